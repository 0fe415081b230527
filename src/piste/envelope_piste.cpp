#include "berm/piste/envelope_piste.hpp"

#include <vector>

namespace berm {

struct EnvelopePiste::State {
  std::vector<Label> labels;
};

EnvelopePiste::EnvelopePiste(const EnvelopePisteConfig& config) : config_(config), state_(std::make_unique<State>()) {
  config_.check();
}

EnvelopePiste::~EnvelopePiste() = default;

PisteResult EnvelopePiste::process(const PisteInput& input) {
  state_->labels.assign(input.labels.begin(), input.labels.end());
  PisteResult result;
  result.labels = state_->labels;
  return result;
}

}  // namespace berm
