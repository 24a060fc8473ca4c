"""What may be wrong with what the report is given."""


class Problem(Exception):
    """One sentence in lower case that says what was found, and what would be right."""

    exit_code = 1


class UsageProblem(Problem):
    """The command line is wrong, and not what it names."""

    exit_code = 2


class EnvironmentProblem(Problem):
    """The machine refused something."""

    exit_code = 3
