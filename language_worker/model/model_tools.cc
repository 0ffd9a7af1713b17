// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/model/model_tools.h"

#include <fmt/format.h>

#include <utility>

#include "worker_runtime/files/files.h"

namespace flair::language {

std::vector<llm::PromptSpec> LanguagePrompts() {
  std::vector<llm::PromptSpec> prompts = llm::RepairPrompts();
  const std::vector<llm::PromptSpec> steps = {
      {"system", {}, {}},
      {"room", {"brief"}, {"brief"}},
      {"zones", {"brief", "room", "zone_count", "wanted_zones"}, {"brief", "room", "wanted_zones"}},
      {"floor_objects", {"brief", "room", "zones", "area_m2"}, {"brief", "room", "zones"}},
      {"tertiaries", {"brief", "room", "objects", "count"}, {"brief", "objects"}},
      {"style", {"brief", "room", "objects"}, {"brief", "objects"}},
      {"intra", {"brief", "room", "objects"}, {"room", "objects"}},
      {"inter", {"brief", "room", "objects"}, {"objects"}},
      {"cleaning", {"sentences"}, {"sentences"}}};
  prompts.insert(prompts.end(), steps.begin(), steps.end());
  return prompts;
}

std::filesystem::path DefaultPromptsFolder() {
  return runtime::InstalledFolder("prompts/language", FLAIR_LANGUAGE_PROMPTS_FOLDER);
}

llm::Question MakeQuestion(const ModelTools& tools, std::string step, std::string_view prompt,
                           const llm::PromptValues& values, const google::protobuf::Message& answer) {
  return {.step = std::move(step),
          .system = tools.prompts.Fill("system", {}),
          .text = tools.prompts.Fill(prompt, values),
          .answer = &answer};
}

absl::Status BothFailed(const absl::Status& first, const absl::Status& second) {
  return absl::Status(first.code(), fmt::format("{}; {}", std::string(first.message()), std::string(second.message())));
}

absl::Status UnusableResult(std::string_view step, const absl::Status& status) {
  return absl::DataLossError(fmt::format("step \"{}\": what the model answered makes no good artifact: {}", step,
                                         std::string(status.message())));
}

}  // namespace flair::language
