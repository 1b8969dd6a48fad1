# SPDX-License-Identifier: Apache-2.0
"""The result of a command: its evidence, its documents, its plot and its table."""

from __future__ import annotations

import copy
import html
import io
import json
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any, Callable, ClassVar, Mapping, Optional, TypeVar

from . import _library
from ._evidence import Accuracy, Note, Verdict
from .parts import Part, pandas_module

if TYPE_CHECKING:
    import pandas


class Svg(str):
    """A picture as SVG text, which a notebook shows.

    Raises:
        ValueError: if the text is no SVG
    """

    def __new__(cls, text: str) -> "Svg":
        if not text.lstrip().startswith(("<svg", "<?xml")):
            raise ValueError(f"the text is no SVG, it begins with {text[:40]!r}; svg() of an answer gives its picture")
        return super().__new__(cls, text)

    def _repr_svg_(self) -> str:
        return str(self)


class Result(Part):
    """The result of a command with its evidence.

    The fields of the result are attributes.  In addition, each result has `usable`,
    `unusable_because`, `verdict`, `notes`, `equations`, `accuracies` and `provenance`.

    >>> import strainwave as sw
    >>> answer = sw.read("cracked_size25.toml").stiffness()
    >>> answer.verdict.judgement
    'cannot be told'
    >>> answer.documents
    ('json', 'text', 'csv', 'plot', 'fad')
    """

    command: ClassVar[str]
    documents: ClassVar[tuple[str, ...]]  # names for document()

    _envelope: dict[str, Any]
    _answer: Optional[_library.Handle]
    _again: Callable[[], _library.Handle]

    @classmethod
    def _from(cls: type["ResultType"], answer: _library.Handle,
              again: Callable[[], _library.Handle]) -> "ResultType":
        made = cls._from_envelope(json.loads(_library.document(answer, "json")))
        made.__dict__["_answer"] = answer
        made.__dict__["_again"] = again
        return made

    @classmethod
    def _from_envelope(cls: type["ResultType"], envelope: dict[str, Any]) -> "ResultType":
        made = cls._of(envelope["result"], envelope["unusable_because"])
        made.__dict__["_envelope"] = envelope
        return made

    @property
    def usable(self) -> bool:
        """Whether the numbers may be used."""
        return bool(self._envelope["usable"])

    @property
    def unusable_because(self) -> str:
        """Why the numbers must not be used; empty if they may be used."""
        return str(self._envelope["unusable_because"])

    @property
    def verdict(self) -> Verdict:
        """Whether the answer may be relied on."""
        return Verdict._of(self._envelope["verdict"], "")

    @property
    def notes(self) -> tuple[Note, ...]:
        """Remarks on the validity."""
        return tuple(Note._of(note, "") for note in self._envelope["notes"])

    @property
    def equations(self) -> tuple[str, ...]:
        """Tags of the equations of the theory manual that were used."""
        return tuple(self._envelope["equations"])

    @property
    def accuracies(self) -> tuple[Accuracy, ...]:
        """The accuracy of each member and crack."""
        return tuple(Accuracy._of(one, "") for one in self._envelope["accuracies"])

    @property
    def provenance(self) -> dict[str, Any]:
        """Program, version, options, and the drive with units."""
        return copy.deepcopy(self._envelope["provenance"])

    def envelope(self) -> dict[str, Any]:
        """Result and evidence as JSON states them (strainwave-result/1)."""
        return copy.deepcopy(self._envelope)

    def document(self, name: str) -> str:
        """A document of the answer, such as "text", "json", "csv" or "plot"; `documents` names all.

        >>> import strainwave as sw
        >>> sw.units().document("json")[:1]
        '{'

        Raises:
            OptionError: if the command does not make this document, or the document needs an option
        """
        answer = self.__dict__.get("_answer")
        if answer is None:
            answer = self.__dict__["_answer"] = self._again()
        return _library.document(answer, name)

    def save(self, path: _library.PathLike, name: Optional[str] = None) -> None:
        """Writes a document into a file.

        Args:
            name: name of the document; if left out, the ending of the path decides: .json, .txt,
                .csv, .md, .svg (the plot), .html, .toml
        """
        chosen = name if name is not None else self._document_for(Path(path).suffix)
        content = self.document(chosen)
        Path(path).write_text(content, encoding="utf-8")

    def _document_for(self, suffix: str) -> str:
        by_suffix = {".json": ("json",), ".txt": ("text",), ".csv": ("csv",), ".md": ("markdown",),
                     ".svg": ("plot", "svg"), ".html": ("html",), ".toml": ("toml",)}
        for name in by_suffix.get(suffix, ()):
            if name in self.documents:
                return name
        raise ValueError(f"{self.command} makes no document for a file that ends in {suffix!r}; "
                         f"pass the name of one of its documents: {', '.join(self.documents)}")

    def svg(self) -> Svg:
        """The plot of the answer as SVG; a notebook shows it.

        Raises:
            ValueError: if the command makes no plot
        """
        return Svg(self.document(self._document_for(".svg")))

    def plot(self, ax: Any = None) -> Any:
        """Draws the plot of the answer by matplotlib, with the numbers, labels and colours of svg().

        >>> import matplotlib, strainwave as sw
        >>> matplotlib.use("agg")  # draws without a window
        >>> sw.read("cracked_size25.toml").torsion().plot()[0].get_xlabel()
        'torque T at the output [N·m]'

        Args:
            ax: axes, one for each panel of the plot; None: new ones

        Returns:
            the axes, one alone if the plot has one panel

        Raises:
            ValueError: if the command makes no plot, or the number of axes is wrong
            ImportError: if matplotlib is not installed
        """
        from .plots import draw

        return draw(self.svg(), ax)

    def to_frame(self) -> "pandas.DataFrame":
        """The table of the answer (its CSV) as a pandas.DataFrame.

        `attrs["units"]` names the units, `attrs["unusable_because"]` says why the numbers must not
        be used (empty if they may be used), and `attrs["verdict"]` is the verdict as a dict.

        >>> import strainwave as sw
        >>> frame = sw.read("cracked_size25.toml").torsion().to_frame()
        >>> frame.columns[0], frame.attrs["units"]["torque"]
        ('torque', 'N*m')

        Raises:
            ValueError: if the command makes no table
        """
        if "csv" not in self.documents:
            raise ValueError(f"{self.command} makes no table; to_dict() gives its values")
        pandas = pandas_module()
        frame = pandas.read_csv(io.StringIO(self.document("csv")), comment="#")
        units, names = {}, []
        for column in frame.columns:
            name, _, rest = str(column).partition(" [")
            name = name if rest.endswith("]") else str(column)
            names.append(name)
            units[name] = rest[:-1] if rest.endswith("]") else "1"
        frame.columns = pandas.Index(names)
        frame.attrs["units"] = units
        frame.attrs["unusable_because"] = self.unusable_because
        frame.attrs["verdict"] = self.verdict.to_dict()
        return frame

    def __str__(self) -> str:
        return self.document("text") if "text" in self.documents else repr(self)

    def __repr__(self) -> str:
        state = self.verdict.judgement if self.usable else f"not usable: {self.unusable_because}"
        return f"<{type(self).__name__} {state}>"

    def _repr_html_(self) -> str:
        verdict = self.verdict
        head = (f"<p><strong>Verdict: {html.escape(verdict.judgement)}.</strong> "
                f"{html.escape(verdict.reason)}</p>")
        if not self.usable:
            head = ("<p><strong>The numbers must not be used: "
                    f"{html.escape(self.unusable_because)}</strong></p>" + head)
        body = f"<pre>{html.escape(self.document('text'))}</pre>" if "text" in self.documents else ""
        return head + body + self._links()

    def _links(self) -> str:
        """Links of the equations and notes into the rendered documentation, whose address the
        environment variable STRAINWAVE_SITE names; empty without this variable."""
        site = os.environ.get("STRAINWAVE_SITE", "")
        if not site:
            return ""

        def linked(page: str, name: str) -> str:
            address = html.escape(f"{site.rstrip('/')}/{page}#{name}")
            return f'<a href="{address}">{html.escape(name)}</a>'

        codes = sorted({note.code for note in self.notes})
        rows = {"Equations": [linked("docs/theory/manual.html", tag) for tag in self.equations],
                "Notes": [linked("notes.html", code) for code in codes]}
        return "".join(f"<p>{title}: {', '.join(links)}</p>" for title, links in rows.items() if links)

    def __getstate__(self) -> dict[str, Any]:
        """Everything but the pointer of the library."""
        return {"_envelope": self._envelope, "_again": self._again}

    def __setstate__(self, state: Mapping[str, Any]) -> None:
        envelope = state["_envelope"]
        made = type(self)._from_envelope(envelope)
        self.__dict__.update(made.__dict__)
        self.__dict__["_again"] = state["_again"]


ResultType = TypeVar("ResultType", bound=Result)
