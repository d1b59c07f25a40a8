// SPDX-License-Identifier: Apache-2.0
#include "cli/live/picture_viewers.h"

#include <utility>

#include "cli/console.h"
#include "cli/live/tev_window.h"
#include "cli/live/web_server.h"

namespace twinray {

std::vector<std::unique_ptr<PictureViewer>> picture_viewers(const RenderArguments& arguments,
                                                            const RenderOutputs& outputs,
                                                            const RenderOutputs& partial) {
  std::vector<std::unique_ptr<PictureViewer>> viewers;
  if (arguments.server) {
    auto server = std::make_unique<WebServer>(*arguments.server, outputs.picture, partial.picture);
    // With --quiet, too: nothing else says the port that was free, or the token.
    console::print_error("Picture at     {}\n", server->page_address());
    viewers.push_back(std::move(server));
  }
  if (arguments.viewer) viewers.push_back(std::make_unique<TevWindow>(*arguments.viewer, outputs.picture));
  return viewers;
}

}  // namespace twinray
