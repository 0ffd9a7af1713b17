// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/solve_flags.h"

#include <cmath>

#include "cli/input/command_line.h"
#include "cli/input/message_text.h"
#include "fmt/format.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

constexpr char kOptionsExample[] = "fields of SolveOptions, such as: max_restart_count: 8 lambdas { balanced: 0 }";

std::string FieldNames(const google::protobuf::Descriptor& type) {
  std::string names;
  for (int i = 0; i < type.field_count(); ++i) names += (i > 0 ? ", " : "") + type.field(i)->name();
  return names;
}

// Sets the numeric field that "name=value" names.
absl::Status SetField(const char* flag, const std::string& text, google::protobuf::Message& message) {
  const size_t equals = text.find('=');
  const std::string name = text.substr(0, equals);
  const google::protobuf::FieldDescriptor* field = message.GetDescriptor()->FindFieldByName(name);
  if (field == nullptr) {
    return absl::InvalidArgumentError(
        fmt::format("{}: {}: should be NAME=VALUE with one of {}", flag, text, FieldNames(*message.GetDescriptor())));
  }
  double value = 0;
  const bool whole = field->cpp_type() == google::protobuf::FieldDescriptor::CPPTYPE_INT32;
  const bool read = equals != std::string::npos && CLI::detail::lexical_cast(text.substr(equals + 1), value) &&
                    std::isfinite(value) && (!whole || (value == std::floor(value) && std::abs(value) < 1e9));
  if (!read) {
    return absl::InvalidArgumentError(
        fmt::format("{}: {}: should be {}=VALUE with a {}number", flag, text, name, whole ? "whole " : ""));
  }
  if (whole) {
    message.GetReflection()->SetInt32(&message, field, static_cast<int>(value));
  } else {
    message.GetReflection()->SetDouble(&message, field, value);
  }
  return absl::OkStatus();
}

}  // namespace

void AddSolveFlags(CLI::App& command, SolveFlags& flags) {
  command.add_option("--seed", flags.seed, "Seed; another seed, another layout (0)")->type_name("N")->check(Seed());
  command.add_option("--restarts", flags.restarts, "Restarts per stage, 1 to 10000 (by the stage's size)")
      ->type_name("N")
      ->check(WholeNumber(1, 10000));
  command.add_option("--threads", flags.threads, "Threads of the solver, 1 to 256 (all cores); changes no result")
      ->type_name("N")
      ->check(WholeNumber(1, 256));
  command.add_option("--variants", flags.variants, "Layouts that differ visibly, 1 to 32 (1), best first")
      ->type_name("K")
      ->check(WholeNumber(1, 32));
  command
      .add_option("--path-width", flags.path_width_m,
                  "Width in metres of the paths from the door that are kept free, 0 to 2 (0.6)")
      ->type_name("M")
      ->check(Number(0.0, 2.0));
  command
      .add_option("--misfits", flags.misfits,
                  "What to do with objects that do not fit: keep them where they do least harm, or leave-out (keep)")
      ->type_name("HOW")
      ->check(OneOf({"keep", "leave-out"}));
  command
      .add_option("--time-limit", flags.time_limit_s,
                  "Stop after so many seconds with the best layout so far, 0.001 to 1000000; results then vary")
      ->type_name("S")
      ->check(Number(1e-3, 1e6));
  command.add_flag("--contradictions", flags.contradictions, "Find the constraints that contradict each other");
  command.add_option("--lambda", flags.lambdas, "A weight of the paper's cost: no_overlap=5, balanced=10, ...")
      ->type_name("NAME=VALUE");
  command.add_option("--tolerance", flags.tolerances, "When a descent stops: relative=1e-4, absolute=1e-5, ...")
      ->type_name("NAME=VALUE");
  command.add_option("--options", flags.file, "All of these and more, as text of a SolveOptions; flags override it")
      ->type_name("FILE");
}

absl::StatusOr<v1::SolveOptions> ReadSolveFlags(const SolveFlags& flags) {
  v1::SolveOptions options;
  if (!flags.file.empty()) {
    RETURN_IF_ERROR(ReadTextMessage("--options", flags.file, kOptionsExample, options));
  }
  if (flags.seed) options.set_seed(*flags.seed);
  if (flags.restarts) options.set_max_restart_count(*flags.restarts);
  if (flags.threads) options.set_thread_count(*flags.threads);
  if (flags.variants) options.set_variant_count(*flags.variants);
  if (flags.path_width_m) options.set_path_width_m(*flags.path_width_m);
  if (flags.misfits == "keep") options.set_misfit_policy(v1::MISFIT_POLICY_KEEP);
  if (flags.misfits == "leave-out") options.set_misfit_policy(v1::MISFIT_POLICY_LEAVE_OUT);
  if (flags.time_limit_s) {
    const double whole_s = std::floor(*flags.time_limit_s);
    options.mutable_time_limit()->set_seconds(static_cast<int64_t>(std::min(whole_s, 1e11)));
    options.mutable_time_limit()->set_nanos(static_cast<int32_t>(1e9 * (*flags.time_limit_s - whole_s)));
  }
  if (flags.contradictions) options.set_find_contradictions(true);
  for (const std::string& lambda : flags.lambdas) {
    RETURN_IF_ERROR(SetField("--lambda", lambda, *options.mutable_lambdas()));
  }
  for (const std::string& tolerance : flags.tolerances) {
    RETURN_IF_ERROR(SetField("--tolerance", tolerance, *options.mutable_tolerances()));
  }
  if (!options.has_seed()) options.set_seed(0);
  return options;
}

}  // namespace flair::cli
