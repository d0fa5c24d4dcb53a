// The punch's program on an Arduino Due: motor, encoder and USB around haptics/firmware/
// punch_program.h. NEVER RUN ON HARDWARE. Begin with a low supply voltage and no hand on it.
//
// ./prepare puts src/ and build.h beside this file; see README.md.
#include <SimpleFOC.h>

#include "build.h"
#include "src/haptics/firmware/punch_program.h"

namespace {

// ---- this board, and how it is wired ----

constexpr uint32_t kBoard = 1;  // serial number ("serial" in the device file), different for each board
constexpr int kPolePairs = 7;           // BGM2804
constexpr float kSupply = 12.0F;        // [V]
constexpr float kAlign = 3.3F;  // voltage while the motor is aligned [V]
constexpr int kPulses = 2048;  // AMT 102, per revolution
constexpr int kCounts = 4 * kPulses;  // edges of both channels per revolution
constexpr int kClosing = 1;  // -1 if closing counts down
constexpr int kFaultPin = -1;  // fault output of the driver, active low; -1: none
constexpr uint32_t kWatchdog = 40;      // [ms]
constexpr uint32_t kPeriod = 1000;  // period of the loop [µs]
constexpr size_t kPacket = 64;  // size of a USB transfer [bytes]
constexpr uint32_t kWatchdogReset = 2;  // reset type in the reset controller

BLDCMotor motor(kPolePairs);
BLDCDriver3PWM driver(9, 5, 6, 8);  // phases, enable
Encoder encoder(3, 2, kPulses);  // the index (pin 4) is not used, since a handle does not turn that far

/// The hardware interface of PunchProgram.
class Due {
 public:
  /// Aligns the motor, which moves it. After a reset by the watchdog this is skipped, because a
  /// hand may be on the handle; the motor then has no voltage until the board is switched off and
  /// on.
  void begin() {
    if (kFaultPin >= 0) pinMode(kFaultPin, INPUT_PULLUP);
    encoder.init();
    encoder.enableInterrupts([] { encoder.handleA(); }, [] { encoder.handleB(); });
    motor.linkSensor(&encoder);
    driver.voltage_power_supply = kSupply;
    driver.voltage_limit = kSupply;
    motor.voltage_limit = kSupply;
    motor.voltage_sensor_align = kAlign;
    motor.foc_modulation = FOCModulationType::SpaceVectorPWM;
    motor.torque_controller = TorqueControlType::voltage;
    motor.controller = MotionControlType::torque;
    driver.init();
    motor.linkDriver(&driver);
    motor.init();
    const uint32_t reset = (RSTC->RSTC_SR & RSTC_SR_RSTTYP_Msk) >> RSTC_SR_RSTTYP_Pos;
    isReady_ = reset != kWatchdogReset && motor.initFOC() != 0;
    if (!isReady_) motor.disable();
  }

  /// Makes the field follow the rotor; to be called as often as possible.
  void turn() {
    if (!isReady_) {
      encoder.update();
      return;
    }
    motor.loopFOC();
    // A positive voltage turns the motor in the direction in which its own angle grows.
    const int growing = static_cast<int>(motor.sensor_direction) < 0 ? -1 : 1;
    motor.move(-0.001F * static_cast<float>(kClosing * growing * millivolts_));
  }

  /// Sends written bytes if USB has space. Otherwise the core would block without a time limit, and
  /// with it the motor.
  void send() {
    if (size_ == 0 || (UOTGHS->UOTGHS_DEVEPTISR[CDC_TX] & UOTGHS_DEVEPTISR_TXINI) == 0) return;
    const size_t count = size_ < kPacket ? size_ : kPacket;
    SerialUSB.write(out_, count);
    size_ -= count;
    memmove(out_, out_ + count, size_);
  }

  // The functions that haptics::firmware::PunchProgram calls.
  static uint32_t micros() { return ::micros(); }
  static int32_t counts() {
    const float turns = encoder.getAngle() / 6.2831853F;
    const float counts = static_cast<float>(kClosing * kCounts) * turns;
    return static_cast<int32_t>(counts < 0.0F ? counts - 0.5F : counts + 0.5F);
  }
  void drive(int16_t millivolts) { millivolts_ = millivolts; }
  bool hasDriverFault() const {
    return !isReady_ || (kFaultPin >= 0 && digitalRead(kFaultPin) == LOW);
  }
  static int read() { return SerialUSB.read(); }
  void write(const uint8_t* bytes, size_t count) {
    if (count > sizeof out_ - size_) return;  // a frame is sent completely or not at all
    memcpy(out_ + size_, bytes, count);
    size_ += count;
  }

  static haptics::firmware::PunchLimits limits() {
    haptics::firmware::PunchLimits limits;
    limits.build = PALPATE_FIRMWARE_BUILD;
    limits.serial = kBoard;
    limits.countsPerTurn = kCounts;
    limits.rate = 1000000 / kPeriod;
    limits.largestVoltage = static_cast<int16_t>(1000.0F * kSupply);
    return limits;
  }

 private:
  bool isReady_ = false;
  int millivolts_ = 0;
  uint8_t out_[3 * kPacket] = {};
  size_t size_ = 0;
};

Due due;

}  // namespace

/// Replaces the core's function, which would switch the watchdog off permanently: it can be set
/// only once.
void watchdogSetup() {}

void setup() {
  SerialUSB.begin(0);
  due.begin();  // within the 16 s that the watchdog initially allows
  watchdogEnable(kWatchdog);
}

void loop() {
  static haptics::firmware::PunchProgram<Due> program(due, Due::limits());
  static uint32_t last = micros();
  watchdogReset();
  due.turn();
  due.send();
  const uint32_t passed = micros() - last;
  if (passed < kPeriod) return;
  last += passed < 2 * kPeriod ? kPeriod : passed;  // do not make up for lost time
  program.step();
}
