// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/service/render_metrics.h"

#include <string>

#include "absl/strings/ascii.h"
#include "absl/strings/strip.h"

namespace flair::renderer {
namespace {

constexpr runtime::MetricFamily kDuration{.kind = runtime::MetricKind::kHistogram,
                                          .name = "flair_render_duration_seconds",
                                          .help = "Time to draw or trace a picture and to encode it.",
                                          .labels = {"view"},
                                          .buckets = runtime::kSecondsBuckets};

// "plan", "bird_eye" ...; a plan when nothing is asked for.
std::string ViewName(v1::PreviewView view) {
  if (view == v1::PREVIEW_VIEW_UNSPECIFIED) view = v1::PREVIEW_VIEW_PLAN;
  return absl::AsciiStrToLower(absl::StripPrefix(v1::PreviewView_Name(view), "PREVIEW_VIEW_"));
}

}  // namespace

RenderMetrics::RenderMetrics(runtime::Metrics& metrics) : metrics_(metrics) { metrics.Declare(kDuration); }

void RenderMetrics::operator()(const v1::RenderRequest& request, const v1::RenderResponse&,
                               absl::Duration duration) const {
  metrics_.GetHistogram(kDuration, {ViewName(request.options().view())}).Observe(absl::ToDoubleSeconds(duration));
}

}  // namespace flair::renderer
