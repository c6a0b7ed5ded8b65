#include "app/info_json.h"

#include "app/info.h"
#include "app/info_words.h"
#include "app/job_needs.h"

namespace restframe {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Vec3& v) {
  return {v.x, v.y, v.z};
}

Json json_of(const Vec3f& v) {
  return {v.x, v.y, v.z};
}

Json json_of(const Bounds& bounds) {
  if (bounds.empty()) return nullptr;
  return {{"lower", json_of(bounds.lower)}, {"upper", json_of(bounds.upper)}};
}

Json json_of(const AssetReport& report, const FoldedNode& folded) {
  const AssetNode& node = report.asset.tree.nodes[static_cast<std::size_t>(folded.node)];
  Json json = {{"name", folded.name}, {"count", folded.count}};
  for (const MeshUse& use : mesh_uses(report.asset, folded.node)) {
    json["meshes"].push_back({{"mesh", use.mesh}, {"count", use.count}});
  }
  if (node.light >= 0) json["light"] = node.light;
  if (node.camera >= 0) json["camera"] = node.camera;
  if (has_extras(report.asset.tree, ExtrasOf::node, folded.node)) json["extras"] = true;
  for (const FoldedNode& child : folded.children) {
    json["children"].push_back(json_of(report, child));
  }
  if (folded.more > 0) json["more"] = folded.more;
  return json;
}

Json json_of(const Mesh& mesh, bool closed) {
  Json materials = Json::array();
  for (const MaterialRange& range : mesh.materials) materials.push_back(range.slot);
  return {{"name", mesh.name},
          {"triangles", mesh.triangles.size()},
          {"vertices", mesh.positions.size()},
          {"closed", closed},
          {"bytes", bytes_in_memory(mesh)},
          {"bounds", json_of(bounds_of(mesh))},
          {"materials", materials}};
}

Json json_of(const Material& material) {
  return {{"name", material.name},
          {"base_color", json_of(material.base_color.value)},
          {"changes", material.base_color.function != no_function},
          {"textured", material.base_color_texture.texture >= 0},
          {"transparent", material.alpha_mode != AlphaMode::opaque},
          {"transmits", can_transmit(material)}};
}

Json json_of(const Image& image) {
  return {{"name", image.name},
          {"width", image.width},
          {"height", image.height},
          {"format", image.format},
          {"bytes", image.rgba.size()}};
}

// The intensity is null where it is a function of the light's clock.
Json json_of(const Light& light) {
  Json json = {{"name", light.name},
               {"type", kind_name(light.kind)},
               {"color", json_of(light.color.value)},
               {"intensity", light.intensity.value}};
  if (light.intensity.function != no_function) json["intensity"] = nullptr;
  if (light.kind == LightKind::spot) {
    json["cone"] = {glm::degrees(light.inner_cone), glm::degrees(light.outer_cone)};
  }
  return json;
}

Json json_of(const AssetCamera& camera) {
  Json json = {{"name", camera.name},
               {"type", camera.is_perspective ? "perspective" : "orthographic"}};
  if (camera.is_perspective) json["fov"] = glm::degrees(camera.vertical_fov);
  return json;
}

template <class T>
Json list_of(const std::vector<T>& values) {
  Json list = Json::array();
  for (const T& value : values) list.push_back(json_of(value));
  return list;
}

Json scenes_of(const AssetTree& tree) {
  Json scenes = Json::array();
  for (std::size_t i = 0; i < tree.scenes.size(); ++i) {
    scenes.push_back(
        {{"name", tree.scenes[i].name}, {"shown", static_cast<int>(i) == tree.default_scene}});
  }
  return scenes;
}

Json json_of(const Scene& scene, const RestFrame& frame, const std::vector<char>& closed) {
  const Velocity& velocity = frame.coordinates().from_world.velocity();
  Json objects = Json::array();
  for (const int index : objects_of(frame)) {
    const Object& object = scene.objects[static_cast<std::size_t>(index)];
    objects.push_back({{"name", object.name},
                       {"meshes_placed", object.parts.size()},
                       {"triangles", triangles_of(scene, object)},
                       {"closed", is_closed(object, closed)},
                       {"bounds", json_of(object_bounds(scene, object))},
                       {"position", json_of(object.worldline.reference.x * scene.light_speed)}});
  }
  return {
      {"velocity", json_of(velocity.beta())}, {"gamma", velocity.gamma()}, {"objects", objects}};
}

}  // namespace

Json json_of(const AssetReport& report) {
  const Asset& asset = report.asset;
  Json nodes = Json::array(), meshes = Json::array();
  for (const FoldedNode& node : report.nodes.children) nodes.push_back(json_of(report, node));
  for (std::size_t i = 0; i < asset.meshes.size(); ++i) {
    meshes.push_back(json_of(asset.meshes[i], report.closed[i] != 0));
    meshes.back()["placed"] = report.placed[i];
  }
  return {{"file", report.file},
          {"bytes", report.file_bytes},
          {"node_count", report.node_count},
          {"meshes_placed", report.placed_count},
          {"triangles", report.triangle_count},
          {"bounds", json_of(report.bounds)},
          {"extensions", asset.extensions},
          {"scenes", scenes_of(asset.tree)},
          {"nodes", nodes},
          {"nodes_left_out", report.nodes.more},
          {"meshes", meshes},
          {"materials", list_of(asset.materials)},
          {"textures", list_of(asset.images)},
          {"lights", list_of(asset.tree.lights)},
          {"cameras", list_of(asset.tree.cameras)}};
}

Json json_of(const Scene& scene, const FrameSet& frames, const std::vector<char>& closed) {
  Json rest_frames = Json::array(), lights = Json::array();
  for (const RestFrame& frame : frames.frames()) {
    rest_frames.push_back(json_of(scene, frame, closed));
  }
  for (const Light& light : scene.lights) {
    lights.push_back(json_of(light));
    lights.back()["velocity"] = json_of(light.worldline.velocity.beta());
    lights.back()["position"] = json_of(light.worldline.reference.x * scene.light_speed);
  }
  return {{"rest_frames", rest_frames},
          {"lights", lights},
          {"materials", list_of(scene.materials)},
          {"memory",
           {{"meshes", bytes_in_memory(scene.meshes)},
            {"images", bytes_in_memory(scene.images) + bytes_in_memory(scene.sky_maps)},
            {"embree", frames.embree_bytes()},
            {"embree_peak", frames.peak_embree_bytes()},
            {"render", needs_of(scene, frames).bytes}}}};
}

std::string document_text(const Json& document) {
  return document.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace restframe
