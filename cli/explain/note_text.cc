// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/explain/note_text.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "cli/explain/call_words.h"
#include "cli/explain/sentence_words.h"
#include "cli/output/text.h"
#include "fmt/format.h"
#include "worker_runtime/text/counted.h"

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

// ", which misses it by 0.12 m", unless the shortfall says that figure itself.
std::string MissedBy(const Demand& demand) {
  if (!demand.missed_by) return "";
  const std::string figure = demand.unit == "deg" ? fmt::format("{:.0f} degrees", *demand.missed_by)
                                                  : fmt::format("{:.2f} {}", *demand.missed_by, demand.unit);
  return demand.shortfall.find(figure) == std::string::npos ? fmt::format(", {} short of it", figure) : "";
}

// "the desk is 0.92 m from the window, at most 0.50 m" says what is right after the comma.
std::string ShortfallText(const Demand& demand) {
  std::string text = Capital(WithoutStop(demand.shortfall));
  for (const std::string_view limit : {", at most ", ", at least ", ", not "}) {
    const size_t at = text.rfind(limit);
    if (at == std::string::npos) continue;
    return fmt::format("{}; asked was {}{}.", text.substr(0, at), text.substr(at + 2), MissedBy(demand));
  }
  return fmt::format("{}{}.", text, MissedBy(demand));
}

std::string HeldText(const Demand& demand) {
  const std::string what = WithoutStop(demand.about_it);
  return demand.reason.empty() ? what + "." : fmt::format("{}: {}.", what, WithoutStop(demand.reason));
}

std::string FailedText(const Demand& demand) {
  const char* const word = demand.fate == DemandFate::kMissed    ? "Not met"
                           : demand.fate == DemandFate::kDropped ? "Left out of account"
                                                                 : "Not understood";
  std::string text = demand.text.empty() ? fmt::format("{}: that it {}.", word, WithoutStop(demand.about_it).substr(3))
                                         : fmt::format("{}: \"{}.\"", word, WithoutStop(demand.text));
  if (!demand.shortfall.empty()) text += " " + ShortfallText(demand);
  if (!demand.reason.empty()) text += fmt::format(" It was asked because: {}.", WithoutStop(demand.reason));
  return text;
}

// "It keeps at least 0.50 m from the bed and the door, blocks no door and stands in a corner.": what is said of
// several is said once.
std::string AlsoText(const std::vector<std::string>& abouts) {
  std::vector<std::pair<std::string, std::vector<std::string>>> by_start;
  for (const std::string& about : abouts) {
    const std::string part = about.substr(3);
    const size_t from = part.find(" from ");
    const std::string start = from == std::string::npos ? part : part.substr(0, from + 5);
    const auto known = std::find_if(by_start.begin(), by_start.end(), [&](const auto& entry) {
      return from != std::string::npos && entry.first == start;
    });
    std::vector<std::string>& ends =
        known != by_start.end() ? known->second : by_start.emplace_back(start, std::vector<std::string>{}).second;
    if (from != std::string::npos) ends.push_back(part.substr(from + 6));
  }
  std::vector<std::string> parts;
  for (const auto& [start, ends] : by_start)
    parts.push_back(ends.empty() ? start : fmt::format("{} {}", start, Joined(ends)));
  return fmt::format("It {}.", Joined(parts));
}

bool StartsWithIt(const Demand& demand) { return demand.about_it.starts_with("It "); }

// "the curtains", "candles 6", not "the glass".
bool IsPlural(std::string_view name) {
  while (!name.empty() && (name.back() == ' ' || (name.back() >= '0' && name.back() <= '9'))) name.remove_suffix(1);
  return name.ends_with("s") && !name.ends_with("ss") && !name.ends_with("us") && !name.ends_with("is");
}

// "stands on the desk" of several: "stand on the desk".
std::string InPlural(const std::string& verb_first) {
  const size_t verb = verb_first.find(' ');
  if (verb == std::string::npos || verb == 0 || verb_first[verb - 1] != 's') return verb_first;
  return verb_first.substr(0, verb - 1) + verb_first.substr(verb);
}

std::string Introduction(const ObjectNote& object) {
  const bool plural = IsPlural(object.name);
  if (!object.placed) return Sentence(fmt::format("{} {} not placed", object.name, plural ? "are" : "is"));
  std::string text = fmt::format("{} {}.", Capital(object.name), plural ? InPlural(object.standing) : object.standing);
  if (object.pinned) text += " The user put it there.";
  if (object.requested) text += " It was asked for.";
  return text;
}

using Skipped = std::set<std::string>;

// What is asked of a group and not met is told in full of the first one only: ids of those sentences, with its name.
using FirstTold = std::map<std::string, std::string>;

std::string FailedLine(const ObjectNote& object, const Demand& demand, const NoteStyle& style, FirstTold& first_told) {
  const bool told = !demand.sentence_id.empty() && !first_told.try_emplace(demand.sentence_id, object.name).second;
  if (!told) return Bullet('!', FailedText(demand), style);
  return Bullet(
      '!', fmt::format("Not met either, see {}: \"{}.\"", first_told[demand.sentence_id], WithoutStop(demand.text)),
      style);
}

std::string Key(const ObjectNote& object, const Demand& demand) {
  return object.id + "/" + (demand.sentence_id.empty() ? demand.edge_ids.front() : demand.sentence_id);
}

std::string DemandLines(const ObjectNote& object, const NoteStyle& style, const Skipped& told_elsewhere,
                        FirstTold& first_told) {
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
    if (demand.fate != DemandFate::kHolds) lines += FailedLine(object, demand, style, first_told);
  }
  return lines;
}

std::string ObjectLines(const ObjectNote& object, const NoteStyle& style, const Skipped& told_elsewhere,
                        FirstTold& first_told) {
  std::string text = Paragraph(Introduction(object), style) + DemandLines(object, style, told_elsewhere, first_told);
  if (object.placed && object.demands.empty()) {
    text += Bullet('-', "Nothing was asked of it: it stands where the others leave it room.", style);
  }
  if (!object.followers.empty()) {
    text += Bullet('-', fmt::format("Its place decides that of {}.", Joined(object.followers)), style);
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
  if (wrong.empty())
    return count.all() == 1 ? "Its one demand holds." : fmt::format("All {} demands hold.", count.all());
  return fmt::format("Of {} {}; {} (marked \"!\").", Counted(count.all(), "demand"),
                     Counted(count.held, "holds", "hold"), Joined(wrong));
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
  FirstTold first_told;
  if (!style.all) {
    const std::string shared = SharedLines(note, style, told);
    if (!shared.empty()) text += "\nKEPT FREE\n" + shared;
  }
  for (const ZoneNote& zone : note.zones) {
    text += ZoneTitle(zone);
    for (const ObjectNote& object : zone.objects) text += ObjectLines(object, style, told, first_told);
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
  FirstTold first_told;
  return ObjectLines(object, {true, style.width}, {}, first_told);
}

}  // namespace flair::cli
