#pragma once

#include "tracer/exposed_camera.h"
#include "tracer/sample.h"

namespace restframe {

// How what is seen moves over the film until the next picture: as it appears, which is faster than
// light where something comes towards the camera, since its light has ever less far to go.
//
// A point rests in its object's rest frame. The next picture's camera sees it where it was on that
// event's past light cone; the sight line there, boosted into the camera and projected, is where the
// point is seen next.
class ApparentMotion {
 public:
  // Longer than the diagonal of any picture, and within the range of half: what leaves the next
  // camera's view for the side, or for behind it, goes as far.
  static constexpr double longest = 60'000;  // pixels

  // next_opening: the camera's time at which the next picture's first exposure opens. Both must
  // outlive it.
  ApparentMotion(const Scene& scene, const ExposedCamera& camera, double next_opening);

  // Pixels to the right and up, from the film point at which it is seen now; film: right and down.
  Vec2 operator()(const SurfaceData& seen, const Vec2& film) const;

 private:
  struct FilmPoint {
    Vec2 film{0};        // right and down
    bool ahead = false;  // else `film` is the way to the side, of any length
  };
  FilmPoint seen_by(const ExposedCamera::Moment& moment, const SurfaceData& seen) const;
  FilmPoint seen_next(const SurfaceData& seen, const Vec2& film) const;

  const Scene& scene_;
  const ExposedCamera& camera_;
  double opening_;
  ExposedCamera::Moment moment_;  // at the opening
};

}  // namespace restframe
