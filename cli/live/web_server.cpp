// SPDX-License-Identifier: Apache-2.0
#include "cli/live/web_server.h"

#include <fmt/format.h>

#include <algorithm>
#include <thread>
#include <utility>

#include "cli/live/web_routes.h"

namespace twinray {
namespace {

constexpr std::chrono::seconds last_wait{1};

bool is_number(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

TcpListener listener_at(const NetworkAddress& address) {
  try {
    return TcpListener(address);
  } catch (const Error& error) {
    throw Error(fmt::format("--serve: cannot listen at {}: {}; --serve=0 takes any free port of this machine",
                            text_of(address), error.what()));
  }
}

}  // namespace

NetworkAddress parse_server_address(const std::string& text) {
  const NetworkAddress usual{"127.0.0.1", 8184};
  return parse_address(is_number(text) ? usual.host + ":" + text : text, usual, 0);
}

WebServer::WebServer(const NetworkAddress& address, const std::string& picture, const std::string& partial)
    : picture_(picture, partial),
      listener_(listener_at(address)),
      access_(http::Access::of(listener_)),
      server_(std::move(listener_), [this](const http::Request& request) {
        access_.check(request);
        return answer(request, picture_);
      }) {}

void WebServer::show_last(const RenderResult& result) {
  picture_.show_last(result);
  last_shown_ = std::chrono::steady_clock::now();
}

std::string WebServer::finish() {
  if (picture_.is_watched()) std::this_thread::sleep_until(last_shown_ + last_wait);
  return "";
}

}  // namespace twinray
