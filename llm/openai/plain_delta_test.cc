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
  EXPECT_EQ(PlainDelta(kOpenAi), R"(" b\"e}d")");
  EXPECT_EQ(PlainDelta(R"( { "choices" : [ { "delta" : { "role" : "assistant", "content" : "a" } } ] } )"), R"("a")");
  EXPECT_EQ(PlainDelta(R"({"choices":[{"delta":{"content":"","refusal":null}}]})"), R"("")");
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
      EXPECT_EQ(json::parse(*delta, nullptr, false), object["choices"][0]["delta"]["content"]) << chunk;
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
