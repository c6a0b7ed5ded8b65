#pragma once

// What reads files into scenes and assets, and writes authored assets. Every function throws
// InputError (one line: FILE:LINE:COLUMN or FILE:/json/pointer, what, the value, the limit) on
// whatever it can not use, and appends to `warnings` what it leaves out.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "importers/warnings.h"
#include "scene/asset.h"
#include "scene/generators.h"
#include "scene/scene.h"

namespace restframe {

// Bounds on what a file may ask for, checked before work starts.
struct ImportLimits {
  std::size_t json_bytes = 64'000'000;
  int json_depth = 64;
  std::size_t nodes = 1'000'000;
  std::size_t triangles = 50'000'000;  // stored ones; instances are not counted again
  std::size_t image_pixels = 64'000'000;
  std::size_t total_bytes = 4'000'000'000;
};

using Path = std::filesystem::path;

// A scene file (.toml), or an asset in its place: one object at rest at the world's origin, in the
// asset's variant of that name.
Scene load_scene(const Path& path, const ImportLimits& limits, Warnings& warnings,
                 const std::optional<std::string>& variant = {});

// By extension: .gltf .glb .obj .ply .stl .off
Asset load_asset(const Path& path, const ImportLimits& limits, Warnings& warnings);

Asset load_gltf(const Path& path, const ImportLimits& limits, Warnings& warnings);
Asset load_obj(const Path& path, const ImportLimits& limits, Warnings& warnings);

// Meshes without materials: one material, "default". Text or binary, as the file says; OFF text only.
Asset load_ply(const Path& path, const ImportLimits& limits, Warnings& warnings);
Asset load_stl(const Path& path, const ImportLimits& limits, Warnings& warnings);
Asset load_off(const Path& path, const ImportLimits& limits, Warnings& warnings);

// PNG or JPEG bytes, of 8 or 16 bits a channel, of any number of channels; `what` names the image in
// errors.
Image decode_image(std::span<const std::uint8_t> bytes, const std::string& what,
                   const ImportLimits& limits);

// The pixels that decode_image() would make, as the bytes say at their beginning. Throws what it
// would throw for the kind and the size of the image.
std::size_t count_image_pixels(std::span<const std::uint8_t> bytes, const std::string& what,
                               const ImportLimits& limits);

// A latitude-longitude environment from the bytes of an OpenEXR file: scan lines of R, G and B, or of
// Y. `what` names it in errors.
SkyMap decode_sky_map(std::span<const std::uint8_t> bytes, const std::string& what,
                      const ImportLimits& limits, Warnings& warnings);

// Normals by crease angle where a mesh has none: smooth across edges that fold by less than
// `crease_degrees`. Vertices are split where their corners' normals differ.
void add_normals(Mesh& mesh, double crease_degrees = 40);

// Authored lattices. The extension of `path` chooses the format: .glb or .obj (obj: always flat).
// Throws OutputError if the file can not be written; nothing partial stays under the final name.
void write_lattice(const LatticeSettings& settings, InstanceMode mode, const Path& path);

}  // namespace restframe
