"""Where a verb writes its results: a file or standard output."""
import sys
from typing import TextIO


class Output:
    """Standard output, in UTF-8 where its own encoding has no λ; or a file, opened when the first text is there."""

    def __init__(self, path: str | None):
        self.path = path
        self.file: TextIO | None = None

    @property
    def on_terminal(self) -> bool:
        return self.path is None and sys.stdout.isatty()

    def __call__(self, text: str) -> None:
        """Write the text, at once."""
        if self.path is not None:
            self.file = self.file or open(self.path, "w", encoding="utf-8")  # noqa: SIM115 (close closes it)
            print(text, end="", flush=True, file=self.file)
            return
        try:
            text.encode(sys.stdout.encoding or "utf-8")
        except UnicodeEncodeError:
            sys.stdout.reconfigure(encoding="utf-8")  # type: ignore[union-attr]
        print(text, end="", flush=True)

    def close(self) -> None:
        if self.file:
            self.file.close()
