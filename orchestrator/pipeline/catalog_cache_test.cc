// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/pipeline/catalog_cache.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>

#include "orchestrator/pipeline/fake_stages.h"

namespace flair::orchestrator {
namespace {

// One of revision `answering` answers, whichever is thought to.
class OptimizersOfRevisions : public FakeStages {
 public:
  std::optional<std::string> answering;

  absl::StatusOr<v1::ListConstraintTypesResponse> ListConstraintTypes(const v1::ListConstraintTypesRequest& request,
                                                                      Call& call) override {
    auto response = FakeStages::ListConstraintTypes(request, call);
    if (!response.ok()) return response;
    response->mutable_catalog()->set_library("of " + answering.value_or("nobody"));
    call.SetAnswerer({answering, [] {}});
    return response;
  }
  std::string Ask(CatalogCache& cache, std::optional<std::string> revision) {
    set_revision(std::move(revision));
    StageCall call;
    const auto catalog = cache.Get(*this, call);
    return catalog.ok() ? (*catalog)->catalog.library() : catalog.status().ToString();
  }
  int asked() const { return calls("ListConstraintTypes"); }
};

TEST(CatalogCache, AsksOptimizersOfOneRevisionOnce) {
  OptimizersOfRevisions optimizers;
  CatalogCache cache;
  optimizers.answering = "1";
  for (int i = 0; i < 3; ++i) EXPECT_EQ(optimizers.Ask(cache, "1"), "of 1");
  EXPECT_EQ(optimizers.asked(), 1);
  optimizers.answering = "2";
  EXPECT_EQ(optimizers.Ask(cache, "2"), "of 2");
  EXPECT_EQ(optimizers.Ask(cache, "1"), "of 1");
  EXPECT_EQ(optimizers.asked(), 2);
}

TEST(CatalogCache, KeepsWhatIsAnsweredAsThatOfWhoAnswered) {
  OptimizersOfRevisions optimizers;
  CatalogCache cache;
  optimizers.answering = "2";
  EXPECT_EQ(optimizers.Ask(cache, "1"), "of 2");
  optimizers.answering = "1";
  EXPECT_EQ(optimizers.Ask(cache, "1"), "of 1");
  EXPECT_EQ(optimizers.Ask(cache, "2"), "of 2");
  EXPECT_EQ(optimizers.asked(), 2);
}

TEST(CatalogCache, AsksThoseThatDoNotSayWhichTheyAreEachTime) {
  OptimizersOfRevisions optimizers;
  CatalogCache cache;
  for (int i = 0; i < 2; ++i) EXPECT_EQ(optimizers.Ask(cache, std::nullopt), "of nobody");
  EXPECT_EQ(optimizers.asked(), 2);
}

}  // namespace
}  // namespace flair::orchestrator
