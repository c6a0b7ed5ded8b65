// The density that scatter() tells is that of the directions it chooses, and its weights are those of
// the fraction for lights: by histograms and quadrature over the sphere.

#include <gtest/gtest.h>

#include <algorithm>

#include "support/bsdf_kinds.h"

namespace restframe {
namespace {

constexpr int kSamples = 40000;
constexpr double kSurest =
    5;  // standard deviations: of all checks here, fewer than one in 1000 runs

struct View {
  double theta, roughness;
};
const View kViews[] = {{1.1, 0.5}, {0.6, 0.9}};

struct Chosen {
  std::vector<int> counts;
  int exact = 0, lost = 0;
  Mean weights[3];
};

Chosen choose(const Bsdf& bsdf, const SphereBins& bins) {
  Chosen chosen;
  chosen.counts.resize(static_cast<std::size_t>(bins.count()));
  Chooser chooser(7);
  for (int i = 0; i < kSamples; ++i) {
    const auto way = chooser(bsdf);
    for (int c = 0; c < 3; ++c) {
      chosen.weights[c].add(way ? static_cast<double>(way->weight[c]) : 0.0);
    }
    if (!way) {
      ++chosen.lost;
    } else if (way->density == 0) {
      ++chosen.exact;
    } else {
      ++chosen.counts[static_cast<std::size_t>(bins.bin_of(way->direction))];
    }
  }
  return chosen;
}

struct Summed {
  std::vector<double> chances;
  double chance = 0;
  Vec3 albedo{0};
};

// Where no light comes from, no path goes either.
Summed sum(const Bsdf& bsdf, const SphereBins& bins) {
  Summed summed;
  summed.chances.resize(static_cast<std::size_t>(bins.count()));
  bins.for_each_point([&](int bin, const Vec3f& direction, double solid_angle) {
    const Vec3f fraction = scattered_fraction(bsdf, direction);
    const double chance = solid_angle * static_cast<double>(scattering_density(bsdf, direction));
    if (fraction == Vec3f(0)) return;
    summed.chances[static_cast<std::size_t>(bin)] += chance;
    summed.chance += chance;
    summed.albedo += solid_angle * Vec3(fraction);
  });
  return summed;
}

// Pearson's sum of bins that expect enough, against its mean and deviation.
double chi_square_excess(const std::vector<int>& counts, const std::vector<double>& chances) {
  constexpr double enough = 10;
  double sum = 0, rare_count = 0, rare_expected = 0;
  int bins = 0;
  const auto add = [&](double count, double expected) {
    sum += (count - expected) * (count - expected) / expected;
    ++bins;
  };
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double expected = kSamples * chances[i];
    if (expected >= enough) {
      add(counts[i], expected);
    } else {
      rare_count += counts[i];
      rare_expected += expected;
    }
  }
  if (rare_expected >= enough) add(rare_count, rare_expected);
  return (sum - bins) / std::sqrt(2.0 * bins);
}

void expect_density(const BsdfKind& kind) {
  const SphereBins bins;
  for (const View& view : kViews) {
    const Bsdf bsdf = kind.seen_at(view.theta, view.roughness);
    SCOPED_TRACE(kind.name + ", theta " + std::to_string(view.theta) + ", roughness " +
                 std::to_string(view.roughness));
    const Chosen chosen = choose(bsdf, bins);
    const Summed summed = sum(bsdf, bins);
    EXPECT_EQ(chosen.exact, 0);
    EXPECT_LE(summed.chance, 1.002);
    const double there = 1 - static_cast<double>(chosen.lost) / kSamples;
    const double deviation = std::sqrt(there * (1 - there) / kSamples);
    EXPECT_NEAR(there, summed.chance, kSurest * deviation + 2e-3);
    EXPECT_LT(chi_square_excess(chosen.counts, summed.chances), kSurest);
    for (int c = 0; c < 3; ++c) {
      const Estimate albedo = chosen.weights[c].estimate();
      EXPECT_NEAR(albedo.mean, summed.albedo[c], kSurest * albedo.deviation + 2e-3);
    }
  }
}

class Density : public testing::TestWithParam<BsdfKind> {};

TEST_P(Density, IsThatOfTheChoices) {
  expect_density(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Of, Density, testing::ValuesIn(all_kinds()), [](const auto& tested) {
  std::string name = tested.param.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
});

// Smooth lobes have none; the rest of the surface keeps its own.
TEST(Density, LeavesOutWhatIsExact) {
  Bsdf bsdf = surface_seen_at(0.5);
  bsdf.alpha = 0;
  const Vec3f mirrored(-bsdf.view.x, -bsdf.view.y, bsdf.view.z);
  Bsdf lambert = bsdf;
  lambert.eta = 1;
  const float diffuses = scattering_density(bsdf, mirrored) / scattering_density(lambert, mirrored);
  int exact = 0;
  Chooser chooser(3);
  for (int i = 0; i < kSamples; ++i) {
    const auto way = chooser(bsdf);
    ASSERT_TRUE(way);
    if (way->density == 0) {
      ++exact;
      EXPECT_LT(glm::length(way->direction - mirrored), 1e-5F);
    } else {
      EXPECT_FLOAT_EQ(way->density, scattering_density(bsdf, way->direction));
    }
  }
  EXPECT_NEAR(exact, (1 - static_cast<double>(diffuses)) * kSamples, kSurest * std::sqrt(kSamples));
}

enum class Kinds { plain, layered, matte };

// 16 surfaces, and the same in a packet.
struct Surfaces {
  std::vector<Bsdf> each;
  BsdfLanes lanes;

  explicit Surfaces(Kinds of) {
    const auto kinds = all_kinds();
    for (int i = 0; i < packet_size; ++i) {
      const std::size_t kind =
          static_cast<std::size_t>(i) % (of == Kinds::plain ? 6 : kinds.size());
      add(i, kinds[kind].seen_at(0.2 + 0.08 * i, 0.3 + 0.04 * i), of);
    }
  }

 private:
  void add(int i, Bsdf b, Kinds of) {
    if (of == Kinds::matte) {
      b.metallic = b.specular = 0;
      b.layers = {};
      lanes.matte = true;
    }
    lanes.view.set(i, b.view);
    lanes.normal.set(i, b.normal);
    lanes.facet.set(i, b.facet);
    lanes.base.set(i, b.base);
    lanes.specular_color.set(i, b.specular_color);
    lanes.specular[i] = b.specular;
    lanes.metallic[i] = b.metallic;
    lanes.alpha[i] = b.alpha;
    lanes.eta[i] = b.eta;
    if (of == Kinds::layered) lanes.set_layers(i, b.layers);
    each.push_back(b);
  }
};

// Packets and single surfaces are the same, whatever they have in common.
TEST(Density, OfPacketsIsThatOfEach) {
  for (const Kinds kinds : {Kinds::plain, Kinds::layered, Kinds::matte}) {
    const Surfaces surfaces(kinds);
    Vec3fLanes numbers;
    Lanes<std::int32_t> active;
    for (int i = 0; i < packet_size; ++i) {
      numbers.set(i, Vec3f(0.06F * static_cast<float>(i), 0.4F, 0.3F));
      active[i] = i == 5 ? 0 : -1;
    }
    ViewLobeLanes lobes;
    view_lobes(surfaces.lanes, lobes);
    ScatteredLanes scattered;
    scatter(surfaces.lanes, lobes, active, numbers, scattered);
    for (int i = 0; i < packet_size; ++i) {
      const Vec3f n = numbers.at(i);
      const auto way = scatter(surfaces.each[static_cast<std::size_t>(i)], n.x, n.y, n.z);
      ASSERT_EQ(scattered.active[i] != 0, way && i != 5) << i;
      if (i == 5 || !way) continue;
      EXPECT_EQ(scattered.direction.at(i), way->direction) << i;
      EXPECT_LT(glm::length(scattered.weight.at(i) - way->weight), 1e-5F) << i;
      EXPECT_NEAR(scattered.density[i], way->density, 1e-5F * way->density) << i;
      EXPECT_EQ(scattered.through[i] != 0, way->through) << i;
    }
  }
}

TEST(Density, OfMattePacketsIsThatOfEachForLightsToo) {
  const Surfaces surfaces(Kinds::matte);
  ViewLobeLanes lobes;
  view_lobes(surfaces.lanes, lobes);
  for (const Vec3f towards : {Vec3f(0.48F, -0.6F, 0.64F), Vec3f(0.6F, 0, -0.8F)}) {
    Vec3fLanes direction, fraction;
    Lanes<float> density;
    for (int i = 0; i < packet_size; ++i) direction.set(i, towards);
    scattered_fraction(surfaces.lanes, lobes, direction, fraction, density);
    for (int i = 0; i < packet_size; ++i) {
      const Bsdf& b = surfaces.each[static_cast<std::size_t>(i)];
      EXPECT_LT(glm::length(fraction.at(i) - scattered_fraction(b, towards)), 1e-6F) << i;
      EXPECT_FLOAT_EQ(density[i], scattering_density(b, towards)) << i;
    }
  }
}

}  // namespace
}  // namespace restframe
