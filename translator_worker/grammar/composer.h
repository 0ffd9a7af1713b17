// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "english/frames/frames.h"
#include "flair/v1/constraint_list.pb.h"
#include "flair/v1/layout_graph.pb.h"
#include "flair/v1/translator_service.pb.h"
#include "translator_worker/catalog/catalog_source.h"
#include "translator_worker/grammar/call.h"
#include "translator_worker/grammar/scene_names.h"

namespace flair::translator {

using english::Length;
using english::Match;
using english::Mention;
using english::Reference;
using english::RefKind;

class Composer;
// Makes the calls of one fact. `detail` is the frame's own, for meanings that serve several.
using Builder = void (*)(const Match& match, std::string_view detail, Composer& composer);

// An object with the side of it that was named (a side word of the lexicon, empty when none).
struct Placed {
  int object = -1;
  std::string side;
};

// Whether the object is in the list.
inline bool Contains(const std::vector<Placed>& list, int object) {
  return std::ranges::any_of(list, [&](const Placed& placed) { return placed.object == object; });
}

// One thing that a fact relates to: objects, or a part of the room.
struct Target {
  RefKind kind = RefKind::kObjects;
  std::vector<Placed> objects;
  // Feature kind, wall name or zone id.
  std::string name;
  // Of a door or window the id of the one that is meant; empty for any.
  std::string opening;
};

// What rules work with while one sentence is translated: who is spoken of, what the words refer to, and where calls and
// remarks go. A rule may ask for anything; what cannot be had becomes a remark, so that nothing is lost silently.
class Composer {
 public:
  Composer(const v1::TranslateRequest& request, const SceneNames& names, const CatalogIndex& catalog,
           const v1::Sentence& sentence);

  // What a noun phrase refers to, as movers: objects only. Null means whatever the sentence speaks of.
  std::vector<Placed> Movers(const Mention* mention);

  // What a noun phrase refers to. Of an "or" list the first member that is in the room. `movers` are not their own
  // targets.
  std::vector<Target> Targets(const Mention& mention, const std::vector<Placed>& movers, bool first_of_either = true);

  // Targets that are objects, in one list.
  std::vector<Placed> TargetObjects(const Mention& mention, const std::vector<Placed>& movers,
                                    bool first_of_either = true);

  const v1::Object& object(int index) const { return request_.object_list().objects(index); }
  const std::string& id(const Placed& placed) const { return object(placed.object).id(); }
  // Whether it is of that kind: "floor", "wall", "ceiling", "surface" (what carries it), "rug", "small-rug" (a mat,
  // which stands before and beside things like furniture), "primary", "tertiary", "in-corner" and "on-top" (where the
  // sentence has put it), "last-space" (whose free space was spoken of last), "own-chair" (a chair that a sentence
  // about one other piece alone brings in: "behind the chair" of a desk), or its name ends in a word of the list of
  // english/data that is so called: "chairs", "seats" (what people sit on), "beds" (lie in), "with-doors", "walk-ins"
  // (with an entrance of their own), "hot-things".
  bool PlacedIs(std::string_view kind, const Placed& placed) const;
  bool IsRug(const Placed& placed) const { return object(placed.object).walk_over(); }
  bool IsChair(const Placed& placed) const { return PlacedIs("chairs", placed); }
  bool HasFeature(const std::string& kind) const;

  // Adds the call if the catalogue has its type; false when it has not.
  bool Emit(Call call);
  // Adds the first of the calls whose type the catalogue has; a remark when it has none of them.
  void EmitFirst(std::vector<Call> calls);
  // "Against the wall for stability (back)": the side of the fact before, when it named none.
  void CompleteSide(const std::string& side);
  // "Space around the bed, at least 0.6 m": the figure of the fact before; false when that is none about free space.
  bool CompleteClearance(double least_m);
  // "... and behind": more sides of the free space that was spoken of last; false when that was something else.
  bool AddSides(const std::vector<std::string>& sides);
  // Says why a part of the sentence gives no call.
  void Refuse(std::string_view code, const std::string& message);
  // That the room has no such wall or corner.
  void RefuseMissing(const Reference& reference);
  // Whether nothing worse was said against the sentence than that it was not understood, and taking that back.
  bool OnlyUnknown() const;
  void ForgetUnknown() { refusals_.clear(); }
  // Says what was decided where the sentence left it open.
  void Note(std::string_view code, const std::string& message);

  // What was spoken of last: the default mover, and the partner that "them" and a bare distance refer to.
  void SetTopic(std::vector<Placed> topic);
  // Objects that are named as movers are spoken of from then on.
  void SpeakOf(const Mention& mention);
  void SetPair(std::vector<Placed> movers, std::vector<Placed> targets);
  const std::vector<Placed>& topic() const { return topic_; }
  const std::vector<Placed>& pair_movers() const { return pair_movers_; }
  const std::vector<Placed>& pair_targets() const { return pair_targets_; }
  const std::vector<Placed>& subjects() const { return subjects_; }

  // Begins another fact of the sentence, and how many calls those before it made.
  void BeginFact() { calls_before_ = calls_.size(); }
  size_t calls_before() const { return calls_before_; }

  const std::vector<Call>& calls() const { return calls_; }
  const std::vector<v1::Diagnostic>& refusals() const { return refusals_; }
  const std::vector<v1::Diagnostic>& notes() const { return notes_; }
  v1::SentenceScope scope() const { return sentence_.scope(); }
  bool IsSaid() const { return sentence_.origin() == v1::SENTENCE_ORIGIN_BRIEF; }
  // The feature that a fact of this sentence related to last: "near a socket without blocking it".
  std::string last_feature;
  // Whether a rug has been placed by this sentence; it lies in one place only.
  bool rug_placed = false;

 private:
  std::vector<Placed> Resolve(const Reference& reference, const std::vector<Placed>& movers, bool target);
  std::vector<int> Choose(const Reference& reference, const std::vector<Placed>& movers);
  // The primary objects, when there are few enough to be spoken of together.
  std::vector<Placed> Primaries() const;
  // Whether the two bear one name.
  bool IsLike(const Placed& a, const Placed& b) const { return object(a.object).name() == object(b.object).name(); }
  // "One chair on the left of the table and the other on the right": on the table's right.
  bool IsLikePairMover(const Placed& mover) const;
  // Those that the heading names, when there are any.
  void KeepSubjects(std::vector<int>& objects) const;
  // "The chairs" under a heading of chairs are these, under one of a table those that belong to it.
  void KeepThoseSpokenOf(const Reference& reference, std::vector<int>& objects) const;
  bool IsInZoneOf(int index, const Placed& placed) const {
    return object(index).zone_id() == object(placed.object).zone_id();
  }
  void KeepZone(std::vector<int>& objects, const Placed& mover) const;
  // "Each chair near a desk", as many desks as chairs: one each.
  void PairUp(const std::vector<Placed>& movers, const std::vector<Placed>& targets);
  // Whether the mover was paired up with another target than this.
  bool IsOfAnother(const std::string& mover, const std::string& target) const;
  // "The TV screen" of a TV stand is the stand where floor objects are spoken of.
  Placed PieceFor(const Placed& placed) const;
  // Chosen only after the sentences about floor objects are written: nothing there can be placed by it.
  bool ChosenLater(int object) const;
  // The furniture that a small thing stands on: who looks at the television looks at its stand. -1 when there is none.
  int CarrierOf(int object) const;
  // Whether a type would place furniture, or the rug as if it were furniture, in a sentence about a rug.
  bool IsBesideTheRug(const std::string& type) const;
  // Whether the call tells of a small thing only in what part of the room it is, or on what other small thing.
  bool TellsLittle(const Call& call) const;
  std::vector<int> Group(const std::string& name, const std::vector<Placed>& movers) const;

  const v1::TranslateRequest& request_;
  const SceneNames& names_;
  const CatalogIndex& catalog_;
  const v1::Sentence& sentence_;
  std::vector<Placed> subjects_;
  std::vector<Placed> topic_;
  // The topic before it: "the desk has the chair in front of it".
  std::vector<Placed> earlier_topic_;
  // What something was related to last: "space around the bed, so the desk and the wardrobe are not close to it".
  std::vector<Placed> named_;
  // By id, who was paired up with whom in the fact that is being read.
  std::map<std::string, std::string> partners_;
  std::vector<Placed> pair_movers_;
  std::vector<Placed> pair_targets_;
  std::vector<Call> calls_;
  size_t calls_before_ = 0;
  std::vector<v1::Diagnostic> refusals_;
  std::vector<v1::Diagnostic> notes_;
};

}  // namespace flair::translator
