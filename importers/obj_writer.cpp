#include "importers/obj_writer.h"

#include <algorithm>
#include <iterator>
#include <string>

#include <fmt/compile.h>
#include <fmt/format.h>

#include "scene/atomic_file.h"

namespace restframe {
namespace {

void flush(AtomicFile& file, fmt::memory_buffer& text, std::size_t at_least) {
  if (text.size() < at_least) return;
  file.write(std::string_view(text.data(), text.size()));
  text.clear();
}

constexpr std::size_t full = 1 << 15;

void write_vectors(AtomicFile& file, const char* keyword, const std::vector<Vec3f>& vectors) {
  fmt::memory_buffer text;
  for (const Vec3f& v : vectors) {
    fmt::format_to(std::back_inserter(text), FMT_COMPILE("{} {} {} {}\n"), keyword, v.x, v.y, v.z);
    flush(file, text, full);
  }
  flush(file, text, 0);
}

void write_faces(AtomicFile& file, const Asset& asset) {
  const Mesh& mesh = asset.meshes.at(0);
  fmt::memory_buffer text;
  auto range = mesh.materials.begin();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (; range != mesh.materials.end() && range->first_triangle == i; ++range) {
      const std::string& name = asset.materials.at(static_cast<std::size_t>(range->slot)).name;
      fmt::format_to(std::back_inserter(text), "usemtl {}\n", name);
    }
    const auto [a, b, c] = mesh.triangles[i];
    fmt::format_to(std::back_inserter(text), FMT_COMPILE("f {0}//{0} {1}//{1} {2}//{2}\n"), a + 1,
                   b + 1, c + 1);
    flush(file, text, full);
  }
  flush(file, text, 0);
}

// Roughness and metallic are those of the format's widespread PBR extension.
std::string as_mtl(const Material& material) {
  const Vec3f& color = material.base_color.value;
  return fmt::format("newmtl {}\nKd {} {} {}\nd {}\nPr {}\nPm {}\n", material.name, color.x,
                     color.y, color.z, material.opacity.value, material.roughness.value,
                     material.metallic.value);
}

void write_mtl(const Asset& asset, const std::filesystem::path& path) {
  write_file_atomically(path, [&](AtomicFile& file) {
    for (const Material& material : asset.materials) file.write(as_mtl(material));
  });
}

// Readers disagree about blanks in a name after `mtllib`, so there are none.
std::filesystem::path mtl_name(const std::filesystem::path& path) {
  std::string name = path.stem().string() + ".mtl";
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c >= 0 && c <= ' '; }, '_');
  return name;
}

}  // namespace

void write_obj(const Asset& asset, const std::filesystem::path& path) {
  const Mesh& mesh = asset.meshes.at(0);
  const std::filesystem::path mtl = mtl_name(path);
  write_file_atomically(path, [&](AtomicFile& file) {
    file.write(fmt::format("# restframe\nmtllib {}\no {}\n", mtl.string(), mesh.name));
    write_vectors(file, "v", mesh.positions);
    write_vectors(file, "vn", mesh.normals);
    write_faces(file, asset);
    write_mtl(asset, path.parent_path() / mtl);
  });
}

}  // namespace restframe
