#include "film/png_preview.h"

#include <cmath>

#include "scene/atomic_file.h"
#include "scene/color.h"
#include "scene/error.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace restframe {
namespace {

void append_bytes(void* to, void* bytes, int count) {
  const auto* first = static_cast<const std::byte*>(bytes);
  static_cast<std::vector<std::byte>*>(to)->insert(static_cast<std::vector<std::byte>*>(to)->end(),
                                                   first, first + count);
}

std::uint8_t byte_of(float encoded) {
  const float value = std::isfinite(encoded) ? glm::clamp(encoded, 0.0F, 1.0F) : 1.0F;
  return static_cast<std::uint8_t>(std::lround(255.0F * value));
}

}  // namespace

void write_png(const std::filesystem::path& path, const Picture& picture,
               const Development& development) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(3 * picture.rgba().size());
  for (const Vec4f& pixel : picture.rgba()) {
    const Vec3f encoded = srgb_from_linear(developed(Vec3f(pixel), development));
    for (int i = 0; i < 3; ++i) rgb.push_back(byte_of(encoded[i]));
  }
  write_png(path, picture.width(), picture.height(), rgb);
}

void write_png(const std::filesystem::path& path, int width, int height,
               std::span<const std::uint8_t> rgb) {
  std::vector<std::byte> file;
  if (stbi_write_png_to_func(append_bytes, &file, width, height, 3, rgb.data(), 3 * width) == 0) {
    throw OutputError(path.string() + ": the picture can not be encoded as PNG");
  }
  write_file_atomically(path, file);
}

}  // namespace restframe
