#pragma once

#include <string>

namespace study::app {

struct ListenArguments {
  std::string port;
  std::string out;  ///< a new CSV file; empty: the terminal
  int baud = 115'200;
  double seconds = 0.0;  ///< duration [s]; 0: until it is stopped
};

/// Records what a punch with the published sketch prints: one row a line, with the time of its
/// arrival. Sends nothing to it. Returns the exit status: 1 if no valid line has arrived.
int listen(const ListenArguments& arguments);

}  // namespace study::app
