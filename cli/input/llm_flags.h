// SPDX-License-Identifier: GPL-3.0-or-later
// Which language model designs, and what it may consume, as a person says it: flags, or a file, or both.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "CLI/CLI.hpp"
#include "absl/status/statusor.h"
#include "flair/config/v1/llm_config.pb.h"
#include "flair/v1/model_call.pb.h"

namespace flair::cli {

// How a model is reached.
struct LlmFlags {
  std::string file;
  std::string model;
  std::string base_url;
  std::string api_key_env;
  std::string record;
  std::string replay;
  std::string cache;
  std::string prompts;

  // The first of the flags that is given, such as "--llm"; empty when none is.
  std::string Given() const;
};

// How a design may use it.
struct ModelFlags {
  std::optional<int> calls;
  std::optional<int64_t> tokens;
  std::optional<double> usd;
  bool stand_in = false;
  bool texts_omitted = false;
};

// Add the flags to a command; `flags` must outlive it.
void AddLlmFlags(CLI::App& command, LlmFlags& flags);
void AddModelFlags(CLI::App& command, ModelFlags& flags);

// The config of the file, else of the file that $FLAIR_LLM names, with the flags over it; nothing when there is
// neither. Flags that replay go before a file that records, and the other way round. INVALID_ARGUMENT names file, line
// and field, or the flag, and says what would be right; also for a variable of the environment that is not set.
// NOT_FOUND and FAILED_PRECONDITION for files that cannot be read.
absl::StatusOr<std::optional<config::v1::LlmConfig>> ReadLlmFlags(const LlmFlags& flags);

// INVALID_ARGUMENT when `config` has no price for its model, so that a limit in US dollars would never be reached.
absl::Status CheckLimits(const ModelFlags& flags, const config::v1::LlmConfig& config);

// The model of a design and what may be asked of it: ReadLlmFlags and CheckLimits; nothing when the services of
// `orchestrator` design, which have their own. INVALID_ARGUMENT for flags that then have no meaning.
absl::StatusOr<std::optional<config::v1::LlmConfig>> ReadDesignModel(const LlmFlags& flags, const ModelFlags& limits,
                                                                     const std::string& orchestrator);

v1::ModelOptions MakeModelOptions(const ModelFlags& flags);

}  // namespace flair::cli
