// SPDX-License-Identifier: GPL-3.0-or-later
// What is said, clause by clause: each is done or told apart.
#include <algorithm>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/str_join.h"
#include "fmt/format.h"
#include "room/conversion/conversion.h"
#include "session/acts/chain.h"
#include "session/acts/layout_acts.h"
#include "session/sentences/answers.h"
#include "session/sentences/asides.h"
#include "session/sentences/names.h"
#include "session/sentences/places.h"
#include "session/sentences/spoken.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::session {
namespace {

using runtime::CallContext;

bool IsRefusal(const absl::Status& status) {
  return absl::IsInvalidArgument(status) || absl::IsFailedPrecondition(status);
}

// Without the field that a caller is told of.
std::string Plainly(const absl::Status& status) {
  constexpr std::string_view kField = "say.text: ";
  const std::string message(status.message());
  return message.starts_with(kField) ? message.substr(kField.size()) : message;
}

// Clauses for a translator that come one after the other are tried together.
struct Batch {
  std::string text;
  std::vector<WishedSentence> places;
  std::vector<std::string> clauses;
};

// What has come of the clauses so far.
struct Told {
  std::vector<std::string> answers, refusals, left_over;
  void Refuse(std::string why, const std::string& clause) {
    if (std::ranges::find(refusals, why) == refusals.end()) refusals.push_back(std::move(why));
    left_over.push_back(clause);
  }
};

// Asks back where a piece is told by a place at which there are several; empty otherwise.
std::string WhichOne(const Spoken& spoken, const v1::SolvedLayout& layout) {
  for (const Meant* const meant : {&spoken.what, &spoken.other}) {
    if (!meant->is_told || !meant->is_one || meant->ids.size() < 2) continue;
    std::vector<std::string> names;
    for (const std::string& id : meant->ids) names.push_back(TheOnes(layout, {id}));
    return fmt::format("which {}: {}?", meant->name, Listed(names, "or"));
  }
  return "";
}

// Why a clause cannot be done, as "done: ..."; empty for others. `examples`: of what can be said instead.
std::string WhyNotDone(const Spoken& spoken, const v1::SolvedLayout& layout, const FindPiece& find,
                       const std::string& examples) {
  if (const std::string which = WhichOne(spoken, layout); !which.empty()) return "done: " + which;
  const bool unread = spoken.act.empty() || !spoken.absent.empty();
  if (const std::string other = unread ? OtherBusiness(spoken.said) : ""; !other.empty()) {
    return fmt::format("done: I only choose and place furniture, {} are not mine to change", other);
  }
  // What is no statement must not become a wish.
  const Tokens tokens = PlainTokens(spoken.said);
  if (!spoken.act.empty() || !IsNoStatement(tokens, {0, tokens.size()})) return "";
  const std::string word = UnknownWord(spoken.said, layout, find);
  return fmt::format("understood{}; {}", word.empty() ? "" : fmt::format(": I do not know \"{}\"", word), examples);
}

}  // namespace

absl::StatusOr<Acted> LayoutActs::Say(const Standing& standing, const v1::SaySentence& say, CallContext& call) const {
  const std::string text(absl::StripAsciiWhitespace(say.text()));
  if (text.empty() || text.size() > 400) {
    return InvalidArgument("say.text: {} characters; sentences of 1 to 400", text.size());
  }
  ASSIGN_OR_RETURN(const Room room, RoomFromProto(standing.shown.graph().room()));
  const IdSet selected(say.selected_object_ids().begin(), say.selected_object_ids().end());
  Chain chain(standing);
  Told told;
  ObjectIds last;
  Batch batch;
  bool is_later = false;
  const auto keep = [&](absl::StatusOr<Acted> acted, const std::string& clause) -> absl::Status {
    if (acted.ok()) {
      if (!acted->answer.empty()) told.answers.push_back(acted->answer);
      if (!acted->left_over.empty()) told.left_over.push_back(acted->left_over);
      chain.Add(*std::move(acted));
      return absl::OkStatus();
    }
    if (!IsRefusal(acted.status())) return acted.status();
    told.Refuse(Plainly(acted.status()), clause);
    return absl::OkStatus();
  };
  const auto say_batch = [&]() -> absl::Status {
    if (batch.clauses.empty()) return absl::OkStatus();
    const Batch now = std::exchange(batch, {});
    v1::SaySentence one = say;
    one.set_text(now.text);
    absl::StatusOr<Acted> acted = SayWishes(chain.standing(), one, now.places, call);
    if (acted.ok()) last = acted->added_ids;
    return keep(std::move(acted), absl::StrJoin(now.clauses, ", "));
  };
  for (const std::string& sentence : SplitSentences(text)) {
    const Tokens tokens = PlainTokens(sentence);
    for (Span span{0, tokens.size()}, rest; !span.empty(); span = rest) {
      // Copied, since what is read holds on to nothing that an act changes.
      const v1::SolvedLayout shown = chain.shown();
      const MeantPieces pieces(shown, selected, last, catalogue_.find);
      Spoken spoken = SpokenReader(pieces, room, is_later).Read(sentence, tokens, span, rest);
      is_later = true;
      if (spoken.act == "reason") continue;
      if (const std::string why = WhyNotDone(spoken, shown, catalogue_.find, Examples(spoken.said, shown, turn_));
          !why.empty()) {
        ++turn_;
        told.Refuse(fmt::format("\"{}\" is not {}", spoken.said, why), spoken.said);
        continue;
      }
      std::optional<std::vector<WishedSentence>> places;
      if (!spoken.act.empty()) places = PlacesSaid(spoken, shown, room);
      if (spoken.act.empty() || places.has_value()) {
        batch.clauses.push_back(spoken.said);
        if (places.has_value()) {
          batch.places.insert(batch.places.end(), places->begin(), places->end());
          last = spoken.what.ids;
        } else {
          batch.text += spoken.said + "\n";
        }
        continue;
      }
      RETURN_IF_ERROR(say_batch());
      const std::string said = spoken.said;
      const ObjectIds about = spoken.what.ids;
      for (const std::string& name : spoken.what.absent) {
        told.Refuse(fmt::format("\"{}\": the room has no {}", said, name), name);
      }
      absl::StatusOr<Acted> acted = DoSpoken(chain.standing(), std::move(spoken), call);
      if (!acted.ok() && IsRefusal(acted.status())) {
        acted = InvalidArgument("\"{}\" is not done: {}", said, Plainly(acted.status()));
      }
      RETURN_IF_ERROR(keep(std::move(acted), said));
      last = about;
    }
  }
  RETURN_IF_ERROR(say_batch());
  if (chain.empty()) {
    return InvalidArgument("say.text: {}",
                           told.refusals.empty() ? "nothing is said" : absl::StrJoin(told.refusals, "; "));
  }
  Acted acted = chain.Take();
  acted.label = SayLabel(text) + AlsoMoved(standing.shown, acted.layout, acted.moved_ids);
  acted.answer = absl::StrJoin(told.answers, " ");
  const std::string harm = HarmDone(standing.shown, acted.layout, acted.diagnostics, acted.answer);
  // With nothing before it there is nothing to say "but" to.
  constexpr std::string_view kBut = " But ";
  const bool alone = acted.answer.empty() && harm.starts_with(kBut);
  acted.answer += alone ? Capital(harm.substr(kBut.size())) : harm;
  acted.left_over = absl::StrJoin(told.left_over, ", ");
  // Of what is said of several pieces alike once is enough.
  std::vector<v1::Diagnostic> once;
  for (v1::Diagnostic& remark : acted.diagnostics) {
    const auto same = [&](const v1::Diagnostic& one) { return one.message() == remark.message(); };
    if (std::ranges::none_of(once, same)) once.push_back(std::move(remark));
  }
  acted.diagnostics = std::move(once);
  for (std::string& refusal : told.refusals) {
    acted.diagnostics.push_back(Remark(v1::SEVERITY_WARNING, "not_understood", "", std::move(refusal)));
  }
  return acted;
}

}  // namespace flair::session
