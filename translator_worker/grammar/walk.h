// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "translator_worker/grammar/composer.h"
#include "translator_worker/grammar/term.h"

namespace flair::translator {

// Reads a sentence from left to right: at each term the rule that covers most is taken; what none covers is left over.
// Borrows its arguments. Linear in the number of terms.
class Walk {
 public:
  // `reads_reasons`: what follows "to" and "for" is read like the rest.
  Walk(const Analysis& analysis, Composer& composer, std::string_view text, bool reads_reasons)
      : terms_(analysis.terms), composer_(composer), text_(text), reads_reasons_(reads_reasons) {}

  void Run();

  // Content words that no fact covered.
  const std::vector<std::string>& left_over() const { return left_over_; }
  // Whether something was skipped as a reason.
  bool reasons() const { return reasons_; }
  // Whether a "not" was left over.
  bool denied() const { return denied_; }
  // Whether it names something no call is about.
  bool vague() const;
  // Left-over noun phrases that name something no call is about.
  void RefuseVague();

 private:
  bool TakeFact();

  // "To the left of the table, at most 0.5 m from it": the partner of the figure is named once more.
  void PassRepeatedPartner();

  // "Away from the shelf and at least 1 m from the stool": the figure is for the stool.
  bool EndsInNextFact(size_t length) const;

  // "Against a wall and its front needs 0.8 m", "against the wall with the front facing the room": of the side comes
  // more.
  bool EndsInNextSubject(size_t length) const;

  // "overshadowed by the bed": what happens to it, not where it is.
  bool Passive() const;

  // "So that its left side touches the stand": what touches what, no reason.
  bool TellsOwnSide() const;

  // Objects that are named as movers are spoken of from then on.
  void TakeTopic(const Mention& mention);

  void LeaveOver(const Term& term);

  const std::vector<Term>& terms_;
  Composer& composer_;
  const std::string_view text_;
  const bool reads_reasons_;
  bool reasons_ = false;
  size_t at_ = 0;
  bool in_reason_ = false;
  bool clause_begins_ = true;
  // A "not" that no rule took: what follows must not be read as wanted.
  bool denied_ = false;
  bool after_or_ = false;
  size_t calls_at_or_ = 0;
  std::vector<std::string> left_over_;
  std::vector<const Mention*> unused_;
};

}  // namespace flair::translator
