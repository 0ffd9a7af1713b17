// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/model/cleaning_changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "llm/answers/choices.h"

namespace flair::language {
namespace {

using model::v1::ChangeAnswer;

// "s1, s2 and s3" as words.
std::vector<std::string> WordsOf(std::string_view text) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : std::string(text) + " ") {
    const bool within = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    if (within) {
      word += c;
    } else if (!word.empty()) {
      words.push_back(std::exchange(word, {}));
    }
  }
  return words;
}

// What stands in "none(why)" and its like; nothing for a sentence.
std::optional<std::string> RemovalReason(std::string_view text) {
  constexpr std::string_view kAround = " \t.,;:-()[]\"'`";
  text.remove_prefix(std::min(text.find_first_not_of(kAround), text.size()));
  const size_t end = std::min(text.find_first_of(" \t:()-,."), text.size());
  static constexpr std::array<std::string_view, 8> kNone = {"",     "none",   "null",    "nothing",
                                                            "goes", "remove", "removed", "delete"};
  const std::string word = llm::Bare(text.substr(0, end));
  if (std::find(kNone.begin(), kNone.end(), word) == kNone.end()) return std::nullopt;
  // A sentence may begin so: "Nothing stands before the door."
  if (word == "nothing" && end < text.size() && text[end] == ' ') return std::nullopt;
  text.remove_prefix(end);
  const size_t first = text.find_first_not_of(kAround);
  if (first == std::string_view::npos) return "";
  return std::string(text.substr(first, text.find_last_not_of(kAround) - first + 1));
}

class Reader {
 public:
  explicit Reader(const SentenceIndex& sentences) : sentences_(sentences) {
    for (const auto& [id, sentence] : sentences) ids_.names.push_back(id);
  }

  // What is wrong with an element; else takes it.
  std::string Add(const ChangeAnswer& answer) {
    Change change;
    for (const std::string& word : WordsOf(answer.from())) {
      const std::optional<std::string> id = llm::FindChoice(word, ids_);
      if (!id && word == "and") continue;
      if (!id) return fmt::format("names {}, which is no sentence of the list", llm::Quoted(word));
      if (std::find(change.from.begin(), change.from.end(), *id) == change.from.end()) change.from.push_back(*id);
    }
    if (change.from.empty()) return "names no sentence; its id before a colon would be right";
    for (const std::string& text : answer.to()) {
      if (std::optional<std::string> reason = RemovalReason(text)) {
        if (change.reason.empty()) change.reason = *std::move(reason);
      } else {
        change.to.push_back(text);
      }
    }
    const v1::SentenceScope scope = sentences_.at(change.from.front())->scope();
    for (const std::string& id : change.from) {
      if (sentences_.at(id)->scope() != scope) return "joins sentences about one object with others about several";
    }
    if (change.from.size() > 1 && change.to.size() > 1) {
      return "makes several sentences of several; one of them, or several of one, would be right";
    }
    return Join(std::move(change));
  }

  std::vector<Change> TakeChanges() {
    std::erase_if(changes_, [&](const Change& change) {
      return change.from.size() == 1 && change.to.size() == 1 &&
             change.to.front() == sentences_.at(change.from.front())->text();
    });
    return std::move(changes_);
  }

 private:
  // A further line about the same sentence is a further part of it.
  std::string Join(Change change) {
    constexpr size_t kMostParts = 8;
    for (const std::string& id : change.from) {
      const auto other = changed_.find(id);
      if (other == changed_.end()) continue;
      Change& first = changes_[other->second];
      if (first.from != change.from || change.from.size() > 1 || first.to.empty() || change.to.empty() ||
          first.to.size() + change.to.size() > kMostParts) {
        return fmt::format("changes {}, which another one changes", id);
      }
      for (std::string& text : change.to) first.to.push_back(std::move(text));
      return "";
    }
    for (const std::string& id : change.from) changed_[id] = changes_.size();
    changes_.push_back(std::move(change));
    return "";
  }

  const SentenceIndex& sentences_;
  llm::Choices ids_;
  std::vector<Change> changes_;
  std::map<std::string, size_t> changed_;
};

}  // namespace

SentenceIndex IndexOf(const v1::ConstraintList& list) {
  SentenceIndex index;
  for (const v1::Sentence& sentence : list.sentences()) {
    if (sentence.scope() != v1::SENTENCE_SCOPE_TERTIARY) index[sentence.id()] = &sentence;
  }
  return index;
}

std::vector<Change> ReadChanges(const model::v1::CleaningAnswer& answer, const SentenceIndex& sentences,
                                std::vector<llm::Fault>* faults) {
  Reader reader(sentences);
  for (int i = 0; i < answer.changes_size(); ++i) {
    std::string fault = reader.Add(answer.changes(i));
    if (!fault.empty() && faults != nullptr) faults->push_back({fmt::format("changes[{}]", i), std::move(fault)});
  }
  return reader.TakeChanges();
}

size_t RemovedCount(const std::vector<Change>& changes) {
  size_t count = 0;
  for (const Change& change : changes) count += change.to.empty() ? change.from.size() : 0;
  return count;
}

}  // namespace flair::language
