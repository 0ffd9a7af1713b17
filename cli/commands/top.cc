// SPDX-License-Identifier: GPL-3.0-or-later
// flair top: how a cluster does, live.
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <future>
#include <memory>
#include <optional>

#include "absl/time/clock.h"
#include "cli/commands/commands.h"
#include "cli/input/options.h"
#include "cli/session/session.h"
#include "cli/top/cluster_state.h"
#include "cli/top/terminal.h"
#include "fmt/format.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

struct TopArguments : Options {
  using Options::Options;
  std::string& orchestrator =
      Text("--orchestrator HOST:PORT", "Watch the cluster of this orchestrator instead of the local store");
  double& interval_seconds = Decimal("--interval S", 0.05, 3600, 2, "Seconds between updates, 0.05 to 3600 (2)");
  bool& once = Flag("--once", "Print once and exit");
  bool& json = Flag("--json", "One JSON object per line and update");
};

// Another look may work: the orchestrator is away, busy or stopping, which cancels its calls.
bool MayPass(const absl::Status& status) {
  return absl::IsUnavailable(status) || absl::IsDeadlineExceeded(status) || absl::IsResourceExhausted(status) ||
         absl::IsCancelled(status);
}

// Longer than an orchestrator itself waits for the servers of its queue, behind calls of others that wait for them too,
// so that it can say that these are silent.
constexpr absl::Duration kAnswerWithin = absl::Seconds(30);
constexpr std::chrono::milliseconds kKeysEvery(20);

class Top {
 public:
  Top(const TopArguments& arguments, Session& session)
      : arguments_(arguments),
        interval_(absl::Seconds(arguments.interval_seconds)),
        watches_cluster_(!session.embedded()),
        address_(watches_cluster_ ? session.address() : "the local store " + DefaultStorePath()),
        client_(session) {
    session.SetLimits({.patience = absl::ZeroDuration(), .answer_within = kAnswerWithin, .stop = &stop_});
  }

  absl::Status Run() {
    RETURN_IF_ERROR(Look());
    if (arguments_.json && !arguments_.once) return Stream();
    return arguments_.once || !TerminalScreen::IsThere() ? PrintOnce() : Live();
  }

 private:
  absl::Status Look() {
    ASSIGN_OR_RETURN(ClusterLook look, client_.Look());
    // This process works on nothing, and knows nothing of others that work on its store.
    if (!watches_cluster_) look.cluster.clear_orchestrators();
    state_.See(look);
    return absl::OkStatus();
  }

  // Two looks, so that there are rates.
  absl::Status PrintOnce() {
    absl::SleepFor(interval_);
    RETURN_IF_ERROR(Look());
    if (arguments_.json) {
      fmt::print("{}\n", TopJson(state_));
    } else {
      for (const std::string& line : TopText(state_, address_, "", {.width = 100})) fmt::print("{}\n", line);
    }
    return absl::OkStatus();
  }

  // One line a look, until it cannot be written or is ended.
  absl::Status Stream() {
    while (true) {
      fmt::print("{}\n", TopJson(state_));
      if (std::fflush(stdout) != 0) return absl::OkStatus();
      absl::SleepFor(interval_);
      absl::Status status = Look();
      while (MayPass(status)) {
        absl::SleepFor(interval_);
        status = Look();
      }
      if (!status.ok()) return status;
    }
  }

  absl::Status Live() {
    const bool color = std::getenv("NO_COLOR") == nullptr;
    TerminalScreen screen;
    std::string trouble;
    absl::Time next = absl::Now() + interval_;
    while (true) {
      const TerminalScreen::Size size = screen.size();
      std::vector<std::string> lines =
          TopText(state_, address_, trouble, {.width = size.width, .height = size.height - 1, .color = color});
      lines.resize(static_cast<size_t>(std::max(1, size.height - 1)));
      lines.push_back(color ? "\x1b[2mq quits\x1b[0m" : "q quits");
      screen.Show(lines);
      const TerminalScreen::Event event = screen.Wait(next - absl::Now());
      if (event == TerminalScreen::Event::kQuit) return absl::OkStatus();
      if (event == TerminalScreen::Event::kResized) continue;
      std::future<absl::Status> look = std::async(std::launch::async, [this] { return Look(); });
      while (look.wait_for(kKeysEvery) != std::future_status::ready) {
        if (screen.Wait(absl::ZeroDuration()) == TerminalScreen::Event::kQuit) stop_.Cancel();
      }
      const absl::Status status = look.get();
      if (stop_.cancelled()) return absl::OkStatus();
      if (!status.ok() && !MayPass(status)) return status;
      trouble = status.ok() ? ""
                            : fmt::format("No answer for {}: {}", ShortDuration(absl::Now() - state_.time()),
                                          std::string(status.message()));
      next = absl::Now() + interval_;
    }
  }

  const TopArguments& arguments_;
  const absl::Duration interval_;
  runtime::Cancellation stop_;
  const bool watches_cluster_;
  const std::string address_;
  ClusterClient client_;
  ClusterState state_;
};

absl::Status WatchCluster(const TopArguments& arguments) {
  config::v1::OrchestratorConfig looks_only;
  looks_only.set_takes_no_jobs(true);
  ASSIGN_OR_RETURN(const std::unique_ptr<Session> session,
                   Session::Open(arguments.orchestrator, std::nullopt, {}, looks_only));
  return Top(arguments, *session).Run();
}

}  // namespace

void AddTop(const Commands& program) {
  program.Add("top",
              "Watch a cluster or the local store live: queue, batches, orchestrators, workers. Prints once when not "
              "on a terminal.",
              WatchCluster);
}

}  // namespace flair::cli
