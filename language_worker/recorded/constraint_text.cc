// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/recorded/constraint_text.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "language_worker/recorded/outline.h"
#include "language_worker/recorded/sentences.h"

namespace flair::language {
namespace {

using KeySet = std::set<std::string, std::less<>>;

bool HasWordOf(const std::vector<Word>& words, const KeySet& set) {
  return std::any_of(words.begin(), words.end(), [&](const Word& word) { return set.contains(word.key); });
}

// Words that a constraint has and a heading has not.
bool Demands(std::string_view text) {
  static const KeySet kWords = {"should", "must", "need", "avoid", "ensure", "cannot", "can", "keep", "maintain"};
  return HasWordOf(ReadWords(text), kWords);
}

bool SaysMust(std::string_view text) {
  static const KeySet kWords = {"must", "cannot", "need", "require", "required"};
  return HasWordOf(ReadWords(text), kWords);
}

// "Constraint: Back side should be against a wall." without the first word, which says nothing.
std::string WithoutEmptyLabel(const OutlineLine& line) {
  static const KeySet kEmpty = {"constraint", "consideration", "note",
                                "placement",  "requirement",   "placement consideration"};
  const std::string all = line.All();
  const size_t colon = all.find(": ");
  if (colon == std::string::npos || colon > 30) return all;
  std::string label;
  for (const Word& word : ReadWords(std::string_view(all).substr(0, colon))) {
    label += (label.empty() ? "" : " ") + word.key;
  }
  return kEmpty.contains(label) ? all.substr(colon + 2) : all;
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
        static const KeySet kPronouns = {"it", "its", "they", "their", "thi", "each", "both"};
        if (!words.empty() && kPronouns.contains(words.front().key) && !sentences_.empty()) own = {objects.front()};
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

}  // namespace

std::vector<RecordedSentence> ReadConstraintText(const ConstraintText& text, Conversion& conversion) {
  return Reader(text, conversion).Read();
}

}  // namespace flair::language
