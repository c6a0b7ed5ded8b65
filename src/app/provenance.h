#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace restframe {

// What made a picture, as its header says it: two of the same provenance have the same pixels.
struct Provenance {
  std::string settings;  // canonical_settings()
  std::string sources;   // a line a file: its hash, its name
  std::string program;   // "restframe 1.2.3"; its last number does not change pixels
};

Provenance provenance_of(const Scene& scene);

// What pixels depend on, within a release: the settings and the assets, not how the scene file is written.
std::string pixel_text(const Provenance& provenance);

// Names and values of the header's attributes.
std::vector<std::pair<std::string, std::string>> texts_of(const Provenance& provenance);

// From such attributes: any map of texts.
template <class Texts>
Provenance provenance_in(const Texts& texts) {
  Provenance provenance;
  for (const auto& [name, text] : texts) {
    if (name == "restframeSettings") provenance.settings = text;
    if (name == "restframeSources") provenance.sources = text;
    if (name == "software") provenance.program = text;
  }
  return provenance;
}

// The first thing that differs, in words; empty where nothing does. Of a scene file only its settings
// count, not its wording.
std::string difference(const Provenance& before, const Provenance& now);

}  // namespace restframe
