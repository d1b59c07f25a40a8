# SPDX-License-Identifier: Apache-2.0
"""Defects in the readers and writers of OpenEXR and PNG."""
from mutant import Mutant

ALPHA = "an EXR of one channel is grey, and its alpha is 1 where it has none"
CHROMA = "luminance with chroma of a lower resolution gives the colours that it stands for"
TEXTS = "texts that would say how an EXR is stored are neither read nor written"
KINDS = "PNGs of all bits and channels, in one pass or several, give the numbers that they store"

MUTANTS = [
    Mutant("an EXR's alpha is not read", "io/picture/exr_reader.cpp",
           "if (file.has(alpha.name)) return grey_image", "if (false) return grey_image",
           "test_io", ALPHA),
    Mutant("luminance with chroma is read as grey", "io/picture/exr_reader.cpp",
           "if (file.is_luminance_chroma())", "if (false)", "test_io", CHROMA),
    Mutant("all rows with chroma are the first", "io/picture/exr_reader.cpp",
           "file.readPixels(window.min.y + y);", "file.readPixels(window.min.y);", "test_io", CHROMA),
    Mutant("channels of fewer pixels are read as layers", "io/picture/exr_reader.cpp",
           "if (stored.xSampling != 1 || stored.ySampling != 1)", "if (false)", "test_io", CHROMA),
    Mutant("an EXR's frame begins at 0", "io/picture/exr_attributes.cpp",
           "picture.min.x - whole.min.x,", "picture.min.x,",
           "test_io", "an EXR whose frame begins anywhere is read with its place in it"),
    Mutant("the kind of a file's part is a text of its picture", "io/picture/exr_attributes.cpp",
           'if (name == "type") continue;', "", "test_io", TEXTS),
    Mutant("texts take the places of what an EXR needs", "io/picture/exr_attributes.cpp",
           "header.find(stored) == header.end()", "true", "test_io", TEXTS),
    Mutant("channels of 16 bits are those of the row before", "io/picture/exr_writer.cpp",
           "      std::copy_n(row.numbers.begin(), row.halves.size(), row.halves.begin());\n", "",
           "test_io", "an EXR holds channels of any names, in 16 bits and in 32"),
    Mutant("rows and columns of tiles are exchanged", "io/picture/exr_tiled_file.cpp",
           "readTile(tile.column, tile.row,", "readTile(tile.row, tile.column,", "test_io",
           "a converted picture has all texels of all levels, for every meaning, in memory and in tiles"),
    Mutant("tiles may have any channels", "io/picture/exr_tiled_file.cpp",
           "if (!has_colors_alone(tiles.header()))", "if (false)", "test_io",
           "tiles of other channels than three of 32-bit floats are refused"),
    Mutant("a PNG in several passes is read before its last", "io/picture/png_reader.cpp",
           "pass + 1 < passes_", "pass + 2 < passes_", "test_io", KINDS),
    Mutant("the bytes of a PNG's 16 bits are exchanged", "io/picture/png_reader.cpp",
           "256 * at[0] + at[1]", "256 * at[1] + at[0]", "test_io", KINDS),
    Mutant("what a JPEG lacks is grey", "io/picture/jpeg_reader.cpp",
           "if (jpeg->err->msg_code == fault) fail_reading(jpeg);", "static_cast<void>(fault);", "test_io",
           "a JPEG that is cut off or damaged is an error, wherever it is"),
    Mutant("all that libjpeg warns of is a fault", "io/picture/jpeg_reader.cpp",
           "if (jpeg->err->msg_code == fault) fail_reading(jpeg);", "fail_reading(jpeg);", "test_io",
           "what does no harm in a JPEG is passed over"),
    Mutant("a printer's black is left out", "io/picture/jpeg_reader.cpp", "(at[c] * at[3] + 127) / 255",
           "at[c]", "test_io",
           "a printer's colours are multiplied by its black"),
    Mutant("a JPEG's header is not checked", "io/picture/jpeg_reader.cpp",
           "check({int(jpeg_.image_width), int(jpeg_.image_height), jpeg_.num_components});",
           "check({1, 1, 1});", "test_io", "a JPEG has the colours, or the grey, that it was made of"),
]
