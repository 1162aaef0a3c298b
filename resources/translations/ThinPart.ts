<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>Colour where no wall was measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours from thin to thick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diagonal of the largest part's bounding box, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Greatest wall that the process allows, mm; 0: any</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How it was measured: across the wall, or as the largest ball inside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured point on the face, in the coordinates of its object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of steps; 0: smooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opposite point, in the coordinates of the document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Placements of the sources when they were measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points opposite the probed points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points where the thickness was probed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Process whose walls are at least Threshold and at most CheckMost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The face where the wall is measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The measured thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sources' shapes when measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The thickness before the sources were changed last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickest wall of the map, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness at the lower end of the colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness at the upper end of the colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thinnest wall of the map, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Transparency of the facets, in percent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit of Low and High</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wall thickness at the measured point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wall thickness at the probed points, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walls thinner than this are thin, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether colours run from the thinnest to the thickest wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether equal ratios of thickness are equally far apart on the scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether only thin walls are coloured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the colours run the other way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the map is lit; off: flat colours, exactly those of the colour bar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the sources have changed since</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ThinPart</name>
    <message>
        <source>
Filled to {} (V/VBB = {})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>
Its volume is unknown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;All parts together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Colours show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Contents</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Exclude…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export CSV…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Fly to thinnest wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Folder:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Isolate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keep measuring</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Learn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Library</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Logarithmic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Measure again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Measure unchanged documents again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Names</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Only thin walls in colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open it in the browser when it is ready</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Probe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Profile:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Remove its limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Remove mesh size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reset to saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Retry failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Shaded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Stop it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Tables</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Thin below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Thresholds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Use as my profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Use it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Whole range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Write report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;beside each document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;in the folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>'normal' and 'unknown' mean that no criterion holds, or that it cannot be told: choose another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>'{}' has not been classified yet: classify the part first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>'{}' is still being measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>'{}' no longer has a part that can be measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, layers in {} of the thin walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 probe was removed: the surface is no longer at its position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A click on the part pins the wall there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A link to {} was put into {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A normal part: one size is enough. About {} elements of {}. Tick a wall to give it layers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A part gets the first category of which a criterion holds. If none holds, it is normal.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A profile that comes with ThinPart stays as it is: save under another name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A shell would take about {} triangles.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A smaller share of the surface counts as none, because single rays may stray</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A verdict is called borderline if a quantity lies nearer to its threshold, relative to that</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A verdict that is less probable is called unsure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About {} elements as a solid, {} as a shell.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About {} elements as a solid.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About {} nodes ({} elements), of {} to {}, for an error of {} in deflections and frequencies. CalculiX takes about {} s for six frequencies.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About {} nodes ({} elements), of {} to {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About {} nodes: more than most analyses need.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Across</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Across the wall (ray)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a category</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a condition (and)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a criterion (or)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a folder with classified parts under 'Libraries'.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a process</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds the folder to the libraries of 'Find parts', and opens that</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Agreement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All labels, either answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An unexpected error occurred ({}): try again, and if it happens again, report it with FreeCAD's log.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle between neighbouring facets of a curved face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angular deflection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another folder…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Answers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apart, {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Area of both of its sides</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Area, {}²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As a picture of any size, or as triangles with their thickness for ParaView, MeshLab and others</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As proposed: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ask for this category earlier: a part gets the first one that applies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ask for this category later: a part gets the first one that applies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At least</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At least, {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At most, {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to its place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to the shipped limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before, {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Borderline within</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bounding box {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Box, {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By which the process is chosen, as in --check</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C&amp;lear all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancelled. Nothing was changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancelled. Nothing was written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancelled: no info file was written, since other parts of the document are not measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Categories (none chosen: any)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Category</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changed at any time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changed in the last day</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changed in the last month</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changed in the last week</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chec&amp;k</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chec&amp;k for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check before meshing whether a part is thin, and where</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checks compare the least wall with the thickness across the wall, and the greatest with the largest balls inside: choose the thickness across the wall under 'Colours show' to see where the limits are broken.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a file with mesh settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a file with thresholds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a folder with classified parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a folder with classified parts, or add one under 'Libraries' in the panel 'Find parts'.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a part in the list to see its faces.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a part in the list to see its walls.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose at least one format.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose tables of labels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the folder for the info files.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the folder that is to be classified.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the folder with the labelled parts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chooses the thresholds that agree most often with what people say of parts: by 'Not right?' beside a verdict, or in tables. Folders that were left out show how good they are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Classification</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Classify again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Classify folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Classify in the background</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Classify part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Classifying again by another profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Classifying the folder has ended: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear filters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear thin colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click or drag over bars to see where those walls are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to close this message.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to show its window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click: fly to its thinnest place. N, P: to the next and the previous one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour bar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour in the view what only one of the two parts has; the document stays as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour thin faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour where no wall could be measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coloured where the two are more than {} apart; at most it is {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours and shares are of the largest balls inside, which shrink to nothing towards sharp edges; the line above is of the thickness across the wall.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours from the thinnest to the thickest wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compared with what the info file said before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compared: {} parts. Groups: {}. Parts besides those to keep: {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compared: {} parts. None of them is there twice, mirrored, in another size, or alike.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comparing the two…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comparing: {} of {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Condition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Confidence: borderline, close to '{}' ({} from the limit)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Confidence: clear ({} from the limit)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connected walls of like thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Continue in the background? 'Classify folder' shows the progress again. Finished results are saved either way.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copied: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Counting…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Criteria</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Criteria and their quantities</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Criteria that hold (none chosen: any)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Criterion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Criterion {}: {}. All its conditions hold: {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cuts the map and the part; the edge of the cut has the colours of the walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dimensions that vary</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Display</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do not say this again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Documents that are not classified yet, and only listed in it: {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double-click a size or a number of layers to change it, for all selected walls. Without the check mark, a wall asks for no small elements.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double-click: fly to its thinnest place. N, P: to the next and the previous one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag it in the view to move it, a corner of it to size it; a right click has more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicates, quickly: by what info files keep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicates, surely: the documents are read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>E&amp;xcept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>E&amp;xport map…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each document is classified in the background when it is saved; the status bar shows the verdict</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit profile: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit your own limits…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Element size, {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Equal ratios of thickness are equally far apart on the scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Equal ratios of thickness are equally far apart, so that thin walls get more of the colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error aimed at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error of probabilities</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Evidence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exclude a wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the rows that are shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export thickness map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Faces that are thin on at least half their area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Faces that are thin on less of their area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Faces thin in places</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Failed: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Families: parts that differ in dimensions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Families: {}. Parts in them: {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files at &amp;once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files at once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter: words of the file or the part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finding element sizes for {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First, coarse colours; finer ones follow, about {} left.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First, coarse colours; finer ones follow.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder for the info files, which mirrors the folders of the documents; it may be on another computer. Empty: beside each document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder of the report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For the info file: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Formats</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD cannot insert {} ({}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD cannot open {} ({}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD may crash in the same way when it opens the file: save your documents first. Open it anyway?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD shows one task at a time: close the one that is open, then try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From behind and below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From now on parts are judged by {}. 'Reclassify' in the panel 'Find parts' judges stored parts by it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the thinnest confirmed wall to the thickness below which 98 % of the surface lies, without rims, whose rays run along the wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the thinnest to the thickest wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From where it is seen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From {} profiles, each learned without some folders or groups, and tried on those. In brackets: intervals of 95 %.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From {} profiles, each learned without some parts, and tried on those. All parts are in one folder, so parts may be similar: the figures are too good. In brackets: intervals of 95 %.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Front</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gmsh made no mesh ({}): try another error or fewer layers, a smaller largest size, or switch a wall off. Nothing was changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gmsh meshes {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Greatest wall, {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Growth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Half of the face's area has thinner walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heat map colour where no wall could be measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heat map of the thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Here: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide colour bar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far a place of one of the two surfaces is from the other at most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far it is from each point of the surface straight through the material to the other side. Verdicts are always judged by it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the mesh may lie from the surface, as a share of the part's diagonal; where walls are thin it is made finer anyway</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How finely parts are measured at first; where the error of a quantity could turn the verdict, a part is measured again, more finely</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How often the part stands in the document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How sure a verdict is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I would say:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I&amp;nclude again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Info file, beside the document: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Info file, in the preferred folder: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Info files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Info files cannot be written in {}: choose another folder for them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Insert into active document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Insert part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Instances</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Into how many steps the colours are divided</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kept because: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kept in the info file with a reason; checks compare this face with it instead of the process</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kept in the info file, also when the part is measured again; the verdict does not change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>L&amp;abels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Label</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Label {} parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Labels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Labels (rows) and verdicts of {} (columns)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Labels: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Larger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest ball</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest ball here: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest ball in {}, and share of the diagonal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest ball inside (sphere)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest ball, {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest size, {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layers in thin walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Learn thresholds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Learned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Learning needs the Python package {}, which this FreeCAD does not have: FreeCAD's Addon Manager offers it when it installs ThinPart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Learning profile {} of {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Learning thresholds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least and median thickness of the wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least share of the surface that counts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least wall, {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left solid, not in the shell: {} walls, last in the table.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Libraries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Like</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limit for {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limits of the wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Linear deflection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Linear elements are far too stiff in thin walls.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Linear triangles are far too stiff in CalculiX.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Local thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Local thickness here: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Local thickness in {}, and share of the diagonal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Local thickness, {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Logarithmic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Long, {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longest side, {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longest, {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking for parts in the folder…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Made by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make shell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Making the mid-surface of {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Making the surface mesh of {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Margin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured: {} parallel, {} tapered, {} nothing opposite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measurements, notes, mesh settings and links stay unchanged. Write the info files now?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measuring and drawing…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measuring needs Python {} beside FreeCAD, which was not found: install it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measuring needs more than {} MB of memory: raise the limit in the preferences.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measuring the walls of {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Median thickness of the wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Median, {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory limit for measuring one document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory per file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mesh and compare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mesh as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mesh file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mesh risk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mesh settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mesh size of a wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Meshes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Most elements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move over the part; a click pins the wall there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>My label: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New process</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No criterion holds: its walls are thick all over.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No file manager was found: open the folder {} yourself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No file manager was found: open the info file {} yourself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No info file was written, because the document is not saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No info file was written, since not every part was measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No info file: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No part was measured, so no info file was written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No place is more than {} apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No program was found that opens {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No thin walls: one size is enough. About {} elements of {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No wall became thinner.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No wall could be measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No wall regions are recorded: measure the part again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No wall was measured here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not compared, because an earlier version has measured them: {}. Classify them again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not counted: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not measured: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not measured: {} of the area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not right?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Now, {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of files of a folder that are measured at the same time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of the group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>OK also makes an analysis, if there is none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of deflections and frequencies, with quadratic elements. It decides the sizes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On every save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On parts that were left out, the learned profile agrees with the labels no better than {} does: keep {}, or label more parts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On {} of the area the largest ball is smaller than {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On {} of the area the local thickness is less than {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One size: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only failures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only labelled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only labelled otherwise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only unsure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only with notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opens a profile that somebody has given you</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opens the page of the guide about this (F1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Order of the elements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Out of date: recompute</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Own limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Own limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part with thin features</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parts are judged by '{}' from now on. Parts that were classified before keep their verdicts until you reclassify them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parts like the active one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parts like this one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Patterns of file names, separated by semicolons; one with a slash is compared with the path below the folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>People</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture of the view (*.png)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pin thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Prepare mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Previous wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probability: {}, next '{}' with {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Process and material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Processes whose least and greatest wall the parts are checked against: a column each</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Processes, with commas between them, whose least and greatest wall every part is checked against</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range of &amp;most walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read the info files again, which may have changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading info files: {} of {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading info files…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading the labels…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reclassify</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reclassify libraries…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reclassify…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recommended: shell.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recommended: solid, or a shell of its walls only.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recommended: solid.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refresh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refreshing the libraries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove all probes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove my label</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove this category</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove this condition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove this criterion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace it? What it contains will be lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report about all parts of '{}'</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report about libraries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report about the classified parts in '{}'</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report about the classified parts in {} libraries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset to saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restore defaults</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resu&amp;me</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reversed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Risk of the automatic mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;hare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save and write info file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the learned profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the profile as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save them?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved in {}, without the probabilities, which belong to other thresholds.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved in {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved in {}. Wherever you choose processes, these limits hold from now on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saves the profile and judges parts by it from now on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Say below a verdict whether the libraries of Find parts have the part already, its mirror image, another size, or one like it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Say what libraries have already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Say what the part is in your eyes. The label is kept in the info file, as of {}; thresholds can be learned from labels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search in it…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Searching for duplicates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a part in the list.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set "Most elements", or a larger error.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set "Most elements", or fewer layers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set &amp;mesh size…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set its &amp;greatest wall…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set its &amp;least wall…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Setting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settings that worked for this part: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settings that worked for {} ({} alike): {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shaded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the face where no wall could be measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the face whose walls are thinner than the threshold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the surface that is the same: the less of both</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shell: its mid-surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Short name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show &amp;all walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show in Find parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show in file manager</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show info file’s folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show poor elements ({})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show sizes on the part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the difference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the shell by its thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shown as thin: below {}, as the preferences say. The verdict does not depend on it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the defaults of this page; OK or Apply saves them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the half that is cut off now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the thresholds of this profile, to change and save them as your own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Similar size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size, {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Something stands before this wall from every side: the mark shows where it is. Hide what covers it, or cut the view open with the clipping plane of the View menu.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source: address</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source: author</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source: title</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source: year</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start &amp;with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starting to measure {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steel (replace it)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop it, and go on here?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped on request before the end.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped: {} of {} info files are up to date.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sure labels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface mesh that is measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Temporary files cannot be written ({}): free some disk space. Nothing was classified.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Temporary files cannot be written ({}): free some disk space. Nothing was measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The active document as it was saved. Click to classify it in the panel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The camera looks at it from where nothing stands before it. N, P: the next thicker wall, and the previous one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The category needs a short name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The category's short name, by which results and searches refer to it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The classification process could not be started.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The classification process ended unexpectedly; finished results are saved. Start again for the rest; the report view shows its last output.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The colours in the view are the first, coarse ones: they are not saved, and go when this panel is closed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The content of {} was copied into {}: a link needs a saved document.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The criterion needs a short name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The criterion's short name, by which results and searches refer to it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The diameter of the largest ball that fits into the material and reaches each point. Edges are as thick as the walls that meet there; ribs, teeth, threads and run-outs have a thickness of their own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The diameter of the largest ball that fits into the material and touches the surface at each point. It is no larger than the wall across and does not see past the next face: at sharp edges it goes down to nothing. It takes longer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The document has changed since it was measured: classify it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The document has changed since it was measured: no info file was written. Classify it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The document has changed while it was measured: measure it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The document has changed while it was meshed: start again. Nothing was changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The document is closed: open it again for a report about it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The failures are folders that could not be searched: make them readable and start again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file {} no longer exists.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The first colour stands for the thickest wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder is still being classified.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder with your parts; its subfolders are included</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder {} has not answered for {} s: connect it, or choose another one for the info files.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder {} is not writable: choose another folder for the info files.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder {} no longer exists.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The info file {} is damaged ({}): classify its document again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The learned profile agrees with {} labels; {} does with {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The learned profile was written to {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The least wall has to be thinner than the greatest.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The least wall; another one is a limit of your own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The limit costs accuracy: {} would take about {} elements.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The limit costs layers: all walls would take about {} elements.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The limit costs layers: {} instead of {}, which would take about {} elements.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The limits of the wall have unsaved changes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The map is lit, so that its shape is seen: colours get darker away from the light. Off: flat colours, exactly those of the colour bar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The map of before beside that of now, once the part was changed and measured again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The map of before is of other parts, or was measured in another way.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The measuring process could not be started.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The measuring process ended unexpectedly; the document is unharmed. Check the part with 'Check geometry' of the Part workbench.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The open panel is about '{}'.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The probabilities of this profile belong to its thresholds before your change: they say how often engineers agreed with verdicts by those. The changed profile is saved without them, and its verdicts are borderline near a threshold instead. 'thinpart learn' makes new ones from labels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The profile has unsaved changes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The report is in {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same part, its mirror image, another size, or one like it; each is said once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The second bound has to be greater than the first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The short name consists of 1 to 40 letters, digits, - and _.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The short name {} is there twice.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The smallest size everywhere would take {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The table was not written to {}: choose a file name that ends with .csv.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The table {} could not be written ({}): choose another place for it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The thickness map cannot be written ({}): free some disk space. Nothing was changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The thickness map is hidden, to show the thin faces. Space shows it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The thinnest wall, the thickest one and pinned ones; those behind the part are hidden</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The threshold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The worker process could not be started.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The worker process ended unexpectedly.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The worker process ended unexpectedly; the report view shows its last output.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {} parts most like {}, among {} of {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {} rows that are shown were written to {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are no classified parts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are no families.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are two categories {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are two criteria {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There has to be a least or a greatest wall.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no document to insert into: open or create one first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no document: open or create one first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no folder {}: choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no folder {}: create it first, or choose another one for the info files.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no info file to keep this in: press 'Save and write info file' above, or classify the document.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thick, {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness labels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thin below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thin faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thin part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ThinPart guide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ThinPart is installed twice: {} is used, {} is not. Remove one of them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ThinPart: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thinnest wall under the face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thinnest wall, and how many places are about as thin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thinnest wall, {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thinnest, {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This link is stored with the part. Open it outside FreeCAD?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Three colours: red is thinner than the limit, yellow up to a tenth above it, blue passes. Violet is thicker than the process allows, by the largest ball inside, as in the check</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thresholds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thresholds (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thresholds to judge by: a shipped profile, or a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time &amp;limit per file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time limit for one file of a folder, or for one document that is classified automatically</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time per file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Title</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To be measured again, because an earlier version did not measure what decides: {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To classify a part, open a document and close the task that is open.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try {}: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two answers to the same part differ in {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unmeasured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsure below a probability of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsure: '{}' ({}) or '{}' ({})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsure: {} or {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use these settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>V/VBB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wall regions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wall thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wall thickness, {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wall thickness: min {}, median {}, max {} (± {})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walls are in the order of their thickness. Key: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walls that are shown as thin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walls that became thinner, the one that lost most first. Click: fly to it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walls thinner than this are coloured as thin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walls thinner than this are coloured as thin; the verdict does not depend on it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walls thinner than this share of the part's diagonal are coloured as thin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walls under {} have fewer layers: they would take most of the elements.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What became thinner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What became thinner…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What faces you is cut off. Choose the current view again after turning the part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it says about a part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What to do with such a part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What would change in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What you change is saved as your own limits in {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When a wall is thinner than</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When libraries have a part already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When the category of a part changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When the thinnest wall of a part falls below this thickness, or is below it in a part that was not classified before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the thresholds are from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which part do you mean?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why it is left out, such as: a crush rib, thin on purpose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why, such as: a crush rib, thin on purpose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With CalculiX as its solver, and steel, which you replace. Supports and loads are yours to add.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without the check mark, a wall stays solid and is not in the shell.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Words in names, paths, notes, links</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes a page about all parts of the libraries, or of the selected one: how many there are of each kind, a map, what is there more than once, and a table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing a report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing a report about libraries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing the info file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing {}…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Written: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your label is kept once the document is saved and its info file is written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your name, under which your labels of parts are kept. Empty: your name on this computer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a file with mesh settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a folder with classified parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a share of the part's diagonal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about {} left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>alike</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all {} libraries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all, or such as: bracket*; *_v2*</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an address or a folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>and a smaller wall, {} of the surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>and {} more parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>and {} smaller walls, {} of the surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>any material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>area with walls thinner than this share of the diagonal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as on this computer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as proposed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>automatic: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>beside each document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>block</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cancelled: finished results are saved, Start continues with the rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>element size {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>error aimed at: {}, elements: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>excluded: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>failed: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fails</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>first, coarse colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from {} on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gamma: three times the inscribed by the circumscribed radius; 1 for regular tetrahedra, under 0.3 poor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>height {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>identical</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in the pre&amp;ferred folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it holds nothing to link to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is the active document itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest ball over {}: too thick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>layers instead</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>layers: {}, elements: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>learned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left solid: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>length {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>limit {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>linear (first order)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>measuring…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>min {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mirror image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>more than {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no library yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no mesh ({})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none stated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none, or such as: FDM, die_casting:zinc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not classified</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not finished</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not in {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing came in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the diagonal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one per processor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only as the verdict needs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only in {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>own limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pausing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>quadratic (second order)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>quality of the elements (gamma)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radius {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>red is thin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rib</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>same limit as the verdict</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>share of the diagonal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>share of the diagonal ({})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>smooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>solid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>standard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stopping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>such as: old/*; *draft*</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>taper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the current view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the learned profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the view cannot be drawn at this size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no importer for such files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>thickest wall {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>thickness: {}, and share of the diagonal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>thin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>thin below {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>thin features</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>thin in places</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>thin on half of the face or more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>those that people keep in its info files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>thread</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to be measured again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to keep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tube</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>under {}: fails</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>up to {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>up to {} above it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>values are missing or of another kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wall {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wedge {:g}–{:g}°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>width {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} (edge)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} (edge, {}×)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} (in searches and tables: {})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} (own)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} (rule {})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} (taper)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} (taper, {}×)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} (unsure)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} ({} parts)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} ({} times)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} ({}×)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} Refresh the libraries to go on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} There are {} more failures.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} and more: {} of the area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} cannot be reached.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} cannot be written ({}): choose another place.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} contains {}, which was removed from the list.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} different parts, {} instances</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} elements, {} poor, worst {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} entries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} fails</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} h {} min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} has no info file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} has several parts, of which none is named {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} info files cannot be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} info files were judged by another version of the profile {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} info files were not changed: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} info files were updated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} info files will be updated; {} parts change their category.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} is in the list already, as a part of {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} is in the list already.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} jobs: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} just above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} labelled parts: {}; by {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} mid-surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} of the area has walls thinner than {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} of the volume in plate-like walls, {} times as wide as thick.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} of {} files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} of {} parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} of {} parts change their category.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} of {} parts fail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} of {}: elements of {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} of {}: {} % ({} to {})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} probes were removed: the surface is no longer at their positions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} shell mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} thick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} times as large</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} to {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} to {} thick ({} to {} of the diagonal): {} of the area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} to {}: {} of the area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} to {}: {} of the area, on 1 face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} to {}: {} of the area, on {} faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} too thick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} triangles of up to {}; walls {} thick, {} of the part's volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} unchanged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} warnings; {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} was imported into {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} was not opened: it is not a CAD file that ThinPart reads.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} was not written by ThinPart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{}, and share of the diagonal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{}, mirrored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{}, {}: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{}. {}, where one of these holds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{}: '{}' ({}) has a wall of {}, below the limit of {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{}: '{}' was '{}' and is '{}' now; its thinnest wall is {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{}: '{}' was '{}' and is '{}' now; its thinnest wall of {} is below the limit of {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{}: '{}' was '{}' and is '{}' now; none of its walls could be measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{}: an earlier version of ThinPart has measured this document, but not all that decides today: classify it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{}: looking for info files, {} so far</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{}: walls {} ({})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{}: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{}: {} of {} info files read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} % like: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>×</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>⚠ The part has changed since it was measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ {}: within the limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✗ The largest ball here is too large: at most {} are allowed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✗ {}: at least {} are needed here</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ThinPartCore</name>
    <message>
        <source>'{object}' has an empty shape: recompute the document or delete it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>'{object}' has no shape, because its last recompute failed ({reason}): repair it and recompute the document.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>'{object}' has no shape, because the last recompute of '{feature}' failed ({reason}): repair it and recompute the document.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>'{object}' is a closed shell but not a solid: convert it to a solid first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>'{object}' is a mesh without triangles: import it again or delete it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>'{object}' is made of surfaces that bound no solid: close or thicken it first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>'{part}' consists of {count} solids, which FEM meshes as one: take it apart first (Part workbench: Compound &gt; Explode compound), then select one solid.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(in no folder of its own)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(the ring is at the thinnest wall)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, not sure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, not watertight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, {count} times in the document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--bands takes a number from 0, for smooth colours, to 64.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--error decides the sizes of elements of second order: leave out --layers and --order 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--keep goes with --check, which shows what works.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--library reads info files only, and takes no {option}: leave it out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--like is for one part: name one file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--range takes the thinner wall first, then the thicker: not {low} and {high}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 document has no info file and is not on this page: 'thinpart classify' measures it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 duplicate triangle was left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 part is not on the map: no wall was found opposite, or its surface is not closed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 triangle of zero area was left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 warning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A budget is at least 1 element, not {value}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A bulky part with thin places: refine the mesh there or remove them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A limit for single faces needs a reason.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A script or a shell is for one part, and there are {count} documents: name one of them, or the part after --part.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ABS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acetal (POM)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Across:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acrylic (PMMA)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alike</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alike: {percent:.0f} % of the surface is the same, the rest up to {apart:.2g} apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alike: {percent:.0f} % of the surface is the same.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All its triangles have zero area.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All parts of this report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All points coincide.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All walls are to stay solid: choose at least one for the shell.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Aluminium</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Aluminium, large casting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Aluminium, small casting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An earlier version has measured {file}: classify it again, to compare it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Area of its surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Area, {unit}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At least, {unit}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At most, {unit}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At the thinnest wall, {thickness} between {face} and {opposite}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bar chart: share of the surface over walls of each thickness, up to {end}; walls under {limit} count as thin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Belongs to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Borderline: close to “{other}” ({margin} from the limit).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bounding box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brass, large casting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brass, small casting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By category</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By the paper's criteria: unknown. {reason}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By the paper's criteria: {category} (criterion {number}: {figures}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By the paper's criteria: {category} (criterion {number}: {figures}; also {others}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By the paper's criteria: {category} (no criterion holds).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By the paper’s thresholds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrated on real parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Category</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear verdict: {margin} from the limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours from {low} to {high} and more; grey where nothing was measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours stand for the diameter of the largest ball inside that touches the surface there, which goes down to nothing at sharp edges. Verdict, tables and the thinnest wall are measured straight across.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours stand for the local thickness, the diameter of the largest ball inside that reaches the surface there. Verdict, tables and the thinnest wall are measured straight across.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connected walls of like thickness, equal ones in one row; the thinnest first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contents</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Could not be measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Counts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cutting the mid-faces of the walls to each other takes too long, as there are too many that nearly touch: mesh it as a solid.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Developed width, {unit}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diagonal of the bounding box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Die casting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ductile iron</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error of a wall at most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every criterion of the profile “{profile}” with what was measured; the category is the first of which one criterion holds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FDM printing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Faces that meet in a thin wedge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Faces: {faces} and {count} more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Faces: {faces}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Families</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Family {number}: {part}, {count} parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fills little of its box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flat and about as long as wide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free-standing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD cannot be imported by {program} ({problem}): install it (Debian: 'apt-get install freecad') or set FREECAD_LIB to the folder with its FreeCAD.so or FreeCAD.pyd.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD cannot open {file} ({problem}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD cannot read it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD cannot read it: open it in the program it came from, and export it again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD cannot read {file} ({problem}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD cannot write them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD could not tessellate any of its faces.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD could not tessellate it ({problem}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD could not tessellate {faces} and {count} more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD could not tessellate {faces}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD did not say which triangle belongs to which face.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD does not follow links from a document whose path is not UTF-8 text or has a backslash: rename {file} or its folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD finds no cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD needs a home folder, but {folder} is not accessible: set FREECAD_USER_HOME to a folder that is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD's mesher left out {left_out}: a copy was measured whose edges were fitted to its faces; check the shape of the part, and export it again if it is damaged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD's mesher left out {left_out}: a copy was measured whose surfaces were converted to splines; its volume agrees with that of the part.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From behind, below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the front, above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the thinnest wall of polypropylene to the thickest of polyethylene: choose the resin for its own limits.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Further faces; all of them are in faces.csv as well</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Giannini et al. 2012</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Giannini, Petton, Pernot: Categorization of CAD models based on thin part identification, TMCE 2012, tables 1 and 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gmsh crashed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gmsh filled no volume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gmsh needed too much memory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gmsh took too long</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gmsh wrote no mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grey iron</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group {number}: {part}, {count} parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Held on two sides</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How it was measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How near it is to another category cannot be told.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Identical</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Info files cannot be written into {folder} ({problem}): give another folder to --info-dir.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Injection moulding</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It came as {faces} loose faces, which were sewn together.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It holds no triangles.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is {length:.4g} higher.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is {length:.4g} longer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is {length:.4g} lower.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is {length:.4g} narrower.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is {length:.4g} shorter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is {length:.4g} wider.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its bounding box is empty or not finite.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its surface encloses no volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Judged by the profile “{profile}”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Labels:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layers are from 0.1 to {most:g}, not {value:g}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Learned on {date} from labels of {count} parts by {people}, starting at the profile {start}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Learning needs the Python package scikit-learn ({problem}): install it (Debian: 'apt-get install python3-sklearn', elsewhere: 'python -m pip install scikit-learn').</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least distance, in diagonals, between walls at a to b degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least distance, in diagonals, between walls at {low:g} to {high:g} degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least width of a face: twice its area by the length of its border</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least, {unit}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of knife's edges, faces that meet at under 30 degrees, in diagonals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the shortest edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length, {unit}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Library of 1 part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Library of {count} parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light alloys in green sand; iron needs more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limits for single faces are lengths over 0, the least one no greater than the other.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limits of the wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Liquid crystal polymer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Local thickness below which 5 % of the area is, in diagonals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Local thickness, by the middle side, that 5 % of the area is below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Local thickness, by the middle side, that 75 % of the area is below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Local thickness, by the middle side, that 99 % of the area is below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Long-fibre reinforced plastics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longest side of the bounding box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longest to middle side of the bounding box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Machining</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Made by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Made of what info files keep; no document was read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Magnesium, large casting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Magnesium, small casting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map of the parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map of {count} parts: across, the median wall as a share of the diagonal of the box; upwards, the share of its box that a part fills</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Margin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Median</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Median of the local thickness, by the middle side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Median thickness of the thinnest ribs, pins, teeth or thread on a solid core, by the middle side; 1 without any</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Median thickness of the thinnest wall region</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Median wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Median, {unit}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mesh settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Meshing needs Gmsh: install it (Debian: 'apt-get install gmsh', elsewhere: https://gmsh.info), and see that 'gmsh --version' runs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Metal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Metals; plastics bend and soften.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Middle side of the bounding box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Middle to shortest side of the bounding box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mirror images of the part to keep.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More than once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Most of the surface is the same, the rest is not: a hole more, another length.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name what to write: --png FILE, --vtp FILE or --ply FILE.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Neither clearly solid nor clearly thin: {walls}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Netgen failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Netgen took too long</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No criterion holds: its walls are thick all over.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No part has all of these words.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No part is labelled {categories}: label at least {needed} parts of every category.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No part like {part} has mesh settings that worked: the usual ones are used.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No report can be written into {folder} ({problem}): give another folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No wall could be measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No wall is wide and thin enough for a shell: mesh it as a solid.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No wall of {part} could be measured: there is nothing to colour.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No wall of {part} is wide and thin enough for a shell: mesh it as a solid.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None of these folders has an info file of a part: 'thinpart classify' writes them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not found any more, though with a limit of its own ({reason}): {faces}: set it anew, or remove it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of edges shorter than 0.3 elements of the automatic mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of faces narrower than 0.3 elements of the automatic mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of wall regions that are bars, shafts, wires or rings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of wall regions that are blocks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of wall regions that are plates, flat, bent or shells</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of wall regions that are tapers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of wall regions that are teeth, of gears or threads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of wall regions that are tubes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of wall regions, connected walls of like thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nylon (PA)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One form, wherever it lies, in whatever file, format or name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One of the given paths is empty: name a file or a folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only the other has round faces of radius {radius:.3g} ({count}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only this one has round faces of radius {radius:.3g} ({count}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only {share:.0f} % of the volume of {part} can be cut off as walls.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PLY with thickness and colours (*.ply)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part with thin features</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parts whose faces are the same but for their sizes, with what varies, in {unit}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture of {part}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pieces that do not meet the rest were left out, {share:.2g} % of the volume: they belong to what is left solid.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plastic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point at a part to see it, click to find it in the table. With the keyboard: arrow keys go from part to part, Enter finds it in the table.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polycarbonate (PC)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polyester (PBT, PET)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polyethylene (PE)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polyphenylene sulphide (PPS)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polypropylene (PP)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polystyrene (PS)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polyurethane (PU)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Previous parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probability: {probability}, next “{other}” with {others}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Process</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reason</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Risk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Risk of the automatic mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Risk of the automatic mesh: unknown, an earlier version measured the part. Measure it again (classify --force).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Risk of the automatic mesh: unknown, not all that it depends on could be measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Risk of the automatic mesh: unknown, triangles have no edges and faces.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Risk of the automatic mesh: {risk}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Risk of the automatic mesh: {risk}: {reasons}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SLA printing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SLS printing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sand casting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scaled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settings that worked for {part} ({alike:.0f} % alike) in {file}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of its box, V/VBB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the area over curved walls that elements of the automatic mesh change by a twentieth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the area over parallel walls from a to b of the middle side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the area over plates and tubes: walls that are wider than thick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the area over walls, parallel or under 60 degrees, from a to b of the middle side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the area whose local thickness is from a to b of the middle side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the area whose rays met nothing at all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the area with a radius below 0.25 elements of the automatic mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the area with no wall opposite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the area with non-parallel walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the area with parallel walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the area with walls that are a to b diagonals thick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the bounding box that the part fills</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the surface over parallel walls thinner than {high:g} of the diagonal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the surface over parallel walls thinner than {high:g} of the middle side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the surface over parallel walls {low:g} to {high:g} of the diagonal thick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the surface over parallel walls {low:g} to {high:g} of the middle side thick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the surface over walls of each thickness ({unit}). {unmeasured} of the surface has no wall opposite; {tapered} lies over tapered walls, which are not in the chart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the surface over walls, parallel or tapered, thinner than {high:g} of the middle side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the surface over walls, parallel or tapered, {low:g} to {high:g} of the middle side thick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the surface whose local thickness is under {high:g} of the middle side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the surface whose local thickness is {low:g} to {high:g} of the middle side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the volume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sheet metal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shell and solid of {part} would count for {share:.0f} % of its volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shortest side of the bounding box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show all {count}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Small castings of aluminium; large ones need about twice as much. The greatest section is that of DeGarmo, Black and Kohser (2003).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Software</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solid but for {features}: mesh it with solids, and refine there or suppress that.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solid but for {features}: mesh it with solids, and refine there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solid core, {share} of the surface is thin: {features}. Refine the mesh there, or suppress them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solid core, {share} of the surface is thin: {features}. Refine the mesh there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solid: {walls}: mesh it with solids.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Some coordinates are not finite numbers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Some triangles refer to points that are not there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped on request before the end.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surfaces touch or cross at ({place}): what lies between them is not counted as a wall.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tables:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes shapes from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Temporary files cannot be written ({problem}): free some disk space, or name another folder in TMPDIR.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Temporary files cannot be written ({problem}): free some disk space. Nothing was meshed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Python module {module} is missing: install it to have documents classified automatically (Debian: python3-{module}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The condition {condition!r} is not understood: write a quantity, one of {comparisons} and a number, as in 'D2/D3 &gt; 6'.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The current folder no longer exists: change to another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The document '{document}' is empty: make or import a solid first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The document has no such part any more: classify it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The document links to {links}, which is a pipe, a device or a socket: it was not opened, and what is linked to is missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The document names Python modules that are not FreeCAD's ({names}): they were not loaded, and objects that need them may lack their shape.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The document's folder has not answered for {seconds:g} s: connect it, or choose a folder for info files in the preferences.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The documents are the same, byte by byte.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The element size of a shell is more than 0 mm, not {value:g}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The error aimed at is from {least:g} to {most:g} %, not {value:g} %.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The error of its mesh is not known ({reason}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The error of its mesh is not known: the frequencies of the reference still change by {change}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file of labels {file} cannot be read ({problem}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file {file}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file {file} cannot be read ({problem}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file {file} no longer exists.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The first part of a group is the one to keep: geometry before triangles, the one used most, with notes, in a document that FreeCAD can edit, with a name that somebody chose, the latest. The others are compared with it, by what info files keep of their form. Nothing is deleted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder for info files {folder} cannot be reached ({problem}): connect it, or choose another one in the preferences.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder for info files {folder} has not answered for {seconds:g} s: connect it, or choose another one in the preferences.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder {folder} cannot be listed ({problem}): its parts are shown as they were last read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder {folder} cannot be listed ({problem}): make it readable, or move it away.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder {folder} cannot be listed ({problem}): the files in it were not changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder {folder} cannot be reached ({problem}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder {folder} could not be searched to its end ({problem}): classify it again when it can be reached.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder {folder} no longer exists: restore it, or remove it from the list.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The greatest element size is more than 0 mm, not {value:g}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The growth from element to element is from {least:g} to {most:g}, not {value:g}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The info file {info_file} belongs to {other} and was not changed: choose another folder for the info file of {own}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The info file {info_file} cannot be read ({problem}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The info file {info_file} could not be written ({problem}): make room or choose another place for it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The info file {info_file} could not be written: another program keeps the folder {folder} locked; end that program, or choose another place for info files.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The info file {info_file} is damaged ({problem}): move it away and classify its document again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The info file {info_file} needs more memory than the limit allows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The info file {info_file} was not written: {problem}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The labels could not be written to {file} ({problem}): choose another place for them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The library {folder} cannot be read ({problem}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The limits of walls {file} are not well formed: {problem}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The limits of walls {file} cannot be read ({problem}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The link '{object}' leads to '{target}' in {file}, which cannot be found: put the file back or set the linked object again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The link '{object}' leads to nothing: set its linked object again or delete it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The list {list} cannot be read ({problem}): give a file to --only that names the parts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The list {list} names {file!r}, which is not an absolute path: write absolute paths, each ended by a NUL byte.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The list {list} names {file}, which does not lie below {top}: name a PATH that holds it, or leave out --info-dir.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mesh cannot be read ({problem}): free some disk space and try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mesh settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mesh {file} cannot be read ({problem}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mid-faces of the walls could not be cut to each other ({problem}): mesh it as a solid.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mid-faces of the walls could not be cut to each other: mesh it as a solid.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mid-surface cannot be read ({problem}): free some disk space and try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mid-surface of {part} could not be meshed ({problem}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mid-surface of {part} could not be meshed ({problem}): name another element size.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mid-surface of {part} falls into {count} pieces that do not meet: mesh it as a solid.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mirror image, by the points that info files keep, by volume and by area.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mirror image: its surfaces are at most {apart:.2g} apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mirror image: triangles lie at most {apart:.2g} from the other surface.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The name is too long for an info file, which adds {ending} to it: it has {bytes} bytes, at most {most} are possible; rename it, or use --no-info.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The order of elements is 1 or 2, not {value}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The outline in an info file is damaged: classify its document again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The overview of the report could not be written into {folder} ({problem}): make room for it, and start again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The page about the library could not be written into {folder} ({problem}): make room for it, and start again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The page {page} could not be written ({problem}): make room, or give another folder for the report.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The part as a whole is thin: consider a shell mesh or a mid-surface.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The part is slender: its lengths are accurate to {error:.2g} only, a finer mesh would be too large.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The part is too slender or too fine to be measured: it needs more than {triangles:,} triangles, with fewer its lengths are accurate to {mm:.2g} only.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The part is {mm} across: check that the file's unit is millimetres.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The parts lie on several drives: name those of one drive at a time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The profile {file} could not be written ({problem}): choose another place for it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The profile {profile} cannot be read ({problem}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The profile {profile} has no category {categories}: labels by a program are of these.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same form in another size.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same form, by the points that info files keep, by volume and by area.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same form, scaled: triangles lie at most {apart:.2g} from the other surface.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same form, {scale:.6g} times as large, by the points that info files keep, by volume and by area.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same form, {scale:.6g} times as large: in the size of the other, its surfaces are at most {apart:.2g} apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same form: its surfaces are at most {apart:.2g} apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same form: triangles lie at most {apart:.2g} from the other surface.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The script opens {copy}, a copy of the part beside it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The search has {count} conditions, words and names, more than {most}: leave some out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The search index {file} cannot be saved ({problem}): it was built in memory, and the next search has to build it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The settings were kept with {part}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shell and what is solid, tied to it, were written to {file}: {elements} elements, {nodes} nodes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shell has {share:.0f} % of the part's volume: the rest is not in the file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shell is in {count} pieces: what is left solid lies between them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shell of {part} reaches only {share:.0f} % of the cuts between its walls and what is solid.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shell was written to {file}: {elements} elements, {nodes} nodes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The size of elements and the error have to be more than 0: state other ones.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sizes were written to {file}: open it in Gmsh.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The surface intersects itself, for example below ({place}): repair it, its thickness and volume are not certain.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The surface is open ({edges} free edges), so it has no certain volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The surface was inside out and has been reversed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The table and the search need JavaScript.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The thickness map {file} cannot be read: measure the part again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The thickness map {file} is of a newer ThinPart: update ThinPart or measure the part again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The thinnest first; thin is what lies over less than {limit}, {part} of the width, as the verdict has it, beside edges of up to 60 degrees too, which are no walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The thinnest wall is {wall} ± {error:.2g}: a finer mesh would be too large.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The thinnest wall, {wall}, is below what the mesh resolves ({error:.2g}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The triangles are not consistently oriented, so it has no certain volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The walls of {part} do not meet: {inside} of the {free} of free edges of its mid-surface lie inside the material. Mesh it as a solid.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The worker process failed ({problem}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The worker processes end as soon as they start: try a larger --memory, or fewer --jobs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {what} cannot be {value:g}: use a value from {least:g} to {most:g} {unit}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are no info files (*{ending}) in {paths}: classify the parts first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are no labels in {folder}: label parts in the window, or by 'thinpart note --label', or name CSV files of labels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are no limits of walls for {process!r}: there are {known}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are no parts in {paths}: name a CAD file or a folder that holds some.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are too few labels: {counts}. At least {needed} parts of every category are needed: even if the verdicts on so few were all right, only {percent:.0f} % right could be claimed with confidence.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no accuracy {accuracy!r}: use {known}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no box {box!r}: use minimal or principal.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no closed solid in '{object}': select a solid, a body, or a face of one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no closed solid in the document '{document}': make or import a solid first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no file of labels {file}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no file {file} with limits of walls: copy {shipped} and edit it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no file {file}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no file {file}: --mesh takes a JSON object or a file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no folder {folder}: name the one with the info files.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no info file {info_file}: classify {file} first, or name the folder of its info file with --info-dir.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no measure {measure!r}: use rays or pairs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no part that could be written to {file}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no part {part} in {file}: it has {parts}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no permission to read {file}: check its permissions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no permission to search the folder {folder}: check its permissions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no profile {profile!r}: give a file or one of {known}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no quantity {quantity!r} in the condition {condition!r}: there are {known}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no quantity {quantity!r}: there are {known}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory for this.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These are not among the parts above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These are not in the table above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness and box: {unit}. The fill is the share of its box that a part fills, V/VBB.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness and box: {unit}. The margin is how far the deciding quantities lie from another category, relative to their thresholds.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thin part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thin plates nearly everywhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thin ribs, pins, teeth or a thread on a solid body</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thin share</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thin walls in places</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thin walls over most of its surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thin walls, tapered ones too, over a good part of its surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thinner wall beside a thick body</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thinnest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thinnest parallel wall {thinnest}: classify the part again for its tapered walls.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thinnest towards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thinnest wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thinnest wall {thinnest}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thinnest wall {thinnest}, in a taper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thinnest wall {thinnest}, in a taper; {count} places below {below:.2g}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thinnest wall {thinnest}; {count} places below {below:.2g}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thinnest {thinnest}, {depth:.2g} beside a sharp edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thinnest {thinnest}, {depth:.2g} beside a sharp edge; {count} places below {below:.2g}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thinnest, {unit}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This FreeCAD has no FEM workbench: install it (Debian: 'apt-get install freecad', elsewhere the installer of freecad.org, which has it), then start FreeCAD again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This may be an older shape of '{object}', because its last recompute failed ({reason}): repair it and recompute the document.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This may be an older shape of '{object}', because the last recompute of '{feature}', which it is made with, failed ({reason}): repair it and recompute the document.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This needs CalculiX: install it (Debian: 'apt-get install calculix-ccx', elsewhere: https://www.calculix.de), and see that 'ccx -v' runs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thresholds chosen on 496 real CAD parts of 43 public repositories that engineers labelled by eye, and tried on repositories left out; quantities after Giannini, Petton, Pernot, TMCE 2012, in units of the middle side of the box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Twice the volume by the area and the median local thickness: 1 of a plate, 1/2 of a wire or square bar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two lines of a nozzle of 0.4 mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unmeasured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsure: “{category}” ({probability}) or “{other}” ({others}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>VTK PolyData with thickness (*.vtp)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Very thin wall on a filled part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Volume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Volume of the part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wall thickness of 1 part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wall thickness of {count} parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walls held on two sides; free-standing ones need more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walls {low} to {high} thick, {share} of the surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is solid could not be cut from the walls ({problem}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is solid of {part} could not be meshed ({problem}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is solid of {part} is not in the file. {problem}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What shows it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where it is thin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether its walls lie within what processes allow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why it is in this category</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With a limit of its own ({reason}), but without a wall that could be measured: {faces}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Within a limit of its own ({reason}): {faces}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your libraries have it in another size: this is {scale:.6g} times {file}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your libraries have its mirror image: {file}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your libraries have one like it: {file}. {evidence}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your libraries have this part: {file}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your own limits {file} cannot be written ({problem}): make room, or name another file in THINPART_LIMITS.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zinc, large casting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zinc, small casting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a bar of {thickness} ({share} of the width)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a block of its elements is empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a larger error, a fifth of the elements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number in it is too long</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a part of {file} is neither measured nor refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a rib of {thickness} ({share} of the width)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a stud of {thickness} ({share} of the width)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a taper {least} to {thickness} thick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a twentieth of the surface is thinner than {limit}, 1/{part:.1f} of an element</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a wall of {thickness} ({share} of the width)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>along the principal axes; diagonal {diagonal}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an edge of {shortest}, 1/{part:.0f} of an element</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an entry has no header</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an entry has two names</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an entry is called '{entry}'</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an entry is cut off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an info file is damaged, foreign or of a newer version</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an unexpected error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an unexpected error in ThinPart: try again, and report it with the file if it happens again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>and {count} more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>and {count} smaller walls, {share} of the surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>angular deflection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another program keeps the folder locked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as it was open in FreeCAD, not saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as proposed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>below {share}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>beside a sharp edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>beside edges, {share} of the surface is thinner than {limit}, {part} of the width of {middle}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>block</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>borderline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>box as flat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>box as long</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>by Netgen, since Gmsh does not mesh it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>byte {place} is not text in Unicode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>can be edited in FreeCAD</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>colours stand for the largest ball inside that touches the surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>colours stand for the local thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>colours stand for the thickness of the wall below the surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coordinates are not numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>curved walls that elements change by over {part} of their thickness on {share} of the surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>different proportions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>different wall distribution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>edges of it join more than two faces ({count}), as where bodies touch along them: fuse these with some overlap, or separate them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>element size {size}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>excluded: {reason}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>faces that lie on each other taken out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>family {number}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>far fewer tapered walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>far more tapered walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fewer layers in the thinnest walls, a twentieth of the thin area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fewer layers, a fifth of the elements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fewer tapered walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fill not comparable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fill, V/VBB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>finer at curves, short edges and narrow faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>finer where Gmsh failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>finer where Gmsh failed, surfaces by Delaunay's method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>flatter box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>for the verdict</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>format is not {format!r}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>geometry, not triangles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>group {number}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has a name of its own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in a taper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it cannot be unpacked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it fills {share} of its box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has no such motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has no triangles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has {count} cells, and the header has {columns}: put quotes around what holds a comma</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is damaged or incomplete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is larger than {megabytes} MB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is nested too deeply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is not JSON: line {line} column {column}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is not UTF-8 text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is not a CSV table ({problem})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is not a regular file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is not in the binary MSH format 2.2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is not text in UTF-8: save the table as CSV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it names no file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it stores a file as '{path}'</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it stores a resource as '{path}'</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its box is flat, {long} by {middle} by {short}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its mesh is incomplete: is the disk full?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its parts are not those of {file}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its probabilities are not of its categories, in their order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its reference mesh is too large</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its reference mesh took too long</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its second answer is the first one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its walls make no shell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its {entry} declares its own entities</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its {entry} is not in UTF-8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its {entry} would be larger than {gigabytes} GB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>keep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>layers in its thin walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>less filled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>less flat box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>less than {share} of the surface lies over walls thinner than {limit}, {part} of the width of {middle}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>linear deflection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>linear deflection {linear}, angular deflection {angular} degrees, at walls {wall}, at least {samples} samples, accuracy {accuracy}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>longer box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>longest side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>look in FreeCAD what 'Check geometry' says about it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>median wall / diagonal of the box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>middle side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>more filled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>more tapered walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>much flatter box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>much less filled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>much less flat box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>much longer box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>much more filled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>much shorter box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no element larger than the part is thick there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no permission to read the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no reason given</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no wall is thinner than {limit}, {part} of the width of {middle}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no wall is thinner than {thinnest}, {part} of the width of {middle}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of least volume; diagonal {diagonal}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the diagonal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one reference mesh is not enough, and a second one too large</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one size, since nothing finer is meshed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only tapered walls are thinner than {limit}, {part} of the width of {middle}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only {share} of the surface lies over walls thinner than {limit}, {part} of the width of {middle}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parts of its surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>processes[{number}]{place} has a min_mm of {least:g}, not below its max_mm of {most:g}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>processes[{number}]{place} has neither min_mm nor max_mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>proportions not comparable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radius {number}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rib</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>same fill</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>same proportions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>same wall distribution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>short edges and narrow faces not finer than the walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shorter box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shortest side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>similar proportions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>similar wall distribution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>standard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stopped on request</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>surfaces by Delaunay's method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>taper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the cluster cannot be used</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the column {columns} is missing; there have to be {required}, and there may be {optional}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the column {columns} is there twice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file is damaged or not what its name says</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file is unsafe to open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file or document is empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the first of equals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the first wall along the inward normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the format is not supported here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the info file could not be written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the latest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the memory limit was reached</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the mesh was not written ({problem})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the paper's pair rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the part encloses no volume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the profile is not usable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the solver crashed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the solver needed too much memory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the solver took too long</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the time limit was reached</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the worker process crashed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no closed solid in it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no info file of {file!r} in {library}: classify it first, write its path as it is below that folder, or take the row out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>thickness, {unit}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>thin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>thin below {limit}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>thin features</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>thinnest wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>thinnest wall, {unit}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>thread</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>thread {least} to {thickness} thick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>thread {least} to {thickness} thick, with a run-out to a sharp edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tube</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two entries are called '{entry}'</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>used {count} times</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>varies: {names}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>version is {version}, and this reads version 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>volumes by Gmsh's usual method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>volumes by the HXT method, which is quicker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>walls at {low:g} to {high:g} degrees as near as {nearest}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>walls thinner than {limit} over {share} of the surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>words of names and folders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wrong usage of the command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{about} needs more memory than the limit allows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{about}: {sentence}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{answer!r} in the column sure is neither yes nor no</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{bytes} bytes after its last entry belong to no entry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{bytes} bytes that belong to no entry lie before '{entry}'</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{bytes} bytes, changed {time} UTC</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{category!r} is no category: there are {known}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{category!r} is no category: there are {known}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{category} (unsure)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{category}, thinnest wall {thinnest}, median {median}, fill {fill}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{check} {faces}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{command} compares the documents themselves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{condition} never holds, because it is never above {limit:g}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{condition} never holds, because it is never below {limit:g}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{constant} is not a JSON number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count:.0f} edges shorter than {limit}, the shortest {shortest}, 1/{part:.0f} of an element</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} bars of {thickness} ({share} of the width)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} criteria</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} documents have no info file and are not on this page: 'thinpart classify' measures them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} documents of the library are called {file!r}: write the path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} duplicate triangles were left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} more faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} more folders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} of them are unsure: close to another category.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} parts are not on the map: no wall was found opposite, or their surface is not closed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} parts were measured by an earlier version and are not compared: 'thinpart classify' measures their documents again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} ribs of {thickness} ({share} of the width)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} studs of {thickness} ({share} of the width)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} tapers {least} to {thickness} thick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} teeth {least} to {thickness} thick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} triangles of zero area were left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} walls of {thickness} ({share} of the width)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} walls {least} to {thickness} thick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} warnings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{faces} and {count} more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{face} fails its own limit: {ball}, at most {most} ({reason}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{face} fails its own limit: {wall}, at least {least} ({reason}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} cannot be read ({problem}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} cannot be read or written ({problem}): check its name, its permissions and the room on its disk.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} cannot be written ({problem}): name another place.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} changed while it was read: measure it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} could not be read in time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} crashed the process that read it: the file is probably damaged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} failed ({problem}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} failed: its result cannot be stored ({problem}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} failed: its result cannot be used ({problem}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} has changed since it was classified, or is gone: classify it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} has coordinates that are not finite numbers: export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} has faces with more than four corners, which FreeCAD leaves out: triangulate it first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} has no ending that ThinPart reads ({endings}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} has no part {part!r}: it has {parts}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} has no part {part!r}: it has {parts}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} has no part {part} any more: classify it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} has the name of a CAD file and was not changed: name another file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} has {count} parts, and one is written: name it after --part, as {example}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} has {count} parts: name one after --part, of {parts}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} holds no closed solid, only surfaces, wires or points: close or thicken it first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} holds no labels: write a row per part below the header.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} holds {count} parts: choose one with --part, by name or label: {parts}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} holds {count} parts: name one in the column part: {parts}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} is a CAD file that ThinPart did not write, and was not changed: name another file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} is a link that leads back to itself: remove it or link it to a part.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} is a link that leads nowhere: remove it or link it to a part.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} is a link to a file that is missing, and was not changed: name the file itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} is a link to {target}, which is not an output of ThinPart and was not changed: name another file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} is a program: it was not opened.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} is an empty document.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} is an info file and was not changed: name another file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} is an input of this run and was not changed: name another file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} is damaged or holds no shape.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} is damaged or not a FreeCAD document ({problem}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} is damaged or not what its ending says ({problem}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} is damaged, or its faces are not triangles: triangulate it first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} is empty (0 bytes).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} is for one part, and there are {count}: name one after --part, as {example}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} is named for two outputs: name another file for one of them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} is no file: name a CAD file with one part.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} is no name for a file of {option}: give it the ending .{ending}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} is no name for a map: give it one of the endings {endings}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} is no name for a script of Gmsh: give it the ending .geo.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} is no name for a shell: give it one of the endings {endings}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} is no profile and is not overwritten: write the new profile elsewhere.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} is not a FreeCAD document.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} is truncated or not an STL file: its header says {announced} triangles, it holds {held}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} is truncated: its end is missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} needs more memory than {megabytes} MB.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} took longer than {seconds:g} s, the limit for one file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} was not opened: it links to {links}, which is a pipe, a device or a socket, and FreeCAD would wait there for ever. Get it from a source that you trust.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} was not opened: {problem}, so it would write outside its own folder or hide some of its content. Get it from a source that you trust.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} was not written by ThinPart and was not changed: name another file, or allow it to be overwritten (--overwrite).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} was not written. {reason}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} was saved again meanwhile: classify it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} was written by another program meanwhile and was not changed: name another file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file} would have the name of a profile that comes with ThinPart: choose another.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file}, line {line}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{file}, part {part}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{first} and {second} exclude each other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{first} to {last} of {count} parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{first} {next}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{first}; {next}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{folder} already exists and is not the folder of a report: it was not changed; give a new or an empty folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{folder} does not lie below {top}: name a folder after --info-tree that holds all PATHs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{info_file} has version {version}; this ThinPart reads version {known}: use a newer one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{info_file} is not a ThinPart info file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{info_file} is too large for an info file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{inside} of the {free} of free edges lie inside the material: there, walls do not meet, or go over into what is left solid. Close these gaps before solving.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{length} ± {error:.2g}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{link} was not opened: a link may lead to http:// or https://, or to a file of the library.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{low} to {high}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{low} to {high}: {share}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{number!r} in the condition {condition!r} is not a number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{one} and {two}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{one}, {two} and {three}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{one}, {two}, {three} and {count} more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{part} - wall thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{part} belongs to another document, {file}: open that one, and prepare its mesh there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{part} has no shell, since it is not closed or was measured by pairs: close its gaps (Part workbench, Check geometry), or measure it by rays.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{part} has no shell: its walls overlap, and would count for {share:.0f} % of its volume. Mesh it as a solid.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{part} has no shell: walls with a mid-surface have only {share:.0f} % of its volume. Mesh it as a solid.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{part} has no {face}: names of faces are those of FreeCAD, such as Face1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{part} is made of triangles, which are no solid to mesh.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{part} is made of triangles, which have no mid-surface: use its STEP file, or mesh it as a solid.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{part} needs more than {megabytes} MB of memory: raise the limit in the preferences.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{part}: {sentence}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{person!r} cannot be kept as a person's name: choose a shorter one, in one line.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{person} calls it {category!r}, which is no category of the start: there are {known}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{person} calls this part {category} here and {other} before ({earlier})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{person} has labelled this part already ({earlier})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{person} is sure of {category} in one place and not in the other ({earlier})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{place} is empty, and a criterion without conditions would always hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{place} names {quantity!r}, which is no quantity: there are {known}, a below b</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{place}: {reason}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{problem} As a file it may have a shell all the same, without faces for supports: ./thinpart size FILE --shell shell.inp.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{process} ({material})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{process}: all walls have limits of their own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{process}: cannot be told: no wall could be measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{process}: cannot be told: the surface is open, and there may be walls thinner than the {thinnest} that were found.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{process}: cannot be told: the thinnest wall is {thinnest}, give or take {error:.2g}, the limit is {least}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{process}: cannot be told: {share} of the surface lies over more than {most}, but a ray may run along a wall there: look at the thickness map.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{process}: fails, but only where walls end in sharp edges: {findings}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{process}: fails: {faces} All other faces pass.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{process}: fails: {faces} Of all other faces it cannot be told.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{process}: fails: {findings}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{process}: passes within tolerance: the thinnest wall is {thinnest}, give or take {error:.2g}, the limit is {least}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{process}: passes: no wall is over {most}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{process}: passes: the thinnest wall is {thinnest}, the limit {least}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{process}: passes: the thinnest wall is {thinnest}, the limit {least}; towards their edges, tapered walls are thinner on {share} of the surface.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{process}: passes: walls from {thinnest} on, the limits are {least} and {most}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{profile} cannot be used: {problem} ({place}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{profile} defines 'normal' or 'unknown', which are reserved: rename the category.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{profile} has version {version}; ThinPart reads version 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{profile} has {count} conditions, more than {most}: leave some out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{profile} is not a ThinPart profile.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{profile} is not well formed: {problem}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{profile} uses a criterion's id twice: {id!r}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{quantities} could not be measured, so criterion {criteria} cannot be decided.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{quantity} = {value:.3g}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{said} So thin a place, {share} of the median of {median}, is often an error of the model: look at it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{said} The thinnest wall that does not end in one is {walls}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{sentence} It was not changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{sentence} It was not changed: move it away to have a new one written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{share} and more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{share} of the surface is thin: {features}. Refine the mesh there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{share} of the surface lies over walls of more than {most}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{share} of the surface lies over walls thinner than {limit}, {part} of the width of {middle}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{share} of the surface lies over walls thinner than {limit}, {part} of the width of {middle}: consider shells (Prepare mesh says whether they can be made).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{share} of the surface lies over walls thinner than {limit}, {part} of the width of {middle}: refine the mesh there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{share} of the surface over walls of {least} to {most}, beside a thick body</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{share} of the surface over walls thinner than {most}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{thickness} and more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{thickness} plate, {share} of the surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{thickness} sheet, {share} of the surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{thickness} wall, {share} of the surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{thinnest}, give or take {error:.2g},</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{thin} of the surface is under {least}, thinnest {place}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{thin} of the surface is under {least}, thinnest {place}, and {thick} over {most}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{title} (rule {number})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{triangles} triangles, chord error {error}, {samples} samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{walls}: consider shells (Prepare mesh says whether they can be made).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{wall} on {face}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{wall}, {depth:.2g} beside a sharp edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{wall}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{wall}; sharp edges are {edges} long.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{what} cannot be stored ({problem}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{what} is not a JSON object ({problem}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{what} is not a JSON object.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{whose} holds 1 face beside its solids, which was left out: close or thicken it if it is a part.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{whose} holds 1 solid that is only a line, which was left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{whose} holds {count} solids that are only a line, which were left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{whose} holds {faces} faces beside its solids, which were left out: close or thicken them if they are a part.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{x:.3g}, {y:.3g}, {z:.3g}</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ThinPart_Classify</name>
    <message>
        <source>Checks whether the selected part is thin, has thin features or is normal, and colours its thin faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Classify part</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ThinPart_ClassifyFolder</name>
    <message>
        <source>Classifies all parts of a folder in the background and shows them in a table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Classify folder…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ThinPart_ClearColours</name>
    <message>
        <source>Clear thin colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restores the colours that the faces of this document had before they were coloured as thin</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ThinPart_EditProfile</name>
    <message>
        <source>Edit profile…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edits the thresholds by which parts are judged, and the limits of the wall, and counts meanwhile what would change in your libraries</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ThinPart_FindParts</name>
    <message>
        <source>Find parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows or hides the panel that finds classified parts by their category, walls, size and notes, and parts like another one</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ThinPart_Guide</name>
    <message>
        <source>Opens the guide: a page for each job, with pictures and examples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ThinPart guide</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ThinPart_LearnThresholds</name>
    <message>
        <source>Chooses thresholds that agree with what people say of the parts of a library, and says how good they are on folders left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Learn thresholds…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ThinPart_MeshSizes</name>
    <message>
        <source>Prepare mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Proposes element sizes that give the thin walls of the selected part enough layers, and makes a FEM mesh with them</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ThinPart_Preferences</name>
    <message>
        <source>Opens the preferences: thresholds, surface mesh, info files, colours and automatic classification</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ThinPart preferences…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ThinPart_Report</name>
    <message>
        <source>Report…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes a page with pictures, walls and criteria about every part of the document, to read, print or hand on</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ThinPart_ShowThickness</name>
    <message>
        <source>Colours the selected parts, or all of them, by the thickness of their walls, and shows how the area is distributed over thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show thickness</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
