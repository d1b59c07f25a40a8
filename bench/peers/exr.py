# SPDX-License-Identifier: Apache-2.0
"""Pictures of linear colours: OpenEXR files of scan lines, as far as the renderers here write them."""
import itertools
import struct
import zlib
from array import array
from dataclasses import dataclass
from pathlib import Path

MAGIC = struct.pack("<II", 20000630, 2)
COMPRESSIONS = {0: 1, 2: 1, 3: 16}  # none, ZIP by line, ZIP: lines of a block
HALF, FLOAT = 1, 2
NOT_SCAN_LINES = 0x1a  # tiles, deep pixels, several parts


@dataclass
class Picture:
    """Rows from the top, three floats a pixel."""
    width: int
    height: int
    pixels: array


def attributes(data):
    """(name -> bytes, offset behind the header)."""
    found, offset = {}, len(MAGIC)
    while data[offset]:
        name_end = data.index(b"\0", offset)
        type_end = data.index(b"\0", name_end + 1)
        size, = struct.unpack_from("<I", data, type_end + 1)
        found[data[offset:name_end].decode()] = data[type_end + 5:type_end + 5 + size]
        offset = type_end + 5 + size
    return found, offset + 1


def channels(data):
    """(name, type) of each channel, in the file's order."""
    offset = 0
    while data[offset]:
        end = data.index(b"\0", offset)
        kind, = struct.unpack_from("<I", data, end + 1)
        yield data[offset:end].decode(), kind
        offset = end + 17


def unpacked(block, size):
    """The bytes of a block of lines; one that did not become shorter is stored as it is."""
    if len(block) == size:
        return block
    differences = zlib.decompress(block)
    halves = bytes(itertools.accumulate(differences, lambda last, step: (last + step - 128) & 255))
    joined = bytearray(size)
    middle = (size + 1) // 2
    joined[0::2], joined[1::2] = halves[:middle], halves[middle:]
    return bytes(joined)


def checked_header(data, path):
    if data[:5] != MAGIC[:5] or data[5] & NOT_SCAN_LINES:
        raise ValueError(f"{path}: no OpenEXR file of scan lines")
    return attributes(data)


def data_window(header):
    """Left, top, right and bottom, the last two within the picture."""
    return struct.unpack("<4i", header["dataWindow"])


def size(path):
    """(width, height) of an OpenEXR file of scan lines, whatever its compression."""
    left, top, right, bottom = data_window(checked_header(Path(path).read_bytes(), path)[0])
    return right - left + 1, bottom - top + 1


def read(path):
    """The R, G and B of an OpenEXR file; other channels are left out."""
    data = Path(path).read_bytes()
    header, offset = checked_header(data, path)
    left, top, right, bottom = data_window(header)
    width, height = right - left + 1, bottom - top + 1
    names = list(channels(header["channels"]))
    lines = COMPRESSIONS.get(header["compression"][0])
    if lines is None or any(kind not in (HALF, FLOAT) for _, kind in names):
        raise ValueError(f"{path}: a compression or a type of numbers that is not read here")
    picture = Picture(width, height, array("f", bytes(12 * width * height)))
    for start in struct.unpack_from(f"<{-(-height // lines)}Q", data, offset):
        y, size = struct.unpack_from("<iI", data, start)
        count = min(lines, bottom - y + 1)
        whole = count * width * sum(2 if kind == HALF else 4 for _, kind in names)
        block = unpacked(data[start + 8:start + 8 + size], whole)
        put_lines(picture, block, names, range(y - top, y - top + count))
    return picture


def put_lines(picture, block, names, rows):
    offset, width = 0, picture.width
    for row in rows:
        for name, kind in names:
            letter, size = ("e", 2) if kind == HALF else ("f", 4)
            if name in "RGB":
                values = struct.unpack_from(f"<{width}{letter}", block, offset)
                first = 3 * width * row + "RGB".index(name)
                picture.pixels[first:3 * width * (row + 1):3] = array("f", values)
            offset += size * width


def attribute(name, kind, data):
    return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<I", len(data)) + data


def write(path, picture):
    """Writes an OpenEXR file without compression."""
    width, height = picture.width, picture.height
    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    names = b"".join(name + b"\0" + struct.pack("<4I", FLOAT, 0, 1, 1) for name in (b"B", b"G", b"R"))
    header = (MAGIC + attribute("channels", "chlist", names + b"\0") +
              attribute("compression", "compression", b"\0") + attribute("dataWindow", "box2i", window) +
              attribute("displayWindow", "box2i", window) + attribute("lineOrder", "lineOrder", b"\0") +
              attribute("pixelAspectRatio", "float", struct.pack("<f", 1)) +
              attribute("screenWindowCenter", "v2f", struct.pack("<2f", 0, 0)) +
              attribute("screenWindowWidth", "float", struct.pack("<f", 1)) + b"\0")
    line = 8 + 12 * width
    first = len(header) + 8 * height
    parts = [header, struct.pack(f"<{height}Q", *range(first, first + line * height, line))]
    for y in range(height):
        row = picture.pixels[3 * width * y:3 * width * (y + 1)]
        parts += [struct.pack("<iI", y, 12 * width), *(row[k::3].tobytes() for k in (2, 1, 0))]
    Path(path).write_bytes(b"".join(parts))
