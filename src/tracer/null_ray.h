#pragma once

#include "frames/packet.h"
#include "scene/camera.h"

namespace restframe {

// Rays of unit frequency from the camera's event through 16 film positions (pixels), in the world
// frame.
inline void camera_rays(const CameraPose& pose, const Projection& projection,
                        const Lanes<double>& film_x, const Lanes<double>& film_y, RayPacket& rays) {
  for (int i = 0; i < packet_size; ++i) rays.origin.set(i, pose.event);
  for (int i = 0; i < packet_size; ++i) {
    const Vec3 direction = projection.direction(film_x[i], film_y[i]);
    rays.k.set(i, pose.world_from_camera(looking_along<in::Camera>(direction)));
  }
  rays.s_min.fill(0.0);
}

}  // namespace restframe
