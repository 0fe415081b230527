#!/usr/bin/env bash
# usage: scripts/piste_table.sh [--quick | --write] [OPTIONS OF berm_piste_accuracy]
#
# Builds the release preset, simulates pistes with truth, takes them through the chain of the groomer and prints what it
# gets right: the default beside the published method and a trivial baseline, run by run; every step switched off in
# turn; settings halved and doubled; other sensors. Then the runs once more with other seeds. Exit code 1 if an accuracy
# that is asked for is not reached.
#   --quick  four short runs, no other table
#   --write  writes docs/piste_table.md, with the bars for four more sets of seeds
# Example: scripts/piste_table.sh --runs-only --seed-offset 7000
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

case "${1:-}" in -h | --help) print_help && exit 0 ;; esac
configure_and_build release --target berm_piste_accuracy >&2
BERM_DATA="$(data_dir)"
export BERM_DATA
program="$repo_dir/build/release/bench/berm_piste_accuracy"
missed=0

measure() {
  local status=0
  "$program" "$@" || status=$?
  [ "$status" -le 1 ] || exit "$status"
  [ "$status" -eq 0 ] || missed=1
  echo
}

write_page() {
  cat <<'PAGE'
# Piste: measured accuracy

Written by `scripts/piste_table.sh --write`; not to be edited. [Piste](piste.md) explains the methods.

PAGE
  measure
  measure --runs-only --seed-offset 1000
  for offset in 2000 3000 4000 5000; do measure --bars-only --seed-offset "$offset"; done
}

case "${1:-}" in
--write)
  page="$repo_dir/build/release/piste_table.md"
  write_page >"$page"
  mv "$page" "$repo_dir/docs/piste_table.md"
  ;;
"")
  measure
  measure --runs-only --seed-offset 1000
  ;;
*) measure "$@" ;;
esac
exit "$missed"
