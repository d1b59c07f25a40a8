// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace twinray {

/// The page that shows a picture as it grows: page.html with its style and its script, whole by itself.
const char* live_page();

}  // namespace twinray
