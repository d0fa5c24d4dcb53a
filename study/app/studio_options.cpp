#include "study/app/studio_options.h"

namespace study::app {

CommandDescription describeStudio() {
  return {
      .name = "palpate-studio",
      .text = "The windows of a study: for the operator, and for the participant.",
      .options = {
          {.names = {"PATH"},
           .text =
               "A study's folder or its study.db, or a protocol (.json) to look at; left out: all "
               "studies of this computer.",
           .isPositional = true},
          {.names = {"-h", "--help"}, .text = "Print the options and end."},
          {.names = {"-v", "--version"}, .text = "Print the version and end."},
          {.names = {"--devices"},
           .value = "FILE",
           .text = "The laboratory's device file (default: devices.json in the study's folder)."},
          {.names = {"--write-knee"},
           .value = "FILE",
           .text = "Write the built-in knee as an OBJ file, a template for your own anatomy, and "
                   "exit."}}};
}

std::string nameOf(const OptionDescription& option) {
  const auto& name = option.names.back();
  return name.substr(name.find_first_not_of('-'));
}

}  // namespace study::app
