// SPDX-License-Identifier: GPL-3.0-or-later
// What a command shows while something runs.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "absl/time/time.h"
#include "flair/v1/job.pb.h"

namespace flair::cli {

class Progress {
 public:
  virtual ~Progress() = default;
  virtual void See(const v1::JobEvent& event) = 0;
};

enum class ProgressForm {
  kTerminal,   // a line per finished stage, and what runs now
  kLines,      // a line per finished stage
  kJsonLines,  // every event as JSON on standard output
  kQuiet,
};

// The form for a command: as asked, else by whether standard error is a terminal.
ProgressForm ChooseProgressForm(bool json, bool quiet);

// `model`: the address of the language model, which is named on a terminal when a stage that asks it takes long.
std::unique_ptr<Progress> MakeProgress(ProgressForm form, const std::string& model = "");

// What a terminal shows of what has gone on for so long; `late` is added after twenty seconds.
std::string SlowText(const std::string& what, absl::Duration taken, const std::string& late);

// Says on standard error what goes on when it takes longer than two seconds: on a terminal with the seconds so far,
// gone when it ends; elsewhere in a line a minute. Lives as long as the work.
class SlowNote {
 public:
  // `what` is such as "tracing 16 paths per pixel"; `late` is added on a terminal after twenty seconds.
  explicit SlowNote(std::string what, std::string late = "");
  ~SlowNote();
  SlowNote(const SlowNote&) = delete;
  SlowNote& operator=(const SlowNote&) = delete;

  // What goes on now, such as "tile 7 of 40". Thread-safe.
  void Set(std::string what);

 private:
  void Run();

  std::mutex mutex_;
  std::condition_variable ended_;
  std::string what_;
  const std::string late_;
  bool end_ = false;
  std::thread thread_;
};

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
