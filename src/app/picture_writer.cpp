#include "app/picture_writer.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/messages.h"
#include "app/part_files.h"
#include "app/previews.h"

namespace restframe {
namespace {

struct PictureToWrite {
  PictureFiles files;
  std::span<const Picture> views;
  PictureInfo info;
  OutputSettings settings;
};

WriteReport write_images(const PictureToWrite& picture) {
  WriteReport report;
  PictureInfo info = picture.info;
  for (const LayerFile& image : picture.files.images) {
    info.only_layer = image.layer;
    report += write_exr(image.path, picture.views, info);
  }
  return report;
}

void write_preview_of(const PictureToWrite& picture) {
  const PictureInfo& info = picture.info;
  const std::string label = preview_label(provenance_in(info.texts), info.number, picture.settings);
  write_preview(picture.files.preview, picture.views.front(),
                {development(picture.settings), info.float_beauty, label});
}

WriteReport write_all(const PictureToWrite& picture) {
  // At the same time, so that the last picture takes no longer than it must. Whichever is there without
  // the other: a preview counts for nothing, and is made anew from its EXR.
  std::future<void> preview;
  if (picture.settings.preview && picture.views.front().has_beauty()) {
    preview = std::async(std::launch::async, [&picture] { write_preview_of(picture); });
  }
  const WriteReport report = write_images(picture);
  if (preview.valid()) preview.get();
  std::error_code ignored;
  std::filesystem::remove(checkpoint_path(picture.files.whole), ignored);
  return report;
}

}  // namespace

PictureWriter::~PictureWriter() {
  if (pending_.valid()) pending_.wait();
}

void PictureWriter::write(PictureFiles files, std::span<const Picture> views, PictureInfo info) {
  finish();
  ++written_;
  if (std::all_of(views.begin(), views.end(), [](const Picture& p) { return p.shows_nothing(); })) {
    ++empty_;
  }
  pending_ = std::async(std::launch::async, write_all,
                        PictureToWrite{std::move(files), views, std::move(info), settings_});
}

void PictureWriter::finish() {
  if (pending_.valid()) report_ += pending_.get();
}

void PictureWriter::report() const {
  if (empty_ > 0) {
    report_warning(
        fmt::format("{} of {} pictures show nothing: the camera meets no object there, as it "
                    "sees them",
                    empty_, written_));
  }
  if (report_.clamped > 0) {
    report_warning(
        fmt::format("{} values of the beauty were not finite or beyond what the file "
                    "holds, and were clamped",
                    report_.clamped));
  }
  if (report_.clamped_data > 0) {
    report_warning(
        fmt::format("{} values of other layers were beyond what half holds, and were clamped; "
                    "output.half names these layers",
                    report_.clamped_data));
  }
}

}  // namespace restframe
