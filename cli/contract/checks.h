// SPDX-License-Identifier: GPL-3.0-or-later
// The checks by file; suite.h puts them together.
#pragma once

#include <google/protobuf/message.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cli/contract/check.h"
#include "cli/contract/target.h"

namespace flair::contract {

using Checks = std::vector<Check>;

// A request that every server of a stage must answer, for checks that are the same for all stages.
struct Sample {
  // What it asks, such as "Solve of a small bedroom".
  std::string what;
  std::shared_ptr<const google::protobuf::Message> request;
  // What is wrong with the answer's bytes; empty when nothing is.
  std::function<std::string(const std::string& bytes)> fault;
  // The part of good bytes that must be equal for equal requests of a server that claims DETERMINISTIC; unset when the
  // answer changes by itself.
  std::function<std::string(const std::string& bytes)> core;
  // Requests that keep a server busy for long, to be given up.
  std::vector<std::shared_ptr<const google::protobuf::Message>> long_requests;
};

// Of the same form for every stage.
void AddServerChecks(const Sample& sample, Checks& checks);
void AddCallerChecks(const Sample& sample, Checks& checks);

void AddSolveChecks(Checks& checks);
void AddUnitChecks(Checks& checks);
void AddSolveRefusals(Checks& checks);
void AddCatalogueChecks(Checks& checks);
void AddEvaluateChecks(Checks& checks);
void AddResolveChecks(Checks& checks);
void AddRestartChecks(Checks& checks);
Sample SolveSample();

void AddLanguageChecks(Checks& checks);
Sample LanguageSample();

void AddTranslatorChecks(Checks& checks);
Sample TranslateSample();

void AddRenderChecks(Checks& checks);
void AddViewChecks(Checks& checks);
void AddContactSheetChecks(Checks& checks);
Sample RenderSample();

void AddOrchestratorChecks(Checks& checks);
void AddBatchChecks(Checks& checks);
void AddOrchestratorRefusals(Checks& checks);
Sample OrchestratorSample();

}  // namespace flair::contract
