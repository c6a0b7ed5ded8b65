#include "importers/object_parts.h"

namespace restframe {

ObjectParts::ObjectParts(const std::vector<MaterialChange>& changes, const SceneFile& file)
    : file_(file) {
  for (const MaterialChange& change : changes) {
    if (change.object) named_.insert(change.object->name);
  }
}

bool ObjectParts::shares_materials(std::size_t object) const {
  if (file_.object_materials[object].part_of < 0) return false;
  return named_.count(file_.scene.objects[object].name) == 0;
}

bool ObjectParts::belongs_to(int part, int object) const {
  if (part < 0 || part == object) return part == object;
  return file_.object_materials[static_cast<std::size_t>(part)].part_of == object;
}

const ObjectMaterials& ObjectParts::wanted_on(std::size_t object) const {
  const int whole = file_.object_materials[object].part_of;
  return file_.object_materials[whole < 0 ? object : static_cast<std::size_t>(whole)];
}

}  // namespace restframe
