// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/http/http_client.h"

#include <curl/curl.h>
#include <fmt/format.h>
#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/match.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::llm {
namespace {

constexpr int64_t kErrorBodyByteLimit = 64 << 10;
constexpr int64_t kHeaderByteLimit = 64 << 10;

absl::Duration Now() { return runtime::SystemClock().Elapsed(); }

long Milliseconds(absl::Duration duration) {
  return std::max<long>(1, static_cast<long>(absl::ToInt64Milliseconds(std::min(duration, absl::Hours(24)))));
}

// Once in a process, before any other use of libcurl.
void InitCurl() {
  static const CURLcode done = curl_global_init(CURL_GLOBAL_DEFAULT);
  (void)done;
}

// Writing to a connection that the server has closed is an error of that connection, not the end of the process.
class WithoutSigpipe {
 public:
  WithoutSigpipe() {
    sigemptyset(&sigpipe_);
    sigaddset(&sigpipe_, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &sigpipe_, &before_);
  }
  ~WithoutSigpipe() {
    if (sigismember(&before_, SIGPIPE) == 1) return;
    constexpr timespec kAtOnce = {};
    while (sigtimedwait(&sigpipe_, nullptr, &kAtOnce) == SIGPIPE) continue;
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }

 private:
  sigset_t sigpipe_;
  sigset_t before_;
};

// Whether the certificates that libcurl trusts by itself are in a file.
bool SystemHasCertificateFile() {
  static const bool has = [] {
    const char* const file = curl_version_info(CURLVERSION_NOW)->cainfo;
    return file != nullptr && access(file, R_OK) == 0;
  }();
  return has;
}

// From a file alone libcurl reads the trusted certificates once for all connections. When it is to look into a folder
// too, as Debian's is by itself, it reads the file again for each: 35 ms and a megabyte.
void SetTrust(CURL* handle, const std::string& ca_path) {
  if (!ca_path.empty()) curl_easy_setopt(handle, CURLOPT_CAINFO, ca_path.c_str());
  if (!ca_path.empty() || SystemHasCertificateFile()) curl_easy_setopt(handle, CURLOPT_CAPATH, nullptr);
}

// One request on its way: a libcurl easy handle, what came so far, and when to give up.
class Transfer {
 public:
  // `deadline` is when the caller stops waiting; times are SystemClock().Elapsed(). All arguments outlive it.
  Transfer(const HttpRequest& request, const HttpOptions& options, absl::Duration deadline)
      : request_(request),
        timeouts_(Within(options.timeouts, deadline - Now())),
        body_byte_limit_(options.body_byte_limit),
        total_end_(Now() + timeouts_.total),
        deadline_(deadline),
        handle_(curl_easy_init()) {
    if (handle_ == nullptr) return;
    AddHeaders();
    SetOptions(options);
  }

  // Null when there is no memory.
  CURL* handle() const { return handle_.get(); }

  // The earliest moment at which Expired() can have an error, as known at `now`.
  absl::Duration NextCheck(absl::Duration now) const {
    // One that still connects may have sent its request a moment later.
    return std::min({total_end_, deadline_, std::min(silent_since_, now) + timeouts_.first_byte});
  }

  // The error of a transfer that has run out of time at `now`; else OK.
  absl::Status Expired(absl::Duration now) const {
    const std::string address = PublicAddress(request_.url);
    if (now >= total_end_) {
      return Unavailable("{}: no complete answer within {}", address, absl::FormatDuration(timeouts_.total));
    }
    if (now >= silent_since_ + timeouts_.first_byte) {
      return Unavailable("{}: silent for {}", address, absl::FormatDuration(timeouts_.first_byte));
    }
    if (now >= deadline_) return absl::DeadlineExceededError("the call's deadline has passed");
    return absl::OkStatus();
  }

  // What came of it, after libcurl said `code`.
  absl::StatusOr<HttpResponse> Finish(CURLcode code) {
    RETURN_IF_ERROR(failure_);
    if (code != CURLE_OK && !enough_) return ErrorOf(code);
    response_.status = HttpStatus();
    return std::move(response_);
  }

 private:
  struct CleanUp {
    void operator()(CURL* handle) const { curl_easy_cleanup(handle); }
    void operator()(curl_slist* list) const { curl_slist_free_all(list); }
  };

  // Shorter ones where the caller waits no longer: who is to blame is said before the caller's time is up.
  static HttpTimeouts Within(HttpTimeouts timeouts, absl::Duration left) {
    timeouts.first_byte = std::min(timeouts.first_byte, left * 0.9);
    timeouts.total = std::min(timeouts.total, left * 0.95);
    return timeouts;
  }

  void SetOptions(const HttpOptions& options) {
    CURL* const handle = handle_.get();
    const bool tls = absl::StartsWithIgnoreCase(request_.url, "https://");
    curl_easy_setopt(handle, CURLOPT_URL, request_.url.c_str());
    curl_easy_setopt(handle, CURLOPT_PROTOCOLS_STR, "http,https");
    curl_easy_setopt(handle, CURLOPT_FOLLOWLOCATION, 0L);
    curl_easy_setopt(handle, CURLOPT_NOSIGNAL, 1L);
    // A name server that does not answer must not hold up the thread when its request is given up.
    curl_easy_setopt(handle, CURLOPT_QUICK_EXIT, 1L);
    curl_easy_setopt(handle, CURLOPT_POST, 1L);
    curl_easy_setopt(handle, CURLOPT_POSTFIELDS, request_.body.c_str());
    curl_easy_setopt(handle, CURLOPT_POSTFIELDSIZE_LARGE, static_cast<curl_off_t>(request_.body.size()));
    curl_easy_setopt(handle, CURLOPT_HTTPHEADER, header_list_.get());
    curl_easy_setopt(handle, CURLOPT_ACCEPT_ENCODING, "gzip, deflate");
    // Without TLS nothing is offered, and nobody waits for it.
    curl_easy_setopt(handle, CURLOPT_HTTP_VERSION,
                     static_cast<long>(tls ? CURL_HTTP_VERSION_2TLS : CURL_HTTP_VERSION_1_1));
    curl_easy_setopt(handle, CURLOPT_TCP_KEEPALIVE, 1L);
    curl_easy_setopt(handle, CURLOPT_CONNECTTIMEOUT_MS, Milliseconds(timeouts_.connect));
    curl_easy_setopt(handle, CURLOPT_SSL_VERIFYPEER, 1L);
    curl_easy_setopt(handle, CURLOPT_SSL_VERIFYHOST, 2L);
    curl_easy_setopt(handle, CURLOPT_SSLVERSION, static_cast<long>(CURL_SSLVERSION_TLSv1_2));
    SetTrust(handle, options.ca_path);
    if (!options.proxy.empty()) curl_easy_setopt(handle, CURLOPT_PROXY, options.proxy.c_str());
    curl_easy_setopt(handle, CURLOPT_SUPPRESS_CONNECT_HEADERS, 1L);
    curl_easy_setopt(handle, CURLOPT_ERRORBUFFER, error_text_);
    SetCallbacks();
  }

  void SetCallbacks() {
    CURL* const handle = handle_.get();
    curl_easy_setopt(handle, CURLOPT_PREREQDATA, this);
    curl_easy_setopt(
        handle, CURLOPT_PREREQFUNCTION, +[](void* self, char*, char*, int, int) {
          static_cast<Transfer*>(self)->silent_since_ = Now();
          return CURL_PREREQFUNC_OK;
        });
    curl_easy_setopt(handle, CURLOPT_HEADERDATA, this);
    curl_easy_setopt(
        handle, CURLOPT_HEADERFUNCTION, +[](char* data, size_t size, size_t count, void* self) {
          return static_cast<Transfer*>(self)->TakeHeader({data, size * count});
        });
    curl_easy_setopt(handle, CURLOPT_WRITEDATA, this);
    curl_easy_setopt(
        handle, CURLOPT_WRITEFUNCTION, +[](char* data, size_t size, size_t count, void* self) {
          return static_cast<Transfer*>(self)->TakeBody({data, size * count});
        });
  }

  void AddHeaders() {
    curl_slist* list = curl_slist_append(nullptr, "Expect:");
    for (const HttpHeader& header : request_.headers) {
      // libcurl takes "Name;" for a header without a value.
      const std::string line =
          header.value.empty() ? header.name + ";" : fmt::format("{}: {}", header.name, header.value);
      list = curl_slist_append(list, line.c_str());
    }
    header_list_.reset(list);
  }

  size_t TakeHeader(std::string_view line) {
    silent_since_ = Now();
    header_byte_count_ += static_cast<int64_t>(line.size());
    if (header_byte_count_ > kHeaderByteLimit) {
      failure_ = DataLoss("{}: headers of more than {} KiB", PublicAddress(request_.url), kHeaderByteLimit >> 10);
      return 0;
    }
    const size_t colon = line.find(':');
    if (line.starts_with("HTTP/")) {
      // Each interim answer (1xx) begins anew.
      response_.headers.clear();
    } else if (colon != std::string_view::npos) {
      const std::string name(line.substr(0, colon)), value(line.substr(colon + 1));
      response_.headers.push_back({absl::AsciiStrToLower(name), std::string(absl::StripAsciiWhitespace(value))});
    }
    return line.size();
  }

  size_t TakeBody(std::string_view piece) {
    silent_since_ = Now();
    const bool success = HttpStatus() / 100 == 2;
    body_byte_count_ += static_cast<int64_t>(piece.size());
    if (success && body_byte_count_ > body_byte_limit_) {
      failure_ = DataLoss("{}: an answer of more than {} bytes", PublicAddress(request_.url), body_byte_limit_);
      return 0;
    }
    response_.body += piece;
    if (!success && body_byte_count_ > kErrorBodyByteLimit) {
      response_.body.resize(kErrorBodyByteLimit);
      enough_ = true;
      return 0;
    }
    return piece.size();
  }

  // Of the answer, by HTTP; 0 when there is none yet.
  int HttpStatus() const {
    long status = 0;
    curl_easy_getinfo(handle_.get(), CURLINFO_RESPONSE_CODE, &status);
    return static_cast<int>(status);
  }

  absl::Status ErrorOf(CURLcode code) const {
    const std::string address = PublicAddress(request_.url);
    // libcurl's own sentence for the code: the longer text may hold times and, of some servers, parts of the request.
    const std::string message = fmt::format("{}: {}", address, curl_easy_strerror(code));
    switch (code) {
      case CURLE_OPERATION_TIMEDOUT:
        // Of connecting, the only time that libcurl watches.
        return Unavailable("{}: no connection within {}", address, absl::FormatDuration(timeouts_.connect));
      case CURLE_URL_MALFORMAT:
        return absl::InvalidArgumentError(message);
      case CURLE_PEER_FAILED_VERIFICATION:
        return FailedPrecondition("{}: its certificate is not trusted ({})", address, error_text_);
      case CURLE_SSL_CACERT_BADFILE:
      case CURLE_SSL_ENGINE_NOTFOUND:
      case CURLE_SSL_CERTPROBLEM:
        return absl::FailedPreconditionError(message);
      case CURLE_UNSUPPORTED_PROTOCOL:
      case CURLE_WEIRD_SERVER_REPLY:
      case CURLE_FILESIZE_EXCEEDED:
        return DataLoss("{}: not an HTTP answer ({})", address, curl_easy_strerror(code));
      case CURLE_BAD_CONTENT_ENCODING:
      case CURLE_WRITE_ERROR:
        return DataLoss("{}: its answer cannot be decompressed", address);
      default:
        return absl::UnavailableError(message);
    }
  }

  const HttpRequest& request_;
  const HttpTimeouts timeouts_;
  const int64_t body_byte_limit_;
  const absl::Duration total_end_;
  const absl::Duration deadline_;
  // Since when the server is silent; infinite while connecting.
  absl::Duration silent_since_ = absl::InfiniteDuration();
  std::unique_ptr<curl_slist, CleanUp> header_list_;
  HttpResponse response_;
  int64_t header_byte_count_ = 0;
  int64_t body_byte_count_ = 0;
  // Why the transfer was ended from our side.
  absl::Status failure_;
  // Enough of the body of an error was read.
  bool enough_ = false;
  char error_text_[CURL_ERROR_SIZE] = {};
  // The last member: closing a handle may still call back.
  std::unique_ptr<CURL, CleanUp> handle_;
};

}  // namespace

class HttpClient::Connections {
 public:
  Connections() : multi_(curl_multi_init()) {}
  ~Connections() { curl_multi_cleanup(multi_); }

  absl::StatusOr<HttpResponse> Run(Transfer& transfer, runtime::CallContext& call) {
    if (transfer.handle() == nullptr || multi_ == nullptr ||
        curl_multi_add_handle(multi_, transfer.handle()) != CURLM_OK) {
      return absl::ResourceExhaustedError("no memory for an HTTP request");
    }
    const absl::StatusOr<CURLcode> code = Wait(transfer, call);
    // Closes the connection of a transfer that has not ended.
    curl_multi_remove_handle(multi_, transfer.handle());
    if (!code.ok()) return code.status();
    return transfer.Finish(*code);
  }

 private:
  absl::StatusOr<CURLcode> Wait(const Transfer& transfer, runtime::CallContext& call) {
    const runtime::OnCancel wake_up(call.cancellation(), [this] { curl_multi_wakeup(multi_); });
    while (true) {
      int running = 0;
      curl_multi_perform(multi_, &running);
      int left = 0;
      if (const CURLMsg* const message = curl_multi_info_read(multi_, &left)) return message->data.result;
      if (call.cancellation().cancelled()) return absl::CancelledError("the caller cancelled the call");
      const absl::Duration now = Now();
      RETURN_IF_ERROR(transfer.Expired(now));
      const absl::Duration wait = std::min(transfer.NextCheck(now) - now, absl::Seconds(1));
      curl_multi_poll(multi_, nullptr, 0, static_cast<int>(Milliseconds(wait)), nullptr);
    }
  }

  CURLM* const multi_;
};

HttpClient::HttpClient(HttpOptions options, const runtime::Clock& clock) : options_(std::move(options)), clock_(clock) {
  InitCurl();
}

HttpClient::~HttpClient() = default;

absl::StatusOr<HttpResponse> HttpClient::Send(const HttpRequest& request, runtime::CallContext& call) {
  RETURN_IF_ERROR(CheckRequest(request));
  RETURN_IF_ERROR(call.CheckAlive());
  const WithoutSigpipe without_sigpipe;
  Transfer transfer(request, options_, Now() + (call.deadline() - clock_.Now()));
  std::unique_ptr<Connections> connections = Borrow();
  absl::StatusOr<HttpResponse> response = connections->Run(transfer, call);
  GiveBack(std::move(connections));
  return response;
}

std::unique_ptr<HttpClient::Connections> HttpClient::Borrow() {
  const std::lock_guard lock(mutex_);
  if (idle_.empty()) return std::make_unique<Connections>();
  std::unique_ptr<Connections> last = std::move(idle_.back());
  idle_.pop_back();
  return last;
}

void HttpClient::GiveBack(std::unique_ptr<Connections> connections) {
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(connections));
}

}  // namespace flair::llm
