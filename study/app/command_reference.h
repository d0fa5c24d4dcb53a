#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace study::app {

/// An option or a positional argument of a command, as help pages describe it.
struct OptionDescription {
  std::vector<std::string> names{};    ///< "--out", "-o"; a positional argument has one: "DIR"
  std::string value{};                 ///< placeholder of the value: "FILE"; empty for a flag
  std::string text{};                  ///< what it does
  std::string range{};                 ///< accepted values, in words: "INT in [1 - 100]"
  std::vector<std::string> choices{};  ///< all accepted values, if they can be listed
  std::string initial{};               ///< default value
  bool isRequired = false;
  bool isPositional = false;
};

/// A program or one of its commands, for help pages.
struct CommandDescription {
  std::string name{};  ///< with the program and the commands above it: "palpate study create"
  std::string text{};
  std::vector<OptionDescription> options{};  ///< including positional arguments
  std::vector<CommandDescription> commands{};
};

/// Reads the description of a command line from its parser. Options without a group are hidden from
/// help pages, and are left out here, too.
CommandDescription describe(const CLI::App& program);

/// The sections of a manual page that the command line does not describe. Texts are plain;
/// manPage() escapes them.
struct ManPageSections {
  std::string version{};               ///< "palpate 0.1.0"
  std::string summary{};               ///< the line after the name
  std::string exitStatus{};            ///< empty: without this section
  std::string files{};                 ///< empty: without this section
  std::vector<std::string> seeAlso{};  ///< "palpate(1)"
};

/// A manual page of section 1 (troff, macros of man(7), UTF-8). It has no date, so that every build
/// gives the same bytes.
std::string manPage(const CommandDescription& program, const ManPageSections& sections);

/// A completion script for bash. It completes commands, options and listed values; for everything
/// else it offers file names.
std::string bashCompletion(const CommandDescription& program);

}  // namespace study::app
