// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/objects/tertiaries.h"

#include <algorithm>

namespace flair::language {
namespace {

// Share of a top that things on it may cover.
constexpr double kMostCovered = 0.45;
// Pieces up to this footprint find a spot on any top, m2.
constexpr double kSmallM2 = 0.025;

bool IsRoomWord(const std::string& word) {
  return word == "wall" || word == "ceiling" || word == "floor" || word == "window";
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

  // A top takes as many pieces as its class says, as long as a good part of it stays free.
  bool TakePlace(const v1::Object& host, const hb::Furniture& piece) {
    const hb::Furniture* furniture = handbook_.FindFurniture(host.name());
    const int places = furniture == nullptr ? 1 : std::max(1, furniture->top_places());
    const double area_m2 = piece.width_m().typical() * piece.depth_m().typical();
    const double covered_m2 = covered_m2_[host.id()] + area_m2;
    const bool first = taken_[host.id()] == 0;
    const bool full = area_m2 > kSmallM2 && covered_m2 > kMostCovered * host.width_m() * host.depth_m();
    if (taken_[host.id()] >= places || (!first && full)) return false;
    ++taken_[host.id()];
    covered_m2_[host.id()] = covered_m2;
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
  std::map<std::string, int> taken_;
  std::map<std::string, double> covered_m2_;
  std::map<std::string, double> hung_m_;
};

}  // namespace

std::vector<std::string> HostClasses(const ProgramItem& item, const RoomProgram& program) {
  if (item.entry != nullptr && item.entry->hosts_size() > 0) return WithSubstitutes(item.entry->hosts(), program);
  if (item.furniture->hosts_size() > 0) return WithSubstitutes(item.furniture->hosts(), program);
  for (const hb::Relation& relation : item.furniture->relations()) {
    if (relation.targets_size() > 0) return WithSubstitutes(relation.targets(), program);
  }
  return {};
}

std::vector<HostedPiece> ShareOut(const RoomProgram& program, const v1::ObjectList& floor_objects, const v1::Room& room,
                                  const Handbook& handbook) {
  Sharer sharer(program, floor_objects, room, handbook);
  std::vector<HostedPiece> pieces;
  for (const ProgramItem& item : program.tertiary_items) {
    const bool full = static_cast<int>(pieces.size()) >= program.max_tertiaries;
    if (full && !item.requested) continue;
    for (const HostedPiece& piece : sharer.Share(item)) pieces.push_back(piece);
  }
  return pieces;
}

}  // namespace flair::language
