#pragma once

// Pictures of one scene with many seeds, and whether their pixels have the means that they should:
// each by its z-score, all together by a bound that is corrected for their number (Sidak).

#include <string>
#include <vector>

#include "scene/scene.h"
#include "tracer/path_walk.h"

namespace restframe {

// Of each pixel's green, or of all three channels.
struct PixelMeans {
  std::vector<double> mean, error;  // standard error of the mean
  int pictures = 0;
};

// With the seeds 1, 2, ... `pictures`. channels: "G" or "RGB".
PixelMeans pixel_means(Scene scene, int pictures, LightSearch search = LightSearch::both,
                       const std::string& channels = "G");

// Means over square blocks of so many pixels a side; the error of each from the block's own spread.
PixelMeans block_means(Scene scene, int pictures, int block,
                       LightSearch search = LightSearch::both);

// The z-score that one of `count` exceeds by chance in a thousand tests, on either side.
double sidak_bound(std::size_t count, double chance = 1e-3);

// Fails where the means are not those expected. relative: what else the expectation may be off by.
void expect_means(const PixelMeans& measured, const std::vector<double>& expected,
                  double relative = 0);
void expect_mean(const PixelMeans& measured, double expected, double relative = 0);
void expect_equal_means(const PixelMeans& a, const PixelMeans& b);

}  // namespace restframe
