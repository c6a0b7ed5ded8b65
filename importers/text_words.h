#pragma once

#include <string_view>

#include "importers/text_lines.h"

namespace restframe {

// The words of a text file, wherever its lines end.
class TextWords {
 public:
  // What follows `comment` on a line is left out; 0: nothing is.
  explicit TextWords(TextFile& file, char comment = '\0') : file_(file), comment_(comment) {}

  // The next word; empty at the end of the file.
  std::string_view next();

  // The next word of this line; empty if there is none left.
  std::string_view next_on_line() { return take_word(rest_); }

  // Whatever is left of this line.
  std::string_view rest_of_line();

  // Moves on to the start of the next line that has a word; false if there is none.
  bool next_line();

  [[noreturn]] void fail(std::string_view word, const std::string& reason) const {
    file_.fail(word, reason);
  }
  // Throws InputError: the file ends where `what` is missing.
  [[noreturn]] void fail_at_end(const std::string& what) const;

  // A number that may be infinite or NaN, as some programs write them. Throws InputError if `word`
  // is none.
  double number(std::string_view word) const;
  // Likewise; those too large for a float are the largest ones.
  float real(std::string_view word) const;

 private:
  TextFile& file_;
  char comment_;
  std::string_view rest_;
};

}  // namespace restframe
