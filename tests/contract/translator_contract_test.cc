// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "room/validation/validate.h"
#include "tests/contract/contract.h"

namespace flair::testing {
namespace {

using Service = v1::TranslatorService::StubInterface;

class TranslatorContract : public ::testing::Test {
 protected:
  v1::TranslateRequest Request() {
    const auto stub = v1::OptimizerService::NewStub(optimizer_.channel());
    const auto catalog =
        Ask(*stub, &v1::OptimizerService::StubInterface::ListConstraintTypes, v1::ListConstraintTypesRequest());
    EXPECT_TRUE(catalog.ok()) << catalog.status();
    const v1::LayoutGraph graph = BedroomGraph();
    v1::TranslateRequest request;
    request.set_request_id("r1");
    *request.mutable_room() = graph.room();
    *request.mutable_zone_plan() = graph.zone_plan();
    *request.mutable_object_list() = graph.object_list();
    *request.mutable_constraint_list() = graph.constraint_list();
    if (catalog.ok()) *request.mutable_catalog() = catalog->catalog();
    return request;
  }

  ServerUnderTest optimizer_{"optimizer"};
  ServerUnderTest translator_{"translator"};
  std::unique_ptr<v1::TranslatorService::Stub> stub_ = v1::TranslatorService::NewStub(translator_.channel());
};

TEST_F(TranslatorContract, EverySentenceBecomesCallsOfTheCatalogueOrADiagnostic) {
  v1::TranslateRequest request = Request();
  v1::Sentence& odd = *request.mutable_constraint_list()->add_sentences();
  odd.set_id("s3");
  odd.set_text("Colourless green ideas sleep furiously.");
  odd.set_scope(v1::SENTENCE_SCOPE_INTRA);
  odd.set_weight(1);
  const auto answer = Ask(*stub_, &Service::Translate, request);
  ASSERT_TRUE(answer.ok()) << answer.status();
  const v1::LayoutGraph& graph = answer->layout_graph();
  EXPECT_TRUE(Validate(graph).ok()) << Validate(graph);
  for (const v1::Sentence& sentence : request.constraint_list().sentences()) {
    bool accounted = false;
    for (const v1::ConstraintEdge& edge : graph.edges()) accounted |= edge.sentence_id() == sentence.id();
    for (const v1::Diagnostic& diagnostic : graph.diagnostics()) accounted |= diagnostic.subject_id() == sentence.id();
    EXPECT_TRUE(accounted) << sentence.text();
  }
  for (const v1::ConstraintEdge& edge : graph.edges()) {
    bool known = false;
    for (const v1::ConstraintType& type : request.catalog().types()) known |= type.name() == edge.type();
    EXPECT_TRUE(known) << edge.type();
    EXPECT_NE(edge.sentence_id(), "s3") << "a guess at a sentence that says nothing";
  }
}

TEST_F(TranslatorContract, PassesOnWhatItWasGiven) {
  const v1::TranslateRequest request = Request();
  const auto answer = Ask(*stub_, &Service::Translate, request);
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_EQ(answer->layout_graph().room().SerializeAsString(), request.room().SerializeAsString());
  EXPECT_EQ(answer->layout_graph().object_list().SerializeAsString(), request.object_list().SerializeAsString());
  EXPECT_EQ(answer->layout_graph().catalog_library(), request.catalog().library());
}

TEST_F(TranslatorContract, ABadRequestIsInvalidArgument) {
  v1::TranslateRequest request = Request();
  request.mutable_object_list()->mutable_objects(0)->set_id("");
  EXPECT_EQ(Ask(*stub_, &Service::Translate, request).status().code(), absl::StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace flair::testing
