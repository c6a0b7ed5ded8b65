#pragma once

#include <string>
#include <vector>

#include "app/options.h"

namespace restframe {

// Each throws InputError with the option's name where the text is something else.

// "AxB" or "AxBxC": as many whole numbers, each at least 1, as `numbers` has places.
void parse_sizes(const std::string& option, const std::string& text, std::vector<int*> numbers);

// The pictures "7", "0-119", "0-999:10" (every tenth), or several of these joined by commas.
std::vector<PictureRange> parse_pictures(const std::string& text);

// The share "3/16".
TileShare parse_share(const std::string& text);
// Fractions of c joined by commas: 1 to 8 of them, each once, at least 0 and below 1.
std::vector<double> parse_speeds(const std::string& text);

}  // namespace restframe
