// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "flair/config/v1/token_list.pb.h"
#include "orchestrator/access/caller.h"
#include "orchestrator/access/rate_limit.h"
#include "spdlog/logger.h"
#include "worker_runtime/clock/clock.h"
#include "worker_runtime/files/files.h"

namespace flair::orchestrator {

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
