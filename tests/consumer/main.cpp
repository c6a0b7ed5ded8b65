#include <cmath>
#include <cstdio>

#include "physics/doppler.h"
#include "physics/worldline.h"
#include "scene/parallel.h"

// Something that comes at 0.6 c is seen with twice the frequency: sqrt((1 + 0.6) / (1 - 0.6)) = 2.
int main() {
  using namespace restframe;
  const Boost<in::Rest, in::World> rest_from_world(Velocity::from_beta({0, 0, 0.6}));
  const WaveVector<in::Rest> k = rest_from_world(looking_along<in::World>({0, 0, -1}));
  const Event<in::Rest> seen = seen_event({{}, rest_from_world}, {0, {0, 0, 0}}, {3, 4, 0});
  std::printf("doppler factor %.15g, seen at %.15g, %d threads\n", doppler_factor(k), seen.t,
              thread_count());
  return std::abs(doppler_factor(k) - 2) < 1e-12 && std::abs(seen.t + 5) < 1e-12 ? 0 : 1;
}
