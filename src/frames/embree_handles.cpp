#include "frames/embree_handles.h"

#include <string>

#include "scene/error.h"

namespace restframe {
namespace {

// Embree calls this from whatever thread fails; the first words are kept until check().
thread_local std::string last_words;

void on_error(void*, RTCError code, const char* words) {
  if (code != RTC_ERROR_NONE && last_words.empty()) last_words = words;
}

std::string device_options([[maybe_unused]] int threads) {
#ifdef RESTFRAME_THREADS_ONLY
  return "threads=1,set_affinity=0";
#else
  return "threads=" + std::to_string(threads);
#endif
}

}  // namespace

EmbreeDevice::EmbreeDevice(int threads) : device_(rtcNewDevice(device_options(threads).c_str())) {
  if (device_ == nullptr) throw OutputError("Embree can not start on this machine");
  rtcSetDeviceErrorFunction(device_, on_error, nullptr);
  rtcSetDeviceMemoryMonitorFunction(device_, count_memory, &memory_);
}

bool EmbreeDevice::count_memory(void* memory, ssize_t change, bool) {
  auto& counted = *static_cast<Memory*>(memory);
  const std::ptrdiff_t now = counted.now += change;
  std::ptrdiff_t peak = counted.peak;
  while (now > peak && !counted.peak.compare_exchange_weak(peak, now)) continue;
  return true;
}

EmbreeDevice::~EmbreeDevice() {
  rtcReleaseDevice(device_);
}

void EmbreeDevice::check() const {
  const std::string words = std::exchange(last_words, {});
  const RTCError code = rtcGetDeviceError(device_);
  if (!words.empty()) throw OutputError("Embree: " + words);
  if (code != RTC_ERROR_NONE) {
    throw OutputError("Embree: error " + std::to_string(static_cast<int>(code)));
  }
}

EmbreeScene new_scene(const EmbreeDevice& device) {
  EmbreeScene scene(rtcNewScene(device.get()));
  rtcSetSceneBuildQuality(scene.get(), RTC_BUILD_QUALITY_MEDIUM);
  // Else rays slip through between triangles that share an edge.
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  return scene;
}

}  // namespace restframe
