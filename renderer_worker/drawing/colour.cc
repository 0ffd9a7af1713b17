// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/drawing/colour.h"

#include <algorithm>
#include <cmath>

namespace flair::renderer {
namespace {

double ToLinear(double channel) {
  return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double FromLinear(double channel) {
  return channel <= 0.0031308 ? channel * 12.92 : 1.055 * std::pow(channel, 1 / 2.4) - 0.055;
}

// Linear sRGB of an OKLCH colour, not clamped. Matrices: B. Ottosson, "A perceptual color space for image processing".
Rgb LinearOf(const Oklch& colour) {
  const double a = colour.chroma * std::cos(colour.hue_rad);
  const double b = colour.chroma * std::sin(colour.hue_rad);
  const double l = std::pow(colour.lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
  const double m = std::pow(colour.lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
  const double s = std::pow(colour.lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
  return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
          -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
          -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

bool Exists(const Rgb& linear) {
  const auto inside = [](double channel) { return channel > -1e-4 && channel < 1.0001; };
  return inside(linear.red) && inside(linear.green) && inside(linear.blue);
}

}  // namespace

Rgb Hex(unsigned value) { return {((value >> 16) & 255) / 255.0, ((value >> 8) & 255) / 255.0, (value & 255) / 255.0}; }

Rgb FromLinear(const Vec3& linear) { return {FromLinear(linear.x), FromLinear(linear.y), FromLinear(linear.z)}; }

Rgb FromProto(const v1::Colour& colour) {
  const auto channel = [](int value) { return std::clamp(value, 0, 255) / 255.0; };
  return {channel(colour.red()), channel(colour.green()), channel(colour.blue())};
}

Rgb Mix(const Rgb& from, const Rgb& to, double share) {
  const auto channel = [share](double a, double b) { return a + (b - a) * share; };
  return {channel(from.red, to.red), channel(from.green, to.green), channel(from.blue, to.blue)};
}

Oklch ToOklch(const Rgb& colour) {
  const double r = ToLinear(colour.red), g = ToLinear(colour.green), b = ToLinear(colour.blue);
  const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  const double lab_a = 1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s;
  const double lab_b = 0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s;
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s, std::hypot(lab_a, lab_b), std::atan2(lab_b, lab_a)};
}

Rgb FromOklch(const Oklch& colour) {
  Oklch nearest = colour;
  Rgb linear = LinearOf(nearest);
  for (int step = 0; step < 40 && !Exists(linear); ++step) {
    nearest.chroma *= 0.9;
    linear = LinearOf(nearest);
  }
  const auto channel = [](double value) { return std::clamp(FromLinear(std::clamp(value, 0.0, 1.0)), 0.0, 1.0); };
  return {channel(linear.red), channel(linear.green), channel(linear.blue)};
}

Rgb ZoneTint(int index) { return FromOklch({0.80, 0.075, 1.0 + 2.399963 * index}); }

Rgb SoftenForPrint(const Rgb& colour) {
  Oklch soft = ToOklch(colour);
  soft.lightness = 0.605 + 0.03 * soft.lightness + 0.34 * std::pow(soft.lightness, 1.5);
  soft.chroma = std::min(0.72 * soft.chroma, 0.10);
  return FromOklch(soft);
}

Rgb TintForPrint(const Rgb& colour) {
  Oklch tint = ToOklch(colour);
  tint.lightness = 0.902 + 0.05 * tint.lightness;
  tint.chroma = std::min(0.4 * tint.chroma, 0.034);
  return FromOklch(tint);
}

Rgb LineColourFor(const Rgb& fill) {
  Oklch line = ToOklch(fill);
  line.lightness = 0.34;
  line.chroma = std::min(0.9 * line.chroma, 0.05);
  return FromOklch(line);
}

}  // namespace flair::renderer
