#pragma once

// Everything in the JSON is checked before tinygltf sees it, because tinygltf checks next to
// nothing: types, ranges, every index, every range of bytes, the graph. What passes can be read
// without a further thought, except for what is in the buffers themselves.

#include <vector>

#include "importers/gltf_place.h"

namespace restframe {

// Throws InputError at the first fault; warns of what is left out.
void check_gltf(const GltfContext& context, const Json& document);

// Its steps.
void check_buffers(const Place& document);
void check_accessors(const Place& document);
void check_materials(const Place& document);
void check_material_extensions(const Place& material, const Place& document);
void check_textures(const Place& document);  // with their images and samplers
void check_variants(const Place& document);
void check_meshes(const Place& document);
void check_nodes(const Place& document);
void check_lights(const Place& document);
void check_cameras(const Place& document);
void check_skins(const Place& document);
void check_unread(const Place& document);  // animations: their references

// The use of a texture under `key`, if there is one.
void check_texture_use(const Place& place, const char* key, const Place& document);

// The number of elements of a top-level array.
std::size_t count_of(const Place& document, const char* key);

// The accessor with this index of a checked document.
inline const Json& accessor_at(const Place& document, std::int64_t index) {
  return document.value()["accessors"][static_cast<std::size_t>(index)];
}

}  // namespace restframe
