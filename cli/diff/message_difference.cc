// SPDX-License-Identifier: GPL-3.0-or-later
#include <google/protobuf/duration.pb.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/str_replace.h"
#include "absl/strings/str_split.h"
#include "cli/diff/difference.h"
#include "cli/output/artifact_text.h"
#include "cli/output/message_view.h"
#include "cli/output/text.h"
#include "flair/v1/style_sheet.pb.h"
#include "fmt/format.h"
#include "fmt/ranges.h"

namespace flair::cli {
namespace {

namespace pb = google::protobuf;

// How items of a list are compared that has a section of its own.
struct Rule {
  std::string type;
  // Fields that together say which one an item is: ids first, then what tells the same thing of another id.
  std::vector<std::string> keys;
  // Fields that it is called by, and one that follows in brackets.
  std::string subject;
  std::string aside = {};
  // Said of an item that only one side has.
  std::string facts = {};
  std::set<std::string> ignored = {};
};

const std::vector<Rule>& Rules() {
  static const std::vector<Rule> rules = {
      {"Opening", {"id"}, "id", "", "wall offset_m width_m"},
      {"Socket", {"id"}, "id", "", "wall offset_m"},
      {"Zone", {"id"}, "id", "", "purpose"},
      // Other ids for the same things are no difference.
      {"Object", {"id", "name kind zone_id", "name kind"}, "id", "name", "width_m depth_m height_m zone_id"},
      {"Omission", {"name"}, "name", "", "reason"},
      {"SurfaceStyle", {"surface"}, "surface", "", "material"},
      {"ObjectStyle", {"subject_id"}, "subject_id", "", "material"},
      // Which number a sentence has says nothing when it says the same.
      {"Sentence", {"text", "id"}, "id text", "", "", {"id", "made_from_ids"}},
      {"Placement", {"object_id"}, "object_id", "", "x_m y_m"},
      {"StageTiming", {"stage"}, "stage"},
      {"StageOutcome", {"stage zone_id"}, "stage zone_id", "", "restart_count"},
      {"TermOutcome", {"term"}, "term"},
  };
  return rules;
}

// Titles of sections that are not the name of the list or the type.
const std::map<std::string_view, const char*> kTitles = {
    {"flair.v1.ObjectList.omissions", "left out"},
    {"flair.v1.StyleSheet.objects", "looks"},
    {"flair.v1.LayoutGraph.pinned_placements", "pinned"},
    {"flair.v1.Report.stage_timings", "times"},
    {"flair.v1.SolvedLayout.stage_outcomes", "stages of the solve"},
    {"flair.v1.ConstraintList", "cleaning"},
    {"flair.v1.StyleSheet", "style"},
    {"flair.v1.LayoutGraph", "catalogue"},
    {"flair.v1.Preview", "picture"}};

template <typename Descriptor>
std::string TitleOf(const Descriptor& what, const std::string& otherwise) {
  const auto found = kTitles.find(what.full_name());
  return found == kTitles.end() ? otherwise : found->second;
}

// Compared elsewhere, or by what follows from them.
const std::set<std::string_view> kSkipped = {"diagnostics", "walls", "edges"};

const Rule* RuleFor(const pb::FieldDescriptor& field) {
  if (!field.is_repeated() || field.message_type() == nullptr) return nullptr;
  const auto found = std::ranges::find(Rules(), field.message_type()->name(), &Rule::type);
  return found == Rules().end() ? nullptr : &*found;
}

// A message that has a section of its own, because it has lists of things.
bool IsPart(const pb::FieldDescriptor& field) {
  if (field.is_repeated() || field.message_type() == nullptr) return false;
  const pb::Descriptor& type = *field.message_type();
  for (int i = 0; i < type.field_count(); ++i) {
    if (RuleFor(*type.field(i)) != nullptr) return true;
  }
  return false;
}

const pb::Message& ItemOf(const pb::Message& message, const pb::FieldDescriptor& list, int i) {
  return message.GetReflection()->GetRepeatedMessage(message, &list, i);
}

std::vector<std::string> ValuesOf(const pb::Message& item, std::string_view fields) {
  std::vector<std::string> values;
  for (const auto piece : absl::StrSplit(std::string(fields), ' ', absl::SkipEmpty())) {
    const std::string name(piece);
    const pb::FieldDescriptor& field = *item.GetDescriptor()->FindFieldByName(name);
    const std::string value = ValueInWords(item, field);
    if (value.empty()) continue;
    const bool is_text = field.cpp_type() == pb::FieldDescriptor::CPPTYPE_STRING;
    values.push_back(is_text ? value : NameInWords(field) + " " + value);
  }
  return values;
}

std::string SubjectOf(const pb::Message& item, const Rule& rule) {
  std::string subject = fmt::format("{}", fmt::join(ValuesOf(item, rule.subject), " "));
  for (const std::string& aside : ValuesOf(item, rule.aside)) {
    if (aside != absl::StrReplaceAll(subject, {{"_", " "}})) subject += fmt::format(" ({})", aside);
  }
  return subject;
}

std::string FloorText(const v1::Polygon& floor) {
  const auto [width, depth] = ExtentOf(floor);
  return fmt::format("{:.2f} x {:.2f} m, {} corners", width, depth, floor.vertices_size());
}

std::string Quoted(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  return fmt::format("\"{}\"", Shortened(text, 71));
}

// Types that change as a whole.
bool IsWhole(const pb::Descriptor& type) {
  return &type == v1::Colour::descriptor() || &type == v1::Polygon::descriptor() || &type == pb::Duration::descriptor();
}

// What changed in one field, in words.
std::string ChangeInWords(const pb::Message& a, const pb::Message& b, const pb::FieldDescriptor& field,
                          const nlohmann::json& was, const nlohmann::json& is) {
  const auto arrow = [](const std::string& from, const std::string& to) {
    return fmt::format("{} -> {}", from.empty() ? "none" : from, to.empty() ? "none" : to);
  };
  const auto &of_a = *a.GetReflection(), &of_b = *b.GetReflection();
  if (field.is_repeated()) {
    if (field.message_type() == nullptr)
      return fmt::format("[{}] -> [{}]", ValueInWords(a, field), ValueInWords(b, field));
    return was.size() == is.size() ? fmt::format("{} others", was.size())
                                   : fmt::format("{} -> {}", was.size(), is.size());
  }
  switch (field.cpp_type()) {
    case pb::FieldDescriptor::CPPTYPE_DOUBLE:
      return NumberWords(field.name(), was, is);
    case pb::FieldDescriptor::CPPTYPE_BOOL:
      return of_b.GetBool(b, &field) ? "no -> yes" : "yes -> no";
    case pb::FieldDescriptor::CPPTYPE_STRING:
      if (field.type() != pb::FieldDescriptor::TYPE_BYTES) return arrow(Quoted(was), Quoted(is));
      return was == is ? fmt::format("other {}", was.get<std::string>()) : arrow(was, is);
    case pb::FieldDescriptor::CPPTYPE_MESSAGE:
      break;
    default:
      return arrow(ValueInWords(a, field), ValueInWords(b, field));
  }
  const pb::Message &from = of_a.GetMessage(a, &field), &to = of_b.GetMessage(b, &field);
  if (const auto* colour = dynamic_cast<const v1::Colour*>(&from)) {
    // By name; channels say something only where the names do not.
    const auto& other = static_cast<const v1::Colour&>(to);
    if (!colour->name().empty() && !other.name().empty() && colour->name() != other.name()) {
      return arrow(colour->name(), other.name());
    }
    const auto hex = [](const std::string& text) { return text.substr(std::min(text.find('#'), text.size())); };
    return arrow(hex(ValueInWords(a, field)), hex(ValueInWords(b, field)));
  }
  if (const auto* floor = dynamic_cast<const v1::Polygon*>(&from)) {
    const std::string extent = FloorText(*floor), other = FloorText(static_cast<const v1::Polygon&>(to));
    return extent == other ? "other corners" : arrow(extent, other);
  }
  return arrow(ValueInWords(a, field), ValueInWords(b, field));
}

nlohmann::json JsonOf(const pb::Message& message, const pb::FieldDescriptor& field) {
  const auto& reflection = *message.GetReflection();
  if (field.is_repeated()) {
    nlohmann::json list = nlohmann::json::array();
    for (int i = 0; i < reflection.FieldSize(message, &field); ++i) {
      if (field.message_type() != nullptr) {
        list.push_back(nlohmann::json::parse(ToJsonLine(ItemOf(message, field, i)), nullptr, false));
      } else {
        list.push_back(reflection.GetRepeatedString(message, &field, i));  // the protocol has no other lists
      }
    }
    return list;
  }
  switch (field.cpp_type()) {
    case pb::FieldDescriptor::CPPTYPE_DOUBLE:
      return reflection.GetDouble(message, &field);
    case pb::FieldDescriptor::CPPTYPE_INT32:
      return reflection.GetInt32(message, &field);
    case pb::FieldDescriptor::CPPTYPE_INT64:
      return reflection.GetInt64(message, &field);
    case pb::FieldDescriptor::CPPTYPE_BOOL:
      return reflection.GetBool(message, &field) ? "yes" : "no";
    default:
      return ValueInWords(message, field);
  }
}

struct FieldChange {
  std::string name;
  std::string words;
  nlohmann::json detail;
};

void CompareFields(const pb::Message& a, const pb::Message& b, const std::string& path, const std::string& words,
                   const std::set<std::string>& but, std::vector<FieldChange>& changes) {
  for (int i = 0; i < a.GetDescriptor()->field_count(); ++i) {
    const pb::FieldDescriptor& field = *a.GetDescriptor()->field(i);
    if (but.contains(field.name()) || kSkipped.contains(field.name()) || RuleFor(field) != nullptr || IsPart(field)) {
      continue;
    }
    const std::string name = words + NameInWords(field), here = path + field.name();
    if (!field.is_repeated() && field.message_type() != nullptr && !IsWhole(*field.message_type())) {
      CompareFields(a.GetReflection()->GetMessage(a, &field), b.GetReflection()->GetMessage(b, &field), here + ".",
                    name + " ", {}, changes);
      continue;
    }
    nlohmann::json was = JsonOf(a, field), is = JsonOf(b, field);
    const bool is_bytes = field.type() == pb::FieldDescriptor::TYPE_BYTES;
    const bool is_same =
        is_bytes ? a.GetReflection()->GetString(a, &field) == b.GetReflection()->GetString(b, &field) : was == is;
    if (is_same) continue;
    std::string change = ChangeInWords(a, b, field, was, is);
    changes.push_back({name, std::move(change), {{"field", here}, {"a", std::move(was)}, {"b", std::move(is)}}});
  }
}

}  // namespace

void AddSection(Section section, std::vector<Section>& sections) {
  if (section.changes.empty() && section.same_count == 0 && section.note.empty()) return;
  sections.push_back(std::move(section));
}

std::string NumberWords(const std::string& field, double a, double b) {
  const Unit& unit = UnitOf(field);
  for (int digits = unit.digits; digits < 12; ++digits) {
    const std::string of_a = fmt::format("{:.{}f}", a * unit.factor, digits);
    const std::string of_b = fmt::format("{:.{}f}", b * unit.factor, digits);
    if (of_a != of_b) return fmt::format("{} -> {}{}", of_a, of_b, unit.sign);
  }
  return fmt::format("{} -> {}{}", a * unit.factor, b * unit.factor, unit.sign);
}

Section FieldsSection(const std::string& title, const pb::Message& a, const pb::Message& b,
                      const std::set<std::string>& but) {
  std::vector<FieldChange> changes;
  CompareFields(a, b, "", "", but, changes);
  Section section{.title = title};
  for (FieldChange& change : changes) {
    section.changes.push_back({Became::kChanged, change.name, change.words, {{"fields", {std::move(change.detail)}}}});
  }
  return section;
}

void CompareThing(const std::string& subject, const pb::Message& a, const pb::Message& b,
                  const std::set<std::string>& but, Section& section) {
  std::vector<FieldChange> changes;
  CompareFields(a, b, "", "", but, changes);
  if (changes.empty()) return void(++section.same_count);
  Change all{Became::kChanged, subject, "", {{"fields", nlohmann::json::array()}}};
  for (FieldChange& change : changes) {
    // Other words for what has changed anyway.
    const bool repeats = changes.size() > 1 && change.name == "description";
    if (!repeats) all.words += fmt::format("{}{} {}", all.words.empty() ? "" : ", ", change.name, change.words);
    all.detail["fields"].push_back(std::move(change.detail));
  }
  section.changes.push_back(std::move(all));
}

void CompareLists(const pb::Message& a, const pb::Message& b, const std::string& list, std::vector<Section>& sections) {
  const pb::FieldDescriptor& field = *a.GetDescriptor()->FindFieldByName(list);
  const Rule& rule = *RuleFor(field);
  Section section{.title = TitleOf(field, NameInWords(field))};
  for (const Pair& pair : MatchItems(a, b, list)) {
    const pb::Message& item = pair.b < 0 ? ItemOf(a, field, pair.a) : ItemOf(b, field, pair.b);
    if (pair.a < 0 || pair.b < 0) {
      section.changes.push_back({pair.a < 0 ? Became::kAdded : Became::kRemoved,
                                 SubjectOf(item, rule),
                                 fmt::format("{}", fmt::join(ValuesOf(item, rule.facts), ", ")),
                                 {}});
    } else {
      CompareThing(SubjectOf(item, rule), ItemOf(a, field, pair.a), item, rule.ignored, section);
    }
  }
  AddSection(std::move(section), sections);
}

void CompareMessages(const pb::Message& a, const pb::Message& b, std::vector<Section>& sections) {
  const pb::Descriptor& type = *a.GetDescriptor();
  AddSection(FieldsSection(TitleOf(type, absl::AsciiStrToLower(type.name())), a, b), sections);
  for (int i = 0; i < type.field_count(); ++i) {
    const pb::FieldDescriptor& field = *type.field(i);
    if (RuleFor(field) != nullptr) CompareLists(a, b, field.name(), sections);
    if (IsPart(field)) {
      CompareMessages(a.GetReflection()->GetMessage(a, &field), b.GetReflection()->GetMessage(b, &field), sections);
    }
  }
}

std::vector<Pair> MatchKeys(const Keys& a, const Keys& b) {
  const int count_a = static_cast<int>(a.front().size()), count_b = static_cast<int>(b.front().size());
  std::vector<int> of_a(count_a, -1), of_b(count_b, -1);
  for (size_t round = 0; round < a.size(); ++round) {
    std::map<std::string_view, std::vector<int>> left;
    for (int j = count_b - 1; j >= 0; --j) {
      if (of_b[j] < 0) left[b[round][j]].push_back(j);
    }
    left.erase("");
    for (int i = 0; i < count_a; ++i) {
      const auto found = of_a[i] >= 0 ? left.end() : left.find(a[round][i]);
      if (found == left.end() || found->second.empty()) continue;
      of_a[i] = found->second.back();
      of_b[of_a[i]] = i;
      found->second.pop_back();
    }
  }
  std::vector<Pair> pairs;
  for (int i = 0; i < count_a; ++i) pairs.push_back({i, of_a[i]});
  for (int j = 0; j < count_b; ++j) {
    if (of_b[j] < 0) pairs.push_back({-1, j});
  }
  return pairs;
}

std::vector<Pair> MatchItems(const pb::Message& a, const pb::Message& b, const std::string& list) {
  const pb::FieldDescriptor& field = *a.GetDescriptor()->FindFieldByName(list);
  const Rule& rule = *RuleFor(field);
  const auto keys = [&](const pb::Message& message) {
    Keys all(rule.keys.size());
    for (size_t round = 0; round < rule.keys.size(); ++round) {
      for (int i = 0; i < message.GetReflection()->FieldSize(message, &field); ++i) {
        all[round].push_back(fmt::format("{}", fmt::join(ValuesOf(ItemOf(message, field, i), rule.keys[round]), "\n")));
      }
    }
    return all;
  };
  return MatchKeys(keys(a), keys(b));
}

}  // namespace flair::cli
