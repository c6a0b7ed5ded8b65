#include "importers/scene_file_motion.h"

#include <fmt/format.h>

namespace restframe {
namespace {

Velocity read_velocity_or_gamma(TableReader& table, const std::string& heading) {
  table.one_of({"velocity", "gamma"});
  const std::optional<double> gamma = table.number("gamma", from_to(1, 1e8));
  const std::optional<Vec3> direction = read_direction(table, heading);
  if (table.has("gamma") != table.has(heading)) {
    const std::string given = table.has("gamma") ? "gamma" : heading;
    table.report(table.key_place(given), fmt::format("gamma and {} go together", heading));
  }
  const Velocity velocity = read_velocity(table);
  return gamma && direction ? Velocity::from_gamma(*gamma, *direction) : velocity;
}

void read_clock(TableReader& table, ClockedWorldline& read) {
  const ConfigValue* value = table.find("clock");
  if (!value) return;
  const auto* text = std::get_if<std::string>(&value->data);
  read.frame_clock = text && *text == "frame";
  if (text && !read.frame_clock) {
    table.report(value->at, fmt::format("clock is \"{}\", must be a number or \"frame\"", *text));
  } else if (!text) {
    read.clock = table.number("clock").value_or(0);
  }
}

}  // namespace

ClockedWorldline read_clocked_worldline(TableReader& table, const std::string& heading,
                                        double light_speed, const Vec3& position) {
  ClockedWorldline read;
  read.worldline.reference.x = table.vector("position").value_or(position) / light_speed;
  read.worldline.reference.t = table.number("time").value_or(0);
  read.worldline.velocity = read_velocity_or_gamma(table, heading);
  read_clock(table, read);
  return read;
}

}  // namespace restframe
