// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences to calls, without a model.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "english/frames/facts.h"
#include "flair/v1/constraint_list.pb.h"
#include "flair/v1/translator_service.pb.h"
#include "translator_worker/catalog/catalog_source.h"
#include "translator_worker/grammar/call.h"
#include "translator_worker/grammar/scene_names.h"

namespace flair::translator {

// A sentence as messages show it: control characters as spaces, at most 160 bytes, cut between characters.
inline std::string Quote(std::string_view text) {
  constexpr size_t kLongest = 160;
  size_t length = text.size();
  if (length > kLongest) {
    length = kLongest;
    while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80) --length;
  }
  std::string result;
  for (const char c : text.substr(0, length))
    result.push_back(static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? ' ' : c);
  return length < text.size() ? result + "..." : result;
}

// What became of a sentence: calls, or remarks that say why there are none, or both.
struct Translation {
  std::vector<Call> calls;
  std::vector<v1::Diagnostic> diagnostics;
  // Factor of the sentence's weight: a half for wishes ("ideally").
  double weight_factor = 1;
};

// Translates one sentence. Reads it from left to right: at each term the rule that covers most is taken; what no rule
// covers is left over. Linear in the length of the sentence. Never without calls and without diagnostics.
Translation TranslateSentence(const v1::TranslateRequest& request, const SceneNames& names, const CatalogIndex& catalog,
                              const v1::Sentence& sentence);

// A remark on a sentence, which it quotes.
v1::Diagnostic RemarkOn(const v1::Sentence& sentence, v1::Severity severity, std::string_view code,
                        const std::string& message);

// The graph of a request whose sentences became that, by their ids; takes the calls out of `translations`.
v1::LayoutGraph GraphOf(const v1::TranslateRequest& request, std::map<std::string, Translation> translations);

// Translates every sentence of a request whose catalogue is set. The request must have been validated.
v1::LayoutGraph Translate(const v1::TranslateRequest& request);

// The facts that the sentence's typed meaning states, their objects by index of the request's list; none when it has no
// meaning, or one of another text. An error says what of the meaning cannot be used: a relation that no frame knows, or
// knows only with other participants, or something that is not in the room.
absl::StatusOr<std::vector<english::Fact>> TypedFacts(const v1::TranslateRequest& request,
                                                      const v1::Sentence& sentence);

}  // namespace flair::translator
