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
        <source>What is done</source>
        <translation>Was getan wird</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>What it is done with</source>
        <translation>Womit es getan wird</translation>
    </message>
    <message>
        <source>Active</source>
        <translation>Aktiv</translation>
    </message>
    <message>
        <source>Whether it is done at all</source>
        <translation>Ob es überhaupt getan wird</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Werkstück</translation>
    </message>
    <message>
        <source>The solid to be made</source>
        <translation>Der Körper, der entstehen soll</translation>
    </message>
    <message>
        <source>Zero</source>
        <translation>Nullpunkt</translation>
    </message>
    <message>
        <source>The program's zero: as the model has it, or the corner or centre of the part's top</source>
        <translation>Der Nullpunkt des Programms: wie im Modell, oder Ecke oder Mitte der Oberseite des Werkstücks</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>What it is made with</source>
        <translation>Womit es gemacht wird</translation>
    </message>
    <message>
        <source>Stock From</source>
        <translation>Rohteil aus</translation>
    </message>
    <message>
        <source>Margins about the part, a box, or another object's box</source>
        <translation>Zugaben um das Werkstück, ein Quader oder der Hüllquader eines anderen Objekts</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Zugabe seitlich</translation>
    </message>
    <message>
        <source>At the part's sides</source>
        <translation>An den Seiten des Werkstücks</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Zugabe oben</translation>
    </message>
    <message>
        <source>Above the part</source>
        <translation>Über dem Werkstück</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>From its top down; 0: to the part's lowest place</source>
        <translation>Von seiner Oberseite nach unten; 0: bis zur tiefsten Stelle des Werkstücks</translation>
    </message>
    <message>
        <source>Stock Lower</source>
        <translation>Rohteil untere Ecke</translation>
    </message>
    <message>
        <source>Lower corner, in the document's coordinates</source>
        <translation>Untere Ecke, in den Koordinaten des Dokuments</translation>
    </message>
    <message>
        <source>Stock Upper</source>
        <translation>Rohteil obere Ecke</translation>
    </message>
    <message>
        <source>Upper corner, in the document's coordinates</source>
        <translation>Obere Ecke, in den Koordinaten des Dokuments</translation>
    </message>
    <message>
        <source>Stock Object</source>
        <translation>Rohteilobjekt</translation>
    </message>
    <message>
        <source>Its bounding box is the stock</source>
        <translation>Sein Hüllquader ist das Rohteil</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>The cutters</source>
        <translation>Die Fräser</translation>
    </message>
    <message>
        <source>Operations</source>
        <translation>Operationen</translation>
    </message>
    <message>
        <source>What is done, in order</source>
        <translation>Was getan wird, der Reihe nach</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Werkstoff</translation>
    </message>
    <message>
        <source>Defaults of the machine for a material</source>
        <translation>Vorgaben der Maschine für einen Werkstoff</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Where it is widest</source>
        <translation>Wo es am breitesten ist</translation>
    </message>
    <message>
        <source>Corner Radius</source>
        <translation>Eckradius</translation>
    </message>
    <message>
        <source>Of a bull-nose, or of the tip of a tapered ball</source>
        <translation>Eines Torusfräsers oder der Spitze eines konischen Kugelfräsers</translation>
    </message>
    <message>
        <source>Tip Diameter</source>
        <translation>Spitzendurchmesser</translation>
    </message>
    <message>
        <source>Of a V with a blunt tip</source>
        <translation>Eines V-Fräsers mit stumpfer Spitze</translation>
    </message>
    <message>
        <source>Flute</source>
        <translation>Schneidenlänge</translation>
    </message>
    <message>
        <source>Length that cuts; 0: not known</source>
        <translation>Länge, die schneidet; 0: unbekannt</translation>
    </message>
    <message>
        <source>Stick Out</source>
        <translation>Auskraglänge</translation>
    </message>
    <message>
        <source>From the tip to the holder; 0: not known</source>
        <translation>Von der Spitze bis zum Halter; 0: unbekannt</translation>
    </message>
    <message>
        <source>Shank</source>
        <translation>Schaft</translation>
    </message>
    <message>
        <source>Diameter above the flutes; 0: as the cutting part</source>
        <translation>Durchmesser über den Schneiden; 0: wie der schneidende Teil</translation>
    </message>
    <message>
        <source>Holder Diameter</source>
        <translation>Halterdurchmesser</translation>
    </message>
    <message>
        <source>0: not known</source>
        <translation>0: unbekannt</translation>
    </message>
    <message>
        <source>Holder Length</source>
        <translation>Halterlänge</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>Its place in the machine</source>
        <translation>Sein Platz in der Maschine</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Of its tip</source>
        <translation>Der Spitze</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Of the tip, from side to side</source>
        <translation>Der Spitze, von Seite zu Seite</translation>
    </message>
    <message>
        <source>Flutes</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Cutting edges</source>
        <translation>Zahl der Schneiden</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>Of cutting with it; 0: the material's or the operation's</source>
        <translation>Beim Fräsen damit; 0: der des Werkstoffs oder der Operation</translation>
    </message>
    <message>
        <source>Plunge</source>
        <translation>Eintauchvorschub</translation>
    </message>
    <message>
        <source>Into the material; 0: the material's or the operation's</source>
        <translation>In das Material hinein; 0: der des Werkstoffs oder der Operation</translation>
    </message>
    <message>
        <source>Spindle</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>Revolutions per minute; 0: the material's or the operation's</source>
        <translation>Umdrehungen je Minute; 0: die des Werkstoffs oder der Operation</translation>
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
        <source>Of a blend's fillet</source>
        <translation>Der Verrundung</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Of a morph: 0 is the first source, 1 the second</source>
        <translation>Eines Übergangs: 0 ist der erste Ausgangskörper, 1 der zweite</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Operation</translation>
    </message>
    <message>
        <source>What is made of the sources</source>
        <translation>Was aus den Ausgangskörpern wird</translation>
    </message>
    <message>
        <source>Given</source>
        <translation>Angegeben</translation>
    </message>
    <message>
        <source>The settings that are given; the others follow their defaults</source>
        <translation>Die angegebenen Einstellungen; die anderen folgen ihren Vorgaben</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>The file of the model: .frep text or a mesh</source>
        <translation>Die Datei des Modells: .frep-Text oder ein Netz</translation>
    </message>
    <message>
        <source>The part's name in the file; empty: all of the model</source>
        <translation>Der Name des Teils in der Datei; leer: das ganze Modell</translation>
    </message>
    <message>
        <source>Opened</source>
        <translation>Geöffnet</translation>
    </message>
    <message>
        <source>The files that the model opens, from its own folder</source>
        <translation>Die Dateien, die das Modell öffnet, von seinem Ordner aus</translation>
    </message>
    <message>
        <source>Followed Text</source>
        <translation>Befolgter Text</translation>
    </message>
    <message>
        <source>The text that the parameters were last taken from</source>
        <translation>Der Text, aus dem die Parameter zuletzt genommen wurden</translation>
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
        <source>Sizes and times of the files that it was made from</source>
        <translation>Größen und Zeiten der Dateien, aus denen es entstand</translation>
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
        <source>About how long the machine takes</source>
        <translation>Wie lange die Maschine etwa braucht</translation>
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
        <source>What each operation comes to</source>
        <translation>Was jede Operation ergibt</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>What one should know</source>
        <translation>Was man wissen sollte</translation>
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
        <source>What the machine gets, compressed</source>
        <translation>Was die Maschine bekommt, komprimiert</translation>
    </message>
    <message>
        <source>Packed Sheet</source>
        <translation>Einrichteblatt, komprimiert</translation>
    </message>
    <message>
        <source>An HTML page for the person at the machine, compressed</source>
        <translation>Eine HTML-Seite für den Menschen an der Maschine, komprimiert</translation>
    </message>
    <message>
        <source>Packed Moves</source>
        <translation>Bewegungen, komprimiert</translation>
    </message>
    <message>
        <source>All moves, as numpy writes them, compressed</source>
        <translation>Alle Bewegungen, wie numpy sie schreibt, komprimiert</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Abschnitte</translation>
    </message>
    <message>
        <source>What each operation's moves are made with, as JSON</source>
        <translation>Womit die Bewegungen jeder Operation gemacht werden, als JSON</translation>
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
        <source>Of the machine's file</source>
        <translation>Der Maschinendatei</translation>
    </message>
    <message>
        <source>Made From</source>
        <translation>Gemacht aus</translation>
    </message>
    <message>
        <source>What it was made from: it is planned anew when this changes</source>
        <translation>Woraus es gemacht wurde: Es wird neu geplant, wenn sich das ändert</translation>
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
        <source>Outwards; below 0 inwards</source>
        <translation>Nach außen; unter 0 nach innen</translation>
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
        <source>Edge of the lattice's cell</source>
        <translation>Kante der Gitterzelle</translation>
    </message>
    <message>
        <source>Strut</source>
        <translation>Stegdicke</translation>
    </message>
    <message>
        <source>Thickness of the lattice's walls</source>
        <translation>Dicke der Gitterwände</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>The mirror's normal, or the axis</source>
        <translation>Die Normale des Spiegels, oder die Achse</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>A point of the mirror or the axis</source>
        <translation>Ein Punkt des Spiegels oder der Achse</translation>
    </message>
    <message>
        <source>Keep Original</source>
        <translation>Original behalten</translation>
    </message>
    <message>
        <source>Both halves</source>
        <translation>Beide Hälften</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>From one copy to the next; of a transform, the way</source>
        <translation>Von einer Kopie zur nächsten; beim Umformen der Weg</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Copies, the original among them</source>
        <translation>Kopien, das Original eingerechnet</translation>
    </message>
    <message>
        <source>From the first copy to where the next round would begin</source>
        <translation>Von der ersten Kopie bis dorthin, wo die nächste Runde begänne</translation>
    </message>
    <message>
        <source>Factors</source>
        <translation>Faktoren</translation>
    </message>
    <message>
        <source>Along x, y and z</source>
        <translation>Entlang x, y und z</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>About the axis</source>
        <translation>Um die Achse</translation>
    </message>
    <message>
        <source>What is made of the source</source>
        <translation>Was aus dem Ausgangskörper wird</translation>
    </message>
    <message>
        <source>Lattice</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>What fills it</source>
        <translation>Was ihn füllt</translation>
    </message>
    <message>
        <source>Node</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>What OpenSCAD calls it</source>
        <translation>Wie OpenSCAD es nennt</translation>
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
        <source>Where the files are that the text names</source>
        <translation>Wo die Dateien sind, die der Text nennt</translation>
    </message>
    <message>
        <source>What it is made of</source>
        <translation>Woraus es entsteht</translation>
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
        <source>The mesh is reduced to about as many; above some thousands all that is done with the shape is slow</source>
        <translation>Das Netz wird auf etwa so viele verringert; über einigen Tausend wird alles langsam, was man mit der Form tut</translation>
    </message>
    <message>
        <source>Merge Faces</source>
        <translation>Flächen verschmelzen</translation>
    </message>
    <message>
        <source>Make one face of triangles that lie in a plane</source>
        <translation>Aus Dreiecken, die in einer Ebene liegen, eine Fläche machen</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Faces of the shape</source>
        <translation>Flächen der Form</translation>
    </message>
    <message>
        <source>Volume Change</source>
        <translation>Volumenänderung</translation>
    </message>
    <message>
        <source>How many percent the shape's volume is above the solid's</source>
        <translation>Um wie viel Prozent das Volumen der Form über dem des Körpers liegt</translation>
    </message>
    <message>
        <source>What the shape was made from: it is made anew when this changes</source>
        <translation>Woraus die Form gemacht wurde: Sie wird neu gemacht, wenn sich das ändert</translation>
    </message>
    <message>
        <source>Start Depth</source>
        <translation>Anfangstiefe</translation>
    </message>
    <message>
        <source>z where it begins to cut</source>
        <translation>z, wo das Fräsen beginnt</translation>
    </message>
    <message>
        <source>Final Depth</source>
        <translation>Endtiefe</translation>
    </message>
    <message>
        <source>Its lowest place</source>
        <translation>Die tiefste Stelle</translation>
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
        <source>Which of its operations; -1: all of them, as the machine's file says</source>
        <translation>Welche seiner Operationen; -1: alle, wie die Maschinendatei sagt</translation>
    </message>
    <message>
        <source>Tool Controller</source>
        <translation>Werkzeugsteuerung</translation>
    </message>
    <message>
        <source>What FreeCAD's job uses for it</source>
        <translation>Was FreeCADs Auftrag dafür nimmt</translation>
    </message>
    <message>
        <source>Whether FreeCAD's job takes it</source>
        <translation>Ob FreeCADs Auftrag es nimmt</translation>
    </message>
    <message>
        <source>Coolant Mode</source>
        <translation>Kühlung</translation>
    </message>
    <message>
        <source>While it cuts</source>
        <translation>Während es fräst</translation>
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
        <source>The same, from the document's folder</source>
        <translation>Dieselbe, vom Ordner des Dokuments aus</translation>
    </message>
    <message>
        <source>File Read</source>
        <translation>Gelesene Datei</translation>
    </message>
    <message>
        <source>Size and time of the file that the mesh was made from</source>
        <translation>Größe und Zeit der Datei, aus der das Netz gemacht wurde</translation>
    </message>
    <message>
        <source>File State</source>
        <translation>Zustand der Datei</translation>
    </message>
    <message>
        <source>Whether the file is there, and what it was when it was read</source>
        <translation>Ob die Datei da ist, und ob sie ist, was sie beim Lesen war</translation>
    </message>
    <message>
        <source>Auto Threshold</source>
        <translation>Automatische Schwelle</translation>
    </message>
    <message>
        <source>Solid is what is denser than halfway between the two commonest densities</source>
        <translation>Körper ist, was dichter ist als die Mitte zwischen den zwei häufigsten Dichten</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>Solid is what is denser than this, where it is not automatic</source>
        <translation>Körper ist, was dichter ist als dies, wo sie nicht automatisch ist</translation>
    </message>
    <message>
        <source>Below</source>
        <translation>Darunter</translation>
    </message>
    <message>
        <source>Solid is what is less dense</source>
        <translation>Körper ist, was weniger dicht ist</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstände</translation>
    </message>
    <message>
        <source>Distances of the samples along x, y and z, mm; 0 0 0: as the file says</source>
        <translation>Abstände der Messpunkte in x, y und z, mm; 0 0 0: wie die Datei sagt</translation>
    </message>
    <message>
        <source>Crop</source>
        <translation>Ausschnitt</translation>
    </message>
    <message>
        <source>First sample along x, y and z, then last; none: the whole volume</source>
        <translation>Erster Messpunkt in x, y und z, dann letzter; keiner: das ganze Volumen</translation>
    </message>
    <message>
        <source>Denoise</source>
        <translation>Entrauschen</translation>
    </message>
    <message>
        <source>Filter against noise</source>
        <translation>Filter gegen Rauschen</translation>
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
        <source>Smaller pieces go</source>
        <translation>Kleinere Stücke fallen weg</translation>
    </message>
    <message>
        <source>Smallest Hole</source>
        <translation>Kleinstes Loch</translation>
    </message>
    <message>
        <source>Smaller cavities are filled</source>
        <translation>Kleinere Hohlräume werden gefüllt</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Messpunkte</translation>
    </message>
    <message>
        <source>Samples along x, y and z; none: as the file or its name says</source>
        <translation>Messpunkte in x, y und z; keine: wie die Datei oder ihr Name sagt</translation>
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
        <source>Of a DICOM folder with several series: which</source>
        <translation>Eines DICOM-Ordners mit mehreren Serien: welche</translation>
    </message>
    <message>
        <source>Program File</source>
        <translation>Programmdatei</translation>
    </message>
    <message>
        <source>The machine's program: G-code, .sbp, .rml, .hpgl</source>
        <translation>Das Programm der Maschine: G-Code, .sbp, .rml, .hpgl</translation>
    </message>
    <message>
        <source>An object that has a program: a machine program, a Path operation or Job. Then there is no file</source>
        <translation>Ein Objekt, das ein Programm hat: ein Maschinenprogramm, eine Path-Operation oder ein Path-Auftrag. Dann gibt es keine Datei</translation>
    </message>
    <message>
        <source>Dialect</source>
        <translation>Dialekt</translation>
    </message>
    <message>
        <source>How its G-code is read; the machine of the set-up decides where nothing is chosen</source>
        <translation>Wie der G-Code gelesen wird; wenn nichts gewählt ist, bestimmt es die Maschine der Aufspannung</translation>
    </message>
    <message>
        <source>Setup File</source>
        <translation>Aufspanndatei</translation>
    </message>
    <message>
        <source>A set-up or job file (docs/simulation.md); none: what the properties below say</source>
        <translation>Eine Aufspann- oder Auftragsdatei (docs/simulation.md); keine: was die Eigenschaften darunter sagen</translation>
    </message>
    <message>
        <source>A tool a line, as JSON: number, shape, diameter, flute, length, shank, holder_diameter, ...</source>
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
        <source>A machine program of the document, whose set-up a program file is carried out in: machine, tools, stock, part</source>
        <translation>Ein Maschinenprogramm des Dokuments, in dessen Aufspannung eine Programmdatei ausgeführt wird: Maschine, Werkzeuge, Rohteil, Werkstück</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Rohteil</translation>
    </message>
    <message>
        <source>The stock as a solid: what an earlier simulation left, say. Then the corners do not count</source>
        <translation>Das Rohteil als Körper: etwa was eine frühere Simulation übrig ließ. Dann zählen die Ecken nicht</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>What should come out: any solid</source>
        <translation>Was herauskommen soll: ein beliebiger Körper</translation>
    </message>
    <message>
        <source>Gouge</source>
        <translation>Verletzung</translation>
    </message>
    <message>
        <source>Deeper cuts into the target are faults</source>
        <translation>Tiefere Schnitte in das Ziel sind Fehler</translation>
    </message>
    <message>
        <source>Excess</source>
        <translation>Restmaterial</translation>
    </message>
    <message>
        <source>More than this left over it is a fault; 0: any amount may be left</source>
        <translation>Mehr als dies darüber ist ein Fehler; 0: Es darf beliebig viel übrig bleiben</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Berührung</translation>
    </message>
    <message>
        <source>Contacts of less than this depth are none</source>
        <translation>Kollisionen, die weniger tief sind, zählen nicht</translation>
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
        <source>Distance of samples; 0 means automatic: a 300th of the stock, at most 0.2 mm</source>
        <translation>Abstand der Messpunkte; 0 heißt automatisch: ein 300stel des Rohteils, höchstens 0,2 mm</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>What came of it</source>
        <translation>Was dabei herauskam</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>What went wrong, worst first: a JSON object a line</source>
        <translation>Was schiefging, das Schlimmste zuerst: ein JSON-Objekt je Zeile</translation>
    </message>
    <message>
        <source>What the program's reader passed over</source>
        <translation>Was beim Lesen des Programms übergangen wurde</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>Abgetragen</translation>
    </message>
    <message>
        <source>Material removed</source>
        <translation>Abgetragenes Material</translation>
    </message>
    <message>
        <source>On the machine</source>
        <translation>Auf der Maschine</translation>
    </message>
    <message>
        <source>Rapid Seconds</source>
        <translation>Eilgangsekunden</translation>
    </message>
    <message>
        <source>Of them rapids</source>
        <translation>Davon Eilgänge</translation>
    </message>
    <message>
        <source>Air Share</source>
        <translation>Luftanteil</translation>
    </message>
    <message>
        <source>Share of the feed that meets no material</source>
        <translation>Anteil des Vorschubs, der auf kein Material trifft</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Kollisionen</translation>
    </message>
    <message>
        <source>Lines that touch what they must not</source>
        <translation>Zeilen, die berühren, was sie nicht dürfen</translation>
    </message>
    <message>
        <source>Gouges</source>
        <translation>Verletzungen</translation>
    </message>
    <message>
        <source>Lines that cut into the target</source>
        <translation>Zeilen, die in das Ziel schneiden</translation>
    </message>
    <message>
        <source>Over Travels</source>
        <translation>Überschrittene Verfahrwege</translation>
    </message>
    <message>
        <source>Lines that leave the machine's limits</source>
        <translation>Zeilen, die die Grenzen der Maschine verlassen</translation>
    </message>
    <message>
        <source>Deepest Gouge</source>
        <translation>Tiefste Verletzung</translation>
    </message>
    <message>
        <source>Of all the surface</source>
        <translation>Der ganzen Oberfläche</translation>
    </message>
    <message>
        <source>Highest Excess</source>
        <translation>Höchstes Restmaterial</translation>
    </message>
    <message>
        <source>The machine that carries it out</source>
        <translation>Die Maschine, die es ausführt</translation>
    </message>
    <message>
        <source>Voxel Size</source>
        <translation>Zellgröße</translation>
    </message>
    <message>
        <source>Edge of the smallest cell; 0 means automatic: a scan's own, else by the preferences' cells along the longest side. OpenSCAD's flat faces need no cells</source>
        <translation>Kante der kleinsten Zelle; 0 heißt automatisch: die eines Scans, sonst nach den Zellen entlang der längsten Seite in den Einstellungen. Ebene Flächen aus OpenSCAD brauchen keine Zellen</translation>
    </message>
    <message>
        <source>Max Error</source>
        <translation>Größter Fehler</translation>
    </message>
    <message>
        <source>How far the mesh may be from the solid; 0 means a tenth of the smallest cell</source>
        <translation>Wie weit das Netz vom Körper abweichen darf; 0 heißt ein Zehntel der kleinsten Zelle</translation>
    </message>
    <message>
        <source>Only When Shown</source>
        <translation>Nur wenn sichtbar</translation>
    </message>
    <message>
        <source>While it is hidden, and only other solids are made of it, it gets no mesh</source>
        <translation>Solange es verborgen ist und nur andere Körper daraus entstehen, bekommt es kein Netz</translation>
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
        <source>Lower corner of the region, where bounds are not found</source>
        <translation>Untere Ecke des Bereichs, wo die Grenzen nicht gesucht werden</translation>
    </message>
    <message>
        <source>Upper</source>
        <translation>Obere Ecke</translation>
    </message>
    <message>
        <source>Upper corner of the region, where bounds are not found</source>
        <translation>Obere Ecke des Bereichs, wo die Grenzen nicht gesucht werden</translation>
    </message>
    <message>
        <source>Certainty</source>
        <translation>Sicherheit</translation>
    </message>
    <message>
        <source>Whether it is proved that the mesh shows all of the solid, else where it is not; empty for a mesh of an earlier version</source>
        <translation>Ob bewiesen ist, dass das Netz den ganzen Körper zeigt, sonst wo nicht; leer bei einem Netz einer früheren Version</translation>
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
        <source>Surface of the mesh</source>
        <translation>Oberfläche des Netzes</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Triangles of the mesh</source>
        <translation>Dreiecke des Netzes</translation>
    </message>
    <message>
        <source>What the mesh was made from: it is made anew when this changes</source>
        <translation>Woraus das Netz gemacht wurde: Es wird neu gemacht, wenn sich das ändert</translation>
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
        <source>How far triangles may be from a Part shape; 0 means 1/2000 of its size</source>
        <translation>Wie weit Dreiecke von einer Part-Form abweichen dürfen; 0 heißt 1/2000 ihrer Größe</translation>
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
        <source>Of the circle or sphere</source>
        <translation>Des Kreises oder der Kugel</translation>
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
        <source>Sides of a circle; 0: by Fa and Fs</source>
        <translation>Seiten eines Kreises; 0: nach Fa und Fs</translation>
    </message>
    <message>
        <source>Fa</source>
        <translation>Fa</translation>
    </message>
    <message>
        <source>Least angle that a side of a circle spans</source>
        <translation>Kleinster Winkel, den eine Seite eines Kreises überspannt</translation>
    </message>
    <message>
        <source>Fs</source>
        <translation>Fs</translation>
    </message>
    <message>
        <source>Least length of a side of a circle</source>
        <translation>Kleinste Länge einer Seite eines Kreises</translation>
    </message>
    <message>
        <source>Bottom Radius</source>
        <translation>Unterer Radius</translation>
    </message>
    <message>
        <source>Of the lower circle</source>
        <translation>Des unteren Kreises</translation>
    </message>
    <message>
        <source>Top Radius</source>
        <translation>Oberer Radius</translation>
    </message>
    <message>
        <source>Of the upper circle</source>
        <translation>Des oberen Kreises</translation>
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
        <source>The corners of each face, clockwise from outside, counted from 0</source>
        <translation>Die Ecken jeder Fläche, von außen im Uhrzeigersinn, von 0 an gezählt</translation>
    </message>
    <message>
        <source>Paths</source>
        <translation>Umrisse</translation>
    </message>
    <message>
        <source>The corners of each outline, counted from 0; none: all in their order</source>
        <translation>Die Ecken jedes Umrisses, von 0 an gezählt; keine: alle in ihrer Reihenfolge</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>Worte</translation>
    </message>
    <message>
        <source>What is written</source>
        <translation>Was geschrieben steht</translation>
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
        <source>Its name, and style=...</source>
        <translation>Ihr Name und style=...</translation>
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
        <source>Of letters; 1 is usual</source>
        <translation>Der Buchstaben; 1 ist üblich</translation>
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
        <source>Of the words: en, de, ...</source>
        <translation>Der Worte: en, de, ...</translation>
    </message>
    <message>
        <source>Script</source>
        <translation>Schriftsystem</translation>
    </message>
    <message>
        <source>Of the words: Latn, ...</source>
        <translation>Der Worte: Latn, ...</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Verdrehung</translation>
    </message>
    <message>
        <source>From the lower to the upper end</source>
        <translation>Vom unteren zum oberen Ende</translation>
    </message>
    <message>
        <source>Scale X</source>
        <translation>Faktor X</translation>
    </message>
    <message>
        <source>Of the upper end along x</source>
        <translation>Des oberen Endes entlang x</translation>
    </message>
    <message>
        <source>Scale Y</source>
        <translation>Faktor Y</translation>
    </message>
    <message>
        <source>Of the upper end along y</source>
        <translation>Des oberen Endes entlang y</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Scheiben</translation>
    </message>
    <message>
        <source>Of what is twisted or scaled; 0: by Fn, Fa and Fs</source>
        <translation>Von Verdrehtem oder Verjüngtem; 0: nach Fn, Fa und Fs</translation>
    </message>
    <message>
        <source>Of the turn, from the x axis</source>
        <translation>Der Drehung, von der x-Achse an</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>What lies at z = 0, not the shadow</source>
        <translation>Was bei z = 0 liegt, nicht der Schatten</translation>
    </message>
    <message>
        <source>Chamfered</source>
        <translation>Gefast</translation>
    </message>
    <message>
        <source>Corners are cut off</source>
        <translation>Ecken werden abgeschnitten</translation>
    </message>
    <message>
        <source>New Length</source>
        <translation>Neue Länge</translation>
    </message>
    <message>
        <source>Along x; 0: as it is</source>
        <translation>Entlang x; 0: wie sie ist</translation>
    </message>
    <message>
        <source>New Width</source>
        <translation>Neue Breite</translation>
    </message>
    <message>
        <source>Along y; 0: as it is</source>
        <translation>Entlang y; 0: wie sie ist</translation>
    </message>
    <message>
        <source>New Height</source>
        <translation>Neue Höhe</translation>
    </message>
    <message>
        <source>Along z; 0: as it is</source>
        <translation>Entlang z; 0: wie sie ist</translation>
    </message>
    <message>
        <source>Auto Length</source>
        <translation>Länge im Verhältnis</translation>
    </message>
    <message>
        <source>Where NewLength is 0: in proportion</source>
        <translation>Wo NewLength 0 ist: im Verhältnis</translation>
    </message>
    <message>
        <source>Auto Width</source>
        <translation>Breite im Verhältnis</translation>
    </message>
    <message>
        <source>Where NewWidth is 0: in proportion</source>
        <translation>Wo NewWidth 0 ist: im Verhältnis</translation>
    </message>
    <message>
        <source>Auto Height</source>
        <translation>Höhe im Verhältnis</translation>
    </message>
    <message>
        <source>Where NewHeight is 0: in proportion</source>
        <translation>Wo NewHeight 0 ist: im Verhältnis</translation>
    </message>
    <message>
        <source>Matrix</source>
        <translation>Matrix</translation>
    </message>
    <message>
        <source>Where the children are put</source>
        <translation>Wohin die Kinder gestellt werden</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Of a .dxf file; none: all</source>
        <translation>Einer .dxf-Datei; keine: alle</translation>
    </message>
    <message>
        <source>Origin X</source>
        <translation>Ursprung X</translation>
    </message>
    <message>
        <source>Of a .dxf file's drawing</source>
        <translation>Der Zeichnung einer .dxf-Datei</translation>
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
        <source>Of a .dxf or .svg file's drawing</source>
        <translation>Der Zeichnung einer .dxf- oder .svg-Datei</translation>
    </message>
    <message>
        <source>Dpi</source>
        <translation>Dpi</translation>
    </message>
    <message>
        <source>Dots of an .svg file to an inch</source>
        <translation>Punkte einer .svg-Datei auf einen Zoll</translation>
    </message>
    <message>
        <source>Inverted</source>
        <translation>Umgekehrt</translation>
    </message>
    <message>
        <source>Of a picture: dark is high</source>
        <translation>Eines Bildes: Dunkles ist hoch</translation>
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
        <source>FreeCAD's start page follows when it is opened the next time</source>
        <translation>FreeCADs Startseite folgt, wenn sie das nächste Mal geöffnet wird</translation>
    </message>
    <message>
        <source>it ended without an answer</source>
        <translation>es endete ohne Antwort</translation>
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
        <source>{filename}: nothing that was chosen bounds a solid</source>
        <translation>{filename}: Nichts von dem Gewählten begrenzt einen Körper</translation>
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
        <source>{label} has no solid: faces and wires bound nothing</source>
        <translation>{label} hat keinen Körper: Flächen und Drähte begrenzen nichts</translation>
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
        <source>{label}: nothing is planned yet</source>
        <translation>{label}: Es ist noch nichts geplant</translation>
    </message>
    <message>
        <source>{label}: choose a Setup</source>
        <translation>{label}: Aufspannung wählen</translation>
    </message>
    <message>
        <source>{label}: cancelled; it is still what it was</source>
        <translation>{label}: abgebrochen; es ist noch, was es war</translation>
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
        <source>{label}: {source} has failed; the shape is still what it was</source>
        <translation>{label}: {source} ist fehlgeschlagen; die Form ist noch, was sie war</translation>
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
        <source>{label}: its tool leans now: make its path anew</source>
        <translation>{label}: Das Werkzeug ist jetzt geneigt: den Pfad neu anlegen</translation>
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
        <source>{label}: the scan {path} is {state}; the mesh is what it was</source>
        <translation>{label}: Der Scan {path}: {state}; das Netz ist, was es war</translation>
    </message>
    <message>
        <source>a tool is like {example}, not {line!r}</source>
        <translation>ein Werkzeug sieht aus wie {example}, nicht wie {line!r}</translation>
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
        <source>{label} was not carried out yet</source>
        <translation>{label} wurde noch nicht ausgeführt</translation>
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
        <source>{filename}: too large for a tree of {most} parts; whole branches are one object each, with their text: {count}</source>
        <translation>{filename}: zu groß für einen Baum aus {most} Teilen; ganze Äste sind je ein Objekt mit ihrem Text: {count}</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Operation</translation>
    </message>
    <message>
        <source>CAM job</source>
        <translation>CAM-Job</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Werkstück</translation>
    </message>
    <message>
        <source>Zero</source>
        <translation>Nullpunkt</translation>
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
        <source>Plans all paths; the window stays free meanwhile</source>
        <translation>Plant alle Bahnen; das Fenster bleibt dabei frei</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>What is to be made, and where the program's zero is on it</source>
        <translation>Was entstehen soll, und wo darauf der Nullpunkt des Programms liegt</translation>
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
        <source>stopped; the program is still what it was</source>
        <translation>angehalten; das Programm ist noch, was es war</translation>
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
        <source>Measured, and its bound</source>
        <translation>Gemessen, und die Schranke</translation>
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
        <source>{name} of the text: a property of the object, too</source>
        <translation>{name} aus dem Text: auch eine Eigenschaft des Objekts</translation>
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
        <source>{count} operations</source>
        <translation>{count} Rechenschritte</translation>
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
        <source>left out, it is {default}</source>
        <translation>fehlt es, gilt {default}</translation>
    </message>
    <message>
        <source>How many samples have which density, on a logarithmic scale. Drag the line to move the threshold</source>
        <translation>Wie viele Messpunkte welche Dichte haben, in logarithmischem Maßstab. Die Linie ziehen, um die Schwelle zu verschieben</translation>
    </message>
    <message>
        <source>no densities yet</source>
        <translation>noch keine Dichten</translation>
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
        <source>How much faster than the machine</source>
        <translation>Wie viel schneller als die Maschine</translation>
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
        <source>Show what must not touch anything</source>
        <translation>Zeigen, was nichts berühren darf</translation>
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
        <source>Show the stock as the machine's table turns it</source>
        <translation>Das Rohteil so zeigen, wie der Tisch der Maschine es dreht</translation>
    </message>
    <message>
        <source>Show the stock as it is at this moment</source>
        <translation>Das Rohteil zeigen, wie es in diesem Augenblick ist</translation>
    </message>
    <message>
        <source>Show the part that should come out</source>
        <translation>Das Werkstück zeigen, das entstehen soll</translation>
    </message>
    <message>
        <source>Paths</source>
        <translation>Bahnen</translation>
    </message>
    <message>
        <source>Show where the tools' tips go, each tool in its colour</source>
        <translation>Zeigen, wohin die Werkzeugspitzen fahren, jedes Werkzeug in seiner Farbe</translation>
    </message>
    <message>
        <source>To the beginning</source>
        <translation>Zum Anfang</translation>
    </message>
    <message>
        <source>Back by one move</source>
        <translation>Eine Bewegung zurück</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Abspielen oder anhalten</translation>
    </message>
    <message>
        <source>On by one move</source>
        <translation>Eine Bewegung weiter</translation>
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
        <source>nothing has cut this place</source>
        <translation>diese Stelle hat nichts geschnitten</translation>
    </message>
    <message>
        <source>line {line}: {message}</source>
        <translation>Zeile {line}: {message}</translation>
    </message>
    <message>
        <source>Where axis {letter} stands, {unit}</source>
        <translation>Stand der Achse {letter}, {unit}</translation>
    </message>
    <message>
        <source>line {line} cut this place, with tool {tool}</source>
        <translation>Zeile {line} hat diese Stelle geschnitten, mit Werkzeug {tool}</translation>
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
        <source>The program. Click a line to go to where it is done</source>
        <translation>Das Programm. Ein Klick auf eine Zeile geht dorthin, wo sie ausgeführt wird</translation>
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
        <source>Halfway between the two commonest densities, air and material</source>
        <translation>In der Mitte zwischen den zwei häufigsten Dichten, Luft und Material</translation>
    </message>
    <message>
        <source>What is less dense than the threshold is solid</source>
        <translation>Was weniger dicht ist als die Schwelle, ist Körper</translation>
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
        <source>Smaller pieces go</source>
        <translation>Kleinere Stücke fallen weg</translation>
    </message>
    <message>
        <source>Smaller cavities are filled</source>
        <translation>Kleinere Hohlräume werden gefüllt</translation>
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
        <source>The last sample of a crop must lie behind the first.</source>
        <translation>Der letzte Messpunkt eines Ausschnitts muss hinter dem ersten liegen.</translation>
    </message>
    <message>
        <source>Nothing is solid at this threshold.</source>
        <translation>Bei dieser Schwelle bleibt kein Körper.</translation>
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
        <source>A distance field: it is taken as it is.</source>
        <translation>Ein Abstandsfeld: Es wird genommen, wie es ist.</translation>
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
        <source>none: a file, or as below</source>
        <translation>keine: eine Datei oder wie unten</translation>
    </message>
    <message>
        <source>none: as below</source>
        <translation>keine: wie unten</translation>
    </message>
    <message>
        <source>Set-ups and jobs (*.toml)</source>
        <translation>Aufspannungen und Aufträge (*.toml)</translation>
    </message>
    <message>
        <source>none, or the set-up's</source>
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
        <source>A box about all places that the program names</source>
        <translation>Ein Quader um alle Stellen, die das Programm nennt</translation>
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
        <source>Simulation</source>
        <translation>Simulation</translation>
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
        <source>stopped; it is still what it was</source>
        <translation>angehalten; es ist noch, was es war</translation>
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
        <source>⌀ {unit}</source>
        <translation>⌀ {unit}</translation>
    </message>
    <message>
        <source>a diameter must be above 0</source>
        <translation>ein Durchmesser muss über 0 liegen</translation>
    </message>
    <message>
        <source>FreeCAD's tool bits and libraries (*.fctb *.fctl)</source>
        <translation>FreeCADs Werkzeuge und Werkzeugbibliotheken (*.fctb *.fctl)</translation>
    </message>
    <message>
        <source>A new end mill</source>
        <translation>Ein neuer Schaftfräser</translation>
    </message>
    <message>
        <source>From file…</source>
        <translation>Aus Datei …</translation>
    </message>
    <message>
        <source>Tool bits (.fctb) or libraries (.fctl) of FreeCAD</source>
        <translation>Werkzeuge (.fctb) oder Werkzeugbibliotheken (.fctl) von FreeCAD</translation>
    </message>
    <message>
        <source>The chosen tool</source>
        <translation>Das gewählte Werkzeug</translation>
    </message>
    <message>
        <source>there is a tool {number} already</source>
        <translation>es gibt schon ein Werkzeug {number}</translation>
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
        <source>{label}: no machine of ours is known to turn {letters}: say which it is</source>
        <translation>{label}: Keine unserer Maschinen dreht bekanntermaßen {letters}: angeben, welche es ist</translation>
    </message>
    <message>
        <source>{label}: no active operation has a path</source>
        <translation>{label}: Keine aktive Operation hat einen Pfad</translation>
    </message>
    <message>
        <source>{label}: its path is turned by its Placement, which a program cannot say</source>
        <translation>{label}: Der Pfad ist durch seine Platzierung gedreht, was ein Programm nicht sagen kann</translation>
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
        <source>Designs</source>
        <translation>Entwürfe</translation>
    </message>
    <message>
        <source>{name}: a {shape} is no cutter that Fieldfab knows</source>
        <translation>{name}: {shape} ist kein Fräser, den Fieldfab kennt</translation>
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
        <source>As it will be</source>
        <translation>So wird es</translation>
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
        <source>No solid is seen that could be cut</source>
        <translation>Kein Körper ist zu sehen, der geschnitten werden könnte</translation>
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
        <source>How fine solids are where their VoxelSize is 0. Twice as many cells: about four times the triangles and the time.</source>
        <translation>Wie fein Körper sind, deren VoxelSize 0 ist. Doppelt so viele Zellen: etwa viermal so viele Dreiecke und viermal so viel Zeit.</translation>
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
        <source>Adds an operation at the end of the selected job, or of the document's only one. The panel asks what is done, with which tool, and for the settings of each stage; what is left empty follows its default.</source>
        <translation>Hängt eine Operation, etwa Schruppen oder Schlichten, an den ausgewählten oder den einzigen Job des Dokuments an. Das Aufgabenfenster fragt, was mit welchem Werkzeug getan wird, und nach den Einstellungen jeder Stufe; was leer bleibt, folgt seiner Vorgabe.</translation>
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
        <source>Checks one selected solid against OpenVDB and CGAL beside the window, and shows each figure with its bound. The mesh takes the colours of its deviations until the panel is closed; nothing of the document is changed.</source>
        <translation>Prüft einen ausgewählten Körper neben dem Fenster gegen OpenVDB und CGAL und zeigt jede Zahl mit ihrer Schranke. Das Netz nimmt die Farben seiner Abweichungen an, bis das Aufgabenfenster geschlossen wird; am Dokument ändert sich nichts.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_Difference</name>
    <message>
        <source>Difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>Take the other selected solids out of the first</source>
        <translation>Die anderen ausgewählten Körper vom ersten abziehen</translation>
    </message>
    <message>
        <source>Makes a solid of the first one that was selected, without all the others. Their order can be changed in the panel by dragging.</source>
        <translation>Macht einen Körper aus dem zuerst ausgewählten, ohne alle anderen. Ihre Reihenfolge lässt sich im Aufgabenfenster durch Ziehen ändern.</translation>
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
        <source>Opens a copy of an example: a knob, a set-up that clears it and finishes it with a ball cutter that leans along the surface, and the planned program. A double-click on the set-up shows its stages.</source>
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
        <source>Show copies of the examples on FreeCAD's start page, or take them away</source>
        <translation>Kopien der Beispiele auf FreeCADs Startseite zeigen oder sie wegnehmen</translation>
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
        <source>Asks for a CT volume's file, or any slice of a stack, and makes a solid of it. The panel shows the histogram and asks for the threshold, the part that is kept and the clean-up; the whole volume is computed at its OK only.</source>
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
        <source>Keep what all selected solids share</source>
        <translation>Behalten, was alle ausgewählten Körper gemeinsam haben</translation>
    </message>
    <message>
        <source>Makes a solid of what two or more others have in common. Select solids, meshes, Part objects or bodies; the panel lists them.</source>
        <translation>Macht einen Körper aus dem, was zwei oder mehr andere gemeinsam haben. Körper, Netze, Part-Objekte oder Bodys auswählen; das Aufgabenfenster führt sie auf.</translation>
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
        <source>Copies of the selected solid in a row</source>
        <translation>Kopien des ausgewählten Körpers in einer Reihe</translation>
    </message>
    <message>
        <source>Makes one solid of copies of the selected one in a row. The panel asks for the way from one to the next and for their number.</source>
        <translation>Macht einen Körper aus Kopien des ausgewählten in einer Reihe. Das Aufgabenfenster fragt nach dem Weg von einer zur nächsten und nach ihrer Zahl.</translation>
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
        <source>Make what lies between two selected solids</source>
        <translation>Machen, was zwischen zwei ausgewählten Körpern liegt</translation>
    </message>
    <message>
        <source>Makes a solid between two others. Select both; the panel asks for the weight: 0 is the first, 1 the second.</source>
        <translation>Macht einen Körper zwischen zwei anderen. Beide auswählen; das Aufgabenfenster fragt nach dem Gewicht: 0 ist der erste, 1 der zweite.</translation>
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
        <source>Adds a job that machines the selected solid, mesh, Part object or body. The panel asks for the stock, the tools, the operations in order and the machine, and plans all paths beside the window.</source>
        <translation>Legt einen Job an, in dem der ausgewählte Körper, das Netz, Part-Objekt oder der Body gefräst wird. Das Aufgabenfenster fragt nach Rohteil, Werkzeugen, Operationen der Reihe nach und Maschine und plant alle Bahnen neben dem Fenster.</translation>
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
        <source>Copies of the selected solid around an axis</source>
        <translation>Kopien des ausgewählten Körpers um eine Achse</translation>
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
        <source>Cut what the view shows, to see what is inside, or show it whole again</source>
        <translation>Schneiden, was die Ansicht zeigt, um ins Innere zu sehen, oder es wieder ganz zeigen</translation>
    </message>
    <message>
        <source>Cuts all solids of the view, and what panels show (scans, the stock of a simulation), across the axis that points most to you; cut faces are orange. Drag the handle on the plane to move it. Choose it again to see all; nothing of the document is changed.</source>
        <translation>Schneidet alle Körper der Ansicht und was Aufgabenfenster zeigen (Scans, das Rohteil einer Simulation) quer zu der Achse, die am meisten auf den Betrachter zeigt; Schnittflächen sind orange. Ziehen am Griff verschiebt die Ebene. Noch einmal wählen zeigt wieder alles; am Dokument ändert sich nichts.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_SetupSheet</name>
    <message>
        <source>Set-up sheet</source>
        <translation>Einrichteblatt</translation>
    </message>
    <message>
        <source>Show the page for the person at the machine</source>
        <translation>Die Seite für den Menschen an der Maschine zeigen</translation>
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
        <source>Makes a hollow solid of the selected one; its outside stays. The panel asks for the wall's thickness.</source>
        <translation>Macht aus dem ausgewählten Körper einen hohlen; außen bleibt er, wie er ist. Das Aufgabenfenster fragt nach der Dicke der Wand.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_ShowUncertainPlaces</name>
    <message>
        <source>Show uncertain places</source>
        <translation>Unsichere Stellen zeigen</translation>
    </message>
    <message>
        <source>Show where the selected solid's mesh may lack parts of it, or hide these places again</source>
        <translation>Zeigen, wo dem Netz des ausgewählten Körpers Teile fehlen können, oder diese Stellen wieder verbergen</translation>
    </message>
    <message>
        <source>Draws a box around each place where it is not proved that the mesh shows all of the selected solid, and zooms to the largest. Choose it again to take the boxes away. It cannot be chosen where the mesh is certain; smaller cells leave fewer and smaller places.</source>
        <translation>Zeichnet einen Quader um jede Stelle, an der nicht bewiesen ist, dass das Netz den ganzen ausgewählten Körper zeigt, und zoomt auf die größte. Noch einmal gewählt, nimmt es die Quader wieder weg. Wo das Netz sicher ist, lässt es sich nicht wählen; kleinere Zellen lassen weniger und kleinere Stellen übrig.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_SimulateProgram</name>
    <message>
        <source>Simulate program</source>
        <translation>Programm simulieren</translation>
    </message>
    <message>
        <source>Carry out a machine's program on a stock: of a file, or of the selected Path operation, Job or machine program</source>
        <translation>Das Programm einer Maschine an einem Rohteil ausführen: aus einer Datei oder von der ausgewählten Path-Operation, dem Path-Auftrag oder Maschinenprogramm</translation>
    </message>
    <message>
        <source>Carries a machine's program out on a stock and plays it in the 3D view. Select a machine program, a Path operation or a Job, or name a file in the panel, which also asks for the stock, the tools, the machine and what should come out.</source>
        <translation>Führt das Programm einer Maschine an einem Rohteil aus und spielt es in der 3D-Ansicht ab. Ein Maschinenprogramm, eine Path-Operation oder einen Path-Auftrag auswählen, oder im Aufgabenfenster eine Datei nennen; es fragt auch nach Rohteil, Werkzeugen, Maschine und dem, was herauskommen soll.</translation>
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
        <source>Makes a solid where a mesh, a Part object or a body is, and follows it. Select the object first. Holes and overlaps of a mesh do no harm; the panel asks how far triangles may be from a Part shape.</source>
        <translation>Macht einen Körper dort, wo ein Netz, ein Part-Objekt oder ein Body ist, und folgt ihm. Zuerst das Objekt auswählen. Löcher und Überschneidungen eines Netzes schaden nicht; das Aufgabenfenster fragt, wie weit Dreiecke von einer Part-Form abweichen dürfen.</translation>
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
        <source>Make a Part shape that follows the selected solid, reduced to some thousand flat faces</source>
        <translation>Eine Part-Form machen, die dem ausgewählten Körper folgt, auf einige Tausend ebene Flächen verringert</translation>
    </message>
    <message>
        <source>Makes an object for Part, Part Design and TechDraw that follows each selected solid. Its faces are flat: the mesh is reduced to the number of triangles that its property MostTriangles says.</source>
        <translation>Macht ein Objekt für Part, Part Design und TechDraw, das jedem ausgewählten Körper folgt. Seine Flächen sind eben: Das Netz wird auf so viele Dreiecke verringert, wie seine Eigenschaft MostTriangles sagt.</translation>
    </message>
</context>
<context>
    <name>Fieldfab_ToPath</name>
    <message>
        <source>To Path job</source>
        <translation>Zu Path-Auftrag</translation>
    </message>
    <message>
        <source>Make the program's operations paths of FreeCAD's own Path workbench, in one of its jobs</source>
        <translation>Aus den Operationen des Programms Pfade von FreeCADs eigenem Arbeitsbereich Path machen, in einem seiner Aufträge</translation>
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
        <source>Show the program as the machine takes it, and save it</source>
        <translation>Das Programm zeigen, wie die Maschine es nimmt, und speichern</translation>
    </message>
    <message>
        <source>Shows the planned program of the selected job as the machine takes it, such as G-code, with line numbers. Its Save asks for the file's name, which is the part's.</source>
        <translation>Zeigt das geplante Programm des ausgewählten Jobs so, wie die Maschine es nimmt, etwa als G-Code, mit Zeilennummern. Beim Speichern wird nach dem Namen der Datei gefragt; vorgeschlagen ist der des Werkstücks.</translation>
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
