// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/solve_settings.h"

#include <cmath>
#include <string>

#include "fmt/format.h"
#include "optimizer_worker/solver/parallel.h"

namespace flair::optimizer {
namespace {

// Reads optional fields one after the other and keeps the first complaint.
class Reader {
 public:
  // A number for which `good` holds.
  template <typename Value, typename Good>
  void Read(bool given, Value value, const char* name, const char* wanted, Good good, Value& target) {
    if (!given || !status_.ok()) return;
    if (!std::isfinite(static_cast<double>(value)) || !good(value)) {
      status_ = absl::InvalidArgumentError(fmt::format("options.{}: {} is not {}", name, value, wanted));
      return;
    }
    target = value;
  }
  void Count(bool given, int value, const char* name, int most, int& target) {
    Read(
        given, value, name, fmt::format("in [1, {}]", most).c_str(), [most](int n) { return n >= 1 && n <= most; },
        target);
  }
  void Fail(std::string problem) {
    if (status_.ok()) status_ = absl::InvalidArgumentError(problem);
  }
  const absl::Status& status() const { return status_; }

 private:
  absl::Status status_;
};

void ReadLambdas(const v1::Lambdas& from, LambdaValues& to, Reader& reader) {
  const auto read = [&reader](bool given, double value, const char* name, double& target) {
    reader.Read(
        given, value, fmt::format("lambdas.{}", name).c_str(), "a number >= 0", [](double v) { return v >= 0; },
        target);
  };
  read(from.has_door_overlap(), from.door_overlap(), "door_overlap", to.door_overlap);
  read(from.has_wall_attraction_divisor(), from.wall_attraction_divisor(), "wall_attraction_divisor",
       to.wall_attraction_divisor);
  read(from.has_no_overlap(), from.no_overlap(), "no_overlap", to.no_overlap);
  read(from.has_balanced(), from.balanced(), "balanced", to.balanced);
  read(from.has_in_bounds(), from.in_bounds(), "in_bounds", to.in_bounds);
  read(from.has_zone(), from.zone(), "zone", to.zone);
  read(from.has_tertiary_in_bounds(), from.tertiary_in_bounds(), "tertiary_in_bounds", to.tertiary_in_bounds);
  read(from.has_on_wall(), from.on_wall(), "on_wall", to.on_wall);
}

void ReadTolerances(const v1::Tolerances& from, ToleranceValues& to, Reader& reader) {
  const auto positive = [](double v) { return v > 0; };
  reader.Read(from.has_relative(), from.relative(), "tolerances.relative", "a number > 0", positive, to.relative);
  reader.Read(from.has_absolute(), from.absolute(), "tolerances.absolute", "a number > 0", positive, to.absolute);
  reader.Count(from.has_max_evaluation_count(), from.max_evaluation_count(), "tolerances.max_evaluation_count", 100000,
               to.max_evaluations);
}

void ReadTimeLimit(const v1::SolveOptions& options, absl::Duration& limit, Reader& reader) {
  if (!options.has_time_limit()) return;
  const google::protobuf::Duration& given = options.time_limit();
  const absl::Duration value = absl::Seconds(given.seconds()) + absl::Nanoseconds(given.nanos());
  if (value <= absl::ZeroDuration()) {
    reader.Fail(fmt::format("options.time_limit: {} s is not > 0", absl::ToDoubleSeconds(value)));
  }
  limit = value;
}

}  // namespace

absl::StatusOr<SolveSettings> ReadSettings(const v1::SolveOptions& options) {
  SolveSettings settings;
  Reader reader;
  int64_t seed = 0;
  int threads = 0;
  reader.Read(
      options.has_seed(), options.seed(), "seed", "in [0, 2^53)",
      [](int64_t s) { return s >= 0 && s < int64_t{1} << 53; }, seed);
  reader.Count(options.has_max_restart_count(), options.max_restart_count(), "max_restart_count", 10000,
               settings.max_restarts);
  reader.Count(options.has_thread_count(), options.thread_count(), "thread_count", 256, threads);
  reader.Read(
      options.has_path_width_m(), options.path_width_m(), "path_width_m", "in [0, 2]",
      [](double w) { return w >= 0 && w <= 2; }, settings.path_width_m);
  reader.Count(options.has_variant_count(), options.variant_count(), "variant_count", 32, settings.variant_count);
  ReadLambdas(options.lambdas(), settings.lambdas, reader);
  ReadTolerances(options.tolerances(), settings.tolerances, reader);
  ReadTimeLimit(options, settings.time_limit, reader);
  if (!v1::MisfitPolicy_IsValid(options.misfit_policy())) {
    reader.Fail(fmt::format("options.misfit_policy: {} is neither KEEP (1) nor LEAVE_OUT (2)",
                            static_cast<int>(options.misfit_policy())));
  }
  if (!reader.status().ok()) return reader.status();
  settings.seed = static_cast<uint64_t>(seed);
  settings.threads = ThreadCount(threads);
  settings.leave_out_misfits = options.misfit_policy() == v1::MISFIT_POLICY_LEAVE_OUT;
  settings.find_contradictions = options.find_contradictions();
  return settings;
}

}  // namespace flair::optimizer
