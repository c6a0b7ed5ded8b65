#include "importers/paper_intervals.h"

#include <fmt/format.h>

#include <charconv>
#include <string_view>

#include "importers/input_file.h"
#include "scene/suggest.h"

namespace restframe {
namespace {

constexpr std::size_t largest_file = 16'000'000;

struct Word {
  TextPosition at;
  std::string text;
};

// A '#' begins a comment, except as a colour, the fifth word of "% interval BEGIN END COLOUR".
std::vector<Word> words_of(std::string_view line, int number) {
  constexpr std::string_view blank = " \t\r\f\v";
  std::vector<Word> words;
  std::size_t begin = line.find_first_not_of(blank);
  while (begin != std::string_view::npos) {
    if (line[begin] == '#' && words.size() != 4) break;
    const bool is_mark = words.empty() && line[begin] == '%';
    const std::size_t end =
        is_mark ? begin + 1 : std::min(line.find_first_of(blank, begin), line.size());
    words.push_back(
        {{number, static_cast<int>(begin) + 1}, std::string(line.substr(begin, end - begin))});
    begin = line.find_first_not_of(blank, end);
  }
  return words;
}

class PaperReader {
 public:
  PaperReader(const ValueRule& rule, const Reporter& reporter) : rule_(rule), report(reporter) {}

  void read_line(const std::vector<Word>& words);
  IntervalFunction result() const { return make_intervals(period_, intervals_, report); }

 private:
  std::optional<double> number(const Word& word, const char* what, const Range& range = {});
  std::optional<TemporalValue> value(const Word& word);
  void read_period(const std::vector<Word>& words);
  void read_interval(const std::vector<Word>& words);
  bool has_count(const std::vector<Word>& words, std::size_t count, const char* form);

  ValueRule rule_;
  const Reporter& report;
  std::optional<double> period_;
  std::vector<PlacedInterval> intervals_;
};

std::optional<double> PaperReader::number(const Word& word, const char* what, const Range& range) {
  double x = 0;
  const char* end = word.text.data() + word.text.size();
  const auto [stop, error] = std::from_chars(word.text.data(), end, x);
  if (error == std::errc() && stop == end) return read_number({word.at, x}, what, range, report);
  report(word.at, fmt::format("{} is \"{}\", must be a number", what, word.text));
  return std::nullopt;
}

std::optional<TemporalValue> PaperReader::value(const Word& word) {
  if (rule_.is_color) return read_color_text(word.at, word.text, "the colour", report);
  const std::optional<double> x = number(word, "the value", rule_.range);
  return x ? std::optional(TemporalValue(static_cast<float>(*x))) : std::nullopt;
}

bool PaperReader::has_count(const std::vector<Word>& words, std::size_t count, const char* form) {
  if (words.size() == count) return true;
  const TextPosition at = words.size() > count ? words[count].at : words.front().at;
  report(at, fmt::format("{} words, must be \"{}\"", words.size(), form));
  return false;
}

void PaperReader::read_period(const std::vector<Word>& words) {
  if (!has_count(words, 3, "% period SECONDS")) return;
  if (period_) report(words[1].at, "the period is given twice");
  const std::optional<double> period = number(words[2], "the period", above(0));
  if (period) period_ = period;
}

void PaperReader::read_interval(const std::vector<Word>& words) {
  const char* form = rule_.is_color ? "% interval BEGIN END COLOUR" : "% interval BEGIN END NUMBER";
  if (!has_count(words, 5, form)) return;
  const auto begin = number(words[2], "the beginning");
  const auto end = number(words[3], "the end");
  const auto held = value(words[4]);
  if (begin && end && held) intervals_.push_back({words[2].at, {*begin, *end, *held}});
}

void PaperReader::read_line(const std::vector<Word>& words) {
  if (words.empty()) return;
  if (words[0].text != "%") {
    report(words[0].at, fmt::format("\"{}\", must be % period or % interval", words[0].text));
    return;
  }
  if (words.size() > 1 && words[1].text == "period") {
    read_period(words);
  } else if (words.size() > 1 && words[1].text == "interval") {
    read_interval(words);
  } else {
    const std::string word = words.size() > 1 ? words[1].text : "";
    report(words.back().at, fmt::format("\"% {}\" is unknown, the nearest is \"% {}\"", word,
                                        nearest(word, {"period", "interval"})));
  }
}

}  // namespace

IntervalFunction read_paper_intervals(const std::filesystem::path& path, const ValueRule& rule) {
  const std::string text = read_input_file(path, largest_file, path.string());
  FaultList faults(path.string());
  const Reporter report{faults, ""};
  PaperReader reader(rule, report);
  int line = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    reader.read_line(words_of(std::string_view(text).substr(begin, end - begin), ++line));
    begin = end + 1;
  }
  IntervalFunction function = reader.result();
  if (faults.empty() && function.intervals.empty()) {
    report({1, 1}, "there is no interval, must be at least one \"% interval BEGIN END ...\"");
  }
  faults.throw_any();
  return function;
}

}  // namespace restframe
