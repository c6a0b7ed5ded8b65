// What pictures of another scene or program are told apart by.

#include "app/provenance.h"

#include <gtest/gtest.h>

namespace restframe {
namespace {

Provenance made_by(const std::string& program) {
  return {"render.samples = 4\n", "1234 ball.glb\n", program};
}

TEST(Provenance, KnowsThePrograms) {
  const Provenance now = made_by("restframe 1.2.3");
  EXPECT_EQ(difference(now, now), "");
  EXPECT_EQ(difference(made_by("restframe 1.2.10"), now), "");
  EXPECT_EQ(difference(made_by("restframe 1.1.3"), now),
            "by restframe 1.1.3, this is restframe 1.2.3");
  EXPECT_EQ(difference(made_by("restframe 0.2.3"), now),
            "by restframe 0.2.3, this is restframe 1.2.3");
}

TEST(Provenance, NamesWhatHasChanged) {
  const Provenance now = made_by("restframe 1.2.3");
  Provenance before = now;
  before.settings = "render.samples = 8\n";
  EXPECT_EQ(difference(before, now), "render.samples was 8, is 4");
  before.sources = "1235 ball.glb\n";
  EXPECT_EQ(difference(before, now), "ball.glb has changed");
}

TEST(Provenance, ComesBackFromTexts) {
  const Provenance now = made_by("restframe 1.2.3");
  const Provenance back = provenance_in(texts_of(now));
  EXPECT_EQ(back.settings, now.settings);
  EXPECT_EQ(back.sources, now.sources);
  EXPECT_EQ(back.program, now.program);
}

}  // namespace
}  // namespace restframe
