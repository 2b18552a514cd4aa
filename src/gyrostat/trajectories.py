"""Motion of a scene, and of what starts close to an equilibrium: the public names."""
from .confirmation import Confirmation, confirm
from .motions import Motion
from .routes import motion

__all__ = ["Confirmation", "Motion", "confirm", "motion"]
