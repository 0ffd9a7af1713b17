// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>

#include "fmt/format.h"
#include "fmt/ranges.h"
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/registry.h"
#include "optimizer_worker/stages/driver.h"
#include "optimizer_worker/stages/infeasible.h"
#include "optimizer_worker/stages/solved_layout.h"
#include "optimizer_worker/stages/stage.h"

namespace flair::optimizer {
namespace {

// Most satisfied edges that are suspected beside a violated one; the first of the graph.
constexpr size_t kMostSuspects = 8;

// How a group of edges came out where it was solved alone.
struct Trial {
  bool holds = false;
  // Of what is missed at best: the first violated edge.
  v1::EdgeOutcome missed;
};

// The sentence that an edge comes from; of an edge without one its id and type.
std::string TextOf(const v1::ConstraintEdge& edge, const v1::ConstraintList& list) {
  for (const v1::Sentence& sentence : list.sentences()) {
    if (!edge.sentence_id().empty() && sentence.id() == edge.sentence_id()) {
      return fmt::format("\"{}\"", sentence.text());
    }
  }
  return fmt::format("\"{}\" ({})", edge.id(), edge.type());
}

class Finder {
 public:
  Finder(const SolveInput& input, const v1::SolvedLayout& layout) : input_(input), layout_(layout) {
    for (const v1::ConstraintEdge& edge : input.graph.edges()) named_.push_back(NamedObjects(edge, input.scene));
  }

  std::vector<v1::Contradiction> Run() {
    std::vector<v1::Contradiction> found;
    for (int e = 0; e < layout_.edge_outcomes_size(); ++e) {
      if (layout_.edge_outcomes(e).status() != v1::OUTCOME_STATUS_VIOLATED || IsAboutZones(e)) continue;
      std::optional<v1::Contradiction> contradiction = Explain(e);
      if (trials_ > kMostTrials || input_.Cancelled() || input_.OutOfTime()) break;
      if (!contradiction) continue;
      const bool known = std::ranges::any_of(found, [&](const v1::Contradiction& other) {
        return std::equal(other.edge_ids().begin(), other.edge_ids().end(), contradiction->edge_ids().begin(),
                          contradiction->edge_ids().end());
      });
      if (!known) found.push_back(*std::move(contradiction));
    }
    return found;
  }

 private:
  bool IsAboutZones(int edge) const {
    const ConstraintFacts* facts = FindConstraint(input_.graph.edges(edge).type());
    return facts == nullptr || std::ranges::any_of(facts->type.parameters(), [](const v1::ParameterSpec& spec) {
             return spec.kind() == v1::PARAMETER_KIND_ZONE;
           });
  }

  // Satisfied edges that share an object with the violated one.
  std::vector<int> SuspectsOf(int violated) const {
    std::vector<int> suspects;
    for (int e = 0; e < layout_.edge_outcomes_size() && suspects.size() < kMostSuspects; ++e) {
      if (layout_.edge_outcomes(e).status() != v1::OUTCOME_STATUS_SATISFIED || IsAboutZones(e)) continue;
      const bool shares = std::any_of(named_[e].begin(), named_[e].end(), [&](int object) {
        return std::binary_search(named_[violated].begin(), named_[violated].end(), object);
      });
      if (shares) suspects.push_back(e);
    }
    return suspects;
  }

  // The problem of these edges alone: their objects, the pinned ones, and what carries them.
  v1::LayoutGraph GraphOf(const std::vector<int>& edges) const {
    std::vector<char> kept = input_.pinned;
    for (int e : edges) {
      for (int object : named_[e]) kept[object] = 1;
    }
    for (size_t i = 0; i < kept.size(); ++i) {
      // Ends at the latest where hosts go round in a circle.
      int host = kept[i] ? input_.scene.objects[i].host : -1;
      for (; host >= 0 && !kept[host]; host = input_.scene.objects[host].host) kept[host] = 1;
    }
    IdSet gone;
    for (size_t i = 0; i < kept.size(); ++i) {
      if (!kept[i]) gone.insert(input_.scene.objects[i].id);
    }
    v1::LayoutGraph graph = input_.graph;
    graph.clear_edges();
    for (int e : edges) *graph.add_edges() = input_.graph.edges(e);
    RemoveObjects(gone, graph);
    return graph;
  }

  // Solves them by themselves. Only what they say and exactness counts: no zones, balance, pull of walls or ways.
  Trial Try(const std::vector<int>& edges) {
    ++trials_;
    const v1::LayoutGraph graph = GraphOf(edges);
    v1::SolveOptions options;
    options.set_max_restart_count(kHoldRestarts);
    options.set_path_width_m(0);
    Trial trial;
    absl::StatusOr<SolveInput> alone = MakeSolveInput(graph, options, input_.solver, input_.cancelled);
    if (!alone.ok()) return Trial{true, {}};
    LambdaValues& lambdas = alone->settings.lambdas;
    lambdas.wall_attraction_divisor = lambdas.zone = lambdas.balanced = 0;
    alone->settings.seed = input_.settings.seed;
    alone->settings.threads = input_.settings.threads;
    const absl::StatusOr<std::vector<Branch>> branches = Driver(*alone, LocalRestartRunner()).Run();
    if (!branches.ok()) return Trial{true, {}};
    for (const Branch& branch : *branches) {
      if (!branch.complete) break;
      const SceneCosts costs = BindCosts(*alone, branch.state);
      const std::vector<v1::EdgeOutcome> outcomes = EdgeOutcomes(*alone, costs, branch.state);
      const auto missed = std::ranges::find_if(
          outcomes, [](const v1::EdgeOutcome& outcome) { return outcome.status() == v1::OUTCOME_STATUS_VIOLATED; });
      trial.missed = missed == outcomes.end() ? v1::EdgeOutcome() : *missed;
      trial.holds = missed == outcomes.end() && FindMisfits(*alone, costs, branch.state).empty();
      if (trial.holds) break;
    }
    return trial;
  }

  std::optional<v1::Contradiction> Explain(int violated) {
    const Trial by_itself = Try({violated});
    if (!by_itself.holds) return Describe({violated}, violated, by_itself.missed);
    std::vector<int> group = SuspectsOf(violated);
    group.push_back(violated);
    Trial clash = Try(group);
    if (clash.holds || group.size() < 2) return std::nullopt;
    for (size_t k = 0; k + 1 < group.size() && trials_ <= kMostTrials;) {
      std::vector<int> without = group;
      without.erase(without.begin() + static_cast<std::ptrdiff_t>(k));
      const Trial trial = without.size() == 1 ? by_itself : Try(without);
      if (trial.holds) {
        ++k;
        continue;
      }
      group = std::move(without);
      clash = trial;
    }
    return Describe(std::move(group), violated, clash.missed);
  }

  static std::string Words(const v1::ArgumentValue& value) {
    if (value.has_texts()) return fmt::format("{}", fmt::join(value.texts().items(), ","));
    if (value.has_number()) return fmt::format("{:.6g}", value.number());
    return value.has_flag() ? (value.flag() ? "true" : "false") : value.text();
  }

  // The sentence that an edge comes from, or its call.
  std::string Words(const v1::ConstraintEdge& edge) const {
    const std::string text = TextOf(edge, input_.graph.constraint_list());
    if (!edge.sentence_id().empty() && !text.ends_with(')')) return text;
    std::string call;
    for (const v1::Argument& argument : edge.arguments()) {
      call += fmt::format(" {}={}", argument.name(), Words(argument.value()));
    }
    return fmt::format("{} ({}{})", edge.id(), edge.type(), call);
  }

  std::string WordsOf(const std::string& edge_id) const {
    const auto edge = std::ranges::find(input_.graph.edges(), edge_id, &v1::ConstraintEdge::id);
    return edge == input_.graph.edges().end() ? edge_id : Words(*edge);
  }

  v1::Contradiction Describe(std::vector<int> group, int violated, const v1::EdgeOutcome& missed) const {
    std::sort(group.begin(), group.end());
    v1::Contradiction contradiction;
    std::vector<std::string> others;
    for (int e : group) {
      contradiction.add_edge_ids(input_.graph.edges(e).id());
      if (e != violated) others.push_back(Words(input_.graph.edges(e)));
    }
    // Without a missed edge it is the furniture that does not fit.
    std::string best = "the objects do not fit";
    if (missed.has_missed_by()) {
      best = fmt::format("{} is missed by {:.2f} {}", WordsOf(missed.edge_id()), missed.missed_by(), missed.unit());
    } else if (!missed.edge_id().empty()) {
      best = fmt::format("{} is missed, {}", WordsOf(missed.edge_id()), missed.reason());
    }
    const std::string what = Words(input_.graph.edges(violated));
    contradiction.set_explanation(
        others.empty()
            ? fmt::format("{} cannot hold in this room, even with nothing else in it: at best {}", what, best)
            : fmt::format("{} cannot hold together with {}: at best {}", what, fmt::join(others, " and "), best));
    return contradiction;
  }

  const SolveInput& input_;
  const v1::SolvedLayout& layout_;
  // Per edge, the objects that it names, ascending.
  std::vector<std::vector<int>> named_;
  int trials_ = 0;
};

// Whether it names an object that `gone` is true of.
template <typename Gone>
bool Names(const v1::Meaning& meaning, const Gone& gone) {
  const auto among = [&](const auto& participants) {
    return std::ranges::any_of(participants, [&](const v1::Participant& one) { return gone(one.object_id()); });
  };
  return std::ranges::any_of(meaning.facts(), [&](const v1::Fact& fact) {
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

std::vector<v1::Contradiction> FindContradictions(const SolveInput& input, const v1::SolvedLayout& layout) {
  return Finder(input, layout).Run();
}

std::vector<v1::Diagnostic> RemoveObjects(const IdSet& ids, v1::LayoutGraph& graph) {
  std::vector<v1::Diagnostic> diagnostics;
  Erase(*graph.mutable_edges(), [&](v1::ConstraintEdge& edge) {
    bool shrunk = false;
    const std::string gone = Shrink(ids, edge, shrunk);
    if (!gone.empty()) {
      diagnostics.push_back(
          About("edge_removed", edge,
                fmt::format("{} is gone with \"{}\", which it names", TextOf(edge, graph.constraint_list()), gone)));
    } else if (shrunk) {
      diagnostics.push_back(
          About("edge_shortened", edge,
                fmt::format("{} is about the objects that are left", TextOf(edge, graph.constraint_list()))));
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
