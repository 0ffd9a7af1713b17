// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/constraint_catalog.pb.h"
#include "flair/v1/translator_service.pb.h"
#include "llm/answers/field_facts.h"
#include "translator_worker/grammar/call.h"
#include "translator_worker/model/call_text.h"

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

// A written call as one of the type: arguments by name or place. One without a name goes to the next parameter that can
// take it, past optional ones that cannot ("against_wall(bed, north)"), or to the list before it. Numbers are clamped
// to their range and the type's needs checked; `remarks` gets what was changed. INVALID_ARGUMENT says what does not fit
// and what would.
absl::StatusOr<Call> BindCall(const WrittenCall& written, const v1::ConstraintType& type, const ArgumentReader& reader,
                              std::vector<std::string>& remarks);

}  // namespace flair::translator
