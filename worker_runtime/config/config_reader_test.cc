// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/config/config_reader.h"

#include <gmock/gmock.h>

#include "flair/config/v1/orchestrator_config.pb.h"

namespace flair::runtime {
namespace {

using ::testing::HasSubstr;

absl::Status Read(const std::string& text, config::v1::OrchestratorConfig& config) {
  return ReadConfigText("test.textproto", text, config, [&](ConfigChecker& checker) {
    if (config.stages().language().empty()) checker.Report("stages.language", "missing");
    checker.Range("running_job_limit", config.running_job_limit(), 0, 256);
  });
}

std::string ErrorOf(const std::string& text) {
  config::v1::OrchestratorConfig config;
  const absl::Status status = Read(text, config);
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
  return std::string(status.message());
}

TEST(ReadConfig, TakesAGoodFile) {
  config::v1::OrchestratorConfig config;
  EXPECT_TRUE(
      Read("runtime { queue_limit: 7 }\nstages { language: \"a:1\" }\n# remark\nrunning_job_limit: 3", config).ok());
  EXPECT_EQ(config.runtime().queue_limit(), 7);
  EXPECT_EQ(config.running_job_limit(), 3);
}

TEST(ReadConfig, ReportsEveryBadFieldWithItsLine) {
  EXPECT_EQ(ErrorOf("runtime {\n  queue_limit: -1\n  log_level: \"loud\"\n}\nstages {\n  langauge: \"a:1\"\n}\n"
                    "running_job_limit: 300\n"),
            "test.textproto:2: runtime.queue_limit: -1 is out of range [1, 100000]\n"
            "test.textproto:3: runtime.log_level: \"loud\" is not a level; expected debug, info, warning or error\n"
            "test.textproto:5: stages.language: missing\n"
            "test.textproto:6: Message type \"flair.config.v1.StageAddresses\" has no field named \"langauge\".\n"
            "test.textproto:8: running_job_limit: 300 is out of range [0, 256]");
}

TEST(ReadConfig, SaysWhatALogFormatAndAnAddressOfFiguresMayBe) {
  const std::string error =
      ErrorOf("runtime {\n  log_format: \"xml\"\n  metrics_address: \"9090\"\n}\nstages { language: \"a:1\" }\n");
  EXPECT_THAT(error,
              HasSubstr("test.textproto:2: runtime.log_format: \"xml\" is not a format; expected text or json\n"));
  EXPECT_THAT(error, HasSubstr("test.textproto:3: runtime.metrics_address: \"9090\": expected HOST:PORT with a port in "
                               "[0, 65535], such as 127.0.0.1:9090"));
}

TEST(ReadConfig, ReportsAValueOfTheWrongTypeWithItsLine) {
  EXPECT_THAT(ErrorOf("stages { language: \"a:1\" }\nrunning_job_limit: \"many\""),
              HasSubstr("test.textproto:2: Expected integer"));
}

TEST(ReadConfig, TakesAThousandThreadsForWorkersThatWaitForAModel) {
  config::v1::OrchestratorConfig config;
  EXPECT_TRUE(Read("runtime { worker_thread_count: 1024 } stages { language: \"a:1\" }", config).ok());
  EXPECT_EQ(ErrorOf("runtime { worker_thread_count: 1025 } stages { language: \"a:1\" }"),
            "test.textproto:1: runtime.worker_thread_count: 1025 is out of range [1, 1024]");
}

TEST(ReadConfig, SaysWhichFileIsMissing) {
  config::v1::OrchestratorConfig config;
  const absl::Status status = ReadConfigFile("/no/such/file.textproto", config, nullptr);
  EXPECT_EQ(status.code(), absl::StatusCode::kNotFound);
  EXPECT_THAT(std::string(status.message()), HasSubstr("/no/such/file.textproto: cannot read"));
}

TEST(ReadConfig, DescribesEveryField) {
  const std::string text = DescribeConfig(*config::v1::OrchestratorConfig::descriptor());
  EXPECT_THAT(text, HasSubstr("runtime.listen_address"));
  EXPECT_THAT(text, HasSubstr("stages.optimizer"));
}

}  // namespace
}  // namespace flair::runtime
