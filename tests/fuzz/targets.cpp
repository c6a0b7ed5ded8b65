#include "fuzz/targets.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "fuzz/sound_asset.h"
#include "importers/csv_function.h"
#include "importers/importers.h"
#include "importers/paper_intervals.h"
#include "scene/error.h"
#include "scene/formula.h"
#include "scene/validate_data.h"
#include "support/gltf_builder.h"

namespace restframe::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr const char* triangle_obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n";

// Small, so that whatever takes long or fills the memory stands out.
ImportLimits small_limits() {
  ImportLimits limits;
  limits.json_bytes = 1'000'000;
  limits.nodes = 2'000;
  limits.triangles = 20'000;
  limits.image_pixels = 20'000;
  limits.total_bytes = 4'000'000;
  return limits;
}

void require_one_line(const std::string& message) {
  if (message.empty()) throw std::logic_error("an empty message");
  for (const char c : message) {
    if (static_cast<unsigned char>(c) < 0x20) throw std::logic_error("not one line: " + message);
  }
}

// Bad input is what the targets live on: it is an InputError whose every fault is one line.
template <class Read>
void expect_input_errors_only(const Read& read) {
  try {
    read();
  } catch (const InputError& error) {
    for (const std::string& fault : error.faults()) require_one_line(fault);
  }
}

void read_asset(const fs::path& path, std::string_view) {
  expect_input_errors_only([&] {
    Warnings warnings;
    require_sound(load_asset(path, small_limits(), warnings));
    for (const std::string& warning : warnings) require_one_line(warning);
  });
}

void read_mtl(const fs::path& path, std::string_view) {
  std::ofstream(path.parent_path() / "uses_mtl.obj") << "mtllib in.mtl\nusemtl a\n"
                                                     << triangle_obj << "f 1/1 2/1 3/1\n";
  read_asset(path.parent_path() / "uses_mtl.obj", "");
}

void read_image(const fs::path&, std::string_view bytes) {
  expect_input_errors_only([&] {
    const std::vector<std::uint8_t> copy(bytes.begin(), bytes.end());  // that ends where it ends
    decode_image(copy, "image", small_limits());
  });
}

void read_sky(const fs::path&, std::string_view bytes) {
  expect_input_errors_only([&] {
    const std::vector<std::uint8_t> copy(bytes.begin(), bytes.end());
    Warnings warnings;
    const SkyMap map = decode_sky_map(copy, "sky", small_limits(), warnings);
    for (const std::string& warning : warnings) require_one_line(warning);
    std::vector<std::string> faults;
    validate_sky_map(map, faults);
    if (!faults.empty()) throw std::logic_error(faults[0]);
  });
}

void read_scene(const fs::path& path, std::string_view) {
  expect_input_errors_only([&] {
    Warnings warnings;
    ImportLimits limits = small_limits();
    limits.triangles = 400;  // most time goes into balls and lattices otherwise
    load_scene(path, limits, warnings);
    for (const std::string& warning : warnings) require_one_line(warning);
  });
}

// Colours or numbers, by the length: one of a file's two meanings an execution.
void read_intervals(const fs::path& path, std::string_view bytes) {
  expect_input_errors_only([&] {
    const IntervalFunction function = read_paper_intervals(path, {bytes.size() % 2 == 0, {}});
    if (!temporal_faults(function).empty()) throw std::logic_error("a function with faults");
  });
}

void read_csv(const fs::path& path, std::string_view) {
  expect_input_errors_only([&] {
    const CsvRequest request{"t", {"r", "g", "b"}, {}, {}, 2.0};
    const KeyFunction function = read_csv_function(path, request, {true, {}});
    if (!temporal_faults(function).empty()) throw std::logic_error("a function with faults");
  });
}

void read_formula(const fs::path&, std::string_view bytes) {
  const std::string text(bytes);
  if (formula_fault(text)) return;
  Formula formula(text);
  for (const double time : {0.0, -1.0, 0.5, 1e300, -1e-300}) {
    const double value = formula(time);
    const bool same = value == formula(time) || std::isnan(value);
    if (!same && text.find("rnd") == text.npos) throw std::logic_error("two values at one time");
  }
}

fs::path memory_folder() {
  std::error_code error;
  const fs::path shared = "/dev/shm";
  return fs::is_directory(shared, error) ? shared : fs::temp_directory_path();
}

}  // namespace

InputFolder::InputFolder() {
  std::string name = (memory_folder() / "restframe-fuzz-XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::runtime_error("cannot create " + name);
  path_ = name;
  write("b.bin", std::string(1024, '\0'));
  write("t.png", test::png(2, 2, "0123456789abcdef"));
  write("m.mtl", "newmtl a\nKd 1 0 0\nmap_Kd t.png\n");
  write("a.obj", std::string("mtllib m.mtl\nusemtl a\n") + triangle_obj + "f 1/1 2/1 3/1\n");
  write("a.glb", test::one_triangle().glb());
  write("f.txt", "% period 1\n% interval 0 0.5 Yellow\n");
  write("f.csv", "t,r,g,b\n0,1,0,0\n1,0,1,0\n");
}

InputFolder::~InputFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

fs::path InputFolder::write(const char* name, std::string_view bytes) const {
  fs::path file = path_ / name;
  std::ofstream stream(file, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!stream.flush()) throw std::runtime_error("cannot write " + file.string());
  return file;
}

const std::vector<Target>& targets() {
  static const std::vector<Target> all = {
      {"gltf", "in.gltf", read_asset},  {"glb", "in.glb", read_asset},
      {"obj", "in.obj", read_asset},    {"mtl", "in.mtl", read_mtl},
      {"ply", "in.ply", read_asset},    {"stl", "in.stl", read_asset},
      {"off", "in.off", read_asset},    {"image", nullptr, read_image},
      {"scene", "in.toml", read_scene}, {"intervals", "in.txt", read_intervals},
      {"csv", "in.csv", read_csv},      {"formula", nullptr, read_formula},
      {"sky", nullptr, read_sky},
  };
  return all;
}

void read(const Target& target, const InputFolder& folder, std::string_view bytes) {
  target.read(target.file != nullptr ? folder.write(target.file, bytes) : fs::path(), bytes);
}

const Target& find_target(std::string_view name) {
  std::string names;
  for (const Target& target : targets()) {
    if (name == target.name) return target;
    names += fmt::format(" {}", target.name);
  }
  throw std::invalid_argument(fmt::format("no target \"{}\"; there are{}", name, names));
}

}  // namespace restframe::fuzz
