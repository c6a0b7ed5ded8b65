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

}  // namespace restframe
