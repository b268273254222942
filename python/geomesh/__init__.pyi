from . import bridges as bridges
from . import core as core
from .core.errors import CannotMesh as CannotMesh
from .core.errors import Error as Error
from .core.errors import InternalError as InternalError
from .core.errors import Interrupted as Interrupted
from .core.errors import InvalidInput as InvalidInput
from .core.errors import UsageError as UsageError
from .inputs import read_surfaces as read_surfaces
from .mesh import Curve as Curve
from .mesh import Mesh as Mesh
from .mesh import Point as Point
from .mesh import Region as Region
from .mesh import Surface as Surface
from .mesh import read as read
from .model import Model as Model
from .model import check as check
from .model import run as run
from .tables import Table as Table
from .views import View as View

__version__: str

def register_pyvista() -> None: ...
