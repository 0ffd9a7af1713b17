// SPDX-License-Identifier: GPL-3.0-or-later
// The part of Composer that chooses which objects of a name, a kind or a group are meant.
#include <algorithm>
#include <iterator>

#include "absl/strings/str_join.h"
#include "fmt/format.h"
#include "translator_worker/grammar/composer.h"

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
  std::vector<std::string> ids;
  for (const int index : candidates) ids.push_back(object(index).id());
  Refuse("ambiguous_object", fmt::format("\"{}\" may be {}; say which", reference.name, absl::StrJoin(ids, ", ")));
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
