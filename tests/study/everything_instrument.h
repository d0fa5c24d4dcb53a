#pragma once

#include <string>

namespace tests {

/// An instrument with an item of every type, one of them identifying and required.
std::string everythingInstrument();

/// A short protocol that asks it in the step after the consent, with the files it needs.
std::string protocolWithEverything();

}  // namespace tests
