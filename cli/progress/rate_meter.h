// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>

#include "absl/time/time.h"

namespace flair::cli {

// How fast counts grow, by name, over the last `window`. A count that falls has begun anew.
class RateMeter {
 public:
  explicit RateMeter(absl::Duration window) : window_(window) {}

  // `time` is when it was so many; a look at the same time says nothing new.
  void Add(const std::string& name, absl::Time time, int64_t count) {
    std::deque<Look>& looks = looks_[name];
    if (!looks.empty() && count < looks.back().count) looks.clear();
    if (!looks.empty() && time <= looks.back().time) return;
    looks.push_back({time, count});
    while (looks.size() > 2 && time - looks[1].time >= window_) looks.pop_front();
  }

  // A second; nothing before two looks.
  std::optional<double> PerSecond(const std::string& name) const {
    const auto found = looks_.find(name);
    if (found == looks_.end() || found->second.size() < 2) return std::nullopt;
    const Look& first = found->second.front();
    const Look& last = found->second.back();
    return static_cast<double>(last.count - first.count) / absl::ToDoubleSeconds(last.time - first.time);
  }

 private:
  struct Look {
    absl::Time time;
    int64_t count;
  };
  const absl::Duration window_;
  std::map<std::string, std::deque<Look>> looks_;
};

}  // namespace flair::cli
