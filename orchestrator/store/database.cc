// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/database.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "orchestrator/store/digest_functions.h"
#include "orchestrator/store/log_vfs.h"
#include "orchestrator/store/schema_sql.h"
#include "worker_runtime/files/files.h"

namespace flair::orchestrator {
namespace {

// How long to wait for another process that writes.
constexpr int kBusyTimeoutMs = 20000;
constexpr int kWalRetryMs = 5;

// Digests lie anywhere, and so do the pages that they are on.
constexpr int kCacheKib = 16 * 1024;
constexpr int kMigrationCacheKib = 256 * 1024;

absl::Status ToStatus(sqlite3* connection, int code) {
  const std::string message = fmt::format("store: {}", sqlite3_errmsg(connection));
  switch (code & 0xff) {
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
      return absl::DataLossError(message);
    case SQLITE_FULL:
      return absl::ResourceExhaustedError(message);
    case SQLITE_CONSTRAINT:
      return absl::AlreadyExistsError(message);
    case SQLITE_BUSY:
    case SQLITE_CANTOPEN:
    case SQLITE_IOERR:
    case SQLITE_READONLY:
    case SQLITE_PERM:
      return absl::UnavailableError(message);
    default:
      return absl::InternalError(message);
  }
}

}  // namespace

Statement::Statement(Statement&& other) noexcept
    : connection_(other.connection_),
      statement_(std::exchange(other.statement_, nullptr)),
      next_parameter_(other.next_parameter_),
      code_(other.code_) {}

Statement::~Statement() {
  if (statement_ == nullptr) return;
  sqlite3_reset(statement_);
  sqlite3_clear_bindings(statement_);
}

Statement& Statement::Bind(int64_t value) {
  if (code_ == SQLITE_OK) code_ = sqlite3_bind_int64(statement_, next_parameter_++, value);
  return *this;
}

Statement& Statement::Bind(std::string_view text) {
  if (code_ == SQLITE_OK) {
    code_ = sqlite3_bind_text64(statement_, next_parameter_++, text.data(), text.size(), SQLITE_TRANSIENT, SQLITE_UTF8);
  }
  return *this;
}

Statement& Statement::BindBytes(std::string_view bytes) {
  // An empty blob must not become NULL.
  const char* data = bytes.empty() ? "" : bytes.data();
  if (code_ == SQLITE_OK) {
    code_ = sqlite3_bind_blob64(statement_, next_parameter_++, data, bytes.size(), SQLITE_TRANSIENT);
  }
  return *this;
}

Statement& Statement::BindNull() {
  if (code_ == SQLITE_OK) code_ = sqlite3_bind_null(statement_, next_parameter_++);
  return *this;
}

Statement& Statement::BindAt(int parameter, int64_t value) {
  next_parameter_ = parameter;
  return Bind(value);
}

Statement& Statement::BindAt(int parameter, std::string_view text) {
  next_parameter_ = parameter;
  return Bind(text);
}

absl::StatusOr<bool> Statement::Step() {
  if (statement_ == nullptr) return Error();
  if (code_ != SQLITE_OK && code_ != SQLITE_ROW) return Error();
  code_ = sqlite3_step(statement_);
  if (code_ == SQLITE_ROW) return true;
  if (code_ == SQLITE_DONE) return false;
  return Error();
}

absl::StatusOr<std::vector<std::string>> Statement::Texts() {
  std::vector<std::string> texts;
  while (true) {
    absl::StatusOr<bool> row = Step();
    if (!row.ok()) return row.status();
    if (!*row) return texts;
    texts.push_back(Text(0));
  }
}

absl::Status Statement::Run() {
  while (true) {
    absl::StatusOr<bool> row = Step();
    if (!row.ok()) return row.status();
    if (!*row) return absl::OkStatus();
  }
}

int64_t Statement::Int(int column) const { return sqlite3_column_int64(statement_, column); }

std::string Statement::Text(int column) const {
  const void* data = sqlite3_column_blob(statement_, column);
  const int size = sqlite3_column_bytes(statement_, column);
  return data == nullptr ? "" : std::string(static_cast<const char*>(data), static_cast<size_t>(size));
}

absl::Status Statement::Error() const {
  return ToStatus(connection_, code_ == SQLITE_OK ? sqlite3_errcode(connection_) : code_);
}

Database::Schema Database::JobSchema() { return kMigrations; }

absl::StatusOr<std::unique_ptr<Database>> Database::Open(const std::string& path, Schema schema) {
  // Nobody asks how much memory SQLite has; counting it takes a lock of the whole process at each allocation.
  [[maybe_unused]] static const int configured = sqlite3_config(SQLITE_CONFIG_MEMSTATUS, 0);
  sqlite3* connection = nullptr;
  const int flags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX;
  const int code = sqlite3_open_v2(path.c_str(), &connection, flags, LogVfsName());
  std::unique_ptr<Database> database(new Database(path, connection));
  absl::Status status = code == SQLITE_OK ? database->Configure() : ToStatus(connection, code);
  if (status.ok()) status = database->Migrate(schema);
  if (status.ok()) status = database->OpenLog();
  if (!status.ok()) {
    const char* right = absl::IsDataLoss(status) ? "; put a good copy in its place, or move it away to begin anew" : "";
    return absl::Status(status.code(), fmt::format("{}: {}{}", path, std::string(status.message()), right));
  }
  return database;
}

Database::~Database() {
  for (auto& [sql, statement] : statements_) sqlite3_finalize(statement);
  sqlite3_close(connection_);
  if (log_file_ >= 0) ::close(log_file_);
}

absl::Status Database::Configure() {
  sqlite3_extended_result_codes(connection_, 1);
  // A statement is planned once, not again for each value that a partial index might depend on.
  sqlite3_db_config(connection_, SQLITE_DBCONFIG_ENABLE_QPSG, 1, nullptr);
  if (const int code = AddDigestFunctions(connection_); code != SQLITE_OK) return ToStatus(connection_, code);
  if (absl::Status status = EnterWal(); !status.ok()) return status;
  sqlite3_busy_timeout(connection_, kBusyTimeoutMs);
  // 16 MiB: a page that many jobs change is written back once for all of them.
  if (absl::Status status = Execute("PRAGMA wal_autocheckpoint = 4000"); !status.ok()) return status;
  if (absl::Status status = Execute(fmt::format("PRAGMA cache_size = -{}", kCacheKib)); !status.ok()) return status;
  return Execute("PRAGMA synchronous = NORMAL");
}

// While another process makes the same new file, SQLite would wait for it in all statements but this one.
absl::Status Database::EnterWal() {
  int code = SQLITE_BUSY;
  for (int waited_ms = 0; waited_ms < kBusyTimeoutMs && (code & 0xff) == SQLITE_BUSY; waited_ms += kWalRetryMs) {
    if (waited_ms > 0) sqlite3_sleep(kWalRetryMs);
    code = sqlite3_exec(connection_, "PRAGMA journal_mode = WAL", nullptr, nullptr, nullptr);
  }
  return code == SQLITE_OK ? absl::OkStatus() : ToStatus(connection_, code);
}

absl::Status Database::Migrate(Schema schema) {
  const auto newest = static_cast<int64_t>(schema.size());
  absl::StatusOr<Transaction> transaction = Transaction::Begin(*this);
  if (!transaction.ok()) return transaction.status();
  int64_t version = 0;
  {
    Statement statement = Prepare("PRAGMA user_version");
    absl::StatusOr<bool> row = statement.Step();
    if (!row.ok()) return row.status();
    version = statement.Int(0);
  }
  if (version > newest) {
    return absl::FailedPreconditionError(
        fmt::format("the store has version {}, this program knows up to {}; use the newer Flair", version, newest));
  }
  if (version == newest) return absl::OkStatus();
  // Many read all of a large store at random.
  if (absl::Status status = Execute(fmt::format("PRAGMA cache_size = -{}", kMigrationCacheKib)); !status.ok())
    return status;
  for (const std::string_view step : schema.subspan(static_cast<size_t>(version))) {
    if (absl::Status status = Execute(std::string(step)); !status.ok()) return status;
  }
  if (absl::Status status = Execute(fmt::format("PRAGMA user_version = {}", newest)); !status.ok()) return status;
  if (absl::Status status = transaction->Commit(); !status.ok()) return status;
  return Execute(fmt::format("PRAGMA cache_size = -{}", kCacheKib));
}

Statement Database::Prepare(std::string_view sql) {
  auto found = statements_.find(sql);
  if (found == statements_.end()) {
    sqlite3_stmt* statement = nullptr;
    sqlite3_prepare_v3(connection_, sql.data(), static_cast<int>(sql.size()), SQLITE_PREPARE_PERSISTENT, &statement,
                       nullptr);
    if (statement == nullptr) return Statement(connection_, nullptr);
    found = statements_.emplace(std::string(sql), statement).first;
  }
  return Statement(connection_, found->second);
}

int64_t Database::changes() const { return sqlite3_changes64(connection_); }

absl::Status Database::Execute(const std::string& sql) {
  const int code = sqlite3_exec(connection_, sql.c_str(), nullptr, nullptr, nullptr);
  return code == SQLITE_OK ? absl::OkStatus() : ToStatus(connection_, code);
}

absl::Status Database::OpenLog() {
  const std::string path = path_ + "-wal";
  // SQLite's locks are on other files, so closing this one loses none.
  log_file_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (log_file_ < 0) return absl::UnavailableError(fmt::format("its log cannot be opened: {}", std::strerror(errno)));
  // The log's place in its folder; SQLite itself sees to it only when it flushes.
  return runtime::FlushFiles(std::span(&path, 1));
}

absl::Status Database::FlushLog() {
  const int64_t asked = ++flushes_asked_;
  std::lock_guard lock(flush_mutex_);
  // One that began later than this was asked for.
  if (flushes_answered_ >= asked) return absl::OkStatus();
  const int64_t answered = flushes_asked_;
  if (::fdatasync(log_file_) != 0) {
    return absl::UnavailableError(fmt::format("{}-wal: cannot be flushed: {}", path_, std::strerror(errno)));
  }
  flushes_answered_ = answered;
  return absl::OkStatus();
}

absl::Status Database::SetFlushedAtOnce(bool at_once) {
  if (at_once == flushed_at_once_) return absl::OkStatus();
  absl::Status status = Execute(at_once ? "PRAGMA synchronous = FULL" : "PRAGMA synchronous = NORMAL");
  if (status.ok()) flushed_at_once_ = at_once;
  return status;
}

absl::StatusOr<Transaction> Transaction::Begin(Database& database, Durability durability) {
  std::unique_lock<std::recursive_mutex> lock = database.lock();
  absl::Status status = database.SetFlushedAtOnce(durability == Durability::kPowerLoss);
  if (status.ok()) status = database.Prepare("BEGIN IMMEDIATE").Run();
  if (!status.ok()) return status;
  return Transaction(database, std::move(lock));
}

Transaction::Transaction(Transaction&& other) noexcept
    : database_(std::exchange(other.database_, nullptr)), lock_(std::move(other.lock_)) {}

Transaction::~Transaction() {
  if (database_ != nullptr) (void)database_->Execute("ROLLBACK");
}

absl::Status Transaction::Commit() {
  absl::Status status = database_->Prepare("COMMIT").Run();
  if (!status.ok()) return status;
  database_ = nullptr;
  lock_.unlock();
  return absl::OkStatus();
}

}  // namespace flair::orchestrator
