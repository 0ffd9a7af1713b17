// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/brief_set.h"

namespace flair::orchestrator {
namespace {

// Of jobs that run, and of those that ended before they had a result.
constexpr size_t kMostBriefs = 4096;

}  // namespace

int64_t BriefSet::generation() {
  std::lock_guard lock(mutex_);
  return generation_;
}

void BriefSet::Add(const std::string& brief, int64_t generation) {
  std::lock_guard lock(mutex_);
  if (generation != generation_) return;
  if (briefs_.size() >= kMostBriefs) briefs_.clear();
  briefs_.insert(brief);
}

bool BriefSet::Contains(const std::string& brief) {
  std::lock_guard lock(mutex_);
  return briefs_.contains(brief);
}

void BriefSet::Forget(const std::string& brief) {
  std::lock_guard lock(mutex_);
  ++generation_;
  briefs_.erase(brief);
}

void BriefSet::ForgetAll() {
  std::lock_guard lock(mutex_);
  ++generation_;
  briefs_.clear();
}

}  // namespace flair::orchestrator
