// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/contract/contract.h"

#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace flair::testing {
namespace {

std::string AddressFromEnvironment(const std::string& name) {
  std::string variable = "FLAIR_CONTRACT_";
  for (const char c : name) variable += static_cast<char>(c - 'a' + 'A');
  const char* value = std::getenv(variable.c_str());
  return value == nullptr ? "" : value;
}

template <typename Message>
Message Parse(const std::string& text) {
  Message message;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &message));
  return message;
}

}  // namespace

ServerUnderTest::ServerUnderTest(const std::string& name) {
  std::string address = AddressFromEnvironment(name);
  if (address.empty()) {
    program_ = std::make_unique<ServerProgram>(
        "flair-" + name, "runtime { listen_address: \"127.0.0.1:0\" log_level: \"error\" }", folder_.path());
    address = program_->address();
  }
  auto channel = runtime::MakeChannel(address, "");
  EXPECT_TRUE(channel.ok()) << channel.status();
  if (channel.ok()) channel_ = *channel;
}

v1::Brief BedroomBrief() { return Parse<v1::Brief>(R"pb(text: "A bedroom that is 4m x 5m." seed: 3)pb"); }

v1::LayoutGraph BedroomGraph() {
  auto graph = Parse<v1::LayoutGraph>(R"pb(
    object_list {
      objects {
        id: "nightstand"
        name: "nightstand"
        role: OBJECT_ROLE_SECONDARY
        kind: OBJECT_KIND_FLOOR
        zone_id: "sleeping"
        width_m: 0.5
        depth_m: 0.4
        height_m: 0.5
      }
    }
    constraint_list {
      sentences {
        id: "s2"
        text: "The nightstand is next to the bed."
        scope: SENTENCE_SCOPE_INTER
        subject_ids: "nightstand"
        subject_ids: "bed"
        weight: 1
      }
    })pb");
  *graph.mutable_room() = BedroomRoom();
  *graph.mutable_zone_plan() = BedroomZones();
  *graph.mutable_object_list()->add_objects() = BedroomBed();
  graph.mutable_object_list()->mutable_objects()->SwapElements(0, 1);
  *graph.mutable_constraint_list()->add_sentences() = BedroomSentence();
  graph.mutable_constraint_list()->mutable_sentences()->SwapElements(0, 1);
  return graph;
}

}  // namespace flair::testing
