#pragma once

#include <vector>

#include "importers/scene_file.h"

namespace restframe {

// Makes Scene::materials and every Object::materials of the assets' materials and the file's
// changes, in the file's order.
//
// Every slot of every object is a material that changes can mean by its asset's name for it. A
// change that means none defines a new one if an object refers to its name. A name that an object
// refers to is looked for in the object's own asset, then among new materials for this object only,
// then among new ones for all, then in the other objects' assets. Slots that are alike after all
// changes share one material.
void assign_materials(const std::vector<MaterialChange>& changes, SceneFile& file);

}  // namespace restframe
