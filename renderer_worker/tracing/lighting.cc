// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/tracing/lighting.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace flair::renderer {
namespace {

constexpr float kMostGloss = 3;  // brighter reflections of lights would sparkle

// Radiance that the surface at a hit sends back.
Vec3 SentBack(const Setting& setting, Vec3 from, Vec3 direction, const Hit& hit) {
  const Vec3 normal = setting.world.GeometricNormalAt(hit, direction);
  const Vec3 position = from + direction * hit.distance + normal * 1e-3F;
  return setting.world.MeanColourAt(hit) * setting.radiosity.IrradianceAt(hit.instance, position, normal);
}

// Radiance that arrives from `direction`, without what LightChoice accounts for.
Vec3 Arriving(const Setting& setting, Vec3 from, Vec3 direction) {
  const Hit hit = setting.world.Feel(from, direction);
  return hit.instance < 0 ? setting.lights.Beyond(from, direction) : SentBack(setting, from, direction, hit);
}

// A normal of a facet of a rough surface (GGX with alpha = roughness squared).
Vec3 FacetNormal(Vec3 normal, float roughness, Vec2 sample) {
  const float alpha = roughness * roughness;
  const float tangent2 = alpha * alpha * sample.x / std::max(1 - sample.x, 1e-4F);
  const float cosine = 1 / std::sqrt(1 + tangent2), sine = std::sqrt(std::max(0.0F, 1 - cosine * cosine));
  const float angle = 2 * std::numbers::pi_v<float> * sample.y;
  Vec3 s, t;
  Basis(normal, s, t);
  return s * (sine * std::cos(angle)) + t * (sine * std::sin(angle)) + normal * cosine;
}

Vec3 GlossOf(const Setting& setting, const Seen& seen, Vec2 sample) {
  const Lights& lights = setting.lights;
  const Vec3 facet = FacetNormal(seen.normal, seen.roughness, sample);
  const float cosine = -Dot(facet, seen.direction);
  const Vec3 direction = seen.direction + facet * (2 * cosine);
  if (cosine <= 0 || Dot(direction, seen.normal) <= 0) return {};
  // Rough surfaces shadow themselves at grazing angles.
  const float grazing = FifthPower(1 - cosine) * (1 - seen.roughness) * (1 - seen.roughness);
  const Vec3 share = seen.specular * (1 - grazing) + Vec3{1, 1, 1} * grazing;
  const Hit hit = setting.world.Feel(seen.position, direction);
  Vec3 arriving;
  if (hit.instance >= 0) {
    arriving = SentBack(setting, seen.position, direction, hit);
  } else if (!lights.open_sky && lights.WindowThrough(seen.position, direction) >= 0) {
    arriving = lights.SkyRadiance(direction);
  } else {
    arriving = lights.Beyond(seen.position, direction);
  }
  const Vec3 gloss = share * arriving;
  const float most = std::max({gloss.x, gloss.y, gloss.z});
  return most > kMostGloss ? gloss * (kMostGloss / most) : gloss;
}

}  // namespace

LightMean IndirectLight(const Setting& setting, const Seen& seen, const PixelSamples& random, int first, int count) {
  if (seen.lit_instance == -1) return {};
  LightSum sum;
  for (int i = first; i < first + count; ++i) {
    const Vec3 direction = CosineDirection(seen.normal, random.At(i, Purpose::kBounce));
    sum.Add(Arriving(setting, seen.position, direction));
  }
  return sum.Mean();
}

Vec3 Gloss(const Setting& setting, const Seen& seen, const PixelSamples& random, int first, int count) {
  const float metal = std::max({seen.specular.x, seen.specular.y, seen.specular.z});
  if (seen.lit_instance < 0 || (seen.roughness > 0.65F && metal < 0.1F)) return {};
  Vec3 gloss;
  for (int i = first; i < first + count; ++i) gloss = gloss + GlossOf(setting, seen, random.At(i, Purpose::kGloss));
  return gloss * (1 / static_cast<float>(count));
}

}  // namespace flair::renderer
