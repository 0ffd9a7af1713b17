// SPDX-License-Identifier: GPL-3.0-or-later
// Acts one after the other that are one act to whoever asked for them.
#pragma once

#include "session/acts/layout_acts.h"

namespace flair::session {

class Chain {
 public:
  // `first` must outlive it.
  explicit Chain(const Standing& first) : first_(first) {}
  Chain(const Chain&) = delete;
  Chain& operator=(const Chain&) = delete;

  // Where the next act begins, until then.
  Standing standing() const;
  const v1::SolvedLayout& shown() const { return any_ ? acted_.layout : first_.shown; }
  bool empty() const { return !any_; }

  void Add(Acted acted);
  // All of them; empty() must not hold.
  Acted Take();

 private:
  const Standing& first_;
  bool any_ = false, was_settled_ = false;
  Acted acted_;
  v1::SolvedLayout settled_;
};

}  // namespace flair::session
