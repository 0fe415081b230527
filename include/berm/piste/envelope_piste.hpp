#pragma once

#include <memory>

#include "berm/core/config.hpp"
#include "berm/piste/piste.hpp"

namespace berm {

/// Settings of the published piste method: METHODS sections 2 and 3, P eqs. 2-9.
struct EnvelopePisteConfig {
  double z_step_m = 0.05;
  double x_step_m = 0.05;

  static void fields(auto&& field) {
    field("z_step_m", &EnvelopePisteConfig::z_step_m, Range{0.001, 10.0}, "z_th of P eq. 3");
    field("x_step_m", &EnvelopePisteConfig::x_step_m, Range{0.001, 10.0}, "x_th of P eq. 6");
  }
  void check() const { check_fields(*this, "piste_reference"); }
};

/// The piste as document P finds it (`--method piste=reference`): within a petal everything from the first to the
/// last step of the waveform is an obstacle, all else piste.
class EnvelopePiste final : public PisteSegmenter {
 public:
  /// Throws ConfigError as `EnvelopePisteConfig::check`.
  explicit EnvelopePiste(const EnvelopePisteConfig& config);
  ~EnvelopePiste() override;

  [[nodiscard]] PisteResult process(const PisteInput& input) override;

 private:
  struct State;
  EnvelopePisteConfig config_;
  std::unique_ptr<State> state_;
};

}  // namespace berm
