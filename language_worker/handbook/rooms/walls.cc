// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/rooms/walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "language_worker/handbook/reading/words.h"

namespace flair::language {
namespace {

// Lists of words, by quarter turns counter-clockwise: compass words from the south, others from the door's wall.
constexpr std::array kCompassTurns = {"southern_walls", "eastern_walls", "northern_walls", "western_walls"};
constexpr std::array kTurnsFromTheDoor = {"near_walls", "right_walls", "far_walls", "left_walls"};

int Count(const v1::Room& room) { return room.floor().vertices_size(); }

const v1::Point2& CornerAt(const v1::Room& room, int i) {
  return room.floor().vertices((i + Count(room)) % Count(room));
}

// The wall of the first opening of a kind.
std::optional<int> WallWith(const v1::Room& room, v1::OpeningKind kind) {
  for (const v1::Opening& opening : room.openings()) {
    if (opening.kind() == kind) return WallNamed(room, opening.wall());
  }
  return std::nullopt;
}

int DoorHeading(const v1::Room& room) {
  const std::optional<int> door = WallWith(room, v1::OPENING_KIND_DOOR);
  return door ? HeadingOf(room, *door) : 0;
}

std::optional<int> HeadingNamed(const v1::Room& room, std::string_view word) {
  for (std::size_t turns = 0; turns < 4; ++turns) {
    if (IsIn(kCompassTurns[turns], word)) return turns;
    if (IsIn(kTurnsFromTheDoor[turns], word)) return (DoorHeading(room) + turns) % 4;
  }
  return std::nullopt;
}

// The first wall of which a measure is largest, of those that have it.
template <typename Measure>
std::optional<int> Most(const v1::Room& room, const Measure& measure) {
  std::optional<int> best;
  double best_m = 0;
  for (int wall = 0; wall < Count(room); ++wall) {
    const std::optional<double> here_m = measure(wall);
    if (!here_m || (best && *here_m < best_m + 1e-7)) continue;
    best = wall;
    best_m = *here_m;
  }
  return best;
}

constexpr std::array<std::array<double, 2>, 4> kOutward = {{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};

// How long a wall is as seen from out there.
double SeenFrom(const v1::Room& room, int wall, double out_x, double out_y) {
  const v1::Point2 &from = CornerAt(room, wall), &to = CornerAt(room, wall + 1);
  return (to.y_m() - from.y_m()) * out_x - (to.x_m() - from.x_m()) * out_y;
}

std::optional<int> LongestFacing(const v1::Room& room, int heading) {
  const auto [out_x, out_y] = kOutward[static_cast<std::size_t>(heading)];
  return Most(room, [&](int wall) {
    return HeadingOf(room, wall) == heading ? std::optional(SeenFrom(room, wall, out_x, out_y)) : std::nullopt;
  });
}

std::optional<int> OneWord(const v1::Room& room, const std::string& word) {
  if (const std::optional<int> heading = HeadingNamed(room, word)) return LongestFacing(room, *heading);
  const auto length = [&](int wall) { return std::optional(WallLength(room, wall)); };
  if (word.starts_with("long")) return Most(room, length);
  if (word.starts_with("short")) return Most(room, [&](int wall) { return std::optional(-WallLength(room, wall)); });
  if (word == "window") return WallWith(room, v1::OPENING_KIND_WINDOW);
  if (word == "door" || word == "entrance") return WallWith(room, v1::OPENING_KIND_DOOR);
  if (word == "blank") return Most(room, [&](int wall) { return IsBlank(room, wall) ? length(wall) : std::nullopt; });
  return std::nullopt;
}

// "northeast" as its two words.
std::vector<std::string> SideWords(std::string_view words) {
  std::vector<std::string> all;
  for (const Token& token : TokensOf(words)) {
    if (token.text.size() == 9 && (token.text.starts_with("north") || token.text.starts_with("south"))) {
      all.push_back(token.text.substr(0, 5));
      all.push_back(token.text.substr(5));
    } else {
      all.push_back(token.text);
    }
  }
  return all;
}

// The corner that is farthest that way: by the sum of its coordinates along the headings' outward directions.
std::optional<int> CornerTowards(const v1::Room& room, const std::vector<int>& headings) {
  std::optional<int> best;
  double best_m = 0;
  for (int i = 0; i < Count(room); ++i) {
    const v1::Point2& here = CornerAt(room, i);
    if (IsReentrant(room, i)) continue;
    double out_m = 0;
    for (const int heading : headings) {
      const auto& way = kOutward[static_cast<std::size_t>(heading)];
      out_m += way[0] * here.x_m() + way[1] * here.y_m();
    }
    if (!best || out_m > best_m + 1e-9) {
      best = i;
      best_m = out_m;
    }
  }
  return best;
}

// The corner nearest to, or farthest from, a point.
std::optional<int> ExtremeCorner(const v1::Room& room, double x_m, double y_m, bool nearest) {
  std::optional<int> best;
  double best_m = 0;
  for (int i = 0; i < Count(room); ++i) {
    const double away_m = std::hypot(CornerAt(room, i).x_m() - x_m, CornerAt(room, i).y_m() - y_m);
    if (IsReentrant(room, i) || (best && (nearest ? away_m > best_m - 1e-9 : away_m < best_m + 1e-9))) continue;
    best = i;
    best_m = away_m;
  }
  return best;
}

}  // namespace

int HeadingOf(const v1::Room& room, int wall) {
  const double dx_m = CornerAt(room, wall + 1).x_m() - CornerAt(room, wall).x_m();
  const double dy_m = CornerAt(room, wall + 1).y_m() - CornerAt(room, wall).y_m();
  if (std::abs(dx_m) > std::abs(dy_m)) return dx_m > 0 ? 0 : 2;
  return dy_m > 0 ? 1 : 3;
}

bool IsReentrant(const v1::Room& room, int corner) {
  const v1::Point2 &before = CornerAt(room, corner - 1), &here = CornerAt(room, corner),
                   &after = CornerAt(room, corner + 1);
  return (here.x_m() - before.x_m()) * (after.y_m() - here.y_m()) <
         (here.y_m() - before.y_m()) * (after.x_m() - here.x_m());
}

double WallLength(const v1::Room& room, int wall) {
  return std::hypot(CornerAt(room, wall + 1).x_m() - CornerAt(room, wall).x_m(),
                    CornerAt(room, wall + 1).y_m() - CornerAt(room, wall).y_m());
}

v1::Point2 PointOn(const v1::Room& room, int wall, double offset_m) {
  const v1::Point2 &from = CornerAt(room, wall), &to = CornerAt(room, wall + 1);
  const double share = offset_m / WallLength(room, wall);
  v1::Point2 point;
  point.set_x_m(from.x_m() + share * (to.x_m() - from.x_m()));
  point.set_y_m(from.y_m() + share * (to.y_m() - from.y_m()));
  return point;
}

std::optional<int> WallNamed(const v1::Room& room, std::string_view name) {
  for (int i = 0; i < room.walls_size(); ++i) {
    if (room.walls(i).name() == name) return i;
  }
  return std::nullopt;
}

bool IsBlank(const v1::Room& room, int wall) {
  return std::ranges::none_of(room.openings(),
                              [&](const v1::Opening& one) { return one.wall() == room.walls(wall).name(); });
}

bool GoesByTheDoor(std::string_view words) {
  const std::vector<std::string> all = SideWords(words);
  return std::ranges::any_of(all, [](const std::string& word) {
    const auto has = [&](const char* list) { return IsIn(list, word); };
    return word == "entrance" || std::ranges::any_of(kTurnsFromTheDoor, has);
  });
}

std::optional<int> WallOf(const v1::Room& room, std::string_view words) {
  if (Count(room) < 3 || room.walls_size() != Count(room)) return std::nullopt;
  const std::vector<std::string> all = SideWords(words);
  if (all.empty()) return std::nullopt;
  if (all.size() == 2 && all[0] == "across") {
    const std::optional<int> wall = OneWord(room, all[1]);
    return wall ? LongestFacing(room, (HeadingOf(room, *wall) + 2) % 4) : std::nullopt;
  }
  // "North west": of an octagon the wall between those.
  const auto one = HeadingNamed(room, all[0]), other = HeadingNamed(room, all.back());
  if (one && other && Count(room) > 6) {
    const auto [x, y] = kOutward[static_cast<std::size_t>(*one)];
    const auto [other_x, other_y] = kOutward[static_cast<std::size_t>(*other)];
    return Most(room,
                [&, x = x + other_x, y = y + other_y](int wall) { return std::optional(SeenFrom(room, wall, x, y)); });
  }
  // "Blank far": the far one if it is blank.
  if (all.size() == 2 && all[0] == "blank") {
    const std::optional<int> wall = OneWord(room, all[1]);
    if (wall && IsBlank(room, *wall)) return wall;
  }
  // "The short wall to the left": of the two the left one.
  for (const bool length : {false, true}) {
    for (const std::string& word : all) {
      const std::optional<int> wall = IsIn("long_or_short", word) == length ? OneWord(room, word) : std::nullopt;
      if (wall) return wall;
    }
  }
  return std::nullopt;
}

const v1::Opening* OpeningOf(const v1::Room& room, v1::OpeningKind kind, std::string_view words) {
  const std::vector<Token> said = TokensOf(words);
  const auto leads_there = [&](const v1::Opening& one) {
    const std::vector<Token> described = TokensOf(one.description());
    return std::ranges::any_of(said, [&](const Token& word) {
      return word.text != "door" && std::ranges::find(described, word.text, &Token::text) != described.end();
    });
  };
  const std::optional<int> wall = WallOf(room, words);
  const v1::Opening* meant = nullptr;
  for (const v1::Opening& one : room.openings()) {
    if (one.kind() != kind) continue;
    if (leads_there(one)) return &one;
    const bool there = wall && one.wall() == room.walls(*wall).name();
    if (there && (meant == nullptr || one.width_m() > meant->width_m())) meant = &one;
  }
  return meant;
}

std::optional<int> CornerOf(const v1::Room& room, std::string_view words) {
  if (Count(room) < 3 || room.walls_size() != Count(room)) return std::nullopt;
  if (words.starts_with("across ")) {
    const std::optional<int> corner = CornerOf(room, words.substr(words.find(' ') + 1));
    if (!corner) return std::nullopt;
    return ExtremeCorner(room, CornerAt(room, *corner).x_m(), CornerAt(room, *corner).y_m(), false);
  }
  if (words.starts_with("at ")) {
    const auto kind = words.ends_with("door") ? v1::OPENING_KIND_DOOR : v1::OPENING_KIND_WINDOW;
    const auto opening = std::ranges::find(room.openings(), kind, &v1::Opening::kind);
    const std::optional<int> wall = opening == room.openings().end() ? std::nullopt : WallNamed(room, opening->wall());
    if (!wall) return std::nullopt;
    const v1::Point2 at = PointOn(room, *wall, opening->offset_m() + opening->width_m() / 2);
    return ExtremeCorner(room, at.x_m(), at.y_m(), true);
  }
  std::vector<int> headings;
  for (const std::string& word : SideWords(words)) {
    if (const std::optional<int> heading = HeadingNamed(room, word)) headings.push_back(*heading);
  }
  if (headings.empty()) return std::nullopt;
  const auto door = std::ranges::find(room.openings(), v1::OPENING_KIND_DOOR, &v1::Opening::kind);
  const std::optional<int> wall = door == room.openings().end() ? std::nullopt : WallNamed(room, door->wall());
  // Of two corners the one away from the door: across from its wall, or along it.
  if (headings.size() == 1 && wall) {
    const bool near_start = door->offset_m() + door->width_m() / 2 < WallLength(room, *wall) / 2;
    const bool beside = (headings[0] - HeadingOf(room, *wall)) % 2 != 0;
    headings.push_back((HeadingOf(room, *wall) + (beside ? 2 : near_start ? 1 : 3)) % 4);
  }
  return CornerTowards(room, headings);
}

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
  // Each into the part that has most left: one on either side of a door.
  std::vector<int> in_each(free.size());
  const auto share_m = [&](std::size_t part, int of) { return (free[part].width_m + kBetweenM) / of; };
  for (int i = 0; i < count; ++i) {
    std::size_t best = 0;
    for (std::size_t part = 1; part < free.size(); ++part) {
      if (share_m(part, in_each[part] + 1) > share_m(best, in_each[best] + 1) + kAlmost) best = part;
    }
    ++in_each[best];
  }
  for (std::size_t part = 0; part < free.size(); ++part) {
    const auto width_m = [&] {
      return std::min(size.width_m, RoundDownTo5Cm(share_m(part, in_each[part]) - kBetweenM));
    };
    while (in_each[part] > 0 && width_m() < size.least_m) --in_each[part];
    for (int i = 0; i < in_each[part]; ++i) {
      const double each_m = share_m(part, in_each[part]);
      const double middle_m = free[part].offset_m + each_m * i + (each_m - kBetweenM) / 2;
      spread.push_back({middle_m - width_m() / 2, width_m()});
    }
  }
  return spread;
}

std::vector<WallSpan> WallSpace::Fill(int wall, double pane_m, const OpeningSize& size) const {
  std::vector<WallSpan> all;
  for (const WallSpan& span : Free(wall, size.corner_m)) {
    const int panes = std::max(1, static_cast<int>(std::lround(span.width_m / pane_m)));
    const double share_m = (span.width_m + kBetweenM) / panes, width_m = RoundDownTo5Cm(share_m - kBetweenM);
    for (int i = 0; i < panes && width_m >= std::min(size.least_m, span.width_m); ++i)
      all.push_back({span.offset_m + share_m * i + (share_m - kBetweenM - width_m) / 2, width_m});
  }
  return all;
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
    const v1::Point2 there = PointOn(room_, *at, door.offset_m() + door.width_m() / 2);
    const auto away_m = [&](const v1::Point2& end) {
      return std::hypot(end.x_m() - there.x_m(), end.y_m() - there.y_m());
    };
    const bool end_nearer = away_m(to) < away_m(from);
    return end_nearer == near;
  }
  return std::nullopt;
}

}  // namespace flair::language
