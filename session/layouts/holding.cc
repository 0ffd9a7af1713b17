// SPDX-License-Identifier: GPL-3.0-or-later
// What solves leave where somebody has put it.
#include <algorithm>

#include "optimizer_worker/resolve/resolve_layout.h"
#include "session/layouts/edits.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::session {

ObjectIds ByHandAfter(ObjectIds before, const EditList& edits) {
  for (const v1::LayoutEdit& edit : edits) {
    const std::string& id = edit.has_move_object()            ? edit.move_object().object_id()
                            : !edit.unpin_object_id().empty() ? edit.unpin_object_id()
                                                              : edit.remove_object_id();
    if (id.empty()) continue;
    std::erase(before, id);
    if (edit.has_move_object()) before.push_back(id);
  }
  return before;
}

absl::StatusOr<EditList> WithHolds(const v1::SolvedLayout& from, const v1::SolvedLayout& shown, const EditList& edits,
                                   const ObjectIds& by_hand, const ObjectIds& held) {
  EditList all = edits;
  ASSIGN_OR_RETURN(const optimizer::EditedProblem problem, optimizer::ApplyEdits(from, edits));
  const IdSet holds(held.begin(), held.end()), there = IdsOf(problem.graph.object_list().objects());
  IdSet moved, resized, pinned = IdsOf(problem.graph.pinned_placements());
  IdSet locked = IdsOf(from.graph().pinned_placements());
  for (const v1::LayoutEdit& edit : edits) {
    if (edit.has_move_object()) moved.insert(edit.move_object().object_id());
    if (edit.has_resize_object()) resized.insert(edit.resize_object().object_id());
    if (!edit.pin_object_id().empty()) locked.insert(edit.pin_object_id());
  }
  for (const std::string& id : by_hand) {
    if (!there.contains(id) || locked.contains(id)) continue;
    const auto now = std::ranges::find(problem.placements, id, &v1::Placement::object_id);
    const v1::Placement* const seen = PlaceOf(shown, id);
    // What a move has carried along stands elsewhere than where it was solved.
    const bool carried = seen != nullptr && !moved.contains(id) && !resized.contains(id) &&
                         (now == problem.placements.end() || !StandSame(*now, *seen));
    if (carried) {
      *all.Add()->mutable_move_object() = *seen;
      pinned.insert(id);
    }
    if (holds.contains(id) && !pinned.contains(id) && now != problem.placements.end()) {
      all.Add()->set_pin_object_id(id);
    } else if (!holds.contains(id) && pinned.contains(id)) {
      all.Add()->set_unpin_object_id(id);
    }
  }
  return all;
}

void KeepOnlyWantedPins(const v1::LayoutGraph& before, const EditList& edits, v1::LayoutGraph& graph) {
  IdSet wanted = IdsOf(before.pinned_placements());
  for (const v1::LayoutEdit& edit : edits) {
    if (!edit.pin_object_id().empty()) wanted.insert(edit.pin_object_id());
    if (!edit.unpin_object_id().empty()) wanted.erase(edit.unpin_object_id());
  }
  EraseIf(*graph.mutable_pinned_placements(),
          [&](const v1::Placement& pin) { return !wanted.contains(pin.object_id()); });
}

std::map<std::string, std::string> WhatCannotBeHeld(const v1::SolvedLayout& layout, const ObjectIds& held) {
  std::map<std::string, std::string> which;
  for (const v1::Finding& finding : layout.metrics().findings()) {
    if (finding.kind() != v1::FINDING_KIND_OVERLAP && finding.kind() != v1::FINDING_KIND_OUTSIDE) continue;
    const auto first = std::ranges::find_if(
        held, [&](const std::string& id) { return id == finding.object_id() || id == finding.partner_id(); });
    if (first != held.end()) which.emplace(*first, finding.message());
  }
  return which;
}

}  // namespace flair::session
