// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/clause_tokens.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace flair::translator {
namespace {

template <typename Words>
bool IsAmong(const Words& words, const Token& token) {
  return token.kind == Token::Kind::kWord && std::find(words.begin(), words.end(), token.text) != words.end();
}

Token Like(const Token& token, Token::Kind kind, std::string_view text) {
  Token made = token;
  made.kind = kind;
  made.text = text;
  return made;
}

// Also after one word that opens a sentence: "Ideally, ...", "Placement: ...".
bool BeginsSentence(const std::vector<Token>& tokens, size_t at) {
  if (at == 0 || tokens[at - 1].IsMark('.')) return true;
  const bool opener = tokens[at - 1].IsMark(',') || tokens[at - 1].IsMark(':');
  return opener && (at == 2 || (at > 2 && tokens[at - 3].IsMark('.')));
}

// "The right of the safe adjoins ...": its right side, where nothing stands before it that could be to the right.
void TakeSideAtBeginning(std::vector<Token>& tokens) {
  for (size_t i = 0; i + 2 < tokens.size(); ++i) {
    const bool side = IsOneOf(tokens[i + 1], {"left", "right"}) && tokens[i + 2].IsWord("of");
    if (!tokens[i].IsWord("the") || !side || !BeginsSentence(tokens, i)) continue;
    tokens.insert(tokens.begin() + static_cast<long>(i) + 2, Like(tokens[i + 1], Token::Kind::kWord, "side"));
  }
}

// "In order to allow", "so as to allow": to allow.
void ShortenInOrderTo(std::vector<Token>& tokens) {
  std::vector<Token> out;
  for (size_t i = 0; i < tokens.size(); ++i) {
    const bool begins = i + 2 < tokens.size() && tokens[i + 2].IsWord("to") &&
                        ((tokens[i].IsWord("in") && tokens[i + 1].IsWord("order")) ||
                         (tokens[i].IsWord("so") && tokens[i + 1].IsWord("as")));
    if (begins) i += 2;
    out.push_back(std::move(tokens[i]));
  }
  tokens = std::move(out);
}

// "Not so close that ...": how close.
void TakeSoAsDegree(std::vector<Token>& tokens) {
  for (size_t i = 0; i + 1 < tokens.size(); ++i) {
    if (tokens[i].IsWord("so") && IsOneOf(tokens[i + 1], {"close", "near", "far", "tightly"})) tokens[i].text = "too";
  }
}

// "It should not hinder anyone", "so customers are not obstructed": no piece that is kept clear.
void DropCareForPeople(std::vector<Token>& tokens) {
  static constexpr std::array<std::string_view, 16> kPeople = {
      "anyone",    "anybody", "people",   "someone",  "somebody", "customers", "guests",  "users",
      "occupants", "clients", "visitors", "children", "patients", "staff",     "workers", "others"};
  static constexpr std::array<std::string_view, 12> kHinder = {"hinder",   "hinders",   "hindering",  "hindered",
                                                               "obstruct", "obstructs", "obstructed", "impede",
                                                               "impeded",  "blocked",   "disturb",    "disturbed"};
  std::vector<Token> out;
  for (size_t i = 0; i < tokens.size(); ++i) {
    const bool people_hindered = i + 3 < tokens.size() && IsAmong(kPeople, tokens[i]) &&
                                 IsOneOf(tokens[i + 1], {"is", "are", "be"}) && tokens[i + 2].IsWord("not") &&
                                 IsAmong(kHinder, tokens[i + 3]);
    const bool hinder_people = i + 1 < tokens.size() && IsAmong(kHinder, tokens[i]) && IsAmong(kPeople, tokens[i + 1]);
    if (people_hindered) {
      i += 3;
    } else if (hinder_people) {
      ++i;
    } else {
      out.push_back(std::move(tokens[i]));
    }
  }
  tokens = std::move(out);
}

// "Not against a wall but at least 0.3 m from it": from the wall, when only words of measure stand between.
void TakePartOfRoomForIt(std::vector<Token>& tokens) {
  static constexpr std::array<std::string_view, 8> kParts = {"wall", "walls", "window", "windows",
                                                             "door", "doors", "socket", "sockets"};
  static constexpr std::array<std::string_view, 20> kMeasure = {
      "but",  "and", "must", "should", "be",   "at",   "least", "away",  "from",  "kept",
      "with", "a",   "gap",  "of",     "stay", "keep", "stand", "about", "leave", "distance"};
  const Token* part = nullptr;
  bool clause_ended = false;
  for (Token& token : tokens) {
    if (IsAmong(kParts, token)) {
      part = &token;
      clause_ended = false;
      continue;
    }
    clause_ended = clause_ended || token.IsMark(',') || IsOneOf(token, {"but", "and"});
    if (part != nullptr && clause_ended && IsOneOf(token, {"it", "them"}) && (&token - 1)->IsWord("from")) {
      token.text = part->text;
    } else if (!IsAmong(kMeasure, token) && token.kind != Token::Kind::kLength && !token.IsMark(',')) {
      part = nullptr;
    }
  }
}

// "Guests at the tables should see the piano": from the tables.
void TakeWherePeopleAre(std::vector<Token>& tokens) {
  static constexpr std::array<std::string_view, 12> kPeople = {"people",   "guests",   "customers", "visitors",
                                                               "patients", "pupils",   "students",  "clients",
                                                               "someone",  "children", "anyone",    "players"};
  for (size_t i = 0; i + 2 < tokens.size(); ++i) {
    if (!BeginsSentence(tokens, i) || !IsAmong(kPeople, tokens[i])) continue;
    const size_t place = i + (IsOneOf(tokens[i + 1], {"sitting", "seated", "standing", "lying"}) ? 2 : 1);
    const auto end = std::find_if(tokens.begin() + static_cast<long>(place), tokens.end(), [](const Token& token) {
      return token.IsMark('.') || IsOneOf(token, {"see", "watch", "look", "view", "reach"});
    });
    if (end == tokens.end() || end->IsMark('.') || !IsOneOf(tokens[place], {"at", "on", "in"})) continue;
    tokens[place].text = "from";
  }
}

// "1 m of floor must be free": 1 m.
void DropOfFloor(std::vector<Token>& tokens) {
  std::vector<Token> out;
  for (size_t i = 0; i < tokens.size(); ++i) {
    out.push_back(std::move(tokens[i]));
    const bool of_floor = out.back().kind == Token::Kind::kLength && i + 2 < tokens.size() &&
                          tokens[i + 1].IsWord("of") && tokens[i + 2].IsWord("floor");
    if (!of_floor) continue;
    const bool space = i + 3 < tokens.size() && IsOneOf(tokens[i + 3], {"space", "area"});
    i += space ? 3 : 2;
  }
  tokens = std::move(out);
}

// "Near a socket without standing in front of one": of a socket.
void TakePartOfRoomForOne(std::vector<Token>& tokens) {
  static constexpr std::array<std::string_view, 5> kParts = {"wall", "window", "door", "socket", "outlet"};
  const Token* part = nullptr;
  for (size_t i = 0; i < tokens.size(); ++i) {
    if (IsAmong(kParts, tokens[i])) part = &tokens[i];
    const bool last = i + 1 == tokens.size() || tokens[i + 1].kind == Token::Kind::kSign;
    const bool after_place = i > 0 && IsOneOf(tokens[i - 1], {"of", "to", "near", "by", "beside", "under", "below"});
    if (part != nullptr && last && after_place && tokens[i].IsWord("one")) tokens[i].text = part->text;
  }
}

// "Within reach of the crafter seated at the table", "for whoever sits at the desk": of the table.
void TakePersonAsPlace(std::vector<Token>& tokens) {
  const auto posture_word = [](const Token& token) {
    return IsOneOf(token, {"seated", "sitting", "standing", "lying", "sits", "stands", "lies"});
  };
  if (std::none_of(tokens.begin(), tokens.end(), posture_word)) return;
  std::vector<Token> out;
  for (size_t i = 0; i < tokens.size(); ++i) {
    out.push_back(tokens[i]);
    if (!IsOneOf(tokens[i], {"of", "for", "to", "from", "by"}) || i + 4 >= tokens.size()) continue;
    const size_t posture = i + (IsOneOf(tokens[i + 1], {"the", "a", "an"}) ? 3 : 2);
    const bool person = IsOneOf(tokens[posture - 1], {"whoever", "anyone", "someone", "somebody"});
    const bool sits = (IsOneOf(tokens[posture], {"seated", "sitting", "standing", "lying"}) ||
                       (person && IsOneOf(tokens[posture], {"sits", "stands", "lies"}))) &&
                      posture + 1 < tokens.size() && IsOneOf(tokens[posture + 1], {"at", "on", "in"});
    if (sits) i = posture + 1;
  }
  tokens = std::move(out);
}

// "Either side of the chair" at the beginning: on it.
void TakeSideAsPlace(std::vector<Token>& tokens) {
  for (size_t i = 0; i + 2 < tokens.size(); ++i) {
    const bool side =
        IsOneOf(tokens[i], {"either", "each"}) && tokens[i + 1].IsWord("side") && tokens[i + 2].IsWord("of");
    if (!side || !BeginsSentence(tokens, i)) continue;
    // "Either side of the desk should have ...": the sides themselves.
    const auto end = std::find_if(tokens.begin() + static_cast<long>(i), tokens.end(), [](const Token& token) {
      return token.IsMark('.') || IsOneOf(token, {"should", "must", "needs", "need", "has", "have", "requires", "is"});
    });
    if (end != tokens.end() && !end->IsMark('.')) continue;
    tokens.insert(tokens.begin() + static_cast<long>(i), Like(tokens[i], Token::Kind::kWord, "on"));
    ++i;
  }
}

// "0.5 m from one stool to the next": between all of them.
void TakeNextForBetween(std::vector<Token>& tokens) {
  constexpr size_t kLongestName = 4;
  for (size_t i = 0; i + 4 < tokens.size(); ++i) {
    if (!tokens[i].IsWord("from") || !tokens[i + 1].IsWord("one")) continue;
    size_t to = i + 2;
    while (to + 2 < tokens.size() && to < i + 2 + kLongestName && !tokens[to].IsWord("to")) ++to;
    const bool next = tokens[to].IsWord("to") && to + 2 < tokens.size() && tokens[to + 1].IsWord("the") &&
                      IsOneOf(tokens[to + 2], {"next", "other"});
    if (!next) continue;
    tokens[i].text = "between";
    tokens[i + 1].text = "all";
    tokens.erase(tokens.begin() + static_cast<long>(to), tokens.begin() + static_cast<long>(to) + 3);
  }
}

// "The cashier's side, i.e. the back, needs 0.9 m": as if it stood in brackets. Of sides alone: other facts are facts.
void BracketNamely(std::vector<Token>& tokens) {
  constexpr size_t kLongest = 8;
  static constexpr std::array<std::string_view, 10> kSides = {"the",   "front", "back",  "rear", "left",
                                                              "right", "side",  "sides", "and",  "its"};
  for (size_t i = 0; i + 2 < tokens.size(); ++i) {
    if (!tokens[i].IsMark(',') || !(tokens[i + 1].IsWord("ie") || tokens[i + 1].IsWord("namely"))) continue;
    size_t end = i + 2;
    while (end < tokens.size() && end < i + kLongest && IsAmong(kSides, tokens[end])) ++end;
    if (end == tokens.size() || !tokens[end].IsMark(',')) continue;
    tokens[i].text = "(";
    tokens[end].text = ")";
  }
}

}  // namespace

void PrepareClauses(std::vector<Token>& tokens) {
  TakeSideAtBeginning(tokens);
  TakeSoAsDegree(tokens);
  ShortenInOrderTo(tokens);
  DropCareForPeople(tokens);
  TakePartOfRoomForIt(tokens);
  TakePartOfRoomForOne(tokens);
  TakeNextForBetween(tokens);
  TakeWherePeopleAre(tokens);
  TakePersonAsPlace(tokens);
  TakeSideAsPlace(tokens);
  DropOfFloor(tokens);
  BracketNamely(tokens);
}

}  // namespace flair::translator
