// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/jetstream/streams.h"

#include <nats/nats.h>

#include <atomic>
#include <nlohmann/json.hpp>
#include <set>

#include "absl/strings/escaping.h"
#include "orchestrator/jetstream/pending_messages.h"
#include "worker_runtime/executor/executor.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

// How long one answer may take; the limit of calls allows for several.
constexpr absl::Duration kOneAnswer = absl::Seconds(2);
constexpr int kCallsAtOnce = 8;
// Consumers of processes that died are removed after this.
constexpr absl::Duration kConsumerLife = absl::Seconds(30);
// A consumer may have any number of unacknowledged messages.
constexpr int64_t kNoLimit = 1'000'000'000;

// Error codes that cnats has names for; for others, see errors.json of nats-server.
const std::set<int> kNoRoom = {JSAccountResourcesExceededErr, JSInsufficientResourcesErr, JSMemoryResourcesExceededErr,
                               JSStorageResourcesExceededErr, JSStreamStoreFailedErr,     JSStreamLimitsErr};
const std::set<int> kMissing = {JSConsumerNotFoundErr, JSNoMessageFoundErr, JSSequenceNotFoundErr,
                                JSStreamMsgDeleteFailed, JSStreamNotFoundErr};
// The servers choose a leader, or move the stream.
const std::set<int> kPassing = {JSClusterIncompleteErr, JSClusterNotActiveErr, JSClusterNotAssignedErr,
                                JSClusterNotAvailErr,   JSClusterNotLeaderErr, JSConsumerCreateErr,
                                JSRaftGeneralErr,       JSStreamAssignmentErr, JSStreamCreateErr,
                                JSStreamGeneralError,   JSPeerRemapErr,        JSTempStorageFailedErr};

// Destroys objects of cnats.
template <auto Destroy>
struct Deleter {
  template <typename T>
  void operator()(T* made) const {
    Destroy(made);
  }
};
using PubAckPtr = std::unique_ptr<jsPubAck, Deleter<jsPubAck_Destroy>>;
using StreamInfoPtr = std::unique_ptr<jsStreamInfo, Deleter<jsStreamInfo_Destroy>>;
using ConsumerInfoPtr = std::unique_ptr<jsConsumerInfo, Deleter<jsConsumerInfo_Destroy>>;

StoredMessage ToMessage(natsMsg* made) {
  const NatsMessagePtr message(made);
  return {natsMsg_GetSubject(made),
          std::string(natsMsg_GetData(made), static_cast<size_t>(natsMsg_GetDataLength(made))),
          natsMsg_GetSequence(made)};
}

}  // namespace

NatsRequest WithMessageId(std::string subject, std::string content, const std::string& message_id) {
  return {std::move(subject), std::move(content), {{"Nats-Msg-Id", message_id}}};
}

NatsRequest WithExpected(std::string subject, std::string content, uint64_t expected) {
  return {std::move(subject), std::move(content), {{"Nats-Expected-Last-Subject-Sequence", std::to_string(expected)}}};
}

Streams::Streams(NatsConnection& connection, absl::Duration limit)
    : connection_(connection),
      limit_(limit),
      pending_(std::make_unique<PendingMessages>(
          [this](int status, int code, const char* text) { return ToStatus(status, code, text); })) {
  jsOptions options;
  jsOptions_Init(&options);
  options.PublishAsync.AckHandler = PendingMessages::OnAck;
  options.PublishAsync.AckHandlerClosure = pending_.get();
  // Both fail only without memory; then every call says so.
  (void)natsConnection_JetStream(&context_, connection.handle(), nullptr);
  (void)natsConnection_JetStream(&publishing_, connection.handle(), &options);
}

Streams::~Streams() {
  // An answer that comes just now is still given to `pending_`.
  jsPubOptions wait = {};
  wait.MaxWait = absl::ToInt64Milliseconds(kOneAnswer);
  (void)js_PublishAsyncComplete(publishing_, &wait);
  jsCtx_Destroy(publishing_);
  jsCtx_Destroy(context_);
}

absl::Status Streams::ToStatus(int nats_status, int error_code, const char* said) const {
  if (nats_status == NATS_OK) return absl::OkStatus();
  // The last error of a thread is of an earlier call when this one got no answer.
  const char* last = said == nullptr && error_code != 0 ? nats_GetLastError(nullptr) : said;
  const std::string text = last != nullptr ? last : natsStatus_GetText(static_cast<natsStatus>(nats_status));
  const std::string& address = connection_.address();
  if (nats_status == NATS_NOT_FOUND || kMissing.contains(error_code)) return absl::NotFoundError(text);
  if (nats_status == NATS_NO_RESPONDERS) {
    return connection_.Unreachable("JetStream is off there, or has no leader at the moment");
  }
  if (error_code == 0) return connection_.Unreachable(text);
  if (error_code == JSStreamWrongLastSequenceErr) return absl::AbortedError(text);
  if (kNoRoom.contains(error_code)) {
    return ResourceExhausted("the queue at {} is full ({}); give its servers more room (max_file_store, disk)", address,
                             text);
  }
  if (error_code == JSStreamReplicasNotSupportedErr || error_code == JSClusterNoPeersErr) {
    return FailedPrecondition("queue.replica_count: {} has fewer servers with JetStream ({})", address, text);
  }
  if (error_code == JSNotEnabledErr || error_code == JSNotEnabledForAccountErr) {
    return FailedPrecondition("queue.address: JetStream is off at {} ({}); start nats-server with --jetstream", address,
                              text);
  }
  if (kPassing.contains(error_code)) {
    return Unavailable("the queue at {} cannot do that now ({})", address, text);
  }
  return Internal("the queue at {} refuses: {} (error {})", address, text, error_code);
}

template <typename Call>
absl::Status Streams::Once(const Call& call) {
  // cnats would wait for a connection that is being made again.
  if (!connection_.connected()) return connection_.Unreachable("no connection");
  jsOptions options;
  jsOptions_Init(&options);
  options.Wait = absl::ToInt64Milliseconds(kOneAnswer);
  jsErrCode code = {};
  const natsStatus status = call(&options, &code);
  return ToStatus(status, code);
}

template <typename Call>
absl::Status Streams::Repeated(const Call& call) {
  return WithinLimit([&] { return Once(call); });
}

// Results of `call(i)` for all i below `count`, several at once. When one ends with UNAVAILABLE, after all its
// repetitions, the others are not tried any more.
template <typename T, typename Call>
std::vector<absl::StatusOr<T>> Streams::ForEach(size_t count, const Call& call) {
  std::vector<absl::StatusOr<T>> results(count, absl::StatusOr<T>(connection_.Unreachable("no answer in time")));
  std::atomic<bool> gave_up = false;
  (void)runtime::ForEach({.thread_count = kCallsAtOnce, .check_alive = {}}, static_cast<int>(count), [&](int i) {
    if (gave_up) return;
    absl::StatusOr<T>& result = results[static_cast<size_t>(i)] = call(static_cast<size_t>(i));
    if (absl::IsUnavailable(result.status())) gave_up = true;
  });
  return results;
}

absl::Status Streams::Make(const StreamOptions& options) {
  jsStreamConfig config;
  jsStreamConfig_Init(&config);
  const char* subject = options.subject.c_str();
  config.Name = options.name.c_str();
  config.Subjects = &subject;
  config.SubjectsLen = 1;
  config.Replicas = options.replica_count;
  // A full stream refuses new messages and keeps the old ones.
  config.Discard = js_DiscardNew;
  if (options.work_queue) config.Retention = js_WorkQueuePolicy;
  if (options.latest_only) config.MaxMsgsPerSubject = 1;
  if (options.life != absl::InfiniteDuration()) {
    config.Storage = js_MemoryStorage;
    config.MaxAge = config.Duplicates = absl::ToInt64Nanoseconds(options.life);
  }
  const auto look = [&](jsOptions* o, jsErrCode* code) {
    jsStreamInfo* info = nullptr;
    const natsStatus status = js_GetStreamInfo(&info, context_, config.Name, o, code);
    jsStreamInfo_Destroy(info);
    return status;
  };
  const absl::Status known = Repeated(look);
  if (!absl::IsNotFound(known)) return known;
  const absl::Status made =
      Repeated([&](jsOptions* o, jsErrCode* code) { return js_AddStream(nullptr, context_, &config, o, code); });
  // Another process may have created it just now.
  return made.ok() || !Repeated(look).ok() ? made : absl::OkStatus();
}

absl::StatusOr<uint64_t> Streams::PublishOnce(const NatsRequest& message) {
  RETURN_IF_ERROR(connection_.CheckSize(message));
  const NatsMessagePtr made = MakeNatsMessage(message);
  if (made == nullptr) return absl::ResourceExhaustedError("no memory for a message");
  jsPubAck* ack = nullptr;
  RETURN_IF_ERROR(Once([&](jsOptions* options, jsErrCode* code) {
    jsPubOptions wait = {};
    wait.MaxWait = options->Wait;
    return js_PublishMsg(&ack, context_, made.get(), &wait, code);
  }));
  return PubAckPtr(ack)->Sequence;
}

absl::StatusOr<uint64_t> Streams::Publish(const NatsRequest& message) {
  return WithinLimit([&] { return PublishOnce(message); });
}

std::vector<absl::StatusOr<uint64_t>> Streams::PublishAll(std::span<const NatsRequest> messages) {
  std::vector<absl::StatusOr<uint64_t>> results(messages.size(), connection_.Unreachable("no answer in time"));
  if (messages.empty()) return results;
  PendingMessages::Call call;
  for (size_t i = 0; i < messages.size() && connection_.connected(); ++i) {
    if (const absl::Status fits = connection_.CheckSize(messages[i]); !fits.ok()) {
      results[i] = fits;
      continue;
    }
    natsMsg* made = MakeNatsMessage(messages[i]).release();
    if (made == nullptr) continue;
    pending_->Add(call, made, &results[i]);
    // Takes the message when it could be sent.
    if (js_PublishMsgAsync(publishing_, &made, nullptr) == NATS_OK) continue;
    pending_->ForgetLast(call);
    natsMsg_Destroy(made);
  }
  pending_->Await(call, kOneAnswer);
  // The rest one by one, until one has had no answer in all the time there is.
  for (size_t i = 0; i < messages.size(); ++i) {
    if (!absl::IsUnavailable(results[i].status())) continue;
    results[i] = Publish(messages[i]);
    if (absl::IsUnavailable(results[i].status())) break;
  }
  return results;
}

absl::Status Streams::PublishEach(std::span<const NatsRequest> messages) {
  for (const absl::StatusOr<uint64_t>& sequence : PublishAll(messages)) RETURN_IF_ERROR(sequence.status());
  return absl::OkStatus();
}

absl::StatusOr<StoredMessage> Streams::Get(const std::string& stream, uint64_t sequence) {
  natsMsg* message = nullptr;
  RETURN_IF_ERROR(Repeated([&](jsOptions* options, jsErrCode* code) {
    return js_GetMsg(&message, context_, stream.c_str(), sequence, options, code);
  }));
  return ToMessage(message);
}

absl::StatusOr<StoredMessage> Streams::LastOnce(const std::string& stream, const std::string& subject,
                                                absl::Duration limit) {
  natsMsg* message = nullptr;
  RETURN_IF_ERROR(Once([&](jsOptions* options, jsErrCode* code) {
    options->Wait = std::max<int64_t>(1, absl::ToInt64Milliseconds(limit));
    return js_GetLastMsg(&message, context_, stream.c_str(), subject.c_str(), options, code);
  }));
  return ToMessage(message);
}

absl::StatusOr<StoredMessage> Streams::Last(const std::string& stream, const std::string& subject) {
  return WithinLimit([&] { return LastOnce(stream, subject, kOneAnswer); });
}

std::vector<absl::StatusOr<StoredMessage>> Streams::LastOfEach(const std::string& stream,
                                                               std::span<const std::string> subjects) {
  return ForEach<StoredMessage>(subjects.size(), [&](size_t i) { return Last(stream, subjects[i]); });
}

// cnats has no call for the next message of a filter that the leader answers.
absl::StatusOr<StoredMessage> Streams::Next(const std::string& stream, const std::string& filter, uint64_t sequence) {
  using nlohmann::json;
  const NatsRequest request{"$JS.API.STREAM.MSG.GET." + stream,
                            json{{"seq", std::max<uint64_t>(1, sequence)}, {"next_by_subj", filter}}.dump(),
                            {}};
  ASSIGN_OR_RETURN(const NatsMessage answer, WithinLimit([&] { return connection_.Request(request, kOneAnswer); }));
  const json parsed = json::parse(answer.content, nullptr, false);
  const auto error = parsed.find("error");
  if (error != parsed.end()) {
    const absl::Status status = ToStatus(NATS_ERR, error->value("err_code", int{JSStreamGeneralError}));
    return status;
  }
  const auto message = parsed.find("message");
  StoredMessage found;
  if (message == parsed.end() || !absl::Base64Unescape(message->value("data", ""), &found.content)) {
    return Internal("stream {} holds a message that cannot be read", stream);
  }
  found.subject = message->value("subject", "");
  found.sequence = message->value("seq", uint64_t{0});
  if (found.sequence < sequence) return Internal("stream {} is read out of order", stream);
  return found;
}

absl::StatusOr<std::vector<StoredMessage>> Streams::Read(const std::string& stream, const std::string& filter,
                                                         uint64_t first_sequence, int limit) {
  std::vector<StoredMessage> read;
  while (static_cast<int>(read.size()) < limit) {
    ASSIGN_OR_RETURN(std::optional<StoredMessage> next,
                     IfFound(Next(stream, filter, read.empty() ? first_sequence : read.back().sequence + 1)));
    if (!next.has_value()) break;
    read.push_back(*std::move(next));
  }
  return read;
}

std::vector<absl::StatusOr<bool>> Streams::Remove(const std::string& stream, std::span<const uint64_t> sequences) {
  return ForEach<bool>(sequences.size(), [&](size_t i) -> absl::StatusOr<bool> {
    const absl::Status status = Repeated([&](jsOptions* options, jsErrCode* code) {
      return js_DeleteMsg(context_, stream.c_str(), sequences[i], options, code);
    });
    if (absl::IsNotFound(status)) return false;
    RETURN_IF_ERROR(status);
    return true;
  });
}

absl::Status Streams::Purge(const std::string& stream, const std::string& filter, uint64_t end_sequence) {
  return Repeated([&](jsOptions* options, jsErrCode* code) {
    options->Stream.Purge.Subject = filter.c_str();
    options->Stream.Purge.Sequence = end_sequence;
    return js_PurgeStream(context_, stream.c_str(), options, code);
  });
}

absl::StatusOr<uint64_t> Streams::LastSequence(const std::string& stream) {
  jsStreamInfo* info = nullptr;
  RETURN_IF_ERROR(Repeated([&](jsOptions* options, jsErrCode* code) {
    return js_GetStreamInfo(&info, context_, stream.c_str(), options, code);
  }));
  return StreamInfoPtr(info)->State.LastSeq;
}

absl::StatusOr<std::map<std::string, int64_t>> Streams::Subjects(const std::string& stream, const std::string& filter) {
  jsStreamInfo* made = nullptr;
  RETURN_IF_ERROR(Repeated([&](jsOptions* options, jsErrCode* code) {
    options->Stream.Info.SubjectsFilter = filter.c_str();
    return js_GetStreamInfo(&made, context_, stream.c_str(), options, code);
  }));
  const StreamInfoPtr info(made);
  std::map<std::string, int64_t> counts;
  const jsStreamStateSubjects* subjects = info->State.Subjects;
  for (int i = 0; subjects != nullptr && i < subjects->Count; ++i) {
    counts[subjects->List[i].Subject] = static_cast<int64_t>(subjects->List[i].Msgs);
  }
  return counts;
}

absl::StatusOr<int64_t> Streams::Count(const std::string& stream, const std::string& filter) {
  jsConsumerInfo* made = nullptr;
  // A server that just died may be asked to keep the consumer; then another is asked.
  RETURN_IF_ERROR(Repeated([&](jsOptions* options, jsErrCode* code) {
    jsConsumerConfig config;
    jsConsumerConfig_Init(&config);
    config.AckPolicy = js_AckNone;
    config.FilterSubject = filter.c_str();
    config.HeadersOnly = true;
    config.InactiveThreshold = absl::ToInt64Nanoseconds(kConsumerLife);
    config.Replicas = 1;
    config.MemoryStorage = true;
    return js_AddConsumer(&made, context_, stream.c_str(), &config, options, code);
  }));
  const ConsumerInfoPtr consumer(made);
  (void)Once([&](jsOptions* options, jsErrCode* code) {
    return js_DeleteConsumer(context_, stream.c_str(), consumer->Name, options, code);
  });
  return static_cast<int64_t>(consumer->NumPending);
}

absl::Status Streams::MakeConsumer(const std::string& stream, const std::string& consumer, const std::string& filter,
                                   absl::Duration ack_wait) {
  return Repeated([&](jsOptions* options, jsErrCode* code) {
    jsConsumerConfig config;
    jsConsumerConfig_Init(&config);
    config.Durable = consumer.c_str();
    config.FilterSubject = filter.c_str();
    config.AckPolicy = js_AckExplicit;
    config.AckWait = absl::ToInt64Nanoseconds(ack_wait);
    config.MaxAckPending = kNoLimit;
    return js_AddConsumer(nullptr, context_, stream.c_str(), &config, options, code);
  });
}

absl::Status Streams::RemoveConsumer(const std::string& stream, const std::string& consumer) {
  const absl::Status status = Repeated([&](jsOptions* options, jsErrCode* code) {
    return js_DeleteConsumer(context_, stream.c_str(), consumer.c_str(), options, code);
  });
  return absl::IsNotFound(status) ? absl::OkStatus() : status;
}

std::vector<absl::StatusOr<Streams::Depth>> Streams::DepthOfEach(const std::string& stream,
                                                                 std::span<const std::string> consumers) {
  return ForEach<Depth>(consumers.size(), [&](size_t i) -> absl::StatusOr<Depth> {
    jsConsumerInfo* made = nullptr;
    RETURN_IF_ERROR(Repeated([&](jsOptions* options, jsErrCode* code) {
      return js_GetConsumerInfo(&made, context_, stream.c_str(), consumers[i].c_str(), options, code);
    }));
    const ConsumerInfoPtr info(made);
    return Depth{static_cast<int64_t>(info->NumPending), info->NumAckPending};
  });
}

}  // namespace flair::orchestrator
