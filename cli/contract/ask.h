// SPDX-License-Identifier: GPL-3.0-or-later
// The steps that most checks consist of: ask, judge the answer, tell what was wrong.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "cli/contract/checks.h"
#include "fmt/format.h"

namespace flair::contract {

// Asks, and lets `judge` say how the answer is: Finding(const Response&). Broken when there is none.
template <typename Response, typename Judge>
Finding Given(Target& target, const std::string& sent, const google::protobuf::Message& request, const Judge& judge) {
  const absl::StatusOr<Response> answer = target.Ask<Response>(request);
  if (!answer.ok()) return Broken(sent, StatusText(answer.status()), "an answer");
  return judge(*answer);
}

// Broken when `status` is not OK, with its message as what came back.
inline Finding KeptIf(const absl::Status& status, const std::string& sent, const std::string& right) {
  return status.ok() ? Kept() : Broken(sent, std::string(status.message()), right);
}

// One row of a table of bad input.
template <typename Message>
struct Fault {
  // What is bad, such as "a width that is no number".
  std::string what;
  // How the error must name the field, at least: "objects[0].width_m".
  std::string field;
  std::function<void(Message&)> spoil;
};

// Kept when the request is refused as bad input and the error names the field.
template <typename Response>
Finding Refused(Target& target, const std::string& what, const std::string& field,
                const google::protobuf::Message& request) {
  const std::string sent = fmt::format("{} with {} ({})", RpcName(request), what, field);
  const std::string right = fmt::format("INVALID_ARGUMENT with a message that names \"{}\"", field);
  const absl::Status status = target.Ask<Response>(request).status();
  if (status.ok()) return Broken(sent, "OK, with an answer", right);
  const bool named = status.message().find(field) != std::string::npos;
  if (absl::IsInvalidArgument(status) && named) return Kept();
  return Broken(sent, StatusText(status), right);
}

// One check for each row: `good` spoiled in its way must be refused.
template <typename Response, typename Request>
void AddRefusals(const Request& good, const std::vector<Fault<Request>>& faults, Checks& checks,
                 v1::Capability capability = v1::CAPABILITY_UNSPECIFIED) {
  for (const Fault<Request>& fault : faults) {
    Request bad = good;
    fault.spoil(bad);
    checks.push_back({.name = fmt::format("{} refuses {}", RpcName(good), fault.what),
                      .promise = Promise::kErrors,
                      .run = [bad, what = fault.what, field = fault.field](
                                 Target& target) { return Refused<Response>(target, what, field, bad); },
                      .capability = capability});
  }
}

}  // namespace flair::contract
