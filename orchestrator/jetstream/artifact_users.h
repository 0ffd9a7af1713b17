// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/store/v1/job_record.pb.h"
#include "orchestrator/jetstream/queue_parts.h"
#include "worker_runtime/executor/executor.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {

// The users of each artifact. A user is a job without a batch, or a batch on behalf of all its jobs, which are deleted
// together. A run becomes a user of an artifact before it stores or reuses it. A deletion removes the user, and then
// deletes only what has no user and was stored before that (ArtifactStore::Mark). An artifact that is cached under a
// key of results has a user that names the key. Errors as Streams. Thread-safe.
class ArtifactUsers {
 public:
  explicit ArtifactUsers(QueueParts& parts) : parts_(parts) {}

  // An artifact and the key of results under which it is cached; empty if it is not.
  struct Use {
    std::string artifact_id;
    std::string result_key;
  };
  using User = store::v1::ArtifactUsers::User;

  // Makes `user` one of the users of these. Returns the artifacts that nobody used before.
  absl::StatusOr<std::vector<std::string>> Add(std::span<const Use> uses, const User& user) {
    std::vector<std::string> ids;
    for (const Use& use : uses) ids.push_back(use.artifact_id);
    return Select(ids, [&](size_t i) { return AddUser(uses[i], user); });
  }

  // Removes the user from these. Returns those without any user left, which are no longer cached. A repeated call
  // returns them again.
  absl::StatusOr<std::vector<std::string>> Remove(std::span<const std::string> artifact_ids,
                                                  const std::string& user_id) {
    return Select(artifact_ids, [&](size_t i) { return RemoveUser(artifact_ids[i], user_id); });
  }

  // Whether one of the artifact's users is of that owner.
  absl::StatusOr<bool> IsOwnedBy(const std::string& owner_token, const std::string& artifact_id) {
    ASSIGN_OR_RETURN(const Known known, Read(artifact_id));
    return std::ranges::any_of(known.users.users(),
                               [&](const User& user) { return user.owner_token() == owner_token; });
  }

 private:
  // Above this many users an artifact is never deleted: the value would not fit into a message.
  static constexpr int kMostUsers = 1000;
  // Artifacts that are looked up at once.
  static constexpr int kAtOnce = 8;

  static std::string UsersKey(const std::string& artifact_id) { return "users." + artifact_id; }

  // False when there is nothing to add.
  static bool AddTo(store::v1::ArtifactUsers& users, const User& user, const std::string& result_key) {
    bool changed = false;
    const bool is_there =
        std::ranges::any_of(users.users(), [&](const User& known) { return known.id() == user.id(); });
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

  struct Known {
    store::v1::ArtifactUsers users;
    // 0 when nobody uses it.
    uint64_t revision = 0;
  };
  absl::StatusOr<Known> Read(const std::string& artifact_id) {
    ASSIGN_OR_RETURN(const std::optional<Bucket::Entry> entry, IfFound(parts_.index.Get(UsersKey(artifact_id))));
    if (!entry.has_value()) return Known();
    Known known{{}, entry->revision};
    if (known.users.ParseFromString(entry->value)) return known;
    return DataLoss("the queue's record of the users of artifact {} is damaged", artifact_id);
  }

  // False if another process has changed it meanwhile.
  absl::StatusOr<bool> Write(const std::string& artifact_id, const Known& known) {
    const absl::Status written =
        parts_.index.Update(UsersKey(artifact_id), runtime::CanonicalBytes(known.users), known.revision).status();
    if (!written.ok() && !absl::IsAborted(written)) return written;
    return written.ok();
  }

  // Those of the artifacts for which `select(i)` says true; several at once.
  absl::StatusOr<std::vector<std::string>> Select(std::span<const std::string> artifact_ids,
                                                  const std::function<absl::StatusOr<bool>(size_t i)>& select) {
    std::vector<absl::StatusOr<bool>> answers(artifact_ids.size(), false);
    (void)runtime::ForEach({.thread_count = kAtOnce, .check_alive = {}}, static_cast<int>(artifact_ids.size()),
                           [&](int i) { answers[static_cast<size_t>(i)] = select(static_cast<size_t>(i)); });
    std::vector<std::string> selected;
    for (size_t i = 0; i < answers.size(); ++i) {
      RETURN_IF_ERROR(answers[i].status());
      if (*answers[i]) selected.push_back(artifact_ids[i]);
    }
    return selected;
  }

  // Whether nobody used it before.
  absl::StatusOr<bool> AddUser(const Use& use, const User& user) {
    // Most are new.
    Known known;
    while (true) {
      if (!AddTo(known.users, user, use.result_key)) return false;
      ASSIGN_OR_RETURN(const bool written, Write(use.artifact_id, known));
      if (written) return known.revision == 0;
      ASSIGN_OR_RETURN(known, Read(use.artifact_id));
    }
  }

  // Whether nobody uses it then.
  absl::StatusOr<bool> RemoveUser(const std::string& artifact_id, const std::string& user_id) {
    while (true) {
      ASSIGN_OR_RETURN(Known known, Read(artifact_id));
      if (known.revision == 0) return true;
      auto& users = *known.users.mutable_users();
      const auto found = std::ranges::find(users, user_id, &User::id);
      if (found == users.end()) return false;
      users.erase(found);
      if (!users.empty() || known.users.kept_for_good()) {
        ASSIGN_OR_RETURN(const bool written, Write(artifact_id, known));
        if (written) return false;
        continue;
      }
      // First it leaves the cache; a run that found it before becomes its user, or sees that it has none.
      RETURN_IF_ERROR(RemoveResults(artifact_id, known));
      ASSIGN_OR_RETURN(const bool removed, parts_.index.Remove({UsersKey(artifact_id), known.revision}));
      if (removed) return true;
    }
  }

  absl::Status RemoveResults(const std::string& artifact_id, const Known& known) {
    for (const std::string& key : known.users.result_keys()) {
      ASSIGN_OR_RETURN(const std::optional<Bucket::Entry> entry, IfFound(parts_.index.Get("result." + key)));
      if (!entry.has_value()) continue;
      v1::ArtifactRef ref;
      // Another artifact may have been found since.
      if (ref.ParseFromString(entry->value) && ref.id() != artifact_id) continue;
      RETURN_IF_ERROR(parts_.index.Remove({"result." + key, entry->revision}).status());
    }
    return absl::OkStatus();
  }

  QueueParts& parts_;
};

}  // namespace flair::orchestrator
