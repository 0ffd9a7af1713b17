// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/gltf/pattern_image.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <vector>

#include "renderer_worker/gltf/pattern_tone.h"

namespace flair::renderer::gltf {
namespace {

// A tone's number: 16 shades of 16 mixtures.
constexpr int kLevels = 16;

struct ToneImage {
  int width_px = 0;
  int height_px = 0;
  std::string pixels;  // compressed rows, as PNG's IDAT has them
};

int LevelOf(float value) { return std::clamp(static_cast<int>(value * (kLevels - 1) + 0.5F), 0, kLevels - 1); }

// What PNG wants compressed: every row after the number of its filter, here none.
ToneImage DrawTones(Figure figure) {
  const Vec2 period = PeriodOf(figure);
  // Floors are looked at more closely than the wood of a chair.
  ToneImage image{256, 256, {}};
  if (figure == Figure::kPlanks) image.width_px = 512;
  if (figure == Figure::kWood) image.height_px = 128;
  std::string rows;
  rows.reserve(static_cast<size_t>(image.height_px) * static_cast<size_t>(image.width_px + 1));
  for (int y = 0; y < image.height_px; ++y) {
    rows.push_back(0);
    for (int x = 0; x < image.width_px; ++x) {
      const float u = (static_cast<float>(x) + 0.5F) / static_cast<float>(image.width_px) * period.x;
      const float v = (static_cast<float>(y) + 0.5F) / static_cast<float>(image.height_px) * period.y;
      const Tone tone = ToneAt(figure, u, v);
      const float shade = (tone.shade - kDarkestShade) / (kLightestShade - kDarkestShade);
      rows.push_back(static_cast<char>(LevelOf(shade) * kLevels + LevelOf(tone.mix)));
    }
  }
  uLongf size = compressBound(rows.size());
  image.pixels.resize(size);
  compress2(reinterpret_cast<Bytef*>(image.pixels.data()), &size, reinterpret_cast<const Bytef*>(rows.data()),
            rows.size(), 4);
  image.pixels.resize(size);
  return image;
}

const ToneImage& TonesOf(Figure figure) {
  static std::array<std::once_flag, kFigureCount> once;
  static std::array<ToneImage, kFigureCount> images;
  const auto index = static_cast<size_t>(figure);
  std::call_once(once[index], [&] { images[index] = DrawTones(figure); });
  return images[index];
}

void AppendNumber(std::string& bytes, uint32_t number) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<char>(number >> shift & 0xFF));
}

void AppendChunk(std::string& png, std::string_view type, std::string_view content) {
  AppendNumber(png, static_cast<uint32_t>(content.size()));
  const size_t begin = png.size();
  png.append(type).append(content);
  const auto* checked = reinterpret_cast<const Bytef*>(png.data() + begin);
  AppendNumber(png, static_cast<uint32_t>(crc32(0, checked, static_cast<uInt>(png.size() - begin))));
}

char SrgbOf(float linear) {
  const float v = std::clamp(linear, 0.0F, 1.0F);
  const float srgb = v <= 0.0031308F ? 12.92F * v : 1.055F * std::pow(v, 1 / 2.4F) - 0.055F;
  return static_cast<char>(std::lround(srgb * 255));
}

std::string PaletteOf(const Material& material) {
  std::string palette;
  for (int shade = 0; shade < kLevels; ++shade) {
    const float factor = kDarkestShade + (kLightestShade - kDarkestShade) * static_cast<float>(shade) / (kLevels - 1);
    for (int mix = 0; mix < kLevels; ++mix) {
      const float t = static_cast<float>(mix) / (kLevels - 1);
      const Vec3 colour = (material.colour * (1 - t) + material.second_colour * t) * factor;
      palette.append({SrgbOf(colour.x), SrgbOf(colour.y), SrgbOf(colour.z)});
    }
  }
  return palette;
}

}  // namespace

std::string PatternPng(const Material& material) {
  if (material.pattern == Pattern::kPlain) return {};
  const ToneImage& tones = TonesOf(FigureOf(material));
  std::string header;
  AppendNumber(header, static_cast<uint32_t>(tones.width_px));
  AppendNumber(header, static_cast<uint32_t>(tones.height_px));
  header.append({8, 3, 0, 0, 0});  // 8 bits a pixel, numbers into a palette, deflate, five filters, not interlaced
  std::string png = "\x89PNG\r\n\x1A\n";
  AppendChunk(png, "IHDR", header);
  AppendChunk(png, "PLTE", PaletteOf(material));
  AppendChunk(png, "IDAT", tones.pixels);
  AppendChunk(png, "IEND", {});
  return png;
}

}  // namespace flair::renderer::gltf
