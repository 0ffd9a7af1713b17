// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/quantity.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "fmt/format.h"
#include "translator_worker/grammar/quantity_words.h"

namespace flair::translator {
namespace {

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
    const auto half_more = [&] {
      if (!WordAt(next, "and") || !WordAt(next + 1, "a") || !WordAt(next + 2, "half")) return;
      value += 0.5;
      next += 3;
    };
    half_more();
    const std::optional<double> unit = UnitAt(next);
    if (!unit) return Read{value, next, false};
    ++next;
    half_more();  // "a metre and a half"
    return Read{value * *unit, next, true};
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
    static constexpr std::array<std::string_view, 17> kWays = {
        "path", "paths",     "pathway", "pathways", "walkway", "walkways", "passage", "aisle",     "corridor",
        "gap",  "clearance", "space",   "zone",     "area",    "strip",    "band",    "passageway"};
    while (WordAt(index, "clear") || WordAt(index, "walking") || WordAt(index, "open")) ++index;
    return Peek(index) && in_[index].kind == Token::Kind::kWord && Contains(kWays, in_[index].text);
  }

  // "0.5 m or more", "0.5 m (or less)", "0.5 m at least", "0.5 m minimum": the words after a length that bound it.
  std::optional<Bound> BoundAfter(size_t& next) const {
    const bool bracket = MarkAt(next, '(');
    const size_t at = next + (bracket ? 1 : 0);
    for (const Qualifier& qualifier : kQualifiersAfter) {
      size_t end = at;
      const bool met = std::all_of(qualifier.words.begin(), qualifier.words.end(),
                                   [&](std::string_view word) { return WordAt(end++, word); });
      if (!met || (bracket && !MarkAt(end, ')'))) continue;
      next = end + (bracket ? 1 : 0);
      return qualifier.bound;
    }
    return std::nullopt;
  }

  Distance Bounded(double value, size_t& next) {
    Bound bound = pending_.value_or(Bound::kExact);
    pending_.reset();
    if (const std::optional<Bound> after = BoundAfter(next)) bound = *after;
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
    if (WordAt(at_, "between") && RangeAt(at_ + 1)) {
      pending_between_ = true;
      ++at_;
      return true;
    }
    for (const Qualifier& qualifier : kQualifiers) {
      size_t next = at_;
      const bool met = std::all_of(qualifier.words.begin(), qualifier.words.end(), [&](std::string_view word) {
        const bool never = word == "not" && WordAt(next, "never");
        return WordAt(next++, word) || never;
      });
      const bool figure_only = qualifier.words.begin()[0] == "up";
      if (!met || !(figure_only ? LengthAt(next) : LengthAfter(next))) continue;
      pending_ = qualifier.bound;
      at_ = next;
      return true;
    }
    return false;
  }

  // "0.8 and 1.2 m", "half a metre and one metre", "20-40 cm".
  bool RangeAt(size_t index) const {
    const std::optional<Read> first = NumberAt(index);
    if (!first) return false;
    if (!WordAt(first->next, "and")) return in_[index].kind == Token::Kind::kNumber && LengthAfter(index);
    const std::optional<Read> second = NumberAt(first->next + 1);
    return second && second->has_unit;
  }

  // "Pushed up to a wall" bounds no length.
  bool LengthAt(size_t index) const {
    const std::optional<Read> read = NumberAt(index);
    return read && (read->has_unit || MarkAt(read->next, '-') || WordAt(read->next, "to"));
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
