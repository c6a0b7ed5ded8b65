// KHR_lights_punctual and cameras.

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

#include "importers/gltf_check.h"
#include "scene/message.h"

namespace restframe {
namespace {

constexpr double most = std::numeric_limits<float>::max();

// Messages once for all elements of a kind, at the first.
struct Repeated {
  std::string first;
  std::size_t count = 0;

  void add(const Place& place) {
    if (count++ == 0) first = place.pointer();
  }
  void warn(const GltfContext& context, const std::string& what) const {
    if (count == 0) return;
    const std::string more = count > 1 ? ", here and " + std::to_string(count - 1) + " more" : "";
    context.warn(first, what + more);
  }
};

template <std::size_t count>
std::string read_type(const Place& element, const std::array<const char*, count>& types) {
  element.require_member("type");
  const Place place = element.member("type");
  std::string type = place.as_string();
  if (std::find(types.begin(), types.end(), type) == types.end()) {
    std::string known;
    for (const char* each : types) known += (known.empty() ? "" : ", ") + std::string(each);
    place.fault("is " + quote(type) + ", must be one of " + known);
  }
  return type;
}

double number_or(const Place& place, const char* key, double least, double greatest,
                 double otherwise) {
  return place.has(key) ? place.member(key).as_number(least, greatest) : otherwise;
}

void check_spot(const Place& light) {
  light.require_member("spot");
  const Place spot = light.member("spot");
  spot.require_object();
  constexpr double right_angle = std::numbers::pi / 2 * (1 + 1e-6);  // floats round up
  const double inner = number_or(spot, "innerConeAngle", 0, right_angle, 0);
  const double outer = number_or(spot, "outerConeAngle", 0, right_angle, std::numbers::pi / 4);
  if (inner <= outer && outer > 0) return;
  spot.fault("innerConeAngle is " + Json(inner).dump() + ", must be at most outerConeAngle, " +
             Json(outer).dump() + ", which must be above 0");
}

void check_light(const Place& light) {
  light.check_string("name");
  light.check_numbers("color", 3, 0, most);
  light.check_number("intensity", 0, most);
  light.check_number("range", 0, most);
  if (read_type(light, std::array{"point", "spot", "directional"}) == "spot") check_spot(light);
}

// Calls body with the object of the extension, where the element has it.
template <class Body>
void with_lights(const Place& element, const Body& body) {
  if (!element.has("extensions")) return;
  const Place extensions = element.member("extensions");
  extensions.require_object();
  if (!extensions.has("KHR_lights_punctual")) return;
  const Place punctual = extensions.member("KHR_lights_punctual");
  punctual.require_object();
  body(punctual);
}

void check_perspective(const Place& camera) {
  camera.require_member("perspective");
  const Place perspective = camera.member("perspective");
  perspective.require_object();
  perspective.require_member("yfov");
  const Place yfov = perspective.member("yfov");
  const double angle = yfov.as_number(-most, most);
  if (angle > 0 && angle < std::numbers::pi) return;
  yfov.fault("is " + yfov.value().dump() + ", must be above 0 and below pi");
}

}  // namespace

void check_lights(const Place& document) {
  std::size_t count = 0;
  Repeated ranges;
  with_lights(document, [&](const Place& punctual) {
    punctual.require_member("lights");
    count = punctual.member("lights").size();
    for_each_object(punctual, "lights", [&](const Place& light) {
      check_light(light);
      if (light.has("range")) ranges.add(light);
    });
  });
  for_each_object(document, "nodes", [&](const Place& node) {
    with_lights(node, [&](const Place& punctual) {
      punctual.require_member("light");
      punctual.index("light", count);
    });
  });
  ranges.warn(document.context(), "range is left out: light falls off with distance alone");
}

void check_cameras(const Place& document) {
  Repeated orthographic;
  for_each_object(document, "cameras", [&](const Place& camera) {
    if (read_type(camera, std::array{"perspective", "orthographic"}) == "perspective") {
      check_perspective(camera);
    } else {
      orthographic.add(camera);
    }
  });
  orthographic.warn(document.context(), "orthographic cameras are not supported, left out");
}

}  // namespace restframe
