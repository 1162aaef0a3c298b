<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>Colours from thin to thick</source>
        <translation>Couleurs du mince à l’épais</translation>
    </message>
    <message>
        <source>Number of steps; 0: smooth</source>
        <translation>Nombre de paliers ; 0 : continu</translation>
    </message>
    <message>
        <source>Of the facets, in percent</source>
        <translation>Des facettes, en pourcentage</translation>
    </message>
    <message>
        <source>Of the largest part's box, mm</source>
        <translation>De la boîte englobante de la plus grande pièce, mm</translation>
    </message>
    <message>
        <source>The face where the wall is measured</source>
        <translation>La face où la paroi est mesurée</translation>
    </message>
    <message>
        <source>The measured thickness</source>
        <translation>L’épaisseur mesurée</translation>
    </message>
    <message>
        <source>The opposite sides of those</source>
        <translation>Les côtés opposés de ceux-ci</translation>
    </message>
    <message>
        <source>The place on the face, in the coordinates of its object</source>
        <translation>L'endroit sur la face, dans les coordonnées de son objet</translation>
    </message>
    <message>
        <source>The place on the opposite side, in the coordinates of the document</source>
        <translation>L'endroit sur le côté opposé, dans les coordonnées du document</translation>
    </message>
    <message>
        <source>The sources' shapes when measured</source>
        <translation>Les formes des sources lors de la mesure</translation>
    </message>
    <message>
        <source>The thickness of the material under that place</source>
        <translation>L'épaisseur de la matière sous cet endroit</translation>
    </message>
    <message>
        <source>The thickness there, mm</source>
        <translation>L’épaisseur à cet endroit, mm</translation>
    </message>
    <message>
        <source>Thickest wall of the map, mm</source>
        <translation>Paroi la plus épaisse de la carte, mm</translation>
    </message>
    <message>
        <source>Thickness at the lower end of the colours</source>
        <translation>Épaisseur au bas de l’échelle de couleurs</translation>
    </message>
    <message>
        <source>Thickness at the upper end of the colours</source>
        <translation>Épaisseur au haut de l’échelle de couleurs</translation>
    </message>
    <message>
        <source>Thinnest wall of the map, mm</source>
        <translation>Paroi la plus mince de la carte, mm</translation>
    </message>
    <message>
        <source>Unit of Low and High</source>
        <translation>Unité de Low et High</translation>
    </message>
    <message>
        <source>Walls under it are thin, mm</source>
        <translation>Les parois plus minces sont minces, mm</translation>
    </message>
    <message>
        <source>What was measured</source>
        <translation>Ce qui a été mesuré</translation>
    </message>
    <message>
        <source>Where nothing was measured</source>
        <translation>Là où rien n’a été mesuré</translation>
    </message>
    <message>
        <source>Where the sources stood when measured</source>
        <translation>Position des sources lors de la mesure</translation>
    </message>
    <message>
        <source>Where thickness was asked for</source>
        <translation>Où l’épaisseur a été demandée</translation>
    </message>
    <message>
        <source>Whether colours run from the thinnest to the thickest wall</source>
        <translation>Si les couleurs vont de la paroi la plus mince à la plus épaisse</translation>
    </message>
    <message>
        <source>Whether only thin walls are coloured</source>
        <translation>Si seules les parois minces sont colorées</translation>
    </message>
    <message>
        <source>Whether the colours run the other way</source>
        <translation>Si les couleurs sont inversées</translation>
    </message>
    <message>
        <source>Whether the sources have changed since</source>
        <translation>Si les sources ont changé depuis</translation>
    </message>
</context>
<context>
    <name>ThinPart</name>
    <message>
        <source>
Filled to {} (V/VBB = {})</source>
        <translation>
Rempli à {} (V/VBB = {})</translation>
    </message>
    <message>
        <source>
Its volume is unknown.</source>
        <translation>
Son volume est inconnu.</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>&amp;All parts together</source>
        <translation>&amp;Toutes les pièces ensemble</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Parcourir…</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Export CSV…</source>
        <translation>E&amp;xporter en CSV…</translation>
    </message>
    <message>
        <source>&amp;Fly to thinnest place</source>
        <translation>Aller à l’&amp;endroit le plus mince</translation>
    </message>
    <message>
        <source>&amp;Folder</source>
        <translation>&amp;Dossier</translation>
    </message>
    <message>
        <source>&amp;Folder:</source>
        <translation>&amp;Dossier :</translation>
    </message>
    <message>
        <source>&amp;Install {}</source>
        <translation>&amp;Installer {}</translation>
    </message>
    <message>
        <source>&amp;Measure again</source>
        <translation>Mesurer à &amp;nouveau</translation>
    </message>
    <message>
        <source>&amp;Measure again what has not changed</source>
        <translation>Mesu&amp;rer à nouveau ce qui n’a pas changé</translation>
    </message>
    <message>
        <source>&amp;Names</source>
        <translation>&amp;Noms</translation>
    </message>
    <message>
        <source>&amp;Only thin walls in colour</source>
        <translation>Seulement les parois minces en &amp;couleur</translation>
    </message>
    <message>
        <source>&amp;Open it in the browser when it is ready</source>
        <translation>L’ou&amp;vrir dans le navigateur une fois prêt</translation>
    </message>
    <message>
        <source>&amp;Open part</source>
        <translation>Ou&amp;vrir la pièce</translation>
    </message>
    <message>
        <source>&amp;Open report</source>
        <translation>&amp;Ouvrir le rapport</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>&amp;Probe</source>
        <translation>&amp;Sonde</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Retirer</translation>
    </message>
    <message>
        <source>&amp;Retry failed</source>
        <translation>Réessa&amp;yer les échecs</translation>
    </message>
    <message>
        <source>&amp;Save the document</source>
        <translation>&amp;Enregistrer le document</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>Démarr&amp;er</translation>
    </message>
    <message>
        <source>&amp;Thin below</source>
        <translation>&amp;Mince sous</translation>
    </message>
    <message>
        <source>&amp;Thresholds</source>
        <translation>&amp;Seuils</translation>
    </message>
    <message>
        <source>&amp;Whole range</source>
        <translation>Toute la pla&amp;ge</translation>
    </message>
    <message>
        <source>&amp;Write report</source>
        <translation>É&amp;crire le rapport</translation>
    </message>
    <message>
        <source>&amp;beside each document</source>
        <translation>à &amp;côté de chaque document</translation>
    </message>
    <message>
        <source>&amp;in the folder</source>
        <translation>dans le d&amp;ossier</translation>
    </message>
    <message>
        <source>'{}' has no parts any more that could be measured.</source>
        <translation>« {} » n’a plus de pièces qui puissent être mesurées.</translation>
    </message>
    <message>
        <source>'{}' was not classified yet: classify the part first.</source>
        <translation>« {} » n’a pas encore été classifiée : classifiez d’abord la pièce.</translation>
    </message>
    <message>
        <source>1 probe was removed: the surface is no longer where it was.</source>
        <translation>1 sonde a été retirée : la surface ne se trouve plus à cet endroit.</translation>
    </message>
    <message>
        <source>A folder for the info files, in which the folders of the documents are repeated; it may lie on another computer. Empty: beside each document</source>
        <translation>Un dossier pour les fichiers d’information, où les dossiers des documents sont reproduits ; il peut se trouver sur un autre ordinateur. Vide : à côté de chaque document</translation>
    </message>
    <message>
        <source>A link to {} was put into {}.</source>
        <translation>Un lien vers {} a été placé dans {}.</translation>
    </message>
    <message>
        <source>Add a folder with classified parts under 'Libraries'.</source>
        <translation>Ajoutez un dossier de pièces classifiées sous « Bibliothèques ».</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>Ajouter…</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Après</translation>
    </message>
    <message>
        <source>All parts</source>
        <translation>Toutes les pièces</translation>
    </message>
    <message>
        <source>Angle between neighbouring facets of a curved face</source>
        <translation>Angle entre les facettes voisines d’une face courbe</translation>
    </message>
    <message>
        <source>Angular deflection</source>
        <translation>Déflexion angulaire</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>Bands</source>
        <translation>Paliers</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>Bounding box {}</source>
        <translation>Boîte englobante {}</translation>
    </message>
    <message>
        <source>Box, {}</source>
        <translation>Boîte, {}</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>C&amp;hoisir…</translation>
    </message>
    <message>
        <source>C&amp;lear all</source>
        <translation>Tout e&amp;ffacer</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was changed.</source>
        <translation>Annulé. Rien n’a été modifié.</translation>
    </message>
    <message>
        <source>Cancelled: no info file was written, since other parts of the document are not measured.</source>
        <translation>Annulé : aucun fichier d’information n’a été écrit, car d’autres pièces du document ne sont pas mesurées.</translation>
    </message>
    <message>
        <source>Categories (none chosen: any)</source>
        <translation>Catégories (aucune choisie : toutes)</translation>
    </message>
    <message>
        <source>Category</source>
        <translation>Catégorie</translation>
    </message>
    <message>
        <source>Changed at any time</source>
        <translation>Modifié à tout moment</translation>
    </message>
    <message>
        <source>Changed in the last day</source>
        <translation>Modifié depuis un jour</translation>
    </message>
    <message>
        <source>Changed in the last month</source>
        <translation>Modifié depuis un mois</translation>
    </message>
    <message>
        <source>Changed in the last week</source>
        <translation>Modifié depuis une semaine</translation>
    </message>
    <message>
        <source>Check before meshing whether a part is thin, and where</source>
        <translation>Vérifier avant le maillage si une pièce est mince, et où</translation>
    </message>
    <message>
        <source>Choose a file with mesh settings</source>
        <translation>Choisir un fichier de paramètres de maillage</translation>
    </message>
    <message>
        <source>Choose a file with thresholds</source>
        <translation>Choisir un fichier de seuils</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Choisir un dossier</translation>
    </message>
    <message>
        <source>Choose a folder with classified parts</source>
        <translation>Choisir un dossier de pièces classifiées</translation>
    </message>
    <message>
        <source>Choose a part in the list to see its faces.</source>
        <translation>Choisissez une pièce dans la liste pour voir ses faces.</translation>
    </message>
    <message>
        <source>Choose at least one format.</source>
        <translation>Choisissez au moins un format.</translation>
    </message>
    <message>
        <source>Choose the folder for the info files.</source>
        <translation>Choisissez le dossier des fichiers d’information.</translation>
    </message>
    <message>
        <source>Choose the folder that is to be classified.</source>
        <translation>Choisissez le dossier à classifier.</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>Classification</source>
        <translation>Classification</translation>
    </message>
    <message>
        <source>Classify again</source>
        <translation>Classifier à nouveau</translation>
    </message>
    <message>
        <source>Classify folder</source>
        <translation>Classifier un dossier</translation>
    </message>
    <message>
        <source>Classify in the background</source>
        <translation>Classifier en arrière-plan</translation>
    </message>
    <message>
        <source>Classify part</source>
        <translation>Classifier la pièce</translation>
    </message>
    <message>
        <source>Classifying the folder has ended: {}</source>
        <translation>La classification du dossier est terminée : {}</translation>
    </message>
    <message>
        <source>Clear filters</source>
        <translation>Effacer les filtres</translation>
    </message>
    <message>
        <source>Clear thin colours</source>
        <translation>Effacer les couleurs de minceur</translation>
    </message>
    <message>
        <source>Click or drag over bars to see where those walls are.</source>
        <translation>Cliquez sur des barres ou balayez-les pour voir où sont ces parois.</translation>
    </message>
    <message>
        <source>Click to take this away.</source>
        <translation>Cliquez pour retirer ce message.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Colour thin faces</source>
        <translation>Colorer les faces minces</translation>
    </message>
    <message>
        <source>Colour where no wall could be measured</source>
        <translation>Couleur là où aucune paroi n’a pu être mesurée</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Couleurs</translation>
    </message>
    <message>
        <source>Colours from the thinnest to the thickest wall</source>
        <translation>Couleurs de la paroi la plus mince à la plus épaisse</translation>
    </message>
    <message>
        <source>Compared with what the info file said before</source>
        <translation>Par rapport au fichier d’information précédent</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Comparaison</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Condition</translation>
    </message>
    <message>
        <source>Confidence: borderline, close to '{}' ({} from the limit)</source>
        <translation>Confiance : cas limite, proche de « {} » (à {} de la limite)</translation>
    </message>
    <message>
        <source>Confidence: clear ({} from the limit)</source>
        <translation>Confiance : nette (à {} de la limite)</translation>
    </message>
    <message>
        <source>Continue in the background? 'Classify folder' shows it again. What is done so far is kept either way.</source>
        <translation>Continuer en arrière-plan ? « Classifier un dossier » l’affiche à nouveau. Ce qui est fait est conservé dans tous les cas.</translation>
    </message>
    <message>
        <source>Copy path</source>
        <translation>Copier le chemin</translation>
    </message>
    <message>
        <source>Criteria</source>
        <translation>Critères</translation>
    </message>
    <message>
        <source>Criteria that hold (none chosen: any)</source>
        <translation>Critères remplis (aucun choisi : tous)</translation>
    </message>
    <message>
        <source>Criterion {}: {}. All its conditions hold: {}.</source>
        <translation>Critère {} : {}. Toutes ses conditions sont remplies : {}.</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Affichage</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>Répartition</translation>
    </message>
    <message>
        <source>E&amp;xcept</source>
        <translation>Sau&amp;f</translation>
    </message>
    <message>
        <source>Each document is classified in the background when it is saved; the status bar shows the verdict</source>
        <translation>Chaque document est classifié en arrière-plan à l’enregistrement ; la barre d’état affiche le verdict</translation>
    </message>
    <message>
        <source>Edit notes</source>
        <translation>Modifier les notes</translation>
    </message>
    <message>
        <source>Export the rows that are shown</source>
        <translation>Exporter les lignes affichées</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Face</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Faces</translation>
    </message>
    <message>
        <source>Faces that are thin on at least half their area</source>
        <translation>Faces minces sur au moins la moitié de leur aire</translation>
    </message>
    <message>
        <source>Faces that are thin on less of their area</source>
        <translation>Faces minces sur une moindre part de leur aire</translation>
    </message>
    <message>
        <source>Faces thin in places</source>
        <translation>Faces minces par endroits</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Échec</translation>
    </message>
    <message>
        <source>Failed: {}</source>
        <translation>Échec : {}</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Files at &amp;once</source>
        <translation>Fichiers si&amp;multanés</translation>
    </message>
    <message>
        <source>Files at once</source>
        <translation>Fichiers simultanés</translation>
    </message>
    <message>
        <source>Files of a folder that are measured at once</source>
        <translation>Fichiers d’un dossier mesurés en même temps</translation>
    </message>
    <message>
        <source>Filter: words of the file or the part</source>
        <translation>Filtre : mots du fichier ou de la pièce</translation>
    </message>
    <message>
        <source>Filters</source>
        <translation>Filtres</translation>
    </message>
    <message>
        <source>Find parts</source>
        <translation>Trouver des pièces</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Dossier</translation>
    </message>
    <message>
        <source>Folder of the report</source>
        <translation>Dossier du rapport</translation>
    </message>
    <message>
        <source>For the info file: {}</source>
        <translation>Pour le fichier d’information : {}</translation>
    </message>
    <message>
        <source>Formats</source>
        <translation>Formats</translation>
    </message>
    <message>
        <source>FreeCAD cannot insert {} ({}).</source>
        <translation>FreeCAD ne peut pas insérer {} ({}).</translation>
    </message>
    <message>
        <source>FreeCAD cannot open {} ({}).</source>
        <translation>FreeCAD ne peut pas ouvrir {} ({}).</translation>
    </message>
    <message>
        <source>FreeCAD shows one task at a time: close the one that is open, then try again.</source>
        <translation>FreeCAD n'affiche qu'une tâche à la fois : fermez celle qui est ouverte, puis réessayez.</translation>
    </message>
    <message>
        <source>FreeCAD's Python has no pip, so {} was not installed: install it into {} by another Python's 'pip install --target'.</source>
        <translation>Le Python de FreeCAD n’a pas pip, {} n’a donc pas été installé : installez-le dans {} avec « pip install --target » d’un autre Python.</translation>
    </message>
    <message>
        <source>From file…</source>
        <translation>Depuis un fichier…</translation>
    </message>
    <message>
        <source>From the thinnest to the thickest wall</source>
        <translation>De la paroi la plus mince à la plus épaisse</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Continuer</translation>
    </message>
    <message>
        <source>Half of the face lies over thinner walls</source>
        <translation>La moitié de la face a des parois plus minces</translation>
    </message>
    <message>
        <source>Heat map of the thickness</source>
        <translation>Carte des épaisseurs</translation>
    </message>
    <message>
        <source>Here: {}</source>
        <translation>Ici : {}</translation>
    </message>
    <message>
        <source>Holds</source>
        <translation>Rempli</translation>
    </message>
    <message>
        <source>How far the mesh may lie from the surface, as a share of the part's diagonal; where walls are thin it is made finer anyway</source>
        <translation>Écart permis entre le maillage et la surface, comme part de la diagonale de la pièce ; là où les parois sont minces, il est affiné de toute façon</translation>
    </message>
    <message>
        <source>How often the part stands in the document</source>
        <translation>Combien de fois la pièce figure dans le document</translation>
    </message>
    <message>
        <source>Info file, beside the document: {}</source>
        <translation>Fichier d’information, à côté du document : {}</translation>
    </message>
    <message>
        <source>Info file, in the preferred folder: {}</source>
        <translation>Fichier d’information, dans le dossier préféré : {}</translation>
    </message>
    <message>
        <source>Info files</source>
        <translation>Fichiers d’information</translation>
    </message>
    <message>
        <source>Info files cannot be written in {}: choose another folder for them.</source>
        <translation>Les fichiers d’information ne peuvent pas être écrits dans {} : choisissez un autre dossier.</translation>
    </message>
    <message>
        <source>Insert into active document</source>
        <translation>Insérer dans le document actif</translation>
    </message>
    <message>
        <source>Insert part</source>
        <translation>Insérer une pièce</translation>
    </message>
    <message>
        <source>Installing {}…</source>
        <translation>Installation de {}…</translation>
    </message>
    <message>
        <source>Instances</source>
        <translation>Exemplaires</translation>
    </message>
    <message>
        <source>Into how many steps the colours are divided</source>
        <translation>En combien de paliers les couleurs sont divisées</translation>
    </message>
    <message>
        <source>It is folders that could not be searched: see to them and start again.</source>
        <translation>Ce sont des dossiers qui n’ont pas pu être parcourus : remédiez-y et démarrez à nouveau.</translation>
    </message>
    <message>
        <source>Libraries</source>
        <translation>Bibliothèques</translation>
    </message>
    <message>
        <source>Like</source>
        <translation>Similaire</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Limites</translation>
    </message>
    <message>
        <source>Linear deflection</source>
        <translation>Déflexion linéaire</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Lien</translation>
    </message>
    <message>
        <source>Longest side, {}</source>
        <translation>Plus long côté, {}</translation>
    </message>
    <message>
        <source>Longest, {}</source>
        <translation>Plus long, {}</translation>
    </message>
    <message>
        <source>Looking for parts in the folder…</source>
        <translation>Recherche des pièces du dossier…</translation>
    </message>
    <message>
        <source>MB</source>
        <translation>Mo</translation>
    </message>
    <message>
        <source>Made by</source>
        <translation>Créée par</translation>
    </message>
    <message>
        <source>Making the surface mesh of {}</source>
        <translation>Maillage de la surface de {}</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Marge</translation>
    </message>
    <message>
        <source>Measured: {} parallel, {} tapered, {} nothing opposite</source>
        <translation>Mesuré : {} parallèle, {} en dépouille, {} sans paroi opposée</translation>
    </message>
    <message>
        <source>Measuring and drawing…</source>
        <translation>Mesure et dessin…</translation>
    </message>
    <message>
        <source>Measuring needs more than {} MB of memory: raise the limit in the preferences.</source>
        <translation>La mesure demande plus de {} Mo de mémoire : augmentez la limite dans les préférences.</translation>
    </message>
    <message>
        <source>Measuring the walls of {}</source>
        <translation>Mesure des parois de {}</translation>
    </message>
    <message>
        <source>Median, {}</source>
        <translation>Médiane, {}</translation>
    </message>
    <message>
        <source>Memory per file</source>
        <translation>Mémoire par fichier</translation>
    </message>
    <message>
        <source>Memory that measuring one document may take</source>
        <translation>Mémoire que peut prendre la mesure d’un document</translation>
    </message>
    <message>
        <source>Mesh settings</source>
        <translation>Paramètres de maillage</translation>
    </message>
    <message>
        <source>Meshes</source>
        <translation>Maillages</translation>
    </message>
    <message>
        <source>Move over the part; a click pins the wall there.</source>
        <translation>Déplacez le pointeur sur la pièce ; un clic y fixe une sonde.</translation>
    </message>
    <message>
        <source>No criterion holds: its walls are thick all over.</source>
        <translation>Aucun critère n’est rempli : ses parois sont épaisses partout.</translation>
    </message>
    <message>
        <source>No info file was written, because the document is not saved.</source>
        <translation>Aucun fichier d’information n’a été écrit, car le document n’est pas enregistré.</translation>
    </message>
    <message>
        <source>No info file was written, since not every part was measured.</source>
        <translation>Aucun fichier d’information n’a été écrit, car toutes les pièces n’ont pas été mesurées.</translation>
    </message>
    <message>
        <source>No info file: {}</source>
        <translation>Pas de fichier d’information : {}</translation>
    </message>
    <message>
        <source>No program opens {} here.</source>
        <translation>Aucun programme n’ouvre {} ici.</translation>
    </message>
    <message>
        <source>No program shows folders here; it is {}.</source>
        <translation>Aucun programme n’affiche les dossiers ici ; c’est {}.</translation>
    </message>
    <message>
        <source>No program shows folders here; the info file is {}.</source>
        <translation>Aucun programme n’affiche les dossiers ici ; le fichier d’information est {}.</translation>
    </message>
    <message>
        <source>No wall could be measured.</source>
        <translation>Aucune paroi n’a pu être mesurée.</translation>
    </message>
    <message>
        <source>No wall was measured here.</source>
        <translation>Aucune paroi n’a été mesurée ici.</translation>
    </message>
    <message>
        <source>Normal part</source>
        <translation>Pièce normale</translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation>Non mesuré</translation>
    </message>
    <message>
        <source>Not measured: {}</source>
        <translation>Non mesuré : {}</translation>
    </message>
    <message>
        <source>Not measured: {} of the area</source>
        <translation>Non mesuré : {} de la surface</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
    <message>
        <source>Nothing can be written into {}: choose another folder for the info files.</source>
        <translation>Rien ne peut être écrit dans {} : choisissez un autre dossier pour les fichiers d’information.</translation>
    </message>
    <message>
        <source>Nothing was written to {}: give the table a name that ends with .csv.</source>
        <translation>Rien n’a été écrit dans {} : donnez au tableau un nom qui se termine par .csv.</translation>
    </message>
    <message>
        <source>On every save</source>
        <translation>À chaque enregistrement</translation>
    </message>
    <message>
        <source>Only borderline</source>
        <translation>Seulement les cas limites</translation>
    </message>
    <message>
        <source>Only failures</source>
        <translation>Seulement les échecs</translation>
    </message>
    <message>
        <source>Only with notes</source>
        <translation>Seulement avec des notes</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Out of date: recompute</source>
        <translation>Périmé : recalculer</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Pièce</translation>
    </message>
    <message>
        <source>Part with thin features</source>
        <translation>Pièce à zones minces</translation>
    </message>
    <message>
        <source>Parts like the active one</source>
        <translation>Pièces similaires à l’active</translation>
    </message>
    <message>
        <source>Parts like this one</source>
        <translation>Pièces similaires à celle-ci</translation>
    </message>
    <message>
        <source>Patterns of file names, separated by semicolons; one with a slash is compared with the path below the folder</source>
        <translation>Motifs de noms de fichiers, séparés par des points-virgules ; un motif avec une barre oblique est comparé au chemin dans le dossier</translation>
    </message>
    <message>
        <source>Pin thickness</source>
        <translation>Fixer une sonde</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Sonde</translation>
    </message>
    <message>
        <source>Probes</source>
        <translation>Sondes</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Grandeur</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Plage</translation>
    </message>
    <message>
        <source>Reclassify</source>
        <translation>Reclassifier</translation>
    </message>
    <message>
        <source>Refresh</source>
        <translation>Actualiser</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Remove all probes</source>
        <translation>Retirer toutes les sondes</translation>
    </message>
    <message>
        <source>Remove thickness</source>
        <translation>Retirer une sonde</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Report about all parts of '{}'</source>
        <translation>Rapport sur toutes les pièces de « {} »</translation>
    </message>
    <message>
        <source>Reports need the Python package {}, which this FreeCAD does not have: install it from the internet into {}?</source>
        <translation>Les rapports ont besoin du paquet Python {}, que ce FreeCAD n’a pas : l’installer depuis Internet dans {} ?</translation>
    </message>
    <message>
        <source>Restore defaults</source>
        <translation>Rétablir les valeurs par défaut</translation>
    </message>
    <message>
        <source>Resu&amp;me</source>
        <translation>Re&amp;prendre</translation>
    </message>
    <message>
        <source>Reversed</source>
        <translation>Inversées</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Save and write info file</source>
        <translation>Enregistrer et écrire le fichier d’information</translation>
    </message>
    <message>
        <source>Saved.</source>
        <translation>Enregistré.</translation>
    </message>
    <message>
        <source>Select a part in the list.</source>
        <translation>Sélectionnez une pièce dans la liste.</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Part</translation>
    </message>
    <message>
        <source>Share of the face over walls under the threshold</source>
        <translation>Part de la face à parois sous le seuil</translation>
    </message>
    <message>
        <source>Share of the face where no wall could be measured</source>
        <translation>Part de la face où aucune paroi n’a pu être mesurée</translation>
    </message>
    <message>
        <source>Share of the part's diagonal under which a wall is coloured as thin</source>
        <translation>Part de la diagonale de la pièce sous laquelle une paroi est colorée comme mince</translation>
    </message>
    <message>
        <source>Show in file manager</source>
        <translation>Afficher dans le gestionnaire de fichiers</translation>
    </message>
    <message>
        <source>Show info file’s folder</source>
        <translation>Afficher le dossier du fichier d’information</translation>
    </message>
    <message>
        <source>Show thickness</source>
        <translation>Afficher l’épaisseur</translation>
    </message>
    <message>
        <source>Shown as thin: below {}, as the preferences say. The verdict does not depend on it.</source>
        <translation>Affiché comme mince : sous {}, selon les préférences. Le verdict n’en dépend pas.</translation>
    </message>
    <message>
        <source>Shows the defaults of this page; they are kept with OK or Apply</source>
        <translation>Affiche les valeurs par défaut de cette page ; OK ou Appliquer les enregistre</translation>
    </message>
    <message>
        <source>Shows the wall under the cursor; a click pins it</source>
        <translation>Affiche l’épaisseur sous le pointeur ; un clic y fixe une sonde</translation>
    </message>
    <message>
        <source>Similar size</source>
        <translation>Taille similaire</translation>
    </message>
    <message>
        <source>Starting to measure {}</source>
        <translation>Début de la mesure de {}</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Stopped after {} of {} info files.</source>
        <translation>Arrêté après {} fichiers d’information sur {}.</translation>
    </message>
    <message>
        <source>Stopped before the end, as asked.</source>
        <translation>Arrêté avant la fin, comme demandé.</translation>
    </message>
    <message>
        <source>Stopped: {} of {} info files are up to date.</source>
        <translation>Arrêté : {} fichiers d’information sur {} sont à jour.</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>Arrêt en cours…</translation>
    </message>
    <message>
        <source>Surface mesh that is measured</source>
        <translation>Maillage de surface mesuré</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tableaux (*.csv)</translation>
    </message>
    <message>
        <source>The active document as it was saved. Click to classify it in the panel.</source>
        <translation>Le document actif tel qu’il est enregistré. Cliquez pour le classifier dans le panneau.</translation>
    </message>
    <message>
        <source>The content of {} was copied into {}, which has no file to link from yet.</source>
        <translation>Le contenu de {} a été copié dans {}, qui n’a pas encore de fichier d’où créer un lien.</translation>
    </message>
    <message>
        <source>The document has changed since it was measured: no info file was written. Classify it again.</source>
        <translation>Le document a changé depuis la mesure : aucun fichier d’information n’a été écrit. Classifiez-le à nouveau.</translation>
    </message>
    <message>
        <source>The document has changed while it was measured: measure it again.</source>
        <translation>Le document a changé pendant la mesure : mesurez-le à nouveau.</translation>
    </message>
    <message>
        <source>The document has changes that are not saved. Save the document first.</source>
        <translation>Le document a des modifications non enregistrées. Enregistrez-le d’abord.</translation>
    </message>
    <message>
        <source>The document has never been saved. Save the document first.</source>
        <translation>Le document n’a jamais été enregistré. Enregistrez-le d’abord.</translation>
    </message>
    <message>
        <source>The document is closed: open it again for a report about it.</source>
        <translation>Le document est fermé : rouvrez-le pour en faire un rapport.</translation>
    </message>
    <message>
        <source>The first colour stands for the thickest wall</source>
        <translation>La première couleur représente la paroi la plus épaisse</translation>
    </message>
    <message>
        <source>The folder is still being classified.</source>
        <translation>La classification du dossier est en cours.</translation>
    </message>
    <message>
        <source>The folder with your parts; the folders in it count as well</source>
        <translation>Le dossier de vos pièces, sous-dossiers compris</translation>
    </message>
    <message>
        <source>The folder {} for Python packages cannot be made ({}): {} was not installed.</source>
        <translation>Le dossier {} pour les paquets Python ne peut pas être créé ({}) : {} n’a pas été installé.</translation>
    </message>
    <message>
        <source>The folder {} has not answered for {} s: connect it, or choose another one for the info files.</source>
        <translation>Le dossier {} ne répond pas depuis {} s : connectez-le ou choisissez-en un autre pour les fichiers d’information.</translation>
    </message>
    <message>
        <source>The info file {} is damaged ({}): classify its document again.</source>
        <translation>Le fichier d’information {} est endommagé ({}) : classifiez à nouveau son document.</translation>
    </message>
    <message>
        <source>The process that classifies could not be started.</source>
        <translation>Le processus de classification n’a pas pu être démarré.</translation>
    </message>
    <message>
        <source>The process that classifies ended unexpectedly; what was done is kept. Start again for the rest; the report view has its last words.</source>
        <translation>Le processus de classification s’est terminé de façon inattendue ; ce qui est fait est conservé. Démarrez à nouveau pour le reste ; ses derniers messages sont dans la vue rapport.</translation>
    </message>
    <message>
        <source>The process that does this could not be started.</source>
        <translation>Le processus correspondant n’a pas pu être démarré.</translation>
    </message>
    <message>
        <source>The process that does this ended unexpectedly.</source>
        <translation>Le processus correspondant s’est terminé de façon inattendue.</translation>
    </message>
    <message>
        <source>The process that does this ended unexpectedly; the report view has its last words. Refresh the libraries to go on.</source>
        <translation>Le processus correspondant s’est terminé de façon inattendue ; ses derniers messages sont dans la vue rapport. Actualisez les bibliothèques pour continuer.</translation>
    </message>
    <message>
        <source>The process that installs could not be started.</source>
        <translation>Le processus d’installation n’a pas pu être lancé.</translation>
    </message>
    <message>
        <source>The process that measures could not be started.</source>
        <translation>Le processus de mesure n’a pas pu être démarré.</translation>
    </message>
    <message>
        <source>The process that measures ended unexpectedly; the document is unharmed. Check the part with 'Check geometry' of the Part workbench.</source>
        <translation>Le processus de mesure s’est terminé de façon inattendue ; le document est intact. Vérifiez la pièce avec « Vérifier la géométrie » de l’atelier Part.</translation>
    </message>
    <message>
        <source>The report is in {}.</source>
        <translation>Le rapport est dans {}.</translation>
    </message>
    <message>
        <source>The same may happen to FreeCAD when it opens the file: save your documents first. Open it nevertheless?</source>
        <translation>La même chose peut arriver à FreeCAD en ouvrant le fichier : enregistrez d’abord vos documents. L’ouvrir quand même ?</translation>
    </message>
    <message>
        <source>The table {} could not be written ({}): choose another place for it.</source>
        <translation>Le tableau {} n’a pas pu être écrit ({}) : choisissez un autre emplacement.</translation>
    </message>
    <message>
        <source>The {} parts most like {}, among {} of {}</source>
        <translation>Les {} pièces les plus similaires à {}, parmi {} sur {}</translation>
    </message>
    <message>
        <source>The {} rows that are shown were written to {}.</source>
        <translation>Les {} lignes affichées ont été écrites dans {}.</translation>
    </message>
    <message>
        <source>There is no Python {} beside FreeCAD to measure with: install it.</source>
        <translation>Il n’y a pas de Python {} à côté de FreeCAD pour mesurer : installez-le.</translation>
    </message>
    <message>
        <source>There is no document to insert into: open or create one first.</source>
        <translation>Il n’y a pas de document où insérer : ouvrez-en ou créez-en un d’abord.</translation>
    </message>
    <message>
        <source>There is no document: open or create one first.</source>
        <translation>Il n’y a pas de document : ouvrez-en ou créez-en un d’abord.</translation>
    </message>
    <message>
        <source>There is no file {} any more.</source>
        <translation>Le fichier {} n’existe plus.</translation>
    </message>
    <message>
        <source>There is no folder {} any more.</source>
        <translation>Le dossier {} n’existe plus.</translation>
    </message>
    <message>
        <source>There is no folder {}: choose another one.</source>
        <translation>Le dossier {} n’existe pas : choisissez-en un autre.</translation>
    </message>
    <message>
        <source>There is no folder {}: make it first, or choose another one for the info files.</source>
        <translation>Le dossier {} n’existe pas : créez-le d’abord ou choisissez-en un autre pour les fichiers d’information.</translation>
    </message>
    <message>
        <source>There is no room for temporary files ({}): nothing was classified.</source>
        <translation>Il n’y a pas de place pour les fichiers temporaires ({}) : rien n’a été classifié.</translation>
    </message>
    <message>
        <source>There is no room for temporary files ({}): nothing was measured.</source>
        <translation>Il n’y a pas de place pour les fichiers temporaires ({}) : rien n’a été mesuré.</translation>
    </message>
    <message>
        <source>There is no room for the thickness map ({}): nothing was changed.</source>
        <translation>Il n’y a pas de place pour la carte des épaisseurs ({}) : rien n’a été modifié.</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Épaisseur</translation>
    </message>
    <message>
        <source>Thickness colours</source>
        <translation>Échelle de couleurs</translation>
    </message>
    <message>
        <source>Thickness under which a wall is coloured as thin</source>
        <translation>Épaisseur sous laquelle une paroi est colorée comme mince</translation>
    </message>
    <message>
        <source>Thin</source>
        <translation>Mince</translation>
    </message>
    <message>
        <source>Thin below</source>
        <translation>Mince sous</translation>
    </message>
    <message>
        <source>Thin faces</source>
        <translation>Faces minces</translation>
    </message>
    <message>
        <source>Thin part</source>
        <translation>Pièce mince</translation>
    </message>
    <message>
        <source>ThinPart is there twice: {} is used, {} is not. Remove one of them.</source>
        <translation>ThinPart est présent deux fois : {} est utilisé, {} ne l’est pas. Supprimez l’un des deux.</translation>
    </message>
    <message>
        <source>ThinPart: {}</source>
        <translation>ThinPart : {}</translation>
    </message>
    <message>
        <source>Thinnest wall</source>
        <translation>Paroi la plus mince</translation>
    </message>
    <message>
        <source>Thinnest wall under the face</source>
        <translation>Paroi la plus mince sous la face</translation>
    </message>
    <message>
        <source>Thinnest wall {} (± {})</source>
        <translation>Paroi la plus mince {} (± {})</translation>
    </message>
    <message>
        <source>Thinnest wall, {}</source>
        <translation>Paroi la plus mince, {}</translation>
    </message>
    <message>
        <source>Thinnest, {}</source>
        <translation>Minimum, {}</translation>
    </message>
    <message>
        <source>This did not work, for a reason that was not foreseen ({}): try again, and if it happens again, report it with FreeCAD's log.</source>
        <translation>Cela n'a pas fonctionné, pour une raison imprévue ({}) : réessayez et, si cela se reproduit, signalez-le avec le journal de FreeCAD.</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Seuil</translation>
    </message>
    <message>
        <source>Thresholds</source>
        <translation>Seuils</translation>
    </message>
    <message>
        <source>Thresholds (*.json)</source>
        <translation>Seuils (*.json)</translation>
    </message>
    <message>
        <source>Thresholds to judge by: a shipped profile, or a file</source>
        <translation>Seuils du verdict : un profil fourni ou un fichier</translation>
    </message>
    <message>
        <source>Time &amp;limit per file</source>
        <translation>&amp;Limite de temps par fichier</translation>
    </message>
    <message>
        <source>Time per file</source>
        <translation>Temps par fichier</translation>
    </message>
    <message>
        <source>Time that one file of a folder, or a document that is classified automatically, may take</source>
        <translation>Temps que peut prendre un fichier d’un dossier ou un document classifié automatiquement</translation>
    </message>
    <message>
        <source>To classify a part, open a document and close the task that is open.</source>
        <translation>Pour classifier une pièce, ouvrez un document et fermez la tâche ouverte.</translation>
    </message>
    <message>
        <source>Under which thickness a wall is coloured as thin; the verdict does not depend on it</source>
        <translation>Épaisseur sous laquelle une paroi est colorée comme mince ; le verdict n’en dépend pas</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Inconnue</translation>
    </message>
    <message>
        <source>Unmeasured</source>
        <translation>Non mesuré</translation>
    </message>
    <message>
        <source>V/VBB</source>
        <translation>V/VBB</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Paroi</translation>
    </message>
    <message>
        <source>Wall thickness</source>
        <translation>Épaisseur</translation>
    </message>
    <message>
        <source>Wall thickness, {}</source>
        <translation>Épaisseur, {}</translation>
    </message>
    <message>
        <source>Wall thickness: min {}, median {}, max {} (± {})</source>
        <translation>Épaisseur de paroi : min. {}, médiane {}, max. {} (± {})</translation>
    </message>
    <message>
        <source>Walls that are shown as thin</source>
        <translation>Parois affichées comme minces</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Avertissements</translation>
    </message>
    <message>
        <source>What is under no wall that could be measured, in the heat map</source>
        <translation>Ce qui n’a pas de paroi mesurable dans la carte des épaisseurs</translation>
    </message>
    <message>
        <source>What was measured, notes, mesh settings and links stay as they are. Write them now?</source>
        <translation>Les mesures, notes, paramètres de maillage et liens restent inchangés. Écrire maintenant ?</translation>
    </message>
    <message>
        <source>When a wall is under</source>
        <translation>Si une paroi est sous</translation>
    </message>
    <message>
        <source>When the category of a part changes</source>
        <translation>Si la catégorie d’une pièce change</translation>
    </message>
    <message>
        <source>When the thinnest wall of a part falls under this thickness, or is under it in a part that was not classified before</source>
        <translation>Si la paroi la plus mince d’une pièce passe sous cette épaisseur, ou l’est déjà dans une pièce jamais classifiée</translation>
    </message>
    <message>
        <source>Which part do you mean?</source>
        <translation>De quelle pièce s’agit-il ?</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Pourquoi</translation>
    </message>
    <message>
        <source>Why: {}</source>
        <translation>Raison : {}</translation>
    </message>
    <message>
        <source>Words in names, paths, notes, links</source>
        <translation>Mots des noms, chemins, notes, liens</translation>
    </message>
    <message>
        <source>Write…</source>
        <translation>Écrire…</translation>
    </message>
    <message>
        <source>Writing the info file…</source>
        <translation>Écriture du fichier d’information…</translation>
    </message>
    <message>
        <source>a file, or a JSON object</source>
        <translation>un fichier ou un objet JSON</translation>
    </message>
    <message>
        <source>a share of the part's diagonal</source>
        <translation>une part de la diagonale de la pièce</translation>
    </message>
    <message>
        <source>a thickness</source>
        <translation>une épaisseur</translation>
    </message>
    <message>
        <source>about {} left</source>
        <translation>encore {} environ</translation>
    </message>
    <message>
        <source>all, or such as: bracket*; *_v2*</source>
        <translation>tous, ou par exemple : support*; *_v2*</translation>
    </message>
    <message>
        <source>an address or a folder</source>
        <translation>une adresse ou un dossier</translation>
    </message>
    <message>
        <source>and {} more parts</source>
        <translation>et {} autres pièces</translation>
    </message>
    <message>
        <source>area over walls thinner than this share of the diagonal</source>
        <translation>surface à parois plus minces que cette part de la diagonale</translation>
    </message>
    <message>
        <source>beside each document</source>
        <translation>à côté de chaque document</translation>
    </message>
    <message>
        <source>cancelled: what was done is kept, Start does the rest</source>
        <translation>annulé : ce qui est fait est conservé, « Démarrer » fait le reste</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>échec</translation>
    </message>
    <message>
        <source>failed: {}</source>
        <translation>échec : {}</translation>
    </message>
    <message>
        <source>in</source>
        <translation>en</translation>
    </message>
    <message>
        <source>in the pre&amp;ferred folder</source>
        <translation>dans le doss&amp;ier préféré</translation>
    </message>
    <message>
        <source>in {}</source>
        <translation>en {}</translation>
    </message>
    <message>
        <source>it holds nothing to link to</source>
        <translation>il ne contient rien à lier</translation>
    </message>
    <message>
        <source>it is the active document itself</source>
        <translation>c’est le document actif lui-même</translation>
    </message>
    <message>
        <source>measuring…</source>
        <translation>mesure…</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normale</translation>
    </message>
    <message>
        <source>not classified</source>
        <translation>non classifié</translation>
    </message>
    <message>
        <source>not finished</source>
        <translation>inachevé</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>non mesuré</translation>
    </message>
    <message>
        <source>nothing came in</source>
        <translation>rien n’a été importé</translation>
    </message>
    <message>
        <source>of the diagonal</source>
        <translation>de la diagonale</translation>
    </message>
    <message>
        <source>off</source>
        <translation>désactivé</translation>
    </message>
    <message>
        <source>one per processor</source>
        <translation>un par processeur</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>en pause</translation>
    </message>
    <message>
        <source>pausing</source>
        <translation>mise en pause</translation>
    </message>
    <message>
        <source>pip could not install {}; the report view has its words.</source>
        <translation>pip n’a pas pu installer {} ; ses messages sont dans la vue rapport.</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>same limit as the verdict</source>
        <translation>même limite que le verdict</translation>
    </message>
    <message>
        <source>share of the diagonal</source>
        <translation>part de la diagonale</translation>
    </message>
    <message>
        <source>share of the diagonal ({})</source>
        <translation>part de la diagonale ({})</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>continu</translation>
    </message>
    <message>
        <source>stopping</source>
        <translation>arrêt en cours</translation>
    </message>
    <message>
        <source>such as: old/*; *draft*</source>
        <translation>par exemple : ancien/*; *brouillon*</translation>
    </message>
    <message>
        <source>there is no importer for such files</source>
        <translation>il n’y a pas d’importateur pour ces fichiers</translation>
    </message>
    <message>
        <source>thickness: {}, and share of the diagonal</source>
        <translation>épaisseur : {} et part de la diagonale</translation>
    </message>
    <message>
        <source>thin</source>
        <translation>mince</translation>
    </message>
    <message>
        <source>thin below {}</source>
        <translation>mince sous {}</translation>
    </message>
    <message>
        <source>thin features</source>
        <translation>zones minces</translation>
    </message>
    <message>
        <source>thin in places</source>
        <translation>mince par endroits</translation>
    </message>
    <message>
        <source>thin on half of the face or more</source>
        <translation>mince sur la moitié de la face ou plus</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>wedge {:g}–{:g}°</source>
        <translation>coin {:g}–{:g}°</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>{} (borderline)</source>
        <translation>{} (cas limite)</translation>
    </message>
    <message>
        <source>{} (rule {})</source>
        <translation>« {} » (règle {})</translation>
    </message>
    <message>
        <source>{} ({} parts)</source>
        <translation>{} ({} pièces)</translation>
    </message>
    <message>
        <source>{} ({} times)</source>
        <translation>{} ({} fois)</translation>
    </message>
    <message>
        <source>{} There are {} more failures.</source>
        <translation>{} Il y a {} autres échecs.</translation>
    </message>
    <message>
        <source>{} and more: {} of the area</source>
        <translation>{} et plus : {} de la surface</translation>
    </message>
    <message>
        <source>{} different parts, {} instances</source>
        <translation>{} pièces différentes, {} occurrences</translation>
    </message>
    <message>
        <source>{} failed</source>
        <translation>{} en échec</translation>
    </message>
    <message>
        <source>{} h {} min</source>
        <translation>{} h {} min</translation>
    </message>
    <message>
        <source>{} has no info file.</source>
        <translation>{} n’a pas de fichier d’information.</translation>
    </message>
    <message>
        <source>{} holds {} too, which was taken off the list.</source>
        <translation>{} contient aussi {}, qui a été retiré de la liste.</translation>
    </message>
    <message>
        <source>{} info files were left as they are: {}</source>
        <translation>{} fichiers d’information sont restés inchangés : {}</translation>
    </message>
    <message>
        <source>{} info files were updated.</source>
        <translation>{} fichiers d’information ont été mis à jour.</translation>
    </message>
    <message>
        <source>{} info files will be updated; {} parts change their category.</source>
        <translation>{} fichiers d’information seront mis à jour ; {} pièces changent de catégorie.</translation>
    </message>
    <message>
        <source>{} is in the list already, as a part of {}.</source>
        <translation>{} est déjà dans la liste, dans {}.</translation>
    </message>
    <message>
        <source>{} is in the list already.</source>
        <translation>{} est déjà dans la liste.</translation>
    </message>
    <message>
        <source>{} min</source>
        <translation>{} min</translation>
    </message>
    <message>
        <source>{} of the area lies over walls thinner than {}</source>
        <translation>{} de la surface a des parois plus minces que {}</translation>
    </message>
    <message>
        <source>{} of {} files</source>
        <translation>{} fichiers sur {}</translation>
    </message>
    <message>
        <source>{} of {} parts</source>
        <translation>{} pièces sur {}</translation>
    </message>
    <message>
        <source>{} of {} parts change their category; {} info files would be updated.</source>
        <translation>{} pièces sur {} changent de catégorie ; {} fichiers d’information seraient mis à jour.</translation>
    </message>
    <message>
        <source>{} probes were removed: the surface is no longer where they were.</source>
        <translation>{} sondes ont été retirées : la surface ne se trouve plus à ces endroits.</translation>
    </message>
    <message>
        <source>{} s</source>
        <translation>{} s</translation>
    </message>
    <message>
        <source>{} to {} thick ({} to {} of the diagonal): {} of the area</source>
        <translation>épaisseur de {} à {} ({} à {} de la diagonale) : {} de la surface</translation>
    </message>
    <message>
        <source>{} to {}: {} of the area</source>
        <translation>{} à {} : {} de la surface</translation>
    </message>
    <message>
        <source>{} to {}: {} of the area, on 1 face</source>
        <translation>{} à {} : {} de la surface, sur 1 face</translation>
    </message>
    <message>
        <source>{} to {}: {} of the area, on {} faces</source>
        <translation>{} à {} : {} de la surface, sur {} faces</translation>
    </message>
    <message>
        <source>{} unchanged</source>
        <translation>{} inchangés</translation>
    </message>
    <message>
        <source>{} warnings; {}</source>
        <translation>{} avertissements ; {}</translation>
    </message>
    <message>
        <source>{} was imported into {}.</source>
        <translation>{} a été importé dans {}.</translation>
    </message>
    <message>
        <source>{} was not found in the index of Python packages: connect this computer to the internet, or set up pip's proxy, and try again.</source>
        <translation>{} est introuvable dans l’index des paquets Python : connectez cet ordinateur à Internet ou configurez le proxy de pip, puis réessayez.</translation>
    </message>
    <message>
        <source>{}, and share of the diagonal</source>
        <translation>{} et part de la diagonale</translation>
    </message>
    <message>
        <source>{}: '{}' ({}) has a wall of {}, under the limit of {}.</source>
        <translation>{} : « {} » ({}) a une paroi de {}, sous la limite de {}.</translation>
    </message>
    <message>
        <source>{}: '{}' was '{}' and is '{}' now; its thinnest wall is {}.</source>
        <translation>{} : « {} » était « {} » et est maintenant « {} » ; sa paroi la plus mince a {}.</translation>
    </message>
    <message>
        <source>{}: '{}' was '{}' and is '{}' now; its thinnest wall of {} is under the limit of {}.</source>
        <translation>{} : « {} » était « {} » et est maintenant « {} » ; sa paroi la plus mince de {} est sous la limite de {}.</translation>
    </message>
    <message>
        <source>{}: '{}' was '{}' and is '{}' now; none of its walls could be measured.</source>
        <translation>{} : « {} » était « {} » et est maintenant « {} » ; aucune de ses parois n’a pu être mesurée.</translation>
    </message>
    <message>
        <source>{}: looking for info files, {} so far</source>
        <translation>{} : recherche des fichiers d’information, {} jusqu’ici</translation>
    </message>
    <message>
        <source>{}: {}</source>
        <translation>{} : {}</translation>
    </message>
    <message>
        <source>{}: {} of {} info files read</source>
        <translation>{} : {} fichiers d’information lus sur {}</translation>
    </message>
    <message>
        <source>{} % like: {}</source>
        <translation>{} % similaire : {}</translation>
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
        <translation>⚠ La pièce a changé depuis la mesure.</translation>
    </message>
</context>
<context>
    <name>ThinPartCore</name>
    <message>
        <source>'{}' has an empty shape: recompute the document or delete it.</source>
        <translation>« {} » a une forme vide : recalculez le document ou supprimez l’objet.</translation>
    </message>
    <message>
        <source>'{}' has no shape, because its last recompute failed ({}): repair it and recompute the document.</source>
        <translation>« {} » n’a pas de forme, car son dernier recalcul a échoué ({}) : réparez l’objet et recalculez le document.</translation>
    </message>
    <message>
        <source>'{}' has no shape, because the last recompute of '{}' failed ({}): repair it and recompute the document.</source>
        <translation>« {} » n’a pas de forme, car le dernier recalcul de « {} » a échoué ({}) : réparez l’objet et recalculez le document.</translation>
    </message>
    <message>
        <source>'{}' is a closed shell but no solid: convert it to a solid first.</source>
        <translation>« {} » est une coque fermée mais pas un solide : convertissez-la d’abord en solide.</translation>
    </message>
    <message>
        <source>'{}' is a mesh without triangles: import it again or delete it.</source>
        <translation>« {} » est un maillage sans triangles : importez-le à nouveau ou supprimez-le.</translation>
    </message>
    <message>
        <source>'{}' is made of surfaces that bound no solid: close or thicken it first.</source>
        <translation>« {} » est fait de surfaces qui ne délimitent aucun solide : fermez-les ou épaississez-les d’abord.</translation>
    </message>
    <message>
        <source>A bulky part with thin places: refine the mesh there or remove them.</source>
        <translation>Une pièce massive avec des endroits minces : affinez-y le maillage ou supprimez-les.</translation>
    </message>
    <message>
        <source>All its triangles have zero area.</source>
        <translation>Tous ses triangles ont une aire nulle.</translation>
    </message>
    <message>
        <source>All points lie in one place.</source>
        <translation>Tous les points sont au même endroit.</translation>
    </message>
    <message>
        <source>Area of its surface</source>
        <translation>Aire de sa surface</translation>
    </message>
    <message>
        <source>Diagonal of the bounding box</source>
        <translation>Diagonale de la boîte englobante</translation>
    </message>
    <message>
        <source>Faces that meet in a thin wedge</source>
        <translation>Faces formant un coin mince</translation>
    </message>
    <message>
        <source>Fills little of its box</source>
        <translation>Remplit peu sa boîte englobante</translation>
    </message>
    <message>
        <source>Flat and about as long as wide</source>
        <translation>Plate et à peu près aussi longue que large</translation>
    </message>
    <message>
        <source>FreeCAD cannot be imported by {} ({}): install it (Debian: 'apt-get install freecad') or set FREECAD_LIB to the folder with its FreeCAD.so or FreeCAD.pyd.</source>
        <translation>FreeCAD ne peut pas être importé par {} ({}) : installez-le (Debian : « apt-get install freecad ») ou donnez à FREECAD_LIB le dossier de son FreeCAD.so ou FreeCAD.pyd.</translation>
    </message>
    <message>
        <source>FreeCAD cannot open {} ({}).</source>
        <translation>FreeCAD ne peut pas ouvrir {} ({}).</translation>
    </message>
    <message>
        <source>FreeCAD cannot read {} ({}).</source>
        <translation>FreeCAD ne peut pas lire {} ({}).</translation>
    </message>
    <message>
        <source>FreeCAD could not tessellate any of its faces.</source>
        <translation>FreeCAD n’a pu tesseller aucune de ses faces.</translation>
    </message>
    <message>
        <source>FreeCAD could not tessellate it ({}).</source>
        <translation>FreeCAD n’a pas pu tesseller la pièce ({}).</translation>
    </message>
    <message>
        <source>FreeCAD could not tessellate {} and {} more.</source>
        <translation>FreeCAD n’a pas pu tesseller {} et {} autres.</translation>
    </message>
    <message>
        <source>FreeCAD could not tessellate {}.</source>
        <translation>FreeCAD n’a pas pu tesseller {}.</translation>
    </message>
    <message>
        <source>FreeCAD did not say which triangle belongs to which face.</source>
        <translation>FreeCAD n’a pas indiqué à quelle face appartient chaque triangle.</translation>
    </message>
    <message>
        <source>FreeCAD follows no links from a document whose path is no UTF-8 text or has a backslash: rename {} or the folder that it lies in.</source>
        <translation>FreeCAD ne suit aucun lien depuis un document dont le chemin n'est pas du texte UTF-8 ou contient une barre oblique inverse : renommez {} ou son dossier.</translation>
    </message>
    <message>
        <source>Giannini et al. 2012</source>
        <translation>Giannini et coll. 2012</translation>
    </message>
    <message>
        <source>Info files cannot be written into {} ({}): give another folder to --info-dir.</source>
        <translation>Les fichiers d’information ne peuvent pas être écrits dans {} ({}) : choisissez un autre dossier (--info-dir).</translation>
    </message>
    <message>
        <source>It came as {} loose faces, which were sewn together.</source>
        <translation>La pièce était faite de {} faces libres, qui ont été cousues.</translation>
    </message>
    <message>
        <source>It holds no triangles.</source>
        <translation>Il ne contient aucun triangle.</translation>
    </message>
    <message>
        <source>Its bounding box is empty or not finite.</source>
        <translation>Sa boîte englobante est vide ou infinie.</translation>
    </message>
    <message>
        <source>Its surface encloses no volume.</source>
        <translation>Sa surface n’enferme aucun volume.</translation>
    </message>
    <message>
        <source>Least distance, in diagonals, between walls at a to b degrees</source>
        <translation>Plus petite distance, en diagonales, entre parois formant un angle de a à b degrés</translation>
    </message>
    <message>
        <source>Longest side of the bounding box</source>
        <translation>Plus long côté de la boîte englobante</translation>
    </message>
    <message>
        <source>Longest to middle side of the bounding box</source>
        <translation>Rapport du plus long côté au côté moyen de la boîte englobante</translation>
    </message>
    <message>
        <source>Middle side of the bounding box</source>
        <translation>Côté moyen de la boîte englobante</translation>
    </message>
    <message>
        <source>Middle to shortest side of the bounding box</source>
        <translation>Rapport du côté moyen au plus petit côté de la boîte englobante</translation>
    </message>
    <message>
        <source>No report can be written into {} ({}): give another folder.</source>
        <translation>Aucun rapport ne peut être écrit dans {} ({}) : indiquez un autre dossier.</translation>
    </message>
    <message>
        <source>Nothing was measured that could be written.</source>
        <translation>Rien n’a été mesuré qui puisse être écrit.</translation>
    </message>
    <message>
        <source>Part with thin features</source>
        <translation>Pièce à zones minces</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Plaque</translation>
    </message>
    <message>
        <source>Reports need the Python package Jinja2 ({}): install it (Debian: 'apt-get install python3-jinja2', elsewhere: 'python -m pip install Jinja2').</source>
        <translation>Les rapports ont besoin du paquet Python Jinja2 ({}) : installez-le (Debian : « apt-get install python3-jinja2 », ailleurs : « python -m pip install Jinja2 »).</translation>
    </message>
    <message>
        <source>Share of the area over non-parallel walls</source>
        <translation>Part de la surface à parois non parallèles</translation>
    </message>
    <message>
        <source>Share of the area over parallel walls</source>
        <translation>Part de la surface à parois parallèles</translation>
    </message>
    <message>
        <source>Share of the area over walls of a thickness from a to b diagonals</source>
        <translation>Part de la surface à parois d’une épaisseur de a à b diagonales</translation>
    </message>
    <message>
        <source>Share of the area whose ray met nothing at all</source>
        <translation>Part de la surface dont le rayon n’a rien rencontré</translation>
    </message>
    <message>
        <source>Share of the area with no wall opposite</source>
        <translation>Part de la surface sans paroi opposée</translation>
    </message>
    <message>
        <source>Share of the bounding box that the part fills</source>
        <translation>Part de la boîte englobante que la pièce remplit</translation>
    </message>
    <message>
        <source>Shortest side of the bounding box</source>
        <translation>Plus petit côté de la boîte englobante</translation>
    </message>
    <message>
        <source>Some coordinates are not finite numbers.</source>
        <translation>Certaines coordonnées ne sont pas des nombres finis.</translation>
    </message>
    <message>
        <source>Some triangles refer to points that are not there.</source>
        <translation>Certains triangles renvoient à des points inexistants.</translation>
    </message>
    <message>
        <source>Stopped before the end, as asked.</source>
        <translation>Arrêté avant la fin, comme demandé.</translation>
    </message>
    <message>
        <source>The Python module {} is missing: install it to have documents classified automatically (Debian: python3-{}).</source>
        <translation>Le module Python {} manque : installez-le pour que les documents soient classifiés automatiquement (Debian : python3-{}).</translation>
    </message>
    <message>
        <source>The condition {} is not understood: write a quantity, one of {} and a number, as in 'D2/D3 &gt; 6'.</source>
        <translation>La condition {} n’est pas comprise : écrivez une grandeur, un des signes {} et un nombre, comme « D2/D3 &gt; 6 ».</translation>
    </message>
    <message>
        <source>The document '{}' is empty: make or import a solid first.</source>
        <translation>Le document « {} » est vide : créez ou importez d’abord un solide.</translation>
    </message>
    <message>
        <source>The document names Python modules that are not FreeCAD's ({}): they were not loaded, and objects that need them may lack their shape.</source>
        <translation>Le document nomme des modules Python qui ne sont pas de FreeCAD ({}) : ils n'ont pas été chargés, et la forme des objets qui en ont besoin peut manquer.</translation>
    </message>
    <message>
        <source>The document's folder has not answered for {} s: connect it, or choose a folder for info files in the preferences.</source>
        <translation>Le dossier du document ne répond pas depuis {} s : connectez-le ou choisissez un dossier pour les fichiers d’information dans les préférences.</translation>
    </message>
    <message>
        <source>The file</source>
        <translation>Le fichier</translation>
    </message>
    <message>
        <source>The file {}</source>
        <translation>Le fichier {}</translation>
    </message>
    <message>
        <source>The file {} cannot be read ({}).</source>
        <translation>Le fichier {} ne peut pas être lu ({}).</translation>
    </message>
    <message>
        <source>The folder for info files {} cannot be reached ({}): connect it, or choose another one in the preferences.</source>
        <translation>Le dossier {} des fichiers d’information est inaccessible ({}) : connectez-le ou choisissez-en un autre dans les préférences.</translation>
    </message>
    <message>
        <source>The folder for info files {} has not answered for {} s: connect it, or choose another one in the preferences.</source>
        <translation>Le dossier {} des fichiers d’information ne répond pas depuis {} s : connectez-le ou choisissez-en un autre dans les préférences.</translation>
    </message>
    <message>
        <source>The folder {} cannot be listed ({}): what is known of it is from earlier.</source>
        <translation>Le contenu du dossier {} ne peut pas être lu ({}) : ce qu’on en sait date d’avant.</translation>
    </message>
    <message>
        <source>The folder {} cannot be listed ({}): what lies in it is left as it is.</source>
        <translation>Le contenu du dossier {} ne peut pas être lu ({}) : il reste inchangé.</translation>
    </message>
    <message>
        <source>The folder {} cannot be reached ({}).</source>
        <translation>Le dossier {} est inaccessible ({}).</translation>
    </message>
    <message>
        <source>The folder {} could not be searched to its end ({}): classify it again when it can be reached.</source>
        <translation>Le dossier {} n’a pas pu être parcouru jusqu’au bout ({}) : classifiez-le à nouveau quand il sera accessible.</translation>
    </message>
    <message>
        <source>The folder {} may not be searched: check its permissions.</source>
        <translation>Le dossier {} ne peut pas être parcouru : vérifiez ses droits d’accès.</translation>
    </message>
    <message>
        <source>The home folder {} may not be used, which FreeCAD needs: set FREECAD_USER_HOME to a folder that may.</source>
        <translation>Le dossier personnel {}, dont FreeCAD a besoin, n’est pas utilisable : donnez à FREECAD_USER_HOME un dossier qui l’est.</translation>
    </message>
    <message>
        <source>The info file {} belongs to {} and was left as it is: choose another folder for the info file of {}.</source>
        <translation>Le fichier d’information {} appartient à {} et est resté inchangé : choisissez un autre dossier pour le fichier d’information de {}.</translation>
    </message>
    <message>
        <source>The info file {} cannot be read ({}).</source>
        <translation>Le fichier d’information {} ne peut pas être lu ({}).</translation>
    </message>
    <message>
        <source>The info file {} could not be written ({}): make room or choose another place for it.</source>
        <translation>Le fichier d’information {} n’a pas pu être écrit ({}) : faites de la place ou choisissez un autre emplacement.</translation>
    </message>
    <message>
        <source>The info file {} is damaged ({}: {}): classify its document again.</source>
        <translation>Le fichier d’information {} est endommagé ({} : {}) : classifiez à nouveau son document.</translation>
    </message>
    <message>
        <source>The info file {} lacks {}.</source>
        <translation>Il manque au fichier d’information {} : {}.</translation>
    </message>
    <message>
        <source>The library {} cannot be read ({}).</source>
        <translation>La bibliothèque {} ne peut pas être lue ({}).</translation>
    </message>
    <message>
        <source>The link '{}' leads to '{}' in {}, which cannot be found: put the file back or set the linked object again.</source>
        <translation>Le lien « {} » mène à « {} » dans {}, introuvable : remettez le fichier en place ou définissez à nouveau l’objet lié.</translation>
    </message>
    <message>
        <source>The link '{}' leads to nothing: set its linked object again or delete it.</source>
        <translation>Le lien « {} » ne mène à rien : définissez à nouveau son objet lié ou supprimez-le.</translation>
    </message>
    <message>
        <source>The list {} cannot be read ({}): give a file to --only that names the parts.</source>
        <translation>La liste {} ne peut pas être lue ({}) : donnez à --only un fichier qui nomme les pièces.</translation>
    </message>
    <message>
        <source>The list {} names {}, which does not lie below {}: name a PATH that holds it, or leave out --info-dir.</source>
        <translation>La liste {} nomme {}, qui n’est pas sous {} : nommez un PATH qui le contient, ou omettez --info-dir.</translation>
    </message>
    <message>
        <source>The list {} names {}, which is no absolute path: write whole paths, each ended by a NUL byte.</source>
        <translation>La liste {} nomme {}, qui n’est pas un chemin absolu : écrivez des chemins complets, chacun terminé par un octet NUL.</translation>
    </message>
    <message>
        <source>The mesh settings</source>
        <translation>Les paramètres de maillage</translation>
    </message>
    <message>
        <source>The name is too long for an info file, which is called the same and {}: it may have {} bytes and has {}; rename it, or use --no-info.</source>
        <translation>Le nom est trop long pour un fichier d’information, qui porte le même suivi de {} : il peut avoir {} octets et en a {} ; renommez le fichier ou utilisez --no-info.</translation>
    </message>
    <message>
        <source>The overview of the report could not be written into {} ({}): make room for it, and start again.</source>
        <translation>La vue d’ensemble du rapport n’a pas pu être écrite dans {} ({}) : faites de la place et démarrez à nouveau.</translation>
    </message>
    <message>
        <source>The page {} could not be written ({}): make room, or give another folder for the report.</source>
        <translation>La page {} n’a pas pu être écrite ({}) : faites de la place ou indiquez un autre dossier pour le rapport.</translation>
    </message>
    <message>
        <source>The part as a whole is thin: consider a shell mesh or a mid-surface.</source>
        <translation>La pièce entière est mince : envisagez un maillage de coque ou une surface moyenne.</translation>
    </message>
    <message>
        <source>The part is {} mm across: check that the file's unit is millimetres.</source>
        <translation>La pièce mesure {} mm en diagonale : vérifiez que l’unité du fichier est le millimètre.</translation>
    </message>
    <message>
        <source>The parts lie on several drives: name those of one drive at a time.</source>
        <translation>Les pièces se trouvent sur plusieurs lecteurs : indiquez celles d’un seul lecteur à la fois.</translation>
    </message>
    <message>
        <source>The profile {} cannot be read ({}).</source>
        <translation>Le profil {} ne peut pas être lu ({}).</translation>
    </message>
    <message>
        <source>The search index {} cannot be kept ({}): it was built in memory, and the next search has to build it again.</source>
        <translation>L’index de recherche {} ne peut pas être conservé ({}) : il a été construit en mémoire, et la prochaine recherche devra le reconstruire.</translation>
    </message>
    <message>
        <source>The surface is open ({} free edges), so it has no certain volume.</source>
        <translation>La surface est ouverte ({} arêtes libres), son volume n’est donc pas certain.</translation>
    </message>
    <message>
        <source>The surface passes through itself, as under ({}): repair it, its thickness and volume are not certain.</source>
        <translation>La surface se traverse elle-même, comme sous ({}) : réparez-la, son épaisseur et son volume ne sont pas certains.</translation>
    </message>
    <message>
        <source>The surface was inside-out and has been turned round.</source>
        <translation>La surface était à l’envers et a été retournée.</translation>
    </message>
    <message>
        <source>The table {} cannot be written ({}): give another file to --csv.</source>
        <translation>Le tableau {} ne peut pas être écrit ({}) : donnez un autre fichier à --csv.</translation>
    </message>
    <message>
        <source>The thickness map {} cannot be read: measure the part again.</source>
        <translation>La carte des épaisseurs {} ne peut pas être lue : mesurez la pièce à nouveau.</translation>
    </message>
    <message>
        <source>The thickness map {} is of a newer ThinPart: update ThinPart or measure the part again.</source>
        <translation>La carte des épaisseurs {} vient d’un ThinPart plus récent : mettez ThinPart à jour ou mesurez la pièce à nouveau.</translation>
    </message>
    <message>
        <source>The thinnest wall, {} mm, is known no better than the mesh resolves ({} mm).</source>
        <translation>La paroi la plus mince, {} mm, n’est pas connue mieux que la résolution du maillage ({} mm).</translation>
    </message>
    <message>
        <source>The triangles are not consistently oriented, so it has no certain volume.</source>
        <translation>Les triangles ne sont pas orientés de façon cohérente, le volume n’est donc pas certain.</translation>
    </message>
    <message>
        <source>The worker processes end as soon as they start: try a larger --memory, or fewer --jobs.</source>
        <translation>Les processus de travail se terminent dès leur démarrage : essayez avec plus de mémoire (--memory) ou moins de fichiers simultanés (--jobs).</translation>
    </message>
    <message>
        <source>The {} cannot be {}: it may be {} to {} {}.</source>
        <translation>{} : {} n’est pas permis, seulement de {} à {} {}.</translation>
    </message>
    <message>
        <source>There are no parts in {}: name a CAD file or a folder that holds some.</source>
        <translation>Il n’y a pas de pièces dans {} : nommez un fichier CAO ou un dossier qui en contient.</translation>
    </message>
    <message>
        <source>There is no box {}: use minimal or principal.</source>
        <translation>La boîte {} n’existe pas : utilisez minimal ou principal.</translation>
    </message>
    <message>
        <source>There is no closed solid in '{}': select a solid, a body, or a face of one.</source>
        <translation>Il n’y a pas de solide fermé dans « {} » : sélectionnez un solide, un corps ou une de ses faces.</translation>
    </message>
    <message>
        <source>There is no closed solid in the document '{}': make or import a solid first.</source>
        <translation>Il n’y a pas de solide fermé dans le document « {} » : créez ou importez d’abord un solide.</translation>
    </message>
    <message>
        <source>There is no file {} any more.</source>
        <translation>Le fichier {} n’existe plus.</translation>
    </message>
    <message>
        <source>There is no file {}.</source>
        <translation>Le fichier {} n’existe pas.</translation>
    </message>
    <message>
        <source>There is no file {}: --mesh takes a JSON object or a file.</source>
        <translation>Le fichier {} n’existe pas : les paramètres de maillage sont un objet JSON ou un fichier.</translation>
    </message>
    <message>
        <source>There is no folder {} any more: bring it back, or remove it from the list.</source>
        <translation>Le dossier {} n’existe plus : rétablissez-le ou retirez-le de la liste.</translation>
    </message>
    <message>
        <source>There is no home folder</source>
        <translation>Il n’y a pas de dossier personnel</translation>
    </message>
    <message>
        <source>There is no info file {}: classify {} first, or name the folder of its info file with --info-dir.</source>
        <translation>Le fichier d’information {} n’existe pas : classifiez d’abord {}, ou nommez le dossier du fichier avec --info-dir.</translation>
    </message>
    <message>
        <source>There is no measure {}: use rays or pairs.</source>
        <translation>La méthode de mesure {} n’existe pas : utilisez rays ou pairs.</translation>
    </message>
    <message>
        <source>There is no place for temporary files ({}): make room, or name another folder in TMPDIR.</source>
        <translation>Il n’y a pas de place pour les fichiers temporaires ({}) : faites de la place ou nommez un autre dossier dans TMPDIR.</translation>
    </message>
    <message>
        <source>There is no profile {}: give a file or one of {}.</source>
        <translation>Le profil {} n’existe pas : donnez un fichier ou un de {}.</translation>
    </message>
    <message>
        <source>There is no quantity {} in the condition {}: there are {}.</source>
        <translation>La grandeur {} de la condition {} n’existe pas : il y a {}.</translation>
    </message>
    <message>
        <source>Thin part</source>
        <translation>Pièce mince</translation>
    </message>
    <message>
        <source>Thin walls over most of its surface</source>
        <translation>Parois minces sur presque toute la surface</translation>
    </message>
    <message>
        <source>Thinner wall beside a thick body</source>
        <translation>Paroi plus mince à côté d’un corps épais</translation>
    </message>
    <message>
        <source>This may be an older shape of '{}', because its last recompute failed ({}): repair it and recompute the document.</source>
        <translation>Il s’agit peut-être d’une ancienne forme de « {} », car son dernier recalcul a échoué ({}) : réparez l’objet et recalculez le document.</translation>
    </message>
    <message>
        <source>This may be an older shape of '{}', because the last recompute of '{}', which it is made with, failed ({}): repair it and recompute the document.</source>
        <translation>Il s’agit peut-être d’une ancienne forme de « {} », car le dernier recalcul de « {} », dont il dépend, a échoué ({}) : réparez l’objet et recalculez le document.</translation>
    </message>
    <message>
        <source>Very thin wall on a filled part</source>
        <translation>Paroi très mince sur une pièce pleine</translation>
    </message>
    <message>
        <source>Volume of the part</source>
        <translation>Volume de la pièce</translation>
    </message>
    <message>
        <source>Wall thickness</source>
        <translation>Épaisseur</translation>
    </message>
    <message>
        <source>a criterion without conditions would always hold</source>
        <translation>un critère sans conditions serait toujours rempli</translation>
    </message>
    <message>
        <source>a threshold must be finite</source>
        <translation>un seuil doit être fini</translation>
    </message>
    <message>
        <source>an entry has no header</source>
        <translation>une entrée n'a pas d'en-tête</translation>
    </message>
    <message>
        <source>an entry has two names</source>
        <translation>une entrée a deux noms</translation>
    </message>
    <message>
        <source>an entry is called '{}'</source>
        <translation>une entrée se nomme « {} »</translation>
    </message>
    <message>
        <source>an entry is cut off</source>
        <translation>une entrée est tronquée</translation>
    </message>
    <message>
        <source>an info file is damaged, foreign or of a newer version</source>
        <translation>un fichier d’information est endommagé, étranger ou d’une version plus récente</translation>
    </message>
    <message>
        <source>an unforeseen failure</source>
        <translation>une erreur imprévue</translation>
    </message>
    <message>
        <source>angular deflection</source>
        <translation>Déflexion angulaire</translation>
    </message>
    <message>
        <source>box as flat</source>
        <translation>boîte aussi plate</translation>
    </message>
    <message>
        <source>box as long</source>
        <translation>boîte aussi longue</translation>
    </message>
    <message>
        <source>comparison {} is neither &lt; nor &gt;</source>
        <translation>la comparaison {} n’est ni &lt; ni &gt;</translation>
    </message>
    <message>
        <source>coordinates are not numbers</source>
        <translation>des coordonnées ne sont pas des nombres</translation>
    </message>
    <message>
        <source>different wall distribution</source>
        <translation>répartition des parois différente</translation>
    </message>
    <message>
        <source>far fewer slanted walls</source>
        <translation>beaucoup moins de parois obliques</translation>
    </message>
    <message>
        <source>far more slanted walls</source>
        <translation>beaucoup plus de parois obliques</translation>
    </message>
    <message>
        <source>fewer slanted walls</source>
        <translation>moins de parois obliques</translation>
    </message>
    <message>
        <source>fill not comparable</source>
        <translation>remplissage non comparable</translation>
    </message>
    <message>
        <source>flatter box</source>
        <translation>boîte plus plate</translation>
    </message>
    <message>
        <source>it is a file</source>
        <translation>c’est un fichier</translation>
    </message>
    <message>
        <source>it is no regular file</source>
        <translation>ce n'est pas un fichier ordinaire</translation>
    </message>
    <message>
        <source>it stores a file as '{}'</source>
        <translation>il range un fichier sous « {} »</translation>
    </message>
    <message>
        <source>it stores a resource as '{}'</source>
        <translation>il range une ressource sous « {} »</translation>
    </message>
    <message>
        <source>its {} declares entities of its own</source>
        <translation>son {} déclare ses propres entités</translation>
    </message>
    <message>
        <source>its {} would be larger than {} GB</source>
        <translation>son {} dépasserait {} Go</translation>
    </message>
    <message>
        <source>less filled</source>
        <translation>moins remplie</translation>
    </message>
    <message>
        <source>less flat box</source>
        <translation>boîte moins plate</translation>
    </message>
    <message>
        <source>linear deflection</source>
        <translation>Déflexion linéaire</translation>
    </message>
    <message>
        <source>longer box</source>
        <translation>boîte plus longue</translation>
    </message>
    <message>
        <source>more filled</source>
        <translation>plus remplie</translation>
    </message>
    <message>
        <source>more slanted walls</source>
        <translation>plus de parois obliques</translation>
    </message>
    <message>
        <source>much flatter box</source>
        <translation>boîte beaucoup plus plate</translation>
    </message>
    <message>
        <source>much less filled</source>
        <translation>beaucoup moins remplie</translation>
    </message>
    <message>
        <source>much less flat box</source>
        <translation>boîte beaucoup moins plate</translation>
    </message>
    <message>
        <source>much longer box</source>
        <translation>boîte beaucoup plus longue</translation>
    </message>
    <message>
        <source>much more filled</source>
        <translation>beaucoup plus remplie</translation>
    </message>
    <message>
        <source>much shorter box</source>
        <translation>boîte beaucoup plus courte</translation>
    </message>
    <message>
        <source>no reason given</source>
        <translation>aucune raison donnée</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>non mesuré</translation>
    </message>
    <message>
        <source>of the diagonal</source>
        <translation>de la diagonale</translation>
    </message>
    <message>
        <source>same fill</source>
        <translation>même remplissage</translation>
    </message>
    <message>
        <source>same wall distribution</source>
        <translation>même répartition des parois</translation>
    </message>
    <message>
        <source>share of the diagonal</source>
        <translation>part de la diagonale</translation>
    </message>
    <message>
        <source>shorter box</source>
        <translation>boîte plus courte</translation>
    </message>
    <message>
        <source>similar wall distribution</source>
        <translation>répartition des parois similaire</translation>
    </message>
    <message>
        <source>stopped as asked</source>
        <translation>arrêté comme demandé</translation>
    </message>
    <message>
        <source>the cluster cannot be used</source>
        <translation>la grappe de calcul n’est pas utilisable</translation>
    </message>
    <message>
        <source>the command was called wrongly</source>
        <translation>la commande a été mal appelée</translation>
    </message>
    <message>
        <source>the file is damaged or not what its name says</source>
        <translation>le fichier est endommagé ou n’est pas ce que dit son nom</translation>
    </message>
    <message>
        <source>the file may not be read</source>
        <translation>le fichier ne peut pas être lu</translation>
    </message>
    <message>
        <source>the file or document holds nothing</source>
        <translation>le fichier ou le document est vide</translation>
    </message>
    <message>
        <source>the file would write where it must not</source>
        <translation>le fichier écrirait là où il ne doit pas</translation>
    </message>
    <message>
        <source>the format cannot be read here</source>
        <translation>le format ne peut pas être lu ici</translation>
    </message>
    <message>
        <source>the info file could not be written</source>
        <translation>le fichier d’information n’a pas pu être écrit</translation>
    </message>
    <message>
        <source>the memory limit was reached</source>
        <translation>la limite de mémoire a été atteinte</translation>
    </message>
    <message>
        <source>the part encloses no volume</source>
        <translation>la pièce n’enferme aucun volume</translation>
    </message>
    <message>
        <source>the part has gone from the index since it was found</source>
        <translation>la pièce n’est plus dans l’index</translation>
    </message>
    <message>
        <source>the pool broke down</source>
        <translation>les processus de travail sont tombés en panne</translation>
    </message>
    <message>
        <source>the pool takes no tasks any more</source>
        <translation>les processus de travail n’acceptent plus de tâches</translation>
    </message>
    <message>
        <source>the profile</source>
        <translation>Le profil</translation>
    </message>
    <message>
        <source>the profile is not usable</source>
        <translation>le profil n’est pas utilisable</translation>
    </message>
    <message>
        <source>the reading process died</source>
        <translation>le processus de lecture s’est arrêté brutalement</translation>
    </message>
    <message>
        <source>the time limit was reached</source>
        <translation>la limite de temps a été atteinte</translation>
    </message>
    <message>
        <source>there is no closed solid in it</source>
        <translation>il n’y a pas de solide fermé dedans</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>ce fichier n’existe pas</translation>
    </message>
    <message>
        <source>two entries are called '{}'</source>
        <translation>deux entrées se nomment « {} »</translation>
    </message>
    <message>
        <source>unknown kind of failure: {}</source>
        <translation>type d’échec inconnu : {}</translation>
    </message>
    <message>
        <source>{} It was left as it is: move it away to have it written anew.</source>
        <translation>{} Il est resté inchangé : déplacez-le pour qu’il soit réécrit.</translation>
    </message>
    <message>
        <source>{} bytes after its last entry belong to none</source>
        <translation>{} octets après la dernière entrée n'appartiennent à aucune</translation>
    </message>
    <message>
        <source>{} bytes that belong to no entry lie before '{}'</source>
        <translation>{} octets qui n'appartiennent à aucune entrée précèdent « {} »</translation>
    </message>
    <message>
        <source>{} cannot be read ({}).</source>
        <translation>{} ne peut pas être lu ({}).</translation>
    </message>
    <message>
        <source>{} changed while it was read: classify it again.</source>
        <translation>{} a changé pendant la lecture : classifiez à nouveau ce fichier.</translation>
    </message>
    <message>
        <source>{} could not be measured, so criterion {} cannot be told.</source>
        <translation>{} n’a pas pu être mesuré, le critère {} reste donc indécis.</translation>
    </message>
    <message>
        <source>{} defines 'normal' or 'unknown', which stand for themselves.</source>
        <translation>{} définit « normal » ou « unknown », qui sont réservés.</translation>
    </message>
    <message>
        <source>{} does not lie below {}: name a folder after --info-tree that holds all PATHs.</source>
        <translation>{} n’est pas sous {} : nommez avec --info-tree un dossier qui contient tous les PATHs.</translation>
    </message>
    <message>
        <source>{} duplicate triangles were left out.</source>
        <translation>{} triangles en double ont été omis.</translation>
    </message>
    <message>
        <source>{} ended the process that read it: the file is likely damaged.</source>
        <translation>{} a fait planter le processus de lecture : le fichier est probablement endommagé.</translation>
    </message>
    <message>
        <source>{} failed ({}).</source>
        <translation>{} a échoué ({}).</translation>
    </message>
    <message>
        <source>{} failed ({}: {}).</source>
        <translation>{} a échoué ({} : {}).</translation>
    </message>
    <message>
        <source>{} has coordinates that are not finite numbers: export it again.</source>
        <translation>{} a des coordonnées qui ne sont pas des nombres finis : exportez-le à nouveau.</translation>
    </message>
    <message>
        <source>{} has faces with more than four corners, which FreeCAD leaves out: triangulate it first.</source>
        <translation>{} a des faces à plus de quatre sommets, que FreeCAD omet : triangulez-le d’abord.</translation>
    </message>
    <message>
        <source>{} has no ending that ThinPart reads ({}).</source>
        <translation>{} n’a pas d’extension que ThinPart sait lire ({}).</translation>
    </message>
    <message>
        <source>{} has no part {}: it has {}.</source>
        <translation>{} n’a pas de pièce {} : il a {}.</translation>
    </message>
    <message>
        <source>{} has version {}; this ThinPart reads version {}: use a newer one.</source>
        <translation>{} a la version {} ; ce ThinPart lit la version {} : utilisez-en un plus récent.</translation>
    </message>
    <message>
        <source>{} has version {}; this reads version 1.</source>
        <translation>{} a la version {} ; seule la version 1 est lue.</translation>
    </message>
    <message>
        <source>{} holds 1 face beside its solids, which was left out: close or thicken it if it is a part.</source>
        <translation>{} contient, outre ses solides, 1 face qui a été omise : fermez-la ou épaississez-la si c’est une pièce.</translation>
    </message>
    <message>
        <source>{} holds no closed solid, only surfaces, wires or points: close or thicken it first.</source>
        <translation>{} ne contient pas de solide fermé, seulement des surfaces, des fils ou des points : fermez ou épaississez les surfaces d’abord.</translation>
    </message>
    <message>
        <source>{} holds {} faces beside its solids, which were left out: close or thicken them if they are a part.</source>
        <translation>{} contient, outre ses solides, {} faces qui ont été omises : fermez-les ou épaississez-les si elles forment une pièce.</translation>
    </message>
    <message>
        <source>{} holds {} parts: say which one is meant with --part, by name or label: {}.</source>
        <translation>{} contient {} pièces : indiquez laquelle avec --part, par son nom ou son étiquette : {}.</translation>
    </message>
    <message>
        <source>{} in the condition {} is not a number.</source>
        <translation>{} dans la condition {} n’est pas un nombre.</translation>
    </message>
    <message>
        <source>{} is a link that leads back to itself: remove it or link it to a part.</source>
        <translation>{} est un lien qui mène à lui-même : retirez-le ou liez-le à une pièce.</translation>
    </message>
    <message>
        <source>{} is a link that leads nowhere: remove it or link it to a part.</source>
        <translation>{} est un lien qui ne mène nulle part : retirez-le ou liez-le à une pièce.</translation>
    </message>
    <message>
        <source>{} is a part, not a table, and was left as it is: name a .csv file after --csv.</source>
        <translation>{} est une pièce et non un tableau, et est resté inchangé : nommez un fichier .csv après --csv.</translation>
    </message>
    <message>
        <source>{} is an empty document.</source>
        <translation>{} est un document vide.</translation>
    </message>
    <message>
        <source>{} is damaged or holds no shape.</source>
        <translation>{} est endommagé ou ne contient aucune forme.</translation>
    </message>
    <message>
        <source>{} is damaged or no FreeCAD document ({}).</source>
        <translation>{} est endommagé ou n’est pas un document FreeCAD ({}).</translation>
    </message>
    <message>
        <source>{} is damaged or not what its ending says ({}).</source>
        <translation>{} est endommagé ou n’est pas ce que dit son extension ({}).</translation>
    </message>
    <message>
        <source>{} is damaged, or its faces are no triangles: triangulate it first.</source>
        <translation>{} est endommagé, ou ses faces ne sont pas des triangles : triangulez-le d’abord.</translation>
    </message>
    <message>
        <source>{} is empty (0 bytes).</source>
        <translation>{} est vide (0 octet).</translation>
    </message>
    <message>
        <source>{} is no JSON object ({}).</source>
        <translation>{} : pas un objet JSON ({}).</translation>
    </message>
    <message>
        <source>{} is no JSON object.</source>
        <translation>{} : pas un objet JSON.</translation>
    </message>
    <message>
        <source>{} is no number of JSON</source>
        <translation>{} n’est pas un nombre en JSON</translation>
    </message>
    <message>
        <source>{} is not a ThinPart info file.</source>
        <translation>{} n’est pas un fichier d’information de ThinPart.</translation>
    </message>
    <message>
        <source>{} is not a ThinPart profile.</source>
        <translation>{} n’est pas un profil de ThinPart.</translation>
    </message>
    <message>
        <source>{} is not well formed: {}.</source>
        <translation>{} est mal formé : {}.</translation>
    </message>
    <message>
        <source>{} is there already and holds something else than a report: it was left as it is; give a new or an empty folder.</source>
        <translation>{} existe déjà et contient autre chose qu’un rapport : il est resté inchangé ; indiquez un dossier nouveau ou vide.</translation>
    </message>
    <message>
        <source>{} is there already and is no table of ThinPart: it was left as it is; give another file to --csv.</source>
        <translation>{} existe déjà et n’est pas un tableau de ThinPart : il est resté inchangé ; donnez un autre fichier à --csv.</translation>
    </message>
    <message>
        <source>{} is too large</source>
        <translation>{} est trop grand</translation>
    </message>
    <message>
        <source>{} is too large for an info file.</source>
        <translation>{} est trop grand pour un fichier d’information.</translation>
    </message>
    <message>
        <source>{} is truncated or no STL file: it announces {} triangles and holds {}.</source>
        <translation>{} est tronqué ou n’est pas un fichier STL : il annonce {} triangles et en contient {}.</translation>
    </message>
    <message>
        <source>{} is truncated: its end is missing.</source>
        <translation>{} est tronqué : la fin manque.</translation>
    </message>
    <message>
        <source>{} lacks or does not know {}.</source>
        <translation>{} : manquant ou inconnu : {}.</translation>
    </message>
    <message>
        <source>{} may not be read: check its permissions.</source>
        <translation>{} ne peut pas être lu : vérifiez ses droits d’accès.</translation>
    </message>
    <message>
        <source>{} needs more memory than it may have.</source>
        <translation>{} demande plus de mémoire que permis.</translation>
    </message>
    <message>
        <source>{} needs more memory than {} MB.</source>
        <translation>{} demande plus de {} Mo de mémoire.</translation>
    </message>
    <message>
        <source>{} needs more than {} MB of memory: raise the limit in the preferences.</source>
        <translation>{} demande plus de {} Mo de mémoire : augmentez la limite dans les préférences.</translation>
    </message>
    <message>
        <source>{} took longer than {} s, the limit for one file.</source>
        <translation>{} a pris plus de {} s, la limite pour un fichier.</translation>
    </message>
    <message>
        <source>{} triangles of zero area were left out.</source>
        <translation>{} triangles d’aire nulle ont été omis.</translation>
    </message>
    <message>
        <source>{} uses a criterion's id twice.</source>
        <translation>{} utilise deux fois le même identifiant de critère.</translation>
    </message>
    <message>
        <source>{} was not opened: {}, so it would write outside its own folder or hide what it holds. Get it from somebody whom you trust.</source>
        <translation>{} n'a pas été ouvert : {}, il écrirait donc hors de son propre dossier ou cacherait ce qu'il contient. Procurez-vous-le auprès de quelqu'un de confiance.</translation>
    </message>
    <message>
        <source>{} was written again meanwhile: classify it again.</source>
        <translation>{} a été réécrit entre-temps : classifiez-le à nouveau.</translation>
    </message>
</context>
<context>
    <name>ThinPart_Classify</name>
    <message>
        <source>Classify part</source>
        <translation>Classifier la pièce</translation>
    </message>
    <message>
        <source>Tells whether the selected part is thin, has thin features or is normal, and colours its thin faces</source>
        <translation>Indique si la pièce sélectionnée est mince, a des zones minces ou est normale, et colore ses faces minces</translation>
    </message>
</context>
<context>
    <name>ThinPart_ClassifyFolder</name>
    <message>
        <source>Classifies all parts of a folder in the background and shows them in a table</source>
        <translation>Classifie toutes les pièces d’un dossier en arrière-plan et les affiche dans un tableau</translation>
    </message>
    <message>
        <source>Classify folder…</source>
        <translation>Classifier un dossier…</translation>
    </message>
</context>
<context>
    <name>ThinPart_ClearColours</name>
    <message>
        <source>Clear thin colours</source>
        <translation>Effacer les couleurs de minceur</translation>
    </message>
    <message>
        <source>Gives the faces of this document the colours back that they had before they were coloured as thin</source>
        <translation>Rend aux faces de ce document les couleurs qu’elles avaient avant d’être colorées comme minces</translation>
    </message>
</context>
<context>
    <name>ThinPart_FindParts</name>
    <message>
        <source>Find parts</source>
        <translation>Trouver des pièces</translation>
    </message>
    <message>
        <source>Shows or hides the panel that finds classified parts by their category, walls, size and notes, and parts like another one</source>
        <translation>Affiche ou masque le panneau qui trouve les pièces classifiées par catégorie, parois, taille et notes, et les pièces similaires à une autre</translation>
    </message>
</context>
<context>
    <name>ThinPart_Preferences</name>
    <message>
        <source>Opens the preferences: thresholds, surface mesh, info files, colours and automatic classification</source>
        <translation>Ouvre les préférences : seuils, maillage de surface, fichiers d’information, couleurs et classification automatique</translation>
    </message>
    <message>
        <source>ThinPart preferences…</source>
        <translation>Préférences de ThinPart…</translation>
    </message>
</context>
<context>
    <name>ThinPart_Report</name>
    <message>
        <source>Report…</source>
        <translation>Rapport…</translation>
    </message>
    <message>
        <source>Writes a page with pictures, walls and criteria about every part of the document, to read, print or hand on</source>
        <translation>Écrit une page avec images, parois et critères sur chaque pièce du document, à lire, imprimer ou transmettre</translation>
    </message>
</context>
<context>
    <name>ThinPart_ShowThickness</name>
    <message>
        <source>Colours the selected parts, or all of them, by the thickness of their walls, and tells how much of the surface lies over which wall</source>
        <translation>Colore les pièces sélectionnées, ou toutes, selon l’épaisseur de leurs parois, et indique quelle part de la surface a quelle paroi</translation>
    </message>
    <message>
        <source>Show thickness</source>
        <translation>Afficher l’épaisseur</translation>
    </message>
</context>
</TS>
