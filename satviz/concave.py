from .shapes import Polygon, Shape
def parts(shape: Shape):
    return (shape,)
