// glTF 2.0: container -> JSON -> checks -> tinygltf's model -> meshes, parts, materials and images.

#include <algorithm>
#include <tuple>

#include "importers/gltf_buffers.h"
#include "importers/gltf_check.h"
#include "importers/gltf_container.h"
#include "importers/gltf_geometry.h"
#include "importers/gltf_images.h"
#include "importers/gltf_lights.h"
#include "importers/gltf_material.h"
#include "importers/gltf_mesh.h"
#include "importers/gltf_model.h"
#include "importers/gltf_nodes.h"
#include "importers/gltf_posed.h"
#include "importers/gltf_take_extras.h"
#include "importers/gltf_variants.h"

namespace restframe {
namespace {

// What the document says of the tree besides its nodes.
struct GltfTreeParts {
  std::vector<std::string> extensions;
  AssetTree tree;  // lights, cameras, and extras with glTF's indices
  std::vector<int> light_indices;
  std::vector<std::string> variants;
};

GltfTreeParts take_tree_parts(const GltfContext& context, Json& document) {
  GltfTreeParts parts;
  parts.tree.lights = read_gltf_lights(document);
  parts.tree.cameras = read_gltf_cameras(document);
  parts.light_indices = read_light_indices(document);
  if (document.contains("extensionsUsed")) {
    parts.extensions = document["extensionsUsed"].get<std::vector<std::string>>();
  }
  parts.variants = variant_names(document);
  parts.tree.extras = take_extras(context, document);
  return parts;
}

void warn_of_degenerate(const GltfContext& context, const std::vector<Mesh>& meshes) {
  std::size_t count = 0;
  for (const Mesh& mesh : meshes) count += count_degenerate(mesh);
  if (count > 0) {
    context.warn("/meshes", std::to_string(count) + " triangles are degenerate (without area)");
  }
}

// Reads every mesh, so that no fault hides, and keeps those that parts use.
void read_meshes(const GltfContext& context, const tinygltf::Model& model,
                 const std::vector<PosedMesh>& poses, SlotTable& slots, Asset& asset) {
  std::vector<int> kept(poses.size(), -1);
  Skins skins(context, model);
  for (const Part& part : asset.parts) kept[static_cast<std::size_t>(part.mesh)] = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const tinygltf::Mesh& source = model.meshes[static_cast<std::size_t>(poses[i].mesh)];
    Mesh mesh = read_mesh(context, model, poses[i], skins, slots.slots_of(source));
    if (kept[i] < 0) {
      context.warn("/meshes/" + std::to_string(poses[i].mesh),
                   "no node of a scene places this mesh");
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

void read_surfaces(const GltfContext& context, tinygltf::Model& model,
                   const std::vector<ImageSource>& images, Asset& asset) {
  std::vector<UsedImage> used_images;
  read_materials(context, model, asset, used_images);
  check_uv_sets(context, model, asset);
  add_default_material(model, asset);
  read_images(context, model, images, used_images, asset);
}

// Gives the extras of nodes the nodes' places in the tree, and drops those that are in no scene.
void connect_extras(const GltfContext& context, const std::vector<int>& new_index,
                    AssetTree& tree) {
  std::vector<AssetExtras> connected;
  for (AssetExtras& extras : tree.extras) {
    if (extras.of == ExtrasOf::node) {
      const int node = new_index[static_cast<std::size_t>(extras.index)];
      if (node < 0) {
        context.warn(extras.place, "is left out: no scene has this node");
        continue;
      }
      require_bounded(context, extras.index,
                      tree.nodes[static_cast<std::size_t>(node)].asset_from_node);
      extras.index = node;
    }
    connected.push_back(std::move(extras));
  }
  tree.extras = std::move(connected);
  std::stable_sort(tree.extras.begin(), tree.extras.end(),
                   [](const AssetExtras& a, const AssetExtras& b) {
                     return std::tie(a.of, a.index) < std::tie(b.of, b.index);
                   });
}

Asset assemble(const GltfContext& context, tinygltf::Model& model,
               const std::vector<ImageSource>& images, GltfTreeParts parts) {
  Asset asset;
  asset.name = context.path.filename().string();
  asset.tree = std::move(parts.tree);
  asset.extensions = std::move(parts.extensions);
  asset.variants = std::move(parts.variants);
  const std::vector<PosedMesh> poses = pose_meshes(context, model);
  connect_extras(context, place_nodes(context, model, parts.light_indices, asset), asset.tree);
  SlotTable slots(static_cast<int>(model.materials.size()));
  read_meshes(context, model, poses, slots, asset);
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
  std::string().swap(container.json);  // an assignment would keep its memory
  check_gltf(context, document);
  const std::vector<ImageSource> images = take_image_sources(document);
  GltfTreeParts tree_parts = take_tree_parts(context, document);
  std::vector<Bytes> buffers = read_buffers(context, document, std::move(container.bin));
  decode_meshopt(context, document, buffers);
  decode_draco(context, document, buffers);
  tinygltf::Model model = parse_model(context, std::move(document), std::move(buffers));
  share_images(images, model);
  Asset asset = assemble(context, model, images, std::move(tree_parts));
  asset.files = std::move(files);
  return asset;
}

}  // namespace restframe
