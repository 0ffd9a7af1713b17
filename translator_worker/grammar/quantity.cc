// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/quantity.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>

#include "fmt/format.h"

namespace flair::translator {
namespace {

struct Unit {
  std::string_view word;
  double metres;
};
constexpr std::array kUnits = {
    Unit{"m", 1},
    Unit{"metre", 1},
    Unit{"metres", 1},
    Unit{"meter", 1},
    Unit{"meters", 1},
    Unit{"cm", 0.01},
    Unit{"centimetre", .01},
    Unit{"centimetres", .01},
    Unit{"centimeter", .01},
    Unit{"centimeters", .01},
    Unit{"mm", 0.001},
    Unit{"millimetres", .001},
    Unit{"millimeters", .001},
    Unit{"ft", 0.3048},
    Unit{"foot", 0.3048},
    Unit{"feet", 0.3048},
    Unit{"inch", 0.0254},
    Unit{"inches", 0.0254},
    Unit{"yard", 0.9144},
    Unit{"yards", 0.9144},
};

struct NumberWord {
  std::string_view word;
  double value;
};
constexpr std::array kNumberWords = {
    NumberWord{"zero", 0}, NumberWord{"half", 0.5}, NumberWord{"a", 1},     NumberWord{"an", 1},
    NumberWord{"one", 1},  NumberWord{"two", 2},    NumberWord{"three", 3}, NumberWord{"four", 4},
    NumberWord{"five", 5}, NumberWord{"six", 6},    NumberWord{"eight", 8}, NumberWord{"ten", 10},
};

enum class Bound { kExact, kMin, kMax };

struct Qualifier {
  std::initializer_list<std::string_view> words;
  Bound bound;
};

// Longest first. Words that stand before a length.
const Qualifier kQualifiers[] = {
    {{"not", "be", "less", "than"}, Bound::kMin},
    {{"not", "be", "closer", "than"}, Bound::kMin},
    {{"not", "be", "more", "than"}, Bound::kMax},
    {{"not", "be", "further", "than"}, Bound::kMax},
    {{"not", "be", "farther", "than"}, Bound::kMax},
    {{"not", "exceed"}, Bound::kMax},
    {{"not", "exceeding"}, Bound::kMax},
    {{"no", "less", "than"}, Bound::kMin},
    {{"not", "less", "than"}, Bound::kMin},
    {{"no", "more", "than"}, Bound::kMax},
    {{"not", "more", "than"}, Bound::kMax},
    {{"no", "further", "than"}, Bound::kMax},
    {{"no", "farther", "than"}, Bound::kMax},
    {{"no", "greater", "than"}, Bound::kMax},
    {{"not", "further", "than"}, Bound::kMax},
    {{"no", "closer", "than"}, Bound::kMin},
    {{"no", "nearer", "than"}, Bound::kMin},
    {{"not", "nearer", "than"}, Bound::kMin},
    {{"nearer", "than"}, Bound::kMin},
    {{"not", "closer", "than"}, Bound::kMin},
    {{"less", "than"}, Bound::kMax},
    {{"closer", "than"}, Bound::kMin},
    {{"more", "than"}, Bound::kMin},
    {{"greater", "than"}, Bound::kMin},
    {{"at", "least"}, Bound::kMin},
    {{"a", "minimum", "of"}, Bound::kMin},
    {{"minimum", "of"}, Bound::kMin},
    {{"a", "maximum", "of"}, Bound::kMax},
    {{"maximum", "of"}, Bound::kMax},
    {{"at", "most"}, Bound::kMax},
    {{"up", "to"}, Bound::kMax},
    {{"within"}, Bound::kMax},
    {{"minimum"}, Bound::kMin},
    {{"maximum"}, Bound::kMax},
    {{"min"}, Bound::kMin},
    {{"max"}, Bound::kMax},
    {{"over"}, Bound::kMin},
};

// Words that may stand between a qualifier and its length: "a minimum clear distance of 0.5 m".
constexpr std::array<std::string_view, 25> kBetween = {
    "depth", "distance", "gap",           "space",   "spacing", "clearance", "separation", "of",      "clear",
    "a",     "an",       "about",         "around",  "free",    "width",     "walkway",    "roughly", "is",
    "be",    "should",   "approximately", "exactly", "buffer",  "another",   "the"};
constexpr std::array<std::string_view, 12> kDimensionWords = {
    "wide", "long", "deep", "high", "tall", "square", "thick", "width", "length", "height", "depth", "diameter"};

constexpr std::array<std::string_view, 11> kSpaceWords = {
    "clearance", "space", "gap", "distance", "room", "out", "spacing", "clear", "unobstructed", "free", "accessible"};

constexpr std::array<std::string_view, 10> kGapWords = {"gap",   "clearance", "separation", "buffer",  "spacing",
                                                        "space", "path",      "pathway",    "walkway", "passage"};

template <typename Words>
bool Contains(const Words& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

class Joiner {
 public:
  explicit Joiner(std::vector<Token> in) : in_(std::move(in)) {}

  std::vector<Token> Run() {
    while (at_ < in_.size()) {
      if (!Length() && !Qualify()) Keep();
    }
    return std::move(out_);
  }

 private:
  struct Read {
    double value;
    size_t next;
    bool has_unit;
  };

  const Token* Peek(size_t index) const { return index < in_.size() ? &in_[index] : nullptr; }
  bool WordAt(size_t index, std::string_view word) const { return Peek(index) && in_[index].IsWord(word); }
  bool MarkAt(size_t index, char mark) const { return Peek(index) && in_[index].IsMark(mark); }

  void Keep() {
    // A new sentence forgets a qualifier that met no length.
    if (in_[at_].IsMark('.')) pending_.reset();
    out_.push_back(in_[at_++]);
  }

  std::optional<double> UnitAt(size_t index) const {
    if (!Peek(index) || in_[index].kind != Token::Kind::kWord) return std::nullopt;
    for (const Unit& unit : kUnits) {
      if (in_[index].text == unit.word) return unit.metres;
    }
    return std::nullopt;
  }

  // A number at `index` with its unit, if one follows.
  std::optional<Read> NumberAt(size_t index) const {
    const Token* token = Peek(index);
    if (!token) return std::nullopt;
    double value = 0;
    size_t next = index + 1;
    if (token->kind == Token::Kind::kNumber) {
      value = token->number;
    } else {
      if (token->kind != Token::Kind::kWord) return std::nullopt;
      const auto word = std::find_if(kNumberWords.begin(), kNumberWords.end(),
                                     [&](const NumberWord& entry) { return entry.word == token->text; });
      if (word == kNumberWords.end()) return std::nullopt;
      value = word->value;
      if (WordAt(next, "half")) {
        value = 0.5;
        ++next;
      }
      if (value == 0.5 && (WordAt(next, "a") || WordAt(next, "an"))) ++next;
    }
    if (WordAt(next, "and") && WordAt(next + 1, "a") && WordAt(next + 2, "half")) {
      value += 0.5;
      next += 3;
    }
    const std::optional<double> unit = UnitAt(next);
    if (!unit) return Read{value, next, false};
    return Read{value * *unit, next + 1, true};
  }

  bool Length() {
    std::optional<Read> first = NumberAt(at_);
    if (!first) return false;
    Token token = in_[at_];
    token.kind = Token::Kind::kDistance;
    token.text.clear();
    size_t next = first->next;
    const bool range_mark = MarkAt(next, '-') || WordAt(next, "to") || (WordAt(next, "and") && pending_between_);
    std::optional<Read> second = range_mark ? NumberAt(next + 1) : std::nullopt;
    if (second && second->has_unit) {
      if (!first->has_unit) first->value *= *UnitAt(second->next - 1);
      token.distance = {std::min(first->value, second->value), std::max(first->value, second->value), false};
      pending_between_ = false;
      pending_.reset();
      next = second->next;
    } else if (first->has_unit) {
      if (SkipDimension(next)) return true;
      token.distance = Bounded(first->value, next);
    } else {
      return SkipDimension(next);
    }
    token.end = in_[next - 1].end;
    // A lone length in brackets says how long something is, "one long side (1.5m)", but not how wide a space is.
    const bool in_brackets = !out_.empty() && out_.back().IsMark('(') && MarkAt(next, ')');
    const bool of_space = SpaceSpokenOf();
    if (!in_brackets || of_space || !token.distance.exact) {
      out_.push_back(std::move(token));
    } else {
      out_.pop_back();
      ++next;
    }
    at_ = next;
    return true;
  }

  // "At least one of the 3m sides" is a side of that length, "the 3m sides" are both.
  void TakeSidesOfLength(size_t next) {
    Token side = in_[next];
    const double length = NumberAt(at_)->value;
    size_t one = out_.size();
    while (one > 0 && (out_[one - 1].IsWord("the") || out_[one - 1].IsWord("of") || out_[one - 1].IsWord("its"))) --one;
    const bool single = one > 0 && one < out_.size() && out_[one - 1].IsWord("one");
    if (single) {
      out_.resize(one - 1);
      if (out_.size() > 1 && out_.back().IsWord("least")) out_.resize(out_.size() - 2);
    }
    side.text = fmt::format("{}:{:.3f}", single ? "length" : "lengths", length);
    out_.push_back(std::move(side));
    at_ = next + 1;
  }

  // "1.8m x 2.8m", "0.6m wide": leaves nothing behind.
  bool SkipDimension(size_t next) {
    const size_t start = next;
    // "the 2.5m side" is the side of that length.
    if (in_[at_].kind == Token::Kind::kNumber && WordAt(next, "side")) {
      Token side = in_[next];
      side.text = fmt::format("length:{:.3f}", NumberAt(at_)->value);
      side.begin = in_[at_].begin;
      out_.push_back(std::move(side));
      at_ = next + 1;
      return true;
    }
    if (in_[at_].kind == Token::Kind::kNumber && WordAt(next, "sides")) {
      TakeSidesOfLength(next);
      return true;
    }
    while (WordAt(next, "x") || WordAt(next, "by")) {
      const std::optional<Read> other = NumberAt(next + 1);
      if (!other) break;
      next = other->next;
    }
    const bool adjective = in_[at_].kind == Token::Kind::kNumber && Peek(next) &&
                           in_[next].kind == Token::Kind::kWord && Contains(kDimensionWords, in_[next].text) &&
                           !pending_ && !IsWay(next + 1);
    if (adjective) ++next;
    if (next == start) return false;
    at_ = next;
    return true;
  }

  // "A 0.8 m wide walkway": how much is kept free, not how wide a thing is.
  bool IsWay(size_t index) const {
    static constexpr std::array<std::string_view, 12> kWays = {"path",     "paths",   "pathway",  "pathways",
                                                               "walkway",  "walkways", "passage",  "aisle",
                                                               "corridor", "gap",     "clearance", "space"};
    while (WordAt(index, "clear") || WordAt(index, "walking") || WordAt(index, "open")) ++index;
    return Peek(index) && in_[index].kind == Token::Kind::kWord && Contains(kWays, in_[index].text);
  }

  Distance Bounded(double value, size_t& next) {
    Bound bound = pending_.value_or(Bound::kExact);
    pending_.reset();
    if (WordAt(next, "or") && (WordAt(next + 1, "more") || WordAt(next + 1, "less"))) {
      bound = WordAt(next + 1, "more") ? Bound::kMin : Bound::kMax;
      next += 2;
    }
    if (WordAt(next, "minimum")) {
      bound = Bound::kMin;
      ++next;
    }
    // A gap of 0.5 m is one of at least that; a distance of 0.5 m is just that.
    const bool of_gap = out_.size() > 1 && out_.back().IsWord("of") && Contains(kGapWords, out_[out_.size() - 2].text);
    const bool gap = Peek(next) && in_[next].kind == Token::Kind::kWord && Contains(kGapWords, in_[next].text);
    if (bound == Bound::kExact && (of_gap || gap)) bound = Bound::kMin;
    switch (bound) {
      case Bound::kMin:
        return {value, std::nullopt, false};
      case Bound::kMax:
        return {std::nullopt, value, false};
      case Bound::kExact:
        break;
    }
    return {value, value, true};
  }

  // Whether this sentence has spoken of free space.
  bool SpaceSpokenOf() const {
    for (size_t i = out_.size(); i > 0 && !out_[i - 1].IsMark('.'); --i) {
      if (Contains(kSpaceWords, out_[i - 1].text)) return true;
    }
    return false;
  }

  // Takes a qualifier off the sentence when a length follows it; it then waits for that length.
  bool Qualify() {
    if (WordAt(at_, "between") && Peek(at_ + 1) && in_[at_ + 1].kind == Token::Kind::kNumber && LengthAfter(at_ + 1)) {
      pending_between_ = true;
      ++at_;
      return true;
    }
    for (const Qualifier& qualifier : kQualifiers) {
      size_t next = at_;
      const bool met = std::all_of(qualifier.words.begin(), qualifier.words.end(),
                                   [&](std::string_view word) { return WordAt(next++, word); });
      if (!met || !LengthAfter(next)) continue;
      pending_ = qualifier.bound;
      at_ = next;
      return true;
    }
    return false;
  }

  bool LengthAfter(size_t index) const {
    // "Minimum distance from the easel: 0.2m" has up to a dozen words between.
    const bool noun_follows =
        Peek(index) && in_[index].kind == Token::Kind::kWord && Contains(kBetween, in_[index].text);
    const size_t limit = std::min(in_.size(), index + (noun_follows ? 14 : 1));
    for (size_t i = index; i < limit && !in_[i].IsMark('.'); ++i) {
      if (in_[i].kind == Token::Kind::kNumber) {
        return NumberAt(i)->has_unit || (MarkAt(NumberAt(i)->next, '-') || WordAt(NumberAt(i)->next, "to"));
      }
      const std::optional<Read> read = NumberAt(i);
      if (read && read->has_unit) return true;
    }
    return false;
  }

  const std::vector<Token> in_;
  size_t at_ = 0;
  std::optional<Bound> pending_;
  bool pending_between_ = false;
  std::vector<Token> out_;
};

}  // namespace

std::vector<Token> JoinQuantities(std::vector<Token> tokens) { return Joiner(std::move(tokens)).Run(); }

}  // namespace flair::translator
