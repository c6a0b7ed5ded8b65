# Writes the man page: restframe.1.in, with every command and option that the program's --help names in
# place of the line @COMMANDS@.
#     awk -v program=build/release/restframe -v version=1.2.3 -v date=2030-12-31 -f man_page.awk restframe.1.in

function escaped(text) {
  gsub(/\\/, "\\e", text)
  gsub(/-/, "\\-", text)
  gsub(/'/, "\\(aq", text)
  sub(/^\./, "\\\\\\&.", text)
  return text
}

# The lines that a command's help has, in `line`, and for entries whose text begins below them, this text
# in `below`. Returns their number.
function read_help(command, line, below,    asked, text, count) {
  asked = "'" program "' " command " --help"
  while ((asked | getline text) > 0) {
    if (text ~ /^                              [^ ]/) {
      sub(/^ +/, "", text)
      below[count] = text
    } else {
      line[++count] = text
    }
  }
  if (close(asked) != 0) fail(asked " fails")
  return count
}

function fail(why) {
  print "man_page.awk: " why > "/dev/stderr"
  failed = 1
  exit 1
}

# What CLI11 says of an option's value, as "INT:INT in [1 - 9]=4 REQUIRED", becomes the name of the value
# and, in `facts`, the rest: "required, 1 to 9, default 4".
function value_of(text,    more) {
  facts = ""
  if (match(text, /(Needs|Excludes|\(Env):.*/)) {
    more = tolower(substr(text, RSTART, 1)) substr(text, RSTART + 1)
    text = substr(text, 1, RSTART - 1)
  }
  if (sub(/ *REQUIRED */, "", text)) facts = "required"
  if (match(text, /=[^=]*$/)) {
    more = "default " substr(text, RSTART + 1) (more == "" ? "" : ", " more)
    text = substr(text, 1, RSTART - 1)
  }
  if (match(text, /:\{.*\}/)) {
    text = substr(text, RSTART + 2, RLENGTH - 3)
    gsub(/,/, "|", text)
  } else if (match(text, /:.*/)) {
    more = bounds(substr(text, RSTART + 1)) (more == "" ? "" : ", " more)
    text = substr(text, 1, RSTART - 1)
  }
  if (more != "") facts = facts (facts == "" ? "" : ", ") more
  return text
}

function bounds(text) {
  if (sub(/^[A-Z]+ in \[/, "", text)) {
    sub(/\]$/, "", text)
    sub(/ - /, " to ", text)
  }
  return text
}

# An option or a positional: names, value, and what it is about.
function print_entry(head, text,    names, value) {
  names = head
  sub(/ .*/, "", names)
  value = value_of(substr(head, length(names) + 2))
  names = escaped(names)
  gsub(/,/, "\\fR, \\fB", names)
  print ".TP"
  print "\\fB" names "\\fR" (value == "" ? "" : " \\fI" escaped(value) "\\fR")
  print escaped(text (facts == "" ? "" : " (" facts ")"))
}

function print_line(line, below,    head, text) {
  if (line ~ /^  [^ ]/) {
    head = below == "" ? substr(line, 1, 30) : line
    text = below == "" ? substr(line, 31) : below
    gsub(/^ +| +$/, "", head)
    print_entry(head, text)
  } else if (line ~ /^[A-Z].*:$/ && line !~ /^(Options|Positionals):$/) {
    print ".PP\n" escaped(line)
  }
}

function print_command(command,    line, below, count, usage, i) {
  count = read_help(command, line, below)
  for (usage = 1; line[usage] !~ /^Usage: /; ++usage) {
    if (usage > count) fail("the help of " command " has no usage")
  }
  print ".SS " escaped(substr(line[usage], length("Usage: ") + 1))
  for (i = 1; i < usage; ++i) print line[i] == "" ? ".PP" : escaped(line[i])
  for (i = usage + 1; i <= count; ++i) print_line(line[i], below[i])
}

function print_commands(    line, below, count, i, word) {
  count = read_help("", line, below)
  for (i = 1; line[i] !~ /^Options:$/; ++i) if (i > count) fail("the help has no options")
  print ".SS restframe"
  while (++i <= count && line[i] !~ /^Subcommands:$/) print_line(line[i], below[i])
  for (; i <= count; ++i) {
    if (line[i] ~ /^  [a-z]/ && split(line[i], word, " ") > 0) print_command(word[1])
  }
}

/^@COMMANDS@$/ {
  print_commands()
  next
}

{
  gsub(/@VERSION@/, version)
  gsub(/@DATE@/, date)
  print
}

END { exit failed }
