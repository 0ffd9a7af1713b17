// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "english/language.h"
#include "language_worker/recorded/constraint_text.h"
#include "language_worker/recorded/object_names.h"
#include "language_worker/recorded/outline.h"
#include "llm/answers/utf8.h"

namespace flair::language {
namespace {

constexpr size_t kLongestPlacement = 300;

// Whether a text says where something is.
bool SaysWhere(std::string_view text) { return HasWordOf("where words", text); }

bool IsLabel(const char* list, std::string_view label) { return english::Language::Get().IsIn(list, label); }

// An item of the list: what it is called, and all that is said of it.
struct Item {
  int line = 0;
  std::string name;
  std::string place;
  // The heading that it stands under: "On the Cutting Table".
  std::string heading;
  bool used = false;
};

// The sentences of a text that are not sizes, joined.
std::string WithoutSizes(std::string_view text) {
  std::string rest;
  for (std::string& sentence : SplitSentences(text)) {
    // "0.2m x 0.2m - Placed on the desk"
    for (const std::string_view gap : {" - ", " – ", ", ", ": ", ") "}) {
      const size_t at = sentence.find(gap);
      if (at != std::string::npos && IsSize(std::string_view(sentence).substr(0, at))) {
        sentence = sentence.substr(at + gap.size());
      }
    }
    if (!IsSize(sentence)) rest += (rest.empty() ? "" : " ") + sentence;
  }
  return rest;
}

// "Placement: On the desk" without its first word.
std::string WithoutLabel(const OutlineLine& line) {
  if (!line.label.empty() && HasWordOf("place labels", line.label)) return line.text;
  const std::string all = line.All();
  const size_t colon = all.find(": ");
  if (colon != std::string::npos && colon < 20 && HasWordOf("place labels", std::string_view(all).substr(0, colon))) {
    return all.substr(colon + 2);
  }
  return line.text.empty() ? line.label : line.text;
}

// The first word of what a line begins with, when that is a label.
std::string LabelKey(const OutlineLine& line) {
  std::string label = line.label;
  if (label.empty()) {
    const size_t colon = line.text.find(':');
    if (colon != std::string::npos && colon < 40) label = line.text.substr(0, colon);
  }
  const std::vector<Word> words = ReadWords(label);
  return words.empty() ? "" : words.front().key;
}

// "Placement:", "Dimensions (width x length):" and the like are about the item above.
bool IsProperty(const OutlineLine& line) { return IsLabel("property labels", LabelKey(line)); }

// Of them, those that do not say where.
bool IsOtherProperty(const OutlineLine& line) { return IsProperty(line) && !IsLabel("where labels", LabelKey(line)); }

class PlacementMatcher {
 public:
  PlacementMatcher(std::string_view text, const std::vector<const v1::Object*>& tertiaries, const ObjectNames& floor)
      : lines_(ReadOutline(text)), tertiaries_(tertiaries), floor_(floor) {}

  std::vector<RecordedPlacement> Match(Conversion& conversion) {
    CollectItems();
    std::vector<RecordedPlacement> placements(tertiaries_.size());
    std::vector<Item*> found(tertiaries_.size(), nullptr);
    // Certain ones first, so that "lamp" does not take the "floor lamp" of another.
    for (const double least : {0.99, 0.6, 0.3}) {
      for (size_t i = 0; i < tertiaries_.size(); ++i) {
        if (found[i] == nullptr) found[i] = Best(*tertiaries_[i], i, found, least);
        if (found[i] != nullptr) found[i]->used = true;
      }
    }
    for (size_t i = 0; i < tertiaries_.size(); ++i) {
      if (found[i] != nullptr) placements[i] = PlacementOf(*found[i]);
    }
    for (const Item& item : items_) {
      if (item.used) {
        conversion.Convert();
      } else {
        conversion.Keep("tertiary", item.line, item.name + ": " + item.place, "belongs to none of the objects");
      }
    }
    return placements;
  }

 private:
  // A line begins an item when it has a size, a place or properties, and what stands under it is about it alone.
  void CollectItems() {
    for (size_t i = 0; i < lines_.size(); ++i) {
      const OutlineLine& line = lines_[i];
      if (HasWordOf("summaries", line.All())) break;  // says all again
      if (IsProperty(line) || (line.kind == LineKind::kText && line.label.empty())) continue;
      Item item{line.number, line.label.empty() ? line.text : line.label, "", HeadingOf(line)};
      if (!line.label.empty()) item.place = WithoutSizes(line.text);
      bool described = HasSize(line.All());
      if (!ReadBelow(i, item, described)) continue;
      if (const size_t colon = line.text.find(": "); line.label.empty() && item.place.empty()) {
        // "Clock: 0.2m x 0.2m. On the desk."
        item.name = line.text.substr(0, colon);
        if (colon != std::string::npos) item.place = WithoutSizes(line.text.substr(colon + 2));
      }
      const bool heading = line.kind == LineKind::kHeading && item.place.empty();
      if (heading || (!described && item.place.empty() && !SaysWhere(item.name))) continue;
      items_.push_back(std::move(item));
      while (i + 1 < lines_.size() && lines_[i + 1].depth > line.depth) ++i;
    }
  }

  // Adds what stands under the line to its item; false when those are items themselves.
  bool ReadBelow(size_t index, Item& item, bool& described) const {
    for (size_t k = index + 1; k < lines_.size() && lines_[k].depth > lines_[index].depth; ++k) {
      const OutlineLine& below = lines_[k];
      const bool own_size = HasSize(below.text) && !IsSize(below.text);
      if (!IsProperty(below) && (!below.label.empty() || below.has_children || own_size)) return false;
      described = described || IsProperty(below);
      if (const std::string key = LabelKey(below); key == "object" || key == "item") item.name = below.text;
      if (IsOtherProperty(below)) continue;
      const std::string more = WithoutSizes(WithoutLabel(below));
      if (!more.empty() && (IsProperty(below) || SaysWhere(more))) item.place += (item.place.empty() ? "" : " ") + more;
    }
    return true;
  }

  std::string HeadingOf(const OutlineLine& line) const {
    return line.parent < 0 ? "" : lines_[static_cast<size_t>(line.parent)].All();
  }

  static double Score(const v1::Object& tertiary, const Item& item) {
    const double in_name = Likeness(tertiary.name(), item.name);
    if (in_name > 0) return in_name;
    // "tablelamp"
    const std::string key = NameKey(tertiary.name());
    if (!key.empty() && NameKey(item.name).find(key) != std::string::npos) return 0.99;
    for (const Word& word : ReadWords(item.name)) {
      if (word.key.size() > 3 && key.find(word.key) != std::string::npos) return 0.5;
    }
    // "Wall Art: A small painting of a forest."
    return Likeness(tertiary.name(), item.name + " " + item.place) == 1 ? 0.4 : 0;
  }

  Item* Best(const v1::Object& tertiary, size_t index, const std::vector<Item*>& found, double least) {
    Item* best = nullptr;
    double best_score = 0;
    for (Item& item : items_) {
      if (item.used) continue;
      const double score = Score(tertiary, item);
      if (score >= least && score > best_score) {
        best = &item;
        best_score = score;
      }
    }
    if (best != nullptr) return best;
    // One item may list several of a kind: "Cushions (x5)".
    for (size_t i = 0; i < index; ++i) {
      if (found[i] != nullptr && tertiaries_[i]->name() == tertiary.name()) best = found[i];
    }
    return best;
  }

  RecordedPlacement PlacementOf(const Item& item) const {
    RecordedPlacement placement;
    placement.line = item.line;
    placement.text = !item.place.empty() ? item.place : item.name;
    if (!SaysWhere(placement.text) && SaysWhere(item.heading)) placement.text = item.heading + ". " + placement.text;
    if (!SaysWhere(placement.text)) placement.text.clear();  // a name and a size alone
    placement.text = llm::CutBytes(placement.text, kLongestPlacement);
    for (const std::string* text :
         std::initializer_list<const std::string*>{&placement.text, &item.name, &item.heading}) {
      const std::vector<Mention> mentions = floor_.FindLoosely(*text);
      if (mentions.empty()) continue;
      placement.hosts = mentions.front().objects;
      break;
    }
    return placement;
  }

  const std::vector<OutlineLine> lines_;
  const std::vector<const v1::Object*>& tertiaries_;
  const ObjectNames& floor_;
  std::vector<Item> items_;
};

}  // namespace

std::vector<RecordedPlacement> ReadTertiaryText(std::string_view text, const std::vector<const v1::Object*>& tertiaries,
                                                const ObjectNames& floor_objects, Conversion& conversion) {
  return PlacementMatcher(text, tertiaries, floor_objects).Match(conversion);
}

}  // namespace flair::language
