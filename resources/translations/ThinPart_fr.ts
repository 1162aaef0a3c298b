<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>Colour where no wall was measured</source>
        <translation>Couleur là où aucune paroi n’a été mesurée</translation>
    </message>
    <message>
        <source>Colours from thin to thick</source>
        <translation>Couleurs du mince à l’épais</translation>
    </message>
    <message>
        <source>Diagonal of the largest part's bounding box, mm</source>
        <translation>Diagonale de la boîte englobante de la plus grande pièce, mm</translation>
    </message>
    <message>
        <source>Greatest wall that the process allows, mm; 0: any</source>
        <translation>Paroi la plus épaisse que le procédé admet, mm ; 0 : toutes</translation>
    </message>
    <message>
        <source>How it was measured: across the wall, or as the largest ball inside</source>
        <translation>Mode de mesure : à travers la paroi, ou plus grande boule à l’intérieur</translation>
    </message>
    <message>
        <source>Measured point on the face, in the coordinates of its object</source>
        <translation>Point mesuré sur la face, dans les coordonnées de son objet</translation>
    </message>
    <message>
        <source>Number of steps; 0: smooth</source>
        <translation>Nombre de paliers ; 0 : continu</translation>
    </message>
    <message>
        <source>Opposite point, in the coordinates of the document</source>
        <translation>Point opposé, dans les coordonnées du document</translation>
    </message>
    <message>
        <source>Placements of the sources when they were measured</source>
        <translation>Position des sources lors de la mesure</translation>
    </message>
    <message>
        <source>Points opposite the probed points</source>
        <translation>Points opposés aux points sondés</translation>
    </message>
    <message>
        <source>Points where the thickness was probed</source>
        <translation>Points où l’épaisseur a été sondée</translation>
    </message>
    <message>
        <source>Process whose walls are at least Threshold and at most CheckMost</source>
        <translation>Procédé dont les parois font au moins Threshold et au plus CheckMost</translation>
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
        <source>The sources' shapes when measured</source>
        <translation>Les formes des sources lors de la mesure</translation>
    </message>
    <message>
        <source>The thickness before the sources were changed last</source>
        <translation>L’épaisseur avant la dernière modification des sources</translation>
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
        <source>Transparency of the facets, in percent</source>
        <translation>Transparence des facettes, en pourcentage</translation>
    </message>
    <message>
        <source>Unit of Low and High</source>
        <translation>Unité de Low et High</translation>
    </message>
    <message>
        <source>Wall thickness at the measured point</source>
        <translation>Épaisseur de la paroi au point mesuré</translation>
    </message>
    <message>
        <source>Wall thickness at the probed points, mm</source>
        <translation>Épaisseur de la paroi aux points sondés, mm</translation>
    </message>
    <message>
        <source>Walls thinner than this are thin, mm</source>
        <translation>Les parois sous cette épaisseur sont minces, mm</translation>
    </message>
    <message>
        <source>What was measured</source>
        <translation>Ce qui a été mesuré</translation>
    </message>
    <message>
        <source>Whether colours run from the thinnest to the thickest wall</source>
        <translation>Si les couleurs vont de la paroi la plus mince à la plus épaisse</translation>
    </message>
    <message>
        <source>Whether equal ratios of thickness are equally far apart on the scale</source>
        <translation>Si des rapports d'épaisseur égaux sont également espacés sur l'échelle</translation>
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
        <source>Whether the map is lit; off: flat colours, exactly those of the colour bar</source>
        <translation>Si la carte est éclairée ; sinon : couleurs plates, exactement celles de la barre de couleurs</translation>
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
        <source>&amp;Back</source>
        <translation>&amp;Retour</translation>
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
        <source>&amp;Colours show</source>
        <translation>Les &amp;couleurs montrent</translation>
    </message>
    <message>
        <source>&amp;Contents</source>
        <translation>&amp;Sommaire</translation>
    </message>
    <message>
        <source>&amp;Exclude…</source>
        <translation>&amp;Exclure…</translation>
    </message>
    <message>
        <source>&amp;Export CSV…</source>
        <translation>E&amp;xporter en CSV…</translation>
    </message>
    <message>
        <source>&amp;Fly to thinnest wall</source>
        <translation>Aller à la paroi la plus minc&amp;e</translation>
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
        <source>&amp;Forward</source>
        <translation>&amp;Suivant</translation>
    </message>
    <message>
        <source>&amp;Isolate</source>
        <translation>&amp;Isoler</translation>
    </message>
    <message>
        <source>&amp;Keep measuring</source>
        <translation>&amp;Continuer à mesurer</translation>
    </message>
    <message>
        <source>&amp;Learn</source>
        <translation>&amp;Apprendre</translation>
    </message>
    <message>
        <source>&amp;Library</source>
        <translation>&amp;Bibliothèque</translation>
    </message>
    <message>
        <source>&amp;Logarithmic</source>
        <translation>&amp;Logarithmique</translation>
    </message>
    <message>
        <source>&amp;Measure again</source>
        <translation>Mesurer à &amp;nouveau</translation>
    </message>
    <message>
        <source>&amp;Measure unchanged documents again</source>
        <translation>Mesu&amp;rer à nouveau les documents inchangés</translation>
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
        <source>&amp;Open…</source>
        <translation>&amp;Ouvrir…</translation>
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
        <source>&amp;Profile:</source>
        <translation>&amp;Profil :</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Retirer</translation>
    </message>
    <message>
        <source>&amp;Remove its limits</source>
        <translation>&amp;Supprimer ses limites</translation>
    </message>
    <message>
        <source>&amp;Remove mesh size</source>
        <translation>&amp;Supprimer la taille de maille</translation>
    </message>
    <message>
        <source>&amp;Reset to saved</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>&amp;Retry failed</source>
        <translation>Réessa&amp;yer les échecs</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>&amp;Save as…</source>
        <translation>&amp;Enregistrer sous…</translation>
    </message>
    <message>
        <source>&amp;Shaded</source>
        <translation>&amp;Ombré</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>Démarr&amp;er</translation>
    </message>
    <message>
        <source>&amp;Stop it</source>
        <translation>&amp;Arrêter</translation>
    </message>
    <message>
        <source>&amp;Tables</source>
        <translation>&amp;Tableaux</translation>
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
        <source>&amp;Use as my profile</source>
        <translation>&amp;Utiliser comme mon profil</translation>
    </message>
    <message>
        <source>&amp;Use it</source>
        <translation>&amp;Utiliser</translation>
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
        <source>'normal' and 'unknown' mean that no criterion holds, or that it cannot be told: choose another name.</source>
        <translation>« normal » et « unknown » signifient qu’aucun critère n’est rempli ou que c’est indécidable : choisissez un autre nom.</translation>
    </message>
    <message>
        <source>'{}' has not been classified yet: classify the part first.</source>
        <translation>« {} » n’a pas encore été classifiée : classifiez d’abord la pièce.</translation>
    </message>
    <message>
        <source>'{}' is still being measured.</source>
        <translation>« {} » est encore en cours de mesure.</translation>
    </message>
    <message>
        <source>'{}' no longer has a part that can be measured.</source>
        <translation>« {} » n’a plus de pièce mesurable.</translation>
    </message>
    <message>
        <source>, layers in {} of the thin walls</source>
        <translation>, couches dans {} des parois minces</translation>
    </message>
    <message>
        <source>1 probe was removed: the surface is no longer at its position.</source>
        <translation>1 sonde a été retirée : la surface ne se trouve plus à cet endroit.</translation>
    </message>
    <message>
        <source>A click on the part pins the wall there</source>
        <translation>Un clic sur la pièce y fixe une sonde</translation>
    </message>
    <message>
        <source>A link to {} was put into {}.</source>
        <translation>Un lien vers {} a été placé dans {}.</translation>
    </message>
    <message>
        <source>A normal part: one size is enough. About {} elements of {}. Tick a wall to give it layers.</source>
        <translation>Une pièce normale : une seule taille suffit. Environ {} éléments de {}. Cochez une paroi pour lui donner des couches.</translation>
    </message>
    <message>
        <source>A part gets the first category of which a criterion holds. If none holds, it is normal.</source>
        <translation>Une pièce reçoit la première catégorie dont un critère est rempli. Si aucun ne l’est, elle est normale.</translation>
    </message>
    <message>
        <source>A profile that comes with ThinPart stays as it is: save under another name</source>
        <translation>Un profil fourni avec ThinPart reste inchangé : enregistrez sous un autre nom</translation>
    </message>
    <message>
        <source>A shell would take about {} triangles.</source>
        <translation>Une coque demanderait environ {} triangles.</translation>
    </message>
    <message>
        <source>A smaller share of the surface counts as none, because single rays may stray</source>
        <translation>Une part plus petite de la surface compte pour nulle, car des rayons isolés peuvent s’égarer</translation>
    </message>
    <message>
        <source>A verdict is called borderline if a quantity lies nearer to its threshold, relative to that</source>
        <translation>Un verdict est dit limite si une grandeur est plus proche de son seuil, relativement à celui-ci</translation>
    </message>
    <message>
        <source>A verdict that is less probable is called unsure</source>
        <translation>Un verdict moins probable est dit incertain</translation>
    </message>
    <message>
        <source>About {} elements as a solid, {} as a shell.</source>
        <translation>Environ {} éléments en volume, {} en coque.</translation>
    </message>
    <message>
        <source>About {} elements as a solid.</source>
        <translation>Environ {} éléments en volume.</translation>
    </message>
    <message>
        <source>About {} nodes ({} elements), of {} to {}, for an error of {} in deflections and frequencies. CalculiX takes about {} s for six frequencies.</source>
        <translation>Environ {} nœuds ({} éléments), de {} à {}, pour une erreur de {} sur les déformations et les fréquences. CalculiX prend environ {} s pour six fréquences.</translation>
    </message>
    <message>
        <source>About {} nodes ({} elements), of {} to {}.</source>
        <translation>Environ {} nœuds ({} éléments), de {} à {}.</translation>
    </message>
    <message>
        <source>About {} nodes: more than most analyses need.</source>
        <translation>Environ {} nœuds : plus que n'en demandent la plupart des calculs.</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Précision</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>Perpendiculaire à</translation>
    </message>
    <message>
        <source>Across the wall (ray)</source>
        <translation>À travers la paroi (rayon)</translation>
    </message>
    <message>
        <source>Add a category</source>
        <translation>Ajouter une catégorie</translation>
    </message>
    <message>
        <source>Add a condition (and)</source>
        <translation>Ajouter une condition (et)</translation>
    </message>
    <message>
        <source>Add a criterion (or)</source>
        <translation>Ajouter un critère (ou)</translation>
    </message>
    <message>
        <source>Add a folder with classified parts under 'Libraries'.</source>
        <translation>Ajoutez un dossier de pièces classifiées sous « Bibliothèques ».</translation>
    </message>
    <message>
        <source>Add a material</source>
        <translation>Ajouter un matériau</translation>
    </message>
    <message>
        <source>Add a process</source>
        <translation>Ajouter un procédé</translation>
    </message>
    <message>
        <source>Adds the folder to the libraries of 'Find parts', and opens that</source>
        <translation>Ajoute le dossier aux bibliothèques de « Trouver des pièces », et l’ouvre</translation>
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
        <source>Agreement</source>
        <translation>Accord</translation>
    </message>
    <message>
        <source>All labels, either answer</source>
        <translation>Toutes les étiquettes, une des réponses</translation>
    </message>
    <message>
        <source>All parts</source>
        <translation>Toutes les pièces</translation>
    </message>
    <message>
        <source>An unexpected error occurred ({}): try again, and if it happens again, report it with FreeCAD's log.</source>
        <translation>Une erreur inattendue s’est produite ({}) : réessayez et, si cela se reproduit, signalez-le avec le journal de FreeCAD.</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>Analyse</translation>
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
        <source>Another document</source>
        <translation>Autre document</translation>
    </message>
    <message>
        <source>Another folder…</source>
        <translation>Un autre dossier…</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>Réponses</translation>
    </message>
    <message>
        <source>Apart, {}</source>
        <translation>Écart, {}</translation>
    </message>
    <message>
        <source>Area of both of its sides</source>
        <translation>Aire de ses deux côtés</translation>
    </message>
    <message>
        <source>Area, {}²</source>
        <translation>Aire, {}²</translation>
    </message>
    <message>
        <source>As a picture of any size, or as triangles with their thickness for ParaView, MeshLab and others</source>
        <translation>Comme image de toute taille, ou comme triangles avec leur épaisseur pour ParaView, MeshLab et d'autres</translation>
    </message>
    <message>
        <source>As proposed: {}</source>
        <translation>Comme proposé : {}</translation>
    </message>
    <message>
        <source>Ask for this category earlier: a part gets the first one that applies</source>
        <translation>Examiner cette catégorie plus tôt : une pièce reçoit la première qui convient</translation>
    </message>
    <message>
        <source>Ask for this category later: a part gets the first one that applies</source>
        <translation>Examiner cette catégorie plus tard : une pièce reçoit la première qui convient</translation>
    </message>
    <message>
        <source>At least</source>
        <translation>Au moins</translation>
    </message>
    <message>
        <source>At least, {}</source>
        <translation>Au moins, {}</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Au plus</translation>
    </message>
    <message>
        <source>At most, {}</source>
        <translation>Au plus, {}</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>Back to its place</source>
        <translation>Remettre à sa place</translation>
    </message>
    <message>
        <source>Back to the shipped limits</source>
        <translation>Revenir aux limites fournies</translation>
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
        <source>Before, {}</source>
        <translation>Avant, {}</translation>
    </message>
    <message>
        <source>Borderline within</source>
        <translation>Cas limite à moins de</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Dessous</translation>
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
        <source>By which the process is chosen, as in --check</source>
        <translation>Par lequel le procédé est choisi, comme dans --check</translation>
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
        <source>Cancelled.</source>
        <translation>Annulé.</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was changed.</source>
        <translation>Annulé. Rien n’a été modifié.</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was written.</source>
        <translation>Annulé. Rien n’a été écrit.</translation>
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
        <source>Chec&amp;k</source>
        <translation>&amp;Vérifier</translation>
    </message>
    <message>
        <source>Chec&amp;k for</source>
        <translation>Vérifier po&amp;ur</translation>
    </message>
    <message>
        <source>Check before meshing whether a part is thin, and where</source>
        <translation>Vérifier avant le maillage si une pièce est mince, et où</translation>
    </message>
    <message>
        <source>Check for</source>
        <translation>Vérifier pour</translation>
    </message>
    <message>
        <source>Checks compare the least wall with the thickness across the wall, and the greatest with the largest balls inside: choose the thickness across the wall under 'Colours show' to see where the limits are broken.</source>
        <translation>Les contrôles comparent la paroi minimale à l’épaisseur à travers la paroi, et la maximale aux plus grandes boules à l’intérieur : choisissez l’épaisseur à travers la paroi sous « Les couleurs montrent » pour voir où les limites ne sont pas respectées.</translation>
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
        <source>Choose a folder with classified parts, or add one under 'Libraries' in the panel 'Find parts'.</source>
        <translation>Choisissez un dossier de pièces classifiées, ou ajoutez-en un sous « Bibliothèques » dans le panneau « Trouver des pièces ».</translation>
    </message>
    <message>
        <source>Choose a part in the list to see its faces.</source>
        <translation>Choisissez une pièce dans la liste pour voir ses faces.</translation>
    </message>
    <message>
        <source>Choose a part in the list to see its walls.</source>
        <translation>Choisissez une pièce dans la liste pour voir ses parois.</translation>
    </message>
    <message>
        <source>Choose at least one format.</source>
        <translation>Choisissez au moins un format.</translation>
    </message>
    <message>
        <source>Choose tables of labels</source>
        <translation>Choisir des tableaux d’étiquettes</translation>
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
        <source>Choose the folder with the labelled parts.</source>
        <translation>Choisissez le dossier des pièces étiquetées.</translation>
    </message>
    <message>
        <source>Chooses the thresholds that agree most often with what people say of parts: by 'Not right?' beside a verdict, or in tables. Folders that were left out show how good they are.</source>
        <translation>Choisit les seuils qui concordent le plus souvent avec ce que l’on dit des pièces : par « Pas exact ? » à côté d’un verdict, ou dans des tableaux. Des dossiers mis de côté montrent leur qualité.</translation>
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
        <source>Classifying again by another profile</source>
        <translation>Nouveau classement selon un autre profil</translation>
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
        <source>Click to close this message.</source>
        <translation>Cliquez pour retirer ce message.</translation>
    </message>
    <message>
        <source>Click to show its window.</source>
        <translation>Cliquez pour afficher sa fenêtre.</translation>
    </message>
    <message>
        <source>Click: fly to its thinnest place. N, P: to the next and the previous one.</source>
        <translation>Clic : voler vers son endroit le plus mince. N, P : vers le suivant et le précédent.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Colour bar</source>
        <translation>Barre de couleurs</translation>
    </message>
    <message>
        <source>Colour in the view what only one of the two parts has; the document stays as it is</source>
        <translation>Colorer dans la vue ce que l’une des deux pièces est seule à avoir ; le document reste tel quel</translation>
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
        <source>Coloured where the two are more than {} apart; at most it is {}.</source>
        <translation>Coloré là où les deux sont distantes de plus de {} ; au plus, c’est {}.</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Couleurs</translation>
    </message>
    <message>
        <source>Colours and shares are of the largest balls inside, which shrink to nothing towards sharp edges; the line above is of the thickness across the wall.</source>
        <translation>Les couleurs et les parts sont celles des plus grandes boules à l'intérieur, qui disparaissent vers les arêtes vives ; la ligne ci-dessus concerne l'épaisseur à travers la paroi.</translation>
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
        <source>Compared: {} parts. Groups: {}. Parts besides those to keep: {}.</source>
        <translation>Comparées : {} pièces. Groupes : {}. Pièces en plus de celles à garder : {}.</translation>
    </message>
    <message>
        <source>Compared: {} parts. None of them is there twice, mirrored, in another size, or alike.</source>
        <translation>Comparées : {} pièces. Aucune n’existe en double, en miroir, dans une autre taille, ou semblable.</translation>
    </message>
    <message>
        <source>Comparing the two…</source>
        <translation>Comparaison des deux…</translation>
    </message>
    <message>
        <source>Comparing: {} of {}</source>
        <translation>Comparaison : {} sur {}</translation>
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
        <source>Connected walls of like thickness</source>
        <translation>Parois continues d’épaisseur semblable</translation>
    </message>
    <message>
        <source>Continue in the background? 'Classify folder' shows the progress again. Finished results are saved either way.</source>
        <translation>Continuer en arrière-plan ? « Classifier un dossier » affiche à nouveau la progression. Les résultats obtenus restent enregistrés dans tous les cas.</translation>
    </message>
    <message>
        <source>Copied: {}</source>
        <translation>Copié : {}</translation>
    </message>
    <message>
        <source>Copy path</source>
        <translation>Copier le chemin</translation>
    </message>
    <message>
        <source>Counting…</source>
        <translation>Décompte en cours…</translation>
    </message>
    <message>
        <source>Criteria</source>
        <translation>Critères</translation>
    </message>
    <message>
        <source>Criteria and their quantities</source>
        <translation>Critères et leurs grandeurs</translation>
    </message>
    <message>
        <source>Criteria that hold (none chosen: any)</source>
        <translation>Critères remplis (aucun choisi : tous)</translation>
    </message>
    <message>
        <source>Criterion</source>
        <translation>Critère</translation>
    </message>
    <message>
        <source>Criterion {}: {}. All its conditions hold: {}.</source>
        <translation>Critère {} : {}. Toutes ses conditions sont remplies : {}.</translation>
    </message>
    <message>
        <source>Cut open</source>
        <translation>Couper</translation>
    </message>
    <message>
        <source>Cuts the map and the part; the edge of the cut has the colours of the walls</source>
        <translation>Coupe la carte et la pièce ; le bord de la coupe a les couleurs des parois</translation>
    </message>
    <message>
        <source>Dimensions that vary</source>
        <translation>Dimensions qui varient</translation>
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
        <source>Do not say this again</source>
        <translation>Ne plus le dire</translation>
    </message>
    <message>
        <source>Documents that are not classified yet, and only listed in it: {}.</source>
        <translation>Documents pas encore classifiés, qui n’y sont que cités : {}.</translation>
    </message>
    <message>
        <source>Double-click a size or a number of layers to change it, for all selected walls. Without the check mark, a wall asks for no small elements.</source>
        <translation>Double-cliquez sur une taille ou un nombre de couches pour les modifier, pour toutes les parois sélectionnées. Sans coche, une paroi ne demande pas de petits éléments.</translation>
    </message>
    <message>
        <source>Double-click: fly to its thinnest place. N, P: to the next and the previous one.</source>
        <translation>Double-clic : aller à son endroit le plus mince. N, P : au suivant et au précédent.</translation>
    </message>
    <message>
        <source>Drag it in the view to move it, a corner of it to size it; a right click has more</source>
        <translation>Dans la vue, la faire glisser pour la déplacer, par un coin pour en changer la taille ; un clic droit offre plus</translation>
    </message>
    <message>
        <source>Duplicates</source>
        <translation>Doublons</translation>
    </message>
    <message>
        <source>Duplicates, quickly: by what info files keep</source>
        <translation>Doublons, vite : d’après ce que gardent les fichiers d’information</translation>
    </message>
    <message>
        <source>Duplicates, surely: the documents are read</source>
        <translation>Doublons, sûrement : les documents sont lus</translation>
    </message>
    <message>
        <source>E&amp;xcept</source>
        <translation>Sau&amp;f</translation>
    </message>
    <message>
        <source>E&amp;xport map…</source>
        <translation>E&amp;xporter la carte…</translation>
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
        <source>Edit profile</source>
        <translation>Modifier le profil</translation>
    </message>
    <message>
        <source>Edit profile: {}</source>
        <translation>Modifier le profil : {}</translation>
    </message>
    <message>
        <source>Edit your own limits…</source>
        <translation>Modifier vos propres limites…</translation>
    </message>
    <message>
        <source>Element size, {}</source>
        <translation>Taille d'élément, {}</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Éléments</translation>
    </message>
    <message>
        <source>Equal ratios of thickness are equally far apart on the scale</source>
        <translation>Des rapports d'épaisseur égaux sont également espacés sur l'échelle</translation>
    </message>
    <message>
        <source>Equal ratios of thickness are equally far apart, so that thin walls get more of the colours</source>
        <translation>Des rapports d'épaisseur égaux sont également espacés, si bien que les parois minces reçoivent plus de couleurs</translation>
    </message>
    <message>
        <source>Error aimed at</source>
        <translation>Erreur visée</translation>
    </message>
    <message>
        <source>Error of probabilities</source>
        <translation>Erreur des probabilités</translation>
    </message>
    <message>
        <source>Evidence</source>
        <translation>Preuve</translation>
    </message>
    <message>
        <source>Exclude a wall</source>
        <translation>Exclure une paroi</translation>
    </message>
    <message>
        <source>Export the rows that are shown</source>
        <translation>Exporter les lignes affichées</translation>
    </message>
    <message>
        <source>Export thickness map</source>
        <translation>Exporter la carte d'épaisseur</translation>
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
        <source>Families: parts that differ in dimensions</source>
        <translation>Familles : pièces qui diffèrent par des dimensions</translation>
    </message>
    <message>
        <source>Families: {}. Parts in them: {}.</source>
        <translation>Familles : {}. Pièces qu’elles contiennent : {}.</translation>
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
        <source>Finding element sizes for {}</source>
        <translation>Recherche des tailles d’éléments pour {}</translation>
    </message>
    <message>
        <source>First, coarse colours; finer ones follow, about {} left.</source>
        <translation>Premières couleurs, grossières ; de plus fines suivent, encore {} environ.</translation>
    </message>
    <message>
        <source>First, coarse colours; finer ones follow.</source>
        <translation>Premières couleurs, grossières ; de plus fines suivent.</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Dossier</translation>
    </message>
    <message>
        <source>Folder for the info files, which mirrors the folders of the documents; it may be on another computer. Empty: beside each document</source>
        <translation>Un dossier pour les fichiers d’information, où les dossiers des documents sont reproduits ; il peut se trouver sur un autre ordinateur. Vide : à côté de chaque document</translation>
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
        <source>FreeCAD may crash in the same way when it opens the file: save your documents first. Open it anyway?</source>
        <translation>FreeCAD peut planter de la même façon en ouvrant le fichier : enregistrez d’abord vos documents. L’ouvrir quand même ?</translation>
    </message>
    <message>
        <source>FreeCAD shows one task at a time: close the one that is open, then try again.</source>
        <translation>FreeCAD n'affiche qu'une tâche à la fois : fermez celle qui est ouverte, puis réessayez.</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>From behind and below</source>
        <translation>De l’arrière et du dessous</translation>
    </message>
    <message>
        <source>From file…</source>
        <translation>Depuis un fichier…</translation>
    </message>
    <message>
        <source>From now on parts are judged by {}. 'Reclassify' in the panel 'Find parts' judges stored parts by it.</source>
        <translation>Désormais, les pièces sont jugées selon {}. « Reclassifier » dans « Trouver des pièces » juge ainsi les pièces enregistrées.</translation>
    </message>
    <message>
        <source>From the thinnest confirmed wall to the thickness below which 98 % of the surface lies, without rims, whose rays run along the wall</source>
        <translation>De la paroi confirmée la plus mince à l'épaisseur sous laquelle se trouvent 98 % de la surface, sans les bords, dont les rayons longent la paroi</translation>
    </message>
    <message>
        <source>From the thinnest to the thickest wall</source>
        <translation>De la paroi la plus mince à la plus épaisse</translation>
    </message>
    <message>
        <source>From where it is seen</source>
        <translation>D’où on la voit</translation>
    </message>
    <message>
        <source>From {} profiles, each learned without some folders or groups, and tried on those. In brackets: intervals of 95 %.</source>
        <translation>De {} profils, chacun appris sans certains dossiers ou groupes et essayé sur ceux-ci. Entre parenthèses : intervalles à 95 %.</translation>
    </message>
    <message>
        <source>From {} profiles, each learned without some parts, and tried on those. All parts are in one folder, so parts may be similar: the figures are too good. In brackets: intervals of 95 %.</source>
        <translation>De {} profils, chacun appris sans certaines pièces et essayé sur celles-ci. Toutes les pièces sont dans un seul dossier et peuvent se ressembler : les chiffres sont trop bons. Entre parenthèses : intervalles à 95 %.</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>Gmsh made no mesh ({}): try another error or fewer layers, a smaller largest size, or switch a wall off. Nothing was changed.</source>
        <translation>Gmsh n'a produit aucun maillage ({}) : essayez une autre erreur ou moins de couches, une plus petite taille maximale, ou désactivez une paroi. Rien n'a été modifié.</translation>
    </message>
    <message>
        <source>Gmsh meshes {}</source>
        <translation>Gmsh maille {}</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Continuer</translation>
    </message>
    <message>
        <source>Go to it</source>
        <translation>Y aller</translation>
    </message>
    <message>
        <source>Greatest wall, {}</source>
        <translation>Paroi la plus épaisse, {}</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Croissance</translation>
    </message>
    <message>
        <source>Half of the face's area has thinner walls</source>
        <translation>La moitié de l’aire de la face a des parois plus minces</translation>
    </message>
    <message>
        <source>Heat map colour where no wall could be measured</source>
        <translation>Couleur de la carte des épaisseurs là où aucune paroi n’a pu être mesurée</translation>
    </message>
    <message>
        <source>Heat map of the thickness</source>
        <translation>Carte des épaisseurs</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>Here: {}</source>
        <translation>Ici : {}</translation>
    </message>
    <message>
        <source>Hide colour bar</source>
        <translation>Masquer la barre de couleurs</translation>
    </message>
    <message>
        <source>Holds</source>
        <translation>Rempli</translation>
    </message>
    <message>
        <source>How far a place of one of the two surfaces is from the other at most</source>
        <translation>Distance maximale d’un point de l’une des deux surfaces à l’autre</translation>
    </message>
    <message>
        <source>How far it is from each point of the surface straight through the material to the other side. Verdicts are always judged by it.</source>
        <translation>La distance, de chaque point de la surface, tout droit à travers la matière jusqu’à l’autre côté. Les verdicts se fondent toujours sur elle.</translation>
    </message>
    <message>
        <source>How far the mesh may lie from the surface, as a share of the part's diagonal; where walls are thin it is made finer anyway</source>
        <translation>Écart permis entre le maillage et la surface, comme part de la diagonale de la pièce ; là où les parois sont minces, il est affiné de toute façon</translation>
    </message>
    <message>
        <source>How finely parts are measured at first; where the error of a quantity could turn the verdict, a part is measured again, more finely</source>
        <translation>Finesse de la première mesure ; là où l’erreur d’une grandeur pourrait changer le verdict, la pièce est mesurée de nouveau, plus finement</translation>
    </message>
    <message>
        <source>How often the part stands in the document</source>
        <translation>Combien de fois la pièce figure dans le document</translation>
    </message>
    <message>
        <source>How sure a verdict is</source>
        <translation>Certitude du verdict</translation>
    </message>
    <message>
        <source>I would say:</source>
        <translation>Je dirais :</translation>
    </message>
    <message>
        <source>I&amp;nclude again</source>
        <translation>I&amp;nclure à nouveau</translation>
    </message>
    <message>
        <source>In the view</source>
        <translation>Dans la vue</translation>
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
        <source>Instances</source>
        <translation>Exemplaires</translation>
    </message>
    <message>
        <source>Into how many steps the colours are divided</source>
        <translation>En combien de paliers les couleurs sont divisées</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isométrique</translation>
    </message>
    <message>
        <source>Kept because: {}</source>
        <translation>À garder : {}</translation>
    </message>
    <message>
        <source>Kept in the info file with a reason; checks compare this face with it instead of the process</source>
        <translation>Conservé dans le fichier d’informations avec une raison ; les contrôles comparent cette face à cette limite au lieu de celle du procédé</translation>
    </message>
    <message>
        <source>Kept in the info file, also when the part is measured again; the verdict does not change</source>
        <translation>Gardé dans le fichier d'information, même si la pièce est mesurée à nouveau ; le verdict ne change pas</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Sorte</translation>
    </message>
    <message>
        <source>L&amp;abels</source>
        <translation>É&amp;tiquettes</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Étiquette</translation>
    </message>
    <message>
        <source>Label {} parts</source>
        <translation>Étiqueter {} pièces</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Étiquettes</translation>
    </message>
    <message>
        <source>Labels (rows) and verdicts of {} (columns)</source>
        <translation>Étiquettes (lignes) et verdicts de {} (colonnes)</translation>
    </message>
    <message>
        <source>Labels: {}</source>
        <translation>Étiquettes : {}</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Plus grand</translation>
    </message>
    <message>
        <source>Largest ball</source>
        <translation>Plus grande boule</translation>
    </message>
    <message>
        <source>Largest ball here: {}</source>
        <translation>Plus grande boule ici : {}</translation>
    </message>
    <message>
        <source>Largest ball in {}, and share of the diagonal</source>
        <translation>Plus grande boule en {}, et part de la diagonale</translation>
    </message>
    <message>
        <source>Largest ball inside (sphere)</source>
        <translation>Plus grande boule à l’intérieur (sphère)</translation>
    </message>
    <message>
        <source>Largest ball, {}</source>
        <translation>Plus grande boule, {}</translation>
    </message>
    <message>
        <source>Largest size</source>
        <translation>Taille maximale</translation>
    </message>
    <message>
        <source>Largest size, {}</source>
        <translation>Plus grande taille, {}</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Couches</translation>
    </message>
    <message>
        <source>Layers in thin walls</source>
        <translation>Couches dans les parois minces</translation>
    </message>
    <message>
        <source>Learn thresholds</source>
        <translation>Apprendre des seuils</translation>
    </message>
    <message>
        <source>Learned</source>
        <translation>Appris</translation>
    </message>
    <message>
        <source>Learning needs the Python package {}, which this FreeCAD does not have: FreeCAD's Addon Manager offers it when it installs ThinPart.</source>
        <translation>L’apprentissage demande le paquet Python {}, que ce FreeCAD n’a pas : le gestionnaire d’extensions de FreeCAD le propose lorsqu’il installe ThinPart.</translation>
    </message>
    <message>
        <source>Learning profile {} of {}</source>
        <translation>Apprentissage du profil {} sur {}</translation>
    </message>
    <message>
        <source>Learning thresholds</source>
        <translation>Apprentissage des seuils</translation>
    </message>
    <message>
        <source>Least and median thickness of the wall</source>
        <translation>Épaisseur minimale et médiane de la paroi</translation>
    </message>
    <message>
        <source>Least share of the surface that counts</source>
        <translation>Plus petite part de la surface qui compte</translation>
    </message>
    <message>
        <source>Least wall, {}</source>
        <translation>Paroi la plus mince, {}</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Gauche</translation>
    </message>
    <message>
        <source>Left solid, not in the shell: {} walls, last in the table.</source>
        <translation>Restent en volume, hors de la coque : {} parois, à la fin du tableau.</translation>
    </message>
    <message>
        <source>Length of the wall</source>
        <translation>Longueur de la paroi</translation>
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
        <source>Limit for {}</source>
        <translation>Limite pour {}</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Limites</translation>
    </message>
    <message>
        <source>Limits of the wall</source>
        <translation>Limites de la paroi</translation>
    </message>
    <message>
        <source>Linear deflection</source>
        <translation>Déflexion linéaire</translation>
    </message>
    <message>
        <source>Linear elements are far too stiff in thin walls.</source>
        <translation>Les éléments linéaires sont beaucoup trop raides dans les parois minces.</translation>
    </message>
    <message>
        <source>Linear triangles are far too stiff in CalculiX.</source>
        <translation>Les triangles linéaires sont bien trop raides dans CalculiX.</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Lien</translation>
    </message>
    <message>
        <source>Local thickness</source>
        <translation>Épaisseur locale</translation>
    </message>
    <message>
        <source>Local thickness here: {}</source>
        <translation>Épaisseur locale ici : {}</translation>
    </message>
    <message>
        <source>Local thickness in {}, and share of the diagonal</source>
        <translation>Épaisseur locale en {} et part de la diagonale</translation>
    </message>
    <message>
        <source>Local thickness, {}</source>
        <translation>Épaisseur locale, {}</translation>
    </message>
    <message>
        <source>Logarithmic</source>
        <translation>Logarithmique</translation>
    </message>
    <message>
        <source>Long, {}</source>
        <translation>Long., {}</translation>
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
        <source>Lost</source>
        <translation>Perte</translation>
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
        <source>Make shell</source>
        <translation>Créer la coque</translation>
    </message>
    <message>
        <source>Making the mid-surface of {}</source>
        <translation>Création de la surface moyenne de {}</translation>
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
        <source>Measurements, notes, mesh settings and links stay unchanged. Write the info files now?</source>
        <translation>Les mesures, notes, paramètres de maillage et liens restent inchangés. Écrire les fichiers d’information maintenant ?</translation>
    </message>
    <message>
        <source>Measuring and drawing…</source>
        <translation>Mesure et dessin…</translation>
    </message>
    <message>
        <source>Measuring needs Python {} beside FreeCAD, which was not found: install it.</source>
        <translation>La mesure demande Python {} à côté de FreeCAD, qui n’a pas été trouvé : installez-le.</translation>
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
        <source>Median thickness of the wall</source>
        <translation>Épaisseur médiane de la paroi</translation>
    </message>
    <message>
        <source>Median, {}</source>
        <translation>Médiane, {}</translation>
    </message>
    <message>
        <source>Memory limit for measuring one document</source>
        <translation>Limite de mémoire pour la mesure d’un document</translation>
    </message>
    <message>
        <source>Memory per file</source>
        <translation>Mémoire par fichier</translation>
    </message>
    <message>
        <source>Mesh and compare</source>
        <translation>Mailler et comparer</translation>
    </message>
    <message>
        <source>Mesh as</source>
        <translation>Mailler en</translation>
    </message>
    <message>
        <source>Mesh file</source>
        <translation>Fichier de maillage</translation>
    </message>
    <message>
        <source>Mesh risk</source>
        <translation>Risque de maillage</translation>
    </message>
    <message>
        <source>Mesh settings</source>
        <translation>Paramètres de maillage</translation>
    </message>
    <message>
        <source>Mesh size of a wall</source>
        <translation>Taille de maille d'une paroi</translation>
    </message>
    <message>
        <source>Meshes</source>
        <translation>Maillages</translation>
    </message>
    <message>
        <source>Most elements</source>
        <translation>Nombre maximal d'éléments</translation>
    </message>
    <message>
        <source>Move over the part; a click pins the wall there.</source>
        <translation>Déplacez le pointeur sur la pièce ; un clic y fixe une sonde.</translation>
    </message>
    <message>
        <source>My label: {}</source>
        <translation>Je dis : {}</translation>
    </message>
    <message>
        <source>New material</source>
        <translation>Nouveau matériau</translation>
    </message>
    <message>
        <source>New process</source>
        <translation>Nouveau procédé</translation>
    </message>
    <message>
        <source>Next wall</source>
        <translation>Paroi suivante</translation>
    </message>
    <message>
        <source>No criterion holds: its walls are thick all over.</source>
        <translation>Aucun critère n’est rempli : ses parois sont épaisses partout.</translation>
    </message>
    <message>
        <source>No file manager was found: open the folder {} yourself.</source>
        <translation>Aucun gestionnaire de fichiers n’a été trouvé : ouvrez vous-même le dossier {}.</translation>
    </message>
    <message>
        <source>No file manager was found: open the info file {} yourself.</source>
        <translation>Aucun gestionnaire de fichiers n’a été trouvé : ouvrez vous-même le fichier d’information {}.</translation>
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
        <source>No part was measured, so no info file was written.</source>
        <translation>Aucune pièce n’a été mesurée, donc aucun fichier d’information n’a été écrit.</translation>
    </message>
    <message>
        <source>No place is more than {} apart.</source>
        <translation>Aucun endroit n’est distant de plus de {}.</translation>
    </message>
    <message>
        <source>No program was found that opens {}.</source>
        <translation>Aucun programme n’a été trouvé pour ouvrir {}.</translation>
    </message>
    <message>
        <source>No thin walls: one size is enough. About {} elements of {}.</source>
        <translation>Aucune paroi mince : une seule taille suffit. Environ {} éléments de {}.</translation>
    </message>
    <message>
        <source>No wall became thinner.</source>
        <translation>Aucune paroi n’est devenue plus mince.</translation>
    </message>
    <message>
        <source>No wall could be measured.</source>
        <translation>Aucune paroi n’a pu être mesurée.</translation>
    </message>
    <message>
        <source>No wall regions are recorded: measure the part again.</source>
        <translation>Aucune région de paroi n’est enregistrée : mesurez de nouveau la pièce.</translation>
    </message>
    <message>
        <source>No wall was measured here.</source>
        <translation>Aucune paroi n’a été mesurée ici.</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Gr.</translation>
    </message>
    <message>
        <source>Normal part</source>
        <translation>Pièce normale</translation>
    </message>
    <message>
        <source>Not compared, because an earlier version has measured them: {}. Classify them again.</source>
        <translation>Non comparées, car mesurées par une version antérieure : {}. Classifiez-les à nouveau.</translation>
    </message>
    <message>
        <source>Not counted: {}</source>
        <translation>Pas de décompte : {}</translation>
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
        <source>Not right?</source>
        <translation>Pas exact ?</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Remarque</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Maintenant</translation>
    </message>
    <message>
        <source>Now, {}</source>
        <translation>Maintenant, {}</translation>
    </message>
    <message>
        <source>Number of files of a folder that are measured at the same time</source>
        <translation>Fichiers d’un dossier mesurés en même temps</translation>
    </message>
    <message>
        <source>Number of the group</source>
        <translation>Numéro du groupe</translation>
    </message>
    <message>
        <source>OK also makes an analysis, if there is none</source>
        <translation>OK crée aussi une analyse, s’il n’y en a pas</translation>
    </message>
    <message>
        <source>Of deflections and frequencies, with quadratic elements. It decides the sizes.</source>
        <translation>Sur les déformations et les fréquences, avec des éléments quadratiques. Elle détermine les tailles.</translation>
    </message>
    <message>
        <source>On every save</source>
        <translation>À chaque enregistrement</translation>
    </message>
    <message>
        <source>On parts that were left out, the learned profile agrees with the labels no better than {} does: keep {}, or label more parts.</source>
        <translation>Sur les pièces mises de côté, le profil appris ne concorde pas mieux avec les étiquettes que {} : gardez {} ou étiquetez plus de pièces.</translation>
    </message>
    <message>
        <source>On {} of the area the largest ball is smaller than {}</source>
        <translation>Sur {} de la surface, la plus grande boule est inférieure à {}</translation>
    </message>
    <message>
        <source>On {} of the area the local thickness is less than {}</source>
        <translation>Sur {} de la surface, l’épaisseur locale est inférieure à {}</translation>
    </message>
    <message>
        <source>One size: {}</source>
        <translation>Taille unique : {}</translation>
    </message>
    <message>
        <source>Only failures</source>
        <translation>Seulement les échecs</translation>
    </message>
    <message>
        <source>Only labelled</source>
        <translation>Seulement étiquetées</translation>
    </message>
    <message>
        <source>Only labelled otherwise</source>
        <translation>Seulement étiquetées autrement</translation>
    </message>
    <message>
        <source>Only unsure</source>
        <translation>Seulement incertaines</translation>
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
        <source>Open it</source>
        <translation>L’ouvrir</translation>
    </message>
    <message>
        <source>Open part</source>
        <translation>Ouvrir la pièce</translation>
    </message>
    <message>
        <source>Opens a profile that somebody has given you</source>
        <translation>Ouvre un profil que quelqu’un vous a donné</translation>
    </message>
    <message>
        <source>Opens the page of the guide about this (F1)</source>
        <translation>Ouvre la page du guide à ce sujet (F1)</translation>
    </message>
    <message>
        <source>Order of the elements</source>
        <translation>Ordre des éléments</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>Autre côté</translation>
    </message>
    <message>
        <source>Out of date: recompute</source>
        <translation>Périmé : recalculer</translation>
    </message>
    <message>
        <source>Own limit</source>
        <translation>Limite propre</translation>
    </message>
    <message>
        <source>Own limits</source>
        <translation>Limites propres</translation>
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
        <source>Parts</source>
        <translation>Pièces</translation>
    </message>
    <message>
        <source>Parts are judged by '{}' from now on. Parts that were classified before keep their verdicts until you reclassify them.</source>
        <translation>Les pièces sont désormais jugées selon « {} ». Celles classifiées auparavant gardent leur verdict jusqu’à ce que vous les reclassifiiez.</translation>
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
        <source>People</source>
        <translation>Personnes</translation>
    </message>
    <message>
        <source>Picture of the view (*.png)</source>
        <translation>Image de la vue (*.png)</translation>
    </message>
    <message>
        <source>Pin thickness</source>
        <translation>Fixer une sonde</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Prepare mesh</source>
        <translation>Préparer le maillage</translation>
    </message>
    <message>
        <source>Previous wall</source>
        <translation>Paroi précédente</translation>
    </message>
    <message>
        <source>Probability: {}, next '{}' with {}</source>
        <translation>Probabilité : {}, puis « {} » avec {}</translation>
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
        <source>Process and material</source>
        <translation>Procédé et matériau</translation>
    </message>
    <message>
        <source>Processes whose least and greatest wall the parts are checked against: a column each</source>
        <translation>Procédés dont les parois minimale et maximale servent à vérifier les pièces : une colonne chacun</translation>
    </message>
    <message>
        <source>Processes, with commas between them, whose least and greatest wall every part is checked against</source>
        <translation>Procédés, séparés par des virgules, dont les parois minimale et maximale servent à vérifier chaque pièce</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
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
        <source>Range of &amp;most walls</source>
        <translation>Plage de la &amp;plupart des parois</translation>
    </message>
    <message>
        <source>Read the info files again, which may have changed</source>
        <translation>Relire les fichiers d’information, qui ont pu changer</translation>
    </message>
    <message>
        <source>Reading info files: {} of {}</source>
        <translation>Lecture des fichiers d’information : {} sur {}</translation>
    </message>
    <message>
        <source>Reading info files…</source>
        <translation>Lecture des fichiers d’information…</translation>
    </message>
    <message>
        <source>Reading the labels…</source>
        <translation>Lecture des étiquettes…</translation>
    </message>
    <message>
        <source>Rear</source>
        <translation>Arrière</translation>
    </message>
    <message>
        <source>Reclassify</source>
        <translation>Reclassifier</translation>
    </message>
    <message>
        <source>Reclassify libraries…</source>
        <translation>Reclassifier les bibliothèques…</translation>
    </message>
    <message>
        <source>Reclassify…</source>
        <translation>Reclassifier…</translation>
    </message>
    <message>
        <source>Recommended: shell.</source>
        <translation>Recommandé : coque.</translation>
    </message>
    <message>
        <source>Recommended: solid, or a shell of its walls only.</source>
        <translation>Recommandé : volume, ou une coque de ses seules parois.</translation>
    </message>
    <message>
        <source>Recommended: solid.</source>
        <translation>Recommandé : volume.</translation>
    </message>
    <message>
        <source>Refresh</source>
        <translation>Actualiser</translation>
    </message>
    <message>
        <source>Refreshing the libraries</source>
        <translation>Actualisation des bibliothèques</translation>
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
        <source>Remove my label</source>
        <translation>Retirer mon étiquette</translation>
    </message>
    <message>
        <source>Remove thickness</source>
        <translation>Retirer une sonde</translation>
    </message>
    <message>
        <source>Remove this category</source>
        <translation>Retirer cette catégorie</translation>
    </message>
    <message>
        <source>Remove this condition</source>
        <translation>Retirer cette condition</translation>
    </message>
    <message>
        <source>Remove this criterion</source>
        <translation>Retirer ce critère</translation>
    </message>
    <message>
        <source>Replace it? What it contains will be lost.</source>
        <translation>Remplacer ce fichier ? Son contenu sera perdu.</translation>
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
        <source>Report about libraries</source>
        <translation>Rapport sur les bibliothèques</translation>
    </message>
    <message>
        <source>Report about the classified parts in '{}'</source>
        <translation>Rapport sur les pièces classifiées de « {} »</translation>
    </message>
    <message>
        <source>Report about the classified parts in {} libraries</source>
        <translation>Rapport sur les pièces classifiées de {} bibliothèques</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Rapport…</translation>
    </message>
    <message>
        <source>Reset to saved</source>
        <translation>Rétablir</translation>
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
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Risk of the automatic mesh</source>
        <translation>Risque du maillage automatique</translation>
    </message>
    <message>
        <source>S&amp;hare</source>
        <translation>&amp;Partager</translation>
    </message>
    <message>
        <source>Same</source>
        <translation>Identique</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Enregistrer &amp;sous…</translation>
    </message>
    <message>
        <source>Save and write info file</source>
        <translation>Enregistrer et écrire le fichier d’information</translation>
    </message>
    <message>
        <source>Save the learned profile</source>
        <translation>Enregistrer le profil appris</translation>
    </message>
    <message>
        <source>Save the limits</source>
        <translation>Enregistrer les limites</translation>
    </message>
    <message>
        <source>Save the profile as</source>
        <translation>Enregistrer le profil sous</translation>
    </message>
    <message>
        <source>Save them?</source>
        <translation>Les enregistrer ?</translation>
    </message>
    <message>
        <source>Saved in {}, without the probabilities, which belong to other thresholds.</source>
        <translation>Enregistré dans {}, sans les probabilités, qui appartiennent à d’autres seuils.</translation>
    </message>
    <message>
        <source>Saved in {}.</source>
        <translation>Enregistré dans {}.</translation>
    </message>
    <message>
        <source>Saved in {}. Wherever you choose processes, these limits hold from now on.</source>
        <translation>Enregistré dans {}. Partout où vous choisissez des procédés, ces limites valent désormais.</translation>
    </message>
    <message>
        <source>Saved.</source>
        <translation>Enregistré.</translation>
    </message>
    <message>
        <source>Saves the profile and judges parts by it from now on</source>
        <translation>Enregistre le profil et juge désormais les pièces selon lui</translation>
    </message>
    <message>
        <source>Say below a verdict whether the libraries of Find parts have the part already, its mirror image, another size, or one like it</source>
        <translation>Dire sous un verdict si les bibliothèques de Trouver des pièces ont déjà la pièce, son image miroir, une autre taille ou une semblable</translation>
    </message>
    <message>
        <source>Say what libraries have already</source>
        <translation>Dire ce que les bibliothèques ont déjà</translation>
    </message>
    <message>
        <source>Say what the part is in your eyes. The label is kept in the info file, as of {}; thresholds can be learned from labels.</source>
        <translation>Dites ce qu’est la pièce à vos yeux. L’étiquette est gardée dans le fichier d’information, comme celle de {} ; on peut apprendre des seuils à partir des étiquettes.</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>Search in it…</source>
        <translation>Y chercher…</translation>
    </message>
    <message>
        <source>Searching for duplicates</source>
        <translation>Recherche de doublons</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>Recherche…</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Coupe</translation>
    </message>
    <message>
        <source>Select a part in the list.</source>
        <translation>Sélectionnez une pièce dans la liste.</translation>
    </message>
    <message>
        <source>Set "Most elements", or a larger error.</source>
        <translation>Réglez « Nombre maximal d'éléments », ou une erreur plus grande.</translation>
    </message>
    <message>
        <source>Set "Most elements", or fewer layers.</source>
        <translation>Réglez « Nombre maximal d'éléments », ou moins de couches.</translation>
    </message>
    <message>
        <source>Set &amp;mesh size…</source>
        <translation>Fixer la taille de &amp;maille…</translation>
    </message>
    <message>
        <source>Set its &amp;greatest wall…</source>
        <translation>Fixer sa paroi la plus é&amp;paisse…</translation>
    </message>
    <message>
        <source>Set its &amp;least wall…</source>
        <translation>Fixer sa paroi la plus &amp;mince…</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Réglage</translation>
    </message>
    <message>
        <source>Settings that worked for this part: {}</source>
        <translation>Réglages qui ont fait leurs preuves pour cette pièce : {}</translation>
    </message>
    <message>
        <source>Settings that worked for {} ({} alike): {}</source>
        <translation>Réglages qui ont fait leurs preuves pour {} (semblable à {}) : {}</translation>
    </message>
    <message>
        <source>Shaded</source>
        <translation>Ombré</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Part</translation>
    </message>
    <message>
        <source>Share of the face where no wall could be measured</source>
        <translation>Part de la face où aucune paroi n’a pu être mesurée</translation>
    </message>
    <message>
        <source>Share of the face whose walls are thinner than the threshold</source>
        <translation>Part de la face dont les parois sont plus minces que le seuil</translation>
    </message>
    <message>
        <source>Share of the surface that is the same: the less of both</source>
        <translation>Part de la surface qui est la même : la plus petite des deux</translation>
    </message>
    <message>
        <source>Shell: its mid-surface</source>
        <translation>Coque : sa surface moyenne</translation>
    </message>
    <message>
        <source>Short name</source>
        <translation>Nom court</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>Tout &amp;afficher</translation>
    </message>
    <message>
        <source>Show &amp;all walls</source>
        <translation>&amp;Afficher toutes les parois</translation>
    </message>
    <message>
        <source>Show in Find parts</source>
        <translation>Montrer dans « Trouver des pièces »</translation>
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
        <source>Show poor elements ({})</source>
        <translation>Montrer les mauvais éléments ({})</translation>
    </message>
    <message>
        <source>Show sizes on the part</source>
        <translation>Montrer les tailles sur la pièce</translation>
    </message>
    <message>
        <source>Show the difference</source>
        <translation>Montrer la différence</translation>
    </message>
    <message>
        <source>Show the shell by its thickness</source>
        <translation>Afficher la coque selon son épaisseur</translation>
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
        <source>Shows the defaults of this page; OK or Apply saves them</source>
        <translation>Affiche les valeurs par défaut de cette page ; OK ou Appliquer les enregistre</translation>
    </message>
    <message>
        <source>Shows the half that is cut off now</source>
        <translation>Montre la moitié qui est coupée pour le moment</translation>
    </message>
    <message>
        <source>Shows the thresholds of this profile, to change and save them as your own</source>
        <translation>Montre les seuils de ce profil, pour les modifier et les enregistrer comme les vôtres</translation>
    </message>
    <message>
        <source>Similar size</source>
        <translation>Taille similaire</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Size, {}</source>
        <translation>Taille, {}</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Plus petit</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Solide</translation>
    </message>
    <message>
        <source>Something stands before this wall from every side: the mark shows where it is. Hide what covers it, or cut the view open with the clipping plane of the View menu.</source>
        <translation>Quelque chose se trouve devant cette paroi de tous les côtés : le repère montre où elle est. Masquez ce qui la couvre, ou ouvrez la vue avec le plan de coupe du menu Affichage.</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>Source: address</source>
        <translation>Source : adresse</translation>
    </message>
    <message>
        <source>Source: author</source>
        <translation>Source : auteur</translation>
    </message>
    <message>
        <source>Source: title</source>
        <translation>Source : titre</translation>
    </message>
    <message>
        <source>Source: year</source>
        <translation>Source : année</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Départ</translation>
    </message>
    <message>
        <source>Start &amp;with</source>
        <translation>Partir &amp;de</translation>
    </message>
    <message>
        <source>Starting to measure {}</source>
        <translation>Début de la mesure de {}</translation>
    </message>
    <message>
        <source>Steel (replace it)</source>
        <translation>Acier (à remplacer)</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Stop it, and go on here?</source>
        <translation>L’arrêter et continuer ici ?</translation>
    </message>
    <message>
        <source>Stopped on request before the end.</source>
        <translation>Arrêté à la demande avant la fin.</translation>
    </message>
    <message>
        <source>Stopped: {} of {} info files are up to date.</source>
        <translation>Arrêté : {} fichiers d’information sur {} sont à jour.</translation>
    </message>
    <message>
        <source>Sure labels</source>
        <translation>Étiquettes sûres</translation>
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
        <source>Temporary files cannot be written ({}): free some disk space. Nothing was classified.</source>
        <translation>Impossible d’écrire des fichiers temporaires ({}) : libérez de l’espace disque. Rien n’a été classé.</translation>
    </message>
    <message>
        <source>Temporary files cannot be written ({}): free some disk space. Nothing was measured.</source>
        <translation>Impossible d’écrire des fichiers temporaires ({}) : libérez de l’espace disque. Rien n’a été mesuré.</translation>
    </message>
    <message>
        <source>The active document as it was saved. Click to classify it in the panel.</source>
        <translation>Le document actif tel qu’il est enregistré. Cliquez pour le classifier dans le panneau.</translation>
    </message>
    <message>
        <source>The camera looks at it from where nothing stands before it. N, P: the next thicker wall, and the previous one</source>
        <translation>La caméra la regarde d’où rien ne se trouve devant elle. N, P : la paroi suivante, plus épaisse, et la précédente</translation>
    </message>
    <message>
        <source>The category needs a short name.</source>
        <translation>La catégorie a besoin d’un nom court.</translation>
    </message>
    <message>
        <source>The category's short name, by which results and searches refer to it</source>
        <translation>Le nom court de la catégorie, par lequel résultats et recherches la désignent</translation>
    </message>
    <message>
        <source>The classification process could not be started.</source>
        <translation>Le processus de classification n’a pas pu être démarré.</translation>
    </message>
    <message>
        <source>The classification process ended unexpectedly; finished results are saved. Start again for the rest; the report view shows its last output.</source>
        <translation>Le processus de classification s’est terminé de façon inattendue ; les résultats obtenus sont enregistrés. Démarrez à nouveau pour le reste ; ses derniers messages sont dans la vue rapport.</translation>
    </message>
    <message>
        <source>The colours in the view are the first, coarse ones: they are not saved, and go when this panel is closed.</source>
        <translation>Les couleurs de la vue sont les premières, grossières : elles ne sont pas enregistrées et disparaissent à la fermeture de ce panneau.</translation>
    </message>
    <message>
        <source>The content of {} was copied into {}: a link needs a saved document.</source>
        <translation>Le contenu de {} a été copié dans {} : un lien demande un document enregistré.</translation>
    </message>
    <message>
        <source>The criterion needs a short name.</source>
        <translation>Le critère a besoin d’un nom court.</translation>
    </message>
    <message>
        <source>The criterion's short name, by which results and searches refer to it</source>
        <translation>Le nom court du critère, par lequel résultats et recherches le désignent</translation>
    </message>
    <message>
        <source>The diameter of the largest ball that fits into the material and reaches each point. Edges are as thick as the walls that meet there; ribs, teeth, threads and run-outs have a thickness of their own.</source>
        <translation>Le diamètre de la plus grande bille qui tient dans la matière et atteint chaque point. Les arêtes sont aussi épaisses que les parois qui s’y rejoignent ; nervures, dents, filets et sorties ont leur propre épaisseur.</translation>
    </message>
    <message>
        <source>The diameter of the largest ball that fits into the material and touches the surface at each point. It is no larger than the wall across and does not see past the next face: at sharp edges it goes down to nothing. It takes longer.</source>
        <translation>Le diamètre de la plus grande boule qui tient dans la matière et touche la surface en chaque point. Il n’est jamais supérieur à la paroi mesurée à travers et ne va pas au-delà de la face suivante : aux arêtes vives, il tend vers zéro. La mesure est plus longue.</translation>
    </message>
    <message>
        <source>The document has changed since it was measured: classify it again.</source>
        <translation>Le document a changé depuis la mesure : classifiez-le à nouveau.</translation>
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
        <source>The document has changed while it was meshed: start again. Nothing was changed.</source>
        <translation>Le document a changé pendant le maillage : recommencez. Rien n'a été modifié.</translation>
    </message>
    <message>
        <source>The document is closed: open it again for a report about it.</source>
        <translation>Le document est fermé : rouvrez-le pour en faire un rapport.</translation>
    </message>
    <message>
        <source>The failures are folders that could not be searched: make them readable and start again.</source>
        <translation>Les échecs sont des dossiers qui n’ont pas pu être parcourus : rendez-les lisibles et démarrez à nouveau.</translation>
    </message>
    <message>
        <source>The file {} no longer exists.</source>
        <translation>Le fichier {} n’existe plus.</translation>
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
        <source>The folder with your parts; its subfolders are included</source>
        <translation>Le dossier de vos pièces, sous-dossiers compris</translation>
    </message>
    <message>
        <source>The folder {} has not answered for {} s: connect it, or choose another one for the info files.</source>
        <translation>Le dossier {} ne répond pas depuis {} s : connectez-le ou choisissez-en un autre pour les fichiers d’information.</translation>
    </message>
    <message>
        <source>The folder {} is not writable: choose another folder for the info files.</source>
        <translation>Le dossier {} n’est pas accessible en écriture : choisissez un autre dossier pour les fichiers d’information.</translation>
    </message>
    <message>
        <source>The folder {} no longer exists.</source>
        <translation>Le dossier {} n’existe plus.</translation>
    </message>
    <message>
        <source>The info file {} is damaged ({}): classify its document again.</source>
        <translation>Le fichier d’information {} est endommagé ({}) : classifiez à nouveau son document.</translation>
    </message>
    <message>
        <source>The learned profile agrees with {} labels; {} does with {}.</source>
        <translation>Le profil appris concorde avec {} étiquettes ; {} avec {}.</translation>
    </message>
    <message>
        <source>The learned profile was written to {}.</source>
        <translation>Le profil appris a été écrit dans {}.</translation>
    </message>
    <message>
        <source>The least wall has to be thinner than the greatest.</source>
        <translation>La plus petite épaisseur doit être inférieure à la plus grande.</translation>
    </message>
    <message>
        <source>The least wall; another one is a limit of your own</source>
        <translation>La paroi minimale ; une autre est une limite personnelle</translation>
    </message>
    <message>
        <source>The limit costs accuracy: {} would take about {} elements.</source>
        <translation>La limite coûte de la précision : {} demanderaient environ {} éléments.</translation>
    </message>
    <message>
        <source>The limit costs layers: all walls would take about {} elements.</source>
        <translation>La limite coûte des couches : toutes les parois demanderaient environ {} éléments.</translation>
    </message>
    <message>
        <source>The limit costs layers: {} instead of {}, which would take about {} elements.</source>
        <translation>La limite coûte des couches : {} au lieu de {}, qui demanderaient environ {} éléments.</translation>
    </message>
    <message>
        <source>The limits of the wall have unsaved changes.</source>
        <translation>Les limites de la paroi ont des modifications non enregistrées.</translation>
    </message>
    <message>
        <source>The map is lit, so that its shape is seen: colours get darker away from the light. Off: flat colours, exactly those of the colour bar</source>
        <translation>La carte est éclairée pour que sa forme se voie : les couleurs sont plus sombres à l'écart de la lumière. Sinon : couleurs plates, exactement celles de la barre de couleurs</translation>
    </message>
    <message>
        <source>The map of before beside that of now, once the part was changed and measured again</source>
        <translation>La carte d’avant à côté de celle de maintenant, une fois la pièce modifiée et mesurée à nouveau</translation>
    </message>
    <message>
        <source>The map of before is of other parts, or was measured in another way.</source>
        <translation>La carte d’avant est celle d’autres pièces, ou a été mesurée autrement.</translation>
    </message>
    <message>
        <source>The measuring process could not be started.</source>
        <translation>Le processus de mesure n’a pas pu être démarré.</translation>
    </message>
    <message>
        <source>The measuring process ended unexpectedly; the document is unharmed. Check the part with 'Check geometry' of the Part workbench.</source>
        <translation>Le processus de mesure s’est terminé de façon inattendue ; le document est intact. Vérifiez la pièce avec « Vérifier la géométrie » de l’atelier Part.</translation>
    </message>
    <message>
        <source>The open panel is about '{}'.</source>
        <translation>Le panneau ouvert concerne « {} ».</translation>
    </message>
    <message>
        <source>The probabilities of this profile belong to its thresholds before your change: they say how often engineers agreed with verdicts by those. The changed profile is saved without them, and its verdicts are borderline near a threshold instead. 'thinpart learn' makes new ones from labels.</source>
        <translation>Les probabilités de ce profil appartiennent à ses seuils d’avant votre modification : elles disent à quelle fréquence des ingénieurs approuvaient les verdicts selon ceux-ci. Le profil modifié est enregistré sans elles, et ses verdicts sont à la place des cas limites près d’un seuil. « thinpart learn » en tire de nouvelles à partir d’étiquettes.</translation>
    </message>
    <message>
        <source>The profile has unsaved changes.</source>
        <translation>Le profil a des modifications non enregistrées.</translation>
    </message>
    <message>
        <source>The report is in {}.</source>
        <translation>Le rapport est dans {}.</translation>
    </message>
    <message>
        <source>The same part, its mirror image, another size, or one like it; each is said once</source>
        <translation>La même pièce, son image miroir, une autre taille, ou une pièce semblable ; chacune est dite une fois</translation>
    </message>
    <message>
        <source>The second bound has to be greater than the first.</source>
        <translation>La seconde borne doit être supérieure à la première.</translation>
    </message>
    <message>
        <source>The short name consists of 1 to 40 letters, digits, - and _.</source>
        <translation>Le nom court se compose de 1 à 40 lettres, chiffres, - et _.</translation>
    </message>
    <message>
        <source>The short name {} is there twice.</source>
        <translation>Le nom court {} existe deux fois.</translation>
    </message>
    <message>
        <source>The smallest size everywhere would take {}.</source>
        <translation>La plus petite taille partout en demanderait {}.</translation>
    </message>
    <message>
        <source>The table was not written to {}: choose a file name that ends with .csv.</source>
        <translation>Le tableau n’a pas été écrit dans {} : choisissez un nom de fichier qui se termine par .csv.</translation>
    </message>
    <message>
        <source>The table {} could not be written ({}): choose another place for it.</source>
        <translation>Le tableau {} n’a pas pu être écrit ({}) : choisissez un autre emplacement.</translation>
    </message>
    <message>
        <source>The thickness map cannot be written ({}): free some disk space. Nothing was changed.</source>
        <translation>Impossible d’écrire la carte d’épaisseurs ({}) : libérez de l’espace disque. Rien n’a été modifié.</translation>
    </message>
    <message>
        <source>The thickness map is hidden, to show the thin faces. Space shows it again.</source>
        <translation>La carte d’épaisseur est masquée pour montrer les faces minces. La barre d’espace la réaffiche.</translation>
    </message>
    <message>
        <source>The thinnest wall, the thickest one and pinned ones; those behind the part are hidden</source>
        <translation>La paroi la plus mince, la plus épaisse et celles épinglées ; ce qui est derrière la pièce est masqué</translation>
    </message>
    <message>
        <source>The threshold</source>
        <translation>Le seuil</translation>
    </message>
    <message>
        <source>The worker process could not be started.</source>
        <translation>Le processus de travail n’a pas pu être démarré.</translation>
    </message>
    <message>
        <source>The worker process ended unexpectedly.</source>
        <translation>Le processus de travail s’est terminé de façon inattendue.</translation>
    </message>
    <message>
        <source>The worker process ended unexpectedly; the report view shows its last output.</source>
        <translation>Le processus de travail s’est terminé de façon inattendue ; ses derniers messages sont dans la vue rapport.</translation>
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
        <source>There are no classified parts.</source>
        <translation>Il n’y a pas de pièces classifiées.</translation>
    </message>
    <message>
        <source>There are no families.</source>
        <translation>Il n’y a pas de familles.</translation>
    </message>
    <message>
        <source>There are two categories {}.</source>
        <translation>Il y a deux catégories {}.</translation>
    </message>
    <message>
        <source>There are two criteria {}.</source>
        <translation>Il y a deux critères {}.</translation>
    </message>
    <message>
        <source>There has to be a least or a greatest wall.</source>
        <translation>Il faut une plus petite ou une plus grande épaisseur.</translation>
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
        <source>There is no folder {}: choose another one.</source>
        <translation>Le dossier {} n’existe pas : choisissez-en un autre.</translation>
    </message>
    <message>
        <source>There is no folder {}: create it first, or choose another one for the info files.</source>
        <translation>Le dossier {} n’existe pas : créez-le d’abord ou choisissez-en un autre pour les fichiers d’information.</translation>
    </message>
    <message>
        <source>There is no info file to keep this in: press 'Save and write info file' above, or classify the document.</source>
        <translation>Il n'y a pas de fichier d'information où le garder : appuyez plus haut sur « Enregistrer et écrire le fichier d'information », ou classez le document.</translation>
    </message>
    <message>
        <source>Thick, {}</source>
        <translation>Épaisseur, {}</translation>
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
        <source>Thickness labels</source>
        <translation>Étiquettes d’épaisseur</translation>
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
        <source>ThinPart guide</source>
        <translation>Guide de ThinPart</translation>
    </message>
    <message>
        <source>ThinPart is installed twice: {} is used, {} is not. Remove one of them.</source>
        <translation>ThinPart est installé deux fois : {} est utilisé, {} ne l’est pas. Supprimez l’un des deux.</translation>
    </message>
    <message>
        <source>ThinPart: {}</source>
        <translation>ThinPart : {}</translation>
    </message>
    <message>
        <source>Thinnest wall under the face</source>
        <translation>Paroi la plus mince sous la face</translation>
    </message>
    <message>
        <source>Thinnest wall, and how many places are about as thin</source>
        <translation>Paroi la plus mince, et combien d’endroits sont à peu près aussi minces</translation>
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
        <source>This link is stored with the part. Open it outside FreeCAD?</source>
        <translation>Ce lien est enregistré avec la pièce. L’ouvrir en dehors de FreeCAD ?</translation>
    </message>
    <message>
        <source>Three colours: red is thinner than the limit, yellow up to a tenth above it, blue passes. Violet is thicker than the process allows, by the largest ball inside, as in the check</source>
        <translation>Trois couleurs : le rouge est plus mince que la limite, le jaune jusqu’à un dixième au-dessus, le bleu est conforme. Le violet est plus épais que le procédé ne le permet, d’après la plus grande boule à l’intérieur, comme dans le contrôle</translation>
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
        <source>Time limit for one file of a folder, or for one document that is classified automatically</source>
        <translation>Limite de temps pour un fichier d’un dossier ou un document classifié automatiquement</translation>
    </message>
    <message>
        <source>Time per file</source>
        <translation>Temps par fichier</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titre</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>To be measured again, because an earlier version did not measure what decides: {}.</source>
        <translation>À mesurer de nouveau, car une version antérieure n’a pas mesuré ce qui décide : {}.</translation>
    </message>
    <message>
        <source>To classify a part, open a document and close the task that is open.</source>
        <translation>Pour classifier une pièce, ouvrez un document et fermez la tâche ouverte.</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Dessus</translation>
    </message>
    <message>
        <source>Try {}: {}</source>
        <translation>Essai {} : {}</translation>
    </message>
    <message>
        <source>Two answers to the same part differ in {}.</source>
        <translation>Deux réponses sur la même pièce diffèrent dans {}.</translation>
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
        <source>Unsure below a probability of</source>
        <translation>Incertain sous une probabilité de</translation>
    </message>
    <message>
        <source>Unsure: '{}' ({}) or '{}' ({})</source>
        <translation>Incertain : « {} » ({}) ou « {} » ({})</translation>
    </message>
    <message>
        <source>Unsure: {} or {}</source>
        <translation>Incertain : {} ou {}</translation>
    </message>
    <message>
        <source>Use these settings</source>
        <translation>Utiliser ces réglages</translation>
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
        <source>Wall regions</source>
        <translation>Régions de paroi</translation>
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
        <source>Walls are in the order of their thickness. Key: {}</source>
        <translation>Les parois sont dans l'ordre de leur épaisseur. Touche : {}</translation>
    </message>
    <message>
        <source>Walls that are shown as thin</source>
        <translation>Parois affichées comme minces</translation>
    </message>
    <message>
        <source>Walls that became thinner, the one that lost most first. Click: fly to it.</source>
        <translation>Parois devenues plus minces, celle qui a le plus perdu d’abord. Clic : y voler.</translation>
    </message>
    <message>
        <source>Walls thinner than this are coloured as thin</source>
        <translation>Les parois plus minces que cette épaisseur sont colorées comme minces</translation>
    </message>
    <message>
        <source>Walls thinner than this are coloured as thin; the verdict does not depend on it</source>
        <translation>Les parois plus minces que cette épaisseur sont colorées comme minces ; le verdict n’en dépend pas</translation>
    </message>
    <message>
        <source>Walls thinner than this share of the part's diagonal are coloured as thin</source>
        <translation>Les parois plus minces que cette part de la diagonale de la pièce sont colorées comme minces</translation>
    </message>
    <message>
        <source>Walls under {} have fewer layers: they would take most of the elements.</source>
        <translation>Les parois de moins de {} ont moins de couches : elles prendraient la plupart des éléments.</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Avertissements</translation>
    </message>
    <message>
        <source>What became thinner</source>
        <translation>Ce qui est devenu plus mince</translation>
    </message>
    <message>
        <source>What became thinner…</source>
        <translation>Ce qui est devenu plus mince…</translation>
    </message>
    <message>
        <source>What faces you is cut off. Choose the current view again after turning the part</source>
        <translation>Ce qui vous fait face est coupé. Choisissez de nouveau la vue actuelle après avoir tourné la pièce</translation>
    </message>
    <message>
        <source>What it says about a part</source>
        <translation>Ce qu’il dit d’une pièce</translation>
    </message>
    <message>
        <source>What to do with such a part</source>
        <translation>Que faire d’une telle pièce</translation>
    </message>
    <message>
        <source>What would change in</source>
        <translation>Ce qui changerait dans</translation>
    </message>
    <message>
        <source>What you change is saved as your own limits in {}.</source>
        <translation>Ce que vous modifiez est enregistré comme vos propres limites dans {}.</translation>
    </message>
    <message>
        <source>When a wall is thinner than</source>
        <translation>Si une paroi est plus mince que</translation>
    </message>
    <message>
        <source>When libraries have a part already</source>
        <translation>Quand les bibliothèques ont déjà une pièce</translation>
    </message>
    <message>
        <source>When the category of a part changes</source>
        <translation>Si la catégorie d’une pièce change</translation>
    </message>
    <message>
        <source>When the thinnest wall of a part falls below this thickness, or is below it in a part that was not classified before</source>
        <translation>Si la paroi la plus mince d’une pièce passe sous cette épaisseur, ou l’est déjà dans une pièce jamais classifiée</translation>
    </message>
    <message>
        <source>Where the thresholds are from</source>
        <translation>D’où viennent les seuils</translation>
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
        <source>Why it is left out, such as: a crush rib, thin on purpose</source>
        <translation>Pourquoi elle est écartée, par exemple : nervure d'écrasement, mince à dessein</translation>
    </message>
    <message>
        <source>Why, such as: a crush rib, thin on purpose</source>
        <translation>Pourquoi, par exemple : une nervure d’écrasement, mince à dessein</translation>
    </message>
    <message>
        <source>Why: {}</source>
        <translation>Raison : {}</translation>
    </message>
    <message>
        <source>With CalculiX as its solver, and steel, which you replace. Supports and loads are yours to add.</source>
        <translation>Avec CalculiX comme solveur et de l’acier, que vous remplacez. Les appuis et les charges restent à ajouter.</translation>
    </message>
    <message>
        <source>Without the check mark, a wall stays solid and is not in the shell.</source>
        <translation>Sans coche, une paroi reste en volume et n’est pas dans la coque.</translation>
    </message>
    <message>
        <source>Words in names, paths, notes, links</source>
        <translation>Mots des noms, chemins, notes, liens</translation>
    </message>
    <message>
        <source>Writes a page about all parts of the libraries, or of the selected one: how many there are of each kind, a map, what is there more than once, and a table</source>
        <translation>Écrit une page sur toutes les pièces des bibliothèques, ou de celle qui est sélectionnée : combien il y en a de chaque sorte, une carte, ce qui existe plusieurs fois, et un tableau</translation>
    </message>
    <message>
        <source>Write…</source>
        <translation>Écrire…</translation>
    </message>
    <message>
        <source>Writing a report</source>
        <translation>Rédaction d’un rapport</translation>
    </message>
    <message>
        <source>Writing a report about libraries</source>
        <translation>Rédaction d’un rapport sur des bibliothèques</translation>
    </message>
    <message>
        <source>Writing the info file…</source>
        <translation>Écriture du fichier d’information…</translation>
    </message>
    <message>
        <source>Writing {}…</source>
        <translation>Écriture de {}…</translation>
    </message>
    <message>
        <source>Written: {}</source>
        <translation>Écrit : {}</translation>
    </message>
    <message>
        <source>Your label is kept once the document is saved and its info file is written.</source>
        <translation>Votre étiquette sera gardée dès que le document sera enregistré et son fichier d’information écrit.</translation>
    </message>
    <message>
        <source>Your name</source>
        <translation>Votre nom</translation>
    </message>
    <message>
        <source>Your name, under which your labels of parts are kept. Empty: your name on this computer</source>
        <translation>Votre nom, sous lequel vos étiquettes de pièces sont gardées. Vide : votre nom sur cet ordinateur</translation>
    </message>
    <message>
        <source>a file with mesh settings</source>
        <translation>un fichier de paramètres de maillage</translation>
    </message>
    <message>
        <source>a folder with classified parts</source>
        <translation>un dossier de pièces classifiées</translation>
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
        <source>alike</source>
        <translation>semblable</translation>
    </message>
    <message>
        <source>all {} libraries</source>
        <translation>les {} bibliothèques</translation>
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
        <source>and a smaller wall, {} of the surface</source>
        <translation>et une paroi plus petite, {} de la surface</translation>
    </message>
    <message>
        <source>and {} more parts</source>
        <translation>et {} autres pièces</translation>
    </message>
    <message>
        <source>and {} smaller walls, {} of the surface</source>
        <translation>et {} parois plus petites, {} de la surface</translation>
    </message>
    <message>
        <source>any material</source>
        <translation>tout matériau</translation>
    </message>
    <message>
        <source>area with walls thinner than this share of the diagonal</source>
        <translation>surface à parois plus minces que cette part de la diagonale</translation>
    </message>
    <message>
        <source>as before</source>
        <translation>comme avant</translation>
    </message>
    <message>
        <source>as on this computer</source>
        <translation>comme sur cet ordinateur</translation>
    </message>
    <message>
        <source>as proposed</source>
        <translation>comme proposé</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatique</translation>
    </message>
    <message>
        <source>automatic: {}</source>
        <translation>automatique : {}</translation>
    </message>
    <message>
        <source>bar</source>
        <translation>barre</translation>
    </message>
    <message>
        <source>beside each document</source>
        <translation>à côté de chaque document</translation>
    </message>
    <message>
        <source>block</source>
        <translation>bloc</translation>
    </message>
    <message>
        <source>cancelled: finished results are saved, Start continues with the rest</source>
        <translation>annulé : les résultats obtenus sont enregistrés, « Démarrer » continue avec le reste</translation>
    </message>
    <message>
        <source>element size {}</source>
        <translation>taille d'élément {}</translation>
    </message>
    <message>
        <source>error aimed at: {}, elements: {}</source>
        <translation>erreur visée : {}, éléments : {}</translation>
    </message>
    <message>
        <source>excluded: {}</source>
        <translation>exclue : {}</translation>
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
        <source>fails</source>
        <translation>échoue</translation>
    </message>
    <message>
        <source>fine</source>
        <translation>fine</translation>
    </message>
    <message>
        <source>first, coarse colours</source>
        <translation>premières couleurs, grossières</translation>
    </message>
    <message>
        <source>from {} on</source>
        <translation>à partir de {}</translation>
    </message>
    <message>
        <source>gamma: three times the inscribed by the circumscribed radius; 1 for regular tetrahedra, under 0.3 poor</source>
        <translation>gamma : trois fois le rayon inscrit sur le rayon circonscrit ; 1 pour des tétraèdres réguliers, mauvais sous 0,3</translation>
    </message>
    <message>
        <source>height {}</source>
        <translation>hauteur {}</translation>
    </message>
    <message>
        <source>identical</source>
        <translation>identique</translation>
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
        <source>largest ball over {}: too thick</source>
        <translation>plus grande boule de plus de {} : trop épais</translation>
    </message>
    <message>
        <source>layers instead</source>
        <translation>des couches à la place</translation>
    </message>
    <message>
        <source>layers: {}, elements: {}</source>
        <translation>couches : {}, éléments : {}</translation>
    </message>
    <message>
        <source>learned</source>
        <translation>appris</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>omise</translation>
    </message>
    <message>
        <source>left solid: {}</source>
        <translation>reste en volume : {}</translation>
    </message>
    <message>
        <source>length {}</source>
        <translation>longueur {}</translation>
    </message>
    <message>
        <source>limit {}</source>
        <translation>limite {}</translation>
    </message>
    <message>
        <source>linear (first order)</source>
        <translation>linéaires (premier ordre)</translation>
    </message>
    <message>
        <source>measuring…</source>
        <translation>mesure…</translation>
    </message>
    <message>
        <source>min {}</source>
        <translation>min. {}</translation>
    </message>
    <message>
        <source>mirror image</source>
        <translation>image miroir</translation>
    </message>
    <message>
        <source>more than {}</source>
        <translation>plus de {}</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>no library yet</source>
        <translation>pas encore de bibliothèque</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>sans limite</translation>
    </message>
    <message>
        <source>no mesh ({})</source>
        <translation>pas de maillage ({})</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>none stated</source>
        <translation>aucune indiquée</translation>
    </message>
    <message>
        <source>none, or such as: FDM, die_casting:zinc</source>
        <translation>aucun, ou par exemple : FDM, die_casting:zinc</translation>
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
        <source>not in {}</source>
        <translation>pas dans {}</translation>
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
        <source>one size</source>
        <translation>taille unique</translation>
    </message>
    <message>
        <source>only as the verdict needs</source>
        <translation>seulement ce que le verdict exige</translation>
    </message>
    <message>
        <source>only in {}</source>
        <translation>seulement dans {}</translation>
    </message>
    <message>
        <source>own limit</source>
        <translation>limite propre</translation>
    </message>
    <message>
        <source>passes</source>
        <translation>conforme</translation>
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
        <source>pixels</source>
        <translation>pixels</translation>
    </message>
    <message>
        <source>plate</source>
        <translation>plaque</translation>
    </message>
    <message>
        <source>quadratic (second order)</source>
        <translation>quadratiques (second ordre)</translation>
    </message>
    <message>
        <source>quality of the elements (gamma)</source>
        <translation>qualité des éléments (gamma)</translation>
    </message>
    <message>
        <source>radius {}</source>
        <translation>rayon {}</translation>
    </message>
    <message>
        <source>red is thin</source>
        <translation>rouge = mince</translation>
    </message>
    <message>
        <source>rib</source>
        <translation>nervure</translation>
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
        <source>shell</source>
        <translation>coque</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>continu</translation>
    </message>
    <message>
        <source>solid</source>
        <translation>volume</translation>
    </message>
    <message>
        <source>standard</source>
        <translation>standard</translation>
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
        <source>taper</source>
        <translation>dépouille</translation>
    </message>
    <message>
        <source>the current view</source>
        <translation>la vue actuelle</translation>
    </message>
    <message>
        <source>the learned profile</source>
        <translation>du profil appris</translation>
    </message>
    <message>
        <source>the view cannot be drawn at this size</source>
        <translation>la vue ne peut pas être dessinée à cette taille</translation>
    </message>
    <message>
        <source>there is no importer for such files</source>
        <translation>il n’y a pas d’importateur pour ces fichiers</translation>
    </message>
    <message>
        <source>thickest wall {}</source>
        <translation>paroi la plus épaisse {}</translation>
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
        <source>those that people keep in its info files</source>
        <translation>celles gardées dans ses fichiers d’information</translation>
    </message>
    <message>
        <source>thread</source>
        <translation>filetage</translation>
    </message>
    <message>
        <source>to be measured again</source>
        <translation>à mesurer de nouveau</translation>
    </message>
    <message>
        <source>to keep</source>
        <translation>à garder</translation>
    </message>
    <message>
        <source>tooth</source>
        <translation>dent</translation>
    </message>
    <message>
        <source>tube</source>
        <translation>tube</translation>
    </message>
    <message>
        <source>under {}: fails</source>
        <translation>moins de {} : non conforme</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>up to {}</source>
        <translation>jusqu’à {}</translation>
    </message>
    <message>
        <source>up to {} above it</source>
        <translation>jusqu'à {} au-dessus</translation>
    </message>
    <message>
        <source>values are missing or of another kind</source>
        <translation>des valeurs manquent ou sont d’un autre type</translation>
    </message>
    <message>
        <source>wall {}</source>
        <translation>paroi {}</translation>
    </message>
    <message>
        <source>wedge {:g}–{:g}°</source>
        <translation>coin {:g}–{:g}°</translation>
    </message>
    <message>
        <source>width {}</source>
        <translation>largeur {}</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>{} (edge)</source>
        <translation>{} (arête)</translation>
    </message>
    <message>
        <source>{} (edge, {}×)</source>
        <translation>{} (arête, {}×)</translation>
    </message>
    <message>
        <source>{} (in searches and tables: {})</source>
        <translation>{} (dans les recherches et tableaux : {})</translation>
    </message>
    <message>
        <source>{} (own)</source>
        <translation>{} (propre)</translation>
    </message>
    <message>
        <source>{} (rule {})</source>
        <translation>« {} » (règle {})</translation>
    </message>
    <message>
        <source>{} (taper)</source>
        <translation>{} (dépouille)</translation>
    </message>
    <message>
        <source>{} (taper, {}×)</source>
        <translation>{} (dépouille, {}×)</translation>
    </message>
    <message>
        <source>{} (unsure)</source>
        <translation>{} (incertain)</translation>
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
        <source>{} ({}×)</source>
        <translation>{} ({}×)</translation>
    </message>
    <message>
        <source>{} Refresh the libraries to go on.</source>
        <translation>{} Actualisez les bibliothèques pour continuer.</translation>
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
        <source>{} cannot be reached.</source>
        <translation>{} est inaccessible.</translation>
    </message>
    <message>
        <source>{} cannot be written ({}): choose another place.</source>
        <translation>{} ne peut pas être écrit ({}) : choisissez un autre emplacement.</translation>
    </message>
    <message>
        <source>{} contains {}, which was removed from the list.</source>
        <translation>{} contient {}, qui a été retiré de la liste.</translation>
    </message>
    <message>
        <source>{} different parts, {} instances</source>
        <translation>{} pièces différentes, {} occurrences</translation>
    </message>
    <message>
        <source>{} elements, {} poor, worst {}</source>
        <translation>{} éléments, {} mauvais, le pire {}</translation>
    </message>
    <message>
        <source>{} entries</source>
        <translation>{} entrées</translation>
    </message>
    <message>
        <source>{} failed</source>
        <translation>{} en échec</translation>
    </message>
    <message>
        <source>{} fails</source>
        <translation>{} non conforme</translation>
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
        <source>{} has several parts, of which none is named {}.</source>
        <translation>{} a plusieurs pièces, dont aucune ne s’appelle {}.</translation>
    </message>
    <message>
        <source>{} info files cannot be read.</source>
        <translation>{} fichiers d’information sont illisibles.</translation>
    </message>
    <message>
        <source>{} info files were judged by another version of the profile {}.</source>
        <translation>{} fichiers d’information ont été jugés selon une autre version du profil {}.</translation>
    </message>
    <message>
        <source>{} info files were not changed: {}</source>
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
        <source>{} jobs: {}</source>
        <translation>{} tâches : {}</translation>
    </message>
    <message>
        <source>{} just above</source>
        <translation>{} juste au-dessus</translation>
    </message>
    <message>
        <source>{} labelled parts: {}; by {}.</source>
        <translation>{} pièces étiquetées : {} ; par {}.</translation>
    </message>
    <message>
        <source>{} mid-surface</source>
        <translation>{} : surface moyenne</translation>
    </message>
    <message>
        <source>{} min</source>
        <translation>{} min</translation>
    </message>
    <message>
        <source>{} of the area has walls thinner than {}</source>
        <translation>{} de la surface a des parois plus minces que {}</translation>
    </message>
    <message>
        <source>{} of the volume in plate-like walls, {} times as wide as thick.</source>
        <translation>{} du volume en parois de type plaque, {} fois plus larges qu’épaisses.</translation>
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
        <source>{} of {} parts change their category.</source>
        <translation>{} pièces sur {} changent de catégorie.</translation>
    </message>
    <message>
        <source>{} of {} parts fail</source>
        <translation>{} pièces sur {} échouent</translation>
    </message>
    <message>
        <source>{} of {}: elements of {}</source>
        <translation>{} de {} : éléments de {}</translation>
    </message>
    <message>
        <source>{} of {}: {} % ({} to {})</source>
        <translation>{} sur {} : {} % ({} à {})</translation>
    </message>
    <message>
        <source>{} passes</source>
        <translation>{} conforme</translation>
    </message>
    <message>
        <source>{} probes were removed: the surface is no longer at their positions.</source>
        <translation>{} sondes ont été retirées : la surface ne se trouve plus à ces endroits.</translation>
    </message>
    <message>
        <source>{} s</source>
        <translation>{} s</translation>
    </message>
    <message>
        <source>{} shell mesh</source>
        <translation>{} : maillage de coque</translation>
    </message>
    <message>
        <source>{} thick</source>
        <translation>épaisseur {}</translation>
    </message>
    <message>
        <source>{} times as large</source>
        <translation>{} fois plus grande</translation>
    </message>
    <message>
        <source>{} to {}</source>
        <translation>{} à {}</translation>
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
        <source>{} too thick</source>
        <translation>{} trop épais</translation>
    </message>
    <message>
        <source>{} triangles of up to {}; walls {} thick, {} of the part's volume.</source>
        <translation>{} triangles jusqu’à {} ; parois de {} d’épaisseur, {} du volume de la pièce.</translation>
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
        <source>{} was not opened: it is not a CAD file that ThinPart reads.</source>
        <translation>{} n’a pas été ouvert : ce n’est pas un fichier CAO que ThinPart lit.</translation>
    </message>
    <message>
        <source>{} was not written by ThinPart.</source>
        <translation>{} n'a pas été écrit par ThinPart.</translation>
    </message>
    <message>
        <source>{}, and share of the diagonal</source>
        <translation>{} et part de la diagonale</translation>
    </message>
    <message>
        <source>{}, mirrored</source>
        <translation>{}, en miroir</translation>
    </message>
    <message>
        <source>{}, {}: {}</source>
        <translation>{}, {} : {}</translation>
    </message>
    <message>
        <source>{}. {}, where one of these holds</source>
        <translation>{}. {}, si l’un de ceux-ci est rempli</translation>
    </message>
    <message>
        <source>{}: '{}' ({}) has a wall of {}, below the limit of {}.</source>
        <translation>{} : « {} » ({}) a une paroi de {}, sous la limite de {}.</translation>
    </message>
    <message>
        <source>{}: '{}' was '{}' and is '{}' now; its thinnest wall is {}.</source>
        <translation>{} : « {} » était « {} » et est maintenant « {} » ; sa paroi la plus mince a {}.</translation>
    </message>
    <message>
        <source>{}: '{}' was '{}' and is '{}' now; its thinnest wall of {} is below the limit of {}.</source>
        <translation>{} : « {} » était « {} » et est maintenant « {} » ; sa paroi la plus mince de {} est sous la limite de {}.</translation>
    </message>
    <message>
        <source>{}: '{}' was '{}' and is '{}' now; none of its walls could be measured.</source>
        <translation>{} : « {} » était « {} » et est maintenant « {} » ; aucune de ses parois n’a pu être mesurée.</translation>
    </message>
    <message>
        <source>{}: an earlier version of ThinPart has measured this document, but not all that decides today: classify it again.</source>
        <translation>{} : une version antérieure de ThinPart a mesuré ce document, mais pas tout ce qui décide aujourd'hui : classez-le de nouveau.</translation>
    </message>
    <message>
        <source>{}: looking for info files, {} so far</source>
        <translation>{} : recherche des fichiers d’information, {} jusqu’ici</translation>
    </message>
    <message>
        <source>{}: walls {} ({})</source>
        <translation>{} : parois {} ({})</translation>
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
    <message>
        <source>✓ {}: within the limits</source>
        <translation>✓ {} : dans les limites</translation>
    </message>
    <message>
        <source>✗ The largest ball here is too large: at most {} are allowed</source>
        <translation>✗ La plus grande boule est trop grande ici : au plus {} sont admis</translation>
    </message>
    <message>
        <source>✗ {}: at least {} are needed here</source>
        <translation>✗ {} : il faut au moins {} ici</translation>
    </message>
</context>
<context>
    <name>ThinPartCore</name>
    <message>
        <source>'{object}' has an empty shape: recompute the document or delete it.</source>
        <translation>« {object} » a une forme vide : recalculez le document ou supprimez l’objet.</translation>
    </message>
    <message>
        <source>'{object}' has no shape, because its last recompute failed ({reason}): repair it and recompute the document.</source>
        <translation>« {object} » n’a pas de forme, car son dernier recalcul a échoué ({reason}) : réparez l’objet et recalculez le document.</translation>
    </message>
    <message>
        <source>'{object}' has no shape, because the last recompute of '{feature}' failed ({reason}): repair it and recompute the document.</source>
        <translation>« {object} » n’a pas de forme, car le dernier recalcul de « {feature} » a échoué ({reason}) : réparez l’objet et recalculez le document.</translation>
    </message>
    <message>
        <source>'{object}' is a closed shell but not a solid: convert it to a solid first.</source>
        <translation>« {object} » est une coque fermée mais pas un solide : convertissez-la d’abord en solide.</translation>
    </message>
    <message>
        <source>'{object}' is a mesh without triangles: import it again or delete it.</source>
        <translation>« {object} » est un maillage sans triangles : importez-le à nouveau ou supprimez-le.</translation>
    </message>
    <message>
        <source>'{object}' is made of surfaces that bound no solid: close or thicken it first.</source>
        <translation>« {object} » est fait de surfaces qui ne délimitent aucun solide : fermez-les ou épaississez-les d’abord.</translation>
    </message>
    <message>
        <source>'{part}' consists of {count} solids, which FEM meshes as one: take it apart first (Part workbench: Compound &gt; Explode compound), then select one solid.</source>
        <translation>« {part} » est constitué de {count} solides, que FEM maille ensemble : séparez-les d'abord (atelier Part : Composé &gt; Éclater le composé), puis sélectionnez un solide.</translation>
    </message>
    <message>
        <source>(in no folder of its own)</source>
        <translation>(dans aucun dossier propre)</translation>
    </message>
    <message>
        <source>(the ring is at the thinnest wall)</source>
        <translation>(l’anneau marque la paroi la plus mince)</translation>
    </message>
    <message>
        <source>, not sure</source>
        <translation>, sans certitude</translation>
    </message>
    <message>
        <source>, not watertight</source>
        <translation>, non fermé</translation>
    </message>
    <message>
        <source>, {count} times in the document</source>
        <translation>, {count} fois dans le document</translation>
    </message>
    <message>
        <source>--bands takes a number from 0, for smooth colours, to 64.</source>
        <translation>--bands prend un nombre de 0, pour des couleurs continues, à 64.</translation>
    </message>
    <message>
        <source>--error decides the sizes of elements of second order: leave out --layers and --order 1.</source>
        <translation>--error détermine les tailles d'éléments du second ordre : omettez --layers et --order 1.</translation>
    </message>
    <message>
        <source>--keep goes with --check, which shows what works.</source>
        <translation>--keep va avec --check, qui montre ce qui marche.</translation>
    </message>
    <message>
        <source>--library reads info files only, and takes no {option}: leave it out.</source>
        <translation>--library ne lit que des fichiers d’information et n’accepte pas {option} : omettez-le.</translation>
    </message>
    <message>
        <source>--like is for one part: name one file.</source>
        <translation>--like vaut pour une seule pièce : nommez un fichier.</translation>
    </message>
    <message>
        <source>--range takes the thinner wall first, then the thicker: not {low} and {high}.</source>
        <translation>--range prend d’abord la paroi la plus mince, puis la plus épaisse : pas {low} et {high}.</translation>
    </message>
    <message>
        <source>1 document has no info file and is not on this page: 'thinpart classify' measures it.</source>
        <translation>1 document n’a pas de fichier d’information et manque sur cette page : « thinpart classify » le mesure.</translation>
    </message>
    <message>
        <source>1 duplicate triangle was left out.</source>
        <translation>1 triangle en double a été omis.</translation>
    </message>
    <message>
        <source>1 part is not on the map: no wall was found opposite, or its surface is not closed.</source>
        <translation>1 pièce n’est pas sur la carte : aucune paroi n’a été trouvée en face, ou sa surface n’est pas fermée.</translation>
    </message>
    <message>
        <source>1 triangle of zero area was left out.</source>
        <translation>1 triangle d’aire nulle a été omis.</translation>
    </message>
    <message>
        <source>1 warning</source>
        <translation>1 avertissement</translation>
    </message>
    <message>
        <source>A budget is at least 1 element, not {value}.</source>
        <translation>Un budget est d'au moins 1 élément, pas de {value}.</translation>
    </message>
    <message>
        <source>A bulky part with thin places: refine the mesh there or remove them.</source>
        <translation>Une pièce massive avec des endroits minces : affinez-y le maillage ou supprimez-les.</translation>
    </message>
    <message>
        <source>A limit for single faces needs a reason.</source>
        <translation>Une limite pour des faces isolées demande une raison.</translation>
    </message>
    <message>
        <source>A script or a shell is for one part, and there are {count} documents: name one of them, or the part after --part.</source>
        <translation>Un script ou une coque est pour une seule pièce, et il y a {count} documents : nommez-en un, ou la pièce après --part.</translation>
    </message>
    <message>
        <source>ABS</source>
        <translation>ABS</translation>
    </message>
    <message>
        <source>Acetal (POM)</source>
        <translation>Polyacétal (POM)</translation>
    </message>
    <message>
        <source>Across:</source>
        <translation>Horizontalement :</translation>
    </message>
    <message>
        <source>Acrylic (PMMA)</source>
        <translation>Acrylique (PMMA)</translation>
    </message>
    <message>
        <source>Alike</source>
        <translation>Semblables</translation>
    </message>
    <message>
        <source>Alike: {percent:.0f} % of the surface is the same, the rest up to {apart:.2g} apart.</source>
        <translation>Semblable : {percent:.0f} % de la surface sont identiques, le reste s’en écarte jusqu’à {apart:.2g}.</translation>
    </message>
    <message>
        <source>Alike: {percent:.0f} % of the surface is the same.</source>
        <translation>Semblable : {percent:.0f} % de la surface sont identiques.</translation>
    </message>
    <message>
        <source>All its triangles have zero area.</source>
        <translation>Tous ses triangles ont une aire nulle.</translation>
    </message>
    <message>
        <source>All parts</source>
        <translation>Toutes les pièces</translation>
    </message>
    <message>
        <source>All parts of this report</source>
        <translation>Toutes les pièces de ce rapport</translation>
    </message>
    <message>
        <source>All points coincide.</source>
        <translation>Tous les points coïncident.</translation>
    </message>
    <message>
        <source>All walls are to stay solid: choose at least one for the shell.</source>
        <translation>Toutes les parois doivent rester en volume : choisissez-en au moins une pour la coque.</translation>
    </message>
    <message>
        <source>Aluminium</source>
        <translation>Aluminium</translation>
    </message>
    <message>
        <source>Aluminium, large casting</source>
        <translation>Aluminium, grande pièce</translation>
    </message>
    <message>
        <source>Aluminium, small casting</source>
        <translation>Aluminium, petite pièce</translation>
    </message>
    <message>
        <source>An earlier version has measured {file}: classify it again, to compare it.</source>
        <translation>Une version antérieure a mesuré {file} : classifiez-le à nouveau pour le comparer.</translation>
    </message>
    <message>
        <source>Area of its surface</source>
        <translation>Aire de sa surface</translation>
    </message>
    <message>
        <source>Area, {unit}</source>
        <translation>Aire, {unit}</translation>
    </message>
    <message>
        <source>At least, {unit}</source>
        <translation>Au moins, {unit}</translation>
    </message>
    <message>
        <source>At most, {unit}</source>
        <translation>Au plus, {unit}</translation>
    </message>
    <message>
        <source>At the thinnest wall, {thickness} between {face} and {opposite}</source>
        <translation>À la paroi la plus mince, {thickness} entre {face} et {opposite}</translation>
    </message>
    <message>
        <source>Bar chart: share of the surface over walls of each thickness, up to {end}; walls under {limit} count as thin</source>
        <translation>Histogramme : part de la surface sur des parois de chaque épaisseur, jusqu’à {end} ; les parois sous {limit} comptent comme minces</translation>
    </message>
    <message>
        <source>Belongs to</source>
        <translation>Appartient à</translation>
    </message>
    <message>
        <source>Borderline: close to “{other}” ({margin} from the limit).</source>
        <translation>Cas limite : proche de « {other} » ({margin} de la limite).</translation>
    </message>
    <message>
        <source>Bounding box</source>
        <translation>Boîte englobante</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Boîte</translation>
    </message>
    <message>
        <source>Brass, large casting</source>
        <translation>Laiton, grande pièce</translation>
    </message>
    <message>
        <source>Brass, small casting</source>
        <translation>Laiton, petite pièce</translation>
    </message>
    <message>
        <source>By category</source>
        <translation>Par catégorie</translation>
    </message>
    <message>
        <source>By the paper's criteria: unknown. {reason}</source>
        <translation>Selon les critères de l’article : inconnue. {reason}</translation>
    </message>
    <message>
        <source>By the paper's criteria: {category} (criterion {number}: {figures}).</source>
        <translation>Selon les critères de l’article : {category} (critère {number} : {figures}).</translation>
    </message>
    <message>
        <source>By the paper's criteria: {category} (criterion {number}: {figures}; also {others}).</source>
        <translation>Selon les critères de l’article : {category} (critère {number} : {figures} ; aussi {others}).</translation>
    </message>
    <message>
        <source>By the paper's criteria: {category} (no criterion holds).</source>
        <translation>Selon les critères de l’article : {category} (aucun critère n’est rempli).</translation>
    </message>
    <message>
        <source>By the paper’s thresholds</source>
        <translation>D’après les seuils de l’article</translation>
    </message>
    <message>
        <source>Calibrated on real parts</source>
        <translation>Calibré sur des pièces réelles</translation>
    </message>
    <message>
        <source>Category</source>
        <translation>Catégorie</translation>
    </message>
    <message>
        <source>Clear verdict: {margin} from the limit.</source>
        <translation>Verdict net : {margin} de la limite.</translation>
    </message>
    <message>
        <source>Colours from {low} to {high} and more; grey where nothing was measured</source>
        <translation>Couleurs de {low} à {high} et plus ; gris là où rien n’a été mesuré</translation>
    </message>
    <message>
        <source>Colours stand for the diameter of the largest ball inside that touches the surface there, which goes down to nothing at sharp edges. Verdict, tables and the thinnest wall are measured straight across.</source>
        <translation>Les couleurs représentent le diamètre de la plus grande bille intérieure qui touche la surface à cet endroit ; il tend vers zéro aux arêtes vives. Le verdict, les tableaux et la paroi la plus mince sont mesurés tout droit à travers la paroi.</translation>
    </message>
    <message>
        <source>Colours stand for the local thickness, the diameter of the largest ball inside that reaches the surface there. Verdict, tables and the thinnest wall are measured straight across.</source>
        <translation>Les couleurs représentent l’épaisseur locale, le diamètre de la plus grande bille intérieure qui y atteint la surface. Le verdict, les tableaux et la paroi la plus mince sont mesurés tout droit à travers la paroi.</translation>
    </message>
    <message>
        <source>Connected walls of like thickness, equal ones in one row; the thinnest first</source>
        <translation>Parois continues d’épaisseur semblable, les identiques sur une ligne ; la plus mince d’abord</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Sommaire</translation>
    </message>
    <message>
        <source>Could not be measured</source>
        <translation>N’a pas pu être mesuré</translation>
    </message>
    <message>
        <source>Counts</source>
        <translation>Nombres</translation>
    </message>
    <message>
        <source>Cutting the mid-faces of the walls to each other takes too long, as there are too many that nearly touch: mesh it as a solid.</source>
        <translation>Couper les faces moyennes des parois entre elles prend trop de temps, car trop d’entre elles se touchent presque : maillez la pièce en volume.</translation>
    </message>
    <message>
        <source>Developed width, {unit}</source>
        <translation>Largeur développée, {unit}</translation>
    </message>
    <message>
        <source>Diagonal of the bounding box</source>
        <translation>Diagonale de la boîte englobante</translation>
    </message>
    <message>
        <source>Die casting</source>
        <translation>Moulage sous pression</translation>
    </message>
    <message>
        <source>Document</source>
        <translation>Document</translation>
    </message>
    <message>
        <source>Ductile iron</source>
        <translation>Fonte ductile</translation>
    </message>
    <message>
        <source>Error of a wall at most</source>
        <translation>Erreur d’une paroi, au plus</translation>
    </message>
    <message>
        <source>Every criterion of the profile “{profile}” with what was measured; the category is the first of which one criterion holds</source>
        <translation>Chaque critère du profil « {profile} » avec les mesures ; la catégorie est la première dont un critère est rempli</translation>
    </message>
    <message>
        <source>FDM printing</source>
        <translation>Impression FDM</translation>
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
        <source>Faces that meet in a thin wedge</source>
        <translation>Faces formant un coin mince</translation>
    </message>
    <message>
        <source>Faces: {faces} and {count} more.</source>
        <translation>Faces : {faces} et {count} autres.</translation>
    </message>
    <message>
        <source>Faces: {faces}.</source>
        <translation>Faces : {faces}.</translation>
    </message>
    <message>
        <source>Families</source>
        <translation>Familles</translation>
    </message>
    <message>
        <source>Family {number}: {part}, {count} parts</source>
        <translation>Famille {number} : {part}, {count} pièces</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Remplissage</translation>
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
        <source>Folder</source>
        <translation>Dossier</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Free-standing</source>
        <translation>Libre</translation>
    </message>
    <message>
        <source>FreeCAD cannot be imported by {program} ({problem}): install it (Debian: 'apt-get install freecad') or set FREECAD_LIB to the folder with its FreeCAD.so or FreeCAD.pyd.</source>
        <translation>FreeCAD ne peut pas être importé par {program} ({problem}) : installez-le (Debian : « apt-get install freecad ») ou donnez à FREECAD_LIB le dossier de son FreeCAD.so ou FreeCAD.pyd.</translation>
    </message>
    <message>
        <source>FreeCAD cannot open {file} ({problem}).</source>
        <translation>FreeCAD ne peut pas ouvrir {file} ({problem}).</translation>
    </message>
    <message>
        <source>FreeCAD cannot read it</source>
        <translation>FreeCAD ne peut pas le lire</translation>
    </message>
    <message>
        <source>FreeCAD cannot read it: open it in the program it came from, and export it again</source>
        <translation>FreeCAD ne peut pas le lire : ouvrez-le dans le programme d’origine et exportez-le à nouveau</translation>
    </message>
    <message>
        <source>FreeCAD cannot read {file} ({problem}).</source>
        <translation>FreeCAD ne peut pas lire {file} ({problem}).</translation>
    </message>
    <message>
        <source>FreeCAD cannot write them</source>
        <translation>FreeCAD ne peut pas les écrire</translation>
    </message>
    <message>
        <source>FreeCAD could not tessellate any of its faces.</source>
        <translation>FreeCAD n’a pu tesseller aucune de ses faces.</translation>
    </message>
    <message>
        <source>FreeCAD could not tessellate it ({problem}).</source>
        <translation>FreeCAD n’a pas pu tesseller la pièce ({problem}).</translation>
    </message>
    <message>
        <source>FreeCAD could not tessellate {faces} and {count} more.</source>
        <translation>FreeCAD n’a pas pu tesseller {faces} et {count} autres.</translation>
    </message>
    <message>
        <source>FreeCAD could not tessellate {faces}.</source>
        <translation>FreeCAD n’a pas pu tesseller {faces}.</translation>
    </message>
    <message>
        <source>FreeCAD did not say which triangle belongs to which face.</source>
        <translation>FreeCAD n’a pas indiqué à quelle face appartient chaque triangle.</translation>
    </message>
    <message>
        <source>FreeCAD does not follow links from a document whose path is not UTF-8 text or has a backslash: rename {file} or its folder.</source>
        <translation>FreeCAD ne suit aucun lien depuis un document dont le chemin n'est pas du texte UTF-8 ou contient une barre oblique inverse : renommez {file} ou son dossier.</translation>
    </message>
    <message>
        <source>FreeCAD finds no cut</source>
        <translation>FreeCAD ne trouve pas de coupe</translation>
    </message>
    <message>
        <source>FreeCAD needs a home folder, but {folder} is not accessible: set FREECAD_USER_HOME to a folder that is.</source>
        <translation>FreeCAD a besoin d’un dossier personnel, mais {folder} n’est pas accessible : donnez à FREECAD_USER_HOME un dossier accessible.</translation>
    </message>
    <message>
        <source>FreeCAD's mesher left out {left_out}: a copy was measured whose edges were fitted to its faces; check the shape of the part, and export it again if it is damaged.</source>
        <translation>Le mailleur de FreeCAD a omis {left_out} : une copie dont les arêtes ont été ajustées aux faces a été mesurée ; vérifiez la forme de la pièce, et exportez-la à nouveau si elle est endommagée.</translation>
    </message>
    <message>
        <source>FreeCAD's mesher left out {left_out}: a copy was measured whose surfaces were converted to splines; its volume agrees with that of the part.</source>
        <translation>Le mailleur de FreeCAD a omis {left_out} : une copie dont les surfaces ont été converties en splines a été mesurée ; son volume concorde avec celui de la pièce.</translation>
    </message>
    <message>
        <source>From behind, below</source>
        <translation>De derrière, par en dessous</translation>
    </message>
    <message>
        <source>From the front, above</source>
        <translation>De devant, par le dessus</translation>
    </message>
    <message>
        <source>From the thinnest wall of polypropylene to the thickest of polyethylene: choose the resin for its own limits.</source>
        <translation>De la paroi la plus mince en polypropylène à la plus épaisse en polyéthylène : choisissez la résine pour avoir ses propres limites.</translation>
    </message>
    <message>
        <source>Further faces; all of them are in faces.csv as well</source>
        <translation>Autres faces ; toutes sont aussi dans faces.csv</translation>
    </message>
    <message>
        <source>Giannini et al. 2012</source>
        <translation>Giannini et coll. 2012</translation>
    </message>
    <message>
        <source>Giannini, Petton, Pernot: Categorization of CAD models based on thin part identification, TMCE 2012, tables 1 and 2</source>
        <translation>Giannini, Petton, Pernot : Categorization of CAD models based on thin part identification, TMCE 2012, tableaux 1 et 2</translation>
    </message>
    <message>
        <source>Gmsh crashed</source>
        <translation>Gmsh a planté</translation>
    </message>
    <message>
        <source>Gmsh filled no volume</source>
        <translation>Gmsh n’a rempli aucun volume</translation>
    </message>
    <message>
        <source>Gmsh needed too much memory</source>
        <translation>Gmsh a demandé trop de mémoire</translation>
    </message>
    <message>
        <source>Gmsh took too long</source>
        <translation>Gmsh a pris trop de temps</translation>
    </message>
    <message>
        <source>Gmsh wrote no mesh</source>
        <translation>Gmsh n’a pas écrit de maillage</translation>
    </message>
    <message>
        <source>Grey iron</source>
        <translation>Fonte grise</translation>
    </message>
    <message>
        <source>Group {number}: {part}, {count} parts</source>
        <translation>Groupe {number} : {part}, {count} pièces</translation>
    </message>
    <message>
        <source>Held on two sides</source>
        <translation>Tenue de deux côtés</translation>
    </message>
    <message>
        <source>Holds</source>
        <translation>Rempli</translation>
    </message>
    <message>
        <source>How it was measured</source>
        <translation>Comment la mesure a été faite</translation>
    </message>
    <message>
        <source>How near it is to another category cannot be told.</source>
        <translation>La distance à une autre catégorie ne peut pas être donnée.</translation>
    </message>
    <message>
        <source>Identical</source>
        <translation>Identiques</translation>
    </message>
    <message>
        <source>Info files cannot be written into {folder} ({problem}): give another folder to --info-dir.</source>
        <translation>Les fichiers d’information ne peuvent pas être écrits dans {folder} ({problem}) : choisissez un autre dossier (--info-dir).</translation>
    </message>
    <message>
        <source>Injection moulding</source>
        <translation>Moulage par injection</translation>
    </message>
    <message>
        <source>It came as {faces} loose faces, which were sewn together.</source>
        <translation>La pièce était faite de {faces} faces libres, qui ont été cousues.</translation>
    </message>
    <message>
        <source>It holds no triangles.</source>
        <translation>Il ne contient aucun triangle.</translation>
    </message>
    <message>
        <source>It is {length:.4g} higher.</source>
        <translation>Elle est plus haute de {length:.4g}.</translation>
    </message>
    <message>
        <source>It is {length:.4g} longer.</source>
        <translation>Elle est plus longue de {length:.4g}.</translation>
    </message>
    <message>
        <source>It is {length:.4g} lower.</source>
        <translation>Elle est plus basse de {length:.4g}.</translation>
    </message>
    <message>
        <source>It is {length:.4g} narrower.</source>
        <translation>Elle est plus étroite de {length:.4g}.</translation>
    </message>
    <message>
        <source>It is {length:.4g} shorter.</source>
        <translation>Elle est plus courte de {length:.4g}.</translation>
    </message>
    <message>
        <source>It is {length:.4g} wider.</source>
        <translation>Elle est plus large de {length:.4g}.</translation>
    </message>
    <message>
        <source>Its bounding box is empty or not finite.</source>
        <translation>Sa boîte englobante est vide ou infinie.</translation>
    </message>
    <message>
        <source>Its faces</source>
        <translation>Ses faces</translation>
    </message>
    <message>
        <source>Its surface encloses no volume.</source>
        <translation>Sa surface n’enferme aucun volume.</translation>
    </message>
    <message>
        <source>Its walls</source>
        <translation>Ses parois</translation>
    </message>
    <message>
        <source>Judged by the profile “{profile}”.</source>
        <translation>Jugé d’après le profil « {profile} ».</translation>
    </message>
    <message>
        <source>Labels:</source>
        <translation>Étiquettes :</translation>
    </message>
    <message>
        <source>Layers are from 0.1 to {most:g}, not {value:g}.</source>
        <translation>Les couches vont de 0,1 à {most:g}, pas {value:g}.</translation>
    </message>
    <message>
        <source>Learned on {date} from labels of {count} parts by {people}, starting at the profile {start}</source>
        <translation>Appris le {date} à partir des étiquettes de {count} pièces par {people}, en partant du profil {start}</translation>
    </message>
    <message>
        <source>Learning needs the Python package scikit-learn ({problem}): install it (Debian: 'apt-get install python3-sklearn', elsewhere: 'python -m pip install scikit-learn').</source>
        <translation>L’apprentissage a besoin du paquet Python scikit-learn ({problem}) : installez-le (Debian : « apt-get install python3-sklearn », ailleurs : « python -m pip install scikit-learn »).</translation>
    </message>
    <message>
        <source>Least distance, in diagonals, between walls at a to b degrees</source>
        <translation>Plus petite distance, en diagonales, entre parois formant un angle de a à b degrés</translation>
    </message>
    <message>
        <source>Least distance, in diagonals, between walls at {low:g} to {high:g} degrees</source>
        <translation>Plus petite distance, en diagonales, entre parois à un angle de {low:g} à {high:g} degrés</translation>
    </message>
    <message>
        <source>Least width of a face: twice its area by the length of its border</source>
        <translation>Plus petite largeur d'une face : deux fois son aire par la longueur de son bord</translation>
    </message>
    <message>
        <source>Least, {unit}</source>
        <translation>Minimum, {unit}</translation>
    </message>
    <message>
        <source>Length of knife's edges, faces that meet at under 30 degrees, in diagonals</source>
        <translation>Longueur des arêtes vives, où des faces se rejoignent sous moins de 30 degrés, en diagonales</translation>
    </message>
    <message>
        <source>Length of the shortest edge</source>
        <translation>Longueur de l'arête la plus courte</translation>
    </message>
    <message>
        <source>Length, {unit}</source>
        <translation>Longueur, {unit}</translation>
    </message>
    <message>
        <source>Library of 1 part</source>
        <translation>Bibliothèque d’une pièce</translation>
    </message>
    <message>
        <source>Library of {count} parts</source>
        <translation>Bibliothèque de {count} pièces</translation>
    </message>
    <message>
        <source>Light alloys in green sand; iron needs more.</source>
        <translation>Alliages légers en sable vert ; la fonte demande plus.</translation>
    </message>
    <message>
        <source>Limits for single faces are lengths over 0, the least one no greater than the other.</source>
        <translation>Les limites pour des faces isolées sont des longueurs supérieures à 0, la plus petite ne dépassant pas l’autre.</translation>
    </message>
    <message>
        <source>Limits of the wall</source>
        <translation>Limites de la paroi</translation>
    </message>
    <message>
        <source>Liquid crystal polymer</source>
        <translation>Polymère à cristaux liquides</translation>
    </message>
    <message>
        <source>Local thickness below which 5 % of the area is, in diagonals</source>
        <translation>Épaisseur locale au-dessous de laquelle se trouvent 5 % de l'aire, en diagonales</translation>
    </message>
    <message>
        <source>Local thickness, by the middle side, that 5 % of the area is below</source>
        <translation>Épaisseur locale, par le côté médian, sous laquelle se trouvent 5 % de la surface</translation>
    </message>
    <message>
        <source>Local thickness, by the middle side, that 75 % of the area is below</source>
        <translation>Épaisseur locale, par le côté médian, sous laquelle se trouvent 75 % de la surface</translation>
    </message>
    <message>
        <source>Local thickness, by the middle side, that 99 % of the area is below</source>
        <translation>Épaisseur locale, par le côté médian, sous laquelle se trouvent 99 % de la surface</translation>
    </message>
    <message>
        <source>Long-fibre reinforced plastics</source>
        <translation>Plastiques renforcés de fibres longues</translation>
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
        <source>Machining</source>
        <translation>Usinage</translation>
    </message>
    <message>
        <source>Made by</source>
        <translation>Créée par</translation>
    </message>
    <message>
        <source>Made of what info files keep; no document was read.</source>
        <translation>Établie à partir des fichiers d’information ; aucun document n’a été lu.</translation>
    </message>
    <message>
        <source>Magnesium, large casting</source>
        <translation>Magnésium, grande pièce</translation>
    </message>
    <message>
        <source>Magnesium, small casting</source>
        <translation>Magnésium, petite pièce</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Carte</translation>
    </message>
    <message>
        <source>Map of the parts</source>
        <translation>Carte des pièces</translation>
    </message>
    <message>
        <source>Map of {count} parts: across, the median wall as a share of the diagonal of the box; upwards, the share of its box that a part fills</source>
        <translation>Carte de {count} pièces : horizontalement, la paroi médiane en part de la diagonale de la boîte ; verticalement, la part de sa boîte que remplit une pièce</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Marge</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Signification</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Mesuré</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Médiane</translation>
    </message>
    <message>
        <source>Median of the local thickness, by the middle side</source>
        <translation>Médiane de l’épaisseur locale, par le côté médian</translation>
    </message>
    <message>
        <source>Median thickness of the thinnest ribs, pins, teeth or thread on a solid core, by the middle side; 1 without any</source>
        <translation>Épaisseur médiane des nervures, broches, dents ou du filetage les plus minces sur un noyau massif, rapportée au côté moyen ; 1 s’il n’y en a pas</translation>
    </message>
    <message>
        <source>Median thickness of the thinnest wall region</source>
        <translation>Épaisseur médiane de la région de paroi la plus mince</translation>
    </message>
    <message>
        <source>Median wall</source>
        <translation>Paroi médiane</translation>
    </message>
    <message>
        <source>Median, {unit}</source>
        <translation>Médiane, {unit}</translation>
    </message>
    <message>
        <source>Mesh settings</source>
        <translation>Paramètres de maillage</translation>
    </message>
    <message>
        <source>Meshing needs Gmsh: install it (Debian: 'apt-get install gmsh', elsewhere: https://gmsh.info), and see that 'gmsh --version' runs.</source>
        <translation>Le maillage demande Gmsh : installez-le (Debian : 'apt-get install gmsh', ailleurs : https://gmsh.info), et vérifiez que 'gmsh --version' fonctionne.</translation>
    </message>
    <message>
        <source>Metal</source>
        <translation>Métal</translation>
    </message>
    <message>
        <source>Metals; plastics bend and soften.</source>
        <translation>Métaux ; les plastiques fléchissent et se ramollissent.</translation>
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
        <source>Mirror images of the part to keep.</source>
        <translation>Images miroir de la pièce à conserver.</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>Symétriques</translation>
    </message>
    <message>
        <source>More than once</source>
        <translation>En plusieurs exemplaires</translation>
    </message>
    <message>
        <source>Most of the surface is the same, the rest is not: a hole more, another length.</source>
        <translation>La plus grande part de la surface est la même, le reste non : un trou de plus, une autre longueur.</translation>
    </message>
    <message>
        <source>Name what to write: --png FILE, --vtp FILE or --ply FILE.</source>
        <translation>Indiquez ce qui est à écrire : --png FICHIER, --vtp FICHIER ou --ply FICHIER.</translation>
    </message>
    <message>
        <source>Neither clearly solid nor clearly thin: {walls}.</source>
        <translation>Ni clairement massive ni clairement mince : {walls}.</translation>
    </message>
    <message>
        <source>Netgen failed</source>
        <translation>Netgen a échoué</translation>
    </message>
    <message>
        <source>Netgen took too long</source>
        <translation>Netgen a mis trop de temps</translation>
    </message>
    <message>
        <source>Next parts</source>
        <translation>Pièces suivantes</translation>
    </message>
    <message>
        <source>No criterion holds: its walls are thick all over.</source>
        <translation>Aucun critère n’est rempli : ses parois sont épaisses partout.</translation>
    </message>
    <message>
        <source>No part has all of these words.</source>
        <translation>Aucune pièce n’a tous ces mots.</translation>
    </message>
    <message>
        <source>No part is labelled {categories}: label at least {needed} parts of every category.</source>
        <translation>Aucune pièce n’est étiquetée {categories} : étiquetez au moins {needed} pièces de chaque catégorie.</translation>
    </message>
    <message>
        <source>No part like {part} has mesh settings that worked: the usual ones are used.</source>
        <translation>Aucune pièce semblable à {part} n'a de réglages de maillage éprouvés : les réglages habituels sont utilisés.</translation>
    </message>
    <message>
        <source>No report can be written into {folder} ({problem}): give another folder.</source>
        <translation>Aucun rapport ne peut être écrit dans {folder} ({problem}) : indiquez un autre dossier.</translation>
    </message>
    <message>
        <source>No wall could be measured.</source>
        <translation>Aucune paroi n’a pu être mesurée.</translation>
    </message>
    <message>
        <source>No wall is wide and thin enough for a shell: mesh it as a solid.</source>
        <translation>Aucune paroi n’est assez large et mince pour une coque : maillez la pièce comme solide.</translation>
    </message>
    <message>
        <source>No wall of {part} could be measured: there is nothing to colour.</source>
        <translation>Aucune paroi de {part} n’a pu être mesurée : il n’y a rien à colorer.</translation>
    </message>
    <message>
        <source>No wall of {part} is wide and thin enough for a shell: mesh it as a solid.</source>
        <translation>Aucune paroi de {part} n’est assez large et mince pour une coque : maillez la pièce comme solide.</translation>
    </message>
    <message>
        <source>None of these folders has an info file of a part: 'thinpart classify' writes them.</source>
        <translation>Aucun de ces dossiers n’a de fichier d’information d’une pièce : « thinpart classify » les écrit.</translation>
    </message>
    <message>
        <source>Normal part</source>
        <translation>Pièce normale</translation>
    </message>
    <message>
        <source>Not found any more, though with a limit of its own ({reason}): {faces}: set it anew, or remove it.</source>
        <translation>Introuvable désormais, bien qu’ayant sa propre limite ({reason}) : {faces} : fixez-la de nouveau, ou supprimez-la.</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
    <message>
        <source>Number of edges shorter than 0.3 elements of the automatic mesh</source>
        <translation>Nombre d'arêtes plus courtes que 0,3 élément du maillage automatique</translation>
    </message>
    <message>
        <source>Number of faces</source>
        <translation>Nombre de faces</translation>
    </message>
    <message>
        <source>Number of faces narrower than 0.3 elements of the automatic mesh</source>
        <translation>Nombre de faces plus étroites que 0,3 élément du maillage automatique</translation>
    </message>
    <message>
        <source>Number of wall regions that are bars, shafts, wires or rings</source>
        <translation>Nombre de régions de paroi qui sont des barres, arbres, fils ou anneaux</translation>
    </message>
    <message>
        <source>Number of wall regions that are blocks</source>
        <translation>Nombre de régions de paroi qui sont des blocs</translation>
    </message>
    <message>
        <source>Number of wall regions that are plates, flat, bent or shells</source>
        <translation>Nombre de régions de paroi qui sont des plaques, planes, pliées ou coques</translation>
    </message>
    <message>
        <source>Number of wall regions that are tapers</source>
        <translation>Nombre de régions de paroi qui sont des coins</translation>
    </message>
    <message>
        <source>Number of wall regions that are teeth, of gears or threads</source>
        <translation>Nombre de régions de paroi qui sont des dents, d’engrenages ou de filetages</translation>
    </message>
    <message>
        <source>Number of wall regions that are tubes</source>
        <translation>Nombre de régions de paroi qui sont des tubes</translation>
    </message>
    <message>
        <source>Number of wall regions, connected walls of like thickness</source>
        <translation>Nombre de régions de paroi, parois continues d’épaisseur semblable</translation>
    </message>
    <message>
        <source>Nylon (PA)</source>
        <translation>Nylon (PA)</translation>
    </message>
    <message>
        <source>One form, wherever it lies, in whatever file, format or name.</source>
        <translation>Une même forme, où qu’elle soit, quels que soient le fichier, le format et le nom.</translation>
    </message>
    <message>
        <source>One of the given paths is empty: name a file or a folder.</source>
        <translation>Un des chemins donnés est vide : indiquez un fichier ou un dossier.</translation>
    </message>
    <message>
        <source>Only the other has round faces of radius {radius:.3g} ({count}).</source>
        <translation>Seule l’autre a des faces rondes de rayon {radius:.3g} ({count}).</translation>
    </message>
    <message>
        <source>Only this one has round faces of radius {radius:.3g} ({count}).</source>
        <translation>Seule celle-ci a des faces rondes de rayon {radius:.3g} ({count}).</translation>
    </message>
    <message>
        <source>Only {share:.0f} % of the volume of {part} can be cut off as walls.</source>
        <translation>Seuls {share:.0f} % du volume de {part} peuvent être séparés comme parois.</translation>
    </message>
    <message>
        <source>PLY with thickness and colours (*.ply)</source>
        <translation>PLY avec épaisseur et couleurs (*.ply)</translation>
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
        <source>Parts</source>
        <translation>Pièces</translation>
    </message>
    <message>
        <source>Parts whose faces are the same but for their sizes, with what varies, in {unit}.</source>
        <translation>Pièces dont les faces sont les mêmes à leurs dimensions près, avec ce qui varie, en {unit}.</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Conforme</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>Picture of {part}</source>
        <translation>Image de {part}</translation>
    </message>
    <message>
        <source>Pieces that do not meet the rest were left out, {share:.2g} % of the volume: they belong to what is left solid.</source>
        <translation>Des morceaux qui ne touchent pas le reste ont été omis, {share:.2g} % du volume : ils font partie de ce qui reste en volume.</translation>
    </message>
    <message>
        <source>Plastic</source>
        <translation>Plastique</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Plaque</translation>
    </message>
    <message>
        <source>Point at a part to see it, click to find it in the table. With the keyboard: arrow keys go from part to part, Enter finds it in the table.</source>
        <translation>Pointez une pièce pour la voir, cliquez pour la trouver dans le tableau. Au clavier : les flèches vont d’une pièce à l’autre, Entrée la trouve dans le tableau.</translation>
    </message>
    <message>
        <source>Polycarbonate (PC)</source>
        <translation>Polycarbonate (PC)</translation>
    </message>
    <message>
        <source>Polyester (PBT, PET)</source>
        <translation>Polyester (PBT, PET)</translation>
    </message>
    <message>
        <source>Polyethylene (PE)</source>
        <translation>Polyéthylène (PE)</translation>
    </message>
    <message>
        <source>Polyphenylene sulphide (PPS)</source>
        <translation>Polysulfure de phénylène (PPS)</translation>
    </message>
    <message>
        <source>Polypropylene (PP)</source>
        <translation>Polypropylène (PP)</translation>
    </message>
    <message>
        <source>Polystyrene (PS)</source>
        <translation>Polystyrène (PS)</translation>
    </message>
    <message>
        <source>Polyurethane (PU)</source>
        <translation>Polyuréthane (PU)</translation>
    </message>
    <message>
        <source>Previous parts</source>
        <translation>Pièces précédentes</translation>
    </message>
    <message>
        <source>Probability: {probability}, next “{other}” with {others}.</source>
        <translation>Probabilité : {probability}, puis « {other} » avec {others}.</translation>
    </message>
    <message>
        <source>Process</source>
        <translation>Procédé</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Grandeur</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Raison</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>Risk</source>
        <translation>Risque</translation>
    </message>
    <message>
        <source>Risk of the automatic mesh</source>
        <translation>Risque du maillage automatique</translation>
    </message>
    <message>
        <source>Risk of the automatic mesh: unknown, an earlier version measured the part. Measure it again (classify --force).</source>
        <translation>Risque du maillage automatique : inconnu, une version antérieure a mesuré la pièce. Mesurez-la de nouveau (classify --force).</translation>
    </message>
    <message>
        <source>Risk of the automatic mesh: unknown, not all that it depends on could be measured.</source>
        <translation>Risque du maillage automatique : inconnu, tout ce dont il dépend n'a pas pu être mesuré.</translation>
    </message>
    <message>
        <source>Risk of the automatic mesh: unknown, triangles have no edges and faces.</source>
        <translation>Risque du maillage automatique : inconnu, des triangles n'ont ni arêtes ni faces.</translation>
    </message>
    <message>
        <source>Risk of the automatic mesh: {risk}.</source>
        <translation>Risque du maillage automatique : {risk}.</translation>
    </message>
    <message>
        <source>Risk of the automatic mesh: {risk}: {reasons}.</source>
        <translation>Risque du maillage automatique : {risk} : {reasons}.</translation>
    </message>
    <message>
        <source>SLA printing</source>
        <translation>Impression SLA</translation>
    </message>
    <message>
        <source>SLS printing</source>
        <translation>Impression SLS</translation>
    </message>
    <message>
        <source>Sand casting</source>
        <translation>Moulage en sable</translation>
    </message>
    <message>
        <source>Scaled</source>
        <translation>À une autre échelle</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Chercher</translation>
    </message>
    <message>
        <source>See</source>
        <translation>Voir</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <source>Settings that worked for {part} ({alike:.0f} % alike) in {file}.</source>
        <translation>Réglages qui ont fait leurs preuves pour {part} ({alike:.0f} % de ressemblance) dans {file}.</translation>
    </message>
    <message>
        <source>Share of its box, V/VBB</source>
        <translation>Part de sa boîte, V/VBB</translation>
    </message>
    <message>
        <source>Share of the area over curved walls that elements of the automatic mesh change by a twentieth</source>
        <translation>Part de l'aire sur des parois courbes dont les éléments du maillage automatique changent l'épaisseur d'un vingtième</translation>
    </message>
    <message>
        <source>Share of the area over parallel walls from a to b of the middle side</source>
        <translation>Part de la surface sur des parois parallèles de a à b du côté médian</translation>
    </message>
    <message>
        <source>Share of the area over plates and tubes: walls that are wider than thick</source>
        <translation>Part de la surface sur des plaques et des tubes : des parois plus larges qu’épaisses</translation>
    </message>
    <message>
        <source>Share of the area over walls, parallel or under 60 degrees, from a to b of the middle side</source>
        <translation>Part de la surface sur des parois, parallèles ou à moins de 60 degrés, de a à b du côté médian</translation>
    </message>
    <message>
        <source>Share of the area whose local thickness is from a to b of the middle side</source>
        <translation>Part de la surface dont l’épaisseur locale vaut de a à b du côté médian</translation>
    </message>
    <message>
        <source>Share of the area whose rays met nothing at all</source>
        <translation>Part de la surface dont le rayon n’a rien rencontré</translation>
    </message>
    <message>
        <source>Share of the area with a radius below 0.25 elements of the automatic mesh</source>
        <translation>Part de l'aire de rayon inférieur à 0,25 élément du maillage automatique</translation>
    </message>
    <message>
        <source>Share of the area with no wall opposite</source>
        <translation>Part de la surface sans paroi opposée</translation>
    </message>
    <message>
        <source>Share of the area with non-parallel walls</source>
        <translation>Part de la surface à parois non parallèles</translation>
    </message>
    <message>
        <source>Share of the area with parallel walls</source>
        <translation>Part de la surface à parois parallèles</translation>
    </message>
    <message>
        <source>Share of the area with walls that are a to b diagonals thick</source>
        <translation>Part de la surface à parois d’une épaisseur de a à b diagonales</translation>
    </message>
    <message>
        <source>Share of the bounding box that the part fills</source>
        <translation>Part de la boîte englobante que la pièce remplit</translation>
    </message>
    <message>
        <source>Share of the surface</source>
        <translation>Part de la surface</translation>
    </message>
    <message>
        <source>Share of the surface over parallel walls thinner than {high:g} of the diagonal</source>
        <translation>Part de la surface sur des parois parallèles plus minces que {high:g} de la diagonale</translation>
    </message>
    <message>
        <source>Share of the surface over parallel walls thinner than {high:g} of the middle side</source>
        <translation>Part de la surface sur des parois parallèles plus minces que {high:g} du côté médian</translation>
    </message>
    <message>
        <source>Share of the surface over parallel walls {low:g} to {high:g} of the diagonal thick</source>
        <translation>Part de la surface sur des parois parallèles épaisses de {low:g} à {high:g} de la diagonale</translation>
    </message>
    <message>
        <source>Share of the surface over parallel walls {low:g} to {high:g} of the middle side thick</source>
        <translation>Part de la surface sur des parois parallèles épaisses de {low:g} à {high:g} du côté médian</translation>
    </message>
    <message>
        <source>Share of the surface over walls of each thickness ({unit}). {unmeasured} of the surface has no wall opposite; {tapered} lies over tapered walls, which are not in the chart.</source>
        <translation>Part de la surface sur des parois de chaque épaisseur ({unit}). {unmeasured} de la surface n’a pas de paroi en face ; {tapered} est sur des parois en dépouille, qui ne sont pas dans l’histogramme.</translation>
    </message>
    <message>
        <source>Share of the surface over walls, parallel or tapered, thinner than {high:g} of the middle side</source>
        <translation>Part de la surface sur des parois, parallèles ou en dépouille, plus minces que {high:g} du côté médian</translation>
    </message>
    <message>
        <source>Share of the surface over walls, parallel or tapered, {low:g} to {high:g} of the middle side thick</source>
        <translation>Part de la surface sur des parois, parallèles ou en dépouille, épaisses de {low:g} à {high:g} du côté médian</translation>
    </message>
    <message>
        <source>Share of the surface whose local thickness is under {high:g} of the middle side</source>
        <translation>Part de la surface dont l’épaisseur locale est inférieure à {high:g} du côté médian</translation>
    </message>
    <message>
        <source>Share of the surface whose local thickness is {low:g} to {high:g} of the middle side</source>
        <translation>Part de la surface dont l’épaisseur locale vaut de {low:g} à {high:g} du côté médian</translation>
    </message>
    <message>
        <source>Share of the volume</source>
        <translation>Part du volume</translation>
    </message>
    <message>
        <source>Sheet metal</source>
        <translation>Tôle</translation>
    </message>
    <message>
        <source>Shell and solid of {part} would count for {share:.0f} % of its volume.</source>
        <translation>La coque et le solide de {part} compteraient pour {share:.0f} % de son volume.</translation>
    </message>
    <message>
        <source>Shortest side of the bounding box</source>
        <translation>Plus petit côté de la boîte englobante</translation>
    </message>
    <message>
        <source>Show all {count}</source>
        <translation>Tout afficher ({count})</translation>
    </message>
    <message>
        <source>Small castings of aluminium; large ones need about twice as much. The greatest section is that of DeGarmo, Black and Kohser (2003).</source>
        <translation>Petites pièces moulées en aluminium ; les grandes demandent environ le double. La plus grande section est celle de DeGarmo, Black et Kohser (2003).</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>Logiciel</translation>
    </message>
    <message>
        <source>Solid but for {features}: mesh it with solids, and refine there or suppress that.</source>
        <translation>Massive sauf {features} : mailler en éléments volumiques, et y raffiner ou supprimer cela.</translation>
    </message>
    <message>
        <source>Solid but for {features}: mesh it with solids, and refine there.</source>
        <translation>Massive sauf {features} : mailler en éléments volumiques, et y raffiner.</translation>
    </message>
    <message>
        <source>Solid core, {share} of the surface is thin: {features}. Refine the mesh there, or suppress them.</source>
        <translation>Noyau massif, {share} de la surface est mince : {features}. Y raffiner le maillage, ou les supprimer.</translation>
    </message>
    <message>
        <source>Solid core, {share} of the surface is thin: {features}. Refine the mesh there.</source>
        <translation>Noyau massif, {share} de la surface est mince : {features}. Y raffiner le maillage.</translation>
    </message>
    <message>
        <source>Solid: {walls}: mesh it with solids.</source>
        <translation>Massive : {walls} : mailler en éléments volumiques.</translation>
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
        <source>Stopped on request before the end.</source>
        <translation>Arrêté à la demande avant la fin.</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>Surface mesh</source>
        <translation>Maillage de la surface</translation>
    </message>
    <message>
        <source>Surfaces touch or cross at ({place}): what lies between them is not counted as a wall.</source>
        <translation>Des surfaces se touchent ou se croisent en ({place}) : ce qui se trouve entre elles ne compte pas comme paroi.</translation>
    </message>
    <message>
        <source>Tables:</source>
        <translation>Tableaux :</translation>
    </message>
    <message>
        <source>Takes shapes from</source>
        <translation>Reprend des formes de</translation>
    </message>
    <message>
        <source>Temporary files cannot be written ({problem}): free some disk space, or name another folder in TMPDIR.</source>
        <translation>Impossible d’écrire des fichiers temporaires ({problem}) : libérez de l’espace disque ou nommez un autre dossier dans TMPDIR.</translation>
    </message>
    <message>
        <source>Temporary files cannot be written ({problem}): free some disk space. Nothing was meshed.</source>
        <translation>Impossible d'écrire les fichiers temporaires ({problem}) : libérez de l'espace disque. Rien n'a été maillé.</translation>
    </message>
    <message>
        <source>The Python module {module} is missing: install it to have documents classified automatically (Debian: python3-{module}).</source>
        <translation>Le module Python {module} manque : installez-le pour que les documents soient classifiés automatiquement (Debian : python3-{module}).</translation>
    </message>
    <message>
        <source>The condition {condition!r} is not understood: write a quantity, one of {comparisons} and a number, as in 'D2/D3 &gt; 6'.</source>
        <translation>La condition {condition!r} n’est pas comprise : écrivez une grandeur, un des signes {comparisons} et un nombre, comme « D2/D3 &gt; 6 ».</translation>
    </message>
    <message>
        <source>The current folder no longer exists: change to another one.</source>
        <translation>Le dossier courant n'existe plus : passez à un autre.</translation>
    </message>
    <message>
        <source>The document '{document}' is empty: make or import a solid first.</source>
        <translation>Le document « {document} » est vide : créez ou importez d’abord un solide.</translation>
    </message>
    <message>
        <source>The document has no such part any more: classify it again.</source>
        <translation>Le document n’a plus cette pièce : classifiez-le à nouveau.</translation>
    </message>
    <message>
        <source>The document links to {links}, which is a pipe, a device or a socket: it was not opened, and what is linked to is missing.</source>
        <translation>Le document renvoie à {links}, qui est un tube, un périphérique ou un socket : il n'a pas été ouvert, et ce à quoi il renvoie manque.</translation>
    </message>
    <message>
        <source>The document names Python modules that are not FreeCAD's ({names}): they were not loaded, and objects that need them may lack their shape.</source>
        <translation>Le document nomme des modules Python qui ne sont pas de FreeCAD ({names}) : ils n'ont pas été chargés, et la forme des objets qui en ont besoin peut manquer.</translation>
    </message>
    <message>
        <source>The document's folder has not answered for {seconds:g} s: connect it, or choose a folder for info files in the preferences.</source>
        <translation>Le dossier du document ne répond pas depuis {seconds:g} s : connectez-le ou choisissez un dossier pour les fichiers d’information dans les préférences.</translation>
    </message>
    <message>
        <source>The documents are the same, byte by byte.</source>
        <translation>Les documents sont identiques, octet par octet.</translation>
    </message>
    <message>
        <source>The element size of a shell is more than 0 mm, not {value:g}.</source>
        <translation>La taille d’élément d’une coque est supérieure à 0 mm, et non {value:g}.</translation>
    </message>
    <message>
        <source>The error aimed at is from {least:g} to {most:g} %, not {value:g} %.</source>
        <translation>L'erreur visée va de {least:g} à {most:g} %, et non {value:g} %.</translation>
    </message>
    <message>
        <source>The error of its mesh is not known ({reason}).</source>
        <translation>L’erreur de son maillage n’est pas connue ({reason}).</translation>
    </message>
    <message>
        <source>The error of its mesh is not known: the frequencies of the reference still change by {change}.</source>
        <translation>L’erreur de son maillage n’est pas connue : les fréquences de la référence changent encore de {change}.</translation>
    </message>
    <message>
        <source>The file</source>
        <translation>Le fichier</translation>
    </message>
    <message>
        <source>The file of labels {file} cannot be read ({problem}).</source>
        <translation>Le fichier d’étiquettes {file} ne peut pas être lu ({problem}).</translation>
    </message>
    <message>
        <source>The file {file}</source>
        <translation>Le fichier {file}</translation>
    </message>
    <message>
        <source>The file {file} cannot be read ({problem}).</source>
        <translation>Le fichier {file} ne peut pas être lu ({problem}).</translation>
    </message>
    <message>
        <source>The file {file} no longer exists.</source>
        <translation>Le fichier {file} n’existe plus.</translation>
    </message>
    <message>
        <source>The first part of a group is the one to keep: geometry before triangles, the one used most, with notes, in a document that FreeCAD can edit, with a name that somebody chose, the latest. The others are compared with it, by what info files keep of their form. Nothing is deleted.</source>
        <translation>La première pièce d’un groupe est celle à conserver : la géométrie avant les triangles, la plus utilisée, avec des notes, dans un document que FreeCAD peut modifier, avec un nom que quelqu’un a choisi, la plus récente. Les autres lui sont comparées, d’après ce que les fichiers d’information gardent de leur forme. Rien n’est supprimé.</translation>
    </message>
    <message>
        <source>The folder for info files {folder} cannot be reached ({problem}): connect it, or choose another one in the preferences.</source>
        <translation>Le dossier {folder} des fichiers d’information est inaccessible ({problem}) : connectez-le ou choisissez-en un autre dans les préférences.</translation>
    </message>
    <message>
        <source>The folder for info files {folder} has not answered for {seconds:g} s: connect it, or choose another one in the preferences.</source>
        <translation>Le dossier {folder} des fichiers d’information ne répond pas depuis {seconds:g} s : connectez-le ou choisissez-en un autre dans les préférences.</translation>
    </message>
    <message>
        <source>The folder {folder} cannot be listed ({problem}): its parts are shown as they were last read.</source>
        <translation>Le contenu du dossier {folder} ne peut pas être lu ({problem}) : ses pièces sont montrées telles qu’à la dernière lecture.</translation>
    </message>
    <message>
        <source>The folder {folder} cannot be listed ({problem}): make it readable, or move it away.</source>
        <translation>Le dossier {folder} ne peut pas être parcouru ({problem}) : rendez-le lisible ou déplacez-le.</translation>
    </message>
    <message>
        <source>The folder {folder} cannot be listed ({problem}): the files in it were not changed.</source>
        <translation>Le contenu du dossier {folder} ne peut pas être lu ({problem}) : ses fichiers n’ont pas été modifiés.</translation>
    </message>
    <message>
        <source>The folder {folder} cannot be reached ({problem}).</source>
        <translation>Le dossier {folder} est inaccessible ({problem}).</translation>
    </message>
    <message>
        <source>The folder {folder} could not be searched to its end ({problem}): classify it again when it can be reached.</source>
        <translation>Le dossier {folder} n’a pas pu être parcouru jusqu’au bout ({problem}) : classifiez-le à nouveau quand il sera accessible.</translation>
    </message>
    <message>
        <source>The folder {folder} no longer exists: restore it, or remove it from the list.</source>
        <translation>Le dossier {folder} n’existe plus : rétablissez-le ou retirez-le de la liste.</translation>
    </message>
    <message>
        <source>The greatest element size is more than 0 mm, not {value:g}.</source>
        <translation>La plus grande taille d'élément est supérieure à 0 mm, pas {value:g}.</translation>
    </message>
    <message>
        <source>The growth from element to element is from {least:g} to {most:g}, not {value:g}.</source>
        <translation>La croissance d'un élément à l'autre va de {least:g} à {most:g}, pas {value:g}.</translation>
    </message>
    <message>
        <source>The info file {info_file} belongs to {other} and was not changed: choose another folder for the info file of {own}.</source>
        <translation>Le fichier d’information {info_file} appartient à {other} et est resté inchangé : choisissez un autre dossier pour le fichier d’information de {own}.</translation>
    </message>
    <message>
        <source>The info file {info_file} cannot be read ({problem}).</source>
        <translation>Le fichier d’information {info_file} ne peut pas être lu ({problem}).</translation>
    </message>
    <message>
        <source>The info file {info_file} could not be written ({problem}): make room or choose another place for it.</source>
        <translation>Le fichier d’information {info_file} n’a pas pu être écrit ({problem}) : faites de la place ou choisissez un autre emplacement.</translation>
    </message>
    <message>
        <source>The info file {info_file} could not be written: another program keeps the folder {folder} locked; end that program, or choose another place for info files.</source>
        <translation>Le fichier d’information {info_file} n’a pas pu être écrit : un autre programme garde le dossier {folder} verrouillé ; arrêtez ce programme, ou choisissez un autre endroit pour les fichiers d’information.</translation>
    </message>
    <message>
        <source>The info file {info_file} is damaged ({problem}): move it away and classify its document again.</source>
        <translation>Le fichier d’information {info_file} est endommagé ({problem}) : déplacez-le et classez de nouveau son document.</translation>
    </message>
    <message>
        <source>The info file {info_file} needs more memory than the limit allows.</source>
        <translation>Le fichier d’information {info_file} demande plus de mémoire que permis.</translation>
    </message>
    <message>
        <source>The info file {info_file} was not written: {problem}.</source>
        <translation>Le fichier d’information {info_file} n’a pas été écrit : {problem}.</translation>
    </message>
    <message>
        <source>The labels could not be written to {file} ({problem}): choose another place for them.</source>
        <translation>Les étiquettes n’ont pas pu être écrites dans {file} ({problem}) : choisissez un autre emplacement.</translation>
    </message>
    <message>
        <source>The library {folder} cannot be read ({problem}).</source>
        <translation>La bibliothèque {folder} ne peut pas être lue ({problem}).</translation>
    </message>
    <message>
        <source>The limits of walls {file} are not well formed: {problem}.</source>
        <translation>Les limites de paroi {file} sont mal formées : {problem}.</translation>
    </message>
    <message>
        <source>The limits of walls {file} cannot be read ({problem}).</source>
        <translation>Les limites de paroi {file} sont illisibles ({problem}).</translation>
    </message>
    <message>
        <source>The link '{object}' leads to '{target}' in {file}, which cannot be found: put the file back or set the linked object again.</source>
        <translation>Le lien « {object} » mène à « {target} » dans {file}, introuvable : remettez le fichier en place ou définissez à nouveau l’objet lié.</translation>
    </message>
    <message>
        <source>The link '{object}' leads to nothing: set its linked object again or delete it.</source>
        <translation>Le lien « {object} » ne mène à rien : définissez à nouveau son objet lié ou supprimez-le.</translation>
    </message>
    <message>
        <source>The list {list} cannot be read ({problem}): give a file to --only that names the parts.</source>
        <translation>La liste {list} ne peut pas être lue ({problem}) : donnez à --only un fichier qui nomme les pièces.</translation>
    </message>
    <message>
        <source>The list {list} names {file!r}, which is not an absolute path: write absolute paths, each ended by a NUL byte.</source>
        <translation>La liste {list} nomme {file!r}, qui n’est pas un chemin absolu : écrivez des chemins absolus, chacun terminé par un octet NUL.</translation>
    </message>
    <message>
        <source>The list {list} names {file}, which does not lie below {top}: name a PATH that holds it, or leave out --info-dir.</source>
        <translation>La liste {list} nomme {file}, qui n’est pas sous {top} : nommez un PATH qui le contient, ou omettez --info-dir.</translation>
    </message>
    <message>
        <source>The mesh cannot be read ({problem}): free some disk space and try again.</source>
        <translation>Impossible de lire le maillage ({problem}) : libérez de l'espace disque et réessayez.</translation>
    </message>
    <message>
        <source>The mesh settings</source>
        <translation>Les paramètres de maillage</translation>
    </message>
    <message>
        <source>The mesh {file} cannot be read ({problem}).</source>
        <translation>Le maillage {file} ne peut pas être lu ({problem}).</translation>
    </message>
    <message>
        <source>The mid-faces of the walls could not be cut to each other ({problem}): mesh it as a solid.</source>
        <translation>Les faces moyennes des parois n’ont pas pu être découpées entre elles ({problem}) : maillez la pièce comme solide.</translation>
    </message>
    <message>
        <source>The mid-faces of the walls could not be cut to each other: mesh it as a solid.</source>
        <translation>Les faces moyennes des parois n’ont pas pu être coupées entre elles : maillez la pièce en volume.</translation>
    </message>
    <message>
        <source>The mid-surface cannot be read ({problem}): free some disk space and try again.</source>
        <translation>La surface moyenne ne peut pas être lue ({problem}) : libérez de l’espace disque et réessayez.</translation>
    </message>
    <message>
        <source>The mid-surface of {part} could not be meshed ({problem}).</source>
        <translation>La surface moyenne de {part} n'a pas pu être maillée ({problem}).</translation>
    </message>
    <message>
        <source>The mid-surface of {part} could not be meshed ({problem}): name another element size.</source>
        <translation>La surface moyenne de {part} n’a pas pu être maillée ({problem}) : indiquez une autre taille d’élément.</translation>
    </message>
    <message>
        <source>The mid-surface of {part} falls into {count} pieces that do not meet: mesh it as a solid.</source>
        <translation>La surface moyenne de {part} se compose de {count} morceaux qui ne se rejoignent pas : maillez la pièce comme solide.</translation>
    </message>
    <message>
        <source>The mirror image, by the points that info files keep, by volume and by area.</source>
        <translation>L’image miroir, d’après les points que gardent les fichiers d’information, le volume et l’aire.</translation>
    </message>
    <message>
        <source>The mirror image: its surfaces are at most {apart:.2g} apart.</source>
        <translation>L’image miroir : les surfaces s’écartent d’au plus {apart:.2g}.</translation>
    </message>
    <message>
        <source>The mirror image: triangles lie at most {apart:.2g} from the other surface.</source>
        <translation>L’image miroir : les triangles s’écartent d’au plus {apart:.2g} de l’autre surface.</translation>
    </message>
    <message>
        <source>The name is too long for an info file, which adds {ending} to it: it has {bytes} bytes, at most {most} are possible; rename it, or use --no-info.</source>
        <translation>Le nom est trop long pour un fichier d’information, qui y ajoute {ending} : il a {bytes} octets, {most} au plus sont possibles ; renommez le fichier ou utilisez --no-info.</translation>
    </message>
    <message>
        <source>The order of elements is 1 or 2, not {value}.</source>
        <translation>L'ordre des éléments est 1 ou 2, pas {value}.</translation>
    </message>
    <message>
        <source>The outline in an info file is damaged: classify its document again.</source>
        <translation>Le contour dans un fichier d’information est endommagé : classez de nouveau son document.</translation>
    </message>
    <message>
        <source>The overview of the report could not be written into {folder} ({problem}): make room for it, and start again.</source>
        <translation>La vue d’ensemble du rapport n’a pas pu être écrite dans {folder} ({problem}) : faites de la place et démarrez à nouveau.</translation>
    </message>
    <message>
        <source>The page about the library could not be written into {folder} ({problem}): make room for it, and start again.</source>
        <translation>La page sur la bibliothèque n’a pas pu être écrite dans {folder} ({problem}) : libérez de la place, et recommencez.</translation>
    </message>
    <message>
        <source>The page {page} could not be written ({problem}): make room, or give another folder for the report.</source>
        <translation>La page {page} n’a pas pu être écrite ({problem}) : faites de la place ou indiquez un autre dossier pour le rapport.</translation>
    </message>
    <message>
        <source>The part as a whole is thin: consider a shell mesh or a mid-surface.</source>
        <translation>La pièce entière est mince : envisagez un maillage de coque ou une surface moyenne.</translation>
    </message>
    <message>
        <source>The part is slender: its lengths are accurate to {error:.2g} only, a finer mesh would be too large.</source>
        <translation>La pièce est élancée : ses longueurs ne sont connues qu'à {error:.2g} près, un maillage plus fin serait trop grand.</translation>
    </message>
    <message>
        <source>The part is too slender or too fine to be measured: it needs more than {triangles:,} triangles, with fewer its lengths are accurate to {mm:.2g} only.</source>
        <translation>La pièce est trop élancée ou trop fine pour être mesurée : il faut plus de {triangles:,} triangles, avec moins ses longueurs ne sont connues qu'à {mm:.2g} près.</translation>
    </message>
    <message>
        <source>The part is {mm} across: check that the file's unit is millimetres.</source>
        <translation>La pièce mesure {mm} en diagonale : vérifiez que l’unité du fichier est le millimètre.</translation>
    </message>
    <message>
        <source>The parts lie on several drives: name those of one drive at a time.</source>
        <translation>Les pièces se trouvent sur plusieurs lecteurs : indiquez celles d’un seul lecteur à la fois.</translation>
    </message>
    <message>
        <source>The profile {file} could not be written ({problem}): choose another place for it.</source>
        <translation>Le profil {file} n’a pas pu être écrit ({problem}) : choisissez un autre emplacement.</translation>
    </message>
    <message>
        <source>The profile {profile} cannot be read ({problem}).</source>
        <translation>Le profil {profile} ne peut pas être lu ({problem}).</translation>
    </message>
    <message>
        <source>The profile {profile} has no category {categories}: labels by a program are of these.</source>
        <translation>Le profil {profile} n’a pas de catégorie {categories} : les étiquettes par un programme en sont.</translation>
    </message>
    <message>
        <source>The same form in another size.</source>
        <translation>La même forme dans une autre taille.</translation>
    </message>
    <message>
        <source>The same form, by the points that info files keep, by volume and by area.</source>
        <translation>La même forme, d’après les points que gardent les fichiers d’information, le volume et l’aire.</translation>
    </message>
    <message>
        <source>The same form, scaled: triangles lie at most {apart:.2g} from the other surface.</source>
        <translation>La même forme, à une autre échelle : les triangles s’écartent d’au plus {apart:.2g} de l’autre surface.</translation>
    </message>
    <message>
        <source>The same form, {scale:.6g} times as large, by the points that info files keep, by volume and by area.</source>
        <translation>La même forme, {scale:.6g} fois plus grande, d’après les points que gardent les fichiers d’information, le volume et l’aire.</translation>
    </message>
    <message>
        <source>The same form, {scale:.6g} times as large: in the size of the other, its surfaces are at most {apart:.2g} apart.</source>
        <translation>La même forme, {scale:.6g} fois aussi grande : à la taille de l’autre, les surfaces s’écartent d’au plus {apart:.2g}.</translation>
    </message>
    <message>
        <source>The same form: its surfaces are at most {apart:.2g} apart.</source>
        <translation>La même forme : les surfaces s’écartent d’au plus {apart:.2g}.</translation>
    </message>
    <message>
        <source>The same form: triangles lie at most {apart:.2g} from the other surface.</source>
        <translation>La même forme : les triangles s’écartent d’au plus {apart:.2g} de l’autre surface.</translation>
    </message>
    <message>
        <source>The script opens {copy}, a copy of the part beside it.</source>
        <translation>Le script ouvre {copy}, une copie de la pièce à côté de lui.</translation>
    </message>
    <message>
        <source>The search has {count} conditions, words and names, more than {most}: leave some out.</source>
        <translation>La recherche contient {count} conditions, mots et noms, plus que {most} : retirez-en.</translation>
    </message>
    <message>
        <source>The search index {file} cannot be saved ({problem}): it was built in memory, and the next search has to build it again.</source>
        <translation>L’index de recherche {file} ne peut pas être conservé ({problem}) : il a été construit en mémoire, et la prochaine recherche devra le reconstruire.</translation>
    </message>
    <message>
        <source>The settings were kept with {part}.</source>
        <translation>Les réglages ont été enregistrés avec {part}.</translation>
    </message>
    <message>
        <source>The shell and what is solid, tied to it, were written to {file}: {elements} elements, {nodes} nodes.</source>
        <translation>La coque et le solide qui lui est lié ont été écrits dans {file} : {elements} éléments, {nodes} nœuds.</translation>
    </message>
    <message>
        <source>The shell has {share:.0f} % of the part's volume: the rest is not in the file.</source>
        <translation>La coque a {share:.0f} % du volume de la pièce : le reste n’est pas dans le fichier.</translation>
    </message>
    <message>
        <source>The shell is in {count} pieces: what is left solid lies between them.</source>
        <translation>La coque est en {count} morceaux : ce qui reste solide se trouve entre eux.</translation>
    </message>
    <message>
        <source>The shell of {part} reaches only {share:.0f} % of the cuts between its walls and what is solid.</source>
        <translation>La coque de {part} n’atteint que {share:.0f} % des coupes entre ses parois et le solide.</translation>
    </message>
    <message>
        <source>The shell was written to {file}: {elements} elements, {nodes} nodes.</source>
        <translation>La coque a été écrite dans {file} : {elements} éléments, {nodes} nœuds.</translation>
    </message>
    <message>
        <source>The size of elements and the error have to be more than 0: state other ones.</source>
        <translation>La taille des éléments et l’erreur doivent être supérieures à 0 : indiquez-en d’autres.</translation>
    </message>
    <message>
        <source>The sizes were written to {file}: open it in Gmsh.</source>
        <translation>Les tailles sont écrites dans {file} : ouvrez ce fichier dans Gmsh.</translation>
    </message>
    <message>
        <source>The surface intersects itself, for example below ({place}): repair it, its thickness and volume are not certain.</source>
        <translation>La surface se recoupe, par exemple sous ({place}) : réparez-la, son épaisseur et son volume ne sont pas certains.</translation>
    </message>
    <message>
        <source>The surface is open ({edges} free edges), so it has no certain volume.</source>
        <translation>La surface est ouverte ({edges} arêtes libres), son volume n’est donc pas certain.</translation>
    </message>
    <message>
        <source>The surface was inside out and has been reversed.</source>
        <translation>La surface était à l’envers et a été retournée.</translation>
    </message>
    <message>
        <source>The table and the search need JavaScript.</source>
        <translation>Le tableau et la recherche nécessitent JavaScript.</translation>
    </message>
    <message>
        <source>The thickness map {file} cannot be read: measure the part again.</source>
        <translation>La carte des épaisseurs {file} ne peut pas être lue : mesurez la pièce à nouveau.</translation>
    </message>
    <message>
        <source>The thickness map {file} is of a newer ThinPart: update ThinPart or measure the part again.</source>
        <translation>La carte des épaisseurs {file} vient d’un ThinPart plus récent : mettez ThinPart à jour ou mesurez la pièce à nouveau.</translation>
    </message>
    <message>
        <source>The thinnest first; thin is what lies over less than {limit}, {part} of the width, as the verdict has it, beside edges of up to 60 degrees too, which are no walls</source>
        <translation>Les plus minces d’abord ; est mince ce qui recouvre moins de {limit}, {part} de la largeur, comme le verdict l’entend, aussi près des arêtes jusqu’à 60 degrés, qui ne sont pas des parois</translation>
    </message>
    <message>
        <source>The thinnest wall is {wall} ± {error:.2g}: a finer mesh would be too large.</source>
        <translation>La paroi la plus mince mesure {wall} ± {error:.2g} : un maillage plus fin serait trop grand.</translation>
    </message>
    <message>
        <source>The thinnest wall, {wall}, is below what the mesh resolves ({error:.2g}).</source>
        <translation>La paroi la plus mince, {wall}, est en dessous de ce que le maillage résout ({error:.2g}).</translation>
    </message>
    <message>
        <source>The triangles are not consistently oriented, so it has no certain volume.</source>
        <translation>Les triangles ne sont pas orientés de façon cohérente, le volume n’est donc pas certain.</translation>
    </message>
    <message>
        <source>The walls of {part} do not meet: {inside} of the {free} of free edges of its mid-surface lie inside the material. Mesh it as a solid.</source>
        <translation>Les parois de {part} ne se rejoignent pas : {inside} des {free} d’arêtes libres de sa surface moyenne sont dans la matière. Maillez la pièce comme solide.</translation>
    </message>
    <message>
        <source>The worker process failed ({problem}).</source>
        <translation>Le processus de travail a échoué ({problem}).</translation>
    </message>
    <message>
        <source>The worker processes end as soon as they start: try a larger --memory, or fewer --jobs.</source>
        <translation>Les processus de travail se terminent dès leur démarrage : essayez avec plus de mémoire (--memory) ou moins de fichiers simultanés (--jobs).</translation>
    </message>
    <message>
        <source>The {what} cannot be {value:g}: use a value from {least:g} to {most:g} {unit}.</source>
        <translation>{what} : {value:g} n’est pas permis, seulement de {least:g} à {most:g} {unit}.</translation>
    </message>
    <message>
        <source>There are no info files (*{ending}) in {paths}: classify the parts first.</source>
        <translation>Il n’y a pas de fichiers d’information (*{ending}) dans {paths} : classifiez d’abord les pièces.</translation>
    </message>
    <message>
        <source>There are no labels in {folder}: label parts in the window, or by 'thinpart note --label', or name CSV files of labels.</source>
        <translation>Il n’y a pas d’étiquettes dans {folder} : étiquetez des pièces dans la fenêtre ou par 'thinpart note --label', ou nommez des fichiers CSV d’étiquettes.</translation>
    </message>
    <message>
        <source>There are no limits of walls for {process!r}: there are {known}.</source>
        <translation>Il n’y a pas de limites de paroi pour {process!r} : il y a {known}.</translation>
    </message>
    <message>
        <source>There are no parts in {paths}: name a CAD file or a folder that holds some.</source>
        <translation>Il n’y a pas de pièces dans {paths} : nommez un fichier CAO ou un dossier qui en contient.</translation>
    </message>
    <message>
        <source>There are too few labels: {counts}. At least {needed} parts of every category are needed: even if the verdicts on so few were all right, only {percent:.0f} % right could be claimed with confidence.</source>
        <translation>Il y a trop peu d’étiquettes : {counts}. Il faut au moins {needed} pièces de chaque catégorie : même si tous les verdicts sur si peu de pièces étaient justes, on ne pourrait affirmer avec confiance que {percent:.0f} % de justes.</translation>
    </message>
    <message>
        <source>There is no accuracy {accuracy!r}: use {known}.</source>
        <translation>La précision {accuracy!r} n’existe pas : utilisez {known}.</translation>
    </message>
    <message>
        <source>There is no box {box!r}: use minimal or principal.</source>
        <translation>La boîte {box!r} n’existe pas : utilisez minimal ou principal.</translation>
    </message>
    <message>
        <source>There is no closed solid in '{object}': select a solid, a body, or a face of one.</source>
        <translation>Il n’y a pas de solide fermé dans « {object} » : sélectionnez un solide, un corps ou une de ses faces.</translation>
    </message>
    <message>
        <source>There is no closed solid in the document '{document}': make or import a solid first.</source>
        <translation>Il n’y a pas de solide fermé dans le document « {document} » : créez ou importez d’abord un solide.</translation>
    </message>
    <message>
        <source>There is no file of labels {file}.</source>
        <translation>Le fichier d’étiquettes {file} n’existe pas.</translation>
    </message>
    <message>
        <source>There is no file {file} with limits of walls: copy {shipped} and edit it.</source>
        <translation>Il n’y a pas de fichier {file} avec des limites de paroi : copiez {shipped} et modifiez la copie.</translation>
    </message>
    <message>
        <source>There is no file {file}.</source>
        <translation>Le fichier {file} n’existe pas.</translation>
    </message>
    <message>
        <source>There is no file {file}: --mesh takes a JSON object or a file.</source>
        <translation>Le fichier {file} n’existe pas : les paramètres de maillage sont un objet JSON ou un fichier.</translation>
    </message>
    <message>
        <source>There is no folder {folder}: name the one with the info files.</source>
        <translation>Le dossier {folder} n’existe pas : nommez celui des fichiers d’information.</translation>
    </message>
    <message>
        <source>There is no info file {info_file}: classify {file} first, or name the folder of its info file with --info-dir.</source>
        <translation>Le fichier d’information {info_file} n’existe pas : classifiez d’abord {file}, ou nommez le dossier du fichier avec --info-dir.</translation>
    </message>
    <message>
        <source>There is no measure {measure!r}: use rays or pairs.</source>
        <translation>La méthode de mesure {measure!r} n’existe pas : utilisez rays ou pairs.</translation>
    </message>
    <message>
        <source>There is no part that could be written to {file}.</source>
        <translation>Il n’y a aucune pièce à écrire dans {file}.</translation>
    </message>
    <message>
        <source>There is no part {part} in {file}: it has {parts}.</source>
        <translation>Il n’y a pas de pièce {part} dans {file} : il contient {parts}.</translation>
    </message>
    <message>
        <source>There is no permission to read {file}: check its permissions.</source>
        <translation>{file} ne peut pas être lu, faute d’autorisation : vérifiez ses droits d’accès.</translation>
    </message>
    <message>
        <source>There is no permission to search the folder {folder}: check its permissions.</source>
        <translation>Le dossier {folder} ne peut pas être parcouru : vérifiez ses droits d’accès.</translation>
    </message>
    <message>
        <source>There is no profile {profile!r}: give a file or one of {known}.</source>
        <translation>Le profil {profile!r} n’existe pas : donnez un fichier ou un de {known}.</translation>
    </message>
    <message>
        <source>There is no quantity {quantity!r} in the condition {condition!r}: there are {known}.</source>
        <translation>La grandeur {quantity!r} de la condition {condition!r} n’existe pas : il y a {known}.</translation>
    </message>
    <message>
        <source>There is no quantity {quantity!r}: there are {known}.</source>
        <translation>La grandeur {quantity!r} n’existe pas : il y a {known}.</translation>
    </message>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>La mémoire ne suffit pas pour cela.</translation>
    </message>
    <message>
        <source>These are not among the parts above</source>
        <translation>Ils ne sont pas parmi les pièces ci-dessus</translation>
    </message>
    <message>
        <source>These are not in the table above</source>
        <translation>Ils ne sont pas dans le tableau ci-dessus</translation>
    </message>
    <message>
        <source>Thickness and box: {unit}. The fill is the share of its box that a part fills, V/VBB.</source>
        <translation>Épaisseur et boîte : {unit}. Le remplissage est la part de sa boîte que remplit une pièce, V/VBB.</translation>
    </message>
    <message>
        <source>Thickness and box: {unit}. The margin is how far the deciding quantities lie from another category, relative to their thresholds.</source>
        <translation>Épaisseur et boîte : {unit}. La marge dit à quelle distance d’une autre catégorie sont les grandeurs décisives, rapportée à leurs seuils.</translation>
    </message>
    <message>
        <source>Thickness by</source>
        <translation>Épaisseur par</translation>
    </message>
    <message>
        <source>Thin part</source>
        <translation>Pièce mince</translation>
    </message>
    <message>
        <source>Thin plates nearly everywhere</source>
        <translation>Des plaques minces presque partout</translation>
    </message>
    <message>
        <source>Thin ribs, pins, teeth or a thread on a solid body</source>
        <translation>Nervures, broches, dents ou filetage minces sur un corps massif</translation>
    </message>
    <message>
        <source>Thin share</source>
        <translation>Part mince</translation>
    </message>
    <message>
        <source>Thin walls in places</source>
        <translation>Des parois minces par endroits</translation>
    </message>
    <message>
        <source>Thin walls over most of its surface</source>
        <translation>Parois minces sur presque toute la surface</translation>
    </message>
    <message>
        <source>Thin walls, tapered ones too, over a good part of its surface</source>
        <translation>Des parois minces, même en dépouille, sur une bonne partie de la surface</translation>
    </message>
    <message>
        <source>Thinner wall beside a thick body</source>
        <translation>Paroi plus mince à côté d’un corps épais</translation>
    </message>
    <message>
        <source>Thinnest</source>
        <translation>Plus mince</translation>
    </message>
    <message>
        <source>Thinnest parallel wall {thinnest}: classify the part again for its tapered walls.</source>
        <translation>Paroi parallèle la plus mince {thinnest} : reclassez la pièce pour ses parois en dépouille.</translation>
    </message>
    <message>
        <source>Thinnest towards</source>
        <translation>Plus mince vers</translation>
    </message>
    <message>
        <source>Thinnest wall</source>
        <translation>Paroi la plus mince</translation>
    </message>
    <message>
        <source>Thinnest wall {thinnest}</source>
        <translation>Paroi la plus mince {thinnest}</translation>
    </message>
    <message>
        <source>Thinnest wall {thinnest}, in a taper</source>
        <translation>Paroi la plus mince {thinnest}, en dépouille</translation>
    </message>
    <message>
        <source>Thinnest wall {thinnest}, in a taper; {count} places below {below:.2g}</source>
        <translation>Paroi la plus mince {thinnest}, en dépouille ; {count} endroits sous {below:.2g}</translation>
    </message>
    <message>
        <source>Thinnest wall {thinnest}; {count} places below {below:.2g}</source>
        <translation>Paroi la plus mince {thinnest} ; {count} endroits sous {below:.2g}</translation>
    </message>
    <message>
        <source>Thinnest {thinnest}, {depth:.2g} beside a sharp edge</source>
        <translation>Endroit le plus mince {thinnest}, à {depth:.2g} d’une arête vive</translation>
    </message>
    <message>
        <source>Thinnest {thinnest}, {depth:.2g} beside a sharp edge; {count} places below {below:.2g}</source>
        <translation>Endroit le plus mince {thinnest}, à {depth:.2g} d’une arête vive ; {count} endroits sous {below:.2g}</translation>
    </message>
    <message>
        <source>Thinnest, {unit}</source>
        <translation>Plus mince, {unit}</translation>
    </message>
    <message>
        <source>This FreeCAD has no FEM workbench: install it (Debian: 'apt-get install freecad', elsewhere the installer of freecad.org, which has it), then start FreeCAD again.</source>
        <translation>Ce FreeCAD n'a pas d'atelier FEM : installez-le (Debian : 'apt-get install freecad', ailleurs l'installateur de freecad.org, qui le contient), puis redémarrez FreeCAD.</translation>
    </message>
    <message>
        <source>This may be an older shape of '{object}', because its last recompute failed ({reason}): repair it and recompute the document.</source>
        <translation>Il s’agit peut-être d’une ancienne forme de « {object} », car son dernier recalcul a échoué ({reason}) : réparez l’objet et recalculez le document.</translation>
    </message>
    <message>
        <source>This may be an older shape of '{object}', because the last recompute of '{feature}', which it is made with, failed ({reason}): repair it and recompute the document.</source>
        <translation>Il s’agit peut-être d’une ancienne forme de « {object} », car le dernier recalcul de « {feature} », dont il dépend, a échoué ({reason}) : réparez l’objet et recalculez le document.</translation>
    </message>
    <message>
        <source>This needs CalculiX: install it (Debian: 'apt-get install calculix-ccx', elsewhere: https://www.calculix.de), and see that 'ccx -v' runs.</source>
        <translation>Ceci demande CalculiX : l’installer (Debian : 'apt-get install calculix-ccx', ailleurs : https://www.calculix.de) et vérifier que 'ccx -v' fonctionne.</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Seuil</translation>
    </message>
    <message>
        <source>Thresholds chosen on 496 real CAD parts of 43 public repositories that engineers labelled by eye, and tried on repositories left out; quantities after Giannini, Petton, Pernot, TMCE 2012, in units of the middle side of the box</source>
        <translation>Seuils choisis sur 496 pièces CAO réelles de 43 dépôts publics que des ingénieurs ont étiquetées à l’œil, et essayés sur des dépôts laissés de côté ; grandeurs d’après Giannini, Petton, Pernot, TMCE 2012, en unités du côté médian de la boîte</translation>
    </message>
    <message>
        <source>Twice the volume by the area and the median local thickness: 1 of a plate, 1/2 of a wire or square bar</source>
        <translation>Double du volume par la surface et l’épaisseur locale médiane : 1 pour une plaque, 1/2 pour un fil ou une barre carrée</translation>
    </message>
    <message>
        <source>Two lines of a nozzle of 0.4 mm.</source>
        <translation>Deux cordons d’une buse de 0,4 mm.</translation>
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
        <source>Unsure: “{category}” ({probability}) or “{other}” ({others}).</source>
        <translation>Incertain : « {category} » ({probability}) ou « {other} » ({others}).</translation>
    </message>
    <message>
        <source>VTK PolyData with thickness (*.vtp)</source>
        <translation>VTK PolyData avec épaisseur (*.vtp)</translation>
    </message>
    <message>
        <source>Very thin wall on a filled part</source>
        <translation>Paroi très mince sur une pièce pleine</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Volume of the part</source>
        <translation>Volume de la pièce</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Paroi</translation>
    </message>
    <message>
        <source>Wall thickness of 1 part</source>
        <translation>Épaisseur de paroi de 1 pièce</translation>
    </message>
    <message>
        <source>Wall thickness of {count} parts</source>
        <translation>Épaisseur de paroi de {count} pièces</translation>
    </message>
    <message>
        <source>Walls held on two sides; free-standing ones need more.</source>
        <translation>Parois tenues de deux côtés ; les parois libres demandent plus.</translation>
    </message>
    <message>
        <source>Walls {low} to {high} thick, {share} of the surface</source>
        <translation>Parois de {low} à {high}, {share} de la surface</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Avertissements</translation>
    </message>
    <message>
        <source>What is solid could not be cut from the walls ({problem}).</source>
        <translation>Le solide n’a pas pu être séparé des parois ({problem}).</translation>
    </message>
    <message>
        <source>What is solid of {part} could not be meshed ({problem}).</source>
        <translation>Le solide de {part} n’a pas pu être maillé ({problem}).</translation>
    </message>
    <message>
        <source>What is solid of {part} is not in the file. {problem}</source>
        <translation>Le solide de {part} n’est pas dans le fichier. {problem}</translation>
    </message>
    <message>
        <source>What shows it</source>
        <translation>Ce qui le montre</translation>
    </message>
    <message>
        <source>Where it is thin</source>
        <translation>Où elle est mince</translation>
    </message>
    <message>
        <source>Whether its walls lie within what processes allow</source>
        <translation>Si ses parois respectent ce que permettent les procédés</translation>
    </message>
    <message>
        <source>Why it is in this category</source>
        <translation>Pourquoi cette catégorie</translation>
    </message>
    <message>
        <source>Why:</source>
        <translation>Pourquoi :</translation>
    </message>
    <message>
        <source>With a limit of its own ({reason}), but without a wall that could be measured: {faces}.</source>
        <translation>Avec sa propre limite ({reason}), mais sans paroi mesurable : {faces}.</translation>
    </message>
    <message>
        <source>Within a limit of its own ({reason}): {faces}.</source>
        <translation>Dans sa propre limite ({reason}) : {faces}.</translation>
    </message>
    <message>
        <source>Your libraries have it in another size: this is {scale:.6g} times {file}.</source>
        <translation>Vos bibliothèques l’ont dans une autre taille : celle-ci fait {scale:.6g} fois {file}.</translation>
    </message>
    <message>
        <source>Your libraries have its mirror image: {file}.</source>
        <translation>Vos bibliothèques ont son image miroir : {file}.</translation>
    </message>
    <message>
        <source>Your libraries have one like it: {file}. {evidence}</source>
        <translation>Vos bibliothèques en ont une semblable : {file}. {evidence}</translation>
    </message>
    <message>
        <source>Your libraries have this part: {file}.</source>
        <translation>Vos bibliothèques ont cette pièce : {file}.</translation>
    </message>
    <message>
        <source>Your own limits {file} cannot be written ({problem}): make room, or name another file in THINPART_LIMITS.</source>
        <translation>Vos propres limites {file} ne peuvent pas être écrites ({problem}) : faites de la place ou nommez un autre fichier dans THINPART_LIMITS.</translation>
    </message>
    <message>
        <source>Zinc, large casting</source>
        <translation>Zinc, grande pièce</translation>
    </message>
    <message>
        <source>Zinc, small casting</source>
        <translation>Zinc, petite pièce</translation>
    </message>
    <message>
        <source>a bar of {thickness} ({share} of the width)</source>
        <translation>une barre de {thickness} ({share} de la largeur)</translation>
    </message>
    <message>
        <source>a block of its elements is empty</source>
        <translation>un bloc de ses éléments est vide</translation>
    </message>
    <message>
        <source>a larger error, a fifth of the elements</source>
        <translation>une erreur plus grande, un cinquième des éléments</translation>
    </message>
    <message>
        <source>a number in it is too long</source>
        <translation>un nombre y est trop long</translation>
    </message>
    <message>
        <source>a part of {file} is neither measured nor refused</source>
        <translation>une pièce de {file} n’est ni mesurée ni refusée</translation>
    </message>
    <message>
        <source>a rib of {thickness} ({share} of the width)</source>
        <translation>une nervure de {thickness} ({share} de la largeur)</translation>
    </message>
    <message>
        <source>a stud of {thickness} ({share} of the width)</source>
        <translation>un téton de {thickness} ({share} de la largeur)</translation>
    </message>
    <message>
        <source>a taper {least} to {thickness} thick</source>
        <translation>une dépouille de {least} à {thickness}</translation>
    </message>
    <message>
        <source>a twentieth of the surface is thinner than {limit}, 1/{part:.1f} of an element</source>
        <translation>un vingtième de la surface est plus mince que {limit}, 1/{part:.1f} d'un élément</translation>
    </message>
    <message>
        <source>a wall of {thickness} ({share} of the width)</source>
        <translation>une paroi de {thickness} ({share} de la largeur)</translation>
    </message>
    <message>
        <source>along the principal axes; diagonal {diagonal}</source>
        <translation>selon les axes principaux ; diagonale {diagonal}</translation>
    </message>
    <message>
        <source>an edge of {shortest}, 1/{part:.0f} of an element</source>
        <translation>une arête de {shortest}, 1/{part:.0f} d'un élément</translation>
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
        <source>an entry is called '{entry}'</source>
        <translation>une entrée se nomme « {entry} »</translation>
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
        <source>an unexpected error</source>
        <translation>une erreur inattendue</translation>
    </message>
    <message>
        <source>an unexpected error in ThinPart: try again, and report it with the file if it happens again</source>
        <translation>une erreur inattendue dans ThinPart : réessayez, et signalez-la avec le fichier si elle se reproduit</translation>
    </message>
    <message>
        <source>and {count} more</source>
        <translation>et {count} autres</translation>
    </message>
    <message>
        <source>and {count} smaller walls, {share} of the surface</source>
        <translation>et {count} parois plus petites, {share} de la surface</translation>
    </message>
    <message>
        <source>angular deflection</source>
        <translation>Déflexion angulaire</translation>
    </message>
    <message>
        <source>another program keeps the folder locked</source>
        <translation>un autre programme garde le dossier verrouillé</translation>
    </message>
    <message>
        <source>as it was open in FreeCAD, not saved</source>
        <translation>tel qu’il était ouvert dans FreeCAD, non enregistré</translation>
    </message>
    <message>
        <source>as proposed</source>
        <translation>comme proposé</translation>
    </message>
    <message>
        <source>bar</source>
        <translation>barre</translation>
    </message>
    <message>
        <source>below {share}</source>
        <translation>moins de {share}</translation>
    </message>
    <message>
        <source>beside a sharp edge</source>
        <translation>près d’une arête vive</translation>
    </message>
    <message>
        <source>beside edges, {share} of the surface is thinner than {limit}, {part} of the width of {middle}</source>
        <translation>près des arêtes, {share} de la surface est plus mince que {limit}, {part} de la largeur de {middle}</translation>
    </message>
    <message>
        <source>block</source>
        <translation>bloc</translation>
    </message>
    <message>
        <source>borderline</source>
        <translation>cas limite</translation>
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
        <source>by Netgen, since Gmsh does not mesh it</source>
        <translation>par Netgen, car Gmsh ne le maille pas</translation>
    </message>
    <message>
        <source>byte {place} is not text in Unicode</source>
        <translation>l'octet {place} n'est pas du texte Unicode</translation>
    </message>
    <message>
        <source>can be edited in FreeCAD</source>
        <translation>modifiable dans FreeCAD</translation>
    </message>
    <message>
        <source>colours stand for the largest ball inside that touches the surface</source>
        <translation>les couleurs représentent la plus grande bille intérieure qui touche la surface</translation>
    </message>
    <message>
        <source>colours stand for the local thickness</source>
        <translation>les couleurs représentent l’épaisseur locale</translation>
    </message>
    <message>
        <source>colours stand for the thickness of the wall below the surface</source>
        <translation>les couleurs représentent l’épaisseur de la paroi sous la surface</translation>
    </message>
    <message>
        <source>coordinates are not numbers</source>
        <translation>des coordonnées ne sont pas des nombres</translation>
    </message>
    <message>
        <source>curved walls that elements change by over {part} of their thickness on {share} of the surface</source>
        <translation>parois courbes que les éléments changent de plus de {part} de leur épaisseur sur {share} de la surface</translation>
    </message>
    <message>
        <source>different proportions</source>
        <translation>d’autres proportions</translation>
    </message>
    <message>
        <source>different wall distribution</source>
        <translation>répartition des parois différente</translation>
    </message>
    <message>
        <source>edges of it join more than two faces ({count}), as where bodies touch along them: fuse these with some overlap, or separate them</source>
        <translation>des arêtes joignent plus de deux faces ({count}), comme là où des corps se touchent le long d’elles : fusionnez-les avec un recouvrement, ou séparez-les</translation>
    </message>
    <message>
        <source>element size {size}</source>
        <translation>taille d’élément {size}</translation>
    </message>
    <message>
        <source>excluded: {reason}</source>
        <translation>exclue : {reason}</translation>
    </message>
    <message>
        <source>faces that lie on each other taken out</source>
        <translation>sans les faces superposées</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>échec</translation>
    </message>
    <message>
        <source>family {number}</source>
        <translation>famille {number}</translation>
    </message>
    <message>
        <source>far fewer tapered walls</source>
        <translation>beaucoup moins de parois obliques</translation>
    </message>
    <message>
        <source>far more tapered walls</source>
        <translation>beaucoup plus de parois obliques</translation>
    </message>
    <message>
        <source>fewer layers in the thinnest walls, a twentieth of the thin area</source>
        <translation>moins de couches dans les parois les plus minces, un vingtième de la surface mince</translation>
    </message>
    <message>
        <source>fewer layers, a fifth of the elements</source>
        <translation>moins de couches, un cinquième des éléments</translation>
    </message>
    <message>
        <source>fewer tapered walls</source>
        <translation>moins de parois obliques</translation>
    </message>
    <message>
        <source>fill not comparable</source>
        <translation>remplissage non comparable</translation>
    </message>
    <message>
        <source>fill, V/VBB</source>
        <translation>remplissage, V/VBB</translation>
    </message>
    <message>
        <source>fine</source>
        <translation>fine</translation>
    </message>
    <message>
        <source>finer at curves, short edges and narrow faces</source>
        <translation>plus fin sur les courbes, les arêtes courtes et les faces étroites</translation>
    </message>
    <message>
        <source>finer where Gmsh failed</source>
        <translation>plus fin là où Gmsh a échoué</translation>
    </message>
    <message>
        <source>finer where Gmsh failed, surfaces by Delaunay's method</source>
        <translation>plus fin là où Gmsh a échoué, surfaces selon Delaunay</translation>
    </message>
    <message>
        <source>flatter box</source>
        <translation>boîte plus plate</translation>
    </message>
    <message>
        <source>for the verdict</source>
        <translation>pour le verdict</translation>
    </message>
    <message>
        <source>format is not {format!r}</source>
        <translation>format n’est pas {format!r}</translation>
    </message>
    <message>
        <source>geometry, not triangles</source>
        <translation>une géométrie, pas des triangles</translation>
    </message>
    <message>
        <source>group {number}</source>
        <translation>groupe {number}</translation>
    </message>
    <message>
        <source>has a name of its own</source>
        <translation>a un nom propre</translation>
    </message>
    <message>
        <source>has notes</source>
        <translation>a des notes</translation>
    </message>
    <message>
        <source>in a taper</source>
        <translation>dans un coin</translation>
    </message>
    <message>
        <source>it cannot be unpacked</source>
        <translation>il ne peut pas être décompressé</translation>
    </message>
    <message>
        <source>it fills {share} of its box</source>
        <translation>remplit {share} de sa boîte englobante</translation>
    </message>
    <message>
        <source>it has no such motion</source>
        <translation>ce mouvement n’existe pas</translation>
    </message>
    <message>
        <source>it has no triangles</source>
        <translation>elle n’a pas de triangles</translation>
    </message>
    <message>
        <source>it has {count} cells, and the header has {columns}: put quotes around what holds a comma</source>
        <translation>la ligne a {count} cellules et l’en-tête {columns} : mettez entre guillemets ce qui contient une virgule</translation>
    </message>
    <message>
        <source>it is a file</source>
        <translation>c’est un fichier</translation>
    </message>
    <message>
        <source>it is damaged or incomplete</source>
        <translation>il est endommagé ou incomplet</translation>
    </message>
    <message>
        <source>it is larger than {megabytes} MB</source>
        <translation>il dépasse {megabytes} Mo</translation>
    </message>
    <message>
        <source>it is nested too deeply</source>
        <translation>l’imbrication est trop profonde</translation>
    </message>
    <message>
        <source>it is not JSON: line {line} column {column}</source>
        <translation>ce n’est pas du JSON : ligne {line}, colonne {column}</translation>
    </message>
    <message>
        <source>it is not UTF-8 text</source>
        <translation>ce n’est pas du texte UTF-8</translation>
    </message>
    <message>
        <source>it is not a CSV table ({problem})</source>
        <translation>ce n’est pas un tableau CSV ({problem})</translation>
    </message>
    <message>
        <source>it is not a regular file</source>
        <translation>ce n'est pas un fichier ordinaire</translation>
    </message>
    <message>
        <source>it is not in the binary MSH format 2.2</source>
        <translation>il n’est pas au format MSH 2.2 binaire</translation>
    </message>
    <message>
        <source>it is not text in UTF-8: save the table as CSV</source>
        <translation>ce n’est pas du texte en UTF-8 : enregistrez le tableau au format CSV</translation>
    </message>
    <message>
        <source>it names no file</source>
        <translation>la ligne ne nomme aucun fichier</translation>
    </message>
    <message>
        <source>it stores a file as '{path}'</source>
        <translation>il range un fichier sous « {path} »</translation>
    </message>
    <message>
        <source>it stores a resource as '{path}'</source>
        <translation>il range une ressource sous « {path} »</translation>
    </message>
    <message>
        <source>its box is flat, {long} by {middle} by {short}</source>
        <translation>boîte englobante plate, {long} par {middle} par {short}</translation>
    </message>
    <message>
        <source>its mesh is incomplete: is the disk full?</source>
        <translation>son maillage est incomplet : le disque est-il plein ?</translation>
    </message>
    <message>
        <source>its parts are not those of {file}</source>
        <translation>ses pièces ne sont pas celles de {file}</translation>
    </message>
    <message>
        <source>its probabilities are not of its categories, in their order</source>
        <translation>les probabilités ne correspondent pas aux catégories dans leur ordre</translation>
    </message>
    <message>
        <source>its reference mesh is too large</source>
        <translation>son maillage de référence est trop grand</translation>
    </message>
    <message>
        <source>its reference mesh took too long</source>
        <translation>son maillage de référence a pris trop de temps</translation>
    </message>
    <message>
        <source>its second answer is the first one</source>
        <translation>la seconde réponse est la même que la première</translation>
    </message>
    <message>
        <source>its walls make no shell</source>
        <translation>ses parois ne forment pas de coque</translation>
    </message>
    <message>
        <source>its {entry} declares its own entities</source>
        <translation>son {entry} déclare ses propres entités</translation>
    </message>
    <message>
        <source>its {entry} is not in UTF-8</source>
        <translation>son {entry} n'est pas en UTF-8</translation>
    </message>
    <message>
        <source>its {entry} would be larger than {gigabytes} GB</source>
        <translation>son {entry} dépasserait {gigabytes} Go</translation>
    </message>
    <message>
        <source>keep</source>
        <translation>à conserver</translation>
    </message>
    <message>
        <source>layers in its thin walls</source>
        <translation>couches dans les parois minces</translation>
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
        <source>less than {share} of the surface lies over walls thinner than {limit}, {part} of the width of {middle}</source>
        <translation>moins de {share} de la surface recouvre des parois plus minces que {limit}, {part} de la largeur de {middle}</translation>
    </message>
    <message>
        <source>linear deflection</source>
        <translation>Déflexion linéaire</translation>
    </message>
    <message>
        <source>linear deflection {linear}, angular deflection {angular} degrees, at walls {wall}, at least {samples} samples, accuracy {accuracy}</source>
        <translation>déviation linéaire {linear}, déviation angulaire {angular} degrés, aux parois {wall}, au moins {samples} points de mesure, précision {accuracy}</translation>
    </message>
    <message>
        <source>longer box</source>
        <translation>boîte plus longue</translation>
    </message>
    <message>
        <source>longest side</source>
        <translation>plus long côté</translation>
    </message>
    <message>
        <source>look in FreeCAD what 'Check geometry' says about it</source>
        <translation>voyez dans FreeCAD ce qu’en dit « Vérifier la géométrie »</translation>
    </message>
    <message>
        <source>median wall / diagonal of the box</source>
        <translation>paroi médiane / diagonale de la boîte</translation>
    </message>
    <message>
        <source>middle side</source>
        <translation>côté moyen</translation>
    </message>
    <message>
        <source>more filled</source>
        <translation>plus remplie</translation>
    </message>
    <message>
        <source>more tapered walls</source>
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
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>no element larger than the part is thick there</source>
        <translation>aucun élément plus grand que l'épaisseur locale de la pièce</translation>
    </message>
    <message>
        <source>no permission to read the file</source>
        <translation>pas d’autorisation de lire le fichier</translation>
    </message>
    <message>
        <source>no reason given</source>
        <translation>aucune raison donnée</translation>
    </message>
    <message>
        <source>no wall is thinner than {limit}, {part} of the width of {middle}</source>
        <translation>aucune paroi n’est plus mince que {limit}, {part} de la largeur de {middle}</translation>
    </message>
    <message>
        <source>no wall is thinner than {thinnest}, {part} of the width of {middle}</source>
        <translation>aucune paroi n’est plus mince que {thinnest}, {part} de la largeur de {middle}</translation>
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
        <source>not measured</source>
        <translation>non mesuré</translation>
    </message>
    <message>
        <source>of least volume; diagonal {diagonal}</source>
        <translation>de volume minimal ; diagonale {diagonal}</translation>
    </message>
    <message>
        <source>of the diagonal</source>
        <translation>de la diagonale</translation>
    </message>
    <message>
        <source>one reference mesh is not enough, and a second one too large</source>
        <translation>un maillage de référence ne suffit pas, et un second est trop grand</translation>
    </message>
    <message>
        <source>one size, since nothing finer is meshed</source>
        <translation>une seule taille, car rien de plus fin ne se maille</translation>
    </message>
    <message>
        <source>only tapered walls are thinner than {limit}, {part} of the width of {middle}</source>
        <translation>seules des parois en dépouille sont plus minces que {limit}, {part} de la largeur de {middle}</translation>
    </message>
    <message>
        <source>only {share} of the surface lies over walls thinner than {limit}, {part} of the width of {middle}</source>
        <translation>seulement {share} de la surface recouvre des parois plus minces que {limit}, {part} de la largeur de {middle}</translation>
    </message>
    <message>
        <source>other</source>
        <translation>autre</translation>
    </message>
    <message>
        <source>parts of its surface</source>
        <translation>des parties de sa surface</translation>
    </message>
    <message>
        <source>plate</source>
        <translation>plaque</translation>
    </message>
    <message>
        <source>processes[{number}]{place} has a min_mm of {least:g}, not below its max_mm of {most:g}</source>
        <translation>processes[{number}]{place} a un min_mm de {least:g}, qui n’est pas sous son max_mm de {most:g}</translation>
    </message>
    <message>
        <source>processes[{number}]{place} has neither min_mm nor max_mm</source>
        <translation>processes[{number}]{place} n’a ni min_mm ni max_mm</translation>
    </message>
    <message>
        <source>proportions not comparable</source>
        <translation>proportions non comparables</translation>
    </message>
    <message>
        <source>radius {number}</source>
        <translation>rayon {number}</translation>
    </message>
    <message>
        <source>rib</source>
        <translation>nervure</translation>
    </message>
    <message>
        <source>same fill</source>
        <translation>même remplissage</translation>
    </message>
    <message>
        <source>same proportions</source>
        <translation>mêmes proportions</translation>
    </message>
    <message>
        <source>same wall distribution</source>
        <translation>même répartition des parois</translation>
    </message>
    <message>
        <source>short edges and narrow faces not finer than the walls</source>
        <translation>arêtes courtes et faces étroites pas plus fines que les parois</translation>
    </message>
    <message>
        <source>shorter box</source>
        <translation>boîte plus courte</translation>
    </message>
    <message>
        <source>shortest side</source>
        <translation>plus petit côté</translation>
    </message>
    <message>
        <source>similar proportions</source>
        <translation>proportions semblables</translation>
    </message>
    <message>
        <source>similar wall distribution</source>
        <translation>répartition des parois similaire</translation>
    </message>
    <message>
        <source>standard</source>
        <translation>standard</translation>
    </message>
    <message>
        <source>stopped on request</source>
        <translation>arrêté à la demande</translation>
    </message>
    <message>
        <source>surfaces by Delaunay's method</source>
        <translation>surfaces selon Delaunay</translation>
    </message>
    <message>
        <source>taper</source>
        <translation>dépouille</translation>
    </message>
    <message>
        <source>the cluster cannot be used</source>
        <translation>la grappe de calcul n’est pas utilisable</translation>
    </message>
    <message>
        <source>the column {columns} is missing; there have to be {required}, and there may be {optional}</source>
        <translation>la colonne {columns} manque ; il faut {required}, et il peut y avoir {optional}</translation>
    </message>
    <message>
        <source>the column {columns} is there twice</source>
        <translation>la colonne {columns} figure deux fois</translation>
    </message>
    <message>
        <source>the file is damaged or not what its name says</source>
        <translation>le fichier est endommagé ou n’est pas ce que dit son nom</translation>
    </message>
    <message>
        <source>the file is unsafe to open</source>
        <translation>le fichier n’est pas sûr à ouvrir</translation>
    </message>
    <message>
        <source>the file or document is empty</source>
        <translation>le fichier ou le document est vide</translation>
    </message>
    <message>
        <source>the first of equals</source>
        <translation>la première d’égales</translation>
    </message>
    <message>
        <source>the first wall along the inward normal</source>
        <translation>la première paroi le long de la normale intérieure</translation>
    </message>
    <message>
        <source>the format is not supported here</source>
        <translation>le format n’est pas pris en charge ici</translation>
    </message>
    <message>
        <source>the info file could not be written</source>
        <translation>le fichier d’information n’a pas pu être écrit</translation>
    </message>
    <message>
        <source>the latest</source>
        <translation>la plus récente</translation>
    </message>
    <message>
        <source>the memory limit was reached</source>
        <translation>la limite de mémoire a été atteinte</translation>
    </message>
    <message>
        <source>the mesh was not written ({problem})</source>
        <translation>le maillage n'a pas été écrit ({problem})</translation>
    </message>
    <message>
        <source>the paper's pair rule</source>
        <translation>la règle des paires de l’article</translation>
    </message>
    <message>
        <source>the part encloses no volume</source>
        <translation>la pièce n’enferme aucun volume</translation>
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
        <source>the solver crashed</source>
        <translation>le solveur a planté</translation>
    </message>
    <message>
        <source>the solver needed too much memory</source>
        <translation>le solveur a demandé trop de mémoire</translation>
    </message>
    <message>
        <source>the solver took too long</source>
        <translation>le solveur a pris trop de temps</translation>
    </message>
    <message>
        <source>the time limit was reached</source>
        <translation>la limite de temps a été atteinte</translation>
    </message>
    <message>
        <source>the worker process crashed</source>
        <translation>le processus de travail a planté</translation>
    </message>
    <message>
        <source>there is no closed solid in it</source>
        <translation>il n’y a pas de solide fermé dedans</translation>
    </message>
    <message>
        <source>there is no info file of {file!r} in {library}: classify it first, write its path as it is below that folder, or take the row out</source>
        <translation>il n’y a pas de fichier d’information de {file!r} dans {library} : classifiez d’abord le fichier, écrivez son chemin tel qu’il est sous ce dossier, ou supprimez la ligne</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>ce fichier n’existe pas</translation>
    </message>
    <message>
        <source>thickness, {unit}</source>
        <translation>épaisseur, {unit}</translation>
    </message>
    <message>
        <source>thin</source>
        <translation>mince</translation>
    </message>
    <message>
        <source>thin below {limit}</source>
        <translation>mince sous {limit}</translation>
    </message>
    <message>
        <source>thin features</source>
        <translation>zones minces</translation>
    </message>
    <message>
        <source>thinnest wall</source>
        <translation>paroi la plus mince</translation>
    </message>
    <message>
        <source>thinnest wall, {unit}</source>
        <translation>paroi la plus mince, {unit}</translation>
    </message>
    <message>
        <source>thread</source>
        <translation>filetage</translation>
    </message>
    <message>
        <source>thread {least} to {thickness} thick</source>
        <translation>filet de {least} à {thickness}</translation>
    </message>
    <message>
        <source>thread {least} to {thickness} thick, with a run-out to a sharp edge</source>
        <translation>filet de {least} à {thickness}, qui finit en arête vive</translation>
    </message>
    <message>
        <source>tooth</source>
        <translation>dent</translation>
    </message>
    <message>
        <source>tube</source>
        <translation>tube</translation>
    </message>
    <message>
        <source>two entries are called '{entry}'</source>
        <translation>deux entrées se nomment « {entry} »</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>used {count} times</source>
        <translation>utilisée {count} fois</translation>
    </message>
    <message>
        <source>varies: {names}</source>
        <translation>varie : {names}</translation>
    </message>
    <message>
        <source>version is {version}, and this reads version 1</source>
        <translation>version est {version}, et la version 1 est lue ici</translation>
    </message>
    <message>
        <source>volumes by Gmsh's usual method</source>
        <translation>volumes par la méthode habituelle de Gmsh</translation>
    </message>
    <message>
        <source>volumes by the HXT method, which is quicker</source>
        <translation>volumes par la méthode HXT, plus rapide</translation>
    </message>
    <message>
        <source>walls at {low:g} to {high:g} degrees as near as {nearest}</source>
        <translation>parois de {low:g} à {high:g} degrés, distantes de {nearest} seulement</translation>
    </message>
    <message>
        <source>walls thinner than {limit} over {share} of the surface</source>
        <translation>parois plus minces que {limit} sur {share} de la surface</translation>
    </message>
    <message>
        <source>words of names and folders</source>
        <translation>mots des noms et des dossiers</translation>
    </message>
    <message>
        <source>wrong usage of the command</source>
        <translation>la commande a été mal appelée</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>{about} needs more memory than the limit allows.</source>
        <translation>{about} a besoin de plus de mémoire que permis.</translation>
    </message>
    <message>
        <source>{about}: {sentence}</source>
        <translation>{about} : {sentence}</translation>
    </message>
    <message>
        <source>{answer!r} in the column sure is neither yes nor no</source>
        <translation>{answer!r} dans la colonne sure n’est ni yes ni no</translation>
    </message>
    <message>
        <source>{bytes} bytes after its last entry belong to no entry</source>
        <translation>{bytes} octets après la dernière entrée n'appartiennent à aucune</translation>
    </message>
    <message>
        <source>{bytes} bytes that belong to no entry lie before '{entry}'</source>
        <translation>{bytes} octets qui n'appartiennent à aucune entrée précèdent « {entry} »</translation>
    </message>
    <message>
        <source>{bytes} bytes, changed {time} UTC</source>
        <translation>{bytes} octets, modifié {time} UTC</translation>
    </message>
    <message>
        <source>{category!r} is no category: there are {known}</source>
        <translation>{category!r} n’est pas une catégorie : il y a {known}</translation>
    </message>
    <message>
        <source>{category!r} is no category: there are {known}.</source>
        <translation>{category!r} n’est pas une catégorie : il y a {known}.</translation>
    </message>
    <message>
        <source>{category} (unsure)</source>
        <translation>{category} (incertain)</translation>
    </message>
    <message>
        <source>{category}, thinnest wall {thinnest}, median {median}, fill {fill}</source>
        <translation>{category}, paroi la plus mince {thinnest}, médiane {median}, remplissage {fill}</translation>
    </message>
    <message>
        <source>{check} {faces}</source>
        <translation>{check} {faces}</translation>
    </message>
    <message>
        <source>{command} compares the documents themselves.</source>
        <translation>{command} compare les documents eux-mêmes.</translation>
    </message>
    <message>
        <source>{condition} never holds, because it is never above {limit:g}</source>
        <translation>{condition} n’est jamais vrai, car la valeur n’est jamais supérieure à {limit:g}</translation>
    </message>
    <message>
        <source>{condition} never holds, because it is never below {limit:g}</source>
        <translation>{condition} n’est jamais vrai, car la valeur n’est jamais inférieure à {limit:g}</translation>
    </message>
    <message>
        <source>{constant} is not a JSON number</source>
        <translation>{constant} n’est pas un nombre en JSON</translation>
    </message>
    <message>
        <source>{count:.0f} edges shorter than {limit}, the shortest {shortest}, 1/{part:.0f} of an element</source>
        <translation>{count:.0f} arêtes plus courtes que {limit}, la plus courte {shortest}, 1/{part:.0f} d'un élément</translation>
    </message>
    <message>
        <source>{count} bars of {thickness} ({share} of the width)</source>
        <translation>{count} barres de {thickness} ({share} de la largeur)</translation>
    </message>
    <message>
        <source>{count} criteria</source>
        <translation>{count} critères</translation>
    </message>
    <message>
        <source>{count} documents have no info file and are not on this page: 'thinpart classify' measures them.</source>
        <translation>{count} documents n’ont pas de fichier d’information et manquent sur cette page : « thinpart classify » les mesure.</translation>
    </message>
    <message>
        <source>{count} documents of the library are called {file!r}: write the path</source>
        <translation>{count} documents de la bibliothèque s’appellent {file!r} : écrivez le chemin</translation>
    </message>
    <message>
        <source>{count} duplicate triangles were left out.</source>
        <translation>{count} triangles en double ont été omis.</translation>
    </message>
    <message>
        <source>{count} more</source>
        <translation>{count} autres</translation>
    </message>
    <message>
        <source>{count} more faces</source>
        <translation>{count} autres faces</translation>
    </message>
    <message>
        <source>{count} more folders</source>
        <translation>{count} autres dossiers</translation>
    </message>
    <message>
        <source>{count} of them are unsure: close to another category.</source>
        <translation>{count} d’entre elles sont incertaines : proches d’une autre catégorie.</translation>
    </message>
    <message>
        <source>{count} parts are not on the map: no wall was found opposite, or their surface is not closed.</source>
        <translation>{count} pièces ne sont pas sur la carte : aucune paroi n’a été trouvée en face, ou leur surface n’est pas fermée.</translation>
    </message>
    <message>
        <source>{count} parts were measured by an earlier version and are not compared: 'thinpart classify' measures their documents again.</source>
        <translation>{count} pièces ont été mesurées par une version antérieure et ne sont pas comparées : « thinpart classify » mesure de nouveau leurs documents.</translation>
    </message>
    <message>
        <source>{count} ribs of {thickness} ({share} of the width)</source>
        <translation>{count} nervures de {thickness} ({share} de la largeur)</translation>
    </message>
    <message>
        <source>{count} studs of {thickness} ({share} of the width)</source>
        <translation>{count} tétons de {thickness} ({share} de la largeur)</translation>
    </message>
    <message>
        <source>{count} tapers {least} to {thickness} thick</source>
        <translation>{count} dépouilles de {least} à {thickness}</translation>
    </message>
    <message>
        <source>{count} teeth {least} to {thickness} thick</source>
        <translation>{count} dents de {least} à {thickness}</translation>
    </message>
    <message>
        <source>{count} triangles of zero area were left out.</source>
        <translation>{count} triangles d’aire nulle ont été omis.</translation>
    </message>
    <message>
        <source>{count} walls of {thickness} ({share} of the width)</source>
        <translation>{count} parois de {thickness} ({share} de la largeur)</translation>
    </message>
    <message>
        <source>{count} walls {least} to {thickness} thick</source>
        <translation>{count} parois de {least} à {thickness}</translation>
    </message>
    <message>
        <source>{count} warnings</source>
        <translation>{count} avertissements</translation>
    </message>
    <message>
        <source>{faces} and {count} more</source>
        <translation>{faces} et {count} autres</translation>
    </message>
    <message>
        <source>{face} fails its own limit: {ball}, at most {most} ({reason}).</source>
        <translation>{face} ne respecte pas sa propre limite : {ball}, au plus {most} ({reason}).</translation>
    </message>
    <message>
        <source>{face} fails its own limit: {wall}, at least {least} ({reason}).</source>
        <translation>{face} ne respecte pas sa propre limite : {wall}, au moins {least} ({reason}).</translation>
    </message>
    <message>
        <source>{file} cannot be read ({problem}).</source>
        <translation>{file} ne peut pas être lu ({problem}).</translation>
    </message>
    <message>
        <source>{file} cannot be read or written ({problem}): check its name, its permissions and the room on its disk.</source>
        <translation>{file} ne peut être ni lu ni écrit ({problem}) : vérifiez son nom, ses droits et la place sur le disque.</translation>
    </message>
    <message>
        <source>{file} cannot be written ({problem}): name another place.</source>
        <translation>{file} ne peut pas être écrit ({problem}) : indiquez un autre emplacement.</translation>
    </message>
    <message>
        <source>{file} changed while it was read: measure it again.</source>
        <translation>{file} a été modifié pendant la lecture : mesurez-le à nouveau.</translation>
    </message>
    <message>
        <source>{file} could not be read in time.</source>
        <translation>{file} n’a pas pu être lu à temps.</translation>
    </message>
    <message>
        <source>{file} crashed the process that read it: the file is probably damaged.</source>
        <translation>{file} a fait planter le processus de lecture : le fichier est probablement endommagé.</translation>
    </message>
    <message>
        <source>{file} failed ({problem}).</source>
        <translation>{file} a échoué ({problem}).</translation>
    </message>
    <message>
        <source>{file} failed: its result cannot be stored ({problem}).</source>
        <translation>{file} a échoué : son résultat ne peut pas être enregistré ({problem}).</translation>
    </message>
    <message>
        <source>{file} failed: its result cannot be used ({problem}).</source>
        <translation>{file} a échoué : son résultat est inutilisable ({problem}).</translation>
    </message>
    <message>
        <source>{file} has changed since it was classified, or is gone: classify it again.</source>
        <translation>{file} a changé depuis sa classification, ou n’existe plus : classifiez-le à nouveau.</translation>
    </message>
    <message>
        <source>{file} has coordinates that are not finite numbers: export it again.</source>
        <translation>{file} a des coordonnées qui ne sont pas des nombres finis : exportez-le à nouveau.</translation>
    </message>
    <message>
        <source>{file} has faces with more than four corners, which FreeCAD leaves out: triangulate it first.</source>
        <translation>{file} a des faces à plus de quatre sommets, que FreeCAD omet : triangulez-le d’abord.</translation>
    </message>
    <message>
        <source>{file} has no ending that ThinPart reads ({endings}).</source>
        <translation>{file} n’a pas d’extension que ThinPart sait lire ({endings}).</translation>
    </message>
    <message>
        <source>{file} has no part {part!r}: it has {parts}</source>
        <translation>{file} n’a pas de pièce {part!r} : il a {parts}</translation>
    </message>
    <message>
        <source>{file} has no part {part!r}: it has {parts}.</source>
        <translation>{file} n’a pas de pièce {part!r} : il a {parts}.</translation>
    </message>
    <message>
        <source>{file} has no part {part} any more: classify it again.</source>
        <translation>{file} ne contient plus la pièce {part} : classez-le de nouveau.</translation>
    </message>
    <message>
        <source>{file} has the name of a CAD file and was not changed: name another file.</source>
        <translation>{file} porte le nom d'un fichier CAO et n'a pas été modifié : indiquer un autre fichier.</translation>
    </message>
    <message>
        <source>{file} has {count} parts, and one is written: name it after --part, as {example}.</source>
        <translation>{file} contient {count} pièces, et une seule est écrite : nommez-la après --part, par exemple {example}.</translation>
    </message>
    <message>
        <source>{file} has {count} parts: name one after --part, of {parts}.</source>
        <translation>{file} contient {count} pièces : nommez-en une après --part, parmi {parts}.</translation>
    </message>
    <message>
        <source>{file} holds no closed solid, only surfaces, wires or points: close or thicken it first.</source>
        <translation>{file} ne contient pas de solide fermé, seulement des surfaces, des fils ou des points : fermez ou épaississez les surfaces d’abord.</translation>
    </message>
    <message>
        <source>{file} holds no labels: write a row per part below the header.</source>
        <translation>{file} ne contient aucune étiquette : écrivez une ligne par pièce sous l’en-tête.</translation>
    </message>
    <message>
        <source>{file} holds {count} parts: choose one with --part, by name or label: {parts}.</source>
        <translation>{file} contient {count} pièces : choisissez-en une avec --part, par son nom ou son étiquette : {parts}.</translation>
    </message>
    <message>
        <source>{file} holds {count} parts: name one in the column part: {parts}</source>
        <translation>{file} contient {count} pièces : nommez-en une dans la colonne part : {parts}</translation>
    </message>
    <message>
        <source>{file} is a CAD file that ThinPart did not write, and was not changed: name another file.</source>
        <translation>{file} est un fichier CAO que ThinPart n'a pas écrit et n'a pas été modifié : indiquer un autre fichier.</translation>
    </message>
    <message>
        <source>{file} is a link that leads back to itself: remove it or link it to a part.</source>
        <translation>{file} est un lien qui mène à lui-même : retirez-le ou liez-le à une pièce.</translation>
    </message>
    <message>
        <source>{file} is a link that leads nowhere: remove it or link it to a part.</source>
        <translation>{file} est un lien qui ne mène nulle part : retirez-le ou liez-le à une pièce.</translation>
    </message>
    <message>
        <source>{file} is a link to a file that is missing, and was not changed: name the file itself.</source>
        <translation>{file} est un lien vers un fichier absent et n'a pas été modifié : indiquer le fichier lui-même.</translation>
    </message>
    <message>
        <source>{file} is a link to {target}, which is not an output of ThinPart and was not changed: name another file.</source>
        <translation>{file} est un lien vers {target}, qui n'est pas une sortie de ThinPart et n'a pas été modifié : indiquer un autre fichier.</translation>
    </message>
    <message>
        <source>{file} is a program: it was not opened.</source>
        <translation>{file} est un programme et n’a pas été ouvert.</translation>
    </message>
    <message>
        <source>{file} is an empty document.</source>
        <translation>{file} est un document vide.</translation>
    </message>
    <message>
        <source>{file} is an info file and was not changed: name another file.</source>
        <translation>{file} est un fichier d'information et n'a pas été modifié : indiquer un autre fichier.</translation>
    </message>
    <message>
        <source>{file} is an input of this run and was not changed: name another file.</source>
        <translation>{file} est lu par cette exécution et n'a pas été modifié : indiquer un autre fichier.</translation>
    </message>
    <message>
        <source>{file} is damaged or holds no shape.</source>
        <translation>{file} est endommagé ou ne contient aucune forme.</translation>
    </message>
    <message>
        <source>{file} is damaged or not a FreeCAD document ({problem}).</source>
        <translation>{file} est endommagé ou n’est pas un document FreeCAD ({problem}).</translation>
    </message>
    <message>
        <source>{file} is damaged or not what its ending says ({problem}).</source>
        <translation>{file} est endommagé ou n’est pas ce que dit son extension ({problem}).</translation>
    </message>
    <message>
        <source>{file} is damaged, or its faces are not triangles: triangulate it first.</source>
        <translation>{file} est endommagé, ou ses faces ne sont pas des triangles : triangulez-le d’abord.</translation>
    </message>
    <message>
        <source>{file} is empty (0 bytes).</source>
        <translation>{file} est vide (0 octet).</translation>
    </message>
    <message>
        <source>{file} is for one part, and there are {count}: name one after --part, as {example}.</source>
        <translation>{file} est pour une pièce, et il y en a {count} : nommez-en une après --part, par exemple {example}.</translation>
    </message>
    <message>
        <source>{file} is named for two outputs: name another file for one of them.</source>
        <translation>{file} est indiqué pour deux sorties : indiquer un autre fichier pour l'une d’elles.</translation>
    </message>
    <message>
        <source>{file} is no file: name a CAD file with one part.</source>
        <translation>{file} n’est pas un fichier : nommez un fichier CAO contenant une pièce.</translation>
    </message>
    <message>
        <source>{file} is no name for a file of {option}: give it the ending .{ending}.</source>
        <translation>{file} n’est pas un nom pour un fichier de {option} : donnez-lui l’extension .{ending}.</translation>
    </message>
    <message>
        <source>{file} is no name for a map: give it one of the endings {endings}.</source>
        <translation>{file} n’est pas un nom pour une carte : donnez-lui l’une des extensions {endings}.</translation>
    </message>
    <message>
        <source>{file} is no name for a script of Gmsh: give it the ending .geo.</source>
        <translation>{file} n'est pas un nom de script Gmsh : donnez-lui l'extension .geo.</translation>
    </message>
    <message>
        <source>{file} is no name for a shell: give it one of the endings {endings}.</source>
        <translation>{file} n’est pas un nom de coque : donnez-lui l’une des extensions {endings}.</translation>
    </message>
    <message>
        <source>{file} is no profile and is not overwritten: write the new profile elsewhere.</source>
        <translation>{file} n’est pas un profil et n’est pas remplacé : écrivez le nouveau profil ailleurs.</translation>
    </message>
    <message>
        <source>{file} is not a FreeCAD document.</source>
        <translation>{file} n’est pas un document FreeCAD.</translation>
    </message>
    <message>
        <source>{file} is truncated or not an STL file: its header says {announced} triangles, it holds {held}.</source>
        <translation>{file} est tronqué ou n’est pas un fichier STL : l’en-tête annonce {announced} triangles, il en contient {held}.</translation>
    </message>
    <message>
        <source>{file} is truncated: its end is missing.</source>
        <translation>{file} est tronqué : la fin manque.</translation>
    </message>
    <message>
        <source>{file} needs more memory than {megabytes} MB.</source>
        <translation>{file} demande plus de {megabytes} Mo de mémoire.</translation>
    </message>
    <message>
        <source>{file} took longer than {seconds:g} s, the limit for one file.</source>
        <translation>{file} a pris plus de {seconds:g} s, la limite pour un fichier.</translation>
    </message>
    <message>
        <source>{file} was not opened: it links to {links}, which is a pipe, a device or a socket, and FreeCAD would wait there for ever. Get it from a source that you trust.</source>
        <translation>{file} n'a pas été ouvert : il renvoie à {links}, qui est un tube, un périphérique ou un socket, et FreeCAD y attendrait sans fin. Procurez-vous-le auprès d'une source de confiance.</translation>
    </message>
    <message>
        <source>{file} was not opened: {problem}, so it would write outside its own folder or hide some of its content. Get it from a source that you trust.</source>
        <translation>{file} n'a pas été ouvert : {problem}, il écrirait donc hors de son propre dossier ou cacherait une partie de son contenu. Procurez-vous-le auprès d’une source de confiance.</translation>
    </message>
    <message>
        <source>{file} was not written by ThinPart and was not changed: name another file, or allow it to be overwritten (--overwrite).</source>
        <translation>{file} n'a pas été écrit par ThinPart et n'a pas été modifié : indiquer un autre fichier ou permettre de l'écraser (--overwrite).</translation>
    </message>
    <message>
        <source>{file} was not written. {reason}</source>
        <translation>{file} n’a pas été écrit. {reason}</translation>
    </message>
    <message>
        <source>{file} was saved again meanwhile: classify it again.</source>
        <translation>{file} a été réenregistré entre-temps : classifiez-le à nouveau.</translation>
    </message>
    <message>
        <source>{file} was written by another program meanwhile and was not changed: name another file.</source>
        <translation>{file} a été écrit entre-temps par un autre programme et n'a pas été modifié : indiquer un autre fichier.</translation>
    </message>
    <message>
        <source>{file} would have the name of a profile that comes with ThinPart: choose another.</source>
        <translation>{file} porterait le nom d’un profil fourni avec ThinPart : choisissez-en un autre.</translation>
    </message>
    <message>
        <source>{file}, line {line}</source>
        <translation>{file}, ligne {line}</translation>
    </message>
    <message>
        <source>{file}, part {part}</source>
        <translation>{file}, pièce {part}</translation>
    </message>
    <message>
        <source>{first} and {second} exclude each other</source>
        <translation>{first} et {second} s’excluent</translation>
    </message>
    <message>
        <source>{first} to {last} of {count} parts</source>
        <translation>{first} à {last} sur {count} pièces</translation>
    </message>
    <message>
        <source>{first} {next}</source>
        <translation>{first} {next}</translation>
    </message>
    <message>
        <source>{first}; {next}</source>
        <translation>{first} ; {next}</translation>
    </message>
    <message>
        <source>{folder} already exists and is not the folder of a report: it was not changed; give a new or an empty folder.</source>
        <translation>{folder} existe déjà et n’est pas le dossier d’un rapport : il est resté inchangé ; indiquez un dossier nouveau ou vide.</translation>
    </message>
    <message>
        <source>{folder} does not lie below {top}: name a folder after --info-tree that holds all PATHs.</source>
        <translation>{folder} n’est pas sous {top} : nommez avec --info-tree un dossier qui contient tous les PATHs.</translation>
    </message>
    <message>
        <source>{info_file} has version {version}; this ThinPart reads version {known}: use a newer one.</source>
        <translation>{info_file} a la version {version} ; ce ThinPart lit la version {known} : utilisez-en un plus récent.</translation>
    </message>
    <message>
        <source>{info_file} is not a ThinPart info file.</source>
        <translation>{info_file} n’est pas un fichier d’information de ThinPart.</translation>
    </message>
    <message>
        <source>{info_file} is too large for an info file.</source>
        <translation>{info_file} est trop grand pour un fichier d’information.</translation>
    </message>
    <message>
        <source>{inside} of the {free} of free edges lie inside the material: there, walls do not meet, or go over into what is left solid. Close these gaps before solving.</source>
        <translation>{inside} des {free} d’arêtes libres sont dans la matière : là, des parois ne se rejoignent pas ou passent à ce qui reste solide. Fermez ces lacunes avant le calcul.</translation>
    </message>
    <message>
        <source>{length} ± {error:.2g}</source>
        <translation>{length} ± {error:.2g}</translation>
    </message>
    <message>
        <source>{link} was not opened: a link may lead to http:// or https://, or to a file of the library.</source>
        <translation>{link} n’a pas été ouvert : un lien peut mener à http:// ou https://, ou à un fichier de la bibliothèque.</translation>
    </message>
    <message>
        <source>{low} to {high}</source>
        <translation>{low} à {high}</translation>
    </message>
    <message>
        <source>{low} to {high}: {share}</source>
        <translation>{low} à {high} : {share}</translation>
    </message>
    <message>
        <source>{number!r} in the condition {condition!r} is not a number.</source>
        <translation>{number!r} dans la condition {condition!r} n’est pas un nombre.</translation>
    </message>
    <message>
        <source>{one} and {two}</source>
        <translation>{one} et {two}</translation>
    </message>
    <message>
        <source>{one}, {two} and {three}</source>
        <translation>{one}, {two} et {three}</translation>
    </message>
    <message>
        <source>{one}, {two}, {three} and {count} more</source>
        <translation>{one}, {two}, {three} et {count} autres</translation>
    </message>
    <message>
        <source>{part} - wall thickness</source>
        <translation>{part} - épaisseur de paroi</translation>
    </message>
    <message>
        <source>{part} belongs to another document, {file}: open that one, and prepare its mesh there.</source>
        <translation>{part} appartient à un autre document, {file} : ouvrez celui-ci et préparez-y son maillage.</translation>
    </message>
    <message>
        <source>{part} has no shell, since it is not closed or was measured by pairs: close its gaps (Part workbench, Check geometry), or measure it by rays.</source>
        <translation>{part} n’a pas de coque, car il n’est pas fermé ou a été mesuré par paires : fermez ses trous (atelier Part, Vérifier la géométrie), ou mesurez-le par rayons.</translation>
    </message>
    <message>
        <source>{part} has no shell: its walls overlap, and would count for {share:.0f} % of its volume. Mesh it as a solid.</source>
        <translation>{part} n’a pas de coque : ses parois se chevauchent et compteraient pour {share:.0f} % de son volume. Maillez-la en volume.</translation>
    </message>
    <message>
        <source>{part} has no shell: walls with a mid-surface have only {share:.0f} % of its volume. Mesh it as a solid.</source>
        <translation>{part} n’a pas de coque : les parois qui ont une surface moyenne ne font que {share:.0f} % de son volume. Maillez-la en volume.</translation>
    </message>
    <message>
        <source>{part} has no {face}: names of faces are those of FreeCAD, such as Face1.</source>
        <translation>{part} n’a pas de {face} : les faces portent les noms de FreeCAD, comme Face1.</translation>
    </message>
    <message>
        <source>{part} is made of triangles, which are no solid to mesh.</source>
        <translation>{part} est fait de triangles, qui ne sont pas un solide à mailler.</translation>
    </message>
    <message>
        <source>{part} is made of triangles, which have no mid-surface: use its STEP file, or mesh it as a solid.</source>
        <translation>{part} est fait de triangles, qui n’ont pas de surface moyenne : utilisez son fichier STEP, ou maillez-le en volume.</translation>
    </message>
    <message>
        <source>{part} needs more than {megabytes} MB of memory: raise the limit in the preferences.</source>
        <translation>{part} demande plus de {megabytes} Mo de mémoire : augmentez la limite dans les préférences.</translation>
    </message>
    <message>
        <source>{part}: {sentence}</source>
        <translation>{part} : {sentence}</translation>
    </message>
    <message>
        <source>{person!r} cannot be kept as a person's name: choose a shorter one, in one line.</source>
        <translation>{person!r} ne peut pas être gardé comme nom de personne : choisissez-en un plus court, sur une ligne.</translation>
    </message>
    <message>
        <source>{person} calls it {category!r}, which is no category of the start: there are {known}</source>
        <translation>{person} l’appelle {category!r}, qui n’est pas une catégorie du profil de départ : il y a {known}</translation>
    </message>
    <message>
        <source>{person} calls this part {category} here and {other} before ({earlier})</source>
        <translation>{person} appelle cette pièce {category} ici et {other} avant ({earlier})</translation>
    </message>
    <message>
        <source>{person} has labelled this part already ({earlier})</source>
        <translation>{person} a déjà étiqueté cette pièce ({earlier})</translation>
    </message>
    <message>
        <source>{person} is sure of {category} in one place and not in the other ({earlier})</source>
        <translation>{person} est sûr de {category} à un endroit et pas à l’autre ({earlier})</translation>
    </message>
    <message>
        <source>{place} is empty, and a criterion without conditions would always hold</source>
        <translation>{place} est vide, et un critère sans conditions serait toujours rempli</translation>
    </message>
    <message>
        <source>{place} names {quantity!r}, which is no quantity: there are {known}, a below b</source>
        <translation>{place} nomme {quantity!r}, qui n’est pas une grandeur : il y a {known}, a inférieur à b</translation>
    </message>
    <message>
        <source>{place}: {reason}.</source>
        <translation>{place} : {reason}.</translation>
    </message>
    <message>
        <source>{problem} As a file it may have a shell all the same, without faces for supports: ./thinpart size FILE --shell shell.inp.</source>
        <translation>{problem} En fichier, elle peut avoir une coque tout de même, sans faces pour les appuis : ./thinpart size FICHIER --shell coque.inp.</translation>
    </message>
    <message>
        <source>{process} ({material})</source>
        <translation>{process} ({material})</translation>
    </message>
    <message>
        <source>{process}: all walls have limits of their own.</source>
        <translation>{process} : toutes les parois ont leurs propres limites.</translation>
    </message>
    <message>
        <source>{process}: cannot be told: no wall could be measured.</source>
        <translation>{process} : indécidable : aucune paroi n’a pu être mesurée.</translation>
    </message>
    <message>
        <source>{process}: cannot be told: the surface is open, and there may be walls thinner than the {thinnest} that were found.</source>
        <translation>{process} : indécidable : la surface est ouverte, et il peut y avoir des parois plus minces que les {thinnest} trouvés.</translation>
    </message>
    <message>
        <source>{process}: cannot be told: the thinnest wall is {thinnest}, give or take {error:.2g}, the limit is {least}.</source>
        <translation>{process} : indécidable : la paroi la plus mince fait {thinnest}, à {error:.2g} près, la limite est {least}.</translation>
    </message>
    <message>
        <source>{process}: cannot be told: {share} of the surface lies over more than {most}, but a ray may run along a wall there: look at the thickness map.</source>
        <translation>{process} : indécidable : {share} de la surface est au-dessus de plus de {most}, mais un rayon peut y suivre une paroi : regardez la carte d’épaisseur.</translation>
    </message>
    <message>
        <source>{process}: fails, but only where walls end in sharp edges: {findings}.</source>
        <translation>{process} : échec, mais seulement là où des parois finissent en arêtes vives : {findings}.</translation>
    </message>
    <message>
        <source>{process}: fails: {faces} All other faces pass.</source>
        <translation>{process} : échec : {faces} Toutes les autres faces sont conformes.</translation>
    </message>
    <message>
        <source>{process}: fails: {faces} Of all other faces it cannot be told.</source>
        <translation>{process} : échec : {faces} Pour toutes les autres faces, c’est indécidable.</translation>
    </message>
    <message>
        <source>{process}: fails: {findings}.</source>
        <translation>{process} : échoue : {findings}.</translation>
    </message>
    <message>
        <source>{process}: passes within tolerance: the thinnest wall is {thinnest}, give or take {error:.2g}, the limit is {least}.</source>
        <translation>{process} : conforme dans la tolérance : la paroi la plus mince fait {thinnest}, à {error:.2g} près, la limite est {least}.</translation>
    </message>
    <message>
        <source>{process}: passes: no wall is over {most}.</source>
        <translation>{process} : conforme : aucune paroi ne dépasse {most}.</translation>
    </message>
    <message>
        <source>{process}: passes: the thinnest wall is {thinnest}, the limit {least}.</source>
        <translation>{process} : conforme : la paroi la plus mince fait {thinnest}, la limite {least}.</translation>
    </message>
    <message>
        <source>{process}: passes: the thinnest wall is {thinnest}, the limit {least}; towards their edges, tapered walls are thinner on {share} of the surface.</source>
        <translation>{process} : conforme : la paroi la plus mince fait {thinnest}, la limite {least} ; vers leurs arêtes, des parois en dépouille sont plus minces sur {share} de la surface.</translation>
    </message>
    <message>
        <source>{process}: passes: walls from {thinnest} on, the limits are {least} and {most}.</source>
        <translation>{process} : conforme : parois à partir de {thinnest}, les limites sont {least} et {most}.</translation>
    </message>
    <message>
        <source>{profile} cannot be used: {problem} ({place}).</source>
        <translation>{profile} n’est pas utilisable : {problem} ({place}).</translation>
    </message>
    <message>
        <source>{profile} defines 'normal' or 'unknown', which are reserved: rename the category.</source>
        <translation>{profile} définit « normal » ou « unknown », qui sont réservés : renommez la catégorie.</translation>
    </message>
    <message>
        <source>{profile} has version {version}; ThinPart reads version 1.</source>
        <translation>{profile} a la version {version} ; ThinPart lit la version 1.</translation>
    </message>
    <message>
        <source>{profile} has {count} conditions, more than {most}: leave some out.</source>
        <translation>{profile} contient {count} conditions, plus que {most} : retirez-en.</translation>
    </message>
    <message>
        <source>{profile} is not a ThinPart profile.</source>
        <translation>{profile} n’est pas un profil de ThinPart.</translation>
    </message>
    <message>
        <source>{profile} is not well formed: {problem}.</source>
        <translation>{profile} est mal formé : {problem}.</translation>
    </message>
    <message>
        <source>{profile} uses a criterion's id twice: {id!r}.</source>
        <translation>{profile} utilise deux fois l’identifiant d’un critère : {id!r}.</translation>
    </message>
    <message>
        <source>{quantities} could not be measured, so criterion {criteria} cannot be decided.</source>
        <translation>{quantities} n’a pas pu être mesuré, le critère {criteria} reste donc indécis.</translation>
    </message>
    <message>
        <source>{quantity} = {value:.3g}</source>
        <translation>{quantity} = {value:.3g}</translation>
    </message>
    <message>
        <source>{said} So thin a place, {share} of the median of {median}, is often an error of the model: look at it.</source>
        <translation>{said} Un endroit aussi mince, {share} de la médiane de {median}, est souvent une erreur du modèle : vérifiez-le.</translation>
    </message>
    <message>
        <source>{said} The thinnest wall that does not end in one is {walls}.</source>
        <translation>{said} La paroi la plus mince qui ne finit pas en arête est de {walls}.</translation>
    </message>
    <message>
        <source>{sentence} It was not changed.</source>
        <translation>{sentence} Il est resté inchangé.</translation>
    </message>
    <message>
        <source>{sentence} It was not changed: move it away to have a new one written.</source>
        <translation>{sentence} Il est resté inchangé : déplacez-le pour qu’il soit réécrit.</translation>
    </message>
    <message>
        <source>{share} and more</source>
        <translation>{share} et plus</translation>
    </message>
    <message>
        <source>{share} of the surface is thin: {features}. Refine the mesh there.</source>
        <translation>{share} de la surface est mince : {features}. Y raffiner le maillage.</translation>
    </message>
    <message>
        <source>{share} of the surface lies over walls of more than {most}</source>
        <translation>{share} de la surface est au-dessus de parois de plus de {most}</translation>
    </message>
    <message>
        <source>{share} of the surface lies over walls thinner than {limit}, {part} of the width of {middle}</source>
        <translation>{share} de la surface recouvre des parois plus minces que {limit}, {part} de la largeur de {middle}</translation>
    </message>
    <message>
        <source>{share} of the surface lies over walls thinner than {limit}, {part} of the width of {middle}: consider shells (Prepare mesh says whether they can be made).</source>
        <translation>{share} de la surface recouvre des parois plus minces que {limit}, {part} de la largeur de {middle} : envisager des éléments de coque (Préparer le maillage dit s’ils sont possibles).</translation>
    </message>
    <message>
        <source>{share} of the surface lies over walls thinner than {limit}, {part} of the width of {middle}: refine the mesh there.</source>
        <translation>{share} de la surface recouvre des parois plus minces que {limit}, {part} de la largeur de {middle} : y raffiner le maillage.</translation>
    </message>
    <message>
        <source>{share} of the surface over walls of {least} to {most}, beside a thick body</source>
        <translation>{share} de la surface recouvre des parois de {least} à {most}, à côté d’un corps épais</translation>
    </message>
    <message>
        <source>{share} of the surface over walls thinner than {most}</source>
        <translation>{share} de la surface recouvre des parois plus minces que {most}</translation>
    </message>
    <message>
        <source>{thickness} and more</source>
        <translation>{thickness} et plus</translation>
    </message>
    <message>
        <source>{thickness} plate, {share} of the surface</source>
        <translation>Plaque de {thickness}, {share} de la surface</translation>
    </message>
    <message>
        <source>{thickness} sheet, {share} of the surface</source>
        <translation>Tôle de {thickness}, {share} de la surface</translation>
    </message>
    <message>
        <source>{thickness} wall, {share} of the surface</source>
        <translation>Paroi de {thickness}, {share} de la surface</translation>
    </message>
    <message>
        <source>{thinnest}, give or take {error:.2g},</source>
        <translation>{thinnest}, à {error:.2g} près,</translation>
    </message>
    <message>
        <source>{thin} of the surface is under {least}, thinnest {place}</source>
        <translation>{thin} de la surface est sous {least}, au plus mince {place}</translation>
    </message>
    <message>
        <source>{thin} of the surface is under {least}, thinnest {place}, and {thick} over {most}</source>
        <translation>{thin} de la surface est sous {least}, au plus mince {place}, et {thick} au-dessus de {most}</translation>
    </message>
    <message>
        <source>{title} (rule {number})</source>
        <translation>{title} (règle {number})</translation>
    </message>
    <message>
        <source>{triangles} triangles, chord error {error}, {samples} samples</source>
        <translation>{triangles} triangles, erreur de corde {error}, {samples} points de mesure</translation>
    </message>
    <message>
        <source>{walls}: consider shells (Prepare mesh says whether they can be made).</source>
        <translation>{walls} : envisager des éléments de coque (Préparer le maillage dit s’ils sont possibles).</translation>
    </message>
    <message>
        <source>{wall} on {face}</source>
        <translation>{wall} sur {face}</translation>
    </message>
    <message>
        <source>{wall}, {depth:.2g} beside a sharp edge</source>
        <translation>{wall}, à {depth:.2g} d’une arête vive</translation>
    </message>
    <message>
        <source>{wall}.</source>
        <translation>{wall}.</translation>
    </message>
    <message>
        <source>{wall}; sharp edges are {edges} long.</source>
        <translation>{wall} ; les arêtes vives mesurent {edges}.</translation>
    </message>
    <message>
        <source>{what} cannot be stored ({problem}).</source>
        <translation>{what} ne peut pas être conservé ({problem}).</translation>
    </message>
    <message>
        <source>{what} is not a JSON object ({problem}).</source>
        <translation>{what} : pas un objet JSON ({problem}).</translation>
    </message>
    <message>
        <source>{what} is not a JSON object.</source>
        <translation>{what} : pas un objet JSON.</translation>
    </message>
    <message>
        <source>{whose} holds 1 face beside its solids, which was left out: close or thicken it if it is a part.</source>
        <translation>{whose} contient, outre ses solides, 1 face qui a été omise : fermez-la ou épaississez-la si c’est une pièce.</translation>
    </message>
    <message>
        <source>{whose} holds 1 solid that is only a line, which was left out.</source>
        <translation>{whose} contient 1 solide qui n’est qu’une ligne ; il a été omis.</translation>
    </message>
    <message>
        <source>{whose} holds {count} solids that are only a line, which were left out.</source>
        <translation>{whose} contient {count} solides qui ne sont qu’une ligne ; ils ont été omis.</translation>
    </message>
    <message>
        <source>{whose} holds {faces} faces beside its solids, which were left out: close or thicken them if they are a part.</source>
        <translation>{whose} contient, outre ses solides, {faces} faces qui ont été omises : fermez-les ou épaississez-les si elles forment une pièce.</translation>
    </message>
    <message>
        <source>{x:.3g}, {y:.3g}, {z:.3g}</source>
        <translation>{x:.3g} ; {y:.3g} ; {z:.3g}</translation>
    </message>
</context>
<context>
    <name>ThinPart_Classify</name>
    <message>
        <source>Checks whether the selected part is thin, has thin features or is normal, and colours its thin faces</source>
        <translation>Vérifie si la pièce sélectionnée est mince, a des zones minces ou est normale, et colore ses faces minces</translation>
    </message>
    <message>
        <source>Classify part</source>
        <translation>Classifier la pièce</translation>
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
        <source>Restores the colours that the faces of this document had before they were coloured as thin</source>
        <translation>Rétablit les couleurs que les faces de ce document avaient avant d’être colorées comme minces</translation>
    </message>
</context>
<context>
    <name>ThinPart_EditProfile</name>
    <message>
        <source>Edit profile…</source>
        <translation>Modifier le profil…</translation>
    </message>
    <message>
        <source>Edits the thresholds by which parts are judged, and the limits of the wall, and counts meanwhile what would change in your libraries</source>
        <translation>Modifie les seuils selon lesquels les pièces sont jugées et les limites de la paroi, et compte en même temps ce qui changerait dans vos bibliothèques</translation>
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
    <name>ThinPart_Guide</name>
    <message>
        <source>Opens the guide: a page for each job, with pictures and examples</source>
        <translation>Ouvre le guide : une page par tâche, avec des images et des exemples</translation>
    </message>
    <message>
        <source>ThinPart guide</source>
        <translation>Guide de ThinPart</translation>
    </message>
</context>
<context>
    <name>ThinPart_LearnThresholds</name>
    <message>
        <source>Chooses thresholds that agree with what people say of the parts of a library, and says how good they are on folders left out</source>
        <translation>Choisit des seuils qui concordent avec ce que l’on dit des pièces d’une bibliothèque, et indique leur qualité sur des dossiers mis de côté</translation>
    </message>
    <message>
        <source>Learn thresholds…</source>
        <translation>Apprendre des seuils…</translation>
    </message>
</context>
<context>
    <name>ThinPart_MeshSizes</name>
    <message>
        <source>Prepare mesh</source>
        <translation>Préparer le maillage</translation>
    </message>
    <message>
        <source>Proposes element sizes that give the thin walls of the selected part enough layers, and makes a FEM mesh with them</source>
        <translation>Propose des tailles d'éléments qui donnent assez de couches aux parois minces de la pièce sélectionnée, et crée avec elles un maillage FEM</translation>
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
        <source>Colours the selected parts, or all of them, by the thickness of their walls, and shows how the area is distributed over thickness</source>
        <translation>Colore les pièces sélectionnées, ou toutes, selon l’épaisseur de leurs parois, et montre comment la surface se répartit selon l’épaisseur</translation>
    </message>
    <message>
        <source>Show thickness</source>
        <translation>Afficher l’épaisseur</translation>
    </message>
</context>
</TS>
