<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>Colours from thin to thick</source>
        <translation>Farben von dünn nach dick</translation>
    </message>
    <message>
        <source>Number of steps; 0: smooth</source>
        <translation>Anzahl der Stufen; 0: stufenlos</translation>
    </message>
    <message>
        <source>Of the facets, in percent</source>
        <translation>Der Facetten, in Prozent</translation>
    </message>
    <message>
        <source>Of the largest part's box, mm</source>
        <translation>Des Hüllquaders des größten Bauteils, mm</translation>
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
        <source>The opposite sides of those</source>
        <translation>Deren gegenüberliegende Seiten</translation>
    </message>
    <message>
        <source>The place on the face, in the coordinates of its object</source>
        <translation>Die Stelle auf der Fläche, in den Koordinaten ihres Objekts</translation>
    </message>
    <message>
        <source>The place on the opposite side, in the coordinates of the document</source>
        <translation>Die Stelle auf der gegenüberliegenden Seite, in den Koordinaten des Dokuments</translation>
    </message>
    <message>
        <source>The sources' shapes when measured</source>
        <translation>Die Formen der Quellen bei der Messung</translation>
    </message>
    <message>
        <source>The thickness of the material under that place</source>
        <translation>Die Dicke des Materials unter dieser Stelle</translation>
    </message>
    <message>
        <source>The thickness there, mm</source>
        <translation>Die Wandstärke dort, mm</translation>
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
        <source>Unit of Low and High</source>
        <translation>Einheit von Low und High</translation>
    </message>
    <message>
        <source>Walls under it are thin, mm</source>
        <translation>Wände darunter sind dünn, mm</translation>
    </message>
    <message>
        <source>What was measured</source>
        <translation>Was gemessen wurde</translation>
    </message>
    <message>
        <source>Where nothing was measured</source>
        <translation>Wo nichts gemessen wurde</translation>
    </message>
    <message>
        <source>Where the sources stood when measured</source>
        <translation>Lage der Quellen bei der Messung</translation>
    </message>
    <message>
        <source>Where thickness was asked for</source>
        <translation>Wo nach der Wandstärke gefragt wurde</translation>
    </message>
    <message>
        <source>Whether colours run from the thinnest to the thickest wall</source>
        <translation>Ob die Farben von der dünnsten bis zur dicksten Wand reichen</translation>
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
        <source>&amp;Browse…</source>
        <translation>&amp;Durchsuchen…</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Abbre&amp;chen</translation>
    </message>
    <message>
        <source>&amp;Export CSV…</source>
        <translation>CSV e&amp;xportieren…</translation>
    </message>
    <message>
        <source>&amp;Fly to thinnest place</source>
        <translation>Zur dünn&amp;sten Stelle</translation>
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
        <source>&amp;Install {}</source>
        <translation>{} &amp;installieren</translation>
    </message>
    <message>
        <source>&amp;Measure again</source>
        <translation>Erne&amp;ut messen</translation>
    </message>
    <message>
        <source>&amp;Measure again what has not changed</source>
        <translation>&amp;Unverändertes neu messen</translation>
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
        <source>&amp;Pause</source>
        <translation>&amp;Pausieren</translation>
    </message>
    <message>
        <source>&amp;Probe</source>
        <translation>&amp;Messpunkt</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>&amp;Retry failed</source>
        <translation>&amp;Fehlgeschlagene wiederholen</translation>
    </message>
    <message>
        <source>&amp;Save the document</source>
        <translation>Dokument &amp;speichern</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>&amp;Starten</translation>
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
        <source>'{}' has no parts any more that could be measured.</source>
        <translation>„{}“ hat keine Bauteile mehr, die gemessen werden könnten.</translation>
    </message>
    <message>
        <source>'{}' was not classified yet: classify the part first.</source>
        <translation>„{}“ wurde noch nicht klassifiziert: Klassifizieren Sie zuerst das Bauteil.</translation>
    </message>
    <message>
        <source>1 probe was removed: the surface is no longer where it was.</source>
        <translation>1 Messpunkt wurde entfernt: Die Oberfläche ist nicht mehr dort, wo er war.</translation>
    </message>
    <message>
        <source>A folder for the info files, in which the folders of the documents are repeated; it may lie on another computer. Empty: beside each document</source>
        <translation>Ein Ordner für die Infodateien, in dem die Ordner der Dokumente nachgebildet werden; er darf auf einem anderen Rechner liegen. Leer: neben jedem Dokument</translation>
    </message>
    <message>
        <source>A link to {} was put into {}.</source>
        <translation>In {1} wurde eine Verknüpfung zu {0} eingefügt.</translation>
    </message>
    <message>
        <source>Add a folder with classified parts under 'Libraries'.</source>
        <translation>Fügen Sie unter „Bibliotheken“ einen Ordner mit klassifizierten Bauteilen hinzu.</translation>
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
        <source>All parts</source>
        <translation>Alle Bauteile</translation>
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
        <source>Automatic</source>
        <translation>Automatik</translation>
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
        <source>Bounding box {}</source>
        <translation>Hüllquader {}</translation>
    </message>
    <message>
        <source>Box, {}</source>
        <translation>Quader, {}</translation>
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
        <source>Cancelled. Nothing was changed.</source>
        <translation>Abgebrochen. Nichts wurde geändert.</translation>
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
        <source>Check before meshing whether a part is thin, and where</source>
        <translation>Vor dem Vernetzen prüfen, ob ein Bauteil dünnwandig ist und wo</translation>
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
        <source>Choose a part in the list to see its faces.</source>
        <translation>Wählen Sie ein Bauteil in der Liste, um seine Flächen zu sehen.</translation>
    </message>
    <message>
        <source>Choose at least one format.</source>
        <translation>Wählen Sie mindestens ein Format.</translation>
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
        <source>Click to take this away.</source>
        <translation>Klicken Sie, um diese Meldung zu entfernen.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
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
        <source>Colours</source>
        <translation>Farben</translation>
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
        <source>Continue in the background? 'Classify folder' shows it again. What is done so far is kept either way.</source>
        <translation>Im Hintergrund fortsetzen? „Ordner klassifizieren“ zeigt es wieder an. Was bisher erledigt ist, bleibt in jedem Fall erhalten.</translation>
    </message>
    <message>
        <source>Copy path</source>
        <translation>Pfad kopieren</translation>
    </message>
    <message>
        <source>Criteria</source>
        <translation>Kriterien</translation>
    </message>
    <message>
        <source>Criteria that hold (none chosen: any)</source>
        <translation>Erfüllte Kriterien (keines gewählt: beliebig)</translation>
    </message>
    <message>
        <source>Criterion {}: {}. All its conditions hold: {}.</source>
        <translation>Kriterium {}: {}. Alle Bedingungen erfüllt: {}.</translation>
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
        <source>E&amp;xcept</source>
        <translation>&amp;Außer</translation>
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
        <source>Export the rows that are shown</source>
        <translation>Angezeigte Zeilen exportieren</translation>
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
        <source>Files of a folder that are measured at once</source>
        <translation>Dateien eines Ordners, die gleichzeitig gemessen werden</translation>
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
        <source>Folder</source>
        <translation>Ordner</translation>
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
        <source>FreeCAD shows one task at a time: close the one that is open, then try again.</source>
        <translation>FreeCAD zeigt immer nur eine Aufgabe: Schließen Sie die geöffnete und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>FreeCAD's Python has no pip, so {} was not installed: install it into {} by another Python's 'pip install --target'.</source>
        <translation>FreeCADs Python hat kein pip, deshalb wurde {} nicht installiert: Installieren Sie es mit „pip install --target“ eines anderen Python nach {}.</translation>
    </message>
    <message>
        <source>From file…</source>
        <translation>Aus Datei…</translation>
    </message>
    <message>
        <source>From the thinnest to the thickest wall</source>
        <translation>Von der dünnsten bis zur dicksten Wand</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weiterlaufen lassen</translation>
    </message>
    <message>
        <source>Half of the face lies over thinner walls</source>
        <translation>Die Hälfte der Fläche liegt über dünneren Wänden</translation>
    </message>
    <message>
        <source>Heat map of the thickness</source>
        <translation>Farbkarte der Wandstärke</translation>
    </message>
    <message>
        <source>Here: {}</source>
        <translation>Hier: {}</translation>
    </message>
    <message>
        <source>Holds</source>
        <translation>Erfüllt</translation>
    </message>
    <message>
        <source>How far the mesh may lie from the surface, as a share of the part's diagonal; where walls are thin it is made finer anyway</source>
        <translation>Wie weit das Netz von der Oberfläche abweichen darf, als Anteil der Diagonale des Bauteils; an dünnen Wänden wird es ohnehin feiner</translation>
    </message>
    <message>
        <source>How often the part stands in the document</source>
        <translation>Wie oft das Bauteil im Dokument vorkommt</translation>
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
        <source>Installing {}…</source>
        <translation>{} wird installiert …</translation>
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
        <source>It is folders that could not be searched: see to them and start again.</source>
        <translation>Fehlgeschlagen sind Ordner, die nicht durchsucht werden konnten: Beheben Sie das und starten Sie erneut.</translation>
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
        <source>Limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Linear deflection</source>
        <translation>Lineare Abweichung</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Verknüpfung</translation>
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
        <source>MB</source>
        <translation>MB</translation>
    </message>
    <message>
        <source>Made by</source>
        <translation>Erzeugt von</translation>
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
        <source>Measuring and drawing…</source>
        <translation>Messen und Zeichnen…</translation>
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
        <source>Median, {}</source>
        <translation>Median, {}</translation>
    </message>
    <message>
        <source>Memory per file</source>
        <translation>Speicher pro Datei</translation>
    </message>
    <message>
        <source>Memory that measuring one document may take</source>
        <translation>Speicher, den das Messen eines Dokuments belegen darf</translation>
    </message>
    <message>
        <source>Mesh settings</source>
        <translation>Netzeinstellungen</translation>
    </message>
    <message>
        <source>Meshes</source>
        <translation>Netze</translation>
    </message>
    <message>
        <source>Move over the part; a click pins the wall there.</source>
        <translation>Bewegen Sie den Zeiger über das Bauteil; ein Klick setzt dort einen Messpunkt.</translation>
    </message>
    <message>
        <source>No criterion holds: its walls are thick all over.</source>
        <translation>Kein Kriterium ist erfüllt: Die Wände sind überall dick.</translation>
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
        <source>No program opens {} here.</source>
        <translation>Hier öffnet kein Programm {}.</translation>
    </message>
    <message>
        <source>No program shows folders here; it is {}.</source>
        <translation>Hier zeigt kein Programm Ordner an; er heißt {}.</translation>
    </message>
    <message>
        <source>No program shows folders here; the info file is {}.</source>
        <translation>Hier zeigt kein Programm Ordner an; die Infodatei ist {}.</translation>
    </message>
    <message>
        <source>No wall could be measured.</source>
        <translation>Es konnte keine Wand gemessen werden.</translation>
    </message>
    <message>
        <source>No wall was measured here.</source>
        <translation>Hier wurde keine Wand gemessen.</translation>
    </message>
    <message>
        <source>Normal part</source>
        <translation>Normales Bauteil</translation>
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
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>Nothing can be written into {}: choose another folder for the info files.</source>
        <translation>In {} kann nichts geschrieben werden: Wählen Sie einen anderen Ordner für die Infodateien.</translation>
    </message>
    <message>
        <source>Nothing was written to {}: give the table a name that ends with .csv.</source>
        <translation>In {} wurde nichts geschrieben: Geben Sie der Tabelle einen Namen, der auf .csv endet.</translation>
    </message>
    <message>
        <source>On every save</source>
        <translation>Bei jedem Speichern</translation>
    </message>
    <message>
        <source>Only borderline</source>
        <translation>Nur Grenzfälle</translation>
    </message>
    <message>
        <source>Only failures</source>
        <translation>Nur Fehlgeschlagene</translation>
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
        <source>Out of date: recompute</source>
        <translation>Veraltet: neu berechnen</translation>
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
        <source>Pin thickness</source>
        <translation>Messpunkt setzen</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
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
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Reclassify</source>
        <translation>Neu klassifizieren</translation>
    </message>
    <message>
        <source>Refresh</source>
        <translation>Aktualisieren</translation>
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
        <source>Remove thickness</source>
        <translation>Messpunkt entfernen</translation>
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
        <source>Reports need the Python package {}, which this FreeCAD does not have: install it from the internet into {}?</source>
        <translation>Berichte brauchen das Python-Paket {}, das diesem FreeCAD fehlt: aus dem Internet nach {} installieren?</translation>
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
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save and write info file</source>
        <translation>Speichern und Infodatei schreiben</translation>
    </message>
    <message>
        <source>Saved.</source>
        <translation>Gespeichert.</translation>
    </message>
    <message>
        <source>Select a part in the list.</source>
        <translation>Wählen Sie ein Bauteil in der Liste.</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>Share of the face over walls under the threshold</source>
        <translation>Anteil der Fläche über Wänden unter dem Schwellenwert</translation>
    </message>
    <message>
        <source>Share of the face where no wall could be measured</source>
        <translation>Anteil der Fläche, wo keine Wand gemessen werden konnte</translation>
    </message>
    <message>
        <source>Share of the part's diagonal under which a wall is coloured as thin</source>
        <translation>Anteil der Diagonale des Bauteils, unter dem eine Wand als dünn eingefärbt wird</translation>
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
        <source>Show thickness</source>
        <translation>Wandstärke anzeigen</translation>
    </message>
    <message>
        <source>Shown as thin: below {}, as the preferences say. The verdict does not depend on it.</source>
        <translation>Als dünn angezeigt: unter {}, wie eingestellt. Das Ergebnis hängt nicht davon ab.</translation>
    </message>
    <message>
        <source>Shows the defaults of this page; they are kept with OK or Apply</source>
        <translation>Zeigt die Standardwerte dieser Seite; sie werden mit OK oder Anwenden übernommen</translation>
    </message>
    <message>
        <source>Shows the wall under the cursor; a click pins it</source>
        <translation>Zeigt die Wandstärke unter dem Zeiger; ein Klick setzt einen Messpunkt</translation>
    </message>
    <message>
        <source>Similar size</source>
        <translation>Ähnliche Größe</translation>
    </message>
    <message>
        <source>Starting to measure {}</source>
        <translation>Messung von {} beginnt</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Stopped after {} of {} info files.</source>
        <translation>Nach {} von {} Infodateien abgebrochen.</translation>
    </message>
    <message>
        <source>Stopped before the end, as asked.</source>
        <translation>Wie gewünscht vorzeitig abgebrochen.</translation>
    </message>
    <message>
        <source>Stopped: {} of {} info files are up to date.</source>
        <translation>Abgebrochen: {} von {} Infodateien sind aktuell.</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>Wird abgebrochen…</translation>
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
        <source>The active document as it was saved. Click to classify it in the panel.</source>
        <translation>Das aktive Dokument, wie es gespeichert ist. Klicken Sie, um es im Aufgabenbereich zu klassifizieren.</translation>
    </message>
    <message>
        <source>The content of {} was copied into {}, which has no file to link from yet.</source>
        <translation>Der Inhalt von {} wurde in {} kopiert, das noch keine Datei hat, von der aus verknüpft werden könnte.</translation>
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
        <source>The document has changes that are not saved. Save the document first.</source>
        <translation>Das Dokument hat ungespeicherte Änderungen. Speichern Sie es zuerst.</translation>
    </message>
    <message>
        <source>The document has never been saved. Save the document first.</source>
        <translation>Das Dokument wurde noch nie gespeichert. Speichern Sie es zuerst.</translation>
    </message>
    <message>
        <source>The document is closed: open it again for a report about it.</source>
        <translation>Das Dokument ist geschlossen: Öffnen Sie es wieder, um darüber zu berichten.</translation>
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
        <source>The folder with your parts; the folders in it count as well</source>
        <translation>Der Ordner mit Ihren Bauteilen, einschließlich seiner Unterordner</translation>
    </message>
    <message>
        <source>The folder {} for Python packages cannot be made ({}): {} was not installed.</source>
        <translation>Der Ordner {} für Python-Pakete kann nicht angelegt werden ({}): {} wurde nicht installiert.</translation>
    </message>
    <message>
        <source>The folder {} has not answered for {} s: connect it, or choose another one for the info files.</source>
        <translation>Der Ordner {} antwortet seit {} s nicht: Verbinden Sie ihn oder wählen Sie einen anderen für die Infodateien.</translation>
    </message>
    <message>
        <source>The info file {} is damaged ({}): classify its document again.</source>
        <translation>Die Infodatei {} ist beschädigt ({}): Klassifizieren Sie ihr Dokument erneut.</translation>
    </message>
    <message>
        <source>The process that classifies could not be started.</source>
        <translation>Der Prozess, der klassifiziert, konnte nicht gestartet werden.</translation>
    </message>
    <message>
        <source>The process that classifies ended unexpectedly; what was done is kept. Start again for the rest; the report view has its last words.</source>
        <translation>Der Prozess, der klassifiziert, wurde unerwartet beendet; was erledigt ist, bleibt erhalten. Starten Sie erneut für den Rest; seine letzten Meldungen stehen im Ausgabefenster.</translation>
    </message>
    <message>
        <source>The process that does this could not be started.</source>
        <translation>Der Prozess dafür konnte nicht gestartet werden.</translation>
    </message>
    <message>
        <source>The process that does this ended unexpectedly.</source>
        <translation>Der Prozess dafür wurde unerwartet beendet.</translation>
    </message>
    <message>
        <source>The process that does this ended unexpectedly; the report view has its last words. Refresh the libraries to go on.</source>
        <translation>Der Prozess dafür wurde unerwartet beendet; seine letzten Meldungen stehen im Ausgabefenster. Aktualisieren Sie die Bibliotheken, um fortzufahren.</translation>
    </message>
    <message>
        <source>The process that installs could not be started.</source>
        <translation>Der Prozess, der installiert, konnte nicht gestartet werden.</translation>
    </message>
    <message>
        <source>The process that measures could not be started.</source>
        <translation>Der Messprozess konnte nicht gestartet werden.</translation>
    </message>
    <message>
        <source>The process that measures ended unexpectedly; the document is unharmed. Check the part with 'Check geometry' of the Part workbench.</source>
        <translation>Der Messprozess wurde unerwartet beendet; das Dokument ist unbeschädigt. Prüfen Sie das Bauteil mit „Geometrie prüfen“ des Arbeitsbereichs Part.</translation>
    </message>
    <message>
        <source>The report is in {}.</source>
        <translation>Der Bericht liegt in {}.</translation>
    </message>
    <message>
        <source>The same may happen to FreeCAD when it opens the file: save your documents first. Open it nevertheless?</source>
        <translation>Dasselbe kann mit FreeCAD geschehen, wenn es die Datei öffnet: Speichern Sie zuerst Ihre Dokumente. Trotzdem öffnen?</translation>
    </message>
    <message>
        <source>The table {} could not be written ({}): choose another place for it.</source>
        <translation>Die Tabelle {} konnte nicht geschrieben werden ({}): Wählen Sie einen anderen Ort dafür.</translation>
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
        <source>There is no Python {} beside FreeCAD to measure with: install it.</source>
        <translation>Neben FreeCAD gibt es kein Python {}, mit dem gemessen werden kann: Installieren Sie es.</translation>
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
        <source>There is no file {} any more.</source>
        <translation>Die Datei {} gibt es nicht mehr.</translation>
    </message>
    <message>
        <source>There is no folder {} any more.</source>
        <translation>Den Ordner {} gibt es nicht mehr.</translation>
    </message>
    <message>
        <source>There is no folder {}: choose another one.</source>
        <translation>Den Ordner {} gibt es nicht: Wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>There is no folder {}: make it first, or choose another one for the info files.</source>
        <translation>Den Ordner {} gibt es nicht: Legen Sie ihn zuerst an oder wählen Sie einen anderen für die Infodateien.</translation>
    </message>
    <message>
        <source>There is no room for temporary files ({}): nothing was classified.</source>
        <translation>Es ist kein Platz für temporäre Dateien ({}): Nichts wurde klassifiziert.</translation>
    </message>
    <message>
        <source>There is no room for temporary files ({}): nothing was measured.</source>
        <translation>Es ist kein Platz für temporäre Dateien ({}): Nichts wurde gemessen.</translation>
    </message>
    <message>
        <source>There is no room for the thickness map ({}): nothing was changed.</source>
        <translation>Für die Wandstärkenkarte ist kein Platz ({}): Es wurde nichts geändert.</translation>
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
        <source>Thickness under which a wall is coloured as thin</source>
        <translation>Wandstärke, unter der eine Wand als dünn eingefärbt wird</translation>
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
        <source>ThinPart is there twice: {} is used, {} is not. Remove one of them.</source>
        <translation>ThinPart ist zweimal da: {} wird benutzt, {} nicht. Entfernen Sie eines davon.</translation>
    </message>
    <message>
        <source>ThinPart: {}</source>
        <translation>ThinPart: {}</translation>
    </message>
    <message>
        <source>Thinnest wall</source>
        <translation>Dünnste Wand</translation>
    </message>
    <message>
        <source>Thinnest wall under the face</source>
        <translation>Dünnste Wand unter der Fläche</translation>
    </message>
    <message>
        <source>Thinnest wall {} (± {})</source>
        <translation>Dünnste Wand {} (± {})</translation>
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
        <source>This did not work, for a reason that was not foreseen ({}): try again, and if it happens again, report it with FreeCAD's log.</source>
        <translation>Das ging aus einem nicht vorgesehenen Grund nicht ({}): Versuchen Sie es noch einmal, und melden Sie es mit FreeCADs Protokoll, wenn es wieder geschieht.</translation>
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
        <source>Time per file</source>
        <translation>Zeit pro Datei</translation>
    </message>
    <message>
        <source>Time that one file of a folder, or a document that is classified automatically, may take</source>
        <translation>Zeit, die eine Datei eines Ordners oder ein automatisch klassifiziertes Dokument brauchen darf</translation>
    </message>
    <message>
        <source>To classify a part, open a document and close the task that is open.</source>
        <translation>Um ein Bauteil zu klassifizieren, öffnen Sie ein Dokument und schließen Sie die offene Aufgabe.</translation>
    </message>
    <message>
        <source>Under which thickness a wall is coloured as thin; the verdict does not depend on it</source>
        <translation>Unter welcher Wandstärke eine Wand als dünn eingefärbt wird; das Ergebnis hängt nicht davon ab</translation>
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
        <source>Walls that are shown as thin</source>
        <translation>Wände, die als dünn angezeigt werden</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Warnungen</translation>
    </message>
    <message>
        <source>What is under no wall that could be measured, in the heat map</source>
        <translation>Was in der Farbkarte ohne messbare Wand ist</translation>
    </message>
    <message>
        <source>What was measured, notes, mesh settings and links stay as they are. Write them now?</source>
        <translation>Messwerte, Notizen, Netzeinstellungen und Verknüpfungen bleiben unverändert. Jetzt schreiben?</translation>
    </message>
    <message>
        <source>When a wall is under</source>
        <translation>Wenn eine Wand dünner ist als</translation>
    </message>
    <message>
        <source>When the category of a part changes</source>
        <translation>Wenn sich die Kategorie eines Bauteils ändert</translation>
    </message>
    <message>
        <source>When the thinnest wall of a part falls under this thickness, or is under it in a part that was not classified before</source>
        <translation>Wenn die dünnste Wand eines Bauteils unter diese Stärke fällt oder bei einem bisher nicht klassifizierten Bauteil darunter liegt</translation>
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
        <source>Why: {}</source>
        <translation>Grund: {}</translation>
    </message>
    <message>
        <source>Words in names, paths, notes, links</source>
        <translation>Wörter in Namen, Pfaden, Notizen, Verknüpfungen</translation>
    </message>
    <message>
        <source>Write…</source>
        <translation>Schreiben…</translation>
    </message>
    <message>
        <source>Writing the info file…</source>
        <translation>Infodatei wird geschrieben…</translation>
    </message>
    <message>
        <source>a file, or a JSON object</source>
        <translation>eine Datei oder ein JSON-Objekt</translation>
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
        <source>all, or such as: bracket*; *_v2*</source>
        <translation>alle, oder z. B.: halter*; *_v2*</translation>
    </message>
    <message>
        <source>an address or a folder</source>
        <translation>eine Adresse oder ein Ordner</translation>
    </message>
    <message>
        <source>and {} more parts</source>
        <translation>und {} weitere Bauteile</translation>
    </message>
    <message>
        <source>area over walls thinner than this share of the diagonal</source>
        <translation>Oberfläche über Wänden, dünner als dieser Anteil der Diagonale</translation>
    </message>
    <message>
        <source>beside each document</source>
        <translation>neben jedem Dokument</translation>
    </message>
    <message>
        <source>cancelled: what was done is kept, Start does the rest</source>
        <translation>abgebrochen: Erledigtes bleibt erhalten, „Starten“ macht den Rest</translation>
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
        <source>measuring…</source>
        <translation>wird gemessen…</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
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
        <source>not classified</source>
        <translation>nicht klassifiziert</translation>
    </message>
    <message>
        <source>not finished</source>
        <translation>nicht abgeschlossen</translation>
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
        <source>paused</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>pausing</source>
        <translation>wird angehalten</translation>
    </message>
    <message>
        <source>pip could not install {}; the report view has its words.</source>
        <translation>pip konnte {} nicht installieren; seine Meldungen stehen im Ausgabefenster.</translation>
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
        <source>smooth</source>
        <translation>stufenlos</translation>
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
        <source>there is no importer for such files</source>
        <translation>für solche Dateien gibt es keinen Import</translation>
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
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>wedge {:g}–{:g}°</source>
        <translation>Keil {:g}–{:g}°</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>{} (borderline)</source>
        <translation>{} (Grenzfall)</translation>
    </message>
    <message>
        <source>{} (rule {})</source>
        <translation>„{}“ (Regel {})</translation>
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
        <source>{} There are {} more failures.</source>
        <translation>{} Es gibt {} weitere Fehler.</translation>
    </message>
    <message>
        <source>{} and more: {} of the area</source>
        <translation>{} und mehr: {} der Oberfläche</translation>
    </message>
    <message>
        <source>{} different parts, {} instances</source>
        <translation>{} verschiedene Bauteile, {} Instanzen</translation>
    </message>
    <message>
        <source>{} failed</source>
        <translation>{} fehlgeschlagen</translation>
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
        <source>{} holds {} too, which was taken off the list.</source>
        <translation>{} enthält auch {}; dieser Ordner wurde aus der Liste genommen.</translation>
    </message>
    <message>
        <source>{} info files were left as they are: {}</source>
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
        <source>{} min</source>
        <translation>{} min</translation>
    </message>
    <message>
        <source>{} of the area lies over walls thinner than {}</source>
        <translation>{} der Oberfläche liegen über Wänden dünner als {}</translation>
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
        <source>{} of {} parts change their category; {} info files would be updated.</source>
        <translation>{} von {} Bauteilen wechseln ihre Kategorie; {} Infodateien würden aktualisiert.</translation>
    </message>
    <message>
        <source>{} probes were removed: the surface is no longer where they were.</source>
        <translation>{} Messpunkte wurden entfernt: Die Oberfläche ist nicht mehr dort, wo sie waren.</translation>
    </message>
    <message>
        <source>{} s</source>
        <translation>{} s</translation>
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
        <source>{} was not found in the index of Python packages: connect this computer to the internet, or set up pip's proxy, and try again.</source>
        <translation>{} wurde im Verzeichnis der Python-Pakete nicht gefunden: Verbinden Sie diesen Computer mit dem Internet oder richten Sie den Proxy von pip ein, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>{}, and share of the diagonal</source>
        <translation>{} und Anteil der Diagonale</translation>
    </message>
    <message>
        <source>{}: '{}' ({}) has a wall of {}, under the limit of {}.</source>
        <translation>{}: „{}“ ({}) hat eine Wand von {}, unter der Grenze von {}.</translation>
    </message>
    <message>
        <source>{}: '{}' was '{}' and is '{}' now; its thinnest wall is {}.</source>
        <translation>{}: „{}“ war „{}“ und ist jetzt „{}“; die dünnste Wand hat {}.</translation>
    </message>
    <message>
        <source>{}: '{}' was '{}' and is '{}' now; its thinnest wall of {} is under the limit of {}.</source>
        <translation>{}: „{}“ war „{}“ und ist jetzt „{}“; die dünnste Wand von {} liegt unter der Grenze von {}.</translation>
    </message>
    <message>
        <source>{}: '{}' was '{}' and is '{}' now; none of its walls could be measured.</source>
        <translation>{}: „{}“ war „{}“ und ist jetzt „{}“; keine der Wände konnte gemessen werden.</translation>
    </message>
    <message>
        <source>{}: looking for info files, {} so far</source>
        <translation>{}: Infodateien werden gesucht, bisher {}</translation>
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
</context>
<context>
    <name>ThinPartCore</name>
    <message>
        <source>'{}' has an empty shape: recompute the document or delete it.</source>
        <translation>„{}“ hat eine leere Form: Berechnen Sie das Dokument neu oder löschen Sie das Objekt.</translation>
    </message>
    <message>
        <source>'{}' has no shape, because its last recompute failed ({}): repair it and recompute the document.</source>
        <translation>„{}“ hat keine Form, weil die letzte Neuberechnung fehlgeschlagen ist ({}): Reparieren Sie das Objekt und berechnen Sie das Dokument neu.</translation>
    </message>
    <message>
        <source>'{}' has no shape, because the last recompute of '{}' failed ({}): repair it and recompute the document.</source>
        <translation>„{}“ hat keine Form, weil die letzte Neuberechnung von „{}“ fehlgeschlagen ist ({}): Reparieren Sie das Objekt und berechnen Sie das Dokument neu.</translation>
    </message>
    <message>
        <source>'{}' is a closed shell but no solid: convert it to a solid first.</source>
        <translation>„{}“ ist eine geschlossene Schale, aber kein Volumenkörper: Wandeln Sie sie zuerst in einen Volumenkörper um.</translation>
    </message>
    <message>
        <source>'{}' is a mesh without triangles: import it again or delete it.</source>
        <translation>„{}“ ist ein Netz ohne Dreiecke: Importieren Sie es erneut oder löschen Sie es.</translation>
    </message>
    <message>
        <source>'{}' is made of surfaces that bound no solid: close or thicken it first.</source>
        <translation>„{}“ besteht aus Flächen, die keinen Volumenkörper begrenzen: Schließen Sie sie zuerst oder geben Sie ihnen eine Wandstärke.</translation>
    </message>
    <message>
        <source>A bulky part with thin places: refine the mesh there or remove them.</source>
        <translation>Ein massiges Bauteil mit dünnen Stellen: Verfeinern Sie dort das Netz oder entfernen Sie sie.</translation>
    </message>
    <message>
        <source>All its triangles have zero area.</source>
        <translation>Alle Dreiecke haben den Flächeninhalt null.</translation>
    </message>
    <message>
        <source>All points lie in one place.</source>
        <translation>Alle Punkte liegen an einer Stelle.</translation>
    </message>
    <message>
        <source>Area of its surface</source>
        <translation>Flächeninhalt der Oberfläche</translation>
    </message>
    <message>
        <source>Diagonal of the bounding box</source>
        <translation>Diagonale des Hüllquaders</translation>
    </message>
    <message>
        <source>Faces that meet in a thin wedge</source>
        <translation>Flächen bilden einen dünnen Keil</translation>
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
        <source>FreeCAD cannot be imported by {} ({}): install it (Debian: 'apt-get install freecad') or set FREECAD_LIB to the folder with its FreeCAD.so or FreeCAD.pyd.</source>
        <translation>FreeCAD kann von {} nicht importiert werden ({}): Installieren Sie es (Debian: „apt-get install freecad“) oder setzen Sie FREECAD_LIB auf den Ordner mit seiner FreeCAD.so oder FreeCAD.pyd.</translation>
    </message>
    <message>
        <source>FreeCAD cannot open {} ({}).</source>
        <translation>FreeCAD kann {} nicht öffnen ({}).</translation>
    </message>
    <message>
        <source>FreeCAD cannot read {} ({}).</source>
        <translation>FreeCAD kann {} nicht lesen ({}).</translation>
    </message>
    <message>
        <source>FreeCAD could not tessellate any of its faces.</source>
        <translation>FreeCAD konnte keine der Flächen tessellieren.</translation>
    </message>
    <message>
        <source>FreeCAD could not tessellate it ({}).</source>
        <translation>FreeCAD konnte das Bauteil nicht tessellieren ({}).</translation>
    </message>
    <message>
        <source>FreeCAD could not tessellate {} and {} more.</source>
        <translation>FreeCAD konnte {} und {} weitere nicht tessellieren.</translation>
    </message>
    <message>
        <source>FreeCAD could not tessellate {}.</source>
        <translation>FreeCAD konnte {} nicht tessellieren.</translation>
    </message>
    <message>
        <source>FreeCAD did not say which triangle belongs to which face.</source>
        <translation>FreeCAD gab nicht an, welches Dreieck zu welcher Fläche gehört.</translation>
    </message>
    <message>
        <source>FreeCAD follows no links from a document whose path is no UTF-8 text or has a backslash: rename {} or the folder that it lies in.</source>
        <translation>FreeCAD folgt keinen Verknüpfungen aus einem Dokument, dessen Pfad kein UTF-8-Text ist oder einen umgekehrten Schrägstrich enthält: Benennen Sie {} oder seinen Ordner um.</translation>
    </message>
    <message>
        <source>Giannini et al. 2012</source>
        <translation>Giannini u. a. 2012</translation>
    </message>
    <message>
        <source>Info files cannot be written into {} ({}): give another folder to --info-dir.</source>
        <translation>In {} können keine Infodateien geschrieben werden ({}): Wählen Sie einen anderen Ordner dafür (--info-dir).</translation>
    </message>
    <message>
        <source>It came as {} loose faces, which were sewn together.</source>
        <translation>Es lag als {} lose Flächen vor, die zusammengenäht wurden.</translation>
    </message>
    <message>
        <source>It holds no triangles.</source>
        <translation>Es enthält keine Dreiecke.</translation>
    </message>
    <message>
        <source>Its bounding box is empty or not finite.</source>
        <translation>Der Hüllquader ist leer oder nicht endlich.</translation>
    </message>
    <message>
        <source>Its surface encloses no volume.</source>
        <translation>Die Oberfläche umschließt kein Volumen.</translation>
    </message>
    <message>
        <source>Least distance, in diagonals, between walls at a to b degrees</source>
        <translation>Kleinster Abstand, in Diagonalen, zwischen Wänden im Winkel von a bis b Grad</translation>
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
        <source>Middle side of the bounding box</source>
        <translation>Mittlere Seite des Hüllquaders</translation>
    </message>
    <message>
        <source>Middle to shortest side of the bounding box</source>
        <translation>Mittlere zu kürzester Seite des Hüllquaders</translation>
    </message>
    <message>
        <source>No report can be written into {} ({}): give another folder.</source>
        <translation>In {} kann kein Bericht geschrieben werden ({}): Geben Sie einen anderen Ordner an.</translation>
    </message>
    <message>
        <source>Nothing was measured that could be written.</source>
        <translation>Es wurde nichts gemessen, was geschrieben werden könnte.</translation>
    </message>
    <message>
        <source>Part with thin features</source>
        <translation>Bauteil mit dünnen Bereichen</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Platte</translation>
    </message>
    <message>
        <source>Reports need the Python package Jinja2 ({}): install it (Debian: 'apt-get install python3-jinja2', elsewhere: 'python -m pip install Jinja2').</source>
        <translation>Berichte brauchen das Python-Paket Jinja2 ({}): Installieren Sie es (Debian: „apt-get install python3-jinja2“, sonst: „python -m pip install Jinja2“).</translation>
    </message>
    <message>
        <source>Share of the area over non-parallel walls</source>
        <translation>Anteil der Oberfläche über nicht parallelen Wänden</translation>
    </message>
    <message>
        <source>Share of the area over parallel walls</source>
        <translation>Anteil der Oberfläche über parallelen Wänden</translation>
    </message>
    <message>
        <source>Share of the area over walls of a thickness from a to b diagonals</source>
        <translation>Anteil der Oberfläche über Wänden mit einer Stärke von a bis b Diagonalen</translation>
    </message>
    <message>
        <source>Share of the area whose ray met nothing at all</source>
        <translation>Anteil der Oberfläche, deren Strahl auf nichts traf</translation>
    </message>
    <message>
        <source>Share of the area with no wall opposite</source>
        <translation>Anteil der Oberfläche ohne Wand gegenüber</translation>
    </message>
    <message>
        <source>Share of the bounding box that the part fills</source>
        <translation>Anteil des Hüllquaders, den das Bauteil ausfüllt</translation>
    </message>
    <message>
        <source>Shortest side of the bounding box</source>
        <translation>Kürzeste Seite des Hüllquaders</translation>
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
        <source>Stopped before the end, as asked.</source>
        <translation>Wie gewünscht vorzeitig abgebrochen.</translation>
    </message>
    <message>
        <source>The Python module {} is missing: install it to have documents classified automatically (Debian: python3-{}).</source>
        <translation>Das Python-Modul {} fehlt: Installieren Sie es, damit Dokumente automatisch klassifiziert werden (Debian: python3-{}).</translation>
    </message>
    <message>
        <source>The condition {} is not understood: write a quantity, one of {} and a number, as in 'D2/D3 &gt; 6'.</source>
        <translation>Die Bedingung {} ist nicht verständlich: Schreiben Sie eine Größe, eines der Zeichen {} und eine Zahl, wie in „D2/D3 &gt; 6“.</translation>
    </message>
    <message>
        <source>The document '{}' is empty: make or import a solid first.</source>
        <translation>Das Dokument „{}“ ist leer: Erstellen oder importieren Sie zuerst einen Volumenkörper.</translation>
    </message>
    <message>
        <source>The document names Python modules that are not FreeCAD's ({}): they were not loaded, and objects that need them may lack their shape.</source>
        <translation>Das Dokument nennt Python-Module, die nicht zu FreeCAD gehören ({}): Sie wurden nicht geladen, und Objekten, die sie brauchen, kann ihre Form fehlen.</translation>
    </message>
    <message>
        <source>The document's folder has not answered for {} s: connect it, or choose a folder for info files in the preferences.</source>
        <translation>Der Ordner des Dokuments antwortet seit {} s nicht: Verbinden Sie ihn oder wählen Sie in den Einstellungen einen Ordner für Infodateien.</translation>
    </message>
    <message>
        <source>The file</source>
        <translation>Die Datei</translation>
    </message>
    <message>
        <source>The file {}</source>
        <translation>Die Datei {}</translation>
    </message>
    <message>
        <source>The file {} cannot be read ({}).</source>
        <translation>Die Datei {} kann nicht gelesen werden ({}).</translation>
    </message>
    <message>
        <source>The folder for info files {} cannot be reached ({}): connect it, or choose another one in the preferences.</source>
        <translation>Der Ordner {} für Infodateien ist nicht erreichbar ({}): Verbinden Sie ihn oder wählen Sie in den Einstellungen einen anderen.</translation>
    </message>
    <message>
        <source>The folder for info files {} has not answered for {} s: connect it, or choose another one in the preferences.</source>
        <translation>Der Ordner {} für Infodateien antwortet seit {} s nicht: Verbinden Sie ihn oder wählen Sie in den Einstellungen einen anderen.</translation>
    </message>
    <message>
        <source>The folder {} cannot be listed ({}): what is known of it is from earlier.</source>
        <translation>Der Ordner {} kann nicht aufgelistet werden ({}): Was von ihm bekannt ist, stammt von früher.</translation>
    </message>
    <message>
        <source>The folder {} cannot be listed ({}): what lies in it is left as it is.</source>
        <translation>Der Ordner {} kann nicht aufgelistet werden ({}): Was darin liegt, bleibt unverändert.</translation>
    </message>
    <message>
        <source>The folder {} cannot be reached ({}).</source>
        <translation>Der Ordner {} ist nicht erreichbar ({}).</translation>
    </message>
    <message>
        <source>The folder {} could not be searched to its end ({}): classify it again when it can be reached.</source>
        <translation>Der Ordner {} konnte nicht vollständig durchsucht werden ({}): Klassifizieren Sie ihn erneut, wenn er erreichbar ist.</translation>
    </message>
    <message>
        <source>The folder {} may not be searched: check its permissions.</source>
        <translation>Der Ordner {} darf nicht durchsucht werden: Prüfen Sie seine Zugriffsrechte.</translation>
    </message>
    <message>
        <source>The home folder {} may not be used, which FreeCAD needs: set FREECAD_USER_HOME to a folder that may.</source>
        <translation>Der Benutzerordner {}, den FreeCAD braucht, darf nicht benutzt werden: Setzen Sie FREECAD_USER_HOME auf einen Ordner, für den das gilt.</translation>
    </message>
    <message>
        <source>The info file {} belongs to {} and was left as it is: choose another folder for the info file of {}.</source>
        <translation>Die Infodatei {} gehört zu {} und blieb unverändert: Wählen Sie einen anderen Ordner für die Infodatei von {}.</translation>
    </message>
    <message>
        <source>The info file {} cannot be read ({}).</source>
        <translation>Die Infodatei {} kann nicht gelesen werden ({}).</translation>
    </message>
    <message>
        <source>The info file {} could not be written ({}): make room or choose another place for it.</source>
        <translation>Die Infodatei {} konnte nicht geschrieben werden ({}): Schaffen Sie Platz oder wählen Sie einen anderen Ort dafür.</translation>
    </message>
    <message>
        <source>The info file {} is damaged ({}: {}): classify its document again.</source>
        <translation>Die Infodatei {} ist beschädigt ({}: {}): Klassifizieren Sie ihr Dokument erneut.</translation>
    </message>
    <message>
        <source>The info file {} lacks {}.</source>
        <translation>In der Infodatei {} fehlt {}.</translation>
    </message>
    <message>
        <source>The library {} cannot be read ({}).</source>
        <translation>Die Bibliothek {} kann nicht gelesen werden ({}).</translation>
    </message>
    <message>
        <source>The link '{}' leads to '{}' in {}, which cannot be found: put the file back or set the linked object again.</source>
        <translation>Die Verknüpfung „{}“ führt zu „{}“ in {}, das nicht gefunden wird: Legen Sie die Datei zurück oder setzen Sie das verknüpfte Objekt neu.</translation>
    </message>
    <message>
        <source>The link '{}' leads to nothing: set its linked object again or delete it.</source>
        <translation>Die Verknüpfung „{}“ führt ins Leere: Setzen Sie ihr verknüpftes Objekt neu oder löschen Sie sie.</translation>
    </message>
    <message>
        <source>The list {} cannot be read ({}): give a file to --only that names the parts.</source>
        <translation>Die Liste {} kann nicht gelesen werden ({}): Geben Sie mit --only eine Datei an, die die Bauteile nennt.</translation>
    </message>
    <message>
        <source>The list {} names {}, which does not lie below {}: name a PATH that holds it, or leave out --info-dir.</source>
        <translation>Die Liste {} nennt {}, das nicht unterhalb von {} liegt: Nennen Sie einen PATH, der es enthält, oder lassen Sie --info-dir weg.</translation>
    </message>
    <message>
        <source>The list {} names {}, which is no absolute path: write whole paths, each ended by a NUL byte.</source>
        <translation>Die Liste {} nennt {}, was kein absoluter Pfad ist: Schreiben Sie ganze Pfade, jeden mit einem NUL-Byte beendet.</translation>
    </message>
    <message>
        <source>The mesh settings</source>
        <translation>Die Netzeinstellungen</translation>
    </message>
    <message>
        <source>The name is too long for an info file, which is called the same and {}: it may have {} bytes and has {}; rename it, or use --no-info.</source>
        <translation>Der Name ist zu lang für eine Infodatei, die genauso und zusätzlich {} heißt: Er darf {} Byte haben und hat {}; benennen Sie die Datei um oder verwenden Sie --no-info.</translation>
    </message>
    <message>
        <source>The overview of the report could not be written into {} ({}): make room for it, and start again.</source>
        <translation>Die Übersicht des Berichts konnte nicht in {} geschrieben werden ({}): Schaffen Sie Platz dafür und starten Sie erneut.</translation>
    </message>
    <message>
        <source>The page {} could not be written ({}): make room, or give another folder for the report.</source>
        <translation>Die Seite {} konnte nicht geschrieben werden ({}): Schaffen Sie Platz oder geben Sie einen anderen Ordner für den Bericht an.</translation>
    </message>
    <message>
        <source>The part as a whole is thin: consider a shell mesh or a mid-surface.</source>
        <translation>Das Bauteil ist insgesamt dünnwandig: Ein Schalennetz oder eine Mittelfläche kommt in Betracht.</translation>
    </message>
    <message>
        <source>The part is {} mm across: check that the file's unit is millimetres.</source>
        <translation>Das Bauteil misst {} mm in der Diagonale: Prüfen Sie, ob die Einheit der Datei Millimeter ist.</translation>
    </message>
    <message>
        <source>The parts lie on several drives: name those of one drive at a time.</source>
        <translation>Die Bauteile liegen auf mehreren Laufwerken: Nennen Sie jeweils nur die eines Laufwerks.</translation>
    </message>
    <message>
        <source>The profile {} cannot be read ({}).</source>
        <translation>Das Profil {} kann nicht gelesen werden ({}).</translation>
    </message>
    <message>
        <source>The search index {} cannot be kept ({}): it was built in memory, and the next search has to build it again.</source>
        <translation>Der Suchindex {} kann nicht gespeichert werden ({}): Er wurde im Speicher aufgebaut, und die nächste Suche muss ihn neu aufbauen.</translation>
    </message>
    <message>
        <source>The surface is open ({} free edges), so it has no certain volume.</source>
        <translation>Die Oberfläche ist offen ({} freie Kanten), daher ist das Volumen nicht sicher.</translation>
    </message>
    <message>
        <source>The surface passes through itself, as under ({}): repair it, its thickness and volume are not certain.</source>
        <translation>Die Oberfläche durchdringt sich selbst, so unter ({}): Reparieren Sie sie, Wandstärke und Volumen sind nicht sicher.</translation>
    </message>
    <message>
        <source>The surface was inside-out and has been turned round.</source>
        <translation>Die Oberfläche war nach innen gekehrt und wurde umgedreht.</translation>
    </message>
    <message>
        <source>The table {} cannot be written ({}): give another file to --csv.</source>
        <translation>Die Tabelle {} kann nicht geschrieben werden ({}): Geben Sie mit --csv eine andere Datei an.</translation>
    </message>
    <message>
        <source>The thickness map {} cannot be read: measure the part again.</source>
        <translation>Die Wandstärkenkarte {} kann nicht gelesen werden: Messen Sie das Bauteil erneut.</translation>
    </message>
    <message>
        <source>The thickness map {} is of a newer ThinPart: update ThinPart or measure the part again.</source>
        <translation>Die Wandstärkenkarte {} stammt von einem neueren ThinPart: Aktualisieren Sie ThinPart oder messen Sie das Bauteil erneut.</translation>
    </message>
    <message>
        <source>The thinnest wall, {} mm, is known no better than the mesh resolves ({} mm).</source>
        <translation>Die dünnste Wand, {} mm, ist nicht genauer bekannt, als das Netz auflöst ({} mm).</translation>
    </message>
    <message>
        <source>The triangles are not consistently oriented, so it has no certain volume.</source>
        <translation>Die Dreiecke sind nicht einheitlich orientiert, daher ist das Volumen nicht sicher.</translation>
    </message>
    <message>
        <source>The worker processes end as soon as they start: try a larger --memory, or fewer --jobs.</source>
        <translation>Die Arbeitsprozesse enden, sobald sie starten: Versuchen Sie es mit mehr Speicher (--memory) oder weniger Dateien gleichzeitig (--jobs).</translation>
    </message>
    <message>
        <source>The {} cannot be {}: it may be {} to {} {}.</source>
        <translation>{}: {} ist nicht erlaubt, nur {} bis {} {}.</translation>
    </message>
    <message>
        <source>There are no parts in {}: name a CAD file or a folder that holds some.</source>
        <translation>In {} gibt es keine Bauteile: Nennen Sie eine CAD-Datei oder einen Ordner, der welche enthält.</translation>
    </message>
    <message>
        <source>There is no box {}: use minimal or principal.</source>
        <translation>Den Quader {} gibt es nicht: Verwenden Sie minimal oder principal.</translation>
    </message>
    <message>
        <source>There is no closed solid in '{}': select a solid, a body, or a face of one.</source>
        <translation>In „{}“ gibt es keinen geschlossenen Volumenkörper: Wählen Sie einen Volumenkörper, einen Körper oder eine Fläche davon.</translation>
    </message>
    <message>
        <source>There is no closed solid in the document '{}': make or import a solid first.</source>
        <translation>Im Dokument „{}“ gibt es keinen geschlossenen Volumenkörper: Erstellen oder importieren Sie zuerst einen.</translation>
    </message>
    <message>
        <source>There is no file {} any more.</source>
        <translation>Die Datei {} gibt es nicht mehr.</translation>
    </message>
    <message>
        <source>There is no file {}.</source>
        <translation>Die Datei {} gibt es nicht.</translation>
    </message>
    <message>
        <source>There is no file {}: --mesh takes a JSON object or a file.</source>
        <translation>Die Datei {} gibt es nicht: Netzeinstellungen sind ein JSON-Objekt oder eine Datei.</translation>
    </message>
    <message>
        <source>There is no folder {} any more: bring it back, or remove it from the list.</source>
        <translation>Den Ordner {} gibt es nicht mehr: Stellen Sie ihn wieder her oder entfernen Sie ihn aus der Liste.</translation>
    </message>
    <message>
        <source>There is no home folder</source>
        <translation>Es gibt keinen Benutzerordner</translation>
    </message>
    <message>
        <source>There is no info file {}: classify {} first, or name the folder of its info file with --info-dir.</source>
        <translation>Die Infodatei {} gibt es nicht: Klassifizieren Sie zuerst {} oder nennen Sie mit --info-dir den Ordner der Infodatei.</translation>
    </message>
    <message>
        <source>There is no measure {}: use rays or pairs.</source>
        <translation>Das Messverfahren {} gibt es nicht: Verwenden Sie rays oder pairs.</translation>
    </message>
    <message>
        <source>There is no place for temporary files ({}): make room, or name another folder in TMPDIR.</source>
        <translation>Für temporäre Dateien ist kein Platz ({}): Schaffen Sie Platz oder nennen Sie in TMPDIR einen anderen Ordner.</translation>
    </message>
    <message>
        <source>There is no profile {}: give a file or one of {}.</source>
        <translation>Das Profil {} gibt es nicht: Geben Sie eine Datei oder eines von {} an.</translation>
    </message>
    <message>
        <source>There is no quantity {} in the condition {}: there are {}.</source>
        <translation>Die Größe {} in der Bedingung {} gibt es nicht: Es gibt {}.</translation>
    </message>
    <message>
        <source>Thin part</source>
        <translation>Dünnwandiges Bauteil</translation>
    </message>
    <message>
        <source>Thin walls over most of its surface</source>
        <translation>Überwiegend dünne Wände</translation>
    </message>
    <message>
        <source>Thinner wall beside a thick body</source>
        <translation>Dünnere Wand neben dickem Körper</translation>
    </message>
    <message>
        <source>This may be an older shape of '{}', because its last recompute failed ({}): repair it and recompute the document.</source>
        <translation>Dies ist möglicherweise eine ältere Form von „{}“, weil die letzte Neuberechnung fehlgeschlagen ist ({}): Reparieren Sie das Objekt und berechnen Sie das Dokument neu.</translation>
    </message>
    <message>
        <source>This may be an older shape of '{}', because the last recompute of '{}', which it is made with, failed ({}): repair it and recompute the document.</source>
        <translation>Dies ist möglicherweise eine ältere Form von „{}“, weil die letzte Neuberechnung von „{}“, woraus es entsteht, fehlgeschlagen ist ({}): Reparieren Sie das Objekt und berechnen Sie das Dokument neu.</translation>
    </message>
    <message>
        <source>Very thin wall on a filled part</source>
        <translation>Sehr dünne Wand an massivem Bauteil</translation>
    </message>
    <message>
        <source>Volume of the part</source>
        <translation>Volumen des Bauteils</translation>
    </message>
    <message>
        <source>Wall thickness</source>
        <translation>Wandstärke</translation>
    </message>
    <message>
        <source>a criterion without conditions would always hold</source>
        <translation>ein Kriterium ohne Bedingungen wäre immer erfüllt</translation>
    </message>
    <message>
        <source>a threshold must be finite</source>
        <translation>ein Schwellenwert muss endlich sein</translation>
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
        <source>an entry is called '{}'</source>
        <translation>ein Eintrag heißt „{}“</translation>
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
        <source>an unforeseen failure</source>
        <translation>ein unvorhergesehener Fehler</translation>
    </message>
    <message>
        <source>angular deflection</source>
        <translation>Winkelabweichung</translation>
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
        <source>comparison {} is neither &lt; nor &gt;</source>
        <translation>der Vergleich {} ist weder &lt; noch &gt;</translation>
    </message>
    <message>
        <source>coordinates are not numbers</source>
        <translation>Koordinaten sind keine Zahlen</translation>
    </message>
    <message>
        <source>different wall distribution</source>
        <translation>andere Wandverteilung</translation>
    </message>
    <message>
        <source>far fewer slanted walls</source>
        <translation>viel weniger schräge Wände</translation>
    </message>
    <message>
        <source>far more slanted walls</source>
        <translation>viel mehr schräge Wände</translation>
    </message>
    <message>
        <source>fewer slanted walls</source>
        <translation>weniger schräge Wände</translation>
    </message>
    <message>
        <source>fill not comparable</source>
        <translation>Füllung nicht vergleichbar</translation>
    </message>
    <message>
        <source>flatter box</source>
        <translation>flacherer Quader</translation>
    </message>
    <message>
        <source>it is a file</source>
        <translation>es ist eine Datei</translation>
    </message>
    <message>
        <source>it is no regular file</source>
        <translation>es ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>it stores a file as '{}'</source>
        <translation>es legt eine Datei als „{}“ ab</translation>
    </message>
    <message>
        <source>it stores a resource as '{}'</source>
        <translation>es legt eine Ressource als „{}“ ab</translation>
    </message>
    <message>
        <source>its {} declares entities of its own</source>
        <translation>seine {} deklariert eigene Entitäten</translation>
    </message>
    <message>
        <source>its {} would be larger than {} GB</source>
        <translation>seine {} wäre größer als {} GB</translation>
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
        <source>linear deflection</source>
        <translation>Lineare Abweichung</translation>
    </message>
    <message>
        <source>longer box</source>
        <translation>längerer Quader</translation>
    </message>
    <message>
        <source>more filled</source>
        <translation>stärker gefüllt</translation>
    </message>
    <message>
        <source>more slanted walls</source>
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
        <source>no reason given</source>
        <translation>kein Grund angegeben</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>of the diagonal</source>
        <translation>der Diagonale</translation>
    </message>
    <message>
        <source>same fill</source>
        <translation>gleiche Füllung</translation>
    </message>
    <message>
        <source>same wall distribution</source>
        <translation>gleiche Wandverteilung</translation>
    </message>
    <message>
        <source>share of the diagonal</source>
        <translation>Anteil der Diagonale</translation>
    </message>
    <message>
        <source>shorter box</source>
        <translation>kürzerer Quader</translation>
    </message>
    <message>
        <source>similar wall distribution</source>
        <translation>ähnliche Wandverteilung</translation>
    </message>
    <message>
        <source>stopped as asked</source>
        <translation>wie gewünscht abgebrochen</translation>
    </message>
    <message>
        <source>the cluster cannot be used</source>
        <translation>der Cluster ist nicht verwendbar</translation>
    </message>
    <message>
        <source>the command was called wrongly</source>
        <translation>der Befehl wurde falsch aufgerufen</translation>
    </message>
    <message>
        <source>the file is damaged or not what its name says</source>
        <translation>die Datei ist beschädigt oder nicht das, was ihr Name sagt</translation>
    </message>
    <message>
        <source>the file may not be read</source>
        <translation>die Datei darf nicht gelesen werden</translation>
    </message>
    <message>
        <source>the file or document holds nothing</source>
        <translation>die Datei oder das Dokument ist leer</translation>
    </message>
    <message>
        <source>the file would write where it must not</source>
        <translation>die Datei würde schreiben, wo sie nicht darf</translation>
    </message>
    <message>
        <source>the format cannot be read here</source>
        <translation>das Format kann hier nicht gelesen werden</translation>
    </message>
    <message>
        <source>the info file could not be written</source>
        <translation>die Infodatei konnte nicht geschrieben werden</translation>
    </message>
    <message>
        <source>the memory limit was reached</source>
        <translation>die Speichergrenze wurde erreicht</translation>
    </message>
    <message>
        <source>the part encloses no volume</source>
        <translation>das Bauteil umschließt kein Volumen</translation>
    </message>
    <message>
        <source>the part has gone from the index since it was found</source>
        <translation>das Bauteil ist nicht mehr im Index</translation>
    </message>
    <message>
        <source>the pool broke down</source>
        <translation>die Arbeitsprozesse sind ausgefallen</translation>
    </message>
    <message>
        <source>the pool takes no tasks any more</source>
        <translation>die Arbeitsprozesse nehmen keine Aufgaben mehr an</translation>
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
        <source>the reading process died</source>
        <translation>der lesende Prozess ist abgestürzt</translation>
    </message>
    <message>
        <source>the time limit was reached</source>
        <translation>das Zeitlimit wurde erreicht</translation>
    </message>
    <message>
        <source>there is no closed solid in it</source>
        <translation>es ist kein geschlossener Volumenkörper darin</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>two entries are called '{}'</source>
        <translation>zwei Einträge heißen „{}“</translation>
    </message>
    <message>
        <source>unknown kind of failure: {}</source>
        <translation>unbekannte Art von Fehler: {}</translation>
    </message>
    <message>
        <source>{} It was left as it is: move it away to have it written anew.</source>
        <translation>{} Sie blieb unverändert: Verschieben Sie sie, damit sie neu geschrieben wird.</translation>
    </message>
    <message>
        <source>{} bytes after its last entry belong to none</source>
        <translation>{} Bytes nach dem letzten Eintrag gehören zu keinem</translation>
    </message>
    <message>
        <source>{} bytes that belong to no entry lie before '{}'</source>
        <translation>{} Bytes, die zu keinem Eintrag gehören, liegen vor „{}“</translation>
    </message>
    <message>
        <source>{} cannot be read ({}).</source>
        <translation>{} kann nicht gelesen werden ({}).</translation>
    </message>
    <message>
        <source>{} changed while it was read: classify it again.</source>
        <translation>{} hat sich während des Lesens geändert: Klassifizieren Sie die Datei erneut.</translation>
    </message>
    <message>
        <source>{} could not be measured, so criterion {} cannot be told.</source>
        <translation>{} konnte nicht gemessen werden, daher lässt sich Kriterium {} nicht entscheiden.</translation>
    </message>
    <message>
        <source>{} defines 'normal' or 'unknown', which stand for themselves.</source>
        <translation>{} definiert „normal“ oder „unknown“, die für sich selbst stehen.</translation>
    </message>
    <message>
        <source>{} does not lie below {}: name a folder after --info-tree that holds all PATHs.</source>
        <translation>{} liegt nicht unterhalb von {}: Nennen Sie mit --info-tree einen Ordner, der alle PATHs enthält.</translation>
    </message>
    <message>
        <source>{} duplicate triangles were left out.</source>
        <translation>{} doppelte Dreiecke wurden weggelassen.</translation>
    </message>
    <message>
        <source>{} ended the process that read it: the file is likely damaged.</source>
        <translation>{} hat den lesenden Prozess zum Absturz gebracht: Die Datei ist wahrscheinlich beschädigt.</translation>
    </message>
    <message>
        <source>{} failed ({}).</source>
        <translation>{} ist fehlgeschlagen ({}).</translation>
    </message>
    <message>
        <source>{} failed ({}: {}).</source>
        <translation>{} ist fehlgeschlagen ({}: {}).</translation>
    </message>
    <message>
        <source>{} has coordinates that are not finite numbers: export it again.</source>
        <translation>{} hat Koordinaten, die keine endlichen Zahlen sind: Exportieren Sie die Datei erneut.</translation>
    </message>
    <message>
        <source>{} has faces with more than four corners, which FreeCAD leaves out: triangulate it first.</source>
        <translation>{} hat Flächen mit mehr als vier Ecken, die FreeCAD weglässt: Zerlegen Sie sie zuerst in Dreiecke.</translation>
    </message>
    <message>
        <source>{} has no ending that ThinPart reads ({}).</source>
        <translation>{} hat keine Dateiendung, die ThinPart liest ({}).</translation>
    </message>
    <message>
        <source>{} has no part {}: it has {}.</source>
        <translation>{} hat kein Bauteil {}: Vorhanden sind {}.</translation>
    </message>
    <message>
        <source>{} has version {}; this ThinPart reads version {}: use a newer one.</source>
        <translation>{} hat Version {}; dieses ThinPart liest Version {}: Verwenden Sie ein neueres.</translation>
    </message>
    <message>
        <source>{} has version {}; this reads version 1.</source>
        <translation>{} hat Version {}; gelesen wird Version 1.</translation>
    </message>
    <message>
        <source>{} holds 1 face beside its solids, which was left out: close or thicken it if it is a part.</source>
        <translation>{} enthält neben den Volumenkörpern 1 Fläche, die weggelassen wurde: Schließen Sie sie oder geben Sie ihr eine Wandstärke, wenn sie ein Bauteil ist.</translation>
    </message>
    <message>
        <source>{} holds no closed solid, only surfaces, wires or points: close or thicken it first.</source>
        <translation>{} enthält keinen geschlossenen Volumenkörper, nur Flächen, Kanten oder Punkte: Schließen Sie die Flächen zuerst oder geben Sie ihnen eine Wandstärke.</translation>
    </message>
    <message>
        <source>{} holds {} faces beside its solids, which were left out: close or thicken them if they are a part.</source>
        <translation>{} enthält neben den Volumenkörpern {} Flächen, die weggelassen wurden: Schließen Sie sie oder geben Sie ihnen eine Wandstärke, wenn sie ein Bauteil sind.</translation>
    </message>
    <message>
        <source>{} holds {} parts: say which one is meant with --part, by name or label: {}.</source>
        <translation>{} enthält {} Bauteile: Geben Sie mit --part an, welches gemeint ist, mit Name oder Bezeichnung: {}.</translation>
    </message>
    <message>
        <source>{} in the condition {} is not a number.</source>
        <translation>{} in der Bedingung {} ist keine Zahl.</translation>
    </message>
    <message>
        <source>{} is a link that leads back to itself: remove it or link it to a part.</source>
        <translation>{} ist eine Verknüpfung, die auf sich selbst führt: Entfernen Sie sie oder verknüpfen Sie sie mit einem Bauteil.</translation>
    </message>
    <message>
        <source>{} is a link that leads nowhere: remove it or link it to a part.</source>
        <translation>{} ist eine Verknüpfung, die ins Leere führt: Entfernen Sie sie oder verknüpfen Sie sie mit einem Bauteil.</translation>
    </message>
    <message>
        <source>{} is a part, not a table, and was left as it is: name a .csv file after --csv.</source>
        <translation>{} ist ein Bauteil und keine Tabelle und blieb unverändert: Nennen Sie nach --csv eine .csv-Datei.</translation>
    </message>
    <message>
        <source>{} is an empty document.</source>
        <translation>{} ist ein leeres Dokument.</translation>
    </message>
    <message>
        <source>{} is damaged or holds no shape.</source>
        <translation>{} ist beschädigt oder enthält keine Form.</translation>
    </message>
    <message>
        <source>{} is damaged or no FreeCAD document ({}).</source>
        <translation>{} ist beschädigt oder kein FreeCAD-Dokument ({}).</translation>
    </message>
    <message>
        <source>{} is damaged or not what its ending says ({}).</source>
        <translation>{} ist beschädigt oder nicht das, was die Dateiendung sagt ({}).</translation>
    </message>
    <message>
        <source>{} is damaged, or its faces are no triangles: triangulate it first.</source>
        <translation>{} ist beschädigt, oder die Flächen sind keine Dreiecke: Zerlegen Sie sie zuerst in Dreiecke.</translation>
    </message>
    <message>
        <source>{} is empty (0 bytes).</source>
        <translation>{} ist leer (0 Byte).</translation>
    </message>
    <message>
        <source>{} is no JSON object ({}).</source>
        <translation>{}: kein JSON-Objekt ({}).</translation>
    </message>
    <message>
        <source>{} is no JSON object.</source>
        <translation>{}: kein JSON-Objekt.</translation>
    </message>
    <message>
        <source>{} is no number of JSON</source>
        <translation>{} ist keine Zahl in JSON</translation>
    </message>
    <message>
        <source>{} is not a ThinPart info file.</source>
        <translation>{} ist keine Infodatei von ThinPart.</translation>
    </message>
    <message>
        <source>{} is not a ThinPart profile.</source>
        <translation>{} ist kein Profil von ThinPart.</translation>
    </message>
    <message>
        <source>{} is not well formed: {}.</source>
        <translation>{} ist nicht wohlgeformt: {}.</translation>
    </message>
    <message>
        <source>{} is there already and holds something else than a report: it was left as it is; give a new or an empty folder.</source>
        <translation>{} ist schon vorhanden und enthält etwas anderes als einen Bericht: Der Ordner blieb unverändert; geben Sie einen neuen oder leeren an.</translation>
    </message>
    <message>
        <source>{} is there already and is no table of ThinPart: it was left as it is; give another file to --csv.</source>
        <translation>{} ist schon vorhanden und keine Tabelle von ThinPart: Die Datei blieb unverändert; geben Sie mit --csv eine andere an.</translation>
    </message>
    <message>
        <source>{} is too large</source>
        <translation>{} ist zu groß</translation>
    </message>
    <message>
        <source>{} is too large for an info file.</source>
        <translation>{} ist zu groß für eine Infodatei.</translation>
    </message>
    <message>
        <source>{} is truncated or no STL file: it announces {} triangles and holds {}.</source>
        <translation>{} ist abgeschnitten oder keine STL-Datei: Angekündigt sind {} Dreiecke, enthalten sind {}.</translation>
    </message>
    <message>
        <source>{} is truncated: its end is missing.</source>
        <translation>{} ist abgeschnitten: Das Ende fehlt.</translation>
    </message>
    <message>
        <source>{} lacks or does not know {}.</source>
        <translation>{}: Es fehlt oder ist unbekannt: {}.</translation>
    </message>
    <message>
        <source>{} may not be read: check its permissions.</source>
        <translation>{} darf nicht gelesen werden: Prüfen Sie die Zugriffsrechte.</translation>
    </message>
    <message>
        <source>{} needs more memory than it may have.</source>
        <translation>{} braucht mehr Speicher, als erlaubt ist.</translation>
    </message>
    <message>
        <source>{} needs more memory than {} MB.</source>
        <translation>{} braucht mehr als {} MB Speicher.</translation>
    </message>
    <message>
        <source>{} needs more than {} MB of memory: raise the limit in the preferences.</source>
        <translation>{} braucht mehr als {} MB Speicher: Erhöhen Sie die Grenze in den Einstellungen.</translation>
    </message>
    <message>
        <source>{} took longer than {} s, the limit for one file.</source>
        <translation>{} dauerte länger als {} s, das Zeitlimit für eine Datei.</translation>
    </message>
    <message>
        <source>{} triangles of zero area were left out.</source>
        <translation>{} Dreiecke mit Flächeninhalt null wurden weggelassen.</translation>
    </message>
    <message>
        <source>{} uses a criterion's id twice.</source>
        <translation>{} verwendet die Kennung eines Kriteriums zweimal.</translation>
    </message>
    <message>
        <source>{} was not opened: {}, so it would write outside its own folder or hide what it holds. Get it from somebody whom you trust.</source>
        <translation>{} wurde nicht geöffnet: {}, so würde es außerhalb seines eigenen Ordners schreiben oder verbergen, was es enthält. Beziehen Sie es von jemandem, dem Sie vertrauen.</translation>
    </message>
    <message>
        <source>{} was written again meanwhile: classify it again.</source>
        <translation>{} wurde inzwischen neu geschrieben: Klassifizieren Sie die Datei erneut.</translation>
    </message>
</context>
<context>
    <name>ThinPart_Classify</name>
    <message>
        <source>Classify part</source>
        <translation>Bauteil klassifizieren</translation>
    </message>
    <message>
        <source>Tells whether the selected part is thin, has thin features or is normal, and colours its thin faces</source>
        <translation>Stellt fest, ob das ausgewählte Bauteil dünnwandig ist, dünne Bereiche hat oder normal ist, und färbt seine dünnen Flächen ein</translation>
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
        <source>Gives the faces of this document the colours back that they had before they were coloured as thin</source>
        <translation>Gibt den Flächen dieses Dokuments die Farben zurück, die sie vor dem Einfärben hatten</translation>
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
        <source>Colours the selected parts, or all of them, by the thickness of their walls, and tells how much of the surface lies over which wall</source>
        <translation>Färbt die ausgewählten oder alle Bauteile nach der Wandstärke ein und zeigt, wie viel der Oberfläche über welcher Wand liegt</translation>
    </message>
    <message>
        <source>Show thickness</source>
        <translation>Wandstärke anzeigen</translation>
    </message>
</context>
</TS>
