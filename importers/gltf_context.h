#pragma once

#include <string>

#include "importers/importers.h"

namespace restframe {

// What all steps of reading one glTF file share.
struct GltfContext {
  Path path;
  std::string file;  // the path as messages show it
  const ImportLimits& limits;
  Warnings& warnings;

  // Throws InputError "FILE:POINTER: what"; an empty pointer means the file as a whole.
  [[noreturn]] void fault(const std::string& pointer, const std::string& what) const;
  void warn(const std::string& pointer, const std::string& what) const;
};

// Text from a file in quotation marks, cut if it is long.
std::string in_quotes(const std::string& text);

}  // namespace restframe
