// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/constraint_catalog.pb.h"
#include "flair/v1/translator_service.pb.h"
#include "llm/answers/choices.h"

namespace flair::translator {

// Reads the texts of a model's arguments as values that a parameter takes: ids and names of what the room has, sides,
// numbers with units. Borrows the request. Immutable, thread-safe.
class ArgumentReader {
 public:
  explicit ArgumentReader(const v1::TranslateRequest& request);

  // INVALID_ARGUMENT with the text and what would be right, when a value means nothing certain: "\"sofa 2\" is no
  // object; one of ...". A name that several equal objects share stands for all of them where a list is wanted.
  absl::StatusOr<v1::ArgumentValue> Read(const v1::ParameterSpec& parameter, std::span<const std::string> values) const;

 private:
  absl::StatusOr<std::string> One(const llm::Choices& choices, const char* what, const std::string& value) const;
  // The ids that a text means.
  absl::StatusOr<std::vector<std::string>> ObjectIds(const std::string& value) const;
  absl::StatusOr<v1::ArgumentValue> Single(const v1::ParameterSpec& parameter, const std::string& value) const;

  llm::Choices objects_;
  // Ids by bare name, for names that objects share.
  std::map<std::string, std::vector<std::string>> groups_;
  llm::Choices zones_;
  llm::Choices walls_;
};

}  // namespace flair::translator
