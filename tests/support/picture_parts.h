#pragma once

// Layers of parts of a picture's light.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/direct_render.h"

namespace restframe {

inline const std::vector<Layer> way_layers = {Layer::emission, Layer::direct, Layer::indirect,
                                              Layer::reflection, Layer::transmission};
inline const std::vector<std::string> way_names = {"emission", "direct", "indirect", "reflection",
                                                   "transmission"};

// The scene with the beauty, all parts and the albedo as its layers.
inline Scene with_parts(Scene scene) {
  scene.output.layers = {Layer::beauty, Layer::lights, Layer::albedo};
  scene.output.layers.insert(scene.output.layers.end(), way_layers.begin(), way_layers.end());
  return scene;
}

// A colour a pixel.
inline std::vector<Vec3> colors_of(const Picture& picture, const std::string& layer) {
  const std::vector<double> r = channel_of(picture, layer + ".R"),
                            g = channel_of(picture, layer + ".G"),
                            b = channel_of(picture, layer + ".B");
  std::vector<Vec3> colors;
  for (std::size_t i = 0; i < r.size(); ++i) colors.emplace_back(r[i], g[i], b[i]);
  return colors;
}

inline std::vector<Vec3> beauty_of(const Picture& picture) {
  std::vector<Vec3> colors;
  for (const Vec4f& pixel : picture.rgba()) colors.emplace_back(Vec3(Vec3f(pixel)));
  return colors;
}

inline Vec3 mean_of(const std::vector<Vec3>& colors) {
  Vec3 sum(0);
  for (const Vec3& color : colors) sum += color;
  return sum / static_cast<double>(colors.size());
}

// Fails where colours differ by more than a part of the larger one, or of `least`.
inline void expect_same_colors(const std::vector<Vec3>& a, const std::vector<Vec3>& b,
                               double relative, double least = 1e-3) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const double size = std::max({least, std::abs(a[i][c]), std::abs(b[i][c])});
      ASSERT_NEAR(a[i][c], b[i][c], relative * size) << "pixel " << i << " channel " << c;
    }
  }
}

// Fails unless the layers' sum is the beauty.
inline void expect_sum(const Picture& picture, const std::vector<std::string>& layers,
                       double relative = 1e-5) {
  std::vector<Vec3> sum(picture.rgba().size(), Vec3(0));
  for (const std::string& layer : layers) {
    const std::vector<Vec3> part = colors_of(picture, layer);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += part[i];
  }
  expect_same_colors(sum, beauty_of(picture), relative);
}

// Fails unless all of the light is in that one of the ways.
inline void expect_all_in(const Picture& picture, const std::string& layer) {
  for (const std::string& way : way_names) {
    SCOPED_TRACE(way);
    const std::vector<Vec3> none(picture.rgba().size(), Vec3(0));
    expect_same_colors(colors_of(picture, way), way == layer ? beauty_of(picture) : none, 1e-5);
  }
}

}  // namespace restframe
