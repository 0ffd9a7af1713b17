// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/progress/slow_note.h"

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <utility>

namespace flair::cli {

using std::chrono::seconds;

SlowNote::SlowNote(std::string what) : what_(std::move(what)), thread_([this] { Run(); }) {}

SlowNote::~SlowNote() {
  {
    std::lock_guard lock(mutex_);
    end_ = true;
  }
  ended_.notify_all();
  thread_.join();
}

void SlowNote::Set(std::string what) {
  std::lock_guard lock(mutex_);
  what_ = std::move(what);
}

// std::fprintf, which does not throw in a thread when nobody reads.
void SlowNote::Run() {
  std::unique_lock lock(mutex_);
  const auto start = std::chrono::steady_clock::now();
  if (ended_.wait_for(lock, seconds(2), [this] { return end_; })) return;
  if (isatty(STDERR_FILENO) == 0) {
    std::fprintf(stderr, "%s ...\n", what_.c_str());
    ended_.wait(lock, [this] { return end_; });
    return;
  }
  do {
    const auto taken = std::chrono::duration_cast<seconds>(std::chrono::steady_clock::now() - start);
    std::fprintf(stderr, "\r\x1b[2K%s, %lld s", what_.c_str(), static_cast<long long>(taken.count()));
    std::fflush(stderr);
  } while (!ended_.wait_for(lock, seconds(1), [this] { return end_; }));
  std::fprintf(stderr, "\r\x1b[2K");
}

}  // namespace flair::cli
