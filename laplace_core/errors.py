"""The one exception a user may cause."""


class InputError(ValueError):
    """Bad input from outside: its message is one sentence that names the entry and the fix.

    The command line prints it and exits with 2; the app shows it as a note.
    Programming errors are ordinary exceptions and stay loud.
    """
