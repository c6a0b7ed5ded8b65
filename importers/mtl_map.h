#pragma once

#include <set>
#include <string>
#include <string_view>

#include "importers/line_reader.h"
#include "importers/mtl_read.h"

namespace restframe {

// Reads what comes after the key of a texture statement: options, before or behind the file's name,
// which may have spaces. Adds options that are not used to `unused`. Throws InputError for options
// without their numbers.
MtlMap read_mtl_map(std::string_view key, std::string_view rest, const LineReader& lines,
                    std::set<std::string>& unused);

}  // namespace restframe
