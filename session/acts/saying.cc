// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of the room in English: wishes for its pieces, and for pieces that it has not.
#include <algorithm>
#include <cmath>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/match.h"
#include "absl/strings/str_join.h"
#include "fmt/format.h"
#include "optimizer_worker/resolve/resolve_layout.h"
#include "room/validation/validate.h"
#include "session/acts/layout_acts.h"
#include "session/layouts/comparing.h"
#include "session/sentences/answers.h"
#include "session/sentences/names.h"
#include "session/sentences/said.h"
#include "session/sentences/sentences.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::session {
namespace {

using runtime::CallContext;

// What an edge is about: the first object that it names.
std::string SubjectOf(const v1::ConstraintEdge& edge, const v1::LayoutGraph& graph) {
  const IdSet objects = IdsOf(graph.object_list().objects());
  const std::vector<std::string> texts = TextsOf(edge);
  const auto first = std::ranges::find_if(texts, [&](const std::string& text) { return objects.contains(text); });
  return first == texts.end() ? "" : *first;
}

// "Desk" is what a room with a standing desk has.
bool HasOne(const v1::LayoutGraph& graph, const std::string& name) {
  return std::ranges::any_of(graph.object_list().objects(), [&](const v1::Object& object) {
    const std::string low = absl::AsciiStrToLower(object.name());
    return low == name || absl::EndsWith(low, " " + name);
  });
}

// As people compare what they have said.
std::string Plain(const std::string& text) {
  std::string plain = absl::AsciiStrToLower(text);
  while (!plain.empty() && !absl::ascii_isalnum(static_cast<unsigned char>(plain.back()))) plain.pop_back();
  return plain;
}

// Edits that take back what was said before in the same words.
void DropSame(const v1::LayoutGraph& graph, const IdSet& said, EditList& edits) {
  IdSet same;
  for (const v1::Sentence& sentence : graph.constraint_list().sentences()) {
    if (sentence.id().starts_with(kSaid) && said.contains(Plain(sentence.text()))) same.insert(sentence.id());
  }
  for (const v1::ConstraintEdge& edge : graph.edges()) {
    if (same.contains(edge.sentence_id())) edits.Add()->set_remove_edge_id(edge.id());
  }
}

// Takes back what was said before of the same piece in the same respect, does not hold, and so is said otherwise now.
void DropOvertaken(const IdSet& now, Acted& acted) {
  v1::LayoutGraph& graph = *acted.layout.mutable_graph();
  std::set<std::pair<std::string, std::string>> said;
  IdSet overtaken;
  for (const v1::ConstraintEdge& edge : graph.edges()) {
    if (now.contains(edge.sentence_id()) && WhyUnmet(acted.layout, {edge.sentence_id()}).empty())
      said.emplace(edge.type(), SubjectOf(edge, graph));
  }
  for (const v1::ConstraintEdge& edge : graph.edges()) {
    const std::string& sentence = edge.sentence_id();
    if (!sentence.starts_with(kSaid) || now.contains(sentence) || WhyUnmet(acted.layout, {sentence}).empty()) continue;
    if (said.contains({edge.type(), SubjectOf(edge, graph)})) overtaken.insert(sentence);
  }
  for (int i = graph.edges_size() - 1; i >= 0; --i) {
    if (!overtaken.contains(graph.edges(i).sentence_id())) continue;
    graph.mutable_edges()->DeleteSubrange(i, 1);
    if (i < acted.layout.edge_outcomes_size()) acted.layout.mutable_edge_outcomes()->DeleteSubrange(i, 1);
  }
  for (const v1::Sentence& sentence : graph.constraint_list().sentences()) {
    if (!overtaken.contains(sentence.id())) continue;
    acted.diagnostics.push_back(
        Remark(v1::SEVERITY_NOTE, "said_otherwise", "",
               fmt::format("\"{}\" is dropped: you have said otherwise since", sentence.text())));
  }
}

// Free space must not undo what pieces are for: a chair does not turn from its table to have room behind it.
constexpr std::string_view kFreeSpace = "accessible";

double WeightBesideUses(const v1::ConstraintEdge& space, const v1::LayoutGraph& graph) {
  constexpr double kLess = 0.25;
  const IdSet uses = UsesOf(graph), named = ObjectsOf(space, graph);
  double least = INFINITY;
  for (const v1::ConstraintEdge& edge : graph.edges()) {
    if (!uses.contains(edge.sentence_id())) continue;
    const IdSet used = ObjectsOf(edge, graph);
    const bool shared = std::ranges::any_of(used, [&](const std::string& id) { return named.contains(id); });
    if (shared) least = std::min(least, kLess * edge.weight());
  }
  return least;
}

// "Added a floor plant. Now the floor plant is in the corner."
std::string AnswerTo(const Said& said, const v1::SolvedLayout& before, const Acted& acted, const IdSet& about) {
  std::vector<std::string> texts;
  const ObjectIds added(said.added_ids.begin(), said.added_ids.end());
  if (added.size() == 1) {
    texts.push_back(fmt::format("Added {}.", WithArticle(NameOf(acted.layout, added.front()))));
  } else if (!added.empty()) {
    const std::string ones = TheOnes(acted.layout, added);
    // "Added 3 chairs", though they are all that there are.
    const bool counted = ones.size() > 4 && ones.starts_with("the ") && absl::ascii_isdigit(ones[4]);
    texts.push_back(fmt::format("Added {}.", counted ? ones.substr(4) : ones));
  }
  const IdSet here = IdsOf(acted.layout.graph().constraint_list().sentences());
  std::vector<std::string> holding;
  for (const v1::Sentence& sentence : said.shown.sentences()) {
    if (!here.contains(sentence.id()) || !WhyUnmet(acted.layout, {sentence.id()}).empty()) continue;
    std::string text(absl::StripTrailingAsciiWhitespace(sentence.text()));
    while (!text.empty() && text.back() == '.') text.pop_back();
    const std::string the = "The ";
    if (text.starts_with(the)) text[0] = 't';
    holding.push_back(std::move(text));
  }
  if (!holding.empty()) {
    const bool so_already = added.empty() && acted.moved_ids.empty();
    texts.push_back(fmt::format("{}{}.", so_already ? "It is so already: " : "Done: ", Listed(holding, "and")));
  }
  if (texts.empty()) return "";
  return absl::StrJoin(texts, " ") + MovedToo(acted.layout, acted.moved_ids, about) +
         AtACost(before, acted.layout, about);
}

// Tells of pieces that were added what their place lacks by what a designer asks of it.
std::string NoGoodPlace(const Acted& acted, const Aim& aim, const IdSet& of_user) {
  const v1::LayoutGraph& graph = acted.layout.graph();
  for (const std::string& id : acted.added_ids) {
    if (PlaceOf(acted.layout, id) == nullptr) {
      return fmt::format(" But there is no room for {}.", TheOnes(acted.layout, {id}));
    }
    for (const std::string& sentence : aim.sentence_ids) {
      if (of_user.contains(sentence) || !ObjectsOf({sentence}, graph).contains(id)) continue;
      const std::string why = WhyUnmet(acted.layout, {sentence});
      if (!why.empty())
        return fmt::format(" But no good place was found for {}: {}.", TheOnes(acted.layout, {id}), why);
    }
  }
  return "";
}

}  // namespace

absl::StatusOr<v1::LayoutGraph> LayoutActs::Understood(const v1::SaySentence& say, const Said& said,
                                                       const v1::SolvedLayout& shown, const v1::SolvedLayout& with,
                                                       CallContext& call) const {
  const IdSet selected(say.selected_object_ids().begin(), say.selected_object_ids().end());
  v1::TranslateRequest request;
  v1::ObjectList& meant = *request.mutable_object_list();
  meant = MeantBy(say.text(), shown, selected);
  for (const v1::Object& object : with.graph().object_list().objects()) {
    if (said.added_ids.contains(object.id())) *meant.add_objects() = object;
  }
  if (said.meant.sentences().empty() || meant.objects().empty()) return v1::LayoutGraph();
  std::ranges::stable_sort(*meant.mutable_objects(), {}, &v1::Object::role);
  *request.mutable_room() = shown.graph().room();
  *request.mutable_zone_plan() = shown.graph().zone_plan();
  *request.mutable_style_sheet() = LooksOf(meant, with);
  *request.mutable_constraint_list() = said.meant;
  ASSIGN_OR_RETURN(*request.mutable_catalog(), stages_.Catalog(call));
  ASSIGN_OR_RETURN(v1::TranslateResponse translated, stages_.Translate(std::move(request), call));
  return std::move(*translated.mutable_layout_graph());
}

absl::Status LayoutActs::TellUnmet(const v1::ConstraintList& said, Acted& acted, CallContext& call) const {
  for (const v1::Sentence& sentence : said.sentences()) {
    const std::string unmet = WhyUnmet(acted.layout, {sentence.id()});
    if (unmet.empty()) continue;
    const IdSet about = ObjectsOf({sentence.id()}, acted.layout.graph());
    ASSIGN_OR_RETURN(const std::string why, WhyNot(acted.layout, {{sentence.id()}, about}, call));
    acted.diagnostics.push_back(
        Remark(v1::SEVERITY_WARNING, "said_in_vain", about.empty() ? "" : *about.begin(),
               fmt::format("\"{}\" is noted but does not hold: {}; {}", sentence.text(), unmet, why)));
  }
  return absl::OkStatus();
}

absl::StatusOr<Acted> LayoutActs::SayWishes(const Standing& standing, const v1::SaySentence& say,
                                            const std::vector<WishedSentence>& places, CallContext& call) const {
  const std::string text(absl::StripAsciiWhitespace(say.text()));
  const v1::LayoutGraph& graph = standing.shown.graph();
  const auto has = [&](const std::string& name) {
    const std::optional<v1::Object> known = catalogue_.find(name);
    return HasOne(graph, name) || (known.has_value() && HasOne(graph, known->name()));
  };
  // Another one of what is there is like it.
  const auto find = [&](const std::string& name) -> std::optional<v1::Object> {
    const v1::Object* const like = AnotherOf(graph, name, catalogue_.find);
    if (like == nullptr) return catalogue_.find(name);
    v1::Object copy = *like;
    copy.clear_id();
    copy.clear_host_id();
    copy.clear_placement();
    return copy;
  };
  Wishes wishes = ReadWishes(text, find, has);
  if (wishes.pieces.size() > kMostAddedAtOnce) {
    return InvalidArgument("\"{}\" is not done: at most {} pieces are added at once", text, kMostAddedAtOnce);
  }
  // A new desk's chair is none of the table's.
  for (PieceWish& piece : wishes.pieces) {
    if (piece.goes_with < 0) continue;
    if (std::optional<v1::Object> known = catalogue_.find(piece.called)) piece.object = *std::move(known);
  }
  wishes.sentences.insert(wishes.sentences.end(), places.begin(), places.end());
  const Said said = Written(wishes, standing.shown);
  v1::SolvedLayout shown = standing.shown, with = shown;
  ASSIGN_OR_RETURN(optimizer::EditedProblem with_pieces, optimizer::ApplyEdits(shown, said.adds));
  with.mutable_graph()->Swap(&with_pieces.graph);
  ASSIGN_OR_RETURN(const v1::LayoutGraph understood, Understood(say, said, shown, with, call));

  std::vector<std::string> refusals, left_over;
  for (const std::string& name : wishes.unknown) {
    refusals.push_back(fmt::format("I know no \"{}\"; the furniture list has {}", name, catalogue_.some));
  }
  // Who adds a piece has not asked to move the others.
  Aim aim{{}, {}, !understood.edges().empty()};
  for (const v1::ConstraintEdge& edge : understood.edges()) aim.sentence_ids.insert(edge.sentence_id());
  const IdSet meaning = aim.sentence_ids;
  // What is said of several new pieces alike is understood when it is of one of them.
  IdSet understood_texts;
  for (const v1::Sentence& sentence : said.shown.sentences()) {
    if (meaning.contains(sentence.id())) understood_texts.insert(sentence.text());
  }
  IdSet words;
  for (const v1::Sentence& sentence : said.shown.sentences()) {
    if (!meaning.contains(sentence.id())) {
      if (understood_texts.contains(sentence.text()) || said.purposes.contains(sentence.id())) continue;
      const std::string word = UnknownWord(sentence.text(), with, catalogue_.find);
      const std::string examples =
          fmt::format("{}; {}", word.empty() ? "" : fmt::format(": I do not know \"{}\"", word),
                      Examples(sentence.text(), standing.shown, turn_++));
      std::string refusal = Refusal(sentence, understood, catalogue_, examples);
      if (std::ranges::find(refusals, refusal) == refusals.end()) refusals.push_back(std::move(refusal));
      // Only the user's own words, and none of a piece that has come.
      const auto own = said.own_words.find(sentence.id());
      if (own != said.own_words.end()) left_over.push_back(own->second);
      continue;
    }
    words.insert(Plain(sentence.text()));
    *shown.mutable_graph()->mutable_constraint_list()->add_sentences() = sentence;
  }
  if (understood.edges().empty() && said.adds.empty()) {
    return InvalidArgument("say.text: {}", refusals.empty() ? "nothing is said" : refusals.front());
  }
  EditList edits = said.adds;
  DropSame(graph, words, edits);
  FreeIds ids(graph.edges(), "e");
  for (const v1::ConstraintEdge& edge : understood.edges()) {
    v1::ConstraintEdge& one = *edits.Add()->mutable_add_edge();
    one = edge;
    one.set_id(ids.Next());
    if (edge.type() == kFreeSpace) one.set_weight(std::min(one.weight(), WeightBesideUses(edge, with.graph())));
    aim.object_ids.insert(SubjectOf(edge, with.graph()));
  }
  // Who says something of a piece that was placed by hand wants it to move.
  ObjectIds by_hand = standing.by_hand;
  std::erase_if(by_hand, [&](const std::string& one) { return aim.object_ids.contains(one); });
  aim.object_ids.insert(said.added_ids.begin(), said.added_ids.end());
  // Without a designer at hand a piece comes as it is.
  absl::StatusOr<v1::LayoutGraph> designers;
  if (!said.adds.empty()) designers = LetDesignerSpeak(said.added_ids, with, shown, edits, aim, call);
  ASSIGN_OR_RETURN(Acted acted, Tried({shown, standing.settled, standing.pending, by_hand}, edits, aim, call));
  // Where it was asked for it would stand in something else or outside: then elsewhere, and that is told.
  if (HasMoreFaults(acted.layout, standing.shown) && !said.adds.empty() && !understood.edges().empty()) {
    constexpr double kLittle = 0.2;
    EditList easier = edits;
    for (v1::LayoutEdit& edit : easier) {
      if (meaning.contains(edit.add_edge().sentence_id())) edit.mutable_add_edge()->set_weight(kLittle);
    }
    ASSIGN_OR_RETURN(Acted elsewhere, Tried({shown, standing.settled, standing.pending, by_hand}, easier, aim, call));
    if (!HasMoreFaults(elsewhere.layout, standing.shown)) acted = std::move(elsewhere);
  }
  if (designers.ok()) ReturnSubjects(*designers, *acted.layout.mutable_graph());
  acted.label = SayLabel(text);
  acted.left_over = absl::StrJoin(left_over, ", ");
  acted.added_ids.assign(said.added_ids.begin(), said.added_ids.end());
  for (const std::string& id : acted.added_ids) {
    const v1::Object* const like = AnotherOf(graph, absl::AsciiStrToLower(NameOf(with, id)), catalogue_.find);
    if (like != nullptr) LookLike(like->id(), id, *acted.layout.mutable_graph());
  }
  for (const v1::Diagnostic& remark : understood.diagnostics()) {
    if (!meaning.contains(remark.subject_id())) continue;
    acted.diagnostics.push_back(remark);
    acted.diagnostics.back().set_message(WithNames(remark.message(), acted.layout));
  }
  for (std::string& refusal : refusals) {
    acted.diagnostics.push_back(Remark(v1::SEVERITY_WARNING, "not_understood", "", std::move(refusal)));
  }
  RETURN_IF_ERROR(TellUnmet(said.shown, acted, call));
  DropOvertaken(meaning, acted);
  acted.answer = AnswerTo(said, standing.shown, acted, aim.object_ids) + NoGoodPlace(acted, aim, meaning);
  return acted;
}

}  // namespace flair::session
