#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace restframe {

// A picture as tests look at it.
struct ExrPicture {
  int width = 0, height = 0;                           // of the data window
  std::map<std::string, std::vector<float>> channels;  // rows from the top, left to right
  std::map<std::string, std::string> types;            // of the channels: "half", "float"
  // Header attributes as text: numbers in their shortest exact form, vectors and matrices as
  // numbers between spaces, lists of strings a line each, compression by its name (as in the scene
  // file). Attributes of other types read "(TYPE)".
  std::map<std::string, std::string> attributes;

  // Throws std::runtime_error naming the channels there are if there is no such one.
  const std::vector<float>& channel(const std::string& name) const;
  float at(const std::string& name, int x, int y) const;
};

// What must be added to the proper and to the world times.
std::pair<double, double> time_origins(const ExrPicture& picture);

// Half and integer channels are converted. Throws std::runtime_error if the file cannot be read,
// lacks parts of the picture, or has several parts.
ExrPicture read_exr(const std::filesystem::path& file);

// Likewise, of a file of any number of parts.
std::vector<ExrPicture> read_exr_parts(const std::filesystem::path& file);

}  // namespace restframe
