// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/bench_translate_text.h"

#include <algorithm>

#include "cli/output/text_table.h"
#include "fmt/format.h"
#include "nlohmann/json.hpp"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

using nlohmann::ordered_json;
using Tallies = std::map<std::string, TranslateTally>;

std::string ValueText(const v1::ArgumentValue& value) {
  switch (value.value_case()) {
    case v1::ArgumentValue::kText:
      return value.text();
    case v1::ArgumentValue::kNumber:
      return fmt::format("{:g}", value.number());
    case v1::ArgumentValue::kFlag:
      return value.flag() ? "true" : "false";
    default:
      return fmt::format("[{}]", fmt::join(value.texts().items(), ", "));
  }
}

std::vector<std::string> Cells(const std::string& name, const TranslateTally& tally) {
  std::vector<std::string> cells = {name, fmt::format("{}", tally.Total())};
  for (const int count : tally.counts) cells.push_back(fmt::format("{}", count));
  cells.push_back(fmt::format("{:.1f}", 100 * tally.CorrectShare()));
  return cells;
}

TextTable Table(const std::string& title, const Tallies& tallies) {
  size_t width = 12;
  for (const auto& [name, tally] : tallies) width = std::max(width, name.size());
  std::vector<std::string> titles = {title, "labels"};
  titles.insert(titles.end(), kTranslateOutcomes.begin(), kTranslateOutcomes.end());
  titles.emplace_back("correct %");
  return TextTable(titles, width);
}

std::string TableText(const std::string& title, const Tallies& tallies) {
  const TextTable table = Table(title, tallies);
  std::string text = table.Header();
  for (const auto& [name, tally] : tallies) text += table.Row(Cells(name, tally));
  return text + "\n";
}

ordered_json ToJson(const TranslateTally& tally) {
  ordered_json json{{"labels", tally.Total()}};
  for (size_t i = 0; i < tally.counts.size(); ++i) json[kTranslateOutcomes[i]] = tally.counts[i];
  json["correct_share"] = tally.CorrectShare();
  return json;
}

ordered_json ToJson(const Tallies& tallies) {
  ordered_json json = ordered_json::object();
  for (const auto& [name, tally] : tallies) json[name] = ToJson(tally);
  return json;
}

ordered_json ToJson(const TranslateMiss& miss) {
  return {{"room", miss.room},     {"list", miss.list}, {"sentence", miss.text},
          {"wanted", miss.wanted}, {"made", miss.made}, {"remarks", miss.remarks}};
}

}  // namespace

std::string EdgeText(const v1::ConstraintEdge& edge) {
  std::vector<std::string> arguments;
  for (const v1::Argument& argument : edge.arguments()) {
    arguments.push_back(fmt::format("{}={}", argument.name(), ValueText(argument.value())));
  }
  return fmt::format("{}({})", edge.type(), fmt::join(arguments, ", "));
}

std::string TranslateScoreText(const TranslateScore& score, double cpu_ms) {
  std::string text = TableText("function", score.by_function) + TableText("room", score.by_room);
  Tallies lists = score.by_list;
  const TextTable table = Table("list", lists);
  text += table.Header();
  for (const auto& [name, tally] : lists) text += table.Row(Cells(name, tally));
  text += table.Row(Cells("all", score.all));
  if (score.silent > 0) text += Counted(score.silent, "sentence") + " gave neither a call nor a remark\n";
  return text + fmt::format("{:.1f} % of {} labels correct, {:.3f} ms of CPU a label\n", 100 * score.all.CorrectShare(),
                            score.all.Total(), cpu_ms / std::max(1, score.all.Total()));
}

std::string TranslateMissesText(const TranslateScore& score) {
  std::string text;
  for (const TranslateMiss& miss : score.misses) {
    text += fmt::format("{} {}: {}\n", miss.room, miss.list, miss.text);
    for (const std::string& wanted : miss.wanted) text += fmt::format("  wanted   {}\n", wanted);
    for (const std::string& made : miss.made) text += fmt::format("  made     {}\n", made);
    for (const std::string& remark : miss.remarks) text += fmt::format("  remarked {}\n", remark);
  }
  return text;
}

std::string TranslateScoreToJson(const TranslateScore& score, const std::vector<std::string>& failures, double cpu_ms) {
  ordered_json json{{"all", ToJson(score.all)},
                    {"by_list", ToJson(score.by_list)},
                    {"by_function", ToJson(score.by_function)},
                    {"by_room", ToJson(score.by_room)},
                    {"silent", score.silent},
                    {"cpu_ms", cpu_ms},
                    {"failures", failures},
                    {"misses", ordered_json::array()}};
  for (const TranslateMiss& miss : score.misses) json["misses"].push_back(ToJson(miss));
  return json.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace flair::cli
