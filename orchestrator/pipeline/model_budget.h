// SPDX-License-Identifier: GPL-3.0-or-later
// What a job's stages may use of language models, and what they used.
#pragma once

#include "flair/v1/artifact.pb.h"
#include "flair/v1/model_call.pb.h"

namespace flair::orchestrator {

// Adds what the calls behind an artifact consumed.
void AddUsage(const v1::Artifact& artifact, v1::ModelUsage& usage);

// The options of a request: those of the job with what is left of its budget, never below 0.
v1::ModelOptions OptionsLeft(const v1::ModelOptions& job_options, const v1::ModelUsage& spent);

// The part of the options that decides results: all but the budget.
v1::ModelOptions DecidingOptions(const v1::ModelOptions& job_options);

}  // namespace flair::orchestrator
