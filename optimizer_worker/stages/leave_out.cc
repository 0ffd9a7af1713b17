// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>

#include "fmt/format.h"
#include "optimizer_worker/stages/floor_stages.h"
#include "optimizer_worker/stages/infeasible.h"
#include "optimizer_worker/stages/solved_layout.h"
#include "optimizer_worker/stages/stage.h"
#include "optimizer_worker/stages/tertiary.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::optimizer {

namespace {

// Solves of the rest; each leaves out what the one before could not place.
constexpr int kMostSolves = 4;

std::vector<Misfit> MisfitsOf(const SolveInput& input, const PartialLayout& state) {
  return FindMisfits(input, BindCosts(input, state), state);
}

// Small for what is left out first.
int ImportanceOf(const SolveInput& input, int object) {
  switch (input.scene.objects[object].role) {
    case ObjectRole::kTertiary:
      return 0;
    case ObjectRole::kSecondary:
      return input.graph.object_list().objects(object).requested() ? 2 : 1;
    case ObjectRole::kPrimary:
      return 3;
  }
  return 3;
}

// The object of all misfits that is to go: least important, then deepest in the way, then last; -1 when all are pinned.
int Scapegoat(const SolveInput& input, const std::vector<Misfit>& misfits) {
  std::map<int, double> depth_of;
  for (const Misfit& misfit : misfits) {
    for (int object : {misfit.object, misfit.other}) {
      if (object >= 0 && !input.pinned[object]) depth_of[object] += misfit.depth_m;
    }
  }
  int chosen = -1;
  for (const auto& [object, depth_m] : depth_of) {
    const int importance = ImportanceOf(input, object);
    const int least = chosen < 0 ? 0 : ImportanceOf(input, chosen);
    if (chosen < 0 || importance < least || (importance == least && depth_m >= depth_of[chosen])) chosen = object;
  }
  return chosen;
}

std::string ReasonOf(const SolveInput& input, const PartialLayout& without, const std::vector<Misfit>& misfits,
                     int object) {
  if (IsSolid(input.scene.objects[object])) return NoFreePlace(input, without, object);
  const auto named = [object](const Misfit& m) { return m.object == object || m.other == object; };
  const Misfit& misfit = *std::find_if(misfits.begin(), misfits.end(), named);
  if (misfit.other < 0) return fmt::format("it {} by {:.2f} m wherever it is put", misfit.what, misfit.depth_m);
  const int other = misfit.object == object ? misfit.other : misfit.object;
  return fmt::format("it {} \"{}\" by {:.2f} m wherever it is put", misfit.what, input.scene.objects[other].id,
                     misfit.depth_m);
}

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

void TakeOut(Branch& branch, int object, std::string reason) {
  branch.state.placed[object] = 0;
  branch.state.layout[object] = FarAway(object);
  branch.left_out.push_back({object, std::move(reason)});
}

// What stands on `carrier`, by its host.
void TakeOutRiders(const SolveInput& input, int carrier, Branch& branch) {
  for (int i = 0; i < static_cast<int>(input.scene.objects.size()); ++i) {
    if (input.scene.objects[i].host != carrier || !branch.state.placed[i] || input.pinned[i]) continue;
    TakeOut(branch, i, fmt::format("it belongs to \"{}\", which is left out", input.scene.objects[carrier].id));
    TakeOutRiders(input, i, branch);
  }
}

// When something went while less important furniture stays: takes that out too, to see whether the first fits then.
void MakeRoomForTheImportant(const SolveInput& input, Branch& branch) {
  int most = 0;
  for (const LeftOut& left : branch.left_out) most = std::max(most, ImportanceOf(input, left.object));
  for (int i = 0; i < static_cast<int>(input.scene.objects.size()); ++i) {
    const bool lesser = IsSolid(input.scene.objects[i]) && !input.pinned[i] && ImportanceOf(input, i) < most;
    if (!lesser || !branch.state.placed[i]) continue;
    TakeOut(branch, i, "");
    TakeOutRiders(input, i, branch);
  }
}

// A layout of a part of the input's objects, as one of the input.
PartialLayout Widen(const SolveInput& part, const PartialLayout& state, const SolveInput& input) {
  PartialLayout wide(input.scene);
  for (size_t i = 0; i < part.scene.objects.size(); ++i) {
    if (state.placed[i]) wide.Place(input.scene.IndexOf(part.scene.objects[i].id), state.layout[i]);
  }
  return wide;
}

// Solves without what `out` leaves out.
absl::StatusOr<std::vector<Branch>> SolveRest(const SolveInput& input, const RestartRunner& runner,
                                              const std::vector<LeftOut>& out) {
  IdSet ids;
  for (const LeftOut& left : out) ids.insert(input.scene.objects[left.object].id);
  if (ids.size() == input.scene.objects.size()) {
    return std::vector<Branch>(1, Branch{PartialLayout(input.scene), 0, {}, {}});
  }
  v1::LayoutGraph rest = input.graph;
  RemoveObjects(ids, rest);
  ASSIGN_OR_RETURN(SolveInput part, MakeSolveInput(rest, {}, input.solver, input.cancelled));
  part.settings = input.settings;
  part.out_of_time = input.out_of_time;
  if (part.settings.groups) part.groups = FindGroups(part);
  absl::StatusOr<std::vector<Branch>> branches = Driver(part, runner).Run();
  if (!branches.ok()) return branches.status();
  for (Branch& branch : *branches) branch.state = Widen(part, branch.state, input);
  return branches;
}

// Puts `object` where it suits the layout best and lets the floor make room for it; false when that does not work out.
bool PutBack(const SolveInput& input, int object, Branch& branch) {
  const bool floor = IsSolid(input.scene.objects[object]);
  const StageSpec alone{floor ? StageKind::kSecondary : StageKind::kTertiary, -1, {object}};
  PartialLayout state = floor ? FurnishRestart(input, alone, branch.state, 0).state
                              : TertiaryRestart(input, alone, branch.state, 0).state;
  if (floor) {
    StageSpec all = FreeStage(input, StageKind::kPolish);
    std::erase_if(all.objects, [&](int i) { return !state.placed[i]; });
    state = PolishRestart(input, all, state, 0).state;
    StageSpec rest = FreeStage(input, StageKind::kTertiary);
    std::erase_if(rest.objects, [&](int i) { return !state.placed[i]; });
    for (int i : rest.objects) state.placed[i] = 0;
    state = TertiaryRestart(input, rest, state, 0).state;
  }
  if (MisfitsOf(input, state).size() > MisfitsOf(input, branch.state).size()) return false;
  branch.state = std::move(state);
  return true;
}

void PutBackWhatFits(const SolveInput& input, Branch& branch) {
  std::vector<LeftOut> out = std::move(branch.left_out);
  branch.left_out.clear();
  std::stable_sort(out.begin(), out.end(), [&](const LeftOut& a, const LeftOut& b) {
    return ImportanceOf(input, a.object) > ImportanceOf(input, b.object);
  });
  for (LeftOut& left : out) {
    const int host = input.scene.objects[left.object].host;
    const bool hosted = host < 0 || branch.state.placed[host];
    if (hosted && !input.Cancelled() && !input.OutOfTime() && PutBack(input, left.object, branch)) continue;
    // The free places of the layout as it is now.
    if (hosted && IsSolid(input.scene.objects[left.object])) {
      left.reason = NoFreePlace(input, branch.state, left.object);
    }
    branch.left_out.push_back(std::move(left));
  }
}

}  // namespace

void LeaveOutOf(const SolveInput& input, Branch& branch) {
  // What is in the way of what does not depend on the zones: the costs may be those of the first round.
  const SceneCosts costs = BindCosts(input, branch.state);
  while (!input.Cancelled()) {
    const std::vector<Misfit> misfits = FindMisfits(input, costs, branch.state);
    const int object = Scapegoat(input, misfits);
    if (object < 0) return;
    branch.state.placed[object] = 0;
    std::string reason = ReasonOf(input, branch.state, misfits, object);
    TakeOut(branch, object, std::move(reason));
    TakeOutRiders(input, object, branch);
  }
}

absl::StatusOr<std::vector<Branch>> SolveWithoutMisfits(const SolveInput& input, const RestartRunner& runner,
                                                        std::vector<Branch> branches) {
  std::vector<LeftOut> out;
  for (int solve = 0; solve < kMostSolves; ++solve) {
    Branch trial = branches.front();
    LeaveOutOf(input, trial);
    if (trial.left_out.size() == branches.front().left_out.size()) break;
    // For a picture nobody moves the furniture.
    const bool floor_fits = std::none_of(trial.left_out.begin(), trial.left_out.end(), [&](const LeftOut& left) {
      return IsSolid(input.scene.objects[left.object]);
    });
    if (floor_fits) {
      branches.front() = std::move(trial);
      break;
    }
    if (solve == 0) MakeRoomForTheImportant(input, trial);
    out = trial.left_out;
    if (input.OutOfTime() || solve + 1 == kMostSolves) {
      branches.assign(1, std::move(trial));
      break;
    }
    ASSIGN_OR_RETURN(branches, SolveRest(input, runner, out));
    for (Branch& branch : branches) branch.left_out = out;
  }
  if (!branches.front().left_out.empty()) PutBackWhatFits(input, branches.front());
  // Variants do without what does not fit in them.
  for (size_t i = 1; i < branches.size(); ++i) {
    if (branches[i].complete) LeaveOutOf(input, branches[i]);
  }
  return branches;
}

namespace {

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
