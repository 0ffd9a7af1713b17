// SPDX-License-Identifier: GPL-3.0-or-later
#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fmt/format.h"
#include "renderer_worker/assets/asset_library.h"
#include "renderer_worker/furniture/classes.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {
namespace {

constexpr size_t kMaxWords = 64;
constexpr size_t kMaxWordBytes = 40;
constexpr std::array<std::string_view, 16> kTellNothing = {"a",  "an", "and", "at", "by", "for", "from", "in",
                                                           "is", "it", "of",  "on", "or", "the", "to",   "with"};

bool IsLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || (c & 0x80) != 0;
}

std::string Singular(std::string word) {
  if (word.size() > 3 && word.back() == 's' && word[word.size() - 2] != 's') word.pop_back();
  return word;
}

// The words of a text: letters and digits (all bytes beyond ASCII count as letters), lower case in ASCII, without words
// that tell nothing ("the", "with") and without a plural's s. At most 64, each at most 40 bytes.
std::vector<std::string> WordsOf(std::string_view text) {
  std::vector<std::string> words;
  std::string word;
  const auto finish = [&] {
    const bool told = std::ranges::find(kTellNothing, word) == kTellNothing.end();
    if (!word.empty() && word.size() <= kMaxWordBytes && told) words.push_back(Singular(std::move(word)));
    word.clear();
  };
  for (const char c : text) {
    if (!IsLetter(c)) {
      finish();
      if (words.size() >= kMaxWords) return words;
    } else {
      word.push_back(c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c);
    }
  }
  finish();
  return words;
}

constexpr int kCandidates = 60;
constexpr double kUnknownFit = 0.8;
constexpr double kSameClass = 0.85;

struct Close {
  void operator()(sqlite3* database) const { sqlite3_close(database); }
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using Database = std::unique_ptr<sqlite3, Close>;
using Statement = std::unique_ptr<sqlite3_stmt, Close>;

absl::Status Failed(sqlite3* database, std::string_view doing) {
  return Internal("SQLite could not {}: {}", doing, sqlite3_errmsg(database));
}

absl::StatusOr<Statement> Prepare(sqlite3* database, std::string_view sql) {
  sqlite3_stmt* statement = nullptr;
  if (sqlite3_prepare_v2(database, sql.data(), static_cast<int>(sql.size()), &statement, nullptr) != SQLITE_OK) {
    return Failed(database, "prepare the index of assets");
  }
  return Statement(statement);
}

void Bind(sqlite3_stmt* statement, int place, std::string_view text) {
  sqlite3_bind_text(statement, place, text.data(), static_cast<int>(text.size()), SQLITE_TRANSIENT);
}

double FitFactor(double fit) { return 0.4 + 0.6 * fit; }

// What is kept of an entry to score it.
struct Known {
  std::string id;
  std::string class_name;            // of its name, else of its tags; empty when neither tells
  std::set<std::string> name_words;  // of name and tags
  std::set<std::string> all_words;   // and of its text
  std::optional<Vec3> size;
};

// Tags are no name and have no head noun: only when all that tell a class tell the same one.
std::string ClassOfTags(const std::string& tags) {
  std::set<std::string> told;
  for (const std::string& tag : WordsOf(tags)) {
    if (const std::string_view found = ClassFromWords(tag); !found.empty()) told.emplace(found);
  }
  return told.size() == 1 ? *told.begin() : std::string();
}

Known KnownOf(const AssetEntry& entry) {
  Known known{entry.id, std::string(ClassFromWords(entry.name)), {}, {}, entry.size_m};
  if (known.class_name.empty()) known.class_name = ClassOfTags(entry.tags);
  if (known.class_name == "box") known.class_name.clear();
  for (const std::string& text : {entry.name, entry.tags}) {
    for (std::string& word : WordsOf(text)) known.name_words.insert(std::move(word));
  }
  known.all_words = known.name_words;
  for (std::string& word : WordsOf(entry.text)) known.all_words.insert(std::move(word));
  return known;
}

// Words of FTS5's query language become plain words by quotes.
std::string QueryOf(const std::vector<std::string>& words) {
  std::string query;
  for (const std::string& word : words) query += fmt::format("{}\"{}\"", query.empty() ? "" : " OR ", word);
  return query;
}

double ShareIn(const std::vector<std::string>& words, const std::set<std::string>& held, double last_weight) {
  double sum = 0, most = 0;
  for (size_t i = 0; i < words.size(); ++i) {
    const double weight = i + 1 == words.size() ? last_weight : 1;
    most += weight;
    sum += held.contains(words[i]) ? weight : 0;
  }
  return most > 0 ? sum / most : 0;
}

class FtsIndex final : public AssetIndex {
 public:
  absl::Status Fill(std::span<const AssetEntry> entries) {
    sqlite3* opened = nullptr;
    const int result = sqlite3_open_v2(":memory:", &opened, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr);
    database_.reset(opened);
    if (result != SQLITE_OK) return Failed(opened, "open the index of assets");
    constexpr char kSchema[] =
        "CREATE VIRTUAL TABLE asset USING fts5(name, tags, text, content='', tokenize='porter unicode61'); BEGIN";
    if (sqlite3_exec(opened, kSchema, nullptr, nullptr, nullptr) != SQLITE_OK)
      return Failed(opened, "make the table of assets");
    ASSIGN_OR_RETURN(Statement insert,
                     Prepare(opened, "INSERT INTO asset(rowid, name, tags, text) VALUES (?, ?, ?, ?)"));
    for (const AssetEntry& entry : entries) {
      known_.push_back(KnownOf(entry));
      sqlite3_bind_int64(insert.get(), 1, static_cast<sqlite3_int64>(known_.size()));
      Bind(insert.get(), 2, entry.name);
      Bind(insert.get(), 3, entry.tags);
      Bind(insert.get(), 4, entry.text);
      if (sqlite3_step(insert.get()) != SQLITE_DONE) return Failed(opened, "enter an asset");
      sqlite3_reset(insert.get());
    }
    insert.reset();
    if (sqlite3_exec(opened, "COMMIT", nullptr, nullptr, nullptr) != SQLITE_OK)
      return Failed(opened, "enter the assets");
    ASSIGN_OR_RETURN(search_, Prepare(opened,
                                      "SELECT rowid, bm25(asset, 8.0, 4.0, 1.0) AS rank FROM asset WHERE asset MATCH ? "
                                      "ORDER BY rank, rowid LIMIT ?"));
    return absl::OkStatus();
  }

  absl::StatusOr<std::vector<AssetMatch>> Find(const v1::Object& object, const v1::ObjectStyle* style,
                                               size_t max_count) override {
    Wanted wanted{object, std::string(ClassOf(object)), WordsOf(object.name()), {}};
    if (wanted.class_name == "box") wanted.class_name.clear();
    if (style != nullptr) wanted.style = WordsOf(style->material() + " " + style->colour().name());
    std::vector<std::string> words = wanted.name;
    for (const std::string& text : {object.category(), wanted.class_name}) {
      for (std::string& word : WordsOf(text)) words.push_back(std::move(word));
    }
    words.insert(words.end(), wanted.style.begin(), wanted.style.end());
    if (words.empty()) return std::vector<AssetMatch>();
    ASSIGN_OR_RETURN(auto candidates, Candidates(QueryOf(words)));
    std::vector<AssetMatch> matches;
    for (const auto& [entry, text] : candidates) {
      const double score = Score(known_[entry], wanted, text);
      if (score >= kLeastAssetScore) matches.push_back({entry, score});
    }
    std::ranges::sort(matches, [&](const AssetMatch& a, const AssetMatch& b) {
      return a.score != b.score ? a.score > b.score : known_[a.entry].id < known_[b.entry].id;
    });
    if (matches.size() > max_count) matches.resize(max_count);
    return matches;
  }

 private:
  struct Wanted {
    const v1::Object& object;
    std::string class_name;
    std::vector<std::string> name;
    std::vector<std::string> style;
  };

  // Entries with their bm25 as a share of the best one's.
  absl::StatusOr<std::vector<std::pair<size_t, double>>> Candidates(const std::string& query) {
    const std::lock_guard lock(mutex_);
    sqlite3_reset(search_.get());
    Bind(search_.get(), 1, query);
    sqlite3_bind_int(search_.get(), 2, kCandidates);
    std::vector<std::pair<size_t, double>> found;
    int step = SQLITE_ROW;
    while ((step = sqlite3_step(search_.get())) == SQLITE_ROW) {
      const auto entry = static_cast<size_t>(sqlite3_column_int64(search_.get(), 0) - 1);
      found.emplace_back(entry, -sqlite3_column_double(search_.get(), 1));
    }
    sqlite3_reset(search_.get());
    if (step != SQLITE_DONE) return Failed(database_.get(), "search for an asset");
    const double best = found.empty() ? 1 : std::max(found.front().second, 1e-12);
    for (auto& [entry, rank] : found) rank = std::clamp(rank / best, 0.0, 1.0);
    return found;
  }

  static double Score(const Known& known, const Wanted& wanted, double text) {
    const bool both = !known.class_name.empty() && !wanted.class_name.empty();
    double what = ShareIn(wanted.name, known.name_words, 2);
    if (both && known.class_name != wanted.class_name) return 0;
    if (both) what = std::max(what, kSameClass);
    const double style = ShareIn(wanted.style, known.all_words, 1);
    const double fit = known.size.has_value() ? SizeFit(*known.size, wanted.object) : kUnknownFit;
    return what * (0.7 + 0.2 * style + 0.1 * text) * FitFactor(fit);
  }

  std::vector<Known> known_;
  std::mutex mutex_;
  Database database_;
  Statement search_;
};

}  // namespace

double SizeFit(Vec3 size, const v1::Object& object) {
  // A picture without a thickness still has proportions.
  const float least = std::max({size.x, size.y, size.z}) * 0.01F;
  const double width = object.width_m() / std::max(size.x, least);
  const double depth = object.kind() == v1::OBJECT_KIND_WALL ? width : object.depth_m() / std::max(size.y, least);
  const double stretch = std::log(width / depth);
  const double height = std::log(std::sqrt(width * depth) * std::max(size.z, least) / object.height_m());
  const double missed = object.height_m() < 0.05 ? 0 : height;
  constexpr double kSpread = 0.45;
  const double fit = std::exp(-(stretch * stretch + missed * missed) / (2 * kSpread * kSpread));
  return std::isfinite(fit) ? fit : 0;
}

double WithSize(double score, Vec3 asset_size, const v1::Object& object) {
  return score / FitFactor(kUnknownFit) * FitFactor(SizeFit(asset_size, object));
}

absl::StatusOr<std::unique_ptr<AssetIndex>> AssetIndex::Make(std::span<const AssetEntry> entries) {
  auto index = std::make_unique<FtsIndex>();
  RETURN_IF_ERROR(index->Fill(entries));
  return index;
}

}  // namespace flair::renderer
