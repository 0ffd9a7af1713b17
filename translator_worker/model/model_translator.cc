// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/model/model_translator.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "flair/model/v1/calls_answers.pb.h"
#include "flair/v1/worker_service.pb.h"
#include "fmt/format.h"
#include "llm/answers/conversation.h"
#include "llm/answers/read_answer.h"
#include "llm/config/check_llm_config.h"
#include "llm/make_llm_client.h"
#include "translator_worker/catalog/catalog_source.h"
#include "translator_worker/grammar/call.h"
#include "translator_worker/grammar/scene_names.h"
#include "translator_worker/grammar/translate.h"
#include "translator_worker/model/prompt_texts.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::translator {
namespace {

using model::v1::CallsAnswer;

// What one sentence became.
struct SentenceCalls {
  std::vector<Call> calls;
  // Why a part of it, or all of it, is in no call; as the model says.
  std::string refusal;
  // What was wrong with calls that were left out, and what was changed in others; sentences for people.
  std::vector<std::string> rejected;
  std::vector<std::string> adjusted;
};

// Adds the calls of one text; says what is wrong with others.
std::vector<std::string> AddCalls(const std::string& text, const llm::Choices& functions, const CatalogIndex& catalog,
                                  const ArgumentReader& reader, SentenceCalls& sentence) {
  const absl::StatusOr<WrittenCalls> written = ReadCallText(text);
  if (!written.ok()) return {std::string(written.status().message())};
  std::vector<std::string> problems;
  for (const WrittenCall& one : written->calls) {
    const std::optional<std::string> name = llm::FindChoice(one.function, functions);
    const v1::ConstraintType* type = name ? catalog.Find(*name) : nullptr;
    if (type == nullptr) {
      problems.push_back(fmt::format("{} is no function of the list", llm::Quoted(one.function)));
      continue;
    }
    absl::StatusOr<Call> call = BindCall(one, *type, reader, sentence.adjusted);
    if (call.ok()) {
      sentence.calls.push_back(*std::move(call));
    } else {
      problems.emplace_back(call.status().message());
    }
  }
  if (!written->why.empty()) sentence.refusal += (sentence.refusal.empty() ? "" : "; ") + written->why;
  return problems;
}

// The calls of a pass's answer that are of its functions and fit the catalogue, by sentence id. Says of every other one
// what is wrong, as faults to ask about, in `faults` when it is not null. Takes any answer.
std::map<std::string, SentenceCalls> ReadCalls(const model::v1::CallsAnswer& answer,
                                               const std::vector<const v1::Sentence*>& sentences,
                                               const llm::Choices& functions, const CatalogIndex& catalog,
                                               const ArgumentReader& reader, std::vector<llm::Fault>* faults) {
  std::map<std::string, SentenceCalls> result;
  for (const v1::Sentence* sentence : sentences) result[sentence->id()];
  for (int i = 0; i < answer.sentences_size(); ++i) {
    const model::v1::SentenceCallsAnswer& said = answer.sentences(i);
    const auto found = result.find(said.id());
    if (found == result.end()) continue;
    for (int k = 0; k < said.calls_size(); ++k) {
      for (std::string& problem : AddCalls(said.calls(k), functions, catalog, reader, found->second)) {
        if (faults != nullptr) {
          faults->push_back({fmt::format("sentences[{}].calls[{}]", i, k), problem, llm::FaultKind::kDoubtful});
        }
        found->second.rejected.push_back(std::move(problem));
      }
    }
  }
  return result;
}

// Appends an entry without calls for every sentence that has none, with a fault to ask about.
void AddMissing(const std::vector<const v1::Sentence*>& sentences, model::v1::CallsAnswer& answer,
                std::vector<llm::Fault>& faults) {
  std::set<std::string> there;
  for (const model::v1::SentenceCallsAnswer& said : answer.sentences()) there.insert(said.id());
  for (const v1::Sentence* sentence : sentences) {
    if (!there.insert(sentence->id()).second) continue;
    faults.push_back({fmt::format("sentences[{}]", answer.sentences_size()),
                      fmt::format("{} is missing; calls, or none(why), would be right", sentence->id()),
                      llm::FaultKind::kDoubtful});
    answer.add_sentences()->set_id(sentence->id());
  }
}

// So many sentences' calls fit into the shortest answers that servers cut off.
constexpr size_t kMostSentences = 60;

// Sentences that are asked about together.
struct Portion {
  const Pass* pass = nullptr;
  std::vector<const v1::Sentence*> sentences;
};

// Sentences that completion added are in the handbook's words, which the grammar knows: no model is asked about them.
bool IsImplied(const v1::Sentence& sentence) { return sentence.origin() == v1::SENTENCE_ORIGIN_IMPLIED; }

std::vector<Portion> Divide(const v1::ConstraintList& list) {
  std::vector<Portion> portions;
  for (const Pass& pass : kPasses) {
    std::vector<const v1::Sentence*> sentences;
    for (const v1::Sentence& sentence : list.sentences()) {
      if (sentence.scope() == pass.scope && !IsImplied(sentence)) sentences.push_back(&sentence);
    }
    for (size_t begin = 0; begin < sentences.size(); begin += kMostSentences) {
      const size_t end = std::min(begin + kMostSentences, sentences.size());
      portions.push_back({&pass,
                          {sentences.begin() + static_cast<std::ptrdiff_t>(begin),
                           sentences.begin() + static_cast<std::ptrdiff_t>(end)}});
    }
  }
  return portions;
}

// Translates the sentences of one request and collects the graph.
class Run {
 public:
  Run(const v1::TranslateRequest& request, const llm::PromptLibrary& prompts)
      : request_(request),
        prompts_(prompts),
        catalog_(request.catalog()),
        reader_(request),
        names_(request.room(), request.zone_plan(), request.object_list()),
        floor_names_(request.room(), request.zone_plan(), request.object_list(), NamedObjects::kFloorFirst) {
    for (const v1::Sentence& sentence : request.constraint_list().sentences()) {
      if (IsImplied(sentence)) ReadByGrammar(sentence);
    }
  }

  llm::Question Ask(const Portion& portion, size_t number) const {
    llm::Question question;
    question.step = std::string(portion.pass->step);
    if (number > 0) question.step += fmt::format(".{}", number + 1);
    question.system = prompts_.Fill("translator", {});
    question.text = Text(portion);
    llm::Choices& ids = question.choices["flair.model.v1.SentenceCallsAnswer.id"];
    for (const v1::Sentence* sentence : portion.sentences) {
      ids.names.push_back(sentence->id());
      // "1" and "sentence 1" for "s1".
      if (!sentence->id().starts_with('s')) continue;
      for (const char* const before : {"", "sentence "})
        ids.aliases[before + sentence->id().substr(1)] = sentence->id();
    }
    question.answer = &CallsAnswer::default_instance();
    question.check = llm::CheckOf<CallsAnswer>([this, &portion](CallsAnswer& answer) {
      std::vector<llm::Fault> faults;
      ReadCalls(answer, portion.sentences, FunctionsOf(portion), catalog_, reader_, &faults);
      AddMissing(portion.sentences, answer, faults);
      return faults;
    });
    return question;
  }

  void Take(const Portion& portion, const llm::Reply& reply) {
    const auto calls =
        ReadCalls(reply.As<CallsAnswer>(), portion.sentences, FunctionsOf(portion), catalog_, reader_, nullptr);
    for (const v1::Sentence* sentence : portion.sentences) Keep(*sentence, calls.at(sentence->id()));
    for (const llm::Fault& fault : reply.faults) {
      if (fault.kind != llm::FaultKind::kWrong) continue;
      v1::Diagnostic& remark = remarks_.emplace_back();
      remark.set_severity(v1::SEVERITY_WARNING);
      remark.set_code("answer_dropped");
      remark.set_message(fmt::format("a part of the model's answer was left out: {}", fault.Sentence()));
    }
  }

  // Without a model.
  void StandIn(const Portion& portion, const absl::Status& failure) {
    for (const v1::Sentence* sentence : portion.sentences) ReadByGrammar(*sentence);
    v1::Diagnostic& remark = remarks_.emplace_back();
    remark.set_severity(v1::SEVERITY_WARNING);
    remark.set_code("stand_in");
    const int64_t count = static_cast<int64_t>(portion.sentences.size());
    remark.set_message(fmt::format("{} {} read by the grammar, as the model failed: {}", Counted(count, "sentence"),
                                   Form(count, "was", "were"), std::string(failure.message())));
  }

  v1::LayoutGraph Graph() {
    v1::LayoutGraph graph = GraphOf(request_, std::move(kept_));
    for (v1::Diagnostic& remark : remarks_) *graph.add_diagnostics() = std::move(remark);
    return graph;
  }

 private:
  void ReadByGrammar(const v1::Sentence& sentence) {
    const SceneNames& names = sentence.scope() == v1::SENTENCE_SCOPE_TERTIARY ? names_ : floor_names_;
    kept_[sentence.id()] = TranslateSentence(request_, names, catalog_, sentence);
  }

  // The names by which the functions of a pass may be called.
  llm::Choices FunctionsOf(const Portion& portion) const {
    llm::Choices functions;
    for (const v1::ConstraintType* type : TypesFor(*portion.pass, request_)) {
      functions.names.push_back(type->name());
      for (const std::string& alias : type->aliases()) functions.aliases.emplace(alias, type->name());
    }
    return functions;
  }

  std::string Text(const Portion& portion) const {
    return prompts_.Fill("translation", {{"pass", std::string(portion.pass->task)},
                                         {"functions", FunctionsText(TypesFor(*portion.pass, request_))},
                                         {"room", RoomText(request_.room())},
                                         {"zones", ZonesText(request_.zone_plan())},
                                         {"objects", ObjectsText(request_.object_list(), portion.sentences)},
                                         {"sentences", SentencesText(portion.sentences)}});
  }

  void Keep(const v1::Sentence& sentence, const SentenceCalls& read) {
    Translation& kept = kept_[sentence.id()];
    kept.calls = read.calls;
    const auto remark = [&](v1::Severity severity, const char* code, const std::string& message) {
      kept.diagnostics.push_back(RemarkOn(sentence, severity, code, message));
    };
    for (const std::string& problem : read.rejected) {
      remark(v1::SEVERITY_WARNING, "call_rejected", "a call was left out: " + problem);
    }
    for (const std::string& change : read.adjusted) remark(v1::SEVERITY_NOTE, "out_of_range", change);
    if (!read.refusal.empty()) {
      remark(v1::SEVERITY_WARNING, read.calls.empty() ? "not_expressible" : "partial", read.refusal);
    } else if (read.calls.empty() && read.rejected.empty()) {
      remark(v1::SEVERITY_WARNING, "unknown_sentence", "the model gave no call for it, and no reason");
    }
  }

  const v1::TranslateRequest& request_;
  const llm::PromptLibrary& prompts_;
  const CatalogIndex catalog_;
  const ArgumentReader reader_;
  const SceneNames names_;
  const SceneNames floor_names_;
  std::map<std::string, Translation> kept_;
  std::vector<v1::Diagnostic> remarks_;
};

}  // namespace

absl::StatusOr<std::unique_ptr<ModelTranslator>> ModelTranslator::Make(std::unique_ptr<llm::LlmClient> client,
                                                                       const std::filesystem::path& prompts,
                                                                       const std::filesystem::path& overrides) {
  const std::vector<llm::PromptSpec> specs = {
      llm::RepairPrompt(),
      {.name = "translator", .placeholders = {}, .required = {}},
      {.name = "translation",
       .placeholders = {"pass", "functions", "room", "zones", "objects", "sentences"},
       .required = {"functions", "objects", "sentences"}}};
  ASSIGN_OR_RETURN(llm::PromptLibrary library, llm::PromptLibrary::Load(prompts, overrides, specs));
  return std::unique_ptr<ModelTranslator>(new ModelTranslator(std::move(client), std::move(library)));
}

absl::StatusOr<v1::TranslateResponse> ModelTranslator::Translate(const v1::TranslateRequest& request,
                                                                 runtime::CallContext& call) const {
  Run run(request, prompts_);
  const std::vector<Portion> portions = Divide(request.constraint_list());
  std::vector<llm::Question> questions;
  std::map<const Pass*, size_t> asked;
  for (const Portion& portion : portions) questions.push_back(run.Ask(portion, asked[portion.pass]++));
  llm::Conversation conversation(*client_, prompts_, request.model_options(), call);
  const std::vector<absl::StatusOr<llm::Reply>> replies = conversation.AskAll(questions);
  for (size_t i = 0; i < portions.size(); ++i) {
    if (replies[i].ok()) {
      run.Take(portions[i], *replies[i]);
    } else if (conversation.MayStandIn(replies[i].status())) {
      run.StandIn(portions[i], replies[i].status());
    } else {
      return replies[i].status();
    }
  }
  v1::TranslateResponse response;
  *response.mutable_layout_graph() = run.Graph();
  for (const v1::ModelCall& one : conversation.calls()) *response.add_model_calls() = one;
  return response;
}

std::filesystem::path DefaultPromptFolder() {
  return runtime::InstalledFolder("prompts/translator", FLAIR_TRANSLATOR_PROMPTS);
}

absl::StatusOr<std::unique_ptr<const Translator>> MakeModelTranslator(const config::v1::TranslatorWorkerConfig& config,
                                                                      runtime::WorkerContext& worker) {
  // A recording answers the same every time.
  if (!config.llm().replay_path().empty()) worker.capabilities = {v1::CAPABILITY_DETERMINISTIC};
  ASSIGN_OR_RETURN(std::unique_ptr<llm::LlmClient> client, llm::MakeLlmClient(config.llm(), worker));
  return ModelTranslator::Make(std::move(client), DefaultPromptFolder(), config.llm().prompts_path());
}

void CheckTranslatorConfig(const config::v1::TranslatorWorkerConfig& config, runtime::ConfigChecker& checker) {
  if (!config.has_llm()) return;
  llm::CheckLlmConfig(config.llm(), [&checker](std::string_view field, std::string_view problem) {
    checker.Report(fmt::format("llm.{}", field), problem);
  });
}

}  // namespace flair::translator
