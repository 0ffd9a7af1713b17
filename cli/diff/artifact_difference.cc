// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/diff/artifact_difference.h"

#include <algorithm>

#include "cli/diff/compare_things.h"
#include "cli/diff/content_difference.h"
#include "cli/output/artifact_text.h"
#include "fmt/format.h"
#include "orchestrator/store/artifact_id.h"
#include "worker_runtime/files/files.h"

namespace flair::cli {
namespace {

void CompareBriefs(const v1::Brief& a, const v1::Brief& b, std::vector<Section>& sections) {
  AddSection(FieldsSection("brief", a, b, {"room", "zone_plan", "object_list", "constraint_list"}), sections);
  CompareRooms(a.room(), b.room(), sections);
  CompareZones(a.zone_plan(), b.zone_plan(), sections);
  CompareObjects(a.object_list(), b.object_list(), sections);
  CompareSentences(a.constraint_list(), b.constraint_list(), sections);
}

void CompareReports(const v1::Report& a, const v1::Report& b, std::vector<Section>& sections) {
  AddSection(FieldsSection("report", a, b, {"stage_timings", "diagnostics", "model_usage"}), sections);
  AddSection(FieldsSection("models", a.model_usage(), b.model_usage()), sections);
  const auto stage = [](const v1::StageTiming& timing) { return timing.stage(); };
  AddSection(CompareThings("times", a.stage_timings(), b.stage_timings(),
                           MatchThings(a.stage_timings(), b.stage_timings(), stage), stage,
                           [](const v1::StageTiming&) { return ""; }),
             sections);
}

void CompareContents(const v1::Artifact& a, const v1::Artifact& b, Difference& difference) {
  std::vector<Section>& sections = difference.sections;
  switch (a.content_case()) {
    case v1::Artifact::kBrief:
      return CompareBriefs(a.brief(), b.brief(), sections);
    case v1::Artifact::kRoom:
      return CompareRooms(a.room(), b.room(), sections);
    case v1::Artifact::kZonePlan:
      return CompareZones(a.zone_plan(), b.zone_plan(), sections);
    case v1::Artifact::kObjectList:
      return CompareObjects(a.object_list(), b.object_list(), sections);
    case v1::Artifact::kStyleSheet:
      return CompareStyles(a.style_sheet(), b.style_sheet(), sections);
    case v1::Artifact::kRawConstraintList:
    case v1::Artifact::kConstraintList: {
      const auto list = [](const v1::Artifact& artifact) -> const v1::ConstraintList& {
        return artifact.has_constraint_list() ? artifact.constraint_list() : artifact.raw_constraint_list();
      };
      return CompareSentences(list(a), list(b), sections);
    }
    case v1::Artifact::kLayoutGraph:
      return CompareGraphs(a.layout_graph(), b.layout_graph(), sections);
    case v1::Artifact::kSolvedLayout:
      return CompareLayouts(a.solved_layout(), b.solved_layout(), difference);
    case v1::Artifact::kPreview:
      return AddSection(FieldsSection("picture", a.preview(), b.preview()), sections);
    case v1::Artifact::kReport:
      return CompareReports(a.report(), b.report(), sections);
    case v1::Artifact::CONTENT_NOT_SET:
      return;
  }
}

// Who made them, of what, and how.
Section OriginSection(const v1::Artifact& a, const v1::Artifact& b) {
  Section section = FieldsSection("made by", a.producer(), b.producer());
  if (a.options_digest() != b.options_digest()) {
    section.changes.push_back(
        {Became::kChanged, "options", "others", {{"a", a.options_digest()}, {"b", b.options_digest()}}});
  }
  const auto ids = [](const v1::Artifact& artifact) {
    return std::vector<std::string>(artifact.made_from_ids().begin(), artifact.made_from_ids().end());
  };
  if (ids(a) != ids(b)) {
    section.changes.push_back({Became::kChanged, "made from", "other artifacts", {{"a", ids(a)}, {"b", ids(b)}}});
  }
  if (a.model_calls_size() != b.model_calls_size()) {
    section.changes.push_back({Became::kChanged,
                               "questions to models",
                               fmt::format("{} -> {}", a.model_calls_size(), b.model_calls_size()),
                               {{"a", a.model_calls_size()}, {"b", b.model_calls_size()}}});
  }
  return section;
}

bool IsListOfConstraints(const v1::Artifact& artifact) {
  return artifact.has_raw_constraint_list() || artifact.has_constraint_list();
}

// Without what says where it came from. Both kinds of constraint lists are one here.
std::string ContentBytes(const v1::Artifact& artifact) {
  v1::Artifact content = artifact;
  if (artifact.has_raw_constraint_list()) *content.mutable_constraint_list() = artifact.raw_constraint_list();
  content.clear_id();
  content.clear_made_from_ids();
  content.clear_producer();
  content.clear_options_digest();
  content.clear_model_calls();
  return runtime::CanonicalBytes(content);
}

}  // namespace

bool Difference::IsEmpty() const {
  return std::ranges::all_of(sections, [](const Section& section) { return section.changes.empty(); });
}

absl::StatusOr<Difference> CompareArtifacts(const v1::Artifact& a, const v1::Artifact& b) {
  if (a.content_case() != b.content_case() && !(IsListOfConstraints(a) && IsListOfConstraints(b))) {
    return absl::InvalidArgumentError(fmt::format("the first is a {}, the second a {}; give two of a kind",
                                                  KindName(orchestrator::KindOf(a)),
                                                  KindName(orchestrator::KindOf(b))));
  }
  Difference difference{.kind = orchestrator::KindOf(b)};
  difference.content_is_same = ContentBytes(a) == ContentBytes(b);
  if (!difference.content_is_same) CompareContents(a, b, difference);
  Section origin = OriginSection(a, b);
  difference.origin_is_same = origin.changes.empty();
  if (!difference.origin_is_same) difference.sections.push_back(std::move(origin));
  return difference;
}

}  // namespace flair::cli
