// SPDX-License-Identifier: GPL-3.0-or-later
// What checks.textproto names and cannot say by paths: how calls fit a catalogue, how layouts are measured.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <set>

#include "cli/contract/script.h"
#include "evaluation/metrics/layout_metrics.h"
#include "flair/v1/optimizer_service.pb.h"
#include "flair/v1/orchestrator_service.pb.h"
#include "flair/v1/translator_service.pb.h"
#include "fmt/format.h"
#include "orchestrator/store/artifact_id.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::contract {
namespace {

using google::protobuf::Message;
using Arguments = google::protobuf::RepeatedPtrField<v1::Argument>;

template <typename As>
const As& To(const Message& message) {
  return *google::protobuf::DynamicCastToGenerated<As>(&message);
}

template <typename Part>
const Part& Field(const Message& message, std::string_view name) {
  return To<Part>(PartOf(message, name));
}

// The names that a text of one kind of parameter may have; nothing when every name will do.
struct Names {
  // Such as "a wall of the room".
  std::string what;
  std::vector<std::string> known;
};

template <typename List, typename NameOf>
Names NamesIn(const char* what, const List& list, NameOf name_of) {
  Names names{what, {}};
  for (const auto& item : list) names.known.push_back((item.*name_of)());
  return names;
}

// Without a graph ids are not looked up.
std::optional<Names> NamesOf(v1::ParameterKind kind, const v1::LayoutGraph* graph) {
  switch (kind) {
    case v1::PARAMETER_KIND_FEATURE: {
      if (graph == nullptr) return std::nullopt;
      Names names = NamesIn("a feature: door, window, socket or the id of a door or window", graph->room().openings(),
                            &v1::Opening::id);
      names.known.insert(names.known.end(), {"door", "window", "socket"});
      return names;
    }
    case v1::PARAMETER_KIND_SIDE:
    case v1::PARAMETER_KIND_SIDES:
      return Names{"a side: front, back, left or right", {"front", "back", "left", "right"}};
    case v1::PARAMETER_KIND_CORNER:
      return Names{"a corner, such as back_left", {"back_left", "back_right", "front_right", "front_left"}};
    default:
      break;
  }
  if (graph == nullptr) return std::nullopt;
  switch (kind) {
    case v1::PARAMETER_KIND_OBJECT:
    case v1::PARAMETER_KIND_OBJECTS:
      return NamesIn("an object of the room", graph->object_list().objects(), &v1::Object::id);
    case v1::PARAMETER_KIND_ZONE:
      return NamesIn("a zone of the room", graph->zone_plan().zones(), &v1::Zone::id);
    case v1::PARAMETER_KIND_WALL:
      return NamesIn("a wall of the room", graph->room().walls(), &v1::Wall::name);
    default:
      return std::nullopt;
  }
}

std::string TextFault(v1::ParameterKind kind, const std::string& text, const v1::LayoutGraph* graph) {
  if (text.empty()) return "is empty";
  const std::optional<Names> names = NamesOf(kind, graph);
  if (!names.has_value() || std::ranges::find(names->known, text) != names->known.end()) return "";
  return fmt::format("\"{}\" is not {}", text, names->what);
}

v1::ArgumentValue::ValueCase CaseOf(v1::ParameterKind kind) {
  switch (kind) {
    case v1::PARAMETER_KIND_OBJECTS:
    case v1::PARAMETER_KIND_SIDES:
      return v1::ArgumentValue::kTexts;
    case v1::PARAMETER_KIND_NUMBER:
      return v1::ArgumentValue::kNumber;
    case v1::PARAMETER_KIND_BOOLEAN:
      return v1::ArgumentValue::kFlag;
    default:
      return v1::ArgumentValue::kText;
  }
}

std::string ValueFault(const v1::ParameterSpec& parameter, const v1::ArgumentValue& value,
                       const v1::LayoutGraph* graph) {
  if (value.value_case() != CaseOf(parameter.kind())) {
    return fmt::format("holds another kind of value than {}", v1::ParameterKind_Name(parameter.kind()));
  }
  if (value.has_number()) {
    const double least = parameter.has_min_number() ? parameter.min_number() : -INFINITY;
    const double most = parameter.has_max_number() ? parameter.max_number() : INFINITY;
    const bool inside = (!parameter.has_min_number() || value.number() >= least) &&
                        (!parameter.has_max_number() || value.number() <= most);
    return inside ? "" : fmt::format("{} is outside [{}, {}]", value.number(), least, most);
  }
  if (value.has_texts() && value.texts().items().empty()) return "is empty";
  for (const std::string& item : value.texts().items()) {
    if (std::string fault = TextFault(parameter.kind(), item, graph); !fault.empty()) return fault;
  }
  return value.value_case() == v1::ArgumentValue::kText ? TextFault(parameter.kind(), value.text(), graph) : "";
}

// What is wrong with the arguments of a call of `type`: one that the type does not have, one that is missing, a value
// of another kind or out of range, an id that the graph does not have. Empty when nothing is.
std::string ArgumentsFault(const v1::ConstraintType& type, const Arguments& arguments,
                           const v1::LayoutGraph* graph = nullptr) {
  std::set<std::string> given;
  for (const v1::Argument& argument : arguments) {
    const auto parameter = std::ranges::find(type.parameters(), argument.name(), &v1::ParameterSpec::name);
    if (parameter == type.parameters().end()) {
      return fmt::format("\"{}\" is not a parameter of {}", argument.name(), type.name());
    }
    if (!given.insert(argument.name()).second) return fmt::format("\"{}\" is given twice", argument.name());
    const std::string fault = ValueFault(*parameter, argument.value(), graph);
    if (!fault.empty()) return fmt::format("{}.{}: {}", type.name(), argument.name(), fault);
  }
  for (const v1::ParameterSpec& parameter : type.parameters()) {
    if (parameter.required() && !given.contains(parameter.name())) {
      return fmt::format("{}.{} is required and missing", type.name(), parameter.name());
    }
  }
  return "";
}

std::string ParameterFault(const v1::ParameterSpec& parameter) {
  if (parameter.doc().empty()) return "has no doc";
  const bool numeric = parameter.kind() == v1::PARAMETER_KIND_NUMBER;
  if (!numeric && (parameter.has_min_number() || parameter.has_max_number() || !parameter.unit().empty())) {
    return "has a range or a unit, but is not a number";
  }
  if (numeric && parameter.unit() != "m" && parameter.unit() != "rad" && !parameter.unit().empty()) {
    return fmt::format("has the unit \"{}\"; it must be \"m\", \"rad\" or \"\"", parameter.unit());
  }
  if (!parameter.has_default_value()) return "";
  const std::string fault = ValueFault(parameter, parameter.default_value(), nullptr);
  return fault.empty() ? "" : "its default " + fault;
}

Finding ParametersFit(const Message&, const Message& answer) {
  for (const v1::ConstraintType& type : To<v1::ListConstraintTypesResponse>(answer).catalog().types()) {
    for (const v1::ParameterSpec& parameter : type.parameters()) {
      const std::string fault = ParameterFault(parameter);
      if (!fault.empty()) return Wrong(fmt::format("{}.{} {}", type.name(), parameter.name(), fault));
    }
  }
  return Kept();
}

Finding ExamplesFit(const Message&, const Message& answer) {
  for (const v1::ConstraintType& type : To<v1::ListConstraintTypesResponse>(answer).catalog().types()) {
    for (const auto& example : type.examples()) {
      const std::string fault = ArgumentsFault(type, example.arguments());
      if (!fault.empty()) return Wrong(fmt::format("{}.examples (\"{}\"): {}", type.name(), example.sentence(), fault));
    }
  }
  return Kept();
}

// The graph is valid, every sentence has an edge or a diagnostic, and edges are calls of the catalogue about things of
// the room.
std::string TranslationFault(const Message& asked, const Message& answer) {
  const auto& request = To<v1::TranslateRequest>(asked);
  const v1::LayoutGraph& graph = To<v1::TranslateResponse>(answer).layout_graph();
  if (const absl::Status status = Validate(graph); !status.ok()) return std::string(status.message());
  for (const v1::Sentence& sentence : request.constraint_list().sentences()) {
    const bool has_edge =
        std::ranges::find(graph.edges(), sentence.id(), &v1::ConstraintEdge::sentence_id) != graph.edges().end();
    const bool is_told =
        std::ranges::find(graph.diagnostics(), sentence.id(), &v1::Diagnostic::subject_id) != graph.diagnostics().end();
    if (has_edge || is_told) continue;
    return fmt::format("neither an edge nor a diagnostic for {} (\"{}\")", sentence.id(), sentence.text());
  }
  for (const v1::ConstraintEdge& edge : graph.edges()) {
    const auto type = std::ranges::find(request.catalog().types(), edge.type(), &v1::ConstraintType::name);
    if (type == request.catalog().types().end()) {
      return fmt::format("edge {}: \"{}\" is not in the catalogue", edge.id(), edge.type());
    }
    if (type->built_in()) return fmt::format("edge {}: {} is built in; nobody calls it", edge.id(), edge.type());
    const std::string fault = ArgumentsFault(*type, edge.arguments(), &graph);
    if (!fault.empty()) return fmt::format("edge {}: {}", edge.id(), fault);
  }
  return "";
}

// A bench that fits a corridor in one direction only. A server that measures otherwise puts it through the walls.
Finding FitsTheCorridor(const Message& asked, const Message& answer) {
  constexpr double kOutsidePercent = 1;
  v1::SolvedLayout layout = To<v1::SolveResponse>(answer).solved_layout();
  *layout.mutable_graph() = To<v1::SolveRequest>(asked).layout_graph();
  const absl::StatusOr<v1::LayoutMetrics> metrics = evaluation::MeasureLayout(layout);
  if (!metrics.ok()) return Wrong(std::string(metrics.status().message()));
  if (metrics->oob_percent() <= kOutsidePercent) return Kept();
  for (const v1::Diagnostic& diagnostic : layout.diagnostics()) {
    if (diagnostic.subject_id() == "bench" || diagnostic.message().find("bench") != std::string::npos) {
      return Skipped("a diagnostic says that the bench has no good place");
    }
  }
  const auto bench = std::ranges::find(layout.placements(), "bench", &v1::Placement::object_id);
  return Wrong(fmt::format("{{ {} }}, which is outside the room by {:.1f} % of its area",
                           bench == layout.placements().end() ? "no placement" : bench->ShortDebugString(),
                           metrics->oob_percent()));
}

// The nightstand stands where it stood, or is named as moved.
Finding SaysWhatMoved(const Message& asked, const Message& answer) {
  constexpr char kNightstand[] = "nightstand";
  const auto& resolved = To<v1::ResolveResponse>(answer);
  const auto placement = [&](const v1::SolvedLayout& layout) {
    const auto found = std::ranges::find(layout.placements(), kNightstand, &v1::Placement::object_id);
    return found == layout.placements().end() ? "" : found->SerializeAsString();
  };
  const std::string before = placement(To<v1::ResolveRequest>(asked).solved_layout());
  const std::string after = placement(resolved.solved_layout());
  if (before.empty() || after.empty()) return Wrong("no placement of the nightstand");
  const bool named = std::ranges::count(resolved.moved_object_ids(), kNightstand) > 0;
  if (named == (before != after)) return Kept();
  return Wrong(
      fmt::format("a nightstand that was {}moved, and moved_object_ids that say otherwise", named ? "not " : ""));
}

// Calls must come from what was sent, not from memory: a catalogue of the types that the first answer did not need.
Finding TranslateWithAnotherCatalogue(Run& run) {
  v1::TranslateRequest request;
  run.Fill("${translate}", request);
  ASSIGN_OR_RETURN(const auto first, run.target().Ask<v1::TranslateResponse>(request));
  auto& types = *request.mutable_catalog()->mutable_types();
  const auto is_called = [&](const v1::ConstraintType& type) {
    const auto& edges = first.layout_graph().edges();
    return std::ranges::find(edges, type.name(), &v1::ConstraintEdge::type) != edges.end();
  };
  types.erase(std::remove_if(types.begin(), types.end(), is_called), types.end());
  ASSIGN_OR_RETURN(const auto second, run.target().Ask<v1::TranslateResponse>(request));
  return WrongIf(TranslationFault(request, second));
}

// Weights scale weighted costs and nothing else.
constexpr double kWeight = 2;

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

Finding EvaluatePlacedExample(Run& run, const v1::ConstraintType& type, int index) {
  const v1::PlacedExample& example = type.placed_examples(index);
  const std::string where = fmt::format("{}.placed_examples[{}]", type.name(), index);
  std::string fault = ArgumentsFault(type, example.arguments());
  if (!fault.empty()) return Wrong(where + ": " + fault, "a call that fits the type's own parameters");
  const v1::EvaluateRequest request = RequestOf(type, example);
  if (const absl::Status status = Validate(request); !status.ok()) {
    return Wrong(fmt::format("{}: {}", where, std::string(status.message())),
                 "room, zone_plan, object_list and placements that make a valid problem");
  }
  const absl::StatusOr<v1::EvaluateResponse> answer = run.target().Ask<v1::EvaluateResponse>(request);
  fault = answer.ok() ? OutcomeFault(example, *answer) : StatusText(answer.status());
  return fault.empty() ? Kept() : Wrong(fault, "", fmt::format("Evaluate of {} with weight {}", where, kWeight));
}

Finding EvaluatePlacedExamples(Run& run) {
  v1::ListConstraintTypesRequest request;
  request.set_with_placed_examples(true);
  ASSIGN_OR_RETURN(const auto answer, run.target().Ask<v1::ListConstraintTypesResponse>(request));
  for (const v1::ConstraintType& type : answer.catalog().types()) {
    for (int i = 0; i < type.placed_examples_size(); ++i) {
      if (Finding finding = EvaluatePlacedExample(run, type, i); finding.verdict != Verdict::kKept) return finding;
    }
  }
  return Kept();
}

std::string ArtifactFault(const std::string& id, const v1::Artifact& artifact) {
  if (const absl::Status status = Validate(artifact); !status.ok()) return std::string(status.message());
  if (artifact.id() != id) return fmt::format("an artifact of id {}", artifact.id());
  const std::string digest = orchestrator::ComputeArtifactId(artifact);
  if (digest != id) return fmt::format("bytes whose digest is {}", digest);
  return artifact.producer().program().empty() && artifact.has_room() ? "a room without a producer" : "";
}

Finding GetTheArtifacts(Run& run) {
  for (const Value& id : run.kept("artifacts")) {
    v1::GetArtifactRequest request;
    request.set_artifact_id(id.text);
    const auto answer = run.target().Ask<v1::GetArtifactResponse>(request);
    const std::string fault = answer.ok() ? ArtifactFault(id.text, answer->artifact()) : StatusText(answer.status());
    if (!fault.empty()) return Wrong(fault, "", fmt::format("GetArtifact of the job's {}", id.text));
  }
  return Kept();
}

template <typename Function>
Function Named(std::initializer_list<std::pair<std::string_view, Function>> all, const std::string& name) {
  for (const auto& [known, function] : all) {
    if (known == name) return function;
  }
  std::abort();  // a name in our own file
}

}  // namespace

Judge JudgeNamed(const std::string& name) {
  return Named<Judge>(
      {{"translation",
        [](const Message& request, const Message& answer) { return WrongIf(TranslationFault(request, answer)); }},
       {"corridor", FitsTheCorridor},
       {"moved nightstand", SaysWhatMoved},
       {"parameters", ParametersFit},
       {"examples", ExamplesFit}},
      name);
}

Action ActionNamed(const std::string& name) {
  return Named<Action>({{"translate with another catalogue", TranslateWithAnotherCatalogue},
                        {"evaluate the placed examples", EvaluatePlacedExamples},
                        {"get the artifacts", GetTheArtifacts}},
                       name);
}

std::string ValidationFault(const Message& part, const Message& request) {
  const std::string& type = part.GetDescriptor()->name();
  const absl::Status status =
      type == "ObjectList"       ? Validate(To<v1::ObjectList>(part), Field<v1::ZonePlan>(request, "zone_plan"))
      : type == "StyleSheet"     ? Validate(To<v1::StyleSheet>(part), Field<v1::Room>(request, "room"),
                                            Field<v1::ObjectList>(request, "object_list"))
      : type == "ConstraintList" ? Validate(To<v1::ConstraintList>(part), Field<v1::ObjectList>(request, "object_list"))
                                 : Validate(part);
  return std::string(status.message());
}

}  // namespace flair::contract
