"""Pictures of models that lie inside the page, by Pillow."""
import base64
import io

from PIL import Image

from .problems import Problem

# Widths and qualities that are tried, best first.
TRIALS = [(960, 80), (880, 78), (800, 76), (720, 76), (640, 74), (560, 74), (480, 72), (480, 50), (400, 60), (400, 45), (320, 60),
          (320, 45), (320, 30), (240, 40), (160, 60)]
MOST_HEIGHT = 2048


def read_picture(path):
    try:
        with Image.open(path) as picture:
            return picture.convert("RGB")
    except Exception as error:  # Whatever Pillow's many decoders may raise.
        raise Problem(f"the picture '{path}' cannot be read: {getattr(error, 'strerror', None) or error}") from error


def shrunk(picture, width):
    """The picture at most so wide; a pixel is the mean of what it was."""
    if picture.width <= width:
        return picture
    return picture.resize((width, max(1, picture.height * width // picture.width)), Image.Resampling.BOX)


def to_address(picture, quality):
    file = io.BytesIO()
    picture.save(file, "JPEG", quality=quality, optimize=True)
    return "data:image/jpeg;base64," + base64.b64encode(file.getvalue()).decode()


def thumbnail(path, most):
    """A picture file as a data: address of at most so many characters, shrunk as far as that takes."""
    picture = read_picture(path)
    for width, quality in TRIALS:
        small = shrunk(picture, width)
        if small.height <= MOST_HEIGHT and len(address := to_address(small, quality)) <= most:
            return address
    raise Problem(f"the picture '{path}' cannot be made as small as the report wants it")
