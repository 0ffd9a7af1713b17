// SPDX-License-Identifier: GPL-3.0-or-later
#include "english/lexicon.h"

#include "gtest/gtest.h"

namespace flair::english {
namespace {

TEST(PhraseBook, FindsTheLongestOfAllOptions) {
  PhraseBook book;
  book.Add("[flush] (against|on [top of]) it", 1);
  book.Add("on", 2);
  book.Add("on top of it", 3);
  const auto find = [&](const char* text, size_t most = PhraseBook::kAnyLength) {
    const PhraseBook::Match match = book.Find(Tokenize(text), 0, most);
    return std::pair(match.value, match.length);
  };
  EXPECT_EQ(find("flush against it"), std::pair(1, size_t{3}));
  EXPECT_EQ(find("on it"), std::pair(1, size_t{2}));
  EXPECT_EQ(find("on the table"), std::pair(2, size_t{1}));
  // Of equals the one added first.
  EXPECT_EQ(find("on top of it"), std::pair(1, size_t{4}));
  EXPECT_EQ(find("on top of it", 2), std::pair(2, size_t{1}));
  EXPECT_EQ(find("against"), std::pair(-1, size_t{0}));
}

TEST(PhraseBook, TakesTheLastWordInAnotherForm) {
  PhraseBook book;
  book.Add("coffee table", 1);
  EXPECT_EQ(book.Find(Tokenize("coffee tables"), 0).length, 0u);
  EXPECT_EQ(book.Find(Tokenize("coffee tables"), 0, PhraseBook::kAnyLength, /*last_form=*/true).length, 2u);
}

TEST(Lexicon, KnowsRelationsAndTheirOtherForms) {
  const Phrase close = Lexicon::Get().Find(Tokenize("close to the bed"), 0);
  EXPECT_EQ(close.word_class, v1::WORD_CLASS_RELATION);
  EXPECT_EQ(close.lemma, "near");
  EXPECT_EQ(close.length, 2u);
  EXPECT_EQ(Lexicon::Get().FindForm(Tokenize("overlapped")[0]).lemma, "block");
  EXPECT_EQ(Lexicon::Get().FindForm(Tokenize("sofa")[0]).length, 0u);
}

}  // namespace
}  // namespace flair::english
