#!/usr/bin/env bash
# usage: scripts/gallery.sh
#
# Draws the pictures of docs/simulator.md into docs/images: each world, and what each sensor sees of one of them.
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

case "${1:-}" in
  -h | --help) print_help && exit 0 ;;
  ?*) wrong_usage "unknown argument $1" ;;
esac
images="$repo_dir/docs/images"
configure_and_build release --target berm
berm="$repo_dir/build/release/berm"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT

for scenario in groomer_clear groomer_forks haul_road haul_road_dust flat_road car_park; do
  say "World $scenario"
  "$berm" sim "$scenario" --picture "$images/world_$scenario.png"
done

# sensor NAME PITCH_DEG TITLE
sensor() {
  say "Sensor $1"
  "$berm" sim groomer_snowfall -o "$work/$1" --sensor "$1" --seconds 1 --set "mount.pitch_deg=$2" -q
  "$berm" draw "$work/$1" --truth --scan 000005 --view perspective --width 960 --height 540 --title "$3" \
    -o "$images/sensor_$1.png"
}
sensor livox_mid70 11 "Livox Mid-70"
sensor livox_mid360 11 "Livox Mid-360"
sensor vlp16 5 "Velodyne VLP-16"
sensor hdl32e 0 "Velodyne HDL-32E"
sensor hdl64e 0 "Velodyne HDL-64E"
sensor ouster64 0 "Ouster OS1-64"
