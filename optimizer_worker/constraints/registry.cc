// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/registry.h"

#include <fmt/format.h>
#include <google/protobuf/text_format.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "flair/constraints/v1/constraint_record.pb.h"
#include "optimizer_worker/constraints/arguments.h"
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/measure/walls.h"
#include "worker_runtime/status/status_macros.h"

namespace flair {
// The text of types/*.textproto, see CMakeLists.txt.
std::string_view OurRecords();
}  // namespace flair

namespace flair::optimizer {
namespace {

ConstraintLibrary SortedLibrary() {
  ConstraintLibrary library = LibraryOfProgram();
  std::ranges::sort(library.types,
                    [](const ConstraintFacts& a, const ConstraintFacts& b) { return a.name() < b.name(); });
  return library;
}

ConstraintFacts FactsOf(const constraints::v1::ConstraintRecord& record, const ConstraintCode& code) {
  ConstraintFacts facts{.type = record.type(), .tied_to_axes = record.tied_to_axes(), .code = code};
  for (const auto& sentence : record.sentences()) {
    v1::CallExample& example = *facts.type.add_examples();
    example.set_sentence(sentence.text());
    for (const v1::Argument& argument : ArgumentsFromText(facts.type, sentence.call()))
      *example.add_arguments() = argument;
  }
  for (const auto& layout : record.satisfied()) facts.layouts.push_back({true, layout.scene(), layout.call()});
  for (const auto& layout : record.violated()) facts.layouts.push_back({false, layout.scene(), layout.call()});
  return facts;
}

}  // namespace

void ConstraintLibrary::Add(std::string_view records, std::span<const ConstraintCode> code) {
  const auto demand = [](bool holds, std::string_view fault) {
    if (holds) return;
    fmt::print(stderr, "constraint records: {}\n", fault);
    std::abort();
  };
  constraints::v1::ConstraintRecords read;
  demand(google::protobuf::TextFormat::ParseFromString(std::string(records), &read), "not readable");
  demand(read.constraints_size() == static_cast<int>(code.size()), "not one for every type that has code");
  for (const constraints::v1::ConstraintRecord& record : read.constraints()) {
    const auto found =
        std::ranges::find_if(code, [&](const ConstraintCode& one) { return one.name == record.type().name(); });
    demand(found != code.end(), fmt::format("{} has no code", record.type().name()));
    types.push_back(FactsOf(record, *found));
  }
}

std::span<const ConstraintCode> DirectionsCode();
std::span<const ConstraintCode> FeatureCode();
std::span<const ConstraintCode> GroupCode();
std::span<const ConstraintCode> OnWallCode();
std::span<const ConstraintCode> PlacesCode();
std::span<const ConstraintCode> RoomCode();
std::span<const ConstraintCode> SpaceCode();
std::span<const ConstraintCode> StackedCode();
std::span<const ConstraintCode> WallCode();

ConstraintLibrary OurLibrary() {
  std::vector<ConstraintCode> code;
  for (const auto& of_file :
       {DirectionsCode, FeatureCode, GroupCode, OnWallCode, PlacesCode, RoomCode, SpaceCode, StackedCode, WallCode}) {
    const std::span<const ConstraintCode> some = of_file();
    code.insert(code.end(), some.begin(), some.end());
  }
  ConstraintLibrary library{.program = "flair-optimizer", .version = "1"};
  library.Add(OurRecords(), code);
  return library;
}

const ConstraintLibrary& Library() {
  static const ConstraintLibrary library = SortedLibrary();
  return library;
}

std::span<const ConstraintFacts> AllConstraints() { return Library().types; }

const ConstraintFacts* FindConstraint(std::string_view name) {
  for (const ConstraintFacts& facts : AllConstraints()) {
    if (facts.name() == name) return &facts;
    for (const std::string& alias : facts.type.aliases()) {
      if (alias == name) return &facts;
    }
  }
  return nullptr;
}

absl::StatusOr<std::unique_ptr<Cost>> Bind(const v1::ConstraintEdge& edge, const BindContext& context) {
  const ConstraintFacts* facts = FindConstraint(edge.type());
  if (facts == nullptr) {
    return InvalidArgument("there is no constraint type \"{}\" in the catalogue", edge.type());
  }
  ASSIGN_OR_RETURN(Arguments arguments, Arguments::Resolve(facts->type, edge, context.scene));
  return facts->code.bind(arguments, context);
}

absl::Status CheckHasPlace(const BindContext& context, int zone) {
  if (static_cast<size_t>(zone) >= context.zone_centers.size()) {
    return absl::FailedPreconditionError("the zones have no places yet");
  }
  if (HasPlace(context.zone_centers[static_cast<size_t>(zone)])) return absl::OkStatus();
  return FailedPrecondition("nothing stands in zone \"{}\", so it has no place",
                            context.scene.zones[static_cast<size_t>(zone)].name);
}

std::vector<int> NamedObjects(const v1::ConstraintEdge& edge, const Scene& scene) {
  const ConstraintFacts* facts = FindConstraint(edge.type());
  if (facts == nullptr) return {};
  const absl::StatusOr<Arguments> arguments = Arguments::Resolve(facts->type, edge, scene);
  if (!arguments.ok()) return {};
  std::vector<int> objects = arguments->AllObjects();
  std::ranges::sort(objects);
  return objects;
}

const v1::ConstraintCatalog& MakeCatalog() {
  static const v1::ConstraintCatalog catalog = [] {
    v1::ConstraintCatalog built;
    built.set_library(Library().program + " " + Library().version);
    for (const ConstraintFacts& facts : AllConstraints()) *built.add_types() = facts.type;
    return built;
  }();
  return catalog;
}

}  // namespace flair::optimizer
