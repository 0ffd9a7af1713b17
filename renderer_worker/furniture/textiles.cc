// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "renderer_worker/furniture/piece.h"

// Rugs, mats, cushions.
namespace flair::renderer {
namespace {

// A frame of cloth between two rectangles, `wide` broad and flush with its ground.
void Border(Piece& p, const Material& material, float inset, float wide, float bottom, float top) {
  const float x = p.w / 2 - inset, y = p.d / 2 - inset;
  for (const float side : {-1.0F, 1.0F}) {
    p.make.Box(material, {-x, side * y, bottom}, {x, side * (y - wide), top}, 0);
    p.make.Box(material, {side * x, -y + wide, bottom}, {side * (x - wide), y - wide, top}, 0);
  }
}

void MakeRug(Piece& p) {
  const float fringe = std::min(0.05F, 0.04F * std::max(p.w, p.d)), thick = p.h;
  const bool along_x = p.w >= p.d, plain = p.Says("plain") || p.Says("fur") || p.Says("sheepskin");
  const float x = p.w / 2 - (along_x ? fringe : 0), y = p.d / 2 - (along_x ? 0 : fringe);
  p.make.Slab(p.is.soft, RoundedOutline({-x, -y}, {x, y}, 0.01F), 0, 0.86F * thick, std::min(0.004F, 0.3F * thick));
  const int threads = std::clamp(static_cast<int>((along_x ? p.d : p.w) / 0.03F), 6, 60);
  for (int i = 0; i < threads; ++i) {
    const float t = (static_cast<float>(i) + 0.5F) / static_cast<float>(threads) - 0.5F,
                half = 0.3F * (along_x ? p.d : p.w) / static_cast<float>(threads);
    for (const float side : {-1.0F, 1.0F}) {
      if (along_x)
        p.make.Box(p.is.pale, {side * x, t * p.d - half, 0}, {side * p.w / 2, t * p.d + half, 0.4F * thick}, 0);
      if (!along_x)
        p.make.Box(p.is.pale, {t * p.w - half, side * y, 0}, {t * p.w + half, side * p.d / 2, 0.4F * thick}, 0);
    }
  }
  const float step = 0.045F * std::min(x, y) * 2;
  if (plain) {
    p.make.Slab(p.is.soft, RoundedOutline({-0.97F * x, -0.97F * y}, {0.97F * x, 0.97F * y}, 0.03F), 0.5F * thick, thick,
                std::min(0.01F, 0.3F * thick));
    return;
  }
  Border(p, p.is.accent, fringe + step, 1.3F * step, 0.5F * thick, 0.93F * thick);
  Border(p, p.is.pale, fringe + 2.9F * step, 0.4F * step, 0.5F * thick, 0.94F * thick);
  // Lozenges in the field.
  const float field_x = x - 4.4F * step, field_y = y - 4.4F * step, r = 0.8F * std::min(field_x, field_y);
  if (r < 0.02F) {
    p.make.Box(p.is.accent, {-0.4F * x, -0.4F * y, 0.5F * thick}, {0.4F * x, 0.4F * y, thick}, 0);
    return;
  }
  const int count = std::clamp(static_cast<int>(std::max(field_x, field_y) / r), 1, 5);
  for (int i = 0; i < count; ++i) {
    const float along = (static_cast<float>(i) - 0.5F * static_cast<float>(count - 1)) * 2 *
                        std::max(field_x, field_y) / static_cast<float>(count);
    const Vec2 c = field_x >= field_y ? Vec2{along, 0} : Vec2{0, along};
    const auto lozenge = [&](float size) {
      return std::array<Vec2, 4>{{{c.x + size, c.y}, {c.x, c.y + size}, {c.x - size, c.y}, {c.x, c.y - size}}};
    };
    p.make.Slab(p.is.accent, lozenge(r), 0.5F * thick, 0.95F * thick, 0);
    p.make.Slab(p.is.pale, lozenge(0.62F * r), 0.5F * thick, 0.97F * thick, 0);
    p.make.Slab(p.is.soft, lozenge(0.36F * r), 0.5F * thick, thick, 0);
  }
}

void MakeRoundRug(Piece& p) {
  const std::array<float, 6> rings{1, 0.9F, 0.82F, 0.56F, 0.5F, 0.16F};
  for (size_t i = 0; i < rings.size(); ++i) {
    const Material& cloth = i % 3 == 0 ? p.is.soft : i % 3 == 1 ? p.is.accent : p.is.pale;
    const float top = p.h * (0.84F + 0.032F * static_cast<float>(i));
    p.make.Slab(cloth, EllipseOutline({}, rings[i] * p.w / 2, rings[i] * p.d / 2, i == 0 ? 48 : 40),
                i == 0 ? 0 : 0.4F * p.h, top, i == 0 ? std::min(0.004F, 0.3F * p.h) : 0);
  }
}

void MakeMat(Piece& p) {
  const Material& cloth = p.is.soft;
  p.make.Slab(cloth, RoundedOutline({-p.w / 2, -p.d / 2}, {p.w / 2, p.d / 2}, 0.04F), 0, 0.9F * p.h,
              std::min(0.01F, 0.3F * p.h));
  const float x = 0.44F * p.w, y = 0.44F * p.d;
  p.make.Slab(p.is.accent, RoundedOutline({-x, -y}, {x, y}, 0.03F), 0.4F * p.h, 0.95F * p.h, 0);
  const float in = 0.05F * p.smaller();
  p.make.Slab(cloth, RoundedOutline({-x + in, -y + in}, {x - in, y - in}, 0.03F), 0.4F * p.h, p.h, 0);
}

void MakeCushion(Piece& p) {
  p.make.Pillow(p.is.soft, {-p.w / 2, -p.d / 2, 0}, {p.w / 2, p.d / 2, p.h});
  if (p.h > 1.4F * p.d) return;
  p.make.Ellipsoid(p.is.accent, {0, 0, 0.985F * p.h}, {0.035F * p.w, 0.035F * p.d, 0.02F * p.h}, 12, 6);
}

void MakeBlanket(Piece& p) {  // folded cloth: blankets and towels
  const int layers = std::clamp(static_cast<int>(p.h / 0.03F), 2, 5);
  const float thick = p.h / static_cast<float>(layers);
  for (int i = 0; i < layers; ++i) {
    const float z = thick * static_cast<float>(i), in = 0.02F * p.smaller() * p.Chance(i);
    p.make.Cushion(i % 2 == 0 ? p.is.soft : p.is.accent, {-p.w / 2 + (i > 0 ? in : 0), -p.d / 2, z},
                   {p.w / 2 - (i > 0 ? in : 0), p.d / 2 - (i > 0 ? in : 0), z + thick}, 0.48F * thick);
  }
}

void MakeCurtain(Piece& p) {
  const float rod = std::min({0.014F, 0.2F * p.d, 0.02F * p.h}), top = p.h - 2.4F * rod, deep = 0.42F * p.d;
  p.make.Bar(p.is.metal, {-p.w / 2 + 2 * rod, 0, p.h - rod}, {p.w / 2 - 2 * rod, 0, p.h - rod}, rod, 10);
  for (const float side : {-1.0F, 1.0F})
    p.make.Ellipsoid(p.is.metal, {side * (p.w / 2 - 2 * rod), 0, p.h - rod},
                     {2 * rod, std::min(2 * rod, 0.5F * p.d), rod}, 10, 6);
  const float wide = p.w > 0.9F ? 0.3F * p.w : 0.47F * p.w;  // drawn aside, the window between
  const int folds = std::clamp(static_cast<int>(wide / 0.09F), 2, 9);
  for (const float side : {-1.0F, 1.0F}) {
    p.make.Sheet(
        p.is.soft, 8 * folds, 5,
        [&](float u, float v) {
          const float gather = 1 - 0.22F * std::sin(kPiFloat * v) * (p.h > 1.2F ? 1.0F : 0.3F);
          const float x =
              side > 0 ? p.w / 2 - 2 * rod - (1 - u) * wide * gather : -p.w / 2 + 2 * rod + u * wide * gather;
          return Vec3{x, -deep * (0.4F + 0.6F * (1 - v)) * std::cos(2 * kPiFloat * static_cast<float>(folds) * u),
                      top * v};
        },
        0.004F);
    if (p.h > 1.2F) {
      const float x = side * (p.w / 2 - 2 * rod - 0.42F * wide);
      p.make.In({{x, 0, 0.45F * p.h}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, [&] {
        p.make.Ring(p.is.accent, {},
                    std::array<Vec2, 4>{
                        {{0.47F, -0.012F * p.h}, {0.5F, -0.012F * p.h}, {0.5F, 0.012F * p.h}, {0.47F, 0.012F * p.h}}},
                    24, {0.84F * wide, 0.94F * p.d});
      });
    }
  }
}

}  // namespace

std::span<const PieceMaker> TextileMakers() {
  static constexpr PieceMaker kMakers[] = {{"rug", MakeRug},         {"round_rug", MakeRoundRug},
                                           {"mat", MakeMat},         {"cushion", MakeCushion},
                                           {"blanket", MakeBlanket}, {"curtain", MakeCurtain}};
  return kMakers;
}

}  // namespace flair::renderer
