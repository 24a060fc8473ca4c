# Prints what zsh would offer behind each line: complete.zsh COMPLETION LINE...
compdef() { }
_describe() {
  offered=()
  for choice in ${(P)2}; do
    [[ ${choice%%:*} == $words[CURRENT]* ]] && offered+=(${choice%%:*})
  done
}
_files() { offered=(files) }
source "$1"
shift
for line; do
  words=(${=line})
  [[ $line == *' ' ]] && words+=("")
  CURRENT=$#words
  offered=()
  _voxc
  print -r -- "$line: $offered"
done
