#pragma once

#include <functional>

#include "support/gltf_builder.h"
#include "support/hostile.h"

namespace restframe::test {

// Files made of a good triangle, broken in one way each.
class HostileGltf : public Hostile {
 protected:
  using Break = std::function<void(GltfBuilder&)>;

  void expect_bytes_refused(const std::string& bytes, const std::string& begin,
                            const std::string& part = "") const {
    folder.write("a.glb", bytes);
    expect_refused("a.glb", begin, part);
  }

  // The triangle of gltf_builder.h has accessors and views 0 (POSITION) and 1 (indices).
  void expect_broken(const Break& change, const std::string& begin,
                     const std::string& part = "") const {
    GltfBuilder builder = one_triangle();
    change(builder);
    expect_bytes_refused(builder.glb(), begin, part);
  }

  void expect_set(const std::string& pointer, const nlohmann::json& value, const std::string& begin,
                  const std::string& part = "") const {
    SCOPED_TRACE(pointer + " = " + value.dump().substr(0, 60));
    expect_broken([&](GltfBuilder& b) { b.json[nlohmann::json::json_pointer(pointer)] = value; },
                  begin, part);
  }
};

}  // namespace restframe::test
