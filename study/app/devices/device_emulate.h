#pragma once

#include <string>

#include "haptics/devices/device_kind.h"

namespace study::app {

/// The options of `palpate device emulate`.
struct EmulateArguments {
  const haptics::devices::DeviceKind* kind = nullptr;  ///< the kind of a device on a serial line
  std::string link;                                    ///< punch: symbolic link to its port
  std::string client = "127.0.0.1:30200";              ///< iiwa: address to which messages are sent
  std::string version = "1.15";
  std::string model = "iiwa14";
  std::string overlay = "wrench";
  std::string firmware;     ///< punch: firmware for the board, run under QEMU
  int rate = 1000;          ///< punch: rate of its loop [Hz]
  int period = 2;           ///< iiwa: period of messages [ms]
  double advance = 7.0;     ///< iiwa: time in which the hand advances to the full depth [s]
  double clockDrift = 0.0;  ///< punch: drift of its clock [ppm]
  double seconds = 0.0;     ///< duration [s]; 0: until it is stopped
  bool endsWithInput = false;
  unsigned seed = 1;  ///< seed of the random hand movement and of random faults
};

/// Emulates a serial device on a pseudo-terminal, or the arm's controller on UDP. Prints a line
/// "ready …", then executes the lines of its input ("drop 3", "status") until it is stopped.
/// Returns the exit status.
int emulateSerial(const EmulateArguments& arguments);
int emulateIiwa(const EmulateArguments& arguments);

}  // namespace study::app
