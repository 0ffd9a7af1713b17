// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/replay/comparison.h"

#include <google/protobuf/util/message_differencer.h>

#include <algorithm>

#include "absl/strings/ascii.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_split.h"
#include "cli/output/text.h"
#include "fmt/format.h"
#include "nlohmann/json.hpp"
#include "orchestrator/pipeline/stage.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

namespace pb = google::protobuf;
using pb::util::MessageDifferencer;

const v1::Artifact* Find(const ArtifactsByKind& artifacts, v1::ArtifactKind kind) {
  const auto found = artifacts.find(kind);
  return found == artifacts.end() ? nullptr : &found->second;
}

// A PNG without the chunks that draw nothing, which name the layout's id among other things; their types begin with a
// small letter. Other pictures, and what is no whole PNG, are as they are.
std::string WithoutNotes(const std::string& picture) {
  constexpr std::string_view kSignature("\x89PNG\r\n\x1a\n", 8);
  constexpr size_t kAroundData = 12;  // length and type before it, checksum after it
  if (!picture.starts_with(kSignature)) return picture;
  std::string drawn(kSignature);
  for (size_t at = kSignature.size(); at < picture.size();) {
    if (picture.size() - at < kAroundData) return picture;
    size_t length = 0;
    for (size_t i = 0; i < 4; ++i) length = length << 8 | static_cast<unsigned char>(picture[at + i]);
    if (length > picture.size() - at - kAroundData) return picture;
    if (absl::ascii_isupper(static_cast<unsigned char>(picture[at + 4]))) {
      drawn.append(picture, at, length + kAroundData);
    }
    at += length + kAroundData;
  }
  return drawn;
}

// Without what is another one in every job.
v1::Artifact OfAnyJob(v1::Artifact artifact) {
  if (artifact.has_preview()) {
    const std::string drawn = WithoutNotes(artifact.preview().image());
    artifact.mutable_preview()->set_image(
        fmt::format("{} bytes, {}", drawn.size(), runtime::Sha256Hex(drawn).substr(0, 8)));
  }
  if (!artifact.has_report()) return artifact;
  artifact.clear_id();
  artifact.clear_options_digest();
  v1::Report& report = *artifact.mutable_report();
  report.clear_job_id();
  report.clear_stage_timings();
  report.clear_model_usage();
  return artifact;
}

v1::Artifact ContentOf(v1::Artifact artifact) {
  artifact.clear_id();
  artifact.clear_made_from_ids();
  artifact.clear_producer();
  artifact.clear_options_digest();
  artifact.clear_model_calls();
  return artifact;
}

constexpr size_t kShownLength = 80;

std::string Shortened(std::string text) {
  return text.size() <= kShownLength ? text : text.substr(0, kShownLength - 3) + "...";
}

std::vector<FieldDifference> Differences(const pb::Message& first, const pb::Message& second,
                                         const std::vector<std::string>& without = {}) {
  MessageDifferencer differencer;
  for (const std::string& name : without) {
    const pb::FieldDescriptor* field = first.GetDescriptor()->FindFieldByName(name);
    if (field != nullptr) differencer.IgnoreField(field);
  }
  // A line for each field, texts in quotes and escaped: "modified: placements[1].x_m: 1.2 -> 1.24", "added: PATH:
  // VALUE", "ignored: PATH".
  std::string report;
  differencer.ReportDifferencesToString(&report);
  differencer.Compare(first, second);
  std::vector<FieldDifference> differences;
  for (const auto line : absl::StrSplit(report, '\n', absl::SkipEmpty())) {
    const std::vector<std::string> part = absl::StrSplit(line, absl::MaxSplits(": ", 2));
    if (part.size() < 3) continue;
    FieldDifference& found = differences.emplace_back(FieldDifference{part[1], "none", "none"});
    const bool is_text = part[2].starts_with('"');
    const size_t arrow = part[0] == "modified" ? part[2].find(is_text ? "\" -> \"" : " -> ") + is_text : part[2].size();
    if (part[0] != "added") found.first = Shortened(part[2].substr(0, arrow));
    if (part[0] != "deleted") found.second = Shortened(part[2].substr(part[0] == "added" ? 0 : arrow + 4));
  }
  if (!differences.empty()) differences.front().field_count = static_cast<int>(differences.size());
  return differences;
}

std::optional<FieldDifference> ContentDifference(const v1::Artifact& first, const v1::Artifact& second) {
  // A layout has its graph in it, whose differences are those of an earlier stage.
  if (first.has_solved_layout() && second.has_solved_layout()) {
    auto found = FirstDifference(first.solved_layout(), second.solved_layout(), {"graph"});
    if (found.has_value()) found->path = "solved_layout." + found->path;
    return found;
  }
  return FirstDifference(ContentOf(first), ContentOf(second));
}

// Other options that were asked for are no cause to tell of.
std::vector<FieldDifference> OriginDifferences(const v1::Artifact& first, const v1::Artifact& second, bool asked) {
  const auto origin = [](const v1::Artifact& artifact, const std::string& options_digest) {
    v1::Artifact made;
    *made.mutable_producer() = artifact.producer();
    made.set_options_digest(options_digest);
    *made.mutable_model_calls() = artifact.model_calls();
    return made;
  };
  std::vector<FieldDifference> differences = Differences(
      origin(first, first.options_digest()), origin(second, asked ? first.options_digest() : second.options_digest()));
  // Of the calls the first will do.
  const auto is_call = [](const FieldDifference& one) { return one.path.starts_with("model_calls"); };
  const auto call = std::ranges::find_if(differences, is_call);
  if (call != differences.end())
    differences.erase(std::remove_if(call + 1, differences.end(), is_call), differences.end());
  return differences;
}

// What is known of a stage that both jobs have run.
void CompareArtifacts(const v1::Artifact& first, const v1::Artifact& second, StageComparison& stage) {
  const v1::Artifact one = OfAnyJob(first);
  const v1::Artifact other = OfAnyJob(second);
  stage.origin = OriginDifferences(one, other, stage.asked);
  stage.content = ContentDifference(one, other);
  if (stage.content.has_value()) {
    stage.agreement = Agreement::kDiffers;
  } else if (one.id() != other.id() || !stage.origin.empty() || !stage.input.empty()) {
    stage.agreement = Agreement::kSameContent;
  } else {
    stage.agreement = Agreement::kSameBytes;
  }
}

std::string_view Verdict(const StageComparison& stage) {
  if (stage.agreement == Agreement::kDiffers && stage.asked) return "differs as asked";
  constexpr std::string_view kWords[] = {"taken",       "agrees", "same content", "differs",
                                         "missing now", "new",    "not reached"};
  return kWords[static_cast<int>(stage.agreement)];
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
  if (!stage.input.empty()) return fmt::format("; likely because its {} differs", stage.input);
  return "; by the same program, build and configuration: it is not deterministic";
}

nlohmann::json ToJson(const FieldDifference& difference) {
  return {{"path", difference.path},
          {"first", difference.first},
          {"replay", difference.second},
          {"field_count", difference.field_count}};
}

}  // namespace

bool StageComparison::Parts() const {
  return !asked && (agreement == Agreement::kDiffers || agreement == Agreement::kFirstOnly ||
                    agreement == Agreement::kReplayOnly);
}

std::vector<StageComparison> CompareStages(const v1::Job& first, const ArtifactsByKind& first_artifacts,
                                           const v1::Job& replay, const ArtifactsByKind& replay_artifacts) {
  const std::span<const orchestrator::Stage> stages = orchestrator::Stages();
  const std::vector<bool> asked = orchestrator::StagesAskedToDiffer(first.spec(), replay.spec());
  const auto begin = static_cast<size_t>(orchestrator::FirstStageOf(replay.spec().replay()));
  std::vector<StageComparison> compared;
  for (size_t i = 0; i < stages.size(); ++i) {
    // Further views are pictures of the same layout.
    if (stages[i].wanted != nullptr) continue;
    StageComparison& stage = compared.emplace_back();
    stage.stage = stages[i].name;
    stage.asked = asked[i];
    for (size_t j = 0; j < i && stage.input.empty(); ++j) {
      const bool is_input = std::ranges::find(stages[i].inputs, stages[j].output) != stages[i].inputs.end();
      const v1::Artifact* one = Find(first_artifacts, stages[j].output);
      const v1::Artifact* other = Find(replay_artifacts, stages[j].output);
      if (is_input && one != nullptr && other != nullptr && one->id() != other->id()) stage.input = stages[j].name;
    }
    const v1::Artifact* one = Find(first_artifacts, stages[i].output);
    const v1::Artifact* other = Find(replay_artifacts, stages[i].output);
    if (one != nullptr && other != nullptr && i < begin) {
      stage.agreement = Agreement::kTaken;
    } else if (one != nullptr && other != nullptr) {
      CompareArtifacts(*one, *other, stage);
    } else if (one != nullptr || other != nullptr) {
      stage.agreement = one != nullptr ? Agreement::kFirstOnly : Agreement::kReplayOnly;
    }
  }
  return compared;
}

bool AllAgree(const std::vector<StageComparison>& stages) {
  return std::ranges::none_of(stages, &StageComparison::Parts);
}

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
  return JsonText(all);
}

std::string FieldDifference::InWords() const { return fmt::format("{}: {} -> {}", path, first, second); }

std::optional<FieldDifference> FirstDifference(const pb::Message& first, const pb::Message& second,
                                               const std::vector<std::string>& aside) {
  std::vector<FieldDifference> found = Differences(first, second, aside);
  if (found.empty() && !aside.empty()) found = Differences(first, second);
  return found.empty() ? std::nullopt : std::optional(std::move(found.front()));
}

}  // namespace flair::cli
