# SPDX-License-Identifier: Apache-2.0
"""Defects in what shows a growing picture in a viewer."""
from mutant import Mutant

GETS = "a viewer gets a picture once, and then its pixels, the last ones for certain"
AGAIN = "a viewer that goes is looked for again, and gets the picture anew"
SLOW = "a viewer that never reads holds nobody up, and is named as too slow"
WATCHED = "a viewer ends with the picture that is saved, and the file has the bytes that it has without"

MUTANTS = [
    Mutant("a packet's length does not count itself", "io/network/tev_packets.cpp",
           "std::uint32_t(bytes_.size());", "std::uint32_t(bytes_.size() - 4);",
           "test_io", "a packet that opens a picture has the bytes of tev's protocol"),
    Mutant("a packet gives the first row for all", "io/network/tev_packets.cpp",
           "picture.values.data() + std::size_t(y0) * row", "picture.values.data()",
           "test_io", "a packet of pixels has the bytes of tev's protocol"),
    Mutant("the last rows of a picture are not sent", "io/network/tev_viewer.cpp",
           "y < picture.height; y += rows", "y + rows <= picture.height; y += rows",
           "test_io", GETS),
    Mutant("a picture is created before each of its updates", "io/network/tev_viewer.cpp",
           "is_created = true;", "is_created = false;",
           "test_io", GETS),
    Mutant("the last picture is not waited for", "io/network/tev_viewer.cpp",
           "(Clock::now() >= *end || (!is_sending && !next))", "true",
           "test_io", GETS),
    Mutant("a sender never gives up", "io/network/tcp_connection.cpp",
           "if (gives_up()) return false;", "",
           "test_io", SLOW),
    Mutant("a viewer that closed its connection is not noticed", "io/network/tcp_connection.cpp",
           "return received == 0 ||", "return",
           "test_io", "a viewer that goes without a word is noticed before the next picture"),
    Mutant("a lost viewer is not looked for again", "io/network/tev_viewer.cpp",
           "if (end && !is_connected) break;", "if (!is_connected) break;",
           "test_io", AGAIN),
    Mutant("viewers do not get the last pass", "cli/live/live_picture.cpp",
           "viewer->show_last(result);", "static_cast<void>(viewer);",
           "test_cli", WATCHED),
    Mutant("passes are shown before they are done", "integrators/render.cpp",
           "    const double start = seconds();\n",
           "    const double start = seconds();\n"
           "    if (options_.pass_done && !is_stopped()) options_.pass_done(film_);\n",
           "test_integrators",
           "whoever watches passes sees all samples of each, more each time, and changes nothing"),
    Mutant("a viewer takes all channels for one", "cli/live/tev_window.cpp",
           "picture.channels.push_back(channel.name);", 'picture.channels.push_back("R");', "test_cli",
           "a viewer gets the layers that the file has, by the same names"),
]
