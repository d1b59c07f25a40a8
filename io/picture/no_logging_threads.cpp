// SPDX-License-Identifier: Apache-2.0
// Part of the library that loads OpenImageIO. Debian's and Ubuntu's loads OpenVDB, and that log4cplus, which
// starts a thread pool as it is loaded: where no thread can be made, it ends the program there. Nothing that
// is used here logs by it; a function of the library that loads it stands before its own of that name.
namespace log4cplus {
void initializeLog4cplus();
void initializeLog4cplus() {}
}  // namespace log4cplus
