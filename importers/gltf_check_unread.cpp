// Animations are not read; but where they refer to nothing, the file is damaged.

#include "importers/gltf_check.h"

namespace restframe {
namespace {

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

}  // namespace

void check_unread(const Place& document) {
  for_each_object(document, "animations",
                  [&](const Place& animation) { check_animation(animation, document); });
  if (count_of(document, "animations") > 0) {
    document.context().warn("/animations", "left out: the asset is read in its rest pose");
  }
}

}  // namespace restframe
