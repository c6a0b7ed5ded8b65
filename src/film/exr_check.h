#pragma once

// A picture says in its header what all its other bytes add up to: so whether a file is as it was written
// is known as fast as it is read, without decoding it.

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>

namespace restframe {

// The text attribute that holds the sum, and what it holds until the file is sealed.
inline constexpr const char* seal_attribute = "restframeSeal";
inline constexpr const char* no_seal = "0000000000000000";

// Writes the sum into the bytes of a whole EXR whose seal_attribute is no_seal.
void seal_exr(std::span<std::byte> file);

// What the header of a picture says.
struct WrittenPicture {
  int number = 0;
  std::map<std::string, std::string> texts;  // attributes
};

// Nothing where the file is missing, torn, not as it was written, or of another make.
std::optional<WrittenPicture> written_picture(const std::filesystem::path& path);

}  // namespace restframe
