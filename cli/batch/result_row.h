// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "flair/v1/job.pb.h"
#include "flair/v1/report.pb.h"

namespace flair::cli {

// One value of a row: nothing, a whole number, a number or text.
using ResultValue = std::variant<std::monostate, int64_t, double, std::string>;

// A column of results.db and of the CSV file.
struct ResultColumn {
  std::string name;
  // As SQLite says it: INTEGER, REAL or TEXT.
  std::string type;
  // What it holds, for people: in the file's table `columns` and in docs/batches.md.
  std::string meaning;
};

// All columns in order. The first one is batch_index, which no two rows share.
std::span<const ResultColumn> ResultColumns();
// Place of the column in ResultColumns(), which must have it.
size_t ColumnPlace(std::string_view name);

// What is known of one job of a batch.
class ResultRow {
 public:
  ResultRow() : values_(ResultColumns().size()) {}
  void Set(std::string_view column, ResultValue value) { values_[ColumnPlace(column)] = std::move(value); }
  const ResultValue& Get(std::string_view column) const { return values_[ColumnPlace(column)]; }
  // The value, or what stands for one that is not there.
  std::string Text(std::string_view column) const;
  int64_t Int(std::string_view column) const;
  const std::vector<ResultValue>& values() const { return values_; }
  std::vector<ResultValue>& values() { return values_; }

 private:
  std::vector<ResultValue> values_;
};

// "worker", "infeasible", ...; empty for a job that has not failed.
std::string FailureKindWord(v1::FailureKind kind);

// Everything that a job says of itself: not what only the submission (line, key) or the collection (path) knows.
ResultRow RowOf(const v1::Job& job);
// Adds what the job's report says.
void AddReport(const v1::Report& report, ResultRow& row);

}  // namespace flair::cli
