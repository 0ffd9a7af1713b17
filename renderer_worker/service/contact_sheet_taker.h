// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/renderer_service.pb.h"
#include "renderer_worker/contact_sheet/contact_sheet.h"
#include "renderer_worker/images/image_files.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::renderer {

// Sheets that a renderer draws at the same time: each keeps its pixels while its tiles come, however slowly.
inline constexpr int kMostOpenSheets = 8;

// One call of RendererService.ComposeContactSheet. A tile that cannot be drawn shows why in its place and is told in
// the diagnostics. Errors, which end the call: INVALID_ARGUMENT for messages out of order, too many or too few tiles,
// and tiles that do not fit; RESOURCE_EXHAUSTED when kMostOpenSheets are being drawn.
class ContactSheetTaker {
 public:
  // Both must outlive it; `open_sheets` counts those of all calls.
  ContactSheetTaker(ImageWriter& writer, std::atomic<int>& open_sheets);
  ~ContactSheetTaker();
  ContactSheetTaker(const ContactSheetTaker&) = delete;
  ContactSheetTaker& operator=(const ContactSheetTaker&) = delete;

  absl::Status Take(const v1::ComposeContactSheetRequest& request, runtime::CallContext& call);
  absl::StatusOr<v1::ComposeContactSheetResponse> Finish(runtime::CallContext& call);

 private:
  absl::Status Begin(const v1::ContactSheetOptions& options);
  absl::Status Add(const v1::ContactSheetTile& tile);

  ImageWriter& writer_;
  std::atomic<int>& open_sheets_;
  const int open_count_;
  int message_count_ = 0;
  v1::PreviewFormat format_ = v1::PREVIEW_FORMAT_PNG;
  std::string title_;
  SheetGrid grid_;
  std::unique_ptr<ContactSheet> sheet_;
  std::vector<v1::Diagnostic> diagnostics_;
};

}  // namespace flair::renderer
