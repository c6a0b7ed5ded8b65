#pragma once

#include <bit>

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

// A bit for each lane that is active, the lowest for lane 0.
inline unsigned active_bits(const Lanes<std::int32_t>& active) {
  unsigned bits = 0;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) bits |= active[i] != 0 ? 1U << i : 0U;
  return bits;
}

// Which of the waiting lanes have the same key as lane `first`; they no longer wait.
template <class Key>
Lanes<std::int32_t> take_group(const Lanes<Key>& keys, int first, Lanes<std::int32_t>& waiting) {
  const Key key = keys[first];
  Lanes<std::int32_t> same, group;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) same[i] = keys[i] == key ? -1 : 0;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const std::int32_t waits = waiting[i];
    group[i] = waits & same[i];
    waiting[i] = waits & ~same[i];
  }
  return group;
}

// Calls visit(first, group) for each set of active lanes that have the same key: its first lane, and
// -1 for all of them. Coherent packets have one to three sets.
template <class Key, class Visit>
void for_each_group(const Lanes<Key>& keys, const Lanes<std::int32_t>& active, const Visit& visit) {
  Lanes<std::int32_t> waiting = active;
  for (unsigned bits = active_bits(waiting); bits != 0; bits = active_bits(waiting)) {
    const int first = std::countr_zero(bits);
    const Lanes<std::int32_t> group = take_group(keys, first, waiting);
    visit(first, group);
  }
}

}  // namespace restframe
