// Buffers, views and accessors: every range of bytes lies within what holds it.

#include "importers/gltf_check.h"
#include "importers/gltf_check_compressed.h"
#include "importers/gltf_layout.h"
#include "scene/message.h"

namespace restframe {
namespace {

constexpr std::uint64_t most_count =
    0xFFFFFFFF;  // so that no product of a count and a stride overflows

void check_buffer(const Place& buffer, const Place& document) {
  buffer.require_member("byteLength");
  buffer.integer("byteLength", 1, document.context().limits.total_bytes, 0);
  buffer.check_string("uri");
  const Json* meshopt = extension_of(buffer.value(), meshopt_name);
  if (meshopt == nullptr) return;
  const Place extensions = buffer.member("extensions");
  const Place extension = extensions.member(meshopt_name);
  extension.require_object();
  extension.check_boolean("fallback");
}

void check_view(const Place& view, const Place& document) {
  const std::uint64_t most = document.context().limits.total_bytes;
  view.require_member("buffer");
  view.require_member("byteLength");
  const std::int64_t buffer = view.index("buffer", count_of(document, "buffers"));
  const std::uint64_t offset = view.integer("byteOffset", 0, most, 0);
  const std::uint64_t length = view.integer("byteLength", 1, most, 0);
  const auto size = document.value()["buffers"][static_cast<std::size_t>(buffer)]["byteLength"]
                        .get<std::uint64_t>();
  if (offset + length > size) {
    view.fault("ends at byte " + std::to_string(offset + length) + " of a buffer of " +
               std::to_string(size));
  }
  if (view.integer("byteStride", 4, 252, 4) % 4 != 0) {
    view.member("byteStride").fault("must be a multiple of 4");
  }
}

struct Run {  // of equal elements
  std::uint64_t count = 0, size = 0, component = 1, end_padding = 0;
};

// `place` names a view and an offset into it where the run's elements are.
void check_run(const Place& place, const Place& document, const Run& run, bool may_stride) {
  const std::int64_t index = place.index("bufferView", count_of(document, "bufferViews"));
  const Json& view = document.value()["bufferViews"][static_cast<std::size_t>(index)];
  const std::uint64_t offset =
      place.integer("byteOffset", 0, document.context().limits.total_bytes, 0);
  if (offset % run.component != 0) {
    place.member("byteOffset")
        .fault("is " + std::to_string(offset) + ", must be a multiple of " +
               std::to_string(run.component));
  }
  const std::uint64_t stride = may_stride ? view.value("byteStride", run.size) : run.size;
  if (stride < run.size) {
    place.fault("byteStride " + std::to_string(stride) + " of its bufferView is less than its " +
                std::to_string(run.size) + " bytes an element");
  }
  const std::uint64_t end = offset + stride * (run.count - 1) + run.size - run.end_padding;
  if (end > view["byteLength"].get<std::uint64_t>()) {
    place.fault("ends at byte " + std::to_string(end) + " of a bufferView of " +
                view["byteLength"].dump());
  }
}

void check_sparse(const Place& accessor, const Place& document, const Run& values) {
  const Place sparse = accessor.member("sparse");
  sparse.require_object();
  for (const char* key : {"count", "indices", "values"}) sparse.require_member(key);
  const std::uint64_t count = sparse.integer("count", 1, values.count, 0);
  const Place indices = sparse.member("indices"), substitutes = sparse.member("values");
  for (const Place* part : {&indices, &substitutes}) {
    part->require_object();
    part->require_member("bufferView");
  }
  indices.require_member("componentType");
  const std::uint64_t type = indices.integer("componentType", 0, most_count, 0);
  if (type != component_u8 && type != component_u16 && type != component_u32) {
    indices.member("componentType")
        .fault("is " + std::to_string(type) + ", must be 5121, 5123 or 5125");
  }
  check_run(indices, document, {count, component_size(type), component_size(type), 0}, false);
  check_run(substitutes, document, {count, values.size, values.component, values.end_padding},
            false);
}

void check_accessor(const Place& accessor, const Place& document) {
  for (const char* key : {"componentType", "count", "type"}) accessor.require_member(key);
  const std::uint64_t component = accessor.integer("componentType", 0, most_count, 0);
  if (component_size(component) == 0) {
    accessor.member("componentType")
        .fault("is " + std::to_string(component) + ", must be 5120 to 5123, 5125 or 5126");
  }
  const std::string type = accessor.member("type").as_string();
  const std::size_t size = element_size(component, type);
  if (size == 0) accessor.member("type").fault("is " + quote(type) + ", must be like \"VEC3\"");
  const std::uint64_t count = accessor.integer("count", 1, most_count, 0);
  accessor.check_boolean("normalized");
  const Run run{count, size, component_size(component), end_padding(component, type)};
  if (accessor.has("bufferView")) {
    check_run(accessor, document, run, true);
  } else {
    accessor.integer("byteOffset", 0, document.context().limits.total_bytes, 0);
  }
  if (accessor.has("sparse")) check_sparse(accessor, document, run);
}

}  // namespace

void check_buffers(const Place& document) {
  std::uint64_t total = 0;
  for_each_object(document, "buffers", [&](const Place& buffer) {
    check_buffer(buffer, document);
    total += buffer.value()["byteLength"].get<std::uint64_t>();
    if (total > document.context().limits.total_bytes) {
      buffer.fault("buffers of more than " + std::to_string(document.context().limits.total_bytes) +
                   " bytes in all");
    }
  });
  for_each_object(document, "bufferViews", [&](const Place& view) { check_view(view, document); });
  check_meshopt_views(document);
}

void check_accessors(const Place& document) {
  for_each_object(document, "accessors",
                  [&](const Place& accessor) { check_accessor(accessor, document); });
}

}  // namespace restframe
