// SPDX-License-Identifier: GPL-3.0-or-later
// What acts are called.
#include <cmath>
#include <utility>

#include "fmt/format.h"
#include "session/sentences/names.h"

namespace flair::session {
namespace {

constexpr size_t kMostLetters = 80;

// "the desk", "3 pieces".
std::string Pieces(const v1::SolvedLayout& layout, const ObjectIds& ids) {
  return ids.size() == 1 ? "the " + NameOf(layout, ids.front()) : fmt::format("{} pieces", ids.size());
}

std::string Shortened(std::string text) {
  if (text.size() <= kMostLetters) return text;
  size_t end = kMostLetters;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return text.substr(0, end) + "…";
}

std::string SentenceText(const v1::SolvedLayout& layout, const std::string& id) {
  for (const v1::Sentence& sentence : layout.graph().constraint_list().sentences()) {
    if (sentence.id() == id) return sentence.text();
  }
  return id;
}

// The verb and the object of one edit.
std::pair<std::string, std::string> VerbOf(const v1::LayoutEdit& edit) {
  switch (edit.edit_case()) {
    case v1::LayoutEdit::kMoveObject:
      return {"move", edit.move_object().object_id()};
    case v1::LayoutEdit::kPinObjectId:
      return {"lock", edit.pin_object_id()};
    case v1::LayoutEdit::kUnpinObjectId:
      return {"unlock", edit.unpin_object_id()};
    case v1::LayoutEdit::kResizeObject:
      return {"resize", edit.resize_object().object_id()};
    case v1::LayoutEdit::kAddObject:
      return {"add", edit.add_object().object().id()};
    case v1::LayoutEdit::kRemoveObjectId:
      return {"remove", edit.remove_object_id()};
    case v1::LayoutEdit::kAddEdge:
      return {"add a constraint", ""};
    case v1::LayoutEdit::kRemoveEdgeId:
      return {"drop a constraint", ""};
    case v1::LayoutEdit::kSetEdgeWeight:
      return {"weigh a constraint", ""};
    case v1::LayoutEdit::EDIT_NOT_SET:
      break;
  }
  return {"change", ""};
}

}  // namespace

std::string NameOf(const v1::SolvedLayout& layout, const std::string& id) {
  for (const v1::Object& object : layout.graph().object_list().objects()) {
    if (object.id() == id) return object.name();
  }
  return id;
}

std::string WithArticle(const std::string& name) {
  constexpr std::string_view kVowels = "aeiou";
  return (!name.empty() && kVowels.find(name.front()) != std::string_view::npos ? "an " : "a ") + name;
}

std::string MoveLabel(const v1::SolvedLayout& layout, const v1::MoveObjects& move) {
  ObjectIds ids;
  bool turned_only = true;
  for (const v1::Placement& to : move.placements()) {
    ids.push_back(to.object_id());
    const v1::Placement* const from = PlaceOf(layout, to.object_id());
    if (from == nullptr) continue;
    turned_only = turned_only && std::hypot(from->x_m() - to.x_m(), from->y_m() - to.y_m()) < 1e-9;
  }
  return fmt::format("{} {}", turned_only ? "turn" : "move", Pieces(layout, ids));
}

std::string EditLabel(const v1::SolvedLayout& layout, const EditList& edits) {
  IdSet verbs, seen;
  ObjectIds ids;
  std::string added;
  for (const v1::LayoutEdit& edit : edits) {
    const auto [verb, id] = VerbOf(edit);
    if (edit.has_add_object()) added = edit.add_object().object().name();
    // What is added is put somewhere: that is one act.
    if (verb == "move" && seen.contains(id)) continue;
    verbs.insert(verb);
    if (!id.empty() && seen.insert(id).second) ids.push_back(id);
  }
  if (verbs.size() != 1) return fmt::format("{} changes", edits.size());
  if (ids.empty()) return *verbs.begin();
  if (*verbs.begin() == "add" && ids.size() == 1) return "add " + WithArticle(added);
  return fmt::format("{} {}", *verbs.begin(), Pieces(layout, ids));
}

std::string SayLabel(const std::string& text) { return fmt::format("say \"{}\"", Shortened(text)); }

std::string AlsoMoved(const v1::SolvedLayout& before, const v1::SolvedLayout& after, const ObjectIds& moved_ids) {
  constexpr size_t kMost = 4;
  const IdSet known = IdsOf(before.graph().object_list().objects());
  std::string text;
  for (const bool is_new : {true, false}) {
    std::vector<std::string> names;
    for (const std::string& id : moved_ids) {
      if (known.contains(id) != is_new) names.push_back(NameOf(after, id));
    }
    if (names.empty()) continue;
    const size_t more = names.size() > kMost ? names.size() - kMost : 0;
    names.resize(names.size() - more);
    text += fmt::format("; {}: {}", is_new ? "added" : "moved", fmt::join(names, ", "));
    if (more > 0) text += fmt::format(" and {} more", more);
  }
  return text;
}

std::string WeighLabel(const v1::SolvedLayout& layout, const v1::WeighSentence& weigh) {
  return Shortened(
      fmt::format("{} \"{}\"", weigh.weight() == 0 ? "drop" : "weigh", SentenceText(layout, weigh.sentence_id())));
}

}  // namespace flair::session
