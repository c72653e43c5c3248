<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Kind of operation</source>
        <translation>Art der Operation</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Tool of the operation</source>
        <translation>Werkzeug der Operation</translation>
    </message>
    <message>
        <source>Active</source>
        <translation>Aktiv</translation>
    </message>
    <message>
        <source>Include the operation in the program</source>
        <translation>Die Operation ins Programm aufnehmen</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Werkstück</translation>
    </message>
    <message>
        <source>Solid to be machined</source>
        <translation>Körper, der gefertigt werden soll</translation>
    </message>
    <message>
        <source>Zero</source>
        <translation>Nullpunkt</translation>
    </message>
    <message>
        <source>Zero of the program: that of the model, the corner or centre of the part's top, or a point</source>
        <translation>Nullpunkt des Programms: der des Modells, die Ecke oder Mitte der Oberseite des Teils oder ein Punkt</translation>
    </message>
    <message>
        <source>Zero Point</source>
        <translation>Nullpunkt</translation>
    </message>
    <message>
        <source>Zero of the program where that is a point, in the document's coordinates</source>
        <translation>Nullpunkt des Programms, wenn er ein Punkt ist, in den Koordinaten des Dokuments</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Machine that the program is written for</source>
        <translation>Maschine, für die das Programm geschrieben wird</translation>
    </message>
    <message>
        <source>Stock From</source>
        <translation>Rohteil aus</translation>
    </message>
    <message>
        <source>Size of the stock: margins around the part, a box, or the bounding box of an object</source>
        <translation>Maße des Rohteils: Zugaben um das Werkstück, ein Quader oder der Hüllquader eines Objekts</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Zugabe seitlich</translation>
    </message>
    <message>
        <source>Margin at the sides of the part</source>
        <translation>Zugabe an den Seiten des Werkstücks</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Zugabe oben</translation>
    </message>
    <message>
        <source>Margin above the part</source>
        <translation>Zugabe über dem Werkstück</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Thickness of the stock from its top; 0: down to the lowest point of the part</source>
        <translation>Dicke des Rohteils von seiner Oberseite an; 0: bis zum tiefsten Punkt des Werkstücks</translation>
    </message>
    <message>
        <source>Stock Lower</source>
        <translation>Rohteil untere Ecke</translation>
    </message>
    <message>
        <source>Lower corner of the stock, in the document's coordinates</source>
        <translation>Untere Ecke des Rohteils, in den Koordinaten des Dokuments</translation>
    </message>
    <message>
        <source>Stock Upper</source>
        <translation>Rohteil obere Ecke</translation>
    </message>
    <message>
        <source>Upper corner of the stock, in the document's coordinates</source>
        <translation>Obere Ecke des Rohteils, in den Koordinaten des Dokuments</translation>
    </message>
    <message>
        <source>Stock Object</source>
        <translation>Rohteilobjekt</translation>
    </message>
    <message>
        <source>Object whose bounding box is the stock</source>
        <translation>Objekt, dessen Hüllquader das Rohteil ist</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Tools of the CAM job</source>
        <translation>Werkzeuge des CAM-Jobs</translation>
    </message>
    <message>
        <source>Operations</source>
        <translation>Operationen</translation>
    </message>
    <message>
        <source>Operations in the order of the program</source>
        <translation>Operationen in der Reihenfolge des Programms</translation>
    </message>
    <message>
        <source>Adjust Feeds</source>
        <translation>Vorschübe anpassen</translation>
    </message>
    <message>
        <source>Adjust feeds to the material that each move removes: slower in corners, faster in air</source>
        <translation>Vorschübe an das Material anpassen, das jede Bewegung abträgt: langsamer in Ecken, schneller in Luft</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Werkstoff</translation>
    </message>
    <message>
        <source>Workpiece material, from which feeds, spindle speed and the machine's settings follow</source>
        <translation>Werkstoff, aus dem Vorschübe, Drehzahl und die Einstellungen der Maschine folgen</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Greatest diameter of the cutting part</source>
        <translation>Größter Durchmesser des schneidenden Teils</translation>
    </message>
    <message>
        <source>Corner Radius</source>
        <translation>Eckradius</translation>
    </message>
    <message>
        <source>Corner radius of a bull-nose, or tip radius of a tapered ball end mill</source>
        <translation>Eckenradius eines Torusfräsers, oder Radius der Spitze eines konischen Kugelfräsers</translation>
    </message>
    <message>
        <source>Tip Diameter</source>
        <translation>Spitzendurchmesser</translation>
    </message>
    <message>
        <source>Diameter of the flat tip of a V-bit</source>
        <translation>Durchmesser der flachen Spitze eines V-Fräsers</translation>
    </message>
    <message>
        <source>Flute</source>
        <translation>Schneidenlänge</translation>
    </message>
    <message>
        <source>Length of the cutting edges; 0: unknown</source>
        <translation>Länge der Schneiden; 0: unbekannt</translation>
    </message>
    <message>
        <source>Stick Out</source>
        <translation>Auskraglänge</translation>
    </message>
    <message>
        <source>Distance from the tip to the holder; 0: unknown</source>
        <translation>Abstand von der Spitze zum Halter; 0: unbekannt</translation>
    </message>
    <message>
        <source>Shank</source>
        <translation>Schaft</translation>
    </message>
    <message>
        <source>Shank diameter; 0: that of the cutting part</source>
        <translation>Schaftdurchmesser; 0: der des schneidenden Teils</translation>
    </message>
    <message>
        <source>Holder Diameter</source>
        <translation>Halterdurchmesser</translation>
    </message>
    <message>
        <source>Diameter of the holder; 0: unknown</source>
        <translation>Durchmesser des Halters; 0: unbekannt</translation>
    </message>
    <message>
        <source>Holder Length</source>
        <translation>Halterlänge</translation>
    </message>
    <message>
        <source>Length of the holder; 0: unknown</source>
        <translation>Länge des Halters; 0: unbekannt</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>Tool number in the machine</source>
        <translation>Werkzeugnummer in der Maschine</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Shape of the tip</source>
        <translation>Form der Spitze</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Included angle of the tip</source>
        <translation>Spitzenwinkel, von Seite zu Seite</translation>
    </message>
    <message>
        <source>Flutes</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Number of cutting edges</source>
        <translation>Zahl der Schneiden</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>Feed rate of cuts; 0: that of the material or the operation</source>
        <translation>Vorschub beim Fräsen; 0: der des Werkstoffs oder der Operation</translation>
    </message>
    <message>
        <source>Plunge</source>
        <translation>Eintauchvorschub</translation>
    </message>
    <message>
        <source>Feed rate of plunges; 0: that of the material or the operation</source>
        <translation>Vorschub beim Eintauchen; 0: der des Werkstoffs oder der Operation</translation>
    </message>
    <message>
        <source>Spindle</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>Spindle speed in rpm; 0: that of the material or the operation</source>
        <translation>Spindeldrehzahl je Minute; 0: die des Werkstoffs oder der Operation</translation>
    </message>
    <message>
        <source>Sources</source>
        <translation>Ausgangskörper</translation>
    </message>
    <message>
        <source>Solids, meshes, Part objects or bodies, in order</source>
        <translation>Körper, Netze, Part-Objekte oder Bodys, der Reihe nach</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Fillet radius of a blend</source>
        <translation>Radius der Verrundung einer verrundeten Vereinigung</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Weight of a morph: 0 gives the first source, 1 the second</source>
        <translation>Gewicht eines Übergangs: 0 ergibt den ersten Ausgangskörper, 1 den zweiten</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Operation</translation>
    </message>
    <message>
        <source>How the sources are combined</source>
        <translation>Wie die Ausgangskörper kombiniert werden</translation>
    </message>
    <message>
        <source>Given</source>
        <translation>Angegeben</translation>
    </message>
    <message>
        <source>Settings that have a value of their own; the others have their defaults</source>
        <translation>Einstellungen mit eigenem Wert; die anderen haben ihre Vorgabe</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>File of the model: .frep text or a mesh</source>
        <translation>Datei des Modells: .frep-Text oder ein Netz</translation>
    </message>
    <message>
        <source>Name of the part in the file; empty: the whole model</source>
        <translation>Name des Teils in der Datei; leer: das ganze Modell</translation>
    </message>
    <message>
        <source>Opened</source>
        <translation>Geöffnet</translation>
    </message>
    <message>
        <source>Files that the model opens, relative to its folder</source>
        <translation>Dateien, die das Modell öffnet, relativ zu seinem Ordner</translation>
    </message>
    <message>
        <source>Followed Text</source>
        <translation>Befolgter Text</translation>
    </message>
    <message>
        <source>Text from which the parameters were last read</source>
        <translation>Text, aus dem die Parameter zuletzt gelesen wurden</translation>
    </message>
    <message>
        <source>Expression</source>
        <translation>Formel</translation>
    </message>
    <message>
        <source>The solid as .frep text or as a prefix math string</source>
        <translation>Der Körper als .frep-Text oder als Formel in Präfixschreibweise</translation>
    </message>
    <message>
        <source>Stamps</source>
        <translation>Zeitstempel</translation>
    </message>
    <message>
        <source>Sizes and modification times of the files it was made from</source>
        <translation>Größen und Änderungszeiten der Dateien, aus denen es entstand</translation>
    </message>
    <message>
        <source>Setup</source>
        <translation>Aufspannung</translation>
    </message>
    <message>
        <source>The CAM job that it follows</source>
        <translation>Der CAM-Job, dem es folgt</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>Sekunden</translation>
    </message>
    <message>
        <source>Estimated machining time in seconds</source>
        <translation>Geschätzte Bearbeitungszeit in Sekunden</translation>
    </message>
    <message>
        <source>Planned Seconds</source>
        <translation>Geplante Sekunden</translation>
    </message>
    <message>
        <source>Estimated machining time in seconds, without adjusted feeds</source>
        <translation>Geschätzte Bearbeitungszeit in Sekunden, ohne angepasste Vorschübe</translation>
    </message>
    <message>
        <source>Cut Length</source>
        <translation>Schnittlänge</translation>
    </message>
    <message>
        <source>Length of cuts</source>
        <translation>Länge der Schnitte</translation>
    </message>
    <message>
        <source>Rapid Length</source>
        <translation>Eilganglänge</translation>
    </message>
    <message>
        <source>Length of rapids</source>
        <translation>Länge der Eilgänge</translation>
    </message>
    <message>
        <source>Reports</source>
        <translation>Berichte</translation>
    </message>
    <message>
        <source>Report of each operation</source>
        <translation>Bericht zu jeder Operation</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>Notes on the program</source>
        <translation>Hinweise zum Programm</translation>
    </message>
    <message>
        <source>The program's zero in the document's coordinates</source>
        <translation>Der Nullpunkt des Programms in den Koordinaten des Dokuments</translation>
    </message>
    <message>
        <source>Packed Program</source>
        <translation>Programm, komprimiert</translation>
    </message>
    <message>
        <source>Machine file, compressed</source>
        <translation>Maschinendatei, komprimiert</translation>
    </message>
    <message>
        <source>Packed Sheet</source>
        <translation>Einrichteblatt, komprimiert</translation>
    </message>
    <message>
        <source>Set-up sheet as an HTML page, compressed</source>
        <translation>Einrichteblatt als HTML-Seite, komprimiert</translation>
    </message>
    <message>
        <source>Packed Moves</source>
        <translation>Bewegungen, komprimiert</translation>
    </message>
    <message>
        <source>All moves as a NumPy array, compressed</source>
        <translation>Alle Bewegungen als NumPy-Array, komprimiert</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Abschnitte</translation>
    </message>
    <message>
        <source>Tool and settings of each operation, as JSON</source>
        <translation>Werkzeug und Einstellungen jeder Operation, als JSON</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Auftrag</translation>
    </message>
    <message>
        <source>The job that it was planned from (docs/cam.md)</source>
        <translation>Der Auftrag, aus dem es geplant wurde (docs/cam.md)</translation>
    </message>
    <message>
        <source>Extension</source>
        <translation>Endung</translation>
    </message>
    <message>
        <source>Extension of the machine file</source>
        <translation>Endung der Maschinendatei</translation>
    </message>
    <message>
        <source>Made From</source>
        <translation>Gemacht aus</translation>
    </message>
    <message>
        <source>Digest of the input; the program is planned again when it changes</source>
        <translation>Prüfsumme der Eingaben; ändert sie sich, wird neu geplant</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Ausgangskörper</translation>
    </message>
    <message>
        <source>A solid, mesh, Part object or body</source>
        <translation>Ein Körper, Netz, Part-Objekt oder Body</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Distance outwards; negative values inwards</source>
        <translation>Abstand nach außen; negative Werte nach innen</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Wanddicke</translation>
    </message>
    <message>
        <source>Thickness of the wall, inwards; 0 for a lattice without one</source>
        <translation>Dicke der Wand nach innen; 0 für ein Gitter ohne Wand</translation>
    </message>
    <message>
        <source>Period</source>
        <translation>Periode</translation>
    </message>
    <message>
        <source>Edge length of a lattice cell</source>
        <translation>Kantenlänge einer Gitterzelle</translation>
    </message>
    <message>
        <source>Strut</source>
        <translation>Stegdicke</translation>
    </message>
    <message>
        <source>Thickness of the lattice's walls or struts</source>
        <translation>Dicke der Wände oder Stäbe des Gitters</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Normal of the mirror plane, or direction of the axis</source>
        <translation>Normale der Spiegelebene, oder Richtung der Achse</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Point on the mirror plane or axis</source>
        <translation>Punkt auf der Spiegelebene oder Achse</translation>
    </message>
    <message>
        <source>Keep Original</source>
        <translation>Original behalten</translation>
    </message>
    <message>
        <source>Unite the mirror image with the original</source>
        <translation>Spiegelbild und Original vereinigen</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Step from one copy to the next, or the move of a transform</source>
        <translation>Schritt von einer Kopie zur nächsten, oder Verschiebung beim Umformen</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Number of copies, including the original</source>
        <translation>Zahl der Kopien, das Original eingerechnet</translation>
    </message>
    <message>
        <source>Angle that the copies fill; 360 degrees is a full turn</source>
        <translation>Winkel, den die Kopien füllen; 360 Grad sind eine volle Drehung</translation>
    </message>
    <message>
        <source>Factors</source>
        <translation>Faktoren</translation>
    </message>
    <message>
        <source>Scale factors along x, y and z</source>
        <translation>Skalierungsfaktoren entlang x, y und z</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Rotation about the axis</source>
        <translation>Drehung um die Achse</translation>
    </message>
    <message>
        <source>How the source is modified</source>
        <translation>Wie der Ausgangskörper verändert wird</translation>
    </message>
    <message>
        <source>Lattice</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>Kind of lattice</source>
        <translation>Art des Gitters</translation>
    </message>
    <message>
        <source>Node</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>Name of the node in OpenSCAD</source>
        <translation>Name des Knotens in OpenSCAD</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>The solid as OpenSCAD's .csg text</source>
        <translation>Der Körper als .csg-Text von OpenSCAD</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Folder of the files that the text names</source>
        <translation>Ordner der Dateien, die der Text nennt</translation>
    </message>
    <message>
        <source>Children of the node, in order</source>
        <translation>Kinder des Knotens, der Reihe nach</translation>
    </message>
    <message>
        <source>A solid or a mesh</source>
        <translation>Ein Körper oder ein Netz</translation>
    </message>
    <message>
        <source>Most Triangles</source>
        <translation>Meiste Dreiecke</translation>
    </message>
    <message>
        <source>If all faces are flat, the mesh is reduced to about as many triangles; FreeCAD is slow with more than some thousands</source>
        <translation>Wenn alle Flächen eben sind, wird das Netz auf etwa so viele Dreiecke verringert; FreeCAD ist mit mehr als einigen Tausend langsam</translation>
    </message>
    <message>
        <source>Merge Faces</source>
        <translation>Flächen verschmelzen</translation>
    </message>
    <message>
        <source>Merge coplanar triangles into one face</source>
        <translation>Dreiecke in einer Ebene zu einer Fläche vereinigen</translation>
    </message>
    <message>
        <source>Curved</source>
        <translation>Gekrümmt</translation>
    </message>
    <message>
        <source>Make cylindrical, conical, spherical, toroidal and free-form faces, as far as the shape stays valid</source>
        <translation>Zylindrische, kegelige, kugelige, torusförmige und freie Flächen bilden, soweit die Form gültig bleibt</translation>
    </message>
    <message>
        <source>Kinds</source>
        <translation>Arten</translation>
    </message>
    <message>
        <source>Number of faces of each kind</source>
        <translation>Anzahl der Flächen jeder Art</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Number of faces of the shape</source>
        <translation>Zahl der Flächen der Form</translation>
    </message>
    <message>
        <source>Volume Change</source>
        <translation>Volumenänderung</translation>
    </message>
    <message>
        <source>Volume of the shape above that of the solid, in percent</source>
        <translation>Um wie viel Prozent das Volumen der Form über dem des Körpers liegt</translation>
    </message>
    <message>
        <source>Digest of the input; the shape is made again when it changes</source>
        <translation>Prüfsumme der Eingaben; ändert sie sich, wird die Form neu gemacht</translation>
    </message>
    <message>
        <source>Start Depth</source>
        <translation>Anfangstiefe</translation>
    </message>
    <message>
        <source>z at which cutting begins</source>
        <translation>z, bei dem das Fräsen beginnt</translation>
    </message>
    <message>
        <source>Final Depth</source>
        <translation>Endtiefe</translation>
    </message>
    <message>
        <source>Lowest z of the path</source>
        <translation>Tiefstes z des Pfads</translation>
    </message>
    <message>
        <source>Safe Height</source>
        <translation>Sichere Höhe</translation>
    </message>
    <message>
        <source>z of rapids</source>
        <translation>z der Eilgänge</translation>
    </message>
    <message>
        <source>Clearance Height</source>
        <translation>Freifahrhöhe</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>The machine program that it follows</source>
        <translation>Das Maschinenprogramm, dem es folgt</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Abschnitt</translation>
    </message>
    <message>
        <source>Index of the operation, from 0; -1: all operations, as in the machine file</source>
        <translation>Nummer der Operation, von 0 an; -1: alle Operationen, wie in der Maschinendatei</translation>
    </message>
    <message>
        <source>Tool Controller</source>
        <translation>Werkzeugsteuerung</translation>
    </message>
    <message>
        <source>Tool controller of the Path job</source>
        <translation>Werkzeugsteuerung des Path-Auftrags</translation>
    </message>
    <message>
        <source>Include the operation in the Path job</source>
        <translation>Die Operation in den Path-Auftrag aufnehmen</translation>
    </message>
    <message>
        <source>Coolant Mode</source>
        <translation>Kühlung</translation>
    </message>
    <message>
        <source>Coolant while cutting</source>
        <translation>Kühlung beim Fräsen</translation>
    </message>
    <message>
        <source>The volume's file, or the folder of its slices</source>
        <translation>Die Datei des Volumens oder der Ordner mit seinen Schichtbildern</translation>
    </message>
    <message>
        <source>File Beside</source>
        <translation>Datei daneben</translation>
    </message>
    <message>
        <source>The same path, relative to the document's folder</source>
        <translation>Derselbe Pfad, relativ zum Ordner des Dokuments</translation>
    </message>
    <message>
        <source>File Read</source>
        <translation>Gelesene Datei</translation>
    </message>
    <message>
        <source>Size and modification time of the file that the mesh was made from</source>
        <translation>Größe und Änderungszeit der Datei, aus der das Netz gemacht wurde</translation>
    </message>
    <message>
        <source>File State</source>
        <translation>Zustand der Datei</translation>
    </message>
    <message>
        <source>Whether the file exists and is unchanged since it was read</source>
        <translation>Ob die Datei da ist und seit dem Lesen unverändert</translation>
    </message>
    <message>
        <source>Auto Threshold</source>
        <translation>Automatische Schwelle</translation>
    </message>
    <message>
        <source>Threshold halfway between the two most frequent densities</source>
        <translation>Schwelle in der Mitte zwischen den zwei häufigsten Dichten</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>Density above which the volume is solid, if AutoThreshold is off</source>
        <translation>Dichte, über der das Volumen Körper ist, wenn AutoThreshold aus ist</translation>
    </message>
    <message>
        <source>Below</source>
        <translation>Darunter</translation>
    </message>
    <message>
        <source>Densities below the threshold are solid</source>
        <translation>Dichten unter der Schwelle sind Körper</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstände</translation>
    </message>
    <message>
        <source>Spacing of the samples along x, y and z, mm; 0 0 0: that of the file</source>
        <translation>Abstände der Messpunkte in x, y und z, mm; 0 0 0: die der Datei</translation>
    </message>
    <message>
        <source>Crop</source>
        <translation>Ausschnitt</translation>
    </message>
    <message>
        <source>First sample along x, y and z, then the last; empty: the whole volume</source>
        <translation>Erster Messpunkt in x, y und z, dann der letzte; leer: das ganze Volumen</translation>
    </message>
    <message>
        <source>Denoise</source>
        <translation>Entrauschen</translation>
    </message>
    <message>
        <source>Noise filter</source>
        <translation>Rauschfilter</translation>
    </message>
    <message>
        <source>Keep Largest</source>
        <translation>Größtes behalten</translation>
    </message>
    <message>
        <source>Keep the largest piece only</source>
        <translation>Nur das größte Stück behalten</translation>
    </message>
    <message>
        <source>Smallest Island</source>
        <translation>Kleinste Insel</translation>
    </message>
    <message>
        <source>Pieces of less volume are removed</source>
        <translation>Stücke von kleinerem Volumen werden entfernt</translation>
    </message>
    <message>
        <source>Smallest Hole</source>
        <translation>Kleinstes Loch</translation>
    </message>
    <message>
        <source>Cavities of less volume are filled</source>
        <translation>Hohlräume von kleinerem Volumen werden gefüllt</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Messpunkte</translation>
    </message>
    <message>
        <source>Number of samples along x, y and z; empty: from the file or its name</source>
        <translation>Zahl der Messpunkte in x, y und z; leer: aus der Datei oder ihrem Namen</translation>
    </message>
    <message>
        <source>Sample Type</source>
        <translation>Typ der Messwerte</translation>
    </message>
    <message>
        <source>Type of the samples</source>
        <translation>Typ der Messwerte</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>Series of a DICOM folder that contains several</source>
        <translation>Serie eines DICOM-Ordners, der mehrere enthält</translation>
    </message>
    <message>
        <source>Script</source>
        <translation>Schriftsystem</translation>
    </message>
    <message>
        <source>Python script that makes the solid</source>
        <translation>Python-Skript, das den Körper erzeugt</translation>
    </message>
    <message>
        <source>Formula</source>
        <translation>Formel</translation>
    </message>
    <message>
        <source>Formula that the script made</source>
        <translation>Formel, die das Skript erzeugt hat</translation>
    </message>
    <message>
        <source>Formula Of</source>
        <translation>Formel von</translation>
    </message>
    <message>
        <source>Script that made the formula, with its values</source>
        <translation>Skript, das die Formel erzeugt hat, mit seinen Werten</translation>
    </message>
    <message>
        <source>Program File</source>
        <translation>Programmdatei</translation>
    </message>
    <message>
        <source>Program file of the machine: G-code, .sbp, .rml, .hpgl</source>
        <translation>Programmdatei der Maschine: G-Code, .sbp, .rml, .hpgl</translation>
    </message>
    <message>
        <source>Object with a program: a machine program, a Path operation or a Path job. It replaces the file</source>
        <translation>Objekt mit einem Programm: ein Maschinenprogramm, eine Path-Operation oder ein Path-Auftrag. Es ersetzt die Datei</translation>
    </message>
    <message>
        <source>Dialect</source>
        <translation>Dialekt</translation>
    </message>
    <message>
        <source>Dialect of the G-code; if none is chosen, that of the set-up's machine</source>
        <translation>Dialekt des G-Codes; ohne Wahl der von der Maschine der Aufspannung</translation>
    </message>
    <message>
        <source>Setup File</source>
        <translation>Aufspanndatei</translation>
    </message>
    <message>
        <source>Set-up or job file (docs/simulation.md); empty: the properties below</source>
        <translation>Aufspann- oder Auftragsdatei (docs/simulation.md); leer: die Eigenschaften darunter</translation>
    </message>
    <message>
        <source>One tool per line, as JSON: number, shape, diameter, flute, length, shank, holder_diameter, ...</source>
        <translation>Ein Werkzeug je Zeile, als JSON: number, shape, diameter, flute, length, shank, holder_diameter, ...</translation>
    </message>
    <message>
        <source>Lower corner of the stock</source>
        <translation>Untere Ecke des Rohteils</translation>
    </message>
    <message>
        <source>Upper corner of the stock</source>
        <translation>Obere Ecke des Rohteils</translation>
    </message>
    <message>
        <source>Setup Program</source>
        <translation>Programm der Aufspannung</translation>
    </message>
    <message>
        <source>Machine program of the document whose set-up a program file uses: machine, tools, stock and part</source>
        <translation>Maschinenprogramm des Dokuments, dessen Aufspannung für eine Programmdatei gilt: Maschine, Werkzeuge, Rohteil und Werkstück</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Rohteil</translation>
    </message>
    <message>
        <source>Stock as a solid, such as the result of an earlier simulation. It replaces the corners</source>
        <translation>Rohteil als Körper, etwa das Ergebnis einer früheren Simulation. Es ersetzt die Ecken</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Solid that the program should produce</source>
        <translation>Körper, den das Programm ergeben soll</translation>
    </message>
    <message>
        <source>Gouge</source>
        <translation>Verletzung</translation>
    </message>
    <message>
        <source>Deeper cuts into the target are reported as gouges</source>
        <translation>Tiefere Schnitte in das Ziel werden als Verletzung gemeldet</translation>
    </message>
    <message>
        <source>Excess</source>
        <translation>Restmaterial</translation>
    </message>
    <message>
        <source>More material left on the target is reported as excess; 0: excess is not reported</source>
        <translation>Höheres Restmaterial auf dem Ziel wird gemeldet; 0: Restmaterial wird nicht gemeldet</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Berührung</translation>
    </message>
    <message>
        <source>Contacts of less depth are ignored</source>
        <translation>Kollisionen von geringerer Tiefe zählen nicht</translation>
    </message>
    <message>
        <source>More Of Setup</source>
        <translation>Mehr der Aufspannung</translation>
    </message>
    <message>
        <source>Further lines of the set-up: zero, start, [work], [limits], [fixture], ...</source>
        <translation>Weitere Zeilen der Aufspannung: zero, start, [work], [limits], [fixture], ...</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Zelle</translation>
    </message>
    <message>
        <source>Sample spacing; 0: automatic, 1/300 of the stock, at most 0.2 mm</source>
        <translation>Abstand der Messpunkte; 0: automatisch, 1/300 des Rohteils, höchstens 0,2 mm</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Result of the simulation in a few words</source>
        <translation>Ergebnis der Simulation in wenigen Worten</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>Events, the worst first: one JSON object per line</source>
        <translation>Ereignisse, die schlimmsten zuerst: ein JSON-Objekt je Zeile</translation>
    </message>
    <message>
        <source>Notes on lines of the program</source>
        <translation>Hinweise zu Zeilen des Programms</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>Abgetragen</translation>
    </message>
    <message>
        <source>Volume of the removed material</source>
        <translation>Volumen des abgetragenen Materials</translation>
    </message>
    <message>
        <source>Machining time in seconds</source>
        <translation>Bearbeitungszeit in Sekunden</translation>
    </message>
    <message>
        <source>Rapid Seconds</source>
        <translation>Eilgangsekunden</translation>
    </message>
    <message>
        <source>Time of the rapids in seconds</source>
        <translation>Zeit der Eilgänge in Sekunden</translation>
    </message>
    <message>
        <source>Air Share</source>
        <translation>Luftanteil</translation>
    </message>
    <message>
        <source>Percentage of the feed moves that meets no material</source>
        <translation>Prozentsatz der Vorschubbewegungen, der auf kein Material trifft</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Kollisionen</translation>
    </message>
    <message>
        <source>Number of lines with a collision</source>
        <translation>Zahl der Zeilen mit einer Kollision</translation>
    </message>
    <message>
        <source>Gouges</source>
        <translation>Verletzungen</translation>
    </message>
    <message>
        <source>Number of lines that gouge the target</source>
        <translation>Zahl der Zeilen, die das Ziel verletzen</translation>
    </message>
    <message>
        <source>Over Travels</source>
        <translation>Überschrittene Verfahrwege</translation>
    </message>
    <message>
        <source>Number of lines that leave the machine's limits</source>
        <translation>Zahl der Zeilen, die die Grenzen der Maschine verlassen</translation>
    </message>
    <message>
        <source>Deepest Gouge</source>
        <translation>Tiefste Verletzung</translation>
    </message>
    <message>
        <source>Greatest depth of a gouge</source>
        <translation>Größte Tiefe einer Verletzung</translation>
    </message>
    <message>
        <source>Highest Excess</source>
        <translation>Höchstes Restmaterial</translation>
    </message>
    <message>
        <source>Greatest height of excess material</source>
        <translation>Größte Höhe des Restmaterials</translation>
    </message>
    <message>
        <source>Machine that runs the program</source>
        <translation>Maschine, die das Programm ausführt</translation>
    </message>
    <message>
        <source>Voxel Size</source>
        <translation>Zellgröße</translation>
    </message>
    <message>
        <source>Edge of the smallest cell. 0: automatic, from a scan's spacing or from the number of cells in the preferences. Flat faces of OpenSCAD need no cells</source>
        <translation>Kante der kleinsten Zelle. 0: automatisch, aus dem Abstand der Messpunkte eines Scans oder der Zahl der Zellen in den Einstellungen. Ebene Flächen aus OpenSCAD brauchen keine Zellen</translation>
    </message>
    <message>
        <source>Max Error</source>
        <translation>Größter Fehler</translation>
    </message>
    <message>
        <source>Greatest distance of the mesh from the solid; 0: a tenth of the smallest cell</source>
        <translation>Größter Abstand des Netzes vom Körper; 0: ein Zehntel der kleinsten Zelle</translation>
    </message>
    <message>
        <source>Only When Shown</source>
        <translation>Nur wenn sichtbar</translation>
    </message>
    <message>
        <source>Make no mesh while the solid is hidden and only used by other solids</source>
        <translation>Kein Netz erzeugen, solange der Körper verborgen ist und nur andere Körper ihn nutzen</translation>
    </message>
    <message>
        <source>Auto Bounds</source>
        <translation>Grenzen automatisch</translation>
    </message>
    <message>
        <source>Find the solid's bounds by interval search</source>
        <translation>Die Grenzen des Körpers durch Intervallsuche finden</translation>
    </message>
    <message>
        <source>Lower</source>
        <translation>Untere Ecke</translation>
    </message>
    <message>
        <source>Lower corner of the region, if AutoBounds is off</source>
        <translation>Untere Ecke des Bereichs, wenn AutoBounds aus ist</translation>
    </message>
    <message>
        <source>Upper</source>
        <translation>Obere Ecke</translation>
    </message>
    <message>
        <source>Upper corner of the region, if AutoBounds is off</source>
        <translation>Obere Ecke des Bereichs, wenn AutoBounds aus ist</translation>
    </message>
    <message>
        <source>Certainty</source>
        <translation>Sicherheit</translation>
    </message>
    <message>
        <source>Whether the mesh is proved to show the whole solid, or the reason; empty for a mesh of an earlier version</source>
        <translation>Ob bewiesen ist, dass das Netz den ganzen Körper zeigt, oder der Grund; leer bei einem Netz einer früheren Version</translation>
    </message>
    <message>
        <source>Uncertain Places</source>
        <translation>Unsichere Stellen</translation>
    </message>
    <message>
        <source>Lower and upper corners of boxes in which parts may be missing, the largest first</source>
        <translation>Untere und obere Ecken der Quader, in denen Teile fehlen können, die größten zuerst</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Volume of the mesh</source>
        <translation>Volumen des Netzes</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Surface area of the mesh</source>
        <translation>Oberfläche des Netzes</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Number of triangles of the mesh</source>
        <translation>Zahl der Dreiecke des Netzes</translation>
    </message>
    <message>
        <source>Digest of the input; the mesh is made again when it changes</source>
        <translation>Prüfsumme der Eingaben; ändert sie sich, wird das Netz neu gemacht</translation>
    </message>
    <message>
        <source>A mesh, a Part object or a body</source>
        <translation>Ein Netz, ein Part-Objekt oder ein Body</translation>
    </message>
    <message>
        <source>Deflection</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Greatest distance of triangles from a Part shape; 0: 1/2000 of its size</source>
        <translation>Größter Abstand der Dreiecke von einer Part-Form; 0: 1/2000 ihrer Größe</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Along z</source>
        <translation>Entlang z</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Along x</source>
        <translation>Entlang x</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Along y</source>
        <translation>Entlang y</translation>
    </message>
    <message>
        <source>Centred</source>
        <translation>Zentriert</translation>
    </message>
    <message>
        <source>Around the origin</source>
        <translation>Um den Ursprung</translation>
    </message>
    <message>
        <source>Radius of the circle or sphere</source>
        <translation>Radius des Kreises oder der Kugel</translation>
    </message>
    <message>
        <source>The file that is imported</source>
        <translation>Die Datei, die importiert wird</translation>
    </message>
    <message>
        <source>Fn</source>
        <translation>Fn</translation>
    </message>
    <message>
        <source>Number of sides of a circle; 0: from Fa and Fs</source>
        <translation>Zahl der Seiten eines Kreises; 0: nach Fa und Fs</translation>
    </message>
    <message>
        <source>Fa</source>
        <translation>Fa</translation>
    </message>
    <message>
        <source>Smallest angle that a side of a circle spans</source>
        <translation>Kleinster Winkel, den eine Seite eines Kreises überspannt</translation>
    </message>
    <message>
        <source>Fs</source>
        <translation>Fs</translation>
    </message>
    <message>
        <source>Smallest length of a side of a circle</source>
        <translation>Kleinste Länge einer Seite eines Kreises</translation>
    </message>
    <message>
        <source>Bottom Radius</source>
        <translation>Unterer Radius</translation>
    </message>
    <message>
        <source>Radius of the lower circle</source>
        <translation>Radius des unteren Kreises</translation>
    </message>
    <message>
        <source>Top Radius</source>
        <translation>Oberer Radius</translation>
    </message>
    <message>
        <source>Radius of the upper circle</source>
        <translation>Radius des oberen Kreises</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>Corners of each face, clockwise from outside, numbered from 0</source>
        <translation>Ecken jeder Fläche, von außen im Uhrzeigersinn, von 0 an gezählt</translation>
    </message>
    <message>
        <source>Paths</source>
        <translation>Umrisse</translation>
    </message>
    <message>
        <source>Corners of each outline, numbered from 0; empty: all in their order</source>
        <translation>Ecken jedes Umrisses, von 0 an gezählt; leer: alle in ihrer Reihenfolge</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>Worte</translation>
    </message>
    <message>
        <source>Text to be written</source>
        <translation>Text, der geschrieben wird</translation>
    </message>
    <message>
        <source>Text Size</source>
        <translation>Schriftgröße</translation>
    </message>
    <message>
        <source>Height of a capital letter</source>
        <translation>Höhe eines Großbuchstabens</translation>
    </message>
    <message>
        <source>Font</source>
        <translation>Schriftart</translation>
    </message>
    <message>
        <source>Name of the font, also with style=...</source>
        <translation>Name der Schrift, auch mit style=...</translation>
    </message>
    <message>
        <source>Horizontal Alignment</source>
        <translation>Waagerechte Ausrichtung</translation>
    </message>
    <message>
        <source>left, center or right</source>
        <translation>left, center oder right</translation>
    </message>
    <message>
        <source>Vertical Alignment</source>
        <translation>Senkrechte Ausrichtung</translation>
    </message>
    <message>
        <source>baseline, bottom, center or top</source>
        <translation>baseline, bottom, center oder top</translation>
    </message>
    <message>
        <source>Spacing of the letters; 1 is normal</source>
        <translation>Abstand der Buchstaben; 1 ist normal</translation>
    </message>
    <message>
        <source>Writing Direction</source>
        <translation>Schreibrichtung</translation>
    </message>
    <message>
        <source>ltr, rtl, ttb or btt</source>
        <translation>ltr, rtl, ttb oder btt</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Language of the text: en, de, ...</source>
        <translation>Sprache des Texts: en, de, ...</translation>
    </message>
    <message>
        <source>Script of the text: Latn, ...</source>
        <translation>Schriftsystem des Texts: Latn, ...</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Verdrehung</translation>
    </message>
    <message>
        <source>Rotation of the upper end against the lower</source>
        <translation>Drehung des oberen Endes gegen das untere</translation>
    </message>
    <message>
        <source>Scale X</source>
        <translation>Faktor X</translation>
    </message>
    <message>
        <source>Scale of the upper end along x</source>
        <translation>Skalierung des oberen Endes entlang x</translation>
    </message>
    <message>
        <source>Scale Y</source>
        <translation>Faktor Y</translation>
    </message>
    <message>
        <source>Scale of the upper end along y</source>
        <translation>Skalierung des oberen Endes entlang y</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Scheiben</translation>
    </message>
    <message>
        <source>Number of slices if twisted or scaled; 0: from Fn, Fa and Fs</source>
        <translation>Zahl der Schichten, wenn verdreht oder skaliert; 0: nach Fn, Fa und Fs</translation>
    </message>
    <message>
        <source>Angle of the revolution, from the x axis</source>
        <translation>Drehwinkel, von der x-Achse an</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Section at z = 0 instead of the projection</source>
        <translation>Schnitt bei z = 0 statt der Projektion</translation>
    </message>
    <message>
        <source>Chamfered</source>
        <translation>Gefast</translation>
    </message>
    <message>
        <source>Cut off the corners</source>
        <translation>Ecken abschneiden</translation>
    </message>
    <message>
        <source>New Length</source>
        <translation>Neue Länge</translation>
    </message>
    <message>
        <source>Length along x; 0: unchanged</source>
        <translation>Länge entlang x; 0: unverändert</translation>
    </message>
    <message>
        <source>New Width</source>
        <translation>Neue Breite</translation>
    </message>
    <message>
        <source>Width along y; 0: unchanged</source>
        <translation>Breite entlang y; 0: unverändert</translation>
    </message>
    <message>
        <source>New Height</source>
        <translation>Neue Höhe</translation>
    </message>
    <message>
        <source>Height along z; 0: unchanged</source>
        <translation>Höhe entlang z; 0: unverändert</translation>
    </message>
    <message>
        <source>Auto Length</source>
        <translation>Länge im Verhältnis</translation>
    </message>
    <message>
        <source>Scale the length in proportion if NewLength is 0</source>
        <translation>Die Länge im Verhältnis anpassen, wenn NewLength 0 ist</translation>
    </message>
    <message>
        <source>Auto Width</source>
        <translation>Breite im Verhältnis</translation>
    </message>
    <message>
        <source>Scale the width in proportion if NewWidth is 0</source>
        <translation>Die Breite im Verhältnis anpassen, wenn NewWidth 0 ist</translation>
    </message>
    <message>
        <source>Auto Height</source>
        <translation>Höhe im Verhältnis</translation>
    </message>
    <message>
        <source>Scale the height in proportion if NewHeight is 0</source>
        <translation>Die Höhe im Verhältnis anpassen, wenn NewHeight 0 ist</translation>
    </message>
    <message>
        <source>Matrix</source>
        <translation>Matrix</translation>
    </message>
    <message>
        <source>Transformation of the children</source>
        <translation>Transformation der Kinder</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Layer of a .dxf file; empty: all layers</source>
        <translation>Layer einer .dxf-Datei; leer: alle</translation>
    </message>
    <message>
        <source>Origin X</source>
        <translation>Ursprung X</translation>
    </message>
    <message>
        <source>Origin of the drawing in a .dxf file</source>
        <translation>Ursprung der Zeichnung in einer .dxf-Datei</translation>
    </message>
    <message>
        <source>Origin Y</source>
        <translation>Ursprung Y</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Scale of the drawing in a .dxf or .svg file</source>
        <translation>Maßstab der Zeichnung in einer .dxf- oder .svg-Datei</translation>
    </message>
    <message>
        <source>Dpi</source>
        <translation>Dpi</translation>
    </message>
    <message>
        <source>Dots per inch of an .svg file</source>
        <translation>Punkte je Zoll einer .svg-Datei</translation>
    </message>
    <message>
        <source>Inverted</source>
        <translation>Umgekehrt</translation>
    </message>
    <message>
        <source>Dark parts of a picture are high</source>
        <translation>Dunkle Stellen eines Bildes sind hoch</translation>
    </message>
    <message>
        <source>Sharp Edges</source>
        <translation>Scharfe Kanten</translation>
    </message>
    <message>
        <source>Draw lines along sharp edges</source>
        <translation>Linien an scharfen Kanten zeichnen</translation>
    </message>
    <message>
        <source>Sample spacing; the default follows from the part's size and the tool (mm)</source>
        <translation>Abstand der Abtastpunkte; die Vorgabe folgt aus der Größe des Teils und dem Werkzeug (mm)</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>Schnitthöhe</translation>
    </message>
    <message>
        <source>Height of the section through the part; the default is the projection from above, or the drawing itself (mm)</source>
        <translation>Höhe des Schnitts durch das Teil; Vorgabe ist die Projektion von oben oder die Zeichnung selbst (mm)</translation>
    </message>
    <message>
        <source>Surface Tolerance</source>
        <translation>Toleranz der Höhenkarte</translation>
    </message>
    <message>
        <source>Greatest distance of the height map from the part's surface (mm)</source>
        <translation>Größter Abstand der Höhenkarte von der Oberfläche des Teils (mm)</translation>
    </message>
    <message>
        <source>Pixel</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>Size of a pixel; the default is that of the image file (mm)</source>
        <translation>Größe eines Pixels; Vorgabe ist die der Bilddatei (mm)</translation>
    </message>
    <message>
        <source>Brighter pixels are solid</source>
        <translation>Hellere Pixel sind Material</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>Invert: darker pixels are solid</source>
        <translation>Umkehren: dunklere Pixel sind Material</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Schwarz</translation>
    </message>
    <message>
        <source>Height of black; the default is that of the image file (mm)</source>
        <translation>Höhe von Schwarz; Vorgabe ist die der Bilddatei (mm)</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Weiß</translation>
    </message>
    <message>
        <source>Height of white; the default is that of the image file (mm)</source>
        <translation>Höhe von Weiß; Vorgabe ist die der Bilddatei (mm)</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Side of the outline on which the tool runs</source>
        <translation>Seite des Umrisses, auf der das Werkzeug fährt</translation>
    </message>
    <message>
        <source>Tabs</source>
        <translation>Haltestege</translation>
    </message>
    <message>
        <source>Number of tabs on each outline, which hold the part</source>
        <translation>Anzahl der Haltestege je Umriss, die das Teil halten</translation>
    </message>
    <message>
        <source>Tab Width</source>
        <translation>Breite der Stege</translation>
    </message>
    <message>
        <source>Width of a tab (mm)</source>
        <translation>Breite eines Haltestegs (mm)</translation>
    </message>
    <message>
        <source>Tab Height</source>
        <translation>Höhe der Stege</translation>
    </message>
    <message>
        <source>Height of a tab (mm)</source>
        <translation>Höhe eines Haltestegs (mm)</translation>
    </message>
    <message>
        <source>Z of the top of the material; the default is the top of the stock (mm)</source>
        <translation>Z der Oberkante des Materials; Vorgabe ist die des Rohteils (mm)</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Depth below the top; the default is through the stock (mm)</source>
        <translation>Tiefe unter der Oberkante; Vorgabe ist durch das Rohteil (mm)</translation>
    </message>
    <message>
        <source>Stepdown</source>
        <translation>Zustellung</translation>
    </message>
    <message>
        <source>Depth of each pass; the default is one pass (mm)</source>
        <translation>Tiefe jedes Durchgangs; Vorgabe ist ein Durchgang (mm)</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>Aufmaß</translation>
    </message>
    <message>
        <source>Stock allowance left on the part (mm)</source>
        <translation>Aufmaß, das am Teil bleibt (mm)</translation>
    </message>
    <message>
        <source>Climb</source>
        <translation>Gleichlauf</translation>
    </message>
    <message>
        <source>Climb milling; false: conventional milling</source>
        <translation>Gleichlauffräsen; nein: Gegenlauffräsen</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Tolerance of fitting lines and arcs (mm)</source>
        <translation>Toleranz beim Einpassen von Strecken und Bögen (mm)</translation>
    </message>
    <message>
        <source>Offsets</source>
        <translation>Bahnen</translation>
    </message>
    <message>
        <source>Number of offsets; -1 clears everything</source>
        <translation>Anzahl der Bahnen; -1 räumt alles</translation>
    </message>
    <message>
        <source>Stepover</source>
        <translation>Bahnabstand</translation>
    </message>
    <message>
        <source>Distance from one offset to the next (diameters)</source>
        <translation>Abstand von einer Bahn zur nächsten (Durchmesser)</translation>
    </message>
    <message>
        <source>Side of the outline that is cleared</source>
        <translation>Seite des Umrisses, die geräumt wird</translation>
    </message>
    <message>
        <source>Distance of the rings (diameters)</source>
        <translation>Abstand der Ringe (Durchmesser)</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Muster</translation>
    </message>
    <message>
        <source>Rings along the walls, or constant engagement: never more than a straight pass has</source>
        <translation>Ringe entlang den Wänden oder gleichbleibender Eingriff: nie größer als auf einer geraden Bahn</translation>
    </message>
    <message>
        <source>Slots in the part, or the inside of a drawing of slots</source>
        <translation>Nuten im Teil oder das Innere einer Zeichnung von Nuten</translation>
    </message>
    <message>
        <source>Widest</source>
        <translation>Größte Breite</translation>
    </message>
    <message>
        <source>Greatest width of a slot; the default is 1.05 diameters (mm)</source>
        <translation>Größte Breite einer Nut; Vorgabe sind 1.05 Durchmesser (mm)</translation>
    </message>
    <message>
        <source>Peck</source>
        <translation>Spantiefe</translation>
    </message>
    <message>
        <source>Depth of each peck; the default is no pecking (mm)</source>
        <translation>Tiefe jedes Bohrhubs; Vorgabe ist Bohren in einem Hub (mm)</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Größter Durchmesser</translation>
    </message>
    <message>
        <source>Largest diameter of the holes; the default is that of the tool (mm)</source>
        <translation>Größter Durchmesser der Bohrungen; Vorgabe ist der des Werkzeugs (mm)</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>Steigung</translation>
    </message>
    <message>
        <source>Rise of the thread in a turn (mm)</source>
        <translation>Steigung des Gewindes je Umdrehung (mm)</translation>
    </message>
    <message>
        <source>Largest diameter of the thread, as 6 of M6; the default is that of an ISO thread in each hole (mm)</source>
        <translation>Außendurchmesser des Gewindes, etwa 6 bei M6; Vorgabe ist der des ISO-Gewindes in jeder Bohrung (mm)</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Gangrichtung</translation>
    </message>
    <message>
        <source>A right-hand or a left-hand thread</source>
        <translation>Rechts- oder Linksgewinde</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>Number of passes to the thread's full depth</source>
        <translation>Anzahl der Durchgänge bis zur vollen Gewindetiefe</translation>
    </message>
    <message>
        <source>Greatest width of a pass (diameters)</source>
        <translation>Größte Breite eines Durchgangs (Durchmesser)</translation>
    </message>
    <message>
        <source>Angle of the passes to x (degrees)</source>
        <translation>Winkel der Bahnen zu x (Grad)</translation>
    </message>
    <message>
        <source>Both Ways</source>
        <translation>Hin und zurück</translation>
    </message>
    <message>
        <source>Alternate passes run backwards</source>
        <translation>Jede zweite Bahn läuft zurück</translation>
    </message>
    <message>
        <source>Depth below the top; the default is down to the part (mm)</source>
        <translation>Tiefe unter der Oberkante; Vorgabe ist bis auf das Teil (mm)</translation>
    </message>
    <message>
        <source>Width of the chamfer, seen from above (mm)</source>
        <translation>Breite der Fase, von oben gesehen (mm)</translation>
    </message>
    <message>
        <source>Beyond</source>
        <translation>Überstand</translation>
    </message>
    <message>
        <source>Distance of the tool's axis from the edge (mm)</source>
        <translation>Abstand der Werkzeugachse von der Kante (mm)</translation>
    </message>
    <message>
        <source>Z of the edge; the default is the top of the part (mm)</source>
        <translation>Z der Kante; Vorgabe ist die Oberkante des Teils (mm)</translation>
    </message>
    <message>
        <source>Distance of passes on a flat floor (mm)</source>
        <translation>Abstand der Bahnen auf ebenem Boden (mm)</translation>
    </message>
    <message>
        <source>Distance of the passes (diameters)</source>
        <translation>Abstand der Bahnen (Durchmesser)</translation>
    </message>
    <message>
        <source>Tolerance of the path against the surface (mm)</source>
        <translation>Toleranz der Bahn gegen die Oberfläche (mm)</translation>
    </message>
    <message>
        <source>Z where the cut begins; the default is the stock's top (mm)</source>
        <translation>Z, bei dem der Schnitt beginnt; Vorgabe ist die Oberkante des Rohteils (mm)</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unterkante</translation>
    </message>
    <message>
        <source>Z where the cut ends; the default is the floor of the surface (mm)</source>
        <translation>Z, bei dem der Schnitt endet; Vorgabe ist der Boden der Oberfläche (mm)</translation>
    </message>
    <message>
        <source>Depth of each level; the default is half the tool's diameter (mm)</source>
        <translation>Tiefe jeder Ebene; Vorgabe ist der halbe Durchmesser des Werkzeugs (mm)</translation>
    </message>
    <message>
        <source>Pattern of the passes</source>
        <translation>Muster der Bahnen</translation>
    </message>
    <message>
        <source>Angle of the passes against x (degrees)</source>
        <translation>Winkel der Bahnen gegen x (Grad)</translation>
    </message>
    <message>
        <source>Scallop</source>
        <translation>Rillenhöhe</translation>
    </message>
    <message>
        <source>Height of the cusps between passes, instead of a stepover (mm)</source>
        <translation>Höhe der Rillen zwischen den Bahnen, statt eines Bahnabstands (mm)</translation>
    </message>
    <message>
        <source>Zigzag: every other pass runs back</source>
        <translation>Zickzack: jede zweite Bahn läuft zurück</translation>
    </message>
    <message>
        <source>Lowest z of the tool; the default is the floor of the surface (mm)</source>
        <translation>Kleinstes z des Werkzeugs; Vorgabe ist der Boden der Oberfläche (mm)</translation>
    </message>
    <message>
        <source>Skip Air</source>
        <translation>Luftschnitte auslassen</translation>
    </message>
    <message>
        <source>Leaves out passes where earlier operations left no stock</source>
        <translation>Lässt Bahnen aus, wo frühere Operationen kein Material übrig ließen</translation>
    </message>
    <message>
        <source>Rest</source>
        <translation>Restmaterial</translation>
    </message>
    <message>
        <source>Rest machining: only where earlier operations left material</source>
        <translation>Restmaterialbearbeitung: nur wo frühere Operationen Material übrig ließen</translation>
    </message>
    <message>
        <source>Rest Least</source>
        <translation>Kleinste Resthöhe</translation>
    </message>
    <message>
        <source>Least height of that material (mm)</source>
        <translation>Kleinste Höhe dieses Materials (mm)</translation>
    </message>
    <message>
        <source>Lean</source>
        <translation>Neigen</translation>
    </message>
    <message>
        <source>Five axes at once: the tool tilts with the surface</source>
        <translation>Fünf Achsen zugleich: das Werkzeug neigt sich mit der Oberfläche</translation>
    </message>
    <message>
        <source>Lead</source>
        <translation>Voreilwinkel</translation>
    </message>
    <message>
        <source>Lead angle: tilt ahead of the surface normal, in the direction of travel (degrees)</source>
        <translation>Voreilwinkel: Neigung vor die Flächennormale, in Fahrtrichtung (Grad)</translation>
    </message>
    <message>
        <source>Most Lean</source>
        <translation>Größte Neigung</translation>
    </message>
    <message>
        <source>Greatest tilt against the plane's z (degrees)</source>
        <translation>Größte Neigung gegen die z-Achse der Ebene (Grad)</translation>
    </message>
    <message>
        <source>Body Clearance</source>
        <translation>Abstand des Schafts</translation>
    </message>
    <message>
        <source>Clearance of shank and holder from the part (mm)</source>
        <translation>Abstand von Schaft und Halter zum Teil (mm)</translation>
    </message>
    <message>
        <source>Least Angle</source>
        <translation>Kleinster Winkel</translation>
    </message>
    <message>
        <source>Least angle between the two sides (degrees)</source>
        <translation>Kleinster Winkel zwischen den beiden Seiten (Grad)</translation>
    </message>
    <message>
        <source>Feed rate of cuts (mm/min)</source>
        <translation>Vorschub beim Fräsen (mm/min)</translation>
    </message>
    <message>
        <source>Feed rate of plunges (mm/min)</source>
        <translation>Vorschub beim Eintauchen (mm/min)</translation>
    </message>
    <message>
        <source>Spindle speed (rpm)</source>
        <translation>Spindeldrehzahl (U/min)</translation>
    </message>
    <message>
        <source>Coolant</source>
        <translation>Kühlmittel</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Sicherheitshöhe</translation>
    </message>
    <message>
        <source>Height of rapids above the stock (mm)</source>
        <translation>Höhe der Eilgänge über dem Rohteil (mm)</translation>
    </message>
    <message>
        <source>Link Feed</source>
        <translation>Vorschub im Freien</translation>
    </message>
    <message>
        <source>Feed rate where the material is cut already; the default is the feed (mm/min)</source>
        <translation>Vorschub, wo das Material schon abgetragen ist; Vorgabe ist der Vorschub (mm/min)</translation>
    </message>
    <message>
        <source>Entry</source>
        <translation>Eintauchen</translation>
    </message>
    <message>
        <source>How closed paths are entered</source>
        <translation>Wie in geschlossene Bahnen eingetaucht wird</translation>
    </message>
    <message>
        <source>Ramp Angle</source>
        <translation>Rampenwinkel</translation>
    </message>
    <message>
        <source>Angle of ramps and helices (degrees)</source>
        <translation>Winkel von Rampen und Wendeln (Grad)</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Cut from: one face, the five visible ones, as seen (alpha, beta), or in even steps; a machine that cannot tilt stops for turning the part by hand</source>
        <translation>Von wo gefräst wird: von einer Seite, von den fünf sichtbaren, wie gesehen (alpha, beta) oder in gleichen Schritten; eine Maschine ohne Schwenkachsen hält an, damit das Teil von Hand gedreht wird</translation>
    </message>
    <message>
        <source>Alpha</source>
        <translation>Alpha</translation>
    </message>
    <message>
        <source>Rotation of a view about z (degrees)</source>
        <translation>Drehung einer Ansicht um z (Grad)</translation>
    </message>
    <message>
        <source>Beta</source>
        <translation>Beta</translation>
    </message>
    <message>
        <source>Rotation of a view about x, after that about z (degrees)</source>
        <translation>Drehung einer Ansicht um x, nach der um z (Grad)</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Number of stepped planes per half turn</source>
        <translation>Anzahl der Ebenen je halbe Umdrehung</translation>
    </message>
    <message>
        <source>Kerf</source>
        <translation>Schnittbreite</translation>
    </message>
    <message>
        <source>Width of the cut (mm)</source>
        <translation>Breite des Schnitts (mm)</translation>
    </message>
    <message>
        <source>Autofocus</source>
        <translation>Autofokus</translation>
    </message>
    <message>
        <source>Focus before the job</source>
        <translation>Vor dem Job fokussieren</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>Of the beam (%)</source>
        <translation>Des Strahls (%)</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>Of pulses (Hz)</source>
        <translation>Der Pulse (Hz)</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Of cutting (%)</source>
        <translation>Des Schnitts (%)</translation>
    </message>
    <message>
        <source>Xmin</source>
        <translation>X-Anfang</translation>
    </message>
    <message>
        <source>Where the program's zero lies (mm)</source>
        <translation>Wo der Nullpunkt des Programms liegt (mm)</translation>
    </message>
    <message>
        <source>Ymin</source>
        <translation>Y-Anfang</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Of the blade (g)</source>
        <translation>Des Messers (g)</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Of cutting (cm/s)</source>
        <translation>Des Schnitts (cm/s)</translation>
    </message>
    <message>
        <source>Cycles</source>
        <translation>Bohrzyklen</translation>
    </message>
    <message>
        <source>Drilling cycles of the control (G81, G83) instead of single moves</source>
        <translation>Bohrzyklen der Steuerung (G81, G83) statt einzelner Bewegungen</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>Eilgang</translation>
    </message>
    <message>
        <source>Speed between cuts (mm/s)</source>
        <translation>Geschwindigkeit zwischen den Schnitten (mm/s)</translation>
    </message>
    <message>
        <source>Of the attenuator (%)</source>
        <translation>Des Abschwächers (%)</translation>
    </message>
    <message>
        <source>Speed of jogs (units/s)</source>
        <translation>Geschwindigkeit der Eilgänge (units/s)</translation>
    </message>
    <message>
        <source>Speed of jogs (inches/s)</source>
        <translation>Geschwindigkeit der Eilgänge (inches/s)</translation>
    </message>
    <message>
        <source>Voxel</source>
        <translation>Zelle</translation>
    </message>
    <message>
        <source>Edge of the smallest cell; 0: 1/200 of the longest side (mm)</source>
        <translation>Kante der kleinsten Zelle; 0: 1/200 der längsten Seite (mm)</translation>
    </message>
    <message>
        <source>Of cutting (mm/s)</source>
        <translation>Des Schnitts (mm/s)</translation>
    </message>
</context>
<context>
    <name>Fieldfab</name>
    <message>
        <source>The mesh is {certainty}</source>
        <translation>Das Netz ist {certainty}</translation>
    </message>
    <message>
        <source>{label}: about {time}</source>
        <translation>{label}: etwa {time}</translation>
    </message>
    <message>
        <source>About {time}</source>
        <translation>Etwa {time}</translation>
    </message>
    <message>
        <source>{path} is written</source>
        <translation>{path} ist geschrieben</translation>
    </message>
    <message>
        <source>Shape gallery</source>
        <translation>Formengalerie</translation>
    </message>
    <message>
        <source>close the task panel first</source>
        <translation>zuerst das Aufgabenfenster schließen</translation>
    </message>
    <message>
        <source>FreeCAD's start page is updated when it is opened the next time</source>
        <translation>FreeCADs Startseite wird aktualisiert, wenn sie das nächste Mal geöffnet wird</translation>
    </message>
    <message>
        <source>{label} mesh</source>
        <translation>{label} Netz</translation>
    </message>
    <message>
        <source>Import scan: a volume, or any slice of a stack</source>
        <translation>Scan importieren: ein Volumen oder ein beliebiges Schichtbild eines Stapels</translation>
    </message>
    <message>
        <source>Run {path}?

A script can do on this computer whatever you can: read, change and delete your files. Run it only if you trust whoever wrote it.</source>
        <translation>{path} ausführen?

Ein Skript kann auf diesem Rechner alles, was Sie selbst können: Ihre Dateien lesen, ändern und löschen. Führen Sie es nur aus, wenn Sie dem vertrauen, der es geschrieben hat.</translation>
    </message>
    <message>
        <source>Running {path}</source>
        <translation>{path} läuft</translation>
    </message>
    <message>
        <source>Volumes and slices ({patterns});;All files (*)</source>
        <translation>Volumen und Schichtbilder ({patterns});;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Scripts ({patterns})</source>
        <translation>Skripte ({patterns})</translation>
    </message>
    <message>
        <source>The script was stopped.</source>
        <translation>Das Skript wurde angehalten.</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>{filename}: Fieldfab reads no .{ending} files</source>
        <translation>{filename}: Fieldfab liest keine .{ending}-Dateien</translation>
    </message>
    <message>
        <source>Import {label}</source>
        <translation>{label} importieren</translation>
    </message>
    <message>
        <source>{filename}: none of the selected objects bounds a solid</source>
        <translation>{filename}: keines der gewählten Objekte begrenzt einen Körper</translation>
    </message>
    <message>
        <source>Writing {filename}</source>
        <translation>{filename} wird geschrieben</translation>
    </message>
    <message>
        <source>{filename}: Fieldfab writes no .{ending} files</source>
        <translation>{filename}: Fieldfab schreibt keine .{ending}-Dateien</translation>
    </message>
    <message>
        <source>{filename}: cancelled, not written</source>
        <translation>{filename}: abgebrochen, nicht geschrieben</translation>
    </message>
    <message>
        <source>{label} has no formula: export it as .asdf or as a mesh</source>
        <translation>{label} hat keine Formel: als .asdf oder als Netz exportieren</translation>
    </message>
    <message>
        <source>the first coordinate, mm</source>
        <translation>die erste Koordinate, mm</translation>
    </message>
    <message>
        <source>the second coordinate, mm</source>
        <translation>die zweite Koordinate, mm</translation>
    </message>
    <message>
        <source>the third coordinate, mm</source>
        <translation>die dritte Koordinate, mm</translation>
    </message>
    <message>
        <source>exact distance</source>
        <translation>genauer Abstand</translation>
    </message>
    <message>
        <source>never more than the distance</source>
        <translation>nie mehr als der Abstand</translation>
    </message>
    <message>
        <source>{label} is empty</source>
        <translation>{label} ist leer</translation>
    </message>
    <message>
        <source>{label} has no solid: faces and wires enclose no volume</source>
        <translation>{label} hat keinen Körper: Flächen und Drähte schließen kein Volumen ein</translation>
    </message>
    <message>
        <source>{label} has neither a mesh nor a shape</source>
        <translation>{label} hat weder Netz noch Form</translation>
    </message>
    <message>
        <source>{filename}: cancelled; nothing was added</source>
        <translation>{filename}: abgebrochen; nichts wurde hinzugefügt</translation>
    </message>
    <message>
        <source>{label}: choose a Part</source>
        <translation>{label}: Part wählen</translation>
    </message>
    <message>
        <source>{label}: its tool is not one of the set-up's</source>
        <translation>{label}: Das Werkzeug gehört nicht zu dieser Aufspannung</translation>
    </message>
    <message>
        <source>{label}: choose a tool</source>
        <translation>{label}: Werkzeug wählen</translation>
    </message>
    <message>
        <source>{label}: choose a StockObject</source>
        <translation>{label}: StockObject wählen</translation>
    </message>
    <message>
        <source>any</source>
        <translation>beliebig</translation>
    </message>
    <message>
        <source>acrylic</source>
        <translation>Acryl</translation>
    </message>
    <message>
        <source>aluminium</source>
        <translation>Aluminium</translation>
    </message>
    <message>
        <source>cardboard</source>
        <translation>Pappe</translation>
    </message>
    <message>
        <source>copper</source>
        <translation>Kupfer</translation>
    </message>
    <message>
        <source>epoxy</source>
        <translation>Epoxidharz</translation>
    </message>
    <message>
        <source>fabric</source>
        <translation>Stoff</translation>
    </message>
    <message>
        <source>foam</source>
        <translation>Schaumstoff</translation>
    </message>
    <message>
        <source>foil</source>
        <translation>Folie</translation>
    </message>
    <message>
        <source>hard plastic</source>
        <translation>harter Kunststoff</translation>
    </message>
    <message>
        <source>hardwood</source>
        <translation>Hartholz</translation>
    </message>
    <message>
        <source>mdf</source>
        <translation>MDF</translation>
    </message>
    <message>
        <source>pcb</source>
        <translation>Leiterplatte</translation>
    </message>
    <message>
        <source>plywood</source>
        <translation>Sperrholz</translation>
    </message>
    <message>
        <source>soft plastic</source>
        <translation>weicher Kunststoff</translation>
    </message>
    <message>
        <source>vinyl</source>
        <translation>Vinyl</translation>
    </message>
    <message>
        <source>wax</source>
        <translation>Wachs</translation>
    </message>
    <message>
        <source>model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>corner</source>
        <translation>Ecke</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Margins</source>
        <translation>Zugaben</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>CAM job</source>
        <translation>CAM-Job</translation>
    </message>
    <message>
        <source>{label} has no size</source>
        <translation>{label} hat keine Ausdehnung</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>Schaftfräser</translation>
    </message>
    <message>
        <source>ball</source>
        <translation>Kugelfräser</translation>
    </message>
    <message>
        <source>bull</source>
        <translation>Torusfräser</translation>
    </message>
    <message>
        <source>v</source>
        <translation>V-Fräser</translation>
    </message>
    <message>
        <source>tapered</source>
        <translation>konischer Kugelfräser</translation>
    </message>
    <message>
        <source>drill</source>
        <translation>Bohrer</translation>
    </message>
    <message>
        <source>{diameter} end mill</source>
        <translation>Schaftfräser {diameter}</translation>
    </message>
    <message>
        <source>{diameter} ball end mill</source>
        <translation>Kugelfräser {diameter}</translation>
    </message>
    <message>
        <source>{diameter} bull-nose end mill</source>
        <translation>Torusfräser {diameter}</translation>
    </message>
    <message>
        <source>{diameter} V-bit</source>
        <translation>V-Fräser {diameter}</translation>
    </message>
    <message>
        <source>{diameter} tapered ball end mill</source>
        <translation>Konischer Kugelfräser {diameter}</translation>
    </message>
    <message>
        <source>{diameter} drill</source>
        <translation>Bohrer {diameter}</translation>
    </message>
    <message>
        <source>{label}: Diameter must be above 0</source>
        <translation>{label}: Der Durchmesser muss über 0 liegen</translation>
    </message>
    <message>
        <source>Union</source>
        <translation>Vereinigung</translation>
    </message>
    <message>
        <source>Intersection</source>
        <translation>Schnittmenge</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Verrundete Vereinigung</translation>
    </message>
    <message>
        <source>Morph</source>
        <translation>Übergang</translation>
    </message>
    <message>
        <source>{label}: choose at least two Sources</source>
        <translation>{label}: mindestens zwei Ausgangskörper wählen</translation>
    </message>
    <message>
        <source>{label}: a morph has two Sources</source>
        <translation>{label}: Ein Übergang hat zwei Ausgangskörper</translation>
    </message>
    <message>
        <source>{label}: the Radius of a blend must be above 0</source>
        <translation>{label}: Der Radius der Verrundung muss über 0 liegen</translation>
    </message>
    <message>
        <source>{label}: choose the File of a model</source>
        <translation>{label}: die Datei eines Modells wählen</translation>
    </message>
    <message>
        <source>Program of {job}</source>
        <translation>Programm von {job}</translation>
    </message>
    <message>
        <source>{label}: nothing is planned yet</source>
        <translation>{label}: Es ist noch nichts geplant</translation>
    </message>
    <message>
        <source>{label}: choose a Setup</source>
        <translation>{label}: Aufspannung wählen</translation>
    </message>
    <message>
        <source>{label}: cancelled; it is unchanged</source>
        <translation>{label}: abgebrochen; es ist unverändert</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>Shell</source>
        <translation>Schale</translation>
    </message>
    <message>
        <source>Lattice infill</source>
        <translation>Gitterfüllung</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spiegeln</translation>
    </message>
    <message>
        <source>Linear array</source>
        <translation>Lineares Muster</translation>
    </message>
    <message>
        <source>Polar array</source>
        <translation>Kreismuster</translation>
    </message>
    <message>
        <source>Transform</source>
        <translation>Umformen</translation>
    </message>
    <message>
        <source>gyroid</source>
        <translation>Gyroid</translation>
    </message>
    <message>
        <source>schwarz_p</source>
        <translation>Schwarz P</translation>
    </message>
    <message>
        <source>diamond</source>
        <translation>Diamant</translation>
    </message>
    <message>
        <source>spinodal</source>
        <translation>Spinodal</translation>
    </message>
    <message>
        <source>cubic struts</source>
        <translation>Stäbe kubisch</translation>
    </message>
    <message>
        <source>BCC struts</source>
        <translation>Stäbe kubisch raumzentriert (BCC)</translation>
    </message>
    <message>
        <source>FCC struts</source>
        <translation>Stäbe kubisch flächenzentriert (FCC)</translation>
    </message>
    <message>
        <source>octet struts</source>
        <translation>Stäbe Oktett</translation>
    </message>
    <message>
        <source>honeycomb</source>
        <translation>Waben</translation>
    </message>
    <message>
        <source>{label}: choose a Source</source>
        <translation>{label}: Ausgangskörper wählen</translation>
    </message>
    <message>
        <source>{label}: Direction has no length</source>
        <translation>{label}: Die Richtung hat keine Länge</translation>
    </message>
    <message>
        <source>{label}: a factor is 0</source>
        <translation>{label}: Ein Faktor ist 0</translation>
    </message>
    <message>
        <source>{label}: {name} must be above 0</source>
        <translation>{label}: {name} muss über 0 liegen</translation>
    </message>
    <message>
        <source>{label}: OpenSCAD has no '{node}'</source>
        <translation>{label}: OpenSCAD hat kein „{node}“</translation>
    </message>
    <message>
        <source>{label}: {source} is no shape of OpenSCAD, and {node} takes no other</source>
        <translation>{label}: {source} ist keine Form von OpenSCAD, und {node} nimmt keine andere</translation>
    </message>
    <message>
        <source>planar</source>
        <translation>eben</translation>
    </message>
    <message>
        <source>cylindrical</source>
        <translation>zylindrisch</translation>
    </message>
    <message>
        <source>conical</source>
        <translation>kegelig</translation>
    </message>
    <message>
        <source>spherical</source>
        <translation>kugelig</translation>
    </message>
    <message>
        <source>toroidal</source>
        <translation>torusförmig</translation>
    </message>
    <message>
        <source>free-form</source>
        <translation>frei geformt</translation>
    </message>
    <message>
        <source>recognising faces</source>
        <translation>Flächen werden erkannt</translation>
    </message>
    <message>
        <source>{label}: the mesh is empty</source>
        <translation>{label}: Das Netz ist leer</translation>
    </message>
    <message>
        <source>{label}: the {count} triangles bound no valid Part solid; allow more triangles, or make the solid coarser</source>
        <translation>{label}: Die {count} Dreiecke begrenzen keinen gültigen Part-Körper; mehr Dreiecke erlauben oder den Körper gröber machen</translation>
    </message>
    <message>
        <source>{label}: choose a solid or a mesh as its Source</source>
        <translation>{label}: einen Körper oder ein Netz als Quelle wählen</translation>
    </message>
    <message>
        <source>{label}: {source} has failed; the shape is unchanged</source>
        <translation>{label}: {source} ist fehlgeschlagen; die Form ist unverändert</translation>
    </message>
    <message>
        <source>{label}: {count} triangles remain where MostTriangles allows {most}; allow more, or make the solid coarser</source>
        <translation>{label}: Es bleiben {count} Dreiecke, wo MostTriangles {most} erlaubt; mehr erlauben oder den Körper gröber machen</translation>
    </message>
    <message>
        <source>FreeCAD's Path takes G-code in millimetres: choose such a machine</source>
        <translation>FreeCADs Path nimmt G-Code in Millimetern: eine solche Maschine wählen</translation>
    </message>
    <message>
        <source>{label}: the program has no operation {section} any more</source>
        <translation>{label}: Das Programm hat keine Operation {section} mehr</translation>
    </message>
    <message>
        <source>{label}: its tool is tilted now: make its path again</source>
        <translation>{label}: Sein Werkzeug ist jetzt geneigt: den Pfad neu machen</translation>
    </message>
    <message>
        <source>the program of {label} is empty</source>
        <translation>das Programm von {label} ist leer</translation>
    </message>
    <message>
        <source>the program {path} cannot be read: {error}</source>
        <translation>das Programm {path} kann nicht gelesen werden: {error}</translation>
    </message>
    <message>
        <source>{label} has no program</source>
        <translation>{label} hat kein Programm</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>changed since it was read</source>
        <translation>seit dem Lesen geändert</translation>
    </message>
    <message>
        <source>as it was read</source>
        <translation>wie gelesen</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>noch nicht gelesen</translation>
    </message>
    <message>
        <source>{label}: choose the File of a scan</source>
        <translation>{label}: die Datei eines Scans wählen</translation>
    </message>
    <message>
        <source>{label}: Samples are three numbers, or none</source>
        <translation>{label}: Samples sind drei Zahlen oder keine</translation>
    </message>
    <message>
        <source>{label}: Crop is the first sample along x, y and z, then the last, or nothing</source>
        <translation>{label}: Crop ist der erste Messpunkt in x, y und z, dann der letzte, oder nichts</translation>
    </message>
    <message>
        <source>{label}: {error}; double-click it to find the file</source>
        <translation>{label}: {error}; ein Doppelklick darauf hilft, die Datei zu finden</translation>
    </message>
    <message>
        <source>{label}: the scan {path} is {state}; the mesh is unchanged</source>
        <translation>{label}: Der Scan {path} ist {state}; das Netz ist unverändert</translation>
    </message>
    <message>
        <source>{label}: its script may run only after you have agreed; double-click the solid</source>
        <translation>{label}: Das Skript läuft erst, wenn Sie zugestimmt haben; doppelklicken Sie den Körper</translation>
    </message>
    <message>
        <source>a tool has the form {example}, not {line!r}</source>
        <translation>ein Werkzeug hat die Form {example}, nicht {line!r}</translation>
    </message>
    <message>
        <source>a tool has no {unknown!r}; it has {known}</source>
        <translation>ein Werkzeug hat kein {unknown!r}; es hat {known}</translation>
    </message>
    <message>
        <source>three axes</source>
        <translation>drei Achsen</translation>
    </message>
    <message>
        <source>the machine's</source>
        <translation>wie die Maschine</translation>
    </message>
    <message>
        <source>fixture contact</source>
        <translation>Kollision mit der Spannung</translation>
    </message>
    <message>
        <source>holder contact</source>
        <translation>Kollision des Halters</translation>
    </message>
    <message>
        <source>shank contact</source>
        <translation>Kollision des Schafts</translation>
    </message>
    <message>
        <source>rapid contact</source>
        <translation>Kollision im Eilgang</translation>
    </message>
    <message>
        <source>over-travel</source>
        <translation>Verfahrweg überschritten</translation>
    </message>
    <message>
        <source>spindle stopped</source>
        <translation>Spindel steht</translation>
    </message>
    <message>
        <source>gouge</source>
        <translation>Verletzung</translation>
    </message>
    <message>
        <source>excess</source>
        <translation>Restmaterial</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>{count} events, the worst: {kind} at line {line}</source>
        <translation>{count} Ereignisse, das schlimmste: {kind} in Zeile {line}</translation>
    </message>
    <message>
        <source>{label}: the set-up {path} cannot be read: {error}</source>
        <translation>{label}: Die Aufspannung {path} kann nicht gelesen werden: {error}</translation>
    </message>
    <message>
        <source>{label} was not simulated yet</source>
        <translation>{label} wurde noch nicht simuliert</translation>
    </message>
    <message>
        <source>{label}: choose a program</source>
        <translation>{label}: Programm wählen</translation>
    </message>
    <message>
        <source>{label}: the stock has no size: give its corners, or a solid as Stock</source>
        <translation>{label}: Das Rohteil hat keine Ausdehnung: seine Ecken angeben oder einen Körper als Rohteil</translation>
    </message>
    <message>
        <source>{label}: {other} could not be computed</source>
        <translation>{label}: {other} konnte nicht berechnet werden</translation>
    </message>
    <message>
        <source>{label}: choose a mesh, a Part object or a body as its Source</source>
        <translation>{label}: ein Netz, ein Part-Objekt oder einen Body als Quelle wählen</translation>
    </message>
    <message>
        <source>draws nothing</source>
        <translation>ergibt nichts</translation>
    </message>
    <message>
        <source>{label}: the file {path} is not there</source>
        <translation>{label}: Die Datei {path} ist nicht da</translation>
    </message>
    <message>
        <source>Reading {name}</source>
        <translation>{name} wird gelesen</translation>
    </message>
    <message>
        <source>{filename}: the design is empty</source>
        <translation>{filename}: Der Entwurf ist leer</translation>
    </message>
    <message>
        <source>{filename}: more than {most} parts; {count} branches became one object each, with their text</source>
        <translation>{filename}: mehr als {most} Teile; {count} Zweige wurden je ein Objekt, mit ihrem Text</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Operation</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Werkstück</translation>
    </message>
    <message>
        <source>Click a corner, the middle of an edge or face, or a hole of the part in the 3D view</source>
        <translation>Klicken Sie in der 3D-Ansicht auf eine Ecke, die Mitte einer Kante oder Fläche oder eine Bohrung des Teils</translation>
    </message>
    <message>
        <source>Zero</source>
        <translation>Nullpunkt</translation>
    </message>
    <message>
        <source>Click a corner, the middle of an edge or face, or a hole of the part</source>
        <translation>Klicken Sie auf eine Ecke, die Mitte einer Kante oder Fläche oder eine Bohrung des Teils</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Rohteil</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Operations</source>
        <translation>Operationen</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Werkstoff</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Planen</translation>
    </message>
    <message>
        <source>Plans all paths in the background</source>
        <translation>Plant alle Pfade im Hintergrund</translation>
    </message>
    <message>
        <source>Adjust feeds to the cut</source>
        <translation>Vorschübe an den Eingriff anpassen</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>The part, and the program's zero on it</source>
        <translation>Das Werkstück und der Nullpunkt des Programms daran</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>Choose a part first</source>
        <translation>Wählen Sie zuerst ein Teil</translation>
    </message>
    <message>
        <source>There is no corner, middle or hole of the part: click again</source>
        <translation>Dort ist keine Ecke, Mitte oder Bohrung des Teils: klicken Sie noch einmal</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>The chosen operation</source>
        <translation>Die gewählte Operation</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>Früher</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Später</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>noch keine</translation>
    </message>
    <message>
        <source>up to {limit}</source>
        <translation>bis {limit}</translation>
    </message>
    <message>
        <source>Planning</source>
        <translation>Es wird geplant</translation>
    </message>
    <message>
        <source>stopped; the program is unchanged</source>
        <translation>angehalten; das Programm ist unverändert</translation>
    </message>
    <message>
        <source>travel {travel}</source>
        <translation>Verfahrweg {travel}</translation>
    </message>
    <message>
        <source>turns about {axes}</source>
        <translation>dreht um {axes}</translation>
    </message>
    <message>
        <source>{time} with the planned feeds</source>
        <translation>{time} mit den geplanten Vorschüben</translation>
    </message>
    <message>
        <source>{count} tools</source>
        <translation>{count} Werkzeuge</translation>
    </message>
    <message>
        <source>Planning: {message}</source>
        <translation>Es wird geplant: {message}</translation>
    </message>
    <message>
        <source>{setting}: see above</source>
        <translation>{setting}: siehe oben</translation>
    </message>
    <message>
        <source>(changed since)</source>
        <translation>(seither geändert)</translation>
    </message>
    <message>
        <source>and</source>
        <translation>und</translation>
    </message>
    <message>
        <source>Measured value and its bound</source>
        <translation>Messwert und seine Schranke</translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv);;Text (*.txt)</source>
        <translation>Kommagetrennte Werte (*.csv);;Text (*.txt)</translation>
    </message>
    <message>
        <source>Cross-check</source>
        <translation>Gegenprüfung</translation>
    </message>
    <message>
        <source>Deviations in colours</source>
        <translation>Abweichungen in Farben</translation>
    </message>
    <message>
        <source>Save table…</source>
        <translation>Tabelle speichern …</translation>
    </message>
    <message>
        <source>{broken} of {count} checks are broken.</source>
        <translation>{broken} von {count} Prüfungen sind nicht bestanden.</translation>
    </message>
    <message>
        <source>All {count} checks are passed.</source>
        <translation>Alle {count} Prüfungen sind bestanden.</translation>
    </message>
    <message>
        <source>Save table</source>
        <translation>Tabelle speichern</translation>
    </message>
    <message>
        <source>Checking {label} against OpenVDB and CGAL…</source>
        <translation>{label} wird gegen OpenVDB und CGAL geprüft …</translation>
    </message>
    <message>
        <source>{measured} of {bound}</source>
        <translation>{measured} von {bound}</translation>
    </message>
    <message>
        <source>Mesh to solid: {mean} on average, {most} at most.</source>
        <translation>Netz zum Körper: {mean} im Mittel, {most} höchstens.</translation>
    </message>
    <message>
        <source>Computing</source>
        <translation>Wird berechnet</translation>
    </message>
    <message>
        <source>Edit {label}</source>
        <translation>{label} bearbeiten</translation>
    </message>
    <message>
        <source>Valid</source>
        <translation>Gültig</translation>
    </message>
    <message>
        <source>Computing: {message}</source>
        <translation>Wird berechnet: {message}</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Ereignis</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Maß</translation>
    </message>
    <message>
        <source>nothing went wrong</source>
        <translation>nichts ging schief</translation>
    </message>
    <message>
        <source>{kind}: {count}</source>
        <translation>{kind}: {count}</translation>
    </message>
    <message>
        <source>Line {line}: {words} (and {count} more)</source>
        <translation>Zeile {line}: {words} (und {count} weitere)</translation>
    </message>
    <message>
        <source>Line {line}: {words}</source>
        <translation>Zeile {line}: {words}</translation>
    </message>
    <message>
        <source>F-rep solid</source>
        <translation>F-Rep-Körper</translation>
    </message>
    <message>
        <source>Insert a shape…</source>
        <translation>Form einfügen …</translation>
    </message>
    <message>
        <source>Choose a shape by its picture; it is inserted where the cursor is</source>
        <translation>Eine Form nach ihrem Bild wählen; sie wird an der Schreibmarke eingefügt</translation>
    </message>
    <message>
        <source>a tenth of the smallest cell</source>
        <translation>ein Zehntel der kleinsten Zelle</translation>
    </message>
    <message>
        <source>Smallest cell</source>
        <translation>Kleinste Zelle</translation>
    </message>
    <message>
        <source>Largest error</source>
        <translation>Größter Fehler</translation>
    </message>
    <message>
        <source>{name} is driven by an expression</source>
        <translation>{name} wird von einem Ausdruck bestimmt</translation>
    </message>
    <message>
        <source>Parameter {name} of the text, also a property of the object</source>
        <translation>Parameter {name} des Texts, auch eine Eigenschaft des Objekts</translation>
    </message>
    <message>
        <source>{count} operations</source>
        <translation>{count} Rechenschritte</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>1/{cells} of the longest side</source>
        <translation>1/{cells} der längsten Seite</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>Numbers of the text are in mm</source>
        <translation>Zahlen im Text sind in mm</translation>
    </message>
    <message>
        <source>0 is automatic: {zero}</source>
        <translation>0 heißt automatisch: {zero}</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Search: a name, or what it does</source>
        <translation>Suche: ein Name, oder was es tut</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Make this solid</source>
        <translation>Diesen Körper anlegen</translation>
    </message>
    <message>
        <source>Insert at the cursor</source>
        <translation>An der Schreibmarke einfügen</translation>
    </message>
    <message>
        <source>a number, a shape, or any formula</source>
        <translation>eine Zahl, eine Form oder eine beliebige Formel</translation>
    </message>
    <message>
        <source>values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>default: {default}</source>
        <translation>Vorgabe: {default}</translation>
    </message>
    <message>
        <source>Histogram of the densities, on a logarithmic scale. Drag the line to move the threshold</source>
        <translation>Histogramm der Dichten, mit logarithmischer Skala. Die Linie ziehen, um die Schwelle zu verschieben</translation>
    </message>
    <message>
        <source>no densities yet</source>
        <translation>noch keine Dichten</translation>
    </message>
    <message>
        <source>{name} is {value}</source>
        <translation>{name} ist {value}</translation>
    </message>
    <message>
        <source>The number</source>
        <translation>Die Zahl</translation>
    </message>
    <message>
        <source>active</source>
        <translation>aktiv</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>defaults</source>
        <translation>Vorgaben</translation>
    </message>
    <message>
        <source>{given} given</source>
        <translation>{given} angegeben</translation>
    </message>
    <message>
        <source>Speed relative to the machine</source>
        <translation>Geschwindigkeit im Verhältnis zur Maschine</translation>
    </message>
    <message>
        <source>Go to a line of the program</source>
        <translation>Zu einer Zeile des Programms gehen</translation>
    </message>
    <message>
        <source>Show the cutter</source>
        <translation>Die Schneide zeigen</translation>
    </message>
    <message>
        <source>Shank and holder</source>
        <translation>Schaft und Halter</translation>
    </message>
    <message>
        <source>Show the shank and the holder, which must not touch anything</source>
        <translation>Schaft und Halter zeigen, die nichts berühren dürfen</translation>
    </message>
    <message>
        <source>Deviation at the end</source>
        <translation>Abweichung am Ende</translation>
    </message>
    <message>
        <source>Colour the finished stock by its distance from the target</source>
        <translation>Das fertige Rohteil nach seinem Abstand vom Ziel färben</translation>
    </message>
    <message>
        <source>Table turns</source>
        <translation>Tisch dreht sich</translation>
    </message>
    <message>
        <source>Turn the stock with the machine's table</source>
        <translation>Das Rohteil mit dem Tisch der Maschine drehen</translation>
    </message>
    <message>
        <source>Show the stock as it is at this moment</source>
        <translation>Das Rohteil zeigen, wie es in diesem Augenblick ist</translation>
    </message>
    <message>
        <source>Show the solid that the program should produce</source>
        <translation>Den Körper zeigen, den das Programm ergeben soll</translation>
    </message>
    <message>
        <source>Paths</source>
        <translation>Bahnen</translation>
    </message>
    <message>
        <source>Show the paths of the tool tips, each tool in its colour</source>
        <translation>Die Wege der Werkzeugspitzen zeigen, jedes Werkzeug in seiner Farbe</translation>
    </message>
    <message>
        <source>To the beginning</source>
        <translation>Zum Anfang</translation>
    </message>
    <message>
        <source>Previous move</source>
        <translation>Vorige Bewegung</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Abspielen oder anhalten</translation>
    </message>
    <message>
        <source>Next move</source>
        <translation>Nächste Bewegung</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>Zum Ende</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>this place was not cut</source>
        <translation>diese Stelle wurde nicht geschnitten</translation>
    </message>
    <message>
        <source>line {line}: {message}</source>
        <translation>Zeile {line}: {message}</translation>
    </message>
    <message>
        <source>Position of axis {letter}, {unit}</source>
        <translation>Position der Achse {letter}, {unit}</translation>
    </message>
    <message>
        <source>this place was cut by line {line} with tool {tool}</source>
        <translation>diese Stelle wurde von Zeile {line} mit Werkzeug {tool} geschnitten</translation>
    </message>
    <message>
        <source>tool {tool}, rapid</source>
        <translation>Werkzeug {tool}, Eilgang</translation>
    </message>
    <message>
        <source>tool {tool}</source>
        <translation>Werkzeug {tool}</translation>
    </message>
    <message>
        <source>rapids</source>
        <translation>Eilgang</translation>
    </message>
    <message>
        <source>cuts of tool {tool}</source>
        <translation>Schnitte mit Werkzeug {tool}</translation>
    </message>
    <message>
        <source>{count} lines. {about}</source>
        <translation>{count} Zeilen. {about}</translation>
    </message>
    <message>
        <source>The program. Click a line to go to its moment</source>
        <translation>Das Programm. Ein Klick auf eine Zeile führt zu ihrem Zeitpunkt</translation>
    </message>
    <message>
        <source>Combine</source>
        <translation>Verknüpfen</translation>
    </message>
    <message>
        <source>Modify</source>
        <translation>Verändern</translation>
    </message>
    <message>
        <source>Solid from object</source>
        <translation>Körper aus Objekt</translation>
    </message>
    <message>
        <source>Part shape</source>
        <translation>Part-Form</translation>
    </message>
    <message>
        <source>Part of a model</source>
        <translation>Teil eines Modells</translation>
    </message>
    <message>
        <source>Path of program</source>
        <translation>Pfad des Programms</translation>
    </message>
    <message>
        <source>OpenSCAD shape</source>
        <translation>OpenSCAD-Form</translation>
    </message>
    <message>
        <source>OpenSCAD text</source>
        <translation>OpenSCAD-Text</translation>
    </message>
    <message>
        <source>Machine program</source>
        <translation>Maschinenprogramm</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Scan</translation>
    </message>
    <message>
        <source>file, or folder of slices</source>
        <translation>Datei oder Ordner mit Schichtbildern</translation>
    </message>
    <message>
        <source>Raw file</source>
        <translation>Rohdatei</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>Halfway between the two most frequent densities, air and material</source>
        <translation>In der Mitte zwischen den zwei häufigsten Dichten, Luft und Material</translation>
    </message>
    <message>
        <source>Densities below the threshold are solid</source>
        <translation>Dichten unter der Schwelle sind Körper</translation>
    </message>
    <message>
        <source>Other spacing</source>
        <translation>Anderer Abstand</translation>
    </message>
    <message>
        <source>Crop (first, last sample)</source>
        <translation>Ausschnitt (erster, letzter Messpunkt)</translation>
    </message>
    <message>
        <source>Clean-up</source>
        <translation>Bereinigen</translation>
    </message>
    <message>
        <source>Largest piece only</source>
        <translation>Nur das größte Stück</translation>
    </message>
    <message>
        <source>Pieces of less volume are removed</source>
        <translation>Stücke von kleinerem Volumen werden entfernt</translation>
    </message>
    <message>
        <source>Cavities of less volume are filled</source>
        <translation>Hohlräume von kleinerem Volumen werden gefüllt</translation>
    </message>
    <message>
        <source>Denoise</source>
        <translation>Entrauschen</translation>
    </message>
    <message>
        <source>Remove islands smaller than</source>
        <translation>Inseln entfernen, kleiner als</translation>
    </message>
    <message>
        <source>Fill holes smaller than</source>
        <translation>Löcher füllen, kleiner als</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>Datei …</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Ordner …</translation>
    </message>
    <message>
        <source>Samples along x, y, z</source>
        <translation>Messpunkte in x, y, z</translation>
    </message>
    <message>
        <source>Below it</source>
        <translation>Darunter</translation>
    </message>
    <message>
        <source>as the samples</source>
        <translation>wie die Messpunkte</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>Folder of slices</source>
        <translation>Ordner mit Schichtbildern</translation>
    </message>
    <message>
        <source>Choose a volume's file, or a folder of its slices.</source>
        <translation>Die Datei eines Volumens wählen oder einen Ordner mit seinen Schichtbildern.</translation>
    </message>
    <message>
        <source>The last sample of a crop must lie after the first.</source>
        <translation>Der letzte Messpunkt eines Ausschnitts muss hinter dem ersten liegen.</translation>
    </message>
    <message>
        <source>There is no solid at this threshold.</source>
        <translation>Bei dieser Schwelle gibt es keinen Körper.</translation>
    </message>
    <message>
        <source>Choose a file first, or Cancel.</source>
        <translation>Zuerst eine Datei wählen, oder abbrechen.</translation>
    </message>
    <message>
        <source>CT volume</source>
        <translation>CT-Volumen</translation>
    </message>
    <message>
        <source>{count} samples of {spacing}, {kind}</source>
        <translation>{count} Messpunkte im Abstand {spacing}, {kind}</translation>
    </message>
    <message>
        <source>About {count} triangles, {memory} MB</source>
        <translation>Etwa {count} Dreiecke, {memory} MB</translation>
    </message>
    <message>
        <source>A distance field: it is used unchanged.</source>
        <translation>Ein Abstandsfeld: Es wird unverändert verwendet.</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Wird gelesen …</translation>
    </message>
    <message>
        <source>The scan {path} is missing: choose where it is now. The solid keeps the mesh it has.</source>
        <translation>Der Scan {path} fehlt: wählen, wo er jetzt ist. Der Körper behält sein Netz.</translation>
    </message>
    <message>
        <source>A script can do on this computer whatever you can: read, change and delete your files. Run it only if you trust whoever wrote it.</source>
        <translation>Ein Skript kann auf diesem Rechner alles, was Sie können: Ihre Dateien lesen, ändern und löschen. Führen Sie es nur aus, wenn Sie seinem Verfasser vertrauen.</translation>
    </message>
    <message>
        <source>Python model</source>
        <translation>Python-Modell</translation>
    </message>
    <message>
        <source>The script is run</source>
        <translation>Das Skript wird ausgeführt</translation>
    </message>
    <message>
        <source>The script is not run</source>
        <translation>Das Skript wird nicht ausgeführt</translation>
    </message>
    <message>
        <source>Run this document's scripts</source>
        <translation>Skripte dieses Dokuments ausführen</translation>
    </message>
    <message>
        <source>Until the document is closed, its scripts run whenever they have changed</source>
        <translation>Bis das Dokument geschlossen wird, laufen seine Skripte nach jeder Änderung</translation>
    </message>
    <message>
        <source>default</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>{default} (default)</source>
        <translation>{default} (Vorgabe)</translation>
    </message>
    <message>
        <source>form</source>
        <translation>Formfräser</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Eckradius</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Flute</source>
        <translation>Schneide</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Shank</source>
        <translation>Schaft</translation>
    </message>
    <message>
        <source>Holder ⌀</source>
        <translation>Halter ⌀</translation>
    </message>
    <message>
        <source>Holder length</source>
        <translation>Halterlänge</translation>
    </message>
    <message>
        <source>a file</source>
        <translation>eine Datei</translation>
    </message>
    <message>
        <source>the machine's program</source>
        <translation>das Programm der Maschine</translation>
    </message>
    <message>
        <source>Programs (*.nc *.ngc *.tap *.gcode *.cnc *.sbp *.rml *.plt *.hpgl);;All files (*)</source>
        <translation>Programme (*.nc *.ngc *.tap *.gcode *.cnc *.sbp *.rml *.plt *.hpgl);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>none: a file, or the settings below</source>
        <translation>keine: eine Datei oder die Einstellungen darunter</translation>
    </message>
    <message>
        <source>none: the settings below</source>
        <translation>keine: die Einstellungen darunter</translation>
    </message>
    <message>
        <source>Set-ups and jobs (*.toml)</source>
        <translation>Aufspannungen und Aufträge (*.toml)</translation>
    </message>
    <message>
        <source>none, or that of the set-up</source>
        <translation>keines, oder das der Aufspannung</translation>
    </message>
    <message>
        <source>Program of</source>
        <translation>Programm von</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Dialect</source>
        <translation>Dialekt</translation>
    </message>
    <message>
        <source>Set-up of</source>
        <translation>Aufspannung von</translation>
    </message>
    <message>
        <source>Set-up file</source>
        <translation>Aufspanndatei</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Zelle</translation>
    </message>
    <message>
        <source>Set-up</source>
        <translation>Aufspannung</translation>
    </message>
    <message>
        <source>a box</source>
        <translation>ein Quader</translation>
    </message>
    <message>
        <source>Around the program</source>
        <translation>Um das Programm</translation>
    </message>
    <message>
        <source>A box around all positions of the program</source>
        <translation>Ein Quader um alle Positionen des Programms</translation>
    </message>
    <message>
        <source>Gouge tolerance</source>
        <translation>Toleranz für Verletzungen</translation>
    </message>
    <message>
        <source>Excess tolerance</source>
        <translation>Toleranz für Restmaterial</translation>
    </message>
    <message>
        <source>Contact tolerance</source>
        <translation>Toleranz für Kollisionen</translation>
    </message>
    <message>
        <source>Add tool</source>
        <translation>Werkzeug hinzufügen</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>tool {row}: {words} is a number, not {text!r}</source>
        <translation>Werkzeug {row}: {words} ist eine Zahl, nicht {text!r}</translation>
    </message>
    <message>
        <source>Playback</source>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>Simulate</source>
        <translation>Simulieren</translation>
    </message>
    <message>
        <source>Folder for frame_0001.png and so on</source>
        <translation>Ordner für frame_0001.png und so weiter</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Bericht …</translation>
    </message>
    <message>
        <source>Write the report as an HTML page with pictures</source>
        <translation>Den Bericht als HTML-Seite mit Bildern schreiben</translation>
    </message>
    <message>
        <source>Frames…</source>
        <translation>Einzelbilder …</translation>
    </message>
    <message>
        <source>Write pictures for a film</source>
        <translation>Bilder für einen Film schreiben</translation>
    </message>
    <message>
        <source>Keep as object</source>
        <translation>Als Objekt behalten</translation>
    </message>
    <message>
        <source>Keep the stock as it is at this moment as a mesh of the document</source>
        <translation>Das Rohteil, wie es in diesem Augenblick ist, als Netz des Dokuments behalten</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>HTML (*.html)</source>
        <translation>HTML (*.html)</translation>
    </message>
    <message>
        <source>{label}, stock at line {line}</source>
        <translation>{label}, Rohteil in Zeile {line}</translation>
    </message>
    <message>
        <source>stopped; the result is unchanged</source>
        <translation>angehalten; das Ergebnis ist unverändert</translation>
    </message>
    <message>
        <source>press Simulate to play it</source>
        <translation>Simulieren drücken, um es abzuspielen</translation>
    </message>
    <message>
        <source>kept: {label}</source>
        <translation>behalten: {label}</translation>
    </message>
    <message>
        <source>written: {path}</source>
        <translation>geschrieben: {path}</translation>
    </message>
    <message>
        <source>{count} frames are in {folder}</source>
        <translation>{count} Einzelbilder liegen in {folder}</translation>
    </message>
    <message>
        <source>Tool library</source>
        <translation>Werkzeugbibliothek</translation>
    </message>
    <message>
        <source>Tools of FreeCAD or Fusion (*.fctb *.fctl *.json)</source>
        <translation>Werkzeuge von FreeCAD oder Fusion (*.fctb *.fctl *.json)</translation>
    </message>
    <message>
        <source>Add to job</source>
        <translation>Zum Job hinzufügen</translation>
    </message>
    <message>
        <source>The chosen tools; a double click adds one</source>
        <translation>Die ausgewählten Werkzeuge; ein Doppelklick fügt eines hinzu</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importieren…</translation>
    </message>
    <message>
        <source>Tools of FreeCAD (.fctb, .fctl) or Fusion (.json)</source>
        <translation>Werkzeuge von FreeCAD (.fctb, .fctl) oder Fusion (.json)</translation>
    </message>
    <message>
        <source>The chosen tools leave the library; jobs keep theirs</source>
        <translation>Die ausgewählten Werkzeuge verlassen die Bibliothek; Jobs behalten ihre</translation>
    </message>
    <message>
        <source>The library is empty: import tools, or keep those of a job</source>
        <translation>Die Bibliothek ist leer: importieren Sie Werkzeuge oder behalten Sie die eines Jobs</translation>
    </message>
    <message>
        <source>{count} tools added to the job</source>
        <translation>{count} Werkzeuge zum Job hinzugefügt</translation>
    </message>
    <message>
        <source>{name} added to the job</source>
        <translation>{name} zum Job hinzugefügt</translation>
    </message>
    <message>
        <source>{count} tools imported</source>
        <translation>{count} Werkzeuge importiert</translation>
    </message>
    <message>
        <source>{name}: Fieldfab does not know the tool shape {shape}</source>
        <translation>{name}: Fieldfab kennt die Werkzeugform {shape} nicht</translation>
    </message>
    <message>
        <source>⌀ {unit}</source>
        <translation>⌀ {unit}</translation>
    </message>
    <message>
        <source>a diameter must be above 0</source>
        <translation>ein Durchmesser muss über 0 liegen</translation>
    </message>
    <message>
        <source>A new end mill</source>
        <translation>Ein neuer Schaftfräser</translation>
    </message>
    <message>
        <source>Library…</source>
        <translation>Bibliothek…</translation>
    </message>
    <message>
        <source>Your tools, for all documents</source>
        <translation>Ihre Werkzeuge, für alle Dokumente</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Puts the chosen tool into your library</source>
        <translation>Legt das ausgewählte Werkzeug in Ihre Bibliothek</translation>
    </message>
    <message>
        <source>The chosen tool</source>
        <translation>Das gewählte Werkzeug</translation>
    </message>
    <message>
        <source>The library has this tool already</source>
        <translation>Die Bibliothek hat dieses Werkzeug schon</translation>
    </message>
    <message>
        <source>tool number {number} is already in use</source>
        <translation>die Werkzeugnummer {number} ist schon vergeben</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>as the operation says</source>
        <translation>wie die Operation sagt</translation>
    </message>
    <message>
        <source>{text!r} is no number</source>
        <translation>{text!r} ist keine Zahl</translation>
    </message>
    <message>
        <source>rpm</source>
        <translation>U/min</translation>
    </message>
    <message>
        <source>{label}: no known machine has the rotary axes {letters}: choose the machine</source>
        <translation>{label}: Keine bekannte Maschine hat die Drehachsen {letters}: Maschine wählen</translation>
    </message>
    <message>
        <source>Block of {job}</source>
        <translation>Quader von {job}</translation>
    </message>
    <message>
        <source>{label}: no active operation has a path</source>
        <translation>{label}: Keine aktive Operation hat einen Pfad</translation>
    </message>
    <message>
        <source>{label}: its Placement turns the path, which a program cannot express</source>
        <translation>{label}: Seine Placement dreht den Pfad, was ein Programm nicht ausdrücken kann</translation>
    </message>
    <message>
        <source>{label}: it has no stock</source>
        <translation>{label}: Es gibt kein Rohteil</translation>
    </message>
    <message>
        <source>{label}: it has no tool controller</source>
        <translation>{label}: Es gibt keine Werkzeugsteuerung</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ohne</translation>
    </message>
    <message>
        <source>median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>gaussian</source>
        <translation>Gauß</translation>
    </message>
    <message>
        <source>anisotropic</source>
        <translation>anisotrop</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>wie die Datei sagt</translation>
    </message>
    <message>
        <source>the scan {path} is not there</source>
        <translation>der Scan {path} ist nicht da</translation>
    </message>
    <message>
        <source>the process ended without a result</source>
        <translation>der Prozess endete ohne Ergebnis</translation>
    </message>
    <message>
        <source>the script is too deep</source>
        <translation>das Skript ist zu tief verschachtelt</translation>
    </message>
    <message>
        <source>{format} files hold no meshes. Convert {names} to a Part shape and write that?</source>
        <translation>{format}-Dateien enthalten keine Netze. {names} in eine Part-Form umwandeln und diese schreiben?</translation>
    </message>
    <message>
        <source>{format} files hold no meshes: {names} is converted to a Part shape</source>
        <translation>{format}-Dateien enthalten keine Netze: {names} wird in eine Part-Form umgewandelt</translation>
    </message>
    <message>
        <source>Designs</source>
        <translation>Entwürfe</translation>
    </message>
    <message>
        <source>{name}: it has no diameter</source>
        <translation>{name}: Es fehlt der Durchmesser</translation>
    </message>
    <message>
        <source>{path}: this is no tool bit ({error})</source>
        <translation>{path}: Das ist kein Werkzeug ({error})</translation>
    </message>
    <message>
        <source>{path}: this is no tool library ({error})</source>
        <translation>{path}: Das ist keine Werkzeugbibliothek ({error})</translation>
    </message>
    <message>
        <source>{name}: there is no such file beside the library</source>
        <translation>{name}: Neben der Bibliothek gibt es keine solche Datei</translation>
    </message>
    <message>
        <source>{path} is of another version</source>
        <translation>{path} ist von einer anderen Version</translation>
    </message>
    <message>
        <source>diameters</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>inches/s</source>
        <translation>Zoll/s</translation>
    </message>
    <message>
        <source>units/s</source>
        <translation>Einheiten/s</translation>
    </message>
    <message>
        <source>must be a number</source>
        <translation>muss eine Zahl sein</translation>
    </message>
    <message>
        <source>must be a number in {unit}</source>
        <translation>muss eine Zahl in {unit} sein</translation>
    </message>
    <message>
        <source>Deviation, {unit}</source>
        <translation>Abweichung, {unit}</translation>
    </message>
    <message>
        <source>deviation, {unit}</source>
        <translation>Abweichung, {unit}</translation>
    </message>
    <message>
        <source>left over</source>
        <translation>Rest</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>außen</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>innen</translation>
    </message>
    <message>
        <source>Coarse preview: cells of {cell}</source>
        <translation>Grobe Vorschau: Zellen von {cell}</translation>
    </message>
    <message>
        <source>Preview: cells of {cell}</source>
        <translation>Vorschau: Zellen von {cell}</translation>
    </message>
    <message>
        <source>Final mesh</source>
        <translation>Endgültiges Netz</translation>
    </message>
    <message>
        <source>Refining where you look</source>
        <translation>Wird verfeinert, wo Sie hinsehen</translation>
    </message>
    <message>
        <source>Refined where you look</source>
        <translation>Verfeinert, wo Sie hinsehen</translation>
    </message>
    <message>
        <source>The view shows no solid to cut</source>
        <translation>Die Ansicht zeigt keinen Körper zum Schneiden</translation>
    </message>
    <message>
        <source>Click on a cut face: its thickness there, and the distance from the last click</source>
        <translation>Klicken Sie auf eine Schnittfläche: ihre Dicke dort und der Abstand zum letzten Klick</translation>
    </message>
    <message>
        <source>{length} thick</source>
        <translation>{length} dick</translation>
    </message>
    <message>
        <source>{length} wide</source>
        <translation>{length} weit</translation>
    </message>
    <message>
        <source>Nothing is cut there</source>
        <translation>Dort wird nichts geschnitten</translation>
    </message>
    <message>
        <source>{length} from the last point</source>
        <translation>{length} vom letzten Punkt</translation>
    </message>
    <message>
        <source>Show {label}</source>
        <translation>{label} zeigen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>Wird angehalten</translation>
    </message>
    <message>
        <source>must be finite</source>
        <translation>muss endlich sein</translation>
    </message>
    <message>
        <source>must be a whole number</source>
        <translation>muss eine ganze Zahl sein</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>must be at most {limit}</source>
        <translation>darf höchstens {limit} sein</translation>
    </message>
    <message>
        <source>must be one of {choices}</source>
        <translation>muss eines von {choices} sein</translation>
    </message>
    <message>
        <source>must be above {limit}</source>
        <translation>muss über {limit} liegen</translation>
    </message>
    <message>
        <source>must be at least {limit}</source>
        <translation>muss mindestens {limit} sein</translation>
    </message>
</context>
<context>
    <name>FieldfabPreferences</name>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Solids</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Smallest cells along the longest side</source>
        <translation>Kleinste Zellen entlang der längsten Seite</translation>
    </message>
    <message>
        <source>Resolution of solids whose VoxelSize is 0. Twice as many cells take about four times the triangles and the time.</source>
        <translation>Auflösung der Körper, deren VoxelSize 0 ist. Doppelt so viele Zellen brauchen etwa die vierfache Zahl der Dreiecke und die vierfache Zeit.</translation>
    </message>
    <message>
        <source>Colour of new solids</source>
        <translation>Farbe neuer Körper</translation>
    </message>
    <message>
        <source>Kernel</source>
        <translation>Kern</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Threads</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
</context>
<context>
    <name>Fieldfab_AddOperation</name>
    <message>
        <source>Add operation</source>
        <translation>Operation hinzufügen</translation>
    </message>
    <message>
        <source>Add an operation to the CAM job</source>
        <translation>Dem CAM-Job eine Operation hinzufügen</translation>
    </message>
    <message>
        <source>Adds an operation, such as roughing or finishing, at the end of the selected job, or of the document's only one. The panel asks for the kind of operation, the tool and the settings of each stage; empty settings have their defaults.</source>
        <translation>Hängt eine Operation, etwa Schruppen oder Schlichten, an den ausgewählten oder den einzigen Job des Dokuments an. Das Aufgabenfenster fragt nach der Art der Operation, dem Werkzeug und den Einstellungen jeder Stufe; leere Einstellungen haben ihre Vorgabe.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_Blend</name>
    <message>
        <source>Blend</source>
        <translation>Verrundete Vereinigung</translation>
    </message>
    <message>
        <source>Unite the selected solids with a fillet</source>
        <translation>Die ausgewählten Körper mit einer Hohlkehle vereinigen</translation>
    </message>
    <message>
        <source>Makes one solid of two or more, with a fillet where they meet. Select them first; the panel asks for the fillet's radius.</source>
        <translation>Macht einen Körper aus zweien oder mehr, mit einer Hohlkehle, wo sie sich treffen. Zuerst die Körper auswählen; das Aufgabenfenster fragt nach dem Radius.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_CrossCheck</name>
    <message>
        <source>Cross-check</source>
        <translation>Gegenprüfung</translation>
    </message>
    <message>
        <source>Check the selected solid against OpenVDB and CGAL, and show where its mesh deviates</source>
        <translation>Den ausgewählten Körper gegen OpenVDB und CGAL prüfen und zeigen, wo sein Netz abweicht</translation>
    </message>
    <message>
        <source>Checks one selected solid against OpenVDB and CGAL in the background, and shows each figure with its bound. The mesh has the colours of its deviations until the panel is closed; the document is not changed.</source>
        <translation>Prüft einen ausgewählten Körper im Hintergrund gegen OpenVDB und CGAL und zeigt jede Zahl mit ihrer Schranke. Das Netz hat die Farben seiner Abweichungen, bis das Aufgabenfenster geschlossen wird; das Dokument ändert sich nicht.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_Difference</name>
    <message>
        <source>Difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>Subtract the other selected solids from the first</source>
        <translation>Die anderen ausgewählten Körper vom ersten abziehen</translation>
    </message>
    <message>
        <source>Subtracts all other selected solids from the one that was selected first. Drag them in the panel to change their order.</source>
        <translation>Zieht alle anderen ausgewählten Körper vom zuerst ausgewählten ab. Ihre Reihenfolge lässt sich im Aufgabenfenster durch Ziehen ändern.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_ExampleBracket</name>
    <message>
        <source>Bracket with parameters</source>
        <translation>Winkel mit Parametern</translation>
    </message>
    <message>
        <source>Open a bracket whose measures are parameters, as a new document</source>
        <translation>Einen Winkel, dessen Maße Parameter sind, als neues Dokument öffnen</translation>
    </message>
    <message>
        <source>Opens a copy of an example: an angle bracket of .frep text. Its measures are properties; a double-click on it shows text and sliders.</source>
        <translation>Öffnet eine Kopie eines Beispiels: einen Winkel aus .frep-Text. Seine Maße sind Eigenschaften; ein Doppelklick darauf zeigt Text und Schieber.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_ExampleLattice</name>
    <message>
        <source>Knob filled with a gyroid</source>
        <translation>Mit Gyroid gefüllter Knauf</translation>
    </message>
    <message>
        <source>Open a knob that is filled with a lattice, as a new document</source>
        <translation>Einen mit einem Gitter gefüllten Knauf als neues Dokument öffnen</translation>
    </message>
    <message>
        <source>Opens a copy of an example: a knob of .frep text, and a solid made of it by Lattice infill. Change the wall or the lattice by a double-click.</source>
        <translation>Öffnet eine Kopie eines Beispiels: einen Knauf aus .frep-Text und einen Körper, den die Gitterfüllung daraus macht. Wand und Gitter lassen sich nach einem Doppelklick ändern.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_ExampleMachining</name>
    <message>
        <source>Knob milled in five axes</source>
        <translation>Fünfachsig gefräster Knauf</translation>
    </message>
    <message>
        <source>Open a CAM job with a planned five-axis program, as a new document</source>
        <translation>Einen CAM-Job mit geplantem fünfachsigem Programm als neues Dokument öffnen</translation>
    </message>
    <message>
        <source>Opens a copy of an example: a knob, a set-up that clears it and finishes it with a ball cutter that tilts with the surface, and the planned program. A double-click on the set-up shows its stages.</source>
        <translation>Öffnet eine Kopie eines Beispiels: einen Knauf, eine Aufspannung, die ihn schruppt und mit einem zur Fläche geneigten Kugelfräser schlichtet, und das geplante Programm. Ein Doppelklick auf die Aufspannung zeigt ihre Stufen.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_ExamplesOnStartPage</name>
    <message>
        <source>Show on the start page</source>
        <translation>Auf der Startseite zeigen</translation>
    </message>
    <message>
        <source>Show copies of the examples on FreeCAD's start page, or remove them</source>
        <translation>Kopien der Beispiele auf FreeCADs Startseite zeigen, oder wieder entfernen</translation>
    </message>
    <message>
        <source>Copies the examples into your own folder of FreeCAD and shows this folder on the start page, besides the folders that you have chosen there. A second press takes the folder from the page again; the copies stay.</source>
        <translation>Kopiert die Beispiele in Ihren eigenen Ordner von FreeCAD und zeigt diesen Ordner auf der Startseite, neben den Ordnern, die Sie dort gewählt haben. Ein zweiter Druck nimmt den Ordner wieder von der Seite; die Kopien bleiben.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_ImportScan</name>
    <message>
        <source>Import scan</source>
        <translation>Scan importieren</translation>
    </message>
    <message>
        <source>Make a solid from a CT volume: a file, or any slice of a stack</source>
        <translation>Einen Körper aus einem CT-Volumen machen: aus einer Datei oder einem beliebigen Schichtbild eines Stapels</translation>
    </message>
    <message>
        <source>Asks for a CT volume's file, or any slice of a stack, and makes a solid of it. The panel shows the histogram and asks for the threshold, the crop and the clean-up; the whole volume is computed only at OK.</source>
        <translation>Fragt nach der Datei eines CT-Volumens oder einem beliebigen Schichtbild eines Stapels und macht einen Körper daraus. Das Aufgabenfenster zeigt das Histogramm und fragt nach Schwelle, Ausschnitt und Bereinigung; das ganze Volumen wird erst bei OK berechnet.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_Intersection</name>
    <message>
        <source>Intersection</source>
        <translation>Schnittmenge</translation>
    </message>
    <message>
        <source>Make the intersection of the selected solids</source>
        <translation>Die Schnittmenge der ausgewählten Körper bilden</translation>
    </message>
    <message>
        <source>Makes the common volume of two or more solids. Select solids, meshes, Part objects or bodies; the panel lists them.</source>
        <translation>Macht das gemeinsame Volumen von zwei oder mehr Körpern. Körper, Netze, Part-Objekte oder Bodys auswählen; das Aufgabenfenster führt sie auf.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_LatticeInfill</name>
    <message>
        <source>Lattice infill</source>
        <translation>Gitterfüllung</translation>
    </message>
    <message>
        <source>Hollow the selected solid and fill it with a lattice</source>
        <translation>Den ausgewählten Körper aushöhlen und mit einem Gitter füllen</translation>
    </message>
    <message>
        <source>Makes a light solid of the selected one: a wall, and a lattice inside. The panel asks for the wall, the kind of lattice, the edge of its cell and the thickness of its struts.</source>
        <translation>Macht aus dem ausgewählten Körper einen leichten: eine Wand, und innen ein Gitter. Das Aufgabenfenster fragt nach der Wand, der Art des Gitters, der Kante seiner Zelle und der Dicke seiner Stege.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_LinearArray</name>
    <message>
        <source>Linear array</source>
        <translation>Lineares Muster</translation>
    </message>
    <message>
        <source>Copy the selected solid in a row</source>
        <translation>Den ausgewählten Körper in einer Reihe kopieren</translation>
    </message>
    <message>
        <source>Makes one solid of copies of the selected one in a row. The panel asks for the step from one copy to the next and for their number.</source>
        <translation>Macht einen Körper aus Kopien des ausgewählten in einer Reihe. Das Aufgabenfenster fragt nach dem Schritt von einer Kopie zur nächsten und nach ihrer Zahl.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_MeasureSection</name>
    <message>
        <source>Measure on section</source>
        <translation>Auf dem Schnitt messen</translation>
    </message>
    <message>
        <source>Measure walls, gaps and distances by clicks on the section plane</source>
        <translation>Wände, Spalte und Abstände durch Klicks auf die Schnittebene messen</translation>
    </message>
    <message>
        <source>Shows the section plane if there is none. A click on it gives the thickness of the wall, or the width of the gap, from the nearest outline through that point to the other side, and the distance from the last click; clicks near an outline are on it. Choose it again to end measuring.</source>
        <translation>Zeigt die Schnittebene, wenn es keine gibt. Ein Klick darauf ergibt die Dicke der Wand oder die Weite des Spalts, von der nächsten Kontur durch diesen Punkt zur anderen Seite, und den Abstand zum letzten Klick; Klicks nahe einer Kontur liegen auf ihr. Erneutes Wählen beendet das Messen.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_Mirror</name>
    <message>
        <source>Mirror</source>
        <translation>Spiegeln</translation>
    </message>
    <message>
        <source>Mirror the selected solid</source>
        <translation>Den ausgewählten Körper spiegeln</translation>
    </message>
    <message>
        <source>Makes the mirror image of the selected solid, with or without the original. The panel asks for the mirror's normal and a point of it.</source>
        <translation>Macht das Spiegelbild des ausgewählten Körpers, mit oder ohne das Original. Das Aufgabenfenster fragt nach der Normale des Spiegels und einem Punkt darauf.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_Morph</name>
    <message>
        <source>Morph</source>
        <translation>Übergang</translation>
    </message>
    <message>
        <source>Make a solid between two selected solids</source>
        <translation>Einen Körper zwischen zwei ausgewählten machen</translation>
    </message>
    <message>
        <source>Makes a solid between two others. Select both; the panel asks for the weight: 0 gives the first, 1 the second.</source>
        <translation>Macht einen Körper zwischen zwei anderen. Beide auswählen; das Aufgabenfenster fragt nach dem Gewicht: 0 ergibt den ersten, 1 den zweiten.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_NewCamSetup</name>
    <message>
        <source>New CAM job</source>
        <translation>Neuer CAM-Job</translation>
    </message>
    <message>
        <source>Machine the selected solid: stock, tools, operations and a machine</source>
        <translation>Den ausgewählten Körper fräsen: Rohteil, Werkzeuge, Operationen und eine Maschine</translation>
    </message>
    <message>
        <source>Adds a job that machines the selected solid, mesh, Part object or body. The panel asks for the stock, the tools, the operations in order and the machine, and plans all paths in the background.</source>
        <translation>Legt einen Job an, in dem der ausgewählte Körper, das Netz, Part-Objekt oder der Body gefräst wird. Das Aufgabenfenster fragt nach Rohteil, Werkzeugen, Operationen der Reihe nach und Maschine und plant alle Bahnen im Hintergrund.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_NewFrepSolid</name>
    <message>
        <source>New f-rep solid</source>
        <translation>Neuer F-Rep-Körper</translation>
    </message>
    <message>
        <source>Make a solid from a formula, recomputed whenever the formula changes</source>
        <translation>Einen Körper aus einer Formel machen, der ihren Änderungen folgt</translation>
    </message>
    <message>
        <source>Makes a solid from .frep text or a prefix math string; nothing needs to be selected. The panel has an editor, a slider for each number of the text, and the resolution; the solid is seen while it is written.</source>
        <translation>Macht einen Körper aus .frep-Text oder einer Formel in Präfixschreibweise; es muss nichts ausgewählt sein. Das Aufgabenfenster hat einen Editor, einen Schieber für jede Zahl des Textes und die Auflösung; der Körper ist schon beim Schreiben zu sehen.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_NewScriptSolid</name>
    <message>
        <source>New Python model</source>
        <translation>Neues Python-Modell</translation>
    </message>
    <message>
        <source>Make a solid by a Python script that the document keeps</source>
        <translation>Einen Körper durch ein Python-Skript erzeugen, das im Dokument bleibt</translation>
    </message>
    <message>
        <source>Makes a solid by a Python script; nothing needs to be selected. The panel has an editor, a slider for each named number of the script, and marks the line of an error. The script runs only after you have agreed for the document, in a process of its own; the document keeps the script and the formula that it made.</source>
        <translation>Erzeugt einen Körper durch ein Python-Skript; nichts muss ausgewählt sein. Das Aufgabenfenster hat einen Editor, einen Schieberegler für jede benannte Zahl des Skripts und markiert die Zeile eines Fehlers. Das Skript läuft erst, nachdem Sie für das Dokument zugestimmt haben, in einem eigenen Prozess; das Dokument behält das Skript und die Formel, die es erzeugt hat.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_Offset</name>
    <message>
        <source>Offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>Grow or shrink the selected solid</source>
        <translation>Den ausgewählten Körper wachsen oder schrumpfen lassen</translation>
    </message>
    <message>
        <source>Makes a solid whose surface lies at a distance from that of the selected one. The panel asks for the distance: outwards, below 0 inwards.</source>
        <translation>Macht einen Körper, dessen Oberfläche in einem Abstand von der des ausgewählten liegt. Das Aufgabenfenster fragt nach dem Abstand: nach außen, unter 0 nach innen.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_Plan</name>
    <message>
        <source>Plan</source>
        <translation>Planen</translation>
    </message>
    <message>
        <source>Plan all paths of the CAM job</source>
        <translation>Alle Bahnen des CAM-Jobs planen</translation>
    </message>
    <message>
        <source>Plans the machine program of the selected job, or of the document's only one, with a progress box. A plan that fails or is cancelled keeps the last good one.</source>
        <translation>Plant das Maschinenprogramm des ausgewählten oder des einzigen Jobs des Dokuments, mit einer Fortschrittsanzeige. Schlägt es fehl oder wird es abgebrochen, bleibt das letzte gute Programm.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_PlaySimulation</name>
    <message>
        <source>Play simulation</source>
        <translation>Simulation abspielen</translation>
    </message>
    <message>
        <source>Show the selected simulation move by move, its events and deviations</source>
        <translation>Die ausgewählte Simulation Bewegung für Bewegung zeigen, mit Ereignissen und Abweichungen</translation>
    </message>
    <message>
        <source>Opens the panel of the selected simulation: the stock at any moment, tool and axes, the program's lines, events with the worst first, and deviations in colours.</source>
        <translation>Öffnet das Aufgabenfenster der ausgewählten Simulation: das Rohteil in jedem Augenblick, Werkzeug und Achsen, die Zeilen des Programms, Kollisionen und andere Ereignisse, das Schlimmste zuerst, und Abweichungen in Farben.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_PolarArray</name>
    <message>
        <source>Polar array</source>
        <translation>Kreismuster</translation>
    </message>
    <message>
        <source>Copy the selected solid around an axis</source>
        <translation>Den ausgewählten Körper um eine Achse kopieren</translation>
    </message>
    <message>
        <source>Makes one solid of copies of the selected one around an axis. The panel asks for the axis, the number of copies and the angle that they fill.</source>
        <translation>Macht einen Körper aus Kopien des ausgewählten um eine Achse. Das Aufgabenfenster fragt nach der Achse, der Zahl der Kopien und dem Winkel, den sie füllen.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_RunScript</name>
    <message>
        <source>Run script</source>
        <translation>Skript ausführen</translation>
    </message>
    <message>
        <source>Run a script that makes solids, after asking, and keep their formulas</source>
        <translation>Nach einer Rückfrage ein Skript ausführen, das Körper macht, und deren Formeln behalten</translation>
    </message>
    <message>
        <source>Asks for a Python script or one of kokopelli, and whether it may run, since it can do whatever you can. The document keeps the formula of each part that it makes, not the script.</source>
        <translation>Fragt nach einem Python-Skript oder einem von kokopelli und ob es laufen darf, denn es kann alles, was Sie können. Das Dokument behält die Formel jedes Teils, den es macht, nicht das Skript.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_Section</name>
    <message>
        <source>Section plane</source>
        <translation>Schnittebene</translation>
    </message>
    <message>
        <source>Cut the view by a plane to see inside, or show everything again</source>
        <translation>Die Ansicht mit einer Ebene schneiden, um ins Innere zu sehen, oder wieder alles zeigen</translation>
    </message>
    <message>
        <source>Cuts all solids of the view, also those of panels (scans, the stock of a simulation), across the axis that points most to you; cut faces are orange, scans that lie along the plane show their densities on it. Drag the handle on the plane to move it. Choose it again to show everything; the document is not changed.</source>
        <translation>Schneidet alle Körper der Ansicht, auch die der Aufgabenfenster (Scans, das Rohteil einer Simulation), quer zu der Achse, die am meisten auf Sie zeigt; Schnittflächen sind orange, Scans, die entlang der Ebene liegen, zeigen darauf ihre Dichten. Ziehen Sie den Griff auf der Ebene, um sie zu verschieben. Erneutes Wählen zeigt alles; das Dokument wird nicht verändert.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_SetupSheet</name>
    <message>
        <source>Set-up sheet</source>
        <translation>Einrichteblatt</translation>
    </message>
    <message>
        <source>Show the page for the machine operator</source>
        <translation>Die Seite für den Maschinenbediener zeigen</translation>
    </message>
    <message>
        <source>Opens the set-up sheet of the planned program in the browser: stock, zero, tools, times and pictures, ready to be printed.</source>
        <translation>Öffnet das Einrichteblatt des geplanten Programms im Browser: Rohteil, Nullpunkt, Werkzeuge, Zeiten und Bilder, fertig zum Drucken.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_ShapeGallery</name>
    <message>
        <source>Shape gallery</source>
        <translation>Formengalerie</translation>
    </message>
    <message>
        <source>Choose a shape by its picture and make a solid of it</source>
        <translation>Eine Form nach ihrem Bild wählen und einen Körper daraus machen</translation>
    </message>
    <message>
        <source>Shows the pictures of all shapes of the library and of the designs, by groups or by words; nothing needs to be selected. The shape that is chosen becomes an f-rep solid whose numbers are its parameters.</source>
        <translation>Zeigt die Bilder aller Formen der Bibliothek und der Entwürfe, nach Gruppen oder nach Wörtern; es muss nichts ausgewählt sein. Die gewählte Form wird ein F-Rep-Körper, dessen Zahlen seine Parameter sind.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_Shell</name>
    <message>
        <source>Shell</source>
        <translation>Schale</translation>
    </message>
    <message>
        <source>Hollow the selected solid</source>
        <translation>Den ausgewählten Körper aushöhlen</translation>
    </message>
    <message>
        <source>Makes a hollow solid of the selected one, with the same outer surface. The panel asks for the wall's thickness.</source>
        <translation>Macht aus dem ausgewählten Körper einen hohlen mit derselben Außenfläche. Das Aufgabenfenster fragt nach der Dicke der Wand.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_ShowUncertainPlaces</name>
    <message>
        <source>Show uncertain places</source>
        <translation>Unsichere Stellen zeigen</translation>
    </message>
    <message>
        <source>Show where the mesh of the selected solid may lack parts, or hide these places again</source>
        <translation>Zeigen, wo dem Netz des ausgewählten Körpers Teile fehlen können, oder diese Stellen wieder verbergen</translation>
    </message>
    <message>
        <source>Draws a box around each place where the mesh is not proved to show the whole selected solid, and zooms to the largest. Choose it again to remove the boxes. It is disabled if the mesh is certain; smaller cells leave fewer and smaller places.</source>
        <translation>Zeichnet einen Quader um jede Stelle, an der nicht bewiesen ist, dass das Netz den ganzen ausgewählten Körper zeigt, und zoomt auf die größte. Noch einmal gewählt, entfernt es die Quader. Ist das Netz sicher, lässt es sich nicht wählen; kleinere Zellen lassen weniger und kleinere Stellen übrig.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_SimulateProgram</name>
    <message>
        <source>Simulate program</source>
        <translation>Programm simulieren</translation>
    </message>
    <message>
        <source>Simulate a machine's program on a stock: from a file, or from the selected Path operation, Job or machine program</source>
        <translation>Das Programm einer Maschine an einem Rohteil simulieren: aus einer Datei oder von der ausgewählten Path-Operation, dem Path-Auftrag oder Maschinenprogramm</translation>
    </message>
    <message>
        <source>Simulates a machine's program on a stock and plays it in the 3D view. Select a machine program, a Path operation or a Job, or choose a file in the panel, which also asks for the stock, the tools, the machine and the target.</source>
        <translation>Simuliert das Programm einer Maschine an einem Rohteil und spielt es in der 3D-Ansicht ab. Ein Maschinenprogramm, eine Path-Operation oder einen Path-Auftrag auswählen, oder im Aufgabenfenster eine Datei wählen; es fragt auch nach Rohteil, Werkzeugen, Maschine und Ziel.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_SolidFromObject</name>
    <message>
        <source>Solid from object</source>
        <translation>Körper aus Objekt</translation>
    </message>
    <message>
        <source>Make a solid of the selected mesh, Part object or body</source>
        <translation>Aus dem ausgewählten Netz, Part-Objekt oder Body einen Körper machen</translation>
    </message>
    <message>
        <source>Makes a solid of a mesh, a Part object or a body, which follows that object. Select the object first. Holes and overlaps of a mesh do no harm; the panel asks how far triangles may be from a Part shape.</source>
        <translation>Macht aus einem Netz, einem Part-Objekt oder einem Body einen Körper, der dem Objekt folgt. Zuerst das Objekt auswählen. Löcher und Überschneidungen eines Netzes schaden nicht; das Aufgabenfenster fragt, wie weit Dreiecke von einer Part-Form abweichen dürfen.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_ToMesh</name>
    <message>
        <source>To mesh</source>
        <translation>Zu Netz</translation>
    </message>
    <message>
        <source>Make a plain mesh of the selected solid, as it is now</source>
        <translation>Ein einfaches Netz des ausgewählten Körpers machen, wie er jetzt ist</translation>
    </message>
    <message>
        <source>Makes a plain copy of the mesh of each selected solid, which does not follow it, and hides the solid. There is no panel.</source>
        <translation>Macht eine einfache Kopie des Netzes jedes ausgewählten Körpers, die ihm nicht folgt, und blendet den Körper aus. Es gibt kein Aufgabenfenster.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_ToPartShape</name>
    <message>
        <source>To Part shape</source>
        <translation>Zu Part-Form</translation>
    </message>
    <message>
        <source>Make a Part shape that follows the selected solid, with flat, round and free-form faces</source>
        <translation>Eine Part-Form erstellen, die dem gewählten Körper folgt, mit ebenen, runden und freien Flächen</translation>
    </message>
    <message>
        <source>Makes an object for Part, Part Design and TechDraw that follows each selected solid. Flat, cylindrical, conical, spherical, toroidal and smooth free-form parts become one face each. Where that gives no valid shape, all faces are flat: the mesh is reduced to the number of triangles that its property MostTriangles says.</source>
        <translation>Erstellt zu jedem gewählten Körper ein Objekt für Part, Part Design und TechDraw, das ihm folgt. Ebene, zylindrische, kegelige, kugelige, torusförmige und glatte freie Bereiche werden je eine Fläche. Wo das keine gültige Form ergibt, sind alle Flächen eben: Das Netz wird auf die Zahl der Dreiecke verringert, die seine Eigenschaft MostTriangles nennt.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_ToPath</name>
    <message>
        <source>To Path job</source>
        <translation>Zu Path-Auftrag</translation>
    </message>
    <message>
        <source>Add the program's operations to a job of FreeCAD's Path workbench</source>
        <translation>Die Operationen des Programms in einen Auftrag von FreeCADs Arbeitsbereich Path aufnehmen</translation>
    </message>
    <message>
        <source>Puts the planned operations as paths into a job of FreeCAD's Path workbench: into the selected or the first one of the document, else into a new one with the set-up's stock and tools. The paths follow the program.</source>
        <translation>Legt die geplanten Operationen als Pfade in einen Auftrag von FreeCADs Arbeitsbereich Path: in den ausgewählten oder den ersten des Dokuments, sonst in einen neuen mit Rohteil und Werkzeugen der Aufspannung. Die Pfade folgen dem Programm.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_Transform</name>
    <message>
        <source>Transform</source>
        <translation>Umformen</translation>
    </message>
    <message>
        <source>Scale, turn and move the selected solid</source>
        <translation>Den ausgewählten Körper skalieren, drehen und verschieben</translation>
    </message>
    <message>
        <source>Makes a solid of the selected one, scaled along x, y and z, turned about an axis and moved. The panel asks for all of these.</source>
        <translation>Macht einen Körper aus dem ausgewählten, entlang x, y und z skaliert, um eine Achse gedreht und verschoben. Das Aufgabenfenster fragt nach alledem.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_Union</name>
    <message>
        <source>Union</source>
        <translation>Vereinigung</translation>
    </message>
    <message>
        <source>Unite the selected solids</source>
        <translation>Die ausgewählten Körper vereinigen</translation>
    </message>
    <message>
        <source>Makes one solid of two or more. Select solids, meshes, Part objects or bodies; the panel lists them and takes others in.</source>
        <translation>Macht einen Körper aus zweien oder mehr. Körper, Netze, Part-Objekte oder Bodys auswählen; das Aufgabenfenster führt sie auf und nimmt weitere dazu.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_WriteMachineFile</name>
    <message>
        <source>Post process</source>
        <translation>Postprozessor</translation>
    </message>
    <message>
        <source>Show the program in the machine's format, and save it</source>
        <translation>Das Programm im Format der Maschine zeigen und speichern</translation>
    </message>
    <message>
        <source>Shows the planned program of the selected job in the machine's format, such as G-code, with line numbers. Save asks for the file name; the default is the part's name.</source>
        <translation>Zeigt das geplante Programm des ausgewählten Jobs im Format der Maschine, etwa als G-Code, mit Zeilennummern. Beim Speichern wird nach dem Namen der Datei gefragt; vorgeschlagen ist der des Werkstücks.</translation>
    </message>
</context>
<context>
    <name>Kernel</name>
    <message>
        <source>outline</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>the part's outline: a slice, or its shadow from above</source>
        <translation>Umriss des Teils: ein Schnitt oder sein Schatten von oben</translation>
    </message>
    <message>
        <source>height map</source>
        <translation>Höhenkarte</translation>
    </message>
    <message>
        <source>the part's upper surface</source>
        <translation>Oberseite des Teils</translation>
    </message>
    <message>
        <source>threshold</source>
        <translation>Schwellwert</translation>
    </message>
    <message>
        <source>black and white</source>
        <translation>Schwarz und Weiß</translation>
    </message>
    <message>
        <source>distance transform</source>
        <translation>Abstandskarte</translation>
    </message>
    <message>
        <source>exact distances to the bitmap's edge</source>
        <translation>genaue Abstände vom Rand der Bitmap</translation>
    </message>
    <message>
        <source>heights</source>
        <translation>Höhen</translation>
    </message>
    <message>
        <source>a height map as drawn</source>
        <translation>Höhenkarte, wie gezeichnet</translation>
    </message>
    <message>
        <source>profile</source>
        <translation>Konturfräsen</translation>
    </message>
    <message>
        <source>contour cut along the part's outline</source>
        <translation>Schnitt entlang dem Umriss des Teils</translation>
    </message>
    <message>
        <source>isolate</source>
        <translation>Isolationsfräsen</translation>
    </message>
    <message>
        <source>offsets outward from the part, as for the traces of a circuit board</source>
        <translation>Bahnen außen um das Teil, wie um die Leiterbahnen einer Platine</translation>
    </message>
    <message>
        <source>pocket</source>
        <translation>Tasche</translation>
    </message>
    <message>
        <source>clears the inside of the part's outline, or the stock around it</source>
        <translation>räumt das Innere des Umrisses oder das Rohteil ringsum</translation>
    </message>
    <message>
        <source>slot</source>
        <translation>Nut</translation>
    </message>
    <message>
        <source>runs along the middle of slots as wide as the tool</source>
        <translation>fährt in der Mitte von Nuten, die so breit wie das Werkzeug sind</translation>
    </message>
    <message>
        <source>drill</source>
        <translation>Bohren</translation>
    </message>
    <message>
        <source>the part's round holes</source>
        <translation>die runden Bohrungen des Teils</translation>
    </message>
    <message>
        <source>thread</source>
        <translation>Gewindefräsen</translation>
    </message>
    <message>
        <source>mills threads into the part's round holes</source>
        <translation>fräst Gewinde in die runden Bohrungen des Teils</translation>
    </message>
    <message>
        <source>face</source>
        <translation>Planfräsen</translation>
    </message>
    <message>
        <source>clears the top of the stock, down to the part</source>
        <translation>trägt die Oberseite des Rohteils bis auf das Teil ab</translation>
    </message>
    <message>
        <source>chamfer</source>
        <translation>Anfasen</translation>
    </message>
    <message>
        <source>breaks the edges of the part's outline with a V</source>
        <translation>bricht die Kanten des Umrisses mit einem V-Fräser</translation>
    </message>
    <message>
        <source>engrave</source>
        <translation>Gravieren</translation>
    </message>
    <message>
        <source>follows the part's outline with the tip, as for lettering</source>
        <translation>folgt dem Umriss mit der Spitze, etwa für Schrift</translation>
    </message>
    <message>
        <source>v_carve</source>
        <translation>V-Gravur</translation>
    </message>
    <message>
        <source>carves the inside of the outline with a V</source>
        <translation>graviert das Innere des Umrisses mit einem V-Fräser</translation>
    </message>
    <message>
        <source>rough</source>
        <translation>Schruppen</translation>
    </message>
    <message>
        <source>clears the material above the part level by level</source>
        <translation>räumt das Material über dem Teil Ebene für Ebene</translation>
    </message>
    <message>
        <source>finish</source>
        <translation>Schlichten</translation>
    </message>
    <message>
        <source>parallel passes over the part's surface</source>
        <translation>parallele Bahnen über die Oberfläche des Teils</translation>
    </message>
    <message>
        <source>waterline</source>
        <translation>Höhenlinien</translation>
    </message>
    <message>
        <source>level contours of the part's surface</source>
        <translation>waagerechte Bahnen um die Oberfläche des Teils</translation>
    </message>
    <message>
        <source>pencil</source>
        <translation>Kehlen</translation>
    </message>
    <message>
        <source>along the valleys of the part's surface, where a round tool touches both sides</source>
        <translation>entlang den Kehlen der Oberfläche, wo ein rundes Werkzeug beide Seiten berührt</translation>
    </message>
    <message>
        <source>moves</source>
        <translation>Bewegungen</translation>
    </message>
    <message>
        <source>how the paths are joined to moves</source>
        <translation>wie die Bahnen zu Bewegungen verbunden werden</translation>
    </message>
    <message>
        <source>cell</source>
        <translation>Zelle</translation>
    </message>
    <message>
        <source>sample spacing; the default follows from the part's size and the tool</source>
        <translation>Abstand der Abtastpunkte; die Vorgabe folgt aus der Größe des Teils und dem Werkzeug</translation>
    </message>
    <message>
        <source>slice</source>
        <translation>Schnitthöhe</translation>
    </message>
    <message>
        <source>height of the section through the part; the default is the projection from above, or the drawing itself</source>
        <translation>Höhe des Schnitts durch das Teil; Vorgabe ist die Projektion von oben oder die Zeichnung selbst</translation>
    </message>
    <message>
        <source>surface_tolerance</source>
        <translation>Toleranz der Höhenkarte</translation>
    </message>
    <message>
        <source>greatest distance of the height map from the part's surface</source>
        <translation>größter Abstand der Höhenkarte von der Oberfläche des Teils</translation>
    </message>
    <message>
        <source>pixel</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>size of a pixel; the default is that of the image file</source>
        <translation>Größe eines Pixels; Vorgabe ist die der Bilddatei</translation>
    </message>
    <message>
        <source>brighter pixels are solid</source>
        <translation>hellere Pixel sind Material</translation>
    </message>
    <message>
        <source>invert</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>invert: darker pixels are solid</source>
        <translation>umkehren: dunklere Pixel sind Material</translation>
    </message>
    <message>
        <source>black</source>
        <translation>Schwarz</translation>
    </message>
    <message>
        <source>height of black; the default is that of the image file</source>
        <translation>Höhe von Schwarz; Vorgabe ist die der Bilddatei</translation>
    </message>
    <message>
        <source>white</source>
        <translation>Weiß</translation>
    </message>
    <message>
        <source>height of white; the default is that of the image file</source>
        <translation>Höhe von Weiß; Vorgabe ist die der Bilddatei</translation>
    </message>
    <message>
        <source>side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>side of the outline on which the tool runs</source>
        <translation>Seite des Umrisses, auf der das Werkzeug fährt</translation>
    </message>
    <message>
        <source>tabs</source>
        <translation>Haltestege</translation>
    </message>
    <message>
        <source>number of tabs on each outline, which hold the part</source>
        <translation>Anzahl der Haltestege je Umriss, die das Teil halten</translation>
    </message>
    <message>
        <source>tab_width</source>
        <translation>Breite der Stege</translation>
    </message>
    <message>
        <source>width of a tab</source>
        <translation>Breite eines Haltestegs</translation>
    </message>
    <message>
        <source>tab_height</source>
        <translation>Höhe der Stege</translation>
    </message>
    <message>
        <source>height of a tab</source>
        <translation>Höhe eines Haltestegs</translation>
    </message>
    <message>
        <source>top</source>
        <translation>Oberkante</translation>
    </message>
    <message>
        <source>z of the top of the material; the default is the top of the stock</source>
        <translation>z der Oberkante des Materials; Vorgabe ist die des Rohteils</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>depth below the top; the default is through the stock</source>
        <translation>Tiefe unter der Oberkante; Vorgabe ist durch das Rohteil</translation>
    </message>
    <message>
        <source>stepdown</source>
        <translation>Zustellung</translation>
    </message>
    <message>
        <source>depth of each pass; the default is one pass</source>
        <translation>Tiefe jedes Durchgangs; Vorgabe ist ein Durchgang</translation>
    </message>
    <message>
        <source>allowance</source>
        <translation>Aufmaß</translation>
    </message>
    <message>
        <source>stock allowance left on the part</source>
        <translation>Aufmaß, das am Teil bleibt</translation>
    </message>
    <message>
        <source>climb</source>
        <translation>Gleichlauf</translation>
    </message>
    <message>
        <source>climb milling; false: conventional milling</source>
        <translation>Gleichlauffräsen; nein: Gegenlauffräsen</translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>tolerance of fitting lines and arcs</source>
        <translation>Toleranz beim Einpassen von Strecken und Bögen</translation>
    </message>
    <message>
        <source>offsets</source>
        <translation>Bahnen</translation>
    </message>
    <message>
        <source>number of offsets; -1 clears everything</source>
        <translation>Anzahl der Bahnen; -1 räumt alles</translation>
    </message>
    <message>
        <source>stepover</source>
        <translation>Bahnabstand</translation>
    </message>
    <message>
        <source>distance from one offset to the next</source>
        <translation>Abstand von einer Bahn zur nächsten</translation>
    </message>
    <message>
        <source>side of the outline that is cleared</source>
        <translation>Seite des Umrisses, die geräumt wird</translation>
    </message>
    <message>
        <source>distance of the rings</source>
        <translation>Abstand der Ringe</translation>
    </message>
    <message>
        <source>pattern</source>
        <translation>Muster</translation>
    </message>
    <message>
        <source>rings along the walls, or constant engagement: never more than a straight pass has</source>
        <translation>Ringe entlang den Wänden oder gleichbleibender Eingriff: nie größer als auf einer geraden Bahn</translation>
    </message>
    <message>
        <source>slots in the part, or the inside of a drawing of slots</source>
        <translation>Nuten im Teil oder das Innere einer Zeichnung von Nuten</translation>
    </message>
    <message>
        <source>widest</source>
        <translation>Größte Breite</translation>
    </message>
    <message>
        <source>greatest width of a slot; the default is 1.05 diameters</source>
        <translation>größte Breite einer Nut; Vorgabe sind 1.05 Durchmesser</translation>
    </message>
    <message>
        <source>peck</source>
        <translation>Spantiefe</translation>
    </message>
    <message>
        <source>depth of each peck; the default is no pecking</source>
        <translation>Tiefe jedes Bohrhubs; Vorgabe ist Bohren in einem Hub</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>Größter Durchmesser</translation>
    </message>
    <message>
        <source>largest diameter of the holes; the default is that of the tool</source>
        <translation>größter Durchmesser der Bohrungen; Vorgabe ist der des Werkzeugs</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>Steigung</translation>
    </message>
    <message>
        <source>rise of the thread in a turn</source>
        <translation>Steigung des Gewindes je Umdrehung</translation>
    </message>
    <message>
        <source>diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>largest diameter of the thread, as 6 of M6; the default is that of an ISO thread in each hole</source>
        <translation>Außendurchmesser des Gewindes, etwa 6 bei M6; Vorgabe ist der des ISO-Gewindes in jeder Bohrung</translation>
    </message>
    <message>
        <source>hand</source>
        <translation>Gangrichtung</translation>
    </message>
    <message>
        <source>a right-hand or a left-hand thread</source>
        <translation>Rechts- oder Linksgewinde</translation>
    </message>
    <message>
        <source>passes</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>number of passes to the thread's full depth</source>
        <translation>Anzahl der Durchgänge bis zur vollen Gewindetiefe</translation>
    </message>
    <message>
        <source>greatest width of a pass</source>
        <translation>größte Breite eines Durchgangs</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>angle of the passes to x</source>
        <translation>Winkel der Bahnen zu x</translation>
    </message>
    <message>
        <source>both_ways</source>
        <translation>Hin und zurück</translation>
    </message>
    <message>
        <source>alternate passes run backwards</source>
        <translation>jede zweite Bahn läuft zurück</translation>
    </message>
    <message>
        <source>depth below the top; the default is down to the part</source>
        <translation>Tiefe unter der Oberkante; Vorgabe ist bis auf das Teil</translation>
    </message>
    <message>
        <source>width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>width of the chamfer, seen from above</source>
        <translation>Breite der Fase, von oben gesehen</translation>
    </message>
    <message>
        <source>beyond</source>
        <translation>Überstand</translation>
    </message>
    <message>
        <source>distance of the tool's axis from the edge</source>
        <translation>Abstand der Werkzeugachse von der Kante</translation>
    </message>
    <message>
        <source>z of the edge; the default is the top of the part</source>
        <translation>z der Kante; Vorgabe ist die Oberkante des Teils</translation>
    </message>
    <message>
        <source>distance of passes on a flat floor</source>
        <translation>Abstand der Bahnen auf ebenem Boden</translation>
    </message>
    <message>
        <source>distance of the passes</source>
        <translation>Abstand der Bahnen</translation>
    </message>
    <message>
        <source>tolerance of the path against the surface</source>
        <translation>Toleranz der Bahn gegen die Oberfläche</translation>
    </message>
    <message>
        <source>z where the cut begins; the default is the stock's top</source>
        <translation>z, bei dem der Schnitt beginnt; Vorgabe ist die Oberkante des Rohteils</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>Unterkante</translation>
    </message>
    <message>
        <source>z where the cut ends; the default is the floor of the surface</source>
        <translation>z, bei dem der Schnitt endet; Vorgabe ist der Boden der Oberfläche</translation>
    </message>
    <message>
        <source>depth of each level; the default is half the tool's diameter</source>
        <translation>Tiefe jeder Ebene; Vorgabe ist der halbe Durchmesser des Werkzeugs</translation>
    </message>
    <message>
        <source>pattern of the passes</source>
        <translation>Muster der Bahnen</translation>
    </message>
    <message>
        <source>angle of the passes against x</source>
        <translation>Winkel der Bahnen gegen x</translation>
    </message>
    <message>
        <source>scallop</source>
        <translation>Rillenhöhe</translation>
    </message>
    <message>
        <source>height of the cusps between passes, instead of a stepover</source>
        <translation>Höhe der Rillen zwischen den Bahnen, statt eines Bahnabstands</translation>
    </message>
    <message>
        <source>zigzag: every other pass runs back</source>
        <translation>Zickzack: jede zweite Bahn läuft zurück</translation>
    </message>
    <message>
        <source>lowest z of the tool; the default is the floor of the surface</source>
        <translation>kleinstes z des Werkzeugs; Vorgabe ist der Boden der Oberfläche</translation>
    </message>
    <message>
        <source>skip_air</source>
        <translation>Luftschnitte auslassen</translation>
    </message>
    <message>
        <source>leaves out passes where earlier operations left no stock</source>
        <translation>lässt Bahnen aus, wo frühere Operationen kein Material übrig ließen</translation>
    </message>
    <message>
        <source>rest</source>
        <translation>Restmaterial</translation>
    </message>
    <message>
        <source>rest machining: only where earlier operations left material</source>
        <translation>Restmaterialbearbeitung: nur wo frühere Operationen Material übrig ließen</translation>
    </message>
    <message>
        <source>rest_least</source>
        <translation>Kleinste Resthöhe</translation>
    </message>
    <message>
        <source>least height of that material</source>
        <translation>kleinste Höhe dieses Materials</translation>
    </message>
    <message>
        <source>lean</source>
        <translation>Neigen</translation>
    </message>
    <message>
        <source>five axes at once: the tool tilts with the surface</source>
        <translation>fünf Achsen zugleich: das Werkzeug neigt sich mit der Oberfläche</translation>
    </message>
    <message>
        <source>lead</source>
        <translation>Voreilwinkel</translation>
    </message>
    <message>
        <source>lead angle: tilt ahead of the surface normal, in the direction of travel</source>
        <translation>Voreilwinkel: Neigung vor die Flächennormale, in Fahrtrichtung</translation>
    </message>
    <message>
        <source>most_lean</source>
        <translation>Größte Neigung</translation>
    </message>
    <message>
        <source>greatest tilt against the plane's z</source>
        <translation>größte Neigung gegen die z-Achse der Ebene</translation>
    </message>
    <message>
        <source>body_clearance</source>
        <translation>Abstand des Schafts</translation>
    </message>
    <message>
        <source>clearance of shank and holder from the part</source>
        <translation>Abstand von Schaft und Halter zum Teil</translation>
    </message>
    <message>
        <source>least_angle</source>
        <translation>Kleinster Winkel</translation>
    </message>
    <message>
        <source>least angle between the two sides</source>
        <translation>kleinster Winkel zwischen den beiden Seiten</translation>
    </message>
    <message>
        <source>feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>feed rate of cuts</source>
        <translation>Vorschub beim Fräsen</translation>
    </message>
    <message>
        <source>plunge</source>
        <translation>Eintauchvorschub</translation>
    </message>
    <message>
        <source>feed rate of plunges</source>
        <translation>Vorschub beim Eintauchen</translation>
    </message>
    <message>
        <source>spindle</source>
        <translation>Spindel</translation>
    </message>
    <message>
        <source>spindle speed</source>
        <translation>Spindeldrehzahl</translation>
    </message>
    <message>
        <source>coolant</source>
        <translation>Kühlmittel</translation>
    </message>
    <message>
        <source>coolant while cutting</source>
        <translation>Kühlmittel beim Fräsen</translation>
    </message>
    <message>
        <source>clearance</source>
        <translation>Sicherheitshöhe</translation>
    </message>
    <message>
        <source>height of rapids above the stock</source>
        <translation>Höhe der Eilgänge über dem Rohteil</translation>
    </message>
    <message>
        <source>link_feed</source>
        <translation>Vorschub im Freien</translation>
    </message>
    <message>
        <source>feed rate where the material is cut already; the default is the feed</source>
        <translation>Vorschub, wo das Material schon abgetragen ist; Vorgabe ist der Vorschub</translation>
    </message>
    <message>
        <source>entry</source>
        <translation>Eintauchen</translation>
    </message>
    <message>
        <source>how closed paths are entered</source>
        <translation>wie in geschlossene Bahnen eingetaucht wird</translation>
    </message>
    <message>
        <source>ramp_angle</source>
        <translation>Rampenwinkel</translation>
    </message>
    <message>
        <source>angle of ramps and helices</source>
        <translation>Winkel von Rampen und Wendeln</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>cut from: one face, the five visible ones, as seen (alpha, beta), or in even steps; a machine that cannot tilt stops for turning the part by hand</source>
        <translation>von wo gefräst wird: von einer Seite, von den fünf sichtbaren, wie gesehen (alpha, beta) oder in gleichen Schritten; eine Maschine ohne Schwenkachsen hält an, damit das Teil von Hand gedreht wird</translation>
    </message>
    <message>
        <source>alpha</source>
        <translation>Alpha</translation>
    </message>
    <message>
        <source>rotation of a view about z</source>
        <translation>Drehung einer Ansicht um z</translation>
    </message>
    <message>
        <source>beta</source>
        <translation>Beta</translation>
    </message>
    <message>
        <source>rotation of a view about x, after that about z</source>
        <translation>Drehung einer Ansicht um x, nach der um z</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>number of stepped planes per half turn</source>
        <translation>Anzahl der Ebenen je halbe Umdrehung</translation>
    </message>
    <message>
        <source>kerf</source>
        <translation>Schnittbreite</translation>
    </message>
    <message>
        <source>width of the cut</source>
        <translation>Breite des Schnitts</translation>
    </message>
    <message>
        <source>autofocus</source>
        <translation>Autofokus</translation>
    </message>
    <message>
        <source>focus before the job</source>
        <translation>vor dem Job fokussieren</translation>
    </message>
    <message>
        <source>power</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>of the beam</source>
        <translation>des Strahls</translation>
    </message>
    <message>
        <source>rate</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>of pulses</source>
        <translation>der Pulse</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>of cutting</source>
        <translation>des Schnitts</translation>
    </message>
    <message>
        <source>xmin</source>
        <translation>X-Anfang</translation>
    </message>
    <message>
        <source>where the program's zero lies</source>
        <translation>wo der Nullpunkt des Programms liegt</translation>
    </message>
    <message>
        <source>ymin</source>
        <translation>Y-Anfang</translation>
    </message>
    <message>
        <source>force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>of the blade</source>
        <translation>des Messers</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>cycles</source>
        <translation>Bohrzyklen</translation>
    </message>
    <message>
        <source>drilling cycles of the control (G81, G83) instead of single moves</source>
        <translation>Bohrzyklen der Steuerung (G81, G83) statt einzelner Bewegungen</translation>
    </message>
    <message>
        <source>jog</source>
        <translation>Eilgang</translation>
    </message>
    <message>
        <source>speed between cuts</source>
        <translation>Geschwindigkeit zwischen den Schnitten</translation>
    </message>
    <message>
        <source>of the attenuator</source>
        <translation>des Abschwächers</translation>
    </message>
    <message>
        <source>speed of jogs</source>
        <translation>Geschwindigkeit der Eilgänge</translation>
    </message>
    <message>
        <source>voxel</source>
        <translation>Zelle</translation>
    </message>
    <message>
        <source>edge of the smallest cell; 0: 1/200 of the longest side</source>
        <translation>Kante der kleinsten Zelle; 0: 1/200 der längsten Seite</translation>
    </message>
    <message>
        <source>DXF drawing</source>
        <translation>DXF-Zeichnung</translation>
    </message>
    <message>
        <source>paths as a drawing, in millimetres</source>
        <translation>Bahnen als Zeichnung, in Millimetern</translation>
    </message>
    <message>
        <source>Epilog laser cutter</source>
        <translation>Epilog-Laserschneider</translation>
    </message>
    <message>
        <source>PCL and HPGL for Epilog lasers: ticks of 1/600 inch</source>
        <translation>PCL und HPGL für Epilog-Laser: Schritte von 1/600 Zoll</translation>
    </message>
    <message>
        <source>Five axes, A and C in the table</source>
        <translation>Fünf Achsen, A und C im Tisch</translation>
    </message>
    <message>
        <source>LinuxCNC, trunnion table: A tilts about x and carries C, which turns the work; x, y and z follow the turned work</source>
        <translation>LinuxCNC, Schwenktisch: A kippt um x und trägt C, die das Werkstück dreht; x, y und z folgen dem gedrehten Werkstück</translation>
    </message>
    <message>
        <source>Five axes, B and C in the table</source>
        <translation>Fünf Achsen, B und C im Tisch</translation>
    </message>
    <message>
        <source>LinuxCNC, trunnion table: B tilts about y and carries C, which turns the work; x, y and z follow the turned work</source>
        <translation>LinuxCNC, Schwenktisch: B kippt um y und trägt C, die das Werkstück dreht; x, y und z folgen dem gedrehten Werkstück</translation>
    </message>
    <message>
        <source>Five axes in the head</source>
        <translation>Fünf Achsen, zwei im Kopf</translation>
    </message>
    <message>
        <source>G-code, head-head: C turns about z and carries B, which tilts about y; x, y and z move the pivot</source>
        <translation>G-Code, zwei Achsen im Kopf: C dreht um z und trägt B, die um y kippt; x, y und z bewegen den Drehpunkt</translation>
    </message>
    <message>
        <source>Five axes, B in the head, C in the table</source>
        <translation>Fünf Achsen, B im Kopf, C im Tisch</translation>
    </message>
    <message>
        <source>G-code, head-table: B tilts the head about y, C turns the work about z</source>
        <translation>G-Code, Kopf und Tisch: B kippt den Kopf um y, C dreht das Werkstück um z</translation>
    </message>
    <message>
        <source>Five axes, tool tip control</source>
        <translation>Fünf Achsen, geführte Werkzeugspitze</translation>
    </message>
    <message>
        <source>LinuxCNC with M428 (tool-centre-point mode), trunnion table A and C: x, y and z are the tip in the work</source>
        <translation>LinuxCNC mit M428 (Werkzeugspitze geführt), Schwenktisch A und C: x, y und z sind die Spitze im Werkstück</translation>
    </message>
    <message>
        <source>GCC laser cutter</source>
        <translation>GCC-Laserschneider</translation>
    </message>
    <message>
        <source>PCL and HPGL of GCC LaserPro Spirit lasers: ticks of 1/254 inch</source>
        <translation>PCL und HPGL der Laser GCC LaserPro Spirit: Schritte von 1/254 Zoll</translation>
    </message>
    <message>
        <source>GCC vinyl cutter</source>
        <translation>GCC-Schneideplotter</translation>
    </message>
    <message>
        <source>HPGL of GCC Puma and Expert cutters: ticks of 1/40 mm</source>
        <translation>HPGL der Schneideplotter GCC Puma und Expert: Schritte von 1/40 mm</translation>
    </message>
    <message>
        <source>Mill in inches</source>
        <translation>Fräse in Zoll</translation>
    </message>
    <message>
        <source>plain G-code in inches, as kokopelli wrote it: lines only</source>
        <translation>einfacher G-Code in Zoll, wie ihn kokopelli schrieb: nur Strecken</translation>
    </message>
    <message>
        <source>GRBL router</source>
        <translation>GRBL-Fräse</translation>
    </message>
    <message>
        <source>G-code for GRBL 1.1: three axes, arcs, one tool after another by hand</source>
        <translation>G-Code für GRBL 1.1: drei Achsen, Bögen, Werkzeugwechsel von Hand</translation>
    </message>
    <message>
        <source>HPGL plotter or fabric cutter</source>
        <translation>HPGL-Plotter oder Stoffschneider</translation>
    </message>
    <message>
        <source>HPGL for vinyl, fabric and drag-knife cutters: ticks of 1/40 mm</source>
        <translation>HPGL für Folien-, Stoff- und Schleppmesser: Schritte von 1/40 mm</translation>
    </message>
    <message>
        <source>Roland iModela</source>
        <translation>Roland iModela</translation>
    </message>
    <message>
        <source>RML for Roland iModela iM-01: ticks of 1/100 mm</source>
        <translation>RML für Roland iModela iM-01: Schritte von 1/100 mm</translation>
    </message>
    <message>
        <source>LinuxCNC mill</source>
        <translation>LinuxCNC-Fräse</translation>
    </message>
    <message>
        <source>G-code for LinuxCNC's interpreter: three axes, arcs, tool table lengths</source>
        <translation>G-Code für LinuxCNC: drei Achsen, Bögen, Längen aus der Werkzeugtabelle</translation>
    </message>
    <message>
        <source>Mach3 mill</source>
        <translation>Mach3-Fräse</translation>
    </message>
    <message>
        <source>G-code for Mach3 and Mach4: three axes, arcs</source>
        <translation>G-Code für Mach3 und Mach4: drei Achsen, Bögen</translation>
    </message>
    <message>
        <source>Marlin router</source>
        <translation>Marlin-Fräse</translation>
    </message>
    <message>
        <source>G-code for routers that run Marlin: lines only, every word in every line</source>
        <translation>G-Code für Fräsen mit Marlin: nur Strecken, jedes Wort in jeder Zeile</translation>
    </message>
    <message>
        <source>Roland MDX-40</source>
        <translation>Roland MDX-40</translation>
    </message>
    <message>
        <source>RML for Roland MDX-40: ticks of 1/100 mm</source>
        <translation>RML für Roland MDX-40: Schritte von 1/100 mm</translation>
    </message>
    <message>
        <source>Roland Modela MDX-15/20</source>
        <translation>Roland Modela MDX-15/20</translation>
    </message>
    <message>
        <source>RML for Roland Modela MDX-15 and MDX-20: ticks of 1/40 mm</source>
        <translation>RML für Roland Modela MDX-15 und MDX-20: Schritte von 1/40 mm</translation>
    </message>
    <message>
        <source>Othermill</source>
        <translation>Othermill</translation>
    </message>
    <message>
        <source>G-code for the Othermill (Bantam desktop mill): millimetres, lines only</source>
        <translation>G-Code für die Othermill (Tischfräse von Bantam): Millimeter, nur Strecken</translation>
    </message>
    <message>
        <source>Oxford laser micromachining</source>
        <translation>Oxford-Lasermikrobearbeitung</translation>
    </message>
    <message>
        <source>Aerotech G-code of Oxford lasers: millimetres and mm/s</source>
        <translation>Aerotech-G-Code der Oxford-Laser: Millimeter und mm/s</translation>
    </message>
    <message>
        <source>PNG height map</source>
        <translation>PNG-Höhenkarte</translation>
    </message>
    <message>
        <source>the part's heights as a 16-bit grey picture with its physical size, for other programs</source>
        <translation>die Höhen des Teils als Graubild mit 16 Bit und seiner wirklichen Größe, für andere Programme</translation>
    </message>
    <message>
        <source>Roland vinyl cutter</source>
        <translation>Roland-Schneideplotter</translation>
    </message>
    <message>
        <source>CAMM-GL of Roland GX-24 and its kin: ticks of 1/40 mm</source>
        <translation>CAMM-GL von Roland GX-24 und ähnlichen: Schritte von 1/40 mm</translation>
    </message>
    <message>
        <source>ShopBot (inches)</source>
        <translation>ShopBot (Zoll)</translation>
    </message>
    <message>
        <source>ShopBot 3-axis routers, part files in inches</source>
        <translation>ShopBot-Fräsen mit drei Achsen, Programme in Zoll</translation>
    </message>
    <message>
        <source>ShopBot 5-axis</source>
        <translation>ShopBot mit fünf Achsen</translation>
    </message>
    <message>
        <source>ShopBot with a head that turns about z (A) and tilts (B), part files in inches (Keeter 6.9); zero the bit pointing straight down</source>
        <translation>ShopBot, deren Kopf um z dreht (A) und kippt (B), Programme in Zoll (Keeter 6.9); Nullpunkt mit dem Werkzeug senkrecht nach unten setzen</translation>
    </message>
    <message>
        <source>ShopBot (mm)</source>
        <translation>ShopBot (mm)</translation>
    </message>
    <message>
        <source>ShopBot 3-axis routers set to millimetres</source>
        <translation>ShopBot-Fräsen mit drei Achsen, auf Millimeter eingestellt</translation>
    </message>
    <message>
        <source>Roland SRM-20</source>
        <translation>Roland SRM-20</translation>
    </message>
    <message>
        <source>RML for Roland monoFab SRM-20: ticks of 1/100 mm</source>
        <translation>RML für Roland monoFab SRM-20: Schritte von 1/100 mm</translation>
    </message>
    <message>
        <source>STL mesh</source>
        <translation>STL-Netz</translation>
    </message>
    <message>
        <source>the part as a watertight mesh</source>
        <translation>das Teil als wasserdichtes Netz</translation>
    </message>
    <message>
        <source>SVG drawing</source>
        <translation>SVG-Zeichnung</translation>
    </message>
    <message>
        <source>Trotec laser cutter</source>
        <translation>Trotec-Laserschneider</translation>
    </message>
    <message>
        <source>serial commands of Trotec Speedy lasers: ticks of 5 micrometres</source>
        <translation>serielle Befehle der Laser Trotec Speedy: Schritte von 5 Mikrometern</translation>
    </message>
    <message>
        <source>Universal laser cutter</source>
        <translation>Universal-Laserschneider</translation>
    </message>
    <message>
        <source>HPGL dialect of Universal lasers: ticks of 1/1000 inch</source>
        <translation>HPGL-Dialekt der Universal-Laser: Schritte von 1/1000 Zoll</translation>
    </message>
</context>
<context>
    <name>Kernel: choice</name>
    <message>
        <source>outside</source>
        <translation>außen</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>innen</translation>
    </message>
    <message>
        <source>on</source>
        <translation>auf dem Umriss</translation>
    </message>
    <message>
        <source>rings</source>
        <translation>Ringe</translation>
    </message>
    <message>
        <source>adaptive</source>
        <translation>adaptiv</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>raster</source>
        <translation>Zeilen</translation>
    </message>
    <message>
        <source>cross</source>
        <translation>Kreuz</translation>
    </message>
    <message>
        <source>spiral</source>
        <translation>Spirale</translation>
    </message>
    <message>
        <source>none</source>
        <translation>kein</translation>
    </message>
    <message>
        <source>mist</source>
        <translation>Nebel</translation>
    </message>
    <message>
        <source>flood</source>
        <translation>Flut</translation>
    </message>
    <message>
        <source>plunge</source>
        <translation>senkrecht</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>helix</source>
        <translation>Wendel</translation>
    </message>
    <message>
        <source>top</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>unten</translation>
    </message>
    <message>
        <source>front</source>
        <translation>vorn</translation>
    </message>
    <message>
        <source>back</source>
        <translation>hinten</translation>
    </message>
    <message>
        <source>five</source>
        <translation>fünf Seiten</translation>
    </message>
    <message>
        <source>view</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>stepped</source>
        <translation>Schritte</translation>
    </message>
</context>
<context>
    <name>Kernel: message</name>
    <message>
        <source>!MC1 without a speed by !RC: 1 revolution per minute stands for it</source>
        <translation>!MC1 ohne Drehzahl durch !RC: stattdessen gilt 1 Umdrehung je Minute</translation>
    </message>
    <message>
        <source>"{0}" is none of CTD, SPT, FFS, FEFS, FEFS-FFS, RS</source>
        <translation>"{0}" ist nicht bekannt; möglich sind CTD, SPT, FFS, FEFS, FEFS-FFS, RS</translation>
    </message>
    <message>
        <source>#&lt;{0}&gt; cannot be set: it follows from the machine's state</source>
        <translation>#&lt;{0}&gt; kann nicht gesetzt werden: der Wert folgt aus dem Zustand der Maschine</translation>
    </message>
    <message>
        <source>#&lt;{0}&gt; has no value yet</source>
        <translation>#&lt;{0}&gt; hat noch keinen Wert</translation>
    </message>
    <message>
        <source>#&lt;{0}&gt; is 0: there is no such thing here</source>
        <translation>#&lt;{0}&gt; ist 0: dergleichen gibt es hier nicht</translation>
    </message>
    <message>
        <source>#&lt;{0}&gt; would be no finite number</source>
        <translation>#&lt;{0}&gt; wäre keine endliche Zahl</translation>
    </message>
    <message>
        <source>&amp; without the name of a variable</source>
        <translation>&amp; ohne Namen einer Variablen</translation>
    </message>
    <message>
        <source>&amp;{0} is given something that is not known here</source>
        <translation>&amp;{0} erhält etwas, das hier unbekannt ist</translation>
    </message>
    <message>
        <source>'(' without its ')'</source>
        <translation>'(' ohne ')'</translation>
    </message>
    <message>
        <source>'(' without its ')': the rest of the line is a comment</source>
        <translation>'(' ohne ')': der Rest der Zeile ist Kommentar</translation>
    </message>
    <message>
        <source>'&lt;' without its '&gt;'</source>
        <translation>'&lt;' ohne '&gt;'</translation>
    </message>
    <message>
        <source>'=' is missing behind &amp;{0}</source>
        <translation>'=' fehlt hinter &amp;{0}</translation>
    </message>
    <message>
        <source>'=' is missing behind a parameter that begins a word</source>
        <translation>'=' fehlt hinter einem Parameter am Wortanfang</translation>
    </message>
    <message>
        <source>'[' without its ']'</source>
        <translation>'[' ohne ']'</translation>
    </message>
    <message>
        <source>'files' are names</source>
        <translation>'files' sind Namen</translation>
    </message>
    <message>
        <source>'open' has no option '{0}'{1}</source>
        <translation>'open' hat keine Option '{0}'{1}</translation>
    </message>
    <message>
        <source>'open' lacks the name of a file in quotes</source>
        <translation>bei 'open' fehlt der Dateiname in Anführungszeichen</translation>
    </message>
    <message>
        <source>'part' lacks its shape or its name: part(SHAPE, "NAME", "COLOUR")</source>
        <translation>bei 'part' fehlt die Form oder der Name: part(SHAPE, "NAME", "COLOUR")</translation>
    </message>
    <message>
        <source>'{0}' cannot begin a word</source>
        <translation>mit '{0}' kann kein Wort beginnen</translation>
    </message>
    <message>
        <source>'{0}' compares nothing</source>
        <translation>'{0}' ist kein Vergleichszeichen</translation>
    </message>
    <message>
        <source>'{0}' found behind a value</source>
        <translation>'{0}' hinter einem Wert gefunden</translation>
    </message>
    <message>
        <source>'{0}' found where a number should be</source>
        <translation>'{0}' gefunden, Zahl erwartet</translation>
    </message>
    <message>
        <source>'{0}' found where a value should be</source>
        <translation>'{0}' gefunden, Wert erwartet</translation>
    </message>
    <message>
        <source>'{0}' found where an argument in brackets should be</source>
        <translation>'{0}' gefunden, Argument in Klammern erwartet</translation>
    </message>
    <message>
        <source>'{0}' found where an instruction should be</source>
        <translation>'{0}' gefunden, Anweisung erwartet</translation>
    </message>
    <message>
        <source>'{0}' found where an operator or ']' should be</source>
        <translation>'{0}' gefunden, Operator oder ']' erwartet</translation>
    </message>
    <message>
        <source>'{0}' has a meaning already and cannot be given another</source>
        <translation>'{0}' hat schon eine Bedeutung und kann keine andere bekommen</translation>
    </message>
    <message>
        <source>'{0}' has another type</source>
        <translation>'{0}' hat einen anderen Typ</translation>
    </message>
    <message>
        <source>'{0}' has no parameter '{1}'; it has: {2}</source>
        <translation>'{0}' hat keinen Parameter '{1}'; vorhanden: {2}</translation>
    </message>
    <message>
        <source>'{0}' is a command to the control: passed over</source>
        <translation>'{0}' ist ein Befehl an die Steuerung: übergangen</translation>
    </message>
    <message>
        <source>'{0}' is a function already</source>
        <translation>'{0}' ist schon eine Funktion</translation>
    </message>
    <message>
        <source>'{0}' is a function: write {1}(...)</source>
        <translation>'{0}' ist eine Funktion: {1}(...) schreiben</translation>
    </message>
    <message>
        <source>'{0}' is an option of a {1}, and this is a {2}</source>
        <translation>'{0}' ist eine Option für Dateien der Art {1}, diese hat die Art {2}</translation>
    </message>
    <message>
        <source>'{0}' is defined twice</source>
        <translation>'{0}' ist doppelt definiert</translation>
    </message>
    <message>
        <source>'{0}' is no number</source>
        <translation>'{0}' ist keine Zahl</translation>
    </message>
    <message>
        <source>'{0}' is no text</source>
        <translation>'{0}' ist kein Text</translation>
    </message>
    <message>
        <source>'{0}' is no type of sample</source>
        <translation>'{0}' ist kein Typ von Messwerten</translation>
    </message>
    <message>
        <source>'{0}' is no whole number from 0 to 99999</source>
        <translation>'{0}' ist keine ganze Zahl von 0 bis 99999</translation>
    </message>
    <message>
        <source>'{0}' is none of automatic, reference, portable, avx2, avx512, jit, jit-avx2, jit-avx512</source>
        <translation>'{0}' ist nicht automatic, reference, portable, avx2, avx512, jit, jit-avx2 oder jit-avx512</translation>
    </message>
    <message>
        <source>'{0}' is none of bitmap, height, normals, shaded</source>
        <translation>'{0}' ist nicht bitmap, height, normals oder shaded</translation>
    </message>
    <message>
        <source>'{0}' is none of median, gaussian, anisotropic</source>
        <translation>'{0}' ist nicht median, gaussian oder anisotropic</translation>
    </message>
    <message>
        <source>'{0}' is not a density, a share such as 90%, halfway, or otsu</source>
        <translation>'{0}' ist weder eine Dichte noch ein Anteil wie 90%, halfway oder otsu</translation>
    </message>
    <message>
        <source>'{0}' is not a distance</source>
        <translation>'{0}' ist kein Abstand</translation>
    </message>
    <message>
        <source>'{0}' is not a number above 0, up to 100</source>
        <translation>'{0}' ist keine Zahl über 0 bis höchstens 100</translation>
    </message>
    <message>
        <source>'{0}' is not known behind an O-word</source>
        <translation>'{0}' ist hinter einem O-Wort unbekannt</translation>
    </message>
    <message>
        <source>'{0}' is not known here</source>
        <translation>'{0}' ist hier unbekannt</translation>
    </message>
    <message>
        <source>'{0}' is three numbers</source>
        <translation>'{0}' sind drei Zahlen</translation>
    </message>
    <message>
        <source>'{0}' is too much behind {1}</source>
        <translation>'{0}' ist hinter {1} zu viel</translation>
    </message>
    <message>
        <source>'{0}' lacks its argument '{1}'</source>
        <translation>bei '{0}' fehlt das Argument '{1}'</translation>
    </message>
    <message>
        <source>'{0}' of 'open' must be a plain number or words</source>
        <translation>'{0}' von 'open' muss eine konstante Zahl oder ein Text sein</translation>
    </message>
    <message>
        <source>'{0}' of '{1}' must be a plain {2}</source>
        <translation>'{0}' von '{1}' muss eine Konstante sein: {2}</translation>
    </message>
    <message>
        <source>'{0}' of '{1}' {2}</source>
        <translation>'{0}' von '{1}' {2}</translation>
    </message>
    <message>
        <source>'{0}' of two solids: write a | b for their union, or value(a) {0} value(b) for numbers</source>
        <translation>'{0}' bei zwei Körpern: a | b für ihre Vereinigung schreiben, oder value(a) {0} value(b) für Zahlen</translation>
    </message>
    <message>
        <source>'{0}' takes at most {1} {2}</source>
        <translation>'{0}' nimmt höchstens {1} {2}</translation>
    </message>
    <message>
        <source>'{0}' takes no words in quotes</source>
        <translation>'{0}' nimmt keinen Text in Anführungszeichen an</translation>
    </message>
    <message>
        <source>'{0}' was never declared</source>
        <translation>'{0}' wurde nie deklariert</translation>
    </message>
    <message>
        <source>, or a thickness to make a plate of a flat model</source>
        <translation>, oder eine Dicke, um aus einem flachen Modell eine Platte zu machen</translation>
    </message>
    <message>
        <source>1 to 100000 frames of 16 to 8192 pixels are wanted</source>
        <translation>möglich sind 1 bis 100000 Einzelbilder von 16 bis 8192 Pixeln</translation>
    </message>
    <message>
        <source>; did you mean '{0}'?</source>
        <translation>; meinten Sie '{0}'?</translation>
    </message>
    <message>
        <source>; it has none at all</source>
        <translation>; sie hat überhaupt keine</translation>
    </message>
    <message>
        <source>; it knows {0}</source>
        <translation>; bekannt sind {0}</translation>
    </message>
    <message>
        <source>@ and ^ are of the plane G17</source>
        <translation>@ und ^ gibt es nur in der Ebene G17</translation>
    </message>
    <message>
        <source>@ and ^ do not go with X and Y</source>
        <translation>@ und ^ sind nicht zusammen mit X und Y möglich</translation>
    </message>
    <message>
        <source>ACOS of {0}, which is not between -1 and 1</source>
        <translation>ACOS von {0}: das Argument muss zwischen -1 und 1 liegen</translation>
    </message>
    <message>
        <source>ASIN of {0}, which is not between -1 and 1</source>
        <translation>ASIN von {0}: das Argument muss zwischen -1 und 1 liegen</translation>
    </message>
    <message>
        <source>ATAN must be written as ATAN[y]/[x]</source>
        <translation>ATAN muss als ATAN[y]/[x] geschrieben werden</translation>
    </message>
    <message>
        <source>CG with a diameter of {0} cannot reach its end</source>
        <translation>CG mit Durchmesser {0} kann sein Ende nicht erreichen</translation>
    </message>
    <message>
        <source>CP away from where the tool is, and the tool is below 0: the height that the control pulls up to is not known here</source>
        <translation>CP abseits der Werkzeugposition, und das Werkzeug steht unter 0: die Höhe, auf die die Steuerung anhebt, ist hier unbekannt</translation>
    </message>
    <message>
        <source>CP needs a diameter above 0</source>
        <translation>CP braucht einen Durchmesser über 0</translation>
    </message>
    <message>
        <source>CP: the control pulls up before it goes to the circle; the height that the tool has is taken</source>
        <translation>CP: die Steuerung hebt das Werkzeug an, bevor sie zum Kreis fährt; angenommen wird die aktuelle Werkzeughöhe</translation>
    </message>
    <message>
        <source>D{0} is below 0</source>
        <translation>D{0} liegt unter 0</translation>
    </message>
    <message>
        <source>EXISTS must be written as EXISTS[#&lt;name&gt;]</source>
        <translation>EXISTS muss als EXISTS[#&lt;name&gt;] geschrieben werden</translation>
    </message>
    <message>
        <source>F in the block of {0} still counts in the units before it</source>
        <translation>F im Satz mit {0} gilt noch in der vorherigen Einheit</translation>
    </message>
    <message>
        <source>F{0} is below 0</source>
        <translation>F{0} liegt unter 0</translation>
    </message>
    <message>
        <source>G10 L20 has no use for R</source>
        <translation>G10 L20 verwendet kein R</translation>
    </message>
    <message>
        <source>G10 L{0} P{1}: there are P1 to P9, and P0 for the one in force</source>
        <translation>G10 L{0} P{1}: möglich sind P1 bis P9, und P0 für das aktive Koordinatensystem</translation>
    </message>
    <message>
        <source>G10 L{0} P{1}: there is no such tool</source>
        <translation>G10 L{0} P{1}: dieses Werkzeug gibt es nicht</translation>
    </message>
    <message>
        <source>G10 L{0} is not known here</source>
        <translation>G10 L{0} ist hier unbekannt</translation>
    </message>
    <message>
        <source>G10 L{0} while G68 is in force</source>
        <translation>G10 L{0} bei aktivem G68</translation>
    </message>
    <message>
        <source>G10 needs L</source>
        <translation>G10 braucht L</translation>
    </message>
    <message>
        <source>G10 needs P</source>
        <translation>G10 braucht P</translation>
    </message>
    <message>
        <source>G28 and G30 cannot be used while G68 is in force</source>
        <translation>G28 und G30 sind bei aktivem G68 nicht möglich</translation>
    </message>
    <message>
        <source>G33 needs K, the pitch</source>
        <translation>G33 braucht K, die Steigung</translation>
    </message>
    <message>
        <source>G33 while the spindle stands still</source>
        <translation>G33 bei stehender Spindel</translation>
    </message>
    <message>
        <source>G38: the probe is taken to touch nothing on its way</source>
        <translation>G38: angenommen wird, dass der Messtaster unterwegs nichts berührt</translation>
    </message>
    <message>
        <source>G4 needs P, the seconds</source>
        <translation>G4 braucht P, die Sekunden</translation>
    </message>
    <message>
        <source>G4 with S and no P is taken as seconds, as Marlin does</source>
        <translation>G4 mit S und ohne P gilt als Sekunden, wie bei Marlin</translation>
    </message>
    <message>
        <source>G43.1 is known for X, Y and Z only</source>
        <translation>G43.1 ist nur für X, Y und Z bekannt</translation>
    </message>
    <message>
        <source>G43.1 needs an axis word</source>
        <translation>G43.1 braucht ein Achswort</translation>
    </message>
    <message>
        <source>G43.2 needs H</source>
        <translation>G43.2 braucht H</translation>
    </message>
    <message>
        <source>G5 needs P and Q</source>
        <translation>G5 braucht P und Q</translation>
    </message>
    <message>
        <source>G5 needs both I and J, or neither</source>
        <translation>G5 braucht I und J oder keines von beiden</translation>
    </message>
    <message>
        <source>G5.1 needs I and J</source>
        <translation>G5.1 braucht I und J</translation>
    </message>
    <message>
        <source>G5.3 without G5.2</source>
        <translation>G5.3 ohne G5.2</translation>
    </message>
    <message>
        <source>G53 cannot be used while G68 is in force</source>
        <translation>G53 ist bei aktivem G68 nicht möglich</translation>
    </message>
    <message>
        <source>G53 goes with G0 and G1 only</source>
        <translation>G53 ist nur mit G0 und G1 möglich</translation>
    </message>
    <message>
        <source>G53 needs G90</source>
        <translation>G53 braucht G90</translation>
    </message>
    <message>
        <source>G68 and G69</source>
        <translation>G68 und G69</translation>
    </message>
    <message>
        <source>G68 needs R, the angle</source>
        <translation>G68 braucht R, den Winkel</translation>
    </message>
    <message>
        <source>G68 turns about a point of the plane in force</source>
        <translation>G68 dreht um einen Punkt der aktiven Ebene</translation>
    </message>
    <message>
        <source>G76 needs P and J above 0, and I other than 0</source>
        <translation>G76 braucht P und J über 0 und I ungleich 0</translation>
    </message>
    <message>
        <source>G76 needs {0}</source>
        <translation>G76 braucht {0}</translation>
    </message>
    <message>
        <source>G76 takes no axis word but Z</source>
        <translation>G76 nimmt kein Achswort außer Z</translation>
    </message>
    <message>
        <source>G76 while the spindle stands still</source>
        <translation>G76 bei stehender Spindel</translation>
    </message>
    <message>
        <source>G76 with E beyond the thread's length</source>
        <translation>G76 mit E über die Gewindelänge hinaus</translation>
    </message>
    <message>
        <source>G76 with Q{0}: the slant is between 0 and 80 degrees</source>
        <translation>G76 mit Q{0}: der Zustellwinkel muss zwischen 0 und 80 Grad liegen</translation>
    </message>
    <message>
        <source>G76 with R{0}: it must be 1 or more</source>
        <translation>G76 mit R{0}: R muss mindestens 1 sein</translation>
    </message>
    <message>
        <source>G76 with a bad H or L</source>
        <translation>G76 mit unzulässigem H oder L</translation>
    </message>
    <message>
        <source>G76 with more than {0} passes</source>
        <translation>G76 mit mehr als {0} Durchgängen</translation>
    </message>
    <message>
        <source>G76: K, the full depth, must be more than J, the first cut's</source>
        <translation>G76: K, die volle Tiefe, muss größer sein als J, die Tiefe des ersten Schnitts</translation>
    </message>
    <message>
        <source>G80 has no use for axis words</source>
        <translation>G80 verwendet keine Achswörter</translation>
    </message>
    <message>
        <source>G88: the operator is taken to draw the tool out straight</source>
        <translation>G88: angenommen wird, dass der Bediener das Werkzeug gerade herauszieht</translation>
    </message>
    <message>
        <source>G96 with D{0}: the greatest speed must be above 0</source>
        <translation>G96 mit D{0}: die größte Drehzahl muss über 0 liegen</translation>
    </message>
    <message>
        <source>G{0} is below 0</source>
        <translation>G{0} liegt unter 0</translation>
    </message>
    <message>
        <source>H{0} is below 0</source>
        <translation>H{0} liegt unter 0</translation>
    </message>
    <message>
        <source>IF without THEN</source>
        <translation>IF ohne THEN</translation>
    </message>
    <message>
        <source>IF {0}: what the control knows is not known here; taken as not so</source>
        <translation>IF {0}: die Werte der Steuerung sind hier unbekannt; gilt als nicht erfüllt</translation>
    </message>
    <message>
        <source>LN of {0}, which is not above 0</source>
        <translation>LN von {0}: das Argument muss über 0 liegen</translation>
    </message>
    <message>
        <source>M61 needs Q, the tool's number</source>
        <translation>M61 braucht Q, die Werkzeugnummer</translation>
    </message>
    <message>
        <source>M61 with Q{0}, which is below 0</source>
        <translation>M61 mit Q{0}: Q darf nicht unter 0 liegen</translation>
    </message>
    <message>
        <source>M66 waits for an input: it is taken as not there (#5399 is -1)</source>
        <translation>M66 wartet auf einen Eingang: er gilt als nicht vorhanden (#5399 ist -1)</translation>
    </message>
    <message>
        <source>M72 where M70 has saved nothing</source>
        <translation>M72, ohne dass M70 etwas gesichert hat</translation>
    </message>
    <message>
        <source>M73 outside of a subroutine does nothing</source>
        <translation>M73 bewirkt außerhalb eines Unterprogramms nichts</translation>
    </message>
    <message>
        <source>M98 needs P, the program's number</source>
        <translation>M98 braucht P, die Programmnummer</translation>
    </message>
    <message>
        <source>M98 with L{0}, which is below 0</source>
        <translation>M98 mit L{0}: L darf nicht unter 0 liegen</translation>
    </message>
    <message>
        <source>M99 in the main program would begin it anew for ever: it ends here</source>
        <translation>M99 im Hauptprogramm würde es endlos wiederholen: es endet hier</translation>
    </message>
    <message>
        <source>MOD of zero</source>
        <translation>MOD mit Divisor null</translation>
    </message>
    <message>
        <source>M{0} and M{1} exclude each other in one block</source>
        <translation>M{0} und M{1} schließen einander in einem Satz aus</translation>
    </message>
    <message>
        <source>M{0} and M{1} in one block: the last one holds</source>
        <translation>M{0} und M{1} in einem Satz: das letzte gilt</translation>
    </message>
    <message>
        <source>M{0} has no meaning here: passed over</source>
        <translation>M{0} hat hier keine Bedeutung: übergangen</translation>
    </message>
    <message>
        <source>M{0} is not known here</source>
        <translation>M{0} ist hier unbekannt</translation>
    </message>
    <message>
        <source>M{0} sets an output: passed over</source>
        <translation>M{0} setzt einen Ausgang: übergangen</translation>
    </message>
    <message>
        <source>N without its number</source>
        <translation>N ohne Nummer</translation>
    </message>
    <message>
        <source>PD before !PZ has said how deep</source>
        <translation>PD, bevor !PZ die Tiefe festgelegt hat</translation>
    </message>
    <message>
        <source>Python in a program is not carried out</source>
        <translation>Python in einem Programm wird nicht ausgeführt</translation>
    </message>
    <message>
        <source>RETURN without GOSUB</source>
        <translation>RETURN ohne GOSUB</translation>
    </message>
    <message>
        <source>SO switches an output: passed over</source>
        <translation>SO schaltet einen Ausgang: übergangen</translation>
    </message>
    <message>
        <source>SQRT of {0}, which is below 0</source>
        <translation>SQRT von {0}: das Argument darf nicht unter 0 liegen</translation>
    </message>
    <message>
        <source>S{0} is below 0</source>
        <translation>S{0} liegt unter 0</translation>
    </message>
    <message>
        <source>TR with a speed of {0}</source>
        <translation>TR mit unzulässiger Drehzahl {0}</translation>
    </message>
    <message>
        <source>T{0} is below 0</source>
        <translation>T{0} liegt unter 0</translation>
    </message>
    <message>
        <source>VA: what follows the five axes is passed over</source>
        <translation>VA: was auf die fünf Achsen folgt, wird übergangen</translation>
    </message>
    <message>
        <source>Z{0} is not known here</source>
        <translation>Z{0} ist hier unbekannt</translation>
    </message>
    <message>
        <source>^ without @ at the origin</source>
        <translation>^ ohne @ am Ursprung</translation>
    </message>
    <message>
        <source>a .glb file holds at most 4 GiB; .3mf and .ply files hold more</source>
        <translation>eine .glb-Datei fasst höchstens 4 GiB; .3mf- und .ply-Dateien fassen mehr</translation>
    </message>
    <message>
        <source>a Field's interval or its restriction does not agree with its values</source>
        <translation>das Intervall eines Field oder seine Einschränkung passt nicht zu seinen Werten</translation>
    </message>
    <message>
        <source>a NURBS moves X and Y only</source>
        <translation>eine NURBS bewegt nur X und Y</translation>
    </message>
    <message>
        <source>a NURBS of order {0}</source>
        <translation>NURBS mit unzulässiger Ordnung {0}</translation>
    </message>
    <message>
        <source>a NURBS of order {0} needs as many control points; there are {1}</source>
        <translation>eine NURBS der Ordnung {0} braucht mindestens ebenso viele Kontrollpunkte; vorhanden sind {1}</translation>
    </message>
    <message>
        <source>a block is not in it</source>
        <translation>ein Block liegt nicht in der Datei</translation>
    </message>
    <message>
        <source>a block stands where none can be</source>
        <translation>ein Block steht, wo keiner sein kann</translation>
    </message>
    <message>
        <source>a box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>a branch with children that do not fit it</source>
        <translation>ein Zweig mit unpassenden Kindern</translation>
    </message>
    <message>
        <source>a canned cycle</source>
        <translation>Bohrzyklus</translation>
    </message>
    <message>
        <source>a cell</source>
        <translation>Zelle</translation>
    </message>
    <message>
        <source>a cell of {0} mm</source>
        <translation>eine Zelle von {0} mm</translation>
    </message>
    <message>
        <source>a cell's content</source>
        <translation>Inhalt einer Zelle</translation>
    </message>
    <message>
        <source>a centre and an angle</source>
        <translation>einen Mittelpunkt und einen Winkel</translation>
    </message>
    <message>
        <source>a change of kinematics</source>
        <translation>Kinematikwechsel</translation>
    </message>
    <message>
        <source>a change of plane</source>
        <translation>Ebenenwechsel</translation>
    </message>
    <message>
        <source>a change of the tool's length</source>
        <translation>Änderung der Werkzeuglänge</translation>
    </message>
    <message>
        <source>a chip load needs a diameter above 0</source>
        <translation>ein Zahnvorschub braucht einen Durchmesser über 0</translation>
    </message>
    <message>
        <source>a circle inside or outside of the line needs the cutter's diameter, which is not known here</source>
        <translation>ein Kreis innerhalb oder außerhalb der Linie braucht den Fräserdurchmesser, der hier unbekannt ist</translation>
    </message>
    <message>
        <source>a circle with a proportion of {0}</source>
        <translation>Kreis mit unzulässigem Streckfaktor {0}</translation>
    </message>
    <message>
        <source>a circle with a radius of 0</source>
        <translation>Kreis mit Radius 0</translation>
    </message>
    <message>
        <source>a circle with tabs or a pocket is not known here</source>
        <translation>ein Kreis mit Haltestegen oder Tasche ist hier unbekannt</translation>
    </message>
    <message>
        <source>a circle with {0} repetitions</source>
        <translation>Kreis mit unzulässiger Anzahl von {0} Wiederholungen</translation>
    </message>
    <message>
        <source>a column's end</source>
        <translation>Ende einer Säule</translation>
    </message>
    <message>
        <source>a command with more than 100 parameters</source>
        <translation>Befehl mit mehr als 100 Parametern</translation>
    </message>
    <message>
        <source>a component</source>
        <translation>eine Komponente</translation>
    </message>
    <message>
        <source>a constant must be a finite number</source>
        <translation>eine Konstante muss eine endliche Zahl sein</translation>
    </message>
    <message>
        <source>a control point with the weight {0}</source>
        <translation>Kontrollpunkt mit unzulässigem Gewicht {0}</translation>
    </message>
    <message>
        <source>a corner</source>
        <translation>eine Ecke</translation>
    </message>
    <message>
        <source>a count is larger than the file</source>
        <translation>eine Anzahl ist größer als die Datei</translation>
    </message>
    <message>
        <source>a division</source>
        <translation>Teilung</translation>
    </message>
    <message>
        <source>a dwell of {0} seconds</source>
        <translation>unzulässige Verweilzeit von {0} Sekunden</translation>
    </message>
    <message>
        <source>a face has an impossible number of crossings</source>
        <translation>eine Fläche hat eine unmögliche Zahl von Schnittpunkten</translation>
    </message>
    <message>
        <source>a face refers to a vertex that is not there</source>
        <translation>eine Fläche verweist auf einen Eckpunkt, den es nicht gibt</translation>
    </message>
    <message>
        <source>a feed of {0} mm/min</source>
        <translation>unzulässiger Vorschub von {0} mm/min</translation>
    </message>
    <message>
        <source>a feed per revolution (G95) while the spindle's speed is 0</source>
        <translation>Vorschub je Umdrehung (G95) bei Spindeldrehzahl 0</translation>
    </message>
    <message>
        <source>a feed without a feed rate (F): its time is not counted</source>
        <translation>Vorschubbewegung ohne Vorschub (F): ihre Zeit wird nicht gezählt</translation>
    </message>
    <message>
        <source>a feed without a feed rate: F is missing or 0</source>
        <translation>Vorschubbewegung ohne Vorschub: F fehlt oder ist 0</translation>
    </message>
    <message>
        <source>a fixture needs a model, or lower and upper corners</source>
        <translation>ein Spannmittel braucht ein Modell oder eine untere und eine obere Ecke</translation>
    </message>
    <message>
        <source>a form tool is for simulation only: nothing is planned with it</source>
        <translation>ein Formwerkzeug dient nur der Simulation: mit ihm wird nichts geplant</translation>
    </message>
    <message>
        <source>a function's argument must stand in brackets</source>
        <translation>das Argument einer Funktion muss in Klammern stehen</translation>
    </message>
    <message>
        <source>a job needs a machine</source>
        <translation>ein Auftrag braucht eine Maschine</translation>
    </message>
    <message>
        <source>a job needs an [input] with a model or an image</source>
        <translation>ein Auftrag braucht ein [input] mit einem Modell oder einem Bild</translation>
    </message>
    <message>
        <source>a job needs at least one [[operation]]</source>
        <translation>ein Auftrag braucht mindestens eine [[operation]]</translation>
    </message>
    <message>
        <source>a job with an image as its input has no other models</source>
        <translation>ein Auftrag mit einem Bild als Eingabe hat keine anderen Modelle</translation>
    </message>
    <message>
        <source>a lattice needs two points and a positive length along each axis</source>
        <translation>ein Raster braucht entlang jeder Achse zwei Punkte und eine positive Länge</translation>
    </message>
    <message>
        <source>a list has a negative length</source>
        <translation>eine Liste hat eine negative Länge</translation>
    </message>
    <message>
        <source>a machine needs the key {0}</source>
        <translation>eine Maschine braucht den Schlüssel {0}</translation>
    </message>
    <message>
        <source>a machine that takes {0} has the format text, dxf or svg</source>
        <translation>eine Maschine mit takes = '{0}' hat das Format text, dxf oder svg</translation>
    </message>
    <message>
        <source>a machine that tilts has one or two [[kinematics.axis]]</source>
        <translation>eine Maschine mit Schwenkachsen hat ein oder zwei [[kinematics.axis]]</translation>
    </message>
    <message>
        <source>a merged cell has several patches</source>
        <translation>eine verschmolzene Zelle hat mehrere Flächenstücke</translation>
    </message>
    <message>
        <source>a mesh this fine</source>
        <translation>ein so feines Netz</translation>
    </message>
    <message>
        <source>a model that opens other files can be written as .frep text only</source>
        <translation>ein Modell, das andere Dateien öffnet, kann nur als .frep-Text geschrieben werden</translation>
    </message>
    <message>
        <source>a move before MS: 25.4 mm/s is taken</source>
        <translation>Bewegung vor MS: 25.4 mm/s werden angenommen</translation>
    </message>
    <message>
        <source>a move before VS: 3 mm/s is taken</source>
        <translation>Bewegung vor VS: 3 mm/s werden angenommen</translation>
    </message>
    <message>
        <source>a move to {0}, which no machine can reach</source>
        <translation>Bewegung nach {0}, für keine Maschine erreichbar</translation>
    </message>
    <message>
        <source>a number of cells</source>
        <translation>Zahl der Zellen</translation>
    </message>
    <message>
        <source>a number of samples</source>
        <translation>Zahl der Messpunkte</translation>
    </message>
    <message>
        <source>a number of slots</source>
        <translation>Zahl der Plätze</translation>
    </message>
    <message>
        <source>a palette of an impossible kind</source>
        <translation>eine Palette unmöglicher Art</translation>
    </message>
    <message>
        <source>a parameter between &lt; and &gt; needs a name</source>
        <translation>ein Parameter zwischen &lt; und &gt; braucht einen Namen</translation>
    </message>
    <message>
        <source>a pause of {0} seconds</source>
        <translation>unzulässige Pause von {0} Sekunden</translation>
    </message>
    <message>
        <source>a picture needs finite bounds with a positive size along x and y</source>
        <translation>ein Bild braucht endliche Grenzen mit positiver Ausdehnung in x und y</translation>
    </message>
    <message>
        <source>a picture of a program is a .png or an .svg</source>
        <translation>ein Bild eines Programms ist eine .png- oder .svg-Datei</translation>
    </message>
    <message>
        <source>a picture of a solid needs finite bounds with a positive size along x, y and z</source>
        <translation>ein Bild eines Körpers braucht endliche Grenzen mit positiver Ausdehnung in x, y und z</translation>
    </message>
    <message>
        <source>a picture of a stock is a .png</source>
        <translation>ein Bild eines Rohteils ist eine .png-Datei</translation>
    </message>
    <message>
        <source>a placement must be finite and invertible</source>
        <translation>eine Platzierung muss endlich und umkehrbar sein</translation>
    </message>
    <message>
        <source>a profile begins on the axis and goes outwards: [[0, 0], ..., [radius, height]]</source>
        <translation>ein Profil beginnt auf der Achse und läuft nach außen: [[0, 0], ..., [Radius, Höhe]]</translation>
    </message>
    <message>
        <source>a profile is [[distance from the axis, height], ...]</source>
        <translation>ein Profil ist [[Abstand von der Achse, Höhe], ...]</translation>
    </message>
    <message>
        <source>a radius</source>
        <translation>einen Radius</translation>
    </message>
    <message>
        <source>a random state</source>
        <translation>Zustand des Zufallsgenerators</translation>
    </message>
    <message>
        <source>a rapid goes through material</source>
        <translation>ein Eilgang geht durch Material</translation>
    </message>
    <message>
        <source>a region must be finite and have a positive size along x and y</source>
        <translation>ein Bereich muss endlich sein und in x und y eine positive Ausdehnung haben</translation>
    </message>
    <message>
        <source>a region must be finite and have a positive size along x, y and z</source>
        <translation>ein Bereich muss endlich sein und in x, y und z eine positive Ausdehnung haben</translation>
    </message>
    <message>
        <source>a rotary axis is called A, B or C, not '{0}'</source>
        <translation>eine Drehachse heißt A, B oder C, nicht '{0}'</translation>
    </message>
    <message>
        <source>a rule</source>
        <translation>Regel</translation>
    </message>
    <message>
        <source>a sample</source>
        <translation>Messpunkt</translation>
    </message>
    <message>
        <source>a sample's edge</source>
        <translation>Kante eines Messpunkts</translation>
    </message>
    <message>
        <source>a saved stock has its own {0}</source>
        <translation>ein gespeichertes Rohteil hat schon {0}</translation>
    </message>
    <message>
        <source>a saved stock is as it is: file stands alone</source>
        <translation>ein gespeichertes Rohteil steht fest: file steht allein</translation>
    </message>
    <message>
        <source>a scallop needs a ball, bull-nose or tapered tool; give a stepover</source>
        <translation>eine Rillenhöhe (scallop) braucht einen Kugelfräser, Torusfräser oder konischen Kugelfräser; einen Bahnabstand (stepover) angeben</translation>
    </message>
    <message>
        <source>a section has finite points that are not left of the axis</source>
        <translation>die Punkte eines Querschnitts müssen endlich sein und dürfen nicht links der Achse liegen</translation>
    </message>
    <message>
        <source>a section needs two points at different heights</source>
        <translation>ein Querschnitt braucht zwei Punkte in verschiedener Höhe</translation>
    </message>
    <message>
        <source>a set-up needs a [stock]</source>
        <translation>eine Aufspannung braucht ein [stock]</translation>
    </message>
    <message>
        <source>a slice is missing between {0} and {1}</source>
        <translation>zwischen {0} und {1} fehlt ein Schichtbild</translation>
    </message>
    <message>
        <source>a solid that was made in memory has no text: save it as a file, and open that</source>
        <translation>ein im Speicher erzeugter Körper hat keinen Text: als Datei speichern und diese öffnen</translation>
    </message>
    <message>
        <source>a speed above 0, in cm/s</source>
        <translation>eine Geschwindigkeit über 0, in cm/s</translation>
    </message>
    <message>
        <source>a speed above 0, in mm/s</source>
        <translation>eine Geschwindigkeit über 0, in mm/s</translation>
    </message>
    <message>
        <source>a spline moves X and Y only</source>
        <translation>ein Spline bewegt nur X und Y</translation>
    </message>
    <message>
        <source>a subroutine cannot be defined within another one</source>
        <translation>ein Unterprogramm kann nicht innerhalb eines anderen definiert werden</translation>
    </message>
    <message>
        <source>a thread needs its pitch</source>
        <translation>ein Gewinde braucht eine Steigung</translation>
    </message>
    <message>
        <source>a thread of {0} mm needs a smaller hole than that of {1} mm</source>
        <translation>ein Gewinde von {0} mm braucht eine kleinere Bohrung als die von {1} mm</translation>
    </message>
    <message>
        <source>a tick of {0} mm</source>
        <translation>unzulässiger Schritt von {0} mm</translation>
    </message>
    <message>
        <source>a tool has no path</source>
        <translation>ein Werkzeug hat keinen Pfad</translation>
    </message>
    <message>
        <source>a triangle</source>
        <translation>ein Dreieck</translation>
    </message>
    <message>
        <source>a unit of {0} mm</source>
        <translation>unzulässige Einheit von {0} mm</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>ein Wert</translation>
    </message>
    <message>
        <source>a value is missing</source>
        <translation>ein Wert fehlt</translation>
    </message>
    <message>
        <source>a vertex</source>
        <translation>einen Eckpunkt</translation>
    </message>
    <message>
        <source>a vertex is not a finite number</source>
        <translation>ein Eckpunkt ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>a vertex is not at a finite place</source>
        <translation>ein Eckpunkt liegt nicht an einer endlichen Stelle</translation>
    </message>
    <message>
        <source>a {0} needs a corner_radius of at most its radius</source>
        <translation>{0}: corner_radius muss über 0 liegen und darf den Werkzeugradius nicht überschreiten</translation>
    </message>
    <message>
        <source>a {0} tool needs an angle between 0 and 180 degrees</source>
        <translation>ein Werkzeug der Form {0} braucht einen Winkel zwischen 0 und 180 Grad</translation>
    </message>
    <message>
        <source>above</source>
        <translation>größer als</translation>
    </message>
    <message>
        <source>an [[operation]] needs a type</source>
        <translation>eine [[operation]] braucht einen type</translation>
    </message>
    <message>
        <source>an arc in a plane that the rotation in force does not keep: given as short straight feeds</source>
        <translation>Bogen in einer Ebene, die bei der aktiven Drehung nicht erhalten bleibt: durch kurze gerade Vorschubbewegungen ersetzt</translation>
    </message>
    <message>
        <source>an arc of {0} degrees</source>
        <translation>unzulässiger Bogen von {0} Grad</translation>
    </message>
    <message>
        <source>an arc repeated from a height below it</source>
        <translation>Bogen, der von einer Höhe unter ihm aus wiederholt wird</translation>
    </message>
    <message>
        <source>an arc whose radius is not more than the tool's</source>
        <translation>Bogen, dessen Radius nicht größer als der des Werkzeugs ist</translation>
    </message>
    <message>
        <source>an arc with P{0}: turns are 1 or more</source>
        <translation>Bogen mit P{0}: mindestens 1 Umdrehung ist nötig</translation>
    </message>
    <message>
        <source>an arc with R and a centre</source>
        <translation>Bogen mit R und Mittelpunkt</translation>
    </message>
    <message>
        <source>an arc with R and no place to end in its plane</source>
        <translation>Bogen mit R ohne Endpunkt in seiner Ebene</translation>
    </message>
    <message>
        <source>an arc with R that ends where it begins</source>
        <translation>Bogen mit R, der dort endet, wo er beginnt</translation>
    </message>
    <message>
        <source>an arc with a radius of 0</source>
        <translation>Bogen mit Radius 0</translation>
    </message>
    <message>
        <source>an arc without R and without its centre's offsets</source>
        <translation>Bogen ohne R und ohne Mittelpunktabstände</translation>
    </message>
    <message>
        <source>an axis</source>
        <translation>eine Achse</translation>
    </message>
    <message>
        <source>an axis has a letter, a direction [x, y, z] and limits [from, to] in degrees</source>
        <translation>eine Achse hat einen Buchstaben, eine Richtung [x, y, z] und Grenzen [von, bis] in Grad</translation>
    </message>
    <message>
        <source>an edge belongs to more than two triangles, or to two of opposite orientation</source>
        <translation>eine Kante gehört zu mehr als zwei Dreiecken oder zu zweien mit entgegengesetztem Umlaufsinn</translation>
    </message>
    <message>
        <source>an image must have pixels</source>
        <translation>ein Bild muss Pixel haben</translation>
    </message>
    <message>
        <source>an impossible picture of {0} x {1} pixels</source>
        <translation>ein unmögliches Bild von {0} x {1} Pixeln</translation>
    </message>
    <message>
        <source>an impossible size</source>
        <translation>eine unmögliche Größe</translation>
    </message>
    <message>
        <source>an inner corner that the tool cannot reach without gouging</source>
        <translation>Innenecke, die das Werkzeug nicht ohne Konturverletzung erreicht</translation>
    </message>
    <message>
        <source>an input is a model or an image, not both</source>
        <translation>input ist ein Modell oder ein Bild, nicht beides</translation>
    </message>
    <message>
        <source>an input needs a model, or models, or an image</source>
        <translation>input braucht model, models oder image</translation>
    </message>
    <message>
        <source>an instruction with more than a million numbers</source>
        <translation>Anweisung mit mehr als einer Million Zahlen</translation>
    </message>
    <message>
        <source>an item</source>
        <translation>ein Element 'item'</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>an operator</source>
        <translation>ein Operator</translation>
    </message>
    <message>
        <source>an unknown kind of cell</source>
        <translation>eine unbekannte Art von Zelle</translation>
    </message>
    <message>
        <source>another coordinate system</source>
        <translation>Wechsel des Koordinatensystems</translation>
    </message>
    <message>
        <source>another coordinate system while G68 is in force</source>
        <translation>Wechsel des Koordinatensystems bei aktivem G68</translation>
    </message>
    <message>
        <source>anticlockwise</source>
        <translation>gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>argument</source>
        <translation>Argument</translation>
    </message>
    <message>
        <source>arguments</source>
        <translation>Argumente</translation>
    </message>
    <message>
        <source>as a math string this expression would be larger than 64 MB, since shared parts are repeated; write .vm or .frep</source>
        <translation>als Formel in Präfixschreibweise wäre dieser Ausdruck größer als 64 MB, weil gemeinsame Teile wiederholt werden; als .vm oder .frep schreiben</translation>
    </message>
    <message>
        <source>at least</source>
        <translation>mindestens</translation>
    </message>
    <message>
        <source>at least 2 planes a half turn</source>
        <translation>mindestens 2 Ebenen je halbe Umdrehung</translation>
    </message>
    <message>
        <source>at {0} places something thinner than {1} mm may stand, for example at x {2}, y {3} up to z {4}: the tool stays above it</source>
        <translation>an {0} Stellen steht möglicherweise etwas, das dünner als {1} mm ist, zum Beispiel bei x {2}, y {3} bis z {4}: das Werkzeug bleibt darüber</translation>
    </message>
    <message>
        <source>axis words, but no G code in force that uses them</source>
        <translation>Achswörter, aber kein aktiver G-Code, der sie verwendet</translation>
    </message>
    <message>
        <source>beam lattices</source>
        <translation>Stabgitter</translation>
    </message>
    <message>
        <source>begins above the lowest place of the mesh</source>
        <translation>beginnt über der tiefsten Stelle des Netzes</translation>
    </message>
    <message>
        <source>begins with an arc</source>
        <translation>beginnt mit einem Bogen</translation>
    </message>
    <message>
        <source>begins with the element '{0}' instead of 'model'</source>
        <translation>beginnt mit dem Element '{0}' statt mit 'model'</translation>
    </message>
    <message>
        <source>bounds are x0, y0, z0, x1, y1, z1</source>
        <translation>bounds sind x0, y0, z0, x1, y1, z1</translation>
    </message>
    <message>
        <source>building the distance field</source>
        <translation>Abstandsfeld wird aufgebaut</translation>
    </message>
    <message>
        <source>bull-nose tool</source>
        <translation>Torusfräser</translation>
    </message>
    <message>
        <source>bytes follow its directory</source>
        <translation>nach dem Verzeichnis folgen weitere Bytes</translation>
    </message>
    <message>
        <source>bytes follow the last cell</source>
        <translation>nach der letzten Zelle folgen weitere Bytes</translation>
    </message>
    <message>
        <source>cannot be compressed</source>
        <translation>kann nicht komprimiert werden</translation>
    </message>
    <message>
        <source>cannot be made: {0}</source>
        <translation>kann nicht angelegt werden: {0}</translation>
    </message>
    <message>
        <source>cannot be read: {0}</source>
        <translation>kann nicht gelesen werden: {0}</translation>
    </message>
    <message>
        <source>cannot begin to deflate</source>
        <translation>die Komprimierung lässt sich nicht beginnen</translation>
    </message>
    <message>
        <source>cannot begin to read PNG</source>
        <translation>das Lesen von PNG lässt sich nicht beginnen</translation>
    </message>
    <message>
        <source>cannot deflate</source>
        <translation>die Komprimierung ist fehlgeschlagen</translation>
    </message>
    <message>
        <source>cannot make a parser</source>
        <translation>ein Parser lässt sich nicht anlegen</translation>
    </message>
    <message>
        <source>cannot map: {0}</source>
        <translation>kann nicht in den Speicher abgebildet werden: {0}</translation>
    </message>
    <message>
        <source>cannot read: {0}</source>
        <translation>kann nicht gelesen werden: {0}</translation>
    </message>
    <message>
        <source>cannot write a mesh as '{0}'; known are .stl .ply .off .obj .3mf .glb</source>
        <translation>ein Netz kann nicht als '{0}' geschrieben werden; bekannt sind .stl .ply .off .obj .3mf .glb</translation>
    </message>
    <message>
        <source>cannot write: is a folder</source>
        <translation>kann nicht geschrieben werden: ist ein Ordner</translation>
    </message>
    <message>
        <source>cannot write: not all of it is there when it is read again</source>
        <translation>kann nicht geschrieben werden: beim erneuten Lesen fehlt ein Teil</translation>
    </message>
    <message>
        <source>cannot {0}: {1}</source>
        <translation>{0} nicht möglich: {1}</translation>
    </message>
    <message>
        <source>cell and tolerance must be above 0</source>
        <translation>cell und tolerance müssen über 0 liegen</translation>
    </message>
    <message>
        <source>cell must be above 0</source>
        <translation>cell muss über 0 liegen</translation>
    </message>
    <message>
        <source>cells are from 4 to 256, levels from 0 to 20, the angle above 0</source>
        <translation>möglich sind 4 bis 256 Zellen, 0 bis 20 Stufen und ein Winkel über 0</translation>
    </message>
    <message>
        <source>centre must be [x, y, z]</source>
        <translation>centre muss [x, y, z] sein</translation>
    </message>
    <message>
        <source>checking against OpenVDB</source>
        <translation>Vergleich mit OpenVDB</translation>
    </message>
    <message>
        <source>checking the distance field</source>
        <translation>Abstandsfeld wird geprüft</translation>
    </message>
    <message>
        <source>checking the mesh with CGAL</source>
        <translation>Netz wird mit CGAL geprüft</translation>
    </message>
    <message>
        <source>clockwise</source>
        <translation>im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>closing holes</source>
        <translation>Löcher werden geschlossen</translation>
    </message>
    <message>
        <source>colours and materials</source>
        <translation>Farben und Materialien</translation>
    </message>
    <message>
        <source>colours in planes of their own are not read</source>
        <translation>Farben in getrennten Ebenen werden nicht gelesen</translation>
    </message>
    <message>
        <source>coordinates is '{0}'; it must be one of program, model{1}</source>
        <translation>coordinates ist '{0}'; möglich sind program, model{1}</translation>
    </message>
    <message>
        <source>cutter compensation in G18 with a rotated coordinate system</source>
        <translation>Fräserradiuskorrektur in G18 bei gedrehtem Koordinatensystem</translation>
    </message>
    <message>
        <source>cutter compensation is of the planes G17 and G18</source>
        <translation>Fräserradiuskorrektur gibt es nur in den Ebenen G17 und G18</translation>
    </message>
    <message>
        <source>cylinder is [x, y, radius, z from, z to]</source>
        <translation>cylinder ist [x, y, Radius, z von, z bis]</translation>
    </message>
    <message>
        <source>deep cuts</source>
        <translation>tiefe Schnitte</translation>
    </message>
    <message>
        <source>direction must not be zero</source>
        <translation>direction darf nicht null sein</translation>
    </message>
    <message>
        <source>divides the region into more than 2^24 cells a side</source>
        <translation>teilt den Bereich in mehr als 2^24 Zellen je Seite</translation>
    </message>
    <message>
        <source>division by zero</source>
        <translation>Division durch null</translation>
    </message>
    <message>
        <source>does not begin with OFF</source>
        <translation>beginnt nicht mit OFF</translation>
    </message>
    <message>
        <source>does not begin with ply</source>
        <translation>beginnt nicht mit ply</translation>
    </message>
    <message>
        <source>does not tell its size: give --dims X,Y,Z, or a name such as scan_256x256x128_uint16.raw</source>
        <translation>nennt die Größe nicht: --dims X,Y,Z angeben oder einen Namen wie scan_256x256x128_uint16.raw</translation>
    </message>
    <message>
        <source>does not tell the size of its part '{0}'</source>
        <translation>nennt die Größe des Teils '{0}' nicht</translation>
    </message>
    <message>
        <source>does not tell the volume's size: no line such as 'size = 255 255 511'</source>
        <translation>nennt die Größe des Volumens nicht: es fehlt eine Zeile wie 'size = 255 255 511'</translation>
    </message>
    <message>
        <source>does not tell where its samples are (ElementDataFile)</source>
        <translation>nennt den Ort der Messwerte nicht (ElementDataFile)</translation>
    </message>
    <message>
        <source>each control point needs both X and Y</source>
        <translation>jeder Kontrollpunkt braucht X und Y</translation>
    </message>
    <message>
        <source>each control point needs its weight P, above 0</source>
        <translation>jeder Kontrollpunkt braucht sein Gewicht P, über 0</translation>
    </message>
    <message>
        <source>elements of '{0}'</source>
        <translation>Elemente von '{0}'</translation>
    </message>
    <message>
        <source>ends too early</source>
        <translation>endet zu früh</translation>
    </message>
    <message>
        <source>every density is {0}: there is no surface</source>
        <translation>alle Dichten sind {0}: es gibt keine Oberfläche</translation>
    </message>
    <message>
        <source>expected a number, found '{0}'</source>
        <translation>erwartet: eine Zahl, gefunden: '{0}'</translation>
    </message>
    <message>
        <source>expected a number, found {0}</source>
        <translation>erwartet: eine Zahl, gefunden: {0}</translation>
    </message>
    <message>
        <source>expected a whole number below 2^31, found '{0}'</source>
        <translation>erwartet: eine ganze Zahl unter 2^31, gefunden: '{0}'</translation>
    </message>
    <message>
        <source>expected a whole number of bytes</source>
        <translation>erwartet: eine ganze Zahl von Bytes</translation>
    </message>
    <message>
        <source>expected an operation after the name {0}</source>
        <translation>nach dem Namen {0} wird eine Operation erwartet</translation>
    </message>
    <message>
        <source>expected little or big, found '{0}'</source>
        <translation>erwartet: little oder big, gefunden: '{0}'</translation>
    </message>
    <message>
        <source>expected open("FILE", NAME = VALUE, ...)</source>
        <translation>erwartet: open("FILE", NAME = VALUE, ...)</translation>
    </message>
    <message>
        <source>expected part(SHAPE, "NAME", "COLOUR")</source>
        <translation>erwartet: part(SHAPE, "NAME", "COLOUR")</translation>
    </message>
    <message>
        <source>expected the twelve numbers of a transform, found '{0}'</source>
        <translation>erwartet: die zwölf Zahlen einer Transformation, gefunden: '{0}'</translation>
    </message>
    <message>
        <source>expected {0} numbers apart by commas, found '{1}'</source>
        <translation>erwartet: {0} durch Kommas getrennte Zahlen, gefunden: '{1}'</translation>
    </message>
    <message>
        <source>expected {0}, found {1}</source>
        <translation>erwartet: {0}, gefunden: {1}</translation>
    </message>
    <message>
        <source>facing needs a tool with a diameter, and a stepover above 0</source>
        <translation>Planfräsen braucht ein Werkzeug mit Durchmesser und einen Bahnabstand über 0</translation>
    </message>
    <message>
        <source>feed is {0}; {1} goes no faster than {2} mm/min</source>
        <translation>feed ist {0}; {1} fährt höchstens {2} mm/min</translation>
    </message>
    <message>
        <source>fewer bricks than its box</source>
        <translation>weniger Teilquader als im Quader</translation>
    </message>
    <message>
        <source>files cannot be opened from this text</source>
        <translation>aus diesem Text lassen sich keine Dateien öffnen</translation>
    </message>
    <message>
        <source>files open each other more than {0} deep</source>
        <translation>Dateien öffnen einander mehr als {0} Ebenen tief</translation>
    </message>
    <message>
        <source>filling cells</source>
        <translation>Zellen werden gefüllt</translation>
    </message>
    <message>
        <source>finding the bounds</source>
        <translation>Grenzen werden gesucht</translation>
    </message>
    <message>
        <source>frame {0} of {1}</source>
        <translation>Einzelbild {0} von {1}</translation>
    </message>
    <message>
        <source>functions call each other more than {0} deep</source>
        <translation>Funktionsaufrufe sind mehr als {0} Ebenen tief verschachtelt</translation>
    </message>
    <message>
        <source>give a depth, or a stock with a thickness</source>
        <translation>eine Tiefe angeben oder ein Rohteil mit einer Dicke</translation>
    </message>
    <message>
        <source>going to another moment</source>
        <translation>anderer Zeitpunkt wird berechnet</translation>
    </message>
    <message>
        <source>has '[' without ']'</source>
        <translation>hat '[' ohne ']'</translation>
    </message>
    <message>
        <source>has '{{' without '}}'</source>
        <translation>hat '{{' ohne '}}'</translation>
    </message>
    <message>
        <source>has a document type declaration, which is not allowed in .3mf files</source>
        <translation>enthält eine Dokumenttyp-Deklaration, die in .3mf-Dateien nicht erlaubt ist</translation>
    </message>
    <message>
        <source>has a letter that only strings and comments may have</source>
        <translation>enthält ein Zeichen, das nur in Zeichenketten und Kommentaren stehen darf</translation>
    </message>
    <message>
        <source>has a property of unknown type '{0}'</source>
        <translation>enthält eine Eigenschaft vom unbekannten Typ '{0}'</translation>
    </message>
    <message>
        <source>has a tag or a comment longer than 1 MiB</source>
        <translation>enthält ein Tag oder einen Kommentar von mehr als 1 MiB</translation>
    </message>
    <message>
        <source>has a transform of more than twelve numbers</source>
        <translation>enthält eine Transformation mit mehr als zwölf Zahlen</translation>
    </message>
    <message>
        <source>has a transform that flattens object {0}</source>
        <translation>enthält eine Transformation, die Objekt {0} flach drückt</translation>
    </message>
    <message>
        <source>has a triangle of vertices {0}, {1} and {2} in an object of {3} vertices</source>
        <translation>enthält ein Dreieck aus den Eckpunkten {0}, {1} und {2} in einem Objekt mit {3} Eckpunkten</translation>
    </message>
    <message>
        <source>has an object of type '{0}'; known are model, solidsupport, support, surface and other</source>
        <translation>enthält ein Objekt vom Typ '{0}'; bekannt sind model, solidsupport, support, surface und other</translation>
    </message>
    <message>
        <source>has an object {0} that is a component of itself</source>
        <translation>enthält ein Objekt {0}, das Komponente seiner selbst ist</translation>
    </message>
    <message>
        <source>has become shorter while it was read</source>
        <translation>wurde während des Lesens kürzer</translation>
    </message>
    <message>
        <source>has changed</source>
        <translation>hat sich geändert</translation>
    </message>
    <message>
        <source>has different units along its axes</source>
        <translation>hat verschiedene Einheiten entlang der Achsen</translation>
    </message>
    <message>
        <source>has more than 256 MiB of names</source>
        <translation>enthält mehr als 256 MiB an Namen</translation>
    </message>
    <message>
        <source>has more than 2^20 objects and groups of materials</source>
        <translation>enthält mehr als 2^20 Objekte und Materialgruppen</translation>
    </message>
    <message>
        <source>has more than 2^22 components and items</source>
        <translation>enthält mehr als 2^22 Komponenten und Elemente 'item'</translation>
    </message>
    <message>
        <source>has more than 2^27 cells</source>
        <translation>hat mehr als 2^27 Zellen</translation>
    </message>
    <message>
        <source>has more than {0} elements within each other</source>
        <translation>enthält mehr als {0} ineinander verschachtelte Elemente</translation>
    </message>
    <message>
        <source>has no level {0}; there are 0 to {1}</source>
        <translation>hat keine Stufe {0}; es gibt 0 bis {1}</translation>
    </message>
    <message>
        <source>has no part '{0}'</source>
        <translation>enthält kein Teil '{0}'</translation>
    </message>
    <message>
        <source>has no tools</source>
        <translation>hat keine Werkzeuge</translation>
    </message>
    <message>
        <source>has no triangle with an area</source>
        <translation>hat kein Dreieck mit einer Fläche über 0</translation>
    </message>
    <message>
        <source>has no triangles</source>
        <translation>hat keine Dreiecke</translation>
    </message>
    <message>
        <source>has no workpiece</source>
        <translation>hat kein Werkstück</translation>
    </message>
    <message>
        <source>has nothing to show</source>
        <translation>enthält nichts Sichtbares</translation>
    </message>
    <message>
        <source>has one level only</source>
        <translation>hat nur eine Stufe</translation>
    </message>
    <message>
        <source>has several slices at one place: choose between them with --series, or put one set in a folder of its own</source>
        <translation>enthält mehrere Schichtbilder an einer Stelle: mit --series auswählen oder einen Satz in einen eigenen Ordner legen</translation>
    </message>
    <message>
        <source>has the unit '{0}'; known are micron, millimeter, centimeter, inch, foot and meter</source>
        <translation>hat die Einheit '{0}'; bekannt sind micron, millimeter, centimeter, inch, foot und meter</translation>
    </message>
    <message>
        <source>has the unit '{0}'; known are mm, um, nm, cm, m and in</source>
        <translation>hat die Einheit '{0}'; bekannt sind mm, um, nm, cm, m und in</translation>
    </message>
    <message>
        <source>has two objects with the id {0}</source>
        <translation>enthält zwei Objekte mit der id {0}</translation>
    </message>
    <message>
        <source>has {0} without '{1}'</source>
        <translation>enthält {0} ohne '{1}'</translation>
    </message>
    <message>
        <source>height and weight must be above 0 mm</source>
        <translation>height und weight müssen über 0 mm liegen</translation>
    </message>
    <message>
        <source>holds a file that GDCM, which reads DICOM, gives up at</source>
        <translation>enthält eine Datei, an der GDCM beim Lesen von DICOM scheitert</translation>
    </message>
    <message>
        <source>holds a grid that is not linear</source>
        <translation>enthält ein nichtlineares Gitter</translation>
    </message>
    <message>
        <source>holds a grid with an impossible transform</source>
        <translation>enthält ein Gitter mit unmöglicher Transformation</translation>
    </message>
    <message>
        <source>holds a grid without samples</source>
        <translation>enthält ein Gitter ohne Messwerte</translation>
    </message>
    <message>
        <source>holds another number of samples than it tells</source>
        <translation>enthält eine andere Zahl von Messwerten als angegeben</translation>
    </message>
    <message>
        <source>holds both TIFF and PNG files; slices of one kind are wanted</source>
        <translation>enthält TIFF- und PNG-Dateien; verlangt sind Schichtbilder einer Art</translation>
    </message>
    <message>
        <source>holds more than one slice, where each file should be one</source>
        <translation>enthält mehr als ein Schichtbild; jede Datei sollte eines sein</translation>
    </message>
    <message>
        <source>holds neither TIFF nor PNG slices nor a DICOM series</source>
        <translation>enthält weder TIFF- noch PNG-Schichtbilder noch eine DICOM-Serie</translation>
    </message>
    <message>
        <source>holds no DICOM series</source>
        <translation>enthält keine DICOM-Serie</translation>
    </message>
    <message>
        <source>holds no grid of 32-bit real numbers</source>
        <translation>enthält kein Gitter aus 32-Bit-Gleitkommazahlen</translation>
    </message>
    <message>
        <source>holds no series '{0}'</source>
        <translation>enthält keine Serie '{0}'</translation>
    </message>
    <message>
        <source>holds no triangles</source>
        <translation>enthält keine Dreiecke</translation>
    </message>
    <message>
        <source>holds {0} bytes; {1} x {2} x {3} samples of {4} after a header of {5} bytes are {6}</source>
        <translation>enthält {0} Byte; {1} x {2} x {3} Messwerte vom Typ {4} nach einem Dateikopf von {5} Byte ergeben {6}</translation>
    </message>
    <message>
        <source>holds {0} pictures, where each file should be one</source>
        <translation>enthält {0} Bilder; jede Datei sollte eines sein</translation>
    </message>
    <message>
        <source>holds {0} series; choose one with --series</source>
        <translation>enthält {0} Serien; eine mit --series auswählen</translation>
    </message>
    <message>
        <source>how far the tool moves aside or where it ends</source>
        <translation>den seitlichen Versatz oder die Endhöhe</translation>
    </message>
    <message>
        <source>importing the volume</source>
        <translation>Volumen wird importiert</translation>
    </message>
    <message>
        <source>is '{0}'; it must be one of {1}{2}</source>
        <translation>ist '{0}'; möglich sind {1}{2}</translation>
    </message>
    <message>
        <source>is PLY of the form '{0}', which is not read</source>
        <translation>ist PLY in der Form '{0}', die nicht gelesen wird</translation>
    </message>
    <message>
        <source>is a NIfTI-2 file; NIfTI-1 is read</source>
        <translation>ist eine NIfTI-2-Datei; gelesen wird NIfTI-1</translation>
    </message>
    <message>
        <source>is a damaged PNG: it ends within a chunk</source>
        <translation>ist eine beschädigte PNG-Datei: sie endet mitten in einem Block</translation>
    </message>
    <message>
        <source>is a number, not words in quotes</source>
        <translation>ist eine Zahl, kein Text in Anführungszeichen</translation>
    </message>
    <message>
        <source>is a part of another volume's import</source>
        <translation>gehört zum Import eines anderen Volumens</translation>
    </message>
    <message>
        <source>is a script; scripts are run by the fieldfab command only, by their names</source>
        <translation>ist ein Skript; Skripte führt nur der Befehl fieldfab aus, wenn ihr Name angegeben ist</translation>
    </message>
    <message>
        <source>is a slice in another direction than the first of its series</source>
        <translation>ist ein Schichtbild in anderer Richtung als das erste der Serie</translation>
    </message>
    <message>
        <source>is cut off after {0} bytes</source>
        <translation>bricht nach {0} Byte ab</translation>
    </message>
    <message>
        <source>is damaged or cut off</source>
        <translation>ist beschädigt oder unvollständig</translation>
    </message>
    <message>
        <source>is damaged or no .asdf file: a block cannot be decompressed</source>
        <translation>ist beschädigt oder keine .asdf-Datei: ein Block lässt sich nicht entpacken</translation>
    </message>
    <message>
        <source>is damaged or no .asdf file: a block's cells do not make a tree</source>
        <translation>ist beschädigt oder keine .asdf-Datei: die Zellen eines Blocks ergeben keinen Baum</translation>
    </message>
    <message>
        <source>is damaged or no .asdf file: {0}</source>
        <translation>ist beschädigt oder keine .asdf-Datei: {0}</translation>
    </message>
    <message>
        <source>is damaged or no saved stock: {0}</source>
        <translation>ist beschädigt oder kein gespeichertes Rohteil: {0}</translation>
    </message>
    <message>
        <source>is damaged: {0}, which reads it, gives up at it</source>
        <translation>ist beschädigt: {0} scheitert beim Lesen</translation>
    </message>
    <message>
        <source>is larger than {0} bytes</source>
        <translation>ist größer als {0} Byte</translation>
    </message>
    <message>
        <source>is no .vdb file, or a damaged one, or of a later version</source>
        <translation>ist keine .vdb-Datei, beschädigt oder von einer neueren Version</translation>
    </message>
    <message>
        <source>is no NIfTI file, or a damaged one</source>
        <translation>ist keine NIfTI-Datei oder beschädigt</translation>
    </message>
    <message>
        <source>is no PNG file, or a damaged one</source>
        <translation>ist keine PNG-Datei oder beschädigt</translation>
    </message>
    <message>
        <source>is no TIFF file, or a damaged one</source>
        <translation>ist keine TIFF-Datei oder beschädigt</translation>
    </message>
    <message>
        <source>is no project of CAMotics: JSON is wanted</source>
        <translation>ist kein CAMotics-Projekt: JSON wird erwartet</translation>
    </message>
    <message>
        <source>is no tool library: a JSON object is wanted</source>
        <translation>ist keine Werkzeugbibliothek: erwartet wird ein JSON-Objekt</translation>
    </message>
    <message>
        <source>is no tool library: known are FreeCAD's .fctb and .fctl, and Fusion's .json</source>
        <translation>ist keine Werkzeugbibliothek: bekannt sind .fctb und .fctl von FreeCAD und .json von Fusion</translation>
    </message>
    <message>
        <source>is no {0} file, or a damaged one: {1}</source>
        <translation>ist keine {0}-Datei oder beschädigt: {1}</translation>
    </message>
    <message>
        <source>is not a PNG</source>
        <translation>ist keine PNG-Datei</translation>
    </message>
    <message>
        <source>is not a mesh file; known are .stl .ply .off .obj .3mf</source>
        <translation>ist keine Netzdatei; bekannt sind .stl .ply .off .obj .3mf</translation>
    </message>
    <message>
        <source>is not a zip archive, which .3mf files are: {0}</source>
        <translation>ist kein Zip-Archiv, wie .3mf-Dateien es sind: {0}</translation>
    </message>
    <message>
        <source>is not an STL file: its size does not fit its count of triangles</source>
        <translation>ist keine STL-Datei: die Größe passt nicht zur Zahl der Dreiecke</translation>
    </message>
    <message>
        <source>is not closed</source>
        <translation>ist nicht geschlossen</translation>
    </message>
    <message>
        <source>is not part {0} of {1} of an import</source>
        <translation>ist nicht Teil {0} von {1} eines Imports</translation>
    </message>
    <message>
        <source>is of version {0} of saved stocks; known is version {1}</source>
        <translation>ist von Version {0} gespeicherter Rohteile; bekannt ist Version {1}</translation>
    </message>
    <message>
        <source>is written, not read; known are {0}</source>
        <translation>wird nur geschrieben, nicht gelesen; bekannt sind {0}</translation>
    </message>
    <message>
        <source>is written, not read; meshes are read from .stl .ply .off .obj .3mf</source>
        <translation>wird nur geschrieben, nicht gelesen; Netze werden aus .stl .ply .off .obj .3mf gelesen</translation>
    </message>
    <message>
        <source>is {0}; it must be a whole number</source>
        <translation>ist {0}, muss aber eine ganze Zahl sein</translation>
    </message>
    <message>
        <source>is {0}; it must be at most {1}{2}</source>
        <translation>ist {0}, darf aber höchstens {1}{2} sein</translation>
    </message>
    <message>
        <source>is {0}; it must be {1} {2}{3}</source>
        <translation>ist {0}; muss {1} {2}{3} sein</translation>
    </message>
    <message>
        <source>it cannot be unpacked</source>
        <translation>lässt sich nicht entpacken</translation>
    </message>
    <message>
        <source>it cuts while the spindle stands</source>
        <translation>schneidet bei stehender Spindel</translation>
    </message>
    <message>
        <source>it cuts {0} mm into the target at ({1}, {2}, {3})</source>
        <translation>schneidet {0} mm in das Ziel bei ({1}, {2}, {3})</translation>
    </message>
    <message>
        <source>it does not begin as one</source>
        <translation>der Anfang passt nicht dazu</translation>
    </message>
    <message>
        <source>it ends too early</source>
        <translation>endet zu früh</translation>
    </message>
    <message>
        <source>it has no such piece</source>
        <translation>hat kein solches Stück</translation>
    </message>
    <message>
        <source>it has {0} that cannot be</source>
        <translation>unmögliche Angabe: {0}</translation>
    </message>
    <message>
        <source>it moves {0}, an axis that {1} does not have</source>
        <translation>hier bewegt sich {0}, eine Achse, die {1} nicht hat</translation>
    </message>
    <message>
        <source>its box is empty</source>
        <translation>der Quader ist leer</translation>
    </message>
    <message>
        <source>its cells do not make a tree</source>
        <translation>die Zellen ergeben keinen Baum</translation>
    </message>
    <message>
        <source>its checksum is wrong</source>
        <translation>die Prüfsumme ist falsch</translation>
    </message>
    <message>
        <source>its components and items would make more than {0} triangles or vertices</source>
        <translation>seine Komponenten und Elemente 'item' ergäben mehr als {0} Dreiecke oder Eckpunkte</translation>
    </message>
    <message>
        <source>its directory cannot be decompressed</source>
        <translation>das Verzeichnis lässt sich nicht entpacken</translation>
    </message>
    <message>
        <source>its directory ends too early</source>
        <translation>das Verzeichnis endet zu früh</translation>
    </message>
    <message>
        <source>its directory holds more than its tree</source>
        <translation>das Verzeichnis enthält mehr als den Baum</translation>
    </message>
    <message>
        <source>its directory is not in it</source>
        <translation>das Verzeichnis liegt nicht in der Datei</translation>
    </message>
    <message>
        <source>its faces are not the surface of a solid</source>
        <translation>seine Flächen bilden nicht die Oberfläche eines Körpers</translation>
    </message>
    <message>
        <source>its faces could not be joined</source>
        <translation>seine Flächen ließen sich nicht verknüpfen</translation>
    </message>
    <message>
        <source>its header has no end</source>
        <translation>der Dateikopf hat kein Ende</translation>
    </message>
    <message>
        <source>its header is not possible</source>
        <translation>der Dateikopf ist unmöglich</translation>
    </message>
    <message>
        <source>its lattice does not fit its region</source>
        <translation>das Raster passt nicht zum Bereich</translation>
    </message>
    <message>
        <source>its lattice is not possible</source>
        <translation>das Raster ist unmöglich</translation>
    </message>
    <message>
        <source>its part '{0}' cannot be read: {1}</source>
        <translation>das Teil '{0}' kann nicht gelesen werden: {1}</translation>
    </message>
    <message>
        <source>its part '{0}' is damaged: it is longer than it says</source>
        <translation>das Teil '{0}' ist beschädigt: es ist länger als angegeben</translation>
    </message>
    <message>
        <source>its part '{0}' is damaged: {1}</source>
        <translation>das Teil '{0}' ist beschädigt: {1}</translation>
    </message>
    <message>
        <source>its part '{0}' is encrypted</source>
        <translation>das Teil '{0}' ist verschlüsselt</translation>
    </message>
    <message>
        <source>its region is not finite</source>
        <translation>der Bereich ist nicht endlich</translation>
    </message>
    <message>
        <source>its region or scale is not a number</source>
        <translation>der Bereich oder der Maßstab ist keine Zahl</translation>
    </message>
    <message>
        <source>its samples span {0} x {1} x {2}, too many for a file of its size</source>
        <translation>die Messpunkte umfassen {0} x {1} x {2}, zu viele für eine Datei dieser Größe</translation>
    </message>
    <message>
        <source>its size is wrong</source>
        <translation>die Größe ist falsch</translation>
    </message>
    <message>
        <source>its surface crosses or touches itself</source>
        <translation>seine Oberfläche schneidet oder berührt sich selbst</translation>
    </message>
    <message>
        <source>its surface has holes</source>
        <translation>seine Oberfläche hat Löcher</translation>
    </message>
    <message>
        <source>joining solids</source>
        <translation>Körper werden verknüpft</translation>
    </message>
    <message>
        <source>knows no form '{0}'; there are i, d4, u8 and u16</source>
        <translation>kennt keine Form '{0}'; es gibt i, d4, u8 und u16</translation>
    </message>
    <message>
        <source>lacks</source>
        <translation>fehlen</translation>
    </message>
    <message>
        <source>least must be above 0 and at most 1</source>
        <translation>least muss über 0 liegen und darf höchstens 1 sein</translation>
    </message>
    <message>
        <source>limits are [from, to]</source>
        <translation>limits sind [von, bis]</translation>
    </message>
    <message>
        <source>line {0}</source>
        <translation>Zeile {0}</translation>
    </message>
    <message>
        <source>looking at slices</source>
        <translation>Schichtbilder werden geprüft</translation>
    </message>
    <message>
        <source>looking closer</source>
        <translation>Zellen werden verfeinert</translation>
    </message>
    <message>
        <source>looking for thin parts</source>
        <translation>dünne Teile werden gesucht</translation>
    </message>
    <message>
        <source>looking for valleys</source>
        <translation>Kehlen werden gesucht</translation>
    </message>
    <message>
        <source>macros (IF, WHILE, GOTO) are not carried out</source>
        <translation>Makros (IF, WHILE, GOTO) werden nicht ausgeführt</translation>
    </message>
    <message>
        <source>may lack</source>
        <translation>fehlen möglicherweise</translation>
    </message>
    <message>
        <source>measuring the solid</source>
        <translation>Körper wird vermessen</translation>
    </message>
    <message>
        <source>medial axis</source>
        <translation>Mittelachse</translation>
    </message>
    <message>
        <source>mesh files hold at most 2^31 vertices and triangles</source>
        <translation>Netzdateien fassen höchstens 2^31 Eckpunkte und Dreiecke</translation>
    </message>
    <message>
        <source>milling needs finite bounds with a size along x, y and z</source>
        <translation>Fräsen braucht endliche Grenzen mit einer Ausdehnung in x, y und z</translation>
    </message>
    <message>
        <source>model</source>
        <translation>model</translation>
    </message>
    <message>
        <source>models</source>
        <translation>models</translation>
    </message>
    <message>
        <source>modes cannot be restored while cutter compensation is on</source>
        <translation>bei aktiver Fräserradiuskorrektur können modale Zustände nicht wiederhergestellt werden</translation>
    </message>
    <message>
        <source>more bricks than its box</source>
        <translation>mehr Teilquader als im Quader</translation>
    </message>
    <message>
        <source>more levels than the volume can be halved</source>
        <translation>mehr Stufen, als sich das Volumen halbieren lässt</translation>
    </message>
    <message>
        <source>more than 10 IF within each other</source>
        <translation>mehr als 10 ineinander geschachtelte IF</translation>
    </message>
    <message>
        <source>more than 100000 characters</source>
        <translation>mehr als 100000 Zeichen</translation>
    </message>
    <message>
        <source>more than 100000 pages</source>
        <translation>mehr als 100000 Seiten</translation>
    </message>
    <message>
        <source>more than 30 arguments</source>
        <translation>mehr als 30 Argumente</translation>
    </message>
    <message>
        <source>more than {0} GOSUB within each other</source>
        <translation>mehr als {0} ineinander geschachtelte GOSUB</translation>
    </message>
    <message>
        <source>more than {0} blocks: this program seems to have no end</source>
        <translation>mehr als {0} Sätze: dieses Programm scheint kein Ende zu haben</translation>
    </message>
    <message>
        <source>more than {0} brackets within brackets</source>
        <translation>mehr als {0} ineinander geschachtelte Klammern</translation>
    </message>
    <message>
        <source>more than {0} control points</source>
        <translation>mehr als {0} Kontrollpunkte</translation>
    </message>
    <message>
        <source>more than {0} loops and conditions within each other</source>
        <translation>mehr als {0} ineinander geschachtelte Schleifen und Bedingungen</translation>
    </message>
    <message>
        <source>more than {0} operations</source>
        <translation>mehr als {0} Rechenschritte</translation>
    </message>
    <message>
        <source>more than {0} parameters with names</source>
        <translation>mehr als {0} Parameter mit Namen</translation>
    </message>
    <message>
        <source>more than {0} pecks</source>
        <translation>mehr als {0} Bohrhübe</translation>
    </message>
    <message>
        <source>more than {0} subroutines within each other</source>
        <translation>mehr als {0} ineinander geschachtelte Unterprogramme</translation>
    </message>
    <message>
        <source>more than {0} variables</source>
        <translation>mehr als {0} Variablen</translation>
    </message>
    <message>
        <source>most must be from 1 to 100</source>
        <translation>most muss zwischen 1 und 100 liegen</translation>
    </message>
    <message>
        <source>must be a finite number</source>
        <translation>muss eine endliche Zahl sein</translation>
    </message>
    <message>
        <source>must be a positive number of mm</source>
        <translation>muss eine positive Zahl in mm sein</translation>
    </message>
    <message>
        <source>must be above 0</source>
        <translation>muss über 0 liegen</translation>
    </message>
    <message>
        <source>must be above 0 and at most the tool's diameter</source>
        <translation>muss über 0 liegen und darf höchstens der Durchmesser des Werkzeugs sein</translation>
    </message>
    <message>
        <source>must be above 0 and below the tool's corner radius of {0} mm</source>
        <translation>muss über 0 und unter dem Eckenradius des Werkzeugs von {0} mm liegen</translation>
    </message>
    <message>
        <source>must be above 0 mm</source>
        <translation>muss über 0 mm liegen</translation>
    </message>
    <message>
        <source>must be above the centre, at a finite place</source>
        <translation>muss an einem endlichen Ort über der Mitte liegen</translation>
    </message>
    <message>
        <source>must be finite</source>
        <translation>muss endlich sein</translation>
    </message>
    <message>
        <source>must be finite and have a positive size</source>
        <translation>muss endlich sein und eine positive Ausdehnung haben</translation>
    </message>
    <message>
        <source>must be finite to measure a solid</source>
        <translation>muss endlich sein, um einen Körper zu vermessen</translation>
    </message>
    <message>
        <source>must be from 0 to 2 radians (115 degrees)</source>
        <translation>muss zwischen 0 und 2 Radiant (115 Grad) liegen</translation>
    </message>
    <message>
        <source>must be three positive numbers of mm</source>
        <translation>verlangt sind drei positive Zahlen in mm</translation>
    </message>
    <message>
        <source>must be {0}, not {1}</source>
        <translation>muss {0} sein, nicht {1}</translation>
    </message>
    <message>
        <source>must have two points along each axis or more, and a spacing and reach above 0</source>
        <translation>muss entlang jeder Achse mindestens zwei Punkte haben, und Abstand und Reichweite müssen über 0 liegen</translation>
    </message>
    <message>
        <source>names no 3D model in _rels/.rels</source>
        <translation>nennt kein 3D-Modell in _rels/.rels</translation>
    </message>
    <message>
        <source>names of components</source>
        <translation>Namen von Komponenten</translation>
    </message>
    <message>
        <source>names of objects</source>
        <translation>Namen von Objekten</translation>
    </message>
    <message>
        <source>needs a V with an angle between 0 and 180 degrees</source>
        <translation>braucht einen V-Fräser mit einem Winkel zwischen 0 und 180 Grad</translation>
    </message>
    <message>
        <source>needs a ball, bull-nose or tapered tool</source>
        <translation>braucht einen Kugelfräser, Torusfräser oder konischen Kugelfräser</translation>
    </message>
    <message>
        <source>needs a diameter above 0</source>
        <translation>braucht einen Durchmesser über 0</translation>
    </message>
    <message>
        <source>needs a number for {0}</source>
        <translation>braucht eine Zahl für {0}</translation>
    </message>
    <message>
        <source>needs a region and a cell that are finite and have a size</source>
        <translation>braucht einen Bereich und eine Zelle, die endlich sind und eine Ausdehnung haben</translation>
    </message>
    <message>
        <source>needs a solid</source>
        <translation>braucht einen Körper</translation>
    </message>
    <message>
        <source>needs a tool of shape v</source>
        <translation>braucht ein Werkzeug der Form v</translation>
    </message>
    <message>
        <source>needs a tool with a diameter</source>
        <translation>braucht ein Werkzeug mit einem Durchmesser</translation>
    </message>
    <message>
        <source>neither this set-up nor the call names a program</source>
        <translation>weder diese Aufspannung noch der Aufruf nennt ein Programm</translation>
    </message>
    <message>
        <source>no chip load is known for '{0}', only for {1}{2}</source>
        <translation>für '{0}' ist kein Zahnvorschub bekannt, nur für {1}{2}</translation>
    </message>
    <message>
        <source>no cutter has this shape</source>
        <translation>kein Fräser hat diese Form</translation>
    </message>
    <message>
        <source>no factor may be 0</source>
        <translation>kein Faktor darf 0 sein</translation>
    </message>
    <message>
        <source>no operation before this one finishes the part</source>
        <translation>keine Operation davor schlichtet das Teil</translation>
    </message>
    <message>
        <source>no slot is between {0} and {1} mm wide</source>
        <translation>keine Nut ist zwischen {0} und {1} mm breit</translation>
    </message>
    <message>
        <source>no speed by VS: 20 mm/s is taken</source>
        <translation>keine Geschwindigkeit durch VS: 20 mm/s werden angenommen</translation>
    </message>
    <message>
        <source>no speed for a rotary axis: 10 degrees/s is taken</source>
        <translation>keine Geschwindigkeit für eine Drehachse: 10 Grad/s werden angenommen</translation>
    </message>
    <message>
        <source>no tool here is of the shape '{0}'</source>
        <translation>eine Werkzeugform '{0}' gibt es hier nicht</translation>
    </message>
    <message>
        <source>no tool is in the spindle; the set-up has none</source>
        <translation>in der Spindel ist kein Werkzeug; die Aufspannung hat keines</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>not certain at {0} {1}, the largest {2} mm: parts thinner than {3} mm may be missing there ({4})</source>
        <translation>nicht sicher an {0} {1}, die größte {2} mm: Teile unter {3} mm Dicke können dort fehlen ({4})</translation>
    </message>
    <message>
        <source>not certain at {0} {1}, the largest {2} mm: parts thinner than {3} mm may be missing there ({4}; cells of {5} mm would show them, with some {6} million triangles)</source>
        <translation>nicht sicher an {0} {1}, die größte {2} mm: Teile unter {3} mm Dicke können dort fehlen ({4}; Zellen von {5} mm würden sie zeigen, mit etwa {6} Millionen Dreiecken)</translation>
    </message>
    <message>
        <source>not certain, since it was not looked whether anything is missing</source>
        <translation>nicht sicher, da nicht geprüft wurde, ob etwas fehlt</translation>
    </message>
    <message>
        <source>not version 2.0 of kokopelli's format</source>
        <translation>nicht Version 2.0 des Formats von kokopelli</translation>
    </message>
    <message>
        <source>nothing in the block uses its {0} word</source>
        <translation>nichts im Satz verwendet sein {0}-Wort</translation>
    </message>
    <message>
        <source>nothing is seen to be missing, but its slopes there are too roughly known for a proof</source>
        <translation>es fehlt nichts Sichtbares, doch die Steigungen sind dort für einen Beweis zu ungenau bekannt</translation>
    </message>
    <message>
        <source>nothing moved that could be shown</source>
        <translation>es gibt keine Bewegung, die sich zeigen ließe</translation>
    </message>
    <message>
        <source>one has a vertex that is not there</source>
        <translation>eines hat einen Eckpunkt, den es nicht gibt</translation>
    </message>
    <message>
        <source>one number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>one or two heights</source>
        <translation>eine oder zwei Höhen</translation>
    </message>
    <message>
        <source>only a ball or a tapered ball can lean while it cuts</source>
        <translation>nur ein Kugelfräser oder konischer Kugelfräser kann geneigt fräsen</translation>
    </message>
    <message>
        <source>only a solid can be cut from other sides</source>
        <translation>nur ein Körper lässt sich von anderen Seiten fräsen</translation>
    </message>
    <message>
        <source>only a whole distance field can be saved</source>
        <translation>nur ein ganzes Abstandsfeld lässt sich speichern</translation>
    </message>
    <message>
        <source>only sampled distances, such as an .asdf file, are meshed in bricks</source>
        <translation>nur abgetastete Abstände, etwa aus einer .asdf-Datei, werden in Teilquadern vernetzt</translation>
    </message>
    <message>
        <source>opens itself: {0}{1}</source>
        <translation>öffnet sich selbst: {0}{1}</translation>
    </message>
    <message>
        <source>origin and direction must be finite, and the direction not 0</source>
        <translation>Ursprung und Richtung müssen endlich sein, und die Richtung nicht 0</translation>
    </message>
    <message>
        <source>outlines must lie within 20 m of the origin</source>
        <translation>Umrisse dürfen höchstens 20 m vom Ursprung entfernt sein</translation>
    </message>
    <message>
        <source>overhangs: this machine's head cannot go from plane to plane with the tool pointing upwards (Keeter, Algorithm 6.1)</source>
        <translation>hängt über: der Kopf dieser Maschine kann nicht mit nach oben zeigendem Werkzeug von Ebene zu Ebene wechseln (Keeter, Algorithmus 6.1)</translation>
    </message>
    <message>
        <source>pairs of x and y</source>
        <translation>Paare von x und y</translation>
    </message>
    <message>
        <source>parameter #{0} cannot be set: it follows from the machine's state</source>
        <translation>Parameter #{0} kann nicht gesetzt werden: der Wert folgt aus dem Zustand der Maschine</translation>
    </message>
    <message>
        <source>parameter #{0} would be no finite number</source>
        <translation>Parameter #{0} wäre keine endliche Zahl</translation>
    </message>
    <message>
        <source>place</source>
        <translation>Stelle</translation>
    </message>
    <message>
        <source>places</source>
        <translation>Stellen</translation>
    </message>
    <message>
        <source>places more than {0} components</source>
        <translation>platziert mehr als {0} Komponenten</translation>
    </message>
    <message>
        <source>places no object of type 'model', and others are not solids</source>
        <translation>platziert kein Objekt vom Typ 'model', und andere sind keine Körper</translation>
    </message>
    <message>
        <source>places nothing: its build has no item</source>
        <translation>platziert nichts: sein Element 'build' enthält kein 'item'</translation>
    </message>
    <message>
        <source>plane {0} overhangs: the tool would point upwards</source>
        <translation>Ebene {0} hängt über: das Werkzeug müsste nach oben zeigen</translation>
    </message>
    <message>
        <source>pressure_angle must be a plain number</source>
        <translation>pressure_angle muss eine konstante Zahl sein</translation>
    </message>
    <message>
        <source>programs in JavaScript (TPL) are not run</source>
        <translation>Programme in JavaScript (TPL) werden nicht ausgeführt</translation>
    </message>
    <message>
        <source>rapids are "straight" or "dog-leg"</source>
        <translation>rapids ist "straight" oder "dog-leg"</translation>
    </message>
    <message>
        <source>reading DICOM files</source>
        <translation>DICOM-Dateien werden gelesen</translation>
    </message>
    <message>
        <source>reading DICOM headers</source>
        <translation>DICOM-Header werden gelesen</translation>
    </message>
    <message>
        <source>reading the mesh</source>
        <translation>Netz wird gelesen</translation>
    </message>
    <message>
        <source>reading the program</source>
        <translation>Programm wird gelesen</translation>
    </message>
    <message>
        <source>reading {0}</source>
        <translation>{0} wird gelesen</translation>
    </message>
    <message>
        <source>refers to an object {0} that is not there</source>
        <translation>verweist auf ein Objekt {0}, das es nicht gibt</translation>
    </message>
    <message>
        <source>refining edges</source>
        <translation>Kanten werden verfeinert</translation>
    </message>
    <message>
        <source>region and voxel must be finite, with a positive size</source>
        <translation>Bereich und Zelle müssen endlich sein und eine positive Größe haben</translation>
    </message>
    <message>
        <source>removing islands</source>
        <translation>Inseln werden entfernt</translation>
    </message>
    <message>
        <source>requires the extension '{0}', which is not read</source>
        <translation>verlangt die Erweiterung '{0}', die nicht gelesen wird</translation>
    </message>
    <message>
        <source>rim is</source>
        <translation>Rand ist</translation>
    </message>
    <message>
        <source>rims are</source>
        <translation>Ränder sind</translation>
    </message>
    <message>
        <source>running {0}</source>
        <translation>{0} läuft</translation>
    </message>
    <message>
        <source>samples of an unknown type, {0}</source>
        <translation>Messwerte von unbekanntem Typ: {0}</translation>
    </message>
    <message>
        <source>samples of {0} are not read</source>
        <translation>Messwerte vom Typ {0} werden nicht gelesen</translation>
    </message>
    <message>
        <source>samples of {0} bits are not read; known are 8, 16 and 32 bits, and 64 for real numbers</source>
        <translation>Messwerte mit {0} Bit werden nicht gelesen; bekannt sind 8, 16 und 32 Bit sowie 64 für Gleitkommazahlen</translation>
    </message>
    <message>
        <source>samples {0} to {1} along {2} are not two or more of the volume's 0 to {3}</source>
        <translation>Messpunkte {0} bis {1} entlang {2}: es müssen mindestens zwei der Messpunkte 0 bis {3} des Volumens sein</translation>
    </message>
    <message>
        <source>scale must be above 0</source>
        <translation>scale muss über 0 liegen</translation>
    </message>
    <message>
        <source>searching for lost parts</source>
        <translation>verlorene Teile werden gesucht</translation>
    </message>
    <message>
        <source>searching for the surface</source>
        <translation>Oberfläche wird gesucht</translation>
    </message>
    <message>
        <source>setting {0} needs a default</source>
        <translation>die Einstellung {0} braucht eine Vorgabe</translation>
    </message>
    <message>
        <source>sharpening edges</source>
        <translation>Kanten werden geschärft</translation>
    </message>
    <message>
        <source>sheet is [width, height] in mm</source>
        <translation>sheet ist [Breite, Höhe] in mm</translation>
    </message>
    <message>
        <source>slice {0} has samples of {1}, the first of {2}</source>
        <translation>Schichtbild {0} hat Messwerte vom Typ {1}, das erste vom Typ {2}</translation>
    </message>
    <message>
        <source>slice {0} has {1} x {2} pixels, the first has {3} x {4}</source>
        <translation>Schichtbild {0} hat {1} x {2} Pixel, das erste {3} x {4}</translation>
    </message>
    <message>
        <source>sorting triangles</source>
        <translation>Dreiecke werden sortiert</translation>
    </message>
    <message>
        <source>spindle is {0}; {1} turns at {2} at most</source>
        <translation>spindle ist {0}; {1} dreht mit höchstens {2}</translation>
    </message>
    <message>
        <source>splines are of the plane G17</source>
        <translation>Splines gibt es nur in der Ebene G17</translation>
    </message>
    <message>
        <source>takes at least three points, each with its x and y</source>
        <translation>braucht mindestens drei Punkte, jeden mit x und y</translation>
    </message>
    <message>
        <source>takes at least two points, each with its x and y</source>
        <translation>braucht mindestens zwei Punkte, jeden mit x und y</translation>
    </message>
    <message>
        <source>tapered ball</source>
        <translation>konischer Kugelfräser</translation>
    </message>
    <message>
        <source>tells an impossible resolution</source>
        <translation>gibt eine unmögliche Auflösung an</translation>
    </message>
    <message>
        <source>tells an impossible size</source>
        <translation>gibt eine unmögliche Größe an</translation>
    </message>
    <message>
        <source>tells distances or directions that are not possible</source>
        <translation>gibt unmögliche Abstände oder Richtungen an</translation>
    </message>
    <message>
        <source>the arc begins {0} mm from its centre and ends {1} mm from it</source>
        <translation>der Bogen beginnt {0} mm vom Mittelpunkt entfernt und endet {1} mm davon entfernt</translation>
    </message>
    <message>
        <source>the area is too large for so small a tool</source>
        <translation>die Fläche ist zu groß für ein so kleines Werkzeug</translation>
    </message>
    <message>
        <source>the argument '{0}' is given twice</source>
        <translation>das Argument '{0}' ist doppelt angegeben</translation>
    </message>
    <message>
        <source>the axis must have a length</source>
        <translation>die Achse muss eine Länge haben</translation>
    </message>
    <message>
        <source>the bottom of a thread must be below its top</source>
        <translation>die Unterkante eines Gewindes muss unter seiner Oberkante liegen</translation>
    </message>
    <message>
        <source>the bottom of the cut ({0}) must be below its top ({1})</source>
        <translation>die Unterkante des Schnitts ({0}) muss unter seiner Oberkante ({1}) liegen</translation>
    </message>
    <message>
        <source>the bounds must be finite and in order</source>
        <translation>die Grenzen müssen endlich und geordnet sein</translation>
    </message>
    <message>
        <source>the checksum of a block is wrong</source>
        <translation>die Prüfsumme eines Blocks ist falsch</translation>
    </message>
    <message>
        <source>the checksum of its directory is wrong</source>
        <translation>die Prüfsumme des Verzeichnisses ist falsch</translation>
    </message>
    <message>
        <source>the checksum of its header is wrong</source>
        <translation>die Prüfsumme des Dateikopfs ist falsch</translation>
    </message>
    <message>
        <source>the control's own variables (%) are not known here</source>
        <translation>die eigenen Variablen der Steuerung (%) sind hier unbekannt</translation>
    </message>
    <message>
        <source>the curves around a cell do not close</source>
        <translation>die Kurven um eine Zelle schließen sich nicht</translation>
    </message>
    <message>
        <source>the density of sample ({0}, {1}, {2}) is not a finite number</source>
        <translation>die Dichte am Messpunkt ({0}, {1}, {2}) ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>the depth of a peck</source>
        <translation>die Zustelltiefe je Bohrhub</translation>
    </message>
    <message>
        <source>the distance field would have more than 2^27 cells</source>
        <translation>das Abstandsfeld hätte mehr als 2^27 Zellen</translation>
    </message>
    <message>
        <source>the distance field would need more memory than there is</source>
        <translation>das Abstandsfeld bräuchte mehr Speicher, als vorhanden ist</translation>
    </message>
    <message>
        <source>the dwell in seconds</source>
        <translation>die Verweilzeit in Sekunden</translation>
    </message>
    <message>
        <source>the end of the statement</source>
        <translation>das Ende der Anweisung</translation>
    </message>
    <message>
        <source>the entry arc of cutter compensation cannot be made</source>
        <translation>der Anfahrbogen der Fräserradiuskorrektur kann nicht gebildet werden</translation>
    </message>
    <message>
        <source>the entry move of cutter compensation is not longer than the tool's radius</source>
        <translation>die Anfahrbewegung der Fräserradiuskorrektur ist nicht länger als der Werkzeugradius</translation>
    </message>
    <message>
        <source>the expression ends here, but {0} follows</source>
        <translation>der Ausdruck endet hier, aber es folgt {0}</translation>
    </message>
    <message>
        <source>the expression is empty</source>
        <translation>der Ausdruck ist leer</translation>
    </message>
    <message>
        <source>the factor must be a positive number</source>
        <translation>der Faktor muss eine positive Zahl sein</translation>
    </message>
    <message>
        <source>the file ends within subroutine {0}</source>
        <translation>die Datei endet innerhalb des Unterprogramms {0}</translation>
    </message>
    <message>
        <source>the file ends within the loop o{0}</source>
        <translation>die Datei endet innerhalb der Schleife o{0}</translation>
    </message>
    <message>
        <source>the fine parts of the surface</source>
        <translation>die feinen Teile der Oberfläche</translation>
    </message>
    <message>
        <source>the first G5 of a row needs I and J</source>
        <translation>das erste G5 einer Folge braucht I und J</translation>
    </message>
    <message>
        <source>the fixture has no size</source>
        <translation>das Spannmittel hat keine Ausdehnung</translation>
    </message>
    <message>
        <source>the height is outside of the region</source>
        <translation>die Höhe liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>the heights of a section must not fall</source>
        <translation>die Höhen eines Querschnitts dürfen nicht abnehmen</translation>
    </message>
    <message>
        <source>the holder meets material</source>
        <translation>der Halter stößt an Material</translation>
    </message>
    <message>
        <source>the job has {0} tools: say which, tool = NUMBER</source>
        <translation>der Auftrag hat {0} Werkzeuge: mit tool = NUMMER eines wählen</translation>
    </message>
    <message>
        <source>the limit of divided cells was reached</source>
        <translation>die Höchstzahl geteilter Zellen ist erreicht</translation>
    </message>
    <message>
        <source>the line ends where a value should be</source>
        <translation>Zeilenende gefunden, Wert erwartet</translation>
    </message>
    <message>
        <source>the machine</source>
        <translation>die Maschine</translation>
    </message>
    <message>
        <source>the machine cannot point its tool along ({0}, {1}, {2})</source>
        <translation>die Maschine kann ihr Werkzeug nicht in die Richtung ({0}, {1}, {2}) stellen</translation>
    </message>
    <message>
        <source>the macro {0} of the control is passed over</source>
        <translation>das Makro {0} der Steuerung wird übergangen</translation>
    </message>
    <message>
        <source>the mesh</source>
        <translation>das Netz</translation>
    </message>
    <message>
        <source>the mesh of {0}</source>
        <translation>das Netz von {0}</translation>
    </message>
    <message>
        <source>the mesh would have more than 2^31 vertices</source>
        <translation>das Netz hätte mehr als 2^31 Eckpunkte</translation>
    </message>
    <message>
        <source>the model is flat: it has no surface to finish; use profile, pocket, isolate or v_carve</source>
        <translation>das Modell ist flach: es hat keine Oberfläche zum Schlichten; profile, pocket, isolate oder v_carve verwenden</translation>
    </message>
    <message>
        <source>the module must be above 0 mm</source>
        <translation>der Modul muss über 0 mm liegen</translation>
    </message>
    <message>
        <source>the name of a part stands in quotes</source>
        <translation>der Name eines Teils steht in Anführungszeichen</translation>
    </message>
    <message>
        <source>the name {0} is given twice</source>
        <translation>der Name {0} ist doppelt vergeben</translation>
    </message>
    <message>
        <source>the normal must have a length</source>
        <translation>die Normale muss eine Länge haben</translation>
    </message>
    <message>
        <source>the number of copies must be from 1 to 10000</source>
        <translation>die Zahl der Kopien muss zwischen 1 und 10000 liegen</translation>
    </message>
    <message>
        <source>the number of pins must be even, from 2 to 1000</source>
        <translation>die Zahl der Anschlüsse muss gerade sein, von 2 bis 1000</translation>
    </message>
    <message>
        <source>the number of sides must be from 3 to 10000</source>
        <translation>die Zahl der Seiten muss zwischen 3 und 10000 liegen</translation>
    </message>
    <message>
        <source>the number of teeth must be from 3 to 10000</source>
        <translation>die Zahl der Zähne muss zwischen 3 und 10000 liegen</translation>
    </message>
    <message>
        <source>the outline {0} parts narrower than {1} mm, for example at x {2}, y {3}: give a smaller cell</source>
        <translation>dem Umriss {0} Teile, die schmaler als {1} mm sind, zum Beispiel bei x {2}, y {3}: eine kleinere Zelle angeben</translation>
    </message>
    <message>
        <source>the parenthesis opened at column {0} is not closed</source>
        <translation>die in Spalte {0} geöffnete Klammer wird nicht geschlossen</translation>
    </message>
    <message>
        <source>the part (to x {0}, y {1}, z {2}) sticks out of the stock (to {3}, {4}, {5})</source>
        <translation>das Teil (bis x {0}, y {1}, z {2}) ragt aus dem Rohteil heraus (bis {3}, {4}, {5})</translation>
    </message>
    <message>
        <source>the part has no holes for this thread; it wants {0} mm</source>
        <translation>das Teil hat keine Bohrungen für dieses Gewinde; nötig sind {0} mm</translation>
    </message>
    <message>
        <source>the part has no outline on this side that the tool can follow</source>
        <translation>das Teil hat auf dieser Seite keinen Umriss, dem das Werkzeug folgen kann</translation>
    </message>
    <message>
        <source>the part has no round holes of at most {0} mm</source>
        <translation>das Teil hat keine runden Bohrungen bis {0} mm</translation>
    </message>
    <message>
        <source>the part is flat: give the depth to face</source>
        <translation>das Teil ist flach: die Tiefe zum Planfräsen angeben</translation>
    </message>
    <message>
        <source>the part is given: the input names none</source>
        <translation>das Teil ist schon gegeben: input darf keines nennen</translation>
    </message>
    <message>
        <source>the picture has no heights; give black and white, mm</source>
        <translation>das Bild hat keine Höhen; black und white in mm angeben</translation>
    </message>
    <message>
        <source>the picture has no physical size; give pixel (mm) or dpi</source>
        <translation>das Bild hat keine wirkliche Größe; pixel (mm) oder dpi angeben</translation>
    </message>
    <message>
        <source>the points lie on a line</source>
        <translation>die Punkte liegen auf einer Geraden</translation>
    </message>
    <message>
        <source>the points of a profile go outwards from the axis</source>
        <translation>die Punkte eines Profils müssen von der Achse nach außen laufen</translation>
    </message>
    <message>
        <source>the polygon is too ragged, or crosses itself</source>
        <translation>das Polygon ist zu zerklüftet oder überschneidet sich selbst</translation>
    </message>
    <message>
        <source>the position cannot be asked for while cutter compensation is on</source>
        <translation>bei aktiver Fräserradiuskorrektur kann die Position nicht abgefragt werden</translation>
    </message>
    <message>
        <source>the pressure angle must be above 0 and below 68 degrees</source>
        <translation>der Eingriffswinkel muss über 0 und unter 68 Grad liegen</translation>
    </message>
    <message>
        <source>the program ends without END</source>
        <translation>das Programm endet ohne END</translation>
    </message>
    <message>
        <source>the program ends without M2 or M30</source>
        <translation>das Programm endet ohne M2 oder M30</translation>
    </message>
    <message>
        <source>the program ends without M2, M30 or a second %</source>
        <translation>das Programm endet ohne M2, M30 oder ein zweites %</translation>
    </message>
    <message>
        <source>the program is empty</source>
        <translation>das Programm ist leer</translation>
    </message>
    <message>
        <source>the program names no tool: number {0} is taken</source>
        <translation>das Programm nennt kein Werkzeug: Nummer {0} wird verwendet</translation>
    </message>
    <message>
        <source>the quotes opened here are not closed on this line</source>
        <translation>die hier geöffneten Anführungszeichen werden in dieser Zeile nicht geschlossen</translation>
    </message>
    <message>
        <source>the radius must be above 0 mm</source>
        <translation>der Radius muss über 0 mm liegen</translation>
    </message>
    <message>
        <source>the radius {0} is too small to reach the arc's end</source>
        <translation>der Radius {0} ist zu klein, um das Ende des Bogens zu erreichen</translation>
    </message>
    <message>
        <source>the result is no finite number</source>
        <translation>das Ergebnis ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>the saved stock has a cell of {0} mm, which does not change</source>
        <translation>das gespeicherte Rohteil hat Zellen von {0} mm; das ist nicht zu ändern</translation>
    </message>
    <message>
        <source>the script could not be run: Python's module fieldfab is not there, or out of memory</source>
        <translation>das Skript konnte nicht ausgeführt werden: das Python-Modul fieldfab fehlt, oder der Speicher reicht nicht</translation>
    </message>
    <message>
        <source>the script still runs after {0} s; an endless loop?</source>
        <translation>das Skript läuft nach {0} s immer noch; eine Endlosschleife?</translation>
    </message>
    <message>
        <source>the script was ended by signal {0}</source>
        <translation>das Skript wurde durch Signal {0} beendet</translation>
    </message>
    <message>
        <source>the script's shape is too large</source>
        <translation>die Form des Skripts ist zu groß</translation>
    </message>
    <message>
        <source>the shank meets material</source>
        <translation>der Schaft stößt an Material</translation>
    </message>
    <message>
        <source>the slices {0} and {1} are {2} mm apart, the others {3} mm: slices are missing or twice there</source>
        <translation>die Schichtbilder {0} und {1} liegen {2} mm auseinander, die anderen {3} mm: Schichtbilder fehlen oder sind doppelt vorhanden</translation>
    </message>
    <message>
        <source>the slot around x {0}, y {1} is wider than the tool of {2} mm: its sides keep material</source>
        <translation>die Nut um x {0}, y {1} ist breiter als das Werkzeug von {2} mm: an ihren Seiten bleibt Material stehen</translation>
    </message>
    <message>
        <source>the smallest cells</source>
        <translation>kleinste Zellen</translation>
    </message>
    <message>
        <source>the solid has no bounds; give some</source>
        <translation>der Körper hat keine Grenzen; Grenzen angeben</translation>
    </message>
    <message>
        <source>the solid is empty; give bounds to work on a region all the same</source>
        <translation>der Körper ist leer; Grenzen angeben, um trotzdem in einem Bereich zu arbeiten</translation>
    </message>
    <message>
        <source>the solid is unbounded along {0}; give bounds x0,y0,z0,x1,y1,z1{1}</source>
        <translation>der Körper ist entlang {0} unbegrenzt; Grenzen angeben: x0,y0,z0,x1,y1,z1{1}</translation>
    </message>
    <message>
        <source>the solids touch each other</source>
        <translation>die Körper berühren sich</translation>
    </message>
    <message>
        <source>the spindle never turns while the program moves: it is taken as switched on by hand</source>
        <translation>die Spindel dreht während des Programms nie: sie gilt als von Hand eingeschaltet</translation>
    </message>
    <message>
        <source>the stock has no size: its lower corner is not below its upper one</source>
        <translation>das Rohteil hat keine Ausdehnung: seine untere Ecke liegt nicht unter der oberen</translation>
    </message>
    <message>
        <source>the stock is no higher than the part: there is nothing to face; give a depth</source>
        <translation>das Rohteil ist nicht höher als das Teil: es gibt nichts planzufräsen; eine Tiefe angeben</translation>
    </message>
    <message>
        <source>the stock lacks {0} mm of the target at ({1}, {2}, {3})</source>
        <translation>dem Rohteil fehlen {0} mm zum Ziel bei ({1}, {2}, {3})</translation>
    </message>
    <message>
        <source>the stock needs lower and upper corners, a cylinder or a model</source>
        <translation>das Rohteil braucht eine untere und eine obere Ecke, einen Zylinder oder ein Modell</translation>
    </message>
    <message>
        <source>the surface</source>
        <translation>die Oberfläche</translation>
    </message>
    <message>
        <source>the system ended this work; it has too little memory</source>
        <translation>das System hat diese Arbeit beendet; es hat zu wenig Speicher</translation>
    </message>
    <message>
        <source>the target may have parts thinner than a cell of {0} mm at {1} places, the largest {2} mm, about ({3}, {4}, {5}): cuts into them may not be seen</source>
        <translation>das Ziel ist womöglich an {1} Stellen dünner als eine Zelle von {0} mm, die größte {2} mm, um ({3}, {4}, {5}): Schnitte dort bleiben vielleicht unbemerkt</translation>
    </message>
    <message>
        <source>the template {0} {1}</source>
        <translation>die Vorlage {0} {1}</translation>
    </message>
    <message>
        <source>the text has no result: its last statement is the solid</source>
        <translation>der Text hat kein Ergebnis: seine letzte Anweisung ist der Körper</translation>
    </message>
    <message>
        <source>the text has parts, and this is none: make it one with part(...), or give it a name</source>
        <translation>der Text hat Teile, und dies ist keines: mit part(...) zu einem machen oder ihm einen Namen geben</translation>
    </message>
    <message>
        <source>the thickness must be above 0 mm</source>
        <translation>die Dicke muss über 0 mm liegen</translation>
    </message>
    <message>
        <source>the tool leans less than asked for, or elsewhere, along {0} mm: it would touch the part</source>
        <translation>auf {0} mm neigt sich das Werkzeug weniger als verlangt oder in eine andere Richtung: es würde das Teil berühren</translation>
    </message>
    <message>
        <source>the tool meets a fixture</source>
        <translation>das Werkzeug stößt an ein Spannmittel</translation>
    </message>
    <message>
        <source>the tool of {0} mm does not fit into the hole of {1} mm</source>
        <translation>das Werkzeug von {0} mm passt nicht in die Bohrung von {1} mm</translation>
    </message>
    <message>
        <source>the tool of {0} mm fits into no pocket; the first is around x {1}, y {2}</source>
        <translation>das Werkzeug von {0} mm passt in keine Tasche; die erste liegt um x {1}, y {2}</translation>
    </message>
    <message>
        <source>the tool of {0} mm is too large for the pocket around x {1}, y {2}: it is left</source>
        <translation>das Werkzeug von {0} mm ist zu groß für die Tasche um x {1}, y {2}: sie wird ausgelassen</translation>
    </message>
    <message>
        <source>the variable &amp;{0} has no value</source>
        <translation>die Variable &amp;{0} hat keinen Wert</translation>
    </message>
    <message>
        <source>the workpiece has no bounds</source>
        <translation>das Werkstück hat keine Grenzen</translation>
    </message>
    <message>
        <source>the workpiece has no size</source>
        <translation>das Werkstück hat keine Ausdehnung</translation>
    </message>
    <message>
        <source>the workpiece is to be as large as the programs' paths, and no program cuts</source>
        <translation>das Werkstück soll so groß wie die Bahnen der Programme sein, aber kein Programm schneidet</translation>
    </message>
    <message>
        <source>there are no valleys that this tool touches on both sides</source>
        <translation>es gibt keine Kehlen, die dieses Werkzeug auf beiden Seiten berührt</translation>
    </message>
    <message>
        <source>there are none to make a picture of</source>
        <translation>es gibt keine, die ein Bild ergeben</translation>
    </message>
    <message>
        <source>there are two tools with number {0}</source>
        <translation>es gibt zwei Werkzeuge mit der Nummer {0}</translation>
    </message>
    <message>
        <source>there is no Field</source>
        <translation>es gibt kein Field</translation>
    </message>
    <message>
        <source>there is no G{0}</source>
        <translation>G{0} gibt es nicht</translation>
    </message>
    <message>
        <source>there is no [[tool]] with number {0}</source>
        <translation>es gibt kein [[tool]] mit der Nummer {0}</translation>
    </message>
    <message>
        <source>there is no brick {0}, {1}, {2} of {3} x {4} x {5}</source>
        <translation>es gibt keinen Teilquader {0}, {1}, {2} von {3} x {4} x {5}</translation>
    </message>
    <message>
        <source>there is no key '{0}' here{1}</source>
        <translation>hier gibt es keinen Schlüssel '{0}'{1}</translation>
    </message>
    <message>
        <source>there is no label {0}</source>
        <translation>die Marke {0} gibt es nicht</translation>
    </message>
    <message>
        <source>there is no machine '{0}'{1} Known are {2}, or a .toml file</source>
        <translation>es gibt keine Maschine '{0}'{1} (bekannt: {2} oder eine .toml-Datei)</translation>
    </message>
    <message>
        <source>there is no operation '{0}'{1} Known are {2}</source>
        <translation>es gibt keine Operation '{0}'{1} (bekannt: {2})</translation>
    </message>
    <message>
        <source>there is no parameter #{0}: they go from #1 to #{1}</source>
        <translation>Parameter #{0} gibt es nicht: möglich sind #1 bis #{1}</translation>
    </message>
    <message>
        <source>there is no part '{0}'{1}</source>
        <translation>es gibt kein Teil '{0}'{1}</translation>
    </message>
    <message>
        <source>there is no part to write</source>
        <translation>es gibt kein Teil zu schreiben</translation>
    </message>
    <message>
        <source>there is no part {0} of {1}</source>
        <translation>es gibt keinen Teil {0} von {1}</translation>
    </message>
    <message>
        <source>there is no plane '{0}'; known are top, bottom, front, back, left, right</source>
        <translation>es gibt keine Ebene '{0}'; bekannt sind top, bottom, front, back, left, right</translation>
    </message>
    <message>
        <source>there is no program O{0}, here or in a file {1}.ngc</source>
        <translation>es gibt kein Programm O{0}, weder hier noch in einer Datei {1}.ngc</translation>
    </message>
    <message>
        <source>there is no reader for '{0}' yet; known are {1}</source>
        <translation>'{0}' kann noch nicht gelesen werden; bekannt sind {1}</translation>
    </message>
    <message>
        <source>there is no subroutine o&lt;{0}&gt;, here or in a file {1}.ngc</source>
        <translation>es gibt kein Unterprogramm o&lt;{0}&gt;, weder hier noch in einer Datei {1}.ngc</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>there is no surface within the bounds</source>
        <translation>in den Grenzen liegt keine Oberfläche</translation>
    </message>
    <message>
        <source>there is no target to tell deviations from</source>
        <translation>ohne Ziel gibt es keine Abweichungen</translation>
    </message>
    <message>
        <source>there is no writer of volumes for '{0}'; known are .nrrd .mha .nii .nii.gz</source>
        <translation>Volumen können nicht als '{0}' geschrieben werden; bekannt sind .nrrd .mha .nii .nii.gz</translation>
    </message>
    <message>
        <source>there is nothing of the part at cells of {0} mm</source>
        <translation>bei Zellen von {0} mm ist vom Teil nichts vorhanden</translation>
    </message>
    <message>
        <source>there is nothing to clear</source>
        <translation>es gibt nichts zu räumen</translation>
    </message>
    <message>
        <source>this build was made without ITK and OpenVDB</source>
        <translation>dieses Programm wurde ohne ITK und OpenVDB gebaut</translation>
    </message>
    <message>
        <source>this kind of solid does not tell its slopes</source>
        <translation>die Steigungen dieser Art von Körper sind unbekannt</translation>
    </message>
    <message>
        <source>this machine cannot tilt the tool</source>
        <translation>diese Maschine kann das Werkzeug nicht neigen</translation>
    </message>
    <message>
        <source>this operation does not take one argument</source>
        <translation>diese Operation hat nicht genau ein Argument</translation>
    </message>
    <message>
        <source>this operation does not take two arguments</source>
        <translation>diese Operation hat nicht genau zwei Argumente</translation>
    </message>
    <message>
        <source>this value is not used: give it a name, or make it a part with part(...); without parts the last statement is the solid</source>
        <translation>dieser Wert wird nicht verwendet: einen Namen geben oder mit part(...) zu einem Teil machen; ohne Teile ist die letzte Anweisung der Körper</translation>
    </message>
    <message>
        <source>tip_diameter must be less than the diameter</source>
        <translation>tip_diameter muss kleiner als der Durchmesser sein</translation>
    </message>
    <message>
        <source>too many faces cross or lie in one plane</source>
        <translation>zu viele Flächen schneiden sich oder liegen in einer Ebene</translation>
    </message>
    <message>
        <source>too many samples to find the pieces of the solid</source>
        <translation>zu viele Messpunkte, um die Stücke des Körpers zu finden</translation>
    </message>
    <message>
        <source>too many vertices</source>
        <translation>zu viele Eckpunkte</translation>
    </message>
    <message>
        <source>too many words: expected NAME OP ARGUMENTS</source>
        <translation>zu viele Wörter; erwartet: NAME OP ARGUMENTS</translation>
    </message>
    <message>
        <source>too much surface for one brick</source>
        <translation>zu viel Oberfläche für einen Teilquader</translation>
    </message>
    <message>
        <source>tool '{0}' has no whole number</source>
        <translation>Werkzeug '{0}' hat keine ganzzahlige Nummer</translation>
    </message>
    <message>
        <source>tool '{0}' is no table</source>
        <translation>Werkzeug '{0}' ist keine Tabelle</translation>
    </message>
    <message>
        <source>tool {0}</source>
        <translation>Werkzeug {0}</translation>
    </message>
    <message>
        <source>tool {0} has no profile</source>
        <translation>Werkzeug {0} hat kein Profil</translation>
    </message>
    <message>
        <source>tool {0} is not in the set-up, which has {1}</source>
        <translation>Werkzeug {0} fehlt in der Aufspannung; vorhanden: {1}</translation>
    </message>
    <message>
        <source>tool {0} is not in the tool table</source>
        <translation>Werkzeug {0} steht nicht in der Werkzeugtabelle</translation>
    </message>
    <message>
        <source>tool {0} needs a length (from tip to holder): {1} turns its head about a point that far away</source>
        <translation>Werkzeug {0} braucht eine Länge (von der Spitze bis zum Halter): {1} dreht den Kopf um einen Punkt in diesem Abstand</translation>
    </message>
    <message>
        <source>tool {0} needs an angle</source>
        <translation>Werkzeug {0} braucht einen Winkel</translation>
    </message>
    <message>
        <source>tool {0}: diameter and length must be above 0</source>
        <translation>Werkzeug {0}: Durchmesser und Länge müssen über 0 liegen</translation>
    </message>
    <message>
        <source>tool {0}: spheroids are not known here</source>
        <translation>Werkzeug {0}: Sphäroide sind hier nicht bekannt</translation>
    </message>
    <message>
        <source>tool {0}: there is no shape '{1}'</source>
        <translation>Werkzeug {0}: es gibt keine Form '{1}'</translation>
    </message>
    <message>
        <source>tool {0}: {1}</source>
        <translation>Werkzeug {0}: {1}</translation>
    </message>
    <message>
        <source>tracing curves</source>
        <translation>Kurven werden verfolgt</translation>
    </message>
    <message>
        <source>travel must be [x, y, z] in mm</source>
        <translation>travel muss [x, y, z] in mm sein</translation>
    </message>
    <message>
        <source>triangles are seen from infinitely far: it must be 0</source>
        <translation>Dreiecke werden aus unendlicher Entfernung gesehen: der Wert muss 0 sein</translation>
    </message>
    <message>
        <source>triangles have no bitmap; shaded, normals and height are possible</source>
        <translation>bitmap gibt es für Dreiecke nicht; möglich sind shaded, normals und height</translation>
    </message>
    <message>
        <source>two $ words in one block</source>
        <translation>zwei $-Wörter in einem Satz</translation>
    </message>
    <message>
        <source>two @ words in one block</source>
        <translation>zwei @-Wörter in einem Satz</translation>
    </message>
    <message>
        <source>two G53 in one block</source>
        <translation>zweimal G53 in einem Satz</translation>
    </message>
    <message>
        <source>two ^ words in one block</source>
        <translation>zwei ^-Wörter in einem Satz</translation>
    </message>
    <message>
        <source>two parts are called '{0}'</source>
        <translation>zwei Teile heißen '{0}'</translation>
    </message>
    <message>
        <source>two {0} words in one block</source>
        <translation>zwei {0}-Wörter in einem Satz</translation>
    </message>
    <message>
        <source>under G90.1 an arc needs {0} and {1}</source>
        <translation>unter G90.1 braucht ein Bogen {0} und {1}</translation>
    </message>
    <message>
        <source>under G93 each arc needs its F word</source>
        <translation>unter G93 braucht jeder Bogen ein eigenes F-Wort</translation>
    </message>
    <message>
        <source>under G93 each feed needs its F word, above 0</source>
        <translation>unter G93 braucht jede Vorschubbewegung ein eigenes F-Wort über 0</translation>
    </message>
    <message>
        <source>unexpected {0}</source>
        <translation>unerwartet: {0}</translation>
    </message>
    <message>
        <source>unexpected {0} after a number</source>
        <translation>unerwartet nach einer Zahl: {0}</translation>
    </message>
    <message>
        <source>unit and feed_unit must be above 0, tick not below, decimals from 0 to 9</source>
        <translation>unit und feed_unit müssen über 0 liegen, tick nicht unter 0, decimals von 0 bis 9</translation>
    </message>
    <message>
        <source>units are '{0}'; known are metric and imperial</source>
        <translation>units ist '{0}'; bekannt sind metric und imperial</translation>
    </message>
    <message>
        <source>unknown colour '{0}'; a CSS name or #rrggbb{1}</source>
        <translation>unbekannte Farbe '{0}'; möglich sind CSS-Namen und #rrggbb{1}</translation>
    </message>
    <message>
        <source>unknown function '{0}'{1}</source>
        <translation>unbekannte Funktion '{0}'{1}</translation>
    </message>
    <message>
        <source>unknown name '{0}'{1}</source>
        <translation>unbekannter Name '{0}'{1}</translation>
    </message>
    <message>
        <source>unknown name {0}</source>
        <translation>unbekannter Name {0}</translation>
    </message>
    <message>
        <source>unknown operation {0}</source>
        <translation>unbekannte Operation {0}</translation>
    </message>
    <message>
        <source>unknown type of sample: datatype '{0}' with '{1}' bits</source>
        <translation>unbekannter Typ der Messwerte: datatype '{0}' mit '{1}' Bit</translation>
    </message>
    <message>
        <source>uses {{{0}}}, which has no value</source>
        <translation>verwendet {{{0}}}, das keinen Wert hat</translation>
    </message>
    <message>
        <source>wants words in quotes</source>
        <translation>verlangt einen Text in Anführungszeichen</translation>
    </message>
    <message>
        <source>what comes of joining two solids is not the surface of a solid</source>
        <translation>das Verknüpfen zweier Körper ergibt nicht die Oberfläche eines Körpers</translation>
    </message>
    <message>
        <source>where the feed begins</source>
        <translation>den Beginn des Vorschubs</translation>
    </message>
    <message>
        <source>where the part is turned over, the program's zero must be the model's</source>
        <translation>wird das Teil gewendet, muss der Nullpunkt des Programms der des Modells sein</translation>
    </message>
    <message>
        <source>where the stock is a saved one, the program's zero must be the model's</source>
        <translation>ist das Rohteil ein gespeichertes, muss der Nullpunkt des Programms der des Modells sein</translation>
    </message>
    <message>
        <source>whole number</source>
        <translation>ganze Zahl</translation>
    </message>
    <message>
        <source>width and beyond are {0} mm together; the tool's radius is {1} mm</source>
        <translation>width und beyond sind zusammen {0} mm; der Radius des Werkzeugs ist {1} mm</translation>
    </message>
    <message>
        <source>works on: {0}; no stage leads there from: {1}</source>
        <translation>verarbeitet: {0}; dorthin führt keine Stufe von: {1}</translation>
    </message>
    <message>
        <source>would inflate to more than {0} bytes: {1} is the most, above {2} at most {3} times the archive</source>
        <translation>ergäbe entpackt mehr als {0} Byte: erlaubt sind {1}, über {2} höchstens das {3}-Fache des Archivs</translation>
    </message>
    <message>
        <source>writing the mesh</source>
        <translation>Netz wird geschrieben</translation>
    </message>
    <message>
        <source>x, y and z</source>
        <translation>x, y und z</translation>
    </message>
    <message>
        <source>zero is '{0}'; it must be one of model, corner, centre{1}, or a point [x, y, z]</source>
        <translation>zero ist '{0}'; möglich sind model, corner, centre{1} oder ein Punkt [x, y, z]</translation>
    </message>
    <message>
        <source>{0} ({1}) is passed over</source>
        <translation>{0} ({1}) wird übergangen</translation>
    </message>
    <message>
        <source>{0} ** {1}: a negative number to a power that is not whole</source>
        <translation>{0} ** {1}: negative Zahl mit nicht ganzzahligem Exponenten</translation>
    </message>
    <message>
        <source>{0} and another G code both want the axis words</source>
        <translation>{0} und ein weiterer G-Code beanspruchen beide die Achswörter</translation>
    </message>
    <message>
        <source>{0} and {1} exclude each other in one block</source>
        <translation>{0} und {1} schließen einander in einem Satz aus</translation>
    </message>
    <message>
        <source>{0} and {1} in one block: the last one holds</source>
        <translation>{0} und {1} in einem Satz: das letzte gilt</translation>
    </message>
    <message>
        <source>{0} between G5.2 and G5.3</source>
        <translation>{0} zwischen G5.2 und G5.3</translation>
    </message>
    <message>
        <source>{0} bytes are no whole number of bytes for each of {1} x {2} x {3} samples; give --dims, --type and --skip</source>
        <translation>{0} Byte ergeben keine ganze Zahl von Bytes für jeden von {1} x {2} x {3} Messwerten; --dims, --type und --skip angeben</translation>
    </message>
    <message>
        <source>{0} can move {1} mm along {2}; this program needs {3} mm or more</source>
        <translation>{0} fährt in {2} höchstens {1} mm; dieses Programm braucht mindestens {3} mm</translation>
    </message>
    <message>
        <source>{0} can neither tilt its tool nor stop for turning the part</source>
        <translation>{0} kann weder das Werkzeug neigen noch zum Drehen des Teils anhalten</translation>
    </message>
    <message>
        <source>{0} cannot be used under G93</source>
        <translation>{0} ist unter G93 nicht möglich</translation>
    </message>
    <message>
        <source>{0} cannot be used while cutter compensation is on</source>
        <translation>{0}: bei aktiver Fräserradiuskorrektur nicht möglich</translation>
    </message>
    <message>
        <source>{0} cannot tilt its tool</source>
        <translation>{0} kann das Werkzeug nicht neigen</translation>
    </message>
    <message>
        <source>{0} cannot tilt its tool: only faces can be turned up by hand</source>
        <translation>{0} kann das Werkzeug nicht neigen: von Hand lassen sich nur ganze Seiten nach oben drehen</translation>
    </message>
    <message>
        <source>{0} cells along a side</source>
        <translation>{0} Zellen entlang einer Seite</translation>
    </message>
    <message>
        <source>{0} cells along an axis</source>
        <translation>{0} Zellen entlang einer Achse</translation>
    </message>
    <message>
        <source>{0} densities for {1} x {2} x {3} samples</source>
        <translation>{0} Dichten für {1} x {2} x {3} Messpunkte</translation>
    </message>
    <message>
        <source>{0} dimensions; a volume has three</source>
        <translation>{0} Dimensionen; ein Volumen hat drei</translation>
    </message>
    <message>
        <source>{0} does not define o&lt;{1}&gt; sub</source>
        <translation>{0} definiert o&lt;{1}&gt; sub nicht</translation>
    </message>
    <message>
        <source>{0} does not run on this processor</source>
        <translation>{0} läuft auf diesem Prozessor nicht</translation>
    </message>
    <message>
        <source>{0} draws or changes where is drawn, but is not known here</source>
        <translation>{0} zeichnet oder ändert, wo gezeichnet wird, ist hier aber unbekannt</translation>
    </message>
    <message>
        <source>{0} for {1} vertices</source>
        <translation>{0} für {1} Eckpunkte</translation>
    </message>
    <message>
        <source>{0} found where a whole number should be</source>
        <translation>{0} gefunden, ganze Zahl erwartet</translation>
    </message>
    <message>
        <source>{0} has more parameters than axes</source>
        <translation>{0} hat mehr Parameter als Achsen</translation>
    </message>
    <message>
        <source>{0} has no defaults for '{1}'{2}{3}</source>
        <translation>{0} hat keine Vorgaben für '{1}'{2}{3}</translation>
    </message>
    <message>
        <source>{0} has no tool {1}</source>
        <translation>{0} hat kein Werkzeug {1}</translation>
    </message>
    <message>
        <source>{0} has too few numbers</source>
        <translation>{0} hat zu wenige Zahlen</translation>
    </message>
    <message>
        <source>{0} in a block that has no use for it is passed over</source>
        <translation>{0} in einem Satz, der es nicht verwendet, wird übergangen</translation>
    </message>
    <message>
        <source>{0} in a name: this is not a .vm program</source>
        <translation>{0} in einem Namen: dies ist kein .vm-Programm</translation>
    </message>
    <message>
        <source>{0} in an arc of another plane</source>
        <translation>{0} in einem Bogen einer anderen Ebene</translation>
    </message>
    <message>
        <source>{0} is '{1}': a number with a unit is wanted</source>
        <translation>{0} ist '{1}': erwartet wird eine Zahl mit Einheit</translation>
    </message>
    <message>
        <source>{0} is '{1}'; it must be one of {2}{3}</source>
        <translation>{0} ist '{1}'; möglich sind {2}{3}</translation>
    </message>
    <message>
        <source>{0} is [x, y, z] and up to six axes more</source>
        <translation>{0} ist [x, y, z] und bis zu sechs weitere Achsen</translation>
    </message>
    <message>
        <source>{0} is not a finite number</source>
        <translation>{0} ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>{0} is not a number</source>
        <translation>{0} ist keine Zahl</translation>
    </message>
    <message>
        <source>{0} is not a positive number</source>
        <translation>{0} ist keine positive Zahl</translation>
    </message>
    <message>
        <source>{0} is not a positive number of mm</source>
        <translation>{0} ist keine positive Zahl in mm</translation>
    </message>
    <message>
        <source>{0} is not a power of two of at least {1}</source>
        <translation>{0} ist keine Zweierpotenz ab {1}</translation>
    </message>
    <message>
        <source>{0} is not known here</source>
        <translation>{0} ist hier unbekannt</translation>
    </message>
    <message>
        <source>{0} is open, and lids cannot close it: what is inside is found by winding numbers, which takes long</source>
        <translation>{0} ist offen und lässt sich nicht mit Deckeln schließen: was innen liegt, wird über Windungszahlen bestimmt, und das dauert lange</translation>
    </message>
    <message>
        <source>{0} is open: {1} {2} closed by lids of {3} mm2</source>
        <translation>{0} ist offen: {1} {2} mit Deckeln von {3} mm2 geschlossen</translation>
    </message>
    <message>
        <source>{0} is outside of the densities, which go from {1} to {2}</source>
        <translation>{0} liegt außerhalb der Dichten, die von {1} bis {2} reichen</translation>
    </message>
    <message>
        <source>{0} is passed over</source>
        <translation>{0} wird übergangen</translation>
    </message>
    <message>
        <source>{0} is too large</source>
        <translation>{0} ist zu groß</translation>
    </message>
    <message>
        <source>{0} is too large for a number in single precision</source>
        <translation>{0} ist zu groß für eine Zahl einfacher Genauigkeit</translation>
    </message>
    <message>
        <source>{0} knows no places below 0; this program goes to x {1}, y {2}: set zero = "corner" for the input, or xmin and ymin</source>
        <translation>{0} kennt keine Positionen unter 0; dieses Programm fährt bis x {1}, y {2}: zero = "corner" für die Eingabe setzen, oder xmin und ymin</translation>
    </message>
    <message>
        <source>{0} levels; from 1 to {1} are possible</source>
        <translation>{0} Stufen; möglich sind 1 bis {1}</translation>
    </message>
    <message>
        <source>{0} may only stand at a block's beginning</source>
        <translation>{0} darf nur am Satzanfang stehen</translation>
    </message>
    <message>
        <source>{0} million bricks; take larger cells</source>
        <translation>{0} Millionen Teilquader; größere Zellen verwenden</translation>
    </message>
    <message>
        <source>{0} mm are left over the target at ({1}, {2}, {3})</source>
        <translation>{0} mm bleiben über dem Ziel stehen bei ({1}, {2}, {3})</translation>
    </message>
    <message>
        <source>{0} mm divides the region into {1} cells a side; at most 2^24 are possible</source>
        <translation>{0} mm teilt den Bereich in {1} Zellen je Seite; möglich sind höchstens 2^24</translation>
    </message>
    <message>
        <source>{0} mm divides the region into {1} cells a side; at most {2} are possible</source>
        <translation>{0} mm teilt den Bereich in {1} Zellen je Seite; möglich sind höchstens {2}</translation>
    </message>
    <message>
        <source>{0} mm is too fine for coordinates of {1} mm in single precision</source>
        <translation>{0} mm ist zu fein für Koordinaten von {1} mm in einfacher Genauigkeit</translation>
    </message>
    <message>
        <source>{0} mm of the paths are left out: shank or holder would touch the part however the tool leans</source>
        <translation>{0} mm der Bahnen sind ausgelassen: Schaft oder Halter würden das Teil bei jeder Neigung berühren</translation>
    </message>
    <message>
        <source>{0} moves X, Y and Z only</source>
        <translation>{0} bewegt nur X, Y und Z</translation>
    </message>
    <message>
        <source>{0} moves the machine, but is not known here</source>
        <translation>{0} bewegt die Maschine, ist hier aber unbekannt</translation>
    </message>
    <message>
        <source>{0} must be a list of lists of numbers</source>
        <translation>{0} muss eine Liste von Zahlenlisten sein</translation>
    </message>
    <message>
        <source>{0} must be a list of numbers</source>
        <translation>{0} muss eine Liste von Zahlen sein</translation>
    </message>
    <message>
        <source>{0} must be a list of tables: [[{0}]]</source>
        <translation>{0} muss eine Liste von Tabellen sein: [[{0}]]</translation>
    </message>
    <message>
        <source>{0} must be a list of texts</source>
        <translation>{0} muss eine Liste von Texten sein</translation>
    </message>
    <message>
        <source>{0} must be a table: [{0}]</source>
        <translation>{0} muss eine Tabelle sein: [{0}]</translation>
    </message>
    <message>
        <source>{0} must be a value, not a table or a date</source>
        <translation>{0} muss ein Wert sein, keine Tabelle und kein Datum</translation>
    </message>
    <message>
        <source>{0} must be {1}</source>
        <translation>{0} muss {1} sein</translation>
    </message>
    <message>
        <source>{0} must not be negative</source>
        <translation>{0} darf nicht negativ sein</translation>
    </message>
    <message>
        <source>{0} needs D, the tool's diameter</source>
        <translation>{0} braucht D, den Werkzeugdurchmesser</translation>
    </message>
    <message>
        <source>{0} needs S</source>
        <translation>{0} braucht S</translation>
    </message>
    <message>
        <source>{0} needs a condition in brackets</source>
        <translation>{0} braucht eine Bedingung in Klammern</translation>
    </message>
    <message>
        <source>{0} needs a spindle that turns {1}</source>
        <translation>{0} braucht eine Spindel, die sich {1} dreht</translation>
    </message>
    <message>
        <source>{0} needs axis words</source>
        <translation>{0} braucht Achswörter</translation>
    </message>
    <message>
        <source>{0} needs {1}</source>
        <translation>{0} braucht: {1}</translation>
    </message>
    <message>
        <source>{0} needs {1} numbers</source>
        <translation>{0} braucht {1} Zahlen</translation>
    </message>
    <message>
        <source>{0} needs {1}, the hole's bottom</source>
        <translation>{0} braucht {1}, den Grund der Bohrung</translation>
    </message>
    <message>
        <source>{0} needs {1}, {2}</source>
        <translation>{0} braucht {1}, {2}</translation>
    </message>
    <message>
        <source>{0} numbers a pixel; one is wanted</source>
        <translation>{0} Zahlen je Pixel; verlangt ist eine</translation>
    </message>
    <message>
        <source>{0} numbers a sample; one is wanted</source>
        <translation>{0} Zahlen je Messpunkt; verlangt ist eine</translation>
    </message>
    <message>
        <source>{0} o{1} has no end</source>
        <translation>{0} o{1} hat kein Ende</translation>
    </message>
    <message>
        <source>{0} o{1} outside of such a loop</source>
        <translation>{0} o{1} außerhalb einer solchen Schleife</translation>
    </message>
    <message>
        <source>{0} o{1} where no subroutine was called</source>
        <translation>{0} o{1}, ohne dass ein Unterprogramm aufgerufen wurde</translation>
    </message>
    <message>
        <source>{0} o{1} where none has begun</source>
        <translation>{0} o{1} ohne zugehörigen Anfang</translation>
    </message>
    <message>
        <source>{0} parts do not fit on a sheet of {1} x {2} mm, {3} mm apart and {4} mm from its edges</source>
        <translation>{0} Teile passen mit {3} mm Abstand voneinander und {4} mm vom Rand nicht auf eine Platte von {1} x {2} mm</translation>
    </message>
    <message>
        <source>{0} pixels; from 1 to 16384 are possible</source>
        <translation>{0} Pixel; möglich sind 1 bis 16384</translation>
    </message>
    <message>
        <source>{0} pixels; from 16 to 16384 are possible</source>
        <translation>{0} Pixel; möglich sind 16 bis 16384</translation>
    </message>
    <message>
        <source>{0} repeats</source>
        <translation>{0} Wiederholungen</translation>
    </message>
    <message>
        <source>{0} samples along an axis; a solid needs two</source>
        <translation>{0} Messpunkte entlang einer Achse; ein Körper braucht zwei</translation>
    </message>
    <message>
        <source>{0} samples; from 1 to 4 are possible</source>
        <translation>{0} Abtastpunkte; möglich sind 1 bis 4</translation>
    </message>
    <message>
        <source>{0} samples; use larger cells</source>
        <translation>{0} Abtastpunkte; größere Zellen verwenden</translation>
    </message>
    <message>
        <source>{0} takes a {1}: it has no operations</source>
        <translation>{0} erwartet {1}: hier gibt es keine Operationen</translation>
    </message>
    <message>
        <source>{0} takes a {1}: the input must be a solid</source>
        <translation>{0} erwartet {1}: die Eingabe muss ein Körper sein</translation>
    </message>
    <message>
        <source>{0} takes {1} {2}, found {3}</source>
        <translation>{0} nimmt {1} {2}, gefunden: {3}</translation>
    </message>
    <message>
        <source>{0} values for {1} vertices</source>
        <translation>{0} Werte für {1} Eckpunkte</translation>
    </message>
    <message>
        <source>{0} while G68 is in force</source>
        <translation>{0} bei aktivem G68</translation>
    </message>
    <message>
        <source>{0} while the spindle stands still</source>
        <translation>{0} bei stehender Spindel</translation>
    </message>
    <message>
        <source>{0} with L{1}: repeats are 1 or more</source>
        <translation>{0} mit L{1}: mindestens 1 Wiederholung ist nötig</translation>
    </message>
    <message>
        <source>{0} with Q{1}: pecks are above 0</source>
        <translation>{0} mit Q{1}: die Zustelltiefe muss über 0 liegen</translation>
    </message>
    <message>
        <source>{0} with R below the hole's bottom</source>
        <translation>{0} mit R unter dem Grund der Bohrung</translation>
    </message>
    <message>
        <source>{0} with a dwell of {1} seconds</source>
        <translation>{0} mit unzulässiger Verweilzeit von {1} Sekunden</translation>
    </message>
    <message>
        <source>{0} with a speed of {1}</source>
        <translation>{0} mit unzulässiger Geschwindigkeit {1}</translation>
    </message>
    <message>
        <source>{0} would need {1} GB of memory, {2} GB are free</source>
        <translation>für {0} wären {1} GB Speicher nötig, frei sind {2} GB</translation>
    </message>
    <message>
        <source>{0} x {1} x {2} samples are more than there can be</source>
        <translation>{0} x {1} x {2} Messpunkte sind mehr als möglich</translation>
    </message>
    <message>
        <source>{0} x {1} x {2} samples; a solid needs two along each axis</source>
        <translation>{0} x {1} x {2} Messpunkte; ein Körper braucht zwei entlang jeder Achse</translation>
    </message>
    <message>
        <source>{0}: left out: {1}</source>
        <translation>{0}: ausgelassen: {1}</translation>
    </message>
    <message>
        <source>{0}: left out: {1} of another type than 'model'</source>
        <translation>{0}: ausgelassen: {1} von anderem Typ als 'model'</translation>
    </message>
    <message>
        <source>{0}: left out: {1} that the build does not place</source>
        <translation>{0}: ausgelassen, da von 'build' nicht platziert: {1}</translation>
    </message>
    <message>
        <source>{0}: nothing of it is left</source>
        <translation>{0}: davon bleibt nichts übrig</translation>
    </message>
    <message>
        <source>{0}: programs in JavaScript (TPL) are not run</source>
        <translation>{0}: Programme in JavaScript (TPL) werden nicht ausgeführt</translation>
    </message>
    <message>
        <source>{0}: the holder of tool {1} meets material at x {2}, y {3}, z {4} of the tip; the tool reaches {5} mm out of it</source>
        <translation>{0}: der Halter von Werkzeug {1} stößt an Material, wenn die Spitze bei x {2}, y {3}, z {4} steht; das Werkzeug ragt {5} mm aus ihm heraus</translation>
    </message>
    <message>
        <source>{0}: the solid is empty</source>
        <translation>{0}: der Körper ist leer</translation>
    </message>
    <message>
        <source>{0}: the solid is unbounded; give bounds = [x0, y0, z0, x1, y1, z1]</source>
        <translation>{0}: der Körper ist unbegrenzt; bounds = [x0, y0, z0, x1, y1, z1] angeben</translation>
    </message>
    <message>
        <source>{0}: there is nothing left to cut</source>
        <translation>{0}: es gibt nichts mehr zu fräsen</translation>
    </message>
    <message>
        <source>{0}: tool {1} is too short with flutes of {2} mm: along {3} mm of its way it stays up to {4} mm higher than planned; {5} mm3 are left, between ({6}, {7}, {8}) and ({9}, {10}, {11})</source>
        <translation>{0}: Werkzeug {1} ist mit Schneiden von {2} mm zu kurz: auf {3} mm seines Wegs bleibt es bis zu {4} mm höher als geplant; {5} mm3 bleiben stehen, zwischen ({6}, {7}, {8}) und ({9}, {10}, {11})</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>CAM</source>
        <translation>CAM</translation>
    </message>
    <message>
        <source>Fieldfab design</source>
        <translation>Fieldfab Entwurf</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Check and exchange</source>
        <translation>Prüfen und austauschen</translation>
    </message>
    <message>
        <source>Scans</source>
        <translation>Scans</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Fieldfab</source>
        <translation>Fieldfab</translation>
    </message>
</context>
</TS>
