#include "app/picture_writer.h"

#include <fmt/format.h>

#include "app/messages.h"
#include "app/part_files.h"
#include "film/png_preview.h"

namespace restframe {

PictureWriter::~PictureWriter() {
  if (pending_.valid()) pending_.wait();
}

void PictureWriter::write(std::filesystem::path path, const Picture& picture, PictureInfo info) {
  finish();
  ++written_;
  if (picture.shows_nothing()) ++empty_;
  pending_ =
      std::async(std::launch::async, [preview = preview_, development = development_,
                                      path = std::move(path), &picture, info = std::move(info)] {
        const auto png = std::filesystem::path(path).replace_extension(".png");
        // The preview first: where the EXR is, all of the picture is. Neither without the other.
        if (preview && picture.has_beauty()) write_png(png, picture, development);
        std::error_code ignored;
        try {
          const WriteReport report = write_exr(path, picture, info);
          std::filesystem::remove(checkpoint_path(path), ignored);
          return report;
        } catch (...) {
          if (preview) std::filesystem::remove(png, ignored);
          throw;
        }
      });
}

void PictureWriter::finish() {
  if (pending_.valid()) clamped_ += pending_.get().clamped;
}

void PictureWriter::report() const {
  if (empty_ > 0) {
    report_warning(
        fmt::format("{} of {} pictures show nothing: the camera meets no object there, as it "
                    "sees them",
                    empty_, written_));
  }
  if (clamped_ > 0) {
    report_warning(
        fmt::format("{} values of the beauty were not finite or beyond what the file "
                    "holds, and were clamped",
                    clamped_));
  }
}

}  // namespace restframe
