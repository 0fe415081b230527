#include "piste_timing.hpp"

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <memory>

namespace berm::bench {
namespace {

constexpr std::size_t kRounds = 15;

/// The scans as they leave a front end.
struct PreparedFront {
  test::FrontEnd front;
  std::vector<test::PreparedScan> scans;
};

PreparedFront prepare(const test::FrontEnd& front, std::span<const test::LabelledScan> scans) {
  PreparedFront prepared{front, std::vector<test::PreparedScan>(scans.size())};
  test::FrontEndPass pass(front);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    pass.prepare(scans[i], prepared.scans[i]);
  }
  return prepared;
}

struct TimedMethod {
  const PreparedFront* input;
  bool has_piste;
  std::unique_ptr<SnowFilter> snow;
  test::PisteStage piste;
  std::vector<double> snow_ms;
  std::vector<double> piste_ms;
};

template <typename Body>
double cpu_ms(const Body& body) {
  const std::clock_t start = std::clock();
  body();
  return 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

void run_round(double per_10k, TimedMethod& method) {
  if (method.snow) {
    method.snow_ms.push_back(per_10k * cpu_ms([&method] {
                               for (const test::PreparedScan& scan : method.input->scans) {
                                 const Scan& input = scan.input.scan;
                                 (void)method.snow->process(input.cloud.view(), input.T_base_sensor);
                               }
                             }));
  }
  if (method.has_piste) {
    method.piste_ms.push_back(per_10k * cpu_ms([&method] {
                                for (const test::PreparedScan& scan : method.input->scans) {
                                  (void)method.piste.process(scan);
                                }
                              }));
  }
}

double median(std::vector<double>& values) {
  if (values.empty()) {
    return 0.0;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

std::vector<StageTimes> time_methods(std::span<const test::Method> methods, std::span<const test::LabelledScan> scans) {
  std::vector<PreparedFront> fronts;
  for (const test::FrontEnd& front : test::front_ends_of(methods)) {
    fronts.push_back(prepare(front, scans));
  }
  std::vector<TimedMethod> timed;
  for (const test::Method& method : methods) {
    const auto input = std::find_if(fronts.begin(), fronts.end(),
                                    [&method](const PreparedFront& front) { return front.front == method.front; });
    timed.push_back({.input = &*input,
                     .has_piste = method.piste != "none",
                     .snow = make_snow(test::machine_of(method)),
                     .piste = test::PisteStage(method),
                     .snow_ms = {},
                     .piste_ms = {}});
  }
  std::size_t points = 0;
  for (const test::LabelledScan& scan : scans) {
    points += scan.truth.size();
  }
  for (std::size_t round = 0; round < kRounds; ++round) {
    for (TimedMethod& method : timed) {
      run_round(1e4 / static_cast<double>(points), method);
    }
  }
  std::vector<StageTimes> times;
  times.reserve(timed.size());
  for (TimedMethod& method : timed) {
    times.push_back({median(method.snow_ms), median(method.piste_ms)});
  }
  return times;
}

}  // namespace berm::bench
