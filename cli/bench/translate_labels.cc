// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include "cli/bench/translate_bench.h"
#include "cli/output/output_folder.h"
#include "cli/output/text.h"
#include "evaluation/readers/flairgpt_calls.h"
#include "fmt/format.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

using evaluation::FlairGptFunction;
using evaluation::FlairGptKind;
using evaluation::FlairGptParameter;
using nlohmann::json;

std::string Text(const json& value) { return JsonText(value); }

v1::Argument& AddArgument(const std::string& name, v1::ConstraintEdge& edge) {
  v1::Argument& argument = *edge.add_arguments();
  argument.set_name(name);
  return argument;
}

absl::Status AddObjects(const json& objects, const FlairGptFunction& function, const v1::LayoutGraph& room,
                        v1::ConstraintEdge& edge) {
  size_t next = 0;
  for (const FlairGptParameter& parameter : function.parameters) {
    const bool list = parameter.kind == FlairGptKind::kFloorObjects;
    const bool one = parameter.kind == FlairGptKind::kFloorObject || parameter.kind == FlairGptKind::kItem;
    if ((!list && !one) || (!parameter.required && next >= objects.size())) continue;
    if (next >= objects.size()) return InvalidArgument("objects: too few for {}", edge.type());
    v1::ArgumentValue& value = *AddArgument(parameter.name, edge).mutable_value();
    do {
      ASSIGN_OR_RETURN(const std::string id, ReadGoldObject(objects[next++], room));
      if (one) value.set_text(id);
      if (list) value.mutable_texts()->add_items(id);
    } while (list && next < objects.size());
  }
  if (next == objects.size()) return absl::OkStatus();
  return InvalidArgument("objects: too many for {}", edge.type());
}

absl::Status AddParameter(const std::string& name, const json& given, const FlairGptFunction& function,
                          const v1::LayoutGraph& room, v1::ConstraintEdge& edge) {
  const std::string keyword = name == "type" ? "fixed_object_type" : name == "zone" ? "region_name" : name;
  const int position = evaluation::PositionOfKeyword(keyword, function);
  if (position < 0) return InvalidArgument("params: {} has no {}", edge.type(), name);
  const std::string object = edge.arguments_size() > 0 ? edge.arguments(0).value().text() : "";
  absl::StatusOr<std::optional<v1::Argument>> argument =
      evaluation::FlairGptArguments(room).Read(function.parameters[position], given, object);
  if (!argument.ok()) return argument.status();
  if (argument->has_value()) *edge.add_arguments() = **std::move(argument);
  return absl::OkStatus();
}

namespace fs = std::filesystem;

constexpr const char* kLists[] = {"primary_intra", "primary_inter", "secondary_intra", "secondary_inter", "tertiary"};

absl::StatusOr<std::vector<fs::path>> LabelFiles(const fs::path& path) {
  std::error_code error;
  if (fs::is_regular_file(path, error)) return std::vector<fs::path>{path};
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(path, error)) {
    if (entry.path().extension() == ".jsonl") files.push_back(entry.path());
  }
  if (error) return NotFound("{}: {}", path.string(), error.message());
  if (files.empty()) return NotFound("{}: no .jsonl files in it", path.string());
  std::ranges::sort(files);
  return files;
}

v1::SentenceScope ScopeOf(const std::string& list) {
  if (list == "tertiary") return v1::SENTENCE_SCOPE_TERTIARY;
  return list.ends_with("intra") ? v1::SENTENCE_SCOPE_INTRA : v1::SENTENCE_SCOPE_INTER;
}

// What one line says, in the words of its room.
struct Line {
  std::string bullet;
  std::string list;
  std::vector<std::string> subject_ids;
  TranslateLabel label;
};

absl::StatusOr<Line> ReadLine(const json& record, const v1::LayoutGraph& room) {
  for (const char* key : {"list", "sentence"}) {
    if (!record.contains(key) || !record[key].is_string()) return InvalidArgument("{}: missing; expected a text", key);
  }
  Line line{record.value("bullet", record["sentence"].get<std::string>()), record["list"], {}, {}};
  if (std::find(std::begin(kLists), std::end(kLists), line.list) == std::end(kLists)) {
    return InvalidArgument("list: unknown list {}; known are {}", line.list, fmt::join(kLists, ", "));
  }
  for (const json& index : record.value("subject_index", json::array())) {
    ASSIGN_OR_RETURN(std::string id, ReadGoldObject(index, room));
    line.subject_ids.push_back(std::move(id));
  }
  line.label.text = record["sentence"];
  line.label.function = "refuse";
  if (!record.contains("gold") || !record["gold"].is_array()) {
    return absl::InvalidArgumentError("gold: missing; expected a list of alternatives, empty to refuse");
  }
  for (const json& alternative : record["gold"]) {
    std::vector<v1::ConstraintEdge>& calls = line.label.alternatives.emplace_back();
    if (!alternative.is_array() || alternative.empty())
      return absl::InvalidArgumentError("gold: an alternative without calls");
    for (const json& call : alternative) {
      ASSIGN_OR_RETURN(v1::ConstraintEdge edge, ReadGoldCall(call, room));
      calls.push_back(std::move(edge));
    }
    if (line.label.alternatives.size() == 1) line.label.function = alternative[0]["function"];
  }
  return line;
}

class Reader {
 public:
  Reader(const fs::path& path, const fs::path& rooms) {
    const fs::path folder = fs::is_directory(path) ? path : path.parent_path();
    folders_ = {folder, folder / "rooms", folder / ".." / "rooms"};
    if (!rooms.empty()) folders_ = {rooms};
  }

  void Read(const fs::path& file, const std::string& text) {
    std::istringstream lines(text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
      if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
      const absl::Status status = Add(line);
      if (status.ok()) continue;
      labels_.failures.push_back(fmt::format("{}:{}: {}", file.string(), number, std::string(status.message())));
    }
  }

  TranslateLabels Finish() && {
    for (auto& room : labels_.rooms) {
      for (LabelledBullet& bullet : room.bullets) {
        *room.request.mutable_constraint_list()->add_sentences() = bullet.sentence;
      }
    }
    std::erase_if(labels_.rooms, [](const LabelledRoom& room) { return room.bullets.empty(); });
    return std::move(labels_);
  }

 private:
  absl::Status Add(const std::string& text) {
    const json record = json::parse(text, nullptr, false);
    if (!record.is_object()) return absl::InvalidArgumentError("not a JSON object");
    if (!record.contains("room") || !record["room"].is_string()) return absl::InvalidArgumentError("room: missing");
    try {
      const std::string name = record["room"];
      ASSIGN_OR_RETURN(const v1::LayoutGraph* graph, Room(name));
      ASSIGN_OR_RETURN(Line line, ReadLine(record, *graph));
      AddLine(labels_.rooms[index_[name]], std::move(line));
    } catch (const json::exception& error) {
      return absl::InvalidArgumentError(error.what());
    }
    return absl::OkStatus();
  }

  absl::StatusOr<const v1::LayoutGraph*> Room(const std::string& name) {
    if (const auto known = graphs_.find(name); known != graphs_.end()) return &known->second;
    if (name.empty() || name.find('/') != std::string::npos) return absl::InvalidArgumentError("room: not a file name");
    for (const fs::path& folder : folders_) {
      const absl::StatusOr<std::string> text = ReadFile(folder / (name + ".json"));
      if (!text.ok()) continue;
      ASSIGN_OR_RETURN(v1::LayoutGraph graph, evaluation::ReadFlairGptRoom(*text));
      LabelledRoom& room = labels_.rooms.emplace_back();
      room.name = name;
      *room.request.mutable_room() = graph.room();
      *room.request.mutable_zone_plan() = graph.zone_plan();
      *room.request.mutable_object_list() = graph.object_list();
      index_[name] = labels_.rooms.size() - 1;
      return &(graphs_[name] = std::move(graph));
    }
    return NotFound("room: no {}.json in {}; name its folder with --rooms", name, folders_[0].string());
  }

  // Lines of one bullet are facts of one sentence.
  static void AddLine(LabelledRoom& room, Line line) {
    const bool same = !room.bullets.empty() && room.bullets.back().list == line.list &&
                      room.bullets.back().sentence.text() == line.bullet && line.bullet != line.label.text;
    if (!same) {
      LabelledBullet& bullet = room.bullets.emplace_back();
      bullet.list = line.list;
      bullet.sentence.set_id(fmt::format("s{}", room.bullets.size()));
      bullet.sentence.set_text(line.bullet);
      bullet.sentence.set_scope(ScopeOf(line.list));
      bullet.sentence.set_weight(1);
      for (const std::string& id : line.subject_ids) bullet.sentence.add_subject_ids(id);
    }
    room.bullets.back().labels.push_back(std::move(line.label));
  }

  std::vector<fs::path> folders_;
  std::map<std::string, v1::LayoutGraph> graphs_;
  std::map<std::string, size_t> index_;
  TranslateLabels labels_;
};

}  // namespace

absl::StatusOr<std::string> ReadGoldObject(const json& index, const v1::LayoutGraph& room) {
  std::string id;
  if (index.is_number_integer()) id = fmt::format("floor_{}", index.get<int64_t>());
  if (index.is_string() && index.get<std::string>().rfind('t', 0) == 0)
    id = "item_" + index.get<std::string>().substr(1);
  const auto& objects = room.object_list().objects();
  const bool known = std::ranges::any_of(objects, [&](const auto& object) { return object.id() == id; });
  if (known) return id;
  return NotFound("the room has no object {}; expected an index such as 3 or \"t3\"", Text(index));
}

absl::StatusOr<v1::ConstraintEdge> ReadGoldCall(const json& call, const v1::LayoutGraph& room) {
  if (!call.is_object() || !call.contains("function") || !call["function"].is_string() || !call.contains("objects") ||
      !call["objects"].is_array()) {
    return InvalidArgument("gold: {} is not a call with function and objects", Text(call));
  }
  const std::string name = call["function"];
  const FlairGptFunction* function = evaluation::FindFlairGptFunction(evaluation::CanonicalFlairGptName(name));
  if (function == nullptr) return NotFound("gold: unknown function {}", name);
  v1::ConstraintEdge edge;
  edge.set_type(function->type);
  RETURN_IF_ERROR(AddObjects(call["objects"], *function, room, edge));
  const json params = call.value("params", json::object());
  if (!params.is_object()) return absl::InvalidArgumentError("gold: params is not an object");
  for (const auto& [key, value] : params.items()) RETURN_IF_ERROR(AddParameter(key, value, *function, room, edge));
  return edge;
}

absl::StatusOr<TranslateLabels> ReadTranslateLabels(const fs::path& path, const fs::path& rooms) {
  ASSIGN_OR_RETURN(const std::vector<fs::path> files, LabelFiles(path));
  Reader reader(path, rooms);
  for (const fs::path& file : files) {
    ASSIGN_OR_RETURN(const std::string text, ReadFile(file));
    reader.Read(file, text);
  }
  TranslateLabels labels = std::move(reader).Finish();
  if (!labels.rooms.empty()) return labels;
  return absl::InvalidArgumentError(labels.failures.empty() ? fmt::format("{}: no labels in it", path.string())
                                                            : labels.failures.front());
}

}  // namespace flair::cli
