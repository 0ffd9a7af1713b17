// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/recorded/prompt_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>

namespace flair::language {
namespace {

constexpr int kMostOfAGroup = 200;

// Calls `read` with each line.
template <typename Read>
void ForEachLine(std::string_view text, const Read& read) {
  while (!text.empty()) {
    const size_t end = std::min(text.find('\n'), text.size());
    read(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

// What stands before `sign`, which is taken off too; nothing when there is no such sign.
std::optional<std::string_view> TakeUntil(std::string_view sign, std::string_view& text) {
  const size_t at = text.find(sign);
  if (at == std::string_view::npos) return std::nullopt;
  const std::string_view before = text.substr(0, at);
  text.remove_prefix(at + sign.size());
  return before;
}

int NumberOf(std::string_view id) {
  int number = 0;
  const std::string_view digits = id.substr(std::min(id.size(), WithoutNumber(id).size() + 1));
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

// "chair_1 to chair_4, together chair", with a star behind it for primaries.
bool ReadNames(std::string_view names, PromptObjects& objects) {
  if (names.ends_with('*')) names.remove_suffix(1);
  std::string_view rest = names;
  const auto first = TakeUntil(" to ", rest);
  const auto last = first ? TakeUntil(", together ", rest) : std::nullopt;
  if (!first || !last) {
    objects.ids = {std::string(names)};
    objects.group = std::string(names);
    return !names.empty() && names.find(' ') == std::string_view::npos;
  }
  objects.group = std::string(rest);
  const std::string_view base = WithoutNumber(*last);
  const int end = NumberOf(*last), begin = NumberOf(*first);
  if (base.size() == last->size() || end - begin > kMostOfAGroup) return false;
  objects.ids = {std::string(*first)};
  for (int number = begin + 1; number <= end; ++number) objects.ids.push_back(fmt::format("{}_{}", base, number));
  return true;
}

std::optional<PromptObjects> ReadObjects(std::string_view line) {
  if (!line.starts_with("- ")) return std::nullopt;
  line.remove_prefix(2);
  PromptObjects objects;
  const auto names = TakeUntil(" (", line);
  if (!names || !ReadNames(*names, objects)) return std::nullopt;
  const auto zone = TakeUntil("): ", line);
  if (!zone) return std::nullopt;
  objects.zone_id = std::string(*zone);
  const auto width = TakeUntil(" x ", line);
  const auto depth = width ? TakeUntil(" x ", line) : std::nullopt;
  if (!depth) return std::nullopt;
  std::from_chars(width->data(), width->data() + width->size(), objects.width_m);
  std::from_chars(depth->data(), depth->data() + depth->size(), objects.depth_m);
  return objects;
}

// "- bed_1: "double bed", 1.60 x 2.00 x 0.50, sleeping, on the floor"
std::optional<PromptObject> ReadTranslationObject(std::string_view line) {
  if (!line.starts_with("- ")) return std::nullopt;
  line.remove_prefix(2);
  PromptObject object;
  const auto id = TakeUntil(": \"", line);
  if (!id || id->find(' ') != std::string_view::npos) return std::nullopt;
  const auto name = TakeUntil("\", ", line);
  const auto width = name ? TakeUntil(" x ", line) : std::nullopt;
  const auto depth = width ? TakeUntil(" x ", line) : std::nullopt;
  const auto height = depth ? TakeUntil(", ", line) : std::nullopt;
  const auto zone = height ? TakeUntil(", ", line) : std::nullopt;
  if (!zone) return std::nullopt;
  object.id = std::string(*id);
  object.name = std::string(*name);
  if (*zone != "no zone") object.zone_id = std::string(*zone);
  std::from_chars(width->data(), width->data() + width->size(), object.width_m);
  std::from_chars(depth->data(), depth->data() + depth->size(), object.depth_m);
  return object;
}

std::optional<PromptSentence> ReadSentence(std::string_view line) {
  PromptSentence sentence;
  if (line.starts_with("- ")) line.remove_prefix(2);
  const auto id = TakeUntil(" [", line);
  if (!id || id->empty() || id->find(' ') != std::string_view::npos) return std::nullopt;
  sentence.id = std::string(*id);
  auto subjects = TakeUntil("] ", line);
  if (!subjects || !line.starts_with('"')) return std::nullopt;
  while (!subjects->empty()) {
    const size_t end = std::min(subjects->find(", "), subjects->size());
    sentence.subject_ids.emplace_back(subjects->substr(0, end));
    subjects->remove_prefix(std::min(end + 2, subjects->size()));
  }
  const nlohmann::json text = nlohmann::json::parse(line, nullptr, /*allow_exceptions=*/false);
  if (!text.is_string()) return std::nullopt;
  sentence.text = text.get<std::string>();
  return sentence;
}

}  // namespace

std::vector<PromptObjects> ReadPromptObjects(std::string_view prompt) {
  std::vector<PromptObjects> list;
  ForEachLine(prompt, [&](std::string_view line) {
    if (auto objects = ReadObjects(line)) list.push_back(*std::move(objects));
  });
  return list;
}

std::vector<PromptObject> ReadTranslationObjects(std::string_view prompt) {
  std::vector<PromptObject> list;
  ForEachLine(prompt, [&](std::string_view line) {
    if (auto object = ReadTranslationObject(line)) list.push_back(*std::move(object));
  });
  return list;
}

std::vector<PromptSentence> ReadPromptSentences(std::string_view prompt) {
  std::vector<PromptSentence> list;
  ForEachLine(prompt, [&](std::string_view line) {
    if (auto sentence = ReadSentence(line)) list.push_back(*std::move(sentence));
  });
  return list;
}

std::string_view WithoutNumber(std::string_view id) {
  const size_t last = id.find_last_not_of("0123456789");
  if (last == std::string_view::npos || last + 1 == id.size() || last == 0 || id[last] != '_') return id;
  return id.substr(0, last);
}

}  // namespace flair::language
