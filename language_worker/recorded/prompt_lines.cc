// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>

#include "absl/strings/str_split.h"
#include "language_worker/recorded/import_answers.h"
#include "language_worker/recorded/recorded_text.h"

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

bool TakePrefix(std::string_view prefix, std::string_view& text) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
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

std::vector<std::string> SplitIds(std::string_view list) {
  return list.empty() ? std::vector<std::string>() : std::vector<std::string>(absl::StrSplit(std::string(list), ", "));
}

// "0.45 x 0.5", with what follows.
bool TakeSize(std::string_view& line, PromptObjects& objects) {
  const auto take = [&](double& number) {
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), number);
    line.remove_prefix(static_cast<size_t>(end - line.data()));
    return error == std::errc();
  };
  return take(objects.width_m) && TakePrefix(" x ", line) && take(objects.depth_m);
}

std::optional<PromptObjects> ReadStepObjects(std::string_view line) {
  PromptObjects objects;
  const auto names = TakeUntil(" (", line);
  const auto zone = names && ReadNames(*names, objects) ? TakeUntil("): ", line) : std::nullopt;
  if (!zone || !TakeSize(line, objects) || !line.starts_with(" x ")) return std::nullopt;
  objects.zone_id = std::string(*zone);
  objects.name = objects.ids.front();
  return objects;
}

std::optional<PromptObjects> ReadTranslationObjects(std::string_view line) {
  PromptObjects objects;
  const auto ids = TakeUntil(": ", line);
  if (!ids) return std::nullopt;
  objects.ids = SplitIds(*ids);
  objects.name = std::string(WithoutNumber(ids->substr(0, ids->find(", "))));
  if (TakePrefix("\"", line)) objects.name = std::string(TakeUntil("\", ", line).value_or(""));
  if (objects.name.empty() || !TakeSize(line, objects) || !TakePrefix(", ", line)) return std::nullopt;
  const std::string_view zone = line.substr(0, line.find(','));
  if (zone != "no zone") objects.zone_id = std::string(zone);
  return objects;
}

// "[altar, workbench]"
std::optional<std::vector<std::string>> ReadHeading(std::string_view line) {
  if (line.size() < 2 || line.front() != '[' || line.back() != ']') return std::nullopt;
  return SplitIds(line.substr(1, line.size() - 2));
}

// "- s1 "The bed stands at a wall.""
std::optional<PromptSentence> ReadSentence(std::string_view line) {
  if (!TakePrefix("- ", line)) return std::nullopt;
  PromptSentence sentence;
  const auto id = TakeUntil(" ", line);
  if (!id || id->empty() || !line.starts_with('"')) return std::nullopt;
  sentence.id = std::string(*id);
  const nlohmann::json text = nlohmann::json::parse(line, nullptr, /*allow_exceptions=*/false);
  if (!text.is_string()) return std::nullopt;
  sentence.text = text.get<std::string>();
  return sentence;
}

}  // namespace

std::vector<PromptObjects> ReadPromptObjects(std::string_view prompt) {
  std::vector<PromptObjects> list;
  ForEachLine(prompt, [&](std::string_view line) {
    if (!TakePrefix("- ", line)) return;
    std::optional<PromptObjects> objects = ReadStepObjects(line);
    if (!objects) objects = ReadTranslationObjects(line);
    if (objects) list.push_back(*std::move(objects));
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

std::string_view WithoutNumber(std::string_view id) {
  const size_t last = id.find_last_not_of("0123456789");
  if (last == std::string_view::npos || last + 1 == id.size() || last == 0 || id[last] != '_') return id;
  return id.substr(0, last);
}

PromptIds::PromptIds(const std::vector<const v1::Object*>& objects, std::vector<PromptObjects> listed, bool loosely)
    : listed_(std::move(listed)), places_(objects.size()) {
  // Prompts round to centimetres.
  const auto near = [](double a, double b) { return std::abs(a - b) < 0.006; };
  const auto equal = [&](const PromptObjects& group, const v1::Object& object) {
    const bool zoned = object.role() != v1::OBJECT_ROLE_TERTIARY;
    return (!zoned || group.zone_id == object.zone_id()) && near(group.width_m, object.width_m()) &&
           near(group.depth_m, object.depth_m());
  };
  std::vector<size_t> used(listed_.size(), 0);
  for (const bool by_name : {false, true}) {
    if (by_name && !loosely) break;
    for (size_t i = 0; i < objects.size(); ++i) {
      for (size_t g = 0; g < listed_.size() && places_[i].group < 0; ++g) {
        const PromptObjects& group = listed_[g];
        if (used[g] == group.ids.size() || NameKey(group.name) != NameKey(objects[i]->name())) continue;
        if (by_name || equal(group, *objects[i])) places_[i] = {static_cast<int>(g), group.ids[used[g]++]};
      }
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
