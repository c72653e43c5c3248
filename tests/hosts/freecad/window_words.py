"""Runs inside FreeCAD's window: the workbench in German, and FreeCAD's What's This help on its commands."""

import FreeCADGui
import pytest
from panels import Button, QtWidgets, document, edit, frep, panels
from window import live, press, shot, wait

from fieldfab_workbench import kernel_messages, mistakes, part_files, words
from fieldfab_workbench.commands import solids
from fieldfab_workbench.objects import cam_operation, cam_setup, cam_tool, combine
from fieldfab_workbench.objects import solid as solid_objects
from fieldfab_workbench.panels import operation_form
from fieldfab_workbench.shim import QtCore, QtGui


@pytest.fixture
def german(document):
    FreeCADGui.setLocale("German")
    live(0.3)
    yield document
    FreeCADGui.setLocale("English")
    live(0.3)
    assert words.tr("Stock") == "Stock"


def seen(kind, text):
    return [widget for widget in FreeCADGui.getMainWindow().findChildren(kind)
            if widget.isVisible() and widget.text() == text]


def action_of(command):
    return FreeCADGui.Command.get(command).getAction()[0]


def test_menus_tools_and_tips_are_german(german):
    menus = FreeCADGui.getMainWindow().menuBar().findChildren(QtWidgets.QMenu)
    [menu] = [menu for menu in menus if menu.title() == "Fieldfab"]
    texts = [action.text() for each in (menu, *menu.findChildren(QtWidgets.QMenu)) for action in each.actions()]
    for text in ("Neuer F-Rep-Körper", "Vereinigung", "Gitterfüllung", "Neuer CAM-Job", "Beispiele",
                 "Prüfen und austauschen", "Auf der Startseite zeigen"):
        assert text in texts
    union = action_of("Fieldfab_Union")
    assert ("Die ausgewählten Körper vereinigen" in union.toolTip()
            and union.statusTip() == "Die ausgewählten Körper vereinigen")
    assert "Macht einen Körper aus zweien oder mehr" in union.whatsThis()
    assert solids.COMMANDS["Fieldfab_Union"].title == "Vereinigung"
    bars = {bar.windowTitle() for bar in FreeCADGui.getMainWindow().findChildren(QtWidgets.QToolBar) if bar.isVisible()}
    assert {"Prüfen und austauschen", "Fieldfab Entwurf"} <= bars
    menu.popup(FreeCADGui.getMainWindow().mapToGlobal(QtCore.QPoint(300, 20)))
    shot("german_menu")
    menu.close()


def test_panels_are_german_and_keep_what_documents_hold(german):
    part = frep(german, "difference(box(20, 20, 12), sphere(r = 7))", 1)
    edit(part)
    wait(lambda: seen(QtWidgets.QPushButton, "Form einfügen …"), what="the panel of an f-rep solid")
    assert seen(QtWidgets.QLabel, "Kleinste Zelle")
    shot("german_frep")
    press(Button.Cancel)

    setup = cam_setup.create(german, part)
    cam_tool.add(setup, {"diameter": 6, "shape": "ball", "name": "Kugel"})
    cam_operation.add(setup, "rough")
    edit(setup)
    wait(lambda: seen(QtWidgets.QPushButton, "Planen"), what="the panel of a set-up")
    assert seen(QtWidgets.QToolButton, "Rohteil") and seen(QtWidgets.QToolButton, "Werkzeuge")
    boxes = [box for box in FreeCADGui.getMainWindow().findChildren(QtWidgets.QComboBox) if box.findText("Ecke") >= 0]
    boxes[0].setCurrentIndex(boxes[0].findText("Ecke"))
    boxes[0].activated.emit(boxes[0].currentIndex())
    assert setup.Zero == "corner"
    shot("german_setup")
    press(Button.Cancel)


def test_what_the_kernel_says_is_german(german, panels):
    """Names, tool tips and values of the kernel's settings; what is stored stays English."""
    setup = cam_setup.create(german, frep(german, "box(20, 20, 12)", 1))
    cam_tool.add(setup, {"diameter": 6, "shape": "ball", "name": "Kugel"})
    finish = cam_operation.add(setup, "finish")
    edit(setup)
    assert [panels[-1].machine.itemText(panels[-1].machine.findData(name)) for name in ("linuxcnc", "shopbot5")] == [
        "LinuxCNC-Fräse", "ShopBot mit fünf Achsen"]
    assert "G-Code für LinuxCNC: drei Achsen" in panels[-1].limits.text()
    assert {"Schruppen", "V-Gravur", "Gewindefräsen"} <= {
        action.text() for action in panels[-1].add_button.menu().actions()}
    press(Button.Cancel)
    edit(finish)
    [form] = [widget for widget in FreeCADGui.getMainWindow().findChildren(operation_form.OperationForm)
              if widget.isVisible()]
    assert form.type.currentText() == "Schlichten" and form.boxes["finish"].button.text() == "Schlichten"
    pattern = form.rows["finish"].rows["pattern"]
    assert pattern.label.text() == "Muster" and pattern.label.toolTip() == "Muster der Bahnen"
    assert pattern.editor.currentText() == "Zeilen (Vorgabe)"
    assert form.rows["finish"].rows["stepover"].editor.placeholderText() == "0.1 Durchmesser"
    pattern.editor.setCurrentIndex(pattern.editor.findText("Spirale"))
    pattern.editor.activated.emit(pattern.editor.currentIndex())
    assert finish.Pattern == "spiral"
    assert form.rows["finish"].rows["skip_air"].label.text() == "Luftschnitte auslassen"
    shot("german_operation")
    press(Button.Cancel)


def test_choices_of_a_property_panel_are_german(german, panels):
    both = [frep(german, text, 1) for text in ("box(20, 20, 12)", "sphere(r = 9)")]
    made = solid_objects.create(combine.Combine, german)
    made.Sources = both
    german.recompute()
    edit(made)
    panel = panels[-1]
    labels = [panel.rows.labelForField(panel.rows.itemAt(row, QtWidgets.QFormLayout.FieldRole).widget()).text()
              for row in range(panel.rows.rowCount())]
    assert labels[0] == "Operation" and "Ausgangskörper" in labels
    box = panel.rows.itemAt(0, QtWidgets.QFormLayout.FieldRole).widget()
    assert box.currentText() == "Vereinigung" and box.currentData() == "Union"
    box.setCurrentIndex(box.findText("Differenz"))
    box.activated.emit(box.currentIndex())
    live(0.2)
    assert made.Operation == "Difference"
    shot("german_combine")
    press(Button.Ok)
    assert made.isValid() and made.Operation == "Difference"


def test_messages_are_german(german):
    made = solid_objects.create(combine.Combine, german)
    german.recompute()
    assert "mindestens zwei Ausgangskörper wählen" in made.getStatusString()


def test_messages_of_the_kernel_are_german(german, panels, tmp_path):
    for english, expected in (
            ("part.stl: holds no triangles", "part.stl: enthält keine Dreiecke"),
            ("Halter: 'box' takes at most 3 arguments", "Halter: 'box' nimmt höchstens 3 Argumente"),
            ("unknown function 'bocks'; did you mean 'box'?", "unbekannte Funktion 'bocks'; meinten Sie 'box'?"),
            ("line 3: S12 in a block that has no use for it is passed over",
             "Zeile 3: S12 in einem Satz, der es nicht verwendet, wird übergangen"),
            ("sharpening edges", "Kanten werden geschärft"),
            ("{{a}}.frep: holds no triangles", "{{a}}.frep: enthält keine Dreiecke"),
            ("machine: the template go uses {x}, which has no value",
             "machine: die Vorlage go verwendet {x}, das keinen Wert hat"),
            ("Halter", "Halter")):
        assert kernel_messages.translated(english) == expected

    damaged = tmp_path / "damaged.stl"
    damaged.write_bytes(b"solid nothing\nendsolid nothing\n")
    with pytest.raises(ValueError) as raised:
        mistakes.in_a_line(part_files.insert)(str(damaged), german.Name, "damaged")
    assert "enthält keine Dreiecke" in str(raised.value)

    part = frep(german, "box(20, 20, 12)", 1)
    edit(part)
    panels[-1].text.setPlainText("sphre(r = 12)")
    wait(lambda: "unbekannte Funktion" in panels[-1].message.text(), what="the mistake in German")
    assert "meinten Sie" in panels[-1].message.text(), panels[-1].message.text()
    shot("german_mistake")
    press(Button.Cancel)

    setup = cam_setup.create(german, part)
    cam_tool.add(setup, {"diameter": 6, "shape": "flat"})
    operation = cam_operation.add(setup, "rough")
    operation.Stepdown = 5
    cam_operation.add(setup, "drill")
    assert [setup.Label, *(each.Label for each in (*setup.Tools, *setup.Operations))] == [
        "CAM-Job", "Schaftfräser 6 mm", "Schruppen", "Bohren"]
    edit(setup)
    panels[-1].plan_button.click()
    wait(lambda: "keine runden Bohrungen" in panels[-1].message.text(), what="the planner's error")
    assert panels[-1].message.text() == "Bohren: das Teil hat keine runden Bohrungen bis 6.3 mm"
    shot("german_plan")
    press(Button.Cancel)


def test_the_property_editor_is_german(german):
    part = frep(german, "box(20, 20, 12)", 1)
    assert {"Zellgröße", "Formel", "Größter Fehler"} <= properties_shown(part)
    setup = cam_setup.create(german, part)
    assert {"Luftschnitte auslassen", "Muster", "Bahnabstand"} <= properties_shown(cam_operation.add(setup, "finish"))


def properties_shown(obj):
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(obj)
    live(0.5)
    shown = set()
    for view in FreeCADGui.getMainWindow().findChildren(QtWidgets.QTreeView):
        model = view.model()
        if model is None or model.metaObject().className() != "Gui::PropertyEditor::PropertyModel":
            continue
        for group in range(model.rowCount()):
            top = model.index(group, 0)
            shown |= {str(model.index(row, 0, top).data()) for row in range(model.rowCount(top))}
    return shown


def test_whats_this_is_shown(document):
    """Same effect as Shift+F1 and a click on a tool."""
    [button] = [bar.widgetForAction(action_of("Fieldfab_Union"))
                for bar in FreeCADGui.getMainWindow().findChildren(QtWidgets.QToolBar)
                if bar.widgetForAction(action_of("Fieldfab_Union"))]
    middle = button.rect().center()
    QtWidgets.QApplication.sendEvent(button,
                                     QtGui.QHelpEvent(QtCore.QEvent.WhatsThis, middle, button.mapToGlobal(middle)))
    live(0.3)
    boxes = [widget for widget in QtWidgets.QApplication.topLevelWidgets()
             if widget.metaObject().className() == "QWhatsThat" and widget.isVisible()]
    shot("whats_this")
    QtWidgets.QWhatsThis.hideText()
    assert len(boxes) == 1
    assert "Makes one solid of two or more" in button.defaultAction().whatsThis()
