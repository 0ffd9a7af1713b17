// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/access/access_control.h"

#include <fmt/format.h>
#include <openssl/crypto.h>

#include <cmath>

#include "absl/strings/match.h"
#include "worker_runtime/files/files.h"

namespace flair::orchestrator {
namespace {

constexpr absl::Duration kLookAfter = absl::Seconds(1);
constexpr size_t kSchemeLength = 7;
// Longer ones are not hashed: somebody sends them to keep us busy.
constexpr size_t kTokenLength = 1024;

// Nothing when it is no bearer token.
std::string_view TokenIn(std::optional<std::string_view> authorization) {
  if (!authorization.has_value() || authorization->size() > kTokenLength) return {};
  const absl::string_view scheme(authorization->data(), std::min(authorization->size(), kSchemeLength));
  if (!absl::EqualsIgnoreCase(scheme, "bearer ")) return {};
  return authorization->substr(kSchemeLength);
}

Caller CallerOf(const config::v1::TokenEntry& entry) {
  return {.name = entry.name(), .sees_all = entry.operator_(), .open_job_limit = entry.open_job_limit()};
}

}  // namespace

absl::StatusOr<std::unique_ptr<AccessControl>> AccessControl::Open(const std::string& tokens_path,
                                                                   const runtime::Clock& clock,
                                                                   std::shared_ptr<spdlog::logger> logger) {
  std::unique_ptr<AccessControl> access(new AccessControl(tokens_path, clock, std::move(logger)));
  if (tokens_path.empty()) return access;
  // Before the file is read: what is written meanwhile is read again.
  access->stamp_ = runtime::FileStamp::Of(tokens_path);
  access->looked_at_ = clock.Elapsed();
  absl::StatusOr<config::v1::TokenList> list = ReadTokenList(tokens_path);
  if (!list.ok()) return list.status();
  access->list_ = *std::move(list);
  return access;
}

absl::StatusOr<Caller> AccessControl::Admit(std::optional<std::string_view> authorization) {
  if (path_.empty()) return Caller();
  const std::string_view token = TokenIn(authorization);
  std::lock_guard lock(mutex_);
  Reload();
  if (token.empty()) {
    return absl::UnauthenticatedError(
        "this orchestrator asks for a token: send the metadata \"authorization: Bearer TOKEN\" (flair: --token-file "
        "FILE)");
  }
  const config::v1::TokenEntry* entry = Find(token);
  if (entry == nullptr) {
    return absl::UnauthenticatedError(
        "the token that was sent is none of this orchestrator's; it may have been replaced");
  }
  const int limit = entry->calls_per_minute_limit();
  if (limit == 0) return CallerOf(*entry);
  auto rate = rates_.try_emplace(entry->name(), limit, clock_.Elapsed()).first;
  if (rate->second.per_minute() != limit) rate->second = RateLimit(limit, clock_.Elapsed());
  const absl::Duration wait = rate->second.Take(clock_.Elapsed());
  if (wait == absl::ZeroDuration()) return CallerOf(*entry);
  return absl::ResourceExhaustedError(fmt::format("\"{}\" may make {} calls a minute and has; try again in {} s",
                                                  entry->name(), limit, std::ceil(absl::ToDoubleSeconds(wait))));
}

// Every entry is looked at, wherever the right one is.
const config::v1::TokenEntry* AccessControl::Find(std::string_view token) const {
  const std::string digest = runtime::Sha256Hex(token);
  const config::v1::TokenEntry* found = nullptr;
  for (const config::v1::TokenEntry& entry : list_.tokens()) {
    if (CRYPTO_memcmp(digest.data(), entry.sha256().data(), digest.size()) == 0) found = &entry;
  }
  return found;
}

void AccessControl::Reload() {
  if (clock_.Elapsed() - looked_at_ < kLookAfter) return;
  looked_at_ = clock_.Elapsed();
  const runtime::FileStamp stamp = runtime::FileStamp::Of(path_);
  if (stamp == stamp_) return;
  stamp_ = stamp;
  absl::StatusOr<config::v1::TokenList> list = ReadTokenList(path_);
  if (!list.ok()) {
    logger_->error("tokens_path: the tokens known before go on: {}", std::string(list.status().message()));
    return;
  }
  list_ = *std::move(list);
  logger_->info("tokens_path: {} tokens read anew from {}", list_.tokens_size(), path_);
}

}  // namespace flair::orchestrator
