#compdef voxc
#Completion of voxc's command line in zsh, written by `voxc completion zsh`.
_voxc() {
  local current=$words[CURRENT] before=$words[CURRENT-1] at= word next
  local -a choices

#The command, of one word or two.
  for word in $words[2,CURRENT-1];
  do
    next="${at:+$at }$word"
    case $next in
    @COMMANDS@) at=$next ;;
    *) break ;;
    esac
  done

#The values of an option that has but a few; or else what the command takes, or files.
  case $before in
@VALUES@
  *) case $at in
@WORDS@
    esac
    if [[ $current != -* && -n $at && $choices[1] == -* ]]; then
      _files
      return
    fi ;;
  esac
  _describe voxc choices
}
if [[ $funcstack[1] == _voxc ]]; then
  _voxc "$@"
else
  compdef _voxc voxc
fi
