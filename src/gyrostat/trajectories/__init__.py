"""The motion of a scene, exact where its model allows, and a verdict held against it.

`models` chooses the smallest model that a scene allows, each a `route`: a body of revolution in U(k3) (`top`;
about any axis a `turned_motion`) or a free body (`free`), both exact; any other scene is `integrated`. A
`motion` answers at any times, in doubles or in more digits (`states_in_digits`): states, attitudes and
angular velocities (`columns`), `librations` of a satellite, rates and what is conserved (`summary`). Times of
any length are reduced in two doubles (`periods`); `elliptic` functions stay exact next to a separatrix, from
angles on the `circle`; many `equidistant` times are interpolated, to the last bits.
`confirmation` disturbs an equilibrium and looks at the `excursions`.
"""
from .confirmation import Confirmation, confirm
from .librations import roll_pitch_yaw
from .models import motion
from .motion import Motion

__all__ = ["Confirmation", "Motion", "confirm", "motion", "roll_pitch_yaw"]
