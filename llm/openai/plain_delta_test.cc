// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/openai/plain_delta.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace flair::llm {
namespace {

using nlohmann::json;

constexpr char kOpenAi[] =
    R"({"id":"c-1","object":"chat.completion.chunk","created":1,"model":"m","system_fingerprint":null,)"
    R"("choices":[{"index":0,"delta":{"content":" b\"e}d"},"logprobs":null,"finish_reason":null}],"usage":null})";

TEST(PlainDelta, FindsThePieceOfText) {
  EXPECT_EQ(PlainDelta(kOpenAi), DeltaPiece(R"(" b\"e}d")"));
  EXPECT_EQ(PlainDelta(R"( { "choices" : [ { "delta" : { "role" : "assistant", "content" : "a" } } ] } )"),
            DeltaPiece(R"("a")"));
  EXPECT_EQ(PlainDelta(R"({"choices":[{"delta":{"content":"","refusal":null}}]})"), DeltaPiece(R"("")"));
  EXPECT_EQ(PlainDelta(R"({"choices":[{"delta":{"content":"a","reasoning":""}}]})"), DeltaPiece(R"("a")"));
}

TEST(PlainDelta, FindsThePieceOfThought) {
  const DeltaPiece thought(R"("hm")", true);
  for (const char* delta :
       {R"({"reasoning_content":"hm"})", R"({"reasoning":"hm","content":null})",
        R"({"reasoning_content":null,"reasoning":"hm"})", R"({"reasoning_content":"hm","reasoning":""})",
        R"({"content":"","reasoning":"hm"})",
        R"({"role":"assistant","content":"","reasoning":"hm","reasoning_details":[{"text":"hm","index":0}]})"}) {
    EXPECT_EQ(PlainDelta(R"({"choices":[{"index":0,"delta":)" + std::string(delta) + "}]}"), thought) << delta;
  }
  // The same under two names, or both at once: which counts is the parser's to say.
  for (const char* delta :
       {R"({"reasoning_content":"hm","reasoning":"hm"})", R"({"content":"a","reasoning":"hm"})",
        R"({"reasoning":["hm"]})", R"({"content":"a","content":null})", R"({"reasoning_details":[]})"}) {
    EXPECT_EQ(PlainDelta(R"({"choices":[{"index":0,"delta":)" + std::string(delta) + "}]}"), std::nullopt) << delta;
  }
}

TEST(PlainDelta, LeavesChunksWithAnythingElseToTheParser) {
  for (const char* chunk : {R"({"choices":[{"index":0,"delta":{"content":"a"},"finish_reason":"stop"}]})",
                            R"({"choices":[{"index":1,"delta":{"content":"a"}}]})",
                            R"({"choices":[{"index":0,"delta":{"content":"a","refusal":"no"}}]})",
                            R"({"choices":[{"index":0,"delta":{"content":"a","tool_calls":[]}}]})",
                            R"({"choices":[{"index":0,"delta":{"content":null}}]})",
                            R"({"choices":[{"index":0,"delta":{"content":"a"}},{"index":1,"delta":{"content":"b"}}]})",
                            R"({"choices":[{"index":0,"delta":{"content":"a"}}],"usage":{"prompt_tokens":1}})",
                            R"({"choices":[{"index":0,"delta":{"content":"a"}}],"error":{"message":"m"}})",
                            R"({"choices":[],"usage":{}})", R"({"choices":{}})", "[]", "", "{", "7", R"("a")"}) {
    EXPECT_EQ(PlainDelta(chunk), std::nullopt) << chunk;
  }
}

TEST(PlainDelta, AChunkThatIsCutOffIsNone) {
  const std::string chunk = kOpenAi;
  for (size_t size = 0; size < chunk.size(); ++size) EXPECT_EQ(PlainDelta(chunk.substr(0, size)), std::nullopt) << size;
}

// Whatever byte is changed: what it finds in valid JSON is what the parser finds.
TEST(PlainDelta, NeverDiffersFromTheParser) {
  int found_count = 0;
  for (size_t at = 0; at < sizeof(kOpenAi) - 1; ++at) {
    for (const char c : std::string(R"({}[]",:\0 an)")) {
      std::string chunk = kOpenAi;
      chunk[at] = c;
      const json object = json::parse(chunk, nullptr, false);
      const auto delta = PlainDelta(chunk);
      if (object.is_discarded() || !delta.has_value()) continue;
      ++found_count;
      EXPECT_EQ(json::parse(delta->string, nullptr, false), object["choices"][0]["delta"]["content"]) << chunk;
    }
  }
  EXPECT_GT(found_count, 100);
}

TEST(PlainText, IsOnlyWhatNeedsNoDecoding) {
  EXPECT_EQ(PlainText(R"("")"), "");
  EXPECT_EQ(PlainText(R"(" a~")"), " a~");
  EXPECT_EQ(PlainText(R"("a\n")"), std::nullopt);
  EXPECT_EQ(PlainText("\"ü\""), std::nullopt);
  EXPECT_EQ(PlainText("\"a\nb\""), std::nullopt);
}

RepeatedDelta Learnt() {
  const std::string chunk = R"({"id":"c-1","choices":[{"index":0,"delta":{"content":"ab"},"finish_reason":null}]})";
  RepeatedDelta repeated;
  repeated.Learn(chunk, PlainDelta(chunk).value());
  return repeated;
}

TEST(RepeatedDelta, FindsTheTextOfAChunkThatDiffersInNothingElse) {
  const RepeatedDelta repeated = Learnt();
  for (const std::string text : {"ab", "", " x", "{}[]:,"}) {
    const std::string chunk =
        R"({"id":"c-1","choices":[{"index":0,"delta":{"content":")" + text + R"("},"finish_reason":null}]})";
    EXPECT_EQ(repeated.Text(chunk), text);
  }
}

TEST(RepeatedDelta, TellsThoughtsFromAnswers) {
  EXPECT_FALSE(Learnt().thought());
  const std::string chunk = R"({"choices":[{"delta":{"content":"","reasoning":"a"}}]})";
  RepeatedDelta repeated;
  repeated.Learn(chunk, PlainDelta(chunk).value());
  EXPECT_EQ(repeated.Text(R"({"choices":[{"delta":{"content":"","reasoning":"bc"}}]})"), "bc");
  EXPECT_TRUE(repeated.thought());
}

TEST(RepeatedDelta, AnEmptyThoughtIsReadAsPlainDeltaReadsIt) {
  const std::string begin = R"({"choices":[{"delta":{"reasoning_content":")", end = R"("}}]})";
  RepeatedDelta repeated;
  const std::string first = begin + "hm" + end, second = begin + end;
  repeated.Learn(first, *PlainDelta(first));
  EXPECT_EQ(repeated.Text(second), "");
  EXPECT_EQ(PlainDelta(second), DeltaPiece(R"("")", true));
}

TEST(RepeatedDelta, LeavesAnythingElseToPlainDelta) {
  const RepeatedDelta repeated = Learnt();
  for (const char* chunk :
       {R"({"id":"c-2","choices":[{"index":0,"delta":{"content":"ab"},"finish_reason":null}]})",
        R"({"id":"c-1","choices":[{"index":0,"delta":{"content":"ab"},"finish_reason":"stop"}]})",
        R"({"id":"c-1","choices":[{"index":0,"delta":{"content":"a\nb"},"finish_reason":null}]})",
        R"({"id":"c-1","choices":[{"index":0,"delta":{"content":"a","refusal":"b"},"finish_reason":null}]})",
        R"({"id":"c-1","choices":[{"index":0,"delta":{"content":"ü"},"finish_reason":null}]})",
        R"({"id":"c-1","choices":[{"index":0,"delta":{"content":"},"finish_reason":null}]})", ""}) {
    EXPECT_EQ(repeated.Text(chunk), std::nullopt) << chunk;
  }
  EXPECT_EQ(RepeatedDelta().Text(""), std::nullopt);
}

}  // namespace
}  // namespace flair::llm
