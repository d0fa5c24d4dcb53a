#include "haptics/devices/iiwa/reamer_kind.h"

namespace haptics::devices {
namespace {

models::CutDetector<double>::Parameters stroke() {
  models::CutDetector<double>::Parameters stroke;
  stroke.closedAbove = 0.008;  // [m]: well into the bone
  stroke.openBelow = 0.002;
  stroke.contactForce = 1.0;
  stroke.frictionSlope = 0.0;
  stroke.yieldDrop = 1.0;
  stroke.advance = 0.0003;
  stroke.bottomOutAbove = 0.018;
  stroke.bottomOutRise = 2.0;
  stroke.retreat = 0.001;
  return stroke;
}

}  // namespace

const DeviceKind& reamerKind() {
  static const DeviceKind kind{
      .name = "reamer",
      .tissue = Tissue::Bone,
      .view = View::Hip,
      .wire = Wire::Fri,
      // Reaming by hand stays below 0.1 m/s.
      .travel =
          {.unit = "m",
           .unitName = "m",
           .least = 0.0,
           .most = 0.02,
           .fastest = 1.0,
           .playSpeed = 0.005},
      .shown =
          {.factor = 1000.0,
           .unit = "mm",
           .suffix = " mm",
           .velocityUnit = "mm/s",
           .energyUnit = "J",
           .axis = "depth [mm]"},
      .plot = {.force = 40.0, .travel = 30.0, .torque = 1.0},
      .stroke = stroke(),
      .simulatedMaxForce = 140.0,  // of an LBR iiwa 14
      .simulatedMaxTorque = 10.0,  // the default of IiwaSettings
      .mechanism =
          {.mass = 4.0,
           .damping = 60.0,
           .stopStiffness = 40'000.0,
           .stopDamping = 300.0,
           .resolution = 0.0,
           .inertia = 0.02,
           .rotationalStiffness = 10.0,
           .rotationalDamping = 0.3},
      .hand =
          {.reach = {0.034, 0.042},
           .closeTime = {1.2, 2.2},
           .openTime = {0.8, 1.4},
           .stiffness = {5500.0, 7000.0},
           .damping = {120.0, 180.0},
           .typicalReach = 0.038},
      .grip = {.stiffness = 6000.0, .damping = 150.0, .speed = 0.03, .strength = 120.0},
      .serial = {},
      .strokeName = {"stroke", {{"de", "Fräsbewegung"}, {"nb", "fresebevegelse"}}},
      .strokesName = {"strokes", {{"de", "Fräsbewegungen"}, {"nb", "fresebevegelser"}}},
      .strokeHint =
          {"Push the reamer into the bone, then draw it back.",
           {{"de", "Drücken Sie die Fräse in den Knochen, dann ziehen Sie sie zurück."},
            {"nb", "Skyv fresen inn i beinet, og trekk den så tilbake."}}},
      .pointerHint =
          {"No instrument at hand? Hold the space bar, or drag down on this page, to push in; let "
           "go to draw back. R switches the reamer off and on.",
           {{"de",
             "Kein Instrument zur Hand? Halten Sie die Leertaste gedrückt oder ziehen Sie auf "
             "dieser Seite nach unten, um hineinzudrücken; lassen Sie los, um zurückzuziehen. R "
             "schaltet die Fräse aus und wieder ein."},
            {"nb",
             "Ikke noe instrument for hånden? Hold mellomromstasten nede, eller dra nedover på "
             "denne siden, for å skyve inn; slipp for å trekke tilbake. R slår fresen av og på."}}},
      .sentences = {
          {"en", "{} cut or stroke", "{} stroke"},
          {"en", "{} cuts or strokes", "{} strokes"},
          {"en", "at least {} cut or stroke", "at least {} stroke"},
          {"en", "at least {} cuts or strokes", "at least {} strokes"},
          {"en", "opening", "turning point"},
          {"de", "opening", "Umkehrpunkt"},
          {"nb", "opening", "vendepunkt"},
          {"de", "{} cut or stroke", "{} Fräsbewegung"},
          {"de", "{} cuts or strokes", "{} Fräsbewegungen"},
          {"de", "at least {} cut or stroke", "mindestens {} Fräsbewegung"},
          {"de", "at least {} cuts or strokes", "mindestens {} Fräsbewegungen"},
          {"nb", "{} cut or stroke", "{} fresebevegelse"},
          {"nb", "{} cuts or strokes", "{} fresebevegelser"},
          {"nb", "at least {} cut or stroke", "minst {} fresebevegelse"},
          {"nb", "at least {} cuts or strokes", "minst {} fresebevegelser"}}};
  return kind;
}

}  // namespace haptics::devices
