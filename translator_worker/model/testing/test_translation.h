// SPDX-License-Identifier: GPL-3.0-or-later
// A small room, its catalogue, and a scripted model that translates it; for tests.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "google/protobuf/text_format.h"
#include "gtest/gtest.h"
#include "llm/testing/fake_llm_client.h"
#include "translator_worker/model/model_translator.h"

namespace flair::translator {

inline v1::TranslateRequest Room() {
  v1::TranslateRequest request;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(
      R"pb(
        request_id: "r1"
        room {
          room_type: "dining room"
          floor {
            vertices {}
            vertices { x_m: 4 }
            vertices { x_m: 4 y_m: 3 }
            vertices { y_m: 3 }
          }
          walls { name: "south" }
          walls { name: "east" }
          walls { name: "north" }
          walls { name: "west" }
          height_m: 3
        }
        zone_plan { zones { id: "dining" name: "dining area" purpose: "To eat." } }
        object_list {
          objects {
            id: "table"
            name: "table"
            role: OBJECT_ROLE_PRIMARY
            kind: OBJECT_KIND_FLOOR
            zone_id: "dining"
            width_m: 1.6
            depth_m: 0.9
            height_m: 0.75
          }
          objects {
            id: "dining_chair_1"
            name: "dining chair"
            role: OBJECT_ROLE_SECONDARY
            kind: OBJECT_KIND_FLOOR
            zone_id: "dining"
            width_m: 0.45
            depth_m: 0.5
            height_m: 0.9
          }
          objects {
            id: "dining_chair_2"
            name: "dining chair"
            role: OBJECT_ROLE_SECONDARY
            kind: OBJECT_KIND_FLOOR
            zone_id: "dining"
            width_m: 0.45
            depth_m: 0.5
            height_m: 0.9
          }
          objects {
            id: "vase"
            name: "vase"
            role: OBJECT_ROLE_TERTIARY
            kind: OBJECT_KIND_SURFACE
            width_m: 0.2
            depth_m: 0.2
            height_m: 0.3
          }
        }
        constraint_list {
          sentences {
            id: "s1"
            text: "The table stands against a wall."
            scope: SENTENCE_SCOPE_INTRA
            subject_ids: "table"
            weight: 2
          }
          sentences { id: "s2" text: "The chairs surround the table." scope: SENTENCE_SCOPE_INTER weight: 1 }
          sentences { id: "s3" text: "The vase is on the table." scope: SENTENCE_SCOPE_TERTIARY weight: 1 }
        }
        catalog {
          library: "test 1"
          types {
            name: "against_wall"
            aliases: "ind_next_to_wall"
            family: "wall"
            summary: "At a wall."
            parameters { name: "object" kind: PARAMETER_KIND_OBJECT required: true }
            parameters { name: "side" kind: PARAMETER_KIND_SIDE }
            parameters { name: "wall" kind: PARAMETER_KIND_WALL }
          }
          types {
            name: "surround"
            family: "group"
            summary: "Around it."
            parameters { name: "object" kind: PARAMETER_KIND_OBJECT required: true }
            parameters { name: "others" kind: PARAMETER_KIND_OBJECTS required: true }
          }
          types {
            name: "near"
            family: "pair"
            summary: "Near."
            parameters { name: "object" kind: PARAMETER_KIND_OBJECT required: true }
            parameters { name: "target" kind: PARAMETER_KIND_OBJECT required: true }
            parameters { name: "max_distance_m" kind: PARAMETER_KIND_NUMBER unit: "m" min_number: 0 max_number: 5 }
          }
          types {
            name: "on"
            family: "surface"
            summary: "On it."
            parameters { name: "object" kind: PARAMETER_KIND_OBJECT required: true }
            parameters { name: "target" kind: PARAMETER_KIND_OBJECT required: true }
          }
          types { name: "no_overlap" family: "room" built_in: true }
        })pb",
      &request));
  return request;
}

// `calls`: texts, or JSON.
inline std::string Entry(const std::string& id, const std::vector<std::string>& calls) {
  std::string list;
  for (const std::string& call : calls) {
    list += (list.empty() ? "" : ", ") + (call.starts_with("{") ? call : "\"" + call + "\"");
  }
  return R"({"id": ")" + id + R"(", "calls": [)" + list + "]}";
}
inline std::string Answer(const std::string& entries) { return R"({"sentences": [)" + entries + "]}"; }

inline constexpr char kWallCall[] = "against_wall(table)";
inline constexpr char kSurroundCall[] = "surround(table, [dining_chair_1, dining_chair_2])";
inline constexpr char kOnCall[] = "on(vase, table)";

class ModelTranslatorTest : public ::testing::Test {
 protected:
  ModelTranslatorTest() {
    auto made = ModelTranslator::Make(std::unique_ptr<llm::LlmClient>(model_), DefaultPromptFolder(), "");
    EXPECT_TRUE(made.ok()) << made.status();
    translator_ = *std::move(made);
  }
  void AnswerTheRest() {
    model_->Answer("translation.inter", Answer(Entry("s2", {kSurroundCall})));
    model_->Answer("translation.tertiary", Answer(Entry("s3", {kOnCall})));
  }
  // With one scripted answer, or two, to the first pass.
  v1::LayoutGraph TranslateIntra(const std::string& answer, const std::string& repaired = "") {
    model_->Answer("translation.intra", answer);
    if (!repaired.empty()) model_->Answer("translation.intra/repair", repaired);
    AnswerTheRest();
    auto response = translator_->Translate(request_, call_);
    EXPECT_TRUE(response.ok()) << response.status();
    return response.ok() ? response->layout_graph() : v1::LayoutGraph();
  }
  static std::vector<std::string> Types(const v1::LayoutGraph& graph) {
    std::vector<std::string> types;
    for (const v1::ConstraintEdge& edge : graph.edges()) types.push_back(edge.type());
    return types;
  }
  static std::vector<std::string> Codes(const v1::LayoutGraph& graph) {
    std::vector<std::string> codes;
    for (const v1::Diagnostic& remark : graph.diagnostics()) codes.push_back(remark.code());
    return codes;
  }

  llm::FakeLlmClient* model_ = new llm::FakeLlmClient();
  std::unique_ptr<ModelTranslator> translator_;
  v1::TranslateRequest request_ = Room();
  runtime::CallContext call_;
};

}  // namespace flair::translator
