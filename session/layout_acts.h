// SPDX-License-Identifier: GPL-3.0-or-later
// What acts make of a layout. Nothing here is stored, and no act has a history: see documents.h.
#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/layout_edit.pb.h"
#include "flair/v1/solved_layout.pb.h"
#include "flair/v1/studio_service.pb.h"
#include "session/edit_lists.h"
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
};

// What an act has made of it.
struct Acted {
  v1::SolvedLayout layout;
  v1::Producer producer;
  // What the act did, such as "move the desk".
  std::string label;
  // Objects that stand elsewhere than before or are new, in the graph's order.
  std::vector<std::string> moved_ids;
  // What could not be done or understood, and why.
  std::vector<v1::Diagnostic> diagnostics;
  // Whether the next solve goes on from this layout; otherwise from the one before.
  bool settled = true;
  // Whether nothing that was solved before helps any more: the room is another one.
  bool anew = false;
  // What that solve is to look at: what has changed since, and what the act made stand badly.
  EditList pending;
};

// Acts on a layout by the stages. Every error leaves things as they are: INVALID_ARGUMENT names the field of the act.
// `stages` must outlive it. Thread-safe.
class LayoutActs {
 public:
  explicit LayoutActs(Stages& stages) : stages_(stages) {}

  // Every act but those about the document itself: undo, redo, title, variants, furnishing.
  absl::StatusOr<Acted> Act(const Standing& standing, const v1::ActRequest& request, runtime::CallContext& call) const;

  // Of a layout whose objects would stand elsewhere.
  absl::StatusOr<v1::JudgeResponse> Judge(const v1::SolvedLayout& layout, const v1::JudgeRequest& request,
                                          runtime::CallContext& call) const;

  // What is shown with up to `count` other layouts of the same problem as complete runner-ups, best first.
  absl::StatusOr<v1::SolvedLayout> WithAlternatives(const v1::SolvedLayout& shown, int count, int64_t seed,
                                                    runtime::CallContext& call) const;

  // The same graph with other places: verdicts and measures anew, nothing moved.
  absl::StatusOr<v1::SolvedLayout> Evaluated(v1::SolvedLayout layout, runtime::CallContext& call) const;

 private:
  absl::StatusOr<Acted> Move(const Standing& standing, const v1::MoveObjects& move, runtime::CallContext& call) const;
  absl::StatusOr<Acted> Edit(const Standing& standing, const v1::EditLayout& edit, runtime::CallContext& call) const;
  // Nothing but the room.
  absl::StatusOr<Acted> Clear(const Standing& standing, runtime::CallContext& call) const;
  absl::StatusOr<Acted> Settle(const Standing& standing, runtime::CallContext& call) const;
  absl::StatusOr<Acted> Say(const Standing& standing, const v1::SaySentence& say, runtime::CallContext& call) const;
  absl::StatusOr<Acted> Weigh(const Standing& standing, const v1::WeighSentence& weigh,
                              runtime::CallContext& call) const;
  absl::StatusOr<Acted> Replace(const Standing& standing, const v1::ReplaceObject& replace,
                                runtime::CallContext& call) const;
  absl::StatusOr<Acted> ChangeRoom(const Standing& standing, const v1::Room& room, runtime::CallContext& call) const;

  // Solves what is pending and `edits`, from `settled` where there is one, else anew.
  absl::StatusOr<Acted> Solved(const Standing& standing, const EditList& edits, runtime::CallContext& call) const;
  // Applies the edits without solving.
  absl::StatusOr<Acted> Unsolved(const Standing& standing, const EditList& edits, runtime::CallContext& call) const;

  Stages& stages_;
};

}  // namespace flair::session
