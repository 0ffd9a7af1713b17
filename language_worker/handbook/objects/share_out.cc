// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/objects/share_out.h"

#include <algorithm>

namespace flair::language {
namespace {

// Share of a top that things on it may cover.
constexpr double kMostCovered = 0.45, kMostAsked = 0.9;
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

bool HangsAbove(const ProgramItem& item) {
  if (item.furniture->kind() != hb::FURNITURE_KIND_WALL) return false;
  return item.entry == nullptr || item.entry->sentence().empty() ||
         item.entry->sentence().find("above") != std::string::npos;
}

}  // namespace

// What the brief says of what carries the pieces of a class; null where it says nothing.
const Place* CarriedAt(const hb::Furniture& furniture, const BriefFacts& facts) {
  const auto place = std::ranges::find_if(facts.places, [&](const Place& one) {
    return one.furniture == &furniture && one.target != nullptr && one.asked->carried() != hb::CARRIED_UNSPECIFIED;
  });
  return place == facts.places.end() ? nullptr : &*place;
}

Sharer::Sharer(const RoomProgram& program, const v1::ObjectList& pieces, const v1::Room& room, const Handbook& handbook,
               const BriefFacts& facts)
    : program_(program), pieces_(pieces), handbook_(handbook), facts_(facts) {
  for (const v1::Opening& opening : room.openings()) {
    if (opening.kind() == v1::OPENING_KIND_WINDOW) windows_.push_back(&opening);
  }
}

std::vector<HostedPiece> Sharer::Share(const ProgramItem& item) {
  const hb::Furniture& furniture = *item.furniture;
  std::vector<const v1::Object*> hosts;
  if (!FindHosts(item, hosts)) return {};
  int count = item.count;
  const bool told = item.requested && item.count > 1;
  if (item.entry != nullptr && item.entry->per_host() && !told && !hosts.empty())
    count *= static_cast<int>(hosts.size());
  if (furniture.at_window()) count = static_cast<int>(windows_.size());
  std::vector<HostedPiece> pieces;
  const bool on_a_top = furniture.kind() == hb::FURNITURE_KIND_SURFACE;
  const bool put_there = CarriedAt(furniture, facts_) != nullptr;
  for (int i = 0; i < count; ++i) {
    const v1::Object* host = hosts.empty() ? nullptr : hosts[static_cast<std::size_t>(i) % hosts.size()];
    if (on_a_top && !TakePlace(*host, furniture, put_there)) {
      // What is asked for goes to another one that has room.
      const auto other = std::ranges::find_if(
          hosts, [&](const v1::Object* one) { return item.requested && TakePlace(*one, furniture, put_there); });
      if (other == hosts.end()) continue;
      host = *other;
    }
    if (host != nullptr && HangsAbove(item) && !TakeWall(*host, furniture)) {
      if (!item.requested && !MayHangAnywhere(item)) continue;
      host = nullptr;
    }
    pieces.push_back({&item, host, furniture.at_window() ? windows_[static_cast<std::size_t>(i)] : nullptr});
  }
  return pieces;
}

// False when the piece has nowhere to go. No hosts and true: it belongs to the room itself.
bool Sharer::FindHosts(const ProgramItem& item, std::vector<const v1::Object*>& hosts) const {
  const bool on_surface = item.furniture->kind() == hb::FURNITURE_KIND_SURFACE;
  if (FindToldHosts(*item.furniture, hosts)) return true;
  std::vector<std::string> classes = HostClasses(item, program_);
  // What was asked for stands where its class may, wherever the room usually has it.
  if (item.requested && on_surface) {
    for (const std::string& host : WithSubstitutes(item.furniture->hosts(), program_)) classes.push_back(host);
  }
  for (const std::string& name : classes) {
    if (IsRoomWord(name) && on_surface) continue;
    if (IsRoomWord(name)) return name != "window" || !windows_.empty();
    for (const v1::Object& object : pieces_.objects()) {
      const auto wall = free_wall_m_.find(object.id());
      const bool behind_window = item.furniture->kind() == hb::FURNITURE_KIND_WALL && wall != free_wall_m_.end() &&
                                 wall->second < item.furniture->width_m().typical();
      if (object.name() == name && !behind_window) hosts.push_back(&object);
    }
    if (!hosts.empty()) return true;
  }
  if (!on_surface) return classes.empty() || item.requested;
  if (!item.requested) return false;
  for (const v1::Object& object : pieces_.objects()) {
    const hb::Furniture* furniture = handbook_.FindFurniture(object.name());
    if (furniture != nullptr && furniture->top_places() > 0) hosts.push_back(&object);
  }
  return !hosts.empty();
}

// Those that the brief puts it on: the mouse beside the keyboard lies where that one does.
bool Sharer::FindToldHosts(const hb::Furniture& furniture, std::vector<const v1::Object*>& hosts) const {
  const Place* place = CarriedAt(furniture, facts_);
  if (place == nullptr) return false;
  for (const std::string& name : WithSubstitutes(std::array{place->target->name()}, program_)) {
    for (const v1::Object& object : pieces_.objects()) {
      if (object.name() != name) continue;
      const bool along = place->asked->carried() == hb::CARRIED_ALONG && object.kind() != v1::OBJECT_KIND_FLOOR;
      const auto host = std::ranges::find(pieces_.objects(), object.host_id(), &v1::Object::id);
      if (!along) hosts.push_back(&object);
      if (along && host != pieces_.objects().end()) hosts.push_back(&*host);
    }
    if (!hosts.empty()) return true;
  }
  return false;
}

// A top takes as many pieces as its class says, as long as a good part of it stays free; what the brief itself puts
// there may cover most of it.
bool Sharer::TakePlace(const v1::Object& host, const hb::Furniture& piece, bool put_there) {
  const hb::Furniture* furniture = handbook_.FindFurniture(host.name());
  const int places = furniture == nullptr ? 1 : std::max(1, furniture->top_places());
  const double width_m = piece.width_m().typical(), depth_m = piece.depth_m().typical();
  const double area_m2 = width_m * depth_m, top_m2 = host.width_m() * host.depth_m();
  Top& top = tops_[host.id()];
  // A strip beside the largest piece.
  const double strip_m = std::max(host.width_m() - top.width_m, host.depth_m() - top.depth_m);
  const bool full = put_there            ? top.covered_m2 + area_m2 > kMostAsked * top_m2
                    : area_m2 > kSmallM2 ? top.covered_m2 + area_m2 > kMostCovered * top_m2
                                         : strip_m < std::min(width_m, depth_m);
  if ((top.count >= places && !put_there) || (top.count > 0 && full)) return false;
  ++top.count;
  top.covered_m2 += area_m2;
  if (area_m2 > top.width_m * top.depth_m) top.width_m = width_m, top.depth_m = depth_m;
  return true;
}

bool Sharer::MayHangAnywhere(const ProgramItem& item) const {
  const std::vector<std::string> classes = HostClasses(item, program_);
  return std::find(classes.begin(), classes.end(), "wall") != classes.end();
}

// The wall above a piece takes one thing, and more only when they fit side by side.
bool Sharer::TakeWall(const v1::Object& host, const hb::Furniture& piece) {
  double& hung_m = hung_m_[host.id()];
  if (hung_m > 0 && hung_m + piece.width_m().typical() > host.width_m()) return false;
  hung_m += piece.width_m().typical();
  return true;
}

}  // namespace flair::language
