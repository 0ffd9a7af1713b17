// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/recorded/object_names.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "absl/strings/ascii.h"
#include "llm/answers/utf8.h"

namespace flair::language {
namespace {

// Words of the longest name that is looked for in a text.
constexpr size_t kLongestName = 6;

bool IsWordByte(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || absl::ascii_isdigit(c) ||
         (static_cast<unsigned char>(c) & 0x80) != 0;
}

std::string Singular(std::string word) {
  const auto ends = [&](std::string_view ending) { return word.size() > ending.size() + 1 && word.ends_with(ending); };
  if (ends("ves")) return word.substr(0, word.size() - 3) + "f";
  if (ends("ies")) return word.substr(0, word.size() - 3) + "y";
  if (ends("shes") || ends("ches") || ends("sses") || ends("xes")) return word.substr(0, word.size() - 2);
  if (ends("s") && !ends("ss") && !ends("us")) return word.substr(0, word.size() - 1);
  return word;
}

// Reads a number at the beginning of `text` and takes it off.
std::optional<double> TakeNumber(std::string_view& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  text.remove_prefix(static_cast<size_t>(end - text.data()));
  return value;
}

void Skip(std::string_view signs, std::string_view& text) {
  const size_t begin = text.find_first_not_of(signs);
  text.remove_prefix(begin == std::string_view::npos ? text.size() : begin);
}

// The two lengths of " (1.5m x 0.6m)", " - Width: 0.5m, Length: 0.4m" and the like, which must follow at once.
std::optional<std::pair<double, double>> ReadSize(std::string_view behind) {
  constexpr size_t kNear = 60;
  behind = behind.substr(0, std::min({behind.size(), kNear, behind.find('\n')}));
  const auto number = [&]() -> std::optional<double> {
    const size_t at = behind.find_first_of("0123456789");
    if (at == std::string_view::npos) return std::nullopt;
    // Only signs and the words of sizes may stand before it.
    for (const Word& word : ReadWords(behind.substr(0, at))) {
      static const std::set<std::string, std::less<>> kWords = {"width", "length", "x",    "m",   "by",
                                                                "wide",  "long",   "each", "size"};
      if (!kWords.contains(word.key)) return std::nullopt;
    }
    behind.remove_prefix(at);
    return TakeNumber(behind);
  };
  const std::optional<double> first = number();
  const std::optional<double> second = first ? number() : std::nullopt;
  if (!second) return std::nullopt;
  return std::pair(*first, *second);
}

// The 2 of " 2 - ..." or " (2)"; 0 when no bare number follows at once.
int ReadNumber(std::string_view behind) {
  Skip(" (#", behind);
  int value = 0;
  size_t digits = 0;
  while (digits < behind.size() && digits < 2 && absl::ascii_isdigit(behind[digits]))
    value = 10 * value + (behind[digits++] - '0');
  if (digits == 0) return 0;
  const char next = digits < behind.size() ? behind[digits] : ' ';
  if (IsWordByte(next) || next == '.') return 0;
  return value;
}

constexpr size_t kLongest = 390;

bool EndsSentence(std::string_view line, size_t at) {
  if (line[at] != '.' && line[at] != '!' && line[at] != '?') return false;
  if (at + 2 >= line.size() || line[at + 1] != ' ') return false;
  const char next = line[at + 2];
  if (next < 'A' || next > 'Z') return false;
  // "e.g. Wooden beams"
  return at < 2 || line[at - 2] != '.';
}

}  // namespace

std::vector<Word> ReadWords(std::string_view text) {
  std::vector<Word> words;
  for (size_t i = 0; i < text.size();) {
    if (!IsWordByte(text[i])) {
      ++i;
      continue;
    }
    Word word{i, i, ""};
    for (; i < text.size(); ++i) {
      const bool point = text[i] == '.' && i + 1 < text.size() && absl::ascii_isdigit(text[i + 1]) &&
                         !word.key.empty() && absl::ascii_isdigit(text[i - 1]);
      if (!IsWordByte(text[i]) && !point) break;
      const char c = text[i];
      word.key += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    word.end = i;
    word.key = Singular(std::move(word.key));
    words.push_back(std::move(word));
  }
  return words;
}

std::string NameKey(std::string_view name) {
  std::string key;
  for (const Word& word : ReadWords(name)) {
    // A number at the end only tells equal things apart.
    if (key.empty() || !std::all_of(word.key.begin(), word.key.end(), absl::ascii_isdigit)) key += word.key;
  }
  return key;
}

ObjectNames::ObjectNames(const std::vector<const v1::Object*>& objects) : objects_(objects) {
  for (size_t i = 0; i < objects.size(); ++i) {
    Name name;
    name.key = NameKey(objects[i]->name());
    for (Word& word : ReadWords(objects[i]->name())) name.words.push_back(std::move(word.key));
    const auto same = std::find_if(names_.begin(), names_.end(), [&](const Name& n) { return n.key == name.key; });
    Name& known = same != names_.end() ? *same : names_.emplace_back(std::move(name));
    known.objects.push_back(static_cast<int>(i));
  }
}

std::vector<int> ObjectNames::Choose(std::string_view behind, std::string_view zone_id,
                                     std::vector<int> objects) const {
  if (objects.size() < 2) return objects;
  const auto keep = [&](auto right) {
    std::vector<int> kept;
    std::copy_if(objects.begin(), objects.end(), std::back_inserter(kept), right);
    if (!kept.empty()) objects = std::move(kept);
  };
  if (const auto size = ReadSize(behind)) {
    const auto equal = [](double a, double b) { return std::abs(a - b) < 0.005; };
    keep([&](int i) {
      const v1::Object& object = *objects_[static_cast<size_t>(i)];
      return (equal(object.width_m(), size->first) && equal(object.depth_m(), size->second)) ||
             (equal(object.width_m(), size->second) && equal(object.depth_m(), size->first));
    });
  }
  if (!zone_id.empty()) keep([&](int i) { return objects_[static_cast<size_t>(i)]->zone_id() == zone_id; });
  const int number = ReadNumber(behind);
  if (number >= 1 && number <= static_cast<int>(objects.size())) return {objects[static_cast<size_t>(number - 1)]};
  return objects;
}

std::vector<Mention> ObjectNames::Find(std::string_view text, std::string_view zone_id) const {
  const std::vector<Word> words = ReadWords(text);
  std::vector<Mention> mentions;
  for (size_t i = 0; i < words.size();) {
    size_t taken = 0;
    for (size_t count = std::min(kLongestName, words.size() - i); count > 0 && taken == 0; --count) {
      std::string key;
      for (size_t k = i; k < i + count; ++k) key += words[k].key;
      for (const Name& name : names_) {
        if (name.key.empty() || name.key != key) continue;
        const size_t end = words[i + count - 1].end;
        mentions.push_back({words[i].begin, end, Choose(text.substr(end), zone_id, name.objects)});
        taken = count;
        break;
      }
    }
    i += std::max<size_t>(taken, 1);
  }
  return mentions;
}

std::vector<Mention> ObjectNames::FindLoosely(std::string_view text, std::string_view zone_id) const {
  std::vector<Mention> mentions = Find(text, zone_id);
  if (!mentions.empty()) return mentions;
  for (const Word& word : ReadWords(text)) {
    constexpr size_t kLeast = 3;  // "of", "tv"
    if (word.key.size() < kLeast) continue;
    const Name* only = nullptr;
    int count = 0;
    for (const Name& name : names_) {
      if (std::find(name.words.begin(), name.words.end(), word.key) == name.words.end()) continue;
      only = &name;
      ++count;
    }
    if (count != 1) continue;
    const bool known = std::any_of(mentions.begin(), mentions.end(),
                                   [&](const Mention& other) { return other.objects == only->objects; });
    if (!known) mentions.push_back({word.begin, word.end, Choose(text.substr(word.end), zone_id, only->objects)});
  }
  return mentions;
}

std::string FindZone(std::string_view text, const std::vector<std::string>& zone_ids) {
  std::vector<Word> words = ReadWords(text);
  for (const std::string& id : zone_ids) {
    std::vector<Word> zone = ReadWords(id);
    // "living_area" is one word of an id but two of a text.
    std::string key, zone_key;
    for (const Word& word : zone) zone_key += word.key;
    for (size_t i = 0; i < std::min<size_t>(words.size(), 3); ++i) {
      key += words[i].key;
      if (!key.empty() && key == zone_key) return id;
    }
  }
  return "";
}

std::vector<std::string> SplitSentences(std::string_view line) {
  std::vector<std::string> sentences;
  size_t begin = 0;
  int open = 0;
  const auto add = [&](size_t end) {
    std::string_view sentence = line.substr(begin, end - begin);
    const size_t first = sentence.find_first_not_of(' ');
    if (first != std::string_view::npos) {
      sentences.push_back(llm::CutBytes(llm::ToUtf8(sentence.substr(first)), kLongest));
    }
    begin = end;
  };
  for (size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '(') ++open;
    if (line[i] == ')') open = std::max(0, open - 1);
    if (open == 0 && EndsSentence(line, i)) add(i + 1);
  }
  add(line.size());
  return sentences;
}

bool IsSize(std::string_view text) {
  static const std::set<std::string, std::less<>> kWords = {"width",     "length",     "x",    "by",  "wide",
                                                            "long",      "each",       "size", "m",   "approximately",
                                                            "dimension", "lengthwise", "and",  "high"};
  for (const Word& word : ReadWords(text)) {
    const bool number = word.key[0] >= '0' && word.key[0] <= '9';
    if (!number && !kWords.contains(word.key)) return false;
  }
  return true;
}

bool HasSize(std::string_view text) {
  const std::vector<Word> words = ReadWords(text);
  return std::any_of(words.begin(), words.end(), [](const Word& word) {
    return word.key.size() > 1 && word.key[0] >= '0' && word.key[0] <= '9' && word.key.back() == 'm';
  });
}

double Likeness(std::string_view a, std::string_view b) {
  const auto keys = [](std::string_view text) {
    static const std::set<std::string, std::less<>> kEmpty = {"the", "a", "an", "be", "is", "to", "of", "for", "it"};
    std::set<std::string, std::less<>> set;
    for (Word& word : ReadWords(text)) {
      if (!kEmpty.contains(word.key)) set.insert(std::move(word.key));
    }
    return set;
  };
  const auto first = keys(a), second = keys(b);
  const size_t least = std::min(first.size(), second.size());
  if (least == 0) return 0;
  const auto common =
      std::count_if(first.begin(), first.end(), [&](const auto& word) { return second.contains(word); });
  return static_cast<double>(common) / static_cast<double>(least);
}

}  // namespace flair::language
