#include "app/showing.h"

#include <fmt/format.h>

#include "app/contact_sheet.h"
#include "app/previews.h"
#include "app/video.h"
#include "scene/atomic_file.h"
#include "scene/error.h"
#include "scene/file_names.h"
#include "scene/message.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;

// One spelling for all that lead to the same place, whether there is a file or not.
fs::path resolved(const fs::path& path) {
  return fs::weakly_canonical(fs::absolute(path));
}

void check_sheet(const fs::path& sheet, const Show& show) {
  if (lower_extension(sheet) != ".png") {
    throw InputError(fmt::format("--contact-sheet: {} must end in .png", quote(sheet.string())));
  }
  for (const fs::path& preview : show.previews) {
    if (resolved(sheet) == resolved(preview)) {
      throw InputError(
          fmt::format("--contact-sheet: {} is the preview of a picture; choose another name",
                      quote(sheet.string())));
    }
  }
}

// Throws OutputError if no file can be made there.
void check_writable(const fs::path& path) {
  const AtomicFile never_committed(path);
}

}  // namespace

Show planned_show(const RenderOptions& options, const Job& job) {
  Show show{options, {}, {}};
  if (!wants_show(options)) return show;
  if (!has_previews(job.scene)) {
    throw InputError(
        "--video and --contact-sheet: output.layers lacks \"beauty\", so there is nothing to show");
  }
  for (const int number : job.numbers) {
    show.previews.push_back(job.files(number).preview);
  }
  if (options.contact_sheet) {
    check_sheet(*options.contact_sheet, show);
    check_writable(*options.contact_sheet);
  }
  if (options.video) {
    show.encoder = checked_encoder(*options.video, job.scene.animation.rate);
    check_writable(*options.video);
  }
  return show;
}

void make_show(const Show& show, const Scene& scene) {
  const auto& [options, previews, encoder] = show;
  if (options.contact_sheet) {
    std::vector<fs::path> chosen;
    for (const std::size_t i : evenly_chosen(previews.size(), largest_sheet)) {
      chosen.push_back(previews[i]);
    }
    const PixelWindow window = picture_window(scene.render);
    write_contact_sheet(*options.contact_sheet, chosen, window.width, window.height);
    if (!options.quiet) {
      fmt::print("{}: {} of {} pictures{}\n", *options.contact_sheet, chosen.size(),
                 previews.size(), chosen.size() < previews.size() ? ", evenly chosen" : "");
    }
  }
  if (options.video) {
    write_video(*options.video, previews, scene.animation.rate, encoder);
    if (!options.quiet) {
      fmt::print("{}: {} pictures, {:.6g} a second\n", *options.video, previews.size(),
                 scene.animation.rate);
    }
  }
}

}  // namespace restframe
