// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/tracing/radiosity.h"

#include <algorithm>
#include <cmath>

namespace flair::renderer {
namespace {

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
  std::fill(irradiance_.begin(), irradiance_.end(), Vec3{});
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
                                                            const Workers& workers) {
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
  absl::Status status = ForEach(workers, tasks, [&](int task) {
    const size_t end = std::min(points.size(), static_cast<size_t>(task + 1) * kPointsPerTask);
    for (size_t i = static_cast<size_t>(task) * kPointsPerTask; i < end; ++i) gather(i);
  });
  if (!status.ok()) return status;
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
