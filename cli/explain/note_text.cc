// SPDX-License-Identifier: GPL-3.0-or-later
// A note in words.
#include <algorithm>
#include <cctype>
#include <functional>
#include <map>
#include <string_view>
#include <vector>

#include "absl/strings/ascii.h"
#include "absl/strings/str_join.h"
#include "cli/explain/layout_note.h"
#include "cli/output/text.h"
#include "english/words.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "optimizer_worker/constraints/arguments.h"
#include "optimizer_worker/constraints/shortfall.h"
#include "room/geometry/gap.h"
#include "room/geometry/pose.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

// What a fate is called here.
const std::map<std::string_view, const char*> kFateWords = {{"missed", "violated"},
                                                            {"dropped", "not taken into account"},
                                                            {"not_understood", "not understood"},
                                                            {"not understood", "not understood"}};

std::string Text(const Note& note, const char* field) { return note.value(field, ""); }

std::string Sentence(const std::string& text) { return Capital(WithoutStop(text)) + "."; }

std::string Paragraph(const std::string& text, const NoteStyle& style) { return Wrapped(text, style.width, "") + "\n"; }

std::string Bullet(char mark, const std::string& text, const NoteStyle& style) {
  return fmt::format("  {} {}\n", mark, Wrapped(text, style.width - 4, "    "));
}

// ", 0.12 m short of it", unless the shortfall says that figure itself.
std::string MissedBy(const Note& demand) {
  if (!demand.contains("missed_by")) return "";
  const double missed_by = demand["missed_by"];
  const std::string figure = MeasureText(missed_by, Text(demand, "unit"));
  return Text(demand, "shortfall").find(figure) == std::string::npos ? fmt::format(", {} short of it", figure) : "";
}

// "the desk is 0.92 m from the window, at most 0.50 m" says what is right after the comma.
std::string ShortfallText(const Note& demand) {
  const std::string text = Capital(WithoutStop(Text(demand, "shortfall")));
  for (const std::string_view limit : {", at most ", ", at least ", ", not "}) {
    const size_t at = text.rfind(limit);
    if (at == std::string::npos) continue;
    return fmt::format("{}; required: {}{}.", text.substr(0, at), text.substr(at + 2), MissedBy(demand));
  }
  return fmt::format("{}{}.", text, MissedBy(demand));
}

// " [e12, e13]": its constraints, as `flair resolve --edit "drop e12"` takes them.
std::string IdsText(const Note& demand) {
  const std::vector<std::string> ids = demand["edge_ids"];
  return ids.empty() ? "" : fmt::format(" [{}]", fmt::join(ids, ", "));
}

bool Holds(const Note& demand) { return demand["fate"] == "holds"; }

// One demand of an object or of none.
std::string DemandLine(const Note& demand, const NoteStyle& style) {
  const std::string reason = WithoutStop(Text(demand, "reason")), about_it = demand["about_it"];
  const std::string ids = style.ids ? IdsText(demand) : "";
  if (Holds(demand)) {
    return Bullet('-', fmt::format("{}{}.{}", about_it, reason.empty() ? "" : ": " + reason, ids), style);
  }
  const std::string word = Capital(kFateWords.at(Text(demand, "fate")));
  std::string text = demand.contains("sentence") ? fmt::format("{}: \"{}.\"", word, about_it)
                                                 : fmt::format("{}: that it {}.", word, about_it.substr(3));
  if (demand.contains("shortfall")) text += " " + ShortfallText(demand);
  if (demand.contains("because")) text += fmt::format(" {}.", Capital(Text(demand, "because")));
  if (!reason.empty()) text += fmt::format(" Reason: {}.", reason);
  return Bullet('!', text + ids, style);
}

// "the curtains", "candles 6", not "the glass".
bool IsPlural(std::string_view name) {
  while (!name.empty() && (name.back() == ' ' || (name.back() >= '0' && name.back() <= '9'))) name.remove_suffix(1);
  return english::IsPlural(name.substr(name.rfind(' ') + 1));
}

// "stands on the desk" of several: "stand on the desk".
std::string InPlural(const std::string& verb_first) {
  const size_t verb = verb_first.find(' ');
  if (verb == std::string::npos || verb == 0 || verb_first[verb - 1] != 's') return verb_first;
  return verb_first.substr(0, verb - 1) + verb_first.substr(verb);
}

std::string Introduction(const Note& object) {
  const std::string name = object["name"];
  const bool plural = IsPlural(name);
  if (!object["placed"]) return Sentence(fmt::format("{} {} not placed", name, plural ? "are" : "is"));
  const std::string stands = object["stands"];
  std::string text = fmt::format("{} {}.", Capital(name), plural ? InPlural(stands) : stands);
  return object.contains("origin") ? fmt::format("{} {}", text, Text(object, "origin")) : text;
}

std::string ObjectLines(const Note& object, const NoteStyle& style) {
  std::string text = Paragraph(Introduction(object), style), failed;
  for (const Note& demand : object["demands"]) {
    // What stands on or hangs above something says so in its first line.
    const bool is_plain = !demand.contains("reason") && !style.all && object["role"] == "tertiary";
    if (!Holds(demand)) failed += DemandLine(demand, style);
    if (Holds(demand) && !is_plain) text += DemandLine(demand, style);
  }
  text += failed;
  if (object["placed"] && object["demands"].empty()) {
    text += Bullet('-', "No constraint concerns it: it stands where there is room.", style);
  }
  if (object.contains("followers")) {
    text += Bullet('-', fmt::format("Placed relative to it: {}.", Joined(object["followers"])), style);
  }
  for (const std::string remark : object.value("remarks", Note::array())) text += Bullet('!', Sentence(remark), style);
  return text;
}

std::string CountText(const Note& note) {
  int all = 0;
  std::vector<std::string> wrong;
  for (const auto& [fate, count] : note["demand_count"].items()) {
    all += count.get<int>();
    if (fate != "holds" && count > 0) wrong.push_back(fmt::format("{} {}", count.get<int>(), kFateWords.at(fate)));
  }
  if (all == 0) return "No constraint concerns its objects.";
  if (wrong.empty()) return all == 1 ? "Its one demand holds." : fmt::format("All {} demands hold.", all);
  return fmt::format("Of {} {}; {} (marked \"!\").", Counted(all, "demand"),
                     Counted(note["demand_count"]["holds"].get<int>(), "holds", "hold"), Joined(wrong));
}

// What is found where it cannot be, and how many uses are met.
std::string TruthText(const Note& note) {
  std::string text;
  int uses_missed = 0;
  if (note.contains("uses")) {
    const int asked = note["uses"]["asked"], met = note["uses"]["met"];
    uses_missed = asked - met;
    text = uses_missed == 0 ? fmt::format(" All {} met.", Counted(asked, "use is", "uses are"))
                            : fmt::format(" {} of {} met.", met, Counted(asked, "use is", "uses are"));
  }
  const int wrong = static_cast<int>(note.value("findings", Note::array()).size()) - uses_missed;
  if (wrong > 0) text += fmt::format(" {} where it cannot be.", Counted(wrong, "piece is", "pieces are"));
  return text;
}

std::string ListText(const char* title, const Note& items, const NoteStyle& style) {
  std::string text = items.empty() ? "" : fmt::format("\n{}\n", title);
  for (const std::string item : items) text += Bullet('-', Sentence(item), style);
  return text;
}

}  // namespace

std::string NoteText(const Note& note, const NoteStyle& style) {
  std::string text = Paragraph(Text(note, "room") + " " + CountText(note) + TruthText(note), style);
  for (const Note& zone : note["zones"]) {
    const std::string purpose = WithoutStop(Text(zone, "purpose"));
    text += fmt::format("\n{}{}{}\n", absl::AsciiStrToUpper(Text(zone, "name")), purpose.empty() ? "" : " - ", purpose);
    for (const Note& object : zone["objects"]) text += ObjectLines(object, style);
  }
  if (note.contains("demands_of_no_object")) {
    text += "\nOTHER DEMANDS\n";
    for (const Note& demand : note["demands_of_no_object"]) text += DemandLine(demand, style);
  }
  return text + ListText("LEFT OUT", note["left_out"], style) +
         ListText("CANNOT HOLD TOGETHER", note["clashes"], style) + ListText("REMARKS", note["remarks"], style);
}

std::string ObjectText(const Note& object, const NoteStyle& style) {
  return ObjectLines(object, {true, style.width, style.ids});
}

namespace {

using optimizer::Arguments;

std::string ObjectNames(const std::vector<int>& objects, const Scene& scene) {
  std::vector<std::string> names;
  for (const int object : objects) names.push_back(NameForPeople(scene, object));
  return Joined(names);
}

std::string ValueInWords(const v1::ParameterSpec& spec, const Arguments& arguments, const Scene& scene) {
  const std::string& name = spec.name();
  switch (spec.kind()) {
    case v1::PARAMETER_KIND_OBJECT:
      return ObjectNames({arguments.Object(name)}, scene);
    case v1::PARAMETER_KIND_OBJECTS:
      return ObjectNames(arguments.Objects(name), scene);
    case v1::PARAMETER_KIND_ZONE:
      return scene.zones[static_cast<size_t>(arguments.Zone(name))].name;
    case v1::PARAMETER_KIND_FEATURE: {
      const std::string feature = optimizer::FeatureName(scene.room, arguments.Feature(name));
      return feature.starts_with("the ") ? feature.substr(4) : feature;
    }
    case v1::PARAMETER_KIND_WALL:
      return absl::StrJoin(arguments.Walls(name), " or ", [&](std::string* out, int wall) {
        out->append(WallName(scene.room, scene.room.walls[static_cast<size_t>(wall)]));
      });
    case v1::PARAMETER_KIND_SIDE:
      return std::string(SideName(arguments.OneSide(name)));
    case v1::PARAMETER_KIND_SIDES: {
      std::vector<std::string> sides;
      for (const Side side : arguments.Sides(name)) sides.emplace_back(SideName(side));
      return Joined(sides);
    }
    case v1::PARAMETER_KIND_CORNER: {
      std::string corner(CornerName(arguments.OneCorner(name)));
      std::ranges::replace(corner, '_', ' ');
      return corner;
    }
    case v1::PARAMETER_KIND_BOOLEAN:
      return arguments.Flag(name) ? "yes" : "no";
    default:
      return spec.unit() == "rad" ? MeasureText(arguments.Number(name) * 180 / kPi, "deg")
                                  : MeasureText(arguments.Number(name), spec.unit());
  }
}

// A text with what stands between `open` and `close` replaced.
std::string WithSlots(std::string_view text, char open, char close,
                      const std::function<std::string(std::string_view)>& value) {
  std::string words;
  for (size_t start = text.find(open); start != std::string_view::npos; start = text.find(open)) {
    const size_t end = text.find(close, start + 1);
    if (end == std::string_view::npos) break;
    words += text.substr(0, start);
    words += value(text.substr(start + 1, end - start - 1));
    text.remove_prefix(end + 1);
  }
  return words + std::string(text);
}

}  // namespace

// `type` is null when the call cannot be read.
struct CallWords::Call {
  const v1::ConstraintType* type = nullptr;
  Arguments arguments = {};
};

CallWords::Call CallWords::Read(const v1::ConstraintEdge& edge) const {
  for (const v1::ConstraintType& type : catalog_.types()) {
    if (type.name() != edge.type() && std::ranges::count(type.aliases(), edge.type()) == 0) continue;
    absl::StatusOr<Arguments> arguments = Arguments::Resolve(type, edge, scene_);
    return arguments.ok() ? Call{&type, *std::move(arguments)} : Call{};
  }
  return {};
}

std::string CallWords::Filled(const std::string& words, const Call& call, const std::string& missed_by) const {
  const bool is_summary = words == call.type->summary();
  return WithSlots(words, is_summary ? '`' : '{', is_summary ? '`' : '}', [&](std::string_view slot) {
    const size_t bar = slot.find('|');
    const std::string name(slot.substr(0, bar));
    if (name == "missed_by") return missed_by;
    const auto spec = std::ranges::find(call.type->parameters(), name, &v1::ParameterSpec::name);
    if (spec != call.type->parameters().end() && call.arguments.Has(name)) {
      return ValueInWords(*spec, call.arguments, scene_);
    }
    return bar == std::string_view::npos ? name : std::string(slot.substr(bar + 1));
  });
}

std::string CallWords::Asked(const v1::ConstraintEdge& edge) const {
  const Call call = Read(edge);
  if (call.type == nullptr) return fmt::format("meets {}", edge.type());
  if (!call.type->phrase().empty()) return Filled(call.type->phrase(), call, "");
  // A type without words of its own: "Daylight falls on `object`." becomes "is so that daylight falls on the desk".
  std::string words = Filled(call.type->summary(), call, "");
  if (words.ends_with('.')) words.pop_back();
  if (!words.empty()) words[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(words[0])));
  return "is so that " + words;
}

std::string CallWords::Clarified(const v1::ConstraintEdge& edge) const {
  const Call call = Read(edge);
  return call.type == nullptr || !call.type->show_phrase() ? "" : "it " + Filled(call.type->phrase(), call, "");
}

std::string CallWords::Excused(const v1::ConstraintEdge& edge, const PartialLayout& where,
                               const optimizer::LinkedPairs& linked) const {
  constexpr double kReachesIn_m = 0.02;
  const Call call = Read(edge);
  if (call.type == nullptr || call.type->name() != "accessible" || !call.arguments.Has("min_clearance_m")) return "";
  const int object = call.arguments.Object("object");
  const auto box_of = [&](int i) {
    const size_t at = static_cast<size_t>(i);
    return Box<double>(scene_.objects[at].footprint, FrameOf(where.layout[at]));
  };
  std::vector<int> excused;
  for (int i = 0; i < static_cast<int>(scene_.objects.size()); ++i) {
    if (i == object || !where.placed[static_cast<size_t>(i)] || !IsSolid(scene_.objects[static_cast<size_t>(i)]))
      continue;
    const auto is_in = [&](Side side) {
      const Box<double> strip = Box<double>::Before(scene_.objects[static_cast<size_t>(object)].footprint,
                                                    FrameOf(where.layout[static_cast<size_t>(object)]), side,
                                                    call.arguments.Number("min_clearance_m"));
      return linked.BelongsAt(object, i, side) && Gap<double>(strip, box_of(i)) < -kReachesIn_m;
    };
    if (std::ranges::any_of(call.arguments.Sides("sides"), is_in)) excused.push_back(i);
  }
  return excused.empty() ? "" : "but for " + ObjectNames(excused, scene_);
}

std::string CallWords::Missed(const v1::ConstraintEdge& edge, const v1::EdgeOutcome& outcome) const {
  const Call call = Read(edge);
  if (call.type == nullptr || call.type->shortfall().empty() || !outcome.has_missed_by()) return "";
  const std::string words = Filled(call.type->shortfall(), call, MeasureText(outcome.missed_by(), outcome.unit()));
  return fmt::format("{} {}", ObjectNames(Subjects(edge), scene_), words);
}

std::vector<int> CallWords::Subjects(const v1::ConstraintEdge& edge) const {
  const Call call = Read(edge);
  if (call.type == nullptr) return {};
  for (const v1::ParameterKind kind : {v1::PARAMETER_KIND_OBJECTS, v1::PARAMETER_KIND_OBJECT}) {
    const auto spec = std::ranges::find(call.type->parameters(), kind, &v1::ParameterSpec::kind);
    if (spec != call.type->parameters().end() && call.arguments.Has(spec->name())) {
      return call.arguments.Objects(spec->name());
    }
  }
  return {};
}

std::vector<int> CallWords::Anchors(const v1::ConstraintEdge& edge) const {
  const Call call = Read(edge);
  std::vector<int> anchors;
  if (call.type == nullptr) return anchors;
  for (const std::string& name : call.type->anchors()) {
    if (!call.arguments.Has(name)) continue;
    const std::vector<int>& objects = call.arguments.Objects(name);
    anchors.insert(anchors.end(), objects.begin(), objects.end());
  }
  return anchors;
}

std::vector<int> CallWords::Named(const v1::ConstraintEdge& edge) const { return Read(edge).arguments.AllObjects(); }

std::string MeasureText(double value, const std::string& unit) {
  if (unit == "deg") return fmt::format("{:.0f} degrees", value);
  return fmt::format("{:.2f}{}{}", value, unit.empty() ? "" : " ", unit);
}

std::string Joined(const std::vector<std::string>& items) {
  std::string text;
  for (size_t i = 0; i < items.size(); ++i) {
    if (i > 0) text += i + 1 == items.size() ? " and " : ", ";
    text += items[i];
  }
  return text;
}

}  // namespace flair::cli
