// The paper's figure 5: equation 3 against viewing direction, as formulas and as the program draws
// it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "physics/doppler.h"
#include "support/file_bytes.h"
#include "support/program_errors.h"
#include "support/temporary_folder.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr long double kDegree = std::numbers::pi_v<long double> / 180;

// alpha = 1 / ((1 + e.beta) gamma), where e.beta is beta times the sine of the angle from the
// transverse direction towards receding. 1 + beta sin(a) = (1 - beta) + 2 beta sin^2((a + 90)/2) has
// no difference that cancels.
long double equation_3(long double beta, long double degrees) {
  const long double half = std::sin((degrees + 90) * kDegree / 2);
  const long double sum = (1 - beta) + 2 * beta * half * half;
  return std::sqrt((1 - beta) * (1 + beta)) / sum;
}

// Where alpha is 1: cos(theta) = sqrt((gamma - 1) / (gamma + 1)), theta = 90 degrees + angle.
long double crossover_degrees(long double beta) {
  const long double gamma = 1 / std::sqrt((1 - beta) * (1 + beta));
  return std::acos(std::sqrt((gamma - 1) / (gamma + 1))) / kDegree - 90;
}

struct Table {
  std::vector<std::string> names;
  std::vector<std::vector<double>> rows;
};

Table table_of(const fs::path& csv) {
  Table table;
  std::istringstream lines(bytes_of(csv));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line);
    const bool head = table.names.empty();
    if (!head) table.rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) {
      if (head) table.names.push_back(cell);
      if (!head) table.rows.back().push_back(std::stod(cell));
    }
  }
  return table;
}

// Where a column passes 1, on straight lines between its rows.
double interpolated_crossing(const Table& table, std::size_t column) {
  for (std::size_t i = 1; i < table.rows.size(); ++i) {
    const auto& before = table.rows[i - 1];
    const auto& after = table.rows[i];
    if (before[column] < 1 || after[column] > 1) continue;
    const double part = (before[column] - 1) / (before[column] - after[column]);
    return before[0] + part * (after[0] - before[0]);
  }
  return std::nan("");
}

class Curves : public testing::Test {
 protected:
  RunResult curves(const std::vector<std::string>& options = {},
                   RunOptions run_options = {}) const {
    std::vector<std::string> arguments = {"curves"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    run_options.folder = folder_.path();
    return run_program(RESTFRAME_PROGRAM, arguments, run_options);
  }
  fs::path path(const std::string& name) const { return folder_.path() / name; }

 private:
  TemporaryFolder folder_;
};

TEST(BlinkRate, IsEquation3) {
  for (const double speed : {0.0, 1e-300, 1e-9, 0.1, 0.5, 0.85, 0.9, 0.99, 0.999999}) {
    for (int degrees = -90; degrees <= 90; degrees += 3) {
      const auto angle = static_cast<double>(degrees * kDegree);
      const auto expected = static_cast<double>(equation_3(speed, degrees));
      // The angle's rounding changes ln(alpha) by up to gamma epsilon.
      const double gamma = 1 / std::sqrt(1 - speed * speed);
      EXPECT_NEAR(blink_rate_factor(speed, angle) / expected, 1, 2e-15 * (1 + gamma))
          << speed << "c at " << degrees;
    }
  }
}

TEST(BlinkRate, HasThePapersValues) {
  EXPECT_NEAR(blink_rate_factor(0.99, -std::numbers::pi / 2), 14.1, 0.05);
  EXPECT_NEAR(blink_rate_factor(0.99, 0), 1 / 7.0888, 1e-6);
  EXPECT_NEAR(blink_rate_factor(0.9, 0), std::sqrt(1 - 0.81), 1e-15);
}

TEST(CrossoverAngle, IsTheClosedForm) {
  for (const double speed : {0.01, 0.1, 0.5, 0.85, 0.9, 0.99, 0.999999, 1 - 1e-12}) {
    const double angle = crossover_angle(speed);
    EXPECT_NEAR(angle / static_cast<double>(crossover_degrees(speed) * kDegree), 1, 1e-14) << speed;
    const double gamma = 1 / std::sqrt((1 - speed) * (1 + speed));
    EXPECT_NEAR(blink_rate_factor(speed, angle), 1, 1e-15 * (2 + gamma)) << speed;
  }
}

TEST(CrossoverAngle, KeepsItsDigitsForSlowObjects) {
  // For small beta, alpha = 1 - beta sin(a) - beta^2/2: sin(a) = -beta/2.
  for (const double speed : {1e-300, 1e-100, 1e-12, 1e-9}) {
    EXPECT_NEAR(crossover_angle(speed) / (-speed / 2), 1, 1e-15) << speed;
  }
  EXPECT_EQ(crossover_angle(0), 0);
}

TEST_F(Curves, TableIsEquation3) {
  const RunResult result = curves();
  ASSERT_EQ(result.exit_code, 0) << result.error;
  EXPECT_THAT(result.out, HasSubstr("out/curves.svg"));
  const Table table = table_of(path("out/curves.csv"));
  EXPECT_THAT(table.names, testing::ElementsAre("angle_degrees", "0.85c", "0.9c", "0.99c"));
  ASSERT_EQ(table.rows.size(), 181U);
  const double speeds[] = {0.85, 0.9, 0.99};
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    ASSERT_EQ(table.rows[i].size(), 4U);
    EXPECT_EQ(table.rows[i][0], static_cast<double>(i) - 90);
    for (std::size_t s = 0; s < 3; ++s) {
      const auto expected =
          static_cast<double>(equation_3(speeds[s], static_cast<long double>(i) - 90));
      EXPECT_NEAR(table.rows[i][s + 1] / expected, 1, 2e-14) << speeds[s] << "c, row " << i;
    }
  }
  EXPECT_NEAR(table.rows[0][3], 14.1, 0.05);
}

TEST_F(Curves, TableCrossesOverWhereTheClosedFormSays) {
  ASSERT_EQ(curves({"-o", "a.svg"}).exit_code, 0);
  ASSERT_EQ(curves({"-o", "b.svg", "--step", "0.1"}).exit_code, 0);
  const double speeds[] = {0.85, 0.9, 0.99};
  for (const auto& [name, tolerance] :
       {std::pair<const char*, double>{"a.csv", 0.01}, {"b.csv", 1e-4}}) {
    const Table table = table_of(path(name));
    for (std::size_t s = 0; s < 3; ++s) {
      EXPECT_NEAR(interpolated_crossing(table, s + 1),
                  static_cast<double>(crossover_degrees(speeds[s])), tolerance)
          << name << ", " << speeds[s] << "c";
    }
  }
}

TEST_F(Curves, TableEndsAt90WhateverTheStep) {
  for (const auto& [step, rows] :
       {std::pair<const char*, std::size_t>{"0.1", 1801}, {"7", 27}, {"90", 3}, {"0.3", 601}}) {
    ASSERT_EQ(curves({"-o", "c.svg", "--step", step}).exit_code, 0);
    const Table table = table_of(path("c.csv"));
    EXPECT_EQ(table.rows.size(), rows) << step;
    EXPECT_EQ(table.rows.front()[0], -90);
    EXPECT_EQ(table.rows.back()[0], 90);
    for (std::size_t i = 1; i < table.rows.size(); ++i) {
      EXPECT_GT(table.rows[i][0], table.rows[i - 1][0]);
    }
  }
}

// The text of the elements that have this attribute.
std::vector<std::string> words_in(const std::string& svg, const std::string& attribute) {
  std::vector<std::string> words;
  for (std::size_t at = 0; (at = svg.find("<text ", at)) != std::string::npos; ++at) {
    const std::size_t begin = svg.find('>', at) + 1;
    if (svg.substr(at, begin - at).find(attribute) == std::string::npos) continue;
    words.push_back(svg.substr(begin, svg.find("</text>", begin) - begin));
  }
  return words;
}

TEST_F(Curves, DrawingMarksWhatThePaperNames) {
  ASSERT_EQ(curves().exit_code, 0);
  const std::string svg = bytes_of(path("out/curves.svg"));
  EXPECT_EQ(svg.rfind("<svg ", 0), 0U);
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  // Red, green and brown; each with its factor at -90 degrees, its cross-over angle and 1/gamma.
  EXPECT_THAT(words_in(svg, "#c8141e"),
              testing::ElementsAre("14.1", "\u221260.2\u00b0", "0.141 at 0.99c"));
  EXPECT_THAT(words_in(svg, "#21873b"),
              testing::ElementsAre("4.36", "\u221238.8\u00b0", "0.436 at 0.9c"));
  EXPECT_THAT(words_in(svg, "#8a5a2b"),
              testing::ElementsAre("3.51", "\u221233.8\u00b0", "0.527 at 0.85c"));
  for (const char* tick : {"\u221290\u00b0", "0\u00b0", "90\u00b0"}) {
    EXPECT_THAT(words_in(svg, "middle"), testing::Contains(tick));
  }
  EXPECT_THAT(words_in(svg, "end"), testing::Contains("14"));
}

TEST_F(Curves, AnySpeedsAreDrawnInsideTheDrawing) {
  const RunResult result =
      curves({"-o", "many.svg", "--speeds", "0,1e-9,0.2,0.5,0.7,0.99,0.999999,0.9999999999"});
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const std::string svg = bytes_of(path("many.svg"));
  EXPECT_THAT(svg, testing::Not(HasSubstr("nan")));
  EXPECT_THAT(svg, testing::Not(HasSubstr("inf")));
  EXPECT_EQ(table_of(path("many.csv")).names.size(), 9U);
  ASSERT_EQ(curves({"-o", "rest.svg", "--speeds", "0"}).exit_code, 0);
  for (const auto& row : table_of(path("rest.csv")).rows) EXPECT_EQ(row[1], 1);
}

TEST_F(Curves, BadOptionsAreOneLine) {
  const std::vector<std::pair<std::string, std::string>> bad = {
      {"--speeds", "1"},
      {"--speeds", "-0.1"},
      {"--speeds", "nan"},
      {"--speeds", "inf"},
      {"--speeds", "0.5,"},
      {"--speeds", ",0.5"},
      {"--speeds", "0.5;6"},
      {"--speeds", "fast"},
      {"--speeds", "1e999"},
      {"--speeds", "0.5,0.5"},
      {"--step", "0"},
      {"--step", "-1"},
      {"--step", "nan"},
      {"--step", "91"},
      {"--output", "x.png"},
      {"--output", "svg"},
      {"--spedes", "0.5"},
      {"--max-bytes", "1"},
      {"--speeds", "0,.1,.2,.3,.4,.5,.6,.7,.8"}};
  for (const auto& [option, value] : bad) {
    SCOPED_TRACE(option + " " + value);
    expect_error(curves({option + "=" + value}), 2, {option});
  }
  EXPECT_FALSE(fs::exists(path("out")));
}

TEST_F(Curves, AFullDiskLeavesNothing) {
  RunOptions options;
  options.largest_file = 300;
  EXPECT_EQ(curves({"-o", "full/c.svg"}, options).exit_code, 3);
  EXPECT_TRUE(fs::is_empty(path("full")));
}

TEST_F(Curves, ThePictureOfFigure5IsWhatTheProgramDraws) {
  ASSERT_EQ(curves().exit_code, 0);
  EXPECT_EQ(bytes_of(path("out/curves.svg")),
            bytes_of(fs::path(RESTFRAME_SOURCE_DIR) / "scenes/fig05_curves/picture.svg"));
}

}  // namespace
}  // namespace restframe
