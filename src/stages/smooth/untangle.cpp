// Untangling after [Garanzha2021]: an energy with a barrier that is finite for inverted corners, minimised while the
// barrier hardens. We differ: node by node instead of all at once; first on the tangled stars alone, then on growing
// patches round those that are left. Before, the nodes of tangled stars go to the centroids of their neighbours,
// whatever that does: it brings them back from far away.
#include "stages/smooth/relax.hpp"
#include "stages/smooth/shape_energy.hpp"
#include "stages/smooth/steps.hpp"

namespace quadline::smoothing {

namespace {

constexpr double kTangled2 = kBrokenJacobian * kBrokenJacobian;  // squared sine below which a star is tangled
constexpr int kRounds = 3, kRingsPerRound = 2, kLaplacePasses = 10, kPasses = 5;
constexpr double kSoft = 1, kHard = 0.01, kHardening = 0.5;  // epsilon of the barrier: first, last, factor

class Untangler {
 public:
  Untangler(Stars& stars, double min_move, const Progress& progress)
      : stars_(stars), min_move_(min_move), progress_(progress) {}

  void run() {
    for (std::size_t i = 0; i < stars_.count(); ++i)
      if (sine2(i) < kTangled2) near_.push_back(static_cast<std::uint32_t>(i));
    if (near_.empty()) return;
    centre();
    std::size_t n_left = near_.size() + 1;
    for (int round = 0; round < kRounds; ++round) {
      const std::size_t n = round_of(round);
      if (n == 0 || n >= n_left) return;
      n_left = n;
      grow_near();
    }
  }

 private:
  double sine2(std::size_t i) {
    star_.gather(stars_, i);
    return star_.least_sine2({});
  }

  void centre() {
    for (const std::uint32_t i : near_) stars_.wake(i);
    for (int pass = 0; pass < kLaplacePasses; ++pass) {
      for (const std::uint32_t i : stars_.take_awake()) {
        if (sine2(i) > 0) continue;
        stars_.move(i, stars_.at(i) + stars_.size(i) * star_.centroid());
        stars_.wake_around(i);
      }
    }
    stars_.take_awake();
    grow_near();
  }

  // Returns how many stars are tangled after it.
  std::size_t round_of(int round) {
    const double done = static_cast<double>(round) / kRounds;
    const Progress part = progress_.part(done, done);  // most rounds are not needed
    for (double epsilon = kSoft; epsilon > kHard; epsilon *= kHardening) {
      if (wake_tangled() == 0) return 0;
      for (int ring = 0; ring < round * kRingsPerRound; ++ring) grow_awake();
      const double below = round == 0 ? kTangled2 : HUGE_VAL;
      relax(stars_, BarrierEnergy(epsilon, below), {.passes = kPasses, .min_move = min_move_}, part);
      stars_.take_awake();
    }
    const std::size_t n = wake_tangled();
    stars_.take_awake();
    return n;
  }

  std::size_t wake_tangled() {
    std::size_t n = 0;
    for (const std::uint32_t i : near_) {
      if (sine2(i) >= kTangled2) continue;
      stars_.wake(i);
      ++n;
    }
    return n;
  }
  void grow_awake() {
    const std::span<const std::uint32_t> awake = stars_.take_awake();
    for (const std::uint32_t i : awake) stars_.wake_around(i);
  }
  // What a round may have reached.
  void grow_near() {
    for (const std::uint32_t i : near_) stars_.wake(i);
    for (int ring = 0; ring < kRingsPerRound; ++ring) grow_awake();
    const std::span<const std::uint32_t> awake = stars_.take_awake();
    near_.assign(awake.begin(), awake.end());
  }

  Stars& stars_;
  double min_move_;
  const Progress& progress_;
  Star star_;
  std::vector<std::uint32_t> near_;  // stars that are or were tangled, and those round them
};

}  // namespace

void untangle(Stars& stars, const SmoothOptions& options, const Progress& progress) {
  Untangler(stars, options.min_move, progress).run();
}

}  // namespace quadline::smoothing
