#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace study::app {

/// An option or a positional argument of a command, as help pages describe it.
struct OptionDescription {
  std::vector<std::string> names{};    ///< "--out", "-o"; a positional argument has one: "FOLDER"
  std::string value{};                 ///< placeholder of the value: "FILE"; empty for a flag
  std::string text{};                  ///< description
  std::string range{};                 ///< accepted values, in words: "1 to 100"
  std::vector<std::string> choices{};  ///< all accepted values; empty if they cannot be listed
  std::string defaultValue{};          ///< default value
  bool isRequired = false;
  bool isPositional = false;
};

/// A program or one of its commands, for help pages.
struct CommandDescription {
  std::string name{};  ///< complete name: "palpate study create"
  std::string text{};
  std::vector<OptionDescription> options{};  ///< including positional arguments
  std::vector<CommandDescription> commands{};
};

/// Reads the description of a command line from its parser. Leaves out options without a group,
/// which help pages hide as well.
CommandDescription describe(const CLI::App& program);

/// Puts the commands and options of @p program in place of those of the command of @p starter that
/// starts it: 'palpate bench' is palpate-bench. Nothing happens if there is no such command.
/// @param name  of the command: "bench"
void addCommandsOf(
    CommandDescription program, const std::string& name, CommandDescription& starter);

/// Lets help pages of @p program and of commands that are added afterwards show values, ranges and
/// defaults of options as describe() gives them.
void setHelpFormat(CLI::App& program);

/// The sections of a manual page that are not in the parser's description. Texts are plain;
/// manPage() escapes them.
struct ManPageSections {
  std::string version{};               ///< "palpate 0.1.0"
  std::string summary{};               ///< the summary after the program's name
  std::string exitStatus{};            ///< empty: no such section
  std::string files{};                 ///< empty: no such section
  std::vector<std::string> seeAlso{};  ///< "palpate(1)"
};

/// A manual page of section 1 (troff with man(7) macros, UTF-8). It contains no date, so that every
/// build gives the same bytes.
std::string manPage(const CommandDescription& program, const ManPageSections& sections);

/// A completion script for bash. It completes commands, options and listed values; for other words
/// it offers file names.
std::string bashCompletion(const CommandDescription& program);

}  // namespace study::app
