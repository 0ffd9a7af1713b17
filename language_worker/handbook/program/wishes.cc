// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "language_worker/handbook/program/room_program.h"
#include "language_worker/handbook/program/seats.h"
#include "language_worker/handbook/reading/piece_words.h"

namespace flair::language {
namespace {

class WishMaker {
 public:
  WishMaker(const BriefFacts& facts, const Handbook& handbook, RoomProgram& program)
      : facts_(facts), handbook_(handbook), program_(program), seats_(facts, handbook, program) {}

  void Apply() {
    for (auto wish = facts_.wishes.rbegin(); wish != facts_.wishes.rend(); ++wish) Add(*wish);
    for (const auto& [piece, other] : facts_.also_serves) {
      seats_.EraseUnasked([&](const ProgramItem& item) { return item.furniture == other; });
      program_.substitutes.emplace_back(other->name(), piece->name());
    }
    KeepAskedSeats();
    KeepSeatsSaidWith();
    KeepAudience();
    SeatOnBenches();
    RemoveRefusals();
    seats_.SeatPeople();
    KeepCounts();
  }

 private:
  void Add(const Wish& wish) {
    TakePlaceOfKin(*wish.furniture);
    if (AddToWhatIsThere(wish, program_.floor_items) || AddToWhatIsThere(wish, program_.tertiary_items)) return;
    ReplaceAlike(*wish.furniture);
    if (!IsFloorPiece(*wish.furniture)) {
      if (TakesAPlaceOnTheWall(wish)) return;
      program_.tertiary_items.insert(program_.tertiary_items.begin(),
                                     {wish.furniture, nullptr, wish.count, "", true, 0});
      program_.tertiary_items.front().size = wish.size;
      return;
    }
    const hb::ZoneSpec& makes = wish.furniture->makes_zone();
    if (!makes.name().empty() && !HasZone(program_, makes.name()) && !HasHome(*wish.furniture)) {
      program_.zones.push_back(makes);
    }
    const std::string zone = HasZone(program_, makes.name()) ? makes.name() : HomeOf(*wish.furniture, program_);
    ReplaceRivals(*wish.furniture, zone);
    program_.floor_items.insert(program_.floor_items.begin(),
                                {wish.furniture, nullptr, wish.count, zone, true, 0, wish.seats});
    program_.floor_items.front().optional = wish.optional;
    program_.floor_items.front().size = wish.size;
    program_.floor_items.front().in_each = wish.in_each;
    program_.floor_items.front().in_rows = wish.in_rows;
    seats_.SeatAt(*wish.furniture, wish.count, wish.seats, zone);
    for (const hb::ObjectEntry& companion : wish.furniture->companions()) {
      const hb::Condition& when = companion.condition();
      const bool elsewhere = !when.rooms().empty() && !Includes(when.rooms(), program_.archetype->name());
      const bool too_many = when.max_count() > 0 && wish.count > when.max_count();
      if (Lists(program_, companion.furniture()) || elsewhere || too_many) continue;
      const hb::Furniture* furniture = handbook_.FindFurniture(companion.furniture());
      const bool in_another_form =
          furniture != nullptr && !IsSeat(*furniture) && std::ranges::any_of(facts_.wishes, [&](const Wish& other) {
            return ShareANoun(*furniture, *other.furniture);
          });
      if (furniture == nullptr || in_another_form || (IsSeat(*furniture) && seats_.SitsOtherwise(*wish.furniture)))
        continue;
      auto& list = IsFloorPiece(*furniture) ? program_.floor_items : program_.tertiary_items;
      list.push_back({furniture, &companion, std::max(1, companion.count()), zone, false, companion.drop_order()});
    }
  }

  // The class that one named by the brief is a kind of; any other itself.
  const std::string& KinOf(const hb::Furniture& furniture) const {
    const auto base = facts_.base_of_own.find(furniture.name());
    return base == facts_.base_of_own.end() || base->second.empty() ? furniture.name() : base->second;
  }

  // A "gaming desk" comes instead of the usual desk, and what is said of desks holds for it.
  void TakePlaceOfKin(const hb::Furniture& furniture) {
    const hb::Furniture* kin = handbook_.FindFurniture(KinOf(furniture));
    if (kin == nullptr || kin == &furniture) return;
    program_.substitutes.emplace_back(kin->name(), furniture.name());
    for (hb::ZoneSpec& zone : program_.zones) {
      if (Includes(zone.primaries(), kin->name())) zone.add_primaries(furniture.name());
    }
    if (IsWished(*kin)) return;
    for (auto* items : {&program_.floor_items, &program_.tertiary_items}) {
      for (ProgramItem& item : *items) {
        if (item.furniture == kin && !item.requested) item.furniture = &furniture;
      }
    }
  }

  // Of what the brief counts there is that number, and no other of its kind: "a chair" is one chair in all, "a ceiling
  // lamp" the only one. Seats stay at tables that nobody asked for.
  void KeepCounts() {
    for (const Wish& wish : facts_.wishes) {
      if (!wish.counted || wish.optional) continue;
      const auto is_another = [&](const ProgramItem& item) {
        const hb::Furniture& furniture = *item.furniture;
        const bool by_noun = wish.noun != nullptr && furniture.kind() != hb::FURNITURE_KIND_CEILING &&
                             std::ranges::any_of(wish.noun->options(), [&](const hb::NounOption& option) {
                               return option.furniture() == furniture.name();
                             });
        const bool alike = furniture.category() == wish.furniture->category() && furniture.category() != "box" &&
                           furniture.kind() == wish.furniture->kind() && !IsFloorPiece(furniture);
        // Chairs for visitors leave whoever sits at the desk their own.
        const bool at_desk = item.seat_of != nullptr && item.seat_of->category() == "desk" &&
                             item.furniture != wish.furniture && wish.furniture->has_makes_zone();
        return !item.requested && (alike || (by_noun && !IsSeatOfAnother(item) && !at_desk));
      };
      std::erase_if(program_.tertiary_items, is_another);
      std::erase_if(program_.floor_items, is_another);
      // No more desks than chairs.
      for (ProgramItem& host : program_.floor_items) {
        if (!host.requested && SeatOf(*host.furniture, handbook_) == wish.furniture)
          host.count = std::min(host.count, wish.count);
      }
    }
  }

  // Six recliners seat whoever comes: no sofa of ours stands before them, and no row of chairs beside them.
  void KeepAskedSeats() {
    constexpr int kEnough = 2, kMany = 4;
    const auto is_easy = [](const hb::Furniture& furniture) {
      const std::string& category = furniture.category();
      return category == "armchair" || category == "sofa" || category == "corner_sofa";
    };
    int asked = 0;
    for (const Wish& wish : facts_.wishes) {
      if (wish.counted && is_easy(*wish.furniture)) asked += wish.count * PlacesOn(*wish.furniture);
    }
    if (asked < kEnough) return;
    seats_.EraseUnasked([&](const ProgramItem& item) {
      const bool usual = IsSeat(*item.furniture) && item.furniture->name() == program_.archetype->per_person();
      return is_easy(*item.furniture) || (usual && asked >= kMany && !IsSeatOfAnother(item));
    });
  }

  // Chairs in rows are for an audience, which has no tables of ours, nor other chairs.
  void KeepAudience() {
    constexpr int kFewest = 8;
    for (const Wish& wish : facts_.wishes) {
      if (!wish.in_rows || !IsSeat(*wish.furniture) || wish.count < kFewest) continue;
      seats_.EraseUnasked([&](const ProgramItem& item) {
        return item.furniture->category().ends_with("table") || IsSeat(*item.furniture);
      });
      for (ProgramItem& item : program_.floor_items) {
        if (item.furniture == wish.furniture) item.seat_of = nullptr;
      }
    }
  }

  // Benches that are asked for are the seats of their table, as long as it is: two at each where nobody counts them,
  // and no chairs of ours. Chairs that are asked for beside them have the other side.
  void SeatOnBenches() {
    constexpr int kAtASide = 3;
    for (const Wish& wish : facts_.wishes) {
      const auto bench = std::ranges::find(program_.floor_items, wish.furniture, &ProgramItem::furniture);
      if (wish.furniture->category() != "bench" || bench == program_.floor_items.end()) continue;
      const auto host = std::ranges::find_if(program_.floor_items, [&](const ProgramItem& item) {
        const hb::Furniture* kin = handbook_.FindFurniture(KinOf(*item.furniture));
        const bool table = kin != nullptr && kin->category().ends_with("table") && SeatOf(*kin, handbook_) != nullptr;
        return item.requested && table && StandsWith(*handbook_.FindFurniture(KinOf(*bench->furniture)), *kin);
      });
      if (host == program_.floor_items.end()) continue;
      const hb::Furniture *table = host->furniture, *chair = SeatOf(*table, handbook_);
      const double table_m = host->size.width_m.value_or(table->width_m().typical());
      const bool chairs = host->seats > 0 || (chair != nullptr && IsWished(*chair));
      const int hosts = host->count;
      if (!wish.counted) bench->count = hosts * (chairs ? 1 : 2);
      bench->seat_of = table;
      bench->zone = host->zone;
      if (!bench->size.width_m)
        bench->size.width_m =
            std::clamp(table_m, LeastOf(bench->furniture->width_m()), MostOf(bench->furniture->width_m()));
      if (!chairs) seats_.EraseUnasked([&](const ProgramItem& item) { return item.furniture == chair; });
      for (const Wish& other : facts_.wishes) {
        const auto seat = std::ranges::find(program_.floor_items, chair, &ProgramItem::furniture);
        if (other.furniture == chair && !other.counted && seat != program_.floor_items.end())
          seat->count = hosts * kAtASide;
      }
    }
  }

  // "A desk with a stool" has no office chair.
  void KeepSeatsSaidWith() {
    for (const Wish& wish : facts_.wishes) {
      if (wish.furniture->category() != "desk" || !seats_.SitsOtherwise(*wish.furniture)) continue;
      const hb::Furniture* usual = SeatOf(*wish.furniture, handbook_);
      seats_.EraseUnasked([&](const ProgramItem& item) { return item.furniture == usual && !IsSeatOfAnother(item); });
    }
  }

  bool IsSeatOfAnother(const ProgramItem& seat) const {
    return std::ranges::any_of(program_.floor_items, [&](const ProgramItem& host) {
      return host.zone == seat.zone && (!host.requested || host.seats > 0) &&
             SeatOf(*host.furniture, handbook_) == seat.furniture;
    });
  }

  // A blackboard hangs where the usual whiteboard would.
  bool TakesAPlaceOnTheWall(const Wish& wish) {
    for (ProgramItem& item : program_.tertiary_items) {
      const bool same =
          item.furniture->category() == wish.furniture->category() && item.furniture->kind() == wish.furniture->kind();
      if (!same || item.requested || wish.furniture->kind() != hb::FURNITURE_KIND_WALL) continue;
      item.furniture = wish.furniture;
      item.count = wish.count;
      item.size = wish.size;
      item.requested = true;
      return true;
    }
    return false;
  }

  bool AddToWhatIsThere(const Wish& wish, std::vector<ProgramItem>& items) {
    const auto item = std::ranges::find_if(items, [&](const auto& one) { return one.furniture == wish.furniture; });
    if (item == items.end()) return false;
    if (item->requested && item->seats > 0 && wish.seats > 0) {
      // Four tables for four, and now those for two.
      const std::string zone = fmt::format("{} for {}", item->zone, wish.seats);
      const auto spec = std::ranges::find(program_.zones, item->zone, &hb::ZoneSpec::name);
      if (spec == program_.zones.end()) return false;
      if (!HasZone(program_, zone)) program_.zones.insert(spec + 1, hb::ZoneSpec(*spec))->set_name(zone);
      items.insert(items.begin(), {wish.furniture, nullptr, wish.count, zone, true, 0, wish.seats});
      seats_.SeatAt(*wish.furniture, wish.count, wish.seats, zone);
      return true;
    }
    const int usual = item->count;
    item->count = wish.counted ? wish.count : std::max(item->count, wish.count);
    TakeAlong(*item, usual);
    item->in_each = wish.in_each;
    item->in_rows = wish.in_rows;
    item->requested = true;
    item->optional = wish.optional;
    item->seats = wish.seats;
    item->size = wish.size;
    if (&items == &program_.floor_items) {
      seats_.SeatAt(*wish.furniture, item->count, wish.seats, std::string(item->zone));
    } else {
      // What is asked for finds its place first.
      std::rotate(items.begin(), item, item + 1);
    }
    return true;
  }

  // Four barber's chairs instead of the usual three have four mirrors to look into: what the kind of room puts before
  // each other in equal numbers.
  void TakeAlong(const ProgramItem& asked, int usual) {
    if (usual < 2 || asked.count == usual) return;
    for (ProgramItem& other : program_.floor_items) {
      const auto ties = [&](const hb::Relation& relation) {
        const std::string &one = asked.furniture->name(), &two = other.furniture->name();
        return (relation.object() == one && Includes(relation.targets(), two)) ||
               (relation.object() == two && Includes(relation.targets(), one));
      };
      if (other.requested || other.zone != asked.zone || other.count != usual) continue;
      if (std::ranges::any_of(program_.archetype->relations(), ties)) other.count = asked.count;
    }
  }

  bool IsWished(const hb::Furniture& furniture) const {
    return std::ranges::any_of(facts_.wishes, [&](const Wish& wish) { return wish.furniture == &furniture; });
  }

  // A wished-for primary takes the place of the usual one of its zone: a bunk bed comes instead of the double bed. So
  // does what makes such a zone by itself, and whoever sat at the usual one goes as well.
  void ReplaceRivals(const hb::Furniture& furniture, const std::string& zone_name) {
    const bool makes_it = furniture.makes_zone().name() == zone_name;
    for (const hb::ZoneSpec& zone : program_.zones) {
      const bool main = std::ranges::any_of(zone.primaries(), [&](const std::string& name) {
        const hb::Furniture* primary = handbook_.FindFurniture(name);
        return primary != nullptr && (primary == &furniture || ShareANoun(*primary, furniture));
      });
      if (zone.name() != zone_name || !(makes_it || main)) continue;
      seats_.EraseUnasked([&](const ProgramItem& item) {
        if (item.zone != zone_name) return false;
        const bool same = item.furniture->category() == furniture.category();
        const bool rival = same || (makes_it && Includes(zone.primaries(), item.furniture->name()));
        // An island stands parallel to the counter, not instead of it.
        const bool seat = IsSeat(*item.furniture) && (item.seat_of == nullptr || !IsWished(*item.seat_of));
        return (rival && !StandsWith(furniture, *item.furniture)) || (makes_it && seat);
      });
    }
  }

  // Whether one word may mean either: a single bed and a double bed.
  bool ShareANoun(const hb::Furniture& one, const hb::Furniture& other) const {
    return std::ranges::any_of(handbook_.contents().nouns(), [&](const hb::Noun& noun) {
      const auto means = [&](const hb::Furniture& furniture) {
        return std::ranges::any_of(noun.options(),
                                   [&](const auto& option) { return option.furniture() == KinOf(furniture); });
      };
      return (noun.one_of() || one.category() == other.category()) && means(one) && means(other);
    });
  }

  // Of pieces that stand for one another the room has the one that is asked for: a corner sofa comes instead of the
  // sofa. Where the brief lists what there is, so do pieces of one category: its lab benches are the room's benches.
  void ReplaceAlike(const hb::Furniture& furniture) {
    if (program_.listed && IsFloorPiece(furniture) && furniture.category() != "box") {
      seats_.EraseUnasked([&](const ProgramItem& item) {
        return item.furniture->category() == furniture.category() && item.furniture != &furniture &&
               !IsWished(*item.furniture) && !StandsWith(furniture, *item.furniture);
      });
    }
    for (const hb::Noun& noun : handbook_.contents().nouns()) {
      const auto among = [&](const hb::Furniture& one) {
        return std::ranges::any_of(noun.options(),
                                   [&](const auto& option) { return option.furniture() == KinOf(one); });
      };
      if (!noun.one_of() || !among(furniture)) continue;
      seats_.EraseUnasked([&](const ProgramItem& item) {
        if (item.furniture == &furniture || IsWished(*item.furniture) || !among(*item.furniture)) return false;
        program_.substitutes.emplace_back(item.furniture->name(), furniture.name());
        return true;
      });
    }
  }

  bool HasHome(const hb::Furniture& furniture) const {
    return std::ranges::any_of(program_.zones, [&](const hb::ZoneSpec& zone) {
      return Includes(zone.primaries(), furniture.name()) || Includes(furniture.zone_hints(), zone.name());
    });
  }

  void RemoveRefusals() {
    for (const hb::Furniture* refusal : facts_.refusals) {
      Remove(refusal->name(), program_);
      for (const hb::ObjectEntry& companion : refusal->companions()) seats_.RemoveUnaccompanied(companion.furniture());
    }
  }

  const BriefFacts& facts_;
  const Handbook& handbook_;
  RoomProgram& program_;
  Seats seats_;
};

}  // namespace

void ApplyWishes(const BriefFacts& facts, const Handbook& handbook, RoomProgram& program) {
  WishMaker(facts, handbook, program).Apply();
}

}  // namespace flair::language
