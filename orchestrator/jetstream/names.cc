// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/jetstream/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "absl/strings/ascii.h"
#include "absl/strings/str_split.h"
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

std::string WriteNotice(const Notice& notice) {
  return fmt::format("{} {} {}", static_cast<char>(notice.kind), notice.subject, notice.batch_id);
}

Notice ReadNotice(std::string_view text) {
  const std::vector<std::string> parts = absl::StrSplit(absl::string_view(text.data(), text.size()), ' ');
  if (parts.size() != 3 || parts[0].size() != 1) return {Notice::Kind{}, "", ""};
  return {static_cast<Notice::Kind>(parts[0][0]), parts[1], parts[2]};
}

}  // namespace flair::orchestrator
