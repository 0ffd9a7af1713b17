// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <mutex>
#include <set>
#include <string>

namespace flair::orchestrator {

// Briefs (see BriefDigest) of which something was found out that holds until it is forgotten: what is found out before,
// and told after, is not taken. Remembers a few thousand. Thread-safe.
class BriefSet {
 public:
  // To be asked before looking.
  int64_t generation();
  // What was found out since then.
  void Add(const std::string& brief, int64_t generation);
  bool Contains(const std::string& brief);
  void Forget(const std::string& brief);
  void ForgetAll();

 private:
  std::mutex mutex_;
  int64_t generation_ = 0;
  std::set<std::string> briefs_;
};

}  // namespace flair::orchestrator
