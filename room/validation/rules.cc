// SPDX-License-Identifier: GPL-3.0-or-later
#include <google/protobuf/text_format.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "flair/rules/v1/rules.pb.h"
#include "room/validation/field.h"

namespace flair {
// The text of rules.textproto, see CMakeLists.txt.
std::string_view ValidationRules();
}  // namespace flair

namespace flair::validation {
namespace {

namespace pb = google::protobuf;

using TypeCheck = void (*)(const pb::Message& message, const Known& known, const Field& at);

template <typename Type>
std::pair<const pb::Descriptor*, TypeCheck> CheckOf() {
  return {Type::descriptor(), [](const pb::Message& message, const Known& known, const Field& at) {
            Check(static_cast<const Type&>(message), known, at);
          }};
}

// How the messages of a type are checked.
struct Plan {
  struct Step {
    const pb::FieldDescriptor* field = nullptr;
    // Null when any value is good.
    const rules::v1::Rule* rule = nullptr;
    // Of a message's fields; null when they are not checked.
    const Plan* inner = nullptr;
  };
  std::vector<Step> steps;
  // Some of its parts may be referred to.
  bool has_parts = false;
  TypeCheck check = nullptr;
};

// The plans of all types, made when they are first asked for.
class Plans {
 public:
  Plans() {
    const bool good = pb::TextFormat::ParseFromString(std::string(ValidationRules()), &rules_);
    if (!good) Die("not readable");
    for (const rules::v1::Rule& rule : rules_.rules()) {
      for (const std::string& field : rule.fields()) {
        if (!rule_of_.emplace("flair.v1." + field, &rule).second) Die("two rules for " + field);
      }
    }
  }

  const Plan& Of(const pb::Descriptor* type) {
    const std::lock_guard lock(mutex_);
    return Make(type);
  }

 private:
  [[noreturn]] static void Die(const std::string& fault) {
    fmt::print(stderr, "rules.textproto: {}\n", fault);
    std::abort();  // a test reads them
  }

  const Plan& Make(const pb::Descriptor* type) {
    const auto [place, is_new] = plans_.try_emplace(type);
    Plan& plan = place->second;
    if (!is_new) return plan;
    for (int i = 0; i < type->field_count(); ++i) {
      Plan::Step step{type->field(i)};
      const auto rule = rule_of_.find(step.field->full_name());
      if (rule != rule_of_.end()) step.rule = rule->second;
      const pb::Descriptor* inner = step.field->message_type();
      const bool ours = inner != nullptr && inner->file()->package() == "flair.v1" && !step.field->is_map();
      const bool unchecked = step.rule != nullptr && step.rule->unchecked();
      if (ours && !unchecked) step.inner = &Make(inner);
      plan.has_parts = plan.has_parts || inner == v1::ZonePlan::descriptor() || inner == v1::ObjectList::descriptor() ||
                       inner == v1::Room::descriptor() || inner == v1::ConstraintList::descriptor() ||
                       inner == v1::LayoutGraph::descriptor();
      if (step.rule != nullptr || step.inner != nullptr) plan.steps.push_back(step);
    }
    const auto check = checks_.find(type);
    if (check != checks_.end()) plan.check = check->second;
    return plan;
  }

  rules::v1::Rules rules_;
  std::map<std::string, const rules::v1::Rule*, std::less<>> rule_of_;
  const std::map<const pb::Descriptor*, TypeCheck> checks_ = {
      CheckOf<v1::Brief>(),
      CheckOf<v1::Room>(),
      CheckOf<v1::Object>(),
      CheckOf<v1::ObjectList>(),
      CheckOf<v1::StyleSheet>(),
      CheckOf<v1::ParameterSpec>(),
      CheckOf<v1::ConstraintType>(),
      CheckOf<v1::ConstraintCatalog>(),
      CheckOf<v1::Participant>(),
      CheckOf<v1::Measure>(),
      CheckOf<v1::ConstraintEdge>(),
      CheckOf<v1::LayoutGraph>(),
      CheckOf<v1::ZoneRegion>(),
      CheckOf<v1::SolvedLayout>(),
      CheckOf<v1::Preview>(),
      CheckOf<v1::Report>(),
      CheckOf<v1::Artifact>(),
      CheckOf<v1::SolveOptions>(),
      CheckOf<v1::RenderOptions>(),
      CheckOf<v1::ViewCamera>(),
      CheckOf<v1::ContactSheetOptions>(),
      CheckOf<v1::ContactSheetTile>(),
      CheckOf<v1::SolveRestartsRequest>(),
      CheckOf<v1::RenderRequest>(),
      CheckOf<v1::PlanParts>(),
      CheckOf<v1::CreateBatchRequest>(),
  };
  std::mutex mutex_;
  std::map<const pb::Descriptor*, Plan> plans_;
};

// The first part of that type that a message has; null when there is none.
template <typename Part>
const Part* PartOf(const pb::Message& message) {
  for (int i = 0; i < message.GetDescriptor()->field_count(); ++i) {
    const pb::FieldDescriptor* const field = message.GetDescriptor()->field(i);
    if (field->message_type() != Part::descriptor() || field->is_repeated()) continue;
    if (!message.GetReflection()->HasField(message, field)) continue;
    return &static_cast<const Part&>(message.GetReflection()->GetMessage(message, field));
  }
  return nullptr;
}

// What the parts of one message may refer to in each other.
class Scope {
 public:
  Scope(const pb::Message& message, const Known& outer) : known_(outer) {
    if (const auto* plan = PartOf<v1::ZonePlan>(message)) known_.zones = &(zones_ = IdsOf(plan->zones()));
    if (const auto* list = PartOf<v1::ObjectList>(message)) known_.objects = &(objects_ = IdsOf(list->objects()));
    if (const auto* room = PartOf<v1::Room>(message)) known_.openings = &(openings_ = IdsOf(room->openings()));
    if (const auto* list = PartOf<v1::ConstraintList>(message)) {
      known_.sentences = &(sentences_ = IdsOf(list->sentences()));
    }
    if (const auto* graph = PartOf<v1::LayoutGraph>(message)) {
      known_.zones = &(zones_ = IdsOf(graph->zone_plan().zones()));
      known_.objects = &(objects_ = IdsOf(graph->object_list().objects()));
      known_.edges = &(edges_ = IdsOf(graph->edges()));
    }
  }
  const Known& known() const { return known_; }

 private:
  Known known_;
  NameSet zones_, objects_, openings_, sentences_, edges_;
};

// A value that a rule speaks of: an element of a repeated field, or with index -1 the one value of a field.
class Value {
 public:
  Value(const pb::Message& message, const pb::FieldDescriptor* field, int index)
      : message_(message), reflection_(*message.GetReflection()), field_(field), index_(index) {}

  const std::string& text(std::string& scratch) const {
    return index_ < 0 ? reflection_.GetStringReference(message_, field_, &scratch)
                      : reflection_.GetRepeatedStringReference(message_, field_, index_, &scratch);
  }
  int enum_number() const {
    return index_ < 0 ? reflection_.GetEnumValue(message_, field_)
                      : reflection_.GetRepeatedEnumValue(message_, field_, index_);
  }
  // Rules speak of single numbers only.
  double number() const {
    switch (field_->cpp_type()) {
      case pb::FieldDescriptor::CPPTYPE_INT32:
        return reflection_.GetInt32(message_, field_);
      case pb::FieldDescriptor::CPPTYPE_INT64:
        return static_cast<double>(reflection_.GetInt64(message_, field_));
      default:
        return reflection_.GetDouble(message_, field_);
    }
  }

 private:
  const pb::Message& message_;
  const pb::Reflection& reflection_;
  const pb::FieldDescriptor* field_;
  int index_;
};

Range RangeOf(const rules::v1::Interval& interval) {
  return {.least = interval.has_over() ? interval.over() : interval.least(),
          .most = interval.has_below() ? interval.below() : interval.most(),
          .open_least = interval.has_over(),
          .open_most = interval.has_below()};
}

void CheckReference(const std::string& id, rules::v1::Target target, const Known& known, const Field& at) {
  const auto refer = [&](const NameSet* names, std::string_view what) {
    if (names != nullptr) at.Refers(id, *names, what);
  };
  if (target == rules::v1::TARGET_ZONE) refer(known.zones, "a zone");
  if (target == rules::v1::TARGET_OBJECT) refer(known.objects, "an object");
  if (target == rules::v1::TARGET_SENTENCE) refer(known.sentences, "a sentence");
  if (target == rules::v1::TARGET_EDGE) refer(known.edges, "an edge");
}

// `seen` holds the new ids of the list so far.
void CheckValue(const pb::FieldDescriptor* field, const Value& value, const rules::v1::Rule& rule, const Known& known,
                NameSet& seen, const Field& at) {
  if (field->enum_type() != nullptr) {
    const int number = value.enum_number();
    if (number == 0 && rule.or_unset()) return;
    at.Enum(number, field->enum_type()->FindValueByNumber(number) != nullptr);
    return;
  }
  if (rule.has_number()) {
    at.InRange(value.number(), RangeOf(rule.number()));
    return;
  }
  std::string scratch;
  const std::string& text = value.text(scratch);
  if (text.empty() && rule.or_unset()) return;
  if (rule.has_text()) at.Text(text, rule.text().least(), rule.text().most());
  if (rule.id()) at.Id(text);
  if (rule.new_id()) at.NewId(text, seen);
  if (rule.digest()) at.Digest(text);
  CheckReference(text, rule.refers_to(), known, at);
}

// `seen` is of the list that the message is in.
void Walk(const pb::Message& message, const Plan& plan, const Known& outer, NameSet& seen, const Field& at) {
  const pb::Reflection& reflection = *message.GetReflection();
  std::optional<Scope> scope;
  if (plan.has_parts) scope.emplace(message, outer);
  const Known& known = scope.has_value() ? scope->known() : outer;
  for (const auto& [field, rule, inner] : plan.steps) {
    const Field here = at[field->name()];
    NameSet inside;
    if (!field->is_repeated()) {
      const bool is_set = !field->has_presence() || reflection.HasField(message, field);
      if (inner != nullptr) {
        const bool required = rule != nullptr && rule->required();
        if (is_set || required) Walk(reflection.GetMessage(message, field), *inner, known, inside, here);
      } else if (is_set && field->message_type() == nullptr) {
        CheckValue(field, Value(message, field, -1), *rule, known, seen, here);
      }
      continue;
    }
    const int count = reflection.FieldSize(message, field);
    if (rule != nullptr && rule->has_items() &&
        !here.Count(count, rule->items().least(), rule->items().most(), rule->items().what())) {
      continue;
    }
    for (int i = 0; i < count; ++i) {
      if (inner != nullptr) {
        Walk(reflection.GetRepeatedMessage(message, field, i), *inner, known, inside, here[i]);
      } else if (field->message_type() == nullptr) {
        CheckValue(field, Value(message, field, i), *rule, known, inside, here[i]);
      }
    }
  }
  if (plan.check != nullptr) plan.check(message, known, at);
}

}  // namespace

void CheckMessage(const pb::Message& message, const Known& known, const Field& at) {
  static Plans& plans = *new Plans;
  NameSet seen;
  Walk(message, plans.Of(message.GetDescriptor()), known, seen, at);
}

}  // namespace flair::validation
