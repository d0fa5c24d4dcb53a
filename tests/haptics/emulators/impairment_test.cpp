#include "haptics/emulators/impairment.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/allocation_counter.h"

namespace haptics::emulators {
namespace impairment_test {

constexpr std::size_t kSize = 16;  // of a frame; garbage has another size
constexpr std::size_t kGarbage = 24;
constexpr std::uint8_t kOdd = 0x5A;

using Frame = std::array<std::uint8_t, kSize>;

/// Its number, and its number again, so that it is seen when a byte is another. Has no zero bytes.
Frame frameOf(std::uint32_t number) {
  Frame frame{};
  frame.fill(kOdd);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto byte = static_cast<std::uint8_t>(1U + (number >> 7U * i & 0x7FU));
    frame[i] = byte;
    frame[i + 4] = static_cast<std::uint8_t>(0xFFU - byte);
  }
  return frame;
}

bool isWhole(std::span<const std::uint8_t> frame) {
  if (frame.size() != kSize) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    if (frame[i] + frame[i + 4] != 0xFF) return false;
  }
  return std::all_of(frame.begin() + 8, frame.end(), [](auto byte) { return byte == kOdd; });
}

std::uint32_t numberOf(std::span<const std::uint8_t> frame) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) number |= (frame[i] - 1U) << 7U * i;
  return number;
}

/// The other side, which sees only what arrives.
class Receiver {
 public:
  explicit Receiver(std::size_t frames) : arrived_(frames, 0) {}

  void operator()(std::span<const std::uint8_t> frame) {
    if (!isWhole(frame)) {
      ++(frame.size() == kSize ? damaged : garbage);
      return;
    }
    const std::uint32_t number = numberOf(frame);
    if (arrived_.at(number)++ > 0) {
      ++doubled;
    } else if (number < next_) {
      ++late;
    } else {
      next_ = number + 1;
    }
    order.push_back(number);
  }

  std::uint64_t missing() const {
    return static_cast<std::uint64_t>(std::count(arrived_.begin(), arrived_.end(), 0));
  }

  std::uint64_t damaged = 0;
  std::uint64_t garbage = 0;
  std::uint64_t doubled = 0;
  std::uint64_t late = 0;
  std::vector<std::uint32_t> order;

 private:
  std::vector<int> arrived_;
  std::uint32_t next_ = 0;
};

void passAll(Impairment& impairment, Receiver& receiver, std::uint32_t frames) {
  for (std::uint32_t i = 0; i < frames; ++i) impairment.pass(frameOf(i), receiver);
}

void expectSeen(const InjectedCounts& injected, const Receiver& receiver) {
  EXPECT_EQ(receiver.missing(), injected[Fault::Drop] + injected[Fault::Damage]);
  EXPECT_EQ(receiver.doubled, injected[Fault::Double]);
  EXPECT_EQ(receiver.late, injected[Fault::Reorder] + injected[Fault::Delay]);
  EXPECT_EQ(receiver.garbage, injected[Fault::Garbage]);
  EXPECT_EQ(receiver.damaged, injected[Fault::Damage]);
}

class ImpairmentSeeds : public testing::TestWithParam<std::uint64_t> {};

TEST_P(ImpairmentSeeds, CountsExactlyWhatTheReceiverSees) {
  constexpr std::uint32_t kFrames = 10'000;
  Impairment impairment(
      {.shares = {0.03, 0.04, 0.05, 0.06, 0.02, 0.03}, .seed = GetParam(), .delay = 7});
  Receiver receiver(kFrames);
  passAll(impairment, receiver, kFrames);
  impairment.flush(receiver);
  const InjectedCounts injected = impairment.counts();
  EXPECT_EQ(injected.passed, kFrames);
  expectSeen(injected, receiver);
  for (const std::uint64_t count : injected.of) EXPECT_GT(count, 100U);
}

INSTANTIATE_TEST_SUITE_P(Seeds, ImpairmentSeeds, testing::Range<std::uint64_t>(1, 21));

TEST(Impairment, IsTheSameForASeed) {
  std::vector<std::uint32_t> orders[2];
  for (auto& order : orders) {
    Impairment impairment({.shares = {0.1, 0.1, 0.1, 0.1, 0.1, 0.1}, .seed = 5});
    Receiver receiver(500);
    passAll(impairment, receiver, 500);
    order = receiver.order;
  }
  EXPECT_EQ(orders[0], orders[1]);
}

TEST(Impairment, ServesEveryOrderOnceAndOneToAFrame) {
  Impairment impairment;
  for (std::size_t i = 0; i < kFaultNames.size(); ++i) {
    impairment.schedule(static_cast<Fault>(i), 10 + static_cast<int>(i));
  }
  Receiver receiver(1000);
  passAll(impairment, receiver, 1000);
  const InjectedCounts injected = impairment.counts();
  for (std::size_t i = 0; i < kFaultNames.size(); ++i) {
    EXPECT_EQ(injected.of[i], 10 + i) << kFaultNames[i];
    EXPECT_EQ(impairment.pendingCount(static_cast<Fault>(i)), 0);
  }
  expectSeen(injected, receiver);
  EXPECT_EQ(impairment.held(), 0U);
}

TEST(Impairment, PassesOtherFramesUnchanged) {
  Impairment impairment;
  Receiver receiver(3);
  passAll(impairment, receiver, 3);
  EXPECT_EQ(receiver.order, (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(Impairment, SwapsTwoFrames) {
  Impairment impairment;
  impairment.schedule(Fault::Reorder, 2);
  Receiver receiver(5);
  passAll(impairment, receiver, 5);
  EXPECT_EQ(receiver.order, (std::vector<std::uint32_t>{1, 0, 3, 2, 4}));
}

TEST(Impairment, HoldsFramesBackForTheirTime) {
  Impairment impairment({.delay = 3});
  impairment.schedule(Fault::Delay, 2);
  Receiver receiver(7);
  passAll(impairment, receiver, 7);
  EXPECT_EQ(receiver.order, (std::vector<std::uint32_t>{2, 3, 0, 4, 1, 5, 6}));
}

TEST(Impairment, SendsAHeldFrameOnlyAfterALaterOne) {
  Impairment impairment({.delay = 1});
  impairment.schedule(Fault::Delay, 1);
  Receiver receiver(4);
  impairment.pass(frameOf(0), receiver);
  impairment.schedule(Fault::Drop, 2);
  impairment.pass(frameOf(1), receiver);
  impairment.pass(frameOf(2), receiver);
  EXPECT_TRUE(receiver.order.empty());
  EXPECT_EQ(impairment.counts()[Fault::Delay], 0U);
  impairment.pass(frameOf(3), receiver);
  EXPECT_EQ(receiver.order, (std::vector<std::uint32_t>{3, 0}));
  EXPECT_EQ(impairment.counts()[Fault::Delay], 1U);
}

TEST(Impairment, SendsHeldFramesAtTheEndAndCountsOnlyOvertakenOnes) {
  Impairment impairment({.delay = 100});
  Receiver receiver(4);
  impairment.schedule(Fault::Delay, 1);
  passAll(impairment, receiver, 3);
  impairment.schedule(Fault::Reorder, 1);
  impairment.pass(frameOf(3), receiver);
  impairment.flush(receiver);
  EXPECT_EQ(receiver.order, (std::vector<std::uint32_t>{1, 2, 0, 3}));
  EXPECT_EQ(impairment.counts()[Fault::Delay], 1U);
  EXPECT_EQ(impairment.counts()[Fault::Reorder], 0U);
}

TEST(Impairment, DelaysAFaultIfThereIsNoRoom) {
  constexpr auto kMost = static_cast<int>(Impairment::kMostHeld);
  Impairment impairment({.delay = 1000});
  impairment.schedule(Fault::Delay, kMost + 5);
  Receiver receiver(3000);
  passAll(impairment, receiver, 500);
  EXPECT_EQ(impairment.pendingCount(Fault::Delay), 5);
  EXPECT_EQ(impairment.held(), Impairment::kMostHeld);
  EXPECT_EQ(receiver.order.size(), 500U - Impairment::kMostHeld);
}

TEST(Impairment, ChangesNoFrameTwice) {
  Impairment impairment;
  impairment.schedule(Fault::Drop, 1);
  Receiver receiver(1);
  impairment.passWithoutFault(frameOf(0), receiver);
  EXPECT_EQ(receiver.order.size(), 1U);
  EXPECT_EQ(impairment.pendingCount(Fault::Drop), 1);
}

TEST(Impairment, SpoilsOneFrameOfASerialLineAndNotItsNeighbours) {
  constexpr std::uint8_t kEnd = 0;
  Impairment impairment(
      {.shares = {0.0, 0.0, 0.0, 0.0, 0.2, 0.2}, .garbage = kGarbage, .delimiter = kEnd});
  std::vector<std::uint8_t> line;
  for (std::uint32_t i = 0; i < 10'000; ++i) {
    std::array<std::uint8_t, kSize + 1> frame{};
    const Frame body = frameOf(i);
    std::copy(body.begin(), body.end(), frame.begin());
    frame.back() = kEnd;
    impairment.pass(frame, [&line](std::span<const std::uint8_t> bytes) {
      line.insert(line.end(), bytes.begin(), bytes.end());
    });
  }
  Receiver receiver(10'000);
  for (auto begin = line.begin(); begin != line.end();) {
    const auto end = std::find(begin, line.end(), kEnd);
    receiver(std::span(begin, end));
    begin = end + 1;
  }
  const InjectedCounts injected = impairment.counts();
  EXPECT_GT(injected[Fault::Garbage], 1500U);
  EXPECT_GT(injected[Fault::Damage], 1500U);
  expectSeen(injected, receiver);
}

TEST(Impairment, PassesEmptyAndTooLongFramesUnchanged) {
  Impairment impairment;
  impairment.schedule(Fault::Drop, 2);
  const std::vector<std::uint8_t> huge(Impairment::kLongestFrame + 1);
  std::vector<std::size_t> sizes;
  const auto send = [&sizes](std::span<const std::uint8_t> bytes) {
    sizes.push_back(bytes.size());
  };
  impairment.pass({}, send);
  impairment.pass(huge, send);
  EXPECT_EQ(sizes, (std::vector<std::size_t>{0, huge.size()}));
  EXPECT_EQ(impairment.pendingCount(Fault::Drop), 2);
}

TEST(Impairment, AllocatesNothingWhenFramesPass) {
  Impairment impairment({.shares = {0.1, 0.1, 0.1, 0.1, 0.1, 0.1}});
  std::size_t bytes = 0;
  const tests::AllocationCounter allocations;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    impairment.pass(frameOf(i), [&bytes](std::span<const std::uint8_t> b) { bytes += b.size(); });
  }
  EXPECT_EQ(allocations.count(), 0U);
  EXPECT_GT(bytes, 0U);
}

TEST(Impairment, AcceptsCommandsFromAnotherThread) {
  constexpr int kOrders = 1000;
  Impairment impairment;
  std::uint64_t sent = 0;
  std::uint64_t passed = 0;
  const auto pass = [&] {
    impairment.pass(frameOf(0), [&sent](std::span<const std::uint8_t> /*bytes*/) { ++sent; });
    ++passed;
  };
  std::thread other([&impairment] {
    for (int i = 0; i < kOrders; ++i) impairment.schedule(Fault::Drop, 1);
  });
  while (impairment.counts()[Fault::Drop] < kOrders) pass();
  other.join();
  EXPECT_EQ(passed - sent, static_cast<std::uint64_t>(kOrders));
}

TEST(Impairment, RefusesInvalidOptions) {
  EXPECT_THROW(Impairment({.shares = {0.6, 0.6}}), std::invalid_argument);
  EXPECT_THROW(Impairment({.shares = {-0.1}}), std::invalid_argument);
  EXPECT_THROW(Impairment({.delay = 0}), std::invalid_argument);
  EXPECT_THROW(Impairment({.garbage = 0}), std::invalid_argument);
}

}  // namespace impairment_test
}  // namespace haptics::emulators
