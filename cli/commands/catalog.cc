// SPDX-License-Identifier: GPL-3.0-or-later
// flair catalog: the constraints that the optimizer understands.
#include <cstdio>

#include "cli/commands/commands.h"
#include "cli/input/message_text.h"
#include "cli/output/artifact_text.h"
#include "cli/output/catalog_text.h"
#include "fmt/format.h"
#include "optimizer_worker/constraints/facts.h"

namespace flair::cli {
namespace {

struct CatalogArguments : Options {
  using Options::Options;
  std::string& type = Text("TYPE", "One of them in full, by name or alias");
  bool& json = Flag("--json", "As JSON");
  bool& markdown = Flag("--markdown", "All of them in full, as docs/constraints.md", {"--json"});
};

absl::Status Catalog(const CatalogArguments& arguments) {
  const v1::ConstraintCatalog& catalog = optimizer::MakeCatalog();
  if (!arguments.type.empty()) {
    const optimizer::ConstraintFacts* const facts = optimizer::FindConstraint(arguments.type);
    if (facts == nullptr) {
      std::vector<std::string> names;
      for (const v1::ConstraintType& type : catalog.types()) names.push_back(type.name());
      return absl::NotFoundError(fmt::format("\"{}\" is not a constraint{}; flair catalog lists them", arguments.type,
                                             DidYouMean(arguments.type, names)));
    }
    for (const v1::ConstraintType& type : catalog.types()) {
      if (type.name() == facts->name()) fmt::print("{}", arguments.json ? ToJson(type) : TypeText(type));
    }
    return absl::OkStatus();
  }
  fmt::print("{}", arguments.json       ? ToJson(catalog)
                   : arguments.markdown ? CatalogMarkdown(catalog)
                                        : CatalogOverview(catalog));
  return absl::OkStatus();
}

}  // namespace

void AddCatalog(const Commands& program) {
  program.Add("catalog", "List the constraints that the optimizer understands.", Catalog);
}

}  // namespace flair::cli
