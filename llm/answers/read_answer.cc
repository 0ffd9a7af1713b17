// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/read_answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "worker_runtime/text/counted.h"

namespace flair::llm {
namespace {

namespace pb = google::protobuf;
using ProtoMessage = pb::Message;
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

// A value as a fault shows it, short.
std::string Shown(const json& value) {
  if (value.is_string()) return Quoted(value.get_ref<const std::string&>());
  if (value.is_object()) return "an object";
  if (value.is_array()) return fmt::format("a list of {}", value.size());
  return value.dump();
}

std::string FieldNames(const pb::Descriptor& type) {
  std::string names;
  for (int i = 0; i < type.field_count(); ++i) names += (i > 0 ? ", " : "") + type.field(i)->name();
  return names;
}

// What an object has for a field: by its name, else by a name that is the same but for case, other characters and the
// unit, or one of its aliases. Null when there is nothing.
const json* FindMember(const json& object, const pb::FieldDescriptor& field) {
  if (const auto found = object.find(field.name()); found != object.end()) return &*found;
  const std::string& unit = FactsOf(field).unit();
  std::vector<std::string> names = {Bare(field.name())};
  if (!unit.empty() && field.name().ends_with("_" + unit)) {
    names.push_back(names.front().substr(0, names.front().size() - unit.size()));
  }
  for (const std::string& alias : FactsOf(field).aliases()) {
    names.push_back(Bare(alias));
    names.push_back(Bare(alias + unit));
  }
  for (const auto& [key, value] : object.items()) {
    if (std::ranges::find(names, Bare(key)) != names.end()) return &value;
  }
  return nullptr;
}

bool HasAnyMember(const json& value, const pb::Descriptor& type) {
  if (!value.is_object()) return false;
  for (int i = 0; i < type.field_count(); ++i) {
    if (FindMember(value, *type.field(i)) != nullptr) return true;
  }
  return false;
}

// The only list of a type; null when it has none or several.
const pb::FieldDescriptor* OnlyList(const pb::Descriptor& type) {
  const pb::FieldDescriptor* only = nullptr;
  for (int i = 0; i < type.field_count(); ++i) {
    if (!type.field(i)->is_repeated()) continue;
    if (only != nullptr) return nullptr;
    only = type.field(i);
  }
  return only;
}

// Length of what a line is about, from its first letter: names up to a colon, "s1, s2", else one name.
size_t FirstPartLength(std::string_view line) {
  const std::string_view names = line.substr(0, line.find(':'));
  const size_t last = names.find_last_not_of(" \t*])\"'`");
  const bool plain = std::ranges::all_of(names, [](unsigned char c) {
    return std::isalnum(c) != 0 ||
           std::string_view("_ ,+&*])\"'`\t").find(static_cast<char>(c)) != std::string_view::npos;
  });
  if (names.size() < line.size() && plain && last != std::string_view::npos) return last + 1;
  return std::min(line.find_first_of(" \t-*[]()\"'`:="), line.size());
}

// A line "s1: words" as the object that it stands for: the part before the colon is the type's first field, the rest
// the only element of its second. Marks of a list, quotes and brackets around the first part mean nothing.
json ObjectOfLine(std::string_view line, const pb::Descriptor& type) {
  line.remove_prefix(std::min(line.find_first_not_of(" \t-*[]()\"'`"), line.size()));
  const size_t end = FirstPartLength(line);
  const size_t rest = std::min(line.find_first_not_of(" \t:=*\"'`])", end), line.size());
  json object = json::object();
  object[type.field(0)->name()] = std::string(line.substr(0, end));
  object[type.field(1)->name()] = json::array({std::string(line.substr(rest))});
  return object;
}

class Reader {
 public:
  explicit Reader(const FieldChoices& choices) : choices_(choices) {}

  std::vector<Fault> TakeFaults() { return std::move(faults_); }

  // As ReadMessage, but an object with nothing of what was asked for is no answer.
  void ReadRoot(const json& value, ProtoMessage& message) {
    const pb::Descriptor& type = *message.GetDescriptor();
    if (!value.is_object() || HasAnyMember(value, type)) return ReadMessage(value, "", message);
    Wrong("", fmt::format("has none of what was asked for; an object with {} would be right", FieldNames(type)));
  }

 private:
  void Wrong(const std::string& path, std::string text) {
    faults_.push_back({path, std::move(text), FaultKind::kWrong});
  }
  void WrongValue(const std::string& path, const json& value, const pb::FieldDescriptor& field) {
    Wrong(path, fmt::format("is {}; {} would be right", Shown(value), RightFor(field, choices_)));
  }
  void Mended(const std::string& path, std::string text) {
    faults_.push_back({path, std::move(text), FaultKind::kMended});
  }
  void Doubtful(const std::string& path, std::string text) {
    faults_.push_back({path, std::move(text), FaultKind::kDoubtful});
  }

  void ReadMessage(const json& value, const std::string& path, ProtoMessage& message) {
    const pb::Descriptor& type = *message.GetDescriptor();
    if (!value.is_object()) {
      return Wrong(path, fmt::format("is {}; an object with {} would be right", Shown(value), FieldNames(type)));
    }
    for (int i = 0; i < type.field_count(); ++i) {
      const pb::FieldDescriptor& field = *type.field(i);
      const std::string at = path.empty() ? field.name() : path + "." + field.name();
      ReadField(FindMember(value, field), field, at, message);
    }
  }

  void ReadField(const json* member, const pb::FieldDescriptor& field, const std::string& path, ProtoMessage& message) {
    const bool absent = member == nullptr || member->is_null();
    if (field.is_repeated()) {
      ReadList(absent ? json::array() : *member, field, path, message);
    } else if (absent) {
      ReadNothing(field, path, message);
    } else if (field.cpp_type() == pb::FieldDescriptor::CPPTYPE_MESSAGE) {
      ReadMessage(*member, path, *message.GetReflection()->MutableMessage(&message, &field));
    } else {
      ReadScalar(*member, field, path, message);
    }
  }

  void ReadNothing(const pb::FieldDescriptor& field, const std::string& path, ProtoMessage& message) {
    const model::v1::FieldFacts& facts = FactsOf(field);
    if (facts.has_when_absent()) {
      Mended(path, fmt::format("is missing; taken as {}", facts.when_absent()));
      SetNumberField(facts.when_absent(), field, message);
    } else if (!field.has_optional_keyword() && field.cpp_type() != pb::FieldDescriptor::CPPTYPE_BOOL) {
      Wrong(path, fmt::format("is missing; {} would be right", RightFor(field, choices_)));
    }
  }

  void ReadList(const json& value, const pb::FieldDescriptor& field, const std::string& path, ProtoMessage& message) {
    const model::v1::FieldFacts& facts = FactsOf(field);
    if (value.is_string() && value.get_ref<const std::string&>().find('\n') != std::string::npos) {
      return Wrong(path, fmt::format("is {}; a list would be right", Shown(value)));
    }
    // One element alone is a list of it.
    const int count = value.is_array() ? static_cast<int>(value.size()) : 1;
    const int most = facts.max_items() > 0 ? facts.max_items() : kMostItems;
    if (count < facts.min_items()) {
      Wrong(path, fmt::format("has {}; at least {}", Counted(count, "element"), facts.min_items()));
    } else if (count > most) {
      Doubtful(path, fmt::format("has {} elements; at most {}, the first are taken", count, most));
    }
    for (int i = 0; i < std::min(count, most); ++i) {
      const json& element = value.is_array() ? value[static_cast<size_t>(i)] : value;
      const std::string at = fmt::format("{}[{}]", path, i);
      if (field.cpp_type() != pb::FieldDescriptor::CPPTYPE_MESSAGE) {
        ReadScalar(element, field, at, message);
        continue;
      }
      ProtoMessage& read = *message.GetReflection()->AddMessage(&message, &field);
      const bool line = facts.line() && element.is_string();
      ReadMessage(line ? ObjectOfLine(element.get_ref<const std::string&>(), *field.message_type()) : element, at,
                  read);
    }
  }

  void ReadScalar(const json& value, const pb::FieldDescriptor& field, const std::string& path, ProtoMessage& message) {
    const pb::Reflection& reflection = *message.GetReflection();
    if (field.cpp_type() == pb::FieldDescriptor::CPPTYPE_STRING) {
      const std::string text = ReadText(value, field, path);
      if (field.is_repeated()) {
        reflection.AddString(&message, &field, text);
      } else if (!text.empty()) {
        reflection.SetString(&message, &field, text);
      }
    } else if (field.cpp_type() == pb::FieldDescriptor::CPPTYPE_BOOL) {
      reflection.SetBool(&message, &field, ReadBool(value, field, path));
    } else if (const std::optional<double> number = ReadNumber(value, field, path); number || field.is_repeated()) {
      // In a list a bad number keeps its place as 0.
      SetNumberField(number.value_or(0), field, message);
    }
  }

  std::string ReadText(const json& value, const pb::FieldDescriptor& field, const std::string& path) {
    const bool notation = FactsOf(field).notation();
    std::string text;
    if (value.is_string() || value.is_number() || notation) {
      text = OneLine(value.is_string() ? value.get<std::string>()
                                       : value.dump(-1, ' ', false, json::error_handler_t::replace));
    }
    if (text.empty()) {
      const bool may_be_empty = notation || (field.has_optional_keyword() && value.is_string());
      if (!may_be_empty) WrongValue(path, value, field);
      return text;
    }
    if (const std::optional<Choices> texts = TextsOf(field, choices_)) {
      const std::optional<std::string> chosen = FindChoice(text, *texts);
      if (chosen) return *chosen;
      if (field.has_optional_keyword() && FactsOf(field).choices_size() > 0) {
        Mended(path, fmt::format("is {}; {} would be right, taken as null", Shown(value), RightFor(field, choices_)));
      } else {
        WrongValue(path, value, field);
      }
      return "";
    }
    const int most = FactsOf(field).max_length() > 0 ? FactsOf(field).max_length() : kMostCharacters;
    if (CutTo(most, text)) Mended(path, fmt::format("is longer than {} characters; cut there", most));
    return text;
  }

  bool ReadBool(const json& value, const pb::FieldDescriptor& field, const std::string& path) {
    if (value.is_boolean()) return value.get<bool>();
    const std::string word = value.is_string() ? Bare(value.get<std::string>()) : "";
    if (word != "true" && word != "false") WrongValue(path, value, field);
    return word == "true";
  }

  std::optional<double> ReadNumber(const json& value, const pb::FieldDescriptor& field, const std::string& path) {
    const std::string& unit = FactsOf(field).unit();
    std::optional<double> number;
    if (value.is_number()) number = value.get<double>();
    if (value.is_string()) number = ReadQuantity(value.get_ref<const std::string&>(), unit);
    const NumberRange range = RangeOf(field);
    const bool whole = !IsWhole(field) || (number && *number == std::floor(*number));
    if (number && std::isfinite(*number) && whole && *number >= range.least && *number <= range.most) return number;
    WrongValue(path, value, field);
    return std::nullopt;
  }

  const FieldChoices& choices_;
  std::vector<Fault> faults_;
};

// The object that a value means for an answer of that type: itself when it has any of the type's fields; the only
// object or list that it wraps, as {"answer": {...}} and [{...}] do; the elements of the type's only list. Else the
// value itself.
json AnswerRoot(json value, const pb::Descriptor& type) {
  constexpr int kMostWrappers = 3;
  const pb::FieldDescriptor* const list = OnlyList(type);
  for (int i = 0; i < kMostWrappers && value.is_structured() && !HasAnyMember(value, type); ++i) {
    const bool of_objects = list != nullptr && list->cpp_type() == pb::FieldDescriptor::CPPTYPE_MESSAGE;
    const auto is_element = [&](const json& item) {
      return (FactsOf(*list).line() && item.is_string()) || HasAnyMember(item, *list->message_type());
    };
    if (value.is_array() && of_objects && std::ranges::any_of(value, is_element)) {
      json root = json::object();
      root[list->name()] = std::move(value);
      return root;
    }
    const auto is_structured = [](const json& item) { return item.is_structured(); };
    if (std::ranges::count_if(value, is_structured) != 1) break;
    json inner = *std::ranges::find_if(value, is_structured);
    value = std::move(inner);
  }
  return value;
}

// ExtractJson with the fields of a type.
ExtractedJson ExtractAnswer(std::string_view answer, const pb::Descriptor& type) {
  std::vector<std::string> keys;
  for (int i = 0; i < type.field_count(); ++i) keys.push_back(type.field(i)->name());
  return ExtractJson(answer, keys);
}

}  // namespace

std::vector<Fault> ReadJson(json value, const FieldChoices& choices, ProtoMessage& message) {
  Reader reader(choices);
  reader.ReadRoot(AnswerRoot(std::move(value), *message.GetDescriptor()), message);
  return reader.TakeFaults();
}

std::vector<Fault> ReadAnswer(std::string_view answer, const FieldChoices& choices, ProtoMessage& message) {
  ExtractedJson extracted = ExtractAnswer(answer, *message.GetDescriptor());
  std::vector<Fault> faults = std::move(extracted.faults);
  if (extracted.value.is_discarded()) return faults;
  for (Fault& fault : ReadJson(std::move(extracted.value), choices, message)) faults.push_back(std::move(fault));
  return faults;
}

}  // namespace flair::llm
