"""One look at a subject: its study from the caches, the lens with its verdict, artefacts and downloads."""
