// Functions of time from CSV files.

#include <gmock/gmock.h>

#include <cmath>

#include "importers/csv_function.h"
#include "scene/temporal_evaluator.h"
#include "support/scene_reading.h"

namespace restframe {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

class Csv : public SceneReading {
 protected:
  KeyFunction number(const std::string& text, CsvRequest request = {{}, {"B"}, {}, {}, {}},
                     const ValueRule& rule = {}) {
    return read_csv_function(folder.write("run.csv", text), request, rule);
  }

  KeyFunction color(const std::string& text, const CsvRequest& request) {
    return number(text, request, {true, from_to(0, 1)});
  }

  // The faults of the file, without its path.
  std::vector<std::string> csv_faults(const std::string& text,
                                      const CsvRequest& request = {{}, {"B"}, {}, {}, {}},
                                      const ValueRule& rule = {}) {
    try {
      number(text, request, rule);
    } catch (const InputError& error) {
      std::vector<std::string> lines = error.faults();
      const std::string file = (folder.path() / "run.csv").string() + ":";
      for (std::string& line : lines) {
        EXPECT_EQ(line.find('\n'), std::string::npos) << line;
        if (line.starts_with(file)) line.erase(0, file.size());
      }
      return lines;
    }
    return {};
  }

  void expect_fault(const std::string& text, const std::string& begin, const std::string& words) {
    EXPECT_THAT(csv_faults(text),
                ElementsAre(::testing::AllOf(::testing::StartsWith(begin), HasSubstr(words))))
        << text.substr(0, 200);
  }

  // Times and first components of the keys.
  static std::vector<std::pair<double, float>> keys_of(const KeyFunction& function) {
    std::vector<std::pair<double, float>> keys;
    for (const KeyFunction::Key& key : function.keys) keys.emplace_back(key.time, key.value.x);
    return keys;
  }
};

using Keys = std::vector<std::pair<double, float>>;

TEST_F(Csv, TheFirstColumnIsTime) {
  EXPECT_EQ(keys_of(number("t,A,B\n0,9,0.5\n1.5,9,0.25\n")), (Keys{{0, 0.5F}, {1.5, 0.25F}}));
}

TEST_F(Csv, AnotherColumnMayBeTime) {
  EXPECT_EQ(keys_of(number("B,t\n0.5,-1\n0.25,1e1\n", {"t", {"B"}, {}, {}, {}})),
            (Keys{{-1, 0.5F}, {10, 0.25F}}));
}

TEST_F(Csv, EveryLineEndAndBlanksAndComments) {
  const Keys wanted{{0, 1}, {1, 2}};
  EXPECT_EQ(keys_of(number("t,B\r\n0,1\r\n1,2\r\n")), wanted);
  EXPECT_EQ(keys_of(number("t,B\r0,1\r1,2")), wanted);
  EXPECT_EQ(keys_of(number("\xEF\xBB\xBFt,B\n0,1\n1,2")), wanted) << "byte order mark";
  EXPECT_EQ(keys_of(number("# run 7\n\n  t ,\tB \n#,,\n 0 , 1\n\n   \n1,+2\n#end")), wanted);
}

TEST_F(Csv, Quotes) {
  const CsvRequest request{"the \"time\", s", {"a\nb"}, {}, {}, {}};
  const std::string text =
      "label,\"the \"\"time\"\", s\" , \"a\nb\"\n\"x,\ny\",\"0\",1\n#\nplain,\"1\" ,\"2\"\n";
  EXPECT_EQ(keys_of(number(text, request)), (Keys{{0, 1}, {1, 2}}));
}

TEST_F(Csv, TextInOtherColumnsIsFine) {
  EXPECT_EQ(keys_of(number("t,note,B\n0,warm,1\n1,,2\n")), (Keys{{0, 1}, {1, 2}}));
}

TEST_F(Csv, EqualTimesAreAJump) {
  EXPECT_EQ(keys_of(number("t,B\n0,0\n1,1\n1,5\n2,6\n")), (Keys{{0, 0}, {1, 1}, {1, 5}, {2, 6}}));
}

TEST_F(Csv, ColoursOfThreeColumnsOrBetweenTwo) {
  const KeyFunction three = color("t,R,G,B\n0,0.1,0.2,0.3\n", {{}, {"R", "G", "B"}, {}, {}, 2.0});
  EXPECT_EQ(three.keys.at(0).value, Vec3f(0.1F, 0.2F, 0.3F));
  EXPECT_EQ(three.period, 2.0);
  const KeyFunction mixed =
      color("t,B\n0,0\n1,0.25\n2,1\n", {{}, {"B"}, Vec3f(0, 1, 0.5F), Vec3f(1, 0, 0.5F), {}});
  EXPECT_EQ(mixed.keys.at(0).value, Vec3f(0, 1, 0.5F));
  EXPECT_EQ(mixed.keys.at(1).value, Vec3f(0.25F, 0.75F, 0.5F));
  EXPECT_EQ(mixed.keys.at(2).value, Vec3f(1, 0, 0.5F));
}

TEST_F(Csv, WholeFiles) {
  expect_fault("", "1:1: ", "empty");
  expect_fault("\n# only comments\n\n", "1:1: ", "empty");
  expect_fault("t,B\n", "1:1: ", "no row");
  expect_fault(std::string("t,B\n0,1\n\0", 9), "3:1: ", "NUL");
  expect_fault(std::string("t\0,\0B\0", 6), "1:1: ", "UTF-16");
}

TEST_F(Csv, LinesOfNames) {
  expect_fault("t,A,Bx\n0,1,2\n",
               "1:1: ", "no column \"B\", the nearest is \"t\" (columns: \"t\", \"A\", \"Bx\")");
  expect_fault("time,Temp,BB\n0,1,2\n", "1:1: ", "the nearest is \"BB\"");
  expect_fault("t,B,B\n0,1,2\n", "1:5: ", "two columns have the name \"B\"");
  expect_fault("0,1\n1,2\n", "1:1: ", "holds numbers, must name the columns");
  expect_fault("t;B\n0;1\n", "1:1: ", "divided by \";\", must be by commas");
  expect_fault("t\tB\n0\t1\n", "1:1: ", "must be by commas");
}

TEST_F(Csv, Rows) {
  expect_fault("t,B\n0,1\n1\n", "3:1: ", "1 fields, must have 2");
  expect_fault("t,B\n0,1\n1,2,3\n", "3:1: ", "3 fields, must have 2");
  expect_fault("t,B\n0,1\n1,\n", "3:3: ", "the value of \"B\" is missing");
  expect_fault("t,B\n,1\n", "2:1: ", "the time is missing");
  expect_fault("t,B\n0,high\n", "2:3: ", "\"high\" is not a finite number");
  expect_fault("t,B\n0,\"1,5\"\n", "2:3: ", "a point, not a comma");
  expect_fault("t,B\n0,nan\n", "2:3: ", "not a finite number");
  expect_fault("t,B\n0,1\ninf,1\n", "3:1: ", "the time: \"inf\" is not a finite number");
  expect_fault("t,B\n0,1e999\n", "2:3: ", "not a finite number");
  expect_fault("t,B\n0,1e39\n", "2:3: ", "is 1e+39, must be from -3.4e+38 to 3.4e+38");
  expect_fault("t,B\n1,1\n0,1\n", "3:1: ", "time 0 is out of order, the one before it is at 1");
  expect_fault("t,B\n1,1\n1,2\n1,3\n", "4:1: ", "third at that time");
  expect_fault("t,B\n0,\"1\n1,2\n", "2:3: ", "a quote is never closed");
  expect_fault("t,B\n0,\"1\"2\n", "2:6: ", "text after a closing quote");
}

TEST_F(Csv, ValuesOutOfRange) {
  const CsvRequest plain{{}, {"B"}, {}, {}, {}};
  EXPECT_THAT(csv_faults("t,B\n0,1.5\n", plain, {false, from_to(0, 1)}),
              ElementsAre(HasSubstr("2:3: the value of \"B\" is 1.5, must be from 0 to 1")));
  const CsvRequest mixed{{}, {"B"}, Vec3f(0), Vec3f(1), {}};
  EXPECT_THAT(csv_faults("t,B\n0,-0.5\n", mixed, {true, at_least(0)}),
              ElementsAre(HasSubstr("is -0.5, must be from 0 to 1")));
  const CsvRequest periodic{{}, {"B"}, {}, {}, 1.0};
  EXPECT_THAT(csv_faults("t,B\n0,1\n1,1\n1.5,1\n", periodic),
              ElementsAre(HasSubstr("4:1: the key at time 1.5 leaves the period, 0 to 1")));
}

TEST_F(Csv, EveryFaultIsListed) {
  EXPECT_THAT(csv_faults("t,B\nx,1\n0,y\n1\n2,3\n1,3\n"), SizeIs(4));
}

TEST_F(Csv, FilesTooWideOrTooLarge) {
  expect_fault("t,B" + std::string(20'000, ',') + "\n", "1:", "more than 10000 columns");
  const std::filesystem::path path = folder.write("big.csv", "t,B\n");
  std::filesystem::resize_file(path, 65'000'000);
  EXPECT_THROW(read_csv_function(path, {{}, {"B"}, {}, {}, {}}, {}), InputError);
}

const std::string ball =
    "[[object]]\nname = \"a\"\nsphere = {}\n[[material]]\nname = \"ball\"\n";  // five lines

TEST_F(Csv, InAScene) {
  folder.write("run.csv", "t,B,R,G\n0,0.5,0,1\n2,1,1,0\n");
  const Scene scene = read(ball +
                           "roughness = {file = \"run.csv\", column = \"B\"}\n"
                           "base_color = {file = \"run.csv\", columns = [\"R\", \"G\", \"B\"], "
                           "period = 4}\n"
                           "emission = {file = \"run.csv\", column = \"G\", from = \"black\", "
                           "to = [0, 8, 0], time = \"t\"}\n");
  ASSERT_EQ(scene.functions.size(), 3U);
  TemporalEvaluator evaluator(scene.functions);
  const Material& m = scene.materials.at(0);
  // Held before and after, straight between; with the period from the last row to the first.
  for (const auto& [t, b] : Keys{{-1, 0.5F}, {0, 0.5F}, {1, 0.75F}, {2, 1}, {9, 1}}) {
    EXPECT_FLOAT_EQ(evaluator(m.roughness, t), b) << t;
  }
  EXPECT_FLOAT_EQ(evaluator(m.base_color, 5.0).x, 0.5F);
  EXPECT_FLOAT_EQ(evaluator(m.emission, 1.0).y, 4);
  EXPECT_THAT(scene.sources, SizeIs(2));  // the scene and the table, once
}

TEST_F(Csv, WrongKeysInAScene) {
  folder.write("run.csv", "t,B,C\n0,0.5,1\n");
  folder.write("run.txt", "% interval 0 1 0.5\n");
  const auto fault = [&](const std::string& line, const std::string& begin,
                         const std::string& words) {
    EXPECT_THAT(faults(ball + line + "\n"),
                ElementsAre(::testing::AllOf(::testing::StartsWith(begin), HasSubstr(words))))
        << line;
  };
  fault("roughness = {file = \"run.csv\"}", "6:21: ", "needs a column");
  fault("roughness = {file = \"run.csv\", columns = [\"B\"]}", "6:32: ", "with a colour only");
  fault("roughness = {file = \"run.csv\", column = 3}", "6:41: ", "must be a text");
  fault("roughness = {file = \"run.csv\", column = \"B\", from = 0, to = 1}",
        "6:53: ", "from and to");
  fault("base_color = {file = \"run.csv\"}", "6:22: ", "needs columns, three names, or");
  fault("base_color = {file = \"run.csv\", column = \"B\"}", "6:42: ", "needs from and to");
  fault("base_color = {file = \"run.csv\", columns = [\"B\", \"C\"]}", "6:43: ", "three names");
  fault(
      "base_color = {file = \"run.csv\", column = \"B\", from = \"red\", to = \"blue\", columns = "
      "[\"B\", \"C\", \"B\"]}",
      "6:", "exclude");
  fault("roughness = {file = \"run.txt\", column = \"B\"}",
        "6:32: ", "column goes with a .csv file only");
  fault("roughness = {file = \"run.txt\", period = 1}",
        "6:32: ", "period goes with a .csv file only");
  fault("roughness = {keys = [[0, 1]], column = \"B\"}",
        "6:31: ", "column goes with a .csv file only");
  fault("roughness = {file = \"none.csv\", column = \"B\"}", "6:21: ", "no such file");
}

TEST_F(Csv, FaultsOfTheTableStandInTheScenesList) {
  folder.write("run.csv", "t,B\n0,hot\n");
  EXPECT_THAT(faults(ball + "roughness = {file = \"run.csv\", column = \"B\"}\n"),
              ElementsAre(HasSubstr("run.csv:2:3: the value of \"B\": \"hot\" is not")));
}

}  // namespace
}  // namespace restframe
