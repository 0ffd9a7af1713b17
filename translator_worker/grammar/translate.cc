// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/translate.h"

#include <algorithm>
#include <span>
#include <utility>

#include "absl/strings/str_join.h"
#include "english/frames/frames.h"
#include "english/frames/term.h"
#include "fmt/format.h"
#include "translator_worker/grammar/composer.h"
#include "translator_worker/grammar/meanings.h"

namespace flair::translator {

using english::Analysis;
using english::FrameBook;
using english::Term;

namespace {

// No pattern is longer than this many terms.
constexpr size_t kLongestFact = 14;

// Reads a sentence from left to right: at each term the rule that covers most is taken; what none covers is left over.
// Borrows its arguments. Linear in the number of terms.
class Walk {
 public:
  // `reads_reasons`: what follows "to" and "for" is read like the rest.
  Walk(const Analysis& analysis, Composer& composer, std::string_view text, bool reads_reasons)
      : terms_(analysis.terms), composer_(composer), text_(text), reads_reasons_(reads_reasons) {}

  void Run() {
    while (at_ < terms_.size()) {
      const Term& term = terms_[at_];
      if (term.kind == Term::Kind::kStop) {
        in_reason_ = false;
        denied_ = false;
        clause_begins_ = true;
        ++at_;
        continue;
      }
      // "To allow talks without crowding the sofa": what is ruled out holds whatever the reason.
      if (term.IsWord("not") && text_.substr(term.begin, term.end - term.begin) == "without") in_reason_ = false;
      if ((!in_reason_ || term.kind == Term::Kind::kDistance) && TakeFact()) {
        in_reason_ = false;
        clause_begins_ = false;
      } else {
        LeaveOver(term);
        ++at_;
      }
    }
  }

  // Content words that no fact covered.
  const std::vector<std::string>& left_over() const { return left_over_; }
  // Whether something was skipped as a reason.
  bool reasons() const { return reasons_; }
  // Whether it names something no call is about.
  bool vague() const {
    return std::ranges::any_of(unused_, [](const Mention* mention) {
      return std::ranges::any_of(mention->references,
                                 [](const Reference& reference) { return reference.kind == RefKind::kVague; });
    });
  }

  // Left-over noun phrases that name something no call is about.
  void RefuseVague() {
    for (const Mention* mention : unused_) {
      for (const Reference& reference : mention->references) {
        if (reference.kind == RefKind::kVague) {
          composer_.Refuse(
              "not_about_layout",
              fmt::format("{} cannot be said by a layout call; name the objects and distances that serve it",
                          reference.name));
        } else if (reference.kind == RefKind::kAbsent) {
          composer_.Refuse("names_absent_object", fmt::format("the room has no \"{}\"", reference.name));
        }
      }
    }
  }

 private:
  bool TakeFact() {
    const std::span<const Term> rest(terms_.data() + at_, std::min(kLongestFact, terms_.size() - at_));
    FrameBook::Hit hit = FrameBook::Get().Find(rest);
    if (!hit.meaning.empty() && EndsInNextFact(hit.match.length))
      hit = FrameBook::Get().Find(rest.first(hit.match.length - 2));
    if (!hit.meaning.empty() && EndsInNextSubject(hit.match.length))
      hit = FrameBook::Get().Find(rest.first(hit.match.length - 1));
    if (hit.meaning.empty() || Passive()) return false;
    // "against a wall or beside the bed": the first is taken, the choice is free.
    const size_t before = composer_.calls().size();
    const bool alternative = after_or_ && before > calls_at_or_;
    if (denied_) {
      composer_.Refuse("unknown_sentence", "this relation cannot be denied; say what shall hold instead");
    } else if (!alternative) {
      if (hit.match.a != nullptr) composer_.SpeakOf(*hit.match.a);
      composer_.BeginFact();
      MakeCalls(hit.meaning, hit.match, hit.detail, composer_);
    }
    at_ += hit.match.length;
    PassRepeatedPartner();
    after_or_ = at_ < terms_.size() && terms_[at_].IsWord("or");
    if (after_or_) {
      calls_at_or_ = before;
      ++at_;
    }
    return true;
  }

  // "To the left of the table, at most 0.5 m from it": the partner of the figure is named once more.
  void PassRepeatedPartner() {
    if (at_ == 0 || at_ + 1 >= terms_.size() || terms_[at_ - 1].kind != Term::Kind::kDistance) return;
    if (!terms_[at_].IsWord("away_from") || terms_[at_ + 1].kind != Term::Kind::kMention) return;
    const Reference& first = terms_[at_ + 1].mention.references.front();
    if (first.kind == RefKind::kPronoun && first.side.empty() && !composer_.pair_targets().empty()) at_ += 2;
  }

  // "Away from the shelf and at least 1 m from the stool": the figure is for the stool.
  bool EndsInNextFact(size_t length) const {
    const size_t next = at_ + length;
    if (length < 4 || next + 1 >= terms_.size() || terms_[next - 1].kind != Term::Kind::kDistance) return false;
    const Term& joint = terms_[next - 2];
    const bool joined = joint.kind == Term::Kind::kSoft && joint.lemma != "(" && joint.lemma != ")";
    const Term& relation = terms_[next];
    const bool relates = relation.IsAnyWord({"away_from", "in_front_of", "behind", "left_of", "right_of", "to_side"});
    return joined && relates && terms_[next + 1].kind == Term::Kind::kMention &&
           !terms_[next + 1].Mentions(RefKind::kPronoun);
  }

  // "Against a wall and its front needs 0.8 m", "against the wall with the front facing the room": of the side comes
  // more.
  bool EndsInNextSubject(size_t length) const {
    const size_t next = at_ + length;
    if (length < 3 || next >= terms_.size() || terms_[next - 2].kind != Term::Kind::kSoft) return false;
    const Term& verb = terms_[next];
    // "Along a wall with the long side against it": of that wall.
    const bool of_it = next + 1 < terms_.size() && verb.IsAnyWord({"against", "facing", "along"}) &&
                       terms_[next + 1].Mentions(RefKind::kPronoun);
    if (of_it) return false;
    const bool goes_on = verb.kind == Term::Kind::kDistance ||
                         (verb.kind == Term::Kind::kWord && !verb.IsWord("or") && !verb.IsWord("of"));
    return terms_[next - 1].IsOwnSide() && goes_on;
  }

  // "overshadowed by the bed": what happens to it, not where it is.
  bool Passive() const {
    if (at_ == 0 || !terms_[at_].IsWord("next_to") || terms_[at_].end - terms_[at_].begin != 2) return false;
    const Term& before = terms_[at_ - 1];
    return before.kind == Term::Kind::kUnknown && before.lemma.size() > 3 && before.lemma.ends_with("ed");
  }

  // "So that its left side touches the stand": what touches what, no reason.
  bool TellsOwnSide() const {
    if (at_ + 2 >= terms_.size() || terms_[at_].lemma != "so") return false;
    return terms_[at_ + 1].IsOwnSide() && terms_[at_ + 2].IsAnyWord({"against", "next_to"});
  }

  void LeaveOver(const Term& term) {
    switch (term.kind) {
      case Term::Kind::kPurpose:
        // "that" after a thing tells which one; "ensure that" tells nothing.
        if (reads_reasons_ && (term.lemma == "to" || term.lemma == "for" || term.lemma == "so")) break;
        if (TellsOwnSide()) break;
        if (term.lemma != "that" || (at_ > 0 && terms_[at_ - 1].kind == Term::Kind::kMention)) in_reason_ = true;
        reasons_ = reasons_ || term.lemma == "to" || term.lemma == "for" || term.lemma == "so";
        break;
      case Term::Kind::kWord:
        if (!in_reason_ && term.lemma == "not") denied_ = true;
        break;
      case Term::Kind::kSoft:
        denied_ = false;
        if (term.lemma == "," || term.lemma == "but" || term.lemma == "while" || term.lemma == "with" ||
            term.lemma == "(" || term.lemma == ")" || term.lemma == ":")
          in_reason_ = false;
        break;
      case Term::Kind::kMention:
        if (in_reason_) break;
        if (at_ > 0 && terms_[at_ - 1].IsSoft("(") && term.IsOwnSide())
          composer_.CompleteSide(term.mention.references.front().side);
        if (clause_begins_) composer_.SpeakOf(term.mention);
        if (term.mention.references.front().kind == RefKind::kObjects && composer_.topic().empty())
          composer_.SpeakOf(term.mention);
        unused_.push_back(&term.mention);
        clause_begins_ = false;
        break;
      case Term::Kind::kUnknown:
      case Term::Kind::kDistance:
        if (!in_reason_) left_over_.push_back(Quote(text_.substr(term.begin, term.end - term.begin)));
        break;
      default:
        break;
    }
  }

  const std::vector<Term>& terms_;
  Composer& composer_;
  const std::string_view text_;
  const bool reads_reasons_;
  bool reasons_ = false;
  size_t at_ = 0;
  bool in_reason_ = false;
  bool clause_begins_ = true;
  // A "not" that no rule took: what follows must not be read as wanted.
  bool denied_ = false;
  bool after_or_ = false;
  size_t calls_at_or_ = 0;
  std::vector<std::string> left_over_;
  std::vector<const Mention*> unused_;
};

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

// Reads the text; says whether it is a wish.
bool ReadText(const v1::Sentence& sentence, const SceneNames& names, Composer& composer) {
  Analysis analysis = english::Analyse(sentence.text(), names);
  // "Installed to the right of the sink": only small things hang.
  if (sentence.scope() != v1::SENTENCE_SCOPE_TERTIARY) {
    std::erase_if(analysis.terms, [](const Term& term) { return term.IsWord("hanging"); });
  }
  if (!analysis.conditional) {
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
    if (nothing_yet() && !analysis.partly_conditional) {
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
  if (analysis.conditional || analysis.partly_conditional)
    composer.Refuse("conditional", "what holds only under a condition cannot be asked for; say what shall hold");
  return analysis.wish;
}

}  // namespace

Translation TranslateSentence(const v1::TranslateRequest& request, const SceneNames& names, const CatalogIndex& catalog,
                              const v1::Sentence& sentence) {
  Composer composer(request, names, catalog, sentence);
  bool is_wish = false;
  const absl::StatusOr<std::vector<english::Fact>> facts = TypedFacts(request, sentence);
  if (!facts.ok()) {
    composer.Note("meaning_not_used", fmt::format("its typed meaning is left aside and the text read: {}",
                                                  std::string(facts.status().message())));
  }
  for (const english::Fact& fact : facts.value_or(std::vector<english::Fact>{})) {
    if (fact.a) composer.SpeakOf(*fact.a);
    composer.BeginFact();
    MakeCalls(fact.meaning, fact.AsMatch(), fact.detail, composer);
    is_wish = sentence.meaning().facts(0).strength() == v1::FACT_STRENGTH_WISH;
  }
  if (composer.calls().empty() && composer.refusals().empty()) is_wish = ReadText(sentence, names, composer);
  Translation result;
  result.weight_factor = is_wish ? 0.5 : 1;
  result.calls = composer.calls();
  for (v1::Diagnostic refusal : composer.refusals()) {
    if (!result.calls.empty()) refusal.set_code("partial");
    result.diagnostics.push_back(std::move(refusal));
  }
  result.diagnostics.insert(result.diagnostics.end(), composer.notes().begin(), composer.notes().end());
  return result;
}

v1::Diagnostic RemarkOn(const v1::Sentence& sentence, v1::Severity severity, std::string_view code,
                        const std::string& message) {
  v1::Diagnostic remark;
  remark.set_severity(severity);
  remark.set_code(std::string(code));
  remark.set_message(fmt::format("\"{}\": {}", Quote(sentence.text()), message));
  remark.set_subject_id(sentence.id());
  return remark;
}

v1::LayoutGraph GraphOf(const v1::TranslateRequest& request, std::map<std::string, Translation> translations) {
  v1::LayoutGraph graph;
  *graph.mutable_room() = request.room();
  *graph.mutable_zone_plan() = request.zone_plan();
  *graph.mutable_object_list() = request.object_list();
  if (request.has_style_sheet()) *graph.mutable_style_sheet() = request.style_sheet();
  *graph.mutable_constraint_list() = request.constraint_list();
  graph.set_catalog_library(request.catalog().library());
  for (const v1::Sentence& sentence : request.constraint_list().sentences()) {
    Translation& translation = translations[sentence.id()];
    for (Call& call : translation.calls) {
      v1::ConstraintEdge& edge = *graph.add_edges();
      edge.set_id(fmt::format("e{}", graph.edges_size()));
      edge.set_type(call.type);
      for (v1::Argument& argument : call.arguments) *edge.add_arguments() = std::move(argument);
      edge.set_weight((sentence.weight() > 0 ? sentence.weight() : 1) * translation.weight_factor);
      edge.set_sentence_id(sentence.id());
    }
    for (v1::Diagnostic& diagnostic : translation.diagnostics) *graph.add_diagnostics() = std::move(diagnostic);
  }
  return graph;
}

v1::LayoutGraph Translate(const v1::TranslateRequest& request) {
  const SceneNames all_names(request.room(), request.zone_plan(), request.object_list());
  const SceneNames floor_names(request.room(), request.zone_plan(), request.object_list(), NamedObjects::kFloorFirst);
  const CatalogIndex catalog(request.catalog());
  std::map<std::string, Translation> translations;
  for (const v1::Sentence& sentence : request.constraint_list().sentences()) {
    const SceneNames& names = sentence.scope() == v1::SENTENCE_SCOPE_TERTIARY ? all_names : floor_names;
    translations[sentence.id()] = TranslateSentence(request, names, catalog, sentence);
  }
  return GraphOf(request, std::move(translations));
}

}  // namespace flair::translator
