// Reads instruments and says about each whether it is accepted and what was found: for
// tests/support/schema_verdicts.mjs.
#include "questionnaires/json/document.h"
#include "questionnaires/reading/instrument_file.h"
#include "tests/support/verdicts.h"

int main(int argc, char** argv) {
  using namespace questionnaires;
  tests::printVerdicts(argc, argv, [](const std::string& file, Problems& problems) {
    return readInstrument(readTextFile(file), problems).has_value();
  });
}
