// SPDX-License-Identifier: GPL-3.0-or-later
#include "english/wordnet.h"

#include <algorithm>
#include <string>

#include "absl/status/status.h"
#include "gtest/gtest.h"

namespace flair::english {
namespace {

bool IsAKindOf(std::string_view word, std::string_view kind) {
  const std::optional<NounSense> sense = WordNet::Get().Find(kind);
  return sense && std::ranges::any_of(WordNet::Get().SensesOf(word), [&](const NounSense& meaning) {
           const std::vector<Kind> kinds = WordNet::Get().KindsOf(meaning);
           return std::ranges::find(kinds, sense->id, &Kind::id) != kinds.end();
         });
}

TEST(WordNet, IsInstalled) { EXPECT_TRUE(WordNet::CheckInstalled().ok()) << WordNet::CheckInstalled(); }

TEST(WordNet, NamesThePackageWhereFilesAreMissing) {
  const absl::Status status = WordNet::Open("/nowhere").status();
  EXPECT_EQ(status.code(), absl::StatusCode::kNotFound);
  EXPECT_NE(status.message().find("wordnet-base"), std::string::npos) << status;
}

TEST(WordNet, KnowsWhatThingsAre) {
  EXPECT_TRUE(IsAKindOf("jukebox", "machine"));
  EXPECT_TRUE(IsAKindOf("settles", "furniture"));
  EXPECT_TRUE(IsAKindOf("coffins", "container"));
  EXPECT_TRUE(IsAKindOf("rocking chair", "chair"));
  EXPECT_TRUE(IsAKindOf("gardener", "person"));
  EXPECT_FALSE(IsAKindOf("gardener", "furniture"));
  EXPECT_FALSE(IsAKindOf("zxcvb", "entity"));
}

TEST(WordNet, OrdersKindsByTheirDistance) {
  const WordNet& words = WordNet::Get();
  const std::vector<Kind> kinds = words.KindsOf(*words.Find("settle"));
  EXPECT_EQ(kinds.front().steps, 0);
  EXPECT_TRUE(std::ranges::is_sorted(kinds, {}, &Kind::steps));
  const auto bench = std::ranges::find(kinds, words.Find("bench")->id, &Kind::id);
  ASSERT_NE(bench, kinds.end());
  EXPECT_EQ(bench->steps, 1);
}

TEST(WordNet, TellsSensesApart) {
  const WordNet& words = WordNet::Get();
  ASSERT_TRUE(words.Find("hammock#2"));
  EXPECT_EQ(words.Find("hammock#2")->domain, Domain::kArtifact);
  EXPECT_NE(words.Find("hammock#1")->domain, Domain::kArtifact);
  EXPECT_FALSE(words.Find("hammock#9"));
  EXPECT_EQ(words.Find("velvet")->domain, Domain::kArtifact);
  EXPECT_EQ(words.Find("granite")->domain, Domain::kSubstance);
}

TEST(WordNet, KnowsPartsOfSpeech) {
  const WordNet& words = WordNet::Get();
  EXPECT_TRUE(words.IsAdjective("velvety"));
  EXPECT_FALSE(words.IsAdjective("jukebox"));
  EXPECT_TRUE(words.IsVerb("leans"));
  EXPECT_TRUE(words.IsVerb("stacked"));
  EXPECT_TRUE(words.Knows("neatly"));
  EXPECT_FALSE(words.Knows("wardorbe"));
}

// The first and last lines of a file, and what sorts before and behind all of them.
TEST(WordNet, FindsWordsAtTheEnds) {
  const WordNet& words = WordNet::Get();
  EXPECT_FALSE(words.SensesOf("zymurgy").empty());
  EXPECT_TRUE(words.SensesOf("").empty());
  EXPECT_TRUE(words.SensesOf("~~~").empty());
  const std::string endless(100000, 'x');
  EXPECT_TRUE(words.SensesOf(endless).empty());
  EXPECT_FALSE(words.IsVerb(endless) || words.IsAdjective(endless) || words.Knows(endless));
}

}  // namespace
}  // namespace flair::english
