// SPDX-License-Identifier: GPL-3.0-or-later
// Optimizer: the catalogue, which translators read and nobody else need know, is complete and true.
#include <algorithm>
#include <cmath>

#include "cli/contract/call_fault.h"
#include "cli/contract/stage_checks.h"
#include "flair/v1/optimizer_service.pb.h"
#include "fmt/format.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::contract {
namespace {

// Weights scale weighted costs and nothing else.
constexpr double kWeight = 2;

v1::ListConstraintTypesRequest Request(bool with_placed_examples) {
  v1::ListConstraintTypesRequest request;
  request.set_with_placed_examples(with_placed_examples);
  return request;
}

std::string OrderFault(const v1::ConstraintCatalog& catalog) {
  for (int i = 1; i < catalog.types_size(); ++i) {
    if (catalog.types(i - 1).name() < catalog.types(i).name()) continue;
    return fmt::format("\"{}\" before \"{}\"", catalog.types(i - 1).name(), catalog.types(i).name());
  }
  return "";
}

// What is wrong with one type; empty when nothing is.
using TypeFault = std::string (*)(const v1::ConstraintType&);

std::string DocFault(const v1::ConstraintType& type) {
  if (type.doc().empty()) return fmt::format("\"{}\" has no doc", type.name());
  return type.family().empty() ? fmt::format("\"{}\" has no family", type.name()) : "";
}

std::string ParametersFault(const v1::ConstraintType& type) {
  for (const v1::ParameterSpec& parameter : type.parameters()) {
    const std::string fault = ParameterFault(parameter);
    if (!fault.empty()) return fmt::format("{}.{} {}", type.name(), parameter.name(), fault);
  }
  return "";
}

std::string SentenceFault(const v1::ConstraintType& type) {
  const bool needs_one = !type.built_in() && type.examples().empty();
  return needs_one ? fmt::format("\"{}\" has no examples", type.name()) : "";
}

std::string ExamplesFault(const v1::ConstraintType& type) {
  for (int i = 0; i < type.examples_size(); ++i) {
    const std::string fault = ArgumentsFault(type, type.examples(i).arguments());
    if (!fault.empty()) {
      return fmt::format("{}.examples[{}] (\"{}\"): {}", type.name(), i, type.examples(i).sentence(), fault);
    }
  }
  return "";
}

std::string UnaskedFault(const v1::ConstraintType& type) {
  if (type.placed_examples().empty()) return "";
  return fmt::format("{} placed examples of \"{}\"", type.placed_examples_size(), type.name());
}

std::string VerdictsFault(const v1::ConstraintType& type) {
  const bool holds = std::ranges::any_of(type.placed_examples(), &v1::PlacedExample::satisfied);
  const bool fails = !std::ranges::all_of(type.placed_examples(), &v1::PlacedExample::satisfied);
  if (type.built_in() || (holds && fails)) return "";
  return fmt::format("\"{}\" has {} placed examples, none that {}", type.name(), type.placed_examples_size(),
                     holds ? "does not hold" : "holds");
}

// Asks for the catalogue and looks at type after type.
std::function<Finding(Target&)> EveryType(TypeFault fault_of, bool with_placed_examples = false) {
  return Answered<v1::ListConstraintTypesResponse>(Request(with_placed_examples),
                                                   [fault_of](const v1::ListConstraintTypesResponse& answer) {
                                                     for (const v1::ConstraintType& type : answer.catalog().types()) {
                                                       if (const std::string fault = fault_of(type); !fault.empty())
                                                         return Wrong(fault);
                                                     }
                                                     return Kept();
                                                   });
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
  if (answer.edge_outcomes_size() != 1) {
    return fmt::format("{} edge_outcomes for one edge", answer.edge_outcomes_size());
  }
  const v1::EdgeOutcome& outcome = answer.edge_outcomes(0);
  const v1::OutcomeStatus expected = example.satisfied() ? v1::OUTCOME_STATUS_SATISFIED : v1::OUTCOME_STATUS_VIOLATED;
  if (outcome.edge_id() != "e1" || outcome.status() != expected) return outcome.ShortDebugString();
  if (!(outcome.cost() >= 0 && outcome.cost() < 1e300)) return fmt::format("a cost of {}", outcome.cost());
  const double weighted = kWeight * outcome.cost();
  if (!(std::abs(outcome.weighted_cost() - weighted) <= 1e-9 * (1 + weighted))) {
    return fmt::format("a weighted_cost of {} for a cost of {} and a weight of {}", outcome.weighted_cost(),
                       outcome.cost(), kWeight);
  }
  return !example.satisfied() && outcome.reason().empty() ? "no reason why it is violated" : "";
}

Finding ExampleIsTrue(Target& target, const v1::ConstraintType& type, int index) {
  const v1::PlacedExample& example = type.placed_examples(index);
  const std::string where = fmt::format("{}.placed_examples[{}]", type.name(), index);
  std::string fault = ArgumentsFault(type, example.arguments());
  if (!fault.empty()) return Wrong(where + ": " + fault, "a call that fits the type's own parameters");
  const v1::EvaluateRequest request = RequestOf(type, example);
  if (const absl::Status status = Validate(request); !status.ok()) {
    return Wrong(fmt::format("{}: {}", where, std::string(status.message())),
                 "room, zone_plan, object_list and placements that make a valid problem");
  }
  const std::string sent = fmt::format("Evaluate of {} with weight {}", where, kWeight);
  const absl::StatusOr<v1::EvaluateResponse> answer = target.Ask<v1::EvaluateResponse>(request);
  fault = answer.ok() ? OutcomeFault(example, *answer) : StatusText(answer.status());
  return fault.empty() ? Kept() : Wrong(fault, "", sent);
}

Finding PlacedExamplesAreTrue(Target& target) {
  ASSIGN_OR_RETURN(const auto answer, target.Ask<v1::ListConstraintTypesResponse>(Request(true)));
  for (const v1::ConstraintType& type : answer.catalog().types()) {
    for (int i = 0; i < type.placed_examples_size(); ++i) {
      if (Finding finding = ExampleIsTrue(target, type, i); finding.verdict != Verdict::kKept) return finding;
    }
  }
  return Kept();
}

}  // namespace

Checks CatalogueChecks() {
  const std::string asked = "ListConstraintTypes";
  const std::string asked_placed = "ListConstraintTypes with_placed_examples";
  using Response = v1::ListConstraintTypesResponse;
  return {
      {"The catalogue is valid: unique names, summaries, parameters", Promise::kCatalogue, asked,
       "a library's name, and types with unique names, a summary and good parameters",
       Answered<Response>(
           Request(false),
           [](const Response& answer) { return WrongIf(std::string(Validate(answer.catalog()).message())); })},
      {"The catalogue is sorted by name", Promise::kCatalogue, asked, "types sorted by name",
       Answered<Response>(Request(false),
                          [](const Response& answer) { return WrongIf(OrderFault(answer.catalog())); })},
      {"Every type of the catalogue has a doc and a family", Promise::kCatalogue, asked,
       "a doc (formula, symbols, unit of the cost) and a family for every type", EveryType(DocFault)},
      {"Every parameter has a doc, and a default in its range", Promise::kCatalogue, asked,
       "a doc for every parameter; range, unit and default that belong to its kind", EveryType(ParametersFault)},
      {"Every type that translators call has an example sentence", Promise::kCatalogue, asked,
       "an example sentence with its call for every type, as translators learn from them", EveryType(SentenceFault)},
      {"The calls of the examples fit their types", Promise::kCatalogue, asked,
       "a call that fits the type's own parameters", EveryType(ExamplesFault)},
      {"Placed examples come only when they are asked for", Promise::kCatalogue, asked,
       "none, as with_placed_examples is not set: they are for checks, and many times the rest",
       EveryType(UnaskedFault)},
      {"Every type has a placed example that holds and one that does not", Promise::kCatalogue, asked_placed,
       "a placed example that holds and one that does not for every type", EveryType(VerdictsFault, true),
       v1::CAPABILITY_EVALUATE},
      {"Every placed example comes to its verdict", Promise::kCatalogue, asked_placed,
       "the verdict that the example says, a finite cost, its product with the weight, a reason when violated",
       PlacedExamplesAreTrue, v1::CAPABILITY_EVALUATE},
  };
}

}  // namespace flair::contract
