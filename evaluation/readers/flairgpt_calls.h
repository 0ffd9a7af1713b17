// SPDX-License-Identifier: GPL-3.0-or-later
// The calls of a recorded problem as constraint edges.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/layout_graph.pb.h"
#include "flair/v1/solved_layout.pb.h"
#include "nlohmann/json.hpp"
#include "nlohmann/json_fwd.hpp"

namespace flair::evaluation {

// One recorded call as edges (without ids), against the objects that `graph` holds already; more than one when it names
// several partners at once. Where a wall or a piece of furniture is named in place of a door, window or socket, the
// call is read as the one that is about walls or furniture. NOT_FOUND or INVALID_ARGUMENT with the reason when it means
// nothing: an unknown function, an absent object, zone or feature.
absl::StatusOr<std::vector<v1::ConstraintEdge>> ReadFlairGptCall(const nlohmann::json& call,
                                                                 const v1::LayoutGraph& graph);

// The functions of the reference implementation under the names of our constraint types.

// What recorded words mean, by list: flairgpt_vocabulary.json. Null for a word that is not in it.
const nlohmann::json* FlairGptMeaning(const char* list, const std::string& word);

// What a recorded argument stands for, by the letter that the table of functions has for it.
enum class FlairGptKind : char {
  kFloorObject = 'o',
  kItem = 'i',
  kFloorObjects = 'L',
  kZone = 'z',
  kFeature = 'f',
  kSide = 's',
  kSides = 'S',
  kCorner = 'c',
  kNumber = 'n',
  kFlag = 'b',
  kIgnored = '_',  // has no part in what the call says
};

struct FlairGptParameter {
  // Ours; empty for kIgnored.
  std::string name;
  FlairGptKind kind = FlairGptKind::kIgnored;
  bool required = false;
};

// A function: our type, and its parameters in the order of its positional arguments.
struct FlairGptFunction {
  std::string type;
  std::vector<FlairGptParameter> parameters;
  // Further arguments do not change what the call says.
  bool ignores_others = false;
};

// The name under which FindFlairGptFunction knows a function of another version, or a slip whose meaning is clear.
std::string CanonicalFlairGptName(std::string name);

// Null when the reference has no such function, or one that has no type here.
const FlairGptFunction* FindFlairGptFunction(const std::string& canonical_name);

// Position of the parameter that a recorded keyword names; -1 when it names none.
int PositionOfKeyword(const std::string& keyword, const FlairGptFunction& function);

// The arguments of recorded calls as ours.

// No index of an object is larger.
inline constexpr double kLargestIndex = 1e6;

// Words of a name in lower case, one blank between them: "Dining_Area" is "dining area".
std::string FlairGptWords(const std::string& name);

// Id that ReadFlairGptRoom gives to an object.
std::string FlairGptObjectId(bool tertiary, int index);

// Reads against the room, zones and objects of a graph, which it borrows.
class FlairGptArguments {
 public:
  explicit FlairGptArguments(const v1::LayoutGraph& graph) : graph_(graph) {}

  // The argument for `parameter`; nothing when the value leaves it to its default. `object_id` is the call's first
  // object, whose proportions say which sides are its long ones. NOT_FOUND and INVALID_ARGUMENT say what is wrong.
  absl::StatusOr<std::optional<v1::Argument>> Read(const FlairGptParameter& parameter, const nlohmann::json& value,
                                                   const std::string& object_id) const;

  // By index or by name.
  absl::StatusOr<std::string> ObjectId(const nlohmann::json& value, bool tertiary) const;

 private:
  absl::StatusOr<std::string> Feature(const nlohmann::json& value) const;
  absl::StatusOr<std::string> ZoneId(const nlohmann::json& value) const;
  absl::StatusOr<std::vector<std::string>> Sides(const nlohmann::json& value, const std::string& object_id) const;
  absl::StatusOr<std::vector<std::string>> Objects(const nlohmann::json& value) const;

  const v1::LayoutGraph& graph_;
};

// Reads the reference implementation's recorded problems: a JSON file with room, fixed objects, zones, objects and
// constraint calls becomes a LayoutGraph.

// The problem as a graph. Object ids are "floor_<index>" and "item_<index>" with the recording's own indices. Calls
// that name absent objects, features or functions become diagnostics, as the recording is a model's and models err;
// heights, which it lacks, take one plausible value per kind. INVALID_ARGUMENT when the text is not such a file.
absl::StatusOr<v1::LayoutGraph> ReadFlairGptRoom(const std::string& json);

// The same of a text that was parsed already.
absl::StatusOr<v1::LayoutGraph> ReadFlairGptProblem(const nlohmann::json& problem);

// What is wrong with a file that should be a recorded problem, field by field, before it is read.

// The text as JSON. INVALID_ARGUMENT with line and column where it stops being that.
absl::StatusOr<nlohmann::json> ParseFlairGptText(const std::string& text);

// INVALID_ARGUMENT when the problem's room, fixed objects, zones or objects cannot be read: up to five faults, each as
// field, value and what would be right. What its calls say is not looked at, only that they are lists: a model wrote
// them. A size of 0 is fine, it stands for none; so are fixed objects without wall or position, which nobody placed.
absl::Status CheckFlairGptProblem(const nlohmann::json& problem);

// Layouts of the reference implementation's problems: the one that a recording holds, and ours as its judge reads them.

// The layout that was recorded with a problem, by the released implementation; `graph` is what ReadFlairGptRoom made of
// the same text. Graph and placements only. NOT_FOUND when the recording has no layout or not all of one.
absl::StatusOr<v1::SolvedLayout> ReadFlairGptSolution(const std::string& json, const v1::LayoutGraph& graph);

// A layout as the judge reads it, indented. `name` is the problem's name; `seconds` what the solve took. Objects keep
// the index that they were imported with; those of other graphs are numbered in their order, tertiaries by themselves.
std::string WriteFlairGptLayout(const v1::SolvedLayout& layout, const std::string& name, double seconds);

}  // namespace flair::evaluation
