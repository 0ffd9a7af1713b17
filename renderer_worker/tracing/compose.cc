// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/tracing/compose.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace flair::renderer {
namespace {

constexpr int kEdgeLooks = 6;
constexpr double kWhite = 1.0;          // what a white surface in mean light comes to
constexpr double kWhiteBalance = 0.65;  // how much of the light's colour is taken out
constexpr double kUsualAlbedo = 0.42;   // of a room in common colours
constexpr double kAdaptation = 0.35;    // how far the eye gets used to darker or lighter ones

// Light on bare ground beside the model, which its backdrop shall keep the colour of.
float BareGroundLight(const Lights& lights) {
  float sky = 0;
  constexpr int kSteps = 64;
  for (int i = 0; i < kSteps; ++i) {
    const float height = std::sqrt((static_cast<float>(i) + 0.5F) / kSteps);
    sky += Luminance(lights.SkyRadiance({std::sqrt(1 - height * height), 0, height})) / kSteps;
  }
  return sky + Luminance(lights.sun_irradiance) * std::max(0.0F, lights.sun_direction.z) / std::numbers::pi_v<float>;
}

class Composer {
 public:
  explicit Composer(const Exposed& e) : e_(e), bare_ground_(e.surroundings.open ? BareGroundLight(e.lights) : 1) {}

  absl::Status Expose(const Workers& workers);
  Vec3 Pixel(int x, int y) const;

 private:
  size_t At(int x, int y) const { return static_cast<size_t>(y) * e_.camera.width_px + x; }
  bool OnEdge(int x, int y) const;
  Lit LitLike(const Seen& seen, int x, int y) const;
  Vec3 Radiance(const Seen& seen, const Lit& lit) const;

  const Exposed& e_;
  float bare_ground_;
  Vec3 exposure_{1, 1, 1};
};

// Means by row, then over rows, so that the order of the sum is always the same.
absl::Status Composer::Expose(const Workers& workers) {
  struct Row {
    double red = 0, green = 0, blue = 0, albedo = 0, count = 0;
  };
  std::vector<Row> rows(e_.camera.height_px);
  absl::Status status = ForEach(workers, e_.camera.height_px, [&](int y) {
    for (int x = 0; x < e_.camera.width_px; ++x) {
      const Seen& seen = e_.seen[At(x, y)];
      if (seen.lit_instance < 0 || seen.instance < 0) continue;
      const Vec3 light = e_.lit[At(x, y)].irradiance;
      rows[y].red += light.x;
      rows[y].green += light.y;
      rows[y].blue += light.z;
      rows[y].albedo += Luminance(seen.albedo + seen.specular);
      rows[y].count += 1;
    }
  });
  if (!status.ok()) return status;
  Row all;
  for (const Row& row : rows) {
    all = {all.red + row.red, all.green + row.green, all.blue + row.blue, all.albedo + row.albedo,
           all.count + row.count};
  }
  const double light = 0.2126 * all.red + 0.7152 * all.green + 0.0722 * all.blue;
  if (all.count == 0 || !(light > 1e-9 * all.count)) return status;
  const double albedo = std::max(all.albedo / all.count, 0.01);
  const double exposure =
      kWhite * all.count / light * std::clamp(std::pow(kUsualAlbedo / albedo, kAdaptation), 0.75, 1.7);
  // Lamplight stays a little warm: the eye gets used to most of its colour, not to all.
  const auto gain = [&](double channel) {
    return static_cast<float>(exposure *
                              std::pow(std::clamp(light / std::max(channel, 1e-9), 0.5, 2.0), kWhiteBalance));
  };
  exposure_ = {gain(all.red), gain(all.green), gain(all.blue)};
  return status;
}

// Whether what the pixel shows ends within it.
bool Composer::OnEdge(int x, int y) const {
  const Seen& here = e_.seen[At(x, y)];
  for (int b = std::max(0, y - 1); b <= std::min(e_.camera.height_px - 1, y + 1); ++b) {
    for (int a = std::max(0, x - 1); a <= std::min(e_.camera.width_px - 1, x + 1); ++a) {
      const Seen& there = e_.seen[At(a, b)];
      if (there.instance != here.instance || there.lit_instance != here.lit_instance) return true;
      if (here.instance < 0) continue;
      if (Dot(here.normal, there.normal) < 0.93F || Dot(here.first_normal, there.first_normal) < 0.93F) return true;
      if (std::abs(here.distance - there.distance) > 0.02F * here.distance) return true;
    }
  }
  return false;
}

// The light of the pixel about (x, y) that shows the same surface; the coarse light where none does.
Lit Composer::LitLike(const Seen& seen, int x, int y) const {
  if (seen.lit_instance == -1) return {};
  const float pixel = std::max(seen.distance, 0.1F) / e_.camera.focal_px;
  float best = 6;
  const Lit* found = nullptr;
  for (int b = std::max(0, y - 1); b <= std::min(e_.camera.height_px - 1, y + 1); ++b) {
    for (int a = std::max(0, x - 1); a <= std::min(e_.camera.width_px - 1, x + 1); ++a) {
      const Seen& there = e_.seen[At(a, b)];
      if (there.lit_instance != seen.lit_instance) continue;
      const Vec3 way = there.position - seen.position;
      const float off = std::abs(Dot(way, seen.normal)) / pixel + 0.2F * Length(way) / pixel;
      const float differs = off + 8 * (1 - Dot(there.normal, seen.normal));
      if (differs < best) best = differs, found = &e_.lit[At(a, b)];
    }
  }
  if (found != nullptr) return *found;
  if (seen.lit_instance < 0) return e_.lit[At(x, y)];
  Lit lit;
  lit.irradiance = e_.radiosity.IrradianceAt(seen.lit_instance, seen.position, seen.normal);
  return lit;
}

Vec3 Composer::Radiance(const Seen& seen, const Lit& lit) const {
  if (seen.lit_instance == -2) {  // the ground: backdrop, darker where the model keeps light away
    const float share = std::min(1.0F, Luminance(lit.irradiance) / bare_ground_);
    return seen.added * exposure_ + seen.filter * e_.surroundings.backdrop * share;
  }
  if (seen.lit_instance == -1) return seen.added;  // what is beyond appears as it is
  return (seen.added + seen.filter * (seen.albedo * lit.irradiance + lit.gloss)) * exposure_;
}

Vec3 Composer::Pixel(int x, int y) const {
  const Seen& here = e_.seen[At(x, y)];
  if (!OnEdge(x, y)) return Radiance(here, e_.lit[At(x, y)]);
  std::array<Vec3, kEdgeLooks> ways;
  for (int i = 0; i < kEdgeLooks; ++i) {
    const uint32_t number = static_cast<uint32_t>(i);
    const float column =
        static_cast<float>(x) + static_cast<float>((number * 3242174889U + 0x40000000U) >> 8) * 0x1p-24F;
    const float row = static_cast<float>(y) + (static_cast<float>(i) + 0.5F) / kEdgeLooks;
    ways[i] = e_.camera.Through(column, row);
  }
  std::array<Seen, kEdgeLooks> looks;
  LookFrom(e_.world, e_.lights, e_.surroundings, e_.camera.eye, ways, 1 / e_.camera.focal_px, looks);
  Vec3 sum;
  for (const Seen& seen : looks) {
    const Vec3 radiance = Radiance(seen, LitLike(seen, x, y));
    // Highlights are bounded before the mean, or they would leave steps along edges.
    const float most = std::max({radiance.x, radiance.y, radiance.z});
    sum = sum + (most > 1.5F ? radiance * (1.5F / most) : radiance);
  }
  return sum * (1.0F / kEdgeLooks);
}

}  // namespace

absl::Status ComposeColour(const Exposed& exposed, const Workers& workers, std::vector<Vec3>& colour) {
  Composer composer(exposed);
  if (absl::Status status = composer.Expose(workers); !status.ok()) return status;
  colour.resize(exposed.seen.size());
  return ForEach(workers, exposed.camera.height_px, [&](int y) {
    for (int x = 0; x < exposed.camera.width_px; ++x) {
      colour[static_cast<size_t>(y) * exposed.camera.width_px + x] = composer.Pixel(x, y);
    }
  });
}

}  // namespace flair::renderer
