"""Every agent there is, whatever page shows it, and what worlds are called."""
