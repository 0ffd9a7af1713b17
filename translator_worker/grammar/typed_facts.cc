// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "translator_worker/grammar/translate.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::translator {
namespace {

using english::RefKind;
using Participants = google::protobuf::RepeatedPtrField<v1::Participant>;

template <typename List, typename NameOf>
bool HasNamed(const List& list, const std::string& name, NameOf&& name_of) {
  return std::ranges::any_of(list, [&](const auto& one) { return name_of(one) == name; });
}

absl::StatusOr<english::Reference> ReferenceOf(const v1::TranslateRequest& request,
                                               const v1::Participant& participant) {
  const auto absent = [](std::string_view what, const std::string& name) {
    return NotFound("there is no {} \"{}\"", what, name);
  };
  english::Reference reference;
  const auto& objects = request.object_list().objects();
  switch (participant.thing_case()) {
    case v1::Participant::kObjectId: {
      const auto object =
          std::ranges::find_if(objects, [&](const v1::Object& one) { return one.id() == participant.object_id(); });
      if (object == objects.end()) return absent("object", participant.object_id());
      reference.kind = RefKind::kObjects;
      reference.name = object->name();
      reference.candidates = {static_cast<int>(object - objects.begin())};
      reference.chosen = true;
      break;
    }
    case v1::Participant::kZoneId:
      if (!HasNamed(request.zone_plan().zones(), participant.zone_id(), [](const auto& zone) { return zone.id(); }))
        return absent("zone", participant.zone_id());
      reference.kind = RefKind::kZone;
      reference.name = participant.zone_id();
      break;
    case v1::Participant::kWall:
      if (!HasNamed(request.room().walls(), participant.wall(), [](const auto& wall) { return wall.name(); }))
        return absent("wall", participant.wall());
      reference.kind = RefKind::kWall;
      reference.name = participant.wall();
      break;
    default:
      reference = english::ReferenceTo(participant.part());
      if (reference.kind == RefKind::kPronoun) return absl::InvalidArgumentError("a participant is nothing");
  }
  reference.side = english::WordOf(participant.side());
  return reference;
}

// Objects with the same side are one reference to several.
absl::StatusOr<std::optional<english::Mention>> MentionOf(const v1::TranslateRequest& request,
                                                          const Participants& participants) {
  if (participants.empty()) return std::nullopt;
  english::Mention mention;
  for (const v1::Participant& participant : participants) {
    ASSIGN_OR_RETURN(english::Reference reference, ReferenceOf(request, participant));
    english::Reference* const last = mention.references.empty() ? nullptr : &mention.references.back();
    if (last != nullptr && last->chosen && reference.chosen && last->side == reference.side) {
      last->candidates.push_back(reference.candidates.front());
      last->plural = true;
    } else {
      mention.references.push_back(std::move(reference));
    }
  }
  return mention;
}

}  // namespace

absl::StatusOr<std::vector<english::Fact>> TypedFacts(const v1::TranslateRequest& request,
                                                      const v1::Sentence& sentence) {
  std::vector<english::Fact> facts;
  if (sentence.meaning().facts().empty() || sentence.meaning().text_digest() != runtime::Sha256Hex(sentence.text()))
    return facts;
  for (const v1::Fact& typed : sentence.meaning().facts()) {
    english::Fact& fact = facts.emplace_back();
    fact.meaning = typed.relation();
    fact.detail = typed.detail();
    ASSIGN_OR_RETURN(fact.a, MentionOf(request, typed.movers()));
    ASSIGN_OR_RETURN(fact.b, MentionOf(request, typed.targets()));
    ASSIGN_OR_RETURN(fact.c, MentionOf(request, typed.others()));
    if (typed.has_measure()) {
      english::Length& length = fact.distance.emplace();
      if (typed.measure().has_min_m()) length.min_m = typed.measure().min_m();
      if (typed.measure().has_max_m()) length.max_m = typed.measure().max_m();
      length.exact = typed.measure().exact();
    }
    if (!english::FrameBook::Get().Knows(fact.meaning, fact.detail, fact.AsMatch())) {
      return InvalidArgument("no frame is \"{}{}{}\" of such participants", fact.meaning,
                             fact.detail.empty() ? "" : ", ", fact.detail);
    }
  }
  return facts;
}

}  // namespace flair::translator
