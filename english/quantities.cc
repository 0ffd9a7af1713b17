// SPDX-License-Identifier: GPL-3.0-or-later
#include "english/quantities.h"

#include <algorithm>
#include <string>
#include <utility>

#include "english/lexicon.h"
#include "fmt/format.h"

namespace flair::english {
namespace {

const Token* Peek(const std::vector<Token>& tokens, size_t i) { return i < tokens.size() ? &tokens[i] : nullptr; }
bool WordAt(const std::vector<Token>& tokens, size_t i, std::string_view word) {
  return i < tokens.size() && tokens[i].IsWord(word);
}
bool MarkAt(const std::vector<Token>& tokens, size_t i, char mark) {
  return i < tokens.size() && tokens[i].IsMark(mark);
}
// A hyphen between the parts of "twenty-five" and "2-foot".
size_t PastHyphen(const std::vector<Token>& tokens, size_t i) {
  return MarkAt(tokens, i, '-') && tokens[i].glued && i + 1 < tokens.size() && tokens[i + 1].glued ? i + 1 : i;
}

// The unit at tokens[i], null when there is none of that kind.
const v1::Unit* UnitAt(const std::vector<Token>& tokens, size_t i, v1::Unit::Kind kind, bool apart = false) {
  if (i >= tokens.size() || tokens[i].kind == Token::Kind::kNumber) return nullptr;
  const v1::Unit* const unit = Language::Get().FindUnit(tokens[i].text);
  return unit != nullptr && unit->kind() == kind && (!unit->only_glued() || tokens[i].glued || apart) ? unit : nullptr;
}

// "And a half", "and a quarter", "and three quarters".
void AddPart(const std::vector<Token>& tokens, double& value, size_t& end, double of) {
  const bool a = WordAt(tokens, end + 1, "a"), three = WordAt(tokens, end + 1, "three");
  const size_t at = PastHyphen(tokens, end + 2);
  const double part = a && WordAt(tokens, at, "half")                                              ? 0.5
                      : a && WordAt(tokens, at, "quarter")                                         ? 0.25
                      : three && (WordAt(tokens, at, "quarters") || WordAt(tokens, at, "quarter")) ? 0.75
                                                                                                   : 0;
  if (!WordAt(tokens, end, "and") || part == 0) return;
  value += of * part;
  end = at + 1;
}

// Adds what follows a length in a smaller unit, or in none: "5 ft 6 in", 9'-0", "1 m 20 cm", 12'6 with its last mark
// left out, "ten foot six", "three metres ten".
void AddRest(const std::vector<Token>& tokens, const v1::Unit& unit, Measure& measure) {
  const size_t at = PastHyphen(tokens, measure.end);
  if (at >= tokens.size()) return;
  const bool digits = tokens[at].kind == Token::Kind::kNumber;
  const v1::NumberWord* const word = digits ? nullptr : Language::Get().FindNumber(tokens[at].text);
  const std::optional<Number> more =
      digits || (word != nullptr && !word->counts_things()) ? NumberAt(tokens, at) : std::nullopt;
  if (!more) return;
  const bool feet = unit.words(0) == "ft", metres = unit.size() == 1;
  const v1::Unit* const smaller = UnitAt(tokens, more->end, unit.kind(), /*apart=*/feet);
  if (smaller != nullptr) {
    if (smaller->size() >= unit.size() || more->value * smaller->size() >= unit.size()) return;
    measure.value += more->value * smaller->size();
    measure.end = more->end + 1;
    return;
  }
  const bool glued = MarkAt(tokens, at - 1, '\'') && tokens[at].glued;
  const bool closes = more->end >= tokens.size() || tokens[more->end].kind != Token::Kind::kWord ||
                      IsIn("behind_lengths", tokens[more->end]);
  const bool hundredths =
      metres && closes && more->value < 100 && (digits ? tokens[at].text.size() == 2 : more->value >= 10);
  const bool inches = feet && more->value < 12 && (glued || closes);
  if (!hundredths && !inches) return;
  measure.value += more->value * (feet ? unit.size() / 12 : 0.01);
  measure.end = more->end;
}

// "Square metres", "m2", "sq. ft": the area's size in square metres with the token after it.
std::optional<Measure> SquareUnitAt(const std::vector<Token>& tokens, size_t i) {
  if (const v1::Unit* const area = UnitAt(tokens, i, v1::Unit::KIND_AREA)) return Measure{0, area->size(), i + 1};
  const bool square = WordAt(tokens, i, "square") || WordAt(tokens, i, "sq");
  size_t at = square ? i + 1 : i;
  if (square && MarkAt(tokens, at, '.')) ++at;
  const v1::Unit* const side = UnitAt(tokens, at, v1::Unit::KIND_LENGTH);
  if (side == nullptr) return std::nullopt;
  ++at;
  if (!square) {
    if (MarkAt(tokens, at, '^')) ++at;
    if (at >= tokens.size() || tokens[at].kind != Token::Kind::kNumber || tokens[at].number != 2) return std::nullopt;
    ++at;
  }
  return Measure{0, side->size() * side->size(), at};
}

// The phrases that bound a figure, before and after it; values are kinds of Bound.
struct BoundPhrases {
  PhraseBook before;
  PhraseBook after;

  static const BoundPhrases& Get() {
    static const auto* const phrases = [] {
      auto* const filled = new BoundPhrases;
      for (const v1::Bound& bound : Language::Get().data().bounds()) {
        for (const std::string& phrase : bound.before()) filled->before.Add(phrase, bound.kind());
        for (const std::string& phrase : bound.after()) filled->after.Add(phrase, bound.kind());
      }
      return filled;
    }();
    return *phrases;
  }
};

class LengthJoiner {
 public:
  explicit LengthJoiner(std::vector<Token> in) : in_(std::move(in)) {}

  std::vector<Token> Run() {
    while (at_ < in_.size()) {
      if (!TakeLength() && !TakeBound()) Keep();
    }
    return std::move(out_);
  }

 private:
  static constexpr int kExact = v1::Unit::KIND_UNSPECIFIED;

  // "A desk", "both lamps" begin no length.
  std::optional<Measure> At(size_t i) const {
    std::optional<Measure> measure = MeasureAt(in_, i);
    const bool counts = measure && measure->unit == 0 && in_[i].kind == Token::Kind::kWord;
    return counts && Language::Get().FindNumber(in_[i].text)->counts_things() ? std::nullopt : measure;
  }
  bool IsRangeAfter(size_t next) const { return MarkAt(in_, next, '-') || WordAt(in_, next, "to"); }

  void Keep() {
    // A new sentence forgets a bound that met no length.
    if (in_[at_].IsMark('.')) bound_ = kExact;
    out_.push_back(in_[at_++]);
  }

  bool TakeLength() {
    std::optional<Measure> first = At(at_);
    if (!first) return false;
    Token token = in_[at_];
    token.kind = Token::Kind::kLength;
    token.text.clear();
    size_t next = first->end;
    const bool range = IsRangeAfter(next) || (WordAt(in_, next, "and") && after_between_);
    const std::optional<Measure> second = range ? At(next + 1) : std::nullopt;
    if (second && second->unit > 0) {
      if (first->unit == 0) first->value *= second->unit;
      token.length = {std::min(first->value, second->value), std::max(first->value, second->value), false};
      after_between_ = false;
      bound_ = kExact;
      next = second->end;
    } else if (first->unit > 0) {
      if (SkipSize(next)) return true;
      token.length = Bounded(first->value, next);
    } else {
      return SkipSize(next);
    }
    token.end = in_[next - 1].end;
    // A lone length in brackets says how long something is, "one long side (1.5m)", but not how wide a space is.
    const bool in_brackets = !out_.empty() && out_.back().IsMark('(') && MarkAt(in_, next, ')');
    if (!in_brackets || SpaceSpokenOf() || !token.length.exact) {
      out_.push_back(std::move(token));
    } else {
      out_.pop_back();
      ++next;
    }
    at_ = next;
    return true;
  }

  // "At least one of the 3m sides" is a side of that length, "the 3m sides" are both, "the 2.5m side" is one.
  void TakeSidesOfLength(size_t next, double length) {
    Token side = in_[next];
    bool single = side.IsWord("side");
    if (!single) {
      size_t one = out_.size();
      while (one > 0 && IsOneOf(out_[one - 1], {"the", "of", "its"})) --one;
      single = one > 0 && one < out_.size() && out_[one - 1].IsWord("one");
      if (single) {
        out_.resize(one - 1);
        if (out_.size() > 1 && out_.back().IsWord("least")) out_.resize(out_.size() - 2);
      }
    }
    side.text = fmt::format("{}:{:.3f}", single ? "length" : "lengths", length);
    side.begin = in_[at_].begin;
    out_.push_back(std::move(side));
    at_ = next + 1;
  }

  // "1.8m x 2.8m", "0.6m wide": leaves nothing behind.
  bool SkipSize(size_t next) {
    const size_t start = next;
    const bool digits = in_[at_].kind == Token::Kind::kNumber;
    if (digits && (WordAt(in_, next, "side") || WordAt(in_, next, "sides"))) {
      TakeSidesOfLength(next, At(at_)->value);
      return true;
    }
    while (WordAt(in_, next, "x") || WordAt(in_, next, "by")) {
      const std::optional<Measure> other = At(next + 1);
      if (!other) break;
      next = other->end;
    }
    const bool adjective =
        digits && next < in_.size() && IsIn("dimensions", in_[next]) && bound_ == kExact && !IsWay(next + 1);
    if (adjective) ++next;
    if (next == start) return false;
    at_ = next;
    return true;
  }

  // "A 0.8 m wide walkway": how much is kept free, not how wide a thing is.
  bool IsWay(size_t i) const {
    while (i < in_.size() && IsOneOf(in_[i], {"clear", "walking", "open"})) ++i;
    return i < in_.size() && IsIn("ways", in_[i]);
  }

  // "0.5 m or more", "0.5 m (or less)": the words after a length that bound it.
  int BoundAfter(size_t& next) const {
    const bool bracket = MarkAt(in_, next, '(');
    const PhraseBook::Match match = BoundPhrases::Get().after.Find(in_, next + (bracket ? 1 : 0));
    const size_t end = next + (bracket ? 1 : 0) + match.length;
    if (match.length == 0 || (bracket && !MarkAt(in_, end, ')'))) return kExact;
    next = end + (bracket ? 1 : 0);
    return match.value;
  }

  Length Bounded(double value, size_t& next) {
    int bound = std::exchange(bound_, kExact);
    if (const int after = BoundAfter(next); after != kExact) bound = after;
    // A gap of 0.5 m is one of at least that; a distance of 0.5 m is just that.
    const bool of_gap = out_.size() > 1 && out_.back().IsWord("of") && IsIn("gaps", out_[out_.size() - 2]);
    if (bound == kExact && (of_gap || (next < in_.size() && IsIn("gaps", in_[next])))) bound = v1::Bound::KIND_LEAST;
    if (bound == v1::Bound::KIND_LEAST) return {value, std::nullopt, false};
    if (bound == v1::Bound::KIND_MOST) return {std::nullopt, value, false};
    return {value, value, true};
  }

  // Whether this sentence has spoken of free space.
  bool SpaceSpokenOf() const {
    for (size_t i = out_.size(); i > 0 && !out_[i - 1].IsMark('.'); --i) {
      if (IsIn("spaces", out_[i - 1])) return true;
    }
    return false;
  }

  // Takes a bound off the sentence when a length follows it; it then waits for that length.
  bool TakeBound() {
    if (WordAt(in_, at_, "between") && BeginsRange(at_ + 1)) {
      after_between_ = true;
      ++at_;
      return true;
    }
    const PhraseBook::Match match = BoundPhrases::Get().before.Find(in_, at_);
    if (match.length == 0) return false;
    const size_t next = at_ + match.length;
    // "Pushed up to a wall" bounds no length, however near one stands.
    const bool at_once = WordAt(in_, at_, "up");
    if (!(at_once ? IsLengthAt(next) : LengthFollows(next))) return false;
    bound_ = match.value;
    at_ = next;
    return true;
  }

  // "0.8 and 1.2 m", "half a metre and one metre", "20-40 cm".
  bool BeginsRange(size_t i) const {
    const std::optional<Measure> first = At(i);
    if (!first) return false;
    if (!WordAt(in_, first->end, "and")) return in_[i].kind == Token::Kind::kNumber && LengthFollows(i);
    const std::optional<Measure> second = At(first->end + 1);
    return second && second->unit > 0;
  }

  bool IsLengthAt(size_t i) const {
    const std::optional<Measure> measure = At(i);
    return measure && (measure->unit > 0 || IsRangeAfter(measure->end));
  }

  bool LengthFollows(size_t i) const {
    // "Minimum distance from the easel: 0.2m" has up to a dozen words between.
    constexpr size_t kFar = 14;
    const size_t limit = std::min(in_.size(), i + (i < in_.size() && IsIn("before_figures", in_[i]) ? kFar : 1));
    for (; i < limit && !in_[i].IsMark('.'); ++i) {
      if (in_[i].kind == Token::Kind::kNumber) return IsLengthAt(i);
      const std::optional<Measure> measure = At(i);
      if (measure && measure->unit > 0) return true;
    }
    return false;
  }

  const std::vector<Token> in_;
  size_t at_ = 0;
  int bound_ = kExact;
  bool after_between_ = false;
  std::vector<Token> out_;
};

}  // namespace

std::optional<double> NumberOf(std::string_view word) {
  const v1::NumberWord* const number = Language::Get().FindNumber(word);
  return number == nullptr ? std::nullopt : std::optional(number->value());
}

std::optional<Number> NumberAt(const std::vector<Token>& tokens, size_t i) {
  const Token* const first = Peek(tokens, i);
  if (first == nullptr) return std::nullopt;
  Number number{first->number, i + 1};
  if (first->kind == Token::Kind::kNumber) {
    const Token* const next = Peek(tokens, i + 1);
    const bool fraction = next != nullptr && next->kind == Token::Kind::kNumber && next->number > 0 &&
                          next->number < 1 && (next->text[0] == '.' || next->text.find('/') != std::string::npos);
    if (fraction && first->text.find('.') == std::string::npos) {
      number.value += next->number;
      ++number.end;
    }
    AddPart(tokens, number.value, number.end, 1);
    return number;
  }
  if (first->kind != Token::Kind::kWord) return std::nullopt;
  const std::optional<double> value = NumberOf(first->text);
  if (!value) return std::nullopt;
  number.value = *value;
  const auto ones_at = [&](size_t at) {
    const std::optional<double> ones = at < tokens.size() ? NumberOf(tokens[at].text) : std::nullopt;
    return ones && !Language::Get().FindNumber(tokens[at].text)->counts_things() ? *ones : 0;
  };
  if (*value == 1 || *value == 0.5) {
    // "A half", "half a dozen", "a hundred", "a few", "a couple".
    if (WordAt(tokens, number.end, "half")) {
      number.value = 0.5;
      ++number.end;
    }
    if (number.value == 0.5 && (WordAt(tokens, number.end, "a") || WordAt(tokens, number.end, "an"))) ++number.end;
    const Token* const scale = Peek(tokens, number.end);
    const v1::NumberWord* const more = scale == nullptr ? nullptr : Language::Get().FindNumber(scale->text);
    const bool counted = first->text == "a" || number.value == 0.5 || (more != nullptr && more->value() >= 12);
    if (more != nullptr && more->value() > 1 && counted && (more->value() >= 100 || more->counts_things())) {
      number.value *= more->value();
      ++number.end;
    }
  } else if (*value >= 20 && *value < 100) {
    const size_t next = PastHyphen(tokens, number.end);
    if (const double ones = ones_at(next); ones >= 1 && ones < 10) {
      number.value += ones;
      number.end = next + 1;
    }
  } else if (const bool dozens = WordAt(tokens, number.end, "dozen"); dozens || WordAt(tokens, number.end, "hundred")) {
    number.value *= dozens ? 12 : 100;
    ++number.end;
  }
  // "Three point two five".
  double place = 0.1;
  for (size_t at = number.end + 1; WordAt(tokens, number.end, "point") || place < 0.1; ++at, place /= 10) {
    const double digit = ones_at(at);
    if (digit >= 10 || (digit < 1 && !WordAt(tokens, at, "zero"))) break;
    number.value += digit * place;
    number.end = at + 1;
  }
  AddPart(tokens, number.value, number.end, 1);
  return number;
}

std::optional<Measure> MeasureAt(const std::vector<Token>& tokens, size_t i, v1::Unit::Kind kind) {
  const std::optional<Number> number = NumberAt(tokens, i);
  if (!number) return std::nullopt;
  Measure measure{number->value, 0, number->end};
  if (kind == v1::Unit::KIND_AREA) {
    if (const std::optional<Measure> area = SquareUnitAt(tokens, measure.end))
      return Measure{measure.value * area->unit, area->unit, area->end};
    return measure;
  }
  const size_t at = PastHyphen(tokens, measure.end);
  const v1::Unit* const unit = UnitAt(tokens, at, kind);
  if (unit == nullptr) return measure;
  measure = {measure.value * unit->size(), unit->size(), at + 1};
  AddPart(tokens, measure.value, measure.end, unit->size());  // "a metre and a half"
  AddRest(tokens, *unit, measure);
  return measure;
}

std::vector<Token> JoinLengths(std::vector<Token> tokens) { return LengthJoiner(std::move(tokens)).Run(); }

}  // namespace flair::english
