// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "cli/live/web_picture.h"
#include "io/http/message.h"

namespace twinray {

/// Answers what a page, or a program in its place, asks of a picture (docs/viewer.md). Throws http::Refusal.
http::Response answer(const http::Request& request, WebPicture& picture);

}  // namespace twinray
