// Preloaded into a program: counts the rays that it gives to Embree, and says so as it ends.

#include <dlfcn.h>
#include <embree3/rtcore.h>

#include <atomic>
#include <cstdio>

namespace {

std::atomic<unsigned long long> rays{0};

void count(const int* valid) {
  unsigned active = 0;
  for (int i = 0; i < 16; ++i) active += valid[i] != 0 ? 1U : 0U;
  rays.fetch_add(active, std::memory_order_relaxed);
}

struct Report {
  ~Report() { std::fprintf(stderr, "rays %llu\n", rays.load()); }
} report;

}  // namespace

extern "C" void rtcIntersect16(const int* valid, RTCScene scene, RTCIntersectContext* context,
                               RTCRayHit16* query) {
  static const auto next =
      reinterpret_cast<decltype(&rtcIntersect16)>(dlsym(RTLD_NEXT, "rtcIntersect16"));
  count(valid);
  next(valid, scene, context, query);
}

extern "C" void rtcOccluded16(const int* valid, RTCScene scene, RTCIntersectContext* context,
                              RTCRay16* query) {
  static const auto next =
      reinterpret_cast<decltype(&rtcOccluded16)>(dlsym(RTLD_NEXT, "rtcOccluded16"));
  count(valid);
  next(valid, scene, context, query);
}
