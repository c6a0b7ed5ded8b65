#pragma once

#include <filesystem>
#include <future>

#include "film/exr_file.h"
#include "film/view_transform.h"

namespace restframe {

// Writes a picture while the next one renders.
class PictureWriter {
 public:
  explicit PictureWriter(const OutputSettings& settings)
      : preview_(settings.preview), development_(development(settings)) {}
  ~PictureWriter();

  // Waits for the picture before; rethrows what went wrong with it. `picture` must stay as it is until the
  // next call has returned. When it is written, its checkpoint goes.
  void write(std::filesystem::path path, const Picture& picture, PictureInfo info);
  // Waits for the last one.
  void finish();

  // Warns of what is odd about the pictures that were written.
  void report() const;

 private:
  bool preview_;
  Development development_;
  std::future<WriteReport> pending_;
  std::size_t written_ = 0, empty_ = 0, clamped_ = 0;
};

}  // namespace restframe
