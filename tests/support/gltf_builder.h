#pragma once

// Small glTF files, made in memory by tests.

#include <nlohmann/json.hpp>

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "support/image_files.h"

namespace restframe::test {

// The document and its one buffer. `json` may be changed freely before it is written.
struct GltfBuilder {
  nlohmann::json json = {{"asset", {{"version", "2.0"}}}};
  std::string bin;

  // Adds raw bytes as a bufferView (4-byte aligned) and returns its index.
  int add_view(const void* bytes, std::size_t size, int stride = 0);

  template <class T>
  int add_view(const std::vector<T>& values, int stride = 0) {
    return add_view(values.data(), values.size() * sizeof(T), stride);
  }

  // Adds an accessor over a view of its own and returns its index.
  template <class T>
  int add_accessor(const std::vector<T>& values, const std::string& type, bool normalized = false) {
    const int view = add_view(values);
    return add_accessor_of_view(view, component_type(T{}), type, values.size(), normalized);
  }
  int add_accessor_of_view(int view, int component, const std::string& type, std::size_t components,
                           bool normalized);

  // Appends to a top-level array and returns the index.
  int add(const std::string& key, const nlohmann::json& element);

  // A mesh of one primitive with these attributes, and a node that places it. Returns the mesh's
  // index.
  int add_mesh(const nlohmann::json& primitive);

  std::string glb() const;
  std::string gltf(const std::string& bin_uri) const;

 private:
  static int component_type(std::int8_t) { return 5120; }
  static int component_type(std::uint8_t) { return 5121; }
  static int component_type(std::int16_t) { return 5122; }
  static int component_type(std::uint16_t) { return 5123; }
  static int component_type(std::uint32_t) { return 5125; }
  static int component_type(float) { return 5126; }
};

// One triangle (0 0 0), (1 0 0), (0 1 0) with a node: the least that renders.
GltfBuilder one_triangle();

// GLB bytes of these chunks, lengths as given.
std::string glb_of(const std::string& json, const std::string& bin);
std::string chunk(const std::string& type, const std::string& content);
std::string little_endian(std::uint32_t value);

std::string base64(const std::string& bytes);

}  // namespace restframe::test
