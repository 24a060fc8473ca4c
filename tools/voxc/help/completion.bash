#Completion of voxc's command line in bash, written by `voxc completion bash`.
_voxc() {
  local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} path= words= word next

#The command, of one word or two.
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}";
  do
    next="${path:+$path }$word"
    case $next in
    @COMMANDS@) path=$next ;;
    *) break ;;
    esac
  done

#The values of an option that has but a few; or else what the command takes, or files.
  case $before in
@VALUES@
  *) case $path in
@WORDS@
    esac ;;
  esac
  if [[ $current == -* || -z $path || " $words " != *' --'* ]]; then
    COMPREPLY=($(compgen -W "$words" -- "$current"))
  else
    local commands=
    for word in $words; do
      [[ $word == -* ]] || commands+=" $word"
    done
    COMPREPLY=($(compgen -W "$commands" -- "$current") $(compgen -f -- "$current"))
  fi
}
complete -o filenames -F _voxc voxc
