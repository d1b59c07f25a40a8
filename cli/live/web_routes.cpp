// SPDX-License-Identifier: Apache-2.0
#include "cli/live/web_routes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include "cli/live/page/page.h"

namespace twinray {
namespace {

using http::Refusal;
using http::Request;
using http::Response;

/// The page may do what it does and nothing else, nor stand in another one.
constexpr const char* page_policy =
    "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; connect-src 'self'; "
    "img-src data:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

Response page(const Request&, WebPicture&) {
  static const auto body = std::make_shared<const std::string>(live_page());
  return {.type = "text/html; charset=utf-8",
          .body = body,
          .fields = {{"Content-Security-Policy", page_policy}, {"X-Frame-Options", "DENY"}}};
}

Response state(const Request&, WebPicture& picture) {
  return {.type = "application/json",
          .body = std::make_shared<const std::string>(state_json(picture.state()) + "\n")};
}

/// The layer that is asked for; the colours, if none is.
std::size_t layer_of(const Request& request, WebPicture& picture) {
  const auto found = request.query.find("layer");
  if (found == request.query.end()) return 0;
  if (const auto layer = picture.layer_number(found->second)) return *layer;
  std::vector<std::string> names;
  for (const LiveLayer& layer : picture.state().layers) names.push_back(layer.name);
  throw Refusal(
      400, fmt::format("There is no layer \"{}\"; valid are {}.", found->second, fmt::join(names, ", ")));
}

std::optional<std::uint64_t> since_of(const Request& request) {
  const auto found = request.query.find("since");
  if (found == request.query.end()) return std::nullopt;
  std::uint64_t version = 0;
  const char* const last = found->second.data() + found->second.size();
  const auto [end, error] = std::from_chars(found->second.data(), last, version);
  if (error != std::errc{} || end != last)
    throw Refusal(
        400, fmt::format("since: \"{}\" is no version; valid are whole numbers from 0 on.", found->second));
  return version;
}

/// The picture, or those of its tiles that changed.
Response values(const Request& request, WebPicture& picture) {
  const std::optional<std::uint64_t> since = since_of(request);
  const auto image = picture.look_at(layer_of(request, picture));
  if (!image || image->version() <= since.value_or(0)) return {.status = 204};
  LiveBytes found = since ? image->changed_since(*since) : image->all();
  return {.type = "application/octet-stream",
          .body = std::make_shared<const std::string>(std::move(found.bytes)),
          .fields = {{"Picture-Version", std::to_string(found.version)},
                     {"Picture-Width", std::to_string(image->width())},
                     {"Picture-Height", std::to_string(image->height())},
                     {"Picture-Tiles", std::to_string(found.tiles)}}};
}

Response pfm(const Request& request, WebPicture& picture) {
  const std::size_t layer = layer_of(request, picture);
  const auto image = picture.look_at(layer);
  if (!image || image->version() == 0)
    throw Refusal(404, "There is no picture yet: this layer comes in a moment.");
  return {
      .type = "image/x-portable-floatmap",
      .body = std::make_shared<const std::string>(pfm_of(image->all().bytes, image->width(), image->height(),
                                                         picture.state().layers[layer].channels.size())),
      .fields = {{"Content-Disposition", "attachment; filename=\"picture.pfm\""}}};
}

Response stop(const Request&, WebPicture& picture) {
  try {
    picture.stop();
  } catch (const Error& error) {
    throw Refusal(409, error.what());
  }
  return {.status = 204};
}

struct Route {
  const char *path, *method;
  Response (*answer)(const Request&, WebPicture&);
};
constexpr Route routes[]{{"/", "GET", page},
                         {"/state", "GET", state},
                         {"/picture", "GET", values},
                         {"/picture.pfm", "GET", pfm},
                         {"/stop", "POST", stop}};

}  // namespace

Response answer(const Request& request, WebPicture& picture) {
  const auto* const route = std::find_if(std::begin(routes), std::end(routes),
                                         [&](const Route& one) { return request.path == one.path; });
  if (route == std::end(routes))
    throw Refusal(404, "There is no such page; valid are /, /state, /picture, /picture.pfm and /stop.");
  if (request.method == route->method) return route->answer(request, picture);
  Response refused = http::text_response(405, fmt::format("{} takes {} alone.", route->path, route->method));
  refused.fields = {{"Allow", route->method}};
  return refused;
}

}  // namespace twinray
