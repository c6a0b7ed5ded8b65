#include "film/preview.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>

#include <array>
#include <stdexcept>

#include "film/png_preview.h"
#include "film/srgb_bytes.h"
#include "film/stored_picture.h"
#include "scene/error.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 3> color_names = {"R", "G", "B"};

struct Colors {
  int width = 0, height = 0;
  std::vector<Vec3f> rgb;
};

// Views and parts are in the order in which they were written: the first one's beauty comes first.
int beauty_part(const Imf::MultiPartInputFile& file) {
  for (int i = 0; i < file.parts(); ++i) {
    if (file.header(i).channels().findChannel(color_names[0]) != nullptr) return i;
  }
  throw std::runtime_error("it has no beauty");
}

Colors read_colors(const fs::path& exr) {
  Imf::MultiPartInputFile file(exr.c_str(), 0);
  Imf::InputPart part(file, beauty_part(file));
  const Imath::Box2i window = part.header().dataWindow();
  Colors colors{window.max.x - window.min.x + 1, window.max.y - window.min.y + 1, {}};
  const auto width = static_cast<std::size_t>(colors.width);
  colors.rgb.resize(width * static_cast<std::size_t>(colors.height));
  Imf::FrameBuffer buffer;
  for (int i = 0; i < 3; ++i) {
    buffer.insert(color_names[static_cast<std::size_t>(i)],
                  Imf::Slice::Make(Imf::FLOAT, &colors.rgb[0][i], window, sizeof(Vec3f),
                                   sizeof(Vec3f) * width));
  }
  part.setFrameBuffer(buffer);
  part.readPixels(window.min.y, window.max.y);
  return colors;
}

// color_at: of the pixel of a number, rows from the top.
template <class ColorAt>
void write_developed(const fs::path& png, int width, int height, const PreviewInfo& info,
                     const ColorAt& color_at) {
  const SrgbBytes byte_of;
  const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  std::vector<std::uint8_t> rgb(3 * count);
  std::uint8_t* to = rgb.data();
  for (std::size_t pixel = 0; pixel < count; ++pixel) {
    const Vec3f light = developed(color_at(pixel), info.development);
    for (int i = 0; i < 3; ++i) *to++ = byte_of(light[i]);
  }
  write_png(png, width, height, rgb, info.label);
}

}  // namespace

void write_preview(const fs::path& png, const Picture& picture, const PreviewInfo& info) {
  write_developed(png, picture.width(), picture.height(), info, [&](std::size_t pixel) {
    Vec3f color(picture.rgba()[pixel]);
    for (int i = 0; i < 3; ++i) color[i] = stored_light(color[i], info.float_beauty);
    return color;
  });
}

void write_preview(const fs::path& png, const fs::path& exr, const PreviewInfo& info) {
  Colors colors;
  try {
    colors = read_colors(exr);
  } catch (const std::exception& error) {
    throw OutputError(exr.string() + ": can not be read again: " + error.what());
  }
  write_developed(png, colors.width, colors.height, info,
                  [&](std::size_t pixel) { return colors.rgb[pixel]; });
}

}  // namespace restframe
