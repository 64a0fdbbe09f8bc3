"""Check a reader's collision function: find the smallest scene where it is wrong, and the mistake it behaves like.

`checked.check` is the public function.  All but the picture needs the standard library only.
"""
