"""Requirements on every picture: labelled axes, and legends and titles clear of the data."""

from itertools import pairwise

from matplotlib.figure import Figure

from sonify.report import figure


def figures(monkeypatch) -> list[Figure]:
    """Return a list that collects every figure created from now on."""
    made = []

    class Kept(Figure):
        def __init__(self, *arguments, **options):
            super().__init__(*arguments, **options)
            made.append(self)

    monkeypatch.setattr(figure, "Figure", Kept)
    return made


def assert_readable(one):
    """Assert that every panel has labelled axes and that its legend and title overlap neither data
    nor each other."""
    for panel in one.axes:
        bar = panel.get_label() == "<colorbar>"
        assert panel.get_ylabel()
        assert panel.get_xlabel() or bar
        label = panel.yaxis.label.get_window_extent()
        numbers = [
            text.get_window_extent()
            for text in panel.get_yticklabels()
            if text.get_text()
        ]
        inside = [
            number
            for number in numbers
            if panel.bbox.y0 - 1 <= (number.y0 + number.y1) / 2 <= panel.bbox.y1 + 1
        ]
        assert not any(label.overlaps(number) for number in inside), (
            f"{panel.get_ylabel()!r} over a number"
        )
        words = panel.get_xticklabels() + panel.get_xticklabels(minor=True)
        begins = sorted(
            (text.get_window_extent().x0, text.get_window_extent().x1)
            for text in words
            if text.get_text()
        )
        within = [
            place for place in begins if panel.bbox.x0 - 40 < place[0] < panel.bbox.x1
        ]
        assert all(a[1] <= b[0] for a, b in pairwise(within)), (
            "numbers of an axis over one another"
        )
        legend = panel.get_legend()
        if legend is None:
            continue
        place = legend.get_window_extent()
        data = panel.get_window_extent()
        assert place.y0 >= data.y1 - 0.5 or place.x0 >= data.x1 - 0.5, (
            "a legend over data"
        )
        for text in [*panel.texts, panel._left_title]:
            if text.get_text():
                assert not place.overlaps(text.get_window_extent()), (
                    f"{text.get_text()!r} under a legend"
                )
