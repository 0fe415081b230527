#!/usr/bin/env bash
# usage: scripts/bench.sh [FILTER]
#
# Builds the release preset and measures every stage on real scans and on made ones of growing size, beside two
# yardsticks of the same run: one memcpy of the cloud and one std::atan2f per point. FILTER is a regular expression on names.
# Figures for machines go to build/release/bench.json.
# Example: scripts/bench.sh ground
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

case "${1:-}" in -h | --help) print_help && exit 0 ;; esac
configure_and_build release
BERM_DATA="$(data_dir)"
export BERM_DATA
"$repo_dir/build/release/bench/berm_bench" --benchmark_filter="${1:-.}" \
  --benchmark_out="$repo_dir/build/release/bench.json" --benchmark_out_format=json
