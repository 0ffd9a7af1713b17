// SPDX-License-Identifier: GPL-3.0-or-later
// Room to pull chairs out.
#include "translator_worker/grammar/rules/rule.h"
#include "translator_worker/grammar/rules/space.h"

namespace flair::translator {
namespace {

// A chair is pulled out backwards; room for "the chair" of a desk is in front of the desk.
void PullOut(const Match& match, std::string_view, Composer& composer) {
  const Mention* const chairs = match.a != nullptr ? match.a : match.b;
  std::vector<Placed> movers = composer.Movers(chairs);
  const std::vector<Placed>& subjects = composer.subjects();
  if (!subjects.empty() && !composer.IsChair(subjects.front())) {
    // Several chairs stand all round a table, one in front of a desk.
    const bool all_round = chairs != nullptr && chairs->references.front().plural;
    for (const Placed& subject : subjects) {
      // "0.8 m around the table, so that chairs can be pulled out": the figure serves it.
      if (all_round && composer.KeepsSpace(subject)) return;
      if (all_round) KeepSpaceAt(subject, {"front", "back", "left", "right"}, match.distance, composer);
    }
    if (all_round) return;
    movers = subjects;
  }
  for (const Placed& mover : movers) {
    KeepSpaceAt(mover, {composer.IsChair(mover) ? "back" : "front"}, match.distance, composer);
  }
}

// "Pushed in with its front towards the table": the rest says where it stands.
void PushedIn(const Match&, std::string_view, Composer& composer) {
  composer.Note("partial", "what holds only when nobody sits there cannot be asked for");
}

// "Chairs need space to be pulled out on the long sides": of the table that is spoken of.
void PullOutAtSides(const Match& match, std::string_view, Composer& composer) {
  for (const Placed& subject : composer.subjects()) {
    if (composer.IsChair(subject)) continue;
    for (const Reference& reference : match.c->references) {
      KeepSpace({{subject.object, reference.side}}, match.distance, composer);
    }
  }
  if (composer.calls().empty()) PullOut({match.a, match.b, nullptr, match.distance, match.length}, "", composer);
}

// "Space for a chair" at a desk is in front of it.
void ChairSpace(const Match& match, std::string_view tag, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  const std::vector<Placed>& subjects = composer.subjects();
  if (!movers.empty() && composer.IsChair(movers.front()) && !subjects.empty()) {
    PullOut(match, tag, composer);
  } else {
    composer.Refuse("unknown_sentence", "say where the space is: in front of it, behind it or around it");
  }
}

}  // namespace

std::vector<Rule> PullOutRules() {
  return {
      {"A? space? D? space? pull_out ,? D? space?", PullOut},
      {"A? space? D? space pushed_in", PullOut},
      {"A? D for/to pushed_in", PullOut},
      {"A? space for/to pushed_in", PullOut},
      {"pushed_in", PushedIn},
      {"A? space for? A pull_out", PullOut},
      {"A? space for? A pull_out ,? at_sides/all_sides/around", PullOut},
      {"A? space? D? space? ,? at_sides for/to? A? pull_out", PullOut},
      {"A? space? pull_out ,? all_sides", PullOut},
      {"A? space? pull_out ,? not block B", PullOut},
      {"space for/to? pull_out", PullOut},
      {"space for A ,? to? pull_out D", PullOut},
      {"space ,? D? space? for/to? pull_out A.object", PullOut},
      {"A? space? D? space? pull_out away_from C", PullOut},
      {"clear_of B pull_out", PullOut},
      {"A? space? D? space? pull_out on/at_sides/along/away_from C.side", PullOutAtSides},
      {"D space? for A pull_out", PullOut},
      {"D space? for A pull_out away_from C", PullOut},
      {"space for A.object", ChairSpace},
      {"space for A.object to pull_out/C.vague", ChairSpace},
  };
}

}  // namespace flair::translator
