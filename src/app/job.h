#pragma once

#include <filesystem>
#include <vector>

#include "app/options.h"
#include "app/picture_files.h"
#include "scene/scene.h"

namespace restframe {

// A scene as it was asked for, and which of its pictures. A picture is the same to the byte, and has the
// same name where that has a number, whatever pictures are asked for with it.
struct Job {
  Scene scene;
  std::vector<int> numbers;  // in order, at least one

  PictureFiles files(int number) const;
  std::filesystem::path path(int number) const { return files(number).whole; }
};

// Throws InputError.
Job loaded_job(const RenderOptions& options, const ImportLimits& limits);

// The closing line: of the job's pictures, so many were made now.
void print_result(const Job& job, std::size_t made);

}  // namespace restframe
