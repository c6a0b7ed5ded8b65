#include "tracer/surface_material.h"

#include "tracer/footprint.h"

namespace restframe {

Vec4f texel(const MetSurface& met, const TextureUse& use) {
  if (use.texture < 0) return Vec4f(1);
  const Texture& texture = met.scene.textures[static_cast<std::size_t>(use.texture)];
  const Image& image = met.scene.images[static_cast<std::size_t>(texture.image)];
  const Vec2f uv = use.transform(uv_at(met.scene, met.frames, met.hits, met.lane, use.uv_set));
  if (met.tables == nullptr || !(met.width > 0)) return sample_texture(texture, image, uv);
  return sample_texture(texture, image, met.tables->mips(use.texture), uv, footprint(met, use));
}

float opacity(const MetSurface& met, float texture_alpha, double clock,
              TemporalEvaluator& evaluator) {
  const Material& material = met.material();
  if (material.alpha_mode == AlphaMode::opaque) return 1.0F;
  const float alpha =
      evaluator(material.opacity, clock) * texture_alpha * met.surfaces.color_at(met.lane).w;
  if (material.alpha_mode == AlphaMode::mask) return alpha >= material.alpha_cutoff ? 1.0F : 0.0F;
  return glm::clamp(alpha, 0.0F, 1.0F);
}

float coverage(const MetSurface& met, float texture_alpha, double clock,
               TemporalEvaluator& evaluator) {
  const Material& material = met.material();
  const bool seen_from_behind = material.double_sided || can_transmit(material);
  if (met.surfaces.back[met.lane] != 0 && !seen_from_behind) return 0.0F;
  return opacity(met, texture_alpha, clock, evaluator);
}

Vec3f base_color(const MetSurface& met, const Vec4f& texture, double clock,
                 TemporalEvaluator& evaluator) {
  return evaluator(met.material().base_color, clock) * Vec3f(texture) *
         Vec3f(met.surfaces.color_at(met.lane));
}

Vec3f emission(const MetSurface& met, double clock, TemporalEvaluator& evaluator) {
  const Material& material = met.material();
  return evaluator(material.emission, clock) * evaluator(material.emission_strength, clock) *
         Vec3f(texel(met, material.emission_texture));
}

SurfaceData surface_data(const MetSurface& met, const ObjectPlace& place, const RayPacket& rays) {
  const int lane = met.lane;
  SurfaceData data;
  data.hit = true;
  data.object = met.surfaces.object[lane];
  data.material = met.surfaces.material[lane];
  data.distance = met.hits.s[lane];
  data.time_proper = clock_at(place, met.hits, lane);
  data.time_world = rays.origin.t[lane] + met.hits.s[lane] * rays.k.t[lane];
  data.doppler = doppler_at(met.hits, lane);
  data.position = position_on_object(met.frames, place, met.hits, lane);
  data.normal = Vec3(met.surfaces.normal.at(lane));
  data.uv = uv_at(met.scene, met.frames, met.hits, lane, 0);
  return data;
}

}  // namespace restframe
