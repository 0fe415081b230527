#pragma once

#include <memory>

#include "berm/core/config.hpp"
#include "berm/edge/edge.hpp"

namespace berm {

/// Settings of the published edge method: METHODS section 4.
struct RingEdgesConfig {
  int sectors = 360;

  static void fields(auto&& field) {
    field("sectors", &RingEdgesConfig::sectors, Range{16, 3600}, "of the polar grid over a full turn");
  }
  void check() const { check_fields(*this, "edge_reference"); }
};

/// Road edges as document E finds them (`--method edge=reference`).
class RingEdges final : public EdgeDetector {
 public:
  /// Throws ConfigError as `RingEdgesConfig::check`.
  explicit RingEdges(const RingEdgesConfig& config);
  ~RingEdges() override;

  [[nodiscard]] EdgeResult process(const EdgeInput& input) override;

 private:
  struct State;
  RingEdgesConfig config_;
  std::unique_ptr<State> state_;
};

}  // namespace berm
