"""``python -m laplace_core``."""

import sys

from laplace_core.cli import main

sys.exit(main())
