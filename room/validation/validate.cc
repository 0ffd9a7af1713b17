// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/validation/validate.h"

#include "absl/strings/ascii.h"
#include "room/validation/field.h"

namespace flair {
namespace {

using validation::Field;
using validation::IdsOf;
using validation::Known;
using validation::NameSet;
using validation::Problems;

Problems Find(const google::protobuf::Message& message, const Known& known, std::string_view path) {
  Problems problems;
  validation::CheckMessage(message, known, Field(problems, std::string(path)));
  return problems;
}

// "layout_graph" of a LayoutGraph, but "options", "spec" and "catalog" whatever they are of; nothing of a request.
std::string UsualName(const google::protobuf::Message& message) {
  std::string name;
  for (const char c : message.GetDescriptor()->name()) {
    if (absl::ascii_isupper(c) && !name.empty()) name += '_';
    name += absl::ascii_tolower(c);
  }
  if (name.ends_with("_request")) return "";
  for (const std::string_view word : {"options", "spec", "catalog"}) {
    if (name.ends_with(word)) return std::string(word);
  }
  return name;
}

}  // namespace

absl::Status Validate(const google::protobuf::Message& message, std::string_view path) {
  return Find(message, {}, path).ToStatus();
}

absl::Status Validate(const google::protobuf::Message& message) { return Validate(message, UsualName(message)); }

std::vector<validation::Problem> FindProblems(const google::protobuf::Message& message) {
  return Find(message, {}, "").list();
}

absl::Status Validate(const v1::ObjectList& list, const v1::ZonePlan& plan, std::string_view path) {
  const NameSet zones = IdsOf(plan.zones());
  return Find(list, Known{.zones = &zones}, path).ToStatus();
}

absl::Status Validate(const v1::StyleSheet& sheet, const v1::Room& room, const v1::ObjectList& objects,
                      std::string_view path) {
  const NameSet object_ids = IdsOf(objects.objects());
  const NameSet opening_ids = IdsOf(room.openings());
  return Find(sheet, Known{.objects = &object_ids, .openings = &opening_ids}, path).ToStatus();
}

absl::Status Validate(const v1::ConstraintList& list, const v1::ObjectList& objects, std::string_view path) {
  const NameSet object_ids = IdsOf(objects.objects());
  return Find(list, Known{.objects = &object_ids}, path).ToStatus();
}

absl::Status Validate(const v1::ComposeContactSheetRequest& request, int index) {
  Problems problems = Find(request, {}, "");
  const Field at(problems, "");
  if (index == 0 && !request.has_options()) at["options"].Reject("is not set; the first message holds it");
  if (index > 0 && !request.has_tile()) at["tile"].Reject("is not set; every message after the first holds one");
  return problems.ToStatus();
}

}  // namespace flair
