// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/program/seats.h"

#include <algorithm>
#include <vector>

#include "language_worker/handbook/reading/piece_words.h"

namespace flair::language {

bool Seats::IsWished(const hb::Furniture& furniture) const {
  return std::ranges::any_of(facts_.wishes, [&](const Wish& wish) { return wish.furniture == &furniture; });
}

void Seats::SeatPeople() {
  SeatAsAsked();
  CountPeople();
}

void Seats::SeatAt(const hb::Furniture& furniture, int count, int seats, const std::string& zone) {
  for (const hb::ObjectEntry& companion : furniture.companions()) {
    const hb::Furniture* seat = handbook_.FindFurniture(companion.furniture());
    if (seat == nullptr || !IsSeat(*seat) || (seats == 0 && SitsOtherwise(furniture))) continue;
    const int wanted = count * (seats > 0 ? seats : std::max(1, companion.count()));
    const auto there = std::ranges::find_if(program_.floor_items, [&](const ProgramItem& item) {
      const bool of_another = item.seat_of != nullptr && item.seat_of != &furniture && seats > 0;
      return item.furniture == seat && item.zone == zone && !of_another;
    });
    if (there == program_.floor_items.end()) {
      if (IsWished(*seat) && seats == 0) continue;
      program_.floor_items.push_back({seat, &companion, wanted, zone, false, companion.drop_order(), 0, &furniture});
    } else if (!there->requested) {
      there->count = seats > 0 || count > 1 ? wanted : std::max(there->count, wanted);
      there->seat_of = &furniture;
    }
    return;
  }
  // Nobody sits at a work table unless the brief says so.
  const auto& all = handbook_.contents().furniture();
  const auto other = std::ranges::find_if(
      all, [&](const hb::Furniture& one) { return seats > 0 && IsSeat(one) && StandsWith(one, furniture); });
  if (other != all.end())
    program_.floor_items.push_back({&*other, nullptr, count * seats, zone, false, 0, 0, &furniture});
}

bool Seats::SitsOtherwise(const hb::Furniture& table) const {
  // Who comes in a wheelchair rolls under the desk.
  const hb::Furniture* usual = SeatOf(table, handbook_);
  for (const hb::Changes* changes : program_.changes) {
    if (usual != nullptr && Includes(changes->removals(), usual->name())) return true;
  }
  const auto wish = std::ranges::find(facts_.wishes, &table, &Wish::furniture);
  if (wish == facts_.wishes.end() || !(table.category().ends_with("table") || table.category() == "desk")) return false;
  // "Two stools at a fold-down table".
  for (const Place& place : facts_.places) {
    const std::string& seat = place.furniture->category();
    if (place.target == &table && table.category() != "desk" && (seat == "stool" || seat == "bench")) return true;
  }
  const auto next =
      std::find_if(wish + 1, facts_.wishes.end(), [](const Wish& other) { return IsFloorPiece(*other.furniture); });
  if (next == facts_.wishes.end()) return false;
  const std::string& category = next->furniture->category();
  if (table.category() != "desk") return category == "stool" || category == "bench";
  // Nobody works from a bean bag, nor from what is named further on.
  return category == "stool" && next->furniture->has_seat_height_m() && next == wish + 1 && next->count == wish->count;
}

void Seats::EraseUnasked(const std::function<bool(const ProgramItem&)>& goes) {
  std::vector<const hb::Furniture*> gone;
  std::erase_if(program_.floor_items, [&](const ProgramItem& item) {
    if (item.requested || !goes(item)) return false;
    gone.push_back(item.furniture);
    return true;
  });
  for (const hb::Furniture* host : gone) {
    const hb::Furniture* seat = SeatOf(*host, handbook_);
    if (seat != nullptr) RemoveUnaccompanied(seat->name());
  }
}

void Seats::RemoveUnaccompanied(const std::string& name) {
  for (const ProgramItem& item : program_.floor_items) {
    if (item.requested && item.furniture->name() == name) return;
    for (const hb::ObjectEntry& companion : item.furniture->companions()) {
      if (companion.furniture() == name) return;
    }
  }
  Remove(name, program_);
}

// Armchairs round a table are its seats: the usual chairs stay away.
void Seats::SeatAsAsked() {
  for (const Place& place : facts_.places) {
    const bool seats =
        place.target != nullptr && !place.asked->text_of_many().empty() && PlacesOn(*place.furniture) > 0;
    if (!seats || SeatOf(*place.target, handbook_) == place.furniture) continue;
    EraseUnasked([&](const ProgramItem& item) { return item.seat_of == place.target; });
  }
}

// The class that each person has a place at, and the seats at each of it. Seats at a table are the table's.
void Seats::CountPeople() {
  if (!facts_.people) return;
  if (SeatPeopleOnBenches()) return;
  // "Seats for 24, mostly at tables for two."
  for (const Wish& wish : facts_.wishes) {
    const auto table = std::ranges::find(program_.floor_items, wish.furniture, &ProgramItem::furniture);
    if (wish.counted || wish.seats == 0 || table == program_.floor_items.end()) continue;
    table->count = std::min(kMostOfAKind, (*facts_.people + wish.seats - 1) / wish.seats);
    return SeatAt(*wish.furniture, table->count, wish.seats, std::string(table->zone));
  }
  // "Seats 16. Chairs charcoal": one each.
  for (const Wish& wish : facts_.wishes) {
    const auto seat = std::ranges::find(program_.floor_items, wish.furniture, &ProgramItem::furniture);
    if (wish.counted || wish.count < 2 || !IsSeat(*wish.furniture) || seat == program_.floor_items.end()) continue;
    seat->count = std::min(kMostOfAKind, *facts_.people);
    return EraseUnasked([&](const ProgramItem& item) { return IsSeat(*item.furniture); });
  }
  std::string name = program_.archetype->per_person();
  if (name.empty()) return SeatPeopleAnywhere();
  for (const auto& [went, came] : program_.substitutes) {
    if (went == name) name = came;
  }
  if (SeatPeopleInGroups(name) || SeatPeopleAtKin(name)) return;
  auto item =
      std::ranges::find_if(program_.floor_items, [&](const ProgramItem& one) { return one.furniture->name() == name; });
  const bool counted = std::ranges::any_of(
      facts_.wishes, [&](const Wish& wish) { return wish.furniture->name() == name && wish.counted; });
  if (item != program_.floor_items.end() && item->requested && counted) return;
  if (item == program_.floor_items.end()) {
    const hb::Furniture* furniture = handbook_.FindFurniture(name);
    if (furniture == nullptr || std::ranges::find(facts_.refusals, furniture) != facts_.refusals.end()) return;
    program_.floor_items.push_back({furniture, nullptr, 1, HomeOf(*furniture, program_)});
    item = program_.floor_items.end() - 1;
  }
  const int places = std::max(1, PlacesOn(*item->furniture));
  // A teacher's desk is not instead of theirs.
  item->requested = item->requested || SeatOf(*item->furniture, handbook_) != nullptr;
  if (!item->requested || item->in_each == 0)
    item->in_each = facts_.people_in.each, item->in_rows = facts_.people_in.rows;
  item->count = std::min(kMostOfAKind, (*facts_.people + places - 1) / places);
  const std::string zone = item->zone;
  const hb::Furniture& furniture = *item->furniture;
  SeatAt(furniture, item->count, 0, zone);
  // Eight recliners before a screen leave no one to sit on a sofa.
  if (furniture.category() != "armchair") return;
  EraseUnasked([&](const ProgramItem& other) {
    const bool before_it = other.furniture->category() == "coffee_table" || other.furniture->category() == "side_table";
    return other.furniture != &furniture &&
           (before_it || (PlacesOn(*other.furniture) > 0 && !IsSeat(*other.furniture)));
  });
}

// Who sits on the benches of a table needs no chair: as many tables as it takes, where nobody counts them.
bool Seats::SeatPeopleOnBenches() {
  const auto bench = std::ranges::find_if(program_.floor_items, [](const ProgramItem& item) {
    return item.requested && item.seat_of != nullptr && item.furniture->category() == "bench";
  });
  if (bench == program_.floor_items.end()) return false;
  const auto host = std::ranges::find(program_.floor_items, bench->seat_of, &ProgramItem::furniture);
  const bool counted = std::ranges::any_of(facts_.wishes, [&](const Wish& wish) {
    return wish.counted && (wish.furniture == bench->furniture || wish.furniture == bench->seat_of);
  });
  if (counted || host == program_.floor_items.end()) return true;
  const int at_each = 2 * std::max(1, PlacesOn(*bench->furniture));
  host->count = std::min(kMostOfAKind / 2, (*facts_.people + at_each - 1) / at_each);
  bench->count = 2 * host->count;
  return true;
}

// Twenty-four pupils in groups of four have six tables for as many, where such stand in for the usual desks.
bool Seats::SeatPeopleInGroups(const std::string& name) {
  const int each = facts_.people_in.each;
  if (each == 0 || facts_.people_in.rows) return false;
  for (const hb::Noun& noun : handbook_.contents().nouns()) {
    const auto is_usual = [&](const hb::NounOption& option) { return option.furniture() == name; };
    if (!noun.one_of() || std::ranges::none_of(noun.options(), is_usual)) continue;
    for (const hb::NounOption& option : noun.options()) {
      const hb::Furniture* table = handbook_.FindFurniture(option.furniture());
      const bool for_some = table != nullptr && table->category().ends_with("table") &&
                            SeatOf(*table, handbook_) != nullptr && !IsWished(*table);
      if (!for_some || table->name() == name) continue;
      EraseUnasked([&](const ProgramItem& item) { return item.furniture->name() == name; });
      const std::string zone = HomeOf(*table, program_);
      const int count = std::min(kMostOfAKind, (*facts_.people + each - 1) / each);
      program_.floor_items.push_back({table, nullptr, count, zone, true, 0, each});
      SeatAt(*table, count, each, zone);
      return true;
    }
  }
  return false;
}

// Twenty-four pupils at "six island benches" sit four at each of those, and not at benches of ours.
bool Seats::SeatPeopleAtKin(const std::string& name) {
  const hb::Furniture* usual = handbook_.FindFurniture(name);
  if (usual == nullptr || usual->category() == "box") return false;
  // Who says how many sit at how many tables has seated them.
  const bool seated = std::ranges::any_of(facts_.wishes, [&](const Wish& wish) {
    return wish.counted && wish.seats > 0 && SeatOf(*wish.furniture, handbook_) == usual;
  });
  if (seated) return true;
  const bool without_seats = IsSeat(*usual) && !Lists(program_.floor_items, name);
  const auto kin = std::ranges::find_if(facts_.wishes, [&](const Wish& wish) {
    if (!wish.counted || wish.count < 2 || wish.furniture == usual || !IsFloorPiece(*wish.furniture)) return false;
    const hb::Furniture* seat = SeatOf(*wish.furniture, handbook_);
    return wish.furniture->category() == usual->category() ||
           (seat != nullptr && (without_seats || seat == SeatOf(*usual, handbook_)));
  });
  if (kin == facts_.wishes.end()) return false;
  EraseUnasked([&](const ProgramItem& item) { return item.furniture == usual; });
  const int each = kin->seats > 0 ? kin->seats : (*facts_.people + kin->count - 1) / kin->count;
  SeatAt(*kin->furniture, kin->count, each, HomeOf(*kin->furniture, program_));
  return true;
}

// Of rooms where one sits on what is there anyway, or sleeps: more armchairs, or beds, until everyone has a place.
void Seats::SeatPeopleAnywhere() {
  constexpr int kMostMore = 4;
  int seats = 0, beds = 0;
  ProgramItem *armchairs = nullptr, *bed = nullptr;
  for (ProgramItem& item : program_.floor_items) {
    const bool for_sleep = item.furniture->category() == "bed";
    const int places = item.count * PlacesOn(*item.furniture);
    if (item.furniture->category() == "armchair") armchairs = &item;
    if (for_sleep && bed == nullptr) bed = &item;
    (for_sleep ? beds : seats) += places;
  }
  ProgramItem* more = bed != nullptr ? bed : armchairs;
  const int missing = *facts_.people - (bed != nullptr ? beds : seats);
  if (more == nullptr || more->requested || missing <= 0) return;
  const int each = PlacesOn(*more->furniture);
  more->count += std::min(kMostMore, (missing + each - 1) / each);
  more->requested = true;  // by who is to sit or lie there
}

}  // namespace flair::language
