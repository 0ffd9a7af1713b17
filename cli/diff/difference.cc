// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/diff/difference.h"

#include <algorithm>
#include <map>
#include <utility>

#include "cli/output/artifact_text.h"
#include "cli/output/text.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "orchestrator/store/artifact_id.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

bool IsListOfConstraints(const v1::Artifact& artifact) {
  return artifact.has_raw_constraint_list() || artifact.has_constraint_list() ||
         artifact.has_completed_constraint_list();
}

const v1::ConstraintList& ListOf(const v1::Artifact& artifact) {
  if (artifact.has_completed_constraint_list()) return artifact.completed_constraint_list();
  return artifact.has_constraint_list() ? artifact.constraint_list() : artifact.raw_constraint_list();
}

void CompareContents(const v1::Artifact& a, const v1::Artifact& b, Difference& difference) {
  if (a.has_layout_graph()) return CompareGraphs(a.layout_graph(), b.layout_graph(), difference.sections);
  if (a.has_solved_layout()) return CompareLayouts(a.solved_layout(), b.solved_layout(), difference);
  if (IsListOfConstraints(a)) return CompareMessages(ListOf(a), ListOf(b), difference.sections);
  const auto content = [](const v1::Artifact& artifact) -> const google::protobuf::Message& {
    const auto& reflection = *artifact.GetReflection();
    const auto* field =
        reflection.GetOneofFieldDescriptor(artifact, artifact.GetDescriptor()->FindOneofByName("content"));
    return field == nullptr ? v1::Brief::default_instance() : reflection.GetMessage(artifact, field);
  };
  CompareMessages(content(a), content(b), difference.sections);
}

// Without what says where it came from. All kinds of constraint lists are one here.
std::string ContentBytes(const v1::Artifact& artifact) {
  v1::Artifact content = artifact;
  if (IsListOfConstraints(artifact)) *content.mutable_constraint_list() = ListOf(artifact);
  content.clear_id();
  content.clear_made_from_ids();
  content.clear_producer();
  content.clear_options_digest();
  content.clear_model_calls();
  return runtime::CanonicalBytes(content);
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

constexpr size_t kTitleWidth = 11;
constexpr size_t kSubjectWidth = 44;

// What things of a sort became, in order of telling; the sign stands before each.
struct Sort {
  Became became;
  const char* sign;
  const char* word;
};
constexpr Sort kSorts[] = {{Became::kAdded, "+", "added"},
                           {Became::kRemoved, "-", "removed"},
                           {Became::kChanged, "~", "changed"},
                           {Became::kBetter, "<", "better"},
                           {Became::kWorse, ">", "worse"}};

const Sort& SortOf(Became became) { return *std::ranges::find(kSorts, became, &Sort::became); }

// "objects    12 the same, 1 added, 2 changed".
std::string Heading(const Section& section) {
  std::vector<std::string> parts;
  if (!section.note.empty()) parts.push_back(section.note);
  if (section.same_count > 0) parts.push_back(fmt::format("{} the same", section.same_count));
  for (const Sort& sort : kSorts) {
    const auto count = std::ranges::count(section.changes, sort.became, &Change::became);
    if (count > 0) parts.push_back(fmt::format("{} {}", count, sort.word));
  }
  return fmt::format("{:<{}} {}\n", section.title, kTitleWidth, fmt::join(parts, ", "));
}

// Whether only the free description of a thing is another one.
bool IsReworded(const Change& change) {
  return change.became == Became::kChanged && change.detail.is_object() && change.detail.contains("fields") &&
         std::ranges::all_of(change.detail["fields"],
                             [](const nlohmann::json& field) { return field["field"] == "description"; });
}

// One line of a section: changes with the same words share it when there are three or more.
struct Line {
  Became became;
  std::string subject;
  std::string words;
};

std::vector<Line> LinesOf(const Section& section) {
  constexpr size_t kFewest = 3;
  std::map<std::pair<Became, std::string>, std::vector<std::string>> subjects;
  size_t reworded_count = 0;
  for (const Change& change : section.changes) {
    subjects[{change.became, change.words}].push_back(change.subject);
    reworded_count += IsReworded(change) ? 1 : 0;
  }
  std::vector<Line> lines;
  for (const Change& change : section.changes) {
    if (reworded_count >= kFewest && IsReworded(change)) continue;
    std::vector<std::string>& same = subjects[{change.became, change.words}];
    const bool shared = !change.words.empty() && (same.empty() || same.size() >= kFewest);
    if (shared && same.empty()) continue;
    lines.push_back({change.became, shared ? fmt::format("{}", fmt::join(same, ", ")) : change.subject, change.words});
    if (shared) same.clear();
  }
  if (reworded_count >= kFewest) {
    lines.push_back(
        {Became::kChanged, fmt::format("{} with another description alone (--format json)", reworded_count), ""});
  }
  return lines;
}

// Subjects in a column; words of long ones on a line of their own.
std::string Lines(const Section& section) {
  const std::vector<Line> lines = LinesOf(section);
  size_t width = 0;
  for (const Line& line : lines) {
    if (const size_t columns = ColumnsOf(line.subject); columns <= kSubjectWidth) width = std::max(width, columns);
  }
  std::string text;
  for (const Line& line : lines) {
    const size_t columns = ColumnsOf(line.subject);
    text += fmt::format("  {} {}", SortOf(line.became).sign, line.subject);
    if (!line.words.empty()) {
      text += columns > width ? "\n      " : std::string(width - columns + 2, ' ');
      text += line.words;
    }
    text += '\n';
  }
  return text;
}

std::string_view WordFor(Became became) { return SortOf(became).word; }

}  // namespace

bool Difference::IsEmpty() const {
  return std::ranges::all_of(sections, [](const Section& section) { return section.changes.empty(); });
}

absl::StatusOr<Difference> CompareArtifacts(const v1::Artifact& a, const v1::Artifact& b) {
  if (a.content_case() != b.content_case() && !(IsListOfConstraints(a) && IsListOfConstraints(b))) {
    return InvalidArgument("the first is a {}, the second a {}; give two of the same kind",
                           KindName(orchestrator::KindOf(a)), KindName(orchestrator::KindOf(b)));
  }
  Difference difference{.kind = orchestrator::KindOf(b)};
  difference.content_is_same = ContentBytes(a) == ContentBytes(b);
  if (!difference.content_is_same) CompareContents(a, b, difference);
  Section origin = OriginSection(a, b);
  difference.origin_is_same = origin.changes.empty();
  if (!difference.origin_is_same) difference.sections.push_back(std::move(origin));
  return difference;
}

std::string DifferenceText(const Difference& difference, const std::string& a, const std::string& b) {
  if (difference.content_is_same && difference.origin_is_same) {
    return fmt::format("{} and {} are the same {}\n", a, b, KindName(difference.kind));
  }
  std::string text = fmt::format("A {}\nB {}\n", a, b);
  if (difference.content_is_same) text += "the content is the same, byte for byte; the producer is not\n";
  std::string same;
  for (const Section& section : difference.sections) {
    if (section.changes.empty() && section.note.empty()) {
      same += fmt::format("{}{} {}", same.empty() ? "" : ", ", section.same_count, section.title);
    } else {
      text += Heading(section) + Lines(section);
    }
  }
  if (!same.empty()) text += fmt::format("{:<{}} {}\n", "the same", kTitleWidth, same);
  if (!difference.content_is_same && difference.IsEmpty()) {
    text += "nothing that matters differs; flair inspect --format json shows both\n";
  }
  return text;
}

std::string DifferenceJson(const Difference& difference, const std::string& a, const std::string& b) {
  nlohmann::json json = {{"kind", KindName(difference.kind)},
                         {"a", a},
                         {"b", b},
                         {"content_is_same", difference.content_is_same},
                         {"origin_is_same", difference.origin_is_same},
                         {"sections", nlohmann::json::array()}};
  for (const Section& section : difference.sections) {
    nlohmann::json changes = nlohmann::json::array();
    for (const Change& change : section.changes) {
      nlohmann::json entry = {{"became", WordFor(change.became)}, {"subject", change.subject}, {"words", change.words}};
      if (change.detail.is_object()) entry["detail"] = change.detail;
      changes.push_back(std::move(entry));
    }
    nlohmann::json entry = {
        {"title", section.title}, {"same_count", section.same_count}, {"changes", std::move(changes)}};
    if (!section.note.empty()) entry["note"] = section.note;
    json["sections"].push_back(std::move(entry));
  }
  return JsonText(json, 2) + "\n";
}

}  // namespace flair::cli
