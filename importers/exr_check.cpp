// The layout is that of "OpenEXR File Layout" (openexr.com): a magic number, a version with flags,
// attributes (name, type, size, value) up to an empty name.

#include "importers/exr_check.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <map>
#include <string_view>

#include "scene/error.h"
#include "scene/message.h"

namespace restframe {
namespace {

constexpr std::size_t longest_name = 255;
constexpr std::size_t most_channels = 128;

class HeaderBytes {
 public:
  HeaderBytes(std::span<const std::uint8_t> bytes, const std::string& what)
      : bytes_(bytes), what_(what) {}

  [[noreturn]] void fail(const std::string& reason) const {
    throw InputError(on_one_line(what_ + ": EXR " + reason));
  }

  bool at_end() const { return position_ == bytes_.size(); }

  std::span<const std::uint8_t> take(std::size_t count) {
    if (count > bytes_.size() - position_) fail("ends within its header");
    const auto taken = bytes_.subspan(position_, count);
    position_ += count;
    return taken;
  }

  template <class Number>
  Number number() {
    static_assert(std::endian::native == std::endian::little);
    Number value;
    std::memcpy(&value, take(sizeof(Number)).data(), sizeof(Number));
    return value;
  }

  // Up to a zero byte.
  std::string name() {
    std::string name;
    for (std::uint8_t c = number<std::uint8_t>(); c != 0; c = number<std::uint8_t>()) {
      name += static_cast<char>(c);
      if (name.size() > longest_name) fail("has a name of more than 255 bytes");
    }
    return name;
  }

 private:
  std::span<const std::uint8_t> bytes_;
  const std::string& what_;
  std::size_t position_ = 0;
};

void check_kind(HeaderBytes& file) {
  constexpr std::uint32_t magic = 20000630;
  if (file.number<std::uint32_t>() != magic) file.fail("file expected, this is none");
  const auto version = file.number<std::uint32_t>();
  if ((version & 0xffU) != 2) {
    file.fail(fmt::format("is of version {}, must be 2", version & 0xffU));
  }
  const std::array<std::pair<std::uint32_t, const char*>, 3> kinds{
      {{0x1000, "of many parts"}, {0x800, "of deep pixels"}, {0x200, "in tiles"}}};
  for (const auto& [flag, kind] : kinds) {
    if ((version & flag) == 0) continue;
    file.fail(fmt::format("is {}, must be one plain picture in scan lines", kind));
  }
  if ((version & ~std::uint32_t{0x4ff}) != 0) file.fail("has unknown flags in its version");
}

ExrWindow window(HeaderBytes value) {
  constexpr std::int64_t farthest = 1 << 24;
  ExrWindow w;
  for (std::int32_t* edge : {&w.min_x, &w.min_y, &w.max_x, &w.max_y}) {
    *edge = value.number<std::int32_t>();
    if (*edge < -farthest || *edge > farthest) {
      value.fail(fmt::format("has a window with an edge at {}, the limit is {}", *edge, farthest));
    }
  }
  if (w.width() < 1 || w.height() < 1) value.fail("has an empty window");
  return w;
}

std::vector<ExrChannel> channels(HeaderBytes value) {
  std::vector<ExrChannel> channels;
  for (std::string name = value.name(); !name.empty(); name = value.name()) {
    if (channels.size() == most_channels) {
      value.fail(fmt::format("has more than {} channels, the limit", most_channels));
    }
    ExrChannel channel;
    channel.name = std::move(name);
    channel.type = value.number<std::int32_t>();
    value.number<std::uint32_t>();  // a hint to lossy compression
    channel.x_sampling = value.number<std::int32_t>();
    channel.y_sampling = value.number<std::int32_t>();
    if (channel.type < 0 || channel.type > 2) value.fail("has a channel of an unknown type");
    if (channel.x_sampling < 1 || channel.y_sampling < 1) {
      value.fail("has a channel of an impossible sampling");
    }
    channels.push_back(std::move(channel));
  }
  return channels;
}

int compression(HeaderBytes value) {
  const int kind = value.number<std::uint8_t>();
  if (kind == 6 || kind == 7) value.fail("is compressed as B44, use ZIP, PIZ or another kind");
  if (kind > 9) value.fail(fmt::format("is compressed in the unknown way {}", kind));
  return kind;
}

std::vector<float> chromaticities(HeaderBytes value) {
  std::vector<float> all(8);
  for (float& one : all) one = value.number<float>();
  return all;
}

}  // namespace

ExrHeader read_exr_header(std::span<const std::uint8_t> bytes, const std::string& what) {
  HeaderBytes file(bytes, what);
  check_kind(file);
  std::map<std::string, HeaderBytes> attributes;
  for (std::string name = file.name(); !name.empty(); name = file.name()) {
    file.name();  // its type
    const auto size = file.number<std::int32_t>();
    if (size < 0) file.fail("has an attribute of a negative size");
    const HeaderBytes value(file.take(static_cast<std::size_t>(size)), what);
    if (!attributes.emplace(name, value).second) file.fail("has two attributes of one name");
  }
  for (const char* needed : {"channels", "compression", "dataWindow", "displayWindow"}) {
    if (!attributes.contains(needed)) file.fail(fmt::format("has no attribute {}", needed));
  }
  ExrHeader header;
  header.channels = channels(attributes.at("channels"));
  header.compression = compression(attributes.at("compression"));
  header.data = window(attributes.at("dataWindow"));
  header.display = window(attributes.at("displayWindow"));
  const auto primaries = attributes.find("chromaticities");
  if (primaries != attributes.end()) header.chromaticities = chromaticities(primaries->second);
  return header;
}

}  // namespace restframe
