#pragma once

// What lights and materials say of their spectra.

#include "importers/scene_file.h"

namespace restframe {

// Keys of a table: `temperature`, `spectrum` and `lines`, with `prefix` before each.
SpectrumChange read_spectrum(TableReader& table, const std::string& prefix, SceneFile& file);

// Gives what emits the spectrum that the file gives, if it does: a temperature takes the place of a
// measured spectrum, and the other way round.
void set(const SpectrumChange& change, TemporalNumber& temperature, EmissionSpectrum& spectrum);

// [render]'s `observe`.
void read_observe(TableReader& render, RenderSettings& settings);

}  // namespace restframe
