// SPDX-License-Identifier: GPL-3.0-or-later
// The service as others see it: over an in-process channel.
#include <string>
#include <utility>

#include "absl/time/clock.h"
#include "flair/v1/translator_service.grpc.pb.h"
#include "google/protobuf/text_format.h"
#include "gtest/gtest.h"
#include "translator_worker/service/make_translator_service.h"
#include "worker_runtime/grpc/in_process_server.h"

namespace flair::translator {
namespace {

// A catalogue that is known from the start.
class FixedCatalogSource final : public CatalogSource {
 public:
  explicit FixedCatalogSource(v1::ConstraintCatalog catalog) : catalog_(std::move(catalog)) {}

  absl::StatusOr<v1::ConstraintCatalog> Get(runtime::CallContext&) override { return catalog_; }

 private:
  const v1::ConstraintCatalog catalog_;
};

v1::TranslateRequest BedroomRequest() {
  v1::TranslateRequest request;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(
      R"pb(
        request_id: "r1"
        room {
          room_type: "bedroom"
          title: "A bedroom"
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
        zone_plan { zones { id: "sleeping" name: "sleeping" purpose: "To sleep." } }
        object_list {
          objects {
            id: "bed"
            name: "bed"
            role: OBJECT_ROLE_PRIMARY
            kind: OBJECT_KIND_FLOOR
            zone_id: "sleeping"
            width_m: 1.6
            depth_m: 2
            height_m: 0.5
          }
        }
        constraint_list {
          sentences { id: "s1" text: "The bed's headboard is against a wall." scope: SENTENCE_SCOPE_INTRA weight: 1 }
          sentences { id: "s2" text: "The bed sings." scope: SENTENCE_SCOPE_INTRA weight: 1 }
        })pb",
      &request));
  return request;
}

v1::ConstraintCatalog SmallCatalog() {
  v1::ConstraintCatalog catalog;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(
      R"pb(
        library: "small 1"
        types {
          name: "against_wall"
          family: "wall"
          summary: "Stands against a wall."
          doc: "cost"
          parameters { name: "object" kind: PARAMETER_KIND_OBJECT doc: "What." required: true }
          parameters { name: "side" kind: PARAMETER_KIND_SIDE doc: "Which side." }
        })pb",
      &catalog));
  return catalog;
}

struct Served {
  explicit Served(std::unique_ptr<CatalogSource> source) {
    auto started = runtime::InProcessServer::Start(
        "flair-translator", {}, v1::TranslatorService::service_full_name(),
        [&](runtime::WorkerContext& worker) -> absl::StatusOr<std::unique_ptr<grpc::Service>> {
          return MakeTranslatorService(std::move(source), nullptr, worker);
        });
    EXPECT_TRUE(started.ok()) << started.status();
    server = *std::move(started);
  }

  grpc::Status Translate(const v1::TranslateRequest& request, v1::TranslateResponse& response) {
    grpc::ClientContext context;
    context.set_deadline(absl::ToChronoTime(absl::Now() + absl::Seconds(60)));
    return v1::TranslatorService::NewStub(server->channel())->Translate(&context, request, &response);
  }

  std::unique_ptr<runtime::InProcessServer> server;
};

TEST(TranslatorService, AnswersWithEdgesAndDiagnostics) {
  Served served(std::make_unique<FixedCatalogSource>(SmallCatalog()));
  v1::TranslateResponse response;
  const grpc::Status status = served.Translate(BedroomRequest(), response);
  ASSERT_TRUE(status.ok()) << status.error_message();
  ASSERT_EQ(response.layout_graph().edges_size(), 1);
  EXPECT_EQ(response.layout_graph().edges(0).type(), "against_wall");
  EXPECT_EQ(response.layout_graph().edges(0).sentence_id(), "s1");
  ASSERT_EQ(response.layout_graph().diagnostics_size(), 1);
  EXPECT_EQ(response.layout_graph().diagnostics(0).subject_id(), "s2");
  EXPECT_EQ(response.layout_graph().catalog_library(), "small 1");
  EXPECT_EQ(response.producer().method(), "grammar");
}

TEST(TranslatorService, PrefersTheCatalogueOfTheRequest) {
  Served served(std::make_unique<NoCatalogSource>());
  v1::TranslateRequest request = BedroomRequest();
  *request.mutable_catalog() = SmallCatalog();
  v1::TranslateResponse response;
  const grpc::Status status = served.Translate(request, response);
  EXPECT_TRUE(status.ok()) << status.error_message();
  EXPECT_EQ(response.layout_graph().edges_size(), 1);
}

TEST(TranslatorService, SaysWhenThereIsNoCatalogue) {
  Served served(std::make_unique<NoCatalogSource>());
  v1::TranslateResponse response;
  EXPECT_EQ(served.Translate(BedroomRequest(), response).error_code(), grpc::StatusCode::FAILED_PRECONDITION);
}

TEST(TranslatorService, RejectsAnObjectThatNobodyKnows) {
  Served served(std::make_unique<FixedCatalogSource>(SmallCatalog()));
  v1::TranslateRequest request = BedroomRequest();
  request.mutable_constraint_list()->mutable_sentences(0)->add_subject_ids("ghost");
  v1::TranslateResponse response;
  const grpc::Status status = served.Translate(request, response);
  EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
  EXPECT_NE(status.error_message().find("ghost"), std::string::npos) << status.error_message();
}

}  // namespace
}  // namespace flair::translator
