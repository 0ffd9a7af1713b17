// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/command_line.h"

#include <memory>
#include <optional>

#include "gmock/gmock.h"
#include "gtest/gtest.h"

namespace flair::cli {
namespace {

using ::testing::HasSubstr;

class HelpTextTest : public ::testing::Test {
 protected:
  HelpTextTest() { program_.formatter(std::make_shared<HelpText>(60)); }

  CLI::App program_{"Draws houses.", "draw"};
  std::string text_;
  std::vector<std::string> texts_;
  bool flag_ = false;
};

TEST_F(HelpTextTest, NamesInTheUsageWhatIsNeeded) {
  program_.add_option("HOUSE", text_, "What is drawn")->required();
  program_.add_option("MORE", texts_, "And these");
  program_.add_option("-o,--out", text_, "Where it goes")->required()->type_name("FILE");
  program_.add_option("--size", text_, "In pixels (800)")->type_name("PX");
  EXPECT_EQ(program_.help(),
            "Draws houses.\n\n"
            "Usage: draw HOUSE [MORE...] --out FILE [OPTIONS]\n\n"
            "Arguments:\n"
            "  HOUSE                   What is drawn\n"
            "  MORE                    And these\n\n"
            "Options:\n"
            "  -h, --help              Print this help message and exit\n"
            "  -o, --out FILE          Where it goes\n"
            "  --size PX               In pixels (800)\n");
}

TEST_F(HelpTextTest, SaysWhichOptionsGoTogether) {
  CLI::Option* json = program_.add_flag("--json", flag_, "As JSON");
  CLI::Option* list = program_.add_flag("--list", flag_, "All of them");
  program_.add_flag("--quiet", flag_, "Say nothing")->excludes(json)->excludes(list);
  program_.add_option("--count", text_, "How many")->type_name("N")->needs(list)->envname("DRAW_COUNT");
  EXPECT_THAT(program_.help(), HasSubstr("As JSON; not with --quiet\n"));
  EXPECT_THAT(program_.help(), HasSubstr("Say nothing; not with --json or\n" + std::string(26, ' ') + "--list\n"));
  EXPECT_THAT(program_.help(),
              HasSubstr("How many; otherwise $DRAW_COUNT;\n" + std::string(26, ' ') + "only with --list\n"));
}

TEST_F(HelpTextTest, LetsTheFooterFlowButForWhatIsIndented) {
  program_.footer("Lines that\nare broken in the source flow again, as wide as it is.\n  draw   --this\n\nEnd.");
  EXPECT_THAT(program_.help(), HasSubstr("\nLines that are broken in the source flow again, as wide as\nit is.\n"
                                         "  draw   --this\n\nEnd.\n"));
}

TEST_F(HelpTextTest, ListsCommandsByGroupBeforeTheOptions) {
  program_.require_subcommand(1);
  program_.add_subcommand("house", "Draw a house.")->group("Houses");
  program_.add_subcommand("tree", "Draw a tree.")->group("Trees");
  EXPECT_THAT(program_.help(), HasSubstr("Usage: draw COMMAND ...\n\nHouses:\n  house                   Draw a house.\n"
                                         "\nTrees:\n  tree                    Draw a tree.\n\nOptions:\n"));
}

}  // namespace
}  // namespace flair::cli
