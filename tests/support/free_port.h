#pragma once

#include <cstdint>

namespace tests {

/// A port of 127.0.0.1 that nothing uses, neither UDP nor TCP. It lies below the ports that the
/// kernel gives to sockets that ask for none (32768 and up), and each process begins elsewhere, so
/// that nothing takes it before the test listens there. Throws std::runtime_error if all are used.
std::uint16_t freePort();

}  // namespace tests
