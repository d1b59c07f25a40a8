# SPDX-License-Identifier: Apache-2.0
"""Defects in what serves a growing picture to browsers."""
from mutant import Mutant

PFM = "a picture is saved as a PFM with all bits, also of a layer of one channel or two"
NAMES = "a server of this machine alone answers to names of this machine alone"
REFUSED = "what a page cannot have is refused with what would be valid"
STOPS = "a page stops a render that has begun, of which something is kept, once"

MUTANTS = [
    Mutant("any name leads to a server of this machine", "io/http/access.cpp",
           "if (!is_host_of_this_machine(host_of(host), address_.host))", "if (host.empty())",
           "test_io", NAMES),
    Mutant("a name that begins like this machine's is one", "io/http/access.cpp",
           'host == "localhost" ||', 'host.starts_with("localhost") ||',
           "test_io", NAMES),
    Mutant("tokens of one length are equal", "io/http/access.cpp",
           "return differences == 0;", "return true;",
           "test_io", "a server for other machines answers to its token alone, and each has its own"),
    Mutant("pages of others may change something", "io/http/access.cpp",
           'request.field("origin") != "http://" + host', 'request.field("origin").empty()',
           "test_io", "what changes something is asked for by a page of the server itself"),
    Mutant("a server listens for others without a token", "io/network/tcp_listener.cpp",
           ">> 24 == 127", ">> 24 >= 0", "test_io",
           "a port that is taken, or a host that is none, is an error with the system's reason"),
    Mutant("a request may be endless", "io/http/connection.cpp",
           "if (end > most_request_bytes) {", "if (end > 100 * most_request_bytes) {",
           "test_io", "a request has so many bytes and no more"),
    Mutant("connections beyond the limit stay", "io/http/server.cpp",
           "connections > most_connections || bytes", "bytes",
           "test_io", "beyond so many connections the oldest one makes room"),
    Mutant("bytes beyond the limit are kept", "io/http/server.cpp",
           " || bytes > most_kept_bytes", "",
           "test_io", "beyond so many bytes that wait for readers the oldest reader makes room"),
    Mutant("a large body is cut after a part", "io/http/connection.cpp",
           "if (!unsent().empty()) return;", "if (sent_ < head_.size()) return;",
           "test_io", "a request is answered with its body, what that is, and what may be made of it"),
    Mutant("a version is sent twice", "cli/live/web_routes.cpp",
           "copy.version <= since", "copy.version < since",
           "test_cli", "a page gets the means of the film, all bits of them, and each version once"),
    Mutant("copies are made though nobody asked since the last one", "cli/live/web_picture.cpp",
           "return picture_asked_ > shown_ && ", "return ",
           "test_cli", "copies are made for whoever asked since the last one, and for nobody else"),
    Mutant("each part of the light is the first one", "cli/live/live_layers.cpp",
           "return parts[layer.index];", "return parts[0];",
           "test_cli", "a page gets a layer's channels from the pass after it asked for them"),
    Mutant("a PFM stands on its head", "io/picture/plain_picture.cpp",
           "for (int y = image.height - 1; y >= 0; --y)\n    for (int x = 0; x < image.width; ++x)\n"
           "      for (",
           "for (int y = 0; y < image.height; ++y)\n    for (int x = 0; x < image.width; ++x)\n"
           "      for (",
           "test_cli", PFM),
    Mutant("a layer of one channel is saved as three", "cli/live/live_layers.cpp",
           "channels == 1 ? 1 : 3", "3", "test_cli", PFM),
    Mutant("any method will do", "cli/live/web_routes.cpp",
           "if (request.method == route->method)", "if (!request.method.empty())",
           "test_cli", REFUSED),
    Mutant("a render is stopped of which nothing is kept", "cli/live/web_picture.cpp",
           "  if (state_.partial.empty()) throw", "  if (false) throw",
           "test_cli", STOPS),
    Mutant("a render that time ended stays at the share that it had", "cli/live/web_state.cpp",
           "return state.is_complete ? 1 : shares.most();", "return shares.most();",
           "test_cli", "a page is told how far the render is"),
    Mutant("a page's state is asked for without a check of its host", "cli/live/web_server.cpp",
           "        access_.check(request);\n", "",
           "test_cli", "a page of another name for this machine is refused"),
]
