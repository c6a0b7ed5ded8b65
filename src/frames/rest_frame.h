#pragma once

// One velocity: the objects that stand still together, as one static Embree scene.
//
//   world  --boost, anchor-->  rest frame  --affine-->  traversal coordinates  (what Embree sees,
//   in float)
//
// A frame that holds one placed mesh traverses that mesh's own scene, and its traversal coordinates
// are the mesh's. Else meshes placed once are baked into coordinates centred on the frame's bounds,
// and meshes placed often are instances. The ray parameter s is the same number on all three sides.

#include <array>
#include <span>
#include <vector>

#include "frames/embree_handles.h"
#include "frames/hit_events.h"
#include "frames/packet.h"
#include "frames/traversable_mesh.h"
#include "physics/lorentz.h"
#include "scene/scene.h"

namespace restframe {

// A mesh placed in a rest frame.
struct FramePart {
  int object = 0;
  int name = -1;  // of PlacedMesh
  int mesh = 0;
  Mat4 rest_from_mesh{1};
  glm::mat3 rest_from_mesh_normal{1};  // inverse transpose; any length
  glm::mat3 rest_from_facet_normal{
      1};                            // of HitPacket::facet_normal, to the side that faces the front
  bool instanced = false;            // else `positions` are in traversal coordinates already
  Mat4 traversal_from_local{1};      // of an instance
  std::vector<Vec3f> baked;          // of a mesh placed once, in a frame that holds others too
  std::span<const Vec3f> positions;  // what Embree sees: baked or the mesh's local ones
  std::span<const Triangle> triangles;
  std::span<const MetTriangle> met_triangles;  // mesh coordinates; empty: normals are the facets'

  // Where they are traversed as they are.
  bool has_corners() const { return !met_triangles.empty() && baked.empty(); }
  void prefetch(std::uint32_t triangle) const {
    if (!met_triangles.empty()) __builtin_prefetch(&met_triangles[triangle]);
    if (!has_corners()) __builtin_prefetch(&triangles[triangle]);
  }
};

// A packet in the traversal coordinates of one rest frame.
struct LocalRays;
// The corners of 16 triangles.
struct CornerLanes;

class RestFrame {
 public:
  // objects: indices into scene.objects, all of one velocity. meshes: one a mesh of the scene; the
  // ones that this frame instances or traverses have their scenes. `scene` and `meshes` must
  // outlive the frame.
  RestFrame(const EmbreeDevice& device, const Scene& scene, std::span<const int> objects,
            std::span<const TraversableMesh> meshes, std::span<const int> uses_of_mesh);

  // Replaces the lanes of `hits` that this frame is nearer to. Frames are asked in the order of their
  // indices: before frame 0, `hits` says only that nothing is hit.
  void intersect(const RayPacket& rays, int own_index, HitPacket& hits) const;

  void intersect(const MediumRayPacket& rays, int own_index, HitPacket& hits) const;

  // Sets the lanes of `blocked` (-1) whose ray meets this frame's objects before `s_max`, by more than
  // floats can tell apart here.
  void find_blocked(const RayPacket& rays, const Lanes<double>& s_max,
                    Lanes<std::int32_t>& blocked) const;

  // Where, along the ray of a hit, the next search begins when the surface lets it pass: behind the
  // hit by more than floats can tell apart here.
  double s_behind(const HitPacket& hits, int lane) const;

  // What a surface at a ray's very end may seem nearer by, in light-seconds here: a light that lies on
  // a surface is not behind it.
  double noise_at_end() const { return noise_at_end_; }

  // Gives hits on one part of this frame, those of `group`, their s in double, and tells their events.
  // first: a lane of the group. by_clock: as exactly as clocks and textures ask for; else onto the plane
  // that Embree's floats make of the triangle, which is all that rays that leave it ask for.
  void locate(HitPacket& hits, int first, const Lanes<std::int32_t>& group, bool by_clock,
              HitEvents& events) const;

  // From which s on rays that leave hits of this frame are clear of the surface, for the lanes of
  // `group`. direction: unit, rest-frame axes. omega: the rays' frequency in this frame.
  void find_clear(const HitEvents& from, const Vec3fLanes& direction, const Lanes<double>& omega,
                  const Lanes<std::int32_t>& group, Lanes<double>& s_clear) const;

  // Gives a hit of this frame its s in double, from the triangle's corners.
  void refine(HitPacket& hits, int lane) const;

  // The event of a refined hit.
  Event<in::World> hit_event(const HitPacket& hits, int lane) const;

  const FramePart& part(std::uint32_t index) const { return parts_[index]; }
  std::span<const FramePart> parts() const { return parts_; }
  const AnchoredFrame<in::Rest>& coordinates() const { return coordinates_; }
  const Bounds& traversal_bounds() const { return bounds_; }
  RTCScene traversed() const { return traversed_; }

  // Rest-frame position of a point in traversal coordinates, relative to the anchor.
  Vec3 rest_position(const Vec3& traversal) const {
    return rest_from_traversal_linear_ * traversal + rest_from_traversal_offset_;
  }

  // What the clock of `object` shows at rest-frame time 0, that is, at the anchor.
  double clock_at_anchor(const Object& object) const;
  // Where the object's origin rests.
  Vec3 origin_of(const Object& object) const { return coordinates_(object.worldline.reference).x; }

 private:
  void build_single(std::span<const TraversableMesh> meshes);
  void build_many(const EmbreeDevice& device, std::span<const TraversableMesh> meshes,
                  std::span<const int> uses_of_mesh);
  void set_traversal(const Mat4& rest_from_traversal);
  void set_origins(const EventLanes<in::World>& origin, LocalRays& local) const;
  void set_origin(const Event<in::World>& origin, LocalRays& local) const;
  LocalRays localised(const RayPacket& rays) const;
  LocalRays localised(const MediumRayPacket& rays) const;
  void find_hits(LocalRays& local, const Lanes<double>& s_min, const Lanes<std::int32_t>& active,
                 bool coherent, bool fresh, int own_index, HitPacket& hits) const;
  unsigned context_flags(const LocalRays& local, bool coherent) const;
  unsigned shadow_flags(const LocalRays& local, bool coherent) const;
  // Of a hit's triangle, in traversal coordinates.
  std::array<Vec3, 3> corners(const HitPacket& hits, int lane) const;
  // Lanes outside of the group get the triangle of lane `first`.
  void gather_corners(const HitPacket& hits, int first, const Lanes<std::int32_t>& group,
                      CornerLanes& corners) const;
  void locate_on_plane(HitPacket& hits, int first, const Lanes<std::int32_t>& group,
                       HitEvents& events) const;
  void set_events(const HitPacket& hits, const Lanes<std::int32_t>& group, HitEvents& events) const;
  void set_noise_at_end();
  double clearance(const HitPacket& hits, int lane, const Vec3& traversal_k) const;

  AnchoredFrame<in::Rest> coordinates_;
  std::vector<FramePart> parts_;
  EmbreeScene own_scene_;
  RTCScene traversed_ = nullptr;  // own_scene_'s, or the only mesh's
  Bounds bounds_;                 // traversal coordinates
  Mat3 rest_from_traversal_linear_{1}, traversal_from_rest_linear_{1};
  Vec3 rest_from_traversal_offset_{0};
  double traversal_scale_ = 1;  // the longest that a unit vector of the rest frame gets, about
  double noise_at_end_ = 0;
  bool has_instances_ = false;
  bool octants_hold_ = true;          // rays of one octant stay so inside every instance
  bool traversal_is_turned_ = false;  // or scaled: the linear part is not the identity
};

}  // namespace restframe
