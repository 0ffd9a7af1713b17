// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/recorded/constraint_text.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "english/language.h"
#include "language_worker/recorded/object_names.h"
#include "language_worker/recorded/outline.h"

namespace flair::language {
namespace {

// Words that a constraint has and a heading has not.
bool Demands(std::string_view text) { return HasWordOf("demands", text); }

bool SaysMust(std::string_view text) { return HasWordOf("musts", text); }

// "Constraint: Back side should be against a wall." without the first word, which says nothing.
std::string WithoutEmptyLabel(const OutlineLine& line) {
  const std::string all = line.All();
  const size_t colon = all.find(": ");
  if (colon == std::string::npos || colon > 30) return all;
  std::string label;
  for (const Word& word : ReadWords(std::string_view(all).substr(0, colon))) {
    label += (label.empty() ? "" : " ") + word.key;
  }
  return english::Language::Get().IsIn("idle labels", label) ? all.substr(colon + 2) : all;
}

class Reader {
 public:
  Reader(const ConstraintText& text, Conversion& conversion)
      : text_(text), conversion_(conversion), lines_(ReadOutline(text.text)), context_(lines_.size()) {}

  std::vector<RecordedSentence> Read() {
    for (size_t i = 0; i < lines_.size(); ++i) {
      const OutlineLine& line = lines_[i];
      if (line.parent >= 0) context_[i] = context_[static_cast<size_t>(line.parent)];
      siblings_.erase(siblings_.upper_bound(line.depth), siblings_.end());
      if (const auto title = siblings_.find(line.depth); title != siblings_.end()) context_[i] = title->second;
      if (IsTitleOfSiblings(line)) {
        OpenTitle(i, context_[i]);
        siblings_[line.depth] = context_[i];
      } else if (IsTitle(line)) {
        OpenTitle(i, context_[i]);
      } else if (IsFrame(line)) {
        continue;
      } else {
        AddLine(line, context_[i]);
      }
    }
    return std::move(sentences_);
  }

 private:
  // What holds for the lines under one.
  struct Context {
    std::vector<int> objects;
    std::string zone_id;
    // The beginning of an unfinished sentence: "Avoid placement near:".
    std::string beginning;
  };

  bool IsTitle(const OutlineLine& line) const {
    if (line.kind == LineKind::kHeading) return true;
    const std::string all = line.All();
    if (line.title) return line.has_children || !Demands(all);
    // "1. Shower caddy (0.3m x 0.3m)" with a list under it.
    return line.has_children && !Demands(all) &&
           (!text_.objects.Find(all).empty() || !FindZone(all, text_.zone_ids).empty());
  }

  // "- Plant stand: 0.4m x 0.4m" with its list at the same indent.
  bool IsTitleOfSiblings(const OutlineLine& line) const {
    if (line.has_children || line.kind != LineKind::kItem) return false;
    const std::string all = line.All();
    const std::vector<Mention> mentions = text_.objects.Find(all);
    constexpr size_t kCount = 4;  // "The ", "4 "
    return !mentions.empty() && mentions.front().begin <= kCount && HasSize(all) &&
           IsSize(std::string_view(all).substr(mentions.front().end));
  }

  // "Certainly! Here are ..." and "These constraints ensure ...": neither in a list nor about an object.
  bool IsFrame(const OutlineLine& line) const {
    if (line.kind != LineKind::kText || line.depth >= 10) return false;
    return !Demands(line.All()) || text_.objects.Find(line.All()).empty();
  }

  void OpenTitle(size_t index, Context& context) {
    const OutlineLine& line = lines_[index];
    const std::string all = line.All();
    if (line.label.empty() && line.kind == LineKind::kItem && Demands(all)) {
      if (HasOnlyShortChildren(index)) {
        context.beginning = all;
      } else {
        AddLine(line, context);
      }
      return;
    }
    if (const std::string zone = FindZone(all, text_.zone_ids); !zone.empty()) context.zone_id = zone;
    if (text_.kind == ConstraintTextKind::kIntra) {
      OpenObject(line, all, context);
    } else if (const auto mentions = text_.objects.Find(all, context.zone_id); !mentions.empty()) {
      context.objects.clear();
      AddObjects(mentions, context.objects);
    }
  }

  // The heading of one object, or of what is said about it ("Accessibility:").
  void OpenObject(const OutlineLine& line, const std::string& all, Context& context) const {
    std::vector<Mention> mentions = text_.objects.Find(all, context.zone_id);
    if (line.kind == LineKind::kItem && !context.objects.empty()) {
      // "Distance from the bed:" is about the object above, "Floor lamp (0.4m x 0.4m)" about another one.
      constexpr size_t kThe = 4;
      if (mentions.empty() || mentions.front().begin > kThe) return;
    } else if (mentions.empty()) {
      mentions = text_.objects.FindLoosely(all, context.zone_id);
    }
    if (!mentions.empty()) context.objects = AfterColon(all, mentions).objects;
  }

  bool HasOnlyShortChildren(size_t index) const {
    constexpr size_t kShort = 4;
    for (size_t i = index + 1; i < lines_.size() && lines_[i].depth > lines_[index].depth; ++i) {
      if (ReadWords(lines_[i].All()).size() > kShort) return false;
    }
    return true;
  }

  // "Workstation: Alchemy Table" names a zone first, whose name may be an object's too: the first mention behind the
  // heading's first colon, the first of all when there is none behind it.
  static const Mention& AfterColon(const std::string& all, const std::vector<Mention>& mentions) {
    const size_t colon = all.find(':');
    for (const Mention& mention : mentions) {
      if (colon != std::string::npos && mention.begin > colon) return mention;
    }
    return mentions.front();
  }

  static void AddObjects(const std::vector<Mention>& mentions, std::vector<int>& objects) {
    for (const Mention& mention : mentions) {
      for (const int object : mention.objects) {
        if (std::find(objects.begin(), objects.end(), object) == objects.end()) objects.push_back(object);
      }
    }
  }

  void AddLine(const OutlineLine& line, const Context& context) {
    std::string all = WithoutEmptyLabel(line);
    if (!context.beginning.empty()) all = context.beginning + " " + all;
    std::vector<int> objects = context.objects;
    if (objects.empty()) AddObjects(MentionsOf(all, context), objects);
    if (objects.empty()) {
      conversion_.Keep(text_.name, line.number, line.All(), "names none of the objects");
      return;
    }
    conversion_.Convert();
    for (const std::string& sentence : SplitSentences(all)) {
      std::vector<int> own = context.objects;
      if (own.empty()) {
        // "The bookshelf ... It should be away from the sofa."
        const std::vector<Word> words = ReadWords(sentence);
        const bool pronoun = !words.empty() && english::Language::Get().IsIn("sentence pronouns", words.front().key);
        if (pronoun && !sentences_.empty()) own = {objects.front()};
        AddObjects(MentionsOf(sentence, context), own);
      }
      sentences_.push_back({own.empty() ? objects : own, sentence, SaysMust(sentence)});
    }
  }

  std::vector<Mention> MentionsOf(const std::string& text, const Context& context) const {
    std::vector<Mention> mentions = text_.objects.FindLoosely(text, context.zone_id);
    // Of several, an intra constraint is about the first.
    if (text_.kind == ConstraintTextKind::kIntra && mentions.size() > 1) mentions.resize(1);
    return mentions;
  }

  const ConstraintText& text_;
  Conversion& conversion_;
  const std::vector<OutlineLine> lines_;
  std::vector<Context> context_;
  // By depth: what the last title without children said.
  std::map<int, Context> siblings_;
  std::vector<RecordedSentence> sentences_;
};

using model::v1::ChangeAnswer;
using model::v1::CleaningAnswer;

// Less than that of the shorter sentence's words in common: another sentence.
constexpr double kSame = 0.6, kSaidElsewhere = 0.75;
// The same words in the same order.
constexpr double kIdentical = 2;
constexpr size_t kMostParts = 8;

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
    for (const double least : {kIdentical, kSame}) {
      for (size_t c = 0; c < after_.size(); ++c) Give(c, least, 1);
    }
    // What is left says a part of what another one says too.
    for (size_t c = 0; c < after_.size(); ++c) Give(c, kSame, kMostParts);
    return Changes();
  }

 private:
  double Score(size_t r, size_t c) const {
    const auto common = [&](const std::string& key) { return before_keys_[r].contains(key); };
    if (!std::any_of(after_keys_[c].begin(), after_keys_[c].end(), common)) return 0;
    if (SameWords(before_[r].text, after_[c].text)) return kIdentical;
    return Likeness(before_[r].text, after_[c].text);
  }

  // Gives the cleaned sentence, if nobody has it, to the best sentence that has fewer than `most`.
  void Give(size_t c, double least, size_t most) {
    if (taken_[c]) return;
    size_t best = before_.size();
    double best_score = 0;
    for (size_t r = 0; r < before_.size(); ++r) {
      const double score = parts_[r].size() < most ? Score(r, c) : 0;
      if (score < least || score <= best_score) continue;
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

std::vector<RecordedSentence> ReadConstraintText(const ConstraintText& text, Conversion& conversion) {
  return Reader(text, conversion).Read();
}

CleaningAnswer FindChanges(const std::vector<PromptSentence>& before, const std::vector<RecordedSentence>& after,
                           const std::vector<std::string>& names) {
  return CleaningMatcher(before, after, names).Match();
}

}  // namespace flair::language
