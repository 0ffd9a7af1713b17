// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/linked_pairs.h"

#include <set>
#include <string>
#include <string_view>

#include "optimizer_worker/constraints/arguments.h"
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/registry.h"

namespace flair::optimizer {
namespace {

constexpr unsigned Bit(Side side) { return 1u << static_cast<unsigned>(side); }
constexpr unsigned kAll = 0xF;
constexpr unsigned kFront = Bit(Side::kFront);
// What stands no farther before something is used from there.
constexpr double kStep_m = 1.0;
constexpr unsigned kBeside = Bit(Side::kLeft) | Bit(Side::kRight);

// Beside without a side may be at the back as well, but nobody says "beside" of what stands before the front.
unsigned BesideAt(const std::optional<Side>& side) { return side.has_value() ? Bit(*side) : kAll & ~kFront; }

}  // namespace

LinkedPairs::LinkedPairs(const Scene& scene, const v1::LayoutGraph& graph) {
  std::set<std::string_view> uses;
  for (const v1::Sentence& sentence : graph.constraint_list().sentences()) {
    if (sentence.use()) uses.insert(sentence.id());
  }
  // Where nothing is known of uses, those that face each other need the others' ties.
  for (const bool facing : {false, true}) {
    for (const v1::ConstraintEdge& edge : graph.edges()) {
      if ((FindConstraint(edge.type()) == FindConstraint("facing")) != facing) continue;
      const Known use = uses.empty()                        ? Known::kNothing
                        : uses.contains(edge.sentence_id()) ? Known::kUse
                                                            : Known::kNoUse;
      AddEdge(scene, edge, use);
    }
  }
}

void LinkedPairs::Link(int a, int b) {
  Place(a, b, kAll);
  Place(b, a, kAll);
}

bool LinkedPairs::BelongsAt(int object, int other, Side side) const {
  const auto found = sides_.find({object, other});
  return found != sides_.end() && (found->second & Bit(side)) != 0;
}

double LinkedPairs::TieOf(int a, int b) const {
  const auto found = ties_.find(std::minmax(a, b));
  return found == ties_.end() ? 0.0 : found->second;
}

void LinkedPairs::TieAll(const std::vector<int>& objects, double weight) {
  for (size_t i = 0; i < objects.size(); ++i) {
    for (size_t k = 0; k < i; ++k) Tie(objects[k], objects[i], weight);
  }
}

int LinkedPairs::CountAbove(int target) const {
  const auto found = above_.find(target);
  return found == above_.end() ? 0 : found->second;
}

void LinkedPairs::AddEdge(const Scene& scene, const v1::ConstraintEdge& edge, Known use) {
  const ConstraintFacts* facts = FindConstraint(edge.type());
  if (facts == nullptr) return;
  const absl::StatusOr<Arguments> resolved = Arguments::Resolve(facts->type, edge, scene);
  if (!resolved.ok()) return;
  const Arguments& a = *resolved;
  const std::string& type = facts->name();
  if (type == "on_wall_above") ++above_[a.Object("target")];
  const double weight = edge.weight() > 0 ? edge.weight() : 1.0;
  if (type == "next_to") {
    Tie(a.Object("object"), a.Object("target"), weight);
    Place(a.Object("object"), a.Object("target"), BesideAt(a.MaybeSide("object_side")));
    Place(a.Object("target"), a.Object("object"), BesideAt(a.MaybeSide("target_side")));
  } else if (type == "in_front_of") {
    if (a.Number("distance_m") > kStep_m) return;
    Tie(a.Object("object"), a.Object("target"), weight);
    if (use == Known::kNoUse) return;
    Place(a.Object("object"), a.Object("target"), kAll);
    Place(a.Object("target"), a.Object("object"), kFront);
  } else if (type == "facing") {
    // Two seats that face each other need their room.
    const bool tied = use == Known::kNothing && TieOf(a.Object("object"), a.Object("target")) > 0;
    if (a.Flag("both") || !(use == Known::kUse || tied)) return;
    Place(a.Object("object"), a.Object("target"), kFront);
    Place(a.Object("target"), a.Object("object"), kAll);
  } else if (type == "on") {
    Link(a.Object("object"), a.Object("target"));
  } else if (type == "row") {
    TieAll(a.Objects("objects"), weight);
    AddGroup(a);
  } else if (type == "surround") {
    const std::vector<int>& seats = a.Objects("objects");
    if (seats.size() > static_cast<size_t>(kMostSeats)) return;
    for (int seat : seats) Tie(a.Object("center"), seat, weight);
    AddGroup(a);
  } else if (type == "between" || type == "perpendicular") {
    AddGroup(a);
  }
}

void LinkedPairs::AddGroup(const Arguments& a) {
  if (a.Has("first")) {
    for (const char* neighbour : {"first", "second"}) {
      Place(a.Object("object"), a.Object(neighbour), kBeside);
      Place(a.Object(neighbour), a.Object("object"), kAll);
    }
  } else if (a.Has("target")) {
    if (!a.Has("center")) return;
    for (const char* looker : {"object", "target"}) {
      Place(a.Object(looker), a.Object("center"), kFront);
      Place(a.Object("center"), a.Object(looker), kAll);
    }
  } else if (a.Has("center")) {
    for (int seat : a.Objects("objects")) {
      Place(seat, a.Object("center"), kFront);
      Place(a.Object("center"), seat, kAll);
    }
  } else {
    for (int one : a.Objects("objects")) {
      for (int other : a.Objects("objects")) {
        if (one != other) Place(one, other, kBeside);
      }
    }
  }
}

}  // namespace flair::optimizer
