// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/program/room_program.h"

#include <algorithm>

#include "language_worker/handbook/program/essentials.h"

namespace flair::language {

bool Lists(const std::vector<ProgramItem>& items, const std::string& name) {
  return std::any_of(items.begin(), items.end(), [&](const auto& item) { return item.furniture->name() == name; });
}

bool Lists(const RoomProgram& program, const std::string& name) {
  return Lists(program.floor_items, name) || Lists(program.tertiary_items, name);
}

bool HasZone(const RoomProgram& program, const std::string& name) {
  return std::any_of(program.zones.begin(), program.zones.end(), [&](const auto& z) { return z.name() == name; });
}

std::string HomeOf(const hb::Furniture& furniture, const RoomProgram& program) {
  for (const hb::ZoneSpec& zone : program.zones) {
    if (Includes(zone.primaries(), furniture.name())) return zone.name();
  }
  // A single bed is where the usual double bed would be.
  for (const hb::ZoneSpec& zone : program.zones) {
    for (const ProgramItem& item : program.floor_items) {
      const bool main = item.zone == zone.name() && Includes(zone.primaries(), item.furniture->name());
      if (main && item.furniture->category() == furniture.category() && furniture.category() != "box") return item.zone;
    }
  }
  for (const std::string& hint : furniture.zone_hints()) {
    if (HasZone(program, hint)) return hint;
  }
  for (const hb::Relation& relation : furniture.relations()) {
    for (const ProgramItem& item : program.floor_items) {
      if (Includes(relation.targets(), item.furniture->name())) return item.zone;
    }
  }
  return program.zones.empty() ? "" : program.zones.front().name();
}

void Remove(const std::string& name, RoomProgram& program) {
  for (auto* list : {&program.floor_items, &program.tertiary_items}) {
    std::erase_if(*list, [&](const ProgramItem& item) { return item.furniture->name() == name; });
  }
}

namespace {

class ProgramMaker {
 public:
  ProgramMaker(const BriefFacts& facts, const Handbook& handbook, double area_m2, const Choice& choice)
      : facts_(facts), handbook_(handbook), area_m2_(area_m2), choice_(choice) {
    program_.archetype = &EffectiveArchetype(facts, handbook);
    program_.changes = AllChanges(facts);
    const auto floor =
        std::ranges::count_if(facts.wishes, [](const auto& one) { return IsFloorPiece(*one.furniture); });
    const std::size_t said = facts.wishes.size() + facts.refusals.size();
    program_.listed = floor >= 3 || (floor == 2 && said >= 3);
    if (program_.archetype->max_tertiaries() > 0) program_.max_tertiaries = program_.archetype->max_tertiaries();
  }

  RoomProgram Make() {
    TakeBands();
    for (const hb::Changes* changes : program_.changes) Apply(*changes);
    ApplyWishes(facts_, handbook_, program_);
    if (!IsOnlyGuessed() && DoesWhatItsKindDoes(facts_, program_))
      BringEssentials(facts_, handbook_, area_m2_, choice_, program_);
    MarkEssentials(handbook_, program_);
    KeepStock(facts_, program_);
    BringHosts(facts_, handbook_, program_);
    LeaveOutWhatCameLater();
    GatherSeats();
    GiveZonesTheirPrimaries();
    SplitIntoGroups(facts_, area_m2_, handbook_, program_);
    MarkEssentials(handbook_, program_);
    return std::move(program_);
  }

 private:
  // What each kind that the room is has on its share of the floor; of what two of them have one is enough.
  void TakeBands() {
    program_.also = AlsoOf(facts_, *program_.archetype);
    double all_m2 = UsualArea(*program_.archetype);
    for (const FurtherKind& also : program_.also) all_m2 += also.share * UsualArea(*also.archetype);
    TakeBand(*program_.archetype, area_m2_ * UsualArea(*program_.archetype) / all_m2, "");
    for (const FurtherKind& also : program_.also) {
      const double share_m2 = area_m2_ * also.share * UsualArea(*also.archetype) / all_m2;
      TakeBand(*also.archetype, share_m2, also.archetype->name() + ".");
    }
  }

  // Of what comes in numbers a hall has more than the largest room that its kind lists, where people come and the brief
  // leaves the furniture to us: a library of 80 m2 has more than eight bookcases.
  int GrowthOf(const hb::Archetype& archetype, const hb::Band& band, double share_m2) const {
    constexpr double kOfListed = 1.5, kMost = 3;
    if (band.max_area_m2() > 0 || program_.listed || facts_.people || archetype.per_person().empty()) return 1;
    const int bands = archetype.bands_size();
    const double listed_m2 =
        std::max(UsualArea(archetype), bands > 1 ? archetype.bands(bands - 2).max_area_m2() : 0.0) * kOfListed;
    // Whole times, so that tables keep their chairs.
    return static_cast<int>(std::lround(std::clamp(share_m2 / listed_m2, 1.0, kMost)));
  }

  void TakeBand(const hb::Archetype& archetype, double share_m2, const std::string& owner) {
    const hb::Band& band = BandFor(archetype, share_m2);
    for (const std::string& name : band.zones()) {
      for (const hb::ZoneSpec& zone : archetype.zones()) {
        if (zone.name() == name && !HasZone(program_, name)) program_.zones.push_back(zone);
      }
    }
    const bool further = !owner.empty();
    const int grown = GrowthOf(archetype, band, share_m2);
    for (const hb::ObjectEntry& entry : band.objects()) {
      if (IsOnlyGuessed()) break;
      if (further && IsThereAlready(entry.furniture())) continue;
      const std::size_t before = program_.floor_items.size();
      Add(entry, owner + "band", archetype);
      if (entry.count() < 2 || program_.floor_items.size() == before) continue;
      int& count = program_.floor_items.back().count;
      count = std::min(kMostOfAKind, count * grown);
    }
    for (const hb::ObjectEntry& entry : archetype.tertiaries()) {
      if (!further || !Lists(program_, entry.furniture())) Add(entry, owner + "tertiary", archetype);
    }
  }

  // Who lists what is in a room of a kind that nobody knows wants that, and not the stock of the kind that came
  // nearest.
  bool IsOnlyGuessed() const { return !facts_.archetype_named && program_.listed; }

  // The piece, or another that the same seats are pulled up to: of two kinds with a dining table one has it.
  bool IsThereAlready(const std::string& name) const {
    if (Lists(program_, name)) return true;
    const hb::Furniture* furniture = handbook_.FindFurniture(name);
    if (furniture == nullptr) return false;
    return std::ranges::any_of(program_.floor_items, [&](const ProgramItem& item) {
      return std::ranges::any_of(item.furniture->companions(), [&](const hb::ObjectEntry& theirs) {
        return std::ranges::any_of(furniture->companions(),
                                   [&](const hb::ObjectEntry& ours) { return ours.furniture() == theirs.furniture(); });
      });
    });
  }

  // Adds an entry to the list that its class belongs to.
  void Add(const hb::ObjectEntry& entry, const std::string& owner, const hb::Archetype& archetype) {
    const std::string key = owner + "." + entry.furniture() + "." + entry.zone();
    if (!Holds(entry.condition(), archetype, area_m2_, choice_, key)) return;
    // Nobody watches a screen beside the fire that they asked for.
    const auto is_instead = [&](const Wish& w) { return Includes(entry.condition().without(), w.furniture->name()); };
    if (std::ranges::any_of(facts_.wishes, is_instead)) return;
    std::string name = entry.furniture();
    const std::size_t pick = choice_.Index(key, static_cast<std::size_t>(entry.or_furniture_size()) + 1);
    if (pick > 0) name = entry.or_furniture(static_cast<int>(pick) - 1);
    const hb::Furniture* furniture = handbook_.FindFurniture(name);
    if (furniture == nullptr) return;
    ProgramItem item{furniture, &entry, std::max(1, entry.count()), entry.zone(), false, entry.drop_order()};
    if (IsFloorPiece(*furniture)) {
      if (item.zone.empty()) item.zone = HomeOf(*furniture, program_);
      program_.floor_items.push_back(item);
    } else {
      program_.tertiary_items.push_back(item);
    }
  }

  void Apply(const hb::Changes& changes) {
    for (auto* list : {&program_.floor_items, &program_.tertiary_items}) Substitute(changes, *list);
    for (const std::string& removal : changes.removals()) Remove(removal, program_);
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
      if (!Lists(program_, entry.furniture()) && !Lists(usual, entry.furniture()))
        Add(entry, "addition", *program_.archetype);
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

  void AddZones(const hb::Changes& changes) {
    auto at = changes.zones_first() && !program_.zones.empty() ? program_.zones.begin() + 1 : program_.zones.end();
    for (const hb::ZoneSpec& zone : changes.zones()) {
      if (!HasZone(program_, zone.name())) at = program_.zones.insert(at, zone) + 1;
    }
  }

  static void DropLast(std::vector<ProgramItem>& items, int count, std::size_t least) {
    for (; count > 0 && items.size() > least; --count) items.pop_back();
  }

  // Rooms of an earlier time have what there was instead, unless the brief asks for it all the same.
  void LeaveOutWhatCameLater() {
    std::optional<int> year = facts_.year;
    for (const hb::Changes* changes : program_.changes) {
      if (changes->year() != 0) year = std::min(year.value_or(changes->year()), changes->year());
    }
    if (!year) return;
    const auto came_later = [&](const hb::Furniture* one) { return one->since_year() > *year; };
    // A pharaoh's server room is no joke of ours.
    if (std::ranges::all_of(program_.floor_items, came_later, &ProgramItem::furniture)) return;
    for (auto* items : {&program_.floor_items, &program_.tertiary_items}) {
      for (ProgramItem& item : *items) {
        const hb::Furniture* then = item.furniture;
        while (then != nullptr && came_later(then)) then = handbook_.FindFurniture(then->before());
        if (item.requested || then == nullptr || then == item.furniture) continue;
        program_.substitutes.emplace_back(item.furniture->name(), then->name());
        item.furniture = then;
        item.entry = nullptr;
      }
      std::erase_if(*items, [&](const ProgramItem& item) { return !item.requested && came_later(item.furniture); });
    }
    std::erase_if(program_.essentials, [&](const hb::Essential* essential) {
      const hb::Furniture* furniture = handbook_.FindFurniture(essential->furniture(0));
      return furniture != nullptr && came_later(furniture);
    });
  }

  // Several armchairs, or one that is asked for by itself, stand with the sofa or round the coffee table, not each in a
  // corner to read in.
  void GatherSeats() {
    const auto zone_of = [&](const auto&... categories) {
      const auto found = std::ranges::find_if(program_.floor_items, [&](const ProgramItem& item) {
        return ((item.furniture->category() == categories) || ...);
      });
      return found == program_.floor_items.end() ? std::string() : found->zone;
    };
    std::string middle = zone_of("sofa", "corner_sofa");
    if (middle.empty()) middle = zone_of("coffee_table");
    for (ProgramItem& item : program_.floor_items) {
      if (middle.empty() || item.furniture->category() != "armchair" || item.seat_of != nullptr) continue;
      const bool placed = std::ranges::any_of(facts_.places, [&](const Place& place) {
        const int most = place.asked->relation().condition().max_count();
        return place.furniture == item.furniture && (most == 0 || item.count <= most);
      });
      const bool alone = std::ranges::none_of(program_.floor_items, [&](const ProgramItem& other) {
        return &other != &item && other.zone == item.zone && other.requested;
      });
      if (!placed && (item.count > 1 || (item.requested && alone))) item.zone = middle;
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
      if (!HasZone(program_, item.zone)) item.zone = program_.zones.front().name();
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
  if (!condition.rooms().empty() && !Includes(condition.rooms(), archetype.name())) return false;
  return condition.chance() <= 0 || choice.Happens("chance." + key, condition.chance());
}

std::vector<const hb::Changes*> AllChanges(const BriefFacts& facts) {
  std::vector<const hb::Changes*> changes;
  for (const hb::Need* need : facts.needs) changes.push_back(&need->changes());
  for (const hb::Theme* theme : facts.themes) changes.push_back(&theme->changes());
  return changes;
}

double UsualArea(const hb::Archetype& archetype) {
  return archetype.width_m().typical() * archetype.depth_m().typical();
}

std::vector<FurtherKind> AlsoOf(const BriefFacts& facts, const hb::Archetype& archetype) {
  return &archetype == facts.archetype ? facts.also : std::vector<FurtherKind>();
}

const hb::Archetype& EffectiveArchetype(const BriefFacts& facts, const Handbook& handbook) {
  const hb::Archetype* archetype = facts.archetype;
  for (const hb::Changes* changes : AllChanges(facts)) {
    if (const hb::Archetype* other = handbook.FindArchetype(changes->becomes_room())) archetype = other;
  }
  return *archetype;
}

RoomProgram MakeRoomProgram(const BriefFacts& facts, const Handbook& handbook, double area_m2, const Choice& choice) {
  return ProgramMaker(facts, handbook, area_m2, choice).Make();
}

}  // namespace flair::language
