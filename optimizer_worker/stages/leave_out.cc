// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <optional>

#include "evaluation/metrics/layout_metrics.h"
#include "fmt/format.h"
#include "optimizer_worker/constraints/registry.h"
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
  const Misfit& misfit = *std::ranges::find_if(misfits, named);
  if (misfit.other < 0) return fmt::format("it {} by {:.2f} m wherever it is put", misfit.what, misfit.depth_m);
  const int other = misfit.object == object ? misfit.other : misfit.object;
  return fmt::format("it {} {} by {:.2f} m wherever it is put", misfit.what, NameForPeople(input.scene, other),
                     misfit.depth_m);
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
    TakeOut(branch, i, fmt::format("it belongs to {}, which is left out", NameForPeople(input.scene, carrier)));
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
  ASSIGN_OR_RETURN(std::vector<Branch> branches, Driver(part, runner).Run());
  for (Branch& branch : branches) branch.state = Widen(part, branch.state, input);
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
    const bool floor_fits = std::ranges::none_of(
        trial.left_out, [&](const LeftOut& left) { return IsSolid(input.scene.objects[left.object]); });
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

// What a spare piece may miss: 0.15 m of what its sentences want, where they weigh at least 1.
constexpr double kBadCost = 0.0225;
constexpr double kBadWeight = 1;

// The object that a call places; -1 when it names several or none.
int MoverOf(const SolveInput& input, const v1::ConstraintEdge& edge) {
  return edge.arguments().empty() ? -1 : input.scene.IndexOf(edge.arguments(0).value().text());
}

// Per object, whether the room does without it: not where it carries what is to stay, nor where that is placed by it.
std::vector<char> FindSpares(const SolveInput& input) {
  const int count = static_cast<int>(input.scene.objects.size());
  std::vector<char> spare(count);
  for (int i = 0; i < count; ++i) {
    const v1::Object& object = input.graph.object_list().objects(i);
    spare[i] = object.spare() && !object.requested() && !input.pinned[i];
  }
  for (bool changed = true; changed;) {
    changed = false;
    const auto keep = [&](int object) {
      changed = changed || spare[object];
      spare[object] = 0;
    };
    for (int i = 0; i < count; ++i) {
      if (const int host = input.scene.objects[i].host; host >= 0 && !spare[i]) keep(host);
    }
    for (const v1::ConstraintEdge& edge : input.graph.edges()) {
      const int mover = MoverOf(input, edge);
      if (mover >= 0 && spare[mover]) continue;
      for (int object : NamedObjects(edge, input.scene)) keep(object);
    }
  }
  return spare;
}

const std::string& TextOf(const SolveInput& input, const v1::ConstraintEdge& edge) {
  const auto& sentences = input.graph.constraint_list().sentences();
  const auto found = std::ranges::find(sentences, edge.sentence_id(), &v1::Sentence::id);
  return found == sentences.end() ? edge.type() : found->text();
}

// Why a spare object is better left out of a layout; nothing where it stands well.
class SpareJudge {
 public:
  SpareJudge(const SolveInput& input, const Branch& branch)
      : input_(input),
        state_(branch.state),
        costs_(BindCosts(input, branch.state)),
        outcomes_(EdgeOutcomes(input, costs_, state_)),
        misfits_(FindMisfits(input, costs_, state_)),
        fronts_(Fronts(state_)) {}

  std::optional<std::string> Fault(int object) const {
    for (int e = 0; e < input_.graph.edges_size(); ++e) {
      const v1::ConstraintEdge& edge = input_.graph.edges(e);
      const bool bad = outcomes_[e].status() == v1::OUTCOME_STATUS_VIOLATED && outcomes_[e].cost() > kBadCost &&
                       edge.weight() >= kBadWeight;
      if (bad && MoverOf(input_, edge) == object) {
        return fmt::format("nobody asked for it, and no place was found where \"{}\" holds", TextOf(input_, edge));
      }
    }
    const auto named = [object](const Misfit& misfit) { return misfit.object == object || misfit.other == object; };
    if (std::ranges::any_of(misfits_, named)) return "nobody asked for it, and it does not fit";
    return IsSolid(input_.scene.objects[object]) ? Hindrance(object) : std::nullopt;
  }

 private:
  double Fronts(const PartialLayout& state) const {
    return evaluation::MeasureLayout({input_.scene, state.layout, state.placed}).reachable_front_share();
  }

  // What the others would have without it.
  std::optional<std::string> Hindrance(int object) const {
    PartialLayout without = state_;
    without.placed[object] = 0;
    without.layout[object] = FarAway(object);
    const std::vector<v1::EdgeOutcome> outcomes = EdgeOutcomes(input_, costs_, without);
    for (int e = 0; e < input_.graph.edges_size(); ++e) {
      const bool cured = outcomes_[e].status() == v1::OUTCOME_STATUS_VIOLATED && outcomes_[e].cost() > kBadCost &&
                         outcomes[e].status() == v1::OUTCOME_STATUS_SATISFIED;
      if (!cured) continue;
      return fmt::format("nobody asked for it, and without it \"{}\" holds", TextOf(input_, input_.graph.edges(e)));
    }
    // What belongs to another piece, such as a footstool, may stand before it.
    constexpr double kRounding = 1e-9;
    if (!input_.partners[object].empty() || Fronts(without) <= fronts_ + kRounding) return std::nullopt;
    return "nobody asked for it, and it stands in the way to other pieces";
  }

  const SolveInput& input_;
  const PartialLayout& state_;
  const SceneCosts costs_;
  const std::vector<v1::EdgeOutcome> outcomes_;
  const std::vector<Misfit> misfits_;
  const double fronts_;
};

// Takes out the spare objects that stand badly, with what they carry and what is placed by them; whether one of them
// stood on the floor.
bool TakeOutBadSpares(const SolveInput& input, const std::vector<char>& spare, Branch& branch) {
  const SpareJudge judge(input, branch);
  const std::size_t before = branch.left_out.size();
  std::vector<LeftOut> bad;
  for (int i = 0; i < static_cast<int>(spare.size()); ++i) {
    if (!spare[i] || !branch.state.placed[i]) continue;
    if (std::optional<std::string> fault = judge.Fault(i)) bad.push_back({i, std::move(*fault)});
  }
  for (LeftOut& left : bad) {
    if (!branch.state.placed[left.object]) continue;
    TakeOut(branch, left.object, std::move(left.reason));
    TakeOutRiders(input, left.object, branch);
  }
  for (const v1::ConstraintEdge& edge : input.graph.edges()) {
    const int mover = MoverOf(input, edge);
    if (mover < 0 || !spare[mover] || !branch.state.placed[mover]) continue;
    for (int object : NamedObjects(edge, input.scene)) {
      if (object == mover || branch.state.placed[object] || !branch.state.placed[mover]) continue;
      TakeOut(branch, mover, fmt::format("it belongs to {}, which is left out", NameForPeople(input.scene, object)));
      TakeOutRiders(input, mover, branch);
    }
  }
  return std::any_of(branch.left_out.begin() + static_cast<std::ptrdiff_t>(before), branch.left_out.end(),
                     [&](const LeftOut& left) { return IsSolid(input.scene.objects[left.object]); });
}

double LackOf(const SolveInput& input, const PartialLayout& state) {
  double lack = 0;
  for (const v1::EdgeOutcome& outcome : EdgeOutcomes(input, BindCosts(input, state), state)) {
    if (outcome.status() == v1::OUTCOME_STATUS_VIOLATED) lack += outcome.weighted_cost();
  }
  return lack;
}

}  // namespace

absl::StatusOr<std::vector<Branch>> SolveWithoutBadSpares(const SolveInput& input, const RestartRunner& runner,
                                                          std::vector<Branch> branches) {
  const std::vector<char> spare = FindSpares(input);
  if (std::ranges::none_of(spare, [](char one) { return one != 0; })) return branches;
  for (int solve = 0; solve < kMostSolves; ++solve) {
    const bool moves = TakeOutBadSpares(input, spare, branches.front());
    if (!moves || input.Cancelled() || input.OutOfTime()) break;
    const std::vector<LeftOut> out = branches.front().left_out;
    ASSIGN_OR_RETURN(std::vector<Branch> rest, SolveRest(input, runner, out));
    if (LackOf(input, rest.front().state) > LackOf(input, branches.front().state)) break;
    for (Branch& branch : rest) branch.left_out = out;
    branches = std::move(rest);
  }
  for (std::size_t i = 1; i < branches.size(); ++i) {
    if (branches[i].complete) TakeOutBadSpares(input, spare, branches[i]);
  }
  return branches;
}

}  // namespace flair::optimizer
