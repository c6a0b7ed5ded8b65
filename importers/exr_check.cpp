// The layout is that of "OpenEXR File Layout" (openexr.com): a magic number, a version with flags,
// attributes (name, type, size, value) up to an empty name.

#include "importers/exr_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <map>
#include <string_view>

#include "scene/error.h"
#include "scene/message.h"

namespace restframe {
namespace {

constexpr std::size_t longest_name = 255;
constexpr std::size_t most_channels = 128, most_attributes = 1000;

class HeaderBytes {
 public:
  HeaderBytes(std::span<const std::uint8_t> bytes, const std::string& what)
      : bytes_(bytes), what_(what) {}

  [[noreturn]] void fail(const std::string& reason) const {
    throw InputError(on_one_line(what_ + ": EXR " + reason));
  }

  std::size_t position() const { return position_; }
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
  if (!value.at_end()) value.fail("has a list of channels of another length than it says");
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

// The value of one attribute, of those that pictures need.
struct Value {
  HeaderBytes bytes;
  std::string type;
  std::size_t size;
};

// Those that OpenEXR needs, with what they must be; size 0: any.
struct Needed {
  const char *name, *type;
  std::size_t size;
};
constexpr std::array needed_attributes = {
    Needed{"channels", "chlist", 0},        Needed{"compression", "compression", 1},
    Needed{"dataWindow", "box2i", 16},      Needed{"displayWindow", "box2i", 16},
    Needed{"lineOrder", "lineOrder", 1},    Needed{"pixelAspectRatio", "float", 4},
    Needed{"screenWindowCenter", "v2f", 8}, Needed{"screenWindowWidth", "float", 4},
};

std::map<std::string, Value> read_attributes(HeaderBytes& file, const std::string& what,
                                             ExrHeader& header) {
  std::map<std::string, Value> attributes;
  for (std::string name = file.name(); !name.empty(); name = file.name()) {
    const std::size_t type_at = file.position();
    std::string type = file.name();
    const auto size = file.number<std::int32_t>();
    if (size < 0) file.fail("has an attribute of a negative size");
    if (attributes.size() == most_attributes) {
      file.fail(fmt::format("has more than {} attributes, the limit", most_attributes));
    }
    const HeaderBytes value(file.take(static_cast<std::size_t>(size)), what);
    const bool is_needed = std::any_of(needed_attributes.begin(), needed_attributes.end(),
                                       [&](const Needed& needed) { return needed.name == name; });
    if (!is_needed) header.needless_types.emplace_back(type_at, type.size());
    const auto length = static_cast<std::size_t>(size);
    if (!attributes.emplace(std::move(name), Value{value, std::move(type), length}).second) {
      file.fail("has two attributes of one name");
    }
  }
  return attributes;
}

}  // namespace

ExrHeader read_exr_header(std::span<const std::uint8_t> bytes, const std::string& what) {
  HeaderBytes file(bytes, what);
  check_kind(file);
  ExrHeader header;
  const std::map<std::string, Value> attributes = read_attributes(file, what, header);
  for (const Needed& needed : needed_attributes) {
    const auto found = attributes.find(needed.name);
    if (found == attributes.end()) file.fail(fmt::format("has no attribute {}", needed.name));
    const Value& value = found->second;
    if (value.type != needed.type || (needed.size != 0 && value.size != needed.size)) {
      file.fail(fmt::format("has an attribute {} of a wrong type or size", needed.name));
    }
  }
  header.channels = channels(attributes.at("channels").bytes);
  header.compression = compression(attributes.at("compression").bytes);
  header.data = window(attributes.at("dataWindow").bytes);
  header.display = window(attributes.at("displayWindow").bytes);
  const auto primaries = attributes.find("chromaticities");
  if (primaries != attributes.end()) {
    header.chromaticities = chromaticities(primaries->second.bytes);
  }
  return header;
}

}  // namespace restframe
