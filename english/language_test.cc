// SPDX-License-Identifier: GPL-3.0-or-later
#include "english/language.h"

#include <filesystem>
#include <fstream>

#include "english/lexicon.h"
#include "gtest/gtest.h"

namespace flair::english {
namespace {

namespace fs = std::filesystem;

TEST(Language, TheInstalledDataIsInOrder) {
  EXPECT_TRUE(Language::CheckInstalled().ok()) << Language::CheckInstalled();
}

TEST(Language, SaysWhereDataIsWrong) {
  EXPECT_EQ(Language::Load("/nonexistent").status().code(), absl::StatusCode::kNotFound);
  const fs::path folder = fs::path(testing::TempDir()) / "language_of_faults";
  fs::create_directories(folder);
  std::ofstream(folder / "a.textproto") << "numbers { word: \"one\" value: 1 }\nnumbers { wort: \"two\" }\n";
  std::ofstream(folder / "b.textproto") << "units { words: \"m\" size: 1 }\n";
  const absl::Status status = Language::Load(folder).status();
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
  EXPECT_NE(status.message().find("a.textproto:2:"), std::string::npos) << status;
  EXPECT_NE(status.message().find("units: m needs"), std::string::npos) << status;
  fs::remove_all(folder);
}

}  // namespace
}  // namespace flair::english
