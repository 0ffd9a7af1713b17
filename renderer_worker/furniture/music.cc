// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "renderer_worker/furniture/piece.h"

// Instruments and what sounds.
namespace flair::renderer {
namespace {

// White keys with black ones on them; the player sits at +y.
void Keys(Piece& p, float left, float right, float back, float front, float top) {
  p.make.Box(stuff::Ivory(), {left, back, top - 0.012F}, {right, front, top}, 0.002F);
  const int octaves = std::clamp(static_cast<int>((right - left) / 0.165F), 1, 8);
  const float white = (right - left) / static_cast<float>(7 * octaves);
  for (int i = 1; i < 7 * octaves; ++i) {
    const float x = left + white * static_cast<float>(i);
    if (const int step = i % 7; step != 0 && step != 3) {
      p.make.Box(stuff::Black(), {x - 0.3F * white, back, top - 0.002F},
                 {x + 0.3F * white, back + 0.62F * (front - back), top + 0.008F}, 0.001F);
    }
  }
}

void MakeUprightPiano(Piece& p) {
  const float key = std::min(0.68F, 0.6F * p.h), body = 0.14F * p.d, board = std::min(0.03F, 0.06F * p.d);
  p.make.Box(p.is.hard, {-0.49F * p.w, -p.d / 2, 0.04F * p.h}, {0.49F * p.w, body, p.h - 0.03F * p.h}, 0.006F);
  p.make.Box(p.is.hard, {-p.w / 2, -p.d / 2, p.h - 0.035F * p.h}, {p.w / 2, body + board, p.h}, 0.008F);
  p.make.Box(p.is.hard, {-0.49F * p.w, body - 0.01F, key - 3 * board}, {0.49F * p.w, p.d / 2, key - board}, 0.006F);
  Keys(p, -0.44F * p.w, 0.44F * p.w, body + 0.3F * board, p.d / 2 - 0.6F * board, key);
  for (const float side : {-1.0F, 1.0F}) {
    p.make.Box(p.is.hard, {side * 0.445F * p.w, body, key - board}, {side * p.w / 2, p.d / 2, key + 1.4F * board},
               0.008F);
    p.make.Taper(p.is.hard, {side * 0.47F * p.w, p.d / 2 - 1.4F * board, 0}, {0.9F * board, board},
                 {side * 0.47F * p.w, p.d / 2 - 1.4F * board, key - 2 * board}, {1.1F * board, 1.1F * board});
    p.make.Box(p.is.hard, {side * 0.43F * p.w, -p.d / 2, 0}, {side * p.w / 2, p.d / 2, 0.05F * p.h}, 0.006F);
  }
  p.make.Box(p.is.hard, {-0.3F * p.w, body, 0.72F * p.h}, {0.3F * p.w, body + 0.6F * board, 0.9F * p.h}, 0.004F);
  for (const float x : {-0.1F, 0.09F})
    p.make.Box(stuff::Paper(), {x * p.w - 0.08F * p.w, body + 0.6F * board, 0.74F * p.h},
               {x * p.w + 0.08F * p.w, body + 0.75F * board, 0.92F * p.h}, 0);
  for (const float x : {-0.06F, 0.0F, 0.06F})
    p.make.Box(p.is.metal, {x * p.w - 0.012F, body, 0.05F * p.h}, {x * p.w + 0.012F, body + 0.12F * p.d, 0.065F * p.h},
               0.004F);
}

void MakeGrandPiano(Piece& p) {
  // Keyboard at the front; the case narrows to a round tail at the back. The straight side is at the player's left
  // (+x).
  const float x = p.w / 2, y = p.d / 2, low = std::min(0.72F, 0.55F * p.h), rim = std::min(1.02F, 0.76F * p.h),
              keys = std::min(0.3F, 0.2F * p.d);
  std::vector<Vec2> outline{{x, y - keys}, {x, -0.55F * y}};
  for (const Vec2& point : ArcPoints({x - 0.42F * p.w, -0.55F * y}, 0.42F * p.w, 0.45F * y, 0, -kPiFloat, 10))
    outline.push_back(point);
  outline.push_back({x - 0.86F * p.w, -0.2F * y});
  outline.push_back({-0.44F * p.w, 0.05F * y});
  outline.push_back({-x, 0.35F * y});
  outline.push_back({-x, y - keys});
  std::reverse(outline.begin(), outline.end());
  p.make.Slab(p.is.hard, outline, low, rim, 0.008F);
  std::vector<Vec2> plate = outline;
  for (Vec2& point : plate) point = {0.9F * point.x, 0.9F * point.y};
  p.make.Slab(p.is.metal, plate, rim - 0.01F, rim + 0.003F, 0.001F);
  p.make.Box(p.is.hard, {-x, y - keys, low}, {x, y, low + 0.35F * (rim - low)}, 0.008F);
  for (const float side : {-1.0F, 1.0F})
    p.make.Box(p.is.hard, {side * x, y - keys, low}, {side * (x - 0.07F * p.w), y, low + 0.75F * (rim - low)}, 0.01F);
  Keys(p, -x + 0.075F * p.w, x - 0.075F * p.w, y - 0.62F * keys, y - 0.05F * keys, low + 0.45F * (rim - low));
  // The lid stands open along the straight side.
  const float lift = std::atan2(0.98F * (p.h - rim), p.w);
  p.make.In(Frame{{x, 0, rim}, {std::cos(lift), 0, -std::sin(lift)}, {0, 1, 0}, {std::sin(lift), 0, std::cos(lift)}},
            [&] {
              std::vector<Vec2> lid;
              for (const Vec2& point : outline) lid.push_back({(point.x - x) * 0.99F / std::cos(lift), point.y});
              p.make.Slab(p.is.hard, lid, 0.004F, 0.03F, 0.006F);
            });
  p.make.Bar(p.is.hard, {-0.2F * p.w, 0.2F * y, rim}, {-0.3F * p.w, 0.2F * y, rim + 0.78F * (p.h - rim)}, 0.012F, 8);
  const float leg = std::min(0.05F, 0.05F * p.smaller());
  for (const Vec2 at : {Vec2{-0.42F * p.w, 0.72F * y}, Vec2{0.42F * p.w, 0.72F * y}, Vec2{0.12F * p.w, -0.6F * y}}) {
    p.make.Lathe(p.is.hard, {at.x, at.y, 0},
                 std::array<Vec2, 5>{{{0.8F * leg, 0},
                                      {leg, 0.06F * low},
                                      {0.7F * leg, 0.12F * low},
                                      {1.1F * leg, 0.85F * low},
                                      {1.4F * leg, low + 0.005F}}},
                 14);
  }
  p.make.Box(p.is.metal, {-0.08F * p.w, 0.5F * y, 0.08F * low}, {0.08F * p.w, 0.62F * y, 0.12F * low}, 0.004F);
  p.make.Bar(p.is.hard, {0, 0.54F * y, 0.1F * low}, {0, 0.54F * y, low}, 0.03F * std::min(1.0F, p.w), 8);
}

void MakeKeyboard(Piece& p) {
  const bool desk = p.h < 0.3F, computer = desk && p.w < 0.6F;
  const float low = desk ? 0 : p.h - std::min(0.12F, 0.3F * p.h);
  p.make.Box(p.is.hard, {-p.w / 2, -p.d / 2, low}, {p.w / 2, p.d / 2, p.h - 0.12F * (p.h - low)}, 0.008F);
  const float top = p.h - 0.1F * (p.h - low);
  if (computer) {
    for (int row = 0; row < 4; ++row) {
      for (int i = 0; i < 12; ++i) {
        const float x = p.w * (-0.46F + 0.077F * static_cast<float>(i)),
                    y = p.d * (-0.4F + 0.21F * static_cast<float>(row));
        p.make.Box(stuff::White(), {x, y, top - 0.002F}, {x + 0.066F * p.w, y + 0.17F * p.d, p.h}, 0.001F);
      }
    }
    return;
  }
  Keys(p, -0.47F * p.w, 0.47F * p.w, -0.08F * p.d, 0.46F * p.d, p.h - 0.008F);
  p.make.Box(stuff::Screen(), {-0.12F * p.w, -0.42F * p.d, top - 0.004F}, {0.12F * p.w, -0.2F * p.d, top + 0.004F},
             0.001F);
  if (desk) return;
  for (const float side : {-1.0F, 1.0F}) {
    const float x = side * 0.32F * p.w, r = 0.016F * std::min(1.0F, p.d / 0.3F);
    p.make.Bar(p.is.metal, {x, -0.42F * p.d, r}, {x, 0.42F * p.d, low}, r, 8);
    p.make.Bar(p.is.metal, {x, 0.42F * p.d, r}, {x, -0.42F * p.d, low}, r, 8);
  }
}

void MakeDrums(Piece& p) {
  const float s = p.smaller();
  const auto drum = [&](Vec3 centre, Vec3 axis, float r, float length) {
    const Vec3 side = Normalized(Cross(std::abs(axis.y) > 0.9F ? Vec3{1, 0, 0} : Vec3{0, 1, 0}, axis));
    p.make.In({centre, side, Cross(axis, side), axis}, [&] {
      p.make.Cylinder(p.is.hard, {0, 0, -length / 2}, r, length, 0.004F, 20);
      for (const float z : {-length / 2, length / 2}) {
        p.make.Ring(
            p.is.metal, {0, 0, z},
            std::array<Vec2, 4>{
                {{0.97F * r, -0.04F * r}, {1.04F * r, -0.04F * r}, {1.04F * r, 0.04F * r}, {0.97F * r, 0.04F * r}}},
            26);
        p.make.Cylinder(stuff::Ivory(), {0, 0, z - 0.005F * s}, 0.97F * r, 0.01F * s, 0.001F, 20);
      }
    });
  };
  const auto stand = [&](Vec3 top, float foot) {
    const float r = 0.008F * s / 1.2F;
    p.make.Bar(p.is.metal, {top.x, top.y, 0.12F * p.h}, top, r, 8);
    for (int i = 0; i < 3; ++i) {
      const float turn = 2 * kPiFloat / 3 * static_cast<float>(i);
      p.make.Bar(p.is.metal, {top.x + foot * std::cos(turn), top.y + foot * std::sin(turn), r},
                 {top.x, top.y, 0.16F * p.h}, r, 6);
    }
  };
  drum({0, -0.12F * p.d, 0.21F * s}, {0, 1, 0}, 0.21F * s, 0.34F * p.d);
  drum({-0.13F * p.w, 0.0F, 0.55F * p.h}, Normalized({0.15F, 0.35F, 1}), 0.12F * s, 0.16F * s);
  drum({0.13F * p.w, 0.0F, 0.55F * p.h}, Normalized({-0.15F, 0.35F, 1}), 0.13F * s, 0.17F * s);
  drum({-0.28F * p.w, 0.2F * p.d, 0.46F * p.h}, Normalized({0, 0.1F, 1}), 0.15F * s, 0.1F * s);
  drum({0.3F * p.w, 0.18F * p.d, 0.32F * p.h}, {0, 0, 1}, 0.18F * s, 0.3F * s);
  stand({-0.28F * p.w, 0.2F * p.d, 0.42F * p.h}, 0.12F * s);
  for (const Vec3 at : {Vec3{-0.36F * p.w, -0.2F * p.d, 0.94F * p.h}, Vec3{0.34F * p.w, -0.22F * p.d, p.h},
                        Vec3{-0.4F * p.w, 0.3F * p.d, 0.72F * p.h}}) {
    p.make.Lathe(
        p.is.metal, at - Vec3{0, 0, 0.02F * p.h},
        std::array<Vec2, 4>{{{0.155F * s, 0}, {0.155F * s, 0.003F * p.h}, {0.04F * s, 0.015F * p.h}, {0, 0.02F * p.h}}},
        26);
    stand(at - Vec3{0, 0, 0.015F * p.h}, 0.1F * s);
  }
  p.make.Cylinder(stuff::Black(), {0.02F * p.w, 0.4F * p.d, 0.36F * p.h}, 0.13F * s, 0.07F * p.h, 0.015F, 20);
  p.make.Bar(p.is.metal, {0.02F * p.w, 0.4F * p.d, 0}, {0.02F * p.w, 0.4F * p.d, 0.37F * p.h}, 0.02F * s, 8);
}

void MakeGuitar(Piece& p) {
  const float x = 0.42F * p.w, body = 0.45F * p.h, thick = std::min(0.1F, 0.35F * p.d), lean = 0.16F;
  p.make.In(Frame::TurnedX({0, 0.12F * p.d, 0.05F * p.h}, lean), [&] {
    p.make.In({{}, {-1, 0, 0}, {0, 0, 1}, {0, 1, 0}}, [&] {
      std::vector<Vec2> outline;
      for (int i = 0; i < 36; ++i) {  // two bouts and a waist
        const float turn = 2 * kPiFloat * static_cast<float>(i) / 36 - kPiFloat / 2, up = (1 + std::sin(turn)) / 2;
        const float waist = 1 - 0.32F * std::exp(-30 * (up - 0.6F) * (up - 0.6F)) - 0.2F * up * up;
        outline.push_back({x * waist * std::cos(turn), body * up});
      }
      p.make.Slab(p.is.hard, outline, -thick / 2, thick / 2, 0.006F);
      p.make.Cylinder(stuff::Black(), {0, 0.62F * body, thick / 2 - 0.001F}, 0.24F * x, 0.003F, 0.001F, 20);
      p.make.Box(stuff::Black(), {-0.1F * x, 0.5F * body, thick / 2 - 0.002F},
                 {0.1F * x, 0.86F * p.h, thick / 2 + 0.012F}, 0.003F);
      p.make.Box(stuff::Black(), {-0.3F * x, 0.26F * body, thick / 2 - 0.001F},
                 {0.3F * x, 0.31F * body, thick / 2 + 0.01F}, 0.003F);
      p.make.Box(p.is.hard, {-0.17F * x, 0.84F * p.h, thick / 2 - 0.006F}, {0.17F * x, 0.96F * p.h, thick / 2 + 0.01F},
                 0.004F);
    });
  });
  const float r = std::min(0.01F, 0.05F * p.smaller());
  for (const float side : {-1.0F, 1.0F}) {
    p.make.Bar(stuff::Black(), {side * 0.44F * p.w, p.d / 2 - r, r}, {0, -0.2F * p.d, 0.5F * p.h}, r, 8);
    p.make.Bar(stuff::Black(), {side * 0.3F * p.w, 0.2F * p.d, 0.06F * p.h},
               {side * 0.3F * p.w, p.d / 2 - r, 0.08F * p.h}, r, 8);
  }
  p.make.Bar(stuff::Black(), {0, -p.d / 2 + r, r}, {0, -0.2F * p.d, 0.5F * p.h}, r, 8);
}

void MakeMusicStand(Piece& p) {
  const float r = std::min(0.014F, 0.06F * p.smaller()), desk = 0.7F * p.h;
  p.make.Bar(p.is.hard, {0, 0, 0.12F * p.h}, {0, 0, 0.8F * p.h}, 1.2F * r, 10);
  for (int i = 0; i < 3; ++i) {
    const float turn = kPiFloat / 2 + 2 * kPiFloat / 3 * static_cast<float>(i);
    p.make.Bar(p.is.hard, {0.45F * p.smaller() * std::cos(turn), 0.45F * p.smaller() * std::sin(turn), r},
               {0, 0, 0.22F * p.h}, r, 8);
  }
  p.make.In(Frame::TurnedX({0, 0.2F * p.d, desk}, 0.5F), [&] {
    const float high = 0.9F * (p.h - desk);
    p.make.Box(p.is.hard, {-p.w / 2, -r, 0}, {p.w / 2, 0, high}, 0.003F);
    p.make.Box(p.is.hard, {-p.w / 2, -r, 0}, {p.w / 2, 0.12F * p.d, r}, 0.002F);
    for (const float side : {-1.0F, 1.0F})
      p.make.Box(stuff::Paper(), {side * 0.004F, 0, r}, {side * 0.42F * p.w, 0.006F, 0.9F * high}, 0.001F);
  });
}

void MakeSpeaker(Piece& p) {
  p.make.Box(p.is.hard, {-p.w / 2, -p.d / 2, 0}, {p.w / 2, 0.46F * p.d, p.h}, 0.008F);
  const auto cone = [&](float x, float z, float r) {
    p.make.In({{x, 0.46F * p.d, z}, {-1, 0, 0}, {0, 0, 1}, {0, 1, 0}}, [&] {
      p.make.Ring(stuff::Rubber(), {},
                  std::array<Vec2, 4>{{{0.8F * r, 0}, {r, 0}, {r, 0.03F * p.d}, {0.85F * r, 0.04F * p.d}}}, 24);
      p.make.Lathe(
          p.is.metal, {},
          std::array<Vec2, 4>{{{0.82F * r, 0}, {0.8F * r, 0.015F * p.d}, {0.35F * r, 0.002F * p.d}, {0, 0.02F * p.d}}},
          20);
    });
  };
  if (p.w > 1.6F * p.h) {  // a sound bar
    p.make.Box(stuff::Rubber(), {-0.47F * p.w, 0.45F * p.d, 0.14F * p.h}, {0.47F * p.w, p.d / 2, 0.86F * p.h}, 0.004F);
    return;
  }
  cone(0, 0.32F * p.h, std::min(0.4F * p.w, 0.22F * p.h));
  if (p.h > 1.6F * p.w) cone(0, 0.6F * p.h, std::min(0.34F * p.w, 0.12F * p.h));
  cone(0, 0.82F * p.h, std::min(0.22F * p.w, 0.09F * p.h));
}

}  // namespace

std::span<const PieceMaker> MusicMakers() {
  static constexpr PieceMaker kMakers[] = {{"upright_piano", MakeUprightPiano},
                                           {"grand_piano", MakeGrandPiano},
                                           {"keyboard", MakeKeyboard},
                                           {"drums", MakeDrums},
                                           {"guitar", MakeGuitar},
                                           {"music_stand", MakeMusicStand},
                                           {"speaker", MakeSpeaker}};
  return kMakers;
}

}  // namespace flair::renderer
