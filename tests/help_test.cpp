// The man page and the shells' completion against --help: each names every command and every option, and
// none that is not there.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "support/program.h"
#include "support/temporary_folder.h"

namespace restframe {
namespace {

using Names = std::set<std::string>;

Names names_in(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern, std::regex::ECMAScript | std::regex::multiline);
  Names names;
  for (std::sregex_iterator i(text.begin(), text.end(), regex); i != std::sregex_iterator(); ++i) {
    names.insert((*i)[1]);
  }
  return names;
}

std::string help_of(const std::string& command) {
  std::vector<std::string> arguments = {"--help"};
  if (!command.empty()) arguments.insert(arguments.begin(), command);
  return run_program(RESTFRAME_PROGRAM, arguments).out;
}

Names commands() {
  const std::string help = help_of("");
  return names_in(help.substr(help.find("Subcommands:")), "^  ([a-z]\\S*)");
}

// "  -o,--output TEXT ..." is two.
Names options_in(const std::string& help) {
  Names options;
  for (const std::string& names : names_in(help, "^  (-\\S*)")) {
    for (const std::string& name : names_in(names, "([^,]+)")) options.insert(name);
  }
  return options;
}

std::string man_page() {
  std::stringstream text;
  text << std::ifstream(RESTFRAME_MAN_PAGE).rdbuf();
  return std::regex_replace(text.str(), std::regex(R"(\\-)"), "-");
}

// What it says of a command; empty: of the program.
std::string section(const std::string& page, const std::string& command) {
  const std::string heading =
      command.empty() ? ".SS restframe\n" : ".SS restframe " + command + " ";
  const std::size_t begin = page.find(heading);
  if (begin == std::string::npos) return {};
  return page.substr(begin, page.find("\n.S", begin + 1) - begin);
}

TEST(ManPage, NamesTheCommandsOfTheHelp) {
  EXPECT_THAT(commands(), testing::Contains("render"));
  EXPECT_EQ(names_in(man_page(), "^\\.SS restframe (\\S+)"), commands());
}

TEST(ManPage, NamesTheOptionsOfTheHelp) {
  const std::string page = man_page();
  Names all = commands();
  all.insert("");
  for (const std::string& command : all) {
    const std::string text = section(page, command);
    Names options;
    for (const std::string& tag : names_in(text, "^(\\\\fB-.*)")) {
      options.merge(names_in(tag, "\\\\fB(-[^\\\\]*)\\\\fR"));
    }
    EXPECT_EQ(options, options_in(help_of(command))) << command;
    EXPECT_THAT(options, testing::Contains("--help")) << command;
  }
}

TEST(ManPage, TellsWhatIsExpected) {
  const std::string render = section(man_page(), "render");
  EXPECT_THAT(render, testing::HasSubstr("\\fBSCENE\\fR"));
  EXPECT_THAT(render,
              testing::HasSubstr("\\fB--samples\\fR \\fIINT\\fR\nSamples a pixel (1 to 65536)"));
  EXPECT_THAT(render, testing::HasSubstr("\\fB--view\\fR \\fIsrgb|filmic\\fR\n"));
  EXPECT_THAT(section(man_page(), "lattice"), testing::HasSubstr("(default 7x7x20)"));
}

struct Shell {
  const char* name;
  // Prints the completions of the last one of the words $1 ..., a line each, once `source` is read.
  const char* script;
};

void PrintTo(const Shell& shell, std::ostream* out) {
  *out << shell.name;
}

constexpr Shell kBash = {"bash", R"(
source "$0"
COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
_restframe
printf '%s\n' "${COMPREPLY[@]}")"};

constexpr Shell kFish = {"fish", R"(
source $argv[1]
complete -C (string join ' ' -- $argv[2..] | string collect) | string replace -r '\t.*' '')"};

// With zsh's own helpers for completion replaced by ones that print what they get.
constexpr Shell kZsh = {"zsh", R"(
starting() { print -l -- $@ | grep -e "^$PREFIX" }
compadd() { starting ${(P)@[-1]} }
_describe() { starting ${${(P)@[-1]}%%:*} }
_files() { : }
words=("$@") CURRENT=$# PREFIX=$words[-1]
source "$0"
true)"};

class Completion : public testing::TestWithParam<Shell> {
 protected:
  void SetUp() override {
    const RunResult shell = run_program("/usr/bin/env", {GetParam().name, "--version"});
    if (shell.exit_code != 0) GTEST_SKIP() << GetParam().name << " is not installed";
  }

  static Names complete(const std::vector<std::string>& words) {
    const Shell& shell = GetParam();
    const std::string source =
        std::string(RESTFRAME_SOURCE_DIR "/src/package/restframe.") + shell.name;
    const TemporaryFolder home;  // fish keeps a file there
    std::vector<std::string> arguments = {"HOME=" + home.path().string(),
                                          "XDG_CONFIG_HOME=" + home.path().string(),
                                          "XDG_DATA_HOME=" + home.path().string(),
                                          shell.name,
                                          "-c",
                                          shell.script,
                                          source,
                                          RESTFRAME_PROGRAM};
    arguments.insert(arguments.end(), words.begin(), words.end());
    const RunResult result = run_program("/usr/bin/env", arguments);
    EXPECT_EQ(result.error, "");
    return names_in(result.out, "^(\\S+)");
  }
};

TEST_P(Completion, OffersTheCommandsOfTheHelp) {
  EXPECT_EQ(complete({""}), commands());
  EXPECT_EQ(complete({"re"}), Names{"render"});
}

TEST_P(Completion, OffersTheOptionsOfTheHelp) {
  for (const std::string& command : commands()) {
    EXPECT_EQ(complete({command, "-"}), options_in(help_of(command))) << command;
  }
  EXPECT_EQ(complete({"-"}), options_in(help_of("")));
  EXPECT_EQ(complete({"render", "scene.toml", "--sa"}), Names{"--samples"});
}

TEST_P(Completion, OffersTheValuesOfAnOption) {
  EXPECT_EQ(complete({"render", "--view", ""}), (Names{"srgb", "filmic"}));
  EXPECT_EQ(complete({"lattice", "--instances", "g"}), Names{"gpu"});
}

TEST_P(Completion, OffersNothingForAnUnknownCommand) {
  EXPECT_EQ(complete({"rendre", "--"}), Names{});
}

INSTANTIATE_TEST_SUITE_P(Shells, Completion, testing::Values(kBash, kFish, kZsh),
                         [](const auto& shell) { return std::string(shell.param.name); });

}  // namespace
}  // namespace restframe
