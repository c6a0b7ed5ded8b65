#pragma once

// glTF files that say something to restframe, made by tests.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "importers/importers.h"
#include "scene/error.h"
#include "support/gltf_builder.h"
#include "support/temporary_folder.h"

namespace restframe::test {

using nlohmann::json;

// A street: a house that rests, a tram with a wheel below it, a lamp (a point light of 2 W/sr) and
// an eye (a camera); two materials, paint on all and spare on nothing.
//     0 house, 1 tram (of 2 wheel), 3 lamp, 4 eye
inline GltfBuilder street() {
  GltfBuilder builder = one_triangle();
  builder.json["meshes"][0]["primitives"][0]["material"] = 0;
  builder.json["materials"] = {{{"name", "paint"}}, {{"name", "spare"}}};
  builder.json["nodes"] = {
      {{"name", "house"}, {"mesh", 0}},
      {{"name", "tram"}, {"mesh", 0}, {"children", {2}}, {"translation", {1, 2, 3}}},
      {{"name", "wheel"}, {"mesh", 0}, {"translation", {0, -1, 0}}},
      {{"name", "lamp"},
       {"translation", {0, 5, 0}},
       {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}},
      {{"name", "eye"}, {"camera", 0}, {"translation", {0, 0, 9}}}};
  builder.json["scenes"] = {{{"nodes", {0, 1, 3, 4}}}};
  builder.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.5}}}}};
  builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "point"}, {"intensity", 1366}}};
  return builder;
}

inline void say(GltfBuilder& builder, const std::string& pointer, const json& what) {
  builder.json[json::json_pointer(pointer)]["extras"]["restframe"] = what;
}

inline const std::string street_lamp = "/extensions/KHR_lights_punctual/lights/0";

class AuthoredAsset : public testing::Test {
 protected:
  Scene load(const GltfBuilder& builder) {
    warnings_.clear();
    return load_scene(folder_.write("street.glb", builder.glb()), {}, warnings_);
  }

  Scene load_toml(const std::string& text) {
    warnings_.clear();
    return load_scene(folder_.write("scene.toml", text), {}, warnings_);
  }

  // What loading reports, without the folder's name.
  template <class Load>
  std::vector<std::string> faults_of(const Load& load) {
    try {
      load();
    } catch (const InputError& error) {
      std::vector<std::string> lines = error.faults();
      for (std::string& line : lines) line = without_folder(line);
      return lines;
    }
    return {};
  }
  std::vector<std::string> faults(const GltfBuilder& builder) {
    return faults_of([&] { load(builder); });
  }

  std::string without_folder(std::string line) const {
    const std::string folder = folder_.path().string() + "/";
    for (auto at = line.find(folder); at != std::string::npos; at = line.find(folder)) {
      line.erase(at, folder.size());
    }
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
    return line;
  }

  static const Object& object(const Scene& scene, const std::string& name) {
    const auto has_name = [&](const Object& each) { return each.name == name; };
    const auto found = std::find_if(scene.objects.begin(), scene.objects.end(), has_name);
    if (found == scene.objects.end()) throw std::runtime_error("there is no object " + name);
    return *found;
  }

  TemporaryFolder folder_;
  Warnings warnings_;
};

}  // namespace restframe::test
