// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/model/bind_call.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "fmt/format.h"
#include "llm/answers/choices.h"
#include "llm/answers/fault.h"
#include "translator_worker/catalog/catalog_index.h"

namespace flair::translator {
namespace {

using Values = std::vector<std::string>;

bool TakesList(const v1::ParameterSpec& parameter) {
  return parameter.kind() == v1::PARAMETER_KIND_OBJECTS || parameter.kind() == v1::PARAMETER_KIND_SIDES;
}

// "None", "null": as if it were not there.
bool IsAbsent(const WrittenArgument& argument) {
  static constexpr std::array<std::string_view, 5> kAbsent = {"", "none", "null", "default", "unspecified"};
  return argument.values.empty() ||
         (argument.values.size() == 1 &&
          std::find(kAbsent.begin(), kAbsent.end(), llm::Bare(argument.values.front())) != kAbsent.end());
}

// Gives the written arguments to the parameters of a type.
class Binder {
 public:
  Binder(const v1::ConstraintType& type, const ArgumentReader& reader) : type_(type), reader_(reader) {}

  absl::Status Add(const WrittenArgument& argument) {
    if (IsAbsent(argument)) {
      if (argument.name.empty()) ++next_;
      return absl::OkStatus();
    }
    if (argument.name.empty()) return AddByPlace(argument);
    const int parameter = Find(argument.name);
    if (parameter < 0) {
      return absl::InvalidArgumentError(
          fmt::format("{} has no parameter {}; it has {}", type_.name(), llm::Quoted(argument.name), Names()));
    }
    return Give(parameter, argument);
  }

  absl::StatusOr<std::vector<v1::Argument>> Read() const {
    std::vector<v1::Argument> arguments;
    for (int i = 0; i < type_.parameters_size(); ++i) {
      const auto given = given_.find(i);
      if (given == given_.end()) continue;
      const v1::ParameterSpec& parameter = type_.parameters(i);
      absl::StatusOr<v1::ArgumentValue> value = reader_.Read(parameter, given->second);
      if (!value.ok()) {
        return absl::InvalidArgumentError(
            fmt::format("{}.{}: {}", type_.name(), parameter.name(), std::string(value.status().message())));
      }
      v1::Argument& argument = arguments.emplace_back();
      argument.set_name(parameter.name());
      *argument.mutable_value() = *std::move(value);
    }
    return arguments;
  }

 private:
  int Find(const std::string& name) const {
    const std::string bare = llm::Bare(name);
    for (int i = 0; i < type_.parameters_size(); ++i) {
      const v1::ParameterSpec& parameter = type_.parameters(i);
      const std::string own = llm::Bare(parameter.name());
      // "max_distance" for max_distance_m
      if (own == bare || (!parameter.unit().empty() && own == bare + llm::Bare(parameter.unit()))) return i;
    }
    return -1;
  }

  std::string Names() const {
    Values names;
    for (const v1::ParameterSpec& parameter : type_.parameters()) names.push_back(parameter.name());
    return fmt::format("{}", fmt::join(names, ", "));
  }

  bool CanTake(int parameter, const Values& values) const {
    return reader_.Read(type_.parameters(parameter), values).ok();
  }

  absl::Status AddByPlace(const WrittenArgument& argument) {
    // "surround(table, chair_1, chair_2)": one list.
    const bool list = last_ >= 0 && TakesList(type_.parameters(last_)) && !argument.in_brackets;
    if (list && CanTake(last_, argument.values)) return Give(last_, argument);
    int first = -1;
    for (int i = next_; i < type_.parameters_size(); ++i) {
      if (given_.contains(i)) continue;
      if (first < 0) first = i;
      if (CanTake(i, argument.values)) return Give(i, argument);
      if (type_.parameters(i).required()) break;
    }
    if (first >= 0) return Give(first, argument);
    return absl::InvalidArgumentError(fmt::format("{} takes no further argument {}; it has {}", type_.name(),
                                                  llm::Quoted(argument.values.front()), Names()));
  }

  absl::Status Give(int parameter, const WrittenArgument& argument) {
    Values& values = given_[parameter];
    if (!values.empty() && !TakesList(type_.parameters(parameter)) && values != argument.values) {
      return absl::InvalidArgumentError(fmt::format("{} is given {} twice; a call for each would be right",
                                                    type_.name(), type_.parameters(parameter).name()));
    }
    if (values != argument.values) values.insert(values.end(), argument.values.begin(), argument.values.end());
    last_ = parameter;
    if (argument.name.empty()) next_ = std::max(next_, parameter + 1);
    return absl::OkStatus();
  }

  const v1::ConstraintType& type_;
  const ArgumentReader& reader_;
  std::map<int, Values> given_;
  int next_ = 0;
  int last_ = -1;
};

// The objects that a call is about, in any of its arguments.
Values ObjectsOf(const v1::ConstraintType& type, const Call& call) {
  Values ids;
  for (const v1::Argument& argument : call.arguments) {
    for (const v1::ParameterSpec& parameter : type.parameters()) {
      if (parameter.name() != argument.name()) continue;
      if (parameter.kind() == v1::PARAMETER_KIND_OBJECT) ids.push_back(argument.value().text());
      if (parameter.kind() != v1::PARAMETER_KIND_OBJECTS) continue;
      ids.insert(ids.end(), argument.value().texts().items().begin(), argument.value().texts().items().end());
    }
  }
  return ids;
}

}  // namespace

absl::StatusOr<Call> BindCall(const WrittenCall& written, const v1::ConstraintType& type, const ArgumentReader& reader,
                              std::vector<std::string>& remarks) {
  Binder binder(type, reader);
  for (const WrittenArgument& argument : written.arguments) {
    if (absl::Status status = binder.Add(argument); !status.ok()) return status;
  }
  absl::StatusOr<std::vector<v1::Argument>> arguments = binder.Read();
  if (!arguments.ok()) return arguments.status();
  Call call(type.name());
  call.arguments = *std::move(arguments);
  if (absl::Status status = CatalogIndex::Fit(type, call.arguments, remarks); !status.ok()) return status;
  Values objects = ObjectsOf(type, call);
  std::sort(objects.begin(), objects.end());
  const auto twice = std::adjacent_find(objects.begin(), objects.end());
  if (twice != objects.end()) {
    return absl::InvalidArgumentError(fmt::format("{} relates \"{}\" to itself", type.name(), *twice));
  }
  return call;
}

}  // namespace flair::translator
