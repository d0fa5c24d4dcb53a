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
  std::string value{};                 ///< placeholder of the value: "FILE"; a flag has none
  std::string text{};                  ///< what it does
  std::string range{};                 ///< which values are accepted, in words: "INT in [1 - 100]"
  std::vector<std::string> choices{};  ///< all accepted values, where they can be listed
  std::string initial{};               ///< its value where it is left out
  bool isRequired = false;
  bool isPositional = false;
};

/// A program or one of its commands.
struct CommandDescription {
  std::string name{};  ///< with the program and all commands above: "palpate study create"
  std::string text{};
  std::vector<OptionDescription> options{};  ///< positional arguments among them
  std::vector<CommandDescription> commands{};
};

/// Reads the description of a command line from its parser. Options in no group are hidden from
/// help pages; they are left out here too.
CommandDescription describe(const CLI::App& program);

/// The sections of a manual page that the command line itself does not describe. Texts are plain:
/// manPage() escapes them.
struct ManPageSections {
  std::string version{};               ///< "palpate 0.1.0"
  std::string summary{};               ///< after the name, in one line
  std::string exitStatus{};            ///< empty: no such section
  std::string files{};                 ///< empty: no such section
  std::vector<std::string> seeAlso{};  ///< "palpate(1)"
};

/// A manual page of section 1 (troff, macros of man(7), UTF-8). It carries no date: two builds give
/// the same bytes.
std::string manPage(const CommandDescription& program, const ManPageSections& sections);

/// A completion script for bash. Commands, options and listed values are completed; all other
/// words are file names.
std::string bashCompletion(const CommandDescription& program);

}  // namespace study::app
