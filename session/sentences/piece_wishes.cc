// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/sentences/piece_wishes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "absl/strings/ascii.h"
#include "english/language.h"
#include "english/lexicon.h"
#include "english/quantities.h"
#include "english/text.h"
#include "english/words.h"

namespace flair::session {
namespace {

using english::IsIn;
using english::Token;

// One more than is done at once, so that too many are told of.
constexpr int kMostCounted = static_cast<int>(kMostAddedAtOnce) + 1;
constexpr size_t kLongestName = 5;

const english::PhraseBook& Requests() {
  static const english::PhraseBook* const book = [] {
    auto* made = new english::PhraseBook;
    for (const auto& list : english::Language::Get().data().lists()) {
      if (list.name() != "requests for a piece") continue;
      for (const std::string& phrase : list.words()) made->Add(phrase, 0);
    }
    return made;
  }();
  return *book;
}

// How many of which piece are named at some place of a sentence.
struct Named {
  std::string name;
  std::optional<v1::Object> object;
  int count = 1;
  // "A desk", not "the desk".
  bool is_new = true;
  // Tokens until its end.
  size_t end = 0;
};

class Reader {
 public:
  Reader(const FindPiece& find, const HasPiece& has, Wishes& wishes) : find_(find), has_(has), wishes_(wishes) {}

  void Read(const std::string& sentence) {
    text_ = sentence;
    tokens_ = english::Tokenize(sentence);
    size_t at = 0;
    while (at < tokens_.size() && IsIn("words before a request", tokens_[at])) ++at;
    const size_t request = Requests().Find(tokens_, at).length;
    const bool read = request > 0 ? ReadRequest(at + request) : IsBareRequest(at) && ReadRequest(at);
    if (!read) wishes_.sentences.push_back({sentence, -1, sentence});
  }

 private:
  bool IsWord(size_t at) const { return at < tokens_.size() && tokens_[at].kind == Token::Kind::kWord; }

  // "Two more chairs", "a plant in the corner"; not "a plant is in the corner".
  bool IsBareRequest(size_t at) const {
    if (at >= tokens_.size()) return false;
    const bool counted = tokens_[at].kind == Token::Kind::kNumber || english::NumberOf(tokens_[at].text).has_value();
    if (!counted && !IsIn("determiners of new things", tokens_[at])) return false;
    const std::optional<Named> named = ReadName(at);
    if (!named.has_value() || !named->object.has_value()) return false;
    const size_t end = named->end;
    return end >= tokens_.size() || tokens_[end].kind == Token::Kind::kSign ||
           IsIn("beginnings of places", tokens_[end]) || IsIn("joins of pieces", tokens_[end]) ||
           IsIn("words after a request", tokens_[end]);
  }

  std::string NameIn(size_t begin, size_t end) const {
    std::string name;
    for (size_t i = begin; i < end; ++i) {
      if (!name.empty()) name += ' ';
      const bool is_noun = end - begin > 2 && tokens_[end - 2].IsWord("of") ? i + 3 == end : i + 1 == end;
      name += is_noun ? english::Singular(tokens_[i].text) : tokens_[i].text;
    }
    return name;
  }

  // The noun phrase at a token: what it is called by its longest end that something is called by.
  std::optional<Named> ReadName(size_t at) const {
    Named named;
    bool is_counted = false, is_more = false;
    while (at < tokens_.size()) {
      is_more = is_more || tokens_[at].IsWord("more");
      if (tokens_[at].kind == Token::Kind::kNumber) {
        is_counted = true;
        named.count = static_cast<int>(std::clamp(tokens_[at].number, 1.0, kMostCounted * 1.0));
      } else if (IsIn("determiners of known things", tokens_[at])) {
        named.is_new = false;
      } else if (!IsIn("determiners of new things", tokens_[at])) {
        const std::optional<double> count = IsWord(at) ? english::NumberOf(tokens_[at].text) : std::nullopt;
        if (!count) break;
        is_counted = true;
        named.count = static_cast<int>(std::clamp(std::round(*count), 1.0, kMostCounted * 1.0));
      }
      ++at;
    }
    size_t end = at;
    while (IsWord(end) && !IsIn("words after a piece", tokens_[end])) ++end;
    if (end == at) return std::nullopt;
    // "A chest of drawers".
    if (end + 1 < tokens_.size() && tokens_[end].IsWord("of") && find_(NameIn(at, end + 2)).has_value()) end += 2;
    // "More chairs" are two at least.
    if (is_more && !is_counted && english::IsPlural(tokens_[end - 1].text)) named.count = 2;
    named.name = NameIn(at, end);
    named.end = end;
    for (size_t last = end; last > at; --last) {
      for (size_t first = last - at > kLongestName ? last - kLongestName : at; first < last; ++first) {
        const std::string name = NameIn(first, last);
        if (!named.is_new && has_(name)) return std::nullopt;
        if (std::optional<v1::Object> object = find_(name); object.has_value()) {
          named.name = name;
          named.object = std::move(object);
          return named;
        }
      }
    }
    // "I want the sofa to face the window", "I want 1 m behind the desk": not a wish for a piece.
    const bool is_length = english::Language::Get().FindUnit(tokens_[at].text) != nullptr;
    return named.is_new && !is_length ? std::optional(named) : std::nullopt;
  }

  int Add(const Named& named, int goes_with) {
    for (int i = 0; i < named.count; ++i) wishes_.pieces.push_back({*named.object, goes_with, text_, named.name});
    return static_cast<int>(wishes_.pieces.size()) - named.count;
  }

  // The pieces of a request and where they go; false when it is none of pieces.
  bool ReadRequest(size_t at) {
    if (at < tokens_.size() && IsIn("pronouns of a piece", tokens_[at]) && last_ >= 0) {
      Say(at + 1, last_);
      return true;
    }
    const std::optional<Named> first = ReadName(at);
    if (!first.has_value()) return false;
    if (!first->object.has_value()) {
      wishes_.unknown.push_back(first->name);
      return true;
    }
    std::vector<int> placed;
    int main = Add(*first, -1);
    for (int i = 0; i < first->count; ++i) placed.push_back(main + i);
    last_ = main;
    size_t next = first->end;
    while (next < tokens_.size() && (tokens_[next].IsMark(',') || IsIn("joins of pieces", tokens_[next]))) {
      bool with = false;
      size_t after = next;
      for (; after < tokens_.size() && (tokens_[after].IsMark(',') || IsIn("joins of pieces", tokens_[after]));
           ++after) {
        with = with || tokens_[after].IsWord("with");
      }
      const std::optional<Named> more = ReadName(after);
      if (!more.has_value() || Requests().Find(tokens_, after).length > 0) {
        next = after;
        break;
      }
      next = more->end;
      if (!more->object.has_value()) {
        wishes_.unknown.push_back(more->name);
        continue;
      }
      const int index = Add(*more, with ? main : -1);
      if (with) continue;
      main = last_ = index;
      placed.clear();
      for (int i = 0; i < more->count; ++i) placed.push_back(index + i);
    }
    // "Add a desk and put it into the corner."
    const size_t again = Requests().Find(tokens_, next).length;
    if (again > 0 && ReadRequest(next + again)) return true;
    for (const int piece : placed) Say(next, piece);
    return true;
  }

  // What the rest of the sentence says of a piece.
  void Say(size_t at, int piece) {
    const auto says_nothing = [](const Token& token) {
      return token.kind == Token::Kind::kSign || IsIn("words after a request", token);
    };
    const auto says_what_for = [&] {
      return tokens_[at].IsWord("for") && at + 1 < tokens_.size() && !IsIn("words after a request", tokens_[at + 1]);
    };
    while (at < tokens_.size() && says_nothing(tokens_[at]) && !says_what_for()) ++at;
    if (at >= tokens_.size()) return;
    const bool clause = IsIn("beginnings of relative clauses", tokens_[at]);
    if (clause && ++at >= tokens_.size()) return;
    std::string rest(absl::StripAsciiWhitespace(text_.substr(tokens_[at].begin)));
    const bool verb = clause || tokens_[at].IsWord("is") || tokens_[at].IsWord("are") || tokens_[at].IsWord("faces");
    wishes_.sentences.push_back({"The {} " + (verb ? rest : "is " + rest), piece, text_});
  }

  const FindPiece& find_;
  const HasPiece& has_;
  Wishes& wishes_;
  std::string text_;
  std::vector<Token> tokens_;
  // What "it" is.
  int last_ = -1;
};

}  // namespace

std::vector<std::string> SplitSentences(std::string_view text) {
  std::vector<std::string> sentences;
  size_t begin = 0;
  for (size_t i = 0; i <= text.size(); ++i) {
    const bool end = i == text.size();
    const bool mark =
        !end && (text[i] == ';' || text[i] == '\n' ||
                 ((text[i] == '.' || text[i] == '!' || text[i] == '?') &&
                  (i + 1 == text.size() || absl::ascii_isspace(static_cast<unsigned char>(text[i + 1])))));
    if (!end && !mark) continue;
    const size_t stop = mark && text[i] != ';' && text[i] != '\n' ? i + 1 : i;
    std::string sentence(text.substr(begin, stop - begin));
    absl::StripAsciiWhitespace(&sentence);
    if (sentence.find_first_not_of(".!? ") != std::string::npos) sentences.push_back(std::move(sentence));
    begin = i + 1;
  }
  return sentences;
}

Wishes ReadWishes(std::string_view text, const FindPiece& find, const HasPiece& has) {
  Wishes wishes;
  Reader reader(find, has, wishes);
  for (const std::string& sentence : SplitSentences(text)) reader.Read(sentence);
  return wishes;
}

}  // namespace flair::session
