// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/answer_schema.h"

#include <nlohmann/json.hpp>

#include "llm/answers/field_facts.h"

namespace flair::llm {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
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
    case FieldDescriptor::CPPTYPE_ENUM: {
      schema["type"] = "string";
      const FieldTexts texts(field, choices);
      if (texts.get() != nullptr) schema["enum"] = texts.get()->names;
      return schema;
    }
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
