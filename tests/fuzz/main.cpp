// The fuzzer: libFuzzer's main function calls what is here. The target is chosen by an argument,
// --target=NAME, which libFuzzer leaves alone.

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <optional>

#include "fuzz/glb_parts.h"
#include "fuzz/targets.h"

using namespace restframe::fuzz;

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

const Target* target = nullptr;

// Mutates one half, and puts the halves together again with the lengths that they now have.
std::optional<std::string> mutated_glb(std::string_view bytes, std::size_t max_size,
                                       unsigned seed) {
  std::optional<GlbParts> parts = split_glb(bytes);
  if (!parts) return std::nullopt;
  std::string& half = seed % 3 == 0 ? parts->bin : parts->json;
  const std::size_t size = half.size();
  half.resize(std::max(max_size, size));
  half.resize(LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(half.data()), size, half.size()));
  std::string whole = join_glb(*parts);
  if (whole.size() > max_size) return std::nullopt;
  return whole;
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  const std::string_view option = "--target=";
  for (int i = 1; i < *argc; ++i) {
    const std::string_view argument = (*argv)[i];
    if (argument.substr(0, option.size()) != option) continue;
    try {
      target = &find_target(argument.substr(option.size()));
    } catch (const std::exception& error) {
      std::cerr << "error: " << error.what() << '\n';
      std::exit(2);
    }
  }
  if (target != nullptr) return 0;
  std::cerr << "error: --target=NAME is missing\n";
  std::exit(2);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const InputFolder folder;
  read(*target, folder, {reinterpret_cast<const char*>(data), size});
  return 0;
}

// Of a GLB whose lengths are wrong, nothing but its header is ever read: four mutations in five
// keep them right.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  if (std::string_view(target->name) == "glb" && seed % 5 != 0) {
    const auto glb = mutated_glb({reinterpret_cast<const char*>(data), size}, max_size, seed / 5);
    if (glb) return glb->copy(reinterpret_cast<char*>(data), glb->size());
  }
  return LLVMFuzzerMutate(data, size, max_size);
}
