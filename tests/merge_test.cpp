// One picture by several machines: `restframe render --tile`, and `restframe merge`; and the part files from
// which a picture goes on that was interrupted.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>

#include "app/part_files.h"
#include "app/render_picture.h"
#include "importers/importers.h"
#include "support/exr_reader.h"
#include "support/program_errors.h"
#include "support/scene_folder.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

// 3 x 2 tiles, those at the edges smaller.
constexpr const char* kScene = R"(
[animation]
pictures = 3
[render]
resolution = [70, 50]
samples = 3
[output]
path = "p.#.exr"
layers = ["beauty", "Z", "time", "N", "samples"]
[[object]]
sphere = {radius = 1, fineness = 3}
velocity = [0.5, 0, 0]
)";

constexpr const char* kLight = R"(
[render]
resolution = [70, 50]
integrator = "path"
doppler = true
samples = 24
noise = 0.1
[exposure]
count = 2
[output]
path = "p.#.exr"
layers = ["beauty", "time", "variance", "samples"]
[[object]]
sphere = {radius = 1, fineness = 3}
velocity = [0.5, 0, 0]
[[light]]
type = "environment"
)";

class Merge : public testing::Test, public SceneFolder {
 protected:
  Merge() : SceneFolder(kScene) {}

  void make(const std::string& command, const std::vector<std::string>& options = {}) const {
    const RunResult result = run(command, options);
    ASSERT_EQ(result.exit_code, 0) << result.error;
  }
  void make_tile(const std::string& tile, const std::string& pattern = "p.#.exr") const {
    make("render", {"--tile", tile, "-o", pattern});
  }
  void expect_merged(const std::string& pattern, int pictures) const {
    make("merge", {"-o", pattern});
    for (int i = 0; i < pictures; ++i) {
      for (const char* extension : {"exr", "png"}) {
        const std::string name = fmt::format("p.{}.{}", i, extension);
        EXPECT_TRUE(content(pattern.substr(0, pattern.size() - 7) + name) == content(name)) << name;
      }
    }
  }
  std::vector<std::string> names_in(const std::string& folder) const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(path(folder))) {
      names.push_back(entry.path().filename());
    }
    std::sort(names.begin(), names.end());
    return names;
  }
};

TEST_F(Merge, GivesTheSameFilesAsOneRendering) {
  make("render");
  for (const int parts : {1, 4, 8}) {  // of 8, two have no tile
    const std::string pattern = fmt::format("{}/p.#.exr", parts);
    for (int part = parts; part >= 1; --part) make_tile(fmt::format("{}/{}", part, parts), pattern);
    EXPECT_FALSE(exists(fmt::format("{}/p.0.exr", parts)));
    expect_merged(pattern, 3);
    EXPECT_THAT(names_in(std::to_string(parts)),
                ElementsAre("p.0.exr", "p.0.png", "p.1.exr", "p.1.png", "p.2.exr", "p.2.png"));
  }
}

TEST_F(Merge, KeepsLightTransportToTheBit) {
  write("scene.toml", kLight);
  make("render");
  for (const char* tile : {"1/2", "2/2"}) make_tile(tile, "2/p.#.exr");
  expect_merged("2/p.#.exr", 1);
}

TEST_F(Merge, JoinsBothEyesOfACrop) {
  std::string text = kScene;
  const std::string size = "resolution = [70, 50]\n";
  text.replace(text.find(size), size.size(), size + "crop = [10, 5, 50, 40]\n");
  write("scene.toml", "[camera]\nposition = [0, 0, 4]\n[camera.stereo]\nseparation = 0.1\n" + text);
  make("render");
  for (const char* tile : {"1/2", "2/2"}) make_tile(tile, "2/p.#.exr");
  expect_merged("2/p.#.exr", 3);
}

TEST_F(Merge, WritesAFileALayer) {
  change_scene("[output]\n", "[output]\nsplit = true\n");
  make("render");
  for (const char* tile : {"1/2", "2/2"}) make_tile(tile, "2/p.#.exr");
  make("merge", {"-o", "2/p.#.exr"});
  const std::vector<std::string> names = names_in("2");
  EXPECT_EQ(names.size(), 3U * (5 + 1));
  for (const std::string& name : names) EXPECT_TRUE(content("2/" + name) == content(name)) << name;
}

TEST_F(Merge, SharesAreEvenAndDisjoint) {
  std::vector<int> uses(1000);
  for (int part = 1; part <= 16; ++part) {
    const auto tiles = tiles_of({part, 16}, uses.size());
    EXPECT_TRUE(tiles.size() == 62 || tiles.size() == 63);
    for (const std::size_t tile : tiles) ++uses[tile];
  }
  EXPECT_THAT(uses, testing::Each(1));
}

TEST_F(Merge, PartsAreNamedSoThatTheySort) {
  EXPECT_EQ(share_path("a/p.0007.exr", {3, 16}), "a/p.0007.exr.part-03-of-16");
  EXPECT_EQ(share_path("p.exr", {12, 9999}), "p.exr.part-0012-of-9999");
  for (const char* name : {"p.exr.part-03-of-16", "p.exr.part-0012-of-9999", "p.exr.part-3-of-16",
                           "p.exr.part-17-of-16", "p.exr.part-03-of-16x", "p.exr.part",
                           "p2.exr.part-01-of-16", "p.exr.part--3-of-16"}) {
    write(name, "");
  }
  std::vector<std::string> found;
  for (const FoundShare& share : shares_of(path("p.exr"))) {
    found.push_back(share.path.filename());
  }
  EXPECT_THAT(found,
              testing::UnorderedElementsAre("p.exr.part-03-of-16", "p.exr.part-0012-of-9999"));
}

TEST_F(Merge, MissingPartsAreNamedBeforeAnythingIsWritten) {
  expect_refused(run("merge"), {"p.0.exr", "no part", "2 pictures more"});
  for (const char* tile : {"1/4", "3/4"}) make_tile(tile);
  expect_refused(run("merge"), {"p.0.exr: parts 2, 4 of 4 are missing", "2 pictures more"});
  make_tile("2/4");
  make_tile("4/4");
  fs::remove(path("p.2.exr.part-03-of-4"));
  expect_refused(run("merge"), {"p.2.exr: part 3 of 4 is missing"});
  EXPECT_FALSE(exists("p.0.exr"));
  make("merge", {"-p", "0-1"});
  EXPECT_TRUE(exists("p.1.exr"));
}

TEST_F(Merge, PartsOfAnotherSceneAreRefused) {
  make_tile("1/2");
  change_scene("fineness = 3", "fineness = 2");
  make_tile("2/2");
  expect_refused(run("merge"), {"p.0.exr.part-01-of-2", "another scene"});
  write("scene.toml", kScene);
  expect_refused(run("merge"), {"p.0.exr.part-02-of-2", "another scene"});
  expect_refused(run("merge", {"--size", "71x50"}), {"render.resolution was 70 50, is 71 50"});
  EXPECT_FALSE(exists("p.0.exr"));
}

TEST_F(Merge, DamagedPartsAreNamed) {
  for (const char* tile : {"1/2", "2/2"}) make_tile(tile);
  const std::string whole = content("p.0.exr.part-02-of-2");
  for (const std::size_t left : {std::size_t{0}, whole.size() / 2, whole.size() - 1}) {
    write("p.0.exr.part-02-of-2", whole.substr(0, left));
    expect_refused(run("merge"), {"p.0.exr.part-02-of-2: is damaged", "--tile 2/2"});
  }
  EXPECT_THAT(run("render", {"--tile", "2/2"}).out, HasSubstr("tile 2/2 of 1 of 3 pictures made"));
  EXPECT_TRUE(content("p.0.exr.part-02-of-2") == whole);
}

TEST_F(Merge, KeepsPartsWhereToldSoAndClearsUpLater) {
  for (const char* tile : {"1/2", "2/2"}) make_tile(tile);
  make("merge", {"--keep"});
  EXPECT_TRUE(exists("p.0.exr") && exists("p.0.exr.part-01-of-2"));
  EXPECT_THAT(run("render", {"--tile", "1/2"}).out, HasSubstr("tile 1/2 of 0 of 3 pictures made"));
  EXPECT_THAT(run("merge").out, HasSubstr("0 of 3 pictures made"));
  EXPECT_FALSE(exists("p.0.exr.part-01-of-2"));
}

TEST_F(Merge, ATileThatIsThereIsKept) {
  make_tile("2/3");
  const auto time = fs::last_write_time(path("p.1.exr.part-02-of-3"));
  fs::remove(path("p.0.exr.part-02-of-3"));
  EXPECT_THAT(run("render", {"--tile", "2/3"}).out, HasSubstr("tile 2/3 of 1 of 3 pictures made"));
  EXPECT_EQ(fs::last_write_time(path("p.1.exr.part-02-of-3")), time);
  change_scene("samples = 3", "samples = 4");
  expect_refused(run("render", {"--tile", "2/3"}),
                 {"p.0.exr.part-02-of-3", "render.samples was 3, is 4", "--overwrite"});
  make("render", {"--tile", "2/3", "--overwrite"});
}

TEST_F(Merge, TilesThatAreNoneAreRefused) {
  for (const char* tile : {"", "0/3", "4/3", "1", "1/", "/3", "1/0", "-1/3", "1/-3", "a/b", "1/3x",
                           "1/10001", "1/99999999999"}) {
    expect_refused(run("render", {fmt::format("--tile={}", tile)}), {"--tile"});
  }
  expect_refused(run("render", {"--tile", "1/2", "--contact-sheet", "s.png"}), {"restframe merge"});
}

TEST_F(Merge, MayEndInAContactSheet) {
  make("render", {"--contact-sheet", "a.png"});
  for (const char* tile : {"1/2", "2/2"}) make_tile(tile, "x/p.#.exr");
  make("merge", {"-o", "x/p.#.exr", "--contact-sheet", "b.png"});
  EXPECT_TRUE(content("a.png") == content("b.png"));
}

class Checkpoint : public Merge {
 protected:
  // As if picture 0 had been interrupted when tiles 0 and 2 of 6 were done and, to be known again, all of
  // Z was 77 there.
  void interrupt_picture() const {
    make("render", {"--tile", "1/2", "-p", "0"});  // tiles 0, 2 and 4
    Warnings warnings;
    const Scene scene = load_scene(path("scene.toml"), {}, warnings);
    Picture picture = blank_picture(scene);
    const std::vector<PixelWindow> tiles = picture_tiles(picture.window());
    TileMarks read(tiles.size());
    const std::vector<PartView> views = {{"", picture, tiles, read}};
    const auto info = read_part(path("p.0.exr.part-01-of-2"), views);
    ASSERT_TRUE(info);
    for (Plane& plane : picture.planes()) {
      if (plane.name == "Z") std::fill(plane.values.begin(), plane.values.end(), 77.0F);
    }
    TileMarks done(tiles.size());
    done.mark(0);
    done.mark(2);
    const std::vector<PartView> written = {{"", picture, tiles, done}};
    ASSERT_TRUE(write_part(path("p.0.exr.part"), *info, written, std::atomic<bool>(false)));
    fs::remove(path("p.0.exr.part-01-of-2"));
  }
  // Where Z is 77 in the picture.
  int pixels_of_checkpoint() const {
    const std::vector<float> z = read_exr(path("p.0.exr")).channel("Z");
    return static_cast<int>(std::count(z.begin(), z.end(), 77.0F));
  }
};

TEST_F(Checkpoint, APictureGoesOnFromIt) {
  interrupt_picture();
  make("render", {"-p", "0"});
  EXPECT_EQ(pixels_of_checkpoint(), 32 * 32 + 6 * 32);
  EXPECT_THAT(names_in("."), ElementsAre("p.0.exr", "p.0.png", "scene.toml"));
}

TEST_F(Checkpoint, OfAnotherSceneIsRefusedUnlessOverwritten) {
  interrupt_picture();
  change_scene("samples = 3", "samples = 4");
  expect_refused(run("render"), {"p.0.exr.part", "render.samples was 3, is 4", "--overwrite"});
  EXPECT_FALSE(exists("p.0.exr"));
  make("render", {"--overwrite"});
  EXPECT_EQ(pixels_of_checkpoint(), 0);
  EXPECT_FALSE(exists("p.0.exr.part"));
}

TEST_F(Checkpoint, OfAnotherPictureIsRefused) {
  interrupt_picture();
  fs::rename(path("p.0.exr.part"), path("p.1.exr.part"));
  expect_refused(run("render"), {"p.1.exr.part", "it is of picture 0, not 1"});
}

TEST_F(Checkpoint, ATornOneIsNotUsed) {
  make("render", {"-p", "0", "-o", "whole.exr"});
  interrupt_picture();
  const std::string part = content("p.0.exr.part");
  write("p.0.exr.part", part.substr(0, part.size() - 100));
  make("render", {"-p", "0"});
  EXPECT_TRUE(content("p.0.exr") == content("whole.exr"));
  EXPECT_FALSE(exists("p.0.exr.part"));
}

// However often it is written meanwhile.
TEST_F(Checkpoint, ChangesNothing) {
  make("render", {"-p", "0", "--samples", "64", "-o", "whole.exr", "--checkpoint", "0"});
  make("render", {"-p", "0", "--samples", "64", "--checkpoint", "1e-6"});
  EXPECT_TRUE(content("p.0.exr") == content("whole.exr"));
  EXPECT_FALSE(exists("p.0.exr.part"));
}

TEST_F(Checkpoint, ThatCanNotBeWrittenIsAWarning) {
  fs::create_directory(path("p.0.exr.part"));
  const RunResult result =
      run("render", {"-p", "0", "--samples", "200", "--size", "300x300", "--checkpoint", "1e-6"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(std::count(result.error.begin(), result.error.end(), '\n'), 1) << result.error;
  EXPECT_THAT(result.error, AllOf(HasSubstr("warning"), HasSubstr("p.0.exr.part")));
  EXPECT_TRUE(exists("p.0.exr"));
}

}  // namespace
}  // namespace restframe
