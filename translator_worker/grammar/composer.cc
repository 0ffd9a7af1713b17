// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/composer.h"

#include <iterator>

#include "absl/strings/str_join.h"
#include "english/frames/noun_phrases.h"
#include "english/language.h"
#include "english/words.h"
#include "fmt/format.h"
#include "translator_worker/grammar/translate.h"

namespace flair::translator {
namespace {

// Keeps those that the test is true of, when there are that many.
template <typename Wanted>
void KeepWhere(std::vector<int>& objects, Wanted&& wanted, size_t least = 1) {
  std::vector<int> kept;
  std::copy_if(objects.begin(), objects.end(), std::back_inserter(kept), wanted);
  if (kept.size() >= least) objects = kept;
}

}  // namespace

Composer::Composer(const v1::TranslateRequest& request, const SceneNames& names, const CatalogIndex& catalog,
                   const v1::Sentence& sentence)
    : request_(request), names_(names), catalog_(catalog), sentence_(sentence) {
  for (const std::string& subject : sentence.subject_ids()) {
    for (int i = 0; i < request.object_list().objects_size(); ++i) {
      if (object(i).id() == subject) subjects_.push_back({i, ""});
    }
  }
  // Of a heading that names several kinds of things the first is what moves.
  std::vector<Placed> others;
  for (const Placed& placed : subjects_) (IsLike(placed, subjects_.front()) ? topic_ : others).push_back(placed);
  if (sentence.scope() != v1::SENTENCE_SCOPE_INTER) return;
  // A bare distance in a sentence about two things, or two kinds of them, is kept between them.
  const bool two_kinds = !others.empty() && std::ranges::all_of(others, [&](const Placed& other) {
    return IsLike(other, others.front());
  });
  if (subjects_.size() == 2) {
    SetPair({subjects_[0]}, {subjects_[1]});
  } else if (two_kinds) {
    SetPair(topic_, others);
  }
}

bool Composer::PlacedIs(std::string_view kind, const Placed& placed) const {
  const v1::Object& it = object(placed.object);
  if (kind == "floor") return it.kind() == v1::OBJECT_KIND_FLOOR;
  if (kind == "wall") return it.kind() == v1::OBJECT_KIND_WALL;
  if (kind == "ceiling") return it.kind() == v1::OBJECT_KIND_CEILING;
  if (kind == "surface") return it.kind() == v1::OBJECT_KIND_SURFACE;
  if (kind == "primary") return it.role() == v1::OBJECT_ROLE_PRIMARY;
  if (kind == "tertiary") return it.role() == v1::OBJECT_ROLE_TERTIARY;
  if (kind == "rug") return it.walk_over();
  if (kind == "sat-at") return it.sat_at();
  if (kind == "small-rug") return it.walk_over() && it.role() == v1::OBJECT_ROLE_TERTIARY;
  const auto is_placed = [&](const Call& call) {
    const bool so = kind == "on-top" ? call.arguments.size() > 1 && call.arguments[1].name() == "host"
                                     : call.type == (kind == "in-corner" ? "in_corner" : "accessible");
    return so && call.arguments.front().value().text() == it.id();
  };
  if (kind == "in-corner" || kind == "on-top") return std::ranges::any_of(calls_, is_placed);
  if (kind == "last-space") return !calls_.empty() && is_placed(calls_.back());
  if (kind == "own-chair") {
    return scope() == v1::SENTENCE_SCOPE_INTRA && subjects_.size() == 1 && subjects_.front().object != placed.object &&
           IsChair(placed) && !IsChair(subjects_.front());
  }
  const std::string_view name = english::WithoutNumber(it.name());
  const std::string last = english::Singular(name.substr(name.find_last_of(" _") + 1));
  const english::Language& language = english::Language::Get();
  // "Armchair", but not "workbench".
  return language.IsIn(kind, last) || (last.size() > 5 && last.ends_with("chair") && language.IsIn(kind, "chair"));
}

bool Composer::HasFeature(const std::string& kind) const {
  if (kind == "socket") return request_.room().sockets_size() > 0;
  const auto wanted = kind == "door" ? v1::OPENING_KIND_DOOR : v1::OPENING_KIND_WINDOW;
  return std::ranges::any_of(request_.room().openings(),
                             [&](const v1::Opening& opening) { return opening.kind() == wanted; });
}

void Composer::SetPair(std::vector<Placed> movers, std::vector<Placed> targets) {
  pair_movers_ = std::move(movers);
  pair_targets_ = std::move(targets);
}

void Composer::SetTopic(std::vector<Placed> topic) {
  if (topic.empty() || topic_.empty() || topic.front().object != topic_.front().object) earlier_topic_ = topic_;
  topic_ = std::move(topic);
}

void Composer::SpeakOf(const Mention& mention) {
  if (mention.references.front().kind != RefKind::kObjects) return;
  // What a thing on a table or wall is about is its heading: "Desk organizer: on the shelf".
  if (scope() == v1::SENTENCE_SCOPE_TERTIARY && !subjects_.empty()) return;
  std::vector<Placed> movers = Movers(&mention);
  for (Placed& placed : movers) placed.side.clear();
  if (!movers.empty()) SetTopic(std::move(movers));
}

void Composer::Refuse(std::string_view code, const std::string& message) {
  v1::Diagnostic remark = RemarkOn(sentence_, v1::SEVERITY_WARNING, code, message);
  const bool known =
      std::ranges::any_of(refusals_, [&](const v1::Diagnostic& other) { return other.message() == remark.message(); });
  if (!known) refusals_.push_back(std::move(remark));
}

bool Composer::OnlyUnknown() const {
  return std::ranges::all_of(refusals_,
                             [](const v1::Diagnostic& refusal) { return refusal.code() == "unknown_sentence"; });
}

void Composer::Note(std::string_view code, const std::string& message) {
  notes_.push_back(RemarkOn(sentence_, v1::SEVERITY_NOTE, code, message));
}

std::vector<int> Composer::Choose(const Reference& reference, const std::vector<Placed>& movers) {
  std::vector<int> candidates = reference.candidates;
  if (reference.chosen) return candidates;
  const bool any = reference.any && !movers.empty();
  // "One lamp on the nightstand" under a heading of one. "The second lamp" counts all lamps, also under its own
  // heading.
  if (scope() == v1::SENTENCE_SCOPE_TERTIARY && movers.empty()) {
    std::vector<int> named = candidates;
    KeepSubjects(named);
    const bool counts_further =
        reference.ordinal != english::kLast && reference.ordinal > static_cast<int>(named.size());
    if (named.size() < candidates.size() && !counts_further) candidates = named;
  }
  if (reference.ordinal == english::kLast && !any && !candidates.empty()) return {candidates.back()};
  if (reference.ordinal > 0 && !any) {
    if (reference.ordinal <= static_cast<int>(candidates.size())) return {candidates[reference.ordinal - 1]};
    Refuse("names_absent_object",
           fmt::format("there is no {}. {}; there are {}", reference.ordinal, reference.name, candidates.size()));
    return {};
  }
  const auto weak_subject = [&](int index) { return Contains(subjects_, index); };
  if ((!reference.full || (scope() == v1::SENTENCE_SCOPE_INTRA && movers.empty())) &&
      std::ranges::none_of(candidates, weak_subject)) {
    for (const int index : reference.weak_candidates) {
      if (weak_subject(index) && !reference.plural) return {index};
    }
  }
  if (reference.plural || reference.each) KeepThoseSpokenOf(reference, candidates);
  if (candidates.size() < 2 || ((reference.plural || reference.each) && !any)) return candidates;
  // Singular with several of the name: those that the sentence is about, then those of one name, then of the same zone.
  const auto keep = [&](auto&& wanted) { KeepWhere(candidates, wanted); };
  keep([&](int index) { return !Contains(movers, index); });
  KeepSubjects(candidates);
  const auto one_name = [&] {
    return std::ranges::all_of(candidates, [&](int i) { return object(i).name() == object(candidates[0]).name(); });
  };
  if (candidates.size() == 1) return candidates;
  if (subjects_.empty()) keep([&](int index) { return object(index).role() == v1::OBJECT_ROLE_PRIMARY; });
  const std::vector<Placed>& speaker = movers.empty() ? topic_ : movers;
  if (!speaker.empty()) {
    const std::string& host = object(speaker.front().object).host_id();
    keep([&](int index) { return object(index).id() == host; });
    if (candidates.size() > 1) KeepZone(candidates, speaker.front());
  }
  keep([&](int index) { return object(index).role() != v1::OBJECT_ROLE_TERTIARY; });
  // "They face the table" of a zone with a main table and a side table.
  if (!one_name()) keep([&](int index) { return object(index).role() == v1::OBJECT_ROLE_PRIMARY; });
  if (one_name()) return candidates;
  std::vector<std::string> names;
  for (const int index : candidates) names.push_back(object(index).name());
  Refuse("ambiguous_object",
         fmt::format("\"{}\" may be the {}; say which", reference.name, absl::StrJoin(names, ", the ")));
  return {};
}

std::vector<int> Composer::Group(const std::string& name, const std::vector<Placed>& movers) const {
  std::vector<int> result;
  if (name == "kind") return result;
  for (int i = 0; i < request_.object_list().objects_size(); ++i) {
    const v1::Object& candidate = object(i);
    if (candidate.kind() != v1::OBJECT_KIND_FLOOR || candidate.role() == v1::OBJECT_ROLE_TERTIARY ||
        candidate.walk_over())
      continue;
    const bool meant = name == "others"    ? !Contains(movers, i) && !Contains(topic_, i)
                       : name == "primary" ? candidate.role() == v1::OBJECT_ROLE_PRIMARY
                       : name == "seating" ? PlacedIs("seats", {i, ""})
                                           : name != "heat" || PlacedIs("hot-things", {i, ""});
    if (meant) result.push_back(i);
  }
  return result;
}

std::vector<Placed> Composer::Primaries() const {
  constexpr size_t kMost = 6;
  std::vector<Placed> result;
  for (int i = 0; i < request_.object_list().objects_size(); ++i) {
    if (object(i).role() == v1::OBJECT_ROLE_PRIMARY && object(i).kind() == v1::OBJECT_KIND_FLOOR)
      result.push_back({i, ""});
  }
  if (result.size() > kMost) result.clear();
  return result;
}

void Composer::KeepSubjects(std::vector<int>& objects) const {
  KeepWhere(objects, [&](int index) { return Contains(subjects_, index); });
}

void Composer::KeepThoseSpokenOf(const Reference& reference, std::vector<int>& objects) const {
  std::vector<int> kept = objects;
  KeepSubjects(kept);
  const bool named = std::ranges::any_of(objects, [&](int index) { return Contains(subjects_, index); });
  if (named) {
    // "Each chair" under a heading that names one of them: the kind, not this one.
    if (kept.size() > 1 || !reference.each) objects = kept;
    return;
  }
  if (subjects_.empty() || objects.size() < 2) return;
  // "Chairs" under a heading of stools are these.
  const auto seat = [&](int index) { return IsChair({index, ""}); };
  if (std::ranges::all_of(objects, seat)) {
    std::vector<int> seats;
    for (const Placed& subject : subjects_) {
      if (IsChair(subject)) seats.push_back(subject.object);
    }
    if (seats.size() > 1) {
      objects = seats;
      return;
    }
  }
  // "The chairs" under a heading of a table are its own, else those of its zone.
  const std::string& host = id(subjects_.front());
  KeepWhere(
      objects, [&](int index) { return object(index).host_id() == host; }, 2);
  KeepWhere(
      objects, [&](int index) { return IsInZoneOf(index, subjects_.front()); }, 2);
}

void Composer::KeepZone(std::vector<int>& objects, const Placed& mover) const {
  KeepWhere(objects, [&](int index) { return IsInZoneOf(index, mover); });
}

}  // namespace flair::translator
