#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>

#include "base/message.h"

namespace haptics::devices {

/// What devices say: why they cannot be used ("device.…"), the faults that end a trial ("fault.…"),
/// and the results of a check ("check.…"; "check.….fix": what to do). The first argument of the
/// first two is the port or address of the device.
inline constexpr auto kDeviceMessages = std::to_array<base::MessageKind>({
    // Any device on a wire
    {"device.not_ready",
     "the device at {} is not ready: put right what is wrong and try again; the program then "
     "connects again"},
    {"fault.unplugged", "{}: it has been unplugged, or its port has failed"},
    {"fault.silent", "{}: it has fallen silent"},
    {"fault.no_thread", "{}: no thread could be started to look after it"},

    // A serial port and its board
    {"device.no_port",
     "There is no serial port {}. Is the device plugged in and switched on? No other serial port "
     "is there."},
    {"device.no_port.others",
     "There is no serial port {}. Is the device plugged in and switched on? Serial ports that are "
     "there: {}."},
    {"device.port_forbidden",
     "You may not use the serial port {}. Become a member of its group (on Debian: sudo adduser "
     "$USER dialout) and log in again."},
    {"device.port_in_use",
     "The serial port {} is in use by another program. End that one (another palpate, a serial "
     "monitor) and try again."},
    {"device.port_failed",
     "The serial port {} cannot be opened: {}. Unplug the device, plug it in again, and try "
     "again."},
    {"device.port_no_port", "{} is no serial port. Choose another in the device file."},
    {"device.port_speed",
     "The serial port {} cannot go at {} baud here. Choose one of {}, or 0 for USB."},
    {"device.no_answer",
     "The device at {} does not answer. Is it the right port, is the motor's supply on, and does "
     "the board run palpate's firmware (docs/devices.md)?"},
    {"device.other_protocol",
     "The device at {} speaks version {} of the protocol, and this program version {}. Put the "
     "firmware of this palpate on the board (docs/devices.md)."},
    {"device.other_firmware",
     "The device at {} runs firmware {}, and not {}. Put that one on the board, or write "
     "\"firmware\": \"{}\" into the device file if it is meant."},
    {"device.other_board",
     "The device at {} is board {}, and board {} is meant. Its calibration does not hold for "
     "another: connect the right one."},
    {"device.impossible_board",
     "The device at {} says of itself what cannot be ({} Hz, {} mV). Put the firmware on the board "
     "again."},
    {"device.scene_unanswered",
     "The device at {} does not answer to the scene it was sent. Try again."},
    {"device.scene_too_early",
     "The device at {} is not ready to be sent a scene. Connect it, and try again."},
    {"device.scene_unsound",
     "The device at {} did not take the scene as it was sent: it finds it unsound. Try again, or "
     "let the host render it."},
    {"device.scene_differs",
     "The device at {} did not take the scene as it was sent: its hash differs. Try again, or let "
     "the host render it."},
    {"device.scene.opening",
     "The device at {} cannot render a scene with an opening branch by itself. Let the host render "
     "it (\"renders\": \"host\" in the device file)."},
    {"device.scene.long_curve",
     "The device at {} cannot render a curve of more than 128 points by itself. Let the host "
     "render "
     "it (\"renders\": \"host\" in the device file)."},
    {"device.scene.uneven",
     "The device at {} cannot render elements of different stiffness by itself. Let the host "
     "render it (\"renders\": \"host\" in the device file)."},
    {"device.scene.many_elements",
     "The device at {} cannot render more than 255 elements by itself. Let the host render it "
     "(\"renders\": \"host\" in the device file)."},
    {"device.scene.as_printed",
     "The device at {} cannot render Q as it is printed by itself. Let the host render it "
     "(\"renders\": \"host\" in the device file)."},
    {"device.scene.smoothing",
     "The device at {} cannot render a scene with smoothing by itself. Let the host render it "
     "(\"renders\": \"host\" in the device file)."},
    {"device.scene.bone",
     "The device at {} cannot render bone by itself. Let the host render it (\"renders\": \"host\" "
     "in the device file)."},
    {"fault.board_silent", "{}: it has sent nothing for 50 ms"},
    {"fault.only_damaged",
     "{}: for 50 ms it has sent damaged frames only: check the cable, and what disturbs it"},
    {"fault.lost_count", "{}: it is where it cannot be: its encoder has lost count"},
    {"fault.leaps", "{}: its position leaps: check the encoder's cable"},
    {"fault.driver", "{}: the motor's driver reports a fault"},
    {"fault.encoder", "{}: its encoder jumps"},
    {"fault.too_fast", "{}: it moves faster than any hand"},
    {"fault.host_paused",
     "{}: it has let go by itself, because this computer stood still: end other programs"},
    {"fault.let_go", "{}: it has let go by itself: it was restarted, or we were silent"},

    // A robot's arm
    {"device.arm_settings",
     "The arm at {} needs a numeric address such as 172.31.1.147, and an axis of reaming that is "
     "not 0, in the device file."},
    {"device.arm_port",
     "The arm at {}: UDP port {} cannot be had ({}). End the other program that uses it, or choose "
     "another port here and on the robot."},
    {"device.arm_slow",
     "The arm at {} wants an answer every {} ms only: too slow to feel. Set the send period of its "
     "application to 1 to 5 ms."},
    {"device.arm_unreadable",
     "The arm at {} sends what cannot be read as FRI {}. Correct fri_version in the device file."},
    {"device.arm_elsewhere",
     "The arm at {} sends nothing to UDP port {}, but {} does ({} datagrams): is that the robot? "
     "Then write \"robot_address\": \"{}\" in the device file."},
    {"device.arm_silent",
     "The arm at {} sends nothing to UDP port {}. Start the application with FRI on its SmartPad, "
     "with this computer's address as its client."},
    {"device.arm_no_forces",
     "The arm at {} takes no forces: its session is not in COMMANDING_ACTIVE. Let the robot's "
     "application start its motion with the FRI overlay, and look there for what it waits for."},
    {"fault.new_session", "{}: its controller has begun a new session"},
    {"fault.not_commanding", "{}: its controller has stopped commanding; its SmartPad says why"},
    {"fault.safety_stop", "{}: a safety stop of the robot is active"},
    {"fault.drives", "{}: its drives are not active"},
    {"fault.no_joints", "{}: it does not say where its joints are"},
    {"fault.missed_cycles", "{}: it has missed 20 cycles, or been silent for 50 ms"},
    {"fault.poor_connection", "{}: its connection has become worse than GOOD"},
    {"fault.joint_near_end", "{}: joint A{} is near its end"},
    {"fault.joint_too_fast", "{}: joint A{} is too fast"},
    {"fault.joint_overloaded", "{}: joint A{} is overloaded"},

    // Checks of any device
    {"check.simulated", "simulated device"},
    {"check.simulated.nothing", "nothing to connect"},
    {"check.connection", "connection"},
    {"check.connection.failed", "failed"},
    {"check.none", "none"},
    {"check.faults", "faults"},
    {"check.clock", "clock against ours"},
    {"check.clock.drift", "{:+.1f} ppm"},
    {"check.clock.fix",
     "The device's clock may be broken; times of the device are not to be used."},
    {"check.median_and_p99", "half within {:.0f} µs, 99 of 100 within {:.0f} µs"},
    {"check.force", "force at most"},

    // Checks of a board
    {"check.firmware", "firmware"},
    {"check.firmware.found", "fits this program (protocol {}, board {}), up to {:.1f} V, {} Hz"},
    {"check.telemetry", "telemetry"},
    {"check.telemetry.rate", "{:.0f} samples/s of {:.0f}"},
    {"check.telemetry.fix",
     "Use the board's native USB port, and end other programs on this computer."},
    {"check.frames", "frames lost, doubled, late, damaged"},
    {"check.frames.counts", "{}, {}, {}, {}"},
    {"check.frames.fix", "Change the cable, and plug it into the computer itself, not into a hub."},
    {"check.round_trip", "round trip"},
    {"check.round_trip.fix",
     "Stiff scenes may vibrate. Give this program real-time priority: the page on devices, \"Real "
     "time\", says how."},
    {"check.leaps", "leaps of the position"},
    {"check.leaps.fix", "Check the encoder's cable."},
    {"check.travel", "travel"},
    {"check.travel.range", "{:.3f} to {:.3f} {}"},
    {"check.travel.fix",
     "Open the instrument altogether, and correct travel_at_zero in the device file."},
    {"check.board_faults", "faults that the board reports"},
    {"check.board_faults.expired", "no force came in time, so it let go"},
    {"check.board_faults.saturated", "it was asked for more than its largest voltage"},
    {"check.board_faults.too_fast", "it moves faster than any hand"},
    {"check.board_faults.driver", "the motor's driver reports a fault"},
    {"check.board_faults.encoder", "its encoder jumps"},
    {"check.board_faults.bad_frames", "damaged frames have reached it"},
    {"check.board_faults.not_armed", "it is not armed"},
    {"check.board_faults.clock", "its clock has begun again at 0"},
    {"check.board_faults.fix", "Switch the device off and on, then check again."},
    {"check.force.volts", "{:.2f} N ({:.3f} N/V)"},

    // Checks of an arm
    {"check.connection.fri", "FRI {}"},
    {"check.session", "session"},
    {"check.session.state", "{}, connection {}"},
    {"check.session.start", "Start the robot's application."},
    {"check.session.fix",
     "Connect the controller directly to this computer, and give this program real-time priority: "
     "the page on devices, \"Real time\", says how."},
    {"check.overlay", "force overlay"},
    {"check.overlay.active", "active"},
    {"check.overlay.differs", "the robot takes: {}; the device file's overlay is {}"},
    {"check.overlay.either",
     "Write \"overlay\": \"{}\" in the device file, or choose {} in the robot's application."},
    {"check.overlay.choose", "Choose {} in the robot's application."},
    {"check.overlay.unnamed", "active, in a mode that the robot does not name"},
    {"check.overlay.waits", "waits in COMMANDING_WAIT"},
    {"check.overlay.not_yet", "not commanding yet"},
    {"check.overlay.start", "Let the robot's application start its motion with the FRI overlay."},
    {"check.overlay.start_or_choose",
     "Let the robot's application start its motion with the FRI overlay. If it has: the device "
     "file's \"overlay\" (wrench or torque) may be another than the robot's."},
    {"check.silence", "longest silence"},
    {"check.silence.short", "{:.0f} ms"},
    {"check.silence.long", "{:.3f} s (a trial ends at {:.0f} ms)"},
    {"check.silence.lasting",
     "nothing has come from the arm for {:.1f} s (a trial ends at {:.0f} ms)"},
    {"check.silence.long.fix",
     "End other programs on this computer, and use a direct cable; look at the SmartPad for what "
     "stopped it."},
    {"check.silence.lasting.fix",
     "Is the application still running? Look at the SmartPad, and at the cable."},
    {"check.safety", "safety state"},
    {"check.safety.normal", "normal operation"},
    {"check.safety.stop", "safety stop"},
    {"check.safety.fix", "Resolve the stop at the robot, then check again."},
    {"check.cycle", "cycle"},
    {"check.cycle.rate", "{:.0f} messages/s of {:.0f}"},
    {"check.cycle.fix",
     "End other programs on this computer; choose a longer send period on the robot."},
    {"check.messages", "messages lost, doubled, late, damaged, foreign"},
    {"check.messages.counts", "{}, {}, {}, {}, {}"},
    {"check.messages.fix",
     "Use a direct cable; no other computer on this network may send to this port."},
    {"check.answer", "answer seen by the robot after"},
    {"check.joints", "joints"},
    {"check.joints.good", "within their margins"},
    {"check.joints.fix", "Move the arm to its starting pose."},
    {"check.tool", "tool"},
    {"check.tool.place", "at {:.4f}, {:.4f}, {:.4f} m"},
    {"check.force.newtons", "{:.0f} N"},
    {"check.torque", "torque at most"},
    {"check.torque.newton_metres", "{:.3g} N·m"},
    {"check.torque.none", "not rendered: torque"},
});

/// A message of kDeviceMessages with its arguments.
template <typename... Arguments>
base::Message deviceMessage(
    base::CheckedKey<kDeviceMessages, sizeof...(Arguments)> key, Arguments&&... arguments) {
  return base::messageOf<kDeviceMessages>(key, std::forward<Arguments>(arguments)...);
}

/// Why a device ended a trial, or that it has no fault. Made and copied without allocation.
class DeviceFault {
 public:
  DeviceFault() = default;
  /// A message of kDeviceMessages about the whole device.
  consteval DeviceFault(const char* key)  // NOLINT(google-explicit-constructor)
      : kind_(&base::CheckedKey<kDeviceMessages, 1>(key).kind()) {}
  /// One about a joint of an arm, A1 to A7.
  DeviceFault(base::CheckedKey<kDeviceMessages, 2> key, int joint) noexcept
      : kind_(&key.kind()), joint_(joint) {}
  DeviceFault(const base::MessageKind* kind, int joint) noexcept : kind_(kind), joint_(joint) {}

  explicit operator bool() const noexcept { return kind_ != nullptr; }
  const base::MessageKind* kind() const noexcept { return kind_; }
  int joint() const noexcept { return joint_; }

  /// In words, about the device at @p place (its port or address).
  base::Message of(const std::string& place) const {
    if (kind_ == nullptr) return {};
    if (joint_ == 0) return {*kind_, {place}};
    return {*kind_, {place, std::int64_t{joint_}}};
  }

 private:
  const base::MessageKind* kind_ = nullptr;
  int joint_ = 0;
};

}  // namespace haptics::devices
