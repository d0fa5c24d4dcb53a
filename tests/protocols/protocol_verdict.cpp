// Loads protocols and says about each whether it is accepted and what was found: for
// tests/support/schema_verdicts.mjs.
#include "protocols/load_protocol.h"
#include "tests/support/verdicts.h"

int main(int argc, char** argv) {
  using namespace protocols;
  tests::printVerdicts(argc, argv, [](const std::string& file, questionnaires::Problems& problems) {
    return loadProtocolFile(file, problems).has_value();
  });
}
