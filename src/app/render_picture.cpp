#include "app/render_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "app/signals.h"
#include "film/exposures.h"
#include "scene/error.h"
#include "scene/parallel.h"
#include "tracer/camera_sampler.h"
#include "tracer/exposed_camera.h"

namespace restframe {
namespace {

constexpr int tile_size = 32;  // pixels
constexpr int block_side = 4;  // a packet is a square of pixels: coherent both ways
static_assert(block_side * block_side == packet_size);

// Where in a block each lane's pixel is, and its number after that of the block's first.
struct BlockPattern {
  PixelLanes offset;
  Lanes<std::int32_t> pixel;

  explicit BlockPattern(int picture_width) {
    for (int lane = 0; lane < packet_size; ++lane) {
      offset.x[lane] = lane % block_side;
      offset.y[lane] = lane / block_side;
      pixel[lane] = offset.y[lane] * picture_width + offset.x[lane];
    }
  }
};

// What the tiles of one picture share.
struct PictureView {
  const RenderContext& context;
  int number;
  CameraSampler sampler;
  ExposedCamera camera;
  BlockPattern pattern;

  PictureView(const RenderContext& of, int picture)
      : context(of),
        number(picture),
        sampler(of.scene),
        camera(of.scene, sampler, picture_time(of.scene.animation, picture)),
        pattern(of.scene.render.width) {}
};

// A square of pixels that is rendered as one packet after the other.
template <class Tracer>
struct Block {
  const PictureView& view;
  const Tracer& integrator;
  TemporalEvaluator& evaluator;
  int left, top;
  int width, height;  // within the picture
  PixelLanes pixels;
  Lanes<std::int32_t> active;  // lanes off the picture stay inactive
  PacketId id;                 // of the sample at hand

  Block(const PictureView& of, const Tracer& by, TemporalEvaluator& with, int x, int y)
      : view(of), integrator(by), evaluator(with), left(x), top(y) {
    const RenderSettings& settings = view.context.scene.render;
    width = std::min(block_side, settings.width - left);
    height = std::min(block_side, settings.height - top);
    id.seed = settings.seed;
    id.picture = static_cast<std::uint32_t>(view.number);
    const BlockPattern& pattern = view.pattern;
    const std::int32_t first = top * settings.width + left;
    const std::int32_t columns = width;
    const std::int32_t rows = height;
#pragma GCC ivdep
    for (int lane = 0; lane < packet_size; ++lane) {
      const std::int32_t across = pattern.offset.x[lane];
      const std::int32_t down = pattern.offset.y[lane];
      pixels.x[lane] = x + across;
      pixels.y[lane] = y + down;
      active[lane] = (across < columns ? -1 : 0) & (down < rows ? -1 : 0);
      id.pixel[lane] = static_cast<std::uint32_t>(first + pattern.pixel[lane]);
    }
  }
};

template <class Tracer, class Store>
void for_pixels(const Block<Tracer>& block, const Store& store) {
  for (int lane = 0; lane < packet_size; ++lane) {
    if (block.active[lane] != 0) store(block.pixels.x[lane], block.pixels.y[lane], lane);
  }
}

void add(RadianceLanes& sum, const RadianceLanes& radiance) {
  for (int lane = 0; lane < packet_size; ++lane) sum[lane] += radiance[lane];
}

template <class Tracer>
void trace(const Block<Tracer>& block, int exposure, const CameraSample& sample,
           RadianceLanes& radiance, SurfaceDataLanes* data) {
  RayPacket rays;
  rays.active = block.active;
  block.view.camera.rays(exposure, sample, rays);
  block.integrator.trace(rays, block.id, block.evaluator, radiance, data);
}

template <class Tracer>
void trace_and_store_data(const Block<Tracer>& block, const CameraSample& sample,
                          RadianceLanes& radiance, Picture& picture) {
  SurfaceDataLanes data;
  trace(block, 0, sample, radiance, &data);
  for_pixels(block, [&](int x, int y, int lane) { picture.set_data(x, y, data[lane]); });
}

// Data layers of samples that are spread over time or the lens: no sample is the ray they hold.
template <class Tracer>
void render_data(const Block<Tracer>& block, Picture& picture) {
  CameraSample sample;
  block.view.sampler.take_center(block.pixels, sample);
  RadianceLanes unused;
  trace_and_store_data(block, sample, unused, picture);
}

// The sum over the samples of one exposure; data layers are those of the very first sample.
template <class Tracer>
void render_exposure(Block<Tracer>& block, int exposure, int samples, bool with_data,
                     RadianceLanes& sum, Picture& picture) {
  const CameraSampler& sampler = block.view.sampler;
  PacketId& id = block.id;
  const auto first = static_cast<std::uint32_t>(exposure) * static_cast<std::uint32_t>(samples);
  id.sample = first;
  CameraSampler::Starts starts;
  sampler.start(id, starts);
  for (int index = 0; index < samples; ++index) {
    id.sample = first + static_cast<std::uint32_t>(index);
    CameraSample sample;
    sampler.take(block.pixels, starts, index, sample);
    RadianceLanes next;
    RadianceLanes& radiance = index == 0 ? sum : next;
    if (with_data && id.sample == 0) {
      trace_and_store_data(block, sample, radiance, picture);
    } else {
      trace(block, exposure, sample, radiance, nullptr);
    }
    if (index > 0) add(sum, next);
  }
}

template <class Tracer>
void store(const Block<Tracer>& block, const RadianceLanes& radiance, Picture& picture) {
  const std::span<const Vec4f> lanes(radiance.lane);
  for (int row = 0; row < block.height; ++row) {
    picture.set_radiance_row(block.left, block.top + row,
                             lanes.subspan(static_cast<std::size_t>(row * block_side),
                                           static_cast<std::size_t>(block.width)));
  }
}

template <class Tracer>
void render_block(Block<Tracer>&& block, Picture& picture) {
  const Scene& scene = block.view.context.scene;
  const bool data_apart = picture.has_data() && block.view.sampler.spreads();
  if (data_apart) render_data(block, picture);
  if (data_apart && !picture.has_beauty()) return;
  const int samples = picture.has_beauty() ? scene.render.samples : 1;
  const int exposures = picture.has_beauty() ? scene.exposure.count : 1;
  ExposureTotal total(scene.exposure);
  for (int exposure = 0; exposure < exposures; ++exposure) {
    if (interrupt_requested()) throw Interrupted();
    RadianceLanes sum;
    render_exposure(block, exposure, samples, picture.has_data() && !data_apart, sum, picture);
    total.add(sum, 1.0F / static_cast<float>(samples));
  }
  store(block, total.combined(), picture);
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
void render_tile(const PictureView& view, const Tracer& integrator, std::size_t tile,
                 Picture& picture) {
  const int tiles_across = (picture.width() + tile_size - 1) / tile_size;
  const int left = static_cast<int>(tile) % tiles_across * tile_size;
  const int top = static_cast<int>(tile) / tiles_across * tile_size;
  const int right = std::min(left + tile_size, picture.width());
  const int bottom = std::min(top + tile_size, picture.height());
  std::unique_ptr<TemporalEvaluator> evaluator = view.context.evaluators.take();
  for (int y = top; y < bottom; y += block_side) {
    for (int x = left; x < right; x += block_side) {
      render_block(Block<Tracer>(view, integrator, *evaluator, x, y), picture);
    }
  }
  check_fault(view.context.scene, *evaluator);
  check_faults(integrator);
  view.context.evaluators.bring_back(std::move(evaluator));
  const auto pixels = static_cast<std::size_t>((right - left) * (bottom - top));
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

Picture blank_picture(const Scene& scene) {
  return {scene.render.width, scene.render.height, scene.output.layers, {scene.light_speed}};
}

void render_picture(const RenderContext& context, int number, Picture& picture) {
  const PictureView view(context, number);
  const auto tiles = [](int length) {
    return static_cast<std::size_t>((length + tile_size - 1) / tile_size);
  };
  const std::size_t count = tiles(picture.width()) * tiles(picture.height());
  std::visit(
      [&](const auto& integrator) {
        parallel_for(count,
                     [&](std::size_t tile) { render_tile(view, integrator, tile, picture); });
      },
      context.integrator);
}

}  // namespace restframe
