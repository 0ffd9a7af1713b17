// SPDX-License-Identifier: GPL-3.0-or-later
// What is fuzzed. Each target takes any bytes and returns; it aborts with a message when a promise is broken. The same
// functions run under libFuzzer (fuzz_main.cc) and, over the corpus, in every run of the tests (corpus_test.cc).
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace flair::fuzz {

// An artifact or graph, as binary, JSON or text message: parsed, validated, and made a scene when it is good.
void ReadGraph(std::string_view bytes);

// The bytes as choices that make a small problem, mostly good: solved with tight limits. See random_problem.cc for what
// must hold of the result.
void SolveProblem(std::string_view bytes);

// Edits of a solved layout. Bytes that begin with "text" and a line break are lines as `flair resolve --edit` reads
// them; any others are choices that make edits and, at times, spoil the layout. See edit_layout.cc for what must hold.
void EditLayout(std::string_view bytes);

// The short text form of scenes.
void ReadSceneText(std::string_view bytes);

// What a model may send: the first byte chooses among the types of answers and a recorded answer, and the unit that its
// lengths are read in; the rest is its text.
void ReadModelAnswer(std::string_view bytes);

// A reply of the chat protocol, streamed or not: the first byte says in which pieces it comes, the rest is its body.
void ReadReply(std::string_view bytes);

// A step of the language or translation phase, chosen by the first byte, whose model answers with the rest; after a
// line
// "=====" with what follows to the request to repair. See model_step.cc for what must hold.
void ModelStep(std::string_view bytes);

// An artifact's file, read as binary, JSON and text message: refused in words, or written in each of them and read
// again.
void ReadArtifact(std::string_view bytes);

// A path to a part of an artifact.
void SelectField(std::string_view bytes);

// A 3D model that a user brings, as GLB. See read_asset.cc for what must hold.
void ReadAsset(std::string_view bytes);

// A manifest of models.
void ReadManifest(std::string_view bytes);

// A request to the studio, head and body. See studio_request.cc for what must hold.
void StudioRequest(std::string_view bytes);

// Aborts with `promise` unless it holds.
inline void Require(bool holds, std::string_view promise) {
  if (holds) return;
  std::fprintf(stderr, "broken promise: %.*s\n", static_cast<int>(promise.size()), promise.data());
  std::abort();
}

}  // namespace flair::fuzz
