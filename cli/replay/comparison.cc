// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/replay/comparison.h"

#include <google/protobuf/text_format.h>
#include <google/protobuf/util/message_differencer.h>

#include <algorithm>

#include "absl/strings/ascii.h"
#include "absl/strings/str_join.h"
#include "cli/output/text.h"
#include "fmt/format.h"
#include "nlohmann/json.hpp"
#include "orchestrator/pipeline/stage.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {

namespace {

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
  if (artifact.has_preview()) artifact.mutable_preview()->set_image(WithoutNotes(artifact.preview().image()));
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
  std::vector<FieldDifference> differences;
  const google::protobuf::Descriptor& producer = *v1::Producer::descriptor();
  for (int i = 0; i < producer.field_count(); ++i) {
    v1::Producer one;
    v1::Producer other;
    const auto& reflection = *one.GetReflection();
    reflection.SetString(&one, producer.field(i), reflection.GetString(first.producer(), producer.field(i)));
    reflection.SetString(&other, producer.field(i), reflection.GetString(second.producer(), producer.field(i)));
    auto found = FirstDifference(one, other);
    if (!found.has_value()) continue;
    found->path = "producer." + found->path;
    differences.push_back(*std::move(found));
  }
  v1::Artifact one;
  v1::Artifact other;
  one.set_options_digest(first.options_digest());
  other.set_options_digest(asked ? first.options_digest() : second.options_digest());
  if (auto found = FirstDifference(one, other); found.has_value()) differences.push_back(*std::move(found));
  one.Clear();
  other.Clear();
  *one.mutable_model_calls() = first.model_calls();
  *other.mutable_model_calls() = second.model_calls();
  if (auto found = FirstDifference(one, other); found.has_value()) differences.push_back(*std::move(found));
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

namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::util::MessageDifferencer;

constexpr size_t kShownLength = 80;

std::string Shortened(std::string text) {
  if (text.size() <= kShownLength) return text;
  size_t end = kShownLength - 3;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return text.substr(0, end) + "...";
}

// One value of a field; `index` is -1 for fields that are no lists.
std::string ValueText(const Message& message, const FieldDescriptor& field, int index) {
  if (field.type() == FieldDescriptor::TYPE_BYTES) {
    const google::protobuf::Reflection& reflection = *message.GetReflection();
    const std::string bytes =
        index < 0 ? reflection.GetString(message, &field) : reflection.GetRepeatedString(message, &field, index);
    return fmt::format("{} bytes", bytes.size());
  }
  google::protobuf::TextFormat::Printer printer;
  printer.SetSingleLineMode(true);
  printer.SetUseUtf8StringEscaping(true);
  std::string text;
  printer.PrintFieldValueToString(message, &field, index, &text);
  if (field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) text = "{ " + text + "}";
  return Shortened(text);
}

using FieldPath = std::vector<MessageDifferencer::SpecificField>;

// Keeps the first difference and counts them all.
class FirstOnly final : public MessageDifferencer::Reporter {
 public:
  const std::optional<FieldDifference>& found() const { return found_; }

  void ReportAdded(const Message&, const Message& second, const FieldPath& path) override {
    if (See(path)) found_->second = ValueAt(second, path, true);
  }
  void ReportDeleted(const Message& first, const Message&, const FieldPath& path) override {
    if (See(path)) found_->first = ValueAt(first, path, false);
  }
  void ReportModified(const Message& first, const Message& second, const FieldPath& path) override {
    // After the fields of a message, the message itself is reported, too.
    if (path.back().field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE || !See(path)) return;
    found_->first = ValueAt(first, path, false);
    found_->second = ValueAt(second, path, true);
  }

 private:
  bool See(const FieldPath& path) {
    const bool is_first = !found_.has_value();
    if (is_first) found_ = FieldDifference{PathText(path), "none", "none", 0};
    ++found_->field_count;
    return is_first;
  }

  static std::string PathText(const FieldPath& path) {
    std::string text;
    for (const MessageDifferencer::SpecificField& step : path) {
      if (step.field == nullptr) continue;
      text += (text.empty() ? "" : ".") + step.field->name();
      if (step.field->is_repeated()) text += fmt::format("[{}]", std::max(step.index, step.new_index));
    }
    return text;
  }

  // The reporter is given the messages that the last field of the path belongs to.
  static std::string ValueAt(const Message& message, const FieldPath& path, bool second) {
    const MessageDifferencer::SpecificField& last = path.back();
    if (!last.field->is_repeated()) return ValueText(message, *last.field, -1);
    return ValueText(message, *last.field, second ? last.new_index : last.index);
  }

  std::optional<FieldDifference> found_;
};

std::optional<FieldDifference> Compare(const Message& first, const Message& second,
                                       const std::vector<std::string>& without) {
  MessageDifferencer differencer;
  for (const std::string& name : without) {
    const FieldDescriptor* field = first.GetDescriptor()->FindFieldByName(name);
    if (field != nullptr) differencer.IgnoreField(field);
  }
  FirstOnly reporter;
  differencer.ReportDifferencesTo(&reporter);
  differencer.Compare(first, second);
  return reporter.found();
}

}  // namespace

std::string FieldDifference::InWords() const {
  // Two pictures of one size may differ.
  if (first == second) return fmt::format("{}: {}, other content", path, first);
  return fmt::format("{}: {} -> {}", path, first, second);
}

std::optional<FieldDifference> FirstDifference(const Message& first, const Message& second,
                                               const std::vector<std::string>& aside) {
  std::optional<FieldDifference> found = Compare(first, second, aside);
  if (!found.has_value() && !aside.empty()) found = Compare(first, second, {});
  return found;
}

}  // namespace flair::cli
