#pragma once

#include <vector>

#include "frames/packet.h"
#include "scene/scene.h"
#include "tracer/camera_sampler.h"

namespace restframe {

// A ray as the camera has it.
struct CameraSight {
  CameraPose pose;  // as it begins
  Vec3 direction;   // unit, in the camera's rest frame
};

// The camera during the exposures of one picture: from samples to rays.
//
// A ray begins at its own moment of the camera's time, on the lens at rest in the camera's frame:
// all points of the lens at the same camera time are as many events in the world. It goes to where
// the pinhole's ray through the same film point meets the plane that is sharp.
class ExposedCamera {
 public:
  // opening: the camera's time at which the first exposure opens. Throws as pose_at.
  ExposedCamera(const Scene& scene, const CameraSampler& sampler, double opening,
                Eye eye = Eye::centre);

  // Origins, wave vectors and s_min of the rays of one sample of an exposure. Throws as pose_at.
  void rays(int exposure, const CameraSample& sample, RayPacket& rays) const;

  // Of the ray of `lane` through the middle of the lens.
  CameraSight sight(int exposure, const CameraSample& sample, int lane) const;

  // Where it is at a time of its own, and how it maps directions to the film. Throws as pose_at.
  struct Moment {
    double time;
    CameraPose pose;
    Projection projection;
  };
  Moment moment_at(double time) const;

 private:
  void steady_rays(const Moment& opening, const CameraSample& sample, RayPacket& rays) const;
  void changing_rays(const Moment& opening, const CameraSample& sample, RayPacket& rays) const;

  const Scene& scene_;
  Eye eye_;
  bool is_pinhole_, is_instant_, is_steady_;
  double pixels_a_ray_ = 0;       // on the film, the side of what each stands for; 0: nobody asks
  std::vector<Moment> openings_;  // of each exposure
};

}  // namespace restframe
