// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "translator_worker/grammar/brackets.h"
#include "translator_worker/grammar/conditions.h"
#include "translator_worker/grammar/lexicon.h"
#include "translator_worker/grammar/noun_phrases.h"
#include "translator_worker/grammar/prepare_tokens.h"
#include "translator_worker/grammar/quantity.h"
#include "translator_worker/grammar/rewrite_terms.h"
#include "translator_worker/grammar/term.h"

namespace flair::translator {
namespace {

// Turns tokens into raw terms: words by the lexicon, names by the scene, nothing grouped yet.
class Reader {
 public:
  Reader(std::vector<Token> tokens, const SceneNames& names, Analysis& analysis)
      : tokens_(std::move(tokens)), names_(names), analysis_(analysis) {}

  std::vector<RawTerm> Run() {
    while (at_ < tokens_.size()) {
      if (at_ == inlined_end_) {
        ++at_;
        continue;
      }
      const Bracket bracket = ReadBracket(tokens_, at_, names_, terms_);
      if (bracket.kind != Bracket::Kind::kPlain) {
        if (bracket.kind == Bracket::Kind::kOpened) inlined_end_ = bracket.closing;
        at_ = bracket.next;
        continue;
      }
      const SceneNames::Found name = names_.Find(tokens_, at_);
      const Phrase phrase = FindPhrase();
      const bool relation_wins =
          phrase.length == name.length && phrase.word_class == WordClass::kRelation && !name.full;
      // "The lamp stands": a verb, though there is a TV stand.
      const bool verb =
          phrase.length == name.length && phrase.word_class == WordClass::kFiller && !name.full && VerbFollows();
      if (name.length > 0 && name.length >= phrase.length && !relation_wins && !verb) {
        PushName(name);
      } else if (phrase.length > 0) {
        PushPhrase(phrase);
      } else if (const Phrase form = Lexicon::Get().FindForm(tokens_[at_]); form.length > 0) {
        PushPhrase(form);
      } else {
        PushOther();
      }
    }
    return std::move(terms_);
  }

 private:
  // "The lamp", "must", "not", or the beginning: a verb comes next, where "the" would bring a noun.
  bool VerbFollows() const {
    if (at_ == 0 || tokens_[at_ - 1].IsMark('.')) return true;
    if (terms_.empty()) return false;
    const RawTerm& before = terms_.back();
    if (before.term.kind == Term::Kind::kPurpose && tokens_[at_ - 1].IsWord("to")) return true;
    if (before.role == RawTerm::Role::kModal || before.term.IsWord("not"))
      return before.term.end == tokens_[at_ - 1].end;
    return before.role == RawTerm::Role::kNone && before.term.kind == Term::Kind::kMention;
  }

  static bool IsOneOf(const Token& token, std::initializer_list<std::string_view> words) {
    return std::any_of(words.begin(), words.end(), [&](std::string_view word) { return token.IsWord(word); });
  }

  bool NounFollows(size_t at) const {
    if (at >= tokens_.size()) return false;
    return names_.Find(tokens_, at).length > 0 || Lexicon::Get().Find(tokens_, at).word_class == WordClass::kFeature;
  }

  void Push(RawTerm term, size_t length) {
    term.term.begin = tokens_[at_].begin;
    term.term.end = tokens_[at_ + length - 1].end;
    at_ += length;
    terms_.push_back(std::move(term));
  }

  // "any side tables" is not "any side" and "tables", "any wall sockets" not "any wall": a name that begins within a
  // phrase and ends after it cuts it short.
  Phrase FindPhrase() const {
    const Phrase phrase = Lexicon::Get().Find(tokens_, at_);
    for (size_t k = 1; k < phrase.length; ++k) {
      const SceneNames::Found name = names_.Find(tokens_, at_ + k);
      const Phrase feature = Lexicon::Get().Find(tokens_, at_ + k);
      const bool of_feature = (phrase.word_class == WordClass::kPlace || phrase.lemma == "into_room") &&
                              feature.word_class == WordClass::kFeature && feature.length > 1;
      const size_t length = std::max(name.length, of_feature ? feature.length : 0);
      if (length > 1 && k + length > phrase.length) return Lexicon::Get().Find(tokens_, at_, k);
    }
    return phrase;
  }

  // After "a", "one of the".
  bool AnyIsMeant() const {
    size_t before = at_;
    if (before > 0 && tokens_[before - 1].IsWord("the")) --before;
    if (before > 0 && tokens_[before - 1].IsWord("of")) --before;
    if (before == at_) return at_ > 0 && IsOneOf(tokens_[at_ - 1], {"a", "an", "one"});
    return before > 0 && tokens_[before - 1].IsWord("one");
  }

  void PushName(const SceneNames::Found& found) {
    RawTerm raw;
    raw.term.kind = Term::Kind::kMention;
    raw.term.mention.references = {found.reference};
    const Phrase area = Lexicon::Get().Find(tokens_, at_ + found.length);
    raw.term.mention.references.front().area = area.length > 0 && area.word_class == WordClass::kArea;
    raw.term.mention.references.front().any = AnyIsMeant();
    Push(std::move(raw), found.length);
  }

  void PushOther() {
    const Token& token = tokens_[at_];
    RawTerm raw;
    if (token.kind == Token::Kind::kDistance) {
      raw.term.kind = Term::Kind::kDistance;
      raw.term.distance = token.distance;
    } else if (token.kind == Token::Kind::kPunctuation) {
      if (token.IsMark('.')) {
        raw.term.kind = Term::Kind::kStop;
      } else if (token.IsMark('/')) {
        raw.role = RawTerm::Role::kOr;
      } else {
        raw.term.kind = Term::Kind::kSoft;
        raw.term.lemma = token.IsMark('(') ? "(" : token.IsMark(')') ? ")" : token.IsMark(':') ? ":" : ",";
      }
    } else if (token.text.rfind("length:", 0) == 0 || token.text.rfind("lengths:", 0) == 0) {
      raw.role = RawTerm::Role::kSide;
      raw.term.lemma = token.text;
    } else if (token.IsWord("'s")) {
      raw.role = RawTerm::Role::kPossessive;
    } else if (token.IsWord("with") || token.IsWord("but") || token.IsWord("while") || token.IsWord("so")) {
      raw.term.kind = Term::Kind::kSoft;
      raw.term.lemma = token.text;
    } else if (token.kind == Token::Kind::kNumber ||
               (token.text.size() > 4 && token.text.substr(token.text.size() - 2) == "ly")) {
      ++at_;  // adverbs and bare numbers place nothing
      return;
    } else {
      raw.term.lemma = token.text;
    }
    Push(std::move(raw), 1);
  }

  // "Keep the front clear", "front accessibility": elsewhere "clear" tells only what kind of space.
  bool EndsSideClear(const Phrase& phrase) const {
    if (phrase.word_class != WordClass::kFiller || phrase.length != 1 || terms_.empty()) return false;
    const Token& token = tokens_[at_];
    if (token.IsWord("accessibility") && terms_.back().role == RawTerm::Role::kSide) return true;
    if (!token.IsWord("clear") && !token.IsWord("free") && !token.IsWord("open")) return false;
    const size_t modals = terms_.back().role == RawTerm::Role::kModal ? 1 : 0;
    if (terms_.size() <= modals) return false;
    const RawTerm& what = terms_[terms_.size() - 1 - modals];
    const bool thing = what.role == RawTerm::Role::kNone && what.term.kind == Term::Kind::kMention;
    if (what.role != RawTerm::Role::kSide && !thing) return false;
    return at_ + 1 == tokens_.size() || tokens_[at_ + 1].IsMark('.') || tokens_[at_ + 1].IsMark(',') ||
           tokens_[at_ + 1].IsWord("for") || tokens_[at_ + 1].IsWord("to") || tokens_[at_ + 1].IsWord("so") ||
           tokens_[at_ + 1].IsWord("by");
  }

  // "Easily accessible from the front": from a side of its own, not from another thing.
  bool ReachedFromSide(const Phrase& phrase) const {
    size_t next = at_ + phrase.length;
    if (!tokens_[next - 1].IsWord("from")) return false;
    while (next < tokens_.size() && (tokens_[next].IsWord("the") || tokens_[next].IsWord("its"))) ++next;
    return next < tokens_.size() && Lexicon::Get().Find(tokens_, next).word_class == WordClass::kSide &&
           Lexicon::Get().Find(tokens_, next).length > 0;
  }

  void PushPhrase(const Phrase& phrase) {
    RawTerm raw;
    Reference reference;
    reference.name = phrase.lemma;
    const auto push_reference = [&](RefKind kind) {
      reference.kind = kind;
      raw.term.kind = Term::Kind::kMention;
      raw.term.mention.references = {reference};
    };
    const auto push_word = [&](std::string lemma) {
      raw.term.kind = Term::Kind::kWord;
      raw.term.lemma = std::move(lemma);
    };
    switch (phrase.word_class) {
      case WordClass::kRelation:
        if (phrase.lemma == "around" && at_ + 1 < tokens_.size() && tokens_[at_ + 1].kind == Token::Kind::kDistance) {
          ++at_;  // "around 0.9 m"
          return;
        }
        // "Between adjacent chairs": which ones, not where.
        if (phrase.length == 1 && IsOneOf(tokens_[at_], {"adjacent", "nearby"}) && at_ > 0 &&
            IsOneOf(tokens_[at_ - 1], {"between", "any", "of", "the", "from", "two", "other"}) &&
            NounFollows(at_ + 1)) {
          ++at_;
          return;
        }
        // "The central plunge pool": which one, not where.
        if (phrase.length == 1 && tokens_[at_].IsWord("central") && at_ > 0 && tokens_[at_ - 1].IsWord("the") &&
            (NounFollows(at_ + 1) || NounFollows(at_ + 2))) {
          ++at_;
          return;
        }
        push_word(phrase.lemma == "near" && ReachedFromSide(phrase) ? "accessible_from" : phrase.lemma);
        break;
      case WordClass::kFiller:
        if (EndsSideClear(phrase)) {
          push_word("keep_clear");
          break;
        }
        // "..., and both should": the two that were spoken of last.
        if (tokens_[at_].IsWord("both") && at_ + 1 < tokens_.size() && IsOneOf(tokens_[at_ + 1], {"should", "must"})) {
          reference.name = "both";
          push_reference(RefKind::kPronoun);
          break;
        }
        at_ += phrase.length;
        return;
      case WordClass::kWish:
        analysis_.wish = true;
        at_ += phrase.length;
        return;
      case WordClass::kCondition:
        if (const std::optional<size_t> next = LeaveOutCondition(tokens_, at_, phrase.length, terms_)) {
          analysis_.partly_conditional = true;
          at_ = *next;
          return;
        }
        analysis_.conditional = true;
        at_ += phrase.length;
        return;
      case WordClass::kModal:
        raw.role = RawTerm::Role::kModal;
        break;
      case WordClass::kQuantity:
        raw.role = RawTerm::Role::kEach;
        raw.negative = tokens_[at_].IsWord("none") || tokens_[at_].IsWord("neither_one");
        break;
      case WordClass::kOrdinal:
        raw.role = RawTerm::Role::kOrdinal;
        raw.ordinal = std::stoi(phrase.lemma);
        break;
      case WordClass::kAnd:
        raw.role = RawTerm::Role::kAnd;
        break;
      case WordClass::kOr:
        raw.role = RawTerm::Role::kOr;
        break;
      case WordClass::kSide:
        raw.role = RawTerm::Role::kSide;
        raw.term.lemma = phrase.lemma;
        break;
      case WordClass::kPurpose:
        raw.term.kind = Term::Kind::kPurpose;
        raw.term.lemma = BeginsReason(tokens_, at_) ? "so" : tokens_[at_].text;
        break;
      case WordClass::kNot:
        push_word("not");
        break;
      case WordClass::kFeature:
        reference.plural = true;
        raw.part_of_furniture = phrase.length == 1 && (tokens_[at_].IsWord("doors") || tokens_[at_].IsWord("door"));
        push_reference(RefKind::kFeature);
        break;
      case WordClass::kPlace: {
        const std::string place = std::exchange(reference.name, "");
        push_reference(place == "wall"      ? RefKind::kWall
                       : place == "ceiling" ? RefKind::kCeiling
                       : place == "floor"   ? RefKind::kFloor
                                            : RefKind::kRoom);
        break;
      }
      case WordClass::kArea:
        at_ += phrase.length;
        return;
      case WordClass::kGroup:
        if (tokens_[at_].IsWord("no") || tokens_[at_].IsWord("nothing")) raw.negative = true;
        push_reference(RefKind::kGroup);
        break;
      case WordClass::kPronoun:
        // "The two beds": how many, not whatever was spoken of.
        if (phrase.length > 1 && NounFollows(at_ + phrase.length)) {
          raw.role = RawTerm::Role::kEach;
          break;
        }
        push_reference(RefKind::kPronoun);
        break;
      case WordClass::kVague:
        push_reference(RefKind::kVague);
        break;
    }
    Push(std::move(raw), phrase.length);
  }

  std::vector<Token> tokens_;
  // The closing bracket of one that was opened up.
  size_t inlined_end_ = std::string::npos;
  const SceneNames& names_;
  Analysis& analysis_;
  size_t at_ = 0;
  std::vector<RawTerm> terms_;
};

}  // namespace

Analysis Analyse(std::string_view text, const SceneNames& names) {
  Analysis analysis;
  Reader reader(PrepareTokens(JoinQuantities(Tokenize(text))), names, analysis);
  analysis.terms = GroupNounPhrases(reader.Run());
  RewriteTerms(analysis.terms);
  return analysis;
}

}  // namespace flair::translator
