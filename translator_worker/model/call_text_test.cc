// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "fmt/format.h"
#include "gtest/gtest.h"
#include "translator_worker/model/prompt_texts.h"

namespace flair::translator {
namespace {

// What was read, in one form for all.
std::string Read(std::string_view text) {
  const absl::StatusOr<WrittenCalls> read = ReadCallText(text);
  if (!read.ok()) return "error: " + std::string(read.status().message());
  std::string said;
  for (const WrittenCall& call : read->calls) {
    said += call.function + "(";
    for (const WrittenArgument& argument : call.arguments) {
      if (!argument.name.empty()) said += argument.name + "=";
      said += argument.in_brackets ? fmt::format("[{}]", fmt::join(argument.values, "|")) : argument.values.at(0);
      said += ";";
    }
    said += ")";
  }
  if (read->none) said += "none:" + read->why;
  return said;
}

TEST(CallText, ReadsTheNotationOfThePrompt) {
  EXPECT_EQ(Read("near(desk, bookshelf, max_distance_m=1)"), "near(desk;bookshelf;max_distance_m=1;)");
  EXPECT_EQ(Read("surround(table, [chair_1, chair_2])"), "surround(table;[chair_1|chair_2];)");
  EXPECT_EQ(Read("ceiling_center()"), "ceiling_center()");
}

struct Deviation {
  const char* text;
  const char* read;
};

TEST(CallText, ReadsWhatModelsWriteInItsStead) {
  for (const Deviation& deviation : {
           Deviation{" Near ( desk ,bookshelf ) ; ", "Near(desk;bookshelf;)"},
           Deviation{"`near(desk, shelf)`", "near(desk;shelf;)"},
           Deviation{"- near(desk, shelf).", "near(desk;shelf;)"},
           Deviation{"near(desk, shelf", "near(desk;shelf;)"},
           Deviation{"near(object=\"desk\", target='shelf')", "near(object=desk;target=shelf;)"},
           Deviation{"near(\"object\": \"desk\", target: shelf)", "near(object=desk;target=shelf;)"},
           Deviation{"row([\"a\",\"b\"])", "row([a|b];)"},
           Deviation{"row(objects={a; b})", "row(objects=[a|b];)"},
           Deviation{"row((a, b))", "row([a|b];)"},
           Deviation{"row(objects=[a, b)", "row(objects=[a|b];)"},
           Deviation{"near(the bed's end, shelf)", "near(the bed's end;shelf;)"},
           Deviation{"near('a, b', c)", "near(a, b;c;)"},
           Deviation{"near(a, b); near(a, c)", "near(a;b;)near(a;c;)"},
           Deviation{"near(a, b), facing(a, b)  # both", "near(a;b;)facing(a;b;)"},
           Deviation{"near(a, b), none(no light)", "near(a;b;)none:no light"},
       }) {
    EXPECT_EQ(Read(deviation.text), deviation.read) << deviation.text;
  }
}

TEST(CallText, ReadsNoCallInAnyOfItsForms) {
  for (const char* text :
       {"none(about light)", "None: about light", "NONE - about light", "none('about light')", "null (about light)"}) {
    EXPECT_EQ(Read(text), "none:about light") << text;
  }
  for (const char* text : {"", "none", "none()", "null", "  "}) EXPECT_EQ(Read(text), "none:") << text;
}

TEST(CallText, SaysWhatIsNoCall) {
  for (const char* text : {"the bed stands at a wall", "near", "(a, b)", "near(a, b) which is right",
                           "{\"function\":\"near\"}", "n/a", "[[[[", "42", "\xff\xfe"}) {
    EXPECT_TRUE(Read(text).starts_with("error: ")) << text << ": " << Read(text);
  }
  EXPECT_EQ(Read("near"), "error: \"near\" is no call; one such as near(sofa, shelf) or none(why) would be right");
}

TEST(CallText, TakesAnyTextInTimeInProportion) {
  for (const char* part : {"(", "[", "'", "near(", "a,", "=", "{\"a\":", "near(a,b);", "\\\"", "“", ")"}) {
    std::string text;
    while (text.size() < 2000) text += part;
    const absl::StatusOr<WrittenCalls> read = ReadCallText(text);
    if (read.ok()) EXPECT_LE(read->calls.size(), 40U);
  }
}

}  // namespace
}  // namespace flair::translator
