// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/brief_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "cli/output/artifact_text.h"
#include "fmt/format.h"
#include "orchestrator/store/artifact_id.h"
#include "tests/fixtures/bedroom.h"

namespace flair::cli {
namespace {

using ::testing::HasSubstr;

std::string FileWith(const std::string& bytes) {
  const std::string path = fmt::format("{}/brief_{}", ::testing::TempDir(), getpid());
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

v1::Brief Wanted() {
  v1::Brief brief;
  brief.set_text("A bedroom.");
  brief.set_seed(3);
  brief.mutable_zone_plan()->add_zones()->set_id("sleeping");
  brief.mutable_zone_plan()->mutable_zones(0)->set_name("sleeping");
  return brief;
}

TEST(ReadBrief, TakesTextJsonAndArtifacts) {
  v1::Artifact artifact;
  *artifact.mutable_brief() = Wanted();
  artifact.set_id(orchestrator::ComputeArtifactId(artifact));
  for (const std::string& bytes : {ToText(Wanted()), ToJson(Wanted()), ToJson(artifact), ArtifactBytes(artifact)}) {
    const absl::StatusOr<v1::Brief> brief = ReadBrief("--brief", FileWith(bytes));
    ASSERT_TRUE(brief.ok()) << brief.status() << bytes;
    EXPECT_EQ(brief->SerializeAsString(), Wanted().SerializeAsString());
  }
}

TEST(ReadBrief, NamesFlagFilePlaceAndWhatIsRight) {
  EXPECT_EQ(ReadBrief("--brief", "/no/such/brief").status().message(), "--brief: /no/such/brief: no such file");
  for (const std::string& bytes : {"txet: \"A bedroom.\"", "{\"txet\": \"A bedroom.\"}"}) {
    const absl::Status status = ReadBrief("--brief", FileWith(bytes)).status();
    EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
    EXPECT_THAT(std::string(status.message()), ::testing::AllOf(HasSubstr("--brief: "), HasSubstr("txet"),
                                                                HasSubstr("should hold a Brief, such as: text: ")));
  }
}

TEST(ReadBrief, RefusesAnArtifactOfAnotherKind) {
  v1::Artifact artifact;
  *artifact.mutable_room() = testing::BedroomRoom();
  artifact.set_id(orchestrator::ComputeArtifactId(artifact));
  EXPECT_THAT(std::string(ReadBrief("--brief", FileWith(ArtifactBytes(artifact))).status().message()),
              HasSubstr("an artifact without a brief"));
}

}  // namespace
}  // namespace flair::cli
