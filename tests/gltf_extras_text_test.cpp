// What an asset's author writes in extras.restframe, as values with places.

#include <gmock/gmock.h>

#include "importers/json_config.h"
#include "importers/toml_reader.h"

namespace restframe {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using ::testing::StartsWith;

class ExtrasText : public ::testing::Test {
 protected:
  std::optional<ConfigTable> parse(const std::string& text) {
    return parse_json_or_toml(text, place, faults);
  }

  std::vector<std::string> lines() const {
    try {
      faults.throw_any();
    } catch (const InputError& error) {
      return error.faults();
    }
    return {};
  }

  // The only fault of a text that is no table.
  std::string fault_of(const std::string& text) {
    EXPECT_FALSE(parse(text)) << text;
    EXPECT_THAT(lines(), SizeIs(1)) << text;
    return lines().empty() ? "" : lines()[0];
  }

  FaultList faults{"scene.toml"};
  int place = faults.add_place("car.glb:/nodes/3/extras/restframe");
};

TEST_F(ExtrasText, ObjectsAreTables) {
  const auto table = parse(R"({"velocity": [0, 0.5, -1e-3], "clock": "frame", "time": 7,
                               "deep": {"yes": true, "none": null}})");
  ASSERT_TRUE(table);
  TableReader reader(*table, {faults, "node"});
  EXPECT_EQ(*reader.vector("velocity"), Vec3(0, 0.5, -1e-3));
  EXPECT_EQ(*reader.text("clock"), "frame");
  EXPECT_EQ(*reader.whole_number("time", 0, 10), 7);
  EXPECT_EQ(*TableReader(*reader.table("deep"), {faults, ""}).boolean("yes"), true);
  EXPECT_THAT(lines(), ElementsAre());
}

TEST_F(ExtrasText, FaultsNameTheJsonPointer) {
  const auto table = parse(R"({"velocity": [0, "x", 0], "a/b~c": 1, "time": null})");
  ASSERT_TRUE(table);
  TableReader reader(*table, {faults, "node \"a\""});
  reader.vector("velocity");
  reader.number("time");
  reader.finish();
  EXPECT_THAT(
      lines(),
      ElementsAre("car.glb:/nodes/3/extras/restframe/velocity/1: node \"a\": velocity[1] is "
                  "a text, must be a number",
                  "car.glb:/nodes/3/extras/restframe/a~1b~0c: node \"a\": unknown key "
                  "\"a/b~c\", the nearest known one is \"time\" (known here: velocity, "
                  "time)",
                  "car.glb:/nodes/3/extras/restframe/time: node \"a\": time is null, must "
                  "be a number"));
}

TEST_F(ExtrasText, StringsAreToml) {
  const auto table = parse(R"("# moves\nvelocity = [0, 0, 2]\n[inner]\nwrong = 1")");
  ASSERT_TRUE(table);
  TableReader reader(*table, {faults, "node"});
  reader.vector("velocity", from_to(-1, 1));
  TableReader(*reader.table("inner"), {faults, "node: inner"}).finish();
  EXPECT_THAT(lines(),
              ElementsAre(StartsWith("car.glb:/nodes/3/extras/restframe:2:19: node: velocity[2] is "
                                     "2, must be from -1 to 1"),
                          StartsWith("car.glb:/nodes/3/extras/restframe:4:1: node: inner: unknown "
                                     "key \"wrong\"")));
}

TEST_F(ExtrasText, SyntaxOfToml) {
  EXPECT_THAT(fault_of(R"("velocity = \n")"),
              StartsWith("car.glb:/nodes/3/extras/restframe:1:12: "));
}

TEST_F(ExtrasText, OtherKinds) {
  EXPECT_EQ(
      fault_of("[1, 2]"),
      "car.glb:/nodes/3/extras/restframe: is an array, must be an object, or TOML in a string");
}

TEST_F(ExtrasText, Null) {
  EXPECT_THAT(fault_of("null"), HasSubstr("is null, must be an object"));
}

TEST_F(ExtrasText, NoJson) {
  EXPECT_THAT(fault_of("{\"a\": "), HasSubstr("restframe: not JSON from character"));
}

TEST_F(ExtrasText, NumbersBeyondDouble) {
  EXPECT_THAT(fault_of("{\"a\": 1e999}"), HasSubstr("not JSON"));
}

TEST_F(ExtrasText, KeysTwice) {
  EXPECT_EQ(fault_of(R"({"a": {"b": 1, "b": 2}})"),
            "car.glb:/nodes/3/extras/restframe/a: key \"b\" is there twice");
}

TEST_F(ExtrasText, TooDeep) {
  EXPECT_THAT(fault_of("{\"a\": " + std::string(100'000, '[')), HasSubstr("deeper than 32"));
}

TEST_F(ExtrasText, TooDeepInToml) {
  EXPECT_THAT(fault_of("\"a" + std::string(100'000, '.') + " = 1\""), HasSubstr("deeper than 32"));
}

TEST_F(ExtrasText, LargeNumbers) {
  const auto table = parse(R"({"a": 9223372036854775807, "b": 18446744073709551615})");
  ASSERT_TRUE(table);
  TableReader reader(*table, {faults, ""});
  EXPECT_EQ(*reader.whole_number("a", 0, std::numeric_limits<std::int64_t>::max()),
            std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(*reader.number("b"), 18446744073709551616.0);
}

TEST_F(ExtrasText, PlacesComeAfterTheFileAndInOrder) {
  faults.add({0, 0, place}, "second");
  faults.add({5, 3}, "first");
  EXPECT_THAT(lines(),
              ElementsAre("scene.toml:5:3: first", "car.glb:/nodes/3/extras/restframe: second"));
}

}  // namespace
}  // namespace restframe
