"""Every agent and every run there is, whatever page shows it."""
