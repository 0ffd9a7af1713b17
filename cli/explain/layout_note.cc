// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/explain/layout_note.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>

#include "absl/strings/ascii.h"
#include "cli/explain/hindrance.h"
#include "english/words.h"
#include "evaluation/metrics/measures.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "optimizer_worker/constraints/shortfall.h"
#include "room/geometry/polygon.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

// "a door in the south wall", "2 windows in the west wall".
std::string OpeningsInWords(const Room& room) {
  std::vector<std::string> parts;
  for (const auto& [kind, word] : {std::pair{OpeningKind::kDoor, "door"}, std::pair{OpeningKind::kWindow, "window"}}) {
    std::map<int, int> count_of_wall;
    for (const Opening& opening : room.openings) count_of_wall[opening.wall] += opening.kind == kind ? 1 : 0;
    for (const auto& [wall, count] : count_of_wall) {
      if (count == 0) continue;
      parts.push_back(fmt::format("{} in {}",
                                  count == 1 ? fmt::format("a {}", word) : fmt::format("{} {}s", count, word),
                                  WallName(room, room.walls[static_cast<size_t>(wall)])));
    }
  }
  return Joined(parts);
}

std::string_view LastWord(std::string_view name) { return name.substr(name.rfind(' ') + 1); }

std::string WithArticle(const std::string& noun) {
  const bool vowel = std::string_view("aeiou").find(noun.front()) != std::string_view::npos;
  return fmt::format("{} {}", vowel ? "an" : "a", noun);
}

std::string RoomInWords(const v1::Room& message, const Room& room) {
  const std::string type = message.room_type().empty() ? "room" : message.room_type();
  const Vec2<double> extent = BoundsOf(room.floor).max;
  std::string text = fmt::format(
      "{} of {:.4g} m x {:.4g} m{} ({:.3g} m²), {:.3g} m high", Capital(WithArticle(type)), extent.x, extent.y,
      room.walls.size() == 4 ? "" : fmt::format(" with {} walls", room.walls.size()), Area(room.floor), room.height_m);
  const std::string openings = OpeningsInWords(room);
  return text + (openings.empty() ? "." : fmt::format(", with {}.", openings));
}

void Append(const std::vector<int>& from, std::vector<int>& to) {
  for (const int object : from) {
    if (std::ranges::find(to, object) == to.end()) to.push_back(object);
  }
}

std::string RoleName(v1::ObjectRole role) {
  if (role == v1::OBJECT_ROLE_PRIMARY) return "primary";
  return role == v1::OBJECT_ROLE_TERTIARY ? "tertiary" : "secondary";
}

// A remark without the sentence that it quotes at its start.
std::string WithoutQuote(const std::string& remark) {
  const size_t quoted = remark.find("\": ");
  return quoted == std::string::npos ? remark : remark.substr(quoted + 3);
}

// Without fields that are empty or false; those in `kept` stay.
Note Pruned(const Note& json, const std::set<std::string_view>& kept) {
  Note pruned = Note::object();
  for (const auto& [field, value] : json.items()) {
    const bool is_empty = value.empty() || value == "" || value == false;
    if (!is_empty || kept.contains(field)) pruned[field] = value;
  }
  return pruned;
}

class NoteMaker {
 public:
  NoteMaker(const v1::SolvedLayout& layout, const v1::ConstraintCatalog& catalog, const Scene& scene,
            const PartialLayout& where)
      : layout_(layout), scene_(scene), where_(where), calls_(catalog, scene), hindrances_(layout, scene, where) {}

  Note Make() {
    note_ = {{"room", RoomInWords(layout_.graph().room(), scene_.room)},
             {"demand_count", {{"holds", 0}, {"missed", 0}, {"dropped", 0}, {"not_understood", 0}}},
             {"uses", Note::object()},
             {"findings", Note::array()},
             {"zones", Note::array()},
             {"demands_of_no_object", Note::array()},
             {"left_out", Note::array()},
             {"clashes", Note::array()},
             {"remarks", Note::array()}};
    DescribeObjects();
    AddDemands();
    AddFindings();
    AddRemarks();
    SortIntoZones();
    return Pruned(note_, {"zones", "left_out", "clashes", "remarks"});
  }

 private:
  void DescribeObjects() {
    const auto& pins = layout_.graph().pinned_placements();
    for (int i = 0; i < static_cast<int>(scene_.objects.size()); ++i) {
      const v1::Object& object = layout_.graph().object_list().objects(i);
      const bool placed = where_.placed[static_cast<size_t>(i)];
      Note& told = objects_.emplace_back(Note{{"id", object.id()},
                                              {"name", NameForPeople(scene_, i)},
                                              {"role", RoleName(object.role())},
                                              {"placed", placed},
                                              {"zone_id", object.zone_id()},
                                              {"requested", object.requested()}});
      const bool pinned = std::ranges::find(pins, object.id(), &v1::Placement::object_id) != pins.end();
      told.update({{"pinned", pinned}, {"origin", OriginOf(i, pinned)}});
      if (placed) {
        told["stands"] = Standing(scene_, where_, i);
        const auto place = std::ranges::find(layout_.placements(), object.id(), &v1::Placement::object_id);
        told.update({{"x_m", place->x_m()}, {"y_m", place->y_m()}, {"z_m", place->z_m()}});
        told["theta_rad"] = place->theta_rad();
      }
      for (const char* list : {"demands", "followers", "remarks"}) told[list] = Note::array();
    }
  }

  // What the user has done for it: "You put it there. You asked for a desk."
  std::string OriginOf(int object, bool pinned) const {
    std::string text = pinned ? "You put it there." : "";
    if (!layout_.graph().object_list().objects(object).requested()) return text;
    std::string name = NameForPeople(scene_, object);
    if (name.starts_with("the ")) {
      name = name.substr(4);
      if (!english::IsPlural(LastWord(name))) name = WithArticle(name);
    } else {
      name = name.substr(0, name.find_last_of(' '));
      name.replace(name.size() - LastWord(name).size(), name.npos, english::Plural(LastWord(name)));
    }
    return fmt::format("{}{}You asked for {}.", text, text.empty() ? "" : " ", name);
  }

  // Every sentence and every call of no sentence, in their order, once for each object that it places.
  void AddDemands() {
    const v1::LayoutGraph& graph = layout_.graph();
    std::map<std::string_view, std::vector<int>> edges_of;
    for (int e = 0; e < graph.edges_size(); ++e) edges_of[graph.edges(e).sentence_id()].push_back(e);
    for (const v1::Sentence& sentence : graph.constraint_list().sentences()) {
      AddSentence(sentence, edges_of[sentence.id()]);
      edges_of.erase(sentence.id());
    }
    for (int e = 0; e < graph.edges_size(); ++e) {
      if (edges_of.contains(graph.edges(e).sentence_id())) AddCall(e);
    }
  }

  static Note DemandOf(const v1::Sentence& sentence, const std::string& about_it) {
    return {{"fate", "holds"},
            {"about_it", about_it},
            {"sentence_id", sentence.id()},
            {"sentence", sentence.text()},
            {"reason", sentence.reason()},
            {"edge_ids", Note::array()},
            {"types", Note::array()},
            {"other_object_ids", Note::array()},
            {"shortfall", ""}};
  }

  void AddSentence(const v1::Sentence& sentence, const std::vector<int>& edges) {
    Note demand = DemandOf(sentence, WithoutStop(sentence.text()));
    std::vector<int> subjects;
    for (const int e : edges) {
      AddOutcome(e, demand);
      AddWords(calls_.Clarified(layout_.graph().edges(e)), demand);
      Append(calls_.Subjects(layout_.graph().edges(e)), subjects);
    }
    for (const v1::Diagnostic& remark : layout_.graph().diagnostics()) {
      if (edges.empty() || remark.code() != "partial" || remark.subject_id() != sentence.id()) continue;
      AddWords("only in part: " + WithoutQuote(remark.message()), demand);
    }
    // Who the sentence says it is about knows better than a call that may be written either way round.
    const int first = sentence.subject_ids_size() > 0 ? scene_.IndexOf(sentence.subject_ids(0)) : -1;
    if (first >= 0 && subjects.size() <= 1) subjects = {first};
    if (edges.empty()) {
      const auto& remarks = layout_.graph().diagnostics();
      const auto why = std::ranges::find(remarks, sentence.id(), &v1::Diagnostic::subject_id);
      // Whatever nobody understood has a remark that says so; the calls of others were dropped.
      demand["fate"] = why == remarks.end() ? "dropped" : "not understood";
      if (why != remarks.end()) demand["shortfall"] = WithoutQuote(why->message());
    }
    Assign(subjects, edges, demand);
  }

  // What has to be said beside a sentence for it to be true.
  static void AddWords(const std::string& words, Note& demand) {
    if (!words.empty()) demand["about_it"] = fmt::format("{} ({})", std::string(demand["about_it"]), words);
  }

  void AddCall(int e) {
    const v1::ConstraintEdge& edge = layout_.graph().edges(e);
    Note demand = DemandOf({}, fmt::format("It {}", calls_.Asked(edge)));
    AddOutcome(e, demand);
    Assign(calls_.Subjects(edge), {e}, demand);
  }

  // The worst of its calls decides; among equally bad ones the first has the word.
  void AddOutcome(int e, Note& demand) const {
    demand["edge_ids"].push_back(layout_.graph().edges(e).id());
    demand["types"].push_back(layout_.graph().edges(e).type());
    if (e >= layout_.edge_outcomes_size()) return;
    const v1::EdgeOutcome& outcome = layout_.edge_outcomes(e);
    const bool is_missed = outcome.status() == v1::OUTCOME_STATUS_VIOLATED;
    const bool is_dropped = outcome.status() == v1::OUTCOME_STATUS_DROPPED;
    if (outcome.status() == v1::OUTCOME_STATUS_SATISFIED) {
      AddWords(calls_.Excused(layout_.graph().edges(e), where_, hindrances_.linked()), demand);
    }
    const bool is_worse = is_missed ? demand["fate"] != "missed" : is_dropped && demand["fate"] == "holds";
    if (!is_worse) return;
    demand["fate"] = is_missed ? "missed" : "dropped";
    demand["shortfall"] = outcome.reason();
    if (is_missed && outcome.reason().empty()) demand["shortfall"] = calls_.Missed(layout_.graph().edges(e), outcome);
    demand.erase("missed_by");
    demand.erase("unit");
    if (outcome.has_missed_by()) demand.update({{"missed_by", outcome.missed_by()}, {"unit", outcome.unit()}});
    const std::vector<int> movers = calls_.Subjects(layout_.graph().edges(e));
    if (is_missed && movers.size() == 1) demand["because"] = hindrances_.Of(e, movers.front());
  }

  void Assign(const std::vector<int>& subjects, const std::vector<int>& edges, const Note& demand) {
    std::vector<int> named;
    for (const int e : edges) Append(calls_.Named(layout_.graph().edges(e)), named);
    Note& count = note_["demand_count"][demand["fate"] == "not understood" ? "not_understood" : demand["fate"]];
    // What has been dropped by hand is asked no more.
    if (!edges.empty() || demand["fate"] != "dropped") count = count.get<int>() + 1;
    for (const int object : subjects.empty() ? std::vector<int>{-1} : subjects) {
      Note own = demand;
      for (const int other : named) {
        if (other != object) own["other_object_ids"].push_back(scene_.objects[static_cast<size_t>(other)].id);
      }
      if (object >= 0 && demand["fate"] == "holds") AddFollower(object, edges);
      (object < 0 ? note_["demands_of_no_object"] : objects_[static_cast<size_t>(object)]["demands"])
          .push_back(Pruned(own, {"edge_ids", "types"}));
    }
  }

  // Notes at the anchors of a demand's calls that its own object has its place because of where they are.
  void AddFollower(int object, const std::vector<int>& edges) {
    const Note name = objects_[static_cast<size_t>(object)]["name"];
    for (const int e : edges) {
      std::vector<int> leaders = calls_.Anchors(layout_.graph().edges(e));
      // A sentence may be about the anchor of its call: then what the call places leads it.
      if (std::ranges::count(leaders, object) > 0) Append(calls_.Subjects(layout_.graph().edges(e)), leaders);
      for (const int leader : leaders) {
        Note& told = objects_[static_cast<size_t>(leader)];
        if (leader == object || told["role"] == "tertiary" || objects_[static_cast<size_t>(object)]["pinned"]) continue;
        if (std::ranges::find(told["followers"], name) == told["followers"].end()) told["followers"].push_back(name);
      }
    }
  }

  // Measured here: another optimizer may not measure them.
  void AddFindings() {
    v1::LayoutMetrics metrics;
    for (v1::Finding& found : evaluation::MeasureSolids({scene_, where_.layout, where_.placed}).findings) {
      Of(found.object_id())->at("remarks").push_back(found.message());
      *metrics.add_findings() = std::move(found);
    }
    evaluation::AddUses(layout_.graph(), layout_.placements(), layout_.edge_outcomes(), metrics);
    if (metrics.use_count() > 0) note_["uses"] = {{"asked", metrics.use_count()}, {"met", metrics.met_use_count()}};
    for (const v1::Finding& finding : metrics.findings()) {
      Note told = {{"kind", absl::AsciiStrToLower(v1::FindingKind_Name(finding.kind()).substr(13))},
                   {"object_id", finding.object_id()},
                   {"partner_id", finding.partner_id()},
                   {"message", finding.message()}};
      if (finding.has_amount()) told.update({{"amount", finding.amount()}, {"unit", finding.unit()}});
      note_["findings"].push_back(Pruned(told, {}));
    }
  }

  void AddRemarks() {
    const v1::LayoutGraph& graph = layout_.graph();
    for (const v1::Omission& omission : graph.object_list().omissions()) {
      note_["left_out"].push_back(fmt::format("{}{}: {}", Capital(omission.name()),
                                              omission.requested() ? " (asked for)" : "", omission.reason()));
    }
    for (const auto* list : {&graph.room().diagnostics(), &graph.zone_plan().diagnostics(),
                             &graph.object_list().diagnostics(), &layout_.diagnostics()}) {
      for (const v1::Diagnostic& remark : *list) {
        Note* const told = Of(remark.subject_id());
        (told != nullptr ? *told : note_)["remarks"].push_back(remark.message());
      }
    }
    for (const Note& told : objects_) {
      if (told["placed"]) continue;
      note_["left_out"].push_back(told["remarks"].empty() ? fmt::format("{} is not placed.", Capital(told["name"]))
                                                          : Joined(told["remarks"]));
    }
    for (const v1::Contradiction& clash : layout_.contradictions()) note_["clashes"].push_back(clash.explanation());
  }

  void SortIntoZones() {
    std::vector<Note> zones;
    for (const v1::Zone& zone : layout_.graph().zone_plan().zones()) {
      zones.push_back(
          {{"id", zone.id()}, {"name", zone.name()}, {"purpose", zone.purpose()}, {"objects", Note::array()}});
    }
    zones.push_back({{"id", ""}, {"name", "the whole room"}, {"objects", Note::array()}});
    for (const Note& told : objects_) {
      const auto zone = std::find_if(zones.begin(), zones.end() - 1,
                                     [&](const Note& candidate) { return candidate["id"] == told["zone_id"]; });
      (*zone)["objects"].push_back(Pruned(told, {"placed", "demands"}));
    }
    for (const Note& zone : zones) {
      if (!zone["objects"].empty()) note_["zones"].push_back(Pruned(zone, {"id", "name"}));
    }
  }

  Note* Of(const std::string& id) {
    const int index = scene_.IndexOf(id);
    return index < 0 ? nullptr : &objects_[static_cast<size_t>(index)];
  }

  const v1::SolvedLayout& layout_;
  const Scene& scene_;
  const PartialLayout& where_;
  const CallWords calls_;
  const Hindrances hindrances_;
  std::vector<Note> objects_;
  Note note_;
};

}  // namespace

absl::StatusOr<Note> MakeLayoutNote(const v1::SolvedLayout& layout, const v1::ConstraintCatalog& catalog) {
  RETURN_IF_ERROR(Validate(layout));
  ASSIGN_OR_RETURN(Scene scene, SceneFromProto(layout.graph()));
  // Names are read by people here: "towel_rack" is written "towel rack".
  for (Object& object : scene.objects) std::ranges::replace(object.name, '_', ' ');
  ASSIGN_OR_RETURN(const PartialLayout where, PosesFromPlacements(scene, layout.placements()));
  return NoteMaker(layout, catalog, scene, where).Make();
}

absl::StatusOr<Note> FindObject(const Note& note, const std::string& key) {
  std::vector<std::string> ids;
  const Note* by_name = nullptr;
  for (const Note& zone : note["zones"]) {
    for (const Note& object : zone["objects"]) {
      if (object["id"] == key) return object;
      if (object["name"] == key || object["name"] == "the " + key) by_name = &object;
      ids.push_back(object["id"]);
    }
  }
  if (by_name != nullptr) return *by_name;
  return NotFound("--object: \"{}\" is not in the layout; it has {}", key, fmt::join(ids, ", "));
}

// Texts may hold what is no UTF-8 when the layout is a stranger's.
std::string NoteJson(const Note& note) { return note.dump(1, ' ', false, Note::error_handler_t::replace) + "\n"; }

}  // namespace flair::cli
