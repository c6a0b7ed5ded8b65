#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "app/canvas.h"
#include "app/commands.h"
#include "app/job.h"
#include "app/part_files.h"
#include "app/picture_files.h"
#include "app/picture_writer.h"
#include "app/previews.h"
#include "app/resume.h"
#include "app/showing.h"
#include "app/signals.h"
#include "scene/error.h"
#include "scene/parallel.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;

// The numbers of the parts that are not among these, which are all of so many.
std::vector<int> missing_parts(const std::vector<FoundShare>& shares, int count) {
  std::vector<int> missing;
  for (int part = 1; part <= count; ++part) {
    const auto is_part = [part](const FoundShare& found) { return found.share.part == part; };
    if (std::none_of(shares.begin(), shares.end(), is_part)) missing.push_back(part);
  }
  return missing;
}

std::string missing_text(const std::vector<int>& missing, int count) {
  constexpr std::size_t most = 12;
  const std::vector<int> first(
      missing.begin(),
      missing.begin() + static_cast<std::ptrdiff_t>(std::min(missing.size(), most)));
  return fmt::format(
      "part{} {}{} of {} {} missing", missing.size() == 1 ? "" : "s", fmt::join(first, ", "),
      missing.size() > most ? fmt::format(" and {} more", missing.size() - most) : "", count,
      missing.size() == 1 ? "is" : "are");
}

// All parts of a picture, whether of 8 or of 16. Where some are missing, none, and `fault` says which.
std::vector<FoundShare> all_parts(const fs::path& picture, std::string& fault) {
  std::map<int, std::vector<FoundShare>> of_count;
  for (FoundShare& found : shares_of(picture)) {
    of_count[found.share.count].push_back(std::move(found));
  }
  fault = picture.string() + ": no part of it is there; `restframe render --tile` makes them";
  for (auto& [count, shares] : of_count) {
    const std::vector<int> missing = missing_parts(shares, count);
    if (missing.empty()) return std::move(shares);
    fault = picture.string() + ": " + missing_text(missing, count);
  }
  return {};
}

struct Merge {
  const Job& job;
  Provenance provenance;
  PictureInfo common;
  bool keep;
};

[[noreturn]] void refuse(const FoundShare& found, const PartInfo& now) {
  const auto summary = part_summary(found.path);
  const std::string differs = summary ? difference(summary->info, now) : std::string();
  if (differs.empty()) {
    throw InputError(fmt::format("{}: is damaged; remove it, and render --tile {}/{} again",
                                 found.path.string(), found.share.part, found.share.count));
  }
  throw InputError(
      fmt::format("{}: was made from another scene ({})", found.path.string(), differs));
}

void add_part(const FoundShare& found, const PartInfo& now, Canvas& canvas) {
  const auto info = read_part(found.path, canvas.views());
  if (!info || !difference(*info, now).empty()) refuse(found, now);
  const std::vector<std::size_t> tiles = tiles_of(found.share, canvas.tiles.size());
  const std::size_t all = tiles.size() * canvas.done.size();
  std::ptrdiff_t done = 0;
  for (const TileMarks& marks : canvas.done) {
    done += std::count_if(tiles.begin(), tiles.end(),
                          [&](std::size_t tile) { return marks.is_marked(tile); });
  }
  if (static_cast<std::size_t>(done) == all) return;
  throw InputError(
      fmt::format("{}: is not finished, {} of {} tiles are there; render --tile {}/{} "
                  "goes on with it",
                  found.path.string(), done, all, found.share.part, found.share.count));
}

void merge_picture(const Merge& merge, int number, const std::vector<FoundShare>& parts,
                   Canvas& canvas, PictureWriter& writer) {
  const Job& job = merge.job;
  const PartInfo now = part_info(merge.provenance, number);
  canvas.clear();
  for (const FoundShare& found : parts) {
    if (interrupt_requested()) throw Interrupted();
    add_part(found, now, canvas);
  }
  writer.write(job.files(number), canvas.pictures, picture_info(merge.common, job.scene, number));
  writer.finish();
  if (merge.keep) return;
  std::error_code ignored;
  for (const FoundShare& found : parts) fs::remove(found.path, ignored);
}

// What a merge left that was interrupted when its picture was there.
void remove_merged_parts(const Merge& merge, const std::vector<int>& to_make) {
  if (merge.keep) return;
  std::error_code ignored;
  for (const int number : merge.job.numbers) {
    if (std::binary_search(to_make.begin(), to_make.end(), number)) continue;
    const PartInfo now = part_info(merge.provenance, number);
    for (const FoundShare& found : shares_of(merge.job.path(number))) {
      const auto part = part_summary(found.path);
      if (part && difference(part->info, now).empty()) fs::remove(found.path, ignored);
    }
  }
}

// Before any picture is written: of all of them, or an InputError that says what is missing.
std::vector<std::vector<FoundShare>> parts_of_all(const Job& job, const std::vector<int>& numbers) {
  std::vector<std::vector<FoundShare>> parts;
  std::vector<std::string> faults;
  for (const int number : numbers) {
    std::string fault;
    parts.push_back(all_parts(job.path(number), fault));
    if (parts.back().empty()) faults.push_back(fault);
  }
  if (faults.size() > 1) {
    faults.front() += fmt::format("; and so for {} pictures more", faults.size() - 1);
  }
  if (!faults.empty()) throw InputError(faults.front());
  return parts;
}

}  // namespace

int merge(const MergeOptions& options, const ImportLimits& limits) {
  set_thread_count(options.render.threads);
  const Job job = loaded_job(options.render, limits);
  const auto [numbers, previews] = what_to_make(job, options.render.overwrite);
  remove_leftovers(job, numbers);
  const Show show = planned_show(options.render, job);
  const Merge merge{job, provenance_of(job.scene), common_info(job.scene), options.keep};
  const auto parts = parts_of_all(job, numbers);
  prepare_folders(job, numbers);
  develop_previews(job, previews);
  Canvas canvas(job.scene);
  PictureWriter writer(job.scene.output);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    merge_picture(merge, numbers[i], parts[i], canvas, writer);
  }
  remove_merged_parts(merge, numbers);
  writer.report();
  if (!options.render.quiet) print_result(job, numbers.size());
  make_show(show, job.scene);
  return 0;
}

}  // namespace restframe
