// SPDX-License-Identifier: GPL-3.0-or-later
// Translator: every sentence becomes calls of the catalogue that was sent, or a diagnostic that says why not.
#include <google/protobuf/util/message_differencer.h>

#include <algorithm>

#include "cli/contract/bedroom.h"
#include "cli/contract/call_fault.h"
#include "cli/contract/stage_checks.h"
#include "fmt/format.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::contract {
namespace {

using google::protobuf::util::MessageDifferencer;

constexpr char kAsked[] = "Translate of two sentences about a bedroom";
constexpr char kNonsense[] = "Colourless green ideas sleep furiously.";
constexpr int kManySentences = 3000;

v1::Sentence& AddSentence(v1::TranslateRequest& request, const std::string& id, const std::string& text) {
  v1::Sentence& sentence = *request.mutable_constraint_list()->add_sentences();
  sentence.set_id(id);
  sentence.set_text(text);
  sentence.set_scope(v1::SENTENCE_SCOPE_INTRA);
  sentence.set_weight(1);
  return sentence;
}

// What is wrong with the edges; empty when all are calls of the catalogue about things of the room.
std::string EdgesFault(const v1::TranslateRequest& request, const v1::LayoutGraph& graph) {
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

bool HasEdge(const v1::LayoutGraph& graph, const std::string& sentence_id) {
  return std::ranges::find(graph.edges(), sentence_id, &v1::ConstraintEdge::sentence_id) != graph.edges().end();
}

bool HasDiagnostic(const v1::LayoutGraph& graph, const std::string& sentence_id) {
  return std::ranges::find(graph.diagnostics(), sentence_id, &v1::Diagnostic::subject_id) != graph.diagnostics().end();
}

// What is wrong with a graph as an answer; empty when nothing is.
std::string GraphFault(const v1::TranslateRequest& request, const v1::LayoutGraph& graph) {
  if (const absl::Status status = Validate(graph); !status.ok()) return std::string(status.message());
  for (const v1::Sentence& sentence : request.constraint_list().sentences()) {
    if (HasEdge(graph, sentence.id()) || HasDiagnostic(graph, sentence.id())) continue;
    return fmt::format("neither an edge nor a diagnostic for {} (\"{}\")", sentence.id(), sentence.text());
  }
  return EdgesFault(request, graph);
}

std::string BedroomFault(const v1::TranslateResponse& answer) {
  return GraphFault(BedroomTranslate(), answer.layout_graph());
}

Finding DoesNotGuess(Target& target) {
  v1::TranslateRequest request = BedroomTranslate();
  AddSentence(request, "s3", kNonsense);
  ASSIGN_OR_RETURN(const v1::TranslateResponse answer, target.Ask<v1::TranslateResponse>(request));
  const std::string fault = GraphFault(request, answer.layout_graph());
  if (!fault.empty()) return Wrong(fault);
  return HasEdge(answer.layout_graph(), "s3") ? Wrong("a call for s3") : Kept();
}

// A catalogue of the types that the first answer did not need: calls must come from what was sent, not from memory.
Finding KeepsToTheCatalogue(Target& target) {
  v1::TranslateRequest request = BedroomTranslate();
  ASSIGN_OR_RETURN(const v1::TranslateResponse first, target.Ask<v1::TranslateResponse>(request));
  const auto is_called = [&](const v1::ConstraintType& type) {
    const auto& edges = first.layout_graph().edges();
    return std::ranges::find(edges, type.name(), &v1::ConstraintEdge::type) != edges.end();
  };
  auto& types = *request.mutable_catalog()->mutable_types();
  types.erase(std::remove_if(types.begin(), types.end(), is_called), types.end());
  ASSIGN_OR_RETURN(const v1::TranslateResponse second, target.Ask<v1::TranslateResponse>(request));
  return WrongIf(GraphFault(request, second.layout_graph()));
}

Finding PassesOn(const v1::TranslateResponse& answer) {
  const v1::TranslateRequest request = BedroomTranslate();
  const v1::LayoutGraph& graph = answer.layout_graph();
  if (!MessageDifferencer::Equals(graph.room(), request.room())) return Wrong("another room");
  if (!MessageDifferencer::Equals(graph.zone_plan(), request.zone_plan())) return Wrong("other zones");
  if (!MessageDifferencer::Equals(graph.object_list(), request.object_list())) return Wrong("other objects");
  if (graph.constraint_list().sentences_size() != request.constraint_list().sentences_size()) {
    return Wrong(fmt::format("{} sentences", graph.constraint_list().sentences_size()));
  }
  if (graph.catalog_library() == request.catalog().library()) return Kept();
  return Wrong(fmt::format("catalog_library \"{}\"", graph.catalog_library()));
}

Finding NeedsACatalogue(Target& target) {
  v1::TranslateRequest request = BedroomTranslate();
  request.clear_catalog();
  const absl::Status status = target.AskForBytes(request).status();
  return absl::IsFailedPrecondition(status) ? Kept() : Finding(status);
}

}  // namespace

Sample TranslateSample() {
  auto many = std::make_shared<v1::TranslateRequest>(BedroomTranslate());
  for (int i = 0; i < kManySentences; ++i) {
    AddSentence(*many, fmt::format("more_{}", i), "The nightstand is next to the bed.").add_subject_ids("nightstand");
  }
  return {.what = kAsked,
          .request = std::make_shared<v1::TranslateRequest>(BedroomTranslate()),
          .fault = FaultOf<v1::TranslateResponse>(BedroomFault),
          .core = [](const std::string& bytes) { return bytes; },
          .long_requests = {many}};
}

Checks TranslatorChecks() {
  using Response = v1::TranslateResponse;
  const std::string right =
      "for every sentence edges with its sentence_id, or a diagnostic with its id as subject_id; edges are calls of "
      "the "
      "catalogue about things of the room";
  return {
      {"Every sentence becomes calls of the catalogue or a diagnostic", Promise::kMessages, kAsked, right,
       Answered<Response>(BedroomTranslate(), [](const Response& answer) { return WrongIf(BedroomFault(answer)); })},
      {"A sentence that says nothing becomes no call", Promise::kMessages,
       fmt::format("Translate of \"{}\" (s3)", kNonsense), "a diagnostic with the subject_id s3, and no call for it",
       DoesNotGuess},
      {"Calls are of the catalogue that was sent", Promise::kCatalogue,
       "Translate with a catalogue without the types of the first answer", right, KeepsToTheCatalogue},
      {"Room, zones, objects and sentences are passed on", Promise::kMessages, kAsked,
       "room, zone_plan, object_list and constraint_list as sent, and the library's name",
       Answered<Response>(BedroomTranslate(), PassesOn)},
      {"The answer says who translated", Promise::kMessages, kAsked, "a producer whose program and method are set",
       Answered<Response>(BedroomTranslate(),
                          [](const Response& answer) { return WrongIf(ProducerFault(answer.producer())); })},
      {"Without a catalogue the translator asks its optimizer, or says that it cannot", Promise::kErrors,
       "Translate without a catalogue",
       "FAILED_PRECONDITION, or an answer by the catalogue of the optimizer that it is configured with",
       NeedsACatalogue},
  };
}

}  // namespace flair::contract
