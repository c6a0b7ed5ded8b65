#pragma once

#include "frames/packet.h"
#include "scene/camera.h"

namespace restframe {

// Rays of unit frequency from the camera's event through 16 film positions (pixels), in the world
// frame.
inline void camera_rays(const CameraPose& pose, const Projection& projection,
                        const Lanes<double>& film_x, const Lanes<double>& film_y, RayPacket& rays) {
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) rays.origin.set(i, pose.event);
  WaveVectorLanes<in::Camera> k;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    k.set(i, looking_along<in::Camera>(projection.direction(film_x[i], film_y[i])));
  }
  transform(pose.world_from_camera, k, rays.k);
  rays.s_min.fill(0.0);
  rays.one_event = true;
}

// Sets the angle that each ray stands for, in the camera's frame: the root of the solid angle of a
// square on the film with sides of `pixels` pixels.
inline void set_spread(const Projection& projection, double pixels, const Lanes<double>& film_x,
                       const Lanes<double>& film_y, RayPacket& rays) {
  const Vec3 corner = projection.corner(), step_x = projection.step_x(),
             step_y = projection.step_y();
  // The film is 1 from the camera: there a pixel covers this area, at distance d and at this cosine
  // 1/d the solid angle area / d^3.
  const double side = pixels * std::sqrt(glm::length(glm::cross(step_x, step_y)));
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const Vec3 sight = corner + film_x[i] * step_x + film_y[i] * step_y;
    const double squared = glm::dot(sight, sight);
    rays.spread[i] = static_cast<float>(side / std::sqrt(squared * std::sqrt(squared)));
  }
  rays.has_spread = true;
}

}  // namespace restframe
