// SPDX-License-Identifier: Apache-2.0
// OpenImageIO of Debian and Ubuntu loads OpenVDB, and that log4cplus, whose initialiser starts a thread pool
// before main: where no thread can be made, it ends the program there. Nothing that is used here logs by it;
// the program's function of that name stands before the library's.
namespace log4cplus {
void initializeLog4cplus();
void initializeLog4cplus() {}
}  // namespace log4cplus
