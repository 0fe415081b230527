#pragma once

#include <string>
#include <vector>

#include "support/chain_score.hpp"

namespace berm::bench {

/// Places of the methods that are in every table.
inline constexpr std::size_t kBaseline = 0;
inline constexpr std::size_t kReference = 1;
inline constexpr std::size_t kDefault = 2;

/// All ground of the default ground is piste; the published methods of snow and piste; the default.
[[nodiscard]] std::vector<test::Method> main_methods();

/// The default with each step switched off in turn.
[[nodiscard]] std::vector<test::Method> methods_without_a_step();

/// A number of the default piste method's settings, and the default with other values of it.
struct VariedKey {
  std::string key;
  double value = 0.0;
  test::Method halved;
  test::Method doubled;
};
[[nodiscard]] std::vector<VariedKey> varied_keys();

}  // namespace berm::bench
