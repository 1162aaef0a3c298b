<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>Colour where no wall was measured</source>
        <translation>Farbe, wo keine Wand gemessen wurde</translation>
    </message>
    <message>
        <source>Colours from thin to thick</source>
        <translation>Farben von dünn nach dick</translation>
    </message>
    <message>
        <source>Diagonal of the largest part's bounding box, mm</source>
        <translation>Diagonale des Hüllquaders des größten Bauteils, mm</translation>
    </message>
    <message>
        <source>Greatest wall that the process allows, mm; 0: any</source>
        <translation>Größte Wandstärke, die das Verfahren zulässt, mm; 0: jede</translation>
    </message>
    <message>
        <source>How it was measured: across the wall, or as the largest ball inside</source>
        <translation>Wie gemessen wurde: quer durch die Wand oder als größte Kugel darin</translation>
    </message>
    <message>
        <source>Measured point on the face, in the coordinates of its object</source>
        <translation>Gemessener Punkt auf der Fläche, in den Koordinaten ihres Objekts</translation>
    </message>
    <message>
        <source>Number of steps; 0: smooth</source>
        <translation>Anzahl der Stufen; 0: stufenlos</translation>
    </message>
    <message>
        <source>Opposite point, in the coordinates of the document</source>
        <translation>Gegenüberliegender Punkt, in den Koordinaten des Dokuments</translation>
    </message>
    <message>
        <source>Placements of the sources when they were measured</source>
        <translation>Lage der Quellen bei der Messung</translation>
    </message>
    <message>
        <source>Points opposite the probed points</source>
        <translation>Punkte gegenüber den Messpunkten</translation>
    </message>
    <message>
        <source>Points where the thickness was probed</source>
        <translation>Punkte, an denen die Wandstärke gemessen wurde</translation>
    </message>
    <message>
        <source>Process whose walls are at least Threshold and at most CheckMost</source>
        <translation>Verfahren, dessen Wände mindestens Threshold und höchstens CheckMost dick sind</translation>
    </message>
    <message>
        <source>The face where the wall is measured</source>
        <translation>Die Fläche, an der die Wand gemessen wird</translation>
    </message>
    <message>
        <source>The measured thickness</source>
        <translation>Die gemessene Wandstärke</translation>
    </message>
    <message>
        <source>The sources' shapes when measured</source>
        <translation>Die Formen der Quellen bei der Messung</translation>
    </message>
    <message>
        <source>The thickness before the sources were changed last</source>
        <translation>Die Wandstärke vor der letzten Änderung der Quellen</translation>
    </message>
    <message>
        <source>Thickest wall of the map, mm</source>
        <translation>Dickste Wand der Karte, mm</translation>
    </message>
    <message>
        <source>Thickness at the lower end of the colours</source>
        <translation>Wandstärke am unteren Ende der Farbskala</translation>
    </message>
    <message>
        <source>Thickness at the upper end of the colours</source>
        <translation>Wandstärke am oberen Ende der Farbskala</translation>
    </message>
    <message>
        <source>Thinnest wall of the map, mm</source>
        <translation>Dünnste Wand der Karte, mm</translation>
    </message>
    <message>
        <source>Transparency of the facets, in percent</source>
        <translation>Transparenz der Facetten, in Prozent</translation>
    </message>
    <message>
        <source>Unit of Low and High</source>
        <translation>Einheit von Low und High</translation>
    </message>
    <message>
        <source>Wall thickness at the measured point</source>
        <translation>Wandstärke am gemessenen Punkt</translation>
    </message>
    <message>
        <source>Wall thickness at the probed points, mm</source>
        <translation>Wandstärke an den Messpunkten, mm</translation>
    </message>
    <message>
        <source>Walls thinner than this are thin, mm</source>
        <translation>Wände unter dieser Stärke sind dünn, mm</translation>
    </message>
    <message>
        <source>What was measured</source>
        <translation>Was gemessen wurde</translation>
    </message>
    <message>
        <source>Whether colours run from the thinnest to the thickest wall</source>
        <translation>Ob die Farben von der dünnsten bis zur dicksten Wand reichen</translation>
    </message>
    <message>
        <source>Whether equal ratios of thickness are equally far apart on the scale</source>
        <translation>Ob gleiche Verhältnisse der Dicke auf der Skala gleich weit auseinander liegen</translation>
    </message>
    <message>
        <source>Whether only thin walls are coloured</source>
        <translation>Ob nur dünne Wände eingefärbt werden</translation>
    </message>
    <message>
        <source>Whether the colours run the other way</source>
        <translation>Ob die Farben umgekehrt verlaufen</translation>
    </message>
    <message>
        <source>Whether the map is lit; off: flat colours, exactly those of the colour bar</source>
        <translation>Ob die Karte beleuchtet ist; aus: flache Farben, genau die des Farbbalkens</translation>
    </message>
    <message>
        <source>Whether the sources have changed since</source>
        <translation>Ob sich die Quellen seitdem geändert haben</translation>
    </message>
</context>
<context>
    <name>ThinPart</name>
    <message>
        <source>
Filled to {} (V/VBB = {})</source>
        <translation>
Gefüllt zu {} (V/VBB = {})</translation>
    </message>
    <message>
        <source>
Its volume is unknown.</source>
        <translation>
Sein Volumen ist unbekannt.</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>&amp;All parts together</source>
        <translation>Alle Bauteile &amp;zusammen</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Durchsuchen…</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Abbre&amp;chen</translation>
    </message>
    <message>
        <source>&amp;Colours show</source>
        <translation>&amp;Farben zeigen</translation>
    </message>
    <message>
        <source>&amp;Contents</source>
        <translation>&amp;Inhalt</translation>
    </message>
    <message>
        <source>&amp;Exclude…</source>
        <translation>&amp;Ausschließen…</translation>
    </message>
    <message>
        <source>&amp;Export CSV…</source>
        <translation>CSV e&amp;xportieren…</translation>
    </message>
    <message>
        <source>&amp;Fly to thinnest wall</source>
        <translation>Zur dünn&amp;sten Wand</translation>
    </message>
    <message>
        <source>&amp;Folder</source>
        <translation>&amp;Ordner</translation>
    </message>
    <message>
        <source>&amp;Folder:</source>
        <translation>&amp;Ordner:</translation>
    </message>
    <message>
        <source>&amp;Forward</source>
        <translation>&amp;Vor</translation>
    </message>
    <message>
        <source>&amp;Isolate</source>
        <translation>&amp;Isolieren</translation>
    </message>
    <message>
        <source>&amp;Keep measuring</source>
        <translation>&amp;Weiter messen</translation>
    </message>
    <message>
        <source>&amp;Learn</source>
        <translation>&amp;Lernen</translation>
    </message>
    <message>
        <source>&amp;Library</source>
        <translation>&amp;Bibliothek</translation>
    </message>
    <message>
        <source>&amp;Logarithmic</source>
        <translation>&amp;Logarithmisch</translation>
    </message>
    <message>
        <source>&amp;Measure again</source>
        <translation>Erne&amp;ut messen</translation>
    </message>
    <message>
        <source>&amp;Measure unchanged documents again</source>
        <translation>&amp;Unveränderte Dokumente neu messen</translation>
    </message>
    <message>
        <source>&amp;Names</source>
        <translation>&amp;Namen</translation>
    </message>
    <message>
        <source>&amp;Only thin walls in colour</source>
        <translation>Nur dünne &amp;Wände in Farbe</translation>
    </message>
    <message>
        <source>&amp;Open it in the browser when it is ready</source>
        <translation>Nach dem Fertigstellen im &amp;Browser öffnen</translation>
    </message>
    <message>
        <source>&amp;Open part</source>
        <translation>&amp;Bauteil öffnen</translation>
    </message>
    <message>
        <source>&amp;Open report</source>
        <translation>Bericht ö&amp;ffnen</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Öf&amp;fnen …</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pausieren</translation>
    </message>
    <message>
        <source>&amp;Probe</source>
        <translation>&amp;Messpunkt</translation>
    </message>
    <message>
        <source>&amp;Profile:</source>
        <translation>&amp;Profil:</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>&amp;Remove its limits</source>
        <translation>Ihre Grenzen &amp;entfernen</translation>
    </message>
    <message>
        <source>&amp;Remove mesh size</source>
        <translation>Netzweite &amp;entfernen</translation>
    </message>
    <message>
        <source>&amp;Reset to saved</source>
        <translation>&amp;Zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;Retry failed</source>
        <translation>&amp;Fehlgeschlagene wiederholen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>&amp;Save as…</source>
        <translation>&amp;Speichern unter…</translation>
    </message>
    <message>
        <source>&amp;Shaded</source>
        <translation>&amp;Schattiert</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>&amp;Starten</translation>
    </message>
    <message>
        <source>&amp;Stop it</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>&amp;Tables</source>
        <translation>&amp;Tabellen</translation>
    </message>
    <message>
        <source>&amp;Thin below</source>
        <translation>&amp;Dünn unter</translation>
    </message>
    <message>
        <source>&amp;Thresholds</source>
        <translation>Sch&amp;wellenwerte</translation>
    </message>
    <message>
        <source>&amp;Use as my profile</source>
        <translation>Als mein Profil &amp;verwenden</translation>
    </message>
    <message>
        <source>&amp;Use it</source>
        <translation>&amp;Verwenden</translation>
    </message>
    <message>
        <source>&amp;Whole range</source>
        <translation>&amp;Gesamter Bereich</translation>
    </message>
    <message>
        <source>&amp;Write report</source>
        <translation>Bericht sch&amp;reiben</translation>
    </message>
    <message>
        <source>&amp;beside each document</source>
        <translation>n&amp;eben jedem Dokument</translation>
    </message>
    <message>
        <source>&amp;in the folder</source>
        <translation>&amp;im Ordner</translation>
    </message>
    <message>
        <source>'normal' and 'unknown' mean that no criterion holds, or that it cannot be told: choose another name.</source>
        <translation>„normal“ und „unknown“ bedeuten, dass kein Kriterium erfüllt ist oder dass es sich nicht sagen lässt: Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>'{}' has not been classified yet: classify the part first.</source>
        <translation>„{}“ wurde noch nicht klassifiziert: Klassifizieren Sie zuerst das Bauteil.</translation>
    </message>
    <message>
        <source>'{}' is still being measured.</source>
        <translation>„{}“ wird noch gemessen.</translation>
    </message>
    <message>
        <source>'{}' no longer has a part that can be measured.</source>
        <translation>„{}“ hat kein messbares Bauteil mehr.</translation>
    </message>
    <message>
        <source>, layers in {} of the thin walls</source>
        <translation>, Schichten in {} der dünnen Wände</translation>
    </message>
    <message>
        <source>1 probe was removed: the surface is no longer at its position.</source>
        <translation>1 Messpunkt wurde entfernt: Die Oberfläche ist nicht mehr dort, wo er war.</translation>
    </message>
    <message>
        <source>A click on the part pins the wall there</source>
        <translation>Ein Klick auf das Bauteil setzt dort einen Messpunkt</translation>
    </message>
    <message>
        <source>A link to {} was put into {}.</source>
        <translation>In {1} wurde eine Verknüpfung zu {0} eingefügt.</translation>
    </message>
    <message>
        <source>A normal part: one size is enough. About {} elements of {}. Tick a wall to give it layers.</source>
        <translation>Ein normales Teil: Eine Größe genügt. Etwa {} Elemente von {}. Setzen Sie das Häkchen einer Wand, damit sie Lagen erhält.</translation>
    </message>
    <message>
        <source>A part gets the first category of which a criterion holds. If none holds, it is normal.</source>
        <translation>Ein Bauteil erhält die erste Kategorie, von der ein Kriterium erfüllt ist. Ist keines erfüllt, ist es normal.</translation>
    </message>
    <message>
        <source>A profile that comes with ThinPart stays as it is: save under another name</source>
        <translation>Ein mitgeliefertes Profil bleibt, wie es ist: unter anderem Namen speichern</translation>
    </message>
    <message>
        <source>A shell would take about {} triangles.</source>
        <translation>Eine Schale bräuchte etwa {} Dreiecke.</translation>
    </message>
    <message>
        <source>A smaller share of the surface counts as none, because single rays may stray</source>
        <translation>Ein kleinerer Anteil der Oberfläche zählt als keiner, weil einzelne Strahlen danebengehen können</translation>
    </message>
    <message>
        <source>A verdict is called borderline if a quantity lies nearer to its threshold, relative to that</source>
        <translation>Ein Urteil heißt Grenzfall, wenn eine Größe näher an ihrem Schwellenwert liegt, relativ zu diesem</translation>
    </message>
    <message>
        <source>A verdict that is less probable is called unsure</source>
        <translation>Ein weniger wahrscheinliches Urteil heißt unsicher</translation>
    </message>
    <message>
        <source>About {} elements as a solid, {} as a shell.</source>
        <translation>Etwa {} Elemente als Volumen, {} als Schale.</translation>
    </message>
    <message>
        <source>About {} elements as a solid.</source>
        <translation>Etwa {} Elemente als Volumen.</translation>
    </message>
    <message>
        <source>About {} nodes ({} elements), of {} to {}, for an error of {} in deflections and frequencies. CalculiX takes about {} s for six frequencies.</source>
        <translation>Etwa {} Knoten ({} Elemente), von {} bis {}, für einen Fehler von {} in Verformungen und Frequenzen. CalculiX braucht für sechs Frequenzen etwa {} s.</translation>
    </message>
    <message>
        <source>About {} nodes ({} elements), of {} to {}.</source>
        <translation>Etwa {} Knoten ({} Elemente), von {} bis {}.</translation>
    </message>
    <message>
        <source>About {} nodes: more than most analyses need.</source>
        <translation>Etwa {} Knoten: mehr, als die meisten Berechnungen brauchen.</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>Quer zu</translation>
    </message>
    <message>
        <source>Across the wall (ray)</source>
        <translation>Quer durch die Wand (Strahl)</translation>
    </message>
    <message>
        <source>Add a category</source>
        <translation>Kategorie hinzufügen</translation>
    </message>
    <message>
        <source>Add a condition (and)</source>
        <translation>Bedingung hinzufügen (und)</translation>
    </message>
    <message>
        <source>Add a criterion (or)</source>
        <translation>Kriterium hinzufügen (oder)</translation>
    </message>
    <message>
        <source>Add a folder with classified parts under 'Libraries'.</source>
        <translation>Fügen Sie unter „Bibliotheken“ einen Ordner mit klassifizierten Bauteilen hinzu.</translation>
    </message>
    <message>
        <source>Add a material</source>
        <translation>Werkstoff hinzufügen</translation>
    </message>
    <message>
        <source>Add a process</source>
        <translation>Verfahren hinzufügen</translation>
    </message>
    <message>
        <source>Adds the folder to the libraries of 'Find parts', and opens that</source>
        <translation>Fügt den Ordner den Bibliotheken von „Bauteile finden“ hinzu und öffnet dieses</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>Hinzufügen…</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Nachher</translation>
    </message>
    <message>
        <source>Agreement</source>
        <translation>Übereinstimmung</translation>
    </message>
    <message>
        <source>All labels, either answer</source>
        <translation>Alle Einordnungen, eine der Antworten</translation>
    </message>
    <message>
        <source>All parts</source>
        <translation>Alle Bauteile</translation>
    </message>
    <message>
        <source>An unexpected error occurred ({}): try again, and if it happens again, report it with FreeCAD's log.</source>
        <translation>Ein unerwarteter Fehler ist aufgetreten ({}): Versuchen Sie es noch einmal, und melden Sie es mit FreeCADs Protokoll, wenn es wieder geschieht.</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>Analyse</translation>
    </message>
    <message>
        <source>Angle between neighbouring facets of a curved face</source>
        <translation>Winkel zwischen benachbarten Facetten einer gekrümmten Fläche</translation>
    </message>
    <message>
        <source>Angular deflection</source>
        <translation>Winkelabweichung</translation>
    </message>
    <message>
        <source>Another document</source>
        <translation>Anderes Dokument</translation>
    </message>
    <message>
        <source>Another folder…</source>
        <translation>Anderer Ordner …</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>Antworten</translation>
    </message>
    <message>
        <source>Apart, {}</source>
        <translation>Abstand, {}</translation>
    </message>
    <message>
        <source>Area of both of its sides</source>
        <translation>Fläche ihrer beiden Seiten</translation>
    </message>
    <message>
        <source>Area, {}²</source>
        <translation>Fläche, {}²</translation>
    </message>
    <message>
        <source>As a picture of any size, or as triangles with their thickness for ParaView, MeshLab and others</source>
        <translation>Als Bild beliebiger Größe, oder als Dreiecke mit ihrer Dicke für ParaView, MeshLab und andere</translation>
    </message>
    <message>
        <source>As proposed: {}</source>
        <translation>Wie vorgeschlagen: {}</translation>
    </message>
    <message>
        <source>Ask for this category earlier: a part gets the first one that applies</source>
        <translation>Diese Kategorie früher prüfen: Ein Bauteil erhält die erste, die zutrifft</translation>
    </message>
    <message>
        <source>Ask for this category later: a part gets the first one that applies</source>
        <translation>Diese Kategorie später prüfen: Ein Bauteil erhält die erste, die zutrifft</translation>
    </message>
    <message>
        <source>At least</source>
        <translation>Mindestens</translation>
    </message>
    <message>
        <source>At least, {}</source>
        <translation>Mindestens, {}</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Höchstens</translation>
    </message>
    <message>
        <source>At most, {}</source>
        <translation>Höchstens, {}</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatik</translation>
    </message>
    <message>
        <source>Back to its place</source>
        <translation>Zurück an seinen Platz</translation>
    </message>
    <message>
        <source>Back to the shipped limits</source>
        <translation>Zurück zu den mitgelieferten Grenzen</translation>
    </message>
    <message>
        <source>Bands</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Before, {}</source>
        <translation>Vorher, {}</translation>
    </message>
    <message>
        <source>Borderline within</source>
        <translation>Grenzfall innerhalb von</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Bounding box {}</source>
        <translation>Hüllquader {}</translation>
    </message>
    <message>
        <source>Box, {}</source>
        <translation>Quader, {}</translation>
    </message>
    <message>
        <source>By which the process is chosen, as in --check</source>
        <translation>Damit wird das Verfahren gewählt, wie bei --check</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>Wä&amp;hlen…</translation>
    </message>
    <message>
        <source>C&amp;lear all</source>
        <translation>&amp;Alle entfernen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was changed.</source>
        <translation>Abgebrochen. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was written.</source>
        <translation>Abgebrochen. Nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>Cancelled: no info file was written, since other parts of the document are not measured.</source>
        <translation>Abgebrochen: Es wurde keine Infodatei geschrieben, da andere Bauteile des Dokuments nicht gemessen sind.</translation>
    </message>
    <message>
        <source>Categories (none chosen: any)</source>
        <translation>Kategorien (keine gewählt: alle)</translation>
    </message>
    <message>
        <source>Category</source>
        <translation>Kategorie</translation>
    </message>
    <message>
        <source>Changed at any time</source>
        <translation>Jederzeit geändert</translation>
    </message>
    <message>
        <source>Changed in the last day</source>
        <translation>Am letzten Tag geändert</translation>
    </message>
    <message>
        <source>Changed in the last month</source>
        <translation>Im letzten Monat geändert</translation>
    </message>
    <message>
        <source>Changed in the last week</source>
        <translation>In der letzten Woche geändert</translation>
    </message>
    <message>
        <source>Chec&amp;k</source>
        <translation>P&amp;rüfen</translation>
    </message>
    <message>
        <source>Chec&amp;k for</source>
        <translation>P&amp;rüfen für</translation>
    </message>
    <message>
        <source>Check before meshing whether a part is thin, and where</source>
        <translation>Vor dem Vernetzen prüfen, ob ein Bauteil dünnwandig ist und wo</translation>
    </message>
    <message>
        <source>Check for</source>
        <translation>Prüfen für</translation>
    </message>
    <message>
        <source>Checks compare the least wall with the thickness across the wall, and the greatest with the largest balls inside: choose the thickness across the wall under 'Colours show' to see where the limits are broken.</source>
        <translation>Prüfungen vergleichen die kleinste Wandstärke mit der Dicke quer durch die Wand und die größte mit den größten Kugeln darin: Wählen Sie bei „Farben zeigen“ die Dicke quer durch die Wand, um zu sehen, wo die Grenzwerte verletzt sind.</translation>
    </message>
    <message>
        <source>Choose a file with mesh settings</source>
        <translation>Datei mit Netzeinstellungen wählen</translation>
    </message>
    <message>
        <source>Choose a file with thresholds</source>
        <translation>Datei mit Schwellenwerten wählen</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Ordner wählen</translation>
    </message>
    <message>
        <source>Choose a folder with classified parts</source>
        <translation>Ordner mit klassifizierten Bauteilen wählen</translation>
    </message>
    <message>
        <source>Choose a folder with classified parts, or add one under 'Libraries' in the panel 'Find parts'.</source>
        <translation>Wählen Sie einen Ordner mit klassifizierten Bauteilen oder fügen Sie im Fenster „Bauteile finden“ unter „Bibliotheken“ einen hinzu.</translation>
    </message>
    <message>
        <source>Choose a part in the list to see its faces.</source>
        <translation>Wählen Sie ein Bauteil in der Liste, um seine Flächen zu sehen.</translation>
    </message>
    <message>
        <source>Choose a part in the list to see its walls.</source>
        <translation>Wählen Sie in der Liste ein Bauteil, um seine Wände zu sehen.</translation>
    </message>
    <message>
        <source>Choose at least one format.</source>
        <translation>Wählen Sie mindestens ein Format.</translation>
    </message>
    <message>
        <source>Choose tables of labels</source>
        <translation>Tabellen mit Einordnungen wählen</translation>
    </message>
    <message>
        <source>Choose the folder for the info files.</source>
        <translation>Wählen Sie den Ordner für die Infodateien.</translation>
    </message>
    <message>
        <source>Choose the folder that is to be classified.</source>
        <translation>Wählen Sie den Ordner, der klassifiziert werden soll.</translation>
    </message>
    <message>
        <source>Choose the folder with the labelled parts.</source>
        <translation>Wählen Sie den Ordner mit den eingeordneten Bauteilen.</translation>
    </message>
    <message>
        <source>Chooses the thresholds that agree most often with what people say of parts: by 'Not right?' beside a verdict, or in tables. Folders that were left out show how good they are.</source>
        <translation>Wählt die Schwellenwerte, die am häufigsten mit dem übereinstimmen, was Menschen über Bauteile sagen: mit „Stimmt nicht?“ neben einem Urteil oder in Tabellen. Ausgelassene Ordner zeigen, wie gut sie sind.</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Classification</source>
        <translation>Klassifizierung</translation>
    </message>
    <message>
        <source>Classify again</source>
        <translation>Erneut klassifizieren</translation>
    </message>
    <message>
        <source>Classify folder</source>
        <translation>Ordner klassifizieren</translation>
    </message>
    <message>
        <source>Classify in the background</source>
        <translation>Im Hintergrund klassifizieren</translation>
    </message>
    <message>
        <source>Classify part</source>
        <translation>Bauteil klassifizieren</translation>
    </message>
    <message>
        <source>Classifying again by another profile</source>
        <translation>Neu klassifizieren nach anderem Profil</translation>
    </message>
    <message>
        <source>Classifying the folder has ended: {}</source>
        <translation>Das Klassifizieren des Ordners ist beendet: {}</translation>
    </message>
    <message>
        <source>Clear filters</source>
        <translation>Filter zurücksetzen</translation>
    </message>
    <message>
        <source>Clear thin colours</source>
        <translation>Dünnwandfarben entfernen</translation>
    </message>
    <message>
        <source>Click or drag over bars to see where those walls are.</source>
        <translation>Klicken Sie auf Balken oder ziehen Sie darüber, um zu sehen, wo diese Wände sind.</translation>
    </message>
    <message>
        <source>Click to close this message.</source>
        <translation>Klicken Sie, um diese Meldung zu entfernen.</translation>
    </message>
    <message>
        <source>Click to show its window.</source>
        <translation>Klicken Sie, um das Fenster zu zeigen.</translation>
    </message>
    <message>
        <source>Click: fly to its thinnest place. N, P: to the next and the previous one.</source>
        <translation>Klick: zur dünnsten Stelle fliegen. N, P: zur nächsten und zur vorigen.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Colour bar</source>
        <translation>Farbbalken</translation>
    </message>
    <message>
        <source>Colour in the view what only one of the two parts has; the document stays as it is</source>
        <translation>In der Ansicht einfärben, was nur eines der beiden Bauteile hat; das Dokument bleibt, wie es ist</translation>
    </message>
    <message>
        <source>Colour thin faces</source>
        <translation>Dünne Flächen einfärben</translation>
    </message>
    <message>
        <source>Colour where no wall could be measured</source>
        <translation>Farbe, wo keine Wand gemessen werden konnte</translation>
    </message>
    <message>
        <source>Coloured where the two are more than {} apart; at most it is {}.</source>
        <translation>Gefärbt, wo die beiden mehr als {} auseinander liegen; höchstens sind es {}.</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Colours and shares are of the largest balls inside, which shrink to nothing towards sharp edges; the line above is of the thickness across the wall.</source>
        <translation>Farben und Anteile sind die der größten Kugeln darin, die zu scharfen Kanten hin verschwinden; die Zeile darüber gilt der Dicke quer zur Wand.</translation>
    </message>
    <message>
        <source>Colours from the thinnest to the thickest wall</source>
        <translation>Farben von der dünnsten bis zur dicksten Wand</translation>
    </message>
    <message>
        <source>Compared with what the info file said before</source>
        <translation>Verglichen mit der bisherigen Infodatei</translation>
    </message>
    <message>
        <source>Compared: {} parts. Groups: {}. Parts besides those to keep: {}.</source>
        <translation>Verglichen: {} Bauteile. Gruppen: {}. Bauteile außer denen, die bleiben sollen: {}.</translation>
    </message>
    <message>
        <source>Compared: {} parts. None of them is there twice, mirrored, in another size, or alike.</source>
        <translation>Verglichen: {} Bauteile. Keines davon ist doppelt, gespiegelt, in anderer Größe oder ähnlich da.</translation>
    </message>
    <message>
        <source>Comparing the two…</source>
        <translation>Die beiden werden verglichen…</translation>
    </message>
    <message>
        <source>Comparing: {} of {}</source>
        <translation>Vergleichen: {} von {}</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Bedingung</translation>
    </message>
    <message>
        <source>Confidence: borderline, close to '{}' ({} from the limit)</source>
        <translation>Sicherheit: Grenzfall, nahe an „{}“ ({} von der Grenze)</translation>
    </message>
    <message>
        <source>Confidence: clear ({} from the limit)</source>
        <translation>Sicherheit: eindeutig ({} von der Grenze)</translation>
    </message>
    <message>
        <source>Connected walls of like thickness</source>
        <translation>Zusammenhängende Wände ähnlicher Dicke</translation>
    </message>
    <message>
        <source>Continue in the background? 'Classify folder' shows the progress again. Finished results are saved either way.</source>
        <translation>Im Hintergrund fortsetzen? „Ordner klassifizieren“ zeigt den Fortschritt wieder an. Fertige Ergebnisse bleiben in jedem Fall gespeichert.</translation>
    </message>
    <message>
        <source>Copied: {}</source>
        <translation>Kopiert: {}</translation>
    </message>
    <message>
        <source>Copy path</source>
        <translation>Pfad kopieren</translation>
    </message>
    <message>
        <source>Counting…</source>
        <translation>Wird gezählt …</translation>
    </message>
    <message>
        <source>Criteria</source>
        <translation>Kriterien</translation>
    </message>
    <message>
        <source>Criteria and their quantities</source>
        <translation>Kriterien und ihre Größen</translation>
    </message>
    <message>
        <source>Criteria that hold (none chosen: any)</source>
        <translation>Erfüllte Kriterien (keines gewählt: beliebig)</translation>
    </message>
    <message>
        <source>Criterion</source>
        <translation>Kriterium</translation>
    </message>
    <message>
        <source>Criterion {}: {}. All its conditions hold: {}.</source>
        <translation>Kriterium {}: {}. Alle Bedingungen erfüllt: {}.</translation>
    </message>
    <message>
        <source>Cut open</source>
        <translation>Aufschneiden</translation>
    </message>
    <message>
        <source>Cuts the map and the part; the edge of the cut has the colours of the walls</source>
        <translation>Schneidet die Karte und das Bauteil; der Rand des Schnitts hat die Farben der Wände</translation>
    </message>
    <message>
        <source>Dimensions that vary</source>
        <translation>Maße, die sich ändern</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Anzeige</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>Verteilung</translation>
    </message>
    <message>
        <source>Do not say this again</source>
        <translation>Nicht noch einmal sagen</translation>
    </message>
    <message>
        <source>Documents that are not classified yet, and only listed in it: {}.</source>
        <translation>Noch nicht klassifizierte Dokumente, die darin nur aufgelistet sind: {}.</translation>
    </message>
    <message>
        <source>Double-click a size or a number of layers to change it, for all selected walls. Without the check mark, a wall asks for no small elements.</source>
        <translation>Doppelklick auf eine Größe oder eine Zahl von Schichten ändert sie für alle gewählten Wände. Ohne Häkchen verlangt eine Wand keine kleinen Elemente.</translation>
    </message>
    <message>
        <source>Double-click: fly to its thinnest place. N, P: to the next and the previous one.</source>
        <translation>Doppelklick: zur dünnsten Stelle fliegen. N, P: zur nächsten und zur vorigen.</translation>
    </message>
    <message>
        <source>Drag it in the view to move it, a corner of it to size it; a right click has more</source>
        <translation>In der Ansicht ziehen, um ihn zu verschieben, an einer Ecke, um seine Größe zu ändern; ein Rechtsklick bietet mehr</translation>
    </message>
    <message>
        <source>Duplicates</source>
        <translation>Duplikate</translation>
    </message>
    <message>
        <source>Duplicates, quickly: by what info files keep</source>
        <translation>Duplikate, schnell: nach dem, was Infodateien enthalten</translation>
    </message>
    <message>
        <source>Duplicates, surely: the documents are read</source>
        <translation>Duplikate, sicher: die Dokumente werden gelesen</translation>
    </message>
    <message>
        <source>E&amp;xcept</source>
        <translation>&amp;Außer</translation>
    </message>
    <message>
        <source>E&amp;xport map…</source>
        <translation>Karte e&amp;xportieren…</translation>
    </message>
    <message>
        <source>Each document is classified in the background when it is saved; the status bar shows the verdict</source>
        <translation>Jedes Dokument wird beim Speichern im Hintergrund klassifiziert; die Statusleiste zeigt das Ergebnis</translation>
    </message>
    <message>
        <source>Edit notes</source>
        <translation>Notizen bearbeiten</translation>
    </message>
    <message>
        <source>Edit profile</source>
        <translation>Profil bearbeiten</translation>
    </message>
    <message>
        <source>Edit profile: {}</source>
        <translation>Profil bearbeiten: {}</translation>
    </message>
    <message>
        <source>Edit your own limits…</source>
        <translation>Eigene Grenzen bearbeiten …</translation>
    </message>
    <message>
        <source>Element size, {}</source>
        <translation>Elementgröße, {}</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Elemente</translation>
    </message>
    <message>
        <source>Equal ratios of thickness are equally far apart on the scale</source>
        <translation>Gleiche Verhältnisse der Dicke liegen auf der Skala gleich weit auseinander</translation>
    </message>
    <message>
        <source>Equal ratios of thickness are equally far apart, so that thin walls get more of the colours</source>
        <translation>Gleiche Verhältnisse der Dicke liegen gleich weit auseinander, sodass dünne Wände mehr von den Farben bekommen</translation>
    </message>
    <message>
        <source>Error aimed at</source>
        <translation>Angestrebter Fehler</translation>
    </message>
    <message>
        <source>Error of probabilities</source>
        <translation>Fehler der Wahrscheinlichkeiten</translation>
    </message>
    <message>
        <source>Evidence</source>
        <translation>Beleg</translation>
    </message>
    <message>
        <source>Exclude a wall</source>
        <translation>Wand ausschließen</translation>
    </message>
    <message>
        <source>Export the rows that are shown</source>
        <translation>Angezeigte Zeilen exportieren</translation>
    </message>
    <message>
        <source>Export thickness map</source>
        <translation>Dickenkarte exportieren</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Faces that are thin on at least half their area</source>
        <translation>Flächen, die auf mindestens der Hälfte ihres Flächeninhalts dünn sind</translation>
    </message>
    <message>
        <source>Faces that are thin on less of their area</source>
        <translation>Flächen, die auf einem kleineren Teil dünn sind</translation>
    </message>
    <message>
        <source>Faces thin in places</source>
        <translation>Stellenweise dünne Flächen</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Fehlgeschlagen</translation>
    </message>
    <message>
        <source>Failed: {}</source>
        <translation>Fehlgeschlagen: {}</translation>
    </message>
    <message>
        <source>Families: parts that differ in dimensions</source>
        <translation>Familien: Bauteile, die sich in Maßen unterscheiden</translation>
    </message>
    <message>
        <source>Families: {}. Parts in them: {}.</source>
        <translation>Familien: {}. Bauteile darin: {}.</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Files at &amp;once</source>
        <translation>Dateien &amp;gleichzeitig</translation>
    </message>
    <message>
        <source>Files at once</source>
        <translation>Dateien gleichzeitig</translation>
    </message>
    <message>
        <source>Filter: words of the file or the part</source>
        <translation>Filter: Wörter der Datei oder des Bauteils</translation>
    </message>
    <message>
        <source>Filters</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Find parts</source>
        <translation>Bauteile finden</translation>
    </message>
    <message>
        <source>Finding element sizes for {}</source>
        <translation>Elementgrößen für {} werden bestimmt</translation>
    </message>
    <message>
        <source>First, coarse colours; finer ones follow, about {} left.</source>
        <translation>Erste, grobe Farben; feinere folgen, noch etwa {}.</translation>
    </message>
    <message>
        <source>First, coarse colours; finer ones follow.</source>
        <translation>Erste, grobe Farben; feinere folgen.</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Folder for the info files, which mirrors the folders of the documents; it may be on another computer. Empty: beside each document</source>
        <translation>Ein Ordner für die Infodateien, in dem die Ordner der Dokumente nachgebildet werden; er darf auf einem anderen Rechner liegen. Leer: neben jedem Dokument</translation>
    </message>
    <message>
        <source>Folder of the report</source>
        <translation>Ordner des Berichts</translation>
    </message>
    <message>
        <source>For the info file: {}</source>
        <translation>Für die Infodatei: {}</translation>
    </message>
    <message>
        <source>Formats</source>
        <translation>Formate</translation>
    </message>
    <message>
        <source>FreeCAD cannot insert {} ({}).</source>
        <translation>FreeCAD kann {} nicht einfügen ({}).</translation>
    </message>
    <message>
        <source>FreeCAD cannot open {} ({}).</source>
        <translation>FreeCAD kann {} nicht öffnen ({}).</translation>
    </message>
    <message>
        <source>FreeCAD may crash in the same way when it opens the file: save your documents first. Open it anyway?</source>
        <translation>FreeCAD kann auf dieselbe Weise abstürzen, wenn es die Datei öffnet: Speichern Sie zuerst Ihre Dokumente. Trotzdem öffnen?</translation>
    </message>
    <message>
        <source>FreeCAD shows one task at a time: close the one that is open, then try again.</source>
        <translation>FreeCAD zeigt immer nur eine Aufgabe: Schließen Sie die geöffnete und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>From behind and below</source>
        <translation>Von hinten unten</translation>
    </message>
    <message>
        <source>From file…</source>
        <translation>Aus Datei…</translation>
    </message>
    <message>
        <source>From now on parts are judged by {}. 'Reclassify' in the panel 'Find parts' judges stored parts by it.</source>
        <translation>Ab jetzt werden Bauteile nach {} beurteilt. „Neu klassifizieren“ in „Bauteile finden“ beurteilt gespeicherte Bauteile danach.</translation>
    </message>
    <message>
        <source>From the thinnest confirmed wall to the thickness below which 98 % of the surface lies, without rims, whose rays run along the wall</source>
        <translation>Von der dünnsten bestätigten Wand bis zu der Dicke, unter der 98 % der Oberfläche liegen, ohne Ränder, deren Strahlen an der Wand entlang laufen</translation>
    </message>
    <message>
        <source>From the thinnest to the thickest wall</source>
        <translation>Von der dünnsten bis zur dicksten Wand</translation>
    </message>
    <message>
        <source>From where it is seen</source>
        <translation>Von wo es zu sehen ist</translation>
    </message>
    <message>
        <source>From {} profiles, each learned without some folders or groups, and tried on those. In brackets: intervals of 95 %.</source>
        <translation>Aus {} Profilen, jedes ohne einige Ordner oder Gruppen gelernt und an diesen erprobt. In Klammern: Intervalle von 95 %.</translation>
    </message>
    <message>
        <source>From {} profiles, each learned without some parts, and tried on those. All parts are in one folder, so parts may be similar: the figures are too good. In brackets: intervals of 95 %.</source>
        <translation>Aus {} Profilen, jedes ohne einige Bauteile gelernt und an diesen erprobt. Alle Bauteile liegen in einem Ordner und können ähnlich sein: Die Zahlen sind zu gut. In Klammern: Intervalle von 95 %.</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Gmsh made no mesh ({}): try another error or fewer layers, a smaller largest size, or switch a wall off. Nothing was changed.</source>
        <translation>Gmsh hat kein Netz erzeugt ({}): Versuchen Sie einen anderen Fehler oder weniger Schichten oder eine kleinere größte Größe, oder schalten Sie eine Wand aus. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Gmsh meshes {}</source>
        <translation>Gmsh vernetzt {}</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weiterlaufen lassen</translation>
    </message>
    <message>
        <source>Go to it</source>
        <translation>Dorthin</translation>
    </message>
    <message>
        <source>Greatest wall, {}</source>
        <translation>Größte Wand, {}</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Wachstum</translation>
    </message>
    <message>
        <source>Half of the face's area has thinner walls</source>
        <translation>Die Hälfte der Fläche hat dünnere Wände</translation>
    </message>
    <message>
        <source>Heat map colour where no wall could be measured</source>
        <translation>Farbe der Farbkarte, wo keine Wand gemessen werden konnte</translation>
    </message>
    <message>
        <source>Heat map of the thickness</source>
        <translation>Farbkarte der Wandstärke</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Here: {}</source>
        <translation>Hier: {}</translation>
    </message>
    <message>
        <source>Hide colour bar</source>
        <translation>Farbbalken ausblenden</translation>
    </message>
    <message>
        <source>Holds</source>
        <translation>Erfüllt</translation>
    </message>
    <message>
        <source>How far a place of one of the two surfaces is from the other at most</source>
        <translation>Wie weit eine Stelle der einen Oberfläche höchstens von der anderen entfernt ist</translation>
    </message>
    <message>
        <source>How far it is from each point of the surface straight through the material to the other side. Verdicts are always judged by it.</source>
        <translation>Wie weit es von jedem Punkt der Oberfläche geradeaus durch das Material zur anderen Seite ist. Urteile richten sich immer danach.</translation>
    </message>
    <message>
        <source>How far the mesh may lie from the surface, as a share of the part's diagonal; where walls are thin it is made finer anyway</source>
        <translation>Wie weit das Netz von der Oberfläche abweichen darf, als Anteil der Diagonale des Bauteils; an dünnen Wänden wird es ohnehin feiner</translation>
    </message>
    <message>
        <source>How finely parts are measured at first; where the error of a quantity could turn the verdict, a part is measured again, more finely</source>
        <translation>Wie fein Teile zuerst gemessen werden; wo der Fehler einer Größe das Urteil ändern könnte, wird ein Teil noch einmal feiner gemessen</translation>
    </message>
    <message>
        <source>How often the part stands in the document</source>
        <translation>Wie oft das Bauteil im Dokument vorkommt</translation>
    </message>
    <message>
        <source>How sure a verdict is</source>
        <translation>Wie sicher ein Urteil ist</translation>
    </message>
    <message>
        <source>I would say:</source>
        <translation>Ich würde sagen:</translation>
    </message>
    <message>
        <source>I&amp;nclude again</source>
        <translation>&amp;Wieder einschließen</translation>
    </message>
    <message>
        <source>In the view</source>
        <translation>In der Ansicht</translation>
    </message>
    <message>
        <source>Info file, beside the document: {}</source>
        <translation>Infodatei neben dem Dokument: {}</translation>
    </message>
    <message>
        <source>Info file, in the preferred folder: {}</source>
        <translation>Infodatei im voreingestellten Ordner: {}</translation>
    </message>
    <message>
        <source>Info files</source>
        <translation>Infodateien</translation>
    </message>
    <message>
        <source>Info files cannot be written in {}: choose another folder for them.</source>
        <translation>In {} können keine Infodateien geschrieben werden: Wählen Sie einen anderen Ordner dafür.</translation>
    </message>
    <message>
        <source>Insert into active document</source>
        <translation>In aktives Dokument einfügen</translation>
    </message>
    <message>
        <source>Insert part</source>
        <translation>Bauteil einfügen</translation>
    </message>
    <message>
        <source>Instances</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Into how many steps the colours are divided</source>
        <translation>In wie viele Stufen die Farben unterteilt sind</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isometrisch</translation>
    </message>
    <message>
        <source>Kept because: {}</source>
        <translation>Soll bleiben: {}</translation>
    </message>
    <message>
        <source>Kept in the info file with a reason; checks compare this face with it instead of the process</source>
        <translation>Wird mit einem Grund in der Infodatei aufbewahrt; Prüfungen vergleichen diese Fläche damit statt mit dem Verfahren</translation>
    </message>
    <message>
        <source>Kept in the info file, also when the part is measured again; the verdict does not change</source>
        <translation>Bleibt in der Infodatei, auch wenn das Teil neu gemessen wird; das Urteil ändert sich nicht</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>L&amp;abels</source>
        <translation>&amp;Einordnungen</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Einordnung</translation>
    </message>
    <message>
        <source>Label {} parts</source>
        <translation>{} Teile einstufen</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Einordnungen</translation>
    </message>
    <message>
        <source>Labels (rows) and verdicts of {} (columns)</source>
        <translation>Einordnungen (Zeilen) und Urteile von {} (Spalten)</translation>
    </message>
    <message>
        <source>Labels: {}</source>
        <translation>Einordnungen: {}</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Größer</translation>
    </message>
    <message>
        <source>Largest ball</source>
        <translation>Größte Kugel</translation>
    </message>
    <message>
        <source>Largest ball here: {}</source>
        <translation>Größte Kugel hier: {}</translation>
    </message>
    <message>
        <source>Largest ball in {}, and share of the diagonal</source>
        <translation>Größte Kugel in {} und als Anteil der Diagonale</translation>
    </message>
    <message>
        <source>Largest ball inside (sphere)</source>
        <translation>Größte Kugel darin (Kugel)</translation>
    </message>
    <message>
        <source>Largest ball, {}</source>
        <translation>Größte Kugel, {}</translation>
    </message>
    <message>
        <source>Largest size</source>
        <translation>Größte Größe</translation>
    </message>
    <message>
        <source>Largest size, {}</source>
        <translation>Größte Elementgröße, {}</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>Layers in thin walls</source>
        <translation>Schichten in dünnen Wänden</translation>
    </message>
    <message>
        <source>Learn thresholds</source>
        <translation>Schwellenwerte lernen</translation>
    </message>
    <message>
        <source>Learned</source>
        <translation>Gelernt</translation>
    </message>
    <message>
        <source>Learning needs the Python package {}, which this FreeCAD does not have: FreeCAD's Addon Manager offers it when it installs ThinPart.</source>
        <translation>Zum Lernen wird das Python-Paket {} gebraucht, das dieses FreeCAD nicht hat: FreeCADs Addon-Manager bietet es an, wenn er ThinPart installiert.</translation>
    </message>
    <message>
        <source>Learning profile {} of {}</source>
        <translation>Profil {} von {} wird gelernt</translation>
    </message>
    <message>
        <source>Learning thresholds</source>
        <translation>Schwellen werden gelernt</translation>
    </message>
    <message>
        <source>Least and median thickness of the wall</source>
        <translation>Kleinste und mittlere Dicke der Wand (Median)</translation>
    </message>
    <message>
        <source>Least share of the surface that counts</source>
        <translation>Kleinster Anteil der Oberfläche, der zählt</translation>
    </message>
    <message>
        <source>Least wall, {}</source>
        <translation>Kleinste Wand, {}</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Left solid, not in the shell: {} walls, last in the table.</source>
        <translation>Bleibt Volumen, nicht in der Schale: {} Wände, zuletzt in der Tabelle.</translation>
    </message>
    <message>
        <source>Length of the wall</source>
        <translation>Länge der Wand</translation>
    </message>
    <message>
        <source>Libraries</source>
        <translation>Bibliotheken</translation>
    </message>
    <message>
        <source>Like</source>
        <translation>Ähnlich</translation>
    </message>
    <message>
        <source>Limit for {}</source>
        <translation>Grenze für {}</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Limits of the wall</source>
        <translation>Grenzen der Wandstärke</translation>
    </message>
    <message>
        <source>Linear deflection</source>
        <translation>Lineare Abweichung</translation>
    </message>
    <message>
        <source>Linear elements are far too stiff in thin walls.</source>
        <translation>Lineare Elemente sind in dünnen Wänden viel zu steif.</translation>
    </message>
    <message>
        <source>Linear triangles are far too stiff in CalculiX.</source>
        <translation>Lineare Dreiecke sind in CalculiX viel zu steif.</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Verknüpfung</translation>
    </message>
    <message>
        <source>Local thickness</source>
        <translation>Örtliche Dicke</translation>
    </message>
    <message>
        <source>Local thickness here: {}</source>
        <translation>Örtliche Dicke hier: {}</translation>
    </message>
    <message>
        <source>Local thickness in {}, and share of the diagonal</source>
        <translation>Örtliche Dicke in {} und Anteil der Diagonale</translation>
    </message>
    <message>
        <source>Local thickness, {}</source>
        <translation>Örtliche Dicke, {}</translation>
    </message>
    <message>
        <source>Logarithmic</source>
        <translation>Logarithmisch</translation>
    </message>
    <message>
        <source>Long, {}</source>
        <translation>Länge, {}</translation>
    </message>
    <message>
        <source>Longest side, {}</source>
        <translation>Längste Seite, {}</translation>
    </message>
    <message>
        <source>Longest, {}</source>
        <translation>Längste, {}</translation>
    </message>
    <message>
        <source>Looking for parts in the folder…</source>
        <translation>Bauteile im Ordner werden gesucht…</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>Verlust</translation>
    </message>
    <message>
        <source>MB</source>
        <translation>MB</translation>
    </message>
    <message>
        <source>Made by</source>
        <translation>Erzeugt von</translation>
    </message>
    <message>
        <source>Make shell</source>
        <translation>Schale erzeugen</translation>
    </message>
    <message>
        <source>Making the mid-surface of {}</source>
        <translation>Mittelfläche von {} wird erzeugt</translation>
    </message>
    <message>
        <source>Making the surface mesh of {}</source>
        <translation>Oberflächennetz von {} wird erzeugt</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Measured: {} parallel, {} tapered, {} nothing opposite</source>
        <translation>Gemessen: {} parallel, {} verjüngt, {} ohne Gegenwand</translation>
    </message>
    <message>
        <source>Measurements, notes, mesh settings and links stay unchanged. Write the info files now?</source>
        <translation>Messwerte, Notizen, Netzeinstellungen und Verknüpfungen bleiben unverändert. Infodateien jetzt schreiben?</translation>
    </message>
    <message>
        <source>Measuring and drawing…</source>
        <translation>Messen und Zeichnen…</translation>
    </message>
    <message>
        <source>Measuring needs Python {} beside FreeCAD, which was not found: install it.</source>
        <translation>Zum Messen wird Python {} neben FreeCAD gebraucht, das nicht gefunden wurde: Installieren Sie es.</translation>
    </message>
    <message>
        <source>Measuring needs more than {} MB of memory: raise the limit in the preferences.</source>
        <translation>Das Messen braucht mehr als {} MB Speicher: Erhöhen Sie die Grenze in den Einstellungen.</translation>
    </message>
    <message>
        <source>Measuring the walls of {}</source>
        <translation>Wände von {} werden gemessen</translation>
    </message>
    <message>
        <source>Median thickness of the wall</source>
        <translation>Mittlere Dicke der Wand (Median)</translation>
    </message>
    <message>
        <source>Median, {}</source>
        <translation>Median, {}</translation>
    </message>
    <message>
        <source>Memory limit for measuring one document</source>
        <translation>Speichergrenze für das Messen eines Dokuments</translation>
    </message>
    <message>
        <source>Memory per file</source>
        <translation>Speicher pro Datei</translation>
    </message>
    <message>
        <source>Mesh and compare</source>
        <translation>Vernetzen und vergleichen</translation>
    </message>
    <message>
        <source>Mesh as</source>
        <translation>Vernetzen als</translation>
    </message>
    <message>
        <source>Mesh file</source>
        <translation>Netzdatei</translation>
    </message>
    <message>
        <source>Mesh risk</source>
        <translation>Netzrisiko</translation>
    </message>
    <message>
        <source>Mesh settings</source>
        <translation>Netzeinstellungen</translation>
    </message>
    <message>
        <source>Mesh size of a wall</source>
        <translation>Netzweite einer Wand</translation>
    </message>
    <message>
        <source>Meshes</source>
        <translation>Netze</translation>
    </message>
    <message>
        <source>Most elements</source>
        <translation>Höchstzahl der Elemente</translation>
    </message>
    <message>
        <source>Move over the part; a click pins the wall there.</source>
        <translation>Bewegen Sie den Zeiger über das Bauteil; ein Klick setzt dort einen Messpunkt.</translation>
    </message>
    <message>
        <source>My label: {}</source>
        <translation>Ich sage: {}</translation>
    </message>
    <message>
        <source>New material</source>
        <translation>Neuer Werkstoff</translation>
    </message>
    <message>
        <source>New process</source>
        <translation>Neues Verfahren</translation>
    </message>
    <message>
        <source>Next wall</source>
        <translation>Nächste Wand</translation>
    </message>
    <message>
        <source>No criterion holds: its walls are thick all over.</source>
        <translation>Kein Kriterium ist erfüllt: Die Wände sind überall dick.</translation>
    </message>
    <message>
        <source>No file manager was found: open the folder {} yourself.</source>
        <translation>Es wurde keine Dateiverwaltung gefunden: Öffnen Sie den Ordner {} selbst.</translation>
    </message>
    <message>
        <source>No file manager was found: open the info file {} yourself.</source>
        <translation>Es wurde keine Dateiverwaltung gefunden: Öffnen Sie die Infodatei {} selbst.</translation>
    </message>
    <message>
        <source>No info file was written, because the document is not saved.</source>
        <translation>Es wurde keine Infodatei geschrieben, weil das Dokument nicht gespeichert ist.</translation>
    </message>
    <message>
        <source>No info file was written, since not every part was measured.</source>
        <translation>Es wurde keine Infodatei geschrieben, da nicht alle Bauteile gemessen wurden.</translation>
    </message>
    <message>
        <source>No info file: {}</source>
        <translation>Keine Infodatei: {}</translation>
    </message>
    <message>
        <source>No part was measured, so no info file was written.</source>
        <translation>Kein Bauteil wurde gemessen, daher wurde keine Infodatei geschrieben.</translation>
    </message>
    <message>
        <source>No place is more than {} apart.</source>
        <translation>Keine Stelle liegt mehr als {} auseinander.</translation>
    </message>
    <message>
        <source>No program was found that opens {}.</source>
        <translation>Es wurde kein Programm gefunden, das {} öffnet.</translation>
    </message>
    <message>
        <source>No thin walls: one size is enough. About {} elements of {}.</source>
        <translation>Keine dünnen Wände: Eine Größe genügt. Etwa {} Elemente von {}.</translation>
    </message>
    <message>
        <source>No wall became thinner.</source>
        <translation>Keine Wand wurde dünner.</translation>
    </message>
    <message>
        <source>No wall could be measured.</source>
        <translation>Es konnte keine Wand gemessen werden.</translation>
    </message>
    <message>
        <source>No wall regions are recorded: measure the part again.</source>
        <translation>Es sind keine Wandbereiche verzeichnet: Messen Sie das Bauteil erneut.</translation>
    </message>
    <message>
        <source>No wall was measured here.</source>
        <translation>Hier wurde keine Wand gemessen.</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Normal part</source>
        <translation>Normales Bauteil</translation>
    </message>
    <message>
        <source>Not compared, because an earlier version has measured them: {}. Classify them again.</source>
        <translation>Nicht verglichen, weil eine frühere Version sie gemessen hat: {}. Klassifizieren Sie sie erneut.</translation>
    </message>
    <message>
        <source>Not counted: {}</source>
        <translation>Nicht gezählt: {}</translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation>Nicht gemessen</translation>
    </message>
    <message>
        <source>Not measured: {}</source>
        <translation>Nicht gemessen: {}</translation>
    </message>
    <message>
        <source>Not measured: {} of the area</source>
        <translation>Nicht gemessen: {} der Oberfläche</translation>
    </message>
    <message>
        <source>Not right?</source>
        <translation>Stimmt nicht?</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Anmerkung</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>Now, {}</source>
        <translation>Jetzt, {}</translation>
    </message>
    <message>
        <source>Number of files of a folder that are measured at the same time</source>
        <translation>Dateien eines Ordners, die gleichzeitig gemessen werden</translation>
    </message>
    <message>
        <source>Number of the group</source>
        <translation>Nummer der Gruppe</translation>
    </message>
    <message>
        <source>OK also makes an analysis, if there is none</source>
        <translation>OK legt auch eine Analyse an, falls es keine gibt</translation>
    </message>
    <message>
        <source>Of deflections and frequencies, with quadratic elements. It decides the sizes.</source>
        <translation>Der Verformungen und Frequenzen, mit quadratischen Elementen. Er bestimmt die Größen.</translation>
    </message>
    <message>
        <source>On every save</source>
        <translation>Bei jedem Speichern</translation>
    </message>
    <message>
        <source>On parts that were left out, the learned profile agrees with the labels no better than {} does: keep {}, or label more parts.</source>
        <translation>An ausgelassenen Bauteilen stimmt das gelernte Profil nicht besser mit den Einordnungen überein als {}: Behalten Sie {} oder ordnen Sie mehr Bauteile ein.</translation>
    </message>
    <message>
        <source>On {} of the area the largest ball is smaller than {}</source>
        <translation>Auf {} der Oberfläche ist die größte Kugel kleiner als {}</translation>
    </message>
    <message>
        <source>On {} of the area the local thickness is less than {}</source>
        <translation>Auf {} der Fläche ist die örtliche Dicke kleiner als {}</translation>
    </message>
    <message>
        <source>One size: {}</source>
        <translation>Eine Größe: {}</translation>
    </message>
    <message>
        <source>Only failures</source>
        <translation>Nur Fehlgeschlagene</translation>
    </message>
    <message>
        <source>Only labelled</source>
        <translation>Nur eingeordnete</translation>
    </message>
    <message>
        <source>Only labelled otherwise</source>
        <translation>Nur anders eingeordnete</translation>
    </message>
    <message>
        <source>Only unsure</source>
        <translation>Nur unsichere</translation>
    </message>
    <message>
        <source>Only with notes</source>
        <translation>Nur mit Notizen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open part</source>
        <translation>Bauteil öffnen</translation>
    </message>
    <message>
        <source>Opens a profile that somebody has given you</source>
        <translation>Öffnet ein Profil, das Ihnen jemand gegeben hat</translation>
    </message>
    <message>
        <source>Opens the page of the guide about this (F1)</source>
        <translation>Öffnet die Seite des Leitfadens dazu (F1)</translation>
    </message>
    <message>
        <source>Order of the elements</source>
        <translation>Ordnung der Elemente</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>Andere Seite</translation>
    </message>
    <message>
        <source>Out of date: recompute</source>
        <translation>Veraltet: neu berechnen</translation>
    </message>
    <message>
        <source>Own limit</source>
        <translation>Eigene Grenze</translation>
    </message>
    <message>
        <source>Own limits</source>
        <translation>Eigene Grenzen</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Bauteil</translation>
    </message>
    <message>
        <source>Part with thin features</source>
        <translation>Bauteil mit dünnen Bereichen</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Bauteile</translation>
    </message>
    <message>
        <source>Parts are judged by '{}' from now on. Parts that were classified before keep their verdicts until you reclassify them.</source>
        <translation>Bauteile werden ab jetzt nach „{}“ beurteilt. Früher klassifizierte behalten ihr Urteil, bis Sie sie neu klassifizieren.</translation>
    </message>
    <message>
        <source>Parts like the active one</source>
        <translation>Bauteile wie das aktive</translation>
    </message>
    <message>
        <source>Parts like this one</source>
        <translation>Bauteile wie dieses</translation>
    </message>
    <message>
        <source>Patterns of file names, separated by semicolons; one with a slash is compared with the path below the folder</source>
        <translation>Muster für Dateinamen, durch Semikolon getrennt; eines mit Schrägstrich wird mit dem Pfad unterhalb des Ordners verglichen</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>Picture of the view (*.png)</source>
        <translation>Bild der Ansicht (*.png)</translation>
    </message>
    <message>
        <source>Pin thickness</source>
        <translation>Messpunkt setzen</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Prepare mesh</source>
        <translation>Netz vorbereiten</translation>
    </message>
    <message>
        <source>Previous wall</source>
        <translation>Vorige Wand</translation>
    </message>
    <message>
        <source>Probability: {}, next '{}' with {}</source>
        <translation>Wahrscheinlichkeit: {}, danach „{}“ mit {}</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Messpunkt</translation>
    </message>
    <message>
        <source>Probes</source>
        <translation>Messpunkte</translation>
    </message>
    <message>
        <source>Process and material</source>
        <translation>Verfahren und Werkstoff</translation>
    </message>
    <message>
        <source>Processes whose least and greatest wall the parts are checked against: a column each</source>
        <translation>Verfahren, gegen deren kleinste und größte Wandstärke die Teile geprüft werden: je eine Spalte</translation>
    </message>
    <message>
        <source>Processes, with commas between them, whose least and greatest wall every part is checked against</source>
        <translation>Verfahren, durch Kommas getrennt, gegen deren kleinste und größte Wandstärke jedes Teil geprüft wird</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Range of &amp;most walls</source>
        <translation>Bereich der &amp;meisten Wände</translation>
    </message>
    <message>
        <source>Read the info files again, which may have changed</source>
        <translation>Die Infodateien neu lesen, falls sie sich geändert haben</translation>
    </message>
    <message>
        <source>Reading info files: {} of {}</source>
        <translation>Infodateien werden gelesen: {} von {}</translation>
    </message>
    <message>
        <source>Reading info files…</source>
        <translation>Infodateien werden gelesen…</translation>
    </message>
    <message>
        <source>Reading the labels…</source>
        <translation>Einordnungen werden gelesen…</translation>
    </message>
    <message>
        <source>Rear</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>Reclassify</source>
        <translation>Neu klassifizieren</translation>
    </message>
    <message>
        <source>Reclassify libraries…</source>
        <translation>Bibliotheken neu klassifizieren …</translation>
    </message>
    <message>
        <source>Reclassify…</source>
        <translation>Neu klassifizieren …</translation>
    </message>
    <message>
        <source>Recommended: shell.</source>
        <translation>Empfohlen: Schale.</translation>
    </message>
    <message>
        <source>Recommended: solid, or a shell of its walls only.</source>
        <translation>Empfohlen: Volumen, oder nur seine Wände als Schale.</translation>
    </message>
    <message>
        <source>Recommended: solid.</source>
        <translation>Empfohlen: Volumen.</translation>
    </message>
    <message>
        <source>Refresh</source>
        <translation>Aktualisieren</translation>
    </message>
    <message>
        <source>Refreshing the libraries</source>
        <translation>Bibliotheken werden aktualisiert</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove all probes</source>
        <translation>Alle Messpunkte entfernen</translation>
    </message>
    <message>
        <source>Remove my label</source>
        <translation>Meine Einordnung entfernen</translation>
    </message>
    <message>
        <source>Remove thickness</source>
        <translation>Messpunkt entfernen</translation>
    </message>
    <message>
        <source>Remove this category</source>
        <translation>Diese Kategorie entfernen</translation>
    </message>
    <message>
        <source>Remove this condition</source>
        <translation>Diese Bedingung entfernen</translation>
    </message>
    <message>
        <source>Remove this criterion</source>
        <translation>Dieses Kriterium entfernen</translation>
    </message>
    <message>
        <source>Replace it? What it contains will be lost.</source>
        <translation>Ersetzen? Der Inhalt geht verloren.</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Report about all parts of '{}'</source>
        <translation>Bericht über alle Bauteile von „{}“</translation>
    </message>
    <message>
        <source>Report about libraries</source>
        <translation>Bericht über Bibliotheken</translation>
    </message>
    <message>
        <source>Report about the classified parts in '{}'</source>
        <translation>Bericht über die klassifizierten Bauteile in „{}“</translation>
    </message>
    <message>
        <source>Report about the classified parts in {} libraries</source>
        <translation>Bericht über die klassifizierten Bauteile in {} Bibliotheken</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Bericht…</translation>
    </message>
    <message>
        <source>Reset to saved</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Restore defaults</source>
        <translation>Standardwerte wiederherstellen</translation>
    </message>
    <message>
        <source>Resu&amp;me</source>
        <translation>For&amp;tsetzen</translation>
    </message>
    <message>
        <source>Reversed</source>
        <translation>Umgekehrt</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Risk of the automatic mesh</source>
        <translation>Risiko des automatischen Netzes</translation>
    </message>
    <message>
        <source>S&amp;hare</source>
        <translation>&amp;Teilen</translation>
    </message>
    <message>
        <source>Same</source>
        <translation>Gleich</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Save and write info file</source>
        <translation>Speichern und Infodatei schreiben</translation>
    </message>
    <message>
        <source>Save the learned profile</source>
        <translation>Das gelernte Profil speichern</translation>
    </message>
    <message>
        <source>Save the limits</source>
        <translation>Grenzen speichern</translation>
    </message>
    <message>
        <source>Save the profile as</source>
        <translation>Profil speichern unter</translation>
    </message>
    <message>
        <source>Save them?</source>
        <translation>Sollen sie gespeichert werden?</translation>
    </message>
    <message>
        <source>Saved in {}, without the probabilities, which belong to other thresholds.</source>
        <translation>Gespeichert in {}, ohne die Wahrscheinlichkeiten, die zu anderen Schwellenwerten gehören.</translation>
    </message>
    <message>
        <source>Saved in {}.</source>
        <translation>Gespeichert in {}.</translation>
    </message>
    <message>
        <source>Saved in {}. Wherever you choose processes, these limits hold from now on.</source>
        <translation>Gespeichert in {}. Überall, wo Sie Verfahren wählen, gelten ab jetzt diese Grenzen.</translation>
    </message>
    <message>
        <source>Saved.</source>
        <translation>Gespeichert.</translation>
    </message>
    <message>
        <source>Saves the profile and judges parts by it from now on</source>
        <translation>Speichert das Profil und beurteilt Bauteile ab jetzt danach</translation>
    </message>
    <message>
        <source>Say below a verdict whether the libraries of Find parts have the part already, its mirror image, another size, or one like it</source>
        <translation>Unter einem Urteil sagen, ob die Bibliotheken von Bauteile finden das Bauteil schon haben, sein Spiegelbild, eine andere Größe oder ein ähnliches</translation>
    </message>
    <message>
        <source>Say what libraries have already</source>
        <translation>Sagen, was Bibliotheken schon haben</translation>
    </message>
    <message>
        <source>Say what the part is in your eyes. The label is kept in the info file, as of {}; thresholds can be learned from labels.</source>
        <translation>Sagen Sie, was das Bauteil in Ihren Augen ist. Die Einordnung bleibt in der Infodatei, als die von {}; aus Einordnungen lassen sich Schwellenwerte lernen.</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search in it…</source>
        <translation>Darin suchen…</translation>
    </message>
    <message>
        <source>Searching for duplicates</source>
        <translation>Duplikate werden gesucht</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>Suche…</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Select a part in the list.</source>
        <translation>Wählen Sie ein Bauteil in der Liste.</translation>
    </message>
    <message>
        <source>Set "Most elements", or a larger error.</source>
        <translation>Setzen Sie „Höchstzahl der Elemente“ oder einen größeren Fehler.</translation>
    </message>
    <message>
        <source>Set "Most elements", or fewer layers.</source>
        <translation>Setzen Sie „Höchstzahl der Elemente“ oder weniger Schichten.</translation>
    </message>
    <message>
        <source>Set &amp;mesh size…</source>
        <translation>&amp;Netzweite festlegen…</translation>
    </message>
    <message>
        <source>Set its &amp;greatest wall…</source>
        <translation>Ihre &amp;größte Wand festlegen …</translation>
    </message>
    <message>
        <source>Set its &amp;least wall…</source>
        <translation>Ihre &amp;kleinste Wand festlegen …</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>Settings that worked for this part: {}</source>
        <translation>Einstellungen, die sich für dieses Teil bewährt haben: {}</translation>
    </message>
    <message>
        <source>Settings that worked for {} ({} alike): {}</source>
        <translation>Einstellungen, die sich für {} bewährt haben (zu {} ähnlich): {}</translation>
    </message>
    <message>
        <source>Shaded</source>
        <translation>Schattiert</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>Share of the face where no wall could be measured</source>
        <translation>Anteil der Fläche, wo keine Wand gemessen werden konnte</translation>
    </message>
    <message>
        <source>Share of the face whose walls are thinner than the threshold</source>
        <translation>Anteil der Fläche, dessen Wände dünner als der Schwellenwert sind</translation>
    </message>
    <message>
        <source>Share of the surface that is the same: the less of both</source>
        <translation>Anteil der Oberfläche, der gleich ist: der kleinere der beiden</translation>
    </message>
    <message>
        <source>Shell: its mid-surface</source>
        <translation>Schale: seine Mittelfläche</translation>
    </message>
    <message>
        <source>Short name</source>
        <translation>Kurzname</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>A&amp;lle zeigen</translation>
    </message>
    <message>
        <source>Show &amp;all walls</source>
        <translation>&amp;Alle Wände zeigen</translation>
    </message>
    <message>
        <source>Show in Find parts</source>
        <translation>In „Bauteile finden“ zeigen</translation>
    </message>
    <message>
        <source>Show in file manager</source>
        <translation>In Dateiverwaltung zeigen</translation>
    </message>
    <message>
        <source>Show info file’s folder</source>
        <translation>Ordner der Infodatei zeigen</translation>
    </message>
    <message>
        <source>Show poor elements ({})</source>
        <translation>Schlechte Elemente zeigen ({})</translation>
    </message>
    <message>
        <source>Show sizes on the part</source>
        <translation>Größen am Teil zeigen</translation>
    </message>
    <message>
        <source>Show the difference</source>
        <translation>Unterschied zeigen</translation>
    </message>
    <message>
        <source>Show the shell by its thickness</source>
        <translation>Schale nach ihrer Dicke zeigen</translation>
    </message>
    <message>
        <source>Show thickness</source>
        <translation>Wandstärke anzeigen</translation>
    </message>
    <message>
        <source>Shown as thin: below {}, as the preferences say. The verdict does not depend on it.</source>
        <translation>Als dünn angezeigt: unter {}, wie eingestellt. Das Ergebnis hängt nicht davon ab.</translation>
    </message>
    <message>
        <source>Shows the defaults of this page; OK or Apply saves them</source>
        <translation>Zeigt die Standardwerte dieser Seite; sie werden mit OK oder Anwenden übernommen</translation>
    </message>
    <message>
        <source>Shows the half that is cut off now</source>
        <translation>Zeigt die Hälfte, die jetzt abgeschnitten ist</translation>
    </message>
    <message>
        <source>Shows the thresholds of this profile, to change and save them as your own</source>
        <translation>Zeigt die Schwellenwerte dieses Profils, um sie zu ändern und als eigene zu speichern</translation>
    </message>
    <message>
        <source>Similar size</source>
        <translation>Ähnliche Größe</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Size, {}</source>
        <translation>Größe, {}</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Kleiner</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Something stands before this wall from every side: the mark shows where it is. Hide what covers it, or cut the view open with the clipping plane of the View menu.</source>
        <translation>Vor dieser Wand steht von allen Seiten etwas: Die Markierung zeigt, wo sie ist. Blenden Sie aus, was sie verdeckt, oder schneiden Sie die Ansicht mit der Schnittebene im Menü Ansicht auf.</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Source: address</source>
        <translation>Quelle: Adresse</translation>
    </message>
    <message>
        <source>Source: author</source>
        <translation>Quelle: Autor</translation>
    </message>
    <message>
        <source>Source: title</source>
        <translation>Quelle: Titel</translation>
    </message>
    <message>
        <source>Source: year</source>
        <translation>Quelle: Jahr</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Ausgang</translation>
    </message>
    <message>
        <source>Start &amp;with</source>
        <translation>&amp;Ausgehen von</translation>
    </message>
    <message>
        <source>Starting to measure {}</source>
        <translation>Messung von {} beginnt</translation>
    </message>
    <message>
        <source>Steel (replace it)</source>
        <translation>Stahl (zu ersetzen)</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Stop it, and go on here?</source>
        <translation>Dort abbrechen und hier weitermachen?</translation>
    </message>
    <message>
        <source>Stopped on request before the end.</source>
        <translation>Auf Wunsch vorzeitig abgebrochen.</translation>
    </message>
    <message>
        <source>Stopped: {} of {} info files are up to date.</source>
        <translation>Abgebrochen: {} von {} Infodateien sind aktuell.</translation>
    </message>
    <message>
        <source>Sure labels</source>
        <translation>Sichere Einordnungen</translation>
    </message>
    <message>
        <source>Surface mesh that is measured</source>
        <translation>Oberflächennetz, das gemessen wird</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Temporary files cannot be written ({}): free some disk space. Nothing was classified.</source>
        <translation>Temporäre Dateien können nicht geschrieben werden ({}): Geben Sie Speicherplatz frei. Nichts wurde klassifiziert.</translation>
    </message>
    <message>
        <source>Temporary files cannot be written ({}): free some disk space. Nothing was measured.</source>
        <translation>Temporäre Dateien können nicht geschrieben werden ({}): Geben Sie Speicherplatz frei. Nichts wurde gemessen.</translation>
    </message>
    <message>
        <source>The active document as it was saved. Click to classify it in the panel.</source>
        <translation>Das aktive Dokument, wie es gespeichert ist. Klicken Sie, um es im Aufgabenbereich zu klassifizieren.</translation>
    </message>
    <message>
        <source>The camera looks at it from where nothing stands before it. N, P: the next thicker wall, and the previous one</source>
        <translation>Die Kamera blickt von dort auf sie, wo nichts davor steht. N, P: zur nächstdickeren Wand und zur vorigen</translation>
    </message>
    <message>
        <source>The category needs a short name.</source>
        <translation>Die Kategorie braucht einen Kurznamen.</translation>
    </message>
    <message>
        <source>The category's short name, by which results and searches refer to it</source>
        <translation>Der Kurzname der Kategorie, unter dem Ergebnisse und Suchen sie nennen</translation>
    </message>
    <message>
        <source>The classification process could not be started.</source>
        <translation>Der Klassifizierungsprozess konnte nicht gestartet werden.</translation>
    </message>
    <message>
        <source>The classification process ended unexpectedly; finished results are saved. Start again for the rest; the report view shows its last output.</source>
        <translation>Der Klassifizierungsprozess wurde unerwartet beendet; fertige Ergebnisse sind gespeichert. Starten Sie erneut für den Rest; seine letzten Meldungen stehen im Ausgabefenster.</translation>
    </message>
    <message>
        <source>The colours in the view are the first, coarse ones: they are not saved, and go when this panel is closed.</source>
        <translation>Die Farben in der Ansicht sind die ersten, groben: Sie werden nicht gespeichert und verschwinden, wenn dieser Aufgabenbereich geschlossen wird.</translation>
    </message>
    <message>
        <source>The content of {} was copied into {}: a link needs a saved document.</source>
        <translation>Der Inhalt von {} wurde in {} kopiert: Eine Verknüpfung braucht ein gespeichertes Dokument.</translation>
    </message>
    <message>
        <source>The criterion needs a short name.</source>
        <translation>Das Kriterium braucht einen Kurznamen.</translation>
    </message>
    <message>
        <source>The criterion's short name, by which results and searches refer to it</source>
        <translation>Der Kurzname des Kriteriums, unter dem Ergebnisse und Suchen es nennen</translation>
    </message>
    <message>
        <source>The diameter of the largest ball that fits into the material and reaches each point. Edges are as thick as the walls that meet there; ribs, teeth, threads and run-outs have a thickness of their own.</source>
        <translation>Der Durchmesser der größten Kugel, die in das Material passt und bis zu jedem Punkt reicht. Kanten sind so dick wie die Wände, die dort zusammentreffen; Rippen, Zähne, Gewinde und Ausläufe haben eine eigene Dicke.</translation>
    </message>
    <message>
        <source>The diameter of the largest ball that fits into the material and touches the surface at each point. It is no larger than the wall across and does not see past the next face: at sharp edges it goes down to nothing. It takes longer.</source>
        <translation>Der Durchmesser der größten Kugel, die in das Material passt und die Oberfläche an der jeweiligen Stelle berührt. Er ist nie größer als die Wand quer gemessen und reicht nicht über die nächste Fläche hinaus: An scharfen Kanten geht er gegen null. Das Messen dauert länger.</translation>
    </message>
    <message>
        <source>The document has changed since it was measured: classify it again.</source>
        <translation>Das Dokument hat sich seit der Messung geändert: Klassifizieren Sie es erneut.</translation>
    </message>
    <message>
        <source>The document has changed since it was measured: no info file was written. Classify it again.</source>
        <translation>Das Dokument hat sich seit der Messung geändert: Es wurde keine Infodatei geschrieben. Klassifizieren Sie es erneut.</translation>
    </message>
    <message>
        <source>The document has changed while it was measured: measure it again.</source>
        <translation>Das Dokument hat sich während der Messung geändert: Messen Sie es erneut.</translation>
    </message>
    <message>
        <source>The document has changed while it was meshed: start again. Nothing was changed.</source>
        <translation>Das Dokument hat sich während des Vernetzens geändert: Beginnen Sie neu. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The document is closed: open it again for a report about it.</source>
        <translation>Das Dokument ist geschlossen: Öffnen Sie es wieder, um darüber zu berichten.</translation>
    </message>
    <message>
        <source>The failures are folders that could not be searched: make them readable and start again.</source>
        <translation>Fehlgeschlagen sind Ordner, die nicht durchsucht werden konnten: Machen Sie sie lesbar und starten Sie erneut.</translation>
    </message>
    <message>
        <source>The file {} no longer exists.</source>
        <translation>Die Datei {} gibt es nicht mehr.</translation>
    </message>
    <message>
        <source>The first colour stands for the thickest wall</source>
        <translation>Die erste Farbe steht für die dickste Wand</translation>
    </message>
    <message>
        <source>The folder is still being classified.</source>
        <translation>Der Ordner wird noch klassifiziert.</translation>
    </message>
    <message>
        <source>The folder with your parts; its subfolders are included</source>
        <translation>Der Ordner mit Ihren Bauteilen, einschließlich seiner Unterordner</translation>
    </message>
    <message>
        <source>The folder {} has not answered for {} s: connect it, or choose another one for the info files.</source>
        <translation>Der Ordner {} antwortet seit {} s nicht: Verbinden Sie ihn oder wählen Sie einen anderen für die Infodateien.</translation>
    </message>
    <message>
        <source>The folder {} is not writable: choose another folder for the info files.</source>
        <translation>Der Ordner {} ist nicht beschreibbar: Wählen Sie einen anderen Ordner für die Infodateien.</translation>
    </message>
    <message>
        <source>The folder {} no longer exists.</source>
        <translation>Den Ordner {} gibt es nicht mehr.</translation>
    </message>
    <message>
        <source>The info file {} is damaged ({}): classify its document again.</source>
        <translation>Die Infodatei {} ist beschädigt ({}): Klassifizieren Sie ihr Dokument erneut.</translation>
    </message>
    <message>
        <source>The learned profile agrees with {} labels; {} does with {}.</source>
        <translation>Das gelernte Profil stimmt mit {} Einordnungen überein, {} mit {}.</translation>
    </message>
    <message>
        <source>The learned profile was written to {}.</source>
        <translation>Das gelernte Profil wurde nach {} geschrieben.</translation>
    </message>
    <message>
        <source>The least wall has to be thinner than the greatest.</source>
        <translation>Die kleinste Wandstärke muss unter der größten liegen.</translation>
    </message>
    <message>
        <source>The least wall; another one is a limit of your own</source>
        <translation>Die kleinste Wand; eine andere ist eine eigene Grenze</translation>
    </message>
    <message>
        <source>The limit costs accuracy: {} would take about {} elements.</source>
        <translation>Die Höchstzahl kostet Genauigkeit: {} bräuchten etwa {} Elemente.</translation>
    </message>
    <message>
        <source>The limit costs layers: all walls would take about {} elements.</source>
        <translation>Die Höchstzahl kostet Schichten: Alle Wände bräuchten etwa {} Elemente.</translation>
    </message>
    <message>
        <source>The limit costs layers: {} instead of {}, which would take about {} elements.</source>
        <translation>Die Höchstzahl kostet Schichten: {} statt {}, die etwa {} Elemente bräuchten.</translation>
    </message>
    <message>
        <source>The limits of the wall have unsaved changes.</source>
        <translation>Die Grenzen der Wandstärke haben ungespeicherte Änderungen.</translation>
    </message>
    <message>
        <source>The map is lit, so that its shape is seen: colours get darker away from the light. Off: flat colours, exactly those of the colour bar</source>
        <translation>Die Karte ist beleuchtet, sodass man ihre Form sieht: vom Licht abgewandt werden Farben dunkler. Aus: flache Farben, genau die des Farbbalkens</translation>
    </message>
    <message>
        <source>The map of before beside that of now, once the part was changed and measured again</source>
        <translation>Die Karte von vorher neben der von jetzt, sobald das Teil geändert und erneut gemessen wurde</translation>
    </message>
    <message>
        <source>The map of before is of other parts, or was measured in another way.</source>
        <translation>Die Karte von vorher ist von anderen Teilen oder wurde anders gemessen.</translation>
    </message>
    <message>
        <source>The measuring process could not be started.</source>
        <translation>Der Messprozess konnte nicht gestartet werden.</translation>
    </message>
    <message>
        <source>The measuring process ended unexpectedly; the document is unharmed. Check the part with 'Check geometry' of the Part workbench.</source>
        <translation>Der Messprozess wurde unerwartet beendet; das Dokument ist unbeschädigt. Prüfen Sie das Bauteil mit „Geometrie prüfen“ des Arbeitsbereichs Part.</translation>
    </message>
    <message>
        <source>The open panel is about '{}'.</source>
        <translation>Das offene Panel gehört zu „{}“.</translation>
    </message>
    <message>
        <source>The probabilities of this profile belong to its thresholds before your change: they say how often engineers agreed with verdicts by those. The changed profile is saved without them, and its verdicts are borderline near a threshold instead. 'thinpart learn' makes new ones from labels.</source>
        <translation>Die Wahrscheinlichkeiten dieses Profils gehören zu seinen Schwellenwerten vor Ihrer Änderung: Sie sagen, wie oft Ingenieure den Urteilen danach zustimmten. Das geänderte Profil wird ohne sie gespeichert; seine Urteile sind stattdessen nahe einem Schwellenwert Grenzfälle. „thinpart learn“ gewinnt neue aus Einordnungen.</translation>
    </message>
    <message>
        <source>The profile has unsaved changes.</source>
        <translation>Das Profil hat ungespeicherte Änderungen.</translation>
    </message>
    <message>
        <source>The report is in {}.</source>
        <translation>Der Bericht liegt in {}.</translation>
    </message>
    <message>
        <source>The same part, its mirror image, another size, or one like it; each is said once</source>
        <translation>Dasselbe Bauteil, sein Spiegelbild, eine andere Größe oder ein ähnliches; jedes wird einmal gesagt</translation>
    </message>
    <message>
        <source>The second bound has to be greater than the first.</source>
        <translation>Die zweite Schranke muss größer als die erste sein.</translation>
    </message>
    <message>
        <source>The short name consists of 1 to 40 letters, digits, - and _.</source>
        <translation>Der Kurzname besteht aus 1 bis 40 Buchstaben, Ziffern, - und _.</translation>
    </message>
    <message>
        <source>The short name {} is there twice.</source>
        <translation>Den Kurznamen {} gibt es zweimal.</translation>
    </message>
    <message>
        <source>The smallest size everywhere would take {}.</source>
        <translation>Überall die kleinste Größe bräuchte {}.</translation>
    </message>
    <message>
        <source>The table was not written to {}: choose a file name that ends with .csv.</source>
        <translation>Die Tabelle wurde nicht in {} geschrieben: Wählen Sie einen Dateinamen, der auf .csv endet.</translation>
    </message>
    <message>
        <source>The table {} could not be written ({}): choose another place for it.</source>
        <translation>Die Tabelle {} konnte nicht geschrieben werden ({}): Wählen Sie einen anderen Ort dafür.</translation>
    </message>
    <message>
        <source>The thickness map cannot be written ({}): free some disk space. Nothing was changed.</source>
        <translation>Die Wandstärkenkarte kann nicht geschrieben werden ({}): Geben Sie Speicherplatz frei. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The thickness map is hidden, to show the thin faces. Space shows it again.</source>
        <translation>Die Dickenkarte ist ausgeblendet, damit die dünnen Flächen zu sehen sind. Die Leertaste blendet sie wieder ein.</translation>
    </message>
    <message>
        <source>The thinnest wall, the thickest one and pinned ones; those behind the part are hidden</source>
        <translation>Die dünnste Wand, die dickste und angeheftete; was hinter dem Teil liegt, ist ausgeblendet</translation>
    </message>
    <message>
        <source>The threshold</source>
        <translation>Der Schwellenwert</translation>
    </message>
    <message>
        <source>The worker process could not be started.</source>
        <translation>Der Arbeitsprozess konnte nicht gestartet werden.</translation>
    </message>
    <message>
        <source>The worker process ended unexpectedly.</source>
        <translation>Der Arbeitsprozess wurde unerwartet beendet.</translation>
    </message>
    <message>
        <source>The worker process ended unexpectedly; the report view shows its last output.</source>
        <translation>Der Arbeitsprozess wurde unerwartet beendet; seine letzten Meldungen stehen im Ausgabefenster.</translation>
    </message>
    <message>
        <source>The {} parts most like {}, among {} of {}</source>
        <translation>Die {} Bauteile, die {} am ähnlichsten sind, unter {} von {}</translation>
    </message>
    <message>
        <source>The {} rows that are shown were written to {}.</source>
        <translation>Die {} angezeigten Zeilen wurden in {} geschrieben.</translation>
    </message>
    <message>
        <source>There are no classified parts.</source>
        <translation>Es gibt keine klassifizierten Bauteile.</translation>
    </message>
    <message>
        <source>There are no families.</source>
        <translation>Es gibt keine Familien.</translation>
    </message>
    <message>
        <source>There are two categories {}.</source>
        <translation>Es gibt zwei Kategorien {}.</translation>
    </message>
    <message>
        <source>There are two criteria {}.</source>
        <translation>Es gibt zwei Kriterien {}.</translation>
    </message>
    <message>
        <source>There has to be a least or a greatest wall.</source>
        <translation>Es muss eine kleinste oder eine größte Wandstärke geben.</translation>
    </message>
    <message>
        <source>There is no document to insert into: open or create one first.</source>
        <translation>Es gibt kein Dokument, in das eingefügt werden kann: Öffnen oder erstellen Sie zuerst eines.</translation>
    </message>
    <message>
        <source>There is no document: open or create one first.</source>
        <translation>Es gibt kein Dokument: Öffnen oder erstellen Sie zuerst eines.</translation>
    </message>
    <message>
        <source>There is no folder {}: choose another one.</source>
        <translation>Den Ordner {} gibt es nicht: Wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>There is no folder {}: create it first, or choose another one for the info files.</source>
        <translation>Den Ordner {} gibt es nicht: Legen Sie ihn zuerst an oder wählen Sie einen anderen für die Infodateien.</translation>
    </message>
    <message>
        <source>There is no info file to keep this in: press 'Save and write info file' above, or classify the document.</source>
        <translation>Es gibt keine Infodatei, die das aufnehmen könnte: Drücken Sie oben „Speichern und Infodatei schreiben“, oder klassifizieren Sie das Dokument.</translation>
    </message>
    <message>
        <source>Thick, {}</source>
        <translation>Dicke, {}</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Wandstärke</translation>
    </message>
    <message>
        <source>Thickness colours</source>
        <translation>Farbskala</translation>
    </message>
    <message>
        <source>Thickness labels</source>
        <translation>Dickenangaben</translation>
    </message>
    <message>
        <source>Thin</source>
        <translation>Dünn</translation>
    </message>
    <message>
        <source>Thin below</source>
        <translation>Dünn unter</translation>
    </message>
    <message>
        <source>Thin faces</source>
        <translation>Dünne Flächen</translation>
    </message>
    <message>
        <source>Thin part</source>
        <translation>Dünnwandiges Bauteil</translation>
    </message>
    <message>
        <source>ThinPart guide</source>
        <translation>ThinPart-Leitfaden</translation>
    </message>
    <message>
        <source>ThinPart is installed twice: {} is used, {} is not. Remove one of them.</source>
        <translation>ThinPart ist zweimal installiert: {} wird benutzt, {} nicht. Entfernen Sie eines davon.</translation>
    </message>
    <message>
        <source>ThinPart: {}</source>
        <translation>ThinPart: {}</translation>
    </message>
    <message>
        <source>Thinnest wall under the face</source>
        <translation>Dünnste Wand unter der Fläche</translation>
    </message>
    <message>
        <source>Thinnest wall, and how many places are about as thin</source>
        <translation>Dünnste Wand, und wie viele Stellen etwa so dünn sind</translation>
    </message>
    <message>
        <source>Thinnest wall, {}</source>
        <translation>Dünnste Wand, {}</translation>
    </message>
    <message>
        <source>Thinnest, {}</source>
        <translation>Dünnste, {}</translation>
    </message>
    <message>
        <source>This link is stored with the part. Open it outside FreeCAD?</source>
        <translation>Dieser Link ist beim Teil hinterlegt. Außerhalb von FreeCAD öffnen?</translation>
    </message>
    <message>
        <source>Three colours: red is thinner than the limit, yellow up to a tenth above it, blue passes. Violet is thicker than the process allows, by the largest ball inside, as in the check</source>
        <translation>Drei Farben: Rot ist dünner als die Grenze, Gelb bis zu einem Zehntel darüber, Blau besteht. Violett ist dicker, als das Verfahren erlaubt, nach der größten Kugel darin, wie bei der Prüfung</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>Thresholds</source>
        <translation>Schwellenwerte</translation>
    </message>
    <message>
        <source>Thresholds (*.json)</source>
        <translation>Schwellenwerte (*.json)</translation>
    </message>
    <message>
        <source>Thresholds to judge by: a shipped profile, or a file</source>
        <translation>Schwellenwerte für das Urteil: ein mitgeliefertes Profil oder eine Datei</translation>
    </message>
    <message>
        <source>Time &amp;limit per file</source>
        <translation>&amp;Zeitlimit pro Datei</translation>
    </message>
    <message>
        <source>Time limit for one file of a folder, or for one document that is classified automatically</source>
        <translation>Zeitgrenze für eine Datei eines Ordners oder ein automatisch klassifiziertes Dokument</translation>
    </message>
    <message>
        <source>Time per file</source>
        <translation>Zeit pro Datei</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>To be measured again, because an earlier version did not measure what decides: {}.</source>
        <translation>Neu zu messen, weil eine frühere Version nicht gemessen hat, was entscheidet: {}.</translation>
    </message>
    <message>
        <source>To classify a part, open a document and close the task that is open.</source>
        <translation>Um ein Bauteil zu klassifizieren, öffnen Sie ein Dokument und schließen Sie die offene Aufgabe.</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Try {}: {}</source>
        <translation>Versuch {}: {}</translation>
    </message>
    <message>
        <source>Two answers to the same part differ in {}.</source>
        <translation>Zwei Antworten zum selben Bauteil unterscheiden sich in {}.</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Unbekannt</translation>
    </message>
    <message>
        <source>Unmeasured</source>
        <translation>Ungemessen</translation>
    </message>
    <message>
        <source>Unsure below a probability of</source>
        <translation>Unsicher unter einer Wahrscheinlichkeit von</translation>
    </message>
    <message>
        <source>Unsure: '{}' ({}) or '{}' ({})</source>
        <translation>Unsicher: „{}“ ({}) oder „{}“ ({})</translation>
    </message>
    <message>
        <source>Unsure: {} or {}</source>
        <translation>Unsicher: {} oder {}</translation>
    </message>
    <message>
        <source>Use these settings</source>
        <translation>Diese Einstellungen verwenden</translation>
    </message>
    <message>
        <source>V/VBB</source>
        <translation>V/VBB</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Wand</translation>
    </message>
    <message>
        <source>Wall regions</source>
        <translation>Wandbereiche</translation>
    </message>
    <message>
        <source>Wall thickness</source>
        <translation>Wandstärke</translation>
    </message>
    <message>
        <source>Wall thickness, {}</source>
        <translation>Wandstärke, {}</translation>
    </message>
    <message>
        <source>Wall thickness: min {}, median {}, max {} (± {})</source>
        <translation>Wandstärke: min. {}, Median {}, max. {} (± {})</translation>
    </message>
    <message>
        <source>Walls are in the order of their thickness. Key: {}</source>
        <translation>Die Wände sind nach ihrer Dicke geordnet. Taste: {}</translation>
    </message>
    <message>
        <source>Walls that are shown as thin</source>
        <translation>Wände, die als dünn angezeigt werden</translation>
    </message>
    <message>
        <source>Walls that became thinner, the one that lost most first. Click: fly to it.</source>
        <translation>Wände, die dünner wurden, die mit dem größten Verlust zuerst. Klick: hinfliegen.</translation>
    </message>
    <message>
        <source>Walls thinner than this are coloured as thin</source>
        <translation>Dünnere Wände als diese werden als dünn eingefärbt</translation>
    </message>
    <message>
        <source>Walls thinner than this are coloured as thin; the verdict does not depend on it</source>
        <translation>Dünnere Wände als diese werden als dünn eingefärbt; das Ergebnis hängt nicht davon ab</translation>
    </message>
    <message>
        <source>Walls thinner than this share of the part's diagonal are coloured as thin</source>
        <translation>Wände, die dünner als dieser Anteil der Diagonale des Bauteils sind, werden als dünn eingefärbt</translation>
    </message>
    <message>
        <source>Walls under {} have fewer layers: they would take most of the elements.</source>
        <translation>Wände unter {} haben weniger Schichten: Sie bräuchten die meisten Elemente.</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Warnungen</translation>
    </message>
    <message>
        <source>What became thinner</source>
        <translation>Was dünner wurde</translation>
    </message>
    <message>
        <source>What became thinner…</source>
        <translation>Was dünner wurde…</translation>
    </message>
    <message>
        <source>What faces you is cut off. Choose the current view again after turning the part</source>
        <translation>Was Ihnen zugewandt ist, wird abgeschnitten. Wählen Sie nach dem Drehen des Bauteils die aktuelle Ansicht erneut</translation>
    </message>
    <message>
        <source>What it says about a part</source>
        <translation>Was es über ein Bauteil sagt</translation>
    </message>
    <message>
        <source>What to do with such a part</source>
        <translation>Was mit einem solchen Bauteil zu tun ist</translation>
    </message>
    <message>
        <source>What would change in</source>
        <translation>Was sich ändern würde in</translation>
    </message>
    <message>
        <source>What you change is saved as your own limits in {}.</source>
        <translation>Was Sie ändern, wird als Ihre eigenen Grenzen in {} gespeichert.</translation>
    </message>
    <message>
        <source>When a wall is thinner than</source>
        <translation>Wenn eine Wand dünner ist als</translation>
    </message>
    <message>
        <source>When libraries have a part already</source>
        <translation>Wenn Bibliotheken ein Bauteil schon haben</translation>
    </message>
    <message>
        <source>When the category of a part changes</source>
        <translation>Wenn sich die Kategorie eines Bauteils ändert</translation>
    </message>
    <message>
        <source>When the thinnest wall of a part falls below this thickness, or is below it in a part that was not classified before</source>
        <translation>Wenn die dünnste Wand eines Bauteils unter diese Stärke fällt oder bei einem bisher nicht klassifizierten Bauteil darunter liegt</translation>
    </message>
    <message>
        <source>Where the thresholds are from</source>
        <translation>Woher die Schwellenwerte stammen</translation>
    </message>
    <message>
        <source>Which part do you mean?</source>
        <translation>Welches Bauteil meinen Sie?</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Warum</translation>
    </message>
    <message>
        <source>Why it is left out, such as: a crush rib, thin on purpose</source>
        <translation>Warum sie wegbleibt, etwa: Quetschrippe, absichtlich dünn</translation>
    </message>
    <message>
        <source>Why, such as: a crush rib, thin on purpose</source>
        <translation>Warum, zum Beispiel: eine Quetschrippe, mit Absicht dünn</translation>
    </message>
    <message>
        <source>Why: {}</source>
        <translation>Grund: {}</translation>
    </message>
    <message>
        <source>With CalculiX as its solver, and steel, which you replace. Supports and loads are yours to add.</source>
        <translation>Mit CalculiX als Löser und Stahl, den Sie ersetzen. Lagerungen und Lasten fügen Sie selbst hinzu.</translation>
    </message>
    <message>
        <source>Without the check mark, a wall stays solid and is not in the shell.</source>
        <translation>Ohne Häkchen bleibt eine Wand Volumen und ist nicht in der Schale.</translation>
    </message>
    <message>
        <source>Words in names, paths, notes, links</source>
        <translation>Wörter in Namen, Pfaden, Notizen, Verknüpfungen</translation>
    </message>
    <message>
        <source>Writes a page about all parts of the libraries, or of the selected one: how many there are of each kind, a map, what is there more than once, and a table</source>
        <translation>Schreibt eine Seite über alle Bauteile der Bibliotheken oder der ausgewählten: wie viele es von jeder Art gibt, eine Karte, was mehrfach da ist, und eine Tabelle</translation>
    </message>
    <message>
        <source>Write…</source>
        <translation>Schreiben…</translation>
    </message>
    <message>
        <source>Writing a report</source>
        <translation>Bericht wird geschrieben</translation>
    </message>
    <message>
        <source>Writing a report about libraries</source>
        <translation>Bericht über Bibliotheken wird geschrieben</translation>
    </message>
    <message>
        <source>Writing the info file…</source>
        <translation>Infodatei wird geschrieben…</translation>
    </message>
    <message>
        <source>Writing {}…</source>
        <translation>{} wird geschrieben…</translation>
    </message>
    <message>
        <source>Written: {}</source>
        <translation>Geschrieben: {}</translation>
    </message>
    <message>
        <source>Your label is kept once the document is saved and its info file is written.</source>
        <translation>Ihre Einordnung wird aufbewahrt, sobald das Dokument gespeichert und seine Infodatei geschrieben ist.</translation>
    </message>
    <message>
        <source>Your name</source>
        <translation>Ihr Name</translation>
    </message>
    <message>
        <source>Your name, under which your labels of parts are kept. Empty: your name on this computer</source>
        <translation>Ihr Name, unter dem Ihre Einordnungen von Bauteilen aufbewahrt werden. Leer: Ihr Name auf diesem Rechner</translation>
    </message>
    <message>
        <source>a file with mesh settings</source>
        <translation>eine Datei mit Netzeinstellungen</translation>
    </message>
    <message>
        <source>a folder with classified parts</source>
        <translation>ein Ordner mit klassifizierten Bauteilen</translation>
    </message>
    <message>
        <source>a share of the part's diagonal</source>
        <translation>ein Anteil der Bauteildiagonale</translation>
    </message>
    <message>
        <source>a thickness</source>
        <translation>eine Wandstärke</translation>
    </message>
    <message>
        <source>about {} left</source>
        <translation>noch etwa {}</translation>
    </message>
    <message>
        <source>alike</source>
        <translation>ähnlich</translation>
    </message>
    <message>
        <source>all {} libraries</source>
        <translation>alle {} Bibliotheken</translation>
    </message>
    <message>
        <source>all, or such as: bracket*; *_v2*</source>
        <translation>alle, oder z. B.: halter*; *_v2*</translation>
    </message>
    <message>
        <source>an address or a folder</source>
        <translation>eine Adresse oder ein Ordner</translation>
    </message>
    <message>
        <source>and a smaller wall, {} of the surface</source>
        <translation>und eine kleinere Wand, {} der Oberfläche</translation>
    </message>
    <message>
        <source>and {} more parts</source>
        <translation>und {} weitere Bauteile</translation>
    </message>
    <message>
        <source>and {} smaller walls, {} of the surface</source>
        <translation>und {} kleinere Wände, {} der Oberfläche</translation>
    </message>
    <message>
        <source>any material</source>
        <translation>jedes Material</translation>
    </message>
    <message>
        <source>area with walls thinner than this share of the diagonal</source>
        <translation>Oberfläche mit Wänden, dünner als dieser Anteil der Diagonale</translation>
    </message>
    <message>
        <source>as before</source>
        <translation>wie zuvor</translation>
    </message>
    <message>
        <source>as on this computer</source>
        <translation>wie auf diesem Rechner</translation>
    </message>
    <message>
        <source>as proposed</source>
        <translation>wie vorgeschlagen</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>automatic: {}</source>
        <translation>automatisch: {}</translation>
    </message>
    <message>
        <source>bar</source>
        <translation>Stab</translation>
    </message>
    <message>
        <source>beside each document</source>
        <translation>neben jedem Dokument</translation>
    </message>
    <message>
        <source>block</source>
        <translation>Block</translation>
    </message>
    <message>
        <source>cancelled: finished results are saved, Start continues with the rest</source>
        <translation>abgebrochen: fertige Ergebnisse sind gespeichert, „Starten“ macht mit dem Rest weiter</translation>
    </message>
    <message>
        <source>element size {}</source>
        <translation>Elementgröße {}</translation>
    </message>
    <message>
        <source>error aimed at: {}, elements: {}</source>
        <translation>angestrebter Fehler: {}, Elemente: {}</translation>
    </message>
    <message>
        <source>excluded: {}</source>
        <translation>ausgeschlossen: {}</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fehlgeschlagen</translation>
    </message>
    <message>
        <source>failed: {}</source>
        <translation>fehlgeschlagen: {}</translation>
    </message>
    <message>
        <source>fails</source>
        <translation>durchgefallen</translation>
    </message>
    <message>
        <source>fine</source>
        <translation>fein</translation>
    </message>
    <message>
        <source>first, coarse colours</source>
        <translation>erste, grobe Farben</translation>
    </message>
    <message>
        <source>from {} on</source>
        <translation>ab {}</translation>
    </message>
    <message>
        <source>gamma: three times the inscribed by the circumscribed radius; 1 for regular tetrahedra, under 0.3 poor</source>
        <translation>gamma: dreimal der Radius der Inkugel durch den der Umkugel; 1 bei regelmäßigen Tetraedern, unter 0,3 schlecht</translation>
    </message>
    <message>
        <source>height {}</source>
        <translation>Höhe {}</translation>
    </message>
    <message>
        <source>identical</source>
        <translation>identisch</translation>
    </message>
    <message>
        <source>in</source>
        <translation>in</translation>
    </message>
    <message>
        <source>in the pre&amp;ferred folder</source>
        <translation>im &amp;voreingestellten Ordner</translation>
    </message>
    <message>
        <source>in {}</source>
        <translation>in {}</translation>
    </message>
    <message>
        <source>it holds nothing to link to</source>
        <translation>es enthält nichts, was verknüpft werden könnte</translation>
    </message>
    <message>
        <source>it is the active document itself</source>
        <translation>es ist das aktive Dokument selbst</translation>
    </message>
    <message>
        <source>largest ball over {}: too thick</source>
        <translation>größte Kugel über {}: zu dick</translation>
    </message>
    <message>
        <source>layers instead</source>
        <translation>stattdessen Schichten</translation>
    </message>
    <message>
        <source>layers: {}, elements: {}</source>
        <translation>Lagen: {}, Elemente: {}</translation>
    </message>
    <message>
        <source>learned</source>
        <translation>gelernt</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>ausgelassen</translation>
    </message>
    <message>
        <source>left solid: {}</source>
        <translation>bleibt Volumen: {}</translation>
    </message>
    <message>
        <source>length {}</source>
        <translation>Länge {}</translation>
    </message>
    <message>
        <source>limit {}</source>
        <translation>Grenze {}</translation>
    </message>
    <message>
        <source>linear (first order)</source>
        <translation>linear (erste Ordnung)</translation>
    </message>
    <message>
        <source>measuring…</source>
        <translation>wird gemessen…</translation>
    </message>
    <message>
        <source>min {}</source>
        <translation>min. {}</translation>
    </message>
    <message>
        <source>mirror image</source>
        <translation>Spiegelbild</translation>
    </message>
    <message>
        <source>more than {}</source>
        <translation>mehr als {}</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>no library yet</source>
        <translation>noch keine Bibliothek</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>keine Grenze</translation>
    </message>
    <message>
        <source>no mesh ({})</source>
        <translation>kein Netz ({})</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>none stated</source>
        <translation>keine angegeben</translation>
    </message>
    <message>
        <source>none, or such as: FDM, die_casting:zinc</source>
        <translation>keine, oder etwa: FDM, die_casting:zinc</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>not classified</source>
        <translation>nicht klassifiziert</translation>
    </message>
    <message>
        <source>not finished</source>
        <translation>nicht abgeschlossen</translation>
    </message>
    <message>
        <source>not in {}</source>
        <translation>nicht in {}</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>nothing came in</source>
        <translation>es wurde nichts eingelesen</translation>
    </message>
    <message>
        <source>of the diagonal</source>
        <translation>der Diagonale</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>one per processor</source>
        <translation>eine pro Prozessor</translation>
    </message>
    <message>
        <source>one size</source>
        <translation>eine Größe</translation>
    </message>
    <message>
        <source>only as the verdict needs</source>
        <translation>nur so weit das Urteil es braucht</translation>
    </message>
    <message>
        <source>only in {}</source>
        <translation>nur in {}</translation>
    </message>
    <message>
        <source>own limit</source>
        <translation>eigene Grenze</translation>
    </message>
    <message>
        <source>passes</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>pausing</source>
        <translation>wird angehalten</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>plate</source>
        <translation>Platte</translation>
    </message>
    <message>
        <source>quadratic (second order)</source>
        <translation>quadratisch (zweite Ordnung)</translation>
    </message>
    <message>
        <source>quality of the elements (gamma)</source>
        <translation>Qualität der Elemente (gamma)</translation>
    </message>
    <message>
        <source>radius {}</source>
        <translation>Radius {}</translation>
    </message>
    <message>
        <source>red is thin</source>
        <translation>Rot ist dünn</translation>
    </message>
    <message>
        <source>rib</source>
        <translation>Rippe</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>same limit as the verdict</source>
        <translation>gleiche Grenze wie das Ergebnis</translation>
    </message>
    <message>
        <source>share of the diagonal</source>
        <translation>Anteil der Diagonale</translation>
    </message>
    <message>
        <source>share of the diagonal ({})</source>
        <translation>Anteil der Diagonale ({})</translation>
    </message>
    <message>
        <source>shell</source>
        <translation>Schale</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>stufenlos</translation>
    </message>
    <message>
        <source>solid</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>standard</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>stopping</source>
        <translation>wird abgebrochen</translation>
    </message>
    <message>
        <source>such as: old/*; *draft*</source>
        <translation>z. B.: alt/*; *entwurf*</translation>
    </message>
    <message>
        <source>taper</source>
        <translation>Keil</translation>
    </message>
    <message>
        <source>the current view</source>
        <translation>die aktuelle Ansicht</translation>
    </message>
    <message>
        <source>the learned profile</source>
        <translation>dem gelernten Profil</translation>
    </message>
    <message>
        <source>the view cannot be drawn at this size</source>
        <translation>die Ansicht kann in dieser Größe nicht gezeichnet werden</translation>
    </message>
    <message>
        <source>there is no importer for such files</source>
        <translation>für solche Dateien gibt es keinen Import</translation>
    </message>
    <message>
        <source>thickest wall {}</source>
        <translation>dickste Wand {}</translation>
    </message>
    <message>
        <source>thickness: {}, and share of the diagonal</source>
        <translation>Wandstärke: {} und Anteil der Diagonale</translation>
    </message>
    <message>
        <source>thin</source>
        <translation>dünnwandig</translation>
    </message>
    <message>
        <source>thin below {}</source>
        <translation>dünn unter {}</translation>
    </message>
    <message>
        <source>thin features</source>
        <translation>teils dünn</translation>
    </message>
    <message>
        <source>thin in places</source>
        <translation>stellenweise dünn</translation>
    </message>
    <message>
        <source>thin on half of the face or more</source>
        <translation>auf mindestens der halben Fläche dünn</translation>
    </message>
    <message>
        <source>those that people keep in its info files</source>
        <translation>die in ihren Infodateien aufbewahrten</translation>
    </message>
    <message>
        <source>thread</source>
        <translation>Gewinde</translation>
    </message>
    <message>
        <source>to be measured again</source>
        <translation>neu zu messen</translation>
    </message>
    <message>
        <source>to keep</source>
        <translation>soll bleiben</translation>
    </message>
    <message>
        <source>tooth</source>
        <translation>Zahn</translation>
    </message>
    <message>
        <source>tube</source>
        <translation>Rohr</translation>
    </message>
    <message>
        <source>under {}: fails</source>
        <translation>unter {}: fällt durch</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>up to {}</source>
        <translation>bis {}</translation>
    </message>
    <message>
        <source>up to {} above it</source>
        <translation>bis zu {} darüber</translation>
    </message>
    <message>
        <source>values are missing or of another kind</source>
        <translation>Werte fehlen oder sind von anderer Art</translation>
    </message>
    <message>
        <source>wall {}</source>
        <translation>Wand {}</translation>
    </message>
    <message>
        <source>wedge {:g}–{:g}°</source>
        <translation>Keil {:g}–{:g}°</translation>
    </message>
    <message>
        <source>width {}</source>
        <translation>Breite {}</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>{} (edge)</source>
        <translation>{} (Kante)</translation>
    </message>
    <message>
        <source>{} (edge, {}×)</source>
        <translation>{} (Kante, {}×)</translation>
    </message>
    <message>
        <source>{} (in searches and tables: {})</source>
        <translation>{} (in Suchen und Tabellen: {})</translation>
    </message>
    <message>
        <source>{} (own)</source>
        <translation>{} (eigene)</translation>
    </message>
    <message>
        <source>{} (rule {})</source>
        <translation>„{}“ (Regel {})</translation>
    </message>
    <message>
        <source>{} (taper)</source>
        <translation>{} (Keil)</translation>
    </message>
    <message>
        <source>{} (taper, {}×)</source>
        <translation>{} (Keil, {}×)</translation>
    </message>
    <message>
        <source>{} (unsure)</source>
        <translation>{} (unsicher)</translation>
    </message>
    <message>
        <source>{} ({} parts)</source>
        <translation>{} ({} Bauteile)</translation>
    </message>
    <message>
        <source>{} ({} times)</source>
        <translation>{} ({}-mal)</translation>
    </message>
    <message>
        <source>{} ({}×)</source>
        <translation>{} ({}×)</translation>
    </message>
    <message>
        <source>{} Refresh the libraries to go on.</source>
        <translation>{} Aktualisieren Sie die Bibliotheken, um fortzufahren.</translation>
    </message>
    <message>
        <source>{} There are {} more failures.</source>
        <translation>{} Es gibt {} weitere Fehler.</translation>
    </message>
    <message>
        <source>{} and more: {} of the area</source>
        <translation>{} und mehr: {} der Oberfläche</translation>
    </message>
    <message>
        <source>{} cannot be reached.</source>
        <translation>{} ist nicht erreichbar.</translation>
    </message>
    <message>
        <source>{} cannot be written ({}): choose another place.</source>
        <translation>{} kann nicht geschrieben werden ({}): wählen Sie einen anderen Ort.</translation>
    </message>
    <message>
        <source>{} contains {}, which was removed from the list.</source>
        <translation>{} enthält {}; dieser Ordner wurde aus der Liste genommen.</translation>
    </message>
    <message>
        <source>{} different parts, {} instances</source>
        <translation>{} verschiedene Bauteile, {} Instanzen</translation>
    </message>
    <message>
        <source>{} elements, {} poor, worst {}</source>
        <translation>{} Elemente, {} schlecht, schlechtestes {}</translation>
    </message>
    <message>
        <source>{} entries</source>
        <translation>{} Einträge</translation>
    </message>
    <message>
        <source>{} failed</source>
        <translation>{} fehlgeschlagen</translation>
    </message>
    <message>
        <source>{} fails</source>
        <translation>{} fällt durch</translation>
    </message>
    <message>
        <source>{} h {} min</source>
        <translation>{} h {} min</translation>
    </message>
    <message>
        <source>{} has no info file.</source>
        <translation>{} hat keine Infodatei.</translation>
    </message>
    <message>
        <source>{} has several parts, of which none is named {}.</source>
        <translation>{} hat mehrere Bauteile, von denen keines {} heißt.</translation>
    </message>
    <message>
        <source>{} info files cannot be read.</source>
        <translation>{} Infodateien sind nicht lesbar.</translation>
    </message>
    <message>
        <source>{} info files were judged by another version of the profile {}.</source>
        <translation>{} Infodateien wurden nach einer anderen Fassung des Profils {} beurteilt.</translation>
    </message>
    <message>
        <source>{} info files were not changed: {}</source>
        <translation>{} Infodateien blieben unverändert: {}</translation>
    </message>
    <message>
        <source>{} info files were updated.</source>
        <translation>{} Infodateien wurden aktualisiert.</translation>
    </message>
    <message>
        <source>{} info files will be updated; {} parts change their category.</source>
        <translation>{} Infodateien werden aktualisiert; {} Bauteile wechseln ihre Kategorie.</translation>
    </message>
    <message>
        <source>{} is in the list already, as a part of {}.</source>
        <translation>{} ist schon in der Liste, als Teil von {}.</translation>
    </message>
    <message>
        <source>{} is in the list already.</source>
        <translation>{} ist schon in der Liste.</translation>
    </message>
    <message>
        <source>{} jobs: {}</source>
        <translation>{} Aufträge: {}</translation>
    </message>
    <message>
        <source>{} just above</source>
        <translation>{} knapp darüber</translation>
    </message>
    <message>
        <source>{} labelled parts: {}; by {}.</source>
        <translation>{} eingeordnete Bauteile: {}; von {}.</translation>
    </message>
    <message>
        <source>{} mid-surface</source>
        <translation>{}: Mittelfläche</translation>
    </message>
    <message>
        <source>{} min</source>
        <translation>{} min</translation>
    </message>
    <message>
        <source>{} of the area has walls thinner than {}</source>
        <translation>{} der Oberfläche haben Wände dünner als {}</translation>
    </message>
    <message>
        <source>{} of the volume in plate-like walls, {} times as wide as thick.</source>
        <translation>{} des Volumens in plattenartigen Wänden, {}-mal so breit wie dick.</translation>
    </message>
    <message>
        <source>{} of {} files</source>
        <translation>{} von {} Dateien</translation>
    </message>
    <message>
        <source>{} of {} parts</source>
        <translation>{} von {} Bauteilen</translation>
    </message>
    <message>
        <source>{} of {} parts change their category.</source>
        <translation>{} von {} Bauteilen wechseln ihre Kategorie.</translation>
    </message>
    <message>
        <source>{} of {} parts fail</source>
        <translation>{} von {} Teilen fallen durch</translation>
    </message>
    <message>
        <source>{} of {}: elements of {}</source>
        <translation>{} von {}: Elemente von {}</translation>
    </message>
    <message>
        <source>{} of {}: {} % ({} to {})</source>
        <translation>{} von {}: {} % ({} bis {})</translation>
    </message>
    <message>
        <source>{} passes</source>
        <translation>{} besteht</translation>
    </message>
    <message>
        <source>{} probes were removed: the surface is no longer at their positions.</source>
        <translation>{} Messpunkte wurden entfernt: Die Oberfläche ist nicht mehr dort, wo sie waren.</translation>
    </message>
    <message>
        <source>{} s</source>
        <translation>{} s</translation>
    </message>
    <message>
        <source>{} shell mesh</source>
        <translation>{}: Schalennetz</translation>
    </message>
    <message>
        <source>{} thick</source>
        <translation>{} dick</translation>
    </message>
    <message>
        <source>{} times as large</source>
        <translation>{}-mal so groß</translation>
    </message>
    <message>
        <source>{} to {}</source>
        <translation>{} bis {}</translation>
    </message>
    <message>
        <source>{} to {} thick ({} to {} of the diagonal): {} of the area</source>
        <translation>{} bis {} Wandstärke ({} bis {} der Diagonale): {} der Oberfläche</translation>
    </message>
    <message>
        <source>{} to {}: {} of the area</source>
        <translation>{} bis {}: {} der Oberfläche</translation>
    </message>
    <message>
        <source>{} to {}: {} of the area, on 1 face</source>
        <translation>{} bis {}: {} der Oberfläche, auf 1 Fläche</translation>
    </message>
    <message>
        <source>{} to {}: {} of the area, on {} faces</source>
        <translation>{} bis {}: {} der Oberfläche, auf {} Flächen</translation>
    </message>
    <message>
        <source>{} too thick</source>
        <translation>{} zu dick</translation>
    </message>
    <message>
        <source>{} triangles of up to {}; walls {} thick, {} of the part's volume.</source>
        <translation>{} Dreiecke bis {}; Wände {} dick, {} des Volumens des Teils.</translation>
    </message>
    <message>
        <source>{} unchanged</source>
        <translation>{} unverändert</translation>
    </message>
    <message>
        <source>{} warnings; {}</source>
        <translation>{} Warnungen; {}</translation>
    </message>
    <message>
        <source>{} was imported into {}.</source>
        <translation>{} wurde in {} importiert.</translation>
    </message>
    <message>
        <source>{} was not opened: it is not a CAD file that ThinPart reads.</source>
        <translation>{} wurde nicht geöffnet: Es ist keine CAD-Datei, die ThinPart liest.</translation>
    </message>
    <message>
        <source>{} was not written by ThinPart.</source>
        <translation>{} wurde nicht von ThinPart geschrieben.</translation>
    </message>
    <message>
        <source>{}, and share of the diagonal</source>
        <translation>{} und Anteil der Diagonale</translation>
    </message>
    <message>
        <source>{}, mirrored</source>
        <translation>{}, gespiegelt</translation>
    </message>
    <message>
        <source>{}, {}: {}</source>
        <translation>{}, {}: {}</translation>
    </message>
    <message>
        <source>{}. {}, where one of these holds</source>
        <translation>{}. {}, wenn eines davon erfüllt ist</translation>
    </message>
    <message>
        <source>{}: '{}' ({}) has a wall of {}, below the limit of {}.</source>
        <translation>{}: „{}“ ({}) hat eine Wand von {}, unter der Grenze von {}.</translation>
    </message>
    <message>
        <source>{}: '{}' was '{}' and is '{}' now; its thinnest wall is {}.</source>
        <translation>{}: „{}“ war „{}“ und ist jetzt „{}“; die dünnste Wand hat {}.</translation>
    </message>
    <message>
        <source>{}: '{}' was '{}' and is '{}' now; its thinnest wall of {} is below the limit of {}.</source>
        <translation>{}: „{}“ war „{}“ und ist jetzt „{}“; die dünnste Wand von {} liegt unter der Grenze von {}.</translation>
    </message>
    <message>
        <source>{}: '{}' was '{}' and is '{}' now; none of its walls could be measured.</source>
        <translation>{}: „{}“ war „{}“ und ist jetzt „{}“; keine der Wände konnte gemessen werden.</translation>
    </message>
    <message>
        <source>{}: an earlier version of ThinPart has measured this document, but not all that decides today: classify it again.</source>
        <translation>{}: Eine frühere Version von ThinPart hat dieses Dokument vermessen, aber nicht alles, was heute entscheidet: Klassifizieren Sie es erneut.</translation>
    </message>
    <message>
        <source>{}: looking for info files, {} so far</source>
        <translation>{}: Infodateien werden gesucht, bisher {}</translation>
    </message>
    <message>
        <source>{}: walls {} ({})</source>
        <translation>{}: Wände {} ({})</translation>
    </message>
    <message>
        <source>{}: {}</source>
        <translation>{}: {}</translation>
    </message>
    <message>
        <source>{}: {} of {} info files read</source>
        <translation>{}: {} von {} Infodateien gelesen</translation>
    </message>
    <message>
        <source>{} % like: {}</source>
        <translation>{} % ähnlich: {}</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>×</source>
        <translation>×</translation>
    </message>
    <message>
        <source>⚠ The part has changed since it was measured.</source>
        <translation>⚠ Das Bauteil hat sich seit der Messung geändert.</translation>
    </message>
    <message>
        <source>✓ {}: within the limits</source>
        <translation>✓ {}: innerhalb der Grenzen</translation>
    </message>
    <message>
        <source>✗ The largest ball here is too large: at most {} are allowed</source>
        <translation>✗ Die größte Kugel hier ist zu groß: Höchstens {} sind zulässig</translation>
    </message>
    <message>
        <source>✗ {}: at least {} are needed here</source>
        <translation>✗ {}: hier sind mindestens {} nötig</translation>
    </message>
</context>
<context>
    <name>ThinPartCore</name>
    <message>
        <source>'{object}' has an empty shape: recompute the document or delete it.</source>
        <translation>„{object}“ hat eine leere Form: Berechnen Sie das Dokument neu oder löschen Sie das Objekt.</translation>
    </message>
    <message>
        <source>'{object}' has no shape, because its last recompute failed ({reason}): repair it and recompute the document.</source>
        <translation>„{object}“ hat keine Form, weil die letzte Neuberechnung fehlgeschlagen ist ({reason}): Reparieren Sie das Objekt und berechnen Sie das Dokument neu.</translation>
    </message>
    <message>
        <source>'{object}' has no shape, because the last recompute of '{feature}' failed ({reason}): repair it and recompute the document.</source>
        <translation>„{object}“ hat keine Form, weil die letzte Neuberechnung von „{feature}“ fehlgeschlagen ist ({reason}): Reparieren Sie das Objekt und berechnen Sie das Dokument neu.</translation>
    </message>
    <message>
        <source>'{object}' is a closed shell but not a solid: convert it to a solid first.</source>
        <translation>„{object}“ ist eine geschlossene Schale, aber kein Volumenkörper: Wandeln Sie sie zuerst in einen Volumenkörper um.</translation>
    </message>
    <message>
        <source>'{object}' is a mesh without triangles: import it again or delete it.</source>
        <translation>„{object}“ ist ein Netz ohne Dreiecke: Importieren Sie es erneut oder löschen Sie es.</translation>
    </message>
    <message>
        <source>'{object}' is made of surfaces that bound no solid: close or thicken it first.</source>
        <translation>„{object}“ besteht aus Flächen, die keinen Volumenkörper begrenzen: Schließen Sie sie zuerst oder geben Sie ihnen eine Wandstärke.</translation>
    </message>
    <message>
        <source>'{part}' consists of {count} solids, which FEM meshes as one: take it apart first (Part workbench: Compound &gt; Explode compound), then select one solid.</source>
        <translation>„{part}“ besteht aus {count} Festkörpern, die FEM als einen vernetzt: Zerlegen Sie es zuerst (Arbeitsbereich Part: Verbund &gt; Verbund auflösen) und wählen Sie dann einen Festkörper.</translation>
    </message>
    <message>
        <source>(in no folder of its own)</source>
        <translation>(in keinem eigenen Ordner)</translation>
    </message>
    <message>
        <source>(the ring is at the thinnest wall)</source>
        <translation>(der Ring ist an der dünnsten Wand)</translation>
    </message>
    <message>
        <source>, not sure</source>
        <translation>, nicht sicher</translation>
    </message>
    <message>
        <source>, not watertight</source>
        <translation>, nicht geschlossen</translation>
    </message>
    <message>
        <source>, {count} times in the document</source>
        <translation>, {count}-mal im Dokument</translation>
    </message>
    <message>
        <source>--bands takes a number from 0, for smooth colours, to 64.</source>
        <translation>--bands nimmt eine Zahl von 0, für stufenlose Farben, bis 64.</translation>
    </message>
    <message>
        <source>--error decides the sizes of elements of second order: leave out --layers and --order 1.</source>
        <translation>--error bestimmt die Größen von Elementen zweiter Ordnung: Lassen Sie --layers und --order 1 weg.</translation>
    </message>
    <message>
        <source>--keep goes with --check, which shows what works.</source>
        <translation>--keep gehört zu --check, das zeigt, was sich bewährt.</translation>
    </message>
    <message>
        <source>--library reads info files only, and takes no {option}: leave it out.</source>
        <translation>--library liest nur Infodateien und nimmt kein {option}: Lassen Sie es weg.</translation>
    </message>
    <message>
        <source>--like is for one part: name one file.</source>
        <translation>--like gilt für ein Teil: nennen Sie eine Datei.</translation>
    </message>
    <message>
        <source>--range takes the thinner wall first, then the thicker: not {low} and {high}.</source>
        <translation>--range nimmt zuerst die dünnere Wand, dann die dickere: nicht {low} und {high}.</translation>
    </message>
    <message>
        <source>1 document has no info file and is not on this page: 'thinpart classify' measures it.</source>
        <translation>1 Dokument hat keine Infodatei und fehlt auf dieser Seite: „thinpart classify“ misst es.</translation>
    </message>
    <message>
        <source>1 duplicate triangle was left out.</source>
        <translation>1 doppeltes Dreieck wurde weggelassen.</translation>
    </message>
    <message>
        <source>1 part is not on the map: no wall was found opposite, or its surface is not closed.</source>
        <translation>1 Teil ist nicht auf der Karte: Gegenüber wurde keine Wand gefunden, oder die Oberfläche ist nicht geschlossen.</translation>
    </message>
    <message>
        <source>1 triangle of zero area was left out.</source>
        <translation>1 Dreieck mit Flächeninhalt null wurde weggelassen.</translation>
    </message>
    <message>
        <source>1 warning</source>
        <translation>1 Warnung</translation>
    </message>
    <message>
        <source>A budget is at least 1 element, not {value}.</source>
        <translation>Ein Budget ist mindestens 1 Element, nicht {value}.</translation>
    </message>
    <message>
        <source>A bulky part with thin places: refine the mesh there or remove them.</source>
        <translation>Ein massiges Bauteil mit dünnen Stellen: Verfeinern Sie dort das Netz oder entfernen Sie sie.</translation>
    </message>
    <message>
        <source>A limit for single faces needs a reason.</source>
        <translation>Eine Grenze für einzelne Flächen braucht einen Grund.</translation>
    </message>
    <message>
        <source>A script or a shell is for one part, and there are {count} documents: name one of them, or the part after --part.</source>
        <translation>Ein Skript oder eine Schale ist für ein Bauteil, und es gibt {count} Dokumente: Nennen Sie eines davon oder das Bauteil nach --part.</translation>
    </message>
    <message>
        <source>ABS</source>
        <translation>ABS</translation>
    </message>
    <message>
        <source>Acetal (POM)</source>
        <translation>Polyacetal (POM)</translation>
    </message>
    <message>
        <source>Across:</source>
        <translation>Nach rechts:</translation>
    </message>
    <message>
        <source>Acrylic (PMMA)</source>
        <translation>Acrylglas (PMMA)</translation>
    </message>
    <message>
        <source>Alike</source>
        <translation>Ähnlich</translation>
    </message>
    <message>
        <source>Alike: {percent:.0f} % of the surface is the same, the rest up to {apart:.2g} apart.</source>
        <translation>Ähnlich: {percent:.0f} % der Oberfläche sind gleich, der Rest liegt bis zu {apart:.2g} auseinander.</translation>
    </message>
    <message>
        <source>Alike: {percent:.0f} % of the surface is the same.</source>
        <translation>Ähnlich: {percent:.0f} % der Oberfläche sind gleich.</translation>
    </message>
    <message>
        <source>All its triangles have zero area.</source>
        <translation>Alle Dreiecke haben den Flächeninhalt null.</translation>
    </message>
    <message>
        <source>All parts</source>
        <translation>Alle Teile</translation>
    </message>
    <message>
        <source>All parts of this report</source>
        <translation>Alle Bauteile dieses Berichts</translation>
    </message>
    <message>
        <source>All points coincide.</source>
        <translation>Alle Punkte fallen zusammen.</translation>
    </message>
    <message>
        <source>All walls are to stay solid: choose at least one for the shell.</source>
        <translation>Alle Wände sollen Volumen bleiben: Wählen Sie mindestens eine für die Schale.</translation>
    </message>
    <message>
        <source>Aluminium</source>
        <translation>Aluminium</translation>
    </message>
    <message>
        <source>Aluminium, large casting</source>
        <translation>Aluminium, großes Gussteil</translation>
    </message>
    <message>
        <source>Aluminium, small casting</source>
        <translation>Aluminium, kleines Gussteil</translation>
    </message>
    <message>
        <source>An earlier version has measured {file}: classify it again, to compare it.</source>
        <translation>Eine frühere Version hat {file} gemessen: Klassifizieren Sie es erneut, um es zu vergleichen.</translation>
    </message>
    <message>
        <source>Area of its surface</source>
        <translation>Flächeninhalt der Oberfläche</translation>
    </message>
    <message>
        <source>Area, {unit}</source>
        <translation>Fläche, {unit}</translation>
    </message>
    <message>
        <source>At least, {unit}</source>
        <translation>Mindestens, {unit}</translation>
    </message>
    <message>
        <source>At most, {unit}</source>
        <translation>Höchstens, {unit}</translation>
    </message>
    <message>
        <source>At the thinnest wall, {thickness} between {face} and {opposite}</source>
        <translation>An der dünnsten Wand, {thickness} zwischen {face} und {opposite}</translation>
    </message>
    <message>
        <source>Bar chart: share of the surface over walls of each thickness, up to {end}; walls under {limit} count as thin</source>
        <translation>Balkendiagramm: Anteil der Oberfläche über Wänden jeder Dicke, bis {end}; Wände unter {limit} gelten als dünn</translation>
    </message>
    <message>
        <source>Belongs to</source>
        <translation>Gehört zu</translation>
    </message>
    <message>
        <source>Borderline: close to “{other}” ({margin} from the limit).</source>
        <translation>Grenzfall: nahe an „{other}“ ({margin} von der Grenze).</translation>
    </message>
    <message>
        <source>Bounding box</source>
        <translation>Hüllquader</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Hüllquader</translation>
    </message>
    <message>
        <source>Brass, large casting</source>
        <translation>Messing, großes Gussteil</translation>
    </message>
    <message>
        <source>Brass, small casting</source>
        <translation>Messing, kleines Gussteil</translation>
    </message>
    <message>
        <source>By category</source>
        <translation>Nach Kategorie</translation>
    </message>
    <message>
        <source>By the paper's criteria: unknown. {reason}</source>
        <translation>Nach den Kriterien des Artikels: unbekannt. {reason}</translation>
    </message>
    <message>
        <source>By the paper's criteria: {category} (criterion {number}: {figures}).</source>
        <translation>Nach den Kriterien des Artikels: {category} (Kriterium {number}: {figures}).</translation>
    </message>
    <message>
        <source>By the paper's criteria: {category} (criterion {number}: {figures}; also {others}).</source>
        <translation>Nach den Kriterien des Artikels: {category} (Kriterium {number}: {figures}; auch {others}).</translation>
    </message>
    <message>
        <source>By the paper's criteria: {category} (no criterion holds).</source>
        <translation>Nach den Kriterien des Artikels: {category} (kein Kriterium ist erfüllt).</translation>
    </message>
    <message>
        <source>By the paper’s thresholds</source>
        <translation>Nach den Schwellen des Artikels</translation>
    </message>
    <message>
        <source>Calibrated on real parts</source>
        <translation>An echten Teilen kalibriert</translation>
    </message>
    <message>
        <source>Category</source>
        <translation>Kategorie</translation>
    </message>
    <message>
        <source>Clear verdict: {margin} from the limit.</source>
        <translation>Eindeutig: {margin} von der Grenze.</translation>
    </message>
    <message>
        <source>Colours from {low} to {high} and more; grey where nothing was measured</source>
        <translation>Farben von {low} bis {high} und mehr; grau, wo nichts gemessen wurde</translation>
    </message>
    <message>
        <source>Colours stand for the diameter of the largest ball inside that touches the surface there, which goes down to nothing at sharp edges. Verdict, tables and the thinnest wall are measured straight across.</source>
        <translation>Die Farben stehen für den Durchmesser der größten Kugel im Innern, die die Oberfläche dort berührt; zu scharfen Kanten hin geht er auf null zurück. Urteil, Tabellen und dünnste Wand sind gerade hindurch gemessen.</translation>
    </message>
    <message>
        <source>Colours stand for the local thickness, the diameter of the largest ball inside that reaches the surface there. Verdict, tables and the thinnest wall are measured straight across.</source>
        <translation>Die Farben stehen für die örtliche Dicke, den Durchmesser der größten Kugel im Inneren, die dort bis zur Oberfläche reicht. Urteil, Tabellen und die dünnste Wand sind geradewegs hindurch gemessen.</translation>
    </message>
    <message>
        <source>Connected walls of like thickness, equal ones in one row; the thinnest first</source>
        <translation>Zusammenhängende Wände ähnlicher Dicke, gleiche in einer Zeile; die dünnste zuerst</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>Could not be measured</source>
        <translation>Konnte nicht gemessen werden</translation>
    </message>
    <message>
        <source>Counts</source>
        <translation>Anzahlen</translation>
    </message>
    <message>
        <source>Cutting the mid-faces of the walls to each other takes too long, as there are too many that nearly touch: mesh it as a solid.</source>
        <translation>Die Mittelflächen der Wände aneinander zu schneiden dauert zu lange, da sich zu viele fast berühren: Vernetzen Sie das Teil als Volumen.</translation>
    </message>
    <message>
        <source>Developed width, {unit}</source>
        <translation>Abgewickelte Breite, {unit}</translation>
    </message>
    <message>
        <source>Diagonal of the bounding box</source>
        <translation>Diagonale des Hüllquaders</translation>
    </message>
    <message>
        <source>Die casting</source>
        <translation>Druckguss</translation>
    </message>
    <message>
        <source>Document</source>
        <translation>Dokument</translation>
    </message>
    <message>
        <source>Ductile iron</source>
        <translation>Gusseisen mit Kugelgraphit</translation>
    </message>
    <message>
        <source>Error of a wall at most</source>
        <translation>Fehler einer Wand höchstens</translation>
    </message>
    <message>
        <source>Every criterion of the profile “{profile}” with what was measured; the category is the first of which one criterion holds</source>
        <translation>Jedes Kriterium des Profils „{profile}“ mit den Messwerten; die Kategorie ist die erste, von der ein Kriterium zutrifft</translation>
    </message>
    <message>
        <source>FDM printing</source>
        <translation>FDM-Druck</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Faces that meet in a thin wedge</source>
        <translation>Flächen bilden einen dünnen Keil</translation>
    </message>
    <message>
        <source>Faces: {faces} and {count} more.</source>
        <translation>Flächen: {faces} und {count} weitere.</translation>
    </message>
    <message>
        <source>Faces: {faces}.</source>
        <translation>Flächen: {faces}.</translation>
    </message>
    <message>
        <source>Families</source>
        <translation>Familien</translation>
    </message>
    <message>
        <source>Family {number}: {part}, {count} parts</source>
        <translation>Familie {number}: {part}, {count} Teile</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Füllung</translation>
    </message>
    <message>
        <source>Fills little of its box</source>
        <translation>Füllt den Hüllquader kaum</translation>
    </message>
    <message>
        <source>Flat and about as long as wide</source>
        <translation>Flach und etwa so lang wie breit</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Dateiformat</translation>
    </message>
    <message>
        <source>Free-standing</source>
        <translation>Freistehend</translation>
    </message>
    <message>
        <source>FreeCAD cannot be imported by {program} ({problem}): install it (Debian: 'apt-get install freecad') or set FREECAD_LIB to the folder with its FreeCAD.so or FreeCAD.pyd.</source>
        <translation>FreeCAD kann von {program} nicht importiert werden ({problem}): Installieren Sie es (Debian: „apt-get install freecad“) oder setzen Sie FREECAD_LIB auf den Ordner mit seiner FreeCAD.so oder FreeCAD.pyd.</translation>
    </message>
    <message>
        <source>FreeCAD cannot open {file} ({problem}).</source>
        <translation>FreeCAD kann {file} nicht öffnen ({problem}).</translation>
    </message>
    <message>
        <source>FreeCAD cannot read it</source>
        <translation>FreeCAD kann sie nicht lesen</translation>
    </message>
    <message>
        <source>FreeCAD cannot read it: open it in the program it came from, and export it again</source>
        <translation>FreeCAD kann sie nicht lesen: Öffnen Sie sie in dem Programm, aus dem sie kommt, und exportieren Sie sie noch einmal</translation>
    </message>
    <message>
        <source>FreeCAD cannot read {file} ({problem}).</source>
        <translation>FreeCAD kann {file} nicht lesen ({problem}).</translation>
    </message>
    <message>
        <source>FreeCAD cannot write them</source>
        <translation>FreeCAD kann sie nicht schreiben</translation>
    </message>
    <message>
        <source>FreeCAD could not tessellate any of its faces.</source>
        <translation>FreeCAD konnte keine der Flächen tessellieren.</translation>
    </message>
    <message>
        <source>FreeCAD could not tessellate it ({problem}).</source>
        <translation>FreeCAD konnte das Bauteil nicht tessellieren ({problem}).</translation>
    </message>
    <message>
        <source>FreeCAD could not tessellate {faces} and {count} more.</source>
        <translation>FreeCAD konnte {faces} und {count} weitere nicht tessellieren.</translation>
    </message>
    <message>
        <source>FreeCAD could not tessellate {faces}.</source>
        <translation>FreeCAD konnte {faces} nicht tessellieren.</translation>
    </message>
    <message>
        <source>FreeCAD did not say which triangle belongs to which face.</source>
        <translation>FreeCAD gab nicht an, welches Dreieck zu welcher Fläche gehört.</translation>
    </message>
    <message>
        <source>FreeCAD does not follow links from a document whose path is not UTF-8 text or has a backslash: rename {file} or its folder.</source>
        <translation>FreeCAD folgt keinen Verknüpfungen aus einem Dokument, dessen Pfad kein UTF-8-Text ist oder einen umgekehrten Schrägstrich enthält: Benennen Sie {file} oder seinen Ordner um.</translation>
    </message>
    <message>
        <source>FreeCAD finds no cut</source>
        <translation>FreeCAD findet keinen Schnitt</translation>
    </message>
    <message>
        <source>FreeCAD needs a home folder, but {folder} is not accessible: set FREECAD_USER_HOME to a folder that is.</source>
        <translation>FreeCAD braucht einen Benutzerordner, aber {folder} ist nicht zugänglich: Setzen Sie FREECAD_USER_HOME auf einen zugänglichen Ordner.</translation>
    </message>
    <message>
        <source>FreeCAD's mesher left out {left_out}: a copy was measured whose edges were fitted to its faces; check the shape of the part, and export it again if it is damaged.</source>
        <translation>Der Vernetzer von FreeCAD hat {left_out} ausgelassen: Gemessen wurde eine Kopie, deren Kanten an die Flächen angepasst sind; prüfen Sie die Form des Bauteils, und exportieren Sie es noch einmal, wenn es beschädigt ist.</translation>
    </message>
    <message>
        <source>FreeCAD's mesher left out {left_out}: a copy was measured whose surfaces were converted to splines; its volume agrees with that of the part.</source>
        <translation>Der Vernetzer von FreeCAD hat {left_out} ausgelassen: Gemessen wurde eine Kopie, deren Flächen in Splines umgewandelt sind; ihr Volumen stimmt mit dem des Bauteils überein.</translation>
    </message>
    <message>
        <source>From behind, below</source>
        <translation>Von hinten unten</translation>
    </message>
    <message>
        <source>From the front, above</source>
        <translation>Von vorn oben</translation>
    </message>
    <message>
        <source>From the thinnest wall of polypropylene to the thickest of polyethylene: choose the resin for its own limits.</source>
        <translation>Von der dünnsten Wand aus Polypropylen bis zur dicksten aus Polyethylen: Wählen Sie den Kunststoff, um dessen eigene Grenzen zu erhalten.</translation>
    </message>
    <message>
        <source>Further faces; all of them are in faces.csv as well</source>
        <translation>Weitere Flächen; alle stehen auch in faces.csv</translation>
    </message>
    <message>
        <source>Giannini et al. 2012</source>
        <translation>Giannini u. a. 2012</translation>
    </message>
    <message>
        <source>Giannini, Petton, Pernot: Categorization of CAD models based on thin part identification, TMCE 2012, tables 1 and 2</source>
        <translation>Giannini, Petton, Pernot: Categorization of CAD models based on thin part identification, TMCE 2012, Tabellen 1 und 2</translation>
    </message>
    <message>
        <source>Gmsh crashed</source>
        <translation>Gmsh ist abgestürzt</translation>
    </message>
    <message>
        <source>Gmsh filled no volume</source>
        <translation>Gmsh hat kein Volumen gefüllt</translation>
    </message>
    <message>
        <source>Gmsh needed too much memory</source>
        <translation>Gmsh brauchte zu viel Speicher</translation>
    </message>
    <message>
        <source>Gmsh took too long</source>
        <translation>Gmsh brauchte zu lange</translation>
    </message>
    <message>
        <source>Gmsh wrote no mesh</source>
        <translation>Gmsh hat kein Netz geschrieben</translation>
    </message>
    <message>
        <source>Grey iron</source>
        <translation>Grauguss</translation>
    </message>
    <message>
        <source>Group {number}: {part}, {count} parts</source>
        <translation>Gruppe {number}: {part}, {count} Teile</translation>
    </message>
    <message>
        <source>Held on two sides</source>
        <translation>An zwei Seiten gehalten</translation>
    </message>
    <message>
        <source>Holds</source>
        <translation>Erfüllt</translation>
    </message>
    <message>
        <source>How it was measured</source>
        <translation>Wie gemessen wurde</translation>
    </message>
    <message>
        <source>How near it is to another category cannot be told.</source>
        <translation>Wie nahe es einer anderen Kategorie ist, lässt sich nicht sagen.</translation>
    </message>
    <message>
        <source>Identical</source>
        <translation>Gleich</translation>
    </message>
    <message>
        <source>Info files cannot be written into {folder} ({problem}): give another folder to --info-dir.</source>
        <translation>In {folder} können keine Infodateien geschrieben werden ({problem}): Wählen Sie einen anderen Ordner dafür (--info-dir).</translation>
    </message>
    <message>
        <source>Injection moulding</source>
        <translation>Spritzguss</translation>
    </message>
    <message>
        <source>It came as {faces} loose faces, which were sewn together.</source>
        <translation>Es lag als {faces} lose Flächen vor, die zusammengenäht wurden.</translation>
    </message>
    <message>
        <source>It holds no triangles.</source>
        <translation>Es enthält keine Dreiecke.</translation>
    </message>
    <message>
        <source>It is {length:.4g} higher.</source>
        <translation>Es ist {length:.4g} höher.</translation>
    </message>
    <message>
        <source>It is {length:.4g} longer.</source>
        <translation>Es ist {length:.4g} länger.</translation>
    </message>
    <message>
        <source>It is {length:.4g} lower.</source>
        <translation>Es ist {length:.4g} niedriger.</translation>
    </message>
    <message>
        <source>It is {length:.4g} narrower.</source>
        <translation>Es ist {length:.4g} schmaler.</translation>
    </message>
    <message>
        <source>It is {length:.4g} shorter.</source>
        <translation>Es ist {length:.4g} kürzer.</translation>
    </message>
    <message>
        <source>It is {length:.4g} wider.</source>
        <translation>Es ist {length:.4g} breiter.</translation>
    </message>
    <message>
        <source>Its bounding box is empty or not finite.</source>
        <translation>Der Hüllquader ist leer oder nicht endlich.</translation>
    </message>
    <message>
        <source>Its faces</source>
        <translation>Die Flächen</translation>
    </message>
    <message>
        <source>Its surface encloses no volume.</source>
        <translation>Die Oberfläche umschließt kein Volumen.</translation>
    </message>
    <message>
        <source>Its walls</source>
        <translation>Die Wände</translation>
    </message>
    <message>
        <source>Judged by the profile “{profile}”.</source>
        <translation>Beurteilt nach dem Profil „{profile}“.</translation>
    </message>
    <message>
        <source>Labels:</source>
        <translation>Einstufungen:</translation>
    </message>
    <message>
        <source>Layers are from 0.1 to {most:g}, not {value:g}.</source>
        <translation>Lagen sind von 0,1 bis {most:g} möglich, nicht {value:g}.</translation>
    </message>
    <message>
        <source>Learned on {date} from labels of {count} parts by {people}, starting at the profile {start}</source>
        <translation>Gelernt am {date} aus Einordnungen von {count} Bauteilen durch {people}, ausgehend vom Profil {start}</translation>
    </message>
    <message>
        <source>Learning needs the Python package scikit-learn ({problem}): install it (Debian: 'apt-get install python3-sklearn', elsewhere: 'python -m pip install scikit-learn').</source>
        <translation>Das Lernen braucht das Python-Paket scikit-learn ({problem}): Installieren Sie es (Debian: „apt-get install python3-sklearn“, sonst: „python -m pip install scikit-learn“).</translation>
    </message>
    <message>
        <source>Least distance, in diagonals, between walls at a to b degrees</source>
        <translation>Kleinster Abstand, in Diagonalen, zwischen Wänden im Winkel von a bis b Grad</translation>
    </message>
    <message>
        <source>Least distance, in diagonals, between walls at {low:g} to {high:g} degrees</source>
        <translation>Kleinster Abstand, in Diagonalen, zwischen Wänden im Winkel von {low:g} bis {high:g} Grad</translation>
    </message>
    <message>
        <source>Least width of a face: twice its area by the length of its border</source>
        <translation>Kleinste Breite einer Fläche: das Doppelte ihres Inhalts durch die Länge ihres Randes</translation>
    </message>
    <message>
        <source>Least, {unit}</source>
        <translation>Kleinste, {unit}</translation>
    </message>
    <message>
        <source>Length of knife's edges, faces that meet at under 30 degrees, in diagonals</source>
        <translation>Länge der Messerkanten, an denen sich Flächen unter weniger als 30 Grad treffen, in Diagonalen</translation>
    </message>
    <message>
        <source>Length of the shortest edge</source>
        <translation>Länge der kürzesten Kante</translation>
    </message>
    <message>
        <source>Length, {unit}</source>
        <translation>Länge, {unit}</translation>
    </message>
    <message>
        <source>Library of 1 part</source>
        <translation>Bibliothek mit 1 Teil</translation>
    </message>
    <message>
        <source>Library of {count} parts</source>
        <translation>Bibliothek mit {count} Teilen</translation>
    </message>
    <message>
        <source>Light alloys in green sand; iron needs more.</source>
        <translation>Leichtmetalle in Grünsand; Eisen braucht mehr.</translation>
    </message>
    <message>
        <source>Limits for single faces are lengths over 0, the least one no greater than the other.</source>
        <translation>Grenzen für einzelne Flächen sind Längen über 0, die kleinste nicht größer als die andere.</translation>
    </message>
    <message>
        <source>Limits of the wall</source>
        <translation>Grenzen der Wandstärke</translation>
    </message>
    <message>
        <source>Liquid crystal polymer</source>
        <translation>Flüssigkristallpolymer</translation>
    </message>
    <message>
        <source>Local thickness below which 5 % of the area is, in diagonals</source>
        <translation>Örtliche Dicke in Diagonalen, unter der 5 % der Oberfläche liegen</translation>
    </message>
    <message>
        <source>Local thickness, by the middle side, that 5 % of the area is below</source>
        <translation>Örtliche Dicke, durch die mittlere Seite, unter der 5 % der Fläche liegen</translation>
    </message>
    <message>
        <source>Local thickness, by the middle side, that 75 % of the area is below</source>
        <translation>Örtliche Dicke, durch die mittlere Seite, unter der 75 % der Fläche liegen</translation>
    </message>
    <message>
        <source>Local thickness, by the middle side, that 99 % of the area is below</source>
        <translation>Örtliche Dicke, durch die mittlere Seite, unter der 99 % der Fläche liegen</translation>
    </message>
    <message>
        <source>Long-fibre reinforced plastics</source>
        <translation>Langfaserverstärkte Kunststoffe</translation>
    </message>
    <message>
        <source>Longest side of the bounding box</source>
        <translation>Längste Seite des Hüllquaders</translation>
    </message>
    <message>
        <source>Longest to middle side of the bounding box</source>
        <translation>Längste zu mittlerer Seite des Hüllquaders</translation>
    </message>
    <message>
        <source>Machining</source>
        <translation>Zerspanung</translation>
    </message>
    <message>
        <source>Made by</source>
        <translation>Erzeugt von</translation>
    </message>
    <message>
        <source>Made of what info files keep; no document was read.</source>
        <translation>Aus den Infodateien erstellt; kein Dokument wurde gelesen.</translation>
    </message>
    <message>
        <source>Magnesium, large casting</source>
        <translation>Magnesium, großes Gussteil</translation>
    </message>
    <message>
        <source>Magnesium, small casting</source>
        <translation>Magnesium, kleines Gussteil</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>Map of the parts</source>
        <translation>Karte der Teile</translation>
    </message>
    <message>
        <source>Map of {count} parts: across, the median wall as a share of the diagonal of the box; upwards, the share of its box that a part fills</source>
        <translation>Karte von {count} Teilen: nach rechts die mittlere Wand als Anteil der Diagonale des Hüllquaders, nach oben der Anteil, den ein Teil von seinem Hüllquader füllt</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Bedeutung</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>Median of the local thickness, by the middle side</source>
        <translation>Median der örtlichen Dicke, durch die mittlere Seite</translation>
    </message>
    <message>
        <source>Median thickness of the thinnest ribs, pins, teeth or thread on a solid core, by the middle side; 1 without any</source>
        <translation>Mittlere Dicke der dünnsten Rippen, Stifte, Zähne oder Gewinde auf einem massiven Kern, durch die mittlere Seite; 1 ohne solche</translation>
    </message>
    <message>
        <source>Median thickness of the thinnest wall region</source>
        <translation>Mediandicke des dünnsten Wandbereichs</translation>
    </message>
    <message>
        <source>Median wall</source>
        <translation>Mediane Wand</translation>
    </message>
    <message>
        <source>Median, {unit}</source>
        <translation>Median, {unit}</translation>
    </message>
    <message>
        <source>Mesh settings</source>
        <translation>Netzeinstellungen</translation>
    </message>
    <message>
        <source>Meshing needs Gmsh: install it (Debian: 'apt-get install gmsh', elsewhere: https://gmsh.info), and see that 'gmsh --version' runs.</source>
        <translation>Zum Vernetzen wird Gmsh gebraucht: installieren Sie es (Debian: 'apt-get install gmsh', sonst: https://gmsh.info), und prüfen Sie, ob 'gmsh --version' läuft.</translation>
    </message>
    <message>
        <source>Metal</source>
        <translation>Metall</translation>
    </message>
    <message>
        <source>Metals; plastics bend and soften.</source>
        <translation>Metalle; Kunststoffe biegen sich und werden weich.</translation>
    </message>
    <message>
        <source>Middle side of the bounding box</source>
        <translation>Mittlere Seite des Hüllquaders</translation>
    </message>
    <message>
        <source>Middle to shortest side of the bounding box</source>
        <translation>Mittlere zu kürzester Seite des Hüllquaders</translation>
    </message>
    <message>
        <source>Mirror images of the part to keep.</source>
        <translation>Spiegelbilder des Teils, das zu behalten ist.</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>Gespiegelt</translation>
    </message>
    <message>
        <source>More than once</source>
        <translation>Mehrfach vorhanden</translation>
    </message>
    <message>
        <source>Most of the surface is the same, the rest is not: a hole more, another length.</source>
        <translation>Der größte Teil der Oberfläche ist gleich, der Rest nicht: ein Loch mehr, eine andere Länge.</translation>
    </message>
    <message>
        <source>Name what to write: --png FILE, --vtp FILE or --ply FILE.</source>
        <translation>Nennen Sie, was geschrieben werden soll: --png DATEI, --vtp DATEI oder --ply DATEI.</translation>
    </message>
    <message>
        <source>Neither clearly solid nor clearly thin: {walls}.</source>
        <translation>Weder eindeutig massiv noch eindeutig dünn: {walls}.</translation>
    </message>
    <message>
        <source>Netgen failed</source>
        <translation>Netgen ist gescheitert</translation>
    </message>
    <message>
        <source>Netgen took too long</source>
        <translation>Netgen hat zu lange gebraucht</translation>
    </message>
    <message>
        <source>Next parts</source>
        <translation>Nächste Teile</translation>
    </message>
    <message>
        <source>No criterion holds: its walls are thick all over.</source>
        <translation>Kein Kriterium ist erfüllt: Die Wände sind überall dick.</translation>
    </message>
    <message>
        <source>No part has all of these words.</source>
        <translation>Kein Teil hat alle diese Wörter.</translation>
    </message>
    <message>
        <source>No part is labelled {categories}: label at least {needed} parts of every category.</source>
        <translation>Kein Bauteil ist als {categories} eingeordnet: Ordnen Sie mindestens {needed} Bauteile in jede Kategorie ein.</translation>
    </message>
    <message>
        <source>No part like {part} has mesh settings that worked: the usual ones are used.</source>
        <translation>Kein Teil, das {part} ähnelt, hat bewährte Netzeinstellungen: die üblichen werden verwendet.</translation>
    </message>
    <message>
        <source>No report can be written into {folder} ({problem}): give another folder.</source>
        <translation>In {folder} kann kein Bericht geschrieben werden ({problem}): Geben Sie einen anderen Ordner an.</translation>
    </message>
    <message>
        <source>No wall could be measured.</source>
        <translation>Es konnte keine Wand gemessen werden.</translation>
    </message>
    <message>
        <source>No wall is wide and thin enough for a shell: mesh it as a solid.</source>
        <translation>Keine Wand ist breit und dünn genug für eine Schale: Vernetzen Sie das Teil als Volumen.</translation>
    </message>
    <message>
        <source>No wall of {part} could be measured: there is nothing to colour.</source>
        <translation>Keine Wand von {part} konnte gemessen werden: Es gibt nichts einzufärben.</translation>
    </message>
    <message>
        <source>No wall of {part} is wide and thin enough for a shell: mesh it as a solid.</source>
        <translation>Keine Wand von {part} ist breit und dünn genug für eine Schale: Vernetzen Sie das Teil als Volumen.</translation>
    </message>
    <message>
        <source>None of these folders has an info file of a part: 'thinpart classify' writes them.</source>
        <translation>Keiner dieser Ordner hat eine Infodatei eines Teils: „thinpart classify“ schreibt sie.</translation>
    </message>
    <message>
        <source>Normal part</source>
        <translation>Normales Bauteil</translation>
    </message>
    <message>
        <source>Not found any more, though with a limit of its own ({reason}): {faces}: set it anew, or remove it.</source>
        <translation>Nicht mehr gefunden, obwohl mit eigener Grenze ({reason}): {faces}: Setzen Sie sie neu, oder entfernen Sie sie.</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>Number of edges shorter than 0.3 elements of the automatic mesh</source>
        <translation>Anzahl der Kanten, die kürzer als 0,3 Elemente des automatischen Netzes sind</translation>
    </message>
    <message>
        <source>Number of faces</source>
        <translation>Anzahl der Flächen</translation>
    </message>
    <message>
        <source>Number of faces narrower than 0.3 elements of the automatic mesh</source>
        <translation>Anzahl der Flächen, die schmaler als 0,3 Elemente des automatischen Netzes sind</translation>
    </message>
    <message>
        <source>Number of wall regions that are bars, shafts, wires or rings</source>
        <translation>Anzahl der Wandbereiche, die Stäbe, Wellen, Drähte oder Ringe sind</translation>
    </message>
    <message>
        <source>Number of wall regions that are blocks</source>
        <translation>Anzahl der Wandbereiche, die Blöcke sind</translation>
    </message>
    <message>
        <source>Number of wall regions that are plates, flat, bent or shells</source>
        <translation>Anzahl der Wandbereiche, die Platten sind, eben, gebogen oder Schalen</translation>
    </message>
    <message>
        <source>Number of wall regions that are tapers</source>
        <translation>Anzahl der Wandbereiche, die Keile sind</translation>
    </message>
    <message>
        <source>Number of wall regions that are teeth, of gears or threads</source>
        <translation>Anzahl der Wandbereiche, die Zähne sind, von Zahnrädern oder Gewinden</translation>
    </message>
    <message>
        <source>Number of wall regions that are tubes</source>
        <translation>Anzahl der Wandbereiche, die Rohre sind</translation>
    </message>
    <message>
        <source>Number of wall regions, connected walls of like thickness</source>
        <translation>Anzahl der Wandbereiche, zusammenhängender Wände ähnlicher Dicke</translation>
    </message>
    <message>
        <source>Nylon (PA)</source>
        <translation>Polyamid (PA)</translation>
    </message>
    <message>
        <source>One form, wherever it lies, in whatever file, format or name.</source>
        <translation>Eine Form, wo immer sie liegt, in welcher Datei, welchem Format und unter welchem Namen auch immer.</translation>
    </message>
    <message>
        <source>One of the given paths is empty: name a file or a folder.</source>
        <translation>Einer der angegebenen Pfade ist leer: Nennen Sie eine Datei oder einen Ordner.</translation>
    </message>
    <message>
        <source>Only the other has round faces of radius {radius:.3g} ({count}).</source>
        <translation>Nur das andere hat runde Flächen mit dem Radius {radius:.3g} ({count}).</translation>
    </message>
    <message>
        <source>Only this one has round faces of radius {radius:.3g} ({count}).</source>
        <translation>Nur dieses hat runde Flächen mit dem Radius {radius:.3g} ({count}).</translation>
    </message>
    <message>
        <source>Only {share:.0f} % of the volume of {part} can be cut off as walls.</source>
        <translation>Nur {share:.0f} % des Volumens von {part} lassen sich als Wände abschneiden.</translation>
    </message>
    <message>
        <source>PLY with thickness and colours (*.ply)</source>
        <translation>PLY mit Dicke und Farben (*.ply)</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Bauteil</translation>
    </message>
    <message>
        <source>Part with thin features</source>
        <translation>Bauteil mit dünnen Bereichen</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>Parts whose faces are the same but for their sizes, with what varies, in {unit}.</source>
        <translation>Teile, deren Flächen bis auf ihre Größen gleich sind, mit dem, was sich ändert, in {unit}.</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Besteht</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Picture of {part}</source>
        <translation>Bild von {part}</translation>
    </message>
    <message>
        <source>Pieces that do not meet the rest were left out, {share:.2g} % of the volume: they belong to what is left solid.</source>
        <translation>Stücke, die den Rest nicht treffen, wurden ausgelassen, {share:.2g} % des Volumens: Sie gehören zu dem, was Volumen bleibt.</translation>
    </message>
    <message>
        <source>Plastic</source>
        <translation>Kunststoff</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Platte</translation>
    </message>
    <message>
        <source>Point at a part to see it, click to find it in the table. With the keyboard: arrow keys go from part to part, Enter finds it in the table.</source>
        <translation>Zeigen Sie auf ein Teil, um es zu sehen; ein Klick findet es in der Tabelle. Mit der Tastatur: Pfeiltasten gehen von Teil zu Teil, die Eingabetaste findet es in der Tabelle.</translation>
    </message>
    <message>
        <source>Polycarbonate (PC)</source>
        <translation>Polycarbonat (PC)</translation>
    </message>
    <message>
        <source>Polyester (PBT, PET)</source>
        <translation>Polyester (PBT, PET)</translation>
    </message>
    <message>
        <source>Polyethylene (PE)</source>
        <translation>Polyethylen (PE)</translation>
    </message>
    <message>
        <source>Polyphenylene sulphide (PPS)</source>
        <translation>Polyphenylensulfid (PPS)</translation>
    </message>
    <message>
        <source>Polypropylene (PP)</source>
        <translation>Polypropylen (PP)</translation>
    </message>
    <message>
        <source>Polystyrene (PS)</source>
        <translation>Polystyrol (PS)</translation>
    </message>
    <message>
        <source>Polyurethane (PU)</source>
        <translation>Polyurethan (PU)</translation>
    </message>
    <message>
        <source>Previous parts</source>
        <translation>Vorige Teile</translation>
    </message>
    <message>
        <source>Probability: {probability}, next “{other}” with {others}.</source>
        <translation>Wahrscheinlichkeit: {probability}, danach „{other}“ mit {others}.</translation>
    </message>
    <message>
        <source>Process</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Risk</source>
        <translation>Risiko</translation>
    </message>
    <message>
        <source>Risk of the automatic mesh</source>
        <translation>Risiko des automatischen Netzes</translation>
    </message>
    <message>
        <source>Risk of the automatic mesh: unknown, an earlier version measured the part. Measure it again (classify --force).</source>
        <translation>Risiko des automatischen Netzes: unbekannt, eine frühere Version hat das Teil gemessen. Messen Sie es noch einmal (classify --force).</translation>
    </message>
    <message>
        <source>Risk of the automatic mesh: unknown, not all that it depends on could be measured.</source>
        <translation>Risiko des automatischen Netzes: unbekannt, nicht alles, wovon es abhängt, konnte gemessen werden.</translation>
    </message>
    <message>
        <source>Risk of the automatic mesh: unknown, triangles have no edges and faces.</source>
        <translation>Risiko des automatischen Netzes: unbekannt, Dreiecke haben keine Kanten und Flächen.</translation>
    </message>
    <message>
        <source>Risk of the automatic mesh: {risk}.</source>
        <translation>Risiko des automatischen Netzes: {risk}.</translation>
    </message>
    <message>
        <source>Risk of the automatic mesh: {risk}: {reasons}.</source>
        <translation>Risiko des automatischen Netzes: {risk}: {reasons}.</translation>
    </message>
    <message>
        <source>SLA printing</source>
        <translation>SLA-Druck</translation>
    </message>
    <message>
        <source>SLS printing</source>
        <translation>SLS-Druck</translation>
    </message>
    <message>
        <source>Sand casting</source>
        <translation>Sandguss</translation>
    </message>
    <message>
        <source>Scaled</source>
        <translation>Skaliert</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>See</source>
        <translation>Siehe</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Settings that worked for {part} ({alike:.0f} % alike) in {file}.</source>
        <translation>Einstellungen, die sich für {part} (zu {alike:.0f} % ähnlich) in {file} bewährt haben.</translation>
    </message>
    <message>
        <source>Share of its box, V/VBB</source>
        <translation>Anteil am Hüllquader, V/VBB</translation>
    </message>
    <message>
        <source>Share of the area over curved walls that elements of the automatic mesh change by a twentieth</source>
        <translation>Anteil der Oberfläche über gekrümmten Wänden, deren Dicke Elemente des automatischen Netzes um ein Zwanzigstel ändern</translation>
    </message>
    <message>
        <source>Share of the area over parallel walls from a to b of the middle side</source>
        <translation>Anteil der Fläche über parallelen Wänden von a bis b der mittleren Seite</translation>
    </message>
    <message>
        <source>Share of the area over plates and tubes: walls that are wider than thick</source>
        <translation>Anteil der Fläche über Platten und Rohren: Wänden, die breiter als dick sind</translation>
    </message>
    <message>
        <source>Share of the area over walls, parallel or under 60 degrees, from a to b of the middle side</source>
        <translation>Anteil der Fläche über Wänden, parallel oder unter 60 Grad, von a bis b der mittleren Seite</translation>
    </message>
    <message>
        <source>Share of the area whose local thickness is from a to b of the middle side</source>
        <translation>Anteil der Fläche, deren örtliche Dicke a bis b der mittleren Seite beträgt</translation>
    </message>
    <message>
        <source>Share of the area whose rays met nothing at all</source>
        <translation>Anteil der Oberfläche, deren Strahl auf nichts traf</translation>
    </message>
    <message>
        <source>Share of the area with a radius below 0.25 elements of the automatic mesh</source>
        <translation>Anteil der Oberfläche mit einem Radius unter 0,25 Elementen des automatischen Netzes</translation>
    </message>
    <message>
        <source>Share of the area with no wall opposite</source>
        <translation>Anteil der Oberfläche ohne Wand gegenüber</translation>
    </message>
    <message>
        <source>Share of the area with non-parallel walls</source>
        <translation>Anteil der Oberfläche mit nicht parallelen Wänden</translation>
    </message>
    <message>
        <source>Share of the area with parallel walls</source>
        <translation>Anteil der Oberfläche mit parallelen Wänden</translation>
    </message>
    <message>
        <source>Share of the area with walls that are a to b diagonals thick</source>
        <translation>Anteil der Oberfläche mit Wänden von a bis b Diagonalen Stärke</translation>
    </message>
    <message>
        <source>Share of the bounding box that the part fills</source>
        <translation>Anteil des Hüllquaders, den das Bauteil ausfüllt</translation>
    </message>
    <message>
        <source>Share of the surface</source>
        <translation>Anteil der Oberfläche</translation>
    </message>
    <message>
        <source>Share of the surface over parallel walls thinner than {high:g} of the diagonal</source>
        <translation>Anteil der Oberfläche über parallelen Wänden, dünner als {high:g} der Diagonale</translation>
    </message>
    <message>
        <source>Share of the surface over parallel walls thinner than {high:g} of the middle side</source>
        <translation>Anteil der Oberfläche über parallelen Wänden, dünner als {high:g} der mittleren Seite</translation>
    </message>
    <message>
        <source>Share of the surface over parallel walls {low:g} to {high:g} of the diagonal thick</source>
        <translation>Anteil der Oberfläche über parallelen Wänden, {low:g} bis {high:g} der Diagonale dick</translation>
    </message>
    <message>
        <source>Share of the surface over parallel walls {low:g} to {high:g} of the middle side thick</source>
        <translation>Anteil der Oberfläche über parallelen Wänden, {low:g} bis {high:g} der mittleren Seite dick</translation>
    </message>
    <message>
        <source>Share of the surface over walls of each thickness ({unit}). {unmeasured} of the surface has no wall opposite; {tapered} lies over tapered walls, which are not in the chart.</source>
        <translation>Anteil der Oberfläche über Wänden jeder Dicke ({unit}). {unmeasured} der Oberfläche haben keine Wand gegenüber; {tapered} liegen über schrägen Wänden, die nicht im Diagramm sind.</translation>
    </message>
    <message>
        <source>Share of the surface over walls, parallel or tapered, thinner than {high:g} of the middle side</source>
        <translation>Anteil der Oberfläche über Wänden, parallel oder verjüngt, dünner als {high:g} der mittleren Seite</translation>
    </message>
    <message>
        <source>Share of the surface over walls, parallel or tapered, {low:g} to {high:g} of the middle side thick</source>
        <translation>Anteil der Oberfläche über Wänden, parallel oder verjüngt, {low:g} bis {high:g} der mittleren Seite dick</translation>
    </message>
    <message>
        <source>Share of the surface whose local thickness is under {high:g} of the middle side</source>
        <translation>Anteil der Oberfläche, deren örtliche Dicke unter {high:g} der mittleren Seite liegt</translation>
    </message>
    <message>
        <source>Share of the surface whose local thickness is {low:g} to {high:g} of the middle side</source>
        <translation>Anteil der Oberfläche, deren örtliche Dicke {low:g} bis {high:g} der mittleren Seite beträgt</translation>
    </message>
    <message>
        <source>Share of the volume</source>
        <translation>Anteil am Volumen</translation>
    </message>
    <message>
        <source>Sheet metal</source>
        <translation>Blech</translation>
    </message>
    <message>
        <source>Shell and solid of {part} would count for {share:.0f} % of its volume.</source>
        <translation>Schale und Volumen von {part} ergäben {share:.0f} % seines Volumens.</translation>
    </message>
    <message>
        <source>Shortest side of the bounding box</source>
        <translation>Kürzeste Seite des Hüllquaders</translation>
    </message>
    <message>
        <source>Show all {count}</source>
        <translation>Alle {count} zeigen</translation>
    </message>
    <message>
        <source>Small castings of aluminium; large ones need about twice as much. The greatest section is that of DeGarmo, Black and Kohser (2003).</source>
        <translation>Kleine Gussteile aus Aluminium; große brauchen etwa das Doppelte. Die größte Wandstärke ist die von DeGarmo, Black und Kohser (2003).</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>Software</translation>
    </message>
    <message>
        <source>Solid but for {features}: mesh it with solids, and refine there or suppress that.</source>
        <translation>Massiv bis auf {features}: mit Volumenelementen vernetzen und dort verfeinern oder das unterdrücken.</translation>
    </message>
    <message>
        <source>Solid but for {features}: mesh it with solids, and refine there.</source>
        <translation>Massiv bis auf {features}: mit Volumenelementen vernetzen und dort verfeinern.</translation>
    </message>
    <message>
        <source>Solid core, {share} of the surface is thin: {features}. Refine the mesh there, or suppress them.</source>
        <translation>Massiver Kern, {share} der Oberfläche sind dünn: {features}. Das Netz dort verfeinern oder sie unterdrücken.</translation>
    </message>
    <message>
        <source>Solid core, {share} of the surface is thin: {features}. Refine the mesh there.</source>
        <translation>Massiver Kern, {share} der Oberfläche sind dünn: {features}. Das Netz dort verfeinern.</translation>
    </message>
    <message>
        <source>Solid: {walls}: mesh it with solids.</source>
        <translation>Massiv: {walls}: mit Volumenelementen vernetzen.</translation>
    </message>
    <message>
        <source>Some coordinates are not finite numbers.</source>
        <translation>Einige Koordinaten sind keine endlichen Zahlen.</translation>
    </message>
    <message>
        <source>Some triangles refer to points that are not there.</source>
        <translation>Einige Dreiecke verweisen auf Punkte, die es nicht gibt.</translation>
    </message>
    <message>
        <source>Stopped on request before the end.</source>
        <translation>Auf Wunsch vorzeitig abgebrochen.</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Surface mesh</source>
        <translation>Oberflächennetz</translation>
    </message>
    <message>
        <source>Surfaces touch or cross at ({place}): what lies between them is not counted as a wall.</source>
        <translation>Flächen berühren oder durchdringen sich bei ({place}): Was dazwischen liegt, zählt nicht als Wand.</translation>
    </message>
    <message>
        <source>Tables:</source>
        <translation>Tabellen:</translation>
    </message>
    <message>
        <source>Takes shapes from</source>
        <translation>Übernimmt Formen aus</translation>
    </message>
    <message>
        <source>Temporary files cannot be written ({problem}): free some disk space, or name another folder in TMPDIR.</source>
        <translation>Temporäre Dateien können nicht geschrieben werden ({problem}): Geben Sie Speicherplatz frei oder nennen Sie in TMPDIR einen anderen Ordner.</translation>
    </message>
    <message>
        <source>Temporary files cannot be written ({problem}): free some disk space. Nothing was meshed.</source>
        <translation>Temporäre Dateien können nicht geschrieben werden ({problem}): Schaffen Sie Platz auf dem Datenträger. Nichts wurde vernetzt.</translation>
    </message>
    <message>
        <source>The Python module {module} is missing: install it to have documents classified automatically (Debian: python3-{module}).</source>
        <translation>Das Python-Modul {module} fehlt: Installieren Sie es, damit Dokumente automatisch klassifiziert werden (Debian: python3-{module}).</translation>
    </message>
    <message>
        <source>The condition {condition!r} is not understood: write a quantity, one of {comparisons} and a number, as in 'D2/D3 &gt; 6'.</source>
        <translation>Die Bedingung {condition!r} ist nicht verständlich: Schreiben Sie eine Größe, eines der Zeichen {comparisons} und eine Zahl, wie in „D2/D3 &gt; 6“.</translation>
    </message>
    <message>
        <source>The current folder no longer exists: change to another one.</source>
        <translation>Der aktuelle Ordner existiert nicht mehr: Wechseln Sie in einen anderen.</translation>
    </message>
    <message>
        <source>The document '{document}' is empty: make or import a solid first.</source>
        <translation>Das Dokument „{document}“ ist leer: Erstellen oder importieren Sie zuerst einen Volumenkörper.</translation>
    </message>
    <message>
        <source>The document has no such part any more: classify it again.</source>
        <translation>Das Dokument hat dieses Bauteil nicht mehr: Klassifizieren Sie es erneut.</translation>
    </message>
    <message>
        <source>The document links to {links}, which is a pipe, a device or a socket: it was not opened, and what is linked to is missing.</source>
        <translation>Das Dokument verweist auf {links}, eine Pipe, ein Gerät oder einen Socket: Das wurde nicht geöffnet, und das Verwiesene fehlt.</translation>
    </message>
    <message>
        <source>The document names Python modules that are not FreeCAD's ({names}): they were not loaded, and objects that need them may lack their shape.</source>
        <translation>Das Dokument nennt Python-Module, die nicht zu FreeCAD gehören ({names}): Sie wurden nicht geladen, und Objekten, die sie brauchen, kann ihre Form fehlen.</translation>
    </message>
    <message>
        <source>The document's folder has not answered for {seconds:g} s: connect it, or choose a folder for info files in the preferences.</source>
        <translation>Der Ordner des Dokuments antwortet seit {seconds:g} s nicht: Verbinden Sie ihn oder wählen Sie in den Einstellungen einen Ordner für Infodateien.</translation>
    </message>
    <message>
        <source>The documents are the same, byte by byte.</source>
        <translation>Die Dokumente sind Byte für Byte gleich.</translation>
    </message>
    <message>
        <source>The element size of a shell is more than 0 mm, not {value:g}.</source>
        <translation>Die Elementgröße einer Schale ist größer als 0 mm, nicht {value:g}.</translation>
    </message>
    <message>
        <source>The error aimed at is from {least:g} to {most:g} %, not {value:g} %.</source>
        <translation>Der angestrebte Fehler liegt zwischen {least:g} und {most:g} %, nicht bei {value:g} %.</translation>
    </message>
    <message>
        <source>The error of its mesh is not known ({reason}).</source>
        <translation>Der Fehler seines Netzes ist nicht bekannt ({reason}).</translation>
    </message>
    <message>
        <source>The error of its mesh is not known: the frequencies of the reference still change by {change}.</source>
        <translation>Der Fehler seines Netzes ist nicht bekannt: Die Frequenzen des Vergleichsnetzes ändern sich noch um {change}.</translation>
    </message>
    <message>
        <source>The file</source>
        <translation>Die Datei</translation>
    </message>
    <message>
        <source>The file of labels {file} cannot be read ({problem}).</source>
        <translation>Die Datei der Einordnungen {file} kann nicht gelesen werden ({problem}).</translation>
    </message>
    <message>
        <source>The file {file}</source>
        <translation>Die Datei {file}</translation>
    </message>
    <message>
        <source>The file {file} cannot be read ({problem}).</source>
        <translation>Die Datei {file} kann nicht gelesen werden ({problem}).</translation>
    </message>
    <message>
        <source>The file {file} no longer exists.</source>
        <translation>Die Datei {file} gibt es nicht mehr.</translation>
    </message>
    <message>
        <source>The first part of a group is the one to keep: geometry before triangles, the one used most, with notes, in a document that FreeCAD can edit, with a name that somebody chose, the latest. The others are compared with it, by what info files keep of their form. Nothing is deleted.</source>
        <translation>Das erste Teil einer Gruppe ist das, das zu behalten ist: Geometrie vor Dreiecken, das am meisten verwendete, mit Notizen, in einem Dokument, das FreeCAD bearbeiten kann, mit einem Namen, den jemand gewählt hat, das neueste. Die anderen werden mit ihm verglichen, nach dem, was Infodateien von ihrer Form behalten. Nichts wird gelöscht.</translation>
    </message>
    <message>
        <source>The folder for info files {folder} cannot be reached ({problem}): connect it, or choose another one in the preferences.</source>
        <translation>Der Ordner {folder} für Infodateien ist nicht erreichbar ({problem}): Verbinden Sie ihn oder wählen Sie in den Einstellungen einen anderen.</translation>
    </message>
    <message>
        <source>The folder for info files {folder} has not answered for {seconds:g} s: connect it, or choose another one in the preferences.</source>
        <translation>Der Ordner {folder} für Infodateien antwortet seit {seconds:g} s nicht: Verbinden Sie ihn oder wählen Sie in den Einstellungen einen anderen.</translation>
    </message>
    <message>
        <source>The folder {folder} cannot be listed ({problem}): its parts are shown as they were last read.</source>
        <translation>Der Ordner {folder} kann nicht aufgelistet werden ({problem}): Seine Bauteile werden gezeigt, wie sie zuletzt gelesen wurden.</translation>
    </message>
    <message>
        <source>The folder {folder} cannot be listed ({problem}): make it readable, or move it away.</source>
        <translation>Der Inhalt des Ordners {folder} kann nicht gelesen werden ({problem}): Machen Sie ihn lesbar oder verschieben Sie ihn an einen anderen Ort.</translation>
    </message>
    <message>
        <source>The folder {folder} cannot be listed ({problem}): the files in it were not changed.</source>
        <translation>Der Ordner {folder} kann nicht aufgelistet werden ({problem}): Die Dateien darin wurden nicht geändert.</translation>
    </message>
    <message>
        <source>The folder {folder} cannot be reached ({problem}).</source>
        <translation>Der Ordner {folder} ist nicht erreichbar ({problem}).</translation>
    </message>
    <message>
        <source>The folder {folder} could not be searched to its end ({problem}): classify it again when it can be reached.</source>
        <translation>Der Ordner {folder} konnte nicht vollständig durchsucht werden ({problem}): Klassifizieren Sie ihn erneut, wenn er erreichbar ist.</translation>
    </message>
    <message>
        <source>The folder {folder} no longer exists: restore it, or remove it from the list.</source>
        <translation>Den Ordner {folder} gibt es nicht mehr: Stellen Sie ihn wieder her oder entfernen Sie ihn aus der Liste.</translation>
    </message>
    <message>
        <source>The greatest element size is more than 0 mm, not {value:g}.</source>
        <translation>Die größte Elementgröße ist mehr als 0 mm, nicht {value:g}.</translation>
    </message>
    <message>
        <source>The growth from element to element is from {least:g} to {most:g}, not {value:g}.</source>
        <translation>Das Wachstum von Element zu Element ist von {least:g} bis {most:g} möglich, nicht {value:g}.</translation>
    </message>
    <message>
        <source>The info file {info_file} belongs to {other} and was not changed: choose another folder for the info file of {own}.</source>
        <translation>Die Infodatei {info_file} gehört zu {other} und blieb unverändert: Wählen Sie einen anderen Ordner für die Infodatei von {own}.</translation>
    </message>
    <message>
        <source>The info file {info_file} cannot be read ({problem}).</source>
        <translation>Die Infodatei {info_file} kann nicht gelesen werden ({problem}).</translation>
    </message>
    <message>
        <source>The info file {info_file} could not be written ({problem}): make room or choose another place for it.</source>
        <translation>Die Infodatei {info_file} konnte nicht geschrieben werden ({problem}): Schaffen Sie Platz oder wählen Sie einen anderen Ort dafür.</translation>
    </message>
    <message>
        <source>The info file {info_file} could not be written: another program keeps the folder {folder} locked; end that program, or choose another place for info files.</source>
        <translation>Die Infodatei {info_file} konnte nicht geschrieben werden: Ein anderes Programm hält den Ordner {folder} gesperrt; beenden Sie dieses Programm, oder wählen Sie einen anderen Ort für Infodateien.</translation>
    </message>
    <message>
        <source>The info file {info_file} is damaged ({problem}): move it away and classify its document again.</source>
        <translation>Die Infodatei {info_file} ist beschädigt ({problem}): Verschieben Sie sie und klassifizieren Sie ihr Dokument erneut.</translation>
    </message>
    <message>
        <source>The info file {info_file} needs more memory than the limit allows.</source>
        <translation>Die Infodatei {info_file} braucht mehr Speicher, als erlaubt ist.</translation>
    </message>
    <message>
        <source>The info file {info_file} was not written: {problem}.</source>
        <translation>Die Infodatei {info_file} wurde nicht geschrieben: {problem}.</translation>
    </message>
    <message>
        <source>The labels could not be written to {file} ({problem}): choose another place for them.</source>
        <translation>Die Einordnungen konnten nicht nach {file} geschrieben werden ({problem}): Wählen Sie einen anderen Ort dafür.</translation>
    </message>
    <message>
        <source>The library {folder} cannot be read ({problem}).</source>
        <translation>Die Bibliothek {folder} kann nicht gelesen werden ({problem}).</translation>
    </message>
    <message>
        <source>The limits of walls {file} are not well formed: {problem}.</source>
        <translation>Die Grenzen der Wandstärke {file} sind nicht wohlgeformt: {problem}.</translation>
    </message>
    <message>
        <source>The limits of walls {file} cannot be read ({problem}).</source>
        <translation>Die Grenzen der Wandstärke {file} sind nicht lesbar ({problem}).</translation>
    </message>
    <message>
        <source>The link '{object}' leads to '{target}' in {file}, which cannot be found: put the file back or set the linked object again.</source>
        <translation>Die Verknüpfung „{object}“ führt zu „{target}“ in {file}, das nicht gefunden wird: Legen Sie die Datei zurück oder setzen Sie das verknüpfte Objekt neu.</translation>
    </message>
    <message>
        <source>The link '{object}' leads to nothing: set its linked object again or delete it.</source>
        <translation>Die Verknüpfung „{object}“ führt ins Leere: Setzen Sie ihr verknüpftes Objekt neu oder löschen Sie sie.</translation>
    </message>
    <message>
        <source>The list {list} cannot be read ({problem}): give a file to --only that names the parts.</source>
        <translation>Die Liste {list} kann nicht gelesen werden ({problem}): Geben Sie mit --only eine Datei an, die die Bauteile nennt.</translation>
    </message>
    <message>
        <source>The list {list} names {file!r}, which is not an absolute path: write absolute paths, each ended by a NUL byte.</source>
        <translation>Die Liste {list} nennt {file!r}, was kein absoluter Pfad ist: Schreiben Sie absolute Pfade, jeden mit einem NUL-Byte beendet.</translation>
    </message>
    <message>
        <source>The list {list} names {file}, which does not lie below {top}: name a PATH that holds it, or leave out --info-dir.</source>
        <translation>Die Liste {list} nennt {file}, das nicht unterhalb von {top} liegt: Nennen Sie einen PATH, der es enthält, oder lassen Sie --info-dir weg.</translation>
    </message>
    <message>
        <source>The mesh cannot be read ({problem}): free some disk space and try again.</source>
        <translation>Das Netz kann nicht gelesen werden ({problem}): Schaffen Sie Platz auf dem Datenträger und versuchen Sie es erneut.</translation>
    </message>
    <message>
        <source>The mesh settings</source>
        <translation>Die Netzeinstellungen</translation>
    </message>
    <message>
        <source>The mesh {file} cannot be read ({problem}).</source>
        <translation>Das Netz {file} kann nicht gelesen werden ({problem}).</translation>
    </message>
    <message>
        <source>The mid-faces of the walls could not be cut to each other ({problem}): mesh it as a solid.</source>
        <translation>Die Mittelflächen der Wände ließen sich nicht aneinander schneiden ({problem}): Vernetzen Sie das Teil als Volumen.</translation>
    </message>
    <message>
        <source>The mid-faces of the walls could not be cut to each other: mesh it as a solid.</source>
        <translation>Die Mittelflächen der Wände ließen sich nicht aneinander schneiden: Vernetzen Sie das Teil als Volumen.</translation>
    </message>
    <message>
        <source>The mid-surface cannot be read ({problem}): free some disk space and try again.</source>
        <translation>Die Mittelfläche lässt sich nicht lesen ({problem}): Schaffen Sie Platz auf dem Datenträger, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The mid-surface of {part} could not be meshed ({problem}).</source>
        <translation>Die Mittelfläche von {part} konnte nicht vernetzt werden ({problem}).</translation>
    </message>
    <message>
        <source>The mid-surface of {part} could not be meshed ({problem}): name another element size.</source>
        <translation>Die Mittelfläche von {part} ließ sich nicht vernetzen ({problem}): Geben Sie eine andere Elementgröße an.</translation>
    </message>
    <message>
        <source>The mid-surface of {part} falls into {count} pieces that do not meet: mesh it as a solid.</source>
        <translation>Die Mittelfläche von {part} zerfällt in {count} Stücke, die sich nicht treffen: Vernetzen Sie das Teil als Volumen.</translation>
    </message>
    <message>
        <source>The mirror image, by the points that info files keep, by volume and by area.</source>
        <translation>Das Spiegelbild, nach den Punkten, die Infodateien behalten, nach Volumen und Fläche.</translation>
    </message>
    <message>
        <source>The mirror image: its surfaces are at most {apart:.2g} apart.</source>
        <translation>Das Spiegelbild: Die Oberflächen liegen höchstens {apart:.2g} auseinander.</translation>
    </message>
    <message>
        <source>The mirror image: triangles lie at most {apart:.2g} from the other surface.</source>
        <translation>Das Spiegelbild: Dreiecke liegen höchstens {apart:.2g} neben der anderen Oberfläche.</translation>
    </message>
    <message>
        <source>The name is too long for an info file, which adds {ending} to it: it has {bytes} bytes, at most {most} are possible; rename it, or use --no-info.</source>
        <translation>Der Name ist zu lang für eine Infodatei, die {ending} anhängt: Er hat {bytes} Byte, höchstens {most} sind möglich; benennen Sie die Datei um oder verwenden Sie --no-info.</translation>
    </message>
    <message>
        <source>The order of elements is 1 or 2, not {value}.</source>
        <translation>Die Ordnung der Elemente ist 1 oder 2, nicht {value}.</translation>
    </message>
    <message>
        <source>The outline in an info file is damaged: classify its document again.</source>
        <translation>Der Umriss in einer Infodatei ist beschädigt: Klassifizieren Sie ihr Dokument neu.</translation>
    </message>
    <message>
        <source>The overview of the report could not be written into {folder} ({problem}): make room for it, and start again.</source>
        <translation>Die Übersicht des Berichts konnte nicht in {folder} geschrieben werden ({problem}): Schaffen Sie Platz dafür und starten Sie erneut.</translation>
    </message>
    <message>
        <source>The page about the library could not be written into {folder} ({problem}): make room for it, and start again.</source>
        <translation>Die Seite über die Bibliothek konnte nicht in {folder} geschrieben werden ({problem}): Schaffen Sie Platz, und beginnen Sie von vorn.</translation>
    </message>
    <message>
        <source>The page {page} could not be written ({problem}): make room, or give another folder for the report.</source>
        <translation>Die Seite {page} konnte nicht geschrieben werden ({problem}): Schaffen Sie Platz oder geben Sie einen anderen Ordner für den Bericht an.</translation>
    </message>
    <message>
        <source>The part as a whole is thin: consider a shell mesh or a mid-surface.</source>
        <translation>Das Bauteil ist insgesamt dünnwandig: Ein Schalennetz oder eine Mittelfläche kommt in Betracht.</translation>
    </message>
    <message>
        <source>The part is slender: its lengths are accurate to {error:.2g} only, a finer mesh would be too large.</source>
        <translation>Das Bauteil ist schlank: Seine Längen sind nur auf {error:.2g} genau, ein feineres Netz würde zu groß.</translation>
    </message>
    <message>
        <source>The part is too slender or too fine to be measured: it needs more than {triangles:,} triangles, with fewer its lengths are accurate to {mm:.2g} only.</source>
        <translation>Das Bauteil ist zu schlank oder zu fein, um gemessen zu werden: Mehr als {triangles:,} Dreiecke sind nötig, mit weniger sind seine Längen nur auf {mm:.2g} bekannt.</translation>
    </message>
    <message>
        <source>The part is {mm} across: check that the file's unit is millimetres.</source>
        <translation>Das Bauteil misst {mm} in der Diagonale: Prüfen Sie, ob die Einheit der Datei Millimeter ist.</translation>
    </message>
    <message>
        <source>The parts lie on several drives: name those of one drive at a time.</source>
        <translation>Die Bauteile liegen auf mehreren Laufwerken: Nennen Sie jeweils nur die eines Laufwerks.</translation>
    </message>
    <message>
        <source>The profile {file} could not be written ({problem}): choose another place for it.</source>
        <translation>Das Profil {file} konnte nicht geschrieben werden ({problem}): Wählen Sie einen anderen Ort dafür.</translation>
    </message>
    <message>
        <source>The profile {profile} cannot be read ({problem}).</source>
        <translation>Das Profil {profile} kann nicht gelesen werden ({problem}).</translation>
    </message>
    <message>
        <source>The profile {profile} has no category {categories}: labels by a program are of these.</source>
        <translation>Das Profil {profile} hat keine Kategorie {categories}: Einordnungen durch ein Programm sind von diesen.</translation>
    </message>
    <message>
        <source>The same form in another size.</source>
        <translation>Dieselbe Form in einer anderen Größe.</translation>
    </message>
    <message>
        <source>The same form, by the points that info files keep, by volume and by area.</source>
        <translation>Dieselbe Form, nach den Punkten, die Infodateien behalten, nach Volumen und Fläche.</translation>
    </message>
    <message>
        <source>The same form, scaled: triangles lie at most {apart:.2g} from the other surface.</source>
        <translation>Dieselbe Form, skaliert: Dreiecke liegen höchstens {apart:.2g} neben der anderen Oberfläche.</translation>
    </message>
    <message>
        <source>The same form, {scale:.6g} times as large, by the points that info files keep, by volume and by area.</source>
        <translation>Dieselbe Form, {scale:.6g}-mal so groß, nach den Punkten, die Infodateien behalten, nach Volumen und Fläche.</translation>
    </message>
    <message>
        <source>The same form, {scale:.6g} times as large: in the size of the other, its surfaces are at most {apart:.2g} apart.</source>
        <translation>Dieselbe Form, {scale:.6g}-mal so groß: In der Größe des anderen liegen die Oberflächen höchstens {apart:.2g} auseinander.</translation>
    </message>
    <message>
        <source>The same form: its surfaces are at most {apart:.2g} apart.</source>
        <translation>Dieselbe Form: Die Oberflächen liegen höchstens {apart:.2g} auseinander.</translation>
    </message>
    <message>
        <source>The same form: triangles lie at most {apart:.2g} from the other surface.</source>
        <translation>Dieselbe Form: Dreiecke liegen höchstens {apart:.2g} neben der anderen Oberfläche.</translation>
    </message>
    <message>
        <source>The script opens {copy}, a copy of the part beside it.</source>
        <translation>Das Skript öffnet {copy}, eine Kopie des Teils daneben.</translation>
    </message>
    <message>
        <source>The search has {count} conditions, words and names, more than {most}: leave some out.</source>
        <translation>Die Suche hat {count} Bedingungen, Wörter und Namen, mehr als {most}: Lassen Sie einige weg.</translation>
    </message>
    <message>
        <source>The search index {file} cannot be saved ({problem}): it was built in memory, and the next search has to build it again.</source>
        <translation>Der Suchindex {file} kann nicht gespeichert werden ({problem}): Er wurde im Speicher aufgebaut, und die nächste Suche muss ihn neu aufbauen.</translation>
    </message>
    <message>
        <source>The settings were kept with {part}.</source>
        <translation>Die Einstellungen wurden bei {part} gespeichert.</translation>
    </message>
    <message>
        <source>The shell and what is solid, tied to it, were written to {file}: {elements} elements, {nodes} nodes.</source>
        <translation>Die Schale und das damit verbundene Volumen wurden nach {file} geschrieben: {elements} Elemente, {nodes} Knoten.</translation>
    </message>
    <message>
        <source>The shell has {share:.0f} % of the part's volume: the rest is not in the file.</source>
        <translation>Die Schale hat {share:.0f} % des Volumens des Teils: Der Rest ist nicht in der Datei.</translation>
    </message>
    <message>
        <source>The shell is in {count} pieces: what is left solid lies between them.</source>
        <translation>Die Schale besteht aus {count} Stücken: Dazwischen liegt, was massiv bleibt.</translation>
    </message>
    <message>
        <source>The shell of {part} reaches only {share:.0f} % of the cuts between its walls and what is solid.</source>
        <translation>Die Schale von {part} erreicht nur {share:.0f} % der Schnitte zwischen seinen Wänden und dem Volumen.</translation>
    </message>
    <message>
        <source>The shell was written to {file}: {elements} elements, {nodes} nodes.</source>
        <translation>Die Schale wurde nach {file} geschrieben: {elements} Elemente, {nodes} Knoten.</translation>
    </message>
    <message>
        <source>The size of elements and the error have to be more than 0: state other ones.</source>
        <translation>Die Elementgröße und der Fehler müssen größer als 0 sein: Geben Sie andere an.</translation>
    </message>
    <message>
        <source>The sizes were written to {file}: open it in Gmsh.</source>
        <translation>Die Größen stehen in {file}: öffnen Sie die Datei in Gmsh.</translation>
    </message>
    <message>
        <source>The surface intersects itself, for example below ({place}): repair it, its thickness and volume are not certain.</source>
        <translation>Die Oberfläche durchdringt sich selbst, zum Beispiel unter ({place}): Reparieren Sie sie, Wandstärke und Volumen sind nicht sicher.</translation>
    </message>
    <message>
        <source>The surface is open ({edges} free edges), so it has no certain volume.</source>
        <translation>Die Oberfläche ist offen ({edges} freie Kanten), daher ist das Volumen nicht sicher.</translation>
    </message>
    <message>
        <source>The surface was inside out and has been reversed.</source>
        <translation>Die Oberfläche war nach innen gekehrt und wurde umgedreht.</translation>
    </message>
    <message>
        <source>The table and the search need JavaScript.</source>
        <translation>Die Tabelle und die Suche brauchen JavaScript.</translation>
    </message>
    <message>
        <source>The thickness map {file} cannot be read: measure the part again.</source>
        <translation>Die Wandstärkenkarte {file} kann nicht gelesen werden: Messen Sie das Bauteil erneut.</translation>
    </message>
    <message>
        <source>The thickness map {file} is of a newer ThinPart: update ThinPart or measure the part again.</source>
        <translation>Die Wandstärkenkarte {file} stammt von einem neueren ThinPart: Aktualisieren Sie ThinPart oder messen Sie das Bauteil erneut.</translation>
    </message>
    <message>
        <source>The thinnest first; thin is what lies over less than {limit}, {part} of the width, as the verdict has it, beside edges of up to 60 degrees too, which are no walls</source>
        <translation>Die dünnsten zuerst; dünn ist, was über weniger als {limit} liegt, {part} der Breite, wie das Urteil es nimmt, auch neben Kanten bis 60 Grad, die keine Wände sind</translation>
    </message>
    <message>
        <source>The thinnest wall is {wall} ± {error:.2g}: a finer mesh would be too large.</source>
        <translation>Die dünnste Wand ist {wall} ± {error:.2g} dick: Ein feineres Netz würde zu groß.</translation>
    </message>
    <message>
        <source>The thinnest wall, {wall}, is below what the mesh resolves ({error:.2g}).</source>
        <translation>Die dünnste Wand, {wall}, liegt unter dem, was das Netz auflöst ({error:.2g}).</translation>
    </message>
    <message>
        <source>The triangles are not consistently oriented, so it has no certain volume.</source>
        <translation>Die Dreiecke sind nicht einheitlich orientiert, daher ist das Volumen nicht sicher.</translation>
    </message>
    <message>
        <source>The walls of {part} do not meet: {inside} of the {free} of free edges of its mid-surface lie inside the material. Mesh it as a solid.</source>
        <translation>Die Wände von {part} treffen sich nicht: {inside} der {free} freier Kanten der Mittelfläche liegen im Material. Vernetzen Sie das Teil als Volumen.</translation>
    </message>
    <message>
        <source>The worker process failed ({problem}).</source>
        <translation>Der Arbeitsprozess ist fehlgeschlagen ({problem}).</translation>
    </message>
    <message>
        <source>The worker processes end as soon as they start: try a larger --memory, or fewer --jobs.</source>
        <translation>Die Arbeitsprozesse enden, sobald sie starten: Versuchen Sie es mit mehr Speicher (--memory) oder weniger Dateien gleichzeitig (--jobs).</translation>
    </message>
    <message>
        <source>The {what} cannot be {value:g}: use a value from {least:g} to {most:g} {unit}.</source>
        <translation>{what}: {value:g} ist nicht erlaubt, nur {least:g} bis {most:g} {unit}.</translation>
    </message>
    <message>
        <source>There are no info files (*{ending}) in {paths}: classify the parts first.</source>
        <translation>In {paths} gibt es keine Infodateien (*{ending}): Klassifizieren Sie zuerst die Bauteile.</translation>
    </message>
    <message>
        <source>There are no labels in {folder}: label parts in the window, or by 'thinpart note --label', or name CSV files of labels.</source>
        <translation>In {folder} gibt es keine Einordnungen: Ordnen Sie Bauteile im Fenster ein oder mit 'thinpart note --label', oder nennen Sie CSV-Dateien mit Einordnungen.</translation>
    </message>
    <message>
        <source>There are no limits of walls for {process!r}: there are {known}.</source>
        <translation>Für {process!r} gibt es keine Grenzen der Wandstärke: Es gibt {known}.</translation>
    </message>
    <message>
        <source>There are no parts in {paths}: name a CAD file or a folder that holds some.</source>
        <translation>In {paths} gibt es keine Bauteile: Nennen Sie eine CAD-Datei oder einen Ordner, der welche enthält.</translation>
    </message>
    <message>
        <source>There are too few labels: {counts}. At least {needed} parts of every category are needed: even if the verdicts on so few were all right, only {percent:.0f} % right could be claimed with confidence.</source>
        <translation>Es gibt zu wenige Einordnungen: {counts}. Von jeder Kategorie werden mindestens {needed} Bauteile gebraucht: Selbst wenn alle Urteile über so wenige richtig wären, ließe sich nur von {percent:.0f} % mit Sicherheit sagen, dass sie richtig sind.</translation>
    </message>
    <message>
        <source>There is no accuracy {accuracy!r}: use {known}.</source>
        <translation>Die Genauigkeit {accuracy!r} gibt es nicht: Verwenden Sie {known}.</translation>
    </message>
    <message>
        <source>There is no box {box!r}: use minimal or principal.</source>
        <translation>Den Quader {box!r} gibt es nicht: Verwenden Sie minimal oder principal.</translation>
    </message>
    <message>
        <source>There is no closed solid in '{object}': select a solid, a body, or a face of one.</source>
        <translation>In „{object}“ gibt es keinen geschlossenen Volumenkörper: Wählen Sie einen Volumenkörper, einen Körper oder eine Fläche davon.</translation>
    </message>
    <message>
        <source>There is no closed solid in the document '{document}': make or import a solid first.</source>
        <translation>Im Dokument „{document}“ gibt es keinen geschlossenen Volumenkörper: Erstellen oder importieren Sie zuerst einen.</translation>
    </message>
    <message>
        <source>There is no file of labels {file}.</source>
        <translation>Die Datei der Einordnungen {file} gibt es nicht.</translation>
    </message>
    <message>
        <source>There is no file {file} with limits of walls: copy {shipped} and edit it.</source>
        <translation>Es gibt keine Datei {file} mit Grenzen der Wandstärke: Kopieren Sie {shipped} und bearbeiten Sie die Kopie.</translation>
    </message>
    <message>
        <source>There is no file {file}.</source>
        <translation>Die Datei {file} gibt es nicht.</translation>
    </message>
    <message>
        <source>There is no file {file}: --mesh takes a JSON object or a file.</source>
        <translation>Die Datei {file} gibt es nicht: Netzeinstellungen sind ein JSON-Objekt oder eine Datei.</translation>
    </message>
    <message>
        <source>There is no folder {folder}: name the one with the info files.</source>
        <translation>Den Ordner {folder} gibt es nicht: Nennen Sie den mit den Infodateien.</translation>
    </message>
    <message>
        <source>There is no info file {info_file}: classify {file} first, or name the folder of its info file with --info-dir.</source>
        <translation>Die Infodatei {info_file} gibt es nicht: Klassifizieren Sie zuerst {file} oder nennen Sie mit --info-dir den Ordner der Infodatei.</translation>
    </message>
    <message>
        <source>There is no measure {measure!r}: use rays or pairs.</source>
        <translation>Das Messverfahren {measure!r} gibt es nicht: Verwenden Sie rays oder pairs.</translation>
    </message>
    <message>
        <source>There is no part that could be written to {file}.</source>
        <translation>Es gibt kein Teil, das nach {file} geschrieben werden könnte.</translation>
    </message>
    <message>
        <source>There is no part {part} in {file}: it has {parts}.</source>
        <translation>In {file} gibt es kein Bauteil {part}: Es hat {parts}.</translation>
    </message>
    <message>
        <source>There is no permission to read {file}: check its permissions.</source>
        <translation>{file} darf nicht gelesen werden: Prüfen Sie die Zugriffsrechte.</translation>
    </message>
    <message>
        <source>There is no permission to search the folder {folder}: check its permissions.</source>
        <translation>Der Ordner {folder} darf nicht durchsucht werden: Prüfen Sie seine Zugriffsrechte.</translation>
    </message>
    <message>
        <source>There is no profile {profile!r}: give a file or one of {known}.</source>
        <translation>Das Profil {profile!r} gibt es nicht: Geben Sie eine Datei oder eines von {known} an.</translation>
    </message>
    <message>
        <source>There is no quantity {quantity!r} in the condition {condition!r}: there are {known}.</source>
        <translation>Die Größe {quantity!r} in der Bedingung {condition!r} gibt es nicht: Es gibt {known}.</translation>
    </message>
    <message>
        <source>There is no quantity {quantity!r}: there are {known}.</source>
        <translation>Die Größe {quantity!r} gibt es nicht: Es gibt {known}.</translation>
    </message>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>Der Speicher reicht dafür nicht aus.</translation>
    </message>
    <message>
        <source>These are not among the parts above</source>
        <translation>Diese sind nicht unter den Teilen oben</translation>
    </message>
    <message>
        <source>These are not in the table above</source>
        <translation>Diese sind nicht in der Tabelle oben</translation>
    </message>
    <message>
        <source>Thickness and box: {unit}. The fill is the share of its box that a part fills, V/VBB.</source>
        <translation>Dicke und Hüllquader: {unit}. Die Füllung ist der Anteil, den ein Teil von seinem Hüllquader füllt, V/VBB.</translation>
    </message>
    <message>
        <source>Thickness and box: {unit}. The margin is how far the deciding quantities lie from another category, relative to their thresholds.</source>
        <translation>Dicke und Hüllquader: {unit}. Der Abstand sagt, wie weit die entscheidenden Größen von einer anderen Kategorie entfernt sind, bezogen auf ihre Schwellen.</translation>
    </message>
    <message>
        <source>Thickness by</source>
        <translation>Dicke durch</translation>
    </message>
    <message>
        <source>Thin part</source>
        <translation>Dünnwandiges Bauteil</translation>
    </message>
    <message>
        <source>Thin plates nearly everywhere</source>
        <translation>Fast überall dünne Platten</translation>
    </message>
    <message>
        <source>Thin ribs, pins, teeth or a thread on a solid body</source>
        <translation>Dünne Rippen, Stifte, Zähne oder ein Gewinde auf einem massiven Körper</translation>
    </message>
    <message>
        <source>Thin share</source>
        <translation>Anteil dünn</translation>
    </message>
    <message>
        <source>Thin walls in places</source>
        <translation>Stellenweise dünne Wände</translation>
    </message>
    <message>
        <source>Thin walls over most of its surface</source>
        <translation>Überwiegend dünne Wände</translation>
    </message>
    <message>
        <source>Thin walls, tapered ones too, over a good part of its surface</source>
        <translation>Dünne Wände, auch keilförmige, über einem guten Teil der Oberfläche</translation>
    </message>
    <message>
        <source>Thinner wall beside a thick body</source>
        <translation>Dünnere Wand neben dickem Körper</translation>
    </message>
    <message>
        <source>Thinnest</source>
        <translation>Dünnste</translation>
    </message>
    <message>
        <source>Thinnest parallel wall {thinnest}: classify the part again for its tapered walls.</source>
        <translation>Dünnste parallele Wand {thinnest}: Klassifizieren Sie das Teil erneut, um auch keilförmige Wände zu erfassen.</translation>
    </message>
    <message>
        <source>Thinnest towards</source>
        <translation>Dünnste gegen</translation>
    </message>
    <message>
        <source>Thinnest wall</source>
        <translation>Dünnste Wand</translation>
    </message>
    <message>
        <source>Thinnest wall {thinnest}</source>
        <translation>Dünnste Wand {thinnest}</translation>
    </message>
    <message>
        <source>Thinnest wall {thinnest}, in a taper</source>
        <translation>Dünnste Wand {thinnest}, keilförmig</translation>
    </message>
    <message>
        <source>Thinnest wall {thinnest}, in a taper; {count} places below {below:.2g}</source>
        <translation>Dünnste Wand {thinnest}, keilförmig; {count} Stellen unter {below:.2g}</translation>
    </message>
    <message>
        <source>Thinnest wall {thinnest}; {count} places below {below:.2g}</source>
        <translation>Dünnste Wand {thinnest}; {count} Stellen unter {below:.2g}</translation>
    </message>
    <message>
        <source>Thinnest {thinnest}, {depth:.2g} beside a sharp edge</source>
        <translation>Dünnste Stelle {thinnest}, {depth:.2g} neben einer scharfen Kante</translation>
    </message>
    <message>
        <source>Thinnest {thinnest}, {depth:.2g} beside a sharp edge; {count} places below {below:.2g}</source>
        <translation>Dünnste Stelle {thinnest}, {depth:.2g} neben einer scharfen Kante; {count} Stellen unter {below:.2g}</translation>
    </message>
    <message>
        <source>Thinnest, {unit}</source>
        <translation>Dünnste, {unit}</translation>
    </message>
    <message>
        <source>This FreeCAD has no FEM workbench: install it (Debian: 'apt-get install freecad', elsewhere the installer of freecad.org, which has it), then start FreeCAD again.</source>
        <translation>Dieses FreeCAD hat keinen Arbeitsbereich FEM: Installieren Sie ihn (Debian: 'apt-get install freecad', sonst mit dem Installer von freecad.org, der ihn enthält) und starten Sie FreeCAD neu.</translation>
    </message>
    <message>
        <source>This may be an older shape of '{object}', because its last recompute failed ({reason}): repair it and recompute the document.</source>
        <translation>Dies ist möglicherweise eine ältere Form von „{object}“, weil die letzte Neuberechnung fehlgeschlagen ist ({reason}): Reparieren Sie das Objekt und berechnen Sie das Dokument neu.</translation>
    </message>
    <message>
        <source>This may be an older shape of '{object}', because the last recompute of '{feature}', which it is made with, failed ({reason}): repair it and recompute the document.</source>
        <translation>Dies ist möglicherweise eine ältere Form von „{object}“, weil die letzte Neuberechnung von „{feature}“, woraus es entsteht, fehlgeschlagen ist ({reason}): Reparieren Sie das Objekt und berechnen Sie das Dokument neu.</translation>
    </message>
    <message>
        <source>This needs CalculiX: install it (Debian: 'apt-get install calculix-ccx', elsewhere: https://www.calculix.de), and see that 'ccx -v' runs.</source>
        <translation>Hierfür wird CalculiX gebraucht: installieren (Debian: 'apt-get install calculix-ccx', sonst: https://www.calculix.de) und prüfen, dass 'ccx -v' läuft.</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>Thresholds chosen on 496 real CAD parts of 43 public repositories that engineers labelled by eye, and tried on repositories left out; quantities after Giannini, Petton, Pernot, TMCE 2012, in units of the middle side of the box</source>
        <translation>Schwellen gewählt an 496 echten CAD-Teilen aus 43 öffentlichen Repositorien, die Ingenieure nach Augenschein beurteilt haben, und erprobt an ausgelassenen Repositorien; Größen nach Giannini, Petton, Pernot, TMCE 2012, in Einheiten der mittleren Seite des Quaders</translation>
    </message>
    <message>
        <source>Twice the volume by the area and the median local thickness: 1 of a plate, 1/2 of a wire or square bar</source>
        <translation>Doppeltes Volumen durch Fläche und Median der örtlichen Dicke: 1 bei einer Platte, 1/2 bei einem Draht oder Vierkantstab</translation>
    </message>
    <message>
        <source>Two lines of a nozzle of 0.4 mm.</source>
        <translation>Zwei Bahnen einer Düse von 0,4 mm.</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Unbekannt</translation>
    </message>
    <message>
        <source>Unmeasured</source>
        <translation>Ungemessen</translation>
    </message>
    <message>
        <source>Unsure: “{category}” ({probability}) or “{other}” ({others}).</source>
        <translation>Unsicher: „{category}“ ({probability}) oder „{other}“ ({others}).</translation>
    </message>
    <message>
        <source>VTK PolyData with thickness (*.vtp)</source>
        <translation>VTK PolyData mit Dicke (*.vtp)</translation>
    </message>
    <message>
        <source>Very thin wall on a filled part</source>
        <translation>Sehr dünne Wand an massivem Bauteil</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Volume of the part</source>
        <translation>Volumen des Bauteils</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Wand</translation>
    </message>
    <message>
        <source>Wall thickness of 1 part</source>
        <translation>Wandstärke von 1 Bauteil</translation>
    </message>
    <message>
        <source>Wall thickness of {count} parts</source>
        <translation>Wandstärke von {count} Bauteilen</translation>
    </message>
    <message>
        <source>Walls held on two sides; free-standing ones need more.</source>
        <translation>Wände, die an zwei Seiten gehalten sind; frei stehende brauchen mehr.</translation>
    </message>
    <message>
        <source>Walls {low} to {high} thick, {share} of the surface</source>
        <translation>Wände von {low} bis {high}, {share} der Oberfläche</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Warnungen</translation>
    </message>
    <message>
        <source>What is solid could not be cut from the walls ({problem}).</source>
        <translation>Das Volumen ließ sich nicht von den Wänden trennen ({problem}).</translation>
    </message>
    <message>
        <source>What is solid of {part} could not be meshed ({problem}).</source>
        <translation>Das Volumen von {part} ließ sich nicht vernetzen ({problem}).</translation>
    </message>
    <message>
        <source>What is solid of {part} is not in the file. {problem}</source>
        <translation>Das Volumen von {part} ist nicht in der Datei. {problem}</translation>
    </message>
    <message>
        <source>What shows it</source>
        <translation>Woran man es sieht</translation>
    </message>
    <message>
        <source>Where it is thin</source>
        <translation>Wo es dünn ist</translation>
    </message>
    <message>
        <source>Whether its walls lie within what processes allow</source>
        <translation>Ob die Wände einhalten, was Verfahren zulassen</translation>
    </message>
    <message>
        <source>Why it is in this category</source>
        <translation>Warum diese Kategorie</translation>
    </message>
    <message>
        <source>Why:</source>
        <translation>Warum:</translation>
    </message>
    <message>
        <source>With a limit of its own ({reason}), but without a wall that could be measured: {faces}.</source>
        <translation>Mit eigener Grenze ({reason}), aber ohne messbare Wand: {faces}.</translation>
    </message>
    <message>
        <source>Within a limit of its own ({reason}): {faces}.</source>
        <translation>Innerhalb einer eigenen Grenze ({reason}): {faces}.</translation>
    </message>
    <message>
        <source>Your libraries have it in another size: this is {scale:.6g} times {file}.</source>
        <translation>Ihre Bibliotheken haben es in anderer Größe: Dies ist das {scale:.6g}-Fache von {file}.</translation>
    </message>
    <message>
        <source>Your libraries have its mirror image: {file}.</source>
        <translation>Ihre Bibliotheken haben sein Spiegelbild: {file}.</translation>
    </message>
    <message>
        <source>Your libraries have one like it: {file}. {evidence}</source>
        <translation>Ihre Bibliotheken haben ein ähnliches: {file}. {evidence}</translation>
    </message>
    <message>
        <source>Your libraries have this part: {file}.</source>
        <translation>Ihre Bibliotheken haben dieses Bauteil: {file}.</translation>
    </message>
    <message>
        <source>Your own limits {file} cannot be written ({problem}): make room, or name another file in THINPART_LIMITS.</source>
        <translation>Ihre eigenen Grenzen {file} können nicht geschrieben werden ({problem}): Schaffen Sie Platz oder nennen Sie in THINPART_LIMITS eine andere Datei.</translation>
    </message>
    <message>
        <source>Zinc, large casting</source>
        <translation>Zink, großes Gussteil</translation>
    </message>
    <message>
        <source>Zinc, small casting</source>
        <translation>Zink, kleines Gussteil</translation>
    </message>
    <message>
        <source>a bar of {thickness} ({share} of the width)</source>
        <translation>einen Stab von {thickness} ({share} der Breite)</translation>
    </message>
    <message>
        <source>a block of its elements is empty</source>
        <translation>ein Block seiner Elemente ist leer</translation>
    </message>
    <message>
        <source>a larger error, a fifth of the elements</source>
        <translation>ein größerer Fehler, ein Fünftel der Elemente</translation>
    </message>
    <message>
        <source>a number in it is too long</source>
        <translation>eine Zahl darin ist zu lang</translation>
    </message>
    <message>
        <source>a part of {file} is neither measured nor refused</source>
        <translation>ein Teil von {file} ist weder gemessen noch abgelehnt</translation>
    </message>
    <message>
        <source>a rib of {thickness} ({share} of the width)</source>
        <translation>eine Rippe von {thickness} ({share} der Breite)</translation>
    </message>
    <message>
        <source>a stud of {thickness} ({share} of the width)</source>
        <translation>ein Zapfen von {thickness} ({share} der Breite)</translation>
    </message>
    <message>
        <source>a taper {least} to {thickness} thick</source>
        <translation>ein Keil von {least} bis {thickness}</translation>
    </message>
    <message>
        <source>a twentieth of the surface is thinner than {limit}, 1/{part:.1f} of an element</source>
        <translation>ein Zwanzigstel der Oberfläche ist dünner als {limit}, 1/{part:.1f} eines Elements</translation>
    </message>
    <message>
        <source>a wall of {thickness} ({share} of the width)</source>
        <translation>eine Wand von {thickness} ({share} der Breite)</translation>
    </message>
    <message>
        <source>along the principal axes; diagonal {diagonal}</source>
        <translation>entlang der Hauptachsen; Diagonale {diagonal}</translation>
    </message>
    <message>
        <source>an edge of {shortest}, 1/{part:.0f} of an element</source>
        <translation>eine Kante von {shortest}, 1/{part:.0f} eines Elements</translation>
    </message>
    <message>
        <source>an entry has no header</source>
        <translation>ein Eintrag hat keinen Kopf</translation>
    </message>
    <message>
        <source>an entry has two names</source>
        <translation>ein Eintrag hat zwei Namen</translation>
    </message>
    <message>
        <source>an entry is called '{entry}'</source>
        <translation>ein Eintrag heißt „{entry}“</translation>
    </message>
    <message>
        <source>an entry is cut off</source>
        <translation>ein Eintrag ist abgeschnitten</translation>
    </message>
    <message>
        <source>an info file is damaged, foreign or of a newer version</source>
        <translation>eine Infodatei ist beschädigt, fremd oder von einer neueren Version</translation>
    </message>
    <message>
        <source>an unexpected error</source>
        <translation>ein unerwarteter Fehler</translation>
    </message>
    <message>
        <source>an unexpected error in ThinPart: try again, and report it with the file if it happens again</source>
        <translation>ein unerwarteter Fehler in ThinPart: Versuchen Sie es noch einmal, und melden Sie ihn mit der Datei, wenn er wieder auftritt</translation>
    </message>
    <message>
        <source>and {count} more</source>
        <translation>und {count} weitere</translation>
    </message>
    <message>
        <source>and {count} smaller walls, {share} of the surface</source>
        <translation>und {count} kleinere Wände, {share} der Oberfläche</translation>
    </message>
    <message>
        <source>angular deflection</source>
        <translation>Winkelabweichung</translation>
    </message>
    <message>
        <source>another program keeps the folder locked</source>
        <translation>ein anderes Programm hält den Ordner gesperrt</translation>
    </message>
    <message>
        <source>as it was open in FreeCAD, not saved</source>
        <translation>wie es in FreeCAD offen war, nicht gespeichert</translation>
    </message>
    <message>
        <source>as proposed</source>
        <translation>wie vorgeschlagen</translation>
    </message>
    <message>
        <source>bar</source>
        <translation>Stab</translation>
    </message>
    <message>
        <source>below {share}</source>
        <translation>unter {share}</translation>
    </message>
    <message>
        <source>beside a sharp edge</source>
        <translation>neben einer scharfen Kante</translation>
    </message>
    <message>
        <source>beside edges, {share} of the surface is thinner than {limit}, {part} of the width of {middle}</source>
        <translation>neben Kanten sind {share} der Oberfläche dünner als {limit}, {part} der Breite von {middle}</translation>
    </message>
    <message>
        <source>block</source>
        <translation>Block</translation>
    </message>
    <message>
        <source>borderline</source>
        <translation>Grenzfall</translation>
    </message>
    <message>
        <source>box as flat</source>
        <translation>Quader gleich flach</translation>
    </message>
    <message>
        <source>box as long</source>
        <translation>Quader gleich lang</translation>
    </message>
    <message>
        <source>by Netgen, since Gmsh does not mesh it</source>
        <translation>mit Netgen, da Gmsh es nicht vernetzt</translation>
    </message>
    <message>
        <source>byte {place} is not text in Unicode</source>
        <translation>Byte {place} ist kein Text in Unicode</translation>
    </message>
    <message>
        <source>can be edited in FreeCAD</source>
        <translation>lässt sich in FreeCAD bearbeiten</translation>
    </message>
    <message>
        <source>colours stand for the largest ball inside that touches the surface</source>
        <translation>die Farben stehen für die größte Kugel im Innern, die die Oberfläche berührt</translation>
    </message>
    <message>
        <source>colours stand for the local thickness</source>
        <translation>die Farben stehen für die örtliche Dicke</translation>
    </message>
    <message>
        <source>colours stand for the thickness of the wall below the surface</source>
        <translation>die Farben stehen für die Dicke der Wand unter der Oberfläche</translation>
    </message>
    <message>
        <source>coordinates are not numbers</source>
        <translation>Koordinaten sind keine Zahlen</translation>
    </message>
    <message>
        <source>curved walls that elements change by over {part} of their thickness on {share} of the surface</source>
        <translation>gekrümmte Wände, die Elemente um mehr als {part} ihrer Dicke verändern, an {share} der Oberfläche</translation>
    </message>
    <message>
        <source>different proportions</source>
        <translation>andere Proportionen</translation>
    </message>
    <message>
        <source>different wall distribution</source>
        <translation>andere Wandverteilung</translation>
    </message>
    <message>
        <source>edges of it join more than two faces ({count}), as where bodies touch along them: fuse these with some overlap, or separate them</source>
        <translation>Kanten verbinden mehr als zwei Flächen ({count}), wie dort, wo Körper sich entlang von ihnen berühren: Vereinigen Sie diese mit etwas Überlappung, oder trennen Sie sie</translation>
    </message>
    <message>
        <source>element size {size}</source>
        <translation>Elementgröße {size}</translation>
    </message>
    <message>
        <source>excluded: {reason}</source>
        <translation>ausgenommen: {reason}</translation>
    </message>
    <message>
        <source>faces that lie on each other taken out</source>
        <translation>ohne Flächen, die aufeinander liegen</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fehlgeschlagen</translation>
    </message>
    <message>
        <source>family {number}</source>
        <translation>Familie {number}</translation>
    </message>
    <message>
        <source>far fewer tapered walls</source>
        <translation>viel weniger schräge Wände</translation>
    </message>
    <message>
        <source>far more tapered walls</source>
        <translation>viel mehr schräge Wände</translation>
    </message>
    <message>
        <source>fewer layers in the thinnest walls, a twentieth of the thin area</source>
        <translation>weniger Schichten in den dünnsten Wänden, einem Zwanzigstel der dünnen Fläche</translation>
    </message>
    <message>
        <source>fewer layers, a fifth of the elements</source>
        <translation>weniger Lagen, ein Fünftel der Elemente</translation>
    </message>
    <message>
        <source>fewer tapered walls</source>
        <translation>weniger schräge Wände</translation>
    </message>
    <message>
        <source>fill not comparable</source>
        <translation>Füllung nicht vergleichbar</translation>
    </message>
    <message>
        <source>fill, V/VBB</source>
        <translation>Füllung, V/VBB</translation>
    </message>
    <message>
        <source>fine</source>
        <translation>fein</translation>
    </message>
    <message>
        <source>finer at curves, short edges and narrow faces</source>
        <translation>feiner an Rundungen, kurzen Kanten und schmalen Flächen</translation>
    </message>
    <message>
        <source>finer where Gmsh failed</source>
        <translation>feiner, wo Gmsh scheiterte</translation>
    </message>
    <message>
        <source>finer where Gmsh failed, surfaces by Delaunay's method</source>
        <translation>feiner, wo Gmsh scheiterte, Flächen nach Delaunay</translation>
    </message>
    <message>
        <source>flatter box</source>
        <translation>flacherer Quader</translation>
    </message>
    <message>
        <source>for the verdict</source>
        <translation>für das Urteil</translation>
    </message>
    <message>
        <source>format is not {format!r}</source>
        <translation>format ist nicht {format!r}</translation>
    </message>
    <message>
        <source>geometry, not triangles</source>
        <translation>Geometrie statt Dreiecke</translation>
    </message>
    <message>
        <source>group {number}</source>
        <translation>Gruppe {number}</translation>
    </message>
    <message>
        <source>has a name of its own</source>
        <translation>hat einen eigenen Namen</translation>
    </message>
    <message>
        <source>has notes</source>
        <translation>hat Notizen</translation>
    </message>
    <message>
        <source>in a taper</source>
        <translation>keilförmig</translation>
    </message>
    <message>
        <source>it cannot be unpacked</source>
        <translation>sie lässt sich nicht entpacken</translation>
    </message>
    <message>
        <source>it fills {share} of its box</source>
        <translation>füllt {share} seines Hüllquaders</translation>
    </message>
    <message>
        <source>it has no such motion</source>
        <translation>es gibt diese Bewegung nicht</translation>
    </message>
    <message>
        <source>it has no triangles</source>
        <translation>sie hat keine Dreiecke</translation>
    </message>
    <message>
        <source>it has {count} cells, and the header has {columns}: put quotes around what holds a comma</source>
        <translation>die Zeile hat {count} Zellen und die Kopfzeile {columns}: Setzen Sie Text mit Komma in Anführungszeichen</translation>
    </message>
    <message>
        <source>it is a file</source>
        <translation>es ist eine Datei</translation>
    </message>
    <message>
        <source>it is damaged or incomplete</source>
        <translation>sie ist beschädigt oder unvollständig</translation>
    </message>
    <message>
        <source>it is larger than {megabytes} MB</source>
        <translation>sie ist größer als {megabytes} MB</translation>
    </message>
    <message>
        <source>it is nested too deeply</source>
        <translation>sie ist zu tief verschachtelt</translation>
    </message>
    <message>
        <source>it is not JSON: line {line} column {column}</source>
        <translation>sie ist kein JSON: Zeile {line}, Spalte {column}</translation>
    </message>
    <message>
        <source>it is not UTF-8 text</source>
        <translation>sie ist kein UTF-8-Text</translation>
    </message>
    <message>
        <source>it is not a CSV table ({problem})</source>
        <translation>das ist keine CSV-Tabelle ({problem})</translation>
    </message>
    <message>
        <source>it is not a regular file</source>
        <translation>es ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>it is not in the binary MSH format 2.2</source>
        <translation>es ist nicht im binären MSH-Format 2.2</translation>
    </message>
    <message>
        <source>it is not text in UTF-8: save the table as CSV</source>
        <translation>das ist kein Text in UTF-8: Speichern Sie die Tabelle als CSV</translation>
    </message>
    <message>
        <source>it names no file</source>
        <translation>die Zeile nennt keine Datei</translation>
    </message>
    <message>
        <source>it stores a file as '{path}'</source>
        <translation>es legt eine Datei als „{path}“ ab</translation>
    </message>
    <message>
        <source>it stores a resource as '{path}'</source>
        <translation>es legt eine Ressource als „{path}“ ab</translation>
    </message>
    <message>
        <source>its box is flat, {long} by {middle} by {short}</source>
        <translation>flacher Hüllquader, {long} mal {middle} mal {short}</translation>
    </message>
    <message>
        <source>its mesh is incomplete: is the disk full?</source>
        <translation>sein Netz ist unvollständig: Ist der Datenträger voll?</translation>
    </message>
    <message>
        <source>its parts are not those of {file}</source>
        <translation>seine Bauteile sind nicht die von {file}</translation>
    </message>
    <message>
        <source>its probabilities are not of its categories, in their order</source>
        <translation>die Wahrscheinlichkeiten gehören nicht zu den Kategorien in deren Reihenfolge</translation>
    </message>
    <message>
        <source>its reference mesh is too large</source>
        <translation>sein Vergleichsnetz ist zu groß</translation>
    </message>
    <message>
        <source>its reference mesh took too long</source>
        <translation>sein Vergleichsnetz hat zu lange gedauert</translation>
    </message>
    <message>
        <source>its second answer is the first one</source>
        <translation>die zweite Antwort ist gleich der ersten</translation>
    </message>
    <message>
        <source>its walls make no shell</source>
        <translation>seine Wände ergeben keine Schale</translation>
    </message>
    <message>
        <source>its {entry} declares its own entities</source>
        <translation>seine {entry} deklariert eigene Entitäten</translation>
    </message>
    <message>
        <source>its {entry} is not in UTF-8</source>
        <translation>{entry} ist nicht in UTF-8</translation>
    </message>
    <message>
        <source>its {entry} would be larger than {gigabytes} GB</source>
        <translation>seine {entry} wäre größer als {gigabytes} GB</translation>
    </message>
    <message>
        <source>keep</source>
        <translation>behalten</translation>
    </message>
    <message>
        <source>layers in its thin walls</source>
        <translation>Lagen in den dünnen Wänden</translation>
    </message>
    <message>
        <source>less filled</source>
        <translation>weniger gefüllt</translation>
    </message>
    <message>
        <source>less flat box</source>
        <translation>weniger flacher Quader</translation>
    </message>
    <message>
        <source>less than {share} of the surface lies over walls thinner than {limit}, {part} of the width of {middle}</source>
        <translation>weniger als {share} der Oberfläche liegen über Wänden dünner als {limit}, {part} der Breite von {middle}</translation>
    </message>
    <message>
        <source>linear deflection</source>
        <translation>Lineare Abweichung</translation>
    </message>
    <message>
        <source>linear deflection {linear}, angular deflection {angular} degrees, at walls {wall}, at least {samples} samples, accuracy {accuracy}</source>
        <translation>lineare Abweichung {linear}, Winkelabweichung {angular} Grad, an Wänden {wall}, mindestens {samples} Messpunkte, Genauigkeit {accuracy}</translation>
    </message>
    <message>
        <source>longer box</source>
        <translation>längerer Quader</translation>
    </message>
    <message>
        <source>longest side</source>
        <translation>längste Seite</translation>
    </message>
    <message>
        <source>look in FreeCAD what 'Check geometry' says about it</source>
        <translation>sehen Sie in FreeCAD nach, was „Geometrie prüfen“ dazu sagt</translation>
    </message>
    <message>
        <source>median wall / diagonal of the box</source>
        <translation>mittlere Wand / Diagonale des Hüllquaders</translation>
    </message>
    <message>
        <source>middle side</source>
        <translation>mittlere Seite</translation>
    </message>
    <message>
        <source>more filled</source>
        <translation>stärker gefüllt</translation>
    </message>
    <message>
        <source>more tapered walls</source>
        <translation>mehr schräge Wände</translation>
    </message>
    <message>
        <source>much flatter box</source>
        <translation>viel flacherer Quader</translation>
    </message>
    <message>
        <source>much less filled</source>
        <translation>viel weniger gefüllt</translation>
    </message>
    <message>
        <source>much less flat box</source>
        <translation>viel weniger flacher Quader</translation>
    </message>
    <message>
        <source>much longer box</source>
        <translation>viel längerer Quader</translation>
    </message>
    <message>
        <source>much more filled</source>
        <translation>viel stärker gefüllt</translation>
    </message>
    <message>
        <source>much shorter box</source>
        <translation>viel kürzerer Quader</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>no element larger than the part is thick there</source>
        <translation>kein Element größer als die Dicke des Teils an der Stelle</translation>
    </message>
    <message>
        <source>no permission to read the file</source>
        <translation>keine Berechtigung, die Datei zu lesen</translation>
    </message>
    <message>
        <source>no reason given</source>
        <translation>kein Grund angegeben</translation>
    </message>
    <message>
        <source>no wall is thinner than {limit}, {part} of the width of {middle}</source>
        <translation>keine Wand ist dünner als {limit}, {part} der Breite von {middle}</translation>
    </message>
    <message>
        <source>no wall is thinner than {thinnest}, {part} of the width of {middle}</source>
        <translation>keine Wand ist dünner als {thinnest}, {part} der Breite von {middle}</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>of least volume; diagonal {diagonal}</source>
        <translation>kleinsten Volumens; Diagonale {diagonal}</translation>
    </message>
    <message>
        <source>of the diagonal</source>
        <translation>der Diagonale</translation>
    </message>
    <message>
        <source>one reference mesh is not enough, and a second one too large</source>
        <translation>ein Vergleichsnetz genügt nicht, und ein zweites ist zu groß</translation>
    </message>
    <message>
        <source>one size, since nothing finer is meshed</source>
        <translation>eine einzige Größe, da nichts Feineres vernetzt wird</translation>
    </message>
    <message>
        <source>only tapered walls are thinner than {limit}, {part} of the width of {middle}</source>
        <translation>nur keilförmige Wände sind dünner als {limit}, {part} der Breite von {middle}</translation>
    </message>
    <message>
        <source>only {share} of the surface lies over walls thinner than {limit}, {part} of the width of {middle}</source>
        <translation>nur {share} der Oberfläche liegen über Wänden dünner als {limit}, {part} der Breite von {middle}</translation>
    </message>
    <message>
        <source>other</source>
        <translation>andere</translation>
    </message>
    <message>
        <source>parts of its surface</source>
        <translation>Teile seiner Oberfläche</translation>
    </message>
    <message>
        <source>plate</source>
        <translation>Platte</translation>
    </message>
    <message>
        <source>processes[{number}]{place} has a min_mm of {least:g}, not below its max_mm of {most:g}</source>
        <translation>processes[{number}]{place} hat ein min_mm von {least:g}, das nicht unter seinem max_mm von {most:g} liegt</translation>
    </message>
    <message>
        <source>processes[{number}]{place} has neither min_mm nor max_mm</source>
        <translation>processes[{number}]{place} hat weder min_mm noch max_mm</translation>
    </message>
    <message>
        <source>proportions not comparable</source>
        <translation>Proportionen nicht vergleichbar</translation>
    </message>
    <message>
        <source>radius {number}</source>
        <translation>Radius {number}</translation>
    </message>
    <message>
        <source>rib</source>
        <translation>Rippe</translation>
    </message>
    <message>
        <source>same fill</source>
        <translation>gleiche Füllung</translation>
    </message>
    <message>
        <source>same proportions</source>
        <translation>gleiche Proportionen</translation>
    </message>
    <message>
        <source>same wall distribution</source>
        <translation>gleiche Wandverteilung</translation>
    </message>
    <message>
        <source>short edges and narrow faces not finer than the walls</source>
        <translation>kurze Kanten und schmale Flächen nicht feiner als die Wände</translation>
    </message>
    <message>
        <source>shorter box</source>
        <translation>kürzerer Quader</translation>
    </message>
    <message>
        <source>shortest side</source>
        <translation>kürzeste Seite</translation>
    </message>
    <message>
        <source>similar proportions</source>
        <translation>ähnliche Proportionen</translation>
    </message>
    <message>
        <source>similar wall distribution</source>
        <translation>ähnliche Wandverteilung</translation>
    </message>
    <message>
        <source>standard</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>stopped on request</source>
        <translation>auf Wunsch abgebrochen</translation>
    </message>
    <message>
        <source>surfaces by Delaunay's method</source>
        <translation>Flächen nach Delaunay</translation>
    </message>
    <message>
        <source>taper</source>
        <translation>Keil</translation>
    </message>
    <message>
        <source>the cluster cannot be used</source>
        <translation>der Cluster ist nicht verwendbar</translation>
    </message>
    <message>
        <source>the column {columns} is missing; there have to be {required}, and there may be {optional}</source>
        <translation>die Spalte {columns} fehlt; nötig sind {required}, möglich sind {optional}</translation>
    </message>
    <message>
        <source>the column {columns} is there twice</source>
        <translation>die Spalte {columns} kommt zweimal vor</translation>
    </message>
    <message>
        <source>the file is damaged or not what its name says</source>
        <translation>die Datei ist beschädigt oder nicht das, was ihr Name sagt</translation>
    </message>
    <message>
        <source>the file is unsafe to open</source>
        <translation>die Datei ist nicht sicher zu öffnen</translation>
    </message>
    <message>
        <source>the file or document is empty</source>
        <translation>die Datei oder das Dokument ist leer</translation>
    </message>
    <message>
        <source>the first of equals</source>
        <translation>das erste von gleichen</translation>
    </message>
    <message>
        <source>the first wall along the inward normal</source>
        <translation>die erste Wand entlang der Normalen nach innen</translation>
    </message>
    <message>
        <source>the format is not supported here</source>
        <translation>das Format wird hier nicht unterstützt</translation>
    </message>
    <message>
        <source>the info file could not be written</source>
        <translation>die Infodatei konnte nicht geschrieben werden</translation>
    </message>
    <message>
        <source>the latest</source>
        <translation>das neueste</translation>
    </message>
    <message>
        <source>the memory limit was reached</source>
        <translation>die Speichergrenze wurde erreicht</translation>
    </message>
    <message>
        <source>the mesh was not written ({problem})</source>
        <translation>das Netz wurde nicht geschrieben ({problem})</translation>
    </message>
    <message>
        <source>the paper's pair rule</source>
        <translation>die Paarregel des Artikels</translation>
    </message>
    <message>
        <source>the part encloses no volume</source>
        <translation>das Bauteil umschließt kein Volumen</translation>
    </message>
    <message>
        <source>the profile</source>
        <translation>Das Profil</translation>
    </message>
    <message>
        <source>the profile is not usable</source>
        <translation>das Profil ist nicht verwendbar</translation>
    </message>
    <message>
        <source>the solver crashed</source>
        <translation>der Löser ist abgestürzt</translation>
    </message>
    <message>
        <source>the solver needed too much memory</source>
        <translation>der Löser brauchte zu viel Speicher</translation>
    </message>
    <message>
        <source>the solver took too long</source>
        <translation>der Löser brauchte zu lange</translation>
    </message>
    <message>
        <source>the time limit was reached</source>
        <translation>das Zeitlimit wurde erreicht</translation>
    </message>
    <message>
        <source>the worker process crashed</source>
        <translation>der Arbeitsprozess ist abgestürzt</translation>
    </message>
    <message>
        <source>there is no closed solid in it</source>
        <translation>es ist kein geschlossener Volumenkörper darin</translation>
    </message>
    <message>
        <source>there is no info file of {file!r} in {library}: classify it first, write its path as it is below that folder, or take the row out</source>
        <translation>in {library} gibt es keine Infodatei von {file!r}: Klassifizieren Sie die Datei zuerst, schreiben Sie ihren Pfad so, wie er unter diesem Ordner lautet, oder entfernen Sie die Zeile</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>thickness, {unit}</source>
        <translation>Dicke, {unit}</translation>
    </message>
    <message>
        <source>thin</source>
        <translation>dünnwandig</translation>
    </message>
    <message>
        <source>thin below {limit}</source>
        <translation>dünn unter {limit}</translation>
    </message>
    <message>
        <source>thin features</source>
        <translation>teils dünn</translation>
    </message>
    <message>
        <source>thinnest wall</source>
        <translation>dünnste Wand</translation>
    </message>
    <message>
        <source>thinnest wall, {unit}</source>
        <translation>dünnste Wand, {unit}</translation>
    </message>
    <message>
        <source>thread</source>
        <translation>Gewinde</translation>
    </message>
    <message>
        <source>thread {least} to {thickness} thick</source>
        <translation>Gewinde von {least} bis {thickness}</translation>
    </message>
    <message>
        <source>thread {least} to {thickness} thick, with a run-out to a sharp edge</source>
        <translation>Gewinde von {least} bis {thickness}, mit Auslauf in eine scharfe Kante</translation>
    </message>
    <message>
        <source>tooth</source>
        <translation>Zahn</translation>
    </message>
    <message>
        <source>tube</source>
        <translation>Rohr</translation>
    </message>
    <message>
        <source>two entries are called '{entry}'</source>
        <translation>zwei Einträge heißen „{entry}“</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>used {count} times</source>
        <translation>{count}-mal verwendet</translation>
    </message>
    <message>
        <source>varies: {names}</source>
        <translation>ändert sich: {names}</translation>
    </message>
    <message>
        <source>version is {version}, and this reads version 1</source>
        <translation>version ist {version}, und gelesen wird Version 1</translation>
    </message>
    <message>
        <source>volumes by Gmsh's usual method</source>
        <translation>Volumen nach dem üblichen Verfahren von Gmsh</translation>
    </message>
    <message>
        <source>volumes by the HXT method, which is quicker</source>
        <translation>Volumen nach dem Verfahren HXT, das schneller ist</translation>
    </message>
    <message>
        <source>walls at {low:g} to {high:g} degrees as near as {nearest}</source>
        <translation>Wände im Winkel von {low:g} bis {high:g} Grad mit nur {nearest} Abstand</translation>
    </message>
    <message>
        <source>walls thinner than {limit} over {share} of the surface</source>
        <translation>Wände dünner als {limit} auf {share} der Oberfläche</translation>
    </message>
    <message>
        <source>words of names and folders</source>
        <translation>Wörter aus Namen und Ordnern</translation>
    </message>
    <message>
        <source>wrong usage of the command</source>
        <translation>der Befehl wurde falsch aufgerufen</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>{about} needs more memory than the limit allows.</source>
        <translation>{about} braucht mehr Speicher, als erlaubt ist.</translation>
    </message>
    <message>
        <source>{about}: {sentence}</source>
        <translation>{about}: {sentence}</translation>
    </message>
    <message>
        <source>{answer!r} in the column sure is neither yes nor no</source>
        <translation>{answer!r} in der Spalte sure ist weder yes noch no</translation>
    </message>
    <message>
        <source>{bytes} bytes after its last entry belong to no entry</source>
        <translation>{bytes} Bytes nach dem letzten Eintrag gehören zu keinem Eintrag</translation>
    </message>
    <message>
        <source>{bytes} bytes that belong to no entry lie before '{entry}'</source>
        <translation>{bytes} Bytes, die zu keinem Eintrag gehören, liegen vor „{entry}“</translation>
    </message>
    <message>
        <source>{bytes} bytes, changed {time} UTC</source>
        <translation>{bytes} Bytes, geändert {time} UTC</translation>
    </message>
    <message>
        <source>{category!r} is no category: there are {known}</source>
        <translation>{category!r} ist keine Kategorie: Es gibt {known}</translation>
    </message>
    <message>
        <source>{category!r} is no category: there are {known}.</source>
        <translation>{category!r} ist keine Kategorie: Es gibt {known}.</translation>
    </message>
    <message>
        <source>{category} (unsure)</source>
        <translation>{category} (unsicher)</translation>
    </message>
    <message>
        <source>{category}, thinnest wall {thinnest}, median {median}, fill {fill}</source>
        <translation>{category}, dünnste Wand {thinnest}, Median {median}, Füllung {fill}</translation>
    </message>
    <message>
        <source>{check} {faces}</source>
        <translation>{check} {faces}</translation>
    </message>
    <message>
        <source>{command} compares the documents themselves.</source>
        <translation>{command} vergleicht die Dokumente selbst.</translation>
    </message>
    <message>
        <source>{condition} never holds, because it is never above {limit:g}</source>
        <translation>{condition} gilt nie, denn der Wert liegt nie über {limit:g}</translation>
    </message>
    <message>
        <source>{condition} never holds, because it is never below {limit:g}</source>
        <translation>{condition} gilt nie, denn der Wert liegt nie unter {limit:g}</translation>
    </message>
    <message>
        <source>{constant} is not a JSON number</source>
        <translation>{constant} ist keine Zahl in JSON</translation>
    </message>
    <message>
        <source>{count:.0f} edges shorter than {limit}, the shortest {shortest}, 1/{part:.0f} of an element</source>
        <translation>{count:.0f} Kanten kürzer als {limit}, die kürzeste {shortest}, 1/{part:.0f} eines Elements</translation>
    </message>
    <message>
        <source>{count} bars of {thickness} ({share} of the width)</source>
        <translation>{count} Stäbe von {thickness} ({share} der Breite)</translation>
    </message>
    <message>
        <source>{count} criteria</source>
        <translation>{count} Kriterien</translation>
    </message>
    <message>
        <source>{count} documents have no info file and are not on this page: 'thinpart classify' measures them.</source>
        <translation>{count} Dokumente haben keine Infodatei und fehlen auf dieser Seite: „thinpart classify“ misst sie.</translation>
    </message>
    <message>
        <source>{count} documents of the library are called {file!r}: write the path</source>
        <translation>{count} Dokumente der Bibliothek heißen {file!r}: Schreiben Sie den Pfad</translation>
    </message>
    <message>
        <source>{count} duplicate triangles were left out.</source>
        <translation>{count} doppelte Dreiecke wurden weggelassen.</translation>
    </message>
    <message>
        <source>{count} more</source>
        <translation>{count} weitere</translation>
    </message>
    <message>
        <source>{count} more faces</source>
        <translation>{count} weitere Flächen</translation>
    </message>
    <message>
        <source>{count} more folders</source>
        <translation>{count} weitere Ordner</translation>
    </message>
    <message>
        <source>{count} of them are unsure: close to another category.</source>
        <translation>{count} davon sind unsicher: nahe an einer anderen Kategorie.</translation>
    </message>
    <message>
        <source>{count} parts are not on the map: no wall was found opposite, or their surface is not closed.</source>
        <translation>{count} Teile sind nicht auf der Karte: Gegenüber wurde keine Wand gefunden, oder ihre Oberfläche ist nicht geschlossen.</translation>
    </message>
    <message>
        <source>{count} parts were measured by an earlier version and are not compared: 'thinpart classify' measures their documents again.</source>
        <translation>{count} Teile hat eine frühere Version gemessen, sie werden nicht verglichen: „thinpart classify“ misst ihre Dokumente neu.</translation>
    </message>
    <message>
        <source>{count} ribs of {thickness} ({share} of the width)</source>
        <translation>{count} Rippen von {thickness} ({share} der Breite)</translation>
    </message>
    <message>
        <source>{count} studs of {thickness} ({share} of the width)</source>
        <translation>{count} Zapfen von {thickness} ({share} der Breite)</translation>
    </message>
    <message>
        <source>{count} tapers {least} to {thickness} thick</source>
        <translation>{count} Keile von {least} bis {thickness}</translation>
    </message>
    <message>
        <source>{count} teeth {least} to {thickness} thick</source>
        <translation>{count} Zähne von {least} bis {thickness}</translation>
    </message>
    <message>
        <source>{count} triangles of zero area were left out.</source>
        <translation>{count} Dreiecke mit Flächeninhalt null wurden weggelassen.</translation>
    </message>
    <message>
        <source>{count} walls of {thickness} ({share} of the width)</source>
        <translation>{count} Wände von {thickness} ({share} der Breite)</translation>
    </message>
    <message>
        <source>{count} walls {least} to {thickness} thick</source>
        <translation>{count} Wände, {least} bis {thickness} dick</translation>
    </message>
    <message>
        <source>{count} warnings</source>
        <translation>{count} Warnungen</translation>
    </message>
    <message>
        <source>{faces} and {count} more</source>
        <translation>{faces} und {count} weitere</translation>
    </message>
    <message>
        <source>{face} fails its own limit: {ball}, at most {most} ({reason}).</source>
        <translation>{face} verfehlt die eigene Grenze: {ball}, höchstens {most} ({reason}).</translation>
    </message>
    <message>
        <source>{face} fails its own limit: {wall}, at least {least} ({reason}).</source>
        <translation>{face} verfehlt die eigene Grenze: {wall}, mindestens {least} ({reason}).</translation>
    </message>
    <message>
        <source>{file} cannot be read ({problem}).</source>
        <translation>{file} kann nicht gelesen werden ({problem}).</translation>
    </message>
    <message>
        <source>{file} cannot be read or written ({problem}): check its name, its permissions and the room on its disk.</source>
        <translation>{file} kann nicht gelesen oder geschrieben werden ({problem}): Prüfen Sie Name, Rechte und Platz auf dem Datenträger.</translation>
    </message>
    <message>
        <source>{file} cannot be written ({problem}): name another place.</source>
        <translation>{file} kann nicht geschrieben werden ({problem}): nennen Sie einen anderen Ort.</translation>
    </message>
    <message>
        <source>{file} changed while it was read: measure it again.</source>
        <translation>{file} wurde beim Lesen geändert: Messen Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>{file} could not be read in time.</source>
        <translation>{file} konnte nicht rechtzeitig gelesen werden.</translation>
    </message>
    <message>
        <source>{file} crashed the process that read it: the file is probably damaged.</source>
        <translation>{file} hat den lesenden Prozess zum Absturz gebracht: Die Datei ist wahrscheinlich beschädigt.</translation>
    </message>
    <message>
        <source>{file} failed ({problem}).</source>
        <translation>{file} ist fehlgeschlagen ({problem}).</translation>
    </message>
    <message>
        <source>{file} failed: its result cannot be stored ({problem}).</source>
        <translation>{file} ist fehlgeschlagen: Das Ergebnis kann nicht gespeichert werden ({problem}).</translation>
    </message>
    <message>
        <source>{file} failed: its result cannot be used ({problem}).</source>
        <translation>{file} ist fehlgeschlagen: das Ergebnis ist nicht verwendbar ({problem}).</translation>
    </message>
    <message>
        <source>{file} has changed since it was classified, or is gone: classify it again.</source>
        <translation>{file} hat sich seit der Klassifizierung geändert oder ist nicht mehr da: Klassifizieren Sie es erneut.</translation>
    </message>
    <message>
        <source>{file} has coordinates that are not finite numbers: export it again.</source>
        <translation>{file} hat Koordinaten, die keine endlichen Zahlen sind: Exportieren Sie die Datei erneut.</translation>
    </message>
    <message>
        <source>{file} has faces with more than four corners, which FreeCAD leaves out: triangulate it first.</source>
        <translation>{file} hat Flächen mit mehr als vier Ecken, die FreeCAD weglässt: Zerlegen Sie sie zuerst in Dreiecke.</translation>
    </message>
    <message>
        <source>{file} has no ending that ThinPart reads ({endings}).</source>
        <translation>{file} hat keine Dateiendung, die ThinPart liest ({endings}).</translation>
    </message>
    <message>
        <source>{file} has no part {part!r}: it has {parts}</source>
        <translation>{file} hat kein Bauteil {part!r}: Vorhanden sind {parts}</translation>
    </message>
    <message>
        <source>{file} has no part {part!r}: it has {parts}.</source>
        <translation>{file} hat kein Bauteil {part!r}: Vorhanden sind {parts}.</translation>
    </message>
    <message>
        <source>{file} has no part {part} any more: classify it again.</source>
        <translation>{file} enthält das Bauteil {part} nicht mehr: Klassifizieren Sie es neu.</translation>
    </message>
    <message>
        <source>{file} has the name of a CAD file and was not changed: name another file.</source>
        <translation>{file} hat den Namen einer CAD-Datei und wurde nicht geändert: eine andere Datei angeben.</translation>
    </message>
    <message>
        <source>{file} has {count} parts, and one is written: name it after --part, as {example}.</source>
        <translation>{file} hat {count} Bauteile, und eines wird geschrieben: Nennen Sie es nach --part, etwa {example}.</translation>
    </message>
    <message>
        <source>{file} has {count} parts: name one after --part, of {parts}.</source>
        <translation>{file} hat {count} Bauteile: Nennen Sie eines nach --part, von {parts}.</translation>
    </message>
    <message>
        <source>{file} holds no closed solid, only surfaces, wires or points: close or thicken it first.</source>
        <translation>{file} enthält keinen geschlossenen Volumenkörper, nur Flächen, Kanten oder Punkte: Schließen Sie die Flächen zuerst oder geben Sie ihnen eine Wandstärke.</translation>
    </message>
    <message>
        <source>{file} holds no labels: write a row per part below the header.</source>
        <translation>{file} enthält keine Einordnungen: Schreiben Sie unter die Kopfzeile eine Zeile je Bauteil.</translation>
    </message>
    <message>
        <source>{file} holds {count} parts: choose one with --part, by name or label: {parts}.</source>
        <translation>{file} enthält {count} Bauteile: Wählen Sie eines mit --part, mit Name oder Bezeichnung: {parts}.</translation>
    </message>
    <message>
        <source>{file} holds {count} parts: name one in the column part: {parts}</source>
        <translation>{file} enthält {count} Bauteile: Nennen Sie eines in der Spalte part: {parts}</translation>
    </message>
    <message>
        <source>{file} is a CAD file that ThinPart did not write, and was not changed: name another file.</source>
        <translation>{file} ist eine CAD-Datei, die ThinPart nicht geschrieben hat, und wurde nicht geändert: eine andere Datei angeben.</translation>
    </message>
    <message>
        <source>{file} is a link that leads back to itself: remove it or link it to a part.</source>
        <translation>{file} ist eine Verknüpfung, die auf sich selbst führt: Entfernen Sie sie oder verknüpfen Sie sie mit einem Bauteil.</translation>
    </message>
    <message>
        <source>{file} is a link that leads nowhere: remove it or link it to a part.</source>
        <translation>{file} ist eine Verknüpfung, die ins Leere führt: Entfernen Sie sie oder verknüpfen Sie sie mit einem Bauteil.</translation>
    </message>
    <message>
        <source>{file} is a link to a file that is missing, and was not changed: name the file itself.</source>
        <translation>{file} ist ein Verweis auf eine Datei, die fehlt, und wurde nicht geändert: die Datei selbst angeben.</translation>
    </message>
    <message>
        <source>{file} is a link to {target}, which is not an output of ThinPart and was not changed: name another file.</source>
        <translation>{file} ist ein Verweis auf {target}, das keine Ausgabe von ThinPart ist und nicht geändert wurde: eine andere Datei angeben.</translation>
    </message>
    <message>
        <source>{file} is a program: it was not opened.</source>
        <translation>{file} ist ein Programm und wurde nicht geöffnet.</translation>
    </message>
    <message>
        <source>{file} is an empty document.</source>
        <translation>{file} ist ein leeres Dokument.</translation>
    </message>
    <message>
        <source>{file} is an info file and was not changed: name another file.</source>
        <translation>{file} ist eine Infodatei und wurde nicht geändert: eine andere Datei angeben.</translation>
    </message>
    <message>
        <source>{file} is an input of this run and was not changed: name another file.</source>
        <translation>{file} wird in diesem Lauf gelesen und wurde nicht geändert: eine andere Datei angeben.</translation>
    </message>
    <message>
        <source>{file} is damaged or holds no shape.</source>
        <translation>{file} ist beschädigt oder enthält keine Form.</translation>
    </message>
    <message>
        <source>{file} is damaged or not a FreeCAD document ({problem}).</source>
        <translation>{file} ist beschädigt oder kein FreeCAD-Dokument ({problem}).</translation>
    </message>
    <message>
        <source>{file} is damaged or not what its ending says ({problem}).</source>
        <translation>{file} ist beschädigt oder nicht das, was die Dateiendung sagt ({problem}).</translation>
    </message>
    <message>
        <source>{file} is damaged, or its faces are not triangles: triangulate it first.</source>
        <translation>{file} ist beschädigt, oder die Flächen sind keine Dreiecke: Zerlegen Sie sie zuerst in Dreiecke.</translation>
    </message>
    <message>
        <source>{file} is empty (0 bytes).</source>
        <translation>{file} ist leer (0 Byte).</translation>
    </message>
    <message>
        <source>{file} is for one part, and there are {count}: name one after --part, as {example}.</source>
        <translation>{file} ist für ein Teil, und es gibt {count}: nennen Sie eines nach --part, etwa {example}.</translation>
    </message>
    <message>
        <source>{file} is named for two outputs: name another file for one of them.</source>
        <translation>{file} ist für zwei Ausgaben angegeben: für eine davon eine andere Datei angeben.</translation>
    </message>
    <message>
        <source>{file} is no file: name a CAD file with one part.</source>
        <translation>{file} ist keine Datei: Nennen Sie eine CAD-Datei mit einem Bauteil.</translation>
    </message>
    <message>
        <source>{file} is no name for a file of {option}: give it the ending .{ending}.</source>
        <translation>{file} ist kein Name für eine Datei von {option}: Geben Sie ihr die Endung .{ending}.</translation>
    </message>
    <message>
        <source>{file} is no name for a map: give it one of the endings {endings}.</source>
        <translation>{file} ist kein Name für eine Karte: Geben Sie ihr eine der Endungen {endings}.</translation>
    </message>
    <message>
        <source>{file} is no name for a script of Gmsh: give it the ending .geo.</source>
        <translation>{file} ist kein Name für ein Skript von Gmsh: geben Sie ihm die Endung .geo.</translation>
    </message>
    <message>
        <source>{file} is no name for a shell: give it one of the endings {endings}.</source>
        <translation>{file} ist kein Name für eine Schale: Geben Sie ihm eine der Endungen {endings}.</translation>
    </message>
    <message>
        <source>{file} is no profile and is not overwritten: write the new profile elsewhere.</source>
        <translation>{file} ist kein Profil und wird nicht überschrieben: Schreiben Sie das neue Profil an einen anderen Ort.</translation>
    </message>
    <message>
        <source>{file} is not a FreeCAD document.</source>
        <translation>{file} ist kein FreeCAD-Dokument.</translation>
    </message>
    <message>
        <source>{file} is truncated or not an STL file: its header says {announced} triangles, it holds {held}.</source>
        <translation>{file} ist abgeschnitten oder keine STL-Datei: Der Kopf nennt {announced} Dreiecke, enthalten sind {held}.</translation>
    </message>
    <message>
        <source>{file} is truncated: its end is missing.</source>
        <translation>{file} ist abgeschnitten: Das Ende fehlt.</translation>
    </message>
    <message>
        <source>{file} needs more memory than {megabytes} MB.</source>
        <translation>{file} braucht mehr als {megabytes} MB Speicher.</translation>
    </message>
    <message>
        <source>{file} took longer than {seconds:g} s, the limit for one file.</source>
        <translation>{file} dauerte länger als {seconds:g} s, das Zeitlimit für eine Datei.</translation>
    </message>
    <message>
        <source>{file} was not opened: it links to {links}, which is a pipe, a device or a socket, and FreeCAD would wait there for ever. Get it from a source that you trust.</source>
        <translation>{file} wurde nicht geöffnet: Es verweist auf {links}, eine Pipe, ein Gerät oder einen Socket, und FreeCAD würde dort endlos warten. Beziehen Sie es aus einer Quelle, der Sie vertrauen.</translation>
    </message>
    <message>
        <source>{file} was not opened: {problem}, so it would write outside its own folder or hide some of its content. Get it from a source that you trust.</source>
        <translation>{file} wurde nicht geöffnet: {problem}, so würde es außerhalb seines eigenen Ordners schreiben oder einen Teil seines Inhalts verbergen. Beziehen Sie es aus einer Quelle, der Sie vertrauen.</translation>
    </message>
    <message>
        <source>{file} was not written by ThinPart and was not changed: name another file, or allow it to be overwritten (--overwrite).</source>
        <translation>{file} wurde nicht von ThinPart geschrieben und nicht geändert: eine andere Datei angeben oder das Überschreiben erlauben (--overwrite).</translation>
    </message>
    <message>
        <source>{file} was not written. {reason}</source>
        <translation>{file} wurde nicht geschrieben. {reason}</translation>
    </message>
    <message>
        <source>{file} was saved again meanwhile: classify it again.</source>
        <translation>{file} wurde inzwischen neu gespeichert: Klassifizieren Sie die Datei erneut.</translation>
    </message>
    <message>
        <source>{file} was written by another program meanwhile and was not changed: name another file.</source>
        <translation>{file} wurde inzwischen von einem anderen Programm geschrieben und nicht geändert: eine andere Datei angeben.</translation>
    </message>
    <message>
        <source>{file} would have the name of a profile that comes with ThinPart: choose another.</source>
        <translation>{file} hätte den Namen eines Profils, das zu ThinPart gehört: Wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>{file}, line {line}</source>
        <translation>{file}, Zeile {line}</translation>
    </message>
    <message>
        <source>{file}, part {part}</source>
        <translation>{file}, Bauteil {part}</translation>
    </message>
    <message>
        <source>{first} and {second} exclude each other</source>
        <translation>{first} und {second} schließen sich aus</translation>
    </message>
    <message>
        <source>{first} to {last} of {count} parts</source>
        <translation>{first} bis {last} von {count} Teilen</translation>
    </message>
    <message>
        <source>{first} {next}</source>
        <translation>{first} {next}</translation>
    </message>
    <message>
        <source>{first}; {next}</source>
        <translation>{first}; {next}</translation>
    </message>
    <message>
        <source>{folder} already exists and is not the folder of a report: it was not changed; give a new or an empty folder.</source>
        <translation>{folder} gibt es schon und ist kein Berichtsordner: Der Ordner blieb unverändert; geben Sie einen neuen oder leeren an.</translation>
    </message>
    <message>
        <source>{folder} does not lie below {top}: name a folder after --info-tree that holds all PATHs.</source>
        <translation>{folder} liegt nicht unterhalb von {top}: Nennen Sie mit --info-tree einen Ordner, der alle PATHs enthält.</translation>
    </message>
    <message>
        <source>{info_file} has version {version}; this ThinPart reads version {known}: use a newer one.</source>
        <translation>{info_file} hat Version {version}; dieses ThinPart liest Version {known}: Verwenden Sie ein neueres.</translation>
    </message>
    <message>
        <source>{info_file} is not a ThinPart info file.</source>
        <translation>{info_file} ist keine Infodatei von ThinPart.</translation>
    </message>
    <message>
        <source>{info_file} is too large for an info file.</source>
        <translation>{info_file} ist zu groß für eine Infodatei.</translation>
    </message>
    <message>
        <source>{inside} of the {free} of free edges lie inside the material: there, walls do not meet, or go over into what is left solid. Close these gaps before solving.</source>
        <translation>{inside} der {free} freier Kanten liegen im Material: Dort treffen sich Wände nicht oder gehen in das über, was massiv bleibt. Schließen Sie diese Lücken vor dem Rechnen.</translation>
    </message>
    <message>
        <source>{length} ± {error:.2g}</source>
        <translation>{length} ± {error:.2g}</translation>
    </message>
    <message>
        <source>{link} was not opened: a link may lead to http:// or https://, or to a file of the library.</source>
        <translation>{link} wurde nicht geöffnet: Ein Link darf zu http:// oder https:// führen oder zu einer Datei der Bibliothek.</translation>
    </message>
    <message>
        <source>{low} to {high}</source>
        <translation>{low} bis {high}</translation>
    </message>
    <message>
        <source>{low} to {high}: {share}</source>
        <translation>{low} bis {high}: {share}</translation>
    </message>
    <message>
        <source>{number!r} in the condition {condition!r} is not a number.</source>
        <translation>{number!r} in der Bedingung {condition!r} ist keine Zahl.</translation>
    </message>
    <message>
        <source>{one} and {two}</source>
        <translation>{one} und {two}</translation>
    </message>
    <message>
        <source>{one}, {two} and {three}</source>
        <translation>{one}, {two} und {three}</translation>
    </message>
    <message>
        <source>{one}, {two}, {three} and {count} more</source>
        <translation>{one}, {two}, {three} und {count} weitere</translation>
    </message>
    <message>
        <source>{part} - wall thickness</source>
        <translation>{part} - Wandstärke</translation>
    </message>
    <message>
        <source>{part} belongs to another document, {file}: open that one, and prepare its mesh there.</source>
        <translation>{part} gehört zu einem anderen Dokument, {file}: Öffnen Sie dieses und bereiten Sie das Netz dort vor.</translation>
    </message>
    <message>
        <source>{part} has no shell, since it is not closed or was measured by pairs: close its gaps (Part workbench, Check geometry), or measure it by rays.</source>
        <translation>{part} hat keine Schale, da es nicht geschlossen ist oder paarweise gemessen wurde: Schließen Sie seine Lücken (Arbeitsbereich Part, Geometrie überprüfen), oder messen Sie es mit Strahlen.</translation>
    </message>
    <message>
        <source>{part} has no shell: its walls overlap, and would count for {share:.0f} % of its volume. Mesh it as a solid.</source>
        <translation>{part} hat keine Schale: Seine Wände überlappen sich und zählten für {share:.0f} % seines Volumens. Vernetzen Sie es als Volumen.</translation>
    </message>
    <message>
        <source>{part} has no shell: walls with a mid-surface have only {share:.0f} % of its volume. Mesh it as a solid.</source>
        <translation>{part} hat keine Schale: Wände mit einer Mittelfläche haben nur {share:.0f} % seines Volumens. Vernetzen Sie es als Volumen.</translation>
    </message>
    <message>
        <source>{part} has no {face}: names of faces are those of FreeCAD, such as Face1.</source>
        <translation>{part} hat keine {face}: Flächen heißen wie in FreeCAD, zum Beispiel Face1.</translation>
    </message>
    <message>
        <source>{part} is made of triangles, which are no solid to mesh.</source>
        <translation>{part} besteht aus Dreiecken, die kein Volumenkörper zum Vernetzen sind.</translation>
    </message>
    <message>
        <source>{part} is made of triangles, which have no mid-surface: use its STEP file, or mesh it as a solid.</source>
        <translation>{part} besteht aus Dreiecken, die keine Mittelfläche haben: Nehmen Sie seine STEP-Datei, oder vernetzen Sie es als Volumen.</translation>
    </message>
    <message>
        <source>{part} needs more than {megabytes} MB of memory: raise the limit in the preferences.</source>
        <translation>{part} braucht mehr als {megabytes} MB Speicher: Erhöhen Sie die Grenze in den Einstellungen.</translation>
    </message>
    <message>
        <source>{part}: {sentence}</source>
        <translation>{part}: {sentence}</translation>
    </message>
    <message>
        <source>{person!r} cannot be kept as a person's name: choose a shorter one, in one line.</source>
        <translation>{person!r} kann nicht als Name einer Person aufbewahrt werden: Wählen Sie einen kürzeren, in einer Zeile.</translation>
    </message>
    <message>
        <source>{person} calls it {category!r}, which is no category of the start: there are {known}</source>
        <translation>{person} nennt es {category!r}, was keine Kategorie des Ausgangsprofils ist: Es gibt {known}</translation>
    </message>
    <message>
        <source>{person} calls this part {category} here and {other} before ({earlier})</source>
        <translation>{person} nennt dieses Bauteil hier {category} und vorher {other} ({earlier})</translation>
    </message>
    <message>
        <source>{person} has labelled this part already ({earlier})</source>
        <translation>{person} hat dieses Bauteil schon eingeordnet ({earlier})</translation>
    </message>
    <message>
        <source>{person} is sure of {category} in one place and not in the other ({earlier})</source>
        <translation>{person} ist sich bei {category} an der einen Stelle sicher und an der anderen nicht ({earlier})</translation>
    </message>
    <message>
        <source>{place} is empty, and a criterion without conditions would always hold</source>
        <translation>{place} ist leer, und ein Kriterium ohne Bedingungen wäre immer erfüllt</translation>
    </message>
    <message>
        <source>{place} names {quantity!r}, which is no quantity: there are {known}, a below b</source>
        <translation>{place} nennt {quantity!r}; diese Größe gibt es nicht: Es gibt {known}, a kleiner als b</translation>
    </message>
    <message>
        <source>{place}: {reason}.</source>
        <translation>{place}: {reason}.</translation>
    </message>
    <message>
        <source>{problem} As a file it may have a shell all the same, without faces for supports: ./thinpart size FILE --shell shell.inp.</source>
        <translation>{problem} Als Datei kann es dennoch eine Schale haben, ohne Flächen für Lager: ./thinpart size DATEI --shell schale.inp.</translation>
    </message>
    <message>
        <source>{process} ({material})</source>
        <translation>{process} ({material})</translation>
    </message>
    <message>
        <source>{process}: all walls have limits of their own.</source>
        <translation>{process}: Alle Wände haben eigene Grenzen.</translation>
    </message>
    <message>
        <source>{process}: cannot be told: no wall could be measured.</source>
        <translation>{process}: nicht zu entscheiden: Es konnte keine Wand gemessen werden.</translation>
    </message>
    <message>
        <source>{process}: cannot be told: the surface is open, and there may be walls thinner than the {thinnest} that were found.</source>
        <translation>{process}: nicht zu entscheiden: Die Oberfläche ist offen, und es kann dünnere Wände geben als die gefundenen {thinnest}.</translation>
    </message>
    <message>
        <source>{process}: cannot be told: the thinnest wall is {thinnest}, give or take {error:.2g}, the limit is {least}.</source>
        <translation>{process}: nicht zu entscheiden: Die dünnste Wand misst {thinnest}, auf {error:.2g} genau, die Grenze ist {least}.</translation>
    </message>
    <message>
        <source>{process}: cannot be told: {share} of the surface lies over more than {most}, but a ray may run along a wall there: look at the thickness map.</source>
        <translation>{process}: nicht zu entscheiden: {share} der Oberfläche liegen über mehr als {most}, aber ein Strahl kann dort längs einer Wand laufen: Sehen Sie die Wandstärkenkarte an.</translation>
    </message>
    <message>
        <source>{process}: fails, but only where walls end in sharp edges: {findings}.</source>
        <translation>{process}: nicht bestanden, aber nur wo Wände in scharfen Kanten enden: {findings}.</translation>
    </message>
    <message>
        <source>{process}: fails: {faces} All other faces pass.</source>
        <translation>{process}: nicht bestanden: {faces} Alle anderen Flächen bestehen.</translation>
    </message>
    <message>
        <source>{process}: fails: {faces} Of all other faces it cannot be told.</source>
        <translation>{process}: nicht bestanden: {faces} Von allen anderen Flächen lässt es sich nicht sagen.</translation>
    </message>
    <message>
        <source>{process}: fails: {findings}.</source>
        <translation>{process}: durchgefallen: {findings}.</translation>
    </message>
    <message>
        <source>{process}: passes within tolerance: the thinnest wall is {thinnest}, give or take {error:.2g}, the limit is {least}.</source>
        <translation>{process}: bestanden im Rahmen der Genauigkeit: Die dünnste Wand misst {thinnest}, auf {error:.2g} genau, die Grenze ist {least}.</translation>
    </message>
    <message>
        <source>{process}: passes: no wall is over {most}.</source>
        <translation>{process}: bestanden: Keine Wand ist dicker als {most}.</translation>
    </message>
    <message>
        <source>{process}: passes: the thinnest wall is {thinnest}, the limit {least}.</source>
        <translation>{process}: bestanden: Die dünnste Wand misst {thinnest}, die Grenze ist {least}.</translation>
    </message>
    <message>
        <source>{process}: passes: the thinnest wall is {thinnest}, the limit {least}; towards their edges, tapered walls are thinner on {share} of the surface.</source>
        <translation>{process}: bestanden: Die dünnste Wand misst {thinnest}, die Grenze ist {least}; zu den Kanten hin sind verjüngte Wände auf {share} der Oberfläche dünner.</translation>
    </message>
    <message>
        <source>{process}: passes: walls from {thinnest} on, the limits are {least} and {most}.</source>
        <translation>{process}: bestanden: Wände ab {thinnest}, die Grenzen sind {least} und {most}.</translation>
    </message>
    <message>
        <source>{profile} cannot be used: {problem} ({place}).</source>
        <translation>{profile} ist nicht verwendbar: {problem} ({place}).</translation>
    </message>
    <message>
        <source>{profile} defines 'normal' or 'unknown', which are reserved: rename the category.</source>
        <translation>{profile} definiert „normal“ oder „unknown“, die reserviert sind: Benennen Sie die Kategorie um.</translation>
    </message>
    <message>
        <source>{profile} has version {version}; ThinPart reads version 1.</source>
        <translation>{profile} hat Version {version}; ThinPart liest Version 1.</translation>
    </message>
    <message>
        <source>{profile} has {count} conditions, more than {most}: leave some out.</source>
        <translation>{profile} hat {count} Bedingungen, mehr als {most}: Lassen Sie einige weg.</translation>
    </message>
    <message>
        <source>{profile} is not a ThinPart profile.</source>
        <translation>{profile} ist kein Profil von ThinPart.</translation>
    </message>
    <message>
        <source>{profile} is not well formed: {problem}.</source>
        <translation>{profile} ist nicht wohlgeformt: {problem}.</translation>
    </message>
    <message>
        <source>{profile} uses a criterion's id twice: {id!r}.</source>
        <translation>{profile} verwendet die Kennung eines Kriteriums zweimal: {id!r}.</translation>
    </message>
    <message>
        <source>{quantities} could not be measured, so criterion {criteria} cannot be decided.</source>
        <translation>{quantities} konnte nicht gemessen werden, daher lässt sich Kriterium {criteria} nicht entscheiden.</translation>
    </message>
    <message>
        <source>{quantity} = {value:.3g}</source>
        <translation>{quantity} = {value:.3g}</translation>
    </message>
    <message>
        <source>{said} So thin a place, {share} of the median of {median}, is often an error of the model: look at it.</source>
        <translation>{said} Eine so dünne Stelle, {share} des Medians von {median}, ist oft ein Fehler des Modells: Sehen Sie sie an.</translation>
    </message>
    <message>
        <source>{said} The thinnest wall that does not end in one is {walls}.</source>
        <translation>{said} Die dünnste Wand, die nicht in einer endet, ist {walls}.</translation>
    </message>
    <message>
        <source>{sentence} It was not changed.</source>
        <translation>{sentence} Sie blieb unverändert.</translation>
    </message>
    <message>
        <source>{sentence} It was not changed: move it away to have a new one written.</source>
        <translation>{sentence} Sie blieb unverändert: Verschieben Sie sie, damit sie neu geschrieben wird.</translation>
    </message>
    <message>
        <source>{share} and more</source>
        <translation>{share} und mehr</translation>
    </message>
    <message>
        <source>{share} of the surface is thin: {features}. Refine the mesh there.</source>
        <translation>{share} der Oberfläche sind dünn: {features}. Das Netz dort verfeinern.</translation>
    </message>
    <message>
        <source>{share} of the surface lies over walls of more than {most}</source>
        <translation>{share} der Oberfläche liegen über Wänden von mehr als {most}</translation>
    </message>
    <message>
        <source>{share} of the surface lies over walls thinner than {limit}, {part} of the width of {middle}</source>
        <translation>{share} der Oberfläche liegen über Wänden, die dünner als {limit} sind, {part} der Breite von {middle}</translation>
    </message>
    <message>
        <source>{share} of the surface lies over walls thinner than {limit}, {part} of the width of {middle}: consider shells (Prepare mesh says whether they can be made).</source>
        <translation>{share} der Oberfläche liegen über Wänden, die dünner als {limit} sind, {part} der Breite von {middle}: Schalenelemente erwägen (Netz vorbereiten sagt, ob sie möglich sind).</translation>
    </message>
    <message>
        <source>{share} of the surface lies over walls thinner than {limit}, {part} of the width of {middle}: refine the mesh there.</source>
        <translation>{share} der Oberfläche liegen über Wänden, die dünner als {limit} sind, {part} der Breite von {middle}: das Netz dort verfeinern.</translation>
    </message>
    <message>
        <source>{share} of the surface over walls of {least} to {most}, beside a thick body</source>
        <translation>{share} der Oberfläche über Wänden von {least} bis {most}, neben einem dicken Körper</translation>
    </message>
    <message>
        <source>{share} of the surface over walls thinner than {most}</source>
        <translation>{share} der Oberfläche über Wänden dünner als {most}</translation>
    </message>
    <message>
        <source>{thickness} and more</source>
        <translation>{thickness} und mehr</translation>
    </message>
    <message>
        <source>{thickness} plate, {share} of the surface</source>
        <translation>Platte von {thickness}, {share} der Oberfläche</translation>
    </message>
    <message>
        <source>{thickness} sheet, {share} of the surface</source>
        <translation>Blech von {thickness}, {share} der Oberfläche</translation>
    </message>
    <message>
        <source>{thickness} wall, {share} of the surface</source>
        <translation>Wand von {thickness}, {share} der Oberfläche</translation>
    </message>
    <message>
        <source>{thinnest}, give or take {error:.2g},</source>
        <translation>{thinnest}, auf {error:.2g} genau,</translation>
    </message>
    <message>
        <source>{thin} of the surface is under {least}, thinnest {place}</source>
        <translation>{thin} der Oberfläche sind unter {least}, am dünnsten {place}</translation>
    </message>
    <message>
        <source>{thin} of the surface is under {least}, thinnest {place}, and {thick} over {most}</source>
        <translation>{thin} der Oberfläche sind unter {least}, am dünnsten {place}, und {thick} über {most}</translation>
    </message>
    <message>
        <source>{title} (rule {number})</source>
        <translation>{title} (Regel {number})</translation>
    </message>
    <message>
        <source>{triangles} triangles, chord error {error}, {samples} samples</source>
        <translation>{triangles} Dreiecke, Sehnenfehler {error}, {samples} Messpunkte</translation>
    </message>
    <message>
        <source>{walls}: consider shells (Prepare mesh says whether they can be made).</source>
        <translation>{walls}: Schalenelemente erwägen (Netz vorbereiten sagt, ob sie möglich sind).</translation>
    </message>
    <message>
        <source>{wall} on {face}</source>
        <translation>{wall} auf {face}</translation>
    </message>
    <message>
        <source>{wall}, {depth:.2g} beside a sharp edge</source>
        <translation>{wall}, {depth:.2g} neben einer scharfen Kante</translation>
    </message>
    <message>
        <source>{wall}.</source>
        <translation>{wall}.</translation>
    </message>
    <message>
        <source>{wall}; sharp edges are {edges} long.</source>
        <translation>{wall}; scharfe Kanten sind {edges} lang.</translation>
    </message>
    <message>
        <source>{what} cannot be stored ({problem}).</source>
        <translation>{what} kann nicht gespeichert werden ({problem}).</translation>
    </message>
    <message>
        <source>{what} is not a JSON object ({problem}).</source>
        <translation>{what}: kein JSON-Objekt ({problem}).</translation>
    </message>
    <message>
        <source>{what} is not a JSON object.</source>
        <translation>{what}: kein JSON-Objekt.</translation>
    </message>
    <message>
        <source>{whose} holds 1 face beside its solids, which was left out: close or thicken it if it is a part.</source>
        <translation>{whose} enthält neben den Volumenkörpern 1 Fläche, die weggelassen wurde: Schließen Sie sie oder geben Sie ihr eine Wandstärke, wenn sie ein Bauteil ist.</translation>
    </message>
    <message>
        <source>{whose} holds 1 solid that is only a line, which was left out.</source>
        <translation>{whose} enthält 1 Körper, der nur eine Linie ist; er wurde ausgelassen.</translation>
    </message>
    <message>
        <source>{whose} holds {count} solids that are only a line, which were left out.</source>
        <translation>{whose} enthält {count} Körper, die nur eine Linie sind; sie wurden ausgelassen.</translation>
    </message>
    <message>
        <source>{whose} holds {faces} faces beside its solids, which were left out: close or thicken them if they are a part.</source>
        <translation>{whose} enthält neben den Volumenkörpern {faces} Flächen, die weggelassen wurden: Schließen Sie sie oder geben Sie ihnen eine Wandstärke, wenn sie ein Bauteil sind.</translation>
    </message>
    <message>
        <source>{x:.3g}, {y:.3g}, {z:.3g}</source>
        <translation>{x:.3g}; {y:.3g}; {z:.3g}</translation>
    </message>
</context>
<context>
    <name>ThinPart_Classify</name>
    <message>
        <source>Checks whether the selected part is thin, has thin features or is normal, and colours its thin faces</source>
        <translation>Prüft, ob das ausgewählte Bauteil dünnwandig ist, dünne Bereiche hat oder normal ist, und färbt seine dünnen Flächen ein</translation>
    </message>
    <message>
        <source>Classify part</source>
        <translation>Bauteil klassifizieren</translation>
    </message>
</context>
<context>
    <name>ThinPart_ClassifyFolder</name>
    <message>
        <source>Classifies all parts of a folder in the background and shows them in a table</source>
        <translation>Klassifiziert alle Bauteile eines Ordners im Hintergrund und zeigt sie in einer Tabelle</translation>
    </message>
    <message>
        <source>Classify folder…</source>
        <translation>Ordner klassifizieren…</translation>
    </message>
</context>
<context>
    <name>ThinPart_ClearColours</name>
    <message>
        <source>Clear thin colours</source>
        <translation>Dünnwandfarben entfernen</translation>
    </message>
    <message>
        <source>Restores the colours that the faces of this document had before they were coloured as thin</source>
        <translation>Stellt die Farben wieder her, die die Flächen dieses Dokuments vor dem Einfärben hatten</translation>
    </message>
</context>
<context>
    <name>ThinPart_EditProfile</name>
    <message>
        <source>Edit profile…</source>
        <translation>Profil bearbeiten …</translation>
    </message>
    <message>
        <source>Edits the thresholds by which parts are judged, and the limits of the wall, and counts meanwhile what would change in your libraries</source>
        <translation>Bearbeitet die Schwellenwerte, nach denen Bauteile beurteilt werden, und die Grenzen der Wandstärke, und zählt dabei, was sich in Ihren Bibliotheken ändern würde</translation>
    </message>
</context>
<context>
    <name>ThinPart_FindParts</name>
    <message>
        <source>Find parts</source>
        <translation>Bauteile finden</translation>
    </message>
    <message>
        <source>Shows or hides the panel that finds classified parts by their category, walls, size and notes, and parts like another one</source>
        <translation>Zeigt oder verbirgt das Fenster, das klassifizierte Bauteile nach Kategorie, Wänden, Größe und Notizen sowie ähnliche Bauteile findet</translation>
    </message>
</context>
<context>
    <name>ThinPart_Guide</name>
    <message>
        <source>Opens the guide: a page for each job, with pictures and examples</source>
        <translation>Öffnet den Leitfaden: eine Seite für jede Aufgabe, mit Bildern und Beispielen</translation>
    </message>
    <message>
        <source>ThinPart guide</source>
        <translation>ThinPart-Leitfaden</translation>
    </message>
</context>
<context>
    <name>ThinPart_LearnThresholds</name>
    <message>
        <source>Chooses thresholds that agree with what people say of the parts of a library, and says how good they are on folders left out</source>
        <translation>Wählt Schwellenwerte, die mit dem übereinstimmen, was Menschen über die Bauteile einer Bibliothek sagen, und sagt, wie gut sie an ausgelassenen Ordnern sind</translation>
    </message>
    <message>
        <source>Learn thresholds…</source>
        <translation>Schwellenwerte lernen…</translation>
    </message>
</context>
<context>
    <name>ThinPart_MeshSizes</name>
    <message>
        <source>Prepare mesh</source>
        <translation>Netz vorbereiten</translation>
    </message>
    <message>
        <source>Proposes element sizes that give the thin walls of the selected part enough layers, and makes a FEM mesh with them</source>
        <translation>Schlägt Elementgrößen vor, mit denen die dünnen Wände des gewählten Teils genug Schichten haben, und erzeugt damit ein FEM-Netz</translation>
    </message>
</context>
<context>
    <name>ThinPart_Preferences</name>
    <message>
        <source>Opens the preferences: thresholds, surface mesh, info files, colours and automatic classification</source>
        <translation>Öffnet die Einstellungen: Schwellenwerte, Oberflächennetz, Infodateien, Farben und automatische Klassifizierung</translation>
    </message>
    <message>
        <source>ThinPart preferences…</source>
        <translation>ThinPart-Einstellungen…</translation>
    </message>
</context>
<context>
    <name>ThinPart_Report</name>
    <message>
        <source>Report…</source>
        <translation>Bericht…</translation>
    </message>
    <message>
        <source>Writes a page with pictures, walls and criteria about every part of the document, to read, print or hand on</source>
        <translation>Schreibt zu jedem Bauteil des Dokuments eine Seite mit Bildern, Wänden und Kriterien, zum Lesen, Drucken oder Weitergeben</translation>
    </message>
</context>
<context>
    <name>ThinPart_ShowThickness</name>
    <message>
        <source>Colours the selected parts, or all of them, by the thickness of their walls, and shows how the area is distributed over thickness</source>
        <translation>Färbt die ausgewählten oder alle Bauteile nach der Wandstärke ein und zeigt, wie sich die Oberfläche auf die Wandstärken verteilt</translation>
    </message>
    <message>
        <source>Show thickness</source>
        <translation>Wandstärke anzeigen</translation>
    </message>
</context>
</TS>
