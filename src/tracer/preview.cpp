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

// Composites `color` (premultiplied) behind what the lane has gathered so far.
void composite(RadianceLanes& radiance, int lane, const Vec3f& color, float alpha) {
  const float behind = 1.0F - radiance.a[lane];
  radiance.r[lane] += behind * color.x;
  radiance.g[lane] += behind * color.y;
  radiance.b[lane] += behind * color.z;
  radiance.a[lane] += behind * alpha;
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
  result.unlit = m.unlit;
  result.base_color = m.base_color.value;
  result.emission = m.emission.value * m.emission_strength.value;
  return result;
}

Vec4f Preview::texel(const TextureUse& use, const Surface& surface) const {
  if (use.texture < 0) return Vec4f(1);
  const Texture& texture = scene_.textures[static_cast<std::size_t>(use.texture)];
  const Image& image = scene_.images[static_cast<std::size_t>(texture.image)];
  return sample_texture(texture, image, surface.uv[static_cast<std::size_t>(use.uv_set)]);
}

float Preview::coverage(const Material& material, const Surface& surface, float texture_alpha,
                        double clock, TemporalEvaluator& evaluator) const {
  if (surface.back && !material.double_sided) return 0.0F;
  if (material.alpha_mode == AlphaMode::opaque) return 1.0F;
  const float alpha = evaluator(material.opacity, clock) * texture_alpha * surface.color.w;
  if (material.alpha_mode == AlphaMode::mask) return alpha >= material.alpha_cutoff ? 1.0F : 0.0F;
  return glm::clamp(alpha, 0.0F, 1.0F);
}

Preview::Shaded Preview::shade_changing(const Surface& surface, double clock,
                                        TemporalEvaluator& evaluator) const {
  const Material& material = scene_.materials[static_cast<std::size_t>(surface.material)];
  const Vec4f base_texel = texel(material.base_color_texture, surface);
  const float alpha = coverage(material, surface, base_texel.w, clock, evaluator);
  if (alpha <= 0.0F) return {};
  const Vec3f base =
      evaluator(material.base_color, clock) * Vec3f(base_texel) * Vec3f(surface.color);
  const Vec3f emission = evaluator(material.emission, clock) *
                         evaluator(material.emission_strength, clock) *
                         Vec3f(texel(material.emission_texture, surface));
  return {alpha * (base * (material.unlit ? 1.0F : surface.cosine) + emission), alpha};
}

Preview::Shaded Preview::shade(const Surface& surface, HitPacket& hits, int lane,
                               TemporalEvaluator& evaluator) const {
  const Plain& plain = plain_[static_cast<std::size_t>(surface.material)];
  Shaded shaded;
  if (!plain.always) {
    frames_.refine(hits, lane);
    const ObjectPlace& place = places_[static_cast<std::size_t>(surface.object)];
    shaded = shade_changing(surface, clock_at(place, hits, lane), evaluator);
  } else if (!surface.back || plain.double_sided) {
    const Vec3f base = plain.base_color * Vec3f(surface.color);
    shaded = {base * (plain.unlit ? 1.0F : surface.cosine) + plain.emission, 1.0F};
  }
  if (scene_.render.beaming) shaded.color *= beaming_factor(doppler_at(hits, lane));
  return shaded;
}

SurfaceData Preview::data_of(const Surface& surface, const RayPacket& rays, const HitPacket& hits,
                             int lane) const {
  const ObjectPlace& place = places_[static_cast<std::size_t>(surface.object)];
  SurfaceData data;
  data.hit = true;
  data.object = surface.object;
  data.material = surface.material;
  data.distance = hits.s[lane];
  data.time_proper = clock_at(place, hits, lane);
  data.time_world = rays.origin.t[lane] + hits.s[lane] * rays.k.t[lane];
  data.doppler = doppler_at(hits, lane);
  data.position = position_on_object(frames_, place, hits, lane);
  data.normal = surface.normal;
  data.uv = surface.uv[0];
  return data;
}

void Preview::trace(RayPacket& rays, const PacketId& id, TemporalEvaluator& evaluator,
                    RadianceLanes& radiance, SurfaceDataLanes* data) const {
  radiance = {};
  if (data != nullptr) data->fill({});
  HitPacket hits;
  bool passing = true;
  for (std::uint32_t layer = 0; passing && layer < most_layers; ++layer) {
    frames_.nearest(rays, hits);
    passing = false;
    for (int lane = 0; lane < packet_size; ++lane) {
      if (rays.active[lane] == 0) continue;
      rays.active[lane] = 0;
      if (hits.frame[lane] < 0) continue;
      const Surface surface = surface_at(scene_, frames_, hits, lane);
      const Shaded shaded = shade(surface, hits, lane, evaluator);
      composite(radiance, lane, shaded.color, shaded.alpha);
      if (data != nullptr && !(*data)[lane].hit &&
          random_unit(id, lane, Dimension::opacity, layer) < shaded.alpha) {
        frames_.refine(hits, lane);
        (*data)[lane] = data_of(surface, rays, hits, lane);
      }
      if (1.0F - radiance.a[lane] < least_transmittance) {
        radiance.a[lane] = 1.0F;
      } else {
        rays.s_min[lane] = frames_.frame(hits.frame[lane]).s_behind(hits, lane);
        rays.active[lane] = -1;
        passing = true;
      }
    }
  }
}

}  // namespace restframe
