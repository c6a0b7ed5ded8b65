#pragma once

#include <embree3/rtcore.h>

#include <atomic>
#include <cstddef>
#include <utility>

namespace restframe {

// Owns one reference to an Embree object.
template <class Handle, void (*release)(Handle)>
class EmbreeHandle {
 public:
  EmbreeHandle() = default;
  explicit EmbreeHandle(Handle handle) : handle_(handle) {}
  EmbreeHandle(EmbreeHandle&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
  EmbreeHandle& operator=(EmbreeHandle&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  EmbreeHandle(const EmbreeHandle&) = delete;
  EmbreeHandle& operator=(const EmbreeHandle&) = delete;
  ~EmbreeHandle() {
    if (handle_ != nullptr) release(handle_);
  }

  Handle get() const { return handle_; }
  explicit operator bool() const { return handle_ != nullptr; }

 private:
  Handle handle_ = nullptr;
};

using EmbreeScene = EmbreeHandle<RTCScene, rtcReleaseScene>;
using EmbreeGeometry = EmbreeHandle<RTCGeometry, rtcReleaseGeometry>;

// The device, its error callback and what its memory monitor counts.
class EmbreeDevice {
 public:
  // Throws OutputError if Embree can not start. `threads` bounds what building uses.
  explicit EmbreeDevice(int threads);
  EmbreeDevice(const EmbreeDevice&) = delete;
  EmbreeDevice& operator=(const EmbreeDevice&) = delete;
  ~EmbreeDevice();

  RTCDevice get() const { return device_; }

  // Throws OutputError with Embree's words if anything failed since the last call.
  void check() const;

  std::size_t bytes_in_use() const { return static_cast<std::size_t>(memory_.now.load()); }
  std::size_t peak_bytes() const { return static_cast<std::size_t>(memory_.peak.load()); }

 private:
  RTCDevice device_ = nullptr;
  struct Memory {
    std::atomic<std::ptrdiff_t> now{0}, peak{0};
  } memory_;

  static bool count_memory(void* memory, ssize_t change, bool post);
};

// A scene of still geometry, not yet committed.
EmbreeScene new_scene(const EmbreeDevice& device);

}  // namespace restframe
