// SPDX-License-Identifier: GPL-3.0-or-later
// Where a released function is sane our value is its value, up to the weight it has built in. The samples are
// evaluations of the released library; FLAIR_GOLDEN_COSTS may name a larger file of the same form.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "optimizer_worker/constraints/arguments.h"
#include "optimizer_worker/constraints/registry.h"
#include "optimizer_worker/constraints/whole_room.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {
namespace {

using nlohmann::json;

struct Sample {
  json line;
  Scene scene;
  Layout layout;
  std::vector<Vec2<double>> zone_centers;
};

Sample ReadSample(const std::string& text) {
  Sample sample{json::parse(text), {}, {}, {}};
  const json& room = sample.line.contains("room") ? sample.line["room"] : sample.line;
  sample.scene.room = RectangularRoom(room["width"], room["length"]);
  for (const json& zone : sample.line["zones"]) {
    sample.scene.zones.push_back({zone["name"], zone["name"]});
    sample.zone_centers.push_back({zone["x"], zone["y"]});
  }
  for (const json& o : sample.line["objects"]) {
    Object object;
    object.id = "o" + std::to_string(sample.scene.objects.size());
    object.footprint = {o["width"], o["length"]};
    sample.scene.objects.push_back(object);
    sample.layout.push_back({o["x"], o["y"], o["theta"]});
  }
  return sample;
}

// The released library swallowed an exception there, or its value depends on rounding.
bool IsBroken(const json& line) {
  const auto is_set = [&line](const char* key) { return line.contains(key) && !line[key].is_null(); };
  return is_set("exception") || (is_set("jump") && line["jump"].get<bool>()) ||
         (is_set("nested_exceptions") && !line["nested_exceptions"].empty()) || !line["value"].is_number();
}

double ValueOf(const Cost& cost, const Layout& layout) {
  std::vector<Pose<double>> poses;
  for (int i : cost.objects()) poses.push_back(layout[static_cast<size_t>(i)]);
  return cost.Value(poses);
}

// Functions of small objects, with the type of object that they act on.
const std::map<std::string, std::string> kSmall = {{"rug_under_central", "floor"},
                                                   {"center_ceiling", "ceiling"},
                                                   {"ceiling_above", "ceiling"},
                                                   {"on_top_central", "table"}};

// With the least number of evaluations that must be compared.
const std::map<std::string, int> kCompared = {
    {"aligned", 50},           {"balanced", 41},
    {"ceiling_above", 27},     {"center_ceiling", 27},
    {"in_bounds", 50},         {"ind_facing_into_room", 42},
    {"ind_in_region", 24},     {"ind_not_against_wall", 33},
    {"io_facing", 84},         {"on_top_central", 4},
    {"on_wall_in_region", 18}, {"rug_under_central", 27},
};

// What is wrong with the others; docs/constraints.md says what ours do instead.
const std::map<std::string, std::string> kNotCompared = {
    {"LINK", "no layout constraint; takes ranks for indices"},
    {"cost", "the pathway metric's sum, no constraint"},
    {"ind_accessible", "jumps at contact"},
    {"ind_away_from_fixed_object", "measures to the hinge and from the half diagonal"},
    {"ind_central", "a product over the axes, or an offset that is never 0"},
    {"ind_close_to_fixed_object", "measures to the hinge, compares squared metres"},
    {"ind_in_corner", "wants the object across the corner"},
    {"ind_near_wall", "ignores the side"},
    {"ind_next_to_wall", "multiplies the distances to two walls"},
    {"ind_not_block_fixed_object", "jumps at contact, ignores sockets"},
    {"ind_under_window", "wants the centre on the wall"},
    {"io_away_from", "never 0"},
    {"io_between", "made of io_next_to"},
    {"io_infront", "one point, headings wrap"},
    {"io_near", "from centre to centre"},
    {"io_next_to", "compares metres with fractions"},
    {"io_not_facing", "always 0"},
    {"io_on", "counts edges of the intersection"},
    {"io_parallel", "headings wrap"},
    {"io_perp", "reads another object's pose"},
    {"io_surround", "depends on the order of the seats"},
    {"io_under_central", "headings wrap"},
    {"no_overlap", "jumps from 0 to 10 at contact"},
    {"on_top_corner", "a point, and nothing when the two are apart"},
    {"on_wall_near", "never 0"},
    {"rug_under_central_forward", "not a number at its optimum"},
    {"t_valid", "a product over all walls, headings not reduced"},
    {"wall_attraction", "made of ind_near_wall"},
};

const char* GoldenFile() {
  const char* const larger = std::getenv("FLAIR_GOLDEN_COSTS");
  return larger != nullptr ? larger : FLAIR_SOURCE_DIR "/optimizer_worker/constraints/testdata/golden_costs.jsonl";
}

class GoldenCosts : public testing::Test {
 protected:
  // The sum of a term over floor objects: all of them, or those that the evaluation held free.
  template <typename Term>
  static double OverFloor(const Sample& s, bool with_fixed, const Term& term) {
    double sum = 0;
    for (size_t i = 0; i < s.scene.objects.size(); ++i) {
      const json& o = s.line["objects"][i];
      if ((with_fixed || !o["fixed"]) && o["role"] != "tertiary") sum += ValueOf(*term(static_cast<int>(i)), s.layout);
    }
    return sum;
  }

  static double Call(const Sample& s, const std::string& type, const std::string& call) {
    const auto cost = Bind(EdgeFromText(type, call), {s.scene, s.zone_centers});
    EXPECT_TRUE(cost.ok()) << cost.status();
    return cost.ok() ? ValueOf(**cost, s.layout) : NAN;
  }

  static std::string Id(const Sample& s, const char* argument) {
    return "o" + std::to_string(s.line["args"][argument].get<int>());
  }

  // Our value with the released function's weight; NaN where the two mean different things.
  static double Ours(const Sample& s) {
    const std::string function = s.line["function"];
    const json& args = s.line["args"];
    if (function == "in_bounds") {
      return args["weight"].get<double>() * OverFloor(s, true, [&s](int i) { return InBounds(s.scene, i); });
    }
    if (function == "aligned") return OverFloor(s, false, [&s](int i) { return Aligned(s.scene, i); });
    if (function == "balanced") return Balance(s);
    if (function == "ind_in_region" || function == "on_wall_in_region") return Zone(s);
    if (function == "ind_facing_into_room") {
      const double ours = Call(s, function, "object=" + Id(s, "object_index"));
      // Turned exactly away, where it is largest, the released function loses the value.
      return s.line["value"] == 0 && ours > 0.999 * (0.75 * kPi) * (0.75 * kPi) ? NAN : ours;
    }
    if (function == "ind_not_against_wall") return FreeStanding(s);
    if (function == "io_facing") {
      return Call(s, function,
                  "object=" + Id(s, "object1_index") + " target=" + Id(s, "object2_index") +
                      " both=" + (args["both"].get<bool>() ? "true" : "false"));
    }
    return kSmall.contains(function) ? Small(s, function) : NAN;
  }

  static double Balance(const Sample& s) {
    std::vector<int> floor_objects;
    int free_count = 0;
    for (size_t i = 0; i < s.scene.objects.size(); ++i) {
      if (s.line["objects"][i]["role"] == "tertiary") continue;
      floor_objects.push_back(static_cast<int>(i));
      free_count += !s.line["objects"][i]["fixed"].get<bool>();
    }
    return free_count < 2 ? NAN : ValueOf(*Balanced(s.scene, floor_objects), s.layout);
  }

  static double Zone(const Sample& s) {
    const std::string name = s.line["args"]["region_name"];
    const int zone = s.scene.ZoneIndexOf(name);
    const bool on_wall = s.line["function"] == "on_wall_in_region";
    const int object = s.line["args"][on_wall ? "tertiary_index" : "object_index"];
    // The released function takes the first zone whose name contains the text.
    if (zone < 0 || (on_wall && s.line["objects"][static_cast<size_t>(object)]["type"] != "wall")) return NAN;
    Scene scene = s.scene;
    scene.objects[static_cast<size_t>(object)].zone = zone;
    const std::unique_ptr<Cost> cost = ZoneAffinity(scene, object, s.zone_centers);
    if (cost == nullptr) return 0;
    return (on_wall ? 1 : s.line["args"]["weight"].get<double>()) * ValueOf(*cost, s.layout);
  }

  static double FreeStanding(const Sample& s) {
    const double min_distance = s.line["args"]["min_dist"];
    const size_t object = s.line["args"]["object_index"];
    for (const Vec2<double>& corner : Corners(s.scene.objects[object].footprint, s.layout[object])) {
      if (!Contains(s.scene.room.floor, corner)) return NAN;  // beyond the wall it measures back
    }
    return 10 * Call(s, "not_against_wall",
                     "object=" + Id(s, "object_index") + " min_distance_m=" + std::to_string(min_distance));
  }

  static double Small(const Sample& s, const std::string& function) {
    const bool rug = function == "rug_under_central";
    const size_t item = s.line["args"]["tertiary_index"];
    if (s.line["objects"][item]["type"] != kSmall.at(function)) return NAN;
    if (function == "center_ceiling") return Call(s, function, "object=" + Id(s, "tertiary_index"));
    const char* other = rug ? "object_index" : "other_index";
    if (function == "on_top_central") {
      const size_t host = s.line["args"][other];
      if (s.layout[item].theta_rad != s.layout[host].theta_rad) return NAN;  // compares headings that wrap
      return Call(s, function, "object=" + Id(s, "tertiary_index") + " host=" + Id(s, other));
    }
    if (rug) return Call(s, function, "rug=" + Id(s, "tertiary_index") + " object=" + Id(s, other));
    return Call(s, function, "object=" + Id(s, "tertiary_index") + " target=" + Id(s, other));
  }
};

TEST_F(GoldenCosts, EqualTheReleasedFunctionsWhereTheseAreSane) {
  std::ifstream file(GoldenFile());
  ASSERT_TRUE(file.is_open());
  std::map<std::string, int> compared;
  for (std::string line; std::getline(file, line);) {
    const Sample sample = ReadSample(line);
    if (IsBroken(sample.line)) continue;
    const double ours = Ours(sample);
    if (std::isnan(ours)) continue;
    const double golden = sample.line["value"];
    ++compared[sample.line["function"]];
    EXPECT_NEAR(ours, golden, 1e-9 * std::max(1.0, std::abs(golden)))
        << sample.line["function"] << " " << sample.line["id"];
  }
  for (const auto& [function, least] : kCompared) EXPECT_GE(compared[function], least) << function;
  for (const auto& [function, count] : compared) {
    EXPECT_TRUE(kCompared.contains(function)) << function << " is compared " << count << " times but not listed";
  }
}

TEST_F(GoldenCosts, EveryReleasedFunctionIsComparedOrHasAReasonNotToBe) {
  const auto is_listed = [](const std::string& function) {
    return kCompared.contains(function) != kNotCompared.contains(function);
  };
  for (const auto& [function, reason] : kNotCompared) {
    EXPECT_FALSE(reason.empty() || kCompared.contains(function)) << function;
  }
  std::ifstream file(GoldenFile());
  for (std::string line; std::getline(file, line);) {
    const std::string function = json::parse(line)["function"];
    EXPECT_TRUE(is_listed(function)) << function;
  }
}

}  // namespace
}  // namespace flair::optimizer
