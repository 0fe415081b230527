#include "berm/pipeline/pipeline.hpp"

#include <algorithm>

#include "berm/ground/polar_ground.hpp"
#include "berm/ground/terrain_ground.hpp"

namespace berm {
namespace {

Label to_label(GroundClass ground) {
  switch (ground) {
    case GroundClass::ground:
      return Label::drivable;
    case GroundClass::not_ground:
      return Label::obstacle;
    case GroundClass::no_return:
      return Label::no_return;
    case GroundClass::invalid:
      break;
  }
  return Label::unlabeled;
}

}  // namespace

std::unique_ptr<GroundSegmenter> make_ground(const Machine& machine) {
  machine.methods.check();
  if (machine.methods.ground == "reference") {
    return std::make_unique<PolarGround>(machine.ground_reference);
  }
  return std::make_unique<TerrainGround>(machine.ground);
}

Pipeline::Pipeline(const Machine& machine) : ground_(make_ground(machine)) {}

ScanLabels Pipeline::process(const Scan& scan) {
  const GroundResult result = ground_->process(scan.cloud.view(), scan.T_base_sensor);
  labels_.resize(result.classes.size());
  std::transform(result.classes.begin(), result.classes.end(), labels_.begin(), to_label);
  return {.labels = labels_, .ground = result.counts};
}

}  // namespace berm
