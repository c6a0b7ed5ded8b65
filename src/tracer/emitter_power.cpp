#include "tracer/emitter_power.h"

#include <algorithm>
#include <cmath>

#include "scene/parallel.h"

namespace restframe {
namespace {

bool is_dark(const TemporalColor& color) {
  return color.value == Vec3f(0) && color.function == no_function;
}

bool is_dark(const TemporalNumber& number) {
  return number.value == 0.0F && number.function == no_function;
}

double mean(const Vec3f& color) {
  return (static_cast<double>(color.x) + static_cast<double>(color.y) +
          static_cast<double>(color.z)) /
         3;
}

// Times at which a function may have any of its values.
void add_times(const Scene& scene, FunctionIndex index, std::vector<double>& times) {
  constexpr int samples = 64;
  if (index == no_function) return;
  const TemporalFunction& function = scene.functions[static_cast<std::size_t>(index)];
  double begin = 0, end = 8;
  const auto stretch = [&](double time) {
    begin = std::min(begin, time);
    end = std::max(end, time);
  };
  if (const auto* intervals = std::get_if<IntervalFunction>(&function)) {
    if (intervals->period) end = *intervals->period;
    for (const auto& interval : intervals->intervals) {
      times.push_back(0.5 * (interval.begin + interval.end));
      if (intervals->period) continue;
      stretch(interval.begin - 1);
      stretch(interval.end + 1);
    }
  } else if (const auto* keys = std::get_if<KeyFunction>(&function)) {
    if (keys->period) end = *keys->period;
    for (const auto& key : keys->keys) {
      times.push_back(key.time);
      if (!keys->period) stretch(key.time);
    }
  }
  for (int i = 0; i < samples; ++i) times.push_back(begin + (end - begin) * (i + 0.5) / samples);
}

// A colour times a number, over their clock: between what it is on average and at most, since what
// flashes matters while it does. Two that seldom shine together count for a little all the same.
double typical(const Scene& scene, const TemporalColor& color, const TemporalNumber& factor,
               TemporalEvaluator& evaluator) {
  constexpr double least_part = 0.01;
  std::vector<double> times = {0};
  add_times(scene, color.function, times);
  add_times(scene, factor.function, times);
  double sum = 0, largest = 0, largest_color = 0, largest_factor = 0;
  for (const double time : times) {
    const double c = std::max(0.0, mean(glm::max(evaluator(color, time), Vec3f(0))));
    const double f = std::max(0.0, static_cast<double>(evaluator(factor, time)));
    sum += c * f;
    largest = std::max(largest, c * f);
    largest_color = std::max(largest_color, c);
    largest_factor = std::max(largest_factor, f);
  }
  const double average = sum / static_cast<double>(times.size());
  const double power =
      std::max(0.5 * (average + largest), least_part * largest_color * largest_factor);
  const bool may_surprise = color.function != no_function || factor.function != no_function;
  return std::max(power, may_surprise ? 1e-6 : 0.0);
}

// Of light of a spectrum of its own: about its energy, since what is invisible may be shifted.
double spectrum_power(const Material& material) {
  const EmissionSpectrum& spectrum = material.emission_spectrum;
  if (!has_own_spectrum(material.emission_temperature, spectrum)) return 1;
  const bool is_hot = has_own_spectrum(material.emission_temperature, {});
  double power = is_hot || !spectrum.points.empty() ? 1 : 1e-6;
  for (const EmissionLine& line : spectrum.lines) power += static_cast<double>(line.power);
  return power;
}

// Means of a texture: over all of its image, and over triangles.
class TextureMean {
 public:
  TextureMean(const Scene& scene, const TextureUse& use, const Mesh& mesh) {
    if (use.texture < 0) return;
    texture_ = &scene.textures[static_cast<std::size_t>(use.texture)];
    image_ = &scene.images[static_cast<std::size_t>(texture_->image)];
    transform_ = use.transform;
    const auto set = static_cast<std::size_t>(use.uv_set);
    if (set < mesh.uvs.size() && !mesh.uvs[set].empty()) uvs_ = &mesh.uvs[set];
    overall_ = mean_of_image();
  }

  // Never below a tenth of the image's: samples may miss what is bright.
  double over(const Triangle& triangle) const {
    if (!texture_) return 1;
    constexpr int rows = 4;
    double sum = 0;
    for (int i = 0; i < rows * rows; ++i) {
      const int row = i / rows, column = i % rows;
      const float a = std::sqrt((static_cast<float>(row) + 0.5F) / rows);
      const float b = (static_cast<float>(column) + 0.5F) / rows;
      const Vec2f uv =
          (1.0F - a) * at(triangle[0]) + a * (1.0F - b) * at(triangle[1]) + a * b * at(triangle[2]);
      sum += mean(Vec3f(sample_texture(*texture_, *image_, transform_(uv))));
    }
    return std::max(sum / (rows * rows), 0.1 * overall_);
  }

 private:
  Vec2f at(std::uint32_t vertex) const { return uvs_ ? (*uvs_)[vertex] : Vec2f(0); }

  double mean_of_image() const {
    double sum = 0;
    for (int y = 0; y < image_->height; ++y) {
      for (int x = 0; x < image_->width; ++x) {
        const Vec2f uv((static_cast<float>(x) + 0.5F) / static_cast<float>(image_->width),
                       (static_cast<float>(y) + 0.5F) / static_cast<float>(image_->height));
        sum += mean(Vec3f(sample_texture(*texture_, *image_, uv)));
      }
    }
    return sum / (static_cast<double>(image_->width) * image_->height);
  }

  const Texture* texture_ = nullptr;
  const Image* image_ = nullptr;
  const std::vector<Vec2f>* uvs_ = nullptr;
  UvTransform transform_;
  double overall_ = 1;
};

double area(const Mesh& mesh, const Triangle& t) {
  const Vec3 a(mesh.positions[t[0]]);
  return 0.5 *
         glm::length(glm::cross(Vec3(mesh.positions[t[1]]) - a, Vec3(mesh.positions[t[2]]) - a));
}

}  // namespace

bool emits(const Material& material) {
  return material.unlit || !(is_dark(material.emission) || is_dark(material.emission_strength));
}

EmittedPower emitted_power(const Scene& scene, const Material& material,
                           TemporalEvaluator& evaluator) {
  EmittedPower power;
  power.emission = typical(scene, material.emission, material.emission_strength, evaluator) *
                   spectrum_power(material);
  if (material.unlit) power.base = typical(scene, material.base_color, {1.0F}, evaluator);
  return power;
}

std::vector<double> triangle_powers(const Scene& scene, const Mesh& mesh, std::uint32_t first,
                                    std::uint32_t count, const Material& material,
                                    const EmittedPower& power) {
  const TextureMean emission(scene, material.emission_texture, mesh);
  const TextureMean base(scene, material.base_color_texture, mesh);
  std::vector<double> powers(count);
  constexpr std::size_t block = 4096;
  parallel_for((count + block - 1) / block, [&](std::size_t b) {
    for (std::size_t i = b * block; i < std::min<std::size_t>(count, (b + 1) * block); ++i) {
      const Triangle& t = mesh.triangles[first + i];
      double emitted = power.emission > 0 ? power.emission * emission.over(t) : 0.0;
      if (power.base > 0) emitted += power.base * base.over(t);
      powers[i] = area(mesh, t) * emitted;
    }
  });
  return powers;
}

}  // namespace restframe
