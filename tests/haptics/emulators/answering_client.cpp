#include "tests/haptics/emulators/answering_client.h"

#include <algorithm>
#include <span>

namespace tests {

using haptics::wire::fri::CommandData;
using haptics::wire::fri::CommandMessage;
using haptics::wire::fri::Refusal;
using haptics::wire::fri::SessionState;

bool AnsweringClient::hear(std::int64_t wait) {
  const std::uint64_t before = seen_.sound;
  if (!overhear(wait)) return false;
  if (seen_.sound > before && isForAnswer()) send(answer());
  return true;
}

bool AnsweringClient::overhear(std::int64_t wait) {
  std::array<std::uint8_t, haptics::wire::fri::kLargestDatagram + 1> bytes{};
  const auto received = socket_.receive(bytes, wait);
  if (!received) return false;
  ++seen_.datagrams;
  if (received->from != controller_) {
    ++seen_.foreign;
    return true;
  }
  const auto datagram = std::span(bytes).first(received->size);
  note(haptics::wire::fri::decode(datagram, version_, message_));
  return true;
}

void AnsweringClient::note(Refusal refusal) {
  switch (refusal) {
    case Refusal::None:
      ++seen_.sound;
      return follow(message_.header.sequence);
    case Refusal::JointCount:
      ++seen_.jointCount;
      return;
    case Refusal::NotFinite:
      ++seen_.notFinite;
      return;
    default:
      ++seen_.malformed;
  }
}

void AnsweringClient::follow(std::uint32_t number) {
  if (arrived_.size() <= number) arrived_.resize(number + 1U, 0);
  if (arrived_[number]++ > 0) {
    ++seen_.doubled;
  } else if (number < next_) {
    ++seen_.late;
  } else {
    next_ = number + 1;
  }
}

std::uint64_t AnsweringClient::missing() const {
  return static_cast<std::uint64_t>(std::count(arrived_.begin(), arrived_.end(), 0));
}

bool AnsweringClient::isForAnswer() const {
  const bool isIdle = !message_.connection || message_.connection->state == SessionState::Idle;
  return !isIdle && message_.header.sequence % every == 0;
}

CommandMessage AnsweringClient::answer() const {
  CommandMessage command;
  command.header.reflected = message_.header.sequence;
  command.header.sequence = sequence;
  if (message_.connection->state < SessionState::CommandingWait) {
    const auto& position = message_.monitorData->commandedPosition;  // 1.x only
    if (position) command.data = CommandData{.jointPosition = position};
    return command;
  }
  command.data = CommandData{
      .jointPosition = message_.ipoData->jointPosition, .wrench = wrench, .jointTorque = torque};
  if (message_.connection->state == SessionState::CommandingActive) {
    (*command.data->jointPosition)[6] += offset;
  }
  return command;
}

void AnsweringClient::send(const CommandMessage& command) {
  std::array<std::uint8_t, haptics::wire::fri::kLargestDatagram> bytes{};
  const std::size_t size = haptics::wire::fri::encode(command, version_, bytes);
  socket_.send(std::span(bytes).first(size), controller_);
  ++answers_;
  ++sequence;
}

}  // namespace tests
