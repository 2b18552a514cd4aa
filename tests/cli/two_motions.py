"""The top and the box of gyrostat motion, by the command and by the library."""
import gyrostat as gs
from gyrostat.trajectories import motion

NUMBERS = ("I1=1", "I3=0.6", "l=0.4", "m0=1")
TOP = ["--potential", "m0*k3", *(f"--set={number}" for number in NUMBERS), "--state",
       "0.3,-0.2,sqrt(2),0.6,0,0.8"]
FREE = ["--potential", "none", *(f"--set={number}" for number in ("I1=1", "I2=2", "I3=5/2", "l=1/4")),
        "--state", "1/3,2,-0.1"]


def the_top(scene, **options):
    return motion(scene, ("0.3", "-0.2", "sqrt(2)", "0.6", 0, "0.8"),
                  dict(number.split("=") for number in NUMBERS), **options)


def the_box():
    return motion(gs.assemble(gs.Gyrostat((1, 2, "5/2"), (0, 0, "1/4"))), ("1/3", 2, "-0.1"))
