// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "renderer_worker/furniture/classes.h"
#include "renderer_worker/furniture/piece.h"

// Kitchens and what washes.
namespace flair::renderer {
namespace {

struct Unit {
  float top, plinth, front, board;  // heights of worktop's underside and plinth, the carcass' front
};

// A base unit with doors and a drawer above each, without its worktop.
Unit BaseUnit(Piece& p, float height) {
  const float thick = std::min(0.04F, 0.08F * height);
  const Unit u{height - thick, std::min(0.1F, 0.12F * height), p.d / 2 - std::min(0.06F, 0.12F * p.d), thick};
  p.make.Box(p.is.hard, {-0.497F * p.w, -p.d / 2, u.plinth}, {0.497F * p.w, u.front, u.top}, 0.002F);
  p.make.Box(stuff::Black(), {-0.49F * p.w, -p.d / 2, 0}, {0.49F * p.w, u.front - 0.05F * p.d, u.plinth}, 0);
  const int count = std::clamp(static_cast<int>(std::lround(p.w / 0.6F)), 1, 10);
  const float wide = p.w * 0.994F / static_cast<float>(count), gap = std::min(0.003F, 0.02F * wide),
              split = u.top - 0.2F * (u.top - u.plinth);
  for (int i = 0; i < count; ++i) {
    const float from = -0.497F * p.w + wide * static_cast<float>(i) + gap, to = from + wide - 2 * gap;
    p.Panel(p.is.hard, {from, u.plinth + gap}, {to, split - gap}, u.front, 0.018F, !p.Says("modern"));
    p.Panel(p.is.hard, {from, split + gap}, {to, u.top - gap}, u.front, 0.018F);
    p.Handle({(from + to) / 2, u.front + 0.018F, (split + u.top) / 2}, std::min(0.14F, 0.4F * wide), false);
    p.Handle(
        {(i % 2 == 0 ? to - 0.06F * wide : from + 0.06F * wide), u.front + 0.018F, split - 0.16F * (split - u.plinth)},
        std::min(0.14F, 0.4F * wide), true);
  }
  return u;
}

const Material& Worktop(const Piece& p) {
  static const Material kStone = [] {
    Material m = BaseMaterialOf("stone").look;
    m.name = "worktop";
    m.colour = LinearHex(0x6F6C68), m.second_colour = LinearHex(0x5C5956);
    m.roughness = 0.35F;
    return m;
  }();
  return p.is.hard.pattern == Pattern::kStone ? p.is.hard : kStone;
}

void Tap(Piece& p, Vec3 at, float height, float reach) {
  const float r = std::min(0.012F, 0.06F * height);
  p.make.Cylinder(stuff::Steel(), at, 2.2F * r, 0.1F * height, 0.002F, 14);
  std::vector<Vec3> path{at, at + Vec3{0, 0, 0.6F * height}};
  for (int i = 1; i <= 8; ++i) {
    const float turn = kPiFloat * static_cast<float>(i) / 8;
    path.push_back(at + Vec3{0, reach / 2 * (1 - std::cos(turn)), (0.62F + 0.35F * std::sin(turn)) * height});
  }
  p.make.Tube(stuff::Steel(), path, std::array{r}, 8);
}

// A rectangular basin sunk into a worktop: rim and inner faces.
void SunkBasin(Piece& p, Vec2 low, Vec2 high, float top, float deep, const Material& material) {
  const float wall = std::min(0.012F, 0.05F * (high.x - low.x));
  p.make.Box(material, {low.x, low.y, top - deep}, {high.x, high.y, top - deep + wall}, 0.002F);
  for (const float x : {low.x, high.x - wall})
    p.make.Box(material, {x, low.y, top - deep}, {x + wall, high.y, top + 0.004F}, 0.003F);
  for (const float y : {low.y, high.y - wall})
    p.make.Box(material, {low.x, y, top - deep}, {high.x, y + wall, top + 0.004F}, 0.003F);
  p.make.Cylinder(stuff::Black(), {(low.x + high.x) / 2, (low.y + high.y) / 2, top - deep + wall - 0.001F},
                  0.1F * (high.y - low.y), 0.003F, 0.001F, 14);
}

// A worktop with a rectangular hole in it.
void WorktopAround(Piece& p, Vec2 low, Vec2 high, float bottom, float top) {
  const Material& m = Worktop(p);
  p.make.Box(m, {-p.w / 2, -p.d / 2, bottom}, {low.x, p.d / 2, top}, 0.005F);
  p.make.Box(m, {high.x, -p.d / 2, bottom}, {p.w / 2, p.d / 2, top}, 0.005F);
  p.make.Box(m, {low.x, -p.d / 2, bottom}, {high.x, low.y, top}, 0.005F);
  p.make.Box(m, {low.x, high.y, bottom}, {high.x, p.d / 2, top}, 0.005F);
}

void Rings(Piece& p, float top, float width, float depth) {
  const int count = width > 0.75F ? 5 : width > 0.4F ? 4 : 2;
  for (int i = 0; i < count; ++i) {
    const float x = i == 4 ? 0 : (i % 2 == 0 ? -0.25F : 0.25F) * width,
                y = i == 4 ? 0 : (i < 2 ? -0.22F : 0.22F) * depth;
    const float r = (i % 3 == 0 ? 0.15F : 0.12F) * std::min(width, 1.4F * depth) * (count == 5 ? 0.75F : 1);
    p.make.Cylinder(stuff::Steel(), {x, y, top - 0.001F}, r, 0.006F, 0.002F, 24);
    p.make.Cylinder(stuff::Black(), {x, y, top}, 0.84F * r, 0.008F, 0.002F, 24);
  }
}

void OvenFront(Piece& p, float bottom, float top, float front) {
  const float high = top - bottom, panel = 0.16F * high;
  p.Panel(stuff::Black(), {-0.47F * p.w, bottom}, {0.47F * p.w, top - panel}, front, 0.02F);
  p.make.Box(stuff::Screen(), {-0.36F * p.w, front + 0.018F, bottom + 0.15F * high},
             {0.36F * p.w, front + 0.024F, bottom + 0.6F * high}, 0.002F);
  p.make.Bar(stuff::Steel(), {-0.4F * p.w, front + 0.045F, top - panel - 0.06F * high},
             {0.4F * p.w, front + 0.045F, top - panel - 0.06F * high}, 0.009F, 8);
  for (const float x : {-0.36F, 0.36F})
    p.make.Bar(stuff::Steel(), {x * p.w, front, top - panel - 0.06F * high},
               {x * p.w, front + 0.045F, top - panel - 0.06F * high}, 0.006F, 6);
  for (int i = 0; i < 5; ++i)
    p.Knob({p.w * (-0.32F + 0.16F * static_cast<float>(i)), front + 0.004F, top - 0.5F * panel},
           std::min(0.016F, 0.25F * panel));
}

void MakeCounter(Piece& p) {
  const Unit u = BaseUnit(p, p.h);
  p.make.Box(Worktop(p), {-p.w / 2, -p.d / 2, u.top}, {p.w / 2, p.d / 2, p.h}, 0.006F);
}

void MakeKitchenIsland(Piece& p) {
  const Unit u = BaseUnit(p, p.h);
  p.make.Box(Worktop(p), {-p.w / 2, -p.d / 2, u.top}, {p.w / 2, p.d / 2, p.h}, 0.008F);
}

void MakeSink(Piece& p) {
  const float top = RestHeightOf("sink", p.h), tap = p.h - top;
  const Unit u = BaseUnit(p, top);
  const Vec2 low{-std::min(0.3F, 0.38F * p.w), -0.24F * p.d}, high{std::min(0.3F, 0.38F * p.w), 0.34F * p.d};
  WorktopAround(p, low, high, u.top, top);
  SunkBasin(p, low, high, top, 0.2F * top, p.Says("stone") || p.Says("ceramic") ? p.is.hard : stuff::Steel());
  Tap(p, {0, -0.34F * p.d, top}, tap, 0.3F * p.d);
}

void MakeHob(Piece& p) {
  const float front = p.d / 2 - 0.05F * p.d, top = p.h - 0.008F;
  p.make.Box(p.is.hard, {-0.495F * p.w, -p.d / 2, 0.06F * p.h}, {0.495F * p.w, front, top - 0.03F * p.h}, 0.003F);
  p.make.Box(stuff::Black(), {-0.47F * p.w, -p.d / 2, 0}, {0.47F * p.w, front - 0.05F * p.d, 0.07F * p.h}, 0);
  p.make.Box(p.is.hard, {-p.w / 2, -p.d / 2, top - 0.035F * p.h}, {p.w / 2, p.d / 2, top - 0.012F}, 0.004F);
  p.make.Box(stuff::Screen(), {-0.48F * p.w, -0.46F * p.d, top - 0.02F}, {0.48F * p.w, 0.46F * p.d, top}, 0.002F);
  Rings(p, top, 0.96F * p.w, 0.92F * p.d);
  OvenFront(p, 0.1F * p.h, top - 0.05F * p.h, front);
}

void MakeFridge(Piece& p) {
  const float front = p.d / 2 - std::min(0.1F, 0.2F * p.d), split = p.w > 0.85F ? 0 : 0.64F * p.h,
              door = 0.6F * (p.d / 2 - front);
  p.make.Box(p.is.hard, {-p.w / 2, -p.d / 2, 0.03F * p.h}, {p.w / 2, front, p.h}, 0.01F);
  p.make.Box(stuff::Black(), {-0.48F * p.w, -0.48F * p.d, 0}, {0.48F * p.w, 0.9F * front, 0.04F * p.h}, 0);
  const float z = 0.04F * p.h;
  const auto bar = [&](float x, float from, float to) {
    p.make.Bar(stuff::Steel(), {x, p.d / 2 - 0.012F, from}, {x, p.d / 2 - 0.012F, to}, 0.012F, 10);
    for (const float at : {from, to})
      p.make.Bar(stuff::Steel(), {x, front + 0.5F * door, at}, {x, p.d / 2 - 0.012F, at}, 0.009F, 8);
  };
  if (split == 0) {  // two doors side by side
    for (const float side : {-1.0F, 1.0F}) {
      p.make.Box(p.is.hard, {side * 0.003F, front, z}, {side * p.w / 2, front + door, p.h}, 0.012F);
      bar(side * 0.06F * p.w, 0.4F * p.h, 0.72F * p.h);
    }
    p.make.Box(stuff::Screen(), {-0.36F * p.w, front, 0.52F * p.h}, {-0.16F * p.w, front + 1.03F * door, 0.7F * p.h},
               0.003F);
    return;
  }
  p.make.Box(p.is.hard, {-p.w / 2, front, z}, {p.w / 2, front + door, split - 0.003F}, 0.012F);
  p.make.Box(p.is.hard, {-p.w / 2, front, split + 0.003F}, {p.w / 2, front + door, p.h}, 0.012F);
  bar(0.4F * p.w, 0.34F * p.h, 0.58F * p.h);
  bar(0.4F * p.w, 0.7F * p.h, 0.86F * p.h);
}

void MakeWashingMachine(Piece& p) {
  const float front = p.d / 2 - std::min(0.05F, 0.09F * p.d), panel = 0.16F * p.h,
              r = std::min(0.3F * p.w, 0.27F * p.h);
  p.make.Box(p.is.hard, {-p.w / 2, -p.d / 2, 0.02F * p.h}, {p.w / 2, front, p.h}, 0.012F);
  p.make.Box(stuff::Black(), {-0.48F * p.w, -0.48F * p.d, 0}, {0.48F * p.w, 0.94F * front, 0.03F * p.h}, 0);
  p.make.Box(stuff::White(), {-0.5F * p.w, front - 0.01F, p.h - panel}, {0.5F * p.w, front + 0.01F, p.h - 0.01F * p.h},
             0.004F);
  p.make.Box(stuff::Screen(), {0.12F * p.w, front, p.h - 0.75F * panel},
             {0.42F * p.w, front + 0.013F, p.h - 0.3F * panel}, 0.001F);
  p.Knob({-0.05F * p.w, front + 0.008F, p.h - 0.5F * panel}, 0.2F * panel);
  p.make.In({{0, front, 0.44F * p.h}, {-1, 0, 0}, {0, 0, 1}, {0, 1, 0}}, [&] {
    p.make.Ring(stuff::Steel(), {},
                std::array<Vec2, 5>{{{0.78F * r, 0}, {r, 0}, {r, 0.025F}, {0.92F * r, 0.045F}, {0.78F * r, 0.03F}}},
                32);
    p.make.Lathe(stuff::Screen(), {},
                 std::array<Vec2, 4>{{{0.8F * r, 0}, {0.78F * r, 0.02F}, {0.5F * r, 0.035F}, {0, 0.04F}}}, 28);
  });
}

void MakeDishwasher(Piece& p) {
  const float front = p.d / 2 - std::min(0.06F, 0.12F * p.d), panel = 0.15F * p.h;
  p.make.Box(p.is.hard, {-p.w / 2, -p.d / 2, 0.1F * p.h}, {p.w / 2, front, p.h}, 0.008F);
  p.make.Box(stuff::Black(), {-0.48F * p.w, -0.48F * p.d, 0}, {0.48F * p.w, 0.9F * front, 0.11F * p.h}, 0);
  p.Panel(p.is.hard, {-0.49F * p.w, 0.12F * p.h}, {0.49F * p.w, p.h - panel}, front, 0.02F);
  p.Panel(stuff::Black(), {-0.49F * p.w, p.h - panel + 0.004F}, {0.49F * p.w, p.h - 0.01F * p.h}, front, 0.02F);
  p.make.Bar(stuff::Steel(), {-0.38F * p.w, p.d / 2 - 0.01F, p.h - panel - 0.06F * p.h},
             {0.38F * p.w, p.d / 2 - 0.01F, p.h - panel - 0.06F * p.h}, 0.01F, 8);
  for (const float x : {-0.35F, 0.35F})
    p.make.Bar(stuff::Steel(), {x * p.w, front, p.h - panel - 0.06F * p.h},
               {x * p.w, p.d / 2 - 0.01F, p.h - panel - 0.06F * p.h}, 0.007F, 6);
}

void MakeSmallAppliance(Piece& p) {
  const Material& body = p.is.hard;
  if (p.Says("kettle") || p.Says("coffee")) {
    p.make.Lathe(body, {0, 0, 0},
                 std::array<Vec2, 7>{{{0.44F, 0},
                                      {0.46F, 0.06F * p.h},
                                      {0.44F, 0.12F * p.h},
                                      {0.4F, 0.5F * p.h},
                                      {0.3F, 0.78F * p.h},
                                      {0.12F, 0.88F * p.h},
                                      {0, 0.88F * p.h}}},
                 20, {p.w * 0.86F, p.d});
    p.make.Ellipsoid(stuff::Black(), {0, 0, 0.93F * p.h}, {0.06F * p.w, 0.06F * p.w, 0.07F * p.h}, 10, 6);
    p.make.Tube(stuff::Black(),
                std::array<Vec3, 4>{{{-0.3F * p.w, 0, 0.75F * p.h},
                                     {-0.5F * p.w, 0, 0.72F * p.h},
                                     {-0.5F * p.w, 0, 0.3F * p.h},
                                     {-0.34F * p.w, 0, 0.2F * p.h}}},
                std::array{0.03F * p.w}, 8);
    p.make.Bar(body, {0.3F * p.w, 0, 0.45F * p.h}, {0.48F * p.w, 0, 0.74F * p.h}, 0.08F * p.w, 0.04F * p.w, 10);
    return;
  }
  p.make.Box(body, {-p.w / 2, -p.d / 2, 0.04F * p.h}, {p.w / 2, 0.47F * p.d, p.h}, 0.012F);
  p.make.Box(stuff::Black(), {-0.44F * p.w, -0.44F * p.d, 0}, {0.44F * p.w, 0.42F * p.d, 0.05F * p.h}, 0.002F);
  p.make.Box(stuff::Screen(), {-0.45F * p.w, 0.46F * p.d, 0.14F * p.h}, {0.2F * p.w, 0.485F * p.d, 0.9F * p.h}, 0.003F);
  for (const float z : {0.3F, 0.6F}) p.Knob({0.35F * p.w, 0.465F * p.d, z * p.h}, std::min(0.07F * p.w, 0.1F * p.h));
  p.make.Box(stuff::Lit(), {0.26F * p.w, 0.465F * p.d, 0.76F * p.h}, {0.44F * p.w, 0.476F * p.d, 0.87F * p.h}, 0);
}

void MakeRangeHood(Piece& p) {
  p.make.Box(p.is.hard, {-p.w / 2, -p.d / 2, 0}, {p.w / 2, p.d / 2, 0.1F * p.h}, 0.006F);
  p.make.Taper(p.is.hard, {0, 0, 0.1F * p.h}, {0.49F * p.w, 0.49F * p.d}, {0, -0.18F * p.d, 0.55F * p.h},
               {0.16F * p.w, 0.3F * p.d});
  p.make.Box(p.is.hard, {-0.15F * p.w, -0.5F * p.d, 0.54F * p.h}, {0.15F * p.w, 0.1F * p.d, p.h}, 0.004F);
  p.make.Box(stuff::Bulb(), {-0.3F * p.w, -0.1F * p.d, -0.002F}, {0.3F * p.w, 0.1F * p.d, 0.004F}, 0);
}

}  // namespace

std::span<const PieceMaker> KitchenMakers() {
  static constexpr PieceMaker kMakers[] = {{"counter", MakeCounter},
                                           {"kitchen_island", MakeKitchenIsland},
                                           {"sink", MakeSink},
                                           {"hob", MakeHob},
                                           {"fridge", MakeFridge},
                                           {"washing_machine", MakeWashingMachine},
                                           {"dishwasher", MakeDishwasher},
                                           {"small_appliance", MakeSmallAppliance},
                                           {"range_hood", MakeRangeHood}};
  return kMakers;
}

}  // namespace flair::renderer
