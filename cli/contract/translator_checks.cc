// SPDX-License-Identifier: GPL-3.0-or-later
// Translator: every sentence becomes calls of the catalogue that was sent, or a diagnostic that says why not.
#include <google/protobuf/util/message_differencer.h>

#include <algorithm>

#include "cli/contract/ask.h"
#include "cli/contract/bedroom.h"
#include "cli/contract/call_fault.h"
#include "flair/v1/translator_service.pb.h"
#include "optimizer_worker/constraints/registry.h"
#include "room/validation/validate.h"

namespace flair::contract {
namespace {

constexpr char kAsked[] = "Translate of two sentences about a bedroom";
constexpr int kManySentences = 3000;

v1::TranslateRequest Bedroom() {
  const v1::LayoutGraph graph = BedroomGraph();
  v1::TranslateRequest request;
  *request.mutable_room() = graph.room();
  *request.mutable_zone_plan() = graph.zone_plan();
  *request.mutable_object_list() = graph.object_list();
  *request.mutable_constraint_list() = graph.constraint_list();
  *request.mutable_catalog() = optimizer::MakeCatalog();
  return request;
}

v1::Sentence& AddSentence(v1::TranslateRequest& request, const std::string& id, const std::string& text) {
  v1::Sentence& sentence = *request.mutable_constraint_list()->add_sentences();
  sentence.set_id(id);
  sentence.set_text(text);
  sentence.set_scope(v1::SENTENCE_SCOPE_INTRA);
  sentence.set_weight(1);
  return sentence;
}

const v1::ConstraintType* TypeNamed(const v1::ConstraintCatalog& catalog, const std::string& name) {
  const auto found = std::ranges::find(catalog.types(), name, &v1::ConstraintType::name);
  return found == catalog.types().end() ? nullptr : &*found;
}

// What is wrong with the edges; empty when all are calls of the catalogue about things of the room.
std::string EdgesFault(const v1::TranslateRequest& request, const v1::LayoutGraph& graph) {
  for (const v1::ConstraintEdge& edge : graph.edges()) {
    const v1::ConstraintType* const type = TypeNamed(request.catalog(), edge.type());
    if (type == nullptr) return fmt::format("edge {}: \"{}\" is not in the catalogue", edge.id(), edge.type());
    if (type->built_in()) return fmt::format("edge {}: {} is built in; nobody calls it", edge.id(), edge.type());
    const std::string fault = ArgumentsFault(*type, edge.arguments(), graph);
    if (!fault.empty()) return fmt::format("edge {}: {}", edge.id(), fault);
  }
  return "";
}

bool IsAccountedFor(const v1::Sentence& sentence, const v1::LayoutGraph& graph) {
  return std::ranges::any_of(graph.edges(), [&](const auto& edge) { return edge.sentence_id() == sentence.id(); }) ||
         std::ranges::any_of(graph.diagnostics(),
                             [&](const auto& diagnostic) { return diagnostic.subject_id() == sentence.id(); });
}

// What is wrong with a graph as an answer; empty when nothing is.
std::string GraphFault(const v1::TranslateRequest& request, const v1::LayoutGraph& graph) {
  if (const absl::Status status = Validate(graph); !status.ok()) return std::string(status.message());
  for (const v1::Sentence& sentence : request.constraint_list().sentences()) {
    if (!IsAccountedFor(sentence, graph)) {
      return fmt::format("neither an edge nor a diagnostic for {} (\"{}\")", sentence.id(), sentence.text());
    }
  }
  return EdgesFault(request, graph);
}

constexpr char kRightGraph[] =
    "for every sentence edges with its sentence_id, or a diagnostic with its id as subject_id; edges are calls of the "
    "catalogue about things of the room";

Finding AccountsFor(Target& target, const v1::TranslateRequest& request, const std::string& sent) {
  return Given<v1::TranslateResponse>(target, sent, request, [&](const v1::TranslateResponse& answer) {
    const std::string fault = GraphFault(request, answer.layout_graph());
    return fault.empty() ? Kept() : Broken(sent, fault, kRightGraph);
  });
}

Finding AccountsForSentences(Target& target) { return AccountsFor(target, Bedroom(), kAsked); }

Finding DoesNotGuess(Target& target) {
  v1::TranslateRequest request = Bedroom();
  AddSentence(request, "s3", "Colourless green ideas sleep furiously.");
  const std::string sent = "Translate of \"Colourless green ideas sleep furiously.\" (s3)";
  return Given<v1::TranslateResponse>(target, sent, request, [&](const v1::TranslateResponse& answer) {
    const std::string fault = GraphFault(request, answer.layout_graph());
    if (!fault.empty()) return Broken(sent, fault, kRightGraph);
    for (const v1::ConstraintEdge& edge : answer.layout_graph().edges()) {
      if (edge.sentence_id() == "s3") return Broken(sent, "a call of " + edge.type(), "a diagnostic and no call");
    }
    return Kept();
  });
}

// A catalogue of the types that the first answer did not need: calls must come from what was sent, not from memory.
Finding KeepsToTheCatalogue(Target& target) {
  v1::TranslateRequest request = Bedroom();
  return Given<v1::TranslateResponse>(target, kAsked, request, [&](const v1::TranslateResponse& answer) {
    const auto is_called = [&](const v1::ConstraintType& type) {
      return std::ranges::any_of(answer.layout_graph().edges(),
                                 [&](const auto& edge) { return edge.type() == type.name(); });
    };
    auto& types = *request.mutable_catalog()->mutable_types();
    types.erase(std::remove_if(types.begin(), types.end(), is_called), types.end());
    return AccountsFor(target, request, "Translate with a catalogue without the types of the first answer");
  });
}

Finding PassesOn(Target& target) {
  const v1::TranslateRequest request = Bedroom();
  return Given<v1::TranslateResponse>(target, kAsked, request, [&](const v1::TranslateResponse& answer) {
    const v1::LayoutGraph& graph = answer.layout_graph();
    using google::protobuf::util::MessageDifferencer;
    const std::string right = "room, zone_plan, object_list and constraint_list as sent, and the library's name";
    if (!MessageDifferencer::Equals(graph.room(), request.room())) return Broken(kAsked, "another room", right);
    if (!MessageDifferencer::Equals(graph.zone_plan(), request.zone_plan()))
      return Broken(kAsked, "other zones", right);
    if (!MessageDifferencer::Equals(graph.object_list(), request.object_list())) {
      return Broken(kAsked, "other objects", right);
    }
    if (graph.constraint_list().sentences_size() != request.constraint_list().sentences_size()) {
      return Broken(kAsked, fmt::format("{} sentences", graph.constraint_list().sentences_size()), right);
    }
    if (graph.catalog_library() == request.catalog().library()) return Kept();
    return Broken(kAsked, fmt::format("catalog_library \"{}\"", graph.catalog_library()), right);
  });
}

Finding NamesItsTranslator(Target& target) {
  return Given<v1::TranslateResponse>(target, kAsked, Bedroom(), [](const v1::TranslateResponse& answer) {
    if (!answer.producer().program().empty() && !answer.producer().method().empty()) return Kept();
    return Broken(kAsked, "a producer without program or method", "both set");
  });
}

Finding NeedsACatalogue(Target& target) {
  v1::TranslateRequest request = Bedroom();
  request.clear_catalog();
  const absl::Status status = target.Ask<v1::TranslateResponse>(request).status();
  if (status.ok() || absl::IsFailedPrecondition(status)) return Kept();
  return Broken("Translate without a catalogue", StatusText(status),
                "FAILED_PRECONDITION, or an answer by the catalogue of the optimizer that it is configured with");
}

void AddTranslatorRefusals(Checks& checks) {
  using Request = v1::TranslateRequest;
  AddRefusals<v1::TranslateResponse, Request>(
      Bedroom(),
      {{"a request without a room", "room", [](Request& request) { request.clear_room(); }},
       {"an object without an id", "objects[0].id",
        [](Request& request) { request.mutable_object_list()->mutable_objects(0)->set_id(""); }},
       {"two sentences of one id", "sentences[1].id",
        [](Request& request) { request.mutable_constraint_list()->mutable_sentences(1)->set_id("s1"); }},
       {"an empty sentence", "sentences[0].text",
        [](Request& request) { request.mutable_constraint_list()->mutable_sentences(0)->set_text(""); }},
       {"a sentence about an object that is not there", "sentences[0].subject_ids[0]",
        [](Request& request) { request.mutable_constraint_list()->mutable_sentences(0)->set_subject_ids(0, "ghost"); }},
       {"a sentence of a scope that is not set", "sentences[0].scope",
        [](Request& request) {
          request.mutable_constraint_list()->mutable_sentences(0)->set_scope(v1::SENTENCE_SCOPE_UNSPECIFIED);
        }},
       {"a catalogue with two types of one name", "types[1].name",
        [](Request& request) { *request.mutable_catalog()->mutable_types(1) = request.catalog().types(0); }},
       {"a catalogue without types", "catalog.types",
        [](Request& request) { request.mutable_catalog()->clear_types(); }}},
      checks);
}

}  // namespace

Sample TranslateSample() {
  const v1::TranslateRequest bedroom = Bedroom();
  v1::TranslateRequest long_request = bedroom;
  for (int i = 0; i < kManySentences; ++i) {
    AddSentence(long_request, fmt::format("more_{}", i), "The nightstand is next to the bed.")
        .add_subject_ids("nightstand");
  }
  return {.what = kAsked,
          .request = std::make_shared<v1::TranslateRequest>(bedroom),
          .fault =
              [bedroom](const std::string& bytes) {
                v1::TranslateResponse answer;
                if (!answer.ParseFromString(bytes)) return std::string("bytes that are no TranslateResponse");
                return GraphFault(bedroom, answer.layout_graph());
              },
          .core = [](const std::string& bytes) { return bytes; },
          .long_requests = {std::make_shared<v1::TranslateRequest>(long_request)}};
}

void AddTranslatorChecks(Checks& checks) {
  checks.push_back(
      {"Every sentence becomes calls of the catalogue or a diagnostic", Promise::kMessages, AccountsForSentences});
  checks.push_back({"A sentence that says nothing becomes no call", Promise::kMessages, DoesNotGuess});
  checks.push_back({"Calls are of the catalogue that was sent", Promise::kCatalogue, KeepsToTheCatalogue});
  checks.push_back({"Room, zones, objects and sentences are passed on", Promise::kMessages, PassesOn});
  checks.push_back({"The answer says who translated", Promise::kMessages, NamesItsTranslator});
  checks.push_back({"Without a catalogue the translator asks its optimizer, or says that it cannot", Promise::kErrors,
                    NeedsACatalogue});
  AddTranslatorRefusals(checks);
}

}  // namespace flair::contract
