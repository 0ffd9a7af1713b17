// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "english/frames/noun_phrases.h"
#include "english/frames/term.h"
#include "english/frames/token_context.h"
#include "english/lexicon.h"
#include "english/quantities.h"

namespace flair::english {
namespace {

// Turns tokens into raw terms: words by the lexicon, names by the scene, nothing grouped yet.
class Reader {
 public:
  Reader(std::vector<Token> tokens, const Names& names, Analysis& analysis)
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
      const Names::Found name = names_.Find(tokens_, at_);
      const Phrase phrase = FindPhrase(Context());
      const bool relation_wins =
          phrase.length == name.length && phrase.word_class == v1::WORD_CLASS_RELATION && !name.full;
      // "The lamp stands": a verb, though there is a TV stand.
      const bool verb = phrase.length == name.length && phrase.word_class == v1::WORD_CLASS_FILLER && !name.full &&
                        VerbFollows(Context());
      if (name.length > 0 && name.length >= phrase.length && !relation_wins && !verb) {
        PushName(name);
      } else if (phrase.length > 0) {
        PushPhrase(phrase);
      } else if (const Phrase form = Lexicon::Get().FindForm(tokens_[at_]); form.length > 0) {
        PushPhrase(form);
      } else if (const Names::Found shared = FindNameWithSharedHead(Context()); shared.length > 0) {
        PushName(shared);
      } else {
        PushOther();
      }
    }
    return std::move(terms_);
  }

 private:
  TokenContext Context() const { return {tokens_, at_, names_, terms_}; }

  void Push(RawTerm term, size_t length) {
    term.term.begin = tokens_[at_].begin;
    term.term.end = tokens_[at_ + length - 1].end;
    at_ += length;
    terms_.push_back(std::move(term));
  }

  void PushName(const Names::Found& found) {
    RawTerm raw;
    raw.term.kind = Term::Kind::kMention;
    raw.term.mention.references = {found.reference};
    const Phrase area = Lexicon::Get().Find(tokens_, at_ + found.length);
    raw.term.mention.references.front().area = area.length > 0 && area.word_class == v1::WORD_CLASS_AREA;
    raw.term.mention.references.front().any = AnyIsMeant(Context());
    Push(std::move(raw), found.length);
  }

  void PushOther() {
    const Token& token = tokens_[at_];
    RawTerm raw;
    if (token.kind == Token::Kind::kLength) {
      raw.term.kind = Term::Kind::kDistance;
      raw.term.distance = token.length;
    } else if (token.kind == Token::Kind::kSign) {
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

  void PushPhrase(const Phrase& phrase) {
    if (Leaves(phrase)) return;
    RawTerm raw;
    switch (phrase.word_class) {
      case v1::WORD_CLASS_RELATION: {
        const bool of_side = phrase.lemma == "near" && ReachedFromSide(Context(), phrase);
        BecomeWord(of_side ? "accessible_from" : phrase.lemma, raw);
        break;
      }
      case v1::WORD_CLASS_FILLER:
        if (IsBothOfSeveral()) {
          raw.role = RawTerm::Role::kEach;
        } else {
          BecomeWord("keep_clear", raw);
        }
        break;
      case v1::WORD_CLASS_NOT:
        BecomeWord("not", raw);
        break;
      case v1::WORD_CLASS_PURPOSE:
        raw.term.kind = Term::Kind::kPurpose;
        raw.term.lemma = BeginsReason(tokens_, at_) ? "so" : tokens_[at_].text;
        break;
      case v1::WORD_CLASS_FEATURE:
      case v1::WORD_CLASS_PLACE:
      case v1::WORD_CLASS_GROUP:
      case v1::WORD_CLASS_VAGUE:
        PushMention(phrase);
        return;
      case v1::WORD_CLASS_PRONOUN:
        // "The two beds": how many, not whatever was spoken of.
        if (phrase.length > 1 && NounFollows(Context(), at_ + phrase.length)) {
          raw.role = RawTerm::Role::kEach;
        } else {
          BecomeReference(RefKind::kPronoun, phrase.lemma, raw);
          // "All three pieces", "both of them": whoever the heading names.
          raw.term.mention.references.front().plural = phrase.length > 1;
        }
        break;
      default:
        BecomePart(phrase, raw);
    }
    Push(std::move(raw), phrase.length);
  }

  // Whether the phrase leaves no term behind; then it has been passed.
  bool Leaves(const Phrase& phrase) {
    switch (phrase.word_class) {
      case v1::WORD_CLASS_RELATION:
        if (!TellsWhichOne(Context(), phrase)) return false;
        ++at_;
        return true;
      case v1::WORD_CLASS_FILLER:
        if (EndsSideClear(Context(), phrase) || IsBothOfSeveral()) return false;
        if (phrase.length > 1 && IsOneOf(tokens_[at_], {"so", "such"})) EndFact();
        break;
      case v1::WORD_CLASS_WISH:
        analysis_.wish = true;
        break;
      case v1::WORD_CLASS_CONDITION:
        if (const std::optional<size_t> next = LeaveOutCondition(tokens_, at_, phrase.length, terms_)) {
          analysis_.partly_conditional = true;
          at_ = *next;
          return true;
        }
        analysis_.conditional = true;
        break;
      case v1::WORD_CLASS_AREA:
        break;
      default:
        return false;
    }
    at_ += phrase.length;
    return true;
  }

  // "Next to the sofa so that it can be used": what follows belongs to no list of the fact before.
  void EndFact() {
    const bool relates = std::ranges::any_of(terms_, [](const RawTerm& raw) {
      return raw.role == RawTerm::Role::kNone && raw.term.kind == Term::Kind::kWord && !raw.term.IsWord("not");
    });
    if (!relates || !(IsMention(terms_.back()) || terms_.back().role == RawTerm::Role::kSide)) return;
    RawTerm comma;
    comma.term.kind = Term::Kind::kSoft;
    comma.term.lemma = ",";
    comma.term.begin = comma.term.end = tokens_[at_].begin;
    terms_.push_back(std::move(comma));
  }

  // "Both armchairs".
  bool IsBothOfSeveral() const {
    if (!tokens_[at_].IsWord("both") || at_ + 1 >= tokens_.size()) return false;
    const Names::Found things = names_.Find(tokens_, at_ + 1);
    return things.length > 0 && things.reference.kind == RefKind::kObjects && things.reference.plural;
  }

  void PushMention(const Phrase& phrase) {
    RawTerm raw;
    switch (phrase.word_class) {
      case v1::WORD_CLASS_FEATURE:
        BecomeReference(RefKind::kFeature, phrase.lemma, raw);
        raw.term.mention.references.front().plural = true;
        raw.part_of_furniture = IsOneOf(tokens_[at_ + phrase.length - 1], {"doors", "door", "entrance"}) &&
                                (phrase.length == 1 || (phrase.length == 2 && tokens_[at_].IsWord("the")));
        break;
      case v1::WORD_CLASS_PLACE:
        BecomeReference(phrase.lemma == "wall"      ? RefKind::kWall
                        : phrase.lemma == "ceiling" ? RefKind::kCeiling
                        : phrase.lemma == "floor"   ? RefKind::kFloor
                                                    : RefKind::kRoom,
                        "", raw);
        break;
      case v1::WORD_CLASS_GROUP:
        BecomeReference(RefKind::kGroup, phrase.lemma, raw);
        raw.negative = IsOneOf(tokens_[at_], {"no", "nothing"});
        break;
      default:
        BecomeReference(RefKind::kVague, phrase.lemma, raw);
    }
    Push(std::move(raw), phrase.length);
  }

  // Parts of noun phrases, which are put together later.
  void BecomePart(const Phrase& phrase, RawTerm& raw) const {
    using Role = RawTerm::Role;
    switch (phrase.word_class) {
      case v1::WORD_CLASS_MODAL:
        raw.role = Role::kModal;
        break;
      case v1::WORD_CLASS_QUANTITY:
        raw.role = Role::kEach;
        raw.negative = IsOneOf(tokens_[at_], {"none", "neither_one"});
        break;
      case v1::WORD_CLASS_ORDINAL:
        raw.role = Role::kOrdinal;
        raw.ordinal = std::stoi(phrase.lemma);
        break;
      case v1::WORD_CLASS_AND:
        raw.role = Role::kAnd;
        break;
      case v1::WORD_CLASS_OR:
        raw.role = Role::kOr;
        break;
      default:
        raw.role = Role::kSide;
        // "From any side": whichever is wanted, so all of them.
        raw.term.lemma =
            tokens_[at_].IsWord("any") && at_ > 0 && tokens_[at_ - 1].IsWord("from") ? "all" : phrase.lemma;
    }
  }

  std::vector<Token> tokens_;
  // The closing bracket of one that was opened up.
  size_t inlined_end_ = std::string::npos;
  const Names& names_;
  Analysis& analysis_;
  size_t at_ = 0;
  std::vector<RawTerm> terms_;
};

}  // namespace

Analysis Analyse(std::string_view text, const Names& names) {
  Analysis analysis;
  Reader reader(PrepareTokens(JoinLengths(KeepClauseMarks(Tokenize(text)))), names, analysis);
  analysis.terms = GroupNounPhrases(reader.Run());
  RewriteTerms(analysis.terms);
  return analysis;
}

}  // namespace flair::english
