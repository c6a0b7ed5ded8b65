#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <string>

#include "importers/importers.h"
#include "scene/error.h"
#include "support/temporary_folder.h"

namespace restframe::test {

// Reads meshes made by tests, and keeps the warnings. The extension of `name` chooses the reader.
class MeshReading : public testing::Test {
 protected:
  Asset load(const std::string& name, const std::string& bytes, const ImportLimits& limits = {}) {
    warnings_.clear();
    return load_asset(files_.write(name, bytes), limits, warnings_);
  }

  // The one mesh of an asset.
  Mesh mesh_of(const std::string& name, const std::string& bytes) {
    const Asset asset = load(name, bytes);
    EXPECT_EQ(asset.meshes.size(), 1U);
    return asset.meshes.at(0);
  }

  // What is wrong with the file, after its name; empty if nothing is.
  std::string fault_of(const std::string& name, const std::string& bytes,
                       const ImportLimits& limits = {}) {
    try {
      load(name, bytes, limits);
      return "";
    } catch (const InputError& error) {
      const std::string message = error.what(), path = (files_.path() / name).string();
      EXPECT_EQ(message.find('\n'), message.npos);
      EXPECT_EQ(message.substr(0, path.size()), path);
      return message.substr(std::min(path.size(), message.size()));
    }
  }

  // The warnings, each after the file's name.
  std::vector<std::string> told() const {
    std::vector<std::string> result;
    for (const std::string& warning : warnings_) {
      const std::size_t end = warning.find(files_.path().string());
      const std::size_t colon = warning.find(':');
      result.push_back(end == 0 ? warning.substr(colon) : warning);
    }
    return result;
  }

  TemporaryFolder files_;
  Warnings warnings_;
};

// What to put in place of the byte at an index: in turn, bytes that readers may stumble over.
inline char odd_byte(std::size_t index) {
  constexpr std::array bytes = {'\0', '9', '-', '\n', '\x7F', '#', '\xFF'};
  return bytes[index % bytes.size()];
}

// The bytes of a number, of the host's order (little) or the other.
template <class Number>
std::string bytes_of(Number number, bool big_endian = false) {
  std::string bytes(sizeof number, '\0');
  std::memcpy(bytes.data(), &number, sizeof number);
  if (big_endian) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

}  // namespace restframe::test
