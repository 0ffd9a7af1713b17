// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/report_text.h"

#include <algorithm>
#include <set>

#include "cli/output/artifact_text.h"
#include "cli/output/message_view.h"
#include "cli/output/text.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "room/conversion/conversion.h"
#include "room/scene/scene.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

const v1::Artifact& Get(const ArtifactsByKind& artifacts, v1::ArtifactKind kind) {
  const auto found = artifacts.find(kind);
  return found == artifacts.end() ? v1::Artifact::default_instance() : found->second;
}

std::string Heading(const v1::Room& room, const v1::Brief& brief, const v1::Preview& preview) {
  const std::string title = room.title().empty() ? brief.text() : room.title();
  const auto [width, depth] = ExtentOf(room.floor());
  return fmt::format(
      "# {}\n\nAsked for: \"{}\" (seed {}).\n\nA {} of {:.4g} m x {:.4g} m, {:.4g} m high.\n\n![plan]({})\n", title,
      MarkdownCell(brief.text()), brief.seed(), room.room_type(), width, depth, room.height_m(), PictureName(preview));
}

std::string SolidsInWords(const v1::LayoutMetrics& metrics) {
  if (!metrics.has_oor_3d_percent()) return "not measured";
  return fmt::format("OOB {:.3f} %, OOR {:.3f} %", metrics.oob_3d_percent(), metrics.oor_3d_percent());
}

std::string Verdict(const v1::Report& report, const v1::SolvedLayout& layout) {
  const v1::LayoutMetrics& m = report.metrics();
  const v1::ConstraintSummary& c = report.constraints();
  const auto row = [](const char* measure, const char* format, double value, const char* meaning) {
    return std::vector<std::string>{measure, fmt::format(fmt::runtime(format), value), meaning};
  };
  return "\n## Measures\n\n" +
         MarkdownTable(
             {"measure", "value", "meaning"},
             {row("OOB", "{:.4f} %", m.oob_percent(), "furniture outside the room, of the room's area"),
              row("OOR", "{:.4f} %", m.oor_percent(),
                  "furniture in furniture or in a door's swing, of the room's area"),
              row("floor reached", "{:.0f} %", 100 * m.reachable_floor_share(),
                  "of the free floor, by a person 0.6 m wide from the door"),
              row("fronts reached", "{:.0f} %", 100 * m.reachable_front_share(),
                  "of the furniture has room to stand in front of it"),
              row("deepest overlap", "{:.1f} mm", 1e3 * m.deepest_overlap_m(),
                  "deepest overlap on the floor: with another object, a door's swing or a wall"),
              {"in three dimensions", SolidsInWords(m),
               "outside and overlaps of everything with everything, of the room's volume"},
              {"uses met", m.has_use_count() ? fmt::format("{} of {}", m.met_use_count(), m.use_count()) : "–",
               "a chair drawn up to its desk, a lamp beside its seat"},
              row("pathway cost", "{:.4f} m3", m.pathway_cost_m3(),
                  "how much furniture narrows paths to less than 0.6 m"),
              {"constraints",
               fmt::format("{} hold, {} do not, {} dropped, {} not understood", c.satisfied_count(), c.violated_count(),
                           c.dropped_count(), c.untranslated_count()),
               fmt::format("{} calls", layout.graph().edges_size())}});
}

std::string ZoneText(const v1::ZonePlan& plan) {
  std::string text = "\n## Zones\n\n";
  for (const v1::Zone& zone : plan.zones()) {
    text += fmt::format("- **{}**{}{}\n", zone.name(), zone.purpose().empty() ? "" : ": ", zone.purpose());
  }
  return text;
}

// The reason of the first sentence that moves the object.
std::string ReasonFor(const std::string& id, const v1::ConstraintList& constraints) {
  for (const v1::Sentence& sentence : constraints.sentences()) {
    if (sentence.subject_ids_size() > 0 && sentence.subject_ids(0) == id && !sentence.reason().empty()) {
      return sentence.reason();
    }
  }
  return "";
}

std::string ObjectText(const v1::SolvedLayout& layout, const v1::StyleSheet& style,
                       const v1::ConstraintList& sentences) {
  std::vector<std::vector<std::string>> rows;
  const absl::StatusOr<Scene> scene = SceneFromProto(layout.graph());
  for (const v1::Object& object : layout.graph().object_list().objects()) {
    const std::string name = scene.ok() ? NameForPeople(*scene, static_cast<int>(rows.size())) : object.name();
    std::string finish;
    const auto look = std::ranges::find(style.objects(), object.id(), &v1::ObjectStyle::subject_id);
    if (look != style.objects().end()) {
      finish = look->material();
      if (!look->colour().name().empty()) finish += (finish.empty() ? "" : ", ") + look->colour().name();
    }
    std::string why = object.requested() ? "asked for" : "";
    std::string reason = ReasonFor(object.id(), sentences);
    if (reason.empty() && why.empty()) reason = object.description();
    if (!reason.empty()) why += (why.empty() ? "" : "; ") + reason;
    rows.push_back({name.starts_with("the ") ? name.substr(4) : name, object.zone_id(),
                    fmt::format("{:.2f} x {:.2f} x {:.2f}", object.width_m(), object.depth_m(), object.height_m()),
                    finish, why});
  }
  return "\n## Objects\n\n" + MarkdownTable({"object", "zone", "width x depth x height (m)", "look", "why"}, rows);
}

// Why no tick is due although all calls of a sentence hold: its piece is where it cannot be. Empty when it can.
std::string Absurdity(const v1::Sentence& sentence, const v1::LayoutMetrics& metrics) {
  const std::string moved = sentence.subject_ids_size() > 0 ? sentence.subject_ids(0) : "";
  const auto found = std::ranges::find_if(metrics.findings(), [&](const v1::Finding& finding) {
    return finding.kind() != v1::FINDING_KIND_USE_NOT_MET && finding.object_id() == moved;
  });
  return found == metrics.findings().end() ? "" : found->message();
}

// What became of one sentence: the worst of its calls.
std::string SentenceOutcome(const v1::Sentence& sentence, const v1::SolvedLayout& layout) {
  int held = 0;
  std::vector<std::string> problems;
  for (int i = 0; i < layout.graph().edges_size() && i < layout.edge_outcomes_size(); ++i) {
    if (layout.graph().edges(i).sentence_id() != sentence.id()) continue;
    const v1::EdgeOutcome& outcome = layout.edge_outcomes(i);
    if (outcome.status() == v1::OUTCOME_STATUS_SATISFIED) {
      ++held;
    } else {
      const bool dropped = outcome.status() == v1::OUTCOME_STATUS_DROPPED;
      const std::string& why = outcome.reason();
      if (dropped) problems.push_back(why.empty() ? "dropped" : "dropped: " + why);
      if (!dropped) problems.push_back(why.empty() ? "does not hold" : why);
    }
  }
  if (!problems.empty()) return "✗ " + problems.front();
  if (held == 0) return "– not understood";
  const std::string absurdity = Absurdity(sentence, layout.metrics());
  return absurdity.empty() ? "✓" : "✗ holds, but " + absurdity;
}

std::string SentenceText(const v1::SolvedLayout& layout, const v1::ConstraintList& constraints) {
  std::vector<std::vector<std::string>> rows;
  for (const v1::Sentence& sentence : constraints.sentences()) {
    rows.push_back({SentenceOutcome(sentence, layout), sentence.text(), sentence.reason()});
  }
  return "\n## Reasons, sentence by sentence\n\n" + MarkdownTable({"", "sentence", "why"}, rows);
}

// A section of bullets; nothing without any.
std::string Bullets(const char* title, const std::vector<std::string>& items) {
  return items.empty() ? "" : fmt::format("\n## {}\n\n- {}\n", title, fmt::join(items, "\n- "));
}

std::string ContradictionText(const v1::SolvedLayout& layout) {
  std::vector<std::string> items;
  for (const v1::Contradiction& contradiction : layout.contradictions()) items.push_back(contradiction.explanation());
  return Bullets("What cannot hold together", items);
}

std::string LeftOutText(const v1::ObjectList& objects) {
  std::vector<std::string> items;
  for (const v1::Omission& omission : objects.omissions()) {
    items.push_back(
        fmt::format("**{}**{}: {}", omission.name(), omission.requested() ? " (asked for)" : "", omission.reason()));
  }
  return Bullets("Left out", items);
}

std::string RemarkText(const v1::Report& report) {
  std::vector<std::string> items;
  for (const v1::Diagnostic& remark : report.diagnostics()) {
    const std::string severity = EnumInWords(remark.severity());
    items.push_back(fmt::format("{}: {}", remark.severity() == v1::SEVERITY_NOTE ? severity : "**" + severity + "**",
                                remark.message()));
  }
  return Bullets("Remarks", items);
}

std::string MakerText(const ArtifactsByKind& artifacts, const v1::Report& report, const v1::Job& job) {
  std::vector<std::vector<std::string>> times, makers;
  for (const v1::StageTiming& timing : report.stage_timings()) {
    times.push_back(
        {timing.stage(), fmt::format("{:.3f}", SecondsOf(timing.duration())), timing.reused() ? "as before" : ""});
  }
  for (const auto& [kind, artifact] : artifacts) {
    if (kind == v1::ARTIFACT_KIND_REPORT) continue;
    const v1::Producer& producer = artifact.producer();
    makers.push_back({v1::ArtifactKind_Name(kind).substr(14), fmt::format("`{}`", artifact.id().substr(0, 16)),
                      fmt::format("{} {} {}", producer.program(), producer.method(), producer.version().substr(0, 24)),
                      producer.build()});
  }
  return "\n## Times\n\n" + MarkdownTable({"stage", "seconds", ""}, times) +
         fmt::format("\n## Made by\n\nJob {}.\n\n", job.id()) +
         MarkdownTable({"artifact", "id", "producer", "build"}, makers);
}

// "plan.png", "birdseye.exr".
std::string NameOf(v1::PreviewView view, v1::PreviewFormat format) {
  return EnumInWords(view) + "." + EnumInWords(format);
}

}  // namespace

std::vector<std::string> NotAsAsked(const v1::SolvedLayout& layout) {
  const v1::LayoutGraph& graph = layout.graph();
  std::vector<std::string> lines;
  std::ptrdiff_t essentials = 0;
  for (const auto* remarks : {&graph.room().diagnostics(), &graph.zone_plan().diagnostics(),
                              &graph.object_list().diagnostics(), &graph.constraint_list().diagnostics()}) {
    for (const v1::Diagnostic& remark : *remarks) {
      if (remark.severity() < v1::SEVERITY_WARNING) continue;
      // What the room cannot do without comes before all else.
      const bool first = remark.code() == "essential_missing";
      lines.insert(first ? lines.begin() + essentials++ : lines.end(), remark.message());
    }
  }
  for (const v1::Omission& omission : graph.object_list().omissions()) {
    if (omission.requested()) lines.push_back(fmt::format("{} is left out: {}", omission.name(), omission.reason()));
  }
  // Places that the brief itself asks for, once for all the pieces that it asks it of.
  std::set<std::string> told;
  for (const v1::Sentence& sentence : graph.constraint_list().sentences()) {
    if (sentence.origin() != v1::SENTENCE_ORIGIN_BRIEF) continue;
    const std::string outcome = SentenceOutcome(sentence, layout);
    if (outcome == "✓" || !told.insert(sentence.reason()).second) continue;
    lines.push_back(fmt::format("{}; {}", sentence.reason(), outcome.substr(outcome.find(' ') + 1)));
  }
  return lines;
}

std::string UsesInWords(const v1::LayoutMetrics& metrics) {
  const int asked = metrics.use_count(), met = metrics.met_use_count();
  if (asked == 0) return "";
  if (met == asked) return asked == 1 ? "The one use is met." : fmt::format("All {} uses are met.", asked);
  return fmt::format("{} of {} met.", met, Counted(asked, "use is", "uses are"));
}

std::vector<std::string> WrongInWords(const v1::LayoutMetrics& metrics, size_t most) {
  std::vector<std::string> lines;
  for (const v1::Finding& finding : metrics.findings()) {
    const bool is_use = finding.kind() == v1::FINDING_KIND_USE_NOT_MET;
    if (lines.size() < most) lines.push_back((is_use ? "use not met: " : "") + finding.message());
  }
  const size_t all = static_cast<size_t>(metrics.findings_size());
  if (all > lines.size()) lines.push_back(fmt::format("and {} more", all - lines.size()));
  return lines;
}

std::string WriteReport(const v1::Job& job, const ArtifactsByKind& artifacts) {
  const v1::SolvedLayout& layout = Get(artifacts, v1::ARTIFACT_KIND_SOLVED_LAYOUT).solved_layout();
  const v1::StyleSheet& style = Get(artifacts, v1::ARTIFACT_KIND_STYLE_SHEET).style_sheet();
  const v1::ConstraintList& constraints =
      Get(artifacts, v1::ARTIFACT_KIND_COMPLETED_CONSTRAINT_LIST).completed_constraint_list();
  const v1::Report& report = Get(artifacts, v1::ARTIFACT_KIND_REPORT).report();
  std::string text = Heading(layout.graph().room(), Get(artifacts, v1::ARTIFACT_KIND_BRIEF).brief(),
                             Get(artifacts, v1::ARTIFACT_KIND_PREVIEW).preview());
  if (!style.summary().empty()) text += fmt::format("\nStyle: {}. {}\n", style.name(), style.summary());
  constexpr size_t kListedWrongs = 12;
  text += Bullets("Not as asked", NotAsAsked(layout));
  text += Bullets("What is wrong", WrongInWords(report.metrics(), kListedWrongs));
  text += LeftOutText(layout.graph().object_list());
  text += Verdict(report, layout);
  text += ZoneText(layout.graph().zone_plan());
  text += ObjectText(layout, style, constraints);
  text += SentenceText(layout, constraints);
  text += ContradictionText(layout);
  text += RemarkText(report);
  text += ModelsSection(report, artifacts);
  text += MakerText(artifacts, report, job);
  return text;
}

std::string PictureName(const v1::Preview& preview) {
  const bool known = preview.view() != v1::PREVIEW_VIEW_UNSPECIFIED && v1::PreviewView_IsValid(preview.view()) &&
                     preview.format() != v1::PREVIEW_FORMAT_UNSPECIFIED && v1::PreviewFormat_IsValid(preview.format());
  return known ? NameOf(preview.view(), preview.format()) : "plan.png";
}

std::vector<std::string> DesignFileNames() {
  constexpr int kMostVariants = 32;
  std::vector<std::string> names = {"report.md", kVariantsPicture};
  for (int number = 2; number <= kMostVariants; ++number) names.push_back(fmt::format("layout-{}.pb", number));
  for (int view = v1::PREVIEW_VIEW_PLAN; view < v1::PreviewView_ARRAYSIZE; ++view) {
    for (int format = v1::PREVIEW_FORMAT_PNG; format < v1::PreviewFormat_ARRAYSIZE; ++format) {
      names.push_back(NameOf(static_cast<v1::PreviewView>(view), static_cast<v1::PreviewFormat>(format)));
    }
  }
  for (int kind = 1; kind < v1::ArtifactKind_ARRAYSIZE; ++kind) {
    const std::string stem = FileStem(static_cast<v1::ArtifactKind>(kind));
    if (stem.empty()) continue;
    names.push_back(stem + ".pb");
    names.push_back(stem + ".json");
  }
  return names;
}

std::vector<OutputFile> MakeDesignFiles(const v1::Job& job, const ArtifactsByKind& artifacts) {
  std::vector<OutputFile> files;
  for (const auto& [kind, artifact] : artifacts) {
    if (artifact.has_preview()) files.push_back({PictureName(artifact.preview()), artifact.preview().image()});
    const std::string stem = FileStem(kind);
    if (stem.empty()) continue;
    files.push_back({stem + ".pb", ArtifactBytes(artifact)});
    files.push_back({stem + ".json", ToJson(artifact)});
  }
  files.push_back({"report.md", WriteReport(job, artifacts)});
  return files;
}

}  // namespace flair::cli
