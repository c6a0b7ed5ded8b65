#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace restframe {

// How many characters must be inserted, removed, exchanged, or swapped with their neighbour, to
// make one word of the other.
int edit_distance(std::string_view a, std::string_view b);

// The one of `known` that is spelled most like `word`, the first of equals; empty if there is none.
std::string nearest(std::string_view word, const std::vector<std::string>& known);

}  // namespace restframe
