// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bitset>
#include <span>
#include <string>
#include <unordered_map>
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

  // One bit a lemma that some pattern requires.
  using Lemmas = std::bitset<256>;
  Lemmas Among(std::span<const Term> terms) const;

  std::vector<Rule> rules_;
  std::vector<Pattern> patterns_;
  std::unordered_map<std::string, size_t> bits_;
  // Of each pattern, choices of lemmas: without one of each it cannot match.
  std::vector<std::vector<Lemmas>> required_;
};

}  // namespace flair::translator
