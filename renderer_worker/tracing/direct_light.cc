// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/tracing/direct_light.h"

#include <algorithm>
#include <optional>

namespace flair::renderer {
namespace {

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
