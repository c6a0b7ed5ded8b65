#include "importers/gltf_model.h"

#include <fstream>  // which tinygltf needs but forgets where it is to use no files

// tinygltf is compiled in here, and only here. It gets to see neither files nor images.
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_FS
#include <tiny_gltf.h>

#include <algorithm>

#include "scene/message.h"

namespace restframe {
namespace {

// tinygltf asks for buffer number i as the file "i".
bool buffer_exists(const std::string&, void*) {
  return true;
}

std::string same_name(const std::string& name, void*) {
  return name;
}

bool hand_over_buffer(Bytes* bytes, std::string*, const std::string& name, void* user_data) {
  auto& buffers = *static_cast<std::vector<Bytes>*>(user_data);
  bytes->swap(buffers.at(std::stoul(name)));
  return true;
}

// The members that the importer reads from the model; everything else stays out of tinygltf's
// reach.
Json reduced(Json&& document, const std::vector<Bytes>& buffers) {
  Json kept;
  for (const char* key : {"asset", "accessors", "bufferViews", "materials", "meshes", "nodes",
                          "samplers", "scene", "scenes", "skins", "textures"}) {
    if (document.contains(key)) kept[key] = std::move(document[key]);
  }
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    kept["buffers"].push_back({{"uri", std::to_string(i)}, {"byteLength", buffers[i].size()}});
  }
  return kept;
}

// Accessors without a bufferView are zeros, but tinygltf refuses them as indices. So they get some
// view, and lose it again in the model. Returns their indices.
std::vector<std::size_t> lend_views(Json& document) {
  std::vector<std::size_t> borrowers;
  if (!document.contains("accessors")) return borrowers;
  Json& accessors = document["accessors"];
  for (std::size_t i = 0; i < accessors.size(); ++i) {
    if (accessors[i].contains("bufferView")) continue;
    accessors[i]["bufferView"] = 0;
    borrowers.push_back(i);
  }
  Json& views = document["bufferViews"];
  if (!borrowers.empty() && views.empty()) views.push_back({{"buffer", 0}, {"byteLength", 1}});
  return borrowers;
}

// The same with skins without inverse bind matrices.
std::vector<std::size_t> lend_matrices(Json& document) {
  std::vector<std::size_t> borrowers;
  if (!document.contains("skins")) return borrowers;
  Json& skins = document["skins"];
  for (std::size_t i = 0; i < skins.size(); ++i) {
    if (skins[i].contains("inverseBindMatrices")) continue;
    skins[i]["inverseBindMatrices"] = 0;
    borrowers.push_back(i);
  }
  return borrowers;
}

}  // namespace

tinygltf::Model parse_model(const GltfContext& context, Json document, std::vector<Bytes> buffers) {
  const std::vector<std::size_t> without_view = lend_views(document);
  const std::vector<std::size_t> without_matrices = lend_matrices(document);
  const std::string text = reduced(std::move(document), buffers).dump();
  document = nullptr;
  tinygltf::TinyGLTF parser;
  parser.SetFsCallbacks({buffer_exists, same_name, hand_over_buffer, nullptr, &buffers});
  tinygltf::Model model;
  std::string errors, warnings;
  const bool parsed = parser.LoadASCIIFromString(&model, &errors, &warnings, text.data(),
                                                 static_cast<unsigned>(text.size()), "");
  if (!parsed || !errors.empty()) {
    std::replace(errors.begin(), errors.end(), '\n', ' ');
    context.fault("", "tinygltf can not read it: " + quote(errors));
  }
  for (const std::size_t accessor : without_view) model.accessors[accessor].bufferView = -1;
  for (const std::size_t skin : without_matrices) model.skins[skin].inverseBindMatrices = -1;
  return model;
}

}  // namespace restframe
