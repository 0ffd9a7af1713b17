// SPDX-License-Identifier: GPL-3.0-or-later
// What is to be got at: accessible pieces, their sides, from where.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "fmt/format.h"
#include "translator_worker/grammar/frames.h"
#include "translator_worker/grammar/rules/shared.h"

namespace flair::translator {
namespace {

// "Used from both sides, so both must be free by 1 m": of the sides that were spoken of.
bool IsSaidOfSides(const Mention* mention, const Composer& composer) {
  const bool they = mention == nullptr || (mention->references.front().kind == RefKind::kPronoun &&
                                           mention->references.front().name == "both");
  if (!they || composer.calls().empty() || composer.topic().empty()) return false;
  const Call& last = composer.calls().back();
  return last.type == "accessible" &&
         std::any_of(composer.topic().begin(), composer.topic().end(),
                     [&](const Placed& one) { return last.arguments.front().value().text() == composer.id(one); });
}

void Accessible(const Match& match, std::string_view, Composer& composer) {
  if (match.a != nullptr && match.a->references.front().name == "all") {
    composer.Refuse("not_about_layout", "access to pieces that are not named cannot be asked for; name them");
    return;
  }
  if (IsOfFeature(match.a, composer)) return;
  if (match.b == nullptr && IsSaidOfSides(match.a, composer)) {
    if (match.distance != nullptr) composer.CompleteClearance(match.distance->Nominal());
    return;
  }
  std::vector<Placed> movers = composer.Movers(match.a);
  // "From the front or side": the choice is free.
  if (match.a != nullptr && match.a->either && movers.size() > 1 && movers[0].object == movers[1].object)
    movers.resize(1);
  if (match.b != nullptr) {
    // "accessible from the front": the sides are those named after the verb.
    std::vector<Placed> sided;
    for (const Placed& mover : movers) {
      for (const Reference& reference : match.b->references) {
        sided.push_back({mover.object, reference.side});
        if (match.b->either) break;
      }
    }
    movers = sided;
  }
  KeepSpace(movers, match.distance, composer);
}

// "Easy access from the front".
void AccessToSide(const Match& match, std::string_view, Composer& composer) {
  KeepSpace(composer.TargetObjects(*match.b, {}), match.distance, composer);
}

// "Access to the bed from both sides".
void AccessFromSide(const Match& match, std::string_view, Composer& composer) {
  std::vector<Placed> sided;
  for (const Placed& other : composer.TargetObjects(*match.b, {})) {
    for (const Reference& reference : match.c->references) sided.push_back({other.object, reference.side});
  }
  KeepSpace(sided, match.distance, composer);
}

// "Must open fully", of the piece that the sentence is about, when nothing else was said.
void OpensFully(const Match& match, std::string_view, Composer& composer) {
  const std::vector<Placed>& topic = composer.topic();
  if (!composer.calls().empty() || topic.empty() || composer.scope() != v1::SENTENCE_SCOPE_INTRA) return;
  KeepSpace(topic, match.distance, composer);
}

// "All sides where chairs stand are accessible", "the front is clear of obstacles".
void OfMovers(const Match& match, std::string_view, Composer& composer) {
  KeepSpace(composer.Movers(match.a), match.distance, composer);
}

// "X is accessible from Y": from one of Y's sides that is Y's own matter, else X is near Y.
void AccessibleFrom(const Match& match, std::string_view, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  for (const Target& target : composer.Targets(*match.b, movers)) {
    if (target.name == "all" || target.name == "others") {
      composer.Refuse("not_about_layout", "say from which object it is reached");
      continue;
    }
    if (target.kind == RefKind::kFeature && target.name == "door") {
      composer.Refuse("not_about_layout", "ways from a door cannot be asked for; say how near it is");
      continue;
    }
    if (target.kind == RefKind::kFeature) {
      for (const Placed& mover : movers) {
        composer.RelateToFeature("close_to_feature", mover, target.name);
      }
    }
    for (const Placed& other : target.objects) {
      for (const Placed& mover : movers) {
        composer.Relate("near", mover, other);
      }
    }
    if (!target.objects.empty()) composer.SetPair(movers, target.objects);
  }
}

// "Its top and front are accessible": the front is.
void Unreachable(const Match& match, std::string_view, Composer& composer) {
  Mention sides;
  for (const Reference& reference : match.a->references) {
    if (reference.kind != RefKind::kVague && !reference.side.empty()) sides.references.push_back(reference);
  }
  if (!sides.references.empty()) {
    KeepSpace(composer.Movers(&sides), match.distance, composer);
    return;
  }
  composer.Refuse("not_about_layout", "access is kept at the front, back, left and right, not from above");
}

void MovementAround(const Match&, std::string_view, Composer& composer) {
  composer.Refuse("not_about_layout", "ways cannot be asked for; say which sides are kept free");
}

// "The cabinet's doors must not bump into the bench": its own front is kept free; of others that of what is blocked.
void NotHitting(const Match& match, std::string_view detail, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  const bool doors = !movers.empty() && movers.front().side == "front" && composer.HasDoors(movers.front());
  doors ? KeepSpace(movers, match.distance, composer) : NotBlock(match, detail, composer);
}

}  // namespace

std::vector<Meaning> AccessMeanings() {
  return {
      {"accessible", Accessible},
      {"access_to_side", AccessToSide},
      {"access_from_side", AccessFromSide},
      {"opens_fully", OpensFully},
      {"of_movers", OfMovers},
      {"accessible_from", AccessibleFrom},
      {"unreachable", Unreachable},
      {"movement_around", MovementAround},
      {"not_hitting", NotHitting},
  };
}

}  // namespace flair::translator
