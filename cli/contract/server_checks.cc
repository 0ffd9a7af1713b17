// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for the servers of all stages: who they are, health, reflection, sizes of messages, bytes that are none,
// and callers who give up, come again or come many at once.
#include <algorithm>

#include "cli/contract/script.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::contract {
namespace {

using Message = google::protobuf::Message;
using Calls = std::vector<std::unique_ptr<Call>>;
using Answers = std::vector<absl::StatusOr<std::string>>;

// Every gRPC server takes 4 MiB unless it is told otherwise.
constexpr int kSmallMib = 3;
constexpr size_t kMib = 1024 * 1024;
// A field that no message has; those who do not know it must pass over it.
constexpr int kUnknownField = 60000;

constexpr int kGoneCallers = 16;
constexpr int kCallersAtOnce = 8;
constexpr absl::Duration kShortDeadline = absl::Milliseconds(500);
constexpr absl::Duration kBeforeCancel = absl::Milliseconds(300);

// Empty when the answer is as it should be.
std::string AnswerFault(const Sample& sample, const absl::StatusOr<std::string>& answer) {
  return answer.ok() ? sample.fault(*answer) : StatusText(answer.status());
}

std::string OutcomeText(const absl::Status& status) { return status.ok() ? "OK, with an answer" : StatusText(status); }

Finding SpeaksTheProtocol(Target& target) { return WrongIf(runtime::ProtocolFault(target.worker())); }

Finding IsOfTheStage(const Sample& sample, Target& target) {
  const absl::Status status = target.AskAgain(*sample.request).status();
  if (!absl::IsUnimplemented(status)) return Kept();
  return Wrong(StatusText(status), fmt::format("the server there to be a {}; is this the port of another stage?",
                                               target.options().service));
}

// A server that has no health service is asked no further; one that has it says the truth.
Finding IsHealthy(Target& target) {
  for (const std::string& service : {target.options().service, std::string()}) {
    const auto health = HealthOf(target.channel(), service, target.options().patience);
    if (absl::IsUnimplemented(health.status())) return Skipped("it serves no grpc.health.v1.Health");
    if (health.ok() && *health == "SERVING") continue;
    return Wrong(health.ok() ? *health : StatusText(health.status()), "SERVING",
                 fmt::format("grpc.health.v1.Health/Check of \"{}\"", service));
  }
  return Kept();
}

Finding HealthOfOthersIsUnknown(Target& target) {
  const auto health = HealthOf(target.channel(), "flair.v1.NoSuchService", target.options().patience);
  if (absl::IsUnimplemented(health.status())) return Skipped("it serves no grpc.health.v1.Health");
  if (absl::IsNotFound(health.status())) return Kept();
  return Wrong(health.ok() ? *health : StatusText(health.status()));
}

Finding ReflectsItsService(Target& target) {
  const absl::StatusOr<std::vector<std::string>> services = ReflectedServices(target);
  if (absl::IsUnimplemented(services.status())) return Skipped("it serves no grpc.reflection");
  RETURN_IF_ERROR(services.status());
  if (std::ranges::find(*services, target.options().service) != services->end()) return Kept();
  return Wrong(fmt::format("{}", fmt::join(*services, ", ")),
               fmt::format("{} among the services", target.options().service));
}

std::unique_ptr<Message> Padded(const Message& request, size_t byte_count) {
  std::unique_ptr<Message> padded(request.New());
  padded->CopyFrom(request);
  padded->GetReflection()
      ->MutableUnknownFields(padded.get())
      ->AddLengthDelimited(kUnknownField, std::string(byte_count, 'x'));
  return padded;
}

Finding TakesLargeMessages(const Sample& sample, Target& target) {
  return WrongIf(AnswerFault(sample, target.AskAgain(*Padded(*sample.request, kSmallMib * kMib))));
}

Finding RefusesTooLargeMessages(const Sample& sample, Target& target) {
  const int limit = target.options().max_message_mib;
  const absl::Status status = target.AskAgain(*Padded(*sample.request, limit * kMib + 1)).status();
  if (absl::IsResourceExhausted(status)) return Kept();
  return Wrong(OutcomeText(status),
               fmt::format("RESOURCE_EXHAUSTED (--max-message-mib when it takes more than {})", limit),
               fmt::format("{} with {} MiB and a byte", sample.what, limit));
}

Finding RefusesBytesThatAreNone(const Sample& sample, Target& target) {
  const std::string bytes(11, '\xff');  // a tag that never ends
  const absl::Status status =
      Call(target.channel(), target.PathOf(*sample.request), bytes, target.options().patience).Wait().status();
  if (status.ok() || absl::IsUnavailable(status) || absl::IsDeadlineExceeded(status)) return Wrong(OutcomeText(status));
  return WrongIf(AnswerFault(sample, target.AskAgain(*sample.request)));
}

// More calls than most servers have threads, so that work that goes on for nobody is in the way of the next caller.
Calls StartLongCalls(const Sample& sample, const Target& target, absl::Duration within) {
  Calls calls;
  for (size_t i = 0; i < kGoneCallers; ++i) {
    calls.push_back(target.Start(*sample.long_requests[i % sample.long_requests.size()], within));
  }
  return calls;
}

// Servers may be done before, or have no room for so many.
bool EndedProperly(const absl::Status& status) {
  return status.ok() || absl::IsDeadlineExceeded(status) || absl::IsCancelled(status) ||
         absl::IsResourceExhausted(status);
}

Finding AfterLongCalls(const Sample& sample, const Target& target, Calls& calls) {
  for (const std::unique_ptr<Call>& call : calls) {
    const absl::Status status = call->Wait().status();
    if (EndedProperly(status)) continue;
    return Wrong(StatusText(status), "DEADLINE_EXCEEDED, CANCELLED or RESOURCE_EXHAUSTED, or the answer");
  }
  return WrongIf(AnswerFault(sample, target.AskAgain(*sample.request)));
}

Finding DeadlinesAreObeyed(const Sample& sample, Target& target) {
  Calls calls = StartLongCalls(sample, target, kShortDeadline);
  return AfterLongCalls(sample, target, calls);
}

Finding CancelsAreObeyed(const Sample& sample, Target& target) {
  Calls calls = StartLongCalls(sample, target, target.options().patience);
  // Lets most of them arrive; whether they have makes no difference to what must happen.
  calls.back()->WaitFor(kBeforeCancel);
  for (const std::unique_ptr<Call>& call : calls) call->Cancel();
  return AfterLongCalls(sample, target, calls);
}

// The answers of several callers at once. Those that were refused for want of room come again, one by one.
Answers AskAtOnce(const Sample& sample, Target& target) {
  Calls calls;
  for (int i = 0; i < kCallersAtOnce; ++i) calls.push_back(target.Start(*sample.request, target.options().patience));
  Answers answers;
  for (const std::unique_ptr<Call>& call : calls) answers.push_back(call->Wait());
  for (absl::StatusOr<std::string>& answer : answers) {
    if (absl::IsResourceExhausted(answer.status())) answer = target.AskAgain(*sample.request);
  }
  return answers;
}

Finding ManyAtOnceAreAnswered(const Sample& sample, Target& target) {
  for (const absl::StatusOr<std::string>& answer : AskAtOnce(sample, target)) {
    if (const std::string fault = AnswerFault(sample, answer); !fault.empty()) return Wrong(fault);
  }
  return Kept();
}

Finding AnswersAreEqual(const Sample& sample, Target& target, bool at_once) {
  ASSIGN_OR_RETURN(const std::string first, target.AskAgain(*sample.request));
  for (const auto& other : at_once ? AskAtOnce(sample, target) : Answers{target.AskAgain(*sample.request)}) {
    RETURN_IF_ERROR(other.status());
    if (sample.core(*other) != sample.core(first)) return Wrong("answers that differ");
  }
  return Kept();
}

// A check of the sample's request.
std::function<Finding(Target&)> Of(const Sample& sample, Finding (*check)(const Sample&, Target&)) {
  return [sample, check](Target& target) { return check(sample, target); };
}

}  // namespace

Checks ServerChecks(const Sample& sample) {
  return {
      {.name = "The server speaks flair.v1",
       .promise = data::PROMISE_PROTOCOL,
       .sent = "GetWorker",
       .right =
           fmt::format("protocols that are empty or hold \"{}\", and a server of that version", runtime::kProtocol),
       .run = SpeaksTheProtocol,
       .decisive = true},
      {.name = "The server is one of this stage",
       .promise = data::PROMISE_PROTOCOL,
       .sent = sample.what,
       .run = Of(sample, IsOfTheStage),
       .decisive = true},
      {"Health says that the service is served", data::PROMISE_PROTOCOL, "grpc.health.v1.Health/Check", "SERVING",
       IsHealthy},
      {"Health does not know other services", data::PROMISE_PROTOCOL,
       "grpc.health.v1.Health/Check of \"flair.v1.NoSuchService\"", "NOT_FOUND", HealthOfOthersIsUnknown},
      {"Reflection lists the service", data::PROMISE_PROTOCOL, "list_services of reflection", "its services",
       ReflectsItsService},
      {"A message of three MiB with an unknown field is answered", data::PROMISE_SIZE,
       fmt::format("{} with {} MiB in a field that nobody knows", sample.what, kSmallMib),
       "the answer as without it: servers take 4 MiB at least and pass over unknown fields",
       Of(sample, TakesLargeMessages)},
      {"A message over the limit is refused", data::PROMISE_SIZE, sample.what, "RESOURCE_EXHAUSTED",
       Of(sample, RefusesTooLargeMessages)},
      {"Bytes that are not a message are refused, and the server goes on", data::PROMISE_ERRORS,
       fmt::format("{} with 11 bytes that are not a message, then {}", RpcName(*sample.request), sample.what),
       "an error, and the server goes on serving", Of(sample, RefusesBytesThatAreNone)},
  };
}

Checks CallerChecks(const Sample& sample) {
  const std::string long_calls =
      fmt::format("{} long calls of {}", kGoneCallers, RpcName(*sample.long_requests.front()));
  const std::string then = "; then " + sample.what;
  const std::string right = "an answer: a server stops working on what nobody waits for any more";
  const std::string at_once = fmt::format("{} times at once", kCallersAtOnce);
  Checks checks = {{"Several callers at once are all answered", data::PROMISE_CALLERS,
                    fmt::format("{}, {}", sample.what, at_once), "the answer that one alone gets",
                    Of(sample, ManyAtOnceAreAnswered)}};
  if (sample.core) {
    const std::string same = "the same bytes, as the server claims DETERMINISTIC";
    checks.push_back({"The same request gets the same answer again", data::PROMISE_REPETITION, sample.what + ", twice",
                      same, [sample](Target& target) { return AnswersAreEqual(sample, target, false); },
                      v1::CAPABILITY_DETERMINISTIC});
    checks.push_back({"Several callers at once get the same answer", data::PROMISE_CALLERS,
                      fmt::format("{}, alone and {}", sample.what, at_once), same,
                      [sample](Target& target) { return AnswersAreEqual(sample, target, true); },
                      v1::CAPABILITY_DETERMINISTIC});
  }
  checks.push_back({"Work whose deadline has passed ends, and the server goes on", data::PROMISE_CALLERS,
                    long_calls + ", each with a deadline of half a second" + then, right,
                    Of(sample, DeadlinesAreObeyed)});
  checks.push_back({"Work that is cancelled ends, and the server goes on", data::PROMISE_CALLERS,
                    long_calls + ", cancelled on the way" + then, right, Of(sample, CancelsAreObeyed)});
  return checks;
}

}  // namespace flair::contract
