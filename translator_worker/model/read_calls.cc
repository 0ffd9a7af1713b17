// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/model/read_calls.h"

#include <algorithm>
#include <set>
#include <utility>

#include "fmt/format.h"

namespace flair::translator {
namespace {

const v1::ParameterSpec* FindParameter(const v1::ConstraintType& type, const std::string& name) {
  for (const v1::ParameterSpec& parameter : type.parameters()) {
    if (llm::Bare(parameter.name()) == llm::Bare(name)) return &parameter;
  }
  return nullptr;
}

std::string ParameterNames(const v1::ConstraintType& type) {
  std::vector<std::string> names;
  for (const v1::ParameterSpec& parameter : type.parameters()) names.push_back(parameter.name());
  return fmt::format("{}", fmt::join(names, ", "));
}

// The objects that a call is about, in any of its arguments.
std::vector<std::string> ObjectsOf(const v1::ConstraintType& type, const Call& call) {
  std::vector<std::string> ids;
  for (const v1::Argument& argument : call.arguments) {
    const v1::ParameterSpec* parameter = FindParameter(type, argument.name());
    if (parameter == nullptr) continue;
    if (parameter->kind() == v1::PARAMETER_KIND_OBJECT) ids.push_back(argument.value().text());
    if (parameter->kind() != v1::PARAMETER_KIND_OBJECTS) continue;
    ids.insert(ids.end(), argument.value().texts().items().begin(), argument.value().texts().items().end());
  }
  return ids;
}

absl::StatusOr<Call> ReadCall(const model::v1::CallAnswer& answer, const CatalogIndex& catalog,
                              const ArgumentReader& reader, std::vector<std::string>& remarks) {
  const v1::ConstraintType* type = catalog.Find(answer.function());
  if (type == nullptr) {
    return absl::InvalidArgumentError(fmt::format("{} is no function of the list", llm::Quoted(answer.function())));
  }
  Call call(type->name());
  for (const model::v1::CallArgumentAnswer& given : answer.arguments()) {
    const v1::ParameterSpec* parameter = FindParameter(*type, given.name());
    if (parameter == nullptr) {
      return absl::InvalidArgumentError(fmt::format("{} has no parameter {}; it has {}", type->name(),
                                                    llm::Quoted(given.name()), ParameterNames(*type)));
    }
    const std::vector<std::string> values(given.values().begin(), given.values().end());
    absl::StatusOr<v1::ArgumentValue> value = reader.Read(*parameter, values);
    if (!value.ok()) {
      return absl::InvalidArgumentError(
          fmt::format("{}.{}: {}", type->name(), parameter->name(), std::string(value.status().message())));
    }
    v1::Argument& argument = call.arguments.emplace_back();
    argument.set_name(parameter->name());
    *argument.mutable_value() = *std::move(value);
  }
  if (absl::Status status = CatalogIndex::Fit(*type, call.arguments, remarks); !status.ok()) return status;
  std::vector<std::string> objects = ObjectsOf(*type, call);
  std::sort(objects.begin(), objects.end());
  const auto twice = std::adjacent_find(objects.begin(), objects.end());
  if (twice != objects.end()) {
    return absl::InvalidArgumentError(fmt::format("{} relates \"{}\" to itself", type->name(), *twice));
  }
  return call;
}

}  // namespace

std::map<std::string, SentenceCalls> ReadCalls(const model::v1::CallsAnswer& answer,
                                               const std::vector<const v1::Sentence*>& sentences,
                                               const CatalogIndex& catalog, const ArgumentReader& reader,
                                               std::vector<llm::Fault>* faults) {
  std::map<std::string, SentenceCalls> result;
  for (const v1::Sentence* sentence : sentences) result[sentence->id()];
  const auto doubt = [faults](const std::string& path, const std::string& text) {
    if (faults != nullptr) faults->push_back({path, text, llm::FaultKind::kDoubtful});
  };
  for (int i = 0; i < answer.sentences_size(); ++i) {
    const model::v1::SentenceCallsAnswer& said = answer.sentences(i);
    const auto found = result.find(said.id());
    if (found == result.end()) continue;
    SentenceCalls& sentence = found->second;
    sentence.answered = true;
    if (!said.refusal().empty()) sentence.refusal = said.refusal();
    for (int k = 0; k < said.calls_size(); ++k) {
      absl::StatusOr<Call> call = ReadCall(said.calls(k), catalog, reader, sentence.adjusted);
      if (call.ok()) {
        sentence.calls.push_back(*std::move(call));
        continue;
      }
      const std::string problem(call.status().message());
      sentence.rejected.push_back(problem);
      doubt(fmt::format("sentences[{}].calls[{}]", i, k), problem);
    }
  }
  std::vector<std::string> missing;
  for (const v1::Sentence* sentence : sentences) {
    if (!result[sentence->id()].answered) missing.push_back(sentence->id());
  }
  if (!missing.empty()) {
    doubt("sentences", fmt::format("has no entry for {}; every sentence needs one", fmt::join(missing, ", ")));
  }
  return result;
}

}  // namespace flair::translator
