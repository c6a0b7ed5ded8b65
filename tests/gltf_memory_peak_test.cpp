// The most memory that reading a GLB takes, as operator new is asked for it: room that is reserved
// counts, even where no page of it is touched.

#include <gtest/gtest.h>
#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "support/gltf_builder.h"
#include "support/gltf_reading.h"

namespace {
std::atomic<std::size_t> held{0}, most_held{0};
}

// Not inlined: the compiler would take malloc and delete for a mismatched pair.
[[gnu::noinline]] void* operator new(std::size_t size) {
  void* memory = std::malloc(size ? size : 1);
  if (memory == nullptr) throw std::bad_alloc();
  const std::size_t now = held += malloc_usable_size(memory);
  std::size_t most = most_held;
  while (now > most && !most_held.compare_exchange_weak(most, now)) {
  }
  return memory;
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  held -= malloc_usable_size(memory);
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  operator delete(memory);
}

namespace restframe {
namespace {

using nlohmann::json;
using test::GltfBuilder;

class GltfMemoryPeak : public test::GltfReading {
 protected:
  // Over the size of the asset's geometry.
  double peak_of(const std::string& path) {
    const std::size_t before = held;
    most_held = before;
    const Asset asset = load_gltf(path, {}, warnings_);
    std::size_t kept = 0;
    for (const Mesh& mesh : asset.meshes) kept += bytes_of(mesh);
    return static_cast<double>(most_held - before) / static_cast<double>(kept);
  }

  std::string file_of(const GltfBuilder& builder) { return folder_.write("a.glb", builder.glb()); }
};

// The triangles of a strip of quads, in as many primitives of one list of vertices. Of a primitive
// are those side by side, or every so manieth.
GltfBuilder strip(std::uint32_t quads, std::uint32_t primitives, bool side_by_side) {
  std::vector<float> positions, normals;
  for (std::uint32_t i = 0; i <= quads; ++i) {
    const auto x = static_cast<float>(i);
    positions.insert(positions.end(), {x, 0, 0, x, 1, 0});
    normals.insert(normals.end(), {0, 0, 1, 0, 0, 1});
  }
  std::vector<std::vector<std::uint32_t>> indices(primitives);
  for (std::uint32_t i = 0; i < quads; ++i) {
    const std::uint32_t a = 2 * i, of = side_by_side ? i * primitives / quads : i % primitives;
    indices[of].insert(indices[of].end(), {a, a + 2, a + 1, a + 1, a + 2, a + 3});
  }
  GltfBuilder builder;
  const json attributes = {{"POSITION", builder.add_accessor(positions, "VEC3")},
                           {"NORMAL", builder.add_accessor(normals, "VEC3")}};
  json all;
  for (const auto& some : indices) {
    all.push_back({{"attributes", attributes}, {"indices", builder.add_accessor(some, "SCALAR")}});
  }
  builder.add_mesh(all[0]);
  builder.json["meshes"][0]["primitives"] = all;
  return builder;
}

TEST_F(GltfMemoryPeak, OfOnePrimitiveIsTheFileAndTheMesh) {
  EXPECT_LT(peak_of(file_of(strip(60'000, 1, true))), 2.1);
}

TEST_F(GltfMemoryPeak, OfPrimitivesThatShareVerticesIsLessThanTwoAndAHalf) {
  for (const bool side_by_side : {true, false}) {
    for (const std::uint32_t primitives : {3U, 8U}) {
      SCOPED_TRACE(primitives);
      EXPECT_LT(peak_of(file_of(strip(60'000, primitives, side_by_side))), 2.5);
    }
  }
}

}  // namespace
}  // namespace restframe
