// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string_view>

#include "english/frames/token_context.h"
#include "english/language.h"
#include "english/lexicon.h"

namespace flair::english {
namespace {

// "Backed directly onto": adverbs that say nothing of places do not come between the words of a phrase.
void DropAdverbs(std::vector<Token>& tokens) {
  std::erase_if(tokens, [](const Token& token) { return IsIn("idle adverbs", token); });
}

Token WordLike(const Token& token, std::string_view text) {
  Token word = token;
  word.text = text;
  return word;
}

// "Neither X nor Y" denies a list, "neither chair" and "neither of the chairs" deny something of each.
void JoinNeitherNor(std::vector<Token>& tokens) {
  bool denied = false;
  for (size_t i = 0; i < tokens.size(); ++i) {
    denied = (denied || tokens[i].IsWord("not") || tokens[i].IsWord("avoid")) && !tokens[i].IsMark('.');
    // "Not block the door nor the window".
    const bool list = i + 1 < tokens.size() && (tokens[i + 1].IsWord("the") || tokens[i + 1].IsWord("any"));
    if (denied && list && tokens[i].IsWord("nor")) tokens[i].text = "and";
    if (!tokens[i].IsWord("neither")) continue;
    bool listed = false;
    size_t end = i + 1;
    for (; end < tokens.size() && !tokens[end].IsMark('.'); ++end) {
      if (!tokens[end].IsWord("nor")) continue;
      tokens[end].text = "and";
      listed = true;
      // "Neither beside nor opposite the sink", "nor stand next to it": the second relation is denied as well.
      const size_t verb = end + 1 < tokens.size() && IsOneOf(tokens[end + 1], {"stand", "be", "sit", "lie"}) ? 1 : 0;
      const bool relates = Lexicon::Get().Find(tokens, end + 1 + verb).word_class == v1::WORD_CLASS_RELATION;
      if (relates && end + 1 < tokens.size() && Lexicon::Get().Find(tokens, end + 1).length > 0)
        tokens.insert(tokens.begin() + static_cast<long>(end) + 1, WordLike(tokens[end], "not"));
    }
    if (listed) continue;
    tokens[i].text = "neither_one";
    while (i + 1 < end && (tokens[i + 1].IsWord("of") || tokens[i + 1].IsWord("the"))) {
      tokens.erase(tokens.begin() + static_cast<long>(i) + 1);
      --end;
    }
  }
}

// "At least one accessible side" is at least one side accessible.
void MoveAdjectiveBehindSide(std::vector<Token>& tokens) {
  for (size_t i = 0; i + 1 < tokens.size(); ++i) {
    const bool open = IsIn("open adjectives", tokens[i]);
    const bool adjective = open || IsIn("access adjectives", tokens[i]);
    size_t side = i + 1;
    while (side < tokens.size() && (tokens[side].IsWord("long") || tokens[side].IsWord("short"))) ++side;
    if (!adjective || side >= tokens.size() || (side + 1 < tokens.size() && tokens[side + 1].IsMark(':'))) continue;
    // "Near the accessible side": which side, not that it is to be got at.
    if (i > 1 && tokens[i - 1].IsWord("the") && !tokens[i - 2].IsMark('.')) {
      tokens.erase(tokens.begin() + static_cast<long>(i));
      continue;
    }
    const bool end = tokens[side].IsWord("front") || tokens[side].IsWord("back");
    if (end && side + 1 < tokens.size() && tokens[side + 1].IsWord("side")) ++side;
    const bool after_article = i == 0 || tokens[i - 1].IsWord("an") || tokens[i - 1].IsWord("a");
    const bool named = !open && (tokens[side].IsWord("side") || tokens[side].IsWord("sides"));
    if (!named && !(end && after_article)) continue;
    if (open) tokens[i].text = "accessible";
    std::rotate(tokens.begin() + static_cast<long>(i), tokens.begin() + static_cast<long>(i) + 1,
                tokens.begin() + static_cast<long>(side) + 1);
    i = side;
  }
}

// "At least 0.3 m and at most 0.6 m": one range.
void JoinBounds(std::vector<Token>& tokens) {
  const auto is_length = [](const Token& token) { return token.kind == Token::Kind::kLength; };
  for (size_t i = 0; i + 2 < tokens.size(); ++i) {
    size_t other = i + 1;
    if (tokens[other].IsMark(',')) ++other;
    if (other + 1 < tokens.size() && (tokens[other].IsWord("and") || tokens[other].IsWord("but"))) ++other;
    if (other == i + 1 || other >= tokens.size() || !is_length(tokens[i]) || !is_length(tokens[other])) continue;
    const Length& a = tokens[i].length;
    const Length& b = tokens[other].length;
    const bool range = a.min_m.has_value() != a.max_m.has_value() && b.min_m.has_value() != b.max_m.has_value() &&
                       a.min_m.has_value() != b.min_m.has_value();
    if (!range) continue;
    tokens[i].length = {a.min_m ? a.min_m : b.min_m, a.max_m ? a.max_m : b.max_m, false};
    tokens[i].end = tokens[other].end;
    tokens.erase(tokens.begin() + static_cast<long>(i) + 1, tokens.begin() + static_cast<long>(other) + 1);
  }
}

// "There should be room to stand", "leave room behind it": space, not the room.
void TakeRoomAsSpace(std::vector<Token>& tokens) {
  for (size_t i = 0; i + 1 < tokens.size(); ++i) {
    const bool begins = i == 0 && (tokens[1].IsWord("for") || tokens[1].IsWord("to"));
    if (tokens[i].IsWord("room") && (begins || (i > 0 && IsIn("before space", tokens[i - 1]))) &&
        IsIn("after space", tokens[i + 1]))
      tokens[i].text = "space";
  }
}

}  // namespace

bool BeginsReason(const std::vector<Token>& tokens, size_t at) {
  return tokens[at].IsWord("to") && at + 1 < tokens.size() && IsIn("reason verbs", tokens[at + 1]);
}

std::vector<Token> PrepareTokens(std::vector<Token> tokens) {
  JoinBounds(tokens);
  DropAdverbs(tokens);
  JoinNeitherNor(tokens);
  TakeRoomAsSpace(tokens);
  MoveAdjectiveBehindSide(tokens);
  return tokens;
}

}  // namespace flair::english
