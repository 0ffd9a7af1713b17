// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/rooms/wall_run.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "language_worker/handbook/rooms/asked_run.h"
#include "language_worker/handbook/rooms/walls.h"

namespace flair::language {
namespace {

constexpr double kSmallM = 1e-6;
// Between a door's frame and the first unit; before a door that is open or slides.
constexpr double kFrameM = 0.05, kPassageM = 0.6;
// Gaps up to this under the worktop are filled; a slot narrower than kSlotM is of no use.
constexpr double kFillM = 1.2, kSlotM = 0.4;
// What a corner unit shows beside the unit that begins at its front.
constexpr double kShownM = 0.4;
// Two runs face each other over an aisle; one reaches both from the middle where it is no wider than kGalleyM.
constexpr double kAisleM = 1.0, kGalleyM = 1.6;
// A hob this near to a wall at its side scorches it.
constexpr double kBesideHobM = 0.2;

struct Unit {
  RunPlace place;
  double depth_m, height_m;
  double least_m, most_m;
};
using Units = std::vector<Unit>;

struct Span {
  double from_m, to_m;
  double length_m() const { return to_m - from_m; }
};

// How far a unit has to slide to be within the window's width, or round it.
double OffWindow(const RunPlace& place, const v1::Opening& window) {
  const double aside_m = place.offset_m + place.width_m / 2 - window.offset_m() - window.width_m() / 2;
  return std::abs(aside_m) - std::abs(place.width_m - window.width_m()) / 2;
}

class RunPlanner {
 public:
  // `form` is how the brief wants it to go round the room; `first` comes first of those that are as good.
  RunPlanner(const v1::Room& room, Units units, const AskedRun& asked, RunForm form, int first)
      : room_(room), units_(std::move(units)), asked_(asked), form_(form), first_(first) {
    for (const Unit& unit : units_) depth_m_ = std::max(depth_m_, unit.depth_m);
  }

  Units Best() {
    OfferAll();
    std::ranges::reverse(units_);
    OfferAll();
    return best_;
  }

 private:
  // In their order: straight, round a corner and on walls that face each other.
  void OfferAll() {
    for (int i = 0; i < room_.walls_size(); ++i) {
      const int wall = (first_ + i) % room_.walls_size();
      Straight(units_, wall, [&](const Units& run) { Offer(run, RunForm::kStraight, 0); });
      for (std::size_t k = 0; k < units_.size(); ++k) RoundCorner(wall, k);
      for (std::size_t k = 0; form_ == RunForm::kRoundTwoCorners && k + 2 < units_.size(); ++k) {
        for (std::size_t second = k + 2; second < units_.size(); ++second) RoundTwoCorners(wall, k, second);
      }
      for (std::size_t k = 1; k < units_.size(); ++k) OnFacingWalls(wall, k);
    }
  }

  int Turned(int wall, int by) const { return (wall + by + room_.walls_size()) % room_.walls_size(); }

  // What doors leave of a wall, as deep as the units.
  std::vector<Span> Free(int wall) const {
    const double length_m = WallLength(room_, wall);
    std::vector<Span> taken = {{length_m, length_m}};
    for (const v1::Opening& one : room_.openings()) {
      if (one.kind() != v1::OPENING_KIND_DOOR) continue;
      const double end_m = one.offset_m() + one.width_m();
      const bool swings = one.has_leaf() && one.leaf().swing() == v1::DOOR_SWING_INWARD;
      const double reach_m = (swings ? std::max(kPassageM, one.width_m()) : kPassageM) + kFrameM;
      const auto is_on = [&](int other) { return one.wall() == room_.walls(other).name(); };
      if (is_on(wall)) taken.push_back({one.offset_m() - kFrameM, end_m + kFrameM});
      if (is_on(Turned(wall, -1)) && WallLength(room_, Turned(wall, -1)) - end_m < depth_m_)
        taken.push_back({0, reach_m});
      if (is_on(Turned(wall, 1)) && one.offset_m() < depth_m_) taken.push_back({length_m - reach_m, length_m});
    }
    std::ranges::sort(taken, {}, &Span::from_m);
    std::vector<Span> free;
    double from_m = 0;
    for (const Span& span : taken) {
      if (span.from_m > from_m + kSmallM) free.push_back({from_m, span.from_m});
      from_m = std::max(from_m, span.to_m);
    }
    return free;
  }

  static double WidthOf(const Units& run) {
    double sum_m = 0;
    for (const Unit& unit : run) sum_m += unit.place.width_m;
    return sum_m;
  }

  // Makes worktops wider, or narrower, by so much in all, the widest first; returns what they do not take.
  static double Widen(Units& run, double by_m) {
    std::vector<Unit*> worktops;
    for (Unit& unit : run) worktops.push_back(&unit);
    std::ranges::stable_sort(worktops, std::greater(), [](const Unit* unit) { return unit->place.width_m; });
    for (Unit* unit : worktops) {
      const double before_m = unit->place.width_m;
      const double now_m = std::floor(std::clamp(before_m + by_m, unit->least_m, unit->most_m) * 100 + 1e-4) / 100;
      if (unit->least_m >= unit->most_m) continue;
      unit->place.width_m = now_m;
      by_m -= now_m - before_m;
    }
    return by_m;
  }

  static void PutAt(Units& run, int wall, double offset_m) {
    for (Unit& unit : run) {
      unit.place.wall = wall;
      unit.place.offset_m = offset_m;
      offset_m += unit.place.width_m;
    }
  }

  // All ways to stand in one line on a wall: as wide as a free part of it, at its ends, the basin before a window.
  template <typename Visit>
  void Straight(const Units& units, int wall, const Visit& visit) const {
    for (const Span& span : Free(wall)) {
      Units run = units;
      double over_m = span.length_m() - WidthOf(run);
      if (over_m < 0) over_m = Widen(run, over_m);
      if (over_m < -kSmallM) continue;
      const bool widens = over_m >= kSmallM && over_m <= kFillM;
      for (int width = 0; width < (widens ? 2 : 1); ++width) {
        if (width > 0) Widen(run, over_m);
        for (double from_m : StartsIn(run, wall, span)) {
          PutAt(run, wall, from_m);
          visit(run);
        }
      }
    }
  }

  std::vector<double> StartsIn(const Units& run, int wall, const Span& span) const {
    const double last_m = std::max(span.from_m, span.to_m - WidthOf(run));
    std::vector<double> starts = {span.from_m, last_m};
    double before_m = 0;
    for (const Unit& unit : run) {
      if (unit.place.part == hb::RUN_PART_BASIN) {
        for (const v1::Opening& window : WindowsOn(wall)) {
          const double middle_m = window.offset_m() + window.width_m() / 2 - unit.place.width_m / 2;
          starts.push_back(std::clamp(middle_m - before_m, span.from_m, last_m));
        }
      }
      before_m += unit.place.width_m;
    }
    return starts;
  }

  // Round the corner where a wall ends, which the worktop k fills: before it on that wall, or after it on the next.
  void RoundCorner(int wall, std::size_t k) {
    const int next = Turned(wall, 1);
    if (units_[k].place.part != hb::RUN_PART_WORKTOP || IsReentrant(room_, next)) return;
    const double least_m = units_[k].depth_m + kShownM;
    if (units_[k].most_m < least_m) return;
    for (const bool ends_here : {true, false}) {
      RoundCorner(wall, k, ends_here, least_m, units_[k].most_m);
      // As wide as brings the basin before the window that it is asked for at.
      constexpr double kStepM = 0.05;
      for (double width_m = least_m; asked_.basin_at_window && width_m <= units_[k].most_m; width_m += kStepM)
        RoundCorner(wall, k, ends_here, width_m, width_m);
    }
  }

  void RoundCorner(int wall, std::size_t k, bool ends_here, double least_m, double most_m) {
    const int next = Turned(wall, 1);
    Units corner_unit = units_;
    corner_unit[k].least_m = std::max(corner_unit[k].least_m, least_m);
    corner_unit[k].most_m = most_m;
    corner_unit[k].place.width_m = std::clamp(corner_unit[k].place.width_m, least_m, most_m);
    const auto cut = corner_unit.begin() + static_cast<std::ptrdiff_t>(k) + (ends_here ? 1 : 0);
    Units first(corner_unit.begin(), cut), second(cut, corner_unit.end());
    if (first.empty() || second.empty()) return;
    const double length_m = WallLength(room_, wall), depth_m = corner_unit[k].depth_m;
    std::vector<Span> here = Free(wall), there = Free(next);
    if (here.empty() || there.empty() || here.back().to_m < length_m || there.front().from_m > 0) return;
    if (ends_here) {
      there.front().from_m += depth_m;
    } else {
      here.back().to_m -= depth_m;
    }
    if (!FitTo(first, here.back().length_m()) || !FitTo(second, there.front().length_m())) return;
    PutAt(first, wall, here.back().to_m - WidthOf(first));
    PutAt(second, next, there.front().from_m);
    first.insert(first.end(), second.begin(), second.end());
    Offer(first, RunForm::kRoundCorner, 0.4);
  }

  // Round both ends of the wall behind `wall`: the worktops k and `second` fill its corners, what is between them
  // stands before it.
  void RoundTwoCorners(int wall, std::size_t k, std::size_t second) {
    const int middle_wall = Turned(wall, 1), last_wall = Turned(wall, 2);
    Units all = units_;
    for (const std::size_t corner : {k, second}) {
      Unit& unit = all[corner];
      const double least_m = unit.depth_m + kShownM;
      if (unit.place.part != hb::RUN_PART_WORKTOP || unit.most_m < least_m) return;
      unit.least_m = std::max(unit.least_m, least_m);
      unit.place.width_m = std::max(unit.place.width_m, least_m);
    }
    if (IsReentrant(room_, middle_wall) || IsReentrant(room_, last_wall)) return;
    const auto at = [&](std::size_t i) { return all.begin() + static_cast<std::ptrdiff_t>(i); };
    Units first(all.begin(), at(k + 1)), middle(at(k + 1), at(second)), last(at(second), all.end());
    const double length_m = WallLength(room_, wall);
    const double between_m = WallLength(room_, middle_wall) - all[k].depth_m - all[second].depth_m;
    const std::vector<Span> here = Free(wall), before = Free(middle_wall), there = Free(last_wall);
    if (here.empty() || before.size() != 1 || there.empty() || here.back().to_m < length_m || there.front().from_m > 0)
      return;
    if (!FitTo(first, here.back().length_m()) || !FitTo(middle, between_m) || !FitTo(last, there.front().length_m()))
      return;
    PutAt(first, wall, length_m - WidthOf(first));
    PutAt(middle, middle_wall, all[k].depth_m + (between_m - WidthOf(middle)) / 2);
    PutAt(last, last_wall, 0);
    first.insert(first.end(), middle.begin(), middle.end());
    first.insert(first.end(), last.begin(), last.end());
    Offer(first, RunForm::kRoundTwoCorners, 0.8);
  }

  // Fills what is left, or takes back what is too much.
  static bool FitTo(Units& run, double length_m) {
    const double over_m = length_m - WidthOf(run);
    return (over_m > kFillM ? 0 : Widen(run, over_m)) > -kSmallM;
  }

  void OnFacingWalls(int wall, std::size_t k) {
    if (room_.walls_size() != 4) return;
    const double aisle_m = WallLength(room_, Turned(wall, 1)) - 2 * depth_m_;
    if (aisle_m < kAisleM - 0.15) return;
    const auto cut = units_.begin() + static_cast<std::ptrdiff_t>(k);
    const Units first(units_.begin(), cut);
    Units second(cut, units_.end());
    for (int turn = 0; turn < 2; ++turn) {
      Straight(first, wall, [&](const Units& here) {
        Straight(second, Turned(wall, 2), [&](const Units& there) {
          Units both = here;
          both.insert(both.end(), there.begin(), there.end());
          Offer(both, RunForm::kFacing,
                (aisle_m < kGalleyM ? -0.3 : 1.5) + WithoutWorktop(here) + WithoutWorktop(there));
        });
      });
      std::ranges::reverse(second);
    }
  }

  // A refrigerator alone on the far wall is no run.
  static double WithoutWorktop(const Units& run) {
    return std::ranges::none_of(run, [](const Unit& u) { return u.place.part == hb::RUN_PART_WORKTOP; }) ? 0.8 : 0;
  }

  std::vector<v1::Opening> WindowsOn(int wall) const {
    std::vector<v1::Opening> windows;
    for (const v1::Opening& one : room_.openings()) {
      if (one.kind() == v1::OPENING_KIND_WINDOW && one.wall() == room_.walls(wall).name()) windows.push_back(one);
    }
    return windows;
  }

  void Offer(const Units& run, RunForm form, double cost) {
    constexpr double kOtherForm = 8;
    if (form_ != RunForm::kAny && form != form_) cost += kOtherForm;
    for (std::size_t i = 0; i < run.size(); ++i) cost += CostOf(run, i);
    if (cost >= least_ - kSmallM) return;
    least_ = cost;
    best_ = run;
  }

  // What is wrong with a unit's place.
  double CostOf(const Units& run, std::size_t i) const {
    constexpr double kAsked = 6;
    const Unit& unit = run[i];
    const RunPlace& place = unit.place;
    const double length_m = WallLength(room_, place.wall);
    const auto joins = [&](std::size_t other) {
      return other < run.size() && run[other].place.wall == place.wall &&
             (std::abs(run[other].place.end_m() - place.offset_m) < kSmallM ||
              std::abs(place.end_m() - run[other].place.offset_m) < kSmallM);
    };
    const auto beside = [&](hb::RunPart part) {
      return (joins(i - 1) && run[i - 1].place.part == part) || (joins(i + 1) && run[i + 1].place.part == part);
    };
    const bool before = joins(i - 1), after = joins(i + 1);
    const double left_m = before ? 1 : place.offset_m, right_m = after ? 1 : length_m - place.end_m();
    const auto own = asked_.wall_of.find(place.object->name());
    const bool is_own = own != asked_.wall_of.end();
    double cost = is_own && own->second != place.wall ? kAsked : 0;
    if (!is_own && !asked_.basin_at_window && asked_.wall && *asked_.wall != place.wall) cost += 3;
    if (asked_.others_at_window && !WindowsOn(place.wall).empty()) cost += 2;
    for (const double slot_m : {left_m, right_m}) {
      if (slot_m > kSmallM && slot_m < kSlotM) cost += 0.4;
    }
    for (const AskedRun::AtDoor& asked : asked_.at_doors) {
      if (asked.away && asked.unit != place.object->name()) continue;
      constexpr double kAwayM = 2.2, kEachMetre = 3, kNearM = 1.2, kEachMetreOff = 0.8;
      const v1::Point2 here = PointOn(room_, place.wall, place.offset_m + place.width_m / 2);
      const double apart_m = std::hypot(here.x_m() - asked.door.x_m(), here.y_m() - asked.door.y_m());
      cost +=
          asked.away ? kEachMetre * std::max(0.0, kAwayM - apart_m) : kEachMetreOff * std::max(0.0, apart_m - kNearM);
    }
    double off_window = 1;
    for (const v1::Opening& window : WindowsOn(place.wall)) {
      const double from_m = window.offset_m(), to_m = from_m + window.width_m();
      if (place.end_m() <= from_m + kSmallM || place.offset_m >= to_m - kSmallM) continue;
      off_window = std::min(off_window, OffWindow(place, window) > kSmallM ? 0.5 : 0);
      if (place.part == hb::RUN_PART_HOB) cost += 1.5;
      if (unit.height_m > window.sill_height_m() + kSmallM) cost += place.part == hb::RUN_PART_TALL ? 4 : 0.5;
    }
    switch (place.part) {
      case hb::RUN_PART_TALL:
        return cost + (before && after && !beside(hb::RUN_PART_TALL) ? 2 : 0) + (beside(hb::RUN_PART_HOB) ? 1 : 0);
      case hb::RUN_PART_BASIN:
        return cost + off_window * (asked_.basin_at_window ? kAsked : 1);
      case hb::RUN_PART_HOB:
        return cost + (beside(hb::RUN_PART_WORKTOP) ? 0 : 1.5) + (std::min(left_m, right_m) < kBesideHobM ? 0.7 : 0);
      case hb::RUN_PART_WASHER:
        return cost + (beside(hb::RUN_PART_BASIN) ? 0 : 1);
      default:
        return cost + std::max(0.0, place.object->width_m() - place.width_m);
    }
  }

  const v1::Room& room_;
  Units units_;
  const AskedRun asked_;
  const RunForm form_;
  const int first_;
  double depth_m_ = 0;
  double least_ = HUGE_VAL;
  Units best_;
};

}  // namespace

bool HasForm(const std::vector<RunPlace>& run, RunForm form) {
  std::set<int> walls;
  for (const RunPlace& place : run) walls.insert(place.wall);
  const bool facing = std::ranges::any_of(walls, [&](int wall) { return walls.contains((wall + 2) % 4); });
  if (walls.size() == 2) return form == RunForm::kAny || form == (facing ? RunForm::kFacing : RunForm::kRoundCorner);
  return form == RunForm::kAny || form == (walls.size() == 1 ? RunForm::kStraight : RunForm::kRoundTwoCorners);
}

std::vector<RunPlace> PlanRun(const v1::Room& room, const v1::ObjectList& objects, const BriefFacts& facts,
                              const Handbook& handbook, const Choice& choice, const std::set<std::string>& fitted) {
  Units units;
  std::map<hb::RunPart, int> count;
  for (const v1::Object& object : objects.objects()) {
    const hb::Furniture* furniture = handbook.FindFurniture(object.name());
    if (furniture == nullptr || furniture->run() == hb::RUN_PART_UNSPECIFIED) continue;
    const double width_m = object.width_m();
    const bool fits = fitted.contains(object.id()) && furniture->run() == hb::RUN_PART_WORKTOP;
    units.push_back({{&object, furniture->run(), 0, 0, width_m},
                     object.depth_m(),
                     object.height_m(),
                     fits ? std::min(width_m, LeastOf(furniture->width_m())) : width_m,
                     fits ? std::max(width_m, MostOf(furniture->width_m())) : width_m});
    ++count[furniture->run()];
  }
  const int wet = count[hb::RUN_PART_BASIN], hot = count[hb::RUN_PART_HOB];
  if (wet + hot == 0 || wet > 1 || hot > 1 || units.size() < 2) return {};
  const std::optional<AskedRun> asked = ReadAskedRun(facts, room);
  if (!asked) return {};
  // From one end: see RunPart. The widest worktop is between basin and hob, the others behind the hob.
  std::ranges::stable_sort(units, {}, [](const Unit& unit) { return unit.place.part; });
  const auto part = [](const Unit& unit) { return unit.place.part; };
  const auto worktops = std::ranges::equal_range(units, hb::RUN_PART_WORKTOP, {}, part);
  std::ranges::stable_sort(worktops, std::greater(), [](const Unit& unit) { return unit.place.width_m; });
  if (wet + hot == 2 && worktops.size() > 1) std::rotate(worktops.begin() + 1, worktops.end(), units.end());
  const auto first = static_cast<int>(choice.Index("wall of the run", static_cast<std::size_t>(room.walls_size())));
  std::vector<RunPlace> places;
  for (const Unit& unit : RunPlanner(room, std::move(units), *asked, facts.run_form, first).Best()) {
    RunPlace& place = places.emplace_back(unit.place);
    const double middle_m = place.offset_m + place.width_m / 2;
    place.clear_above_m = WallLength(room, place.wall);
    for (const v1::Opening& one : room.openings()) {
      if (one.kind() != v1::OPENING_KIND_WINDOW || one.wall() != room.walls(place.wall).name()) continue;
      const double off_m = std::max(one.offset_m() - middle_m, middle_m - one.offset_m() - one.width_m());
      place.clear_above_m = std::min(place.clear_above_m, std::max(0.0, 2 * off_m));
      place.at_window |= place.part == hb::RUN_PART_BASIN && OffWindow(place, one) < kSmallM;
    }
  }
  return places;
}

}  // namespace flair::language
