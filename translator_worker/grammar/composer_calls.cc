// SPDX-License-Identifier: GPL-3.0-or-later
// The part of Composer that keeps the calls of a sentence: which are let in, and which replace others.
#include <algorithm>
#include <string_view>
#include <utility>

#include "absl/strings/str_join.h"
#include "english/language.h"
#include "fmt/format.h"
#include "google/protobuf/util/message_differencer.h"
#include "translator_worker/grammar/composer.h"

namespace flair::translator {
namespace {

// Whether `call` says all that `part` says.
bool Includes(const Call& call, const Call& part) {
  return call.type == part.type && std::ranges::all_of(part.arguments, [&](const v1::Argument& wanted) {
           return std::ranges::any_of(call.arguments, [&](const v1::Argument& given) {
             return google::protobuf::util::MessageDifferencer::Equals(given, wanted);
           });
         });
}

// Whether both are of that type and about one object, and one target if they have any.
bool BothAre(std::string_view type, const Call& a, const Call& b) {
  return a.type == type && b.type == type && a.TextOf("object") == b.TextOf("object") &&
         a.TextOf("target") == b.TextOf("target");
}

// Adds the sides that a call about free space does not have; false when it had them all.
template <typename Sides>
bool AddSidesTo(Call& space, const Sides& more) {
  auto& sides = *space.arguments[1].mutable_value()->mutable_texts()->mutable_items();
  const int before = sides.size();
  for (const std::string& side : more) {
    if (std::ranges::find(sides, side) == sides.end()) *sides.Add() = side;
  }
  return sides.size() > before;
}

// Whether both keep space at one object, `vague` without a figure or with a lesser one ("drawers extend 0.5 m, so keep
// 0.9 m"), at some of the sides of `precise`.
bool IsSameSpace(const Call& vague, const Call& precise) {
  const v1::ArgumentValue* const little = vague.Find("min_clearance_m");
  const v1::ArgumentValue* const much = precise.Find("min_clearance_m");
  if (!BothAre("accessible", vague, precise) || much == nullptr || vague.Find("sides") == nullptr) return false;
  Call all = precise;
  return (little == nullptr || little->number() < much->number()) &&
         !AddSidesTo(all, vague.Find("sides")->texts().items());
}

// "In front of it and at its sides": one space, when neither has a figure or one fact says both. Adds the sides of
// `more` to `call`.
bool JoinSides(Call& call, const Call& more, bool one_fact) {
  if (!BothAre("accessible", call, more) || call.arguments.size() != more.arguments.size() ||
      (call.arguments.size() > 2 && !one_fact))
    return false;
  AddSidesTo(call, more.arguments[1].value().texts().items());
  return true;
}

// "On the right of the stand, so that its left side touches it": one contact. Adds the side of `more` to `call`.
bool JoinContacts(Call& call, const Call& more) {
  if (!BothAre("next_to", call, more) || call.arguments.size() != 3 || more.arguments.size() != 3 ||
      call.arguments[2].name() == more.arguments[2].name())
    return false;
  call.arguments.push_back(more.arguments[2]);
  return true;
}

// Whether both put a piece beside the same other, at sides of it that differ.
bool TouchOtherSides(const Call& a, const Call& b) {
  const std::string& side = a.TextOf("target_side");
  const std::string& other = b.TextOf("target_side");
  return BothAre("next_to", a, b) && !side.empty() && !other.empty() && side != other;
}

}  // namespace

bool Composer::IsBesideTheRug(const std::string& type) const {
  return scope() == v1::SENTENCE_SCOPE_TERTIARY && english::Language::Get().IsIn("calls beside rugs", type) &&
         std::ranges::any_of(topic_, [&](const Placed& placed) { return IsRug(placed); });
}

void Composer::CompleteSide(const std::string& side) {
  if (side != "front" && side != "back" && side != "left" && side != "right") return;
  // "Adjacent to the sofa (left side)": of the sofa.
  if (!calls_.empty() && calls_.back().type == "next_to" && calls_.back().arguments.size() == 2) {
    calls_.back().Text("target_side", side);
    return;
  }
  if (calls_.empty() || (calls_.back().type != "against_wall" && calls_.back().type != "near_wall")) return;
  calls_.back().Text("side", side);
}

bool Composer::CompleteClearance(double least_m) {
  // "The chairs need space behind them (0.6 m)": of each of them.
  size_t first = calls_.size();
  while (first > 0 && calls_[first - 1].type == "accessible" && calls_[first - 1].Find("min_clearance_m") == nullptr) {
    --first;
  }
  for (size_t i = first; i < calls_.size(); ++i) calls_[i].Number("min_clearance_m", least_m);
  return first < calls_.size();
}

bool Composer::AddSides(const std::vector<std::string>& sides) {
  if (calls_.empty() || calls_.back().type != "accessible" || calls_.back().arguments.size() < 2) return false;
  AddSidesTo(calls_.back(), sides);
  return true;
}

bool Composer::TellsLittle(const Call& call) const {
  if (call.type == "on_wall_in_zone" || call.type == "ceiling_center" || call.type == "in_zone") return true;
  // "On the runner, on the table": the table is what stands there.
  const std::string& host = call.TextOf("host");
  return !host.empty() && std::ranges::any_of(request_.object_list().objects(), [&](const v1::Object& other) {
    return other.id() == host && other.kind() != v1::OBJECT_KIND_FLOOR;
  });
}

bool Composer::IsOfAnother(const std::string& mover, const std::string& target) const {
  const auto partner = partners_.find(mover);
  return partner != partners_.end() && partner->second != target;
}

bool Composer::Emit(Call call) {
  const v1::ConstraintType* type = catalog_.Find(call.type);
  if (type == nullptr) return false;
  const bool relates = call.arguments.size() > 1 && call.arguments[1].value().has_text() &&
                       (call.arguments[1].name() == "target" || call.arguments[1].name() == "host");
  if (relates && IsOfAnother(call.arguments[0].value().text(), call.arguments[1].value().text())) return true;
  if (relates && call.arguments[0].value().text() == call.arguments[1].value().text()) {
    Refuse("unknown_sentence", "nothing can be related to itself; name two objects");
    return true;
  }
  if (english::Language::Get().IsIn("calls of the floor", type->name()) && !call.arguments.empty()) {
    const std::string& mover = call.arguments.front().value().text();
    // On which wall and by which opening something hangs can be asked for.
    const bool names_part = call.Find("wall") != nullptr || call.Find("feature") != nullptr;
    for (const v1::Object& candidate : request_.object_list().objects()) {
      if (candidate.id() != mover || candidate.kind() == v1::OBJECT_KIND_FLOOR) continue;
      if (names_part && candidate.kind() == v1::OBJECT_KIND_WALL) break;
      Refuse("not_expressible",
             fmt::format("{} is for what stands on the floor, which {} does not", type->name(), mover));
      return true;
    }
  }
  if (!call.arguments.empty() && call.arguments.front().name() == "rug") {
    if (std::exchange(rug_placed, true)) return true;
  }
  std::vector<std::string> remarks;
  if (!CatalogIndex::Fit(*type, call.arguments, remarks).ok()) return false;
  for (const std::string& remark : remarks) Note("out_of_range", remark);
  call.type = type->name();
  // "not next to the bed, at least 0.5 m from it": the fuller of two like calls stays.
  if (IsBesideTheRug(type->name())) {
    Refuse("not_expressible",
           fmt::format("a rug lies under things or in the middle; {} says nothing of it", type->name()));
    return true;
  }
  // "Space around it (at least 0.3 m on all sides)": the one with the figure stays.
  std::erase_if(calls_, [&](const Call& other) { return IsSameSpace(other, call); });
  // "In the living area, under the sofa": the sofa says where the rug lies.
  if (call.type == "rug_under_center" || call.type == "rug_under_forward") {
    std::erase_if(calls_, [](const Call& other) { return other.type == "in_zone"; });
  }
  // "On the wall in the study area, above the desk": the desk says it all.
  if (scope() == v1::SENTENCE_SCOPE_TERTIARY && !TellsLittle(call)) {
    std::erase_if(calls_, [&](const Call& other) {
      return TellsLittle(other) && other.TextOf("object") == call.TextOf("object");
    });
  }
  if (!calls_.empty() && (JoinSides(calls_.back(), call, false) || JoinContacts(calls_.back(), call))) return true;
  const size_t of_fact = calls_.size() - std::min(calls_.size(), calls_before_);
  if (std::any_of(calls_.end() - static_cast<long>(of_fact), calls_.end(),
                  [&](Call& other) { return JoinSides(other, call, true); }))
    return true;
  // "On the left of the bed, flush with its headboard": one piece touches one side.
  if (std::ranges::any_of(calls_, [&](const Call& other) { return TouchOtherSides(other, call); })) return true;
  for (Call& other : calls_) {
    if (Includes(other, call)) return true;
    if (Includes(call, other)) {
      other = std::move(call);
      return true;
    }
  }
  calls_.push_back(std::move(call));
  return true;
}

void Composer::EmitFirst(std::vector<Call> calls) {
  std::vector<std::string> types;
  for (Call& call : calls) {
    types.push_back(call.type);
    if (Emit(std::move(call))) return;
  }
  Refuse("not_in_catalog", fmt::format("the optimizer's catalogue has no {}", absl::StrJoin(types, " or ")));
}

}  // namespace flair::translator
