#!/usr/bin/env bash
# usage: scripts/build.sh [PRESET] [arguments of cmake --build...]
#
# Configures and builds a preset of CMake (default: release). The program lands at build/PRESET/berm.
# Examples: scripts/build.sh; scripts/build.sh dev; scripts/build.sh release --target berm
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

case "${1:-}" in
  -h | --help) print_help && exit 0 ;;
  -*) wrong_usage "unknown argument $1" ;;
esac
preset="${1:-release}"
configure_and_build "$preset" "${@:2}"
