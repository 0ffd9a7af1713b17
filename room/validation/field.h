// SPDX-License-Identifier: GPL-3.0-or-later
// A field under validation: knows its path and where bad values are reported, so that a check is one line.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "absl/container/flat_hash_set.h"
#include "absl/status/status.h"
#include "flair/v1/artifact.pb.h"
#include "flair/v1/job.pb.h"
#include "flair/v1/language_service.pb.h"
#include "flair/v1/optimizer_service.pb.h"
#include "flair/v1/orchestrator_service.pb.h"
#include "flair/v1/renderer_service.pb.h"
#include "flair/v1/translator_service.pb.h"
#include "fmt/format.h"
#include "room/validation/validate.h"

namespace flair::validation {

// Ids and names that references may point to; what they are part of, or literals, must outlive the set.
using NameSet = absl::flat_hash_set<std::string_view>;

// What is wrong with a message, in the order found.
class Problems {
 public:
  void Add(Problem problem) { problems_.push_back(std::move(problem)); }
  bool empty() const { return problems_.empty(); }
  const std::vector<Problem>& list() const { return problems_; }
  // OK, or INVALID_ARGUMENT with the first five problems and the number of further ones.
  absl::Status ToStatus() const;

 private:
  std::vector<Problem> problems_;
};

// A range of numbers; its ends belong to it unless said to be open.
struct Range {
  double least;
  double most;
  bool open_least = false;
  bool open_most = false;

  bool Holds(double value) const;
  std::string Text() const;  // "(0, 20]"
};

// One field. Checks report to `problems` and return whether the value is good. The problems and the names, which are
// literals, must outlive the field. Its path is written down only when there is something to report.
class Field {
 public:
  Field(Problems& problems, std::string path) : problems_(&problems), root_(std::move(path)) {}

  Field operator[](int index) const { return Inner({.name = nullptr, .name_size = 0, .index = index}); }
  Field operator[](std::string_view name) const {
    return Inner({.name = name.data(), .name_size = name.size(), .index = -1});
  }
  std::string path() const;

  // Reports "path: text" and returns false.
  template <typename... Args>
  bool Reject(fmt::format_string<Args...> format, Args&&... args) const {
    problems_->Add({path(), fmt::format(format, std::forward<Args>(args)...)});
    return false;
  }

  // A finite number in the range.
  bool InRange(double value, const Range& range) const;
  // Length in characters (UTF-8 code points).
  bool Text(std::string_view value, int least, int most) const;
  // How many items or characters something has.
  bool Count(int count, int least, int most, std::string_view what) const;
  // 1 to 64 of a-z, 0-9 and "_"; so it can be a file name, a column and a word of a call.
  bool Id(std::string_view value) const;
  // A good Id that `seen` does not hold yet; it is put there.
  bool NewId(std::string_view value, NameSet& seen) const;
  // One of `known`; `what` is such as "an object".
  bool Refers(std::string_view value, const NameSet& known, std::string_view what) const;
  // A 64-character lower-case hex digest.
  bool Digest(std::string_view value) const;
  // A value that the enum has, other than 0.
  bool Enum(int value, bool is_valid) const;

 private:
  // A name, or an item's index. Takes no work to make: most fields are good and their steps never looked at.
  struct Step {
    const char* name;
    size_t name_size;
    int index;
  };
  Field Inner(Step step) const;

  Problems* problems_;
  std::string root_;
  std::array<Step, 16> steps_;
  size_t depth_ = 0;
};

// Code points of valid UTF-8; -1 when it is not valid.
int CharacterCount(std::string_view text);

// How a message is checked: every field by its rule (rules.textproto), messages inside it likewise, then what several
// fields say together by the Check of its type. Callers outside this folder use validate.h.

// Of points in a room or beside it, metres.
inline constexpr Range kCoordinate{.least = -1000, .most = 1000};

// What the parts of one problem may refer to. Sets that are null are not known, and references to them not followed.
struct Known {
  const NameSet* zones = nullptr;
  const NameSet* objects = nullptr;
  const NameSet* openings = nullptr;
  const NameSet* sentences = nullptr;
  const NameSet* edges = nullptr;
};

// Reports all that is wrong with a message of package flair.v1. Its parts may refer to each other and to `known`.
void CheckMessage(const google::protobuf::Message& message, const Known& known, const Field& at);

// What several fields of one message say together, or one alone that no rule can say. Fields that break a rule have
// been reported already.
void Check(const v1::Brief& brief, const Known& known, const Field& at);
void Check(const v1::Room& room, const Known& known, const Field& at);
void Check(const v1::Object& object, const Known& known, const Field& at);
void Check(const v1::ObjectList& list, const Known& known, const Field& at);
void Check(const v1::StyleSheet& sheet, const Known& known, const Field& at);
void Check(const v1::ParameterSpec& parameter, const Known& known, const Field& at);
void Check(const v1::ConstraintType& type, const Known& known, const Field& at);
void Check(const v1::ConstraintCatalog& catalog, const Known& known, const Field& at);
void Check(const v1::Participant& participant, const Known& known, const Field& at);
void Check(const v1::Measure& measure, const Known& known, const Field& at);
void Check(const v1::ConstraintEdge& edge, const Known& known, const Field& at);
void Check(const v1::LayoutGraph& graph, const Known& known, const Field& at);
void Check(const v1::ZoneRegion& region, const Known& known, const Field& at);
void Check(const v1::SolvedLayout& layout, const Known& known, const Field& at);
void Check(const v1::Preview& preview, const Known& known, const Field& at);
void Check(const v1::Report& report, const Known& known, const Field& at);
void Check(const v1::Artifact& artifact, const Known& known, const Field& at);
void Check(const v1::SolveOptions& options, const Known& known, const Field& at);
void Check(const v1::RenderOptions& options, const Known& known, const Field& at);
void Check(const v1::ViewCamera& camera, const Known& known, const Field& at);
void Check(const v1::ContactSheetOptions& options, const Known& known, const Field& at);
void Check(const v1::ContactSheetTile& tile, const Known& known, const Field& at);
void Check(const v1::SolveRestartsRequest& request, const Known& known, const Field& at);
void Check(const v1::RenderRequest& request, const Known& known, const Field& at);
void Check(const v1::PlanParts& parts, const Known& known, const Field& at);
void Check(const v1::CreateBatchRequest& request, const Known& known, const Field& at);

// The ids of a list's elements, for looking up references.
template <typename List>
NameSet IdsOf(const List& list) {
  NameSet ids;
  for (const auto& element : list) ids.insert(element.id());
  return ids;
}

}  // namespace flair::validation
