#include "tracer/preview.h"

namespace restframe {
namespace {

// Below this much light from behind, what lies behind is left out.
constexpr float least_transmittance = 1e-4F;
constexpr int most_layers = 1000;

float beaming_factor(const Scene& scene, double doppler) {
  if (!scene.render.beaming) return 1.0F;
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
    : scene_(scene), frames_(frames), places_(object_places(scene, frames)) {}

Vec4f Preview::texel(const TextureUse& use, const Surface& surface) const {
  if (use.texture < 0) return Vec4f(1);
  const Texture& texture = scene_.textures[static_cast<std::size_t>(use.texture)];
  const Image& image = scene_.images[static_cast<std::size_t>(texture.image)];
  return sample_texture(texture, image, surface.uv[static_cast<std::size_t>(use.uv_set)]);
}

float Preview::coverage(const Material& material, const Surface& surface, float texture_alpha,
                        TemporalEvaluator& evaluator) const {
  if (surface.back && !material.double_sided) return 0.0F;
  if (material.alpha_mode == AlphaMode::opaque) return 1.0F;
  const float alpha = evaluator(material.opacity, surface.clock) * texture_alpha * surface.color.w;
  if (material.alpha_mode == AlphaMode::mask) return alpha >= material.alpha_cutoff ? 1.0F : 0.0F;
  return glm::clamp(alpha, 0.0F, 1.0F);
}

Preview::Shaded Preview::shade(const Surface& surface, TemporalEvaluator& evaluator) const {
  const Material& material = scene_.materials[static_cast<std::size_t>(surface.material)];
  const Vec4f base_texel = texel(material.base_color_texture, surface);
  Shaded shaded;
  shaded.alpha = coverage(material, surface, base_texel.w, evaluator);
  if (shaded.alpha <= 0.0F) return shaded;
  const Vec3f base =
      evaluator(material.base_color, surface.clock) * Vec3f(base_texel) * Vec3f(surface.color);
  const Vec3f emission = evaluator(material.emission, surface.clock) *
                         evaluator(material.emission_strength, surface.clock) *
                         Vec3f(texel(material.emission_texture, surface));
  const Vec3f seen = base * (material.unlit ? 1.0F : surface.cosine) + emission;
  shaded.color = seen * (shaded.alpha * beaming_factor(scene_, surface.doppler));
  return shaded;
}

SurfaceData Preview::data_of(const Surface& surface, const RayPacket& rays, const HitPacket& hits,
                             int lane) const {
  SurfaceData data;
  data.hit = true;
  data.object = surface.object;
  data.material = surface.material;
  data.distance = hits.s[lane];
  data.time_proper = surface.clock;
  data.time_world = rays.origin.t[lane] + hits.s[lane] * rays.k.t[lane];
  data.doppler = surface.doppler;
  data.position = position_on_object(frames_, places_, hits, lane);
  data.normal = surface.normal;
  data.uv = surface.uv[0];
  return data;
}

void Preview::trace(RayPacket& rays, const Lanes<SampleId>& ids, TemporalEvaluator& evaluator,
                    RadianceLanes& radiance, SurfaceDataLanes* data) const {
  radiance.r.fill(0.0F);
  radiance.g.fill(0.0F);
  radiance.b.fill(0.0F);
  radiance.a.fill(0.0F);
  if (data != nullptr) data->fill({});
  HitPacket hits;
  bool passing = true;
  for (std::uint32_t layer = 0; passing && layer < most_layers; ++layer) {
    frames_.nearest(rays, hits);
    passing = false;
    for (int lane = 0; lane < packet_size; ++lane) {
      if (rays.active[lane] == 0) continue;
      if (hits.frame[lane] < 0) {
        rays.active[lane] = 0;
        continue;
      }
      const Surface surface = surface_at(scene_, frames_, places_, hits, lane);
      const Shaded shaded = shade(surface, evaluator);
      composite(radiance, lane, shaded.color, shaded.alpha);
      if (data != nullptr && !(*data)[lane].hit &&
          random_unit(ids[lane], Dimension::opacity, layer) < shaded.alpha) {
        (*data)[lane] = data_of(surface, rays, hits, lane);
      }
      if (1.0F - radiance.a[lane] < least_transmittance) {
        radiance.a[lane] = 1.0F;
        rays.active[lane] = 0;
      } else {
        rays.s_min[lane] = frames_.frame(hits.frame[lane]).s_behind(hits, lane);
        passing = true;
      }
    }
  }
}

}  // namespace restframe
