// SPDX-License-Identifier: GPL-3.0-or-later
#include <google/protobuf/descriptor.h>
#include <google/protobuf/text_format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <regex>

#include "absl/strings/numbers.h"
#include "cli/contract/script.h"

namespace flair::contract {
namespace {

namespace pb = google::protobuf;

// Takes what stands before the first of `ends` outside of brackets, and that character.
std::string_view Take(std::string_view& text, std::string_view ends) {
  size_t end = 0;
  for (int depth = 0; end < text.size() && (depth > 0 || ends.find(text[end]) == std::string_view::npos); ++end) {
    depth += (text[end] == '[') - (text[end] == ']');
  }
  const std::string_view taken = text.substr(0, end);
  text.remove_prefix(std::min(text.size(), end + 1));
  return taken;
}

int Number(std::string_view digits) { return std::atoi(std::string(digits).c_str()); }

// Which of `count` messages the brackets mean: "[]", "[-1]", "[2:]", "[id=bed][kind!=FLOOR]".
std::vector<int> Chosen(std::string_view brackets, int count, const std::function<const pb::Message&(int)>& item) {
  std::vector<int> chosen(static_cast<size_t>(count));
  std::iota(chosen.begin(), chosen.end(), 0);
  while (brackets.starts_with('[')) {
    brackets.remove_prefix(1);
    std::string_view inside = Take(brackets, "]");
    if (inside.empty()) continue;
    if (inside.find('=') != std::string_view::npos) {
      std::string_view key = Take(inside, "=");
      const bool other = key.ends_with('!');
      if (other) key.remove_suffix(1);
      std::erase_if(chosen, [&](int i) {
        const Values values = ValuesAt(item(i), key);
        return (values.size() == 1 && values[0].text == inside) == other;
      });
      continue;
    }
    const int number = Number(inside);
    const size_t from = number < 0 ? chosen.size() + static_cast<size_t>(number) : static_cast<size_t>(number);
    chosen.erase(chosen.begin(), chosen.begin() + static_cast<std::ptrdiff_t>(std::min(from, chosen.size())));
    if (!inside.ends_with(':') && chosen.size() > 1) chosen.resize(1);
  }
  return chosen;
}

// `index` is that of a list's item, -1 for a single field.
Value ValueOf(const pb::Message& message, const pb::FieldDescriptor& field, int index) {
  const pb::Reflection& reflection = *message.GetReflection();
  if (field.cpp_type() == pb::FieldDescriptor::CPPTYPE_STRING) {
    return {index < 0 ? reflection.GetString(message, &field) : reflection.GetRepeatedString(message, &field, index),
            true};
  }
  pb::TextFormat::Printer printer;
  printer.SetSingleLineMode(true);
  Value value;
  printer.PrintFieldValueToString(message, &field, index, &value.text);
  return value;
}

// What is at the rest of the path in one item of a list, or in a single field.
Values Within(const pb::Message& message, const pb::FieldDescriptor& field, int index, std::string_view path) {
  if (path.empty()) return {ValueOf(message, field, index)};
  const pb::Reflection& reflection = *message.GetReflection();
  return ValuesAt(
      index < 0 ? reflection.GetMessage(message, &field) : reflection.GetRepeatedMessage(message, &field, index), path);
}

Values Counted(size_t count) { return {{std::to_string(count), false}}; }

double NumberOf(const std::string& text) {
  double number = 0;
  return absl::SimpleAtod(text, &number) ? number : NAN;
}

bool IsLess(const std::string& one, const std::string& other) {
  const double a = NumberOf(one), b = NumberOf(other);
  return std::isnan(a) || std::isnan(b) ? one < other : a < b;
}

// Whether all of `got` are so; false when there are none.
bool Each(const std::vector<std::string>& got, const std::function<bool(const std::string&)>& is_so) {
  return !got.empty() && std::ranges::all_of(got, is_so);
}

}  // namespace

const pb::FieldDescriptor& FieldOf(const pb::Message& message, std::string_view name) {
  const pb::FieldDescriptor* const field = message.GetDescriptor()->FindFieldByName(std::string(name));
  if (field == nullptr) std::abort();
  return *field;
}

Values ValuesAt(const pb::Message& message, std::string_view path) {
  std::string_view step = Take(path, ".");
  const bool counts = step.ends_with('#');
  if (counts) step.remove_suffix(1);
  const size_t bracket = std::min(step.find('['), step.size());
  const pb::FieldDescriptor& field = FieldOf(message, step.substr(0, bracket));
  const pb::Reflection& reflection = *message.GetReflection();
  if (!field.is_repeated()) {
    const bool absent = field.has_presence() && !reflection.HasField(message, &field);
    return absent && path.empty() ? Values() : Within(message, field, -1, path);
  }
  const std::vector<int> chosen =
      Chosen(step.substr(bracket), reflection.FieldSize(message, &field),
             [&](int i) -> const pb::Message& { return reflection.GetRepeatedMessage(message, &field, i); });
  if (counts) return Counted(chosen.size());
  Values values;
  for (const int i : chosen) std::ranges::move(Within(message, field, i, path), std::back_inserter(values));
  return values;
}

Values ValuesAt(const Messages& answers, std::string_view path) {
  if (!path.starts_with('[')) return answers.empty() ? Values() : ValuesAt(*answers.back(), path);
  const std::string_view step = Take(path, ".");
  Values values;
  for (const int i :
       Chosen(step, static_cast<int>(answers.size()), [&](int i) -> const pb::Message& { return *answers[i]; })) {
    std::ranges::move(ValuesAt(*answers[static_cast<size_t>(i)], path), std::back_inserter(values));
  }
  return values;
}

pb::Message& PartOf(pb::Message& message, std::string_view path) {
  pb::Message* part = &message;
  while (!path.empty()) {
    const std::string_view step = Take(path, ".");
    const size_t bracket = step.find('[');
    const pb::FieldDescriptor& field = FieldOf(*part, step.substr(0, bracket));
    const pb::Reflection& reflection = *part->GetReflection();
    part = bracket == std::string_view::npos
               ? reflection.MutableMessage(part, &field)
               : reflection.MutableRepeatedMessage(part, &field, Number(step.substr(bracket + 1)));
  }
  return *part;
}

const pb::Message& PartOf(const pb::Message& message, std::string_view path) {
  const pb::Message* part = &message;
  while (!path.empty()) part = &part->GetReflection()->GetMessage(*part, &FieldOf(*part, Take(path, ".")));
  return *part;
}

bool Holds(checks::v1::Relation relation, const std::vector<std::string>& got, const std::vector<std::string>& given) {
  const std::string first = given.empty() ? "" : given.front();
  const auto sorted = [](std::vector<std::string> texts) {
    std::ranges::sort(texts);
    return texts;
  };
  switch (relation) {
    case checks::v1::RELATION_SAME_SET:
      return sorted(got) == sorted(given);
    case checks::v1::RELATION_INCLUDES:
      return std::ranges::all_of(given, [&](const auto& one) { return std::ranges::count(got, one) > 0; });
    case checks::v1::RELATION_STARTS_WITH:
      return got.size() >= given.size() && std::equal(given.begin(), given.end(), got.begin());
    case checks::v1::RELATION_DIFFERS:
      return got != given;
    case checks::v1::RELATION_MATCHES:
      return Each(got, [&](const auto& one) { return std::regex_search(one, std::regex(first)); });
    case checks::v1::RELATION_BEGINS:
      return Each(got, [&](const auto& one) { return one.starts_with(first); });
    case checks::v1::RELATION_IS_SET:
      return Each(got, [](const auto& one) { return !one.empty(); });
    case checks::v1::RELATION_RISING:
      return std::ranges::adjacent_find(got, [](const auto& a, const auto& b) { return !IsLess(a, b); }) == got.end();
    case checks::v1::RELATION_COUNTING:
      for (size_t i = 0; i < got.size(); ++i) {
        if (got[i] != std::to_string(i + 1)) return false;
      }
      return true;
    case checks::v1::RELATION_NEAR:
      return Each(got, [&](const auto& one) { return std::abs(NumberOf(one) - NumberOf(first)) < 1e-6; });
    case checks::v1::RELATION_SUM: {
      double sum = 0;
      for (const std::string& one : got) sum += NumberOf(one);
      return sum == NumberOf(first);
    }
    case checks::v1::RELATION_GREATEST:
      return !got.empty() && *std::ranges::max_element(got, IsLess) == first;
    default:
      return got == given;
  }
}

}  // namespace flair::contract
