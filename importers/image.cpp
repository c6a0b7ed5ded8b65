// PNG and JPEG through stb_image, which believes what files say: sizes are asked first, and no
// single allocation may be larger than the decoded picture explains.

#include <climits>
#include <cstdlib>
#include <cstring>

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

bool begins_with(const std::vector<std::uint8_t>& bytes, const char* signature,
                 std::size_t length) {
  return bytes.size() >= length && std::memcmp(bytes.data(), signature, length) == 0;
}

// stb_image quotes the bytes of an unknown chunk's name.
[[noreturn]] void fail_to_decode(const std::string& what) {
  throw InputError(on_one_line(what + ": image can not be decoded: " + stbi_failure_reason()));
}

}  // namespace

Image decode_image(const std::vector<std::uint8_t>& bytes, const std::string& what,
                   const ImportLimits& limits) {
  if (!begins_with(bytes, "\x89PNG\r\n\x1a\n", 8) && !begins_with(bytes, "\xff\xd8\xff", 3)) {
    throw InputError(what + ": image is neither PNG nor JPEG");
  }
  if (bytes.size() > INT_MAX) {
    throw InputError(what + ": image file of " + std::to_string(bytes.size()) +
                     " bytes, the limit is " + std::to_string(INT_MAX));
  }
  if (bytes[0] == 0xFF && !has_sound_huffman_tables(bytes)) {
    throw InputError(what + ": image can not be decoded: a Huffman table of more than 256 codes");
  }
  const auto size = static_cast<int>(bytes.size());
  int width = 0, height = 0, channels = 0;
  largest_allocation = std::size_t{1} << 20;
  if (stbi_info_from_memory(bytes.data(), size, &width, &height, &channels) == 0) {
    fail_to_decode(what);
  }
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (pixels > limits.image_pixels) {
    throw InputError(what + ": image of " + std::to_string(width) + " x " + std::to_string(height) +
                     " pixels, the limit is " + std::to_string(limits.image_pixels) +
                     " pixels; --max-image-pixels raises it");
  }
  // 16 bits a channel, a filter byte a row, and buffers that double as they grow.
  largest_allocation = 20 * (pixels + static_cast<std::size_t>(height)) + bytes.size() + (1 << 20);
  stbi_uc* rgba = stbi_load_from_memory(bytes.data(), size, &width, &height, &channels, 4);
  if (rgba == nullptr) {
    fail_to_decode(what);
  }
  Image image;
  image.width = width;
  image.height = height;
  image.rgba.assign(rgba, rgba + 4 * pixels);
  stbi_image_free(rgba);
  return image;
}

}  // namespace restframe
