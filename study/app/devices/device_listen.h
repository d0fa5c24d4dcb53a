#pragma once

#include <string>

namespace study::app {

struct ListenArguments {
  std::string port;
  std::string out;  ///< a CSV file to make; empty: the terminal
  int baud = 115'200;
  double seconds = 0.0;  ///< how long; 0: until it is ended
};

/// Writes down what a punch prints that runs the published sketch: one row a line, with the time of
/// its arrival. Nothing is sent to it. Exit status: 1 where no line of its kind has come.
int listen(const ListenArguments& arguments);

}  // namespace study::app
