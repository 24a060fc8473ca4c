#!/usr/bin/env bash
# Writes the help texts that help.test expects, from the tools of a build folder; look at the difference before a commit.
set -euo pipefail
readonly bin="${1:-build/release}/bin" inputs="$(dirname "$0")/Inputs"
for tool in voxc voxc-hard-rays voxc-opt voxc-trace; do "$bin/$tool" --help >"$inputs/help-$tool.txt"; done
for command in compile build render view run trace verify accuracy bench export facts suggest search plan submit status merge split edit attach info devices doctor cache manual completion; do
  "$bin/voxc" "$command" --help >"$inputs/help-$command.txt"
done
for action in export import report; do
  "$bin/voxc" bench "$action" --help >"$inputs/help-bench-$action.txt"
done
