// SPDX-License-Identifier: GPL-3.0-or-later
// What a command shows while something runs.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

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

std::unique_ptr<Progress> MakeProgress(ProgressForm form);

// Says on standard error what goes on when it takes longer than two seconds: on a terminal with the seconds so far,
// gone when it ends; elsewhere in one line. Lives as long as the work.
class SlowNote {
 public:
  // `what` is such as "tracing 16 paths per pixel".
  explicit SlowNote(std::string what);
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
  bool end_ = false;
  std::thread thread_;
};

}  // namespace flair::cli
