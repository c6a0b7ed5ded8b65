#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/job.h"
#include "app/provenance.h"

namespace restframe {

enum class Found {
  nothing_of_use,  // a file is missing, or not as it was written
  finished,
  finished_without_preview,  // it is missing, or of another scene, view or exposure
  another,                   // a whole picture of another scene
  changed,                   // a whole picture, but not as restframe wrote it
};

struct FoundPicture {
  Found found = Found::nothing_of_use;
  std::string difference;      // of another or a changed ...
  std::filesystem::path path;  // ... file
};

// What is there under a picture's name.
FoundPicture find_picture(const PictureFiles& files, int number, const Provenance& now,
                          const OutputSettings& settings, bool with_preview);

// Of each of the job's pictures. Throws Interrupted.
std::vector<FoundPicture> find_pictures(const Job& job);

struct ToMake {
  std::vector<int> pictures;  // with their previews
  std::vector<int> previews;  // of finished pictures
};

// What of the job is not finished. A whole picture of another scene or of another make
// is an InputError that says what differs; `overwrite` makes all again. Throws Interrupted.
ToMake what_to_make(const Job& job, bool overwrite);

// Clears away what killed processes left beside the job's pictures, of which these are to be made: files
// that were being written, and checkpoints of pictures that are finished.
void remove_leftovers(const Job& job, const std::vector<int>& to_make);

// Makes the folders of these pictures. Throws OutputError where no file can be made: better now than
// after hours.
void prepare_folders(const Job& job, const std::vector<int>& numbers);

}  // namespace restframe
