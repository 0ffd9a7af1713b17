// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/tracing/lighting.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace flair::renderer {
namespace {

constexpr float kMostGloss = 3;  // brighter reflections of lights would sparkle

// Radiance that the surface at a hit sends back.
Vec3 SentBack(const World& world, const Radiosity& radiosity, Vec3 from, Vec3 direction, const Hit& hit) {
  const Vec3 normal = world.GeometricNormalAt(hit, direction);
  const Vec3 position = from + direction * hit.distance + normal * 1e-3F;
  return world.MeanColourAt(hit) * radiosity.IrradianceAt(hit.instance, position, normal);
}

// Radiance that arrives from `direction`, without what LightChoice accounts for.
Vec3 Arriving(const World& world, const Lights& lights, const Radiosity& radiosity, Vec3 from, Vec3 direction) {
  const Hit hit = world.Feel(from, direction);
  return hit.instance < 0 ? lights.Beyond(from, direction) : SentBack(world, radiosity, from, direction, hit);
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

Vec3 GlossOf(const World& world, const Lights& lights, const Radiosity& radiosity, const Seen& seen, Vec2 sample) {
  const Vec3 facet = FacetNormal(seen.normal, seen.roughness, sample);
  const float cosine = -Dot(facet, seen.direction);
  const Vec3 direction = seen.direction + facet * (2 * cosine);
  if (cosine <= 0 || Dot(direction, seen.normal) <= 0) return {};
  // Rough surfaces shadow themselves at grazing angles.
  const float grazing = std::pow(1 - cosine, 5.0F) * (1 - seen.roughness) * (1 - seen.roughness);
  const Vec3 share = seen.specular * (1 - grazing) + Vec3{1, 1, 1} * grazing;
  const Hit hit = world.Feel(seen.position, direction);
  Vec3 arriving;
  if (hit.instance >= 0) {
    arriving = SentBack(world, radiosity, seen.position, direction, hit);
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

Lit LightOf(const World& world, const Lights& lights, const Radiosity& radiosity, const Seen& seen,
            const SampleSeeds& seeds, int column, int row, int round_count) {
  Lit lit;
  if (seen.lit_instance == -1) return lit;
  const PixelSamples random(seeds, column, row, round_count);
  const LightChoice choice(lights, seen.position, seen.normal);
  float sum = 0, sum_of_squares = 0;
  for (int i = 0; i < round_count; ++i) {
    Vec3 light =
        Arriving(world, lights, radiosity, seen.position, CosineDirection(seen.normal, random.At(i, Purpose::kBounce)));
    light = light + DirectLight(world, choice, seen.position, random, i);
    lit.irradiance = lit.irradiance + light;
    const float luminance = Luminance(light);
    sum += luminance;
    sum_of_squares += luminance * luminance;
  }
  const float count = static_cast<float>(round_count), mean = sum / count;
  lit.irradiance = lit.irradiance * (1 / count);
  // One sample says nothing of its spread: as if it were as large as the value.
  const float spread =
      round_count > 1 ? std::max(0.0F, sum_of_squares / count - mean * mean) * count / (count - 1) : mean * mean;
  lit.variance = spread / count;
  const float metal = std::max({seen.specular.x, seen.specular.y, seen.specular.z});
  if (seen.lit_instance < 0 || (seen.roughness > 0.65F && metal < 0.1F)) return lit;
  const int gloss_count = (round_count + 3) / 4;
  for (int i = 0; i < gloss_count; ++i) {
    lit.gloss = lit.gloss + GlossOf(world, lights, radiosity, seen, random.At(i, Purpose::kGloss));
  }
  lit.gloss = lit.gloss * (1 / static_cast<float>(gloss_count));
  return lit;
}

}  // namespace flair::renderer
