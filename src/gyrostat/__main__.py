"""python -m gyrostat."""
import sys

from .cli import main

sys.exit(main())
