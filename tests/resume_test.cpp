// `restframe render` a second time: which previews are made again, what a changed scene is refused for; and
// that a picture is the same whichever others are asked for with it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "support/program_errors.h"
#include "support/resumed_animation.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using Resume = ResumedAnimation;

TEST_F(Resume, APreviewThatIsNotWholeIsMadeAgain) {
  make({"-p", "0-1"});
  const std::string exr = content("p.1.exr"), png = content("p.1.png");
  ASSERT_GT(png.size(), 60U);
  const auto expect_new_preview = [&](const std::string& what) {
    const RunResult result = render({"-p", "0-1"});
    EXPECT_THAT(result.out, HasSubstr("0 of 2 pictures made")) << what;
    EXPECT_TRUE(content("p.1.png") == png) << what;
    EXPECT_TRUE(content("p.1.exr") == exr) << what;
  };
  fs::remove(path("p.1.png"));
  expect_new_preview("no preview");
  for (const std::size_t left : {std::size_t{0}, std::size_t{7}, std::size_t{30}, png.size() - 1}) {
    write("p.1.png", png.substr(0, left));
    expect_new_preview(fmt::format("{} bytes of the preview", left));
  }
  write("p.1.png", png.substr(0, 40) + std::string(png.size() - 40, '\0'));
  expect_new_preview("zeros");
}

// From the picture, that is not rendered again, and as rendering it would have made it: half and float,
// in one file or several, of one eye or two, light apart from data.
TEST_F(Resume, APreviewIsDevelopedFromItsPicture) {
  const auto with = [](const std::string& keys) {
    std::string scene = kResumedScene;
    return scene.replace(scene.find("layers ="), 0, keys);
  };
  for (const std::string& scene :
       {with(""), with("float = [\"beauty\"]\n"), with("split = true\n"),
        with("compression = \"pxr24\"\n"),
        kResumedScene +
            std::string(
                "[camera]\nposition = [0.5, 0.5, 3]\n[camera.stereo]\nseparation = 0.1\n")}) {
    write("scene.toml", scene);
    make({"-p", "0-1", "--overwrite"});
    const std::string plain = content("p.1.png");
    const std::vector<std::string> filmic = {"-p", "0-1", "--view", "filmic", "--exposure", "1"};
    EXPECT_THAT(render(filmic).out, HasSubstr("0 of 2 pictures made")) << scene;
    const std::string developed = content("p.1.png");
    EXPECT_FALSE(developed == plain) << scene;
    EXPECT_THAT(render({"-p", "0-1"}).out, HasSubstr("0 of 2 pictures made")) << scene;
    EXPECT_TRUE(content("p.1.png") == plain) << scene;
    std::vector<std::string> again = filmic;
    again.emplace_back("--overwrite");
    make(again);
    EXPECT_TRUE(content("p.1.png") == developed) << scene;
  }
}

TEST_F(Resume, APreviewOfAnotherPictureIsMadeAgain) {
  make({"-p", "0-1"});
  const std::string png = content("p.1.png");
  fs::copy_file(path("p.0.png"), path("p.1.png"), fs::copy_options::overwrite_existing);
  EXPECT_THAT(render({"-p", "0-1"}).out, HasSubstr("0 of 2 pictures made"));
  EXPECT_TRUE(content("p.1.png") == png);
}

TEST_F(Resume, NoPreviewIsMissedWhereNoneIsWanted) {
  change_scene("[output]", "[output]\npreview = false");
  make();
  EXPECT_FALSE(exists("p.1.png"));
  EXPECT_THAT(render().out, HasSubstr("0 of 4 pictures made"));
}

TEST_F(Resume, AChangedAssetIsNamed) {
  make();
  write("square.obj", std::string(kSquare) + "v 2 2 2\nf 1 2 5\n");
  expect_refused(render(), {"p.0.exr", "square.obj has changed", "--overwrite"});
}

TEST_F(Resume, AChangedSettingIsNamedWithBothValues) {
  make();
  change_scene("rate = 25", "rate = 24");
  expect_refused(render(), {"p.0.exr", "animation.rate was 25, is 24"});
}

TEST_F(Resume, WhatTheSceneFileSaysOtherwiseMakesNoDifference) {
  make();
  change_scene("rate = 25", "# as films in Europe\nrate = 25.0");
  EXPECT_THAT(render().out, HasSubstr("0 of 4 pictures made"));
}

TEST_F(Resume, AnAnimationMayGrow) {
  make();
  change_scene("pictures = 4", "pictures = 6");
  EXPECT_THAT(render().out, HasSubstr("2 of 6 pictures made, 4 were there already"));
}

TEST_F(Resume, AnotherPictureUnderTheNameIsRefused) {
  make({"-p", "1", "-o", "x.exr"});
  const std::string before = content("x.exr");
  expect_refused(render({"-p", "2", "-o", "x.exr"}), {"x.exr", "it is picture 1, not 2"});
  EXPECT_TRUE(content("x.exr") == before);
}

TEST_F(Resume, AnyChoiceOfPicturesGivesTheSameFiles) {
  make();
  std::vector<std::string> whole, previews;
  for (int i = 0; i < 4; ++i) {
    whole.push_back(content(fmt::format("p.{}.exr", i)));
    previews.push_back(content(fmt::format("p.{}.png", i)));
  }
  int folder = 0;
  for (const char* choice : {"2", "2-2", "1-3:2,2", "0-3:9,3-3:1,2,2"}) {
    const std::string name = fmt::format("{}/p.", folder++);
    make({"-p", choice, "-o", name + "#.exr"});
    EXPECT_TRUE(content(name + "2.exr") == whole[2]) << choice;
    EXPECT_TRUE(content(name + "2.png") == previews[2]) << choice;
  }
  EXPECT_FALSE(exists("0/p.0.exr") || exists("0/p.1.exr") || exists("2/p.0.exr"));
  EXPECT_TRUE(content("2/p.1.exr") == whole[1] && content("2/p.3.exr") == whole[3]);
  EXPECT_TRUE(exists("3/p.0.exr") && !exists("3/p.1.exr") && exists("3/p.3.exr"));
}

TEST_F(Resume, ChoicesThatAreNoneAreRefused) {
  for (const char* choice : {"", "-", "1-", "-1", "3-1", "0-3:0", "0-3:-1", "0-3:", "1:2", "1,",
                             ",1", "1,,2", "a", "0-3:1x", "0--3", "99999999999"}) {
    expect_refused(render({fmt::format("--pictures={}", choice)}), {"--pictures"});
  }
  expect_refused(render({"-p", "0-4"}), {"there is no picture 4; the last one is 3"});
  expect_refused(render({"-p", "0-2000000000:2000000000"}), {"there is no picture 2000000000"});
}

}  // namespace
}  // namespace restframe
