// Every limit is an option, of every command that reads files.

#include "support/hostile_gltf.h"

namespace restframe {
namespace {

using test::HostileGltf;

class HostileLimits : public HostileGltf {
 protected:
  HostileLimits() {
    test::GltfBuilder builder = test::one_triangle();
    const std::string image = test::png(2, 2, std::string(16, 'x'));
    builder.add_view(image.data(), image.size());
    builder.add("images", {{"bufferView", 2}, {"mimeType", "image/png"}});
    builder.add("textures", {{"source", 0}});
    builder.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    auto& primitives = builder.json["meshes"][0]["primitives"];
    primitives[0]["material"] = 0;
    primitives.push_back(primitives[0]);
    builder.json["nodes"].push_back({{"mesh", 0}});
    folder.write("a.glb", builder.glb());
  }

  // The lower limit refuses the file, and says so; the higher one does not.
  void expect_limit(const std::string& option, const std::string& refusing,
                    const std::string& allowing, const std::string& message) const {
    for (const char* command : {"render", "info", "check"}) {
      SCOPED_TRACE(command + (" " + option));
      std::vector<std::string> arguments = {command, "a.glb", option, refusing};
      const RunResult refused = run(arguments);
      EXPECT_EQ(refused.exit_code, 2);
      EXPECT_THAT(refused.error, ::testing::HasSubstr("error: a.glb:"));
      EXPECT_THAT(refused.error, ::testing::HasSubstr(message));
      if (std::string(command) == "render") continue;
      arguments.back() = allowing;
      EXPECT_EQ(run(arguments).exit_code, 0);
    }
  }
};

TEST_F(HostileLimits, AreOptions) {
  expect_limit("--max-json-bytes", "100", "10000",
               "the limit is 100 bytes; --max-json-bytes raises it");
  expect_limit("--max-json-depth", "5", "20",
               "deeper than the limit of 5; --max-json-depth raises it");
  expect_limit("--max-nodes", "1", "2", "the limit is 1");
  expect_limit("--max-triangles", "1", "2", "more than 1 triangles in all; --max-triangles raises");
  expect_limit("--max-image-pixels", "3", "4",
               "the limit is 3 pixels; --max-image-pixels raises it");
  expect_limit("--max-bytes", "500", "100000", "the limit is 500 bytes");
}

TEST_F(HostileLimits, AreWholeNumbers) {
  for (const char* option : {"--max-json-bytes", "--max-json-depth", "--max-nodes",
                             "--max-triangles", "--max-image-pixels", "--max-bytes"}) {
    for (const char* value : {"-1", "x", "1.5", "99999999999999999999999", ""}) {
      SCOPED_TRACE(std::string(option) + "=" + value);
      const RunResult result = run({"check", "a.glb", std::string(option) + "=" + value});
      EXPECT_EQ(result.exit_code, 2) << result.out;
      EXPECT_THAT(result.error, ::testing::HasSubstr(option));
      EXPECT_EQ(std::count(result.error.begin(), result.error.end(), '\n'), 1) << result.error;
    }
  }
  // Deeper documents would need more stack than there may be.
  EXPECT_EQ(run({"check", "a.glb", "--max-json-depth=1001"}).exit_code, 2);
}

TEST_F(HostileLimits, AHundredWarningsAreEnough) {
  test::GltfBuilder builder = test::one_triangle();
  for (int i = 0; i < 300; ++i) builder.json["meshes"].push_back(builder.json["meshes"][0]);
  folder.write("many.glb", builder.glb());
  const RunResult result = run({"check", "many.glb"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(std::count(result.error.begin(), result.error.end(), '\n'), 101);
  EXPECT_THAT(result.error, ::testing::HasSubstr("and 200 warnings more"));
}

TEST_F(HostileLimits, AreInTheHelp) {
  const RunResult help = run({"render", "--help"});
  for (const char* text :
       {"--max-json-bytes", "=64000000", "--max-json-depth", "=64", "--max-nodes", "=1000000",
        "--max-triangles", "=50000000", "--max-image-pixels", "--max-bytes", "=4000000000"}) {
    EXPECT_THAT(help.out, ::testing::HasSubstr(text));
  }
}

}  // namespace
}  // namespace restframe
