#include "chain_score.hpp"

#include <algorithm>
#include <memory>
#include <numeric>
#include <random>

namespace berm::test {
namespace {

template <typename Value>
std::vector<Value> pick(std::span<const Value> values, const std::vector<std::size_t>& order) {
  std::vector<Value> picked;
  if (!values.empty()) {
    picked.reserve(order.size());
    for (const std::size_t i : order) {
      picked.push_back(values[i]);
    }
  }
  return picked;
}

/// The same points in an order that means nothing.
LabelledScan shuffle(const LabelledScan& scan) {
  std::vector<std::size_t> order(scan.truth.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::mt19937 random(1);
  for (std::size_t i = order.size(); i > 1; --i) {
    std::swap(order[i - 1], order[random() % i]);
  }
  const PointsView points = scan.scan.cloud.view();
  LabelledScan shuffled;
  shuffled.scan.stamp_ns = scan.scan.stamp_ns;
  shuffled.scan.T_base_sensor = scan.scan.T_base_sensor;
  shuffled.scan.cloud = PointCloud({.x = pick(points.x, order),
                                    .y = pick(points.y, order),
                                    .z = pick(points.z, order),
                                    .intensity = pick(points.intensity, order),
                                    .time = pick(points.time, order),
                                    .ring = pick(points.ring, order),
                                    .label = {}});
  shuffled.truth = pick(std::span<const std::uint32_t>(scan.truth), order);
  return shuffled;
}

Machine machine_before_piste(const FrontEnd& front) {
  Machine machine;
  machine.methods = {.snow = front.snow, .ground = front.ground, .piste = "none"};
  return machine;
}

std::vector<std::uint32_t> raw_labels(std::span<const Label> labels) {
  std::vector<std::uint32_t> raw(labels.size());
  std::transform(labels.begin(), labels.end(), raw.begin(), semantic_kitti_id);
  return raw;
}

}  // namespace

Machine machine_of(const Method& method) {
  Machine machine = machine_before_piste(method.front);
  machine.methods.piste = method.piste;
  machine.piste = method.config;
  return machine;
}

std::vector<FrontEnd> front_ends_of(std::span<const Method> methods) {
  std::vector<FrontEnd> fronts;
  for (const Method& method : methods) {
    if (std::find(fronts.begin(), fronts.end(), method.front) == fronts.end()) {
      fronts.push_back(method.front);
    }
  }
  return fronts;
}

FrontEndPass::FrontEndPass(const FrontEnd& front) : shuffled_(front.shuffled), pipeline_(machine_before_piste(front)) {}

void FrontEndPass::prepare(const LabelledScan& scan, PreparedScan& prepared) {
  prepared.input = shuffled_ ? shuffle(scan) : scan;
  const ScanResult result = pipeline_.process(prepared.input.scan);
  prepared.labels.assign(result.labels.begin(), result.labels.end());
  prepared.falling.resize(result.labels.size());
  std::transform(result.labels.begin(), result.labels.end(), prepared.falling.begin(),
                 [](Label label) { return label == Label::falling_snow ? std::uint8_t{1} : std::uint8_t{0}; });
  prepared.surface = result.surface != nullptr ? std::optional(*result.surface) : std::nullopt;
}

PisteStage::PisteStage(const Method& method) : piste_(make_piste(machine_of(method))) {}

std::span<const Label> PisteStage::process(const PreparedScan& scan) {
  if (!piste_) {
    return scan.labels;
  }
  const PointsView points = scan.input.scan.cloud.view();
  PisteInput input{.points = points,
                   .labels = scan.labels,
                   .series = {},
                   .surface = scan.surface ? &*scan.surface : nullptr,
                   .T_base_sensor = scan.input.scan.T_base_sensor};
  if (piste_->needs_series()) {
    input.series = repair_.process(points, scan.falling);
  }
  return piste_->process(input).labels;
}

Score& Score::operator+=(const Score& other) {
  piste += other.piste;
  snow += other.snow;
  return *this;
}

std::vector<std::uint8_t> find_returns(const PointsView& points) {
  std::vector<std::uint8_t> is_return(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    is_return[i] = is_no_return(points.x[i], points.y[i], points.z[i]) ? 0 : 1;
  }
  return is_return;
}

Score score_labels(std::span<const Label> labels, const LabelledScan& scan) {
  const std::vector<std::uint32_t> output = raw_labels(labels);
  return {.piste = judge_piste(output, scan.truth),
          .snow = judge_snow(output, scan.truth, find_returns(scan.scan.cloud.view()))};
}

std::vector<Score> score_methods(std::span<const Method> methods, std::span<const LabelledScan> scans) {
  std::vector<Score> scores(methods.size());
  for (const FrontEnd& front : front_ends_of(methods)) {
    FrontEndPass pass(front);
    std::vector<std::pair<std::size_t, std::unique_ptr<PisteStage>>> stages;
    for (std::size_t i = 0; i < methods.size(); ++i) {
      if (methods[i].front == front) {
        stages.emplace_back(i, std::make_unique<PisteStage>(methods[i]));
      }
    }
    PreparedScan prepared;
    for (const LabelledScan& scan : scans) {
      pass.prepare(scan, prepared);
      for (const auto& [method, stage] : stages) {
        scores[method] += score_labels(stage->process(prepared), prepared.input);
      }
    }
  }
  return scores;
}

}  // namespace berm::test
