#include <fmt/format.h>

#include "importers/scene_file.h"

namespace restframe {
namespace {

// In the order of the enumerations ShutterShape and Combine.
const std::vector<std::string> shape_names = {"box", "triangle"};
const std::vector<std::string> combine_names = {"sum", "mean", "max"};

std::optional<std::pair<double, double>> read_curve_point(const ConfigValue& value,
                                                          const Reporter& report) {
  const auto* pair = std::get_if<ConfigArray>(&value.data);
  if (!pair || pair->size() != 2) {
    report(value.at, "a point of opening must be [fraction of the shutter's time, openness]");
    return std::nullopt;
  }
  const auto x = read_number((*pair)[0], "a fraction of the shutter's time", from_to(0, 1), report);
  const auto openness = read_number((*pair)[1], "openness", at_least(0), report);
  if (!x || !openness) return std::nullopt;
  return std::pair(*x, *openness);
}

void read_curve(const ConfigValue& value, const ConfigArray& points, const Reporter& report,
                ExposureSettings& settings) {
  settings.shape = ShutterShape::curve;
  for (const ConfigValue& point : points) {
    const auto read = read_curve_point(point, report);
    if (!read) return;
    settings.curve.push_back(*read);
  }
  const auto fault = shutter_curve_fault(settings.curve);
  if (fault) report(value.at, "opening: " + *fault);
}

void read_opening(TableReader& exposure, ExposureSettings& settings) {
  const ConfigValue* value = exposure.find("opening");
  if (!value) return;
  if (const auto* points = std::get_if<ConfigArray>(&value->data)) {
    read_curve(*value, *points, exposure.report, settings);
  } else if (!std::holds_alternative<std::string>(value->data)) {
    report_kind(*value, "opening", "\"box\", \"triangle\", or points [[0, 0], [0.3, 1], [1, 0]]",
                exposure.report);
  } else if (const auto shape = exposure.choice("opening", shape_names)) {
    settings.shape = static_cast<ShutterShape>(*shape);
  }
}

void read_multiple(TableReader& exposure, ExposureSettings& settings) {
  settings.count = exposure.integer("count", 1, most_exposures).value_or(settings.count);
  settings.interval = exposure.number("interval", at_least(0)).value_or(settings.interval);
  if (settings.count > 1 && settings.interval == 0) {
    exposure.report(exposure.place("interval"),
                    fmt::format("interval is 0, must be above 0 with count = {}", settings.count));
  }
  if (const auto combine = exposure.choice("combine", combine_names)) {
    settings.combine = static_cast<Combine>(*combine);
  }
}

// [camera.stereo]
void read_stereo(TableReader& camera_table, double light_speed, Camera& camera) {
  const ConfigTable* table = camera_table.table("stereo");
  if (!table) return;
  TableReader stereo(*table, {camera_table.report.faults, camera_table.report.name + ": stereo"});
  StereoSettings& settings = camera.stereo.emplace();
  if (!stereo.has("separation")) stereo.report(stereo.place(), "separation is missing");
  settings.separation = stereo.number("separation", at_least(0)).value_or(0) / light_speed;
  settings.convergence = stereo.number("convergence", at_least(0)).value_or(0) / light_speed;
  stereo.finish();
}

}  // namespace

void read_exposure(TableReader& root, SceneFile& file) {
  const ConfigTable* table = root.table("exposure");
  if (!table) return;
  TableReader exposure(*table, {file.faults, "exposure"});
  ExposureSettings& settings = file.scene.exposure;
  settings.shutter = exposure.number("shutter", at_least(0)).value_or(settings.shutter);
  read_opening(exposure, settings);
  read_multiple(exposure, settings);
  exposure.finish();
}

void read_lens_and_rolling(TableReader& camera_table, double light_speed, Camera& camera) {
  TableReader& table = camera_table;
  camera.aperture = table.number("aperture", at_least(0)).value_or(0) / light_speed;
  const auto focus = table.number("focus", above(0));
  if (focus) camera.focus = *focus / light_speed;
  if (camera.aperture > 0 && !table.has("focus")) {
    table.report(table.place("aperture"),
                 "aperture needs focus, the distance of what is to be sharp");
  }
  camera.rolling = table.number("rolling", at_least(0)).value_or(0);
  read_stereo(table, light_speed, camera);
}

}  // namespace restframe
