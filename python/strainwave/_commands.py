# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The commands, as functions and as methods of Drive."""

from __future__ import annotations

from typing import Any, Literal, Mapping, Optional, Sequence

import strainwave  # noqa: F401  names the drive among the options, for typing.get_type_hints

from . import results
from .running import Named, ShownProgress, run

__all__ = [
    "DriveCommands",
    "duty",
    "fit",
    "sif_list",
    "sif_show",
    "sif_eval",
    "sif_plot",
    "material_list",
    "material_show",
    "catalogue",
    "validate",
    "audit",
    "schema",
    "explain",
    "units",
    "diff",
]


def duty(*, rainflow: Optional[Named] = None, column: Optional[Named] = None,
         residue: Optional[Literal["half_cycles", "repeated"]] = None,
         classes: Optional[int] = None, texts: Optional[Mapping[str, str]] = None,
         progress: ShownProgress = None) -> results.duty.DutyResult:
    """Count the load cycles of a duty, place by place, or of any history.

    Args:
        rainflow: count the cycles of a history instead: CSV of any length, or - for standard input
        column: with `rainflow`, the column to count; the only one if left out
        residue: with `rainflow`, what counts of the ranges that stay open at the end; half_cycles
            if left out
        classes: sum up ranges and means in at most this many classes each; exact values if left out
        texts: texts that options name, by their names; an option may also be a pathlib.Path, whose
            file is read
        progress: True for a line of progress, or a function that receives the completed fraction
    """
    given: dict[str, Any] = {"rainflow": rainflow, "column": column, "residue": residue,
                             "classes": classes}
    answer: results.duty.DutyResult = run(None, "duty", given, texts, progress)
    return answer


def fit(data: Named, *, stress_range: Optional[Named] = None, plate_width: Optional[Named] = None,
        stress_ratio: Optional[float] = None, judge: Optional[Named] = None,
        size: Optional[Sequence[Named]] = None, known: Optional[Sequence[Named]] = None,
        parts: Optional[Named] = None, knots: Optional[int] = None,
        confidence: Optional[float] = None, draws: Optional[int] = None, seed: Optional[int] = None,
        threads: Optional[int] = None, texts: Optional[Mapping[str, str]] = None,
        progress: ShownProgress = None) -> results.fit.FitResult:
    """Fit a law of crack growth and its scatter to measured specimens.

    Args:
        data: CSV with sizes such as "crack_length [mm]" in the first column and the cycles of one
            specimen in each other column; or with the columns specimen, crack_length, cycles and,
            without `stress_range`, delta_K
        stress_range: range of the stress on a plate with a crack in its middle, a number with its
            unit; sizes are then half lengths
        plate_width: width of the plate, a number with its unit; left out for a wide plate
        stress_ratio: R of the test, which the records do not say; the text for a drive file states
            it
        judge: CSV of other specimens, of the same test, whose cycles are predicted; each specimen
            of the data by a fit to all others if left out
        size: size whose cycles are predicted, a number with its unit; once or more; five sizes over
            the records if left out
        known: also predict the cycles left, with the own record of a specimen up to this size, a
            number with its unit; once or more
        parts: parts of the scatter, separated by commas: level and slope differ from specimen to
            specimen; correlated and white vary along the path of a crack
        knots: points of the median rate; 2 give Paris' law; left out, the number from 2 to 8 with
            the least information criterion
        confidence: probability of a band
        draws: drawn paths of growth for a band
        seed: seed of the draws
        threads: number of threads; 0 for all of the machine; the answer does not depend on it
        texts: texts that options name, by their names; an option may also be a pathlib.Path, whose
            file is read
        progress: True for a line of progress, or a function that receives the completed fraction
    """
    given: dict[str, Any] = {"data": data, "stress_range": stress_range, "plate_width": plate_width,
                             "stress_ratio": stress_ratio, "judge": judge, "size": size, "known": known,
                             "parts": parts, "knots": knots, "confidence": confidence, "draws": draws,
                             "seed": seed, "threads": threads}
    answer: results.fit.FitResult = run(None, "fit", given, texts, progress)
    return answer


def sif_list(*, family: Optional[Named] = None, texts: Optional[Mapping[str, str]] = None,
             progress: ShownProgress = None) -> results.sif_list.SifListResult:
    """List all solutions of the library.

    Args:
        family: family to list: plate, tube, bar or gradient
        texts: texts that options name, by their names; an option may also be a pathlib.Path, whose
            file is read
        progress: True for a line of progress, or a function that receives the completed fraction
    """
    given: dict[str, Any] = {"family": family}
    answer: results.sif_list.SifListResult = run(None, "sif list", given, texts, progress)
    return answer


def sif_show(name: Named, *, texts: Optional[Mapping[str, str]] = None,
             progress: ShownProgress = None) -> results.sif_show.SifShowResult:
    """Describe one solution.

    Args:
        name: name of the solution
        texts: texts that options name, by their names; an option may also be a pathlib.Path, whose
            file is read
        progress: True for a line of progress, or a function that receives the completed fraction
    """
    given: dict[str, Any] = {"name": name}
    answer: results.sif_show.SifShowResult = run(None, "sif show", given, texts, progress)
    return answer


def sif_eval(name: Named, *, set: Optional[Sequence[Named]] = None,
             material: Optional[Named] = None, texts: Optional[Mapping[str, str]] = None,
             progress: ShownProgress = None) -> results.sif_eval.SifEvalResult:
    """Compute stress intensity, geometry factors, added compliance.

    Args:
        name: name of the solution
        set: NAME=VALUE, a field or a load, with its unit; repeatable
        material: steel of the material library; if left out, E = 210 GPa and nu = 0.3
        texts: texts that options name, by their names; an option may also be a pathlib.Path, whose
            file is read
        progress: True for a line of progress, or a function that receives the completed fraction
    """
    given: dict[str, Any] = {"name": name, "set": set, "material": material}
    answer: results.sif_eval.SifEvalResult = run(None, "sif eval", given, texts, progress)
    return answer


def sif_plot(name: Named, *, set: Optional[Sequence[Named]] = None,
             texts: Optional[Mapping[str, str]] = None,
             progress: ShownProgress = None) -> results.sif_plot.SifPlotResult:
    """Draw geometry factors over the crack size and along its front.

    Args:
        name: name of the solution
        set: NAME=VALUE, a field or a load, with its unit; repeatable
        texts: texts that options name, by their names; an option may also be a pathlib.Path, whose
            file is read
        progress: True for a line of progress, or a function that receives the completed fraction
    """
    given: dict[str, Any] = {"name": name, "set": set}
    answer: results.sif_plot.SifPlotResult = run(None, "sif plot", given, texts, progress)
    return answer


def material_list(*,
                  use: Optional[Literal["flexspline", "bearing", "shaft", "generic", "ply"]] = None,
                  texts: Optional[Mapping[str, str]] = None,
                  progress: ShownProgress = None) -> results.material_list.MaterialListResult:
    """Print all steels, one line for each.

    Args:
        use: only steels for this use
        texts: texts that options name, by their names; an option may also be a pathlib.Path, whose
            file is read
        progress: True for a line of progress, or a function that receives the completed fraction
    """
    given: dict[str, Any] = {"use": use}
    answer: results.material_list.MaterialListResult = run(None, "material list", given, texts, progress)
    return answer


def material_show(name: Named, *, texts: Optional[Mapping[str, str]] = None,
                  progress: ShownProgress = None) -> results.material_show.MaterialShowResult:
    """Print all data of one steel.

    Args:
        name: name or alias; case and blanks do not matter
        texts: texts that options name, by their names; an option may also be a pathlib.Path, whose
            file is read
        progress: True for a line of progress, or a function that receives the completed fraction
    """
    given: dict[str, Any] = {"name": name}
    answer: results.material_show.MaterialShowResult = run(None, "material show", given, texts, progress)
    return answer


def catalogue(*, size: Optional[int] = None, ratio: Optional[float] = None,
              texts: Optional[Mapping[str, str]] = None,
              progress: ShownProgress = None) -> results.catalogue.CatalogueResult:
    """Print makers' data: K1, K2, K3 and torques.

    Args:
        size: only this size
        ratio: only this ratio, or its class
        texts: texts that options name, by their names; an option may also be a pathlib.Path, whose
            file is read
        progress: True for a line of progress, or a function that receives the completed fraction
    """
    given: dict[str, Any] = {"size": size, "ratio": ratio}
    answer: results.catalogue.CatalogueResult = run(None, "catalogue", given, texts, progress)
    return answer


def validate(*,
             mode: Optional[Literal["geometry", "leave-one-size-out", "leave-one-class-out", "per-row"]] = None,
             factors: Optional[Named] = None, blank: Optional[Literal["ratio", "size"]] = None,
             all_sets: Optional[bool] = None, draws: Optional[int] = None,
             data: Optional[Named] = None, texts: Optional[Mapping[str, str]] = None,
             progress: ShownProgress = None) -> results.validate.ValidateResult:
    """Compare the torsion curve with the makers' tables.

    Args:
        mode: which factors are fitted before the comparison, and to what
        factors: other factors to fit, at most three, separated by commas
        blank: walls of the drives: made for the wave of each ratio, or of ratio 100 for all ratios
            of a size
        all_sets: with mode leave-one-size-out or leave-one-class-out, also fit every set of one to
            three factors
        draws: number of drives drawn for the bands, at least 2; 0 for none
        data: also judge rows of your own: CSV with the columns series, form, length, size or
            pitch_diameter [mm], ratio, T1 [N*m], T2 [N*m], K1 [N*m/rad], K2 [N*m/rad], K3 [N*m/rad]
        texts: texts that options name, by their names; an option may also be a pathlib.Path, whose
            file is read
        progress: True for a line of progress, or a function that receives the completed fraction
    """
    given: dict[str, Any] = {"mode": mode, "factors": factors, "blank": blank, "all_sets": all_sets,
                             "draws": draws, "data": data}
    answer: results.validate.ValidateResult = run(None, "validate", given, texts, progress)
    return answer


def audit(*, texts: Optional[Mapping[str, str]] = None,
          progress: ShownProgress = None) -> results.audit.AuditResult:
    """Recompute the article's worked example number by number.

    Args:
        texts: texts that options name, by their names; an option may also be a pathlib.Path, whose
            file is read
        progress: True for a line of progress, or a function that receives the completed fraction
    """
    given: dict[str, Any] = {}
    answer: results.audit.AuditResult = run(None, "audit", given, texts, progress)
    return answer


def new(*, size: Optional[int] = None, ratio: Optional[float] = None,
        form: Optional[Literal["cup", "hat"]] = None,
        length: Optional[Literal["standard", "short", "flat"]] = None,
        blank: Optional[Literal["ratio", "size"]] = None, texts: Optional[Mapping[str, str]] = None,
        progress: ShownProgress = None) -> results.new.NewResult:
    """Print a commented starting file.

    Args:
        size: size in the catalogue; prints its typical drive
        ratio: ratio of the typical drive, 30 to 320
        form: flexspline of the typical drive: cup, or silk hat with the diaphragm outward
        length: length class of its flexspline
        blank: walls made for the wave of this ratio, or of ratio 100 for all ratios of a size
        texts: texts that options name, by their names; an option may also be a pathlib.Path, whose
            file is read
        progress: True for a line of progress, or a function that receives the completed fraction
    """
    given: dict[str, Any] = {"size": size, "ratio": ratio, "form": form, "length": length,
                             "blank": blank}
    answer: results.new.NewResult = run(None, "new", given, texts, progress)
    return answer


def schema(*, of: Optional[Literal["input", "options", "result"]] = None,
           command: Optional[Named] = None, texts: Optional[Mapping[str, str]] = None,
           progress: ShownProgress = None) -> results.schema.SchemaResult:
    """Print the JSON Schema of the input.

    Args:
        of: subject: the input file, or the options or the result of a command
        command: command whose options or result are described, such as "sif eval"
        texts: texts that options name, by their names; an option may also be a pathlib.Path, whose
            file is read
        progress: True for a line of progress, or a function that receives the completed fraction
    """
    given: dict[str, Any] = {"of": of, "command": command}
    answer: results.schema.SchemaResult = run(None, "schema", given, texts, progress)
    return answer


def explain(word: Named, *, texts: Optional[Mapping[str, str]] = None,
            progress: ShownProgress = None) -> results.explain.ExplainResult:
    """Explain a word: a field, a unit, a note, an equation and more.

    Args:
        word: a term, table, kind of crack, field, unit, note code, equation, exit status, material,
            solution, output, command, or option without its dashes
        texts: texts that options name, by their names; an option may also be a pathlib.Path, whose
            file is read
        progress: True for a line of progress, or a function that receives the completed fraction
    """
    given: dict[str, Any] = {"word": word}
    answer: results.explain.ExplainResult = run(None, "explain", given, texts, progress)
    return answer


def units(*, texts: Optional[Mapping[str, str]] = None,
          progress: ShownProgress = None) -> results.units.UnitsResult:
    """List all units with dimension, factor to SI and a field that takes them.

    Args:
        texts: texts that options name, by their names; an option may also be a pathlib.Path, whose
            file is read
        progress: True for a line of progress, or a function that receives the completed fraction
    """
    given: dict[str, Any] = {}
    answer: results.units.UnitsResult = run(None, "units", given, texts, progress)
    return answer


def diff(first: Named, second: Named, *,
         method: Optional[Literal["as-printed", "repaired", "corrected"]] = None,
         coverage: Optional[float] = None, texts: Optional[Mapping[str, str]] = None,
         progress: ShownProgress = None) -> results.diff.DiffResult:
    """Compare two drives or two results.

    Args:
        first: a drive, or a result that --format json wrote
        second: a drive or a result to compare with the first
        method: theory to use
        coverage: number of standard uncertainties that a difference must exceed
        texts: texts that options name, by their names; an option may also be a pathlib.Path, whose
            file is read
        progress: True for a line of progress, or a function that receives the completed fraction
    """
    given: dict[str, Any] = {"first": first, "second": second, "method": method, "coverage": coverage}
    answer: results.diff.DiffResult = run(None, "diff", given, texts, progress)
    return answer


class DriveCommands:
    """The commands that take a drive."""

    def _run(self, command: str, options: Mapping[str, Any], texts: Optional[Mapping[str, str]],
             progress: ShownProgress) -> Any:
        raise NotImplementedError

    def stiffness(self, *, method: Optional[Literal["as-printed", "repaired", "corrected"]] = None,
                  texts: Optional[Mapping[str, str]] = None,
                  progress: ShownProgress = None) -> results.stiffness.StiffnessResult:
        """Compute the torsional stiffness of a drive, sound and cracked.

        Args:
            method: theory to use
            texts: texts that options name, by their names; an option may also be a pathlib.Path,
                whose file is read
            progress: True for a line of progress, or a function that receives the completed
                fraction
        """
        given: dict[str, Any] = {"method": method}
        answer: results.stiffness.StiffnessResult = self._run("stiffness", given, texts, progress)
        return answer

    def torsion(self, *, compare: Optional[bool] = None, angles: Optional[int] = None,
                draws: Optional[int] = None, cage_phase: Optional[Named] = None,
                tolerances: Optional[int] = None, seed: Optional[int] = None,
                texts: Optional[Mapping[str, str]] = None,
                progress: ShownProgress = None) -> results.torsion.TorsionResult:
        """Compute the torsion curve in the maker's numbers: K1, K2, K3.

        Args:
            compare: compare the drive with the cracks of the file with the sound drive
            angles: number of positions of the wave generator for `compare`; 0 for every tooth
            draws: number of drives drawn from the file's ranges; 0 for none
            cage_phase: angle of the first ball from the major axis, a number with its unit
            tolerances: number of drives whose parts are drawn from their tolerances; none if left
                out
            seed: seed of the draws of `tolerances`
            texts: texts that options name, by their names; an option may also be a pathlib.Path,
                whose file is read
            progress: True for a line of progress, or a function that receives the completed
                fraction
        """
        given: dict[str, Any] = {"compare": compare, "angles": angles, "draws": draws,
                                 "cage_phase": cage_phase, "tolerances": tolerances, "seed": seed}
        answer: results.torsion.TorsionResult = self._run("torsion", given, texts, progress)
        return answer

    def duty(self, *, rainflow: Optional[Named] = None, column: Optional[Named] = None,
             residue: Optional[Literal["half_cycles", "repeated"]] = None,
             classes: Optional[int] = None, texts: Optional[Mapping[str, str]] = None,
             progress: ShownProgress = None) -> results.duty.DutyResult:
        """Count the load cycles of a duty, place by place, or of any history.

        Args:
            rainflow: count the cycles of a history instead: CSV of any length, or - for standard
                input
            column: with `rainflow`, the column to count; the only one if left out
            residue: with `rainflow`, what counts of the ranges that stay open at the end;
                half_cycles if left out
            classes: sum up ranges and means in at most this many classes each; exact values if left
                out
            texts: texts that options name, by their names; an option may also be a pathlib.Path,
                whose file is read
            progress: True for a line of progress, or a function that receives the completed
                fraction
        """
        given: dict[str, Any] = {"rainflow": rainflow, "column": column, "residue": residue,
                                 "classes": classes}
        answer: results.duty.DutyResult = self._run("duty", given, texts, progress)
        return answer

    def life(self, *, texts: Optional[Mapping[str, str]] = None,
             progress: ShownProgress = None) -> results.life.LifeResult:
        """Compute the life of a drive over its duty: what ends it, and when.

        Args:
            texts: texts that options name, by their names; an option may also be a pathlib.Path,
                whose file is read
            progress: True for a line of progress, or a function that receives the completed
                fraction
        """
        given: dict[str, Any] = {}
        answer: results.life.LifeResult = self._run("life", given, texts, progress)
        return answer

    def grow(self, *, until: Optional[Named] = None, law: Optional[Named] = None,
             mixed_mode: Optional[Literal["energy", "tanaka", "richard", "largest_tangential_stress"]] = None,
             interaction: Optional[Literal["none", "wheeler", "willenborg", "closure"]] = None,
             zone_factor: Optional[float] = None, wheeler_exponent: Optional[float] = None,
             constraint: Optional[float] = None, stress_level: Optional[float] = None,
             points: Optional[int] = None, texts: Optional[Mapping[str, str]] = None,
             progress: ShownProgress = None) -> results.grow.GrowResult:
        """Grow the cracks over the duty: size, stiffness and reserve over hours.

        Args:
            until: end of the computation: a time such as "20000 h", "1e6 cycles", a size such as
                "output_shaft.crack[0].depth=5 mm", or "event" for the first crack that ends the
                life
            law: steel of the material library whose law of growth replaces that of the file; the
                file's if left out
            mixed_mode: rule that makes one stress intensity of three modes
            interaction: how a large cycle slows the cycles after it
            zone_factor: beta of the plastic zone (K/yield strength)^2/(beta pi): 1 the whole zone
                in plane stress, 2 its radius, 3 and 6 in plane strain; needed with `interaction`
            wheeler_exponent: exponent of `interaction="wheeler"`, which needs it
            constraint: alpha of Newman's opening, 1 in plane stress to 3 in plane strain, for
                `interaction="closure"`; cracks with a law of NASGRO take that of their law
            stress_level: largest stress over the flow stress of Newman's opening, with `constraint`
            points: largest number of rows of a series
            texts: texts that options name, by their names; an option may also be a pathlib.Path,
                whose file is read
            progress: True for a line of progress, or a function that receives the completed
                fraction
        """
        given: dict[str, Any] = {"until": until, "law": law, "mixed_mode": mixed_mode,
                                 "interaction": interaction, "zone_factor": zone_factor,
                                 "wheeler_exponent": wheeler_exponent, "constraint": constraint,
                                 "stress_level": stress_level, "points": points}
        answer: results.grow.GrowResult = self._run("grow", given, texts, progress)
        return answer

    def inspect(self, *, until: Optional[Named] = None,
                method: Optional[Literal["curve", "stiffness", "one_sided_stiffness", "resonance"]] = None,
                a50: Optional[Named] = None, a90: Optional[Named] = None,
                detection: Optional[Literal["log_logistic", "log_normal"]] = None,
                noise: Optional[float] = None, false_calls: Optional[float] = None,
                find: Optional[Literal["out", "repair"]] = None,
                repaired_to: Optional[Named] = None, detection_data: Optional[Named] = None,
                threshold: Optional[float] = None, floor: Optional[float] = None,
                ceiling: Optional[float] = None, see: Optional[Sequence[Named]] = None,
                at: Optional[Sequence[Named]] = None, every: Optional[Named] = None,
                first: Optional[Named] = None, risk: Optional[float] = None,
                most: Optional[int] = None, law: Optional[Named] = None,
                mixed_mode: Optional[Literal["energy", "tanaka", "richard", "largest_tangential_stress"]] = None,
                interaction: Optional[Literal["none", "wheeler", "willenborg", "closure"]] = None,
                zone_factor: Optional[float] = None, wheeler_exponent: Optional[float] = None,
                constraint: Optional[float] = None, stress_level: Optional[float] = None,
                draws: Optional[int] = None, importance_sampling: Optional[bool] = None,
                seed: Optional[int] = None, threads: Optional[int] = None,
                texts: Optional[Mapping[str, str]] = None,
                progress: ShownProgress = None) -> results.inspect.InspectResult:
        """Compute the risk of cracked drives over hours, and the inspections that lower it.

        Args:
            until: end of service, a time of duty with its unit; the life at the values of the file
                if left out
            method: what an inspection looks at: the cracks, with a curve of detection over their
                size, or a measurement of the drive; as [inspection] of the file says, or a curve,
                if left out
            a50: size of a crack that one inspection finds in half of the cases, a number with its
                unit: the depth, or the half length of a crack through the wall; as [inspection] of
                the file says if left out
            a90: size that is found in nine of ten cases, a number with its unit
            detection: form of the probability of detection over the size; log_logistic if left out
            noise: of a measurement: standard deviation of the measured change over the measured
                value
            false_calls: probability that an inspection finds a crack that is not there; 0 if left
                out of a curve; the threshold of a measurement follows from it
            find: what a find leads to: the drive goes out of service, or the repair of its cracks;
                out if left out
            repaired_to: size of a crack after its repair, a number with its unit
            detection_data: CSV of trials on cracks of known size, from which the curve is fitted,
                in place of a50 and a90: the columns size [mm] and hit (1 or 0), or size [mm] and
                signal with `threshold`
            threshold: signal of `detection_data` from which on a crack counts as found, in the unit
                of the signal
            floor: signal of `detection_data` at which the noise begins, in the unit of the signal;
                a signal at the floor or below it counts as somewhere below
            ceiling: signal of `detection_data` at which the scale ends, in the unit of the signal;
                a signal at the ceiling or above it counts as somewhere above
            see: path of a crack that the inspections can see, once for each; all cracks if left out
            at: time of an inspection, with its unit, once for each
            every: interval of the inspections, a time with its unit
            first: first inspection of the intervals; one interval if left out
            risk: wanted probability of failure up to the end of service; plans the fewest
                inspections for it
            most: largest number of inspections of a plan, 1 to 100; 20 if left out
            law: steel of the material library whose law of growth replaces that of the file; the
                file's if left out
            mixed_mode: rule that makes one stress intensity of three modes
            interaction: how a large cycle slows the cycles after it
            zone_factor: beta of the plastic zone (K/yield strength)^2/(beta pi): 1 the whole zone
                in plane stress, 2 its radius, 3 and 6 in plane strain; needed with `interaction`
            wheeler_exponent: exponent of `interaction="wheeler"`, which needs it
            constraint: alpha of Newman's opening, 1 in plane stress to 3 in plane strain, for
                `interaction="closure"`; cracks with a law of NASGRO take that of their law
            stress_level: largest stress over the flow stress of Newman's opening, with `constraint`
            draws: number of drives drawn from [[scatter]] and growth_scatter, 20 to 1e6
            importance_sampling: let draws scatter about the failures up to the end of service too,
                for probabilities below about 1e-2; needs an `until` before the life at the values
                of the file
            seed: seed of the draws
            threads: threads; 0: as many as the machine runs; the answer does not depend on them
            texts: texts that options name, by their names; an option may also be a pathlib.Path,
                whose file is read
            progress: True for a line of progress, or a function that receives the completed
                fraction
        """
        given: dict[str, Any] = {"until": until, "method": method, "a50": a50, "a90": a90,
                                 "detection": detection, "noise": noise, "false_calls": false_calls,
                                 "find": find, "repaired_to": repaired_to, "detection_data": detection_data,
                                 "threshold": threshold, "floor": floor, "ceiling": ceiling, "see": see,
                                 "at": at, "every": every, "first": first, "risk": risk, "most": most,
                                 "law": law, "mixed_mode": mixed_mode, "interaction": interaction,
                                 "zone_factor": zone_factor, "wheeler_exponent": wheeler_exponent,
                                 "constraint": constraint, "stress_level": stress_level, "draws": draws,
                                 "importance_sampling": importance_sampling, "seed": seed,
                                 "threads": threads}
        answer: results.inspect.InspectResult = self._run("inspect", given, texts, progress)
        return answer

    def oval(self, *, torque: Optional[Sequence[Named]] = None,
             nonlinear: Optional[Literal["auto", "on", "off"]] = None,
             texts: Optional[Mapping[str, str]] = None,
             progress: ShownProgress = None) -> results.oval.OvalResult:
        """Compute the stress of the sound flexspline over a turn of the wave generator.

        Args:
            torque: torque at the output, may be repeated; if left out that of the file
            nonlinear: large rotations of the oval: auto if they matter, on or off; auto if left out
            texts: texts that options name, by their names; an option may also be a pathlib.Path,
                whose file is read
            progress: True for a line of progress, or a function that receives the completed
                fraction
        """
        given: dict[str, Any] = {"torque": torque, "nonlinear": nonlinear}
        answer: results.oval.OvalResult = self._run("oval", given, texts, progress)
        return answer

    def turn(self, *, crack: Optional[Named] = None, torque: Optional[Sequence[Named]] = None,
             half_length: Optional[Sequence[Named]] = None, depth: Optional[Sequence[Named]] = None,
             angles: Optional[int] = None, texts: Optional[Mapping[str, str]] = None,
             progress: ShownProgress = None) -> results.turn.TurnResult:
        """Compute K of a crack over a turn of the wave generator, in milliseconds.

        Args:
            crack: path of the crack, such as flexspline.crack[0]; if left out the only crack of the
                wall
            torque: torque at the output, may be repeated; if left out the file's torque, none, and
                the reversed torque
            half_length: half length of a through crack, may be repeated; if left out that of the
                file
            depth: depth of a surface crack of the same shape, may be repeated; if left out that of
                the file
            angles: angles over one wave, half a turn; 36 if left out
            texts: texts that options name, by their names; an option may also be a pathlib.Path,
                whose file is read
            progress: True for a line of progress, or a function that receives the completed
                fraction
        """
        given: dict[str, Any] = {"crack": crack, "torque": torque, "half_length": half_length,
                                 "depth": depth, "angles": angles}
        answer: results.turn.TurnResult = self._run("turn", given, texts, progress)
        return answer

    def laminate(self, *, texts: Optional[Mapping[str, str]] = None,
                 progress: ShownProgress = None) -> results.laminate.LaminateResult:
        """Compute the laminates of a flexspline: stiffness, torsion, first failure.

        Args:
            texts: texts that options name, by their names; an option may also be a pathlib.Path,
                whose file is read
            progress: True for a line of progress, or a function that receives the completed
                fraction
        """
        given: dict[str, Any] = {}
        answer: results.laminate.LaminateResult = self._run("laminate", given, texts, progress)
        return answer

    def transmission(self, *, torque: Optional[Named] = None,
                     flexspline_teeth: Optional[Named] = None, spline_teeth: Optional[Named] = None,
                     draws: Optional[int] = None, seed: Optional[int] = None,
                     texts: Optional[Mapping[str, str]] = None,
                     progress: ShownProgress = None) -> results.transmission.TransmissionResult:
        """Compute the kinematic error by deviations of the teeth and by cracks.

        Args:
            torque: torque at the output, a number with its unit; that of the load if left out
            flexspline_teeth: measured teeth of the flexspline: CSV with a row for each tooth and
                the columns position and thickness, deviations with their units; one column is
                enough
            spline_teeth: measured teeth of the circular spline, likewise
            draws: number of drives whose teeth are drawn from their tolerances, without measured
                teeth; 0 for teeth without deviations
            seed: seed of the draws and of the random positions
            texts: texts that options name, by their names; an option may also be a pathlib.Path,
                whose file is read
            progress: True for a line of progress, or a function that receives the completed
                fraction
        """
        given: dict[str, Any] = {"torque": torque, "flexspline_teeth": flexspline_teeth,
                                 "spline_teeth": spline_teeth, "draws": draws, "seed": seed}
        answer: results.transmission.TransmissionResult = self._run("transmission", given, texts, progress)
        return answer

    def modes(self, *, torque: Optional[Named] = None, growth: Optional[bool] = None,
              texts: Optional[Mapping[str, str]] = None,
              progress: ShownProgress = None) -> results.modes.ModesResult:
        """Compute the natural frequencies between motor and load, sound and cracked.

        Args:
            torque: torque at the output about which the springs are linear, a number with its unit;
                that of the load if left out
            growth: add the first mode while the cracks grow over the duty of the file, as
                strainwave grow computes them
            texts: texts that options name, by their names; an option may also be a pathlib.Path,
                whose file is read
            progress: True for a line of progress, or a function that receives the completed
                fraction
        """
        given: dict[str, Any] = {"torque": torque, "growth": growth}
        answer: results.modes.ModesResult = self._run("modes", given, texts, progress)
        return answer

    def frf(self, *, torque: Optional[Named] = None, from_: Optional[Named] = None,
            to: Optional[Named] = None, points: Optional[int] = None,
            texts: Optional[Mapping[str, str]] = None,
            progress: ShownProgress = None) -> results.frf.FrfResult:
        """Compute the frequency responses between motor and load, sound and cracked.

        Args:
            torque: torque at the output about which the springs are linear, a number with its unit;
                that of the load if left out
            from_: first frequency, a number with its unit; a tenth of the lowest natural frequency
                with locked input if left out
            to: last frequency, a number with its unit; ten times the lowest natural frequency with
                free input if left out
            points: number of frequencies, at most 100000
            texts: texts that options name, by their names; an option may also be a pathlib.Path,
                whose file is read
            progress: True for a line of progress, or a function that receives the completed
                fraction
        """
        given: dict[str, Any] = {"torque": torque, "from": from_, "to": to, "points": points}
        answer: results.frf.FrfResult = self._run("frf", given, texts, progress)
        return answer

    def simulate(self, *, step: Optional[Named] = None, tolerance: Optional[Named] = None,
                 engine: Optional[Literal["explicit", "stiff"]] = None,
                 growth: Optional[Named] = None, flexspline_teeth: Optional[Named] = None,
                 spline_teeth: Optional[Named] = None, drawn_teeth: Optional[int] = None,
                 texts: Optional[Mapping[str, str]] = None,
                 progress: ShownProgress = None) -> results.simulate.SimulateResult:
        """Compute the motion of a drive between motor and load, sound and cracked.

        Args:
            step: time between two rows, a number with its unit; a thousandth of the motion if left
                out
            tolerance: error of the output's angle that one time step may add, a number with its
                unit
            engine: what takes the steps: explicit, or stiff for very stiff friction and springs, if
                the program was built with it
            growth: time of the [duty] of the file that passes evenly during the motion while the
                cracks grow as strainwave grow computes them, a number with its unit such as '100
                h'; a time lapse unless the motion takes as long
            flexspline_teeth: measured teeth of the flexspline: CSV with a row for each tooth and
                the columns position and thickness, deviations with their units; one column is
                enough
            spline_teeth: measured teeth of the circular spline, likewise
            drawn_teeth: draw the deviations of the teeth from the tolerances of the file by this
                seed, in place of measured teeth; both need the computed curve
            texts: texts that options name, by their names; an option may also be a pathlib.Path,
                whose file is read
            progress: True for a line of progress, or a function that receives the completed
                fraction
        """
        given: dict[str, Any] = {"step": step, "tolerance": tolerance, "engine": engine, "growth": growth,
                                 "flexspline_teeth": flexspline_teeth, "spline_teeth": spline_teeth,
                                 "drawn_teeth": drawn_teeth}
        answer: results.simulate.SimulateResult = self._run("simulate", given, texts, progress)
        return answer

    def backbone(self, *, excitation: Optional[Sequence[Named]] = None,
                 amplitude: Optional[Named] = None, load_torque: Optional[Named] = None,
                 at: Optional[Literal["motor", "load"]] = None,
                 input: Optional[Literal["free", "locked"]] = None, harmonics: Optional[int] = None,
                 points: Optional[int] = None, from_: Optional[Named] = None,
                 to: Optional[Named] = None, texts: Optional[Mapping[str, str]] = None,
                 progress: ShownProgress = None) -> results.backbone.BackboneResult:
        """Compute resonance and response over the amplitude, sound and cracked.

        Args:
            excitation: amplitude of the torque that shakes the drive, a number with its unit, once
                for each response; a twentieth and a fifth of the load's torque if left out, over
                the ratio at the motor
            amplitude: largest half range of the twist of the backbone, a number with its unit; the
                twist under the load's torque if left out
            load_torque: constant torque on the output about which the drive vibrates, a number with
                its unit; that of the load if left out
            at: end that is shaken
            input: free: the motor gives its torque; locked: the motor keeps its speed
            harmonics: harmonics of the twist
            points: amplitudes of the backbone
            from_: frequency at which the responses begin, a number with its unit; half of the
                lowest resonance if left out
            to: frequency at which the responses end, a number with its unit; one and a half of the
                highest resonance if left out
            texts: texts that options name, by their names; an option may also be a pathlib.Path,
                whose file is read
            progress: True for a line of progress, or a function that receives the completed
                fraction
        """
        given: dict[str, Any] = {"excitation": excitation, "amplitude": amplitude,
                                 "load_torque": load_torque, "at": at, "input": input,
                                 "harmonics": harmonics, "points": points, "from": from_, "to": to}
        answer: results.backbone.BackboneResult = self._run("backbone", given, texts, progress)
        return answer

    def accuracy(self, *, torque: Optional[Named] = None, speed: Optional[Named] = None,
                 tool_radius: Optional[Named] = None, draws: Optional[int] = None,
                 texts: Optional[Mapping[str, str]] = None,
                 progress: ShownProgress = None) -> results.accuracy.AccuracyResult:
        """Compute the budget of the error of the output and of a tool point.

        Args:
            torque: external torque on the output about +z, a number with its unit; that of the load
                if left out; gravity of the [drivetrain] is added
            speed: speed of the input, a number with its unit; the largest input_speed of the
                manoeuvres if left out, and 0 without them
            tool_radius: distance of the tool point from the axis of the output, a number with its
                unit
            draws: number of drives drawn from [[range]] and [[scatter]], at most 100000; 0: none
            texts: texts that options name, by their names; an option may also be a pathlib.Path,
                whose file is read
            progress: True for a line of progress, or a function that receives the completed
                fraction
        """
        given: dict[str, Any] = {"torque": torque, "speed": speed, "tool_radius": tool_radius,
                                 "draws": draws}
        answer: results.accuracy.AccuracyResult = self._run("accuracy", given, texts, progress)
        return answer

    def require(self, *, requirements: Optional[Sequence[Named]] = None,
                method: Optional[Literal["as-printed", "repaired", "corrected"]] = None,
                coverage: Optional[float] = None, texts: Optional[Mapping[str, str]] = None,
                progress: ShownProgress = None) -> results.require.RequireResult:
        """Check a drive against requirements on its outputs.

        Args:
            requirements: OUTPUT OP VALUE, where OP is one of >=, >, <=, < and VALUE has a unit; one
                or more
            method: theory to use
            coverage: number of standard uncertainties to take into account
            texts: texts that options name, by their names; an option may also be a pathlib.Path,
                whose file is read
            progress: True for a line of progress, or a function that receives the completed
                fraction
        """
        given: dict[str, Any] = {"requirements": requirements, "method": method, "coverage": coverage}
        answer: results.require.RequireResult = self._run("require", given, texts, progress)
        return answer

    def report(self, *, method: Optional[Literal["as-printed", "repaired", "corrected"]] = None,
               date: Optional[Named] = None, site: Optional[Named] = None,
               texts: Optional[Mapping[str, str]] = None,
               progress: ShownProgress = None) -> results.report.ReportResult:
        """Write a report on a drive as one HTML file.

        Args:
            method: theory to use
            date: date to print, YYYY-MM-DD; if left out, the command line uses SOURCE_DATE_EPOCH
            site: address of the folder with the rendered documentation, such as
                https://example.org/strainwave; equations and codes of notes lead there
            texts: texts that options name, by their names; an option may also be a pathlib.Path,
                whose file is read
            progress: True for a line of progress, or a function that receives the completed
                fraction
        """
        given: dict[str, Any] = {"method": method, "date": date, "site": site}
        answer: results.report.ReportResult = self._run("report", given, texts, progress)
        return answer

    def sensitivity(self, *, scatter: Optional[bool] = None, sobol: Optional[bool] = None,
                    of: Optional[Sequence[Named]] = None, points: Optional[int] = None,
                    samples: Optional[int] = None, seed: Optional[int] = None,
                    threads: Optional[int] = None, texts: Optional[Mapping[str, str]] = None,
                    progress: ShownProgress = None) -> results.sensitivity.SensitivityResult:
        """Find the inputs that determine stiffness and its loss.

        Args:
            scatter: also propagate the scatter that the file gives
            sobol: also divide the variance of outputs among the inputs, by Sobol's indices
            of: output of the Sobol study, such as curve.positive.K1; may be repeated; by default
                stiffness and loss of the sum of the members
            points: base points of the Sobol study, a multiple of 16; the drive is evaluated at each
                of them for two more than the inputs
            samples: draws of the Monte Carlo study
            seed: seed of the draws
            threads: number of threads; 0 for all of the machine; the answer does not depend on it
            texts: texts that options name, by their names; an option may also be a pathlib.Path,
                whose file is read
            progress: True for a line of progress, or a function that receives the completed
                fraction
        """
        given: dict[str, Any] = {"scatter": scatter, "sobol": sobol, "of": of, "points": points,
                                 "samples": samples, "seed": seed, "threads": threads}
        answer: results.sensitivity.SensitivityResult = self._run("sensitivity", given, texts, progress)
        return answer

    def reliability(self, *, require: Optional[Sequence[Named]] = None,
                    draws: Optional[int] = None, seed: Optional[int] = None,
                    threads: Optional[int] = None, texts: Optional[Mapping[str, str]] = None,
                    progress: ShownProgress = None) -> results.reliability.ReliabilityResult:
        """Find the probability that scatter breaks a requirement.

        Args:
            require: OUTPUT OP VALUE, where OP is one of >=, >, <=, < and VALUE has a unit; once or
                more
            draws: plain draws; by default 200000 for an output of the sum of the members, 20000 for
                a strength margin and 2000 for any other
            seed: seed of the draws
            threads: number of threads; 0 for all of the machine; the answer does not depend on it
            texts: texts that options name, by their names; an option may also be a pathlib.Path,
                whose file is read
            progress: True for a line of progress, or a function that receives the completed
                fraction
        """
        given: dict[str, Any] = {"require": require, "draws": draws, "seed": seed, "threads": threads}
        answer: results.reliability.ReliabilityResult = self._run("reliability", given, texts, progress)
        return answer

    def sweep(self, *, vary: Optional[Sequence[Named]] = None,
              method: Optional[Literal["as-printed", "repaired", "corrected"]] = None,
              texts: Optional[Mapping[str, str]] = None,
              progress: ShownProgress = None) -> results.sweep.SweepResult:
        """Tabulate all outputs over one or two fields.

        Args:
            vary: PATH=FROM..TO:N[:log], a field and its range with units; once or twice
            method: theory to use
            texts: texts that options name, by their names; an option may also be a pathlib.Path,
                whose file is read
            progress: True for a line of progress, or a function that receives the completed
                fraction
        """
        given: dict[str, Any] = {"vary": vary, "method": method}
        answer: results.sweep.SweepResult = self._run("sweep", given, texts, progress)
        return answer

    def solve(self, vary: Named, target: Named, *,
              method: Optional[Literal["as-printed", "repaired", "corrected"]] = None,
              texts: Optional[Mapping[str, str]] = None,
              progress: ShownProgress = None) -> results.solve.SolveResult:
        """Find the value of a field that gives a wanted output.

        Args:
            vary: PATH[=FROM..TO], the field to find and its search range
            target: OUTPUT=VALUE, with a unit
            method: theory to use
            texts: texts that options name, by their names; an option may also be a pathlib.Path,
                whose file is read
            progress: True for a line of progress, or a function that receives the completed
                fraction
        """
        given: dict[str, Any] = {"vary": vary, "target": target, "method": method}
        answer: results.solve.SolveResult = self._run("solve", given, texts, progress)
        return answer

    def calibrate(self, *, catalogue: Optional[bool] = None, measured: Optional[Named] = None,
                  factors: Optional[Named] = None, predict_ratios: Optional[Named] = None,
                  blank: Optional[Literal["ratio", "size"]] = None, friction: Optional[bool] = None,
                  no_load_torque: Optional[Named] = None, starting_torque: Optional[Named] = None,
                  back_driving_torque: Optional[Named] = None, efficiency: Optional[Named] = None,
                  at_speed: Optional[Named] = None, at_torque: Optional[Named] = None,
                  texts: Optional[Mapping[str, str]] = None,
                  progress: ShownProgress = None) -> results.calibrate.CalibrateResult:
        """Find factors of a drive from its catalogue or measured stiffness.

        Args:
            catalogue: calibrate to K1, K2, K3 of the catalogue's row for this form, length, ratio
                and the nearest size
            measured: calibrate to a measured curve: CSV with the columns torque [N*m] and twist
                [arcmin]
            factors: factors to fit, separated by commas
            predict_ratios: also predict K1, K2, K3 at these ratios of the size, such as 50,80,100,
                or all for the other ratios of the tables, with the error
            blank: with `predict_ratios`, walls of the drives of other ratios: made for the wave of
                each ratio, or of ratio 100 for all ratios of a size
            friction: fit drivetrain.friction to a maker's four values, those below or, with
                `catalogue`, of the row of this size and ratio; in place of factors
            no_load_torque: with `friction`, torque that turns the input at `at_speed` without load,
                a number with its unit
            starting_torque: with `friction`, torque that starts the input without load, a number
                with its unit
            back_driving_torque: with `friction`, torque on the output that starts the free input, a
                number with its unit
            efficiency: with `friction`, efficiency at `at_torque` and `at_speed`, such as 0.77 or
                77 %
            at_speed: with `friction`, speed of the input for no-load torque and efficiency, a
                number with its unit; 2000 rpm if left out
            at_torque: with `friction`, torque on the output for the efficiency, a number with its
                unit; rating.rated_torque if left out
            texts: texts that options name, by their names; an option may also be a pathlib.Path,
                whose file is read
            progress: True for a line of progress, or a function that receives the completed
                fraction
        """
        given: dict[str, Any] = {"catalogue": catalogue, "measured": measured, "factors": factors,
                                 "predict_ratios": predict_ratios, "blank": blank, "friction": friction,
                                 "no_load_torque": no_load_torque, "starting_torque": starting_torque,
                                 "back_driving_torque": back_driving_torque, "efficiency": efficiency,
                                 "at_speed": at_speed, "at_torque": at_torque}
        answer: results.calibrate.CalibrateResult = self._run("calibrate", given, texts, progress)
        return answer
