#include "importers/gltf_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

namespace restframe {
namespace {

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

// Percent-decoded, or nothing where a '%' is not followed by two digits.
bool percent_decode(const std::string& uri, std::string& decoded) {
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] != '%') {
      decoded += uri[i];
      continue;
    }
    const int high = i + 2 < uri.size() ? hex_digit(uri[i + 1]) : -1;
    const int low = high < 0 ? -1 : hex_digit(uri[i + 2]);
    if (low < 0) return false;
    decoded += static_cast<char>(high * 16 + low);
    i += 2;
  }
  return true;
}

bool has_scheme(const std::string& name) {
  const std::size_t colon = name.find(':');
  return colon != std::string::npos && colon < name.find('/');
}

bool leaves(const Path& relative) {
  return relative.is_absolute() || (!relative.empty() && *relative.begin() == "..");
}

// The real path of the file that `uri` names, inside the asset's folder even after symbolic links.
Path resolve(const GltfContext& context, const std::string& pointer, const std::string& uri) {
  std::string name;
  if (!percent_decode(uri, name)) context.fault(pointer, "malformed % in URI " + in_quotes(uri));
  if (name.empty()) context.fault(pointer, "URI is empty");
  if (name.find('\0') != std::string::npos) context.fault(pointer, "NUL in URI " + in_quotes(uri));
  if (name.find('\\') != std::string::npos) {
    context.fault(pointer, "backslash in URI " + in_quotes(uri) + "; separate folders with /");
  }
  if (has_scheme(name)) {
    context.fault(pointer, "URI " + in_quotes(uri) + " is neither a relative path nor data:");
  }
  const std::string outside = "URI " + in_quotes(uri) + " leaves the asset's folder";
  if (leaves(Path(name).lexically_normal())) context.fault(pointer, outside);

  std::error_code error;
  const Path parent = context.path.parent_path();
  const Path folder = std::filesystem::canonical(parent.empty() ? Path(".") : parent, error);
  const Path real = std::filesystem::canonical(folder / name, error);
  if (error) context.fault(pointer, "can not find file " + in_quotes(uri) + ": " + error.message());
  if (leaves(real.lexically_relative(folder))) context.fault(pointer, outside);
  return real;
}

constexpr std::array<std::int8_t, 256> make_base64_values() {
  std::array<std::int8_t, 256> values{};
  for (auto& value : values) value = -1;
  for (int i = 0; i < 26; ++i) {
    values[static_cast<std::size_t>('A' + i)] = static_cast<std::int8_t>(i);
    values[static_cast<std::size_t>('a' + i)] = static_cast<std::int8_t>(26 + i);
  }
  for (int i = 0; i < 10; ++i) {
    values[static_cast<std::size_t>('0' + i)] = static_cast<std::int8_t>(52 + i);
  }
  values['+'] = 62;
  values['/'] = 63;
  return values;
}

// Appends the bytes of base64 text from `begin` on; false where it is malformed.
bool decode_base64(const std::string& text, std::size_t begin, Bytes& bytes) {
  static constexpr auto values = make_base64_values();
  std::size_t end = text.size();
  if ((end - begin) % 4 == 0) {
    for (int i = 0; i < 2 && end > begin && text[end - 1] == '='; ++i) --end;
  }
  if ((end - begin) % 4 == 1) return false;
  bytes.reserve((end - begin) / 4 * 3 + 2);
  std::uint32_t bits = 0;
  int count = 0;
  for (std::size_t i = begin; i < end; ++i) {
    const int value = values[static_cast<unsigned char>(text[i])];
    if (value < 0) return false;
    bits = (bits << 6) | static_cast<std::uint32_t>(value);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<std::uint8_t>(bits >> count));
  }
  return true;
}

Bytes read_data_uri(const GltfContext& context, const std::string& pointer, const std::string& uri,
                    std::size_t limit) {
  static const std::string marker = ";base64";
  const std::size_t comma = uri.find(',');
  if (comma == std::string::npos || comma < marker.size() ||
      uri.compare(comma - marker.size(), marker.size(), marker) != 0) {
    context.fault(pointer, "data URI " + in_quotes(uri) + " is not ;base64,");
  }
  if ((uri.size() - comma) / 4 > limit / 3) {
    context.fault(pointer, "data URI holds more than " + std::to_string(limit) + " bytes");
  }
  Bytes bytes;
  if (!decode_base64(uri, comma + 1, bytes)) {
    context.fault(pointer, "malformed base64 in data URI " + in_quotes(uri));
  }
  return bytes;
}

}  // namespace

RegularFile::RegularFile(const GltfContext& context, const Path& path, const std::string& pointer)
    : context_(context), pointer_(pointer) {
  const std::string shown = pointer.empty() ? "can not read it" : "can not read " + path.string();
  struct stat status {};
  descriptor_ = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
  if (descriptor_ < 0) context.fault(pointer, shown + ": " + std::strerror(errno));
  if (::fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode)) {
    ::close(descriptor_);
    context.fault(pointer, shown + ": not a regular file");
  }
  size_ = static_cast<std::size_t>(status.st_size);
}

RegularFile::~RegularFile() {
  ::close(descriptor_);
}

void RegularFile::read(void* bytes, std::size_t count) {
  auto* target = static_cast<std::uint8_t*>(bytes);
  while (count > 0) {
    const ssize_t got = ::read(descriptor_, target, std::min(count, std::size_t{1} << 30));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) context_.fault(pointer_, std::string("can not read on: ") + std::strerror(errno));
    if (got == 0) context_.fault(pointer_, "the file ends early");
    target += got;
    count -= static_cast<std::size_t>(got);
  }
}

Bytes read_uri(const GltfContext& context, const std::string& pointer, const std::string& uri,
               std::size_t limit) {
  if (uri.rfind("data:", 0) == 0) return read_data_uri(context, pointer, uri, limit);
  RegularFile file(context, resolve(context, pointer, uri), pointer);
  if (file.size() > limit) {
    context.fault(pointer, "file of " + std::to_string(file.size()) + " bytes, the limit is " +
                               std::to_string(limit));
  }
  Bytes bytes(file.size());
  file.read(bytes.data(), bytes.size());
  return bytes;
}

}  // namespace restframe
