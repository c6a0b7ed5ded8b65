// PNG and JPEG through stb_image, which believes what files say: sizes are asked first, and no
// single allocation may be larger than the decoded picture explains.

#include <climits>
#include <cstdlib>
#include <memory>
#include <string_view>

#include "importers/image_format.h"
#include "importers/importers.h"
#include "importers/jpeg_check.h"
#include "scene/error.h"
#include "scene/message.h"

namespace {

thread_local std::size_t largest_allocation = 0;

// Zeros, because a JPEG may use tables that it does not define.
void* limited_alloc(std::size_t size) {
  return size > largest_allocation ? nullptr : std::calloc(1, size);
}

void* limited_realloc(void* memory, std::size_t size) {
  return size > largest_allocation ? nullptr : std::realloc(memory, size);
}

}  // namespace

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_ASSERT(condition) static_cast<void>(0)  // some files break them, without harm
#define STBI_MALLOC(size) limited_alloc(size)
#define STBI_REALLOC(memory, size) limited_realloc(memory, size)
#define STBI_FREE(memory) std::free(memory)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#ifdef __clang__
// It copies no bytes to nowhere. The fuzzer should look for more than that.
#pragma clang attribute push(__attribute__((no_sanitize("nonnull-attribute"))), apply_to = function)
#endif
#include <stb/stb_image.h>
#ifdef __clang__
#pragma clang attribute pop
#endif
#pragma GCC diagnostic pop

namespace restframe {
namespace {

struct FreePixels {
  void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};

struct Size {
  int width = 0, height = 0;
  std::size_t pixels() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
};

void require_kind(ByteSpan bytes, const std::string& what) {
  const char* kind = image_kind(bytes);
  const std::string_view name = kind ? kind : "";
  if (name == "PNG" || name == "JPEG") return;
  throw InputError(what + ": image is neither PNG nor JPEG" +
                   (kind ? std::string(" but ") + kind : std::string()));
}

// stb_image quotes the bytes of an unknown chunk's name.
[[noreturn]] void throw_undecodable(const std::string& what) {
  throw InputError(on_one_line(what + ": image can not be decoded: " + stbi_failure_reason()));
}

Size size_of(ByteSpan bytes, const std::string& what, const ImportLimits& limits) {
  require_kind(bytes, what);
  if (bytes.size() > INT_MAX) {
    throw InputError(what + ": image file of " + std::to_string(bytes.size()) +
                     " bytes, the limit is " + std::to_string(INT_MAX));
  }
  if (bytes[0] == 0xFF && !has_sound_huffman_tables(bytes)) {
    throw InputError(what + ": image can not be decoded: a Huffman table of more than 256 codes");
  }
  Size size;
  int channels = 0;
  largest_allocation = std::size_t{1} << 20;
  if (stbi_info_from_memory(bytes.data(), static_cast<int>(bytes.size()), &size.width, &size.height,
                            &channels) == 0) {
    throw_undecodable(what);
  }
  if (size.pixels() <= limits.image_pixels) return size;
  throw InputError(what + ": image of " + std::to_string(size.width) + " x " +
                   std::to_string(size.height) + " pixels, the limit is " +
                   std::to_string(limits.image_pixels) + " pixels; --max-image-pixels raises it");
}

}  // namespace

std::size_t count_image_pixels(ByteSpan bytes, const std::string& what,
                               const ImportLimits& limits) {
  return size_of(bytes, what, limits).pixels();
}

Image decode_image(ByteSpan bytes, const std::string& what, const ImportLimits& limits) {
  const Size size = size_of(bytes, what, limits);
  const bool is_jpeg = bytes[0] == 0xFF;
  const std::string fault = is_jpeg ? jpeg_fault(bytes) : png_fault(bytes);
  if (!fault.empty()) {
    throw InputError(what + (is_jpeg ? ": image is a JPEG " : ": image is a PNG ") + fault);
  }
  // 16 bits a channel, a filter byte a row, and buffers that double as they grow.
  const std::size_t pixels = size.pixels();
  largest_allocation =
      20 * (pixels + static_cast<std::size_t>(size.height)) + bytes.size() + (1 << 20);
  Image image;
  image.format = is_jpeg ? "JPEG" : "PNG";
  int channels = 0;
  const std::unique_ptr<stbi_uc, FreePixels> rgba(stbi_load_from_memory(
      bytes.data(), static_cast<int>(bytes.size()), &image.width, &image.height, &channels, 4));
  if (!rgba) throw_undecodable(what);
  image.rgba.assign(rgba.get(), rgba.get() + 4 * pixels);
  return image;
}

}  // namespace restframe
