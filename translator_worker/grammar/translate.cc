// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/translate.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "absl/strings/str_join.h"
#include "fmt/format.h"
#include "translator_worker/catalog/catalog_index.h"
#include "translator_worker/grammar/composer.h"
#include "translator_worker/grammar/scene_names.h"
#include "translator_worker/grammar/term.h"
#include "translator_worker/grammar/walk.h"

namespace flair::translator {

namespace {

// What happens to an object stays, "overshadowed by", and so does what is denied: "minimize distractions from".
Analysis WithoutUnknown(const Analysis& analysis) {
  Analysis known = analysis;
  known.terms.clear();
  for (size_t i = 0; i < analysis.terms.size(); ++i) {
    const Term& term = analysis.terms[i];
    const bool passive = i + 1 < analysis.terms.size() && term.lemma.ends_with("ed") && term.lemma != "seated" &&
                         analysis.terms[i + 1].IsWord("next_to");
    const bool denied = i > 0 && analysis.terms[i - 1].IsWord("not") && !term.lemma.ends_with("ing");
    if (term.kind != Term::Kind::kUnknown || passive || denied) {
      known.terms.push_back(term);
    } else if (i > 0 && i + 1 < analysis.terms.size() && analysis.terms[i - 1].kind == Term::Kind::kWord &&
               analysis.terms[i + 1].IsWord("of")) {
      ++i;  // "away from the draught of the door"
    }
  }
  return known;
}

// "These constraints ensure that all pieces are accessible": about the list, not about a piece.
bool SpeaksOfArrangement(const Analysis& analysis) {
  const auto first = std::find_if(analysis.terms.begin(), analysis.terms.end(),
                                  [](const Term& term) { return term.kind != Term::Kind::kUnknown; });
  return first != analysis.terms.end() && first->kind == Term::Kind::kMention &&
         first->mention.references.front().name == "arrangement";
}

// "When not in use, it can be pushed under the desk": a place of certain times. A wall that it stands at then is one
// that it may stand at.
bool IsStowedAtTimes(const Analysis& analysis) {
  const auto says = [&](std::string_view lemma) {
    return std::any_of(analysis.terms.begin(), analysis.terms.end(),
                       [&](const Term& term) { return term.IsWord(lemma); });
  };
  return says("under_when_unused") && (says("pushed_under") || says("pull_out") || says("under"));
}

}  // namespace

Translation TranslateSentence(const v1::TranslateRequest& request, const SceneNames& names, const CatalogIndex& catalog,
                              const v1::Sentence& sentence) {
  Composer composer(request, names, catalog, sentence);
  Analysis analysis = Analyse(sentence.text(), names);
  // "Installed to the right of the sink": only small things hang.
  if (sentence.scope() != v1::SENTENCE_SCOPE_TERTIARY) {
    std::erase_if(analysis.terms, [](const Term& term) { return term.IsWord("hanging"); });
  }
  Translation result;
  result.weight_factor = analysis.wish ? 0.5 : 1;
  if (SpeaksOfArrangement(analysis)) {
    composer.Refuse("not_about_layout", "what is said of all constraints together places nothing");
  } else if (analysis.conditional || IsStowedAtTimes(analysis)) {
    composer.Refuse("conditional", "what holds only under a condition cannot be asked for; say what shall hold");
  } else {
    Walk walk(analysis, composer, sentence.text(), false);
    walk.Run();
    const auto nothing_yet = [&] { return composer.calls().empty() && composer.refusals().empty(); };
    // A word that is not known may stand within a fact that is: "positioned snugly-ish next to the bed".
    const bool not_understood = composer.calls().empty() && composer.OnlyUnknown();
    const Analysis known = not_understood ? WithoutUnknown(analysis) : Analysis{};
    if (not_understood && known.terms.size() < analysis.terms.size()) {
      composer.ForgetUnknown();
      Walk(known, composer, sentence.text(), false).Run();
    }
    if (nothing_yet() && walk.reasons() && !walk.vague()) {
      // "Positioned to create a nook away from the TV": all that it says stands in the reason.
      Walk(analysis, composer, sentence.text(), true).Run();
      if (nothing_yet()) Walk(known, composer, sentence.text(), true).Run();
    }
    walk.RefuseVague();
    if (analysis.partly_conditional) {
      composer.Refuse("conditional", "what holds only under a condition cannot be asked for; say what shall hold");
    }
    if (composer.calls().empty() && composer.refusals().empty()) {
      composer.Refuse(
          "unknown_sentence",
          "no relation was understood; say for example \"the X is against a wall\", \"the X is 0.5 m in front of "
          "the Y\" or \"the front of the X is accessible\"");
    }
    if (!composer.calls().empty() && !walk.left_over().empty()) {
      const size_t shown = std::min<size_t>(walk.left_over().size(), 8);
      composer.Note("partial", fmt::format("not understood: {}",
                                           absl::StrJoin(walk.left_over().begin(),
                                                         walk.left_over().begin() + static_cast<long>(shown), ", ")));
    }
  }
  result.calls = composer.calls();
  for (v1::Diagnostic refusal : composer.refusals()) {
    if (!result.calls.empty()) refusal.set_code("partial");
    result.diagnostics.push_back(std::move(refusal));
  }
  result.diagnostics.insert(result.diagnostics.end(), composer.notes().begin(), composer.notes().end());
  return result;
}

v1::LayoutGraph Translate(const v1::TranslateRequest& request) {
  v1::LayoutGraph graph;
  *graph.mutable_room() = request.room();
  *graph.mutable_zone_plan() = request.zone_plan();
  *graph.mutable_object_list() = request.object_list();
  if (request.has_style_sheet()) *graph.mutable_style_sheet() = request.style_sheet();
  *graph.mutable_constraint_list() = request.constraint_list();
  graph.set_catalog_library(request.catalog().library());
  const SceneNames all_names(request.room(), request.zone_plan(), request.object_list());
  const SceneNames floor_names(request.room(), request.zone_plan(), request.object_list(), NamedObjects::kFloorFirst);
  const CatalogIndex catalog(request.catalog());
  for (const v1::Sentence& sentence : request.constraint_list().sentences()) {
    const SceneNames& names = sentence.scope() == v1::SENTENCE_SCOPE_TERTIARY ? all_names : floor_names;
    Translation translation = TranslateSentence(request, names, catalog, sentence);
    for (Call& call : translation.calls) {
      v1::ConstraintEdge& edge = *graph.add_edges();
      edge.set_id("e" + std::to_string(graph.edges_size()));
      edge.set_type(call.type);
      for (v1::Argument& argument : call.arguments) *edge.add_arguments() = std::move(argument);
      edge.set_weight((sentence.weight() > 0 ? sentence.weight() : 1) * translation.weight_factor);
      edge.set_sentence_id(sentence.id());
    }
    for (v1::Diagnostic& diagnostic : translation.diagnostics) *graph.add_diagnostics() = std::move(diagnostic);
  }
  return graph;
}

}  // namespace flair::translator
