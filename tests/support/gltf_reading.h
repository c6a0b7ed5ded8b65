#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "importers/importers.h"
#include "support/gltf_builder.h"
#include "support/temporary_folder.h"

namespace restframe::test {

// The positions of a triangle's corners.
inline const std::vector<float> triangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};

inline void expect_near(const Vec3f& value, const Vec3f& expected) {
  EXPECT_LT(glm::distance(value, expected), 1e-6F)
      << value.x << " " << value.y << " " << value.z << ", expected " << expected.x << " "
      << expected.y << " " << expected.z;
}

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
