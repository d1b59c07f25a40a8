// SPDX-License-Identifier: Apache-2.0
// Compiled once for the compact tree, and out of line: counting must not make the queries that do not
// count any slower.
#include "accel/compact/node.h"
#include "accel/wide/inspection.h"
#include "accel/wide/scalar_query.h"
#include "accel/wide/survey.h"

namespace twinray {

template Hit scalar_closest(const CompactBvh&, const Geometry&, const Ray&, QueryCounts&);
template bool scalar_any(const CompactBvh&, const Geometry&, const Ray&, QueryCounts&);
template std::string find_fault(const CompactBvh&, const Geometry&, Occurrence);
template TreeStats statistics_of(const CompactBvh&, const Geometry&, const BuildOptions&);

}  // namespace twinray
