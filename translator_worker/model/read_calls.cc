// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/model/read_calls.h"

#include <utility>

#include "fmt/format.h"

namespace flair::translator {
namespace {

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

}  // namespace

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

}  // namespace flair::translator
