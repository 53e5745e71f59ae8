"""Keys that Blender has nothing on in a 3D Viewport, in Object and in Pose mode."""
HOLD = 'F'  # held for the pen
PIE = 'V'  # the menu of the tool
