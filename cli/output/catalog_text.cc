// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/catalog_text.h"

#include <array>
#include <utility>

#include "absl/strings/str_join.h"
#include "cli/output/artifact_text.h"
#include "cli/output/message_view.h"
#include "cli/output/text.h"
#include "fmt/format.h"

namespace flair::cli {
namespace {

constexpr std::array<std::pair<const char*, const char*>, 10> kFamilies = {{
    {"wall", "Objects at walls"},
    {"feature", "Objects and doors, windows, sockets"},
    {"space", "Objects in the room"},
    {"pair", "Two objects"},
    {"group", "Several objects"},
    {"rug", "Rugs"},
    {"surface", "Things on top of others"},
    {"on_wall", "Things that hang on walls"},
    {"ceiling", "Things that hang from the ceiling"},
    {"room", "Whole-room terms, which the optimizer adds itself"},
}};

std::string RangeText(const v1::ParameterSpec& parameter) {
  if (!parameter.has_min_number() && !parameter.has_max_number()) return "";
  return fmt::format("[{}, {}]{}", parameter.has_min_number() ? fmt::format("{:g}", parameter.min_number()) : "-inf",
                     parameter.has_max_number() ? fmt::format("{:g}", parameter.max_number()) : "inf",
                     parameter.unit().empty() ? "" : " " + parameter.unit());
}

std::string DefaultText(const v1::ParameterSpec& parameter) {
  if (parameter.required()) return "required";
  return parameter.has_default_value() ? ValueText(parameter.default_value()) : "-";
}

std::string TypeMarkdown(const v1::ConstraintType& type) {
  std::string text = fmt::format("### {}\n\n{}\n\n{}\n", type.name(), type.summary(), type.doc());
  if (type.aliases_size() > 0) {
    text += fmt::format("\nAlso read as: `{}`.\n", absl::StrJoin(type.aliases(), "`, `"));
  }
  std::vector<std::vector<std::string>> rows;
  for (const v1::ParameterSpec& parameter : type.parameters()) {
    rows.push_back({"`" + parameter.name() + "`", EnumInWords(parameter.kind()), DefaultText(parameter),
                    RangeText(parameter), parameter.doc()});
  }
  text += "\n" + MarkdownTable({"parameter", "kind", "default", "range", "meaning"}, rows);
  if (!type.phrase().empty()) text += fmt::format("\nTold as \"{}\".\n", type.phrase());
  if (!type.shortfall().empty()) text += fmt::format("Missed: \"{}\".\n", type.shortfall());
  for (const v1::CallExample& example : type.examples()) {
    text += fmt::format("\n> {}  \n> `{}`\n", example.sentence(), CallText(type.name(), example.arguments()));
  }
  return text + "\n";
}

}  // namespace

std::string CatalogMarkdown(const v1::ConstraintCatalog& catalog) {
  std::string text = fmt::format(
      "# Constraints\n\nWhat `{}` understands. Written by `flair catalog --markdown`; a test fails when it is stale.\n"
      "Costs are zero exactly where the sentence is true. Lengths are metres, angles radians unless said "
      "otherwise.\n\n",
      catalog.library());
  for (const auto& [family, title] : kFamilies) {
    text += fmt::format("## {}\n\n", title);
    for (const v1::ConstraintType& type : catalog.types()) {
      if (type.family() == family) text += TypeMarkdown(type);
    }
  }
  return text;
}

std::string TypeText(const v1::ConstraintType& type) {
  std::string text = fmt::format("{}: {}\n\n{}\n\n", type.name(), type.summary(), type.doc());
  if (type.aliases_size() > 0) text += fmt::format("also read as {}\n\n", absl::StrJoin(type.aliases(), ", "));
  for (const v1::ParameterSpec& parameter : type.parameters()) {
    text += fmt::format("  {:<18} {:<8} {:<10} {:<12} {}\n", parameter.name(), EnumInWords(parameter.kind()),
                        DefaultText(parameter), RangeText(parameter), parameter.doc());
  }
  for (const v1::CallExample& example : type.examples()) {
    text += fmt::format("\n  \"{}\"\n  {}\n", example.sentence(), CallText(type.name(), example.arguments()));
  }
  return text;
}

std::string CatalogOverview(const v1::ConstraintCatalog& catalog) {
  std::string text;
  for (const v1::ConstraintType& type : catalog.types()) {
    if (!type.built_in()) text += fmt::format("{:<18} {}\n", type.name(), type.summary());
  }
  return text;
}

}  // namespace flair::cli
