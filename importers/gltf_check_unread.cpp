// Skins and animations are not read; but where they refer to nothing, the file is damaged.

#include "importers/gltf_check.h"

namespace restframe {
namespace {

void check_skin(const Place& skin, const Place& document) {
  const std::size_t nodes = count_of(document, "nodes");
  skin.index("inverseBindMatrices", count_of(document, "accessors"));
  skin.index("skeleton", nodes);
  skin.require_member("joints");
  const Place joints = skin.member("joints");
  joints.require_array();
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const Place joint = joints.element(i);
    if (nodes == 0) joint.fault("there are no nodes");
    joint.as_integer(0, nodes - 1);
  }
}

void check_animation(const Place& animation, const Place& document) {
  for_each_object(animation, "samplers", [&](const Place& sampler) {
    sampler.index("input", count_of(document, "accessors"));
    sampler.index("output", count_of(document, "accessors"));
  });
  for_each_object(animation, "channels", [&](const Place& channel) {
    channel.index("sampler", count_of(animation, "samplers"));
    channel.require_member("target");
    const Place target = channel.member("target");
    target.require_object();
    target.index("node", count_of(document, "nodes"));
  });
}

void check_morph_targets(const Place& primitive, const Place& document) {
  for_each_object(primitive, "targets", [&](const Place& target) {
    for (const auto& [name, value] : target.value().items()) {
      target.index(name.c_str(), count_of(document, "accessors"));
    }
  });
}

}  // namespace

void check_unread(const Place& document) {
  for_each_object(document, "skins", [&](const Place& skin) { check_skin(skin, document); });
  for_each_object(document, "animations",
                  [&](const Place& animation) { check_animation(animation, document); });
  for_each_object(document, "meshes", [&](const Place& mesh) {
    for_each_object(mesh, "primitives",
                    [&](const Place& primitive) { check_morph_targets(primitive, document); });
  });
}

}  // namespace restframe
