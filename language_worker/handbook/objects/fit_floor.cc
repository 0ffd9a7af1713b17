// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/objects/fit_floor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "language_worker/handbook/rooms/describe_room.h"

namespace flair::language {
namespace {

// What the brief asks for may cover a little more before any of it goes, and what is small always finds a place.
constexpr double kCoverLimitIfAsked = 0.52, kCoverLimitIfOptional = 0.32, kSmallAskedM2 = 0.25;

bool IsEssential(const ProgramItem& item) { return item.count <= item.essential; }
bool IsAskedFor(const ProgramItem& item) { return item.requested && !item.optional; }
double ToCentimetre(double length_m) { return std::round(length_m * 100) / 100; }

class FloorFitter {
 public:
  FloorFitter(const RoomProgram& program, const Handbook& handbook, const FloorExtent& floor,
              std::vector<LeftOut>& left_out)
      : program_(program), handbook_(handbook), floor_(floor), left_out_(left_out) {
    for (const ProgramItem& item : program.floor_items) {
      items_.push_back(Size(item));
      asked_[item.furniture->name()] += item.count;
    }
    MarkPrimaries();
    for (SizedItem& sized : items_) {
      const PieceSize& asked = sized.item.size;
      sized.width_m = asked.width_m.value_or(sized.width_m);
      sized.depth_m = asked.depth_m.value_or(sized.depth_m);
      sized.height_m = asked.height_m.value_or(sized.height_m);
    }
  }

  std::vector<SizedItem> Fit() {
    FitSingly();
    if (Cover() > limit_) ShrinkAll();
    if (Cover() > limit_) TakeSmaller(/*requested=*/false);
    while (Cover() > kCoverLimit && DropOne(/*requested=*/false)) {
    }
    limit_ = kCoverLimitIfAsked;
    if (Cover() > limit_) TakeSmaller(/*requested=*/true);
    while (Cover() > kCoverLimit && DropOne(/*requested=*/true)) {
    }
    // "An island only if one can still walk round everything".
    limit_ = kCoverLimitIfOptional;
    for (SizedItem& sized : items_) {
      if (!sized.item.optional || IsSmall(sized) || Cover() <= limit_) continue;
      LeaveOut(sized, sized.item.count, Why(sized));
      DropSeatsOf(static_cast<std::size_t>(&sized - items_.data()), 0);
      sized.item.count = 0;
    }
    EraseEmpty();
    TellReplacements();
    return std::move(items_);
  }

 private:
  static SizedItem Size(const ProgramItem& item) {
    const hb::Furniture& furniture = *item.furniture;
    SizedItem sized{item, furniture.width_m().typical(), furniture.depth_m().typical(), furniture.height_m().typical()};
    if (item.entry != nullptr && item.entry->furniture() == furniture.name()) {
      if (item.entry->width_m() > 0) sized.width_m = item.entry->width_m();
      if (item.entry->depth_m() > 0) sized.depth_m = item.entry->depth_m();
      if (item.entry->height_m() > 0) sized.height_m = item.entry->height_m();
    }
    if (item.seats > 0 && SeatsRound(furniture, sized.width_m, sized.depth_m) > 0) SizeForSeats(item, sized);
    return sized;
  }

  // A table is as long as those who sit at it need; one of several no longer.
  static void SizeForSeats(const ProgramItem& item, SizedItem& sized) {
    const hb::Furniture& table = *item.furniture;
    const bool round = table.category() == "round_table";
    const double start_m = item.count > 1 || item.seats <= 2 ? LeastOf(table.width_m()) : sized.width_m;
    sized.width_m = WidthForSeats(table, item.seats, start_m, sized.depth_m);
    if (round) sized.depth_m = sized.width_m;
  }

  // One primary a zone: the first of the zone's list that is there, else the zone's first piece.
  void MarkPrimaries() {
    for (const hb::ZoneSpec& zone : program_.zones) {
      SizedItem* primary = nullptr;
      for (const std::string& name : zone.primaries()) {
        for (SizedItem& sized : items_) {
          if (primary == nullptr && sized.item.zone == zone.name() && sized.item.furniture->name() == name)
            primary = &sized;
        }
      }
      for (SizedItem& sized : items_) {
        if (primary == nullptr && sized.item.zone == zone.name()) primary = &sized;
      }
      if (primary == nullptr) continue;
      primary->primary = true;
      for (double* side : {&primary->width_m, &primary->depth_m, &primary->height_m}) {
        *side = ToCentimetre(*side * program_.primary_scale);
      }
    }
  }

  static bool IsSmall(const SizedItem& sized) { return sized.width_m * sized.depth_m <= kSmallAskedM2; }

  double Cover() const {
    double area_m2 = 0;
    for (const SizedItem& sized : items_) area_m2 += sized.area_m2();
    return area_m2 / floor_.area_m2;
  }

  bool FitsAlone(double width_m, double depth_m) const {
    return std::max(width_m, depth_m) <= std::max(floor_.width_m, floor_.depth_m) &&
           std::min(width_m, depth_m) <= std::min(floor_.width_m, floor_.depth_m);
  }

  // Pieces that do not fit through the room's sides at all become smaller, become another class, or go.
  void FitSingly() {
    std::vector<SizedItem> kept;
    for (SizedItem& sized : items_) {
      if (!FitsAlone(sized.width_m, sized.depth_m)) Shrink(sized, 1);
      if (!FitsAlone(sized.width_m, sized.depth_m)) Replace(sized);
      if (FitsAlone(sized.width_m, sized.depth_m)) {
        kept.push_back(sized);
      } else {
        LeaveOut(sized, sized.item.count,
                 fmt::format("at {:g} m x {:g} m it is larger than the room ({:g} m x {:g} m)", sized.width_m,
                             sized.depth_m, floor_.width_m, floor_.depth_m));
      }
    }
    items_ = std::move(kept);
  }

  // Moves the size towards the class's least by `share` of the way.
  static void Shrink(SizedItem& sized, double share) {
    const hb::Furniture& furniture = *sized.item.furniture;
    const auto towards = [&](double now_m, double least_m) {
      return least_m < now_m ? ToCentimetre(now_m + share * (least_m - now_m)) : now_m;
    };
    if (!sized.item.size.width_m) sized.width_m = towards(sized.width_m, LeastOf(furniture.width_m()));
    if (!sized.item.size.depth_m) sized.depth_m = towards(sized.depth_m, LeastOf(furniture.depth_m()));
  }

  void ShrinkAll() {
    const std::vector<SizedItem> before = items_;
    for (int step = 1; step <= 4 && Cover() > kCoverLimit; ++step) {
      items_ = before;
      for (SizedItem& sized : items_) Shrink(sized, step / 4.0);
    }
  }

  bool Replace(SizedItem& sized) {
    const hb::Furniture* smaller = handbook_.FindFurniture(sized.item.furniture->smaller());
    if (smaller == nullptr || sized.item.size.any()) return false;
    const hb::Furniture* wanted = sized.wanted != nullptr ? sized.wanted : sized.item.furniture;
    sized.item.furniture = smaller;
    const bool primary = sized.primary;
    sized = Size(sized.item);
    sized.wanted = wanted;
    sized.primary = primary;
    Shrink(sized, 1);
    return true;
  }

  // Smaller classes for all pieces, or for those that nobody asked for by name, from the end of the list, as often as
  // needed.
  void TakeSmaller(bool requested) {
    for (bool changed = true; changed && Cover() > kCoverLimit;) {
      changed = false;
      for (std::size_t i = items_.size(); i-- > 0 && Cover() > kCoverLimit;) {
        if (requested || !IsAskedFor(items_[i].item)) changed = Replace(items_[i]) || changed;
      }
    }
  }

  // How much a piece is wanted: what the brief asks for above all, then what the room cannot do without and the first
  // zone's primary, then other primaries; within that by drop order and place in the list.
  int Rank(const SizedItem& sized) const {
    const bool main = sized.primary && !program_.zones.empty() && sized.item.zone == program_.zones.front().name();
    return (IsAskedFor(sized.item) ? 8 : 0) + (IsEssential(sized.item) ? 4 : 0) + (main ? 2 : 0) +
           (sized.primary ? 1 : 0);
  }

  // Whether it goes with the piece that it is pulled up to, not by itself.
  bool GoesWithAnother(const SizedItem& seat) const {
    return std::ranges::any_of(items_, [&](const SizedItem& host) { return IsSeatAt(seat, host); });
  }

  static bool IsSeatAt(const SizedItem& seat, const SizedItem& host) {
    return seat.item.seat_of != nullptr && seat.item.zone == host.item.zone &&
           (seat.item.seat_of == host.item.furniture || seat.item.seat_of == host.wanted);
  }

  // Leaves out the least wanted piece; none that is requested or the room's main one unless `requested`.
  bool DropOne(bool requested) {
    std::size_t victim = items_.size();
    for (std::size_t i = 0; i < items_.size(); ++i) {
      if (GoesWithAnother(items_[i]) || (IsAskedFor(items_[i].item) && IsSmall(items_[i]))) continue;
      const bool first = victim == items_.size();
      const int rank = Rank(items_[i]), worst = first ? 0 : Rank(items_[victim]);
      const bool later = !first && rank == worst && items_[i].item.drop_order >= items_[victim].item.drop_order;
      if (first || rank < worst || later) victim = i;
    }
    if (victim == items_.size()) return false;
    if (!requested && Rank(items_[victim]) >= 2) return false;
    if (items_[victim].item.count == 1) {
      // A table loses its chairs before it goes itself, but not the last two.
      for (SizedItem& seat : items_) {
        if (!IsSeatAt(seat, items_[victim]) || seat.item.count <= 2) continue;
        LeaveOut(seat, 1, Why(seat));
        --seat.item.count;
        return true;
      }
      // The last piece stays even when it covers more than the limit: an empty room helps nobody.
      const auto others =
          std::ranges::count_if(items_, [&](const SizedItem& other) { return !IsSeatAt(other, items_[victim]); });
      if (others == 1) return DropSeatsOf(victim, 0) && EraseEmpty();
    }
    LeaveOut(items_[victim], 1, Why(items_[victim]));
    DropSeatsOf(victim, items_[victim].item.count - 1);
    --items_[victim].item.count;
    return EraseEmpty();
  }

  bool EraseEmpty() {
    std::erase_if(items_, [](const SizedItem& sized) { return sized.item.count == 0; });
    return true;
  }

  // Keeps the seats of as many hosts; whether any went.
  bool DropSeatsOf(std::size_t victim, int hosts_left) {
    bool dropped = false;
    const SizedItem host = items_[victim];
    for (SizedItem& seat : items_) {
      if (!IsSeatAt(seat, host)) continue;
      const int each = (seat.item.count + host.item.count - 1) / host.item.count;
      const int gone = std::max(0, seat.item.count - each * hosts_left);
      LeaveOut(seat, gone, Why(seat));
      seat.item.count -= gone;
      dropped = dropped || gone > 0;
    }
    return dropped;
  }

  std::string Why(const SizedItem& sized) const {
    return fmt::format("it needs {:g} m x {:g} m, and furniture may cover at most {:.0f} % of a floor of {:.1f} m2",
                       sized.width_m, sized.depth_m, 100 * limit_, floor_.area_m2);
  }

  // Wishes of which a smaller class was taken.
  void TellReplacements() {
    for (const SizedItem& sized : items_) {
      if (sized.wanted == nullptr || !sized.item.requested) continue;
      LeaveOut(sized, sized.item.count,
               fmt::format("on {:.1f} m2 of floor the room takes the smaller {} instead", floor_.area_m2,
                           sized.item.furniture->name()));
    }
  }

  void LeaveOut(const SizedItem& sized, int count, const std::string& reason) {
    const std::string& name = (sized.wanted != nullptr ? sized.wanted : sized.item.furniture)->name();
    if (count < 1) return;
    // Several of a kind are told once, with their number.
    const auto told = std::ranges::find_if(left_out_, [&](const LeftOut& l) { return l.name == name; });
    if (told != left_out_.end()) {
      told->count = std::min(told->count + count, told->asked);
      return;
    }
    const int asked = asked_.contains(name) ? asked_.at(name) : count;
    const std::string why = sized.item.optional ? "the brief wants it only if there is room, and " + reason : reason;
    left_out_.push_back({name, why, IsAskedFor(sized.item), count, asked});
  }

  const RoomProgram& program_;
  const Handbook& handbook_;
  const FloorExtent& floor_;
  std::vector<LeftOut>& left_out_;
  std::vector<SizedItem> items_;
  double limit_ = kCoverLimit;        // share of the floor
  std::map<std::string, int> asked_;  // by class
};

}  // namespace

std::string LeftOut::Told() const {
  if (asked < 2) return reason;
  return count == asked ? fmt::format("all {}: {}", asked, reason) : fmt::format("{} of {}: {}", count, asked, reason);
}

FloorExtent ExtentOf(const v1::Room& room) {
  FloorExtent extent;
  for (const v1::Point2& vertex : room.floor().vertices()) {
    extent.width_m = std::max(extent.width_m, vertex.x_m());
    extent.depth_m = std::max(extent.depth_m, vertex.y_m());
  }
  extent.area_m2 = FloorArea(room);
  return extent;
}

std::vector<SizedItem> FitFloor(const RoomProgram& program, const Handbook& handbook, const FloorExtent& floor,
                                std::vector<LeftOut>& left_out) {
  return FloorFitter(program, handbook, floor, left_out).Fit();
}

}  // namespace flair::language
