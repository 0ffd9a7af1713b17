// SPDX-License-Identifier: GPL-3.0-or-later
// The data of a language (protos/flair/english/v1/language.proto), ready to look up. Programs use it through text.h,
// quantities.h, words.h and lexicon.h.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/english/v1/language.pb.h"

namespace flair::english {

// A part of a word that is a word of its own: of "doesn't" the first 4 letters are kept, the rest means "not".
struct FoundContraction {
  std::string_view meant;  // empty when the word is none
  size_t kept = 0;
};

// Immutable and thread-safe.
class Language {
 public:
  // Reads all *.textproto files of a folder. NOT_FOUND when it has none, INVALID_ARGUMENT with file, line and column
  // for every fault in them.
  static absl::StatusOr<std::unique_ptr<const Language>> Load(const std::filesystem::path& folder);

  // English, from share/flair/english beside the program's folder when it is installed, else from the source tree. Read
  // on first use. Programs call CheckInstalled when they start: without the data this ends the program.
  static const Language& Get();
  static absl::Status CheckInstalled();

  explicit Language(v1::Language data);

  const v1::Language& data() const { return data_; }

  FoundContraction FindContraction(std::string_view word) const;
  // Null for other words.
  const v1::NumberWord* FindNumber(std::string_view word) const;
  const v1::Unit* FindUnit(std::string_view word) const;
  // Whether the list of that name has the word.
  bool IsIn(std::string_view list, std::string_view word) const;
  // The other form of a noun, when no rule tells it; empty otherwise.
  std::string_view IrregularSingular(std::string_view plural) const;
  std::string_view IrregularPlural(std::string_view singular) const;
  // The British spelling of a word that has another; empty otherwise.
  std::string_view BritishSpelling(std::string_view word) const;

 private:
  struct Hash : std::hash<std::string_view> {
    using is_transparent = void;
  };
  template <typename Value>
  using Map = std::unordered_map<std::string, Value, Hash, std::equal_to<>>;

  const v1::Language data_;
  Map<std::string> contractions_;
  std::vector<const v1::Contraction*> endings_;
  Map<const v1::NumberWord*> numbers_;
  Map<const v1::Unit*> units_;
  Map<std::string> singulars_;
  Map<std::string> plurals_;
  Map<std::string> spellings_;
  Map<std::unordered_set<std::string, Hash, std::equal_to<>>> lists_;
};

}  // namespace flair::english
