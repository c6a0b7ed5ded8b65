#include "importers/gltf_files.h"

#include <array>

#include "importers/asset_file.h"
#include "importers/input_file.h"
#include "scene/file_names.h"
#include "scene/message.h"

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

// The file in the asset's folder that `uri` names.
Path find_file(const GltfContext& context, const std::string& pointer, const std::string& uri) {
  std::string name;
  if (!percent_decode(uri, name)) context.fault(pointer, "malformed % in URI " + quote(uri));
  if (name.empty()) context.fault(pointer, "URI is empty");
  if (name.find('\0') != std::string::npos) context.fault(pointer, "NUL in URI " + quote(uri));
  if (name.find('\\') != std::string::npos) {
    context.fault(pointer, "backslash in URI " + quote(uri) + "; separate folders with /");
  }
  if (has_scheme(name)) {
    context.fault(pointer, "URI " + quote(uri) + " is neither a relative path nor data:");
  }
  const Path folder = folder_of(context.path);
  const std::string what = context.place(pointer) + ": URI " + quote(uri);
  const std::optional<Path> file = find_asset_file(folder, folder, name, what);
  if (!file) context.fault(pointer, "can not find file " + quote(uri));
  return *file;
}

constexpr std::array<int, 256> make_base64_values() {
  std::array<int, 256> values{};
  for (auto& value : values) value = -1;
  for (int i = 0; i < 26; ++i) {
    values[static_cast<std::size_t>('A' + i)] = i;
    values[static_cast<std::size_t>('a' + i)] = 26 + i;
  }
  for (int i = 0; i < 10; ++i) {
    values[static_cast<std::size_t>('0' + i)] = 52 + i;
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
    context.fault(pointer, "data URI " + quote(uri) + " is not ;base64,");
  }
  if ((uri.size() - comma) / 4 > limit / 3) {
    context.fault(pointer, "data URI holds more than " + std::to_string(limit) + " bytes");
  }
  Bytes bytes;
  if (!decode_base64(uri, comma + 1, bytes)) {
    context.fault(pointer, "malformed base64 in data URI " + quote(uri));
  }
  return bytes;
}

}  // namespace

Bytes read_uri(const GltfContext& context, const std::string& pointer, const std::string& uri,
               std::size_t limit) {
  if (uri.rfind("data:", 0) == 0) return read_data_uri(context, pointer, uri, limit);
  const Path file = find_file(context, pointer, uri);
  context.files.insert(file);
  return read_input_file<Bytes>(file, limit, context.place(pointer));
}

}  // namespace restframe
