#pragma once

#include <memory>

#include "berm/core/config.hpp"
#include "berm/piste/piste.hpp"

namespace berm {

/// Settings of the default piste method.
struct BoundaryPisteConfig {
  double max_range_m = 80.0;

  static void fields(auto&& field) {
    field("max_range_m", &BoundaryPisteConfig::max_range_m, Range{5.0, 500.0}, "the boundary is looked for this far");
  }
  void check() const { check_fields(*this, "piste"); }
};

/// The default piste method (`--method piste=default`).
class BoundaryPiste final : public PisteSegmenter {
 public:
  /// Throws ConfigError as `BoundaryPisteConfig::check`.
  explicit BoundaryPiste(const BoundaryPisteConfig& config);
  ~BoundaryPiste() override;

  [[nodiscard]] PisteResult process(const PisteInput& input) override;

 private:
  struct State;
  BoundaryPisteConfig config_;
  std::unique_ptr<State> state_;
};

}  // namespace berm
