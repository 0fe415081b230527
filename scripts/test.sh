#!/usr/bin/env bash
# usage: scripts/test.sh [arguments of ctest...]
#
# Installs what is missing, builds and runs all tests. Needs nothing but apt-get on a bare system.
# Tests on real recordings look for them in $BERM_DATA; without recordings they say so and are left out,
# unless BERM_REQUIRE_DATA=1: then they fail. Without arguments the pages are tried in Chromium as well, where it can be
# installed.
# Example: scripts/test.sh -R Pcd
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

case "${1:-}" in -h | --help) print_help && exit 0 ;; esac
"$repo_dir/scripts/setup.sh"
if [ $# -eq 0 ]; then "$repo_dir/scripts/setup.sh" --browser || echo "No browser: the pages are not tried in one." >&2; fi
configure_and_build release
if [ -z "$(data_dir)" ]; then echo "No recordings: the tests that need them are left out (set BERM_DATA)."; fi
code=0
if [ $# -eq 0 ]; then BERM_PROGRAM="$repo_dir/build/release/berm" "$repo_dir/scripts/web.sh" browser || code=1; fi
run_tests release "$@"
if [ "$code" -ne 0 ]; then die "the pages failed in the browser, see above"; fi
