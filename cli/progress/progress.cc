// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/progress/progress.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

#include "cli/output/artifact_text.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "orchestrator/pipeline/stage.h"

namespace flair::cli {
namespace {

std::string Seconds(const v1::JobEvent& event) {
  const double seconds = SecondsOf(event.duration());
  return seconds < 0.0095 ? "" : fmt::format("  {:.2f} s", seconds);
}

class Quiet : public Progress {
 public:
  void See(const v1::JobEvent&) override {}
};

class JsonLines : public Progress {
 public:
  void See(const v1::JobEvent& event) override {
    fmt::print(stdout, "{}\n", ToJsonLine(event));
    std::fflush(stdout);
  }
};

// A line per stage that has ended, on a terminal with a mark and what runs now.
class Lines : public Progress {
 public:
  Lines(bool is_terminal, const std::string& model)
      : is_terminal_(is_terminal), late_(model.empty() ? "" : fmt::format(", no answer of {} yet", model)) {}
  ~Lines() override { Erase(); }

  void See(const v1::JobEvent& event) override {
    Erase();
    const auto running = std::ranges::find(running_, event.stage());
    switch (event.kind()) {
      case v1::JOB_EVENT_KIND_STAGE_STARTED:
        if (running == running_.end()) running_.push_back(event.stage());
        break;
      case v1::JOB_EVENT_KIND_STAGE_FINISHED:
      case v1::JOB_EVENT_KIND_STAGE_REUSED:
        if (running != running_.end()) running_.erase(running);
        ShowEnded(event, event.kind() == v1::JOB_EVENT_KIND_STAGE_REUSED);
        break;
      default:
        running_.clear();
    }
    ShowRunning();
  }

 private:
  void ShowEnded(const v1::JobEvent& event, bool is_reused) const {
    const std::string tail = is_reused ? "  (as before)" : Seconds(event);
    const char* const mark = is_reused ? "\x1b[36m=\x1b[0m " : "\x1b[32m✓\x1b[0m ";
    fmt::print(stderr, "{}{:<12} {}{}\n", is_terminal_ ? mark : "", event.stage(), event.message(),
               is_terminal_ ? fmt::format("\x1b[2m{}\x1b[0m", tail) : tail);
  }
  void ShowRunning() {
    if (running_.empty() || !is_terminal_) return;
    const std::string text = fmt::format("… {}", fmt::join(running_, ", "));
    fmt::print(stderr, "\x1b[2m{}\x1b[0m", text);
    std::fflush(stderr);
    const bool asks_model = orchestrator::StageIndex(running_.front()) < orchestrator::StageIndex("solve");
    note_.emplace(text, asks_model ? late_ : "");
  }
  void Erase() {
    if (note_.has_value()) fmt::print(stderr, "\r\x1b[K");
    note_.reset();
  }

  const bool is_terminal_;
  const std::string late_;
  std::vector<std::string> running_;
  // Of what runs, while it is shown.
  std::optional<SlowNote> note_;
};

}  // namespace

ProgressForm ChooseProgressForm(bool json, bool quiet) {
  if (json) return ProgressForm::kJsonLines;
  if (quiet) return ProgressForm::kQuiet;
  const char* term = std::getenv("TERM");
  const bool plain = term == nullptr || std::string(term) == "dumb" || std::getenv("NO_COLOR") != nullptr;
  return isatty(STDERR_FILENO) && !plain ? ProgressForm::kTerminal : ProgressForm::kLines;
}

std::unique_ptr<Progress> MakeProgress(ProgressForm form, const std::string& model) {
  switch (form) {
    case ProgressForm::kTerminal:
    case ProgressForm::kLines:
      return std::make_unique<Lines>(form == ProgressForm::kTerminal, model);
    case ProgressForm::kJsonLines:
      return std::make_unique<JsonLines>();
    case ProgressForm::kQuiet:
      break;
  }
  return std::make_unique<Quiet>();
}

std::string SlowText(const std::string& what, absl::Duration taken, const std::string& late) {
  return fmt::format("{}, {} s{}", what, absl::ToInt64Seconds(taken), taken >= absl::Seconds(20) ? late : "");
}

using std::chrono::seconds;

SlowNote::SlowNote(std::string what, std::string late)
    : what_(std::move(what)), late_(std::move(late)), thread_([this] { Run(); }) {}

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
    do {
      std::fprintf(stderr, "%s ...\n", what_.c_str());
    } while (!ended_.wait_for(lock, std::chrono::minutes(1), [this] { return end_; }));
    return;
  }
  do {
    const absl::Duration taken = absl::FromChrono(std::chrono::steady_clock::now() - start);
    std::fprintf(stderr, "\r\x1b[2K%s", SlowText(what_, taken, late_).c_str());
    std::fflush(stderr);
  } while (!ended_.wait_for(lock, seconds(1), [this] { return end_; }));
  std::fprintf(stderr, "\r\x1b[2K");
}

}  // namespace flair::cli
