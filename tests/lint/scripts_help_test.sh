#!/usr/bin/env bash
# usage: scripts_help_test.sh REPOSITORY
#
# Every script explains itself from any folder, and refuses what it does not know with exit code 2.
set -euo pipefail
scripts="$1/scripts"
cd /

count=0
for script in "$scripts"/*.sh; do
  name="$(basename "$script")"
  if [ "$name" = common.sh ]; then continue; fi
  help="$("$script" --help)"
  case "$help" in
    "usage: scripts/$name"*) ;;
    *) echo "$name --help does not begin with its usage: $help" && exit 1 ;;
  esac
  count=$((count + 1))
done
if [ "$count" -lt 9 ]; then echo "only $count scripts in $scripts" && exit 1; fi

for name in setup build sanitize coverage fuzz lint demo gallery; do
  code=0
  "$scripts/$name.sh" --no-such-option >/dev/null 2>&1 || code=$?
  if [ "$code" -ne 2 ]; then echo "$name.sh takes an unknown option (exit code $code)" && exit 1; fi
done
echo "$count scripts"
