#!/usr/bin/env bash
# usage: scripts/bench.sh [FILTER]
#
# Builds the release preset, measures every stage on real scans and on made ones of growing size, beside two yardsticks
# of the same run (one memcpy of the cloud, one std::atan2f per point), and prints what the methods get right, step by
# step. The benchmarks take turns at random and the tables show medians of CPU time, so that a noisy machine does less
# harm. FILTER is a regular expression on the names of benchmarks. Figures for programs go to build/release/bench.json.
# Example: scripts/bench.sh 'ground|yardstick'
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

case "${1:-}" in -h | --help) print_help && exit 0 ;; esac
command -v python3 >/dev/null || die "python3 is missing, it makes the tables: scripts/setup.sh --dev installs it"
configure_and_build release --target berm_bench berm_accuracy
BERM_DATA="$(data_dir)"
export BERM_DATA
"$repo_dir/build/release/bench/berm_bench" --benchmark_filter="${1:-.}" --benchmark_repetitions=7 \
  --benchmark_min_time=0.1 --benchmark_enable_random_interleaving=true --benchmark_report_aggregates_only=true \
  --benchmark_out="$repo_dir/build/release/bench.json" --benchmark_out_format=json >/dev/null
"$repo_dir/bench/table.py" "$repo_dir/build/release/bench.json"
echo
"$repo_dir/build/release/bench/berm_accuracy"
