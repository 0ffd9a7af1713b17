// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "flair/store/v1/job_record.pb.h"
#include "orchestrator/jetstream/queue_parts.h"

namespace flair::orchestrator {

// Who has which artifact. A user is an job without a batch, or a batch for all of its jobs, since those are forgotten
// together. Whoever is about to store or take an artifact becomes a user of it first; whoever forgets one deletes it
// only after nobody was its user, and then only what was stored before (ArtifactStore::Mark). What is found again under
// a key of results has a user that names the key. Errors as JetStreamApi. Thread-safe.
class ArtifactUsers {
 public:
  explicit ArtifactUsers(QueueParts& parts) : parts_(parts) {}

  // An artifact and the key of results under which it is to be found; empty: under none.
  struct Use {
    std::string artifact_id;
    std::string result_key;
  };
  using User = store::v1::ArtifactUsers::User;

  // Makes `user` one of the users of these. Returns the artifacts that nobody used before.
  absl::StatusOr<std::vector<std::string>> Add(std::span<const Use> uses, const User& user);

  // Takes the user away from these. Returns those that nobody uses then; they are not found again any more. Again, it
  // returns them again.
  absl::StatusOr<std::vector<std::string>> Remove(std::span<const std::string> artifact_ids,
                                                  const std::string& user_id);

  // Whether one of the artifact's users is of that owner.
  absl::StatusOr<bool> IsOwnedBy(const std::string& owner_token, const std::string& artifact_id);

 private:
  struct Known {
    std::string artifact_id;
    store::v1::ArtifactUsers users;
    uint64_t revision = 0;
  };
  // Those that have users.
  absl::StatusOr<std::vector<Known>> Read(std::span<const std::string> artifact_ids);
  absl::StatusOr<std::vector<Use>> AddToKnown(std::span<const Use> uses, const User& user);
  // Adds those that nobody uses then to `free`; returns those that somebody else has changed meanwhile.
  absl::StatusOr<std::vector<std::string>> RemoveFrom(std::span<const std::string> artifact_ids,
                                                      const std::string& user_id, std::vector<std::string>& free);
  absl::Status RemoveResults(std::span<const Known> unused);

  QueueParts& parts_;
};

}  // namespace flair::orchestrator
