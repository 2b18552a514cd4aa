"""What textbooks derive of tops and free bodies without the bracket.

`attitude` has Euler's angles and their rates, `quaternion` that of a rotation, `lagrangian` the Lagrangian in
the angles and the effective potential, `free_body` Euler's equations with a torque and the limits and the
period of a free motion, `free_precession` the rates and the cones of a free body of revolution.
"""
