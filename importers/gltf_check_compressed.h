#pragma once

// What KHR_draco_mesh_compression and EXT_meshopt_compression say of what they hold.

#include "importers/gltf_place.h"

namespace restframe {

inline constexpr const char* draco_name = "KHR_draco_mesh_compression";
inline constexpr const char* meshopt_name = "EXT_meshopt_compression";

// The extension of an element of the document, or null.
const Json* extension_of(const Json& element, const char* name);

// A primitive whose attributes and indices are checked; nothing where it is not compressed.
void check_draco(const Place& primitive, const Place& document);

// All views, which are checked themselves: ranges, and how much comes out of them in all.
void check_meshopt_views(const Place& document);

// Whether the buffer is there for readers without meshoptimizer alone: it may lack its bytes.
bool is_fallback(const Json& buffer);

}  // namespace restframe
