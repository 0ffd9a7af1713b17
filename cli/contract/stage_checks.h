// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of checks, which check.h puts together by stage, and what they are made with.
#pragma once

#include <google/protobuf/message.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cli/contract/check.h"
#include "cli/contract/target.h"

namespace flair::contract {

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

// For Sample::fault: reads the bytes and lets `judge` say what is wrong with the answer.
template <typename Response>
std::function<std::string(const std::string&)> FaultOf(std::function<std::string(const Response&)> judge) {
  return [judge = std::move(judge)](const std::string& bytes) {
    Response answer;
    return answer.ParseFromString(bytes) ? judge(answer) : "bytes that are no " + Response::descriptor()->name();
  };
}

// For Check::run: asks, and lets `judge` say how the answer is. Broken when there is none.
template <typename Response, typename Request>
std::function<Finding(Target&)> Answered(Request request, std::function<Finding(const Response&)> judge) {
  return [request = std::move(request), judge = std::move(judge)](Target& target) -> Finding {
    const absl::StatusOr<Response> answer = target.Ask<Response>(request);
    return answer.ok() ? judge(*answer) : Finding(answer.status());
  };
}

// Kept when a call was refused in this way.
inline Finding RefusedAs(absl::StatusCode code, const absl::Status& status) {
  if (status.code() == code) return Kept();
  return Wrong(StatusText(status), absl::StatusCodeToString(code));
}

// "" or what is missing in what an answer says of its maker.
std::string ProducerFault(const v1::Producer& producer);

// The same of all stages.
Checks ServerChecks(const Sample& sample);
Checks CallerChecks(const Sample& sample);

Checks LanguageChecks();
Checks TranslatorChecks();
Checks SolveChecks();
// Of optimizers that claim more than Solve.
Checks OptionalSolveChecks();
Checks CatalogueChecks();
Checks RendererChecks();
Checks JobChecks();
Checks BatchChecks();

Sample LanguageSample();
Sample TranslateSample();
Sample SolveSample();
Sample RenderSample();
Sample OrchestratorSample();

// Bad requests, each of which must be refused with an error that names the field.
Checks LanguageRefusals();
Checks TranslatorRefusals();
Checks OptimizerRefusals();
Checks RendererRefusals();
// And ids that are not there.
Checks OrchestratorRefusals();

}  // namespace flair::contract
