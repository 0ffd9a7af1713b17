// SPDX-License-Identifier: GPL-3.0-or-later
// Tiles of two blocks side by side: what is known of their pixels stays in the nearest cache until light has been
// gathered.
#include "renderer_worker/tracing/tile.h"

#include <algorithm>
#include <array>

#include "renderer_worker/tracing/direct_light.h"

namespace flair::renderer {
namespace {

constexpr int kTileWidth = kMostRaysTogether;
static_assert(kTileHeight == kBlockSide && kTileWidth % kBlockSide == 0);

class Tile {
 public:
  Tile(const Setting& setting, int column, int row)
      : setting_(setting),
        column_(column),
        row_(row),
        width_(std::min(kTileWidth, setting.camera.width_px - column)),
        height_(std::min(kTileHeight, setting.camera.height_px - row)) {}

  void Look();
  void FillView(TracedView& view) const;
  void FillFrame(Frame& frame) const;
  void GatherDirect(const SampleSeeds& seeds, int round_count, LightGrid& grid) const;
  void GatherIndirect(const SampleSeeds& seeds, int round_count, Frame& frame) const;

 private:
  const Seen& At(int x, int y) const { return seen_[y * kTileWidth + x]; }
  size_t PixelOf(int x, int y) const {
    return static_cast<size_t>(row_ + y) * setting_.camera.width_px + static_cast<size_t>(column_ + x);
  }

  const Setting& setting_;
  int column_, row_, width_, height_;
  std::array<Seen, kTileWidth * kTileHeight> seen_;
};

void Tile::Look() {
  for (int y = 0; y < height_; ++y) {
    std::array<Vec3, kTileWidth> ways;
    for (int x = 0; x < width_; ++x) {
      ways[x] = setting_.camera.Through(static_cast<float>(column_ + x) + 0.5F, static_cast<float>(row_ + y) + 0.5F);
    }
    LookFrom(setting_.world, setting_.lights, setting_.surroundings, setting_.camera.eye, std::span(ways).first(width_),
             setting_.pixel_rad(), std::span(seen_).subspan(y * kTileWidth, width_));
  }
}

// The planes that say what is seen.
void Tile::FillView(TracedView& view) const {
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const size_t at = PixelOf(x, y);
      const Seen& s = At(x, y);
      const bool any = s.instance >= 0;
      const Vec3 way =
          setting_.camera.Through(static_cast<float>(column_ + x) + 0.5F, static_cast<float>(row_ + y) + 0.5F);
      view.depth_m[at] = any ? s.distance * Dot(way, setting_.camera.forward) : 0;
      view.instance[at] = any ? setting_.world.instances()[s.instance].instance_id : 0;
      if (view.normal.empty()) continue;
      view.normal[at] = s.first_normal;
      view.albedo[at] = s.first_albedo;
      view.object_class[at] = any ? setting_.world.instances()[s.instance].class_id : 0;
    }
  }
}

// `pixels`: the distance of the grid's points, in pixels.
void FillGuides(const Seen& s, float pixel_rad, float pixels, size_t at, Planes& guides) {
  const bool lit = s.lit_instance != -1;
  const Vec3 position = lit ? s.position : Vec3{}, normal = lit ? s.normal : Vec3{};
  guides[kX][at] = position.x, guides[kY][at] = position.y, guides[kZ][at] = position.z;
  guides[kNormalX][at] = normal.x, guides[kNormalY][at] = normal.y, guides[kNormalZ][at] = normal.z;
  guides[kReach][at] = lit ? 1 / std::max(1e-4F, s.distance * pixel_rad * 1.5F * pixels) : 0;
  guides[kInstance][at] = static_cast<float>(s.lit_instance);
}

void FillLight(const LightMean& light, size_t at, Planes& planes) {
  planes[kRed][at] = light.light.x, planes[kGreen][at] = light.light.y, planes[kBlue][at] = light.light.z;
  planes[kVariance][at] = light.variance;
  planes[kLuminance][at] = Luminance(light.light);
}

void Tile::FillFrame(Frame& frame) const {
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const size_t at = PixelOf(x, y);
      const Seen& s = At(x, y);
      FillGuides(s, setting_.pixel_rad(), 1, at, frame.direct.guides);
      frame.paint[at] = s.filter * s.albedo;
      frame.added[at] = s.added;
    }
  }
}

void Tile::GatherDirect(const SampleSeeds& seeds, int round_count, LightGrid& grid) const {
  for (int left = 0; left < width_; left += kBlockSide) {
    PixelBlock block{};
    for (int y = 0; y < height_; ++y) {
      for (int x = left; x < std::min(width_, left + kBlockSide); ++x) block[y * kBlockSide + x - left] = &At(x, y);
    }
    const BlockLight light = DirectLightOn(setting_, seeds, block, column_ + left, row_, round_count);
    for (int y = 0; y < height_; ++y) {
      for (int x = left; x < std::min(width_, left + kBlockSide); ++x) {
        FillLight(light[y * kBlockSide + x - left], PixelOf(x, y), grid.light);
      }
    }
  }
}

void Tile::GatherIndirect(const SampleSeeds& seeds, int round_count, Frame& frame) const {
  // Where the sky is open, these rays bring its light; within a room only that of other surfaces, which varies less.
  const int ray_count = setting_.lights.open_sky ? 2 * round_count : round_count;
  const int gloss_count = (round_count + 1) / 2;
  for (int y = 0; y < height_; y += 2) {
    for (int x = 0; x < width_; x += 2) {
      const Seen& s = At(x, y);
      const int column = (column_ + x) / 2, row = (row_ + y) / 2;
      const size_t at = static_cast<size_t>(row) * frame.indirect.width + column;
      FillGuides(s, setting_.pixel_rad(), 2, at, frame.indirect.guides);
      FillLight(IndirectLight(setting_, s, PixelSamples(seeds, column, row, ray_count), 0, ray_count), at,
                frame.indirect.light);
      const Vec3 gloss = s.filter * Gloss(setting_, s, PixelSamples(seeds, column, row, gloss_count), 0, gloss_count);
      frame.gloss[0][at] = gloss.x, frame.gloss[1][at] = gloss.y, frame.gloss[2][at] = gloss.z;
      frame.reflectance[at] = Luminance(s.albedo + s.specular);
    }
  }
}

}  // namespace

void TraceRows(const Setting& setting, const SampleSeeds& seeds, int round_count, int row, Frame& frame,
               TracedView& view) {
  for (int column = 0; column < setting.camera.width_px; column += kTileWidth) {
    Tile tile(setting, column, row);
    tile.Look();
    tile.FillView(view);
    tile.FillFrame(frame);
    tile.GatherDirect(seeds, round_count, frame.direct);
    tile.GatherIndirect(seeds, round_count, frame);
  }
}

}  // namespace flair::renderer
