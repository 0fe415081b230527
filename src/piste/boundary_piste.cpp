#include "berm/piste/boundary_piste.hpp"

#include <vector>

namespace berm {

struct BoundaryPiste::State {
  std::vector<Label> labels;
};

BoundaryPiste::BoundaryPiste(const BoundaryPisteConfig& config) : config_(config), state_(std::make_unique<State>()) {
  config_.check();
}

BoundaryPiste::~BoundaryPiste() = default;

PisteResult BoundaryPiste::process(const PisteInput& input) {
  state_->labels.assign(input.labels.begin(), input.labels.end());
  PisteResult result;
  result.labels = state_->labels;
  return result;
}

}  // namespace berm
