#include "study/app/studio_options.h"

namespace study::app {

CommandDescription describeStudio() {
  return {
      .name = "palpate-studio",
      .text = "The windows of Palpate: for the operator of a study, and for its participants.",
      .options = {
          {.names = {"PATH"},
           .text = "Folder of a study, its study.db, or a protocol (.json) to look at (default: "
                   "the list "
                   "of all studies on this computer).",
           .isPositional = true},
          {.names = {"-h", "--help"}, .text = "Print the options and end."},
          {.names = {"-v", "--version"}, .text = "Print the version and end."},
          {.names = {"--devices"},
           .value = "FILE",
           .text = "The laboratory's device file (default: devices.json in the study's folder)."},
          {.names = {"--write-knee"},
           .value = "FILE",
           .text = "Only write the built-in knee to a new OBJ file, a template for your own "
                   "anatomy."}}};
}

std::string nameOf(const OptionDescription& option) {
  const auto& name = option.names.back();
  return name.substr(name.find_first_not_of('-'));
}

}  // namespace study::app
