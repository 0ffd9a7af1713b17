// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/holding.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "fmt/format.h"
#include "optimizer_worker/resolve/resolve_layout.h"
#include "session/act_words.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::session {
namespace {

const v1::Placement* PlaceOf(const v1::SolvedLayout& layout, const std::string& id) {
  const auto at = std::ranges::find(layout.placements(), id, &v1::Placement::object_id);
  return at == layout.placements().end() ? nullptr : &*at;
}

bool Unmoved(const v1::Placement& a, const v1::Placement& b) {
  return a.x_m() == b.x_m() && a.y_m() == b.y_m() && a.theta_rad() == b.theta_rad();
}

}  // namespace

v1::Producer ByHand() {
  v1::Producer producer;
  producer.set_program("flair");
  producer.set_method("placed by hand");
  producer.set_version("1");
  return producer;
}

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
  const std::set<std::string> holds(held.begin(), held.end());
  std::set<std::string> moved, pinned, there, locked;
  for (const v1::LayoutEdit& edit : edits) {
    if (edit.has_move_object()) moved.insert(edit.move_object().object_id());
    if (!edit.pin_object_id().empty()) locked.insert(edit.pin_object_id());
  }
  for (const v1::Placement& pin : problem.graph.pinned_placements()) pinned.insert(pin.object_id());
  for (const v1::Placement& pin : from.graph().pinned_placements()) locked.insert(pin.object_id());
  for (const v1::Object& object : problem.graph.object_list().objects()) there.insert(object.id());
  const auto resized = [&](const std::string& id) {
    return std::ranges::any_of(edits, [&](const v1::LayoutEdit& e) { return e.resize_object().object_id() == id; });
  };
  for (const std::string& id : by_hand) {
    if (!there.contains(id) || locked.contains(id)) continue;
    const auto now = std::ranges::find(problem.placements, id, &v1::Placement::object_id);
    const v1::Placement* const seen = PlaceOf(shown, id);
    // What a move has carried along stands elsewhere than where it was solved.
    const bool carried = seen != nullptr && !moved.contains(id) && !resized(id) &&
                         (now == problem.placements.end() || !Unmoved(*now, *seen));
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
  std::set<std::string> wanted;
  for (const v1::Placement& pin : before.pinned_placements()) wanted.insert(pin.object_id());
  for (const v1::LayoutEdit& edit : edits) {
    if (!edit.pin_object_id().empty()) wanted.insert(edit.pin_object_id());
    if (!edit.unpin_object_id().empty()) wanted.erase(edit.unpin_object_id());
  }
  const google::protobuf::RepeatedPtrField<v1::Placement> pins = graph.pinned_placements();
  graph.clear_pinned_placements();
  for (const v1::Placement& pin : pins) {
    if (wanted.contains(pin.object_id())) *graph.add_pinned_placements() = pin;
  }
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

void TellFreed(const v1::SolvedLayout& before, const std::string& id, const std::string& reason, Acted& acted) {
  const v1::Placement *was = PlaceOf(before, id), *is = PlaceOf(acted.layout, id);
  if (was != nullptr && is != nullptr && Unmoved(*was, *is)) return;
  std::erase(acted.by_hand, id);
  v1::Diagnostic& freed = *acted.layout.add_diagnostics();
  freed.set_severity(v1::SEVERITY_WARNING);
  freed.set_code("hand_placed_moved");
  freed.set_subject_id(id);
  freed.set_message(
      fmt::format("the {} could not stay where it was put by hand: {}", NameOf(acted.layout, id), reason));
}

}  // namespace flair::session
