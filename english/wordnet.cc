// SPDX-License-Identifier: GPL-3.0-or-later
#include "english/wordnet.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/interprocess/file_mapping.hpp>
#include <boost/interprocess/mapped_region.hpp>
#include <charconv>
#include <cstdlib>
#include <string>
#include <utility>

#include "english/words.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::english {
namespace {

constexpr const char* kFolder = "/usr/share/wordnet";

constexpr std::size_t kLongest = 80;  // of its compounds

}  // namespace

// A file of WordNet (man wndb): lines of fields with a space between them; those of an index begin with the lemma, in
// the order of its bytes, those of data are found by their offset.
class WordNet::MappedFile {
 public:
  explicit MappedFile(const std::filesystem::path& path)
      : file_(path.c_str(), boost::interprocess::read_only), region_(file_, boost::interprocess::read_only) {}

  std::string_view text() const { return {static_cast<const char*>(region_.get_address()), region_.get_size()}; }

  std::string_view LineAt(std::size_t offset) const {
    if (offset >= text().size()) return {};
    return text().substr(offset, text().find('\n', offset) - offset);
  }

  // The line of a lemma, empty where there is none. The licence at the top is indented, so that it sorts first.
  std::string_view LineOf(std::string_view lemma) const {
    std::size_t low = 0, high = text().size();
    while (low < high) {
      std::size_t begin = low + (high - low) / 2;
      while (begin > low && text()[begin - 1] != '\n') --begin;
      const std::string_view line = LineAt(begin);
      const std::string_view found = line.substr(0, line.find(' '));
      if (found == lemma) return line;
      if (found < lemma) low = begin + line.size() + 1;
      if (found > lemma) high = begin;
    }
    return {};
  }

 private:
  boost::interprocess::file_mapping file_;
  boost::interprocess::mapped_region region_;
};

namespace {

// The next field of a line.
std::string_view Take(std::string_view& line) {
  const std::size_t end = std::min(line.find(' '), line.size());
  const std::string_view field = line.substr(0, end);
  line.remove_prefix(std::min(end + 1, line.size()));
  return field;
}

std::uint32_t TakeNumber(std::string_view& line, int base = 10) {
  const std::string_view field = Take(line);
  std::uint32_t number = 0;
  std::from_chars(field.data(), field.data() + field.size(), number, base);
  return number;
}

// As lemmas are written: "bird_bath".
std::string LemmaOf(std::string_view word) {
  std::string lemma(word);
  std::ranges::replace(lemma, ' ', '_');
  return lemma;
}

std::string SingularLemma(std::string_view word) {
  const std::size_t last = word.rfind(' ') + 1;
  return LemmaOf(std::string(word.substr(0, last)) + Singular(word.substr(last)));
}

}  // namespace

struct WordNet::Files {
  explicit Files(const std::filesystem::path& folder)
      : nouns(folder / "index.noun"),
        data(folder / "data.noun"),
        adjectives(folder / "index.adj"),
        verbs(folder / "index.verb"),
        adverbs(folder / "index.adv") {}

  MappedFile nouns, data, adjectives, verbs, adverbs;
};

absl::StatusOr<std::unique_ptr<const WordNet>> WordNet::Open(const std::filesystem::path& folder) {
  try {
    return std::unique_ptr<const WordNet>(new WordNet(std::make_unique<const Files>(folder)));
  } catch (const boost::interprocess::interprocess_exception& error) {
    return NotFound("{}: WordNet's files cannot be read ({}); Debian's package wordnet-base installs them",
                    folder.string(), error.what());
  }
}

const WordNet& WordNet::Get() {
  static const WordNet* const installed = [] {
    absl::StatusOr<std::unique_ptr<const WordNet>> opened = Open(kFolder);
    if (opened.ok()) return opened->release();
    fmt::print(stderr, "{}\n", opened.status().ToString());
    std::exit(1);
  }();
  return *installed;
}

absl::Status WordNet::CheckInstalled() { return Open(kFolder).status(); }

WordNet::WordNet(std::unique_ptr<const Files> files) : files_(std::move(files)) {}
WordNet::~WordNet() = default;

std::vector<NounSense> WordNet::SensesOf(std::string_view noun) const {
  if (noun.empty() || noun.size() > kLongest) return {};
  // "glasses" and "arms" are words of their own, "stools" is not.
  std::string_view line = files_->nouns.LineOf(LemmaOf(noun));
  if (line.empty()) line = files_->nouns.LineOf(SingularLemma(noun));
  if (line.empty()) return {};
  Take(line), Take(line);  // lemma, part of speech
  const std::uint32_t count = TakeNumber(line);
  for (std::uint32_t symbols = TakeNumber(line); symbols > 0; --symbols) Take(line);
  Take(line), Take(line);  // senses again, senses with known frequency
  std::vector<NounSense> senses;
  for (std::uint32_t i = 0; i < count; ++i) {
    NounSense& sense = senses.emplace_back();
    sense.id = TakeNumber(line);
    std::string_view data = files_->data.LineAt(sense.id);
    Take(data);
    sense.domain = static_cast<Domain>(TakeNumber(data));
  }
  return senses;
}

std::optional<NounSense> WordNet::Find(std::string_view text) const {
  const std::size_t mark = std::min(text.find('#'), text.size());
  std::size_t which = 1;
  if (mark < text.size()) std::from_chars(text.data() + mark + 1, text.data() + text.size(), which);
  const std::vector<NounSense> senses = SensesOf(text.substr(0, mark));
  return which >= 1 && which <= senses.size() ? std::optional(senses[which - 1]) : std::nullopt;
}

std::vector<Kind> WordNet::KindsOf(const NounSense& sense) const {
  std::vector<Kind> kinds = {{sense.id, 0}};
  for (std::size_t next = 0; next < kinds.size(); ++next) {
    std::string_view line = files_->data.LineAt(kinds[next].id);
    Take(line), Take(line), Take(line);  // offset, domain, part of speech
    for (std::uint32_t words = TakeNumber(line, 16); words > 0; --words) Take(line), Take(line);
    for (std::uint32_t pointers = TakeNumber(line); pointers > 0; --pointers) {
      const std::string_view symbol = Take(line);
      const std::uint32_t target = TakeNumber(line);
      Take(line), Take(line);  // part of speech, words
      const bool above = symbol == "@" || symbol == "@i";
      if (above && std::ranges::find(kinds, target, &Kind::id) == kinds.end()) {
        kinds.push_back({target, kinds[next].steps + 1});
      }
    }
  }
  return kinds;
}

bool WordNet::IsAdjective(std::string_view word) const {
  return word.size() <= kLongest && !files_->adjectives.LineOf(LemmaOf(word)).empty();
}

bool WordNet::IsVerb(std::string_view word) const {
  if (word.size() > kLongest) return false;
  if (!files_->verbs.LineOf(LemmaOf(word)).empty()) return true;
  const auto without = [&](std::string_view ending, std::string_view more) {
    return word.ends_with(ending) &&
           !files_->verbs.LineOf(std::string(word.substr(0, word.size() - ending.size())).append(more)).empty();
  };
  return without("s", "") || without("es", "") || without("ies", "y") || without("ed", "") || without("ed", "e") ||
         without("ing", "") || without("ing", "e");
}

bool WordNet::Knows(std::string_view word) const {
  if (word.size() > kLongest) return false;
  return !SensesOf(word).empty() || IsAdjective(word) || IsVerb(word) || !files_->adverbs.LineOf(LemmaOf(word)).empty();
}

}  // namespace flair::english
