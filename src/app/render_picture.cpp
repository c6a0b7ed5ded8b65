#include "app/render_picture.h"

#include <fmt/format.h>

#include "app/signals.h"
#include "scene/error.h"
#include "scene/parallel.h"
#include "tracer/film_samples.h"
#include "tracer/null_ray.h"

namespace restframe {
namespace {

constexpr int tile_size = 32;  // pixels
constexpr int block_side = 4;  // a packet is a square of pixels: coherent both ways
static_assert(block_side * block_side == packet_size);

// What the tiles of one picture share.
struct PictureView {
  const RenderContext& context;
  int number;
  CameraPose pose;
  Projection projection;
  std::vector<Vec2f> offsets;
};

struct Block {
  int x, y;  // of its top left pixel
};

int pixel_x(const Block& block, int lane) {
  return block.x + lane % block_side;
}
int pixel_y(const Block& block, int lane) {
  return block.y + lane / block_side;
}

// Film positions of the block's pixels for one sample. Lanes off the picture stay inactive.
void place_samples(const PictureView& view, const Block& block, int sample, Lanes<double>& film_x,
                   Lanes<double>& film_y, RayPacket& rays) {
  const RenderSettings& settings = view.context.scene.render;
  const Vec2f& offset = view.offsets[static_cast<std::size_t>(sample)];
  for (int lane = 0; lane < packet_size; ++lane) {
    const int x = pixel_x(block, lane);
    const int y = pixel_y(block, lane);
    film_x[lane] = x + 0.5 + static_cast<double>(offset.x);
    film_y[lane] = y + 0.5 + static_cast<double>(offset.y);
    rays.active[lane] = x < settings.width && y < settings.height ? -1 : 0;
  }
}

PacketId block_id(const PictureView& view, const Block& block) {
  const RenderSettings& settings = view.context.scene.render;
  PacketId id;
  id.seed = settings.seed;
  id.picture = static_cast<std::uint32_t>(view.number);
  for (int lane = 0; lane < packet_size; ++lane) {
    id.pixel[lane] =
        static_cast<std::uint32_t>(pixel_y(block, lane) * settings.width + pixel_x(block, lane));
  }
  return id;
}

void store(Picture& picture, const Block& block, const RadianceLanes& sum, float scale) {
  const int columns = std::min(block_side, picture.width() - block.x);
  const int rows = std::min(block_side, picture.height() - block.y);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const int lane = row * block_side + column;
      picture.set_radiance(block.x + column, block.y + row, scale * sum[lane]);
    }
  }
}

void store(Picture& picture, const Block& block, const SurfaceDataLanes& data) {
  for (int lane = 0; lane < packet_size; ++lane) {
    const int x = pixel_x(block, lane);
    const int y = pixel_y(block, lane);
    if (x < picture.width() && y < picture.height()) picture.set_data(x, y, data[lane]);
  }
}

void add(RadianceLanes& sum, const RadianceLanes& radiance) {
  for (int lane = 0; lane < packet_size; ++lane) sum[lane] += radiance[lane];
}

void render_block(const PictureView& view, const Block& block, TemporalEvaluator& evaluator,
                  Picture& picture) {
  const int samples = picture.has_beauty() ? view.context.scene.render.samples : 1;
  RadianceLanes sum;
  sum.fill(Vec4f(0));
  PacketId id;
  if (picture.has_data()) id = block_id(view, block);  // only they draw random numbers
  for (int sample = 0; sample < samples; ++sample) {
    id.sample = static_cast<std::uint32_t>(sample);
    Lanes<double> film_x, film_y;
    RayPacket rays;
    place_samples(view, block, sample, film_x, film_y, rays);
    camera_rays(view.pose, view.projection, film_x, film_y, rays);
    RadianceLanes radiance;
    if (sample == 0 && picture.has_data()) {
      SurfaceDataLanes data;
      view.context.integrator.trace(rays, id, evaluator, radiance, &data);
      store(picture, block, data);
    } else {
      view.context.integrator.trace(rays, id, evaluator, radiance, nullptr);
    }
    add(sum, radiance);
  }
  store(picture, block, sum, 1.0F / static_cast<float>(samples));
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

void render_tile(const PictureView& view, std::size_t tile, Picture& picture) {
  const int tiles_across = (picture.width() + tile_size - 1) / tile_size;
  const int left = static_cast<int>(tile) % tiles_across * tile_size;
  const int top = static_cast<int>(tile) / tiles_across * tile_size;
  const int right = std::min(left + tile_size, picture.width());
  const int bottom = std::min(top + tile_size, picture.height());
  std::unique_ptr<TemporalEvaluator> evaluator = view.context.evaluators.take();
  for (int y = top; y < bottom; y += block_side) {
    for (int x = left; x < right; x += block_side) {
      if (interrupt_requested()) throw Interrupted();
      render_block(view, {x, y}, *evaluator, picture);
    }
  }
  check_fault(view.context.scene, *evaluator);
  view.context.evaluators.bring_back(std::move(evaluator));
  const std::size_t pixels = static_cast<std::size_t>((right - left) * (bottom - top));
  if (view.context.samples_done) {
    view.context.samples_done(pixels * static_cast<std::size_t>(view.context.scene.render.samples));
  }
}

}  // namespace

double picture_time(const AnimationSettings& animation, int number) {
  return animation.start + number / animation.rate;
}

Picture blank_picture(const Scene& scene) {
  return {scene.render.width, scene.render.height, scene.output.layers, {scene.light_speed}};
}

void render_picture(const RenderContext& context, int number, Picture& picture) {
  const Scene& scene = context.scene;
  const RenderSettings& settings = scene.render;
  const CameraPose pose = pose_at(scene.camera, picture_time(scene.animation, number));
  const Projection projection(pose, pose.vertical_fov, settings.width, settings.height);
  const PictureView view{context, number, pose, projection, film_offsets(settings.samples)};
  const auto tiles = [](int length) {
    return static_cast<std::size_t>((length + tile_size - 1) / tile_size);
  };
  parallel_for(tiles(settings.width) * tiles(settings.height),
               [&](std::size_t tile) { render_tile(view, tile, picture); });
}

}  // namespace restframe
