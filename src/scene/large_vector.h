#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <new>
#include <vector>

namespace restframe {

// Memory that is read or written all over while rays are traced. In pages of 2 MB where the system
// grants them: with the usual 4 kB, most accesses would wait for the page's address first. Begins
// at a cache line in any case.
template <class T>
struct LargePages {
  using value_type = T;
  static constexpr std::size_t page = std::size_t{1} << 21U;
  static constexpr std::size_t cache_line = 64;

  LargePages() = default;
  template <class U>
  explicit LargePages(const LargePages<U>&) {}

  static constexpr std::align_val_t alignment(std::size_t bytes) {
    return std::align_val_t{bytes < page ? cache_line : page};
  }
  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    void* memory = ::operator new(bytes, alignment(bytes));
    // A hint only: a system without such pages says no, and nothing is lost.
    if (bytes >= page) madvise(memory, bytes, MADV_HUGEPAGE);
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t count) {
    ::operator delete(memory, alignment(count * sizeof(T)));
  }
  bool operator==(const LargePages&) const = default;
};

template <class T>
using LargeVector = std::vector<T, LargePages<T>>;

}  // namespace restframe
