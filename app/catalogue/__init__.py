"""Every agent there is, whatever page shows it, and what worlds, rules and observations are called."""
