// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/furniture/piece.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace flair::renderer {
namespace {

uint32_t Mixed(uint32_t x) {
  x ^= x >> 16;
  x *= 0x7FEB352DU;
  x ^= x >> 15;
  x *= 0x846CA68BU;
  return x ^ (x >> 16);
}

}  // namespace

bool Piece::Says(std::string_view word) const {
  const auto letter = [this](size_t at) {
    return at < words.size() && std::isalpha(static_cast<unsigned char>(words[at]));
  };
  for (size_t at = words.find(word); at != std::string::npos; at = words.find(word, at + 1)) {
    size_t end = at + word.size();
    if (end < words.size() && words[end] == 's') ++end;  // a plural
    if ((at == 0 || !letter(at - 1)) && !letter(end)) return true;
  }
  return false;
}

float Piece::Chance(int index) const {
  return static_cast<float>(Mixed(seed + 0x9E3779B9U * static_cast<uint32_t>(index + 1)) >> 8) / 16777216.0F;
}

void Piece::Shine(Vec3 at, float intensity_cd, float radius_m, Vec3 colour) {
  lights.push_back({.position = make.Placed(at), .colour = colour, .intensity_cd = intensity_cd, .radius_m = radius_m});
}

void Piece::LegsAt(const Material& material, float x, float y, float top, float half, float taper, float splay) {
  for (const float sx : {-1.0F, 1.0F}) {
    for (const float sy : {-1.0F, 1.0F}) {
      make.Taper(material, {sx * (x + splay), sy * (y + splay), 0}, {half * taper, half * taper}, {sx * x, sy * y, top},
                 {half, half});
    }
  }
}

void Piece::RoundLegsAt(const Material& material, float x, float y, float top, float radius, float splay) {
  for (const float sx : {-1.0F, 1.0F}) {
    for (const float sy : {-1.0F, 1.0F}) {
      make.Bar(material, {sx * (x + splay), sy * (y + splay), 0}, {sx * x, sy * y, top}, 0.6F * radius, radius, 10);
    }
  }
}

void Piece::Knob(Vec3 at, float radius) {
  if (radius < 1e-4F) return;
  make.In(Frame::TurnedX(at, -kPiFloat / 2), [&] {
    const std::array<Vec2, 6> profile{{{0.45F, 0}, {0.4F, 0.5F}, {0.95F, 0.9F}, {1, 1.2F}, {0.75F, 1.6F}, {0, 1.7F}}};
    std::array<Vec2, 6> scaled{};
    for (size_t i = 0; i < profile.size(); ++i) scaled[i] = {radius * profile[i].x, radius * profile[i].y};
    make.Lathe(is.metal, {}, scaled, 10);
  });
}

void Piece::Handle(Vec3 at, float length, bool upright) {
  if (length < 1e-3F) return;
  const float thick = std::min(0.006F, 0.1F * length), out = 0.028F * std::min(1.0F, length / 0.1F);
  const Vec3 along = upright ? Vec3{0, 0, length / 2} : Vec3{length / 2, 0, 0}, front{0, out, 0};
  make.Bar(is.metal, at - along + front, at + along + front, thick, 8);
  for (const float side : {-0.8F, 0.8F})
    make.Bar(is.metal, at + along * side, at + along * side + front, 0.8F * thick, 6);
}

void Piece::Panel(const Material& material, Vec2 low, Vec2 high, float y, float thickness, bool framed) {
  make.Box(material, {low.x, y, low.y}, {high.x, y + thickness, high.y}, 0.003F);
  const float width = high.x - low.x, height = high.y - low.y, rail = std::min({0.06F, 0.2F * width, 0.2F * height});
  if (!framed || rail < 0.008F) return;
  const float front = y + thickness, proud = front + 0.55F * thickness;
  make.Box(material, {low.x, front, low.y}, {low.x + rail, proud, high.y}, 0.003F);
  make.Box(material, {high.x - rail, front, low.y}, {high.x, proud, high.y}, 0.003F);
  make.Box(material, {low.x + rail, front, low.y}, {high.x - rail, proud, low.y + rail}, 0.003F);
  make.Box(material, {low.x + rail, front, high.y - rail}, {high.x - rail, proud, high.y}, 0.003F);
}

void Piece::Flame(Vec3 at, float height, float intensity_cd) {
  const float r = 0.22F * height;
  make.Lathe(stuff::FlameStuff(), at,
             std::array<Vec2, 5>{
                 {{0, 0}, {0.8F * r, 0.12F * height}, {r, 0.32F * height}, {0.45F * r, 0.68F * height}, {0, height}}},
             8);
  Shine(at + Vec3{0, 0, 0.4F * height}, intensity_cd, std::max(0.01F, r), {1, 0.66F, 0.32F});
}

void Piece::Shade(Vec3 base, float bottom_radius, float top_radius, float height, const Material& material) {
  const float wall = std::min({0.004F, 0.1F * bottom_radius, 0.1F * top_radius, 0.1F * height});
  make.Ring(material, base,
            std::array<Vec2, 4>{
                {{bottom_radius - wall, 0}, {bottom_radius, 0}, {top_radius, height}, {top_radius - wall, height}}},
            24);
}

void Piece::Book(Vec3 low, Vec3 high, int index) {
  const int tint = static_cast<int>(Chance(index) * 7);
  const float cover = std::min(0.004F, 0.15F * (high.x - low.x));
  make.Box(stuff::Book(tint), low, high, 0.15F * (high.x - low.x));
  // Pages, seen from above, stand out a little: cheaper than three covers and as telling.
  make.Box(stuff::Paper(), {low.x + cover, low.y + cover, high.z - 0.02F * (high.z - low.z)},
           {high.x - cover, high.y - 3 * cover, high.z + 0.0015F}, 0);
}

void Piece::Pot(Vec3 base, float radius, float height, const Material& material) {
  const float wall = 0.1F * radius;
  make.Lathe(material, base,
             std::array<Vec2, 8>{{{0.68F * radius, 0},
                                  {0.72F * radius, 0.02F * height},
                                  {0.95F * radius, 0.82F * height},
                                  {radius, 0.84F * height},
                                  {radius, height},
                                  {radius - wall, height},
                                  {radius - 1.2F * wall, 0.86F * height},
                                  {0, 0.86F * height}}},
             20);
  make.Cylinder(stuff::Soil(), base + Vec3{0, 0, 0.84F * height}, radius - 1.3F * wall, 0.05F * height, 0.002F, 16);
}

void Piece::Foliage(Vec3 centre, Vec3 radii, int leaves, float leaf, const Material& material) {
  constexpr float kGolden = 2.39996323F;
  for (int i = 0; i < leaves; ++i) {
    // Spread over the upper part of an ellipsoid; each leaf hangs outwards.
    const float z = 1 - 1.55F * (static_cast<float>(i) + 0.5F) / static_cast<float>(leaves);
    const float turn = kGolden * static_cast<float>(i) + Chance(i), flat = std::sqrt(std::max(0.0F, 1 - z * z));
    const Vec3 out{flat * std::cos(turn), flat * std::sin(turn), z};
    const float reach = 0.62F + 0.3F * Chance(i + 100);
    const Vec3 root = centre + Vec3{out.x * radii.x, out.y * radii.y, out.z * radii.z} * (reach - 0.35F);
    const Vec3 tip =
        centre + Vec3{out.x * radii.x, out.y * radii.y, out.z * radii.z} * reach + Vec3{0, 0, -0.25F * leaf};
    const Vec3 along = Normalized(tip - root);
    const Vec3 side = Normalized(Cross(along, std::abs(along.z) < 0.95F ? Vec3{0, 0, 1} : Vec3{1, 0, 0}));
    const Vec3 up = Cross(side, along);
    const float length = leaf * (0.8F + 0.4F * Chance(i + 200));
    const Material& tint = i % 4 == 0 ? stuff::Leaf(1) : i % 5 == 0 ? stuff::Leaf(2) : material;
    make.Sheet(
        tint, 2, 3,
        [&](float u, float v) {
          const float wide = 0.34F * length * std::sin(kPiFloat * (0.12F + 0.86F * v)), across = 2 * u - 1;
          return root + along * (length * v) + side * (wide * across) +
                 up * (0.12F * length * across * across + length * 0.3F * v * (1 - v));
        },
        0.004F * std::min(1.0F, leaf / 0.1F));
  }
}

}  // namespace flair::renderer
