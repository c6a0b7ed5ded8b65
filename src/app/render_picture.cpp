#include "app/render_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "app/measured_block.h"
#include "app/render_block.h"
#include "app/signals.h"
#include "film/exposures.h"
#include "film/sample_sum.h"
#include "scene/error.h"
#include "scene/light_groups.h"
#include "scene/parallel.h"

namespace restframe {
namespace {

constexpr int tile_size = 32;  // pixels

void add(RadianceLanes& sum, const RadianceLanes& radiance) {
  for (int lane = 0; lane < packet_size; ++lane) sum[lane] += radiance[lane];
}

// The sum over the samples of one exposure; data layers are those of the very first sample.
template <class Tracer>
void render_exposure(Block<Tracer>& block, int exposure, int samples, bool with_data,
                     RadianceLanes& sum, PartTotals& parts, Picture& picture) {
  const CameraSampler& sampler = block.view.sampler;
  PacketId& id = block.id;
  const int bits = bits_for(samples);
  const std::uint32_t first = static_cast<std::uint32_t>(exposure) << bits;
  id.sample = first;
  id.sample_bits =
      static_cast<std::uint32_t>(bits + bits_for(block.view.context.scene.exposure.count));
  CameraSampler::Starts starts;
  sampler.start(id, starts);
  SampleSum subtotals;
  for (int index = 0; index < samples; ++index) {
    if (interrupt_requested()) throw Interrupted();
    id.sample = first + static_cast<std::uint32_t>(index);
    CameraSample sample;
    sampler.take(block.pixels, starts, index, sample);
    RadianceLanes next;
    RadianceLanes& radiance = index == 0 ? sum : next;
    const SampleLayers layers{nullptr, block.covers, parts.sample()};
    if (with_data && id.sample == 0) {
      trace_and_store_data(block, sample, radiance, layers, picture);
    } else {
      trace(block, exposure, sample, radiance, layers);
    }
    if (parts.are_wanted()) parts.add_sample();
    if (index > 0) add(sum, next);
    subtotals.take_subtotal(index, sum);
  }
  subtotals.complete(sum);
}

template <class Tracer>
void store_sample_count(const Block<Tracer>& block, int samples, Picture& picture) {
  for_pixels(block, [&](int x, int y, int) { picture.set_statistics(x, y, {Vec3f(0), samples}); });
}

// The multiple of `step` at or before `coordinate`: what a pixel is rendered with does not depend on which
// part of a picture is rendered.
int aligned(int coordinate, int step) {
  const int rest = coordinate % step;
  return coordinate - (rest < 0 ? rest + step : rest);
}

template <class Tracer>
void render_block(Block<Tracer>& block, Picture& picture) {
  const Scene& scene = block.view.context.scene;
  const PictureView& view = block.view;
  const bool data_apart = picture.has_data() && (view.sampler.spreads() || view.measured);
  if (data_apart) render_data(block, picture);
  const bool all_samples = picture.has_beauty() || picture.has_parts() || block.covers != nullptr;
  if (data_apart && !all_samples) return;
  if (view.measured) return render_measured(block, picture);
  const int samples = all_samples ? scene.render.samples : 1;
  const int exposures = all_samples ? scene.exposure.count : 1;
  ExposureTotal total(scene.exposure);
  PartTotals parts(picture.part_columns(), scene.exposure);
  for (int exposure = 0; exposure < exposures; ++exposure) {
    RadianceLanes sum;
    render_exposure(block, exposure, samples, picture.has_data() && !data_apart, sum, parts,
                    picture);
    total.add(sum, 1.0F / static_cast<float>(samples));
  }
  store(block, total.combined(), picture);
  store_parts(block, parts, samples, picture);
  if (block.covers != nullptr) {
    store_mattes(block, samples * exposures, total.alpha_over_mean(), picture);
  }
  if (picture.has_statistics()) store_sample_count(block, samples * exposures, picture);
}

std::string formula_text(const Scene& scene, FunctionIndex function) {
  const auto* formula =
      std::get_if<FormulaFunction>(&scene.functions[static_cast<std::size_t>(function)]);
  return formula == nullptr ? "" : fmt::format("{}", fmt::join(formula->formulas, ", "));
}

void check_fault(const Scene& scene, const TemporalEvaluator& evaluator) {
  const TemporalEvaluator::Fault& fault = evaluator.fault();
  if (fault.function == no_function) return;
  const auto index = static_cast<std::size_t>(fault.function);
  const std::string place =
      index < scene.function_places.size() ? scene.function_places[index] + ": " : "";
  throw InputError(fmt::format("{}formula \"{}\": no finite value at t = {:.9g}", place,
                               formula_text(scene, fault.function), fault.time));
}

template <class Tracer>
void render_tile(const PictureView& view, const Tracer& integrator, const PixelWindow& tile,
                 Picture& picture) {
  std::unique_ptr<TemporalEvaluator> evaluator = view.context.evaluators.take();
  const auto covers =
      picture.mattes().empty() ? nullptr : std::make_unique<CoverCounts>(view.mattes);
  for (int y = aligned(tile.top, block_side); y < tile.bottom(); y += block_side) {
    for (int x = aligned(tile.left, block_side); x < tile.right(); x += block_side) {
      Block<Tracer> block(view, integrator, *evaluator, x, y);
      block.covers = covers.get();
      if (covers) covers->clear();
      render_block(block, picture);
    }
  }
  check_fault(view.context.scene, *evaluator);
  check_faults(integrator);
  view.context.evaluators.bring_back(std::move(evaluator));
  const auto pixels = static_cast<std::size_t>(tile.width * tile.height);
  if (view.context.samples_done) {
    view.context.samples_done(pixels * samples_a_pixel(view.context.scene));
  }
}

}  // namespace

double picture_time(const AnimationSettings& animation, int number) {
  return animation.start + number / animation.rate;
}

std::size_t samples_a_pixel(const Scene& scene) {
  return static_cast<std::size_t>(scene.render.samples) *
         static_cast<std::size_t>(scene.exposure.count);
}

bool measures_noise(const Scene& scene) {
  const OutputSettings& output = scene.output;
  if (has_layer(output.layers, Layer::variance)) return true;
  return scene.render.noise > 0.0 && takes_all_samples(output.layers);
}

Picture blank_picture(const Scene& scene) {
  return {
      picture_window(scene.render), scene.output.layers, {scene.light_speed}, light_groups(scene)};
}

std::vector<Picture> blank_views(const Scene& scene) {
  return std::vector<Picture>(eyes_of(scene.camera).size(), blank_picture(scene));
}

std::vector<PixelWindow> picture_tiles(const PixelWindow& window) {
  std::vector<PixelWindow> tiles;
  for (int y = aligned(window.top, tile_size); y < window.bottom(); y += tile_size) {
    for (int x = aligned(window.left, tile_size); x < window.right(); x += tile_size) {
      tiles.push_back(common_part({x, y, tile_size, tile_size}, window));
    }
  }
  return tiles;
}

void render_tiles(const RenderContext& context, int number, std::span<const std::size_t> tiles,
                  Picture& picture, TileMarks& done, Eye eye) {
  const PictureView view(context, number, picture.window(), eye);
  const std::vector<PixelWindow> windows = picture_tiles(picture.window());
  std::visit(
      [&](const auto& integrator) {
        parallel_for(tiles.size(), [&](std::size_t i) {
          render_tile(view, integrator, windows[tiles[i]], picture);
          done.mark(tiles[i]);
        });
      },
      context.integrator);
}

void render_picture(const RenderContext& context, int number, Picture& picture, Eye eye) {
  TileMarks done(picture_tiles(picture.window()).size());
  std::vector<std::size_t> all(done.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  render_tiles(context, number, all, picture, done, eye);
}

void render_views(const RenderContext& context, int number, std::vector<Picture>& views) {
  const std::vector<Eye> eyes = eyes_of(context.scene.camera);
  for (std::size_t i = 0; i < views.size(); ++i) {
    render_picture(context, number, views[i], eyes[i]);
  }
}

}  // namespace restframe
