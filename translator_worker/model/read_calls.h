// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/model/v1/calls_answers.pb.h"
#include "flair/v1/constraint_list.pb.h"
#include "llm/answers/fault.h"
#include "llm/answers/field_facts.h"
#include "translator_worker/catalog/catalog_index.h"
#include "translator_worker/grammar/call.h"
#include "translator_worker/model/bind_call.h"

namespace flair::translator {

// What one sentence became.
struct SentenceCalls {
  std::vector<Call> calls;
  // Why a part of it, or all of it, is in no call; as the model says.
  std::string refusal;
  // What was wrong with calls that were left out, and what was changed in others; sentences for people.
  std::vector<std::string> rejected;
  std::vector<std::string> adjusted;
};

// The calls of a pass's answer that are of its functions and fit the catalogue, by sentence id. Says of every other one
// what is wrong, as faults to ask about, in `faults` when it is not null. Takes any answer.
std::map<std::string, SentenceCalls> ReadCalls(const model::v1::CallsAnswer& answer,
                                               const std::vector<const v1::Sentence*>& sentences,
                                               const llm::Choices& functions, const CatalogIndex& catalog,
                                               const ArgumentReader& reader, std::vector<llm::Fault>* faults);

// Appends an entry without calls for every sentence that has none, with a fault to ask about.
void AddMissing(const std::vector<const v1::Sentence*>& sentences, model::v1::CallsAnswer& answer,
                std::vector<llm::Fault>& faults);

}  // namespace flair::translator
