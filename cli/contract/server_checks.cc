// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for the servers of all stages: who they are, health, reflection, sizes of messages, bytes that are none.
#include <algorithm>

#include "cli/contract/ask.h"
#include "cli/contract/common_services.h"
#include "fmt/ranges.h"
#include "worker_runtime/grpc/client_call.h"

namespace flair::contract {
namespace {

// Every gRPC server takes 4 MiB unless it is told otherwise.
constexpr int kSmallMib = 3;
// A field that no message has; those who do not know it must pass over it.
constexpr int kUnknownField = 60000;

Finding SpeaksTheProtocol(Target& target) {
  const std::string fault = runtime::ProtocolFault(target.worker());
  if (fault.empty()) return Kept();
  return Broken(
      "GetWorker", fault,
      fmt::format("protocols that are empty or hold \"{}\", and a server of that version", runtime::kProtocol));
}

Finding IsOfTheStage(const Sample& sample, Target& target) {
  const absl::Status status = target.Start(*sample.request, target.options().patience)->Wait().status();
  if (!absl::IsUnimplemented(status)) return Kept();
  return Broken(
      sample.what, StatusText(status),
      fmt::format("the server there to be a {}; is this the port of another stage?", target.options().service));
}

// A server that has no health service is asked no further; one that has it says the truth.
Finding IsHealthy(Target& target) {
  for (const std::string& service : {target.options().service, std::string()}) {
    const std::string sent = fmt::format("grpc.health.v1.Health/Check of \"{}\"", service);
    const absl::StatusOr<Health> health = HealthOf(target.channel(), service, target.options().patience);
    if (absl::IsUnimplemented(health.status())) return Skipped("it serves no grpc.health.v1.Health");
    if (!health.ok()) return Broken(sent, StatusText(health.status()), "SERVING");
    if (*health != Health::kServing) return Broken(sent, HealthName(*health), "SERVING");
  }
  return Kept();
}

Finding HealthOfOthersIsUnknown(Target& target) {
  const absl::StatusOr<Health> health = HealthOf(target.channel(), "flair.v1.NoSuchService", target.options().patience);
  if (absl::IsUnimplemented(health.status())) return Skipped("it serves no grpc.health.v1.Health");
  if (absl::IsNotFound(health.status())) return Kept();
  return Broken("grpc.health.v1.Health/Check of \"flair.v1.NoSuchService\"",
                health.ok() ? HealthName(*health) : StatusText(health.status()), "NOT_FOUND");
}

Finding ReflectsItsService(Target& target) {
  const absl::StatusOr<std::vector<std::string>> services = ReflectedServices(target, target.options().patience);
  if (absl::IsUnimplemented(services.status())) return Skipped("it serves no grpc.reflection");
  const std::string right = fmt::format("{} among the services", target.options().service);
  if (!services.ok()) return Broken("list_services of reflection", StatusText(services.status()), right);
  if (std::ranges::find(*services, target.options().service) != services->end()) return Kept();
  return Broken("list_services of reflection", fmt::format("{}", fmt::join(*services, ", ")), right);
}

std::unique_ptr<google::protobuf::Message> Padded(const google::protobuf::Message& request, size_t byte_count) {
  std::unique_ptr<google::protobuf::Message> padded(request.New());
  padded->CopyFrom(request);
  padded->GetReflection()
      ->MutableUnknownFields(padded.get())
      ->AddLengthDelimited(kUnknownField, std::string(byte_count, 'x'));
  return padded;
}

constexpr size_t kMib = 1024 * 1024;

Finding TakesLargeMessages(const Sample& sample, Target& target) {
  const std::string sent = fmt::format("{} with {} MiB in a field that nobody knows", sample.what, kSmallMib);
  const auto bytes = target.Start(*Padded(*sample.request, kSmallMib * kMib), target.options().patience)->Wait();
  const std::string right = "the answer as without it: servers take 4 MiB at least and pass over unknown fields";
  if (!bytes.ok()) return Broken(sent, StatusText(bytes.status()), right);
  const std::string fault = sample.fault(*bytes);
  return fault.empty() ? Kept() : Broken(sent, fault, right);
}

Finding RefusesTooLargeMessages(const Sample& sample, Target& target) {
  const int limit = target.options().max_message_mib;
  const std::string sent = fmt::format("{} with {} MiB and a byte", sample.what, limit);
  const std::string right = fmt::format("RESOURCE_EXHAUSTED (--max-message-mib when it takes more than {})", limit);
  const absl::Status status =
      target.Start(*Padded(*sample.request, limit * kMib + 1), target.options().patience)->Wait().status();
  if (absl::IsResourceExhausted(status)) return Kept();
  return Broken(sent, status.ok() ? "OK, with an answer" : StatusText(status), right);
}

Finding RefusesBytesThatAreNone(const Sample& sample, Target& target) {
  const std::string path = PathOf(target.options().service, *sample.request);
  const std::string bytes = "\xff\xff\xff\xff\xff\xff\xff\xff\xff\xff\xff";  // a tag that never ends
  const absl::Status status = target.Start(path, bytes, target.options().patience)->Wait().status();
  const std::string sent = fmt::format("{} with 11 bytes that are no message", RpcName(*sample.request));
  const std::string right = "an error, and the server goes on serving";
  if (status.ok()) return Broken(sent, "OK, with an answer", right);
  if (absl::IsUnavailable(status) || absl::IsDeadlineExceeded(status)) return Broken(sent, StatusText(status), right);
  const auto next = target.Start(*sample.request, target.options().patience)->Wait();
  const std::string fault = next.ok() ? sample.fault(*next) : StatusText(next.status());
  return fault.empty() ? Kept() : Broken(sent + ", then " + sample.what, fault, right);
}

}  // namespace

void AddServerChecks(const Sample& sample, Checks& checks) {
  checks.push_back({.name = "The server speaks flair.v1",
                    .promise = Promise::kProtocol,
                    .run = SpeaksTheProtocol,
                    .decisive = true});
  checks.push_back({.name = "The server is one of this stage",
                    .promise = Promise::kProtocol,
                    .run = [sample](Target& target) { return IsOfTheStage(sample, target); },
                    .decisive = true});
  checks.push_back({.name = "Health says that the service is served", .promise = Promise::kProtocol, .run = IsHealthy});
  checks.push_back(
      {.name = "Health does not know other services", .promise = Promise::kProtocol, .run = HealthOfOthersIsUnknown});
  checks.push_back({.name = "Reflection lists the service", .promise = Promise::kProtocol, .run = ReflectsItsService});
  checks.push_back({.name = "A message of three MiB with an unknown field is answered",
                    .promise = Promise::kSize,
                    .run = [sample](Target& target) { return TakesLargeMessages(sample, target); }});
  checks.push_back({.name = "A message over the limit is refused",
                    .promise = Promise::kSize,
                    .run = [sample](Target& target) { return RefusesTooLargeMessages(sample, target); }});
  checks.push_back({.name = "Bytes that are no message are refused, and the server goes on",
                    .promise = Promise::kErrors,
                    .run = [sample](Target& target) { return RefusesBytesThatAreNone(sample, target); }});
}

}  // namespace flair::contract
