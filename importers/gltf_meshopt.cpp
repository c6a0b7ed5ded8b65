#include <meshoptimizer.h>

#include "importers/gltf_buffers.h"
#include "importers/gltf_check_compressed.h"

namespace restframe {
namespace {

// What a checked extension of a view says.
struct Compressed {
  const std::uint8_t* bytes = nullptr;
  std::size_t length = 0, count = 0, stride = 0;
  std::string mode, filter;
};

Compressed compressed_of(const Json& extension, const std::vector<Bytes>& buffers) {
  Compressed source;
  source.bytes = buffers[extension["buffer"].get<std::size_t>()].data() +
                 extension.value("byteOffset", std::size_t{0});
  source.length = extension["byteLength"].get<std::size_t>();
  source.count = extension["count"].get<std::size_t>();
  source.stride = extension["byteStride"].get<std::size_t>();
  source.mode = extension["mode"].get<std::string>();
  source.filter = extension.value("filter", "NONE");
  return source;
}

// Whether meshoptimizer could read it; it reads nothing beyond what it is given.
bool decode(const Compressed& source, Bytes& bytes) {
  const auto& [from, length, count, stride, mode, filter] = source;
  if (mode == "TRIANGLES") {
    return meshopt_decodeIndexBuffer(bytes.data(), count, stride, from, length) == 0;
  }
  if (mode == "INDICES") {
    return meshopt_decodeIndexSequence(bytes.data(), count, stride, from, length) == 0;
  }
  return meshopt_decodeVertexBuffer(bytes.data(), count, stride, from, length) == 0;
}

void undo_filter(const Compressed& source, Bytes& bytes) {
  if (source.filter == "OCTAHEDRAL") {
    meshopt_decodeFilterOct(bytes.data(), source.count, source.stride);
  } else if (source.filter == "QUATERNION") {
    meshopt_decodeFilterQuat(bytes.data(), source.count, source.stride);
  } else if (source.filter == "EXPONENTIAL") {
    meshopt_decodeFilterExp(bytes.data(), source.count, source.stride);
  }
}

}  // namespace

void decode_meshopt(const GltfContext& context, Json& document, std::vector<Bytes>& buffers) {
  if (!document.contains("bufferViews")) return;
  std::size_t index = 0;
  for (Json& view : document["bufferViews"]) {
    const std::string pointer = "/bufferViews/" + std::to_string(index++);
    const Json* extension = extension_of(view, meshopt_name);
    if (extension == nullptr) continue;
    const Compressed source = compressed_of(*extension, buffers);
    Bytes bytes(source.count * source.stride);
    if (!decode(source, bytes)) {
      context.fault(pointer + "/extensions/" + meshopt_name,
                    "can not be decompressed: it is damaged");
    }
    undo_filter(source, bytes);
    view["buffer"] = buffers.size();
    view["byteOffset"] = 0;
    view.erase("extensions");
    buffers.push_back(std::move(bytes));
  }
}

}  // namespace restframe
