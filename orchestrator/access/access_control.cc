// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/access/access_control.h"

#include <fmt/format.h>
#include <openssl/crypto.h>

#include <cmath>

#include "absl/strings/match.h"
#include "worker_runtime/config/config_reader.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

constexpr absl::Duration kLookAfter = absl::Seconds(1);

// When the day "2027-12-31" is over; nothing for what is no day.
std::optional<absl::Time> EndOf(const std::string& day) {
  absl::Time begin;
  if (day.size() != 10 || !absl::ParseTime("%Y-%m-%d", day, absl::UTCTimeZone(), &begin, nullptr)) return std::nullopt;
  return begin + absl::Hours(24);
}
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

constexpr size_t kNameLength = 64;
constexpr size_t kDigestLength = 64;

bool IsName(std::string_view name) {
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
           c == '.';
  };
  return !name.empty() && name.size() <= kNameLength && std::ranges::all_of(name, allowed);
}

// Not quoted in messages when it is none: it may be the token itself, put in the wrong place.
bool IsDigest(std::string_view digest) {
  const auto hex = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
  return digest.size() == kDigestLength && std::ranges::all_of(digest, hex);
}

bool SameRights(const config::v1::TokenEntry& a, const config::v1::TokenEntry& b) {
  return a.open_job_limit() == b.open_job_limit() && a.calls_per_minute_limit() == b.calls_per_minute_limit() &&
         a.operator_() == b.operator_();
}

void CheckEntry(const config::v1::TokenEntry& entry, const std::string& path, runtime::ConfigChecker& checker) {
  if (!IsName(entry.name())) {
    checker.Report(path + ".name",
                   fmt::format("expected 1 to {} letters, digits, \"-\", \"_\" and \".\"", kNameLength));
  }
  if (!IsDigest(entry.sha256())) {
    checker.Report(path + ".sha256",
                   "expected the SHA-256 of a token, 64 digits 0-9 a-f, as \"flair token new\" prints it");
  }
  if (!entry.last_day().empty() && !EndOf(entry.last_day()).has_value()) {
    checker.Report(path + ".last_day", fmt::format("\"{}\" is no day; expected one such as \"2027-12-31\"",
                                                   entry.last_day().substr(0, 20)));
  }
  if (entry.open_job_limit() != 0) checker.Range(path + ".open_job_limit", entry.open_job_limit(), 1, 1000000);
  if (entry.calls_per_minute_limit() != 0) {
    checker.Range(path + ".calls_per_minute_limit", entry.calls_per_minute_limit(), 1, 1000000);
  }
}

void Check(const config::v1::TokenList& list, runtime::ConfigChecker& checker) {
  if (list.tokens().empty()) checker.Report("tokens", "there are none, so nobody could call; add one");
  std::map<std::string, int> digests;
  std::map<std::string, int> names;
  for (int i = 0; i < list.tokens_size(); ++i) {
    const config::v1::TokenEntry& entry = list.tokens(i);
    const std::string path = fmt::format("tokens[{}]", i);
    CheckEntry(entry, path, checker);
    const auto [twin, new_digest] = digests.try_emplace(entry.sha256(), i);
    if (!new_digest) checker.Report(path + ".sha256", fmt::format("is also that of tokens[{}]", twin->second));
    const auto [same, new_name] = names.try_emplace(entry.name(), i);
    if (!new_name && !SameRights(entry, list.tokens(same->second))) {
      checker.Report(path,
                     fmt::format("has other limits or rights than tokens[{}], which has the same name", same->second));
    }
  }
}

// Of what is in no file.
class Problems final : public runtime::ConfigChecker {
 public:
  void Report(std::string_view path, std::string_view problem) override {
    text_ += fmt::format("{}{}: {}", text_.empty() ? "" : "\n", path, problem);
  }
  absl::Status status() const { return text_.empty() ? absl::OkStatus() : absl::InvalidArgumentError(text_); }

 private:
  std::string text_;
};

}  // namespace

absl::Status Caller::CheckOpenJobs(int64_t open, int64_t more) const {
  if (open_job_limit == 0 || open + more <= open_job_limit) return absl::OkStatus();
  return ResourceExhausted(
      "{} of your jobs are waiting or running; {} more would exceed the limit of {} for \"{}\"; try again later", open,
      more, open_job_limit, name);
}

absl::Status Caller::CheckOperator(std::string_view what) const {
  if (sees_all) return absl::OkStatus();
  return absl::PermissionDeniedError(fmt::format("{}: only for operators, which \"{}\" is not", what, name));
}

absl::StatusOr<std::unique_ptr<AccessControl>> AccessControl::Open(const std::string& tokens_path,
                                                                   const runtime::Clock& clock,
                                                                   std::shared_ptr<spdlog::logger> logger) {
  std::unique_ptr<AccessControl> access(new AccessControl(tokens_path, clock, std::move(logger)));
  if (tokens_path.empty()) return access;
  // Before the file is read: what is written meanwhile is read again.
  access->stamp_ = runtime::FileStamp::Of(tokens_path);
  access->looked_at_ = clock.Elapsed();
  ASSIGN_OR_RETURN(access->list_, ReadTokenList(tokens_path));
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
    return absl::UnauthenticatedError("this orchestrator does not know the token; it may have been replaced");
  }
  if (!entry->last_day().empty() && clock_.Now() >= EndOf(entry->last_day())) {
    return absl::UnauthenticatedError(
        fmt::format("the token of \"{}\" was good until {}; ask for a new one", entry->name(), entry->last_day()));
  }
  const int limit = entry->calls_per_minute_limit();
  if (limit == 0) return CallerOf(*entry);
  auto rate = rates_.try_emplace(entry->name(), limit, clock_.Elapsed()).first;
  if (rate->second.per_minute() != limit) rate->second = RateLimit(limit, clock_.Elapsed());
  const absl::Duration wait = rate->second.Take(clock_.Elapsed());
  if (wait == absl::ZeroDuration()) return CallerOf(*entry);
  return ResourceExhausted("\"{}\" has made the {} calls a minute that it may; try again in {} s", entry->name(), limit,
                           std::ceil(absl::ToDoubleSeconds(wait)));
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
    logger_->error("tokens_path: the previous tokens stay in use: {}", std::string(list.status().message()));
    return;
  }
  list_ = *std::move(list);
  logger_->info("tokens_path: reloaded {} tokens from {}", list_.tokens_size(), path_);
}

absl::Status CheckTokenList(const config::v1::TokenList& list) {
  Problems problems;
  Check(list, problems);
  return problems.status();
}

absl::StatusOr<config::v1::TokenList> ReadTokenList(const std::string& path) {
  config::v1::TokenList list;
  RETURN_IF_ERROR(runtime::ReadConfigFile(path, list, [&](runtime::ConfigChecker& checker) { Check(list, checker); }));
  return list;
}

}  // namespace flair::orchestrator
