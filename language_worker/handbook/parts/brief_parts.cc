// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/parts/brief_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "language_worker/handbook/reading/piece_words.h"
#include "language_worker/handbook/rooms/describe_room.h"
#include "language_worker/handbook/sentences/list_constraints.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::language {
namespace {

// In all; a solver does not get better by more, and each has its price.
constexpr int kMostSentences = 600;
constexpr double kPlacementWeight = 1;

// The sentences of a list that place a tertiary: those that name it first.
std::vector<v1::Sentence> PlacingSentences(const v1::Object& object, const v1::ConstraintList& list) {
  std::vector<v1::Sentence> placing;
  for (const v1::Sentence& sentence : list.sentences()) {
    const bool first = !sentence.subject_ids().empty() && sentence.subject_ids(0) == object.id();
    if (sentence.scope() == v1::SENTENCE_SCOPE_TERTIARY && first) placing.push_back(sentence);
  }
  return placing;
}

// Whether a list says something about an object, by its id or by its name.
bool Mentions(const v1::ConstraintList& list, const v1::Object& object) {
  const std::string name = PlainName(object.name());
  return std::ranges::any_of(list.sentences(), [&](const v1::Sentence& sentence) {
    const auto& ids = sentence.subject_ids();
    if (!ids.empty()) return std::find(ids.begin(), ids.end(), object.id()) != ids.end();
    return PlainName(sentence.text()).find(name) != std::string::npos;
  });
}

// The usual list with the placements of the tertiaries that their lister placed in the stead of its own.
v1::ConstraintList WithPlacements(const v1::ObjectList& objects, const v1::ConstraintList& usual) {
  const bool placed = std::ranges::any_of(objects.objects(), [](const v1::Object& object) {
    return object.role() == v1::OBJECT_ROLE_TERTIARY && !object.placement().empty();
  });
  if (!placed) return usual;
  v1::ConstraintList list;
  for (const v1::Sentence& sentence : usual.sentences()) {
    if (sentence.scope() == v1::SENTENCE_SCOPE_TERTIARY) continue;
    *list.add_sentences() = sentence;
    list.mutable_sentences(list.sentences_size() - 1)->set_id(fmt::format("s{}", list.sentences_size()));
  }
  AddPlacements(objects, usual, list);
  *list.mutable_diagnostics() = usual.diagnostics();
  return list;
}

}  // namespace

std::string PlainName(std::string_view name) {
  std::string plain;
  for (const char c : name) {
    const bool upper = c >= 'A' && c <= 'Z';
    const bool word =
        upper || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80;
    if (word) {
      plain += upper ? static_cast<char>(c - 'A' + 'a') : c;
    } else if (!plain.empty() && plain.back() != ' ') {
      plain += ' ';
    }
  }
  if (!plain.empty() && plain.back() == ' ') plain.pop_back();
  return plain;
}

void TellNotAsAsked(const BriefFacts& facts, const Handbook& handbook, v1::ObjectList& list) {
  const auto count = [&](const hb::Furniture& furniture) {
    return static_cast<int>(std::ranges::count(list.objects(), furniture.name(), &v1::Object::name));
  };
  const auto tell_fewer = [&](const hb::Furniture& furniture, int there, int asked) {
    const bool told = std::ranges::count(list.omissions(), furniture.name(), &v1::Omission::name) > 0;
    if (there >= asked || told) return;
    AddDiagnostic(v1::SEVERITY_WARNING, "fewer_than_asked",
                  fmt::format("Of \"{}\" the brief asks for {}; the room has {}.", furniture.name(), asked, there),
                  list);
  };
  // Of one class all tables together: "six tables with two chairs each and one for eight".
  struct Seats {
    const hb::Furniture* seat;
    const hb::Furniture* host;
    int asked;
  };
  std::vector<Seats> seats;
  for (const Wish& wish : facts.wishes) {
    tell_fewer(*wish.furniture, count(*wish.furniture), wish.count);
    const hb::Furniture* seat = wish.seats > 0 ? SeatOf(*wish.furniture, handbook) : nullptr;
    if (seat == nullptr) continue;
    auto there = std::ranges::find(seats, seat, &Seats::seat);
    if (there == seats.end()) there = seats.insert(there, {seat, wish.furniture, 0});
    there->asked += wish.count * wish.seats;
  }
  for (const auto& [seat, host, asked] : seats) {
    int there = count(*seat);
    // The one across the table is a seat as well.
    for (const auto& companion : host->companions()) {
      const hb::Furniture* other = handbook.FindFurniture(companion.furniture());
      if (other != nullptr && other != seat && IsSeat(*other)) there += count(*other);
    }
    tell_fewer(*seat, there, asked);
  }
  for (const hb::Furniture* refusal : facts.refusals) {
    if (count(*refusal) == 0) continue;
    AddDiagnostic(v1::SEVERITY_WARNING, "refused_but_there",
                  fmt::format("The brief wants no {}; the room has one.", refusal->name()), list);
  }
}

std::vector<std::string> WantedZones(const v1::Brief& brief) {
  std::vector<std::string> wanted;
  for (const v1::Object& object : brief.object_list().objects()) {
    const std::string& zone = object.zone_id();
    if (!zone.empty() && std::find(wanted.begin(), wanted.end(), zone) == wanted.end()) wanted.push_back(zone);
  }
  return wanted;
}

void AddWantedZones(const v1::Brief& brief, v1::ZonePlan& plan) {
  for (const std::string& id : WantedZones(brief)) {
    const bool there = std::ranges::any_of(plan.zones(), [&](const v1::Zone& zone) { return zone.id() == id; });
    if (there) continue;
    v1::Zone& zone = *plan.add_zones();
    zone.set_id(id);
    zone.set_name(id);
    std::replace(zone.mutable_name()->begin(), zone.mutable_name()->end(), '_', ' ');
    AddDiagnostic(v1::SEVERITY_NOTE, "zone_of_objects",
                  fmt::format("The zone \"{}\" is here because the brief's own objects are in it.", id), plan);
  }
}

absl::StatusOr<v1::ZonePlan> PlanWantedZones(const v1::Brief& brief, const v1::Room& room, const Handbook& handbook) {
  absl::StatusOr<v1::ZonePlan> plan = PlanZones(brief, room, handbook);
  if (plan.ok()) AddWantedZones(brief, *plan);
  return plan;
}

void AddSentence(const std::string& text, v1::SentenceScope scope, double weight,
                 const std::vector<std::string>& subjects, v1::ConstraintList& list) {
  if (text.empty() || list.sentences_size() >= kMostSentences) return;
  v1::Sentence& sentence = *list.add_sentences();
  sentence.set_id(fmt::format("s{}", list.sentences_size()));
  sentence.set_text(text);
  sentence.set_scope(scope);
  sentence.set_weight(weight);
  for (const std::string& id : subjects) {
    const auto& there = sentence.subject_ids();
    if (std::find(there.begin(), there.end(), id) == there.end()) sentence.add_subject_ids(id);
  }
}

void AddSentence(const v1::Sentence& sentence, v1::ConstraintList& list) {
  AddSentence(sentence.text(), sentence.scope(), sentence.weight(),
              {sentence.subject_ids().begin(), sentence.subject_ids().end()}, list);
}

void AddPlacements(const v1::ObjectList& objects, const v1::ConstraintList& usual, v1::ConstraintList& list) {
  for (const v1::Object& object : objects.objects()) {
    if (object.role() != v1::OBJECT_ROLE_TERTIARY) continue;
    if (object.placement().empty()) {
      for (const v1::Sentence& sentence : PlacingSentences(object, usual)) AddSentence(sentence, list);
      continue;
    }
    std::vector<std::string> subjects = {object.id()};
    if (!object.host_id().empty()) subjects.push_back(object.host_id());
    AddSentence(object.placement(), v1::SENTENCE_SCOPE_TERTIARY, kPlacementWeight, subjects, list);
  }
}

absl::StatusOr<v1::ConstraintList> UsualConstraints(const ObjectsRequest& request, const v1::ObjectList& objects,
                                                    const Handbook& handbook) {
  ASSIGN_OR_RETURN(const v1::ConstraintList usual,
                   ListConstraints(request.brief, request.room, request.zones, objects, handbook));
  return WithPlacements(objects, usual);
}

absl::StatusOr<v1::ConstraintList> OwnConstraints(const ObjectsRequest& request, const v1::ObjectList& objects,
                                                  const Handbook& handbook) {
  v1::ConstraintList list = request.brief.constraint_list();
  ASSIGN_OR_RETURN(const v1::ConstraintList usual, UsualConstraints(request, objects, handbook));
  std::set<std::string> ids;
  for (const v1::Sentence& sentence : list.sentences()) ids.insert(sentence.id());
  int added = 0;
  for (const v1::Object& object : objects.objects()) {
    const bool unplaced = request.brief.has_object_list() && object.placement().empty();
    if (object.role() != v1::OBJECT_ROLE_TERTIARY || unplaced || Mentions(request.brief.constraint_list(), object))
      continue;
    for (const v1::Sentence& sentence : PlacingSentences(object, usual)) {
      v1::Sentence& made = *list.add_sentences();
      made = sentence;
      std::string id = fmt::format("t{}", ++added);
      while (!ids.insert(id).second) id = fmt::format("t{}", ++added);
      made.set_id(id);
    }
  }
  if (added > 0) {
    AddDiagnostic(
        v1::SEVERITY_NOTE, "placements_added",
        "What the brief's own constraints do not mention on walls, ceiling and tops goes where it usually does.", list);
  }
  return list;
}

}  // namespace flair::language
