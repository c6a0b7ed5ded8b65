#pragma once

// Comma-separated values: a line that names the columns, then rows of as many fields (RFC 4180).
// Lines end with LF, CRLF or CR; those that are empty or begin with '#' are left out, as are spaces
// around fields. Fields in double quotes may hold commas and line ends.

#include <string>
#include <vector>

#include "importers/text_lines.h"
#include "importers/value_reader.h"

namespace restframe {

struct CsvField {
  TextPosition at;
  std::string text;
};

// A file that is read row by row.
class CsvTable {
 public:
  // Reads the line of names. Throws InputError where the file can not be read, or is no text.
  // Faults of the rows go to `faults`, which must be the file's.
  CsvTable(const std::filesystem::path& path, FaultList& faults);

  const std::vector<CsvField>& names() const { return names_; }

  // The index of the column with this name; a fault if there is none, or more than one.
  std::optional<std::size_t> column(const std::string& name) const;

  // The next row, false if there is none. Rows of another number of fields are faults and left out.
  bool next_row(std::vector<CsvField>& fields);

 private:
  bool next_record(std::vector<CsvField>& fields);
  bool skip_to_record();
  CsvField read_field();
  void read_quoted(CsvField& field);
  void skip_blanks();
  void skip_line_end();
  void check_names();
  bool at_line_end() const;
  bool at_end() const { return next_ >= text_.size(); }
  TextPosition here() const;

  TextFile file_;
  std::string_view text_;
  Reporter report_;
  std::vector<CsvField> names_;
  std::size_t next_ = 0, line_begin_ = 0;
  int line_ = 1;
  bool is_broken_ = false;  // there is no telling where rows end from here on
};

}  // namespace restframe
