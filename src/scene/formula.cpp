#include "scene/formula.h"

#include <algorithm>
#include <cctype>
#include <numbers>
#include <stdexcept>

#include "scene/temporal_function.h"

namespace restframe {
namespace {

// muParser evaluates "t = 5". Every '=' of a formula has to belong to ==, !=, <= or >=.
bool assigns(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '=') continue;
    if (i + 1 < text.size() && text[i + 1] == '=') {
      ++i;
    } else if (i == 0 || std::string("<>!").find(text[i - 1]) == std::string::npos) {
      return true;
    }
  }
  return false;
}

bool is_plain(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte < 127 && (std::isprint(byte) || std::isspace(byte));
}

// What muParser takes but a formula must not hold.
void check_text(const std::string& text) {
  constexpr std::size_t longest = 10'000;
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) {
    throw std::invalid_argument("the formula is empty");
  }
  if (text.size() > longest) {
    throw std::invalid_argument("the formula is longer than 10000 characters");
  }
  if (!std::all_of(text.begin(), text.end(), is_plain)) {
    throw std::invalid_argument("the formula holds a character that is not plain ASCII");
  }
  if (text.find('"') != std::string::npos) {
    throw std::invalid_argument("a formula holds no text in quotes");
  }
  if (assigns(text)) throw std::invalid_argument("a formula can not assign; == compares");
}

}  // namespace

Formula::Formula(const std::string& text) {
  check_text(text);
  parser_.ClearConst();
  parser_.DefineConst("pi", std::numbers::pi);
  parser_.DefineVar("t", &t_);
  parser_.SetExpr(text);
  // The first evaluation parses into bytecode, which the second, as all later ones, runs.
  parser_.Eval();
  if (parser_.GetNumResults() != 1) {
    throw std::invalid_argument("the formula is a list of " +
                                std::to_string(parser_.GetNumResults()) + " values, must be one");
  }
  parser_.Eval();
}

std::optional<std::string> formula_fault(const std::string& formula) {
  try {
    const Formula parsed(formula);
    return std::nullopt;
  } catch (const mu::Parser::exception_type& error) {
    return error.GetMsg();
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace restframe
