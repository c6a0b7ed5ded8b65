// Part files: that they keep every bit of the tiles that are done, and that torn ones are known as such.

#include "film/part_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <thread>

#include "scene/error.h"
#include "support/file_bytes.h"
#include "support/temporary_folder.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr PixelWindow kWindow{-3, 5, 10, 7};
const std::vector<PixelWindow> kTiles = {{-3, 5, 4, 4}, {1, 5, 6, 4}, {-3, 9, 4, 3}, {1, 9, 6, 3}};
const std::vector<Layer> kLayers = {Layer::beauty, Layer::z, Layer::time, Layer::samples};
const std::atomic<bool> kGoOn{false};

// One whose pixels and planes all differ; times have more digits than a float.
struct View {
  Picture picture{kWindow, kLayers, {}};
  TileMarks done{kTiles.size()};

  void fill(double offset) {
    double value = offset;
    for (Vec4f& pixel : picture.rgba()) {
      for (int i = 0; i < 4; ++i) pixel[i] = static_cast<float>(value += 0.375);
    }
    for (Plane& plane : picture.planes()) {
      for (float& v : plane.values) v = static_cast<float>(value += 0.375);
      for (double& t : plane.times) t = 1.0 / (value += 0.375);
    }
    picture.planes()[0].values[0] = std::numeric_limits<float>::infinity();
    picture.planes()[1].times[0] = std::numeric_limits<double>::quiet_NaN();
    picture.rgba()[0].x = -0.0F;
  }
  PartView part(std::string name = "") { return {std::move(name), picture, kTiles, done}; }
};

template <class Pixels>
bool same_bits(const Pixels& a, const Pixels& b, std::size_t i) {
  return std::memcmp(&a[i], &b[i], sizeof a[i]) == 0;
}

// Of the pixels: how many are the same in all planes as in another picture.
int same_pixels(const Picture& a, const Picture& b, const PixelWindow& tile) {
  int same = 0;
  for (int y = tile.top; y < tile.bottom(); ++y) {
    for (int x = tile.left; x < tile.right(); ++x) {
      const std::size_t i = a.index(x, y);
      bool all = same_bits(a.rgba(), b.rgba(), i);
      for (std::size_t p = 0; p < a.planes().size(); ++p) {
        const Plane &of_a = a.planes()[p], &of_b = b.planes()[p];
        all = all && (of_a.kind == ChannelKind::plain ? same_bits(of_a.values, of_b.values, i)
                                                      : same_bits(of_a.times, of_b.times, i));
      }
      same += all ? 1 : 0;
    }
  }
  return same;
}

class PartFile : public testing::Test {
 protected:
  PartFile() {
    made_.fill(1);
    made_.done.mark(1);
    made_.done.mark(2);
    const std::vector<PartView> views = {made_.part()};
    EXPECT_TRUE(write_part(path(), info_, views, kGoOn));
  }
  fs::path path() const { return folder_.path() / "x.part"; }
  const TemporaryFolder& folder() const { return folder_; }

  View made_;
  PartInfo info_{7, {{"settings", "a = 1\nb = 2\n"}, {"empty", ""}}};

 private:
  TemporaryFolder folder_;
};

TEST_F(PartFile, KeepsEveryBitOfTheTilesThatAreDone) {
  View read;
  read.fill(1000);
  View untouched;
  untouched.fill(1000);
  const std::vector<PartView> views = {read.part()};
  const auto info = read_part(path(), views);
  ASSERT_TRUE(info);
  EXPECT_EQ(info->number, 7);
  EXPECT_EQ(info->texts, info_.texts);
  EXPECT_THAT(read.done.marked(), ElementsAre(1, 2));
  for (const std::size_t tile : {1U, 2U}) {
    EXPECT_EQ(same_pixels(read.picture, made_.picture, kTiles[tile]),
              kTiles[tile].width * kTiles[tile].height);
  }
  for (const std::size_t tile : {0U, 3U}) {
    EXPECT_EQ(same_pixels(read.picture, untouched.picture, kTiles[tile]),
              kTiles[tile].width * kTiles[tile].height);
  }
}

TEST_F(PartFile, TellsWhatIsDoneWithoutAPicture) {
  const auto summary = part_summary(path());
  ASSERT_TRUE(summary);
  EXPECT_EQ(summary->info.texts, info_.texts);
  EXPECT_THAT(summary->done, ElementsAre(ElementsAre(1, 2)));
}

TEST_F(PartFile, HoldsSeveralViews) {
  View right;
  right.fill(5);
  right.done.mark(0);
  const std::vector<PartView> views = {made_.part("left"), right.part("right")};
  ASSERT_TRUE(write_part(path(), info_, views, kGoOn));
  View a, b;
  const std::vector<PartView> into = {a.part("left"), b.part("right")};
  ASSERT_TRUE(read_part(path(), into));
  EXPECT_THAT(a.done.marked(), ElementsAre(1, 2));
  EXPECT_THAT(b.done.marked(), ElementsAre(0));
  EXPECT_EQ(same_pixels(b.picture, right.picture, kTiles[0]), 16);
  const std::vector<PartView> swapped = {a.part("right"), b.part("left")};
  EXPECT_FALSE(read_part(path(), swapped));
  const std::vector<PartView> one = {a.part("left")};
  EXPECT_FALSE(read_part(path(), one));
}

TEST_F(PartFile, TornOnesAreKnown) {
  const std::string whole = bytes_of(path());
  ASSERT_LT(whole.size(), 4000U);
  View read;
  const std::vector<PartView> views = {read.part()};
  const auto expect_torn = [&](const std::string& content, std::size_t at) {
    folder().write("x.part", content);
    EXPECT_FALSE(part_summary(path())) << at;
    EXPECT_FALSE(read_part(path(), views)) << at;
    EXPECT_THAT(read.done.marked(), IsEmpty());
  };
  for (std::size_t at = 0; at < whole.size(); at += 29) {
    expect_torn(whole.substr(0, at), at);
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 0x81);
    expect_torn(changed, at);
    expect_torn(whole.substr(0, at) + std::string(whole.size() - at, '\xff'), at);
  }
  expect_torn(whole.substr(0, whole.size() - 1), whole.size() - 1);
  expect_torn(whole + "x", whole.size());
  fs::remove(path());
  EXPECT_FALSE(part_summary(path()));
  EXPECT_FALSE(part_summary(folder().path()));
}

TEST_F(PartFile, OfAnotherShapeFitsNot) {
  TileMarks done(kTiles.size());
  Picture other_layers(kWindow, std::vector{Layer::beauty, Layer::z, Layer::time}, {});
  Picture other_window({-3, 5, 10, 8}, kLayers, {});
  Picture no_beauty(kWindow, std::vector{Layer::z, Layer::time, Layer::samples}, {});
  for (Picture* picture : {&other_layers, &other_window, &no_beauty}) {
    const std::vector<PartView> views = {{"", *picture, kTiles, done}};
    EXPECT_FALSE(read_part(path(), views));
  }
  EXPECT_THAT(done.marked(), IsEmpty());
}

TEST_F(PartFile, IsNotWrittenOnceItIsStopped) {
  const std::string before = bytes_of(path());
  made_.done.mark(0);
  const std::vector<PartView> views = {made_.part()};
  EXPECT_FALSE(write_part(path(), info_, views, std::atomic<bool>(true)));
  EXPECT_EQ(bytes_of(path()), before);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder().path()), {}), 1);
}

// Tiles are written while it is read what is done: whatever is marked is whole. (The thread sanitizer
// looks at this one, too.)
TEST(PartFileThreads, TilesMayBeDoneWhileItIsWritten) {
  const TemporaryFolder folder;
  View source;
  source.fill(1);
  View made;
  std::thread painter([&] {
    for (std::size_t tile = 0; tile < kTiles.size(); ++tile) {
      for (int y = kTiles[tile].top; y < kTiles[tile].bottom(); ++y) {
        for (int x = kTiles[tile].left; x < kTiles[tile].right(); ++x) {
          const std::size_t i = made.picture.index(x, y);
          made.picture.rgba()[i] = source.picture.rgba()[i];
          for (std::size_t p = 0; p < made.picture.planes().size(); ++p) {
            const Plane& from = source.picture.planes()[p];
            Plane& to = made.picture.planes()[p];
            if (from.kind == ChannelKind::plain) to.values[i] = from.values[i];
            if (from.kind != ChannelKind::plain) to.times[i] = from.times[i];
          }
        }
      }
      made.done.mark(tile);
      std::this_thread::yield();
    }
  });
  for (bool all = false; !all;) {
    const std::vector<PartView> views = {made.part()};
    ASSERT_TRUE(write_part(folder.path() / "p", {}, views, kGoOn));
    View read;
    const std::vector<PartView> into = {read.part()};
    ASSERT_TRUE(read_part(folder.path() / "p", into));
    for (const std::size_t tile : read.done.marked()) {
      EXPECT_EQ(same_pixels(read.picture, source.picture, kTiles[tile]),
                kTiles[tile].width * kTiles[tile].height);
    }
    all = read.done.marked().size() == kTiles.size();
  }
  painter.join();
}

}  // namespace
}  // namespace restframe
