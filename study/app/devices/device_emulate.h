#pragma once

#include <string>

#include "haptics/devices/device_kind.h"

namespace study::app {

/// What `palpate device emulate` was asked for.
struct EmulateArguments {
  const haptics::devices::DeviceKind* kind = nullptr;  ///< on a serial line: which
  std::string link;                                    ///< punch: a name for its port that stays
  std::string client = "127.0.0.1:30200";              ///< iiwa: where messages go
  std::string version = "1.15";
  std::string model = "iiwa14";
  std::string overlay = "wrench";
  std::string firmware;     ///< punch: a program for the board, to be run under QEMU
  int rate = 1000;          ///< punch: of its loop [Hz]
  int period = 5;           ///< iiwa: between messages [ms]
  double clockDrift = 0.0;  ///< punch: of its clock [ppm]
  double seconds = 0.0;     ///< how long; 0: until it is ended
  bool endsWithInput = false;
  unsigned seed = 1;  ///< of hand and faults
};

/// A stand-in for a device on a pseudo-terminal, or for the arm's controller on UDP. Says "ready
/// …" in a line, then obeys lines of its input ("drop 3", "status") until it is ended. Exit status.
int emulateSerial(const EmulateArguments& arguments);
int emulateIiwa(const EmulateArguments& arguments);

}  // namespace study::app
