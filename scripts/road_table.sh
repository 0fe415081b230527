#!/usr/bin/env bash
# usage: scripts/road_table.sh [--write] [OPTIONS OF berm_road_accuracy]
#
# Builds the release preset, simulates haul roads with truth, takes them from scans to the lines of their edges and prints
# what is right: the default beside the published method, road by road; every step switched off in turn; other
# settings. Exit code 1 if a figure that is asked for is not reached in the mean.
#   --write [OPTIONS]  writes docs/road_table.md, with the roads of another set of seeds, and roads in dust
# Example: scripts/road_table.sh --runs-only --seed-offset 7000
#          scripts/road_table.sh --write --keep ~/haul_roads
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

case "${1:-}" in -h | --help) print_help && exit 0 ;; esac
configure_and_build release --target berm_road_accuracy >&2
program="$repo_dir/build/release/bench/berm_road_accuracy"
missed=0

measure() {
  local status=0
  "$program" "$@" || status=$?
  [ "$status" -le 1 ] || exit "$status"
  [ "$status" -eq 0 ] || missed=1
}

write_page() {
  cat <<'PAGE'
# Haul roads: measured accuracy

Written by `scripts/road_table.sh --write`; not to be edited. [Edges](edges.md) and [their map](edge_map.md) explain the
methods: default snow and ground stages, edges with the poses of gnss.tum at the time of each point, map, lines.

PAGE
  measure "$@"
  measure "$@" --bars-only --seed-offset 1000
  measure "$@" --dust
  measure "$@" --dust --seed-offset 1000
}

case "${1:-}" in
--write)
  shift
  page="$repo_dir/build/release/road_table.md"
  write_page "$@" >"$page"
  mv "$page" "$repo_dir/docs/road_table.md"
  ;;
*) measure "$@" ;;
esac
exit "$missed"
