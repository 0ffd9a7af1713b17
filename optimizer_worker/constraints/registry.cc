// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/registry.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "optimizer_worker/constraints/arguments.h"
#include "optimizer_worker/constraints/call_text.h"
#include "optimizer_worker/constraints/facts.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::optimizer {

namespace {

ConstraintLibrary SortedLibrary() {
  ConstraintLibrary library = LibraryOfProgram();
  std::sort(library.types.begin(), library.types.end(),
            [](const ConstraintFacts& a, const ConstraintFacts& b) { return a.name < b.name; });
  return library;
}

v1::ConstraintType ToProto(const ConstraintFacts& facts) {
  v1::ConstraintType type;
  type.set_name(facts.name);
  for (const std::string& alias : facts.aliases) type.add_aliases(alias);
  type.set_family(facts.family);
  type.set_summary(facts.summary);
  type.set_doc(facts.doc);
  for (const v1::ParameterSpec& spec : facts.parameters) *type.add_parameters() = spec;
  for (const SentenceExample& sentence : facts.sentences) {
    v1::CallExample& example = *type.add_examples();
    example.set_sentence(sentence.sentence);
    for (const v1::Argument& argument : ArgumentsFromText(facts, sentence.call)) *example.add_arguments() = argument;
  }
  type.set_built_in(facts.built_in);
  return type;
}

}  // namespace

const ConstraintLibrary& Library() {
  static const ConstraintLibrary library = SortedLibrary();
  return library;
}

std::span<const ConstraintFacts> AllConstraints() { return Library().types; }

const ConstraintFacts* FindConstraint(std::string_view name) {
  for (const ConstraintFacts& facts : AllConstraints()) {
    if (facts.name == name) return &facts;
    for (const std::string& alias : facts.aliases) {
      if (alias == name) return &facts;
    }
  }
  return nullptr;
}

absl::StatusOr<std::unique_ptr<Cost>> Bind(const v1::ConstraintEdge& edge, const BindContext& context) {
  const ConstraintFacts* facts = FindConstraint(edge.type());
  if (facts == nullptr) {
    return absl::InvalidArgumentError(fmt::format("there is no constraint type \"{}\" in the catalogue", edge.type()));
  }
  ASSIGN_OR_RETURN(Arguments arguments, Arguments::Resolve(*facts, edge, context.scene));
  return facts->bind(arguments, context);
}

std::vector<int> NamedObjects(const v1::ConstraintEdge& edge, const Scene& scene) {
  const ConstraintFacts* facts = FindConstraint(edge.type());
  if (facts == nullptr) return {};
  const absl::StatusOr<Arguments> arguments = Arguments::Resolve(*facts, edge, scene);
  if (!arguments.ok()) return {};
  std::vector<int> objects = arguments->AllObjects();
  std::sort(objects.begin(), objects.end());
  return objects;
}

const v1::ConstraintCatalog& MakeCatalog() {
  static const v1::ConstraintCatalog catalog = [] {
    v1::ConstraintCatalog built;
    built.set_library(Library().program + " " + Library().version);
    for (const ConstraintFacts& facts : AllConstraints()) *built.add_types() = ToProto(facts);
    return built;
  }();
  return catalog;
}

}  // namespace flair::optimizer
