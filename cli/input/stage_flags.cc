// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/stage_flags.h"

#include "fmt/format.h"

namespace flair::cli {

void AddStageFlags(CLI::App& command, StageFlags& flags) {
  const auto add = [&command](const char* flag, std::string* address, const char* help) {
    command.add_option(flag, *address, help)->type_name("HOST:PORT[,HOST:PORT...]")->group("Stages of others");
  };
  add("--language", flags.mutable_language(), "Describes the room instead of the own language stage");
  add("--translator", flags.mutable_translator(), "Makes constraint calls of the sentences instead of the own one");
  add("--optimizer", flags.mutable_optimizer(), "Places the objects instead of the own one; its catalogue counts");
  add("--renderer", flags.mutable_renderer(), "Draws instead of the own one");
}

absl::Status CheckStageFlags(const StageFlags& flags, const std::string& orchestrator, const LlmFlags& llm) {
  const struct {
    const char* stage;
    const std::string& address;
  } stages[] = {{"language", flags.language()},
                {"translator", flags.translator()},
                {"optimizer", flags.optimizer()},
                {"renderer", flags.renderer()}};
  for (const auto& [stage, address] : stages) {
    if (address.empty() || orchestrator.empty()) continue;
    return absl::InvalidArgumentError(fmt::format(
        "--{0} {1}: not with --orchestrator {2}, which asks the stages of its own config; set there: stages "
        "{{ {0}: \"{1}\" }}",
        stage, address, orchestrator));
  }
  if (flags.language().empty() || flags.translator().empty() || llm.Given().empty()) return absl::OkStatus();
  return absl::InvalidArgumentError(
      fmt::format("{}: not with both --language {} and --translator {}: they have their own models, and no other stage "
                  "asks one",
                  llm.Given(), flags.language(), flags.translator()));
}

}  // namespace flair::cli
