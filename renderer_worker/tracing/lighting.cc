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
  const float grazing = FifthPower(1 - cosine) * (1 - seen.roughness) * (1 - seen.roughness);
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

// A mean of samples and how sure it is.
class Gathered {
 public:
  void Add(Vec3 light) {
    sum_ = sum_ + light;
    const float luminance = Luminance(light);
    luminance_ += luminance;
    squares_ += luminance * luminance;
    count_ += 1;
  }
  Vec3 Mean() const { return sum_ * (1 / count_); }
  // Of the mean's luminance. One sample says nothing of its spread: as if it were as large as the value.
  float Variance() const {
    const float mean = luminance_ / count_;
    const float spread =
        count_ > 1 ? std::max(0.0F, squares_ / count_ - mean * mean) * count_ / (count_ - 1) : mean * mean;
    return spread / count_;
  }

 private:
  Vec3 sum_;
  float luminance_ = 0, squares_ = 0, count_ = 0;
};

}  // namespace

Lit LightOf(const World& world, const Lights& lights, const Radiosity& radiosity, const Seen& seen,
            const SampleSeeds& seeds, int column, int row, int round_count) {
  Lit lit;
  if (seen.lit_instance == -1) return lit;
  const PixelSamples random(seeds, column, row, round_count);
  const LightChoice choice(lights, seen.position, seen.normal);
  Gathered direct, bounced;
  for (int i = 0; i < round_count; ++i) direct.Add(DirectLight(world, choice, seen.position, random, i));
  // Where the sky is open, these rays bring its light; within a room only that of other surfaces, which varies less.
  const int bounce_count = lights.open_sky ? round_count : (round_count + 1) / 2;
  const PixelSamples random_bounces(seeds, column, row, bounce_count);
  for (int i = 0; i < bounce_count; ++i) {
    const Vec3 direction = CosineDirection(seen.normal, random_bounces.At(i, Purpose::kBounce));
    bounced.Add(Arriving(world, lights, radiosity, seen.position, direction));
  }
  lit.irradiance = direct.Mean() + bounced.Mean();
  lit.variance = direct.Variance() + bounced.Variance();
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
