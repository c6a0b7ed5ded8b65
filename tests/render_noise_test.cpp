// How sure pixels are: the layer of their variance, and pictures that end where they are sure enough.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "film/replicates.h"
#include "support/direct_render.h"
#include "support/path_scene.h"
#include "support/scene_reading.h"

namespace restframe {
namespace {

// A ball over a floor under a sky: the sky itself is flat, the ball's shadow soft.
constexpr const char* kBall = R"toml(
[camera]
position = [0, 1.2, 4]
look_at = [0, 0.6, 0]
fov = 45
[render]
resolution = [24, 16]
integrator = "path"
depth = 4
[[object]]
name = "ball"
sphere = {radius = 0.6, fineness = 3}
position = [0, 0.7, 0]
velocity = [0.3, 0, 0]
material = "clay"
[[object]]
name = "floor"
asset = "floor.obj"
material = "clay"
[[light]]
type = "environment"
[[material]]
name = "clay"
base_color = [0.8, 0.5, 0.2]
metallic = 0
roughness = 1
)toml";

class RenderNoise : public SceneReading {
 protected:
  RenderNoise() {
    folder.write("floor.obj", "v -3 0 -3\nv 3 0 -3\nv 3 0 3\nv -3 0 3\nf 4 3 2 1\n");
  }
  Scene ball() {
    Scene scene = read(kBall);
    scene.output.layers = {Layer::beauty};
    return scene;
  }
};

const std::vector<float>& statistic(const Picture& picture, const std::string& name) {
  for (const Plane& plane : picture.planes()) {
    if (plane.name == name) return plane.values;
  }
  throw std::out_of_range(name);
}

double luminance(const Vec4f& rgb) {
  return 0.2126 * static_cast<double>(rgb.x) + 0.7152 * static_cast<double>(rgb.y) +
         0.0722 * static_cast<double>(rgb.z);
}

// Pictures of independent seeds with the layer: over the seeds, the square of a pixel's deviation from
// its mean and its variance by the layer have the same expectation. Pixels of one picture hang together,
// so what is judged is one number a picture, the sum over its pixels.
void expect_true_variance(Scene scene, int seeds) {
  scene.output.layers.push_back(Layer::variance);
  std::vector<Picture> pictures;
  for (int seed = 0; seed < seeds; ++seed) {
    scene.render.seed = 100 + static_cast<std::uint64_t>(seed);
    pictures.push_back(first_picture(scene));
  }
  const std::size_t pixels = pictures[0].rgba().size();
  std::vector<double> mean(pixels);
  for (const Picture& picture : pictures) {
    for (std::size_t i = 0; i < pixels; ++i) {
      mean[i] += static_cast<double>(picture.rgba()[i].y) / seeds;
    }
  }
  double told = 0, found = 0, sum = 0, squares = 0;
  for (const Picture& picture : pictures) {
    double own_told = 0, own_found = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
      const double deviation = static_cast<double>(picture.rgba()[i].y) - mean[i];
      own_found += deviation * deviation * seeds / (seeds - 1);
      own_told += static_cast<double>(statistic(picture, "variance.G")[i]);
    }
    told += own_told;
    found += own_found;
    sum += own_found - own_told;
    squares += (own_found - own_told) * (own_found - own_told);
  }
  EXPECT_GT(found, 0);
  EXPECT_NEAR(told / found, 1, 0.1);
  EXPECT_LT(std::abs(sum / std::sqrt(squares)), 4);
}

TEST_F(RenderNoise, TheVarianceLayerIsTheVarianceOverSeeds) {
  Scene scene = ball();
  scene.render.width = 16;
  scene.render.height = 12;
  for (const int samples : {4, 16, 21}) {
    scene.render.samples = samples;
    expect_true_variance(scene, 60);
  }
}

TEST_F(RenderNoise, TheVarianceLayerIsTheVarianceOverSeedsOfSeveralExposures) {
  Scene scene = ball();
  scene.render.width = 16;
  scene.render.height = 12;
  scene.render.samples = 8;
  scene.exposure.count = 3;
  scene.exposure.interval = 0.2;
  scene.exposure.shutter = 0.3;
  expect_true_variance(scene, 60);
  scene.exposure.combine = Combine::mean;
  expect_true_variance(scene, 60);
}

TEST_F(RenderNoise, WhereNothingIsChanceTheVarianceIsNone) {
  Scene scene = ball();
  scene.render.samples = 16;
  scene.output.layers = {Layer::beauty, Layer::variance, Layer::samples};
  const Picture picture = first_picture(scene);
  EXPECT_EQ(picture.rgba()[0], Vec4f(1));  // the sky
  for (const char* channel : {"variance.R", "variance.G", "variance.B"}) {
    EXPECT_EQ(statistic(picture, channel)[0], 0.0F);
    EXPECT_GT(statistic(picture, channel)[8 * 24 + 12], 0.0F);
  }
  for (const float n : statistic(picture, "samples.V")) EXPECT_EQ(n, 16.0F);
}

// The relative error of a block of 4 x 4 pixels, as Replicates::noise() states it, by a picture that
// hardly has any.
struct BlockErrors {
  double worst = 0, mean_square = 0;
};

BlockErrors block_errors(const Picture& picture, const Picture& converged) {
  BlockErrors errors;
  int blocks = 0;
  for (int top = 0; top < picture.height(); top += 4) {
    for (int left = 0; left < picture.width(); left += 4) {
      double square = 0;
      for (int i = 0; i < 16; ++i) {
        const auto at = static_cast<std::size_t>((top + i / 4) * picture.width() + left + i % 4);
        const double truth = luminance(converged.rgba()[at]);
        const double error = luminance(picture.rgba()[at]) - truth;
        square += std::pow(error / std::max(truth, 0.05), 2) / 16;
      }
      errors.worst = std::max(errors.worst, std::sqrt(square));
      errors.mean_square += square;
      ++blocks;
    }
  }
  errors.mean_square /= blocks;
  return errors;
}

TEST_F(RenderNoise, EndsWherePixelsAreSureEnough) {
  Scene scene = ball();
  scene.render.samples = 4096;
  scene.render.seed = 5;
  const Picture converged = first_picture(scene);
  scene.render.seed = 6;
  scene.output.layers.push_back(Layer::samples);
  double fewer = 0;
  for (const double noise : {0.1, 0.03}) {
    scene.render.noise = noise;
    const Picture picture = first_picture(scene);
    const BlockErrors errors = block_errors(picture, converged);
    EXPECT_LT(std::sqrt(errors.mean_square), noise);
    // 4 deviations of a mean of 16 squares, and as many of the 48 degrees of freedom of its estimate.
    EXPECT_LT(errors.worst, 2 * noise);
    const std::vector<float>& samples = statistic(picture, "samples.V");
    EXPECT_EQ(samples[0], 16.0F);  // the sky is sure at once
    const float most = *std::max_element(samples.begin(), samples.end());
    EXPECT_GT(most, 16.0F);
    EXPECT_LT(most, 4096.0F);
    double sum = 0;
    for (const float n : samples) sum += static_cast<double>(n);
    EXPECT_GT(sum, fewer);
    fewer = sum;
  }
}

TEST_F(RenderNoise, TakesNoMoreSamplesThanAreGranted) {
  Scene scene = ball();
  scene.render.samples = 27;
  scene.render.noise = 1e-6;
  scene.exposure.count = 2;
  scene.output.layers = {Layer::beauty, Layer::samples};
  const Picture picture = first_picture(scene);
  const std::vector<float>& samples = statistic(picture, "samples.V");
  EXPECT_EQ(*std::max_element(samples.begin(), samples.end()), 54.0F);  // of both exposures
}

// Without noise to judge, the layer of samples changes no pixel.
TEST_F(RenderNoise, TheNumberOfSamplesAloneChangesNoPixel) {
  Scene scene = ball();
  scene.render.samples = 2;
  const Picture plain = first_picture(scene);
  scene.output.layers.push_back(Layer::samples);
  const Picture counted = first_picture(scene);
  EXPECT_TRUE(std::equal(plain.rgba().begin(), plain.rgba().end(), counted.rgba().begin()));
  for (const float n : statistic(counted, "samples.V")) EXPECT_EQ(n, 2.0F);
}

// Data layers are those of the pixels' centres, whatever the beauty does.
TEST_F(RenderNoise, DataLayersStay) {
  Scene scene = ball();
  scene.output.layers = {Layer::beauty, Layer::z, Layer::time, Layer::id};
  scene.render.samples = 8;
  const Picture plain = first_picture(scene);
  scene.render.noise = 0.05;
  const Picture ended = first_picture(scene);
  for (const char* channel : {"Z", "time_proper.V", "time_world.V", "id_object.V"}) {
    const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
    const std::vector<double> a = channel_of(plain, channel), b = channel_of(ended, channel);
    EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), same)) << channel;
  }
}

// Several exposures, a shutter, a lens: the same picture as without a noise level, but for noise.
TEST_F(RenderNoise, ExposuresAreCombinedAsEver) {
  for (const Combine combine : {Combine::sum, Combine::mean}) {
    Scene scene = ball();
    scene.lights.clear();
    scene.render.integrator = IntegratorKind::preview;
    scene.exposure = {0.4, ShutterShape::triangle, {}, 3, 0.7, combine};
    scene.camera.aperture = 0.05;
    scene.camera.focus = 4;
    scene.render.samples = 256;
    const Picture plain = first_picture(scene);
    scene.render.noise = 1e-3;
    const Picture ended = first_picture(scene);
    Vec4f sum_plain(0), sum_ended(0);
    for (std::size_t i = 0; i < plain.rgba().size(); ++i) {
      const Vec4f difference = plain.rgba()[i] - ended.rgba()[i];
      for (int c = 0; c < 4; ++c) EXPECT_NEAR(difference[c], 0, 0.12F) << i;
      sum_plain += plain.rgba()[i];
      sum_ended += ended.rgba()[i];
    }
    for (int c = 0; c < 4; ++c) EXPECT_NEAR(sum_ended[c] / sum_plain[c], 1, 3e-3F) << c;
  }
}

TEST(ReplicatesTest, MeanAndVarianceAreThoseOfTheSets) {
  Replicates replicates;
  RadianceLanes radiance;
  const float values[] = {1, 2, 4, 9};
  for (int set = 0; set < replicate_count; ++set) {
    radiance.fill(Vec4f(values[set], 0, 0.5F * values[set], 1));
    replicates.add(set, radiance, 1.0F);
    replicates.count(set);
  }
  // Mean 4; deviations -3, -2, 0, 5: 38 / 3 / 4.
  EXPECT_EQ(replicates.samples(), 4);
  EXPECT_EQ(replicates.mean(3), Vec4f(4, 0, 2, 1));
  EXPECT_NEAR(replicates.variance(3).x, 38.0 / 12, 1e-6);
  EXPECT_EQ(replicates.variance(3).y, 0.0F);
  EXPECT_NEAR(replicates.variance(3).z, 38.0 / 48, 1e-6);
  Lanes<std::int32_t> active;
  active.fill(-1);
  // Red and blue go together here, so luminance does with them.
  EXPECT_NEAR(replicates.noise(active), std::sqrt(38.0 / 12) / 4, 1e-6);
}

// The same bytes for any number of threads; the layers reach the file.
TEST(RenderNoiseProgram, ThreadsChangeNothing) {
  const std::string scene =
      "[render]\nresolution = [50, 40]\nsamples = 64\nintegrator = \"path\"\nnoise = 0.005\n"
      "[output]\npreview = false\nlayers = [\"beauty\", \"Z\", \"variance\", \"samples\"]\n"
      "[[object]]\nsphere = {fineness = 3}\nposition = [0, 0, -3]\n[[light]]\ntype = "
      "\"environment\"\n";
  const PathRender one = run_path(scene, {}, {"--threads", "1"});
  const PathRender four = run_path(scene, {}, {"--threads", "4"});
  ASSERT_EQ(one.result.exit_code, 0) << one.result.error;
  ASSERT_EQ(four.result.exit_code, 0) << four.result.error;
  const ExrPicture a = one.picture(), b = four.picture();
  EXPECT_EQ(a.channels, b.channels);
  EXPECT_EQ(a.channels.count("variance.B"), 1U);
  const std::vector<float>& samples = a.channel("samples.V");
  EXPECT_LT(*std::min_element(samples.begin(), samples.end()),
            *std::max_element(samples.begin(), samples.end()));
}

TEST(RenderNoiseProgram, OptionsAreJudgedTogether) {
  const std::string scene = "[[object]]\nsphere = {}\n";
  const PathRender few = run_path(scene, {}, {"--noise", "0.1", "--samples", "2"});
  EXPECT_EQ(few.result.exit_code, 2);
  EXPECT_NE(few.result.error.find("samples to be at least 4, it is 2"), std::string::npos)
      << few.result.error;
  EXPECT_EQ(run_path(scene, {}, {"--noise", "-1"}).result.exit_code, 2);
}

// Exposure and view are the preview's: the EXR keeps its bytes.
TEST(RenderNoiseProgram, ViewsChangeOnlyThePreview) {
  const std::string scene =
      "[render]\nresolution = [8, 8]\n[[object]]\nsphere = {}\nposition = [0, 0, -3]\n";
  const auto bytes = [](const PathRender& render, const char* name) {
    std::ifstream stream(render.folder->path() / name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  std::vector<std::string> previews;
  const PathRender plain = run_path(scene, {});
  for (const std::vector<std::string>& options : {std::vector<std::string>{},
                                                  {"--exposure", "-2"},
                                                  {"--view", "filmic"},
                                                  {"--exposure", "-2", "--view", "filmic"}}) {
    const PathRender shown = run_path(scene, {}, options);
    ASSERT_EQ(shown.result.exit_code, 0) << shown.result.error;
    EXPECT_EQ(bytes(shown, "picture.0000.exr"), bytes(plain, "picture.0000.exr"));
    previews.push_back(bytes(shown, "picture.0000.png"));
  }
  EXPECT_EQ(previews[0], bytes(plain, "picture.0000.png"));
  std::sort(previews.begin(), previews.end());
  EXPECT_EQ(std::unique(previews.begin(), previews.end()) - previews.begin(), 4);
  EXPECT_EQ(run_path(scene, {}, {"--view", "aces"}).result.exit_code, 2);
}

}  // namespace
}  // namespace restframe
