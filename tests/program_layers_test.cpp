// A file for each layer, two eyes, crops: what `restframe render` leaves of them, and how it resumes.

#include <gmock/gmock.h>

#include "app/picture_files.h"
#include "support/exr_reader.h"
#include "support/image_files.h"
#include "support/scene_folder.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* kScene = R"(
[camera]
position = [0, 0, 4]
direction = [0, 0, -1]
[camera.stereo]
separation = 0.3
convergence = 4
[animation]
pictures = 2
rate = 25
[render]
resolution = [20, 14]
overscan = 3
samples = 2
[output]
path = "out/shot_####.exr"
layers = ["beauty", "Z", "time"]
split = true
half = ["Z"]
[[object]]
name = "ball"
sphere = {radius = 1, fineness = 2}
)";

class LayerFiles : public testing::Test, public SceneFolder {
 protected:
  LayerFiles() : SceneFolder(kScene) {}

  fs::path out(const std::string& name) const { return path("out") / name; }
};

TEST(LayerPattern, HasTheLayerBeforeTheNumber) {
  EXPECT_EQ(layer_pattern("out/name.####.exr", "Z"), "out/name.Z.####.exr");
  EXPECT_EQ(layer_pattern("out/shot_####.exr", "beauty"), "out/shot_beauty_####.exr");
  EXPECT_EQ(layer_pattern("a-##.b.exr", "N"), "a-N-##.b.exr");
  EXPECT_EQ(layer_pattern("name####.exr", "N"), "name.N.####.exr");
  EXPECT_EQ(layer_pattern("out/####.exr", "N"), "out/N.####.exr");
  EXPECT_EQ(layer_pattern("####.exr", "N"), "N.####.exr");
  EXPECT_EQ(layer_pattern("####/name.exr", "N"), "####/name.N.exr");
  EXPECT_EQ(layer_pattern("out/still.exr", "N"), "out/still.N.exr");
}

TEST_F(LayerFiles, AreOneALayerWithBothViews) {
  const RunResult result = render();
  ASSERT_EQ(result.exit_code, 0) << result.error;
  EXPECT_THAT(result.out, HasSubstr("out/shot_beauty_0000.exr to out/shot_beauty_0001.exr"));
  for (const char* number : {"0000", "0001"}) {
    for (const char* layer : {"beauty", "Z", "time"}) {
      EXPECT_TRUE(fs::exists(out(std::string("shot_") + layer + "_" + number + ".exr"))) << layer;
    }
    EXPECT_TRUE(fs::exists(out(std::string("shot_") + number + ".png")));
    EXPECT_FALSE(fs::exists(out(std::string("shot_") + number + ".exr")));
  }
  const ExrPicture beauty = read_exr(out("shot_beauty_0001.exr"));
  EXPECT_EQ(beauty.channels.size(), 8U);
  EXPECT_TRUE(beauty.channels.contains("right.A"));
  EXPECT_EQ(beauty.attributes.at("dataWindow"), "-3 -3 22 16");
  EXPECT_EQ(beauty.attributes.at("displayWindow"), "0 0 19 13");
  EXPECT_EQ(beauty.attributes.at("timeCode"), "00:00:00:01");
  const ExrPicture z = read_exr(out("shot_Z_0001.exr"));
  EXPECT_EQ(z.types.at("Z"), "half");
  EXPECT_EQ(z.types.at("right.Z"), "half");
  EXPECT_FALSE(z.channel("Z") == z.channel("right.Z"));
  EXPECT_EQ(read_exr(out("shot_time_0000.exr")).channels.size(), 4U);
}

TEST_F(LayerFiles, AreAllThereOrMadeAgain) {
  ASSERT_EQ(render().exit_code, 0);
  const std::string before = bytes_of(out("shot_time_0001.exr"));
  fs::resize_file(out("shot_time_0001.exr"), before.size() / 2);
  fs::remove(out("shot_Z_0000.exr"));
  const RunResult again = render();
  EXPECT_EQ(again.exit_code, 0) << again.error;
  EXPECT_THAT(again.out, HasSubstr("2 of 2 pictures made"));
  EXPECT_TRUE(bytes_of(out("shot_time_0001.exr")) == before);
  EXPECT_TRUE(fs::exists(out("shot_Z_0000.exr")));
  EXPECT_THAT(render().out, HasSubstr("0 of 2 pictures made"));
  change_scene("radius = 1", "radius = 0.5");
  const RunResult refused = render();
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.error, HasSubstr("--overwrite"));
}

// Of both eyes, and of a window that is no multiple of a tile.
TEST_F(LayerFiles, AreTheSameFromShares) {
  change_scene("resolution = [20, 14]", "resolution = [61, 47]");
  ASSERT_EQ(render().exit_code, 0);
  for (const char* tile : {"1/3", "2/3", "3/3"}) {
    ASSERT_EQ(render({"-o", "shares/s_####.exr", "--tile", tile}).exit_code, 0);
  }
  const RunResult merged = run("merge", {"-o", "shares/s_####.exr"});
  ASSERT_EQ(merged.exit_code, 0) << merged.error;
  for (const char* name : {"beauty_0000.exr", "Z_0001.exr", "time_0001.exr", "0000.png"}) {
    EXPECT_TRUE(bytes_of(out(std::string("shot_") + name)) ==
                bytes_of(out(std::string("../shares/s_") + name)))
        << name;
  }
}

TEST_F(LayerFiles, ShowTheLeftEyeAndAllThatIsRendered) {
  ASSERT_EQ(render({"--contact-sheet", "sheet.png"}).exit_code, 0);
  EXPECT_TRUE(fs::exists(out("../sheet.png")));
  change_scene("[camera.stereo]\nseparation = 0.3\nconvergence = 4\n", "");
  ASSERT_EQ(render({"-o", "mono/p.#.exr"}).exit_code, 0);
  EXPECT_FALSE(read_exr(out("../mono/p.beauty.0.exr")).attributes.contains("multiView"));
}

TEST_F(LayerFiles, OfHalfSayWhatTheyCouldNotHold) {
  change_scene("{radius = 1, fineness = 2}",
               "{radius = 90000, fineness = 2}\nposition = [0, 0, -200000]");
  const RunResult result = render({"-p", "0"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.error, HasSubstr("beyond what half holds"));
}

TEST_F(LayerFiles, FaultsAreTold) {
  change_scene("half = [\"Z\"]", "half = [\"time\"]");
  EXPECT_THAT(render().error, HasSubstr("half: \"time\" must stay float"));
  change_scene("half = [\"Z\"]", "half = [\"N\"]");
  EXPECT_THAT(render().error, HasSubstr("half: \"N\" is not among `layers`"));
  change_scene("half = [\"Z\"]", "half = [\"Z\"]\nfloat = [\"Z\"]");
  EXPECT_THAT(render().error, HasSubstr("half: \"Z\" is named by float, too"));
  change_scene("half = [\"Z\"]", "compression_level = -1");
  EXPECT_THAT(render().error, HasSubstr("compression_level is -1"));
}

}  // namespace
}  // namespace restframe
