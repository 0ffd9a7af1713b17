// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/engine_flags.h"

#include "cli/input/value_checks.h"
#include "fmt/format.h"

namespace flair::cli {

void AddEngineFlags(CLI::App& command, EngineFlags& flags) {
  constexpr char kGroup[] = "Queue on other machines";
  command
      .add_option(
          "--engine", flags.address,
          "Use the queue of these NATS servers, such as nats://127.0.0.1:4222, or tls://; commas between several")
      ->type_name("ADDRESS")
      ->group(kGroup);
  command.add_option("--queue", flags.queue, "Name of the queue there, for several on the same servers (flair)")
      ->type_name("NAME")
      ->group(kGroup);
  command
      .add_option("--artifacts", flags.artifacts,
                  "Where its orchestrators keep artifacts: jetstream: or folder:PATH (jetstream:)")
      ->type_name("ADDRESS")
      ->group(kGroup);
  command
      .add_option("--replicas", flags.replica_count, "Copies of everything when the queue is first made: 1, 3, 5 (1)")
      ->type_name("N")
      ->check(OneOf({"1", "3", "5"}))
      ->group(kGroup);
}

absl::Status CheckEngineFlags(const EngineFlags& flags, const std::string& orchestrator) {
  if (!flags.address.empty() && !orchestrator.empty()) {
    return absl::InvalidArgumentError(fmt::format(
        "--engine: not with --orchestrator {}, which uses the queue of its own config; set queue.address there",
        orchestrator));
  }
  if (!flags.address.empty()) return absl::OkStatus();
  const char* flag = nullptr;
  if (!flags.queue.empty()) flag = "--queue";
  if (!flags.artifacts.empty()) flag = "--artifacts";
  if (flags.replica_count > 0) flag = "--replicas";
  if (flag == nullptr) return absl::OkStatus();
  return absl::InvalidArgumentError(
      fmt::format("{}: belongs to a queue of --engine nats://HOST:PORT; give both", flag));
}

void SetEngine(const EngineFlags& flags, config::v1::OrchestratorConfig& config) {
  if (flags.address.empty()) return;
  config.mutable_queue()->set_address(flags.address);
  config.mutable_queue()->set_name(flags.queue);
  config.mutable_queue()->set_replica_count(flags.replica_count);
  config.set_artifact_store(flags.artifacts);
}

}  // namespace flair::cli
