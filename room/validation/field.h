// SPDX-License-Identifier: GPL-3.0-or-later
// A field under validation: knows its path and where bad values are reported, so that a check is one line.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "absl/container/flat_hash_set.h"
#include "absl/status/status.h"
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

}  // namespace flair::validation
