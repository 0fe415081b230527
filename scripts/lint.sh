#!/usr/bin/env bash
# usage: scripts/lint.sh [--fix] [CHECK]...
#
# Style and likely bugs, as errors. CHECK is any of: format includes shell paths tidy (default: all, quick ones first).
# Examples: scripts/lint.sh format includes; scripts/lint.sh --fix format
#
#   --fix    format files in place instead of complaining
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

fix=false
checks=()
for argument in "$@"; do
  case "$argument" in
    -h | --help) print_help && exit 0 ;;
    --fix) fix=true ;;
    format | includes | shell | paths | tidy) checks+=("$argument") ;;
    *) wrong_usage "unknown argument $argument" ;;
  esac
done
if [ ${#checks[@]} -eq 0 ]; then checks=(format includes shell paths tidy); fi
cd "$repo_dir"

check_format() {
  local tool mode=(--dry-run -Werror)
  tool="$(find_llvm_tool clang-format)" || exit 1
  if $fix; then mode=(-i); fi
  find include src apps tests bench examples -name '*.[ch]pp' -print0 | xargs -0 -r "$tool" "${mode[@]}"
}

check_includes() { scripts/check_includes.py; }

check_shell() { shellcheck -x scripts/*.sh tests/lint/*.sh .ci/run; }

# Paths of one machine have no place in what others build.
check_paths() {
  if grep -rnIE '(^|[^A-Za-z0-9_.~$}])/(home|root|work|Users|mnt|media)/' . \
    --exclude-dir={.git,build,out,.cache,node_modules} --exclude={LICENSE,lint.sh}; then
    echo "lint: absolute paths of a machine (above)" >&2
    return 1
  fi
}

check_tidy() {
  local tidy runner
  tidy="$(find_llvm_tool clang-tidy)" || exit 1
  runner="$(find_llvm_tool run-clang-tidy)" || exit 1
  # Several files at a time, as unity builds have them: most of the time goes into the headers that they share.
  cmake --preset dev -B build/lint -DCMAKE_UNITY_BUILD=ON >build/lint-configure.log 2>&1 ||
    { cat build/lint-configure.log && return 1; }
  # The runner echoes every file; only what is wrong is of interest.
  if "$runner" -quiet -clang-tidy-binary "$tidy" -p build/lint -j "$jobs" \
    -header-filter='(include/berm|src|apps|examples)/.*\.[ch]pp$' -checks='-bugprone-suspicious-include' \
    "$repo_dir/(build/lint/)?(src|apps|examples)/.*\.c(pp|xx)$" >build/lint-tidy.log 2>&1; then return 0; fi
  grep -vE '^(.*clang-tidy.* -p=|[0-9]+ warnings|Suppressed|Use -header-filter)' build/lint-tidy.log || true
  return 1
}

mkdir -p build
failed=()
for check in "${checks[@]}"; do
  say "lint: $check"
  "check_$check" || failed+=("$check")
done
if [ ${#failed[@]} -gt 0 ]; then die "failed: ${failed[*]}"; fi
say "lint: all good"
