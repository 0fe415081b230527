#!/usr/bin/env bash
# usage: scripts/odometry_table.sh [--write | OPTIONS OF berm_odometry_accuracy]
#
# Builds the release preset, simulates drives with truth, and prints how far the odometry drifts on them: the default
# beside the published method, drive by drive, and the default with each part switched off in turn.
#   --write  writes docs/odometry_table.md, with the drives of another set of seeds (15 minutes: the reference is slow)
# Example: scripts/odometry_table.sh --runs-only --no-reference --seed-offset 7000
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

case "${1:-}" in -h | --help) print_help && exit 0 ;; esac
configure_and_build release --target berm_odometry_accuracy >&2
program="$repo_dir/build/release/bench/berm_odometry_accuracy"

write_page() {
  cat <<'PAGE'
# Odometry: measured drift

Written by `scripts/odometry_table.sh --write`; not to be edited. [Odometry](odometry.md) and
[the published one](odometry_reference.md) explain the methods; labels are those of the chain of the machine.

Drift: mean error over all stretches of 10, 25 and 50 m, in % of their length. ATE after a rigid alignment. Weak, lost:
share of the scans that the odometry calls so. CPU time a scan on one core, of the odometry and of the labels. The bare
slope has nothing that stands: it is there to see whether the odometry says so.

## First seeds

PAGE
  "$program"
  printf '\n## Seeds + 1000\n\n'
  "$program" --seed-offset 1000 --runs-only --no-reference
}

case "${1:-}" in
--write)
  page="$repo_dir/build/release/odometry_table.md"
  write_page >"$page"
  mv "$page" "$repo_dir/docs/odometry_table.md"
  ;;
*) "$program" "$@" ;;
esac
