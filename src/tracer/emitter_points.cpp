#include "tracer/emitter_points.h"

#include <cmath>

#include "frames/lane_groups.h"
#include "physics/clones.h"
#include "tracer/light_arrival.h"

namespace restframe {
namespace {

void set_color(const Mesh& mesh, int lane, EmitterPoints& points) {
  if (mesh.colors.empty()) return;
  if (!points.surfaces.colored) points.surfaces.color.fill(Vec4f(1));
  points.surfaces.colored = true;
  const Triangle& t = mesh.triangles[points.hits.triangle[lane]];
  const float u = points.hits.bary_u[lane], v = points.hits.bary_v[lane];
  points.surfaces.color[lane] =
      (1.0F - u - v) * mesh.colors[t[0]] + u * mesh.colors[t[1]] + v * mesh.colors[t[2]];
}

// Uniform over the triangle.
void choose_point(const EmitterStage& stage, const Emitters::Chosen& chosen, int lane, float u,
                  float v, EmitterPoints& points) {
  const EmittingPatch& patch = *chosen.patch;
  const FramePart& part = stage.frames.frame(patch.frame).part(patch.part);
  const RestTriangle triangle = rest_triangle(stage.scene, part, chosen.triangle);
  const float root = std::sqrt(u);
  const float b = root * (1.0F - v), c = root * v;
  points.hits.part[lane] = patch.part;
  points.hits.triangle[lane] = chosen.triangle;
  points.hits.bary_u[lane] = b;
  points.hits.bary_v[lane] = c;
  points.surfaces.object[lane] = patch.object;
  points.surfaces.material[lane] = patch.material;
  points.place.set(lane, triangle.corners[0] +
                             static_cast<double>(b) * (triangle.corners[1] - triangle.corners[0]) +
                             static_cast<double>(c) * (triangle.corners[2] - triangle.corners[0]));
  points.normal.set(lane, triangle.normal);
  points.per_area[lane] = chosen.chance / triangle.area;
  points.active[lane] = triangle.area > 0.0 ? -1 : 0;
  set_color(stage.scene.meshes[static_cast<std::size_t>(part.mesh)], lane, points);
}

// All events see their points as if these were in the frame of `place`; the group's are. A density
// over area becomes one over solid angle in the emitter's frame, by distance^2 / cosine, and one in
// the surface's by D^2: together by the squared distance in the surface's frame.
void see_group(const LightPlace& place, const EventLanes<in::World>& event, const LitLanes& lit,
               const Lanes<std::int32_t>& group, EmitterPoints& points, PointsSeen& seen,
               IncidentLanes& incident) {
  EventLanes<in::LightRest> at;
  to_light(place, event, at);
  Vec3Lanes towards;
  Lanes<double> distance;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const Vec3 there = points.place.at(i) - at.x.at(i);
    distance[i] = std::sqrt(glm::dot(there, there));
    towards.set(i, there / distance[i]);
  }
  Arrival arrival;
  IncidentLanes arriving;
  arrive(place, lit, towards, arrival, arriving);
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const double facing = -glm::dot(points.normal.at(i), towards.at(i));
    const double length = distance[i] * arrival.frequency[i];
    const double density = points.per_area[i] * length * length / std::abs(facing);
    const bool comes = density > 0.0 && density < 1e300;
    set_in(group, i, incident.active, comes ? -1 : 0);
    set_in(group, i, points.surfaces.back, facing < 0.0 ? 1 : 0);
    set_in(group, i, points.surfaces.cosine, static_cast<float>(std::abs(facing)));
    set_in(group, i, seen.density, density);
    set_in(group, i, seen.doppler, arrival.doppler[i]);
    set_in(group, i, seen.rest_t, at.t[i] - distance[i]);
    set_in(group, i, incident.s_light, distance[i] * arrival.doppler[i]);
    set_in(group, i, incident.k.t, arriving.k.t[i]);
    set_in(group, i, incident.k.x, arriving.k.x.at(i));
    set_in(group, i, incident.direction, arriving.direction.at(i));
  }
}

}  // namespace

void choose_points(const EmitterStage& stage, const EventLanes<in::World>& event,
                   const LitLanes& lit, const Vec3fLanes& facing, const PointNumbers& numbers,
                   EmitterPoints& points) {
  points.surfaces.colored = false;
  points.active.fill(0);
  for (int lane = 0; lane < packet_size; ++lane) {
    if (lit.active[lane] == 0) continue;
    const std::int32_t frame =
        stage.emitters.choose_frame(static_cast<double>(numbers.frame[lane]));
    points.hits.frame[lane] = frame;
    const Receiver receiver = stage.emitters.receiver(
        frame, event.at(lane), lit.rest_from_world[lane]->velocity(), facing.at(lane));
    const auto chosen = stage.emitters.choose(frame, receiver, numbers.triangle[lane]);
    if (!(chosen.chance > 0.0)) continue;
    choose_point(stage, chosen, lane, numbers.u[lane], numbers.v[lane], points);
  }
}

RESTFRAME_CLONES void see_points(const EmitterStage& stage, const EventLanes<in::World>& event,
                                 const LitLanes& lit, EmitterPoints& points, PointsSeen& seen,
                                 IncidentLanes& incident) {
  incident.active.fill(0);
  for_each_group(points.hits.frame, points.active,
                 [&](int first, const Lanes<std::int32_t>& group) {
                   see_group(stage.emitters.place(points.hits.frame[first]), event, lit, group,
                             points, seen, incident);
                 });
}

}  // namespace restframe
