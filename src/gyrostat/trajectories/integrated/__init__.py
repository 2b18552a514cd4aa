"""The motion of any other scene, integrated twice and compared.

`integrators` are heyoka's Taylor method and DOP853; `integrated_motion` runs one and estimates its error.
"""
