// SPDX-License-Identifier: GPL-3.0-or-later
// The openings of a brief as they are found: joined to those named before, related to each other, contradictions
// settled.
#include <algorithm>
#include <string>
#include <utility>

#include "fmt/format.h"
#include "language_worker/handbook/reading/opening_parts.h"

namespace flair::language {

namespace {

constexpr std::size_t kMostWishes = 12;

using Sides = std::vector<std::string>;

void Inherit(const OpeningWish& from, OpeningWish& to) {
  if (!to.width_m) to.width_m = from.width_m;
  if (!to.height_m) to.height_m = from.height_m;
  if (!to.sill_m) to.sill_m = from.sill_m;
  if (to.width_factor == 1) to.width_factor = from.width_factor;
  if (to.along.at == AlongWall::At::kAny) to.along = from.along;
  if (to.leads_to.empty()) to.leads_to = from.leads_to;
  if (to.name.empty()) to.name = from.name;
  if (to.kind.empty()) to.kind = from.kind;
  if (to.swing == v1::DOOR_SWING_UNSPECIFIED) to.swing = from.swing;
  to.to_ceiling = to.to_ceiling || from.to_ceiling;
  to.outside = to.outside || from.outside;
  to.fills = to.fills || from.fills;
}

}  // namespace

void OpeningList::Add(const OpeningNoun& noun, OpeningSite site) {
  OpeningWish wish = noun.wish;
  if (std::exchange(site.both_ends, false)) {
    OpeningNoun one = noun;
    one.wish.count = 1;
    for (const char* end : {"left", "right"}) {
      one.wish.along = {AlongWall::At::kEnd, end, {}};
      Add(one, site);
    }
    return;
  }
  const auto is_alike = [&](const OpeningWish& one) { return one.door == wish.door; };
  if (noun.further && std::ranges::none_of(openings_.wishes, is_alike)) Add({.door = wish.door, .said = wish.said});
  // Of doors in several walls the others go by the first.
  if (wish.door && site.sides.size() > 1 && IsIn("sides_from_the_door", site.sides[0]))
    site.sides = site.sides == Sides{"left", "right"} ? Sides{"", "far"} : Sides{"", "left"};
  Join(noun, site, wish);
  const std::size_t walls = site.sides.size(), rooms = noun.leads.size(), parts = std::max(walls, rooms);
  if (parts == 0) return Add(wish);
  const int all = wish.count, n = static_cast<int>(parts);
  for (int w = 0; w < n; ++w) {
    const auto at = static_cast<std::size_t>(w);
    if (walls > 0) wish.side = Resolved(site.sides[std::min(at, walls - 1)], wish.door);
    if (at < rooms) {
      wish.leads_to = IsIn("ways_in", noun.leads[at]) ? "" : noun.leads[at];
      wish.name = noun.leads[at] + " door";
      wish.outside = IsIn("open_air", noun.leads[at]);
    }
    const bool each = !wish.counted || all < n;
    wish.count = parts == 1 ? all : each ? 1 : all / n + (w < all % n ? 1 : 0);
    Add(wish);
  }
}

void OpeningList::Add(const OpeningWish& wish) {
  if (wish.count > 0 && openings_.wishes.size() < kMostWishes) openings_.wishes.push_back(wish);
}

// A wall that goes by the opening of the same kind that was named before, or as those see it who look on.
std::string OpeningList::Resolved(const std::string& side, bool door) const {
  const bool any_kind = side == "opposite" || side == "beside";
  if (side != "same" && side != "across same" && !any_kind) {
    if (!onlookers_) return side;
    // They sit in the south, and look north.
    if (side == "left" || side == "right") return side == "left" ? "west" : "east";
    return IsIn("far_sides", side) ? "north" : side;
  }
  const bool across = side != "same" && side != "beside";
  for (std::size_t i = openings_.wishes.size(); i-- > 0;) {
    const OpeningWish& there = openings_.wishes[i];
    if ((!any_kind && there.door != door) || there.side.empty() || there.side.starts_with("across")) continue;
    return across ? "across " + there.side : there.side;
  }
  return across ? "far" : "near";
}

// Takes over what was said before of the same openings: "two windows. The windows are on the east wall."
void OpeningList::Join(const OpeningNoun& noun, const OpeningSite& site, OpeningWish& wish) {
  if (!wish.definite && !noun.part) return;
  for (std::size_t i = 0; i < openings_.wishes.size(); ++i) {
    OpeningWish& there = openings_.wishes[i];
    // "The back door", of "a back door to the yard".
    const bool called = !wish.name.empty() && there.said.find(wish.name) != std::string::npos;
    const bool same_place = called || there.leads_to == wish.leads_to || (wish.outside && there.outside) ||
                            (wish.leads_to.empty() && !wish.door) || (noun.part && there.leads_to.empty());
    const bool same_side = called || there.outside == wish.outside || (noun.part && !there.outside);
    if (called) wish.leads_to.clear(), wish.name.clear();
    if (there.door != wish.door || !same_place || !same_side || there.of_many) continue;
    if (there.side.empty() && there.count > wish.count && !noun.plural) {
      // One of several.
      there.count -= wish.count;
      wish.counted = there.counted;
      return Inherit(there, wish);
    }
    // "Beside the front door ..., and a second door".
    if (noun.further && there.count == 1) continue;
    // "One to the passage and one to the larder".
    if (noun.part && there.count == wish.count && (there.side.empty() == site.sides.empty()) && !there.name.empty())
      continue;
    if (!there.side.empty() && !site.sides.empty() && there.side != site.sides[0]) {
      if (!(wish.door && there.definite && wish.definite)) continue;
      openings_.not_read.push_back(
          fmt::format("The brief says both \"{}\" and \"{}\"; the first counts.", there.said, wish.said));
      wish.count = 0;
      return;
    }
    if (noun.part && !there.side.empty()) continue;
    Inherit(there, wish);
    if (noun.plural || !wish.counted) {
      wish.count = std::max(wish.counted ? wish.count : 1, there.count);
      wish.counted = wish.counted || there.counted;
    }
    if (wish.side.empty() && site.sides.empty()) wish.side = there.side;
    openings_.wishes.erase(openings_.wishes.begin() + static_cast<std::ptrdiff_t>(i));
    return;
  }
}

void OpeningList::Settle() {
  for (const auto& [noun, side] : hints_) {
    const bool placed = std::ranges::any_of(openings_.wishes, [&, door = noun.wish.door](const OpeningWish& one) {
      return one.door == door && !one.side.empty();
    });
    OpeningSite site;
    if (!placed) site.sides = {side};
    if (!placed || (noun.wish.door && !noun.wish.leads_to.empty())) Add(noun, site);
  }
  SettleRelations();
  const auto is_window = [](const OpeningWish& one) { return !one.door; };
  const auto window = std::ranges::find_if(openings_.wishes, is_window);
  const bool meant = openings_.window_meant || openings_.windows_meant;
  if (!openings_.no_windows || (window == openings_.wishes.end() && !meant)) return;
  if (window == openings_.wishes.end()) {
    openings_.not_read.push_back("The brief asks for no windows and speaks of one; there are none.");
    return;
  }
  openings_.not_read.push_back(
      fmt::format("The brief asks for no windows and for \"{}\"; the latter counts.", window->said));
  openings_.no_windows = false;
}

// A door that goes by the window: where that has no wall either it is across from the door, or beside it.
void OpeningList::SettleRelations() {
  std::vector<OpeningWish>& all = openings_.wishes;
  for (std::size_t d = 0; d < all.size(); ++d) {
    const bool across = all[d].side == "across window";
    if (!all[d].door || (!across && all[d].side != "window")) continue;
    const auto is_window = [](const OpeningWish& one) { return !one.door && !one.of_many; };
    const auto window = std::ranges::find_if(all, is_window);
    if (window != all.end() && !window->side.empty() && !IsIn("sides_from_the_door", window->side)) {
      all[d].side = across ? "across " + window->side : window->side;
      continue;
    }
    all[d].side.clear();
    OpeningWish usual;
    usual.said = all[d].said;
    usual.of_many = true;
    OpeningWish& beside = window != all.end() ? *window : usual;
    beside.side = across ? "far" : "near";
    if (window == all.end()) Add(usual);
  }
}

void OpeningList::LookOn() {
  onlookers_ = true;
  openings_.bare_sides.push_back("south");
}

}  // namespace flair::language
