#pragma once

#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "haptics/devices/hand.h"
#include "haptics/models/cut_detector.h"

namespace haptics::devices {

/// The tissue that an instrument is used on. Every force model simulates one tissue.
enum class Tissue : std::uint8_t { Meniscus, Bone };

/// The scene that is drawn during a trial.
enum class View : std::uint8_t { None, Knee, Hip };

/// How the real instruments of a kind are connected.
enum class Wire : std::uint8_t {
  Serial,  ///< docs/punch-protocol.md
  Fri,     ///< docs/fri.md
};

/// A text for users, with its translation into every language that is shipped.
class Text {
 public:
  using InLanguages = std::vector<std::pair<std::string_view, std::string_view>>;

  /// @param others  language and text: {{"de", "Schnitt"}}.
  Text(std::string_view english, InLanguages others)
      : english_(english), others_(std::move(others)) {}

  /// The text in @p language, English if it has no translation; "de" also matches "de-CH".
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

/// The moving part of a simulated instrument: a mass with viscous friction between two elastic
/// stops.
struct Mechanism {
  double mass = 0.004;          ///< m [N·s² / travel unit], > 0
  double damping = 0.05;        ///< b [N·s / travel unit], >= 0
  double stopStiffness = 80.0;  ///< [N / travel unit], > 0
  double stopDamping = 0.3;     ///< [N·s / travel unit], >= 0
  double resolution = 0.0;      ///< of the encoder [travel unit]; 0: none
  /// Rotation about the tool's axis, of the tool and the wrist that holds it: I φ̈ = τ − b φ̇ − k
  /// φ.
  double inertia = 0.0;              ///< I [kg·m²]; 0: the tool does not rotate
  double rotationalStiffness = 0.0;  ///< k [N·m/rad], >= 0
  double rotationalDamping = 0.0;    ///< b [N·m·s/rad], >= 0
};

/// A kind of instrument, with all facts that other code needs about it. docs/devices.md says how to
/// add one; haptics/registry lists all. [unit] is the kind's own unit of travel.
struct DeviceKind {
  std::string_view name;  ///< in protocols, device files and messages: "punch"
  Tissue tissue;
  View view;
  Wire wire;

  struct Travel {
    std::string_view unit;      ///< in files and exports: "travel_unit", "m"
    std::string_view unitName;  ///< written after a number: "travel units", "m"
    double least;               ///< [unit]
    double most;                ///< [unit]
    double fastest;             ///< faster motion is impossible for a hand [unit/s]
    double playSpeed;           ///< default speed of `scene play` [unit/s]
  } travel;

  /// How travel is shown to users.
  struct TravelDisplay {
    double factor;                  ///< shown value = factor · travel
    std::string_view unit;          ///< "mm"
    std::string_view suffix;        ///< after a number in narrow places: " mm"; may be empty
    std::string_view velocityUnit;  ///< "mm/s"
    std::string_view energyUnit;    ///< unit of force times travel (not scaled by factor): "J"
    std::string_view axis;  ///< axis label of figures, a key of the translations: "depth [mm]"
  } shown;

  /// The initial ranges of a live plot, in the shown unit, for a usual hand movement.
  struct Plot {
    double force;         ///< [N]
    double travel;        ///< [shown unit]
    double torque = 0.0;  ///< from −torque to torque [N·m]; 0: no scene of the kind has a torque
  } plot;

  models::CutDetector<double>::Parameters stroke;  ///< the thresholds that define a cut or stroke

  // The parameters of the simulated device.
  double simulatedMaxForce;         ///< largest force [N]
  double simulatedMaxTorque = 0.0;  ///< largest torque about the tool's axis [N·m]; 0: none
  Mechanism mechanism;

  struct Range {
    double least;
    double most;
  };
  /// The ranges from which the hands of simulated participants are drawn at random.
  struct Hand {
    Range reach;          ///< travel that the hand aims at; resistance stops it earlier [unit]
    Range closeTime;      ///< [s]
    Range openTime;       ///< [s]
    Range stiffness;      ///< [N/unit]
    Range damping;        ///< [N·s/unit]
    double typicalReach;  ///< reach of a hand that the mouse or an emulator moves [unit]
  } hand;
  PointerHand::Grip grip;  ///< of a user who moves the tool with the mouse

  /// Defaults for a device on a serial line.
  struct Serial {
    double travelPerCount = 0.00439;  ///< of the encoder [unit]
    /// Travel outside this range means that the zero is wrong [unit]
    Range plausibleTravel{-2.0, 14.0};

    /// Whether the mechanism can reach @p travel, for every possible error of its zero. If the
    /// encoder has lost counts, or its cable is faulty, the travel is far outside this range.
    bool isPlausibleTravel(double travel) const noexcept {
      const double span = plausibleTravel.most - plausibleTravel.least;
      return travel >= plausibleTravel.least - span && travel <= plausibleTravel.most + span;
    }
  } serial;

  // Texts.
  Text strokeName;   ///< "cut"
  Text strokesName;  ///< "cuts"
  Text strokeHint;   ///< tells a participant how a stroke is made with the instrument
  Text pointerHint;  ///< explains the keys and the mouse to a participant

  /// A sentence that replaces a general sentence in the reports and exports of a study whose
  /// devices are all of this kind.
  struct Sentence {
    std::string_view language;
    std::string_view english;  ///< the general sentence: "at least {} cut or stroke"
    std::string_view text;     ///< the replacement, in that language: "at least {} press"
  };
  std::vector<Sentence> sentences = {};
};

}  // namespace haptics::devices
