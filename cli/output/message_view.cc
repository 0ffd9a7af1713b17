// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/message_view.h"

#include <google/protobuf/duration.pb.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "absl/strings/ascii.h"
#include "absl/strings/str_replace.h"
#include "cli/output/artifact_text.h"
#include "cli/output/text.h"
#include "flair/v1/style_sheet.pb.h"
#include "fmt/format.h"
#include "fmt/ranges.h"

namespace flair::cli {
namespace {

namespace pb = google::protobuf;

constexpr size_t kMostColumns = 120;
constexpr int kNameWidth = 11;

constexpr Unit kUnits[] = {
    {"_m", " m", 1, 2},       {"_m2", " m2", 1, 2},     {"_m3", " m3", 1, 3}, {"_rad", "°", 180 / std::numbers::pi, 1},
    {"_percent", " %", 1, 2}, {"_share", " %", 100, 1}, {"_px", " px", 1, 1}, {"", "", 1, 3}};

// Fields whose names are no words for people.
const std::map<std::string_view, std::string_view> kNames = {
    {"theta_rad", "heading"}, {"oob_percent", "OOB"}, {"oor_percent", "OOR"}, {"swing_angle_rad", "opens"}};

// Columns that would be longer than what they tell.
const std::set<std::string_view> kHidden = {"flair.v1.Object.description", "flair.v1.Object.placement",
                                            "flair.v1.EdgeOutcome.cost"};

bool IsMessage(const pb::FieldDescriptor& field) { return field.cpp_type() == pb::FieldDescriptor::CPPTYPE_MESSAGE; }

bool IsList(const pb::FieldDescriptor& field) { return field.is_repeated() && IsMessage(field); }

// Whether there is a list of messages in it: too much for a line.
bool HoldsLists(const pb::Descriptor& type) {
  for (int i = 0; i < type.field_count(); ++i) {
    if (IsList(*type.field(i)) && type.name() != "Polygon") return true;
  }
  return false;
}

bool IsSet(const pb::Message& message, const pb::FieldDescriptor& field) {
  return field.is_repeated() ? message.GetReflection()->FieldSize(message, &field) > 0
                             : message.GetReflection()->HasField(message, &field);
}

// Numbers with the digits of their unit for a column, else with as many as they need.
std::string NumberText(double value, const pb::FieldDescriptor& field, bool in_column) {
  const Unit& unit = UnitOf(field.name());
  const std::string_view sign = in_column && unit.sign != "°" ? "" : unit.sign;
  if (in_column && !unit.suffix.empty()) return fmt::format("{:.{}f}{}", value * unit.factor, unit.digits, sign);
  // What is less than a millionth is noise.
  return fmt::format("{:.4g}{}", std::abs(value) < 1e-6 ? 0.0 : value * unit.factor, sign);
}

std::string MessageInWords(const pb::Message& message) {
  if (const auto* colour = dynamic_cast<const v1::Colour*>(&message)) {
    return fmt::format("{}#{:02x}{:02x}{:02x}", colour->name().empty() ? "" : colour->name() + " ", colour->red() & 255,
                       colour->green() & 255, colour->blue() & 255);
  }
  if (const auto* point = dynamic_cast<const v1::Point2*>(&message)) {
    return fmt::format("({:.4g}, {:.4g})", point->x_m(), point->y_m());
  }
  if (const auto* polygon = dynamic_cast<const v1::Polygon*>(&message)) {
    std::string corners;
    for (const v1::Point2& vertex : polygon->vertices()) {
      corners += (corners.empty() ? "" : " ") + MessageInWords(vertex);
    }
    return Shortened(corners, 400);
  }
  if (const auto* duration = dynamic_cast<const pb::Duration*>(&message)) {
    return fmt::format("{:.3f} s", SecondsOf(*duration));
  }
  return FieldsInWords(message);
}

// One value, `index` -1 for the only one.
std::string OneValue(const pb::Message& message, const pb::FieldDescriptor& field, int index, bool in_column) {
  const auto& reflection = *message.GetReflection();
  const auto get = [&](auto one, auto item) {
    return index < 0 ? (reflection.*one)(message, &field) : (reflection.*item)(message, &field, index);
  };
  using Access = pb::Reflection;
  const std::string sign(in_column ? "" : UnitOf(field.name()).sign);
  switch (field.cpp_type()) {
    case pb::FieldDescriptor::CPPTYPE_DOUBLE:
      return NumberText(get(&Access::GetDouble, &Access::GetRepeatedDouble), field, in_column);
    case pb::FieldDescriptor::CPPTYPE_INT32:
      return fmt::format("{}{}", get(&Access::GetInt32, &Access::GetRepeatedInt32), sign);
    case pb::FieldDescriptor::CPPTYPE_INT64:
      return fmt::format("{}{}", get(&Access::GetInt64, &Access::GetRepeatedInt64), sign);
    case pb::FieldDescriptor::CPPTYPE_BOOL:
      return get(&Access::GetBool, &Access::GetRepeatedBool) ? "yes" : "";
    case pb::FieldDescriptor::CPPTYPE_ENUM: {
      const auto* value = get(&Access::GetEnum, &Access::GetRepeatedEnum);
      return value->number() == 0 ? "" : EnumInWords(*value);
    }
    case pb::FieldDescriptor::CPPTYPE_STRING: {
      const std::string text = get(&Access::GetString, &Access::GetRepeatedString);
      return field.type() == pb::FieldDescriptor::TYPE_BYTES ? fmt::format("{} bytes", text.size()) : text;
    }
    case pb::FieldDescriptor::CPPTYPE_MESSAGE:
      return MessageInWords(index < 0 ? reflection.GetMessage(message, &field)
                                      : reflection.GetRepeatedMessage(message, &field, index));
    default:
      return "";  // the protocol has no other types
  }
}

std::string Value(const pb::Message& message, const pb::FieldDescriptor& field, bool in_column) {
  if (field.is_repeated()) {
    std::vector<std::string> items;
    for (int i = 0; i < message.GetReflection()->FieldSize(message, &field); ++i) {
      items.push_back(OneValue(message, field, i, false));
    }
    return fmt::format("{}", fmt::join(items, ", "));
  }
  return field.has_presence() && !IsSet(message, field) ? "" : OneValue(message, field, -1, in_column);
}

bool IsNumber(const pb::FieldDescriptor& field) {
  return !field.is_repeated() && (field.cpp_type() == pb::FieldDescriptor::CPPTYPE_DOUBLE ||
                                  field.cpp_type() == pb::FieldDescriptor::CPPTYPE_INT32 ||
                                  field.cpp_type() == pb::FieldDescriptor::CPPTYPE_INT64);
}

std::string ColumnTitle(const pb::FieldDescriptor& field) {
  if (field.name() == "id") {
    const std::string& type = field.containing_type()->name();
    size_t word = type.size() - 1;  // the last one: "edge" of ConstraintEdge
    while (word > 0 && !absl::ascii_isupper(static_cast<unsigned char>(type[word]))) --word;
    return absl::AsciiStrToLower(type.substr(word));
  }
  const std::string_view sign = UnitOf(field.name()).sign;
  return (IsNumber(field) ? ">" : "") + NameInWords(field) + std::string(sign == "°" ? "" : sign);
}

// Rows that say the same of several pieces become one that counts them.
std::vector<std::vector<std::string>> Merged(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::vector<std::string>> merged;
  std::map<std::vector<std::string>, size_t> row_of;
  for (const std::vector<std::string>& row : rows) {
    const auto [found, is_new] = row_of.emplace(std::vector(row.begin() + 1, row.end()), merged.size());
    if (is_new) {
      merged.push_back(row);
      merged.back().insert(merged.back().begin() + 1, "1");
      continue;
    }
    std::vector<std::string>& first = merged[found->second];
    first[0] = first[0].substr(0, first[0].find(" … ")) + " … " + row[0];
    first[1] = std::to_string(std::stoi(first[1]) + 1);
  }
  return merged;
}

}  // namespace

const Unit& UnitOf(std::string_view field) {
  return *std::ranges::find_if(kUnits, [field](const Unit& unit) { return field.ends_with(unit.suffix); });
}

std::string NameInWords(const pb::FieldDescriptor& field) {
  const std::string_view name = field.name();
  if (const auto found = kNames.find(name); found != kNames.end()) return std::string(found->second);
  std::string words(name.substr(0, name.size() - UnitOf(name).suffix.size()));
  const auto end_with = [&words](std::string_view end, std::string_view instead) {
    if (!words.ends_with(end) || words.size() == end.size()) return;
    words = words.substr(0, words.size() - end.size()).append(instead);
  };
  end_with("_id", "");
  end_with("_ids", "s");
  end_with("_count", words.ends_with("ed_count") ? "" : "s");
  return absl::StrReplaceAll(words.empty() ? field.name() : words, {{"_", " "}});
}

std::string EnumInWords(const pb::EnumValueDescriptor& value) {
  std::string prefix;
  for (const char c : value.type()->name()) {
    if (absl::ascii_isupper(static_cast<unsigned char>(c)) && !prefix.empty()) prefix += '_';
    prefix += absl::ascii_toupper(static_cast<unsigned char>(c));
  }
  std::string name = value.name();
  if (name.starts_with(prefix + "_")) name = name.substr(prefix.size() + 1);
  return absl::StrReplaceAll(absl::AsciiStrToLower(name), {{"_", " "}});
}

std::string ValueInWords(const pb::Message& message, const pb::FieldDescriptor& field) {
  return Value(message, field, false);
}

std::string FieldsInWords(const pb::Message& message) {
  std::vector<std::string> parts;
  for (int i = 0; i < message.GetDescriptor()->field_count(); ++i) {
    const pb::FieldDescriptor& field = *message.GetDescriptor()->field(i);
    const std::string value = Value(message, field, false);
    if (!value.empty()) parts.push_back(fmt::format("{} {}", NameInWords(field), value));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

const pb::FieldDescriptor* NameField(const pb::Descriptor& type) {
  for (const char* name : {"id", "object_id", "edge_id", "zone_id", "subject_id", "instance_id", "name", "stage",
                           "step", "surface", "term", "code"}) {
    const pb::FieldDescriptor* field = type.FindFieldByName(name);
    if (field != nullptr && field->cpp_type() == pb::FieldDescriptor::CPPTYPE_STRING && !field->is_repeated())
      return field;
  }
  return nullptr;
}

std::string FieldLines(const pb::Message& message, const std::set<std::string>& but) {
  std::string text;
  for (int i = 0; i < message.GetDescriptor()->field_count(); ++i) {
    const pb::FieldDescriptor& field = *message.GetDescriptor()->field(i);
    const bool is_small = !IsMessage(field) || !HoldsLists(*field.message_type());
    const bool is_colours = IsList(field) && field.message_type() == v1::Colour::descriptor();
    if (but.contains(field.name()) || !is_small || (IsList(field) && !is_colours)) continue;
    if (!IsSet(message, field) && !IsNumber(field)) continue;
    const std::string value = Value(message, field, false);
    if (!value.empty()) text += fmt::format("{:<{}} {}\n", NameInWords(field), kNameWidth - 1, value);
  }
  return text;
}

Extent ExtentOf(const v1::Polygon& floor) {
  Extent extent;
  for (const v1::Point2& vertex : floor.vertices()) {
    extent.width_m = std::max(extent.width_m, vertex.x_m());
    extent.depth_m = std::max(extent.depth_m, vertex.y_m());
  }
  return extent;
}

std::string Heading(const std::string& title) { return "\n" + title + "\n"; }

std::string ListTable(const pb::Message& message, const std::string& list, const std::string& title, size_t most_rows,
                      const std::vector<ExtraColumn>& extra) {
  const pb::FieldDescriptor& field = *message.GetDescriptor()->FindFieldByName(list);
  const int size = message.GetReflection()->FieldSize(message, &field);
  if (size == 0) return "";
  const auto item = [&](int i) -> const pb::Message& {
    return message.GetReflection()->GetRepeatedMessage(message, &field, i);
  };
  std::vector<std::string> titles;
  std::vector<std::vector<std::string>> rows(static_cast<size_t>(size));
  for (int k = 0; k < field.message_type()->field_count(); ++k) {
    const pb::FieldDescriptor& column = *field.message_type()->field(k);
    bool is_any = false;
    for (int i = 0; i < size; ++i) is_any = is_any || IsSet(item(i), column);
    if (!is_any || IsList(column) || kHidden.contains(column.full_name())) continue;
    titles.push_back(ColumnTitle(column));
    for (int i = 0; i < size; ++i) {
      rows[static_cast<size_t>(i)].push_back(Shortened(Value(item(i), column, true), kMostColumns));
    }
  }
  for (const ExtraColumn& column : extra) {
    titles.push_back(column.title);
    for (int i = 0; i < size; ++i) rows[static_cast<size_t>(i)].push_back(column.cell(i));
  }
  if (field.message_type()->name() == "Object") {
    titles.insert(titles.begin() + 1, ">count");
    rows = Merged(rows);
  }
  Columns table(titles);
  for (std::vector<std::string>& row : rows) table.Add(std::move(row));
  return Heading(fmt::format("{}, {}", title, size)) + table.Text(most_rows);
}

std::string MessageText(const pb::Message& message, size_t most_rows) {
  std::string text = FieldLines(message);
  for (int i = 0; i < message.GetDescriptor()->field_count(); ++i) {
    const pb::FieldDescriptor& field = *message.GetDescriptor()->field(i);
    const std::string title = absl::AsciiStrToUpper(NameInWords(field));
    if (IsList(field) && field.message_type() != v1::Colour::descriptor()) {
      text += ListTable(message, field.name(), title, most_rows);
    } else if (IsMessage(field) && !field.is_repeated() && IsSet(message, field) && HoldsLists(*field.message_type())) {
      text += Heading(title) + MessageText(message.GetReflection()->GetMessage(message, &field), most_rows);
    }
  }
  return text;
}

}  // namespace flair::cli
