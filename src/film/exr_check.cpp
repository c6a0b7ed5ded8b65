#include "film/exr_check.h"

#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <cstring>
#include <fstream>
#include <string_view>

#include "film/byte_sum.h"

namespace restframe {
namespace {

constexpr std::size_t digits = std::string_view(no_seal).size();

// The bytes of the attribute before its value: its name and type, each with a NUL, and its length.
std::string seal_start() {
  using namespace std::string_literals;
  return seal_attribute + "\0string\0\x10\0\0\0"s;
}

// Appends up to a piece; returns false at the end of the file.
bool read_piece(std::ifstream& file, std::string& bytes) {
  constexpr std::size_t piece = 1 << 20;
  const std::size_t before = bytes.size();
  bytes.resize(before + piece);
  file.read(bytes.data() + before, piece);
  bytes.resize(before + static_cast<std::size_t>(file.gcount()));
  return bytes.size() > before;
}

// Reads on until all of the seal is there, and returns where it is.
std::optional<std::size_t> find_seal(std::ifstream& file, std::string& bytes) {
  constexpr std::size_t longest_header = 1 << 28;
  const std::string start = seal_start();
  while (bytes.size() < longest_header && read_piece(file, bytes)) {
    const std::size_t at = bytes.find(start);
    if (at != std::string::npos && at + start.size() + digits <= bytes.size()) {
      return at + start.size();
    }
  }
  return std::nullopt;
}

bool is_as_written(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes;
  const auto at = find_seal(file, bytes);
  if (!at) return false;
  const std::string seal = bytes.substr(*at, digits);
  bytes.replace(*at, digits, no_seal);
  ByteSum sum;
  do {
    sum.add(bytes.data(), bytes.size());
    bytes.clear();
  } while (read_piece(file, bytes));
  return sum.hex() == seal;
}

WrittenPicture read_header(const Imf::Header& header) {
  WrittenPicture written;
  for (auto i = header.begin(); i != header.end(); ++i) {
    if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&i.attribute())) {
      written.texts[i.name()] = text->value();
    }
  }
  if (const auto* number = header.findTypedAttribute<Imf::IntAttribute>("pictureNumber")) {
    written.number = number->value();
  }
  return written;
}

}  // namespace

void seal_exr(std::span<std::byte> file) {
  const std::string_view bytes(reinterpret_cast<const char*>(file.data()), file.size());
  const std::string start = seal_start();
  const std::size_t at = bytes.find(start + no_seal);
  if (at == std::string_view::npos) return;
  ByteSum sum;
  sum.add(bytes.data(), bytes.size());
  std::memcpy(file.data() + at + start.size(), sum.hex().data(), digits);
}

std::optional<WrittenPicture> written_picture(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored) || !is_as_written(path)) return std::nullopt;
  try {
    const Imf::MultiPartInputFile file(path.c_str(), 0);
    return read_header(file.header(0));
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace restframe
