// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "llm/answers/read_answer.h"

namespace flair::llm {
namespace {

using google::protobuf::FieldDescriptor;

constexpr int kMostShownChoices = 24;

std::string UnitWord(std::string_view unit) {
  if (unit == "m") return "metres";
  if (unit == "deg") return "degrees";
  return std::string(unit);
}

// The names whose bare form `equal` accepts, aliases included.
template <typename Equal>
std::set<std::string> Meant(const Choices& choices, const Equal& equal) {
  std::set<std::string> meant;
  for (const std::string& name : choices.names) {
    if (equal(Bare(name))) meant.insert(name);
  }
  for (const auto& [alias, name] : choices.aliases) {
    if (equal(Bare(alias))) meant.insert(name);
  }
  return meant;
}

std::string WithoutPlural(std::string text) {
  if (text.size() > 3 && text.back() == 's') text.pop_back();
  return text;
}

struct UnitName {
  std::string_view unit;
  std::string_view name;
  double factor;
};

constexpr UnitName kUnits[] = {
    {"m", "m", 1},         {"m", "metres", 1},   {"m", "meters", 1}, {"m", "cm", 0.01}, {"m", "mm", 0.001},
    {"deg", "degrees", 1}, {"deg", "degree", 1}, {"deg", "deg", 1},  {"deg", "°", 1},
};

std::string_view Stripped(std::string_view text) {
  const size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

using google::protobuf::Descriptor;
using Json = nlohmann::ordered_json;

// Servers that turn a schema into a grammar write repetitions out; larger limits are for the reader alone.
constexpr int kMostItemsToSay = 40;

Json ObjectSchema(const Descriptor& message, const FieldChoices& choices);

// 20 instead of 20.0, so that the schema reads as a person would write it.
Json Number(double value) {
  if (value == static_cast<double>(static_cast<int64_t>(value))) return static_cast<int64_t>(value);
  return value;
}

Json ValueSchema(const FieldDescriptor& field, const FieldChoices& choices) {
  const model::v1::FieldFacts& facts = FactsOf(field);
  Json schema;
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_MESSAGE:
      if (facts.line()) return {{"type", "string"}};
      return ObjectSchema(*field.message_type(), choices);
    case FieldDescriptor::CPPTYPE_BOOL:
      return {{"type", "boolean"}};
    case FieldDescriptor::CPPTYPE_STRING:
      schema["type"] = "string";
      if (const std::optional<Choices> texts = TextsOf(field, choices)) schema["enum"] = texts->names;
      return schema;
    default:
      schema["type"] = IsWhole(field) ? "integer" : "number";
      if (facts.has_minimum()) schema["minimum"] = Number(facts.minimum());
      if (facts.has_maximum()) schema["maximum"] = Number(facts.maximum());
      return schema;
  }
}

Json FieldSchema(const FieldDescriptor& field, const FieldChoices& choices) {
  const model::v1::FieldFacts& facts = FactsOf(field);
  Json schema = ValueSchema(field, choices);
  if (field.is_repeated()) {
    schema = {{"type", "array"}, {"items", schema}};
    if (facts.min_items() > 0) schema["minItems"] = facts.min_items();
    if (facts.max_items() > 0 && facts.max_items() <= kMostItemsToSay) schema["maxItems"] = facts.max_items();
  } else if (field.has_optional_keyword()) {
    schema["type"] = {schema["type"], "null"};
    if (schema.contains("enum")) schema["enum"].push_back(nullptr);
  }
  if (!facts.doc().empty()) schema["description"] = facts.doc();
  return schema;
}

Json ObjectSchema(const Descriptor& message, const FieldChoices& choices) {
  Json properties = Json::object(), required = Json::array();
  for (int i = 0; i < message.field_count(); ++i) {
    properties[message.field(i)->name()] = FieldSchema(*message.field(i), choices);
    required.push_back(message.field(i)->name());
  }
  return {{"type", "object"}, {"properties", properties}, {"required", required}, {"additionalProperties", false}};
}

}  // namespace

const model::v1::FieldFacts& FactsOf(const FieldDescriptor& field) {
  return field.options().GetExtension(model::v1::facts);
}

std::optional<Choices> TextsOf(const FieldDescriptor& field, const FieldChoices& choices) {
  if (const auto found = choices.find(field.full_name()); found != choices.end()) return found->second;
  const auto& declared = FactsOf(field).choices();
  if (declared.empty()) return std::nullopt;
  return Choices{{declared.begin(), declared.end()}, {}};
}

bool IsWhole(const FieldDescriptor& field) { return field.cpp_type() == FieldDescriptor::CPPTYPE_INT32; }

NumberRange RangeOf(const FieldDescriptor& field) {
  NumberRange range = {std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max()};
  if (IsWhole(field)) range = {std::numeric_limits<int32_t>::min(), std::numeric_limits<int32_t>::max()};
  const model::v1::FieldFacts& facts = FactsOf(field);
  if (facts.has_minimum()) range.least = facts.minimum();
  if (facts.has_maximum()) range.most = facts.maximum();
  return range;
}

void SetNumberField(double value, const FieldDescriptor& field, google::protobuf::Message& message) {
  const google::protobuf::Reflection& reflection = *message.GetReflection();
  const auto whole = static_cast<int32_t>(value);
  if (field.is_repeated()) {
    IsWhole(field) ? reflection.AddInt32(&message, &field, whole) : reflection.AddDouble(&message, &field, value);
  } else {
    IsWhole(field) ? reflection.SetInt32(&message, &field, whole) : reflection.SetDouble(&message, &field, value);
  }
}

std::string RightFor(const FieldDescriptor& field, const FieldChoices& choices) {
  const model::v1::FieldFacts& facts = FactsOf(field);
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_MESSAGE:
      return "an object";
    case FieldDescriptor::CPPTYPE_BOOL:
      return "true or false";
    case FieldDescriptor::CPPTYPE_STRING: {
      const std::optional<Choices> texts = TextsOf(field, choices);
      if (!texts) return "a text";
      std::string names;
      const int count = static_cast<int>(texts->names.size());
      for (int i = 0; i < std::min(count, kMostShownChoices); ++i) {
        names += fmt::format("{}\"{}\"", i > 0 ? ", " : "", texts->names[static_cast<size_t>(i)]);
      }
      if (count > kMostShownChoices) names += fmt::format(" and {} more", count - kMostShownChoices);
      return "one of " + names;
    }
    default: {
      std::string right = IsWhole(field) ? "a whole number" : "a number";
      if (!facts.unit().empty()) right += " in " + UnitWord(facts.unit());
      const NumberRange range = RangeOf(field);
      if (facts.has_minimum() && facts.has_maximum())
        return fmt::format("{}, {:g} to {:g}", right, range.least, range.most);
      if (facts.has_minimum()) return fmt::format("{}, {:g} or more", right, range.least);
      if (facts.has_maximum()) return fmt::format("{}, {:g} or less", right, range.most);
      return right;
    }
  }
}

std::string Bare(std::string_view text) {
  std::string bare;
  for (const char c : text) {
    if (c >= 'A' && c <= 'Z') {
      bare += static_cast<char>(c - 'A' + 'a');
    } else if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80) {
      bare += c;
    }
  }
  return bare;
}

std::optional<std::string> FindChoice(std::string_view text, const Choices& choices) {
  const std::string bare = Bare(text);
  if (bare.empty()) return std::nullopt;
  for (const std::string& name : choices.names) {
    if (name == text) return name;
  }
  std::set<std::string> meant = Meant(choices, [&](const std::string& name) { return name == bare; });
  if (meant.empty()) {
    const std::string singular = WithoutPlural(bare);
    meant = Meant(choices, [&](const std::string& name) { return WithoutPlural(name) == singular; });
  }
  if (meant.size() != 1) return std::nullopt;
  return *meant.begin();
}

std::optional<double> ReadQuantity(std::string_view written, std::string_view unit) {
  const std::string_view text = Stripped(written);
  double value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  const std::string_view rest = Stripped(text.substr(static_cast<size_t>(stop - text.data())));
  if (rest.empty()) return value;
  const auto* const found = std::ranges::find_if(
      kUnits, [&](const UnitName& candidate) { return candidate.unit == unit && candidate.name == rest; });
  return found == std::end(kUnits) ? std::nullopt : std::optional(value * found->factor);
}

std::string AnswerSchema(const Descriptor& message, const FieldChoices& choices) {
  return ObjectSchema(message, choices).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string AnswerSchemaName(const Descriptor& message) {
  std::string name;
  for (const char c : message.name()) {
    const bool upper = c >= 'A' && c <= 'Z';
    if (upper && !name.empty()) name += '_';
    name += upper ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return name.substr(0, 64);
}

}  // namespace flair::llm
