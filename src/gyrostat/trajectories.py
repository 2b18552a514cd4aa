"""Motion of a scene, and of what starts close to an equilibrium: the public names."""
from .confirmation import Confirmation, confirm
from .motions import Motion, motion

__all__ = ["Confirmation", "Motion", "confirm", "motion"]
