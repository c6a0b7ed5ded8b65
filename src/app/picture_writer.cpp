#include "app/picture_writer.h"

#include "film/png_preview.h"

namespace restframe {

PictureWriter::~PictureWriter() {
  if (pending_.valid()) pending_.wait();
}

void PictureWriter::write(std::filesystem::path path, const Picture& picture, PictureInfo info) {
  finish();
  pending_ =
      std::async(std::launch::async, [preview = preview_, development = development_,
                                      path = std::move(path), &picture, info = std::move(info)] {
        const auto png = std::filesystem::path(path).replace_extension(".png");
        // The preview first: where the EXR is, all of the picture is. Neither without the other.
        if (preview && picture.has_beauty()) write_png(png, picture, development);
        try {
          return write_exr(path, picture, info);
        } catch (...) {
          std::error_code ignored;
          if (preview) std::filesystem::remove(png, ignored);
          throw;
        }
      });
}

void PictureWriter::finish() {
  if (pending_.valid()) clamped_ += pending_.get().clamped;
}

}  // namespace restframe
