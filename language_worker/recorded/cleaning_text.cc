// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/recorded/cleaning_text.h"

#include <algorithm>
#include <set>
#include <string>

#include "language_worker/recorded/sentences.h"

namespace flair::language {
namespace {

using model::v1::ChangeAnswer;
using model::v1::CleaningAnswer;

// Less than that of the shorter sentence's words in common: another sentence.
constexpr double kSame = 0.6, kSaidElsewhere = 0.75;
constexpr int kMostParts = 8;

bool SameWords(std::string_view a, std::string_view b) {
  const std::vector<Word> first = ReadWords(a), second = ReadWords(b);
  return std::equal(first.begin(), first.end(), second.begin(), second.end(),
                    [](const Word& x, const Word& y) { return x.key == y.key; });
}

class CleaningMatcher {
 public:
  CleaningMatcher(const std::vector<PromptSentence>& before, const std::vector<RecordedSentence>& after,
                  const std::vector<std::string>& names)
      : before_(before), after_(after), parts_(before.size()), taken_(after.size(), false) {
    for (const PromptSentence& sentence : before) {
      std::set<std::string> keys;
      for (const std::string& id : sentence.subject_ids) keys.insert(NameKey(id));
      before_keys_.push_back(std::move(keys));
    }
    for (const RecordedSentence& sentence : after) {
      std::set<std::string> keys;
      for (const int object : sentence.objects) keys.insert(NameKey(names[static_cast<size_t>(object)]));
      after_keys_.push_back(std::move(keys));
    }
  }

  CleaningAnswer Match() {
    for (const double least : {1.01, kSame}) {
      for (size_t c = 0; c < after_.size(); ++c) TakeBest(c, least);
    }
    // What is left says a part of what another one says too.
    for (size_t c = 0; c < after_.size(); ++c) {
      if (!taken_[c]) AddPart(c);
    }
    return Changes();
  }

 private:
  // 2 for the same words in the same order.
  double Score(size_t r, size_t c) const {
    const auto common = [&](const std::string& key) { return before_keys_[r].contains(key); };
    if (!std::any_of(after_keys_[c].begin(), after_keys_[c].end(), common)) return 0;
    if (SameWords(before_[r].text, after_[c].text)) return 2;
    return Likeness(before_[r].text, after_[c].text);
  }

  // Gives the cleaned sentence to the best sentence that has none yet.
  void TakeBest(size_t c, double least) {
    if (taken_[c]) return;
    size_t best = before_.size();
    double best_score = 0;
    for (size_t r = 0; r < before_.size(); ++r) {
      const double score = parts_[r].empty() ? Score(r, c) : 0;
      if (score < least || score <= best_score) continue;
      best = r;
      best_score = score;
    }
    if (best == before_.size()) return;
    parts_[best].push_back(c);
    taken_[c] = true;
  }

  void AddPart(size_t c) {
    size_t best = before_.size();
    double best_score = kSame;
    for (size_t r = 0; r < before_.size(); ++r) {
      const double score = parts_[r].size() < kMostParts ? Score(r, c) : 0;
      if (score < best_score || (best != before_.size() && score == best_score)) continue;
      best = r;
      best_score = score;
    }
    if (best == before_.size()) return;
    for (const size_t part : parts_[best]) {
      if (Likeness(after_[part].text, after_[c].text) == 1) return;  // the same again
    }
    parts_[best].push_back(c);
    taken_[c] = true;
  }

  bool SaidElsewhere(size_t r) const {
    for (size_t c = 0; c < after_.size(); ++c) {
      if (taken_[c] && Score(r, c) >= kSaidElsewhere) return true;
    }
    return false;
  }

  CleaningAnswer Changes() const {
    CleaningAnswer changes, removals;
    for (size_t r = 0; r < before_.size(); ++r) {
      const std::vector<size_t>& parts = parts_[r];
      if (parts.size() == 1 && SameWords(before_[r].text, after_[parts[0]].text)) continue;
      ChangeAnswer& change = parts.empty() ? *removals.add_changes() : *changes.add_changes();
      change.set_from(before_[r].id);
      for (const size_t c : parts) change.add_to(after_[c].text);
      if (parts.empty()) change.add_to(SaidElsewhere(r) ? "none(another one says it)" : "none");
    }
    if (2 * static_cast<size_t>(removals.changes_size()) <= before_.size()) changes.MergeFrom(removals);
    return changes;
  }

  const std::vector<PromptSentence>& before_;
  const std::vector<RecordedSentence>& after_;
  std::vector<std::set<std::string>> before_keys_, after_keys_;
  // Of each sentence, the cleaned ones that it became.
  std::vector<std::vector<size_t>> parts_;
  std::vector<bool> taken_;
};

}  // namespace

CleaningAnswer FindChanges(const std::vector<PromptSentence>& before, const std::vector<RecordedSentence>& after,
                           const std::vector<std::string>& names) {
  return CleaningMatcher(before, after, names).Match();
}

}  // namespace flair::language
