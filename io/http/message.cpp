// SPDX-License-Identifier: Apache-2.0
#include "io/http/message.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "io/uri.h"

namespace twinray::http {
namespace {

constexpr std::array<std::pair<int, const char*>, 12> statuses{{{200, "OK"},
                                                                {204, "No Content"},
                                                                {400, "Bad Request"},
                                                                {403, "Forbidden"},
                                                                {404, "Not Found"},
                                                                {405, "Method Not Allowed"},
                                                                {409, "Conflict"},
                                                                {413, "Content Too Large"},
                                                                {414, "URI Too Long"},
                                                                {431, "Request Header Fields Too Large"},
                                                                {500, "Internal Server Error"},
                                                                {505, "HTTP Version Not Supported"}}};

const char* name_of(int status) {
  const auto found = std::find_if(statuses.begin(), statuses.end(),
                                  [status](const auto& entry) { return entry.first == status; });
  return found == statuses.end() ? "" : found->second;
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// What names of fields are made of (RFC 9110, section 5.6.2).
bool is_token(std::string_view word) {
  constexpr std::string_view others = "!#$%&'*+-.^_`|~0123456789";
  return !word.empty() && std::all_of(word.begin(), word.end(), [others](char c) {
    return is_letter(c) || others.find(c) != others.npos;
  });
}

std::string lower_case(std::string_view word) {
  std::string lower(word);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return lower;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  return begin == text.npos ? std::string_view()
                            : text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
}

/// Takes the text up to a separator, and the separator; all where there is none.
std::string_view take(std::string_view& text, std::string_view separator) {
  const std::size_t end = std::min(text.find(separator), text.size());
  const std::string_view taken = text.substr(0, end);
  text.remove_prefix(std::min(end + separator.size(), text.size()));
  return taken;
}

std::map<std::string, std::string> parse_query(std::string_view text) {
  std::map<std::string, std::string> query;
  while (!text.empty()) {
    std::string_view value = take(text, "&");
    const std::string name = decoded_uri(take(value, "="));
    query[name] = decoded_uri(value);
  }
  return query;
}

/// "GET /state?a=b HTTP/1.1"
Request parse_first_line(std::string_view line) {
  const std::string_view method = take(line, " ");
  std::string_view target = take(line, " ");
  if (!is_token(method) || !target.starts_with('/') ||
      !std::all_of(target.begin(), target.end(), [](char c) { return c > ' ' && c < 127; }))
    throw Refusal(400, "A request begins with a line like \"GET / HTTP/1.1\".");
  if (line != "HTTP/1.1" && line != "HTTP/1.0") throw Refusal(505, "Valid are HTTP/1.1 and HTTP/1.0.");
  Request request;
  request.method = method;
  request.path = take(target, "?");
  request.query = parse_query(target);
  return request;
}

void add_field(std::string_view line, Request& request) {
  const std::string_view name = take(line, ":");
  if (!is_token(name)) throw Refusal(400, "The fields of a request are lines like \"Host: localhost\".");
  if (!request.fields.emplace(lower_case(name), trimmed(line)).second && lower_case(name) == "host")
    throw Refusal(400, "A request has one field Host.");
}

}  // namespace

const std::string& Request::field(const std::string& name) const {
  static const std::string none;
  const auto found = fields.find(name);
  return found == fields.end() ? none : found->second;
}

Request parse_request(std::string_view text) {
  Request request = parse_first_line(take(text, "\r\n"));
  while (!text.empty()) add_field(take(text, "\r\n"), request);
  const std::string& length = request.field("content-length");
  if ((!length.empty() && length != "0") || !request.field("transfer-encoding").empty())
    throw Refusal(413, "Requests have no body here.");
  return request;
}

Response text_response(int status, const std::string& text) {
  return {.status = status, .body = std::make_shared<const std::string>(text + "\n")};
}

std::string head_of(const Response& response) {
  std::string head = fmt::format("HTTP/1.1 {} {}\r\n", response.status, name_of(response.status));
  if (response.body)
    head += fmt::format("Content-Type: {}\r\nContent-Length: {}\r\n", response.type, response.body->size());
  for (const auto& [name, value] : response.fields) head += fmt::format("{}: {}\r\n", name, value);
  return head +
         "Connection: close\r\nCache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\n"
         "Cross-Origin-Resource-Policy: same-origin\r\nReferrer-Policy: no-referrer\r\n\r\n";
}

}  // namespace twinray::http
