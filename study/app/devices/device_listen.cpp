#include "study/app/devices/device_listen.h"

#include <array>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>

#include <fmt/format.h>

#include "haptics/devices/serial_port.h"
#include "haptics/timing/monotonic_clock.h"
#include "haptics/wire/sketch_line.h"
#include "study/model/user_error.h"

namespace study::app {
namespace {

namespace timing = haptics::timing;
using haptics::wire::SketchForces;
using haptics::wire::SketchMesh;

volatile std::sig_atomic_t isStopRequested = 0;

void stopOnSignal(int) {
  isStopRequested = 1;
}

/// A row of the CSV file: the time, then the values of the line. Missing values are empty cells.
struct Row {
  double time;  // [s]

  std::string operator()(const SketchMesh& mesh) const {
    return fmt::format("{:.6f},mesh,{},,,\n", time, mesh.toolDisplacement());
  }
  std::string operator()(const SketchForces& forces) const {
    return fmt::format(
        "{:.6f},forces,,{},{},{}\n",
        time,
        forces.finiteElements,
        forces.interpolation,
        forces.average);
  }
};

}  // namespace

int listen(const ListenArguments& arguments) {
  if (!arguments.out.empty() && std::filesystem::exists(arguments.out)) {
    throw UserError(arguments.out + " is there already. Name a file that is not.");
  }
  haptics::devices::SerialPort port;
  port.open(arguments.port, arguments.baud);
  std::ofstream file;
  if (!arguments.out.empty()) file.open(arguments.out);
  std::ostream& out = arguments.out.empty() ? std::cout : file;
  out << "time_s,kind,tool_displacement,finite_elements_n,interpolation_n,average_n\n"
      << std::flush;
  std::signal(SIGINT, stopOnSignal);
  std::signal(SIGTERM, stopOnSignal);

  const std::int64_t begin = timing::now();
  const std::int64_t until = arguments.seconds > 0.0
                                 ? begin + static_cast<std::int64_t>(1e9 * arguments.seconds)
                                 : std::numeric_limits<std::int64_t>::max();
  constexpr std::size_t kLongestLine = 1000;
  std::string line;
  std::int64_t understood = 0;
  std::int64_t others = 0;
  while (port.isOpen() && isStopRequested == 0 && timing::now() < until) {
    port.waitReadable(std::min(until, timing::now() + 100 * timing::kMillisecond));
    std::array<std::uint8_t, 512> bytes{};
    const std::size_t count = port.read(bytes);
    const double time = 1e-9 * static_cast<double>(timing::now() - begin);
    for (std::size_t i = 0; i < count; ++i) {
      if (bytes[i] != '\n') {
        if (line.size() < kLongestLine) line += static_cast<char>(bytes[i]);
        continue;
      }
      const auto read = haptics::wire::parseSketchLine(line);
      line.clear();
      ++(read ? understood : others);
      if (read) out << std::visit(Row{time}, *read);
    }
    if (count > 0) out.flush();  // no received row is lost if the program is killed
  }
  out.flush();
  if (understood == 0 && !arguments.out.empty()) std::filesystem::remove(arguments.out);
  if (!out) throw UserError("What was heard could not be written to " + arguments.out + ".");
  fmt::print(
      stderr,
      "{} lines of the published sketch, {} others{}.\n",
      understood,
      others,
      port.isOpen() ? "" : "; then the port was gone");
  if (understood == 0) {
    fmt::print(
        stderr,
        "{} has come that could be written down{}. Is this the punch's port (palpate device list), "
        "is it switched on, is the published sketch on the board, and is its speed the one of "
        "--baud ({})?\n",
        others == 0 ? "Nothing" : "No line",
        arguments.out.empty() ? "" : "; " + arguments.out + " was not made",
        arguments.baud);
  }
  return understood > 0 ? 0 : 1;
}

}  // namespace study::app
