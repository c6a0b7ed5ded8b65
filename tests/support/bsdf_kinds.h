#pragma once

// Surfaces that scatter, one with each lobe and some with many, and what is found out about them by
// chance and by quadrature.

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "tracer/bsdf.h"

namespace restframe {

// At an angle of incidence, around the normal z.
inline Bsdf surface_seen_at(double theta) {
  Bsdf bsdf;
  bsdf.view = Vec3f(
      Vec3(std::sin(theta) * std::cos(0.4), std::sin(theta) * std::sin(0.4), std::cos(theta)));
  return bsdf;
}

struct BsdfKind {
  std::string name;
  std::function<void(Bsdf&)> make;  // of one that is a grey dielectric

  Bsdf seen_at(double theta, double roughness) const {
    Bsdf bsdf = surface_seen_at(theta);
    bsdf.alpha = static_cast<float>(roughness * roughness);
    make(bsdf);
    return bsdf;
  }
};

inline void add_coat(Bsdf& b, float coat, float alpha) {
  b.layers.coat = coat;
  b.layers.coat_alpha = alpha;
}

inline void add_sheen(Bsdf& b, const Vec3f& color, float alpha) {
  b.layers.sheen = color;
  b.layers.sheen_alpha = alpha;
}

// White ones lose no light.
inline std::vector<BsdfKind> white_kinds() {
  return {
      {"dielectric", [](Bsdf&) {}},
      {"denser outside", [](Bsdf& b) { b.eta = 1 / 1.33F; }},
      {"metal", [](Bsdf& b) { b.metallic = 1; }},
      {"half metal", [](Bsdf& b) { b.metallic = 0.5F; }},
      {"less specular", [](Bsdf& b) { b.specular = 0.4F; }},
      {"tinted gloss", [](Bsdf& b) { b.specular_color = Vec3f(8); }},
      {"glass", [](Bsdf& b) { b.layers.transmission = 1; }},
      {"glass from within",
       [](Bsdf& b) {
         b.layers.transmission = 1;
         b.eta = 1 / 1.5F;
       }},
      {"heavy glass",
       [](Bsdf& b) {
         b.layers.transmission = 1;
         b.eta = 2.4F;
       }},
      {"milky glass", [](Bsdf& b) { b.layers.transmission = 0.6F; }},
      {"sheet",
       [](Bsdf& b) {
         b.layers.transmission = 1;
         b.layers.thin = true;
       }},
      {"velvet", [](Bsdf& b) { add_sheen(b, Vec3f(1), 0.25F); }},
      {"varnish", [](Bsdf& b) { add_coat(b, 1, 0.16F); }},
      {"everything",
       [](Bsdf& b) {
         b.metallic = 0.3F;
         b.layers.transmission = 0.5F;
         b.layers.thin = true;
         add_coat(b, 0.7F, 0.2F);
         add_sheen(b, Vec3f(0.6F), 0.5F);
       }},
  };
}

// Some of these lose light.
inline std::vector<BsdfKind> all_kinds() {
  std::vector<BsdfKind> kinds = white_kinds();
  kinds.push_back({"gold", [](Bsdf& b) {
                     b.metallic = 1;
                     b.base = {0.9F, 0.5F, 0.1F};
                   }});
  kinds.push_back({"coloured glass", [](Bsdf& b) {
                     b.layers.transmission = 0.8F;
                     b.base = {0.2F, 0.9F, 0.4F};
                     b.specular_color = {3, 1, 0.1F};
                     b.specular = 0.7F;
                   }});
  kinds.push_back({"tilted coat", [](Bsdf& b) {
                     add_coat(b, 1, 0.1F);
                     b.layers.coat_normal = glm::normalize(Vec3f(0.2F, -0.1F, 1));
                     b.base = {0.5F, 0.1F, 0.1F};
                   }});
  kinds.push_back({"tilted normal", [](Bsdf& b) {
                     b.normal = glm::normalize(Vec3f(0.3F, 0.1F, 1));
                     b.layers.transmission = 0.5F;
                   }});
  return kinds;
}

// A mean by chance, with its standard deviation.
struct Estimate {
  double mean = 0, deviation = 0;
};

class Mean {
 public:
  void add(double value) {
    ++count_;
    const double off = value - mean_;
    mean_ += off / count_;
    squares_ += off * (value - mean_);
  }
  Estimate estimate() const { return {mean_, std::sqrt(squares_ / count_ / count_)}; }

 private:
  int count_ = 0;
  double mean_ = 0, squares_ = 0;
};

// Numbers that choose ways on.
class Chooser {
 public:
  explicit Chooser(unsigned seed) : random_(seed) {}
  std::optional<Scattered> operator()(const Bsdf& bsdf) {
    const float lobe = number(), u = number(), v = number();
    return scatter(bsdf, lobe, u, v);
  }

 private:
  float number() { return static_cast<float>(random_() >> 8) * 0x1p-24F; }
  std::mt19937 random_;
};

// The sphere in bins of equal solid angle, each with points in it.
struct SphereBins {
  int rings = 16, sectors = 16, points = 16;  // points: along each side of a bin

  int count() const { return rings * sectors; }
  int bin_of(const Vec3f& direction) const {
    const double turn = std::atan2(direction.y, direction.x) / (2 * std::numbers::pi) + 0.5;
    const int ring = static_cast<int>((0.5 * static_cast<double>(direction.z) + 0.5) * rings);
    const int sector = static_cast<int>(turn * sectors);
    return std::clamp(ring, 0, rings - 1) * sectors + std::clamp(sector, 0, sectors - 1);
  }

  // Calls `visit` with each point's bin, direction and solid angle.
  template <class Visit>
  void for_each_point(const Visit& visit) const {
    const int across = rings * points, around = sectors * points;
    const double solid_angle = 4 * std::numbers::pi / (static_cast<double>(across) * around);
    for (int i = 0; i < across; ++i) {
      const double z = 2 * (i + 0.5) / across - 1, sine = std::sqrt(1 - z * z);
      for (int j = 0; j < around; ++j) {
        const double phi = 2 * std::numbers::pi * ((j + 0.5) / around - 0.5);
        const Vec3 direction(sine * std::cos(phi), sine * std::sin(phi), z);
        visit(i / points * sectors + j / points, Vec3f(direction), solid_angle);
      }
    }
  }
};

}  // namespace restframe
