#compdef restframe
# Completion for zsh: commands, options, and the values of options that have a few. They are asked of
# the program itself, so they are those of the one that would run.

# Every entry of a help text on one line: a long one has its text on the next.
_restframe_help() {
  ${~words[1]} $1 --help 2>/dev/null | sed -e ':a' -e '$!N' -e 's/\n \{30\}/  /' -e ta -e 'P;D'
}

_restframe() {
  local command=${${words[2,CURRENT-1]:#-*}[1]} before=$words[CURRENT-1] help option
  local -a values options commands
  help=$(_restframe_help $command)
  if [[ $PREFIX == --*=* ]]; then
    before=${PREFIX%%=*}
    compset -P '*='
  fi

  if [[ $before == -* ]]; then
    option=$(grep -E "^  (-[^ ]*,)?$before(,[^ ]*)? [A-Z]" <<<$help)
  fi
  if [[ -n $option ]]; then
    values=(${(s:,:)"$(sed -n 's/^  [^ ]* [A-Z]*:{\([^}]*\)}.*/\1/p' <<<$option)"})
    if (( $#values )); then compadd -a values; else _files; fi
  elif [[ $PREFIX == -* ]]; then
    options=("${(@f)$(awk -F '   *' '/^  -/ { split($2, word, " "); count = split(word[1], name, ",")
      for (i = 1; i <= count; ++i) print name[i] ":" $3 }' <<<$help)}")
    _describe -o option options
  elif [[ -z $command ]]; then
    commands=("${(@f)$(sed -n '/^Subcommands:/,$s/^  \([a-z]*\)  *\(.*\)/\1:\2/p' <<<$help)}")
    _describe command commands
  else
    _files
  fi
}

_restframe "$@"
