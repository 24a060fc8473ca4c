"""What an input tells of itself."""
import warnings

from . import _library as c


class InputWarning(UserWarning):
    """What of a file was left out, or taken otherwise than it may be meant: a sentence of the tools."""

    __module__ = "voxc"


class Told:
    """Sentences of the library, or of the program in its place, as they come."""

    def __init__(self):
        self.warnings, self.notes = [], []
        self.functions = [c.SENTENCE(lambda _, sentence, of=of: of.append(sentence.decode(errors="replace")))
                          for of in (self.warnings, self.notes)]
        self.report = c.InputReport(*self.functions, None)

    def read(self, text):
        """Takes the lines that the program wrote, once where it opened a file twice."""
        for line in text.splitlines():
            for mark, of in (("voxc: warning: ", self.warnings), ("voxc: note: ", self.notes)):
                if line.startswith(mark) and line.removeprefix(mark) not in of:
                    of.append(line.removeprefix(mark))

    def warn(self, depth):
        """An InputWarning for each warning, as of the caller so many calls up."""
        for sentence in self.warnings:
            warnings.warn(sentence, InputWarning, stacklevel=depth + 1)
