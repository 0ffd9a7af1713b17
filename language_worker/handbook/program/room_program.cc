// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/program/room_program.h"

#include <algorithm>

namespace flair::language {
namespace {

bool IsFloorPiece(const hb::Furniture& furniture) {
  return !furniture.walk_over() &&
         (furniture.kind() == hb::FURNITURE_KIND_FLOOR || furniture.kind() == hb::FURNITURE_KIND_UNSPECIFIED);
}

template <typename List>
bool Has(const List& list, const std::string& item) {
  return std::find(list.begin(), list.end(), item) != list.end();
}

class ProgramMaker {
 public:
  ProgramMaker(const BriefFacts& facts, const Handbook& handbook, double area_m2, const Choice& choice)
      : facts_(facts), handbook_(handbook), area_m2_(area_m2), choice_(choice) {
    program_.archetype = &EffectiveArchetype(facts, handbook);
    program_.changes = AllChanges(facts);
    if (program_.archetype->max_tertiaries() > 0) program_.max_tertiaries = program_.archetype->max_tertiaries();
  }

  RoomProgram Make() {
    TakeBand();
    for (const hb::Changes* changes : program_.changes) Apply(*changes);
    AddWishes();
    RemoveRefusals();
    CountPeople();
    GiveZonesTheirPrimaries();
    return std::move(program_);
  }

 private:
  const hb::Band& BandByArea() const {
    const auto& bands = program_.archetype->bands();
    for (const hb::Band& band : bands) {
      if (band.max_area_m2() == 0 || area_m2_ < band.max_area_m2()) return band;
    }
    return bands[bands.size() - 1];
  }

  void TakeBand() {
    const hb::Band& band = BandByArea();
    for (const std::string& name : band.zones()) {
      for (const hb::ZoneSpec& zone : program_.archetype->zones()) {
        if (zone.name() == name) program_.zones.push_back(zone);
      }
    }
    for (const hb::ObjectEntry& entry : band.objects()) Add(entry, "band");
    for (const hb::ObjectEntry& entry : program_.archetype->tertiaries()) Add(entry, "tertiary");
  }

  // Adds an entry to the list that its class belongs to.
  void Add(const hb::ObjectEntry& entry, const std::string& owner) {
    const std::string key = owner + "." + entry.furniture() + "." + entry.zone();
    if (!Holds(entry.condition(), *program_.archetype, area_m2_, choice_, key)) return;
    std::string name = entry.furniture();
    const std::size_t pick = choice_.Index(key, static_cast<std::size_t>(entry.or_furniture_size()) + 1);
    if (pick > 0) name = entry.or_furniture(static_cast<int>(pick) - 1);
    const hb::Furniture* furniture = handbook_.FindFurniture(name);
    if (furniture == nullptr) return;
    ProgramItem item{furniture, &entry, std::max(1, entry.count()), entry.zone(), false, entry.drop_order()};
    if (IsFloorPiece(*furniture)) {
      if (item.zone.empty()) item.zone = HomeOf(*furniture);
      program_.floor_items.push_back(item);
    } else {
      program_.tertiary_items.push_back(item);
    }
  }

  bool HasZone(const std::string& name) const {
    return std::any_of(program_.zones.begin(), program_.zones.end(), [&](const auto& z) { return z.name() == name; });
  }

  // The zone where a class belongs when nothing says so.
  std::string HomeOf(const hb::Furniture& furniture) const {
    for (const hb::ZoneSpec& zone : program_.zones) {
      if (Has(zone.primaries(), furniture.name())) return zone.name();
    }
    for (const std::string& hint : furniture.zone_hints()) {
      if (HasZone(hint)) return hint;
    }
    for (const hb::Relation& relation : furniture.relations()) {
      for (const ProgramItem& item : program_.floor_items) {
        if (Has(relation.targets(), item.furniture->name())) return item.zone;
      }
    }
    return program_.zones.empty() ? "" : program_.zones.front().name();
  }

  void Apply(const hb::Changes& changes) {
    for (auto* list : {&program_.floor_items, &program_.tertiary_items}) Substitute(changes, *list);
    for (const std::string& removal : changes.removals()) Remove(removal);
    for (const hb::ObjectEntry& count : changes.counts()) {
      for (auto* list : {&program_.floor_items, &program_.tertiary_items}) {
        for (ProgramItem& item : *list) {
          if (item.furniture->name() == count.furniture()) item.count = std::max(1, count.count());
        }
      }
    }
    if (Holds(changes.zone_condition(), *program_.archetype, area_m2_, choice_, "zones")) AddZones(changes);
    // Additions stand before the archetype's decoration: they are why the brief was written.
    std::vector<ProgramItem> usual = std::move(program_.tertiary_items);
    program_.tertiary_items.clear();
    for (const hb::ObjectEntry& entry : changes.additions()) {
      if (!Contains(entry.furniture()) && !Lists(usual, entry.furniture())) Add(entry, "addition");
    }
    program_.tertiary_items.insert(program_.tertiary_items.end(), usual.begin(), usual.end());
    DropLast(program_.floor_items, changes.fewer_secondaries(), program_.zones.size());
    DropLast(program_.tertiary_items, changes.fewer_tertiaries(), 3);
    if (changes.primary_scale() > 0) program_.primary_scale *= changes.primary_scale();
  }

  void Substitute(const hb::Changes& changes, std::vector<ProgramItem>& items) {
    for (ProgramItem& item : items) {
      std::vector<const hb::Furniture*> options;
      for (const hb::Substitution& substitution : changes.substitutions()) {
        const hb::Furniture* to = handbook_.FindFurniture(substitution.to());
        if (substitution.from() == item.furniture->name() && to != nullptr &&
            Holds(substitution.condition(), *program_.archetype, area_m2_, choice_,
                  "substitution." + substitution.to())) {
          options.push_back(to);
        }
      }
      if (options.empty()) continue;
      const hb::Furniture* came = options[choice_.Index("substitution." + item.furniture->name(), options.size())];
      program_.substitutes.emplace_back(item.furniture->name(), came->name());
      item.furniture = came;
    }
  }

  void Remove(const std::string& name) {
    for (auto* list : {&program_.floor_items, &program_.tertiary_items}) {
      std::erase_if(*list, [&](const ProgramItem& item) { return item.furniture->name() == name; });
    }
  }

  static bool Lists(const std::vector<ProgramItem>& items, const std::string& name) {
    return std::any_of(items.begin(), items.end(), [&](const auto& item) { return item.furniture->name() == name; });
  }

  bool Contains(const std::string& name) const {
    return Lists(program_.floor_items, name) || Lists(program_.tertiary_items, name);
  }

  void AddZones(const hb::Changes& changes) {
    auto at = changes.zones_first() && !program_.zones.empty() ? program_.zones.begin() + 1 : program_.zones.end();
    for (const hb::ZoneSpec& zone : changes.zones()) {
      if (!HasZone(zone.name())) at = program_.zones.insert(at, zone) + 1;
    }
  }

  static void DropLast(std::vector<ProgramItem>& items, int count, std::size_t least) {
    for (; count > 0 && items.size() > least; --count) items.pop_back();
  }

  void AddWishes() {
    for (auto wish = facts_.wishes.rbegin(); wish != facts_.wishes.rend(); ++wish) AddWish(*wish);
  }

  void AddWish(const Wish& wish) {
    for (auto* list : {&program_.floor_items, &program_.tertiary_items}) {
      for (ProgramItem& item : *list) {
        if (item.furniture != wish.furniture) continue;
        item.count = wish.count;
        item.requested = true;
        if (list == &program_.floor_items) SeatAt(*wish.furniture, wish.count, wish.seats, std::string(item.zone));
        return;
      }
    }
    if (!IsFloorPiece(*wish.furniture)) {
      program_.tertiary_items.insert(program_.tertiary_items.begin(),
                                     {wish.furniture, nullptr, wish.count, "", true, 0});
      return;
    }
    const hb::ZoneSpec& makes = wish.furniture->makes_zone();
    if (!makes.name().empty() && !HasZone(makes.name()) && HintedZone(*wish.furniture).empty()) {
      program_.zones.push_back(makes);
    }
    const std::string zone = HasZone(makes.name()) ? makes.name() : HomeOf(*wish.furniture);
    ReplaceRivals(*wish.furniture, zone);
    program_.floor_items.insert(program_.floor_items.begin(), {wish.furniture, nullptr, wish.count, zone, true, 0});
    SeatAt(*wish.furniture, wish.count, wish.seats, zone);
    for (const hb::ObjectEntry& companion : wish.furniture->companions()) {
      if (Contains(companion.furniture())) continue;
      const hb::Furniture* furniture = handbook_.FindFurniture(companion.furniture());
      if (furniture == nullptr) continue;
      auto& list = IsFloorPiece(*furniture) ? program_.floor_items : program_.tertiary_items;
      list.push_back({furniture, &companion, std::max(1, companion.count()), zone, false, companion.drop_order()});
    }
  }

  // Every one of several desks has its chair, every table of a zone of its own the seats that belong to it, or as many
  // as were asked for.
  void SeatAt(const hb::Furniture& furniture, int count, int seats, const std::string& zone) {
    for (const hb::ObjectEntry& companion : furniture.companions()) {
      const hb::Furniture* seat = handbook_.FindFurniture(companion.furniture());
      if (seat == nullptr || !IsSeat(*seat)) continue;
      const int wanted = count * (seats > 0 ? seats : std::max(1, companion.count()));
      const auto there = std::ranges::find_if(
          program_.floor_items, [&](const ProgramItem& item) { return item.furniture == seat && item.zone == zone; });
      if (there == program_.floor_items.end()) {
        if (IsWished(*seat)) continue;
        program_.floor_items.push_back({seat, &companion, wanted, zone, false, companion.drop_order()});
      } else if (!there->requested) {
        there->count = seats > 0 || count > 1 ? wanted : std::max(there->count, wanted);
      }
      return;
    }
  }

  static bool IsSeat(const hb::Furniture& furniture) {
    return furniture.category() == "chair" || furniture.category() == "stool";
  }

  bool IsWished(const hb::Furniture& furniture) const {
    return std::ranges::any_of(facts_.wishes, [&](const Wish& wish) { return wish.furniture == &furniture; });
  }

  // A wished-for primary takes the place of the usual one of its zone: a bunk bed comes instead of the double bed. So
  // does what makes such a zone by itself, and whoever sat at the usual one goes as well.
  void ReplaceRivals(const hb::Furniture& furniture, const std::string& zone_name) {
    const bool makes_it = furniture.makes_zone().name() == zone_name;
    for (const hb::ZoneSpec& zone : program_.zones) {
      if (zone.name() != zone_name || !(makes_it || Has(zone.primaries(), furniture.name()))) continue;
      std::erase_if(program_.floor_items, [&](const ProgramItem& item) {
        if (item.requested || item.zone != zone_name) return false;
        const bool same = item.furniture->category() == furniture.category();
        return same || (makes_it && (Has(zone.primaries(), item.furniture->name()) || IsSeat(*item.furniture)));
      });
    }
  }

  std::string HintedZone(const hb::Furniture& furniture) const {
    for (const hb::ZoneSpec& zone : program_.zones) {
      if (Has(zone.primaries(), furniture.name()) || Has(furniture.zone_hints(), zone.name())) return zone.name();
    }
    return "";
  }

  void RemoveRefusals() {
    for (const hb::Furniture* refusal : facts_.refusals) {
      Remove(refusal->name());
      for (const hb::ObjectEntry& companion : refusal->companions()) RemoveUnaccompanied(companion.furniture());
    }
  }

  // Without its desk the office chair goes as well, unless another piece brings one or the brief asks for it.
  void RemoveUnaccompanied(const std::string& name) {
    for (const ProgramItem& item : program_.floor_items) {
      if (item.requested && item.furniture->name() == name) return;
      for (const hb::ObjectEntry& companion : item.furniture->companions()) {
        if (companion.furniture() == name) return;
      }
    }
    Remove(name);
  }

  // The class that there is one of for each person, and the seats at each of it.
  void CountPeople() {
    if (!facts_.people || program_.archetype->per_person().empty()) return;
    for (std::size_t i = 0; i < program_.floor_items.size(); ++i) {
      ProgramItem& item = program_.floor_items[i];
      if (item.furniture->name() != program_.archetype->per_person() || item.requested) continue;
      item.count = *facts_.people;
      SeatAt(*item.furniture, item.count, 0, std::string(item.zone));
      return;
    }
  }

  // Zones whose primary is gone go as well; what stood in them moves to the first zone.
  void GiveZonesTheirPrimaries() {
    std::vector<hb::ZoneSpec> kept;
    for (const hb::ZoneSpec& zone : program_.zones) {
      const bool used = std::any_of(program_.floor_items.begin(), program_.floor_items.end(),
                                    [&](const ProgramItem& item) { return item.zone == zone.name(); });
      if (used) kept.push_back(zone);
    }
    if (kept.empty() && !program_.zones.empty()) kept.push_back(program_.zones.front());
    program_.zones = std::move(kept);
    for (ProgramItem& item : program_.floor_items) {
      if (!HasZone(item.zone)) item.zone = program_.zones.front().name();
    }
  }

  const BriefFacts& facts_;
  const Handbook& handbook_;
  const double area_m2_;
  const Choice& choice_;
  RoomProgram program_;
};

}  // namespace

bool Holds(const hb::Condition& condition, const hb::Archetype& archetype, double area_m2, const Choice& choice,
           const std::string& key) {
  if (area_m2 < condition.min_area_m2()) return false;
  if (condition.max_area_m2() > 0 && area_m2 >= condition.max_area_m2()) return false;
  if (!condition.rooms().empty() && !Has(condition.rooms(), archetype.name())) return false;
  return condition.chance() <= 0 || choice.Happens("chance." + key, condition.chance());
}

std::vector<const hb::Changes*> AllChanges(const BriefFacts& facts) {
  std::vector<const hb::Changes*> changes;
  for (const hb::Need* need : facts.needs) changes.push_back(&need->changes());
  for (const hb::Theme* theme : facts.themes) changes.push_back(&theme->changes());
  return changes;
}

const hb::Archetype& EffectiveArchetype(const BriefFacts& facts, const Handbook& handbook) {
  const hb::Archetype* archetype = facts.archetype;
  for (const hb::Changes* changes : AllChanges(facts)) {
    if (const hb::Archetype* other = handbook.FindArchetype(changes->becomes_room())) archetype = other;
  }
  return *archetype;
}

std::vector<std::string> WithSubstitutes(const google::protobuf::RepeatedPtrField<std::string>& classes,
                                         const RoomProgram& program) {
  std::vector<std::string> all;
  for (const std::string& name : classes) {
    all.push_back(name);
    for (const auto& [went, came] : program.substitutes) {
      if (went == name && !Has(all, came)) all.push_back(came);
    }
  }
  return all;
}

RoomProgram MakeRoomProgram(const BriefFacts& facts, const Handbook& handbook, double area_m2, const Choice& choice) {
  return ProgramMaker(facts, handbook, area_m2, choice).Make();
}

}  // namespace flair::language
