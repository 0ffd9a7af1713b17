// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/batch/interruption.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include "cli/exit_code.h"

namespace flair::cli {
namespace {

// Where the handler writes; signals know of no object.
std::atomic<int> signal_pipe = -1;
std::atomic<int> signal_count = 0;

constexpr char kSignal = 's';
constexpr char kEnd = 'e';

void OnSignal(int) {
  if (signal_count.fetch_add(1) > 0) ::_exit(kExitStopped);
  const ssize_t ignored = ::write(signal_pipe, &kSignal, 1);
  (void)ignored;
}

void SetHandler(void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
}

}  // namespace

Interruption::Interruption() {
  if (::pipe2(pipe_, O_CLOEXEC) != 0) return;  // then signals end the process as they always do
  signal_pipe = pipe_[1];
  signal_count = 0;
  thread_ = std::thread([this] {
    char read = kEnd;
    while (::read(pipe_[0], &read, 1) < 0) {
    }
    if (read != kSignal) return;
    by_signal_ = true;
    stop_.Cancel();
  });
  SetHandler(OnSignal);
}

Interruption::~Interruption() {
  if (!thread_.joinable()) return;
  SetHandler(SIG_DFL);
  const ssize_t ignored = ::write(pipe_[1], &kEnd, 1);
  (void)ignored;
  thread_.join();
  ::close(pipe_[0]);
  ::close(pipe_[1]);
}

}  // namespace flair::cli
