#pragma once

#include <vector>

#include "scene/scene.h"
#include "tracer/random.h"
#include "tracer/shutter.h"

namespace restframe {

// Pixels, one a lane; lanes off the picture too.
struct PixelLanes {
  Lanes<std::int32_t> x, y;
};

// What one sample of 16 pixels is: where on the film, when, and through which point of the lens.
struct CameraSample {
  Lanes<double> film_x, film_y;  // pixels
  Lanes<double> after_opening;   // seconds of the camera's time since its exposure opened
  Lanes<double> lens_x, lens_y;  // right and up from the lens's centre, if any; light-seconds
};

// Spreads the samples of each pixel over film, shutter and lens.
//
// Sample i of n takes the i-th of n equal parts of the light that the shutter lets through: a
// pixel's samples are stratified in time, and the 16 lanes of a packet are close in time, so that
// their rays stay coherent. The moment within its part is a Kronecker sequence of the square root
// of 5, the point of the lens one of the square roots of 2 and 3; both begin at random for each
// pixel and exposure, which makes each of their samples uniform. The points on the film are the
// same in all pixels, film_offsets(), under a shutter in an order that does not go with time: what
// stands still looks as it does without a shutter.
class CameraSampler {
 public:
  explicit CameraSampler(const Scene& scene);

  // Whether the samples of a pixel are spread over time or the lens: then none of them is the ray
  // that data layers hold.
  bool spreads() const { return !shutter_.is_instant() || has_lens(); }
  bool is_instant() const { return shutter_.is_instant() && rolling_per_pixel_ == 0.0; }
  bool has_lens() const { return aperture_ > 0.0; }

  // What is drawn once for the pixels of a block and an exposure.
  struct Starts {
    Lanes<double> moment;  // as a fraction of a part
    Lanes<double> lens_u, lens_v;
  };
  // id: of the exposure's first sample.
  void start(const PacketId& id, Starts& starts) const;

  // Sample `index` of the exposure that `starts` belongs to.
  void take(const PixelLanes& pixels, const Starts& starts, int index, CameraSample& sample) const;

  // The next sample of a set that may end anywhere, and that is to be independent of other sets: all
  // of it is drawn. Pixels then differ along edges, and lanes in their times.
  void draw(const PixelLanes& pixels, PacketRandom& random, CameraSample& sample) const;

  // The pixels' centres, through the lens's centre, as the exposure opens.
  void take_center(const PixelLanes& pixels, CameraSample& sample) const;

 private:
  void place_on_film(const PixelLanes& pixels, int index, CameraSample& sample) const;
  void place_on_lens(const Starts& starts, int index, CameraSample& sample) const;
  void place_in_time(const Starts& starts, int index, CameraSample& sample) const;
  void add_rolling(CameraSample& sample) const;

  Shutter shutter_;
  std::vector<Vec2f> offsets_;    // of the samples on the film, from the pixel's centre
  double aperture_ = 0;           // light-seconds
  double rolling_per_pixel_ = 0;  // seconds
};

}  // namespace restframe
