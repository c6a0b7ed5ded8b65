#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace restframe {

// Numbers distinct triples from 0 on in the order in which they come: a hash table that only grows.
class IndexTable {
 public:
  using Key = std::array<std::uint32_t, 3>;

  explicit IndexTable(std::size_t expected = 0) {
    keys_.reserve(expected);
    std::size_t size = 16;
    while (size < 2 * expected) size *= 2;
    slots_.assign(size, empty);
  }

  // The number of `key`; keys().size() before the call if it is new.
  std::uint32_t insert(const Key& key) {
    if (2 * keys_.size() >= slots_.size()) grow();
    std::size_t slot = first_slot(key);
    while (slots_[slot] != empty && keys_[slots_[slot]] != key)
      slot = (slot + 1) & (slots_.size() - 1);
    if (slots_[slot] == empty) {
      slots_[slot] = static_cast<std::uint32_t>(keys_.size());
      keys_.push_back(key);
    }
    return slots_[slot];
  }

  const std::vector<Key>& keys() const { return keys_; }
  void reserve_keys(std::size_t count) { keys_.reserve(count); }

  // The table is empty afterwards.
  std::vector<Key> take_keys() {
    slots_ = std::vector<std::uint32_t>(16, empty);
    return std::exchange(keys_, {});
  }

 private:
  static constexpr std::uint32_t empty = 0xFFFFFFFFU;

  std::size_t first_slot(const Key& key) const {
    std::uint64_t h = 0;
    for (const std::uint32_t part : key) {
      h = (h ^ part) * 0x9E3779B97F4A7C15ULL;
      h ^= h >> 29U;
    }
    return static_cast<std::size_t>(h) & (slots_.size() - 1);
  }

  void grow() {
    slots_.assign(2 * slots_.size(), empty);
    for (std::size_t i = 0; i < keys_.size(); ++i) {
      std::size_t slot = first_slot(keys_[i]);
      while (slots_[slot] != empty) slot = (slot + 1) & (slots_.size() - 1);
      slots_[slot] = static_cast<std::uint32_t>(i);
    }
  }

  std::vector<Key> keys_;
  std::vector<std::uint32_t> slots_;
};

}  // namespace restframe
