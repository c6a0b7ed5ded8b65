#pragma once

// A square with a texture, for tests that look at it by rays or in pictures.

#include <array>
#include <vector>

#include "frames/frame_set.h"
#include "scene/scene.h"
#include "tracer/null_ray.h"
#include "tracer/surface_material.h"

namespace restframe {

// Pixels by bytes, RGBA.
inline Image image_of(int width, int height, std::vector<std::uint8_t> rgba) {
  Image image;
  image.width = width;
  image.height = height;
  image.rgba = std::move(rgba);
  return image;
}

inline void add_pixel(std::vector<std::uint8_t>& rgba, const std::array<std::uint8_t, 4>& pixel) {
  for (const std::uint8_t channel : pixel) rgba.push_back(channel);
}

// Black and white pixels.
inline Image checkerboard(int side) {
  std::vector<std::uint8_t> rgba;
  for (int i = 0; i < side * side; ++i) {
    const std::uint8_t grey = (i % side + i / side) % 2 == 0 ? 255 : 0;
    add_pixel(rgba, {grey, grey, grey, 255});
  }
  return image_of(side, side, std::move(rgba));
}

// From -half to half along x and y, its front towards +z, with the texture upright on it.
inline Mesh textured_square(float half, float repeats = 1) {
  Mesh mesh;
  mesh.positions = {{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}};
  mesh.uvs[0] = {{0, repeats}, {repeats, repeats}, {repeats, 0}, {0, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.materials = {{0, 0}};
  pad_for_embree(mesh);
  return mesh;
}

// One object of material 0 at the origin, which texture 0 is the image of; the camera looks along
// -z from (0, 0, distance), and sees x and y from -1 to 1 at z = 0.
inline Scene scene_of_square(Mesh mesh, Image image, double distance = 2, int pixels = 40) {
  Scene scene;
  scene.meshes.push_back(std::move(mesh));
  scene.images.push_back(std::move(image));
  scene.textures.emplace_back();
  scene.materials.emplace_back();
  Object object;
  object.name = "square";
  object.parts = {{0, Mat4(1)}};
  object.materials = {0};
  scene.objects = {object};
  std::get<Worldline>(scene.camera.motion).reference.x = {0, 0, distance};
  scene.camera.vertical_fov = 2 * std::atan(1 / distance);
  scene.camera_given = true;
  scene.render.width = scene.render.height = pixels;
  scene.render.samples = 1;
  scene.output.layers = {Layer::beauty, Layer::normal};
  return scene;
}

// 16 rays of the first picture, and what they meet.
struct MetPacket {
  MetPacket(const Scene& scene_in, const Lanes<double>& film_x, const Lanes<double>& film_y)
      : scene(scene_in), frames(scene_in, 1), tables(scene_in) {
    const CameraPose pose = pose_at(scene.camera, 0);
    const Projection projection(pose, pose.vertical_fov, scene.render.width, scene.render.height);
    rays.active.fill(-1);
    camera_rays(pose, projection, film_x, film_y, rays);
    set_spread(projection, 1, film_x, film_y, rays);
    frames.nearest(rays, hits);
    surfaces_at(scene, frames, hits, rays.active, surfaces);
    for (int lane = 0; lane < packet_size; ++lane) {
      if (hits.frame[lane] >= 0) frames.refine(hits, lane);
    }
  }
  MetSurface at(int lane) const {
    const float width = rays.spread[lane] * static_cast<float>(hits.s[lane]);
    return {scene, frames, surfaces, hits, lane, &tables, width};
  }

  const Scene& scene;
  FrameSet frames;
  SurfaceTables tables;
  RayPacket rays;
  HitPacket hits;
  SurfaceLanes surfaces;
};

}  // namespace restframe
