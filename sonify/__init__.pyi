__version__: str

from .entry_points import run as run
from .fitting.result import Fits as Fits
from .fitting.result import fit as fit
from .hearing.recording import Heard as Heard
from .hearing.recording import listen as listen
from .hearing.recording_errors import RecordingError as RecordingError
from .pipeline import solve as solve
from .pipeline import write as write
from .report.write import summary as summary
from .result import Result as Result
from .scene import Audio as Audio
from .scene import Scene as Scene
from .scene import load_scene as load_scene
from .scene import shipped_scenes as shipped_scenes
from .scene_errors import SceneError as SceneError
from .sweeps.command import sweep as sweep
