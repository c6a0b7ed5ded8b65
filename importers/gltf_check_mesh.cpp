// Meshes: accessors of the right kind, as many elements as there are vertices, and not too much in
// all.

#include "importers/gltf_check.h"
#include "importers/gltf_check_attributes.h"
#include "importers/gltf_check_compressed.h"
#include "importers/gltf_layout.h"

namespace restframe {
namespace {

std::uint64_t check_indices(const Place& primitive, const Place& document) {
  const std::int64_t index = primitive.index("indices", count_of(document, "accessors"));
  const Json& accessor = accessor_at(document, index);
  const auto component = accessor["componentType"].get<std::uint64_t>();
  if (accessor["type"] != "SCALAR" || accessor.value("normalized", false) ||
      !(component == component_u8 || component == component_u16 || component == component_u32)) {
    primitive.member("indices").fault(
        "must be scalars of componentType 5121, 5123 or 5125, not normalized");
  }
  return accessor["count"].get<std::uint64_t>();
}

struct Totals {
  std::uint64_t triangles = 0, bytes = 0;
};

// Returns its number of morph targets.
std::size_t check_primitive(const Place& primitive, const Place& document, bool quantized,
                            Totals& totals) {
  primitive.require_member("attributes");
  const Place attributes = primitive.member("attributes");
  const CheckedAttributes checked = check_attributes(attributes, document, quantized);
  const std::uint64_t corners =
      primitive.has("indices") ? check_indices(primitive, document) : checked.vertices;
  const std::uint64_t mode = primitive.integer("mode", 0, 6, 4);
  primitive.index("material", count_of(document, "materials"));
  if (primitive.has("extensions")) primitive.member("extensions").require_object();
  check_draco(primitive, document);

  const std::uint64_t triangles = mode == 4 ? corners / 3 : mode > 4 ? corners : 0;
  totals.triangles += triangles;
  totals.bytes += triangles * sizeof(Triangle) + checked.bytes;
  const ImportLimits& limits = document.context().limits;
  if (totals.triangles > limits.triangles) {
    primitive.fault("more than " + std::to_string(limits.triangles) +
                    " triangles in all; --max-triangles raises the limit");
  }
  if (totals.bytes > limits.total_bytes) {
    primitive.fault("geometry of more than " + std::to_string(limits.total_bytes) +
                    " bytes in all; --max-bytes raises the limit");
  }
  return check_morph_targets(primitive, document, quantized, checked.vertices);
}

// The weights of a mesh, or of a node that places it.
void check_weights(const Place& place, std::size_t targets) {
  if (place.has("weights")) place.check_numbers("weights", targets, -1e15, 1e15);
}

// The number of its morph targets.
std::size_t check_mesh(const Place& mesh, const Place& document, bool quantized, Totals& totals) {
  mesh.require_member("primitives");
  std::size_t targets = 0, index = 0;
  for_each_object(mesh, "primitives", [&](const Place& primitive) {
    const std::size_t count = check_primitive(primitive, document, quantized, totals);
    if (index++ > 0 && count != targets) {
      primitive.fault("has " + std::to_string(count) + " morph targets, the one before " +
                      std::to_string(targets));
    }
    targets = count;
  });
  check_weights(mesh, targets);
  return targets;
}

}  // namespace

void check_meshes(const Place& document) {
  const bool quantized = uses_quantization(document.value());
  Totals totals;
  std::vector<std::size_t> targets;  // of each mesh
  std::size_t morphed = 0;
  for_each_object(document, "meshes", [&](const Place& mesh) {
    targets.push_back(check_mesh(mesh, document, quantized, totals));
    morphed += targets.back() > 0 ? 1U : 0U;
  });
  for_each_object(document, "nodes", [&](const Place& node) {
    const std::int64_t mesh = node.index("mesh", targets.size());
    if (mesh >= 0) check_weights(node, targets[static_cast<std::size_t>(mesh)]);
  });
  if (morphed == 0) return;
  document.context().warn("/meshes", "morph targets of " + std::to_string(morphed) +
                                         " meshes are not moved: read in its rest pose, with the "
                                         "weights that the file gives");
}

}  // namespace restframe
