// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "renderer_worker/furniture/piece.h"

// What one trains with.
namespace flair::renderer {
namespace {

// A disc that stands upright, its axis along x.
void UprightDisc(Piece& p, const Material& material, Vec3 centre, float radius, float thick, int sides = 24) {
  p.make.In({centre, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}}, [&] {
    p.make.Cylinder(material, {0, 0, -thick / 2}, radius, thick, 0.005F, sides);
  });
}

void Dumbbell(Piece& p, Vec3 centre, float length, float radius, bool along_y) {
  const Vec3 axis = along_y ? Vec3{0, 1, 0} : Vec3{1, 0, 0}, side = along_y ? Vec3{-1, 0, 0} : Vec3{0, 1, 0};
  p.make.In({centre, side, Cross(axis, side), axis}, [&] {
    p.make.Cylinder(p.is.metal, {0, 0, -length / 2}, 0.3F * radius, length, 0.001F, 8);
    for (const float z : {-length / 2, 0.22F * length})
      p.make.Cylinder(stuff::Rubber(), {0, 0, z}, radius, 0.28F * length, 0.006F, 6);
  });
}

void MakeTreadmill(Piece& p) {
  // One runs towards the back of the box, where the display is.
  const float deck = std::min(0.2F, 0.16F * p.h), rail = 0.09F * p.w, post = std::min(0.03F, 0.05F * p.w),
              y = -0.36F * p.d;
  p.make.Box(p.is.hard, {-p.w / 2, -p.d / 2, 0.2F * deck}, {p.w / 2, p.d / 2, 0.8F * deck}, 0.02F);
  for (const float side : {-1.0F, 1.0F})
    p.make.Box(p.is.hard, {side * (p.w / 2 - rail), -0.44F * p.d, 0.7F * deck}, {side * p.w / 2, 0.49F * p.d, deck},
               0.01F);
  p.make.Box(stuff::Rubber(), {-p.w / 2 + rail, -0.44F * p.d, 0.7F * deck}, {p.w / 2 - rail, 0.49F * p.d, 0.93F * deck},
             0.004F);
  p.make.Cushion(p.is.hard, {-0.46F * p.w, -p.d / 2, 0.3F * deck}, {0.46F * p.w, -0.36F * p.d, 1.7F * deck}, 0.05F,
                 0.01F);
  for (const float side : {-1.0F, 1.0F}) {
    const float x = side * (p.w / 2 - 1.5F * post);
    p.make.Taper(p.is.metal, {x, y, 0.6F * deck}, {post, 1.6F * post}, {x, y + 0.03F * p.d, 0.82F * p.h},
                 {0.8F * post, 1.2F * post});
    p.make.Bar(stuff::Rubber(), {x, y, 0.72F * p.h}, {x, 0.02F * p.d, 0.7F * p.h}, 0.9F * post, 10);
  }
  for (const float x : {-0.42F, 0.42F})
    p.make.Box(stuff::Rubber(), {x * p.w - 0.03F * p.w, 0.46F * p.d, 0},
               {x * p.w + 0.03F * p.w, 0.49F * p.d, 0.25F * deck}, 0.003F);
  p.make.In(Frame::TurnedX({0, y + 0.02F * p.d, 0.76F * p.h}, 0.5F), [&] {
    p.make.Box(p.is.hard, {-p.w / 2 + post, -0.04F * p.d, 0}, {p.w / 2 - post, 0, 0.24F * p.h}, 0.015F);
    p.make.Box(stuff::Lit(), {-0.26F * p.w, -0.004F, 0.08F * p.h}, {0.26F * p.w, 0.006F, 0.2F * p.h}, 0.002F);
  });
}

void MakeExerciseBike(Piece& p) {
  const float r = std::min({0.24F * p.d, 0.26F * p.h}), tube = std::min(0.03F, 0.08F * p.w), bar = 0.9F * p.h;
  const bool cycle =
      p.Says("bicycle") || (p.Says("bike") && !p.Says("exercise") && !p.Says("stationary") && !p.Says("spin"));
  const float front = -0.5F * p.d + r, rear = 0.5F * p.d - r;  // rides towards the back of its box
  const auto wheel = [&](float y) {
    p.make.In({{0, y, r}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}}, [&] {
      p.make.Hoop(stuff::Rubber(), {}, r - 0.5F * tube, tube, 30);
      for (int i = 0; i < 8; ++i) {
        const float turn = kPiFloat / 4 * static_cast<float>(i);
        p.make.Bar(p.is.metal, {}, {0.94F * r * std::cos(turn), 0.94F * r * std::sin(turn), 0}, 0.1F * tube, 4);
      }
    });
  };
  const Vec3 crank{0, 0.04F * p.d, 0.28F * p.h}, seat{0, 0.2F * p.d, 0.76F * p.h}, head{0, -0.24F * p.d, 0.76F * p.h};
  if (cycle) {
    wheel(front), wheel(rear);
    p.make.Bar(p.is.hard, crank, {0, rear, r}, 0.6F * tube), p.make.Bar(p.is.hard, seat, {0, rear, r}, 0.5F * tube);
    p.make.Bar(p.is.hard, head, {0, front, r}, 0.6F * tube);
  } else {
    UprightDisc(p, p.is.metal, {0, -0.24F * p.d, 1.1F * r}, r, 0.1F * p.w, 30);
    UprightDisc(p, p.is.hard, {0, -0.24F * p.d, 1.1F * r}, 0.6F * r, 0.16F * p.w, 24);
    for (const float y : {-0.46F, 0.46F})
      p.make.Box(p.is.hard, {-0.42F * p.w, y * p.d - tube, 0}, {0.42F * p.w, y * p.d + tube, 1.4F * tube}, 0.01F);
    p.make.Bar(p.is.hard, {0, -0.46F * p.d, tube}, {0, 0.46F * p.d, tube}, tube, 10);
    p.make.Bar(p.is.hard, {0, -0.24F * p.d, 0.2F * p.h}, head, 1.1F * tube, 10);
    p.make.Bar(p.is.hard, {0, 0.34F * p.d, tube}, crank, 1.2F * tube, 10);
  }
  p.make.Bar(p.is.hard, crank, seat, tube, 10), p.make.Bar(p.is.hard, crank, head, tube, 10);
  if (cycle) p.make.Bar(p.is.hard, seat, head, 0.8F * tube, 10);
  UprightDisc(p, p.is.metal, crank, 0.09F * p.h, 0.3F * tube);
  for (const float side : {-1.0F, 1.0F}) {
    const Vec3 pedal = crank + Vec3{side * 0.2F * p.w, side * 0.06F * p.d, side * 0.07F * p.h};
    p.make.Bar(p.is.metal, crank + Vec3{side * 0.16F * p.w, 0, 0}, pedal, 0.4F * tube, 6);
    p.make.Box(stuff::Rubber(), pedal + Vec3{side * 0.02F * p.w, -0.05F * p.d, -0.01F * p.h},
               pedal + Vec3{side * 0.22F * p.w, 0.05F * p.d, 0.01F * p.h}, 0.004F);
    p.make.Tube(stuff::Rubber(),
                std::array<Vec3, 4>{{head + Vec3{0, 0, 0.1F * p.h},
                                     {side * 0.3F * p.w, head.y, bar},
                                     {side * 0.48F * p.w, head.y - 0.06F * p.d, bar},
                                     {side * 0.48F * p.w, head.y + 0.12F * p.d, bar + 0.02F * p.h}}},
                std::array{0.6F * tube}, 8);
  }
  p.make.Bar(p.is.metal, head, head + Vec3{0, 0, 0.14F * p.h}, 0.7F * tube, 8);
  p.make.Cushion(stuff::Rubber(), seat + Vec3{-0.22F * p.w, -0.12F * p.d, 0},
                 seat + Vec3{0.22F * p.w, 0.08F * p.d, 0.07F * p.h}, 0.03F * p.h, 0.01F);
  if (!cycle)
    p.make.Box(stuff::Lit(), {-0.2F * p.w, head.y - 0.04F * p.d, bar + 0.01F * p.h},
               {0.2F * p.w, head.y + 0.02F * p.d, p.h}, 0.004F);
}

void MakeRowingMachine(Piece& p) {
  const bool lengthwise = p.d >= p.w;
  const float length = lengthwise ? p.d : p.w, width = lengthwise ? p.w : p.d,
              r = std::min(0.42F * p.h, 0.14F * length), tube = std::min(0.035F, 0.08F * width);
  p.make.In(lengthwise ? Frame{} : Frame{{}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}, [&] {
    const float y = -0.5F * length + r;
    p.make.In({{0, y, p.h - r}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}}, [&] {
      p.make.Cylinder(p.is.hard, {0, 0, -0.24F * width}, r, 0.48F * width, 0.02F, 28);
    });
    p.make.Bar(p.is.metal, {0, y, 0.5F * p.h}, {0, 0.48F * length, 0.32F * p.h}, 1.3F * tube, 10);
    for (const float at : {y, 0.46F * length}) {
      p.make.Box(p.is.hard, {-0.5F * width, at - tube, 0}, {0.5F * width, at + tube, 1.6F * tube}, 0.01F);
      p.make.Bar(p.is.hard, {0, at, tube}, {0, at, at < 0 ? p.h - r : 0.34F * p.h}, 1.2F * tube, 10);
    }
    p.make.Cushion(stuff::Rubber(), {-0.36F * width, 0.12F * length, 0.4F * p.h},
                   {0.36F * width, 0.28F * length, 0.52F * p.h}, 0.04F * p.h, 0.01F);
    for (const float side : {-1.0F, 1.0F})
      p.make.Box(stuff::Rubber(), {side * 0.12F * width, -0.2F * length, 0.36F * p.h},
                 {side * 0.4F * width, -0.1F * length, 0.44F * p.h}, 0.01F);
    p.make.Bar(stuff::Rubber(), {-0.38F * width, -0.12F * length, 0.58F * p.h},
               {0.38F * width, -0.12F * length, 0.58F * p.h}, 0.6F * tube, 8);
    p.make.Bar(p.is.metal, {0, y + 0.7F * r, p.h - r}, {0, -0.12F * length, 0.58F * p.h}, 0.2F * tube, 6);
  });
}

void MakeWeightBench(Piece& p) {
  const bool lengthwise = p.d >= p.w || p.h > 0.8F;
  const float width = lengthwise ? p.w : p.d, length = lengthwise ? p.d : p.w, seat = std::min(0.44F, 0.5F * p.h),
              tube = std::min(0.035F, 0.05F * width);
  p.make.In(lengthwise ? Frame{} : Frame{{}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}, [&] {
    const float pad = std::min(0.16F, 0.3F * width);
    for (const float y : {-0.28F, 0.38F}) {
      p.make.Box(p.is.hard, {-0.24F * width, y * length - tube, 0}, {0.24F * width, y * length + tube, 2 * tube},
                 0.006F);
      p.make.Box(p.is.hard, {-tube, y * length - tube, tube}, {tube, y * length + tube, seat - 0.05F * p.h}, 0.006F);
    }
    p.make.Box(p.is.hard, {-tube, -0.4F * length, seat - 0.1F * p.h - tube},
               {tube, 0.42F * length, seat - 0.1F * p.h + tube}, 0.006F);
    p.make.Cushion(stuff::Rubber(), {-pad, -0.44F * length, seat - 0.08F * p.h}, {pad, 0.2F * length, seat}, 0.03F,
                   0.006F);
    p.make.Cushion(stuff::Rubber(), {-pad, 0.22F * length, seat - 0.08F * p.h}, {pad, 0.48F * length, seat}, 0.03F,
                   0.006F);
    const float rack = p.h > 1.25F * seat ? 0.88F * p.h : seat + 0.1F, y = -0.36F * length,
                disc = std::min({0.22F, 0.2F * length, p.h > 1.2F * seat ? p.h - rack : 0.1F});
    for (const float side : {-1.0F, 1.0F}) {
      p.make.Box(p.is.hard, {side * 0.3F * width - tube, y - tube, 0}, {side * 0.3F * width + tube, y + tube, rack},
                 0.006F);
      p.make.Box(p.is.hard, {side * 0.3F * width - tube, y - 0.12F * length, 0},
                 {side * 0.3F * width + tube, y + 0.2F * length, 2 * tube}, 0.006F);
      for (const float out : {0.42F, 0.46F})
        UprightDisc(p, stuff::Rubber(), {side * out * width, y + 1.6F * tube, rack}, std::max(disc, 0.12F * p.h),
                    0.03F * width);
    }
    p.make.Bar(p.is.metal, {-0.5F * width, y + 1.6F * tube, rack}, {0.5F * width, y + 1.6F * tube, rack}, 0.5F * tube,
               8);
  });
}

void MakeWeights(Piece& p) {
  if (p.h < 0.35F && p.w < 0.7F) {  // a pair on the floor
    const float r = std::min(0.5F * p.h, 0.25F * p.smaller());
    const bool along_y = p.w > 1.4F * p.d;
    for (const float side : {-1.0F, 1.0F})
      Dumbbell(p, along_y ? Vec3{side * 0.25F * p.w, 0, r} : Vec3{0, side * 0.25F * p.d, r}, along_y ? p.d : p.w, r,
               along_y);
    return;
  }
  const float post = std::min(0.03F, 0.06F * p.smaller()), r = std::min({0.08F, 0.2F * p.d, 0.12F * p.h});
  const int rows = std::clamp(static_cast<int>(p.h / 0.32F), 1, 4),
            count = std::clamp(static_cast<int>(p.w / (2.6F * r)), 1, 8);
  for (const float side : {-1.0F, 1.0F}) {
    const float x = side * (p.w / 2 - post);
    p.make.Box(p.is.hard, {x - post, -p.d / 2, 0}, {x + post, p.d / 2, 2 * post}, 0.006F);
    p.make.Taper(p.is.hard, {x, 0.2F * p.d, post}, {post, 1.4F * post}, {x, -0.4F * p.d, p.h - r}, {post, 1.2F * post});
  }
  for (int row = 0; row < rows; ++row) {
    const float t = (static_cast<float>(row) + 0.7F) / (static_cast<float>(rows) + 0.3F), z = t * (p.h - 1.8F * r),
                y = p.d * (0.22F - 0.42F * t);
    p.make.In(Frame::TurnedX({0, y, z}, -0.28F), [&] {
      p.make.Box(p.is.hard, {-p.w / 2 + post, -0.24F * p.d, -post}, {p.w / 2 - post, 0.24F * p.d, 0}, 0.004F);
      for (int i = 0; i < count; ++i) {
        const float x = (p.w - 3 * post) * ((static_cast<float>(i) + 0.5F) / static_cast<float>(count) - 0.5F);
        Dumbbell(p, {x, 0, 0.8F * r}, 0.5F * p.d,
                 r * (0.7F + 0.3F * static_cast<float>(rows - row) / static_cast<float>(rows)), true);
      }
    });
  }
}

void MakePunchingBag(Piece& p) {
  const float r = 0.36F * p.smaller();
  p.make.Lathe(p.is.soft, {0, 0, 0.3F * p.h},
               std::array<Vec2, 6>{{{0.8F * r, 0},
                                    {r, 0.03F * p.h},
                                    {r, 0.55F * p.h},
                                    {0.9F * r, 0.6F * p.h},
                                    {0.4F * r, 0.66F * p.h},
                                    {0.1F * r, 0.7F * p.h}}},
               24);
  p.make.Ring(p.is.metal, {0, 0, 0.8F * p.h},
              std::array<Vec2, 4>{{{0.98F * r, 0}, {1.02F * r, 0}, {1.02F * r, 0.03F * p.h}, {0.98F * r, 0.03F * p.h}}},
              24);
  p.make.Bar(p.is.metal, {0, 0, 0.1F * p.h}, {0, 0, 0.34F * p.h}, 0.2F * r, 12);
  p.make.Lathe(p.is.hard, {},
               std::array<Vec2, 4>{{{0.5F, 0}, {0.5F, 0.06F * p.h}, {0.4F, 0.1F * p.h}, {0.12F, 0.13F * p.h}}}, 26,
               {p.w, p.d});
}

}  // namespace

std::span<const PieceMaker> SportMakers() {
  static constexpr PieceMaker kMakers[] = {{"treadmill", MakeTreadmill},
                                           {"exercise_bike", MakeExerciseBike},
                                           {"rowing_machine", MakeRowingMachine},
                                           {"weight_bench", MakeWeightBench},
                                           {"weights", MakeWeights},
                                           {"punching_bag", MakePunchingBag}};
  return kMakers;
}

}  // namespace flair::renderer
