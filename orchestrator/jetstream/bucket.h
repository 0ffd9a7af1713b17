// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "orchestrator/jetstream/streams.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {

// Values by keys in a stream of JetStream, the latest of each; keys are tokens with dots between. cnats's kvStore is
// not used: it cannot remove a value without a trace, and it may read from a server that is behind. Errors as Streams.
// Thread-safe.
class Bucket {
 public:
  struct Entry {
    std::string value;
    // Changes with each writing.
    uint64_t revision = 0;
  };

  Bucket(Streams& streams, const std::string& name)
      : streams_(streams), stream_("KV_" + name), prefix_("$KV." + name + ".") {}

  // NOT_FOUND when there is none.
  absl::StatusOr<Entry> Get(std::string_view key) { return ToEntry(streams_.Last(stream_, SubjectOf(key))); }

  std::vector<absl::StatusOr<Entry>> GetAll(std::span<const std::string> keys) {
    std::vector<std::string> subjects;
    for (const std::string& key : keys) subjects.push_back(SubjectOf(key));
    std::vector<absl::StatusOr<Entry>> entries;
    for (auto& message : streams_.LastOfEach(stream_, subjects)) entries.push_back(ToEntry(std::move(message)));
    return entries;
  }

  // Without repetition.
  absl::StatusOr<Entry> GetOnce(std::string_view key, absl::Duration limit) {
    return ToEntry(streams_.LastOnce(stream_, SubjectOf(key), limit));
  }

  // Whatever was there.
  absl::StatusOr<uint64_t> Put(std::string_view key, std::string value) {
    return streams_.Publish({SubjectOf(key), std::move(value), {}});
  }

  // Only if the key's revision is still `expected`, 0 for none at all; ABORTED otherwise. Returns the new one. Asks
  // again while the servers do not answer and `more` (null: the calls' limit) allows; a value that is then found to be
  // there has been written.
  absl::StatusOr<uint64_t> Update(std::string_view key, std::string value, uint64_t expected,
                                  const std::function<bool()>& more = nullptr) {
    const NatsRequest request = WithExpected(SubjectOf(key), std::move(value), expected);
    int asked = 0;
    const auto ask = [&] {
      ++asked;
      return streams_.PublishOnce(request);
    };
    absl::StatusOr<uint64_t> revision = more ? Streams::WhileUnavailable(ask, more) : streams_.WithinLimit(ask);
    if (!absl::IsAborted(revision.status()) || asked == 1) return revision;
    // An earlier attempt may have been stored although its answer was lost.
    ASSIGN_OR_RETURN(const Entry now, Get(key));
    if (now.value == request.content) return now.revision;
    return revision;
  }

  struct Change {
    std::string key;
    std::string value;
    uint64_t expected = 0;
  };
  // Many updates of different keys at once; each ends as Update.
  std::vector<absl::StatusOr<uint64_t>> UpdateAll(std::span<const Change> changes) {
    std::vector<NatsRequest> requests;
    for (const Change& change : changes) {
      requests.push_back(WithExpected(SubjectOf(change.key), change.value, change.expected));
    }
    return streams_.PublishAll(requests);
  }

  struct Revision {
    std::string key;
    uint64_t revision = 0;
  };
  // Removes values without a trace: those that still have that revision. False where that is not so.
  std::vector<absl::StatusOr<bool>> RemoveAll(std::span<const Revision> revisions) {
    // A key has one message, the latest: an earlier one is gone.
    std::vector<uint64_t> sequences;
    for (const Revision& revision : revisions) sequences.push_back(revision.revision);
    return streams_.Remove(stream_, sequences);
  }

  absl::StatusOr<bool> Remove(const Revision& revision) { return RemoveAll(std::span(&revision, 1)).front(); }

  const std::string& stream() const { return stream_; }
  // The subject of a key, with wildcards where it has them, and the key of a subject.
  std::string SubjectOf(std::string_view key) const { return prefix_ + std::string(key); }
  std::string_view KeyOf(std::string_view subject) const { return subject.substr(prefix_.size()); }

 private:
  static absl::StatusOr<Bucket::Entry> ToEntry(absl::StatusOr<StoredMessage> message) {
    if (!message.ok()) return message.status();
    return Bucket::Entry{std::move(message->content), message->sequence};
  }

  Streams& streams_;
  const std::string stream_;
  const std::string prefix_;
};

}  // namespace flair::orchestrator
