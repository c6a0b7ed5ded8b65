#include "film/part_file.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <string_view>

#include "film/byte_sum.h"
#include "scene/atomic_file.h"

// A part file is, one after the other, numbers in the machine's byte order, texts with their length:
//
//   first_line, the picture's number, how many texts and these as names and values, how many views, and
//   of each view
//     its name, window and number of tiles, 1 if it has a beauty, how many other planes and their names
//     and kinds, how many tiles follow, and of each of these
//       which one it is, its window, and its pixels, row by row: in each row plane by plane
//   and the ByteSum of all this.

namespace restframe {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view first_line = "restframe part 1\n";

class PartWriter {
 public:
  explicit PartWriter(AtomicFile& file) : file_(file) {}

  void bytes(const void* from, std::size_t count) {
    sum_.add(from, count);
    file_.write(std::span(static_cast<const std::byte*>(from), count));
  }
  template <class Number>
  void number(Number value) {
    bytes(&value, sizeof value);
  }
  void count(std::size_t value) { number(static_cast<std::uint64_t>(value)); }
  void text(std::string_view value) {
    count(value.size());
    bytes(value.data(), value.size());
  }
  void window(const PixelWindow& w) { number(std::array{w.left, w.top, w.width, w.height}); }
  void finish() { number(sum_.value()); }

 private:
  AtomicFile& file_;
  ByteSum sum_;
};

struct Torn : std::runtime_error {
  Torn() : std::runtime_error("torn") {}
};

class PartReader {
 public:
  explicit PartReader(const fs::path& path) : file_(path, std::ios::binary) {
    std::error_code error;
    left_ = fs::is_regular_file(path, error) ? fs::file_size(path, error) : 0;
    if (error) throw Torn();
  }

  void bytes(void* to, std::size_t count) {
    if (count > left_) throw Torn();
    file_.read(static_cast<char*>(to), static_cast<std::streamsize>(count));
    if (static_cast<std::size_t>(file_.gcount()) != count) throw Torn();
    left_ -= count;
    sum_.add(to, count);
  }
  template <class Number>
  Number number() {
    Number value{};
    bytes(&value, sizeof value);
    return value;
  }
  // Of things that take at least a byte each.
  std::size_t count() {
    const auto value = number<std::uint64_t>();
    if (value > left_) throw Torn();
    return static_cast<std::size_t>(value);
  }
  std::string text() {
    std::string value(count(), '\0');
    bytes(value.data(), value.size());
    return value;
  }
  PixelWindow window() {
    const auto w = number<std::array<int, 4>>();
    if (w[2] < 0 || w[3] < 0) throw Torn();
    return {w[0], w[1], w[2], w[3]};
  }
  void skip(std::uint64_t count) {
    std::array<char, 1 << 14> piece;
    for (; count > 0; count -= std::min<std::uint64_t>(count, piece.size())) {
      bytes(piece.data(), static_cast<std::size_t>(std::min<std::uint64_t>(count, piece.size())));
    }
  }
  void finish() {
    const std::uint64_t expected = sum_.value();
    if (number<std::uint64_t>() != expected || left_ != 0) throw Torn();
  }

 private:
  std::ifstream file_;
  std::uintmax_t left_ = 0;
  ByteSum sum_;
};

// What a view's pixels are made of.
struct ViewShape {
  std::string name;
  PixelWindow window;
  std::uint64_t tiles = 0;
  bool has_beauty = false;
  std::vector<std::pair<std::string, ChannelKind>> planes;
  bool operator==(const ViewShape&) const = default;

  std::uint64_t pixel_bytes() const {
    std::uint64_t bytes = has_beauty ? sizeof(Vec4f) : 0;
    for (const auto& plane : planes) {
      bytes += plane.second == ChannelKind::plain ? sizeof(float) : sizeof(double);
    }
    return bytes;
  }
};

ViewShape shape_of(const PartView& view) {
  ViewShape shape{
      view.name, view.picture.window(), view.tiles.size(), view.picture.has_beauty(), {}};
  for (const Plane& plane : view.picture.planes())
    shape.planes.emplace_back(plane.name, plane.kind);
  return shape;
}

void write_shape(const ViewShape& shape, PartWriter& to) {
  to.text(shape.name);
  to.window(shape.window);
  to.number(shape.tiles);
  to.number(static_cast<std::uint8_t>(shape.has_beauty));
  to.count(shape.planes.size());
  for (const auto& [name, kind] : shape.planes) {
    to.text(name);
    to.number(kind);
  }
}

ViewShape read_shape(PartReader& from) {
  ViewShape shape;
  shape.name = from.text();
  shape.window = from.window();
  shape.tiles = from.number<std::uint64_t>();
  shape.has_beauty = from.number<std::uint8_t>() != 0;
  const std::size_t planes = from.count();
  for (std::size_t i = 0; i < planes; ++i) {
    std::string name = from.text();
    shape.planes.emplace_back(std::move(name), from.number<ChannelKind>());
  }
  return shape;
}

// Calls `act` with where the rows of a tile are in memory, in the order of the file.
template <class Act>
void for_rows(Picture& picture, const PixelWindow& tile, const Act& act) {
  const auto columns = static_cast<std::size_t>(tile.width);
  const auto row = [&](auto& pixels, std::size_t first) {
    act(pixels.data() + first, columns * sizeof pixels[0]);
  };
  for (int y = tile.top; y < tile.bottom(); ++y) {
    const std::size_t first = picture.index(tile.left, y);
    if (picture.has_beauty()) row(picture.rgba(), first);
    for (Plane& plane : picture.planes()) {
      if (plane.kind == ChannelKind::plain) {
        row(plane.values, first);
      } else {
        row(plane.times, first);
      }
    }
  }
}

bool write_view(const PartView& view, PartWriter& to, const std::atomic<bool>& stop) {
  write_shape(shape_of(view), to);
  const std::vector<std::size_t> done = view.done.marked();
  to.count(done.size());
  for (const std::size_t tile : done) {
    if (stop) return false;
    to.count(tile);
    to.window(view.tiles[tile]);
    for_rows(view.picture, view.tiles[tile],
             [&](const void* row, std::size_t size) { to.bytes(row, size); });
  }
  return true;
}

PartInfo read_info(PartReader& from) {
  std::string line(first_line.size(), '\0');
  from.bytes(line.data(), line.size());
  if (line != first_line) throw Torn();
  PartInfo info;
  info.number = from.number<int>();
  const std::size_t texts = from.count();
  for (std::size_t i = 0; i < texts; ++i) {
    std::string name = from.text();
    info.texts.emplace_back(std::move(name), from.text());
  }
  return info;
}

std::vector<std::size_t> skip_tiles(const ViewShape& shape, PartReader& from) {
  std::vector<std::size_t> done;
  for (std::size_t left = from.count(); left > 0; --left) {
    done.push_back(from.number<std::uint64_t>());
    const PixelWindow window = from.window();
    const auto pixels =
        static_cast<std::uint64_t>(window.width) * static_cast<std::uint64_t>(window.height);
    from.skip(pixels * shape.pixel_bytes());
  }
  return done;
}

std::vector<std::size_t> read_tiles(const PartView& view, PartReader& from) {
  if (read_shape(from) != shape_of(view)) throw Torn();
  std::vector<std::size_t> done;
  for (std::size_t left = from.count(); left > 0; --left) {
    const std::size_t tile = from.number<std::uint64_t>();
    if (tile >= view.tiles.size() || from.window() != view.tiles[tile]) throw Torn();
    for_rows(view.picture, view.tiles[tile],
             [&](void* row, std::size_t size) { from.bytes(row, size); });
    done.push_back(tile);
  }
  return done;
}

}  // namespace

bool write_part(const fs::path& path, const PartInfo& info, std::span<const PartView> views,
                const std::atomic<bool>& stop) {
  AtomicFile file(path);
  PartWriter to(file);
  to.bytes(first_line.data(), first_line.size());
  to.number(info.number);
  to.count(info.texts.size());
  for (const auto& [name, text] : info.texts) {
    to.text(name);
    to.text(text);
  }
  to.count(views.size());
  for (const PartView& view : views) {
    if (!write_view(view, to, stop)) return false;
  }
  to.finish();
  file.commit();
  return true;
}

std::optional<PartSummary> part_summary(const fs::path& path) {
  try {
    PartReader from(path);
    PartSummary summary{read_info(from), {}};
    const std::size_t views = from.count();
    for (std::size_t i = 0; i < views; ++i) {
      summary.done.push_back(skip_tiles(read_shape(from), from));
    }
    from.finish();
    return summary;
  } catch (const Torn&) {
    return std::nullopt;
  }
}

std::optional<PartInfo> read_part(const fs::path& path, std::span<const PartView> views) {
  PartInfo info;
  std::vector<std::vector<std::size_t>> done;
  try {
    PartReader from(path);
    info = read_info(from);
    if (from.count() != views.size()) return std::nullopt;
    for (const PartView& view : views) done.push_back(read_tiles(view, from));
    from.finish();
  } catch (const Torn&) {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < views.size(); ++i) {
    for (const std::size_t tile : done[i]) views[i].done.mark(tile);
  }
  return info;
}

}  // namespace restframe
