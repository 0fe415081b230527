#!/usr/bin/env bash
# usage: scripts/piste_figures.sh FOLDER
#
# Draws the figures of the ski piste into FOLDER: the three cases of the published method (obstacles on both sides, a
# bend, a fork of two runs of 34 and 16 degrees), simulated in snowfall, and a real scan of a Livox Horizon. For each:
# the histogram of intensities with and without flakes, x and z over the firing order (reference and default), the
# labelled scan from above and from the side, and the truth beside it where there is one. BERM names another program.
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

case "${1:-}" in
  -h | --help) print_help && exit 0 ;;
  "") wrong_usage "FOLDER is missing" ;;
esac
folder="$1"
berm="${BERM:-}"
if [ -z "$berm" ]; then
  configure_and_build release --target berm
  berm="$repo_dir/build/release/berm"
fi
mkdir -p "$folder"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
reference=(--method piste=reference --method snow=reference)

# figures RECORDING SCAN NAME TITLE FIRST_POINT [options of berm draw...]
figures() {
  local recording="$1" scan="$2" name="$folder/$3" title="$4" first="$5"
  shift 5
  local draw=("$berm" draw "$recording" --scan "$scan" --machine groomer --light "$@")
  local waveform=(--figure waveform --first-point "$first" --points 1000)
  "${draw[@]}" --figure histogram --title "$title: intensities" -o "${name}_histogram.png"
  "${draw[@]}" "${waveform[@]}" --title "$title: default" -o "${name}_waveform.png"
  "${draw[@]}" "${waveform[@]}" "${reference[@]}" --title "$title: method P" -o "${name}_waveform_reference.png"
  "${draw[@]}" --ahead --range 60 --title "$title: default" -o "${name}_above.png"
  "${draw[@]}" --ahead --range 60 "${reference[@]}" --title "$title: method P" -o "${name}_above_reference.png"
  "${draw[@]}" --ahead --range 60 --view side --title "$title: default" -o "${name}_side.png"
}

# simulated NAME TITLE SCENARIO SEED FIRST_POINT [SECTION.KEY=VALUE...]
simulated() {
  local name="$1" title="$2" scenario="$3" seed="$4" first="$5" options=()
  shift 5
  for setting in "$@"; do options+=(--set "$setting"); done
  say "$title"
  "$berm" sim "$scenario" -o "$work/$name" --seed "$seed" --seconds 1 -q "${options[@]}" \
    --picture "$folder/${name}_world.png"
  figures "$work/$name" 000005 "$name" "$title" "$first"
  "$berm" draw "$work/$name" --scan 000005 --truth --machine groomer --light --ahead --range 60 --title "$title: truth" \
    -o "$folder/${name}_above_truth.png"
}

simulated obstacles "Obstacles on both sides" groomer_snowfall 18 4000 \
  things.fence_share=0.9 things.trees_per_hectare=900 piste.min_width_m=9 piste.max_width_m=13 traffic.oncoming=0
simulated bend "Bend" groomer_snowfall 15 4000 \
  route.bend_deg=110 route.bend_every_m=30 route.min_radius_m=25 piste.max_width_m=20
# The seed is one whose main run turns to 33 degrees where a run of 16 degrees leaves it.
simulated fork "Fork of 34 and 16 degrees" groomer_forks 58 4000 \
  route.min_gradient_deg=14 route.max_gradient_deg=36 route.gradient_every_m=40 route.bend_deg=20 \
  route.roller_height_m=0 vehicle.start_m=322 vehicle.turn_on_spot_deg=0 traffic.oncoming=0 \
  things.trees_per_hectare=0 things.lift=false snowfall.flakes_per_m3=130

data="$(data_dir)"
if [ -d "$data/livox_horizon" ]; then
  say "Livox Horizon"
  figures "$data/livox_horizon" 1 horizon "Livox Horizon, recorded" 19000 \
    --set mount.height_m=2.0 --set mount.pitch_deg=0
else
  say "No recorded scan: set BERM_DATA to the folder that holds livox_horizon"
fi
