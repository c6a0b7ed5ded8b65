#pragma once

// Everything that a picture is made of, as plain data. Lengths are light-seconds (scene lengths
// divided by `light_speed`) except inside meshes; things refer to each other by index.

#include <string>
#include <vector>

#include "physics/worldline.h"
#include "scene/camera.h"
#include "scene/light.h"
#include "scene/material.h"
#include "scene/mesh.h"
#include "scene/settings.h"
#include "scene/sky_map.h"
#include "scene/texture.h"

namespace restframe {

// A mesh placed in an object. The object's coordinates are rest-frame axes around the object's
// origin.
struct PlacedMesh {
  int mesh = 0;
  Mat4 object_from_mesh{1};  // affine; the mesh's units to light-seconds; may mirror
  int name = -1;             // index into the object's part_names; -1: the object's own
};

// One clock, one velocity. Its worldline is that of its origin; the reference event is its
// `position` at its `time`.
struct Object {
  std::string name;
  Worldline worldline;
  double clock = 0;          // what its clock shows at the reference event ...
  bool frame_clock = false;  // ... or: the rest frame's own time, zero at the world's origin event
  std::vector<PlacedMesh> parts;
  // For mattes: what the parts are called, and what the object is a moving part of; empty: itself.
  std::vector<std::string> part_names;
  std::string whole;
  std::vector<int> materials;  // material index of each slot that the parts' meshes use
};

// A file that went into the scene, for the header of pictures.
struct SourceFile {
  std::string name;
  std::string hash;  // hexadecimal
};

struct Scene {
  double light_speed = 1;  // scene lengths a second
  Camera camera;
  bool camera_given = false;  // else one is chosen that frames everything
  AnimationSettings animation;
  ExposureSettings exposure;
  RenderSettings render;
  OutputSettings output;

  std::vector<Object> objects;
  std::vector<Light> lights;
  std::vector<Mesh> meshes;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<Image> images;
  std::vector<SkyMap> sky_maps;
  std::vector<TemporalFunction> functions;
  // Where each function comes from, for messages ("scene.toml:12:3: material \"rods\": base_color");
  // empty where nothing is known.
  std::vector<std::string> function_places;
  std::vector<SourceFile> sources;
};

// What the object's clock shows at its reference event.
double clock_at_reference(const Object& object);

// The worldline of a point that rests on the object, at `offset` (light-seconds, rest-frame axes)
// from its origin. Its reference is where the object's clock shows `clock`.
Worldline at_rest_on(const Object& object, const Vec3& offset, double clock);

// Likewise; its reference is at the world time of the object's own, which loses no digits however
// fast the object is.
Worldline at_rest_on(const Object& object, const Vec3& offset);

// Every fault that would keep the scene from being rendered, in words. An importer reports what it
// can with positions; this is the last guard, and the only one for scenes built by a program.
std::vector<std::string> validate(const Scene& scene);

}  // namespace restframe
