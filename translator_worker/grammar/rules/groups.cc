// SPDX-License-Identifier: GPL-3.0-or-later
// Groups: who is meant where several are named together, and the meanings that need all of them at once.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "translator_worker/grammar/meanings.h"
#include "translator_worker/grammar/rules/shared.h"

namespace flair::translator {

Groups TwoGroups(const Mention* mention, Composer& composer) {
  if (mention != nullptr && mention->references.size() == 2) {
    const Mention first{{mention->references[0]}};
    const Mention second{{mention->references[1]}};
    Groups groups{composer.Movers(&first), composer.Movers(&second)};
    if (!groups.first.empty() && !groups.second.empty()) return groups;
  }
  std::vector<Placed> all = composer.Movers(mention);
  if (all.size() < 2) all = composer.subjects();
  if (all.size() == 2) return {{all[0]}, {all[1]}};
  composer.Refuse("unknown_sentence", "two objects can stand so to each other; name them");
  return {};
}

Groups AllAndFirst(const Mention* mention, Composer& composer) {
  std::vector<Placed> movers = composer.Movers(mention);
  // "Behind the bench and parallel": to the bench.
  if (movers.size() == 1 && !composer.pair_targets().empty()) return {movers, composer.pair_targets()};
  if (movers.size() < 2) movers = composer.subjects();
  if (movers.size() < 2) return {};
  return {{movers.begin() + 1, movers.end()}, {movers.front()}};
}

std::vector<Placed> OneAtEach(const Mention* mention, const Mention* place, Composer& composer) {
  const std::string side = place != nullptr ? place->references.front().side : "sides";
  const bool each = side == "sides" || side == "all" || side.ends_with("both");
  if (!each || mention == nullptr || mention->references.size() != 1 || mention->references.front().ordinal != 1)
    return composer.Movers(mention);
  Mention all = *mention;
  all.references.front().ordinal = 0;
  all.references.front().each = true;
  return composer.Movers(&all);
}

bool MentionIs(const std::string& kind, const Mention& mention, const Composer& composer) {
  const Reference& first = mention.references.front();
  if (kind == "in-room") return composer.HasFeature(first.name);
  if (kind == "area") return first.area;
  if (kind == "many") return mention.references.size() > 1;
  if (kind == "some-feature") {
    return std::ranges::any_of(mention.references, [](const Reference& one) { return one.kind == RefKind::kFeature; });
  }
  if (kind == "bare") return first.kind == RefKind::kPronoun && first.name.empty();
  if (kind == "own-part") {
    return composer.topic().size() == 1 && mention.references.size() == 1 && first.kind == RefKind::kObjects &&
           first.Names(composer.topic().front().object);
  }
  if (kind == "own-sides") return AreOwnSides(mention, composer);
  if (kind == "sided") {
    return std::ranges::any_of(mention.references,
                               [](const Reference& one) { return one.kind != RefKind::kVague && !one.side.empty(); });
  }
  // Two that are named, or several of a name.
  if (kind == "several-things") {
    const bool several = first.kind == RefKind::kObjects && (first.plural || first.each) && first.candidates.size() > 1;
    return several || (mention.references.size() > 1 && first.kind != RefKind::kGroup);
  }
  return OfSort(mention, kind);
}

bool MayBeOwnSpace(const Match& match, const Composer& composer) {
  if (match.a != nullptr) return false;
  // "Parallel to the oven and 1.5 m in front of it": of the oven.
  const bool of_partner = match.distance != nullptr && match.distance->exact &&
                          composer.scope() == v1::SENTENCE_SCOPE_INTER && !composer.pair_targets().empty() &&
                          !composer.calls().empty() && match.b->references.front().name == "it";
  // "One can stand in front of the wardrobe" that is spoken of.
  const bool of_topic = composer.scope() == v1::SENTENCE_SCOPE_INTRA && MentionIs("own-part", *match.b, composer);
  return of_topic || (match.distance != nullptr && !of_partner);
}

namespace {

Target TargetOf(std::vector<Placed> objects) { return {RefKind::kObjects, std::move(objects), ""}; }

std::vector<std::string> IdsOf(const std::vector<Placed>& list, const Composer& composer) {
  std::vector<std::string> ids;
  for (const Placed& placed : list) ids.push_back(composer.id(placed));
  return ids;
}

// One mover at each side of each target; more than two stand round it.
void OnEachSide(const Match& match, std::string_view, Composer& composer) {
  const std::vector<Placed> movers = OneAtEach(match.a, nullptr, composer);
  const std::vector<Placed> targets = composer.TargetObjects(*match.b, movers);
  for (const Placed& target : targets) {
    if (movers.size() > 2 && composer.PlacedIs("floor", movers.front())) {
      composer.EmitFirst(
          {Call("surround").Text("center", composer.id(target)).Texts("objects", IdsOf(movers, composer))});
      continue;
    }
    // "On opposite long sides of the table" are those two.
    const std::vector<std::string> named = SidesOf(composer, target);
    std::string side = named.size() == 2 ? named.front() : "left";
    for (Placed mover : movers) {
      // With its back or front to the table a chair stands as it likes.
      const bool lateral = side == "left" || side == "right";
      mover.side = lateral ? OppositeSide(side) : "";
      MakeCallsOf("at_side_of", {mover}, TargetOf({{target.object, side}}), nullptr, composer);
      side = OppositeSide(side);
    }
  }
  if (!movers.empty() && !targets.empty()) composer.SetPair(movers, targets);
}

void EmitSurround(const std::vector<Placed>& movers, const std::vector<Placed>& centers, const Length* distance,
                  Composer& composer) {
  if (movers.empty() || centers.empty()) return;
  // "Each table is surrounded by four chairs": the first four stand round the first.
  if (centers.size() > 1 && movers.size() > centers.size() && movers.size() % centers.size() == 0) {
    const auto each = static_cast<long>(movers.size() / centers.size());
    for (size_t i = 0; i < centers.size(); ++i) {
      const auto first = movers.begin() + static_cast<long>(i) * each;
      EmitSurround({first, first + each}, {centers[i]}, distance, composer);
    }
    return;
  }
  std::vector<std::string> ids = IdsOf(movers, composer);
  const std::string& center = composer.id(centers.front());
  std::erase(ids, center);
  if (ids.empty()) return;
  Call call = Call("surround").Text("center", center).Texts("objects", ids);
  if (distance != nullptr) call.Number("gap_m", distance->Nominal());
  composer.EmitFirst({call});
  composer.SetPair(movers, {centers.front()});
}

// detail "plain": only "around", which several stand and one moves.
void Surround(const Match& match, std::string_view detail, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  if (detail == "plain" && movers.size() < 2) {
    composer.Refuse("unknown_sentence", "one object cannot stand around another; say beside or near it");
    return;
  }
  EmitSurround(movers, composer.TargetObjects(*match.b, movers), match.distance, composer);
}

void SurroundedBy(const Match& match, std::string_view, Composer& composer) {
  const std::vector<Placed> centers = composer.Movers(match.a);
  EmitSurround(composer.TargetObjects(*match.b, centers), centers, nullptr, composer);
}

void PlaceBetween(const Match& match, std::string_view, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  const std::vector<Placed> targets = composer.TargetObjects(*match.b, movers, false);
  if (targets.size() != 2 || movers.empty()) {
    composer.Refuse("unknown_sentence", "between needs exactly two objects; name them");
    return;
  }
  for (const Placed& mover : movers) {
    if (composer.PlacedIs("wall", mover)) {
      MakeCallsOf("near", {mover}, TargetOf({targets[0]}), nullptr, composer);
      continue;
    }
    composer.EmitFirst({Call("between")
                            .Text("object", composer.id(mover))
                            .Text("first", composer.id(targets[0]))
                            .Text("second", composer.id(targets[1]))});
  }
}

void Row(const Match& match, std::string_view, Composer& composer) {
  std::vector<Placed> movers = composer.Movers(match.a);
  if (movers.size() < 2) movers = composer.subjects();
  if (movers.size() < 2) {
    composer.Refuse("unknown_sentence", "a row needs at least two objects; name them");
    return;
  }
  Call row = Call("row").Texts("objects", IdsOf(movers, composer));
  if (match.distance != nullptr) row.Number("gap_m", match.distance->Nominal());
  if (composer.Emit(row)) return;
  for (size_t i = 0; i + 1 < movers.size(); ++i) {
    composer.EmitFirst({Call("next_to")
                            .Text("object", composer.id(movers[i + 1]))
                            .Text("target", composer.id(movers[i]))
                            .Text("object_side", "left")
                            .Text("target_side", "right")});
  }
}

// Every two of the list, but none of one group among themselves: "between the table and each chair", and "between the
// shelf and both the desk and the table" from the shelf to each of the others.
void KeepApart(const std::vector<Placed>& all, const std::vector<Reference>& groups, const Length* distance,
               Composer& composer) {
  constexpr size_t kMost = 12;
  if (all.size() > kMost || all.size() < 2) {
    composer.Refuse("unknown_sentence", "a distance needs two objects that it is kept between");
    return;
  }
  const auto both = std::find_if(groups.begin() + !groups.empty(), groups.end(),
                                 [](const Reference& one) { return one.each && !one.plural; });
  const long last_group = groups.size() < 3 ? static_cast<long>(groups.size()) : both - groups.begin();
  const auto group_of = [&](const Placed& placed) {
    const auto named = std::ranges::find_if(groups, [&](const Reference& one) { return one.Names(placed.object); });
    return named == groups.end() ? -1 : std::min(named - groups.begin(), last_group);
  };
  for (size_t i = 0; i < all.size(); ++i) {
    for (size_t k = i + 1; k < all.size(); ++k) {
      const bool together = groups.size() > 1 && group_of(all[i]) >= 0 && group_of(all[i]) == group_of(all[k]);
      if (!together) MakeCallsOf("distance", {all[i]}, TargetOf({all[k]}), distance, composer);
    }
  }
  if (all.size() == 2) composer.SetPair({all[0]}, {all[1]});
}

// The last pair spoken of, else `otherwise`, else what the sentence is about.
std::vector<Placed> PairOr(std::vector<Placed> otherwise, const Composer& composer) {
  std::vector<Placed> all = composer.pair_movers();
  if (all.size() > 1 && !composer.pair_targets().empty()) return all;
  all.insert(all.end(), composer.pair_targets().begin(), composer.pair_targets().end());
  if (composer.pair_targets().empty()) all = std::move(otherwise);
  return all.size() > 1 ? all : composer.subjects();
}

// Every pair of the list; "them" is the last pair spoken of, or the objects that the sentence is about.
void Between(const Match& match, std::string_view, Composer& composer) {
  const std::vector<Reference>& references = match.b->references;
  const Reference& last = references.back();
  Mention first{{references.front()}};
  if (last.kind == RefKind::kGroup && references.size() > 1 && match.distance != nullptr) {
    // "Between the backs of the chairs and any wall or furniture": free space there; "at least 0.3 m between the
    // cabinet and any other object".
    const bool sided = !references.front().side.empty() && references.front().side != "side";
    if (!sided) first.references.front().side.clear();
    const Mention others{{last}};
    Match fact{&first, &others, nullptr, match.distance, match.length};
    MakeCalls(sided ? "free_beside" : "away_from", fact, "", composer);
  } else if (last.kind == RefKind::kGroup) {
    composer.Refuse("not_about_layout",
                    "a passage between pieces that are not named cannot be asked for; name two objects");
  } else if (references.size() == 1 && last.kind == RefKind::kPronoun) {
    std::vector<Placed> all = PairOr(composer.topic(), composer);
    if (all.size() < 2) all = composer.TargetObjects(*match.b, {}, false);
    KeepApart(all, {}, match.distance, composer);
  } else if (last.kind == RefKind::kWall || last.kind == RefKind::kFeature) {
    for (size_t i = 0; i + 1 < references.size(); ++i) {
      const Mention one{{references[i]}};
      MakeCallsOf("away", composer.Movers(&one), {last.kind, {}, last.name}, match.distance, composer);
    }
  } else {
    KeepApart(composer.TargetObjects(*match.b, {}, false), references, match.distance, composer);
  }
}

// "X and Y 0.5 m apart", "... at least 0.5 m apart" after a fact about X and Y.
void ApartFromEachOther(const Match& match, std::string_view, Composer& composer) {
  if (match.a != nullptr && match.a->references.front().kind == RefKind::kGroup) {
    composer.Refuse("not_about_layout",
                    "distances among pieces that are not named cannot be asked for; name two objects");
    return;
  }
  const std::vector<Placed> movers = composer.Movers(match.a);
  KeepApart(movers.size() > 1 ? movers : PairOr({}, composer), {}, match.distance, composer);
}

}  // namespace

std::vector<Procedure> GroupProcedures() {
  return {{"on_each_side", OnEachSide},
          {"surround", Surround},
          {"surrounded_by", SurroundedBy},
          {"place_between", PlaceBetween},
          {"row", Row},
          {"between", Between},
          {"apart_from_each_other", ApartFromEachOther}};
}

}  // namespace flair::translator
