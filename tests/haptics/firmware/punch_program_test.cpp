// The punch's own program on hardware that a test plays: its clock, its encoder, its line.
#include "haptics/firmware/punch_program.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/recordings/parametric_cut.h"

namespace haptics::firmware {
namespace punch_program_test {

using namespace wire::punch;
using Bytes = std::vector<std::uint8_t>;

constexpr std::uint32_t kMillisecond = 1000;  // [µs]

/// Does what the test says, and remembers what was said.
struct Bench {
  std::uint32_t time = 0;
  std::int32_t position = 0;
  std::int16_t voltage = 0;
  bool isFaulty = false;
  std::deque<std::uint8_t> toBoard;
  Bytes fromBoard;

  std::uint32_t micros() const { return time; }
  std::int32_t counts() const { return position; }
  void drive(std::int16_t millivolts) { voltage = millivolts; }
  bool hasDriverFault() const { return isFaulty; }
  int read() {
    if (toBoard.empty()) return -1;
    const int byte = toBoard.front();
    toBoard.pop_front();
    return byte;
  }
  void write(const std::uint8_t* bytes, std::size_t count) {
    fromBoard.insert(fromBoard.end(), bytes, bytes + count);
  }
};

template <typename Message>
Bytes payloadOf(const Message& message) {
  Bytes payload(kLargestPayload);
  Writer writer(payload.data());
  write(writer, message);
  payload.resize(writer.size());
  return payload;
}

template <typename Message>
Bytes onWire(const Message& message, std::uint16_t sequence) {
  Bytes bytes(kLargestOnWire);
  bytes.resize(encode(message, sequence, 0, bytes.data()));
  return bytes;
}

/// What the board has said, by type.
struct Said {
  std::vector<Hello> hellos;
  std::vector<State> states;
  std::vector<Event> events;
  std::vector<ModelTaken> taken;
  std::vector<Stop> stops;

  std::size_t frames() const {
    return hellos.size() + states.size() + events.size() + taken.size() + stops.size();
  }
  long count(EventCode code) const {
    return std::count_if(
        events.begin(), events.end(), [&](const Event& event) { return event.code == code; });
  }
};

PunchLimits limits() {
  return {.build = 0x1122334455667788, .serial = 7};
}

/// A host that says what the test wants, a board, and time that passes when the test says so.
class PunchProgramTest : public testing::Test {
 protected:
  void begin(const PunchLimits& what, std::uint32_t time = 0) {
    program_.reset();
    bench_ = {.time = time};
    said_ = {};
    program_.emplace(bench_, what);
  }
  void SetUp() override { begin(limits()); }

  void put(const Bytes& bytes) {
    bench_.toBoard.insert(bench_.toBoard.end(), bytes.begin(), bytes.end());
  }
  template <typename Message>
  void send(const Message& message) {
    put(onWire(message, ++sequence_));
  }

  /// One turn of the loop; the voltage after it [mV].
  int step(std::uint32_t micros = kMillisecond) {
    bench_.time += micros;
    program_->step();
    hear();
    return bench_.voltage;
  }
  void steps(int count) {
    for (int i = 0; i < count; ++i) step();
  }
  void greet() {
    send(Hello{});
    step();
  }
  void greetAndArm(std::uint8_t expiry = 20) {
    greet();
    send(Arm{.isArmed = true, .expiry = expiry});
    step();
  }
  /// Keeps asking for @p voltage for some loops.
  int hold(int voltage, int loops, std::uint8_t expiry = 10) {
    for (int i = 0; i < loops; ++i) {
      send(SetForce{.voltage = static_cast<std::int16_t>(voltage), .expiry = expiry});
      step();
    }
    return bench_.voltage;
  }
  const State& state() const { return said_.states.back(); }
  bool has(std::uint8_t fault) const { return (state().faults & fault) != 0; }

  Bench bench_;
  Said said_;
  std::optional<PunchProgram<Bench>> program_;
  std::uint16_t sequence_ = 0;

 private:
  template <typename Message>
  void keep(const Frame& frame, std::vector<Message>& where) {
    Message message;
    ASSERT_TRUE(wire::punch::read(frame, message));
    where.push_back(message);
  }
  void hear() {
    Frame frame;
    for (const auto byte : bench_.fromBoard) {
      if (!decoder_.take(byte, frame)) continue;
      if (frame.type == Type::Hello) keep(frame, said_.hellos);
      if (frame.type == Type::State) keep(frame, said_.states);
      if (frame.type == Type::Event) keep(frame, said_.events);
      if (frame.type == Type::ModelTaken) keep(frame, said_.taken);
      if (frame.type == Type::Stop) keep(frame, said_.stops);
    }
    bench_.fromBoard.clear();
    ASSERT_EQ(decoder_.damaged(), 0U);
  }

  FrameDecoder decoder_;
};

TEST_F(PunchProgramTest, AnswersNothingBeforeHello) {
  send(Arm{.isArmed = true, .expiry = 20});
  send(SetForce{.voltage = 5000, .expiry = 20});
  send(Model{.kind = ModelKind::FiniteElements});
  send(Render{.hash = 1});
  send(Stop{});
  steps(10);
  EXPECT_EQ(said_.frames(), 0U);
  EXPECT_EQ(bench_.voltage, 0);
  EXPECT_FALSE(program_->isArmed());
}

TEST_F(PunchProgramTest, SaysWhoItIsAndThenWhereItIs) {
  bench_.position = 123;
  greet();
  ASSERT_EQ(said_.hellos.size(), 1U);
  const Hello& hello = said_.hellos[0];
  EXPECT_EQ(hello.protocolVersion, kProtocolVersion);
  EXPECT_EQ(hello.build, 0x1122334455667788U);
  EXPECT_EQ(hello.serial, 7U);
  EXPECT_EQ(hello.rate, 1000);
  EXPECT_EQ(hello.largestVoltage, 12000);
  EXPECT_EQ(hello.largestSlew, 1200);
  steps(9);
  EXPECT_EQ(said_.states.size(), 10U);
  EXPECT_EQ(state().counts, 123);
  EXPECT_TRUE(has(kNotArmed));
}

TEST_F(PunchProgramTest, HasNothingToDoWithAHostOfAnotherVersion) {
  send(Hello{.protocolVersion = kProtocolVersion + 1});
  send(Arm{.isArmed = true, .expiry = 20});
  send(SetForce{.voltage = 5000, .expiry = 20});
  steps(10);
  EXPECT_EQ(said_.hellos.size(), 1U);
  ASSERT_EQ(said_.stops.size(), 1U);
  EXPECT_EQ(said_.stops[0].reason, StopReason::VersionMismatch);
  EXPECT_EQ(said_.frames(), 2U);
  EXPECT_EQ(bench_.voltage, 0);
}

TEST_F(PunchProgramTest, GivesNoVoltageUnlessArmed) {
  greet();
  EXPECT_EQ(hold(12000, 20), 0);
  EXPECT_TRUE(has(kNotArmed));
  send(Arm{.isArmed = true, .expiry = 20});
  EXPECT_EQ(hold(6000, 20), 6000);
  EXPECT_FALSE(has(kNotArmed));
  send(Arm{.isArmed = false, .expiry = 20});
  EXPECT_EQ(hold(6000, 20), 0);
  EXPECT_TRUE(has(kNotArmed));
  EXPECT_EQ(said_.count(EventCode::Armed), 1);
  EXPECT_EQ(said_.count(EventCode::Disarmed), 1);
}

TEST_F(PunchProgramTest, ReachesAForceNoFasterThanTheSlew) {
  greetAndArm();
  for (const int goal : {12000, -12000, 500, 0}) {
    int before = bench_.voltage;
    for (const std::uint32_t micros : {1000U, 250U, 3000U, 1000U, 1U, 5000U, 999U, 5000U, 5000U}) {
      send(SetForce{.voltage = static_cast<std::int16_t>(goal), .expiry = 20});
      const int now = step(micros);
      EXPECT_LE(std::abs(now - before), 1.2 * micros);
      before = now;
    }
    EXPECT_EQ(before, goal);
  }
}

TEST_F(PunchProgramTest, MovesNoFurtherThanFiveMillisecondsAfterALongerPause) {
  greetAndArm();
  send(SetForce{.voltage = 12000, .expiry = 20});
  EXPECT_EQ(step(1'000'000), 5 * 1200);
}

TEST_F(PunchProgramTest, SaturatesAndSaysSo) {
  greetAndArm();
  for (const int asked : {12001, 32767, -32768}) {
    EXPECT_EQ(hold(asked, 30), asked > 0 ? 12000 : -12000);
    EXPECT_TRUE(has(kSaturated));
    hold(12000, 2);
    EXPECT_FALSE(has(kSaturated));
  }
}

TEST_F(PunchProgramTest, LetsGoWhenAForceExpires) {
  greetAndArm();
  for (const std::uint8_t expiry : std::initializer_list<std::uint8_t>{1, 5, 10, 20}) {
    ASSERT_EQ(hold(12000, 30, expiry), 12000);
    const auto fired = said_.count(EventCode::WatchdogFired);
    for (int age = 1; age <= expiry; ++age) {
      EXPECT_EQ(step(), 12000) << age;
      EXPECT_FALSE(has(kExpired));
    }
    EXPECT_EQ(step(), 12000 - 1200);
    EXPECT_TRUE(has(kExpired));
    for (int i = 0; i < 9; ++i) step();
    EXPECT_EQ(bench_.voltage, 0);
    steps(5);
    EXPECT_TRUE(has(kExpired));
    EXPECT_EQ(said_.count(EventCode::WatchdogFired), fired + 1);
  }
}

TEST_F(PunchProgramTest, IsGivenForceAgainAfterAShortPause) {
  greetAndArm();
  hold(6000, 10);
  steps(25);
  ASSERT_EQ(bench_.voltage, 0);
  EXPECT_EQ(hold(6000, 10), 6000);
  EXPECT_FALSE(has(kExpired));
  EXPECT_TRUE(program_->isArmed());
}

TEST_F(PunchProgramTest, KeepsNoForceLongerThanItWasArmedFor) {
  greetAndArm(3);
  ASSERT_EQ(hold(6000, 10, 20), 6000);
  steps(3);
  EXPECT_EQ(bench_.voltage, 6000);
  EXPECT_EQ(step(), 4800);
}

TEST_F(PunchProgramTest, GivesUpAHostThatFallsSilent) {
  greetAndArm();
  hold(6000, 10);
  steps(40);
  EXPECT_TRUE(program_->isArmed());
  step();
  EXPECT_FALSE(program_->isArmed());
  EXPECT_TRUE(has(kNotArmed));
  EXPECT_EQ(said_.count(EventCode::Disarmed), 1);
  EXPECT_EQ(hold(6000, 10), 0);  // until it is armed again
}

TEST_F(PunchProgramTest, StaysArmedButLetsGoWhereTheHostSpeaksOfSomethingElse) {
  greetAndArm();
  hold(6000, 10);
  for (int i = 0; i < 200; ++i) {
    send(Model{.kind = ModelKind::FiniteElements});
    step();
  }
  EXPECT_TRUE(program_->isArmed());
  EXPECT_EQ(bench_.voltage, 0);
  EXPECT_EQ(said_.count(EventCode::WatchdogFired), 1);
}

TEST_F(PunchProgramTest, GivesNoOldForceWhenTheClockHasGoneRound) {
  auto patient = limits();
  patient.silence = 60'000;
  begin(patient);
  greetAndArm();
  hold(6000, 10);
  for (int i = 0; i < 80; ++i) {  // 80 minutes
    send(Model{.kind = ModelKind::FiniteElements});
    step(59'999'999);
    if (i > 2) {
      ASSERT_EQ(bench_.voltage, 0) << i;
    }
  }
  const std::uint32_t age = bench_.time - 11'000;
  step(0U - age);  // by the clock, the last force is as good as new
  step();
  EXPECT_EQ(bench_.voltage, 0);
}

TEST_F(PunchProgramTest, IsNotDisturbedWhenTheClockWraps) {
  begin(limits(), 0U - 30'500U);
  greetAndArm();
  ASSERT_EQ(hold(6000, 20), 6000);
  int wrapped = 0;
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(hold(6000, 1), 6000);
    wrapped += has(kClockWrapped) ? 1 : 0;
  }
  EXPECT_EQ(wrapped, 1);
  EXPECT_EQ(state().lateLoops, 0);
  EXPECT_EQ(said_.count(EventCode::WatchdogFired), 0);
}

TEST_F(PunchProgramTest, LetsGoInTimeWhereTheClockWrapsMeanwhile) {
  begin(limits(), 0U - 27'500U);
  greetAndArm();
  ASSERT_EQ(hold(6000, 20), 6000);  // five milliseconds are left
  steps(10);
  EXPECT_LT(bench_.time, 10'000U);
  EXPECT_EQ(bench_.voltage, 6000);
  EXPECT_EQ(step(), 4800);
  steps(4);
  EXPECT_EQ(bench_.voltage, 0);
}

struct Latched {
  const char* name;
  std::uint8_t fault;
  EventCode code;
};

class PunchProgramLatches : public PunchProgramTest, public testing::WithParamInterface<Latched> {
 protected:
  void breakIt() {
    if (GetParam().fault == kEncoderFault) bench_.position += 401;
    if (GetParam().fault == kDriverFault) bench_.isFaulty = true;
    if (GetParam().fault == kTooFast) {
      for (int i = 0; i < 8; ++i) {
        bench_.position -= 160;  // 160,000 counts/s
        hold(6000, 1);
      }
    }
  }
};

TEST_P(PunchProgramLatches, UntilItIsArmedAgain) {
  greetAndArm();
  ASSERT_EQ(hold(6000, 10), 6000);
  breakIt();
  hold(6000, 20);
  EXPECT_EQ(bench_.voltage, 0);
  EXPECT_TRUE(has(GetParam().fault));
  EXPECT_EQ(said_.count(GetParam().code), 1);
  bench_.isFaulty = false;
  EXPECT_EQ(hold(6000, 20), 0);  // mended, and still off
  greet();
  EXPECT_TRUE(has(GetParam().fault));
  send(Arm{.isArmed = true, .expiry = 20});
  EXPECT_EQ(hold(6000, 20), 6000);
  EXPECT_EQ(state().faults, 0);
}

TEST_P(PunchProgramLatches, BeginsToLetGoInTheSameLoop) {
  greetAndArm();
  ASSERT_EQ(hold(6000, 10), 6000);
  if (GetParam().fault == kTooFast) return;  // takes some loops to be seen
  breakIt();
  EXPECT_EQ(hold(6000, 1), 4800);
}

INSTANTIATE_TEST_SUITE_P(
    Faults,
    PunchProgramLatches,
    testing::Values(
        Latched{"EncoderLeap", kEncoderFault, EventCode::EncoderFault},
        Latched{"TooFast", kTooFast, EventCode::TooFast},
        Latched{"DriverFault", kDriverFault, EventCode::DriverFault}),
    [](const auto& parameter) { return std::string(parameter.param.name); });

TEST_F(PunchProgramTest, LatchesADriverThatIsStillBrokenAgain) {
  greetAndArm();
  bench_.isFaulty = true;
  hold(6000, 10);
  send(Arm{.isArmed = true, .expiry = 20});
  EXPECT_EQ(hold(6000, 20), 0);
  EXPECT_TRUE(has(kDriverFault));
}

TEST_F(PunchProgramTest, TakesAnyCountsForWhatTheyAre) {
  greetAndArm();
  constexpr auto kMost = std::numeric_limits<std::int32_t>::max();
  for (const std::int32_t position : {kMost, 0, -kMost - 1, 20'000'000, -20'000'000}) {
    send(Arm{.isArmed = true, .expiry = 20});
    hold(6000, 10);
    bench_.position = position;
    hold(6000, 10);
    EXPECT_TRUE(has(kEncoderFault)) << position;
    EXPECT_EQ(bench_.voltage, 0);
    EXPECT_EQ(state().counts, position);
  }
}

TEST_F(PunchProgramTest, CountsOnWhereTheEncoderGoesRound) {
  bench_.position = std::numeric_limits<std::int32_t>::max() - 250;
  program_.emplace(bench_, limits());
  greetAndArm();
  for (int i = 0; i < 10; ++i) {
    bench_.position = static_cast<std::int32_t>(static_cast<std::uint32_t>(bench_.position) + 100U);
    hold(1000, 1);
  }
  EXPECT_LT(bench_.position, 0);
  EXPECT_EQ(state().velocity, 100'000);
  EXPECT_EQ(state().faults, 0);
}

TEST_F(PunchProgramTest, AllowsWhatAHandDoes) {
  greetAndArm();
  for (int i = 0; i < 100; ++i) {
    bench_.position += 100;  // 100,000 counts/s
    hold(1000, 1);
  }
  EXPECT_EQ(state().velocity, 100'000);
  EXPECT_EQ(state().faults, 0);
  EXPECT_EQ(bench_.voltage, 1000);
}

TEST_F(PunchProgramTest, EchoesTheLastFrameThatWasValid) {
  greetAndArm();
  sequence_ = 40'000;
  hold(100, 1);
  EXPECT_EQ(state().echo, 40'001);
  auto damaged = onWire(SetForce{.voltage = 100}, 40'002);
  damaged[3] ^= 0x20;
  put(damaged);
  step();
  EXPECT_EQ(state().echo, 40'001);
  put(onWire(SetForce{.voltage = 100, .expiry = 0}, 40'003));  // no expiry there is
  step();
  EXPECT_EQ(state().echo, 40'001);
  put(onWire(State{}, 40'004));  // not for a device
  step();
  EXPECT_EQ(state().echo, 40'001);
  put(onWire(Arm{.isArmed = true, .expiry = 21}, 40'005));
  step();
  EXPECT_EQ(state().echo, 40'001);
  EXPECT_EQ(state().badFrames, 4);
  sequence_ = 65'534;
  hold(100, 2);
  EXPECT_EQ(state().echo, 0);  // wraps
}

TEST_F(PunchProgramTest, CountsFramesThatAreDamaged) {
  greetAndArm();
  for (int i = 1; i <= 5; ++i) {
    auto damaged = onWire(SetForce{.voltage = 12000}, 1);
    damaged[static_cast<std::size_t>(i)] ^= 0x80;
    put(damaged);
    step();
    EXPECT_TRUE(has(kBadFrames));
    EXPECT_EQ(state().badFrames, i);
    step();
    EXPECT_FALSE(has(kBadFrames));
  }
  EXPECT_EQ(bench_.voltage, 0);
  EXPECT_EQ(hold(1000, 1), 1000);  // what follows is understood
  greet();
  EXPECT_EQ(state().badFrames, 0);
}

TEST_F(PunchProgramTest, DoesNotListenToAFloodForEver) {
  greetAndArm();
  while (bench_.toBoard.size() < 5000) send(SetForce{.voltage = 1200, .expiry = 20});
  std::size_t left = bench_.toBoard.size();
  while (left > 512) {
    step();
    EXPECT_EQ(bench_.toBoard.size(), left - 512);
    left -= 512;
  }
  step();
  EXPECT_TRUE(bench_.toBoard.empty());
  EXPECT_EQ(state().echo, sequence_);  // and loses nothing of it
  EXPECT_EQ(state().badFrames, 0);
}

TEST_F(PunchProgramTest, CountsLoopsThatCameLate) {
  greet();
  steps(10);
  EXPECT_EQ(state().lateLoops, 0);
  step(1600);
  step(20'000);
  EXPECT_EQ(state().lateLoops, 2);
  greet();
  EXPECT_EQ(state().lateLoops, 0);
}

TEST_F(PunchProgramTest, IsDisarmedByAnotherHello) {
  greetAndArm();
  ASSERT_EQ(hold(6000, 10), 6000);
  send(Hello{});
  EXPECT_EQ(hold(6000, 1), 4800);
  EXPECT_FALSE(program_->isArmed());
  EXPECT_EQ(hold(6000, 10), 0);
  EXPECT_TRUE(has(kNotArmed));
  EXPECT_EQ(said_.hellos.size(), 2U);
}

TEST_F(PunchProgramTest, IsDisarmedByStop) {
  greetAndArm();
  hold(6000, 10);
  send(Stop{StopReason::HostFault});
  EXPECT_EQ(step(), 4800);
  EXPECT_FALSE(program_->isArmed());
}

// What it renders by itself.

std::vector<models::CurveNode<float>> parametricNodes() {
  std::vector<models::CurveNode<float>> nodes;
  const auto cut = recordings::parametricCut();
  for (const auto& node : cut.curve.nodes()) {
    nodes.push_back({static_cast<float>(node.travel), static_cast<float>(node.force)});
  }
  return nodes;
}

std::vector<ModelTable> tablesOf(const std::vector<models::CurveNode<float>>& nodes) {
  std::vector<ModelTable> tables;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (i % kTableChunk == 0) tables.push_back({.first = static_cast<std::uint8_t>(i)});
    ModelTable& table = tables.back();
    table.travel[table.count] = nodes[i].travel;
    table.force[table.count] = nodes[i].force;
    ++table.count;
  }
  return tables;
}

constexpr float kTravelPerCount = 0.00439F;

Model modelOf(ModelKind kind, std::size_t points) {
  const models::KalmanNoise<float> noise;
  return {
      .kind = kind,
      .tableSize = static_cast<std::uint8_t>(points),
      .travelPerCount = kTravelPerCount,
      .millivoltsPerNewton = 1500.0F,
      .largestForce = 8.0F,
      .scheme = static_cast<std::uint8_t>(models::KalmanScheme::AuthorsFirmware),
      .noise = {
          noise.processForce,
          noise.processCovariance,
          noise.processStiffness,
          noise.finiteElements,
          noise.interpolation,
          noise.wandering}};
}

template <typename Message>
std::uint32_t hashOf(const Message& message, std::uint32_t before = 0) {
  const Bytes payload = payloadOf(message);
  return wire::crc32(payload.data(), payload.size(), before);
}

/// The models of the engine, as they would render the same scene.
template <typename Scalar>
class Reference {
 public:
  Reference(ModelKind kind, const std::vector<models::CurveNode<float>>& nodes) : kind_(kind) {
    for (const auto& node : nodes) nodes_.push_back({Scalar(node.travel), Scalar(node.force)});
  }

  Scalar at(Scalar travel) {
    if (kind_ == ModelKind::FiniteElements) return elements_.at(travel, state_).force;
    const models::Interpolation<Scalar> curve(nodes_.data(), nodes_.size(), {});
    const Scalar recorded = curve.at(travel, hint_).force;
    if (kind_ == ModelKind::Interpolation) return recorded;
    const Scalar elastic = elements_.at(travel, state_).force;
    const Scalar travelled = last_ ? travel - *last_ : Scalar{0};
    last_ = travel;
    return filter_.step(travelled, elastic, recorded);
  }

 private:
  using Elements = models::FiniteElements<Scalar>;

  ModelKind kind_;
  std::vector<models::CurveNode<Scalar>> nodes_;
  std::size_t hint_ = 0;
  Elements elements_{typename Elements::Parameters()};
  typename Elements::State state_;
  models::KalmanFilter<Scalar> filter_{
      models::KalmanNoise<Scalar>().factored(), models::KalmanScheme::AuthorsFirmware};
  std::optional<Scalar> last_;
};

/// Of the encoder, in a closing and an opening of a second each.
std::int32_t countsInStroke(int millisecond) {
  return static_cast<std::int32_t>(1300.0 * (1.0 - std::cos(0.00314159 * millisecond)));
}

class PunchRendersTest : public PunchProgramTest {
 protected:
  /// Sends a scene; its hash.
  std::uint32_t teach(const Model& model, const std::vector<models::CurveNode<float>>& nodes) {
    said_.taken.clear();
    send(model);
    std::uint32_t hash = hashOf(model);
    for (const auto& table : tablesOf(nodes)) {
      step();
      send(table);
      hash = hashOf(table, hash);
    }
    step();
    return hash;
  }
  void beginQuick() {
    auto quick = limits();
    quick.largestSlew = 60'000;  // so that the voltage is the model's
    begin(quick);
    greet();
  }
  void arm() {
    send(Arm{.isArmed = true, .expiry = 20});
    step();
  }
  int render(std::uint32_t hash) {
    send(Render{.hash = hash, .expiry = 10});
    return step();
  }

  const std::vector<models::CurveNode<float>> cut_ = parametricNodes();
};

TEST_F(PunchRendersTest, AgreesOnAScenePieceByPiece) {
  greet();
  const Model model = modelOf(ModelKind::Interpolation, cut_.size());
  const auto tables = tablesOf(cut_);
  ASSERT_GT(tables.size(), 2U);
  send(model);
  step();
  std::uint32_t hash = hashOf(model);
  ASSERT_EQ(said_.taken.size(), 1U);
  EXPECT_EQ(said_.taken[0].hash, hash);
  EXPECT_EQ(said_.taken[0].verdict, ModelVerdict::Incomplete);
  for (const auto& table : tables) {
    send(table);
    step();
    hash = hashOf(table, hash);
    EXPECT_EQ(said_.taken.back().hash, hash);
    const bool isLast = &table == &tables.back();
    EXPECT_EQ(said_.taken.back().verdict, isLast ? ModelVerdict::Taken : ModelVerdict::Incomplete);
  }
}

TEST_F(PunchRendersTest, TakesPiecesInTheirOrderOnly) {
  greet();
  const auto tables = tablesOf(cut_);
  send(modelOf(ModelKind::Interpolation, cut_.size()));
  send(tables[1]);
  step();
  EXPECT_EQ(said_.taken.back().verdict, ModelVerdict::Incomplete);
  for (const auto& table : tables) send(table);
  send(tables.back());  // once more
  steps(3);
  ASSERT_EQ(said_.taken.size(), tables.size() + 3);
  EXPECT_EQ(said_.taken[said_.taken.size() - 2].verdict, ModelVerdict::Taken);
  EXPECT_EQ(said_.taken.back().verdict, ModelVerdict::Incomplete);
  EXPECT_EQ(said_.taken.back().hash, said_.taken[said_.taken.size() - 2].hash);
}

TEST_F(PunchRendersTest, RefusesAModelThatIsUnsound) {
  greet();
  auto backwards = cut_;
  std::swap(backwards[3], backwards[4]);
  teach(modelOf(ModelKind::Interpolation, cut_.size()), backwards);
  EXPECT_EQ(said_.taken.back().verdict, ModelVerdict::Unsound);

  const auto verdictOn = [&](const auto& spoil) {
    Model model = modelOf(ModelKind::Kalman, cut_.size());
    spoil(model);
    teach(model, cut_);
    return said_.taken.back().verdict;
  };
  EXPECT_EQ(verdictOn([](Model&) {}), ModelVerdict::Taken);
  EXPECT_EQ(verdictOn([](Model& m) { m.toolPosition = m.end; }), ModelVerdict::Unsound);
  EXPECT_EQ(verdictOn([](Model& m) { m.elements = 0; }), ModelVerdict::Unsound);
  EXPECT_EQ(verdictOn([](Model& m) { m.readings = 3U << 1U; }), ModelVerdict::Unsound);
  EXPECT_EQ(verdictOn([](Model& m) { m.rampLength = 0.0F; }), ModelVerdict::Unsound);
  EXPECT_EQ(verdictOn([](Model& m) { m.largestForce = -1.0F; }), ModelVerdict::Unsound);
  EXPECT_EQ(verdictOn([](Model& m) { m.noise[0] = -1.0F; }), ModelVerdict::Unsound);
  EXPECT_EQ(verdictOn([](Model& m) { m.noise[1] = 100.0F; }), ModelVerdict::Unsound);
}

TEST_F(PunchRendersTest, TakesNoModelWhileItIsArmed) {
  greetAndArm();
  send(modelOf(ModelKind::FiniteElements, 0));
  hold(0, 1);
  ASSERT_EQ(said_.taken.size(), 1U);
  EXPECT_EQ(said_.taken[0].verdict, ModelVerdict::Armed);
}

TEST_F(PunchRendersTest, RendersOnlyTheSceneThatIsMeant) {
  greet();
  bench_.position = 1300;
  steps(20);
  const auto hash = teach(modelOf(ModelKind::FiniteElements, 0), {});
  arm();
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(render(hash + 1), 0);
    EXPECT_FALSE(state().isRendering);
  }
  for (int i = 0; i < 10; ++i) render(hash);
  EXPECT_TRUE(state().isRendering);
  EXPECT_GT(bench_.voltage, 1000);
  for (int i = 0; i < 10; ++i) render(hash + 1);
  EXPECT_EQ(bench_.voltage, 0);
  EXPECT_FALSE(state().isRendering);
}

TEST_F(PunchRendersTest, RendersNothingOfASceneThatIsIncompleteOrNone) {
  greet();
  bench_.position = 1300;
  steps(20);
  const Model model = modelOf(ModelKind::Interpolation, cut_.size());
  send(model);
  arm();
  for (int i = 0; i < 20; ++i) EXPECT_EQ(render(hashOf(model)), 0);
  begin(limits());
  greetAndArm();
  for (int i = 0; i < 20; ++i) EXPECT_EQ(render(0), 0);
}

TEST_F(PunchRendersTest, StopsToRenderWhenItIsNotToldToGoOn) {
  greet();
  bench_.position = 1300;
  steps(20);
  const auto hash = teach(modelOf(ModelKind::FiniteElements, 0), {});
  arm();
  for (int i = 0; i < 20; ++i) render(hash);
  const int full = bench_.voltage;
  ASSERT_GT(full, 1200);
  steps(10);
  EXPECT_EQ(bench_.voltage, full);
  EXPECT_EQ(step(), full - 1200);
  steps(9);
  EXPECT_EQ(bench_.voltage, 0);
  EXPECT_TRUE(has(kExpired));
}

TEST_F(PunchRendersTest, GivesTheVoltageOfAForceThatNoMotorHasWithinItsLimit) {
  beginQuick();
  Model model = modelOf(ModelKind::FiniteElements, 0);
  model.millivoltsPerNewton = 1e38F;
  bench_.position = 2000;
  steps(20);
  const auto hash = teach(model, {});
  arm();
  for (int i = 0; i < 20; ++i) render(hash);
  EXPECT_EQ(bench_.voltage, 12000);
  EXPECT_TRUE(has(kSaturated));
}

TEST_F(PunchRendersTest, BoundsTheForceOfItsScene) {
  beginQuick();
  Model model = modelOf(ModelKind::FiniteElements, 0);
  model.largestForce = 2.0F;
  bench_.position = 2000;
  steps(20);
  const auto hash = teach(model, {});
  arm();
  EXPECT_EQ(render(hash), 3000);
}

TEST_F(PunchRendersTest, RendersNoMoreThanTheHostLetsThrough) {
  beginQuick();
  bench_.position = 2000;
  steps(20);
  const auto hash = teach(modelOf(ModelKind::FiniteElements, 0), {});
  arm();
  for (const std::int16_t most : std::initializer_list<std::int16_t>{32767, 3000, 0, 500}) {
    send(Render{.hash = hash, .expiry = 10, .most = most});
    EXPECT_EQ(step(), most == 32767 ? 10'500 : most);
    EXPECT_FALSE(has(kSaturated));
  }
  send(Render{.hash = hash, .expiry = 10, .most = -1});
  EXPECT_EQ(step(), 500);  // is none
  EXPECT_EQ(state().badFrames, 1);
}

class PunchRendersAsTheEngine : public PunchRendersTest,
                                public testing::WithParamInterface<ModelKind> {};

TEST_P(PunchRendersAsTheEngine, InSinglePrecisionToTheLastBit) {
  beginQuick();
  const auto nodes =
      GetParam() == ModelKind::FiniteElements ? std::vector<models::CurveNode<float>>() : cut_;
  const auto hash = teach(modelOf(GetParam(), nodes.size()), nodes);
  ASSERT_EQ(said_.taken.back().verdict, ModelVerdict::Taken);
  ASSERT_EQ(said_.taken.back().hash, hash);
  arm();
  Reference<float> reference(GetParam(), nodes);
  int least = 0;
  int most = 0;
  for (int i = 0; i < 2000; ++i) {
    bench_.position = countsInStroke(i);
    const int millivolts = render(hash);
    const float force = reference.at(kTravelPerCount * static_cast<float>(bench_.position));
    const float bounded = std::clamp(force, -8.0F, 8.0F);
    ASSERT_EQ(millivolts, static_cast<int>(bounded * 1500.0F)) << i;
    least = std::min(least, millivolts);
    most = std::max(most, millivolts);
  }
  EXPECT_GT(most, 6000);
  EXPECT_GT(least, -12000);
  EXPECT_EQ(state().faults, 0);
}

TEST_P(PunchRendersAsTheEngine, AndInDoublePrecisionToATenThousandth) {
  ChipScene scene;
  const auto nodes =
      GetParam() == ModelKind::FiniteElements ? std::vector<models::CurveNode<float>>() : cut_;
  const Model model = modelOf(GetParam(), nodes.size());
  const Bytes payload = payloadOf(model);
  scene.take(model, payload.data(), payload.size());
  for (const auto& table : tablesOf(nodes)) scene.take(table, payload.data(), payload.size());
  ASSERT_TRUE(scene.isReady());
  Reference<double> reference(GetParam(), nodes);
  for (int i = 0; i < 2000; ++i) {
    const auto counts = countsInStroke(i);
    const double expected = reference.at(static_cast<double>(kTravelPerCount) * counts);
    ASSERT_NEAR(
        scene.forceAt(scene.travelAt(counts)), expected, 1e-4 * std::max(1.0, std::abs(expected)))
        << i;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Models,
    PunchRendersAsTheEngine,
    testing::Values(ModelKind::Interpolation, ModelKind::FiniteElements, ModelKind::Kalman),
    [](const auto& parameter) {
      return parameter.param == ModelKind::Kalman          ? "Kalman"
             : parameter.param == ModelKind::Interpolation ? "Interpolation"
                                                           : "FiniteElements";
    });

}  // namespace punch_program_test
}  // namespace haptics::firmware
