"""The deflection of a simply supported stiffened plate against the series solution."""
import unittest

import numpy as np

from calculix import ExampleTest


def deflection(a, b, thickness, young, nu, pressure, stiffeners, bending, twisting, x, y):
    """Deflection at (x, y) of a plate a x b, simply supported along its edges, with stiffeners along x at the heights
    `stiffeners`, of bending stiffness `bending` (E I) and torsional stiffness `twisting`, under uniform pressure.

    Navier's double sine series for the plate; the energy of the stiffeners couples the terms across y (Timoshenko and
    Woinowsky-Krieger, Theory of Plates and Shells, 2nd ed., sections 28 and 92; exact as the series goes on).
    """
    plate = young * thickness**3 / (12 * (1 - nu**2))
    n = np.arange(1, 301)
    beta = n * np.pi / b
    total = 0.0
    for m in range(1, 60, 2):
        alpha = m * np.pi / a
        stiffness = np.diag(plate * (alpha**2 + beta**2)**2 * b / 2)
        for at in stiffeners:
            shape, slope = np.sin(beta * at), beta * np.cos(beta * at)
            stiffness += bending * alpha**4 * np.outer(shape, shape) + twisting * alpha**2 * np.outer(slope, slope)
        load = 4 * pressure / (m * np.pi) * (1 - np.cos(n * np.pi)) / beta
        total += np.linalg.solve(stiffness, load) @ np.sin(beta * y) * np.sin(alpha * x)
    return total


class SeriesSolution(unittest.TestCase):
    def test_is_timoshenkos_for_a_square_plate_without_stiffeners(self):
        plate = 210000.0 * 10**3 / (12 * 0.91)
        w = deflection(1000, 1000, 10, 210000.0, 0.3, 0.01, [], 0, 0, 500, 500)
        self.assertAlmostEqual(w / (0.01 * 1000**4 / plate), 0.00406, delta=0.000005)


class StiffenedPlate(ExampleTest):
    name = "stiffened-plate"

    def test_deflection_of_the_middle(self):
        young, side = 210000.0, 30.0
        inertia = side**4 / 12
        # CalculiX blocks the warping of beams: their torsion constant is the polar moment; Poisson's ratio is 0.
        twisting = young / 2 * 2 * inertia
        theory = deflection(1200, 900, 10, young, 0.3, 0.01, [225, 450, 675], young * inertia, twisting, 600, 450)
        found = self.printed("displacements", "middle")[3]
        print("\nstiffened plate: deflection %.4f mm, theory %.4f mm: %+.2f %%"
              % (found, theory, 100 * (found / theory - 1)))
        self.assertAlmostEqual(found / theory, 1.0, delta=0.005)


if __name__ == "__main__":
    unittest.main()
