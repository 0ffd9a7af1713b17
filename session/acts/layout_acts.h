// SPDX-License-Identifier: GPL-3.0-or-later
// What acts make of a layout. Nothing here is stored, and no act has a history: see documents.h.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/studio_service.pb.h"
#include "session/layouts/lists.h"
#include "session/sentences/said.h"
#include "session/sentences/spoken.h"
#include "session/stages.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::session {

// Where a document stands before an act.
struct Standing {
  // What is shown.
  const v1::SolvedLayout& shown;
  // What was last solved, from which the next solve goes on: it knows what held before things were moved. Null when
  // this problem was never solved.
  const v1::SolvedLayout* settled;
  // What has changed since then.
  const EditList& pending;
  // Objects that somebody has placed by hand, the latest last: a solve leaves them there.
  const ObjectIds& by_hand;
};

// What an act has made of it.
struct Acted {
  v1::SolvedLayout layout;
  v1::Producer producer;
  // What the act did, such as "move the desk".
  std::string label;
  // Objects that stand elsewhere than before or are new, in the graph's order.
  ObjectIds moved_ids;
  // What could not be done or understood, and why.
  std::vector<v1::Diagnostic> diagnostics;
  // Whether the next solve goes on from this layout; otherwise from the one before.
  bool settled = true;
  // Whether nothing that was solved before helps any more: the room is another one.
  bool anew = false;
  // What that solve is to look at: what has changed since, and what the act made stand badly.
  EditList pending;
  // As Standing.by_hand.
  ObjectIds by_hand;
  // What a sentence has done, in plain English, and what of its words was not done.
  std::string answer, left_over;
  // Pieces that a sentence has added.
  ObjectIds added_ids;
};

// What an act is for: what is to hold afterwards.
struct Aim {
  IdSet sentence_ids;
  // What it is about: these move first.
  IdSet object_ids;
  // Whether others may be solved anew for it as well; else only against faults, and for its place in the room: that it
  // stands at a wall, with its front clear.
  bool others_may_move = true;
  // Nothing that is wrong already is taken as given, and nothing moves but for more that holds.
  bool mends_all = false;
};

// What a designer says of objects in a room.
using SentencesOf =
    std::function<absl::StatusOr<v1::ConstraintList>(const v1::Room&, const v1::ZonePlan&, const v1::ObjectList&)>;

// Who makes layouts that nothing has solved.
v1::Producer ByHand(const char* method = "placed by hand");
// Pieces that were used with what the edits take away and have no other use: one remark each, its subject the piece.
std::vector<v1::Diagnostic> LeftBehind(const v1::SolvedLayout& before, const EditList& edits);
// Whether nothing stands elsewhere and the problem is the same.
bool ChangesNothing(const v1::SolvedLayout& before, const Acted& acted);

// Acts on a layout by the stages. Every error leaves things as they are: INVALID_ARGUMENT names the field of the act.
// `stages` must outlive it. Thread-safe.
class LayoutActs {
 public:
  LayoutActs(Stages& stages, SentencesOf sentences_of, Catalogue catalogue = {})
      : stages_(stages), sentences_of_(std::move(sentences_of)), catalogue_(std::move(catalogue)) {}

  // Every act but those about the document itself: undo, redo, title, variants, furnishing.
  absl::StatusOr<Acted> Act(const Standing& standing, const v1::ActRequest& request, runtime::CallContext& call) const;

  // Of a layout whose objects would stand elsewhere.
  absl::StatusOr<v1::JudgeResponse> Judge(const v1::SolvedLayout& layout, const v1::JudgeRequest& request,
                                          runtime::CallContext& call) const;

  // What is shown with up to `count` other layouts of the same problem as complete runner-ups, best first.
  absl::StatusOr<v1::SolvedLayout> WithAlternatives(const v1::SolvedLayout& shown, int count, int64_t seed,
                                                    runtime::CallContext& call) const;

  // What is shown with the places of `variant`, which was found for it or for an earlier form of it. What was added
  // since and what is locked stay where they are: where a locked piece stood otherwise in the variant, the rest is
  // solved around it and a diagnostic says so.
  absl::StatusOr<Acted> Taken(const v1::SolvedLayout& shown, v1::SolvedLayout variant,
                              runtime::CallContext& call) const;

  // The same graph with other places: verdicts and measures anew, nothing moved.
  absl::StatusOr<v1::SolvedLayout> Evaluated(v1::SolvedLayout layout, runtime::CallContext& call) const;

 private:
  absl::StatusOr<Acted> Move(const Standing& standing, const v1::MoveObjects& move, runtime::CallContext& call) const;
  absl::StatusOr<Acted> Dispatch(const Standing& standing, const v1::ActRequest& request,
                                 runtime::CallContext& call) const;
  absl::StatusOr<Acted> Edit(const Standing& standing, const v1::EditLayout& edit, runtime::CallContext& call) const;
  // With pieces that are new: what a designer says of them comes along.
  absl::StatusOr<Acted> Add(const Standing& standing, const v1::EditLayout& edit, runtime::CallContext& call) const;
  // Of what is new in `with`, which `before` has become, as constraints: those that name it.
  absl::StatusOr<v1::LayoutGraph> SaidOf(const IdSet& added, const v1::SolvedLayout& before,
                                         const v1::SolvedLayout& with, runtime::CallContext& call) const;
  // Adds to the edits what is said of new pieces by a designer, and its sentences to `shown` and the aim; returns them.
  absl::StatusOr<v1::LayoutGraph> LetDesignerSpeak(const IdSet& added, const v1::SolvedLayout& with,
                                                   v1::SolvedLayout& shown, EditList& edits, Aim& aim,
                                                   runtime::CallContext& call) const;
  // Nothing but the room.
  absl::StatusOr<Acted> Clear(const Standing& standing, runtime::CallContext& call) const;
  // What was placed by hand or is locked stays; the answer says what came of it, and why nothing could be better.
  absl::StatusOr<Acted> Settle(const Standing& standing, runtime::CallContext& call) const;
  absl::StatusOr<Acted> Say(const Standing& standing, const v1::SaySentence& say, runtime::CallContext& call) const;
  // Wishes for what a translator reads, and for new pieces; `places`: more such sentences.
  absl::StatusOr<Acted> SayWishes(const Standing& standing, const v1::SaySentence& say,
                                  const std::vector<WishedSentence>& places, runtime::CallContext& call) const;
  // A clause that asks for a change of pieces that are there, and how it is done by its kind.
  absl::StatusOr<Acted> DoSpoken(const Standing& standing, Spoken spoken, runtime::CallContext& call) const;
  absl::StatusOr<Acted> RemoveSpoken(const Standing& standing, const Spoken& spoken, runtime::CallContext& call) const;
  absl::StatusOr<Acted> ResizeSpoken(const Standing& standing, const Spoken& spoken, runtime::CallContext& call) const;
  absl::StatusOr<Acted> ReplaceSpoken(const Standing& standing, const Spoken& spoken, runtime::CallContext& call) const;
  absl::StatusOr<Acted> LockSpoken(const Standing& standing, const Spoken& spoken, runtime::CallContext& call) const;
  absl::StatusOr<Acted> SwapSpoken(const Standing& standing, const Spoken& spoken, runtime::CallContext& call) const;
  absl::StatusOr<Acted> MoveSpoken(const Standing& standing, const Spoken& spoken, runtime::CallContext& call) const;
  // So far to one side of another piece.
  absl::StatusOr<Acted> SetOffSpoken(const Standing& standing, const Spoken& spoken, runtime::CallContext& call) const;
  absl::StatusOr<Acted> TurnSpoken(const Standing& standing, const Spoken& spoken, runtime::CallContext& call) const;
  // As Move; where that leaves faults, others give way if they can.
  absl::StatusOr<Acted> MovedAndSettled(const Standing& standing, const v1::MoveObjects& move,
                                        runtime::CallContext& call) const;
  // As MovedAndSettled; the pieces may stand up to so far from there.
  absl::StatusOr<Acted> MovedNearBy(const Standing& standing, const v1::MoveObjects& move, double farthest_m,
                                    runtime::CallContext& call) const;
  // Solves from there, these pieces as well.
  absl::StatusOr<Acted> SolvedFrom(const Standing& standing, const v1::MoveObjects& move,
                                   runtime::CallContext& call) const;
  // What a translator makes of what is said; `with`: what is shown with the pieces that are new.
  absl::StatusOr<v1::LayoutGraph> Understood(const v1::SaySentence& say, const Said& said,
                                             const v1::SolvedLayout& shown, const v1::SolvedLayout& with,
                                             runtime::CallContext& call) const;
  // One remark for each of these sentences that does not hold, with what stands against it.
  absl::Status TellUnmet(const v1::ConstraintList& said, Acted& acted, runtime::CallContext& call) const;
  absl::StatusOr<Acted> Weigh(const Standing& standing, const v1::WeighSentence& weigh,
                              runtime::CallContext& call) const;
  absl::StatusOr<Acted> Replace(const Standing& standing, const v1::ReplaceObject& replace,
                                runtime::CallContext& call) const;
  absl::StatusOr<Acted> ChangeRoom(const Standing& standing, const v1::Room& room, runtime::CallContext& call) const;

  // Solves what is pending and `edits`, from `settled` where there is one, else anew.
  // What was placed by hand stays, unless that leaves faults: then it is freed, the earliest first, and told.
  absl::StatusOr<Acted> Solved(const Standing& standing, const EditList& edits, runtime::CallContext& call) const;
  // What was said of these pieces and does not hold where a hand has put them is not said any more: edits that drop it.
  absl::StatusOr<EditList> Overtaken(const v1::SolvedLayout& shown, const v1::EditLayout& edit,
                                     runtime::CallContext& call) const;
  // As Solved; where the aim is not reached that way, what is in reach of it may move too, and be placed anew. The best
  // of all that.
  absl::StatusOr<Acted> Tried(const Standing& standing, const EditList& edits, const Aim& aim,
                              runtime::CallContext& call) const;
  // The same from what a solve has made of it.
  absl::StatusOr<Acted> Widened(Acted best, const Standing& standing, const EditList& edits, const Aim& aim,
                                runtime::CallContext& call) const;
  // Everything but `free` stays where it stands.
  absl::StatusOr<Acted> SolvedAround(const v1::SolvedLayout& from, const IdSet& free, runtime::CallContext& call) const;
  // Puts pieces that the aim is not about back where they stood, one by one, where that makes nothing worse.
  absl::Status PutBack(const v1::SolvedLayout& before, const Aim& aim, Acted& acted, runtime::CallContext& call) const;
  // What stands against it that the aim is reached: what would give way if nothing counted more.
  absl::StatusOr<std::string> WhyNot(const v1::SolvedLayout& layout, const Aim& aim, runtime::CallContext& call) const;
  absl::StatusOr<Acted> SolvedHolding(const Standing& standing, const EditList& edits, const ObjectIds& held,
                                      runtime::CallContext& call) const;
  // Applies the edits without solving.
  absl::StatusOr<Acted> Unsolved(const Standing& standing, const EditList& edits, runtime::CallContext& call) const;

  Stages& stages_;
  const SentencesOf sentences_of_;
  const Catalogue catalogue_;
  // So that examples are others each time.
  mutable std::atomic<unsigned> turn_ = 0;
};

}  // namespace flair::session
