// glTF 2.0: container -> JSON -> checks -> tinygltf's model -> meshes, parts, materials and images.

#include <algorithm>

#include "importers/gltf_check.h"
#include "importers/gltf_container.h"
#include "importers/gltf_geometry.h"
#include "importers/gltf_images.h"
#include "importers/gltf_material.h"
#include "importers/gltf_mesh.h"
#include "importers/gltf_model.h"
#include "importers/gltf_nodes.h"
#include "importers/gltf_variants.h"

namespace restframe {
namespace {

void fit_to_length(const GltfContext& context, const std::string& pointer, Bytes& bytes,
                   std::size_t length, std::size_t tolerated) {
  if (bytes.size() < length || bytes.size() > length + tolerated) {
    context.fault(pointer, "byteLength is " + std::to_string(length) + ", but there are " +
                               std::to_string(bytes.size()) + " bytes");
  }
  bytes.resize(length);
}

// The bytes of every buffer of the document, exactly as many as it says.
std::vector<Bytes> read_buffers(const GltfContext& context, Json& document,
                                std::optional<Bytes> bin) {
  std::vector<Bytes> buffers;
  if (!document.contains("buffers")) return buffers;
  for (Json& buffer : document["buffers"]) {
    const std::string pointer = "/buffers/" + std::to_string(buffers.size());
    const auto length = buffer["byteLength"].get<std::size_t>();
    if (buffer.contains("uri")) {
      const std::string uri = std::move(buffer["uri"].get_ref<std::string&>());
      buffers.push_back(read_uri(context, pointer + "/uri", uri, context.limits.total_bytes));
      fit_to_length(context, pointer, buffers.back(), length, 0);
    } else {
      if (!buffers.empty() || !bin) context.fault(pointer, "has neither a uri nor a BIN chunk");
      buffers.push_back(std::move(*bin));
      fit_to_length(context, pointer, buffers.back(), length, 3);  // chunks are padded
    }
  }
  return buffers;
}

void warn_of_degenerate(const GltfContext& context, const std::vector<Mesh>& meshes) {
  std::size_t count = 0;
  for (const Mesh& mesh : meshes) count += count_degenerate(mesh);
  if (count > 0) {
    context.warn("/meshes", std::to_string(count) + " triangles are degenerate (without area)");
  }
}

// Reads every mesh, so that no fault hides, and keeps those that parts use.
void read_meshes(const GltfContext& context, const tinygltf::Model& model, SlotTable& slots,
                 Asset& asset) {
  std::vector<int> kept(model.meshes.size(), -1);
  for (const Part& part : asset.parts) kept[static_cast<std::size_t>(part.mesh)] = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    Mesh mesh = read_mesh(context, model, i, slots.slots_of(model.meshes[i]));
    if (kept[i] < 0) {
      context.warn("/meshes/" + std::to_string(i), "no node of the scene places this mesh");
      continue;
    }
    kept[i] = mesh.triangles.empty() ? -1 : static_cast<int>(asset.meshes.size());
    if (kept[i] >= 0) asset.meshes.push_back(std::move(mesh));
  }
  warn_of_degenerate(context, asset.meshes);
  for (Part& part : asset.parts) part.mesh = kept[static_cast<std::size_t>(part.mesh)];
  const auto is_empty = [](const Part& part) { return part.mesh < 0; };
  asset.parts.erase(std::remove_if(asset.parts.begin(), asset.parts.end(), is_empty),
                    asset.parts.end());
  if (asset.parts.empty()) context.warn("", "has no triangles to render");
}

// The slot after the model's materials is that of primitives without one. Where there are none, the
// slots beyond move up.
void add_default_material(const tinygltf::Model& model, Asset& asset) {
  const auto slot = static_cast<int>(model.materials.size());
  bool needed = asset.materials.empty();
  for (const VariantSlot& by_variant : asset.variant_slots) needed |= by_variant.material == slot;
  for (const Mesh& mesh : asset.meshes) {
    for (const MaterialRange& range : mesh.materials) needed |= range.slot == slot;
  }
  if (needed) {
    asset.materials.emplace_back().name = "default";
    return;
  }
  for (Mesh& mesh : asset.meshes) {
    for (MaterialRange& range : mesh.materials) range.slot -= range.slot > slot ? 1 : 0;
  }
}

void read_surfaces(const GltfContext& context, const tinygltf::Model& model,
                   const std::vector<ImageSource>& images, Asset& asset) {
  std::vector<UsedImage> used_images;
  read_materials(context, model, asset, used_images);
  check_uv_sets(context, model, asset);
  add_default_material(model, asset);
  read_images(context, model, images, used_images, asset);
}

Asset assemble(const GltfContext& context, const tinygltf::Model& model,
               const std::vector<ImageSource>& images) {
  Asset asset;
  asset.name = context.path.filename().string();
  asset.parts = place_meshes(context, model);
  SlotTable slots(static_cast<int>(model.materials.size()));
  read_meshes(context, model, slots, asset);
  asset.variant_slots = slots.take();
  read_surfaces(context, model, images, asset);
  return asset;
}

}  // namespace

Asset load_gltf(const Path& path, const ImportLimits& limits, Warnings& warnings) {
  std::set<Path> files;
  const GltfContext context{path, path.string(), limits, warnings, files};
  GltfContainer container = read_container(context);
  Json document = parse_gltf_json(context, container.json);
  container.json = {};
  check_gltf(context, document);
  const std::vector<ImageSource> images = take_image_sources(document);
  std::vector<std::string> variants = variant_names(document);
  std::vector<Bytes> buffers = read_buffers(context, document, std::move(container.bin));
  const tinygltf::Model model = parse_model(context, std::move(document), std::move(buffers));
  Asset asset = assemble(context, model, images);
  asset.variants = std::move(variants);
  asset.files = std::move(files);
  return asset;
}

}  // namespace restframe
