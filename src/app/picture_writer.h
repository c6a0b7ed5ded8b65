#pragma once

#include <filesystem>
#include <future>

#include "app/picture_files.h"

namespace restframe {

// Writes a picture while the next one renders.
class PictureWriter {
 public:
  explicit PictureWriter(const OutputSettings& settings) : settings_(settings) {}
  ~PictureWriter();

  // Waits for the picture before; rethrows what went wrong with it. `views`, one an eye, must stay as they
  // are until the next call has returned. When it is written, its checkpoint goes.
  void write(PictureFiles files, std::span<const Picture> views, PictureInfo info);
  // Waits for the last one.
  void finish();

  // Warns of what is odd about the pictures that were written.
  void report() const;

 private:
  OutputSettings settings_;
  std::future<WriteReport> pending_;
  WriteReport report_;
  std::size_t written_ = 0, empty_ = 0;
};

}  // namespace restframe
