// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>

#include "cli/inspect/columns.h"
#include "cli/inspect/provenance.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "nlohmann/json.hpp"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

constexpr size_t kShortDigits = 12;

std::string Short(const std::string& digest) { return digest.substr(0, kShortDigits); }

// "graph", with digits of its id when several have the name; digits alone for what was not found.
std::map<std::string, std::string> NamesOf(const std::vector<ProvenanceStep>& steps) {
  std::map<std::string, int> count;
  for (const ProvenanceStep& step : steps) ++count[step.name];
  std::map<std::string, std::string> names;
  for (const ProvenanceStep& step : steps) {
    names[step.id] = step.name.empty()      ? Short(step.id) + " (missing)"
                     : count[step.name] > 1 ? step.name + " " + Short(step.id)
                                            : step.name;
  }
  return names;
}

std::string MakerText(const ProvenanceStep& step) {
  const v1::Producer& producer = step.producer;
  std::string text = step.edited ? "edited by hand" : fmt::format("{}, {}", producer.program(), producer.method());
  if (producer.program().empty()) text = "nobody says who made it";
  if (!producer.version().empty()) text += fmt::format(", {}{}", step.edited ? "" : "version ", producer.version());
  if (!producer.build().empty()) text += ", build " + producer.build();
  if (!producer.configuration_digest().empty()) text += ", configuration " + Short(producer.configuration_digest());
  return text;
}

// What decided it beside its inputs; empty when nothing did.
std::string ChoicesText(const ProvenanceStep& step) {
  std::vector<std::string> parts;
  if (!step.options_digest.empty()) parts.push_back("options " + Short(step.options_digest));
  if (!step.seeds.empty()) {
    parts.push_back(fmt::format("{} {}", step.seeds.size() == 1 ? "seed" : "seeds", fmt::join(step.seeds, ", ")));
  }
  if (step.model_call_count > 0) {
    parts.push_back(fmt::format("{} of {}, prompts {}", Counted(step.model_call_count, "call"),
                                fmt::join(step.models, ", "), fmt::join(step.prompt_versions, ", ")));
  }
  return fmt::format("{}", fmt::join(parts, "; "));
}

}  // namespace

std::string ProvenanceText(const std::vector<ProvenanceStep>& steps, const std::string& places) {
  const std::map<std::string, std::string> names = NamesOf(steps);
  std::string text;
  for (const ProvenanceStep& step : steps) {
    if (step.name.empty()) {
      text += fmt::format("{:<15} {}  MISSING: {}\n", "?", Short(step.id), places);
      continue;
    }
    text += fmt::format("{:<15} {}  stage {}, {}\n", step.name, Short(step.id), step.stage, step.place);
    if (!step.text.empty()) text += fmt::format("{:<15} \"{}\"\n", "", Shortened(step.text, 90));
    text += fmt::format("{:<15} {}\n", "", MakerText(step));
    if (const std::string choices = ChoicesText(step); !choices.empty())
      text += fmt::format("{:<15} {}\n", "", choices);
    if (step.made_from_ids.empty()) continue;
    std::vector<std::string> parents;
    for (const std::string& id : step.made_from_ids) {
      const auto found = names.find(id);
      parents.push_back(found == names.end() ? Short(id) : found->second);
    }
    text += fmt::format("{:<15} from {}\n", "", fmt::join(parents, ", "));
  }
  return text;
}

std::string ProvenanceJson(const std::vector<ProvenanceStep>& steps) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const ProvenanceStep& step : steps) {
    nlohmann::ordered_json entry = {{"id", step.id}, {"found", !step.name.empty()}};
    if (!step.name.empty()) {
      entry["kind"] = step.name;
      entry["place"] = step.place;
      entry["stage"] = step.stage;
      entry["program"] = step.producer.program();
      entry["method"] = step.producer.method();
      entry["version"] = step.producer.version();
      entry["build"] = step.producer.build();
      entry["configuration_digest"] = step.producer.configuration_digest();
      entry["options_digest"] = step.options_digest;
      entry["edited"] = step.edited;
      entry["made_from_ids"] = step.made_from_ids;
      entry["seeds"] = step.seeds;
      entry["models"] = step.models;
      entry["prompt_versions"] = step.prompt_versions;
      if (!step.text.empty()) entry["text"] = step.text;
    }
    json.push_back(std::move(entry));
  }
  return json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string ProvenanceLine(const std::vector<ProvenanceStep>& steps) {
  std::vector<std::string> names;
  size_t missing = 0;
  for (const ProvenanceStep& step : steps) {
    missing += step.name.empty() ? 1 : 0;
    if (!step.name.empty()) names.push_back(step.edited ? step.name + " (edited)" : step.name);
  }
  std::string text = fmt::format("{}", fmt::join(names, " > "));
  if (missing > 0) text += fmt::format("; {} missing", missing);
  return text;
}

}  // namespace flair::cli
