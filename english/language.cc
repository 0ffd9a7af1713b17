// SPDX-License-Identifier: GPL-3.0-or-later
#include "english/language.h"

#include <google/protobuf/io/tokenizer.h>
#include <google/protobuf/text_format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <utility>

#include "absl/strings/str_join.h"
#include "fmt/format.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::english {
namespace {

namespace fs = std::filesystem;

// Collects what the parser finds, as "file:line:column: message".
class Faults : public google::protobuf::io::ErrorCollector {
 public:
  Faults(std::string file, std::vector<std::string>& lines) : file_(std::move(file)), lines_(lines) {}
  void AddError(int line, int column, const std::string& message) override {
    lines_.push_back(fmt::format("{}:{}:{}: {}", file_, line + 1, column + 1, message));
  }

 private:
  std::string file_;
  std::vector<std::string>& lines_;
};

// What the parser cannot check: fields that must be set.
void Check(const v1::Language& data, std::vector<std::string>& faults) {
  for (const v1::Unit& unit : data.units()) {
    if (unit.kind() == v1::Unit::KIND_UNSPECIFIED || unit.size() <= 0 || unit.words().empty())
      faults.push_back(
          fmt::format("units: {} needs words, a kind and a size above 0", absl::StrJoin(unit.words(), ", ")));
  }
  for (const v1::Bound& bound : data.bounds()) {
    if (bound.kind() == v1::Bound::KIND_UNSPECIFIED) faults.emplace_back("bounds: each needs a kind");
  }
  for (const v1::Frame& frame : data.frames()) {
    if (frame.meaning().empty() || frame.forms().empty()) faults.emplace_back("frames: each needs a meaning and forms");
  }
  for (const v1::Phrases& phrases : data.phrases()) {
    if (phrases.word_class() == v1::WORD_CLASS_UNSPECIFIED || phrases.phrases().empty())
      faults.push_back(fmt::format("phrases: \"{}\" needs a word_class and phrases", phrases.lemma()));
  }
}

absl::StatusOr<std::vector<fs::path>> FilesOf(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> files;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (it->path().extension() == ".textproto") files.push_back(it->path());
  }
  if (error) return NotFound("language folder {}: {}", folder.string(), error.message());
  if (files.empty()) {
    return NotFound("language folder {} has no *.textproto files", folder.string());
  }
  std::ranges::sort(files);
  return files;
}

absl::StatusOr<std::unique_ptr<const Language>> LoadInstalled() {
  return Language::Load(runtime::InstalledFolder("english", FLAIR_ENGLISH_FOLDER));
}

const absl::StatusOr<std::unique_ptr<const Language>>& Installed() {
  static const auto* const installed = new absl::StatusOr<std::unique_ptr<const Language>>(LoadInstalled());
  return *installed;
}

template <typename Map>
std::string_view ValueIn(const Map& map, std::string_view key) {
  const auto found = map.find(key);
  return found == map.end() ? std::string_view() : std::string_view(found->second);
}

}  // namespace

absl::StatusOr<std::unique_ptr<const Language>> Language::Load(const fs::path& folder) {
  ASSIGN_OR_RETURN(const std::vector<fs::path> files, FilesOf(folder));
  v1::Language merged;
  std::vector<std::string> faults;
  for (const fs::path& file : files) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    if (!stream) return Unavailable("cannot read {}", file.string());
    Faults collector(file.filename().string(), faults);
    google::protobuf::TextFormat::Parser parser;
    parser.RecordErrorsTo(&collector);
    v1::Language part;
    if (parser.ParseFromString(text.str(), &part)) merged.MergeFrom(part);
  }
  Check(merged, faults);
  if (!faults.empty()) {
    return InvalidArgument("language folder {}:\n  {}", folder.string(), absl::StrJoin(faults, "\n  "));
  }
  return std::make_unique<const Language>(std::move(merged));
}

absl::Status Language::CheckInstalled() { return Installed().status(); }

const Language& Language::Get() {
  const auto& installed = Installed();
  if (!installed.ok()) {
    std::fprintf(stderr, "%s\n", std::string(installed.status().message()).c_str());
    std::abort();
  }
  return **installed;
}

Language::Language(v1::Language data) : data_(std::move(data)) {
  for (const v1::Contraction& one : data_.contractions()) {
    if (one.written().starts_with('-')) {
      endings_.push_back(&one);
    } else {
      contractions_[one.written()] = one.meant();
    }
  }
  for (const v1::NumberWord& number : data_.numbers()) numbers_[number.word()] = &number;
  for (const v1::Unit& unit : data_.units()) {
    for (const std::string& word : unit.words()) units_[word] = &unit;
  }
  for (const v1::Noun& noun : data_.nouns()) {
    singulars_[noun.plural()] = noun.singular();
    plurals_.try_emplace(noun.singular(), noun.plural());  // the first one, where a word has two
  }
  for (const v1::Spelling& spelling : data_.spellings()) {
    for (const std::string& other : spelling.others()) spellings_[other] = spelling.british();
  }
  for (const v1::WordList& list : data_.lists()) lists_[list.name()].insert(list.words().begin(), list.words().end());
}

FoundContraction Language::FindContraction(std::string_view word) const {
  if (const std::string_view meant = ValueIn(contractions_, word); !meant.empty()) return {meant, 0};
  if (word.find('\'') == std::string_view::npos) return {};
  for (const v1::Contraction* const ending : endings_) {
    const std::string_view letters = std::string_view(ending->written()).substr(1);
    if (word.size() > letters.size() && word.ends_with(letters)) return {ending->meant(), word.size() - letters.size()};
  }
  return {};
}

const v1::NumberWord* Language::FindNumber(std::string_view word) const {
  const auto found = numbers_.find(word);
  return found == numbers_.end() ? nullptr : found->second;
}

const v1::Unit* Language::FindUnit(std::string_view word) const {
  const auto found = units_.find(word);
  return found == units_.end() ? nullptr : found->second;
}

bool Language::IsIn(std::string_view list, std::string_view word) const {
  const auto found = lists_.find(list);
  return found != lists_.end() && found->second.contains(word);
}

std::string_view Language::IrregularSingular(std::string_view plural) const { return ValueIn(singulars_, plural); }

std::string_view Language::IrregularPlural(std::string_view singular) const { return ValueIn(plurals_, singular); }

std::string_view Language::BritishSpelling(std::string_view word) const { return ValueIn(spellings_, word); }

}  // namespace flair::english
