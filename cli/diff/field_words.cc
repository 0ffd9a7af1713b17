// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/diff/field_words.h"

#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

#include "cli/output/artifact_text.h"
#include "flair/v1/style_sheet.pb.h"
#include "fmt/format.h"

namespace flair::cli {

namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

constexpr size_t kMostLetters = 70;

// How numbers of a field are shown, by the end of its name.
struct Unit {
  std::string_view suffix;
  std::string_view sign;
  double factor;
  int digits;
};
constexpr Unit kUnits[] = {
    {"_m", " m", 1, 2},       {"_m2", " m2", 1, 2},     {"_m3", " m3", 1, 3}, {"_rad", "°", 180 / std::numbers::pi, 1},
    {"_percent", " %", 1, 2}, {"_share", " %", 100, 1}, {"", "", 1, 3}};

const Unit& UnitOf(std::string_view field) {
  for (const Unit& unit : kUnits) {
    if (field.ends_with(unit.suffix)) return unit;
  }
  return kUnits[std::size(kUnits) - 1];
}

// "head height" for head_height_m.
std::string NameInWords(std::string_view field) {
  std::string name(field.substr(0, field.size() - UnitOf(field).suffix.size()));
  if (name.empty()) name = field;
  for (char& c : name) {
    if (c == '_') c = ' ';
  }
  return name;
}

std::string Quoted(const std::string& text) {
  std::string cut;
  size_t letters = 0;
  for (const char c : text) {
    if ((static_cast<unsigned char>(c) & 0xC0) != 0x80 && ++letters > kMostLetters) return "\"" + cut + "...\"";
    cut += c == '\n' ? ' ' : c;
  }
  return "\"" + cut + "\"";
}

// OBJECT_KIND_FLOOR of ObjectKind: "floor".
std::string EnumInWords(const google::protobuf::EnumValueDescriptor& value) {
  std::string prefix;
  for (const char c : value.type()->name()) {
    if (c >= 'A' && c <= 'Z' && !prefix.empty()) prefix += '_';
    prefix += static_cast<char>(std::toupper(c));
  }
  std::string name = value.name();
  if (name.starts_with(prefix + "_")) name = name.substr(prefix.size() + 1);
  for (char& c : name) c = c == '_' ? ' ' : static_cast<char>(std::tolower(c));
  return name;
}

// Walks two messages of one type.
class Walk {
 public:
  void Compare(const Message& a, const Message& b, const std::string& path, const std::string& words,
               const std::set<std::string>& but) {
    for (int i = 0; i < a.GetDescriptor()->field_count(); ++i) {
      const FieldDescriptor& field = *a.GetDescriptor()->field(i);
      if (!but.contains(field.name())) CompareField(a, b, field, path + field.name(), words);
    }
  }
  struct Item {
    std::string name, words;
    nlohmann::json detail;
  };
  std::vector<Item> items;

 private:
  void Add(const std::string& path, const std::string& name, const std::string& words, nlohmann::json a,
           nlohmann::json b) {
    items.push_back({name, words, {{"field", path}, {"a", std::move(a)}, {"b", std::move(b)}}});
  }

  void CompareField(const Message& a, const Message& b, const FieldDescriptor& field, const std::string& path,
                    const std::string& words) {
    const std::string name = words + NameInWords(field.name());
    if (field.is_repeated()) return CompareList(a, b, field, path, name);
    const auto &of_a = *a.GetReflection(), &of_b = *b.GetReflection();
    switch (field.cpp_type()) {
      case FieldDescriptor::CPPTYPE_DOUBLE:
        return CompareNumbers(of_a.GetDouble(a, &field), of_b.GetDouble(b, &field), field, path, name);
      case FieldDescriptor::CPPTYPE_INT32:
        return CompareCounts(of_a.GetInt32(a, &field), of_b.GetInt32(b, &field), path, name);
      case FieldDescriptor::CPPTYPE_INT64:
        return CompareCounts(of_a.GetInt64(a, &field), of_b.GetInt64(b, &field), path, name);
      case FieldDescriptor::CPPTYPE_BOOL:
        return CompareTexts(of_a.GetBool(a, &field) ? "yes" : "no", of_b.GetBool(b, &field) ? "yes" : "no", path, name);
      case FieldDescriptor::CPPTYPE_ENUM:
        return CompareTexts(EnumInWords(*of_a.GetEnum(a, &field)), EnumInWords(*of_b.GetEnum(b, &field)), path, name);
      case FieldDescriptor::CPPTYPE_STRING:
        return CompareStrings(of_a.GetString(a, &field), of_b.GetString(b, &field), field, path, name);
      case FieldDescriptor::CPPTYPE_MESSAGE:
        if (field.message_type() == v1::Colour::descriptor()) {
          return CompareColours(static_cast<const v1::Colour&>(of_a.GetMessage(a, &field)),
                                static_cast<const v1::Colour&>(of_b.GetMessage(b, &field)), path, name);
        }
        return Compare(of_a.GetMessage(a, &field), of_b.GetMessage(b, &field), path + ".", name + " ", {});
      default:
        return;  // the contract has no other types
    }
  }

  void CompareNumbers(double a, double b, const FieldDescriptor& field, const std::string& path,
                      const std::string& name) {
    if (a != b) Add(path, name, NumberWords(field.name(), a, b), a, b);
  }
  void CompareCounts(int64_t a, int64_t b, const std::string& path, const std::string& name) {
    if (a != b) Add(path, name, fmt::format("{} -> {}", a, b), a, b);
  }
  void CompareTexts(const std::string& a, const std::string& b, const std::string& path, const std::string& name) {
    if (a != b) Add(path, name, fmt::format("{} -> {}", a, b), a, b);
  }
  // By name; channels say something only where the names do not.
  void CompareColours(const v1::Colour& a, const v1::Colour& b, const std::string& path, const std::string& name) {
    const auto hex = [](const v1::Colour& colour) {
      return fmt::format("#{:02x}{:02x}{:02x}", colour.red() & 255, colour.green() & 255, colour.blue() & 255);
    };
    const auto both = [&hex](const v1::Colour& colour) { return colour.name() + " " + hex(colour); };
    if (both(a) == both(b)) return;
    const bool named = !a.name().empty() && !b.name().empty() && a.name() != b.name();
    Add(path, name, fmt::format("{} -> {}", named ? a.name() : hex(a), named ? b.name() : hex(b)), both(a), both(b));
  }

  void CompareStrings(const std::string& a, const std::string& b, const FieldDescriptor& field, const std::string& path,
                      const std::string& name) {
    if (a == b) return;
    if (field.type() == FieldDescriptor::TYPE_BYTES) {
      return Add(path, name,
                 a.size() == b.size() ? fmt::format("{} other bytes", a.size())
                                      : fmt::format("{} -> {} bytes", a.size(), b.size()),
                 a.size(), b.size());
    }
    Add(path, name, fmt::format("{} -> {}", Quoted(a), Quoted(b)), a, b);
  }

  // Lists without names for their items: one line for all.
  void CompareList(const Message& a, const Message& b, const FieldDescriptor& field, const std::string& path,
                   const std::string& name) {
    const auto text = [&field](const Message& message) {
      nlohmann::json list = nlohmann::json::array();
      for (int i = 0; i < message.GetReflection()->FieldSize(message, &field); ++i) {
        if (field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) {
          list.push_back(nlohmann::json::parse(
              ToJsonLine(message.GetReflection()->GetRepeatedMessage(message, &field, i)), nullptr, false));
        } else if (field.cpp_type() == FieldDescriptor::CPPTYPE_STRING) {
          list.push_back(message.GetReflection()->GetRepeatedString(message, &field, i));
        }
      }
      return list;
    };
    const nlohmann::json of_a = text(a), of_b = text(b);
    if (of_a == of_b) return;
    const bool all_short = field.cpp_type() == FieldDescriptor::CPPTYPE_STRING;
    const auto shown = [all_short](const nlohmann::json& list) {
      if (!all_short) return fmt::format("{}", list.size());
      std::string items;
      for (const auto& item : list) items += (items.empty() ? "" : ", ") + item.get<std::string>();
      return "[" + items + "]";
    };
    const bool same_size = !all_short && of_a.size() == of_b.size();
    Add(path, name,
        same_size ? fmt::format("{} others", of_a.size()) : fmt::format("{} -> {}", shown(of_a), shown(of_b)), of_a,
        of_b);
  }
};

}  // namespace

std::string NumberWords(const std::string& field, double a, double b) {
  const Unit& unit = UnitOf(field);
  for (int digits = unit.digits; digits < 12; ++digits) {
    const std::string of_a = fmt::format("{:.{}f}", a * unit.factor, digits);
    const std::string of_b = fmt::format("{:.{}f}", b * unit.factor, digits);
    if (of_a != of_b) return fmt::format("{} -> {}{}", of_a, of_b, unit.sign);
  }
  return fmt::format("{} -> {}{}", a * unit.factor, b * unit.factor, unit.sign);
}

std::optional<FieldWords> ChangedFields(const Message& a, const Message& b, const std::set<std::string>& but) {
  Walk walk;
  walk.Compare(a, b, "", "", but);
  if (walk.items.empty()) return std::nullopt;
  FieldWords words{.words = "", .detail = {{"fields", nlohmann::json::array()}}};
  for (Walk::Item& item : walk.items) {
    // Other words for what has changed anyway.
    const bool repeats = walk.items.size() > 1 && item.name == "description";
    if (!repeats) words.words += fmt::format("{}{} {}", words.words.empty() ? "" : ", ", item.name, item.words);
    words.detail["fields"].push_back(std::move(item.detail));
  }
  return words;
}

Section FieldsSection(const std::string& title, const Message& a, const Message& b, const std::set<std::string>& but) {
  Walk walk;
  walk.Compare(a, b, "", "", but);
  Section section{.title = title};
  for (Walk::Item& item : walk.items) {
    section.changes.push_back({Became::kChanged, item.name, item.words, {{"fields", {std::move(item.detail)}}}});
  }
  return section;
}

}  // namespace flair::cli
