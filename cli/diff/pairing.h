// SPDX-License-Identifier: GPL-3.0-or-later
// Which things of two lists are the same thing.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "flair/v1/layout_graph.pb.h"

namespace flair::cli {

// Indices in A and B; -1 where there is none.
struct Pair {
  int a = -1;
  int b = -1;
};

// Pairs things whose keys are equal, for each key in turn among those that are left; several of one key in their order.
// All of A in its order, then what only B has. A key is a function from a thing to text; empty text pairs nothing.
template <typename List, typename... Keys>
std::vector<Pair> MatchThings(const List& a, const List& b, const Keys&... keys) {
  const int count_a = static_cast<int>(a.size()), count_b = static_cast<int>(b.size());
  std::vector<int> of_a(count_a, -1), of_b(count_b, -1);
  const auto match = [&](const auto& key) {
    std::map<std::string, std::vector<int>> left;
    for (int j = count_b - 1; j >= 0; --j) {
      if (of_b[j] < 0) left[key(b[j])].push_back(j);
    }
    left.erase("");
    for (int i = 0; i < count_a; ++i) {
      if (of_a[i] >= 0) continue;
      const auto found = left.find(key(a[i]));
      if (found == left.end() || found->second.empty()) continue;
      of_a[i] = found->second.back();
      of_b[of_a[i]] = i;
      found->second.pop_back();
    }
  };
  (match(keys), ...);
  std::vector<Pair> pairs;
  for (int i = 0; i < count_a; ++i) pairs.push_back({i, of_a[i]});
  for (int j = 0; j < count_b; ++j) {
    if (of_b[j] < 0) pairs.push_back({-1, j});
  }
  return pairs;
}

// Which objects and calls of two graphs are the same.

// Objects by id, then by name, kind and zone, then by name and kind: other ids for the same things are no difference.
std::vector<Pair> PairObjects(const v1::ObjectList& a, const v1::ObjectList& b);

// Calls by what they say and the sentence that says so, then by what they say, then by id and type. Ids of calls are
// mere numbers: one call more in front changes them all.
std::vector<Pair> PairCalls(const v1::LayoutGraph& a, const v1::LayoutGraph& b);

// Sentences by their words, then by id.
std::vector<Pair> PairSentences(const v1::ConstraintList& a, const v1::ConstraintList& b);

// A call as it is written, without its weight.
std::string BareCall(const v1::ConstraintEdge& edge);

}  // namespace flair::cli
