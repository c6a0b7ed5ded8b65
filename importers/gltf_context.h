#pragma once

#include <set>
#include <string>

#include "importers/importers.h"

namespace restframe {

// What all steps of reading one glTF file share.
struct GltfContext {
  Path path;
  std::string file;  // the path as messages show it
  const ImportLimits& limits;
  Warnings& warnings;
  std::set<Path>& files;  // those read so far, besides the file itself

  // "FILE:POINTER"; an empty pointer means the file as a whole.
  std::string place(const std::string& pointer) const;
  // Throws InputError "FILE:POINTER: what".
  [[noreturn]] void fault(const std::string& pointer, const std::string& what) const;
  void warn(const std::string& pointer, const std::string& what) const;
};

}  // namespace restframe
