#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/job.h"
#include "app/provenance.h"

namespace restframe {

enum class Found {
  nothing_of_use,  // a file is missing, or not as it was written, or the preview is missing
  finished,
  another,  // a whole picture that something else made
};

struct FoundPicture {
  Found found = Found::nothing_of_use;
  std::string difference;      // of another ...
  std::filesystem::path path;  // ... file
};

// What is there under a picture's name.
FoundPicture find_picture(const PictureFiles& files, int number, const Provenance& now,
                          bool with_preview);

// Whether a PNG goes beside each picture.
bool has_previews(const Scene& scene);

// Of each of the job's pictures. Throws Interrupted.
std::vector<FoundPicture> find_pictures(const Job& job);

// Those of the job's pictures that are not finished. A whole picture of another scene is an InputError
// that says what differs; `overwrite` makes all again. Throws Interrupted.
std::vector<int> pictures_to_make(const Job& job, bool overwrite);

// Makes the folders of these pictures and clears away what killed processes left there. Throws OutputError
// where no file can be made: better now than after hours.
void prepare_folders(const Job& job, const std::vector<int>& numbers);

}  // namespace restframe
