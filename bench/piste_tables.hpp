#pragma once

#include <span>
#include <vector>

#include "piste_measure.hpp"
#include "piste_methods.hpp"
#include "piste_timing.hpp"

namespace berm::bench {

/// Every run by itself.
void print_runs(std::span<const RunResult> results);

/// Whether the bars of the accuracy hold; returns that. Also says where the default is the worse choice.
[[nodiscard]] bool print_bars(std::span<const RunResult> results);

/// Each method by itself: accuracy over the runs, and times; then whether the bar of the time holds, which a busy
/// computer can make it miss. `results` and `times` are in the order of `methods`.
void print_methods(std::span<const test::Method> methods, std::span<const RunResult> results,
                   std::span<const StageTimes> times);

/// Other sensors on the groomer: `results` of one after the other, `runs_each` of each.
void print_sensors(std::span<const RunResult> results, std::size_t runs_each);

/// Numbers of the settings halved and doubled; the scores of a key's two methods begin at `first` and follow each
/// other.
void print_keys(std::span<const VariedKey> keys, std::span<const RunResult> results, std::size_t first);

}  // namespace berm::bench
