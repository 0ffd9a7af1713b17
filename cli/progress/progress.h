// SPDX-License-Identifier: GPL-3.0-or-later
// What a command shows while a job runs.
#pragma once

#include <memory>

#include "flair/v1/job.pb.h"

namespace flair::cli {

class Progress {
 public:
  virtual ~Progress() = default;
  virtual void See(const v1::JobEvent& event) = 0;
};

enum class ProgressForm {
  kTerminal,   // a line per finished stage, and what runs now
  kLines,      // a line per finished stage
  kJsonLines,  // every event as JSON on standard output
  kQuiet,
};

// The form for a command: as asked, else by whether standard error is a terminal.
ProgressForm ChooseProgressForm(bool json, bool quiet);

std::unique_ptr<Progress> MakeProgress(ProgressForm form);

}  // namespace flair::cli
