#include "haptics/devices/serial_port.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "haptics/devices/device.h"
#include "haptics/devices/messages.h"
#include "haptics/timing/monotonic_clock.h"

namespace haptics::devices {
namespace {

base::Message openErrorMessage(const std::string& path, int error) {
  if (error == ENOENT || error == ENODEV || error == ENXIO) {
    std::string there;
    for (const auto& port : serialPorts()) there += (there.empty() ? "" : ", ") + port;
    return there.empty() ? deviceMessage("device.no_port", path)
                         : deviceMessage("device.no_port.others", path, there);
  }
  if (error == EACCES || error == EPERM) {
    return deviceMessage("device.port_forbidden", path);
  }
  if (error == EBUSY || error == EWOULDBLOCK) {
    return deviceMessage("device.port_in_use", path);
  }
  return deviceMessage("device.port_failed", path, std::strerror(error));
}

constexpr std::array<std::pair<int, speed_t>, 6> kBaudRates{
    {{115'200, B115200},
     {230'400, B230400},
     {460'800, B460800},
     {921'600, B921600},
     {1'000'000, B1000000},
     {2'000'000, B2000000}}};

const std::pair<int, speed_t>* speedOf(int baud) noexcept {
  const auto* speed =
      std::ranges::find_if(kBaudRates, [&](const auto& known) { return known.first == baud; });
  return speed == kBaudRates.end() ? nullptr : speed;
}

void makeRaw(int descriptor, const std::string& path, int baud) {
  termios settings{};
  if (tcgetattr(descriptor, &settings) != 0) {
    throw DeviceError(deviceMessage("device.port_no_port", path));
  }
  cfmakeraw(&settings);
  settings.c_cflag |= CLOCAL | CREAD;
  // So that closing the port does not reset the board.
  settings.c_cflag &= ~static_cast<tcflag_t>(HUPCL);
  settings.c_cc[VMIN] = 0;
  settings.c_cc[VTIME] = 0;
  if (baud != 0) {
    const auto* speed = speedOf(baud);
    if (speed == nullptr) {
      throw DeviceError(
          deviceMessage("device.port_speed", path, baud, SerialPort::supportedSpeeds()));
    }
    cfsetspeed(&settings, speed->second);
  }
  if (tcsetattr(descriptor, TCSANOW, &settings) != 0)
    throw DeviceError(openErrorMessage(path, errno));
}

}  // namespace

bool SerialPort::supportsBaud(int baud) noexcept {
  return baud == 0 || speedOf(baud) != nullptr;
}

std::string SerialPort::supportedSpeeds() {
  std::string text;
  for (const auto& [baud, speed] : kBaudRates) {
    text += (text.empty() ? "" : ", ") + std::to_string(baud);
  }
  return text;
}

void SerialPort::open(const std::string& path, int baud) {
  close();
  const int descriptor = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) throw DeviceError(openErrorMessage(path, errno));
  descriptor_ = descriptor;
  try {
    // TIOCEXCL refuses other processes unless they are root; flock refuses those that also use
    // flock.
    if (flock(descriptor, LOCK_EX | LOCK_NB) != 0) throw DeviceError(openErrorMessage(path, EBUSY));
    makeRaw(descriptor, path, baud);
    isExclusive_ = ioctl(descriptor, TIOCEXCL) == 0;
  } catch (...) {
    close();
    throw;
  }
  discardInput();
}

void SerialPort::close() noexcept {
  if (descriptor_ < 0) return;
  // The flag is the terminal's: another program that has the port open may have set it.
  if (std::exchange(isExclusive_, false)) ioctl(descriptor_, TIOCNXCL);
  ::close(descriptor_);
  descriptor_ = -1;
}

void SerialPort::waitReadable(std::int64_t deadline) noexcept {
  const std::int64_t left = deadline - timing::now();
  if (left <= 0) return;
  const timespec time{.tv_sec = left / timing::kSecond, .tv_nsec = left % timing::kSecond};
  pollfd watched{.fd = descriptor_, .events = POLLIN, .revents = 0};
  ppoll(&watched, 1, &time, nullptr);
  constexpr short kGone = POLLHUP | POLLERR | POLLNVAL;
  if ((watched.revents & kGone) != 0 && (watched.revents & POLLIN) == 0) close();
}

std::size_t SerialPort::read(std::span<std::uint8_t> into) noexcept {
  if (descriptor_ < 0) return 0;
  const ssize_t count = ::read(descriptor_, into.data(), into.size());
  if (count > 0) return static_cast<std::size_t>(count);
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) return 0;
  if (count < 0) {
    close();
    return 0;
  }
  // Zero bytes mean that none are available (VMIN 0), or that the other end has hung up.
  pollfd watched{.fd = descriptor_, .events = POLLIN, .revents = 0};
  if (poll(&watched, 1, 0) > 0 && (watched.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0) close();
  return 0;
}

bool SerialPort::write(std::span<const std::uint8_t> bytes) noexcept {
  std::size_t written = 0;
  // If part of a frame was written, retry: frames are short, so the buffer has space for the rest
  // soon.
  constexpr int kTries = 4;
  for (int i = 0; i < kTries && descriptor_ >= 0 && written < bytes.size(); ++i) {
    const ssize_t count = ::write(descriptor_, bytes.data() + written, bytes.size() - written);
    if (count > 0) {
      written += static_cast<std::size_t>(count);
    } else if (count < 0 && errno != EAGAIN && errno != EINTR) {
      close();
    } else if (written == 0) {
      break;
    }
  }
  return written == bytes.size();
}

void SerialPort::discardInput() noexcept {
  if (descriptor_ >= 0) tcflush(descriptor_, TCIFLUSH);
}

std::vector<std::string> serialPorts() {
  namespace fs = std::filesystem;
  std::vector<std::string> ports;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator("/dev/serial/by-id", ignored)) {
    ports.push_back(entry.path().string());
  }
  if (ports.empty()) {
    for (const auto& entry : fs::directory_iterator("/dev", ignored)) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with("ttyACM") || name.starts_with("ttyUSB")) {
        ports.push_back(entry.path().string());
      }
    }
  }
  std::ranges::sort(ports);
  return ports;
}

}  // namespace haptics::devices
