#include "app/picture_writer.h"

#include "film/png_preview.h"

namespace restframe {
namespace {

struct PictureToWrite {
  PictureFiles files;
  std::span<const Picture> views;
  PictureInfo info;
  bool preview = false;
  Development development;
};

WriteReport write_images(PictureToWrite& picture) {
  WriteReport report;
  for (const LayerFile& image : picture.files.images) {
    picture.info.only_layer = image.layer;
    report += write_exr(image.path, picture.views, picture.info);
  }
  return report;
}

WriteReport write_all(PictureToWrite picture) {
  const bool preview = picture.preview && picture.views.front().has_beauty();
  // The preview first: where the last EXR is, all of the picture is. Neither without the other.
  if (preview) write_png(picture.files.preview, picture.views.front(), picture.development);
  try {
    return write_images(picture);
  } catch (...) {
    std::error_code ignored;
    if (preview) std::filesystem::remove(picture.files.preview, ignored);
    throw;
  }
}

}  // namespace

PictureWriter::~PictureWriter() {
  if (pending_.valid()) pending_.wait();
}

void PictureWriter::write(PictureFiles files, std::span<const Picture> views, PictureInfo info) {
  finish();
  pending_ =
      std::async(std::launch::async, write_all,
                 PictureToWrite{std::move(files), views, std::move(info), preview_, development_});
}

void PictureWriter::finish() {
  if (pending_.valid()) report_ += pending_.get();
}

}  // namespace restframe
