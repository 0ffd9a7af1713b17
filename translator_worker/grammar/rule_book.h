// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "translator_worker/grammar/pattern.h"
#include "translator_worker/grammar/rules/rule.h"
#include "translator_worker/grammar/term.h"

namespace flair::translator {

// All families' rules, ready to match. Immutable and thread-safe.
class RuleBook {
 public:
  // The one book, compiled on first use.
  static const RuleBook& Get();

  struct Hit {
    const Rule* rule = nullptr;
    Match match;
  };

  // The rule that covers the most terms from the first one on; of equals the earlier in the book. Null when none does.
  Hit Find(std::span<const Term> terms) const;

  size_t size() const { return rules_.size(); }

 private:
  RuleBook();

  std::vector<Rule> rules_;
  std::vector<Pattern> patterns_;
};

}  // namespace flair::translator
