// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/stage_flags.h"

#include "CLI/CLI.hpp"
#include "cli/input/llm_flags.h"
#include "fmt/format.h"

namespace flair::cli {

void AddStageFlags(CLI::App& command, StageFlags& flags) {
  const auto add = [&command](const char* flag, std::string* address, const char* help) {
    command.add_option(flag, *address, help)->type_name("HOST:PORT[,HOST:PORT...]")->group("Stages of others");
  };
  add("--language", flags.addresses.mutable_language(), "Describes the room instead of the own language stage");
  add("--translator", flags.addresses.mutable_translator(),
      "Makes constraint calls of the sentences instead of the own one");
  add("--optimizer", flags.addresses.mutable_optimizer(),
      "Places the objects instead of the own one; its catalogue counts");
  add("--renderer", flags.addresses.mutable_renderer(), "Draws instead of the own one");
  command
      .add_option("--handbook", flags.handbooks,
                  "Furniture, kinds of room and styles of your own, laid over the handbook; again for more folders")
      ->type_name("DIR");
}

absl::Status CheckStageFlags(const StageFlags& flags, const std::string& orchestrator, const LlmFlags& llm) {
  const struct {
    const char* stage;
    const std::string& address;
  } stages[] = {{"language", flags.addresses.language()},
                {"translator", flags.addresses.translator()},
                {"optimizer", flags.addresses.optimizer()},
                {"renderer", flags.addresses.renderer()}};
  for (const auto& [stage, address] : stages) {
    if (address.empty() || orchestrator.empty()) continue;
    return absl::InvalidArgumentError(fmt::format(
        "--{0} {1}: not with --orchestrator {2}, which asks the stages of its own config; set there: stages "
        "{{ {0}: \"{1}\" }}",
        stage, address, orchestrator));
  }
  const std::string& language = orchestrator.empty() ? flags.addresses.language() : orchestrator;
  if (!flags.handbooks.empty() && !language.empty()) {
    return absl::InvalidArgumentError(fmt::format(
        "--handbook {}: not with {} {}, whose language worker reads its own handbook; set in its config: "
        "handbook_overlay_paths: \"{}\"",
        flags.handbooks[0], orchestrator.empty() ? "--language" : "--orchestrator", language, flags.handbooks[0]));
  }
  if (flags.addresses.language().empty() || flags.addresses.translator().empty() || llm.Given().empty())
    return absl::OkStatus();
  return absl::InvalidArgumentError(
      fmt::format("{}: not with both --language {} and --translator {}: they have their own models, and no other stage "
                  "asks one",
                  llm.Given(), flags.addresses.language(), flags.addresses.translator()));
}

}  // namespace flair::cli
