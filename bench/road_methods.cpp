#include "road_methods.hpp"

#include <utility>

#include "berm/edge/ring_edges.hpp"
#include "berm/edge/trace_edges.hpp"

namespace berm::bench {
namespace {

RoadMethod changed(std::string name, const std::function<void(TraceEdgesConfig&)>& change) {
  TraceEdgesConfig config;
  change(config);
  return {.name = std::move(name),
          .make = [config] { return std::make_unique<TraceEdges>(config); },
          .map = {},
          .lines = {}};
}

}  // namespace

std::vector<RoadMethod> main_road_methods() {
  return {changed("default", [](TraceEdgesConfig&) {}),
          {.name = "reference",
           .make = [] { return std::make_unique<RingEdges>(RingEdgesConfig{}); },
           .map = {},
           .lines = {},
           .reference_map = true}};
}

std::vector<RoadMethod> road_methods_without_a_step() {
  using C = TraceEdgesConfig;
  return {changed("without sub_cell", [](C& c) { c.sub_cell = false; }),
          changed("without own_road", [](C& c) { c.own_road = false; }),
          changed("without face", [](C& c) { c.face = false; }),
          changed("without hide", [](C& c) { c.hide = false; }),
          changed("without agree", [](C& c) { c.agree = false; }),
          changed("without outline", [](C& c) { c.outline = false; }),
          changed("without find_drops", [](C& c) { c.find_drops = false; })};
}

}  // namespace berm::bench
