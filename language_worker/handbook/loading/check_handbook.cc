// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <set>
#include <string_view>

#include "english/wordnet.h"
#include "flair/handbook/v1/references.pb.h"
#include "language_worker/handbook/loading/handbook_files.h"
#include "language_worker/handbook/reading/vocabulary.h"

namespace flair::language {
namespace {

namespace pb = google::protobuf;
using Lines = pb::TextFormat::ParseInfoTree;

// The entries that messages name, by the field of Handbook that holds them.
constexpr std::array<std::pair<std::string_view, std::string_view>, 7> kKinds = {{{"furniture", "furniture"},
                                                                                  {"archetypes", "archetype"},
                                                                                  {"themes", "theme"},
                                                                                  {"needs", "need"},
                                                                                  {"styles", "style"},
                                                                                  {"colours", "colour"},
                                                                                  {"general_rules", "general rule"}}};

class Checker {
 public:
  Checker(const std::vector<HandbookFile>& files, HandbookFindings& findings) : findings_(findings) {
    for (const HandbookFile& file : files) {
      for (const hb::Furniture& item : file.part.furniture()) {
        names_["furniture"].insert(item.name());
        names_["category"].insert(item.category());
        if (!file.overlay) names_["word for drawing"].insert(item.category());
        names_["material group of a piece"].insert(item.material_group());
        names_["zone"].insert(item.makes_zone().name());
      }
      const auto learn = [&](std::string_view kind, const auto& list) {
        for (const auto& item : list) names_[std::string(kind)].insert(item.name());
      };
      const auto learn_zones = [&](const hb::Changes& changes) { learn("zone", changes.zones()); };
      learn("archetype", file.part.archetypes());
      learn("need", file.part.needs());
      learn("style", file.part.styles());
      learn("colour", file.part.colours());
      for (const hb::NamedColour& colour : file.part.colours()) {
        names_["colour"].insert(colour.synonyms().begin(), colour.synonyms().end());
      }
      for (const hb::Archetype& room : file.part.archetypes()) learn("zone", room.zones());
      for (const hb::Need& need : file.part.needs()) learn_zones(need.changes());
      for (const hb::Theme& theme : file.part.themes()) learn_zones(theme.changes());
      for (const hb::Style& style : file.part.styles()) {
        for (const hb::MaterialChoice& material : style.materials()) names_["material group"].insert(material.group());
      }
    }
    names_["material group of a piece"].insert("");
    names_["host"] = names_["furniture"];
    names_["host"].insert({"wall", "ceiling", "floor", "window"});
    if (names_["archetype"].empty()) findings_.faults.push_back("the handbook has no archetype");
  }

  void Check(const HandbookFile& file) {
    file_ = &file;
    const pb::Reflection& reflection = *file.part.GetReflection();
    std::vector<const pb::FieldDescriptor*> fields;
    reflection.ListFields(file.part, &fields);
    for (const pb::FieldDescriptor* field : fields) {
      if (field->cpp_type() != pb::FieldDescriptor::CPPTYPE_MESSAGE) continue;
      for (int i = 0; i < reflection.FieldSize(file.part, field); ++i) Enter(*field, i);
    }
  }

 private:
  // One entry of a file.
  void Enter(const pb::FieldDescriptor& field, int index) {
    const pb::Message& entry = file_->part.GetReflection()->GetRepeatedMessage(file_->part, &field, index);
    line_ = LineOf(file_->lines.get(), field, index, 0);
    const auto kind = std::ranges::find(kKinds, field.name(), &std::pair<std::string_view, std::string_view>::first);
    const pb::FieldDescriptor* name_field = entry.GetDescriptor()->FindFieldByName("name");
    const std::string name = name_field == nullptr ? "" : entry.GetReflection()->GetString(entry, name_field);
    entry_ = kind == kKinds.end() ? std::string(field.name()) : fmt::format("{} \"{}\"", kind->second, name);
    if (name_field == nullptr) entry_ += fmt::format("[{}]", index);
    if (kind != kKinds.end()) {
      if (name.empty()) Fault(line_, "name", "is missing; every entry of this kind needs one");
      const std::string key = fmt::format("{} {}", file_->overlay ? FolderOf(file_->name) : "", entry_);
      const auto [there, fresh] = seen_.emplace(key, fmt::format("{}:{}", file_->name, line_ + 1));
      if (!fresh) Fault(line_, "name", fmt::format("is already defined in {}", there->second));
    }
    room_zones_.clear();
    if (field.message_type() == hb::Archetype::descriptor()) {
      for (const hb::ZoneSpec& zone : file_->part.archetypes(index).zones()) room_zones_.insert(zone.name());
    }
    owner_ = kind != kKinds.end() && kind->second == "furniture" ? name : "";
    Walk(entry, file_->lines->GetTreeForNested(&field, index), "");
  }

  static std::string FolderOf(const std::string& name) { return name.substr(0, name.rfind('/') + 1); }

  // Elements of a list in brackets share the place of the list.
  static int LineOf(const Lines* lines, const pb::FieldDescriptor& field, int index, int otherwise) {
    for (int i = index; lines != nullptr && i >= 0; --i) {
      const int line = lines->GetLocation(&field, field.is_repeated() ? i : -1).line;
      if (line >= 0) return line;
    }
    return otherwise;
  }

  void Walk(const pb::Message& message, const Lines* lines, const std::string& path) {
    const pb::Reflection& reflection = *message.GetReflection();
    const pb::Descriptor& type = *message.GetDescriptor();
    const int own_line = line_;
    for (int i = 0; i < type.field_count(); ++i) {
      const pb::FieldDescriptor& field = *type.field(i);
      if (field.options().GetExtension(hb::needed) && reflection.FieldSize(message, &field) == 0)
        Fault(line_, path + std::string(field.name()), "is empty");
    }
    CheckValues(message, path);
    std::vector<const pb::FieldDescriptor*> fields;
    reflection.ListFields(message, &fields);
    for (const pb::FieldDescriptor* field : fields) {
      const int count = field->is_repeated() ? reflection.FieldSize(message, field) : 1;
      for (int i = 0; i < count; ++i) {
        const std::string where =
            path + std::string(field->name()) + (field->is_repeated() ? fmt::format("[{}]", i) : "");
        line_ = LineOf(lines, *field, i, own_line);
        if (field->cpp_type() == pb::FieldDescriptor::CPPTYPE_MESSAGE) {
          const pb::Message& nested = field->is_repeated() ? reflection.GetRepeatedMessage(message, field, i)
                                                           : reflection.GetMessage(message, field);
          const Lines* tree =
              lines == nullptr ? nullptr : lines->GetTreeForNested(field, field->is_repeated() ? i : -1);
          Walk(nested, tree, where + ".");
        } else if (field->cpp_type() == pb::FieldDescriptor::CPPTYPE_STRING) {
          CheckText(*field, message,
                    field->is_repeated() ? reflection.GetRepeatedString(message, field, i)
                                         : reflection.GetString(message, field),
                    where);
        }
      }
      line_ = own_line;
    }
  }

  void CheckText(const pb::FieldDescriptor& field, const pb::Message& message, const std::string& text,
                 const std::string& where) {
    std::string kind = field.options().GetExtension(hb::names);
    if (kind.empty()) return;
    if (kind == "sentence") return CheckSentence(message, text, where);
    if (kind == "hex") {
      const bool good =
          text.size() == 7 && text[0] == '#' && text.find_first_not_of("0123456789abcdefABCDEF", 1) == text.npos;
      if (!good) Fault(line_, where, fmt::format("\"{}\" is not #RRGGBB", text));
      return;
    }
    if (kind == "meaning") {
      if (english::WordNet::Get().Find(text)) return;
      return Fault(line_, where,
                   fmt::format("WordNet has no sense \"{}\" of a noun; \"seat#3\" is the third of \"seat\"", text));
    }
    // Objects of a room stand in its own zones; those that needs and themes add, in any.
    if (kind == "zone" && !room_zones_.empty() && where.starts_with("bands")) kind = "zone of the room";
    const std::set<std::string>& known = kind == "zone of the room" ? room_zones_ : names_[kind];
    if (known.contains(text)) return;
    if (kind == "word for drawing") {
      findings_.notes.push_back(Place(line_, where) +
                                fmt::format(": no piece of the handbook is a \"{}\"; it is drawn as a labelled block{}",
                                            text, Meant(known, text)));
      return;
    }
    Fault(line_, where, fmt::format("there is no {} \"{}\"{}", kind, text, Meant(known, text)));
  }

  static std::string Meant(const std::set<std::string>& known, const std::string& text) {
    const auto meant = std::ranges::find_if(known, [&](const std::string& one) { return IsOneEditAway(one, text); });
    return meant == known.end() || meant->empty() ? "" : fmt::format("; did you mean \"{}\"?", *meant);
  }

  void CheckSentence(const pb::Message& message, const std::string& text, const std::string& where) {
    static const std::set<std::string, std::less<>> kPlaceholders = {
        "object", "objects",    "target",    "targets",   "front_m",         "sides_m", "back_m", "way_m",
        "side",   "other_side", "long_side", "room_side", "other_room_side", "corner",  "zone",   "count",
        "first",  "second",     "wall",      "seat",      "length"};
    for (std::size_t open = text.find('{'); open != std::string::npos; open = text.find('{', open + 1)) {
      const std::size_t close = text.find('}', open);
      const std::string name = text.substr(open + 1, close == std::string::npos ? close : close - open - 1);
      if (close != std::string::npos && kPlaceholders.contains(name)) continue;
      Fault(line_, where,
            fmt::format("{{{}}} is not a placeholder; expected one of {{{}}}", name, fmt::join(kPlaceholders, "}, {")));
    }
    if (!file_->last) return;
    SentenceTemplate sentence{Place(line_, where), text, owner_, ""};
    if (const auto* relation = dynamic_cast<const hb::Relation*>(&message)) {
      if (!relation->object().empty()) sentence.object = relation->object();
      if (relation->targets_size() > 0) sentence.target = relation->targets(0);
    } else if (const auto* entry = dynamic_cast<const hb::ObjectEntry*>(&message)) {
      sentence.object = entry->furniture();
      if (entry->hosts_size() > 0) sentence.target = entry->hosts(0);
    }
    findings_.sentences.push_back(std::move(sentence));
  }

  // Sizes, conditions and sentences as wholes.
  void CheckValues(const pb::Message& message, const std::string& path) {
    if (const auto* extent = dynamic_cast<const hb::Extent*>(&message)) {
      const double low = extent->min() > 0 ? extent->min() : extent->typical();
      const double high = extent->max() > 0 ? extent->max() : extent->typical();
      const bool good = extent->typical() > 0 && low <= extent->typical() && extent->typical() <= high && high <= 20;
      if (good) return;
      Fault(line_, path,
            fmt::format("{} (min {}, max {}) must be above 0, in order, and at most 20 m", extent->typical(),
                        extent->min(), extent->max()));
    } else if (const auto* condition = dynamic_cast<const hb::Condition*>(&message)) {
      const auto in_order = [](double least, double most) { return least >= 0 && (most == 0 || least <= most); };
      if (!in_order(condition->min_area_m2(), condition->max_area_m2()))
        Fault(line_, path, "min_area_m2 is above max_area_m2");
      if (!in_order(condition->min_count(), condition->max_count())) Fault(line_, path, "min_count is above max_count");
      if (condition->chance() < 0 || condition->chance() > 1) Fault(line_, path, "chance must be in (0, 1]");
    } else if (const auto* relation = dynamic_cast<const hb::Relation*>(&message)) {
      if (relation->text().empty()) Fault(line_, path, "a sentence is empty");
    } else if (const auto* piece = dynamic_cast<const hb::Furniture*>(&message)) {
      for (const auto& [name, set] :
           {std::pair("width_m", piece->has_width_m()), std::pair("depth_m", piece->has_depth_m()),
            std::pair("height_m", piece->has_height_m())}) {
        if (!set) Fault(line_, name, "is missing; width_m, depth_m and height_m are needed");
      }
    } else if (const auto* room = dynamic_cast<const hb::Archetype*>(&message)) {
      if (!room->has_width_m() || !room->has_depth_m()) Fault(line_, "width_m", "width_m and depth_m are needed");
    }
  }

  std::string Place(int line, const std::string& field) const {
    std::string path = field;
    if (path.ends_with('.')) path.pop_back();
    return fmt::format("{}:{}: {}{}{}", file_->name, line + 1, entry_, path.empty() ? "" : ": ", path);
  }

  void Fault(int line, const std::string& field, const std::string& text) {
    findings_.faults.push_back(fmt::format("{}: {}", Place(line, field), text));
  }

  HandbookFindings& findings_;
  const HandbookFile* file_ = nullptr;
  std::map<std::string, std::set<std::string>, std::less<>> names_;  // by kind
  std::map<std::string, std::string> seen_;                          // where an entry stands, by folder, kind and name
  // Of the entry that is being checked.
  std::string entry_;
  std::string owner_;  // its class, where it is one
  std::set<std::string> room_zones_;
  int line_ = 0;
};

}  // namespace

void CheckFiles(const std::vector<HandbookFile>& files, HandbookFindings& findings) {
  Checker checker(files, findings);
  for (const HandbookFile& file : files) checker.Check(file);
}

}  // namespace flair::language
