// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "english/frames/token_context.h"
#include "english/lexicon.h"

namespace flair::english {
namespace {

// What stands in brackets beyond this many tokens is read like the rest.
constexpr size_t kLongestBracket = 40;
// A bracket that tells how wide a space is has no more tokens than this.
constexpr size_t kLongestFigure = 10;

class BracketReader {
 public:
  BracketReader(const std::vector<Token>& tokens, size_t at, const Names& names, std::vector<RawTerm>& terms)
      : tokens_(tokens), at_(at), end_(at + 1), names_(names), terms_(terms) {
    const size_t limit = std::min(tokens.size(), at + kLongestBracket);
    while (end_ < limit && !tokens[end_].IsMark(')') && !tokens[end_].IsMark('.')) ++end_;
  }

  Bracket Read() {
    const Token& first = tokens_[at_ + 1];
    // "Enough space (at least 0.6 m) behind": the bracket adds to what is said.
    const bool adds = SpaceSpokenOf();
    const bool closed = end_ < tokens_.size() && tokens_[end_].IsMark(')');
    if (first.kind == Token::Kind::kLength && (!IsSize() || adds) && end_ <= at_ + 4 && closed) {
      return {Bracket::Kind::kOpened, at_ + 1, end_};
    }
    // "0.4 m (ideally 0.5 m)": how much was said.
    const bool said = !terms_.empty() && terms_.back().term.kind == Term::Kind::kDistance;
    if (said && IsOneOf(first, {"ideally", "preferably"}) && closed) return {Bracket::Kind::kSkipped, end_ + 1, 0};
    if (IsLength() || TakeNames() || TakeSide() || (adds && closed && TakeFigure()) || Explains()) {
      return {Bracket::Kind::kSkipped, std::min(end_ + 1, tokens_.size()), 0};
    }
    return {};
  }

 private:
  bool Is(size_t i, std::string_view word) const { return i < tokens_.size() && tokens_[i].IsWord(word); }

  // "(1.5m)", "(2 m side)": how long a thing is.
  bool IsSize() const {
    const Token& first = tokens_[at_ + 1];
    const bool edge = end_ == at_ + 3 && IsOneOf(tokens_[at_ + 2], {"edge", "side", "each", "width", "length"});
    return first.kind == Token::Kind::kLength && first.length.exact && (end_ == at_ + 2 || edge);
  }

  bool Explains() const {
    const Token& first = tokens_[at_ + 1];
    // "(left side)" says which one.
    if (first.IsWord("left") && (Is(at_ + 2, "side") || Is(at_ + 2, "hand"))) return false;
    return first.IsMark(')') || IsSize() || IsOneOf(first, {"eg", "ie", "preferably", "left", "ideally", "including"});
  }

  // Whether this sentence has said that something is kept free, so that a bare figure is how much.
  bool SpaceSpokenOf() const {
    for (size_t i = terms_.size(); i > 0 && terms_[i - 1].term.kind != Term::Kind::kStop; --i) {
      const Term& term = terms_[i - 1].term;
      const bool way = term.kind == Term::Kind::kMention && term.mention.references.front().name == "paths";
      if (way || term.IsAnyWord({"space", "pull_out", "keep_clear", "accessible", "away_from", "clear_of", "around",
                                 "all_sides", "in_front", "behind", "swing_open"})) {
        return true;
      }
    }
    return false;
  }

  // "(preferably 0.5 m minimum clearance)": the one length in it. One that says where, too, is read like the rest.
  bool TakeFigure() {
    const auto is_length = [](const Token& token) { return token.kind == Token::Kind::kLength; };
    for (size_t i = at_ + 1; i < end_; ++i) {
      const Phrase phrase = Lexicon::Get().Find(tokens_, i);
      const bool says_where = phrase.word_class == v1::WORD_CLASS_SIDE ||
                              (phrase.word_class == v1::WORD_CLASS_RELATION && phrase.lemma != "space");
      if (phrase.length > 0 && says_where) return false;
    }
    const auto begin = tokens_.begin() + static_cast<long>(at_) + 1;
    const auto end = tokens_.begin() + static_cast<long>(end_);
    if (end_ - at_ > kLongestFigure || std::count_if(begin, end, is_length) != 1) return false;
    const Token& length = *std::find_if(begin, end, is_length);
    RawTerm raw;
    raw.term.kind = Term::Kind::kDistance;
    raw.term.distance = length.length;
    raw.term.begin = length.begin;
    raw.term.end = length.end;
    terms_.push_back(std::move(raw));
    return true;
  }

  // The side word just before that leaves open which one is meant; null when there is none.
  std::string* OpenSide() {
    if (terms_.empty() || terms_.back().role != RawTerm::Role::kSide) return nullptr;
    std::string& side = terms_.back().term.lemma;
    const bool open =
        side == "side" || side == "long_one" || side == "short_one" || side == "two_any" || side == "opposite_two";
    return open ? &side : nullptr;
  }

  // "The front (1 m side)": how long the side is.
  bool IsLength() const {
    const size_t side = at_ + (Is(at_ + 1, "the") ? 2 : 1);
    return side + 1 == end_ && tokens_[side].text.starts_with("length");
  }

  // "One side (preferably the front)".
  bool TakeSide() {
    std::string* const open = OpenSide();
    if (open == nullptr) return false;
    std::vector<std::string> named;
    for (size_t i = at_ + 1; i < end_; ++i) {
      const Phrase phrase = Lexicon::Get().Find(tokens_, i);
      if (phrase.word_class == v1::WORD_CLASS_SIDE && phrase.length > 0) named.push_back(phrase.lemma);
      if (phrase.length > 1) i += phrase.length - 1;
    }
    if (named.size() == 1) *open = named[0];
    return !named.empty();
  }

  // "The seating zone (sofa and armchair)": the names stand for the zone.
  bool TakeNames() {
    if (terms_.empty() || terms_.back().role != RawTerm::Role::kNone || !IsZoneOrClass(terms_.back().term))
      return false;
    std::vector<Reference> named;
    for (size_t i = at_ + 1; i < end_;) {
      const Names::Found name = names_.Find(tokens_, i);
      const bool joins = tokens_[i].IsMark(',') || tokens_[i].IsMark('/') ||
                         IsOneOf(tokens_[i], {"and", "the", "or", "eg", "like", "such", "as"});
      if (name.length == 0 && !joins) return false;
      if (name.length > 0) named.push_back(name.reference);
      i += std::max<size_t>(name.length, 1);
    }
    if (named.empty()) return false;
    terms_.back().term.mention.references = std::move(named);
    return true;
  }

  static bool IsZoneOrClass(const Term& term) {
    if (term.kind != Term::Kind::kMention) return false;
    const RefKind kind = term.mention.references.back().kind;
    return kind == RefKind::kZone || kind == RefKind::kGroup || kind == RefKind::kAbsent;
  }

  const std::vector<Token>& tokens_;
  const size_t at_;
  // The closing mark, or where reading ends without one.
  size_t end_;
  const Names& names_;
  std::vector<RawTerm>& terms_;
};

}  // namespace

Bracket ReadBracket(const std::vector<Token>& tokens, size_t at, const Names& names, std::vector<RawTerm>& terms) {
  if (!tokens[at].IsMark('(') || at + 1 >= tokens.size()) return {};
  return BracketReader(tokens, at, names, terms).Read();
}

}  // namespace flair::english
