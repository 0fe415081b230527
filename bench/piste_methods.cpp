#include "piste_methods.hpp"

#include <functional>
#include <string_view>
#include <type_traits>

#include "berm/io/field_access.hpp"

namespace berm::bench {
namespace {

using test::FrontEnd;
using test::Method;

Method variant(const std::string& name, const std::function<void(BoundaryPisteConfig&)>& change) {
  Method method{.name = name, .front = {}, .piste = "default", .config = {}};
  change(method.config);
  return method;
}

Method after(const std::string& name, const FrontEnd& front) {
  return {.name = name, .front = front, .piste = "default", .config = {}};
}

template <typename Value>
Method with_value(const std::string& name, Value BoundaryPisteConfig::*member, Value value) {
  return variant(name, [member, value](BoundaryPisteConfig& config) { config.*member = value; });
}

}  // namespace

std::vector<Method> main_methods() {
  return {{.name = "baseline: all ground is piste", .front = {}, .piste = "none", .config = {}},
          {.name = "reference: method P",
           .front = {.snow = "reference", .ground = "default", .shuffled = false},
           .piste = "reference",
           .config = {}},
          after("default", {})};
}

std::vector<Method> methods_without_a_step() {
  using C = BoundaryPisteConfig;
  return {
      variant("without height (use_height)", [](C& c) { c.use_height = false; }),
      variant("without slope (use_slope)", [](C& c) { c.use_slope = false; }),
      variant("without roughness (use_roughness)", [](C& c) { c.use_roughness = false; }),
      variant("without obstacles (use_obstacles)", [](C& c) { c.use_obstacles = false; }),
      variant("without adapt", [](C& c) { c.adapt = false; }),
      variant("one pass (passes 1)", [](C& c) { c.passes = 1; }),
      variant("each bearing by itself (jump_cost 0)", [](C& c) { c.jump_cost = 0.0; }),
      after("no firing order (shuffled points)", {.snow = "default", .ground = "default", .shuffled = true}),
      after("without snow stage (snow none)", {.snow = "none", .ground = "default", .shuffled = false}),
      after("after snow reference", {.snow = "reference", .ground = "default", .shuffled = false}),
      after("on ground reference", {.snow = "default", .ground = "reference", .shuffled = false}),
  };
}

std::vector<VariedKey> varied_keys() {
  std::vector<VariedKey> keys;
  BoundaryPisteConfig::fields(EachField{[&keys](std::string_view key, auto member, const std::string& /*allowed*/,
                                                const auto& /*find*/, std::string_view /*text*/) {
    using Value = std::remove_cvref_t<decltype(BoundaryPisteConfig{}.*member)>;
    if constexpr (!std::is_same_v<Value, bool>) {
      const Value value = BoundaryPisteConfig{}.*member;
      const std::string name(key);
      keys.push_back({.key = name,
                      .value = static_cast<double>(value),
                      .halved = with_value(name + " halved", member, static_cast<Value>(value / 2)),
                      .doubled = with_value(name + " doubled", member, static_cast<Value>(value * 2))});
    }
  }});
  return keys;
}

}  // namespace berm::bench
