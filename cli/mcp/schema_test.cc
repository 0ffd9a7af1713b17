// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mcp/schema.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string_view>

namespace flair {
std::string_view McpToolTable();
}

namespace flair::cli::mcp {
namespace {

using Json = nlohmann::json;

std::string FaultIn(const char* schema, const char* value) {
  return std::string(CheckAgainst(Json::parse(schema), Json::parse(value)).message());
}

TEST(Schema, SaysWhereAValueIsWrongAndWhatWouldBeRight) {
  constexpr char kMove[] = R"({"type":"object","required":["x"],"additionalProperties":false,"properties":{
      "x":{"type":"number","minimum":0,"maximum":5}, "n":{"type":"integer"}, "w":{"enum":["a","b"]},
      "s":{"type":"string","minLength":1,"maxLength":3}, "p":{"type":"number","exclusiveMinimum":0},
      "l":{"type":"array","maxItems":2,"items":{"type":"boolean"}}}})";
  EXPECT_EQ(FaultIn(kMove, R"({"x":5,"n":2,"w":"b","s":"äöü","p":0.1,"l":[true]})"), "");
  EXPECT_EQ(FaultIn(kMove, R"({"x":5,"n":2.0})"), "");
  EXPECT_EQ(FaultIn(kMove, "{}"), "x: is missing");
  EXPECT_EQ(FaultIn(kMove, "[]"), "arguments: []; must be an object");
  EXPECT_EQ(FaultIn(kMove, R"({"x":"1"})"), "x: \"1\"; must be a number");
  EXPECT_EQ(FaultIn(kMove, R"({"x":-0.5})"), "x: -0.5; must be at least 0");
  EXPECT_EQ(FaultIn(kMove, R"({"x":6})"), "x: 6; must be at most 5");
  EXPECT_EQ(FaultIn(kMove, R"({"x":1,"n":1.5})"), "n: 1.5; must be an integer");
  EXPECT_EQ(FaultIn(kMove, R"({"x":1,"w":"c"})"), "w: \"c\"; must be one of a, b");
  EXPECT_EQ(FaultIn(kMove, R"({"x":1,"s":""})"), "s: \"\"; must be some text");
  EXPECT_EQ(FaultIn(kMove, R"({"x":1,"s":"long"})"), "s: \"long\"; must be at most 3 characters");
  EXPECT_EQ(FaultIn(kMove, R"({"x":1,"p":0})"), "p: 0; must be more than 0");
  EXPECT_EQ(FaultIn(kMove, R"({"x":1,"l":[true,1]})"), "l[1]: 1; must be a boolean");
  EXPECT_EQ(FaultIn(kMove, R"({"x":1,"l":[true,true,true]})"), "l: 3 items; at most 2");
  EXPECT_EQ(FaultIn(kMove, R"({"x":1,"y":2})"), "y: is not known; there are: l, n, p, s, w, x");
}

TEST(Schema, SharedPartsArePutInAndMayBeOverruled) {
  const Json shared = Json::parse(R"({"id":{"type":"string","description":"An id."},"both":[{"use":"id"}]})");
  EXPECT_EQ(WithShared(Json::parse(R"({"a":{"use":"id","description":"Other."},"b":{"use":"both"}})"), shared),
            Json::parse(R"({"a":{"type":"string","description":"Other."},
                            "b":[{"type":"string","description":"An id."}]})"));
}

// What agents are told of each tool, and what it checks.
TEST(ToolTable, EveryToolIsDescribedInFull) {
  const Json table = Json::parse(McpToolTable());
  std::set<std::string> names;
  for (const Json& tool : WithShared(table["tools"], table["shared"])) {
    const std::string name = tool["name"];
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_TRUE(tool["description"].get<std::string>().ends_with(".")) << name;
    EXPECT_TRUE(tool.contains("title")) << name;
    EXPECT_EQ(tool["annotations"].size(), 4u) << name;
    EXPECT_EQ(tool["annotations"]["openWorldHint"], false) << name;
    EXPECT_EQ(tool["outputSchema"]["type"], "object") << name;
    EXPECT_EQ(tool["inputSchema"]["additionalProperties"], false) << name;
    for (const auto& [parameter, schema] : tool["inputSchema"]["properties"].items()) {
      EXPECT_TRUE(schema.contains("description")) << name << " " << parameter;
      EXPECT_TRUE(schema.contains("type")) << name << " " << parameter;
    }
    for (const Json& required : tool["inputSchema"].value("required", Json::array())) {
      EXPECT_TRUE(tool["inputSchema"]["properties"].contains(required)) << name << " " << required;
    }
  }
}

}  // namespace
}  // namespace flair::cli::mcp
