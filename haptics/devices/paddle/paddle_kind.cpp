#include "haptics/devices/paddle/paddle_kind.h"

namespace haptics::devices {

const DeviceKind& paddleKind() {
  static const DeviceKind kind{
      .name = "paddle",
      .tissue = Tissue::Meniscus,
      .view = View::None,
      .wire = Wire::Serial,
      .travel =
          {.unit = "deg",
           .unitName = "degrees",
           .least = 0.0,
           .most = 30.0,
           .fastest = 900.0,
           .playSpeed = 150.0},
      .shown =
          {.factor = 1.0,
           .unit = "°",
           .suffix = "°",
           .velocityUnit = "°/s",
           .energyUnit = "N·°",
           .axis = "angle [°]"},
      .plot = {.force = 6.0, .travel = 35.0},
      .stroke =
          {.closedAbove = 18.0,
           .openBelow = 6.0,
           .contactForce = 0.1,
           .frictionSlope = 0.02,
           .yieldDrop = 0.2,
           .advance = 0.8,
           .bottomOutAbove = 27.0,
           .bottomOutRise = 0.2,
           .retreat = 3.0},
      .simulatedMaxForce = 6.0,
      .mechanism =
          {.mass = 0.0015,
           .damping = 0.02,
           .stopStiffness = 30.0,
           .stopDamping = 0.1,
           .resolution = 0.05},
      .hand =
          {.reach = {36.0, 40.0},
           .closeTime = {0.4, 1.0},
           .openTime = {0.3, 0.7},
           .stiffness = {0.9, 1.3},
           .damping = {0.03, 0.06},
           .typicalReach = 38.0},
      .grip = {.stiffness = 1.1, .damping = 0.045, .speed = 120.0},
      .serial = {.travelPerCount = 0.012, .plausibleTravel = {-5.0, 36.0}},
      .strokeName = {"press", {{"de", "Druckbewegung"}, {"nb", "trykk"}}},
      .strokesName = {"presses", {{"de", "Druckbewegungen"}, {"nb", "trykk"}}},
      .strokeHint =
          {"Press the paddle, then release it.",
           {{"de", "Drücken Sie das Paddel, dann lassen Sie es los."},
            {"nb", "Trykk på padlen, og slipp den så."}}},
      .pointerHint =
          {"No instrument at hand? Hold the space bar, or drag down on this page, to press the "
           "paddle; let go to release it.",
           {{"de",
             "Kein Instrument zur Hand? Halten Sie die Leertaste gedrückt oder ziehen Sie auf "
             "dieser Seite nach unten, um das Paddel zu drücken; lassen Sie los, um es "
             "freizugeben."},
            {"nb",
             "Ikke noe instrument for hånden? Hold mellomromstasten nede, eller dra nedover på "
             "denne siden, for å trykke på spaken; slipp for å gi den fri."}}},
      .sentences = {
          {"en", "at least {} cut or stroke", "at least {} press"},
          {"en", "at least {} cuts or strokes", "at least {} presses"},
          {"en", "{} cut or stroke", "{} press"},
          {"en", "{} cuts or strokes", "{} presses"},
          {"en", "Cuts (strokes) that were made", "Presses that were made"},
          {"en",
           "One row per cut (stroke), with its landmarks; what was not found is missing.",
           "One row per press, with its landmarks; what was not found is missing."},
          {"en",
           "Where the load began to rise [travel unit of the device]",
           "Where the load began to rise [deg]"},
          {"en", "Largest force of the cut", "Largest force of the press"},
          {"de", "angle [°]", "Winkel [°]"},
          {"de", "at least {} cut or stroke", "mindestens {} Druckbewegung"},
          {"de", "at least {} cuts or strokes", "mindestens {} Druckbewegungen"},
          {"de", "{} cut or stroke", "{} Druckbewegung"},
          {"de", "{} cuts or strokes", "{} Druckbewegungen"},
          {"nb", "angle [°]", "vinkel [°]"},
          {"nb", "at least {} cut or stroke", "minst {} trykk"},
          {"nb", "at least {} cuts or strokes", "minst {} trykk"},
          {"nb", "{} cut or stroke", "{} trykk"},
          {"nb", "{} cuts or strokes", "{} trykk"}}};
  return kind;
}

}  // namespace haptics::devices
