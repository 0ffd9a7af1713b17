// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "language_worker/handbook/program/room_program.h"
#include "language_worker/handbook/reading/piece_words.h"

namespace flair::language {
namespace {

constexpr double kSeatM = 0.6;
// A table grows to this many times its class's largest width before another one comes.
constexpr double kMostGrowth = 1.6;
constexpr int kMostGroups = 12;

bool IsTable(const hb::Furniture& furniture) {
  return furniture.category().ends_with("table") && SeatsRound(furniture, 1, 1) > 0;
}

// One sits with the thighs below the top: 0.2 to 0.35 m lie between seat and top (0.27 to 0.3 m is best).
bool ReachesTop(const hb::Furniture& seat, double top_m) {
  constexpr double kLeastM = 0.2, kMostM = 0.35;
  return top_m - LeastOf(seat.seat_height_m()) >= kLeastM && top_m - MostOf(seat.seat_height_m()) <= kMostM;
}

double WidthOf(const ProgramItem& item) { return item.size.width_m.value_or(item.furniture->width_m().typical()); }

std::string RowName(int i) {
  constexpr std::array<const char*, 10> kOrdinals = {"first", "second",  "third",  "fourth", "fifth",
                                                     "sixth", "seventh", "eighth", "ninth",  "tenth"};
  const auto at = static_cast<std::size_t>(i);
  return at < kOrdinals.size() ? fmt::format("{} row", kOrdinals[at]) : fmt::format("row {}", i + 1);
}

class Grouper {
 public:
  Grouper(const BriefFacts& facts, double area_m2, const Handbook& handbook, RoomProgram& program)
      : facts_(facts), area_m2_(area_m2), handbook_(handbook), program_(program) {}

  void Group() {
    for (ProgramItem& seat : program_.floor_items) Attach(seat);
    for (ProgramItem& seat : program_.floor_items) SuitHeight(seat);
    for (ProgramItem& host : program_.floor_items) SeatPeople(host);
    for (std::size_t i = 1; i < program_.floor_items.size(); ++i) PartTables(i);
    for (std::size_t i = 0; i < program_.floor_items.size(); ++i) SitAcross(i);
    for (const NamedSet& set : facts_.sets) GatherSet(set);
    for (const hb::Rows& rows : program_.archetype->rows()) SplitRows(rows);
    for (const Place& place : facts_.places) FaceOneWay(place);
    for (std::size_t i = 0; i < program_.floor_items.size(); ++i) {
      const ProgramItem& item = program_.floor_items[i];
      if (item.in_rows && item.requested && item.in_each > 1) MakeRows(*item.furniture);
    }
    for (std::size_t i = 0; i < program_.floor_items.size(); ++i) SplitTables(i);
  }

 private:
  // Seats of a kind that comes with another piece of their zone belong to that one.
  void Attach(ProgramItem& seat) {
    if (seat.seat_of != nullptr) return;
    for (const ProgramItem& host : program_.floor_items) {
      if (host.zone != seat.zone || SeatOf(*host.furniture, handbook_) != seat.furniture) continue;
      seat.seat_of = host.furniture;
      return;
    }
  }

  // Stools of 0.45 m at a table of 0.9 m become higher ones: another class of seats that goes with the table.
  void SuitHeight(ProgramItem& seat) {
    const auto host = std::ranges::find_if(program_.floor_items, [&](const ProgramItem& one) {
      return one.furniture == seat.seat_of && one.zone == seat.zone;
    });
    if (host == program_.floor_items.end()) return;
    const double top_m = host->size.height_m.value_or(host->furniture->height_m().typical());
    if (!seat.furniture->has_seat_height_m() || ReachesTop(*seat.furniture, top_m)) return;
    for (const hb::Furniture& other : handbook_.contents().furniture()) {
      const bool seat_like = IsSeat(other) && other.has_seat_height_m() && ReachesTop(other, top_m);
      if (!seat_like || !StandsWith(other, *host->furniture)) continue;
      program_.substitutes.emplace_back(seat.furniture->name(), other.name());
      seat.furniture = &other;
      return;
    }
  }

  // "Two chairs each" at a desk that has a seat on either side are one of each.
  void SitAcross(std::size_t i) {
    const ProgramItem host = program_.floor_items[i];
    ProgramItem* seats = SeatsOf(host);
    if (seats == nullptr || host.furniture->category() != "desk" || seats->count <= host.count) return;
    for (const auto& companion : host.furniture->companions()) {
      const hb::Furniture* other = handbook_.FindFurniture(companion.furniture());
      if (other == nullptr || !IsSeat(*other) || other == seats->furniture) continue;
      ProgramItem across = *seats;
      across.furniture = other;
      across.count = seats->count - host.count;
      seats->count = host.count;
      std::erase_if(program_.floor_items,
                    [&](const ProgramItem& item) { return item.furniture == other && item.zone == host.zone; });
      program_.floor_items.push_back(across);
      return;
    }
  }

  // "Ten double desks facing the whiteboard" stand in rows, whatever the kind of room has.
  void FaceOneWay(const Place& place) {
    const bool faces = place.asked->relation().text() == "The {object} faces the {target}." && place.target != nullptr;
    if (faces && place.which < 0 && PlacesOn(*place.target) == 0) MakeRows(*place.furniture);
  }

  // Rows of what has none in this kind of room.
  void MakeRows(const hb::Furniture& furniture) {
    constexpr int kFewest = 4;
    constexpr double kAislesM = 1;
    const bool known = std::ranges::any_of(program_.archetype->rows(),
                                           [&](const hb::Rows& rows) { return rows.furniture() == furniture.name(); });
    const auto item = std::ranges::find(program_.floor_items, &furniture, &ProgramItem::furniture);
    if (known || item == program_.floor_items.end() || item->own_rows) return;
    hb::Rows rows;
    rows.set_furniture(furniture.name());
    rows.set_aisles_m(kAislesM);
    rows.set_min_count(kFewest);
    item->own_rows = true;
    SplitRows(rows);
  }

  ProgramItem* SeatsOf(const ProgramItem& host) {
    for (ProgramItem& item : program_.floor_items) {
      if (item.seat_of == host.furniture && item.zone == host.zone) return &item;
    }
    return nullptr;
  }

  void SeatPeople(ProgramItem& host) {
    ProgramItem* seats = SeatsOf(host);
    if (seats == nullptr) return;
    int places = 0;
    for (const ProgramItem& item : program_.floor_items) {
      const bool at_it = item.seat_of == host.furniture && item.zone == host.zone;
      places += at_it ? item.count * std::max(1, PlacesOn(*item.furniture)) : 0;
    }
    host.seats = (places + host.count - 1) / host.count;
    if (!IsTable(*host.furniture)) return;
    const double largest_m = std::max(host.furniture->width_m().max(), host.furniture->width_m().typical());
    const double width_m = host.furniture->width_m().typical(), depth_m = host.furniture->depth_m().typical();
    if (WidthForSeats(*host.furniture, host.seats, width_m, depth_m) <= kMostGrowth * largest_m) return;
    constexpr int kAtEach = 4;
    host.count = (places + kAtEach - 1) / kAtEach;
    host.seats = kAtEach;
  }

  // How many people, or desks of people, stand without a way between them: nobody climbs over more than one at a desk
  // or three in seats. 0 for what nobody sits at.
  int Abreast(const ProgramItem& item) {
    constexpr double kDesksM = 2;
    constexpr int kSeats = 7;
    if (SeatsOf(item) != nullptr) return std::max(1, static_cast<int>(kDesksM / WidthOf(item)));
    if (item.furniture->category() == "bench") return 1;
    return item.furniture->category() != "bed" && PlacesOn(*item.furniture) > 0 ? kSeats : 0;
  }

  // As many side by side as the shorter side of the room takes, with ways between them unless the rows become too many,
  // and all rows about as long.
  void SplitRows(const hb::Rows& rows) {
    constexpr double kShortSide = 0.8;  // of the side of a square of that area
    constexpr int kEven = 4;
    constexpr double kFrontM = 1, kBehindDeskM = 0.9, kBehindSeatM = 0.5, kWayM = 0.75;
    const auto item = std::ranges::find_if(program_.floor_items,
                                           [&](const auto& one) { return one.furniture->name() == rows.furniture(); });
    if (item == program_.floor_items.end() || item->count < std::max(2, rows.min_count())) return;
    // Pairs are what rows of desks are made of.
    if (item->in_each == 2) item->in_each = 0;
    if (item->in_each > 1 && !item->in_rows) return;
    // Those in rows of their own have no arms to touch.
    constexpr double kChairsApartM = 0.1, kMatsApartM = 0.3;
    const bool spaced = item->own_rows && SeatsOf(*item) == nullptr;
    const double apart_m = !spaced ? 0 : PlacesOn(*item->furniture) > 0 ? kChairsApartM : kMatsApartM;
    const double side_m = std::sqrt(area_m2_), width_m = WidthOf(*item) + apart_m;
    const double row_m = item->furniture->depth_m().typical() + (SeatsOf(*item) ? kBehindDeskM : kBehindSeatM);
    int across = item->in_each;
    // "Two rows of five pews" that are too long to stand across the room are five pews on either side of an aisle.
    const int asked_rows = across > 0 ? (item->count + across - 1) / across : 0;
    const bool along = asked_rows > 1 && asked_rows < across && across * width_m > kShortSide * side_m;
    if (along) across = asked_rows;
    for (item->abreast = along ? 1 : Abreast(*item); across == 0; ++item->abreast) {
      const int block = item->abreast > 0 ? item->abreast : item->count;
      const auto length_m = [&](int n) { return n * width_m + std::max(rows.aisles_m(), (n - 1) / block * kWayM); };
      int most = 1;
      while (most < item->count && length_m(most + 1) <= kShortSide * side_m) ++most;
      // Thirteen seats are two times six rather than seven; of desks some stay out.
      const bool even = block >= kEven && most > block;
      int each = even ? most / ((most + block - 1) / block) : block;
      if (most > each) most -= most % each;
      const int count = (item->count + most - 1) / most;
      if (item->abreast > 0 && block < most && count * row_m > side_m - kFrontM) continue;
      across = (item->count + count - 1) / count;
      if (even) each = (across * each + most - 1) / most;
      if (most > each) across = std::min(most, (across + each - 1) / each * each);
      if (item->abreast > 0) item->abreast = each;
      break;
    }
    const int ways = item->abreast > 0 ? (across - 1) / item->abreast : 0;
    item->way_m = std::max(kWayM, ways > 0 ? rows.aisles_m() / ways : 0);
    if (spaced) item->abreast = 0, item->way_m = apart_m;
    item->behind_each_other = true;
    std::vector<hb::ZoneSpec> zones;
    for (int i = 0; i < (item->count + across - 1) / across; ++i) {
      zones.emplace_back().set_name(RowName(i));
      if (!rows.purpose().empty()) zones.back().add_purposes(rows.purpose());
    }
    Split(static_cast<std::size_t>(item - program_.floor_items.begin()), across, zones);
  }

  // Tables of two kinds with the same chairs: those of the second have a zone of their own with it.
  void PartTables(std::size_t i) {
    ProgramItem& host = program_.floor_items[i];
    ProgramItem* seats = SeatsOf(host);
    const auto sits_there = [&](const ProgramItem& other) {
      const ProgramItem* theirs = SeatsOf(other);
      return other.zone == host.zone && other.furniture != host.furniture && IsTable(*other.furniture) &&
             theirs != nullptr && theirs->furniture == seats->furniture;
    };
    const auto end = program_.floor_items.begin() + static_cast<std::ptrdiff_t>(i);
    if (seats == nullptr || !IsTable(*host.furniture) || std::none_of(program_.floor_items.begin(), end, sits_there))
      return;
    const auto zone = std::ranges::find(program_.zones, host.zone, &hb::ZoneSpec::name);
    if (zone == program_.zones.end()) return;
    hb::ZoneSpec own = *zone;
    own.clear_primaries();
    own.add_primaries(host.furniture->name());
    for (int number = 2; HasZone(program_, own.name()); ++number) own.set_name(fmt::format("{} {}", host.zone, number));
    seats->zone = host.zone = own.name();
    program_.zones.insert(zone + 1, own);
  }

  // Many desks stand in islands, face to face and side by side, rather than along walls, unless the brief says where.
  void MakeIslands(ProgramItem& host) {
    constexpr int kFewest = 4, kFour = 4, kSix = 6;
    constexpr double kRoomEachM2 = 4.5;
    const hb::Furniture& desk = *host.furniture;
    const bool has_back_free = desk.clear_back_m() == 0 && SeatsOf(host) != nullptr && host.abreast == 0;
    const bool placed =
        std::ranges::any_of(facts_.places, [&](const Place& place) { return place.furniture == host.furniture; });
    if (desk.category() != "desk" || !has_back_free || placed || host.in_each > 0 || host.count < kFewest) return;
    if (area_m2_ >= kRoomEachM2 * host.count) {
      host.in_each = host.count % kFour != 0 && host.count % kSix == 0 ? kSix : kFour;
      host.in_rows = false;
    }
  }

  // Tables with their seats, and what the brief wants in groups.
  void SplitTables(std::size_t i) {
    MakeIslands(program_.floor_items[i]);
    const ProgramItem& host = program_.floor_items[i];
    const bool asked = host.in_each > 0 && host.in_each < host.count;
    if (!asked && (host.count < 2 || host.seats < 2 || !IsTable(*host.furniture))) return;
    const int in_each = std::max(asked ? host.in_each : 1, (host.count + kMostGroups - 1) / kMostGroups);
    const int count = (host.count + in_each - 1) / in_each;
    std::vector<hb::ZoneSpec> zones;
    for (const hb::ZoneSpec& zone : program_.zones) {
      if (zone.name() != host.zone) continue;
      int number = 1;
      for (int g = 0; g < count; ++g) {
        zones.push_back(zone);
        // The kind of room may have a zone of that name.
        while (g > 0 && HasZone(program_, zones.back().name()))
          zones.back().set_name(fmt::format("{} {}", zone.name(), ++number));
      }
    }
    if (!zones.empty()) Split(i, in_each, zones);
  }

  // Shares one line of the program and its seats out over zones that take the place of its own.
  void Split(std::size_t at, int in_each, std::vector<hb::ZoneSpec>& zones) {
    const ProgramItem host = program_.floor_items[at];
    std::vector<ProgramItem> lines, seats;
    for (const ProgramItem& item : program_.floor_items) {
      if (item.seat_of == host.furniture && item.zone == host.zone) seats.push_back(item);
    }
    std::vector<int> at_each;
    for (const ProgramItem& item : seats) at_each.push_back((item.count + host.count - 1) / host.count);
    int left = host.count;
    for (hb::ZoneSpec& zone : zones) {
      zone.clear_primaries();
      zone.add_primaries(host.furniture->name());
      ProgramItem line = host;
      line.zone = zone.name();
      line.count = std::min(in_each, left);
      left -= line.count;
      lines.push_back(line);
      for (std::size_t s = 0; s < seats.size(); ++s) {
        ProgramItem sitting = seats[s];
        sitting.zone = zone.name();
        sitting.count = std::min(seats[s].count, line.count * at_each[s]);
        seats[s].count -= sitting.count;
        if (sitting.count > 0) lines.push_back(sitting);
      }
    }
    std::erase_if(program_.floor_items, [&](const ProgramItem& item) {
      return item.zone == host.zone && (item.furniture == host.furniture || item.seat_of == host.furniture);
    });
    for (ProgramItem& item : program_.floor_items) {
      if (item.zone == host.zone) item.zone = zones.front().name();
    }
    const auto place =
        program_.floor_items.begin() + static_cast<std::ptrdiff_t>(std::min(at, program_.floor_items.size()));
    program_.floor_items.insert(place, lines.begin(), lines.end());
    ReplaceZone(host.zone, zones);
  }

  // Each of its sets has a zone of its own, with its share of every piece and of the seats at it. The largest piece,
  // which is named first, must be there in each.
  void GatherSet(const NamedSet& set) {
    if (set.pieces.empty()) return;
    const auto is_in_it = [&](const ProgramItem& item) {
      const bool named = Includes(set.pieces, item.furniture) || Includes(set.pieces, item.seat_of);
      return named && item.count >= set.count && item.count % set.count == 0;
    };
    std::vector<ProgramItem> shares;
    std::ranges::copy_if(program_.floor_items, std::back_inserter(shares), is_in_it);
    const auto main = std::ranges::find_if(shares, [&](const auto& one) { return one.furniture == set.pieces[0]; });
    if (shares.size() < 2 || main == shares.end()) return;
    const auto home = std::ranges::find(program_.zones, main->zone, &hb::ZoneSpec::name);
    if (home == program_.zones.end()) return;
    const hb::ZoneSpec spec = *home;
    const std::string name = set.name.empty() ? spec.name() : set.name;
    std::vector<hb::ZoneSpec> zones;
    std::vector<ProgramItem> lines;
    for (int number = 1; static_cast<int>(zones.size()) < set.count; ++number) {
      hb::ZoneSpec zone = spec;
      zone.set_name(fmt::format("{} {}", name, number));
      if (HasZone(program_, zone.name())) continue;
      zone.clear_primaries();
      zone.add_primaries(set.pieces[0]->name());
      for (ProgramItem line : shares) {
        line.zone = zone.name();
        line.count /= set.count;
        line.in_each = 0;
        lines.push_back(line);
      }
      zones.push_back(zone);
    }
    std::erase_if(program_.floor_items, is_in_it);
    program_.floor_items.insert(program_.floor_items.begin(), lines.begin(), lines.end());
    const bool empty =
        std::ranges::none_of(program_.floor_items, [&](const ProgramItem& item) { return item.zone == spec.name(); });
    const auto at = empty ? program_.zones.erase(home) : home;
    program_.zones.insert(at, zones.begin(), zones.end());
  }

  void ReplaceZone(const std::string& name, const std::vector<hb::ZoneSpec>& zones) {
    const auto zone = std::ranges::find_if(program_.zones, [&](const auto& one) { return one.name() == name; });
    if (zone == program_.zones.end()) return;
    const auto at = program_.zones.erase(zone);
    program_.zones.insert(at, zones.begin(), zones.end());
  }

  const BriefFacts& facts_;
  const double area_m2_;
  const Handbook& handbook_;
  RoomProgram& program_;
};

}  // namespace

int SeatsRound(const hb::Furniture& table, double width_m, double depth_m) {
  constexpr double kPlay = 0.05, kEndM = 0.75, kRoundSeatM = 0.55;
  if (table.category() == "round_table") {
    return static_cast<int>(std::numbers::pi * (width_m + kPlay) / kRoundSeatM);
  }
  if (table.category() != "table") return 0;
  return 2 * static_cast<int>((width_m + kPlay) / kSeatM) + (depth_m >= kEndM ? 2 : 0);
}

double WidthForSeats(const hb::Furniture& table, int seats, double start_m, double depth_m) {
  double width_m = start_m;
  while (SeatsRound(table, width_m, depth_m) < seats && width_m < 20) width_m += 0.1;
  return std::round(width_m * 100) / 100;
}

void SplitIntoGroups(const BriefFacts& facts, double area_m2, const Handbook& handbook, RoomProgram& program) {
  Grouper(facts, area_m2, handbook, program).Group();
}

}  // namespace flair::language
