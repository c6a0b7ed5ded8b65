// Environments from OpenEXR files. Its reader has a history: what the header says is checked before,
// sizes are limited, and it reads from memory, on this thread alone.

#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "importers/exr_check.h"
#include "importers/importers.h"
#include "scene/error.h"
#include "scene/message.h"

namespace restframe {
namespace {

using ByteSpan = std::span<const std::uint8_t>;

// Attributes that nothing needs have types that OpenEXR does not know, so it passes them over.
class MemoryStream : public Imf::IStream {
 public:
  MemoryStream(ByteSpan bytes, const ExrHeader& header)
      : IStream("memory"), bytes_(bytes), header_(header) {}

  bool read(char to[], int count) override {
    const std::size_t left = position_ < bytes_.size() ? bytes_.size() - position_ : 0;
    if (count < 0 || static_cast<std::size_t>(count) > left) {
      throw std::runtime_error("the file ends early");
    }
    std::memcpy(to, bytes_.data() + position_, static_cast<std::size_t>(count));
    hide_types(to, static_cast<std::size_t>(count));
    position_ += static_cast<std::size_t>(count);
    return position_ < bytes_.size();
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }
  void clear() override {}

 private:
  void hide_types(char to[], std::size_t count) const {
    if (header_.needless_types.empty()) return;
    const auto& [last, last_length] = header_.needless_types.back();
    if (position_ >= last + last_length) return;
    for (const auto& [begin, length] : header_.needless_types) {
      for (std::size_t i = begin; i < begin + length; ++i) {
        if (i >= position_ && i < position_ + count) to[i - position_] = 'x';
      }
    }
  }

  ByteSpan bytes_;
  const ExrHeader& header_;
  std::uint64_t position_ = 0;
};

const ExrChannel* find_channel(const ExrHeader& header, const std::string& name) {
  const auto found = std::find_if(header.channels.begin(), header.channels.end(),
                                  [&](const ExrChannel& c) { return c.name == name; });
  return found == header.channels.end() ? nullptr : &*found;
}

// Red, green and blue; or three times the luminance.
std::array<const char*, 3> colour_channels(const ExrHeader& header, const std::string& what) {
  std::array<const char*, 3> names = {"R", "G", "B"};
  const auto is_there = [&](const char* name) { return find_channel(header, name) != nullptr; };
  if (std::none_of(names.begin(), names.end(), is_there) && is_there("Y")) names.fill("Y");
  for (const char* name : names) {
    const ExrChannel* channel = find_channel(header, name);
    if (!channel) throw InputError(what + ": EXR has no channel " + name + ", needs R, G, B or Y");
    if (channel->x_sampling == 1 && channel->y_sampling == 1) continue;
    throw InputError(what + ": EXR has the subsampled channel " + name);
  }
  return names;
}

// OpenEXR holds a block of lines of all channels, compressed and not.
void check_size(const ExrHeader& header, const std::string& what, const ImportLimits& limits) {
  constexpr std::size_t lines_of_block = 256;  // at most
  const auto width = static_cast<std::size_t>(header.data.width());
  const auto height = static_cast<std::size_t>(header.data.height());
  if (width > limits.image_pixels / height) {
    throw InputError(
        fmt::format("{}: EXR of {} x {} pixels, the limit is {}; --max-image-pixels "
                    "raises it",
                    what, width, height, limits.image_pixels));
  }
  const std::size_t block = 4 * width * std::min(height, lines_of_block) * header.channels.size();
  const std::size_t bytes = width * height * sizeof(Vec3f) + 2 * block;
  if (bytes <= limits.total_bytes) return;
  throw InputError(
      fmt::format("{}: EXR that needs {} bytes of memory, the limit is {}; --max-bytes "
                  "raises it",
                  what, bytes, limits.total_bytes));
}

void check_header(const ExrHeader& header, const std::string& what, const ImportLimits& limits,
                  Warnings& warnings) {
  check_size(header, what, limits);
  if (header.data != header.display) {
    throw InputError(what +
                     ": EXR whose data window is not its display window, must be a whole "
                     "picture");
  }
  constexpr std::array rec_709 = {0.64F, 0.33F, 0.3F, 0.6F, 0.15F, 0.06F, 0.3127F, 0.329F};
  for (std::size_t i = 0; i < header.chromaticities.size(); ++i) {
    if (std::abs(header.chromaticities[i] - rec_709[i]) < 2e-3F) continue;
    warnings.push_back(what +
                       ": the EXR's chromaticities are not those of Rec. 709; its colours "
                       "are taken for such");
    return;
  }
}

void read_pixels(ByteSpan bytes, const ExrHeader& header, const std::array<const char*, 3>& names,
                 SkyMap& map) {
  MemoryStream stream(bytes, header);
  Imf::InputFile file(stream, 0);
  const Imath::Box2i window = file.header().dataWindow();
  Imf::FrameBuffer buffer;
  const std::size_t row = sizeof(Vec3f) * static_cast<std::size_t>(map.width);
  // A name that is there three times is read once.
  for (std::size_t i = 0; i < 3 && (i == 0 || names[i] != names[0]); ++i) {
    buffer.insert(names[i], Imf::Slice::Make(Imf::FLOAT, &map.pixels[0][static_cast<int>(i)],
                                             window, sizeof(Vec3f), row));
  }
  file.setFrameBuffer(buffer);
  file.readPixels(window.min.y, window.max.y);
  if (names[1] != names[0]) return;
  for (Vec3f& pixel : map.pixels) pixel = Vec3f(pixel.x);
}

// Filters leave negative values beside bright pixels; what is not a number is nothing to guess at.
void check_pixels(SkyMap& map, const std::string& what, Warnings& warnings) {
  constexpr float brightest = 1e20F;
  std::size_t negative = 0;
  for (std::size_t i = 0; i < map.pixels.size(); ++i) {
    Vec3f& pixel = map.pixels[i];
    if (!is_within(pixel, brightest)) {
      const auto width = static_cast<std::size_t>(map.width);
      throw InputError(fmt::format("{}: pixel ({}, {}) is [{}, {}, {}], must be from 0 to {}", what,
                                   i % width, i / width, pixel.x, pixel.y, pixel.z, brightest));
    }
    if (pixel.x < 0.0F || pixel.y < 0.0F || pixel.z < 0.0F) ++negative;
    pixel = glm::max(pixel, Vec3f(0));
  }
  if (negative == 0) return;
  warnings.push_back(fmt::format("{}: {} pixels are negative, taken for 0", what, negative));
}

}  // namespace

SkyMap decode_sky_map(ByteSpan bytes, const std::string& what, const ImportLimits& limits,
                      Warnings& warnings) {
  const ExrHeader header = read_exr_header(bytes, what);
  const std::array<const char*, 3> names = colour_channels(header, what);
  check_header(header, what, limits, warnings);
  SkyMap map;
  map.name = what;
  map.width = static_cast<int>(header.data.width());
  map.height = static_cast<int>(header.data.height());
  map.pixels.resize(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height));
  try {
    read_pixels(bytes, header, names, map);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError(on_one_line(what + ": EXR can not be read: " + error.what()));
  }
  check_pixels(map, what, warnings);
  return map;
}

}  // namespace restframe
