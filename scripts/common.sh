# shellcheck shell=bash
# Sourced by the scripts beside it: where the tree is, how help is printed, which tool of several versions is there.

repo_dir="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
jobs="${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}"
readonly repo_dir jobs

say() { printf '\n== %s\n' "$*"; }

die() {
  printf '%s: %s\n' "$(basename "$0")" "$*" >&2
  exit 1
}

wrong_usage() {
  printf '%s: %s (see --help)\n' "$(basename "$0")" "$*" >&2
  exit 2
}

# The help of a script is the comment at its top.
print_help() { sed -n '2,/^[^#]/{s/^# \{0,1\}//p}' "$0"; }

# Prints the first of the given names that is a program; fails without output if there is none.
find_tool() {
  local name
  for name in "$@"; do
    if command -v "$name"; then return 0; fi
  done
  return 1
}

# The same for a tool of LLVM. 16 comes first: the tree is formatted with it, and releases differ in details.
find_llvm_tool() {
  find_tool "$1-16" "$1-17" "$1-18" "$1-15" "$1-14" "$1" ||
    die "$1 is missing: scripts/setup.sh --dev installs it"
}

# Folder of recordings for tests and demo; empty if there is none.
data_dir() {
  local folder="${BERM_DATA:-$repo_dir/../shared/data}"
  if [ -d "$folder" ]; then (cd "$folder" && pwd); fi
}

# configure_and_build PRESET [arguments of cmake --build...]
configure_and_build() {
  local preset="$1"
  shift
  (cd "$repo_dir" && cmake --preset "$preset" && cmake --build --preset "$preset" --parallel "$jobs" "$@")
}

run_tests() {
  local preset="$1"
  shift
  (cd "$repo_dir" && ctest --preset "$preset" --parallel "$jobs" "$@")
}
