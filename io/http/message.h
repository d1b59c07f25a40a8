// SPDX-License-Identifier: Apache-2.0
// Requests and responses of HTTP/1.1 (RFC 9112), as far as a server of small requests needs them.
#pragma once
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.h"

namespace twinray::http {

/// What a request cannot have, as a response says it: its status and a sentence.
class Refusal : public Error {
 public:
  Refusal(int status, const std::string& text) : Error(text), status_(status) {}
  int status() const { return status_; }

 private:
  int status_;
};

/// A request has so many bytes at most, up to the empty line.
inline constexpr std::size_t most_request_bytes = 8192;

struct Request {
  std::string method;                         ///< "GET", ...
  std::string path;                           ///< "/state"; begins with a slash.
  std::map<std::string, std::string> query;   ///< What stands behind the "?"; of equal names the last counts.
  std::map<std::string, std::string> fields;  ///< By names in lower case.

  /// A field's value; empty where there is none.
  const std::string& field(const std::string& name) const;
};

/// A request without a body, from its text up to the empty line. Throws Refusal.
Request parse_request(std::string_view text);

struct Response {
  int status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::shared_ptr<const std::string> body;  ///< Null: none. Several responses may share one.
  std::vector<std::pair<std::string, std::string>> fields = {};  ///< Besides those that say what the body is.
};

/// A response that is a line of text.
Response text_response(int status, const std::string& text);

/// What goes before the body. The connection ends with it, nothing may be stored, and nothing else may be
/// made of it than it says.
std::string head_of(const Response& response);

}  // namespace twinray::http
