// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/recorded/style_text.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "language_worker/recorded/outline.h"
#include "language_worker/recorded/sentences.h"
#include "llm/answers/utf8.h"

namespace flair::language {
namespace {

using KeySet = std::set<std::string, std::less<>>;

constexpr size_t kLongestMaterial = 90, kLongestSummary = 390;
constexpr size_t kDescriptionWords = 12;

// Materials that say their colour.
const std::map<std::string, std::string, std::less<>> kMaterialColours = {
    {"oak", "#B98B55"},      {"light oak", "#C9A772"},   {"dark oak", "#6F4E2F"},    {"oakwood", "#B98B55"},
    {"walnut", "#5F4330"},   {"dark walnut", "#45301F"}, {"mahogany", "#5B2C20"},    {"cherry", "#7B3F2B"},
    {"pine", "#D2AC74"},     {"teak", "#9A6B3F"},        {"maple", "#D3AE7C"},       {"birch", "#DCC39C"},
    {"ebony", "#2E2622"},    {"bamboo", "#CBAE74"},      {"rattan", "#BE9A66"},      {"wicker", "#B08E5E"},
    {"wood", "#A47B4F"},     {"wooden", "#A47B4F"},      {"light wood", "#C8A678"},  {"dark wood", "#5A3D28"},
    {"hardwood", "#A1744A"}, {"brass", "#B08D4B"},       {"bronze", "#8C6A3F"},      {"copper", "#B26B43"},
    {"chrome", "#C5C9CC"},   {"nickel", "#B4B2AC"},      {"silver", "#C0C0C0"},      {"gold", "#C8A24A"},
    {"steel", "#9DA3A8"},    {"iron", "#3F4042"},        {"metal", "#8E9296"},       {"glass", "#D6E4E6"},
    {"crystal", "#E4ECEE"},  {"mirror", "#D2DADD"},      {"marble", "#E9E6E1"},      {"stone", "#A6A29A"},
    {"concrete", "#A3A3A0"}, {"porcelain", "#F4F3EF"},   {"terracotta", "#C0653F"},  {"leather", "#7A5236"},
    {"linen", "#E3DAC9"},    {"jute", "#C2A878"},        {"multicolour", "#9A8F86"}, {"multicolored", "#9A8F86"}};

enum class Property { kNone, kColour, kMaterial, kStyle, kOther };

Property PropertyOf(std::string_view label) {
  static const KeySet kColours = {"colour", "color", "tone"};
  static const KeySet kMaterials = {"material", "finish", "type", "fabric", "upholstery", "covering"};
  static const KeySet kStyles = {"style", "description", "design", "look"};
  static const KeySet kOthers = {"reasoning", "reason", "purpose", "placement", "note", "dimension", "accent"};
  const std::vector<Word> words = ReadWords(label);
  if (words.empty() || words.size() > 4) return Property::kNone;
  const auto has = [&](const KeySet& set) {
    return std::any_of(words.begin(), words.end(), [&](const Word& word) { return set.contains(word.key); });
  };
  if (has(kColours)) return Property::kColour;
  if (has(kMaterials)) return Property::kMaterial;
  if (has(kStyles)) return Property::kStyle;
  return has(kOthers) ? Property::kOther : Property::kNone;
}

std::string SurfaceOf(std::string_view title) {
  const std::vector<Word> words = ReadWords(title);
  if (words.empty() || words.size() > 5) return "";
  for (const Word& word : words) {
    if (word.key == "wall") return "walls";
    if (word.key == "floor" || word.key == "flooring") return "floor";
    if (word.key == "ceiling" || word.key == "window" || word.key == "door") return word.key;
  }
  return "";
}

std::string FirstSentence(std::string_view text) {
  const std::vector<std::string> sentences = SplitSentences(text);
  return sentences.empty() ? "" : sentences.front();
}

// The text up to its first sentence's end, and at most so many words.
std::string FirstWords(std::string_view text, size_t count) {
  const std::string sentence = FirstSentence(text);
  const std::vector<Word> words = ReadWords(sentence);
  return words.size() <= count ? sentence : sentence.substr(0, words[count - 1].end);
}

// The material in a whole sentence, such as "Hardwood floors enhance the room."; empty when the text is no sentence, or
// names none.
std::string MaterialSaid(std::string_view text) {
  static const KeySet kVerbs = {"is",      "are",    "be",     "enhance", "create", "feature", "add",
                                "provide", "offer",  "give",   "bring",   "have",   "has",     "will",
                                "let",     "should", "prefer", "choose",  "use"};
  const std::vector<Word> words = ReadWords(text);
  if (std::none_of(words.begin(), words.end(), [](const Word& word) { return kVerbs.contains(word.key); })) return "";
  for (size_t i = 0; i < words.size(); ++i) {
    const std::string two = i + 1 < words.size() ? words[i].key + " " + words[i + 1].key : "";
    if (kMaterialColours.contains(two)) return two;
    if (kMaterialColours.contains(words[i].key)) return words[i].key;
    if (words[i].key == "paint" || words[i].key == "painted") return "paint";
    if (words[i].key == "wallpaper") return "wallpaper";
  }
  return "";
}

// "Dark oak wood." as a material: up to the first sign.
std::string AsMaterial(const std::string& text) {
  if (std::string said = MaterialSaid(FirstSentence(text)); !said.empty()) return said;
  std::string material = text.substr(0, text.find_first_of(".;("));
  while (!material.empty() && material.back() == ' ') material.pop_back();
  return llm::CutBytes(material, kLongestMaterial);
}

// What stands behind and under a title.
struct Properties {
  std::string colour;
  std::string material;
  std::string style;
  std::string rest;

  void Add(Property property, const std::string& text) {
    std::string& to = property == Property::kColour     ? colour
                      : property == Property::kMaterial ? material
                      : property == Property::kStyle    ? style
                                                        : rest;
    if (property != Property::kOther) to += (to.empty() ? "" : " ") + text;
  }
};

// "Colour: white" as label and text, also when it is not marked.
std::pair<std::string, std::string> SplitProperty(const OutlineLine& line) {
  if (!line.label.empty()) return {line.label, line.text};
  const size_t colon = line.text.find(':');
  if (colon == std::string::npos || colon > 30) return {"", line.text};
  const size_t begin = line.text.find_first_not_of(": ", colon);
  return {line.text.substr(0, colon), begin == std::string::npos ? "" : line.text.substr(begin)};
}

class Reader {
 public:
  Reader(std::string_view text, const ObjectNames& objects, const Handbook& handbook, Conversion& conversion)
      : lines_(ReadOutline(text)), objects_(objects), handbook_(handbook), conversion_(conversion) {}

  RecordedStyle Read() {
    RecordedStyle style;
    for (size_t i = 0; i < lines_.size(); ++i) {
      const OutlineLine& line = lines_[i];
      if (line.kind == LineKind::kText && line.label.empty() && !line.title) {
        if (style.summary.empty()) style.summary = SummaryOf(line.text);
        continue;
      }
      RecordedLook look;
      if (!FindSubject(line, look)) continue;
      if (!Fill(i, look)) continue;  // names what stands under it, as "Windows and Doors"
      if (look.colour.hex.empty()) {
        conversion_.Keep("style", line.number, line.All(), "names no colour that is known");
        continue;
      }
      conversion_.Convert();
      style.looks.push_back(std::move(look));
    }
    return style;
  }

 private:
  static std::string SummaryOf(const std::string& text) {
    for (const std::string& sentence : SplitSentences(text)) {
      constexpr size_t kLeast = 6;
      // Talk with who asked, not about the room.
      static const KeySet kTalk = {"sure", "certainly", "absolutely", "of", "let", "here", "given", "below"};
      const std::vector<Word> words = ReadWords(sentence);
      if (words.size() >= kLeast && !kTalk.contains(words.front().key)) return llm::CutBytes(sentence, kLongestSummary);
    }
    return "";
  }

  // What the line is the title of; false when of nothing, or of a property.
  bool FindSubject(const OutlineLine& line, RecordedLook& look) const {
    const std::string name = line.label.empty() ? SplitProperty(line).first : line.label;
    const std::string title = name.empty() && line.title ? line.text : name;
    if (title.empty()) return false;
    const std::vector<Mention> mentions = objects_.Find(title);
    if (!mentions.empty()) {
      look.objects = mentions.front().objects;
      return true;
    }
    if (PropertyOf(title) != Property::kNone) return false;
    look.surface = SurfaceOf(title);
    if (!look.surface.empty()) return true;
    const std::vector<Mention> loose = objects_.FindLoosely(title);
    if (loose.empty() || ReadWords(title).size() > 5) return false;
    look.objects = loose.front().objects;
    return true;
  }

  // False when nothing is said of it.
  bool Fill(size_t index, RecordedLook& look) const {
    const OutlineLine& line = lines_[index];
    Properties properties;
    if (const std::string text = SplitProperty(line).second; !line.title && !text.empty()) properties.rest = text;
    for (size_t k = index + 1; k < lines_.size(); ++k) {
      const OutlineLine& below = lines_[k];
      // Properties in bold without a list stand at the depth of a title.
      const bool follows = below.kind != LineKind::kHeading && line.kind == LineKind::kHeading;
      RecordedLook other;
      if ((below.depth <= line.depth && !follows && !IsProperty(below)) || FindSubject(below, other)) break;
      const auto [label, text] = SplitProperty(below);
      properties.Add(PropertyOf(label), text);
    }
    look.colour = FindColour(properties.colour, handbook_);
    for (const std::string* text : {&properties.material, &properties.style, &properties.rest}) {
      if (look.colour.hex.empty()) look.colour = FindColour(*text, handbook_);
    }
    const std::string& other = properties.rest.empty() ? properties.style : properties.rest;
    const std::string said = MaterialSaid(FirstSentence(other));
    look.material = !properties.material.empty() ? AsMaterial(properties.material)
                    : !said.empty()              ? said
                                                 : AsMaterial(FirstWords(other, 6));
    look.description = FirstWords(!properties.style.empty() ? properties.style : properties.rest, kDescriptionWords);
    return !(properties.colour + properties.material + properties.style + properties.rest).empty();
  }

  static bool IsProperty(const OutlineLine& line) { return PropertyOf(SplitProperty(line).first) != Property::kNone; }

  const std::vector<OutlineLine> lines_;
  const ObjectNames& objects_;
  const Handbook& handbook_;
  Conversion& conversion_;
};

}  // namespace

RecordedColour FindColour(std::string_view text, const Handbook& handbook) {
  const std::vector<Word> words = ReadWords(text);
  constexpr size_t kLongestColour = 3;
  const auto find = [&](const auto& known) {
    for (size_t i = 0; i < words.size(); ++i) {
      for (size_t count = std::min(kLongestColour, words.size() - i); count > 0; --count) {
        std::string name;
        for (size_t k = i; k < i + count; ++k) name += (name.empty() ? "" : " ") + words[k].key;
        if (RecordedColour colour = known(name); !colour.hex.empty()) return colour;
      }
    }
    return RecordedColour();
  };
  RecordedColour colour = find([&](const std::string& name) {
    const hb::NamedColour* named = handbook.FindColour(name);
    return named == nullptr ? RecordedColour() : RecordedColour{named->name(), named->hex()};
  });
  if (!colour.hex.empty()) return colour;
  return find([](const std::string& name) {
    const auto found = kMaterialColours.find(name);
    return found == kMaterialColours.end() ? RecordedColour() : RecordedColour{name, found->second};
  });
}

RecordedStyle ReadStyleText(std::string_view text, const ObjectNames& objects, const Handbook& handbook,
                            Conversion& conversion) {
  return Reader(text, objects, handbook, conversion).Read();
}

}  // namespace flair::language
