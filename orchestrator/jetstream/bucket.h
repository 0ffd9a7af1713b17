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
#include "orchestrator/jetstream/api.h"

namespace flair::orchestrator {

// Values by keys in a stream of JetStream, the latest of each; keys are tokens with dots between. A value is read from
// the stream's leader, so that what was written is seen by whoever asks later. Errors as JetStreamApi. Thread-safe.
class Bucket {
 public:
  struct Entry {
    std::string value;
    // Changes with each writing.
    uint64_t revision = 0;
  };

  Bucket(JetStreamApi& api, const std::string& name) : api_(api), stream_("KV_" + name), prefix_("$KV." + name + ".") {}

  // NOT_FOUND when there is none.
  absl::StatusOr<Entry> Get(std::string_view key);
  std::vector<absl::StatusOr<Entry>> GetAll(std::span<const std::string> keys);

  // Whatever was there.
  absl::StatusOr<uint64_t> Put(std::string_view key, std::string_view value);

  // Only if the key's revision is still `expected`, 0 for none at all; ABORTED otherwise. Returns the new one. Asks
  // again while the servers do not answer and `more` (null: the calls' limit) allows; a value that is then found to be
  // there has been written.
  absl::StatusOr<uint64_t> Update(std::string_view key, std::string_view value, uint64_t expected,
                                  const std::function<bool()>& more = nullptr);

  struct Change {
    std::string key;
    std::string value;
    uint64_t expected = 0;
  };
  // Many updates of different keys at once; each ends as Update.
  std::vector<absl::StatusOr<uint64_t>> UpdateAll(std::span<const Change> changes);

  struct Revision {
    std::string key;
    uint64_t revision = 0;
  };
  // Removes values without a trace: those that still have that revision. False where that is not so.
  std::vector<absl::StatusOr<bool>> RemoveAll(std::span<const Revision> revisions);
  absl::StatusOr<bool> Remove(const Revision& revision);

  // A request that writes a value only if the key has none; ABORTED when it has (JetStreamApi::PublishAll).
  NatsRequest NewRequest(std::string_view key, std::string value) const;

  // A request for a key, to ask it in one's own way, and what its answer means.
  NatsRequest GetRequest(std::string_view key) const;
  absl::StatusOr<Entry> ParseEntry(const NatsMessage& answer) const;

  const std::string& stream() const { return stream_; }
  // The subject of a key, with wildcards where it has them, and the key of a subject.
  std::string SubjectOf(std::string_view key) const { return prefix_ + std::string(key); }
  std::string_view KeyOf(std::string_view subject) const { return subject.substr(prefix_.size()); }

 private:
  JetStreamApi& api_;
  const std::string stream_;
  const std::string prefix_;
};

}  // namespace flair::orchestrator
