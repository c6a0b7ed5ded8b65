#include "importers/gltf_buffers.h"

#include <algorithm>

#include "importers/gltf_check_compressed.h"

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

// Whether some view needs the buffer's own bytes.
std::vector<bool> read_from_views(const Json& document) {
  std::vector<bool> needed(document["buffers"].size(), false);
  if (!document.contains("bufferViews")) return needed;
  for (const Json& view : document["bufferViews"]) {
    if (extension_of(view, meshopt_name) != nullptr) continue;
    needed[view["buffer"].get<std::size_t>()] = true;
  }
  return needed;
}

}  // namespace

std::vector<Bytes> read_buffers(const GltfContext& context, Json& document,
                                std::optional<Bytes> bin) {
  std::vector<Bytes> buffers;
  if (!document.contains("buffers")) return buffers;
  const std::vector<bool> needed = read_from_views(document);
  for (Json& buffer : document["buffers"]) {
    const std::size_t index = buffers.size();
    const std::string pointer = "/buffers/" + std::to_string(index);
    const auto length = buffer["byteLength"].get<std::size_t>();
    if (is_fallback(buffer) && !needed[index]) {
      buffers.emplace_back(1);
    } else if (buffer.contains("uri")) {
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

}  // namespace restframe
