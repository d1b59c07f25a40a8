// SPDX-License-Identifier: Apache-2.0
// A server of HTTP, whatever those do who connect to it.
#include <fmt/format.h>

#include <list>
#include <set>

#include "io/http/access.h"
#include "io/http/server.h"
#include "tests/support/catch.h"
#include "tests/support/http_client.h"

namespace twinray::test {
namespace {

using http::Access;
using http::Refusal;
using http::Request;
using http::Response;

constexpr std::size_t large_body = std::size_t(64) << 20;

/// "/" is a word, "/large" more than a system keeps for a reader, all else is not there.
Response answer(const Request& request) {
  if (request.path == "/") return http::text_response(200, request.method + " of " + request.query.at("who"));
  if (request.path == "/broken") throw std::runtime_error("it broke");
  if (request.path != "/large") throw Refusal(404, "There is / and /large.");
  static const auto body = std::make_shared<const std::string>(large_body, 'x');
  return {.type = "application/octet-stream", .body = body, .fields = {{"Version", "3"}}};
}

class TestServer {
 public:
  std::uint16_t port() const { return port_; }

 private:
  TcpListener listener_{{"127.0.0.1", 0}};
  const std::uint16_t port_ = listener_.address().port;
  http::Server server_{std::move(listener_), answer};
};

/// What a server says to a request of just these bytes.
HttpAnswer answer_to(const std::string& text) {
  const TestServer server;
  HttpClient client(server.port());
  client.send(text);
  return client.answer();
}

int status_of(const std::string& text) { return answer_to(text).status; }

std::string refusal_of(const Access& access, const Request& request) {
  try {
    access.check(request);
    return "";
  } catch (const Refusal& refusal) {
    CHECK(refusal.status() == 403);
    return refusal.what();
  }
}

Request from_host(const std::string& host) { return {"GET", "/", {}, {{"host", host}}}; }

Request with_token(const std::string& token) {
  return {"GET", "/", {{"token", token}}, {{"host", "desk.example:80"}}};
}

}  // namespace

TEST_CASE("a request is answered with its body, what that is, and what may be made of it") {
  const TestServer server;
  const HttpAnswer text = get(server.port(), "/?a=1&who=me%20%26%20you&");
  CHECK(text.status == 200);
  CHECK(text.body == "GET of me & you\n");
  CHECK(text.field("Content-Type") == "text/plain; charset=utf-8");
  CHECK(text.field("Content-Length") == "16");
  CHECK(text.field("Cache-Control") == "no-store");
  CHECK(text.field("X-Content-Type-Options") == "nosniff");
  CHECK(text.field("Referrer-Policy") == "no-referrer");
  const HttpAnswer large = get(server.port(), "/large");
  CHECK((large.body == std::string(large_body, 'x')));  // not shown where it is wrong
  CHECK(large.field("Version") == "3");
}

TEST_CASE("HEAD is answered as GET is, without the body") {
  const TestServer server;
  const HttpAnswer head = ask(server.port(), "HEAD", "/?who=me");
  CHECK(head.status == 200);
  CHECK(head.body.empty());
  CHECK(head.field("Content-Length") == "10");
  CHECK(ask(server.port(), "HEAD", "/none").status == 404);
  CHECK(ask(server.port(), "HEAD", "/none").body.empty());
}

TEST_CASE("what is refused, and what breaks, is answered with the reason") {
  const TestServer server;
  const HttpAnswer missing = get(server.port(), "/../etc/passwd");
  CHECK(missing.status == 404);
  CHECK(missing.body == "There is / and /large.\n");
  const HttpAnswer broken = get(server.port(), "/broken");
  CHECK(broken.status == 500);
  CHECK(broken.body == "it broke\n");
  CHECK(get(server.port(), "/?who=me").status == 200);
}

TEST_CASE("what is no request of HTTP is refused") {
  for (const std::string text :
       {"hello\r\n\r\n", "GET\r\n\r\n", "GET  HTTP/1.1\r\n\r\n", "GET http://a/ HTTP/1.1\r\n\r\n",
        "G(T / HTTP/1.1\r\n\r\n", "GET /\x80 HTTP/1.1\r\n\r\n", "GET / HTTP/1.1\r\nHost : a\r\n\r\n",
        "GET / HTTP/1.1\r\n: a\r\n\r\n", "GET / HTTP/1.1\r\nHost: a\r\n folded\r\n\r\n",
        "GET / HTTP/1.1\r\nHost: a\r\nhost: b\r\n\r\n"}) {
    CAPTURE(text);
    CHECK(status_of(text) == 400);
  }
  CHECK(status_of("GET / HTTP/2.0\r\n\r\n") == 505);
  CHECK(status_of("GET / HTTP/1.1 x\r\n\r\n") == 505);
  CHECK(status_of("GET /?who=a HTTP/1.0\r\nContent-Length: 0\r\n\r\n") == 200);
  CHECK(status_of("GET / HTTP/1.1\r\nContent-Length: 7\r\n\r\nmore...") == 413);
  CHECK(status_of("GET / HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n") == 413);
}

TEST_CASE("a request has so many bytes and no more") {
  const auto request = [](std::size_t more) { return "GET /" + std::string(more, 'a') + " HTTP/1.1"; };
  const std::size_t rest = request(0).size();
  CHECK(status_of(request(http::most_request_bytes - rest) + "\r\n\r\n") == 404);
  CHECK(status_of(request(http::most_request_bytes - rest + 1) + "\r\n\r\n") == 414);
  CHECK(status_of(request(1'000'000)) == 414);
  const HttpAnswer many = answer_to("GET / HTTP/1.1\r\n" + std::string(10'000, 'a'));
  CHECK(many.status == 431);
  CHECK(many.body == "A request has 8192 bytes at most.\n");
}

TEST_CASE("whoever is silent or does not read holds nobody up, nor the end") {
  std::list<HttpClient> rude;
  {
    const TestServer server;
    for (int i = 0; i < 25; ++i) {
      rude.emplace_back(server.port()).send(i % 2 == 0 ? "" : "GET /lar");
      rude.emplace_back(server.port(), 4096).send("GET /large HTTP/1.1\r\n\r\n");
      CHECK(rude.back().receive(15) == "HTTP/1.1 200 OK");
    }
    CHECK(get(server.port(), "/?who=me").body == "GET of me\n");
    CHECK(get(server.port(), "/large").body.size() == large_body);
  }
  // The server has gone, though they are still there.
  CHECK(rude.front().answer().status == 0);
  CHECK(rude.back().receive(large_body).size() < large_body);
}

TEST_CASE("a request that does not end is not waited for, though its bytes drip") {
  const TestServer server;
  HttpClient silent(server.port()), dripping(server.port());
  for (int i = 0; i < 100; ++i) dripping.send("a");
  CHECK(silent.answer().status == 0);
  CHECK(dripping.answer().status == 0);
}

TEST_CASE("beyond so many connections the oldest one makes room") {
  const TestServer server;
  HttpClient oldest(server.port());
  std::list<HttpClient> others;
  for (std::size_t i = 0; i < http::Server::most_connections; ++i) others.emplace_back(server.port());
  CHECK(oldest.answer().status == 0);
  others.back().send("GET /?who=me HTTP/1.1\r\n\r\n");
  CHECK(others.back().answer().body == "GET of me\n");
}

TEST_CASE("beyond so many bytes that wait for readers the oldest reader makes room") {
  const TestServer server;
  std::list<HttpClient> readers;
  for (std::size_t kept = 0; kept <= http::Server::most_kept_bytes; kept += large_body) {
    readers.emplace_back(server.port(), 4096).send("GET /large HTTP/1.1\r\n\r\n");
    CHECK(readers.back().receive(15) == "HTTP/1.1 200 OK");
  }
  CHECK(get(server.port(), "/?who=me").status == 200);
  CHECK(readers.front().receive(large_body).size() < large_body);
  CHECK(readers.back().receive(large_body).size() == large_body);
}

TEST_CASE("a port that is taken, or a host that is none, is an error with the system's reason") {
  const TcpListener listener({"127.0.0.1", 0});
  CHECK(listener.is_local());
  CHECK_FALSE(TcpListener({"0.0.0.0", 0}).is_local());
  CHECK_THROWS_WITH(TcpListener(listener.address()), "Address already in use");
  CHECK_THROWS_AS(TcpListener({"no such host", 80}), Error);
}

TEST_CASE("a server of this machine alone answers to names of this machine alone") {
  const Access access({"127.0.0.1", 8184}, "");
  CHECK(access.page_address() == "http://127.0.0.1:8184/");
  for (const std::string host :
       {"127.0.0.1:8184", "localhost:8184", "localhost", "localhost:9000", "[::1]:8184"})
    CHECK(refusal_of(access, from_host(host)).empty());
  for (const std::string host : {"", "evil.example", "evil.example:8184", "localhost.evil.example:8184",
                                 "127.0.0.1.evil.example", "[::1].evil.example", "[::2]:8184"}) {
    CAPTURE(host);
    CHECK(refusal_of(access, from_host(host)) == "This server is asked as http://127.0.0.1:8184/ alone.");
  }
}

TEST_CASE("a server for other machines answers to its token alone, and each has its own") {
  const Access access({"desk.example", 80}, "5ecre7");
  CHECK(access.page_address() == "http://desk.example:80/?token=5ecre7");
  CHECK(refusal_of(access, with_token("5ecre7")).empty());
  for (const std::string token : {"", "5ecre", "5ecre8", "6ecre7", "5ecre7x"}) {
    CAPTURE(token);
    CHECK(refusal_of(access, with_token(token)) ==
          "The token is missing or wrong: the program prints the address with it.");
  }
  CHECK_FALSE(refusal_of(access, from_host("desk.example:80")).empty());
  std::set<std::string> tokens;
  for (int i = 0; i < 100; ++i) tokens.insert(http::random_token());
  CHECK(tokens.size() == 100);
  CHECK(tokens.begin()->size() == 32);
  CHECK(Access::of(TcpListener({"127.0.0.1", 0})).page_address().find("token") == std::string::npos);
  CHECK(Access::of(TcpListener({"0.0.0.0", 0})).page_address().find("/?token=") != std::string::npos);
}

TEST_CASE("what changes something is asked for by a page of the server itself") {
  for (const bool needs_token : {false, true}) {
    const Access access({"127.0.0.1", 8184}, needs_token ? "5ecre7" : "");
    Request request{"POST", "/stop", {{"token", "5ecre7"}}, {{"host", "localhost:8184"}}};
    const std::string refused =
        "Only a page of this server may do that: the field Origin says which one asks.";
    CHECK(refusal_of(access, request) == refused);
    for (const std::string origin :
         {"null", "http://evil.example", "https://localhost:8184", "http://localhost:80"}) {
      request.fields["origin"] = origin;
      CHECK(refusal_of(access, request) == refused);
    }
    request.fields["origin"] = "http://localhost:8184";
    CHECK(refusal_of(access, request).empty());
  }
  // No page answers to these: that is what they are to be told.
  const Access access({"127.0.0.1", 8184}, "");
  for (const std::string method : {"PUT", "OPTIONS", "DELETE"})
    CHECK(refusal_of(access, {method, "/stop", {}, {{"host", "localhost:8184"}}}).empty());
}

}  // namespace twinray::test
