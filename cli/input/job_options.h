// SPDX-License-Identifier: GPL-3.0-or-later
// Options of a job by name: the fields of SolveOptions under "optimizer.", of RenderOptions under "renderer.", of
// ModelOptions under "models.", and "brief.seed". Some have a short name (optimizer.restarts) and are flags
// (--restarts).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "cli/input/options.h"
#include "flair/v1/job.pb.h"

namespace flair::cli {

struct OptionName {
  // Such as "optimizer.restarts" or "optimizer.lambdas.balanced".
  std::string name;
  // What it takes, such as "a whole number" or "plan, birdseye or perspective".
  std::string values;
};
// Every option of a job, by its short name if it has one.
std::vector<OptionName> OptionNames();

// Sets the option that "NAME=VALUE" names; "NAME=" gives it back to the stage, which then takes its default. Numbers
// and words of a list have commas between, words of enums may be long or short, with - or _: PREVIEW_VIEW_PLAN, plan;
// "all" stands for all words of a list. Returns the name of the first stage that takes such options, such as "solve".
// INVALID_ARGUMENT says which names there are, or what VALUE should be. Ranges are checked by Validate.
absl::StatusOr<std::string_view> SetOption(const std::string& assignment, v1::JobSpec& spec);

// Flags of a command that set options of a job.
class JobFlags : public Options {
 public:
  struct Choice {
    std::string_view option;  // such as "optimizer.restarts"
    std::string help = "";    // in place of the usual help
  };
  JobFlags(CLI::App& command, const std::vector<Choice>& choices, const std::string& group = "Options");

  // Sets the options that were given. INVALID_ARGUMENT names the flag, the value and what would be right.
  absl::Status Set(v1::JobSpec& spec) const;
  // Names the flags in a message of Validate instead of the fields.
  std::string InFlags(const std::string& message) const;

 private:
  struct Given {
    std::string_view option;
    CLI::Option* flag;
    std::string text;
  };
  std::deque<Given> given_;
};

// What a design may consume of its language model.
struct ModelFlags : JobFlags {
  explicit ModelFlags(CLI::App& command)
      : JobFlags(command,
                 {{"models.max_calls"},
                  {"models.max_tokens"},
                  {"models.max_usd"},
                  {"models.stand_in"},
                  {"models.omit_texts"}},
                 "Language model") {}
};

// How to solve: flags, or a file, or both.
struct SolveFlags : JobFlags {
  explicit SolveFlags(CLI::App& command);
  std::vector<std::string>& lambdas =
      List("--lambda NAME=VALUE", "A weight of the paper's cost: no_overlap=5, balanced=10, ...");
  std::vector<std::string>& tolerances =
      List("--tolerance NAME=VALUE", "When a descent stops: relative=1e-4, absolute=1e-5, ...");
  std::string& file = Text("--options FILE", "All of these and more, as text of a SolveOptions; flags override it");
};

// The options of the file with those of the flags over them. INVALID_ARGUMENT names file and line, or flag and value,
// and says what would be right. Ranges are checked by the optimizer.
absl::StatusOr<v1::SolveOptions> ReadSolveFlags(const SolveFlags& flags);

// How to draw.
struct RenderFlags : JobFlags {
  explicit RenderFlags(CLI::App& command);
  double& field_of_view_deg =
      Decimal("--fov DEG", 6, 148, 0, "Views: vertical field of view in degrees, 6 to 148 (57.3)");
};

// The options for a picture that goes to the file `out`, whose ending says the format. INVALID_ARGUMENT names the flag
// or the ending, the value, and what would be right, also for flags that do not go together.
absl::StatusOr<v1::RenderOptions> ReadRenderFlags(const RenderFlags& flags, const std::string& out);

// By the ending of a file name. INVALID_ARGUMENT when it is none of png, jpg, jpeg, tif, tiff, exr, svg, pdf.
absl::StatusOr<v1::PreviewFormat> FormatOfFile(const std::string& path);

// "plan", "birdseye" or "perspective"; INVALID_ARGUMENT otherwise.
absl::StatusOr<v1::PreviewView> ViewOfName(const std::string& name);

}  // namespace flair::cli
