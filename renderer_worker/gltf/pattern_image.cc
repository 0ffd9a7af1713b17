// SPDX-License-Identifier: GPL-3.0-or-later
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <mutex>

#include "renderer_worker/gltf/mesh_book.h"

namespace flair::renderer::gltf {
namespace {

static_assert(static_cast<int>(Pattern::kWallpaper) == static_cast<int>(Figure::kWallpaper));

// [0, 1), the same for the same cell.
float Random(int x, int y, int salt) {
  uint32_t h = static_cast<uint32_t>(x) * 0x9E3779B1U ^ static_cast<uint32_t>(y) * 0x85EBCA77U ^
               static_cast<uint32_t>(salt) * 0xC2B2AE3DU;
  h ^= h >> 15;
  h *= 0x2C1B3C6DU;
  h ^= h >> 12;
  h *= 0x297A2D39U;
  h ^= h >> 15;
  return static_cast<float>(h >> 8) / 16777216.0F;
}

int Wrapped(int i, int period) { return ((i % period) + period) % period; }

float Smooth(float t) { return t * t * (3 - 2 * t); }

// Value noise in [0, 1] that repeats after period_x by period_y cells; x and y not negative.
float Noise(float x, float y, int period_x, int period_y, int salt) {
  int x0 = static_cast<int>(x);
  int y0 = static_cast<int>(y);
  const float tx = Smooth(x - static_cast<float>(x0));
  const float ty = Smooth(y - static_cast<float>(y0));
  if (x0 >= period_x) x0 %= period_x;
  if (y0 >= period_y) y0 %= period_y;
  const int x1 = x0 + 1 == period_x ? 0 : x0 + 1;
  const int y1 = y0 + 1 == period_y ? 0 : y0 + 1;
  const float low = Random(x0, y0, salt) * (1 - tx) + Random(x1, y0, salt) * tx;
  const float high = Random(x0, y1, salt) * (1 - tx) + Random(x1, y1, salt) * tx;
  return low * (1 - ty) + high * ty;
}

// 1 on the edge of a cell of `extent`, 0 from `width` inwards on.
float Joint(float at, float extent, float width) {
  const float distance = std::min(at, extent - at);
  return std::clamp(1.5F - distance / width, 0.0F, 1.0F);
}

// Fibres along u, `length` units before they repeat: fine streaks over broad figure.
float Grain(float u, float v, int length, int breadth, int salt) {
  const float figure = Noise(u * 0.5F, v * 2, std::max(1, length / 2), breadth * 2, salt);
  const float streak = Noise(u, v * 12 + figure * 3, length, breadth * 12, salt + 1);
  return 0.45F * figure + 0.55F * streak;
}

Tone Wood(float u, float v) { return {0.6F * Grain(u, v, 8, 4, 61), 0.95F + 0.08F * Noise(u * 0.5F, v, 4, 4, 62)}; }

Tone Board(float along, float across, float length, float width, float joint, int id) {
  const float gap = std::max(Joint(across, width, joint), Joint(along, length, joint));
  const float tint = Random(id, 3, 17);
  const float grain = Grain(along + 37 * tint, across, 4096, 64, id);
  return {std::max(gap, 0.30F * grain), 0.88F + 0.16F * tint};
}

Tone Planks(float u, float v) {
  const int row = static_cast<int>(v);
  const float shifted = u + 16 * Random(row, 0, 5);
  const int board = Wrapped(static_cast<int>(std::floor(shifted / 8)), 2);
  const float along = shifted - 8 * std::floor(shifted / 8);
  return Board(along, v - static_cast<float>(row), 8, 1, 0.02F, row * 2 + board);
}

// Staves of 1 by 4, laid at right angles; on the diagonal each row of cells moves by one.
Tone Herringbone(float u, float v) {
  const int i = static_cast<int>(u);
  const int j = static_cast<int>(v);
  const float fu = u - static_cast<float>(i);
  const float fv = v - static_cast<float>(j);
  const int step = Wrapped(i - j, 8);
  if (step < 4) return Board(static_cast<float>(step) + fu, fv, 4, 1, 0.03F, Wrapped(i - step, 8) * 8 + j);
  const int below = 7 - step;  // cells of the same stave below this one
  return Board(static_cast<float>(below) + fv, fu, 4, 1, 0.03F, 64 + i * 8 + Wrapped(j - below, 8));
}

Tone Tiles(float u, float v) {
  const int i = static_cast<int>(u);
  const int j = static_cast<int>(v);
  const float joint =
      std::max(Joint(u - static_cast<float>(i), 1, 0.018F), Joint(v - static_cast<float>(j), 1, 0.018F));
  return {std::max(joint, 0.10F * Noise(u * 3, v * 3, 12, 12, 9)), 0.94F + 0.10F * Random(i, j, 11)};
}

Tone Bricks(float u, float v) {
  constexpr float kCourse = 1 / 3.0F;
  const int row = static_cast<int>(v / kCourse);
  const float shifted = u + (row % 2 == 0 ? 0.0F : 0.5F);
  const int brick = Wrapped(static_cast<int>(std::floor(shifted)), 4);
  const float joint = std::max(Joint(shifted - std::floor(shifted), 1, 0.03F),
                               Joint(v - static_cast<float>(row) * kCourse, kCourse, 0.03F));
  return {joint, 0.84F + 0.22F * Random(brick, row, 21) - 0.05F * Noise(u * 8, v * 8, 32, 32, 22)};
}

Tone Stone(float u, float v) {
  const float broad = Noise(u, v, 4, 4, 31);
  const float middle = Noise(u * 3, v * 3, 12, 12, 32);
  const float fine = Noise(u * 13, v * 13, 52, 52, 33);
  return {0.5F * broad + 0.3F * middle + 0.2F * fine, 1};
}

// Cells round scattered points, 8 by 8 before they repeat; the joint is where the two nearest are equally far.
Tone Stones(float u, float v) {
  const int i = static_cast<int>(u);
  const int j = static_cast<int>(v);
  float nearest = 1e9F, second = 1e9F, tone = 0;
  for (int a = i - 1; a <= i + 1; ++a) {
    for (int b = j - 1; b <= j + 1; ++b) {
      const int cell_x = Wrapped(a, 8);
      const int cell_y = Wrapped(b, 8);
      const float dx = static_cast<float>(a) + 0.15F + 0.7F * Random(cell_x, cell_y, 34) - u;
      const float dy = static_cast<float>(b) + 0.15F + 0.7F * Random(cell_x, cell_y, 35) - v;
      const float distance = std::sqrt(dx * dx + dy * dy);
      if (distance < nearest) {
        second = nearest;
        nearest = distance;
        tone = Random(cell_x, cell_y, 36);
      } else {
        second = std::min(second, distance);
      }
    }
  }
  const float joint = std::clamp(1.4F - (second - nearest) / 0.07F, 0.0F, 1.0F);
  const float grain = 0.5F * Noise(u * 4, v * 4, 32, 32, 37) + 0.5F * Noise(u * 16, v * 16, 128, 128, 38);
  return {std::max(joint, 0.30F * grain), 0.82F + 0.26F * tone};
}

Tone Carpet(float u, float v) {
  const float tuft = Random(Wrapped(static_cast<int>(u * 2), 128), Wrapped(static_cast<int>(v * 2), 128), 41);
  return {0.55F * tuft + 0.25F * Noise(u / 8, v / 8, 8, 8, 42), 0.94F + 0.10F * tuft};
}

Tone Fabric(float u, float v) {
  const bool over = (static_cast<int>(u) + static_cast<int>(v)) % 2 == 0;
  const float across = over ? v - std::floor(v) : u - std::floor(u);
  const float roundness = 4 * across * (1 - across);
  const float thread = over ? Random(0, static_cast<int>(v), 51) : Random(static_cast<int>(u), 1, 52);
  return {0.45F * (1 - roundness) + 0.25F * thread, 0.96F + 0.06F * roundness};
}

// A lozenge with a blossom, every second column half a repeat lower.
Tone Wallpaper(float u, float v) {
  const int column = static_cast<int>(u * 2);
  const float x = 2 * (u * 2 - static_cast<float>(column)) - 1;
  const float y_shifted = v + (column % 2 == 0 ? 0.0F : 0.5F);
  const float y = 2 * (y_shifted - std::floor(y_shifted)) - 1;
  const float lozenge = std::abs(x) + std::abs(y);
  const float radius = std::sqrt(x * x + 0.45F * y * y);
  const float petals = 0.34F + 0.13F * std::cos(6 * std::atan2(y * 0.67F, x));
  const bool figure = radius < petals || std::abs(lozenge - 0.92F) < 0.035F;
  const bool heart = radius < 0.09F;
  return {figure && !heart ? 1.0F : 0.0F, 1};
}

struct FigureFacts {
  Vec2 period;
  Tone (*tone)(float u, float v);
};

// In the order of the enum.
constexpr FigureFacts kFigures[kFigureCount] = {{{0, 0}, [](float, float) { return Tone{}; }},
                                                {{8, 4}, Wood},
                                                {{16, 8}, Planks},
                                                {{8, 8}, Herringbone},
                                                {{4, 4}, Tiles},
                                                {{4, 8 / 3.0F}, Bricks},
                                                {{4, 4}, Stone},
                                                {{64, 64}, Carpet},
                                                {{64, 64}, Fabric},
                                                {{1, 1}, Wallpaper},
                                                {{8, 8}, Stones}};

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

Figure FigureOf(const Material& material) {
  if (material.pattern == Pattern::kStone && material.pattern_size_m < 1) return Figure::kStones;
  return static_cast<Figure>(material.pattern);
}

Vec2 PeriodOf(Figure figure) { return kFigures[static_cast<int>(figure)].period; }

Tone ToneAt(Figure figure, float u, float v) { return kFigures[static_cast<int>(figure)].tone(u, v); }

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
