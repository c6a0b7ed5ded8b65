#include "importers/csv_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/message.h"
#include "scene/suggest.h"

namespace restframe {
namespace {

constexpr std::size_t largest_file = 64'000'000, most_columns = 10'000;

std::string names_of(const std::vector<CsvField>& names) {
  constexpr std::size_t most = 12;
  std::string list;
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i) {
    list += (i == 0 ? "" : ", ") + quote(names[i].text);
  }
  return names.size() > most ? fmt::format("{} and {} more", list, names.size() - most) : list;
}

bool is_number(const CsvField& field) {
  double ignored = 0;
  return read_number(field.text, ignored);
}

}  // namespace

CsvTable::CsvTable(const std::filesystem::path& path, FaultList& faults)
    : file_(path, largest_file), text_(file_.text()), report_{faults, ""} {
  if (next_record(names_)) {
    check_names();
  } else if (!is_broken_) {
    report_({1, 1}, "the file is empty, must have a line that names the columns, and rows");
  }
}

void CsvTable::check_names() {
  if (names_.size() == 1) {
    const std::string& only = names_[0].text;
    const std::size_t divider = only.find_first_of(";\t|");
    if (divider != std::string::npos) {
      report_(names_[0].at, fmt::format("columns are divided by {}, must be by commas",
                                        quote(only.substr(divider, 1))));
    }
  } else if (std::all_of(names_.begin(), names_.end(), is_number)) {
    report_(names_[0].at, "the first line holds numbers, must name the columns");
  }
}

std::optional<std::size_t> CsvTable::column(const std::string& name) const {
  const auto has_name = [&](const CsvField& field) { return field.text == name; };
  const auto found = std::find_if(names_.begin(), names_.end(), has_name);
  if (found == names_.end()) {
    std::vector<std::string> known;
    for (const CsvField& field : names_) known.push_back(field.text);
    report_(names_.empty() ? TextPosition{} : names_[0].at,
            fmt::format("there is no column {}, the nearest is {} (columns: {})", quote(name),
                        quote(nearest(name, known)), names_of(names_)));
    return std::nullopt;
  }
  const auto again = std::find_if(found + 1, names_.end(), has_name);
  if (again != names_.end()) {
    report_(again->at, fmt::format("two columns have the name {}", quote(name)));
    return std::nullopt;
  }
  return static_cast<std::size_t>(found - names_.begin());
}

bool CsvTable::next_row(std::vector<CsvField>& fields) {
  while (next_record(fields)) {
    if (fields.size() == names_.size()) return true;
    report_(fields[0].at,
            fmt::format("the row has {} fields, must have {} as the line of names has",
                        fields.size(), names_.size()));
  }
  return false;
}

TextPosition CsvTable::here() const {
  return {line_, static_cast<int>(next_ - line_begin_) + 1};
}

bool CsvTable::at_line_end() const {
  return at_end() || text_[next_] == '\n' || text_[next_] == '\r';
}

void CsvTable::skip_blanks() {
  while (!at_end() && (text_[next_] == ' ' || text_[next_] == '\t')) ++next_;
}

void CsvTable::skip_line_end() {
  if (at_end()) return;
  next_ += text_.substr(next_, 2) == "\r\n" ? 2 : 1;
  line_begin_ = next_;
  ++line_;
}

// Leaves out empty lines and comments.
bool CsvTable::skip_to_record() {
  for (; !at_end(); skip_line_end()) {
    const std::size_t begin = next_;
    skip_blanks();
    if (!at_line_end() && text_[next_] != '#') {
      next_ = begin;
      return true;
    }
    while (!at_line_end()) ++next_;
  }
  return false;
}

// From behind the opening quote to behind the closing one; two quotes stand for one.
void CsvTable::read_quoted(CsvField& field) {
  for (++next_; !at_end();) {
    if (text_[next_] == '"') {
      const bool is_doubled = text_.substr(next_, 2) == "\"\"";
      next_ += is_doubled ? 2 : 1;
      if (!is_doubled) return;
      field.text += '"';
    } else if (at_line_end()) {
      field.text += '\n';
      skip_line_end();
    } else {
      field.text += text_[next_++];
    }
  }
  report_(field.at, "a quote is never closed");
  is_broken_ = true;
}

CsvField CsvTable::read_field() {
  skip_blanks();
  CsvField field{here(), {}};
  if (!at_end() && text_[next_] == '"') {
    read_quoted(field);
    skip_blanks();
    if (!at_line_end() && text_[next_] != ',') report_(here(), "text after a closing quote");
    while (!at_line_end() && text_[next_] != ',') ++next_;
    return field;
  }
  const std::size_t begin = next_;
  while (!at_line_end() && text_[next_] != ',') ++next_;
  field.text = trimmed(text_.substr(begin, next_ - begin));
  return field;
}

bool CsvTable::next_record(std::vector<CsvField>& fields) {
  fields.clear();
  if (is_broken_ || !skip_to_record()) return false;
  for (;;) {
    fields.push_back(read_field());
    if (at_line_end()) break;
    if (fields.size() == most_columns) {
      report_(here(), fmt::format("there are more than {} columns", most_columns));
      is_broken_ = true;
      return false;
    }
    ++next_;  // the comma
  }
  skip_line_end();
  return !is_broken_;
}

}  // namespace restframe
