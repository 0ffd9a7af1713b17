// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked in words of pieces that are there: away with them, other sizes, others in their place, locks.
#include <algorithm>
#include <cmath>
#include <utility>

#include "fmt/format.h"
#include "session/acts/layout_acts.h"
#include "session/layouts/comparing.h"
#include "session/layouts/edits.h"
#include "session/layouts/sizing.h"
#include "session/sentences/answers.h"
#include "session/sentences/names.h"
#include "session/sentences/spoken.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::session {
namespace {

using runtime::CallContext;

std::vector<std::string> KindsOf(const v1::SolvedLayout& layout, const ObjectIds& ids) {
  std::vector<std::string> kinds;
  for (const std::string& id : ids) {
    const std::string name = "the " + NameOf(layout, id);
    if (std::ranges::find(kinds, name) == kinds.end()) kinds.push_back(name);
  }
  return kinds;
}

// " It stands 2.10 m from there now." of a piece that has not come to stand where the one before it stood.
std::string StandsElsewhere(const v1::SolvedLayout& before, const v1::SolvedLayout& after, const std::string& id) {
  constexpr double kSamePlace_m = 0.5;
  const v1::Placement *const was = PlaceOf(before, id), *const is = PlaceOf(after, id);
  if (was == nullptr || is == nullptr) return "";
  const double away_m = std::hypot(is->x_m() - was->x_m(), is->y_m() - was->y_m());
  return away_m < kSamePlace_m ? "" : fmt::format(" It does not stand in its place but {:.2f} m from there.", away_m);
}

}  // namespace

absl::StatusOr<Acted> LayoutActs::RemoveSpoken(const Standing& standing, const Spoken& spoken,
                                               CallContext& call) const {
  ObjectIds ids = spoken.what.ids;
  const size_t of_kind = ids.size();
  // Who wants one chair less keeps those that were there first.
  if (spoken.what.is_one) ids = {ids.back()};
  v1::EditLayout edit;
  for (const std::string& id : ids) edit.add_edits()->set_remove_object_id(id);
  ASSIGN_OR_RETURN(Acted acted, Edit(standing, edit, call));
  acted.answer = spoken.what.is_one
                     ? fmt::format("Removed one of the {} {}s.", of_kind, NameOf(standing.shown, ids.front()))
                     : fmt::format("Removed {}.", spoken.what.is_all ? "everything" : TheOnes(standing.shown, ids));
  acted.answer += MovedToo(acted.layout, acted.moved_ids, {});
  return acted;
}

absl::StatusOr<Acted> LayoutActs::ResizeSpoken(const Standing& standing, const Spoken& spoken,
                                               CallContext& call) const {
  const ObjectIds ids = spoken.what.is_one ? ObjectIds{spoken.what.ids.front()} : spoken.what.ids;
  const bool exact = spoken.length_m.has_value() || !spoken.size_m.empty() || spoken.factor > 0;
  std::string wrong;
  // Without a figure it may be less, down to what one notices.
  for (const double share : exact ? std::vector<double>{1} : std::vector<double>{1, 0.5, 0.25}) {
    EditList edits;
    std::string change;
    for (const std::string& id : ids) {
      const v1::Object& object = *ObjectOf(standing.shown, id);
      const v1::ResizeObject size = SizeAfter(object, spoken, share);
      if (size.has_width_m() || size.has_depth_m() || size.has_height_m()) *edits.Add()->mutable_resize_object() = size;
      if (change.empty()) change = SizeChange(object, size, spoken);
    }
    if (edits.empty()) {
      return InvalidArgument("{} {} of that size already", TheOnes(standing.shown, ids),
                             ids.size() == 1 ? "is" : "are");
    }
    ASSIGN_OR_RETURN(Acted acted, Solved(standing, edits, call));
    wrong = HasMoreFaults(acted.layout, standing.shown) ? NewFault(standing.shown, acted.layout) : "";
    if (!wrong.empty() && !exact) continue;
    acted.answer =
        fmt::format("{} {} {}.", Capital(TheOnes(acted.layout, ids)), ids.size() == 1 ? "is" : "are", change);
    acted.answer += MovedToo(acted.layout, acted.moved_ids, IdSetOf(ids));
    if (!wrong.empty()) acted.answer += fmt::format(" But {}.", wrong);
    return acted;
  }
  return InvalidArgument("there is no room for it: {}", wrong);
}

absl::StatusOr<Acted> LayoutActs::ReplaceSpoken(const Standing& standing, const Spoken& spoken,
                                                CallContext& call) const {
  const ObjectIds ids = spoken.what.is_one ? ObjectIds{spoken.what.ids.front()} : spoken.what.ids;
  v1::Object by = spoken.by->object;
  const std::string were = TheOnes(standing.shown, ids), name = by.name();
  Chain chain(standing);
  ObjectIds added;
  for (size_t i = 0; i < ids.size(); ++i) {
    const v1::Object was = *ObjectOf(chain.shown(), ids[i]);
    absl::StatusOr<Acted> one;
    if (was.kind() == by.kind() && was.walk_over() == by.walk_over()) {
      v1::ReplaceObject replace;
      replace.set_object_id(ids[i]);
      *replace.mutable_by() = by;
      one = Replace(chain.standing(), replace, call);
      added.push_back(ids[i]);
    } else {
      v1::EditLayout edit;
      edit.add_edits()->set_remove_object_id(ids[i]);
      v1::Object& object = *edit.add_edits()->mutable_add_object()->mutable_object();
      object = by;
      object.clear_id();
      object.clear_host_id();
      object.set_zone_id(was.zone_id());
      one = Edit(chain.standing(), edit, call);
    }
    RETURN_IF_ERROR(one.status());
    chain.Add(*std::move(one));
  }
  Acted acted = chain.Take();
  for (const std::string& id : added) LookLike(spoken.by->like_id, id, *acted.layout.mutable_graph());
  acted.answer = fmt::format("Replaced {} by {}.", were,
                             ids.size() == 1 ? WithArticle(name) : fmt::format("{} {}s", ids.size(), name));
  if (ids.size() == 1) acted.answer += StandsElsewhere(standing.shown, acted.layout, ids.front());
  acted.answer += MovedToo(acted.layout, acted.moved_ids, IdSetOf(ids));
  const std::string wrong = HasMoreFaults(acted.layout, standing.shown) ? NewFault(standing.shown, acted.layout) : "";
  if (!wrong.empty()) acted.answer += fmt::format(" But {}.", wrong);
  return acted;
}

absl::StatusOr<Acted> LayoutActs::LockSpoken(const Standing& standing, const Spoken& spoken, CallContext& call) const {
  v1::EditLayout edit;
  edit.set_without_solving(true);
  const bool locks = spoken.act == "lock";
  for (const std::string& id : spoken.what.ids) {
    if (locks) {
      edit.add_edits()->set_pin_object_id(id);
    } else {
      edit.add_edits()->set_unpin_object_id(id);
    }
  }
  ASSIGN_OR_RETURN(Acted acted, Edit(standing, edit, call));
  acted.answer = fmt::format("{} {}.", locks ? "Locked" : "Unlocked",
                             spoken.what.is_all ? "everything" : TheOnes(standing.shown, spoken.what.ids));
  return acted;
}

absl::StatusOr<Acted> LayoutActs::DoSpoken(const Standing& standing, Spoken spoken, CallContext& call) const {
  if (!spoken.absent.empty()) return InvalidArgument("the room has no {}", spoken.absent);
  const bool for_all = spoken.act == "remove" || spoken.act == "lock" || spoken.act == "unlock";
  if (spoken.what.is_all && !for_all) return InvalidArgument("say of which piece");
  ObjectIds& ids = spoken.what.ids;
  std::vector<std::string> kinds = KindsOf(standing.shown, ids);
  if (spoken.what.is_one && kinds.size() > 1) {
    if (spoken.act == "remove" || spoken.act == "replace") {
      return InvalidArgument("which {}: {}?", spoken.what.name, Listed(kinds, "or"));
    }
    // The largest is what people mean by "the table".
    const auto largest = std::ranges::max_element(ids, {}, [&](const std::string& id) {
      const v1::Object& object = *ObjectOf(standing.shown, id);
      return object.width_m() * object.depth_m();
    });
    ids = {*largest};
    spoken.what.is_one = false;
  }
  if (spoken.act == "remove") return RemoveSpoken(standing, spoken, call);
  if (spoken.act.starts_with("resize")) return ResizeSpoken(standing, spoken, call);
  if (spoken.act == "replace") return ReplaceSpoken(standing, spoken, call);
  if (spoken.act == "lock" || spoken.act == "unlock") return LockSpoken(standing, spoken, call);
  if (spoken.act == "settle") {
    ASSIGN_OR_RETURN(Acted acted, Settle(standing, call));
    return acted;
  }
  if (spoken.what.is_one) ids.resize(1);
  const IdSet locked = IdsOf(standing.shown.graph().pinned_placements());
  for (const Meant* const meant : {&spoken.what, &spoken.other}) {
    for (const std::string& id : meant->ids) {
      if (!locked.contains(id)) continue;
      return InvalidArgument("{} is locked; say \"unlock {}\" first", TheOnes(standing.shown, {id}),
                             TheOnes(standing.shown, {id}));
    }
  }
  if (spoken.act == "swap") return SwapSpoken(standing, spoken, call);
  if (spoken.act == "set off") return SetOffSpoken(standing, spoken, call);
  if (spoken.act == "move by") return MoveSpoken(standing, spoken, call);
  if (spoken.act.starts_with("turn")) return TurnSpoken(standing, spoken, call);
  return InvalidArgument("say that by itself, not with other wishes");
}

}  // namespace flair::session
