#include "chain_covariance.hpp"

#include <Eigen/Cholesky>

namespace berm {

ChainInformation::ChainInformation(std::size_t nodes)
    : own_(nodes, Matrix6d::Zero()), beside_(nodes > 0 ? nodes - 1 : 0, Matrix6d::Zero()) {}

void ChainInformation::add_link(std::size_t first, const Matrix6d& by_first, const Matrix6d& by_second) {
  own_[first] += by_first.transpose() * by_first;
  own_[first + 1] += by_second.transpose() * by_second;
  beside_[first] += by_first.transpose() * by_second;
}

std::vector<Matrix6d> ChainInformation::covariances() const {
  const std::size_t n = own_.size();
  std::vector<Matrix6d> before(n, Matrix6d::Zero());  // what the nodes before take away from the own information
  for (std::size_t i = 1; i < n; ++i) {
    const Matrix6d rest = own_[i - 1] - before[i - 1];
    before[i] = beside_[i - 1].transpose() * rest.ldlt().solve(beside_[i - 1]);
  }
  std::vector<Matrix6d> result(n);
  Matrix6d after = Matrix6d::Zero();
  for (std::size_t i = n; i-- > 0;) {
    result[i] = (own_[i] - before[i] - after).ldlt().solve(Matrix6d::Identity());
    result[i] = 0.5 * (result[i] + result[i].transpose()).eval();
    if (i > 0) {
      after = beside_[i - 1] * (own_[i] - after).ldlt().solve(beside_[i - 1].transpose());
    }
  }
  return result;
}

}  // namespace berm
