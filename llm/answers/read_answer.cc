// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/read_answer.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "llm/answers/answer_elements.h"
#include "llm/answers/answer_lines.h"
#include "llm/answers/answer_members.h"
#include "llm/answers/answer_root.h"
#include "llm/answers/extract_json.h"
#include "llm/answers/field_facts.h"
#include "llm/answers/plain_value.h"
#include "llm/answers/read_number.h"
#include "llm/answers/utf8.h"
#include "llm/answers/written_size.h"
#include "worker_runtime/text/counted.h"

namespace flair::llm {
namespace {

using google::protobuf::FieldDescriptor;
using ProtoMessage = google::protobuf::Message;
using google::protobuf::Reflection;
using nlohmann::json;

constexpr int kMostItems = 1000;
constexpr int kMostCharacters = 400;

// One line without space around it; line ends and other control characters become spaces.
std::string OneLine(const std::string& text) {
  std::string line;
  for (const char c : PlainSpaces(text)) {
    const bool space = static_cast<unsigned char>(c) <= 0x20 || c == 0x7F;
    if (!space) {
      line += c;
    } else if (!line.empty() && line.back() != ' ') {
      line += ' ';
    }
  }
  if (!line.empty() && line.back() == ' ') line.pop_back();
  return line;
}

// Cuts valid UTF-8 to `most` characters, and the space that it then ends in; false when it has no more.
bool CutTo(int most, std::string& text) {
  int count = 0;
  for (size_t i = 0; i < text.size(); ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xC0) != 0x80 && ++count > most) {
      text.resize(i);
      if (text.back() == ' ') text.pop_back();
      return true;
    }
  }
  return false;
}

class Reader {
 public:
  Reader(const FieldChoices& choices, const LengthUnit* bare_unit) : choices_(choices), bare_unit_(bare_unit) {}

  std::vector<Fault> TakeFaults() { return std::move(faults_); }

  // As ReadMessage, but an object with nothing of what was asked for is no answer.
  void ReadRoot(const json& value, ProtoMessage& message) {
    const google::protobuf::Descriptor& type = *message.GetDescriptor();
    bool any = !value.is_object();
    Members members(value, type);
    for (int i = 0; i < type.field_count(); ++i) any = any || members.Find(*type.field(i)).value != nullptr;
    if (any) {
      ReadMessage(value, "", message);
    } else {
      Wrong("", fmt::format("has none of what was asked for; an object with {} would be right", FieldNames(type)));
    }
  }

  void ReadMessage(const json& value, const std::string& path, ProtoMessage& message) {
    const google::protobuf::Descriptor& type = *message.GetDescriptor();
    if (value.is_string()) {
      const json object = ObjectOfText(value.get_ref<const std::string&>(), type);
      if (object.is_object()) return ReadMessage(object, path, message);
    }
    if (!value.is_object()) {
      Wrong(path, fmt::format("is {}; an object with {} would be right", Shown(value), FieldNames(type)));
      return;
    }
    const std::optional<LengthUnit> unit = UnitOf(value, type);
    const LengthUnit* const outer_unit = std::exchange(bare_unit_, unit ? &*unit : bare_unit_);
    const std::optional<json> sized = WithWrittenSize(value, type);
    Members members(sized ? *sized : value, type);
    for (int i = 0; i < type.field_count(); ++i) {
      const FieldDescriptor& field = *type.field(i);
      const std::string at = path.empty() ? field.name() : path + "." + field.name();
      const Member member = members.Find(field);
      const json by_choice =
          field.is_repeated() && member.value == nullptr ? MembersByChoice(value, field, choices_) : json();
      ReadField(by_choice.is_null() ? member : Member{&by_choice}, field, at, message);
    }
    bare_unit_ = outer_unit;
  }

 private:
  void Wrong(const std::string& path, std::string text) {
    faults_.push_back({path, std::move(text), FaultKind::kWrong});
  }

  static std::string FieldNames(const google::protobuf::Descriptor& type) {
    std::string names;
    for (int i = 0; i < type.field_count(); ++i) names += (i > 0 ? ", " : "") + type.field(i)->name();
    return names;
  }

  void ReadField(const Member& member, const FieldDescriptor& field, const std::string& path, ProtoMessage& message) {
    const bool absent = member.value == nullptr || member.value->is_null();
    if (field.is_repeated()) {
      static const json nothing = json::array();
      ReadList(absent ? nothing : *member.value, field, path, message);
    } else if (absent) {
      ReadNothing(field, path, message);
    } else if (field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) {
      ReadMessage(*member.value, path, *message.GetReflection()->MutableMessage(&message, &field));
    } else if (const std::optional<double> number = member.unit.empty() ? std::nullopt : PlainNumber(*member.value)) {
      ReadScalar(fmt::format("{} {}", *number, member.unit), field, path, message);
    } else {
      ReadScalar(*member.value, field, path, message);
    }
  }

  void ReadNothing(const FieldDescriptor& field, const std::string& path, ProtoMessage& message) {
    const model::v1::FieldFacts& facts = FactsOf(field);
    if (facts.has_when_absent()) {
      faults_.push_back({path, fmt::format("is missing; taken as {}", facts.when_absent()), FaultKind::kMended});
      SetNumber(facts.when_absent(), field, message);
    } else if (!field.has_optional_keyword() && field.cpp_type() != FieldDescriptor::CPPTYPE_BOOL) {
      Wrong(path, fmt::format("is missing; {} would be right", RightFor(field, choices_)));
    }
  }

  void ReadList(const json& value, const FieldDescriptor& field, const std::string& path, ProtoMessage& message) {
    const model::v1::FieldFacts& facts = FactsOf(field);
    const bool plain = value.is_array() && !facts.line();
    const json made = plain ? json() : ElementsOf(value, field, choices_);
    const json& list = plain ? value : made;
    const int most = facts.max_items() > 0 ? facts.max_items() : kMostItems;
    const int count = static_cast<int>(list.size());
    if (count < facts.min_items()) {
      Wrong(path, fmt::format("has {}; at least {}", Counted(count, "element"), facts.min_items()));
    } else if (count > most) {
      faults_.push_back(
          {path, fmt::format("has {} elements; at most {}, the first are taken", count, most), FaultKind::kDoubtful});
    }
    for (int i = 0; i < std::min(count, most); ++i) {
      const std::string element = fmt::format("{}[{}]", path, i);
      if (field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) {
        ReadMessage(list[static_cast<size_t>(i)], element, *message.GetReflection()->AddMessage(&message, &field));
      } else {
        ReadScalar(list[static_cast<size_t>(i)], field, element, message);
      }
    }
  }

  void ReadScalar(const json& value, const FieldDescriptor& field, const std::string& path, ProtoMessage& message) {
    if (const json* const plain = PlainValueOf(value, field)) return ReadScalar(*plain, field, path, message);
    // One value in a list is that value.
    if (value.is_array() && value.size() == 1 && !value[0].is_structured() && !FactsOf(field).notation()) {
      return ReadScalar(value[0], field, path, message);
    }
    switch (field.cpp_type()) {
      case FieldDescriptor::CPPTYPE_STRING:
        SetText(ReadText(value, field, path), field, message);
        break;
      case FieldDescriptor::CPPTYPE_ENUM:
        SetEnum(ReadText(value, field, path), field, message);
        break;
      case FieldDescriptor::CPPTYPE_BOOL:
        SetBool(ReadBool(value, field, path), field, message);
        break;
      default:
        if (SaysNothing(value) && (field.has_optional_keyword() || FactsOf(field).has_when_absent())) {
          ReadNothing(field, path, message);
        } else {
          SetNumber(ReadNumber(value, field, path, bare_unit_, faults_), field, message);
        }
    }
  }

  std::string ReadText(const json& value, const FieldDescriptor& field, const std::string& path) {
    const auto wrong = [&] {
      Wrong(path, fmt::format("is {}; {} would be right", Shown(value), RightFor(field, choices_)));
      return std::string();
    };
    const bool notation = FactsOf(field).notation();
    if (!value.is_string() && !value.is_number() && !notation) return wrong();
    std::string text = OneLine(value.is_string() ? value.get<std::string>()
                                                 : value.dump(-1, ' ', false, json::error_handler_t::replace));
    const FieldTexts texts(field, choices_);
    if (field.has_optional_keyword() && value.is_string() && SaysNothing(std::string_view(text)) &&
        !IsOneOf(text, texts)) {
      text.clear();
    }
    if (text.empty()) return field.has_optional_keyword() || notation ? text : wrong();
    if (texts.get() != nullptr) {
      std::optional<std::string> chosen = FindChoice(text, *texts.get());
      if (!chosen) chosen = FindChoiceWithin(text, *texts.get());
      if (!chosen && field.has_optional_keyword() && FactsOf(field).choices_size() > 0) {
        faults_.push_back(
            {path, fmt::format("is {}; {} would be right, taken as null", Shown(value), RightFor(field, choices_)),
             FaultKind::kMended});
        return "";
      }
      return chosen ? *chosen : wrong();
    }
    const int most = FactsOf(field).max_length() > 0 ? FactsOf(field).max_length() : kMostCharacters;
    if (CutTo(most, text)) {
      faults_.push_back({path, fmt::format("is longer than {} characters; cut there", most), FaultKind::kMended});
    }
    return text;
  }

  // Whether it is a choice as it stands: "none" may be one.
  static bool IsOneOf(const std::string& text, const FieldTexts& texts) {
    return texts.get() != nullptr && FindChoice(text, *texts.get());
  }

  bool ReadBool(const json& value, const FieldDescriptor& field, const std::string& path) {
    if (value.is_boolean()) return value.get<bool>();
    if (value.is_number()) return value.get<double>() != 0;
    const std::string word = value.is_string() ? Bare(value.get<std::string>()) : "";
    if (word == "true" || word == "yes" || word == "y" || word == "1") return true;
    if (word != "false" && word != "no" && word != "n" && word != "0") {
      Wrong(path, fmt::format("is {}; {} would be right", Shown(value), RightFor(field, choices_)));
    }
    return false;
  }

  static void SetText(const std::string& text, const FieldDescriptor& field, ProtoMessage& message) {
    const Reflection& reflection = *message.GetReflection();
    if (field.is_repeated()) {
      reflection.AddString(&message, &field, text);
    } else if (!text.empty()) {
      reflection.SetString(&message, &field, text);
    }
  }

  static void SetEnum(const std::string& name, const FieldDescriptor& field, ProtoMessage& message) {
    const int number = EnumNumber(*field.enum_type(), name);
    if (field.is_repeated()) {
      message.GetReflection()->AddEnumValue(&message, &field, number);
    } else if (number != 0) {
      message.GetReflection()->SetEnumValue(&message, &field, number);
    }
  }

  static void SetBool(bool value, const FieldDescriptor& field, ProtoMessage& message) {
    if (field.is_repeated()) {
      message.GetReflection()->AddBool(&message, &field, value);
    } else {
      message.GetReflection()->SetBool(&message, &field, value);
    }
  }

  static void SetNumber(std::optional<double> number, const FieldDescriptor& field, ProtoMessage& message) {
    // In a list a bad number keeps its place as 0.
    if (!number && !field.is_repeated()) return;
    SetNumberField(number.value_or(0), field, message);
  }

  const FieldChoices& choices_;
  // Of lengths without one, where the answer now is.
  const LengthUnit* bare_unit_;
  std::vector<Fault> faults_;
};

}  // namespace

std::vector<Fault> ReadJson(json value, const FieldChoices& choices, ProtoMessage& message,
                            const LengthUnit* bare_unit) {
  Reader reader(choices, bare_unit);
  reader.ReadRoot(AnswerRoot(std::move(value), *message.GetDescriptor()), message);
  return reader.TakeFaults();
}

ExtractedJson ExtractAnswer(std::string_view answer, const google::protobuf::Descriptor& type) {
  std::vector<std::string> keys;
  keys.reserve(static_cast<size_t>(type.field_count()));
  for (int i = 0; i < type.field_count(); ++i) keys.push_back(type.field(i)->name());
  return ExtractJson(answer, keys);
}

std::vector<Fault> ReadAnswer(std::string_view answer, const FieldChoices& choices, ProtoMessage& message,
                              const LengthUnit* bare_unit) {
  ExtractedJson extracted = ExtractAnswer(answer, *message.GetDescriptor());
  if (extracted.value.is_discarded()) {
    extracted.value = AnswerOfLines(answer, *message.GetDescriptor(), choices);
    if (extracted.value.is_discarded()) return std::move(extracted.faults);
    extracted.faults = {{"", "has lines instead of JSON", FaultKind::kMended}};
  }
  std::vector<Fault> faults = std::move(extracted.faults);
  for (Fault& fault : ReadJson(std::move(extracted.value), choices, message, bare_unit))
    faults.push_back(std::move(fault));
  return faults;
}

}  // namespace flair::llm
