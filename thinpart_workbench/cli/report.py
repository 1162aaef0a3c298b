"""``thinpart report``: a page per part, with pictures, and an overview."""

from contextlib import closing

from ..core.criteria import load_profile
from ..workflow.analyse_file import FileTask
from ..workflow.find_documents import common_folder
from ..workflow.report_folder import ReportFolder
from ..workflow.run_control import RunControl
from ..workflow.run_plan import info_place, plan_run
from .control_input import listen
from .file_run import analyse_planned
from .run_options import (
    add_choice, add_conversation, add_info_place, add_limits, add_measuring, info_tree, limits_of,
    search_documents, settings_of,
)
from .run_report import new_report, standard_output
from .stop_signals import stop_signals


def add_arguments(parser):
    """Declare the options."""
    add_choice(parser)
    parser.add_argument("-o", "--output", metavar="DIR", required=True,
                        help="folder of the report: a new or an empty one, or that of an earlier report, "
                             "whose pages are replaced")
    add_info_place(parser, "take notes that are kept with the parts from the info files in this folder "
                           "instead of those beside the parts")
    add_measuring(parser)
    add_limits(parser)
    add_conversation(parser)


def run(options):
    """Make the report and return the exit status."""
    report = new_report(options.json)
    control = RunControl(report.state)
    profile = load_profile(options.profile).content
    with stop_signals(control) as undisturbed, report:
        if options.control:
            listen(control)
        documents, failures = search_documents(options, control, report)
        tree = common_folder(options.paths)
        folder = ReportFolder(options.output, tree, profile, info_place(options.info_dir, info_tree(options)))
        with closing(folder):
            new_task = _new_task(options, profile, folder)
            planned = plan_run(documents, new_task, lambda file: None, options.jobs)
            failed = analyse_planned(planned, failures, limits_of(options), control, report, folder.add)
            with undisturbed():
                folder.finish()
    if not options.json:
        with standard_output() as stream:
            stream.write(f"{folder.overview}\n")
    return 1 if failed else 0


def _new_task(options, profile, folder):
    settings = settings_of(options)
    return lambda file, info: FileTask(file, info, settings, profile, pages=folder.pages_for(file))
