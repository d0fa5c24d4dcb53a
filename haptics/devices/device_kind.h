#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "haptics/devices/hand.h"
#include "haptics/models/cut_detector.h"

namespace haptics::devices {

/// What an instrument is used on. Every force model is of one tissue.
enum class Tissue : std::uint8_t { Meniscus, Bone };

/// What can be seen while an instrument is felt.
enum class View : std::uint8_t { None, Knee, Hip };

/// How the real instruments of a kind are connected.
enum class Wire : std::uint8_t {
  Serial,  ///< docs/punch-protocol.md
  Fri,     ///< docs/fri.md
};

/// A text for people in every language that is shipped.
class Text {
 public:
  using InLanguages = std::vector<std::pair<std::string_view, std::string_view>>;

  /// @param others  language and text: {{"de", "Schnitt"}}.
  Text(std::string_view english, InLanguages others)
      : english_(english), others_(std::move(others)) {}

  /// English where @p language has none; "de" for "de-CH".
  std::string_view in(std::string_view language) const noexcept {
    for (const auto& [tag, text] : others_) {
      if (language.substr(0, language.find('-')) == tag) return text;
    }
    return english_;
  }
  const InLanguages& others() const noexcept { return others_; }

 private:
  std::string_view english_;
  InLanguages others_;
};

/// The moving part of a simulated instrument: a mass with friction between two stops.
struct Mechanism {
  double mass = 0.004;          ///< m [N·s² / travel unit], > 0
  double damping = 0.05;        ///< b [N·s / travel unit], >= 0
  double stopStiffness = 80.0;  ///< [N / travel unit], > 0
  double stopDamping = 0.3;     ///< [N·s / travel unit], >= 0
  double resolution = 0.0;      ///< of the encoder [travel unit]; 0: none
  /// About the tool's axis, with the wrist that holds it: I φ̈ = τ − b φ̇ − k φ.
  double inertia = 0.0;        ///< I [kg·m²]; 0: it does not turn
  double turnStiffness = 0.0;  ///< k [N·m/rad], >= 0
  double turnDamping = 0.0;    ///< b [N·m·s/rad], >= 0
};

/// A kind of instrument, and all that other code has to know about it. docs/devices.md says how to
/// add one; haptics/registry lists all. [unit] is the kind's own unit of travel.
struct DeviceKind {
  std::string_view name;  ///< in protocols, device files and messages: "punch"
  Tissue tissue;
  View view;
  Wire wire;

  struct Travel {
    std::string_view unit;      ///< in files and exports: "travel_unit", "m"
    std::string_view unitName;  ///< behind a number: "travel units", "m"
    double least;               ///< [unit]
    double most;                ///< [unit]
    double fastest;             ///< faster than any hand moves the tool [unit/s]
    double playSpeed;           ///< of `scene play`, unless another is asked for [unit/s]
  } travel;

  /// How people read the travel.
  struct TravelDisplay {
    double factor;                  ///< from the unit to the one that is shown
    std::string_view unit;          ///< "mm"
    std::string_view suffix;        ///< behind a number where room is scarce: " mm"; or nothing
    std::string_view velocityUnit;  ///< "mm/s"
    std::string_view energyUnit;    ///< of force times the kind's own unit: "J"
    std::string_view axis;          ///< of figures, in the catalogues: "depth [mm]"
  } shown;

  /// The ranges with which a plot begins, in the shown unit: those of a usual hand.
  struct Plot {
    double force;         ///< [N]
    double travel;        ///< [shown unit]
    double velocity;      ///< to either side [shown unit/s]
    double torque = 0.0;  ///< to either side [N·m]; 0: its scenes have none
  } plot;

  models::CutDetector<double>::Parameters stroke;  ///< what counts as one

  // The parameters of the simulated device.
  double simulatedForce;         ///< that it gives at most [N]
  double simulatedTorque = 0.0;  ///< largest torque about the tool's axis [N·m]; 0: none
  Mechanism mechanism;

  struct Range {
    double least;
    double most;
  };
  /// From which the hands of simulated participants are drawn.
  struct Hand {
    Range reach;           ///< travel that it aims at; resistance stops it earlier [unit]
    Range closeTime;       ///< [s]
    Range openTime;        ///< [s]
    Range stiffness;       ///< [N/unit]
    Range damping;         ///< [N·s/unit]
    double ordinaryReach;  ///< of a pointer's hand, and of an emulator's [unit]
  } hand;
  PointerHand::Grip grip;  ///< of a person with a mouse

  /// Of a device on a serial line.
  struct Serial {
    double travelPerCount = 0.00439;  ///< of the encoder [unit]
    Range believable{-2.0, 14.0};     ///< beyond it its zero is wrong [unit]

    /// Whether the mechanism can reach @p travel, however wrong its zero is. An encoder that lost
    /// count, or a fault in its cable, gives places far outside.
    bool canReach(double travel) const noexcept {
      const double span = believable.most - believable.least;
      return travel >= believable.least - span && travel <= believable.most + span;
    }
  } serial;

  // Words.
  Text strokeName;   ///< "cut"
  Text strokesName;  ///< "cuts"
  Text pointerHint;  ///< to a participant: what keys and the mouse do

  /// The device's own texts for reports and exports of a study with this kind of device alone.
  struct Sentence {
    std::string_view language;
    std::string_view english;  ///< the sentence: "at least {} cut or stroke"
    std::string_view text;     ///< in that language: "at least {} press"
  };
  std::vector<Sentence> sentences = {};
};

}  // namespace haptics::devices
