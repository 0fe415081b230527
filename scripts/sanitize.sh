#!/usr/bin/env bash
# usage: scripts/sanitize.sh [asan-ubsan|tsan]... [-- arguments of ctest...]
#
# Builds with the address and undefined-behaviour sanitizers, then with the thread sanitizer, and runs the tests
# under each. Default: both, all tests.
# Example: scripts/sanitize.sh asan-ubsan -- -R Pcd
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

presets=()
while [ $# -gt 0 ]; do
  case "$1" in
    -h | --help) print_help && exit 0 ;;
    asan-ubsan | tsan) presets+=("$1") ;;
    --) shift && break ;;
    *) wrong_usage "unknown argument $1" ;;
  esac
  shift
done
if [ ${#presets[@]} -eq 0 ]; then presets=(asan-ubsan tsan); fi

for preset in "${presets[@]}"; do
  say "$preset"
  configure_and_build "$preset"
  run_tests "$preset" "$@"
done
