// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/walk.h"

#include "fmt/format.h"
#include "translator_worker/grammar/frames.h"
#include "translator_worker/grammar/translate.h"

namespace flair::translator {
namespace {

// No pattern is longer than this many terms.
constexpr size_t kLongestFact = 14;

}  // namespace

void Walk::Run() {
  while (at_ < terms_.size()) {
    const Term& term = terms_[at_];
    if (term.kind == Term::Kind::kStop) {
      in_reason_ = false;
      denied_ = false;
      clause_begins_ = true;
      ++at_;
      continue;
    }
    // "To allow talks without crowding the sofa": what is ruled out holds whatever the reason.
    if (term.IsWord("not") && text_.substr(term.begin, term.end - term.begin) == "without") in_reason_ = false;
    if ((!in_reason_ || term.kind == Term::Kind::kDistance) && TakeFact()) {
      in_reason_ = false;
      clause_begins_ = false;
    } else {
      LeaveOver(term);
      ++at_;
    }
  }
}

bool Walk::vague() const {
  return std::any_of(unused_.begin(), unused_.end(), [](const Mention* mention) {
    return std::any_of(mention->references.begin(), mention->references.end(),
                       [](const Reference& reference) { return reference.kind == RefKind::kVague; });
  });
}

void Walk::RefuseVague() {
  for (const Mention* mention : unused_) {
    for (const Reference& reference : mention->references) {
      if (reference.kind == RefKind::kVague) {
        composer_.Refuse("not_about_layout",
                         fmt::format("{} cannot be said by a layout call; name the objects and distances that serve it",
                                     reference.name));
      } else if (reference.kind == RefKind::kAbsent) {
        composer_.Refuse("names_absent_object", fmt::format("the room has no \"{}\"", reference.name));
      }
    }
  }
}

bool Walk::TakeFact() {
  const std::span<const Term> rest(terms_.data() + at_, std::min(kLongestFact, terms_.size() - at_));
  FrameBook::Hit hit = FrameBook::Get().Find(rest);
  if (hit.build != nullptr && EndsInNextFact(hit.match.length))
    hit = FrameBook::Get().Find(rest.first(hit.match.length - 2));
  if (hit.build != nullptr && EndsInNextSubject(hit.match.length))
    hit = FrameBook::Get().Find(rest.first(hit.match.length - 1));
  if (hit.build == nullptr || Passive()) return false;
  // "against a wall or beside the bed": the first is taken, the choice is free.
  const size_t before = composer_.calls().size();
  const bool alternative = after_or_ && before > calls_at_or_;
  if (denied_) {
    composer_.Refuse("unknown_sentence", "this relation cannot be denied; say what shall hold instead");
  } else if (!alternative) {
    if (hit.match.a != nullptr) TakeTopic(*hit.match.a);
    hit.build(hit.match, hit.detail, composer_);
  }
  at_ += hit.match.length;
  PassRepeatedPartner();
  after_or_ = at_ < terms_.size() && terms_[at_].IsWord("or");
  if (after_or_) {
    calls_at_or_ = before;
    ++at_;
  }
  return true;
}

void Walk::PassRepeatedPartner() {
  if (at_ == 0 || at_ + 1 >= terms_.size() || terms_[at_ - 1].kind != Term::Kind::kDistance) return;
  if (!terms_[at_].IsWord("away_from") || terms_[at_ + 1].kind != Term::Kind::kMention) return;
  const Reference& first = terms_[at_ + 1].mention.references.front();
  if (first.kind == RefKind::kPronoun && first.side.empty() && !composer_.pair_targets().empty()) at_ += 2;
}

bool Walk::EndsInNextFact(size_t length) const {
  const size_t next = at_ + length;
  if (length < 4 || next + 1 >= terms_.size() || terms_[next - 1].kind != Term::Kind::kDistance) return false;
  const Term& joint = terms_[next - 2];
  const bool joined = joint.kind == Term::Kind::kSoft && joint.lemma != "(" && joint.lemma != ")";
  const Term& relation = terms_[next];
  const bool relates = relation.IsWord("away_from") || relation.IsWord("in_front_of") || relation.IsWord("behind") ||
                       relation.IsWord("left_of") || relation.IsWord("right_of") || relation.IsWord("to_side");
  return joined && relates && terms_[next + 1].kind == Term::Kind::kMention &&
         terms_[next + 1].mention.references.front().kind != RefKind::kPronoun;
}

bool Walk::EndsInNextSubject(size_t length) const {
  const size_t next = at_ + length;
  if (length < 3 || next >= terms_.size() || terms_[next - 2].kind != Term::Kind::kSoft) return false;
  const Term& side = terms_[next - 1];
  const bool own = side.kind == Term::Kind::kMention && side.mention.references.front().kind == RefKind::kPronoun &&
                   !side.mention.references.front().side.empty();
  const Term& verb = terms_[next];
  // "Along a wall with the long side against it": of that wall.
  const bool of_it = next + 1 < terms_.size() && verb.IsAnyWord({"against", "facing", "along"}) &&
                     terms_[next + 1].kind == Term::Kind::kMention &&
                     terms_[next + 1].mention.references.front().kind == RefKind::kPronoun;
  if (of_it) return false;
  const bool goes_on = verb.kind == Term::Kind::kDistance ||
                       (verb.kind == Term::Kind::kWord && !verb.IsWord("or") && !verb.IsWord("of"));
  return own && goes_on;
}

bool Walk::Passive() const {
  if (at_ == 0 || !terms_[at_].IsWord("next_to") || terms_[at_].end - terms_[at_].begin != 2) return false;
  const Term& before = terms_[at_ - 1];
  return before.kind == Term::Kind::kUnknown && before.lemma.size() > 3 && before.lemma.ends_with("ed");
}

bool Walk::TellsOwnSide() const {
  if (at_ + 2 >= terms_.size() || terms_[at_].lemma != "so") return false;
  const Term& side = terms_[at_ + 1];
  const bool own = side.kind == Term::Kind::kMention && side.mention.references.front().kind == RefKind::kPronoun &&
                   !side.mention.references.front().side.empty();
  return own && (terms_[at_ + 2].IsWord("against") || terms_[at_ + 2].IsWord("next_to"));
}

void Walk::TakeTopic(const Mention& mention) {
  if (mention.references.front().kind != RefKind::kObjects) return;
  // What a thing on a table or wall is about is its heading: "Desk organizer: on the shelf".
  if (composer_.scope() == v1::SENTENCE_SCOPE_TERTIARY && !composer_.subjects().empty()) return;
  std::vector<Placed> movers = composer_.Movers(&mention);
  for (Placed& placed : movers) placed.side.clear();
  if (!movers.empty()) composer_.SetTopic(std::move(movers));
}

void Walk::LeaveOver(const Term& term) {
  switch (term.kind) {
    case Term::Kind::kPurpose:
      // "that" after a thing tells which one; "ensure that" tells nothing.
      if (reads_reasons_ && (term.lemma == "to" || term.lemma == "for" || term.lemma == "so")) break;
      if (TellsOwnSide()) break;
      if (term.lemma != "that" || (at_ > 0 && terms_[at_ - 1].kind == Term::Kind::kMention)) in_reason_ = true;
      reasons_ = reasons_ || term.lemma == "to" || term.lemma == "for" || term.lemma == "so";
      break;
    case Term::Kind::kWord:
      if (!in_reason_ && term.lemma == "not") denied_ = true;
      break;
    case Term::Kind::kSoft:
      denied_ = false;
      if (term.lemma == "," || term.lemma == "but" || term.lemma == "while" || term.lemma == "with" ||
          term.lemma == "(" || term.lemma == ")" || term.lemma == ":")
        in_reason_ = false;
      break;
    case Term::Kind::kMention:
      if (in_reason_) break;
      if (at_ > 0 && terms_[at_ - 1].kind == Term::Kind::kSoft && terms_[at_ - 1].lemma == "(" &&
          term.mention.references.front().kind == RefKind::kPronoun && !term.mention.references.front().side.empty()) {
        composer_.CompleteSide(term.mention.references.front().side);
      }
      if (clause_begins_) TakeTopic(term.mention);
      if (term.mention.references.front().kind == RefKind::kObjects && composer_.topic().empty())
        TakeTopic(term.mention);
      unused_.push_back(&term.mention);
      clause_begins_ = false;
      break;
    case Term::Kind::kUnknown:
    case Term::Kind::kDistance:
      if (!in_reason_) left_over_.push_back(Quote(text_.substr(term.begin, term.end - term.begin)));
      break;
    default:
      break;
  }
}

}  // namespace flair::translator
