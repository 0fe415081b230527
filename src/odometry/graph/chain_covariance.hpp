#pragma once

#include <cstddef>
#include <vector>

#include "berm/odometry/odometry.hpp"

namespace berm {

/// The information of a chain of nodes, each linked to the next: a matrix with blocks on and beside the diagonal.
class ChainInformation {
 public:
  explicit ChainInformation(std::size_t nodes);

  void add(std::size_t node, const Matrix6d& information) { own_[node] += information; }
  /// Of a residual on nodes `first` and `first` + 1, by its whitened Jacobians.
  void add_link(std::size_t first, const Matrix6d& by_first, const Matrix6d& by_second);

  /// The covariance of every node: the diagonal blocks of the inverse, by eliminating from both ends.
  [[nodiscard]] std::vector<Matrix6d> covariances() const;

 private:
  std::vector<Matrix6d> own_;
  std::vector<Matrix6d> beside_;  ///< of i and i + 1
};

}  // namespace berm
