// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/jetstream/api.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

using nlohmann::json;

// What one answer may take; the calls' limit allows for several.
constexpr absl::Duration kOneAnswer = absl::Seconds(2);
// And many asked at once.
constexpr absl::Duration kManyAnswers = absl::Seconds(4);

// Codes of nats-server's errors.json.
bool MeansNoRoom(int code) {
  return code == 10002 || code == 10023 || code == 10028 || code == 10047 || code == 10077 || code == 10053;
}
bool MeansNotFound(int code) {
  return code == 10014 || code == 10037 || code == 10043 || code == 10057 || code == 10059;
}
constexpr int kWrongLastSequence = 10071;
constexpr int kNoSuitablePeers = 10005;
constexpr int kReplicasNeedCluster = 10074;
constexpr int kNotEnabled = 10076;
constexpr int kNotEnabledForAccount = 10039;

absl::Status ToStatus(const json& error, const std::string& address) {
  const int code = error.value("err_code", 0);
  const std::string text = error.value("description", "error without description");
  if (code == kWrongLastSequence) return absl::AbortedError(text);
  if (MeansNotFound(code)) return absl::NotFoundError(text);
  if (MeansNoRoom(code)) {
    return absl::ResourceExhaustedError(
        fmt::format("the queue at {} is full ({}); give its servers more room (max_file_store, disk)", address, text));
  }
  if (code == kReplicasNeedCluster || code == kNoSuitablePeers) {
    return absl::FailedPreconditionError(
        fmt::format("queue.replica_count: {} has not so many servers with JetStream ({})", address, text));
  }
  if (code == kNotEnabled || code == kNotEnabledForAccount) {
    return absl::FailedPreconditionError(
        fmt::format("queue.address: JetStream is off at {} ({}); start nats-server with --jetstream", address, text));
  }
  const int kind = error.value("code", 0);
  if (kind == 503 || kind == 500) {
    return absl::UnavailableError(fmt::format("the queue at {} cannot do that just now ({})", address, text));
  }
  return absl::InternalError(fmt::format("the queue at {} refuses: {} (error {})", address, text, code));
}

}  // namespace

absl::StatusOr<json> JetStreamApi::Parse(const absl::StatusOr<NatsMessage>& answer) const {
  if (!answer.ok()) return answer.status();
  json parsed = json::parse(answer->content, nullptr, false);
  if (!parsed.is_object()) {
    return absl::InternalError(fmt::format("{} does not answer as JetStream does", connection_.address()));
  }
  const auto error = parsed.find("error");
  if (error != parsed.end() && error->is_object()) return ToStatus(*error, connection_.address());
  return parsed;
}

absl::StatusOr<StoredAck> JetStreamApi::ParseAck(const absl::StatusOr<NatsMessage>& answer) const {
  ASSIGN_OR_RETURN(const json parsed, Parse(answer));
  return StoredAck{parsed.value("seq", uint64_t{0}), parsed.value("duplicate", false)};
}

absl::StatusOr<NatsMessage> JetStreamApi::Request(const NatsRequest& request) {
  return WithinLimit([&] { return connection_.Request(request, kOneAnswer); });
}

absl::StatusOr<json> JetStreamApi::Call(const std::string& verb, const json& request) {
  const NatsRequest message{"$JS.API." + verb, request.is_null() ? "" : request.dump(), {}};
  return WithinLimit([&] { return Parse(connection_.Request(message, kOneAnswer)); });
}

std::vector<absl::StatusOr<json>> JetStreamApi::CallAll(std::span<const std::pair<std::string, json>> calls) {
  std::vector<NatsRequest> requests;
  for (const auto& [verb, request] : calls) {
    requests.push_back({"$JS.API." + verb, request.is_null() ? "" : request.dump(), {}});
  }
  std::vector<absl::StatusOr<json>> answers;
  for (const absl::StatusOr<NatsMessage>& answer : connection_.RequestAll(requests, kManyAnswers)) {
    answers.push_back(Parse(answer));
  }
  return answers;
}

absl::StatusOr<StoredAck> JetStreamApi::PublishOnce(const NatsRequest& message) {
  return ParseAck(connection_.Request(message, kOneAnswer));
}

absl::StatusOr<StoredAck> JetStreamApi::Publish(const NatsRequest& message) {
  return WithinLimit([&] { return PublishOnce(message); });
}

std::vector<absl::StatusOr<StoredAck>> JetStreamApi::PublishAll(std::span<const NatsRequest> messages) {
  std::vector<absl::StatusOr<StoredAck>> acks;
  const absl::Time deadline = absl::Now() + limit_;
  for (const auto& answer : connection_.RequestAll(messages, limit_)) acks.push_back(ParseAck(answer));
  for (size_t i = 0; i < acks.size(); ++i) {
    if (!absl::IsUnavailable(acks[i].status())) continue;
    acks[i] = WhileUnavailable([&] { return PublishOnce(messages[i]); }, [&] { return absl::Now() < deadline; });
    // When that one had no luck, the others have none either.
    if (absl::IsUnavailable(acks[i].status())) break;
  }
  return acks;
}

absl::Status JetStreamApi::PublishEach(std::span<const NatsRequest> messages) {
  if (messages.size() == 1) return Publish(messages.front()).status();
  for (const absl::StatusOr<StoredAck>& ack : PublishAll(messages)) RETURN_IF_ERROR(ack.status());
  return absl::OkStatus();
}

}  // namespace flair::orchestrator
