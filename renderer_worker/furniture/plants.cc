// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "renderer_worker/furniture/families.h"

// What grows.
namespace flair::renderer {
namespace {

// Long blades that bend outwards from one root.
void Fronds(Piece& p, Vec3 root, float reach_x, float reach_y, float rise, int count, float width,
            const Material& material) {
  for (int i = 0; i < count; ++i) {
    const float turn = 2.39996F * static_cast<float>(i) + 0.5F * p.Chance(i), out = 0.55F + 0.45F * p.Chance(50 + i);
    const float high = rise * (0.7F + 0.3F * p.Chance(90 + i)) * (1.15F - 0.4F * out);
    const float c = std::cos(turn), s = std::sin(turn);
    p.make.Sheet(
        i % 3 == 0 ? stuff::Leaf(1) : material, 2, 6,
        [&](float u, float v) {
          const float across = (2 * u - 1) * width * std::sin(kPiFloat * std::min(0.98F, 0.14F + 0.86F * v));
          const float along = out * v * (0.35F + 0.65F * v), up = high * (1.7F * v - 0.75F * v * v);
          return root + Vec3{c * along * reach_x - s * across, s * along * reach_y + c * across,
                             up + 0.25F * std::abs(across)};
        },
        0.003F * std::min(1.0F, p.smaller() / 0.3F));
  }
}

}  // namespace

void MakePlant(Piece& p) {
  const bool hanging = p.Says("hanging") || p.Says("ceiling");
  const float r = 0.5F * p.smaller(), pot = std::min(0.34F * p.h, 1.5F * r), rim = std::min(0.62F * r, 0.55F * pot);
  const Material& clay = p.Says("woven") || p.Says("basket") ? BaseMaterialOf("rattan").look : p.is.hard;
  const Material& leaf = stuff::Leaf(0);
  if (hanging) {
    const float base = 0.3F * p.h;
    p.Pot({0, 0, base}, 0.8F * rim + 0.1F * r, 0.8F * pot, clay);
    for (int i = 0; i < 3; ++i) {
      const float turn = 2 * kPiFloat / 3 * static_cast<float>(i);
      p.make.Bar(p.is.soft, {rim * std::cos(turn), rim * std::sin(turn), base + 0.7F * pot}, {0, 0, p.h}, 0.004F, 5);
    }
    p.Foliage({0, 0, base + 0.8F * pot}, {r, r, 0.2F * p.h}, 30, 0.5F * r, leaf);
    for (int i = 0; i < 9; ++i) {  // trailing shoots
      const float turn = 2.39996F * static_cast<float>(i), c = std::cos(turn) * r * 0.9F, s = std::sin(turn) * r * 0.9F,
                  low = base * p.Chance(i);
      p.make.Tube(
          leaf, std::array<Vec3, 3>{{{0.5F * c, 0.5F * s, base + 0.8F * pot}, {c, s, base + 0.5F * pot}, {c, s, low}}},
          std::array{0.004F}, 4);
      for (int k = 0; k < 4; ++k)
        p.make.Ellipsoid(
            stuff::Leaf(k),
            {c * (1 + 0.06F * p.Chance(k + 9 * i)), s, low + 0.24F * static_cast<float>(k) * (base + 0.4F * pot - low)},
            {0.1F * r, 0.1F * r, 0.06F * r}, 6, 4);
    }
    return;
  }
  p.Pot({}, rim, pot, clay);
  const float top = 0.85F * pot, rise = p.h - top;
  if (p.Says("cactus")) {
    for (const Vec3 c : {Vec3{0, 0, 0.5F}, Vec3{-0.5F, 0, 0.55F}, Vec3{0.5F, 0, 0.45F}}) {
      const float wide = c.x == 0 ? 0.34F * r : 0.17F * r;
      p.make.Ellipsoid(stuff::Leaf(2), {c.x * r, 0, top + c.z * rise}, {wide, wide, (c.x == 0 ? 0.5F : 0.28F) * rise},
                       14, 10);
      if (c.x != 0)
        p.make.Bar(stuff::Leaf(2), {0, 0, top + 0.35F * rise}, {c.x * r, 0, top + 0.4F * rise}, 0.8F * wide, 10);
    }
  } else if (p.h > 1.1F * p.smaller() &&
             (p.Says("tree") || p.Says("olive") || p.Says("fig") || p.Says("ficus") || p.h > 1.5F)) {
    const float crown = top + 0.62F * rise;
    p.make.Tube(BaseMaterialOf("bark").look,
                std::array<Vec3, 4>{{{0, 0, top - 0.05F * pot},
                                     {0.05F * r, 0, top + 0.2F * rise},
                                     {-0.04F * r, 0.03F * r, top + 0.4F * rise},
                                     {0, 0, crown}}},
                std::array{0.07F * r, 0.05F * r, 0.045F * r, 0.02F * r}, 8);
    p.Foliage({0, 0, crown}, {r, r, 0.38F * rise}, 90, std::min(0.2F, 0.42F * r), leaf);
    p.Foliage({0.1F * r, -0.1F * r, crown - 0.06F * rise}, {0.6F * r, 0.6F * r, 0.25F * rise}, 40,
              std::min(0.18F, 0.4F * r), stuff::Leaf(2));
  } else if (p.Says("palm") || p.Says("fern") || p.Says("snake") || p.Says("grass") || p.Chance(3) < 0.35F) {
    const bool upright = p.Says("snake") || p.Says("grass");
    Fronds(p, {0, 0, top}, (upright ? 0.85F : 1.0F) * r, (upright ? 0.85F : 1.0F) * r, rise * (upright ? 1.0F : 0.95F),
           upright ? 18 : 30, std::min(0.05F, 0.14F * r), leaf);
  } else {
    p.Foliage({0, 0, top + 0.36F * rise}, {r, r, 0.6F * rise}, 64, std::min(0.26F, 0.62F * r), leaf);
    p.make.Tube(stuff::Leaf(2), std::array<Vec3, 2>{{{0, 0, top - 0.04F * pot}, {0, 0, top + 0.6F * rise}}},
                std::array{0.06F * r}, 6);
  }
}

}  // namespace flair::renderer
