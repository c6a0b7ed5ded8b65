#include "importers/gltf_container.h"

#include <array>
#include <cstring>

#include "importers/input_file.h"

namespace restframe {
namespace {

constexpr std::uint32_t magic_gltf = 0x46546C67, chunk_json = 0x4E4F534A, chunk_bin = 0x004E4942;
constexpr std::size_t header_size = 12, chunk_header_size = 8;

std::uint32_t little_endian(const std::uint8_t* b) {
  return static_cast<std::uint32_t>(b[0]) | static_cast<std::uint32_t>(b[1]) << 8 |
         static_cast<std::uint32_t>(b[2]) << 16 | static_cast<std::uint32_t>(b[3]) << 24;
}

std::string bytes_text(std::size_t count) {
  return std::to_string(count) + " bytes";
}

void check_json_size(const GltfContext& context, std::size_t size) {
  if (size <= context.limits.json_bytes) return;
  context.fault("", "JSON of " + bytes_text(size) + ", the limit is " +
                        bytes_text(context.limits.json_bytes) + "; --max-json-bytes raises it");
}

void check_header(const GltfContext& context, const std::uint8_t* header, std::size_t size) {
  const std::uint32_t version = little_endian(header + 4), length = little_endian(header + 8);
  if (version != 2) {
    context.fault("", "GLB version " + std::to_string(version) + ", only version 2 can be read");
  }
  if (length != size) {
    context.fault("",
                  "GLB header says " + bytes_text(length) + ", the file has " + bytes_text(size));
  }
}

struct Chunk {
  std::uint32_t size = 0, type = 0;
};

Chunk read_chunk_header(const GltfContext& context, InputFile& file, std::size_t left) {
  if (left < chunk_header_size) {
    context.fault("",
                  "GLB ends within a chunk header, " + bytes_text(left) + " after the last chunk");
  }
  std::array<std::uint8_t, chunk_header_size> header{};
  file.read(header.data(), header.size());
  const Chunk chunk{little_endian(header.data()), little_endian(header.data() + 4)};
  left -= chunk_header_size;
  if (chunk.size > left) {
    context.fault("", "GLB chunk claims " + bytes_text(chunk.size) + ", the file has " +
                          bytes_text(left) + " left");
  }
  if (chunk.size % 4 != 0) {
    context.fault("", "GLB chunk of " + bytes_text(chunk.size) + " is not a multiple of 4");
  }
  return chunk;
}

void check_chunk_order(const GltfContext& context, const Chunk& chunk, int number) {
  if (number == 0 && chunk.type != chunk_json) context.fault("", "first GLB chunk is not JSON");
  if (number > 0 && chunk.type == chunk_json) context.fault("", "GLB has a second JSON chunk");
  if (number > 1 && chunk.type == chunk_bin) {
    context.fault("", "GLB has a BIN chunk at place " + std::to_string(number + 1) +
                          ", only the second chunk can be one");
  }
}

GltfContainer read_glb(const GltfContext& context, InputFile& file, std::size_t left) {
  GltfContainer container;
  for (int number = 0; number == 0 || left > 0; ++number) {
    const Chunk chunk = read_chunk_header(context, file, left);
    check_chunk_order(context, chunk, number);
    left -= chunk_header_size + chunk.size;
    if (chunk.type == chunk_json) {
      check_json_size(context, chunk.size);
      container.json.resize(chunk.size);
      file.read(container.json.data(), chunk.size);
    } else if (chunk.type == chunk_bin) {
      container.bin.emplace(chunk.size);
      file.read(container.bin->data(), chunk.size);
    } else {
      Bytes skipped(chunk.size);
      file.read(skipped.data(), chunk.size);
      context.warn("", "GLB chunk of unknown type " + std::to_string(chunk.type) + " left out");
    }
  }
  return container;
}

}  // namespace

GltfContainer read_container(const GltfContext& context) {
  InputFile file(context.path, context.file);
  const std::size_t size = file.size();
  if (size == 0) context.fault("", "the file is empty");
  file.check_size(context.limits.total_bytes);
  std::array<std::uint8_t, header_size> header{};
  const std::size_t begun = std::min(size, header_size);
  file.read(header.data(), begun);
  if (begun >= 4 && little_endian(header.data()) == magic_gltf) {
    if (begun < header_size) context.fault("", "GLB ends within its header");
    check_header(context, header.data(), size);
    return read_glb(context, file, size - header_size);
  }
  check_json_size(context, size);
  GltfContainer container;
  container.json.resize(size);
  std::memcpy(container.json.data(), header.data(), begun);
  file.read(container.json.data() + begun, size - begun);
  return container;
}

}  // namespace restframe
