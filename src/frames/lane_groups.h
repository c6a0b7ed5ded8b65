#pragma once

#include "frames/packet.h"

namespace restframe {

// Calls visit(first, group) for each set of active lanes that have the same key: its first lane, and
// -1 for all of them. Coherent packets have one to three sets.
template <class Key, class Visit>
void for_each_group(const Lanes<Key>& keys, const Lanes<std::int32_t>& active, const Visit& visit) {
  Lanes<std::int32_t> waiting = active;
  for (int first = 0; first < packet_size; ++first) {
    if (waiting[first] == 0) continue;
    const Key key = keys[first];
    Lanes<std::int32_t> group;
#pragma GCC ivdep
    for (int i = 0; i < packet_size; ++i) {
      const bool same = keys[i] == key;
      group[i] = same ? waiting[i] : 0;
      waiting[i] = same ? 0 : waiting[i];
    }
    visit(first, group);
  }
}

}  // namespace restframe
