// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/recorded/recorded_text.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "absl/strings/ascii.h"
#include "english/language.h"
#include "llm/answers/read_answer.h"

namespace flair::language {
namespace {

constexpr size_t kMostLines = 2000, kLongestLine = 2000, kLongestPlacement = 300;
// Depths: headings 1 to 6, titles, plain text, then items by their indent.
constexpr int kTitleDepth = 7, kTextDepth = 8, kItemDepth = 12;

// One line of Markdown that says something, without its marks.
struct Line {
  int number = 0;  // from 1
  int depth = 0;
  // Index of the nearest line before it with a smaller depth; -1 for none.
  int parent = -1;
  bool has_children = false;
  // It names what stands under it: a heading, a line all in bold, or one that ends in a colon.
  bool title = false;
  std::string text;
};

std::string Strip(std::string_view text) {
  std::string stripped;
  for (const char c : text) {
    if (c != '*' && c != '`') stripped += c;
  }
  absl::StripAsciiWhitespace(&stripped);
  return stripped;
}

// "- ", "• ", "3. ", "b) ": the number of bytes; 0 when the line does not begin so. "3.2 m" is no item.
size_t ItemMark(std::string_view line, bool& numbered) {
  constexpr std::string_view kDot = "•";
  numbered = false;
  if (line.starts_with(kDot)) return kDot.size();
  const size_t digits = std::min(line.find_first_not_of("0123456789"), line.size());
  if (digits == 0 && line.size() > 1) {
    return std::string_view("-*+").find(line[0]) != std::string_view::npos && absl::ascii_isspace(line[1]) ? 1 : 0;
  }
  numbered = digits > 0 && digits < 4 && digits + 1 < line.size() && (line[digits] == '.' || line[digits] == ')') &&
             (line[digits + 1] == ' ' || line[digits + 1] == '*');
  return numbered ? digits + 1 : 0;
}

Line ReadLine(std::string_view raw) {
  Line line;
  const size_t indent = std::min(raw.find_first_not_of(" \t\r"), raw.size());
  std::string_view rest = raw.substr(indent);
  const size_t hashes = std::min(rest.find_first_not_of('#'), rest.size());
  const bool heading = hashes > 0 && hashes < 7;
  if (heading) rest = rest.substr(std::min(rest.find_first_not_of(" \t", hashes), rest.size()));
  bool numbered = false;
  const size_t mark = ItemMark(rest, numbered);
  rest = rest.substr(std::min(rest.find_first_not_of(" \t", mark), rest.size()));
  line.text = Strip(rest);
  const size_t bold_end = rest.starts_with("**") ? rest.find("**", 2) : std::string_view::npos;
  const bool bold = bold_end != std::string_view::npos &&
                    rest.find_first_not_of("*: \t\r", bold_end) == std::string_view::npos && !line.text.ends_with('.');
  line.title = heading || bold || line.text.ends_with(':');
  while (line.text.ends_with(':')) line.text = Strip(line.text.substr(0, line.text.size() - 1));
  if (heading) {
    line.depth = static_cast<int>(hashes);
  } else if (mark > 0 || indent >= 2) {
    // Text that is indented goes on with what is above it.
    line.depth = kItemDepth + 4 * static_cast<int>(std::min<size_t>(indent, 40)) + (numbered ? 0 : mark > 0 ? 2 : 3);
  } else {
    line.depth = line.title ? kTitleDepth : kTextDepth;
  }
  return line;
}

// Reads any bytes; long lines are cut, lines after the first 2,000 left out. What `is_title` says of goes above the
// items at its indent.
std::vector<Line> ReadOutline(std::string_view text,
                              const std::function<bool(const std::string& text)>& is_title = nullptr) {
  std::vector<Line> lines;
  std::vector<int> open;  // the lines that the next one may stand under
  for (int number = 1; !text.empty() && lines.size() < kMostLines; ++number) {
    const size_t end = std::min(text.find('\n'), text.size());
    Line line = ReadLine(llm::CutBytes(llm::ToUtf8(text.substr(0, std::min(end, 2 * kLongestLine))), kLongestLine));
    text.remove_prefix(std::min(end + 1, text.size()));
    // "---", "```" and the like say nothing.
    if (ReadWords(line.text).empty()) continue;
    line.number = number;
    if (line.depth >= kItemDepth && is_title != nullptr && is_title(line.text)) --line.depth;
    while (!open.empty() && lines[static_cast<size_t>(open.back())].depth >= line.depth) open.pop_back();
    if (!open.empty()) {
      line.parent = open.back();
      lines[static_cast<size_t>(open.back())].has_children = true;
    }
    open.push_back(static_cast<int>(lines.size()));
    lines.push_back(std::move(line));
  }
  return lines;
}

// The first words of a line up to a colon; empty without one.
std::string LabelOf(std::string_view text) {
  const size_t colon = text.find(": ");
  return colon == std::string_view::npos || colon > 40 ? "" : std::string(text.substr(0, colon));
}

bool IsIn(const char* list, std::string_view text) { return english::Language::Get().IsIn(list, text); }

// The first word of a text, as its key.
std::string FirstWord(std::string_view text) {
  const std::vector<Word> words = ReadWords(text);
  return words.empty() ? "" : words.front().key;
}

// ---- Constraints

// Words that a constraint has and a heading has not.
bool Demands(std::string_view text) { return HasWordOf("demands", text); }

class ConstraintReader {
 public:
  ConstraintReader(const ConstraintText& text, Conversion& conversion) : text_(text), conversion_(conversion) {}

  std::vector<RecordedSentence> Read() {
    const std::vector<Line> lines =
        ReadOutline(text_.text, [this](const std::string& line) { return IsNameWithSize(line); });
    std::vector<Context> contexts(lines.size());
    for (size_t i = 0; i < lines.size(); ++i) {
      const Line& line = lines[i];
      if (line.parent >= 0) contexts[i] = contexts[static_cast<size_t>(line.parent)];
      if (IsTitle(line)) {
        OpenTitle(line, contexts[i]);
      } else if (line.title && line.has_children) {
        contexts[i].beginning = line.text + " ";
      } else if (line.depth >= kItemDepth || (Demands(line.text) && !text_.objects.Find(line.text).empty())) {
        AddLine(line, contexts[i]);
      }  // else it frames a list: "Certainly! Here are ..."
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

  // "Plant stand: 0.4m x 0.4m", whose list may stand at the same indent.
  bool IsNameWithSize(const std::string& line) const {
    const std::vector<Mention> mentions = text_.objects.Find(line);
    return IsAtBegin(mentions) && HasSize(line) && IsSize(std::string_view(line).substr(mentions.front().end));
  }

  // After at most "The " or "4 ".
  static bool IsAtBegin(const std::vector<Mention>& mentions) {
    return !mentions.empty() && mentions.front().begin <= 4;
  }

  bool IsTitle(const Line& line) const {
    if (line.depth < kTitleDepth) return true;
    if (Demands(line.text)) return false;
    return line.title || (line.has_children &&
                          (!text_.objects.Find(line.text).empty() || !FindZone(line.text, text_.zone_ids).empty()));
  }

  void OpenTitle(const Line& line, Context& context) const {
    if (std::string zone = FindZone(line.text, text_.zone_ids); !zone.empty()) context.zone_id = std::move(zone);
    std::vector<Mention> mentions = text_.objects.Find(line.text, context.zone_id);
    if (text_.kind == ConstraintTextKind::kInter) {
      if (!mentions.empty()) context.objects.clear();
      return AddObjects(mentions, context.objects);
    }
    // "Distance from the bed:" is about the object above, "Floor lamp (0.4m x 0.4m)" about another one.
    if (line.depth >= kItemDepth && !context.objects.empty() && !IsAtBegin(mentions)) return;
    if (mentions.empty()) mentions = text_.objects.FindLoosely(line.text, context.zone_id);
    if (mentions.empty()) return;
    // "Workstation: Alchemy Table" names a zone first, whose name may be an object's too.
    const auto behind = std::ranges::find_if(
        mentions, [colon = line.text.find(':')](const Mention& mention) { return mention.begin > colon; });
    context.objects = behind == mentions.end() ? mentions.front().objects : behind->objects;
  }

  static void AddObjects(const std::vector<Mention>& mentions, std::vector<int>& objects) {
    for (const Mention& mention : mentions) {
      for (const int object : mention.objects) {
        if (std::ranges::find(objects, object) == objects.end()) objects.push_back(object);
      }
    }
  }

  void AddLine(const Line& line, const Context& context) {
    const std::string label = LabelOf(line.text);
    const bool idle = !label.empty() && IsIn("idle labels", FirstWord(label));
    const std::string all = context.beginning + (idle ? line.text.substr(label.size() + 2) : line.text);
    std::vector<int> objects = context.objects;
    if (objects.empty()) AddObjects(MentionsOf(all, context), objects);
    if (objects.empty()) return conversion_.Keep(text_.name, line.number, line.text, "names none of the objects");
    conversion_.Convert();
    for (const std::string& sentence : SplitSentences(all)) {
      std::vector<int> own = context.objects;
      // "The bookshelf ... It should be away from the sofa."
      if (own.empty() && IsIn("sentence pronouns", FirstWord(sentence))) own = {objects.front()};
      if (context.objects.empty()) AddObjects(MentionsOf(sentence, context), own);
      sentences_.push_back({own.empty() ? objects : own, sentence, HasWordOf("musts", sentence)});
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
  std::vector<RecordedSentence> sentences_;
};

// ---- Places of tertiaries

bool SaysWhere(std::string_view text) { return HasWordOf("where words", text); }

// An item of the list: what it is called, what is said of its place, the heading that it stands under.
struct Item {
  int line = 0;
  std::string name;
  std::string place;
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

// "Placement:", "Dimensions (width x length):" and the like are about the item above.
bool IsProperty(const Line& line) {
  return IsIn("property labels", FirstWord(line.title ? line.text : LabelOf(line.text)));
}

// Adds what stands under an item to it; false when those are items themselves.
bool ReadBelow(const std::vector<Line>& lines, size_t index, Item& item, bool& described) {
  for (size_t k = index + 1; k < lines.size() && lines[k].depth > lines[index].depth; ++k) {
    const std::string label = LabelOf(lines[k].text);
    const bool property = IsProperty(lines[k]);
    if (!property && (!label.empty() || lines[k].has_children || HasSize(lines[k].text))) return false;
    described = described || property;
    if (property && !IsIn("where labels", FirstWord(label))) continue;
    const std::string more = WithoutSizes(property && !label.empty() ? lines[k].text.substr(label.size() + 2)
                                          : property                 ? ""
                                                                     : lines[k].text);
    if (!more.empty() && (property || SaysWhere(more))) item.place += (item.place.empty() ? "" : " ") + more;
  }
  return true;
}

// A line begins an item when it has a size, a place or properties, and what stands under it is about it alone.
std::vector<Item> ReadItems(std::string_view text) {
  const std::vector<Line> lines = ReadOutline(text);
  std::vector<Item> items;
  for (size_t i = 0; i < lines.size(); ++i) {
    const Line& line = lines[i];
    if (HasWordOf("summaries", line.text)) break;  // says all again
    if (IsProperty(line) || line.depth == kTextDepth) continue;
    const std::string label = LabelOf(line.text);
    Item item{line.number, label.empty() ? line.text : label,
              label.empty() ? "" : WithoutSizes(line.text.substr(label.size() + 2)),
              line.parent < 0 ? "" : lines[static_cast<size_t>(line.parent)].text};
    bool described = HasSize(line.text) && line.depth >= kItemDepth;
    if (!ReadBelow(lines, i, item, described)) continue;
    if (!described && item.place.empty() && (line.depth < kItemDepth || !SaysWhere(item.name))) continue;
    items.push_back(std::move(item));
    while (i + 1 < lines.size() && lines[i + 1].depth > line.depth) ++i;
  }
  return items;
}

double ScoreOf(const v1::Object& tertiary, const Item& item) {
  const double in_name = Likeness(tertiary.name(), item.name);
  if (in_name > 0) return in_name;
  // "tablelamp"
  const std::string key = NameKey(tertiary.name());
  if (!key.empty() && NameKey(item.name).find(key) != std::string::npos) return 0.99;
  // "Wall Art: A small painting of a forest."
  return Likeness(tertiary.name(), item.name + " " + item.place) == 1 ? 0.4 : 0;
}

// The best unused item of at least that score; null when there is none.
Item* BestItem(const v1::Object& tertiary, double least, std::vector<Item>& items) {
  Item* best = nullptr;
  for (Item& item : items) {
    const double score = item.used ? 0 : ScoreOf(tertiary, item);
    if (score >= least && (best == nullptr || score > ScoreOf(tertiary, *best))) best = &item;
  }
  return best;
}

RecordedPlacement PlacementOf(const Item& item, const ObjectNames& floor) {
  RecordedPlacement placement{!item.place.empty() ? item.place : item.name, {}, item.line};
  if (!SaysWhere(placement.text) && SaysWhere(item.heading)) placement.text = item.heading + ". " + placement.text;
  if (!SaysWhere(placement.text)) placement.text.clear();  // a name and a size alone
  placement.text = llm::CutBytes(placement.text, kLongestPlacement);
  for (const std::string& text : {placement.text, item.name, item.heading}) {
    const std::vector<Mention> mentions = floor.FindLoosely(text);
    if (mentions.empty()) continue;
    placement.hosts = mentions.front().objects;
    break;
  }
  return placement;
}

}  // namespace

std::vector<RecordedSentence> ReadConstraintText(const ConstraintText& text, Conversion& conversion) {
  return ConstraintReader(text, conversion).Read();
}

std::vector<RecordedPlacement> ReadTertiaryText(std::string_view text, const std::vector<const v1::Object*>& tertiaries,
                                                const ObjectNames& floor_objects, Conversion& conversion) {
  std::vector<Item> items = ReadItems(text);
  std::vector<Item*> found(tertiaries.size(), nullptr);
  // Certain ones first, so that "lamp" does not take the "floor lamp" of another.
  for (const double least : {0.99, 0.6, 0.3}) {
    for (size_t i = 0; i < tertiaries.size(); ++i) {
      if (found[i] == nullptr) found[i] = BestItem(*tertiaries[i], least, items);
      // One item may list several of a kind: "Cushions (x5)".
      for (size_t k = 0; k < i && found[i] == nullptr; ++k) {
        if (tertiaries[k]->name() == tertiaries[i]->name()) found[i] = found[k];
      }
      if (found[i] != nullptr) found[i]->used = true;
    }
  }
  std::vector<RecordedPlacement> placements(tertiaries.size());
  for (size_t i = 0; i < tertiaries.size(); ++i) {
    if (found[i] != nullptr) placements[i] = PlacementOf(*found[i], floor_objects);
  }
  for (const Item& item : items) {
    if (item.used) {
      conversion.Convert();
    } else {
      conversion.Keep("tertiary", item.line, item.name + ": " + item.place, "belongs to none of the objects");
    }
  }
  return placements;
}

}  // namespace flair::language
