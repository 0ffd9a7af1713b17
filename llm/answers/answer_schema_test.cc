// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "flair/model/v1/constraint_answers.pb.h"
#include "flair/model/v1/object_answers.pb.h"
#include "flair/model/v1/room_answers.pb.h"
#include "flair/model/v1/style_answers.pb.h"
#include "llm/answers/read_answer.h"

namespace flair::llm {
namespace {

using nlohmann::json;

TEST(AnswerSchema, IsWhatServersEnforceStrictly) {
  EXPECT_EQ(AnswerSchema(*model::v1::ZonesAnswer::descriptor(), {}),
            R"({"type":"object","properties":{"zones":{"type":"array","items":{"type":"object","properties":{)"
            R"("name":{"type":"string","description":"One or two words in lower case, such as sleeping."},)"
            R"("purpose":{"type":"string","description":"At most twelve words: what happens there."}},)"
            R"("required":["name","purpose"],"additionalProperties":false},"minItems":1,"maxItems":12,)"
            R"("description":"Most important first."}},"required":["zones"],"additionalProperties":false})");
}

TEST(AnswerSchema, OptionalFieldsMayBeNullAndChoicesAreEnums) {
  const json room = json::parse(AnswerSchema(*model::v1::RoomAnswer::descriptor(), {}));
  EXPECT_EQ(room["properties"]["height_m"]["type"], json({"number", "null"}));
  EXPECT_EQ(room["properties"]["height_m"]["maximum"], 12);
  const json& swing = room["properties"]["openings"]["items"]["properties"]["swing"];
  EXPECT_EQ(swing["enum"], json({"inward", "outward", "sliding", "open", nullptr}));
  const json objects =
      json::parse(AnswerSchema(*model::v1::FloorObjectsAnswer::descriptor(),
                               {{"flair.model.v1.FloorObjectAnswer.zone", {{"a", "b"}, {{"x", "a"}}}}}));
  EXPECT_EQ(objects["properties"]["objects"]["items"]["properties"]["zone"]["enum"], json({"a", "b"}));
  EXPECT_EQ(objects["properties"]["objects"]["items"]["properties"]["count"]["type"], "integer");
}

// Every object closed, with all its properties required: at any depth of all our answers.
void CheckClosed(const json& schema) {
  if (schema.is_array()) {
    for (const json& element : schema) CheckClosed(element);
  }
  if (!schema.is_object()) return;
  if (schema.contains("properties") && schema["type"] == "object") {
    EXPECT_EQ(schema["additionalProperties"], false);
    EXPECT_EQ(schema["required"].size(), schema["properties"].size());
  }
  for (const auto& [key, member] : schema.items()) CheckClosed(member);
}

TEST(AnswerSchema, AllAnswersAreClosedObjects) {
  using namespace model::v1;
  for (const auto* type : {RoomAnswer::descriptor(), ZonesAnswer::descriptor(), FloorObjectsAnswer::descriptor(),
                           TertiariesAnswer::descriptor(), StyleAnswer::descriptor(), IntraAnswer::descriptor(),
                           InterAnswer::descriptor(), CleaningAnswer::descriptor()}) {
    CheckClosed(json::parse(AnswerSchema(*type, {})));
  }
  EXPECT_EQ(AnswerSchemaName(*FloorObjectsAnswer::descriptor()), "floor_objects_answer");
}

}  // namespace
}  // namespace flair::llm
