// SPDX-License-Identifier: GPL-3.0-or-later
// A test that is put to every form of the queue.
#pragma once

#include <google/protobuf/util/time_util.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <memory>

#include "tests/contract/queue/queue_forms.h"
#include "tests/contract/queue/watched_queue.h"
#include "tests/fixtures/programs.h"

namespace flair::testing {

class QueueTest : public ::testing::TestWithParam<NamedForm> {
 protected:
  // One more process's view.
  WatchedQueue Open() {
    auto queue = form_->Open();
    EXPECT_TRUE(queue.ok()) << queue.status();
    return WatchedQueue(queue.ok() ? *std::move(queue) : nullptr);
  }
  const std::unique_ptr<QueueForm> form_ = GetParam().make();
};

#define FLAIR_EVERY_FORM(suite)                                                        \
  INSTANTIATE_TEST_SUITE_P(, suite, ::testing::Values(FolderForm(), JetStreamForm(1)), \
                           [](const ::testing::TestParamInfo<NamedForm>& form) { return form.param.name; })

}  // namespace flair::testing
