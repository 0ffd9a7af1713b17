// SPDX-License-Identifier: GPL-3.0-or-later
// What callers may do to a server of any stage: give up, come again, come many at once.
#include "cli/contract/ask.h"

namespace flair::contract {
namespace {

constexpr int kGoneCallers = 16;
constexpr int kCallersAtOnce = 8;
constexpr absl::Duration kShortDeadline = absl::Milliseconds(500);
constexpr absl::Duration kBeforeCancel = absl::Milliseconds(300);

using Calls = std::vector<std::unique_ptr<Call>>;

// More calls than most servers have threads, so that work that goes on for nobody is in the way of the next caller.
Calls StartLongCalls(const Sample& sample, const Target& target, absl::Duration within) {
  Calls calls;
  for (int i = 0; i < kGoneCallers; ++i) {
    const size_t which = static_cast<size_t>(i) % sample.long_requests.size();
    calls.push_back(target.Start(*sample.long_requests[which], within));
  }
  return calls;
}

std::string CallsText(const Sample& sample, const std::string& end) {
  return fmt::format("{} long calls of {}, {}", kGoneCallers, RpcName(*sample.long_requests.front()), end);
}

// Empty when the sample gets its answer.
std::string NextFault(const Sample& sample, const Target& target) {
  const absl::StatusOr<std::string> answer = target.Start(*sample.request, target.options().patience)->Wait();
  return answer.ok() ? sample.fault(*answer) : StatusText(answer.status());
}

// Servers may be done before, or have no room for so many.
bool EndedProperly(const absl::Status& status) {
  return status.ok() || absl::IsDeadlineExceeded(status) || absl::IsCancelled(status) ||
         absl::IsResourceExhausted(status);
}

Finding AfterLongCalls(const Sample& sample, const Target& target, const std::string& sent, Calls& calls) {
  for (const std::unique_ptr<Call>& call : calls) {
    const absl::Status status = call->Wait().status();
    if (!EndedProperly(status)) {
      return Broken(sent, StatusText(status), "DEADLINE_EXCEEDED, CANCELLED or RESOURCE_EXHAUSTED, or the answer");
    }
  }
  const std::string fault = NextFault(sample, target);
  if (fault.empty()) return Kept();
  return Broken(sent + "; then " + sample.what, fault,
                "an answer: a server stops working on what nobody waits for any more");
}

Finding DeadlinesAreObeyed(const Sample& sample, Target& target) {
  Calls calls = StartLongCalls(sample, target, kShortDeadline);
  return AfterLongCalls(sample, target, CallsText(sample, "each with a deadline of half a second"), calls);
}

Finding CancelsAreObeyed(const Sample& sample, Target& target) {
  Calls calls = StartLongCalls(sample, target, target.options().patience);
  // Lets most of them arrive; whether they have makes no difference to what must happen.
  calls.back()->WaitFor(kBeforeCancel);
  for (const std::unique_ptr<Call>& call : calls) call->Cancel();
  return AfterLongCalls(sample, target, CallsText(sample, "cancelled on the way"), calls);
}

// The answers of several callers at once. Those that were refused for want of room come again, one by one.
std::vector<absl::StatusOr<std::string>> AskAtOnce(const Sample& sample, Target& target) {
  Calls calls;
  for (int i = 0; i < kCallersAtOnce; ++i) {
    calls.push_back(target.Start(*sample.request, target.options().patience));
  }
  std::vector<absl::StatusOr<std::string>> answers;
  for (const std::unique_ptr<Call>& call : calls) answers.push_back(call->Wait());
  for (absl::StatusOr<std::string>& answer : answers) {
    if (!absl::IsResourceExhausted(answer.status())) continue;
    answer = target.Start(*sample.request, target.options().patience)->Wait();
  }
  return answers;
}

Finding ManyAtOnceAreAnswered(const Sample& sample, Target& target) {
  const std::string sent = fmt::format("{}, {} times at once", sample.what, kCallersAtOnce);
  for (const absl::StatusOr<std::string>& answer : AskAtOnce(sample, target)) {
    const std::string fault = answer.ok() ? sample.fault(*answer) : StatusText(answer.status());
    if (!fault.empty()) return Broken(sent, fault, "the answer that one alone gets");
  }
  return Kept();
}

Finding AnswersAreEqual(const Sample& sample, Target& target, bool at_once) {
  const std::string sent =
      fmt::format("{}, alone and {}", sample.what, at_once ? fmt::format("{} times at once", kCallersAtOnce) : "again");
  const absl::StatusOr<std::string> first = target.Start(*sample.request, target.options().patience)->Wait();
  if (!first.ok()) return Broken(sent, StatusText(first.status()), "an answer");
  std::vector<absl::StatusOr<std::string>> others;
  if (at_once) {
    others = AskAtOnce(sample, target);
  } else {
    others.push_back(target.Start(*sample.request, target.options().patience)->Wait());
  }
  for (const absl::StatusOr<std::string>& other : others) {
    if (!other.ok()) return Broken(sent, StatusText(other.status()), "an answer");
    if (sample.core(*other) == sample.core(*first)) continue;
    return Broken(sent, "answers that differ", "the same bytes, as the server claims DETERMINISTIC");
  }
  return Kept();
}

}  // namespace

void AddCallerChecks(const Sample& sample, Checks& checks) {
  const auto add = [&checks, &sample](std::string name, Promise promise, auto run,
                                      v1::Capability capability = v1::CAPABILITY_UNSPECIFIED) {
    checks.push_back({.name = std::move(name),
                      .promise = promise,
                      .run = [sample, run](Target& target) { return run(sample, target); },
                      .capability = capability});
  };
  add("Several callers at once are all answered", Promise::kCallers, ManyAtOnceAreAnswered);
  if (sample.core) {
    add(
        "The same request gets the same answer again", Promise::kRepetition,
        [](const Sample& of, Target& target) { return AnswersAreEqual(of, target, false); },
        v1::CAPABILITY_DETERMINISTIC);
    add(
        "Several callers at once get the same answer", Promise::kCallers,
        [](const Sample& of, Target& target) { return AnswersAreEqual(of, target, true); },
        v1::CAPABILITY_DETERMINISTIC);
  }
  add("Work whose deadline has passed ends, and the server goes on", Promise::kCallers, DeadlinesAreObeyed);
  add("Work that is cancelled ends, and the server goes on", Promise::kCallers, CancelsAreObeyed);
}

}  // namespace flair::contract
