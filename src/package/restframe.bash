# shellcheck shell=bash
# Completion for bash: commands, options, and the values of options that have a few. They are asked of
# the program itself, so they are those of the one that would run.

# Every entry of a help text on one line: a long one has its text on the next.
_restframe_help() {
  "${COMP_WORDS[0]/#\~/$HOME}" "$@" --help 2>/dev/null | sed -e ':a' -e '$!N' -e 's/\n \{30\}/  /' -e ta -e 'P;D'
}

_restframe() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command='' help option words i
  if [[ $word == = ]]; then
    word=''
  elif [[ $before == = ]]; then
    before=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  for ((i = 1; i < COMP_CWORD; ++i)); do
    [[ ${COMP_WORDS[i]} == -* ]] || { command=${COMP_WORDS[i]} && break; }
  done
  help=$(_restframe_help ${command:+"$command"})

  COMPREPLY=()
  option=$([[ $before == -* ]] && grep -E "^  (-[^ ]*,)?$before(,[^ ]*)? [A-Z]" <<<"$help")
  if [[ -n $option ]]; then
    # Its value; where there is no list of them, the shell completes a file's name.
    words=$(sed -n 's/^  [^ ]* [A-Z]*:{\([^}]*\)}.*/\1/p' <<<"$option" | tr ',' ' ')
  elif [[ $word == -* ]]; then
    words=$(sed -n 's/^  \(-[^ ]*\).*/\1/p' <<<"$help" | tr ',' ' ')
  elif [[ -z $command ]]; then
    words=$(sed -n '/^Subcommands:/,$s/^  \([a-z]*\) .*/\1/p' <<<"$help")
  fi
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}

complete -o default -F _restframe restframe
