#include "physics/worldline.h"

namespace restframe {

Event<in::Rest> seen_event(const AnchoredFrame<in::Rest>& rest, const Event<in::World>& observer,
                           const Vec3& point) {
  const Event<in::Rest> from = rest(observer);
  return {from.t - glm::length(point - from.x), point};
}

}  // namespace restframe
