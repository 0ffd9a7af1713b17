// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/pipeline/model_budget.h"

#include <algorithm>

namespace flair::orchestrator {

void AddUsage(const v1::Artifact& artifact, v1::ModelUsage& usage) {
  for (const v1::ModelCall& call : artifact.model_calls()) {
    const v1::ModelUsage& used = call.usage();
    usage.set_call_count(usage.call_count() + used.call_count());
    usage.set_input_token_count(usage.input_token_count() + used.input_token_count());
    usage.set_output_token_count(usage.output_token_count() + used.output_token_count());
    usage.set_cached_input_token_count(usage.cached_input_token_count() + used.cached_input_token_count());
    usage.set_estimated(usage.estimated() || used.estimated());
    usage.set_cost_usd(usage.cost_usd() + used.cost_usd());
  }
}

v1::ModelOptions OptionsLeft(const v1::ModelOptions& job_options, const v1::ModelUsage& spent) {
  v1::ModelOptions options = job_options;
  if (!options.has_budget()) return options;
  v1::ModelBudget& budget = *options.mutable_budget();
  if (budget.has_call_count()) budget.set_call_count(std::max(0, budget.call_count() - spent.call_count()));
  if (budget.has_token_count()) {
    const int64_t tokens = spent.input_token_count() + spent.output_token_count();
    budget.set_token_count(std::max<int64_t>(0, budget.token_count() - tokens));
  }
  if (budget.has_cost_usd()) budget.set_cost_usd(std::max(0.0, budget.cost_usd() - spent.cost_usd()));
  return options;
}

v1::ModelOptions DecidingOptions(const v1::ModelOptions& job_options) {
  v1::ModelOptions options = job_options;
  options.clear_budget();
  return options;
}

}  // namespace flair::orchestrator
