// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/graph/layout_diagram.h"

#include <algorithm>
#include <map>

#include "cli/output/artifact_text.h"
#include "fmt/format.h"
#include "fmt/ranges.h"

namespace flair::cli {
namespace {

// What a call names, whatever its catalogue calls the parameters: ids of objects, names of walls, ids and kinds of
// openings and sockets. Zones and sides are no nodes; they become words of the call.
class Builder {
 public:
  Builder(const v1::LayoutGraph& graph, const v1::SolvedLayout* layout) : graph_(graph) {
    diagram_.title = graph.room().title();
    diagram_.is_solved = layout != nullptr;
    for (const v1::Zone& zone : graph.zone_plan().zones()) diagram_.zones.push_back({zone.id(), zone.name()});
    for (const v1::Sentence& sentence : graph.constraint_list().sentences())
      sentences_[sentence.id()] = sentence.text();
    for (const v1::Object& object : graph.object_list().objects()) AddObject(object);
    for (int i = 0; i < graph.edges_size(); ++i) {
      AddEdge(graph.edges(i),
              layout != nullptr && i < layout->edge_outcomes_size() ? &layout->edge_outcomes(i) : nullptr);
    }
  }

  Diagram Take() { return std::move(diagram_); }

 private:
  void AddObject(const v1::Object& object) {
    const auto zone = std::ranges::find(diagram_.zones, object.zone_id(), &DiagramZone::id);
    objects_[object.id()] = static_cast<int>(diagram_.nodes.size());
    diagram_.nodes.push_back(
        {.id = object.id(),
         .name = object.name().empty() ? object.id() : object.name(),
         .facts = fmt::format("{} · {:.2f} × {:.2f} m", object.id(), object.width_m(), object.depth_m()),
         .zone = zone == diagram_.zones.end() ? -1 : static_cast<int>(zone - diagram_.zones.begin())});
  }

  int Feature(const std::string& id, const std::string& name, const std::string& facts, DiagramKind kind) {
    const auto [found, is_new] = features_.emplace(id, static_cast<int>(diagram_.nodes.size()));
    if (is_new) diagram_.nodes.push_back({.id = id, .name = name, .facts = facts, .kind = kind});
    return found->second;
  }

  // The node that a text of a call names; -1 for none.
  int NodeNamed(const std::string& text) {
    if (const auto found = objects_.find(text); found != objects_.end()) return found->second;
    const v1::Room& room = graph_.room();
    for (const v1::Wall& wall : room.walls()) {
      if (wall.name() == text) return Feature("wall " + text, text + " wall", "", DiagramKind::kWall);
    }
    const auto kind_of = [](v1::OpeningKind kind) {
      return kind == v1::OPENING_KIND_DOOR ? DiagramKind::kDoor : DiagramKind::kWindow;
    };
    for (const v1::Opening& opening : room.openings()) {
      if (opening.id() == text) return Feature(text, text, "in " + opening.wall(), kind_of(opening.kind()));
    }
    for (const v1::Socket& socket : room.sockets()) {
      if (socket.id() == text) return Feature(text, text, "on " + socket.wall(), DiagramKind::kSocket);
    }
    return KindNamed(text);
  }

  // "door": any of the room's doors.
  int KindNamed(const std::string& text) {
    std::vector<std::string> ids;
    for (const v1::Opening& opening : graph_.room().openings()) {
      const bool is_door = opening.kind() == v1::OPENING_KIND_DOOR;
      if (text == (is_door ? "door" : "window")) ids.push_back(opening.id());
    }
    for (const v1::Socket& socket : graph_.room().sockets()) {
      if (text == "socket") ids.push_back(socket.id());
    }
    if (ids.empty()) return -1;
    const DiagramKind kind = text == "door"     ? DiagramKind::kDoor
                             : text == "window" ? DiagramKind::kWindow
                                                : DiagramKind::kSocket;
    return Feature(text, ids.size() == 1 ? text : "any " + text, fmt::format("{}", fmt::join(ids, ", ")), kind);
  }

  void AddEdge(const v1::ConstraintEdge& edge, const v1::EdgeOutcome* outcome) {
    std::vector<int> members;
    std::vector<std::string> words;  // what it names besides
    const auto see = [&](const std::string& text) {
      const int node = NodeNamed(text);
      if (node < 0) return words.push_back(text);
      if (std::ranges::find(members, node) == members.end()) members.push_back(node);
    };
    for (const v1::Argument& argument : edge.arguments()) {
      if (argument.value().has_texts()) {
        for (const std::string& text : argument.value().texts().items()) see(text);
      } else if (argument.value().value_case() == v1::ArgumentValue::kText) {
        see(argument.value().text());
      }
    }
    DiagramCall call = MakeCall(edge, outcome, words);
    if (members.size() == 2 && diagram_.nodes[members[1]].kind != DiagramKind::kObject) {
      // "clear of feature" points at the feature.
      if (const size_t at = call.words.find(" feature"); at != std::string::npos) call.words.erase(at, 8);
    }
    Place(std::move(call), members);
  }

  DiagramCall MakeCall(const v1::ConstraintEdge& edge, const v1::EdgeOutcome* outcome,
                       const std::vector<std::string>& words) const {
    DiagramCall call{.words = edge.type()};
    if (!words.empty()) call.words += fmt::format(" ({})", fmt::join(words, ", "));
    std::ranges::replace(call.words, '_', ' ');
    if (const auto found = sentences_.find(edge.sentence_id()); found != sentences_.end()) call.tooltip = found->second;
    call.tooltip += fmt::format("{}{}: {}", call.tooltip.empty() ? "" : "\n", edge.id(), CallText(edge));
    if (outcome == nullptr) return call;
    call.status = outcome->status();
    if (!outcome->reason().empty()) call.tooltip += "\n" + outcome->reason();
    if (call.status == v1::OUTCOME_STATUS_VIOLATED && outcome->has_missed_by()) {
      const std::string unit = outcome->unit() == "deg" ? "°" : outcome->unit() == "m2" ? " m²" : " " + outcome->unit();
      call.words += fmt::format(", off by {:.2f}{}", outcome->missed_by(), outcome->unit().empty() ? "" : unit);
    }
    return call;
  }

  void Place(DiagramCall call, const std::vector<int>& members) {
    if (members.empty()) {
      const int room = Feature("the room", "the whole room", "", DiagramKind::kRoom);
      diagram_.nodes[room].rows.push_back(std::move(call));
    } else if (members.size() == 1) {
      diagram_.nodes[members[0]].rows.push_back(std::move(call));
    } else if (members.size() == 2) {
      const std::pair<int, int> ends = std::minmax(members[0], members[1]);
      const auto [found, is_new] = links_.emplace(ends, diagram_.links.size());
      if (is_new) diagram_.links.push_back({members[0], members[1], {}});
      diagram_.links[found->second].calls.push_back(std::move(call));
    } else {
      diagram_.groups.push_back({std::move(call), members});
    }
  }

  const v1::LayoutGraph& graph_;
  Diagram diagram_;
  std::map<std::string, std::string> sentences_;
  std::map<std::string, int> objects_;
  std::map<std::string, int> features_;
  std::map<std::pair<int, int>, size_t> links_;
};

}  // namespace

Diagram DiagramOf(const v1::SolvedLayout& layout) { return Builder(layout.graph(), &layout).Take(); }

Diagram DiagramOf(const v1::LayoutGraph& graph) { return Builder(graph, nullptr).Take(); }

v1::OutcomeStatus WorstOf(const std::vector<DiagramCall>& calls) {
  const auto has = [&calls](v1::OutcomeStatus status) {
    return std::ranges::find(calls, status, &DiagramCall::status) != calls.end();
  };
  for (const v1::OutcomeStatus status :
       {v1::OUTCOME_STATUS_VIOLATED, v1::OUTCOME_STATUS_SATISFIED, v1::OUTCOME_STATUS_DROPPED}) {
    if (has(status)) return status;
  }
  return v1::OUTCOME_STATUS_UNSPECIFIED;
}

}  // namespace flair::cli
