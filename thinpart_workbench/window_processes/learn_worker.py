"""The process that learns a profile from labels for the window.

It handles requests in their order until the end of its input: ``{"learn": arguments of `learn`}`` is answered by
``progress`` (``stage``, ``done``, ``total``) and ``learned``, the attributes of a `LearnedProfile`;
``{"save": {"content", "output", "overwrite"}}`` by ``saved``, the path. What cannot be done is answered by ``refused``, a
sentence.
"""

from ..api.learning import learn, save_profile
from ..core.errors import ThinPartError
from .json_lines import JsonLines


def main():
    """Handle requests until the parent closes the pipe."""
    parent = JsonLines()
    with parent.reporting_failures():
        while (request := parent.incoming.get()) is not None:
            try:
                _answer(parent, **request)
            except ThinPartError as error:
                parent.send(refused=str(error))
    parent.end()


def _answer(parent, learn=None, save=None):
    if save is not None:
        save_profile(**save)
        parent.send(saved=save["output"])
    else:
        parent.send(learned=_learned(parent, learn))


def _learned(parent, arguments):
    def report(stage, done, total):
        parent.send(progress={"stage": stage, "done": done, "total": total})

    learned = learn(**arguments, report=report)
    return {**learned.as_dict(), "is_better": learned.is_better}


if __name__ == "__main__":
    main()
