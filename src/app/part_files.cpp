#include "app/part_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>

#include "app/render_picture.h"
#include "app/signals.h"
#include "scene/error.h"
#include "scene/file_names.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;

// Reads a number and what follows it.
bool read_number(std::string_view& text, std::string_view after, int& number) {
  const auto [stop, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (fault != std::errc{}) return false;
  text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
  if (!text.starts_with(after)) return false;
  text.remove_prefix(after.size());
  return true;
}

// Throws InputError if the part file belongs to another picture.
std::optional<PartSummary> checked_summary(const fs::path& path, const PartInfo& now) {
  auto part = part_summary(path);
  const std::string differs = part ? difference(part->info, now) : std::string();
  if (differs.empty()) return part;
  throw InputError(fmt::format("{}: was made from another scene ({}); --overwrite replaces it",
                               path.string(), differs));
}

bool is_finished(const PartSummary& part, const std::vector<std::size_t>& tiles) {
  return std::all_of(part.done.begin(), part.done.end(), [&](std::vector<std::size_t> done) {
    std::sort(done.begin(), done.end());
    return std::includes(done.begin(), done.end(), tiles.begin(), tiles.end());
  });
}

}  // namespace

fs::path checkpoint_path(const fs::path& picture) {
  return picture.string() + ".part";
}

fs::path share_path(const fs::path& picture, const TileShare& share) {
  const std::size_t digits = std::max<std::size_t>(2, std::to_string(share.count).size());
  return fmt::format("{}.part-{:0{}}-of-{}", picture.string(), share.part, digits, share.count);
}

std::vector<FoundShare> shares_of(const fs::path& picture) {
  const std::string start = picture.filename().string() + ".part-";
  std::vector<FoundShare> found;
  std::error_code error;
  for (fs::directory_iterator entry(folder_of(picture), error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!name.starts_with(start)) continue;
    std::string_view rest = std::string_view(name).substr(start.size());
    TileShare share;
    if (!read_number(rest, "-of-", share.part) || !read_number(rest, "", share.count)) continue;
    const fs::path path = share_path(picture, share);
    if (is_share(share) && path.filename() == name) found.push_back({path, share});
  }
  return found;
}

std::vector<std::size_t> tiles_of(const TileShare& share, std::size_t tiles) {
  std::vector<std::size_t> chosen;
  const auto step = static_cast<std::size_t>(share.count);
  for (auto tile = static_cast<std::size_t>(share.part - 1); tile < tiles; tile += step) {
    chosen.push_back(tile);
  }
  return chosen;
}

PartInfo part_info(const Provenance& provenance, int number) {
  return {number, texts_of(provenance)};
}

std::string difference(const PartInfo& before, const PartInfo& now) {
  const Provenance then = provenance_in(before.texts);
  const Provenance today = provenance_in(now.texts);
  std::string differs = difference(then, today);
  if (!differs.empty()) return differs;
  if (before.number != now.number) {
    return fmt::format("it is of picture {}, not {}", before.number, now.number);
  }
  // Within one picture, every repair of the program counts.
  return then.program == today.program ? "" : "by another version of restframe";
}

std::vector<int> pictures_with_tiles_to_make(const Job& job, const std::vector<int>& numbers,
                                             const std::optional<TileShare>& share) {
  const Provenance provenance = provenance_of(job.scene);
  const std::size_t tiles = picture_tiles(blank_picture(job.scene).window()).size();
  std::vector<int> to_make;
  for (const int number : numbers) {
    if (interrupt_requested()) throw Interrupted();
    const PartInfo now = part_info(provenance, number);
    const fs::path whole = share ? share_path(job.path(number), *share) : job.path(number);
    checked_summary(checkpoint_path(whole), now);
    const auto part = share ? checked_summary(whole, now) : std::nullopt;
    if (!part || !is_finished(*part, tiles_of(*share, tiles))) to_make.push_back(number);
  }
  return to_make;
}

}  // namespace restframe
