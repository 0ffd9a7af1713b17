// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/objects/list_objects.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "flair/v1/object_list.pb.h"
#include "flair/v1/room.pb.h"
#include "language_worker/handbook/objects/fit_floor.h"
#include "language_worker/handbook/parts/brief_parts.h"
#include "language_worker/handbook/program/essentials.h"
#include "language_worker/handbook/program/room_program.h"
#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/rooms/describe_room.h"
#include "language_worker/handbook/styling/choose_style.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::language {
namespace {

// A tertiary to be made: its class and the floor object that it belongs to (null: the room itself).
struct HostedPiece {
  const ProgramItem* item = nullptr;
  const v1::Object* host = nullptr;
};

// Share of a top that things on it may cover.
constexpr double kMostCovered = 0.45;
// Pieces up to this footprint need no more than a strip beside the largest, m2.
constexpr double kSmallM2 = 0.025;

bool IsRoomWord(const std::string& word) {
  return word == "wall" || word == "ceiling" || word == "floor" || word == "window";
}

// Where a class may be put when the entry says nothing: its hosts, else the partners of its first sentence.
std::vector<std::string> HostClasses(const ProgramItem& item, const RoomProgram& program) {
  if (item.entry != nullptr && item.entry->hosts_size() > 0) return WithSubstitutes(item.entry->hosts(), program);
  if (item.furniture->hosts_size() > 0) return WithSubstitutes(item.furniture->hosts(), program);
  for (const hb::Relation& relation : item.furniture->relations()) {
    if (relation.targets_size() > 0) return WithSubstitutes(relation.targets(), program);
  }
  return {};
}

class Sharer {
 public:
  Sharer(const RoomProgram& program, const v1::ObjectList& floor_objects, const v1::Room& room,
         const Handbook& handbook)
      : program_(program), floor_objects_(floor_objects), handbook_(handbook) {
    for (const v1::Opening& opening : room.openings()) windows_ += opening.kind() == v1::OPENING_KIND_WINDOW ? 1 : 0;
  }

  // The pieces of one line of the program.
  std::vector<HostedPiece> Share(const ProgramItem& item) {
    const hb::Furniture& furniture = *item.furniture;
    std::vector<const v1::Object*> hosts;
    if (!FindHosts(item, hosts)) return {};
    int count = item.count;
    if (item.entry != nullptr && item.entry->per_host() && !hosts.empty()) count *= static_cast<int>(hosts.size());
    if (furniture.at_window()) count = windows_;
    std::vector<HostedPiece> pieces;
    for (int i = 0; i < count; ++i) {
      const v1::Object* host = hosts.empty() ? nullptr : hosts[static_cast<std::size_t>(i) % hosts.size()];
      if (furniture.kind() == hb::FURNITURE_KIND_SURFACE && !TakePlace(*host, furniture)) continue;
      if (host != nullptr && HangsAbove(item) && !TakeWall(*host, furniture)) {
        if (!item.requested && !MayHangAnywhere(item)) continue;
        host = nullptr;
      }
      pieces.push_back({&item, host});
    }
    return pieces;
  }

 private:
  // False when the piece has nowhere to go. No hosts and true: it belongs to the room itself.
  bool FindHosts(const ProgramItem& item, std::vector<const v1::Object*>& hosts) const {
    const bool on_surface = item.furniture->kind() == hb::FURNITURE_KIND_SURFACE;
    const std::vector<std::string> classes = HostClasses(item, program_);
    for (const std::string& name : classes) {
      if (IsRoomWord(name)) return !on_surface && (name != "window" || windows_ > 0);
      for (const v1::Object& object : floor_objects_.objects()) {
        if (object.name() == name) hosts.push_back(&object);
      }
      if (!hosts.empty()) return true;
    }
    if (!on_surface) return classes.empty() || item.requested;
    if (!item.requested) return false;
    for (const v1::Object& object : floor_objects_.objects()) {
      const hb::Furniture* furniture = handbook_.FindFurniture(object.name());
      if (furniture != nullptr && furniture->top_places() > 0) hosts.push_back(&object);
    }
    return !hosts.empty();
  }

  // What of a top is taken.
  struct Top {
    int count = 0;
    double covered_m2 = 0;
    // Of the piece that takes most.
    double width_m = 0, depth_m = 0;
  };

  // Whether the largest piece leaves a strip of the top that a thing of that width fits into.
  static bool LeavesStrip(const v1::Object& host, const Top& top, double width_m) {
    return std::max(host.width_m() - top.width_m, host.depth_m() - top.depth_m) >= width_m;
  }

  // A top takes as many pieces as its class says, as long as a good part of it stays free.
  bool TakePlace(const v1::Object& host, const hb::Furniture& piece) {
    const hb::Furniture* furniture = handbook_.FindFurniture(host.name());
    const int places = furniture == nullptr ? 1 : std::max(1, furniture->top_places());
    const double width_m = piece.width_m().typical(), depth_m = piece.depth_m().typical();
    const double area_m2 = width_m * depth_m;
    Top& top = tops_[host.id()];
    const bool full = area_m2 > kSmallM2 ? top.covered_m2 + area_m2 > kMostCovered * host.width_m() * host.depth_m()
                                         : !LeavesStrip(host, top, std::min(width_m, depth_m));
    if (top.count >= places || (top.count > 0 && full)) return false;
    ++top.count;
    top.covered_m2 += area_m2;
    if (area_m2 > top.width_m * top.depth_m) top.width_m = width_m, top.depth_m = depth_m;
    return true;
  }

  static bool HangsAbove(const ProgramItem& item) {
    if (item.furniture->kind() != hb::FURNITURE_KIND_WALL) return false;
    return item.entry == nullptr || item.entry->sentence().empty() ||
           item.entry->sentence().find("above") != std::string::npos;
  }

  bool MayHangAnywhere(const ProgramItem& item) const {
    const std::vector<std::string> classes = HostClasses(item, program_);
    return std::find(classes.begin(), classes.end(), "wall") != classes.end();
  }

  // The wall above a piece takes one thing, and more only when they fit side by side.
  bool TakeWall(const v1::Object& host, const hb::Furniture& piece) {
    double& hung_m = hung_m_[host.id()];
    if (hung_m > 0 && hung_m + piece.width_m().typical() > host.width_m()) return false;
    hung_m += piece.width_m().typical();
    return true;
  }

  const RoomProgram& program_;
  const v1::ObjectList& floor_objects_;
  const Handbook& handbook_;
  int windows_ = 0;
  std::map<std::string, Top> tops_;
  std::map<std::string, double> hung_m_;
};

// Shares the tertiaries of a program out over the floor objects that can carry them, most wanted first, at most
// `program.max_tertiaries` and every requested one. Pieces whose host is missing or full are left out.
std::vector<HostedPiece> ShareOut(const RoomProgram& program, const v1::ObjectList& floor_objects, const v1::Room& room,
                                  const Handbook& handbook) {
  Sharer sharer(program, floor_objects, room, handbook);
  std::vector<HostedPiece> pieces;
  for (const ProgramItem& item : program.tertiary_items) {
    const bool full = static_cast<int>(pieces.size()) >= program.max_tertiaries;
    if (full && !item.requested && item.essential == 0) continue;
    for (const HostedPiece& piece : sharer.Share(item)) pieces.push_back(piece);
  }
  return pieces;
}

double Clamp(double value, const hb::Extent& extent) { return std::clamp(value, LeastOf(extent), MostOf(extent)); }

class ObjectLister {
 public:
  ObjectLister(const BriefFacts& facts, const v1::Room& room, const v1::ZonePlan& zones, const Handbook& handbook,
               const Choice& choice)
      : room_(room),
        zones_(zones),
        handbook_(handbook),
        style_(facts, handbook, choice),
        program_(MakeRoomProgram(facts, handbook, FloorArea(room), choice)),
        facts_(facts) {}

  void ListFloor() {
    std::vector<LeftOut> left_out;
    const std::vector<SizedItem> fitting = FitFloor(program_, handbook_, ExtentOf(room_), left_out);
    AddFloorObjects(fitting);
    TellLeftOut(left_out);
    TellPlaces(fitting);
  }

  // What completes these floor objects, but nothing of a class that is `there` already.
  void ListTertiaries(const v1::ObjectList& floor_objects, const std::set<std::string>& there) {
    const std::vector<HostedPiece> pieces = ShareOut(program_, floor_objects, room_, handbook_);
    for (const HostedPiece& piece : pieces) {
      if (!there.contains(piece.item->furniture->name())) AddTertiary(piece);
    }
    NameObjects();
    std::vector<LeftOut> left_out;
    for (const ProgramItem& item : program_.tertiary_items) {
      const std::string& name = item.furniture->name();
      const bool listed =
          there.contains(name) ||
          std::any_of(pieces.begin(), pieces.end(), [&](const HostedPiece& piece) { return piece.item == &item; });
      if (item.requested && !listed) left_out.push_back({name, "nothing in the room can carry it", true});
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
    int places = 0, beds = 0;
    for (const SizedItem& sized : fitting) {
      const hb::Furniture& furniture = *sized.item.furniture;
      const int each = furniture.name() == name ? std::max(1, PlacesOn(furniture)) : PlacesOn(furniture);
      if (name.empty() || furniture.name() == name || each > 1) places += sized.item.count * each;
      if (furniture.category() == "bed") beds += sized.item.count * each;
    }
    if (beds > 0) places = beds;
    if (places >= *facts_.people) return;
    AddDiagnostic(v1::SEVERITY_WARNING, "people_without_place",
                  fmt::format("The brief mentions {} people; the room has places for {}.", *facts_.people, places),
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

  v1::Object& AddObject(const ProgramItem& item, v1::ObjectRole role) {
    const hb::Furniture& furniture = *item.furniture;
    v1::Object& object = *list_.add_objects();
    object.set_name(furniture.name());
    object.set_role(role);
    object.set_kind(furniture.kind() == hb::FURNITURE_KIND_UNSPECIFIED ? v1::OBJECT_KIND_FLOOR
                                                                       : static_cast<v1::ObjectKind>(furniture.kind()));
    object.set_walk_over(furniture.walk_over());
    object.set_category(furniture.category());
    object.set_rim_sides_m(furniture.rim_sides_m());
    object.set_rim_ends_m(furniture.rim_ends_m());
    object.set_requested(item.requested);
    object.set_description(style_.Describe(furniture, style_.LookOf(furniture, drawn_++)));
    return object;
  }

  void AddTertiary(const HostedPiece& piece) {
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
  }

  static void SizeByHost(const HostedPiece& piece, v1::Object& object) {
    const hb::Furniture& furniture = *piece.item->furniture;
    if (piece.host == nullptr || !furniture.sized_by_target()) return;
    const double reach_m = 2 * furniture.reach_beyond_target_m();
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

  double ElevationOf(const hb::Furniture& furniture, const v1::Object* host, const v1::Object& object) const {
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
      default:
        return 0;
    }
  }

  // Numbers tertiaries of which there are several.
  void NameObjects() {
    std::map<std::string, int> total, number;
    for (const v1::Object& object : list_.objects()) ++total[object.name()];
    for (v1::Object& object : *list_.mutable_objects()) {
      if (!object.id().empty()) continue;
      const std::string id = IdOf(object.name());
      object.set_id(total[object.name()] > 1 ? fmt::format("{}_{}", id, ++number[object.name()]) : id);
    }
  }

  const v1::Room& room_;
  const v1::ZonePlan& zones_;
  const Handbook& handbook_;
  const StyleChoice style_;
  const RoomProgram program_;
  const BriefFacts& facts_;
  v1::ObjectList list_;
  int drawn_ = 0;
};

// Makes a lister for the brief and has it list.
template <typename List>
absl::StatusOr<v1::ObjectList> Listed(const v1::Brief& brief, const v1::Room& room, const v1::ZonePlan& zones,
                                      const Handbook& handbook, const List& list) {
  ASSIGN_OR_RETURN(const BriefFacts facts, ReadBrief(brief, handbook));
  const Choice choice(brief.seed(), brief.text());
  ObjectLister lister(facts, room, zones, handbook, choice);
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
  TellMissingEssentials(MakeRoomProgram(facts, handbook, FloorArea(room), choice), handbook, list);
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
