// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/database.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include "orchestrator/store/schema_sql.h"

namespace flair::orchestrator {
namespace {

// How long to wait for another process that writes.
constexpr int kBusyTimeoutMs = 20000;
constexpr int kWalRetryMs = 5;

absl::Status ToStatus(sqlite3* connection, int code) {
  const std::string message = fmt::format("store: {}", sqlite3_errmsg(connection));
  // A table or column of ours that is not there was lost.
  const bool lost = (code & 0xff) == SQLITE_ERROR && message.starts_with("store: no such ");
  switch (lost ? SQLITE_CORRUPT : code & 0xff) {
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
      return Damaged(sqlite3_db_filename(connection, "main"), message);
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

absl::Status Damaged(std::string_view path, std::string_view what) {
  return DataLoss("{}: {}; restore a good copy, or move it away to start afresh", path, what);
}

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

Statement& Statement::Bind(Blob blob) {
  // An empty blob must not become NULL.
  const char* data = blob.bytes.empty() ? "" : blob.bytes.data();
  if (code_ == SQLITE_OK) {
    code_ = sqlite3_bind_blob64(statement_, next_parameter_++, data, blob.bytes.size(), SQLITE_TRANSIENT);
  }
  return *this;
}

Statement& Statement::BindValue(const SqlValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return Bind(*text);
  if (const auto* number = std::get_if<int64_t>(&value)) return Bind(*number);
  const auto* real = std::get_if<double>(&value);
  if (code_ != SQLITE_OK) return *this;
  const int place = next_parameter_++;
  code_ = real != nullptr ? sqlite3_bind_double(statement_, place, *real) : sqlite3_bind_null(statement_, place);
  return *this;
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
    ASSIGN_OR_RETURN(const bool row, Step());
    if (!row) return texts;
    texts.push_back(Text(0));
  }
}

absl::Status Statement::Run() {
  while (true) {
    ASSIGN_OR_RETURN(const bool row, Step());
    if (!row) return absl::OkStatus();
  }
}

int64_t Statement::Int(int column) const { return sqlite3_column_int64(statement_, column); }

std::string Statement::Text(int column) const {
  const void* data = sqlite3_column_blob(statement_, column);
  const int size = sqlite3_column_bytes(statement_, column);
  return data == nullptr ? "" : std::string(static_cast<const char*>(data), static_cast<size_t>(size));
}

SqlValue Statement::Value(int column) const {
  switch (sqlite3_column_type(statement_, column)) {
    case SQLITE_INTEGER:
      return Int(column);
    case SQLITE_FLOAT:
      return sqlite3_column_double(statement_, column);
    case SQLITE_TEXT:
      return Text(column);
    default:
      return {};
  }
}

absl::Status Statement::Error() const {
  return ToStatus(connection_, code_ == SQLITE_OK ? sqlite3_errcode(connection_) : code_);
}

Database::Schema Database::JobSchema() { return kMigrations; }

absl::StatusOr<std::unique_ptr<Database>> Database::Open(const std::string& path, Schema schema) {
  sqlite3* connection = nullptr;
  const int flags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX;
  const int code = sqlite3_open_v2(path.c_str(), &connection, flags, nullptr);
  std::unique_ptr<Database> database(new Database(path, connection));
  absl::Status status = code == SQLITE_OK ? database->Configure() : ToStatus(connection, code);
  if (status.ok() && !schema.empty()) status = database->Migrate(schema);
  if (status.ok()) return database;
  if (absl::IsDataLoss(status)) return status;
  return absl::Status(status.code(), fmt::format("{}: {}", path, std::string(status.message())));
}

Database::~Database() {
  for (auto& [sql, statement] : statements_) sqlite3_finalize(statement);
  sqlite3_close(connection_);
}

absl::Status Database::Configure() {
  sqlite3_extended_result_codes(connection_, 1);
  // A statement is planned once, not again for each value that a partial index might depend on.
  sqlite3_db_config(connection_, SQLITE_DBCONFIG_ENABLE_QPSG, 1, nullptr);
  RETURN_IF_ERROR(EnterWal());
  sqlite3_busy_timeout(connection_, kBusyTimeoutMs);
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
  ASSIGN_OR_RETURN(Transaction transaction, Transaction::Begin(*this));
  ASSIGN_OR_RETURN(const int64_t version, FirstInt("PRAGMA user_version"));
  if (version > newest) {
    return FailedPrecondition("the store has version {}, this program knows up to {}; use a newer Flair", version,
                              newest);
  }
  if (version == newest) return absl::OkStatus();
  for (const std::string_view step : schema.subspan(static_cast<size_t>(version))) {
    RETURN_IF_ERROR(Execute(std::string(step)));
  }
  RETURN_IF_ERROR(Execute(fmt::format("PRAGMA user_version = {}", newest)));
  return transaction.Commit();
}

Statement Database::PrepareUnbound(std::string_view sql) {
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

absl::Status Database::CheckWhole() {
  ASSIGN_OR_RETURN(const std::string fault, FirstText("PRAGMA integrity_check(1)"));
  return fault == "ok" ? absl::OkStatus() : Damaged(path_, fault);
}

absl::Status Database::SetFlushedAtOnce(bool at_once) {
  if (at_once == flushed_at_once_) return absl::OkStatus();
  RETURN_IF_ERROR(Execute(at_once ? "PRAGMA synchronous = FULL" : "PRAGMA synchronous = NORMAL"));
  flushed_at_once_ = at_once;
  return absl::OkStatus();
}

absl::StatusOr<Transaction> Transaction::Begin(Database& database, Durability durability) {
  std::unique_lock<std::recursive_mutex> lock = database.lock();
  RETURN_IF_ERROR(database.SetFlushedAtOnce(durability == Durability::kPowerLoss));
  RETURN_IF_ERROR(database.Prepare("BEGIN IMMEDIATE").Run());
  return Transaction(database, std::move(lock));
}

Transaction::Transaction(Transaction&& other) noexcept
    : database_(std::exchange(other.database_, nullptr)), lock_(std::move(other.lock_)) {}

Transaction::~Transaction() {
  if (database_ != nullptr) (void)database_->Execute("ROLLBACK");
}

absl::Status Transaction::Commit() {
  RETURN_IF_ERROR(database_->Prepare("COMMIT").Run());
  database_ = nullptr;
  lock_.unlock();
  return absl::OkStatus();
}

}  // namespace flair::orchestrator
