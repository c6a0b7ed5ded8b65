#pragma once

#include <map>
#include <string>
#include <vector>

#include "importers/importers.h"

namespace restframe {

// A texture statement of an MTL file, with its options.
struct MtlMap {
  std::string key;            // as written: map_Kd
  std::string file;           // as written
  Vec2f offset{0}, scale{1};  // -o, -s: texture coordinates times scale plus offset, v upwards
  bool clamp = false;         // -clamp on
  bool smooth = true;         // unless -blendu off and -blendv off
  char channel = 0;           // -imfchan: r, g, b, m(atte), l(uminance), z; 0: not given
  float multiplier = 1;       // -bm
  float base = 0, gain = 1;   // -mm: a value becomes base + gain value
};

// One newmtl of an MTL file. Keys are in lower case.
struct MtlMaterial {
  std::string name;
  Path file;                            // textures are relative to its folder
  std::map<std::string, Vec3f> colors;  // kd ks ke tf
  std::map<std::string, float> numbers;
  std::map<std::string, MtlMap> maps;  // by what they are for: bump for map_Bump, too
};

// Appends the materials of an MTL file. Throws InputError for malformed numbers and for whatever
// makes it unreadable.
void read_mtl(const Path& path, const ImportLimits& limits, std::vector<MtlMaterial>& materials,
              Warnings& warnings);

}  // namespace restframe
