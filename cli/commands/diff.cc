// SPDX-License-Identifier: GPL-3.0-or-later
// flair diff: what differs between two artifacts of a kind, by meaning.
#include <cstdio>
#include <filesystem>

#include "absl/strings/str_replace.h"
#include "cli/commands/commands.h"
#include "cli/diff/difference.h"
#include "cli/exit_code.h"
#include "cli/input/artifact_source.h"
#include "cli/output/output_folder.h"
#include "cli/output/report_text.h"
#include "cli/output/text.h"
#include "cli/session/stage_calls.h"
#include "fmt/format.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

struct DiffArguments : Options {
  using Options::Options;
  std::string& a = Required("A", fmt::format("An artifact: {}", kSourceHelp));
  std::string& b = Required("B", "A later one of the same kind");
  std::string& format = Word("--format FORMAT", {"text", "json"}, "Format: text or json (text)");
  std::string& picture =
      Text("--picture FILE", "Layouts: both plans in one picture, with the differences marked; png jpg tif svg pdf");
  std::optional<int>& size_px =
      Whole("--size PX", 256, 8192, "Longer side of the picture in pixels, 256 to 8192 (2400)");
  SourceFlags source{command()};
  RendererFlags renderer{command()};
};

// "14 of 15 constraints hold, OOB 0.00 %, OOR 0.12 %, cost 3.25".
std::string MeasuresOf(const v1::SolvedLayout& layout) {
  return fmt::format("{}, cost {:.2f}", LayoutLine(layout), layout.total_cost());
}

// The picture without its plans.
PlansBeside PictureOf(const DiffArguments& arguments) {
  return {.picture = arguments.picture, .size_px = arguments.size_px, .renderer = arguments.renderer, .plans = {}};
}

absl::Status DrawPicture(const DiffArguments& arguments, const v1::Artifact& a, const v1::Artifact& b,
                         const Difference& difference) {
  PlansBeside plans = PictureOf(arguments);
  plans.plans.push_back({a.solved_layout(), "A   " + arguments.a, MeasuresOf(a.solved_layout()), {}});
  plans.plans.push_back({b.solved_layout(), "B   " + arguments.b, MeasuresOf(b.solved_layout()), {}});
  for (const ObjectFate& fate : difference.fates) {
    v1::ObjectChange& change = plans.plans.back().changes.emplace_back();
    change.set_before_object_id(fate.a_id);
    change.set_after_object_id(fate.b_id);
    change.set_words(absl::StrReplaceAll(fate.words, {{"->", "→"}}));
  }
  return DrawPlansBeside(plans);
}

absl::Status Diff(const DiffArguments& arguments) {
  if (!arguments.picture.empty()) {
    RETURN_IF_ERROR(CheckPicture(PictureOf(arguments)));
  }
  ASSIGN_OR_RETURN(const v1::Artifact a, OpenArtifact(arguments.a, arguments.source));
  ASSIGN_OR_RETURN(const v1::Artifact b, OpenArtifact(arguments.b, arguments.source));
  const absl::StatusOr<Difference> difference = CompareArtifacts(a, b);
  if (!difference.ok()) return About(fmt::format("{} and {}", arguments.a, arguments.b), difference.status());
  if (!arguments.picture.empty()) {
    if (!a.has_solved_layout()) {
      return absl::InvalidArgumentError(
          fmt::format("--picture: {} is not a layout; only layouts can be drawn", arguments.a));
    }
    RETURN_IF_ERROR(DrawPicture(arguments, a, b, *difference));
  }
  fmt::print("{}", arguments.format == "json" ? DifferenceJson(*difference, arguments.a, arguments.b)
                                              : Printable(DifferenceText(*difference, arguments.a, arguments.b)));
  return difference->content_is_same ? absl::OkStatus() : DiffersStatus();
}

}  // namespace

void AddDiff(const Commands& program) {
  program.Add("diff", "Show what differs between two artifacts of the same kind.", Diff,
              "Items are matched by meaning: sentences by their words, calls by type and arguments, objects by id or "
              "name. + added, - removed, ~ changed, < better (lower cost, now satisfied), > worse. "
              "Exits with 0 when the contents are the same, whoever made them, and with 7 when they differ. "
              "Examples:\n"
              "  flair diff out/a/layout.pb out/b/layout.pb --picture difference.png\n"
              "  flair diff out/a/constraints_raw.pb out/a/constraints.pb");
}

}  // namespace flair::cli
