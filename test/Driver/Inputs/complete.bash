# Prints what bash would offer behind each line: complete.bash COMPLETION LINE...
source "$1"
shift
for line; do
  read -ra COMP_WORDS <<<"$line"
  [[ $line == *' ' ]] && COMP_WORDS+=("")
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  COMPREPLY=()
  _voxc
  echo "$line: ${COMPREPLY[*]}"
done
