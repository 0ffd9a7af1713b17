// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "renderer_worker/furniture/classes.h"
#include "renderer_worker/furniture/piece.h"

// Bathrooms and pools.
namespace flair::renderer {
namespace {

// A tub as nested outlines: outer wall, rim, inner wall, floor.
struct Tub {
  float rim, deep;    // width of the rim, height of the floor inside
  float foot, flare;  // share of the size at the foot, and inside at the floor
  bool oval;
};

std::vector<Vec2> TubOutline(const Piece& p, bool oval, float share, float inset) {
  const float x = p.w / 2 * share - inset, y = p.d / 2 * share - inset;
  return oval ? EllipseOutline({}, x, y, 40) : RoundedOutline({-x, -y}, {x, y}, 0.35F * std::min(x, y), 5);
}

// The skin between two outlines of the same number of points at two heights; outside when `outward`.
void Skin(Piece& p, const Material& material, const std::vector<Vec2>& low, float z_low, const std::vector<Vec2>& high,
          float z_high, bool outward) {
  const auto count = static_cast<int>(low.size());
  p.make.Sheet(
      material, count, 2,
      [&](float u, float v) {
        const int i = static_cast<int>(std::lround(u * static_cast<float>(count))) % count;
        const auto k = static_cast<size_t>(outward ? i : (count - i) % count);
        const float s = v * v * (3 - 2 * v);
        return Vec3{low[k].x + (high[k].x - low[k].x) * s, low[k].y + (high[k].y - low[k].y) * s,
                    z_low + (z_high - z_low) * v};
      },
      0.004F * std::min(1.0F, p.smaller()));
}

void MakeTub(Piece& p, const Tub& t, float top, const Material& material) {
  const std::vector<Vec2> foot = TubOutline(p, t.oval, t.foot, 0), outer = TubOutline(p, t.oval, 0.985F, 0),
                          inner = TubOutline(p, t.oval, 1, t.rim), floor = TubOutline(p, t.oval, t.flare, t.rim);
  p.make.Slab(material, foot, 0, 0.04F * top, 0.004F);
  Skin(p, material, foot, 0.01F * top, outer, 0.97F * top, true);
  Skin(p, material, floor, t.deep, inner, 0.985F * top, false);
  p.make.Slab(material, floor, t.deep - 0.02F * top, t.deep, 0);
  // The rim: a flat ring with a rounded edge.
  const auto count = static_cast<int>(outer.size());
  const std::vector<Vec2> edge = TubOutline(p, t.oval, 1, 0);
  p.make.Sheet(
      material, count, 2,
      [&](float u, float v) {
        const auto k = static_cast<size_t>(static_cast<int>(std::lround(u * static_cast<float>(count))) % count);
        return Vec3{edge[k].x + (inner[k].x - edge[k].x) * v, edge[k].y + (inner[k].y - edge[k].y) * v, 0.975F * top};
      },
      0.05F * top);
}

void Mixer(Piece& p, Vec3 at, float size, Vec3 towards) {
  const float r = 0.09F * size;
  p.make.Cylinder(stuff::Steel(), at, 1.6F * r, 0.2F * size, 0.002F, 12);
  p.make.Tube(
      stuff::Steel(),
      std::array<Vec3, 4>{{at, at + Vec3{0, 0, 0.7F * size}, at + towards * (0.4F * size) + Vec3{0, 0, 0.95F * size},
                           at + towards * size + Vec3{0, 0, 0.75F * size}}},
      std::array{r}, 8);
  p.make.Bar(stuff::Steel(), at + Vec3{0, 0, 0.65F * size}, at + towards * (-0.3F * size) + Vec3{0, 0, 1.05F * size},
             0.6F * r, 8);
}

void MakeBath(Piece& p) {
  const float tap = std::min(0.12F, 0.2F * p.h), top = p.h - tap;
  const bool oval = p.Says("freestanding") || p.Says("oval") || p.Says("clawfoot") || p.Says("round");
  const float rim = std::min(0.055F, 0.09F * p.smaller());
  MakeTub(p, {rim, 0.24F * top, oval ? 0.8F : 0.97F, 0.78F, oval}, top, p.is.hard);
  const bool along_x = p.w >= p.d;
  const float x = along_x ? p.w / 2 - 2.2F * rim : 0, y = along_x ? 0 : -p.d / 2 + 2.2F * rim;
  p.make.Slab(stuff::Water(), TubOutline(p, oval, 0.93F, rim), 0.5F * top, 0.56F * top, 0);
  Mixer(p, {along_x ? p.w / 2 - 0.6F * rim : 0, along_x ? 0 : -p.d / 2 + 0.6F * rim, top - 0.03F * top}, tap,
        along_x ? Vec3{-1, 0, 0} : Vec3{0, 1, 0});
  p.make.Cylinder(stuff::Steel(), {x * 0.8F, y * 0.8F, 0.235F * top}, 0.03F * std::min(1.0F, p.smaller()), 0.01F,
                  0.002F, 14);
}

void MakePool(Piece& p) {
  const float rim = std::min(0.25F, 0.1F * p.smaller());
  const bool oval = p.Says("round") || p.Says("hot tub") || p.Says("oval");
  const std::vector<Vec2> outer = TubOutline(p, oval, 1, 0), inner = TubOutline(p, oval, 1, rim);
  MakeTub(p, {rim, 0.3F * p.h, 0.99F, 0.97F, oval}, p.h, p.is.hard);
  if (p.Says("sandpit") || p.Says("palaestra")) {
    static const Material kSand = PlainMaterial("sand", 0xD9C49A, 1);
    p.make.Slab(kSand, TubOutline(p, oval, 0.985F, rim), 0.6F * p.h, 0.72F * p.h, 0);
  } else {
    p.make.Slab(stuff::Water(), TubOutline(p, oval, 0.985F, rim), 0.72F * p.h, 0.8F * p.h, 0);
  }
}

void MakeShower(Piece& p) {
  const float tray = std::min(0.06F, 0.05F * p.h), glass = std::min(0.008F, 0.02F * p.smaller()),
              post = std::min(0.014F, 0.03F * p.smaller());
  p.make.Slab(stuff::White(), RoundedOutline({-p.w / 2, -p.d / 2}, {p.w / 2, p.d / 2}, 0.03F), 0, tray, 0.008F);
  p.make.Cylinder(stuff::Steel(), {0, 0, tray - 0.002F}, 0.06F * p.smaller(), 0.006F, 0.002F, 16);
  const float x = p.w / 2 - post, y = p.d / 2 - post;
  for (const Vec2 at : {Vec2{-x, y}, Vec2{x, y}, Vec2{x, -y}, Vec2{-x, -y}})
    p.make.Box(p.is.metal, {at.x - post, at.y - post, tray}, {at.x + post, at.y + post, p.h}, 0.002F);
  p.make.Box(stuff::Glass(), {-x, y - glass / 2, tray}, {x, y + glass / 2, p.h - post}, 0);
  p.make.Box(stuff::Glass(), {x - glass / 2, -y, tray}, {x + glass / 2, y, p.h - post}, 0);
  for (const float side : {-1.0F, 1.0F})
    p.make.Box(p.is.metal, {side * x - post, -y, p.h - 2 * post}, {side * x + post, y, p.h}, 0.002F);
  p.make.Box(p.is.metal, {-x, y - post, p.h - 2 * post}, {x, y + post, p.h}, 0.002F);
  p.make.Bar(p.is.metal, {0.02F * p.w, y + 1.4F * post, 0.45F * p.h}, {0.02F * p.w, y + 1.4F * post, 0.55F * p.h},
             0.7F * post, 8);
  const Vec3 pipe{0, -p.d / 2 + 2 * post, 0};
  p.make.Tube(stuff::Steel(),
              std::array<Vec3, 4>{{pipe + Vec3{0, 0, 0.45F * p.h}, pipe + Vec3{0, 0, 0.92F * p.h},
                                   pipe + Vec3{0, 0.1F * p.d, 0.96F * p.h}, pipe + Vec3{0, 0.3F * p.d, 0.95F * p.h}}},
              std::array{0.8F * post}, 8);
  p.make.Cylinder(stuff::Steel(), pipe + Vec3{0, 0.3F * p.d, 0.925F * p.h}, 0.12F * p.smaller(), 0.012F, 0.003F, 24);
  p.make.Box(stuff::Steel(), pipe + Vec3{-0.1F * p.w, -post, 0.48F * p.h}, pipe + Vec3{0.1F * p.w, post, 0.51F * p.h},
             0.006F);
}

void MakeToilet(Piece& p) {
  const float seat = std::min(0.42F, 0.52F * p.h), tank = std::min(0.2F, 0.3F * p.d), middle = 0.12F * p.d;
  const float rx = std::min(0.5F * p.w, 0.2F + 0.15F * p.w), ry = p.d / 2 - middle;
  std::vector<Vec2> bowl{{0.5F, 0},
                         {0.52F, 0.1F * seat},
                         {0.55F, 0.35F * seat},
                         {0.82F, 0.75F * seat},
                         {0.96F, 0.9F * seat},
                         {0.97F, 0.96F * seat}};
  p.make.Lathe(p.is.hard, {0, middle, 0}, bowl, 28, {rx, ry});
  p.make.Box(p.is.hard, {-0.5F * rx, -p.d / 2 + 0.3F * tank, 0}, {0.5F * rx, middle, 0.9F * seat}, 0.03F);
  p.make.Box(p.is.hard, {-0.85F * rx, -p.d / 2 + 0.6F * tank, 0.8F * seat}, {0.85F * rx, middle, 0.95F * seat}, 0.02F);
  const std::vector<Vec2> lid = EllipseOutline({0, middle}, rx, ry, 32);
  p.make.Slab(stuff::White(), lid, 0.955F * seat, seat, 0.006F);
  std::vector<Vec2> cover = EllipseOutline({0, middle}, 0.96F * rx, 0.97F * ry, 32);
  p.make.Slab(stuff::White(), cover, seat + 0.002F, 1.05F * seat, 0.01F);
  p.make.Cushion(p.is.hard, {-p.w / 2, -p.d / 2, 0.95F * seat}, {p.w / 2, -p.d / 2 + tank, p.h - 0.03F * p.h}, 0.03F);
  p.make.Box(p.is.hard, {-p.w / 2, -p.d / 2, p.h - 0.06F * p.h}, {p.w / 2, -p.d / 2 + 1.06F * tank, p.h - 0.012F * p.h},
             0.008F);
  p.make.Cylinder(stuff::Steel(), {0, -p.d / 2 + tank / 2, p.h - 0.014F * p.h}, 0.06F * p.w, 0.014F * p.h, 0.002F, 16);
}

void MakeBasin(Piece& p) {
  const bool cabinet = p.Says("vanity") || p.Says("cabinet") || p.Says("unit") || p.w > 0.75F;
  const float top = RestHeightOf("basin", p.h), tap = p.h - top, thick = std::min(0.14F, 0.2F * top);
  if (cabinet) {
    p.make.Box(p.is.hard, {-0.49F * p.w, -p.d / 2, 0.12F * top}, {0.49F * p.w, 0.42F * p.d, top - 0.6F * thick},
               0.004F);
    for (const float side : {-1.0F, 1.0F}) {
      p.Panel(p.is.hard, {side < 0 ? -0.48F * p.w : 0.004F, 0.14F * top},
              {side < 0 ? -0.004F : 0.48F * p.w, top - 0.66F * thick}, 0.42F * p.d, 0.018F, true);
      p.Handle({side * 0.05F * p.w, 0.42F * p.d + 0.018F, 0.6F * top}, std::min(0.14F, 0.2F * top), true);
    }
  } else {
    p.make.Lathe(
        stuff::White(), {0, -0.1F * p.d, 0},
        std::array<Vec2, 5>{
            {{0.3F, 0}, {0.26F, 0.05F * top}, {0.18F, 0.3F * top}, {0.2F, 0.7F * top}, {0.34F, top - 0.9F * thick}}},
        20, {p.smaller(), p.smaller()});
  }
  // The slab around a bowl: four sides, then the hollow as a lathe turned inside.
  const float x = 0.36F * p.w > 0.3F ? 0.3F : 0.36F * p.w, low = -0.22F * p.d, high = 0.4F * p.d,
              slab = top - 0.45F * thick;
  const Material& white = stuff::White();
  p.make.Box(white, {-p.w / 2, -p.d / 2, slab}, {-x, p.d / 2, top}, 0.008F);
  p.make.Box(white, {x, -p.d / 2, slab}, {p.w / 2, p.d / 2, top}, 0.008F);
  p.make.Box(white, {-x, -p.d / 2, slab}, {x, low, top}, 0.008F);
  p.make.Box(white, {-x, high, slab}, {x, p.d / 2, top}, 0.008F);
  const float cy = (low + high) / 2, ry = (high - low) / 2;
  p.make.Sheet(
      white, 28, 6,
      [&](float u, float v) {  // seen from above: the inside of the bowl, square at the rim and round below
        const float turn = 2 * kPiFloat * u, c = std::cos(turn), s = std::sin(turn);
        const float square = std::max(std::abs(c), std::abs(s)), r = v < 0.99F ? v : 1.0F / (0.55F + 0.45F * square);
        const float sx = std::clamp(r * c * 1.02F, -1.0F, 1.0F), sy = std::clamp(r * s * 1.02F, -1.0F, 1.0F);
        return Vec3{-x * sx, cy + ry * sy, top - 0.004F - 0.85F * thick * (1 - v * v * v)};
      },
      0.004F);
  Mixer(p, {0, -0.36F * p.d, top - 0.002F}, tap, {0, 1, 0});
}

}  // namespace

std::span<const PieceMaker> BathroomMakers() {
  static constexpr PieceMaker kMakers[] = {
      {"bath", MakeBath}, {"pool", MakePool}, {"shower", MakeShower}, {"toilet", MakeToilet}, {"basin", MakeBasin}};
  return kMakers;
}

}  // namespace flair::renderer
