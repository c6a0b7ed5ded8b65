#include "importers/off_header.h"

#include <fmt/format.h>

#include <charconv>
#include <system_error>

#include "scene/message.h"

namespace restframe {
namespace {

bool take_prefix(std::string_view& word, std::string_view prefix) {
  if (word.substr(0, prefix.size()) != prefix) return false;
  word.remove_prefix(prefix.size());
  return true;
}

// Takes the keyword off the front of `word`, which may go on with a number (some programs forget
// the space). False if it does not begin with one.
bool take_keyword(TextWords& words, std::string_view& word, OffHeader& header) {
  std::string_view rest = word;
  header.has_uvs = take_prefix(rest, "ST");
  header.has_colors = take_prefix(rest, "C");
  header.has_normals = take_prefix(rest, "N");
  header.has_weight = take_prefix(rest, "4");
  if (take_prefix(rest, "n") && take_prefix(rest, "OFF")) {
    words.fail(word, "nOFF, in any number of dimensions, can not be read: save it in three");
  }
  if (!take_prefix(rest, "OFF")) return false;
  word = rest;
  return true;
}

std::uint64_t read_count(TextWords& words, std::string_view word, const char* what) {
  if (word.empty()) words.fail_at_end(fmt::format("the number of {} is missing", what));
  std::uint64_t count = 0;
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, count);
  if (stop != end || error == std::errc::invalid_argument) {
    words.fail(word, fmt::format("{} is no number of {}", quote(word), what));
  }
  return error == std::errc::result_out_of_range ? UINT64_MAX : count;
}

// Each line of a vertex or face has at least so many bytes.
void check_room(TextWords& words, std::string_view word, std::uint64_t count, std::size_t size,
                std::size_t least, const char* what) {
  if (count <= (size + 1) / least) return;
  words.fail(word, fmt::format("{} {} can not be in a file of {} bytes", word, what, size));
}

}  // namespace

OffHeader read_off_header(TextWords& words, std::size_t size) {
  constexpr std::size_t vertex_bytes = 6, face_bytes = 2;  // "0 0 0\n", "0\n"
  OffHeader header;
  std::string_view word = words.next();
  if (word.empty()) words.fail_at_end("no OFF header");
  const bool has_keyword = take_keyword(words, word, header);
  if (!has_keyword && (word[0] < '0' || word[0] > '9')) {
    words.fail(word,
               fmt::format("{}, must be \"OFF\" (or COFF, NOFF, STOFF, 4OFF, ...)", quote(word)));
  }
  if (word.empty()) word = words.next();
  if (word == "BINARY") {
    words.fail(word, "binary OFF can not be read: save it as text, or as binary PLY");
  }
  header.vertices = read_count(words, word, "vertices");
  check_room(words, word, header.vertices, size, vertex_bytes, "vertices");
  word = words.next();
  header.faces = read_count(words, word, "faces");
  check_room(words, word, header.faces, size, face_bytes, "faces");
  words.rest_of_line();  // the number of edges, which nobody needs
  return header;
}

}  // namespace restframe
