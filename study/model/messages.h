#pragma once

#include <array>
#include <utility>

#include "base/message.h"

namespace study {

/// Why a trial did not pass ("trial.…"), whether a device suits a protocol ("preflight.…"), and
/// what is wrong with files of a study ("storage.…", "traces.…"). Messages of trials are stored by
/// key and arguments, so neither may change.
inline constexpr auto kMessages = std::to_array<base::MessageKind>({
    {"trial.broke_off", "the trial broke off ({})"},
    {"trial.broke_off.fault", "the trial broke off ({}: {})"},
    {"trial.samples_kept", "{} of {} samples were kept"},
    {"trial.samples_lost", "{} samples were lost"},
    {"trial.samples_lost.one", "{} sample was lost"},
    {"trial.device_silent", "the device was silent for {} ticks"},
    {"trial.device_silent.one", "the device was silent for {} tick"},
    {"trial.wire_faults",
     "on the device's wire {} were lost, {} doubled, {} late, {} damaged, {} foreign"},
    {"trial.leaps", "the position leapt {} times, faster than any hand: check the encoder's cable"},
    {"trial.leaps.one",
     "the position leapt {} time, faster than any hand: check the encoder's cable"},
    {"trial.clipped", "the device gave less than it was asked for in {} ticks"},
    {"trial.clipped.one", "the device gave less than it was asked for in {} tick"},
    {"trial.rate", "{:.0f} of {:.0f} Hz were reached"},
    {"trial.late", "{} of {} ticks were late"},
    {"trial.late.machine",
     "{} of {} ticks were late, {} of them because the machine itself stood still"},
    {"trial.cut_off", "the force was cut off for {:.2f} s of {:.2f} s"},
    {"trial.torque_cut_off", "the torque was cut off for {:.2f} s of {:.2f} s"},
    {"trial.no_device", "the device was simulated: the participant felt no force"},
    {"trial.no_torque", "not rendered: torque"},
    {"trial.no_force", "the scene had no force for {:.3f} s"},
    {"trial.damping",
     "passivity (b > KT/2) needs {:.3g} N·s/{} of damping, the device has {:.3g}, the rest is the "
     "hand's"},
    {"trial.limit_cycle",
     "on a hand that rests the force alternates by {:.3g} N at {:.4g} Hz: no damping takes that "
     "up"},
    {"trial.too_fast", "the tool was too fast, and the force faded ({}×, {:.3f} s)"},
    {"trial.released", "the dead-man switch was released ({}×, {:.3f} s)"},
    {"trial.lost_beats", "the loop lost beats, and the force faded ({}×, {:.3f} s)"},
    {"trial.not_finite", "the scene asked for a force that is no number ({}×, {:.3f} s)"},
    {"trial.active",
     "the scene gave more energy than it was given: it may have vibrated ({}×, {:.3f} s)"},
    {"trial.soft_start",
     "the force never came on: the scene asked for too much all along ({}×, {:.3f} s)"},
    {"preflight.instrument", "instrument"},
    {"preflight.instrument.fix", "The protocol needs a {} here."},
    {"preflight.force", "force that the protocol asks for"},
    {"preflight.force.limits", "{:g} N of {:g} N"},
    {"preflight.force.fix",
     "Scenes that ask for more are cut off, the same for every condition, and every trial says so; "
     "scale the scenes (force_scale) or lower max_force_n."},
    {"preflight.damping", "damping that the scenes need"},
    {"preflight.damping.limits", "up to {:.3g} of {:.3g} N·s/{} at {:.0f} Hz"},
    {"preflight.damping.fix",
     "Scenes may vibrate unless the hand takes that up, and trials are judged by it: "
     "\"slope_limit\" "
     "makes a cut gentler."},
    {"preflight.damping.fix.fri",
     "Scenes may vibrate unless the hand takes that up, and trials are judged by it: choose a "
     "shorter send period on the robot (2 or 1 ms)."},
    {"preflight.torque", "torque that the protocol asks for"},
    {"preflight.torque.limits", "{:g} N·m of {:g} N·m"},
    {"preflight.torque.fix",
     "Scenes that ask for more are cut off, and every trial says so; scale the scenes "
     "(force_scale) or lower max_torque_nm of the protocol."},
    {"preflight.no_torque.fix",
     "The device gives no torque, and every trial says so. Raise max_torque_nm in the device file "
     "if the arm can give one."},
    {"preflight.device_file", "device file"},
    {"preflight.device_file.missing", "no device of that name"},
    {"preflight.device_file.fix", "Add it to the device file, or give it that id."},
    {"storage.busy",
     "Could not use {}: another program is using it. Close it there, or wait, and try again."},
    {"storage.disk_full",
     "Could not write to {}: the disk is full. Free some space and try again; what was confirmed "
     "is not lost."},
    {"storage.quota_used_up",
     "Could not write to {}: this account's share of the disk (quota) is used up. Free some space "
     "and try again; what was confirmed is not lost."},
    {"storage.not_writable",
     "Could not use {}: it may not be written. Check who owns the folder, and the disk."},
    {"storage.disk_error",
     "Could not use {}: the disk reports an error ({}). Is it healthy and connected?"},
    {"traces.damaged", "{} is damaged: second {} of a trial is not what was recorded."},
    {"traces.unreadable", "the traces cannot be read; 'palpate study verify' says more"},
});

/// One of these messages, with its arguments.
template <typename... Arguments>
base::Message message(
    base::CheckedKey<kMessages, sizeof...(Arguments)> key, Arguments&&... arguments) {
  return base::messageOf<kMessages>(key, std::forward<Arguments>(arguments)...);
}

}  // namespace study
