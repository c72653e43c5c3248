"""Task panel of a solid made by a Python script: the script, its parameters, resolution and preview."""

from .. import scripts
from ..shim import QtWidgets
from ..sources import Source
from ..words import marked, tr
from .frep_panel import FrepPanel
from .script_editor import ScriptEditor

DANGER = marked("A script can do on this computer whatever you can: read, change and delete your files. "
                "Run it only if you trust whoever wrote it.")


class ScriptPanel(FrepPanel):
    """Runs the script whenever it has changed, after the user has agreed to that for the document."""

    def __init__(self, obj):
        self.mistake = None  # of the last run
        super().__init__(obj)
        self.layout.insertWidget(0, self._question())

    def title(self):
        return tr("Python model")

    def editor(self, text):
        made = ScriptEditor(text)
        made.setObjectName("ScriptEditor")
        return made

    def arrows(self):
        return None

    def valid(self, count):
        return tr("The script is run") if self._may_run() else tr("The script is not run")

    # Consent.
    def _question(self):
        """Returns the question whether the document's scripts may run, which disappears once that is agreed."""
        self.question = QtWidgets.QWidget()
        layout = QtWidgets.QVBoxLayout(self.question)
        layout.setContentsMargins(0, 0, 0, 0)
        words = QtWidgets.QLabel(tr(DANGER))
        words.setWordWrap(True)
        self.agree = QtWidgets.QPushButton(tr("Run this document's scripts"))
        self.agree.setToolTip(tr("Until the document is closed, its scripts run whenever they have changed"))
        self.agree.setAutoDefault(False)
        self.agree.clicked.connect(self._agreed)
        layout.addWidget(words)
        layout.addWidget(self.agree)
        self.question.setVisible(not self._may_run())
        return self.question

    def _may_run(self):
        return scripts.may_run(self.document)

    def _agreed(self):
        scripts.agree(self.document)
        self.question.hide()
        self.text.check()

    # Preview.
    def _show(self):
        if self._may_run() or self.written() == self.obj.FormulaOf:
            super()._show()

    def _source(self):
        """Returns the Source of the script, which notes the mistake of its run."""
        script, known = self.written(), self.obj.Formula if self.written() == self.obj.FormulaOf else None
        source = self.obj.Proxy.source_of_text(script, known)

        def make(progress):
            self.mistake = None
            try:
                return source.field(progress)
            except scripts.ScriptError as error:
                self.mistake = error
                raise

        return Source(("script", script), make)

    def _told(self, words, good):
        mistake = self.mistake
        if not good and mistake is not None and str(mistake) == words:
            self.text.tell(mistake)
            self.say(words)
            self.text.message = ""  # the text itself is valid: a parameter may mend it
        else:
            super()._told(words, good)
