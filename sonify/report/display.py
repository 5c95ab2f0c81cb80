"""Display results as text, notebook view and pictures; drawing modules are imported on
demand."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from PIL.Image import Image

    from sonify.result import Result


class ReportDisplay:
    """The `sonify.result.Display` of the report."""

    def text(self, result: "Result") -> str:
        """Return a summary in a few lines of text."""
        from sonify.report.page import summary_text

        return summary_text(result)

    def html(self, result: "Result") -> str:
        """Return a sound player and the verdict on each claim as an HTML fragment."""
        from sonify.report.page import notebook_html

        return notebook_html(result)

    def picture(self, result: "Result", name: str) -> "Image":
        """Return one of the pictures; raise ValueError for an unknown name."""
        from sonify.report.pictures import picture

        return picture(result, name)
