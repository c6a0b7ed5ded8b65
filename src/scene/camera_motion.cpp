#include "scene/camera_motion.h"

#include <algorithm>
#include <cmath>

namespace restframe {
namespace {

// The mean of gamma while gamma beta goes straight from u to v.
//
// Along the line let w be the part of gamma beta on it, from w0 to w1 = w0 + q, and m^2 = 1 + the
// square of the part across: gamma^2 = m^2 + w^2. With w = m sinh(eta), and d = eta1 - eta0,
//     1/q int sqrt(m^2 + w^2) dw = m^2 / (2 q) (d + cosh(eta0 + eta1) sinh(d)),
//     m^2 sinh(d) = w1 gamma0 - w0 gamma1,   m^2 cosh(eta0 + eta1) = gamma0 gamma1 + w0 w1,
// each written below without a difference of like numbers.
double mean_gamma(const Vec3& u, const Vec3& v) {
  const double q = glm::length(v - u);
  if (q < 1e-8) return Velocity::from_gamma_beta(0.5 * (u + v)).gamma();  // in error by q^2 / 24
  const Vec3 along = (v - u) / q;
  const double w0 = glm::dot(u, along), w1 = w0 + q;
  const Vec3 across = u - w0 * along;
  const double m2 = 1.0 + glm::dot(across, across);
  const double gamma0 = std::sqrt(m2 + w0 * w0), gamma1 = std::sqrt(m2 + w1 * w1);
  const bool same_way = w0 * w1 > 0.0;
  const double sinh_d = same_way ? q * std::abs(w0 + w1) / std::abs(w1 * gamma0 + w0 * gamma1)
                                 : (w1 * gamma0 - w0 * gamma1) / m2;
  const double cosh_sum = same_way
                              ? (gamma0 * gamma1 + w0 * w1) / m2
                              : (m2 + w0 * w0 + w1 * w1) / (gamma0 * gamma1 + std::abs(w0 * w1));
  return m2 / (2.0 * q) * (std::asinh(sinh_d) + cosh_sum * sinh_d);
}

double sinh_over(double x) {
  return x == 0.0 ? 1.0 : std::sinh(x) / x;
}

// Hyperbolic motion for proper time tau, in the rest frame of its beginning: with the acceleration
// a from rest, t = sinh(a tau) / a, x = (cosh(a tau) - 1) / a = tau (a tau / 2) (sinh(a tau / 2) /
// (a tau / 2))^2 and gamma beta = sinh(a tau).
Worldline after_acceleration(const Worldline& from, const Vec3& acceleration, double tau) {
  const double rapidity = glm::length(acceleration) * tau;
  const double stretch = sinh_over(rapidity), half_stretch = sinh_over(0.5 * rapidity);
  const AnchoredFrame<in::Rest> frame = from.rest_frame();
  const Event<in::Rest> event{tau * stretch,
                              acceleration * (0.5 * tau * tau * half_stretch * half_stretch)};
  const Velocity gained = Velocity::from_gamma_beta(acceleration * (tau * stretch));
  return {frame.to_world(event), composed(frame.from_world, gained)};
}

CameraState state_on(const Worldline& worldline, double proper_time) {
  return {worldline.at_proper_time(proper_time), worldline.velocity};
}

}  // namespace

KeyedPath::KeyedPath(double time, std::vector<PathKey> keys, bool states_velocity)
    : time_(time), keys_(std::move(keys)), states_velocity_(states_velocity) {
  world_times_.assign(keys_.size(), 0.0);
  for (std::size_t i = 1; i < keys_.size(); ++i) {
    const double gamma = mean_gamma(gamma_beta_after(i - 1, 0), gamma_beta_after(i - 1, 1));
    world_times_[i] =
        world_times_[i - 1] + gamma * (keys_[i].proper_time - keys_[i - 1].proper_time);
  }
  // So far the first key's is 0; it is clock 0 that has the given time.
  const double first_time = time - state_at(0).event.t;
  for (double& world_time : world_times_) world_time += first_time;
}

// gamma beta at a fraction of the way from a key, not the last, to the next.
Vec3 KeyedPath::gamma_beta_after(std::size_t key, double fraction) const {
  const PathKey &from = keys_[key], &to = keys_[key + 1];
  if (states_velocity_) {
    return glm::mix(from.velocity.gamma_beta(), to.velocity.gamma_beta(), fraction);
  }
  return (to.position - from.position) / (to.proper_time - from.proper_time);
}

CameraState KeyedPath::held_at(std::size_t key, double proper_time) const {
  const Velocity velocity = states_velocity_ ? keys_[key].velocity : Velocity();
  const double since = proper_time - keys_[key].proper_time;
  return {{world_times_[key] + velocity.gamma() * since, keys_[key].position}, velocity};
}

CameraState KeyedPath::state_after(std::size_t key, double proper_time) const {
  const PathKey &from = keys_[key], &to = keys_[key + 1];
  const double since = proper_time - from.proper_time;
  const double fraction = since / (to.proper_time - from.proper_time);
  const Vec3 gamma_beta = gamma_beta_after(key, fraction);
  const double elapsed = since * mean_gamma(gamma_beta_after(key, 0), gamma_beta);
  return {{world_times_[key] + elapsed, glm::mix(from.position, to.position, fraction)},
          Velocity::from_gamma_beta(gamma_beta)};
}

CameraState KeyedPath::state_at(double proper_time) const {
  if (keys_.empty()) return {{time_ + proper_time, Vec3(0)}, Velocity()};
  if (keys_.size() == 1 || proper_time < keys_.front().proper_time) return held_at(0, proper_time);
  if (proper_time > keys_.back().proper_time) return held_at(keys_.size() - 1, proper_time);
  const auto is_before = [](double time, const PathKey& key) { return time < key.proper_time; };
  const auto next = std::upper_bound(keys_.begin() + 1, keys_.end() - 1, proper_time, is_before);
  return state_after(static_cast<std::size_t>(next - keys_.begin()) - 1, proper_time);
}

AcceleratedPath::AcceleratedPath(const Worldline& start, std::vector<AccelerationLeg> legs)
    : legs_(std::move(legs)), clocks_{0.0}, beginnings_{start} {
  for (const AccelerationLeg& leg : legs_) {
    clocks_.push_back(clocks_.back() + leg.duration);
    beginnings_.push_back(after_acceleration(beginnings_.back(), leg.acceleration, leg.duration));
  }
}

CameraState AcceleratedPath::state_at(double proper_time) const {
  const auto next = std::upper_bound(clocks_.begin(), clocks_.end(), proper_time);
  if (next == clocks_.begin()) return state_on(beginnings_.front(), proper_time);
  const auto leg = static_cast<std::size_t>(next - clocks_.begin()) - 1;
  const double since = proper_time - clocks_[leg];
  if (leg == legs_.size()) return state_on(beginnings_.back(), since);
  const Worldline here = after_acceleration(beginnings_[leg], legs_[leg].acceleration, since);
  return {here.reference, here.velocity};
}

CameraState state_at(const CameraMotion& motion, double proper_time) {
  if (const auto* keyed = std::get_if<KeyedPath>(&motion)) return keyed->state_at(proper_time);
  if (const auto* accelerated = std::get_if<AcceleratedPath>(&motion)) {
    return accelerated->state_at(proper_time);
  }
  return state_on(std::get<Worldline>(motion), proper_time);
}

}  // namespace restframe
