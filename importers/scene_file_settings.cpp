#include <fmt/format.h>

#include <algorithm>

#include "importers/scene_file.h"
#include "importers/scene_file_spectrum.h"
#include "scene/output_pattern.h"

namespace restframe {
namespace {

// In the order of the enumerations Layer and Compression.
const std::vector<std::string> layer_names = {"beauty",
                                              "Z",
                                              "time",
                                              "doppler",
                                              "N",
                                              "P",
                                              "UV",
                                              "id",
                                              "variance",
                                              "samples",
                                              "depth",
                                              "normal",
                                              "crypto_object",
                                              "crypto_material",
                                              "crypto_asset",
                                              "emission",
                                              "direct",
                                              "indirect",
                                              "reflection",
                                              "transmission",
                                              "lights",
                                              "albedo",
                                              "motion"};
const std::vector<std::string> compression_names = {"none",  "rle",  "zips", "zip", "piz",
                                                    "pxr24", "dwaa", "dwab", "b44", "b44a"};

void read_scene(TableReader& root, SceneFile& file) {
  const ConfigTable* table = root.table("scene");
  if (!table) return;
  TableReader scene(*table, {file.faults, "scene"});
  file.scene.light_speed = scene.number("light_speed", above(0)).value_or(1);
  scene.finish();
}

void read_animation(TableReader& root, SceneFile& file) {
  const ConfigTable* table = root.table("animation");
  if (!table) return;
  TableReader animation(*table, {file.faults, "animation"});
  AnimationSettings& settings = file.scene.animation;
  settings.rate = animation.number("rate", above(0)).value_or(settings.rate);
  settings.start = animation.number("start").value_or(settings.start);
  settings.pictures = animation.integer("pictures", 1, 1'000'000).value_or(settings.pictures);
  animation.finish();
}

void read_resolution(TableReader& render, RenderSettings& settings) {
  const ConfigValue* value = render.find("resolution");
  if (!value) return;
  const auto* array = std::get_if<ConfigArray>(&value->data);
  if (!array || array->size() != 2) {
    render.report(value->at, "resolution must be [width, height]");
    return;
  }
  const auto width = read_whole_number((*array)[0], "width", 1, most_pixels_a_side, render.report);
  const auto height =
      read_whole_number((*array)[1], "height", 1, most_pixels_a_side, render.report);
  settings.width = static_cast<int>(width.value_or(settings.width));
  settings.height = static_cast<int>(height.value_or(settings.height));
}

// crop = [left, top, width, height]
void read_crop(TableReader& render, RenderSettings& settings) {
  settings.overscan = render.integer("overscan", 0, most_overscan).value_or(0);
  const ConfigValue* value = render.find("crop");
  if (!value) return;
  const auto* array = std::get_if<ConfigArray>(&value->data);
  if (!array || array->size() != 4) {
    render.report(value->at, "crop must be [left, top, width, height]");
    return;
  }
  constexpr std::int64_t most = most_pixels_a_side + 2 * most_overscan;
  const auto number = [&](std::size_t i, const char* what, std::int64_t low) {
    const auto read = read_whole_number((*array)[i], what, low, most, render.report);
    return static_cast<int>(read.value_or(1));
  };
  const PixelWindow crop{number(0, "crop's left", -most_overscan),
                         number(1, "crop's top", -most_overscan), number(2, "crop's width", 1),
                         number(3, "crop's height", 1)};
  settings.crop = crop;
  if (contains(whole_window(settings), crop)) return;
  const PixelWindow whole = whole_window(settings);
  render.report(value->at,
                fmt::format("crop reaches from ({}, {}) to ({}, {}), must lie within ({}, {}) and "
                            "({}, {}), the resolution and its overscan",
                            crop.left, crop.top, crop.right(), crop.bottom(), whole.left, whole.top,
                            whole.right(), whole.bottom()));
}

void read_render(TableReader& root, SceneFile& file) {
  const ConfigTable* table = root.table("render");
  if (!table) return;
  TableReader render(*table, {file.faults, "render"});
  RenderSettings& settings = file.scene.render;
  read_resolution(render, settings);
  read_crop(render, settings);
  settings.samples = render.integer("samples", 1, 65'536).value_or(settings.samples);
  settings.noise = render.number("noise", from_to(0, 1)).value_or(settings.noise);
  settings.beaming = render.boolean("beaming").value_or(settings.beaming);
  settings.seed = static_cast<std::uint64_t>(
      render.whole_number("seed", 0, std::numeric_limits<std::int64_t>::max()).value_or(0));
  if (const auto index = render.choice("integrator", {"preview", "path"})) {
    settings.integrator = static_cast<IntegratorKind>(*index);
  }
  settings.depth = render.integer("depth", 1, 64).value_or(settings.depth);
  settings.doppler = render.boolean("doppler").value_or(settings.doppler);
  read_observe(render, settings);
  render.finish();
}

std::vector<Layer> read_layers(const ConfigArray& names, TableReader& output) {
  std::vector<Layer> layers;
  for (const ConfigValue& value : names) {
    const std::optional<std::string> name = read_text(value, "a layer", output.report);
    if (!name) continue;
    const auto index = read_choice(value.at, *name, "a layer", layer_names, output.report);
    if (!index) continue;
    const Layer layer = static_cast<Layer>(*index);
    if (has_layer(layers, layer)) {
      output.report(value.at, fmt::format("the layer \"{}\" is given twice", *name));
    }
    layers.push_back(layer);
  }
  return layers;
}

void read_layers(TableReader& output, const char* key, std::vector<Layer>& layers) {
  const ConfigValue* value = output.find(key);
  if (!value) return;
  const auto* names = std::get_if<ConfigArray>(&value->data);
  if (!names || names->empty()) {
    output.report(value->at, fmt::format("{} must be an array of at least one layer's name", key));
    return;
  }
  layers = read_layers(*names, output);
}

// Which layers are stored in 16 bits, and which in 32.
void read_pixel_types(TableReader& output, OutputSettings& settings) {
  read_layers(output, "half", settings.half_layers);
  read_layers(output, "float", settings.float_layers);
  const auto check = [&](const char* key, const std::vector<Layer>& layers, bool are_half) {
    for (const Layer layer : layers) {
      const std::string& name = layer_names[static_cast<std::size_t>(layer)];
      const auto report = [&](const std::string& what) {
        output.report(output.place(key), fmt::format("{}: \"{}\" {}", key, name, what));
      };
      if (!has_layer(settings.layers, layer)) {
        report("is not among `layers`");
      } else if (are_half && needs_float(layer)) {
        report("must stay float: half would lose what it tells");
      } else if (are_half && has_layer(settings.float_layers, layer)) {
        report("is named by float, too");
      }
    }
  };
  check("half", settings.half_layers, true);
  check("float", settings.float_layers, false);
}

// An asset, which may be a stranger's, writes below the current folder only.
bool leads_out(const Path& path) {
  return path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end();
}

void read_path(TableReader& output, SceneFile& file) {
  const auto path = output.text("path");
  if (!path) return;
  file.scene.output.path = *path;
  const auto fault = output_pattern_fault(*path, file.scene.animation.pictures);
  if (fault) output.report(output.place("path"), *fault);
  if (!file.asset_being_read || !leads_out(*path)) return;
  output.report(output.place("path"),
                fmt::format("path is \"{}\", must lie in the current folder or below: an asset "
                            "chooses no other; --output does",
                            *path));
}

void read_output(TableReader& root, SceneFile& file) {
  OutputSettings& settings = file.scene.output;
  const ConfigTable* table = root.table("output");
  if (!table) return;
  TableReader output(*table, {file.faults, "output"});
  read_path(output, file);
  read_layers(output, "layers", settings.layers);
  read_pixel_types(output, settings);
  settings.split = output.boolean("split").value_or(settings.split);
  settings.compression_level =
      output.number("compression_level", from_to(0, most_compression_level))
          .value_or(settings.compression_level);
  if (const auto index = output.choice("compression", compression_names)) {
    settings.compression = static_cast<Compression>(*index);
  }
  settings.preview = output.boolean("preview").value_or(settings.preview);
  settings.exposure =
      output.number("exposure", from_to(-most_stops, most_stops)).value_or(settings.exposure);
  if (const auto index = output.choice("view", {"srgb", "filmic"})) {
    settings.view = static_cast<ViewTransform>(*index);
  }
  output.finish();
}

}  // namespace

void read_settings(TableReader& root, SceneFile& file) {
  read_scene(root, file);
  read_animation(root, file);
  read_exposure(root, file);
  read_render(root, file);
  read_output(root, file);
}

}  // namespace restframe
