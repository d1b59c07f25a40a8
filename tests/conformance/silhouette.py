# SPDX-License-Identifier: Apache-2.0
"""The silhouettes that PNG pictures show, and how much two of them have in common.

The standard library knows no pictures, so PNG is read here, as far as the suite and twinray write it (W3C,
"Portable Network Graphics", 2003): 8 bits a channel, not interlaced. Each byte of a line is predicted from
the bytes a (left), b (above) and c (above and left) of its own channel, so one channel can be read without
the others.

A silhouette is a bytes object of 0 and 1, one for each pixel, line by line.
"""
import struct
import zlib
from itertools import accumulate

CHANNELS = {0: 1, 2: 3, 4: 2, 6: 4}  # by PNG's colour type


class PictureError(Exception):
    """A picture that cannot be read."""


def chunks(data):
    """The (type, contents) of a PNG's chunks."""
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        raise PictureError("not a PNG")
    at = 8
    while at + 8 <= len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        yield kind, data[at + 8:at + 8 + length]
        at += length + 12


def paeth(a, b, c):
    """Whichever of a, b and c is nearest to a + b - c."""
    to_a, to_b, to_c = abs(b - c), abs(a - c), abs(a + b - 2 * c)
    if to_a <= to_b and to_a <= to_c:
        return a
    return b if to_b <= to_c else c


def unfiltered(kind, line, above):
    """A line of one channel from its differences to what PNG predicts."""
    if kind == 0 or (kind == 2 and not any(above)):
        return line
    if kind == 1:
        return bytes(value & 255 for value in accumulate(line))
    if kind == 2:
        return bytes((x + b) & 255 for x, b in zip(line, above))
    result, a, c = bytearray(), 0, 0
    for x, b in zip(line, above):
        a = (x + ((a + b) // 2 if kind == 3 else paeth(a, b, c))) & 255
        c = b
        result.append(a)
    return bytes(result)


class Picture:
    """A PNG: `width`, `height`, `channels`, and channels on demand."""

    def __init__(self, data):
        parts = list(chunks(data))
        header = next((body for kind, body in parts if kind == b"IHDR"), b"")
        if len(header) != 13:
            raise PictureError("no header")
        self.width, self.height, depth, colors, _, _, interlaced = struct.unpack(">IIBBBBB", header)
        if depth != 8 or colors not in CHANNELS or interlaced:
            raise PictureError("not 8 bits a channel, or interlaced")
        self.channels = CHANNELS[colors]
        self._lines = zlib.decompress(b"".join(body for kind, body in parts if kind == b"IDAT"))
        if len(self._lines) != self.height * (1 + self.width * self.channels):
            raise PictureError("lines are missing")

    def channel(self, index):
        """The values of one channel, line by line."""
        step = 1 + self.width * self.channels
        lines, above = [], bytes(self.width)
        for at in range(0, len(self._lines), step):
            line = self._lines[at + 1 + index:at + step:self.channels]
            above = unfiltered(self._lines[at], line, above)
            lines.append(above)
        return b"".join(lines)


def opaque(picture):
    """Where the suite's picture shows something: its background is transparent."""
    if picture.channels not in (2, 4):
        raise PictureError("it has no alpha channel, so its background is not known")
    return picture.channel(picture.channels - 1).translate(bytes([0]) + bytes([1]) * 255)


def not_black(picture):
    """Where a picture of normals shows something. No normal (x, y, z) is black: that would be (-1, -1, -1);
    two channels are enough, since at most one of x and y is -1."""
    red, green = (picture.channel(i).translate(bytes([0]) + bytes([1]) * 255) for i in (0, 1))
    return bytes(map(int.__or__, red, green))


def pixels(silhouette):
    return silhouette.count(1)


def likeness(a, b):
    """Intersection over union; 1 where both are empty."""
    both = int.from_bytes(a, "big") & int.from_bytes(b, "big")
    either = int.from_bytes(a, "big") | int.from_bytes(b, "big")
    return both.bit_count() / either.bit_count() if either else 1.0


def comparison(width, theirs, ours):
    """A PNG: grey what both show, red what theirs shows alone, green what ours shows alone."""
    colors = {(0, 0): b"\xff\xff\xff", (1, 1): b"\xaa\xaa\xaa",
              (1, 0): b"\xdd\x22\x22", (0, 1): b"\x22\xaa\x22"}
    values = [colors[pair] for pair in zip(theirs, ours)]
    lines = b"".join(b"\0" + b"".join(values[at:at + width]) for at in range(0, len(values), width))

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    header = struct.pack(">IIBBBBB", width, len(values) // width, 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(lines)) +
            chunk(b"IEND", b""))
