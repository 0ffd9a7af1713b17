// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "renderer_worker/tracing/lights.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {
namespace {

constexpr int kLeastPerInstance = 3;

float AreaOf(const MeshPart& part, size_t triangle) {
  const uint32_t* corner = &part.indices[3 * triangle];
  const Vec3 a = part.positions[corner[0]];
  const float area = Length(Cross(part.positions[corner[1]] - a, part.positions[corner[2]] - a)) / 2;
  return std::isfinite(area) ? area : 0;
}

double AreaOf(const Mesh& mesh) {
  double area = 0;
  for (const MeshPart& part : mesh.parts) {
    if (!HoldsUpLight(part.material)) continue;
    for (size_t i = 0; i < part.indices.size() / 3; ++i) area += AreaOf(part, i);
  }
  return area;
}

// One point every `step` square metres, the first after half of it; within a triangle by Roberts' R2 sequence.
void AddPoints(const WorldInstance& instance, int index, double step, std::vector<SurfacePoint>& points) {
  double due = step / 2;
  uint32_t number = static_cast<uint32_t>(index) * 7U;
  for (const MeshPart& part : instance.mesh->parts) {
    if (!HoldsUpLight(part.material)) continue;
    for (size_t i = 0; i < part.indices.size() / 3; ++i) {
      due -= AreaOf(part, i);
      for (; due < 0; due += step, ++number) {
        const uint32_t* corner = &part.indices[3 * i];
        float u = static_cast<float>((number * 3242174889U) >> 8) * 0x1p-24F;
        float v = static_cast<float>((number * 2447445414U) >> 8) * 0x1p-24F;
        if (u + v > 1) u = 1 - u, v = 1 - v;
        const Vec3 a = part.positions[corner[0]], b = part.positions[corner[1]] - a, c = part.positions[corner[2]] - a;
        const Vec3 normal = Normalized(instance.TurnToRoom(Cross(b, c)));
        points.push_back({instance.ToRoom(a + b * u + c * v) + normal * 1e-3F, normal, index});
      }
    }
  }
}

constexpr int kRaysPerPoint = 40;
constexpr int kLightSamples = 10;
constexpr int kBounces = 7;
constexpr int kPointsPerTask = 64;

// What a ray from a point met.
struct Link {
  int cell = -1;  // -1: nothing that sends light on
  Vec3 colour;
};

int SideOf(Vec3 normal) {
  const float x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
  if (z >= x && z >= y) return normal.z > 0 ? 4 : 5;
  if (x >= y) return normal.x > 0 ? 0 : 1;
  return normal.y > 0 ? 2 : 3;
}

}  // namespace

std::vector<SurfacePoint> SpreadPoints(const World& world, int count) {
  std::vector<double> areas;
  double total = 0;
  for (const WorldInstance& instance : world.instances()) {
    areas.push_back(instance.shades ? AreaOf(*instance.mesh) : 0);
    total += areas.back();
  }
  std::vector<SurfacePoint> points;
  const double step = total / std::max(count, 1);
  for (size_t i = 0; i < areas.size(); ++i) {
    if (areas[i] <= 0 || !std::isfinite(areas[i])) continue;
    AddPoints(world.instances()[i], static_cast<int>(i), std::min(step, areas[i] / kLeastPerInstance), points);
  }
  return points;
}

Vec3 DirectLight(const World& world, const LightChoice& choice, Vec3 position, const PixelSamples& random, int sample) {
  Vec3 light;
  const auto add = [&](const LightSample& from) {
    if (Luminance(from.irradiance) > 0 && !IsShaded(world, position, from)) light = light + from.irradiance;
  };
  if (choice.any()) add(choice.Sample(random.At(sample, Purpose::kLight).x, random.At(sample, Purpose::kPlaceOnLight)));
  if (choice.sun()) add(choice.SampleSun(random.At(sample, Purpose::kSun)));
  return light;
}

float MeanDirectLight(const World& world, const Lights& lights, const std::vector<SurfacePoint>& points, int samples) {
  const SampleSeeds seeds(77);
  double sum = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const PixelSamples random(seeds, static_cast<int>(i % 256), static_cast<int>(i / 256), samples);
    const LightChoice choice(lights, points[i].position, points[i].normal);
    for (int k = 0; k < samples; ++k) sum += Luminance(DirectLight(world, choice, points[i].position, random, k));
  }
  return points.empty() ? 0 : static_cast<float>(sum / (static_cast<double>(points.size()) * samples));
}

void BalanceLights(const World& world, const std::vector<SurfacePoint>& points, const RoomShape& shape,
                   Lights& lights) {
  constexpr float kDaylight = 0.6F, kLeastDaylight = 0.002F, kLamplight = 0.3F, kFill = 0.3F, kFillBesideLamps = 0.06F;
  std::vector<SurfacePoint> inside;  // what faces the outside gets no light and shall not count
  for (const SurfacePoint& p : points) {
    const Vec3 q = p.position;
    if (q.z > 0 && q.z < shape.height_m && Inside(shape, q.x, q.y)) inside.push_back(p);
  }
  Lights daylight = lights;
  daylight.balls.clear();
  daylight.sun_irradiance = {};
  const float mean = MeanDirectLight(world, daylight, inside, 4);
  if (mean > kLeastDaylight) {
    lights.sky_scale = kDaylight / mean;
    return;
  }
  lights.sky_scale = 1;
  Lights lamplight = lights;
  lamplight.rects.clear();
  lamplight.sun_irradiance = {};
  const float of_lamps = MeanDirectLight(world, lamplight, inside, 4);
  const bool lamps = of_lamps > 1e-4F;
  for (BallLight& ball : lights.balls) {
    if (lamps) ball.intensity = ball.intensity * (kLamplight / of_lamps);
  }
  lights.sun_irradiance = {};
  const auto [low, high] = Bounds2(shape.floor);
  const float width = 0.8F * (high.x - low.x), depth = 0.8F * (high.y - low.y);
  RectLight fill;
  fill.corner = {low.x + width / 8, high.y - depth / 8, shape.height_m - 0.01F};
  fill.along = {width, 0, 0};
  fill.up = {0, -depth, 0};
  fill.normal = {0, 0, -1};
  fill.area_m2 = width * depth;
  fill.radiance = {1, 0.98F, 0.95F};
  daylight.rects = {fill};
  const float filled = MeanDirectLight(world, daylight, inside, 4);
  if (!(filled > 1e-6F)) return;
  fill.radiance = fill.radiance * ((lamps ? kFillBesideLamps : kFill) / filled);
  lights.rects = {fill};
}

uint64_t Radiosity::KeyOf(int instance, Vec3 position, int side) const {
  // Truncation is rounding down here: nothing lies 8,192 cells off.
  const auto cell = [this](float value) {
    return static_cast<uint64_t>(static_cast<int>(std::clamp(value * cells_per_m_ + 8192, 0.0F, 16383.0F)));
  };
  return ((static_cast<uint64_t>(instance) * 6 + static_cast<uint64_t>(side)) << 42) | (cell(position.x) << 28) |
         (cell(position.y) << 14) | cell(position.z);
}

int Radiosity::CellAt(int instance, Vec3 position, Vec3 normal) const {
  const int side = SideOf(normal);
  const auto at = cells_.find(KeyOf(instance, position, side));
  return at != cells_.end() ? at->second : first_fallback_ + instance * 6 + side;
}

std::vector<int> Radiosity::AssignCells(const std::vector<SurfacePoint>& points, size_t instance_count) {
  std::vector<int> cell_of;
  for (const SurfacePoint& p : points) {
    const uint64_t key = KeyOf(p.instance, p.position, SideOf(p.normal));
    cell_of.push_back(cells_.try_emplace(key, static_cast<int>(cells_.size())).first->second);
  }
  first_fallback_ = static_cast<int>(cells_.size());
  irradiance_.assign(cells_.size() + 6 * instance_count, {});
  return cell_of;
}

// Means by cell and by side of each instance; sides without points take the instance's mean.
void Radiosity::Average(const std::vector<SurfacePoint>& points, const std::vector<int>& cell_of,
                        const std::vector<Vec3>& values) {
  std::ranges::fill(irradiance_, Vec3{});
  std::vector<float> weight(irradiance_.size());
  for (size_t i = 0; i < points.size(); ++i) {
    for (const int slot : {cell_of[i], first_fallback_ + points[i].instance * 6 + SideOf(points[i].normal)}) {
      irradiance_[slot] = irradiance_[slot] + values[i];
      weight[slot] += 1;
    }
  }
  for (size_t first = first_fallback_; first < irradiance_.size(); first += 6) {
    Vec3 sum;
    float count = 0;
    for (size_t i = first; i < first + 6; ++i) sum = sum + irradiance_[i], count += weight[i];
    for (size_t i = first; i < first + 6; ++i) {
      if (weight[i] == 0) irradiance_[i] = sum, weight[i] = std::max(count, 1.0F);
    }
  }
  for (size_t i = 0; i < irradiance_.size(); ++i) irradiance_[i] = irradiance_[i] * (1 / std::max(weight[i], 1.0F));
}

absl::StatusOr<std::unique_ptr<Radiosity>> Radiosity::Solve(const World& world, const Lights& lights,
                                                            const std::vector<SurfacePoint>& points,
                                                            const runtime::Workers& workers) {
  auto result = std::make_unique<Radiosity>();
  const std::vector<int> cell_of = result->AssignCells(points, world.instances().size());
  std::vector<Vec3> direct(points.size());
  std::vector<Link> links(points.size() * kRaysPerPoint);
  const SampleSeeds seeds(1234);
  const auto gather = [&](size_t i) {
    const SurfacePoint& p = points[i];
    const PixelSamples random(seeds, static_cast<int>(i & 255), static_cast<int>(i >> 8), 64);
    const LightChoice choice(lights, p.position, p.normal);
    Vec3 sum;
    for (int k = 0; k < kLightSamples; ++k) sum = sum + DirectLight(world, choice, p.position, random, k);
    direct[i] = sum * (1.0F / kLightSamples);
    Vec3 sky;
    for (int k = 0; k < kRaysPerPoint; ++k) {
      const Vec3 direction = CosineDirection(p.normal, random.At(k, Purpose::kBounce));
      const Hit hit = world.Feel(p.position, direction);
      if (hit.instance < 0) {
        sky = sky + lights.Beyond(p.position, direction);
        continue;
      }
      const Vec3 normal = world.GeometricNormalAt(hit, direction);
      links[i * kRaysPerPoint + k] = {
          result->CellAt(hit.instance, p.position + direction * hit.distance + normal * 1e-3F, normal),
          world.MeanColourAt(hit)};
    }
    direct[i] = direct[i] + sky * (1.0F / kRaysPerPoint);
  };
  const int tasks = static_cast<int>((points.size() + kPointsPerTask - 1) / kPointsPerTask);
  RETURN_IF_ERROR(runtime::ForEach(workers, tasks, [&](int task) {
    const size_t end = std::min(points.size(), static_cast<size_t>(task + 1) * kPointsPerTask);
    for (size_t i = static_cast<size_t>(task) * kPointsPerTask; i < end; ++i) gather(i);
  }));
  std::vector<Vec3> values = direct;
  for (int bounce = 0; bounce < kBounces; ++bounce) {
    result->Average(points, cell_of, values);
    for (size_t i = 0; i < points.size(); ++i) {
      Vec3 sum;
      for (int k = 0; k < kRaysPerPoint; ++k) {
        const Link& link = links[i * kRaysPerPoint + k];
        if (link.cell >= 0) sum = sum + link.colour * result->irradiance_[link.cell];
      }
      values[i] = direct[i] + sum * (1.0F / kRaysPerPoint);
    }
  }
  result->Average(points, cell_of, values);
  return result;
}

Vec3 Radiosity::IrradianceAt(int instance, Vec3 position, Vec3 normal) const {
  return irradiance_[CellAt(instance, position, normal)];
}

}  // namespace flair::renderer
