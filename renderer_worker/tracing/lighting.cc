// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/tracing/lighting.h"

#include <cmath>
#include <numbers>
#include <optional>

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

constexpr size_t kPixels = kBlockSide * kBlockSide;
constexpr int kFewPixels = 5;  // of a surface: they prove nothing

enum class Source { kLampsAndWindows, kSun };

// Samples of one source at one pixel, or at all of a surface.
struct Tally {
  LightSum light;
  int reaching = 0, shaded = 0;

  void Add(const World& world, Vec3 position, const LightSample& from) {
    const bool any = Luminance(from.irradiance) > 0, kept = any && IsShaded(world, position, from);
    light.Add(any && !kept ? from.irradiance : Vec3{});
    reaching += any && !kept;
    shaded += kept;
  }
  void Add(const Tally& other) {
    light.Add(other.light);
    reaching += other.reaching;
    shaded += other.shaded;
  }
};

class Block {
 public:
  Block(const Setting& setting, const SampleSeeds& seeds, const PixelBlock& pixels, int column, int row)
      : setting_(setting), seeds_(seeds), pixels_(pixels), column_(column), row_(row) {
    for (size_t i = 0; i < kPixels; ++i) {
      if (pixels[i] == nullptr || pixels[i]->lit_instance == -1) continue;
      choices_[i].emplace(setting.lights, pixels[i]->position, pixels[i]->normal);
      if (first_ == kPixels) first_ = i;
      even_ = even_ && pixels[i]->lit_instance == pixels[first_]->lit_instance;
    }
  }

  // `at_first` samples of each pixel, and up to `at_most` where those of a surface disagree.
  void Gather(Source source, int at_first, int at_most, BlockLight& light) {
    std::array<Tally, kPixels> tallies;
    for (size_t i = 0; i < kPixels; ++i) Sample(source, i, 0, at_first, tallies[i]);
    Tally surface = even_ ? OfSurface(tallies, first_) : Tally();
    for (size_t i = 0; i < kPixels; ++i) {
      if (!choices_[i]) continue;
      if (!even_) surface = OfSurface(tallies, i);
      if (surface.reaching == 0 && surface.shaded == 0) continue;
      const bool doubtful =
          (surface.reaching > 0 && surface.shaded > 0) || surface.light.count() <= kFewPixels * at_first;
      Tally tally = tallies[i];
      if (doubtful) Sample(source, i, at_first, at_most, tally);
      if (tally.light.count() == 0) continue;
      const LightMean mean = tally.light.Mean();
      light[i].light = light[i].light + mean.light;
      light[i].variance +=
          doubtful ? mean.variance : surface.light.Variance() / static_cast<float>(tally.light.count());
    }
  }

 private:
  // All samples at pixels that show what pixel `i` does.
  Tally OfSurface(const std::array<Tally, kPixels>& tallies, size_t i) const {
    Tally all;
    for (size_t k = 0; k < kPixels && i < kPixels; ++k) {
      if (choices_[k] && pixels_[k]->lit_instance == pixels_[i]->lit_instance) all.Add(tallies[k]);
    }
    return all;
  }

  // The samples [begin, end) of a pixel; the first ones and the others each fill the block evenly.
  void Sample(Source source, size_t i, int begin, int end, Tally& tally) const {
    if (!choices_[i] || begin >= end) return;
    const LightChoice& choice = *choices_[i];
    if (source == Source::kSun ? !choice.sun() : !choice.any()) return;
    const int x = column_ + static_cast<int>(i % kBlockSide), y = row_ + static_cast<int>(i / kBlockSide);
    const PixelSamples random(seeds_, x, y, end - begin);
    const bool more = begin > 0;
    for (int k = 0; k < end - begin; ++k) {
      if (source == Source::kSun) {
        const Vec2 place = random.At(k, more ? Purpose::kMoreSun : Purpose::kSun);
        tally.Add(setting_.world, pixels_[i]->position, choice.SampleSun(place));
      } else {
        const Vec2 which = random.At(k, more ? Purpose::kMoreLight : Purpose::kLight);
        const Vec2 place = random.At(k, more ? Purpose::kMorePlaces : Purpose::kPlaceOnLight);
        tally.Add(setting_.world, pixels_[i]->position, choice.Sample(which.x, place));
      }
    }
  }

  const Setting& setting_;
  const SampleSeeds& seeds_;
  const PixelBlock& pixels_;
  int column_, row_;
  std::array<std::optional<LightChoice>, kPixels> choices_;
  size_t first_ = kPixels;
  bool even_ = true;  // all of one surface
};

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

BlockLight DirectLightOn(const Setting& setting, const SampleSeeds& seeds, const PixelBlock& pixels, int column,
                         int row, int round_count) {
  BlockLight light;
  Block block(setting, seeds, pixels, column, row);
  const int at_first = (round_count + 3) / 4;
  block.Gather(Source::kLampsAndWindows, at_first, (round_count + 1) / 2, light);
  block.Gather(Source::kSun, at_first, round_count, light);
  return light;
}

}  // namespace flair::renderer
