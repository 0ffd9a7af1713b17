// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/prepare_tokens.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "english/lexicon.h"

namespace flair::translator {
namespace {

// "Backed directly onto": adverbs that say nothing of places do not come between the words of a phrase.
void DropAdverbs(std::vector<Token>& tokens) {
  static constexpr std::array<std::string_view, 9> kAdverbs = {
      "always", "generally", "directly", "immediately", "firmly", "securely", "properly", "safely", "neatly"};
  std::erase_if(tokens, [](const Token& token) {
    return token.kind == Token::Kind::kWord &&
           std::find(kAdverbs.begin(), kAdverbs.end(), token.text) != kAdverbs.end();
  });
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
      const bool relates = Lexicon::Get().Find(tokens, end + 1 + verb).word_class == english::v1::WORD_CLASS_RELATION;
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

bool SpaceBefore(const std::vector<Token>& tokens, size_t end) {
  static constexpr std::array<std::string_view, 6> kSpaces = {"space", "room", "clearance", "gap", "distance", "area"};
  constexpr size_t kFar = 12;
  const auto last = tokens.begin() + static_cast<long>(end);
  return std::any_of(last - static_cast<long>(std::min(end, kFar)), last, [](const Token& token) {
    return std::find(kSpaces.begin(), kSpaces.end(), token.text) != kSpaces.end();
  });
}

// "At least one accessible side" is at least one side accessible.
void MoveAdjectiveBehindSide(std::vector<Token>& tokens) {
  static constexpr std::array<std::string_view, 4> kAdjectives = {"accessible", "unobstructed", "unblocked",
                                                                  "reachable"};
  static constexpr std::array<std::string_view, 3> kOpen = {"clear", "free", "open"};
  for (size_t i = 0; i + 1 < tokens.size(); ++i) {
    const bool open = std::find(kOpen.begin(), kOpen.end(), tokens[i].text) != kOpen.end();
    const bool adjective =
        open || std::find(kAdjectives.begin(), kAdjectives.end(), tokens[i].text) != kAdjectives.end();
    size_t side = i + 1;
    while (side < tokens.size() && (tokens[side].IsWord("long") || tokens[side].IsWord("short"))) ++side;
    if (!adjective || side >= tokens.size() || (side + 1 < tokens.size() && tokens[side + 1].IsMark(':'))) continue;
    // "Space on one accessible side", "near the accessible side": which side, not that it is to be got at.
    const bool at_side =
        i > 1 && (tokens[i - 2].IsWord("on") || tokens[i - 2].IsWord("at") || tokens[i - 2].IsWord("along"));
    const bool to_side =
        i > 1 && (tokens[i - 2].IsWord("to") || tokens[i - 2].IsWord("near")) && tokens[i - 1].IsWord("the");
    const bool begins =
        i > 1 && i < 5 && tokens[i - 2].IsWord("along") && (i == 2 || tokens[i - 3].kind == Token::Kind::kSign);
    const bool after_space = to_side || begins || (at_side && SpaceBefore(tokens, i));
    if (after_space) {
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
    const Distance& a = tokens[i].length;
    const Distance& b = tokens[other].length;
    const bool range = a.min_m.has_value() != a.max_m.has_value() && b.min_m.has_value() != b.max_m.has_value() &&
                       a.min_m.has_value() != b.min_m.has_value();
    if (!range) continue;
    tokens[i].length = {a.min_m ? a.min_m : b.min_m, a.max_m ? a.max_m : b.max_m, false};
    tokens[i].end = tokens[other].end;
    tokens.erase(tokens.begin() + static_cast<long>(i) + 1, tokens.begin() + static_cast<long>(other) + 1);
  }
}

// "Against a wall for stability and should not block windows": with "and" and a verb of its own a new clause begins,
// after which the reason is over. "To save space and ensure access" may be one reason still.
void EndReasonBeforeClause(std::vector<Token>& tokens) {
  static constexpr std::array<std::string_view, 10> kModals = {"should",  "must", "needs", "need",   "requires",
                                                               "require", "can",  "avoid", "cannot", "shall"};
  static constexpr std::array<std::string_view, 5> kSideWords = {"front", "back", "rear", "left", "right"};
  constexpr size_t kLongestSubject = 10;
  static constexpr std::array<std::string_view, 4> kWishes = {"ensure", "make", "keep", "leave"};
  const auto is_one_of = [](const auto& words, const Token& token) {
    return std::find(words.begin(), words.end(), token.text) != words.end();
  };
  std::string_view reason;
  for (size_t i = 0; i + 1 < tokens.size(); ++i) {
    if (tokens[i].IsMark('.') || tokens[i].IsMark(',')) reason = "";
    if (tokens[i].IsWord("for") || tokens[i].IsWord("to")) reason = tokens[i].text;
    if (reason.empty() || !tokens[i].IsWord("and")) continue;
    // "On the front and back sides must be space": both are of one list.
    if (i > 0 && is_one_of(kSideWords, tokens[i - 1]) && is_one_of(kSideWords, tokens[i + 1])) continue;
    // "... and the front should be accessible".
    bool clause = is_one_of(kModals, tokens[i + 1]) || (reason == "for" && is_one_of(kWishes, tokens[i + 1]));
    for (size_t k = i + 2; k < std::min(tokens.size(), i + kLongestSubject) && !clause; ++k) {
      if (tokens[k].kind == Token::Kind::kSign || tokens[k].IsWord("and")) break;
      clause = tokens[k].IsWord("should") || tokens[k].IsWord("must") || tokens[k].IsWord("needs");
    }
    if (clause) {
      tokens[i].kind = Token::Kind::kSign;
      tokens[i].text = ",";
      reason = "";
    }
  }
}

// "Accessible while seated at the desk": from the desk.
void TakePostureAsPlace(std::vector<Token>& tokens) {
  for (size_t i = 1; i + 2 < tokens.size(); ++i) {
    const bool when = tokens[i].IsWord("while") || tokens[i].IsWord("when");
    const std::string& doing = tokens[i + 1].text;
    const bool posture = doing.ends_with("ing") || doing == "seated";
    const bool place = tokens[i + 2].IsWord("at") || tokens[i + 2].IsWord("in") || tokens[i + 2].IsWord("on");
    if (!when || !posture || !place) continue;
    tokens[i].text = "from";
    tokens.erase(tokens.begin() + static_cast<long>(i) + 1, tokens.begin() + static_cast<long>(i) + 3);
  }
}

// "At least 0.5 m left between them": what remains, no side.
void DropLeftOver(std::vector<Token>& tokens) {
  static constexpr std::array<std::string_view, 8> kAfter = {"between", "over", "free", "open",
                                                             "clear",   "in",   "for",  "behind"};
  for (size_t i = 1; i + 1 < tokens.size(); ++i) {
    const Token& before = tokens[i - 1];
    const bool amount =
        before.kind == Token::Kind::kLength || before.IsWord("space") || before.IsWord("room") || before.IsWord("gap");
    const bool goes_on = std::find(kAfter.begin(), kAfter.end(), tokens[i + 1].text) != kAfter.end();
    if (tokens[i].IsWord("left") && amount && goes_on) tokens.erase(tokens.begin() + static_cast<long>(i));
  }
}

// "There should be room to stand", "leave room behind it": space, not the room.
void TakeRoomAsSpace(std::vector<Token>& tokens) {
  static constexpr std::array<std::string_view, 17> kBefore = {
      "with", "be",     "is",   "have",     "has",   "leave",    "leaves",  "leaving", "allow",
      "some", "enough", "need", "requires", "needs", "provides", "provide", "of"};
  static constexpr std::array<std::string_view, 9> kAfter = {"for",    "to", "in", "behind", "around",
                                                             "beside", "on", "at", "between"};
  const auto is_one_of = [](const auto& words, const Token& token) {
    return std::find(words.begin(), words.end(), token.text) != words.end();
  };
  for (size_t i = 0; i + 1 < tokens.size(); ++i) {
    const bool begins = i == 0 && (tokens[1].IsWord("for") || tokens[1].IsWord("to"));
    if (tokens[i].IsWord("room") && (begins || (i > 0 && is_one_of(kBefore, tokens[i - 1]))) &&
        is_one_of(kAfter, tokens[i + 1]))
      tokens[i].text = "space";
  }
}

// "Right by the door", "right behind it": how close, not which side. "Its right against the wall" is one.
void DropRightBeforePlace(std::vector<Token>& tokens) {
  for (size_t i = 0; i + 1 < tokens.size(); ++i) {
    const bool place = IsOneOf(tokens[i + 1], {"by", "at", "beside", "next", "near", "under", "below", "above", "over",
                                               "behind", "opposite", "inside", "beneath", "underneath"});
    const bool side = i > 0 && IsOneOf(tokens[i - 1], {"the", "its", "their", "and", "or", "on", "to", "'s"});
    if (tokens[i].IsWord("right") && place && !side) tokens.erase(tokens.begin() + static_cast<long>(i));
  }
}

// "The sink backs onto a wall": its back is against it.
void ReadBacksOnto(std::vector<Token>& tokens) {
  for (size_t i = 0; i + 1 < tokens.size(); ++i) {
    if (!tokens[i].IsWord("backs") || !IsOneOf(tokens[i + 1], {"onto", "on", "up"})) continue;
    const size_t last = i + (tokens[i + 1].IsWord("on") && i + 2 < tokens.size() && tokens[i + 2].IsWord("to") ? 2 : 1);
    tokens[i].text = "back";
    tokens[i + 1] = WordLike(tokens[i + 1], tokens[i + 1].IsWord("up") ? "up" : "against");
    if (last == i + 2) tokens.erase(tokens.begin() + static_cast<long>(last));
  }
}

// "In its way" is in the way of it; "is to its left" is to the left of it.
void PutPossessorLast(std::vector<Token>& tokens) {
  std::vector<Token> out;
  for (size_t i = 0; i < tokens.size(); ++i) {
    out.push_back(tokens[i]);
    if (i + 2 >= tokens.size() || !IsOneOf(tokens[i + 1], {"its", "their"})) continue;
    const bool verb = i > 0 && IsOneOf(tokens[i - 1], {"is", "are", "be", "stands", "stand", "goes", "sits", "placed",
                                                       "located", "positioned"});
    const bool way = tokens[i].IsWord("in") && tokens[i + 2].IsWord("way");
    const bool ends = i + 3 == tokens.size() || tokens[i + 3].kind == Token::Kind::kSign ||
                      IsOneOf(tokens[i + 3], {"so", "because", "for", "to", "while", "and", "with", "since"});
    const bool side = tokens[i].IsWord("to") && (verb || ends) && IsOneOf(tokens[i + 2], {"left", "right"});
    if (!way && !side) continue;
    out.push_back(WordLike(tokens[i + 1], "the"));
    out.push_back(tokens[i + 2]);
    out.push_back(WordLike(tokens[i + 2], "of"));
    out.push_back(WordLike(tokens[i + 1], tokens[i + 1].IsWord("its") ? "it" : "them"));
    i += 2;
  }
  tokens = std::move(out);
}

}  // namespace

bool BeginsReason(const std::vector<Token>& tokens, size_t at) {
  static constexpr std::array<std::string_view, 20> kVerbs = {
      "allow", "ensure", "provide", "maintain", "give",   "leave", "create", "enable", "facilitate",  "help",
      "let",   "make",   "keep",    "permit",   "reduce", "ease",  "offer",  "have",   "accommodate", "minimize"};
  if (!tokens[at].IsWord("to") || at + 1 >= tokens.size()) return false;
  return std::any_of(kVerbs.begin(), kVerbs.end(), [&](std::string_view verb) { return tokens[at + 1].IsWord(verb); });
}

std::vector<Token> PrepareTokens(std::vector<Token> tokens) {
  JoinBounds(tokens);
  EndReasonBeforeClause(tokens);
  DropLeftOver(tokens);
  TakePostureAsPlace(tokens);
  DropAdverbs(tokens);
  DropRightBeforePlace(tokens);
  ReadBacksOnto(tokens);
  PutPossessorLast(tokens);
  JoinNeitherNor(tokens);
  TakeRoomAsSpace(tokens);
  MoveAdjectiveBehindSide(tokens);
  return tokens;
}

}  // namespace flair::translator
