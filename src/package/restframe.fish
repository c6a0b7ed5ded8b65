# Completion for fish: commands, options, and the values of options that have a few. They are asked of
# the program itself, so they are those of the one that would run.

# Every entry of a help text on one line: a long one has its text on the next.
function __restframe_help
    set -l words (commandline -opc)
    type -q $words[1]; or return
    set -l command (string match -rv -- '^-' $words[2..])[1]
    $words[1] $command --help 2>/dev/null | sed -e ':a' -e '$!N' -e 's/\n \{30\}/  /' -e ta -e 'P;D'
end

function __restframe_commands
    __restframe_help | sed -n '/^Subcommands:/,$s/^  \([a-z]*\)  *\(.*\)/\1\t\2/p'
end

function __restframe_options
    set -l tab \t
    for entry in (__restframe_help | string match -r '^  -.*')
        set -l names (string match -r '^  (\S+)' -- $entry)[2]
        set -l text (string match -r '^  \S.*?  +(.*)' -- $entry)[2]
        for name in (string split , -- $names)
            echo "$name$tab$text"
        end
    end
end

# The option whose value comes next, as its entry.
function __restframe_asking
    set -l last (commandline -opc)[-1]
    string match -q -- '-*' $last
    and __restframe_help | string match -r -- "^  (?:-\S*,)?$last(?:,\S*)? [A-Z].*"
end

function __restframe_values
    __restframe_asking | string match -r ':{([^}]*)}' | sed -n 2p | string split ,
end

complete -c restframe -n 'not __restframe_asking >/dev/null; and __fish_use_subcommand' -f -a '(__restframe_commands)'
complete -c restframe -n 'string match -q -- "-*" (commandline -ct)' -a '(__restframe_options)'
complete -c restframe -n 'test -n "$(__restframe_values)"' -f -a '(__restframe_values)'
