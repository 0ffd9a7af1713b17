// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "optimizer_worker/stages/solve_input.h"

namespace flair::optimizer {
namespace {

TEST(ReadSettings, FillsInTheDefaultsOfTheContract) {
  const absl::StatusOr<SolveSettings> settings = ReadSettings({});
  ASSERT_TRUE(settings.ok()) << settings.status();
  EXPECT_EQ(settings->variant_count, 1);
  EXPECT_FALSE(settings->leave_out_misfits);
  EXPECT_EQ(settings->time_limit, absl::InfiniteDuration());
  EXPECT_EQ(settings->tolerances.relative, 1e-4);
  EXPECT_EQ(settings->tolerances.absolute, 1e-5);
  EXPECT_EQ(settings->tolerances.max_evaluations, 60);
}

TEST(ReadSettings, TakesWhatIsGiven) {
  v1::SolveOptions options;
  options.set_seed(7);
  options.set_variant_count(4);
  options.set_misfit_policy(v1::MISFIT_POLICY_LEAVE_OUT);
  options.set_groups(v1::GROUP_POLICY_OFF);
  options.mutable_time_limit()->set_nanos(500000000);
  options.mutable_tolerances()->set_relative(1e-6);
  options.mutable_tolerances()->set_max_evaluation_count(9);
  const absl::StatusOr<SolveSettings> settings = ReadSettings(options);
  ASSERT_TRUE(settings.ok()) << settings.status();
  EXPECT_EQ(settings->seed, 7u);
  EXPECT_EQ(settings->variant_count, 4);
  EXPECT_TRUE(settings->leave_out_misfits);
  EXPECT_FALSE(settings->groups);
  EXPECT_EQ(settings->time_limit, absl::Milliseconds(500));
  EXPECT_EQ(settings->tolerances.relative, 1e-6);
  EXPECT_EQ(settings->tolerances.max_evaluations, 9);
}

TEST(ReadSettings, NamesTheFieldThatIsOutOfRange) {
  struct Case {
    const char* field;
    std::function<void(v1::SolveOptions&)> spoil;
  };
  const Case cases[] = {
      {"options.seed", [](v1::SolveOptions& o) { o.set_seed(-1); }},
      {"options.max_restart_count", [](v1::SolveOptions& o) { o.set_max_restart_count(0); }},
      {"options.thread_count", [](v1::SolveOptions& o) { o.set_thread_count(257); }},
      {"options.path_width_m", [](v1::SolveOptions& o) { o.set_path_width_m(std::nan("")); }},
      {"options.variant_count", [](v1::SolveOptions& o) { o.set_variant_count(33); }},
      {"options.misfit_policy", [](v1::SolveOptions& o) { o.set_misfit_policy(static_cast<v1::MisfitPolicy>(9)); }},
      {"options.groups", [](v1::SolveOptions& o) { o.set_groups(static_cast<v1::GroupPolicy>(9)); }},
      {"options.time_limit", [](v1::SolveOptions& o) { o.mutable_time_limit(); }},
      {"options.tolerances.relative", [](v1::SolveOptions& o) { o.mutable_tolerances()->set_relative(0); }},
      {"options.tolerances.absolute", [](v1::SolveOptions& o) { o.mutable_tolerances()->set_absolute(-1); }},
      {"options.tolerances.max_evaluation_count",
       [](v1::SolveOptions& o) { o.mutable_tolerances()->set_max_evaluation_count(0); }},
      {"options.lambdas.zone", [](v1::SolveOptions& o) { o.mutable_lambdas()->set_zone(-1); }},
  };
  for (const Case& c : cases) {
    v1::SolveOptions options;
    c.spoil(options);
    const absl::Status status = ReadSettings(options).status();
    EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument) << c.field;
    EXPECT_EQ(std::string(status.message()).rfind(std::string(c.field) + ":", 0), 0u) << status;
  }
}

}  // namespace
}  // namespace flair::optimizer
