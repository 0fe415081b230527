#include "road_methods.hpp"

#include <utility>

#include "berm/io/settings.hpp"

namespace berm::bench {

RoadMethod road_method(std::string name, const std::vector<std::string>& changes) {
  RoadMethod method{.name = std::move(name), .settings = {}};
  for (const std::string& change : changes) {
    (void)set_value(method.settings, change, method.name);
  }
  method.settings.check();
  return method;
}

std::vector<RoadMethod> main_road_methods() {
  return {road_method("default", {}), {.name = "reference: method E", .settings = {}, .is_reference = true}};
}

std::vector<RoadMethod> dust_methods() {
  RoadMethod bare = road_method("no snow stage", {});
  bare.with_snow = false;
  return {road_method("default", {}), bare};
}

std::vector<RoadMethod> changed_road_methods() {
  std::vector<RoadMethod> methods;
  for (const char* step : {"across", "sub_cell", "own_road", "face", "hide", "agree", "outline", "find_drops"}) {
    methods.push_back(road_method(std::string("without ") + step, {std::string("edge.") + step + "=false"}));
  }
  methods.push_back(road_method("gaps are not crossed", {"lines.max_gap_m=0.1", "lines.max_hidden_m=0.1"}));
  for (const char* change : {"edge.min_height_m=0.15", "edge.min_radius_m=80"}) {
    methods.push_back(road_method(change, {change}));
  }
  return methods;
}

}  // namespace berm::bench
