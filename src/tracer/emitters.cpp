#include "tracer/emitters.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "tracer/emitter_power.h"

namespace restframe {
namespace {

// What a matrix makes of areas, on average over their directions.
double area_scale(const Mat4& matrix) {
  return std::pow(std::abs(glm::determinant(Mat3(matrix))), 2.0 / 3.0);
}

std::uint32_t end_of_range(const Mesh& mesh, std::size_t range) {
  return range + 1 < mesh.materials.size() ? mesh.materials[range + 1].first_triangle
                                           : static_cast<std::uint32_t>(mesh.triangles.size());
}

// Daylight on what is unlit and a spectrum of its own: rare, and found by chance alone.
bool has_two_spectra(const Material& material) {
  return material.unlit &&
         has_own_spectrum(material.emission_temperature, material.emission_spectrum);
}

// Gathers the patches of a scene, and a table for each mesh's range and material.
class Gatherer {
 public:
  Gatherer(const Scene& scene, std::vector<EmittingPatch>& patches, std::vector<AliasTable>& tables)
      : scene_(scene), evaluator_(scene.functions), patches_(patches), tables_(tables) {}

  void add(std::int32_t frame, std::uint32_t index, const FramePart& part) {
    const Mesh& mesh = scene_.meshes[static_cast<std::size_t>(part.mesh)];
    const Object& object = scene_.objects[static_cast<std::size_t>(part.object)];
    for (std::size_t range = 0; range < mesh.materials.size(); ++range) {
      const auto slot = static_cast<std::size_t>(mesh.materials[range].slot);
      const int material = object.materials[slot];
      const Material& shining = scene_.materials[static_cast<std::size_t>(material)];
      if (!emits(shining) || has_two_spectra(shining)) continue;
      const std::uint32_t first = mesh.materials[range].first_triangle;
      const std::uint32_t end = end_of_range(mesh, range);
      if (end <= first) continue;
      const std::uint32_t table = table_of(part.mesh, range, material, first, end - first);
      const double power = tables_[table].total() * area_scale(part.rest_from_mesh);
      if (!(power > 0.0)) continue;
      patches_.push_back({frame, index, first, end - first, part.object, material, table});
      powers.push_back(power);
    }
  }

  std::vector<double> powers;  // a patch each

 private:
  std::uint32_t table_of(int mesh, std::size_t range, int material, std::uint32_t first,
                         std::uint32_t count) {
    const auto [known, is_new] = table_of_.emplace(std::tuple(mesh, range, material),
                                                   static_cast<std::uint32_t>(tables_.size()));
    if (!is_new) return known->second;
    const Material& m = scene_.materials[static_cast<std::size_t>(material)];
    const EmittedPower power = emitted_power(scene_, m, evaluator_);
    tables_.emplace_back(triangle_powers(scene_, scene_.meshes[static_cast<std::size_t>(mesh)],
                                         first, count, m, power));
    return known->second;
  }

  const Scene& scene_;
  TemporalEvaluator evaluator_;
  std::vector<EmittingPatch>& patches_;
  std::vector<AliasTable>& tables_;
  std::map<std::tuple<int, std::size_t, int>, std::uint32_t> table_of_;
};

}  // namespace

Emitters::Emitters(const Scene& scene, const FrameSet& frames) {
  if (std::none_of(scene.materials.begin(), scene.materials.end(), emits)) return;
  Gatherer gatherer(scene, patches_, tables_);
  std::int32_t index = 0;
  for (const RestFrame& frame : frames.frames()) {
    std::vector<std::uint32_t>& firsts = first_patches_.emplace_back();
    std::uint32_t part_index = 0;
    for (const FramePart& part : frame.parts()) {
      firsts.push_back(static_cast<std::uint32_t>(patches_.size()));
      gatherer.add(index, part_index++, part);
    }
    firsts.push_back(static_cast<std::uint32_t>(patches_.size()));
    const AnchoredFrame<in::Rest>& at = frame.coordinates();
    LightPlace place;
    place.frame = {at.anchor, Boost<in::LightRest, in::World>(at.from_world.velocity())};
    place.world_from_light = place.frame.from_world.inverse();
    places_.push_back(place);
    ++index;
  }
  chances_ = AliasTable(gatherer.powers);
}

Emitters::Chosen Emitters::choose(double u, double v) const {
  const std::uint32_t patch = chances_.choose(u);
  const EmittingPatch& chosen = patches_[patch];
  const std::uint32_t triangle = chosen.first + tables_[chosen.table].choose(v);
  return {&chosen, triangle, chance(patch, triangle)};
}

double Emitters::chance(std::int32_t frame, std::uint32_t part, std::uint32_t triangle) const {
  const std::vector<std::uint32_t>& firsts = first_patches_[static_cast<std::size_t>(frame)];
  const auto begin = patches_.begin() + firsts[part], end = patches_.begin() + firsts[part + 1];
  const auto after = std::upper_bound(
      begin, end, triangle,
      [](std::uint32_t wanted, const EmittingPatch& patch) { return wanted < patch.first; });
  if (after == begin) return 0.0;
  const EmittingPatch& patch = *(after - 1);
  if (triangle - patch.first >= patch.count) return 0.0;
  return chance(static_cast<std::size_t>(after - 1 - patches_.begin()), triangle);
}

RestTriangle rest_triangle(const Scene& scene, const FramePart& part, std::uint32_t triangle) {
  const Mesh& mesh = scene.meshes[static_cast<std::size_t>(part.mesh)];
  const Triangle& vertices = mesh.triangles[triangle];
  RestTriangle rest;
  for (std::size_t i = 0; i < 3; ++i) {
    rest.corners[i] =
        Vec3(part.rest_from_mesh * glm::dvec4(Vec3(mesh.positions[vertices[i]]), 1.0));
  }
  const Vec3 across =
      glm::cross(rest.corners[1] - rest.corners[0], rest.corners[2] - rest.corners[0]);
  const double length = glm::length(across);
  const double front = glm::determinant(Mat3(part.rest_from_mesh)) < 0.0 ? -1.0 : 1.0;
  rest.normal = length > 0.0 ? across * (front / length) : Vec3(0);
  rest.area = 0.5 * length;
  return rest;
}

}  // namespace restframe
