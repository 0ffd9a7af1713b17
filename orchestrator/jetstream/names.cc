// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/jetstream/names.h"

#include <algorithm>

#include "absl/strings/ascii.h"
#include "worker_runtime/files/files.h"

namespace flair::orchestrator {

std::string QueueNames::Join(std::initializer_list<std::string_view> tokens) const {
  std::string subject = name_;
  for (std::string_view token : tokens) {
    subject += '.';
    subject += token;
  }
  return subject;
}

std::string OwnerToken(std::string_view owner) {
  if (owner.empty()) return "-";
  // What is a digest begins with another letter than what is a name, so that no name is another's digest.
  return IsToken(owner) && owner.size() <= 64 ? "o" + std::string(owner) : "h" + runtime::Sha256Hex(owner);
}

bool IsToken(std::string_view text) {
  return !text.empty() && text.size() <= 128 && std::ranges::all_of(text, [](char c) {
    return absl::ascii_isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_';
  });
}

std::string_view TokenAt(std::string_view subject, int place) {
  for (; place > 0; --place) {
    const size_t dot = subject.find('.');
    if (dot == std::string_view::npos) return {};
    subject.remove_prefix(dot + 1);
  }
  return subject.substr(0, subject.find('.'));
}

std::string RequestKey(const std::string& owner, RequestKind kind, const std::string& request_id,
                       const std::string& id) {
  const char* token = kind == RequestKind::kJob ? ".single." : ".batch.";
  return OwnerToken(owner) + token + runtime::Sha256Hex(request_id.empty() ? id : request_id);
}

absl::Duration LeaseOf(const config::v1::QueueConfig& config) {
  return absl::Seconds(config.has_lease_seconds() ? config.lease_seconds() : 30);
}

namespace {

// The first letter of what is sent, by NewsKind.
constexpr std::string_view kLetters = "wjhb";
static_assert(static_cast<size_t>(NewsKind::kUnknown) == kLetters.size());

}  // namespace

std::string WriteNews(const News& news) {
  return std::string(1, kLetters.at(static_cast<size_t>(news.kind))) + ' ' + news.subject + ' ' + news.batch_id;
}

News ReadNews(std::string_view text) {
  if (text.size() < 2 || text[1] != ' ') return {};
  News news;
  news.kind = static_cast<NewsKind>(std::min(kLetters.find(text[0]), kLetters.size()));
  text.remove_prefix(2);
  const size_t space = text.find(' ');
  news.subject = text.substr(0, space);
  if (space != std::string_view::npos) news.batch_id = text.substr(space + 1);
  return news;
}

}  // namespace flair::orchestrator
