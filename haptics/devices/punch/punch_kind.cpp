#include "haptics/devices/punch/punch_kind.h"

namespace haptics::devices {

const DeviceKind& punchKind() {
  static const DeviceKind kind{
      .name = "punch",
      .tissue = Tissue::Meniscus,
      .view = View::Knee,
      .wire = Wire::Serial,
      // A hurried hand closes a punch at 60 travel units/s.
      .travel =
          {.unit = "travel_unit",
           .unitName = "travel units",
           .least = 0.0,
           .most = 11.0,
           .fastest = 300.0,
           .playSpeed = 57.0},
      .shown =
          {.factor = 1.0,
           .unit = "units",
           .suffix = "",
           .velocityUnit = "/s",
           .energyUnit = "N·units",
           .axis = "travel [travel units]"},
      .plot = {.force = 8.0, .travel = 12.0},
      .stroke = {},
      .simulatedMaxForce = 8.0,
      // The encoder's resolution of 0.0439° is taken as 0.0439 travel units.
      .mechanism =
          {.mass = 0.004,
           .damping = 0.05,
           .stopStiffness = 80.0,
           .stopDamping = 0.3,
           .resolution = 0.0439},
      .hand =
          {.reach = {13.3, 14.3},
           .closeTime = {0.4, 1.2},
           .openTime = {0.3, 0.7},
           .stiffness = {2.6, 3.6},
           .damping = {0.08, 0.16},
           .typicalReach = 13.8},
      .grip = {.stiffness = 3.0, .damping = 0.12, .speed = 40.0},
      .serial = {.travelPerCount = 0.00439, .plausibleTravel = {-2.0, 14.0}},
      .strokeName = {"cut", {{"de", "Schnitt"}, {"nb", "kutt"}}},
      .strokesName = {"cuts", {{"de", "Schnitte"}, {"nb", "kutt"}}},
      .strokeHint =
          {"Close the handles until the tissue is cut, then open them.",
           {{"de",
             "Schließen Sie die Griffe, bis das Gewebe durchtrennt ist, dann öffnen Sie sie."},
            {"nb", "Lukk håndtakene til vevet er kuttet, og åpne dem så."}}},
      .pointerHint =
          {"No instrument at hand? Hold the space bar, or drag down on this page, to close; let go "
           "to open.",
           {{"de",
             "Kein Instrument zur Hand? Halten Sie die Leertaste gedrückt oder ziehen Sie auf "
             "dieser Seite nach unten, um zu schließen; lassen Sie los, um zu öffnen."},
            {"nb",
             "Ikke noe instrument for hånden? Hold mellomromstasten nede, eller dra nedover på "
             "denne siden, for å lukke; slipp for å åpne."}}},
      .sentences = {
          {"en", "{} cut or stroke", "{} cut"},
          {"en", "{} cuts or strokes", "{} cuts"},
          {"en", "at least {} cut or stroke", "at least {} cut"},
          {"en", "at least {} cuts or strokes", "at least {} cuts"},
          {"de", "{} cut or stroke", "{} Schnitt"},
          {"de", "{} cuts or strokes", "{} Schnitte"},
          {"de", "at least {} cut or stroke", "mindestens {} Schnitt"},
          {"de", "at least {} cuts or strokes", "mindestens {} Schnitten"},
          {"nb", "{} cut or stroke", "{} kutt"},
          {"nb", "{} cuts or strokes", "{} kutt"},
          {"nb", "at least {} cut or stroke", "minst {} kutt"},
          {"nb", "at least {} cuts or strokes", "minst {} kutt"}}};
  return kind;
}

}  // namespace haptics::devices
