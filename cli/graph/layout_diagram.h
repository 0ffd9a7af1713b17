// SPDX-License-Identifier: GPL-3.0-or-later
// A layout graph as a diagram: nodes, links and rows, free of any drawing.
#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/solved_layout.pb.h"

namespace flair::cli {

// One constraint call as the diagram says it.
struct DiagramCall {
  v1::OutcomeStatus status = v1::OUTCOME_STATUS_UNSPECIFIED;  // UNSPECIFIED: not solved
  std::string words;                                          // such as "next to", with by how much it is missed
  std::string tooltip = {};                                   // the sentence, the call, the reason
};

enum class DiagramKind { kObject, kWall, kDoor, kWindow, kSocket, kRoom };

struct DiagramNode {
  std::string id;  // of the object, name of the wall, "door", "door_1", ...
  std::string name;
  std::string facts;  // one line: size, ids
  DiagramKind kind = DiagramKind::kObject;
  int zone = -1;                       // index in Diagram::zones; -1: of the whole room
  std::vector<DiagramCall> rows = {};  // calls about it alone
};

// All calls between the same two nodes.
struct DiagramLink {
  int from = 0;
  int to = 0;
  std::vector<DiagramCall> calls;
};

// A call that names three nodes or more.
struct DiagramGroup {
  DiagramCall call;
  std::vector<int> members;
};

struct DiagramZone {
  std::string id;
  std::string name;
};

struct Diagram {
  std::string title;
  bool is_solved = false;
  std::vector<DiagramZone> zones;
  std::vector<DiagramNode>
      nodes;  // objects first; walls and openings that some call names; the room when one names none
  std::vector<DiagramLink> links;
  std::vector<DiagramGroup> groups;
};

// Of a solved layout, with verdicts.
Diagram DiagramOf(const v1::SolvedLayout& layout);
// Of a graph that nobody solved.
Diagram DiagramOf(const v1::LayoutGraph& graph);

// The worst of the verdicts: what a link of several calls looks like.
v1::OutcomeStatus WorstOf(const std::vector<DiagramCall>& calls);

// The diagram in Graphviz's language: zones are clusters in the plan's colours, objects tables with a row for each call
// about them alone, links coloured by verdict with the sentences as tooltips. Pure; any text of a layout is escaped.
std::string DotText(const Diagram& diagram);

// What Graphviz's program `dot` makes of `text` as "svg", "png" or "pdf". A process of its own: nothing of Graphviz is
// loaded by other commands, and a graph that it cannot cope with harms nobody. The same text gives the same bytes.
// FAILED_PRECONDITION when there is no `dot`, DEADLINE_EXCEEDED when it takes more than two minutes, INTERNAL with what
// it said otherwise.
absl::StatusOr<std::string> RunDot(const std::string& text, const std::string& format);

}  // namespace flair::cli
