#include "study/app/command_reference.h"

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

#include <CLI/CLI.hpp>

#include "base/joined.h"

namespace study::app {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

/// A range of CLI11 in words: "1 to 100" for "INT in [1 - 100]"; other validators as they are.
std::string rangeInWords(const std::string& validator) {
  if (validator == "POSITIVE") return "above 0";
  if (validator == "NONNEGATIVE") return "0 or above";
  const auto open = validator.find(" in [");
  const auto between = validator.find(" - ", open);
  const bool isRange = open != std::string::npos && between != std::string::npos &&
                       validator.find(' ') == open && validator.back() == ']';
  if (!isRange) return validator;
  const auto least = open + std::string(" in [").size();
  const auto most = between + std::string(" - ").size();
  return validator.substr(least, between - least) + " to " +
         validator.substr(most, validator.size() - 1 - most);
}

/// Reads CLI11's description of a type, "TEXT:{csv,json}", "INT:INT in [1 - 100]" or "TEXT:DIR":
/// the type, a colon, and the validator.
void readType(const std::string& type, OptionDescription& option) {
  const auto colon = type.find(':');
  option.value = type.substr(0, colon);
  if (option.value == "INT" || option.value == "UINT" || option.value == "FLOAT") {
    option.value = "NUMBER";
  }
  if (colon == std::string::npos) return;
  const std::string validator = type.substr(colon + 1);
  if (validator == "DIR") {
    option.value = "FOLDER";
  } else if (validator == "FILE") {
    option.value = "FILE";
  } else if (validator.size() > 2 && validator.front() == '{' && validator.back() == '}') {
    option.choices = split(validator.substr(1, validator.size() - 2), ',');
  } else if (const auto either = validator.find("}) OR ("); either != std::string::npos) {
    constexpr std::size_t kBrackets = 2;  // "({"
    option.choices = split(validator.substr(kBrackets, either - kBrackets), ',');
    const auto other = validator.substr(either + std::string("}) OR (").size());
    option.range = "or " + rangeInWords(other.substr(0, other.size() - 1));
  } else {
    option.range = rangeInWords(validator);
  }
}

OptionDescription describe(const CLI::Option& option) {
  OptionDescription described{
      .text = option.get_description(),
      .defaultValue = option.get_default_str(),
      .isRequired = option.get_required(),
      .isPositional = option.get_positional()};
  for (const auto& name : option.get_snames()) described.names.push_back("-" + name);
  for (const auto& name : option.get_lnames()) described.names.push_back("--" + name);
  if (described.names.empty()) described.names.push_back(option.get_name(true));
  if (option.get_items_expected_max() > 0) readType(option.get_type_name(), described);
  return described;
}

CommandDescription describe(const CLI::App& command, const std::string& above) {
  CommandDescription described{
      .name = above + command.get_name(), .text = command.get_description()};
  for (const auto* option : command.get_options({})) {
    if (!option->get_group().empty()) described.options.push_back(describe(*option));
  }
  for (const auto* below : command.get_subcommands({})) {
    if (!below->get_group().empty()) {
      described.commands.push_back(describe(*below, described.name + " "));
    }
  }
  return described;
}

/// Text for troff. Escapes the hyphen-minus, so that options can be copied from the page.
std::string escaped(const std::string& text) {
  std::string result;
  bool isLineStart = true;
  for (const char c : text) {
    // troff reads a dot or an apostrophe at the start of a line as a request
    if (isLineStart && (c == '.' || c == '\'')) result += "\\&";
    isLineStart = c == '\n';
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else if (c == '\'') {
      result += "\\(aq";
    } else if (c == '`') {
      result += "\\(ga";
    } else if (c == '^') {
      result += "\\(ha";
    } else if (c == '~') {
      result += "\\(ti";
    } else {
      result += c;
    }
  }
  return result;
}

std::string bold(const std::string& text) {
  return "\\fB" + escaped(text) + "\\fR";
}
std::string italic(const std::string& text) {
  return "\\fI" + escaped(text) + "\\fR";
}

std::string heading(const OptionDescription& option) {
  if (option.isPositional) return italic(option.names.front());
  std::vector<std::string> names;
  for (const auto& name : option.names) names.push_back(bold(name));
  return base::joined(names, ", ") + (option.value.empty() ? "" : " " + italic(option.value));
}

/// The remarks after an option's description: accepted values, default, and whether it is required.
std::string remarks(const OptionDescription& option) {
  std::vector<std::string> parts;
  if (option.isRequired) parts.emplace_back("required");
  if (!option.choices.empty()) parts.push_back("one of: " + base::joined(option.choices, ", "));
  if (!option.range.empty()) parts.push_back(option.range);
  if (!option.defaultValue.empty()) parts.push_back("default: " + option.defaultValue);
  return parts.empty() ? "" : " (" + base::joined(parts, "; ") + ")";
}

std::string sectionOfOptions(const CommandDescription& command) {
  std::string text;
  for (const bool isPositional : {true, false}) {
    for (const auto& option : command.options) {
      if (option.isPositional != isPositional) continue;
      text += ".TP\n" + heading(option) + "\n" + escaped(option.text + remarks(option)) + "\n";
    }
  }
  return text;
}

std::string synopsis(const CommandDescription& command) {
  std::string text = ".B " + escaped(command.name) + "\n";
  for (const auto& option : command.options) {
    if (option.isPositional || !option.isRequired) continue;
    text += bold(option.names.back()) + " " + italic(option.value) + "\n";
  }
  if (!command.options.empty()) text += "[" + italic("OPTIONS") + "]\n";
  for (const auto& option : command.options) {
    if (!option.isPositional) continue;
    const auto name = italic(option.names.front());
    text += option.isRequired ? name + "\n" : "[" + name + "]\n";
  }
  if (!command.commands.empty()) text += italic("COMMAND") + "\n";
  return text;
}

/// Adds a section for each subcommand of @p above, and for their subcommands.
void addCommands(const CommandDescription& above, std::string& page) {
  for (const auto& command : above.commands) {
    page += ".SS " + escaped(command.name) + "\n" + synopsis(command) + ".PP\n" +
            escaped(command.text) + "\n" + sectionOfOptions(command);
    addCommands(command, page);
  }
}

/// A word in double quotes, for a case label or a list.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\' || c == '$' || c == '`') result += '\\';
    result += c;
  }
  return result + "\"";
}

struct CompletionCases {
  std::vector<std::string> commands;  ///< patterns of commands below the program
  std::string values;                 ///< allowed values of an option
  std::string words;                  ///< commands and options of a command
};

void addCompletions(const CommandDescription& command, CompletionCases& cases) {
  std::vector<std::string> verbs;
  std::vector<std::string> options;
  for (const auto& below : command.commands) {
    verbs.push_back(below.name.substr(below.name.rfind(' ') + 1));
    cases.commands.push_back(quoted(below.name));
  }
  for (const auto& option : command.options) {
    if (option.isPositional) {
      verbs.insert(verbs.end(), option.choices.begin(), option.choices.end());
      continue;
    }
    options.insert(options.end(), option.names.begin(), option.names.end());
    if (option.value.empty()) continue;
    std::vector<std::string> labels;
    for (const auto& name : option.names) labels.push_back(quoted(command.name + " " + name));
    cases.values += "    " + base::joined(labels, " | ") +
                    ") words=" + quoted(base::joined(option.choices, " ")) + " ;;\n";
  }
  cases.words += "    " + quoted(command.name) + ") words=" + quoted(base::joined(verbs, " ")) +
                 " options=" + quoted(base::joined(options, " ")) + " ;;\n";
  for (const auto& below : command.commands) addCompletions(below, cases);
}

/// Shows the value of an option as manual pages do: what it is, its range and its default.
class HelpFormatter final : public CLI::Formatter {
 public:
  std::string make_option_opts(const CLI::Option* option) const override {
    const auto described = describe(*option);
    std::string text;
    if (!described.choices.empty()) {
      text += " {" + base::joined(described.choices, ",") + "}";
    } else if (!described.value.empty() && !described.isPositional) {
      text += " " + described.value;
    }
    std::vector<std::string> remarks;
    if (!described.range.empty()) remarks.push_back(described.range);
    if (!described.defaultValue.empty()) remarks.push_back("default: " + described.defaultValue);
    if (!option->get_envname().empty()) remarks.push_back("or $" + option->get_envname());
    if (!remarks.empty()) text += " (" + base::joined(remarks, "; ") + ")";
    if (option->get_expected_max() == CLI::detail::expected_max_vector_size) text += " ...";
    if (described.isRequired) text += " REQUIRED";
    text += namesOf("Needs", option->get_needs());
    return text + namesOf("Excludes", option->get_excludes());
  }

  std::string make_option_desc(const CLI::Option* option) const override {
    return wrapped(option->get_description());
  }

 private:
  /// @p text in lines of at most kMostPerLine bytes, broken at blanks.
  static std::string wrapped(const std::string& text) {
    constexpr std::size_t kMostPerLine = 96;
    std::string lines;
    std::size_t length = 0;
    for (const auto& word : split(text, ' ')) {
      const bool isBroken = length + 1 + word.size() > kMostPerLine;
      if (!lines.empty()) lines += isBroken ? '\n' : ' ';
      length = (isBroken ? 0 : length + 1) + word.size();
      lines += word;
    }
    return lines;
  }

  static std::string namesOf(const char* label, const std::set<CLI::Option*>& options) {
    if (options.empty()) return "";
    std::vector<std::string> names;
    for (const auto* option : options) names.push_back(option->get_name());
    std::ranges::sort(names);
    return std::string(" ") + label + ": " + base::joined(names, " ");
  }
};

}  // namespace

void setHelpFormat(CLI::App& program) {
  constexpr std::size_t kColumnOfDescriptions = 34;
  program.formatter(std::make_shared<HelpFormatter>());
  program.get_formatter()->column_width(kColumnOfDescriptions);
}

CommandDescription describe(const CLI::App& program) {
  return describe(program, "");
}

namespace {

void rename(CommandDescription& command, std::size_t length, const std::string& name) {
  command.name.replace(0, length, name);
  for (auto& below : command.commands) rename(below, length, name);
}

}  // namespace

void addCommandsOf(
    CommandDescription program, const std::string& name, CommandDescription& starter) {
  const auto full = starter.name + " " + name;
  const auto command = std::ranges::find(starter.commands, full, &CommandDescription::name);
  if (command == starter.commands.end()) return;
  const auto length = program.name.size();
  rename(program, length, full);
  *command = std::move(program);
}

std::string manPage(const CommandDescription& program, const ManPageSections& sections) {
  std::string title;
  for (const char c : program.name) title += c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c;
  std::string page = ".TH " + escaped(title) + " 1 \"\" \"" + escaped(sections.version) +
                     "\" \"Palpate\"\n.SH NAME\n" + escaped(program.name) + " \\- " +
                     escaped(sections.summary) + "\n.SH SYNOPSIS\n" + synopsis(program) +
                     ".SH DESCRIPTION\n" + escaped(program.text) + "\n.SH OPTIONS\n" +
                     sectionOfOptions(program);
  if (!program.commands.empty()) {
    page += ".SH COMMANDS\n";
    addCommands(program, page);
  }
  const auto add = [&](const char* name, const std::string& text) {
    if (!text.empty()) page += ".SH " + std::string(name) + "\n" + escaped(text) + "\n";
  };
  add("EXIT STATUS", sections.exitStatus);
  add("FILES", sections.files);
  add("SEE ALSO", base::joined(sections.seeAlso, ", "));
  return page;
}

std::string bashCompletion(const CommandDescription& program) {
  CompletionCases cases;
  addCompletions(program, cases);
  std::string function = "_" + program.name;
  for (char& c : function) {
    if (c == '-') c = '_';
  }
  std::string script =
      "# bash completion for " + program.name + ", generated from its command line\n\n" + function +
      "() {\n"
      "  local word=\"${COMP_WORDS[COMP_CWORD]}\" before=\"${COMP_WORDS[COMP_CWORD - 1]}\"\n"
      "  local command=" +
      quoted(program.name) + " words=\"\" options=\"\" i\n";
  if (!cases.commands.empty()) {
    script +=
        "  for ((i = 1; i < COMP_CWORD; i++)); do\n"
        "    case \"$command ${COMP_WORDS[i]}\" in\n"
        "      " +
        base::joined(cases.commands, " | \\\n      ") +
        ")\n"
        "        command+=\" ${COMP_WORDS[i]}\" ;;\n"
        "    esac\n"
        "  done\n";
  }
  script += "  case \"$command $before\" in\n" + cases.values +
            "    *)\n"
            "      case \"$command\" in\n" +
            cases.words +
            "      esac ;;\n"
            "  esac\n"
            "  [[ \"$word\" != -* ]] || words=\"$options\"\n"
            "  mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\")\n"
            "}\n"
            "complete -o bashdefault -o default -F " +
            function + " " + program.name + "\n";
  return script;
}

}  // namespace study::app
