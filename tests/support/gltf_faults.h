#pragma once

// For tests of bad glTF files: what the importer says of a good file that was damaged in one way.

#include <gtest/gtest.h>

#include <functional>

#include "importers/importers.h"
#include "scene/error.h"
#include "support/gltf_builder.h"
#include "support/temporary_folder.h"

namespace restframe::test {

// What load_gltf says about the file, without the folder's name; empty if the file is read.
inline std::string fault_of(const std::filesystem::path& path, const ImportLimits& limits = {}) {
  Warnings warnings;
  try {
    load_gltf(path, limits, warnings);
  } catch (const InputError& error) {
    const std::string message = error.what(), folder = path.parent_path().string() + "/";
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_EQ(message.rfind(folder, 0), 0U) << message;
    return message.substr(std::min(folder.size(), message.size()));
  }
  return "";
}

inline std::string fault_of_bytes(const std::string& bytes, const ImportLimits& limits = {}) {
  const TemporaryFolder folder;
  return fault_of(folder.write("a.glb", bytes), limits);
}

inline void expect_fault(const std::string& fault, const std::string& begin,
                         const std::string& part = "") {
  EXPECT_EQ(fault.rfind("a.glb:" + begin, 0), 0U) << fault;
  EXPECT_NE(fault.find(part), std::string::npos) << fault << "\nlacks: " << part;
}

using Damage = std::function<void(GltfBuilder&)>;

// Loads a damaged `one_triangle`, which has accessors and views 0 (POSITION) and 1 (indices), mesh
// 0 and node 0. What is said must begin with the place and hold the part.
inline void expect_damage(const Damage& damage, const std::string& begin,
                          const std::string& part = "", const ImportLimits& limits = {}) {
  GltfBuilder builder = one_triangle();
  damage(builder);
  expect_fault(fault_of_bytes(builder.glb(), limits), begin, part);
}

// Sets the value at a JSON pointer.
inline Damage set(const std::string& pointer, const nlohmann::json& value) {
  return [=](GltfBuilder& b) { b.json[nlohmann::json::json_pointer(pointer)] = value; };
}

}  // namespace restframe::test
