// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "renderer_worker/furniture/classes.h"
#include "renderer_worker/furniture/piece.h"

// Chairs, stools and benches.
namespace flair::renderer {
namespace {

float SeatHeight(const Piece& p) { return RestHeightOf("chair", p.h); }

// Legs, seat rails and an upholstered or wooden seat.
void SeatOnLegs(Piece& p, float seat, float leg, bool padded) {
  const float x = p.w / 2 - 1.3F * leg, y = p.d / 2 - 1.3F * leg, board = std::min(0.03F, 0.08F * seat);
  for (const float sx : {-1.0F, 1.0F}) {
    p.make.Taper(p.is.hard, {sx * (p.w / 2 - leg), p.d / 2 - leg, 0}, {0.6F * leg, 0.6F * leg},
                 {sx * x, y, seat - board}, {leg, leg});
  }
  p.make.Box(p.is.hard, {-x, -y, seat - 2.6F * board}, {x, y, seat - board}, 0.004F);
  p.make.Box(p.is.hard, {-0.49F * p.w, -0.47F * p.d, seat - board}, {0.49F * p.w, p.d / 2, seat}, 0.008F);
  if (padded) {
    p.make.Cushion(p.is.soft, {-0.47F * p.w, -0.42F * p.d, seat - 0.004F},
                   {0.47F * p.w, 0.48F * p.d, seat + 1.5F * board}, 0.018F, 0.008F);
  }
}

// Rear legs that go on as posts and lean back.
void Posts(Piece& p, float seat, float leg, float top) {
  for (const float sx : {-1.0F, 1.0F}) {
    const float x = sx * (p.w / 2 - 1.2F * leg);
    p.make.Taper(p.is.hard, {x, -p.d / 2 + 1.5F * leg, 0}, {0.7F * leg, 0.7F * leg}, {x, -p.d / 2 + 2.4F * leg, seat},
                 {leg, leg});
    p.make.Taper(p.is.hard, {x, -p.d / 2 + 2.4F * leg, seat - 0.01F}, {leg, leg}, {x, -p.d / 2 + 0.8F * leg, top},
                 {0.75F * leg, 0.75F * leg});
  }
}

void MakeChair(Piece& p) {
  const float seat = SeatHeight(p), leg = std::min(0.019F, 0.06F * p.smaller()), above = p.h - seat;
  const bool padded = !p.Says("stone") && (p.is.soft.name.find("linen, soft") == std::string::npos ||
                                           p.Says("upholstered") || p.Says("cushion"));
  SeatOnLegs(p, seat, leg, padded || p.Says("dining"));
  Posts(p, seat, leg, p.h);
  const float back = -p.d / 2 + 1.2F * leg, x = p.w / 2 - 1.2F * leg;
  p.make.Box(p.is.hard, {-x, back - 0.8F * leg, p.h - 0.2F * above}, {x, back + 0.7F * leg, p.h - 0.01F * above},
             0.008F);
  if (p.Says("upholstered") || p.Says("velvet") || p.Says("leather")) {
    p.make.Cushion(p.is.soft, {-0.92F * x, back, seat + 0.18F * above},
                   {0.92F * x, back + 3 * leg, p.h - 0.03F * above}, 0.02F, 0.01F);
    return;
  }
  p.make.Box(p.is.hard, {-x, back + 0.3F * leg, seat + 0.16F * above}, {x, back + 1.5F * leg, seat + 0.25F * above},
             0.004F);
  for (int i = 0; i < 4; ++i) {  // slats
    const float at = x * (-0.6F + 0.4F * static_cast<float>(i)), half = 0.09F * x;
    p.make.Taper(p.is.hard, {at, back + 0.9F * leg, seat + 0.24F * above}, {half, 0.35F * leg},
                 {at, back, p.h - 0.19F * above}, {half, 0.35F * leg});
  }
}

void MakeOfficeChair(Piece& p) {
  const float seat = RestHeightOf("office_chair", p.h) / 1.04F, foot = 0.5F * p.smaller(),
              wheel = std::min(0.03F, 0.08F * seat);
  for (int i = 0; i < 5; ++i) {
    const float turn = kPiFloat / 2 + 2 * kPiFloat / 5 * static_cast<float>(i);
    const Vec3 end{(foot - wheel) * std::cos(turn), (foot - wheel) * std::sin(turn), 2.1F * wheel};
    p.make.Bar(p.is.metal, {0, 0, 3.4F * wheel}, end, 0.75F * wheel, 0.5F * wheel, 8);
    p.make.In({end - Vec3{0, 0, 1.1F * wheel},
               {std::cos(turn), std::sin(turn), 0},
               {0, 0, 1},
               {std::sin(turn), -std::cos(turn), 0}},
              [&] {
                for (const float z : {-0.9F, 0.2F})
                  p.make.Cylinder(stuff::Rubber(), {0, 0, z * wheel}, wheel, 0.7F * wheel, 0.004F, 12);
              });
  }
  p.make.Bar(p.is.metal, {0, 0, 2.8F * wheel}, {0, 0, 0.88F * seat}, 0.028F * std::min(1.0F, p.w / 0.5F), 12);
  p.make.Box(stuff::Black(), {-0.18F * p.w, -0.2F * p.d, 0.84F * seat}, {0.18F * p.w, 0.2F * p.d, 0.9F * seat}, 0.01F);
  p.make.Cushion(p.is.soft, {-0.4F * p.w, -0.34F * p.d, 0.88F * seat}, {0.4F * p.w, 0.42F * p.d, 1.04F * seat}, 0.03F,
                 0.012F);
  const float back = -0.36F * p.d, above = p.h - seat;
  p.make.Box(stuff::Black(), {-0.06F * p.w, back - 0.03F * p.d, 0.86F * seat},
             {0.06F * p.w, back + 0.02F * p.d, seat + 0.5F * above}, 0.01F);
  p.make.In(Frame::TurnedX({0, back, seat + 0.12F * above}, 0.1F), [&] {
    p.make.Sheet(
        p.is.soft, 8, 6,
        [&](float u, float v) {
          const float x = 2 * u - 1, wide = p.w * (0.4F - 0.06F * v * v * v);
          return Vec3{-wide * x, 0.09F * p.d * x * x + 0.05F * p.d * std::sin(kPiFloat * v), 0.86F * above * v};
        },
        0.045F * std::min(1.0F, p.d / 0.5F));
  });
  const float arm = seat + 0.28F * above;
  for (const float side : {-1.0F, 1.0F}) {
    const float x = side * 0.46F * p.w;
    p.make.Bar(stuff::Black(), {side * 0.3F * p.w, 0, 0.88F * seat}, {x, 0, 0.92F * seat}, 0.014F, 8);
    p.make.Bar(stuff::Black(), {x, 0, 0.9F * seat}, {x, 0, arm}, 0.014F, 8);
    p.make.Cushion(stuff::Black(), {x - 0.04F * p.w, -0.2F * p.d, arm}, {x + 0.04F * p.w, 0.24F * p.d, arm + 0.03F},
                   0.012F);
  }
}

void MakeRockingChair(Piece& p) {
  const float seat = SeatHeight(p), leg = std::min(0.02F, 0.05F * p.smaller()), above = p.h - seat;
  for (const float side : {-1.0F, 1.0F}) {
    const float x = side * (p.w / 2 - leg);
    std::vector<Vec3> runner;
    for (int i = 0; i <= 12; ++i) {
      const float y = -1 + static_cast<float>(i) / 6;
      runner.push_back({x, 0.5F * p.d * y, leg + 0.16F * seat * y * y});
    }
    p.make.Tube(p.is.hard, runner, std::array{leg}, 8);
    for (const float y : {-0.28F, 0.3F})
      p.make.Bar(p.is.hard, {x, y * p.d, 0.05F * seat}, {x, 0.92F * y * p.d, seat + 0.34F * above}, leg, 8);
    p.make.Box(p.is.hard, {x - 1.6F * leg, -0.3F * p.d, seat + 0.32F * above},
               {x + leg, 0.4F * p.d, seat + 0.37F * above}, 0.006F);
  }
  p.make.Box(p.is.hard, {-p.w / 2 + leg, -0.3F * p.d, 0.9F * seat}, {p.w / 2 - leg, 0.38F * p.d, 0.96F * seat}, 0.01F);
  p.make.Cushion(p.is.soft, {-0.42F * p.w, -0.28F * p.d, 0.95F * seat}, {0.42F * p.w, 0.37F * p.d, 1.08F * seat},
                 0.025F, 0.01F);
  p.make.In(Frame::TurnedX({0, -0.3F * p.d, 0.92F * seat}, 0.2F), [&] {
    for (int i = 0; i < 7; ++i) {
      const float x = p.w * (-0.39F + 0.13F * static_cast<float>(i));
      p.make.Bar(p.is.hard, {x, 0, 0}, {x, 0, above}, i == 0 || i == 6 ? leg : 0.6F * leg, 8);
    }
    p.make.Box(p.is.hard, {-0.42F * p.w, -leg, 0.94F * above}, {0.42F * p.w, leg, 1.1F * above}, 0.01F);
  });
}

void MakeStool(Piece& p) {
  const float leg = std::min(0.018F, 0.06F * p.smaller()), top = std::min(0.05F, 0.12F * p.h);
  const bool stump = p.is.hard.name.starts_with("bark") || p.Says("stump") || p.Says("log");
  if (stump) {
    p.make.Lathe(p.is.hard, {},
                 std::array<Vec2, 4>{{{0.5F, 0}, {0.45F, 0.2F * p.h}, {0.44F, 0.9F * p.h}, {0.46F, p.h - 0.01F}}}, 18,
                 {p.w, p.d});
    p.make.Lathe(BaseMaterialOf("pine").look, {0, 0, p.h - 0.012F}, std::array<Vec2, 2>{{{0.43F, 0}, {0.43F, 0.012F}}},
                 18, {p.w, p.d});
    return;
  }
  p.RoundLegsAt(p.is.hard, 0.26F * p.w, 0.26F * p.d, p.h - top, 1.2F * leg, 0.1F * p.smaller());
  const float ring = 0.3F * p.h;
  for (const float side : {-1.0F, 1.0F}) {
    p.make.Bar(p.is.hard, {-0.33F * p.w, side * 0.33F * p.d, ring}, {0.33F * p.w, side * 0.33F * p.d, ring}, 0.7F * leg,
               8);
    p.make.Bar(p.is.hard, {side * 0.33F * p.w, -0.33F * p.d, ring}, {side * 0.33F * p.w, 0.33F * p.d, ring}, 0.7F * leg,
               8);
  }
  p.make.Lathe(p.is.hard, {0, 0, p.h - top},
               std::array<Vec2, 4>{{{0.46F, 0}, {0.5F, 0.3F * top}, {0.5F, 0.6F * top}, {0.47F, 0.7F * top}}}, 24,
               {p.w, p.d});
  p.make.Lathe(p.is.soft, {0, 0, p.h - 0.35F * top},
               std::array<Vec2, 4>{{{0.47F, 0}, {0.47F, 0.15F * top}, {0.4F, 0.3F * top}, {0.2F, 0.35F * top}}}, 24,
               {p.w, p.d});
}

void MakeBench(Piece& p) {
  const float seat = RestHeightOf("bench", p.h), leg = std::min(0.03F, 0.08F * p.smaller()),
              board = std::min(0.05F, 0.12F * seat);
  if (p.is.hard.name.find("stone") != std::string::npos || p.is.hard.name.find("marble") != std::string::npos) {
    for (const float side : {-1.0F, 1.0F}) {
      p.make.Taper(p.is.hard, {side * 0.36F * p.w, 0, 0}, {0.07F * p.w, 0.44F * p.d},
                   {side * 0.36F * p.w, 0, seat - board}, {0.05F * p.w, 0.36F * p.d});
    }
    p.make.Box(p.is.hard, {-p.w / 2, -p.d / 2, seat - 1.3F * board}, {p.w / 2, p.d / 2, seat}, 0.015F);
  } else if (p.Says("storage") || p.Says("blanket")) {
    p.make.Box(p.is.hard, {-p.w / 2, -p.d / 2, 0}, {p.w / 2, p.d / 2 - 0.02F * p.d, seat - 2 * board}, 0.006F);
    for (const float side : {-1.0F, 1.0F}) {
      p.Panel(p.is.hard, {side > 0 ? 0.01F * p.w : -0.48F * p.w, 0.08F * seat},
              {side > 0 ? 0.48F * p.w : -0.01F * p.w, seat - 2.3F * board}, 0.48F * p.d - 0.005F, 0.012F, true);
    }
    p.make.Cushion(p.is.soft, {-p.w / 2, -p.d / 2, seat - 2 * board}, {p.w / 2, p.d / 2, seat}, 0.03F, 0.01F);
  } else {
    p.LegsAt(p.is.hard, p.w / 2 - 0.06F * p.w - leg, p.d / 2 - 2 * leg, seat - board, leg, 0.7F, 0.8F * leg);
    p.make.Box(p.is.hard, {-0.42F * p.w, -0.3F * p.d, seat - 2.4F * board}, {0.42F * p.w, 0.3F * p.d, seat - board},
               0.004F);
    p.make.Box(p.is.hard, {-p.w / 2, -p.d / 2, seat - board}, {p.w / 2, p.d / 2, seat - 0.3F * board}, 0.01F);
    p.make.Cushion(p.is.soft, {-0.49F * p.w, -0.48F * p.d, seat - 0.35F * board},
                   {0.49F * p.w, 0.48F * p.d, seat + 0.4F * board}, 0.02F, 0.008F);
  }
  if (seat == p.h) return;
  for (const float x : {-0.46F, 0.0F, 0.46F})
    p.make.Taper(p.is.hard, {x * p.w, -p.d / 2 + 2 * leg, seat - board}, {leg, leg}, {x * p.w, -p.d / 2 + leg, p.h},
                 {0.7F * leg, 0.7F * leg});
  for (const float z : {0.45F, 0.8F}) {
    p.make.Box(p.is.hard, {-p.w / 2, -p.d / 2 + leg, seat + (z - 0.1F) * (p.h - seat)},
               {p.w / 2, -p.d / 2 + 2.2F * leg, seat + (z + 0.16F) * (p.h - seat)}, 0.008F);
  }
}

void MakeThrone(Piece& p) {
  const float seat = RestHeightOf("throne", p.h), post = std::min(0.05F, 0.08F * p.w), above = p.h - seat;
  p.make.Box(p.is.hard, {-p.w / 2, -p.d / 2, 0}, {p.w / 2, p.d / 2, 0.18F * seat}, 0.012F);
  p.make.Box(p.is.hard, {-0.45F * p.w, -0.46F * p.d, 0.17F * seat}, {0.45F * p.w, 0.44F * p.d, 0.82F * seat}, 0.01F);
  p.make.Cushion(p.is.soft, {-0.4F * p.w, -0.38F * p.d, 0.8F * seat}, {0.4F * p.w, 0.45F * p.d, seat}, 0.04F, 0.015F);
  const std::array<Vec2, 5> gable{{{-0.44F * p.w, 0},
                                   {0.44F * p.w, 0},
                                   {0.44F * p.w, 0.7F * above},
                                   {0, 0.97F * above},
                                   {-0.44F * p.w, 0.7F * above}}};
  p.make.In({{0, -0.36F * p.d, 0.8F * seat}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}}, [&] {
    p.make.Slab(p.is.hard, gable, 0, 0.1F * p.d, 0.012F);
    std::array<Vec2, 5> padded = gable;
    for (Vec2& point : padded) point = {0.74F * point.x, 0.1F * above + 0.78F * point.y};
    p.make.Slab(p.is.soft, padded, -0.035F, 0.02F, 0.03F);
  });
  for (const float side : {-1.0F, 1.0F}) {
    const float x = side * (p.w / 2 - post);
    p.make.Box(p.is.hard, {x - post, -p.d / 2, 0.15F * seat}, {x + post, -p.d / 2 + 2 * post, seat + 0.8F * above},
               0.01F);
    p.make.Ellipsoid(p.is.metal, {x, -p.d / 2 + post, seat + 0.8F * above + post}, {post, post, 1.3F * post}, 12, 8);
    p.make.Box(p.is.hard, {x - post, p.d / 2 - 2.4F * post, 0.15F * seat},
               {x + post, p.d / 2 - 0.2F * post, seat + 0.26F * above}, 0.008F);
    p.make.Box(p.is.hard, {x - 1.1F * post, -0.45F * p.d, seat + 0.24F * above},
               {x + 1.1F * post, p.d / 2, seat + 0.32F * above}, 0.014F);
    p.make.Ellipsoid(p.is.metal, {x, p.d / 2 - post, seat + 0.34F * above}, {post, post, post}, 12, 6);
  }
  p.make.Ellipsoid(p.is.metal, {0, -0.4F * p.d, p.h - 0.04F * above}, {0.06F * p.w, 0.04F * p.d, 0.06F * above}, 12, 8);
}

}  // namespace

std::span<const PieceMaker> ChairMakers() {
  static constexpr PieceMaker kMakers[] = {{"chair", MakeChair},
                                           {"office_chair", MakeOfficeChair},
                                           {"rocking_chair", MakeRockingChair},
                                           {"stool", MakeStool},
                                           {"bench", MakeBench},
                                           {"throne", MakeThrone}};
  return kMakers;
}

}  // namespace flair::renderer
