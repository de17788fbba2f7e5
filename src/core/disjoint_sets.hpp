#pragma once
#include "base/index.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace breccia {

/// Which of n things hang together; each set goes by its smallest member.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }

  Index root(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void join(Index a, Index b) {
    const Index ra = root(a), rb = root(b);
    parent_[std::max(ra, rb)] = std::min(ra, rb);
  }

 private:
  std::vector<Index> parent_;
};

}  // namespace breccia
