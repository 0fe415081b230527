#include "berm/edge/ring_edges.hpp"

namespace berm {

struct RingEdges::State {};

RingEdges::RingEdges(const RingEdgesConfig& config) : config_(config), state_(std::make_unique<State>()) {
  config_.check();
}

RingEdges::~RingEdges() = default;

EdgeResult RingEdges::process(const EdgeInput& /*input*/) {
  return {};
}

}  // namespace berm
