// SPDX-License-Identifier: GPL-3.0-or-later
// What the processes of a queue tell each other at once: hints on what to look at, never the thing itself. They may be
// lost, so everybody also looks now and then.
#pragma once

#include <string>
#include <string_view>

namespace flair::orchestrator {

enum class NewsKind {
  // There is something to take under a subject of the queue stream.
  kWork,
  // Something happened to a job (and, when it ended, to its batch, named second).
  kJob,
  // The same, and who runs it should look whether it still does.
  kHold,
  // A batch was paused, resumed, cancelled or got jobs.
  kBatch,
  // Not understood: look at everything.
  kUnknown,
};

struct News {
  NewsKind kind = NewsKind::kUnknown;
  std::string subject;
  std::string batch_id;
};

std::string WriteNews(const News& news);
News ReadNews(std::string_view text);

}  // namespace flair::orchestrator
