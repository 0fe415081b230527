#!/usr/bin/env bash
# usage: scripts/demo.sh [RECORDING] [OUT]
#
# Installs what is missing, builds, runs the program on a recording and draws a scan of the result.
# RECORDING: a folder of scans as docs/formats.md lists them; default kitti00 in $BERM_DATA.
# OUT: where the results go; default out/demo. What an earlier demo left there is replaced.
# MACHINE (environment): the machine that carried the sensor, default car; `berm machine list` names those there are.
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

case "${1:-}" in
  -h | --help) print_help && exit 0 ;;
  -*) wrong_usage "unknown argument $1" ;;
esac
recording="${1:-$(data_dir)/kitti00}"
out="${2:-$repo_dir/out/demo}"
if [ ! -e "$recording" ]; then
  die "there is no recording at $recording. Give one, for instance a sequence of KITTI with velodyne/*.bin:" \
    "scripts/demo.sh path/to/recording"
fi

"$repo_dir/scripts/setup.sh"
configure_and_build release --target berm
berm="$repo_dir/build/release/berm"

# Exit code 3 says that something was lost, and the program said what: no reason to stop.
accept_losses() { "$@" || [ $? -eq 3 ]; }

say "What the recording holds"
accept_losses "$berm" info "$recording"
say "Labelling it"
mkdir -p "$out"
accept_losses "$berm" run "$recording" --machine "${MACHINE:-car}" -o "$out" --force
if [ -d "$recording/labels" ]; then
  say "Against the labels of the recording"
  accept_losses "$berm" eval "$out" "$recording"
fi
say "Drawing the first scan"
"$berm" draw "$recording" --run "$out" --view perspective -o "$out/scan.png"
say "Results in $out: labels/, run.json, scan.png"
