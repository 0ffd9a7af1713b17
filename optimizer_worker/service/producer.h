// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "flair/v1/provenance.pb.h"

namespace flair::optimizer {

// Who made a layout. Raise the version whenever equal inputs would give another layout.
inline v1::Producer OptimizerProducer() {
  v1::Producer producer;
  producer.set_program("flair-optimizer");
  producer.set_method("slsqp");
  producer.set_version("1");
  return producer;
}

}  // namespace flair::optimizer
