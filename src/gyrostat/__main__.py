"""Runs the command line: python -m gyrostat."""
import sys

from .cli.parser import main

sys.exit(main())
