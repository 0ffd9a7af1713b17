// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/model/model_tools.h"

#include <fmt/format.h>

#include <utility>

#include "language_worker/handbook/rooms/describe_room.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::language {
namespace {

// Leaves room for a number behind it: ids have at most 64 characters.
constexpr size_t kLongestBase = 50;

std::string BaseOf(std::string_view name, std::string_view fallback) {
  std::string base = IdOf(PlainName(name));
  if (base == "unnamed") base = std::string(fallback);
  if (base.size() > kLongestBase) base.resize(kLongestBase);
  while (base.size() > 1 && base.back() == '_') base.pop_back();
  return base;
}

}  // namespace

std::vector<llm::PromptSpec> LanguagePrompts() {
  return {llm::RepairPrompt(),
          {"system", {}, {}},
          {"room", {"brief"}, {"brief"}},
          {"zones", {"brief", "room", "zone_count", "wanted_zones"}, {"brief", "room", "wanted_zones"}},
          {"floor_objects", {"brief", "room", "zones", "area_m2"}, {"brief", "room", "zones"}},
          {"tertiaries", {"brief", "room", "objects", "count"}, {"brief", "objects"}},
          {"style", {"brief", "room", "objects"}, {"brief", "objects"}},
          {"intra", {"brief", "room", "objects"}, {"room", "objects"}},
          {"inter", {"brief", "room", "objects"}, {"objects"}},
          {"cleaning", {"sentences"}, {"sentences"}}};
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

absl::Status CheckResult(std::string_view step, const absl::Status& status) {
  if (status.ok()) return status;
  return DataLoss("step \"{}\": what the model answered makes no good artifact: {}", step, status.message());
}

std::string IdMaker::Make(std::string_view name, std::string_view fallback) { return MakeLike(BaseOf(name, fallback)); }

std::string IdMaker::MakeLike(const std::string& id) {
  if (taken_.insert(id).second) return id;
  for (int number = 2;; ++number) {
    std::string numbered = fmt::format("{}_{}", id, number);
    if (taken_.insert(numbered).second) return numbered;
  }
}

std::vector<std::string> IdMaker::MakeSeveral(std::string_view name, int count, std::string_view fallback) {
  if (count == 1) return {Make(name, fallback)};
  std::vector<std::string> ids;
  const std::string base = BaseOf(name, fallback);
  for (int number = 1; static_cast<int>(ids.size()) < count; ++number) {
    std::string id = fmt::format("{}_{}", base, number);
    if (taken_.insert(id).second) ids.push_back(std::move(id));
  }
  return ids;
}

}  // namespace flair::language
