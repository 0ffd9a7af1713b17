// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/program/essentials.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "language_worker/handbook/parts/furniture_index.h"
#include "language_worker/handbook/reading/piece_words.h"

namespace flair::language {
namespace {

int NeededOf(const hb::Essential& essential) { return std::max(1, essential.count()); }

// Whether it is one of the essential's classes, or what a theme has put in its place.
bool IsNamed(const hb::Essential& essential, const hb::Furniture& furniture, const RoomProgram& program) {
  return Includes(WithSubstitutes(essential.furniture(), program), furniture.name());
}

// Whether one of that class will do.
bool Serves(const hb::Essential& essential, const hb::Furniture& furniture, const RoomProgram& program) {
  return Includes(essential.categories(), furniture.category()) || IsNamed(essential, furniture, program);
}

// Whether it will do because the brief wants that instead: who asks for settles sits on them and on no sofa.
bool Serves(const hb::Essential& essential, const ProgramItem& item, const RoomProgram& program,
            const Handbook& handbook) {
  if (Serves(essential, *item.furniture, program)) return true;
  const hb::Furniture* usual = handbook.FindFurniture(essential.furniture(0));
  const auto is_easy = [](const hb::Furniture& piece) {
    return IsFloorPiece(piece) && PlacesOn(piece) > 0 && piece.category() != "bed" && !IsSeat(piece);
  };
  // An audience in rows has no tables, and no other chairs.
  const bool audience = item.in_rows && IsSeat(*item.furniture);
  if (!item.requested || usual == nullptr) return false;
  return (is_easy(*usual) && is_easy(*item.furniture)) ||
         (audience && (usual->category().ends_with("table") || IsSeat(*usual)));
}

// How many of what is needed one piece makes up for: a bunk bed is a bed for each of two.
int WorthOf(const hb::Essential& essential, const hb::Furniture& furniture, const Handbook& handbook) {
  const hb::Furniture* usual = handbook.FindFurniture(essential.furniture(0));
  const bool sleeps_two = furniture.category() == "bunk_bed" && usual != nullptr && usual->category() == "bed";
  return sleeps_two ? std::max(1, PlacesOn(furniture) / std::max(1, PlacesOn(*usual))) : 1;
}

// The first of its classes, or what a theme has in its place; null when the brief wants none of them.
const hb::Furniture* ToBring(const hb::Essential& essential, const BriefFacts& facts, const Handbook& handbook,
                             const RoomProgram& program) {
  if (facts.nothing_else) return nullptr;
  const hb::Furniture* first = handbook.FindFurniture(essential.furniture(0));
  for (const auto& [went, came] : program.substitutes) {
    const auto counts_it = [&](const Wish& wish) { return wish.counted && wish.furniture->name() == came; };
    // One bunk bed is asked for: the third child has a bed.
    if (first == nullptr || went != first->name() || std::ranges::any_of(facts.wishes, counts_it)) continue;
    first = handbook.FindFurniture(came);
  }
  const bool refused = std::ranges::find(facts.refusals, first) != facts.refusals.end();
  return refused ? nullptr : first;
}

// Whether the stock has one of the essential's classes of that category: an island is no kitchen's only worktop.
bool StockHas(const hb::Essential& essential, const std::string& category, const RoomProgram& program) {
  return std::ranges::any_of(program.floor_items, [&](const ProgramItem& item) {
    return !item.requested && item.furniture->category() == category && IsNamed(essential, *item.furniture, program);
  });
}

void Bring(const hb::Essential& essential, const hb::Furniture& furniture, int count, RoomProgram& program) {
  if (!IsFloorPiece(furniture)) {
    program.tertiary_items.push_back({&furniture, nullptr, count, ""});
    return;
  }
  std::string zone = HasZone(program, essential.zone()) ? essential.zone() : "";
  const bool has_home = std::ranges::any_of(program.zones, [&](const hb::ZoneSpec& one) {
    return Includes(one.primaries(), furniture.name()) || Includes(furniture.zone_hints(), one.name());
  });
  if (zone.empty() && !has_home && !furniture.makes_zone().name().empty()) {
    program.zones.push_back(furniture.makes_zone());
  }
  if (zone.empty()) zone = HomeOf(furniture, program);
  program.floor_items.push_back({&furniture, nullptr, count, zone});
}

std::string WhyMissing(const hb::Essential& essential, const v1::ObjectList& list) {
  for (const v1::Omission& omission : list.omissions()) {
    if (Includes(essential.furniture(), omission.name())) return omission.reason();
  }
  return "it is not among the pieces that were listed or asked for";
}

}  // namespace

void BringEssentials(const BriefFacts& facts, const Handbook& handbook, double area_m2, const Choice& choice,
                     RoomProgram& program) {
  const auto collect = [&](const auto& essentials, const hb::Archetype& archetype) {
    for (const hb::Essential& essential : essentials) {
      if (Holds(essential.condition(), archetype, area_m2, choice, "essential." + essential.furniture(0))) {
        program.essentials.push_back(&essential);
      }
    }
  };
  collect(program.archetype->essentials(), *program.archetype);
  for (const FurtherKind& also : program.also) collect(also.archetype->essentials(), *also.archetype);
  for (const hb::Changes* changes : program.changes) collect(changes->essentials(), *program.archetype);
  for (const hb::Essential* essential : program.essentials) {
    int missing = NeededOf(*essential);
    for (const auto* items : {&program.floor_items, &program.tertiary_items}) {
      for (const ProgramItem& item : *items) {
        if (Serves(*essential, item, program, handbook))
          missing -= item.count * WorthOf(*essential, *item.furniture, handbook);
      }
    }
    if (missing <= 0) continue;
    const hb::Furniture* furniture = ToBring(*essential, facts, handbook, program);
    if (furniture != nullptr) Bring(*essential, *furniture, missing, program);
  }
}

void MarkEssentials(const Handbook& handbook, RoomProgram& program) {
  for (auto* items : {&program.floor_items, &program.tertiary_items}) {
    for (ProgramItem& item : *items) item.essential = 0;
  }
  for (const hb::Essential* essential : program.essentials) {
    int left = NeededOf(*essential);
    // What is asked for before the stock: a bathtub will do for a shower; then the classes themselves before others.
    for (const auto& [requested, named] : {std::pair(true, true), {true, false}, {false, true}, {false, false}}) {
      for (auto* items : {&program.floor_items, &program.tertiary_items}) {
        for (ProgramItem& item : *items) {
          const bool serves = item.requested == requested && Serves(*essential, item, program, handbook);
          if (left <= 0 || !serves || IsNamed(*essential, *item.furniture, program) != named) continue;
          if (requested && !named && StockHas(*essential, item.furniture->category(), program)) continue;
          const int worth = WorthOf(*essential, *item.furniture, handbook);
          item.essential = std::max(item.essential, std::min((left + worth - 1) / worth, item.count));
          left -= item.count * worth;
        }
      }
    }
  }
  std::ranges::stable_partition(program.tertiary_items, [](const ProgramItem& item) { return item.essential > 0; });
}

void TellMissingEssentials(const RoomProgram& program, const Handbook& handbook, v1::ObjectList& list) {
  const FurnitureIndex index(handbook);
  std::vector<v1::Diagnostic> remarks;
  for (const hb::Essential* essential : program.essentials) {
    int there = 0;
    for (const v1::Object& object : list.objects()) {
      const hb::Furniture* furniture = index.Find(object.name());
      const auto item = std::ranges::find(program.floor_items, furniture, &ProgramItem::furniture);
      const bool serves =
          furniture != nullptr && (item == program.floor_items.end() ? Serves(*essential, *furniture, program)
                                                                     : Serves(*essential, *item, program, handbook));
      there += serves ? WorthOf(*essential, *furniture, handbook) : 0;
    }
    if (there >= NeededOf(*essential)) continue;
    v1::Diagnostic& remark = remarks.emplace_back();
    remark.set_severity(v1::SEVERITY_WARNING);
    remark.set_code("essential_missing");
    const std::string& called = essential->called().empty() ? essential->furniture(0) : essential->called();
    remark.set_message(fmt::format("The {} lacks what it cannot do without, {}: {}.", program.archetype->name(), called,
                                   WhyMissing(*essential, list)));
  }
  for (v1::Diagnostic& other : *list.mutable_diagnostics()) remarks.push_back(std::move(other));
  list.mutable_diagnostics()->Assign(remarks.begin(), remarks.end());
}

}  // namespace flair::language
