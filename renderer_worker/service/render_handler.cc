// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/service/render_handler.h"

#include <fmt/format.h>

#include "renderer_worker/service/render_plan.h"
#include "room/validation/validate.h"

namespace flair::renderer {
namespace {

// A plan is compressed many times over, so that its size is known when it is there.
absl::Status CheckAnswer(const v1::RenderResponse& response, int64_t answer_bytes) {
  const size_t size = response.ByteSizeLong();
  if (size <= static_cast<uint64_t>(answer_bytes)) return absl::OkStatus();
  return absl::ResourceExhaustedError(
      fmt::format("options: the picture's file takes {} MiB, and this renderer sends messages of {} MiB "
                  "(runtime.max_message_mib); ask for a smaller size_px or dpi, or PNG or JPEG",
                  size >> 20, answer_bytes >> 20));
}

}  // namespace

absl::StatusOr<v1::RenderResponse> RenderHandler::Handle(const v1::RenderRequest& request,
                                                         runtime::CallContext& call) const {
  if (absl::Status status = Validate(request); !status.ok()) return status;
  const v1::PreviewView view = request.options().view();
  const bool is_plan = view == v1::PREVIEW_VIEW_UNSPECIFIED || view == v1::PREVIEW_VIEW_PLAN;
  absl::StatusOr<v1::RenderResponse> response =
      is_plan ? RenderPlan(request, writer_, call) : RenderView(request, furnishing_, writer_, limits_, call);
  if (!response.ok()) return response;
  if (absl::Status status = CheckAnswer(*response, limits_.answer_bytes); !status.ok()) return status;
  return response;
}

}  // namespace flair::renderer
