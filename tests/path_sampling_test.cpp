// What the sequence of random numbers does for the path integrator: less error than independent numbers
// give, and finer-grained.

#include <gtest/gtest.h>

#include <cmath>

#include "frames/frame_set.h"
#include "scene/temporal_evaluator.h"
#include "support/scene_reading.h"
#include "tracer/exposed_camera.h"
#include "tracer/path_tracer.h"

namespace restframe {
namespace {

constexpr int side = 24;  // pixels

// The soft shadow that a ball in front of a sky throws on the floor it hovers over.
constexpr const char* kShadow = R"toml(
[camera]
position = [0.9, 1.6, 0]
direction = [0, -1, 0]
up = [0, 0, -1]
fov = 5
[render]
resolution = [24, 24]
integrator = "path"
depth = 1
[[object]]
sphere = {radius = 0.9, fineness = 3}
position = [2.6, 1, 0]
material = "black"
[[object]]
asset = "floor.obj"
material = "grey"
[[light]]
type = "environment"
[[material]]
name = "black"
base_color = "black"
[[material]]
name = "grey"
base_color = [0.8, 0.8, 0.8]
metallic = 0
roughness = 1
ior = 1
)toml";

class PathSampling : public SceneReading {
 protected:
  PathSampling() {
    folder.write("floor.obj", "v -9 0 -9\nv 9 0 -9\nv 9 0 9\nv -9 0 9\nf 4 3 2 1\n");
  }
};

// Red through the middle of each pixel, over what `place` makes of the samples 0 to n - 1.
template <class Place>
std::vector<double> means(const Scene& scene, int samples, const Place& place) {
  const FrameSet frames(scene, 1);
  const PathTracer tracer(scene, frames);
  TemporalEvaluator evaluator(scene.functions);
  const CameraSampler sampler(scene);
  const ExposedCamera camera(scene, sampler, 0);
  std::vector<double> means(side * side);
  for (int y = 0; y < side; y += 4) {
    for (int x = 0; x < side; x += 4) {
      PacketId id;
      PixelLanes pixels;
      for (int i = 0; i < packet_size; ++i) {
        pixels.x[i] = x + i % 4;
        pixels.y[i] = y + i / 4;
        id.pixel[i] = morton_place(static_cast<std::uint32_t>(pixels.x[i]),
                                   static_cast<std::uint32_t>(pixels.y[i]));
      }
      CameraSample middle;
      sampler.take_center(pixels, middle);
      for (int s = 0; s < samples; ++s) {
        place(static_cast<std::uint32_t>(s), id);
        RayPacket rays;
        rays.active.fill(-1);
        camera.rays(0, middle, rays);
        RadianceLanes radiance;
        tracer.trace(rays, id, evaluator, radiance, {});
        for (int i = 0; i < packet_size; ++i) {
          means[static_cast<std::size_t>(pixels.y[i] * side + pixels.x[i])] +=
              static_cast<double>(radiance[i].x) / samples;
        }
      }
    }
  }
  return means;
}

std::vector<double> of_sequence(const Scene& scene, int samples, std::uint64_t seed) {
  return means(scene, samples, [&](std::uint32_t sample, PacketId& id) {
    id.seed = seed;
    id.sample = sample;
    id.sample_bits = static_cast<std::uint32_t>(bits_for(samples));
  });
}

std::vector<double> of_independent_numbers(const Scene& scene, int samples, std::uint64_t seed) {
  return means(scene, samples, [&](std::uint32_t sample, PacketId& id) {
    id.seed = seed;
    id.replicate = sample;
  });
}

double squared_error(const std::vector<double>& picture, const std::vector<double>& converged) {
  double sum = 0;
  for (std::size_t i = 0; i < picture.size(); ++i) {
    sum += (picture[i] - converged[i]) * (picture[i] - converged[i]);
  }
  return sum / static_cast<double>(picture.size());
}

// The error that is left of squares of 4 x 4 pixels.
double squared_error_of_squares(const std::vector<double>& picture,
                                const std::vector<double>& converged) {
  double sum = 0;
  for (int y = 0; y < side; y += 4) {
    for (int x = 0; x < side; x += 4) {
      double error = 0;
      for (int i = 0; i < packet_size; ++i) {
        const auto at = static_cast<std::size_t>((y + i / 4) * side + x + i % 4);
        error += (picture[at] - converged[at]) / packet_size;
      }
      sum += error * error * packet_size / (side * side);
    }
  }
  return sum;
}

// Samples of independent numbers leave a squared error of sigma^2 / n, those of a scrambled net one that
// falls with n^(3/2) where an edge is what is integrated over: the ball against the sky.
TEST_F(PathSampling, ASoftShadowHasLessErrorThanWithIndependentNumbers) {
  const Scene scene = read(kShadow);
  const std::vector<double> converged = of_sequence(scene, 1024, 1);
  const double sequence = squared_error(of_sequence(scene, 64, 2), converged);
  const double independent = squared_error(of_independent_numbers(scene, 64, 2), converged);
  RecordProperty("variance_ratio_at_64", std::to_string(sequence / independent));
  EXPECT_LT(sequence, 0.35 * independent) << sequence << ' ' << independent;
  EXPECT_GT(independent, 1e-5);
}

TEST_F(PathSampling, AtFewSamplesNeighboursErrorsMakeUpForEachOther) {
  const Scene scene = read(kShadow);
  const std::vector<double> converged = of_sequence(scene, 1024, 1);
  for (const int samples : {1, 4}) {
    double sequence = 0, independent = 0;
    for (std::uint64_t seed = 10; seed < 20; ++seed) {
      sequence += squared_error_of_squares(of_sequence(scene, samples, seed), converged);
      independent +=
          squared_error_of_squares(of_independent_numbers(scene, samples, seed), converged);
    }
    RecordProperty("coarse_variance_ratio_at_" + std::to_string(samples),
                   std::to_string(sequence / independent));
    EXPECT_LT(sequence, 0.5 * independent) << samples;
  }
}

// Both have the same expected value: the pictures' means agree within their noise.
TEST_F(PathSampling, TheSequenceHasTheSameMean) {
  const Scene scene = read(kShadow);
  double difference = 0, variance = 0;
  const std::vector<double> sequence = of_sequence(scene, 256, 4);
  const std::vector<double> independent = of_independent_numbers(scene, 256, 4);
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    difference += sequence[i] - independent[i];
    variance += 0.8 * 0.8 / 4 / 256;  // at most: a path ends in 0 or 0.8
  }
  EXPECT_LT(std::abs(difference), 4 * std::sqrt(2 * variance));
}

}  // namespace
}  // namespace restframe
