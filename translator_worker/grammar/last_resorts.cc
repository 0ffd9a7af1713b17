// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/last_resorts.h"

#include <algorithm>

#include "translator_worker/grammar/rules/space.h"

namespace flair::translator {
namespace {

// What is spoken of, a part of it, or a vague thing that it has space for.
bool IsOwn(const Reference& reference, const Composer& composer) {
  if (reference.kind == RefKind::kObjects) {
    return !composer.topic().empty() && std::find(reference.candidates.begin(), reference.candidates.end(),
                                                  composer.topic().front().object) != reference.candidates.end();
  }
  const bool comfort = reference.kind == RefKind::kVague && (reference.name == "comfort" || reference.name == "paths");
  return reference.kind == RefKind::kPronoun || comfort ||
         (reference.kind == RefKind::kFeature && reference.name == "door");
}

}  // namespace

bool TakeSpace(const std::vector<Term>& terms, Composer& composer) {
  const Distance* distance = nullptr;
  bool space = false;
  bool purpose = false;
  for (const Term& term : terms) {
    // Of the reason nothing is to be kept free.
    if (term.kind == Term::Kind::kPurpose && (term.lemma == "because" || term.lemma == "since")) break;
    if (term.kind == Term::Kind::kSoft && term.lemma == "while") break;
    const bool door = term.kind == Term::Kind::kMention && term.mention.references.front().name == "door";
    space = space || door || term.IsWord("space") || term.IsWord("pull_out");
    purpose = purpose || term.IsWord("swing_open") || term.IsWord("pull_out") ||
              (space && term.kind == Term::Kind::kPurpose) || term.kind == Term::Kind::kDistance;
    if (term.kind == Term::Kind::kDistance && distance != nullptr) return false;
    if (term.kind == Term::Kind::kDistance) distance = &term.distance;
    if (term.IsWord("not") || term.IsWord("between") || term.IsWord("away_from") || term.IsWord("around")) return false;
    if (term.kind == Term::Kind::kMention && !IsOwn(term.mention.references.front(), composer)) return false;
  }
  if (!space || !purpose || composer.scope() != v1::SENTENCE_SCOPE_INTRA || !composer.OnlyUnknown()) return false;
  KeepUsableSpace(distance, composer);
  return !composer.calls().empty();
}

void TakeSocket(const std::vector<Term>& terms, Composer& composer) {
  if (composer.scope() != v1::SENTENCE_SCOPE_INTRA || !composer.HasFeature("socket")) return;
  const bool named = std::any_of(terms.begin(), terms.end(), [](const Term& term) {
    if (term.kind != Term::Kind::kMention) return false;
    const std::vector<Reference>& references = term.mention.references;
    const auto socket = [](const Reference& reference) { return reference.name == "socket"; };
    return std::any_of(references.begin(), references.end(), socket) &&
           std::all_of(references.begin(), references.end(), [&](const Reference& reference) {
             return socket(reference) || reference.kind == RefKind::kVague;
           });
  });
  const bool relates = std::any_of(terms.begin(), terms.end(), [](const Term& term) {
    return term.IsWord("not") || term.IsWord("block") || term.IsWord("away_from") || term.IsWord("accessible");
  });
  if (!named || relates) return;
  for (const Placed& placed : composer.topic()) {
    composer.EmitFirst({Call("close_to_feature").Text("object", composer.id(placed)).Text("feature", "socket")});
  }
}

bool TakePlace(const std::vector<Term>& terms, Composer& composer) {
  if (composer.scope() != v1::SENTENCE_SCOPE_TERTIARY || composer.topic().size() != 1) return false;
  if (!composer.OnlyUnknown()) return false;
  const Placed& small = composer.topic().front();
  const Mention* place = nullptr;
  for (const Term& term : terms) {
    if (term.IsWord("not") || term.IsWord("away_from")) return false;
    if (term.kind != Term::Kind::kMention) continue;
    const RefKind kind = term.mention.references.front().kind;
    if (kind != RefKind::kObjects && kind != RefKind::kZone) continue;
    if (kind == RefKind::kObjects && IsOwn(term.mention.references.front(), composer)) continue;
    if (place == nullptr) place = &term.mention;
  }
  if (place == nullptr) return false;
  const std::string& id = composer.id(small);
  if (place->references.front().kind == RefKind::kZone) {
    if (!composer.IsWall(small)) return false;
    composer.EmitFirst({Call("on_wall_in_zone").Text("object", id).Text("zone", place->references.front().name)});
    return !composer.calls().empty();
  }
  const std::vector<Placed> hosts = composer.TargetObjects(*place, {small});
  if (hosts.empty() || !composer.IsFloor(hosts.front())) return false;
  const std::string& host = composer.id(hosts.front());
  if (composer.IsSurface(small)) {
    composer.EmitFirst({Call("on_top_center").Text("object", id).Text("host", host)});
  } else if (composer.IsWall(small)) {
    composer.EmitFirst({Call("on_wall_near").Text("object", id).Text("target", host)});
  } else if (composer.IsCeiling(small)) {
    composer.EmitFirst({Call("ceiling_above").Text("object", id).Text("target", host)});
  }
  return !composer.calls().empty();
}

}  // namespace flair::translator
