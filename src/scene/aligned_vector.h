#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace restframe {

// Puts the first element at the beginning of a cache line.
template <class T>
struct CacheAligned {
  using value_type = T;
  static constexpr std::align_val_t cache_line{64};

  CacheAligned() = default;
  template <class U>
  explicit CacheAligned(const CacheAligned<U>&) {}

  T* allocate(std::size_t count) {
    return static_cast<T*>(::operator new(count * sizeof(T), cache_line));
  }
  void deallocate(T* memory, std::size_t) { ::operator delete(memory, cache_line); }
  bool operator==(const CacheAligned&) const = default;
};

// What is read or written a few elements at a time, all over, while rays are traced.
template <class T>
using AlignedVector = std::vector<T, CacheAligned<T>>;

}  // namespace restframe
