#include "importers/scene_file_camera.h"

namespace restframe {
namespace {

std::optional<Aim> aim_at_object(TableReader& table, const std::string& key, const Vec3& point,
                                 const SceneFile& file) {
  const std::optional<int> index = read_object_reference(table, key, file);
  if (!index) return std::nullopt;
  const Object& object = file.scene.objects[static_cast<std::size_t>(*index)];
  return AimTrack{at_rest_on(object, object_point(file, *index, point)), object.name};
}

// track = "name", or {object = "name", point = [x, y, z]}
std::optional<Aim> read_track(TableReader& table, const SceneFile& file) {
  const ConfigValue* value = table.find("track");
  if (!value) return std::nullopt;
  if (std::holds_alternative<std::string>(value->data)) {
    return aim_at_object(table, "track", Vec3(0), file);
  }
  const auto* inner = std::get_if<ConfigTable>(&value->data);
  if (!inner) {
    report_kind(*value, "track", "an object's name or {object = \"name\", point = [x, y, z]}",
                table.report);
    return std::nullopt;
  }
  TableReader track(*inner, {table.report.faults, table.report.name + ": track"});
  if (!track.has("object")) track.report(inner->at, "object is missing");
  const Vec3 point = track.vector("point").value_or(Vec3(0));
  std::optional<Aim> aim = aim_at_object(track, "object", point, file);
  track.finish();
  return aim;
}

}  // namespace

std::optional<Aim> read_aim(TableReader& table, const Vec3& up, const SceneFile& file) {
  table.one_of({"look_at", "direction", "track"});
  const std::optional<Vec3> point = table.vector("look_at");
  const std::optional<Vec3> direction = read_direction(table, "direction");
  std::optional<Aim> track = read_track(table, file);
  if (direction && glm::length(glm::cross(*direction, up)) < 1e-9) {
    table.report(table.place("direction"),
                 "direction is along up, which leaves the orientation open");
  }
  if (point) return AimPoint{*point / file.scene.light_speed};
  if (direction) return AimDirection{*direction};
  return track;
}

}  // namespace restframe
