// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/openai/reply_reader.h"

#include <fmt/format.h>

#include "absl/strings/ascii.h"
#include "llm/openai/json_fields.h"

namespace flair::llm {
namespace {

constexpr std::string_view kSpace = " \t\r\n";
constexpr size_t kKeptByteLimit = 16 << 20;

}  // namespace

absl::Status ReplyReader::Take(std::string_view piece) {
  if (absl::Status status = TakePiece(piece); !status.ok()) return status;
  const size_t kept = whole_.size() + sse_.kept_byte_count() + completion_.text_byte_count();
  return kept <= kKeptByteLimit ? absl::OkStatus() : NotOfTheProtocol("an answer of more than 16 MiB");
}

absl::Status ReplyReader::TakePiece(std::string_view piece) {
  if (kind_ == Kind::kUnknown) {
    const size_t begin = piece.find_first_not_of(kSpace);
    if (begin == std::string_view::npos) return absl::OkStatus();
    const bool whole = piece[begin] == '{' || piece[begin] == '[' || piece[begin] == '<';
    kind_ = whole ? Kind::kWhole : Kind::kEvents;
    // As if it had come in a piece of its own.
    piece.remove_prefix(begin);
  }
  if (kind_ == Kind::kWhole) {
    whole_ += piece;
    return absl::OkStatus();
  }
  return sse_.Take(piece, [this](std::string_view data) { return TakeEvent(data); });
}

absl::StatusOr<ChatAnswer> ReplyReader::FinishStream(const std::string& model) {
  if (kind_ != Kind::kEvents) return Read(whole_, model);
  const absl::Status status = sse_.Finish([this](std::string_view data) { return TakeEvent(data); });
  if (!status.ok()) return status;
  if (!done_ && !completion_.finished()) {
    return absl::UnavailableError(fmt::format("{}: the stream of the answer ended early", address_));
  }
  return ToAnswer(model);
}

absl::StatusOr<ChatAnswer> ReplyReader::Read(std::string_view body, const std::string& model) {
  const size_t begin = body.find_first_not_of(kSpace);
  if (begin == std::string_view::npos) return NotOfTheProtocol("an empty body");
  if (body[begin] == '<') return NotOfTheProtocol("HTML instead of an answer; is the base address right?");
  if (auto status = Add(body); !status.ok()) return status;
  return ToAnswer(model);
}

absl::Status ReplyReader::TakeEvent(std::string_view data) {
  if (done_) return absl::OkStatus();
  if (data.find_first_not_of(kSpace) == std::string_view::npos) return absl::OkStatus();
  if (data == "[DONE]") {
    done_ = true;
    return absl::OkStatus();
  }
  return AddPlainDelta(data) ? absl::OkStatus() : Add(data);
}

bool ReplyReader::AddPlainDelta(std::string_view json_text) {
  if (const auto text = repeated_.Text(json_text)) return completion_.AddText(*text, repeated_.thought());
  const auto piece = PlainDelta(json_text);
  if (!piece.has_value()) return false;
  repeated_.Learn(json_text, *piece);
  if (const auto text = PlainText(piece->string)) return completion_.AddText(*text, piece->thought);
  const nlohmann::json text = ParseJson(piece->string);
  return text.is_string() && completion_.AddText(text.get_ref<const std::string&>(), piece->thought);
}

absl::Status ReplyReader::Add(std::string_view json_text) {
  const nlohmann::json object = ParseJson(json_text);
  if (object.is_discarded()) return NotOfTheProtocol("a reply that is not JSON");
  if (ErrorInside(object) != nullptr) {
    const ServerError error = ReadServerError(json_text);
    return StatusOf(HttpStatusOf(error), error, fmt::format("{}: an error inside the reply", address_), confidential_);
  }
  const absl::Status added = completion_.Add(object);
  return added.ok() ? added : NotOfTheProtocol(std::string_view(added.message().data(), added.message().size()));
}

absl::StatusOr<ChatAnswer> ReplyReader::ToAnswer(const std::string& model) const {
  auto answer = completion_.ToAnswer(request_, model);
  if (answer.ok()) return answer;
  return NotOfTheProtocol(std::string_view(answer.status().message().data(), answer.status().message().size()));
}

absl::Status ReplyReader::NotOfTheProtocol(std::string_view what) const {
  return absl::DataLossError(fmt::format("{}: {}", address_, what));
}

}  // namespace flair::llm
