// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <string>

#include "cli/live/picture_viewer.h"
#include "cli/live/web_picture.h"
#include "io/http/access.h"
#include "io/http/server.h"

namespace twinray {

/// Where --serve listens: a port of this machine, 8184, or what the text says otherwise: "PORT", or as
/// parse_address(). Throws Error.
NetworkAddress parse_server_address(const std::string& text);

/// --serve: pages in browsers.
class WebServer final : public PictureViewer {
 public:
  /// Serves from now on. The names are those of WebState. Throws Error where it cannot listen.
  WebServer(const NetworkAddress& address, const std::string& picture, const std::string& partial);

  /// Where people find the page.
  std::string page_address() const { return access_.page_address(); }

  void begin(const RenderOptions& options, const Scene& scene, const std::vector<LiveLayer>& more) override {
    picture_.begin(options, scene, more);
  }
  void progress(const RenderProgress& progress) override { picture_.progress(progress); }
  bool is_ready() const override { return picture_.is_awaited(); }
  void show(const Film& film) override { picture_.show(film); }
  bool needs_film() const override { return picture_.needs_film(); }
  void show_tile(const Film& film, const PixelRect& tile) override { picture_.show_tile(film, tile); }
  void show_last(const RenderResult& result) override;
  std::string finish() override;
  bool asks_to_stop() const override { return picture_.is_stopping(); }

 private:
  std::chrono::steady_clock::time_point last_shown_;
  WebPicture picture_;
  TcpListener listener_;
  http::Access access_;
  http::Server server_;
};

}  // namespace twinray
