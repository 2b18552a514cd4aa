"""Every other motion, integrated.

`methods` (heyoka's Taylor method, DOP853) and `motion`, computed twice and watched.
"""
