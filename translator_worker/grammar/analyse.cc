// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <utility>

#include "translator_worker/grammar/furniture_words.h"
#include "translator_worker/grammar/lexicon.h"
#include "translator_worker/grammar/noun_phrases.h"
#include "translator_worker/grammar/quantity.h"
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
      if (SkipBracket()) continue;
      const SceneNames::Found name = names_.Find(tokens_, at_);
      const Phrase phrase = FindPhrase();
      const bool relation_wins =
          phrase.length == name.length && phrase.word_class == WordClass::kRelation && !name.full;
      if (name.length > 0 && name.length >= phrase.length && !relation_wins) {
        PushName(name);
      } else if (phrase.length > 0) {
        PushPhrase(phrase);
      } else {
        PushOther();
      }
    }
    return std::move(terms_);
  }

 private:
  void Push(RawTerm term, size_t length) {
    term.term.begin = tokens_[at_].begin;
    term.term.end = tokens_[at_ + length - 1].end;
    at_ += length;
    terms_.push_back(std::move(term));
  }

  // "any side tables" is not "any side" and "tables": a name that begins within a phrase and ends after it cuts it
  // short.
  Phrase FindPhrase() const {
    const Phrase phrase = Lexicon::Get().Find(tokens_, at_);
    for (size_t k = 1; k < phrase.length; ++k) {
      const SceneNames::Found name = names_.Find(tokens_, at_ + k);
      if (name.length > 1 && k + name.length > phrase.length) return Lexicon::Get().Find(tokens_, at_, k);
    }
    return phrase;
  }

  // "(e.g., to place items)" explains; it says nothing of its own.
  bool SkipBracket() {
    if (!tokens_[at_].IsMark('(') || at_ + 1 >= tokens_.size()) return false;
    const Token& first = tokens_[at_ + 1];
    const bool length_only =
        first.kind == Token::Kind::kDistance && at_ + 2 < tokens_.size() &&
        (tokens_[at_ + 2].IsMark(')') || (at_ + 3 < tokens_.size() && tokens_[at_ + 3].IsMark(')')));
    if (!first.IsWord("eg") && !first.IsWord("ie") && !first.IsWord("preferably") && !first.IsWord("left") &&
        !first.IsMark(')') && !length_only) {
      return false;
    }
    while (at_ < tokens_.size() && !tokens_[at_].IsMark(')') && !tokens_[at_].IsMark('.')) ++at_;
    if (at_ < tokens_.size()) ++at_;
    return true;
  }

  void PushName(const SceneNames::Found& found) {
    RawTerm raw;
    raw.term.kind = Term::Kind::kMention;
    raw.term.mention.references = {found.reference};
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
        raw.term.lemma = token.IsMark('(') ? "(" : ",";
      }
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
      case WordClass::kFiller:
        at_ += phrase.length;
        return;
      case WordClass::kWish:
        analysis_.wish = true;
        at_ += phrase.length;
        return;
      case WordClass::kCondition:
        analysis_.conditional = true;
        at_ += phrase.length;
        return;
      case WordClass::kModal:
        raw.role = RawTerm::Role::kModal;
        break;
      case WordClass::kQuantity:
        raw.role = RawTerm::Role::kEach;
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
        raw.term.lemma = tokens_[at_].text;
        break;
      case WordClass::kNot:
        push_word("not");
        break;
      case WordClass::kRelation:
        push_word(phrase.lemma);
        break;
      case WordClass::kFeature:
        reference.plural = true;
        raw.part_of_furniture = tokens_[at_ + phrase.length - 1].IsWord("doors") && phrase.length == 1;
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
        if (tokens_[at_].IsWord("no")) raw.negative = true;
        push_reference(RefKind::kGroup);
        break;
      case WordClass::kPronoun:
        push_reference(RefKind::kPronoun);
        break;
      case WordClass::kVague:
        push_reference(RefKind::kVague);
        break;
    }
    Push(std::move(raw), phrase.length);
  }

  const std::vector<Token> tokens_;
  const SceneNames& names_;
  Analysis& analysis_;
  size_t at_ = 0;
  std::vector<RawTerm> terms_;
};

// "not" itself; "to avoid" begins a reason all the same.
bool IsPlainNot(const Term& term) { return term.IsWord("not") && term.end - term.begin == 3; }

// "Not to block", "to not block": no reason follows.
void DropToBesideNot(std::vector<Term>& terms) {
  std::vector<Term> kept;
  for (size_t i = 0; i < terms.size(); ++i) {
    const bool to = terms[i].kind == Term::Kind::kPurpose && terms[i].lemma == "to";
    const bool beside_not =
        (!kept.empty() && IsPlainNot(kept.back())) || (i + 1 < terms.size() && IsPlainNot(terms[i + 1]));
    if (!to || !beside_not) kept.push_back(std::move(terms[i]));
  }
  terms = std::move(kept);
}

// "Avoid [X] in front of windows" and "X not in front of windows" are one form: the second.
void MoveNotBehindSubject(std::vector<Term>& terms) {
  for (size_t i = 0; i + 2 < terms.size(); ++i) {
    if (terms[i].IsWord("not") && terms[i + 1].kind == Term::Kind::kMention && terms[i + 2].kind == Term::Kind::kWord) {
      std::swap(terms[i], terms[i + 1]);
    }
  }
}

}  // namespace

Analysis Analyse(std::string_view text, const SceneNames& names) {
  Analysis analysis;
  Reader reader(JoinQuantities(Tokenize(text)), names, analysis);
  analysis.terms = GroupNounPhrases(reader.Run());
  DropToBesideNot(analysis.terms);
  MoveNotBehindSubject(analysis.terms);
  return analysis;
}

}  // namespace flair::translator
