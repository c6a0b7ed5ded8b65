#include "tracer/exposed_camera.h"

#include <algorithm>
#include <cmath>

#include "physics/clones.h"
#include "tracer/null_ray.h"

namespace restframe {
namespace {

// A pixel's samples share what it covers; but no texture is made sharper than an eighth of a pixel.
double pixels_a_ray(const Scene& scene) {
  if (scene.textures.empty()) return 0.0;
  return std::max(0.125, 1.0 / std::sqrt(static_cast<double>(scene.render.samples)));
}

// A ray as the camera has it, told from its event at the exposure's opening.
struct CameraRay {
  Displacement<in::Camera> origin;
  Vec3 direction;
};

inline CameraRay pinhole_ray(const Projection& projection, const CameraSample& sample, int lane) {
  return {{sample.after_opening[lane], {0, 0, 0}},
          projection.direction(sample.film_x[lane], sample.film_y[lane])};
}

inline CameraRay lens_ray(const CameraPose& pose, const Projection& projection, double focus,
                          const CameraSample& sample, int lane) {
  const Vec3 through = projection.corner() + sample.film_x[lane] * projection.step_x() +
                       sample.film_y[lane] * projection.step_y();  // 1 along the camera's axis
  const Vec3 on_lens = sample.lens_x[lane] * pose.axes[0] + sample.lens_y[lane] * pose.axes[1];
  return {{sample.after_opening[lane], on_lens}, glm::normalize(focus * through - on_lens)};
}

}  // namespace

ExposedCamera::ExposedCamera(const Scene& scene, const CameraSampler& sampler, double opening,
                             Eye eye)
    : scene_(scene),
      eye_(eye),
      is_pinhole_(!sampler.has_lens()),
      is_instant_(sampler.is_instant()),
      is_steady_(is_instant_ || is_steady(scene.camera)),
      pixels_a_ray_(pixels_a_ray(scene)) {
  for (int i = 0; i < scene.exposure.count; ++i) {
    openings_.push_back(moment_at(opening + i * scene.exposure.interval));
  }
}

ExposedCamera::Moment ExposedCamera::moment_at(double time) const {
  const CameraPose pose = pose_at(scene_.camera, time, eye_);
  return {time, pose,
          Projection(pose, pose.vertical_fov, scene_.render.width, scene_.render.height)};
}

RESTFRAME_CLONES void ExposedCamera::rays(int exposure, const CameraSample& sample,
                                          RayPacket& rays) const {
  const Moment& opening = openings_[static_cast<std::size_t>(exposure)];
  if (is_instant_ && is_pinhole_) {
    camera_rays(opening.pose, opening.projection, sample.film_x, sample.film_y, rays);
  } else if (is_steady_) {
    steady_rays(opening, sample, rays);
  } else {
    changing_rays(opening, sample, rays);
  }
  if (pixels_a_ray_ > 0.0) {
    set_spread(opening.projection, pixels_a_ray_, sample.film_x, sample.film_y, rays);
  }
}

CameraSight ExposedCamera::sight(int exposure, const CameraSample& sample, int lane) const {
  const Moment& opening = openings_[static_cast<std::size_t>(exposure)];
  const Moment moment =
      is_instant_ ? opening : moment_at(opening.time + sample.after_opening[lane]);
  return {moment.pose, moment.projection.direction(sample.film_x[lane], sample.film_y[lane])};
}

// One boost and one projection for all lanes: only the event moves.
void ExposedCamera::steady_rays(const Moment& opening, const CameraSample& sample,
                                RayPacket& rays) const {
  const CameraPose pose = opening.pose;
  const Projection projection = opening.projection;
  if (is_pinhole_) {
    camera_rays(pose, projection, sample.film_x, sample.film_y, rays);
    rays.one_event = false;
    const Displacement<in::World> second =
        pose.world_from_camera(Displacement<in::Camera>{1.0, {}});
#pragma GCC ivdep
    for (int i = 0; i < packet_size; ++i) {
      const double t = sample.after_opening[i];
      rays.origin.set(i, pose.event + Displacement<in::World>{t * second.t, t * second.x});
    }
    return;
  }
  WaveVectorLanes<in::Camera> k;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const CameraRay ray = lens_ray(pose, projection, scene_.camera.focus, sample, i);
    rays.origin.set(i, pose.event + pose.world_from_camera(ray.origin));
    k.set(i, looking_along<in::Camera>(ray.direction));
  }
  transform(pose.world_from_camera, k, rays.k);
  rays.s_min.fill(0.0);
}

// Each lane has a camera of its own.
void ExposedCamera::changing_rays(const Moment& opening, const CameraSample& sample,
                                  RayPacket& rays) const {
  for (int i = 0; i < packet_size; ++i) {
    const Moment moment = moment_at(opening.time + sample.after_opening[i]);
    const CameraRay ray =
        is_pinhole_ ? pinhole_ray(moment.projection, sample, i)
                    : lens_ray(moment.pose, moment.projection, scene_.camera.focus, sample, i);
    const Displacement<in::Camera> on_lens{0.0, ray.origin.x};
    rays.origin.set(i, moment.pose.event + moment.pose.world_from_camera(on_lens));
    rays.k.set(i, moment.pose.world_from_camera(looking_along<in::Camera>(ray.direction)));
  }
  rays.s_min.fill(0.0);
}

}  // namespace restframe
