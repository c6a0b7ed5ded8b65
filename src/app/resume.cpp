#include "app/resume.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "app/part_files.h"
#include "app/previews.h"
#include "app/signals.h"
#include "film/exr_check.h"
#include "film/exr_decoding.h"
#include "film/png_preview.h"
#include "scene/atomic_file.h"
#include "scene/error.h"
#include "scene/file_names.h"
#include "scene/parallel.h"
#include "scene/temporary_files.h"

namespace restframe {

namespace fs = std::filesystem;

namespace {

// Somebody may have worked on it.
FoundPicture changed(const fs::path& image) {
  return {Found::changed,
          "its bytes are not as restframe wrote them: another program's, or changed", image};
}

std::string refusal(const FoundPicture& picture) {
  const std::string reason =
      picture.found == Found::another
          ? fmt::format("was made from another scene ({})", picture.difference)
          : picture.difference;
  return fmt::format("{}: {}; --overwrite replaces it", picture.path.string(), reason);
}

}  // namespace

FoundPicture find_picture(const PictureFiles& files, int number, const Provenance& now,
                          const OutputSettings& settings, bool with_preview) {
  bool all_there = true;
  for (const LayerFile& image : files.images) {
    const std::optional<WrittenPicture> written = written_picture(image.path);
    all_there = all_there && written;
    if (!written && decodes(image.path)) return changed(image.path);
    if (!written) continue;
    const std::string differs = difference(provenance_in(written->texts), now);
    if (!differs.empty()) return {Found::another, differs, image.path};
    if (written->number != number) {
      return {Found::another, fmt::format("it is picture {}, not {}", written->number, number),
              image.path};
    }
  }
  if (!all_there) return {};
  const bool shown =
      !with_preview || is_whole_png(files.preview, preview_label(now, number, settings));
  return {shown ? Found::finished : Found::finished_without_preview, {}, {}};
}

std::vector<FoundPicture> find_pictures(const Job& job) {
  const Provenance now = provenance_of(job.scene);
  const bool with_previews = has_previews(job.scene);
  std::vector<FoundPicture> found(job.numbers.size());
  parallel_for(found.size(), [&](std::size_t i) {
    if (interrupt_requested()) throw Interrupted();
    const int number = job.numbers[i];
    found[i] = find_picture(job.files(number), number, now, job.scene.output, with_previews);
  });
  return found;
}

ToMake what_to_make(const Job& job, bool overwrite) {
  if (overwrite) return {job.numbers, {}};
  const std::vector<FoundPicture> found = find_pictures(job);
  ToMake to_make;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i].found == Found::nothing_of_use) {
      to_make.pictures.push_back(job.numbers[i]);
    } else if (found[i].found == Found::finished_without_preview) {
      to_make.previews.push_back(job.numbers[i]);
    } else if (found[i].found != Found::finished) {
      throw InputError(refusal(found[i]));
    }
  }
  return to_make;
}

void remove_leftovers(const Job& job, const std::vector<int>& to_make) {
  const Provenance provenance = provenance_of(job.scene);
  std::set<fs::path> folders;
  std::error_code ignored;
  for (const int number : job.numbers) {
    const fs::path picture = job.path(number);
    if (folders.insert(folder_of(picture)).second) remove_orphans(folder_of(picture));
    if (std::binary_search(to_make.begin(), to_make.end(), number)) continue;
    const fs::path checkpoint = checkpoint_path(picture);
    const auto part = part_summary(checkpoint);
    if (part && difference(part->info, part_info(provenance, number)).empty()) {
      fs::remove(checkpoint, ignored);
    }
  }
}

void prepare_folders(const Job& job, const std::vector<int>& numbers) {
  std::set<fs::path> folders;
  for (const int number : numbers) {
    const fs::path path = job.path(number);
    if (!folders.insert(folder_of(path)).second) continue;
    const AtomicFile never_committed(path);
  }
}

}  // namespace restframe
