#pragma once

// 16 paths, walked together surface by surface.

#include "tracer/bsdf.h"
#include "tracer/light_sampling.h"
#include "tracer/medium_stack.h"
#include "tracer/random.h"
#include "tracer/sample.h"
#include "tracer/surface_material.h"

namespace restframe {

// What all paths share.
struct PathStage {
  const Scene& scene;
  const FrameSet& frames;
  std::vector<ObjectPlace> places;
  std::vector<LightPlace> lights, environments;
  bool has_emitters = false;     // surfaces or environments: paths meet them by chance only
  bool has_see_through = false;  // materials that let light pass straight on
};

// Objects of two velocities, of which light found one inside the other; -1: none.
struct MediumCrossing {
  std::int32_t medium = -1, inside = -1;
};

class PathWalk {
 public:
  // All arguments must outlive the walk. `rays` are the camera's, and change.
  PathWalk(const PathStage& stage, const PacketId& id, TemporalEvaluator& evaluator,
           RayPacket& rays, SurfaceDataLanes* data);

  void run();
  void take_radiance(RadianceLanes& radiance) const;
  const MediumCrossing& crossing() const { return crossing_; }

 private:
  struct State {
    Vec3f throughput{1};
    Vec3f radiance{0};
    float coverage = 0;  // 1: something was met that is no background
    int scatterings = 0;
    double omega = 1;  // inside media: the light's frequency in their rest frame
    MediumStack media;
  };
  // A surface event that scatters, in its rest frame.
  struct Vertex {
    Bsdf bsdf;
    LitEvent lit;
    Vec3f throughput{1};  // of the path that comes from there
  };

  bool find_surfaces();
  bool rests_together(int frame, int other) const;
  void step(int lane);
  void miss(int lane);
  void pass_straight(int lane);
  void meet(int lane, const MetSurface& met, double clock, const Vec4f& texture);
  void set_vertex(int lane, const MetSurface& met, double clock, const Vec4f& texture);
  Medium medium_of(int lane, const MetSurface& met, double clock);
  float index_ratio(int lane, const MetSurface& met, double clock);
  void scatter_on(int lane, const MetSurface& met, double clock);
  bool survives(int lane);
  void depart(int lane, const Vec3f& direction);
  void add_lights();
  void add_light(const LightPlace& light);
  void let_through(RayPacket& shadows, const Lanes<double>& s_max, Lanes<Vec3f>& arriving);
  float random(int lane, Dimension dimension) const {
    return random_unit(id_, lane, dimension, round_);
  }

  const PathStage& stage_;
  const PacketId& id_;
  TemporalEvaluator& evaluator_;
  RayPacket& rays_;            // of the lanes outside of media
  MediumRayPacket in_medium_;  // of the others
  SurfaceDataLanes* data_;
  std::uint32_t round_ = 0;  // surfaces met so far
  Lanes<State> states_;
  HitPacket hits_;
  SurfaceLanes surfaces_;
  Lanes<Vertex> vertices_;
  Lanes<std::int32_t> lit_;  // -1: lights may reach the lane's vertex
  MediumCrossing crossing_;
};

}  // namespace restframe
