// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/model/model_tools.h"

#include <fmt/format.h>

#include <utility>

#include "language_worker/handbook/rooms/describe_room.h"
#include "worker_runtime/files/files.h"

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

// Whether a length is at most so many times as large as a class gets, and at least as small as that allows.
bool IsWithin(double value_m, const hb::Extent& extent, double factor) {
  const double most_m = MostOf(extent);
  return most_m <= 0 || (value_m <= factor * most_m && value_m >= LeastOf(extent) / factor);
}

// Longer and shorter side of a class: width and depth of an object may be meant the other way round.
std::pair<const hb::Extent&, const hb::Extent&> SidesOf(const hb::Furniture& furniture) {
  const hb::Extent &width = furniture.width_m(), &depth = furniture.depth_m();
  if (width.typical() >= depth.typical()) return {width, depth};
  return {depth, width};
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

bool IsRugName(std::string_view name) {
  static const std::set<std::string, std::less<>> kRugs = {"rug",  "rugs",   "carpet",    "carpets", "mat",
                                                           "mats", "runner", "sheepskin", "doormat", "tatami"};
  const std::string words = PlainName(name);
  const size_t space = words.rfind(' ');
  const std::string last = space == std::string::npos ? words : words.substr(space + 1);
  // A table runner lies on a table, a place mat too.
  if (words.starts_with("table ") || words.starts_with("place ") || words.starts_with("desk ")) return false;
  return kRugs.contains(last);
}

std::string OddSize(const ObjectSize& size, const hb::Furniture* furniture) {
  if (furniture == nullptr) return "";
  constexpr double kFactor = 2.5;
  const auto [longer, shorter] = SidesOf(*furniture);
  const auto odd = [](double value_m, const hb::Extent& extent) {
    return value_m > 0 && !IsWithin(value_m, extent, kFactor);
  };
  if (!odd(std::max(size.width_m, size.depth_m), longer) && !odd(std::min(size.width_m, size.depth_m), shorter)) {
    return "";
  }
  return fmt::format("is {}; a {} usually measures {:g} m x {:g} m", FootprintText(size), furniture->name(),
                     furniture->width_m().typical(), furniture->depth_m().typical());
}

std::optional<llm::Fault> FootprintFault(const std::string& path, const ObjectSize& size, const FloorExtent& floor,
                                         const hb::Furniture* furniture) {
  const bool fits = std::max(size.width_m, size.depth_m) <= std::max(floor.width_m, floor.depth_m) &&
                    std::min(size.width_m, size.depth_m) <= std::min(floor.width_m, floor.depth_m);
  if (!fits) {
    return llm::Fault{path + ".width_m", fmt::format("{} is larger than the room of {:g} m x {:g} m",
                                                     FootprintText(size), floor.width_m, floor.depth_m)};
  }
  std::string odd = OddSize(size, furniture);
  if (odd.empty()) return std::nullopt;
  return llm::Fault{path + ".width_m", std::move(odd), llm::FaultKind::kDoubtful};
}

std::string FootprintText(const ObjectSize& size) { return fmt::format("{:g} m x {:g} m", size.width_m, size.depth_m); }

}  // namespace flair::language
