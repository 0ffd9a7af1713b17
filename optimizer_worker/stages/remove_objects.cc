// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "fmt/format.h"
#include "optimizer_worker/stages/infeasible.h"

namespace flair::optimizer {
namespace {

// Whether it names an object that `gone` is true of.
template <typename Gone>
bool Names(const v1::Meaning& meaning, const Gone& gone) {
  const auto among = [&](const auto& participants) {
    return std::any_of(participants.begin(), participants.end(),
                       [&](const v1::Participant& one) { return gone(one.object_id()); });
  };
  return std::any_of(meaning.facts().begin(), meaning.facts().end(), [&](const v1::Fact& fact) {
    return among(fact.movers()) || among(fact.targets()) || among(fact.others());
  });
}

template <typename Message, typename Drop>
void Erase(google::protobuf::RepeatedPtrField<Message>& list, const Drop& drop) {
  int kept = 0;
  for (int i = 0; i < list.size(); ++i) {
    if (drop(list[i])) continue;
    if (kept != i) list.SwapElements(kept, i);
    ++kept;
  }
  list.DeleteSubrange(kept, list.size() - kept);
}

v1::Diagnostic About(const char* code, const v1::ConstraintEdge& edge, std::string message) {
  v1::Diagnostic diagnostic;
  diagnostic.set_severity(v1::SEVERITY_NOTE);
  diagnostic.set_code(code);
  diagnostic.set_subject_id(edge.id());
  diagnostic.set_message(std::move(message));
  return diagnostic;
}

// What becomes of an edge: "" when it may stay as it is now, else the removed object that it cannot do without.
std::string Shrink(const IdSet& ids, v1::ConstraintEdge& edge, bool& shrunk) {
  for (v1::Argument& argument : *edge.mutable_arguments()) {
    if (ids.contains(argument.value().text())) return argument.value().text();
    if (!argument.value().has_texts()) continue;
    auto& items = *argument.mutable_value()->mutable_texts()->mutable_items();
    const int before = items.size();
    const std::string first = before > 0 ? items[0] : "";
    Erase(items, [&](const std::string& item) { return ids.contains(item); });
    if (before > 0 && items.empty()) return first;
    shrunk = shrunk || items.size() < before;
  }
  return "";
}

}  // namespace

std::vector<v1::Diagnostic> RemoveObjects(const IdSet& ids, v1::LayoutGraph& graph) {
  std::vector<v1::Diagnostic> diagnostics;
  Erase(*graph.mutable_edges(), [&](v1::ConstraintEdge& edge) {
    bool shrunk = false;
    const std::string gone = Shrink(ids, edge, shrunk);
    if (!gone.empty()) {
      diagnostics.push_back(
          About("edge_removed", edge,
                fmt::format("\"{}\" ({}) is gone with \"{}\", which it names", edge.id(), edge.type(), gone)));
    } else if (shrunk) {
      diagnostics.push_back(
          About("edge_shortened", edge,
                fmt::format("\"{}\" ({}) is about the objects that are left", edge.id(), edge.type())));
    }
    return !gone.empty();
  });
  const auto gone = [&](const std::string& id) { return ids.contains(id); };
  Erase(*graph.mutable_object_list()->mutable_objects(), [&](const v1::Object& object) { return gone(object.id()); });
  for (v1::Object& object : *graph.mutable_object_list()->mutable_objects()) {
    if (gone(object.host_id())) object.clear_host_id();
  }
  Erase(*graph.mutable_pinned_placements(), [&](const v1::Placement& pin) { return gone(pin.object_id()); });
  Erase(*graph.mutable_style_sheet()->mutable_objects(),
        [&](const v1::ObjectStyle& style) { return gone(style.subject_id()); });
  for (v1::Sentence& sentence : *graph.mutable_constraint_list()->mutable_sentences()) {
    Erase(*sentence.mutable_subject_ids(), gone);
    // Its text is read in the room that is left.
    if (Names(sentence.meaning(), gone)) sentence.clear_meaning();
  }
  return diagnostics;
}

}  // namespace flair::optimizer
