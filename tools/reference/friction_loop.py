# SPDX-License-Identifier: Apache-2.0
"""Friction of the coupled drive: width of the loop (TC-16, TC-33), loss while it runs (TC-34, TC-35).

Widths.  The first order in mu: the friction of each contact acts as a load on the drive in its state
without friction, H dx = -sum mu N sign(ds/dT) ds/dx, with the dense Hessian H of coupled_drive.py.
The rotation in dx is half of the width; reciprocity is not used.  `coulomb` rows contain the full
problem of one coefficient: equilibrium with closings along the normals and forces turned by friction,
which has no potential, by Newton's method on an unsymmetric matrix, once for rising and once for
falling torque.

Independent of the library: no condensation to the contacts, no reciprocity; the slip of the outer ring
in its bore is an integral by Gauss's rule from ball to ball instead of a sum over harmonics; the
balance of the outer ring is a minimum over its free rotation instead of a weighted median.

    friction_loop.py            JSON on stdout
    friction_loop.py --write    and tests/data/friction_loop.csv; 20 s
    friction_loop.py --makers   no-load, starting and back-driving torque and efficiency, with the
                                makers' values
"""
import sys
from math import cos, pi, sin

import numpy as np
from scipy.linalg import cho_solve

from coupled_drive import Coupled, typical

ARCMIN = pi / 180 / 60
MU, MU_OUTER, MU_ROLLING = 0.1, 0.1, 0.001


def free_rotation(slip, force):
    """The rotation of the outer ring, which makes the loss least; a kink of the loss is a ball."""
    at = slip[force > 0]
    return at[np.argmin([force @ np.abs(slip - c) for c in at])]


class Rubbing(Coupled):
    def __init__(self, drive):
        super().__init__(drive)
        alpha, teeth = drive["flank_angle"], self.teeth
        rows = self.flank_rows.copy()
        rows[:, self.rings:] = 0.0  # slip is the motion of the two rings, not of neighbouring teeth
        across = (rows[:teeth] - rows[teeth:]) / (2 * cos(alpha))
        up = (rows[:teeth] + rows[teeth:]) / (2 * sin(alpha))
        self.flank_slip = np.vstack((cos(alpha) * up - sin(alpha) * across,
                                     cos(alpha) * up + sin(alpha) * across))
        self.outer_slip = self.integrated_slip()

    def slip_growth(self, theta):
        """Growth of the slip between rim and outer ring per angle: stretch and bending."""
        n = self.n
        h = (self.g["rim_thickness"] + self.g["outer_race_thickness"]) / 2
        phase = np.outer(theta, n)
        stretch = self.rows(theta, a=np.cos(phase), b=np.sin(phase), c=-n * np.sin(phase),
                            d=n * np.cos(phase))
        bending = self.rows(theta, a=(1 - n ** 2) * np.cos(phase), b=(1 - n ** 2) * np.sin(phase))
        return stretch + h / self.R * bending  # a_0 turns the ring as a whole

    def ball_angles(self):
        return self.g["cage_phase"] + 2 * pi * np.arange(self.g["ball_count"]) / self.g["ball_count"]

    def integrated_slip(self):
        node, weight = np.polynomial.legendre.leggauss(24)
        psi = self.ball_angles()
        half = (psi[1] - psi[0]) / 2
        rows = [np.zeros(self.size)]
        for start in psi[:-1]:
            rows.append(rows[-1] + half * weight @ self.slip_growth(start + half * (1 + node)))
        return np.array(rows)

    def at(self, torque):
        if self.start is None:
            self.assemble()
        return self.solve(self.start.x, torque, self.amplitude) if torque else self.start

    def tangent(self, state):
        _, ball_rate, flank_rate, _ = self.gradient(state.x, 0.0, self.amplitude)
        factor = self.factor(ball_rate, flank_rate)
        unit = np.zeros(self.size)
        unit[1] = 1 / self.R
        return factor, cho_solve(factor, unit)

    def widths(self, torque):
        """Distance of the envelopes over mu, by the flanks and by the outer ring."""
        state = self.at(torque)
        factor, rate = self.tangent(state)
        flank = (state.flank_force * np.sign(self.flank_slip @ rate)) @ self.flank_slip
        slip = self.outer_slip @ rate
        free = free_rotation(slip, state.ball_force)
        force = state.ball_force * np.sign(slip - free)
        force[np.argmin(np.abs(slip - free))] = 0.0
        force[np.argmin(np.abs(slip - free))] = -force.sum()  # the ring has no other support
        return [2 * cho_solve(factor, load)[1] / self.R for load in (flank, force @ self.outer_slip)]

    def coulomb(self, torque, mu):
        """Distance of the envelopes with friction of the flanks, by two complete solutions."""
        state = self.at(torque)
        _, rate = self.tangent(state)
        return (self.turned(state, torque, mu, rate, -1) - self.turned(state, torque, mu, rate, 1)
                ) / self.R

    def turned(self, state, torque, mu, rate, sense):
        """c_0 while all flanks slip as under a torque that rises (+1) or falls (-1)."""
        turn = mu * sense * np.sign(self.flank_slip @ rate)[:, None] * self.flank_slip

        def equation(x):
            g, ball_rate, flank_rate, (Q, F, _) = self.gradient(x, torque, self.amplitude)
            return g + F @ turn, ball_rate, flank_rate, np.linalg.norm(Q) + np.linalg.norm(F)

        x = state.x.copy()
        left, ball_rate, flank_rate, scale = equation(x)
        for _ in range(100):
            if np.linalg.norm(left) <= 2e-12 * scale:
                break
            matrix = (self.K + (self.ball_rows.T * ball_rate) @ self.ball_rows
                      + ((self.flank_rows + turn).T * flank_rate) @ self.flank_rows)
            step, size = -np.linalg.solve(matrix, left), 1.0
            while size > 1e-4 and np.linalg.norm(equation(x + size * step)[0]) > np.linalg.norm(left):
                size /= 2
            x = x + size * step
            left, ball_rate, flank_rate, scale = equation(x)
        if np.linalg.norm(left) > 1e-9 * scale:
            raise ArithmeticError(f"no equilibrium with friction: {np.linalg.norm(left):.1e}")
        return x[1]

    def running(self, torque):
        """Input torque lost in balls, outer ring and flanks, over the coefficient of each."""
        g, state = self.g, self.at(torque)
        Q, turn = state.ball_force, 1 + 1 / g["ratio"]
        pitch = (g["inner_race_diameter"] + g["outer_race_diameter"]) / 4
        speed = self.slip_growth(self.ball_angles()) @ state.x
        free = free_rotation(speed, Q)
        m, w0, alpha = g["pitch_diameter"] / (2 * g["ratio"]), g["radial_displacement"], g["flank_angle"]

        def place(t):  # of the pitch point in the space of the circular spline (TC-7)
            return m * t - w0 / 2 * np.sin(2 * t), w0 * np.cos(2 * t)

        count = round(2 * g["ratio"])
        t = np.remainder((self.index + 0.5) * 2 * pi / count + pi / 2, pi) - pi / 2
        t = np.concatenate((t, -t))
        h = 1e-3
        slide = 0.0  # eighth order difference of the path along the flank
        for k, c in ((1, 4 / 5), (2, -1 / 5), (3, 4 / 105), (4, -1 / 280)):
            (x1, y1), (x0, y0) = place(t + k * h), place(t - k * h)
            slide = slide + c / h * ((y1 - y0) * cos(alpha) - (x1 - x0) * sin(alpha))
        return (turn * pitch * Q.sum(), turn * Q @ np.abs(speed - free),
                turn * state.flank_force @ np.abs(slide))

    def input_loss(self, torque):
        return sum(mu * part for mu, part in zip((MU_ROLLING, MU_OUTER, MU), self.running(torque)))

    def back_driving(self):
        torque = 0.0
        for _ in range(200):
            last, torque = torque, self.g["ratio"] * self.input_loss(torque)
            if abs(torque - last) < 1e-10 * torque:
                return torque
        raise ArithmeticError("the drive locks")


CASES = {"plain": {}, "pressed_1": dict(lobe_gap=-1e-6), "pressed_2": dict(lobe_gap=-2e-6),
         "pressed_5": dict(lobe_gap=-5e-6), "pressed_50": dict(lobe_gap=-50e-6),
         "half_free": dict(spline_support=0.5), "half_free_pressed_50": dict(
             spline_support=0.5, lobe_gap=-50e-6),
         "relieved_teeth": dict(spline_support=0.5, tooth="straight", tips="relieved")}


def tables(sizes=((25, 100), (25, 50), (14, 80), (50, 160))):
    from reference_csv import Table

    table = Table("friction_loop", "size [1]", "ratio [1]", "torque [N*m]")
    for size, ratio in sizes:
        for case, changes in CASES.items():
            model = Rubbing(typical(size, ratio, **changes))
            T1 = 51.7e3 * model.g["pitch_diameter"] ** 3
            pressed = changes.get("lobe_gap", 0) < 0
            for torque in (0.0 if pressed else T1 / 1000, T1, 187 / 51.7 * T1, -T1):
                inputs = (size, ratio, torque)
                for what, value in zip(("flanks", "outer_ring"), model.widths(torque)):
                    table.add(f"{case}.width_{what}", inputs, value, "rad", "load of friction",
                              digits=9, printed=12)
                for what, value in zip(("balls", "outer_ring", "flanks"), model.running(torque)):
                    table.add(f"{case}.running_{what}", inputs, value, "N*m", "path of slip",
                              digits=9, printed=12)
                if (size, ratio) == (25, 100) and torque >= 0:
                    table.add(f"{case}.coulomb", inputs, model.coulomb(torque, MU), "rad",
                              "unsymmetric Newton", digits=7, printed=12)
            if not pressed:
                table.add(f"{case}.back_driving", (size, ratio, 0.0), model.back_driving(), "N*m",
                          "fixed point", digits=9, printed=12)
    return [table]


def some_tables():
    """The same table for one drive."""
    return tables([(25, 100)])


MAKERS = {14: (10, 21, 35, 2.21, 67), 17: (31, 29, 51, 3.06, 77), 20: (52, 37, 105, 3.89, 77),
          25: (87, 69, 195, 7.26, 77)}  # T_N, starting, running at 2000 rpm [mN m], back-driving, %


def makers():
    for size in (14, 17, 20, 25, 40):
        for ratio in (50, 100):
            model = Rubbing(typical(size, ratio))
            none, back = model.input_loss(0.0), model.back_driving()
            parts = [1e3 * mu * p for mu, p in zip((MU_ROLLING, MU_OUTER, MU), model.running(0.0))]
            line = (f"{size:3} {ratio:4} no load {1e3 * none:6.2f} mN m (balls, outer ring, flanks "
                    f"{parts[0]:.2f} {parts[1]:.2f} {parts[2]:.2f}), back-driving {back:.3f} N m, over "
                    f"starting times ratio {back / none / ratio:.3f}")
            if ratio == 100 and size in MAKERS:
                rated, start, run, drive, percent = MAKERS[size]
                input_torque = rated / ratio
                eta = input_torque / (input_torque + model.input_loss(rated) + run / 1e3 - none)
                line += (f"; maker: {start}, {run} mN m, {drive} N m, {drive / start / ratio * 1e3:.3f}"
                         f"; efficiency with the rest of the maker's no-load torque {100 * eta:.1f}, "
                         f"stated {percent} %")
            print(line)


def main():
    if "--makers" in sys.argv[1:]:
        makers()
        return
    from reference_csv import publish

    publish(*tables())


if __name__ == "__main__":
    main()
