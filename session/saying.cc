// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of the room in English: wishes for its pieces, and for pieces that it has not.
#include <algorithm>
#include <set>

#include "absl/strings/ascii.h"
#include "absl/strings/match.h"
#include "absl/strings/str_replace.h"
#include "fmt/format.h"
#include "optimizer_worker/resolve/resolve_layout.h"
#include "room/validation/validate.h"
#include "session/act_words.h"
#include "session/layout_acts.h"
#include "session/naming.h"
#include "session/trying.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::session {
namespace {

using runtime::CallContext;

// An id that no sentence or edge has yet.
template <typename Items>
std::string FreeId(const Items& items, const std::string& letter) {
  std::set<std::string> taken;
  for (const auto& item : items) taken.insert(item.id());
  for (int n = items.size() + 1;; ++n) {
    if (std::string id = letter + std::to_string(n); !taken.contains(id)) return id;
  }
}

// What a call is about: the first object that it names.
std::string SubjectOf(const v1::ConstraintEdge& edge, const v1::LayoutGraph& graph) {
  std::set<std::string> ids;
  for (const v1::Object& object : graph.object_list().objects()) ids.insert(object.id());
  for (const v1::Argument& argument : edge.arguments()) {
    if (ids.contains(argument.value().text())) return argument.value().text();
    for (const std::string& text : argument.value().texts().items()) {
      if (ids.contains(text)) return text;
    }
  }
  return "";
}

// What nobody asked for gives way to what the user says: twice the heaviest of a designer's sentences.
double WeightOfSaid(const v1::ConstraintList& list) {
  constexpr double kLeast = 4, kMost = 10;
  double heaviest = 0;
  for (const v1::Sentence& sentence : list.sentences()) {
    if (sentence.origin() != v1::SENTENCE_ORIGIN_BRIEF) heaviest = std::max(heaviest, sentence.weight());
  }
  return std::clamp(2 * heaviest, kLeast, kMost);
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

// How a piece stands to what it comes with.
std::string PlaceWith(const v1::Object& piece, const v1::Object& other) {
  if (piece.kind() == v1::OBJECT_KIND_SURFACE) return "The {} is on the {}.";
  if (piece.kind() == v1::OBJECT_KIND_WALL || piece.kind() == v1::OBJECT_KIND_CEILING)
    return "The {} hangs above the {}.";
  if (piece.walk_over()) return "The {} is under the {}.";
  if (piece.seat() && other.sat_at()) return "The front of the {} is next to the front of the {}.";
  return "The {} is next to the {}.";
}

// The pieces and sentences of a text, as they are given to the translator.
class Said {
 public:
  Said(const Wishes& wishes, const v1::SolvedLayout& shown) : wishes_(wishes) {
    for (const PieceWish& piece : wishes.pieces) *adds_.Add()->mutable_add_object()->mutable_object() = piece.object;
    adds_ = Completed(shown, adds_);
    for (size_t i = 0; i < wishes.pieces.size(); ++i) {
      v1::Object& object = *adds_[static_cast<int>(i)].mutable_add_object()->mutable_object();
      const int host = wishes.pieces[i].goes_with;
      if (host >= 0 && object.kind() == v1::OBJECT_KIND_SURFACE) object.set_host_id(Piece(host).id());
    }
  }

  const EditList& adds() const { return adds_; }
  // The sentences as people read them, by their ids in a list for the translator, which calls pieces by their ids.
  const v1::ConstraintList& shown() const { return shown_; }
  const v1::ConstraintList& meant() const { return meant_; }

  void Write(const v1::ConstraintList& before) {
    for (size_t i = 0; i < wishes_.pieces.size(); ++i) {
      const PieceWish& piece = wishes_.pieces[i];
      if (piece.goes_with < 0) continue;
      const v1::Object &one = Piece(static_cast<int>(i)), &other = Piece(piece.goes_with);
      const std::string form = PlaceWith(one, other);
      const bool use = one.seat() && other.sat_at();
      Add(before, Filled(Filled(form, one.name()), other.name()), Filled(Filled(form, one.id()), other.id()),
          piece.said, use);
    }
    for (const WishedSentence& sentence : wishes_.sentences) {
      if (sentence.piece < 0) {
        Add(before, sentence.text, sentence.text, sentence.said, false);
      } else {
        const v1::Object& piece = Piece(sentence.piece);
        Add(before, Filled(sentence.text, piece.name()), Filled(sentence.text, piece.id()), sentence.said, false);
      }
    }
  }

 private:
  const v1::Object& Piece(int i) const { return adds_[i].add_object().object(); }

  static std::string Filled(std::string form, const std::string& name) {
    const size_t at = form.find("{}");
    return at == std::string::npos ? form : form.replace(at, 2, name);
  }

  void Add(const v1::ConstraintList& before, const std::string& text, const std::string& meant, const std::string& said,
           bool use) {
    v1::Sentence& sentence = *shown_.add_sentences();
    v1::ConstraintList all = before;
    all.MergeFrom(meant_);
    sentence.set_id(FreeId(all.sentences(), "said_"));
    sentence.set_text(text);
    sentence.set_scope(v1::SENTENCE_SCOPE_INTER);
    sentence.set_weight(WeightOfSaid(before));
    sentence.set_reason(fmt::format("you said \"{}\"", said));
    sentence.set_origin(v1::SENTENCE_ORIGIN_BRIEF);
    sentence.set_use(use);
    v1::Sentence& for_translator = *meant_.add_sentences();
    for_translator = sentence;
    for_translator.set_text(meant);
  }

  const Wishes& wishes_;
  EditList adds_;
  v1::ConstraintList shown_, meant_;
};

// Why a sentence means nothing here, for people.
std::string Refusal(const v1::Sentence& sentence, const v1::LayoutGraph& understood, const Catalogue& catalogue) {
  constexpr std::string_view kMissing = "the room has no \"";
  for (const v1::Diagnostic& why : understood.diagnostics()) {
    if (why.subject_id() != sentence.id()) continue;
    const size_t at = why.message().rfind(kMissing);
    if (why.code() == "names_absent_object" && at != std::string::npos) {
      const size_t begin = at + kMissing.size();
      const std::string name = why.message().substr(begin, why.message().find('"', begin) - begin);
      if (catalogue.find(name).has_value()) {
        return fmt::format(
            "\"{}\" is not understood: the room has no {}; say \"add {}\" or take one from the furniture list",
            sentence.text(), name, WithArticle(name));
      }
      return fmt::format("\"{}\" is not understood: I know no \"{}\"; the furniture list has {}", sentence.text(), name,
                         catalogue.some);
    }
    if (why.code() == "unknown_sentence") break;
    const size_t quoted = why.message().find("\": ");
    return fmt::format("\"{}\" is not understood: {}", sentence.text(),
                       quoted == std::string::npos ? why.message() : why.message().substr(quoted + 3));
  }
  return fmt::format(
      "\"{}\" is not understood; say for example \"the desk is against a wall\", \"the lamp is next to the sofa\" or "
      "\"add a plant in the corner\"",
      sentence.text());
}

void Warn(const char* code, const std::string& subject, std::string message, Acted& acted) {
  v1::Diagnostic& warning = acted.diagnostics.emplace_back();
  warning.set_severity(v1::SEVERITY_WARNING);
  warning.set_code(code);
  warning.set_subject_id(subject);
  warning.set_message(std::move(message));
}

// Edits that take back what was said before in the same words.
void DropSame(const v1::LayoutGraph& graph, const std::set<std::string>& said, EditList& edits) {
  std::set<std::string> same;
  for (const v1::Sentence& sentence : graph.constraint_list().sentences()) {
    if (sentence.id().starts_with("said_") && said.contains(Plain(sentence.text()))) same.insert(sentence.id());
  }
  for (const v1::ConstraintEdge& edge : graph.edges()) {
    if (same.contains(edge.sentence_id())) edits.Add()->set_remove_edge_id(edge.id());
  }
}

// Takes back what was said before of the same piece in the same respect, does not hold, and so is said otherwise now.
void DropOvertaken(const std::set<std::string>& now, Acted& acted) {
  v1::LayoutGraph& graph = *acted.layout.mutable_graph();
  std::set<std::pair<std::string, std::string>> said;
  std::set<std::string> overtaken;
  for (const v1::ConstraintEdge& edge : graph.edges()) {
    if (now.contains(edge.sentence_id()) && WhyUnmet(acted.layout, {edge.sentence_id()}).empty())
      said.emplace(edge.type(), SubjectOf(edge, graph));
  }
  for (const v1::ConstraintEdge& edge : graph.edges()) {
    const std::string& sentence = edge.sentence_id();
    if (!sentence.starts_with("said_") || now.contains(sentence) || WhyUnmet(acted.layout, {sentence}).empty())
      continue;
    if (said.contains({edge.type(), SubjectOf(edge, graph)})) overtaken.insert(sentence);
  }
  for (int i = graph.edges_size() - 1; i >= 0; --i) {
    if (!overtaken.contains(graph.edges(i).sentence_id())) continue;
    graph.mutable_edges()->DeleteSubrange(i, 1);
    if (i < acted.layout.edge_outcomes_size()) acted.layout.mutable_edge_outcomes()->DeleteSubrange(i, 1);
  }
  for (const v1::Sentence& sentence : graph.constraint_list().sentences()) {
    if (!overtaken.contains(sentence.id())) continue;
    v1::Diagnostic& told = acted.diagnostics.emplace_back();
    told.set_severity(v1::SEVERITY_NOTE);
    told.set_code("said_otherwise");
    told.set_message(fmt::format("\"{}\" is dropped: you have said otherwise since", sentence.text()));
  }
}

}  // namespace

absl::StatusOr<Acted> LayoutActs::Say(const Standing& standing, const v1::SaySentence& say, CallContext& call) const {
  const std::string text(absl::StripAsciiWhitespace(say.text()));
  if (text.empty() || text.size() > 400) {
    return InvalidArgument("say.text: {} characters; sentences of 1 to 400", text.size());
  }
  const v1::LayoutGraph& graph = standing.shown.graph();
  const auto has = [&](const std::string& name) {
    const std::optional<v1::Object> known = catalogue_.find(name);
    return HasOne(graph, name) || (known.has_value() && HasOne(graph, known->name()));
  };
  const Wishes wishes = ReadWishes(text, catalogue_.find, has);
  Said said(wishes, standing.shown);
  said.Write(graph.constraint_list());
  ASSIGN_OR_RETURN(const optimizer::EditedProblem with_pieces, optimizer::ApplyEdits(standing.shown, said.adds()));

  v1::SolvedLayout with = standing.shown;
  *with.mutable_graph() = with_pieces.graph;
  IdSet added;
  for (const v1::LayoutEdit& edit : said.adds()) added.insert(edit.add_object().object().id());
  IdSet selected(say.selected_object_ids().begin(), say.selected_object_ids().end());
  v1::ObjectList meant = MeantBy(text, standing.shown, selected);
  for (const v1::Object& object : with_pieces.graph.object_list().objects()) {
    if (added.contains(object.id())) *meant.add_objects() = object;
  }
  std::ranges::stable_sort(*meant.mutable_objects(), {}, &v1::Object::role);

  v1::LayoutGraph understood;
  if (!said.meant().sentences().empty() && !meant.objects().empty()) {
    v1::TranslateRequest request;
    request.set_request_id("flair-session");
    *request.mutable_room() = graph.room();
    *request.mutable_zone_plan() = graph.zone_plan();
    *request.mutable_object_list() = meant;
    *request.mutable_style_sheet() = LooksOf(request.object_list(), with);
    *request.mutable_constraint_list() = said.meant();
    ASSIGN_OR_RETURN(*request.mutable_catalog(), stages_.Catalog(call));
    RETURN_IF_ERROR(Validate(request));
    ASSIGN_OR_RETURN(v1::TranslateResponse translated, stages_.Translate(request, call));
    understood.Swap(translated.mutable_layout_graph());
  }
  std::vector<std::string> refusals;
  for (const std::string& name : wishes.unknown) {
    refusals.push_back(fmt::format("I know no \"{}\"; the furniture list has {}", name, catalogue_.some));
  }
  IdSet meaning, words;
  for (const v1::ConstraintEdge& edge : understood.edges()) meaning.insert(edge.sentence_id());
  v1::SolvedLayout shown = standing.shown, settled = standing.settled == nullptr ? shown : *standing.settled;
  for (const v1::Sentence& sentence : said.shown().sentences()) {
    if (!meaning.contains(sentence.id())) {
      refusals.push_back(Refusal(sentence, understood, catalogue_));
      continue;
    }
    words.insert(Plain(sentence.text()));
    for (v1::SolvedLayout* layout : {&shown, &settled})
      *layout->mutable_graph()->mutable_constraint_list()->add_sentences() = sentence;
  }
  if (understood.edges().empty() && said.adds().empty()) {
    return InvalidArgument("say.text: {}", refusals.empty() ? "nothing is said" : refusals.front());
  }
  EditList edits = said.adds();
  DropSame(graph, words, edits);
  Aim aim{meaning, {}};
  std::string id = FreeId(graph.edges(), "e");
  for (const v1::ConstraintEdge& edge : understood.edges()) {
    v1::ConstraintEdge& one = *edits.Add()->mutable_add_edge();
    one = edge;
    one.set_id(id);
    id = "e" + std::to_string(std::stoi(id.substr(1)) + 1);
    aim.object_ids.insert(SubjectOf(edge, with_pieces.graph));
  }
  // Who says something of a piece that was placed by hand wants it to move.
  ObjectIds by_hand = standing.by_hand;
  std::erase_if(by_hand, [&](const std::string& one) { return aim.object_ids.contains(one); });
  aim.object_ids.insert(added.begin(), added.end());
  // Without a designer at hand a piece comes as it is.
  absl::StatusOr<v1::LayoutGraph> designers;
  if (!added.empty()) designers = LetDesignerSpeak(added, with, shown, edits, aim, call);
  ASSIGN_OR_RETURN(
      Acted acted,
      Tried({shown, standing.settled == nullptr ? nullptr : &settled, standing.pending, by_hand}, edits, aim, call));
  if (designers.ok()) ReturnSubjects(*designers, *acted.layout.mutable_graph());
  acted.label = SayLabel(text) + AlsoMoved(standing.shown, acted.layout, acted.moved_ids);
  for (const v1::Diagnostic& remark : understood.diagnostics()) {
    if (!meaning.contains(remark.subject_id())) continue;
    acted.diagnostics.push_back(remark);
    acted.diagnostics.back().set_message(WithNames(remark.message(), acted.layout));
  }
  for (std::string& refusal : refusals) Warn("not_understood", "", std::move(refusal), acted);
  for (const v1::Sentence& sentence : said.shown().sentences()) {
    const std::string unmet = WhyUnmet(acted.layout, {sentence.id()});
    if (!meaning.contains(sentence.id()) || unmet.empty()) continue;
    const IdSet about = ObjectsOf({sentence.id()}, acted.layout.graph());
    ASSIGN_OR_RETURN(const std::string why, WhyNot(acted.layout, {{sentence.id()}, about}, call));
    Warn("said_in_vain", about.empty() ? "" : *about.begin(),
         fmt::format("\"{}\" is noted but does not hold: {}; {}", sentence.text(), unmet, why), acted);
  }
  DropOvertaken(meaning, acted);
  return acted;
}

}  // namespace flair::session
