// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/rooms/wall_space.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "language_worker/handbook/rooms/wall_words.h"

namespace flair::language {
namespace {

constexpr double kBetweenM = 0.15;  // openings
constexpr double kAlmost = 1e-9;

double RoundDownTo5Cm(double length_m) { return std::floor(length_m * 20 + kAlmost) / 20; }

WallSpan Widest(const std::vector<WallSpan>& spans) {
  return *std::ranges::max_element(
      spans, [](const WallSpan& a, const WallSpan& b) { return a.width_m + kAlmost < b.width_m; });
}

}  // namespace

std::vector<WallSpan> WallSpace::Free(int wall, double corner_m) const {
  const double wall_m = WallLength(room_, wall);
  // A short wall has no room for gaps.
  corner_m = std::min(corner_m, wall_m / 10);
  std::vector<std::pair<double, double>> taken;
  for (const v1::Opening& one : room_.openings()) {
    if (one.wall() != room_.walls(wall).name()) continue;
    taken.emplace_back(one.offset_m() - kBetweenM, one.offset_m() + one.width_m() + kBetweenM);
  }
  taken.emplace_back(wall_m - corner_m, wall_m);
  std::ranges::sort(taken);
  std::vector<WallSpan> free;
  double from_m = corner_m;
  for (const auto& [begin_m, end_m] : taken) {
    if (begin_m > from_m) free.push_back({from_m, begin_m - from_m});
    from_m = std::max(from_m, end_m);
  }
  return free;
}

std::optional<WallSpan> WallSpace::Place(int wall, const OpeningSize& size, const AlongWall& along, bool& moved) const {
  const double wall_m = WallLength(room_, wall);
  const std::vector<WallSpan> free = Free(wall, along.from_end_m ? 0 : size.corner_m);
  moved = false;
  if (free.empty()) return std::nullopt;
  const bool at_end = IsEnd(wall, along.end).value_or(false);
  if (along.at == AlongWall::At::kEnd && along.from_end_m) {
    const double from_m = at_end ? wall_m - *along.from_end_m - size.width_m : *along.from_end_m;
    for (const WallSpan& span : free) {
      const bool holds =
          from_m >= span.offset_m - kAlmost && from_m + size.width_m <= span.offset_m + span.width_m + kAlmost;
      if (holds) return WallSpan{from_m, size.width_m};
    }
    moved = true;
  } else if (along.at == AlongWall::At::kEnd) {
    const WallSpan& span = at_end ? free.back() : free.front();
    const double width_m = std::min(size.width_m, RoundDownTo5Cm(span.width_m));
    if (width_m >= size.least_m) {
      return WallSpan{at_end ? span.offset_m + span.width_m - width_m : span.offset_m, width_m};
    }
    moved = true;
  } else if (along.at == AlongWall::At::kMiddle) {
    for (const WallSpan& span : free) {
      const double half_m = std::min(wall_m / 2 - span.offset_m, span.offset_m + span.width_m - wall_m / 2);
      const double width_m = std::min(size.width_m, RoundDownTo5Cm(2 * half_m));
      if (width_m >= size.least_m) return WallSpan{(wall_m - width_m) / 2, width_m};
    }
    moved = true;
  }
  const WallSpan span = Widest(free);
  const double width_m = std::min(size.width_m, RoundDownTo5Cm(span.width_m));
  if (width_m < size.least_m) return std::nullopt;
  return WallSpan{span.offset_m + (span.width_m - width_m) / 2, width_m};
}

std::vector<WallSpan> WallSpace::Spread(int wall, int count, const OpeningSize& size) const {
  const std::vector<WallSpan> free = Free(wall, size.corner_m);
  std::vector<WallSpan> spread;
  if (free.empty()) return spread;
  const WallSpan span = Widest(free);
  for (; count > 0; --count) {
    const double share_m = (span.width_m + kBetweenM) / count;
    const double width_m = std::min(size.width_m, RoundDownTo5Cm(share_m - kBetweenM));
    if (width_m < size.least_m) continue;
    for (int i = 0; i < count; ++i) {
      const double middle_m = span.offset_m + share_m * i + (share_m - kBetweenM) / 2;
      spread.push_back({middle_m - width_m / 2, width_m});
    }
    break;
  }
  return spread;
}

std::optional<bool> WallSpace::IsEnd(int wall, const std::string& words) const {
  const int next = (wall + 1) % room_.floor().vertices_size();
  const v1::Point2 &from = room_.floor().vertices(wall), &to = room_.floor().vertices(next);
  const double dx_m = to.x_m() - from.x_m(), dy_m = to.y_m() - from.y_m();
  const bool along_x = std::abs(dx_m) > std::abs(dy_m);
  if (words.starts_with("east") && along_x) return dx_m > 0;
  if (words.starts_with("west") && along_x) return dx_m < 0;
  if (words.starts_with("north") && !along_x) return dy_m > 0;
  if (words.starts_with("south") && !along_x) return dy_m < 0;
  // Whoever faces a wall has its end at the left.
  const bool in_the_south = along_x && dx_m > 0;
  if (words == "left") return !in_the_south;
  if (words == "right") return in_the_south;
  for (const v1::Opening& door : room_.openings()) {
    const bool near = words == "near" || words == "nearest" || words == "front" || words == "entrance";
    const bool far = words.starts_with("far") || words == "furthest" || words == "back" || words == "rear";
    if (door.kind() != v1::OPENING_KIND_DOOR || (!near && !far)) continue;
    const std::optional<int> at = WallNamed(room_, door.wall());
    if (!at) break;
    const int behind = (*at + 1) % room_.floor().vertices_size();
    const double share = (door.offset_m() + door.width_m() / 2) / WallLength(room_, *at);
    const v1::Point2 &a = room_.floor().vertices(*at), &b = room_.floor().vertices(behind);
    const double x_m = a.x_m() + share * (b.x_m() - a.x_m()), y_m = a.y_m() + share * (b.y_m() - a.y_m());
    const bool end_nearer = std::hypot(to.x_m() - x_m, to.y_m() - y_m) < std::hypot(from.x_m() - x_m, from.y_m() - y_m);
    return end_nearer == near;
  }
  return std::nullopt;
}

}  // namespace flair::language
