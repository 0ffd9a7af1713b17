// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/layouts/edits.h"

#include <cmath>

#include "absl/strings/ascii.h"
#include "fmt/format.h"
#include "session/layouts/placing.h"

namespace flair::session {
namespace {

// "floor lamp" becomes "floor_lamp", or "floor_lamp_2" where there is one.
std::string FreeObjectId(const std::string& name, IdSet& taken) {
  std::string base;
  for (const char c : name) {
    const char low = absl::ascii_tolower(static_cast<unsigned char>(c));
    if (absl::ascii_isalnum(static_cast<unsigned char>(low))) {
      base += low;
    } else if (!base.empty() && base.back() != '_') {
      base += '_';
    }
  }
  while (base.ends_with('_')) base.pop_back();
  if (base.empty() || !absl::ascii_isalpha(static_cast<unsigned char>(base[0]))) base = "piece_" + base;
  std::string id = base;
  for (int n = 2; !taken.insert(id).second; ++n) id = fmt::format("{}_{}", base, n);
  return id;
}

// The zone whose middle is nearest to where an object will stand; the first without a place or regions.
std::string NearestZone(const v1::SolvedLayout& layout, const v1::Placement* at) {
  const auto& zones = layout.graph().zone_plan().zones();
  std::string nearest = zones.empty() ? "" : zones[0].id();
  double least = INFINITY;
  for (const v1::ZoneRegion& region : layout.zone_regions()) {
    if (at == nullptr) break;
    const double away = std::hypot(region.center().x_m() - at->x_m(), region.center().y_m() - at->y_m());
    if (away < least) least = away, nearest = region.zone_id();
  }
  return nearest;
}

}  // namespace

EditList Completed(const v1::SolvedLayout& layout, const EditList& edits) {
  IdSet taken = IdsOf(layout.graph().object_list().objects());
  EditList completed = edits;
  for (int i = 0; i < completed.size(); ++i) {
    if (!completed[i].has_add_object()) continue;
    v1::Object& object = *completed[i].mutable_add_object()->mutable_object();
    if (object.id().empty()) object.set_id(FreeObjectId(object.name(), taken));
    for (v1::ConstraintEdge& edge : *completed[i].mutable_add_object()->mutable_edges()) {
      for (v1::Argument& argument : *edge.mutable_arguments()) {
        if (argument.value().has_text() && argument.value().text().empty()) {
          argument.mutable_value()->set_text(object.id());
        }
      }
    }
    v1::Placement* at = nullptr;
    if (i + 1 < completed.size() && completed[i + 1].has_move_object()) {
      v1::Placement& next = *completed[i + 1].mutable_move_object();
      if (next.object_id().empty()) next.set_object_id(object.id());
      if (next.object_id() == object.id()) at = &next;
    }
    if (object.kind() == v1::OBJECT_KIND_UNSPECIFIED) object.set_kind(v1::OBJECT_KIND_FLOOR);
    if (object.role() == v1::OBJECT_ROLE_UNSPECIFIED) {
      const bool floor = object.kind() == v1::OBJECT_KIND_FLOOR && !object.walk_over();
      object.set_role(floor ? v1::OBJECT_ROLE_SECONDARY : v1::OBJECT_ROLE_TERTIARY);
    }
    if (object.zone_id().empty()) object.set_zone_id(NearestZone(layout, at));
    object.set_requested(true);
    if (at != nullptr) FaceIntoRoom(layout.graph().room(), object, true, *at);
  }
  return completed;
}

ObjectIds MovedIds(const v1::SolvedLayout& before, const v1::SolvedLayout& after) {
  ObjectIds ids;
  for (const v1::Object& object : after.graph().object_list().objects()) {
    const v1::Placement *was = PlaceOf(before, object.id()), *is = PlaceOf(after, object.id());
    if (is == nullptr) continue;
    if (was == nullptr || was->SerializeAsString() != is->SerializeAsString()) ids.push_back(object.id());
  }
  return ids;
}

EditList WhatStandsBadly(const v1::SolvedLayout& layout) {
  EditList edits;
  ForOutcomes(layout, [&](const v1::ConstraintEdge& edge, const v1::EdgeOutcome& outcome) {
    if (outcome.status() != v1::OUTCOME_STATUS_VIOLATED) return;
    v1::SetEdgeWeight& again = *edits.Add()->mutable_set_edge_weight();
    again.set_edge_id(edge.id());
    again.set_weight(edge.weight());
  });
  IdSet seen;
  for (const v1::Finding& finding : layout.metrics().findings()) {
    if (!finding.sentence_id().empty() || finding.object_id().empty()) continue;
    if (seen.insert(finding.object_id()).second) {
      edits.Add()->mutable_resize_object()->set_object_id(finding.object_id());
    }
  }
  return edits;
}

bool RemovesAll(const v1::SolvedLayout& layout, const EditList& edits) {
  IdSet left = IdsOf(layout.graph().object_list().objects());
  for (const v1::LayoutEdit& edit : edits) {
    if (edit.remove_object_id().empty()) return false;
    left.erase(edit.remove_object_id());
  }
  return left.empty();
}

}  // namespace flair::session
