// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "orchestrator/access/access_control.h"
#include "worker_runtime/config/config_reader.h"

namespace flair::orchestrator {
namespace {

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
                     fmt::format("has other limits or rights than tokens[{}], but tokens of one name are one caller",
                                 same->second));
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

absl::Status CheckTokenList(const config::v1::TokenList& list) {
  Problems problems;
  Check(list, problems);
  return problems.status();
}

absl::StatusOr<config::v1::TokenList> ReadTokenList(const std::string& path) {
  config::v1::TokenList list;
  const absl::Status status =
      runtime::ReadConfigFile(path, list, [&](runtime::ConfigChecker& checker) { Check(list, checker); });
  if (!status.ok()) return status;
  return list;
}

}  // namespace flair::orchestrator
