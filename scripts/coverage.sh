#!/usr/bin/env bash
# usage: scripts/coverage.sh [FLOOR]
#
# Runs the tests with coverage counters and prints the share of lines of src and include that they reach, per
# file. Fails below FLOOR percent (default 85). Page to browse: build/coverage/coverage.html
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

case "${1:-}" in
  -h | --help) print_help && exit 0 ;;
  *[!0-9]*) wrong_usage "FLOOR is a whole number of percent, not $1" ;;
esac
floor="${1:-85}"
gcovr="$(find_tool gcovr)" || die "gcovr is missing: scripts/setup.sh --dev installs it"

configure_and_build coverage
find "$repo_dir/build/coverage" -name '*.gcda' -delete
run_tests coverage
cd "$repo_dir"
"$gcovr" --root . --filter 'src/' --filter 'include/' --exclude-throw-branches --print-summary \
  --txt --html-details build/coverage/coverage.html --fail-under-line "$floor" build/coverage
