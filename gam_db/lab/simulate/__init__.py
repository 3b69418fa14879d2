"""A simulated fleet of robots: joints that visit levels, wear, and send dirty rows, with the truth.

It stands in for industrial data that cannot be given away. It is a stress, not tuned so that any method
wins, and its clock is compressed: hours of it stand for months. Nothing here knows of the indicator.

* ``roles``: which robot fails, which is a control, who shares a program;
* ``program``: the cycle of moves of a robot, and when it does what;
* ``joint``: the signal of one joint; ``wear``: how its fault shows; ``dirt``: what is wrong in its rows;
* ``fleet``: readings and truth of a robot; ``store``: the fleet in a file, robot by robot.
"""
