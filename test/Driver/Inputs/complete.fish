# Prints what fish would offer behind each line: complete.fish COMPLETION LINE...
source $argv[1]
for line in $argv[2..-1]
  echo "$line: "(complete -C "$line" | string split -f 1 \t | string join ' ')
end
