"""A robot's controller on the wire of FRI 1.15, written from the wire format alone.

It shares no code with Palpate: messages are packed and read here, byte by byte, and the arm is a plane linkage in closed
form. It plays the side that sets the pace: it sends where the arm is, and keeps what it is told.
"""
import math
import socket
import struct
import threading
import time

MONITORING, COMMAND = 0x245142, 0x34001
WAIT_MONITORING, MONITORING_READY, COMMANDING_WAIT, COMMANDING_ACTIVE = 1, 2, 3, 4
EXCELLENT, CARTESIAN_IMPEDANCE, WRENCH, CARTESIAN_OVERLAY, ACTIVE, AUTOMATIC = 3, 1, 2, 2, 2, 2
VARINT, FIXED64, BYTES = 0, 1, 2


def varint(value):
    out = bytearray()
    while value > 0x7F:
        out.append(value & 0x7F | 0x80)
        value >>= 7
    out.append(value)
    return bytes(out)


def whole(field, value):
    return varint(field << 3 | VARINT) + varint(value)


def part(field, *content):
    inside = b"".join(content)
    return varint(field << 3 | BYTES) + varint(len(inside)) + inside


def joints(field, values):
    return part(field, *(varint(1 << 3 | FIXED64) + struct.pack("<d", value) for value in values))


def read_varint(data, at):
    value = shift = 0
    while True:
        byte = data[at]
        at += 1
        value |= (byte & 0x7F) << shift
        if byte < 0x80:
            return value, at
        shift += 7


def fields_of(data):
    """Every field of a message, in order: (number, value)."""
    at = 0
    while at < len(data):
        key, at = read_varint(data, at)
        if key & 7 == VARINT:
            value, at = read_varint(data, at)
        elif key & 7 == FIXED64:
            value, at = struct.unpack_from("<d", data, at)[0], at + 8
        elif key & 7 == BYTES:
            size, at = read_varint(data, at)
            value, at = data[at:at + size], at + size
        else:
            raise ValueError(f"wire type {key & 7}")
        yield key >> 3, value


def doubles_of(data):
    """The doubles of field 1, packed or not."""
    found = []
    for _, value in fields_of(data):
        found += struct.unpack(f"<{len(value) // 8}d", value) if isinstance(value, bytes) else [value]
    return found


class Answer:
    """A command message: which of ours it answers, the joints, and the wrench (Fx Fy Fz τA τB τC)."""

    def __init__(self, data):
        message = dict(fields_of(data))
        header = dict(fields_of(message[1]))
        if header[1] != COMMAND:
            raise ValueError(f"identifier {header[1]:#x}")
        command = dict(fields_of(message.get(2, b"")))
        self.sequence, self.reflected = header[2], header[3]
        self.joints = doubles_of(command[1]) if 1 in command else None
        self.wrench = doubles_of(command[2]) if 2 in command else None


class DownwardArm:
    """An iiwa 14 whose tool points straight down: a plane linkage of two members, and a wrist that keeps its direction."""

    SHOULDER, UPPER, FORE, TOOL = 0.36, 0.42, 0.40, 0.126 + 0.2  # [m]
    ZERO = [0.0, 30.0, 0.0, -90.0, 0.0, 60.0, 0.0]  # [deg]

    def __init__(self):
        upper, fore = math.radians(30.0), math.radians(120.0)  # from the vertical
        self.x = self.UPPER * math.sin(upper) + self.FORE * math.sin(fore)
        self.z = self.UPPER * math.cos(upper) + self.FORE * math.cos(fore)

    def joints_at(self, depth):
        """The joints [rad] with the tool @p depth [m] below where it is at ZERO."""
        x, z = self.x, self.z - depth
        far = math.hypot(x, z)
        towards = math.atan2(x, z)
        upper = towards - math.acos((self.UPPER**2 + far**2 - self.FORE**2) / (2 * self.UPPER * far))
        fore = towards + math.acos((self.FORE**2 + far**2 - self.UPPER**2) / (2 * self.FORE * far))
        return [0.0, upper, 0.0, upper - fore, 0.0, math.pi - fore, 0.0]


class Sent:
    """A message and what came back for it."""

    def __init__(self, depth, state):
        self.depth = depth
        self.state = state
        self.answer = None


class Robot(threading.Thread):
    """Sends a message every period to a port of this computer, until stop().

    @p depth_at gives the depth [m] of the n-th message in COMMANDING_ACTIVE.
    """

    SETTLING, PATIENCE = 20, 8  # messages

    def __init__(self, port, period_ms, depth_at):
        super().__init__(daemon=True)
        self.period_ms, self.depth_at = period_ms, depth_at
        self.arm = DownwardArm()
        self.home = self.arm.joints_at(0.0)
        self.sent = []
        self.wrong = []
        self.longest_gap = 0.0  # between two messages, while commands were taken [s]
        self.state, self.since, self.missed, self.moves = WAIT_MONITORING, 0, 0, 0
        self.reflected = 0
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.bind(("127.0.0.1", 0))
        self.client = ("127.0.0.1", port)
        self.over = threading.Event()

    def stop(self):
        self.over.set()
        self.join()
        self.socket.close()

    def run(self):
        due = last = time.monotonic()
        while not self.over.is_set():
            now = time.monotonic()
            if self.state == COMMANDING_ACTIVE:
                self.longest_gap = max(self.longest_gap, now - last)
            last = now
            self.send()
            due = max(due + self.period_ms / 1000, now)
            self.receive(due)
            self.follow()

    def send(self):
        depth = self.depth_at(self.moves) if self.state == COMMANDING_ACTIVE else self.depth_at(0)
        self.moves += self.state == COMMANDING_ACTIVE
        self.sent.append(Sent(depth, self.state))
        try:
            self.socket.sendto(self.message(len(self.sent) - 1, depth), self.client)
        except ConnectionRefusedError:
            pass  # nobody listens yet

    def message(self, number, depth):
        measured = self.arm.joints_at(depth)
        stamp = number * self.period_ms
        ipo = []
        if self.state >= COMMANDING_WAIT:
            ipo = [part(5, joints(1, self.home), whole(10, WRENCH), whole(11, CARTESIAN_OVERLAY))]
        return b"".join([
            part(1, whole(1, MONITORING), whole(2, number), whole(3, self.reflected)),
            part(2, whole(1, 7), whole(2, 0), *[whole(5, ACTIVE)] * 7, whole(6, AUTOMATIC), whole(7, CARTESIAN_IMPEDANCE)),
            part(3, joints(1, measured), joints(2, [0.0] * 7), joints(3, self.home), joints(4, [0.0] * 7),
                 joints(5, [0.0] * 7), part(15, whole(1, 1_700_000_000 + stamp // 1000), whole(2, stamp % 1000 * 1_000_000))),
            part(4, whole(1, self.state), whole(2, EXCELLENT), whole(3, self.period_ms), whole(4, 1)),
            *ipo])

    def receive(self, until):
        """Takes answers until the next message is due."""
        while (left := until - time.monotonic()) > 0:
            self.socket.settimeout(left)
            try:
                data, sender = self.socket.recvfrom(1501)
            except (TimeoutError, socket.timeout, ConnectionRefusedError):
                continue
            if sender != self.client:
                continue
            try:
                self.take(Answer(data))
            except (ValueError, KeyError, IndexError, struct.error) as error:
                self.wrong.append(f"an answer cannot be read: {error!r}")

    def take(self, answer):
        self.reflected = answer.sequence
        if answer.reflected >= len(self.sent) or self.sent[answer.reflected].answer:
            self.wrong.append(f"an answer to message {answer.reflected}, of {len(self.sent)} sent")
            return
        sent = self.sent[answer.reflected]
        sent.answer = answer
        if sent.state < COMMANDING_WAIT:
            return
        if answer.joints != self.home:
            self.wrong.append("the joints are not mirrored")
        if answer.wrench is None or len(answer.wrench) != 6:
            self.wrong.append("a wrench is missing")

    def follow(self):
        """The next state: forward while every message is answered, back when nobody answers."""
        if self.sent[-1].answer is None:
            self.missed += 1
            self.since = 0
            if self.missed > self.PATIENCE:
                self.state = WAIT_MONITORING
            return
        self.missed = 0
        self.since += 1
        if self.since >= self.SETTLING and self.state < COMMANDING_ACTIVE:
            self.state, self.since = self.state + 1, 0
