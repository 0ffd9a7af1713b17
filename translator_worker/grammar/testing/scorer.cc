// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/testing/scorer.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace flair::translator {
namespace {

using nlohmann::json;

json ToJson(const v1::ArgumentValue& value) {
  switch (value.value_case()) {
    case v1::ArgumentValue::kText:
      return value.text();
    case v1::ArgumentValue::kNumber:
      return value.number();
    case v1::ArgumentValue::kFlag:
      return value.flag();
    default:
      break;
  }
  json list = json::array();
  for (const std::string& item : value.texts().items()) list.push_back(item);
  return list;
}

json Arguments(const v1::ConstraintEdge& edge) {
  json result = json::object();
  for (const v1::Argument& argument : edge.arguments()) result[argument.name()] = ToJson(argument.value());
  return result;
}

bool SameValue(const json& made, const json& wanted) {
  if (wanted.is_number()) return made.is_number() && std::abs(made.get<double>() - wanted.get<double>()) < 1e-6;
  if (wanted.is_array()) {
    return made.is_array() &&
           std::set<std::string>(made.begin(), made.end()) == std::set<std::string>(wanted.begin(), wanted.end());
  }
  return made == wanted;
}

bool SameArguments(const json& made, const json& wanted) {
  return std::all_of(wanted.items().begin(), wanted.items().end(), [&](const auto& item) {
    const json value = made.contains(item.key()) ? made[item.key()] : json(nullptr);
    // An unnamed side of accessible is the front, an unnamed "both" is false.
    if (value.is_null() && item.key() == "sides") return item.value() == json::array({"front"});
    return SameValue(value, item.value());
  });
}

void SwapKeys(json& object, const char* a, const char* b) {
  json first = object.contains(a) ? object[a] : json(nullptr);
  json second = object.contains(b) ? object[b] : json(nullptr);
  object.erase(a);
  object.erase(b);
  if (!second.is_null()) object[a] = second;
  if (!first.is_null()) object[b] = first;
}

}  // namespace

bool Meets(const v1::ConstraintEdge& edge, const json& label) {
  const std::string type = label[0];
  if (edge.type() != type) return false;
  json made = Arguments(edge);
  const json& wanted = label[1];
  if ((type == "against_wall" || type == "near_wall") && !wanted.contains("side") && made.contains("side") &&
      made["side"] != "back") {
    return false;
  }
  if (SameArguments(made, wanted)) return true;
  const bool symmetric = type == "near" || type == "away_from" || type == "parallel" || type == "perpendicular" ||
                         type == "next_to" || (type == "facing" && wanted.value("both", false));
  if (symmetric) {
    SwapKeys(made, "object", "target");
    SwapKeys(made, "object_side", "target_side");
    return SameArguments(made, wanted);
  }
  if (type == "between") {
    SwapKeys(made, "first", "second");
    return SameArguments(made, wanted);
  }
  return false;
}

bool AddToScore(const LabelledSentence& labelled, const std::vector<v1::ConstraintEdge>& edges, bool has_diagnostic,
                Score& score) {
  const auto met = [&](const json& call) {
    return std::any_of(edges.begin(), edges.end(), [&](const v1::ConstraintEdge& edge) { return Meets(edge, call); });
  };
  bool right = true;
  bool refuse = true;
  for (const json& alternatives : labelled.parts) {
    if (alternatives.empty()) continue;
    refuse = false;
    int best_met = -1;
    int best_size = 1;
    bool may_refuse = false;
    for (const json& alternative : alternatives) {
      if (alternative.empty()) {
        may_refuse = true;  // a careful reader may refuse as well
        continue;
      }
      const int count = static_cast<int>(std::count_if(alternative.begin(), alternative.end(), met));
      const int size = static_cast<int>(alternative.size());
      if (count * best_size > best_met * size) {
        best_met = count;
        best_size = size;
      }
    }
    if (may_refuse && best_met < best_size) continue;
    score.labelled_calls += best_size;
    score.met_calls += best_met;
    right = right && best_met == best_size;
  }
  for (const v1::ConstraintEdge& edge : edges) {
    bool named = false;
    for (const json& alternatives : labelled.parts) {
      for (const json& alternative : alternatives) {
        for (const json& call : alternative) named = named || Meets(edge, call);
      }
    }
    ++score.made_calls;
    score.right_calls += named;
    right = right && named;
  }
  if (refuse) {
    ++score.refusals;
    score.right_refusals += edges.empty();
  }
  if (edges.empty() && !has_diagnostic) ++score.silent;
  return right;
}

std::string ToText(const v1::ConstraintEdge& edge) {
  std::string text = edge.type() + "(";
  for (const v1::Argument& argument : edge.arguments()) {
    if (text.back() != '(') text += ", ";
    const json value = ToJson(argument.value());
    text += argument.name() + "=" + (value.is_string() ? value.get<std::string>() : value.dump());
  }
  return text + ")";
}

}  // namespace flair::translator
