#pragma once

// What a fuzzer gives its inputs to, and what the ordinary tests replay: one entry point a kind of
// file. Each reads the bytes as that kind, as the program would.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace restframe::fuzz {

// A folder in memory (where the machine has one) that inputs are read from. Beside them lie small
// good files that inputs may name: b.bin (1024 bytes), t.png, m.mtl, a.obj, a.glb, f.txt, f.csv.
class InputFolder {
 public:
  InputFolder();
  ~InputFolder();
  InputFolder(const InputFolder&) = delete;
  InputFolder& operator=(const InputFolder&) = delete;

  std::filesystem::path write(const char* name, std::string_view bytes) const;

 private:
  std::filesystem::path path_;
};

struct Target {
  const char* name;
  const char* file;  // that holds the input, in the folder; null: it is not read from a file
  void (*read)(const std::filesystem::path& path, std::string_view bytes);
};

// Throws std::logic_error where what was read is not sound, or a message is not one line.
void read(const Target& target, const InputFolder& folder, std::string_view bytes);

const std::vector<Target>& targets();

// Throws std::invalid_argument, naming all targets, if there is none of that name.
const Target& find_target(std::string_view name);

}  // namespace restframe::fuzz
