#pragma once

#include <vector>

#include "app/job.h"
#include "app/provenance.h"
#include "film/preview.h"

namespace restframe {

// Whether a PNG goes beside each picture.
bool has_previews(const Scene& scene);

// Says which picture of what provenance a PNG shows, and how.
std::string preview_label(const Provenance& provenance, int number, const OutputSettings& settings);

// Makes the previews of finished pictures from their EXRs. Throws OutputError and Interrupted.
void develop_previews(const Job& job, const std::vector<int>& numbers);

}  // namespace restframe
