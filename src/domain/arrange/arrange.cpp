// Turns a model into a planar arrangement, step by step; each step has a file of its own.
#include "domain/arrange/arrange.hpp"

#include "domain/arrange/work.hpp"

namespace quadline {

Domain arrange(const Model& model, const Options& options, Context& context) {
  context.progress("arrange", 0.0);
  arrangement::Work work = arrangement::read_input(model, options);
  arrangement::add_rings(work, options);
  arrangement::resolve(work, context);
  context.progress("arrange", 0.7);
  arrangement::Subdivision parts = arrangement::subdivide(work);
  arrangement::classify(work, parts);
  context.progress("arrange", 0.9);
  Domain domain = arrangement::to_domain(work, parts);
  arrangement::report_near_misses(domain, options, domain.findings);
  context.progress("arrange", 1.0);
  return domain;
}

}  // namespace quadline
