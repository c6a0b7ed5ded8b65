#pragma once

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace restframe {

// Sets that grow together (union-find), whose members are of two kinds: each knows whether it is of
// the same kind as its set's first.
class ParitySets {
 public:
  struct Member {
    std::uint32_t root = 0;
    bool differs = false;  // from the root
  };

  explicit ParitySets(std::size_t size) : parent_(size), differs_(size, 0) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  Member find(std::uint32_t member) {
    bool differs = false;
    while (parent_[member] != member) {
      const std::uint32_t up = parent_[member];
      differs_[member] = static_cast<char>(differs_[member] ^ differs_[up]);
      parent_[member] = parent_[up];
      differs = differs != (differs_[member] != 0);
      member = parent_[member];
    }
    return {member, differs};
  }

  // Says that two members differ in kind, or not. False if it contradicts what was said before.
  bool unite(std::uint32_t a, std::uint32_t b, bool differ) {
    Member first = find(a), second = find(b);
    if (first.root == second.root) return (first.differs != second.differs) == differ;
    if (first.root > second.root) std::swap(first, second);
    parent_[second.root] = first.root;
    differs_[second.root] = (first.differs != second.differs) != differ ? 1 : 0;
    return true;
  }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<char> differs_;  // from the parent
};

}  // namespace restframe
