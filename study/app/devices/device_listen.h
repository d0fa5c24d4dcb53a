#pragma once

#include <string>

namespace study::app {

/// The options of `palpate device listen`.
struct ListenArguments {
  std::string port;
  std::string out;  ///< a new CSV file; empty: the terminal
  int baud = 115'200;
  double seconds = 0.0;  ///< duration [s]; 0: until it is stopped
};

/// Records the serial output of a punch that runs the published Arduino sketch: one row for each
/// line, with its time of arrival. Sends nothing to the punch. Returns the exit status: 1 if no
/// valid line arrived.
int listen(const ListenArguments& arguments);

}  // namespace study::app
