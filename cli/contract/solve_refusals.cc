// SPDX-License-Identifier: GPL-3.0-or-later
// Optimizer: what Solve must not take.
#include <cmath>

#include "cli/contract/bedroom.h"
#include "cli/contract/graph_faults.h"
#include "flair/v1/optimizer_service.pb.h"

namespace flair::contract {
namespace {

v1::SolveOptions& OptionsOf(v1::SolveRequest& request) { return *request.mutable_options(); }

std::vector<Fault<v1::SolveRequest>> OptionFaults() {
  using Request = v1::SolveRequest;
  return {
      {"a seed below zero", "options.seed", [](Request& request) { OptionsOf(request).set_seed(-1); }},
      {"no restarts", "options.max_restart_count",
       [](Request& request) { OptionsOf(request).set_max_restart_count(0); }},
      {"no threads", "options.thread_count", [](Request& request) { OptionsOf(request).set_thread_count(0); }},
      {"a path that is no number wide", "options.path_width_m",
       [](Request& request) { OptionsOf(request).set_path_width_m(std::nan("")); }},
      {"a factor below zero", "lambdas.no_overlap",
       [](Request& request) { OptionsOf(request).mutable_lambdas()->set_no_overlap(-1); }},
      {"no layouts wanted", "options.variant_count", [](Request& request) { OptionsOf(request).set_variant_count(0); }},
      {"a misfit policy that no enum has", "options.misfit_policy",
       [](Request& request) { OptionsOf(request).set_misfit_policy(static_cast<v1::MisfitPolicy>(99)); }},
      {"a time limit of zero", "options.time_limit",
       [](Request& request) { OptionsOf(request).mutable_time_limit()->set_seconds(0); }},
  };
}

}  // namespace

void AddSolveRefusals(Checks& checks) {
  v1::SolveRequest good;
  *good.mutable_layout_graph() = BedroomGraph();
  AddRefusals<v1::SolveResponse>(good, GraphFaultsIn(&v1::SolveRequest::mutable_layout_graph), checks);
  AddRefusals<v1::SolveResponse>(good, OptionFaults(), checks);
}

}  // namespace flair::contract
