// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/message_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/output/artifact_text.h"
#include "flair/v1/artifact.pb.h"
#include "flair/v1/job.pb.h"
#include "tests/fixtures/bedroom.h"

namespace flair::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string NameOfField(const google::protobuf::Descriptor& type, const std::string& field) {
  return NameInWords(*type.FindFieldByName(field));
}

TEST(MessageView, NamesOfFieldsAreWords) {
  const auto& opening = *v1::Opening::descriptor();
  EXPECT_EQ(NameOfField(opening, "head_height_m"), "head height");
  EXPECT_EQ(NameOfField(*v1::Object::descriptor(), "zone_id"), "zone");
  EXPECT_EQ(NameOfField(*v1::Sentence::descriptor(), "subject_ids"), "subjects");
  EXPECT_EQ(NameOfField(*v1::StageOutcome::descriptor(), "restart_count"), "restarts");
  EXPECT_EQ(NameOfField(*v1::ConstraintSummary::descriptor(), "satisfied_count"), "satisfied");
  EXPECT_EQ(NameOfField(*v1::Placement::descriptor(), "theta_rad"), "heading");
  EXPECT_EQ(NameOfField(*v1::Object::descriptor(), "id"), "id");
}

TEST(MessageView, ValuesHaveTheirUnitsAndEnumsTheirWords) {
  v1::LayoutMetrics metrics;
  metrics.set_reachable_floor_share(0.985);
  metrics.set_deepest_overlap_m(1e-17);
  EXPECT_EQ(FieldsInWords(metrics),
            "OOB 0 %, OOR 0 %, reachable floor 98.5 %, reachable front 0 %, pathway cost 0 m3, deepest overlap 0 m");
  EXPECT_EQ(EnumInWords(v1::JOB_STATE_SUCCEEDED), "succeeded");
  EXPECT_EQ(EnumInWords(v1::ARTIFACT_KIND_RAW_CONSTRAINT_LIST), "raw constraint list");
  EXPECT_EQ(EnumInWords(static_cast<v1::JobState>(99)), "unknown");
}

TEST(MessageView, ColumnsThatNothingFillsAreLeftOut) {
  const std::string table = ListTable(testing::BedroomRoom(), "openings", "OPENINGS", 10);
  EXPECT_THAT(table, HasSubstr("\nOPENINGS, 1\nopening  kind  wall   offset m  width m"));
  EXPECT_THAT(table, Not(HasSubstr("description")));
  EXPECT_EQ(ListTable(v1::Room(), "openings", "OPENINGS", 10), "");
}

// As a newer orchestrator or a damaged store may name one.
TEST(FileStem, OfAnUnknownKindIsEmpty) {
  EXPECT_EQ(FileStem(v1::ARTIFACT_KIND_ROOM), "room");
  for (const int kind : {-7, 10, 13, 1 << 30}) EXPECT_EQ(FileStem(static_cast<v1::ArtifactKind>(kind)), "") << kind;
}

}  // namespace
}  // namespace flair::cli
