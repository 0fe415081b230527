#!/usr/bin/env bash
# usage: scripts/fuzz.sh [SECONDS] [TARGET]...
#
# Builds the fuzz targets with clang (address and undefined-behaviour sanitizers on) and runs each for SECONDS
# (default 60), or only those that are named. What it finds of interest grows in build/fuzz/corpus/TARGET; an input that
# breaks a parser is left in build/fuzz/crashes and makes the script fail.
# Example: scripts/fuzz.sh 600 fuzz_pcd
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

case "${1:-}" in
  -h | --help) print_help && exit 0 ;;
  *[!0-9]*) wrong_usage "SECONDS is a whole number, not $1" ;;
esac
seconds="${1:-60}"
if [ $# -gt 0 ]; then shift; fi

configure_and_build fuzz
build="$repo_dir/build/fuzz"
mkdir -p "$build/crashes"
targets=("$@")
if [ ${#targets[@]} -eq 0 ]; then
  mapfile -t targets < <(find "$build/tests/fuzz" -maxdepth 1 -type f -perm -u+x -name 'fuzz_*' -printf '%f\n' | sort)
fi
if [ ${#targets[@]} -eq 0 ]; then die "no fuzz targets in $build/tests/fuzz"; fi

failed=()
for target in "${targets[@]}"; do
  say "$target, $seconds s"
  corpus="$build/corpus/$target"
  seeds="$repo_dir/tests/fuzz/corpus/${target#fuzz_}"
  mkdir -p "$corpus"
  folders=("$corpus")
  if [ -d "$seeds" ]; then folders+=("$seeds"); fi
  "$build/tests/fuzz/$target" -max_total_time="$seconds" -rss_limit_mb=2048 -timeout=10 -print_final_stats=1 \
    -artifact_prefix="$build/crashes/$target-" "${folders[@]}" || failed+=("$target")
done
if [ ${#failed[@]} -gt 0 ]; then die "inputs that break ${failed[*]} are in $build/crashes"; fi
say "All ${#targets[@]} targets held"
