class Trouble(Exception):
    """Something the user can put right; ends the program with status 2."""
