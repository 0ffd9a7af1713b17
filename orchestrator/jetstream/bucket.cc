// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/jetstream/bucket.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "absl/strings/escaping.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

using nlohmann::json;

absl::StatusOr<Bucket::Entry> ToEntry(const absl::StatusOr<json>& answer) {
  if (!answer.ok()) return answer.status();
  const json message = answer->value("message", json::object());
  Bucket::Entry entry;
  entry.revision = message.value("seq", uint64_t{0});
  if (!absl::Base64Unescape(message.value("data", ""), &entry.value) || entry.revision == 0) {
    return absl::InternalError("a bucket of the queue gives a value that cannot be read");
  }
  return entry;
}

NatsRequest WriteRequest(std::string subject, std::string_view value) {
  return {std::move(subject), std::string(value), {}};
}

NatsRequest UpdateRequest(std::string subject, std::string value, uint64_t expected) {
  return {std::move(subject), std::move(value), {{"Nats-Expected-Last-Subject-Sequence", std::to_string(expected)}}};
}

}  // namespace

NatsRequest Bucket::NewRequest(std::string_view key, std::string value) const {
  return UpdateRequest(SubjectOf(key), std::move(value), 0);
}

NatsRequest Bucket::GetRequest(std::string_view key) const {
  return {"$JS.API.STREAM.MSG.GET." + stream_, json{{"last_by_subj", SubjectOf(key)}}.dump(), {}};
}

absl::StatusOr<Bucket::Entry> Bucket::ParseEntry(const NatsMessage& answer) const {
  return ToEntry(api_.Parse(answer));
}

absl::StatusOr<Bucket::Entry> Bucket::Get(std::string_view key) {
  return ToEntry(api_.Call("STREAM.MSG.GET." + stream_, json{{"last_by_subj", SubjectOf(key)}}));
}

std::vector<absl::StatusOr<Bucket::Entry>> Bucket::GetAll(std::span<const std::string> keys) {
  std::vector<std::pair<std::string, json>> calls;
  for (const std::string& key : keys) {
    calls.emplace_back("STREAM.MSG.GET." + stream_, json{{"last_by_subj", SubjectOf(key)}});
  }
  std::vector<absl::StatusOr<Entry>> entries;
  for (const absl::StatusOr<json>& answer : api_.CallAll(calls)) entries.push_back(ToEntry(answer));
  return entries;
}

absl::StatusOr<uint64_t> Bucket::Put(std::string_view key, std::string_view value) {
  ASSIGN_OR_RETURN(const StoredAck ack, api_.Publish(WriteRequest(SubjectOf(key), value)));
  return ack.sequence;
}

absl::StatusOr<uint64_t> Bucket::Update(std::string_view key, std::string_view value, uint64_t expected,
                                        const std::function<bool()>& more) {
  const NatsRequest request = UpdateRequest(SubjectOf(key), std::string(value), expected);
  int asked = 0;
  const auto ask = [&] {
    ++asked;
    return api_.PublishOnce(request);
  };
  const absl::StatusOr<StoredAck> ack = more ? JetStreamApi::WhileUnavailable(ask, more) : api_.WithinLimit(ask);
  if (ack.ok()) return ack->sequence;
  if (!absl::IsAborted(ack.status()) || asked == 1) return ack.status();
  // An earlier question may have been heard without our hearing the answer.
  ASSIGN_OR_RETURN(const Entry now, Get(key));
  if (now.value == value) return now.revision;
  return ack.status();
}

std::vector<absl::StatusOr<uint64_t>> Bucket::UpdateAll(std::span<const Change> changes) {
  std::vector<NatsRequest> requests;
  for (const Change& change : changes) {
    requests.push_back(UpdateRequest(SubjectOf(change.key), change.value, change.expected));
  }
  std::vector<absl::StatusOr<uint64_t>> revisions;
  for (const absl::StatusOr<StoredAck>& ack : api_.PublishAll(requests)) {
    if (ack.ok()) {
      revisions.emplace_back(ack->sequence);
    } else {
      revisions.emplace_back(ack.status());
    }
  }
  return revisions;
}

std::vector<absl::StatusOr<bool>> Bucket::RemoveAll(std::span<const Revision> revisions) {
  std::vector<std::pair<std::string, json>> calls;
  for (const Revision& revision : revisions) {
    // A key has one message, the latest: an earlier one is gone.
    calls.emplace_back("STREAM.MSG.DELETE." + stream_, json{{"seq", revision.revision}, {"no_erase", true}});
  }
  std::vector<absl::StatusOr<bool>> removed;
  for (const absl::StatusOr<json>& answer : api_.CallAll(calls)) {
    if (answer.ok() || absl::IsNotFound(answer.status())) {
      removed.emplace_back(answer.ok());
    } else {
      removed.emplace_back(answer.status());
    }
  }
  return removed;
}

absl::StatusOr<bool> Bucket::Remove(const Revision& revision) { return RemoveAll(std::span(&revision, 1)).front(); }

}  // namespace flair::orchestrator
