// SPDX-License-Identifier: GPL-3.0-or-later
// Optimizer: the catalogue, which translators read and nobody else need know, is complete and true.
#include <algorithm>

#include "cli/contract/ask.h"
#include "cli/contract/call_fault.h"
#include "flair/v1/optimizer_service.pb.h"
#include "room/validation/validate.h"

namespace flair::contract {
namespace {

constexpr char kAsked[] = "ListConstraintTypes";
constexpr char kAskedPlaced[] = "ListConstraintTypes with_placed_examples";
// Weights scale weighted costs and nothing else.
constexpr double kWeight = 2;

using CatalogJudge = std::function<Finding(const v1::ConstraintCatalog&)>;

std::function<Finding(Target&)> OfCatalog(bool placed, CatalogJudge judge) {
  return [placed, judge = std::move(judge)](Target& target) {
    v1::ListConstraintTypesRequest request;
    request.set_with_placed_examples(placed);
    return Given<v1::ListConstraintTypesResponse>(
        target, placed ? kAskedPlaced : kAsked, request,
        [&judge](const v1::ListConstraintTypesResponse& answer) { return judge(answer.catalog()); });
  };
}

Finding IsValid(const v1::ConstraintCatalog& catalog) {
  return KeptIf(Validate(catalog), kAsked,
                "a library's name, and types with unique names, a summary and good parameters");
}

Finding IsSorted(const v1::ConstraintCatalog& catalog) {
  for (int i = 1; i < catalog.types_size(); ++i) {
    if (catalog.types(i - 1).name() < catalog.types(i).name()) continue;
    return Broken(kAsked, fmt::format("\"{}\" before \"{}\"", catalog.types(i - 1).name(), catalog.types(i).name()),
                  "types sorted by name");
  }
  return Kept();
}

Finding IsDocumented(const v1::ConstraintCatalog& catalog) {
  for (const v1::ConstraintType& type : catalog.types()) {
    if (!type.doc().empty() && !type.family().empty()) continue;
    return Broken(kAsked, fmt::format("\"{}\" has no {}", type.name(), type.doc().empty() ? "doc" : "family"),
                  "a doc (formula, symbols, unit of the cost) and a family for every type");
  }
  return Kept();
}

Finding ParametersAreGood(const v1::ConstraintCatalog& catalog) {
  for (const v1::ConstraintType& type : catalog.types()) {
    for (const v1::ParameterSpec& parameter : type.parameters()) {
      const std::string fault = ParameterFault(parameter);
      if (fault.empty()) continue;
      return Broken(kAsked, fmt::format("{}.{} {}", type.name(), parameter.name(), fault),
                    "a doc for every parameter; range, unit and default that belong to its kind");
    }
  }
  return Kept();
}

Finding ExamplesFitTheirTypes(const v1::ConstraintCatalog& catalog) {
  for (const v1::ConstraintType& type : catalog.types()) {
    for (int i = 0; i < type.examples_size(); ++i) {
      const std::string fault = ArgumentsFault(type, type.examples(i).arguments());
      if (fault.empty()) continue;
      return Broken(kAsked,
                    fmt::format("{}.examples[{}] (\"{}\"): {}", type.name(), i, type.examples(i).sentence(), fault),
                    "a call that fits the type's own parameters");
    }
  }
  return Kept();
}

Finding EveryTypeHasASentence(const v1::ConstraintCatalog& catalog) {
  for (const v1::ConstraintType& type : catalog.types()) {
    if (type.built_in() || type.examples_size() > 0) continue;
    return Broken(kAsked, fmt::format("\"{}\" has no examples", type.name()),
                  "an example sentence with its call for every type, as translators learn from them");
  }
  return Kept();
}

Finding PlacedOnlyWhenAsked(const v1::ConstraintCatalog& catalog) {
  for (const v1::ConstraintType& type : catalog.types()) {
    if (type.placed_examples_size() == 0) continue;
    return Broken(kAsked, fmt::format("{} placed examples of \"{}\"", type.placed_examples_size(), type.name()),
                  "none, as with_placed_examples is not set: they are for checks, and many times the rest");
  }
  return Kept();
}

Finding BothVerdictsAreShown(const v1::ConstraintCatalog& catalog) {
  for (const v1::ConstraintType& type : catalog.types()) {
    if (type.built_in()) continue;
    const auto& examples = type.placed_examples();
    const bool holds = std::ranges::any_of(examples, &v1::PlacedExample::satisfied);
    const bool fails = !std::ranges::all_of(examples, &v1::PlacedExample::satisfied);
    if (holds && fails) continue;
    return Broken(kAskedPlaced,
                  fmt::format("\"{}\" has {} placed examples, none that {}", type.name(), examples.size(),
                              holds ? "does not hold" : "holds"),
                  "a placed example that holds and one that does not for every type");
  }
  return Kept();
}

v1::EvaluateRequest RequestOf(const v1::ConstraintType& type, const v1::PlacedExample& example) {
  v1::EvaluateRequest request;
  v1::LayoutGraph& graph = *request.mutable_layout_graph();
  *graph.mutable_room() = example.room();
  *graph.mutable_zone_plan() = example.zone_plan();
  *graph.mutable_object_list() = example.object_list();
  v1::ConstraintEdge& edge = *graph.add_edges();
  edge.set_id("e1");
  edge.set_type(type.name());
  edge.set_weight(kWeight);
  *edge.mutable_arguments() = example.arguments();
  *request.mutable_placements() = example.placements();
  return request;
}

// What is wrong with the outcome of an example; empty when it is as it says.
std::string OutcomeFault(const v1::PlacedExample& example, const v1::EvaluateResponse& answer) {
  if (answer.edge_outcomes_size() != 1)
    return fmt::format("{} edge_outcomes for one edge", answer.edge_outcomes_size());
  const v1::EdgeOutcome& outcome = answer.edge_outcomes(0);
  const v1::OutcomeStatus expected = example.satisfied() ? v1::OUTCOME_STATUS_SATISFIED : v1::OUTCOME_STATUS_VIOLATED;
  if (outcome.edge_id() != "e1" || outcome.status() != expected) return outcome.ShortDebugString();
  if (!(outcome.cost() >= 0 && outcome.cost() < 1e300)) return fmt::format("a cost of {}", outcome.cost());
  const double weighted = kWeight * outcome.cost();
  if (!(std::abs(outcome.weighted_cost() - weighted) <= 1e-9 * (1 + weighted))) {
    return fmt::format("a weighted_cost of {} for a cost of {} and a weight of {}", outcome.weighted_cost(),
                       outcome.cost(), kWeight);
  }
  if (!example.satisfied() && outcome.reason().empty()) return "no reason why it is violated";
  return "";
}

Finding EvaluatesTo(Target& target, const v1::ConstraintType& type, int index) {
  const v1::PlacedExample& example = type.placed_examples(index);
  const std::string sent =
      fmt::format("Evaluate of {}.placed_examples[{}] with weight {}", type.name(), index, kWeight);
  const std::string right = fmt::format(
      "OUTCOME_STATUS_{} as the example says, a finite cost, its product with the weight, a reason when violated",
      example.satisfied() ? "SATISFIED" : "VIOLATED");
  const v1::EvaluateRequest request = RequestOf(type, example);
  if (const absl::Status status = Validate(request); !status.ok()) {
    return Broken(kAskedPlaced,
                  fmt::format("{}.placed_examples[{}]: {}", type.name(), index, std::string(status.message())),
                  "room, zone_plan, object_list and placements that make a valid problem");
  }
  return Given<v1::EvaluateResponse>(target, sent, request, [&](const v1::EvaluateResponse& answer) {
    const std::string fault = OutcomeFault(example, answer);
    return fault.empty() ? Kept() : Broken(sent, fault, right);
  });
}

Finding PlacedExamplesAreTrue(Target& target) {
  v1::ListConstraintTypesRequest request;
  request.set_with_placed_examples(true);
  return Given<v1::ListConstraintTypesResponse>(
      target, kAskedPlaced, request, [&](const v1::ListConstraintTypesResponse& answer) {
        for (const v1::ConstraintType& type : answer.catalog().types()) {
          for (int i = 0; i < type.placed_examples_size(); ++i) {
            const std::string fault = ArgumentsFault(type, type.placed_examples(i).arguments());
            if (!fault.empty()) {
              return Broken(kAskedPlaced, fmt::format("{}.placed_examples[{}]: {}", type.name(), i, fault),
                            "a call that fits the type's own parameters");
            }
            if (Finding finding = EvaluatesTo(target, type, i); finding.verdict != Verdict::kKept) return finding;
          }
        }
        return Kept();
      });
}

}  // namespace

void AddCatalogueChecks(Checks& checks) {
  const auto add = [&checks](std::string name, std::function<Finding(Target&)> run,
                             v1::Capability capability = v1::CAPABILITY_UNSPECIFIED) {
    checks.push_back({std::move(name), Promise::kCatalogue, std::move(run), capability});
  };
  add("The catalogue is valid: unique names, summaries, parameters", OfCatalog(false, IsValid));
  add("The catalogue is sorted by name", OfCatalog(false, IsSorted));
  add("Every type of the catalogue has a doc and a family", OfCatalog(false, IsDocumented));
  add("Every parameter has a doc, and a default in its range", OfCatalog(false, ParametersAreGood));
  add("Every type that translators call has an example sentence", OfCatalog(false, EveryTypeHasASentence));
  add("The calls of the examples fit their types", OfCatalog(false, ExamplesFitTheirTypes));
  add("Placed examples come only when they are asked for", OfCatalog(false, PlacedOnlyWhenAsked));
  add("Every type has a placed example that holds and one that does not", OfCatalog(true, BothVerdictsAreShown),
      v1::CAPABILITY_EVALUATE);
  add("Every placed example comes to its verdict", PlacedExamplesAreTrue, v1::CAPABILITY_EVALUATE);
}

}  // namespace flair::contract
