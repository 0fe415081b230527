#!/usr/bin/env bash
# usage: scripts/demo.sh [RECORDING [OUT]]
#
# Installs what is missing, builds, simulates a short drive of a snow groomer in snowfall and one of a haul truck in a
# mine, runs the program on both, compares with the truth and draws what it saw. Needs nothing but apt-get.
# RECORDING: process this one instead: a folder of scans as docs/formats.md lists them.
# OUT: where everything goes; default out/demo. What an earlier demo left there is replaced.
# MACHINE (environment): for RECORDING, the machine that carried the sensor, default car; `berm machine list`.
# Example: MACHINE=groomer scripts/demo.sh path/to/recording
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

case "${1:-}" in
  -h | --help) print_help && exit 0 ;;
  -*) wrong_usage "unknown argument $1" ;;
esac
out="${2:-$repo_dir/out/demo}"
if [ $# -gt 0 ] && [ ! -e "$1" ]; then
  die "there is no recording at $1. Give one, for instance a sequence of KITTI with velodyne/*.bin, or none at all:" \
    "then two are simulated"
fi

"$repo_dir/scripts/setup.sh"
configure_and_build release --target berm
berm="$repo_dir/build/release/berm"
mkdir -p "$out"

# Exit code 3 says that something was lost, and the program said what: no reason to stop.
accept_losses() { "$@" || [ $? -eq 3 ]; }

# process RECORDING MACHINE FOLDER [arguments of berm draw...]
process() {
  local recording="$1" machine="$2" folder="$3"
  shift 3
  accept_losses "$berm" run "$recording" --machine "$machine" -o "$folder" --force
  if [ -d "$recording/labels" ]; then accept_losses "$berm" eval "$folder" "$recording"; fi
  "$berm" draw "$recording" --run "$folder" --view perspective "$@" -o "$folder/scan.png"
}

# simulate_and_process SCENARIO MACHINE
simulate_and_process() {
  local recording="$out/$1"
  say "Simulating $1, 10 s"
  "$berm" sim "$1" -o "$recording" --seconds 10 --picture "$out/$1.png" --force
  say "Labelling it, and comparing with the truth"
  process "$recording" "$2" "$recording-run" --scan 000050
}

if [ $# -gt 0 ]; then
  say "What the recording holds"
  accept_losses "$berm" info "$1"
  say "Labelling it"
  process "$1" "${MACHINE:-car}" "$out"
  say "Results in $out: report.html (open it in a browser), labels/, run.json, scan.png"
else
  simulate_and_process groomer_snowfall groomer
  simulate_and_process haul_road haul_truck
  say "Results in $out"
  printf '  %s\n' \
    "groomer_snowfall.png, haul_road.png               the simulated worlds" \
    "groomer_snowfall-run/report.html, haul_road-...   a page about each run: open it in a browser" \
    "groomer_snowfall-run/scan.png, haul_road-run/...  what berm says of a scan" \
    "groomer_snowfall-run/labels/, run.json            labels point by point, counts and times" \
    "groomer_snowfall/, haul_road/                     the recordings with their truth"
fi
