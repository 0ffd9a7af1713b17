// SPDX-License-Identifier: GPL-3.0-or-later
// Who calls, what they may do, and how often.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "flair/config/v1/token_list.pb.h"
#include "spdlog/logger.h"
#include "worker_runtime/clock/clock.h"
#include "worker_runtime/files/files.h"

namespace flair::orchestrator {

// Who makes a call, and what they may do. As made: anybody, on a server without tokens, who may do everything.
struct Caller {
  // What their jobs and batches are kept under (Job.owner); empty on a server without tokens.
  std::string name;
  // Sees and does everything, whoever owns it.
  bool sees_all = true;
  // Jobs that may wait or run at once; no limit of their own when 0.
  int64_t open_job_limit = 0;

  // Whether something of `owner` is there for them. What is not is NOT_FOUND, in the words for what does not exist.
  bool MaySee(std::string_view owner) const { return sees_all || owner == name; }

  // For ListFilter.owner.
  std::optional<std::string> OwnerFilter() const { return sees_all ? std::nullopt : std::optional(name); }

  // What their request id is known by to the queue: two callers may use the same one and do not meet.
  std::string RequestKey(const std::string& request_id) const {
    return name.empty() ? request_id : name + "/" + request_id;
  }

  // OK when `more` jobs may be added to `open` ones of theirs (WorkQueue::CountOpen), else RESOURCE_EXHAUSTED.
  absl::Status CheckOpenJobs(int64_t open, int64_t more) const;

  // OK for those who see everything, else PERMISSION_DENIED, naming `what`, such as "GetCluster".
  absl::Status CheckOperator(std::string_view what) const;
};

// So many calls a minute, as a bucket that holds a minute's worth and fills evenly: bursts are taken, floods are not.
// Not thread-safe.
class RateLimit {
 public:
  RateLimit(int per_minute, absl::Duration now) : per_minute_(per_minute), filled_(per_minute), at_(now) {}

  int per_minute() const { return per_minute_; }

  // Takes one call; when none is left, says how long until one is. `now` never goes back (Clock::Elapsed).
  absl::Duration Take(absl::Duration now) {
    filled_ = std::min<double>(per_minute_, filled_ + absl::ToDoubleMinutes(now - at_) * per_minute_);
    at_ = now;
    if (filled_ < 1) return absl::Minutes((1 - filled_) / per_minute_);
    filled_ -= 1;
    return absl::ZeroDuration();
  }

 private:
  int per_minute_;
  double filled_;
  absl::Duration at_;
};

// Decides who may call, by the tokens of a file. The file is looked at again at most once a second, when somebody
// calls; one that cannot be read or is wrong is logged and changes nothing. Tokens are compared by their SHA-256 in
// constant time, and are in no message. Thread-safe.
class AccessControl {
 public:
  // Of a TokenList file; with an empty path everybody may call. Errors as ReadTokenList. The clock outlives it.
  static absl::StatusOr<std::unique_ptr<AccessControl>> Open(const std::string& tokens_path,
                                                             const runtime::Clock& clock,
                                                             std::shared_ptr<spdlog::logger> logger);

  // Who calls with that metadata "authorization" ("Bearer TOKEN"), nullopt for none. Counts the call. UNAUTHENTICATED
  // without a token that is in the file, RESOURCE_EXHAUSTED beyond the caller's calls a minute.
  absl::StatusOr<Caller> Admit(std::optional<std::string_view> authorization);

 private:
  AccessControl(std::string path, const runtime::Clock& clock, std::shared_ptr<spdlog::logger> logger)
      : path_(std::move(path)), clock_(clock), logger_(std::move(logger)) {}
  void Reload();
  const config::v1::TokenEntry* Find(std::string_view token) const;

  const std::string path_;
  const runtime::Clock& clock_;
  const std::shared_ptr<spdlog::logger> logger_;
  std::mutex mutex_;
  absl::Duration looked_at_;
  runtime::FileStamp stamp_;
  config::v1::TokenList list_;
  // By name of the caller.
  std::map<std::string, RateLimit> rates_;
};

// INVALID_ARGUMENT lists every bad field.
absl::Status CheckTokenList(const config::v1::TokenList& list);

// Reads and checks a list of tokens. NOT_FOUND when there is no such file; INVALID_ARGUMENT lists every bad field with
// its line.
absl::StatusOr<config::v1::TokenList> ReadTokenList(const std::string& path);

}  // namespace flair::orchestrator
