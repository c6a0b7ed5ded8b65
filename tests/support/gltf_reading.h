#pragma once

#include <gtest/gtest.h>

#include "importers/importers.h"
#include "support/gltf_builder.h"
#include "support/temporary_folder.h"

namespace restframe::test {

// Reads what a builder made, and keeps the warnings.
class GltfReading : public testing::Test {
 protected:
  Asset load(const std::string& bytes, const std::string& name = "asset.glb") {
    warnings_.clear();
    return load_gltf(folder_.write(name, bytes), {}, warnings_);
  }
  Asset load(const GltfBuilder& builder) { return load(builder.glb()); }

  // Whether a warning holds this text.
  bool warned(const std::string& text) const {
    for (const std::string& warning : warnings_) {
      if (warning.find(text) != std::string::npos) return true;
    }
    return false;
  }

  TemporaryFolder folder_;
  Warnings warnings_;
};

}  // namespace restframe::test
