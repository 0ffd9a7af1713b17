// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/meanings.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "absl/strings/numbers.h"
#include "translator_worker/grammar/rules/shared.h"

namespace flair::translator {
namespace {

bool Has(const Words& words, std::string_view word) {
  return std::ranges::any_of(words, [&](const std::string& one) {
    return one == word || (one.front() == '*' && word.ends_with(std::string_view(one).substr(1)));
  });
}

// What the cases of a meaning are looked up for: a mover, a target, an object of it, each null where there is none.
struct Pair {
  const Placed* mover = nullptr;
  const Target* target = nullptr;
  const Placed* object = nullptr;
};

// One fact while its calls are made by one table. Borrows everything.
class Fact {
 public:
  Fact(const Match& match, std::string_view detail, Composer& composer)
      : match_(match), detail_(detail), composer_(composer) {}

  void Read(const Table& table) {
    table_ = &table;
    for (const Case& one : table.first) {
      if (!Holds(one, {})) continue;
      if (!one.data->refuse().empty()) Refuse(one);
      if (!one.data->as().empty()) MakeCalls(one.data->as(), match_, detail_, composer_);
      return;
    }
    ReadPairs(table);
  }

  void ReadPairs(const Table& table, const std::vector<Placed>& movers, const Target& target) {
    movers_ = movers;
    targets_ = {target};
    Each(table, *targets_);
  }

 private:
  void ReadPairs(const Table& table) {
    if (table.cases.empty()) return;
    const std::vector<Placed>& movers = Movers();
    const std::vector<Target>& targets = Targets();
    if (table.targets.empty() && targets.empty()) {
      for (const Placed& mover : movers) Make(table, {&mover, nullptr, nullptr});
    } else {
      Each(table, targets);
    }
  }

  void Each(const Table& table, const std::vector<Target>& targets) {
    const std::vector<Placed> movers = Movers();
    for (const Target& target : targets) {
      const std::vector<Placed>& objects = target.objects;
      const size_t used = Has(table.targets, "first") ? std::min<size_t>(objects.size(), 1) : objects.size();
      const bool shares = Has(table.targets, "shared") || (Has(table.targets, "each") && ShareOut(used));
      for (size_t i = 0; i < std::max<size_t>(movers.size(), 1); ++i) {
        const Placed* const mover = i < movers.size() ? &movers[i] : nullptr;
        if (objects.empty()) Make(table, {mover, &target, nullptr});
        for (size_t k = 0; k < used; ++k) {
          if (!shares || k == PartnerOf(i, used)) Make(table, {mover, &target, &objects[k]});
        }
      }
      if (!objects.empty() && !Has(table.targets, "alone")) composer_.SetPair(movers, objects);
    }
  }

  // "Two chairs at each table": the first two at the first.
  size_t PartnerOf(size_t mover, size_t targets) const {
    return ShareOut(targets) ? mover / (movers_->size() / targets) : movers_->size() > 1 ? mover % targets : 0;
  }
  bool ShareOut(size_t targets) const {
    return movers_->size() > targets && targets > 1 && movers_->size() % targets == 0 &&
           match_.b->references.front().each;
  }

  void Make(const Table& table, const Pair& pair) {
    for (const Case& one : table.cases) {
      if (!Holds(one, pair)) continue;
      if (!one.data->refuse().empty()) Refuse(one);
      for (const std::vector<Template>& alternatives : one.calls) Emit(alternatives, pair);
      const auto other = Tables().find(one.data->as());
      if (other != Tables().end()) Make(other->second, pair);
      return;
    }
  }

  void Refuse(const Case& one) {
    composer_.Refuse(one.data->code().empty() ? "unknown_sentence" : one.data->code(), one.data->refuse());
  }

  void Emit(const std::vector<Template>& alternatives, const Pair& pair) {
    std::vector<Call> calls;
    bool needs_object = false;
    for (const Template& one : alternatives) {
      Call call(one.type == "detail" ? std::string(detail_) : one.type);
      bool complete = true;
      for (const Template::Argument& argument : one.arguments) {
        const bool of_target = argument.values.front() == "B" && !IsNamed(argument) && pair.object == nullptr;
        needs_object = needs_object || of_target;
        complete = complete && !of_target && (argument.values.front() != "A" || pair.mover != nullptr) &&
                   (AddTo(call, argument, pair) || !argument.required);
      }
      if (complete) calls.push_back(std::move(call));
    }
    if (calls.empty() && needs_object)
      composer_.Refuse("unknown_sentence", "this relation needs an object, not a part of the room");
    if (!calls.empty()) composer_.EmitFirst(std::move(calls));
  }

  // Whether the argument takes what a part of the room is called.
  static bool IsNamed(const Template::Argument& argument) {
    return argument.name == "feature" || argument.name == "wall" || argument.name == "zone";
  }

  bool AddTo(Call& call, const Template::Argument& argument, const Pair& pair) {
    for (const std::string& value : argument.values) {
      if (argument.name == "sides") {
        const std::vector<std::string> sides = SidesFor(value, pair);
        if (sides.empty()) continue;
        call.Texts(argument.name, sides);
      } else if (argument.name.ends_with("_m")) {
        const std::optional<double> figure = FigureFor(value);
        if (!figure) continue;
        call.Number(argument.name, *figure);
      } else if (value == "true") {
        call.Flag(argument.name, true);
      } else {
        const std::string text = IsNamed(argument) && value == "B" ? NameFor(pair) : TextFor(value, pair);
        if (text.empty()) continue;
        call.Text(argument.name, text);
      }
      return true;
    }
    return false;
  }

  std::optional<double> FigureFor(std::string_view value) const {
    if (double written = 0; absl::SimpleAtod(std::string(value), &written)) return written;
    if (match_.distance == nullptr) return std::nullopt;
    if (value == "least") return match_.distance->min_m;
    if (value == "most") return match_.distance->max_m;
    if (value == "limit") return match_.distance->exact ? std::nullopt : match_.distance->max_m;
    return match_.distance->Nominal();
  }

  std::string NameFor(const Pair& pair) const {
    if (pair.target != nullptr) return pair.target->opening.empty() ? pair.target->name : pair.target->opening;
    return match_.b != nullptr ? match_.b->references.front().name : "";
  }

  // The wall that a mention names, empty for any.
  std::string WallOf(const Mention* mention) {
    if (mention == nullptr) return "";
    const Reference& reference = mention->references.front();
    if (reference.missing) composer_.RefuseMissing(reference);
    return reference.kind == RefKind::kWall || reference.kind == RefKind::kCorner ? reference.name : "";
  }

  const Placed* PlacedOf(const std::string& value, const Pair& pair) const {
    return value.front() == 'A' ? pair.mover : pair.object;
  }

  std::string TextFor(const std::string& value, const Pair& pair) {
    if (value == "detail") return std::string(detail_);
    if (value == "last") return composer_.last_feature;
    if (value == "subject") return composer_.subjects().empty() ? "" : composer_.id(composer_.subjects().front());
    if (value == "B.name") return NameFor(pair);
    if (value == "B.wall") return WallOf(match_.b);
    if (value == "C.wall") return WallOf(match_.c);
    if (value == "B.opening") return pair.target != nullptr ? pair.target->opening : "";
    const bool of_pair = value == "A" || value == "B" || value.starts_with("A.") || value.starts_with("B.");
    if (!of_pair) return value;
    const Placed* const placed = PlacedOf(value, pair);
    if (placed == nullptr) return "";
    if (value.size() == 1) return composer_.id(*placed);
    if (value.ends_with(".side")) return OneSide(composer_, *placed);
    if (value.ends_with(".zone")) return composer_.object(placed->object).zone_id();
    const std::vector<std::string> sides = SidesOf(composer_, *placed);
    if (sides.empty()) return "";
    return value.ends_with(".opposite") ? OppositeSide(sides.front()) : sides.front();
  }

  std::vector<std::string> SidesFor(const std::string& value, const Pair& pair) {
    if (value == "detail") return {std::string(detail_)};
    if (value == "C.sides") {
      std::vector<std::string> all;
      if (match_.c == nullptr || pair.mover == nullptr) return all;
      for (const Reference& reference : match_.c->references) {
        for (const std::string& side : SidesOf(composer_, {pair.mover->object, reference.side})) all.push_back(side);
      }
      return all;
    }
    if (!value.starts_with("A.") && !value.starts_with("B.")) return Split(value, ',');
    const Placed* const placed = PlacedOf(value, pair);
    if (placed == nullptr) return {};
    if (!value.ends_with(".open")) return SidesOf(composer_, *placed);
    return OpenSidesOf(composer_, *placed, pair.object == placed ? pair.target->objects : *movers_);
  }

  bool Holds(const Case& one, const Pair& pair) {
    return std::ranges::all_of(one.tests, [&](const Condition& test) { return Holds(test, pair) != test.denied; });
  }

  bool Holds(const Condition& test, const Pair& pair) {
    const std::string& subject = test.subject;
    if (subject == "A") return OfMention(test, match_.a);
    if (subject == "B") return OfMention(test, match_.b);
    if (subject == "C") return OfMention(test, match_.c);
    if (subject == "D") return match_.distance != nullptr && (test.about == 0 || DistanceIs(test.values.front()));
    if (subject == "mover")
      return OfPlaced(test, pair.target == nullptr && pair.mover == nullptr ? First(Movers()) : pair.mover);
    if (subject == "target") return OfTarget(test, pair);
    if (subject == "topic") return OfAny(test, composer_.topic());
    if (subject == "subject") return OfPlaced(test, First(composer_.subjects()));
    if (subject == "pair") return !composer_.pair_targets().empty();
    if (subject == "detail") return test.about == 0 ? !detail_.empty() : Has(test.values, detail_);
    if (subject == "said") return composer_.IsSaid();
    if (subject == "scope") return Has(test.values, ScopeName());
    if (subject == "calls") return composer_.calls_before() > 0;
    if (subject == "feature") return !composer_.last_feature.empty();
    if (subject == "laid") return composer_.rug_placed;
    if (subject == "several") return Movers().size() > 1;
    if (subject == "same") return pair.mover && pair.object && pair.mover->object == pair.object->object;
    if (subject == "own") return Moves(pair.object);
    return subject == "opposed" && pair.mover && pair.object && !pair.mover->side.empty() &&
           pair.mover->side == OppositeSide(pair.object->side);
  }

  bool OfAny(const Condition& test, const std::vector<Placed>& list) const {
    return std::ranges::any_of(list, [&](const Placed& one) { return OfPlaced(test, &one); });
  }

  static const Placed* First(const std::vector<Placed>& list) { return list.empty() ? nullptr : &list.front(); }

  bool Moves(const Placed* object) {
    const std::vector<Placed>& movers = Movers();
    return object != nullptr && (movers.empty() || std::ranges::any_of(movers, [&](const Placed& mover) {
                                   return mover.object == object->object;
                                 }));
  }

  std::string_view ScopeName() const {
    if (composer_.scope() == v1::SENTENCE_SCOPE_INTRA) return "intra";
    return composer_.scope() == v1::SENTENCE_SCOPE_TERTIARY ? "tertiary" : "inter";
  }

  bool DistanceIs(std::string_view kind) const {
    if (kind == "least") return match_.distance->min_m.has_value();
    if (kind == "most") return match_.distance->max_m.has_value();
    return kind == "exact" ? match_.distance->exact : match_.distance->Nominal() == 0;
  }

  bool OfMention(const Condition& test, const Mention* mention) const {
    if (mention == nullptr || test.about == 0) return mention != nullptr;
    const Reference& first = mention->references.front();
    if (test.about == '=') return Has(test.values, first.name);
    if (test.about == '.') return test.values.empty() ? !first.side.empty() : Has(test.values, first.side);
    return std::ranges::any_of(test.values,
                               [&](const std::string& kind) { return MentionIs(kind, *mention, composer_); });
  }

  // Parts of the room, where "wall" of an object is what carries it.
  static bool IsPart(std::string_view kind) {
    return kind == "wall" || kind == "feature" || kind == "room" || kind == "zone" || kind == "object";
  }

  bool OfTarget(const Condition& test, const Pair& pair) {
    if (pair.target == nullptr) {  // of a fact as a whole
      for (const Target& target : Targets()) {
        if (!target.objects.empty()) return OfPlaced(test, &target.objects.front());
      }
      return false;
    }
    if (test.about == '=')
      return test.values.empty() ? !pair.target->name.empty() : Has(test.values, pair.target->name);
    if (test.about == ':') {
      for (const std::string& kind : test.values) {
        if (kind == "object" ? pair.object != nullptr : IsPart(kind) && IsOfKind(pair.target->kind, kind)) return true;
      }
      if (IsPart(test.values.front())) return false;
    }
    return OfPlaced(test, pair.object);
  }

  bool OfPlaced(const Condition& test, const Placed* placed) const {
    if (placed == nullptr || test.about == 0) return placed != nullptr;
    if (test.about == '.') return test.values.empty() ? !placed->side.empty() : Has(test.values, placed->side);
    return std::ranges::any_of(test.values, [&](const std::string& kind) { return composer_.PlacedIs(kind, *placed); });
  }

  const std::vector<Placed>& Movers() {
    if (!movers_) movers_ = FindMovers();
    return *movers_;
  }

  std::vector<Placed> FindMovers() {
    if (table_ == nullptr || table_->movers.empty()) return {};
    const std::string& what = table_->movers.front();
    if (what == "subjects") return composer_.subjects();
    if (what == "topic") return AtSides(composer_.topic(), table_->movers);
    if (what == "pair") {
      targets_ = {{RefKind::kObjects, composer_.pair_targets(), ""}};
      return composer_.pair_movers();
    }
    if (what == "two" || what == "all") {
      auto [movers, others] = what == "two" ? TwoGroups(match_.a, composer_) : AllAndFirst(match_.a, composer_);
      targets_ = {{RefKind::kObjects, std::move(others), ""}};
      return movers;
    }
    const Mention* const mention = what == "B" ? match_.b : match_.a;
    return Has(table_->movers, "each") ? OneAtEach(mention, match_.b, composer_)
                                       : AtSides(composer_.Movers(mention), table_->movers);
  }

  const std::vector<Target>& Targets() {
    if (targets_) return *targets_;
    const std::vector<Placed> movers = Movers();
    if (!targets_) targets_ = FindTargets(movers);
    return *targets_;
  }

  std::vector<Target> FindTargets(const std::vector<Placed>& movers) {
    if (table_ == nullptr || table_->targets.empty()) return {};
    const Words& how = table_->targets;
    const Mention* const mention = how.front() == "C" ? match_.c : match_.b;
    if (mention == nullptr) return {};
    const bool alone = Has(how, "alone") || (Has(how, "own") && MayBeOwnSpace(match_, composer_));
    std::vector<Target> targets = composer_.Targets(*mention, alone ? std::vector<Placed>{} : movers, !Has(how, "any"));
    for (Target& target : targets) target.objects = AtSides(target.objects, how);
    for (size_t i = 1; Has(how, "shared") && i < targets.size(); ++i) {
      std::vector<Placed>& all = targets.front().objects;
      all.insert(all.end(), targets[i].objects.begin(), targets[i].objects.end());
    }
    if (Has(how, "shared") && targets.size() > 1) targets.resize(1);
    return targets;
  }

  // "At C": at the sides that C names, of an "or" list the first.
  std::vector<Placed> AtSides(const std::vector<Placed>& list, const Words& how) const {
    if (!Has(how, "at")) return list;
    const Mention* const sides = how[2] == "B" ? match_.b : match_.c;
    if (sides == nullptr) return list;
    std::vector<Placed> sided;
    for (const Placed& placed : list) {
      for (const Reference& reference : sides->references) {
        sided.push_back({placed.object, reference.side});
        if (sides->either) break;
      }
    }
    return sided;
  }

  const Match& match_;
  const std::string_view detail_;
  Composer& composer_;
  const Table* table_ = nullptr;
  std::optional<std::vector<Placed>> movers_;
  std::optional<std::vector<Target>> targets_;
};

}  // namespace

void MakeCalls(std::string_view meaning, const Match& match, std::string_view detail, Composer& composer) {
  if (const auto table = Tables().find(meaning); table != Tables().end()) {
    Fact(match, detail, composer).Read(table->second);
  } else if (const auto procedure = Procedures().find(meaning); procedure != Procedures().end()) {
    procedure->second(match, detail, composer);
  }
}

void MakeCallsOf(std::string_view meaning, const std::vector<Placed>& movers, const Target& target,
                 const Length* distance, Composer& composer) {
  Match match;
  match.distance = distance;
  const auto table = Tables().find(meaning);
  if (table != Tables().end()) Fact(match, "", composer).ReadPairs(table->second, movers, target);
}

}  // namespace flair::translator
