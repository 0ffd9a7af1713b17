// SPDX-License-Identifier: GPL-3.0-or-later
// Flags for other machines: how servers are reached, which queue is used, which stages run elsewhere.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "cli/input/options.h"
#include "flair/config/v1/llm_config.pb.h"
#include "flair/config/v1/orchestrator_config.pb.h"
#include "flair/v1/model_call.pb.h"
#include "worker_runtime/grpc/channel.h"

namespace flair::cli {

// Which language model designs, as a person says it: flags, or a file, or both.

// The model that designs and translates; none: the handbook and the grammar do.
using OptionalLlm = std::optional<config::v1::LlmConfig>;

// How a model is reached.
class LlmFlags : public Options {
 public:
  explicit LlmFlags(CLI::App& command);

  // The first of the flags that is given, such as "--llm"; empty when none is.
  std::string Given() const;
  // The file that --llm names; empty when none is given.
  const std::string& file() const { return file_; }
  // The value given for a field of LlmConfig; null when it was not given.
  const std::string* ValueOf(std::string_view field) const;

 private:
  std::string& file_;
  std::map<std::string_view, const std::string*> values_;  // by the fields that they set
};

// The config of the file, else of the file that $FLAIR_LLM names, with the flags over it; nothing when there is
// neither. Flags that replay go before a file that records, and the other way round. INVALID_ARGUMENT names file, line
// and field, or the flag, and says what would be right; also for a variable of the environment that is not set.
// NOT_FOUND and FAILED_PRECONDITION for files that cannot be read.
absl::StatusOr<OptionalLlm> ReadLlmFlags(const LlmFlags& flags);

// INVALID_ARGUMENT when `config` has no price for its model, so that a limit in US dollars would never be reached.
absl::Status CheckLimits(const v1::ModelOptions& limits, const config::v1::LlmConfig& config);

// The model of a design and what may be asked of it: ReadLlmFlags and CheckLimits; nothing when the services of
// `orchestrator` design, which have their own. INVALID_ARGUMENT for flags that then have no meaning.
absl::StatusOr<OptionalLlm> ReadDesignModel(const LlmFlags& flags, const v1::ModelOptions& limits,
                                            const std::string& orchestrator);

class LlmFlags;

// Adds --tls, --tls-authority, --tls-certificate and --tls-key to every command that takes the address of a server, and
// --token-file and --allow-insecure to those that take that of an orchestrator. After all commands, once: one process
// runs one command, and reaches all servers that it is told of in one way.
void AddConnectionFlags(CLI::App& program);

// As the flags and the environment say. INVALID_ARGUMENT names the flag or variable, the file and what is wrong with
// it. Stages on other servers are not told the token; without one, plain text goes to any machine.
absl::StatusOr<runtime::ChannelOptions> StageConnection();
absl::StatusOr<runtime::ChannelOptions> OrchestratorConnection();

// Where jobs wait: a queue in NATS JetStream; in the local store when `address` is empty.
struct EngineFlags : Options {
  explicit EngineFlags(CLI::App& command);
  std::string& address =
      Text("--engine ADDRESS",
           "Use the queue of these NATS servers, such as nats://127.0.0.1:4222, or tls://; separated by commas");
  std::string& queue = Text("--queue NAME", "Name of the queue there, for several on the same servers (flair)");
  std::string& artifacts =
      Text("--artifacts ADDRESS", "Where its orchestrators keep artifacts: jetstream: or folder:PATH (jetstream:)");
  int replica_count = 0;
};

// INVALID_ARGUMENT when the engine is given beside the orchestrator that would have to use it, or no engine beside what
// belongs to one.
absl::Status CheckEngineFlags(const EngineFlags& flags, const std::string& orchestrator);

// Tells an orchestrator of this process.
void SetEngine(const EngineFlags& flags, config::v1::OrchestratorConfig& config);

// The local store: $FLAIR_HOME, else $XDG_DATA_HOME/flair, else ~/.local/share/flair.
std::string DefaultStorePath();

// Which stages run elsewhere, and what the language stage of this process reads.
struct StageChoice {
  config::v1::StageAddresses addresses;  // an empty address: the stage runs in this process
  std::vector<std::string> handbooks;    // folders laid over the handbook of the own language stage, in this order
  std::string asset_folder;              // of the own renderer; empty: none
};
struct StageFlags : Options, StageChoice {
  explicit StageFlags(CLI::App& command);
};

// INVALID_ARGUMENT when stages, handbooks or assets are given that the orchestrator or the stage elsewhere would not
// use, or a model that none of the own stages would ask.
absl::Status CheckStageFlags(const StageChoice& flags, const std::string& orchestrator, const LlmFlags& llm);

// What a command that got `status` from the orchestrator at `address` ends with: when nobody answered there or not in
// time, UNAVAILABLE with the address, why, and what to do; `status` itself otherwise.
absl::Status NoOrchestrator(const absl::Status& status, const std::string& address);

}  // namespace flair::cli
