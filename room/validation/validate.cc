// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/validation/validate.h"

#include "room/validation/checks.h"

namespace flair {
namespace {

using validation::Check;
using validation::Field;
using validation::Known;
using validation::NameSet;
using validation::Problems;

template <typename Message>
absl::Status Run(const Message& message, std::string_view path) {
  Problems problems;
  Check(message, Field(problems, std::string(path)));
  return problems.ToStatus();
}

template <typename Message>
absl::Status Run(const Message& message, const Known& known, std::string_view path) {
  Problems problems;
  Check(message, known, Field(problems, std::string(path)));
  return problems.ToStatus();
}

template <typename Message>
std::vector<validation::Problem> Find(const Message& message) {
  Problems problems;
  Check(message, Field(problems, ""));
  return problems.list();
}

}  // namespace

absl::Status Validate(const v1::Brief& brief, std::string_view path) { return Run(brief, path); }
absl::Status Validate(const v1::Room& room, std::string_view path) { return Run(room, path); }
absl::Status Validate(const v1::ZonePlan& plan, std::string_view path) { return Run(plan, path); }
absl::Status Validate(const v1::ConstraintCatalog& catalog, std::string_view path) { return Run(catalog, path); }
absl::Status Validate(const v1::LayoutGraph& graph, std::string_view path) { return Run(graph, path); }
absl::Status Validate(const v1::SolvedLayout& layout, std::string_view path) { return Run(layout, path); }
absl::Status Validate(const v1::SolveOptions& options, std::string_view path) { return Run(options, path); }
absl::Status Validate(const v1::RenderOptions& options, std::string_view path) { return Run(options, path); }
absl::Status Validate(const v1::JobSpec& spec, std::string_view path) { return Run(spec, path); }
absl::Status Validate(const v1::Preview& preview, std::string_view path) { return Run(preview, path); }
absl::Status Validate(const v1::Report& report, std::string_view path) { return Run(report, path); }
absl::Status Validate(const v1::Artifact& artifact, std::string_view path) { return Run(artifact, path); }

std::vector<validation::Problem> FindProblems(const v1::Artifact& artifact) { return Find(artifact); }
std::vector<validation::Problem> FindProblems(const v1::Brief& brief) { return Find(brief); }
std::vector<validation::Problem> FindProblems(const v1::Room& room) { return Find(room); }

absl::Status Validate(const v1::ObjectList& list, std::string_view path) { return Run(list, Known{}, path); }

absl::Status Validate(const v1::ObjectList& list, const v1::ZonePlan& plan, std::string_view path) {
  const NameSet zones = validation::ZoneIds(plan);
  return Run(list, Known{.zones = &zones}, path);
}

absl::Status Validate(const v1::StyleSheet& sheet, std::string_view path) { return Run(sheet, Known{}, path); }

absl::Status Validate(const v1::StyleSheet& sheet, const v1::Room& room, const v1::ObjectList& objects,
                      std::string_view path) {
  const NameSet object_ids = validation::ObjectIds(objects);
  const NameSet opening_ids = validation::OpeningIds(room);
  return Run(sheet, Known{.objects = &object_ids, .openings = &opening_ids}, path);
}

absl::Status Validate(const v1::ConstraintList& list, std::string_view path) { return Run(list, Known{}, path); }

absl::Status Validate(const v1::ConstraintList& list, const v1::ObjectList& objects, std::string_view path) {
  const NameSet object_ids = validation::ObjectIds(objects);
  return Run(list, Known{.objects = &object_ids}, path);
}

}  // namespace flair
