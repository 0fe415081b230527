#!/usr/bin/env bash
# usage: scripts/web.sh [build|test|browser|check|format]
#
# The pages of berm: the viewer and the report, TypeScript under web/. What they are built into, web/dist, is part of
# the repository, so that only who changes the pages needs Node (18 or newer) with npm.
#
#   build    install packages, check types, run the unit tests, build into web/dist (default)
#   test     the same without building
#   browser  drive the built pages in Chromium ($BERM_CHROMIUM or the package of Debian), over $BERM_PROGRAM or the berm
#            of build/release; where Node or Chromium is missing it is left out and says so
#   check    test, style, and fail if web/dist is not what the sources build
#   format   put the sources into shape
# Example: scripts/web.sh && scripts/web.sh browser
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

job="${1:-build}"
case "$job" in
  -h | --help) print_help && exit 0 ;;
  build | test | browser | check | format) ;;
  *) wrong_usage "unknown argument $job" ;;
esac
cd "$repo_dir/web"

# Not everybody has a browser where they build, and the packages of npm take a network: no reason to call a build broken.
leave_out() {
  echo "web: $*: the pages are not tried in a browser (scripts/setup.sh --browser installs what that takes)"
  exit 0
}

if ! find_tool npm >/dev/null; then
  if [ "$job" = browser ]; then leave_out "npm is missing"; fi
  die "npm is missing: install Node 18 or newer. Users need none: web/dist is built"
fi

# A second call needs no network: packages are fetched when the lock file is newer than what is there.
install_packages() {
  if [ node_modules/.package-lock.json -nt package-lock.json ]; then return 0; fi
  npm ci --no-fund --no-audit
}

unit_tests() { npm run -s types && npm run -s test; }

check_dist() {
  local fresh
  fresh="$(mktemp -d)"
  # shellcheck disable=SC2064
  trap "rm -rf '$fresh'" EXIT
  node build.mjs "$fresh"
  diff -rq "$fresh" dist || die "web/dist is not what the sources build: run scripts/web.sh and commit web/dist"
}

if [ "$job" = browser ]; then
  [ -n "${BERM_CHROMIUM:-}" ] || find_tool chromium chromium-browser google-chrome >/dev/null || leave_out "no Chromium"
  install_packages || leave_out "npm cannot fetch its packages"
else
  install_packages
fi
case "$job" in
  build) unit_tests && npm run -s build ;;
  test) unit_tests ;;
  browser) npm run -s browser ;;
  check) unit_tests && npx prettier --check . && check_dist ;;
  format) npx prettier --write . ;;
esac
