// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "renderer_worker/furniture/classes.h"
#include "renderer_worker/furniture/piece.h"

// What one sleeps in, for a night or for good. Heads are at the back.
namespace flair::renderer {
namespace {

// Mattress, pillows at the back, a blanket turned down; in [left, right] x [back, front] from `bottom` to `top`.
struct Bedding {
  float left, right, back, front, bottom, top;
};

void MakeBedding(Piece& p, const Bedding& b, bool several_pillows) {
  const float width = b.right - b.left, depth = b.front - b.back, thick = b.top - b.bottom;
  const float round = std::min(0.05F, 0.3F * thick);
  p.make.Cushion(p.is.pale, {b.left, b.back, b.bottom}, {b.right, b.front, b.top - 0.12F * thick}, round, 0.006F);
  // The blanket hangs over the sides and the foot.
  const float turned = b.back + std::min(0.62F, 0.34F * depth), over = std::min(0.012F, 0.02F * width);
  p.make.Cushion(p.is.soft, {b.left - over, turned, b.bottom + 0.25F * thick}, {b.right + over, b.front + over, b.top},
                 round, 0.008F);
  p.make.Cushion(p.is.pale, {b.left - over, turned - 0.02F * depth, b.bottom + 0.3F * thick},
                 {b.right + over, turned + std::min(0.22F, 0.12F * depth), b.top + 0.05F * thick}, round, 0.008F);
  if (depth > 1.2F) {  // a throw at the foot
    const float from = b.front - 0.26F * depth;
    p.make.Cushion(p.is.accent, {b.left - 1.4F * over, from, b.bottom + 0.15F * thick},
                   {b.right + 1.4F * over, from + 0.16F * depth, b.top + 0.05F * thick}, round, 0.004F);
  }
  const int count = several_pillows && width > 1.15F ? 2 : 1;
  const float pitch = width / static_cast<float>(count), size = std::min(0.42F, 0.24F * depth),
              wide = std::min(0.72F, 0.88F * pitch);
  for (int i = 0; i < count; ++i) {
    const float x = b.left + pitch * (0.5F + static_cast<float>(i));
    p.make.In(Frame::TurnedX({x, b.back + 0.03F * depth, b.top - 0.1F * thick}, 0.22F), [&] {
      p.make.Pillow(p.is.pale, {-wide / 2, 0, 0}, {wide / 2, size, 0.42F * size});
    });
  }
}

void Posts(Piece& p, float half, float top, bool knobs) {
  for (const float sx : {-1.0F, 1.0F}) {
    for (const float sy : {-1.0F, 1.0F}) {
      const float x = sx * (p.w / 2 - half), y = sy * (p.d / 2 - half);
      p.make.Box(p.is.hard, {x - half, y - half, 0}, {x + half, y + half, top}, 0.005F);
      if (knobs) p.make.Ellipsoid(p.is.hard, {x, y, top + 0.8F * half}, {half, half, 1.2F * half}, 12, 6);
    }
  }
}

// Four posts that carry a frame with a curtain gathered at each corner.
void Canopy(Piece& p, float post) {
  Posts(p, post, p.h, false);
  const float x = p.w / 2 - post, y = p.d / 2 - post, rail = 0.7F * post;
  for (const float side : {-1.0F, 1.0F}) {
    p.make.Box(p.is.hard, {-x, side * y - rail, p.h - 2 * rail}, {x, side * y + rail, p.h}, 0.004F);
    p.make.Box(p.is.hard, {side * x - rail, -y, p.h - 2 * rail}, {side * x + rail, y, p.h}, 0.004F);
  }
  for (const float sx : {-1.0F, 1.0F}) {
    for (const float sy : {-1.0F, 1.0F}) {
      p.make.Sheet(
          p.is.accent, 12, 6,
          [&](float u, float v) {
            const float narrow = 1 - 0.6F * std::exp(-18 * (v - 0.42F) * (v - 0.42F)),
                        fold = 0.02F * std::sin(6.2832F * 3 * u);
            const float along = 0.16F * p.d * u * narrow, out = 1.1F * post + fold * narrow;
            return Vec3{sx * (x + 0.2F * post - out), sy * (y - post - along), 0.06F * p.h + 0.92F * p.h * (1 - v)};
          },
          0.006F);
    }
  }
}

void MakeBed(Piece& p) {
  const bool canopy = p.h > 1.5F || p.Says("canopy") || p.Says("four-poster") || p.Says("four poster");
  const float head = p.h, deck = std::min({0.34F, 0.4F * p.h, 0.3F * p.d}), board = std::min(0.06F, 0.06F * p.d);
  const float rail = std::min(0.035F, 0.05F * p.w), leg = std::min(0.03F, 0.06F * p.smaller());
  const float top = RestHeightOf("bed", p.h);
  const float head_top = canopy ? std::min(1.25F, 0.6F * p.h) : head;
  if (canopy) {
    Canopy(p, std::min(0.045F, 0.06F * p.smaller()));
  } else {
    p.LegsAt(p.is.hard, p.w / 2 - 1.6F * leg, p.d / 2 - 1.6F * leg, 0.5F * deck, leg, 0.7F);
  }
  for (const float side : {-1.0F, 1.0F}) {
    p.make.Box(p.is.hard, {side * p.w / 2, -p.d / 2, 0.35F * deck}, {side * (p.w / 2 - rail), p.d / 2, deck}, 0.006F);
  }
  p.make.Box(p.is.hard, {-p.w / 2 + rail, p.d / 2 - rail, 0.35F * deck}, {p.w / 2 - rail, p.d / 2, 1.15F * deck},
             0.006F);
  p.make.Box(p.is.hard, {-p.w / 2 + rail, -p.d / 2 + board, 0.45F * deck},
             {p.w / 2 - rail, p.d / 2 - rail, 0.75F * deck}, 0);
  const bool padded =
      p.Says("upholstered") || p.Says("upholstery") || p.Says("fabric") || p.Says("velvet") || p.Says("tufted");
  if (padded) {
    const int panels = std::clamp(static_cast<int>(p.w / 0.3F), 1, 7);
    for (int i = 0; i < panels; ++i) {
      const float pitch = p.w / static_cast<float>(panels), from = -p.w / 2 + pitch * static_cast<float>(i);
      p.make.Cushion(p.is.soft, {from, -p.d / 2, 0.1F * head_top}, {from + pitch, -p.d / 2 + 1.4F * board, head_top},
                     0.03F, 0.012F);
    }
  } else {
    p.make.Box(p.is.hard, {-p.w / 2, -p.d / 2, 0}, {p.w / 2, -p.d / 2 + board, 0.94F * head_top}, 0.012F);
    p.make.Box(p.is.hard, {-p.w / 2, -p.d / 2, 0.93F * head_top}, {p.w / 2, -p.d / 2 + 1.4F * board, head_top}, 0.012F);
  }
  const float in = canopy ? 0.03F * p.w : 0.02F * p.w;
  MakeBedding(p,
              {-p.w / 2 + in, p.w / 2 - in, -p.d / 2 + 1.3F * board, p.d / 2 - (canopy ? 0.12F : 0.6F * rail),
               0.72F * deck, top},
              true);
}

void MakeBunkBed(Piece& p) {
  const float post = std::min(0.035F, 0.05F * p.smaller()), rail = 0.6F * post;
  Posts(p, post, p.h, false);
  for (const float level : {0.16F, 0.62F}) {
    const float z = level * p.h, high = 0.07F * p.h;
    for (const float side : {-1.0F, 1.0F}) {
      p.make.Box(p.is.hard, {side * (p.w / 2 - post) - rail, -p.d / 2 + post, z - high},
                 {side * (p.w / 2 - post) + rail, p.d / 2 - post, z}, 0.005F);
      p.make.Box(p.is.hard, {-p.w / 2 + post, side * (p.d / 2 - post) - rail, z - high},
                 {p.w / 2 - post, side * (p.d / 2 - post) + rail, z}, 0.005F);
    }
    p.make.Box(p.is.hard, {-p.w / 2 + post, -p.d / 2 + post, z - 0.6F * high},
               {p.w / 2 - post, p.d / 2 - post, z - 0.3F * high}, 0);
    MakeBedding(p,
                {-p.w / 2 + 2.2F * post, p.w / 2 - 2.2F * post, -p.d / 2 + 2.2F * post, p.d / 2 - 2.2F * post,
                 z - 0.4F * high, z + 0.09F * p.h},
                false);
  }
  for (const float z : {0.83F, 0.93F}) {  // guards of the upper bed
    for (const float side : {-1.0F, 1.0F}) {
      p.make.Box(p.is.hard, {side * (p.w / 2 - post) - rail, -p.d / 2 + post, z * p.h - post},
                 {side * (p.w / 2 - post) + rail, (side > 0 ? 0.1F : 0.5F) * p.d - post, z * p.h + post * 0.4F},
                 0.004F);
      p.make.Box(p.is.hard, {-p.w / 2 + post, side * (p.d / 2 - post) - rail, z * p.h - post},
                 {p.w / 2 - post, side * (p.d / 2 - post) + rail, z * p.h + post * 0.4F}, 0.004F);
    }
  }
  const float from = 0.18F * p.d, to = 0.42F * p.d, x = p.w / 2 - 0.6F * post;  // the ladder
  for (const float y : {from, to})
    p.make.Box(p.is.hard, {x - rail, y - rail, 0}, {x + rail, y + rail, 0.95F * p.h}, 0.004F);
  for (int i = 1; i <= 5; ++i) {
    const float z = 0.11F * static_cast<float>(i) * p.h;
    p.make.Bar(p.is.hard, {x, from, z}, {x, to, z}, 0.7F * rail, 8);
  }
}

void MakeCot(Piece& p) {
  const float post = std::min(0.02F, 0.05F * p.smaller()), rail = 0.9F * post, low = 0.2F * p.h,
              high = p.h - 2.2F * post;
  Posts(p, post, p.h - 1.2F * post, true);
  const auto side = [&](Vec3 from, Vec3 to) {
    for (const float z : {low, high})
      p.make.Box(p.is.hard, from + Vec3{-rail, -rail, z - 1.2F * rail}, to + Vec3{rail, rail, z + 1.2F * rail}, 0.004F);
    const int bars = std::clamp(static_cast<int>(Length(to - from) / 0.085F), 3, 22);
    for (int i = 1; i < bars; ++i) {
      const Vec3 at = from + (to - from) * (static_cast<float>(i) / static_cast<float>(bars));
      p.make.Bar(p.is.hard, at + Vec3{0, 0, low}, at + Vec3{0, 0, high}, 0.45F * post, 6);
    }
  };
  const float x = p.w / 2 - post, y = p.d / 2 - post;
  side({-x, -y, 0}, {-x, y, 0}), side({x, -y, 0}, {x, y, 0}), side({-x, -y, 0}, {x, -y, 0}),
      side({-x, y, 0}, {x, y, 0});
  p.make.Box(p.is.hard, {-x, -y, low - 0.03F * p.h}, {x, y, low + 0.02F * p.h}, 0.003F);
  const bool lengthwise = p.d >= p.w;
  p.make.Cushion(p.is.pale, {-0.93F * x, -0.95F * y, low}, {0.93F * x, 0.95F * y, 0.42F * p.h}, 0.03F, 0.006F);
  if (lengthwise) {
    p.make.Cushion(p.is.soft, {-0.95F * x, -0.2F * y, low + 0.08F * p.h}, {0.95F * x, 0.97F * y, 0.45F * p.h}, 0.03F,
                   0.008F);
    p.make.Cushion(p.is.pale, {-0.6F * x, -0.88F * y, 0.4F * p.h}, {0.6F * x, -0.5F * y, 0.49F * p.h}, 0.03F, 0.015F);
  } else {
    p.make.Cushion(p.is.soft, {-0.2F * x, -0.95F * y, low + 0.08F * p.h}, {0.97F * x, 0.95F * y, 0.45F * p.h}, 0.03F,
                   0.008F);
    p.make.Cushion(p.is.pale, {-0.88F * x, -0.6F * y, 0.4F * p.h}, {-0.5F * x, 0.6F * y, 0.49F * p.h}, 0.03F, 0.015F);
  }
}

void MakeCoffin(Piece& p) {
  // Wide at the shoulders; along the longer side, its head at the back.
  const bool lengthwise = p.d >= p.w;
  const float width = lengthwise ? p.w : p.d, length = lengthwise ? p.d : p.w;
  const auto outline = [&](float scale, float inset) {
    const float x = width / 2 * scale - inset, y = length / 2 * scale - inset;
    return std::array<Vec2, 6>{
        {{-0.62F * x, -y}, {0.62F * x, -y}, {x, -0.42F * y}, {0.58F * x, y}, {-0.58F * x, y}, {-x, -0.42F * y}}};
  };
  const Frame frame = lengthwise ? Frame{} : Frame{{}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}};
  const float wall = std::min(0.035F, 0.06F * width), lid = 0.2F * p.h;
  p.make.In(frame, [&] {
    p.make.Slab(p.is.hard, outline(0.97F, 0), 0, 0.1F * p.h, 0.006F);
    p.make.Slab(p.is.hard, outline(0.93F, 0), 0.09F * p.h, p.h - lid, 0.006F);
    p.make.Slab(p.is.soft, outline(0.955F, wall * 0.2F), p.h - lid - 0.03F * p.h, p.h - lid + 0.02F * p.h, 0.004F);
    p.make.Slab(p.is.hard, outline(1, 0), p.h - lid + 0.01F * p.h, p.h - 0.08F * p.h, 0.012F);
    p.make.Slab(p.is.hard, outline(0.9F, wall), p.h - 0.09F * p.h, p.h - 0.02F * p.h, 0.02F);
    // A cross of metal on the lid, handles along the sides.
    const float bar = 0.035F * width, z = p.h - 0.03F * p.h;
    p.make.Box(p.is.metal, {-bar, -0.36F * length, z}, {bar, 0.3F * length, p.h}, 0.004F);
    p.make.Box(p.is.metal, {-0.22F * width, -0.2F * length - bar, z}, {0.22F * width, -0.2F * length + bar, p.h},
               0.004F);
    for (const float side : {-1.0F, 1.0F}) {
      for (const float y : {-0.05F, 0.2F}) {
        const float x = side * width * (0.44F - 0.28F * (y + 0.05F)), z_handle = 0.5F * p.h;
        p.make.Bar(p.is.metal, {x, (y - 0.06F) * length, z_handle},
                   {x - side * 0.02F * width, (y + 0.06F) * length, z_handle}, 0.02F * width, 8);
      }
    }
  });
}

}  // namespace

std::span<const PieceMaker> BedMakers() {
  static constexpr PieceMaker kMakers[] = {
      {"bed", MakeBed}, {"bunk_bed", MakeBunkBed}, {"cot", MakeCot}, {"coffin", MakeCoffin}};
  return kMakers;
}

}  // namespace flair::renderer
