#pragma once

// 16 paths, walked together surface by surface. A round: find what each path meets next and what
// stops there, make a vertex of it (path_vertex.cpp), light the vertices (path_lights.cpp), and go on
// from them (path_scatter.cpp).

#include "tracer/bsdf.h"
#include "tracer/emitter_points.h"
#include "tracer/emitter_spectrum.h"
#include "tracer/environment.h"
#include "tracer/footprint.h"
#include "tracer/light_sampling.h"
#include "tracer/line_history.h"
#include "tracer/medium_stack.h"
#include "tracer/path_parts.h"
#include "tracer/plain_material.h"
#include "tracer/random.h"
#include "tracer/sample.h"
#include "tracer/surface_material.h"

namespace restframe {

// How paths find the light of what they can also meet: by looking for it at every vertex, by chance, or
// by both, each weighed by how likely it is to. All have the same mean; two are for comparison.
enum class LightSearch : std::uint8_t { both, by_choice, by_chance };

// What all paths share.
struct PathStage {
  const Scene& scene;
  const FrameSet& frames;
  SurfaceTables tables;
  std::vector<ObjectPlace> places;
  std::vector<PlainMaterial> plain;  // a material each
  std::vector<LightPlace> lights;    // without size: paths never meet them by chance
  std::vector<Environment> environments;
  Emitters emitters;
  LightSearch search = LightSearch::both;
  bool has_lights = false;       // something to look for light of at every vertex
  bool has_emitters = false;     // surfaces or environments that paths may meet
  bool has_see_through = false;  // materials that let light pass straight on
  bool has_clocks = false;       // something that changes over time
  bool has_media = false;        // materials that light can be inside of
  SceneSpectra spectra;
  LightGroups groups;

  std::int32_t group_of(const LightPlace& place) const {
    return groups.of_light[static_cast<std::size_t>(place.light - scene.lights.data())];
  }
  std::int32_t group_of_material(std::int32_t material) const {
    return groups.of_material[static_cast<std::size_t>(material)];
  }
  std::int32_t spectrum_of(const LightPlace& place) const {
    return spectra.of_light(place.light - scene.lights.data());
  }
};

// What light meets on its way to a surface: lamps without size are hidden by back faces, too; what
// paths could also meet is seen as paths see it.
enum class ShadowKind : std::uint8_t { of_lamps, as_paths_see };

// Objects of two velocities, of which light found one inside the other; -1: none.
struct MediumCrossing {
  std::int32_t medium = -1, inside = -1;
};

class PathWalk {
 public:
  // All arguments must outlive the walk. `rays` are the camera's, and change.
  PathWalk(const PathStage& stage, const PacketId& id, TemporalEvaluator& evaluator,
           RayPacket& rays, const SampleLayers& layers);

  void run();
  void take_radiance(RadianceLanes& radiance) const;
  const MediumCrossing& crossing() const { return crossing_; }

 private:
  struct PathLanes {
    Vec3fLanes throughput, radiance;
    Lanes<float> coverage;  // 1: something was met that is no background
    Lanes<std::int32_t> scatterings;
    Lanes<double> omega;  // the light's frequency in the rest frame of the surface or medium
    Lanes<RayCone> cone;  // around the path on its way; only where there are textures
  };
  // Surface events that scatter, each in its rest frame.
  struct VertexLanes {
    Lanes<std::int32_t> active;
    HitEvents at;
    BsdfLanes bsdf;
    ViewLobeLanes lobes;
  };
  // Of paths that are followed by wavelength: three lanes are three wavelengths. Without initial
  // values.
  struct WavelengthLanes {
    Lanes<float> hero;      // what chose them, in [0, 1)
    Vec3fLanes wavelength;  // the camera's, nm
    // What surfaces reflect of them, and daylight, where light has `omega` times its frequency.
    Lanes<double> omega;
    Lanes<std::array<Vec4f, 3>> local;
    Vec3fLanes color;  // light that is not told by wavelength, linear Rec. 709: of lines, ...
    Lanes<std::int32_t> direct;  // ... and of daylight that nothing has weighed on its way: -1
  };
  // How the paths' last scatterings chose their directions.
  struct ChosenLanes {
    // Per steradian in the rest frame there; 0 where lights were not looked for in that direction: after
    // mirrors, into and out of media, and before the first.
    Lanes<float> density;
    Lanes<double> omega;        // the light's frequency there
    Lanes<std::int32_t> frame;  // the rest frame there ...
    Vec3fLanes facing;          // ... and where light was looked for, as Receiver has it
  };
  // What shines towards the paths from what they have met, before the emitter's factor: D65 light of
  // a colour, and colours of light of the materials' own spectra.
  struct ShineLanes {
    bool any = false, any_own = false;
    Vec3fLanes radiance, own;
    Lanes<float> kelvin;

    void set(int lane, const Vec3f& shines) {
      radiance.set(lane, shines);
      any = any || shines != Vec3f(0);
    }
    void set_own(int lane, const Vec3f& color, float temperature) {
      if (!any_own) own = {};
      own.set(lane, color);
      kelvin[lane] = temperature;
      any_own = true;
    }
  };

  bool find_surfaces();
  bool in_medium(int lane) const { return stage_.has_media && !media_[lane].empty(); }
  bool rests_together(int frame, int other) const;
  bool enters_other_frame(int lane);
  void miss();
  void add_uniform(const Environment& sky, const Lanes<std::int32_t>& leaving);
  void add_environment(const Environment& sky, int lane);
  void receive_from_sky(const Environment& sky, int lane, const Vec3f& color);
  void stop_or_pass();
  void stop_or_pass(int lane);
  void count_covers() const;
  void stop_at_plain(const PlainMaterial& plain, const Lanes<std::int32_t>& group);
  void pass(int lane);
  float cone_width(int lane) const {
    return stage_.tables.has_textures() ? paths_.cone[lane].at(hits_.s[lane]) : 0.0F;
  }
  MetSurface met_surface(int lane) const {
    return {stage_.scene, stage_.frames, surfaces_, hits_, lane, &stage_.tables, cone_width(lane)};
  }
  const PlainMaterial& plain(int lane) const {
    return stage_.plain[static_cast<std::size_t>(surfaces_.material[lane])];
  }

  void meet();
  void arrive();
  void absorb(int lane);
  void set_plain_material(const PlainMaterial& plain, const Lanes<std::int32_t>& group,
                          ShineLanes& shines);
  void set_changing_material(int lane, ShineLanes& shines);
  void add_emission(const ShineLanes& shines);
  void add_own_spectrum(int lane, const ShineLanes& shines);
  void set_geometry();

  void add_lights();
  void find_rest_frames(LitLanes& lit) const;
  void add_light(const LightPlace& light, const LitLanes& lit, const ViewLobeLanes& lobes);
  void add_arriving(const IncidentLanes& from_light, const LitLanes& lit,
                    const Vec3fLanes& fraction, ShadowKind kind);
  void let_through(RayPacket& shadows, const Lanes<double>& s_max, ShadowKind kind,
                   Lanes<float>& left);
  void dim(RayPacket& shadows, const Lanes<double>& s_max, ShadowKind kind, Lanes<float>& left);
  bool stops_all(const SurfaceLanes& surfaces, int lane) const;
  float stopped(const MetSurface& met, ShadowKind kind);

  void add_emitters(const LitLanes& lit, const ViewLobeLanes& lobes);
  void set_radiance(const EmitterPoints& points, const PointsSeen& seen, IncidentLanes& from);
  void set_spectrum(const MetSurface& met, const PointsSeen& seen, IncidentLanes& from);
  Vec3f shine(const MetSurface& met, double rest_t);
  void add_sky(const Environment& sky, const LitLanes& lit, const ViewLobeLanes& lobes);
  void add_sampled(IncidentLanes& from, const Lanes<double>& density, const LitLanes& lit,
                   const ViewLobeLanes& lobes);
  void darken_insides(IncidentLanes& from) const;
  Vec3f facing(int lane) const;
  void set_chosen(const ScatteredLanes& scattered);
  float share_of_chance(int lane, double light_density) const;
  float share_of_sky(const Environment& sky, int lane) const;
  float share_of_emitter(int lane) const;
  void weigh_emission(ShineLanes& shines) const;

  Medium medium_of(int lane, const MetSurface& met, double clock);
  float index_ratio(int lane, const MetSurface& met, double clock);
  void scatter_on();
  Vec3fLanes scattering_numbers();
  void weigh(const ScatteredLanes& scattered);
  void end_by_chance(Lanes<std::int32_t>& going);
  bool change_sides(int lane);
  // The path goes on with this fraction of its light, a colour at the surface or in the medium that
  // it is at.
  void weigh(int lane, const Vec3f& weight) {
    paths_.throughput.set(lane, paths_.throughput.at(lane) * by_wavelength(lane, weight));
    by_wavelength_.direct[lane] = 0;
    if (follows_lines()) history_.weigh(lane, weight, paths_.omega[lane]);
  }
  // Light that arrives at the end of the path from an emitter of this group, its emitter's factor
  // included.
  void receive(int lane, const Vec3f& light, std::int32_t group) {
    const Vec3f left = paths_.throughput.at(lane) * light;
    paths_.radiance.set(lane, paths_.radiance.at(lane) + left);
    if (parts_.are_wanted()) parts_.receive(lane, group, left);
  }
  void widen_cone(int lane, float density);
  void depart(const ScatteredLanes& scattered);
  void depart_within(int lane, const Vec3& x, double s_min);
  Boost<in::World, in::Rest> world_from_rest(int lane) const {
    return stage_.frames.frame(hits_.frame[lane]).coordinates().from_world.inverse();
  }

  void choose_wavelengths(const PacketId& id);
  glm::mat3 color_from_lanes(float hero) const;
  void find_local_spectra();
  // A fraction by colour, where the path is, as one by the path's lanes.
  Vec3f by_wavelength(int lane, const Vec3f& color) const {
    if (!stage_.spectra.shifts) return color;
    const std::array<Vec4f, 3>& local = by_wavelength_.local[lane];
    return {glm::dot(Vec3f(local[0]), color), glm::dot(Vec3f(local[1]), color),
            glm::dot(Vec3f(local[2]), color)};
  }
  // What arrives, and which part of it is scattered, as the paths' lanes have it.
  struct ArrivingLanes {
    Vec3fLanes irradiance, fraction;
  };
  void by_wavelength(const IncidentLanes& from_light, const Vec3fLanes& fraction,
                     ArrivingLanes& arriving) const;
  void receive_lines(const IncidentLanes& from_light, const Vec3fLanes& fraction,
                     const Lanes<std::int32_t>& reached, const Lanes<float>& left);
  // An emitter's light of a colour, which is any factors times the colour, as the path's lanes have
  // it. omega: its frequency in the emitter's rest frame over that in the camera.
  Vec3f light_by_wavelength(int lane, const EmitterSpectrum& spectrum, const Vec3f& color,
                            float kelvin, double omega) const;
  // D65 light of a colour that the camera sees as it is needs no wavelengths: true if it was received.
  bool receive_direct(int lane, const Vec3f& color, double omega, std::int32_t group);
  bool follows_lines() const { return stage_.spectra.shifts && stage_.spectra.has_lines; }
  // The lines of an emitter's light of a colour: they are not among the path's wavelengths. What the
  // surface where the path is scatters of it is `scattered`, if light comes by way of it.
  void receive_lines(int lane, const EmitterSpectrum& spectrum, const Vec3f& color, double omega,
                     std::int32_t group, const LobeSplit* scattered = nullptr);

  LobeSplit lobe_split(int lane, const Vec3f& direction, const Vec3f& all, bool exact) const;
  void note_scattering(int lane, const ScatteredLanes& scattered);
  void note_arriving(const IncidentLanes& from_light, const Vec3fLanes& fraction,
                     const Vec3fLanes& arriving, const Lanes<std::int32_t>& reached,
                     const Lanes<float>& left);
  void note_albedos();

  float random(int lane, Dimension dimension) { return random_(lane, dimension, round_); }

  const PathStage& stage_;
  PacketRandom random_;
  TemporalEvaluator& evaluator_;
  RayPacket& rays_;            // of the lanes outside of media
  MediumRayPacket in_medium_;  // of the others
  SampleLayers layers_;
  std::uint32_t round_ = 0;  // surfaces met so far
  PathLanes paths_;
  ChosenLanes chosen_;
  WavelengthLanes by_wavelength_;
  LineHistory history_;
  PathParts parts_;
  Lanes<MediumStack> media_;
  HitPacket hits_;
  SurfaceLanes surfaces_;
  bool inside_ = false;               // some path goes on within a medium
  Lanes<std::int32_t> hit_, missed_;  // -1: the path meets a surface, or nothing, in this round
  Lanes<double> clock_;               // of what was met, unless it is plain
  Lanes<Vec4f> texture_;              // likewise: the base colour's
  Lanes<std::int32_t> met_;           // -1: the path is stopped by a surface in this round
  bool tilts_ = false;                // some surface met has a normal map
  VertexLanes vertices_;
  MediumCrossing crossing_;
};

}  // namespace restframe
