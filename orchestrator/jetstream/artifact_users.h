// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "flair/store/v1/job_record.pb.h"
#include "orchestrator/jetstream/artifact_users.h"
#include "orchestrator/jetstream/queue_parts.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {

// Who has which artifact. A user is an job without a batch, or a batch for all of its jobs, since those are forgotten
// together. Whoever is about to store or take an artifact becomes a user of it first; whoever forgets one deletes it
// only after nobody was its user, and then only what was stored before (ArtifactStore::Mark). What is found again under
// a key of results has a user that names the key. Errors as Streams. Thread-safe.
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
  absl::StatusOr<std::vector<std::string>> Add(std::span<const Use> uses, const User& user) {
    std::vector<std::string> unused;
    std::vector<Use> left(uses.begin(), uses.end());
    while (!left.empty()) {
      // Most are new.
      std::vector<Bucket::Change> changes;
      for (const Use& use : left) {
        store::v1::ArtifactUsers users;
        AddUser(users, user, use.result_key);
        changes.push_back({UsersKey(use.artifact_id), runtime::CanonicalBytes(users), 0});
      }
      const std::vector<absl::StatusOr<uint64_t>> revisions = parts_.index.UpdateAll(changes);
      std::vector<Use> known;
      for (size_t i = 0; i < left.size(); ++i) {
        if (revisions[i].ok()) {
          unused.push_back(left[i].artifact_id);
        } else if (absl::IsAborted(revisions[i].status())) {
          known.push_back(left[i]);
        } else {
          return revisions[i].status();
        }
      }
      ASSIGN_OR_RETURN(left, AddToKnown(known, user));
    }
    return unused;
  }

  // Takes the user away from these. Returns those that nobody uses then; they are not found again any more. Again, it
  // returns them again.
  absl::StatusOr<std::vector<std::string>> Remove(std::span<const std::string> artifact_ids,
                                                  const std::string& user_id) {
    std::vector<std::string> free;
    for (size_t first = 0; first < artifact_ids.size(); first += kUsersAtOnce) {
      const auto some = artifact_ids.subspan(first, std::min(kUsersAtOnce, artifact_ids.size() - first));
      std::vector<std::string> left(some.begin(), some.end());
      // Again for those that somebody else has changed meanwhile.
      while (!left.empty()) {
        ASSIGN_OR_RETURN(left, RemoveFrom(left, user_id, free));
      }
    }
    return free;
  }

  // Whether one of the artifact's users is of that owner.
  absl::StatusOr<bool> IsOwnedBy(const std::string& owner_token, const std::string& artifact_id) {
    ASSIGN_OR_RETURN(const std::vector<Known> known, Read(std::span(&artifact_id, 1)));
    return !known.empty() && std::ranges::any_of(known.front().users.users(),
                                                 [&](const User& user) { return user.owner_token() == owner_token; });
  }

 private:
  // Above so many users an artifact is kept for good: the value would outgrow a message.
  static constexpr int kMostUsers = 1000;
  // Values in memory at once.
  static constexpr size_t kUsersAtOnce = 500;

  static std::string UsersKey(const std::string& artifact_id) { return "users." + artifact_id; }
  static std::string KeyOfResult(const std::string& result_key) { return "result." + result_key; }

  // False when there is nothing to add.
  static bool AddUser(store::v1::ArtifactUsers& users, const ArtifactUsers::User& user, const std::string& result_key) {
    bool changed = false;
    const bool is_there =
        std::ranges::any_of(users.users(), [&](const ArtifactUsers::User& known) { return known.id() == user.id(); });
    if (!is_there && users.users_size() < kMostUsers) {
      *users.add_users() = user;
      changed = true;
    } else if (!is_there && !users.kept_for_good()) {
      users.set_kept_for_good(true);
      changed = true;
    }
    const auto& keys = users.result_keys();
    if (!result_key.empty() && users.result_keys_size() < kMostUsers &&
        std::ranges::find(keys, result_key) == keys.end()) {
      users.add_result_keys(result_key);
      changed = true;
    }
    return changed;
  }

  // False when the user is none of them.
  static bool RemoveUser(store::v1::ArtifactUsers& users, const std::string& user_id) {
    auto& all = *users.mutable_users();
    const auto found = std::ranges::find(all, user_id, &ArtifactUsers::User::id);
    if (found == all.end()) return false;
    all.erase(found);
    return true;
  }

  struct Known {
    std::string artifact_id;
    store::v1::ArtifactUsers users;
    uint64_t revision = 0;
  };
  // Those that have users.
  absl::StatusOr<std::vector<Known>> Read(std::span<const std::string> artifact_ids) {
    std::vector<std::string> keys;
    for (const std::string& id : artifact_ids) keys.push_back(UsersKey(id));
    const std::vector<absl::StatusOr<Bucket::Entry>> entries = parts_.index.GetAll(keys);
    std::vector<Known> known;
    for (size_t i = 0; i < entries.size(); ++i) {
      if (absl::IsNotFound(entries[i].status())) continue;
      if (!entries[i].ok()) return entries[i].status();
      Known& found = known.emplace_back(Known{artifact_ids[i], {}, entries[i]->revision});
      if (!found.users.ParseFromString(entries[i]->value)) {
        return absl::DataLossError(
            fmt::format("the queue's record of who has artifact {} is damaged", artifact_ids[i]));
      }
    }
    return known;
  }

  // Returns those that somebody else has changed meanwhile.
  absl::StatusOr<std::vector<Use>> AddToKnown(std::span<const Use> uses, const User& user) {
    std::vector<std::string> ids;
    std::map<std::string, Use> by_id;
    for (const Use& use : uses) {
      ids.push_back(use.artifact_id);
      by_id[use.artifact_id] = use;
    }
    ASSIGN_OR_RETURN(std::vector<Known> read, Read(ids));
    std::vector<Bucket::Change> changes;
    std::vector<Use> changed;
    for (Known& known : read) {
      const auto use = by_id.extract(known.artifact_id);
      if (use.empty() || !AddUser(known.users, user, use.mapped().result_key)) continue;
      changes.push_back({UsersKey(known.artifact_id), runtime::CanonicalBytes(known.users), known.revision});
      changed.push_back(use.mapped());
    }
    // What is there no more is left in `by_id`.
    std::vector<Use> again;
    for (const auto& [id, use] : by_id) again.push_back(use);
    const std::vector<absl::StatusOr<uint64_t>> revisions = parts_.index.UpdateAll(changes);
    for (size_t i = 0; i < changed.size(); ++i) {
      if (absl::IsAborted(revisions[i].status())) {
        again.push_back(changed[i]);
      } else if (!revisions[i].ok()) {
        return revisions[i].status();
      }
    }
    return again;
  }

  // Adds those that nobody uses then to `free`; returns those that somebody else has changed meanwhile.
  absl::StatusOr<std::vector<std::string>> RemoveFrom(std::span<const std::string> artifact_ids,
                                                      const std::string& user_id, std::vector<std::string>& free) {
    ASSIGN_OR_RETURN(std::vector<Known> read, Read(artifact_ids));
    std::set<std::string> without_users(artifact_ids.begin(), artifact_ids.end());
    std::vector<Known> unused;
    std::vector<Known> used;
    for (Known& known : read) {
      without_users.erase(known.artifact_id);
      if (!RemoveUser(known.users, user_id)) continue;
      const bool stays = !known.users.users().empty() || known.users.kept_for_good();
      (stays ? used : unused).push_back(std::move(known));
    }
    free.insert(free.end(), without_users.begin(), without_users.end());
    std::vector<Bucket::Change> changes;
    for (const Known& known : used) {
      changes.push_back({UsersKey(known.artifact_id), runtime::CanonicalBytes(known.users), known.revision});
    }
    std::vector<std::string> again;
    const std::vector<absl::StatusOr<uint64_t>> revisions = parts_.index.UpdateAll(changes);
    for (size_t i = 0; i < used.size(); ++i) {
      if (revisions[i].ok()) continue;
      if (!absl::IsAborted(revisions[i].status())) return revisions[i].status();
      again.push_back(used[i].artifact_id);
    }
    // First nobody finds them any more; whoever found one before that becomes its user, or sees that it has none.
    RETURN_IF_ERROR(RemoveResults(unused));
    std::vector<Bucket::Revision> removals;
    for (const Known& known : unused) removals.push_back({UsersKey(known.artifact_id), known.revision});
    const std::vector<absl::StatusOr<bool>> removed = parts_.index.RemoveAll(removals);
    for (size_t i = 0; i < unused.size(); ++i) {
      if (!removed[i].ok()) return removed[i].status();
      (*removed[i] ? free : again).push_back(unused[i].artifact_id);
    }
    return again;
  }

  absl::Status RemoveResults(std::span<const Known> unused) {
    std::vector<std::string> keys;
    std::vector<std::string> artifact_ids;
    for (const Known& known : unused) {
      for (const std::string& key : known.users.result_keys()) {
        keys.push_back(KeyOfResult(key));
        artifact_ids.push_back(known.artifact_id);
      }
    }
    const std::vector<absl::StatusOr<Bucket::Entry>> entries = parts_.index.GetAll(keys);
    std::vector<Bucket::Revision> removals;
    for (size_t i = 0; i < keys.size(); ++i) {
      if (absl::IsNotFound(entries[i].status())) continue;
      if (!entries[i].ok()) return entries[i].status();
      v1::ArtifactRef ref;
      // Another artifact may have been found since.
      if (ref.ParseFromString(entries[i]->value) && ref.id() != artifact_ids[i]) continue;
      removals.push_back({keys[i], entries[i]->revision});
    }
    for (const absl::StatusOr<bool>& removed : parts_.index.RemoveAll(removals)) RETURN_IF_ERROR(removed.status());
    return absl::OkStatus();
  }

  QueueParts& parts_;
};

}  // namespace flair::orchestrator
