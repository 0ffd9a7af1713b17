// SPDX-License-Identifier: GPL-3.0-or-later
// Deletion while servers die.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "tests/contract/queue/queue_test.h"
#include "tests/fixtures/nats_server.h"

namespace flair::testing {
namespace {

class DeletionOnThreeServers : public DeletionContract {
 protected:
  // Until nothing is left of it, whatever fails meanwhile.
  void Delete(WatchedQueue& queue, const std::string& batch_id) {
    while (true) {
      const auto some = queue->DeleteBatch(batch_id, 1, *artifacts_);
      // The answer to its last step may have been lost.
      if (absl::IsNotFound(some.status()) || (some.ok() && some->done)) return;
      ASSERT_TRUE(some.ok() || absl::IsUnavailable(some.status())) << some.status();
    }
  }
};
INSTANTIATE_TEST_SUITE_P(, DeletionOnThreeServers, ::testing::Values(JetStreamForm(3)),
                         [](const ::testing::TestParamInfo<NamedForm>& form) { return form.param.name; });

TEST_P(DeletionOnThreeServers, OneOfThemMayDieInBetween) {
  WatchedQueue queue = Open();
  RunBatch(queue, "b1", 20, {"own", "shared"});
  RunBatch(queue, "kept", 3, {"own"});
  RunAlone(queue, "job-1", {"shared"});
  // Wherever it is just then.
  std::thread deletion([&] { Delete(queue, "b1"); });
  form_->servers()->Kill(0);
  deletion.join();
  EXPECT_TRUE(queue.WaitUntil([&] { return queue->FinishDeletions(*artifacts_).ok(); }));
  EXPECT_TRUE(absl::IsNotFound(queue->GetBatch("b1").status()));
  EXPECT_TRUE(absl::IsNotFound(artifacts_->Get(IdOf("own-of-b1-00000007")).status()));
  ExpectWhole(queue, "kept", 3);
  EXPECT_EQ(queue->GetJob("job-1")->state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_TRUE(artifacts_->Get(IdOf("shared")).ok());
}

}  // namespace
}  // namespace flair::testing
