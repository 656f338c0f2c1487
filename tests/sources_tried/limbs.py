"""From a posture to the orientations of sensors on the arms, and to the angles in which devices tell them.

A quaternion is (4,): x, y, z, w; it turns vectors of the sensor into vectors of the room.
"""

import math

import numpy as np

from app.hardware.shirt.orientation_sensors.orientation import exponential, product

ARMS = ("right_upper_arm", "left_upper_arm", "right_forearm", "left_forearm")
"""The parts of the body that wear a sensor."""

# Rotation vectors (rad) of full movements, each about another axis; no sensor turns so far that its angles would jump.
SHOULDER = np.array((0.0, 0.5, 0.0))
SHOULDER_UP = np.array((0.0, 0.0, 0.2))
ELBOW = np.array((0.8, 0.0, 0.0))


def orientations(levels, random, noise):
    """Return the orientation of each of ARMS.

    Parameters
    ----------
    levels : the levels of the joints, 0 (rest) to 1 (full movement), by name
    random : generator of the sensors' noise
    noise : its standard deviation, rad
    """
    found = {}
    for side in ("right", "left"):
        shoulder = levels[f"{side}_shoulder"] * SHOULDER + levels[f"{side}_shoulder_up"] * SHOULDER_UP
        upper_arm = exponential(shoulder)
        found[f"{side}_upper_arm"] = upper_arm
        found[f"{side}_forearm"] = product(upper_arm, exponential(levels[f"{side}_elbow"] * ELBOW))
    return {part: product(found[part], exponential(random.normal(0.0, noise, 3))) for part in ARMS}


def device_angles_deg(q):
    """Return alpha, beta, gamma of the W3C's Device Orientation, as `device_orientation` takes them (degrees)."""
    x, y, z, w = q
    alpha = math.atan2(2 * (w * z - x * y), 1 - 2 * (x * x + z * z))
    beta = math.asin(max(-1.0, min(1.0, 2 * (y * z + w * x))))
    gamma = math.atan2(2 * (w * y - x * z), 1 - 2 * (x * x + y * y))
    return math.degrees(alpha) % 360.0, math.degrees(beta), math.degrees(gamma)


def sensor_angles_deg(q):
    """Return roll, pitch, yaw, as `sensor_orientation` takes them (degrees)."""
    x, y, z, w = q
    roll = math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y))
    pitch = math.asin(max(-1.0, min(1.0, 2 * (w * y - z * x))))
    yaw = math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))
    return math.degrees(roll), math.degrees(pitch), math.degrees(yaw)
