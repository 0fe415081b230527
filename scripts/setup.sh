#!/usr/bin/env bash
# usage: scripts/setup.sh [--dev] [--browser] [--list]
#
# Installs what is missing to build and test berm, with apt-get, on Debian 12 and Ubuntu 22.04 / 24.04.
# What is there already is left alone: a second call does nothing and needs no network.
#
#   --dev      also the tools of lint, fuzz and coverage, and those that tests read exports back with
#   --browser  also Node and Chromium, in which the pages of viewer and report are tried; not Chromium on Ubuntu, which
#              has no package of it
#   --list     only print what would be installed
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

packages=(
  g++ cmake ninja-build
  libeigen3-dev libfmt-dev libspdlog-dev libcli11-dev libyaml-cpp-dev nlohmann-json3-dev
  libceres-dev liblzf-dev libpng-dev robin-map-dev libnanoflann-dev libembree-dev libgdal-dev liboctomap-dev libboost-dev
  libgtest-dev libgmock-dev librapidcheck-dev libbenchmark-dev
)
dev_packages=(gcovr shellcheck python3 gdal-bin libxml2-utils)

list_only=false
dev=false
browser=false
for argument in "$@"; do
  case "$argument" in
    --dev) dev=true ;;
    --browser) browser=true ;;
    --list) list_only=true ;;
    -h | --help) print_help && exit 0 ;;
    *) wrong_usage "unknown argument $argument" ;;
  esac
done

if ! find_tool apt-get >/dev/null; then
  die "this system has no apt-get. Install by hand what these packages of Debian hold, then use the presets of" \
    "CMake: ${packages[*]}"
fi

# Ubuntu 22.04 has the package under its older name.
geographiclib_package() {
  local id="" version=""
  # shellcheck source=/dev/null
  . /etc/os-release
  id="${ID:-}" version="${VERSION_ID:-}"
  case "$id-$version" in
    ubuntu-22.04) echo libgeographic-dev ;;
    *) echo libgeographiclib-dev ;;
  esac
}

# The newest release of clang up to 16 that this distribution packages.
clang_version() {
  local id="" version=""
  # shellcheck source=/dev/null
  . /etc/os-release
  id="${ID:-}" version="${VERSION_ID:-}"
  case "$id-$version" in
    ubuntu-22.04) echo 15 ;;
    *) echo 16 ;;
  esac
}

packages+=("$(geographiclib_package)")
if $dev; then
  clang="$(clang_version)"
  packages+=("${dev_packages[@]}" "clang-$clang" "clang-format-$clang" "clang-tidy-$clang" "libclang-rt-$clang-dev")
fi

# What is there under another name or from elsewhere is as good. On Ubuntu the package of Chromium installs nothing.
if $browser; then
  find_tool npm >/dev/null || packages+=(nodejs npm)
  if ! find_tool chromium chromium-browser google-chrome >/dev/null && grep -q '^ID=debian' /etc/os-release; then
    packages+=(chromium)
  fi
fi

missing=()
for package in "${packages[@]}"; do
  status="$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)"
  [ "$status" = installed ] || missing+=("$package")
done

if [ ${#missing[@]} -eq 0 ]; then
  echo "setup: nothing is missing"
  exit 0
fi
if $list_only; then
  printf '%s\n' "${missing[@]}"
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || die "missing: ${missing[*]}. Installing them takes root, and there is no sudo here." \
    "Run as root: apt-get update && apt-get install ${missing[*]}"
  as_root=(sudo)
fi

say "Installing ${missing[*]}"
apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -y -q)
# A list of some other repository that cannot be fetched must not stop us: the installation tells what is lacking.
"${apt[@]}" update || echo "setup: apt-get update had trouble, going on with the lists that are there" >&2
"${apt[@]}" install --no-install-recommends "${missing[@]}" || die \
  "apt-get could not install the packages above. Is the network there, and on Ubuntu the component 'universe'?"
