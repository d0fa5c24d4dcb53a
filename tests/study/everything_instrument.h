#pragma once

#include <string>

namespace tests {

/// An instrument with an item of every type; one of them names a person and is required.
std::string everythingInstrument();

/// A short protocol with that instrument after the consent, and its files.
std::string protocolWithEverything();

}  // namespace tests
