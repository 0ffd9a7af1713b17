// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/tracing/lights.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flair::renderer {
namespace {

constexpr float kLeastBesideSky = 0.05F;  // irradiance over pi; the sky's is about 1
constexpr size_t kMostLights = 250;       // beyond, the least bright ones of a scene stay dark

// How much a light may give a point: only steers the choice.
float GuessOf(const RectLight& rect, Vec3 position, Vec3 normal) {
  constexpr float kPlaces[5][2] = {{0.1F, 0.1F}, {0.9F, 0.1F}, {0.1F, 0.9F}, {0.9F, 0.9F}, {0.5F, 0.5F}};
  float sum = 0;
  for (const auto& place : kPlaces) {
    const Vec3 way = rect.corner + rect.along * place[0] + rect.up * place[1] - position;
    const float distance2 = Dot(way, way) + 0.02F * rect.area_m2;
    const float above = std::max(0.0F, Dot(normal, way)), facing = std::max(0.0F, -Dot(rect.normal, way));
    sum += above * facing / (distance2 * distance2);
  }
  return sum * rect.area_m2 * (rect.window ? 1 : Luminance(rect.radiance)) * (0.2F / kPiFloat);
}

float GuessOf(const BallLight& ball, Vec3 position, Vec3 normal) {
  const Vec3 way = ball.centre - position;
  const float left = ball.LeftAt(Dot(way, way));
  if (left <= 0) return 0;
  const float distance2 = Dot(way, way) + ball.radius_m * ball.radius_m;
  const float above = Dot(normal, way) + ball.radius_m;
  return above <= 0 ? 0 : left * Luminance(ball.intensity) * (above / std::sqrt(distance2)) / distance2 / kPiFloat;
}

LightSample TowardsRect(const Lights& lights, const RectLight& rect, Vec3 position, Vec3 normal, Vec2 place) {
  const Vec3 point = rect.corner + rect.along * place.x + rect.up * place.y;
  const Vec3 way = point - position;
  const float distance2 = std::max(Dot(way, way), 1e-6F);
  LightSample sample;
  sample.distance = std::sqrt(distance2);
  sample.direction = way * (1 / sample.distance);
  const float cosine = Dot(normal, sample.direction), facing = -Dot(rect.normal, sample.direction);
  if (cosine <= 0 || facing <= 0) return sample;
  const Vec3 radiance = rect.window ? lights.SkyRadiance(sample.direction) : rect.radiance;
  // Right before a window a point of it would outshine all others: no smaller than a fiftieth of its area.
  const float form = cosine * facing * rect.area_m2 / (kPiFloat * std::max(distance2, rect.area_m2 * 0.02F));
  sample.irradiance = radiance * form;
  return sample;
}

LightSample TowardsBall(const BallLight& ball, Vec3 position, Vec3 normal, Vec2 place) {
  LightSample sample;
  const Vec3 axis = ball.centre - position;
  const float distance = std::max(Length(axis), 1e-3F);
  Vec3 s, t;
  Basis(axis * (1 / distance), s, t);
  const Vec2 disc = DiscPoint(place);
  const Vec3 way = axis + s * (disc.x * ball.radius_m) + t * (disc.y * ball.radius_m);
  sample.distance = Length(way);
  sample.direction = way * (1 / std::max(sample.distance, 1e-6F));
  const float cosine = Dot(normal, sample.direction);
  if (cosine <= 0) return sample;
  const float distance2 = std::max(distance * distance, 4 * ball.radius_m * ball.radius_m);
  sample.irradiance = ball.intensity * (ball.LeftAt(distance * distance) * cosine / (kPiFloat * distance2));
  return sample;
}

LightSample TowardsSun(const Lights& lights, Vec3 normal, Vec2 place) {
  LightSample sample;
  Vec3 s, t;
  Basis(lights.sun_direction, s, t);
  const Vec2 disc = DiscPoint(place);
  sample.direction =
      Normalized(lights.sun_direction + s * (disc.x * lights.sun_radius) + t * (disc.y * lights.sun_radius));
  sample.distance = std::numeric_limits<float>::infinity();
  sample.irradiance = lights.sun_irradiance * (std::max(0.0F, Dot(normal, sample.direction)) / kPiFloat);
  return sample;
}

void AddLamps(const Scene& scene, float scale, Lights& lights) {
  for (const SceneObject& object : scene.objects) {
    const float theta = static_cast<float>(object.placement.theta_rad());
    for (const LampLight& lamp : object.furnishing.lights) {
      const Vec3 p = lamp.position;
      BallLight ball;
      ball.centre = {p.x * std::cos(theta) - p.y * std::sin(theta) + static_cast<float>(object.placement.x_m()),
                     p.x * std::sin(theta) + p.y * std::cos(theta) + static_cast<float>(object.placement.y_m()),
                     p.z + static_cast<float>(object.placement.z_m())};
      ball.intensity = lamp.colour * (lamp.intensity_cd * scale);
      ball.radius_m = std::clamp(lamp.radius_m, 0.02F, 0.5F);
      const float power = Luminance(ball.intensity);
      if (std::isfinite(power) && power > 0 && power < 1e6F) lights.balls.push_back(ball);
    }
  }
  if (lights.balls.size() + lights.rects.size() <= kMostLights) return;
  std::ranges::stable_sort(lights.balls, [](const BallLight& a, const BallLight& b) {
    return Luminance(a.intensity) > Luminance(b.intensity);
  });
  lights.balls.resize(kMostLights - std::min(kMostLights, lights.rects.size()));
}

}  // namespace

Vec3 Lights::SkyRadiance(Vec3 direction) const {
  if (uniform_sky) return Vec3{1, 1, 1} * sky_scale;
  const float height = direction.z;
  if (height < 0) return Vec3{0.42F, 0.41F, 0.39F} * sky_scale;
  const float up = std::sqrt(height);
  return (Vec3{0.86F, 0.87F, 0.88F} * (1 - up) + Vec3{1.03F, 1.05F, 1.08F} * up) * sky_scale;
}

Vec3 Lights::Beyond(Vec3 from, Vec3 direction) const {
  if (open_sky) return SkyRadiance(direction);
  return WindowThrough(from, direction) >= 0 ? Vec3{} : beyond;
}

int Lights::WindowThrough(Vec3 from, Vec3 direction, float spread) const {
  for (size_t i = 0; i < rects.size(); ++i) {
    const RectLight& rect = rects[i];
    const float rate = -Dot(rect.normal, direction);
    if (!rect.window || rate <= 1e-6F) continue;
    const float distance = Dot(from - rect.corner, rect.normal) / rate;
    if (distance <= 0) continue;
    const Vec3 at = from + direction * distance - rect.corner;
    const float width2 = Dot(rect.along, rect.along), height2 = Dot(rect.up, rect.up), margin = spread * distance;
    const float u = Dot(at, rect.along) / width2, v = Dot(at, rect.up) / height2;
    const float du = margin / std::sqrt(width2), dv = margin / std::sqrt(height2);
    if (u >= -du && u <= 1 + du && v >= -dv && v <= 1 + dv) return static_cast<int>(i);
  }
  return -1;
}

LightChoice::LightChoice(const Lights& lights, Vec3 position, Vec3 normal)
    : lights_(lights), position_(position), normal_(normal) {
  for (const RectLight& rect : lights.rects) {
    total_ += guess_[count_++] = GuessOf(rect, position, normal) * (rect.window ? lights.sky_scale : 1);
  }
  for (const BallLight& ball : lights.balls) total_ += guess_[count_++] = GuessOf(ball, position, normal);
  // A guess may be wrong: no light that counts at all is chosen too seldom, or its few samples would be sparks.
  const float least = 0.12F * total_ / static_cast<float>(std::max<size_t>(count_, 1));
  total_ = 0;
  for (size_t i = 0; i < count_; ++i) {
    if (guess_[i] > 0) guess_[i] = std::max(guess_[i], least);
    total_ += guess_[i];
  }
  sun_ = Luminance(lights.sun_irradiance) > 0 && Dot(normal, lights.sun_direction) + lights.sun_radius > 0 &&
         (lights.open_sky || lights.WindowThrough(position, lights.sun_direction, 2 * lights.sun_radius) >= 0);
}

LightSample LightChoice::Sample(float choice, Vec2 place) const {
  if (!(total_ > 0)) return {};
  float rest = choice * total_;
  size_t chosen = 0;
  while (chosen + 1 < count_ && (rest >= guess_[chosen] || guess_[chosen] <= 0)) rest -= guess_[chosen++];
  if (guess_[chosen] <= 0) return {};
  LightSample sample = chosen < lights_.rects.size()
                           ? TowardsRect(lights_, lights_.rects[chosen], position_, normal_, place)
                           : TowardsBall(lights_.balls[chosen - lights_.rects.size()], position_, normal_, place);
  sample.irradiance = sample.irradiance * (total_ / guess_[chosen]);
  return sample;
}

LightSample LightChoice::SampleSun(Vec2 place) const {
  LightSample sample = TowardsSun(lights_, normal_, place);
  if (!lights_.open_sky && lights_.WindowThrough(position_, sample.direction) < 0) sample.irradiance = {};
  return sample;
}

Lights LightsOf(const Scene& scene, bool open_sky) {
  Lights lights;
  lights.open_sky = open_sky;
  if (open_sky) {
    // From behind the camera's left shoulder, high: soft shadows that fall away to the right.
    const Vec3 ahead = Normalized(
        Vec3{scene.birdseye.target.x - scene.birdseye.eye.x, scene.birdseye.target.y - scene.birdseye.eye.y, 0});
    const Vec3 left{-ahead.y, ahead.x, 0};
    lights.sun_direction = Normalized(left * 0.75F - ahead * 0.15F + Vec3{0, 0, 1.15F});
    lights.sun_irradiance = Vec3{1.0F, 0.94F, 0.85F} * 2.2F;
    lights.sun_radius = 0.09F;
    AddLamps(scene, 0.005F, lights);
    for (BallLight& ball : lights.balls) {
      ball.reach_m = std::sqrt(Luminance(ball.intensity) / (kPiFloat * kLeastBesideSky));
    }
    return lights;
  }
  for (const DaylightWindow& window : scene.windows) {
    const float area = Length(window.along) * Length(window.up);
    if (area <= 1e-4F || lights.rects.size() >= 100) continue;
    lights.rects.push_back({window.corner, window.along, window.up, window.inward, area, true, {}});
  }
  AddLamps(scene, 0.012F, lights);
  lights.beyond = {0.32F, 0.32F, 0.31F};
  // The sun stands where the largest window lets it in, aslant.
  const auto largest = std::ranges::max_element(
      lights.rects, [](const auto& a, const auto& b) { return a.area_m2 < b.area_m2 - 1e-3F; });
  if (largest != lights.rects.end()) {
    lights.sun_direction = Normalized(-largest->normal + Normalized(largest->along) * 0.55F + Vec3{0, 0, 0.95F});
    lights.sun_irradiance = Vec3{1.0F, 0.90F, 0.74F} * 3.0F;
    lights.sun_radius = 0.035F;
  }
  return lights;
}

}  // namespace flair::renderer
