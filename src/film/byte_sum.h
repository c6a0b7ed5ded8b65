#pragma once

#include <fmt/format.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <cstdint>
#include <string>

namespace restframe {

// XXH3 over bytes as they come: tells torn files, not forged ones.
class ByteSum {
 public:
  ByteSum() { XXH3_64bits_reset(&state_); }
  void add(const void* bytes, std::size_t count) { XXH3_64bits_update(&state_, bytes, count); }
  std::uint64_t value() const { return XXH3_64bits_digest(&state_); }
  std::string hex() const { return fmt::format("{:016x}", value()); }

 private:
  XXH3_state_t state_;
};

}  // namespace restframe
