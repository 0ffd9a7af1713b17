// SPDX-License-Identifier: GPL-3.0-or-later
// Which language model designs, as a person says it: flags, or a file, or both.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "cli/input/options.h"
#include "flair/config/v1/llm_config.pb.h"
#include "flair/v1/model_call.pb.h"

namespace flair::cli {

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

}  // namespace flair::cli
