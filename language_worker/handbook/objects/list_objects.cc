// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/objects/list_objects.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "language_worker/handbook/objects/fit_floor.h"
#include "language_worker/handbook/objects/share_out.h"
#include "language_worker/handbook/parts/brief_parts.h"
#include "language_worker/handbook/program/essentials.h"
#include "language_worker/handbook/program/room_program.h"
#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/reading/piece_words.h"
#include "language_worker/handbook/rooms/describe_room.h"
#include "language_worker/handbook/rooms/wall_run.h"
#include "language_worker/handbook/styling/choose_style.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::language {
namespace {

double Clamp(double value, const hb::Extent& extent) { return std::clamp(value, LeastOf(extent), MostOf(extent)); }

class ObjectLister {
 public:
  ObjectLister(const BriefFacts& facts, const v1::Room& room, const v1::ZonePlan& zones, const Handbook& handbook,
               const Choice& choice)
      : room_(room),
        zones_(zones),
        handbook_(handbook),
        choice_(choice),
        style_(facts, handbook, choice),
        program_(MakeRoomProgram(facts, handbook, FloorArea(room), choice)),
        facts_(facts) {}

  void ListFloor() {
    std::vector<LeftOut> left_out;
    const std::vector<SizedItem> fitting = FitFloor(program_, handbook_, ExtentOf(room_), left_out);
    AddFloorObjects(fitting);
    FitRun(fitting);
    TellLeftOut(left_out);
    TellPlaces(fitting);
  }

  // What completes these floor objects, but nothing of a class that is `there` already: shared out over what can carry
  // it, most wanted first, at most `program.max_tertiaries` and every requested one. What has no host is left out.
  void ListTertiaries(const v1::ObjectList& floor_objects, const std::set<std::string>& there) {
    v1::ObjectList pieces = floor_objects;
    Sharer sharer(program_, pieces, room_, handbook_, facts_);
    for (const RunPlace& place : PlanRun(room_, floor_objects, facts_, handbook_, choice_)) {
      sharer.LimitWall(place.object->id(), place.clear_above_m);
    }
    std::vector<LeftOut> left_out;
    int listed = 0;
    for (const ProgramItem* item : CarriersFirst()) {
      const std::string& name = item->furniture->name();
      if (listed >= program_.max_tertiaries && !item->requested && item->essential == 0) continue;
      const std::vector<HostedPiece> shared = sharer.Share(*item);
      if (!item->requested) listed += static_cast<int>(shared.size());
      if (shared.empty() && item->requested && !there.contains(name)) {
        left_out.push_back({name, "nothing in the room can carry it", true});
      }
      if (there.contains(name)) continue;
      for (std::size_t i = 0; i < shared.size(); ++i) {
        v1::Object& object = AddTertiary(shared[i]);
        const std::string id = IdOf(name);
        object.set_id(IsListedTwice(*item, shared.size()) ? fmt::format("{}_{}", id, ++numbers_[name]) : id);
        *pieces.add_objects() = object;
      }
    }
    TellLeftOut(left_out);
  }

  void TellDifferences() {
    TellNotAsAsked(facts_, handbook_, list_);
    TellMissingEssentials(program_, handbook_, list_);
  }

  v1::ObjectList& list() { return list_; }

 private:
  std::string ZoneId(const std::string& name) const {
    const std::string id = IdOf(name);
    for (const v1::Zone& zone : zones_.zones()) {
      if (zone.id() == id) return id;
    }
    return zones_.zones_size() > 0 ? zones_.zones(0).id() : "";
  }

  // Says so when fewer can sit, or sleep, than the brief speaks of.
  void TellPlaces(const std::vector<SizedItem>& fitting) {
    if (!facts_.people) return;
    const std::string& name = program_.archetype->per_person();
    int places = 0, beds = 0, seats = 0;
    for (const SizedItem& sized : fitting) {
      const hb::Furniture& furniture = *sized.item.furniture;
      const int alone = furniture.name() == name ? std::max(1, PlacesOn(furniture)) : PlacesOn(furniture);
      const int each = name.empty() ? alone : std::max(alone, sized.item.seats);
      if (name.empty() || furniture.name() == name || each > 1) places += sized.item.count * each;
      if (IsSeat(furniture)) seats += sized.item.count;
      if (furniture.category() == "bed") beds += sized.item.count * each;
    }
    places = beds > 0 ? beds : std::max(places, seats);
    if (places >= *facts_.people) return;
    AddDiagnostic(v1::SEVERITY_WARNING, "people_without_place",
                  fmt::format("The brief speaks of {} people{}; the room has places for {}.", *facts_.people,
                              facts_.people_said.empty() ? "" : fmt::format(" (\"{}\")", facts_.people_said), places),
                  list_);
  }

  void TellLeftOut(const std::vector<LeftOut>& left_out) {
    for (const LeftOut& left : left_out) {
      v1::Omission& omission = *list_.add_omissions();
      omission.set_name(left.name);
      omission.set_reason(left.Told());
      omission.set_requested(left.requested);
    }
  }

  // Worktops of which nobody asked for a size are as wide as their run has room for.
  void FitRun(const std::vector<SizedItem>& fitting) {
    std::set<std::string> fitted;
    for (const v1::Object& object : list_.objects()) {
      const bool asked = std::ranges::any_of(fitting, [&](const SizedItem& sized) {
        return sized.item.furniture->name() == object.name() && sized.item.size.width_m.has_value();
      });
      if (!asked) fitted.insert(object.id());
    }
    const v1::ObjectList before = list_;
    for (const RunPlace& place : PlanRun(room_, before, facts_, handbook_, choice_, fitted)) {
      for (v1::Object& object : *list_.mutable_objects()) {
        if (object.id() == place.object->id()) object.set_width_m(place.width_m);
      }
    }
    double covered_m2 = 0;
    for (const v1::Object& object : list_.objects()) covered_m2 += object.width_m() * object.depth_m();
    if (covered_m2 > kCoverLimit * FloorArea(room_)) list_ = before;
  }

  // Floor objects have their final ids from the start, because tertiaries name them as hosts.
  void AddFloorObjects(const std::vector<SizedItem>& sized) {
    std::map<std::string, int> total, number;
    for (const SizedItem& item : sized) total[item.item.furniture->name()] += item.item.count;
    for (const bool primaries : {true, false}) {
      for (const SizedItem& item : sized) {
        for (int i = 0; i < item.item.count; ++i) {
          if ((item.primary && i == 0) != primaries) continue;
          v1::Object& object = AddObject(item.item, primaries ? v1::OBJECT_ROLE_PRIMARY : v1::OBJECT_ROLE_SECONDARY);
          const std::string id = IdOf(object.name());
          object.set_id(total[object.name()] > 1 ? fmt::format("{}_{}", id, ++number[object.name()]) : id);
          object.set_zone_id(ZoneId(item.item.zone));
          object.set_width_m(item.width_m);
          object.set_depth_m(item.depth_m);
          object.set_height_m(std::min(item.height_m, room_.height_m()));
        }
      }
    }
  }

  // Whether the room does without it where it finds no good place: nobody asked for it, and no piece or person needs it
  // for a seat.
  bool IsSpare(const ProgramItem& item) const {
    const bool seat = item.seat_of != nullptr || (facts_.people && PlacesOn(*item.furniture) > 0);
    return !item.requested && item.essential == 0 && !seat;
  }

  // Whether a brief that names pieces names none of the zone, and the room is such a room without it.
  bool IsSpareZone(const std::string& zone) const {
    if (facts_.wishes.empty() || program_.zones.empty() || zone == program_.zones.front().name()) return false;
    return std::ranges::all_of(program_.floor_items,
                               [&](const ProgramItem& item) { return item.zone != zone || IsSpare(item); });
  }

  v1::Object& AddObject(const ProgramItem& item, v1::ObjectRole role) {
    const hb::Furniture& furniture = *item.furniture;
    v1::Object& object = *list_.add_objects();
    object.set_name(furniture.name());
    object.set_role(role);
    object.set_kind(furniture.kind() == hb::FURNITURE_KIND_UNSPECIFIED ? v1::OBJECT_KIND_FLOOR
                                                                       : static_cast<v1::ObjectKind>(furniture.kind()));
    object.set_walk_over(furniture.walk_over());
    object.set_round(furniture.round());
    object.set_sat_at(furniture.sat_at());
    object.set_seat(furniture.has_seat_height_m());
    object.set_category(furniture.category());
    object.set_rim_sides_m(furniture.rim_sides_m());
    object.set_rim_ends_m(furniture.rim_ends_m());
    object.set_requested(item.requested);
    object.set_spare(IsSpare(item) && (role != v1::OBJECT_ROLE_PRIMARY || IsSpareZone(item.zone)));
    object.set_description(style_.Describe(furniture, style_.LookOf(furniture, drawn_++)));
    return object;
  }

  // In the order of the program, but what the brief puts on or beside another thing behind that one.
  std::vector<const ProgramItem*> CarriersFirst() const {
    constexpr int kMostOnEachOther = 4;
    const auto depth_of = [&](const ProgramItem& item) {
      int depth = 0;
      const hb::Furniture* furniture = item.furniture;
      for (const Place* place = CarriedAt(*furniture, facts_); place != nullptr && depth < kMostOnEachOther; ++depth) {
        if (!Lists(program_.tertiary_items, place->target->name())) break;
        place = CarriedAt(*place->target, facts_);
      }
      return depth;
    };
    std::vector<const ProgramItem*> order;
    for (int depth = 0; depth <= kMostOnEachOther; ++depth) {
      for (const ProgramItem& item : program_.tertiary_items) {
        if (depth_of(item) == depth) order.push_back(&item);
      }
    }
    return order;
  }

  // Whether there are several of the class, of one line of the program or of two.
  bool IsListedTwice(const ProgramItem& item, std::size_t shared) const {
    return shared > 1 || std::ranges::count(program_.tertiary_items, item.furniture, &ProgramItem::furniture) > 1;
  }

  v1::Object& AddTertiary(const HostedPiece& piece) {
    const hb::Furniture& furniture = *piece.item->furniture;
    v1::Object& object = AddObject(*piece.item, v1::OBJECT_ROLE_TERTIARY);
    object.set_width_m(furniture.width_m().typical());
    object.set_depth_m(furniture.depth_m().typical());
    object.set_height_m(std::min(furniture.height_m().typical(), 0.9 * room_.height_m()));
    if (piece.host != nullptr) {
      object.set_host_id(piece.host->id());
      object.set_zone_id(piece.host->zone_id());
    } else if (!piece.item->zone.empty()) {
      object.set_zone_id(ZoneId(piece.item->zone));
    }
    SizeByHost(piece, object);
    if (const hb::ObjectEntry* entry = piece.item->entry; entry != nullptr && entry->furniture() == furniture.name()) {
      if (entry->width_m() > 0) object.set_width_m(entry->width_m());
      if (entry->depth_m() > 0) object.set_depth_m(entry->depth_m());
    }
    FitOnHost(piece, object);
    const PieceSize& asked = piece.item->size;
    object.set_width_m(asked.width_m.value_or(object.width_m()));
    object.set_depth_m(asked.depth_m.value_or(object.depth_m()));
    object.set_height_m(std::min(asked.height_m.value_or(object.height_m()), room_.height_m()));
    FitToRoom(object);
    object.set_elevation_m(ElevationOf(furniture, piece.host, object));
    return object;
  }

  static void SizeByHost(const HostedPiece& piece, v1::Object& object) {
    const hb::Furniture& furniture = *piece.item->furniture;
    const double reach_m = 2 * furniture.reach_beyond_target_m();
    if (piece.window != nullptr) object.set_width_m(Clamp(piece.window->width_m() + reach_m, furniture.width_m()));
    if (piece.host == nullptr || !furniture.sized_by_target()) return;
    object.set_width_m(Clamp(piece.host->width_m() + reach_m, furniture.width_m()));
    object.set_depth_m(Clamp(piece.host->depth_m() + reach_m, furniture.depth_m()));
  }

  static void FitOnHost(const HostedPiece& piece, v1::Object& object) {
    if (piece.host == nullptr || piece.item->furniture->kind() != hb::FURNITURE_KIND_SURFACE) return;
    object.set_width_m(std::min(object.width_m(), piece.host->width_m()));
    object.set_depth_m(std::min(object.depth_m(), piece.host->depth_m()));
  }

  // Rugs and lamps never reach from wall to wall.
  void FitToRoom(v1::Object& object) const {
    const FloorExtent floor = ExtentOf(room_);
    object.set_width_m(std::min(object.width_m(), std::max(0.3, floor.width_m - 0.4)));
    object.set_depth_m(std::min(object.depth_m(), std::max(0.3, floor.depth_m - 0.4)));
  }

  double ElevationOf(const hb::Furniture& furniture, const v1::Object* host, v1::Object& object) const {
    const double most_m = std::max(0.0, room_.height_m() - object.height_m());
    switch (furniture.kind()) {
      case hb::FURNITURE_KIND_CEILING:
        return most_m;
      case hb::FURNITURE_KIND_WALL: {
        const bool above = host != nullptr && furniture.gap_above_target_m() > 0;
        const double wanted_m =
            above ? std::max(furniture.elevation_m(), host->height_m() + furniture.gap_above_target_m())
                  : furniture.elevation_m();
        return std::min(wanted_m, std::max(0.0, most_m - 0.05));
      }
      case hb::FURNITURE_KIND_SURFACE: {
        const Place* place = host == nullptr ? nullptr : CarriedAt(furniture, facts_);
        if (place == nullptr) return 0;
        // "On the bookshelf" is on one of its shelves, unless it says "on top".
        const bool on_a_shelf = place->asked->carried() == hb::CARRIED_ON && host->category() == "bookshelf" &&
                                place->said.find("top") == std::string::npos;
        return on_a_shelf || place->asked->carried() == hb::CARRIED_IN ? LevelWithin(*host, object) : 0;
      }
      default:
        return 0;
    }
  }

  // Of what is on a shelf of its host, or in it: from the host's top down. On the top where it is too large for that.
  static double LevelWithin(const v1::Object& host, v1::Object& object) {
    constexpr double kShelf = 0.45, kLeastM = 0.25, kBoardM = 0.03;  // where the middle shelf is, of the height
    if (host.kind() == v1::OBJECT_KIND_SURFACE || host.height_m() < kLeastM) return 0;
    const double above_m = (1 - kShelf) * host.height_m() - kBoardM, below_m = host.height_m() - 2 * kBoardM;
    object.set_width_m(std::min(object.width_m(), host.width_m() - 2 * kBoardM));
    object.set_depth_m(std::min(object.depth_m(), host.depth_m() - kBoardM));
    if (object.height_m() <= above_m) return -above_m - kBoardM;
    return object.height_m() <= below_m ? -below_m - kBoardM : 0;
  }

  const v1::Room& room_;
  const v1::ZonePlan& zones_;
  const Handbook& handbook_;
  const Choice& choice_;
  const StyleChoice style_;
  const RoomProgram program_;
  const BriefFacts& facts_;
  v1::ObjectList list_;
  std::map<std::string, int> numbers_;  // of tertiaries of a class so far
  int drawn_ = 0;
};

// Makes a lister for the brief and has it list.
template <typename List>
absl::StatusOr<v1::ObjectList> Listed(const v1::Brief& brief, const v1::Room& room, const v1::ZonePlan& zones,
                                      const Handbook& handbook, const List& list) {
  ASSIGN_OR_RETURN(const BriefFacts facts, ReadBrief(brief, handbook));
  const Choice choice(brief.seed(), brief.text());
  ObjectLister lister(facts, room, zones, facts.HandbookOr(handbook), choice);
  list(lister);
  return std::move(lister.list());
}

}  // namespace

absl::StatusOr<v1::ObjectList> ListObjects(const v1::Brief& brief, const v1::Room& room, const v1::ZonePlan& zones,
                                           const Handbook& handbook) {
  return Listed(brief, room, zones, handbook, [](ObjectLister& lister) {
    lister.ListFloor();
    lister.ListTertiaries(v1::ObjectList(lister.list()), {});
    lister.TellDifferences();
  });
}

absl::Status TellMissing(const v1::Brief& brief, const v1::Room& room, const Handbook& handbook, v1::ObjectList& list) {
  ASSIGN_OR_RETURN(const BriefFacts facts, ReadBrief(brief, handbook));
  const Choice choice(brief.seed(), brief.text());
  const Handbook& all = facts.HandbookOr(handbook);
  TellMissingEssentials(MakeRoomProgram(facts, all, FloorArea(room), choice), all, list);
  return absl::OkStatus();
}

absl::StatusOr<v1::ObjectList> ListFloorObjects(const v1::Brief& brief, const v1::Room& room, const v1::ZonePlan& zones,
                                                const Handbook& handbook) {
  return Listed(brief, room, zones, handbook, [](ObjectLister& lister) { lister.ListFloor(); });
}

absl::StatusOr<v1::ObjectList> ListTertiaries(const v1::Brief& brief, const v1::Room& room, const v1::ZonePlan& zones,
                                              const v1::ObjectList& objects, const Handbook& handbook) {
  v1::ObjectList floor_objects;
  std::set<std::string> there;
  for (const v1::Object& object : objects.objects()) {
    if (object.role() == v1::OBJECT_ROLE_TERTIARY) {
      there.insert(object.name());
    } else {
      *floor_objects.add_objects() = object;
    }
  }
  return Listed(brief, room, zones, handbook,
                [&](ObjectLister& lister) { lister.ListTertiaries(floor_objects, there); });
}

}  // namespace flair::language
