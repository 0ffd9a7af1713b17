// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/meanings.h"

#include <algorithm>

#include "language_worker/handbook/reading/words.h"

namespace flair::language {
namespace {

using english::Domain;
using english::Kind;
using english::NounSense;
using english::WordNet;

constexpr int kAnyDistance = 100;
constexpr int kNear = 1;                 // "settle" is a bench, but no "seat" of the handbook
constexpr std::size_t kUsualSenses = 3;  // a "hammock" is a hill first

// The longest end of a compound that WordNet has, and its senses.
std::vector<NounSense> SensesOf(std::string_view noun) {
  while (true) {
    std::vector<NounSense> senses = WordNet::Get().SensesOf(noun);
    const std::size_t space = noun.find(' ');
    if (!senses.empty() || space == std::string_view::npos) return senses;
    noun.remove_prefix(space + 1);
  }
}

// The senses in which a noun may name something that stands in a room, likeliest first.
std::vector<NounSense> PhysicalOf(const std::vector<NounSense>& senses, std::size_t usual) {
  std::vector<NounSense> physical;
  for (std::size_t i = 0; i < std::min(senses.size(), usual); ++i) {
    const Domain domain = senses[i].domain;
    const bool first = i == 0 && (domain == Domain::kPlant || domain == Domain::kFood || domain == Domain::kSubstance ||
                                  domain == Domain::kCommunication || domain == Domain::kNaturalObject);
    if (domain == Domain::kArtifact || first) physical.push_back(senses[i]);
  }
  return physical;
}

}  // namespace

template <typename Entry>
void Meanings::Add(std::string_view text, const Entry* entry, int most_steps, Anchors<Entry>& anchors) {
  const std::optional<NounSense> sense = WordNet::Get().Find(text);
  if (sense) anchors.try_emplace(sense->id, Anchor<Entry>{entry, most_steps});
}

Meanings::Meanings(const hb::Handbook& handbook) {
  for (const hb::Furniture& furniture : handbook.furniture()) {
    for (const std::string& noun : furniture.meanings()) Add(noun, &furniture, kAnyDistance, things_);
  }
  for (const std::string& noun : WordsOf("meanings_of_no_things")) {
    Add<hb::Furniture>(noun, nullptr, kAnyDistance, things_);
  }
  for (const hb::Furniture& furniture : handbook.furniture()) {
    const std::vector<NounSense> senses = PhysicalOf(WordNet::Get().SensesOf(furniture.name()), kUsualSenses);
    if (!senses.empty()) things_.try_emplace(senses.front().id, Anchor<hb::Furniture>{&furniture, kNear});
  }
  for (const hb::Archetype& archetype : handbook.archetypes()) {
    for (const std::string& noun : archetype.meanings()) Add(noun, &archetype, kAnyDistance, rooms_);
  }
}

Thing Meanings::ThingOf(std::string_view noun, std::size_t usual) const {
  const std::vector<NounSense> senses = SensesOf(noun);
  Thing thing{.known = !senses.empty()};
  for (const NounSense& sense : PhysicalOf(senses, usual)) {
    for (const Kind& kind : WordNet::Get().KindsOf(sense)) {
      const auto anchor = things_.find(kind.id);
      if (anchor == things_.end() || kind.steps > anchor->second.most_steps) continue;
      thing.is_thing = thing.is_thing || anchor->second.entry != nullptr;
      thing.like = anchor->second.entry;
      return thing;
    }
    thing.is_thing = thing.is_thing || sense.domain == Domain::kArtifact;
  }
  return thing;
}

const hb::Archetype* Meanings::RoomOf(std::string_view noun) const {
  static const std::vector<std::uint32_t> places = [] {
    std::vector<std::uint32_t> ids;
    for (const std::string& place : WordsOf("meanings_of_places")) {
      if (const std::optional<NounSense> sense = WordNet::Get().Find(place)) ids.push_back(sense->id);
    }
    return ids;
  }();
  return RoomAmong(noun, kUsualSenses, [](const std::vector<Kind>& kinds) {
    return std::ranges::any_of(kinds, [](const Kind& kind) { return Includes(places, kind.id); });
  });
}

const hb::Archetype* Meanings::RoomFor(std::string_view noun) const {
  return RoomAmong(noun, 2, [](const std::vector<Kind>&) { return true; });
}

const hb::Archetype* Meanings::RoomAmong(std::string_view noun, std::size_t most,
                                         const std::function<bool(const std::vector<english::Kind>&)>& counts) const {
  std::vector<NounSense> senses = SensesOf(noun);
  senses.resize(std::min(senses.size(), most));
  for (const NounSense& sense : senses) {
    const std::vector<Kind> kinds = WordNet::Get().KindsOf(sense);
    if (!counts(kinds)) continue;
    for (const Kind& kind : kinds) {
      if (const auto anchor = rooms_.find(kind.id); anchor != rooms_.end()) return anchor->second.entry;
    }
  }
  return nullptr;
}

bool MeanTheSame(std::string_view a, std::string_view b) {
  const std::vector<NounSense> of_b = WordNet::Get().SensesOf(b);
  return std::ranges::any_of(WordNet::Get().SensesOf(a), [&](const NounSense& sense) {
    return std::ranges::find(of_b, sense.id, &NounSense::id) != of_b.end();
  });
}

bool IsKindOf(std::string_view name, std::string_view noun) {
  const std::vector<NounSense> of_noun = PhysicalOf(WordNet::Get().SensesOf(noun), kUsualSenses);
  const std::vector<NounSense> of_name = PhysicalOf(SensesOf(name), kUsualSenses);
  constexpr int kMostSteps = 2;  // everything is a kind of "equipment"
  return !of_name.empty() && std::ranges::any_of(WordNet::Get().KindsOf(of_name.front()), [&](const Kind& kind) {
    return kind.steps <= kMostSteps && std::ranges::find(of_noun, kind.id, &NounSense::id) != of_noun.end();
  });
}

bool MeansPeople(std::string_view noun) {
  const std::vector<NounSense> senses = WordNet::Get().SensesOf(noun);
  return !senses.empty() && senses.front().domain == Domain::kPerson && !IsFormIn("no_persons", noun);
}

}  // namespace flair::language
