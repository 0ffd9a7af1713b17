// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/solve_flags.h"

#include <cmath>

#include "cli/input/text_message.h"
#include "cli/input/value_checks.h"
#include "fmt/format.h"

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
  command.add_option("--seed", flags.seed, "Another seed, another layout (0)")->type_name("N")->check(Seed());
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
                  "Width of the way from the door to everything in metres, 0 to 2 (0.6)")
      ->type_name("M")
      ->check(Number(0.0, 2.0));
  command
      .add_option("--misfits", flags.misfits, "What does not fit: keep it where it is least bad, or leave-out (keep)")
      ->type_name("HOW")
      ->check(OneOf({"keep", "leave-out"}));
  command
      .add_option("--time-limit", flags.time_limit_s,
                  "End with the best layout after so many seconds, 0.001 to 1000000; results then vary")
      ->type_name("S")
      ->check(Number(1e-3, 1e6));
  command.add_flag("--contradictions", flags.contradictions, "Find the constraints that cannot hold together");
  command.add_option("--lambda", flags.lambdas, "A factor of the paper: no_overlap=5, balanced=10, ...")
      ->type_name("NAME=VALUE");
  command.add_option("--tolerance", flags.tolerances, "When a descent ends: relative=1e-4, absolute=1e-5, ...")
      ->type_name("NAME=VALUE");
  command.add_option("--options", flags.file, "All of these and more, as text of a SolveOptions; flags go before it")
      ->type_name("FILE");
}

absl::StatusOr<v1::SolveOptions> ReadSolveFlags(const SolveFlags& flags) {
  v1::SolveOptions options;
  if (!flags.file.empty()) {
    if (absl::Status status = ReadTextMessage("--options", flags.file, kOptionsExample, options); !status.ok())
      return status;
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
    if (absl::Status status = SetField("--lambda", lambda, *options.mutable_lambdas()); !status.ok()) return status;
  }
  for (const std::string& tolerance : flags.tolerances) {
    absl::Status status = SetField("--tolerance", tolerance, *options.mutable_tolerances());
    if (!status.ok()) return status;
  }
  if (!options.has_seed()) options.set_seed(0);
  return options;
}

}  // namespace flair::cli
