#include "importers/file_hash.h"

#include <fmt/format.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <memory>
#include <new>
#include <vector>

#include "importers/input_file.h"

namespace restframe {
namespace {

struct FreeState {
  void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
};

std::string hexadecimal(XXH128_hash_t hash) {
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace

std::string file_hash(const std::filesystem::path& path) {
  const std::unique_ptr<XXH3_state_t, FreeState> state(XXH3_createState());
  if (!state || XXH3_128bits_reset(state.get()) != XXH_OK) throw std::bad_alloc();
  InputFile file(path, path.string());
  std::vector<char> block(1 << 20);
  for (std::size_t left = file.size(); left > 0;) {
    const std::size_t count = std::min(left, block.size());
    file.read(block.data(), count);
    XXH3_128bits_update(state.get(), block.data(), count);
    left -= count;
  }
  return hexadecimal(XXH3_128bits_digest(state.get()));
}

}  // namespace restframe
