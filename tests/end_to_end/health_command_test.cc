// SPDX-License-Identifier: GPL-3.0-or-later
// What health checks of containers see.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include "tests/fixtures/programs.h"

namespace flair::testing {
namespace {

using ::testing::HasSubstr;

constexpr char kListen[] = "runtime { listen_address: \"127.0.0.1:0\" log_level: \"error\" }\n";

class HealthCommand : public ::testing::Test {
 protected:
  static Finished Health(const std::vector<std::string>& arguments) {
    std::vector<std::string> all = {"health"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return RunProgram("flair", all);
  }

  TestFolder folder_;
  ServerProgram optimizer_{"flair-optimizer", kListen, folder_.path()};
};

TEST_F(HealthCommand, IsDoneWhenTheServerAndTheServiceServe) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{optimizer_.address()},
                                                    {optimizer_.address(), "--service", "flair.v1.OptimizerService"}}) {
    const Finished run = Health(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("SERVING"));
  }
}

TEST_F(HealthCommand, NamesAServiceThatIsNotThere) {
  const Finished run = Health({optimizer_.address(), "--service", "flair.v1.RendererService"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("flair.v1.RendererService at " + optimizer_.address()));
}

TEST_F(HealthCommand, FailsWhenTheServerIsGoneOrSilent) {
  const std::string address = optimizer_.address();
  optimizer_.process().Signal(SIGSTOP);
  const Finished silent = Health({address, "--patience", "0.3"});
  EXPECT_EQ(silent.exit_code, 3) << silent.err;
  EXPECT_THAT(silent.err, HasSubstr(address));
  optimizer_.process().Signal(SIGKILL);
  optimizer_.process().Wait();
  const Finished gone = Health({address});
  EXPECT_EQ(gone.exit_code, 3) << gone.err;
  EXPECT_THAT(gone.err, HasSubstr(address));
}

TEST_F(HealthCommand, RefusesWhatIsNoAddressAndNoPatience) {
  EXPECT_EQ(Health({"nowhere"}).exit_code, 2);
  const Finished run = Health({optimizer_.address(), "--patience", "nan"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("--patience"));
}

}  // namespace
}  // namespace flair::testing
