"""FreeCAD's start-up script: where the time of Show thickness goes."""
import json, os, sys, time, traceback
def main():
    root, output, files = json.loads(os.environ["THINPART_GUI_ARGUMENTS"])
    try:
        sys.path[:0] = [root, os.path.join(root, "tests"), os.path.join(root, "tests", "gui")]
        import FreeCAD as App, FreeCADGui as Gui, Part
        import window_actions as window
        Gui.activateWorkbench("ThinPartWorkbench"); window.settle(2500)
        from thinpart_workbench.gui.processes import snapshot_job, document_analysis
        from thinpart_workbench.gui.thickness import measurement
        out=sys.__stderr__
        T0=[0]
        def mark(what): print("   %.2f %s"%(time.perf_counter()-T0[0],what),file=out,flush=True)
        def wrap(cls,name):
            old=getattr(cls,name)
            def f(self,*a,**k):
                mark("begin "+name)
                try: return old(self,*a,**k)
                finally: mark("end "+name)
            setattr(cls,name,f)
        wrap(snapshot_job.SnapshotJob,"start")
        wrap(measurement.ThicknessMeasurement,"start_selected")
        wrap(measurement.ThicknessMeasurement,"_finish")
        wrap(measurement.ThicknessMeasurement,"_on_mapped")
        last=[None]
        oldm=document_analysis.DocumentAnalysis.on_message
        def onm(self,m):
            k=next(iter(m)); k=(k,m[k].get("stage")) if k=="progress" else (k,)
            if k!=last[0]: last[0]=k; mark("message %s"%(k,))
            return oldm(self,m)
        document_analysis.DocumentAnalysis.on_message=onm
        for f in files:
            if f.lower().endswith("fcstd"): document=App.openDocument(f)
            else:
                document=App.newDocument("Doc"); Part.insert(f,document.Name)
            Gui.SendMsgToActiveView("ViewFit"); window.settle(3000)
            T0[0]=time.perf_counter(); print(os.path.basename(f),file=out,flush=True)
            window.show_thickness()
            mark("shown"); window.settle(200)
            App.closeDocument(document.Name); window.settle(3000)
    except BaseException: traceback.print_exc(file=sys.__stderr__)
    finally: os._exit(0)
from PySide import QtCore
QtCore.QTimer.singleShot(0, main)
