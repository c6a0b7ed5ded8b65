#include "tracer/preview.h"

namespace restframe {
namespace {

// Below this much light from behind, what lies behind is left out.
constexpr float least_transmittance = 1e-4F;
constexpr std::uint32_t most_layers = 1000;

float beaming_factor(double doppler) {
  const double squared = doppler * doppler;
  return static_cast<float>(squared * squared);  // bolometric radiance gains D^4
}

}  // namespace

Preview::Preview(const Scene& scene, const FrameSet& frames)
    : scene_(scene), frames_(frames), places_(object_places(scene, frames)) {
  for (const Material& material : scene.materials) plain_.push_back(plain(material));
}

Preview::Plain Preview::plain(const Material& m) {
  const bool changes = m.base_color.function != no_function || m.opacity.function != no_function ||
                       m.emission.function != no_function ||
                       m.emission_strength.function != no_function;
  const bool textured = m.base_color_texture.texture >= 0 || m.emission_texture.texture >= 0;
  Plain result;
  result.always = !changes && !textured && m.alpha_mode == AlphaMode::opaque;
  result.double_sided = m.double_sided;
  const Vec4f base(m.base_color.value, 0.0F);
  result.lit = m.unlit ? Vec4f(0) : base;
  result.unlit = m.unlit ? base : Vec4f(0);
  result.emission = Vec4f(m.emission.value * m.emission_strength.value, 1.0F);
  return result;
}

Vec4f Preview::texel(const TextureUse& use, const Met& met) const {
  if (use.texture < 0) return Vec4f(1);
  const Texture& texture = scene_.textures[static_cast<std::size_t>(use.texture)];
  const Image& image = scene_.images[static_cast<std::size_t>(texture.image)];
  return sample_texture(texture, image, uv_at(scene_, frames_, met.hits, met.lane, use.uv_set));
}

float Preview::coverage(const Material& material, const Met& met, float texture_alpha, double clock,
                        TemporalEvaluator& evaluator) const {
  if (met.surfaces.back[met.lane] != 0 && !material.double_sided) return 0.0F;
  if (material.alpha_mode == AlphaMode::opaque) return 1.0F;
  const float alpha =
      evaluator(material.opacity, clock) * texture_alpha * met.surfaces.color[met.lane].w;
  if (material.alpha_mode == AlphaMode::mask) return alpha >= material.alpha_cutoff ? 1.0F : 0.0F;
  return glm::clamp(alpha, 0.0F, 1.0F);
}

Vec4f Preview::shade_changing(const Met& met, TemporalEvaluator& evaluator) const {
  const SurfaceLanes& surfaces = met.surfaces;
  const Material& material =
      scene_.materials[static_cast<std::size_t>(surfaces.material[met.lane])];
  frames_.refine(met.hits, met.lane);
  const double clock =
      clock_at(places_[static_cast<std::size_t>(surfaces.object[met.lane])], met.hits, met.lane);
  const Vec4f base_texel = texel(material.base_color_texture, met);
  const float alpha = coverage(material, met, base_texel.w, clock, evaluator);
  if (alpha <= 0.0F) return Vec4f(0);
  const Vec3f base =
      evaluator(material.base_color, clock) * Vec3f(base_texel) * Vec3f(surfaces.color[met.lane]);
  const Vec3f emission = evaluator(material.emission, clock) *
                         evaluator(material.emission_strength, clock) *
                         Vec3f(texel(material.emission_texture, met));
  const Vec3f seen = base * (material.unlit ? 1.0F : surfaces.cosine[met.lane]) + emission;
  return alpha * Vec4f(seen, 1.0F);
}

inline Vec4f Preview::shade(const Met& met, TemporalEvaluator& evaluator) const {
  const SurfaceLanes& surfaces = met.surfaces;
  const Plain& plain = plain_[static_cast<std::size_t>(surfaces.material[met.lane])];
  Vec4f shaded(0);
  if (!plain.always) {
    shaded = shade_changing(met, evaluator);
  } else if (surfaces.back[met.lane] == 0 || plain.double_sided) {
    shaded = (plain.lit * surfaces.cosine[met.lane] + plain.unlit) * surfaces.color[met.lane] +
             plain.emission;
  }
  if (scene_.render.beaming) {
    const float factor = beaming_factor(doppler_at(met.hits, met.lane));
    shaded *= Vec4f(factor, factor, factor, 1.0F);
  }
  return shaded;
}

SurfaceData Preview::data_of(const Met& met) const {
  const int lane = met.lane;
  frames_.refine(met.hits, lane);
  const ObjectPlace& place = places_[static_cast<std::size_t>(met.surfaces.object[lane])];
  SurfaceData data;
  data.hit = true;
  data.object = met.surfaces.object[lane];
  data.material = met.surfaces.material[lane];
  data.distance = met.hits.s[lane];
  data.time_proper = clock_at(place, met.hits, lane);
  data.time_world = met.rays.origin.t[lane] + met.hits.s[lane] * met.rays.k.t[lane];
  data.doppler = doppler_at(met.hits, lane);
  data.position = position_on_object(frames_, place, met.hits, lane);
  data.normal = Vec3(met.surfaces.normal.at(lane));
  data.uv = uv_at(scene_, frames_, met.hits, lane, 0);
  return data;
}

void Preview::trace(RayPacket& rays, const PacketId& id, TemporalEvaluator& evaluator,
                    RadianceLanes& radiance, SurfaceDataLanes* data) const {
  radiance.fill(Vec4f(0));
  if (data != nullptr) data->fill({});
  HitPacket hits;
  SurfaceLanes surfaces;
  bool passing = true;
  for (std::uint32_t layer = 0; passing && layer < most_layers; ++layer) {
    frames_.nearest(rays, hits);
    surfaces_at(scene_, frames_, hits, rays.active, surfaces);
    passing = false;
    for (int lane = 0; lane < packet_size; ++lane) {
      if (rays.active[lane] == 0) continue;
      rays.active[lane] = 0;
      if (hits.frame[lane] < 0) continue;
      const Met met{rays, surfaces, hits, lane};
      const Vec4f shaded = shade(met, evaluator);
      radiance[lane] += (1.0F - radiance[lane].w) * shaded;  // behind what is in front
      if (data != nullptr && !(*data)[lane].hit &&
          random_unit(id, lane, Dimension::opacity, layer) < shaded.w) {
        (*data)[lane] = data_of(met);
      }
      if (1.0F - radiance[lane].w < least_transmittance) {
        radiance[lane].w = 1.0F;
      } else {
        rays.s_min[lane] = frames_.frame(hits.frame[lane]).s_behind(hits, lane);
        rays.active[lane] = -1;
        passing = true;
      }
    }
  }
}

}  // namespace restframe
