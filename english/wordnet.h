// SPDX-License-Identifier: GPL-3.0-or-later
// What words mean: nouns, their senses and what each of them is a kind of, from WordNet 3.0 (Princeton University) as
// Debian's package wordnet-base installs it. Words are lower case, parts of a compound with one space between them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace flair::english {

// Large fields of meaning, by the number of WordNet's lexicographer file.
enum class Domain : std::uint8_t {
  kOther = 0,
  kArtifact = 6,
  kCommunication = 10,
  kFood = 13,
  kGroup = 14,
  kNaturalObject = 17,
  kPerson = 18,
  kPlant = 20,
  kSubstance = 27,
  kTime = 28,
};

// One meaning of a noun.
struct NounSense {
  std::uint32_t id = 0;
  Domain domain = Domain::kOther;
};

// A meaning that another one is a kind of, and how many steps lie between.
struct Kind {
  std::uint32_t id = 0;
  int steps = 0;
};

// Immutable and thread-safe. A look-up searches the mapped files: some microseconds, nothing is held in memory.
class WordNet {
 public:
  // Maps the files of a folder. NOT_FOUND, with the package's name, where they are missing.
  static absl::StatusOr<std::unique_ptr<const WordNet>> Open(const std::filesystem::path& folder);

  // That of the machine, opened on first use. Programs call CheckInstalled when they start: without the files this ends
  // the program.
  static const WordNet& Get();
  static absl::Status CheckInstalled();

  ~WordNet();
  WordNet(const WordNet&) = delete;
  WordNet& operator=(const WordNet&) = delete;

  // The senses of a noun in the singular or plural, the most frequent first; none where it is no noun.
  std::vector<NounSense> SensesOf(std::string_view noun) const;

  // The sense that a text names: "seat#3" the third of "seat", "table" the first.
  std::optional<NounSense> Find(std::string_view text) const;

  // The sense itself and all that it is a kind of, nearest first.
  std::vector<Kind> KindsOf(const NounSense& sense) const;

  bool IsAdjective(std::string_view word) const;
  bool IsVerb(std::string_view word) const;
  // Whether it is a word of any part of speech, in whatever form.
  bool Knows(std::string_view word) const;

 private:
  class MappedFile;
  struct Files;

  explicit WordNet(std::unique_ptr<const Files> files);

  std::unique_ptr<const Files> files_;
};

}  // namespace flair::english
