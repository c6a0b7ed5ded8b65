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
      patches_.push_back({frame, index, first, end - first, part.object, material, table, leaves});
      powers.push_back(power);
      leaves += end - first;
    }
  }

  // The frame's so far.
  std::vector<double> powers;  // a patch each
  std::uint32_t leaves = 0;    // triangles

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

Emitters::Emitters(const Scene& scene, const FrameSet& frames, std::size_t most_leaves) {
  if (std::none_of(scene.materials.begin(), scene.materials.end(), emits)) return;
  Gatherer gatherer(scene, patches_, tables_);
  std::vector<double> powers;
  for (const RestFrame& frame : frames.frames()) {
    FrameEmitters& emitters = frames_.emplace_back();
    gatherer.powers.clear();
    gatherer.leaves = 0;
    for (std::uint32_t part = 0; part < frame.parts().size(); ++part) {
      emitters.first_patches.push_back(static_cast<std::uint32_t>(patches_.size()));
      gatherer.add(static_cast<std::int32_t>(frames_.size()) - 1, part, frame.part(part));
    }
    emitters.first_patches.push_back(static_cast<std::uint32_t>(patches_.size()));
    emitters.patch_chances = AliasTable(gatherer.powers);
    powers.push_back(emitters.patch_chances.total());
    if (gatherer.leaves <= most_leaves) add_tree(scene, frame, emitters);
    const AnchoredFrame<in::Rest>& at = frame.coordinates();
    emitters.place.frame = {at.anchor, Boost<in::LightRest, in::World>(at.from_world.velocity())};
    emitters.place.world_from_light = emitters.place.frame.from_world.inverse();
  }
  frame_chances_ = AliasTable(powers);
}

void Emitters::add_tree(const Scene& scene, const RestFrame& frame, FrameEmitters& emitters) const {
  std::vector<TreeLeaf> leaves;
  for (std::uint32_t i = emitters.first_patches.front(); i < emitters.first_patches.back(); ++i) {
    const EmittingPatch& patch = patches_[i];
    const Material& material = scene.materials[static_cast<std::size_t>(patch.material)];
    const double power = emitters.patch_chances.chance(i - emitters.first_patches.front());
    for (std::uint32_t t = 0; t < patch.count; ++t) {
      const RestTriangle triangle = rest_triangle(scene, frame.part(patch.part), patch.first + t);
      const auto& [a, b, c] = triangle.corners;
      TreeLeaf leaf;
      leaf.lower = glm::min(glm::min(a, b), c);
      leaf.upper = glm::max(glm::max(a, b), c);
      leaf.normal = triangle.normal;
      leaf.two_sided = material.double_sided || refracts(material);
      leaf.power = power * tables_[patch.table].chance(t);
      leaf.index = patch.first_leaf + t;
      leaves.push_back(leaf);
      emitters.patch_of_leaf.push_back(i);
    }
  }
  emitters.tree = EmitterTree(std::move(leaves));
}

Emitters::Chosen Emitters::choose_by_power(const FrameEmitters& emitters, double u) const {
  const std::uint32_t in_frame = emitters.patch_chances.choose_and_reuse(u);
  const std::uint32_t patch = emitters.first_patches.front() + in_frame;
  const EmittingPatch& chosen = patches_[patch];
  const std::uint32_t triangle = chosen.first + tables_[chosen.table].choose(u);
  return {&chosen, triangle, chance_by_power(emitters, patch, triangle)};
}

double Emitters::chance_by_power(const FrameEmitters& emitters, std::uint32_t patch,
                                 std::uint32_t triangle) const {
  const EmittingPatch& p = patches_[patch];
  return emitters.patch_chances.chance(patch - emitters.first_patches.front()) *
         tables_[p.table].chance(triangle - p.first);
}

Emitters::Chosen Emitters::choose(std::int32_t frame, const Receiver& receiver, double u) const {
  const FrameEmitters& emitters = frames_[static_cast<std::size_t>(frame)];
  Chosen chosen;
  if (emitters.tree.empty()) {
    chosen = choose_by_power(emitters, u);
  } else {
    const EmitterTree::Chosen leaf = emitters.tree.choose(receiver, u);
    const EmittingPatch& patch = patches_[emitters.patch_of_leaf[leaf.leaf]];
    chosen = {&patch, patch.first + (leaf.leaf - patch.first_leaf), leaf.chance};
  }
  chosen.chance *= frame_chances_.chance(static_cast<std::uint32_t>(frame));
  return chosen;
}

double Emitters::chance(std::int32_t frame, std::uint32_t part, std::uint32_t triangle,
                        const Receiver& receiver) const {
  const FrameEmitters& emitters = frames_[static_cast<std::size_t>(frame)];
  const auto begin = patches_.begin() + emitters.first_patches[part];
  const auto end = patches_.begin() + emitters.first_patches[part + 1];
  const auto after = std::upper_bound(
      begin, end, triangle,
      [](std::uint32_t wanted, const EmittingPatch& patch) { return wanted < patch.first; });
  if (after == begin) return 0.0;
  const EmittingPatch& patch = *(after - 1);
  if (triangle - patch.first >= patch.count) return 0.0;
  const auto index = static_cast<std::uint32_t>(after - 1 - patches_.begin());
  const double in_frame =
      emitters.tree.empty()
          ? chance_by_power(emitters, index, triangle)
          : emitters.tree.chance(receiver, patch.first_leaf + (triangle - patch.first));
  return in_frame * frame_chances_.chance(static_cast<std::uint32_t>(frame));
}

Receiver Emitters::receiver(std::int32_t frame, const Event<in::World>& event,
                            const Velocity& velocity, const Vec3f& facing) const {
  const AnchoredFrame<in::LightRest>& own = place(frame).frame;
  return {own(event).x, own.from_world.velocity() == velocity ? facing : Vec3f(0)};
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
