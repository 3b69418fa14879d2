"""Parts of a script or a package that can be left out, and the steps of each."""

from collections.abc import Collection, Mapping

from gam_db.settings.parameters import ROBUST, Parameters

#: What may be left out of a script.
PARTS = ("certificate", "curve", "probe")

#: The columns of a certificate that only one part fills.
LEFT_OUT: Mapping[str, tuple[str, ...]] = {
    "curve": ("vectors_needed",),
    "probe": (
        *("usual_low", "usual_middle", "usual_high", "sees", "sees_half_stroke", "sees_frozen"),
        *("sees_faster", "sees_slower", "would_not_see", "blind_reason"),
    ),
}

#: The last steps, and of which part they are.
RESULTS: Mapping[str, str] = {
    "health": "certificate",
    "support_summary": "certificate",
    "certificate": "certificate",
    "probes": "probe",
}


def parts_of(parameters: Parameters, without: Collection[str] | None = None) -> list[str]:
    """Return the parts of a script or a package; see :func:`gam_db.export.script.render`."""
    if without is None:
        is_paper = all(variant.range != ROBUST for variant in parameters.variants())
        without = ("curve", "probe") if is_paper else ()
    return [part for part in PARTS if part not in without and "certificate" not in without]
