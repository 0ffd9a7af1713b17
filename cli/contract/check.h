// SPDX-License-Identifier: GPL-3.0-or-later
// One promise of a contract, put to a server: what is asked of it, and what came of that.
#pragma once

#include <functional>
#include <string>
#include <utility>

#include "flair/v1/worker_service.pb.h"

namespace flair::contract {

class Target;

// What a check belongs to, in the order of reports.
enum class Promise {
  kProtocol,    // the server is there and speaks this protocol
  kMessages,    // answers are valid and complete
  kUnits,       // metres, radians counter-clockwise, north up
  kErrors,      // bad input gets the right status, which names the field
  kCatalogue,   // the catalogue is complete and true
  kRepetition,  // repeats are harmless, and equal where that is claimed
  kCallers,     // deadlines, cancels, many callers at once
  kSize,        // messages up to a size, and no larger
};

// One word or two for reports, such as "deadlines".
const char* PromiseName(Promise promise);

enum class Verdict { kKept, kBroken, kSkipped };

// How a check came out.
struct Finding {
  Verdict verdict = Verdict::kKept;
  // Broken: what was sent, what came back and what would be right, for whoever writes the server.
  std::string sent = {};
  std::string got = {};
  std::string right = {};
  // Skipped: why.
  std::string reason = {};
};

inline Finding Kept() { return {}; }
inline Finding Broken(std::string sent, std::string got, std::string right) {
  return {.verdict = Verdict::kBroken, .sent = std::move(sent), .got = std::move(got), .right = std::move(right)};
}
inline Finding Skipped(std::string reason) { return {.verdict = Verdict::kSkipped, .reason = std::move(reason)}; }

struct Check {
  // What holds when it is kept, as a sentence without full stop: "A width that is no number is refused". Unique in its
  // stage.
  std::string name;
  Promise promise = Promise::kMessages;
  // Must not hang: every call goes through the target, which has a deadline for each. May be called again.
  std::function<Finding(Target&)> run;
  // Of servers that claim this only; UNSPECIFIED: of every server of the stage.
  v1::Capability capability = v1::CAPABILITY_UNSPECIFIED;
  // When it is broken, no further question makes sense.
  bool decisive = false;
};

}  // namespace flair::contract
