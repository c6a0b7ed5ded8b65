#pragma once

#include "frames/packet.h"

namespace restframe {

// Sets lane i if it is in the group, without a branch.
template <class T>
void set_in(const Lanes<std::int32_t>& group, int i, Lanes<T>& lanes, T value) {
  blend(group[i] != 0, lanes[i], value);
}
inline void set_in(const Lanes<std::int32_t>& group, int i, Vec3fLanes& lanes, const Vec3f& v) {
  set_in(group, i, lanes.x, v.x);
  set_in(group, i, lanes.y, v.y);
  set_in(group, i, lanes.z, v.z);
}
inline void set_in(const Lanes<std::int32_t>& group, int i, Vec3Lanes& lanes, const Vec3& v) {
  set_in(group, i, lanes.x, v.x);
  set_in(group, i, lanes.y, v.y);
  set_in(group, i, lanes.z, v.z);
}

// Calls visit(first, group) for each set of active lanes that have the same key: its first lane, and
// -1 for all of them. Coherent packets have one to three sets.
template <class Key, class Visit>
void for_each_group(const Lanes<Key>& keys, const Lanes<std::int32_t>& active, const Visit& visit) {
  Lanes<std::int32_t> waiting = active;
  for (int first = 0; any_active(waiting); ++first) {
    if (waiting[first] == 0) continue;
    const Key key = keys[first];
    Lanes<std::int32_t> group;
#pragma GCC ivdep
    for (int i = 0; i < packet_size; ++i) {
      const std::int32_t waits = waiting[i];
      const bool same = keys[i] == key;
      group[i] = same ? waits : 0;
      waiting[i] = same ? 0 : waits;
    }
    visit(first, group);
  }
}

}  // namespace restframe
