#pragma once

// Moving nodes of an asset are parts of the object that it is placed as: what is said of the object's
// materials holds for them.

#include <set>
#include <string>
#include <vector>

#include "importers/scene_file.h"

namespace restframe {

class ObjectParts {
 public:
  ObjectParts(const std::vector<MaterialChange>& changes, const SceneFile& file);

  // Whether the object is a part that has the whole's materials: no change names it.
  bool shares_materials(std::size_t object) const;

  // Whether what holds on the object holds on the part, be it the same or a part of it.
  bool belongs_to(int part, int object) const;

  // Where the object, or the whole that it is a part of, takes its materials from.
  const ObjectMaterials& wanted_on(std::size_t object) const;

 private:
  const SceneFile& file_;
  std::set<std::string> named_;  // by changes
};

}  // namespace restframe
