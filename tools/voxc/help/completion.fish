#Completion of voxc's command line in fish, written by `voxc completion fish`.

#Whether the command so far, of one word or two, is this one.
function __voxc_at --argument-names wanted
  set -l at
  for word in (commandline -opc)[2..-1]
    set -l next (string join ' ' $at $word)
    contains -- "$next" @COMMANDS@
    or break
    set at $next
  end
  test "$at" = "$wanted"
end

@WORDS@
