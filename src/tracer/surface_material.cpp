#include "tracer/surface_material.h"

#include "tracer/footprint.h"
#include "tracer/shading_normal.h"

namespace restframe {
namespace {

// Formulas may leave the range of what they stand for.
float fraction(float value) {
  return glm::clamp(value, 0.0F, 1.0F);
}

float alpha_of(float roughness, float texture) {
  const float product = fraction(roughness) * texture;
  return product * product;
}

// Of glass it is on the outside: there is none that light meets from within.
float coat_of(const MetSurface& met, double clock, TemporalEvaluator& evaluator) {
  const Material& material = met.material();
  const float coat = fraction(evaluator(material.clearcoat, clock));
  const bool within = met.surfaces.back[met.lane] != 0 && refracts(material);
  return coat <= 0.0F || within ? 0.0F : coat * texel(met, material.clearcoat_texture).x;
}

float coat_alpha_of(const MetSurface& met, double clock, TemporalEvaluator& evaluator) {
  const Material& material = met.material();
  return alpha_of(evaluator(material.clearcoat_roughness, clock),
                  texel(met, material.clearcoat_roughness_texture).y);
}

}  // namespace

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
  const bool seen_from_behind = material.double_sided || refracts(material);
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

void set_finish(const MetSurface& met, double clock, TemporalEvaluator& evaluator,
                BsdfLanes& bsdf) {
  const Material& material = met.material();
  const int lane = met.lane;
  const Vec4f finish = texel(met, material.metallic_roughness_texture);
  bsdf.metallic[lane] = fraction(evaluator(material.metallic, clock)) * finish.z;
  bsdf.alpha[lane] = alpha_of(evaluator(material.roughness, clock), finish.y);
  bsdf.specular[lane] =
      fraction(evaluator(material.specular, clock)) * texel(met, material.specular_texture).w;
  bsdf.specular_color.set(lane, glm::max(evaluator(material.specular_color, clock), Vec3f(0)) *
                                    Vec3f(texel(met, material.specular_color_texture)));
}

BsdfLayers layers(const MetSurface& met, double clock, TemporalEvaluator& evaluator) {
  const Material& m = met.material();
  BsdfLayers layers;
  layers.thin = m.thin_walled;
  layers.transmission = fraction(evaluator(m.transmission, clock));
  if (layers.transmission > 0.0F) layers.transmission *= texel(met, m.transmission_texture).x;
  layers.coat = coat_of(met, clock, evaluator);
  if (layers.coat > 0.0F) {
    layers.coat_alpha = coat_alpha_of(met, clock, evaluator);
    layers.coat_normal = clearcoat_normal(met);
  }
  layers.sheen = glm::clamp(evaluator(m.sheen_color, clock), Vec3f(0), Vec3f(1));
  if (layers.sheen != Vec3f(0)) {
    layers.sheen *= Vec3f(texel(met, m.sheen_color_texture));
    layers.sheen_alpha =
        alpha_of(evaluator(m.sheen_roughness, clock), texel(met, m.sheen_roughness_texture).w);
  }
  return layers;
}

float below_coat(const MetSurface& met, float cosine, double clock, TemporalEvaluator& evaluator) {
  const float coat = coat_of(met, clock, evaluator);
  if (coat <= 0.0F) return 1.0F;
  return 1.0F - coat_reflection(coat, coat_alpha_of(met, clock, evaluator), cosine);
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
