// SPDX-License-Identifier: GPL-3.0-or-later
// Flair's own programs keep every promise of their stages: the checks of `flair contract`, one test for each.
#include <gtest/gtest.h>

#include <cctype>

#include "tests/contract/servers.h"

namespace flair::testing {
namespace {

struct Case {
  const contract::Stage* stage;
  contract::Check check;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.stage->name << ": " << c.check.name; }

std::vector<Case> AllCases() {
  std::vector<Case> cases;
  for (const contract::Stage& stage : contract::AllStages()) {
    for (contract::Check& check : contract::ChecksOf(stage)) cases.push_back({&stage, std::move(check)});
  }
  return cases;
}

// "optimizer: Solve refuses no objects" as OptimizerSolveRefusesNoObjects.
std::string NameOf(const ::testing::TestParamInfo<Case>& info) {
  std::string name;
  bool begins = true;
  for (const char c : info.param.stage->name + std::string(" ") + info.param.check.name) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      name += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
      begins = false;
    } else {
      begins = true;
    }
  }
  return name;
}

class OwnPrograms : public ::testing::TestWithParam<Case> {
 protected:
  // One of each stage for all tests of this process.
  static contract::Target& TargetOf(const contract::Stage& stage) {
    if (stage_ != &stage) {
      target_.reset();
      program_ = std::make_unique<StageProgram>(stage);
      target_ = ConnectTo(stage, program_->address());
      stage_ = &stage;
    }
    return *target_;
  }
  static void TearDownTestSuite() {
    target_.reset();
    program_.reset();
    stage_ = nullptr;
  }

 private:
  static inline const contract::Stage* stage_ = nullptr;
  static inline std::unique_ptr<StageProgram> program_;
  static inline std::unique_ptr<contract::Target> target_;
};

// They claim all there is to claim: nothing is skipped.
TEST_P(OwnPrograms, Keep) {
  const contract::Finding finding = contract::RunCheck(GetParam().check, TargetOf(*GetParam().stage));
  EXPECT_EQ(finding.verdict, contract::Verdict::kKept) << FindingText(finding);
}

INSTANTIATE_TEST_SUITE_P(Contract, OwnPrograms, ::testing::ValuesIn(AllCases()), NameOf);

}  // namespace
}  // namespace flair::testing
