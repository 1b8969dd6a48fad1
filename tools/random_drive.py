#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws drives over all members, kinds of cracks and options of the input format.

    tools/random_drive.py SEED      prints the drive of that seed

The proportions are those of real drives, so the program accepts most of the drives.  The ranges
deliberately contain some drives that it must refuse, because the messages are tested too.
"""

import random
import sys

LIBRARY = ["52100 hardened", "17-4PH H900", "C45 QT to 16 mm", "4340 tempered 425 C"]


class Drive:
    def __init__(self, seed):
        self.random = random.Random(seed)
        self.lines = []
        self.d = self.uniform(0.03, 0.16)  # pitch diameter [m]
        self.ratio = self.random.choice([50, 80, 100, 120, 160])

    def uniform(self, low, high):
        return self.random.uniform(low, high)

    def chance(self, share):
        return self.random.random() < share

    def put(self, key, value, unit=None):
        """Writes a field; a length gets one of three units."""
        if unit == "m":
            name, factor = self.random.choice([("mm", 1e3), ("m", 1.0), ("um", 1e6)])
            self.lines.append(f'{key} = "{value * factor:.7g} {name}"')
        elif unit:
            self.lines.append(f'{key} = "{value:.7g} {unit}"')
        elif isinstance(value, bool):
            self.lines.append(f"{key} = {str(value).lower()}")
        elif isinstance(value, str):
            self.lines.append(f'{key} = "{value}"')
        else:
            self.lines.append(f"{key} = {value:.7g}" if isinstance(value, float) else f"{key} = {value}")

    def maybe(self, share, key, low, high, unit=None):
        if self.chance(share):
            self.put(key, self.uniform(low, high), unit)

    def table(self, name):
        self.lines.append(f"\n[{name}]")

    def crack(self, member, kind):
        self.lines.append(f"\n[[{member}.crack]]")
        self.put("kind", kind)

    def position(self):
        self.maybe(0.7, "position", -180, 180, "deg")

    def material(self):
        if self.chance(0.3):
            return self.random.choice(LIBRARY)
        return self.random.choice(self.steels)

    def materials(self):
        self.steels = ["steel", "tough steel"][: self.random.choice([1, 2])]
        for name in self.steels:
            self.table(f'material."{name}"')
            self.put("youngs_modulus", self.uniform(190, 215), "GPa")
            given = self.random.choice(["nu", "G", "both"])
            if given != "G":
                self.put("poissons_ratio", self.uniform(0.26, 0.32))
            if given != "nu":
                self.put("shear_modulus", self.uniform(76, 82), "GPa")
            if self.chance(0.7):
                strength = self.uniform(600, 1700)
                self.put("yield_strength", strength, "MPa")
                self.maybe(0.5, "ultimate_strength", strength, 1.3 * strength, "MPa")
            self.maybe(0.7, "fracture_toughness", 20, 120, "MPa*m^0.5")

    def wave_generator(self):
        d = self.d
        section = 0.073 * d * self.uniform(0.9, 1.1)
        self.table("wave_generator")
        self.put("material", self.material())
        self.put("force_transmission_coefficient", self.uniform(0.3, 0.5))
        self.maybe(0.3, "load_factor", 1.0, 1.3)
        if self.chance(0.3):
            self.put("conversion", self.random.choice(["reciprocity", "cam"]))
        source = self.random.choice(["radial_stiffness", "displacements", "bearing", "bearing"])
        if source == "radial_stiffness":
            self.put("radial_stiffness", self.uniform(5e4, 3e5), "N/mm")
        if source != "bearing" or self.chance(0.05):
            axes = [f'"{self.uniform(*r) * d * 1e3:.5g} mm"' for r in ((0.01, 0.04), (0.002, 0.01))]
            self.lines.append(f"contact_semi_axes = [{', '.join(axes)}]")
        self.put("inner_ring_thickness", self.uniform(0.02, 0.06) * d, "m")
        # 0.1.0 took a ring with a surface crack as a wide plate.
        width_known = self.chance(0.6)
        if width_known:
            self.put("inner_ring_width", self.uniform(0.12, 0.18) * d, "m")
        self.put("inner_ring_mean_radius", self.uniform(0.36, 0.39) * d, "m")
        self.maybe(0.2, "cam_flattening", 0, 1.5)
        if source == "displacements":
            self.table("wave_generator.displacements")
            self.put("bearing", self.uniform(1e-6, 2e-5), "m")
            self.maybe(0.5, "cam", 0, 1e-5, "m")
            self.maybe(0.3, "shaft", 0, 1e-5, "m")
        kinds = ["edge"] if width_known else ["surface"]
        if source == "bearing":
            self.table("wave_generator.bearing")
            self.put("ball_diameter", section, "m")
            self.put("inner_raceway_diameter", 0.845 * d - section, "m")
            self.put("outer_raceway_diameter", 0.845 * d + section * 1.0002, "m")
            self.maybe(0.5, "inner_conformity", 0.515, 0.54)
            self.maybe(0.5, "outer_conformity", 0.515, 0.54)
            self.put("loaded_balls", self.random.randint(1, 6))
            if self.chance(0.8):
                self.put("ball_count", self.random.randint(19, 27))
            self.maybe(0.3, "clearance", 0, 47e-6 * d, "m")
            if self.chance(0.8):
                kinds.append("outer_race")
                self.table("wave_generator.bearing.outer_ring")
                self.put("mean_radius", 0.471 * d, "m")
                self.put("thickness", self.uniform(0.018, 0.026) * d, "m")
                self.put("width", self.uniform(0.14, 0.16) * d, "m")
                self.maybe(0.3, "groove_factor", 0.7, 0.9)
        for _ in range(self.random.choice([0, 1, 1, 2])):
            kind = self.random.choice(kinds)
            self.crack("wave_generator", kind)
            self.put("depth", self.uniform(0.001, 0.012) * d, "m")
            if kind == "surface":
                self.put("aspect_ratio", self.uniform(0.2, 1.0))
            if kind != "outer_race":
                driver = self.random.choice(["orthogonal_shear", "contact_edge", "ring_bending", "given"])
                if kind == "surface" and driver == "ring_bending":
                    driver = "contact_edge"  # 0.1.0 took that stress as uniform
                self.put("stress_driver", driver)
                if driver == "given":
                    self.put("stress", self.uniform(-100, 500), "MPa")
                if driver == "orthogonal_shear":
                    self.maybe(0.5, "contact_factor", 0.2, 0.6)
                self.position()
            else:  # the assembly opens the crack there; 0.1.0 softened the ring also at pressed cracks
                self.put("position", self.uniform(60, 120), "deg")

    def flexspline(self):
        d = self.d
        rim = self.uniform(0.010, 0.015) * d
        barrel = rim * self.uniform(0.5, 0.9)
        length = self.uniform(0.38, 0.9) * d
        face = self.uniform(0.12, 0.2) * d
        sections = self.chance(0.7)
        shape = "cup" if sections or self.chance(0.5) else "cylinder"
        self.table("flexspline")
        self.put("material", self.material())
        if shape == "cylinder" or self.chance(0.3):
            self.put("shape", shape)
        self.put("wall_thickness", rim, "m")
        self.put("length", length, "m")
        if sections:
            self.put("crack_free", "sections")
        else:
            self.maybe(0.3, "shape_factor", 0.7, 1.0)
        self.maybe(0.3, "stress_nonuniformity", 1.0, 1.3)
        self.maybe(0.3, "dynamic_load", 1.0, 1.3)
        if sections:
            self.maybe(0.2, "flange_compliance", 1e-7, 1e-5, "rad/(N*m)")
        outer = d * 0.989
        mean = outer - rim
        hub = self.uniform(0.45, 0.62) * d
        if sections:
            for name, thickness, extent in (("rim", rim, face), ("barrel", barrel, 0.999 * length - face)):
                self.table(f"flexspline.{name}")
                self.put("outer_diameter", mean + thickness, "m")
                self.put("wall_thickness", thickness, "m")
                self.put("length", extent, "m")
            if self.chance(0.97):
                self.table("flexspline.diaphragm")
                thickness = self.uniform(0.008, 0.02) * d
                self.put("outer_diameter", mean, "m")
                self.put("inner_diameter", hub, "m")
                self.put("thickness", thickness, "m")
                if self.chance(0.3):
                    stations = [(hub / 2, 1.5 * thickness), ((hub + mean) / 4, 1.2 * thickness),
                                (mean / 2, thickness)]
                    for radius, at in stations:
                        self.lines.append("\n[[flexspline.diaphragm.profile]]")
                        self.lines.append(f'radius = "{radius!r} m"')
                        self.put("thickness", at, "m")
            if self.chance(0.3):
                self.table("flexspline.boss")
                self.put("outer_diameter", hub, "m")
                self.put("wall_thickness", self.uniform(0.1, 0.3) * hub, "m")
                self.put("length", self.uniform(0.05, 0.1) * d, "m")
        kinds = ["through", "surface"]
        if sections:
            kinds += ["diaphragm_arc", "diaphragm_groove", "rim_axial"]
        for _ in range(self.random.choice([0, 1, 1, 2, 3])):
            kind = self.random.choice(kinds)
            self.crack("flexspline", kind)
            if kind == "through":
                self.put("half_length", self.uniform(0.002, 0.05) * d, "m")
                if self.chance(0.3):
                    self.put("shell_correction", self.chance(0.5))
            if kind == "surface":
                depth = self.uniform(0.1, 0.6) * barrel
                self.put("depth", depth, "m")
                self.put("half_length", depth * self.uniform(1.0, 4.0), "m")
            if kind in ("through", "surface"):
                self.maybe(0.8, "angle", -89, 90, "deg")
                if sections and self.chance(0.5):
                    self.put("section", self.random.choice(["barrel", "rim"]))
            if kind == "diaphragm_arc":
                self.put("half_length", self.uniform(0.01, 0.06) * d, "m")
                self.maybe(0.3, "radius", 0.55 * hub, 0.45 * mean, "m")
            if kind == "diaphragm_groove":
                self.put("depth", self.uniform(0.001, 0.006) * d, "m")
                self.put("width", self.uniform(0.003, 0.012) * d, "m")
                self.put("radius", (hub + mean) / 4, "m")
            if kind == "rim_axial":
                self.put("depth", self.uniform(0.1, 0.6) * rim, "m")
                self.maybe(0.7, "position", -35, 35, "deg")  # the assembly opens the crack there

    def output_shaft(self):
        outer = self.uniform(0.3, 0.6) * self.d
        inner = 0.0 if self.chance(0.4) else self.uniform(0.2, 0.8) * outer
        self.table("output_shaft")
        self.put("material", self.material())
        self.put("outer_diameter", outer, "m")
        if inner:
            self.put("inner_diameter", inner, "m")
        self.put("length", self.uniform(0.5, 4.0) * outer, "m")
        for _ in range(self.random.choice([0, 1, 1, 2])):
            self.crack("output_shaft", "annular")
            self.put("depth", self.uniform(0.01, 0.45) * (outer - inner) / 2, "m")
            if not inner and self.chance(0.4):
                self.put("solution", self.random.choice(["improved", "tada"]))

    def torsion(self):
        d = self.d
        if self.chance(0.8):
            self.table("mesh")
            self.maybe(0.8, "flank_angle", 18, 26, "deg")
            self.maybe(0.3, "gap_factor", 0.8, 1.2)
            self.maybe(0.5, "coning", 0.1, 1.0)
            self.maybe(0.3, "lobe_gap", -16e-6 * d, 31e-6 * d, "m")
            self.maybe(0.5, "friction_coefficient", 0.05, 0.15)
            self.maybe(0.3, "rim_stiffening", 1.2, 1.3)
            self.maybe(0.2, "pair_stiffness", 1e10, 1e11, "Pa")
            if self.chance(0.3):
                self.crack("mesh", "tooth")
                self.put("stiffness_loss", self.uniform(0.1, 1.0))
                self.position()
        if self.chance(0.6):
            self.table("circular_spline")
            self.put("material", self.material())
            self.put("outer_diameter", self.uniform(1.3, 1.4) * d, "m")
            self.put("inner_diameter", 1.021 * d, "m")
            self.put("width", self.uniform(0.14, 0.18) * d, "m")
            self.put("support", self.uniform(0, 1))
            if self.chance(0.4):
                self.crack("circular_spline", "ring")
                self.put("depth", self.uniform(0.01, 0.06) * d, "m")
                self.position()
        if self.chance(0.8):
            self.table("rating")
            T1 = self.uniform(0.8, 1.2) * 14 * (d / 0.0635) ** 3
            T2 = T1 * self.uniform(2.5, 4)
            self.put("T1", T1, "N*m")
            self.put("T2", T2, "N*m")
            self.maybe(0.3, "T3", 1.3 * T2, 2 * T2, "N*m")
            self.maybe(0.3, "rated_torque", 1.5 * T2, 2 * T2, "N*m")
            self.maybe(0.3, "lost_motion_share", 0.02, 0.06)
            self.maybe(0.3, "friction_torque", 0, 0.02 * T2, "N*m")

    def knowledge(self):
        if self.chance(0.3):
            self.lines.append("\n[[range]]")
            self.put("path", "drive.radial_displacement")
            self.put("lower", f"{0.95 * self.w0 * 1e3:.6g} mm")
            self.put("upper", f"{1.05 * self.w0 * 1e3:.6g} mm")
            if self.chance(0.5):
                self.put("knowledge", self.random.choice(["catalogue", "typical", "assumed"]))
        scattered = ["load.torque", "drive.pitch_diameter"]
        if "\n[flexspline]" in self.lines:
            scattered.append("flexspline.wall_thickness")
        for path in scattered:
            if self.chance(0.5):
                self.lines.append("\n[[scatter]]")
                self.put("path", path)
                self.put("relative_standard_deviation", self.uniform(0.005, 0.1))
                if self.chance(0.5):
                    self.put("distribution", self.random.choice(["lognormal", "normal"]))
        if self.chance(0.3):
            self.table("article")
            self.maybe(0.5, "radial_load", 100, 1000, "N")
            self.maybe(0.5, "flaw_parameter", 1, 2)
            self.maybe(0.5, "mean_radius", 0.49 * self.d, 0.5 * self.d, "m")
            self.maybe(0.5, "M_p", 0.5, 1)
            self.maybe(0.5, "M_M", 0.3, 1)

    def text(self):
        self.lines += ['format = "strainwave-drive/1"']
        if self.chance(0.7):
            self.put("name", "A drive drawn at random")
        self.materials()
        self.table("drive")
        waves = self.random.choice([2, 2, 2, 3])
        self.w0 = self.uniform(0.9, 1.05) * self.d / (2 * self.ratio) * waves / 2
        self.put("ratio", self.ratio)
        if waves != 2:
            self.put("wave_number", waves)
        self.lines.append(f'pitch_diameter = "{self.d * 1e3!r} mm"')
        self.put("radial_displacement", self.w0, "m")
        self.table("load")
        self.put("torque", self.uniform(-1, 2) * 48 * (self.d / 0.0635) ** 3, "N*m")
        self.maybe(0.3, "axial_force", -500, 500, "N")
        if self.chance(0.8):
            self.wave_generator()
        if self.chance(0.85):
            self.flexspline()
        if self.chance(0.5):
            self.output_shaft()
        self.torsion()
        self.knowledge()
        return "\n".join(self.lines) + "\n"


def random_drive(seed):
    return Drive(seed).text()


if __name__ == "__main__":
    sys.stdout.write(random_drive(int(sys.argv[1])))
