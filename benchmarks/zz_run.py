import os,sys
from pathlib import Path
ROOT=Path(__file__).resolve().parents[1]
sys.path[:0]=[os.fspath(ROOT), os.fspath(ROOT/"tests"/"gui")]
from run_in_freecad import run
import tempfile
home=Path(tempfile.mkdtemp())
print(run(ROOT/"benchmarks"/"zz_where.py",[os.fspath(ROOT),"/tmp/x.json",["/srv/parts/"+n for n in sys.argv[1:]]],home,500))
print((home/"freecad.log").read_text(errors="replace")[-6000:])
