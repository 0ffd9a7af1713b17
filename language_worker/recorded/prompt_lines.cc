// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/recorded/prompt_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>

#include "language_worker/recorded/object_names.h"

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

// "- chair_1, chair_2: "dining chair", 0.45 x 0.5, dining, on a wall"; without the name where the ids tell it.
std::vector<PromptObject> ReadTranslationObjectLine(std::string_view line) {
  if (!line.starts_with("- ")) return {};
  line.remove_prefix(2);
  PromptObject object;
  auto ids = TakeUntil(": ", line);
  if (!ids) return {};
  const std::string_view first_id = ids->substr(0, ids->find(", "));
  object.name = std::string(WithoutNumber(first_id));
  if (line.starts_with('"')) {
    const auto name = TakeUntil("\", ", line);
    if (!name) return {};
    object.name = std::string(name->substr(1));
  }
  const auto width = TakeUntil(" x ", line);
  const auto depth = width ? TakeUntil(", ", line) : std::nullopt;
  if (!depth) return {};
  const std::string_view zone = line.substr(0, line.find(','));
  if (zone != "no zone") object.zone_id = std::string(zone);
  const auto read = [](std::string_view text, double& number) {
    const char* const end = text.data() + text.size();
    return std::from_chars(text.data(), end, number).ptr == end;
  };
  if (!read(*width, object.width_m) || !read(*depth, object.depth_m)) return {};
  std::vector<PromptObject> objects;
  while (!ids->empty()) {
    const size_t end = std::min(ids->find(", "), ids->size());
    object.id = std::string(ids->substr(0, end));
    objects.push_back(object);
    ids->remove_prefix(std::min(end + 2, ids->size()));
  }
  return objects;
}

// "[altar, workbench]"
std::optional<std::vector<std::string>> ReadHeading(std::string_view line) {
  if (line.size() < 2 || line.front() != '[' || line.back() != ']') return std::nullopt;
  line = line.substr(1, line.size() - 2);
  std::vector<std::string> ids;
  while (!line.empty()) {
    const size_t end = std::min(line.find(", "), line.size());
    ids.emplace_back(line.substr(0, end));
    line.remove_prefix(std::min(end + 2, line.size()));
  }
  return ids;
}

// "- s1 "The bed stands at a wall.""
std::optional<PromptSentence> ReadSentence(std::string_view line) {
  if (!line.starts_with("- ")) return std::nullopt;
  line.remove_prefix(2);
  PromptSentence sentence;
  const auto id = TakeUntil(" ", line);
  if (!id || id->empty() || !line.starts_with('"')) return std::nullopt;
  sentence.id = std::string(*id);
  const nlohmann::json text = nlohmann::json::parse(line, nullptr, /*allow_exceptions=*/false);
  if (!text.is_string()) return std::nullopt;
  sentence.text = text.get<std::string>();
  return sentence;
}

// "- near(object, target, max_distance_m? = 3): They are near."
std::optional<PromptFunction> ReadFunction(std::string_view line) {
  if (!line.starts_with("- ")) return std::nullopt;
  line.remove_prefix(2);
  PromptFunction function;
  const auto name = TakeUntil("(", line);
  auto parameters = name ? TakeUntil("): ", line) : std::nullopt;
  if (!parameters || name->empty() || name->find(' ') != std::string_view::npos) return std::nullopt;
  function.name = std::string(*name);
  while (!parameters->empty()) {
    const size_t end = std::min(parameters->find(", "), parameters->size());
    const std::string_view parameter = parameters->substr(0, end);
    parameters->remove_prefix(std::min(end + 2, parameters->size()));
    const size_t name_end = std::min(parameter.find_first_of("?: ="), parameter.size());
    if (name_end == parameter.size() || parameter[name_end] != '?') {
      function.needed.emplace_back(parameter.substr(0, name_end));
    }
  }
  return function;
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
    for (PromptObject& object : ReadTranslationObjectLine(line)) list.push_back(std::move(object));
  });
  return list;
}

std::vector<PromptSentence> ReadPromptSentences(std::string_view prompt) {
  std::vector<PromptSentence> list;
  std::vector<std::string> subject_ids;
  ForEachLine(prompt, [&](std::string_view line) {
    if (auto heading = ReadHeading(line)) subject_ids = *std::move(heading);
    if (auto sentence = ReadSentence(line)) {
      sentence->subject_ids = subject_ids;
      list.push_back(*std::move(sentence));
    }
  });
  return list;
}

std::vector<PromptFunction> ReadPromptFunctions(std::string_view prompt) {
  std::vector<PromptFunction> list;
  ForEachLine(prompt, [&](std::string_view line) {
    if (auto function = ReadFunction(line)) list.push_back(*std::move(function));
  });
  return list;
}

std::string_view WithoutNumber(std::string_view id) {
  const size_t last = id.find_last_not_of("0123456789");
  if (last == std::string_view::npos || last + 1 == id.size() || last == 0 || id[last] != '_') return id;
  return id.substr(0, last);
}

PromptIds::PromptIds(const std::vector<const v1::Object*>& objects, std::vector<PromptObjects> listed)
    : listed_(std::move(listed)), places_(objects.size()) {
  // Prompts round to centimetres.
  const auto near = [](double a, double b) { return std::abs(a - b) < 0.006; };
  std::vector<size_t> used(listed_.size(), 0);
  for (size_t i = 0; i < objects.size(); ++i) {
    const v1::Object& object = *objects[i];
    for (size_t g = 0; g < listed_.size(); ++g) {
      const PromptObjects& group = listed_[g];
      if (used[g] == group.ids.size() || group.zone_id != object.zone_id() ||
          NameKey(group.ids[0]) != NameKey(object.name()) || !near(group.width_m, object.width_m()) ||
          !near(group.depth_m, object.depth_m())) {
        continue;
      }
      places_[i] = {static_cast<int>(g), group.ids[used[g]++]};
      break;
    }
  }
}

std::vector<std::string> PromptIds::NamesOf(const std::vector<int>& objects) const {
  std::vector<size_t> counts(listed_.size(), 0);
  for (const int object : objects) {
    const Place& place = places_[static_cast<size_t>(object)];
    if (place.group >= 0) ++counts[static_cast<size_t>(place.group)];
  }
  std::vector<std::string> names;
  std::set<std::string> seen;
  for (const int object : objects) {
    const Place& place = places_[static_cast<size_t>(object)];
    if (place.group < 0) continue;
    const PromptObjects& group = listed_[static_cast<size_t>(place.group)];
    const bool whole = counts[static_cast<size_t>(place.group)] == group.ids.size();
    const std::string& name = whole ? group.group : place.id;
    if (seen.insert(name).second) names.push_back(name);
  }
  return names;
}

}  // namespace flair::language
