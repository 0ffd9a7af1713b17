// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/replay/comparison_text.h"

#include <algorithm>

#include "absl/strings/str_join.h"
#include "fmt/format.h"
#include "nlohmann/json.hpp"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

std::string_view Verdict(const StageComparison& stage) {
  switch (stage.agreement) {
    case Agreement::kTaken:
      return "taken";
    case Agreement::kSameBytes:
      return "agrees";
    case Agreement::kSameContent:
      return "same content";
    case Agreement::kDiffers:
      return stage.asked ? "differs as asked" : "differs";
    case Agreement::kFirstOnly:
      return "missing now";
    case Agreement::kReplayOnly:
      return "new";
    case Agreement::kNeither:
      return "not reached";
  }
  return "";
}

// What happened at the stage, beside the verdict.
std::string Finding(const StageComparison& stage) {
  std::string text;
  if (stage.content.has_value()) {
    text = stage.content->InWords();
    const int more = stage.content->field_count - 1;
    if (more > 0) text += ", and " + Counted(more, "more field");
  }
  const bool made_twice = stage.agreement == Agreement::kDiffers || stage.agreement == Agreement::kSameContent;
  if (made_twice && !stage.input.empty())
    text += fmt::format("{}made from another {}", text.empty() ? "" : "; ", stage.input);
  if (stage.asked && stage.agreement == Agreement::kSameBytes) text = "although asked otherwise";
  return text;
}

// The first stage whose result is another one, though nothing else was asked of it.
const StageComparison* FirstToPart(const std::vector<StageComparison>& stages) {
  const auto found = std::ranges::find_if(stages, &StageComparison::Parts);
  return found == stages.end() ? nullptr : &*found;
}

// Why a stage may have parted that was given the same.
std::string LikelyCause(const StageComparison& stage) {
  if (stage.agreement == Agreement::kFirstOnly) return "";
  if (!stage.origin.empty()) return "; likely because of " + stage.origin.front().InWords();
  if (!stage.input.empty()) return fmt::format("; likely because its {} is another one", stage.input);
  return "; by the same program, build and configuration: it does not repeat itself";
}

nlohmann::json ToJson(const FieldDifference& difference) {
  return {{"path", difference.path},
          {"first", difference.first},
          {"replay", difference.second},
          {"field_count", difference.field_count}};
}

}  // namespace

std::string ComparisonTable(const std::vector<StageComparison>& stages) {
  std::string table;
  for (const StageComparison& stage : stages) {
    const std::string finding = Finding(stage);
    table += fmt::format("{:<12} {}", stage.stage, Verdict(stage));
    if (!finding.empty())
      table += fmt::format("{:{}}{}", "", 18 - std::min<size_t>(16, Verdict(stage).size()), finding);
    table += '\n';
    for (const FieldDifference& cause : stage.origin) {
      table += fmt::format("{:<12} {:<18}{}\n", "", "", cause.InWords());
    }
  }
  return table;
}

std::string ComparisonSummary(const std::vector<StageComparison>& stages) {
  const auto count = [&](Agreement agreement) {
    return static_cast<int>(std::ranges::count(stages, agreement, &StageComparison::agreement));
  };
  const auto asked = static_cast<int>(std::ranges::count_if(
      stages, [](const StageComparison& s) { return s.asked && s.agreement == Agreement::kDiffers; }));
  const auto parted = static_cast<int>(std::ranges::count_if(stages, &StageComparison::Parts));
  const int same = count(Agreement::kSameBytes);
  std::vector<std::string> parts;
  if (same > 0) parts.push_back(Counted(same, "stage agrees", "stages agree"));
  if (const int n = count(Agreement::kSameContent); n > 0)
    parts.push_back(Counted(n, "agrees in content only", "agree in content only"));
  if (const int n = count(Agreement::kTaken); n > 0) parts.push_back(fmt::format("{} taken", n));
  if (asked > 0) parts.push_back(Counted(asked, "differs as asked", "differ as asked"));
  if (const StageComparison* part = FirstToPart(stages); part != nullptr) {
    parts.push_back(
        fmt::format("{}, first \"{}\"{}", Counted(parted, "differs", "differ"), part->stage, LikelyCause(*part)));
  }
  return absl::StrJoin(parts, ", ");
}

std::string ComparisonJson(const std::vector<StageComparison>& stages, const std::string& first_id,
                           const std::string& replay_id) {
  nlohmann::json rows = nlohmann::json::array();
  for (const StageComparison& stage : stages) {
    nlohmann::json row = {{"stage", stage.stage}, {"verdict", Verdict(stage)}, {"asked", stage.asked}};
    if (stage.content.has_value()) row["content"] = ToJson(*stage.content);
    for (const FieldDifference& cause : stage.origin) row["origin"].push_back(ToJson(cause));
    if (!stage.input.empty()) row["input"] = stage.input;
    rows.push_back(std::move(row));
  }
  const nlohmann::json all = {{"job_id", first_id},
                              {"replay_job_id", replay_id},
                              {"agrees", AllAgree(stages)},
                              {"summary", ComparisonSummary(stages)},
                              {"stages", std::move(rows)}};
  return all.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace flair::cli
