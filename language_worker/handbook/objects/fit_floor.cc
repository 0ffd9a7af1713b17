// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/objects/fit_floor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "language_worker/handbook/rooms/describe_room.h"

namespace flair::language {
namespace {

// [Handbook facts] the recorded rooms cover 20 to 29 % of the floor, small bedrooms up to 49 %.
constexpr double kCoverLimit = 0.45;

double Least(const hb::Extent& extent) { return extent.min() > 0 ? extent.min() : extent.typical(); }
double ToCentimetre(double length_m) { return std::round(length_m * 100) / 100; }

class FloorFitter {
 public:
  FloorFitter(const RoomProgram& program, const Handbook& handbook, const FloorExtent& floor,
              std::vector<LeftOut>& left_out)
      : program_(program), handbook_(handbook), floor_(floor), left_out_(left_out) {
    for (const ProgramItem& item : program.floor_items) items_.push_back(Size(item));
    MarkPrimaries();
  }

  std::vector<SizedItem> Fit() {
    FitSingly();
    if (Cover() > kCoverLimit) ShrinkAll();
    if (Cover() > kCoverLimit) TakeSmaller(/*requested=*/false);
    while (Cover() > kCoverLimit && DropOne(/*requested=*/false)) {
    }
    if (Cover() > kCoverLimit) TakeSmaller(/*requested=*/true);
    while (Cover() > kCoverLimit && DropOne(/*requested=*/true)) {
    }
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
    return sized;
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
    sized.width_m = towards(sized.width_m, Least(furniture.width_m()));
    sized.depth_m = towards(sized.depth_m, Least(furniture.depth_m()));
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
    if (smaller == nullptr) return false;
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
        if (requested || !items_[i].item.requested) changed = Replace(items_[i]) || changed;
      }
    }
  }

  // How much a piece is wanted: the first zone's primary above all, then what the brief asks for, then other primaries;
  // within that by drop order and place in the list.
  int Rank(const SizedItem& sized) const {
    const bool main = sized.primary && !program_.zones.empty() && sized.item.zone == program_.zones.front().name();
    return (main ? 4 : 0) + (sized.item.requested ? 2 : 0) + (sized.primary ? 1 : 0);
  }

  // Leaves out the least wanted piece; none that is requested or the room's main one unless `requested`.
  bool DropOne(bool requested) {
    if (items_.empty()) return false;
    std::size_t victim = 0;
    for (std::size_t i = 1; i < items_.size(); ++i) {
      const int rank = Rank(items_[i]), worst = Rank(items_[victim]);
      if (rank < worst || (rank == worst && items_[i].item.drop_order >= items_[victim].item.drop_order)) victim = i;
    }
    // The last piece stays even when it covers more than the limit: an empty room helps nobody.
    if (items_.size() == 1 && items_[0].item.count == 1) return false;
    SizedItem& sized = items_[victim];
    if (!requested && Rank(sized) >= 2) return false;
    LeaveOut(sized, 1,
             fmt::format("it needs {:g} m x {:g} m, and furniture may cover at most {:.0f} % of a floor of {:.1f} m2",
                         sized.width_m, sized.depth_m, 100 * kCoverLimit, floor_.area_m2));
    if (--sized.item.count == 0) items_.erase(items_.begin() + static_cast<std::ptrdiff_t>(victim));
    return true;
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
    // Several of a kind are told once.
    const bool told = std::any_of(left_out_.begin(), left_out_.end(), [&](const LeftOut& l) { return l.name == name; });
    if (!told && count > 0) left_out_.push_back({name, reason, sized.item.requested});
  }

  const RoomProgram& program_;
  const Handbook& handbook_;
  const FloorExtent& floor_;
  std::vector<LeftOut>& left_out_;
  std::vector<SizedItem> items_;
};

}  // namespace

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
