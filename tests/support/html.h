// SPDX-License-Identifier: Apache-2.0
// What a page must keep to.
#pragma once
#include <string>

namespace twinray::test {

/// The first fault of an HTML page's form: an element that is not closed, or closed out of order; "" for
/// none.
std::string html_fault(const std::string& page);

/// The first thing that a page would load from elsewhere: an attribute or a style's address; "" for none.
/// Data that stands in the page and links within it are not loaded.
std::string html_load(const std::string& page);

/// How often a text occurs.
std::size_t count(const std::string& text, const std::string& part);

}  // namespace twinray::test
