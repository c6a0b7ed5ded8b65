#include "importers/gltf_check_compressed.h"

#include "importers/gltf_check.h"
#include "scene/message.h"

namespace restframe {
namespace {

constexpr std::uint64_t most_count = 0xFFFFFFFF;

// How meshoptimizer is to read a view: what is in it, and how it was made smaller before.
struct MeshoptKind {
  std::string mode, filter;
};

MeshoptKind check_kind(const Place& extension) {
  extension.require_member("mode");
  const Place mode = extension.member("mode");
  MeshoptKind kind{mode.as_string(), "NONE"};
  if (kind.mode != "ATTRIBUTES" && kind.mode != "TRIANGLES" && kind.mode != "INDICES") {
    mode.fault("is " + quote(kind.mode) + ", must be ATTRIBUTES, TRIANGLES or INDICES");
  }
  if (!extension.has("filter")) return kind;
  const Place filter = extension.member("filter");
  kind.filter = filter.as_string();
  if (kind.filter != "NONE" && kind.filter != "OCTAHEDRAL" && kind.filter != "QUATERNION" &&
      kind.filter != "EXPONENTIAL") {
    filter.fault("is " + quote(kind.filter) +
                 ", must be NONE, OCTAHEDRAL, QUATERNION or EXPONENTIAL");
  }
  if (kind.filter != "NONE" && kind.mode != "ATTRIBUTES") {
    filter.fault("is " + kind.filter + ", but only ATTRIBUTES have filters");
  }
  return kind;
}

std::uint64_t check_stride(const Place& extension, const MeshoptKind& kind) {
  extension.require_member("byteStride");
  const std::uint64_t stride = extension.integer("byteStride", 1, 256, 0);
  const bool fits = kind.mode != "ATTRIBUTES"     ? stride == 2 || stride == 4
                    : kind.filter == "OCTAHEDRAL" ? stride == 4 || stride == 8
                    : kind.filter == "QUATERNION" ? stride == 8
                                                  : stride % 4 == 0;
  if (!fits) {
    extension.member("byteStride")
        .fault("is " + std::to_string(stride) + ", which " + kind.mode + " with filter " +
               kind.filter + " can not have");
  }
  return stride;
}

// The least number of bytes that so many elements are compressed to: fewer are not worth memory.
std::uint64_t least_compressed(const std::string& mode, std::uint64_t count, std::uint64_t stride) {
  if (mode == "ATTRIBUTES") return 1 + count * stride / 64;
  return 1 + (mode == "TRIANGLES" ? count / 3 : count);
}

void check_source(const Place& extension, const Place& document, std::uint64_t least) {
  const std::uint64_t most = document.context().limits.total_bytes;
  extension.require_member("buffer");
  extension.require_member("byteLength");
  const std::int64_t index = extension.index("buffer", count_of(document, "buffers"));
  const Json& buffer = document.value()["buffers"][static_cast<std::size_t>(index)];
  const std::uint64_t offset = extension.integer("byteOffset", 0, most, 0);
  const std::uint64_t length = extension.integer("byteLength", 1, most, 0);
  if (offset + length > buffer["byteLength"].get<std::uint64_t>()) {
    extension.fault("ends at byte " + std::to_string(offset + length) + " of a buffer of " +
                    buffer["byteLength"].dump());
  }
  if (is_fallback(buffer)) extension.member("buffer").fault("is a fallback, which has no data");
  if (length < least) {
    extension.fault("has " + std::to_string(length) + " bytes, too few for its count");
  }
}

// The bytes that come out.
std::uint64_t check_meshopt(const Place& view, const Place& extension, const Place& document) {
  extension.require_object();
  const MeshoptKind kind = check_kind(extension);
  const std::uint64_t stride = check_stride(extension, kind);
  extension.require_member("count");
  const std::uint64_t count = extension.integer("count", 1, most_count, 0);
  if (kind.mode == "TRIANGLES" && count % 3 != 0) {
    extension.member("count").fault("is " + std::to_string(count) + ", must be a multiple of 3");
  }
  if (view.integer("byteStride", 4, 252, stride) != stride) {
    extension.member("byteStride")
        .fault("is " + std::to_string(stride) + ", the view's is " +
               view.value()["byteStride"].dump());
  }
  const auto length = view.value()["byteLength"].get<std::uint64_t>();
  if (count * stride != length) {
    extension.fault("gives " + std::to_string(count) + " elements of " + std::to_string(stride) +
                    " bytes, the view has " + std::to_string(length) + " bytes");
  }
  check_source(extension, document, least_compressed(kind.mode, count, stride));
  return length;
}

void check_draco_attributes(const Place& extension, const Place& primitive) {
  extension.require_member("attributes");
  const Place attributes = extension.member("attributes");
  attributes.require_object();
  for (const auto& [name, value] : attributes.value().items()) {
    const Place attribute = attributes.member(name.c_str());
    attribute.as_integer(0, most_count);
    if (!primitive.value()["attributes"].contains(name)) {
      attribute.fault("the primitive has no attribute of this name");
    }
  }
  attributes.require_member("POSITION");
}

}  // namespace

const Json* extension_of(const Json& element, const char* name) {
  const auto extensions = element.find("extensions");
  if (extensions == element.end()) return nullptr;
  const auto found = extensions->find(name);
  return found == extensions->end() ? nullptr : &*found;
}

bool is_fallback(const Json& buffer) {
  const Json* extension = extension_of(buffer, meshopt_name);
  return extension != nullptr && extension->is_object() && extension->value("fallback", false);
}

void check_draco(const Place& primitive, const Place& document) {
  if (extension_of(primitive.value(), draco_name) == nullptr) return;
  const Place extensions = primitive.member("extensions");
  const Place extension = extensions.member(draco_name);
  extension.require_object();
  extension.require_member("bufferView");
  extension.index("bufferView", count_of(document, "bufferViews"));
  check_draco_attributes(extension, primitive);
  const std::uint64_t mode = primitive.integer("mode", 0, 6, 4);
  if (mode != 4 && mode != 5) {
    primitive.member("mode").fault("is " + std::to_string(mode) +
                                   ", but Draco has triangles only (4 or 5)");
  }
  primitive.require_member("indices");
}

void check_meshopt_views(const Place& document) {
  std::uint64_t total = 0;
  for_each_object(document, "bufferViews", [&](const Place& view) {
    if (extension_of(view.value(), meshopt_name) != nullptr) {
      const Place extensions = view.member("extensions");
      const Place extension = extensions.member(meshopt_name);
      total += check_meshopt(view, extension, document);
      const std::size_t limit = document.context().limits.total_bytes;
      if (total > limit) {
        extension.fault("more than " + std::to_string(limit) +
                        " bytes decompressed in all; --max-bytes raises the limit");
      }
      return;
    }
    const Json& buffer = document.value()["buffers"][view.value()["buffer"].get<std::size_t>()];
    if (is_fallback(buffer) && !buffer.contains("uri")) {
      view.member("buffer").fault("is a fallback without data, and the view is not compressed");
    }
  });
}

}  // namespace restframe
