// SPDX-License-Identifier: GPL-3.0-or-later
// Finding things in the lists of a layout, and dropping them.
#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "flair/v1/layout_edit.pb.h"
#include "flair/v1/solved_layout.pb.h"

namespace flair::session {

using IdSet = std::set<std::string>;
using ObjectIds = std::vector<std::string>;
using EditList = google::protobuf::RepeatedPtrField<v1::LayoutEdit>;

inline IdSet IdSetOf(const ObjectIds& ids) { return {ids.begin(), ids.end()}; }

// Of placements those of their objects.
template <typename Items>
IdSet IdsOf(const Items& items) {
  IdSet ids;
  for (const auto& item : items) {
    if constexpr (requires { item.object_id(); }) {
      ids.insert(item.object_id());
    } else {
      ids.insert(item.id());
    }
  }
  return ids;
}

// Ids that none of these has: "e7", "e8".
class FreeIds {
 public:
  template <typename Items>
  FreeIds(const Items& items, std::string letters)
      : taken_(IdsOf(items)), letters_(std::move(letters)), last_(items.size()) {}
  std::string Next() {
    std::string id;
    do id = letters_ + std::to_string(++last_);
    while (!taken_.insert(id).second);
    return id;
  }

 private:
  IdSet taken_;
  const std::string letters_;
  int last_;
};

template <typename List, typename Which>
void EraseIf(List& list, const Which& which) {
  list.erase(std::remove_if(list.begin(), list.end(), which), list.end());
}

// Calls visit(edge, outcome) for every constraint that was evaluated.
template <typename Visit>
void ForOutcomes(const v1::SolvedLayout& layout, const Visit& visit) {
  for (int i = 0; i < layout.edge_outcomes_size() && i < layout.graph().edges_size(); ++i) {
    visit(layout.graph().edges(i), layout.edge_outcomes(i));
  }
}

// Null when there is none of that id.
const v1::Object* ObjectOf(const v1::SolvedLayout& layout, std::string_view id);

// Where an object stands; null when it has no place.
const v1::Placement* PlaceOf(const v1::SolvedLayout& layout, std::string_view id);
// Whether two places are the same to the last bit; the height is that of what carries it.
inline bool StandSame(const v1::Placement& a, const v1::Placement& b) {
  return a.x_m() == b.x_m() && a.y_m() == b.y_m() && a.theta_rad() == b.theta_rad();
}

// The texts of an edge's arguments in their order: ids of objects, names of walls, words.
std::vector<std::string> TextsOf(const v1::ConstraintEdge& edge);
// The objects that an edge names.
IdSet ObjectsOf(const v1::ConstraintEdge& edge, const v1::LayoutGraph& graph);
// Those that the edges of sentences name.
IdSet ObjectsOf(const IdSet& sentence_ids, const v1::LayoutGraph& graph);

// Sentences that say how pieces are used with each other.
IdSet UsesOf(const v1::LayoutGraph& graph);

v1::Diagnostic Remark(v1::Severity severity, const char* code, const std::string& subject_id, std::string message);

}  // namespace flair::session
