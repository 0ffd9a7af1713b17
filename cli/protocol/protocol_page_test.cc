// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "cli/protocol/protocol.h"

namespace flair::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

// What GitHub would make of the page's headings.
std::multiset<std::string> AnchorsOf(const std::string& page) {
  std::multiset<std::string> anchors;
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("#")) continue;
    std::string anchor;
    for (const char c : line.substr(line.find(' ') + 1)) {
      if (std::isalnum(static_cast<unsigned char>(c)) != 0) anchor += static_cast<char>(std::tolower(c));
      if (c == ' ') anchor += '-';
    }
    anchors.insert(anchor);
  }
  return anchors;
}

TEST(ProtocolPage, IsNotStale) {
  std::ifstream file(FLAIR_SOURCE_DIR "/docs/protocol.md");
  std::stringstream page;
  page << file.rdbuf();
  EXPECT_TRUE(page.str() == ProtocolMarkdown()) << "write it anew: flair protocol --markdown > docs/protocol.md";
}

TEST(ProtocolPage, EveryLinkLeadsToOneHeading) {
  const std::string page = ProtocolMarkdown();
  const std::multiset<std::string> anchors = AnchorsOf(page);
  const std::regex link(R"(\]\(#([^)]*)\))");
  int count = 0;
  for (std::sregex_iterator at(page.begin(), page.end(), link), end; at != end; ++at, ++count) {
    EXPECT_EQ(anchors.count((*at)[1]), 1U) << (*at)[1];
  }
  EXPECT_GT(count, 300);
}

TEST(ProtocolPage, ReadsAllFilesInAnOrderChosenForPeople) {
  EXPECT_GE(ProtocolFiles().size(), 26U);
  for (const auto& [title, file] : ProtocolFiles()) {
    EXPECT_FALSE(title.ends_with(".proto")) << title << ": give it a place and a title in protocol.cc";
  }
}

TEST(ProtocolPage, NothingIsWithoutAComment) {
  for (const auto& [title, file] : ProtocolFiles()) {
    for (int i = 0; i < file->message_type_count(); ++i) {
      const auto& message = *file->message_type(i);
      EXPECT_FALSE(CommentOf(message).empty()) << message.full_name();
      for (int k = 0; k < message.field_count(); ++k) {
        EXPECT_FALSE(CommentOf(*message.field(k)).empty()) << message.field(k)->full_name();
      }
    }
  }
}

TEST(ProtocolPage, CommentsBecomeTextThatMarkdownLeavesAlone) {
  const std::string page = ProtocolMarkdown();
  EXPECT_THAT(page, HasSubstr("| `walls` | list of [Wall](#wall) | 4 | One per edge of `floor`, in the same order"));
  EXPECT_THAT(page, HasSubstr("see [Producer.build](#producer)"));
  EXPECT_THAT(page, HasSubstr("**WatchJob**: [WatchJobRequest](#watchjobrequest) → stream of [WatchJobResponse]"));
  EXPECT_THAT(page, HasSubstr("| `time_limit` | `google.protobuf.Duration` | 9 |"));
}

TEST(ProtocolText, FindsServicesCallsMessagesAndEnumsInAnyCase) {
  EXPECT_THAT(ProtocolEntryText("optimizerservice").value(), StartsWith("service OptimizerService\n"));
  EXPECT_THAT(ProtocolEntryText("solve").value(), HasSubstr("Solve(SolveRequest) -> SolveResponse\n"));
  EXPECT_THAT(ProtocolEntryText("Room").value(), HasSubstr("\n  walls = 4: list of Wall\n      One per edge"));
  EXPECT_THAT(ProtocolEntryText("OPENINGKIND").value(), HasSubstr("\n  OPENING_KIND_DOOR = 1\n"));
  EXPECT_EQ(ProtocolEntryText("Table").status().code(), absl::StatusCode::kNotFound);
  EXPECT_EQ(ProtocolEntryText("").status().code(), absl::StatusCode::kNotFound);
}

TEST(ProtocolText, TheOverviewNamesEveryCall) {
  const std::string overview = ProtocolOverview();
  for (const char* name : {"DescribeRoom", "Translate", "SolveRestarts", "ExportScene", "WatchJob", "GetWorker"}) {
    EXPECT_THAT(overview, HasSubstr(std::string("\n  ") + name + " "));
  }
}

}  // namespace
}  // namespace flair::cli
