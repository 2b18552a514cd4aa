"""The motion of a scene, and a verdict held against it.

`models` chooses the smallest model that a scene allows, a `route`: a body of revolution in U(k3) (`top`;
about any axis `turned`), a free body or gyrostat (`free`), both exact; any other scene is `integrated`. A
`motion` is asked for states (in `digits`), attitudes and what is `conserved` at any times (`columns`; of a
satellite its `librations`), for its `rates` and a `summary`; times of any length are reduced modulo a
period in two doubles (`periods`), `elliptic` functions are those of the complementary parameter.
`confirmation` disturbs an equilibrium and looks at the `excursions`.
"""
from .confirmation import Confirmation, confirm
from .librations import roll_pitch_yaw
from .models import motion
from .motion import Motion

__all__ = ["Confirmation", "Motion", "confirm", "motion", "roll_pitch_yaw"]
