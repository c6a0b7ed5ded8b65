#include "frames/frame_groups.h"

#include <algorithm>

namespace restframe {
namespace {

// The largest extent over the smallest object's size: floats then place it to a 64th of its size.
constexpr double most_span = 0x1p18;
// More cost too much; the rest shares the last one, as coarse as it may be.
constexpr std::size_t most_frames_of_one_velocity = 1000;

const Object& object_at(const Scene& scene, int index) {
  return scene.objects[static_cast<std::size_t>(index)];
}

std::vector<std::vector<int>> grouped_by_velocity(const Scene& scene) {
  std::vector<std::vector<int>> groups;
  for (int i = 0; i < static_cast<int>(scene.objects.size()); ++i) {
    const Object& object = object_at(scene, i);
    if (object.parts.empty()) continue;
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const std::vector<int>& g) {
      return object_at(scene, g[0]).worldline.velocity == object.worldline.velocity;
    });
    if (same == groups.end()) {
      groups.push_back({i});
    } else {
      same->push_back(i);
    }
  }
  return groups;
}

Bounds united(Bounds a, const Bounds& b) {
  if (b.empty()) return a;
  a.add(b.lower);
  a.add(b.upper);
  return a;
}

double size_of(const Bounds& bounds) {
  return bounds.empty() ? 0.0 : glm::length(bounds.extent());
}

// Of a ball around the mesh.
Bounds placed_bounds(const PlacedMesh& placed, const TraversableMesh& mesh) {
  if (mesh.bounds.empty()) return {};
  const Mat4& m = placed.object_from_mesh;
  const Vec3 center(m * glm::dvec4(mesh.offset + mesh.bounds.center(), 1.0));
  double stretch = 0;
  for (int column = 0; column < 3; ++column) {
    stretch = std::max(stretch, glm::length(Vec3(m[column])));
  }
  const double radius = 0.5 * stretch * size_of(mesh.bounds);
  return {center - Vec3(radius), center + Vec3(radius)};
}

struct PlacedObject {
  int index = 0;
  Bounds bounds;  // where it rests
  double size = 0;
};

std::vector<PlacedObject> placed_objects(const Scene& scene, const std::vector<int>& group,
                                         std::span<const TraversableMesh> meshes) {
  const auto rest = object_at(scene, group[0]).worldline.rest_frame();
  std::vector<PlacedObject> all;
  for (const int index : group) {
    const Object& object = object_at(scene, index);
    PlacedObject placed{index, {}, 0};
    for (const PlacedMesh& part : object.parts) {
      placed.bounds =
          united(placed.bounds, placed_bounds(part, meshes[static_cast<std::size_t>(part.mesh)]));
    }
    placed.size = size_of(placed.bounds);
    const Vec3 origin = rest(object.worldline.reference).x;
    placed.bounds.lower += origin;
    placed.bounds.upper += origin;
    all.push_back(placed);
  }
  return all;
}

// Objects of no size ask for nothing.
bool spans(const Bounds& all, double smallest) {
  return smallest == 0.0 || size_of(all) <= most_span * smallest;
}

bool fits_together(const std::vector<PlacedObject>& objects) {
  Bounds all;
  double smallest = 0;
  for (const PlacedObject& object : objects) {
    all = united(all, object.bounds);
    if (smallest == 0.0 || (object.size > 0.0 && object.size < smallest)) smallest = object.size;
  }
  return spans(all, smallest);
}

struct Part {
  Bounds bounds;
  std::vector<int> objects;
};

// From the largest object down, each to the first part that is not too large for it.
std::vector<std::vector<int>> split_by_size(std::vector<PlacedObject> objects) {
  std::stable_sort(objects.begin(), objects.end(),
                   [](const PlacedObject& a, const PlacedObject& b) { return a.size > b.size; });
  std::vector<Part> parts;
  for (const PlacedObject& object : objects) {
    auto part = std::find_if(parts.begin(), parts.end(), [&](const Part& p) {
      return spans(united(p.bounds, object.bounds), object.size);
    });
    if (part == parts.end()) {
      if (parts.size() < most_frames_of_one_velocity) parts.emplace_back();
      part = std::prev(parts.end());
    }
    part->bounds = united(part->bounds, object.bounds);
    part->objects.push_back(object.index);
  }
  std::vector<std::vector<int>> groups;
  for (Part& part : parts) {
    std::sort(part.objects.begin(), part.objects.end());
    groups.push_back(std::move(part.objects));
  }
  return groups;
}

}  // namespace

std::vector<std::vector<int>> frame_groups(const Scene& scene,
                                           std::span<const TraversableMesh> meshes) {
  std::vector<std::vector<int>> groups;
  for (std::vector<int>& group : grouped_by_velocity(scene)) {
    std::vector<PlacedObject> objects;
    if (group.size() > 1) objects = placed_objects(scene, group, meshes);
    if (fits_together(objects)) {
      groups.push_back(std::move(group));
      continue;
    }
    for (std::vector<int>& part : split_by_size(std::move(objects))) {
      groups.push_back(std::move(part));
    }
  }
  return groups;
}

}  // namespace restframe
