// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/explain/note_text.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "cli/explain/call_words.h"
#include "cli/explain/sentence_words.h"
#include "fmt/format.h"

namespace flair::cli {
namespace {

// A demand that many objects share is told once for all of them when as many hold it.
constexpr size_t kShared = 2;

std::string WithoutStop(std::string text) {
  while (!text.empty() && (text.back() == '.' || text.back() == ' ')) text.pop_back();
  return text;
}

std::string Sentence(const std::string& text) { return Capital(WithoutStop(text)) + "."; }

std::string Paragraph(const std::string& text, const NoteStyle& style) { return Wrapped(text, style.width, "") + "\n"; }

std::string Bullet(char mark, const std::string& text, const NoteStyle& style) {
  return fmt::format("  {} {}\n", mark, Wrapped(text, style.width - 4, "    "));
}

// "missed by 0.12 m", unless the shortfall says that figure itself.
std::string MissedBy(const Demand& demand) {
  if (!demand.missed_by) return "";
  const std::string figure = demand.unit == "deg" ? fmt::format("{:.0f} degrees", *demand.missed_by)
                                                  : fmt::format("{:.2f} {}", *demand.missed_by, demand.unit);
  return demand.shortfall.find(figure) == std::string::npos ? fmt::format(", which misses it by {}", figure) : "";
}

std::string HeldText(const Demand& demand) {
  const std::string what = WithoutStop(demand.about_it);
  return demand.reason.empty() ? what + "." : fmt::format("{}: {}.", what, WithoutStop(demand.reason));
}

std::string FailedText(const Demand& demand) {
  const std::string what = demand.text.empty() ? WithoutStop(demand.about_it) : WithoutStop(demand.text);
  const char* const word = demand.fate == DemandFate::kMissed    ? "Not met"
                           : demand.fate == DemandFate::kDropped ? "Left out of account"
                                                                 : "Not understood";
  std::string text = fmt::format("{}: \"{}.\"", word, what);
  if (!demand.shortfall.empty()) {
    text += fmt::format(" {}{}.", Capital(WithoutStop(demand.shortfall)), MissedBy(demand));
  }
  if (!demand.reason.empty()) text += fmt::format(" It was asked because: {}.", WithoutStop(demand.reason));
  return text;
}

// "It also has its back flush on a wall, blocks no door and stands in a corner."
std::string AlsoText(const std::vector<std::string>& abouts) {
  std::vector<std::string> parts;
  for (const std::string& about : abouts) parts.push_back(about.starts_with("It ") ? about.substr(3) : about);
  return fmt::format("It {}.", Joined(parts));
}

bool StartsWithIt(const Demand& demand) { return demand.about_it.starts_with("It "); }

std::string Introduction(const ObjectNote& object) {
  if (!object.placed) return Sentence(object.name + " is not placed");
  std::string text = fmt::format("{} {}.", Capital(object.name), object.standing);
  if (object.pinned) text += " The user put it there.";
  if (object.requested) text += " It was asked for.";
  return text;
}

using Skipped = std::set<std::string>;

std::string Key(const ObjectNote& object, const Demand& demand) {
  return object.id + "/" + (demand.sentence_id.empty() ? demand.edge_ids.front() : demand.sentence_id);
}

std::string DemandLines(const ObjectNote& object, const NoteStyle& style, const Skipped& told_elsewhere) {
  std::string lines;
  std::vector<std::string> plain;
  for (const Demand& demand : object.demands) {
    if (demand.fate != DemandFate::kHolds || told_elsewhere.contains(Key(object, demand))) continue;
    // What stands on or hangs above something says so in its first line.
    if (demand.reason.empty() && !style.all && object.role == "tertiary") continue;
    if (demand.reason.empty() && StartsWithIt(demand)) {
      plain.push_back(WithoutStop(demand.about_it));
    } else {
      lines += Bullet('-', HeldText(demand), style);
    }
  }
  if (!plain.empty()) lines += Bullet('-', AlsoText(plain), style);
  for (const Demand& demand : object.demands) {
    if (demand.fate != DemandFate::kHolds) lines += Bullet('!', FailedText(demand), style);
  }
  return lines;
}

std::string ObjectLines(const ObjectNote& object, const NoteStyle& style, const Skipped& told_elsewhere) {
  std::string text = Paragraph(Introduction(object), style) + DemandLines(object, style, told_elsewhere);
  if (object.placed && object.demands.empty()) {
    text += Bullet('-', "Nothing was asked of it: it stands where the others leave it room.", style);
  }
  if (!object.followers.empty()) {
    text += Bullet('-', fmt::format("From its place follows that of {}.", Joined(object.followers)), style);
  }
  for (const std::string& remark : object.remarks) text += Bullet('!', Sentence(remark), style);
  return text;
}

// What several objects are asked for one and the same reason, told once: by reason, the objects that hold it.
std::string SharedLines(const LayoutNote& note, const NoteStyle& style, Skipped& told) {
  using Place = std::pair<const ObjectNote*, const Demand*>;
  std::vector<std::pair<std::string, std::vector<Place>>> by_reason;
  for (const ZoneNote& zone : note.zones) {
    for (const ObjectNote& object : zone.objects) {
      for (const Demand& demand : object.demands) {
        const bool of_room = demand.types.size() == 1 && demand.types.front() == "clear_of_feature";
        if (!of_room || demand.fate != DemandFate::kHolds || demand.reason.empty()) continue;
        const auto known = std::find_if(by_reason.begin(), by_reason.end(),
                                        [&](const auto& entry) { return entry.first == demand.reason; });
        if (known != by_reason.end()) {
          known->second.emplace_back(&object, &demand);
        } else {
          by_reason.push_back({demand.reason, {{&object, &demand}}});
        }
      }
    }
  }
  std::string lines;
  for (const auto& [reason, places] : by_reason) {
    if (places.size() < kShared) continue;
    std::vector<std::string> names;
    for (const auto& [object, demand] : places) {
      names.push_back(object->name);
      told.insert(Key(*object, *demand));
    }
    lines +=
        Bullet('-', fmt::format("{}: {} keep out of the way.", Capital(WithoutStop(reason)), Joined(names)), style);
  }
  return lines;
}

std::string CountText(const LayoutNote& note) {
  const DemandCount count = CountDemands(note);
  if (count.all() == 0) return "Nothing was asked of its objects.";
  std::vector<std::string> wrong;
  if (count.missed > 0) wrong.push_back(fmt::format("{} not met", count.missed));
  if (count.dropped > 0) wrong.push_back(fmt::format("{} left out of account", count.dropped));
  if (count.not_understood > 0) wrong.push_back(fmt::format("{} not understood", count.not_understood));
  if (wrong.empty()) return fmt::format("All {} demands hold.", count.all());
  return fmt::format("Of {} demands {} hold; {} (marked \"!\").", count.all(), count.held, Joined(wrong));
}

std::string ListText(const char* title, const std::vector<std::string>& items, const NoteStyle& style) {
  if (items.empty()) return "";
  std::string text = fmt::format("\n{}\n", title);
  for (const std::string& item : items) text += Bullet('-', Sentence(item), style);
  return text;
}

std::string ZoneTitle(const ZoneNote& zone) {
  if (zone.id.empty()) return "\nTHE WHOLE ROOM\n";
  std::string name = zone.name;
  for (char& c : name) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return fmt::format("\n{}{}{}\n", name, zone.purpose.empty() ? "" : " - ", WithoutStop(zone.purpose));
}

}  // namespace

std::string NoteText(const LayoutNote& note, const NoteStyle& style) {
  std::string text = Paragraph(note.room + " " + CountText(note), style);
  Skipped told;
  if (!style.all) {
    const std::string shared = SharedLines(note, style, told);
    if (!shared.empty()) text += "\nKEPT FREE\n" + shared;
  }
  for (const ZoneNote& zone : note.zones) {
    text += ZoneTitle(zone);
    for (const ObjectNote& object : zone.objects) text += ObjectLines(object, style, told);
  }
  if (!note.homeless.empty()) text += "\nOF NO OBJECT\n";
  for (const Demand& demand : note.homeless) {
    text += demand.fate == DemandFate::kHolds ? Bullet('-', HeldText(demand), style)
                                              : Bullet('!', FailedText(demand), style);
  }
  text += ListText("LEFT OUT", note.left_out, style);
  text += ListText("CANNOT HOLD TOGETHER", note.clashes, style);
  return text + ListText("REMARKS", note.remarks, style);
}

absl::StatusOr<const ObjectNote*> FindObject(const LayoutNote& note, const std::string& key) {
  std::string ids;
  const ObjectNote* by_name = nullptr;
  for (const ZoneNote& zone : note.zones) {
    for (const ObjectNote& object : zone.objects) {
      if (object.id == key) return &object;
      if (object.name == key || object.name == "the " + key) by_name = &object;
      ids += (ids.empty() ? "" : ", ") + object.id;
    }
  }
  if (by_name != nullptr) return by_name;
  return absl::NotFoundError(fmt::format("--object: \"{}\" is not in the layout; it has {}", key, ids));
}

std::string ObjectText(const ObjectNote& object, const NoteStyle& style) {
  return ObjectLines(object, {true, style.width}, {});
}

}  // namespace flair::cli
