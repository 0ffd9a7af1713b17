// SPDX-License-Identifier: GPL-3.0-or-later
// What was found and what models used, in numbers and in words for people.
#pragma once

#include <string>

#include "flair/v1/artifact.pb.h"
#include "flair/v1/model_call.pb.h"

namespace flair::orchestrator {

// What was found, in one line for people: "3 zones: sleeping, storage, work".
std::string Summarize(const v1::Artifact& artifact);

// What models did for it: "3 calls of gpt-4o, 1 repair, 5012 tokens, 0.0213 USD"; empty when none was asked.
std::string SummarizeModels(const v1::Artifact& artifact);

// "5012 tokens, 0.0213 USD", "about 5012 tokens" where they were not counted; no price where there is none.
std::string SummarizeUsage(const v1::ModelUsage& usage);

// A step of a model call that asked for a better answer.
bool IsRepair(const v1::ModelCall& call);

// Adds what the calls behind an artifact consumed.
void AddUsage(const v1::Artifact& artifact, v1::ModelUsage& usage);

// The options of a request: those of the job with what is left of its budget, never below 0.
v1::ModelOptions OptionsLeft(const v1::ModelOptions& job_options, const v1::ModelUsage& spent);

}  // namespace flair::orchestrator
